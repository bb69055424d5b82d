//! Assembly: many open pieces into one mesh.
//!
//! The work in order:
//!
//! 1. The pieces are put side by side, and borders that lie on one another are sewn ([`weld`](crate::repair::weld)).
//! 2. The orientation of each component is made consistent ([`orient`](crate::repair::orient)).
//! 3. Loops of different components that face each other across a gap are found (`facing_loops`): whole loops, or the runs of
//!    vertices along which one loop is another one's nearest neighbour, as on scans of adjacent parts.
//! 4. Components are turned over so that they agree across the gaps (`agree`).
//! 5. Each pair is stitched, nearest first ([`stitch`](super)).
//! 6. Holes that are left are filled, if wanted ([`fill`](crate::fill)).
//!
//! What faces nothing is left alone, and everything done or left is in the account.

mod agree;
mod facing_loops;
mod request;
mod run;

pub use request::{Assembly, Joint, LeftLoop, MaxGap, Options, Outcome, Reason, Selector};
pub use run::assemble;
