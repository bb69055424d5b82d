//! C interface: hole filling.

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, choice, flag, lent};
use crate::capi::mesh::stitch::gusset_quality_report;
use crate::capi::mesh::stitch_options::{GUSSET_FAIRING_NONE, GUSSET_FAIRING_THIN_PLATE};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status::GUSSET_ERROR_NULL_ARGUMENT;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::fill::{
    Continuity, Fairing, Filled, Finish, Hole, HoleStatus, Keep, Limits, Options, Refinement, Selection, Together,
    Weight, fill_holes,
};
use crate::mesh::MAX_ELEMENTS;
use gusset_base::alloc;

/// The best continuation of the surface round the hole: the least sum of 2 sin(t / 2) over all edges,
/// the rim's included, t being the angle between the normals on both sides, and over the triangles of
/// the mean square of how far the surface that was there is likely to have been from them, as its
/// tangent planes at the rim say, in units of 1 / 140 of its length. By area alone if it is planar.
pub const GUSSET_WEIGHT_CONTINUATION: u32 = 0;
/// The least sum of areas and, for each edge, the rim's included, squared length times 1 - cosine
/// of the angle between its faces.
pub const GUSSET_WEIGHT_AREA_AND_BEND: u32 = 1;
/// The least largest angle between neighbouring faces, those beyond the rim included, and then the
/// least area, as Liepa has it.
pub const GUSSET_WEIGHT_BEND_THEN_AREA: u32 = 2;
/// The least area, exactly.
pub const GUSSET_WEIGHT_AREA: u32 = 3;

/// All loops are holes.
pub const GUSSET_KEEP_NONE: u32 = 0;
/// The longest loop is none: the outline of an open sheet.
pub const GUSSET_KEEP_LONGEST: u32 = 1;
/// Loops are none that go round a sheet rather than a hole in it, so that a patch would lie on the
/// sheet: whose area vector points as that of their component, and is at least half as long as its
/// area.
pub const GUSSET_KEEP_BORDERS: u32 = 2;

/// Each loop gets a patch of its own.
pub const GUSSET_TOGETHER_APART: u32 = 0;
/// All loops that are filled get one patch: a surface of genus 0 between them. If they are not in one
/// plane, up to some 160 loops.
pub const GUSSET_TOGETHER_ONE: u32 = 1;
/// Loops get one patch where that costs less, by the weight asked for, than patches of their own.
/// Loops whose boxes, each larger on all sides by half its diagonal, meet are tried, the pair that
/// gains most first: about 8 pairs for each loop and 256 in all, as the log says, and at most 16
/// loops for a patch. By area alone the ends of a short tube cost less together, along the tube
/// itself.
pub const GUSSET_TOGETHER_CHEAPEST: u32 = 2;

/// Triangles between the vertices of the rims.
pub const GUSSET_PATCH_PLAIN: u32 = 0;
/// With new vertices, where the plain triangles are, but for those beside creases that go on.
pub const GUSSET_PATCH_REFINED: u32 = 1;
/// With new vertices, faired.
pub const GUSSET_PATCH_FAIRED: u32 = 2;

/// No new vertices.
pub const GUSSET_REFINE_NONE: u32 = 0;
/// New vertices as dense as those round the hole.
pub const GUSSET_REFINE_RIM_DENSITY: u32 = 1;

/// Faired patches leave the old surface along its tangent planes: the plate's squared Laplacian is
/// least.
pub const GUSSET_CONTINUITY_C1: u32 = 0;
/// They go on with its curvature, too: the squared gradient of the Laplacian is least. Two rings of old
/// faces round each rim have a say, and with them their noise.
pub const GUSSET_CONTINUITY_C2: u32 = 1;

/// Filled; with plan_only, to be filled.
pub const GUSSET_HOLE_FILLED: u32 = 0;
/// Left: it is no hole, as keep has it.
pub const GUSSET_HOLE_KEPT: u32 = 1;
/// Left: it exceeds max_edges, max_length, max_diameter or max_area.
pub const GUSSET_HOLE_TOO_LARGE: u32 = 2;
/// Left: an open chain.
pub const GUSSET_HOLE_OPEN: u32 = 3;
/// Left: it runs along an edge with three or more faces.
pub const GUSSET_HOLE_NON_MANIFOLD: u32 = 4;
/// Left: the faces along it disagree in orientation.
pub const GUSSET_HOLE_NOT_ORIENTED: u32 = 5;
/// Left: a given loop of fewer than three vertices, or one that passes a vertex twice.
pub const GUSSET_HOLE_NOT_SIMPLE: u32 = 6;
/// Left: an edge of a given loop does not have exactly one face, or is one of a loop before it.
pub const GUSSET_HOLE_NOT_FREE: u32 = 7;
/// Left: every triangulation would have an edge between two vertices of one old face, which is an
/// edge of the mesh or becomes one once its polygons are cut into triangles; or none was found that
/// closes all loops together which are to get one patch, as where two of them share a vertex.
pub const GUSSET_HOLE_NO_TRIANGULATION: u32 = 8;

/// A mesh with holes filled. Opaque and immutable; it keeps nothing of the mesh it was made from.
pub struct gusset_fill {
    pub(crate) filled: Filled,
    holes: Vec<gusset_hole>,
}

handle! { gusset_fill }

/// How holes are filled; all zero is the default: triangles without new vertices, in every hole.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_options {
    /// sizeof(gusset_fill_options), set by the caller.
    pub struct_size: usize,
    /// GUSSET_WEIGHT_...
    pub weight: u32,
    /// GUSSET_REFINE_...
    pub refine: u32,
    /// GUSSET_FAIRING_..., read if new vertices are asked for; otherwise the log says that it is not.
    pub fairing: u32,
    /// GUSSET_KEEP_...: which loops are no holes; read if all loops are asked for.
    pub keep: u32,
    /// GUSSET_INTERSECTIONS_...: whether faces of patches that cut each other or old faces are looked
    /// for, and avoided by less fairing, other weights and no new vertices (AUTO), only reported
    /// (REPORT), or neither (IGNORE).
    pub intersections: u32,
    /// 1: nothing is filled or turned over; the accounts say which loops would be tried, and with
    /// which weight and finish. Loops that turn out to have no triangulation are not foreseen, nor
    /// which of them together says get one patch. 0 or 1.
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
    /// GUSSET_OUTWARD_...: what becomes of closed components of the result, patches and all.
    pub outward: u32,
    /// GUSSET_TOGETHER_...: which loops get one patch; read without groups.
    pub together: u32,
    /// A number for each of the loops given, loop_count in all: those with the same number get one
    /// patch, a surface of genus 0 between them, but for loops that are left for reasons of their
    /// own. NULL: as together says. Needs loops.
    pub groups: *const u32,
    /// GUSSET_CONTINUITY_...: how smoothly faired vertices go on the surface round the hole.
    pub continuity: u32,
    /// 1: creases of the old surface that end at a rim end there, and no patch goes on with them. 0 or
    /// 1.
    pub ignore_creases: u32,
}

/// The account of one loop.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_hole {
    /// Its vertices are rims.data[rim_first] and on: with the surface on the left as it was before
    /// closed components were turned outwards, or, of a given loop that is not simple, free or
    /// oriented, as given.
    pub rim_first: usize,
    /// How many they are.
    pub rim_count: usize,
    /// Its patch's first face in the result: the faces and the new vertices of a patch of several
    /// loops are in the accounts of all of them.
    pub face_first: usize,
    /// How many faces the patch has.
    pub face_count: usize,
    /// The patch's first new vertex in the result.
    pub vertex_first: usize,
    /// How many new vertices the patch has.
    pub vertex_count: usize,
    /// The sum of its edges' lengths, in the unit of the positions.
    pub length: f64,
    /// The diagonal of the box round it, along the axes.
    pub diameter: f64,
    /// The area of the cone of triangles from its edges to their common centre: that of the hole if
    /// it is planar and convex, more otherwise.
    pub area: f64,
    /// GUSSET_HOLE_...
    pub status: u32,
    /// GUSSET_WEIGHT_...: the weight that the patch's triangulation is best by: the one asked for, or
    /// one that cuts less.
    pub weight: u32,
    /// GUSSET_PATCH_...: what the patch is made of: what was asked for, or less, which cuts less.
    pub finish: u32,
    /// The number of the patch, from 0 on in the order of the faces; loops with the same number have
    /// one patch. UINT32_MAX if it has none, as all have in a plan.
    pub patch: u32,
}

/// The accounts of all loops. Pointers are valid until the fill is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_view {
    /// sizeof(gusset_fill_view), set by the caller.
    pub struct_size: usize,
    /// One for each loop: those given, in their order, or all that the mesh has, as
    /// gusset_boundary_get_loop numbers them. NULL if there are none.
    pub holes: *const gusset_hole,
    /// How many.
    pub hole_count: usize,
    /// The vertices of all rims.
    pub rims: gusset_indices,
    /// Of each new vertex, in their order, three vertices of its patch's rims.
    pub parents: gusset_indices,
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; NULL without
    /// new vertices. They place it at the nearest point of the plain triangulation of the rims,
    /// which it is itself if its patch was neither faired nor creased, or if the hole is flat.
    pub weights: *const f64,
    /// Pairs of faces of the result that cut each other, two numbers a pair, the larger one first,
    /// which is a new face's; ascending. What they share, a vertex or an edge, is no cut, nor are
    /// vertices and edges at the same place; any other touch is. Exact.
    pub intersections: gusset_indices,
    /// Faces of the result, old and new ones, that GUSSET_OUTWARD_CLOSED turned over, ascending.
    /// Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: gusset_indices,
    /// 1 if intersections were looked for, 0 if not.
    pub intersections_known: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_fill_options: 72, gusset_fill_view: 104 }
fixed! { gusset_hole: 88 }

c_enum! {
    weight: Weight {
        GUSSET_WEIGHT_CONTINUATION => Continuation,
        GUSSET_WEIGHT_AREA_AND_BEND => AreaAndBend,
        GUSSET_WEIGHT_BEND_THEN_AREA => BendThenArea,
        GUSSET_WEIGHT_AREA => Area,
    }
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
    finish: Finish {
        GUSSET_PATCH_PLAIN => Plain,
        GUSSET_PATCH_REFINED => Refined,
        GUSSET_PATCH_FAIRED => Faired,
    }
    status: HoleStatus {
        GUSSET_HOLE_FILLED => Filled,
        GUSSET_HOLE_KEPT => Kept,
        GUSSET_HOLE_TOO_LARGE => TooLarge,
        GUSSET_HOLE_OPEN => Open,
        GUSSET_HOLE_NON_MANIFOLD => NonManifold,
        GUSSET_HOLE_NOT_ORIENTED => NotOriented,
        GUSSET_HOLE_NOT_SIMPLE => NotSimple,
        GUSSET_HOLE_NOT_FREE => NotFree,
        GUSSET_HOLE_NO_TRIANGULATION => NoTriangulation,
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
            outward: choice(self.outward)?,
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

impl gusset_hole {
    pub(crate) fn of(hole: &Hole) -> Self {
        gusset_hole {
            rim_first: hole.rim.start,
            rim_count: hole.rim.len(),
            face_first: hole.faces.start as usize,
            face_count: hole.faces.len(),
            vertex_first: hole.vertices.start as usize,
            vertex_count: hole.vertices.len(),
            length: hole.measures.length,
            diameter: hole.measures.diameter,
            area: hole.measures.area,
            status: hole.status.number(),
            weight: hole.weight.number(),
            finish: hole.finish.number(),
            patch: hole.patch,
        }
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
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param mesh the mesh.
/// @param loops the vertices of each loop in order, in either direction, each consecutive pair (and
///     the last with the first) an edge with exactly one face; loop_count of them. NULL with 0: all
///     loops that the mesh has.
/// @param loop_count see loops.
/// @param options NULL for the defaults.
/// @param[out] fill receives the result, for gusset_fill_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_mesh_view, INDEX_OUT_OF_RANGE (with the place in
///     the loop, whose number is the report's input), NULL_ARGUMENT (groups without loops),
///     UNKNOWN_VALUE, OUT_OF_RANGE, TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity Loops of n <= 128 vertices: O(n^3) time and 30 n^2 bytes, the best triangulation (of
///     least area: exactly); longer ones: from coarse to fine, O(n), or, if they are planar, ear by
///     ear, O(n log n); linear memory. Several loops of n vertices in all: O(n log n) if they are
///     few, O(n^3) if they are many. Besides O(H log d) for H half-edges and at most d edges at a
///     vertex, and O(m^1.5) for m new vertices of a hole. The search for cuts: O(n log n) for n faces
///     near the holes, and the pairs whose boxes overlap, in the worst case O(n^2). Loops that touch
///     at one vertex look at each other's edges there.
/// @source Barequet and Sharir 1995; Liepa, Filling holes in meshes, 2003.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    loops: *const gusset_indices,
    loop_count: usize,
    options: *const gusset_fill_options,
    fill: *mut *mut gusset_fill,
) -> gusset_status {
    create(context, fill, "fill", |job| {
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
        let holes = alloc::collect(filled.holes.iter().map(gusset_hole::of))?;
        Ok(gusset_fill { filled, holes })
    })
}

/// Destroys a fill; NULL is allowed.
///
/// @param[in,out] fill the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_fill_destroy(fill: *mut gusset_fill) {
    handle::destroy(fill);
}

/// Lends the result, valid until the fill is destroyed.
///
/// @param fill the filled mesh.
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill_get_mesh(fill: *const gusset_fill, view: *mut gusset_mesh_view) -> gusset_status {
    lend!(fill, view, |fill| mesh::lend(&fill.filled.mesh))
}

/// Lends the accounts of the loops.
///
/// @param fill the filled mesh.
/// @param[out] parts receives the parts; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: those of gusset_fill_get_mesh.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill_get_view(fill: *const gusset_fill, parts: *mut gusset_fill_view) -> gusset_status {
    lend!(fill, parts, |gusset_fill { filled, holes }| gusset_fill_view {
        struct_size: size_of::<gusset_fill_view>(),
        holes: lent(holes),
        hole_count: holes.len(),
        rims: gusset_indices::lend(&filled.rims),
        parents: gusset_indices::lend(filled.parents.as_flattened()),
        weights: lent(filled.weights.as_flattened()),
        intersections: gusset_indices::lend(filled.intersections.as_deref().unwrap_or_default().as_flattened()),
        intersections_known: u32::from(filled.intersections.is_some()),
        turned_outwards: gusset_indices::lend(&filled.turned_outwards),
        reserved: 0,
    })
}

/// Measures of the new faces and of the result.
///
/// @param fill the filled mesh.
/// @param[out] quality receives the measures; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill_get_quality(
    fill: *const gusset_fill,
    quality: *mut gusset_quality_report,
) -> gusset_status {
    lend!(fill, quality, |fill| gusset_quality_report::of(&fill.filled.quality))
}
