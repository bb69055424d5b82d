//! Typed parameters: a filter declares its parameters once, each with the type of its value, and
//! its body gets a struct of these values.
//!
//! ```text
//! params! {
//!     vertices: Vertices = Param::choice("Weld", "The vertices to weld.", Vertices::CHOICES);
//!     tolerance: Option<f64> = WELD_TOLERANCE;
//! }
//!
//! fn run(inputs: &[Input<'_>], values: &Values<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
//!     ... values.tolerance ...
//! }
//! ```
//!
//! The name of a field is the id of its parameter. A body cannot read a parameter that the filter
//! does not declare: the struct lacks the field. The compiler warns of a field that is never read.

use super::data::Input;
pub(super) use super::param::Param;
use super::param::{ParamKind, Suggestion};
use glam::DVec3;
use gusset_attributes::Origins;
use gusset_base::choice::Choices;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use std::ops::Deref;

/// The parameters of a filter; [`params!`] implements it.
pub(super) trait Parameters {
    /// All parameters, in the order of their values.
    const PARAMS: &'static [Param];

    /// The values of all parameters, from components that [`Param::check`] accepts.
    fn read(components: &[f64]) -> Self;
}

/// A filter without parameters.
impl Parameters for () {
    const PARAMS: &'static [Param] = &[];

    fn read(_: &[f64]) {}
}

/// `params! { id: Type = parameter; ... }` declares the struct `Params` with a field for each
/// parameter of a filter.
macro_rules! params {
    ($($id:ident: $type:ty = $param:expr;)+) => {
        /// The values of the parameters.
        pub(super) struct Params {
            $($id: $type,)+
        }

        impl $crate::typed_param::Parameters for Params {
            const PARAMS: &'static [$crate::param::Param] = &[$({
                const PARAM: $crate::typed_param::TypedParam<$type> = $param;
                PARAM.with_id(stringify!($id))
            }),+];

            fn read(mut components: &[f64]) -> Self {
                Params {
                    $($id: {
                        const PARAM: $crate::typed_param::TypedParam<$type> = $param;
                        PARAM.take_value(&mut components)
                    }),+
                }
            }
        }
    };
}
pub(super) use params;

/// A parameter, still without its id, whose values are of type `T`.
pub(super) struct TypedParam<T: 'static> {
    param: Param,
    read: ValueReader<T>,
}

/// The way from components to a value.
enum ValueReader<T: 'static> {
    Components(fn(&[f64]) -> T),
    Choice(&'static [T]),
}

/// A plane n . x = d.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlaneValue {
    /// The unit normal n.
    pub(super) normal: DVec3,
    /// The signed distance d from the origin.
    pub(super) distance: f64,
}

/// Positive lengths: meshes come in all units.
pub(super) const LENGTH_RANGE: [f64; 2] = [1e-15, 1e15];

/// Lengths from 0 on.
pub(super) const NON_NEGATIVE_RANGE: [f64; 2] = [0.0, 1e15];

/// Lengths from 0 on, and -1 for automatic ones.
pub(super) const NON_NEGATIVE_OR_AUTO_RANGE: [f64; 2] = [-1.0, 1e15];

/// Coordinates, and signed lengths.
pub(super) const COORDINATE_RANGE: [f64; 2] = [-1e15, 1e15];

/// Numbers of elements that a report lists.
pub(super) const LISTED_COUNT_RANGE: [f64; 2] = [0.0, 1e6];

/// The largest number of 32 bits.
pub(super) const MAX_COUNT: f64 = u32::MAX as f64;

impl Param {
    const fn new(
        kind: ParamKind,
        [label, help]: [&'static str; 2],
        [min, max]: [f64; 2],
        default: &'static [f64],
    ) -> Param {
        let step = if kind.is_integer() { 1.0 } else { 0.0 };
        Param { id: "", label, help, kind, min, max, default, step, choices: &[], suggestion: None }
    }

    const fn new_typed<T>(
        kind: ParamKind,
        texts: [&'static str; 2],
        range: [f64; 2],
        default: &'static [f64],
        read: fn(&[f64]) -> T,
    ) -> TypedParam<T> {
        TypedParam { param: Param::new(kind, texts, range, default), read: ValueReader::Components(read) }
    }

    /// A whole number of 32 bits.
    pub(super) const fn int(
        label: &'static str,
        help: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> TypedParam<u32> {
        Param::new_typed(ParamKind::Int, [label, help], range, default, |v| v[0] as u32)
    }

    /// A whole number of either sign.
    pub(super) const fn signed_int(
        label: &'static str,
        help: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> TypedParam<i64> {
        Param::new_typed(ParamKind::Int, [label, help], range, default, |v| v[0] as i64)
    }

    /// A number without a unit.
    pub(super) const fn real(
        label: &'static str,
        help: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> TypedParam<f64> {
        Param::new_typed(ParamKind::Real, [label, help], range, default, |v| v[0])
    }

    /// A length.
    pub(super) const fn length(
        label: &'static str,
        help: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> TypedParam<f64> {
        Param::new_typed(ParamKind::Length, [label, help], range, default, |v| v[0])
    }

    /// An angle.
    pub(super) const fn angle(
        label: &'static str,
        help: &'static str,
        range: [f64; 2],
        default: &'static [f64],
    ) -> TypedParam<f64> {
        Param::new_typed(ParamKind::Angle, [label, help], range, default, |v| v[0])
    }

    /// A point.
    pub(super) const fn point(
        label: &'static str,
        help: &'static str,
        default: &'static [f64; 3],
    ) -> TypedParam<DVec3> {
        Param::new_typed(ParamKind::Point, [label, help], COORDINATE_RANGE, default, to_vector)
    }

    /// A direction, read as a unit vector; the z axis by default.
    pub(super) const fn direction(label: &'static str, help: &'static str) -> TypedParam<DVec3> {
        Param::new_typed(ParamKind::Direction, [label, help], COORDINATE_RANGE, &[0.0, 0.0, 1.0], |v| {
            unit_vector_and_length(v).0
        })
    }

    /// A plane; z = 0 by default.
    pub(super) const fn plane(label: &'static str, help: &'static str) -> TypedParam<PlaneValue> {
        Param::new_typed(ParamKind::Plane, [label, help], COORDINATE_RANGE, &[0.0, 0.0, 1.0, 0.0], |v| {
            let (normal, [largest, length]) = unit_vector_and_length(v);
            PlaneValue { normal, distance: v[3] / largest / length }
        })
    }

    /// A flag, off by default.
    pub(super) const fn flag(label: &'static str, help: &'static str) -> TypedParam<bool> {
        Param::new_typed(ParamKind::Bool, [label, help], [0.0, 1.0], &[0.0], |v| v[0] != 0.0)
    }

    /// A bound on the error of a result, relative to a size that the help names.
    pub(super) const fn relative_error(label: &'static str, help: &'static str) -> TypedParam<f64> {
        Param::real(label, help, [1e-9, 1.0], &[1e-4])
    }

    /// A choice, by default the first.
    pub(super) const fn choice<T: Copy>(label: &'static str, help: &'static str, choices: Choices<T>) -> TypedParam<T> {
        let range = [0.0, (choices.texts.len() - 1) as f64];
        let param = Param::new(ParamKind::Choice, [label, help], range, &[0.0]);
        let param = Param { choices: choices.texts, ..param };
        TypedParam { param, read: ValueReader::Choice(choices.values) }
    }
}

/// The first three components.
fn to_vector(components: &[f64]) -> DVec3 {
    DVec3::from_slice(&components[..3])
}

/// Returns a unit vector along the first three components, their largest magnitude, and their
/// length relative to it. Squares of tiny components would vanish.
fn unit_vector_and_length(components: &[f64]) -> (DVec3, [f64; 2]) {
    let given = to_vector(components);
    let largest = given.abs().max_element();
    let length = (given / largest).length();
    (given / largest / length, [largest, length])
}

impl<T: Copy> TypedParam<T> {
    /// The parameter with its id.
    pub(super) const fn with_id(&self, id: &'static str) -> Param {
        Param { id, ..self.param }
    }

    /// The parameter with another label, for filters that call it by another name.
    pub(super) const fn with_label(self, label: &'static str) -> Self {
        TypedParam { param: Param { label, ..self.param }, ..self }
    }

    /// The parameter with another help, for filters in which it means something else.
    pub(super) const fn with_help(self, help: &'static str) -> Self {
        TypedParam { param: Param { help, ..self.param }, ..self }
    }

    /// The value at the start of some components, which are moved past it.
    pub(super) fn take_value(&self, components: &mut &[f64]) -> T {
        let (own, rest) = components.split_at(self.param.kind.component_count());
        *components = rest;
        match self.read {
            ValueReader::Components(read) => read(own),
            ValueReader::Choice(values) => values[own[0] as usize],
        }
    }

    const fn with_suggestion(self, suggestion: Suggestion) -> Self {
        TypedParam { param: Param { suggestion: Some(suggestion), ..self.param }, ..self }
    }
}

impl TypedParam<f64> {
    /// The length with a default relative to the diagonal of the inputs' bounding box.
    pub(super) const fn with_size_ratio(self, ratio: f64) -> Self {
        self.with_suggestion(Suggestion::Ratio(ratio))
    }

    /// Sets a function that computes the default from the inputs and their bounding box. `None`
    /// keeps the plain default.
    pub(super) const fn suggested(self, number: fn(&[Input<'_>], &Aabb) -> Option<f64>) -> Self {
        self.with_suggestion(Suggestion::Number(number))
    }

    /// The number read as `None` if it is negative.
    pub(super) const fn none_if_negative(self) -> TypedParam<Option<f64>> {
        TypedParam { param: self.param, read: ValueReader::Components(|v| (v[0] >= 0.0).then_some(v[0])) }
    }

    /// The number read as `None` unless it is above 0.
    pub(super) const fn none_unless_positive(self) -> TypedParam<Option<f64>> {
        TypedParam { param: self.param, read: ValueReader::Components(|v| (v[0] > 0.0).then_some(v[0])) }
    }
}

impl TypedParam<u32> {
    /// Sets a function that computes the default from the inputs and their bounding box. `None`
    /// keeps the plain default.
    pub(super) const fn suggested(self, number: fn(&[Input<'_>], &Aabb) -> Option<f64>) -> Self {
        self.with_suggestion(Suggestion::Number(number))
    }

    /// The number read as `None` if it is negative.
    pub(super) const fn none_if_negative(self) -> TypedParam<Option<u32>> {
        TypedParam { param: self.param, read: ValueReader::Components(|v| (v[0] >= 0.0).then_some(v[0] as u32)) }
    }

    /// The number read as `None` if it is 0.
    pub(super) const fn none_unless_positive(self) -> TypedParam<Option<u32>> {
        TypedParam { param: self.param, read: ValueReader::Components(|v| (v[0] > 0.0).then_some(v[0] as u32)) }
    }
}

impl TypedParam<bool> {
    /// The flag, on by default.
    pub(super) const fn on_by_default(self) -> Self {
        TypedParam { param: Param { default: &[1.0], ..self.param }, ..self }
    }
}

impl TypedParam<DVec3> {
    /// Sets a function that computes the default point or direction from the inputs and their
    /// bounding box. `None` keeps the plain default.
    pub(super) const fn suggested(self, vector: fn(&[Input<'_>], &Aabb) -> Option<DVec3>) -> Self {
        self.with_suggestion(Suggestion::Vector(vector))
    }
}

impl TypedParam<PlaneValue> {
    /// Sets a function that computes the default plane from the inputs and their bounding box.
    /// `None` keeps the plain default.
    pub(super) const fn suggested(self, plane: fn(&[Input<'_>], &Aabb) -> Option<[f64; 4]>) -> Self {
        self.with_suggestion(Suggestion::Plane(plane))
    }
}

/// The request of one run: the values of the parameters, and whether to trace the elements of
/// results back to the elements of the inputs.
pub(super) struct ParamValues<P> {
    params: P,
    traced: bool,
}

impl<P: Parameters> ParamValues<P> {
    /// The values that some components give.
    pub(super) fn new(components: &[f64], traced: bool) -> Self {
        ParamValues { params: P::read(components), traced }
    }

    /// The origins of the elements of a result, if they are asked for.
    pub(super) fn trace_origins(&self, trace: impl FnOnce() -> Result<Origins>) -> Result<Option<Box<Origins>>> {
        self.traced.then(|| trace().map(Box::new)).transpose()
    }
}

impl<P> Deref for ParamValues<P> {
    type Target = P;

    fn deref(&self) -> &P {
        &self.params
    }
}
