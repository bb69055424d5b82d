//! The topology of a net: its contracted links and its seams (Deryagin, "Non-spatial operations";
//! the characteristic matrix, Figs. 4 and 5).
//!
//! - [`Sides`]: closures that need no matrix. [`LinkMatrix`]: the paper's characteristic matrix.
//!   [`Seam`]: gluings that neither can express.
//! - [`Topology`]: links and seams in a normal form.
//! - [`NodeClasses`]: the classes of glued nodes. [`ReducedCell`]: the polygon to which a cell reduces.
//!   [`GluingType`]: the 18 local gluings; [`find_gluing_occurrences()`] lists a net's. [`Gluing`]: explicit
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
pub use classes::{NodeClasses, NodeGroups};
pub use gluing::{CellDiagonal, Gluing};
pub use link_matrix::LinkMatrix;
pub(crate) use local_gluing::links_of_star;
pub use local_gluing::{GluingHistogram, GluingType, classify_cell, classify_node, gluing_histogram};
pub use occurrences::{GluingOccurrence, GluingSignature, find_gluing_occurrences};
pub use seam::{Seam, SeamRun};
pub use sides::Sides;
pub use structure::{ContractedLinks, Topology};
