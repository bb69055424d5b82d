//! Accessors: typed numbers in buffer views, with strides, normalisation and sparse replacements.

use super::gltf_buffers::{Buffers, Bytes, element, malformed, not_whole};
use crate::error::{Note, Place, ReadError};
use crate::json_tape::Value;
use gusset_base::alloc;

/// Type of an accessor's numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Component {
    fn from_code(code: u64) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5124 => Self::I32,
            5125 => Self::U32,
            5126 => Self::F32,
            5130 => Self::F64,
            _ => return None,
        })
    }

    fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Largest value, by which normalised integers are divided.
    fn largest(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            Self::I32 => f64::from(i32::MAX),
            Self::U32 => f64::from(u32::MAX),
            Self::F32 | Self::F64 => 1.0,
        }
    }

    /// Returns the number in the first bytes.
    fn number(self, b: &[u8]) -> f64 {
        match self {
            Self::I8 => f64::from(b[0] as i8),
            Self::U8 => f64::from(b[0]),
            Self::I16 => f64::from(i16::from_le_bytes([b[0], b[1]])),
            Self::U16 => f64::from(u16::from_le_bytes([b[0], b[1]])),
            Self::I32 => f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Self::U32 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Self::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Self::F64 => f64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]),
        }
    }
}

/// Bytes of an accessor's elements, checked to exist.
struct Elements<'a> {
    bytes: Bytes<'a>,
    stride: usize,
    count: usize,
    component: Component,
}

/// Replacements of elements.
struct Sparse<'a> {
    indices: Elements<'a>,
    values: Elements<'a>,
}

/// An accessor whose bytes exist. Without `elements`, all numbers are 0 except the replaced ones.
pub(super) struct Accessor<'a> {
    name: String,
    pub(super) count: usize,
    pub(super) component: Component,
    pub(super) is_normalised: bool,
    /// Numbers of an element.
    pub(super) width: usize,
    elements: Option<Elements<'a>>,
    sparse: Option<Sparse<'a>>,
}

/// Reads accessors.
pub(super) struct Accessors<'a> {
    pub(super) buffers: Buffers<'a>,
    accessors: Vec<Value<'a>>,
}

fn width_from_type(kind: Value<'_>) -> Option<usize> {
    [("SCALAR", 1), ("VEC2", 2), ("VEC3", 3), ("VEC4", 4), ("MAT2", 4), ("MAT3", 9), ("MAT4", 16)]
        .into_iter()
        .find_map(|(name, width)| kind.equals_text(name).then_some(width))
}

impl<'a> Accessors<'a> {
    pub(super) fn new(root: Value<'a>, buffers: Buffers<'a>) -> Result<Self, ReadError> {
        Ok(Self { buffers, accessors: root.list("accessors")? })
    }

    /// Finds an accessor and its bytes.
    pub(super) fn open_accessor(&mut self, index: usize, notes: &mut Vec<Note>) -> Result<Accessor<'a>, ReadError> {
        let json = element(&self.accessors, index, "accessor")?;
        let name = format!("accessor {index}");
        let whole = |key: &str| json.get(key).map(|value| value.whole_number().ok_or_else(|| not_whole(&name, key)));
        let count = whole("count").transpose()?.ok_or_else(|| malformed(format!("{name} lacks its count")))?;
        let code = whole("componentType").transpose()?.unwrap_or(0);
        let component = Component::from_code(code)
            .ok_or_else(|| malformed(format!("{name} has numbers of the unknown type {code}")))?;
        let width = json.get("type").and_then(width_from_type);
        let width = width.ok_or_else(|| malformed(format!("{name} has elements of an unknown type")))?;
        let is_normalised = json.get("normalized").is_some_and(Value::is_true);
        let elements = match whole("bufferView").transpose()? {
            None => None,
            Some(view) => {
                let offset = whole("byteOffset").transpose()?.unwrap_or(0);
                Some(self.read_elements(&name, view as usize, offset, count, component, width, notes)?)
            }
        };
        let sparse =
            json.get("sparse").map(|sparse| self.read_sparse(&name, sparse, component, width, notes)).transpose()?;
        let count = usize::try_from(count).map_err(|_| ReadError::out_of_memory())?;
        Ok(Accessor { name, count, component, is_normalised, width, elements, sparse })
    }

    #[allow(clippy::too_many_arguments)]
    fn read_elements(
        &mut self,
        name: &str,
        view: usize,
        offset: u64,
        count: u64,
        component: Component,
        width: usize,
        notes: &mut Vec<Note>,
    ) -> Result<Elements<'a>, ReadError> {
        let view = self.buffers.read_view(view)?;
        let size = component.bytes() * width;
        let stride = view.stride.filter(|&stride| stride > 0).unwrap_or(size);
        let needed = match count {
            0 => Some(0),
            count => (count - 1).checked_mul(stride as u64).and_then(|bytes| bytes.checked_add(size as u64)),
        };
        let end = needed.and_then(|needed| needed.checked_add(offset));
        let fits = |bytes: &[u8]| end.is_some_and(|end| end <= bytes.len() as u64);
        let bytes = if fits(&view.bytes) {
            view.bytes
        } else if fits(&view.with_rest) {
            alloc::push(notes, Note::new(Place::Whole, format!("{name} exceeds its buffer view, but not the buffer")))?;
            view.with_rest
        } else {
            return Err(malformed(format!(
                "{name} reaches beyond its buffer: {count} elements from byte {offset}, where the view has {} bytes",
                view.with_rest.len()
            )));
        };
        // Both fit: they are at most the number of bytes.
        Ok(Elements { bytes: bytes.part(offset, needed.unwrap_or(0)), stride, count: count as usize, component })
    }

    fn read_sparse(
        &mut self,
        name: &str,
        json: Value<'a>,
        component: Component,
        width: usize,
        notes: &mut Vec<Note>,
    ) -> Result<Sparse<'a>, ReadError> {
        let incomplete = || malformed(format!("the sparse part of {name} is incomplete"));
        let whole = |json: Value<'a>, key: &str| json.get(key).and_then(Value::whole_number);
        let count = whole(json, "count").ok_or_else(incomplete)?;
        let places = json.get("indices").ok_or_else(incomplete)?;
        let kind = whole(places, "componentType").and_then(Component::from_code).ok_or_else(incomplete)?;
        let values = json.get("values").ok_or_else(incomplete)?;
        let mut part = |json: Value<'a>, component, width| {
            let view = whole(json, "bufferView").ok_or_else(incomplete)?;
            let offset = whole(json, "byteOffset").unwrap_or(0);
            let name = format!("the sparse part of {name}");
            self.read_elements(&name, view as usize, offset, count, component, width, notes)
        };
        Ok(Sparse { indices: part(places, kind, 1)?, values: part(values, component, width)? })
    }
}

impl Accessor<'_> {
    /// Returns whether the file has numbers of this accessor.
    pub(super) fn has_bytes(&self) -> bool {
        self.elements.is_some() || self.sparse.is_some()
    }

    /// Reads all elements as vectors of `N` numbers. Fails if the elements have another size.
    pub(super) fn read_vectors<const N: usize, T: Copy>(
        &self,
        buffers: &mut Buffers<'_>,
        convert: impl Fn(f64) -> T,
    ) -> Result<Vec<[T; N]>, ReadError> {
        if self.width != N {
            return Err(malformed(format!("{} has elements of {} numbers instead of {N}", self.name, self.width)));
        }
        let mut made = buffers.budget.allocate_vector(self.count as u64)?;
        let scale = if self.is_normalised { self.component.largest() } else { 1.0 };
        match &self.elements {
            None => made.resize(self.count, [convert(0.0); N]),
            Some(elements) => elements.read_into(scale, &convert, &mut made),
        }
        if let Some(sparse) = &self.sparse {
            let mut values = buffers.budget.allocate_vector(sparse.values.count as u64)?;
            sparse.values.read_into(scale, &convert, &mut values);
            for (k, value) in values.into_iter().enumerate() {
                let place = sparse.indices.component.number(&sparse.indices.bytes[k * sparse.indices.stride..]);
                let target = made.get_mut(place as usize).filter(|_| place >= 0.0).ok_or_else(|| {
                    let (name, count) = (&self.name, self.count);
                    malformed(format!("the sparse part of {name} names element {place} (the accessor has {count})"))
                })?;
                *target = value;
            }
        }
        Ok(made)
    }

    /// Reads all elements as indices.
    pub(super) fn read_indices(&self, buffers: &mut Buffers<'_>) -> Result<Vec<u32>, ReadError> {
        if self.width != 1 {
            return Err(malformed(format!("{} has indices of {} numbers", self.name, self.width)));
        }
        if let (Some(elements), None) = (&self.elements, &self.sparse)
            && let Some(made) = elements.plain_indices(buffers)?
        {
            return Ok(made);
        }
        // Numbers that are not indices become the largest one, which exceeds every count.
        let index = |number: f64| if number >= 0.0 && number.fract() == 0.0 { number as u32 } else { u32::MAX };
        Ok(self.read_vectors::<1, u32>(buffers, index)?.into_flattened())
    }
}

impl Elements<'_> {
    fn read_into<const N: usize, T>(&self, scale: f64, convert: &impl Fn(f64) -> T, made: &mut Vec<[T; N]>) {
        let (size, component) = (self.component.bytes(), self.component);
        if component == Component::F32 {
            made.extend(self.each_element(4 * N).map(|element| {
                std::array::from_fn(|part| {
                    let b = &element[4 * part..4 * part + 4];
                    convert(f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])))
                })
            }));
            return;
        }
        let lowest = if scale == 1.0 { f64::NEG_INFINITY } else { -1.0 };
        made.extend(self.each_element(size * N).map(|element| {
            std::array::from_fn(|part| convert((component.number(&element[size * part..]) / scale).max(lowest)))
        }));
    }

    fn each_element(&self, size: usize) -> impl Iterator<Item = &[u8]> {
        (0..self.count).map(move |k| &self.bytes[k * self.stride..k * self.stride + size])
    }

    /// Reads unsigned integers without a detour.
    fn plain_indices(&self, buffers: &mut Buffers<'_>) -> Result<Option<Vec<u32>>, ReadError> {
        let size = self.component.bytes();
        if self.stride != size {
            return Ok(None);
        }
        let mut made = buffers.budget.allocate_vector(self.count as u64)?;
        let bytes = &self.bytes[..self.count * size];
        match self.component {
            Component::U8 => made.extend(bytes.iter().map(|&byte| u32::from(byte))),
            Component::U16 => {
                made.extend(bytes.chunks_exact(2).map(|b| u32::from(u16::from_le_bytes([b[0], b[1]]))));
            }
            Component::U32 => {
                made.extend(bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])));
            }
            _ => return Ok(None),
        }
        Ok(Some(made))
    }
}
