//! Holes that are filled without changes of other faces.

use super::corner_place::CornerPlace;
use super::repair_request::DropReason;
use super::repair_state::RepairState;
use crate::fill::{self, Filled, HoleStatus, LoopSelection, fill_holes};
use crate::repair::orient::Outward;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// Fills the holes of a mesh, and returns their number. A hole stays open if its patch would repeat a face, as around a
/// loose triangle.
pub(super) fn fill_open_holes(state: &mut RepairState, options: &fill::Options, job: &Job<'_>) -> Result<u32> {
    let options = fill::Options { plan_only: false, outward: Outward::Keep, ..*options };
    let filled = {
        let view = state.mesh.view(&job.sub_job(0.0, 0.0))?;
        fill_holes(&view, LoopSelection::All, &options, job)?
    };
    let repeated = repeated_patches(state, &filled)?;
    let is_filled = |status: HoleStatus| status == HoleStatus::Filled;
    let count = filled.holes.iter().filter(|hole| is_filled(hole.status)).count() - repeated.len();
    if count == 0 {
        return Ok(0);
    }
    state.append_patches(filled)?;
    if !repeated.is_empty() {
        let mut reasons = alloc::filled(None, state.mesh.face_count())?;
        repeated.iter().for_each(|&f| reasons[f as usize] = Some(DropReason::Duplicate));
        state.drop_faces(&reasons)?;
    }
    Ok(count as u32)
}

/// Returns the patches of one triangle with the vertices of an old face. O(F log k) for F faces and k such patches.
fn repeated_patches(state: &RepairState, filled: &Filled) -> Result<Vec<u32>> {
    let triangle = |f: usize| {
        let [first, end] = [f, f + 1].map(|k| filled.mesh.face_offsets[k] as usize);
        let mut corners = <[u32; 3]>::try_from(&filled.mesh.face_corners[first..end]).ok()?;
        corners.sort_unstable();
        Some(corners)
    };
    let triangles = filled.holes.iter().filter(|hole| hole.status == HoleStatus::Filled && hole.faces.len() == 1);
    let mut patches =
        alloc::gather(triangles.filter_map(|hole| Some((triangle(hole.faces.start as usize)?, hole.faces.start))))?;
    patches.sort_unstable();
    let mut repeated = Vec::new();
    if !patches.is_empty() {
        for corners in (0..state.mesh.face_count()).filter_map(triangle) {
            if let Ok(k) = patches.binary_search_by_key(&corners, |&(corners, _)| corners) {
                alloc::push(&mut repeated, patches[k].1)?;
            }
        }
    }
    repeated.sort_unstable();
    repeated.dedup();
    Ok(repeated)
}

impl RepairState {
    /// Replaces the mesh by the filled one.
    fn append_patches(&mut self, filled: Filled) -> Result<()> {
        self.changes += 1;
        alloc::grow(&mut self.face_origin, filled.mesh.face_count(), NONE)?;
        alloc::grow(&mut self.turned, filled.mesh.face_count(), false)?;
        alloc::grow(&mut self.corner_places, filled.mesh.face_corners.len(), CornerPlace::NONE)?;
        let old = self.vertex_origin.len() as u32;
        let parents = filled.parents.iter().zip(&filled.weights).zip(old..);
        alloc::extend(&mut self.new_vertices, parents.map(|((&parents, &weights), v)| (v, parents, weights)))?;
        alloc::grow(&mut self.vertex_origin, filled.mesh.positions.len(), NONE)?;
        self.mesh = filled.mesh;
        Ok(())
    }
}
