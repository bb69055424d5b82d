//! Small geometry shared by all modules, over [`glam`]'s double-precision vectors.
//!
//! * [`kd_tree`]: nearest point of a set.
//! * [`subdivision`]: all solutions of equations over a box of parameters, by proofs; clusters of what is left.
//! * [`triangle`]: area, angles and aspect ratio of one triangle.
//! * [`scale`]: a power of two as unit of length, so that products of coordinates neither overflow nor vanish whatever
//!   the host's units are.

pub(crate) mod kd_tree;
pub(crate) mod scale;
pub(crate) mod subdivision;
pub(crate) mod triangle;
