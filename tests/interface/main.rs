//! The C interface as built.

mod c_abi;
mod features;
mod layers;
mod lenders;
mod messages;
mod modules;
