//! Surfaces: Sheets with an index: smooth surfaces that answer queries.
//!
//! @source Leus, "Carcasses on smooth surfaces"; the index and the proofs are our own.

pub mod cells;
pub mod contour;
pub mod curve;
pub mod distance;
pub mod evaluate;
pub mod line_intersection;
pub mod nearest;
pub mod report;
pub mod sheet;
pub mod sheet_construct;
pub mod sheet_mesh;
pub mod sheet_report;
pub mod surface_intersection;

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, flag, lent};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::error::Error;
use crate::surface::{Contact, ContactKind, Paths, Place, Sheet, Surface};
use glam::DVec3;
use gusset_base::alloc;

/// A smooth surface of one or more sheets with an index, which answers. Opaque and immutable: all
/// functions may use it from any thread, and many at the same time, each with a context of its own;
/// it is destroyed when none uses it any more. It keeps what it needs of its sheets.
pub struct gusset_surface(pub(crate) Surface<'static>, pub(crate) Vec<gusset_surface_sheet>);

handle! { gusset_surface }

/// A sheet of a surface.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_sheet {
    /// Cells in u: u runs from 0 to this. There is one more row of corners.
    pub rows: usize,
    /// Cells in v.
    pub columns: usize,
    /// The number of its cell (0, 0) among the cells of all sheets, one sheet after the other, each
    /// row after row. Cell (i, j) has the number first_cell + i * columns + j, which is its bit in
    /// masks of gusset_surface_cells_view.
    pub first_cell: u64,
    /// The number of its corner (0, 0) among the corners of all sheets, rows + 1 by columns + 1
    /// each: where its values begin for GUSSET_CONTOUR_VALUES.
    pub first_node: u64,
    /// 1: closed in u.
    pub closed_u: u32,
    /// 1: closed in v.
    pub closed_v: u32,
}

/// A place on a surface.
#[repr(C)]
#[derive(Clone, Copy, Default, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_place {
    /// The sheet, counted from 0 as they were given.
    pub sheet: u32,
    /// The row of the cell: between node rows row and row + 1.
    pub row: u32,
    /// Its column.
    pub column: u32,
    /// 0.
    pub reserved: u32,
    /// The parameter within the cell, 0 to 1, from row to row; that of the sheet is row + u.
    pub u: f64,
    /// The same from column to column.
    pub v: f64,
}

/// How two surfaces touch.
pub type gusset_contact_kind = u32;
/// Two surfaces touch in a point: all round it they are apart, or overlap by no more than the
/// tolerance.
pub const GUSSET_CONTACT_POINT: gusset_contact_kind = 1;
/// Two branches of an intersection cross in a point, or pass it within the tolerance.
pub const GUSSET_CONTACT_CROSSING: gusset_contact_kind = 2;

/// A point where two surfaces touch, to the tolerance: their normals there are parallel.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_contact {
    /// Where it is on the first surface.
    pub place: gusset_surface_place,
    /// Where it is on the second one.
    pub other: gusset_surface_place,
    /// A length: how far the first surface is above the second one, along the normal of the first.
    pub gap: f64,
    /// A length: near the contact, points of the one surface that are within the tolerance of the
    /// other one are within this distance of it, but for those on branches that cross there.
    pub radius: f64,
    /// How two surfaces touch.
    pub kind: gusset_contact_kind,
    /// 0.
    pub reserved: u32,
}

/// How a surface is built.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_surface_options {
    /// sizeof(gusset_surface_options), set by the caller.
    pub struct_size: usize,
    /// A length, to which answers are proved, finite; 0: 1e-9 of the diagonal of the surface's box.
    pub tolerance: f64,
    /// 1: with the cones of normals that isophotes (GUSSET_CONTOUR_ANGLE) and
    /// gusset_surface_nearest_angle descend, about 0.7 bytes a node; 0: the first such question
    /// builds them.
    /// @flag
    pub cones: u32,
    /// 0.
    pub reserved: u32,
}

/// Curves on a surface: what sections, contours and intersections give. Opaque and immutable; it
/// keeps nothing of the surface.
pub struct gusset_surface_paths {
    ends: Vec<u32>,
    closed: Vec<u32>,
    levels: Vec<u32>,
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    places: Vec<gusset_surface_place>,
    others: Vec<gusset_surface_place>,
    unresolved: Vec<gusset_surface_place>,
    contacts: Vec<gusset_surface_contact>,
}

handle! { gusset_surface_paths }

/// The curves. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_paths_view {
    /// sizeof(gusset_surface_paths_view), set by the caller.
    pub struct_size: usize,
    /// How many curves.
    pub path_count: usize,
    /// How many points there are in all.
    pub point_count: usize,
    /// 0, then the end of each curve among the points: curve k has the points ends[k] to ends[k +
    /// 1] - 1.
    pub ends: gusset_indices,
    /// By curve: 1 if it returns to its first point, which is not repeated. (Closed nodes and
    /// gusset_curve_through_create have it again at the end.)
    pub closed: *const u32,
    /// By curve: the number of the plane, level or angle that it belongs to; 0 if there was one.
    pub levels: *const u32,
    /// x, y, z of each point, on the surface.
    pub points: *const f64,
    /// The unit normals there, x, y, z of each; 0 where there is none.
    pub normals: *const f64,
    /// Where the points are on the surface.
    pub places: *const gusset_surface_place,
    /// For intersections: where they are on the second; else NULL.
    pub others: *const gusset_surface_place,
    /// Cells in which something may be that could not be resolved: tangency, coincidence, or pieces
    /// smaller than the tolerance.
    pub unresolved: *const gusset_surface_place,
    /// How many.
    pub unresolved_count: usize,
    /// For intersections: points where they touch.
    pub contacts: *const gusset_surface_contact,
    /// How many.
    pub contact_count: usize,
}

versioned! { gusset_surface_options: 16 reserved, gusset_surface_paths_view: 104 }
fixed! { gusset_surface_place: 32, gusset_surface_contact: 88, gusset_surface_sheet: 40 }
c_enum! { kind: ContactKind { GUSSET_CONTACT_POINT => Point, GUSSET_CONTACT_CROSSING => Crossing } }

impl gusset_surface_sheet {
    /// The sheets of a surface.
    pub(crate) fn all(surface: &Surface<'_>) -> Result<Vec<Self>, Error> {
        let (mut first_cell, mut first_node) = (0, 0);
        alloc::collect((0..surface.len()).map(|k| {
            let ([rows, columns], [closed_u, closed_v]) =
                (surface.sheet(k).cells(), surface.sheet(k).is_closed().map(u32::from));
            let sheet = gusset_surface_sheet { rows, columns, first_cell, first_node, closed_u, closed_v };
            first_cell += (rows * columns) as u64;
            first_node += ((rows + 1) * (columns + 1)) as u64;
            sheet
        }))
    }
}

impl From<Place> for gusset_surface_place {
    fn from(place: Place) -> Self {
        let Place { sheet, cell: [row, column], u, v } = place;
        gusset_surface_place { sheet, row, column, reserved: 0, u, v }
    }
}

impl From<Contact> for gusset_surface_contact {
    fn from(contact: Contact) -> Self {
        let Contact { kind, place, other, gap, radius } = contact;
        let (place, other) = (place.into(), other.into());
        gusset_surface_contact { place, other, gap, radius, kind: kind.number(), reserved: 0 }
    }
}

/// The surface of a handle.
pub(crate) fn read<'a>(surface: *const gusset_surface) -> Result<&'a Surface<'static>, Failure> {
    Ok(&handle::get(surface, "surface")?.0)
}

impl TryFrom<Paths> for gusset_surface_paths {
    type Error = Error;

    fn try_from(paths: Paths) -> Result<Self, Error> {
        let places = |places: Vec<Place>| alloc::collect(places.into_iter().map(gusset_surface_place::from));
        Ok(gusset_surface_paths {
            ends: paths.ends,
            closed: alloc::collect(paths.closed.into_iter().map(u32::from))?,
            levels: paths.levels,
            points: paths.points,
            normals: paths.normals,
            places: places(paths.places)?,
            others: places(paths.others)?,
            unresolved: places(paths.unresolved)?,
            contacts: alloc::collect(paths.contacts.into_iter().map(gusset_surface_contact::from))?,
        })
    }
}

/// The sheets of an array of handles; copies share their nodes.
fn sheets(handles: *const *const gusset_sheet, count: usize) -> Result<Vec<Sheet<'static>>, Failure> {
    let handles = handle::list(handles, count, "sheets")?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.0.clone())))
}

/// Builds the index of one sheet or several, which together are one surface.
///
/// The greatest absolute coordinate of each is from 1e-30 to 1e37, or 0, control points included:
/// boxes are in single precision.
///
/// @param sheets count handles, none NULL, the array at any alignment; they may be destroyed
///     afterwards.
/// @param count see sheets.
/// @errors NULL_ARGUMENT (of a handle with its number, as GUSSET_ELEMENT_ITEM), EMPTY_MESH (without
///     sheets), OUT_OF_RANGE (with the sheet (as GUSSET_ELEMENT_ITEM) whose coordinates are too
///     large or too small, for the tolerance)
/// @complexity O(nodes), about 7 bytes a node, and 0.7 with cones; threads.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_create(
    context: *const gusset_context,
    sheets: *const *const gusset_sheet,
    count: usize,
    options: *const gusset_surface_options,
    surface: *mut *mut gusset_surface,
) -> gusset_status {
    create(context, surface, "surface", |job| {
        let options = input::read(options, true, "options")?;
        let given = self::sheets(sheets, count)?;
        let tolerance = if options.tolerance == 0.0 { None } else { Some(options.tolerance) };
        let with_cones = flag(options.cones, "cones")?;
        let split = if with_cones { 0.8 } else { 1.0 };
        let made = Surface::new(given, tolerance, &job.part(0.0, split))?;
        if with_cones {
            made.build_cones(&job.part(split, 1.0))?;
        }
        let sheets = gusset_surface_sheet::all(&made)?;
        Ok(gusset_surface(made, sheets))
    })
}

/// Frees a surface; NULL is allowed.
///
/// Results that were found with it stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_destroy(surface: *mut gusset_surface) {
    handle::destroy(surface);
}

/// The curves, lent until they are destroyed.
///
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_paths_get_view(
    paths: *const gusset_surface_paths,
    view: *mut gusset_surface_paths_view,
) -> gusset_status {
    lend!(paths, view, |paths| gusset_surface_paths_view {
        struct_size: 0,
        path_count: paths.closed.len(),
        point_count: paths.points.len(),
        ends: gusset_indices::lend(&paths.ends),
        closed: lent(&paths.closed),
        levels: lent(&paths.levels),
        points: lent(&paths.points).cast(),
        normals: lent(&paths.normals).cast(),
        places: lent(&paths.places),
        others: lent(&paths.others),
        unresolved: lent(&paths.unresolved),
        unresolved_count: paths.unresolved.len(),
        contacts: lent(&paths.contacts),
        contact_count: paths.contacts.len(),
    })
}

/// Frees curves; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_paths_destroy(paths: *mut gusset_surface_paths) {
    handle::destroy(paths);
}
