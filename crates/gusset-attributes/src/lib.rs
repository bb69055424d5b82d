//! Attributes: what meshes carry beside positions, for the vertices, corners and faces of results.
//!
//! An operation is asked where the elements of its result come from ([`Origins`]), once, and any
//! number of [`Channel`]s is carried over by that ([`apply()`]): colours, normals, texture
//! coordinates, skin weights, materials, numbers.
//!
//! | file | what it does |
//! |---|---|
//! | [`domain`](self) | vertices, corners, faces |
//! | [`table`](self) | rows of sources with weights |
//! | [`origins`](self) | the tables of a result; those of new vertices and faces |
//! | [`rims`](self) | where new faces hang on old ones |
//! | [`continuation`](self) | texture coordinates across new faces |
//! | [`joined`](self) | results that keep all faces: stitched, filled, oriented, side by side |
//! | [`repaired`](self) | results of welding, sewing, assembling, trimming |
//! | [`grids`](self) | meshes of nets and sheets |
//! | [`splits`](self) | vertices that are kept apart for their values |
//! | [`values`](self) | types of values, and where those of a result go |
//! | [`channel`](self) | values of one kind, and the rule by which they are mixed |
//! | [`apply()`] | a channel carried over |

mod apply;
mod channel;
mod continuation;
mod domain;
mod grids;
mod joined;
mod origins;
mod repaired;
mod rims;
mod splits;
mod table;
mod values;

pub use apply::apply;
pub use channel::{Channel, Rule};
pub use domain::{Counts, Domain};
pub use origins::Origins;
pub use splits::KeepSplits;
pub use table::Table;
pub use values::{Output, ValueType};
