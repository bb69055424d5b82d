//! Frames beside frames: room for comfort.
//!
//! Nadopta's aim: the body of a shoe is that of the foot, and room for comfort round it, more in
//! some places than in others. Each node moves by an amount of its own, and curves are drawn through
//! the new nodes. Directions come from circles through neighbouring nodes
//! ([`node_normals`](gusset_base::geom::node_normals)), so that frames of planes, cylinders and spheres
//! become such.

use super::{Correspondence, Frame, FrameOptions, NodeGrid, frame};
use crate::identify::{Outlines, Points};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::node_normals::{node_normals, tangent};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// The cosine of the angle between the normal of a body and the outside of its section below which
/// the section does not tell on which side the outside is.
const MIN_SIDE: f64 = 0.05;

/// Where nodes move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OffsetDirection {
    /// Along the normals of the body.
    #[default]
    Normal,
    /// Within the planes of their sections.
    InSection,
}

/// The frame whose nodes are so far from those of another: outwards, if its sections are closed,
/// negative distances inwards; of open sections along the derivative from section to section
/// crossed with that along them, or, within sections, away from the chord between their ends. Nodes
/// where nothing tells a direction stay.
///
/// `distances`: one for all nodes, one for each section, or one for each node. `options`: those of
/// the curves; nodes correspond as they are.
///
/// # Errors
/// [`Error::ValuesDiffer`] for another number of distances, [`Error::BadValue`] for one that is not
/// finite, and those of [`frame`].
pub fn offset(
    grid: &NodeGrid,
    closed: bool,
    distances: &[f64],
    direction: OffsetDirection,
    options: &FrameOptions<'_>,
    job: &Job<'_>,
) -> Result<Frame> {
    let (rows, columns) = (grid.rows, grid.columns);
    let distance = by_node(distances, [rows, columns])?;
    // Of coordinates near 1 neither squares nor their inverses leave the range.
    let unit = common_unit(&grid.nodes);
    let nodes = &alloc::collect(grid.nodes.iter().map(|&p| p / unit))?[..];
    let inside = alloc::collect((0..rows * columns).map(|k| {
        let row = &nodes[k / columns * columns..][..columns];
        tangent(columns, closed, k % columns, |j| row[j]).cross(area_vector(row)).normalize_or_zero()
    }))?;
    let directions = match direction {
        OffsetDirection::InSection => inside,
        OffsetDirection::Normal => {
            let mut normals = node_normals(nodes, [rows, columns], [options.ring, closed])?;
            // The side on which the sections have their outside, or, where a body is as flat as its
            // sections, that of most other nodes.
            let outwards: f64 = normals.iter().zip(&inside).map(|(n, out)| n.dot(*out)).sum();
            for (n, out) in normals.iter_mut().zip(&inside).filter(|_| closed) {
                let own = n.dot(*out);
                let side = if own.abs() < MIN_SIDE { outwards } else { own };
                *n = if side < 0.0 { -*n } else { *n };
            }
            normals
        }
    };
    let moved = alloc::collect((0..rows * columns).map(|k| (grid.nodes[k] + distance(k) * directions[k]).to_array()))?;
    let offsets = alloc::collect((0..rows + 1).map(|k| (k * columns) as u32))?;
    let sections = Outlines { points: Points::from(&moved[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let options = FrameOptions {
        correspondence: Correspondence::Given,
        smooth_corners: grid.corners.is_empty(),
        missing: &[],
        ..*options
    };
    frame(&sections, &options, job)
}

/// The distance of each node of a grid, from one for all, one for each row, or one for each node.
pub fn by_node(distances: &[f64], [rows, columns]: [usize; 2]) -> Result<impl Fn(usize) -> f64> {
    let count = rows * columns;
    if let Some((k, &value)) = distances.iter().enumerate().find(|(_, value)| !value.is_finite()) {
        return Err(Error::BadValue { element: Element::Node, index: k as u64, input: 0, value });
    }
    let share = match distances.len() {
        1 => count,
        n if n == count => 1,
        n if n == rows => columns,
        n => return Err(Error::ValuesDiffer { input: 0, given: n as u64, needed: count as u64 }),
    };
    Ok(move |k: usize| distances[k / share])
}

/// The area of a section as a vector square to its plane, about which it runs counterclockwise.
fn area_vector(row: &[DVec3]) -> DVec3 {
    let turn = |pair: &[DVec3]| (pair[0] - row[0]).cross(pair[1] - row[0]);
    row.windows(2).map(turn).sum()
}
