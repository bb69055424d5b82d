//! Chains of fields applied to a net in one pass. O(nodes x fields).

use super::space_map::{Field, PointsMut};
use crate::chunks::{self, MAX_NODES_PER_CHUNK};
use crate::{Net, Real, XyzMatrices, each};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// One field of a chain.
#[derive(Clone, Copy)]
pub struct DeformationStep<'a> {
    /// The field.
    pub field: &'a dyn Field,
    /// The strength at which the field is applied, 1 for the whole field. For fields that change
    /// with time see `Timed::strength`.
    pub strength: f64,
}

/// Moves every node by each field in order, in place, in one pass over the memory.
///
/// Fields work in double precision; the result is rounded once to the net's type. Steps of strength
/// 0 change nothing. Missing nodes stay missing. If a field is partial, a first pass checks that
/// the chain is defined at every node and finite in the net's type, and on an error no node moves.
/// Other chains are not checked, and nodes that overflow become missing. O(nodes x fields), with
/// constant extra memory.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a strength that is not finite, [`Error::FieldUndefined`],
/// [`Error::Cancelled`].
pub fn deform(net: &mut Net<'_>, steps: &[DeformationStep<'_>], job: &Job<'_>) -> Result<()> {
    steps.iter().try_for_each(|step| Error::require(step.strength.is_finite(), "strength", step.strength, "finite"))?;
    job.step(0.0, "deform")?;
    each!(net.coordinates_mut(), planes => {
        if steps.iter().any(|step| step.strength != 0.0 && !step.field.is_defined_everywhere()) {
            chunks::for_each_chunk_mut(planes, job.requested_threads(), MAX_NODES_PER_CHUNK, |first, rows| check_images_finite(steps, first, &rows))?;
            job.step(0.5, "deform")?;
        }
        apply_steps(planes, steps, job.requested_threads())
    })
}

fn apply_steps<T: Real>(planes: &mut XyzMatrices<'_, T>, steps: &[DeformationStep<'_>], threads: usize) -> Result<()> {
    if steps.iter().all(|step| step.strength == 0.0) {
        return Ok(());
    }
    chunks::for_each_chunk_mut(planes, threads, MAX_NODES_PER_CHUNK, |_, rows| {
        let mut scratch = [[0.0; MAX_NODES_PER_CHUNK]; 3];
        let moved = map_nodes(steps, &rows, &mut scratch);
        for (row, moved) in rows.into_iter().zip(moved) {
            row.iter_mut().zip(moved).for_each(|(to, &mut from)| *to = T::from_f64(from));
        }
        Ok(())
    })
}

/// Returns [`Error::FieldUndefined`] for the first finite node of a chunk whose image is not
/// finite.
fn check_images_finite<T: Real>(steps: &[DeformationStep<'_>], first: usize, rows: &[&mut [T]; 3]) -> Result<()> {
    let mut scratch = [[0.0; MAX_NODES_PER_CHUNK]; 3];
    let [x, y, z] = map_nodes(steps, rows, &mut scratch);
    let undefined = (0..x.len()).find(|&k| {
        let is_finite = rows.iter().all(|row| row[k].into().is_finite());
        // Compares the stored value, because a finite double may overflow the net's type.
        is_finite && ![x[k], y[k], z[k]].into_iter().all(|value| T::from_f64(value).into().is_finite())
    });
    undefined.map_or(Ok(()), |k| Err(Error::FieldUndefined { node: (first + k) as u32 }))
}

/// Returns the nodes of a chunk, in double precision, after all fields.
fn map_nodes<'a, T: Real>(
    steps: &[DeformationStep<'_>],
    rows: &[&mut [T]; 3],
    scratch: &'a mut [[f64; MAX_NODES_PER_CHUNK]; 3],
) -> PointsMut<'a> {
    let count = rows[0].len();
    let [x, y, z] = scratch;
    let [x, y, z] = [&mut x[..count], &mut y[..count], &mut z[..count]];
    for (to, from) in [&mut *x, &mut *y, &mut *z].into_iter().zip(rows) {
        to.iter_mut().zip(from.iter()).for_each(|(to, &from)| *to = from.into());
    }
    for step in steps.iter().filter(|step| step.strength != 0.0) {
        step.field.map_points(step.strength, [&mut *x, &mut *y, &mut *z]);
    }
    [x, y, z]
}
