//! Macros that write trait implementations. Types, constants and functions are written out, because
//! cbindgen does not expand macros.

/// Declares the structs of a file that begin with `size_t struct_size`, each with the size of its
/// first version. A struct with a field `reserved` that must be 0 says so. The list of the binary
/// interface checks the whole layouts.
macro_rules! versioned {
    ($($name:ident: $size:literal $($reserved:ident)?),* $(,)?) => {$(
        // SAFETY: repr(C), and all fields are plain numbers and raw pointers, for which zeros are
        // valid. The size comes first, as asserted.
        unsafe impl $crate::capi::input::VersionedStruct for $name {
            const MIN_SIZE: usize = if size_of::<usize>() == 8 { $size } else { size_of::<$name>() };
            $(fn reserved(&self) -> u32 { self.$reserved })?
        }
        const _: () = assert!(std::mem::offset_of!($name, struct_size) == 0);
        const _: () = assert!(size_of::<usize>() != 8 || (size_of::<$name>() >= $size && size_of::<$name>() % 8 == 0));
    )*};
}

/// Declares the sizes of structs that are used in arrays and can therefore never grow.
macro_rules! fixed {
    ($($name:ident: $size:literal),* $(,)?) => {
        const _: () = assert!(size_of::<usize>() != 8 || ($(size_of::<$name>() == $size)&&*));
    };
}

/// Maps the constants of C to the variants of an enum of the core, with the name of the field or
/// parameter that takes them.
macro_rules! c_enum {
    ($($name:ident: $enum:ty { $($constant:ident => $variant:ident),* $(,)? })*) => {$(
        impl $crate::capi::input::Choice for $enum {
            const NAME: &'static str = stringify!($name);
            const CONSTANTS: &'static [&'static str] = &[$(stringify!($constant)),*];

            fn from_constant(value: u32) -> Option<Self> {
                match value {
                    $($constant => Some(Self::$variant),)*
                    _ => None,
                }
            }

            fn number(self) -> u32 {
                match self {
                    $(Self::$variant => $constant,)*
                }
            }
        }
    )*};
}

/// `laid_out_like! { A: B { x, y, ... } }` asserts that A and B have exactly these fields at equal
/// offsets.
macro_rules! laid_out_like {
    ($name:ident: $other:ty { $($field:ident),* $(,)? }) => {
        const _: () = assert!(
            size_of::<$name>() == size_of::<$other>()
                $(&& std::mem::offset_of!($name, $field) == std::mem::offset_of!($other, $field))*
        );
    };
}

/// Returns the names of constants of C.
macro_rules! constants {
    ($($constant:ident),* $(,)?) => {{
        // The constants exist.
        const _: &[u32] = &[$($constant),*];
        [$(stringify!($constant)),*]
    }};
}

pub(crate) use {c_enum, constants, fixed, laid_out_like, versioned};
