//! Assembly: many open pieces into one mesh.
//!
//! The stages in order:
//!
//! 1. The pieces are concatenated, overlaps trimmed on request (`trimmed`), and coincident borders
//!    sewn ([`sew`](crate::repair::sew)).
//! 2. Each component is oriented consistently ([`orient`](crate::repair::orient)).
//! 3. Loops that sewing left of two borders are joined with themselves (`slit`), and loops of
//!    different components that face each other across a gap are paired (`facing_loops`): whole
//!    loops that look at each other, by the best one-to-one choice (`whole_loops`, `assignment`),
//!    or arcs along which one loop is the other's nearest neighbour, as on scans of adjacent parts.
//! 4. Components are turned over so that they agree across the gaps (`agreement`): each is bound
//!    to those that it faces, turned or not.
//! 5. Each pair is stitched, nearest first ([`stitch`](super)).
//! 6. The remaining holes are filled, on request ([`fill`](crate::fill)).
//! 7. Closed components of the result that are inside out are turned over, each by its own volume
//!    ([`turn_outwards`](crate::repair::orient::turn_outwards())).
//!
//! Loops without a partner stay as they are; the report lists every join and every loop left.

mod agreement;
mod assemble_request;
mod assemble_run;
mod assignment;
mod base;
mod candidates;
mod edges;
mod facing_loops;
mod given_pair;
mod history;
mod left;
mod piece_loops;
mod slit;
mod trimmed;
mod whole_loops;

pub use assemble_request::{Assembly, Joint, LeftLoop, MaxGap, Options, Outcome, Overlaps, Reason, Selector};
pub use assemble_run::assemble;
pub use history::History;
