//! Meshes and heights: Converts nets to meshes and back, and heights to nets.

use crate::capi::context::{create_handle, create_handle_and_outputs, gusset_context, lend};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice, read_flag};
use crate::capi::mesh::gusset_scalar;
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::convert::{Diagonal, Heights, MeshOptions, net_of_grid, net_of_heights, net_of_triangles};
use crate::net::{Coordinates, Net, Real, Shape, XyzMatrices};
use gusset_base::alloc;
use gusset_base::geom::strided::Strided;
use std::ffi::c_void;
use std::ptr;

/// Faces of a net's mesh.
pub type gusset_net_faces = u32;
/// Quads, and triangles where a side of a cell is a point.
pub const GUSSET_NET_QUADS: gusset_net_faces = 0;
/// Triangles, cut by the shorter diagonal, or the other if that edge exists.
pub const GUSSET_NET_TRIANGLES_SHORTER: gusset_net_faces = 1;
/// Triangles, cut from (i, j) to (i + 1, j + 1), with the same exception.
pub const GUSSET_NET_TRIANGLES_FIXED: gusset_net_faces = 2;

/// Options of gusset_net_to_mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_mesh_options {
    /// sizeof(gusset_net_mesh_options).
    pub struct_size: usize,
    /// Faces of a net's mesh.
    pub faces: gusset_net_faces,
    /// 1: a vertex for each node; 0: glued nodes are one.
    /// @flag
    pub no_weld: u32,
    /// 1: keeps finite vertices without faces and wires.
    /// @flag
    pub keep_unused: u32,
    /// 1: a cell with exactly one missing corner becomes a triangle.
    /// @flag
    pub fill_corners: u32,
    /// 1: computes texture coordinates.
    /// @flag
    pub texture: u32,
    /// 0.
    pub reserved: u32,
    /// Omits faces with edges above this multiple of the median edge; 0: no limit. 4 removes depth
    /// jumps from range images.
    pub max_edge_ratio: f64,
}

/// Maps between a net and its mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_mesh_report {
    /// sizeof(gusset_net_mesh_report).
    pub struct_size: usize,
    /// Vertex of each node, or UINT32_MAX.
    pub vertex_of_node: gusset_indices,
    /// First node of each vertex.
    pub node_of_vertex: gusset_indices,
    /// Cell of each face.
    pub cell_of_face: gusset_indices,
    /// Edges without faces, two vertices each: cells with opposite sides glued.
    /// @shape * 2
    pub wires: gusset_indices,
    /// For each corner, its pair in texture_coordinates; empty unless requested.
    pub texture_corners: gusset_indices,
    /// Pairs (column, row), 0 to 1. A vertex on a seam has a pair on each side.
    /// @shape texture_count 2
    pub texture_coordinates: *const f64,
    /// Number of pairs.
    pub texture_count: usize,
}

/// Heights over a regular grid.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_heights {
    /// sizeof(gusset_heights).
    pub struct_size: usize,
    /// At least 2.
    pub rows: usize,
    /// At least 2.
    pub columns: usize,
    /// Heights, contiguous in rows. NaN and infinity mark missing nodes.
    pub values: *const c_void,
    /// Stride of rows.
    pub row_stride: usize,
    /// x from column to column, y from row to row; not 0.
    pub spacing: [f64; 2],
    /// Position of node (0, 0) at height 0.
    pub origin: [f64; 3],
    /// Height of missing nodes, if has_no_data.
    pub no_data: f64,
    /// 0 or 1.
    pub has_no_data: u32,
    /// Type of heights and net.
    pub scalar: gusset_scalar,
}

/// Faces of a cell of the given grid.
pub type gusset_grid_cells = u32;
/// One quad for each cell; a triangle beside a pole.
pub const GUSSET_GRID_QUADS: gusset_grid_cells = 0;
/// Two triangles for each cell.
pub const GUSSET_GRID_TRIANGLES: gusset_grid_cells = 1;

/// Options of gusset_net_from_mesh_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_grid_options {
    /// sizeof(gusset_net_grid_options).
    pub struct_size: usize,
    /// Faces of a cell of the given grid.
    pub cells: gusset_grid_cells,
    /// 1: only the component of face must be a grid; 0: all.
    /// @when cells GUSSET_GRID_QUADS
    /// @flag
    pub has_face: u32,
    /// Face of the component.
    /// @when has_face 1
    pub face: u32,
    /// 0.
    pub reserved: u32,
}

/// Correspondence between a net and its mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_grid_view {
    /// sizeof(gusset_net_grid_view).
    pub struct_size: usize,
    /// Vertex of each node.
    pub vertex_of_node: gusset_indices,
    /// Face of each cell, the first of two for GUSSET_GRID_TRIANGLES.
    pub face_of_cell: gusset_indices,
}

/// Correspondence between a net and its mesh.
pub struct gusset_net_grid {
    vertex_of_node: Vec<u32>,
    face_of_cell: Vec<u32>,
}

handle! { gusset_net_grid }

versioned! {
    gusset_net_mesh_options: 40 reserved,
    gusset_net_mesh_report: 104,
    gusset_heights: 96,
    gusset_net_grid_options: 24 reserved,
    gusset_net_grid_view: 40,
}

impl gusset_net_mesh_options {
    fn checked(self) -> Result<MeshOptions, Failure> {
        Ok(MeshOptions {
            triangles: match self.faces {
                GUSSET_NET_QUADS => None,
                GUSSET_NET_TRIANGLES_SHORTER => Some(Diagonal::Shorter),
                GUSSET_NET_TRIANGLES_FIXED => Some(Diagonal::Fixed),
                other => {
                    return Err(Failure::unknown_choice(
                        "faces",
                        other,
                        &constants![GUSSET_NET_QUADS, GUSSET_NET_TRIANGLES_SHORTER, GUSSET_NET_TRIANGLES_FIXED],
                    ));
                }
            },
            weld: !read_flag(self.no_weld, "no_weld")?,
            keep_unused: read_flag(self.keep_unused, "keep_unused")?,
            fill_corners: read_flag(self.fill_corners, "fill_corners")?,
            texture: read_flag(self.texture, "texture")?,
            max_edge_ratio: (self.max_edge_ratio != 0.0).then_some(self.max_edge_ratio),
        })
    }
}

/// Makes the mesh of a net.
///
/// Glued nodes become one vertex, closed nets closed meshes. Absent cells are omitted; the mesh may
/// lack faces. Faces have the net's orientation.
///
/// @errors OUT_OF_RANGE (max_edge_ratio), TOO_LARGE (UINT32_MAX corners or more)
/// @complexity O(nodes), and O(w log w) for w cells with opposite sides glued.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_to_mesh(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_mesh_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        Ok(gusset_result(OperationResult::NetMesh(net_of_handle(net)?.to_mesh(&options, job)?)))
    })
}

/// Lends the maps.
///
/// @errors WRONG_HANDLE
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_net_mesh(
    result: *const gusset_result,
    report: *mut gusset_net_mesh_report,
) -> gusset_status {
    report!(result, report, "gusset_net_to_mesh", OperationResult::NetMesh(made) => {
        let (coordinates, corners) =
            made.texture.as_ref().map_or((&[][..], &[][..]), |texture| (&texture.coordinates, &texture.corners));
        gusset_net_mesh_report {
            struct_size: size_of::<gusset_net_mesh_report>(),
            vertex_of_node: gusset_indices::lend_indices(&made.vertex_of_node),
            node_of_vertex: gusset_indices::lend_indices(&made.node_of_vertex),
            cell_of_face: gusset_indices::lend_indices(&made.cell_of_face),
            wires: gusset_indices::lend_indices(made.wires.as_flattened()),
            texture_corners: gusset_indices::lend_indices(corners),
            texture_coordinates: lend_list(coordinates).cast(),
            texture_count: coordinates.len(),
        }
    })
}

/// Copies the caller's numbers, at any alignment, without the gaps between rows.
fn read_heights<T: Real>(shape: Shape, heights: &gusset_heights) -> Result<Vec<T>, Failure> {
    let (count, stride, row) = (shape.rows(), heights.row_stride, shape.columns() * size_of::<T>());
    let bytes =
        input::input_bytes(heights.values, Strided::byte_span(count, stride, row, "rows of values")?, 1, "values")?;
    let rows = Strided::new(bytes, count, stride, row, "rows of values")?;
    let mut values = alloc::with_capacity(shape.node_count())?;
    for i in 0..count {
        values.extend(rows.bytes(i).chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned::<T>));
    }
    Ok(values)
}

fn net_of_c_heights<T: Real>(heights: &gusset_heights, job: &Job<'_>) -> Result<Net<'static>, Failure>
where
    Coordinates<'static>: From<XyzMatrices<'static, T>>,
{
    let shape = Shape::new(heights.rows, heights.columns)?;
    let has_no_data = read_flag(heights.has_no_data, "has_no_data")?;
    let values = read_heights::<T>(shape, heights)?;
    let heights = Heights {
        shape,
        values: &values,
        stride: 0,
        spacing: heights.spacing,
        origin: heights.origin.into(),
        no_data: has_no_data.then_some(heights.no_data),
    };
    Ok(net_of_heights(&heights, job)?)
}

/// Makes a net from heights: node (i, j) is at origin + (j spacing[0], i spacing[1], height).
///
/// Faces are counter-clockwise from above, for any sign of spacing.
///
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OUT_OF_RANGE (spacing, origin)
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_from_heights_create(
    context: *const gusset_context,
    heights: *const gusset_heights,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |job| {
        let heights = input::read_versioned_struct(heights, false, "heights")?;
        Ok(gusset_net::new(match read_choice(heights.scalar)? {
            Scalar::F32 => net_of_c_heights::<f32>(&heights, job)?,
            Scalar::F64 => net_of_c_heights::<f64>(&heights, job)?,
        }))
    })
}

/// Finds rows and columns in a mesh, and makes their net, bit for bit.
///
/// The quads form a rectangle of at least one row, possibly closed in either direction. Fans of
/// triangles around poles may adjoin its first and last row. Rows follow the only closed direction,
/// else the first edge of the first quad.
///
/// GUSSET_GRID_TRIANGLES: either diagonal cuts each quad.
///
/// - Among several grids, the choice is deterministic; a torus may close with a shift, unlike the
///   original.
/// - It may refuse tubes and tori with irregular diagonals, and poles of open sheets with under six
///   triangles.
///
/// @param grid receives the correspondence, or NULL.
/// @errors NO_GRID (face that violates the grid)
/// @complexity O(H log d). Closed triangle meshes without distinct poles take several attempts.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_from_mesh_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_net_grid_options,
    grid: *mut *mut gusset_net_grid,
    net: *mut *mut gusset_net,
) -> gusset_status {
    let slot = input::cleared_optional_output(grid, ptr::null_mut(), "grid");
    let found = |job: &Job<'_>| {
        let slot = slot?;
        let options = input::read_versioned_struct(options, true, "options")?;
        let face = read_flag(options.has_face, "has_face")?.then_some(options.face);
        let given_mesh = self::mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let (view, job) = (given_mesh.mesh_view(), job.sub_job(0.1, 1.0));
        let found = match options.cells {
            GUSSET_GRID_QUADS => net_of_grid(&view, face, &job)?,
            GUSSET_GRID_TRIANGLES => net_of_triangles(&view, &job)?,
            other => {
                return Err(Failure::unknown_choice(
                    "cells",
                    other,
                    &constants![GUSSET_GRID_QUADS, GUSSET_GRID_TRIANGLES],
                ));
            }
        };
        let (vertex_of_node, face_of_cell) = (found.vertex_of_node, found.face_of_cell);
        Ok((
            gusset_net::new(found.net),
            (slot, handle::box_with_kind(gusset_net_grid { vertex_of_node, face_of_cell })),
        ))
    };
    create_handle_and_outputs(context, net, "net", found, |(slot, grid)| {
        if let Some(slot) = slot {
            *slot = handle::into_handle(grid);
        }
    })
}

/// Destroys a grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_grid_destroy(grid: *mut gusset_net_grid) {
    handle::destroy(grid);
}

/// Lends a grid.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_grid_get_view(
    grid: *const gusset_net_grid,
    view: *mut gusset_net_grid_view,
) -> gusset_status {
    lend!(grid, view, |grid| gusset_net_grid_view {
        struct_size: size_of::<gusset_net_grid_view>(),
        vertex_of_node: gusset_indices::lend_indices(&grid.vertex_of_node),
        face_of_cell: gusset_indices::lend_indices(&grid.face_of_cell),
    })
}
