//! Appends the patches to a copy of the mesh in the order of the loops, and reports on each loop.

use super::candidate_loops::CandidateLoop;
use super::fill_request::{Filled, Finish, Hole, HoleStatus, Options};
use super::patch::list_attempts;
use super::placed_patch::{MeshAndPatchVertices, PlacedPatch};
use crate::repair::orient::{Outward, turn_outwards};
use crate::stitch::{Quality, faces_as_mesh};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, concat};

/// The finished patches.
pub(super) struct FinishedPatches<'a> {
    pub(super) vertices: MeshAndPatchVertices<'a>,
    /// In the order of the first loops of their groups.
    pub(super) patches: Vec<PlacedPatch>,
    /// The candidates that each patch closes.
    pub(super) groups: Vec<&'a [usize]>,
    /// Pairs of intersecting faces of the result; `None` if they were not looked for.
    pub(super) intersections: Option<Vec<[u32; 2]>>,
}

impl<'a> FinishedPatches<'a> {
    pub(super) fn empty(mesh: &'a MeshView<'a>) -> Self {
        FinishedPatches {
            vertices: MeshAndPatchVertices::new(mesh, &[]),
            patches: Vec::new(),
            groups: Vec::new(),
            intersections: None,
        }
    }

    /// Returns the patch number of each candidate, or [`NONE`].
    fn patch_numbers(&self, candidates: usize) -> Result<Vec<u32>> {
        let mut numbers = alloc::filled(NONE, candidates)?;
        for (group, patch) in self.groups.iter().zip(0..) {
            group.iter().for_each(|&candidate| numbers[candidate] = patch);
        }
        Ok(numbers)
    }
}

/// Assembles the result. O(H) for H half-edges of the result.
pub(super) fn build_result(
    made: FinishedPatches<'_>,
    candidates: &[CandidateLoop],
    options: &Options,
    job: &Job<'_>,
) -> Result<Filled> {
    let mesh = made.vertices.mesh;
    job.step(0.0, "putting the pieces together")?;
    let counts = made.patches.iter().map(|patch| [patch.vertices.len(), patch.triangles.len()]);
    let [points, faces] = counts.fold([0, 0], |sum, count| [sum[0] + count[0], sum[1] + count[1]]);
    let mut whole = concat::empty_mesh_with_room(std::iter::once(mesh), [points, faces, 3 * faces])?;
    concat::append_piece(&mut whole, mesh, job, |_| false)?;
    let (mut parents, mut weights) = (alloc::with_capacity(points)?, alloc::with_capacity(points)?);
    for patch in &made.patches {
        parents.extend(patch.parents.iter().map(|&(of, _)| of));
        weights.extend(patch.parents.iter().map(|&(_, weights)| weights));
    }
    let (holes, rims) = hole_reports(&made, candidates, options, &mut whole)?;
    job.step(0.1, "putting the pieces together")?;
    let part = faces_as_mesh(&whole, mesh.faces().len(), &job.sub_job(0.1, 0.3))?;
    let outward = if options.plan_only { Outward::Keep } else { options.outward };
    let measured = if outward == Outward::Closed { 0.7 } else { 1.0 };
    let quality = Quality::measure(&whole, &part, &job.sub_job(0.3, measured))?;
    let turned_outwards = match outward {
        Outward::Keep => Vec::new(),
        Outward::Closed => turn_outwards(&mut whole, &job.sub_job(measured, 1.0))?.turned,
    };
    let intersections = made.intersections;
    Ok(Filled {
        mesh: whole,
        holes,
        rims,
        parents,
        weights,
        intersections,
        coincident_edges: 0,
        turned_outwards,
        quality,
    })
}

/// Reports on each loop, and lists the vertices of all loops. Appends each patch with its first
/// loop.
fn hole_reports(
    made: &FinishedPatches<'_>,
    candidates: &[CandidateLoop],
    options: &Options,
    whole: &mut Mesh,
) -> Result<(Vec<Hole>, Vec<u32>)> {
    let numbers = made.patch_numbers(candidates.len())?;
    let (mut holes, mut rims) = (alloc::with_capacity(candidates.len())?, Vec::new());
    let mut placed = alloc::with_capacity(made.patches.len())?;
    let asked = if options.plan_only { list_attempts(options)[0].construction() } else { Finish::Plain };
    for (candidate, patch) in candidates.iter().zip(numbers) {
        let end = |whole: &Mesh| [whole.face_count() as u32, whole.positions.len() as u32];
        if patch as usize == placed.len() {
            let start = end(whole);
            append_patch(whole, &made.vertices, &made.patches[patch as usize])?;
            placed.push([start, end(whole)]);
        }
        let own = made.patches.get(patch as usize);
        let [start, end] = placed.get(patch as usize).copied().unwrap_or([end(whole); 2]);
        let start_of_rim = rims.len();
        alloc::append(&mut rims, &candidate.vertices)?;
        let left = candidate.status == HoleStatus::Filled && own.is_none() && !options.plan_only;
        holes.push(Hole {
            status: if left { HoleStatus::NoTriangulation } else { candidate.status },
            rim: start_of_rim..rims.len(),
            patch,
            faces: start[0]..end[0],
            vertices: start[1]..end[1],
            measures: candidate.measures,
            weight: own.map_or(options.weight, |patch| patch.attempt.weight),
            finish: own.map_or(asked, |patch| patch.attempt.construction()),
        });
    }
    Ok((holes, rims))
}

/// Appends a patch to a mesh with enough capacity.
fn append_patch(whole: &mut Mesh, vertices: &MeshAndPatchVertices<'_>, patch: &PlacedPatch) -> Result<()> {
    let (old, first) = (vertices.mesh.positions().len() as u32, whole.positions.len() as u32);
    let name = |v: u32| if v < old { v } else { v - patch.vertices.start + first };
    whole.positions.extend(patch.vertices.clone().map(|v| vertices.position(v)))?;
    for triangle in &patch.triangles {
        whole.face_corners.extend(triangle.map(name));
        whole.face_offsets.push(whole.face_corners.len() as u32);
    }
    Ok(())
}
