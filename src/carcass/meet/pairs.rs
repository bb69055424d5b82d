//! Pairs of cells that may meet: both pyramids are descended together, and pairs of blocks that are apart are dropped.

use super::CellPair;
use crate::alloc;
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::index::{Bounds, Oriented, Pyramid};
use crate::carcass::{Sheet, each_sheet};
use crate::error::{Error, Result};
use crate::job::Job;
use glam::DVec3;

/// The largest number of pairs of cells.
pub const MAX_PAIRS: u64 = 1 << 26;

/// Pairs of blocks between two looks at the job.
const STEP: usize = 1024;

/// A sheet, its index, and what takes its index's coordinates to the common ones.
#[derive(Clone, Copy)]
pub(super) struct Indexed<'a> {
    pub(super) number: u32,
    pub(super) sheet: &'a Sheet<'a>,
    pub(super) index: &'a Pyramid,
}

/// A block of one of the sheets.
#[derive(Clone, Copy)]
struct Node {
    level: usize,
    row: usize,
    column: usize,
    bounds: Bounds,
    solid: Option<Solid>,
}

/// A parallelepiped: its centre and its half edges.
#[derive(Clone, Copy)]
struct Solid {
    centre: DVec3,
    half: [DVec3; 3],
}

impl Solid {
    fn of(oriented: &Oriented, shift: DVec3) -> Solid {
        let corners = oriented.corners();
        let half = [1, 2, 4].map(|k| 0.5 * (corners[k] - corners[0]));
        Solid { centre: 0.5 * (corners[0] + corners[7]) + shift, half }
    }

    /// False if one of the axes of separation shows that the solids are farther apart than `by`: those across faces and across pairs of edges.
    fn meets(&self, other: &Solid, by: f64) -> bool {
        let between = other.centre - self.centre;
        let apart = |axis: DVec3| {
            let reach: f64 = self.half.iter().chain(&other.half).map(|half| half.dot(axis).abs()).sum();
            between.dot(axis).abs() > reach + by * axis.length()
        };
        let faces = |[x, y, z]: [DVec3; 3]| [y.cross(z), z.cross(x), x.cross(y)];
        let edges = || self.half.iter().flat_map(|&a| other.half.map(|b| a.cross(b)));
        !(faces(self.half).into_iter().any(apart) || faces(other.half).into_iter().any(apart) || edges().any(apart))
    }
}

impl Node {
    fn root(index: &Pyramid, shift: DVec3) -> Node {
        let bounds = index.bounds();
        let bounds = shifted(bounds, shift - index.origin());
        Node { level: index.levels().len(), row: 0, column: 0, bounds, solid: None }
    }

    /// The blocks below that exist.
    fn children(self, index: &Pyramid, shift: DVec3) -> impl Iterator<Item = Node> {
        let level = &index.levels()[self.level - 1];
        let group = level.group(self.row, self.column);
        (0..4).filter_map(move |k| {
            let bounds = group.get(k);
            let (row, column) = (2 * self.row + k / 2, 2 * self.column + k % 2);
            (!bounds.is_empty()).then(|| {
                let solid = level.oriented(row, column).map(|oriented| Solid::of(oriented, shift));
                Node { level: self.level - 1, row, column, bounds: shifted(bounds, shift), solid }
            })
        })
    }

    fn extent(&self) -> f64 {
        (self.bounds.high - self.bounds.low).max_element()
    }

    fn meets(&self, other: &Node, by: f64) -> bool {
        overlap(&self.bounds, &other.bounds, by)
            && self.solid.zip(other.solid).is_none_or(|(one, other)| one.meets(&other, by))
    }
}

fn shifted(bounds: Bounds, by: DVec3) -> Bounds {
    Bounds { low: bounds.low + by, high: bounds.high + by }
}

fn overlap(a: &Bounds, b: &Bounds, by: f64) -> bool {
    (a.low - by).cmple(b.high).all() && (b.low - by).cmple(a.high).all()
}

/// A cell: the corners of its quadrilateral, in order round it, relative to the common origin.
#[derive(Clone, Copy)]
struct Quad {
    cell: [u32; 2],
    corners: [DVec3; 4],
    bounds: Bounds,
}

impl Quad {
    const NONE: Quad = Quad { cell: [0; 2], corners: [DVec3::ZERO; 4], bounds: Bounds::EMPTY };

    /// The middle directions of its sides.
    fn sides(&self) -> [DVec3; 2] {
        let [a, b, c, d] = self.corners;
        [c + d - a - b, b + c - a - d]
    }

    /// False if the hulls of the corners are farther apart than `by`, as the axes of separation of two parallelograms show.
    fn meets(&self, other: &Quad, by: f64) -> bool {
        let ([a, b], [c, d]) = (self.sides(), other.sides());
        let apart = |axis: DVec3| {
            let range = |corners: [DVec3; 4]| {
                let along = corners.map(|corner| corner.dot(axis));
                along.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)))
            };
            let ((low, high), (others_low, others_high)) = (range(self.corners), range(other.corners));
            let gap = (others_low - high).max(low - others_high);
            gap > by * axis.length()
        };
        let axes = [a.cross(b), c.cross(d), a.cross(c), a.cross(d), b.cross(c), b.cross(d)];
        overlap(&self.bounds, &other.bounds, by) && !axes.into_iter().any(apart)
    }
}

/// The cells of a block that may meet a box, and how far the surface may be from their quadrilaterals.
struct Block {
    quads: [Quad; BLOCK * BLOCK],
    count: usize,
    deviation: f64,
}

impl Block {
    fn of(sheet: &Indexed<'_>, node: &Node, near: &Bounds, origin: DVec3, by: f64) -> Block {
        let deviation = sheet.index.deviation(node.row, node.column);
        let mut block = Block { quads: [Quad::NONE; BLOCK * BLOCK], count: 0, deviation };
        each_sheet!(sheet.sheet, cells => block.fill(cells, node, near, origin, by));
        block
    }

    fn fill<const N: usize>(&mut self, cells: &impl Cells<N>, node: &Node, near: &Bounds, origin: DVec3, by: f64) {
        let [rows, columns] = cells.counts();
        let (first, last) = (node.row * BLOCK, rows.min((node.row + 1) * BLOCK));
        let (left, right) = (node.column * BLOCK, columns.min((node.column + 1) * BLOCK));
        let mut corners = [[DVec3::ZERO; BLOCK + 1]; BLOCK + 1];
        for i in first..=last {
            for j in left..=right {
                corners[i - first][j - left] = cells.corner(i, j) - origin;
            }
        }
        for (i, j) in (first..last).flat_map(|i| (left..right).map(move |j| (i, j))) {
            let (r, c) = (i - first, j - left);
            let corners = [corners[r][c], corners[r][c + 1], corners[r + 1][c + 1], corners[r + 1][c]];
            let mut bounds = Bounds::EMPTY;
            corners.iter().for_each(|&corner| bounds.add(corner));
            if overlap(&bounds, near, by + self.deviation) {
                self.quads[self.count] = Quad { cell: [i as u32, j as u32], corners, bounds };
                self.count += 1;
            }
        }
    }

    fn quads(&self) -> &[Quad] {
        &self.quads[..self.count]
    }
}

/// Adds the pairs of cells of two sheets that may be as near as `within`: all that are, and few others.
pub(super) fn pairs(
    a: &Indexed<'_>,
    b: &Indexed<'_>,
    within: f64,
    found: &mut Vec<CellPair>,
    job: &Job<'_>,
) -> Result<()> {
    let origin = a.index.origin();
    let shift = b.index.origin() - origin;
    let roots = [Node::root(a.index, DVec3::ZERO), Node::root(b.index, shift)];
    // Boxes hold the surface to the bit; the shift from one origin to the other rounds.
    let size = [a, b].map(|sheet| {
        let Bounds { low, high } = sheet.index.bounds();
        low.abs().max(high.abs()).max_element()
    });
    let by = within + 8.0 * f64::EPSILON * size[0].max(size[1]);
    let mut stack = vec![roots];
    let mut looked_at = 0_usize;
    while let Some([one, other]) = stack.pop() {
        looked_at += 1;
        if looked_at.is_multiple_of(STEP) {
            job.step(0.0, "pairs of cells")?;
        }
        if one.level == 0 && other.level == 0 {
            let left = Block::of(a, &one, &other.bounds, origin, by);
            let right = Block::of(b, &other, &one.bounds, origin, by);
            let by = by + left.deviation + right.deviation;
            for (p, q) in left.quads().iter().flat_map(|p| right.quads().iter().map(move |q| (p, q))) {
                if p.meets(q, by) {
                    alloc::push(found, CellPair { sheets: [a.number, b.number], cells: [p.cell, q.cell] })?;
                }
            }
            if found.len() as u64 > MAX_PAIRS {
                return Err(Error::TooLarge { what: "pairs of cells", count: found.len() as u64, limit: MAX_PAIRS });
            }
        } else if one.level > 0 && (other.level == 0 || one.extent() >= other.extent()) {
            let children = one.children(a.index, DVec3::ZERO).filter(|child| child.meets(&other, by));
            stack.extend(children.map(|child| [child, other]));
        } else {
            let children = other.children(b.index, shift).filter(|child| one.meets(child, by));
            stack.extend(children.map(|child| [one, child]));
        }
    }
    Ok(())
}
