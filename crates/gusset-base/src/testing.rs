//! Helpers for unit tests.

/// Returns the number of cases that a randomised test tries. An optimised build (`make exhaustive`)
/// tries all `full` cases. A plain build is ten times as slow and tries a tenth.
pub const fn case_count(full: u32) -> u32 {
    if cfg!(debug_assertions) { full.div_ceil(10) } else { full }
}
