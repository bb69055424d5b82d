//! Several loops in common numbers.

use super::super::weigh::{Measure, Polygon};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// Loops one after another, their vertices numbered through.
pub(super) struct Rims {
    /// The vertices of all of them.
    pub(super) all: Polygon,
    /// Where each loop begins, and where the last one ends.
    start: Vec<u32>,
    /// The loop of each vertex.
    pub(super) ring: Vec<u32>,
}

impl Rims {
    /// Of fewer than 2^32 vertices in all.
    pub(super) fn new(loops: &[Polygon]) -> Result<Rims> {
        let mut all = Polygon::new(Vec::new(), Vec::new(), Vec::new());
        let (mut start, mut ring) = (alloc::filled(0, 1)?, Vec::new());
        for (polygon, number) in loops.iter().zip(0..) {
            alloc::append(&mut all.points, &polygon.points)?;
            alloc::append(&mut all.across, &polygon.across)?;
            alloc::append(&mut all.normals, &polygon.normals)?;
            alloc::grow(&mut ring, all.points.len(), number)?;
            alloc::push(&mut start, all.points.len() as u32)?;
        }
        Ok(Rims { all, start, ring })
    }

    /// How many vertices there are.
    pub(super) fn count(&self) -> usize {
        self.ring.len()
    }

    /// How many loops there are.
    pub(super) fn loops(&self) -> usize {
        self.start.len() - 1
    }

    /// The vertices of a loop.
    pub(super) fn range(&self, ring: usize) -> Range<u32> {
        self.start[ring]..self.start[ring + 1]
    }

    /// The vertex after one, on its loop.
    pub(super) fn next(&self, v: u32) -> u32 {
        let range = self.range(self.ring[v as usize] as usize);
        if v + 1 < range.end { v + 1 } else { range.start }
    }

    /// True of the ends of a rim's edge.
    pub(super) fn is_edge(&self, u: u32, v: u32) -> bool {
        self.next(u) == v || self.next(v) == u
    }

    /// True if an edge between two vertices leads from one loop to another.
    pub(super) fn joins(&self, u: u32, v: u32) -> bool {
        self.ring[u as usize] != self.ring[v as usize]
    }

    /// The points of each loop.
    pub(super) fn points(&self) -> impl Iterator<Item = &[DVec3]> + Clone {
        (0..self.loops()).map(|ring| {
            let Range { start, end } = self.range(ring);
            &self.all.points[start as usize..end as usize]
        })
    }

    /// Of triangulations that close all of them together.
    pub(super) fn measure(&self) -> Measure {
        Measure::of(self.points(), (self.count() + 2 * self.loops()).saturating_sub(4))
    }

    /// The square of the distance of two vertices.
    pub(super) fn squared(&self, u: u32, v: u32) -> f64 {
        self.all.points[u as usize].distance_squared(self.all.points[v as usize])
    }
}

/// A loop of fewer vertices is not thinned: three must be left.
const MIN_THINNED: usize = 5;

/// Loops with about half as many vertices, those alone that have more than half as many as the
/// longest; of each vertex left the number that it had. `None` if all are short.
pub(super) fn thinned(loops: &[Polygon]) -> Result<Option<(Vec<Polygon>, Vec<u32>)>> {
    let longest = loops.iter().map(|polygon| polygon.points.len()).max().unwrap_or(0);
    if longest < MIN_THINNED {
        return Ok(None);
    }
    let (mut coarse, mut kept) = (alloc::with_capacity(loops.len())?, Vec::new());
    let mut first = 0;
    for polygon in loops {
        let n = polygon.points.len();
        let (thin, of_loop) = if n >= MIN_THINNED && 2 * n > longest {
            polygon.coarser()?
        } else {
            let [points, across, normals] =
                [&polygon.points, &polygon.across, &polygon.normals].map(|of| alloc::copied(of));
            (Polygon::new(points?, across?, normals?), alloc::collect((0..n).map(|i| i as u32))?)
        };
        coarse.push(thin);
        alloc::extend(&mut kept, of_loop.iter().map(|&v| first + v))?;
        first += n as u32;
    }
    Ok(Some((coarse, kept)))
}
