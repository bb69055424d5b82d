//! The cost of a triangulation of a loop.
//!
//! **Continuation** has two terms. The first is the sum of 2 sin(t / 2) over all edges, including
//! the rim's, where t is the angle between the normals on both sides. It does not depend on the
//! edge's length, and is nearly linear in t, so that a surface may turn in one place rather than a
//! little everywhere. The second is the mean square distance of the triangles from the likely old
//! surface. A chord has ends at the distances h and k from each other's tangent planes. Like the
//! cubic with these tangents, it bulges by b^2 = (h^2 + k^2) / 32 in the middle. Bulges are in
//! units of 1 / 140 of the rim's length. A triangle with the bulges b1, b2, b3 has the mean square
//! (b1^2 + b2^2 + b3^2 + b1 b2 + b2 b3 + b3 b1) / 6. The second term is the mean over the
//! triangles. Both terms are invariant under refinement of the rim. Strips are chosen in the same
//! way. Among the weights tried, this one gives the triangulations nearest to the parts cut out of
//! closed meshes (`make bench ONLY=fill/truth`).
//!
//! The other weights follow the sources.

use super::Weight;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::cmp::Ordering;

/// A loop to be triangulated: triangles run its edges from each point to the next.
pub(super) struct Polygon {
    pub(super) points: Vec<DVec3>,
    /// The unit normal of the face across the edge from each point to the next; 0 if it is not
    /// known.
    pub(super) normals_across_edges: Vec<DVec3>,
    /// The unit normal of the old surface at each point; 0 if it is undefined.
    pub(super) normals: Vec<DVec3>,
    /// The reciprocal of the unit of bulges.
    reciprocal_bulge_unit: f64,
}

impl Polygon {
    pub(super) fn new(points: Vec<DVec3>, across: Vec<DVec3>, normals: Vec<DVec3>) -> Self {
        let mut polygon = Polygon { points, normals_across_edges: across, normals, reciprocal_bulge_unit: 0.0 };
        let length = polygon.perimeter();
        polygon.reciprocal_bulge_unit = if length > 0.0 { BULGE_UNITS_PER_RIM / length } else { 0.0 };
        polygon
    }

    /// Returns the perimeter of the closed polygon.
    pub(super) fn perimeter(&self) -> f64 {
        self.points.iter().zip(self.points.iter().cycle().skip(1)).map(|(p, q)| p.distance(*q)).sum()
    }

    /// Returns the polygon thinned to at most `max_points` points.
    pub(super) fn thinned_to_point_count(&self, max_points: usize) -> Result<Polygon> {
        let of = |points: &[DVec3]| alloc::copied(points);
        let (points, across, normals) = (of(&self.points)?, of(&self.normals_across_edges)?, of(&self.normals)?);
        let mut few = Polygon {
            points,
            normals_across_edges: across,
            normals,
            reciprocal_bulge_unit: self.reciprocal_bulge_unit,
        };
        while few.points.len() > max_points {
            few = few.every_other_point()?.0;
        }
        Ok(few)
    }

    /// Keeps every other point and the last one. Also returns the old index of each point.
    pub(super) fn every_other_point(&self) -> Result<(Polygon, Vec<u32>)> {
        let n = self.points.len();
        let mut kept = alloc::collect((0..n.div_ceil(2)).map(|i| 2 * i as u32))?;
        if n.is_multiple_of(2) {
            alloc::push(&mut kept, n as u32 - 1)?;
        }
        let at = |of: &[DVec3]| alloc::collect(kept.iter().map(|&i| of[i as usize]));
        let across = alloc::collect((0..kept.len()).map(|i| {
            let edges = kept[i] as usize..kept.get(i + 1).map_or(n, |&end| end as usize);
            let weighted = |e: usize| self.normals_across_edges[e] * self.points[e].distance(self.points[(e + 1) % n]);
            edges.map(weighted).sum::<DVec3>().normalize_or_zero()
        }))?;
        let (points, normals) = (at(&self.points)?, at(&self.normals)?);
        Ok((
            Polygon {
                points,
                normals_across_edges: across,
                normals,
                reciprocal_bulge_unit: self.reciprocal_bulge_unit,
            },
            kept,
        ))
    }
}

/// The cost of a triangulation. Costs are compared field by field; less is better.
#[derive(Clone, Copy)]
pub(super) struct TriangulationCost {
    /// The number of triangles without area.
    degenerate_count: u32,
    /// The largest bend across an edge, as 1 - cosine in steps of 2^-20, so that rounding does not
    /// decide before `area_and_bend_cost` does.
    largest_bend_steps: u32,
    /// The area plus the cost of bends, or the sum of bends and bulges.
    area_and_bend_cost: f64,
    /// The sum of squared sides of the triangles, which decides among flat triangulations.
    squared_side_sum: f64,
}

impl TriangulationCost {
    pub(super) const ZERO: TriangulationCost = TriangulationCost {
        degenerate_count: 0,
        largest_bend_steps: 0,
        area_and_bend_cost: 0.0,
        squared_side_sum: 0.0,
    };

    pub(super) fn plus(self, other: TriangulationCost) -> TriangulationCost {
        TriangulationCost {
            degenerate_count: self.degenerate_count + other.degenerate_count,
            largest_bend_steps: self.largest_bend_steps.max(other.largest_bend_steps),
            area_and_bend_cost: self.area_and_bend_cost + other.area_and_bend_cost,
            squared_side_sum: self.squared_side_sum + other.squared_side_sum,
        }
    }

    /// Multiplies the cost by a factor.
    pub(super) fn scaled(self, times: f64) -> TriangulationCost {
        let bend = (f64::from(self.largest_bend_steps) * times).ceil() as u32;
        TriangulationCost {
            largest_bend_steps: bend,
            area_and_bend_cost: self.area_and_bend_cost * times,
            squared_side_sum: self.squared_side_sum * times,
            ..self
        }
    }

    #[cfg(test)]
    pub(super) fn weighted_value(&self) -> f64 {
        self.area_and_bend_cost
    }

    /// Returns the relative gain in value over another cost; 1 if this cost has fewer degenerate
    /// triangles or a smaller bend.
    pub(super) fn relative_gain_over(&self, other: &TriangulationCost) -> f64 {
        match (self.degenerate_count, self.largest_bend_steps).cmp(&(other.degenerate_count, other.largest_bend_steps))
        {
            Ordering::Less => 1.0,
            Ordering::Greater => 0.0,
            Ordering::Equal => {
                (other.area_and_bend_cost - self.area_and_bend_cost) / other.area_and_bend_cost.max(f64::MIN_POSITIVE)
            }
        }
    }
}

/// The length of a rim in units of bulges. A surface that is one unit away from its triangulation
/// everywhere costs as much as an edge that bends by 60 degrees.
const BULGE_UNITS_PER_RIM: f64 = 140.0;
/// Areas count as equal if they differ by at most this fraction of the loop's squared size.
const MAX_RELATIVE_EQUAL_AREA_DIFFERENCE: f64 = 1e-14;
/// Sums of angles count as equal if they differ by at most this, in radians. The rounding is large
/// because a bend of 0 is the square root of a rounding error.
const MAX_EQUAL_ANGLE_SUM_DIFFERENCE: f64 = 1e-6;
/// A triangle is degenerate if its doubled area is at most this fraction of its sides' squares.
const MAX_DEGENERATE_AREA_RATIO: f64 = 1e-10;
/// The ends of a side coincide if its length is at most this fraction of the triangle's size.
const MAX_COINCIDENT_END_RATIO: f64 = 1e-10;
/// Number of steps of [`TriangulationCost::largest_bend_steps`] per unit of 1 - cosine.
const BEND_STEPS_PER_COSINE: f64 = (1 << 20) as f64;

/// The quantities that all triangulations of the same loops share.
#[derive(Clone, Copy)]
pub(super) struct CostNormalisation {
    /// The square of the largest distance from the first point.
    squared_extent: f64,
    /// The reciprocal of the unit of bulges.
    per_unit: f64,
    /// The number of triangles of any triangulation.
    triangles: f64,
}

impl CostNormalisation {
    /// Measures loops whose triangulations have this number of triangles.
    pub(super) fn new<'a>(loops: impl Iterator<Item = &'a [DVec3]> + Clone, triangles: usize) -> CostNormalisation {
        let first = loops.clone().flatten().next().copied().unwrap_or_default();
        let size = loops.clone().flatten().map(|p| p.distance_squared(first)).fold(0.0, f64::max);
        let sides = loops.flat_map(|points| points.iter().zip(points.iter().cycle().skip(1)));
        let length: f64 = sides.map(|(p, q)| p.distance(*q)).sum();
        let per_unit = if length > 0.0 { BULGE_UNITS_PER_RIM / length } else { 0.0 };
        CostNormalisation { squared_extent: size, per_unit, triangles: triangles.max(1) as f64 }
    }

    /// Replaces the unit of bulges by the unit of `all`.
    pub(super) fn with_bulge_unit_of(self, all: CostNormalisation) -> CostNormalisation {
        CostNormalisation { per_unit: all.per_unit, ..self }
    }
}

/// The weights of the triangulations of one polygon.
pub(super) struct CostEvaluator<'a> {
    polygon: &'a Polygon,
    /// True for places whose edge to the next place is a bridge. Empty for a single loop.
    is_bridge: &'a [bool],
    weight: Weight,
    /// Values that differ by at most this are equal.
    rounding: f64,
    normalisation: CostNormalisation,
}

impl<'a> CostEvaluator<'a> {
    pub(super) fn new(polygon: &'a Polygon, weight: Weight) -> Self {
        let points = &polygon.points;
        let size = points.iter().map(|p| p.distance_squared(points[0])).fold(0.0, f64::max);
        let triangles = points.len().saturating_sub(2).max(1) as f64;
        CostEvaluator::for_opened_loops(
            polygon,
            weight,
            CostNormalisation { squared_extent: size, per_unit: polygon.reciprocal_bulge_unit, triangles },
            &[],
        )
    }

    /// Creates the scale of loops that are cut open along bridges into one polygon.
    pub(super) fn for_opened_loops(
        polygon: &'a Polygon,
        weight: Weight,
        measure: CostNormalisation,
        bridges: &'a [bool],
    ) -> Self {
        let rounding = if weight == Weight::Continuation {
            MAX_EQUAL_ANGLE_SUM_DIFFERENCE
        } else {
            MAX_RELATIVE_EQUAL_AREA_DIFFERENCE * measure.squared_extent
        };
        CostEvaluator { polygon, is_bridge: bridges, weight, rounding, normalisation: measure }
    }

    pub(super) fn polygon(&self) -> &'a Polygon {
        self.polygon
    }

    pub(super) fn is_cheaper(&self, a: &TriangulationCost, b: &TriangulationCost) -> bool {
        match (a.degenerate_count, a.largest_bend_steps).cmp(&(b.degenerate_count, b.largest_bend_steps)) {
            Ordering::Less => true,
            Ordering::Greater => false,
            Ordering::Equal if (a.area_and_bend_cost - b.area_and_bend_cost).abs() > self.rounding => {
                a.area_and_bend_cost < b.area_and_bend_cost
            }
            Ordering::Equal => a.squared_side_sum < b.squared_side_sum,
        }
    }

    /// Returns the likely distance of the old surface from the middle of the chord (i, k), in the
    /// unit of bulges; 0 along the rim.
    pub(super) fn chord_bulge(&self, i: usize, k: usize) -> f64 {
        let is_rim = |edge: usize| !self.is_bridge.get(edge).is_some_and(|&is_bridge| is_bridge);
        if k == i + 1 && is_rim(i) || k - i + 1 == self.polygon.points.len() && is_rim(k) {
            return 0.0;
        }
        self.bulge_of_any_chord([i, k])
    }

    /// Returns the bulge of a chord between any two vertices.
    pub(super) fn bulge_of_any_chord(&self, [i, k]: [usize; 2]) -> f64 {
        let Polygon { points, normals, .. } = self.polygon;
        if self.weight != Weight::Continuation {
            return 0.0;
        }
        let chord = (points[k] - points[i]) * self.normalisation.per_unit;
        let [h, g] = [i, k].map(|end| chord.dot(normals[end]));
        ((h * h + g * g) / 32.0).sqrt()
    }

    /// Closes a seam: a triangle (i, m, k) of which two vertices coincide, between two coincident
    /// sides.
    ///
    /// Returns the normal beyond the seam, and the cost of closing it. `normals` are the normals
    /// beyond (i, m) and (m, k); the normal is 0 if neither coincident side is (i, k). Returns
    /// `None` for other triangles, and if there are several loops. Without seams, a slit with
    /// coincident sides would be closed by pairs of triangles back to back, because triangles
    /// without area are the last choice.
    pub(super) fn seam_triangle_cost(
        &self,
        [i, m, k]: [usize; 3],
        [left, right]: [DVec3; 2],
    ) -> Option<(DVec3, TriangulationCost)> {
        let squared = |a: usize, b: usize| self.polygon.points[a].distance_squared(self.polygon.points[b]);
        let [first, second, third] = [squared(i, m), squared(m, k), squared(k, i)];
        let none = MAX_COINCIDENT_END_RATIO * MAX_COINCIDENT_END_RATIO * (first + second + third);
        if !self.is_bridge.is_empty() {
            None
        } else if third <= none {
            Some((DVec3::ZERO, self.bend_cost([i, m], left, right)))
        } else if first <= none {
            Some((right, TriangulationCost::ZERO))
        } else if second <= none {
            Some((left, TriangulationCost::ZERO))
        } else {
            None
        }
    }

    /// Returns the unit normal of a triangle (0 if the triangle is degenerate) and its own cost.
    /// `bulges` belong to its three sides.
    pub(super) fn triangle_cost(&self, corners: [usize; 3], bulges: [f64; 3]) -> (DVec3, TriangulationCost) {
        let [p, q, r] = corners.map(|k| self.polygon.points[k]);
        let cross = (q - p).cross(r - p);
        let double_area = cross.length();
        let sides = p.distance_squared(q) + q.distance_squared(r) + r.distance_squared(p);
        let flat = double_area <= MAX_DEGENERATE_AREA_RATIO * sides;
        let normal = if flat { DVec3::ZERO } else { cross / double_area };
        // A seam between two coincident sides is not degenerate; see `seam`.
        let shortest = p.distance_squared(q).min(q.distance_squared(r)).min(r.distance_squared(p));
        let flat = flat && shortest > MAX_COINCIDENT_END_RATIO * MAX_COINCIDENT_END_RATIO * sides;
        let [x, y, z] = bulges;
        let value = match self.weight {
            Weight::Continuation => {
                (x * x + y * y + z * z + x * y + y * z + z * x) / (6.0 * self.normalisation.triangles)
            }
            Weight::AreaAndBend | Weight::BendThenArea | Weight::Area => 0.5 * double_area,
        };
        (
            normal,
            TriangulationCost {
                degenerate_count: u32::from(flat),
                largest_bend_steps: 0,
                area_and_bend_cost: value,
                squared_side_sum: sides,
            },
        )
    }

    /// Returns the cost of the bend across the chord (i, k) between two unit normals; 0 if one is
    /// unknown.
    pub(super) fn bend_cost(&self, [i, k]: [usize; 2], a: DVec3, b: DVec3) -> TriangulationCost {
        let mut cost = TriangulationCost::ZERO;
        if a == DVec3::ZERO || b == DVec3::ZERO {
            return cost;
        }
        let bend = (1.0 - a.dot(b)).max(0.0);
        match self.weight {
            Weight::Area => {}
            // 2 sin(t / 2) = sqrt(2 (1 - cos t)).
            Weight::Continuation => cost.area_and_bend_cost = (2.0 * bend).sqrt(),
            Weight::BendThenArea => cost.largest_bend_steps = (BEND_STEPS_PER_COSINE * bend).round() as u32,
            Weight::AreaAndBend => {
                cost.area_and_bend_cost = bend * self.polygon.points[i].distance_squared(self.polygon.points[k]);
            }
        }
        cost
    }
}
