//! Free boundary loops of an open polygon mesh.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*, algorithm 1. The
//! paper walks from free edge to free edge (an edge with a face on exactly one side) until it
//! returns to the start. As printed it has one loop, of undefined direction, and need not end;
//! here:
//!
//! * **Direction.** A loop runs as the faces along it run their own half-edges. With faces
//!   counter-clockwise from outside, the surface is on the **left** and the hole on the right of
//!   someone who walks along the loop on the outside.
//! * **Fan by fan.** From the end of a free edge the walk turns through the faces round that
//!   vertex, from each to its neighbour across the shared edge, until it meets the next free edge.
//!   Every free edge has exactly one successor and one predecessor, so the walk cannot run into a
//!   cycle that it did not start from, and it visits each free edge once.
//! * **Simple loops.** Where a walk passes a vertex again (a bow-tie, or two holes that touch) it
//!   is cut there, so that every loop passes each of its vertices once. Loops that were cut from
//!   one walk carry the same walk number.
//! * **Edges with three or more faces** end a fan. Each of their faces then has a border of its own
//!   there, and the loop runs along it ([`NonManifold::Cut`]) or ends as an open chain
//!   ([`NonManifold::Stop`]). Both are flagged.
//! * **Faces that disagree in orientation** do not stop a walk; the loop takes the direction of
//!   most of its faces and marks the edges where it runs against theirs.
//!
//! Files: `options` and `boundary_loops` have the types and the entry point, `walk` goes from free edge to
//! free edge, `simple_loops` makes simple loops, and `fast` finds ordinary boundaries without looking at
//! every edge.

mod boundary_loops;
mod fast;
mod options;
mod simple_loops;
mod walk;

pub(crate) use simple_loops::split_simple;

pub use boundary_loops::{Boundary, EdgeFlags, Loop, LoopFlags, boundary_loops};
pub use options::{NonManifold, Options, Survey};
