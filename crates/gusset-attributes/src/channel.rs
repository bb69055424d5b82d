//! Channels: values of one kind for each element of the inputs, and the rule for mixing them.

use super::domain::{Counts, Domain};
use super::values::ValueType;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::strided::Strided;
use gusset_base::job::Job;
use gusset_base::par;

const STAGE: &str = "checking values";
/// Number of elements that a thread checks in one task.
const ELEMENTS_PER_TASK: usize = 1 << 14;
/// Largest number of components.
pub(crate) const MAX_CHANNEL_COMPONENTS: u32 = 1 << 12;

/// How the values of several sources become one value. An element with one source has its value,
/// bit for bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// The weighted mean, rounded for unsigned types.
    #[default]
    Linear,
    /// Directions with three components of a floating-point type: the weighted mean on the sphere,
    /// with length 1. The directions of faces that were turned over are reversed.
    Normal,
    /// Weights of bones, at least 0: the weighted mean. Keeps a limited number of the largest
    /// weights, and scales them to the sum 1, or in unsigned types to the largest value of the
    /// type.
    SkinWeights,
    /// The value of the source with the largest weight.
    Nearest,
    /// Texture coordinates. At the corners of new faces they follow [`Rule::Linear`] where both
    /// sides are on one chart. Elsewhere, each side's chart is extended up to a seam in the middle.
    Texture,
}

/// Values of the inputs' elements, with a fixed type and number of components.
#[derive(Debug, Clone)]
pub struct Channel<'a> {
    pub(super) domain: Domain,
    pub(super) value_type: ValueType,
    pub(super) components: usize,
    pub(super) rule: Rule,
    /// For [`Rule::SkinWeights`], the largest number of weights to keep; 0 for all.
    pub(super) max_influences: usize,
    /// The values of each input; `None` if it lacks the channel.
    pub(super) inputs: Vec<Option<Strided<'a>>>,
}

impl<'a> Channel<'a> {
    /// Creates a channel without inputs.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if `components` is 0 or above 4096, or if [`Rule::Normal`] is
    /// used with an unsigned type or a number of components other than three.
    pub fn new(domain: Domain, value_type: ValueType, components: u32, rule: Rule) -> Result<Channel<'a>> {
        Error::require(
            (1..=MAX_CHANNEL_COMPONENTS).contains(&components),
            "components",
            components.into(),
            1.0..=MAX_CHANNEL_COMPONENTS.into(),
        )?;
        if rule == Rule::Normal {
            Error::require(components == 3, "components", components.into(), "3 for normals")?;
            Error::require(
                value_type.largest_value().is_none(),
                "value_type",
                0.0,
                "a floating-point type for normals",
            )?;
        }
        let components = components as usize;
        Ok(Channel { domain, value_type, components, rule, max_influences: 0, inputs: Vec::new() })
    }

    /// Limits the number of skin weights kept for an element with several sources; 0 for all.
    #[must_use]
    pub fn with_max_influences(self, most: u32) -> Self {
        Channel { max_influences: most as usize, ..self }
    }

    /// Adds the values of the next input. The values of an element begin every `stride` bytes, with
    /// any alignment; 0 means contiguous values.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`],
    /// [`Error::OutOfMemory`].
    pub fn push(&mut self, bytes: &'a [u8], stride: usize, count: usize) -> Result<()> {
        let values = Strided::new(bytes, count, stride, self.bytes_per_value(), "values")?;
        alloc::push(&mut self.inputs, Some(values))
    }

    /// Adds an input that lacks the channel. Elements that mix its sources with others take the
    /// values of the others. All other elements become 0.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn push_missing(&mut self) -> Result<()> {
        alloc::push(&mut self.inputs, None)
    }

    /// The type and the number of the values of one element.
    pub fn value_type_and_components(&self) -> (ValueType, u32) {
        (self.value_type, self.components as u32)
    }

    /// Size of the values of one element in bytes.
    pub fn bytes_per_value(&self) -> usize {
        self.components * self.value_type.size()
    }

    /// Checks that each input has values for all its elements, that all values are finite, and that
    /// skin weights are at least 0.
    pub(super) fn check_inputs(&self, needed: &[Counts], job: &Job<'_>) -> Result<()> {
        if self.inputs.len() != needed.len() {
            return Err(Error::InputsDiffer { given: self.inputs.len() as u64, needed: needed.len() as u64 });
        }
        for ((values, counts), input) in self.inputs.iter().zip(needed).zip(0..) {
            let (Some(values), needed) = (values, counts.count(self.domain)) else { continue };
            if values.count() != needed {
                return Err(Error::ValuesDiffer { input, given: values.count() as u64, needed: needed as u64 });
            }
        }
        let floating = self.value_type.largest_value().is_none();
        if !floating || self.rule == Rule::Nearest {
            return Ok(());
        }
        let (at_least, size) =
            (if self.rule == Rule::SkinWeights { 0.0 } else { f64::NEG_INFINITY }, self.value_type.size());
        let is_bad = |value: f64| !value.is_finite() || value < at_least;
        for (values, input) in self.inputs.iter().zip(0..).filter_map(|(values, input)| Some((values.as_ref()?, input)))
        {
            let bad = |element: &usize| {
                let bytes = values.bytes(*element);
                bytes.chunks_exact(size).any(|value| is_bad(self.value_type.read(value)))
            };
            let found = par::map_cancellable(
                job,
                STAGE,
                par::split_into_ranges(values.count(), ELEMENTS_PER_TASK),
                |mut range| range.find(bad),
            )?;
            if let Some(&index) = found.iter().flatten().next() {
                let mut own = values.bytes(index).chunks_exact(size).map(|value| self.value_type.read(value));
                let value = own.find(|&value| is_bad(value)).unwrap_or(f64::NAN);
                return Err(Error::BadValue { element: self.error_element(), index: index as u64, input, value });
            }
        }
        Ok(())
    }

    fn error_element(&self) -> Element {
        match self.domain {
            Domain::Vertices => Element::Vertex,
            Domain::Corners => Element::Corner,
            Domain::Faces => Element::Face,
        }
    }
}
