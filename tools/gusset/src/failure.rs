//! Why the program ends without having done its work.

use std::fmt;

/// Exit statuses; the help, the manual and the guide list them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    Usage = 1,
    File = 2,
    Plugin = 3,
    Refused = 4,
    Cancelled = 5,
    Memory = 6,
    Defects = 7,
}

impl Exit {
    /// Exit statuses and their meanings.
    pub(crate) const MEANINGS: [(u8, &'static str); 8] = [
        (0, "done; without --strict, also if check finds defects"),
        (1, "the command line is invalid"),
        (2, "a file cannot be read or written, or its format does not suit"),
        (3, "the library or plugin cannot be loaded, or it failed internally"),
        (4, "the filter refused its parameters or inputs"),
        (5, "cancelled"),
        (6, "out of memory"),
        (7, "check --strict found defects; an open border is one"),
    ];
}

/// A sentence for people, and its subject for programs.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) exit: Exit,
    pub(crate) message: String,
    /// Where a plugin refused; absent for other failures.
    pub(crate) refusal: Refusal,
}

/// The subject of a refusal.
#[derive(Debug, Default)]
pub(crate) struct Refusal {
    pub(crate) status: Option<i32>,
    pub(crate) parameter: Option<String>,
    pub(crate) input: Option<u32>,
    /// Kind of element and its index.
    pub(crate) element: Option<(&'static str, u64)>,
}

impl Failure {
    pub(crate) fn new(exit: Exit, message: impl Into<String>) -> Self {
        Self { exit, message: message.into(), refusal: Refusal::default() }
    }

    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Self::new(Exit::Usage, message)
    }

    pub(crate) fn file(message: impl Into<String>) -> Self {
        Self::new(Exit::File, message)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

/// Writes a count with its noun: `1 input`, `2 inputs`.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
