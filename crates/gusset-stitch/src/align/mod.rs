//! Alignment: rigid motion of overlapping pieces to where they fit.
//!
//! Sources:
//! * P. Besl and N. McKay, *A method for registration of 3-D shapes* (1992), and Y. Chen and G.
//!   Medioni, *Object modelling by registration of multiple range images* (1992), for nearest
//!   points as pairs, and their tangent planes.
//! * G. Turk and M. Levoy, *Zippered polygon meshes from range images* (1994), for ignoring pairs
//!   at a border of the other piece.
//! * S. Rusinkiewicz, *A symmetric objective function for ICP* (2019), for the mean of both
//!   normals.
//! * P. Neugebauer, *Reconstruction of real-world objects via simultaneous registration* (1997),
//!   for one system of all pieces, so that errors do not accumulate around a ring.
//!
//! * R. Rusu, N. Blodow and M. Beetz, *Fast point feature histograms (FPFH) for 3D registration*
//!   (2009), and Z. Chen, K. Sun, F. Yang and W. Tao, *SC2-PCR: a second order spatial compatibility
//!   for efficient and robust point cloud registration* (2022), for poses without a start.
//!
//! Each round finds the points of every piece's neighbours that are nearest to its samples. Let
//! piece i move by a small rotation w_i about its centre g_i and a translation u_i. The distance of
//! a pair x_i, x_j along its normal n then changes to
//!
//! (x_i - x_j) . n + (u_i + w_i x (x_i - g_i)) . n - (u_j + w_j x (x_j - g_j)) . n.
//!
//! The motions that minimise the weighted sum of squares are applied, until nothing moves. The
//! first piece is fixed. At the end each piece is assessed: whether it overlaps others, fits there,
//! and is held in all six directions.
//!
//! | file | task |
//! |---|---|
//! | [`align_request`](self) | options, results, reasons |
//! | [`pose`](self) | a rotation and a translation |
//! | [`centred_piece`](self) | a prepared piece: points, smoothed normals, borders, samples |
//! | [`sampled_rims`](self) | a piece's rims at equal steps, with frames and signatures |
//! | [`sampled_piece`](self) | a piece in an alignment, with its samples |
//! | [`sample_pairs`](self) | pairs of samples on other pieces, and their equations |
//! | [`rim_sample_pairs`](self) | pairs of rim samples |
//! | [`alignment_scene`](self) | the pieces, and the pairs that are near |
//! | [`motion_system`](self) | the equations of all motions, solved by conjugate gradients |
//! | [`hold_stiffness`](self) | the stiffness with which overlaps hold a piece |
//! | [`relax_poses`](self) | the rounds |
//! | [`principal_axes`](self) | an initial alignment by principal axes |
//! | [`rim_features`](self) | an initial alignment by features of rims |
//! | [`surface_samples`](self) | a piece's surface as points at equal spacing |
//! | [`surface_features`](self) | histograms of angles around samples |
//! | [`surface_matches`](self) | samples of two pieces with similar features |
//! | [`consistent_matches`](self) | sets of matches that one motion explains |
//! | [`surface_pose`](self) | how well one surface fits another in a pose |
//! | [`surface_pair`](self) | the pose of one piece on another, and its certificate |
//! | [`free_start`](self) | an initial alignment by features of surfaces |
//! | [`assess`](self) | the assessment of pairs and pieces |
//! | [`align_run`](self) | all steps in order |
//! | [`moved_mesh`](self) | the aligned pieces, in one mesh and as views |

mod align_request;
mod align_run;
mod consistent_matches;
mod free_start;
mod surface_features;
mod surface_matches;
mod surface_pair;
mod surface_pose;
mod surface_samples;
mod rim_sample_pairs;
mod principal_axes;
mod hold_stiffness;
mod assess;
mod sampled_piece;
mod motion_system;
mod moved_mesh;
mod pose;
mod relax_poses;
mod rim_features;
mod sample_pairs;
mod sampled_rims;
mod centred_piece;
mod alignment_scene;

pub use align_request::{Aligned, Alignment, Options, Overlap, Reason, Start};
pub use align_run::align;
pub(crate) use align_run::common_length_unit;
pub(crate) use centred_piece::CentredPiece;
pub use moved_mesh::views_of_moved_pieces;
pub use pose::Pose;
