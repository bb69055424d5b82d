//! Free boundary loops of an open polygon mesh.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*, algorithm 1. The
//! paper walks from free edge to free edge (an edge with a face on exactly one side) until it
//! returns to the start. The printed algorithm finds one loop, of undefined direction, and may not
//! terminate. Here:
//!
//! * **Direction.** A loop runs in the direction of its faces' half-edges. If faces are
//!   counter-clockwise from outside, the surface lies on the **left** of the loop and the hole on
//!   the right, seen from outside.
//! * **Fan by fan.** From the end of a free edge the walk rotates through the fan of faces around
//!   the vertex to the next free edge. Every free edge has exactly one successor and one
//!   predecessor. So the walk returns to its start, and visits each free edge once.
//! * **Simple loops.** A walk is cut where it passes a vertex again (a bow-tie, or two holes that
//!   touch). Every loop therefore passes each of its vertices once. Loops that were cut from one
//!   walk have equal walk numbers.
//! * **Edges with three or more faces** end a fan. Each of their faces has its own border there.
//!   The loop runs along it ([`NonManifold::Cut`]) or ends as an open chain
//!   ([`NonManifold::Stop`]). Both cases are flagged.
//! * **Inconsistent orientation** does not stop a walk. The loop takes the direction of most of its
//!   faces, and flags the edges that it runs against their faces.
//!
//! Files: `options` and `boundary_loops` have the types and the entry point. `border_walker` walks
//! from free edge to free edge, and `simple_loops` cuts the walks. `regular_walks` finds regular
//! boundaries without pairing all edges.

mod boundary_loops;
mod regular_walks;
mod options;
mod simple_loops;
mod border_walker;

pub(crate) use simple_loops::split_into_simple_loops;

pub use boundary_loops::{Boundary, EdgeFlags, Loop, LoopFlags, boundary_loops};
pub use options::{NonManifold, Options, Survey};
