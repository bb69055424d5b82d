//! Spatial operations (paper, "All spatial operations on tetragonal regular networks come down to transforms of the space"):
//! translations, rotations, scalings, compressions, and every other affine map.
//!
//! Operations are composed to one matrix, which is applied to all nodes in place, in one pass. Each node is computed by itself,
//! so that glued nodes of equal bits keep equal bits.

mod affine;

pub use affine::{Affine, Axis, Sense};

use super::pieces;
use super::{Net, Planes, Real, each};
use crate::error::Result;
use crate::job::Job;
use crate::simd::{self, Kernel};

/// Moves every node, in place, in the arithmetic of the net's type.
///
/// A map that mirrors (negative determinant) turns the surface inside out; the topology's
/// [`is_reversed`](super::Topology::is_reversed) changes then, so that faces look outwards as before. Missing nodes stay
/// missing. A cancel is heard before the first node is moved, not later: all nodes are moved, or none. O(nodes), no memory.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled).
pub fn transform(net: &mut Net<'_>, affine: &Affine, job: &Job<'_>) -> Result<()> {
    job.step(0.0, "transform")?;
    each!(net.coordinates_mut(), planes => apply(planes, affine, job.threads())?);
    if affine.determinant() < 0.0 {
        let reversed = net.topology().is_reversed();
        let topology = net.topology().clone().with_reversed(!reversed);
        net.set_topology(topology);
    }
    Ok(())
}

fn apply<T: Real>(planes: &mut Planes<'_, T>, affine: &Affine, threads: usize) -> Result<()> {
    let rows = affine.rows().map(|row| row.map(T::of));
    pieces::change(planes, threads, pieces::BLOCK, |_, [x, y, z]| {
        simd::run(Apply { rows, x, y, z });
        Ok(())
    })
}

struct Apply<'a, T> {
    rows: [[T; 4]; 3],
    x: &'a mut [T],
    y: &'a mut [T],
    z: &'a mut [T],
}

impl<T: Real> Kernel for Apply<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        apply_to(self.rows, self.x, self.y, self.z);
    }
}

/// A function of its own, as only arguments are known not to overlap.
#[inline(always)]
fn apply_to<T: Real>(rows: [[T; 4]; 3], x: &mut [T], y: &mut [T], z: &mut [T]) {
    // Whole runs, and the rest elsewhere: a loop for the rest would keep the matrix in registers that the vectors need.
    let ((x, x_rest), (y, y_rest), (z, z_rest)) = (x.as_chunks_mut(), y.as_chunks_mut(), z.as_chunks_mut());
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        apply_to_run(&rows, x, y, z);
    }
    rest(&rows, x_rest, y_rest, z_rest);
}

#[inline(always)]
fn apply_to_run<T: Real>(rows: &[[T; 4]; 3], x: &mut [T; RUN], y: &mut [T; RUN], z: &mut [T; RUN]) {
    for k in 0..RUN {
        let [a, b, c] = rows.map(|[p, q, r, s]| p * x[k] + q * y[k] + r * z[k] + s);
        x[k] = a;
        y[k] = b;
        z[k] = c;
    }
}

#[inline(never)]
fn rest<T: Real>(rows: &[[T; 4]; 3], x: &mut [T], y: &mut [T], z: &mut [T]) {
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        let [a, b, c] = rows.map(|[p, q, r, s]| p * *x + q * *y + r * *z + s);
        (*x, *y, *z) = (a, b, c);
    }
}

/// So many nodes are a run.
const RUN: usize = 16;
