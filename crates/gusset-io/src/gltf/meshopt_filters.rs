//! Filters of compressed attributes: unit vectors, quaternions, floats with shared exponents, and colours.

use crate::json_tape::Value;

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Filter {
    None,
    Octahedral,
    Quaternion,
    Exponential,
    Colour,
}

impl Filter {
    pub(super) fn from_json(name: Value<'_>) -> Option<Self> {
        [
            ("NONE", Self::None),
            ("OCTAHEDRAL", Self::Octahedral),
            ("QUATERNION", Self::Quaternion),
            ("EXPONENTIAL", Self::Exponential),
            ("COLOR", Self::Colour),
        ]
        .into_iter()
        .find_map(|(known, filter)| name.equals_text(known).then_some(filter))
    }
}

/// Undoes a filter. Leaves elements of an unexpected size as they are.
pub(super) fn apply_filter(filter: Filter, stride: usize, bytes: &mut [u8]) {
    match (filter, stride) {
        (Filter::Octahedral, 4) => each_of_4(bytes, |v: [i8; 4]| octahedral(v.map(f64::from), 127.0).map(|x| x as i8)),
        (Filter::Octahedral, 8) => {
            each_of_4(bytes, |v: [i16; 4]| octahedral(v.map(f64::from), 32767.0).map(|x| x as i16));
        }
        (Filter::Quaternion, 8) => each_of_4(bytes, quaternion),
        (Filter::Exponential, _) => {
            for word in bytes.chunks_exact_mut(4) {
                let value = i32::from_le_bytes([word[0], word[1], word[2], word[3]]);
                let (exponent, mantissa) = (value >> 24, value << 8 >> 8);
                word.copy_from_slice(&((f64::from(exponent).exp2() * f64::from(mantissa)) as f32).to_le_bytes());
            }
        }
        (Filter::Colour, 4) => each_of_4(bytes, |v: [u8; 4]| {
            let signed = |x: u8| f64::from(x as i8);
            colour(f64::from(v[0]), signed(v[1]), signed(v[2]), u32::from(v[3]), 255.0).map(|x| x as u8)
        }),
        (Filter::Colour, 8) => each_of_4(bytes, |v: [u16; 4]| {
            let signed = |x: u16| f64::from(x as i16);
            colour(f64::from(v[0]), signed(v[1]), signed(v[2]), u32::from(v[3]), 65535.0).map(|x| x as u16)
        }),
        _ => {}
    }
}

/// Numbers of one or two bytes.
trait Small: Copy + bytemuck::Pod {
    fn little(self) -> Self;
}

macro_rules! small {
    ($($kind:ty)*) => {$(
        impl Small for $kind {
            fn little(self) -> Self {
                Self::from_le(self)
            }
        }
    )*};
}

small!(i8 u8 i16 u16);

fn each_of_4<T: Small>(bytes: &mut [u8], change: impl Fn([T; 4]) -> [T; 4]) {
    for element in bytes.chunks_exact_mut(4 * size_of::<T>()) {
        let mut values = [T::zeroed(); 4];
        bytemuck::cast_slice_mut(&mut values).copy_from_slice(element);
        let changed = change(values.map(T::little)).map(T::little);
        element.copy_from_slice(bytemuck::cast_slice(&changed));
    }
}

/// Returns the unit vector of octahedral coordinates whose 1 is the third number. The fourth one stays.
fn octahedral([x, y, one, rest]: [f64; 4], largest: f64) -> [f64; 4] {
    let (x, y) = (x / one, y / one);
    let z = 1.0 - x.abs() - y.abs();
    let fold = (-z).max(0.0);
    let [x, y] = [x, y].map(|part| if part >= 0.0 { part - fold } else { part + fold });
    let scale = largest / (x * x + y * y + z * z).sqrt();
    [(x * scale).round(), (y * scale).round(), (z * scale).round(), rest]
}

fn quaternion(v: [i16; 4]) -> [i16; 4] {
    let largest = (v[3] & 3) as usize;
    let scale = std::f64::consts::FRAC_1_SQRT_2 / f64::from(v[3] | 3);
    let [x, y, z] = [v[0], v[1], v[2]].map(|part| f64::from(part) * scale);
    let w = (1.0 - x * x - y * y - z * z).max(0.0).sqrt();
    let mut made = [0; 4];
    for (place, part) in [w, x, y, z].into_iter().enumerate() {
        made[(largest + place) % 4] = (part * 32767.0).round() as i16;
    }
    made
}

/// Returns red, green, blue and opacity of luma, chroma and an opacity whose highest bit gives the scale.
fn colour(y: f64, co: f64, cg: f64, opacity: u32, largest: f64) -> [f64; 4] {
    let bits = 32 - opacity.leading_zeros();
    let range = (1_u64 << bits) - 1;
    let opacity = u64::from(opacity) & (range >> 1);
    let opacity = (opacity << 1) | (opacity & 1);
    let scale = largest / (range.max(1)) as f64;
    [y + co - cg, y + cg, y - co - cg, opacity as f64].map(|part| (part * scale).round())
}
