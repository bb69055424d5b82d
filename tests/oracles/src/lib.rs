//! Brute force that tests compare the library with. It uses nothing of the library.
//!
//! Tests are compiled without optimisation, which is quicker than to optimise them for one run. A
//! loop over all pairs belongs here; functions here are not generic, since those would be compiled
//! with the tests.

pub mod crossings;
pub mod cuts;
pub mod descent;
pub mod distances;
pub mod loops;
