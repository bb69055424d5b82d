//! Channels: values of one kind for each element of the inputs, and the rule by which they are
//! mixed.

use super::origins::{Domain, Origins};
use crate::alloc;
use crate::choice::choices;
use crate::error::{Element, Error, Result};
use crate::geom::strided::Strided;
use crate::job::Job;
use crate::par;

const STAGE: &str = "checking values";
/// Elements that one thread checks at a time.
const CHUNK: usize = 1 << 14;
/// The largest number of components.
pub(crate) const MAX_COMPONENTS: u32 = 1 << 12;

/// The type of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueType {
    /// 32-bit float.
    F32,
    /// 64-bit float.
    F64,
    /// 8-bit unsigned.
    U8,
    /// 16-bit unsigned.
    U16,
    /// 32-bit unsigned.
    U32,
}

impl ValueType {
    /// Bytes of one value.
    pub fn size(self) -> usize {
        match self {
            ValueType::U8 => 1,
            ValueType::U16 => 2,
            ValueType::F32 | ValueType::U32 => 4,
            ValueType::F64 => 8,
        }
    }

    /// The largest value of an unsigned type.
    pub(super) fn largest(self) -> Option<f64> {
        match self {
            ValueType::F32 | ValueType::F64 => None,
            ValueType::U8 => Some(u8::MAX.into()),
            ValueType::U16 => Some(u16::MAX.into()),
            ValueType::U32 => Some(u32::MAX.into()),
        }
    }

    /// The first value in `bytes`, exactly.
    #[inline]
    pub(super) fn read(self, bytes: &[u8]) -> f64 {
        fn first<T: bytemuck::AnyBitPattern>(bytes: &[u8]) -> T {
            bytemuck::pod_read_unaligned(&bytes[..size_of::<T>()])
        }
        match self {
            ValueType::F32 => first::<f32>(bytes).into(),
            ValueType::F64 => first(bytes),
            ValueType::U8 => bytes[0].into(),
            ValueType::U16 => first::<u16>(bytes).into(),
            ValueType::U32 => first::<u32>(bytes).into(),
        }
    }

    /// Writes a value; to an unsigned type the nearest one that it has.
    #[inline]
    pub(super) fn write(self, value: f64, bytes: &mut [u8]) {
        let mut put = |value: &[u8]| bytes[..value.len()].copy_from_slice(value);
        match self {
            ValueType::F32 => put(&(value as f32).to_ne_bytes()),
            ValueType::F64 => put(&value.to_ne_bytes()),
            ValueType::U8 => put(&[value.round() as u8]),
            ValueType::U16 => put(&(value.round() as u16).to_ne_bytes()),
            ValueType::U32 => put(&(value.round() as u32).to_ne_bytes()),
        }
    }
}

/// How the values of several sources become one. An element with one source has its value, bit for
/// bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// The weighted mean; of unsigned types rounded.
    #[default]
    Linear,
    /// Directions of three components, of a floating type: the weighted mean on the sphere, of
    /// length 1. Those of faces that were turned over are turned, too.
    Normal,
    /// Shares, at least 0, as of bones: the weighted mean, of which so many of the largest are kept
    /// and made to have the sum 1, or in unsigned types the largest value of the type.
    Shares,
    /// The value of the source that counts most.
    Nearest,
    /// Texture coordinates: at the corners of new faces, as [`Rule::Linear`] where both sides are on
    /// one chart; elsewhere each side's chart goes on to a seam in the middle.
    Texture,
}

choices! { for Rule:
    Linear => "Mean", "The weighted mean of the sources.";
    Normal => "Normals", "The weighted mean on the sphere, of length 1; turned with faces that are turned over.";
    Shares => "Shares", "The weighted mean, of which the largest shares are kept, with the sum 1.";
    Nearest => "Nearest", "The value of the source that counts most.";
    Texture => "Texture coordinates", "The weighted mean where both sides are on one chart, else each chart goes on.";
}

/// Values of the inputs' elements: so many components of one type for each.
#[derive(Debug, Clone)]
pub struct Channel<'a> {
    pub(super) domain: Domain,
    pub(super) value_type: ValueType,
    pub(super) components: usize,
    pub(super) rule: Rule,
    /// Of [`Rule::Shares`], how many are kept; 0 for all.
    pub(super) most_shares: usize,
    /// Of each input; `None` if it has no such values.
    pub(super) inputs: Vec<Option<Strided<'a>>>,
}

impl<'a> Channel<'a> {
    /// Without inputs.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for no components or more than 4096, and for [`Rule::Normal`]
    /// with other than three or an unsigned type.
    pub fn new(domain: Domain, value_type: ValueType, components: u32, rule: Rule) -> Result<Channel<'a>> {
        Error::require((1..=MAX_COMPONENTS).contains(&components), "components", components.into())?;
        if rule == Rule::Normal {
            Error::require(components == 3, "components", components.into())?;
            Error::require(value_type.largest().is_none(), "value_type", 0.0)?;
        }
        let components = components as usize;
        Ok(Channel { domain, value_type, components, rule, most_shares: 0, inputs: Vec::new() })
    }

    /// Keeps so many of the shares of an element that has several sources; 0 for all.
    #[must_use]
    pub fn with_most_shares(self, most: u32) -> Self {
        Channel { most_shares: most as usize, ..self }
    }

    /// Adds the values of the next input: of each element at the start of every `stride` bytes, 0
    /// for values without gaps; any alignment.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`],
    /// [`Error::OutOfMemory`].
    pub fn push(&mut self, bytes: &'a [u8], stride: usize, count: usize) -> Result<()> {
        let values = Strided::new(bytes, count, stride, self.size(), "values")?;
        alloc::push(&mut self.inputs, Some(values))
    }

    /// Adds an input that has no such values: others count for its elements as far as they mix, and
    /// the rest is 0.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn push_missing(&mut self) -> Result<()> {
        alloc::push(&mut self.inputs, None)
    }

    /// Bytes of the values of one element.
    pub fn size(&self) -> usize {
        self.components * self.value_type.size()
    }

    /// Holds the values to the rules: as many as the inputs have elements, all of them numbers, and
    /// shares at least 0.
    pub(super) fn check(&self, origins: &Origins, job: &Job<'_>) -> Result<()> {
        let needed = origins.inputs();
        if self.inputs.len() != needed.len() {
            return Err(Error::InputsDiffer { given: self.inputs.len() as u64, needed: needed.len() as u64 });
        }
        for ((values, counts), input) in self.inputs.iter().zip(needed).zip(0..) {
            let (Some(values), needed) = (values, counts.of(self.domain)) else { continue };
            if values.len() != needed {
                return Err(Error::ValuesDiffer { input, given: values.len() as u64, needed: needed as u64 });
            }
        }
        let floating = self.value_type.largest().is_none();
        if !floating || self.rule == Rule::Nearest {
            return Ok(());
        }
        let (at_least, size) = (if self.rule == Rule::Shares { 0.0 } else { f64::NEG_INFINITY }, self.value_type.size());
        let is_bad = |value: f64| !value.is_finite() || value < at_least;
        for (values, input) in self.inputs.iter().zip(0..).filter_map(|(values, input)| Some((values.as_ref()?, input))) {
            let bad = |element: &usize| {
                let bytes = values.bytes(*element);
                bytes.chunks_exact(size).any(|value| is_bad(self.value_type.read(value)))
            };
            let found = par::map_cancellable(job, STAGE, par::ranges(values.len(), CHUNK), |mut range| range.find(bad))?;
            if let Some(&index) = found.iter().flatten().next() {
                let mut own = values.bytes(index).chunks_exact(size).map(|value| self.value_type.read(value));
                let value = own.find(|&value| is_bad(value)).unwrap_or(f64::NAN);
                return Err(Error::BadValue { element: self.element(), index: index as u64, input, value });
            }
        }
        Ok(())
    }

    fn element(&self) -> Element {
        match self.domain {
            Domain::Vertices => Element::Vertex,
            Domain::Corners => Element::Corner,
            Domain::Faces => Element::Face,
        }
    }
}

/// Where the values of a result go: those of each element at the start of every stride.
#[derive(Debug)]
pub struct Output<'a> {
    pub(super) bytes: &'a mut [u8],
    pub(super) stride: usize,
    pub(super) value_type: ValueType,
    pub(super) components: usize,
}

impl<'a> Output<'a> {
    /// Room for `count` elements of a channel; `stride` in bytes, 0 for values without gaps.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`].
    pub fn new(bytes: &'a mut [u8], stride: usize, count: usize, channel: &Channel<'_>) -> Result<Output<'a>> {
        let needed = Strided::span(count, stride, channel.size(), "values")?;
        let stride = if stride == 0 { channel.size() } else { stride };
        let given = bytes.len() as u64;
        let Some(bytes) = bytes.get_mut(..needed) else {
            return Err(Error::ArrayTooShort { what: "values", needed: needed as u64, given });
        };
        Ok(Output { bytes, stride, value_type: channel.value_type, components: channel.components })
    }

    /// Component `c` of element `k`.
    pub(super) fn get(&self, k: usize, c: usize) -> f64 {
        self.value_type.read(&self.bytes[k * self.stride + c * self.value_type.size()..])
    }

    pub(super) fn set(&mut self, k: usize, c: usize, value: f64) {
        self.value_type.write(value, &mut self.bytes[k * self.stride + c * self.value_type.size()..]);
    }
}
