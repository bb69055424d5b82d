//! Deformation fields (Deryagin, "Spatial operations"): one description of shaping, animation and
//! projection.
//!
//! * [`Field`]: a map of space that can be applied in part. [`deform`]: chains of fields in one
//!   pass.
//! * [`Twist`], [`Taper`], [`Bend`], [`Shear`]: shaping. [`Spherify`], [`CylinderWrap`],
//!   [`TorusWrap`]: sheets onto surfaces.
//! * [`Lattice`]: free-form. [`Projection`]: parallel, perspective, any 4 x 4 matrix. [`displace`]:
//!   along the normals.
//! * [`Timed`]: the strength of a field as a function of time.
//!
//! Invariant: a field maps each point independently, so that nodes of equal bits, such as glued
//! ones, keep equal bits. O(nodes x fields).

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

use super::chunks::{self, CHUNK};
use super::transform::Affine;
use super::{Net, Planes, Real, each};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::simd::{self, Kernel};

/// Points to move: their x, y and z, slices of equal length.
pub type Points<'a> = [&'a mut [f64]; 3];

/// A map of space.
pub trait Field: Sync {
    /// Moves each point independently. `strength`: 1 applies the whole map; values between 0 and 1,
    /// and beyond, are defined by each field; never 0. A point outside the field's domain becomes
    /// NaN.
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
    /// The part of it that is applied; for fields that change with time see [`Timed::strength`].
    pub strength: f64,
}

/// Moves every node by each field in order, in place, in one pass over the memory.
///
/// Fields work in double precision; the result is rounded once to the net's type. Steps of strength
/// 0 change nothing. Missing nodes stay missing. On an error no node is moved: if a field is
/// partial, a first pass checks that the chain is defined at every node and finite in the net's
/// type. Other chains are not checked, and nodes that overflow become missing. O(nodes x fields),
/// no memory that depends on the net.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a strength that is not finite, [`Error::FieldUndefined`],
/// [`Error::Cancelled`].
pub fn deform(net: &mut Net<'_>, steps: &[Step<'_>], job: &Job<'_>) -> Result<()> {
    if let Some(step) = steps.iter().find(|step| !step.strength.is_finite()) {
        return Err(Error::OptionOutOfRange { option: "strength", value: step.strength });
    }
    job.step(0.0, "deform")?;
    each!(net.coordinates_mut(), planes => {
        if steps.iter().any(|step| step.strength != 0.0 && !step.field.is_total()) {
            chunks::for_each_chunk(planes, job.threads(), |first, rows| check(steps, first, rows))?;
            job.step(0.5, "deform")?;
        }
        apply(planes, steps, job.threads())
    })
}

fn apply<T: Real>(planes: &mut Planes<'_, T>, steps: &[Step<'_>], threads: usize) -> Result<()> {
    if steps.iter().all(|step| step.strength == 0.0) {
        return Ok(());
    }
    chunks::for_each_chunk_mut(planes, threads, CHUNK, |_, rows| {
        let mut scratch = [[0.0; CHUNK]; 3];
        let moved = mapped(steps, [&*rows[0], &*rows[1], &*rows[2]], &mut scratch);
        for (row, moved) in rows.into_iter().zip(moved) {
            row.iter_mut().zip(moved).for_each(|(to, &mut from)| *to = T::of(from));
        }
        Ok(())
    })
}

/// [`Error::FieldUndefined`] for the first finite node of a chunk whose image is not finite.
fn check<T: Real>(steps: &[Step<'_>], first: usize, rows: [&[T]; 3]) -> Result<()> {
    let mut scratch = [[0.0; CHUNK]; 3];
    let [x, y, z] = mapped(steps, rows, &mut scratch);
    let undefined = (0..x.len()).find(|&k| {
        let is_finite = rows.iter().all(|row| row[k].into().is_finite());
        // As stored: a finite double may overflow the net's type.
        is_finite && ![x[k], y[k], z[k]].into_iter().all(|value| T::of(value).into().is_finite())
    });
    undefined.map_or(Ok(()), |k| Err(Error::FieldUndefined { node: (first + k) as u32 }))
}

/// The nodes of a chunk, in double precision, after all fields.
fn mapped<'a, T: Real>(steps: &[Step<'_>], rows: [&[T]; 3], scratch: &'a mut [[f64; CHUNK]; 3]) -> Points<'a> {
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

/// Applies `map` to each point, for maps that call functions and so do not vectorise.
fn each_point([x, y, z]: Points<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
    apply_to(x, y, z, map);
}

/// Applies `map` to each point, for maps of plain arithmetic, which vectorise.
fn each_point_simd([x, y, z]: Points<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
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

/// A separate function, as only arguments are known not to alias.
#[inline(always)]
fn apply_to(x: &mut [f64], y: &mut [f64], z: &mut [f64], map: impl Fn([f64; 3]) -> [f64; 3]) {
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        [*x, *y, *z] = map([*x, *y, *z]);
    }
}

/// The point at parameter `strength` on the line from a point to its image.
fn along_line(strength: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> impl Fn([f64; 3]) -> [f64; 3] {
    move |from| {
        let to = map(from);
        // At 1, without further rounding.
        if strength == 1.0 { to } else { [0, 1, 2].map(|k| from[k] + strength * (to[k] - from[k])) }
    }
}

/// [`Error::OptionOutOfRange`] for the first parameter that is not finite.
fn check_finite(parameters: &[(&'static str, f64)]) -> Result<()> {
    match parameters.iter().find(|(_, value)| !value.is_finite()) {
        Some(&(option, value)) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}

/// In part: along the line to the image.
impl Field for Affine {
    fn map(&self, strength: f64, points: Points<'_>) {
        let rows = self.rows();
        each_point_simd(points, along_line(strength, |[x, y, z]| rows.map(|[a, b, c, d]| a * x + b * y + c * z + d)));
    }
}
