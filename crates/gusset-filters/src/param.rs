//! Parameters: kinds, ranges, defaults, and the validation of values.

use glam::DVec3;
use gusset_attributes::Origins;
pub use gusset_base::choice::Choice;
use gusset_base::choice::Choices;
use gusset_base::error::{Error, Result};
use std::ops::Range;

/// The kind of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParamKind {
    /// 0 or 1.
    Bool,
    /// A whole number.
    Int,
    /// A number without a unit.
    Real,
    /// The place of one of [`Param::choices`].
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
    pub const fn arity(self) -> usize {
        match self {
            ParamKind::Point | ParamKind::Direction => 3,
            ParamKind::Plane => 4,
            _ => 1,
        }
    }

    const fn is_whole(self) -> bool {
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
    /// For a length, its suggested ratio to the diagonal of the inputs' bounding box; 0 suggests
    /// none.
    pub size_ratio: f64,
}

/// Positive lengths: meshes come in all units.
pub(super) const LENGTHS: [f64; 2] = [1e-15, 1e15];

/// Lengths from 0 on.
pub(super) const NON_NEGATIVE: [f64; 2] = [0.0, 1e15];

/// Coordinates, and signed lengths.
pub(super) const COORDINATES: [f64; 2] = [-1e15, 1e15];

impl Param {
    /// A parameter without help.
    pub(super) const fn new(
        kind: ParamKind,
        id: &'static str,
        label: &'static str,
        [min, max]: [f64; 2],
        default: &'static [f64],
    ) -> Self {
        let step = if kind.is_whole() { 1.0 } else { 0.0 };
        Param { id, label, help: "", kind, min, max, default, step, choices: &[], size_ratio: 0.0 }
    }

    /// A whole number.
    pub(super) const fn int(id: &'static str, label: &'static str, range: [f64; 2], default: &'static [f64]) -> Self {
        Param::new(ParamKind::Int, id, label, range, default)
    }

    /// A number without a unit.
    pub(super) const fn real(id: &'static str, label: &'static str, range: [f64; 2], default: &'static [f64]) -> Self {
        Param::new(ParamKind::Real, id, label, range, default)
    }

    /// A length.
    pub(super) const fn length(
        id: &'static str,
        label: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> Self {
        Param::new(ParamKind::Length, id, label, range, default)
    }

    /// A direction; the z axis by default.
    pub(super) const fn direction(id: &'static str, label: &'static str) -> Self {
        Param::new(ParamKind::Direction, id, label, COORDINATES, &[0.0, 0.0, 1.0])
    }

    /// A plane; z = 0 by default.
    pub(super) const fn plane(id: &'static str, label: &'static str) -> Self {
        Param::new(ParamKind::Plane, id, label, COORDINATES, &[0.0, 0.0, 1.0, 0.0])
    }

    /// A flag, off by default.
    pub(super) const fn flag(id: &'static str, label: &'static str) -> Self {
        Param::new(ParamKind::Bool, id, label, [0.0, 1.0], &[0.0])
    }

    /// A bound on the error of a result, relative to a size that the help names.
    pub(super) const fn relative_error(id: &'static str, label: &'static str) -> Self {
        Param::real(id, label, [1e-9, 1.0], &[1e-4])
    }

    /// A choice, by default the first.
    pub(super) const fn choice(id: &'static str, label: &'static str, choices: &'static [Choice]) -> Self {
        let range = [0.0, (choices.len() - 1) as f64];
        Param { choices, ..Param::new(ParamKind::Choice, id, label, range, &[0.0]) }
    }

    /// The parameter with its help.
    pub(super) const fn with_help(self, help: &'static str) -> Self {
        Param { help, ..self }
    }

    /// The length with a default relative to the diagonal of the inputs.
    pub(super) const fn with_size_ratio(self, size_ratio: f64) -> Self {
        Param { size_ratio, ..self }
    }

    /// True if `value` is valid for a component.
    pub fn accepts(&self, value: f64) -> bool {
        // NaN is in no range.
        (self.min..=self.max).contains(&value) && (!self.kind.is_whole() || value.fract() == 0.0)
    }
}

/// The places of the values of parameter `id` among those of all parameters.
pub(super) fn range_of(params: &[Param], id: &str) -> Option<Range<usize>> {
    let mut end = 0;
    params.iter().find_map(|param| {
        let start = end;
        end += param.kind.arity();
        (param.id == id).then_some(start..end)
    })
}

/// What a call asks for: values in range, by parameter, and whether to trace the elements of results
/// back to those of the inputs.
pub struct Values<'a> {
    params: &'static [Param],
    values: &'a [f64],
    traced: bool,
}

impl<'a> Values<'a> {
    /// `values` of all `params`.
    pub(super) fn check(params: &'static [Param], values: &'a [f64]) -> Result<Self> {
        let mut rest = values;
        for param in params {
            let (own, next) = rest.split_at(param.kind.arity());
            own.iter().try_for_each(|&value| Error::require(param.accepts(value), param.id, value))?;
            let has_direction = matches!(param.kind, ParamKind::Direction | ParamKind::Plane);
            let is_zero = has_direction && own[..3].iter().all(|&component| component == 0.0);
            Error::require(!is_zero, param.id, 0.0)?;
            rest = next;
        }
        Ok(Values { params, values, traced: false })
    }

    /// The same values with or without origins asked for.
    pub(super) fn traced(self, traced: bool) -> Self {
        Values { traced, ..self }
    }

    /// The origins of the elements of a result, if they are asked for.
    pub(super) fn origins(&self, of: impl FnOnce() -> Result<Origins>) -> Result<Option<Box<Origins>>> {
        self.traced.then(|| of().map(Box::new)).transpose()
    }

    /// The values of parameter `id`, which the filter must have.
    fn of(&self, id: &str) -> &'a [f64] {
        let range = range_of(self.params, id).unwrap_or_else(|| panic!("the filter has no parameter {id}"));
        &self.values[range]
    }

    /// The value of a parameter of one component.
    pub(super) fn number(&self, id: &str) -> f64 {
        self.of(id)[0]
    }

    /// The value of a parameter of three components.
    pub(super) fn vector(&self, id: &str) -> DVec3 {
        DVec3::from_slice(&self.of(id)[..3])
    }

    /// True if a flag is set.
    pub(super) fn is_set(&self, id: &str) -> bool {
        self.number(id) != 0.0
    }

    /// A unit vector along a direction.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]: it has no length.
    pub(super) fn direction(&self, id: &'static str) -> Result<DVec3> {
        let given = self.vector(id);
        given.try_normalize().ok_or(Error::OptionOutOfRange { option: id, value: given.length() })
    }

    /// The unit normal n of a plane and its distance d from the origin: n . x = d.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]: its normal has no length.
    pub(super) fn plane(&self, id: &'static str) -> Result<(DVec3, f64)> {
        let length = self.vector(id).length();
        self.direction(id).map(|normal| (normal, self.of(id)[3] / length))
    }

    /// The place of the choice made.
    pub(super) fn place(&self, id: &str) -> usize {
        self.number(id) as usize
    }

    /// The value of the choice made.
    pub(super) fn choice<T: Copy>(&self, id: &str, choices: Choices<T>) -> T {
        choices.values[self.place(id)]
    }
}
