//! The topology that coordinates tell: what lies together is glued.
//!
//! Neighbours that coincide are contracted links. Of the rest only the rim of the net is looked at: runs of rim nodes
//! that coincide with others, forwards or backwards, are what closes a net, be it a row that ends where it begins, a
//! side that is another one turned round, or one that is folded. A node that meets another one alone touches it and is
//! not glued to it.

use super::coincide::{check_tolerance, coincide, links};
use super::topology::{Links, Matrix, Run, Seam, Topology};
use super::{Classes, Coordinates, Shape};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;
use std::cmp::Ordering;

/// Of the rim nodes at one place, each is compared with so many others at most.
const MOST_PARTNERS: usize = 8;

/// The topology of coordinates, in its canonical form ([`Topology::saturated`]): neighbours that coincide, and runs of
/// two and more rim nodes that do. Tolerance 0: equal coordinates (0 and -0 are equal). O(nodes), and a sort of the
/// rim.
///
/// # Errors
/// [`Error::OptionOutOfRange`](crate::Error::OptionOutOfRange) (the tolerance is no finite number from 0 on),
/// [`Error::CrossingCell`](crate::Error::CrossingCell) (both pairs of opposite corners of a cell coincide, and are not
/// all one), [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
pub fn derive(coordinates: &Coordinates<'_>, tolerance: f64, job: &Job<'_>) -> Result<Topology> {
    check_tolerance(tolerance)?;
    let shape = coordinates.shape();
    let mut matrix = Matrix::empty(shape)?;
    links(coordinates, tolerance, &job.part(0.0, 0.5), |link| {
        if shape.is_inner(link) {
            matrix.set(link, true);
        }
        Ok(())
    })?;
    let near = Topology::new(shape, Links::Matrix(matrix), &[])?;
    let classes = Classes::of(&near)?;
    let rim = Rim { shape, coordinates, tolerance };
    let seams = rim.seams(&rim.pairs(&classes)?, &classes)?;
    job.step(0.8, "derivation")?;
    Topology::new(shape, Links::Matrix(near.matrix()?), &seams)?.saturated()
}

/// The nodes of the four sides, numbered round the net: the first row forwards, the last column down, the last row
/// backwards, the first column up. Corners are there once.
struct Rim<'a> {
    shape: Shape,
    coordinates: &'a Coordinates<'a>,
    tolerance: f64,
}

impl Rim<'_> {
    fn len(&self) -> usize {
        2 * (self.shape.rows() + self.shape.columns()) - 4
    }

    /// Where the four sides begin, and the end.
    fn corners(&self) -> [usize; 5] {
        let (h, w) = (self.shape.rows() - 1, self.shape.columns() - 1);
        [0, w, w + h, 2 * w + h, 2 * (w + h)]
    }

    fn node(&self, k: usize) -> (usize, usize) {
        let (h, w) = (self.shape.rows() - 1, self.shape.columns() - 1);
        match k {
            k if k < w => (0, k),
            k if k < w + h => (k - w, w),
            k if k < 2 * w + h => (h, 2 * w + h - k),
            k => (2 * (w + h) - k, 0),
        }
    }

    fn place(&self, k: usize) -> DVec3 {
        let (i, j) = self.node(k % self.len());
        self.coordinates.get(i, j)
    }

    fn class(&self, classes: &Classes, k: usize) -> u32 {
        let (i, j) = self.node(k % self.len());
        classes.representative(self.shape.node(i, j))
    }

    /// Pairs of rim nodes that coincide and are not one vertex by links alone; of each such vertex its first node.
    fn pairs(&self, classes: &Classes) -> Result<Vec<[usize; 2]>> {
        let mut nodes: Vec<(u32, usize)> = alloc::collect((0..self.len()).map(|k| (self.class(classes, k), k)))?;
        nodes.sort_unstable();
        nodes.dedup_by_key(|node| node.0);
        let mut sorted: Vec<(Cell, usize)> = alloc::with_capacity(nodes.len())?;
        let finite = nodes.iter().filter(|node| self.place(node.1).is_finite());
        sorted.extend(finite.map(|&(_, k)| (self.cell(k), k)));
        sorted.sort_unstable_by(|a, b| by_cell(&a.0, &b.0).then(a.1.cmp(&b.1)));
        // Nodes within the tolerance are in the same cell or next to it; the cells in a line along z are in sequence.
        let near: &[f64] = if self.tolerance > 0.0 { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        let (first, last) = (near[0], near[near.len() - 1]);
        let mut pairs = Vec::new();
        for (at, &([x, y, z], k)) in sorted.iter().enumerate() {
            // Each pair is found from the node that comes first.
            let partners = near.iter().flat_map(|dx| near.iter().map(move |dy| [x + dx, y + dy])).flat_map(|[x, y]| {
                let behind = &sorted[at + 1..];
                let from = behind.partition_point(|other| by_cell(&other.0, &[x, y, z + first]).is_lt());
                behind[from..].iter().take_while(move |other| by_cell(&other.0, &[x, y, z + last]).is_le())
            });
            let partners = partners.filter(|&&(_, l)| coincide(self.place(k), self.place(l), self.tolerance));
            for &(_, l) in partners.take(MOST_PARTNERS) {
                alloc::push(&mut pairs, [k.min(l), k.max(l)])?;
            }
        }
        Ok(pairs)
    }

    /// The cell of a grid that a rim node is in: a little wider than the tolerance, for rounding. Without a tolerance, or
    /// with one that is too small for any other node to be within it, each place is one.
    fn cell(&self, k: usize) -> Cell {
        self.place(k).to_array().map(|x| {
            let at = (x / (self.tolerance * 1.01)).floor();
            // Adding 0 makes one zero of the two.
            (if self.tolerance > 0.0 && at.is_finite() { at } else { x }) + 0.0
        })
    }

    /// The pairs in runs. Those of one sum run against each other, those of one difference side by side; round the rim,
    /// both are meant modulo its length. Every run is found from both its sides, which a topology takes for the one
    /// seam that it is.
    fn seams(&self, pairs: &[[usize; 2]], classes: &Classes) -> Result<Vec<Seam>> {
        let n = self.len();
        let mut seams = Vec::new();
        for backwards in [true, false] {
            let line = |k: usize, l: usize| if backwards { (k + l) % n } else { (l + n - k) % n };
            let mut sorted = alloc::with_capacity(2 * pairs.len())?;
            sorted.extend(pairs.iter().flat_map(|&[k, l]| [(line(k, l), k), (line(l, k), l)]));
            sorted.sort_unstable();
            sorted.dedup();
            for line in sorted.chunk_by(|a, b| a.0 == b.0) {
                let partners = Partners { line: line[0].0, backwards, n };
                for (start, count) in cyclic_runs(line, n) {
                    self.add_run(partners, start, count, classes, &mut seams)?;
                }
            }
        }
        Ok(seams)
    }

    /// A run, cut where either side turns a corner; with the pair before and after it, if it is one of vertices that
    /// links have glued to others and that were not compared for that.
    fn add_run(
        &self,
        partners: Partners,
        start: usize,
        count: usize,
        classes: &Classes,
        seams: &mut Vec<Seam>,
    ) -> Result<()> {
        let n = self.len();
        let same = |k: usize| {
            self.class(classes, k) == self.class(classes, partners.of(k))
                || coincide(self.place(k), self.place(partners.of(k)), self.tolerance)
        };
        let before = usize::from(count < n && same(start + n - 1));
        let after = usize::from(count < n && same(start + count));
        let (mut k, mut steps) = (start + n - before, before + count + after - 1);
        // A fold is its own other side.
        if partners.backwards && partners.of(k) % n == (k + steps) % n {
            steps /= 2;
        }
        while steps > 0 {
            let (a, b) = (self.run(k, true), self.run(partners.of(k), !partners.backwards));
            let straight = a.1.min(b.1).min(steps);
            alloc::push(seams, Seam { a: a.0, b: b.0, count: straight as u32 + 1 })?;
            (k, steps) = (k + straight, steps - straight);
        }
        Ok(())
    }

    /// The straight run that begins at rim node k and goes on round the rim, or back; and how many steps it can take.
    fn run(&self, k: usize, forwards: bool) -> (Run, usize) {
        let (k, corners) = (k % self.len(), self.corners());
        // Going back from a corner is going along the side before.
        let k = if k == 0 && !forwards { corners[4] } else { k };
        let side = (0..4).rposition(|side| if forwards { corners[side] <= k } else { corners[side] < k }).unwrap_or(0);
        let steps = if forwards { corners[side + 1] - k } else { k - corners[side] };
        let (i, j) = self.node(k);
        let along = if forwards { 1 } else { -1 };
        let (row_step, column_step) = [(0, along), (along, 0), (0, -along), (-along, 0)][side];
        (Run { row: i as u32, column: j as u32, row_step, column_step }, steps)
    }
}

/// Of a grid: three whole numbers, or three coordinates.
type Cell = [f64; 3];

fn by_cell(a: &Cell, b: &Cell) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
}

/// Which rim node a rim node is paired with.
#[derive(Clone, Copy)]
struct Partners {
    /// The sum of the two, or the difference.
    line: usize,
    backwards: bool,
    n: usize,
}

impl Partners {
    fn of(self, k: usize) -> usize {
        let k = k % self.n;
        (if self.backwards { self.line + self.n - k } else { k + self.line }) % self.n
    }
}

/// Runs of consecutive numbers, as first number and count; n comes before 0.
fn cyclic_runs(line: &[(usize, usize)], n: usize) -> impl Iterator<Item = (usize, usize)> {
    let wraps = line.len() < n && line[0].1 == 0 && line[line.len() - 1].1 == n - 1;
    let runs = || line.chunk_by(|a, b| a.1 + 1 == b.1).map(|run| (run[0].1, run.len()));
    let head = if wraps { runs().next().map_or(0, |run| run.1) } else { 0 };
    let count = runs().count();
    let joined = move |(at, (start, len)): (usize, (usize, usize))| match at {
        0 if wraps => None,
        at if wraps && at + 1 == count => Some((start, len + head)),
        _ => Some((start, len)),
    };
    line.chunk_by(|a, b| a.1 + 1 == b.1).map(|run| (run[0].1, run.len())).enumerate().filter_map(joined)
}
