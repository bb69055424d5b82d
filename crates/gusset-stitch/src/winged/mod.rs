//! Winged-edge tables: Baumgart's representation as in the stitching paper, and algorithm 1 on
//! them.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*, equations 1 and
//! 2, after B. Baumgart, *Winged edge polyhedron representation* (Stanford, 1972). An edge is a
//! record M, N, b, c, d, e, L, R. It runs from vertex M to vertex N, with face R on its right, face
//! L on its left, and four neighbours, the wings. In Baumgart's convention faces are **clockwise**
//! seen from outside. R runs the edge from M to N; d precedes the edge in R, and b follows it. L
//! runs it from N to M; c precedes it in L, and e follows it. Missing entries are NULL, here
//! [`NONE`](gusset_mesh::NONE).
//!
//! * [`winged_edges`](self): the tables, and their construction from a mesh.
//! * [`free_loops`](self): algorithm 1 on the tables.
//! * [`winged_faces`](self): the polygons of a table.

mod winged_faces;
mod free_loops;
mod winged_edges;

pub use free_loops::{FreeLoops, free_loops};
pub use winged_edges::{EdgeMarks, Winding, WingedEdge, WingedEdges};
pub use winged_faces::{WingedFaces, faces};
