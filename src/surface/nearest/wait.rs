//! What is left of a long search: blocks, cells and parts of them that wait for their turn, the one with the least bound first.

use super::cell::{DEPTH, Part, proven};
use super::descend::{FEW_STEPS, Foot, STEPS, descend};
use super::hunt::{Answer, Hunt};
use super::leaf::{Leaf, decide};
use super::search::Block;
use crate::surface::Patch;
use crate::surface::cells::Cells;
use crate::surface::index::Pyramid;
use glam::DVec2;
use std::cmp::Ordering;

/// Something of a sheet that has to wait, and a lower bound of its distance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Waiting {
    pub(super) bound: f64,
    pub(super) sheet: u32,
    pub(super) what: What,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum What {
    Block {
        level: u32,
        row: u32,
        column: u32,
    },
    /// A cell, and parameters near its nearest point.
    Cell {
        cell: [u32; 2],
        start: DVec2,
    },
    /// A part of a cell in which a nearest point was looked for.
    Part {
        cell: [u32; 2],
        from: DVec2,
        size: DVec2,
    },
}

/// The one with the least bound is the greatest.
impl Ord for Waiting {
    fn cmp(&self, other: &Waiting) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Waiting) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Waiting) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl Waiting {
    /// Looks at it; what it consists of may have to wait again.
    pub(super) fn open<const N: usize>(&self, cells: &impl Cells<N>, index: &Pyramid, hunt: &mut Hunt) {
        let sheet = self.sheet;
        match self.what {
            What::Block { level: 0, row, column } => {
                let reach = hunt.reach();
                Leaf { cells, index, row: row as usize, column: column as usize }.search(hunt);
                if hunt.reach() < reach && hunt.is_worth(hunt.reach()) {
                    decide(cells, sheet, hunt);
                }
                while let Some(candidate) = hunt.candidates.pop() {
                    hunt.wait(candidate.waiting(sheet));
                }
            }
            What::Block { level, row, column } => {
                let block =
                    Block { bound: self.bound, level: level as usize, row: row as usize, column: column as usize };
                for child in block.children(index, hunt.query).into_iter().flatten() {
                    let (level, row, column) = (child.level as u32, child.row as u32, child.column as u32);
                    let bound = child.bound.max(self.bound);
                    hunt.wait(Waiting { bound, sheet, what: What::Block { level, row, column } });
                    let cell = child.middle(cells);
                    if hunt.is_worth(cells.corner(cell[0], cell[1]).distance(hunt.query)) {
                        look(cells, sheet, cell, DVec2::ZERO, hunt);
                    }
                }
            }
            What::Cell { cell, start } => {
                look(cells, sheet, cell.map(|k| k as usize), start, hunt);
            }
            What::Part { cell, from, size } => {
                let patch = cells.patch(cell[0] as usize, cell[1] as usize);
                let part = Part { patch: patch.cut(from, from + size), from, size, bound: self.bound };
                part.divide(|part| Look { patch: &patch, sheet, cell }.part(&part.bounded(hunt.query), hunt));
            }
        }
    }
}

/// Steps from cell to cell.
const WAY: usize = 256;

/// Goes down from the nearest answer from cell to cell: a search that ends without proof may not have come to the bottom.
pub(super) fn settle<const N: usize>(cells: &impl Cells<N>, closed: [bool; 2], hunt: &mut Hunt) {
    for _ in 0..WAY {
        let Some(best) = hunt.best() else { return };
        let counts = cells.counts();
        let next = |k: usize, off: usize| {
            // One before, the same, one after.
            let (at, count) = (best.cell[k] as usize + off, counts[k]);
            if closed[k] { Some((at + count - 1) % count) } else { at.checked_sub(1).filter(|&at| at < count) }
        };
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            if let (Some(i), Some(j)) = (next(0, i), next(1, j)) {
                look(cells, best.sheet, [i, j], DVec2::splat(0.5), hunt);
            }
        }
        if hunt.distance() >= best.distance - hunt.tolerance {
            return;
        }
    }
}

/// Looks at a cell.
fn look<const N: usize>(cells: &impl Cells<N>, sheet: u32, [i, j]: [usize; 2], start: DVec2, hunt: &mut Hunt) {
    Look { patch: &cells.patch(i, j), sheet, cell: [i as u32, j as u32] }.whole(0.0, start, hunt);
}

/// A look at a cell.
pub(super) struct Look<'a, const N: usize> {
    pub(super) patch: &'a Patch<N>,
    pub(super) sheet: u32,
    pub(super) cell: [u32; 2],
}

impl<const N: usize> Look<'_, N> {
    /// At all of it. `bound`: what is known of its distance; `start`: parameters near its nearest point.
    pub(super) fn whole(&self, bound: f64, start: DVec2, hunt: &mut Hunt) {
        hunt.work();
        let foot = descend(self.patch, hunt.query, start, STEPS);
        let proven = proven(self.patch, hunt.query, &foot, bound, hunt.tolerance);
        if proven > hunt.limit() {
            return;
        }
        self.add(&foot, hunt);
        if proven >= foot.distance - hunt.tolerance {
            hunt.proved(proven);
        } else {
            self.wait(proven, DVec2::ZERO, DVec2::ONE, hunt);
        }
    }

    fn part(&self, part: &Part<N>, hunt: &mut Hunt) {
        if part.bound > hunt.limit() {
            return;
        }
        hunt.work();
        let local = descend(&part.patch, hunt.query, DVec2::splat(0.5), FEW_STEPS);
        if local.distance <= hunt.limit().min(hunt.distance()) {
            // As the whole patch has it: the part's control points are rounded.
            self.add(&Foot::at(self.patch, hunt.query, part.from + part.size * local.place), hunt);
        }
        let proven = proven(&part.patch, hunt.query, &local, part.bound, hunt.tolerance);
        if proven >= hunt.distance() - hunt.tolerance || part.size.min_element() <= 0.5_f64.powi(DEPTH) {
            hunt.proved(proven);
        } else {
            self.wait(proven, part.from, part.size, hunt);
        }
    }

    fn wait(&self, bound: f64, from: DVec2, size: DVec2, hunt: &mut Hunt) {
        hunt.wait(Waiting { bound, sheet: self.sheet, what: What::Part { cell: self.cell, from, size } });
    }

    fn add(&self, foot: &Foot, hunt: &mut Hunt) {
        let Foot { place, jet, distance } = *foot;
        let normal = jet.regular_normal(self.patch.noise()).unwrap_or_default();
        let (sheet, cell) = (self.sheet, self.cell);
        hunt.add(Answer { point: jet.point, normal, distance, sheet, cell, parameters: place });
    }
}
