//! The nesting of the closed paths of one plane: which loops are around a loop.
//!
//! Each loop gets a test point inside: the middle of the widest gap between its crossings with a
//! line through the middle of its box. A loop is inside another one if the other one has the larger
//! area and an odd number of edges above the test point. Loops may therefore touch and share edges.
//! The edges are sorted into slabs, so that a test sees the edges of one slab only.

use super::section_request::STAGE;
use super::sections::Sections;
use crate::NONE;
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::{Buckets, sort};

/// Slabs are halved in number while the edges have more than this many entries each.
const MAX_ENTRIES_PER_EDGE: usize = 4;

/// An edge of a loop.
#[derive(Clone, Copy, Default)]
struct LoopEdge {
    start_point: DVec2,
    end_point: DVec2,
    /// The index of the loop among the closed paths.
    path: u32,
}

impl LoopEdge {
    /// Returns the second coordinate of the edge at the first coordinate `x`, if the edge has a
    /// point there. If two edges meet at x, one counts.
    fn height_at(&self, x: f64) -> Option<f64> {
        let [low, high] = if self.start_point.x < self.end_point.x {
            [self.start_point, self.end_point]
        } else {
            [self.end_point, self.start_point]
        };
        (low.x <= x && x < high.x).then(|| low.y + (high.y - low.y) * ((x - low.x) / (high.x - low.x)))
    }
}

/// Sets the areas, parents and depths of the paths from `first_path` on, which are of one plane.
pub(super) fn nest_loops(sections: &mut Sections, first_path: usize, normal: DVec3, job: &Job<'_>) -> Result<()> {
    let closed = alloc::gather((first_path..sections.paths.len()).filter(|&k| sections.paths[k].is_closed))?;
    if closed.is_empty() {
        return Ok(());
    }
    let (u, v) = normal.any_orthonormal_pair();
    // Areas are more accurate about a near point.
    let origin = sections.points[sections.range(closed[0]).start];
    let flat = |p: DVec3| DVec2::new((p - origin).dot(u), (p - origin).dot(v));
    let count = closed.iter().map(|&k| sections.range(k).len()).sum();
    let mut edges: Vec<LoopEdge> = alloc::with_capacity(count)?;
    let mut starts: Vec<usize> = alloc::with_capacity(closed.len() + 1)?;
    for (path, &k) in (0..).zip(&closed) {
        job.step_within_list(edges.len(), STAGE)?;
        let points = &sections.points[sections.range(k)];
        starts.push(edges.len());
        edges.extend((0..points.len()).map(|i| LoopEdge {
            start_point: flat(points[i]),
            end_point: flat(points[(i + 1) % points.len()]),
            path,
        }));
        sections.paths[k].area = measure_area(&edges[starts[path as usize]..]);
    }
    starts.push(edges.len());
    if closed.len() == 1 {
        return Ok(());
    }
    let slabs = Slabs::new(&edges, job)?;
    let mut above: Vec<u32> = Vec::new();
    let mut crossings = Vec::new();
    for (path, &k) in closed.iter().enumerate() {
        job.step_within_heavy_list(64, path, STAGE)?;
        let inside = find_inner_point(&edges[starts[path]..starts[path + 1]], &mut crossings, job)?;
        slabs.find_edges_above(&edges, inside, &mut above, job)?;
        sort(&mut above, Ord::cmp, job, STAGE)?;
        let own = (sections.paths[k].area.abs(), std::cmp::Reverse(k));
        // The area, then the path: the smaller of two loops is inside.
        let mut parent: Option<(f64, std::cmp::Reverse<usize>)> = None;
        let mut depth = 0;
        for run in above.chunk_by(|a, b| a == b).filter(|run| run.len() % 2 == 1) {
            let other = closed[run[0] as usize];
            let size = (sections.paths[other].area.abs(), std::cmp::Reverse(other));
            if size > own {
                depth += 1;
                parent = if parent.is_none_or(|parent| size < parent) { Some(size) } else { parent };
            }
        }
        sections.paths[k].depth = depth;
        sections.paths[k].parent = parent.map_or(NONE, |(_, std::cmp::Reverse(other))| other as u32);
    }
    Ok(())
}

/// Returns the signed area of a loop.
fn measure_area(edges: &[LoopEdge]) -> f64 {
    let origin = edges[0].start_point;
    edges.iter().map(|edge| (edge.start_point - origin).perp_dot(edge.end_point - origin)).sum::<f64>() / 2.0
}

/// Returns a point inside a loop, as far as possible from its edges on one line.
fn find_inner_point(edges: &[LoopEdge], crossings: &mut Vec<f64>, job: &Job<'_>) -> Result<DVec2> {
    let (low, high) = edges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), edge| {
        (low.min(edge.start_point.x), high.max(edge.start_point.x))
    });
    let x = f64::midpoint(low, high);
    crossings.clear();
    alloc::extend(crossings, edges.iter().filter_map(|edge| edge.height_at(x)))?;
    sort(crossings, f64::total_cmp, job, STAGE)?;
    let gaps = crossings.chunks_exact(2);
    let widest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    let y = widest.map_or(edges[0].start_point.y, |gap| f64::midpoint(gap[0], gap[1]));
    Ok(DVec2::new(x, y))
}

/// The edges in slabs of equal width along the first coordinate.
struct Slabs {
    low_coordinate: f64,
    /// The number of slabs in a unit of length.
    slabs_per_unit: f64,
    slab_count: usize,
    edges_of_slab: Buckets<u32>,
}

impl Slabs {
    fn new(edges: &[LoopEdge], job: &Job<'_>) -> Result<Slabs> {
        let (low, high) = edges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), edge| {
            (low.min(edge.start_point.x), high.max(edge.start_point.x))
        });
        let mut slabs = Slabs {
            low_coordinate: low,
            slabs_per_unit: 0.0,
            slab_count: edges.len(),
            edges_of_slab: Buckets::default(),
        };
        loop {
            job.step_within_list(edges.len(), STAGE)?;
            let density = slabs.slab_count as f64 / (high - low);
            slabs.slabs_per_unit = if density.is_finite() { density } else { 0.0 };
            let entries: usize = edges.iter().map(|edge| slabs.range_of_edge(edge).count()).sum();
            if entries <= MAX_ENTRIES_PER_EDGE * edges.len() {
                break;
            }
            slabs.slab_count /= 2;
        }
        let by_slab = (0..).zip(edges).flat_map(|(k, edge)| slabs.range_of_edge(edge).map(move |slab| (slab, k)));
        slabs.edges_of_slab = Buckets::new_cancellable(slabs.slab_count, 0, by_slab, job, STAGE)?;
        Ok(slabs)
    }

    fn slab_at(&self, x: f64) -> usize {
        // The conversion saturates.
        (((x - self.low_coordinate) * self.slabs_per_unit) as usize).min(self.slab_count - 1)
    }

    fn range_of_edge(&self, edge: &LoopEdge) -> std::ops::RangeInclusive<usize> {
        let [a, b] = [edge.start_point.x, edge.end_point.x].map(|x| self.slab_at(x));
        a.min(b)..=a.max(b)
    }

    /// Collects the loop of each edge above a point.
    fn find_edges_above(&self, edges: &[LoopEdge], p: DVec2, above: &mut Vec<u32>, job: &Job<'_>) -> Result<()> {
        above.clear();
        for (k, &edge) in self.edges_of_slab.get(self.slab_at(p.x)).iter().enumerate() {
            job.step_within_list(k, STAGE)?;
            let edge = &edges[edge as usize];
            if edge.height_at(p.x).is_some_and(|height| height > p.y) {
                alloc::push(above, edge.path)?;
            }
        }
        Ok(())
    }
}
