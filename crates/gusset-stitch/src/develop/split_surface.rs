//! Charts: the connected components of a cut surface.

use super::STAGE;
use super::cut_edges::CutSurface;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::NONE;
use std::ops::Range;

/// A surface with its vertices split along cuts.
pub(super) struct SurfaceSplitAtCuts {
    /// For each corner, the vertex of the result, numbered chart by chart.
    pub(super) corners: Vec<u32>,
    /// For each vertex of the split surface, its vertex in the uncut surface.
    pub(super) vertex_map: Vec<u32>,
    /// For each face, its chart.
    pub(super) face_charts: Vec<u32>,
    /// The faces of each chart.
    pub(super) faces: Buckets<u32>,
    /// The vertices of each chart.
    pub(super) vertices: Vec<Range<u32>>,
    /// The Euler characteristic of each chart; 1 for a disc.
    pub(super) euler: Vec<i64>,
    /// The number of border edges of each chart.
    pub(super) border: Vec<u32>,
}

impl SurfaceSplitAtCuts {
    /// Returns true if a chart can be laid out: a disc with at least three border edges.
    pub(super) fn is_disc(&self, chart: usize) -> bool {
        self.euler[chart] == 1 && self.border[chart] >= 3
    }

    /// Splits a surface along its cuts. O(H).
    pub(super) fn new(surface: &CutSurface<'_, '_>, job: &Job<'_>) -> Result<SurfaceSplitAtCuts> {
        let job = &job.sub_job(0.0, 0.0);
        let faces = surface.mesh.faces();
        let (count, corner_count) = (faces.len(), faces.half_edge_count());
        // Corners share a vertex if their faces meet along an edge that is not cut.
        let mut same = DisjointSets::new(corner_count)?;
        let mut joined = DisjointSets::new(count)?;
        for h in 0..corner_count as u32 {
            job.step_within_list(h as usize, STAGE)?;
            let mate = surface.mate_across(h);
            if mate != NONE && h < mate {
                same.union(h, faces.next(mate));
                same.union(faces.next(h), mate);
                joined.union(faces.face_of_half_edge(h), faces.face_of_half_edge(mate));
            }
        }
        let roots = joined.into_roots(job, STAGE)?;
        let mut number = alloc::filled(NONE, count)?;
        let (mut face_charts, mut charts) = (alloc::with_capacity(count)?, 0);
        for &root in &roots {
            let chart = &mut number[root as usize];
            if *chart == NONE {
                *chart = charts;
                charts += 1;
            }
            face_charts.push(*chart);
        }
        let of_charts = face_charts.iter().zip(0..).map(|(&chart, f)| (chart as usize, f));
        let of_charts = Buckets::new_cancellable(charts as usize, 0u32, of_charts, job, STAGE)?;
        let same = same.into_roots(job, STAGE)?;
        let mut names = alloc::filled(NONE, corner_count)?;
        let (mut vertex_map, mut vertices) = (Vec::new(), alloc::with_capacity(charts as usize)?);
        let (mut euler, mut border) = (alloc::with_capacity(charts as usize)?, alloc::with_capacity(charts as usize)?);
        for chart in 0..charts as usize {
            let first = vertex_map.len() as u32;
            let (mut sum, mut free) = (0i64, 0);
            for &f in of_charts.get(chart) {
                job.step_within_list(f as usize, STAGE)?;
                sum += 1;
                for h in faces.corner_range(f as usize) {
                    let name = &mut names[same[h] as usize];
                    if *name == NONE {
                        *name = vertex_map.len() as u32;
                        alloc::push(&mut vertex_map, faces.corner(h as u32))?;
                    }
                    // Count an edge with two faces at its smaller half-edge.
                    let mate = surface.mate_across(h as u32);
                    sum -= i64::from(mate == NONE || (h as u32) < mate);
                    free += u32::from(mate == NONE);
                }
            }
            vertices.push(first..vertex_map.len() as u32);
            euler.push(sum + i64::from(vertex_map.len() as u32 - first));
            border.push(free);
        }
        let corners = alloc::collect(same.iter().map(|&root| names[root as usize]))?;
        Ok(SurfaceSplitAtCuts { corners, vertex_map, face_charts, faces: of_charts, vertices, euler, border })
    }
}
