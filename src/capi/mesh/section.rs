//! Mesh sections: Cuts meshes by planes into ordered polylines.

use crate::attributes::Origins;
use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, constants, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice, read_flag};
use crate::capi::mesh::origins::gusset_origins;
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::mesh::section::{
    InPlane, Options, Plane, PlaneStack, SectionPath, Sections, cut_by_planes, cut_by_stack, planes_about_axis,
    planes_across_polyline,
};
use glam::DVec3;
use gusset_base::alloc;

/// Side of vertices in a plane.
pub type gusset_in_plane = u32;
/// They count as above: the section is the limit from just below the plane.
pub const GUSSET_IN_PLANE_ABOVE: gusset_in_plane = 0;
/// They count as below: the section is the limit from just above the plane.
pub const GUSSET_IN_PLANE_BELOW: gusset_in_plane = 1;

c_enum! { in_plane: InPlane { GUSSET_IN_PLANE_ABOVE => Above, GUSSET_IN_PLANE_BELOW => Below } }

/// Kind of cutting planes.
pub type gusset_cutting_kind = u32;
/// Parallel planes with the normal `direction`, at rising distances `values` from `point`.
pub const GUSSET_CUTTING_STACK: gusset_cutting_kind = 0;
/// Planes through `points`, each with its normal in `normals`.
pub const GUSSET_CUTTING_PLANES: gusset_cutting_kind = 1;
/// Planes through the axis at `point` along `direction`, turned from `reference` by the angles
/// `values`. Normals point to larger angles.
pub const GUSSET_CUTTING_AXIS: gusset_cutting_kind = 2;
/// Planes across the polyline `points`, at the distances `values` from its first point along it.
/// They turn evenly from each vertex's bisector to the next.
pub const GUSSET_CUTTING_CURVE: gusset_cutting_kind = 3;

/// Planes that cut a mesh. Only the fields of their kind are read.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_cutting_planes {
    /// sizeof(gusset_cutting_planes).
    pub struct_size: usize,
    /// Kind of cutting planes.
    pub kind: gusset_cutting_kind,
    /// CURVE. 1: the polyline returns to its first point.
    pub closed: u32,
    /// STACK, AXIS: a point at distance 0, or of the axis.
    pub point: [f64; 3],
    /// STACK, AXIS: not 0.
    pub direction: [f64; 3],
    /// AXIS: not parallel to `direction`.
    pub reference: [f64; 3],
    /// STACK, AXIS, CURVE: distances or angles.
    pub values: *const f64,
    /// Number of values.
    pub value_count: usize,
    /// PLANES, CURVE: x, y, z each.
    pub points: *const f64,
    /// PLANES: x, y, z each, not 0.
    pub normals: *const f64,
    /// Number of points, and of normals.
    pub point_count: usize,
}

/// Options of gusset_mesh_sections_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_mesh_section_options {
    /// sizeof(gusset_mesh_section_options).
    pub struct_size: usize,
    /// Leaves out points up to this far from the polyline; 0: keeps all points. Polylines with points
    /// left out may cross each other or themselves.
    pub tolerance: f64,
    /// Side of vertices in a plane.
    pub in_plane: gusset_in_plane,
    /// 0.
    pub reserved: u32,
}

/// A polyline of a section.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_section_path {
    /// Index of the plane.
    pub plane: u32,
    /// 1: returns to its first point, not repeated.
    /// @flag
    pub closed: u32,
    /// Smallest closed path of the plane around a closed path, or UINT32_MAX.
    pub parent: u32,
    /// Number of closed paths around a closed path; else 0.
    pub depth: u32,
    /// Length, with all points.
    pub length: f64,
    /// Area inside a closed path, with all points, positive if counter-clockwise seen against the
    /// plane's normal; else 0.
    pub area: f64,
}

/// Sections of a mesh.
pub struct gusset_mesh_sections {
    sections: Sections,
    paths: Vec<gusset_section_path>,
    /// The numbers of vertices, corners and faces of the mesh.
    counts: crate::attributes::Counts,
}

handle! { gusset_mesh_sections }

/// Lent polylines, by plane, then by lowest face.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_mesh_sections_view {
    /// sizeof(gusset_mesh_sections_view).
    pub struct_size: usize,
    /// Number of planes.
    pub plane_count: usize,
    /// Number of polylines.
    pub path_count: usize,
    /// Number of points.
    pub point_count: usize,
    /// The polylines.
    /// @shape path_count
    pub paths: *const gusset_section_path,
    /// Polyline k has the points starts[k] to starts[k + 1] - 1.
    pub starts: gusset_indices,
    /// The points.
    /// @shape point_count 3
    pub points: *const f64,
    /// Ends of the edge of each point; equal at a vertex in the plane.
    /// @shape point_count 2
    pub edges: *const u32,
    /// Parameter of each point on its edge, 0 to 1.
    /// @shape point_count
    pub parameters: *const f64,
    /// Face of the segment after each point, the first if points were left out; UINT32_MAX at an
    /// open path's end.
    pub faces: gusset_indices,
}

versioned! {
    gusset_cutting_planes: 128,
    gusset_mesh_section_options: 24 reserved,
    gusset_mesh_sections_view: 96,
}
fixed! { gusset_section_path: 32 }

impl From<&SectionPath> for gusset_section_path {
    fn from(path: &SectionPath) -> Self {
        let SectionPath { plane, is_closed, parent, depth, length, area } = *path;
        gusset_section_path { plane, closed: is_closed.into(), parent, depth, length, area }
    }
}

/// Copies packed vectors of the caller.
fn read_vectors(vectors: *const f64, count: usize, name: &'static str) -> Result<Vec<DVec3>, Failure> {
    let numbers = input::copy_input_items(vectors, input::checked_product(count, 3, name)?, name)?;
    Ok(alloc::collect(numbers.chunks_exact(3).map(DVec3::from_slice))?)
}

/// Cuts a mesh by planes into ordered polylines, with nesting and sources.
///
/// A polyline runs along the plane's normal x the face's normal: around a solid, outer loops are
/// counter-clockwise seen against the plane's normal, holes clockwise.
///
/// Sides of planes are exact. Vertices in a plane count as above it (GUSSET_IN_PLANE_BELOW: below).
/// A closed mesh therefore gives closed loops only. An edge in the plane appears if a face beside
/// it is below (above), or there and back if both are. Faces in the plane and peaks give nothing.
///
/// At a non-manifold edge, loops around the inside of solids touch but do not cross. Paths end at
/// borders. Faces with fewer than three sides between different vertices are left out.
///
/// @errors OUT_OF_RANGE (vectors, values, tolerance, coordinates beyond 1e150), NOT_FINITE (point),
///     EMPTY_CURVE (polyline without length), TOO_LARGE, as gusset_mesh_view
/// @complexity O(V log n + H + s log s) for n planes of a stack and s crossed faces, parallel.
///     Otherwise O(n (V + H) + s log s). Nesting takes O(c log c) for c crossings of loops and lines:
///     few lines pierce all loops, but many long loops beside many small ones make c quadratic.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_mesh_sections_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    planes: *const gusset_cutting_planes,
    options: *const gusset_mesh_section_options,
    sections: *mut *mut gusset_mesh_sections,
) -> gusset_status {
    create_handle(context, sections, "sections", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let options = Options { in_plane: read_choice(options.in_plane)?, tolerance: options.tolerance };
        let planes = input::read_versioned_struct(planes, false, "planes")?;
        let [point, direction, reference] = [planes.point, planes.direction, planes.reference].map(DVec3::from_array);
        let values = || input::copy_input_items(planes.values, planes.value_count, "values");
        let points = || read_vectors(planes.points, planes.point_count, "points");
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let (mesh, job) = (given_mesh.mesh_view(), job.sub_job(0.2, 1.0));
        let sections = match planes.kind {
            GUSSET_CUTTING_STACK => {
                let stack = PlaneStack { point, normal: direction, offsets: &values()? };
                cut_by_stack(&mesh, &stack, &options, &job)?
            }
            GUSSET_CUTTING_PLANES => {
                let normals = read_vectors(planes.normals, planes.point_count, "normals")?;
                let each = points()?.into_iter().zip(normals).map(|(point, normal)| Plane { point, normal });
                cut_by_planes(&mesh, &alloc::gather(each)?, &options, &job)?
            }
            GUSSET_CUTTING_AXIS => {
                let about = planes_about_axis(point, direction, reference, &values()?)?;
                cut_by_planes(&mesh, &about, &options, &job)?
            }
            GUSSET_CUTTING_CURVE => {
                let is_closed = read_flag(planes.closed, "closed")?;
                cut_by_planes(&mesh, &planes_across_polyline(&points()?, is_closed, &values()?)?, &options, &job)?
            }
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![GUSSET_CUTTING_STACK, GUSSET_CUTTING_PLANES, GUSSET_CUTTING_AXIS, GUSSET_CUTTING_CURVE],
                ));
            }
        };
        let paths = alloc::collect(sections.paths().iter().map(gusset_section_path::from))?;
        Ok(gusset_mesh_sections { sections, paths, counts: crate::attributes::Counts::from_mesh(&mesh) })
    })
}

/// Destroys sections.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_mesh_sections_destroy(sections: *mut gusset_mesh_sections) {
    handle::destroy(sections);
}

/// Lends the polylines.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_mesh_sections_get_view(
    sections: *const gusset_mesh_sections,
    view: *mut gusset_mesh_sections_view,
) -> gusset_status {
    lend!(sections, view, |gusset_mesh_sections { sections, paths, .. }| gusset_mesh_sections_view {
        struct_size: size_of::<gusset_mesh_sections_view>(),
        plane_count: sections.plane_count(),
        path_count: paths.len(),
        point_count: sections.points().len(),
        paths: lend_list(paths),
        starts: gusset_indices::lend_indices(sections.starts()),
        points: lend_list(sections.points()).cast(),
        edges: lend_list(sections.edges().as_flattened()),
        parameters: lend_list(sections.parameters()),
        faces: gusset_indices::lend_indices(sections.faces()),
    })
}

/// Finds the sources of section points: the ends of their edges, weighted by the parameter. Faces
/// of the origins are segments, one for each point, with the mesh's faces as sources. Corners are
/// empty.
///
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_mesh_sections_origins_create(
    context: *const gusset_context,
    sections: *const gusset_mesh_sections,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create_handle(context, origins, "origins", |job| {
        let gusset_mesh_sections { sections, counts, .. } = handle::get_object(sections, "sections")?;
        Ok(gusset_origins(Origins::from_sections(sections, *counts, job)?))
    })
}
