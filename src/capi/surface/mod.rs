//! Surfaces: Smooth surfaces that answer queries from an index. Coordinates of queries, lines and
//! targets are -1e150 to 1e150.
//!
//! @source Leus, "Carcasses on smooth surfaces".

pub mod sheet;
pub mod nearest;
pub mod evaluate;
pub mod line_intersection;
pub mod contour;
pub mod surface_intersection;
pub mod distance;
pub mod report;
pub mod sheet_construct;
pub mod sheet_report;
pub mod sheet_mesh;
pub mod cells;
pub mod curve;

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, lend_list, read_flag};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::error::Error;
use crate::surface::{Contact, ContactKind, Paths, Place, Sheet, Surface};
use glam::DVec3;
use gusset_base::alloc;

/// A smooth surface of sheets, indexed for queries.
pub struct gusset_surface(pub(crate) Surface<'static>, pub(crate) Vec<gusset_surface_sheet>);

handle! { gusset_surface }

/// Size and numbering of a sheet.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_sheet {
    /// Rows of cells: u runs from 0 to rows.
    pub rows: usize,
    /// Columns of cells, in v.
    pub columns: usize,
    /// Number of cell (0, 0) among all sheets' cells; cell (i, j) is first_cell + i * columns + j,
    /// its bit in region masks.
    pub first_cell: u64,
    /// Number of corner (0, 0) among all sheets' corners, (rows + 1) x (columns + 1) each: offset
    /// of values for GUSSET_CONTOUR_VALUES.
    pub first_node: u64,
    /// 1: closed in u.
    /// @flag
    pub closed_u: u32,
    /// 1: closed in v.
    /// @flag
    pub closed_v: u32,
}

/// A place on a surface.
#[repr(C)]
#[derive(Clone, Copy, Default, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_place {
    /// Index of the sheet.
    pub sheet: u32,
    /// Row of the cell.
    pub row: u32,
    /// Column of the cell.
    pub column: u32,
    /// 0.
    pub reserved: u32,
    /// Parameter in the cell, 0 to 1; the sheet's is row + u.
    pub u: f64,
    /// Parameter in the cell, 0 to 1; the sheet's is column + v.
    pub v: f64,
}

/// How two surfaces touch.
pub type gusset_contact_kind = u32;
/// They touch in a point, apart round it or overlapping within the tolerance.
pub const GUSSET_CONTACT_POINT: gusset_contact_kind = 1;
/// Two branches cross, or pass each other within the tolerance.
pub const GUSSET_CONTACT_CROSSING: gusset_contact_kind = 2;

/// A point where surfaces touch within the tolerance, with parallel normals.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_contact {
    /// Place on the first surface.
    pub place: gusset_surface_place,
    /// Place on the second surface.
    pub other: gusset_surface_place,
    /// Height of the first above the second, along the first's normal.
    pub gap: f64,
    /// Near it, points within the tolerance of the other surface lie this near, except on crossing
    /// branches.
    pub radius: f64,
    /// How two surfaces touch.
    pub kind: gusset_contact_kind,
    /// 0.
    pub reserved: u32,
}

/// Options of gusset_surface_create.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_surface_options {
    /// sizeof(gusset_surface_options).
    pub struct_size: usize,
    /// Guaranteed accuracy of distances and positions. 0: 1e-9 of the surface's box diagonal.
    pub tolerance: f64,
    /// 1: builds cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle; 0: the
    /// first such query does.
    /// @flag
    pub cones: u32,
    /// 0.
    pub reserved: u32,
}

/// Curves on a surface: sections, contours or intersections.
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

/// Lent curves.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_paths_view {
    /// sizeof(gusset_surface_paths_view).
    pub struct_size: usize,
    /// Number of curves.
    pub path_count: usize,
    /// Number of points.
    pub point_count: usize,
    /// Offsets into points, by curve.
    pub ends: gusset_indices,
    /// By curve: 1 if closed; append the first point for gusset_curve_through_create.
    /// @shape path_count
    /// @flag
    pub closed: *const u32,
    /// By curve: index of its plane, level or angle, or 0.
    /// @shape path_count
    pub levels: *const u32,
    /// On the surface.
    /// @shape point_count 3
    pub points: *const f64,
    /// Unit normals; 0 where undefined.
    /// @shape point_count 3
    pub normals: *const f64,
    /// Places of the points.
    /// @shape point_count
    pub places: *const gusset_surface_place,
    /// Intersections: places on the second surface.
    /// @shape point_count
    pub others: *const gusset_surface_place,
    /// Cells that may hold tangencies, coincidences, or pieces below the tolerance.
    /// @shape unresolved_count
    pub unresolved: *const gusset_surface_place,
    /// Number of unresolved cells.
    pub unresolved_count: usize,
    /// Intersections: points where surfaces touch.
    /// @shape contact_count
    pub contacts: *const gusset_surface_contact,
    /// Number of contacts.
    pub contact_count: usize,
}

versioned! { gusset_surface_options: 16 reserved, gusset_surface_paths_view: 104 }
fixed! { gusset_surface_place: 32, gusset_surface_contact: 88, gusset_surface_sheet: 40 }
c_enum! { kind: ContactKind { GUSSET_CONTACT_POINT => Point, GUSSET_CONTACT_CROSSING => Crossing } }

impl gusset_surface_sheet {
    /// Returns the views of a surface's sheets.
    pub(crate) fn views_of_sheets(surface: &Surface<'_>) -> Result<Vec<Self>, Error> {
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

/// Returns the surface of a handle.
pub(crate) fn surface_of_handle<'a>(surface: *const gusset_surface) -> Result<&'a Surface<'static>, Failure> {
    Ok(&handle::get_object(surface, "surface")?.0)
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

/// Reads the sheets of an array of handles; copies share their nodes.
fn sheets_of_handles(handles: *const *const gusset_sheet, count: usize) -> Result<Vec<Sheet<'static>>, Failure> {
    let handles = handle::get_objects(handles, count, "sheets")?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.0.clone())))
}

/// Makes a surface of sheets.
///
/// Each sheet's greatest absolute coordinate, of controls also, is 0 or 1e-30 to 1e37.
///
/// @param sheets none NULL.
/// @errors EMPTY_MESH (no sheets), OUT_OF_RANGE (tolerance, coordinates)
/// @complexity O(nodes), parallel; about 7 bytes a node, and 0.7 for cones.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_create(
    context: *const gusset_context,
    sheets: *const *const gusset_sheet,
    count: usize,
    options: *const gusset_surface_options,
    surface: *mut *mut gusset_surface,
) -> gusset_status {
    create_handle(context, surface, "surface", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let given = self::sheets_of_handles(sheets, count)?;
        let tolerance = if options.tolerance == 0.0 { None } else { Some(options.tolerance) };
        let with_cones = read_flag(options.cones, "cones")?;
        let split = if with_cones { 0.8 } else { 1.0 };
        let made = Surface::new(given, tolerance, &job.sub_job(0.0, split))?;
        if with_cones {
            made.build_cones(&job.sub_job(split, 1.0))?;
        }
        let sheets = gusset_surface_sheet::views_of_sheets(&made)?;
        Ok(gusset_surface(made, sheets))
    })
}

/// Frees a surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_destroy(surface: *mut gusset_surface) {
    handle::destroy(surface);
}

/// Lends the curves.
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
        ends: gusset_indices::lend_indices(&paths.ends),
        closed: lend_list(&paths.closed),
        levels: lend_list(&paths.levels),
        points: lend_list(&paths.points).cast(),
        normals: lend_list(&paths.normals).cast(),
        places: lend_list(&paths.places),
        others: lend_list(&paths.others),
        unresolved: lend_list(&paths.unresolved),
        unresolved_count: paths.unresolved.len(),
        contacts: lend_list(&paths.contacts),
        contact_count: paths.contacts.len(),
    })
}

/// Frees curves.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_paths_destroy(paths: *mut gusset_surface_paths) {
    handle::destroy(paths);
}
