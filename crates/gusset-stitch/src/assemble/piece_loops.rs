//! The boundary loops of the combined pieces.

use super::assemble_request::{LeftLoop, MaxGap, Options, Reason, Selector};
use super::candidates::{FacingLoops, FacingSearch, LoopMeasures, STAGE, SlitLoop};
use super::given_pair::GivenLoopPair;
use super::loop_edges::{LoopEdges, entries_of_vertex};
use crate::boundary::{self, Boundary, boundary_loops};
use crate::stitch::IndexMap;
use crate::stitch::stitch_rim::{Rim, is_usable};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{Mesh, NONE, vertex_components};

/// A seam between two loops of one component is at least this many times as long as wide.
const MIN_SEAM_ASPECT_RATIO: f64 = 10.0;
/// Number of loops between two progress reports.
const LOOPS_PER_REPORT: usize = 1 << 12;

/// The boundary loops of the combined pieces: loops that can carry a strip, and others.
pub(super) struct PieceLoops {
    pub(super) rims: Vec<Rim>,
    pub(super) candidates: Vec<LoopMeasures>,
    pub(super) components: DisjointSets,
    /// The sides of each loop that is a slit.
    pub(super) slits: Vec<Option<SlitLoop>>,
    /// The loops that cannot carry a strip, with the reason.
    pub(super) loops_without_strip: Vec<LeftLoop>,
    /// The unit of the rims' points.
    pub(super) unit: f64,
    /// The number of vertices of the mesh.
    vertex_count: usize,
}

impl PieceLoops {
    /// Finds the loops of `mesh`. `piece` has the first piece of each vertex, and `seam` the
    /// vertices that sewing merged, ascending.
    pub(super) fn new(mesh: &Mesh, piece: &[u32], seam: &[u32], job: &Job<'_>) -> Result<Self> {
        let mut loops = PieceLoops {
            rims: Vec::new(),
            candidates: Vec::new(),
            components: DisjointSets::default(),
            slits: Vec::new(),
            loops_without_strip: Vec::new(),
            unit: 1.0,
            vertex_count: mesh.positions.len(),
        };
        if mesh.face_count() == 0 {
            return Ok(loops);
        }
        let view = mesh.view(&job.sub_job(0.0, 0.3))?;
        let boundary: Boundary = boundary_loops(&view, &boundary::Options::default(), &job.sub_job(0.3, 1.0))?;
        job.step(1.0, STAGE)?;
        loops.components = vertex_components(&view)?;
        for (number, found) in boundary.iter().enumerate() {
            job.sub_job(1.0, 1.0).step_every(LOOPS_PER_REPORT, number, boundary.len(), STAGE)?;
            if is_usable(&found) {
                alloc::push(&mut loops.rims, Rim::from_loop(&view, &found)?)?;
            } else {
                let reason = if found.vertices.len() < 3 { Reason::TooShort } else { Reason::NotSimple };
                alloc::push(
                    &mut loops.loops_without_strip,
                    LeftLoop {
                        vertices: alloc::copied(found.vertices)?,
                        origin: [NONE; 2],
                        reason,
                        gap: f64::INFINITY,
                        allowed_gap: 0.0,
                        filled: false,
                    },
                )?;
            }
        }
        loops.unit = common_unit(loops.rims.iter().flat_map(|rim| &rim.points));
        let sizes = component_sizes(mesh, &mut loops.components, &loops.rims)?;
        for ((rim, size), found) in loops.rims.iter_mut().zip(sizes).zip(boundary.iter().filter(is_usable)) {
            rim.points.iter_mut().for_each(|p| *p /= loops.unit);
            alloc::push(
                &mut loops.slits,
                SlitLoop::find_in_loop(&view, &found, rim, loops.unit, seam, &job.sub_job(1.0, 1.0))?,
            )?;
            let component = loops.components.find(rim.vertices[0]);
            let piece = piece[rim.vertices[0] as usize];
            alloc::push(&mut loops.candidates, LoopMeasures::new(rim, component, piece, size / loops.unit))?;
        }
        Ok(loops)
    }

    /// Returns the two loops, or arcs of them, each with its surface on the left.
    pub(super) fn facing_sides(&self, facing: &FacingLoops) -> Result<[Rim; 2]> {
        let [r, k] = facing.rims;
        let (mut a, mut b) = (self.rims[r].try_clone()?, self.rims[k].try_clone()?);
        if let Some([arc_a, arc_b]) = facing.arcs {
            a.cut_to_arc(arc_a)?;
            b.cut_to_arc(arc_b)?;
        }
        Ok([a, b])
    }

    /// Returns true if the loops belong to two components, or if both sides are much longer than
    /// the gap is wide. This is the shape of a gap in a seam. A strip between two holes side by
    /// side would instead create a handle.
    pub(super) fn is_seam(&self, facing: &FacingLoops) -> bool {
        let [a, b] = facing.rims.map(|r| self.candidates[r].component);
        a != b
            || (0..2).all(|side| {
                let own = &self.candidates[facing.rims[side]];
                let vertices = facing.arcs.map_or(self.rims[facing.rims[side]].vertices.len(), |arcs| arcs[side].count);
                vertices as f64 * own.mean_edge_length >= MIN_SEAM_ASPECT_RATIO * facing.mean_gap
            })
    }

    /// Returns the mesh's edges between vertices of rims. A vertex may lie on several rims.
    pub(super) fn edges_between_rims(&self, mesh: &Mesh) -> Result<LoopEdges> {
        LoopEdges::new(mesh, self.vertex_loop_pairs()?)
    }

    pub(super) fn facing_search<'a>(
        &'a self,
        options: &Options<'_>,
        used: &'a [bool],
        excluded: &'a [[u32; 2]],
    ) -> FacingSearch<'a> {
        let max_gap = match options.max_gap {
            MaxGap::Given(gap) => Some(gap / self.unit),
            MaxGap::Auto => None,
        };
        FacingSearch {
            rims: &self.rims,
            candidates: &self.candidates,
            is_joined_loop: used,
            slits: &self.slits,
            excluded,
            within_components: options.within_components,
            extent: options.extent,
            max_gap,
            whole_loop_gap_factor: 1.0,
        }
    }

    /// Returns pairs of a vertex and a loop through it, in ascending order.
    pub(super) fn vertex_loop_pairs(&self) -> Result<Vec<(u32, u32)>> {
        let mut places = alloc::with_capacity(self.rims.iter().map(|rim| rim.vertices.len()).sum())?;
        for (rim, r) in self.rims.iter().zip(0u32..) {
            places.extend(rim.vertices.iter().map(|&v| (v, r)));
        }
        places.sort_unstable();
        Ok(places)
    }

    /// Returns the loops that a selector names, in ascending order. `maps` leads from the vertices
    /// of the pieces to the vertices of the mesh.
    pub(super) fn select_loops(
        &self,
        maps: &[IndexMap],
        places: &[(u32, u32)],
        selector: Selector,
    ) -> Result<Vec<usize>> {
        let Some(map) = maps.get(selector.piece as usize) else {
            return Ok(Vec::new());
        };
        if let Some(&vertex) = map.vertices.get(selector.vertex as usize) {
            return alloc::collect(entries_of_vertex(places, vertex).iter().map(|&(_, r)| r as usize));
        }
        if selector.vertex != NONE {
            return Ok(Vec::new());
        }
        let mut of_piece = alloc::filled(false, self.vertex_count)?;
        map.vertices.iter().filter(|&&v| v != NONE).for_each(|&v| of_piece[v as usize] = true);
        let has_one = |&r: &usize| self.rims[r].vertices.iter().any(|&v| of_piece[v as usize]);
        alloc::gather((0..self.rims.len()).filter(has_one))
    }

    /// Returns the excluded pairs of loops (smaller, larger), in ascending order.
    pub(super) fn list_excluded_pairs(&self, maps: &[IndexMap], options: &Options<'_>) -> Result<Vec<[u32; 2]>> {
        let places = self.vertex_loop_pairs()?;
        let mut excluded = Vec::new();
        for (k, pair) in options.excluded.iter().enumerate() {
            GivenLoopPair { option: "excluded", pair_index: k as u32, pair }.check_pieces_and_vertices_exist(maps)?;
            let [first, second] =
                [self.select_loops(maps, &places, pair[0])?, self.select_loops(maps, &places, pair[1])?];
            let pairs = first.iter().flat_map(|&r| second.iter().map(move |&s| [r.min(s) as u32, r.max(s) as u32]));
            alloc::extend(&mut excluded, pairs)?;
        }
        excluded.sort_unstable();
        Ok(excluded)
    }
}

/// Returns for each rim the largest extent of its component along an axis.
fn component_sizes(mesh: &Mesh, components: &mut DisjointSets, rims: &[Rim]) -> Result<Vec<f64>> {
    let of_rims = alloc::collect(rims.iter().map(|rim| components.find(rim.vertices[0])))?;
    let mut roots = alloc::copied(&of_rims)?;
    sort_distinct(&mut roots);
    let mut boxes = alloc::filled(Aabb::EMPTY, roots.len())?;
    for v in 0..mesh.positions.len() as u32 {
        if let Ok(place) = roots.binary_search(&components.find(v)) {
            boxes[place].add(mesh.positions.get(v));
        }
    }
    alloc::collect(of_rims.iter().map(|&root| boxes[roots.partition_point(|&other| other < root)].size().max_element()))
}
