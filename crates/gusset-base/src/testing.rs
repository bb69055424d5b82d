//! What unit tests share.

/// How many of `full` cases a test tries that goes through many: all in an optimised build (`make
/// exhaustive`), a tenth in a plain one, which is ten times as slow.
pub const fn cases(full: u32) -> u32 {
    if cfg!(debug_assertions) { full.div_ceil(10) } else { full }
}
