//! Fields of deformation (paper, "Spatial operations"): the one description of shaping, animation and projection.
//!
//! * [`Field`]: a map of space that can be applied in part. * [`deform`]: chains of fields, applied in one pass.
//! * [`Twist`], [`Taper`], [`Bend`], [`Shear`]: shaping. * [`Spherify`], [`CylinderWrap`], [`TorusWrap`]: sheets onto surfaces.
//! * [`Lattice`]: free-form. * [`Projection`]: parallel, perspective, any 4 x 4. * [`displace`]: along the normals.
//! * [`Timed`]: the strength of a field as a function of time.
//!
//! A field maps each point by itself: nodes of equal bits, such as glued ones, keep equal bits.

mod lattice;
mod projection;
mod shaping;
mod surface;
mod timed;
mod wrap;

pub use lattice::Lattice;
pub use projection::Projection;
pub use shaping::{Bend, Shear, Taper, Twist};
pub use surface::{RowsMut, deform_rows, displace, snap};
pub use timed::{Easing, Timed};
pub use wrap::{CylinderWrap, Spherify, TorusWrap};

use super::pieces::{self, PIECE};
use super::transform::Affine;
use super::{Net, Planes, Real, each};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::simd::{self, Kernel};

/// Points to be moved: their x, y and z, slices of one length.
pub type Points<'a> = [&'a mut [f64]; 3];

/// A map of space.
pub trait Field: Sync {
    /// Moves the points. `strength` says how much of the map is done: 0 nothing, 1 all of it; what lies between, and
    /// beyond, is for each field to say. It is never called with 0. Each point is moved by itself, whatever the others
    /// are. A point that the field is not defined at becomes NaN.
    fn map(&self, strength: f64, points: Points<'_>);

    /// True if finite points stay finite, but for overflow.
    fn is_total(&self) -> bool {
        true
    }
}

/// One field of a chain.
#[derive(Clone, Copy)]
pub struct Step<'a> {
    /// The field.
    pub field: &'a dyn Field,
    /// How much of it is done; for fields that change with time see [`Timed::strength`].
    pub strength: f64,
}

/// Moves every node by each field in turn, in place, in one pass over the memory.
///
/// The fields work in double precision; the result is rounded to the net's type once. With strengths of 0 only, nothing
/// changes at all. Missing nodes stay missing. Whatever the error: no node is moved. If a field is not defined
/// everywhere, all is computed twice, first to see that it is defined at every node and that the result is finite in the
/// net's type; other chains are not checked, and nodes that overflow become infinite, which is missing. O(nodes x
/// fields), no memory that depends on the net.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a strength that is not finite, [`Error::FieldUndefined`], [`Error::Cancelled`].
pub fn deform(net: &mut Net<'_>, steps: &[Step<'_>], job: &Job<'_>) -> Result<()> {
    if let Some(step) = steps.iter().find(|step| !step.strength.is_finite()) {
        return Err(Error::OptionOutOfRange { option: "strength", value: step.strength });
    }
    job.step(0.0, "deform")?;
    each!(net.coordinates_mut(), planes => {
        if steps.iter().any(|step| step.strength != 0.0 && !step.field.is_total()) {
            pieces::scan(planes, job.threads(), |first, rows| check(steps, first, rows))?;
            job.step(0.5, "deform")?;
        }
        apply(planes, steps, job.threads())
    })
}

fn apply<T: Real>(planes: &mut Planes<'_, T>, steps: &[Step<'_>], threads: usize) -> Result<()> {
    if steps.iter().all(|step| step.strength == 0.0) {
        return Ok(());
    }
    pieces::change(planes, threads, PIECE, |_, rows| {
        let mut scratch = [[0.0; PIECE]; 3];
        let moved = mapped(steps, [&*rows[0], &*rows[1], &*rows[2]], &mut scratch);
        for (row, moved) in rows.into_iter().zip(moved) {
            row.iter_mut().zip(moved).for_each(|(to, &mut from)| *to = T::of(from));
        }
        Ok(())
    })
}

/// [`Error::FieldUndefined`] for the first node of the piece that is finite and does not stay so.
fn check<T: Real>(steps: &[Step<'_>], first: usize, rows: [&[T]; 3]) -> Result<()> {
    let mut scratch = [[0.0; PIECE]; 3];
    let [x, y, z] = mapped(steps, rows, &mut scratch);
    let undefined = (0..x.len()).find(|&k| {
        let is_finite = rows.iter().all(|row| row[k].into().is_finite());
        // As it will be stored: what is a number in double precision may overflow the net's type.
        is_finite && ![x[k], y[k], z[k]].into_iter().all(|value| T::of(value).into().is_finite())
    });
    undefined.map_or(Ok(()), |k| Err(Error::FieldUndefined { node: (first + k) as u32 }))
}

/// The nodes of a piece, in double precision, after all fields.
fn mapped<'a, T: Real>(steps: &[Step<'_>], rows: [&[T]; 3], scratch: &'a mut [[f64; PIECE]; 3]) -> Points<'a> {
    let count = rows[0].len();
    let [x, y, z] = scratch;
    let [x, y, z] = [&mut x[..count], &mut y[..count], &mut z[..count]];
    for (to, from) in [&mut *x, &mut *y, &mut *z].into_iter().zip(rows) {
        to.iter_mut().zip(from).for_each(|(to, &from)| *to = from.into());
    }
    for step in steps.iter().filter(|step| step.strength != 0.0) {
        step.field.map(step.strength, [&mut *x, &mut *y, &mut *z]);
    }
    [x, y, z]
}

/// Moves each point by itself: `map` is given its coordinates and returns the new ones. For maps that call functions,
/// which keep a loop from vectors anyhow.
fn each_point([x, y, z]: Points<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
    apply_to(x, y, z, map);
}

/// The same, for maps that are plain arithmetic.
fn each_point_widely([x, y, z]: Points<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
    simd::run(EachPoint { x, y, z, map });
}

struct EachPoint<'a, F> {
    x: &'a mut [f64],
    y: &'a mut [f64],
    z: &'a mut [f64],
    map: F,
}

impl<F: Fn([f64; 3]) -> [f64; 3]> Kernel for EachPoint<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        apply_to(self.x, self.y, self.z, self.map);
    }
}

/// A function of its own, as only arguments are known not to overlap.
#[inline(always)]
fn apply_to(x: &mut [f64], y: &mut [f64], z: &mut [f64], map: impl Fn([f64; 3]) -> [f64; 3]) {
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        [*x, *y, *z] = map([*x, *y, *z]);
    }
}

/// The straight way to where `map` takes a point, as far as `strength` says.
fn partly(strength: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> impl Fn([f64; 3]) -> [f64; 3] {
    move |from| {
        let to = map(from);
        // The whole way, without rounding once more.
        if strength == 1.0 { to } else { [0, 1, 2].map(|k| from[k] + strength * (to[k] - from[k])) }
    }
}

/// [`Error::OptionOutOfRange`] for the first of the parameters that is not finite.
fn finite(parameters: &[(&'static str, f64)]) -> Result<()> {
    match parameters.iter().find(|(_, value)| !value.is_finite()) {
        Some(&(option, value)) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}

/// In part: on the straight way.
impl Field for Affine {
    fn map(&self, strength: f64, points: Points<'_>) {
        let rows = self.rows();
        each_point_widely(points, partly(strength, |[x, y, z]| rows.map(|[a, b, c, d]| a * x + b * y + c * z + d)));
    }
}
