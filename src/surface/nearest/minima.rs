//! All places where the distance is locally least, the nearest first.

use super::Closest;
use super::cell::{Workspace, nearest};
use super::critical::{Least, minima, side_minima};
use super::descend::{STEPS, descend};
use super::region::check;
use super::search::Block;
use crate::alloc;
#[cfg(doc)]
use crate::error::Error;
use crate::error::Result;
use crate::job::Job;
use crate::surface::cells::Cells;
use crate::surface::{Place, Sheet, Surface, each_sheet};
use glam::{DVec2, DVec3};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Places where the distance from a point is locally least.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Minima {
    /// The nearest first. Of each, `bound` is about the surface next to it; if `proven` is false, it is not certain that it is a minimum: the
    /// distance is nearly the same all round, as at a focus, or on a whole curve of places; for all such cells that touch there is one.
    pub points: Vec<Closest>,
    /// False if the search gave up: there may be others, none nearer than `bound`.
    pub complete: bool,
    /// No minimum that is missing is nearer: the distance at which the search ended.
    pub bound: f64,
}

/// Cells that may stay open before a search gives up.
const OPEN: usize = 512;
/// Blocks between two chances to cancel.
const ROUND: usize = 1 << 8;

/// A block that waits, the nearest to be taken first.
struct Waiting {
    block: Block,
    sheet: usize,
}

impl Waiting {
    fn key(&self) -> (f64, usize, usize, usize, usize) {
        (self.block.bound, self.sheet, self.block.level, self.block.row, self.block.column)
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let ((a, at), (b, other)) = ((self.key().0, self.key()), (other.key().0, other.key()));
        b.total_cmp(&a).then_with(|| (other.1, other.2, other.3, other.4).cmp(&(at.1, at.2, at.3, at.4)))
    }
}

/// A minimum and the cell where it was found.
#[derive(Clone, Copy)]
struct Candidate {
    least: Least,
    sheet: usize,
    cell: (usize, usize),
}

impl Surface<'_> {
    /// The places where the distance from `query` is locally least, no farther than `limit`: all, or the `most` nearest; the nearest first.
    ///
    /// None is missed: a place where it cannot be proved that there is a minimum, or that there is none, is given too, with `proven` false.
    /// With `most`, cells farther than the last one are not looked at; without, all cells within the limit are.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a limit that is negative or NaN, [`Error::NotFinite`], [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn local_minima(&self, query: DVec3, limit: f64, most: usize, job: &Job<'_>) -> Result<Minima> {
        check("limit", query, limit)?;
        let tolerance = self.tolerance().max(self.rounding(query));
        let mut search = Search { surface: self, query, limit, tolerance, most, found: Vec::new(), open: Vec::new() };
        let bound = search.run(job)?;
        search.end(bound, self.closest(query, limit))
    }
}

struct Search<'a> {
    surface: &'a Surface<'a>,
    query: DVec3,
    limit: f64,
    tolerance: f64,
    most: usize,
    found: Vec<Candidate>,
    open: Vec<Candidate>,
}

impl Search<'_> {
    /// Looks at blocks, the nearest first; the distance at which it ended.
    fn run(&mut self, job: &Job<'_>) -> Result<f64> {
        let mut waiting = BinaryHeap::new();
        for sheet in 0..self.surface.len() {
            waiting.push(Waiting { block: Block::root(self.surface.indexed(sheet).1), sheet });
        }
        let mut looked_at = 0;
        while let Some(Waiting { block, sheet }) = waiting.pop() {
            if block.bound > self.reach() || self.open.len() > OPEN {
                return Ok(block.bound);
            }
            looked_at += 1;
            if looked_at % ROUND == 0 {
                job.step(0.0, "minima")?;
            }
            let (cells, index) = self.surface.indexed(sheet);
            if block.level > 0 {
                waiting.extend(
                    block.children(index, self.query).into_iter().flatten().map(|block| Waiting { block, sheet }),
                );
                continue;
            }
            each_sheet!(cells, cells => self.block(cells, &block, sheet))?;
        }
        Ok(self.limit)
    }

    /// What is farther is not wanted.
    fn reach(&self) -> f64 {
        if self.most == 0 || self.found.len() < self.most {
            return self.limit;
        }
        let mut distances: Vec<f64> = self.found.iter().map(|found| found.least.distance).collect();
        let (_, &mut last, _) = distances.select_nth_unstable_by(self.most - 1, f64::total_cmp);
        self.limit.min(last + self.tolerance)
    }

    fn block<const N: usize>(&mut self, cells: &impl Cells<N>, block: &Block, sheet: usize) -> Result<()> {
        for cell in block.cells(cells) {
            let patch = cells.patch(cell.0, cell.1);
            if patch.box_distance(self.query) > self.limit {
                continue;
            }
            let mut candidates = Vec::new();
            minima(&patch, self.query, self.tolerance, |least| candidates.push(least));
            if !cells.is_smooth_around(cell.0, cell.1) {
                side_minima(&patch, self.query, |least| candidates.push(least));
            }
            for least in candidates {
                self.add(Candidate { least, sheet, cell })?;
            }
        }
        Ok(())
    }

    fn add(&mut self, candidate: Candidate) -> Result<()> {
        let least = &candidate.least;
        if least.bound > self.limit {
            return Ok(());
        }
        if !least.proven {
            return alloc::push(&mut self.open, candidate);
        }
        let near = 16.0 * self.tolerance;
        let known = |other: &Candidate| other.least.point.distance(least.point) <= near;
        if least.distance > self.limit || self.found.iter().any(known) || !self.is_least_around(&candidate) {
            return Ok(());
        }
        alloc::push(&mut self.found, candidate)
    }

    /// True if no cell that meets the candidate's point has a way down from there.
    fn is_least_around(&self, candidate: &Candidate) -> bool {
        let on_border = |x: f64| x <= 0.0 || x >= 1.0;
        let least = &candidate.least;
        if !(on_border(least.place.x) || on_border(least.place.y)) {
            return true;
        }
        (0..self.surface.len()).all(|sheet| {
            let (cells, _) = self.surface.indexed(sheet);
            each_sheet!(cells, cells => self.is_least_in(cells, sheet, least))
        })
    }

    fn is_least_in<const N: usize>(&self, cells: &impl Cells<N>, sheet: usize, least: &Least) -> bool {
        let index = self.surface.indexed(sheet).1;
        let mut workspace = Workspace::default();
        let mut blocks = vec![Block::root(index)];
        while let Some(block) = blocks.pop() {
            if block.level > 0 {
                let meets = |block: &Block| block.bound <= self.tolerance;
                blocks.extend(block.children(index, least.point).into_iter().flatten().filter(meets));
                continue;
            }
            for (i, j) in block.cells(cells) {
                let patch = cells.patch(i, j);
                if patch.box_distance(least.point) > self.tolerance {
                    continue;
                }
                let start = DVec2::splat(0.5);
                let Some(there) =
                    nearest(&patch, least.point, start, self.tolerance, 0.1 * self.tolerance, &mut workspace)
                else {
                    continue;
                };
                if there.distance <= self.tolerance {
                    let foot = descend(&patch, self.query, there.place, STEPS);
                    let moved = foot.jet.point.distance(least.point) > 16.0 * self.tolerance;
                    if moved && foot.distance < least.distance {
                        return false;
                    }
                }
            }
        }
        true
    }

    /// What was found, with one place for all open cells that touch.
    fn end(mut self, bound: f64, nearest: Option<Closest>) -> Result<Minima> {
        let complete = self.open.len() <= OPEN;
        merge(&mut self.open, self.surface);
        let proven = std::mem::take(&mut self.found);
        // An open place next to a proven one is that.
        let near = 16.0 * self.tolerance;
        self.open.retain(|open| proven.iter().all(|found| found.least.point.distance(open.least.point) > near));
        let mut points = alloc::with_capacity(proven.len() + self.open.len() + 1)?;
        for Candidate { least, sheet, cell } in proven.into_iter().chain(self.open) {
            let (i, j) = (cell.0 as u32, cell.1 as u32);
            let place = Place { sheet: sheet as u32, cell: [i, j], u: least.place.x, v: least.place.y };
            let Least { point, distance, bound, proven, .. } = least;
            let normal = self.surface.normal(place);
            points.push(Closest { place, point, normal, distance, bound, proven, many: !proven });
        }
        // The nearest point of all is a minimum, whatever the surface is like there.
        let reached = |point: &Closest, nearest: &Closest| point.distance <= nearest.distance + self.tolerance;
        if let Some(nearest) = nearest.filter(|nearest| !points.iter().any(|point| reached(point, nearest))) {
            points.push(nearest);
        }
        points.sort_by(|a, b| {
            let place = |c: &Closest| (c.place.sheet, c.place.cell);
            a.distance.total_cmp(&b.distance).then_with(|| place(a).cmp(&place(b)))
        });
        points.retain(|point| point.distance <= self.limit);
        unite(&mut points, near)?;
        if self.most > 0 {
            points.truncate(self.most);
        }
        Ok(Minima { points, complete, bound })
    }
}

/// Leaves one of all points that are one in space, the first; a proven one next to it makes it proven.
fn unite(points: &mut Vec<Closest>, near: f64) -> Result<()> {
    let mut kept: Vec<Closest> = alloc::with_capacity(points.len())?;
    for point in points.drain(..) {
        // Points that are one are nearly as far: the last ones only need be compared.
        let alike = kept.iter_mut().rev().take_while(|other| other.distance >= point.distance - near);
        match { alike }.find(|other| other.point.distance(point.point) <= near) {
            Some(other) if point.proven && !other.proven => *other = point,
            Some(other) => other.bound = other.bound.min(point.bound),
            None => kept.push(point),
        }
    }
    // A proven one may be a little farther than the one whose place it took.
    kept.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    *points = kept;
    Ok(())
}

/// Leaves the nearest of all that are in cells of a sheet that touch, round seams too.
fn merge(open: &mut Vec<Candidate>, surface: &Surface<'_>) {
    open.sort_by_key(|candidate| (candidate.sheet, candidate.cell));
    let mut group: Vec<usize> = (0..open.len()).collect();
    fn root(group: &mut [usize], mut k: usize) -> usize {
        while group[k] != k {
            group[k] = group[group[k]];
            k = group[k];
        }
        k
    }
    for k in 0..open.len() {
        let Candidate { sheet, cell, .. } = open[k];
        for next in neighbours(surface.sheet(sheet), cell) {
            if let Ok(other) = open.binary_search_by_key(&(sheet, next), |other| (other.sheet, other.cell)) {
                let (a, b) = (root(&mut group, k), root(&mut group, other));
                group[a.max(b)] = a.min(b);
            }
        }
    }
    let mut best: Vec<Option<Candidate>> = vec![None; open.len()];
    for (k, &candidate) in open.iter().enumerate() {
        let slot = &mut best[root(&mut group, k)];
        *slot = Some(match *slot {
            Some(other) => {
                let bound = other.least.bound.min(candidate.least.bound);
                let nearer = if candidate.least.distance < other.least.distance { candidate } else { other };
                Candidate { least: Least { bound, ..nearer.least }, ..nearer }
            }
            None => candidate,
        });
    }
    *open = best.into_iter().flatten().collect();
}

/// The cells round another one of a sheet.
fn neighbours(sheet: &Sheet<'_>, (i, j): (usize, usize)) -> impl Iterator<Item = (usize, usize)> {
    let counts = sheet.cells();
    let closed = match sheet {
        Sheet::Grid(grid) => grid.is_closed(),
        _ => [false; 2],
    };
    let step = move |at: usize, by: usize, k: usize| {
        let (at, count) = (at + by, counts[k]);
        if closed[k] { Some((at + count - 1) % count) } else { at.checked_sub(1).filter(|&at| at < count) }
    };
    (0..9).filter_map(move |k| Some((step(i, k / 3, 0)?, step(j, k % 3, 1)?)))
}
