//! Task a) of the paper: nearest points, local minima of the distance, and the cells within a
//! radius.
//!
//! The paper's search by diameters is an incidence test. For nearest points it needs an upper bound
//! (the study's erratum E3), which makes it branch and bound (Land and Doig 1960). The best-first
//! order over a hierarchy of boxes follows Hjaltason and Samet (1999, "Distance browsing in spatial
//! databases"). Proofs are relative to the given surface: the patches through the nodes.
//!
//! Layers, each of which uses only those above it:
//! - geometry without state: `foot_point` (Newton's method on a patch), `patch_bounds` (lower
//!   bounds of the distance of a patch), `patch_part` (parts of a patch), `bounded_block` (blocks
//!   of the index), `block_corners` and `candidate_block` (the cells of a block);
//! - `incumbent`: the best answer so far and the upper bound;
//! - searches with the tasks of `super::frontier`: `nearest_search` (of a surface), `patch_search`
//!   (of a patch), `patch_minima` (all minima of a patch), with `descent_direction` (which rejects
//!   places);
//! - queries: `closest`, `nearest_batch`, `minima`, `ball_region`, with `query_checks` for the
//!   checks of arguments.

mod ball_region;
mod bounded_block;
mod patch_bounds;
mod closest;
mod block_corners;
mod descent_direction;
mod foot_point;
mod incumbent;
mod candidate_block;
mod minima;
mod nearest_batch;
mod nearest_search;
mod patch_part;
mod patch_minima;
mod patch_search;
mod query_checks;

pub use ball_region::CellsInBall;
pub use closest::Closest;
pub use minima::Minima;
