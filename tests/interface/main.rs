//! The C interface as built.

mod c_abi;
mod circles;
mod comments;
mod features;
mod floors;
mod lenders;
mod messages;
mod modules;
#[cfg(target_os = "linux")]
mod options;
