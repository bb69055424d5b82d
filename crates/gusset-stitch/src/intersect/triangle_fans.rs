//! Groups of triangles that share a corner.
//!
//! Where many triangles meet at one vertex, boxes do not separate them: all pairs of a fan would be
//! tested. Suppose that all triangles of a group have the vertex. If a plane through it separates a
//! triangle with the vertex from all other corners of the group, then they share nothing else.
//! Candidates are the planes through the sides of the triangle, perpendicular to it.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_mesh::NONE;

/// Bound on the round-off of a product, relative to the size of its factors.
const MAX_RELATIVE_ROUND_OFF: f64 = 1.0 / (1u64 << 40) as f64;
/// Largest slope of a triangle's own sides against a plane through one of them.
const MAX_OWN_SIDE_SLOPE: f64 = 1.0 / (1u64 << 46) as f64;

/// For each node of a tree over groups of triangles, the vertex that they share, and the box of
/// their other corners.
pub(super) struct TriangleFans(Vec<SharedApex>);

/// The only vertex that all triangles of a group share, and the bounding box of their other
/// corners.
#[derive(Clone, Copy)]
struct SharedApex {
    /// [`NONE`] unless they share exactly one vertex.
    apex: u32,
    box_of_other_corners: Aabb,
}

impl TriangleFans {
    /// Builds the fans of groups of `group` triangles of `new` in this order. Calls `report` with
    /// the number of each node. O(n log n) for n triangles.
    pub(super) fn new(
        order: &[u32],
        group: usize,
        new: &[[u32; 3]],
        at: &impl Fn(u32) -> DVec3,
        report: &impl Fn(usize) -> Result<()>,
    ) -> Result<TriangleFans> {
        let leaves = order.len().div_ceil(group).next_power_of_two();
        // The vertices that all triangles of a node share; `None` for empty nodes.
        let mut shared = alloc::filled(None, 2 * leaves)?;
        for (k, (shared, triangles)) in shared[leaves..].iter_mut().zip(order.chunks(group)).enumerate() {
            report(k)?;
            *shared = triangles.iter().map(|&t| new[t as usize]).reduce(common_vertices);
        }
        for node in (1..leaves).rev() {
            report(node)?;
            shared[node] = match (shared[2 * node], shared[2 * node + 1]) {
                (Some(a), Some(b)) => Some(common_vertices(a, b)),
                (a, b) => a.or(b),
            };
        }
        let mut fans = alloc::filled(SharedApex { apex: NONE, box_of_other_corners: Aabb::EMPTY }, 2 * leaves)?;
        for (node, fan) in fans.iter_mut().enumerate().skip(1) {
            report(node)?;
            let [apex, second, third] = shared[node].unwrap_or([NONE; 3]);
            if apex == NONE || second != NONE || third != NONE {
                continue;
            }
            // The leaves below a node are consecutive.
            let width = leaves >> node.ilog2();
            let first = (node * width - leaves) * group;
            let triangles = &order[first.min(order.len())..(first + width * group).min(order.len())];
            let corners = triangles.iter().flat_map(|&t| new[t as usize]).filter(|&v| v != apex);
            *fan = SharedApex { apex, box_of_other_corners: Aabb::from_points(corners.map(at)) };
        }
        Ok(TriangleFans(fans))
    }

    /// Returns true if the planes through the sides of a triangle prove that it shares only one
    /// vertex with the triangles of a node. O(1).
    #[inline]
    pub(super) fn meets_fan_only_in_apex(&self, node: usize, sides: &TrianglePlanes) -> bool {
        let fan = &self.0[node];
        fan.apex != NONE
            && sides.vertices.iter().position(|&v| v == fan.apex).is_some_and(|k| {
                let slack =
                    MAX_RELATIVE_ROUND_OFF * (sides.max_coordinate + fan.box_of_other_corners.max_vector_length());
                [k, (k + 2) % 3].into_iter().any(|side| {
                    let normal = sides.normals[side];
                    // The corner of the box that is least far along the normal.
                    let least = DVec3::select(
                        normal.cmpge(DVec3::ZERO),
                        fan.box_of_other_corners.low,
                        fan.box_of_other_corners.high,
                    );
                    (least - sides.corners[k]).dot(normal) > slack
                })
            })
    }
}

/// Returns the common vertices, followed by [`NONE`].
fn common_vertices(a: [u32; 3], b: [u32; 3]) -> [u32; 3] {
    let mut found = [NONE; 3];
    a.into_iter().filter(|v| *v != NONE && b.contains(v)).zip(&mut found).for_each(|(v, place)| *place = v);
    found
}

/// The sides of a triangle, and the perpendicular planes through them.
pub(super) struct TrianglePlanes {
    vertices: [u32; 3],
    corners: [DVec3; 3],
    /// For each side, the normal of its plane, pointing away from the triangle. Side k leads from
    /// corner k to the next. The normal is 0 if round-off would put a part of the triangle beyond
    /// the plane.
    normals: [DVec3; 3],
    max_coordinate: f64,
}

fn coordinate_size(points: &[DVec3; 3]) -> f64 {
    points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()))
}

impl TrianglePlanes {
    pub(super) fn new(vertices: [u32; 3], corners: [DVec3; 3]) -> TrianglePlanes {
        let [p, q, r] = corners;
        let normal = (q - p).cross(r - p).normalize_or_zero();
        let normals = [0, 1, 2].map(|k| {
            let [side, other] = [1, 2].map(|next| corners[(k + next) % 3] - corners[k]);
            let away = side.cross(normal).normalize_or_zero();
            // The normal of a needle is mostly round-off. The slopes of its own sides must be far
            // below the slopes that others may have.
            let is_sound = away.dot(side).abs() <= MAX_OWN_SIDE_SLOPE * side.length()
                && away.dot(other) <= MAX_OWN_SIDE_SLOPE * other.length();
            if is_sound { away } else { DVec3::ZERO }
        });
        TrianglePlanes { vertices, corners, normals, max_coordinate: coordinate_size(&corners) }
    }

    /// Returns true if another triangle lies strictly beyond one of the sides, except for common
    /// ends of that side. The triangles then share nothing else.
    #[inline]
    pub(super) fn meets_only_in_common_vertices(&self, other: [u32; 3], at: &impl Fn(u32) -> DVec3) -> bool {
        let points = other.map(at);
        let slack = MAX_RELATIVE_ROUND_OFF * (coordinate_size(&points) + self.max_coordinate);
        (0..3).any(|k| {
            let ends = [self.vertices[k], self.vertices[(k + 1) % 3]];
            let is_beyond =
                |(v, p): (u32, DVec3)| ends.contains(&v) || (p - self.corners[k]).dot(self.normals[k]) > slack;
            self.normals[k] != DVec3::ZERO && other.into_iter().zip(points).all(is_beyond)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::predicates::triangles_intersect;
    use super::super::{TriangleSoup, intersecting_pairs};
    use glam::DVec3;
    use gusset_base::job::Job;

    /// Fans of needles that fold over each other, some around the same apex, some flat.
    #[test]
    fn fans_intersect_as_their_triangles_do_pair_by_pair() {
        let mut random = fastrand::Rng::with_seed(3);
        let mut met = 0;
        for case in 0..gusset_base::testing::case_count(200) {
            let n = 40;
            let rise = [0.0, 1e-12, 0.02, 0.5][case as usize % 4];
            let turns = [0.5, 1.0, 2.3][case as usize / 4 % 3];
            // Two apexes next to each other, and a polyline around them.
            let mut points = vec![DVec3::ZERO, DVec3::new(1e-3, 0.0, rise * 1e-3)];
            points.extend((0..=n).map(|k| {
                let t = turns * std::f64::consts::TAU * f64::from(k) / f64::from(n);
                DVec3::new(libm::cos(t), libm::sin(t), rise * (random.f64() + t)) * (1.0 + 0.3 * random.f64())
            }));
            let line = 2..n as u32 + 2;
            let new: Vec<[u32; 3]> = line.map(|k| [k % 3 / 2, k, k + 1]).collect();
            let at = |v: u32| points[v as usize];
            let found = intersecting_pairs(
                &TriangleSoup { position_of_vertex: at, new_triangles: &new, old_triangles: &[] },
                &Job::default(),
            )
            .unwrap();
            let all = (0..new.len() as u32).flat_map(|j| (0..j).map(move |i| [i, j]));
            let mut expected: Vec<_> =
                all.filter(|pair| triangles_intersect(new[pair[0] as usize], new[pair[1] as usize], at)).collect();
            expected.sort_unstable();
            assert_eq!(found, expected, "case {case}");
            met += expected.len();
        }
        assert!(met > 100, "{met}");
    }
}
