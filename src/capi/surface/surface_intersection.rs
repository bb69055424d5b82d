//! Intersections of surfaces: Curves in which two surfaces meet, or one meets itself.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::contour::{gusset_spacing_rule, to_point_spacing};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, surface_of_handle};
use crate::error::Error;
use crate::surface::contour::PointSpacing;
use crate::surface::surface_intersection::Options;

/// Options of gusset_surface_intersection_create.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_intersection_options {
    /// sizeof(gusset_intersection_options).
    pub struct_size: usize,
    /// Largest distance of the curve from its chords, above 0; rare chords exceed it by about 15 %.
    /// At least the smallest of `tolerance` and the surfaces' applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    pub chord: f64,
    /// Surfaces touch where their gap or overlap stays within it; 0: the surfaces' smaller
    /// tolerance. Self-intersections use at most the surface's. Branches shorter than all three may
    /// be lost.
    pub tolerance: f64,
    /// Not GUSSET_POINT_SPACING_LEUS; GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    pub spacing: gusset_spacing_rule,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_intersection_options: 32 reserved }

fn read_options(options: *const gusset_intersection_options) -> Result<Options, Failure> {
    let options = input::read_versioned_struct(options, true, "options")?;
    let chord = match to_point_spacing(options.spacing, options.chord, 0)? {
        PointSpacing::Auto => None,
        PointSpacing::CellEdges => Some(f64::INFINITY),
        PointSpacing::Chord(chord) if chord.is_infinite() => {
            return Err(Error::OptionOutOfRange {
                option: "chord",
                value: chord,
                allowed: "finite and above 0".into(),
            }
            .into());
        }
        PointSpacing::Chord(chord) => Some(chord),
        PointSpacing::Leus(_) => {
            return Err(Failure::unknown_value("spacing", options.spacing.into(), "a spacing other than Leus"));
        }
    };
    Ok(Options { chord, tolerance: (options.tolerance != 0.0).then_some(options.tolerance) })
}

/// Finds the curves in which two surfaces meet, or one meets itself.
///
/// Each curve is found once, and runs along N x N', the normals at `places` and `others`. Points
/// and normals are the first surface's; the second differs by rounding, at crossings within the
/// tolerance.
///
/// Two surfaces: all branches are found, except
/// - branches shorter than the tolerance, or the surfaces' if smaller (near poles, four times
///   that);
/// - branches within four times that length of another;
/// - parts within contacts and unresolved cells.
///
/// Open paths end at borders or in unresolved cells.
///
/// A point where surfaces touch or branches cross is a contact if proved:
/// - Near it, both surfaces are graphs over a plane.
/// - Their difference has definite (GUSSET_CONTACT_POINT) or indefinite (GUSSET_CONTACT_CROSSING)
///   second derivatives.
/// - The gap is within the tolerance. A larger one leaves a loop, nothing, or two branches.
///
/// Within a contact's radius, at most about 4 sqrt(2 tolerance / c) for the least curvature c of
/// the difference, loops are omitted and paths run straight to its point. At a crossing, a path
/// turns into the branch that closes it, if any.
///
/// Cells of the first surface are unresolved where
/// - surfaces coincide, or touch along a curve, at a pole or border, or to a higher order;
/// - the work limit is exceeded, as by branches 1e-4 of a cell apart, or nearly along cell sides of
///   both.
///
/// There, curves may end, split or be missing, but join across a cell if a chord is as near to both
/// surfaces as elsewhere.
///
/// Self-intersections:
/// - Along a closed curve the pieces may swap: it ends at its first point with `places` and
///   `others` exchanged. A seam that turns the sheet over also reverses it.
/// - Common points of joined cells do not count. These share a side, corner or pole, or lie at
///   opposite borders of a sheet. Control points there are equal, in either order, to 64 roundings
///   of the largest coordinate.
/// - Common borders of different sheets are intersections.
/// - Branches above the tolerance are found, except in unresolved cells: at pinches, creases and
///   singular poles, and where pieces touch or coincide.
/// - Curves stop before pinches, where pieces come within the tolerance (rough surfaces: tens of
///   tolerances).
/// - Curves along cell sides may be in many parts.
/// - Contacts are not sought.
///
/// Exchanging the surfaces may change rounding and contacts proved.
///
/// @param other NULL: self-intersections; if `surface`, everything coincides.
/// @errors OUT_OF_RANGE (chord, tolerance), TOO_LARGE (above 2^26 pairs of cells)
/// @complexity Proportional to pairs of cells within the tolerance, and to points, about 1 /
///     sqrt(chord); parallel. At most 256 boxes of parameters for each pair, and 2^22 more in all.
///     Self-intersections: also to cells, and n^2/2 for n cells round a pole.
/// @source Leus, task e.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_intersection_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    other: *const gusset_surface,
    options: *const gusset_intersection_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create_handle(context, paths, "paths", |job| {
        let (surface, options) = (surface_of_handle(surface)?, read_options(options)?);
        let found = if other.is_null() {
            surface.meet_itself(&options, job)?
        } else {
            surface.meet(&handle::get_object(other, "other")?.0, &options, job)?
        };
        Ok(found.try_into()?)
    })
}
