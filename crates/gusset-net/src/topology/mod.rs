//! The topology of a net: its contracted links and its seams (Deryagin, "Non-spatial operations";
//! the characteristic matrix, Figs. 4 and 5).
//!
//! - [`Sides`]: closures that need no matrix. [`LinkMatrix`]: the paper's characteristic matrix.
//!   [`Seam`]: gluings that neither can express.
//! - [`Topology`]: links and seams in a normal form.
//! - [`Classes`]: the classes of glued nodes. [`ReducedCell`]: the polygon to which a cell reduces.
//!   [`GluingType`]: the 18 local gluings; [`occurrences()`] lists a net's. [`Gluing`]: explicit
//!   editing.
//!
//! Invariant: links and seams name pairs of nodes, and the partition into classes is their
//! equivalence closure. No cell has both pairs of opposite corners in one class each.

mod canonical_seams;
mod cell;
mod classes;
mod gluing;
mod link_matrix;
mod local_gluing;
mod normal_form;
mod occurrences;
mod seam;
mod sides;
mod structure;

pub use cell::ReducedCell;
pub use classes::{Classes, Groups};
pub use gluing::{CellDiagonal, Gluing};
pub use link_matrix::LinkMatrix;
pub(crate) use local_gluing::star_links;
pub use local_gluing::{GluingHistogram, GluingType, classify_cell, classify_node, histogram};
pub use occurrences::{GluingOccurrence, GluingSignature, occurrences};
pub use seam::{Seam, SeamRun};
pub use sides::Sides;
pub use structure::{ContractedLinks, Topology};
