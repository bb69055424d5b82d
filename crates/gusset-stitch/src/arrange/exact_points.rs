//! Points with exact homogeneous coordinates, and planes.
//!
//! Coordinates are in units of a grid, so that given points are triples of integers. A constructed
//! point (X, Y, Z) / W has wide integers and W > 0. Each point also has its coordinates rounded to
//! nearest, which decide most comparisons. Equal points have equal rounded coordinates.

use super::wide_int::{WideInt, WideVec, cross, difference, dot, rounded_quotient};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use robust::{Coord, Coord3D, orient2d, orient3d};
use std::cmp::Ordering;

/// The axes of a projection along each axis. The third axis points at the viewer.
const PROJECTIONS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// Returns the sign of a determinant.
pub(super) fn sign(x: f64) -> i32 {
    i32::from(x > 0.0) - i32::from(x < 0.0)
}

/// Returns the side of the plane abc on which d lies: 1 where abc is counter-clockwise.
pub(super) fn side_of_plane([a, b, c]: [DVec3; 3], d: DVec3) -> i32 {
    let at = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    -sign(orient3d(at(a), at(b), at(c), at(d)))
}

/// Returns 1 if abc is counter-clockwise seen along an axis from its positive end.
pub(super) fn orientation_along(axis: usize, a: DVec3, b: DVec3, c: DVec3) -> i32 {
    let (x, y) = PROJECTIONS[axis];
    let at = |v: DVec3| Coord { x: v[x], y: v[y] };
    sign(orient2d(at(a), at(b), at(c)))
}

/// The plane of points p with `normal` · p = `offset`.
pub(super) struct Plane {
    pub(super) normal: WideVec,
    offset: WideInt,
}

fn integers(p: DVec3) -> WideVec {
    p.to_array().map(WideInt::from_integral)
}

impl Plane {
    /// Returns the plane of a triangle, with its normal (b - a) x (c - a).
    pub(super) fn from_triangle(corners: [DVec3; 3]) -> Plane {
        let [a, b, c] = corners.map(integers);
        let normal = cross(&difference(&b, &a), &difference(&c, &a));
        let offset = dot(&normal, &a);
        Plane { normal, offset }
    }

    /// Returns the plane of an edge and an axis.
    pub(super) fn from_edge([p, q]: [DVec3; 2], axis: usize) -> Plane {
        let [p, q] = [p, q].map(integers);
        let mut along = [WideInt::ZERO; 3];
        along[axis] = WideInt::from_integral(1.0);
        let normal = cross(&difference(&q, &p), &along);
        let offset = dot(&normal, &p);
        Plane { normal, offset }
    }

    /// Returns the point in which the line pq meets the plane. They are not parallel.
    pub(super) fn meet_line(&self, [p, q]: [DVec3; 2]) -> [WideInt; 4] {
        let [p, q] = [p, q].map(integers);
        let along = difference(&q, &p);
        let share = self.offset.minus(&dot(&self.normal, &p));
        let weight = dot(&self.normal, &along);
        let at = |k: usize| p[k].times(&weight).plus(&along[k].times(&share));
        [at(0), at(1), at(2), weight]
    }

    /// Returns the common point of three planes in general position.
    pub(super) fn meet_planes(&self, second: &Plane, third: &Plane) -> [WideInt; 4] {
        let a = cross(&second.normal, &third.normal);
        let b = cross(&third.normal, &self.normal);
        let c = cross(&self.normal, &second.normal);
        let at = |k: usize| self.offset.times(&a[k]).plus(&second.offset.times(&b[k])).plus(&third.offset.times(&c[k]));
        [at(0), at(1), at(2), dot(&self.normal, &a)]
    }
}

/// The place of a point's integers.
#[derive(Clone, Copy, Default)]
struct LimbRange {
    first_limb: usize,
    /// The number of limbs of each coordinate, negative for a negative coordinate. All are 0 for a
    /// point whose rounded coordinates are exact integers.
    limb_counts: [i8; 4],
}

impl LimbRange {
    fn is_integral(&self) -> bool {
        self.limb_counts[3] == 0
    }
}

/// Points with numbers from `first_number` on, which continue a base.
pub(super) struct ExactPoints<'a> {
    base: Option<&'a ExactPoints<'a>>,
    first_number: u32,
    rounded: Vec<DVec3>,
    limb_ranges: Vec<LimbRange>,
    limbs: Vec<u64>,
}

impl<'a> ExactPoints<'a> {
    /// Takes points with integral coordinates.
    pub(super) fn from_integral(points: Vec<DVec3>) -> Result<Self> {
        let places = alloc::filled(LimbRange::default(), points.len())?;
        Ok(ExactPoints { base: None, first_number: 0, rounded: points, limb_ranges: places, limbs: Vec::new() })
    }

    /// Creates an empty set whose numbers continue a base.
    pub(super) fn extending(base: &'a ExactPoints<'a>) -> ExactPoints<'a> {
        ExactPoints {
            base: Some(base),
            first_number: base.end(),
            rounded: Vec::new(),
            limb_ranges: Vec::new(),
            limbs: Vec::new(),
        }
    }

    /// Returns the number after the last.
    pub(super) fn end(&self) -> u32 {
        self.first_number + self.rounded.len() as u32
    }

    /// Separates the own points from the base.
    pub(super) fn into_own(self) -> ExactPoints<'static> {
        ExactPoints { base: None, ..self }
    }

    /// Appends all own points of another set, in order.
    pub(super) fn append(&mut self, other: &ExactPoints<'_>) -> Result<()> {
        let start = self.limbs.len();
        alloc::append(&mut self.rounded, &other.rounded)?;
        alloc::extend(
            &mut self.limb_ranges,
            other.limb_ranges.iter().map(|place| LimbRange { first_limb: place.first_limb + start, ..*place }),
        )?;
        alloc::append(&mut self.limbs, &other.limbs)
    }

    /// Appends a point with integral coordinates.
    pub(super) fn push_integral(&mut self, point: DVec3) -> Result<u32> {
        alloc::push(&mut self.rounded, point)?;
        alloc::push(&mut self.limb_ranges, LimbRange::default())?;
        Ok(self.end() - 1)
    }

    /// Appends a point with homogeneous coordinates, the last of which is not 0.
    pub(super) fn push(&mut self, point: &[WideInt; 4]) -> Result<u32> {
        let turn = point[3].is_negative();
        let is_negative = |x: &WideInt| x.is_negative() != turn;
        let mut place = LimbRange { first_limb: self.limbs.len(), limb_counts: [0; 4] };
        let mut rounded = [0.0; 3];
        for (k, x) in point.iter().enumerate() {
            let count = x.limbs().len() as i8;
            place.limb_counts[k] = if is_negative(x) { -count } else { count };
            alloc::append(&mut self.limbs, x.limbs())?;
            if let Some(rounded) = rounded.get_mut(k) {
                let size = rounded_quotient(x, &point[3]);
                *rounded = if x.sign() != 0 && is_negative(x) { -size } else { size };
            }
        }
        alloc::push(&mut self.rounded, DVec3::from_array(rounded))?;
        alloc::push(&mut self.limb_ranges, place)?;
        Ok(self.end() - 1)
    }

    fn owner(&self, i: u32) -> (&ExactPoints<'a>, usize) {
        match self.base {
            Some(base) if i < self.first_number => (base, i as usize),
            _ => (self, (i - self.first_number) as usize),
        }
    }

    /// Returns the rounded coordinates of a point.
    pub(super) fn rounded(&self, i: u32) -> DVec3 {
        let (set, k) = self.owner(i);
        set.rounded[k]
    }

    fn is_integral(&self, i: u32) -> bool {
        let (set, k) = self.owner(i);
        set.limb_ranges[k].is_integral()
    }

    /// Returns the homogeneous coordinates of a point.
    fn homogeneous(&self, i: u32) -> [WideInt; 4] {
        let (set, k) = self.owner(i);
        let place = set.limb_ranges[k];
        if place.is_integral() {
            let [x, y, z] = integers(set.rounded[k]);
            return [x, y, z, WideInt::from_integral(1.0)];
        }
        let mut start = place.first_limb;
        place.limb_counts.map(|count| {
            let end = start + usize::from(count.unsigned_abs());
            let made = WideInt::from_limbs(&set.limbs[start..end], count < 0);
            start = end;
            made
        })
    }

    /// Returns the midpoint of two points.
    pub(super) fn midpoint(&self, i: u32, j: u32) -> [WideInt; 4] {
        let (p, q) = (self.homogeneous(i), self.homogeneous(j));
        let at = |k: usize| p[k].times(&q[3]).plus(&q[k].times(&p[3]));
        let weight = p[3].times(&q[3]);
        [at(0), at(1), at(2), weight.plus(&weight)]
    }

    /// Returns the side of a plane on which a point lies: 1 where the normal points.
    pub(super) fn side_of(&self, plane: &Plane, i: u32) -> i32 {
        let [x, y, z, weight] = self.homogeneous(i);
        dot(&plane.normal, &[x, y, z]).minus(&plane.offset.times(&weight)).sign()
    }

    /// Compares a coordinate of two points.
    pub(super) fn compare_along(&self, k: usize, i: u32, j: u32) -> Ordering {
        let (x, y) = (self.rounded(i)[k], self.rounded(j)[k]);
        if x != y || i == j || (self.is_integral(i) && self.is_integral(j)) {
            return x.partial_cmp(&y).unwrap_or(Ordering::Equal);
        }
        let (p, q) = (self.homogeneous(i), self.homogeneous(j));
        p[k].times(&q[3]).compare(&q[k].times(&p[3]))
    }

    /// Compares two points by x, then y, then z.
    pub(super) fn compare(&self, i: u32, j: u32) -> Ordering {
        self.compare_along(0, i, j).then_with(|| self.compare_along(1, i, j)).then_with(|| self.compare_along(2, i, j))
    }

    /// Returns 1 if the points are counter-clockwise seen along an axis from its positive end, and 0
    /// if their projections are collinear.
    pub(super) fn orientation(&self, axis: usize, [i, j, k]: [u32; 3]) -> i32 {
        let [a, b, c] = [i, j, k].map(|v| self.rounded(v));
        if [i, j, k].iter().all(|&v| self.is_integral(v)) {
            return orientation_along(axis, a, b, c);
        }
        let (x, y) = PROJECTIONS[axis];
        let (bx, by, cx, cy) = (b[x] - a[x], b[y] - a[y], c[x] - a[x], c[y] - a[y]);
        // Bounds of the errors of the coordinates, and of the determinant with room to spare.
        let unit = 0.5 * f64::EPSILON;
        let error_x = unit * a[x].abs().max(b[x].abs()).max(c[x].abs());
        let error_y = unit * a[y].abs().max(b[y].abs()).max(c[y].abs());
        let (reach_x, reach_y) = (bx.abs() + cx.abs() + error_x, by.abs() + cy.abs() + error_y);
        let bound = 8.0 * (reach_x * error_y + reach_y * error_x + unit * reach_x * reach_y);
        let determinant = bx * cy - by * cx;
        if determinant.abs() > bound {
            return sign(determinant);
        }
        let [p, q, r] = [i, j, k].map(|v| self.homogeneous(v));
        let minor = |p: &[WideInt; 4], q: &[WideInt; 4]| p[x].times(&q[y]).minus(&q[x].times(&p[y]));
        let part = |weight: &WideInt, minor: WideInt| weight.times(&minor);
        part(&p[3], minor(&q, &r)).plus(&part(&q[3], minor(&r, &p))).plus(&part(&r[3], minor(&p, &q))).sign()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(p: [i32; 3]) -> DVec3 {
        DVec3::from_array(p.map(f64::from))
    }

    proptest! {
        /// The line and two planes through a lattice point meet there; the constructed points equal
        /// the given one, and are oriented like it.
        #[test]
        fn constructed_points_equal_given_ones(
            corners in prop::array::uniform7(prop::array::uniform3(-9i32..10)),
        ) {
            let p = corners.map(point);
            let planes = [[0, 1, 2], [0, 3, 4], [0, 5, 6]].map(|t| Plane::from_triangle(t.map(|k| p[k])));
            let made = planes[0].meet_planes(&planes[1], &planes[2]);
            prop_assume!(made[3].sign() != 0);
            let mut points = ExactPoints::from_integral(p.to_vec()).unwrap();
            let by_planes = points.push(&made).unwrap();
            prop_assert_eq!(points.compare(0, by_planes), Ordering::Equal);
            prop_assert_eq!(points.rounded(by_planes), p[0]);
            let on_line = planes[0].meet_line([p[0], p[5]]);
            prop_assume!(on_line[3].sign() != 0);
            let on_line = points.push(&on_line).unwrap();
            prop_assert_eq!(points.compare(on_line, by_planes), Ordering::Equal);
            for axis in 0..3 {
                for (j, k) in [(1, 2), (3, 5), (4, 6)] {
                    let expected = orientation_along(axis, p[0], p[j], p[k]);
                    prop_assert_eq!(points.orientation(axis, [by_planes, j as u32, k as u32]), expected);
                    prop_assert_eq!(points.orientation(axis, [j as u32, k as u32, on_line]), expected);
                }
            }
        }

        /// Orders points of a line by their parameters, also where doubles cannot tell them apart.
        #[test]
        fn points_of_a_line_are_ordered(a in 1i64..1 << 40, b in 1i64..1 << 40, step in 1i64..5) {
            let line = [DVec3::ZERO, DVec3::new(3.0, 1.0, 7.0)];
            let mut points = ExactPoints::from_integral(Vec::new()).unwrap();
            let at = |offset: i64, scale: i64| {
                // The plane scale x = 3 offset.
                let normal = [scale, 0, 0].map(|x| WideInt::from_integral(x as f64));
                Plane { normal, offset: WideInt::from_integral(3.0 * offset as f64) }.meet_line(line)
            };
            let (i, j) = (points.push(&at(a, b)).unwrap(), points.push(&at(a + step, b)).unwrap());
            let same = points.push(&at(2 * a, 2 * b)).unwrap();
            prop_assert_eq!(points.compare(i, j), Ordering::Less);
            prop_assert_eq!(points.compare(same, i), Ordering::Equal);
            prop_assert_eq!(points.orientation(0, [i, j, same]), 0);
        }
    }

    #[test]
    fn sides_follow_the_right_hand() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        assert_eq!(side_of_plane(triangle, DVec3::Z), 1);
        assert_eq!(orientation_along(2, DVec3::ZERO, DVec3::X, DVec3::Y), 1);
        assert_eq!(Plane::from_triangle(triangle).normal[2].sign(), 1);
    }
}
