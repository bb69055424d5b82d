//! Coordinates of shapes, written row by row in double precision and rounded once. O(nodes).

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::{Coordinates, Net, Real, Topology, each};

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;

/// The net whose row i `row` writes to three buffers. Zeros are positive.
pub(super) fn rows(
    topology: Topology,
    scalar: Scalar,
    job: &Job<'_>,
    mut row: impl FnMut(usize, [&mut [f64]; 3]),
) -> Result<Net<'static>> {
    let shape = topology.shape();
    let mut coordinates = Coordinates::zeroed(shape, scalar)?;
    let mut buffer: Vec<f64> = alloc::zeroed(3 * shape.columns())?;
    let often = (NODES_PER_REPORT / shape.columns()).max(1);
    for i in 0..shape.rows() {
        job.step_every(often, i, shape.rows(), "primitive")?;
        let (x, yz) = buffer.split_at_mut(shape.columns());
        let (y, z) = yz.split_at_mut(shape.columns());
        row(i, [x, y, z]);
        each!(&mut coordinates, planes => copy(&buffer, planes.row_mut(i)));
    }
    Ok(Net::new(coordinates, topology))
}

/// The net whose nodes `node` gives.
pub(super) fn nodes(
    topology: Topology,
    scalar: Scalar,
    job: &Job<'_>,
    node: impl Fn(usize, usize) -> [f64; 3],
) -> Result<Net<'static>> {
    rows(topology, scalar, job, |i, [x, y, z]| {
        for (j, ((x, y), z)) in x.iter_mut().zip(y).zip(z).enumerate() {
            [*x, *y, *z] = node(i, j);
        }
    })
}

fn copy<T: Real>(buffer: &[f64], row: [&mut [T]; 3]) {
    let columns = row[0].len();
    for (to, from) in row.into_iter().zip(buffer.chunks_exact(columns)) {
        // Adding 0 makes negative zeros positive, those that rounding makes included.
        to.iter_mut().zip(from).for_each(|(to, &value)| *to = T::of(value) + T::of(0.0));
    }
}
