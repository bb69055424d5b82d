//! Coordinates of nets that are joined.

use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::arrange::planes;
use crate::net::{Coordinates, Direction, Net, Planes, Real, Shape};
use std::ops::Range;

/// The matrices of all nets side by side, bit for bit.
pub(super) fn joined(
    nets: &[&Net<'_>],
    direction: Direction,
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
            Coordinates::$kind(beside(&parts, direction, shape, job)?)
        }};
    }
    Ok(match nets[0].coordinates() {
        Coordinates::F32(_) => joined!(F32),
        Coordinates::F64(_) => joined!(F64),
    })
}

fn beside<T: Real>(
    parts: &[&Planes<'_, T>],
    direction: Direction,
    shape: Shape,
    job: &Job<'_>,
) -> Result<Planes<'static, T>> {
    let mut starts = alloc::with_capacity(parts.len() + 1)?;
    starts.push(0);
    for part in parts {
        starts.push(starts[starts.len() - 1] + direction.extent(part.shape()).0);
    }
    let columns = shape.columns();
    match direction {
        Direction::Down => planes(shape, job, |axis, rows, to| below(parts, &starts, axis, rows, columns, to)),
        Direction::Right => planes(shape, job, |axis, rows, to| {
            for (part, &start) in parts.iter().zip(&starts) {
                let (from, stride, width) = (part.matrices()[axis], part.stride(), part.shape().columns());
                for (i, to) in rows.clone().zip(to.chunks_exact_mut(columns)) {
                    to[start..start + width].copy_from_slice(&from[i * stride..][..width]);
                }
            }
        }),
    }
}

/// Fills rows with those of the nets that lie there.
fn below<T: Real>(
    parts: &[&Planes<'_, T>],
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
        if stride == columns {
            here.copy_from_slice(&from[first * columns..][..here.len()]);
        } else {
            for (i, to) in (first..).zip(here.chunks_exact_mut(columns)) {
                to.copy_from_slice(&from[i * stride..][..columns]);
            }
        }
        (i, part, to) = (end, part + 1, rest);
    }
}
