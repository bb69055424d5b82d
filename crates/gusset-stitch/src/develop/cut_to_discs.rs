//! Cuts that leave only discs.
//!
//! The loops of a chart's border are joined by shortest paths, one after another. Handles are cut
//! by the greedy system of loops (Erickson, Whittlesey). T is the tree of shortest paths from the
//! border, or from a vertex. The other edges are sorted by the loops they close with T, the longest
//! first. In this order, a spanning tree of the faces is built from the edges that it may cross;
//! they stay whole. Each of the remaining 2 g edges closes a loop with T, and cutting along these
//! loops leaves a disc.

use super::STAGE;
use super::cut_edges::{CutSurface, PathSearch, SurfaceGraph};
use super::develop_request::CutKind;
use super::split_surface::SurfaceSplitAtCuts;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_base::sort::{Buckets, sort};
use gusset_mesh::NONE;

/// Cuts each chart that is not a disc until it is one. Returns true if there were any. O(H log V)
/// for each loop and handle.
pub(super) fn open_charts_to_discs(
    surface: &mut CutSurface<'_, '_>,
    split: &SurfaceSplitAtCuts,
    job: &Job<'_>,
) -> Result<bool> {
    let charts = split.euler.len();
    if (0..charts).all(|chart| split.is_disc(chart)) {
        return Ok(false);
    }
    let count = split.vertex_map.len();
    let graph = SurfaceGraph::new(surface, count, |h| split.corners[h as usize], job)?;
    let mut search = PathSearch::new(count)?;
    for chart in (0..charts).filter(|&chart| !split.is_disc(chart)) {
        let done = chart as f64 / charts as f64;
        job.step(done, STAGE)?;
        DiscOpening { split, graph: &graph, search: &mut search, chart }
            .cut_to_disc(surface, &job.sub_job(done, done))?;
    }
    Ok(true)
}

struct DiscOpening<'a> {
    split: &'a SurfaceSplitAtCuts,
    graph: &'a SurfaceGraph,
    search: &'a mut PathSearch,
    chart: usize,
}

impl DiscOpening<'_> {
    fn cut_to_disc(&mut self, surface: &mut CutSurface<'_, '_>, job: &Job<'_>) -> Result<()> {
        let first = self.split.vertices[self.chart].start;
        let loops = self.border_loops(surface, job)?;
        let mut sources = Vec::new();
        let mut is_source = alloc::filled(false, self.split.vertices[self.chart].len())?;
        if loops.is_empty() {
            alloc::push(&mut sources, first)?;
        }
        let mut loop_of = alloc::filled(NONE, is_source.len())?;
        for (k, border) in (0..).zip(&loops) {
            border.iter().for_each(|&v| loop_of[(v - first) as usize] = k);
        }
        let add = |vertices: &[u32], sources: &mut Vec<u32>, is_source: &mut [bool]| {
            for &v in vertices {
                if !std::mem::replace(&mut is_source[(v - first) as usize], true) {
                    alloc::push(sources, v)?;
                }
            }
            Ok(())
        };
        if let Some(border) = loops.first() {
            add(border, &mut sources, &mut is_source)?;
        }
        let mut paths = Vec::new();
        for _ in 1..loops.len() {
            let is_other = |v: u32| loop_of[(v - first) as usize] != NONE && !is_source[(v - first) as usize];
            let Some(end) = self.search.search_nearest_target(self.graph, &sources, is_other, job)? else {
                break;
            };
            let path = self.search.path_half_edges(end)?;
            for &h in &path {
                let ends = self.ends_in_split_surface(surface, h);
                add(&ends, &mut sources, &mut is_source)?;
            }
            add(&loops[loop_of[(end - first) as usize] as usize], &mut sources, &mut is_source)?;
            alloc::append(&mut paths, &path)?;
        }
        for h in paths {
            surface.cut_edge(h, CutKind::Opening)?;
        }
        let handles = (2 - loops.len() as i64 - self.split.euler[self.chart]) / 2;
        if handles > 0 {
            return self.cut_handles(surface, &sources, job);
        }
        if loops.is_empty() {
            // A sphere: cut along a path as long as possible.
            let start = self.farthest_vertex(&sources, job)?;
            let end = self.farthest_vertex(&[start], job)?;
            let path = self.search.path_half_edges(end)?;
            for &h in &path {
                surface.cut_edge(h, CutKind::Opening)?;
            }
            // A single edge has equal ends on both sides, and does not open the sphere.
            return if path.len() == 1 { self.extend_slit(surface, [start, end]) } else { Ok(()) };
        }
        match loops.as_slice() {
            [ends] if self.split.border[self.chart] < 3 => self.extend_slit(surface, [ends[0], ends[ends.len() - 1]]),
            _ => Ok(()),
        }
    }

    fn ends_in_split_surface(&self, surface: &CutSurface<'_, '_>, h: u32) -> [u32; 2] {
        [h, surface.mesh.faces().next(h)].map(|h| self.split.corners[h as usize])
    }

    fn chart_half_edges(&self, surface: &CutSurface<'_, '_>) -> impl Iterator<Item = u32> + Clone {
        let faces = *surface.mesh.faces();
        self.split.faces.get(self.chart).iter().flat_map(move |&f| faces.corner_range(f as usize)).map(|h| h as u32)
    }

    /// Returns the vertices of each connected part of the chart's border, ascending, not in the
    /// order along the loop.
    fn border_loops(&self, surface: &CutSurface<'_, '_>, job: &Job<'_>) -> Result<Vec<Vec<u32>>> {
        let vertices = self.split.vertices[self.chart].clone();
        let (first, count) = (vertices.start, vertices.len());
        let mut sets = DisjointSets::new(count)?;
        let mut on_border = alloc::filled(false, count)?;
        for (k, h) in self.chart_half_edges(surface).enumerate() {
            job.step_within_list(k, STAGE)?;
            if surface.mate_across(h) != NONE {
                continue;
            }
            let [u, v] = self.ends_in_split_surface(surface, h).map(|v| v - first);
            sets.union(u, v);
            (on_border[u as usize], on_border[v as usize]) = (true, true);
        }
        let roots = sets.into_roots(job, STAGE)?;
        let members = (0..count).filter(|&v| on_border[v]).map(|v| (roots[v] as usize, first + v as u32));
        let members = Buckets::new_cancellable(count, 0u32, members, job, STAGE)?;
        let loops = (0..count).map(|root| members.get(root)).filter(|members| !members.is_empty());
        alloc::try_collect(loops.map(alloc::copied))
    }

    /// Returns the vertex of the chart that is farthest from all sources. It is not a source, even
    /// if all vertices lie in one point.
    fn farthest_vertex(&mut self, sources: &[u32], job: &Job<'_>) -> Result<u32> {
        self.search.search_nearest_target(self.graph, sources, |_| false, job)?;
        let vertices = self.split.vertices[self.chart].clone();
        let is_farther = |v: u32, far: u32| {
            let [from, to] = [far, v].map(|v| self.search.distances[v as usize]);
            to > from || (to == from && self.search.is_source(far) && !self.search.is_source(v))
        };
        Ok(vertices.clone().fold(vertices.start, |far, v| if is_farther(v, far) { v } else { far }))
    }

    /// Cuts along one more edge at an end of a slit.
    fn extend_slit(&self, surface: &mut CutSurface<'_, '_>, ends: [u32; 2]) -> Result<()> {
        let more = self.graph.neighbours(ends[1]).iter().find(|&&(v, ..)| !ends.contains(&v));
        more.map_or(Ok(()), |&(_, h, _)| surface.cut_edge(h, CutKind::Opening))
    }

    /// Cuts along the loops of the greedy system.
    fn cut_handles(&mut self, surface: &mut CutSurface<'_, '_>, sources: &[u32], job: &Job<'_>) -> Result<()> {
        self.search.search_nearest_target(self.graph, sources, |_| false, job)?;
        let faces = *surface.mesh.faces();
        let mut edges = Vec::new();
        for (k, h) in self.chart_half_edges(surface).enumerate() {
            job.step_within_list(k, STAGE)?;
            let mate = surface.mate_across(h);
            if mate == NONE || h > mate {
                continue;
            }
            let [u, v] = self.ends_in_split_surface(surface, h);
            let is_of_tree =
                [u, v].iter().any(|&v| self.search.path_ends_with(v, h) || self.search.path_ends_with(v, mate));
            if !is_of_tree {
                let length = self.search.distances[u as usize] + self.search.distances[v as usize];
                let [p, q] = surface.end_vertices(h).map(|v| surface.mesh.positions().get(v));
                alloc::push(&mut edges, (length + overflow_safe_distance(p, q), h))?;
            }
        }
        // Visit the edges of the longest loops first.
        sort(&mut edges, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)), job, STAGE)?;
        let mut joined = DisjointSets::new(faces.len())?;
        let mut cuts = Vec::new();
        for (k, (_, h)) in edges.into_iter().enumerate() {
            job.step_within_list(k, STAGE)?;
            if !joined.union(faces.face_of_half_edge(h), faces.face_of_half_edge(surface.mate_across(h))) {
                alloc::push(&mut cuts, h)?;
                for v in self.ends_in_split_surface(surface, h) {
                    alloc::append(&mut cuts, &self.search.path_half_edges(v)?)?;
                }
            }
        }
        for h in cuts {
            surface.cut_edge(h, CutKind::Opening)?;
        }
        Ok(())
    }
}
