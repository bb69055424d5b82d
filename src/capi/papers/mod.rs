//! The papers to the letter: Tables and searches as the papers print them, kept as documented
//! references.

pub mod mask;
pub mod reference;
pub mod winged;
