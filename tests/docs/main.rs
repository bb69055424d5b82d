//! The pages hold what the code does.

mod snippets;
