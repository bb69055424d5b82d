//! Exact intersection test of two triangles, for coordinates whose products of four neither
//! overflow nor vanish.
//!
//! Vertices are identified by number: a vertex or an edge that two triangles share by number is
//! no intersection. Any other common point is, so touching counts. The signs of all
//! determinants are exact, hence so is the answer.

use glam::DVec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// Six times the volume of the tetrahedron: its sign says on which side of the plane of p, q, r the
/// point s lies.
fn volume(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> f64 {
    let at = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    orient3d(at(p), at(q), at(r), at(s))
}

/// A projection along one axis.
#[derive(Clone, Copy)]
struct AxisProjection(usize);

impl AxisProjection {
    fn area(self, p: DVec3, q: DVec3, r: DVec3) -> f64 {
        let (x, y) = [(1, 2), (2, 0), (0, 1)][self.0];
        let at = |v: DVec3| Coord { x: v[x], y: v[y] };
        orient2d(at(p), at(q), at(r))
    }

    /// Do the segments pq and rs meet, seen along the axis?
    fn segments_meet(self, p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> bool {
        let (to_r, to_s) = (self.area(p, q, r), self.area(p, q, s));
        let (to_p, to_q) = (self.area(r, s, p), self.area(r, s, q));
        if [to_r, to_s, to_p, to_q] == [0.0; 4] {
            // On one line: their boxes overlap.
            return (0..3)
                .filter(|&k| k != self.0)
                .all(|k| p[k].max(q[k]) >= r[k].min(s[k]) && r[k].max(s[k]) >= p[k].min(q[k]));
        }
        !same_side(to_r, to_s) && !same_side(to_p, to_q)
    }

    /// Does segment pq meet the triangle, seen along the axis?
    fn segment_meets(self, p: DVec3, q: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
        let inside = [self.area(a, b, p), self.area(b, c, p), self.area(c, a, p)];
        all_on_one_side(inside) || [(a, b), (b, c), (c, a)].iter().any(|&(r, s)| self.segments_meet(p, q, r, s))
    }
}

fn same_side(x: f64, y: f64) -> bool {
    (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0)
}

fn all_on_one_side(signs: [f64; 3]) -> bool {
    signs.iter().all(|&s| s >= 0.0) || signs.iter().all(|&s| s <= 0.0)
}

/// A projection in which the triangle keeps an area; `None` if it has none at all.
fn projection([a, b, c]: [DVec3; 3]) -> Option<AxisProjection> {
    (0..3).map(AxisProjection).find(|along| along.area(a, b, c) != 0.0)
}

/// Does the closed segment pq meet the closed triangle?
fn segment_meets(p: DVec3, q: DVec3, triangle: [DVec3; 3]) -> bool {
    let [a, b, c] = triangle;
    let (to_p, to_q) = (volume(a, b, c, p), volume(a, b, c, q));
    if same_side(to_p, to_q) {
        return false;
    }
    if to_p != 0.0 || to_q != 0.0 {
        // It reaches the plane in one point; the lines from it round the triangle all turn the same
        // way.
        return all_on_one_side([volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)]);
    }
    match projection(triangle) {
        Some(along) => along.segment_meets(p, q, triangle),
        // A triangle without area is its three edges.
        None => [(a, b), (b, c), (c, a)].iter().any(|&(r, s)| segments_meet(p, q, r, s)),
    }
}

fn segments_meet(p: DVec3, q: DVec3, r: DVec3, s: DVec3) -> bool {
    // In one plane, and seen along every axis.
    volume(p, q, r, s) == 0.0 && (0..3).all(|k| AxisProjection(k).segments_meet(p, q, r, s))
}

/// Do the triangles with vertices `v` and `w` cut each other?
pub(super) fn triangles_intersect(v: [u32; 3], w: [u32; 3], at: impl Fn(u32) -> DVec3) -> bool {
    let shared = v.iter().filter(|x| w.contains(x)).count();
    let (p, q) = (v.map(&at), w.map(&at));
    // Most pairs that are near each other lie apart by the plane of one of them.
    let apart = |t: [DVec3; 3], from: [u32; 3], others: [u32; 3]| {
        let side =
            |k: usize| if from.contains(&others[k]) { None } else { Some(volume(t[0], t[1], t[2], at(others[k]))) };
        let mut sides = (0..3).filter_map(side);
        let first = sides.next().unwrap_or(0.0);
        sides.all(|s| same_side(s, first))
    };
    if shared < 2 && (apart(p, v, w) || apart(q, w, v)) {
        return false;
    }
    match shared {
        0 => {
            let edge = |t: [DVec3; 3], k: usize| (t[k], t[(k + 1) % 3]);
            (0..3).any(|k| segment_meets(edge(p, k).0, edge(p, k).1, q))
                || (0..3).any(|k| segment_meets(edge(q, k).0, edge(q, k).1, p))
        }
        1 => {
            // Whatever else they have in common reaches the side opposite the shared vertex of one
            // of them.
            let opposite = |t: [u32; 3], other: [u32; 3]| {
                let k = (0..3).find(|&k| other.contains(&t[k])).unwrap_or(0);
                (at(t[(k + 1) % 3]), at(t[(k + 2) % 3]))
            };
            let ((a, b), (c, d)) = (opposite(v, w), opposite(w, v));
            segment_meets(a, b, q) || segment_meets(c, d, p)
        }
        2 => {
            // Folded onto each other: in one plane, and on the same side of the edge.
            let apex = |t: [u32; 3], other: [u32; 3]| (0..3).find(|&k| !other.contains(&t[k])).unwrap_or(0);
            let (k, l) = (apex(v, w), apex(w, v));
            let (e, f) = (p[(k + 1) % 3], p[(k + 2) % 3]);
            volume(e, f, p[k], q[l]) == 0.0
                && projection(p).is_some_and(|along| same_side(along.area(e, f, p[k]), along.area(e, f, q[l])))
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// An independent answer in integers. The common points are the (s, t, u, v) with p(s, t) =
    /// q(u, v), 0 <= s, t, s + t <= 1 and the same for u, v: a polytope, which is not empty if and
    /// only if it has a corner, where four independent rows are 0.
    fn have_common_points(p: [[i64; 3]; 3], q: [[i64; 3]; 3]) -> bool {
        let edge = |t: [[i64; 3]; 3], corner: usize, k: usize| i128::from(t[corner][k] - t[0][k]);
        // Rows: coefficients of s, t, u, v and a constant; three that must be 0, and six that must
        // not be negative.
        let mut rows: Vec<[i128; 5]> = (0..3)
            .map(|k| [edge(p, 1, k), edge(p, 2, k), -edge(q, 1, k), -edge(q, 2, k), i128::from(p[0][k] - q[0][k])])
            .collect();
        rows.extend([[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [-1, -1, 0, 0, 1]]);
        rows.extend([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, -1, -1, 1]]);
        (0..1u32 << 9).filter(|set| set.count_ones() == 4).any(|set| {
            let active: Vec<_> = (0..9).filter(|k| set >> k & 1 == 1).map(|k| rows[k]).collect();
            // Cramer's rule, without division.
            let minor = |column: usize| {
                let at = |r: usize, c: usize| if c == column { -active[r][4] } else { active[r][c] };
                determinant(std::array::from_fn(|r| std::array::from_fn(|c| at(r, c))))
            };
            let whole = minor(4);
            let value = |row: &[i128; 5]| (0..4).map(|c| row[c] * minor(c)).sum::<i128>() + row[4] * whole;
            whole != 0
                && rows[..3].iter().all(|row| value(row) == 0)
                && rows[3..].iter().all(|row| value(row) * whole.signum() >= 0)
        })
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
        /// On a small lattice, where touching and lying in one plane are common.
        #[test]
        fn equals_the_search_for_a_corner(
            p in prop::array::uniform3((-2i64..3, -2i64..3, -1i64..2)),
            q in prop::array::uniform3((-2i64..3, -2i64..3, -1i64..2)),
        ) {
            let (p, q) = (p.map(|(x, y, z)| [x, y, z]), q.map(|(x, y, z)| [x, y, z]));
            let points: Vec<DVec3> = p.iter().chain(&q).map(|&[x, y, z]| DVec3::new(x as f64, y as f64, z as f64)).collect();
            prop_assert_eq!(triangles_intersect([0, 1, 2], [3, 4, 5], |v| points[v as usize]), have_common_points(p, q));
        }
    }

    #[test]
    fn what_is_shared_is_no_cut() {
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
