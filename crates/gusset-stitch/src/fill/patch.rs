//! The patch of one rim: its triangulation, or a blend if new vertices are requested, by a sequence
//! of attempts.

use super::creases::{DividedHole, divide_along_creases};
use super::fill_request::{Fairing, Finish, Options, Refinement, Weight};
use super::loops::triangulate_loops_together;
use super::patch_rim::PatchRim;
use super::planar_loops::{clip_ears, is_planar, mean_normal};
use super::triangulation_search::{MAX_EXACT_VERTICES, minimum_weight_triangulation};
use crate::blend::{self, BlendFairing, NewVertexLimits};
use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::triangle_places::nearest_places;
use gusset_base::job::Job;
use std::cell::Cell;

/// Limit on the estimated number of new vertices of a hole, if the caller sets none.
const DEFAULT_MAX_NEW_VERTICES: u32 = 50_000;
/// After the first blend of a hole, others are tried as long as all together stay below this
/// effort. Five blends of 4,400 new vertices with full fairing reach it. On 163 meshes, no blend
/// beyond it had fewer cuts than the best patch before it.
const MAX_EFFORT_OF_ATTEMPTS: usize = 110_000;
/// Limit on the new vertices that sharp angles at the rim may request, per rim vertex, if the
/// caller sets none.
const DEFAULT_MAX_NEW_PER_RIM_VERTEX: u32 = 4;
/// The fairing attempts for blends, in order, until nothing intersects.
const FAIRING_ATTEMPTS: [BlendFairing; 4] = [
    BlendFairing { rounds: 4, unfolds: false },
    BlendFairing { rounds: 4, unfolds: true },
    BlendFairing { rounds: 1, unfolds: true },
    BlendFairing::WITHOUT_FAIRING,
];
/// Faired vertices stay in the rim's box, enlarged on all sides by this fraction of its diagonal.
pub(super) const MAX_RELATIVE_BULGE: f64 = 0.5;

/// One attempt to fill a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PatchAttempt {
    pub(super) weight: Weight,
    /// How the blend is faired; `None` for a patch without new vertices.
    fairing: Option<BlendFairing>,
    /// True if creases of the old surface are continued. Without creases the attempt fails.
    creased: bool,
}

impl PatchAttempt {
    /// Returns true if the patch has new vertices.
    pub(super) fn is_blend(self) -> bool {
        self.fairing.is_some()
    }

    /// Returns the effort of a patch with `vertices` new vertices: a pass over them for the blend, and
    /// one for each round of fairing.
    pub(super) fn effort(self, vertices: usize) -> usize {
        self.fairing.map_or(0, |way| vertices * (1 + way.rounds as usize))
    }

    /// Returns the construction of the resulting patch.
    pub(super) fn construction(self) -> Finish {
        match self.fairing {
            None => Finish::Plain,
            Some(BlendFairing::WITHOUT_FAIRING) => Finish::Refined,
            Some(_) => Finish::Faired,
        }
    }
}

/// Returns the attempts that the options allow, the requested one first.
pub(super) fn list_attempts(options: &Options) -> Vec<PatchAttempt> {
    let mut weights = vec![options.weight];
    weights.extend(Weight::CHOICES.values.iter().copied().filter(|&weight| weight != options.weight));
    let blends: &[BlendFairing] = match (options.refinement, options.fairing) {
        (Refinement::None, _) => &[],
        (Refinement::RimDensity(_), Fairing::None) => &[BlendFairing::WITHOUT_FAIRING],
        (Refinement::RimDensity(_), Fairing::ThinPlate) => &FAIRING_ATTEMPTS,
    };
    let mut ways = Vec::new();
    for weight in weights {
        let creases: &[bool] = if options.ignore_creases { &[false] } else { &[true, false] };
        for &creased in creases {
            ways.extend(blends.iter().map(|&way| PatchAttempt { weight, fairing: Some(way), creased }));
        }
        ways.extend(creases.iter().map(|&creased| PatchAttempt { weight, fairing: None, creased }));
    }
    ways
}

/// A patch. The rim's vertices keep their numbers in the [`PatchRim`], and `points` come after
/// them.
pub(super) struct Patch {
    /// The new vertices, in the rim's unit and from its origin.
    pub(super) points: Vec<DVec3>,
    /// Their positions without fairing: on the triangles of the initial triangulation, or between
    /// creases, near these triangles.
    pub(super) points_before_fairing: Vec<DVec3>,
    /// The initial triangulation.
    pub(super) coarse_triangles: Vec<[u32; 3]>,
    /// The new faces.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// Builds patches for one rim.
pub(super) struct PatchBuilder<'a, T: Fn(u32, u32) -> bool> {
    rim: &'a PatchRim,
    options: &'a Options,
    /// Returns true if two rim vertices must not get an edge.
    is_forbidden_edge: &'a T,
    /// The last triangulation, and the plan of the blends based on it.
    coarse_triangulation: Option<(Weight, Vec<[u32; 3]>)>,
    blend_plan: Option<blend::BlendPlan<&'a T>>,
    /// The number of new vertices of the last attempt with a blend.
    last_vertices: Cell<usize>,
    /// The effort of all attempts so far, also of those that were rejected.
    effort: Cell<usize>,
}

impl<'a, T: Fn(u32, u32) -> bool> PatchBuilder<'a, T> {
    /// Creates the builder. `earlier` is the attempt that was made before, and its number of new
    /// vertices.
    pub(super) fn new(
        rim: &'a PatchRim,
        options: &'a Options,
        taken: &'a T,
        earlier: Option<(PatchAttempt, usize)>,
    ) -> Self {
        PatchBuilder {
            rim,
            options,
            is_forbidden_edge: taken,
            coarse_triangulation: None,
            blend_plan: None,
            last_vertices: Cell::new(earlier.map_or(0, |(_, vertices)| vertices)),
            effort: Cell::new(earlier.map_or(0, |(attempt, vertices)| attempt.effort(vertices))),
        }
    }

    /// Returns true if the attempt is a blend, is not the first one, and would exceed
    /// [`MAX_EFFORT_OF_ATTEMPTS`] if it has as many vertices as the last one.
    pub(super) fn exceeds_limit(&self, attempt: PatchAttempt) -> bool {
        let used = self.effort.get();
        attempt.is_blend() && used > 0 && used + attempt.effort(self.last_vertices.get()) > MAX_EFFORT_OF_ATTEMPTS
    }

    /// Adds an attempt with `vertices` new vertices to the effort.
    fn count_effort(&self, attempt: PatchAttempt, vertices: usize) {
        self.last_vertices.set(vertices);
        self.effort.set(self.effort.get() + attempt.effort(vertices));
    }

    /// Returns true if the last patch had no triangulation.
    pub(super) fn lacks_triangulation(&self) -> bool {
        self.coarse_triangulation.is_none()
    }

    /// Builds the patch. Returns `None` if no triangulation is found without a taken edge, or if
    /// the patch would leave the neighbourhood of its rim.
    ///
    /// O(n^3) for a rim of n <= 128 vertices, O(n log n) for longer ones. Refinement and fairing of
    /// m new vertices: O(m log m), and O(m^1.5) for the sparse factor.
    pub(super) fn build_patch(&mut self, attempt: PatchAttempt, job: &Job<'_>) -> Result<Option<Patch>> {
        let rim = self.rim;
        if self.coarse_triangulation.as_ref().is_none_or(|&(weight, _)| weight != attempt.weight) {
            self.blend_plan = None;
            let found = triangulate_rim(rim, attempt.weight, self.is_forbidden_edge, &job.sub_job(0.0, 0.4))?;
            self.coarse_triangulation = found.map(|triangles| (attempt.weight, triangles));
        }
        let Some((_, coarse)) = &self.coarse_triangulation else {
            return Ok(None);
        };
        if attempt.creased {
            return self.build_creased_patch(attempt, coarse, &job.sub_job(0.4, 1.0));
        }
        if let (Refinement::RimDensity(limit), None, true) =
            (self.options.refinement, &self.blend_plan, attempt.fairing.is_some())
        {
            let copy = alloc::copied(coarse)?;
            self.blend_plan = blend::BlendPlan::new(
                rim.old_ring(self.options.continuity)?,
                copy,
                new_vertex_limits(limit),
                self.is_forbidden_edge,
                None,
                &job.sub_job(0.4, 0.6),
            )?;
        }
        let coarse = alloc::copied(coarse)?;
        if attempt.is_blend() && self.blend_plan.is_none() {
            return Ok(None);
        }
        let (Some(plan), Some(way)) = (&self.blend_plan, attempt.fairing) else {
            let triangles = alloc::copied(&coarse)?;
            return Ok(Some(Patch {
                points: Vec::new(),
                points_before_fairing: Vec::new(),
                coarse_triangles: coarse,
                triangles,
            }));
        };
        let made = plan.create_blend(way, &job.sub_job(0.6, 1.0))?;
        self.count_effort(attempt, made.points.len());
        if !is_near_rim(rim, &made.points) {
            return Ok(None);
        }
        if way != BlendFairing::WITHOUT_FAIRING {
            return Ok(Some(Patch {
                points: made.points,
                points_before_fairing: made.unfaired,
                coarse_triangles: coarse,
                triangles: made.triangles,
            }));
        }
        // Flips and moves cut the corners of a bent triangulation. Project the vertices back onto
        // it, so that each lies at the weighted mean of its parents.
        let points =
            project_onto_triangles(&rim.points[..rim.rim_vertex_count], &coarse, &made.points, &job.sub_job(1.0, 1.0))?;
        Ok(Some(Patch {
            points_before_fairing: alloc::copied(&points)?,
            points,
            coarse_triangles: coarse,
            triangles: made.triangles,
        }))
    }

    /// Builds the patch from parts between creases; `None` if no creases continue. `whole` is the
    /// initial triangulation of the hole, which defines the parents of new vertices.
    fn build_creased_patch(&self, attempt: PatchAttempt, whole: &[[u32; 3]], job: &Job<'_>) -> Result<Option<Patch>> {
        let rim = self.rim;
        let limits = match self.options.refinement {
            Refinement::RimDensity(limit) if attempt.fairing.is_some() => Some(new_vertex_limits(limit)),
            _ => None,
        };
        // Half of the new vertices are for the parts.
        let Some(DividedHole { points, parts }) =
            divide_along_creases(rim, self.is_forbidden_edge, limits.map(|limits| limits.max_estimated_vertices / 2))?
        else {
            return Ok(None);
        };
        // A crease within the plane of the hole does not bend the patch, and the parts could
        // overlap.
        let mut outlines = alloc::copied(&rim.points[..rim.rim_vertex_count])?;
        let normal = mean_normal(&outlines);
        alloc::append(&mut outlines, &points)?;
        if parts.len() > 1 && counts_only_area(attempt.weight, &outlines, normal) {
            return Ok(None);
        }
        let unfaired = alloc::copied(&points)?;
        let mut patch = Patch {
            points,
            points_before_fairing: unfaired,
            coarse_triangles: alloc::copied(whole)?,
            triangles: Vec::new(),
        };
        let all: usize = parts.iter().map(|part| part.names.len()).sum();
        for (k, part) in parts.iter().enumerate() {
            let job = job.sub_job_of_item(k, parts.len());
            let taken = |u: u32, v: u32| part.is_taken_edge(u, v, self.is_forbidden_edge);
            let Some(mut triangles) = triangulate_rim(&part.rim, attempt.weight, &taken, &job.sub_job(0.0, 0.4))?
            else {
                return Ok(None);
            };
            let first = rim.rim_vertex_count + patch.points.len();
            if let Some((way, limits)) = attempt.fairing.zip(limits) {
                let new =
                    (u64::from(limits.max_estimated_vertices / 2) * part.names.len() as u64 / all as u64).max(1) as u32;
                let limits = NewVertexLimits { max_estimated_vertices: new, ..limits };
                let plan = blend::BlendPlan::new(
                    part.rim.old_ring(self.options.continuity)?,
                    triangles,
                    limits,
                    taken,
                    None,
                    &job.sub_job(0.4, 0.6),
                )?;
                let Some(plan) = plan else {
                    return Ok(None);
                };
                let made = plan.create_blend(way, &job.sub_job(0.6, 1.0))?;
                let unfaired = if way == BlendFairing::WITHOUT_FAIRING { &made.points } else { &made.unfaired };
                alloc::append(&mut patch.points, &made.points)?;
                alloc::append(&mut patch.points_before_fairing, unfaired)?;
                triangles = made.triangles;
            }
            let name = |v: u32| match (v as usize).checked_sub(part.names.len()) {
                None => part.names[v as usize],
                Some(k) => (first + k) as u32,
            };
            alloc::extend(&mut patch.triangles, triangles.iter().map(|triangle| triangle.map(name)))?;
        }
        self.count_effort(attempt, patch.points.len());
        Ok(is_near_rim(rim, &patch.points).then_some(patch))
    }
}

/// Returns the limits on new vertices for the caller's `limit`, or for 0.
fn new_vertex_limits(limit: u32) -> NewVertexLimits {
    let [new, at_rim] =
        if limit == 0 { [DEFAULT_MAX_NEW_VERTICES, DEFAULT_MAX_NEW_PER_RIM_VERTEX] } else { [limit, 0] };
    NewVertexLimits { max_estimated_vertices: new, max_vertices_per_rim_vertex: at_rim, max_side_growth: f64::INFINITY }
}

/// Returns the nearest point on the triangles for each point.
fn project_onto_triangles(
    rim: &[DVec3],
    triangles: &[[u32; 3]],
    points: &[DVec3],
    job: &Job<'_>,
) -> Result<Vec<DVec3>> {
    let places = nearest_places(rim, triangles, points, "refining", job)?;
    let at = |v: u32| rim[v as usize];
    alloc::collect(places.iter().map(|&(of, weights)| of.into_iter().zip(weights).map(|(v, w)| w * at(v)).sum()))
}

fn is_near_rim(rim: &PatchRim, points: &[DVec3]) -> bool {
    let room = patch_bounds(&rim.points[..rim.rim_vertex_count]);
    points.iter().all(|&p| room.axis_distances(p) == DVec3::ZERO)
}

/// Returns the box that no patch leaves.
pub(super) fn patch_bounds(rim: &[DVec3]) -> Aabb {
    let around = Aabb::from_points(rim);
    around.grown_by(MAX_RELATIVE_BULGE * around.diagonal())
}

/// Returns the triangulation of least weight; `None` if none is found without a taken edge.
pub(super) fn triangulate_rim(
    rim: &PatchRim,
    weight: Weight,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let polygons = rim.loop_polygons()?;
    let [polygon] = polygons.as_slice() else {
        return triangulate_loops_together(&polygons, weight, taken, job);
    };
    let points = polygon.points.as_slice();
    let n = points.len();
    // A planar triangulation without overlaps also has the least area.
    let planar = counts_only_area(weight, points, mean_normal(points));
    if planar
        && n > MAX_EXACT_VERTICES
        && let Some(triangles) = clip_ears(points, taken, &job.sub_job(0.0, 0.1))?
    {
        return flip_to_delaunay(points, triangles, taken, &job.sub_job(0.1, 1.0)).map(Some);
    }
    // On a plane, the surface beyond the rim does not matter.
    let weight = if planar { Weight::Area } else { weight };
    let found =
        minimum_weight_triangulation(polygon, weight, &|i, k| taken(i as u32, k as u32), &job.sub_job(0.1, 1.0))?;
    let Some(triangles) = found else {
        // For a long rim, only chords in bands were tried.
        return if n > MAX_EXACT_VERTICES { clip_ears(points, taken, &job.sub_job(1.0, 1.0)) } else { Ok(None) };
    };
    if planar {
        return flip_to_delaunay(points, triangles, taken, &job.sub_job(1.0, 1.0)).map(Some);
    }
    Ok(Some(triangles))
}

/// Returns true if only the area of triangles counts, because their vertices lie in the plane with
/// this normal.
fn counts_only_area(weight: Weight, points: &[DVec3], normal: DVec3) -> bool {
    matches!(weight, Weight::Continuation | Weight::Area) && is_planar(points, normal)
}

/// Flips edges to the Delaunay criterion.
fn flip_to_delaunay(
    points: &[DVec3],
    triangles: Vec<[u32; 3]>,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Vec<[u32; 3]>> {
    let mut mesh = PatchMesh::new(alloc::copied(points)?, triangles)?;
    mesh.flip_edges_to_delaunay(points.len(), &taken, job)?;
    Ok(mesh.triangles)
}
