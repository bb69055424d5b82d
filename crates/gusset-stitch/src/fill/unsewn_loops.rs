//! Finds loops along borders that coincide with others. A patch there would lie on faces or have no
//! area.

use crate::boundary::Boundary;
use crate::repair::coordinate_round_off;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Number of edges in a leaf of the tree.
const EDGES_PER_LEAF: usize = 4;
/// Number of edges between two progress reports.
const EDGES_PER_REPORT: usize = 1 << 10;
/// Largest distance between coincident edges, relative to the shorter edge.
const MAX_DISTANCE_TO_LENGTH: f64 = 0.25;
/// Largest sine of the angle between coincident edges.
const MAX_SINE: f64 = 0.1;

const STAGE: &str = "comparing borders";

/// The loops with an edge that coincides with another boundary edge.
#[derive(Default)]
pub(super) struct UnsewnLoops {
    /// One flag for each loop; empty if all are sewn.
    pub(super) is_unsewn: Vec<bool>,
    /// The number of boundary edges that coincide with another.
    pub(super) edges: u32,
}

impl UnsewnLoops {
    /// An edge coincides with a boundary edge of another face if its midpoint lies on that edge, up
    /// to the rounding of the positions, and both are parallel.
    ///
    /// O(n log n) for n boundary edges, unless very many coincide.
    pub(super) fn find(mesh: &MeshView<'_>, boundary: &Boundary, job: &Job<'_>) -> Result<Self> {
        // The ends, the face and the loop of each edge.
        let mut edges = Vec::new();
        for (k, found) in boundary.iter().enumerate() {
            let sides = found.vertices.iter().zip(found.vertices.iter().cycle().skip(1));
            let faces = found.half_edges.iter().map(|&h| mesh.faces().face_of_half_edge(h));
            alloc::extend(&mut edges, sides.zip(faces).map(|((&u, &v), face)| ([u, v], face, k)))?;
        }
        let vertices = alloc::collect(edges.iter().map(|&([u, _], ..)| u))?;
        let tolerance = coordinate_round_off(mesh, &vertices, &job.sub_job(0.0, 0.1))?;
        let points = alloc::collect(vertices.iter().map(|&v| mesh.positions().get(v)))?;
        let unit = common_unit(&points);
        let tolerance = tolerance / unit;
        let ends = |e: usize| edges[e].0.map(|v| mesh.positions().get(v) / unit);
        let boxes = alloc::collect((0..edges.len()).map(|e| Aabb::from_points(ends(e)).grown_by(tolerance)))?;
        let order = spatial_order(&boxes, EDGES_PER_LEAF, &job.sub_job(0.1, 0.3), STAGE)?;
        let around = |leaf: &[u32]| leaf.iter().fold(Aabb::EMPTY, |whole, &e| whole.union(boxes[e as usize]));
        let tree = BoxTree::new_cancellable(order.chunks(EDGES_PER_LEAF).map(around), &job.sub_job(0.3, 0.3), STAGE)?;
        let mut unsewn = UnsewnLoops { is_unsewn: alloc::filled(false, boundary.len())?, edges: 0 };
        for e in 0..edges.len() {
            job.sub_job(0.3, 1.0).step_every(EDGES_PER_REPORT, e, edges.len(), STAGE)?;
            let [p, q] = ends(e);
            let middle = (p + q) / 2.0;
            let spot = Aabb { low: middle, high: middle };
            let is_met = std::cell::Cell::new(false);
            tree.visit_accepted(
                |_, b| !is_met.get() && b.overlaps(&spot),
                |leaf| {
                    for &other in order.chunks(EDGES_PER_LEAF).nth(leaf).unwrap_or_default() {
                        let other = other as usize;
                        let meets = edges[other].1 != edges[e].1
                            && boxes[other].overlaps(&spot)
                            && edges_coincide([p, q], middle, ends(other), tolerance);
                        is_met.set(is_met.get() || meets);
                    }
                    Ok(())
                },
            )?;
            if is_met.get() {
                unsewn.is_unsewn[edges[e].2] = true;
                unsewn.edges += 1;
            }
        }
        Ok(unsewn)
    }
}

/// Returns true if the middle of edge pq lies on edge rs, and both are parallel.
fn edges_coincide([p, q]: [DVec3; 2], middle: DVec3, [r, s]: [DVec3; 2], tolerance: f64) -> bool {
    let (own, other) = (q - p, s - r);
    let [length, other_length] = [own, other].map(DVec3::length);
    let reach = tolerance.min(MAX_DISTANCE_TO_LENGTH * length.min(other_length));
    let at = (middle - r).dot(other) / (other_length * other_length);
    own.cross(other).length() <= MAX_SINE * length * other_length
        && (r + other * at.clamp(0.0, 1.0)).distance(middle) <= reach
        && length > 0.0
        && other_length > 0.0
}
