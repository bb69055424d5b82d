//! Coordinates of joined nets, bit for bit. O(nodes), bound by memory.

use crate::arrange::build_matrices;
use crate::reformat::prefix_sums;
use crate::{Coordinates, Direction, Net, Real, Shape, XyzMatrices};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::ops::Range;

/// Returns the matrices of all nets side by side, bit for bit, with `inner` rows or columns of
/// zeros between.
pub(super) fn join_matrices(
    nets: &[&Net<'_>],
    (direction, inner): (Direction, u32),
    shape: Shape,
    job: &Job<'_>,
) -> Result<Coordinates<'static>> {
    macro_rules! joined {
        ($kind:ident) => {{
            let mut parts = alloc::with_capacity(nets.len())?;
            for net in nets {
                match net.coordinates() {
                    Coordinates::$kind(planes) => parts.push(planes),
                    _ => return Err(Error::MixedScalars),
                }
            }
            Coordinates::$kind(place_side_by_side(&parts, (direction, inner), shape, job)?)
        }};
    }
    Ok(match nets[0].coordinates() {
        Coordinates::F32(_) => joined!(F32),
        Coordinates::F64(_) => joined!(F64),
    })
}

fn place_side_by_side<T: Real>(
    parts: &[&XyzMatrices<'_, T>],
    (direction, inner): (Direction, u32),
    shape: Shape,
    job: &Job<'_>,
) -> Result<XyzMatrices<'static, T>> {
    let starts = first_lines_of_nets(parts.iter().map(|part| part.shape()), direction, inner)?;
    let columns = shape.columns();
    match direction {
        Direction::Down => {
            build_matrices(shape, job, |axis, rows, to| copy_rows_of_nets(parts, &starts, axis, rows, columns, to))
        }
        Direction::Right => build_matrices(shape, job, |axis, rows, to| {
            for (part, &start) in parts.iter().zip(&starts) {
                let (from, stride, width) = (part.matrices()[axis], part.stride(), part.shape().columns());
                for (i, to) in rows.clone().zip(to.chunks_exact_mut(columns)) {
                    to[start..start + width].copy_from_slice(&from[i * stride..][..width]);
                }
            }
        }),
    }
}

/// Returns the start of each net in a direction, if `inner` rows or columns follow each; one entry
/// more than there are nets.
pub(crate) fn first_lines_of_nets(
    shapes: impl ExactSizeIterator<Item = Shape>,
    direction: Direction,
    inner: u32,
) -> Result<Vec<usize>> {
    prefix_sums(shapes.map(|shape| direction.line_count_and_length(shape).0 + inner as usize))
}

/// Fills rows from the nets that lie one below the other.
fn copy_rows_of_nets<T: Real>(
    parts: &[&XyzMatrices<'_, T>],
    starts: &[usize],
    axis: usize,
    rows: Range<usize>,
    columns: usize,
    to: &mut [T],
) {
    let mut part = starts.partition_point(|&start| start <= rows.start) - 1;
    let (mut i, mut to) = (rows.start, to);
    while i < rows.end {
        let (from, stride) = (parts[part].matrices()[axis], parts[part].stride());
        let end = rows.end.min(starts[part + 1]);
        let (here, rest) = to.split_at_mut((end - i) * columns);
        let first = i - starts[part];
        let own = parts[part].shape().rows().saturating_sub(first).min(end - i);
        let here = &mut here[..own * columns];
        if own == 0 {
            // Rows between two nets; a range may begin anywhere in them.
        } else if stride == columns {
            here.copy_from_slice(&from[first * columns..][..here.len()]);
        } else {
            for (i, to) in (first..).zip(here.chunks_exact_mut(columns)) {
                to.copy_from_slice(&from[i * stride..][..columns]);
            }
        }
        (i, part, to) = (end, part + 1, rest);
    }
}
