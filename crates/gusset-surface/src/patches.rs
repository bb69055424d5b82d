//! Sheets of given Bézier patches.

use super::Patch;
use super::cells::{BLOCK, Cells, cells_of_block};
use super::checks::finite_points;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::elevate;
use std::ops::Range;
use std::sync::Arc;

/// The greatest degree of a patch.
pub const MAX_DEGREE: usize = 7;

/// `rows x columns` Bézier patches of degree N - 1, row after row; neighbours share their sides, or
/// nearly.
#[derive(Debug, Clone)]
pub struct Patches<const N: usize> {
    /// Not a slice: that would be a copy of what may be gigabytes.
    patches: Arc<Vec<Patch<N>>>,
    rows: usize,
    columns: usize,
    closed: [bool; 2],
    origin: Option<Arc<Origin>>,
}

/// The spline that patches were made of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Origin {
    /// A bound of the distance from it at equal parameters, but for rounding if it is 0.
    pub(crate) deviation: f64,
    /// The parameters of the borders of cells, in u and in v.
    pub(crate) knots: [Vec<f64>; 2],
}

impl<const N: usize> Patches<N> {
    /// From control nets, one after the other: each `(degree_u + 1) * (degree_v + 1)` points, u by
    /// u; lower degrees are raised to N - 1, which changes nothing but for rounding.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a degree of 0 or above N - 1, [`Error::EmptyMesh`] without
    /// patches, [`Error::ArrayTooShort`], [`Error::TooLarge`], [`Error::NotFinite`] with the
    /// control point, [`Error::OutOfMemory`].
    pub fn new(points: &[DVec3], degrees: [usize; 2], rows: usize, columns: usize) -> Result<Self> {
        degrees.iter().try_for_each(|&degree| Error::require((1..N).contains(&degree), "degree", degree as f64))?;
        let each = (degrees[0] + 1) * (degrees[1] + 1);
        let count = (rows as u64).saturating_mul(columns as u64);
        let total = count.saturating_mul(each as u64);
        if count == 0 {
            return Err(Error::EmptyMesh { what: "patches" });
        }
        Error::check_count("control points", total, super::MAX_NODES)?;
        let points = finite_points(points, total, "control points")?;
        let patches = alloc::collect(points.chunks_exact(each).map(|net| Patch::raised(net, degrees)))?;
        Ok(Self::of(patches, rows, columns))
    }

    /// `rows * columns` patches, at least one.
    pub(crate) fn of(patches: Vec<Patch<N>>, rows: usize, columns: usize) -> Self {
        let mut made = Patches { patches: Arc::new(patches), rows, columns, closed: [false, false], origin: None };
        let closed_u = |j: usize| made.get(0, j).points[0] == made.get(rows - 1, j).points[N - 1];
        let closed_v = |i: usize| {
            let (first, last) = (made.get(i, 0), made.get(i, columns - 1));
            first.points.iter().zip(&last.points).all(|(first, last)| first[0] == last[N - 1])
        };
        made.closed = [rows > 2 && (0..columns).all(closed_u), columns > 2 && (0..rows).all(closed_v)];
        made
    }

    /// The same patches, with what they were made of.
    pub(crate) fn with(self, origin: Origin) -> Self {
        Patches { origin: Some(Arc::new(origin)), ..self }
    }

    /// What they were made of, if that was a spline.
    pub(crate) fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// The numbers of cells in u and in v.
    pub fn cells(&self) -> [usize; 2] {
        [self.rows, self.columns]
    }

    /// Whether it is closed in u and in v: three cells at least, and the control points of the last
    /// side are those of the first one.
    pub fn is_closed(&self) -> [bool; 2] {
        self.closed
    }

    /// The patch over the cell at (i, j).
    pub fn get(&self, i: usize, j: usize) -> &Patch<N> {
        &self.patches[i * self.columns + j]
    }
}

impl<const N: usize> Patch<N> {
    /// A control net of lower degrees as one of degree N - 1.
    pub(crate) fn raised(net: &[DVec3], [p, q]: [usize; 2]) -> Patch<N> {
        let mut points = [[DVec3::ZERO; N]; N];
        for (row, given) in points.iter_mut().zip(net.chunks_exact(q + 1)) {
            row[..=q].copy_from_slice(given);
            elevate(row, q);
        }
        elevate(&mut points, p);
        Patch { points }
    }
}

impl<const N: usize> Cells<N> for Patches<N> {
    fn counts(&self) -> [usize; 2] {
        [self.rows, self.columns]
    }

    fn corner(&self, i: usize, j: usize) -> DVec3 {
        let (r, c) = (i.min(self.rows - 1), j.min(self.columns - 1));
        let side = |on: bool| if on { N - 1 } else { 0 };
        self.get(r, c).points[side(i > r)][side(j > c)]
    }

    fn patch(&self, i: usize, j: usize) -> Patch<N> {
        *self.get(i, j)
    }

    fn displacements(&self, block_rows: Range<usize>, boxes: &mut [Aabb]) -> Result<()> {
        let across = self.columns.div_ceil(BLOCK);
        for (k, bounds) in boxes.iter_mut().enumerate() {
            for [i, j] in cells_of_block([block_rows.start + k / across, k % across], self.counts()) {
                let patch = self.get(i, j);
                // From the bilinear patch through the corners that searches see, which are a
                // neighbour's where sides differ.
                let seen = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| self.corner(i, j));
                let corners = patch.corners();
                let gap = Aabb::from_points(corners.as_flattened().iter().zip(seen).map(|(&own, seen)| own - seen));
                *bounds = bounds.union(patch.displacements().sum(gap));
            }
        }
        Ok(())
    }

    fn tangents(&self, block_rows: Range<usize>, boxes: &mut [[Aabb; 2]]) -> Result<()> {
        let across = self.columns.div_ceil(BLOCK);
        for (k, boxes) in boxes.iter_mut().enumerate() {
            let cells = cells_of_block([block_rows.start + k / across, k % across], self.counts());
            *boxes = cells
                .map(|[i, j]| self.get(i, j).tangents())
                .fold([Aabb::EMPTY; 2], |[all_u, all_v], [u, v]| [all_u.union(u), all_v.union(v)]);
        }
        Ok(())
    }
}
