//! Task a) of the paper: the nearest point.
//!
//! The paper's search by diameters is an incidence test: for the nearest point it must know an upper bound (the study's erratum E3), and
//! that is branch and bound. What is proved here is relative to the surface as declared, the patches through the nodes.

mod cell;
mod search;

pub(crate) use cell::Scratch;
pub(crate) use search::search;
