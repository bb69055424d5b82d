//! The steps from coarse triangles to a blend.

use super::old_ring::{MIN_SMOOTH_BEND_COSINE, OldRing};
use crate::fair::mean_curvature;
use crate::remesh::{
    PatchMesh, VertexSizes, estimate_new_vertices, even_out_side_lengths, refine_by_insertion, size_growth_for_limit,
};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Length of new sides, relative to old ones.
const NEW_SIDE_TO_OLD_SIDE_RATIO: f64 = 0.8;
/// Before fairing, sharp triangles are left if their shortest side is below this fraction of the
/// size.
const MIN_RELATIVE_SHORTEST_SIDE: f64 = 0.3;
/// The corresponding fraction in the last step.
const FINAL_MIN_RELATIVE_SHORTEST_SIDE: f64 = 1e-3;
/// Rounds in which vertices move within the surface, before each solution and in the last step.
const VERTEX_MOVE_ROUNDS: [u32; 2] = [2, 5];
/// Smoothing passes over the strip's curvature, which is concentrated in its ridges.
const CURVATURE_SMOOTHING_PASSES: u32 = 10;

/// How a blend is faired.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BlendFairing {
    /// The number of solutions of the plate, each after a refinement.
    pub(crate) rounds: u32,
    /// If true, vertices that would fold a triangle stay behind. The result is less smooth, so this
    /// is used only against intersections.
    pub(crate) unfolds: bool,
}

impl BlendFairing {
    /// No fairing.
    pub(crate) const WITHOUT_FAIRING: BlendFairing = BlendFairing { rounds: 0, unfolds: true };
}

/// Limits on the number of new vertices.
#[derive(Clone, Copy)]
pub(crate) struct NewVertexLimits {
    /// Estimated number of vertices for the sizes. If more are needed, all sides grow. If the
    /// estimate is too low for the shape, there are at most twice as many.
    pub(crate) max_estimated_vertices: u32,
    /// For each rim vertex, the number of new vertices that is always allowed, and the number in
    /// addition for sharp angles.
    pub(crate) max_vertices_per_rim_vertex: u32,
    /// The blend fails if sides must grow by more than this. If this is finite, it also fails if
    /// the limits are reached.
    pub(crate) max_side_growth: f64,
}

/// The replacement of coarse triangles.
pub(crate) struct Blend {
    /// The triangles. Rim vertices keep their numbers, and the new vertices follow.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The new vertices, in the unit of the [`OldRing`] and relative to 0.
    pub(crate) points: Vec<DVec3>,
    /// The positions without fairing.
    pub(crate) unfaired: Vec<DVec3>,
}

/// Moves points from the coarse triangles to a surface that guides the blend.
pub(crate) type GuideSurface<'a> = dyn Fn(&mut [DVec3]) -> Result<()> + 'a;

/// The common start of all fairing attempts.
pub(crate) struct BlendPlan<T: Fn(u32, u32) -> bool> {
    ring: OldRing,
    /// Returns true if two rim vertices must not get an edge.
    is_forbidden_edge: T,
    /// The coarse triangles with refined sides.
    mesh: PatchMesh,
    sizing: VertexSizes,
    /// Creases with a smaller cosine are smoothed out.
    min_cosine: f64,
    /// True for rim vertices at which old creases end.
    is_crease_end: Vec<bool>,
}

impl<T: Fn(u32, u32) -> bool> BlendPlan<T> {
    /// Plans the blend of triangles between the rims; `None` if the limits do not allow a blend.
    /// With a `guide`, the blend follows that surface instead of the coarse triangles.
    /// O(T + n log n) for T triangles and n new vertices.
    pub(crate) fn new(
        mut ring: OldRing,
        triangles: Vec<[u32; 3]>,
        limits: NewVertexLimits,
        taken: T,
        guide: Option<&GuideSurface<'_>>,
        job: &Job<'_>,
    ) -> Result<Option<Self>> {
        let rim = ring.has_laplacian_in_energy.len();
        let (usual, creased) = ring.measure_bends()?;
        // The cosine of twice the angle.
        let min_cosine = MIN_SMOOTH_BEND_COSINE.min(2.0 * usual * usual - 1.0);
        let mut mesh = PatchMesh::new(alloc::copied(&ring.points[..rim])?, triangles)?;
        let mut size = ring.mean_side_lengths_at_rims()?;
        size.iter_mut().for_each(|s| *s *= NEW_SIDE_TO_OLD_SIDE_RATIO);
        let at_rim = limits.max_vertices_per_rim_vertex.saturating_mul(rim as u32);
        let limit = limits.max_estimated_vertices.max(at_rim);
        let needed = estimate_new_vertices(&mesh, &size);
        // Sides of length 0 make the estimate infinite.
        if !needed.is_finite() {
            return Ok(None);
        }
        let needed = needed.min(f64::from(limit));
        let grown = size_growth_for_limit(&mesh, &size, limit);
        if grown > limits.max_side_growth {
            return Ok(None);
        }
        size.iter_mut().for_each(|s| *s *= grown);
        ring.draw_old_vertices_to_rims(&size)?;
        let mut sizing = VertexSizes {
            wanted_side_lengths: size,
            points_before_fairing: alloc::copied(&mesh.points)?,
            curvature: alloc::filled(DVec3::ZERO, rim)?,
            // Twice the estimate, for shapes that need more.
            max_vertices: rim + 2 * needed as usize + at_rim as usize,
            min_shortest_side_in_sizes: MIN_RELATIVE_SHORTEST_SIDE,
        };
        even_out_side_lengths(&mut mesh, rim, &mut sizing, &taken, &job.sub_job(0.0, 0.5))?;
        refine_by_insertion(&mut mesh, rim, &mut sizing, &taken, &job.sub_job(0.5, 0.8))?;
        if limits.max_side_growth.is_finite() && mesh.points.len() >= sizing.max_vertices {
            return Ok(None);
        }
        mesh.move_vertices_within_surface(rim, &taken, VERTEX_MOVE_ROUNDS[0], &job.sub_job(0.8, 1.0))?;
        if let Some(guide) = guide {
            guide(&mut mesh.points[rim..])?;
            sizing.points_before_fairing.copy_from_slice(&mesh.points);
        }
        let closed = |v: usize| v >= rim;
        sizing.curvature =
            mean_curvature(&mesh.points, &mesh.triangles, &closed, CURVATURE_SMOOTHING_PASSES, &job.sub_job(1.0, 1.0))?;
        Ok(Some(BlendPlan { ring, is_forbidden_edge: taken, mesh, sizing, min_cosine, is_crease_end: creased }))
    }

    /// Creates the blend. For n new vertices O(n log n), plus O(n^1.5) for the plate; nearly linear
    /// on a narrow strip.
    pub(crate) fn create_blend(&self, way: BlendFairing, job: &Job<'_>) -> Result<Blend> {
        let (ring, taken, rim) = (&self.ring, &self.is_forbidden_edge, self.ring.has_laplacian_in_energy.len());
        let (mut mesh, mut sizing) = (self.mesh.try_clone()?, self.sizing.try_clone()?);
        for round in 0..way.rounds {
            let part = job.sub_job(0.0, 0.6).sub_job_of_item(round as usize, way.rounds as usize);
            if round > 0 {
                refine_by_insertion(&mut mesh, rim, &mut sizing, taken, &part.sub_job(0.0, 0.3))?;
                mesh.move_vertices_within_surface(rim, taken, VERTEX_MOVE_ROUNDS[0], &part.sub_job(0.3, 0.4))?;
                if let Some(passes) = ring.smoothing_passes_of_rest_curvature {
                    sizing.curvature = ring.smoothed_curvature_of_patch(&mesh, passes, &part.sub_job(0.4, 0.4))?;
                }
            }
            ring.fair_patch(&mut mesh, &sizing, way.unfolds, &part.sub_job(0.4, 1.0))?;
        }
        mesh.iron_out_creases(rim, self.min_cosine, &self.is_crease_end, &job.sub_job(0.6, 0.7))?;
        sizing.min_shortest_side_in_sizes = FINAL_MIN_RELATIVE_SHORTEST_SIDE;
        refine_by_insertion(&mut mesh, rim, &mut sizing, taken, &job.sub_job(0.7, 0.8))?;
        mesh.move_vertices_within_surface(rim, taken, VERTEX_MOVE_ROUNDS[1], &job.sub_job(0.8, 1.0))?;
        let back = |points: &[DVec3]| alloc::collect(points[rim..].iter().map(|&p| p + ring.origin));
        Ok(Blend {
            points: back(&mesh.points)?,
            unfaired: back(&sizing.points_before_fairing)?,
            triangles: mesh.triangles,
        })
    }
}
