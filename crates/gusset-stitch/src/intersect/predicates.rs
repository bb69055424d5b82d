//! Exact intersection test of two triangles. Products of four coordinates must not overflow or
//! vanish.
//!
//! A shared vertex or edge does not count, whether it has one number or two coincident copies, as
//! along unwelded seams. Any other common point counts, so touching is an intersection. The signs
//! of all determinants are exact, and so is the result.

use glam::DVec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// Returns six times the signed volume of the tetrahedron. Its sign tells the side of the plane pqr
/// on which s lies.
fn six_fold_signed_volume(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> f64 {
    let at = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    orient3d(at(p), at(q), at(r), at(s))
}

/// A projection along one axis.
#[derive(Clone, Copy)]
struct AxisProjection(usize);

impl AxisProjection {
    /// Returns the axis that becomes the second axis of the projection.
    fn second_axis(self) -> usize {
        (self.0 + 2) % 3
    }

    fn projected_double_area(self, p: DVec3, q: DVec3, r: DVec3) -> f64 {
        let (x, y) = [(1, 2), (2, 0), (0, 1)][self.0];
        let at = |v: DVec3| Coord { x: v[x], y: v[y] };
        orient2d(at(p), at(q), at(r))
    }

    /// Returns true if the segments pq and rs meet in the projection.
    fn segments_meet(self, p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> bool {
        let (to_r, to_s) = (self.projected_double_area(p, q, r), self.projected_double_area(p, q, s));
        let (to_p, to_q) = (self.projected_double_area(r, s, p), self.projected_double_area(r, s, q));
        if [to_r, to_s, to_p, to_q] == [0.0; 4] {
            // Collinear segments meet if their boxes overlap.
            return (0..3)
                .filter(|&k| k != self.0)
                .all(|k| p[k].max(q[k]) >= r[k].min(s[k]) && r[k].max(s[k]) >= p[k].min(q[k]));
        }
        !have_same_sign(to_r, to_s) && !have_same_sign(to_p, to_q)
    }

    /// Returns true if the segment pq meets the triangle in the projection.
    fn segment_meets(self, p: DVec3, q: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
        let inside = [
            self.projected_double_area(a, b, p),
            self.projected_double_area(b, c, p),
            self.projected_double_area(c, a, p),
        ];
        are_all_on_one_side(inside) || [(a, b), (b, c), (c, a)].iter().any(|&(r, s)| self.segments_meet(p, q, r, s))
    }
}

fn have_same_sign(x: f64, y: f64) -> bool {
    (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0)
}

fn are_all_on_one_side(signs: [f64; 3]) -> bool {
    signs.iter().all(|&s| s >= 0.0) || signs.iter().all(|&s| s <= 0.0)
}

/// Returns a projection in which the triangle has a positive area; `None` for a degenerate
/// triangle.
fn non_degenerate_projection([a, b, c]: [DVec3; 3]) -> Option<AxisProjection> {
    (0..3).map(AxisProjection).find(|along| along.projected_double_area(a, b, c) != 0.0)
}

/// Returns true if the corners of a triangle lie on one line.
pub(crate) fn are_collinear(triangle: [DVec3; 3]) -> bool {
    non_degenerate_projection(triangle).is_none()
}

/// Returns true if the closed segment pq meets the closed triangle.
fn segment_meets(p: DVec3, q: DVec3, triangle: [DVec3; 3]) -> bool {
    let [a, b, c] = triangle;
    let (to_p, to_q) = (six_fold_signed_volume(a, b, c, p), six_fold_signed_volume(a, b, c, q));
    if have_same_sign(to_p, to_q) {
        return false;
    }
    if to_p != 0.0 || to_q != 0.0 {
        // The segment meets the plane in one point. The point is inside if pq turns the same way
        // around all three edges.
        return are_all_on_one_side([
            six_fold_signed_volume(p, q, a, b),
            six_fold_signed_volume(p, q, b, c),
            six_fold_signed_volume(p, q, c, a),
        ]);
    }
    match non_degenerate_projection(triangle) {
        Some(along) => along.segment_meets(p, q, triangle),
        // A degenerate triangle consists of its three edges.
        None => [(a, b), (b, c), (c, a)].iter().any(|&(r, s)| segments_meet(p, q, r, s)),
    }
}

fn segments_meet(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> bool {
    // The segments are coplanar and meet in every projection.
    six_fold_signed_volume(p, q, r, s) == 0.0 && (0..3).all(|k| AxisProjection(k).segments_meet(p, q, r, s))
}

/// Returns true if p lies on the closed segment rs.
fn is_on_segment(p: DVec3, r: DVec3, s: DVec3) -> bool {
    segments_meet(p, p, r, s)
}

/// Returns true if p lies on the closed triangle.
pub(crate) fn is_on_triangle(p: DVec3, triangle: [DVec3; 3]) -> bool {
    segment_meets(p, p, triangle)
}

/// Returns true if a ray from p in the positive direction of an axis meets the triangle. The ray is
/// moved sideways by an infinitesimal, so it never meets an edge. p must not lie on the triangle.
pub(crate) fn ray_meets_triangle(p: DVec3, axis: usize, [a, b, c]: [DVec3; 3]) -> bool {
    let along = AxisProjection(axis);
    let up = along.second_axis();
    let has_on_left = |r: DVec3, s: DVec3| {
        let [low, high] = if r[up] <= s[up] { [r, s] } else { [s, r] };
        low[up] <= p[up] && p[up] < high[up] && along.projected_double_area(low, high, p) > 0.0
    };
    let is_inside = has_on_left(a, b) ^ has_on_left(b, c) ^ has_on_left(c, a);
    is_inside && have_same_sign(along.projected_double_area(a, b, c), six_fold_signed_volume(a, b, c, p))
}

/// Returns true if the triangles with vertices `v` and `w` intersect.
pub(super) fn triangles_intersect(v: [u32; 3], w: [u32; 3], at: impl Fn(u32) -> DVec3) -> bool {
    // Vertices with equal numbers coincide, and most pairs are decided by the numbers alone.
    unified_triangles_intersect(v, w, &at) && {
        let (same_v, same_w) = unify_coincident_vertices(v, w, &at);
        (same_v, same_w) == (v, w) || unified_triangles_intersect(same_v, same_w, &at)
    }
}

/// Replaces each vertex by the first vertex at its position.
fn unify_coincident_vertices(v: [u32; 3], w: [u32; 3], at: impl Fn(u32) -> DVec3) -> ([u32; 3], [u32; 3]) {
    let first = |x: u32| v.into_iter().chain(w).find(|&y| at(x) == at(y)).unwrap_or(x);
    (v.map(first), w.map(first))
}

/// Tests triangles whose coincident vertices have equal numbers. A triangle with a repeated vertex
/// is a segment or a point.
fn unified_triangles_intersect(v: [u32; 3], w: [u32; 3], at: impl Fn(u32) -> DVec3) -> bool {
    let (p, q) = (v.map(&at), w.map(&at));
    // The plane of one triangle separates most nearby pairs.
    let apart = |t: [DVec3; 3], from: [u32; 3], others: [u32; 3]| {
        let side = |k: usize| {
            if from.contains(&others[k]) { None } else { Some(six_fold_signed_volume(t[0], t[1], t[2], at(others[k]))) }
        };
        let mut sides = (0..3).filter_map(side);
        sides.next().is_none_or(|first| first != 0.0 && sides.all(|s| have_same_sign(s, first)))
    };
    let shared = || v.into_iter().enumerate().filter(|&(k, x)| w.contains(&x) && !v[..k].contains(&x));
    let count = shared().count();
    if count < 2 && (apart(p, v, w) || apart(q, w, v)) {
        return false;
    }
    // The corners of one triangle that the other lacks.
    let rest = |t: [u32; 3], other: [u32; 3]| {
        let mut own = t.into_iter().filter(move |x| !other.contains(x)).map(&at);
        own.next().map(|first| (first, own.next().unwrap_or(first)))
    };
    match count {
        0 => {
            let edge = |t: [DVec3; 3], k: usize| (t[k], t[(k + 1) % 3]);
            (0..3).any(|k| segment_meets(edge(p, k).0, edge(p, k).1, q))
                || (0..3).any(|k| segment_meets(edge(q, k).0, edge(q, k).1, p))
        }
        // Any other common point reaches the side opposite to the shared vertex in one of the
        // triangles. If a degenerate triangle has the shared vertex on its opposite side, test the
        // ends of that side.
        1 => shared().any(|(_, x)| {
            let reaches = |rest: Option<(DVec3, DVec3)>, other: [DVec3; 3]| match rest {
                Some((a, b)) if is_on_segment(at(x), a, b) => segment_meets(a, a, other) || segment_meets(b, b, other),
                Some((a, b)) => segment_meets(a, b, other),
                None => false,
            };
            reaches(rest(v, w), q) || reaches(rest(w, v), p)
        }),
        2 => {
            let mut ends = shared().map(|(_, x)| at(x));
            let (Some(e), Some(f), Some((a, _)), Some((b, _))) = (ends.next(), ends.next(), rest(v, w), rest(w, v))
            else {
                // One of them is contained in the shared edge.
                return false;
            };
            // Folded onto each other: coplanar, and on the same side of the edge.
            let same_side_of_edge = |along: AxisProjection| {
                have_same_sign(along.projected_double_area(e, f, a), along.projected_double_area(e, f, b))
            };
            // Collinear: beyond the same end of the edge.
            let beyond_same_end = || {
                non_degenerate_projection(q).is_none()
                    && ![a, b].iter().any(|&x| is_on_segment(x, e, f))
                    && ![e, f].iter().any(|&x| is_on_segment(x, a, b))
            };
            six_fold_signed_volume(e, f, a, b) == 0.0
                && non_degenerate_projection(p).map_or_else(beyond_same_end, same_side_of_edge)
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Computes an independent answer in integers. The common points are the solutions (s, t, u, v)
    /// of p(s, t) = q(u, v) with 0 <= s, t, s + t <= 1 and likewise u, v. They form a polytope. Its
    /// corners are the points at which four independent rows are 0. Returns each corner as
    /// homogeneous coordinates (x, y, z, w), w > 0.
    fn corners_of_common_points(p: [[i64; 3]; 3], q: [[i64; 3]; 3]) -> Vec<[i128; 4]> {
        let edge = |t: [[i64; 3]; 3], corner: usize, k: usize| i128::from(t[corner][k] - t[0][k]);
        // Rows: coefficients of s, t, u, v and a constant. The first three must be 0, and the other
        // six non-negative.
        let mut rows: Vec<[i128; 5]> = (0..3)
            .map(|k| [edge(p, 1, k), edge(p, 2, k), -edge(q, 1, k), -edge(q, 2, k), i128::from(p[0][k] - q[0][k])])
            .collect();
        rows.extend([[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [-1, -1, 0, 0, 1]]);
        rows.extend([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, -1, -1, 1]]);
        let corner = |set: u32| {
            let active: Vec<_> = (0..9).filter(|k| set >> k & 1 == 1).map(|k| rows[k]).collect();
            // Cramer's rule without division.
            let minor = |column: usize| {
                let at = |r: usize, c: usize| if c == column { -active[r][4] } else { active[r][c] };
                determinant(std::array::from_fn(|r| std::array::from_fn(|c| at(r, c))))
            };
            let sign = minor(4).signum();
            let [s, t, u, v, whole] = [0, 1, 2, 3, 4].map(|column| sign * minor(column));
            let value = |row: &[i128; 5]| row[0] * s + row[1] * t + row[2] * u + row[3] * v + row[4] * whole;
            let place = |k: usize| i128::from(p[0][k]) * whole + edge(p, 1, k) * s + edge(p, 2, k) * t;
            let is_corner = whole != 0
                && rows[..3].iter().all(|row| value(row) == 0)
                && rows[3..].iter().all(|row| value(row) >= 0);
            is_corner.then(|| [place(0), place(1), place(2), whole])
        };
        (0..1u32 << 9).filter(|set| set.count_ones() == 4).filter_map(corner).collect()
    }

    /// Returns true if the triangles share points other than coincident vertices and the segments
    /// between these.
    fn intersect_beyond_shared_vertices(p: [[i64; 3]; 3], q: [[i64; 3]; 3]) -> bool {
        let mut shared = p.to_vec();
        shared.retain(|corner| q.contains(corner));
        shared.sort_unstable();
        shared.dedup();
        let is_shared = |c: &[i128; 4]| {
            let leg = |from: &[i64; 3]| [0, 1, 2].map(|k| c[k] - c[3] * i128::from(from[k]));
            match shared.as_slice() {
                [] => false,
                [only] => leg(only) == [0; 3],
                [e, f] => {
                    let (a, b) = (leg(e), leg(f));
                    let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i]);
                    cross == [0; 3] && a.iter().zip(b).map(|(a, b)| a * b).sum::<i128>() <= 0
                }
                _ => false,
            }
        };
        !corners_of_common_points(p, q).iter().all(is_shared)
    }

    fn determinant(m: [[i128; 4]; 4]) -> i128 {
        let minor = |skip: usize| {
            let c: Vec<usize> = (0..4).filter(|&k| k != skip).collect();
            let at = |r: usize, k: usize| m[r][c[k]];
            at(1, 0) * (at(2, 1) * at(3, 2) - at(2, 2) * at(3, 1))
                - at(1, 1) * (at(2, 0) * at(3, 2) - at(2, 2) * at(3, 0))
                + at(1, 2) * (at(2, 0) * at(3, 1) - at(2, 1) * at(3, 0))
        };
        m[0][0] * minor(0) - m[0][1] * minor(1) + m[0][2] * minor(2) - m[0][3] * minor(3)
    }

    proptest! {
        /// Uses a small lattice, on which touching, coplanar, coincident and degenerate triangles
        /// are common.
        #[test]
        fn intersections_equal_the_search_for_a_corner(
            p in prop::array::uniform3((-2i64..3, -2i64..3, -1i64..2)),
            q in prop::array::uniform3((-2i64..3, -2i64..3, -1i64..2)),
            same in prop::array::uniform2(0usize..6),
            times in 0usize..3,
        ) {
            let mut all = [p, q].concat();
            // Often some vertices coincide.
            for k in 0..times {
                all[3 + k] = all[same[k]];
            }
            let all: Vec<[i64; 3]> = all.into_iter().map(|(x, y, z)| [x, y, z]).collect();
            let points: Vec<DVec3> = all.iter().map(|&[x, y, z]| DVec3::new(x as f64, y as f64, z as f64)).collect();
            let (p, q) = ([all[0], all[1], all[2]], [all[3], all[4], all[5]]);
            let expected = intersect_beyond_shared_vertices(p, q);
            prop_assert_eq!(triangles_intersect([0, 1, 2], [3, 4, 5], |v| points[v as usize]), expected);
            // Test again with equal numbers for coincident vertices.
            let number = |k: usize| (0..6).find(|&j| all[j] == all[k]).unwrap_or(k) as u32;
            let by_number = triangles_intersect([0, 1, 2].map(number), [3, 4, 5].map(number), |v| points[v as usize]);
            prop_assert_eq!(by_number, expected);
        }
    }

    #[test]
    fn shared_vertices_and_edges_do_not_count() {
        let points = [
            DVec3::ZERO,
            DVec3::X,
            DVec3::Y,
            DVec3::new(1.0, 1.0, 0.0),
            DVec3::new(0.25, 0.25, 0.0),
            DVec3::new(0.25, 0.25, 1.0),
            DVec3::new(0.25, 0.25, -1.0),
            DVec3::new(-1.0, -1.0, 0.0),
        ];
        let triangles_intersect = |v, w| triangles_intersect(v, w, |k| points[k as usize]);
        assert!(!triangles_intersect([0, 1, 2], [2, 1, 3]), "side by side in a plane");
        assert!(triangles_intersect([0, 1, 2], [1, 2, 4]), "folded over in a plane");
        assert!(!triangles_intersect([0, 1, 2], [1, 2, 5]), "an edge, and up from it");
        assert!(triangles_intersect([0, 1, 2], [0, 5, 6]), "through it from a shared vertex");
        assert!(!triangles_intersect([0, 1, 2], [0, 7, 5]), "away from a shared vertex");
        assert!(triangles_intersect([0, 1, 2], [0, 3, 4]), "in one plane from a shared vertex");
        assert!(triangles_intersect([0, 1, 2], [2, 0, 1]), "the same triangle twice");
    }
}
