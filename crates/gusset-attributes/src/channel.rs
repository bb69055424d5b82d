//! Channels: values of one kind for each element of the inputs, and the rule by which they are
//! mixed.

use super::domain::{Counts, Domain};
use super::values::ValueType;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::strided::Strided;
use gusset_base::job::Job;
use gusset_base::par;

const STAGE: &str = "checking values";
/// Elements that one thread checks at a time.
const CHUNK: usize = 1 << 14;
/// The largest number of components.
pub(crate) const MAX_COMPONENTS: u32 = 1 << 12;

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
    /// Weights of bones, at least 0: the weighted mean, of which so many of the largest are kept
    /// and made to have the sum 1, or in unsigned types the largest value of the type.
    SkinWeights,
    /// The value of the source that counts most.
    Nearest,
    /// Texture coordinates: at the corners of new faces, as [`Rule::Linear`] where both sides are on
    /// one chart; elsewhere each side's chart goes on to a seam in the middle.
    Texture,
}

/// Values of the inputs' elements: so many components of one type for each.
#[derive(Debug, Clone)]
pub struct Channel<'a> {
    pub(super) domain: Domain,
    pub(super) value_type: ValueType,
    pub(super) components: usize,
    pub(super) rule: Rule,
    /// Of [`Rule::SkinWeights`], how many are kept; 0 for all.
    pub(super) max_influences: usize,
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
        Ok(Channel { domain, value_type, components, rule, max_influences: 0, inputs: Vec::new() })
    }

    /// Keeps so many of the skin weights of an element that has several sources; 0 for all.
    #[must_use]
    pub fn with_max_influences(self, most: u32) -> Self {
        Channel { max_influences: most as usize, ..self }
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

    /// The type and the number of the values of one element.
    pub fn values(&self) -> (ValueType, u32) {
        (self.value_type, self.components as u32)
    }

    /// Bytes of the values of one element.
    pub fn size(&self) -> usize {
        self.components * self.value_type.size()
    }

    /// Holds the values to the rules: as many as the inputs have elements, all of them numbers, and
    /// skin weights at least 0.
    pub(super) fn check(&self, needed: &[Counts], job: &Job<'_>) -> Result<()> {
        if self.inputs.len() != needed.len() {
            return Err(Error::InputsDiffer { given: self.inputs.len() as u64, needed: needed.len() as u64 });
        }
        for ((values, counts), input) in self.inputs.iter().zip(needed).zip(0..) {
            let (Some(values), needed) = (values, counts.of(self.domain)) else { continue };
            if values.count() != needed {
                return Err(Error::ValuesDiffer { input, given: values.count() as u64, needed: needed as u64 });
            }
        }
        let floating = self.value_type.largest().is_none();
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
            let found =
                par::map_cancellable(job, STAGE, par::ranges(values.count(), CHUNK), |mut range| range.find(bad))?;
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
