//! Arrays that the library lends: one without elements is NULL, and no pointer that must not be
//! looked through.

#![allow(unsafe_code, reason = "calls the C functions")]

use gusset::capi::curve::export::*;
use gusset::capi::curve::intersect::*;
use gusset::capi::curve::{gusset_curve, gusset_curve_create, gusset_curve_destroy};
use gusset::capi::mesh::GUSSET_F64;
use gusset::capi::mesh::result::*;
use gusset::capi::net::mesh::*;
use gusset::capi::net::{gusset_net_create, gusset_net_destroy, gusset_net_view};
use gusset::capi::status::gusset_status::{self, GUSSET_OK};
use gusset::capi::surface::cells::*;
use gusset::capi::surface::contour::{gusset_contour_function, gusset_surface_contours_create};
use gusset::capi::surface::line_intersection::*;
use gusset::capi::surface::nearest::*;
use gusset::capi::surface::sheet::*;
use gusset::capi::surface::*;
use std::ptr;

/// A handle that a function made, until it is dropped.
struct Made<T> {
    handle: *mut T,
    destroy: unsafe extern "C" fn(*mut T),
}

impl<T> Drop for Made<T> {
    fn drop(&mut self) {
        // SAFETY: made below, and given up here.
        unsafe { (self.destroy)(self.handle) };
    }
}

fn made<T>(destroy: unsafe extern "C" fn(*mut T), make: impl FnOnce(*mut *mut T) -> gusset_status) -> Made<T> {
    let mut handle = ptr::null_mut();
    assert_eq!(make(&raw mut handle), GUSSET_OK);
    Made { handle, destroy }
}

/// All zeros but the size, with which it begins.
fn sized<T: Copy>() -> T {
    // SAFETY: the structs of the interface are plain numbers and pointers, and begin with a size.
    unsafe {
        let mut value: T = std::mem::zeroed();
        (&raw mut value).cast::<usize>().write(size_of::<T>());
        value
    }
}

fn lent<T: Copy>(lend: impl FnOnce(*mut T) -> gusset_status) -> T {
    let mut view = sized();
    assert_eq!(lend(&raw mut view), GUSSET_OK);
    view
}

const DEFAULTS: *const gusset::capi::context::gusset_context = ptr::null();

#[test]
fn the_parts_that_a_form_of_a_curve_does_not_have() {
    let (points, ends) = ([0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0u32, 1, 2, 3]);
    // SAFETY: arrays as long as the counts say, and handles that live.
    unsafe {
        let curve: Made<gusset_curve> = made(gusset_curve_destroy, |out| {
            gusset_curve_create(DEFAULTS, points.as_ptr(), 4, 2, ends.as_ptr(), 4, 1, out)
        });
        let parts = |form: Made<gusset_curve_form>| {
            let view: gusset_curve_form_view = lent(|out| gusset_curve_form_get_view(form.handle, out));
            for (data, count) in [(view.points, view.point_count), (view.knots, view.knot_count)] {
                assert_eq!(data.is_null(), count == 0);
            }
            [view.points.is_null(), view.on_curve.is_null(), view.knots.is_null()]
        };
        let form = |format| {
            let export = |out| gusset_curve_export_create(DEFAULTS, curve.handle, format, 0.0, out);
            parts(made(gusset_curve_form_destroy, export))
        };
        assert_eq!(form(GUSSET_CURVE_FORMAT_SVG), [true, true, true]);
        assert_eq!(form(GUSSET_CURVE_FORMAT_CONTOUR), [false, false, true]);
        assert_eq!(form(GUSSET_CURVE_FORMAT_SPLINE), [false, true, false]);

        let (point, normal) = ([0.0, 5.0, 0.0], [0.0, 1.0, 0.0]);
        let none = made(gusset_places_destroy, |out| {
            gusset_curve_intersect_plane_create(DEFAULTS, curve.handle, point.as_ptr(), normal.as_ptr(), out)
        });
        let view: gusset_places_view = lent(|out| gusset_places_get_view(none.handle, out));
        assert_eq!((view.count, view.overlap_count), (0, 0));
        assert!(view.places.is_null() && view.points.is_null() && view.overlaps.is_null());
    }
}

#[test]
fn the_mesh_of_a_net_without_nodes() {
    let mut missing = [f64::NAN; 4];
    let [x, y, z] = [missing.as_mut_ptr().cast(); 3];
    let arrays = gusset_net_view { rows: 2, columns: 2, x, y, z, scalar: GUSSET_F64, ..sized() };
    // SAFETY: as above.
    unsafe {
        let net = made(gusset_net_destroy, |out| gusset_net_create(DEFAULTS, &raw const arrays, ptr::null(), 0, out));
        let mesh = made(gusset_result_destroy, |out| gusset_net_to_mesh(DEFAULTS, net.handle, ptr::null(), out));
        let view = lent(|out| gusset_result_get_mesh(mesh.handle, out));
        assert_eq!((view.vertex_count, view.face_count), (0, 0));
        assert!(view.positions.is_null() && view.face_corners.is_null() && !view.face_offsets.is_null());
    }
}

/// A square in a plane z.
unsafe fn plane(z: f64) -> Made<gusset_surface> {
    let nodes: Vec<[f64; 3]> = (0..16).map(|k| [f64::from(k / 4), f64::from(k % 4), z]).collect();
    let nodes = gusset_nodes { nodes: nodes.as_ptr().cast(), rows: 4, columns: 4, scalar: GUSSET_F64, ..sized() };
    // SAFETY: as above.
    unsafe {
        let sheet =
            made(gusset_sheet_destroy, |out| gusset_sheet_create(DEFAULTS, &raw const nodes, ptr::null(), 0, out));
        let sheets = [sheet.handle.cast_const()];
        made(gusset_surface_destroy, |out| gusset_surface_create(DEFAULTS, sheets.as_ptr(), 1, ptr::null(), out))
    }
}

#[test]
fn questions_about_a_surface_that_nothing_answers() {
    let (far, level) = ([0.0, 0.0, 9.0], 0.0);
    let height = gusset_contour_function { point: far, direction: [0.0, 0.0, 1.0], ..sized() };
    let near = gusset_nearest_options { limit: 0.5, ..sized() };
    // SAFETY: as above.
    unsafe {
        let (surface, other) = (plane(0.0), plane(5.0));
        let paths = made(gusset_surface_paths_destroy, |out| {
            gusset_surface_contours_create(
                DEFAULTS,
                surface.handle,
                &raw const height,
                &raw const level,
                1,
                ptr::null(),
                out,
            )
        });
        let view: gusset_surface_paths_view = lent(|out| gusset_surface_paths_get_view(paths.handle, out));
        assert_eq!((view.path_count, view.point_count, view.unresolved_count), (0, 0, 0));
        assert!(view.closed.is_null() && view.levels.is_null() && view.points.is_null() && view.normals.is_null());
        assert!(view.places.is_null() && view.others.is_null() && view.unresolved.is_null());

        let hits = made(gusset_surface_hits_destroy, |out| {
            let (lines, curve) = (ptr::null(), ptr::null());
            gusset_surface_hits_create(DEFAULTS, surface.handle, lines, 0, curve, GUSSET_HITS_ALL, out)
        });
        let view: gusset_surface_hits_view = lent(|out| gusset_surface_hits_get_view(hits.handle, out));
        assert_eq!((view.hit_count, view.hits.is_null(), view.on_curve.is_null()), (0, true, true));

        let points = made(gusset_surface_points_destroy, |out| {
            gusset_surface_minima_create(DEFAULTS, surface.handle, far.as_ptr(), &raw const near, out)
        });
        let view: gusset_surface_points_view = lent(|out| gusset_surface_points_get_view(points.handle, out));
        assert_eq!((view.count, view.points.is_null()), (0, true));

        let region = made(gusset_surface_cells_destroy, |out| {
            gusset_surface_region_create(DEFAULTS, surface.handle, far.as_ptr(), 0.5, out)
        });
        let view: gusset_surface_cells_view = lent(|out| gusset_surface_cells_get_view(region.handle, out));
        assert_eq!((view.cell_count, view.cells.is_null(), view.whole.is_null()), (0, true, true));

        let pairs = made(gusset_surface_cells_destroy, |out| {
            gusset_surface_cell_pairs_create(DEFAULTS, surface.handle, other.handle, 0.0, out)
        });
        let view: gusset_surface_cells_view = lent(|out| gusset_surface_cells_get_view(pairs.handle, out));
        assert_eq!((view.cell_count, view.cells.is_null(), view.others.is_null()), (0, true, true));
    }
}
