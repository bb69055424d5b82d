//! Seams of meshes in pieces as files have them: coordinates rounded to seven digits, T-junctions,
//! points that rims share.

mod pairing;
mod sew;
mod slits;
mod touching;
mod wide_tolerance;
mod weld_tolerance;
