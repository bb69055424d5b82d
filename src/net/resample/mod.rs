//! Nets of other sizes: resampled, halved again and again, or without the rows and columns that matter least.
//!
//! All of this is for nets that are glued along whole sides (see [`Sides`]): the sides of the result are glued in the
//! same way, and glued nodes have equal bits.

mod decimate;
mod pyramid;

pub use decimate::{Decimated, decimate};
pub use pyramid::pyramid;

use super::field::snap;
use super::{Coordinates, Net, Planes, Real, Shape, Sides, Topology};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::par;

/// About so many nodes are one thread's work at a time.
const BLOCK: usize = 1 << 14;

/// How positions between nodes are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Interpolation {
    /// On the bilinear patches of the cells.
    Bilinear,
    /// On cubic splines after Catmull and Rom along rows and columns, which pass through all nodes with one tangent.
    /// Where a row or column is closed they go on across the seam.
    #[default]
    Bicubic,
}

/// A net of another size, whose nodes are spread evenly over the rows and columns of this one. First and last ones
/// stay.
///
/// Nodes that fall on nodes have their bits. Missing nodes make missing those that they have a part in. O(nodes of
/// both).
///
/// # Errors
/// [`Error::GluedInside`], [`Error::NetTooSmall`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn resample(
    net: &Net<'_>,
    rows: usize,
    columns: usize,
    interpolation: Interpolation,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let (sides, shape) = (sides(net)?, Shape::new(rows, columns)?);
    let along = Taps::new(net.shape().columns(), columns, sides.rows_closed, interpolation)?;
    let across = Taps::new(net.shape().rows(), rows, sides.columns_closed, interpolation)?;
    let coordinates = match net.coordinates() {
        Coordinates::F32(planes) => Coordinates::F32(interpolated(planes, shape, &along, &across, job)?),
        Coordinates::F64(planes) => Coordinates::F64(interpolated(planes, shape, &along, &across, job)?),
    };
    with_sides(coordinates, net, sides)
}

/// The sides of a net that is glued along them alone and has no bridges; else [`Error::GluedInside`].
fn sides(net: &Net<'_>) -> Result<Sides> {
    let alone = net.topology().seams().is_empty() && net.bridges().is_empty();
    net.topology().sides().filter(|_| alone).ok_or(Error::GluedInside)
}

/// The fewest rows and columns for the surface to stay what it is, if closed ones keep `closed` nodes: a face between two
/// poles must not become an edge, or the same face twice.
fn least(sides: Sides, closed: usize) -> [usize; 2] {
    let fewest = |is_closed: bool, poles: [bool; 2], across: [bool; 2]| match (poles, across) {
        _ if is_closed => closed,
        ([true, true], [false, false]) => 3,
        ([true, true], _) => 4,
        ([true, _] | [_, true], [true, _] | [_, true]) => 3,
        _ => 2,
    };
    let (rows, columns) = ([sides.pole_top, sides.pole_bottom], [sides.pole_left, sides.pole_right]);
    [fewest(sides.columns_closed, rows, columns), fewest(sides.rows_closed, columns, rows)]
}

/// A net glued as the given one, its glued nodes made equal.
fn with_sides(coordinates: Coordinates<'static>, like: &Net<'_>, sides: Sides) -> Result<Net<'static>> {
    let topology = Topology::of_sides(coordinates.shape(), sides).with_reversed(like.topology().is_reversed());
    let mut net = Net::new(coordinates, topology);
    snap(&mut net)?;
    Ok(net)
}

/// The nodes of chosen rows and columns, bit for bit.
fn selected(net: &Net<'_>, rows: &[usize], columns: &[usize]) -> Result<Coordinates<'static>> {
    fn planes<T: Real>(from: &Planes<'_, T>, rows: &[usize], columns: &[usize]) -> Result<Planes<'static, T>> {
        let mut to = Planes::zeroed(Shape::new(rows.len(), columns.len())?)?;
        for (i, &row) in rows.iter().enumerate() {
            for (to, from) in to.row_mut(i).into_iter().zip(from.row(row)) {
                to.iter_mut().zip(columns).for_each(|(to, &j)| *to = from[j]);
            }
        }
        Ok(to)
    }
    Ok(match net.coordinates() {
        Coordinates::F32(from) => Coordinates::F32(planes(from, rows, columns)?),
        Coordinates::F64(from) => Coordinates::F64(planes(from, rows, columns)?),
    })
}

/// The nodes that a new node is made of, along one direction, and their weights.
#[derive(Clone, Copy)]
struct Tap {
    nodes: [u32; 4],
    weights: [f64; 4],
}

struct Taps(Vec<Tap>);

impl Taps {
    /// For `new` nodes spread evenly over `old` ones.
    fn new(old: usize, new: usize, closed: bool, interpolation: Interpolation) -> Result<Self> {
        let taps = (0..new).map(|k| {
            // k (old - 1) / (new - 1), exactly.
            let (at, steps) = (k as u64 * (old as u64 - 1), new as u64 - 1);
            let before = ((at / steps) as usize).min(old - 2);
            let t = (at - before as u64 * steps) as f64 / steps as f64;
            match interpolation {
                Interpolation::Bilinear => Tap::new([before; 4], before + 1, [0.0, 1.0 - t, t, 0.0]),
                Interpolation::Bicubic => Tap::cubic(before, old, closed, t),
            }
        });
        Ok(Taps(crate::alloc::collect(taps)?))
    }
}

impl Tap {
    fn new([first, second, _, last]: [usize; 4], third: usize, weights: [f64; 4]) -> Self {
        Tap { nodes: [first as u32, second as u32, third as u32, last as u32], weights }
    }

    /// The spline of Catmull and Rom between nodes `k` and `k + 1` of `count`. Beyond an open end the polygon goes on
    /// straight: the missing node is twice the last less the one before.
    fn cubic(k: usize, count: usize, closed: bool, t: f64) -> Self {
        let (s, square) = (1.0 - t, t * t);
        let mut weights =
            [-0.5 * t * s * s, 1.0 + square * (1.5 * t - 2.5), 1.0 + s * s * (1.5 * s - 2.5), -0.5 * s * square];
        // The last node of a closed row is its first again.
        let (mut before, mut after) = (k.wrapping_sub(1), k + 2);
        if k == 0 {
            before = if closed { count - 2 } else { 0 };
            if !closed {
                let w = std::mem::take(&mut weights[0]);
                (weights[1], weights[2]) = (weights[1] + 2.0 * w, weights[2] - w);
            }
        }
        if k + 2 == count {
            after = if closed { 1 } else { count - 1 };
            if !closed {
                let w = std::mem::take(&mut weights[3]);
                (weights[1], weights[2]) = (weights[1] - w, weights[2] + 2.0 * w);
            }
        }
        Tap::new([before, k, k, after], k + 1, weights)
    }

    /// The number of the node that this is, if its weight is all.
    fn single(&self) -> Option<usize> {
        (0..4)
            .find(|&k| self.weights[k] == 1.0 && self.weights.iter().filter(|&&w| w != 0.0).count() == 1)
            .map(|k| self.nodes[k] as usize)
    }

    /// Nodes without weight are left out, lest missing ones spread.
    fn apply(&self, value: impl Fn(usize) -> f64) -> f64 {
        let parts = self.nodes.iter().zip(self.weights).filter(|&(_, weight)| weight != 0.0);
        parts.map(|(&node, weight)| weight * value(node as usize)).sum()
    }
}

/// First across, a row at a time, then along the row.
fn interpolated<T: Real>(
    from: &Planes<'_, T>,
    shape: Shape,
    along: &Taps,
    across: &Taps,
    job: &Job<'_>,
) -> Result<Planes<'static, T>> {
    let mut to = Planes::zeroed(shape)?;
    let lines = (BLOCK / shape.columns()).max(1);
    let [x, y, z] = to.matrices_mut().map(|matrix| matrix.chunks_mut(lines * shape.columns()));
    let results = par::map_cancellable(job, "resample", x.zip(y).zip(z).enumerate(), |(block, ((x, y), z))| {
        let mut line = crate::alloc::filled(0.0, from.shape().columns())?;
        for (axis, matrix) in [x, y, z].into_iter().enumerate() {
            for (k, row) in matrix.chunks_mut(shape.columns()).enumerate() {
                across.0[block * lines + k].blend_rows(from, axis, &mut line);
                row.iter_mut().zip(&along.0).for_each(|(to, tap)| *to = T::of(tap.along(&line)));
            }
        }
        Ok(())
    })?;
    results.into_iter().collect::<Result<()>>()?;
    Ok(to)
}

impl Tap {
    /// The rows that this tap names, blended.
    fn blend_rows<T: Real>(&self, from: &Planes<'_, T>, axis: usize, line: &mut [f64]) {
        if let Some(i) = self.single() {
            line.iter_mut().zip(from.row(i)[axis]).for_each(|(to, &from)| *to = from.into());
            return;
        }
        line.fill(0.0);
        for (&i, weight) in self.nodes.iter().zip(self.weights).filter(|&(_, weight)| weight != 0.0) {
            line.iter_mut().zip(from.row(i as usize)[axis]).for_each(|(to, &from)| *to += weight * from.into());
        }
    }

    fn along(&self, line: &[f64]) -> f64 {
        self.single().map_or_else(|| self.apply(|j| line[j]), |j| line[j])
    }
}
