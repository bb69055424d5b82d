//! Meridians: which vertex of one rim is joined to which of the other.
//!
//! A set of meridians is a list of pairs (i, j), i = 0..=N on rim A and j = 0..=M on rim B, that starts with (0, 0), ends with
//! (N, M) (the start again, as both rims are closed), and from one to the next advances by one vertex on A, on B, or on
//! both. It is a path through the lattice of all pairs, and it is the paper's matrix H read row by row.
//!
//! * [`index_rule`](mod@index_rule): the paper's rule, by index alone.
//! * `min_area`: the path whose triangles have the least total area.

pub mod index_rule;
pub(crate) mod min_area;

/// One meridian: the places on rim A and on rim B.
pub type Pair = [u32; 2];
