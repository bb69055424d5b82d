//! Attributes: values that meshes carry besides positions, for the vertices, corners and faces of
//! results.
//!
//! [`Origins`] tells, once for an operation, which elements of the inputs each element of its
//! result comes from. [`carry_values_over`] uses it to transfer any number of [`Channel`]s: colours, normals,
//! texture coordinates, skin weights, materials, numbers.
//!
//! | file | what it does |
//! |---|---|
//! | [`domain`](self) | vertices, corners, faces |
//! | [`table`](self) | rows of sources with weights |
//! | [`origins`](self) | the tables of a result, also of its new vertices and faces |
//! | [`rims`](self) | where new faces adjoin old ones |
//! | [`continuation`](self) | texture coordinates across new faces |
//! | [`joined`](self) | results that keep all faces: stitched, filled, oriented, side by side |
//! | [`repaired`](self) | results of welding, sewing, assembling, trimming, triangulating |
//! | [`grids`](self) | meshes of nets and sheets |
//! | [`splits`](self) | vertices that stay split because of their values |
//! | [`values`](self) | types of values, and the output of a result |
//! | [`channel`](self) | values of one kind, and the rule for mixing them |
//! | [`carry_values_over`] | transfers a channel |

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

pub use apply::carry_values_over;
pub use channel::{Channel, Rule};
pub use domain::{Counts, Domain};
pub use origins::Origins;
pub use splits::KeepSplitVertices;
pub use table::SourceTable;
pub use values::{Output, ValueType};
