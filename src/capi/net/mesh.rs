//! Meshes and heights: Nets to meshes and back, and nets of height fields.

use crate::capi::context::{create, create_and_tell, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, flag, lent};
use crate::capi::mesh::gusset_scalar;
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::convert::{Diagonal, Heights, MeshOptions, net_of_grid, net_of_heights, net_of_triangles};
use crate::net::{Coordinates, Net, Planes, Real, Shape};
use gusset_base::alloc;
use gusset_base::geom::strided::Strided;
use std::ffi::c_void;
use std::ptr;

/// What the faces of the mesh of a net are.
pub type gusset_net_faces = u32;
/// Quads, and triangles where a side of a cell is one point.
pub const GUSSET_NET_QUADS: gusset_net_faces = 0;
/// Triangles: quads are cut along the shorter diagonal, or where that would be an edge that there
/// is already, the other one.
pub const GUSSET_NET_TRIANGLES_SHORTER: gusset_net_faces = 1;
/// Triangles: quads are cut from (i, j) to (i + 1, j + 1), with the same exception.
pub const GUSSET_NET_TRIANGLES_FIXED: gusset_net_faces = 2;

/// How a net becomes a mesh. All zeros: quads, one vertex for each class of glued nodes, only
/// vertices that something uses.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_mesh_options {
    /// sizeof(gusset_net_mesh_options), set by the caller.
    pub struct_size: usize,
    /// GUSSET_NET_QUADS, GUSSET_NET_TRIANGLES_SHORTER or GUSSET_NET_TRIANGLES_FIXED.
    pub faces: gusset_net_faces,
    /// 1: a vertex for each node, and nothing is glued. 0 or 1.
    /// @flag
    pub no_weld: u32,
    /// 1: finite vertices that nothing uses are kept. 0 or 1.
    /// @flag
    pub keep_unused: u32,
    /// 1: a cell of which just one corner is missing becomes a triangle. 0 or 1.
    /// @flag
    pub fill_corners: u32,
    /// 1: texture coordinates are wanted. 0 or 1.
    /// @flag
    pub texture: u32,
    /// 0.
    pub reserved: u32,
    /// Faces with an edge of more than so many times the median length of edges are left out: in a
    /// range image those that lead from one surface to another behind it, for which 4 is a good
    /// value. Above 0; 0 for no limit.
    pub max_edge_ratio: f64,
}

/// What became what when a net became a mesh. Pointers are valid until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_mesh_report {
    /// sizeof(gusset_net_mesh_report), set by the caller.
    pub struct_size: usize,
    /// For each node its vertex, or UINT32_MAX.
    pub vertex_of_node: gusset_indices,
    /// For each vertex the first of its nodes.
    pub node_of_vertex: gusset_indices,
    /// For each face its cell: cell (i, j) is i * (columns - 1) + j.
    pub cell_of_face: gusset_indices,
    /// Edges without faces, two vertices each: threads, and whatever else is left of cells whose
    /// opposite sides are glued.
    pub wires: gusset_indices,
    /// For each corner of the mesh its pair of texture coordinates; empty unless they were asked
    /// for.
    pub texture_corners: gusset_indices,
    /// Pairs u, v from 0 to 1: column and row. A vertex on a seam has one on each side of it.
    pub texture_coordinates: *const f64,
    /// The number of pairs.
    pub texture_count: usize,
}

/// Heights over a grid, at any alignment.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_heights {
    /// sizeof(gusset_heights), set by the caller.
    pub struct_size: usize,
    /// The number of rows, at least 2.
    pub rows: usize,
    /// The number of columns, at least 2.
    pub columns: usize,
    /// Number (i, j) is at values + i * row_stride + j times the scalar's size. Any numbers: NaN
    /// and infinities are missing.
    pub values: *const c_void,
    /// Bytes from row to row; 0 for rows without gaps.
    pub row_stride: usize,
    /// x from column to column and y from row to row; finite and not 0, negative where rows run
    /// against y.
    pub spacing: [f64; 2],
    /// Where the first node is if its height is 0.
    pub origin: [f64; 3],
    /// Read if has_no_data is 1: the number that stands for a missing height.
    pub no_data: f64,
    /// 0 or 1.
    pub has_no_data: u32,
    /// GUSSET_F32 or GUSSET_F64: of the values, and of the net.
    pub scalar: gusset_scalar,
}

/// The cells of a net that is sought in a mesh.
pub type gusset_grid_cells = u32;
/// Quads, with triangles at poles.
pub const GUSSET_GRID_QUADS: gusset_grid_cells = 0;
/// Triangles only, two for each cell.
pub const GUSSET_GRID_TRIANGLES: gusset_grid_cells = 1;

/// How a net is found in a mesh; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_grid_options {
    /// sizeof(gusset_net_grid_options), set by the caller.
    pub struct_size: usize,
    /// The cells of a net that is sought in a mesh.
    pub cells: gusset_grid_cells,
    /// 1: only the component of one face is a grid; 0: the mesh must be one grid. Read for GUSSET_GRID_QUADS.
    /// @when cells GUSSET_GRID_QUADS
    /// @flag
    pub has_face: u32,
    /// Read if has_face is 1: a face of the component.
    /// @when has_face 1
    /// @flag
    pub face: u32,
    /// 0.
    pub reserved: u32,
}

/// Where a net was found in a mesh. Pointers are valid until the grid is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_grid_view {
    /// sizeof(gusset_net_grid_view), set by the caller.
    pub struct_size: usize,
    /// For each node its vertex.
    pub vertex_of_node: gusset_indices,
    /// For each cell its face.
    pub face_of_cell: gusset_indices,
}

/// The places of a net in the mesh that it was found in. Opaque and immutable; it keeps nothing of the mesh.
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
                other => return Err(Failure::unknown("faces", other.into())),
            },
            weld: !flag(self.no_weld, "no_weld")?,
            keep_unused: flag(self.keep_unused, "keep_unused")?,
            fill_corners: flag(self.fill_corners, "fill_corners")?,
            texture: flag(self.texture, "texture")?,
            max_edge_ratio: (self.max_edge_ratio != 0.0).then_some(self.max_edge_ratio),
        })
    }
}

/// Makes the mesh of a net.
///
/// Cells with a missing corner and those of hidden bridges are left out; glued corners are one, so
/// that closed nets become closed meshes; faces are counter-clockwise as the net's are. A mesh
/// without faces is no failure. The grid of a range image becomes the mesh of what was seen by
/// triangles, fill_corners and max_edge_ratio.
///
/// @errors OUT_OF_RANGE, TOO_LARGE (2^32 - 1 corners and more)
/// @complexity O(nodes), and O(w log w) for w cells whose opposite sides are glued.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_to_mesh(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_mesh_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        Ok(gusset_result(Made::NetMesh(read(net)?.to_mesh(&options, job)?)))
    })
}

/// Lends the maps between the net and its mesh, for results of gusset_net_to_mesh.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_net_mesh(
    result: *const gusset_result,
    report: *mut gusset_net_mesh_report,
) -> gusset_status {
    report!(result, report, "gusset_net_to_mesh", Made::NetMesh(made) => {
        let (coordinates, corners) =
            made.texture.as_ref().map_or((&[][..], &[][..]), |texture| (&texture.coordinates, &texture.corners));
        gusset_net_mesh_report {
            struct_size: size_of::<gusset_net_mesh_report>(),
            vertex_of_node: gusset_indices::lend(&made.vertex_of_node),
            node_of_vertex: gusset_indices::lend(&made.node_of_vertex),
            cell_of_face: gusset_indices::lend(&made.cell_of_face),
            wires: gusset_indices::lend(made.wires.as_flattened()),
            texture_corners: gusset_indices::lend(corners),
            texture_coordinates: lent(coordinates).cast(),
            texture_count: coordinates.len(),
        }
    })
}

/// Numbers of the caller's, at any alignment, with the gaps between rows left out.
fn values<T: Real>(shape: Shape, heights: &gusset_heights) -> Result<Vec<T>, Failure> {
    let (count, stride, row) = (shape.rows(), heights.row_stride, shape.columns() * size_of::<T>());
    let bytes = input::bytes(heights.values, Strided::span(count, stride, row, "rows of values")?, 1, "values")?;
    let rows = Strided::new(bytes, count, stride, row, "rows of values")?;
    let mut values = alloc::with_capacity(shape.node_count())?;
    for i in 0..count {
        values.extend(rows.bytes(i).chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned::<T>));
    }
    Ok(values)
}

fn of_heights<T: Real>(heights: &gusset_heights, job: &Job<'_>) -> Result<Net<'static>, Failure>
where
    Coordinates<'static>: From<Planes<'static, T>>,
{
    let shape = Shape::new(heights.rows, heights.columns)?;
    let has_no_data = flag(heights.has_no_data, "has_no_data")?;
    let values = values::<T>(shape, heights)?;
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

/// Makes the net of heights over a grid: x = origin + j spacing, y = origin + i spacing, z = origin
/// + height.
///
/// Missing heights become missing nodes; faces are counter-clockwise from above, whichever way rows
/// and columns run.
///
/// @param heights the heights.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OUT_OF_RANGE (spacing, origin)
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_from_heights_create(
    context: *const gusset_context,
    heights: *const gusset_heights,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |job| {
        let heights = input::read(heights, false, "heights")?;
        Ok(gusset_net::new(match choice(heights.scalar)? {
            Scalar::F32 => of_heights::<f32>(&heights, job)?,
            Scalar::F64 => of_heights::<f64>(&heights, job)?,
        }))
    })
}

/// Finds rows and columns in a mesh, and makes the net of its vertices.
///
/// Quads form a rectangle, which may be closed round, with fans of triangles round a pole at its first
/// and last row, or either. Rows run as the first quad says, and round if only one direction is closed.
///
/// With GUSSET_GRID_TRIANGLES each quad is cut in two along either diagonal. Vertices and their bits are kept.
/// For each cell the grid lends the first of its two triangles. Where several pairings of the triangles
/// make a grid, as if all diagonals run one way, the same mesh always gives the same one. On a torus that
/// pairing may close with a shift, so that rows and columns differ from those it was made from. Tubes
/// and tori whose diagonals run without any rule may be refused, and so are fans of fewer than six
/// triangles at the pole of an open sheet; at least one row of quads is needed.
///
/// @param mesh see gusset_mesh_view.
/// @param options NULL for the defaults: quads, and the whole mesh is one grid.
/// @param grid receives where the net was found, for gusset_net_grid_destroy; NULL on failure. May
///     be NULL.
/// @errors NO_GRID (with a face that shows it)
/// @complexity O(H log d) for H half-edges and vertices of degree d; for closed nets of triangles
///     whose poles do not show by their degrees some attempts of that.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_from_mesh_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_net_grid_options,
    grid: *mut *mut gusset_net_grid,
    net: *mut *mut gusset_net,
) -> gusset_status {
    let slot = input::optional_output(grid, ptr::null_mut(), "grid");
    let found = |job: &Job<'_>| {
        let slot = slot?;
        let options = input::read(options, true, "options")?;
        let face = flag(options.has_face, "has_face")?.then_some(options.face);
        let given_mesh = self::mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let (view, job) = (given_mesh.view(), job.part(0.1, 1.0));
        let found = match options.cells {
            GUSSET_GRID_QUADS => net_of_grid(&view, face, &job)?,
            GUSSET_GRID_TRIANGLES => net_of_triangles(&view, &job)?,
            other => return Err(Failure::unknown("cells", other.into())),
        };
        let (vertex_of_node, face_of_cell) = (found.vertex_of_node, found.face_of_cell);
        Ok((gusset_net::new(found.net), (slot, handle::boxed(gusset_net_grid { vertex_of_node, face_of_cell }))))
    };
    create_and_tell(context, net, "net", found, |(slot, grid)| {
        if let Some(slot) = slot {
            *slot = handle::give(grid);
        }
    })
}

/// Destroys a grid; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_grid_destroy(grid: *mut gusset_net_grid) {
    handle::destroy(grid);
}

/// Lends where the net was found.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_grid_get_view(
    grid: *const gusset_net_grid,
    view: *mut gusset_net_grid_view,
) -> gusset_status {
    lend!(grid, view, |grid| gusset_net_grid_view {
        struct_size: size_of::<gusset_net_grid_view>(),
        vertex_of_node: gusset_indices::lend(&grid.vertex_of_node),
        face_of_cell: gusset_indices::lend(&grid.face_of_cell),
    })
}
