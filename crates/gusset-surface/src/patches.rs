//! Sheets of Bézier patches that the caller gives.

use super::Patch;
use super::cells::{CELLS_PER_BLOCK_SIDE, SheetCells, cells_of_block};
use super::checks::first_finite_points;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::elevate;
use std::ops::Range;
use std::sync::Arc;

/// Largest degree of a patch.
pub const MAX_DEGREE: usize = 7;

/// `rows x columns` Bézier patches of degree N - 1, row by row. Neighbours share their sides,
/// exactly or nearly.
#[derive(Debug, Clone)]
pub struct Patches<const N: usize> {
    /// A shared vector rather than a shared slice, whose construction would copy the patches.
    patches: Arc<Vec<Patch<N>>>,
    rows: usize,
    columns: usize,
    closed: [bool; 2],
    spline_origin: Option<Arc<SplineOrigin>>,
}

/// The spline from which patches were converted.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SplineOrigin {
    /// A bound of the distance to the spline at equal parameters. If the bound is 0, rounding may
    /// add to it.
    pub(crate) deviation: f64,
    /// The spline's parameters at the borders of cells, in u and in v.
    pub(crate) knots: [Vec<f64>; 2],
}

impl<const N: usize> Patches<N> {
    /// Creates patches from control nets, one after the other. Each net has `(degree_u + 1) *
    /// (degree_v + 1)` points, u by u. Lower degrees are raised to N - 1, which changes the surface
    /// only by rounding.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a degree is 0 or above N - 1, [`Error::EmptyMesh`]
    /// without patches, [`Error::ArrayTooShort`], [`Error::TooLarge`], [`Error::NotFinite`] with
    /// the control point, [`Error::OutOfMemory`].
    pub fn new(points: &[DVec3], degrees: [usize; 2], rows: usize, columns: usize) -> Result<Self> {
        degrees.iter().try_for_each(|&degree| {
            Error::require((1..N).contains(&degree), "degree", degree as f64, 1.0..=(N - 1) as f64)
        })?;
        let each = (degrees[0] + 1) * (degrees[1] + 1);
        let count = (rows as u64).saturating_mul(columns as u64);
        let total = count.saturating_mul(each as u64);
        if count == 0 {
            return Err(Error::EmptyMesh { what: "patches" });
        }
        Error::check_count("control points", total, super::MAX_NODES)?;
        let points = first_finite_points(points, total, "control points")?;
        let patches = alloc::collect(points.chunks_exact(each).map(|net| Patch::from_lower_degrees(net, degrees)))?;
        Ok(Self::from_patches(patches, rows, columns))
    }

    /// Creates a sheet of `rows * columns` patches. At least one patch is required.
    pub(crate) fn from_patches(patches: Vec<Patch<N>>, rows: usize, columns: usize) -> Self {
        let mut made =
            Patches { patches: Arc::new(patches), rows, columns, closed: [false, false], spline_origin: None };
        let closed_u = |j: usize| made.get(0, j).points[0] == made.get(rows - 1, j).points[N - 1];
        let closed_v = |i: usize| {
            let (first, last) = (made.get(i, 0), made.get(i, columns - 1));
            first.points.iter().zip(&last.points).all(|(first, last)| first[0] == last[N - 1])
        };
        made.closed = [rows > 2 && (0..columns).all(closed_u), columns > 2 && (0..rows).all(closed_v)];
        made
    }

    /// Returns the patches with a record of the spline they were converted from.
    pub(crate) fn with_spline_origin(self, origin: SplineOrigin) -> Self {
        Patches { spline_origin: Some(Arc::new(origin)), ..self }
    }

    /// The spline that the patches were converted from, if any.
    pub(crate) fn spline_origin(&self) -> Option<&SplineOrigin> {
        self.spline_origin.as_deref()
    }

    /// The numbers of cells in u and in v.
    pub fn cells(&self) -> [usize; 2] {
        [self.rows, self.columns]
    }

    /// Whether the sheet is closed in u and in v. A closed direction has at least three cells, and
    /// the control points of its last side equal those on its first one.
    pub fn is_closed(&self) -> [bool; 2] {
        self.closed
    }

    /// The patch over the cell at (i, j).
    pub fn get(&self, i: usize, j: usize) -> &Patch<N> {
        &self.patches[i * self.columns + j]
    }
}

impl<const N: usize> Patch<N> {
    /// Raises a control net of lower degrees to degree N - 1.
    pub(crate) fn from_lower_degrees(net: &[DVec3], [p, q]: [usize; 2]) -> Patch<N> {
        let mut points = [[DVec3::ZERO; N]; N];
        for (row, given) in points.iter_mut().zip(net.chunks_exact(q + 1)) {
            row[..=q].copy_from_slice(given);
            elevate(row, q);
        }
        elevate(&mut points, p);
        Patch { points }
    }
}

impl<const N: usize> SheetCells<N> for Patches<N> {
    fn cell_counts(&self) -> [usize; 2] {
        [self.rows, self.columns]
    }

    fn corner_point(&self, i: usize, j: usize) -> DVec3 {
        let (r, c) = (i.min(self.rows - 1), j.min(self.columns - 1));
        let side = |on: bool| if on { N - 1 } else { 0 };
        self.get(r, c).points[side(i > r)][side(j > c)]
    }

    fn cell_patch(&self, i: usize, j: usize) -> Patch<N> {
        *self.get(i, j)
    }

    fn fill_displacement_boxes(&self, block_rows: Range<usize>, boxes: &mut [Aabb]) -> Result<()> {
        let across = self.columns.div_ceil(CELLS_PER_BLOCK_SIDE);
        for (k, bounds) in boxes.iter_mut().enumerate() {
            for [i, j] in cells_of_block([block_rows.start + k / across, k % across], self.cell_counts()) {
                let patch = self.get(i, j);
                // The bilinear patch uses the corners that searches see. Where sides differ, they
                // are a neighbour's corners.
                let seen = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| self.corner_point(i, j));
                let corners = patch.corner_points();
                let gap = Aabb::from_points(corners.as_flattened().iter().zip(seen).map(|(&own, seen)| own - seen));
                *bounds = bounds.union(patch.displacement_box().minkowski_sum(gap));
            }
        }
        Ok(())
    }

    fn fill_tangent_boxes(&self, block_rows: Range<usize>, boxes: &mut [[Aabb; 2]]) -> Result<()> {
        let across = self.columns.div_ceil(CELLS_PER_BLOCK_SIDE);
        for (k, boxes) in boxes.iter_mut().enumerate() {
            let cells = cells_of_block([block_rows.start + k / across, k % across], self.cell_counts());
            *boxes = cells
                .map(|[i, j]| self.get(i, j).tangent_boxes())
                .fold([Aabb::EMPTY; 2], |[all_u, all_v], [u, v]| [all_u.union(u), all_v.union(v)]);
        }
        Ok(())
    }
}
