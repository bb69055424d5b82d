//! Edges of one sheet that coincide.
//!
//! A sheet can pass an edge twice, so that both passes have the same two vertices although each
//! vertex has one fan of faces: a ring of cubes that touches itself at an edge. A vertex in the
//! middle of each pass makes them two edges.

use super::repair_state::RepairState;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// Splits the edge of each pair of half-edges in the middle, with a vertex of its own. O(V + H).
pub(super) fn split_twin_edges(state: &mut RepairState, pairs: &[[u32; 2]], job: &Job<'_>) -> Result<()> {
    if pairs.is_empty() {
        return Ok(());
    }
    let old = state.mesh.positions.len();
    let mut places = alloc::with_capacity(2 * pairs.len())?;
    for (k, &pair) in pairs.iter().enumerate() {
        places.extend(pair.map(|h| (h, 0.5, (old + k) as u32)));
    }
    places.sort_unstable_by_key(|&(h, ..)| h);
    let (mut middles, mut new) = (alloc::with_capacity(pairs.len())?, alloc::with_capacity(pairs.len())?);
    {
        let view = state.mesh.view(&job.sub_job(0.0, 0.3))?;
        let half = |h: u32| view.positions().get(view.faces().corner(h)) * 0.5;
        for (v, &[h, _]) in (old as u32..).zip(pairs) {
            let end = view.faces().next(h);
            middles.push(half(h) + half(end));
            let [a, b] = [h, end].map(|h| view.faces().corner(h));
            new.push((v, [a, b, b], [0.5, 0.5, 0.0]));
        }
    }
    alloc::append(&mut state.new_vertices, &new)?;
    state.mesh.positions.extend(middles.into_iter())?;
    alloc::grow(&mut state.vertex_origin, old + pairs.len(), NONE)?;
    let reasons = alloc::filled(None, state.mesh.face_count())?;
    state.drop_and_insert(&reasons, &places, &job.sub_job(0.3, 1.0))
}
