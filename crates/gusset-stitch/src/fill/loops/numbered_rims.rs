//! Several loops with common vertex numbers.

use super::super::triangulation_cost::{CostNormalisation, Polygon};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// Loops in sequence, with consecutive vertex numbers.
pub(super) struct NumberedRims {
    /// The vertices of all loops.
    pub(super) all_vertices: Polygon,
    /// The first vertex of each loop, then the number of vertices.
    loop_starts: Vec<u32>,
    /// The loop of each vertex.
    pub(super) loop_of_vertex: Vec<u32>,
}

impl NumberedRims {
    /// Concatenates the loops, which must have fewer than 2^32 vertices in all.
    pub(super) fn new(loops: &[Polygon]) -> Result<NumberedRims> {
        let mut all = Polygon::new(Vec::new(), Vec::new(), Vec::new());
        let (mut start, mut ring) = (alloc::filled(0, 1)?, Vec::new());
        for (polygon, number) in loops.iter().zip(0..) {
            alloc::append(&mut all.points, &polygon.points)?;
            alloc::append(&mut all.normals_across_edges, &polygon.normals_across_edges)?;
            alloc::append(&mut all.normals, &polygon.normals)?;
            alloc::grow(&mut ring, all.points.len(), number)?;
            alloc::push(&mut start, all.points.len() as u32)?;
        }
        Ok(NumberedRims { all_vertices: all, loop_starts: start, loop_of_vertex: ring })
    }

    /// Returns the number of vertices.
    pub(super) fn vertex_count(&self) -> usize {
        self.loop_of_vertex.len()
    }

    /// Returns the number of loops.
    pub(super) fn loop_count(&self) -> usize {
        self.loop_starts.len() - 1
    }

    /// Returns the vertices of a loop.
    pub(super) fn loop_vertices(&self, ring: usize) -> Range<u32> {
        self.loop_starts[ring]..self.loop_starts[ring + 1]
    }

    /// Returns the next vertex on the loop.
    pub(super) fn next_vertex(&self, v: u32) -> u32 {
        let range = self.loop_vertices(self.loop_of_vertex[v as usize] as usize);
        if v + 1 < range.end { v + 1 } else { range.start }
    }

    /// Returns true if the vertices are the ends of a rim edge.
    pub(super) fn is_rim_edge(&self, u: u32, v: u32) -> bool {
        self.next_vertex(u) == v || self.next_vertex(v) == u
    }

    /// Returns true if the vertices lie on different loops.
    pub(super) fn joins_two_loops(&self, u: u32, v: u32) -> bool {
        self.loop_of_vertex[u as usize] != self.loop_of_vertex[v as usize]
    }

    /// Returns the points of each loop.
    pub(super) fn loop_points(&self) -> impl Iterator<Item = &[DVec3]> + Clone {
        (0..self.loop_count()).map(|ring| {
            let Range { start, end } = self.loop_vertices(ring);
            &self.all_vertices.points[start as usize..end as usize]
        })
    }

    /// Returns the measure of triangulations that close all loops together.
    pub(super) fn common_cost_normalisation(&self) -> CostNormalisation {
        CostNormalisation::new(self.loop_points(), (self.vertex_count() + 2 * self.loop_count()).saturating_sub(4))
    }

    /// Returns the squared distance between two vertices.
    pub(super) fn squared_distance(&self, u: u32, v: u32) -> f64 {
        self.all_vertices.points[u as usize].distance_squared(self.all_vertices.points[v as usize])
    }
}

/// A loop with fewer vertices is not thinned, because at least three vertices must remain.
const MIN_VERTICES_OF_LOOP_TO_THIN: usize = 5;

/// Removes about every other vertex of the long loops: those with more than half as many vertices
/// as the longest. Returns the loops, and for each remaining vertex its old number; `None` if all
/// loops are short.
pub(super) fn thin_loops(loops: &[Polygon]) -> Result<Option<(Vec<Polygon>, Vec<u32>)>> {
    let longest = loops.iter().map(|polygon| polygon.points.len()).max().unwrap_or(0);
    if longest < MIN_VERTICES_OF_LOOP_TO_THIN {
        return Ok(None);
    }
    let (mut coarse, mut kept) = (alloc::with_capacity(loops.len())?, Vec::new());
    let mut first = 0;
    for polygon in loops {
        let n = polygon.points.len();
        let (thin, of_loop) = if n >= MIN_VERTICES_OF_LOOP_TO_THIN && 2 * n > longest {
            polygon.every_other_point()?
        } else {
            let [points, across, normals] =
                [&polygon.points, &polygon.normals_across_edges, &polygon.normals].map(|of| alloc::copied(of));
            (Polygon::new(points?, across?, normals?), alloc::collect((0..n).map(|i| i as u32))?)
        };
        coarse.push(thin);
        alloc::extend(&mut kept, of_loop.iter().map(|&v| first + v))?;
        first += n as u32;
    }
    Ok(Some((coarse, kept)))
}
