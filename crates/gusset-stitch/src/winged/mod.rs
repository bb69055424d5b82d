//! Winged-edge tables: Baumgart's representation, as the stitching paper has it, and its algorithm
//! 1 on them.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*, equations 1 and
//! 2, after B. Baumgart, *Winged edge polyhedron representation* (Stanford, 1972). An edge is a
//! record M, N, b, c, d, e, L, R: it runs from vertex M to vertex N, has face R on its right and L
//! on its left, and four neighbours, the wings. In Baumgart's convention faces are **clockwise**
//! seen from outside. R is the face that runs M to N: d comes before the edge in it, and b after. L
//! runs N to M: c comes before and e after. What is missing is NULL, here
//! [`NONE`](gusset_mesh::NONE).
//!
//! * [`tables`](self): the tables, and how they are filled from a mesh.
//! * [`free_loops`](self): algorithm 1 on the tables.
//! * [`faces`](self): the polygons of a table, the way back.

mod faces;
mod free_loops;
mod tables;

pub use faces::{WingedFaces, faces};
pub use free_loops::{FreeLoops, free_loops};
pub use tables::{EdgeMarks, Winding, WingedEdge, WingedEdges};
