//! Holes: Closes holes by new triangles.
//!
//! @source G. Barequet and M. Sharir (1995); P. Liepa (2003).

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice, flag};
use crate::capi::mesh::fill_report::{Fill, gusset_fill_report, gusset_fill_weight};
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::stitch_options::{
    GUSSET_FAIRING_NONE, GUSSET_FAIRING_THIN_PLATE, gusset_fairing, gusset_intersections, gusset_outward, outward,
};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status::GUSSET_ERROR_NULL_ARGUMENT;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::fill::{Continuity, Fairing, Keep, Limits, Options, Refinement, Selection, Together, fill_holes};
use crate::mesh::MAX_ELEMENTS;
use crate::repair::orient::Outward;
use gusset_base::alloc;

/// The loops that are not holes.
pub type gusset_fill_keep = u32;
/// All loops are holes.
pub const GUSSET_KEEP_NONE: gusset_fill_keep = 0;
/// The longest loop is none: the outline of an open sheet.
pub const GUSSET_KEEP_LONGEST: gusset_fill_keep = 1;
/// Loops are none that go round a sheet rather than a hole in it, so that a patch would lie on the
/// sheet: whose area vector points as that of their component, and is at least half as long as its
/// area.
pub const GUSSET_KEEP_BORDERS: gusset_fill_keep = 2;

/// The loops that get one patch.
pub type gusset_fill_together = u32;
/// Each loop gets a patch of its own.
pub const GUSSET_TOGETHER_APART: gusset_fill_together = 0;
/// All loops that are filled get one patch: a surface of genus 0 between them. If they are not in one
/// plane, up to some 160 loops.
pub const GUSSET_TOGETHER_ONE: gusset_fill_together = 1;
/// Loops get one patch where that costs less, by the weight asked for, than patches of their own.
/// Loops whose boxes, each larger on all sides by half its diagonal, meet are tried, the pair that
/// gains most first: about 8 pairs for each loop and 256 in all, as the log says, and at most 16
/// loops for a patch. By area alone the ends of a short tube cost less together, along the tube
/// itself.
pub const GUSSET_TOGETHER_CHEAPEST: gusset_fill_together = 2;

/// The new vertices of patches.
pub type gusset_fill_refinement = u32;
/// No new vertices.
pub const GUSSET_REFINE_NONE: gusset_fill_refinement = 0;
/// New vertices as dense as those round the hole.
pub const GUSSET_REFINE_RIM_DENSITY: gusset_fill_refinement = 1;

/// How smoothly faired patches continue the old surface.
pub type gusset_fill_continuity = u32;
/// Faired patches leave the old surface along its tangent planes: the plate's squared Laplacian is
/// least.
pub const GUSSET_CONTINUITY_C1: gusset_fill_continuity = 0;
/// They go on with its curvature, too: the squared gradient of the Laplacian is least. Two rings of old
/// faces round each rim have a say, and with them their noise.
pub const GUSSET_CONTINUITY_C2: gusset_fill_continuity = 1;

/// How holes are filled; all zero is the default: triangles without new vertices, in every hole.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_options {
    /// sizeof(gusset_fill_options), set by the caller.
    pub struct_size: usize,
    /// The weight that the triangulation of a rim minimises.
    pub weight: gusset_fill_weight,
    /// The new vertices of patches.
    pub refine: gusset_fill_refinement,
    /// Read if new vertices are asked for; otherwise the log says that it is not.
    pub fairing: gusset_fairing,
    /// Which loops are no holes; read if all loops are asked for.
    pub keep: gusset_fill_keep,
    /// Whether faces of patches that cut each other or old faces are looked for, and
    /// avoided by less fairing, other weights and no new vertices (AUTO), only reported
    /// (REPORT), or neither (IGNORE).
    pub intersections: gusset_intersections,
    /// 1: nothing is filled or turned over; the accounts say which loops would be tried, and with
    /// which weight and finish. Loops that turn out to have no triangulation are not foreseen, nor
    /// which of them together says get one patch. 0 or 1.
    /// @flag
    pub plan_only: u32,
    /// About how many new vertices a patch gets, at most about twice as many; where more would be
    /// needed the triangles are larger. 0: 50,000, or four for each vertex of its rims if that is
    /// more, and as many again for sharp angles there.
    pub max_new_vertices: u32,
    /// Loops of more edges are left alone. 0 is no limit.
    pub max_edges: u32,
    /// Longer loops are left alone, in the unit of the positions, at least 0. 0 is no limit.
    pub max_length: f64,
    /// Loops in a box along the axes with a longer diagonal are left alone. 0 is no limit.
    pub max_diameter: f64,
    /// Loops with a larger area, as gusset_hole has it, are left alone. 0 is no limit.
    pub max_area: f64,
    /// What becomes of closed components of the result, patches and all.
    pub outward: gusset_outward,
    /// Which loops get one patch; read without groups.
    pub together: gusset_fill_together,
    /// A number for each of the loops given, loop_count in all: those with the same number get one
    /// patch, a surface of genus 0 between them, but for loops that are left for reasons of their
    /// own. NULL: as together says. Needs loops.
    pub groups: *const u32,
    /// How smoothly faired vertices go on the surface round the hole.
    pub continuity: gusset_fill_continuity,
    /// 1: creases of the old surface that end at a rim end there, and no patch goes on with them. 0 or
    /// 1.
    /// @flag
    pub ignore_creases: u32,
}

versioned! { gusset_fill_options: 72 }

c_enum! {
    fairing: Fairing { GUSSET_FAIRING_NONE => None, GUSSET_FAIRING_THIN_PLATE => ThinPlate }
    continuity: Continuity { GUSSET_CONTINUITY_C1 => C1, GUSSET_CONTINUITY_C2 => C2 }
    keep: Keep {
        GUSSET_KEEP_NONE => None,
        GUSSET_KEEP_LONGEST => Longest,
        GUSSET_KEEP_BORDERS => Borders,
    }
    together: Together {
        GUSSET_TOGETHER_APART => Apart,
        GUSSET_TOGETHER_ONE => One,
        GUSSET_TOGETHER_CHEAPEST => Cheapest,
    }
}

impl gusset_fill_options {
    pub(crate) fn checked(self) -> Result<Options, Failure> {
        let refinement = match self.refine {
            GUSSET_REFINE_NONE => Refinement::None,
            GUSSET_REFINE_RIM_DENSITY => Refinement::RimDensity(self.max_new_vertices),
            other => return Err(Failure::unknown("refine", other.into())),
        };
        let limits = Limits {
            edges: (self.max_edges != 0).then_some(self.max_edges),
            length: (self.max_length != 0.0).then_some(self.max_length),
            diameter: (self.max_diameter != 0.0).then_some(self.max_diameter),
            area: (self.max_area != 0.0).then_some(self.max_area),
        };
        Ok(Options {
            weight: choice(self.weight)?,
            refinement,
            fairing: choice(self.fairing)?,
            continuity: choice(self.continuity)?,
            ignore_creases: flag(self.ignore_creases, "ignore_creases")?,
            intersections: choice(self.intersections)?,
            limits,
            keep: choice(self.keep)?,
            together: choice(self.together)?,
            plan_only: flag(self.plan_only, "plan_only")?,
            outward: outward(self.outward, Outward::Keep)?,
        })
    }

    /// The numbers of the loops' groups, copied.
    fn groups(self, loops: *const gusset_indices, count: usize) -> Result<Option<Vec<u32>>, Failure> {
        if self.groups.is_null() {
            return Ok(None);
        }
        if loops.is_null() {
            return Err(Failure::new(GUSSET_ERROR_NULL_ARGUMENT, "groups are given, but loops is NULL"));
        }
        input::list(self.groups, count, "groups").map(Some)
    }
}

/// The caller's loops, copied; `None` for all.
fn given(loops: *const gusset_indices, count: usize) -> Result<Option<Vec<Vec<u32>>>, Failure> {
    Error::check_count("loops", count as u64, MAX_ELEMENTS)?;
    if loops.is_null() {
        return if count == 0 { Ok(None) } else { Err(Failure::null("loops")) };
    }
    let list = |i| {
        let found = mesh::indices(loops.wrapping_add(i), "the data of a loop").map(Option::unwrap_or_default);
        found.map_err(|failure| failure.of_item(i))
    };
    alloc::try_collect((0..count).map(list)).map(Some)
}

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round
/// them.
///
/// Loops that cannot be filled are left, which is no error: the account of each says why.
///
/// The result has the old vertices with their bits and indices, then the new ones; the old faces,
/// which are turned over only if outward says so, then the new triangles, hole by hole. No new edge
/// joins two vertices of one old face, so that a result that is closed stays so when its polygons are
/// cut into triangles. A planar hole gets no overlaps by the default weight and by area, however
/// concave it is, also one round islands, if its rims do not cross.
///
/// Creases of the old surface that end at a rim go on across the patch, by plain triangles where they
/// are straight: joined in pairs, or three and more in a new vertex where they meet. A crease without
/// a counterpart ends at the rim. Patches of several loops have none, and with ignore_creases none
/// has.
///
/// Several loops get one patch where options.groups or options.together says so: a surface of genus 0
/// between them. If none is found, by a search that is not complete, or two of the loops share a
/// vertex, all of them are left; GUSSET_TOGETHER_CHEAPEST leaves such loops apart.
///
/// Faces of a patch that cut each other or old faces are looked for, exactly. Where there are any,
/// less fairing, the other weights and no new vertices are tried, and what cuts least is taken; the
/// view has the pairs that are left. No faired vertex leaves the box round its rims, larger on all
/// sides by half its diagonal.
///
/// @param loops the vertices of each loop in order, in either direction, each consecutive pair (and
///     the last with the first) an edge with exactly one face; loop_count of them. NULL with 0: all
///     loops that the mesh has.
/// @param loop_count see loops.
/// @errors as gusset_mesh_view, INDEX_OUT_OF_RANGE (with the place in the loop, whose number is the
///     report's input), NULL_ARGUMENT (groups without loops), OUT_OF_RANGE, TOO_LARGE
/// @complexity Loops of n <= 128 vertices: O(n^3) time and 30 n^2 bytes, the best triangulation (of
///     least area: exactly); longer ones: from coarse to fine, O(n), or, if they are planar, ear by
///     ear, O(n log n); linear memory. Several loops of n vertices in all: O(n log n) if they are
///     few, O(n^3) if they are many. Besides O(H log d) for H half-edges and at most d edges at a
///     vertex, and O(m^1.5) for m new vertices of a hole. The search for cuts: O(n log n) for n
///     faces near the holes, and the pairs whose boxes overlap, in the worst case O(n^2). Loops
///     that touch at one vertex look at each other's edges there.
/// @source Barequet and Sharir 1995; Liepa, Filling holes in meshes, 2003.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    loops: *const gusset_indices,
    loop_count: usize,
    options: *const gusset_fill_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let given_options = input::read(options, true, "options")?;
        let options = given_options.checked()?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let mesh = given_mesh.view();
        let given = given(loops, loop_count)?;
        let merged =
            |loops: Vec<Vec<u32>>| alloc::gather(loops.into_iter().map(|vertices| mesh::merged(&mesh, vertices)));
        let given = given.map(merged).transpose()?;
        let slices = given.as_ref().map(|loops| alloc::collect(loops.iter().map(Vec::as_slice))).transpose()?;
        let numbers = given_options.groups(loops, loop_count)?;
        let groups = match (&slices, &numbers) {
            (Some(loops), Some(numbers)) => alloc::collect(loops.iter().copied().zip(numbers.iter().copied()))?,
            _ => Vec::new(),
        };
        let selection = match (&slices, &numbers) {
            (None, _) => Selection::All,
            (Some(loops), None) => Selection::Loops(loops),
            (Some(_), Some(_)) => Selection::Groups(&groups),
        };
        let mut filled = fill_holes(&mesh, selection, &options, &job.part(0.1, 0.95))?;
        filled.keep_splits(&[&mesh], &job.part(0.95, 1.0))?;
        Ok(gusset_result(Made::Fill(Fill::new(filled)?)))
    })
}

/// Lends the reports of the loops, for results of gusset_fill.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_fill(
    result: *const gusset_result,
    report: *mut gusset_fill_report,
) -> gusset_status {
    report!(result, report, "gusset_fill", Made::Fill(fill) => fill.report())
}
