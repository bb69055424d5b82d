//! Costs between neighbouring triangles.
//!
//! **Smooth** is the sum of (1 - cos t) times the edge's length over all inner edges of the strip.
//! Here t is the angle between the normals of the edge's triangles. For small angles this is t^2 /
//! 2 times the length, like the energy of a bent plate: many small bends cost less than one sharp
//! bend. Along the rims the second triangle is the old face, if it is known.
//!
//! **Continuation** has two terms. The first is the sum of 2 sin(t / 2), with the weight
//! [`RIM_BEND_WEIGHT`] along the rims. It does not depend on the edge's length, and is nearly
//! linear in t. So a surface may turn in one place rather than a little everywhere, as where the
//! old faces continue across the gap. Above 150 degrees two triangles fold onto each other, and the
//! cost grows steeply. The second term is the mean square distance of the triangles from the likely
//! old surface. A meridian from A_i to B_j has ends at the distances h and k from each other's
//! tangent planes. Like the cubic with these tangents, it bulges by b^2 = (h^2 + k^2) / 32 in the
//! middle. A triangle between two meridians has the mean square (b1^2 + b1 b2 + b2^2) / 3. All
//! lengths are in mean edges of the rims. The weights, and the powers of t and of the length, were
//! tuned on parts cut out of closed meshes, which the strips should approximate (`make bench
//! ONLY=truth`).
//!
//! A degenerate triangle counts as perpendicular to its neighbours. All loops over the nodes of a
//! row are free of branches, so that they vectorise.

use super::rim_pair::{MeridianEnds, RimPair};
use super::step_metric::{PointArrays, StepCosts, point_of_slice};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// The weight of bends along the rims relative to bends across meridians, for
/// [`StripBends::for_best_continuation`].
const RIM_BEND_WEIGHT: f64 = 4.0;
/// The distance of the unit normals of two triangles that fold onto each other: 150 degrees.
const MIN_FOLD_DISTANCE: f64 = 1.931_851_652_578_136_6;
/// The cost of a fold for each unit of distance beyond [`MIN_FOLD_DISTANCE`].
const FOLD_COST: f64 = 50.0;

/// The cost of strips between two rims, as a sum over the steps of their meridians.
pub(super) struct StripBends<'a> {
    a: &'a [DVec3],
    b: PointArrays,
    /// The unit normals of the faces along the rims, 0 if unknown. The normal at `k` belongs to the
    /// edge that ends at place k.
    face_normals_along_rims: [PointArrays; 2],
    /// Weight of the bends along the rims.
    rim_weight: f64,
    /// Weight of the sum of squared meridian lengths. It decides between strips of equal bend.
    tie_break_weight: f64,
    continuation: Option<OldSurfaceNormals>,
}

/// The quantities for the likely old surface.
struct OldSurfaceNormals {
    /// The normals at the vertices of both rims.
    normals: [PointArrays; 2],
    /// The reciprocal of the mean edge of the rims.
    reciprocal_mean_edge: f64,
}

/// The quantities of the steps into the nodes (i, j) of one row, by j.
pub(super) struct StepRow {
    /// The unit normals of the triangles A_i A_i-1 B_j and A_i B_j-1 B_j; 0 for a missing or
    /// degenerate triangle.
    normals: [PointArrays; 2],
    areas: [Vec<f64>; 2],
    /// For each node, the squared bulge of its meridian. If bends are weighted by length, the
    /// length of its meridian.
    meridians: Vec<f64>,
}

impl StepRow {
    pub(super) fn new(len: usize) -> Result<Self> {
        let zeros = || alloc::filled(0.0, len);
        let normals = [PointArrays::zeros(len)?, PointArrays::zeros(len)?];
        Ok(StepRow { normals, areas: [zeros()?, zeros()?], meridians: zeros()? })
    }
}

impl<'a> StripBends<'a> {
    /// Creates the cost of a strip that is to have the least bends. For `tie_break_weight` see
    /// [`weight_of_squared_lengths`].
    pub(super) fn for_least_bends(rims: &RimPair<'a>, tie_break_weight: f64) -> Result<Self> {
        let &RimPair { a, b, face_normals_along_rims: sides, .. } = rims;
        let ends = |points: &[DVec3], side: Option<&[DVec3]>| {
            let mut line = PointArrays::zeros(points.len())?;
            (1..points.len()).zip(side.into_iter().flatten()).for_each(|(k, &normal)| line.set(k, normal));
            Ok(line)
        };
        let rim_weight = if sides.is_some() { 1.0 } else { 0.0 };
        let sides = [ends(a, sides.map(|sides| sides[0]))?, ends(b, sides.map(|sides| sides[1]))?];
        Ok(StripBends {
            a,
            b: PointArrays::new(b)?,
            face_normals_along_rims: sides,
            rim_weight,
            tie_break_weight,
            continuation: None,
        })
    }

    /// Creates the cost of a strip that is to continue both surfaces: the sum of its bends, plus its
    /// mean square distance from the likely old surface.
    pub(super) fn for_best_continuation(rims: &RimPair<'a>, tie_break_weight: f64) -> Result<Self> {
        let &RimPair { a, b, face_normals_along_rims: sides, closed, .. } = rims;
        let length = |line: &[DVec3]| line.windows(2).map(|edge| edge[0].distance(edge[1])).sum::<f64>();
        let mean = (length(a) + length(b)) / (a.len() + b.len() - 2).max(1) as f64;
        let per_edge = if mean > 0.0 { 1.0 / mean } else { 0.0 };
        let normals = |points: &[DVec3], side: Option<&[DVec3]>| match side {
            Some(side) => PointArrays::new(&vertex_normals(side, points.len(), closed)?),
            None => PointArrays::zeros(points.len()),
        };
        let normals = [normals(a, sides.map(|sides| sides[0]))?, normals(b, sides.map(|sides| sides[1]))?];
        let least = StripBends::for_least_bends(rims, tie_break_weight * per_edge)?;
        let rim_weight = RIM_BEND_WEIGHT * least.rim_weight;
        Ok(StripBends {
            rim_weight,
            continuation: Some(OldSurfaceNormals { normals, reciprocal_mean_edge: per_edge }),
            ..least
        })
    }

    /// Computes the costs of the steps into the nodes (i, j) for j in `range`: `steps[0]` for those
    /// that follow a step on A, and `steps[1]` for those that follow a step on B. Reads row i - 1
    /// from `rows[0]`, and writes row i to `rows[1]`.
    pub(super) fn compute_row_costs(
        &self,
        i: usize,
        range: Range<usize>,
        rows: [&mut StepRow; 2],
        steps: &mut [StepCosts; 2],
    ) {
        self.compute_triangles(i, range.clone(), rows[1], &mut steps[0].squared_meridian_lengths);
        match &self.continuation {
            Some(tangents) => {
                tangents.compute_squared_bulges(self.a[i], &self.b, i, range.clone(), rows[1]);
                self.compute_step_costs::<true>(i, range, rows, steps);
            }
            None => self.compute_step_costs::<false>(i, range, rows, steps),
        }
    }

    /// Computes the normals and areas of row i's triangles, and the lengths and squared lengths of
    /// its meridians.
    fn compute_triangles(&self, i: usize, range: Range<usize>, row: &mut StepRow, squared: &mut [f64]) {
        let (here, back) = (self.a[i], self.a[i.saturating_sub(1)] - self.a[i]);
        let b = self.b.slice(range.clone());
        let [by_a, by_b] = &mut row.normals;
        let [area_a, area_b] = &mut row.areas;
        let [x, y, z] = by_a.slice_mut(range.clone());
        let (area, squared) = (&mut area_a[range.clone()], &mut squared[range.clone()]);
        let length = &mut row.meridians[range.clone()];
        for j in 0..area.len() {
            let across = point_of_slice(b, j) - here;
            let double = back.cross(across);
            (area[j], squared[j]) = (0.5 * double.length(), across.length_squared());
            length[j] = squared[j].sqrt();
            [x[j], y[j], z[j]] = double.normalize_or_zero().to_array();
        }
        // Steps on B start at j = 1.
        let (from, end) = (range.start.max(1), range.end);
        let (before, b) = (self.b.slice(from - 1..end - 1), self.b.slice(from..end));
        let [x, y, z] = by_b.slice_mut(from..end);
        let area = &mut area_b[from..end];
        for j in 0..area.len() {
            let double = (point_of_slice(before, j) - here).cross(point_of_slice(b, j) - here);
            area[j] = 0.5 * double.length();
            [x[j], y[j], z[j]] = double.normalize_or_zero().to_array();
        }
    }

    fn compute_step_costs<const CONTINUES: bool>(
        &self,
        i: usize,
        range: Range<usize>,
        [before, now]: [&mut StepRow; 2],
        [after_a, after_b]: &mut [StepCosts; 2],
    ) {
        let edge = self.a[i.saturating_sub(1)].distance(self.a[i]);
        let side = self.face_normals_along_rims[0].get(i);
        let steps = RimStepsOfRow {
            normals: now.normals[0].slice(range.clone()),
            areas: &now.areas[0][range.clone()],
            meridians: [&before.meridians[range.clone()], &now.meridians[range.clone()]],
            normals_before: [0, 1].map(|k| before.normals[k].slice(range.clone())),
            squared_meridian_lengths: &after_a.squared_meridian_lengths[range.clone()],
        };
        let costs = [&mut after_a.costs_on_a[range.clone()], &mut after_b.costs_on_a[range.clone()]];
        steps.compute_costs::<CONTINUES>(self, (i, range.start) == (1, 0), |_| (side, edge), costs);

        let (from, end) = (range.start.max(1), range.end);
        let (sides, b, next) = (
            self.face_normals_along_rims[1].slice(from..end),
            self.b.slice(from - 1..end - 1),
            self.b.slice(from..end),
        );
        let steps = RimStepsOfRow {
            normals: now.normals[1].slice(from..end),
            areas: &now.areas[1][from..end],
            meridians: [&now.meridians[from - 1..end - 1], &now.meridians[from..end]],
            normals_before: [0, 1].map(|k| now.normals[k].slice(from - 1..end - 1)),
            squared_meridian_lengths: &after_a.squared_meridian_lengths[from..end],
        };
        let costs = [&mut after_a.costs_on_b[from..end], &mut after_b.costs_on_b[from..end]];
        let rim = |j: usize| (point_of_slice(sides, j), point_of_slice(b, j).distance(point_of_slice(next, j)));
        steps.compute_costs::<CONTINUES>(self, (i, from) == (0, 1), rim, costs);
    }

    /// Returns the bend across the meridian where a closed strip begins, between the last triangle
    /// and the first. `last_on_b` and `first_on_b` tell the rims of the last and the first step.
    pub(super) fn bend_across_seam(&self, last_on_b: bool, first_on_b: bool) -> f64 {
        let (n, m) = (self.a.len() - 1, self.b.len() - 1);
        let b = |j: usize| self.b.get(j);
        let normal = |i: usize, j: usize, on_b: bool| {
            let from = if on_b { b(j - 1) } else { self.a[i - 1] };
            (from - self.a[i]).cross(b(j) - self.a[i]).normalize_or_zero()
        };
        let next = if first_on_b { normal(0, 1, true) } else { normal(1, 0, false) };
        let (last, length) = (normal(n, m, last_on_b), self.a[n].distance(b(m)));
        if self.continuation.is_some() {
            bend_between_normals::<true>(last, next, length)
        } else {
            bend_between_normals::<false>(last, next, length)
        }
    }
}

impl OldSurfaceNormals {
    /// Computes the squared bulges of the meridians in squared mean edges, and converts the areas
    /// to the same unit.
    fn compute_squared_bulges(&self, here: DVec3, b: &PointArrays, i: usize, range: Range<usize>, row: &mut StepRow) {
        let square = self.reciprocal_mean_edge * self.reciprocal_mean_edge;
        let normal = self.normals[0].get(i);
        let (normals, b) = (self.normals[1].slice(range.clone()), b.slice(range.clone()));
        for (j, bulge) in row.meridians[range.clone()].iter_mut().enumerate() {
            let across = point_of_slice(b, j) - here;
            let (h, k) = (normal.dot(across), point_of_slice(normals, j).dot(across));
            *bulge = (h * h + k * k) / 32.0 * square;
        }
        row.areas.iter_mut().flat_map(|areas| &mut areas[range.clone()]).for_each(|area| *area *= square);
    }
}

/// For consecutive nodes of a row, the quantities of the step into each node along one rim. Element
/// k of each array belongs to node k.
struct RimStepsOfRow<'a> {
    /// The normals of the added triangles.
    normals: [&'a [f64]; 3],
    areas: &'a [f64],
    /// The quantities of the meridians before and after each step; see [`StepRow`].
    meridians: [&'a [f64]; 2],
    /// The normals of the preceding triangles, by steps on A and on B.
    normals_before: [[&'a [f64]; 3]; 2],
    /// The squared lengths of the meridians.
    squared_meridian_lengths: &'a [f64],
}

impl RimStepsOfRow<'_> {
    /// Computes the costs after a step on A, and after a step on B. `rim` returns the normal of the
    /// face along the rim and the length of the edge. If `begins`, the first step is the first of
    /// the path: no triangle precedes it, and the seam is added at the end.
    #[inline(always)]
    fn compute_costs<const CONTINUES: bool>(
        &self,
        bends: &StripBends<'_>,
        begins: bool,
        rim: impl Fn(usize) -> (DVec3, f64),
        [after_a, after_b]: [&mut [f64]; 2],
    ) {
        let (tie_break_weight, rim_weight) = (bends.tie_break_weight, bends.rim_weight);
        let [from, to] = self.meridians;
        let alone = |j: usize| {
            let (side, length) = rim(j);
            let along = tie_break_weight * self.squared_meridian_lengths[j]
                + rim_weight * bend_between_normals::<CONTINUES>(point_of_slice(self.normals, j), side, length);
            if !CONTINUES {
                return along;
            }
            along + self.areas[j] * ((to[j] + from[j] + (to[j] * from[j]).sqrt()) / 3.0)
        };
        for j in 0..after_a.len() {
            let (normal, alone) = (point_of_slice(self.normals, j), alone(j));
            after_a[j] =
                alone + bend_between_normals::<CONTINUES>(normal, point_of_slice(self.normals_before[0], j), from[j]);
            after_b[j] =
                alone + bend_between_normals::<CONTINUES>(normal, point_of_slice(self.normals_before[1], j), from[j]);
        }
        if begins && let ([a, ..], [b, ..]) = (after_a, after_b) {
            (*a, *b) = (alone(0), alone(0));
        }
    }
}

/// Returns the bend between triangles with normals `p` and `q` across an edge.
#[inline(always)]
fn bend_between_normals<const CONTINUES: bool>(p: DVec3, q: DVec3, length: f64) -> f64 {
    if !CONTINUES {
        return length * (1.0 - p.dot(q));
    }
    let bend = p.distance(q);
    bend + FOLD_COST * (bend - MIN_FOLD_DISTANCE).max(0.0)
}

/// Returns the normals at the vertices of a rim, each the mean over its two faces on the rim. The
/// last point of a closed rim repeats the first.
fn vertex_normals(sides: &[DVec3], points: usize, closed: bool) -> Result<Vec<DVec3>> {
    let around = |k: usize| match (k.checked_sub(1), sides.get(k)) {
        (Some(before), Some(&after)) => sides[before] + after,
        (None, Some(&after)) if closed => sides[sides.len() - 1] + after,
        (Some(before), None) if closed => sides[before] + sides[0],
        (Some(before), None) => sides[before],
        (None, after) => after.copied().unwrap_or_default(),
    };
    alloc::collect((0..points).map(|k| around(k).normalize_or_zero()))
}

/// Returns a weight for the meridians' squared lengths. In the plane all strips have equal bends,
/// and round-off would decide. On the paper's strip this term is 2^-20 of the meridians' lengths.
pub(super) fn weight_of_squared_lengths(rims: &RimPair<'_>, paper: &[MeridianEnds]) -> f64 {
    let squared = |&[i, j]: &MeridianEnds| rims.a[i as usize].distance_squared(rims.b[j as usize]);
    let (lengths, squares) =
        paper.iter().map(squared).fold((0.0, 0.0), |(lengths, squares), s| (lengths + s.sqrt(), squares + s));
    if squares > 0.0 { 0.5f64.powi(20) * lengths / squares } else { 0.0 }
}
