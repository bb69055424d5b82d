//! Trimming: where pieces overlap, one of them is kept, and a narrow gap is left between them,
//! which strips close.
//!
//! Source of the idea: G. Turk and M. Levoy, *Zippered polygon meshes from range images* (1994),
//! who eat overlaps away from the borders and clip one mesh at the other's. Here both are cut along
//! the line where they are equally good, near the middle of the overlap, and no vertex moves:
//!
//! 1. Each vertex has a confidence: its distance from the nearest border of its piece, in edges, so
//!    that the finer of two pieces counts for more; less where it was seen under a flat angle, if
//!    the caller says from where.
//! 2. A vertex lies on another piece if the nearest place there is near, faces the same way, and is
//!    not on a border.
//! 3. Piece by piece, in their order, a vertex is kept if it lies on nothing that is kept before, and
//!    is no less confident than what it lies on after, up to what noise may say; not where it is too
//!    near to the rim of what is kept before: that is the gap.
//! 4. Faces are kept whose vertices are; what is left thinner than two faces goes, and so do small
//!    islands, and faces that would meet in one vertex only. What cannot be kept competes with
//!    nothing, and islands that nothing else shows are given back.
//! 5. Kept faces that cut those of a piece before theirs go, with those round them.
//!
//! | file | what it does |
//! |---|---|
//! | [`trim_request`](self) | options and results |
//! | [`layer`](self) | a piece made ready to be asked for places |
//! | [`covers`](self) | which places of other pieces vertices lie on |
//! | [`region`](self) | the faces that are kept: thin parts, islands, pinches |
//! | [`crossings`](self) | kept faces that cut each other |
//! | [`trim_run`](self) | all of it in order |
//! | [`remains`](self) | what is left as one mesh, and what it was |

mod covers;
mod crossings;
mod layer;
mod region;
mod remains;
mod trim_request;
mod trim_run;

pub use remains::Remains;
pub use trim_request::{Options, Trimmed};
pub use trim_run::trim;

/// The stage of progress.
const STAGE: &str = "trimming the pieces";
