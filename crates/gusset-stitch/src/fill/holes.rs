//! Fills the selected holes of a mesh, step by step.

use super::candidate_loops::choose_loops;
use super::fill_request::{Fairing, Filled, LoopSelection, Options, Refinement, Together};
use super::fill_result::{FinishedPatches, build_result};
use super::group_by_cost::group_by_cost;
use super::hole_filling::HoleFilling;
use super::patch_groups::group_candidates_by_patch;
use super::unsewn_loops::UnsewnLoops;
use crate::boundary::{self, Boundary, Survey, boundary_loops};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented like the surface around
/// them.
///
/// Given loops list their vertices in order, in either direction. Consecutive vertices, and the
/// last with the first, must span an edge with exactly one face. With [`LoopSelection::All`],
/// boundaries that touch themselves are cut into simple loops. A loop that cannot be filled is not
/// an error: its report gives the reason. By default the outer borders of sheets stay open, and so
/// do loops along borders that coincide; see [`Keep`](super::Keep).
///
/// **Several loops** share one patch, a surface of genus 0 between them, if the caller asks for it,
/// or if [`Together::Cheapest`] finds that it costs less. Loops of a group that cannot be filled do
/// not count. If the other loops cannot be closed together, or two of them share a vertex, the
/// whole group stays open; `Cheapest` then fills them separately. The search for a common patch is
/// incomplete. `Cheapest` tries loops that are near each other: at most 8 pairs per loop, 256 pairs
/// in all, and at most 16 loops per patch. By area alone, the two ends of a short tube cost less
/// together: their patch runs along the tube.
///
/// **Triangulation.** A loop of n <= 128 vertices gets its triangulation of least weight by dynamic
/// programming over all chords, in O(n^3). For the weight `Area` the result is optimal. A longer
/// loop is searched from coarse to fine, in O(n). A long planar loop is triangulated by ear
/// clipping, in O(n log n), and its edges are flipped to the Delaunay criterion. No new edge joins
/// two vertices of one old face, so a closed result stays closed when its polygons are
/// triangulated. A planar hole whose rim does not intersect itself is triangulated without
/// overlaps, by the default weight and by the area. It may have islands and be concave.
///
/// **Creases.** A crease is an old edge at the rim that is far sharper than the median there. If
/// two creases continue each other, or three or more point at one place, they are continued across
/// the patch; without new vertices, along chords. The parts between them are filled one by one.
/// Elsewhere the patch is smooth.
///
/// **Intersections.** Faces of a patch that intersect each other or old faces are found exactly. If
/// there are any, the search also tries less fairing, the other weights and no new vertices. It
/// keeps the patch with the fewest intersections; [`Filled::intersections`] lists the remaining
/// ones. Faired vertices stay in the box of their rims, enlarged on all sides by half its diagonal.
///
/// **Complexity.** O(H) for H half-edges (O(H log d) at a non-manifold boundary), plus O(m^1.5) to
/// refine and fair m new vertices. Several loops with n vertices in all take O(n log n) if the
/// loops are few, and O(n^3) if they are many. Finding intersections takes O(n log n) for n faces
/// near the holes, plus time for each pair of overlapping boxes: O(n^2) in the worst case. Extra
/// memory is linear.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a limit that is negative or not a number; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn fill_holes(
    mesh: &MeshView<'_>,
    selection: LoopSelection<'_>,
    options: &Options,
    job: &Job<'_>,
) -> Result<Filled> {
    let survey = HoleSurvey::new(mesh, selection, &job.sub_job(0.0, 0.25))?;
    let coincident = survey.coincident_edges();
    if coincident > 0 {
        job.note(&format!("boundary edges that coincide with others: {coincident}; sew them first, as a join does"));
    }
    survey.fill(options, &job.sub_job(0.25, 1.0))
}

/// The boundary loops of a mesh before its holes are filled.
pub struct HoleSurvey<'m, 'a> {
    mesh: &'m MeshView<'a>,
    selection: LoopSelection<'m>,
    boundary: Boundary,
    unsewn: UnsewnLoops,
}

impl<'m, 'a> HoleSurvey<'m, 'a> {
    /// Finds the loops and, if all loops are selected, the boundary edges that coincide with others.
    ///
    /// O(H log d) for H half-edges, and O(n log n) for n boundary edges.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn new(mesh: &'m MeshView<'a>, selection: LoopSelection<'m>, job: &Job<'_>) -> Result<Self> {
        let survey = boundary::Options { survey: Survey::BoundaryOnly, ..boundary::Options::default() };
        let boundary = boundary_loops(mesh, &survey, &job.sub_job(0.0, 0.8))?;
        let unsewn = match selection {
            LoopSelection::All => UnsewnLoops::find(mesh, &boundary, &job.sub_job(0.8, 1.0))?,
            _ => UnsewnLoops::default(),
        };
        Ok(HoleSurvey { mesh, selection, boundary, unsewn })
    }

    /// Returns the number of boundary edges that coincide with another one. Sewing closes the gap
    /// between them.
    pub fn coincident_edges(&self) -> u32 {
        self.unsewn.edges
    }

    /// Fills the selected holes like [`fill_holes`].
    ///
    /// # Errors
    /// As for [`fill_holes`].
    pub fn fill(self, options: &Options, job: &Job<'_>) -> Result<Filled> {
        let HoleSurvey { mesh, selection, boundary, unsewn } = self;
        let limits = options.limits;
        let named = [("max_length", limits.length), ("max_diameter", limits.diameter), ("max_area", limits.area)];
        for (option, limit) in named {
            let limit = limit.unwrap_or(0.0);
            Error::require(limit >= 0.0, option, limit, "at least 0")?;
        }
        let options = &options.with_finish();
        if options.fairing == Fairing::ThinPlate && options.refinement == Refinement::None {
            job.note("fairing does nothing without new vertices inside holes: request a refinement");
        }
        let candidates = choose_loops(mesh, &boundary, selection, &unsewn.is_unsewn, options)?;
        let built = |made, job: &Job<'_>| {
            let filled = build_result(made, &candidates, options, job)?;
            Ok(Filled { coincident_edges: unsewn.edges, ..filled })
        };
        if options.plan_only {
            return built(FinishedPatches::empty(mesh), &job.sub_job(0.0, 1.0));
        }
        let mut loops_through_vertex = alloc::filled(0u8, mesh.positions().len())?;
        for found in boundary.iter() {
            found
                .vertices
                .iter()
                .for_each(|&v| loops_through_vertex[v as usize] = loops_through_vertex[v as usize].saturating_add(1));
        }
        let mut groups = group_candidates_by_patch(&candidates, selection, options.together)?;
        if options.together == Together::Cheapest && !matches!(selection, LoopSelection::Groups(_)) {
            groups = group_by_cost(
                mesh,
                &loops_through_vertex,
                &candidates,
                &groups,
                options.weight,
                &job.sub_job(0.0, 0.2),
            )?;
        }
        let mut filling =
            HoleFilling::new(mesh, &candidates, &groups, &loops_through_vertex, options, &job.sub_job(0.2, 0.25))?;
        filling.build_patches(&job.sub_job(0.25, 0.75))?;
        built(filling.finished_patches, &job.sub_job(0.75, 1.0))
    }
}
