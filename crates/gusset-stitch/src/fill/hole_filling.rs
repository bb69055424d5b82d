//! Builds the patches of all groups of loops, and replaces patches that intersect.

use super::candidate_loops::CandidateLoop;
use super::faces_near_boxes::find_faces_near_boxes;
use super::fill_request::{Options, Refinement};
use super::fill_result::FinishedPatches;
use super::old_faces_at_rims::OldFacesAtRims;
use super::patch::{PatchBuilder, list_attempts, patch_bounds};
use super::patch_cuts::{IntersectionCounter, OldTriangles, find_patch_intersections, intersecting_patches};
use super::patch_rim::PatchRim;
use super::placed_patch::{MeshAndPatchVertices, PlacedPatch};
use crate::stitch::Intersections;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use std::collections::HashSet;

/// The note on a hole with fewer attempts.
const LIMIT_NOTE: &str = "a hole takes too many new vertices to try all ways of fairing its patch: refine it less";

/// The patches and their inputs.
pub(super) struct HoleFilling<'a> {
    options: &'a Options,
    candidates: &'a [CandidateLoop],
    /// The candidates to fill. Each group gets one patch.
    groups: &'a [Vec<usize>],
    /// For each group, a box that contains its patch.
    patch_boxes: Vec<Aabb>,
    /// For each mesh vertex, the number of loops that pass it.
    loops_through_vertex: &'a [u8],
    /// The faces near the holes, ascending.
    faces_near_holes: Vec<u32>,
    surroundings: OldFacesAtRims<'a>,
    /// New edges between old vertices that several loops pass. No other patch may repeat them.
    bridges: HashSet<(u32, u32)>,
    pub(super) finished_patches: FinishedPatches<'a>,
}

impl<'a> HoleFilling<'a> {
    pub(super) fn new(
        mesh: &'a MeshView<'a>,
        candidates: &'a [CandidateLoop],
        groups: &'a [Vec<usize>],
        loops_through_vertex: &'a [u8],
        options: &'a Options,
        job: &Job<'_>,
    ) -> Result<Self> {
        let mut points = Vec::new();
        let mut boxes = Vec::new();
        for group in groups {
            let first = points.len();
            let vertices = group.iter().flat_map(|&number| &candidates[number].vertices);
            alloc::extend(&mut points, vertices.map(|&v| mesh.positions().get(v)))?;
            let rim = &points[first..];
            // New vertices may leave the rim's box: they are faired, or lie on creases.
            let bulges = options.refinement != Refinement::None;
            alloc::push(&mut boxes, if bulges { patch_bounds(rim) } else { Aabb::from_points(rim) })?;
        }
        let near = find_faces_near_boxes(mesh, &boxes, &job.sub_job(0.0, 0.9))?;
        let surroundings =
            OldFacesAtRims::new(mesh, loops_through_vertex, &near, options.continuity, &job.sub_job(0.9, 1.0))?;
        let made =
            FinishedPatches { vertices: MeshAndPatchVertices::new(mesh, &points), ..FinishedPatches::empty(mesh) };
        Ok(HoleFilling {
            options,
            candidates,
            groups,
            patch_boxes: boxes,
            loops_through_vertex,
            faces_near_holes: near,
            surroundings,
            bridges: HashSet::new(),
            finished_patches: made,
        })
    }

    pub(super) fn build_patches(&mut self, job: &Job<'_>) -> Result<()> {
        let length = |group: &[usize]| group.iter().map(|&k| self.candidates[k].vertices.len()).sum::<usize>();
        let all: usize = self.groups.iter().map(|group| length(group)).sum();
        let (mut done, make) = (0, job.sub_job(0.0, 0.6));
        let mut rooms = alloc::with_capacity(self.groups.len())?;
        for (k, group) in self.groups.iter().enumerate() {
            let end = done + length(group);
            let part = make.sub_job(done as f64 / all as f64, end as f64 / all as f64);
            done = end;
            if let Some(placed) = self.build_first_patch(group, &part)? {
                alloc::push(&mut self.finished_patches.groups, group.as_slice())?;
                alloc::push(&mut self.finished_patches.patches, placed)?;
                rooms.push(self.patch_boxes[k]);
            }
        }
        if self.options.intersections != Intersections::Ignore {
            self.replace_intersecting_patches(&rooms, &job.sub_job(0.6, 1.0))?;
        }
        Ok(())
    }

    /// Returns the rim of a group's patch, and the rim's mesh vertices; `None` if two of the loops
    /// share a vertex.
    fn build_group_rim(&mut self, group: &[usize], job: &Job<'_>) -> Result<Option<(PatchRim, Vec<u32>)>> {
        self.surroundings.build_patch_rim(group.iter().map(|&number| self.candidates[number].vertices.as_slice()), job)
    }

    /// Returns the first patch that can be built.
    fn build_first_patch(&mut self, group: &[usize], job: &Job<'_>) -> Result<Option<PlacedPatch>> {
        let Some((rim, names)) = self.build_group_rim(group, job)? else {
            return Ok(None);
        };
        let taken =
            |u: u32, v: u32| is_taken_edge(&self.surroundings, &self.bridges, [names[u as usize], names[v as usize]]);
        let mut planner = PatchBuilder::new(&rim, self.options, &taken, None);
        let (mut found, mut limited) = (None, false);
        let ways = list_attempts(self.options);
        for (i, &attempt) in ways.iter().enumerate() {
            let job = job.sub_job_of_item(i, ways.len());
            if planner.exceeds_limit(attempt) {
                limited = true;
                continue;
            }
            if let Some(patch) = planner.build_patch(attempt, &job.sub_job(0.0, 0.9))? {
                found = Some(self.finished_patches.vertices.place_patch(
                    &rim,
                    &names,
                    &patch,
                    attempt,
                    &job.sub_job(0.9, 1.0),
                )?);
            }
            // The search for several loops is incomplete, so another weight may succeed.
            if found.is_some() || planner.lacks_triangulation() && group.len() == 1 {
                break;
            }
        }
        if limited {
            job.note(LIMIT_NOTE);
        }
        drop(planner);
        alloc::insert_all(
            &mut self.bridges,
            found.iter().flat_map(|placed| edges_between_shared_vertices(self.loops_through_vertex, placed)),
        )?;
        Ok(found)
    }

    /// Looks for intersections, and tries other patches where there are any. `patch_boxes` are the
    /// patches' boxes.
    fn replace_intersecting_patches(&mut self, patch_boxes: &[Aabb], job: &Job<'_>) -> Result<()> {
        let old =
            OldTriangles::new(self.finished_patches.vertices.mesh, &self.faces_near_holes, &job.sub_job(0.0, 0.1))?;
        let mut pairs = find_patch_intersections(
            &self.finished_patches.vertices,
            &self.finished_patches.patches,
            &old,
            &job.sub_job(0.1, 0.3),
        )?;
        if !pairs.is_empty() && self.options.intersections == Intersections::Auto {
            let trials =
                IntersectionCounter::new(&self.finished_patches.vertices, &old, patch_boxes, &job.sub_job(0.3, 0.3))?;
            let cutting = intersecting_patches(&pairs, &self.finished_patches.patches)?;
            for (i, &k) in cutting.iter().enumerate() {
                let job = job.sub_job(0.3, 0.8).sub_job_of_item(i, cutting.len());
                self.replace_by_best_attempt(k, &trials, &job)?;
            }
            pairs = find_patch_intersections(
                &self.finished_patches.vertices,
                &self.finished_patches.patches,
                &old,
                &job.sub_job(0.8, 1.0),
            )?;
        }
        let first_new = self.finished_patches.vertices.mesh.faces().len() as u32;
        self.finished_patches.intersections =
            Some(old.pairs_of_faces(&pairs, &self.finished_patches.patches, first_new)?);
        Ok(())
    }

    /// Replaces patch `k` by the attempt with the fewest intersections, the first of equals.
    fn replace_by_best_attempt(&mut self, k: usize, trials: &IntersectionCounter<'_>, job: &Job<'_>) -> Result<()> {
        let Some((rim, names)) = self.build_group_rim(self.finished_patches.groups[k], job)? else {
            return Ok(());
        };
        if rim.rim_vertex_count == 3 && self.options.refinement == Refinement::None {
            // A triangular hole has only one triangulation.
            return Ok(());
        }
        let taken =
            |u: u32, v: u32| is_taken_edge(&self.surroundings, &self.bridges, [names[u as usize], names[v as usize]]);
        let first = &self.finished_patches.patches[k];
        let mut planner = PatchBuilder::new(&rim, self.options, &taken, Some((first.attempt, first.vertices.len())));
        let mut least = trials.count_intersections(
            &self.finished_patches.vertices,
            &self.finished_patches.patches,
            k,
            &self.finished_patches.patches[k],
            &job.sub_job(0.0, 0.0),
        )?;
        let first_tried = self.finished_patches.vertices.end_vertex_number();
        let (mut better, mut limited) = (None, false);
        let ways = list_attempts(self.options);
        for (i, &attempt) in ways.iter().enumerate() {
            let job = job.sub_job_of_item(i, ways.len());
            if least == 0 {
                break;
            }
            if attempt == self.finished_patches.patches[k].attempt {
                continue;
            }
            if planner.exceeds_limit(attempt) {
                limited = true;
                continue;
            }
            let Some(patch) = planner.build_patch(attempt, &job.sub_job(0.0, 0.7))? else {
                continue;
            };
            let mut placed =
                self.finished_patches.vertices.place_patch(&rim, &names, &patch, attempt, &job.sub_job(0.7, 0.8))?;
            let count = trials.count_intersections(
                &self.finished_patches.vertices,
                &self.finished_patches.patches,
                k,
                &placed,
                &job.sub_job(0.8, 1.0),
            )?;
            if count < least {
                self.finished_patches.vertices.move_last_patch_down(&mut placed, first_tried);
                (least, better) = (count, Some(placed));
            } else {
                self.finished_patches.vertices.remove_last_patch(&placed);
            }
        }
        if limited {
            job.note(LIMIT_NOTE);
        }
        drop(planner);
        alloc::insert_all(
            &mut self.bridges,
            better.iter().flat_map(|placed| edges_between_shared_vertices(self.loops_through_vertex, placed)),
        )?;
        if let Some(placed) = better {
            self.finished_patches.patches[k] = placed;
        }
        Ok(())
    }
}

/// Returns true if two rim vertices must not get an edge.
fn is_taken_edge(surroundings: &OldFacesAtRims<'_>, bridges: &HashSet<(u32, u32)>, [u, v]: [u32; 2]) -> bool {
    surroundings.have_common_face(u, v) || bridges.contains(&(u.min(v), u.max(v)))
}

/// Returns the edges of a patch between two old vertices that several loops pass.
fn edges_between_shared_vertices(loops_through_vertex: &[u8], patch: &PlacedPatch) -> impl Iterator<Item = (u32, u32)> {
    let shared = |v: u32| loops_through_vertex.get(v as usize).is_some_and(|&count| count > 1);
    let sides = patch.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    sides.filter(move |&(u, v)| shared(u) && shared(v)).map(|(u, v)| (u.min(v), u.max(v)))
}
