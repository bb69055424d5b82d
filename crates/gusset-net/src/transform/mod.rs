//! Spatial operations (Deryagin, "All spatial operations on tetragonal regular networks come down
//! to transforms of the space"): translations, rotations, scalings, compressions, all other affine
//! maps.
//!
//! Operations are composed into one matrix, which is applied to all nodes in place, in one pass.
//! Invariant: each node is computed independently, so that glued nodes of equal bits keep equal
//! bits. O(nodes), bound by memory.

mod affine;

pub(crate) use affine::is_orientation_reversing;
pub use affine::{Affine, Axis, RotationSense};

use super::chunks;
use super::{Net, Real, XyzMatrices, each};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::simd::{self, Kernel};

/// Moves every node, in place, in the arithmetic of the net's type.
///
/// A mirroring map (negative determinant) turns the surface inside out. The topology's
/// [`is_reversed`](super::Topology::is_reversed) then changes, so that faces still look outwards.
/// Missing nodes stay missing. The host can cancel before the first node moves, so that all nodes
/// move or none. O(nodes), without extra memory.
///
/// # Errors
/// [`Error::FieldUndefined`] for the first node whose coordinates would overflow; no node moves.
/// Coordinates beyond the square root of the largest number of their type, 1e19 and 1e154, may
/// overflow under harmless maps and then become missing. [`Error::Cancelled`].
pub fn transform(net: &mut Net<'_>, affine: &Affine, job: &Job<'_>) -> Result<()> {
    job.step(0.0, "transform")?;
    each!(net.coordinates_mut(), planes => {
        check_overflow(planes, affine, job.requested_threads())?;
        apply_affine(planes, affine, job.requested_threads())?;
    });
    if affine.is_mirroring() {
        let reversed = net.topology().is_reversed();
        let topology = net.topology().clone().with_reversed(!reversed);
        net.set_topology(topology);
    }
    Ok(())
}

/// Returns [`Error::FieldUndefined`] for the first node that overflows. Checks nodes only if the
/// map is so large that nodes of common size may overflow.
fn check_overflow<T: Real>(planes: &mut XyzMatrices<'_, T>, affine: &Affine, threads: usize) -> Result<()> {
    let bound = |[a, b, c, d]: [f64; 4]| (a.abs() + b.abs() + c.abs()) * T::MAX.sqrt() + d.abs();
    if affine.rows().into_iter().all(|row| bound(row) <= T::MAX) {
        return Ok(());
    }
    let rows = affine.rows().map(|row| row.map(T::from_f64));
    chunks::for_each_chunk_mut(planes, threads, chunks::MAX_NODES_PER_CHUNK, |first, [x, y, z]| {
        let overflows = |k: usize| {
            let node = [x[k], y[k], z[k]];
            let moved = rows.map(|[a, b, c, d]| a * node[0] + b * node[1] + c * node[2] + d);
            let finite = |numbers: [T; 3]| numbers.into_iter().all(|x| x.into().is_finite());
            finite(node) && !finite(moved)
        };
        let first_lost = (0..x.len()).find(|&k| overflows(k));
        first_lost.map_or(Ok(()), |k| Err(Error::FieldUndefined { node: (first + k) as u32 }))
    })
}

fn apply_affine<T: Real>(planes: &mut XyzMatrices<'_, T>, affine: &Affine, threads: usize) -> Result<()> {
    let rows = affine.rows().map(|row| row.map(T::from_f64));
    chunks::for_each_chunk_mut(planes, threads, chunks::NODES_PER_BLOCK, |_, [x, y, z]| {
        simd::run(ApplyAffine { rows, x, y, z });
        Ok(())
    })
}

struct ApplyAffine<'a, T> {
    rows: [[T; 4]; 3],
    x: &'a mut [T],
    y: &'a mut [T],
    z: &'a mut [T],
}

impl<T: Real> Kernel for ApplyAffine<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        apply_matrix_to_nodes(self.rows, self.x, self.y, self.z);
    }
}

#[inline(always)]
fn apply_matrix_to_nodes<T: Real>(rows: [[T; 4]; 3], x: &mut [T], y: &mut [T], z: &mut [T]) {
    // Whole runs. The remainder is processed elsewhere, because its loop would hold the matrix in
    // registers that the vectors need.
    let [(x, x_rest), (y, y_rest), (z, z_rest)] = [x, y, z].map(<[T]>::as_chunks_mut);
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        apply_matrix_to_run(rows, x, y, z);
    }
    apply_matrix_to_remainder(rows, x_rest, y_rest, z_rest);
}

/// Nodes of a vectorised run.
const NODES_PER_RUN: usize = 16;

#[inline(always)]
fn apply_matrix_to_run<T: Real>(
    rows: [[T; 4]; 3],
    x: &mut [T; NODES_PER_RUN],
    y: &mut [T; NODES_PER_RUN],
    z: &mut [T; NODES_PER_RUN],
) {
    // Separate results, which cannot alias the operands.
    let mut moved = [[T::from_f64(0.0); NODES_PER_RUN]; 3];
    let [new_x, new_y, new_z] = &mut moved;
    for k in 0..NODES_PER_RUN {
        new_x[k] = rows[0][0] * x[k] + rows[0][1] * y[k] + rows[0][2] * z[k] + rows[0][3];
        new_y[k] = rows[1][0] * x[k] + rows[1][1] * y[k] + rows[1][2] * z[k] + rows[1][3];
        new_z[k] = rows[2][0] * x[k] + rows[2][1] * y[k] + rows[2][2] * z[k] + rows[2][3];
    }
    [*x, *y, *z] = moved;
}

#[inline(never)]
fn apply_matrix_to_remainder<T: Real>(rows: [[T; 4]; 3], x: &mut [T], y: &mut [T], z: &mut [T]) {
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        [*x, *y, *z] = rows.map(|[p, q, r, s]| p * *x + q * *y + r * *z + s);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_equal_for_any_vector_width() {
        // Longer than runs, with a rest.
        let numbers = |k: usize| (0..3 * NODES_PER_RUN + 5).map(|n| ((n * k) as f32).sin()).collect::<Vec<f32>>();
        let rows = [[0.3, -0.7, 0.1, 1e-3], [0.9, 0.2, -0.4, 7.0], [-0.1, 0.6, 0.8, -2.5]];
        let [wide, narrow] = [true, false].map(|wide| {
            let [mut x, mut y, mut z] = [3, 5, 7].map(numbers);
            let kernel = ApplyAffine { rows, x: &mut x, y: &mut y, z: &mut z };
            if wide {
                simd::run(kernel);
            } else {
                kernel.run();
            }
            [x, y, z].concat().into_iter().map(f32::to_bits).collect::<Vec<u32>>()
        });
        assert_eq!(wide, narrow);
    }
}
