//! 3MF

mod mf_model;
mod mf_package;
mod mf_properties;
mod read_3mf;
mod read_mf_model;
mod write_3mf;

pub(crate) use read_3mf::read_3mf;
pub(crate) use write_3mf::write_3mf;

#[cfg(test)]
mod three_mf_tests;
