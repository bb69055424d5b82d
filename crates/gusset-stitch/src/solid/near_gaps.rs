//! Gaps between borders that nearly match, vertex by vertex.
//!
//! Two vertices of free edges are partners if they are mutually nearest, and at most a quarter of the
//! shortest edge at either apart. Two free edges lie along a gap if their ends are partners, or a
//! common end, and their faces lie on different sides. Partners at such edges become one vertex: the
//! smaller one, which does not move. Pinholes through the two sheets of a thin wall are not gaps: the
//! faces at their rims lie on one side.
//! Coincident vertices are left to [sewing](super::sew_borders).

use super::repair_state::RepairState;
use super::sew_borders::SewCounts;
use super::sheet_pairs::direction_from_edge;
use crate::repair::near_borders::find_near_partners;
use crate::repair::sew_edges::{free_edges, free_vertices};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{NONE, Topology, unordered};

/// Largest width of a gap, relative to the shortest edge at its vertices.
const MAX_GAP_TO_EDGE_RATIO: f64 = 0.25;

/// Largest cosine between the directions from the two edges of a gap into their faces. It is -1 on a
/// plane, and 1 for two sheets that lie on each other.
const MAX_FACE_COSINE: f64 = 0.5;

const STAGE: &str = "closing gaps";

/// Joins the free edges along gaps. O(H + B log B) for H half-edges and B free edges.
pub(super) fn close_near_gaps(state: &mut RepairState, job: &Job<'_>) -> Result<SewCounts> {
    let (mut counts, mut pairs) = (SewCounts::default(), Vec::new());
    {
        let view = state.mesh.view(&job.sub_job(0.0, 0.1))?;
        let topology = Topology::new(&view, &job.sub_job(0.1, 0.5))?;
        let vertices = free_vertices(&view, &topology)?;
        if vertices.is_empty() {
            return Ok(counts);
        }
        let partners = find_near_partners(&view, &vertices, MAX_GAP_TO_EDGE_RATIO, &job.sub_job(0.5, 0.8))?;
        let position = |v: u32| view.positions().get(v);
        let across = |v: u32| match partners[v as usize] {
            NONE => v,
            partner if position(partner) == position(v) => v,
            partner => partner,
        };
        let mut edges = alloc::gather(free_edges(&view, &topology).map(|(h, ends)| (unordered(ends), h)))?;
        sort(&mut edges, Ord::cmp, &job.sub_job(0.8, 0.9), STAGE)?;
        let direction = |h: u32| direction_from_edge(&view, &topology, h);
        for (h, ends) in free_edges(&view, &topology) {
            let other = ends.map(across);
            let Ok(k) = edges.binary_search_by_key(&unordered(other), |&(key, _)| key) else { continue };
            if other == ends || direction(h).dot(direction(edges[k].1)) > MAX_FACE_COSINE {
                continue;
            }
            counts.sewn_edges += u32::from(unordered(ends) < unordered(other));
            for (v, partner) in ends.into_iter().zip(other).filter(|&(v, partner)| partner < v) {
                alloc::push(&mut pairs, (v, partner))?;
            }
        }
    }
    sort(&mut pairs, Ord::cmp, &job.sub_job(0.9, 1.0), STAGE)?;
    pairs.dedup();
    counts.welded_vertices = pairs.len() as u32;
    if !pairs.is_empty() {
        state.replace_vertices(&pairs);
        state.changes += 1;
    }
    Ok(counts)
}
