//! Parameters: kinds, ranges, defaults, and the check of values against them.

use crate::error::{Error, Result};
use glam::DVec3;

/// What a parameter's values mean.
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
    /// How many values it has.
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

/// One choice of a [`ParamKind::Choice`].
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// For menus.
    pub label: &'static str,
    /// What it does.
    pub help: &'static str,
}

/// A parameter of a filter.
#[derive(Debug, Clone, Copy)]
pub struct Param {
    /// Stable for ever: scripts and stored projects name it.
    pub id: &'static str,
    /// For dialogs.
    pub label: &'static str,
    /// What it does, in whole sentences.
    pub help: &'static str,
    /// What its values mean.
    pub kind: ParamKind,
    /// The least value of each component.
    pub min: f64,
    /// The greatest value of each component.
    pub max: f64,
    /// As many values as the kind has components.
    pub default: &'static [f64],
    /// What a spin box adds; 0 if the host may choose.
    pub step: f64,
    /// Of a [`ParamKind::Choice`]; else empty.
    pub choices: &'static [Choice],
}

/// Lengths that may be meant: meshes come in all units.
pub(super) const LENGTHS: [f64; 2] = [1e-15, 1e15];

/// Coordinates that may be meant, and lengths with a sign.
pub(super) const PLACES: [f64; 2] = [-1e15, 1e15];

impl Param {
    /// A parameter that is no choice.
    pub(super) const fn new(
        id: &'static str,
        label: &'static str,
        help: &'static str,
        kind: ParamKind,
        [min, max]: [f64; 2],
        default: &'static [f64],
    ) -> Self {
        let step = if kind.is_whole() { 1.0 } else { 0.0 };
        Param { id, label, help, kind, min, max, default, step, choices: &[] }
    }

    /// Something that is done or not; not by default.
    pub(super) const fn flag(id: &'static str, label: &'static str, help: &'static str) -> Self {
        Param::new(id, label, help, ParamKind::Bool, [0.0, 1.0], &[0.0])
    }

    /// The greatest error of a result, relative to a size that the help names.
    pub(super) const fn relative(id: &'static str, label: &'static str, help: &'static str) -> Self {
        Param::new(id, label, help, ParamKind::Real, [1e-9, 1.0], &[1e-4])
    }

    /// A choice, whose default is the first.
    pub(super) const fn choice(
        id: &'static str,
        label: &'static str,
        help: &'static str,
        choices: &'static [Choice],
    ) -> Self {
        let max = (choices.len() - 1) as f64;
        Param { id, label, help, kind: ParamKind::Choice, min: 0.0, max, default: &[0.0], step: 1.0, choices }
    }

    /// True if `value` may stand for a component.
    pub fn accepts(&self, value: f64) -> bool {
        // NaN is in no range.
        (self.min..=self.max).contains(&value) && (!self.kind.is_whole() || value.fract() == 0.0)
    }
}

/// Values that are in range, by parameter.
pub struct Values<'a> {
    params: &'static [Param],
    values: &'a [f64],
}

impl<'a> Values<'a> {
    /// `values` of all `params`.
    pub(super) fn check(params: &'static [Param], values: &'a [f64]) -> Result<Self> {
        let mut rest = values;
        for param in params {
            let (own, next) = rest.split_at(param.kind.arity());
            if let Some(&value) = own.iter().find(|&&value| !param.accepts(value)) {
                return Err(Error::OptionOutOfRange { option: param.id, value });
            }
            let has_direction = matches!(param.kind, ParamKind::Direction | ParamKind::Plane);
            if has_direction && own[..3].iter().all(|&component| component == 0.0) {
                return Err(Error::OptionOutOfRange { option: param.id, value: 0.0 });
            }
            rest = next;
        }
        Ok(Values { params, values })
    }

    /// The values of parameter `id`, which the filter must have.
    fn of(&self, id: &str) -> &'a [f64] {
        let mut start = 0;
        for param in self.params {
            let end = start + param.kind.arity();
            if param.id == id {
                return &self.values[start..end];
            }
            start = end;
        }
        panic!("the filter has no parameter {id}")
    }

    /// The value of a parameter of one component.
    pub(super) fn number(&self, id: &str) -> f64 {
        self.of(id)[0]
    }

    /// The value of a parameter of three components.
    pub(super) fn vector(&self, id: &str) -> DVec3 {
        DVec3::from_slice(&self.of(id)[..3])
    }

    /// Whether a flag is set.
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

    /// The place of a choice.
    pub(super) fn chosen(&self, id: &str) -> usize {
        self.number(id) as usize
    }
}
