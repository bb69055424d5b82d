//! Repair: merging of pieces that touch, and consistent orientation of faces.
//!
//! * [`weld`]: merges coincident vertices; on borders, by sewing edge to edge.
//! * [`sew`]: welds borders that do not match vertex by vertex, by splitting edges.
//! * [`orient`]: turns faces over until neighbours agree, and turns closed surfaces outwards.
//! * [`corner_origins`]: origins of the corners of a repaired mesh.
//! * [`cluster`](self): clusters of coincident vertices.
//! * [`seams`](self): pairs of edges that can be sewn without harm.
//! * [`corners`](self): the corners at each vertex.
//! * [`tolerance`](self): the largest distance between copies of one vertex.
//! * [`junctions`](self): the splits of free edges.
//! * [`split_mesh`](self), [`split_face`](self): faces with split edges.

mod cluster;
pub mod corner_origins;
mod corners;
mod junctions;
pub mod orient;
mod seams;
pub mod sew;
mod split_face;
mod split_mesh;
mod tolerance;
pub mod weld;
