//! Geometry that all crates share, over [`glam`]'s double-precision vectors.
//!
//! - [`aabb`]: axis-aligned boxes.
//! - [`bernstein`]: polynomials in Bernstein form, scalar, vectorial and tensor.
//! - [`linear`]: systems of linear equations.
//! - [`disjoint_sets`], [`bit_set`]: sets of numbered elements.
//! - [`kd_tree`], [`box_tree`]: nearest points of a set, boxes that overlap a box.
//! - [`hull_distance`]: a lower bound of the distance between two convex hulls.
//! - [`node_normals`]: normals of a surface at a grid of nodes.
//! - [`oriented_box`]: boxes aligned with the triangles inside.
//! - [`polygon`]: polygons as triangles.
//! - [`rotation`]: the rotation that best maps points to other points.
//! - [`subdivision`]: all solutions of equations over a box of parameters, with proofs, and
//!   clusters of the undecided boxes.
//! - [`strided`]: elements of a host, at any stride and alignment.
//! - [`triangle`], [`triangle_places`]: area, angles and aspect ratio of one triangle; nearest
//!   places on a set of triangles.
//! - [`scale`]: a power of two as unit of length, so that products of coordinates neither overflow
//!   nor underflow in any unit of the host.

pub mod aabb;
pub mod bernstein;
pub mod bit_set;
pub mod box_tree;
pub mod disjoint_sets;
pub mod hull_distance;
pub mod kd_tree;
pub mod linear;
pub mod node_normals;
pub mod oriented_box;
pub mod polygon;
pub mod rotation;
pub mod scale;
pub mod strided;
pub mod subdivision;
pub mod triangle;
pub mod triangle_places;

pub use aabb::Aabb;
