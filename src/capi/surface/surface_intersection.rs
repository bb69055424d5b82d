//! Intersections of surfaces: Curves in which two surfaces meet, or one meets itself.

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::contour::{gusset_spacing_rule, spacing};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, read};
use crate::error::Error;
use crate::surface::contour::PointSpacing;
use crate::surface::surface_intersection::Options;

/// How intersections are wanted.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_intersection_options {
    /// sizeof(gusset_intersection_options), set by the caller.
    pub struct_size: usize,
    /// With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite, the greatest distance of the
    /// curve from the chords between its points, as their tangents and middles show it. (1.14 times
    /// as much was seen at one chord in 10,000.) A chord that is smaller than `tolerance` and than
    /// the surfaces' own tolerances counts as the smaller one of these. Otherwise not read.
    pub chord: f64,
    /// A length, finite: surfaces that are apart, or overlap, by no more than that all over touch
    /// there. 0: the smaller one of the tolerances of the two surfaces. Branches are found and told
    /// apart by that one, or by `tolerance` if it is smaller: shorter ones may be lost. A surface's
    /// intersections with itself take a greater one for the surface's own.
    pub tolerance: f64,
    /// All but GUSSET_POINT_SPACING_LEUS; for GUSSET_POINT_SPACING_AUTO the smaller
    /// surface's box counts.
    pub spacing: gusset_spacing_rule,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_intersection_options: 32 reserved }

fn read_options(options: *const gusset_intersection_options) -> Result<Options, Failure> {
    let options = input::read(options, true, "options")?;
    let chord = match spacing(options.spacing, options.chord, 0)? {
        PointSpacing::Auto => None,
        PointSpacing::CellEdges => Some(f64::INFINITY),
        PointSpacing::Chord(chord) if chord.is_infinite() => {
            return Err(Error::OptionOutOfRange { option: "chord", value: chord }.into());
        }
        PointSpacing::Chord(chord) => Some(chord),
        PointSpacing::Leus(_) => return Err(Failure::unknown("spacing", options.spacing.into())),
    };
    Ok(Options { chord, tolerance: (options.tolerance != 0.0).then_some(options.tolerance) })
}

/// Finds the curves in which two surfaces meet, or in which a surface meets itself, with the places
/// of their points on both.
///
/// Curves run along N x N', where N is the normal at `places` and N' the normal at `others`. Closed
/// ones are marked so. Points and normals are those of the first surface; the points at `others` are
/// the same but for rounding, and at crossings to the tolerance. Each curve is given once.
///
/// Two surfaces: every branch is found, relative to the surfaces as declared, that is longer than
/// the tolerance, or the surfaces' own if that is smaller, or, next to a pole, than four times that;
/// farther than four times that from others; and not part of a contact or of a cell that is listed
/// as unresolved. A path that is not closed ends at the border of a sheet, or in such a cell.
///
/// A point where the surfaces touch, or where two branches cross, is a contact if it is proved to
/// be alone: near it both are graphs over a plane, and the second derivatives of their difference
/// are a definite form (GUSSET_CONTACT_POINT) or an indefinite one (GUSSET_CONTACT_CROSSING), and
/// the gap is within the tolerance; if it is larger, there is a loop, or nothing, or two branches
/// that pass each other. All within a contact's radius, at most some four times the root of
/// twice the tolerance over the least curvature of that difference, is left out: loops, and how
/// branches run that come nearer to each other than that; a path goes straight to the contact's
/// point from where it comes to it. A path that comes to a crossing turns there, as N x N' points to
/// it and away from it in turn, and goes back the way that closes it if there is one: a figure of
/// eight is two closed paths that have one point in common.
///
/// Cells of the first surface where the surfaces touch in another way (along a curve, at a pole, at
/// a border, to a higher order) or coincide are listed as unresolved, and curves may end there, or
/// be in parts or missing within such cells. So are cells that take more work than the limit, as
/// where two branches run beside each other at 1e-4 of a cell and not along its sides, or one runs
/// nearly along the sides of cells of both surfaces, as where coaxial surfaces of revolution meet.
/// Curves are joined across such a place where a chord is as near to both surfaces as elsewhere.
///
/// A surface with itself: along a closed curve the two pieces may change places, as on a Klein
/// bottle. The curve then ends where it begins in space, with `places` and `others` exchanged. Where
/// a sheet is turned over at a seam, as a Möbius band is, the direction turns too.
///
/// Cells of a sheet with a side or a corner in common, across a seam too, opposite borders of a sheet
/// whose control points are the same to 64 units of rounding of the largest coordinate, in either
/// order, and cells round a pole are joined: what they have in common so is no intersection, and
/// that they have nothing else is proved, or they are divided. Every branch longer than the
/// tolerance is found, but for cells that are listed as unresolved: where tangents are dependent, as
/// where a curve ends in a pinch (Whitney's umbrella), at creases and singular poles, and where
/// pieces touch or coincide. A curve that ends in a pinch ends where its pieces are as near to each
/// other as the tolerance, some tens of tolerances from the pinch where the surface is rough; the
/// unresolved place is there. A curve that runs along sides of cells all its way may come in many
/// parts. No contacts are looked for. A common part of borders of different sheets is an
/// intersection.
///
/// @param other the other surface; NULL: the surface with itself. For the handle of the surface
///     everything is reported as coincident.
/// @param options NULL for the defaults. For one surface they are those of two with it twice.
/// @errors UNKNOWN_VALUE (spacing, reserved), OUT_OF_RANGE (chord, tolerance), TOO_LARGE (above
///     2^26 pairs of cells)
/// @complexity In proportion to the pairs of cells that may be within the tolerance of each other,
///     with a limit for each, and to the points, as 1 / sqrt(chord); more where cells are within
///     the tolerance of hundreds of others. For one surface also in proportion to its cells; of n
///     cells round a pole n^2 / 2 pairs are looked at, and held only where the sheet is not proved
///     to be regular there. Threads; the same bits for any number of them. With the surfaces
///     exchanged bits may differ, and which contacts are proved.
/// @source Leus, "Carcasses on smooth surfaces", task e; the proofs are ours.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_intersection_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    other: *const gusset_surface,
    options: *const gusset_intersection_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let (surface, options) = (read(surface)?, read_options(options)?);
        let found = if other.is_null() {
            surface.meet_itself(&options, job)?
        } else {
            surface.meet(&handle::get(other, "other")?.0, &options, job)?
        };
        Ok(found.try_into()?)
    })
}
