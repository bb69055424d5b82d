//! The cost of a step through the lattice of meridians.
//!
//! Node (i, j) is the meridian from A_i to B_j. A step on A into (i, j) adds the triangle A_i A_i-1
//! B_j, and a step on B adds the triangle A_i B_j-1 B_j. A step on both rims, for strips of quads
//! only, adds the quad of all four vertices.

use super::rim_pair::MeridianEnds;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle::double_area;
use std::ops::Range;

/// The points of a polyline, with one array per coordinate, so that loops vectorise.
pub(super) struct PointArrays {
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
}

impl PointArrays {
    pub(super) fn new(points: &[DVec3]) -> Result<Self> {
        let part = |k: usize| alloc::collect(points.iter().map(|p| p[k]));
        Ok(PointArrays { x: part(0)?, y: part(1)?, z: part(2)? })
    }

    pub(super) fn zeros(len: usize) -> Result<Self> {
        let part = || alloc::filled(0.0, len);
        Ok(PointArrays { x: part()?, y: part()?, z: part()? })
    }

    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    pub(super) fn get(&self, k: usize) -> DVec3 {
        DVec3::new(self.x[k], self.y[k], self.z[k])
    }

    pub(super) fn set(&mut self, k: usize, p: DVec3) {
        [self.x[k], self.y[k], self.z[k]] = p.to_array();
    }

    /// Returns the points of `range`, for [`point_of_slice`].
    pub(super) fn slice(&self, range: Range<usize>) -> [&[f64]; 3] {
        [&self.x[range.clone()], &self.y[range.clone()], &self.z[range]]
    }

    pub(super) fn slice_mut(&mut self, range: Range<usize>) -> [&mut [f64]; 3] {
        [&mut self.x[range.clone()], &mut self.y[range.clone()], &mut self.z[range]]
    }
}

/// Returns point `k` of a [`PointArrays::slice`].
#[inline(always)]
pub(super) fn point_of_slice([x, y, z]: [&[f64]; 3], k: usize) -> DVec3 {
    DVec3::new(x[k], y[k], z[k])
}

/// The costs of the steps into the nodes of one row: `a[j]` and `b[j]` belong to (i, j).
pub(super) struct StepCosts {
    pub(super) costs_on_a: Vec<f64>,
    pub(super) costs_on_b: Vec<f64>,
    /// |A_i B_j|^2.
    pub(super) squared_meridian_lengths: Vec<f64>,
}

impl StepCosts {
    /// Creates costs of 0 for `len` nodes.
    pub(super) fn zeros_for_nodes(len: usize) -> Result<Self> {
        Ok(StepCosts {
            costs_on_a: alloc::filled(0.0, len)?,
            costs_on_b: alloc::filled(0.0, len)?,
            squared_meridian_lengths: alloc::filled(0.0, len)?,
        })
    }
}

/// A sum over the steps of a path, each independent of the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum StepMetric {
    /// Twice the area of the triangles, plus `tie_break_weight` times the sum of the meridians'
    /// squared lengths.
    Area { tie_break_weight: f64 },
    /// The sum of the meridians' lengths.
    Diagonal,
    /// The sum of the meridians' squared lengths. The path may step on both rims at once.
    Quad,
}

impl StepMetric {
    /// Creates the area metric with a tie break. In the plane all strips without folds have equal
    /// area, and round-off would decide. On the paper's strip the squared lengths contribute 2^-32
    /// of the area.
    pub(super) fn area_with_tie_break(a: &[DVec3], b: &[DVec3], paper: &[MeridianEnds]) -> Self {
        let area = strip_area(a, b, paper);
        let squared: f64 = paper.iter().map(|&[i, j]| a[i as usize].distance_squared(b[j as usize])).sum();
        StepMetric::Area {
            tie_break_weight: if area > 0.0 && squared > 0.0 { 0.5f64.powi(32) * area / squared } else { 1.0 },
        }
    }

    /// Returns true if the path may step on both rims at once.
    pub(super) fn may_step_on_both(self) -> bool {
        self == StepMetric::Quad
    }

    /// Computes the costs of the steps into the nodes (i, j) for j in `range`. The loops are free
    /// of branches, so that they vectorise.
    pub(super) fn compute_step_costs(
        self,
        a: &[DVec3],
        b: &PointArrays,
        i: usize,
        range: Range<usize>,
        steps: &mut StepCosts,
    ) {
        let (first, last) = (range.start, range.end - 1);
        let here = a[i];
        let [x, y, z] = [&b.x[first..=last], &b.y[first..=last], &b.z[first..=last]];
        let n = x.len();
        let [step_a, step_b, squared] =
            [&mut steps.costs_on_a, &mut steps.costs_on_b, &mut steps.squared_meridian_lengths]
                .map(|s| &mut s[first..=last]);
        for j in 0..n {
            let (dx, dy, dz) = (x[j] - here.x, y[j] - here.y, z[j] - here.z);
            squared[j] = dx * dx + dy * dy + dz * dz;
        }
        let tie_break_weight = match self {
            StepMetric::Area { tie_break_weight } => tie_break_weight,
            StepMetric::Diagonal => {
                for j in 0..n {
                    step_a[j] = squared[j].sqrt();
                }
                step_b.copy_from_slice(step_a);
                return;
            }
            StepMetric::Quad => {
                step_a.copy_from_slice(squared);
                step_b.copy_from_slice(squared);
                return;
            }
        };
        let edge = here - a[i.saturating_sub(1)];
        for j in 0..n {
            let (dx, dy, dz) = (x[j] - here.x, y[j] - here.y, z[j] - here.z);
            let (cx, cy, cz) = (edge.y * dz - edge.z * dy, edge.z * dx - edge.x * dz, edge.x * dy - edge.y * dx);
            step_a[j] = (cx * cx + cy * cy + cz * cz).sqrt() + tie_break_weight * squared[j];
        }
        // Steps on B start at j = 1.
        let from = first.max(1);
        let (n, before) = (last + 1 - from, from - 1);
        let [x, y, z] = [&b.x[from..=last], &b.y[from..=last], &b.z[from..=last]];
        let [px, py, pz] = [&b.x[before..last], &b.y[before..last], &b.z[before..last]];
        let (step_b, squared) = (&mut steps.costs_on_b[from..=last], &steps.squared_meridian_lengths[from..=last]);
        for j in 0..n {
            let (ex, ey, ez) = (x[j] - px[j], y[j] - py[j], z[j] - pz[j]);
            let (dx, dy, dz) = (here.x - px[j], here.y - py[j], here.z - pz[j]);
            let (cx, cy, cz) = (ey * dz - ez * dy, ez * dx - ex * dz, ex * dy - ey * dx);
            step_b[j] = (cx * cx + cy * cy + cz * cz).sqrt() + tie_break_weight * squared[j];
        }
    }

    /// Returns the cost of a whole path, without its first node.
    pub(super) fn path_cost(self, a: &[DVec3], b: &[DVec3], pairs: &[MeridianEnds]) -> f64 {
        let squared = |&[i, j]: &MeridianEnds| a[i as usize].distance_squared(b[j as usize]);
        match self {
            StepMetric::Area { tie_break_weight } => {
                strip_area(a, b, pairs) + tie_break_weight * pairs[1..].iter().map(squared).sum::<f64>()
            }
            StepMetric::Diagonal => pairs[1..].iter().map(|pair| squared(pair).sqrt()).sum(),
            StepMetric::Quad => pairs[1..].iter().map(squared).sum(),
        }
    }
}

/// Returns twice the area of the strip over `pairs`. Quads are split by the diagonal from the
/// earlier vertex of `a`.
pub(super) fn strip_area(a: &[DVec3], b: &[DVec3], pairs: &[MeridianEnds]) -> f64 {
    let (a_at, b_at) = (|i: u32| a[i as usize], |j: u32| b[j as usize]);
    let mut area = 0.0;
    for step in pairs.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        if j2 > j {
            area += double_area(a_at(i), b_at(j), b_at(j2));
        }
        if i2 > i {
            area += double_area(a_at(i), a_at(i2), b_at(j2));
        }
    }
    area
}
