//! The pages agree with the code.

mod rust;
mod snippets;
