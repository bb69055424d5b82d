//! C interface: intersection curves of two surfaces, and of one with itself.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lent};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, read};
use crate::surface::surface_intersection::{CellPair, Options};
use gusset_base::alloc;

/// How intersections are wanted.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_intersection_options {
    /// sizeof(gusset_intersection_options), set by the caller.
    pub struct_size: usize,
    /// A length, the greatest distance of the curve from the chords between its points, as their
    /// tangents and middles show it (1.14 times as much was seen at one chord in 10,000); 0: 1e-4 of
    /// the diagonal of the smaller surface's box; INFINITY: points are only where it crosses sides
    /// of cells of either surface; one that is smaller than `tolerance` and than the surfaces' own
    /// counts as the smaller one of these. (In gusset_contour_options `spacing` says which of these
    /// is meant.)
    pub chord: f64,
    /// A length, finite: surfaces that are apart, or overlap, by no more than that all over touch
    /// there. 0: the smaller one of the tolerances of the two surfaces. Branches are found and told
    /// apart by that one, or by `tolerance` if it is smaller: shorter ones may be lost. A surface's
    /// intersections with itself take a greater one for the surface's own.
    pub tolerance: f64,
}

/// A cell of one surface and a cell of another.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_cell_pair {
    /// The sheet of the first surface.
    pub sheet_a: u32,
    /// The row of its cell.
    pub row_a: u32,
    /// The column of its cell.
    pub column_a: u32,
    /// The sheet of the second surface.
    pub sheet_b: u32,
    /// The row of its cell.
    pub row_b: u32,
    /// The column of its cell.
    pub column_b: u32,
}

/// Pairs of cells. Opaque and immutable; it keeps nothing of the surfaces.
pub struct gusset_cell_pairs(Vec<gusset_cell_pair>);

handle! { gusset_cell_pairs }

/// The pairs. The pointer is valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_cell_pairs_view {
    /// sizeof(gusset_cell_pairs_view), set by the caller.
    pub struct_size: usize,
    /// The pairs, by sheets, then by the first surface's cells.
    pub pairs: *const gusset_cell_pair,
    /// How many.
    pub count: usize,
}

versioned! { gusset_intersection_options: 24, gusset_cell_pairs_view: 24 }
fixed! { gusset_cell_pair: 24 }

fn read_options(options: *const gusset_intersection_options) -> Result<Options, Failure> {
    let options = input::read(options, true, "options")?;
    let given = |value: f64| (value != 0.0).then_some(value);
    Ok(Options { chord: given(options.chord), tolerance: given(options.tolerance) })
}

/// The curves in which two surfaces meet, with the places of their points on both: ordered along
/// N_A x N_B, closed ones marked so.
///
/// Points and normals are those of a; the points of b at `others` are the same but for rounding,
/// and at crossings to the tolerance. Every branch is found, relative to the surfaces as declared,
/// that is longer than the tolerance, or the surfaces' own if that is smaller, or, next to a pole,
/// than four times that; farther than four times that from others; and not part of a contact or of
/// a cell that is listed as unresolved. A path that is not closed ends at the border of a sheet, or
/// in such a cell.
///
/// A point where the surfaces touch, or where two branches cross, is a contact if it is proved to
/// be alone: near it both are graphs over a plane, and the second derivatives of their difference
/// are a definite form (GUSSET_CONTACT_POINT) or an indefinite one (GUSSET_CONTACT_CROSSING), and
/// the gap is within the tolerance; if it is larger, there is a loop, or nothing, or two branches
/// that pass each other. What is within a contact's radius, at most some four times the root of
/// twice the tolerance over the least curvature of that difference, is left out: loops, and how
/// branches run that come nearer to each other than that; a path goes straight to the contact's
/// point from where it comes to it. A path that comes to a crossing turns there, as N_A x N_B
/// points to it and away from it in turn, and goes back the way that closes it if there is one: a
/// figure of eight is two closed paths that have one point in common.
///
/// Cells of a where the surfaces touch in another way (along a curve, at a pole, at a border, to a
/// higher order) or coincide are listed as unresolved, and curves may end there, or be in parts or
/// missing within such cells. So are cells that take more work than the limit, as where two branches
/// run beside each other at 1e-4 of a cell and not along its sides, or one runs nearly along the
/// sides of cells of both surfaces, as where coaxial surfaces of revolution meet. Curves are joined
/// across such a place where a chord is as near to both surfaces as elsewhere. For where one
/// surface meets itself see gusset_surface_self_intersection_create.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param a the one surface.
/// @param b the other; of the same handle all is reported as coincident.
/// @param options NULL for the defaults.
/// @param[out] paths receives the curves, for gusset_surface_paths_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     OUT_OF_RANGE (chord, tolerance), TOO_LARGE above 2^26 pairs of cells, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity In proportion to the pairs of cells that may be within the tolerance of each other,
///     with a limit for each, and to the points, as 1 / sqrt(chord); more where cells are within
///     the tolerance of hundreds of others. Threads; the same bits for any number of them. With a
///     and b exchanged bits may differ, and which contacts are proved.
/// @source Leus, "Carcasses on smooth surfaces", task e; the proofs are ours.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_intersection_create(
    context: *const gusset_context,
    a: *const gusset_surface,
    b: *const gusset_surface,
    options: *const gusset_intersection_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let options = read_options(options)?;
        Ok(read(a)?.meet(read(b)?, &options, job)?.try_into()?)
    })
}

/// The curves in which a surface meets itself, with the places of their points on both pieces:
/// ordered along N x N', where N is the normal at `places` and N' that at `others`; closed ones
/// marked so. Each curve is given once.
///
/// Along a closed curve the two pieces may change places, as on a Klein bottle: it then ends where
/// it begins in space, with `places` and `others` exchanged. Where a sheet is turned over at a
/// seam, as a Möbius band is, the direction turns too.
///
/// Cells with a side or a corner in common, across a seam too, opposite borders of a sheet whose
/// control points are the same to 64 units of rounding of the largest coordinate, in either order,
/// and cells round a pole are joined: what they have in common so is no intersection, and that they
/// have nothing else is proved, or they are divided. Every branch longer than the tolerance is
/// found, but for cells that are listed as unresolved: where tangents are dependent, as where a
/// curve ends in a pinch (Whitney's umbrella), at creases and singular poles, and where pieces
/// touch or coincide. A curve that ends in a pinch ends where its pieces are as near to each other
/// as the tolerance, some tens of tolerances from the pinch where the surface is rough; the
/// unresolved place is there. A curve that runs along sides of cells all its way may come in many
/// parts. No contacts are looked for. What borders of different sheets have in common is an
/// intersection.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param options NULL for the defaults; those of one surface are those of two with it twice.
/// @param[out] paths receives the curves, for gusset_surface_paths_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     OUT_OF_RANGE (chord, tolerance), TOO_LARGE above 2^26 pairs of cells, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity In proportion to the cells and to the pairs of cells that may meet, with a limit for
///     each; of n cells round a pole n^2 / 2 pairs are looked at, and held only where the sheet is
///     not proved to be regular there; threads; the same bits for any number of them.
/// @source After gusset_surface_intersection_create; the proofs for joined cells are ours.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_self_intersection_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    options: *const gusset_intersection_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let options = read_options(options)?;
        Ok(read(surface)?.meet_itself(&options, job)?.try_into()?)
    })
}

/// Pairs of cells of two surfaces that may be as near to each other as `within`: all that are, and
/// few others.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param a the one surface.
/// @param b the other surface.
/// @param within a length, finite; 0: cells that may meet.
/// @param[out] pairs receives them, for gusset_cell_pairs_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (within),
///     TOO_LARGE above 2^26 pairs, OUT_OF_MEMORY, CANCELLED.
/// @complexity In proportion to the pairs, and some for each level of the indices; 24 bytes a pair.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_cell_pairs_create(
    context: *const gusset_context,
    a: *const gusset_surface,
    b: *const gusset_surface,
    within: f64,
    pairs: *mut *mut gusset_cell_pairs,
) -> gusset_status {
    create(context, pairs, "pairs", |job| {
        let pair = |CellPair { sheets: [sheet_a, sheet_b], cells: [[row_a, column_a], [row_b, column_b]] }| {
            gusset_cell_pair { sheet_a, row_a, column_a, sheet_b, row_b, column_b }
        };
        let found = read(a)?.candidates(read(b)?, within, job)?;
        Ok(gusset_cell_pairs(alloc::collect(found.into_iter().map(pair))?))
    })
}

/// The pairs, lent until they are destroyed.
///
/// @param pairs the pairs.
/// @param[out] parts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_cell_pairs_get_view(
    pairs: *const gusset_cell_pairs,
    parts: *mut gusset_cell_pairs_view,
) -> gusset_status {
    lend!(pairs, parts, |pairs| {
        gusset_cell_pairs_view { struct_size: 0, pairs: lent(&pairs.0), count: pairs.0.len() }
    })
}

/// Frees pairs of cells; NULL is allowed.
///
/// @param[in,out] pairs the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_cell_pairs_destroy(pairs: *mut gusset_cell_pairs) {
    handle::destroy(pairs);
}
