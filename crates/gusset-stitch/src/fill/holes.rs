//! Filling the selected holes of a mesh, step by step.

use super::cheapest::cheapest;
use super::choose::choose;
use super::fill_request::{Fairing, Filled, Options, Refinement, Selection, Together};
use super::filling::Filling;
use super::groups::groups;
use super::result::{Made, result};
use crate::boundary::{self, Survey, boundary_loops};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round
/// them.
///
/// Loops that are given have their vertices in order, in either direction, each consecutive pair (and
/// the last with the first) being an edge with exactly one face. All loops that the mesh has are cut
/// into simple ones where the boundary touches itself. Loops that cannot be filled are left, and the
/// account of each says why; nothing of this is an error.
///
/// **Several loops** get one patch, a surface of genus 0 between them, if the caller says so or
/// [`Together::Cheapest`] finds that it costs less. Loops of a group that are left for reasons of
/// their own do not count. If the others cannot be closed together, by a search that is not complete,
/// or two of them share a vertex, all of them are left; `Cheapest` leaves such loops apart. It tries
/// loops that are near each other, at most 8 pairs for each loop, 256 in all, and joins at most 16.
/// By area alone the ends of a short tube cost less together, along the tube itself.
///
/// A loop of n <= 128 vertices gets its triangulation of least weight by dynamic programming over
/// all chords, in O(n^3); by area it is the least there is. A longer one is searched from coarse to
/// fine, in O(n); a long planar one is cut ear by ear, in O(n log n), and its edges flipped to
/// Delaunay's rule. No new edge joins two vertices of one old face, so that a result that is closed
/// stays so when its polygons are cut into triangles. A planar hole, also one round islands, is
/// triangulated without overlaps by the default weight and by the area, however concave it is, if its
/// rim does not cross itself.
///
/// Where creases of the old surface end at the rim, sharp edges far above what is usual there, and two
/// fit each other, or three and more point at one place, they go on across the patch, along chords if
/// there are no new vertices, and the parts between them are filled one by one. The patch is smooth
/// otherwise.
///
/// Faces of a patch that cut each other or old faces are looked for, exactly. Where there are any,
/// less fairing, the other weights and no new vertices are tried, and what cuts least is taken;
/// [`Filled::intersections`] has what is left. No faired vertex leaves the box round its rims, larger
/// on all sides by half its diagonal.
///
/// Several loops take O(n log n) for n vertices in all if they are few, and O(n^3) if they are many.
/// O(H) for H half-edges besides (O(H log d) where the boundary is odd), and what refinement and
/// fairing of m new vertices need: O(m^1.5). The search for cuts takes O(n log n) for n faces near
/// the holes, and time for each pair whose boxes overlap, in the worst case O(n^2). Extra memory is
/// linear.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a limit that is no number or negative; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn fill_holes(mesh: &MeshView<'_>, selection: Selection<'_>, options: &Options, job: &Job<'_>) -> Result<Filled> {
    let limits = &options.limits;
    let named = [("max_length", limits.length), ("max_diameter", limits.diameter), ("max_area", limits.area)];
    for (option, limit) in named {
        let limit = limit.unwrap_or(0.0);
        Error::require(limit >= 0.0, option, limit)?;
    }
    if options.fairing == Fairing::ThinPlate && options.refinement == Refinement::None {
        job.note("fairing moves the new vertices inside holes, and none were asked for: it does nothing");
    }
    let survey = boundary::Options { survey: Survey::BoundaryOnly, ..boundary::Options::default() };
    let boundary = boundary_loops(mesh, &survey, &job.part(0.0, 0.2))?;
    let candidates = choose(mesh, &boundary, selection, options)?;
    if options.plan_only {
        return result(Made::nothing(mesh), &candidates, options, &job.part(0.2, 1.0));
    }
    let mut passes = alloc::filled(0u8, mesh.positions().len())?;
    for found in boundary.iter() {
        found.vertices.iter().for_each(|&v| passes[v as usize] = passes[v as usize].saturating_add(1));
    }
    let mut groups = groups(&candidates, selection, options.together)?;
    if options.together == Together::Cheapest && !matches!(selection, Selection::Groups(_)) {
        groups = cheapest(mesh, &passes, &candidates, &groups, options.weight, &job.part(0.2, 0.4))?;
    }
    let mut filling = Filling::new(mesh, &candidates, &groups, &passes, options, &job.part(0.4, 0.45))?;
    filling.fill(&job.part(0.45, 0.8))?;
    result(filling.made, &candidates, options, &job.part(0.8, 1.0))
}
