//! What a triangulation of a loop costs.
//!
//! **Continuation.** Over all edges, those of the rim included, the sum of 2 sin(t / 2), t being the
//! angle between the normals on both sides, whatever the edge's length: nearly linear in t, so that
//! a surface may turn in one place rather than a little everywhere. To it comes, over the triangles,
//! the mean square of the distance that the surface which was there is likely to have had from them:
//! a chord whose ends lie h and k off each other's tangent planes bulges by b^2 = (h^2 + k^2) / 32
//! in the middle, as the cubic with these tangents does, and a triangle between three such has
//! (b1^2 + b2^2 + b3^2 + b1 b2 + b2 b3 + b3 b1) / 6, in units of 1 / 140 of the rim's length; of
//! that the mean over the triangles. Both terms stay what they are where the rim is refined. Strips
//! are chosen in the same way; of the weights tried, the triangulations that are least by this one
//! were nearest to what had been cut out of closed meshes (`make bench ONLY=fill/truth`).
//!
//! The other weights are those of the sources.

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
    pub(super) across: Vec<DVec3>,
    /// The unit normal of the old surface at each point; 0 if it has none.
    pub(super) normals: Vec<DVec3>,
    /// One over the unit of bulges.
    per_unit: f64,
}

impl Polygon {
    pub(super) fn new(points: Vec<DVec3>, across: Vec<DVec3>, normals: Vec<DVec3>) -> Self {
        let mut polygon = Polygon { points, across, normals, per_unit: 0.0 };
        let length = polygon.length();
        polygon.per_unit = if length > 0.0 { BULGES / length } else { 0.0 };
        polygon
    }

    pub(super) fn length(&self) -> f64 {
        self.points.iter().zip(self.points.iter().cycle().skip(1)).map(|(p, q)| p.distance(*q)).sum()
    }

    /// Thinned until it has at most so many points.
    pub(super) fn of_few(&self, most: usize) -> Result<Polygon> {
        let of = |points: &[DVec3]| alloc::copied(points);
        let (points, across, normals) = (of(&self.points)?, of(&self.across)?, of(&self.normals)?);
        let mut few = Polygon { points, across, normals, per_unit: self.per_unit };
        while few.points.len() > most {
            few = few.coarser()?.0;
        }
        Ok(few)
    }

    /// Every other point, and the last one; of each which it was here.
    pub(super) fn coarser(&self) -> Result<(Polygon, Vec<u32>)> {
        let n = self.points.len();
        let mut kept = alloc::collect((0..n.div_ceil(2)).map(|i| 2 * i as u32))?;
        if n.is_multiple_of(2) {
            alloc::push(&mut kept, n as u32 - 1)?;
        }
        let at = |of: &[DVec3]| alloc::collect(kept.iter().map(|&i| of[i as usize]));
        let across = alloc::collect((0..kept.len()).map(|i| {
            let edges = kept[i] as usize..kept.get(i + 1).map_or(n, |&end| end as usize);
            let weighted = |e: usize| self.across[e] * self.points[e].distance(self.points[(e + 1) % n]);
            edges.map(weighted).sum::<DVec3>().normalize_or_zero()
        }))?;
        let (points, normals) = (at(&self.points)?, at(&self.normals)?);
        Ok((Polygon { points, across, normals, per_unit: self.per_unit }, kept))
    }
}

/// What a triangulation costs; less is better, item by item.
#[derive(Clone, Copy)]
pub(super) struct Cost {
    /// Triangles without area.
    degenerate: u32,
    /// The largest bend across an edge, 1 - cosine in steps of 2^-20, so that rounding does not
    /// decide before the value.
    bend: u32,
    /// The area, with what bends add to it, or the sum of bends and bulges.
    value: f64,
    /// The squares of the sides of the triangles: chooses among flat triangulations.
    sides: f64,
}

impl Cost {
    pub(super) const ZERO: Cost = Cost { degenerate: 0, bend: 0, value: 0.0, sides: 0.0 };

    pub(super) fn and(self, other: Cost) -> Cost {
        Cost {
            degenerate: self.degenerate + other.degenerate,
            bend: self.bend.max(other.bend),
            value: self.value + other.value,
            sides: self.sides + other.sides,
        }
    }

    /// So many times as dear.
    pub(super) fn loosened(self, times: f64) -> Cost {
        let bend = (f64::from(self.bend) * times).ceil() as u32;
        Cost { bend, value: self.value * times, sides: self.sides * times, ..self }
    }

    #[cfg(test)]
    pub(super) fn value(&self) -> f64 {
        self.value
    }

    /// By what part of it the value is less; all of it where less is degenerate or bends.
    pub(super) fn gain_over(&self, other: &Cost) -> f64 {
        match (self.degenerate, self.bend).cmp(&(other.degenerate, other.bend)) {
            Ordering::Less => 1.0,
            Ordering::Greater => 0.0,
            Ordering::Equal => (other.value - self.value) / other.value.max(f64::MIN_POSITIVE),
        }
    }
}

/// A rim is so many units of bulges long: then a surface that was this far from a triangulation
/// everywhere costs as much as an edge that bends by 60 degrees.
const BULGES: f64 = 140.0;
/// Areas that differ by this part of the squared size of the loop are equal.
const AREA_ROUNDING: f64 = 1e-14;
/// Sums of angles that differ by less are equal: bends of 0 come out as the root of round-off.
const ANGLE_ROUNDING: f64 = 1e-6;
/// A triangle whose doubled area is this part of its sides' squares has none.
const FLAT: f64 = 1e-10;
/// A side that is this part of another one has no length.
const CLOSED: f64 = 1e-10;
const STEPS: f64 = (1 << 20) as f64;

/// What costs of the same loops have in common.
#[derive(Clone, Copy)]
pub(super) struct Measure {
    /// The square of how far the loops reach from their first point.
    size: f64,
    /// One over the unit of bulges.
    per_unit: f64,
    /// The number of triangles of any triangulation.
    triangles: f64,
}

impl Measure {
    /// Of loops with so many triangles.
    pub(super) fn of<'a>(loops: impl Iterator<Item = &'a [DVec3]> + Clone, triangles: usize) -> Measure {
        let first = loops.clone().flatten().next().copied().unwrap_or_default();
        let size = loops.clone().flatten().map(|p| p.distance_squared(first)).fold(0.0, f64::max);
        let sides = loops.flat_map(|points| points.iter().zip(points.iter().cycle().skip(1)));
        let length: f64 = sides.map(|(p, q)| p.distance(*q)).sum();
        let per_unit = if length > 0.0 { BULGES / length } else { 0.0 };
        Measure { size, per_unit, triangles: triangles.max(1) as f64 }
    }

    /// This one, of thinned loops, in the unit of all.
    pub(super) fn in_unit_of(self, all: Measure) -> Measure {
        Measure { per_unit: all.per_unit, ..self }
    }
}

/// How the triangulations of one polygon are weighed.
pub(super) struct Scale<'a> {
    polygon: &'a Polygon,
    /// True of the places whose edge to the next one is a bridge and no part of a rim; none are if
    /// it is empty.
    bridges: &'a [bool],
    weight: Weight,
    /// Values that differ by less are equal.
    rounding: f64,
    measure: Measure,
}

impl<'a> Scale<'a> {
    pub(super) fn new(polygon: &'a Polygon, weight: Weight) -> Self {
        let points = &polygon.points;
        let size = points.iter().map(|p| p.distance_squared(points[0])).fold(0.0, f64::max);
        let triangles = points.len().saturating_sub(2).max(1) as f64;
        Scale::opened(polygon, weight, Measure { size, per_unit: polygon.per_unit, triangles }, &[])
    }

    /// Of loops cut open along bridges to one polygon.
    pub(super) fn opened(polygon: &'a Polygon, weight: Weight, measure: Measure, bridges: &'a [bool]) -> Self {
        let rounding = if weight == Weight::Continuation { ANGLE_ROUNDING } else { AREA_ROUNDING * measure.size };
        Scale { polygon, bridges, weight, rounding, measure }
    }

    pub(super) fn polygon(&self) -> &'a Polygon {
        self.polygon
    }

    pub(super) fn is_less(&self, a: &Cost, b: &Cost) -> bool {
        match (a.degenerate, a.bend).cmp(&(b.degenerate, b.bend)) {
            Ordering::Less => true,
            Ordering::Greater => false,
            Ordering::Equal if (a.value - b.value).abs() > self.rounding => a.value < b.value,
            Ordering::Equal => a.sides < b.sides,
        }
    }

    /// How far the surface is likely to have been from the middle of the chord (i, k), in the
    /// unit of bulges; 0 along the rim.
    pub(super) fn bulge(&self, i: usize, k: usize) -> f64 {
        let is_rim = |edge: usize| !self.bridges.get(edge).is_some_and(|&is_bridge| is_bridge);
        if k == i + 1 && is_rim(i) || k - i + 1 == self.polygon.points.len() && is_rim(k) {
            return 0.0;
        }
        self.bulge_of([i, k])
    }

    /// The same of any two vertices that have a chord.
    pub(super) fn bulge_of(&self, [i, k]: [usize; 2]) -> f64 {
        let Polygon { points, normals, .. } = self.polygon;
        if self.weight != Weight::Continuation {
            return 0.0;
        }
        let chord = (points[k] - points[i]) * self.measure.per_unit;
        let [h, g] = [i, k].map(|end| chord.dot(normals[end]));
        ((h * h + g * g) / 32.0).sqrt()
    }

    /// Where two vertices of a triangle (i, m, k) lie at one place, so that it is no more than a seam
    /// between two sides that coincide: what closing the seam costs, and the normal beyond the seam,
    /// which the side (i, k) has if it is one of the two. `None` of other triangles, and where there
    /// are several loops.
    ///
    /// `normals`: beyond (i, m) and (m, k). Without this a slit whose sides coincide would be closed by
    /// pairs of triangles that lie back to back, since triangles without area are the last choice.
    pub(super) fn seam(&self, [i, m, k]: [usize; 3], [left, right]: [DVec3; 2]) -> Option<(DVec3, Cost)> {
        let squared = |a: usize, b: usize| self.polygon.points[a].distance_squared(self.polygon.points[b]);
        let [first, second, third] = [squared(i, m), squared(m, k), squared(k, i)];
        let none = CLOSED * CLOSED * (first + second + third);
        if !self.bridges.is_empty() {
            None
        } else if third <= none {
            Some((DVec3::ZERO, self.bend([i, m], left, right)))
        } else if first <= none {
            Some((right, Cost::ZERO))
        } else if second <= none {
            Some((left, Cost::ZERO))
        } else {
            None
        }
    }

    /// The unit normal of a triangle, 0 if it has no area, and what it costs by itself. `bulges`: of
    /// its three sides.
    pub(super) fn triangle(&self, corners: [usize; 3], bulges: [f64; 3]) -> (DVec3, Cost) {
        let [p, q, r] = corners.map(|k| self.polygon.points[k]);
        let cross = (q - p).cross(r - p);
        let double_area = cross.length();
        let sides = p.distance_squared(q) + q.distance_squared(r) + r.distance_squared(p);
        let flat = double_area <= FLAT * sides;
        let normal = if flat { DVec3::ZERO } else { cross / double_area };
        // A seam between two sides that coincide is nothing bad, see `seam`.
        let shortest = p.distance_squared(q).min(q.distance_squared(r)).min(r.distance_squared(p));
        let flat = flat && shortest > CLOSED * CLOSED * sides;
        let [x, y, z] = bulges;
        let value = match self.weight {
            Weight::Continuation => (x * x + y * y + z * z + x * y + y * z + z * x) / (6.0 * self.measure.triangles),
            Weight::AreaAndBend | Weight::BendThenArea | Weight::Area => 0.5 * double_area,
        };
        (normal, Cost { degenerate: u32::from(flat), bend: 0, value, sides })
    }

    /// What the bend across the chord (i, k) between two unit normals costs; nothing if one is not
    /// known.
    pub(super) fn bend(&self, [i, k]: [usize; 2], a: DVec3, b: DVec3) -> Cost {
        let mut cost = Cost::ZERO;
        if a == DVec3::ZERO || b == DVec3::ZERO {
            return cost;
        }
        let bend = (1.0 - a.dot(b)).max(0.0);
        match self.weight {
            Weight::Area => {}
            // 2 sin(t / 2) = sqrt(2 (1 - cos t)).
            Weight::Continuation => cost.value = (2.0 * bend).sqrt(),
            Weight::BendThenArea => cost.bend = (STEPS * bend).round() as u32,
            Weight::AreaAndBend => {
                cost.value = bend * self.polygon.points[i].distance_squared(self.polygon.points[k]);
            }
        }
        cost
    }
}
