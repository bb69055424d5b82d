//! Polygon meshes that come in pieces: boundary loops, stitching, filling, repair.
//!
//! The crate follows S. Nesterenko, *The algorithm for polygonal networks of cross-linking*: find
//! the free boundary loops of two open meshes, and join them by a strip of new faces. The errata of
//! the paper are in `docs/errata.md`. Other modules follow the articles that their pages name.
//!
//! Every operation takes a [`MeshView`](gusset_mesh::MeshView) of the host's arrays and returns a
//! [`Mesh`](gusset_mesh::Mesh) with a report. Old vertices keep their bits. Positions are in single
//! or double precision; computations are in double precision.
//!
//! | module | task | source |
//! |---|---|---|
//! | [`boundary`] | finds free boundary loops | Nesterenko, algorithm 1 |
//! | [`winged`] | builds winged-edge tables, and finds loops on them | Baumgart 1972; Nesterenko |
//! | [`check`] | reports everything wrong or unusual in a mesh | |
//! | [`repair`] | merges coincident vertices, sews borders, makes orientation consistent | |
//! | [`align`] | finds the poses of overlapping pieces | Besl and McKay 1992; Neugebauer 1997 |
//! | [`arrange`] | unites solids: splits triangles where they intersect, exactly | Zhou and others 2016 |
//! | [`trim`] | removes what overlapping pieces cover twice | Turk and Levoy 1994 |
//! | [`stitch`] | joins two loops by a strip of new faces | Nesterenko, algorithm 2 |
//! | [`fill`] | closes holes by new faces | Barequet and Sharir 1995; Liepa 2003 |
//! | [`assemble`] | joins many pieces into one mesh | |
//! | [`certify`] | states facts about a result that others can check | |
//! | [`develop`] | lays surfaces out in the plane | Rabinovich and others 2017 |
//! | `blend` | replaces coarse faces of a strip or patch by fine ones | Botsch and Kobbelt 2004 |
//! | [`fair`] | moves new vertices to where a thin plate bends least | Liepa 2003 |
//! | `remesh` | splits, flips and refines the triangles of a patch | |
//! | `intersect` | finds intersecting triangles, exactly | Shewchuk 1997 |

pub mod align;
pub mod arrange;
pub mod assemble;
mod blend;
pub mod boundary;
pub mod certify;
pub mod check;
pub mod develop;
pub mod fair;
pub mod fill;
mod intersect;
mod remesh;
pub mod repair;
pub mod solid;
pub mod stitch;
pub mod trim;
pub mod winged;
