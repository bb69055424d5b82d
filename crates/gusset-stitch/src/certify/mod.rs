//! Certificates: facts about the result of an operation that others can check without the library.
//!
//! A certificate compares a result with the meshes that it was made from. Every fact has a definition
//! that needs only coordinates and the faces' corners, so a short independent program can confirm or
//! refute it. All facts are exact, except the length of the largest move, which is rounded.
//!
//! * [`certificate`](self): facts and entry point.
//! * [`face_matching`](self): the input faces that the result keeps, turns over or lacks.
//! * [`farthest_vertex`](self): the input vertex that is farthest from the result's vertices.
//! * [`own_vertices`](self): components whose nesting is certain.
//! * [`numbered_points`](self): equal positions of several meshes have one number.

mod certificate;
mod face_matching;
mod farthest_vertex;
mod numbered_points;
mod own_vertices;

pub use certificate::{Certificate, certify};
pub use farthest_vertex::FarthestVertex;
