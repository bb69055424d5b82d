//! Holes: Closes holes by new triangles.
//!
//! @source G. Barequet and M. Sharir (1995); P. Liepa (2003).

use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::input::{self, read_choice, read_flag};
use crate::capi::mesh::fill_report::{FillResult, gusset_fill_report, gusset_fill_weight};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{
    GUSSET_FAIRING_NONE, GUSSET_FAIRING_THIN_PLATE, GUSSET_FINISH_STRIP, gusset_fairing, gusset_finish,
    gusset_intersections, gusset_outward, to_outward,
};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status::GUSSET_ERROR_NULL_ARGUMENT;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::fill::{Continuity, Fairing, Keep, Limits, LoopSelection, Options, Refinement, Together, fill_holes};
use crate::mesh::MAX_ELEMENTS;
use crate::repair::orient::Outward;
use gusset_base::alloc;

/// Loops that are not holes, if all loops are selected. Except with GUSSET_KEEP_NONE, loops also
/// stay open by GUSSET_HOLE_UNSEWN.
pub type gusset_fill_keep = u32;
/// Outer borders of sheets, and borders of loose faces.
/// - A component is a sheet if its area vector's length is at least 3/4 of its area. Its outer
///   border is the loop whose area vector reaches farthest along the component's.
/// - A component is loose if one loop passes all its vertices, like a single face.
pub const GUSSET_KEEP_AUTO: gusset_fill_keep = 0;
/// All loops are holes.
pub const GUSSET_KEEP_NONE: gusset_fill_keep = 1;
/// The longest loop (the first of equals).
pub const GUSSET_KEEP_LONGEST: gusset_fill_keep = 2;
/// Outer borders of sheets and shallow bowls: loops whose area vector has a positive dot product
/// with the component's. Its length is at least half the component's area.
pub const GUSSET_KEEP_BORDERS: gusset_fill_keep = 3;

/// Loops that share a patch.
pub type gusset_fill_together = u32;
/// Each loop gets its own patch.
pub const GUSSET_TOGETHER_APART: gusset_fill_together = 0;
/// All filled loops share one patch of genus 0. Unless coplanar, at most about 160 loops.
pub const GUSSET_TOGETHER_ONE: gusset_fill_together = 1;
/// Loops share a patch where it weighs less than separate patches.
/// - Pairs are tried whose boxes, grown by half their diagonals, overlap: about 8 a loop and 256 in
///   all (the log says if exceeded).
/// - The largest relative gain comes first. A patch has at most 16 loops.
/// - With GUSSET_WEIGHT_AREA, a short tube's ends share a patch along the tube.
pub const GUSSET_TOGETHER_CHEAPEST: gusset_fill_together = 2;

/// New vertices of patches.
pub type gusset_fill_refinement = u32;
/// No new vertices.
pub const GUSSET_REFINE_NONE: gusset_fill_refinement = 0;
/// New vertices as dense as those around the hole.
pub const GUSSET_REFINE_RIM_DENSITY: gusset_fill_refinement = 1;

/// Smoothness between faired patches and the old surface.
pub type gusset_fill_continuity = u32;
/// Tangent continuity: fairing minimises the squared Laplacian.
pub const GUSSET_CONTINUITY_C1: gusset_fill_continuity = 0;
/// Curvature continuity: fairing minimises the squared gradient of the Laplacian. Two rings of old
/// faces at the rim determine it, with their noise.
pub const GUSSET_CONTINUITY_C2: gusset_fill_continuity = 1;

/// Options of gusset_fill. Default: all holes, without new vertices.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_options {
    /// sizeof(gusset_fill_options).
    pub struct_size: usize,
    /// Weight that the triangulation of a hole minimises.
    pub weight: gusset_fill_weight,
    /// New vertices of patches.
    pub refine: gusset_fill_refinement,
    /// Positions of new vertices; ignored without them.
    pub fairing: gusset_fairing,
    /// Loops that are not holes, if all loops are selected.
    pub keep: gusset_fill_keep,
    /// Patch faces that intersect each other or old faces: AUTO avoids, REPORT reports, IGNORE
    /// ignores them.
    pub intersections: gusset_intersections,
    /// 1: only reports which loops would be filled, by which weight and finish, without predicting
    /// failed triangulations and shared patches.
    /// @flag
    pub plan_only: u32,
    /// Approximate limit on a patch's new vertices, kept by larger triangles, within a factor of 2.
    /// 0: 50,000, or 4 a rim vertex if more; twice that for sharp angles.
    pub max_new_vertices: u32,
    /// Most edges of a loop to fill; 0: any.
    pub max_edges: u32,
    /// Largest length of a loop to fill, at least 0; 0: any.
    pub max_length: f64,
    /// As max_length, for diameter of gusset_hole.
    pub max_diameter: f64,
    /// As max_length, for area of gusset_hole.
    pub max_area: f64,
    /// Side that closed components face.
    pub outward: gusset_outward,
    /// Loops that share a patch.
    pub together: gusset_fill_together,
    /// Group of each given loop; the group's loops share a patch of genus 0, except loops left open
    /// for their own reasons. NULL: together decides.
    /// @shape loop_count
    pub groups: *const u32,
    /// Smoothness between faired patches and the old surface.
    pub continuity: gusset_fill_continuity,
    /// 1: creases of the old surface end at the rim.
    /// @flag
    pub ignore_creases: u32,
    /// Surface between the rims, or in a hole.
    pub finish: gusset_finish,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_fill_options: 72 reserved }

c_enum! {
    fairing: Fairing { GUSSET_FAIRING_NONE => None, GUSSET_FAIRING_THIN_PLATE => ThinPlate }
    continuity: Continuity { GUSSET_CONTINUITY_C1 => C1, GUSSET_CONTINUITY_C2 => C2 }
    keep: Keep {
        GUSSET_KEEP_AUTO => Auto,
        GUSSET_KEEP_NONE => None,
        GUSSET_KEEP_LONGEST => Longest,
        GUSSET_KEEP_BORDERS => OuterBorders,
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
            GUSSET_REFINE_NONE if self.finish == GUSSET_FINISH_STRIP => Refinement::None,
            GUSSET_REFINE_NONE | GUSSET_REFINE_RIM_DENSITY => Refinement::RimDensity(self.max_new_vertices),
            other => {
                return Err(Failure::unknown_choice(
                    "refine",
                    other,
                    &constants![GUSSET_REFINE_NONE, GUSSET_REFINE_RIM_DENSITY],
                ));
            }
        };
        let limits = Limits {
            edges: (self.max_edges != 0).then_some(self.max_edges),
            length: (self.max_length != 0.0).then_some(self.max_length),
            diameter: (self.max_diameter != 0.0).then_some(self.max_diameter),
            area: (self.max_area != 0.0).then_some(self.max_area),
        };
        Ok(Options {
            weight: read_choice(self.weight)?,
            finish: read_choice(self.finish)?,
            refinement,
            fairing: read_choice(self.fairing)?,
            continuity: read_choice(self.continuity)?,
            ignore_creases: read_flag(self.ignore_creases, "ignore_creases")?,
            intersections: read_choice(self.intersections)?,
            limits,
            keep: read_choice(self.keep)?,
            together: read_choice(self.together)?,
            plan_only: read_flag(self.plan_only, "plan_only")?,
            outward: to_outward(self.outward, Outward::Keep)?,
        })
    }

    /// Copies the loops' group numbers.
    fn read_groups(self, loops: *const gusset_indices, count: usize) -> Result<Option<Vec<u32>>, Failure> {
        if self.groups.is_null() {
            return Ok(None);
        }
        if loops.is_null() {
            return Err(Failure::new(
                GUSSET_ERROR_NULL_ARGUMENT,
                "loops is NULL beside groups; pass the loops, or NULL for groups",
            ));
        }
        input::copy_input_items(self.groups, count, "groups").map(Some)
    }
}

/// Copies the caller's loops; `None` means all.
fn read_loops(loops: *const gusset_indices, count: usize) -> Result<Option<Vec<Vec<u32>>>, Failure> {
    Error::check_count("loops", count as u64, MAX_ELEMENTS)?;
    if loops.is_null() {
        return if count == 0 { Ok(None) } else { Err(Failure::null_argument("loops")) };
    }
    let list = |i| {
        let found = mesh::read_indices(loops.wrapping_add(i), "data").map(Option::unwrap_or_default);
        found.map_err(|failure| failure.with_item("loops", i))
    };
    alloc::try_collect((0..count).map(list)).map(Some)
}

/// Fills holes by triangles, oriented like the surrounding surface.
///
/// Loops that cannot be filled, and outer borders of sheets, stay open; see gusset_hole_status. New
/// vertices come after the old; new triangles after the old faces, hole by hole. gusset_join with
/// fill 1 and max_gap 0 sews coincident borders first.
/// - No new edge joins two vertices of an old face: a closed result stays closed if its polygons
///   are triangulated.
/// - With the default weight or GUSSET_WEIGHT_AREA, planar holes whose rims do not cross, even with
///   islands, get no overlapping triangles.
/// - In a patch of one loop, creases continue: matching pairs are joined, three or more meet in a
///   new vertex. Without new vertices, only straight pairs are joined. Other creases end at the
///   rim.
/// - Loops of a shared patch stay open if two share a vertex, or the search (not exhaustive) fails.
///   GUSSET_TOGETHER_CHEAPEST gives them separate patches.
/// - A patch that intersects itself or other faces, by an exact test, is retried with less fairing,
///   other weights and no new vertices. The fewest intersections win; see gusset_hole.
/// - Faired vertices stay in the rims' box, grown on all sides by half its diagonal.
///
/// @param loops each as loop_a of gusset_stitch; NULL with loop_count 0: all loops.
/// @errors as gusset_mesh_view, INDEX_OUT_OF_RANGE (input is the loop, index the place in it),
///     NULL_ARGUMENT (groups without loops), OUT_OF_RANGE, TOO_LARGE
/// @complexity O(n^3) time, 30 n^2 bytes for a loop of n <= 128 vertices. Otherwise linear memory:
///     O(n), coarse to fine; planar O(n log n); shared patches O(n log n) for few loops, O(n^3) for
///     many. Also O(H log d), O(m^1.5) for m new vertices of a hole, and O(n log n), at worst
///     O(n^2), for intersections with n faces near holes.
/// @source Barequet and Sharir 1995; Liepa 2003.
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
    create_handle(context, result, "result", |job| {
        let given_options = input::read_versioned_struct(options, true, "options")?;
        let options = given_options.checked()?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let mesh = given_mesh.mesh_view();
        let given = read_loops(loops, loop_count)?;
        let merged = |loops: Vec<Vec<u32>>| {
            alloc::gather(loops.into_iter().map(|vertices| mesh::map_to_merged_vertices(&mesh, vertices)))
        };
        let given = given.map(merged).transpose()?;
        let slices = given.as_ref().map(|loops| alloc::collect(loops.iter().map(Vec::as_slice))).transpose()?;
        let numbers = given_options.read_groups(loops, loop_count)?;
        let groups = match (&slices, &numbers) {
            (Some(loops), Some(numbers)) => alloc::collect(loops.iter().copied().zip(numbers.iter().copied()))?,
            _ => Vec::new(),
        };
        let selection = match (&slices, &numbers) {
            (None, _) => LoopSelection::All,
            (Some(loops), None) => LoopSelection::Loops(loops),
            (Some(_), Some(_)) => LoopSelection::Groups(&groups),
        };
        let mut filled = fill_holes(&mesh, selection, &options, &job.sub_job(0.1, 0.95))?;
        filled.keep_split_vertices(&[&mesh], &job.sub_job(0.95, 1.0))?;
        Ok(gusset_result(OperationResult::Fill(FillResult::new(filled)?)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_fill(
    result: *const gusset_result,
    report: *mut gusset_fill_report,
) -> gusset_status {
    report!(result, report, "gusset_fill", OperationResult::Fill(fill) => fill.fill_report())
}
