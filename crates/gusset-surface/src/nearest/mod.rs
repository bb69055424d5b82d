//! Task a) of the paper: nearest points, local minima of the distance, and the cells within a
//! radius.
//!
//! The paper's search by diameters is an incidence test, which for a nearest point needs an upper
//! bound (the study's erratum E3); with one it is branch and bound (Land and Doig 1960; best first
//! over a hierarchy of boxes: Hjaltason and Samet 1999, "Distance browsing in spatial databases").
//! Proofs are relative to the surface as declared, the patches through the nodes.
//!
//! Layers, each of which knows those above it only:
//! * geometry, without state: `foot` (Newton's descent on a patch), `bounds` (lower bounds of the
//!   distance of a patch), `part` (parts of a patch), `block` (blocks of the index), `corners` and
//!   `leaf` (the cells of a block);
//! * `incumbent`: the best answer so far and the upper bound;
//! * searches, with the tasks of `super::frontier`: `nearest_search` (of a surface), `patch_search` (of one
//!   patch), `patch_minima` (all minima of one patch), with `descent_direction` (whether a place is none);
//! * questions: `closest`, `nearest_batch`, `minima`, `ball_region`, with `query` for what may be asked.

mod ball_region;
mod block;
mod bounds;
mod closest;
mod corners;
mod descent_direction;
mod foot;
mod incumbent;
mod leaf;
mod minima;
mod nearest_batch;
mod nearest_search;
mod part;
mod patch_minima;
mod patch_search;
mod query;

pub use ball_region::Region;
pub use closest::Closest;
pub use minima::Minima;
