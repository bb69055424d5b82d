//! The pages hold what the code does.

mod rust;
mod snippets;
