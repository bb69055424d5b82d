//! Repair: merging of pieces that touch, and consistent orientation of faces.
//!
//! * [`weld`]: merges coincident vertices; on borders, by sewing edge to edge.
//! * [`sew`]: welds borders that do not match vertex by vertex, by splitting edges.
//! * [`orient`]: turns faces over until neighbours agree, and turns closed surfaces outwards.
//! * [`nesting`](self): the closed components that enclose others.
//! * [`corner_origins`]: origins of the corners of a repaired mesh.
//! * [`vertex_clusters`](self): clusters of coincident vertices.
//! * [`sew_edges`](self): pairs of edges that can be sewn without harm.
//! * [`vertex_corners`](self): the corners at each vertex.
//! * [`weld_tolerance`](self): the largest distance between copies of one vertex.
//! * [`t_junctions`](self): the splits of free edges.
//! * [`split_mesh`](self), [`split_face`](self): faces with split edges.

mod vertex_clusters;
pub mod corner_origins;
mod vertex_corners;
mod cluster_across;
pub mod near_borders;
mod nesting;
mod t_junctions;
pub mod orient;
pub(crate) mod sew_edges;
pub mod sew;
pub(crate) mod split_face;
mod split_mesh;
mod weld_tolerance;
pub mod weld;

pub(crate) use vertex_clusters::border_clusters;
pub(crate) use weld_tolerance::coordinate_round_off;
