//! Repair: pieces that touch made one surface, and faces made to agree.
//!
//! * [`weld`]: makes one vertex of vertices that lie together; on borders, by sewing edge to edge.
//! * [`orient`]: turns faces over until neighbours agree, and closed surfaces outwards.
//! * [`cluster`](self): which vertices lie together. [`sew`](self): which of them can be one
//!   without harm. [`corners`](self): the faces' corners at each vertex. [`tolerance`](self): how
//!   far apart copies of one vertex can be.

mod cluster;
mod corners;
pub mod orient;
mod sew;
mod tolerance;
pub mod weld;
