//! Trimming of overlaps: one piece is kept, and a narrow gap is left, which strips close.
//!
//! The idea follows G. Turk and M. Levoy, *Zippered polygon meshes from range images* (1994), who
//! erode overlaps from the borders and clip one mesh at the other. Here both pieces are cut along
//! the line of equal confidence, near the middle of the overlap, and vertices do not move:
//!
//! 1. Each vertex has a confidence: its distance from the nearest border of its piece, in mean
//!    edges, so that the finer of two pieces has more. If the caller gives viewpoints, vertices
//!    that were seen at a grazing angle have less.
//! 2. A vertex lies on another piece if the nearest place there is near, faces the same side, and
//!    is not on a border.
//! 3. The pieces are visited in order. A vertex is kept if it does not lie on earlier kept faces,
//!    and is at least as confident as its places on later pieces, up to noise. A vertex too near to
//!    the rim of earlier kept faces is not kept: that makes the gap.
//! 4. Faces are kept if their vertices are. Parts thinner than two faces, small islands, and faces
//!    that meet only in a vertex are removed. Removed faces no longer compete with others, and
//!    islands that no other piece shows are restored.
//! 5. Kept faces that intersect faces of an earlier piece are removed, with the faces around them.
//!
//! | file | task |
//! |---|---|
//! | [`trim_request`](self) | options and results |
//! | [`trim_piece`](self) | a prepared piece |
//! | [`vertex_covers`](self) | the places on other pieces that vertices lie on |
//! | [`kept_faces`](self) | the faces that are kept: thin parts, islands, pinches |
//! | [`crossing_faces`](self) | kept faces that intersect each other |
//! | [`trim_run`](self) | all steps in order |
//! | [`kept_meshes`](self) | the kept faces as one mesh, and their origins |

mod vertex_covers;
mod crossing_faces;
mod trim_piece;
mod kept_faces;
mod kept_meshes;
mod trim_request;
mod trim_run;

pub(crate) use trim_request::SameSurfaceLimits;

pub use kept_meshes::TrimmedPieces;
pub use trim_request::{KeptFacesOfPieces, Options};
pub use trim_run::trim;

/// The progress message.
const STAGE: &str = "trimming the pieces";
