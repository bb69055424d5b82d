//! Repair: pieces that touch made one surface, and faces made to agree.
//!
//! * [`weld`]: makes one vertex of vertices that lie together; on borders, by sewing edge to edge.
//! * [`sew`]: welds borders that do not match vertex by vertex either; edges are split for it.
//! * [`orient`]: turns faces over until neighbours agree, and closed surfaces outwards.
//! * [`corner_origins`]: which corners of the old mesh those of the new one are.
//! * [`cluster`](self): which vertices lie together. [`seams`](self): which of them can be one
//!   without harm. [`corners`](self): the faces' corners at each vertex. [`tolerance`](self): how
//!   far apart copies of one vertex can be. [`junctions`](self): where free edges are split.
//!   [`split_mesh`](self), [`split_face`](self): what becomes of their faces.

mod cluster;
pub mod corner_origins;
mod corners;
mod junctions;
pub mod orient;
mod seams;
pub mod sew;
mod split_face;
mod split_mesh;
mod tolerance;
pub mod weld;
