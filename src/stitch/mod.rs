//! Stitching: a strip of new faces between two boundary loops.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*. The paper joins two open meshes by a third,
//! intermediate one that hangs on **meridians**, the lines from a vertex of one rim to a vertex of the other. The rims are the
//! arcs of two loops that face each other, as in the paper, or whole loops, so that the strip is a closed band; loops repeat
//! their start, hence N + 1 and M + 1 points for loops of N and M vertices.
//!
//! The work in order, one file each:
//!
//! | file | what it does |
//! |---|---|
//! | [`request`](self) | what a caller asks for, and what comes back |
//! | [`rim`](self) | a loop given by the caller, held to the rules; rims in step with each other |
//! | [`pairing`](self) | which two loops, if the caller leaves that open: the nearest |
//! | [`facing`] | which vertices of the loops face each other: algorithm 2 |
//! | [`extent`](self) | whole loops, or arcs |
//! | [`sense`](self) | do the rims run opposite ways round the gap, as on one oriented surface? |
//! | [`start`](self) | the meridian to begin with: the closest pair, or the best rotation |
//! | [`meridian`] | which vertices the meridians join, matrix H: the paper's rule, the strip of least area, and others |
//! | [`grid`](self) | rows between the rims, matrix P, and the faces between them |
//! | [`strip`](self) | from two rims to a strip: the last three, in order |
//! | [`settle`](self) | the strip among its neighbours: rows faired, faces that cut each other |
//! | [`ruled`](self) | a strip between polylines that belong to no mesh |
//! | [`combine`](self) | one mesh of both pieces and the strip, with maps from old to new |
//! | [`quality`](self) | what the result is worth |
//! | [`join`](self) | all of these, in order |
//! | [`assemble`] | many pieces |

pub mod assemble;
mod combine;
mod extent;
pub mod facing;
mod grid;
mod join;
pub mod meridian;
mod pairing;
mod polyline;
mod quality;
mod request;
mod rim;
mod ruled;
mod sense;
mod settle;
mod start;
mod strip;

pub(crate) use combine::part_alone;
pub(crate) use grid::FaceList;
pub(crate) use rim::FreeEdges;

pub use combine::IndexMap;
pub use extent::Extent;
pub use join::stitch;
pub use meridian::{Meridians, Search};
pub use quality::Quality;
pub use request::{Cells, Fairing, Intersections, Options, Orientation, Request, Rows, Stitch};
pub use ruled::{Ruled, RuledOptions, ruled};
pub use start::Start;
