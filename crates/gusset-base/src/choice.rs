//! Choices: the values of an option in a stable order, each with the text that hosts show.
//!
//! A table stands beside its enum in the core; filters and their pages take order, values and texts
//! from it. Places in a table are stored by hosts: a table grows at its end only.

/// The text of one choice.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// For menus.
    pub label: &'static str,
    /// Its effect, in a sentence.
    pub help: &'static str,
}

impl Choice {
    /// A choice with its texts.
    pub const fn new(label: &'static str, help: &'static str) -> Self {
        Choice { label, help }
    }
}

/// The choices of an option.
#[derive(Debug, Clone, Copy)]
pub struct Choices<T: 'static> {
    /// The value of each choice.
    pub values: &'static [T],
    /// The text of each choice.
    pub texts: &'static [Choice],
}

/// `choices! { for Enum: Variant => "label", "help"; ... }` gives an enum its table of [`Choices`],
/// `Enum::CHOICES`; `choices! { NAME: Type = value => "label", "help"; ... }` defines one of any
/// values.
#[macro_export]
macro_rules! choices {
    (for $type:ident: $($variant:ident => $label:literal, $help:literal;)+) => {
        impl $type {
            $crate::choices! {
                /// The choices of hosts.
                CHOICES: $type = $($type::$variant => $label, $help;)+
            }
        }
    };
    ($(#[$attr:meta])* $name:ident: $type:ty = $($value:expr => $label:literal, $help:literal;)+) => {
        $(#[$attr])*
        pub const $name: $crate::choice::Choices<$type> = $crate::choice::Choices {
            values: &[$($value),+],
            texts: &[$($crate::choice::Choice::new($label, $help)),+],
        };
    };
}
