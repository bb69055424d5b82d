//! Polygon meshes that come in pieces: boundary loops, stitching, filling, repair.
//!
//! The algorithms follow S. Nesterenko, *The algorithm for polygonal networks of cross-linking*,
//! and the articles that each module names.
//!
//! | module | what it does |
//! |---|---|
//! | [`mesh`] | the view of the host's arrays, the mesh that results come in, half-edges |
//! | [`boundary`] | finds free boundary loops |
//! | [`winged`] | builds winged-edge tables, and finds loops on them |
//! | [`check`] | reports everything wrong or unusual in a mesh |
//! | [`repair`] | merges coincident vertices, sews borders, makes orientation consistent |
//! | [`align`] | finds the poses of overlapping pieces |
//! | [`trim`] | removes what overlapping pieces cover twice |
//! | [`stitch`] | joins two loops by a strip of new faces |
//! | [`fill`] | closes holes by new faces |
//! | [`assemble`] | joins many pieces into one mesh |
//! | [`develop`] | lays surfaces out in the plane |

pub mod align;
pub mod assemble;
mod blend;
pub mod boundary;
pub mod check;
pub mod develop;
pub mod fair;
pub mod fill;
mod intersect;
pub mod mesh;
mod remesh;
pub mod repair;
pub mod stitch;
pub mod trim;
pub mod winged;
