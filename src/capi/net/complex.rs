//! The quotient surface: The surface of a net with glued nodes merged.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::mesh::gusset_indices;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::net::complex::Complex;

/// Cells that count.
pub type gusset_net_cells = u32;
/// All cells.
pub const GUSSET_NET_CELLS_ALL: gusset_net_cells = 0;
/// Cells that are not absent; see gusset_net.
pub const GUSSET_NET_CELLS_PRESENT: gusset_net_cells = 1;

/// Properties of the surface of a net.
/// @bits
pub type gusset_net_flags = u32;
/// No boundary edges.
pub const GUSSET_NET_CLOSED: gusset_net_flags = 1;
/// Manifold, with or without boundary: no wires, branches, pinches.
pub const GUSSET_NET_MANIFOLD: gusset_net_flags = 2;
/// Consistent orientation of faces.
pub const GUSSET_NET_ORIENTED: gusset_net_flags = 4;
/// Consistent after reversal of some faces.
pub const GUSSET_NET_ORIENTABLE: gusset_net_flags = 8;

/// Quotient complex: the surface of a net.
pub struct gusset_net_complex(Complex);

handle! { gusset_net_complex }

/// Counts, and sorted lists of defects. A vertex is its smallest node, an edge a pair.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_complex_view {
    /// sizeof(gusset_net_complex_view).
    pub struct_size: usize,
    /// Number of vertices.
    pub vertex_count: u64,
    /// Edges; links with equal ends are one.
    pub edge_count: u64,
    /// Number of quads.
    pub quad_count: u64,
    /// Number of triangles.
    pub triangle_count: u64,
    /// Cells reduced to an edge.
    pub digon_count: u64,
    /// Cells reduced to a point.
    pub point_count: u64,
    /// Cells folded along a diagonal.
    pub fold_count: u64,
    /// Number of boundary edges.
    pub boundary_edge_count: u64,
    /// Number of connected components.
    pub component_count: u64,
    /// Vertices - edges + faces.
    pub euler: i64,
    /// Handles, or crosscaps if not orientable, of all components; -1 if not manifold.
    pub genus: i64,
    /// Properties of the surface of a net.
    pub properties: gusset_net_flags,
    /// 0.
    pub reserved: u32,
    /// Offsets into boundary_nodes, by chain.
    pub boundary_offsets: gusset_indices,
    /// Vertices of chains of boundary edges, faces on the left.
    pub boundary_nodes: gusset_indices,
    /// For each chain: 1 if it ends at branches, 0 for a loop.
    /// @flag
    pub boundary_open: gusset_indices,
    /// Edges without faces.
    /// @shape * 2
    pub wires: gusset_indices,
    /// Non-manifold edges.
    /// @shape * 2
    pub branches: gusset_indices,
    /// Vertices whose faces form several fans.
    pub pinches: gusset_indices,
    /// Edges that two faces traverse in one direction.
    /// @shape * 2
    pub conflicts: gusset_indices,
}

versioned! { gusset_net_complex_view: 216 }

/// Determines a net's surface.
///
/// @errors TOO_LARGE (more than 2^31 boundary edges)
/// @complexity O(nodes), plus a sort of elements at glued nodes; linear memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_complex_create(
    context: *const gusset_context,
    net: *const gusset_net,
    cells: gusset_net_cells,
    quotient: *mut *mut gusset_net_complex,
) -> gusset_status {
    create_handle(context, quotient, "quotient", |job| {
        let net = net_of_handle(net)?;
        Ok(gusset_net_complex(match cells {
            GUSSET_NET_CELLS_ALL => Complex::from_topology(net.topology(), job)?,
            GUSSET_NET_CELLS_PRESENT => Complex::from_net(net, job)?,
            other => {
                return Err(Failure::unknown_choice(
                    "cells",
                    other,
                    &constants![GUSSET_NET_CELLS_ALL, GUSSET_NET_CELLS_PRESENT],
                ));
            }
        }))
    })
}

/// Lends the counts and defects.
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
            boundary_offsets: gusset_indices::lend_indices(c.boundary.offsets()),
            boundary_nodes: gusset_indices::lend_indices(c.boundary.nodes()),
            boundary_open: gusset_indices::lend_indices(c.boundary.open_chain_flags()),
            wires: gusset_indices::lend_indices(c.wires.as_flattened()),
            branches: gusset_indices::lend_indices(c.branches.as_flattened()),
            pinches: gusset_indices::lend_indices(&c.pinches),
            conflicts: gusset_indices::lend_indices(c.conflicts.as_flattened()),
        }
    })
}

/// Destroys a complex.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_complex_destroy(quotient: *mut gusset_net_complex) {
    handle::destroy(quotient);
}
