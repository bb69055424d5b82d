//! Parameters as hosts see them: kinds, ranges, defaults, suggestions, and the validation of values.
//!
//! Filters declare parameters by `params!`, which also gives the values their types.

use super::data::Input;
use super::extent::round_to_two_digits;
use glam::DVec3;
pub use gusset_base::choice::Choice;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::Aabb;

/// The kind of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParamKind {
    /// 0 or 1.
    Bool,
    /// A whole number.
    Int,
    /// A number without a unit.
    Real,
    /// The index of one of [`Param::choices`].
    Choice,
    /// A length, in the unit of the positions.
    Length,
    /// An angle, in radians.
    Angle,
    /// A point: three coordinates.
    Point,
    /// A direction: three components, not all 0.
    Direction,
    /// A plane a x + b y + c z = d: a, b, c, d, the first three not all 0.
    Plane,
}

impl ParamKind {
    /// The number of components.
    pub const fn component_count(self) -> usize {
        match self {
            ParamKind::Point | ParamKind::Direction => 3,
            ParamKind::Plane => 4,
            _ => 1,
        }
    }

    pub(super) const fn is_integer(self) -> bool {
        matches!(self, ParamKind::Bool | ParamKind::Int | ParamKind::Choice)
    }
}

/// A parameter of a filter.
#[derive(Debug, Clone, Copy)]
pub struct Param {
    /// Stable for ever: scripts and stored projects name it.
    pub id: &'static str,
    /// For dialogs.
    pub label: &'static str,
    /// Its meaning, in whole sentences.
    pub help: &'static str,
    /// The kind of its values.
    pub kind: ParamKind,
    /// The smallest value of each component.
    pub min: f64,
    /// The largest value of each component.
    pub max: f64,
    /// One value for each component.
    pub default: &'static [f64],
    /// The increment of a spin box; 0 leaves it to the host.
    pub step: f64,
    /// The choices of a [`ParamKind::Choice`]; else empty.
    pub choices: &'static [Choice],
    /// The default that suits the inputs.
    pub(super) suggestion: Option<Suggestion>,
}

/// How a default follows from the inputs and their bounding box. `None` keeps the plain default.
#[derive(Debug, Clone, Copy)]
pub(super) enum Suggestion {
    /// This fraction of the diagonal, rounded to two digits.
    Ratio(f64),
    /// A number.
    Number(fn(&[Input<'_>], &Aabb) -> Option<f64>),
    /// A point or a direction.
    Vector(fn(&[Input<'_>], &Aabb) -> Option<DVec3>),
    /// The components of a plane.
    Plane(fn(&[Input<'_>], &Aabb) -> Option<[f64; 4]>),
}

impl Param {
    /// True if `value` is valid for a component.
    pub fn accepts(&self, value: f64) -> bool {
        // NaN is in no range.
        (self.min..=self.max).contains(&value) && (!self.kind.is_integer() || value.fract() == 0.0)
    }

    /// Returns the values of a component for a message.
    fn allowed(&self) -> Allowed {
        if self.kind.is_integer() { Allowed::Whole(self.min, self.max) } else { Allowed::Between(self.min, self.max) }
    }

    /// Checks the components of a value.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for the first component out of range, for a direction or a normal
    /// of length 0, and for a plane too far from the origin.
    pub(super) fn check(&self, components: &[f64]) -> Result<()> {
        components.iter().try_for_each(|&value| Error::require(self.accepts(value), self.id, value, self.allowed()))?;
        if matches!(self.kind, ParamKind::Direction | ParamKind::Plane) {
            let largest = components[..3].iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
            Error::require(largest > 0.0, self.id, 0.0, "a vector other than 0")?;
            components[3..].iter().try_for_each(|&d| {
                Error::require((d / largest).is_finite(), self.id, d, "a finite multiple of the normal")
            })?;
        }
        Ok(())
    }

    /// Replaces the components of the default by those that suit the inputs, as far as they are in
    /// range.
    pub(super) fn suggest(&self, inputs: &[Input<'_>], extent: &Aabb, components: &mut [f64]) {
        let mut set = |suggested: &[f64]| {
            for (component, &value) in components.iter_mut().zip(suggested) {
                // Meshes may be of any size, even beyond all ranges.
                *component = if value.is_nan() { *component } else { value.clamp(self.min, self.max) };
            }
        };
        match self.suggestion {
            None => {}
            Some(Suggestion::Ratio(ratio)) => set(&[round_to_two_digits(ratio * extent.diagonal())]),
            Some(Suggestion::Number(number)) => number(inputs, extent).iter().for_each(|&number| set(&[number])),
            Some(Suggestion::Vector(vector)) => vector(inputs, extent).iter().for_each(|v| set(&v.to_array())),
            Some(Suggestion::Plane(plane)) => plane(inputs, extent).iter().for_each(|plane| set(plane)),
        }
    }
}
