//! Surfaces through nodes with given tangents.

use crate::axis::GridAxis;
use crate::checks::first_finite_points;
use crate::{Nodes, Patch, Patches, Scheme, Sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The mixed derivatives S_uv at nodes, which tangents do not determine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Twists<'a> {
    /// The mean of two differences: of S_u along rows, and of S_v along columns, each from five
    /// nodes. Fourth order.
    #[default]
    Differences,
    /// Adini's twists: the twists of the bilinearly blended Coons patch through the tangents around
    /// the node. Second order; they depend on the adjacent nodes only.
    Adini,
    /// Zero twists (Ferguson): the surface has flat spots at nodes, and third order.
    Zero,
    /// One twist for each node, row by row.
    Given(&'a [DVec3]),
}

/// Nodes and the tangents of the coordinate curves at them. Nodes have integer parameters, so S_u
/// is the derivative for one row.
#[derive(Debug, Clone, Copy)]
pub struct Tangents<'a> {
    /// The nodes.
    pub nodes: &'a Nodes<'a>,
    /// S_u at each node, row by row: along the column, towards the next row.
    pub u: &'a [DVec3],
    /// S_v at each node: along the row, towards the next column.
    pub v: &'a [DVec3],
    /// S_uv at each node.
    pub twists: Twists<'a>,
    /// Whether the surface is closed in u and in v. The last line of nodes in a closed direction
    /// repeats the first one, and its tangents are not read.
    pub closed: [bool; 2],
}

impl Sheet<'static> {
    /// Creates the bicubic Hermite surface through nodes with tangents. It is C1, and of fourth
    /// order if the tangents are at least of third order.
    ///
    /// O(nodes); 384 bytes for each cell.
    ///
    /// # Errors
    /// [`NotFinite`](gusset_base::Error::NotFinite) with the node, also for its tangents and twist;
    /// [`ArrayTooShort`](gusset_base::Error::ArrayTooShort);
    /// [`NetTooSmall`](gusset_base::Error::NetTooSmall) if a closed direction has fewer than three
    /// nodes and the repeated one; [`SidesApart`](gusset_base::Error::SidesApart);
    /// [`OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn from_tangents(given: &Tangents<'_>, job: &Job<'_>) -> Result<Self> {
        let hermite = CheckedHermiteData::new(given)?;
        let [rows, columns] = [hermite.rows - 1, hermite.columns - 1];
        let twists = hermite.node_twists()?;
        let mut patches = alloc::with_capacity(rows * columns)?;
        for i in 0..rows {
            job.step(i as f64 / rows as f64, "making patches")?;
            patches.extend((0..columns).map(|j| hermite.cell_patch(&twists, i, j)));
        }
        Ok(Sheet::Cubic(Patches::from_patches(patches, rows, columns)))
    }
}

/// Nodes and tangents that were checked.
struct CheckedHermiteData<'a> {
    given: &'a Tangents<'a>,
    rows: usize,
    columns: usize,
    axes: [GridAxis; 2],
}

impl<'a> CheckedHermiteData<'a> {
    fn new(given: &'a Tangents<'a>) -> Result<Self> {
        let (nodes, closed) = (given.nodes, given.closed);
        let (rows, columns) = (nodes.rows(), nodes.columns());
        let axes = GridAxis::new_pair([rows, columns], closed, Scheme::SixTap)?;
        nodes.check_finite()?;
        let arrays = [("tangents", given.u), ("tangents", given.v)];
        let twists = if let Twists::Given(twists) = given.twists { Some(("twists", twists)) } else { None };
        for (what, vectors) in arrays.into_iter().chain(twists) {
            first_finite_points(vectors, (rows * columns) as u64, what)?;
        }
        nodes.check_closed_directions(closed)?;
        Ok(CheckedHermiteData { given, rows, columns, axes })
    }

    /// The index of the node (i, j). In a closed direction, the last line maps to the first one.
    fn node_index(&self, i: usize, j: usize) -> usize {
        let [closed_u, closed_v] = self.given.closed;
        let i = if closed_u && i == self.rows - 1 { 0 } else { i };
        let j = if closed_v && j == self.columns - 1 { 0 } else { j };
        i * self.columns + j
    }

    /// S_uv at each node.
    fn node_twists(&self) -> Result<Vec<DVec3>> {
        let places = (0..self.rows * self.columns).map(|k| (k / self.columns, k % self.columns));
        alloc::collect(places.map(|(i, j)| match self.given.twists {
            Twists::Zero => DVec3::ZERO,
            Twists::Given(twists) => twists[self.node_index(i, j)],
            Twists::Differences => {
                let ((rows, of_rows), (columns, of_columns)) =
                    (self.axes[0].slope_nodes_and_weights(i), self.axes[1].slope_nodes_and_weights(j));
                let across = |k: usize| of_rows[k] * self.given.v[self.node_index(rows[k], j)];
                let along = |k: usize| of_columns[k] * self.given.u[self.node_index(i, columns[k])];
                0.5 * (0..rows.len()).map(|k| across(k) + along(k)).sum::<DVec3>()
            }
            Twists::Adini => self.adini_twist(i, j),
        }))
    }

    /// Adini's twist, from differences over the adjacent lines: of S_u along the row, plus of S_v
    /// along the column, minus the mixed difference of the nodes.
    fn adini_twist(&self, i: usize, j: usize) -> DVec3 {
        let (rows, columns) =
            (self.neighbour_lines_and_interval_count(0, i), self.neighbour_lines_and_interval_count(1, j));
        let [height, width] = [rows, columns].map(|[_, _, span]| span as f64);
        let (given, node) = (self.given, |i: usize, j: usize| self.node_index(i, j));
        let along = (given.u[node(i, columns[1])] - given.u[node(i, columns[0])]) / width;
        let across = (given.v[node(rows[1], j)] - given.v[node(rows[0], j)]) / height;
        let corner = |a: usize, b: usize| given.nodes.get(rows[a], columns[b]);
        let mixed = (corner(1, 1) - corner(0, 1)) - (corner(1, 0) - corner(0, 0));
        along + across - mixed / (height * width)
    }

    /// The lines before and after a line, and the number of intervals between them.
    fn neighbour_lines_and_interval_count(&self, direction: usize, line: usize) -> [usize; 3] {
        let last = self.axes[direction].interval_count();
        if self.given.closed[direction] {
            return [(line + last - 1) % last, (line + 1) % last, 2];
        }
        let (before, after) = (line.saturating_sub(1), (line + 1).min(last));
        [before, after, after - before]
    }

    fn cell_patch(&self, twists: &[DVec3], i: usize, j: usize) -> Patch<4> {
        let mut points = [[DVec3::ZERO; 4]; 4];
        for (di, dj) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let (point, node) = (self.given.nodes.get(i + di, j + dj), self.node_index(i + di, j + dj));
            // A third of the derivative, directed into the cell.
            let inwards = |end: usize| if end == 0 { 1.0 / 3.0 } else { -1.0 / 3.0 };
            let (u, v) = (inwards(di) * self.given.u[node], inwards(dj) * self.given.v[node]);
            let twist = inwards(di) * inwards(dj) * twists[node];
            let at = |end: usize, step: usize| if end == 0 { step } else { 3 - step };
            points[at(di, 0)][at(dj, 0)] = point;
            points[at(di, 1)][at(dj, 0)] = point + u;
            points[at(di, 0)][at(dj, 1)] = point + v;
            points[at(di, 1)][at(dj, 1)] = point + u + v + twist;
        }
        Patch { points }
    }
}
