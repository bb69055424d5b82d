//! The quotient surface: The surface that a net becomes when glued nodes are one.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::mesh::gusset_indices;
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::net::complex::Complex;

/// Which cells count.
pub type gusset_net_cells = u32;
/// All.
pub const GUSSET_NET_CELLS_ALL: gusset_net_cells = 0;
/// Those whose four nodes have finite coordinates and that no hidden bridge has.
pub const GUSSET_NET_CELLS_PRESENT: gusset_net_cells = 1;

/// Bits that describe the surface of a net.
/// @bits
pub type gusset_net_flags = u32;
/// No edge has one face only.
pub const GUSSET_NET_CLOSED: gusset_net_flags = 1;
/// A surface, with or without boundary: no wires, branches and pinches.
pub const GUSSET_NET_MANIFOLD: gusset_net_flags = 2;
/// No edge that two faces run along the same way.
pub const GUSSET_NET_ORIENTED: gusset_net_flags = 4;
/// Faces can be turned over so that there is none.
pub const GUSSET_NET_ORIENTABLE: gusset_net_flags = 8;

/// The quotient complex of a net: what surface it is. Opaque and immutable; it keeps nothing of the
/// net.
pub struct gusset_net_complex(Complex);

handle! { gusset_net_complex }

/// Numbers of a complex, and whatever keeps it from being a closed oriented surface. Vertices are
/// given by their smallest nodes, edges as pairs of them, one pair after the other, in order.
/// Pointers are valid until the complex is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_complex_view {
    /// sizeof(gusset_net_complex_view), set by the caller.
    pub struct_size: usize,
    /// Vertices.
    pub vertex_count: u64,
    /// Edges: pairs of vertices that links join.
    pub edge_count: u64,
    /// Faces of four corners.
    pub quad_count: u64,
    /// Faces of three.
    pub triangle_count: u64,
    /// Cells that have become an edge.
    pub digon_count: u64,
    /// Cells that have become a point.
    pub point_count: u64,
    /// Cells that are folded along a diagonal to two edges.
    pub fold_count: u64,
    /// Edges of one face.
    pub boundary_edge_count: u64,
    /// Pieces that do not hang together.
    pub component_count: u64,
    /// Vertices - edges + faces.
    pub euler: i64,
    /// Handles if it is orientable, else crosscaps, of all pieces together; -1 if it is no surface.
    pub genus: i64,
    /// GUSSET_NET_CLOSED, ..._MANIFOLD, ..._ORIENTED, ..._ORIENTABLE.
    pub properties: gusset_net_flags,
    /// 0.
    pub reserved: u32,
    /// 0, then the end of each chain of boundary edges in boundary_nodes: one more than there are
    /// chains.
    pub boundary_offsets: gusset_indices,
    /// The vertices of all chains, with the faces on the left; the last of a chain is followed by
    /// its first.
    pub boundary_nodes: gusset_indices,
    /// For each chain 0, or 1 if it is no loop: it ends at edges of three faces and more, and its
    /// last vertex is followed by none.
    pub boundary_open: gusset_indices,
    /// Edges of no face.
    pub wires: gusset_indices,
    /// Edges of three faces and more.
    pub branches: gusset_indices,
    /// Vertices whose faces are several fans that meet nowhere else.
    pub pinches: gusset_indices,
    /// Edges that two faces run along the same way.
    pub conflicts: gusset_indices,
}

versioned! { gusset_net_complex_view: 216 }

/// Finds out what surface a net is once glued nodes are one.
///
/// What it finds is no error.
///
/// @errors TOO_LARGE (2^31 edges of one face)
/// @complexity O(nodes), and a sort of what belongs to each glued node; linear extra memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_complex_create(
    context: *const gusset_context,
    net: *const gusset_net,
    cells: gusset_net_cells,
    quotient: *mut *mut gusset_net_complex,
) -> gusset_status {
    create(context, quotient, "quotient", |job| {
        let net = read(net)?;
        Ok(gusset_net_complex(match cells {
            GUSSET_NET_CELLS_ALL => Complex::of_topology(net.topology(), job)?,
            GUSSET_NET_CELLS_PRESENT => Complex::of(net, job)?,
            other => return Err(Failure::unknown("cells", other.into())),
        }))
    })
}

/// Lends what is known of a complex.
///
/// @param view receives it; struct_size is set by the caller.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_complex_get_view(
    quotient: *const gusset_net_complex,
    view: *mut gusset_net_complex_view,
) -> gusset_status {
    lend!(quotient, view, |gusset_net_complex(c)| {
        let bit = |set, bit| if set { bit } else { 0 };
        gusset_net_complex_view {
            struct_size: 0,
            vertex_count: c.vertices,
            edge_count: c.edges,
            quad_count: c.quads,
            triangle_count: c.triangles,
            digon_count: c.digons,
            point_count: c.points,
            fold_count: c.folds,
            boundary_edge_count: c.boundary_edges,
            component_count: c.components,
            euler: c.euler_characteristic(),
            genus: c.genus().map_or(-1, |genus| genus as i64),
            properties: bit(c.is_closed(), GUSSET_NET_CLOSED)
                | bit(c.is_manifold(), GUSSET_NET_MANIFOLD)
                | bit(c.conflicts.is_empty(), GUSSET_NET_ORIENTED)
                | bit(c.orientable, GUSSET_NET_ORIENTABLE),
            reserved: 0,
            boundary_offsets: gusset_indices::lend(c.boundary.offsets()),
            boundary_nodes: gusset_indices::lend(c.boundary.nodes()),
            boundary_open: gusset_indices::lend(c.boundary.open()),
            wires: gusset_indices::lend(c.wires.as_flattened()),
            branches: gusset_indices::lend(c.branches.as_flattened()),
            pinches: gusset_indices::lend(&c.pinches),
            conflicts: gusset_indices::lend(c.conflicts.as_flattened()),
        }
    })
}

/// Destroys a complex; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_complex_destroy(quotient: *mut gusset_net_complex) {
    handle::destroy(quotient);
}
