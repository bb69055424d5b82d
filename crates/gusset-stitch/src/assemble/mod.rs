//! Assembly of many open pieces into one mesh.
//!
//! The stages in order:
//!
//! 1. The pieces are concatenated. Overlaps are trimmed on request (`face_removals`), and
//!    coincident borders are sewn ([`sew`](crate::repair::sew)). Strips then fill the gaps between
//!    borders that share vertices but not edges (`touching_borders`).
//! 2. Each component is oriented consistently ([`orient`](crate::repair::orient)).
//! 3. Slits that sewing left between two borders are joined with themselves (`slit`). A slit of any
//!    width is joined if its sides belonged to whole loops that faced each other before sewing
//!    (`unsewn_pairs`).
//! 4. Loops of different components that face each other across a gap are paired (`facing_loops`).
//!    Whole loops are paired one to one (`whole_loops`, `assignment`). Arcs are paired where one
//!    loop is the other's nearest neighbour, as on scans of adjacent parts. Two loops that are
//!    left, with nobody else near, are paired across wider gaps (`lone_pairs`).
//! 5. Components are turned over so that they agree across the gaps (`agreement`).
//! 6. Each pair is stitched, nearest first ([`stitch`](super)).
//! 7. The remaining holes are filled on request ([`fill`](crate::fill)).
//! 8. Closed components of the result face outwards, and walls of cavities into the cavities
//!    ([`turn_outwards`](crate::repair::orient::turn_outwards())).
//!
//! Loops without a partner stay open. The report lists every joint and every loop left
//! (`report_details`). After trimming, the stages run again until nothing intersects: each round
//! removes faces (`face_removals`), but no part that other parts do not cover (`covered_faces`).

mod agreement;
mod assemble_request;
mod assemble_run;
mod assignment;
mod combined_pieces;
mod covered_faces;
mod candidates;
mod loop_edges;
mod facing_loops;
mod given_pair;
mod origin_history;
mod left_loops;
mod lone_pairs;
mod piece_loops;
mod report_details;
mod side_facing;
mod slit;
mod touching_borders;
mod unsewn_pairs;
mod face_removals;
mod whole_loops;

pub use assemble_request::{Assembly, Extent, Joint, LeftLoop, MaxGap, Options, Outcome, Overlaps, Reason, Selector};
pub use assemble_run::assemble;
pub use origin_history::History;
