//! Choices: the values of an option in a stable order, each with the text that hosts show.
//!
//! A table is declared beside its enum in the core. Filters and their documentation take order,
//! values and texts from it. Hosts store positions in a table, so new entries go at the end.

/// The text of one choice.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// The label, for menus.
    pub label: &'static str,
    /// The effect, as a sentence.
    pub help: &'static str,
}

impl Choice {
    /// Creates a choice from its texts.
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
                /// The choices that hosts offer.
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
