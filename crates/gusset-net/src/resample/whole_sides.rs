//! Nets glued along whole sides: their requirements, and results with the same sides. O(nodes).

use crate::arrange::{Rearrangement, rearrange_coordinates};
use crate::field::snap_glued_nodes;
use crate::{Coordinates, Net, Shape, Sides, Topology};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// Returns the sides of a net without other gluings and bridges; otherwise returns
/// [`Error::GluedInside`].
pub(super) fn sides_or_glued_inside_error(net: &Net<'_>) -> Result<Sides> {
    let plain = net.topology().seams().is_empty() && net.bridges().is_empty();
    net.topology().sides().filter(|_| plain).ok_or(Error::GluedInside)
}

/// Returns the smallest numbers of rows and columns that preserve the surface, if closed ones keep
/// `closed` nodes. A face between two poles must not become an edge or occur twice.
pub(super) fn min_rows_and_columns(sides: Sides, min_closed_count: usize) -> [usize; 2] {
    let min = |is_closed: bool, poles: [bool; 2], across: [bool; 2]| match (poles, across) {
        _ if is_closed => min_closed_count,
        ([true, true], [false, false]) => 3,
        ([true, true], _) => 4,
        ([true, _] | [_, true], [true, _] | [_, true]) => 3,
        _ => 2,
    };
    let (rows, columns) = ([sides.pole_top, sides.pole_bottom], [sides.pole_left, sides.pole_right]);
    [min(sides.columns_closed, rows, columns), min(sides.rows_closed, columns, rows)]
}

/// Returns a net with the given sides and the orientation of another, its glued nodes made equal.
pub(super) fn net_with_sides(coordinates: Coordinates<'static>, like: &Net<'_>, sides: Sides) -> Result<Net<'static>> {
    let topology = Topology::from_sides(coordinates.shape(), sides).with_reversed(like.topology().is_reversed());
    let mut net = Net::new(coordinates, topology);
    snap_glued_nodes(&mut net)?;
    Ok(net)
}

/// Returns the nodes of selected rows and columns, bit for bit.
pub(super) fn select_lines(
    net: &Net<'_>,
    rows: &[usize],
    columns: &[usize],
    job: &Job<'_>,
) -> Result<Coordinates<'static>> {
    let indices = |list: &[usize]| alloc::collect(list.iter().map(|&k| k as u32));
    let shape = Shape::new(rows.len(), columns.len())?;
    let map = Rearrangement::Selection { rows: &indices(rows)?, columns: &indices(columns)? };
    rearrange_coordinates(net.coordinates(), shape, &map, job)
}
