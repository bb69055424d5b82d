//! Alignment: pieces that overlap, each in a place of its own, moved rigidly to where they fit.
//!
//! Sources: P. Besl and N. McKay, *A method for registration of 3-D shapes* (1992), and Y. Chen and
//! G. Medioni, *Object modelling by registration of multiple range images* (1992): nearest points
//! as pairs, and planes at them; G. Turk and M. Levoy, *Zippered polygon meshes from range images*
//! (1994): what lies beyond a border of the other piece is no pair; S. Rusinkiewicz, *A symmetric
//! objective function for ICP* (2019): the plane of both normals; P. Neugebauer, *Reconstruction of
//! real-world objects via simultaneous registration* (1997): all pieces in one system, so that no
//! error adds up round a ring of them.
//!
//! In each round every piece asks its neighbours for the points nearest to some of its own. With
//! small motions of piece i, a turn w_i about its centre g_i and a shift u_i, the distance of a
//! pair x_i, x_j along their normal n changes to
//!
//! (x_i - x_j) . n + (u_i + w_i x (x_i - g_i)) . n - (u_j + w_j x (x_j - g_j)) . n,
//!
//! and the motions that make the weighted sum of squares least are applied, until nothing moves.
//! The first piece stays. What is left in the end says whether a piece can be trusted to lie right:
//! whether it overlaps others, fits there, and whether the overlaps hold it in all six directions.
//!
//! | file | what it does |
//! |---|---|
//! | [`align_request`](self) | options, results, reasons |
//! | [`pose`](self) | a rotation and a translation |
//! | [`scan`](self) | a piece made ready: points, smoothed normals, borders, samples |
//! | [`sampled_rim`](self) | its rims at equal steps, with frames and signatures |
//! | [`member`](self) | a piece among others, and what it looks for |
//! | [`sample_pairs`](self) | which samples lie on which other piece, and their equations |
//! | [`along`](self) | the same of rims |
//! | [`scene`](self) | the pieces, and who is near whom |
//! | [`motion_system`](self) | the equations of all motions, solved by conjugate gradients |
//! | [`freedom`](self) | the directions in which overlaps do not hold a piece |
//! | [`relax`](self) | the rounds |
//! | [`axes`](self) | a start by principal axes |
//! | [`rim_features`](self) | a start by features of rims |
//! | [`judge`](self) | what can be trusted |
//! | [`align_run`](self) | all of it in order |
//! | [`moved`](self) | the pieces where they lie in the end, in one mesh and apart |

mod align_request;
mod align_run;
mod along;
mod axes;
mod freedom;
mod judge;
mod member;
mod motion_system;
mod moved;
mod pose;
mod relax;
mod rim_features;
mod sample_pairs;
mod sampled_rim;
mod scan;
mod scene;

pub use align_request::{Aligned, Alignment, Options, Overlap, Reason, Start};
pub use align_run::align;
pub(crate) use align_run::common_unit_of;
pub use moved::views_of;
pub use pose::Pose;
pub(crate) use scan::Scan;
