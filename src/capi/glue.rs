//! Declarative glue: macros that write impls. Types, constants and functions stay written out, as
//! cbindgen sees none that a macro makes.

/// The structs of a file that begin with `size_t struct_size`, each with the size of its first
/// version and `reserved` if it is read and has a field of that name, which must be 0 then. Layouts
/// as a whole are held by the list of the binary interface.
macro_rules! versioned {
    ($($name:ident: $size:literal $($reserved:ident)?),* $(,)?) => {$(
        // SAFETY: repr(C), all fields plain numbers and raw pointers, for which zeros are values;
        // the size comes first, as asserted.
        unsafe impl $crate::capi::input::Versioned for $name {
            const MIN_SIZE: usize = if size_of::<usize>() == 8 { $size } else { size_of::<$name>() };
            $(fn reserved(&self) -> u32 { self.$reserved })?
        }
        const _: () = assert!(std::mem::offset_of!($name, struct_size) == 0);
        const _: () = assert!(size_of::<usize>() != 8 || (size_of::<$name>() >= $size && size_of::<$name>() % 8 == 0));
    )*};
}

/// The sizes of structs that lie in arrays, and can therefore never grow.
macro_rules! fixed {
    ($($name:ident: $size:literal),* $(,)?) => {
        const _: () = assert!(size_of::<usize>() != 8 || ($(size_of::<$name>() == $size)&&*));
    };
}

/// The constants of C that stand for the variants of an enum of the core, with the name of the
/// field or parameter that takes them.
macro_rules! c_enum {
    ($($name:ident: $enum:ty { $($constant:ident => $variant:ident),* $(,)? })*) => {$(
        impl $crate::capi::input::Choice for $enum {
            const NAME: &'static str = stringify!($name);

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

/// `laid_out_like! { A: B { x, y, ... } }`: A and B have these fields, all of them, at the same
/// places.
macro_rules! laid_out_like {
    ($name:ident: $other:ty { $($field:ident),* $(,)? }) => {
        const _: () = assert!(
            size_of::<$name>() == size_of::<$other>()
                $(&& std::mem::offset_of!($name, $field) == std::mem::offset_of!($other, $field))*
        );
    };
}

pub(crate) use {c_enum, fixed, laid_out_like, versioned};
