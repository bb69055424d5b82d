//! The search for one opened polygon.

use super::super::Weight;
use super::super::chords::ChordSet;
use super::super::triangulation_cost::{CostEvaluator, CostNormalisation, TriangulationCost};
use super::super::triangulation_search::best_triangulation;
use super::numbered_rims::NumberedRims;
use super::opened_loops::OpenedLoops;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::Buckets;

/// Loops to be closed together, and the criteria.
pub(super) struct ClosingTask<'a> {
    pub(super) rims: &'a NumberedRims,
    pub(super) weight: Weight,
    pub(super) normalisation: CostNormalisation,
    /// Returns true if two vertices must not get an edge.
    pub(super) is_forbidden_edge: &'a dyn Fn(u32, u32) -> bool,
    /// False for thinned loops: of their edges, only bridges are sure to stay edges.
    pub(super) is_finest: bool,
}

/// How the search treats triangulations that repeat an edge.
pub(super) enum RepeatedEdgeTreatment<'a> {
    /// Searches without the first chord and without the second, this many times in all.
    Both(&'a mut usize),
    /// Searches with only one chord of each repeated pair, this many times.
    One(usize),
}

impl RepeatedEdgeTreatment<'_> {
    /// Returns the sets of chords to exclude next, in turn, if the chords `repeated` occur.
    fn next_exclusions(&mut self, without: &[[u32; 2]], repeated: &[[[u32; 2]; 2]]) -> Result<Vec<Vec<[u32; 2]>>> {
        let left = match self {
            RepeatedEdgeTreatment::Both(left) => left,
            RepeatedEdgeTreatment::One(left) => left,
        };
        if *left == 0 {
            return Ok(Vec::new());
        }
        *left -= 1;
        let with = |more: &mut dyn Iterator<Item = [u32; 2]>| {
            let mut all = alloc::copied(without)?;
            alloc::extend(&mut all, more)?;
            all.sort_unstable();
            Ok(all)
        };
        match self {
            RepeatedEdgeTreatment::Both(_) => {
                alloc::try_collect(repeated[0].iter().map(|&chord| with(&mut [chord].into_iter())))
            }
            RepeatedEdgeTreatment::One(_) => Ok(vec![with(&mut repeated.iter().map(|pair| pair[1]))?]),
        }
    }
}

/// A triangulation of loops that are cut open.
pub(super) struct OpenedLoopsTriangulation {
    pub(super) opened: OpenedLoops,
    /// Triples of places, ascending.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Includes the bends across the bridges.
    pub(super) cost: TriangulationCost,
}

impl ClosingTask<'_> {
    /// Returns true if `a` is less than `b` by the measure of these loops.
    pub(super) fn is_cheaper_by_loop_measure(&self, a: &TriangulationCost, b: &TriangulationCost) -> bool {
        CostEvaluator::for_opened_loops(&self.rims.all_vertices, self.weight, self.normalisation, &[]).is_cheaper(a, b)
    }

    /// Returns true if no chord may join the vertices.
    pub(super) fn forbids_chord(&self, u: u32, v: u32) -> bool {
        u == v
            || self.rims.is_rim_edge(u, v)
            || (self.is_finest || self.rims.joins_two_loops(u, v)) && (self.is_forbidden_edge)(u, v)
    }

    /// Returns the best triangulation without repeated edges, and without chords between `excluded`
    /// vertices, that costs less than `limit`.
    pub(super) fn search_polygon(
        &self,
        opened: OpenedLoops,
        chords: &impl ChordSet,
        excluded: &dyn Fn(u32, u32) -> bool,
        limit: Option<&TriangulationCost>,
        mut repeats: RepeatedEdgeTreatment<'_>,
        job: &Job<'_>,
    ) -> Result<Option<OpenedLoopsTriangulation>> {
        let polygon = opened.build_polygon(self.rims)?;
        let scale = CostEvaluator::for_opened_loops(&polygon, self.weight, self.normalisation, &opened.is_bridge);
        let tree = opened.bridge_tree()?;
        let mut is_copied = alloc::filled(false, self.rims.vertex_count())?;
        tree.iter().flat_map(|(ends, _)| ends).for_each(|&v| is_copied[v as usize] = true);
        let is_bridge = |u: u32, v: u32| {
            is_copied[u as usize] && is_copied[v as usize] && {
                tree.binary_search_by_key(&[u.min(v), u.max(v)], |&(ends, _)| ends).is_ok()
            }
        };
        let mut best: Option<(Vec<[u32; 3]>, TriangulationCost)> = None;
        let mut open = vec![Vec::<[u32; 2]>::new()];
        while let Some(without) = open.pop() {
            let forbidden = |i: usize, k: usize| {
                let [u, v] = [i, k].map(|place| opened.vertex_at_place[place]);
                let is_out = || without.binary_search(&[i as u32, k as u32]).is_ok();
                self.forbids_chord(u, v) || is_bridge(u, v) || excluded(u, v) || is_out()
            };
            let least = best.as_ref().map(|(_, cost)| cost).or(limit);
            let Some(next) = best_triangulation(&scale, chords, &forbidden, least, job)? else {
                continue;
            };
            let repeated = opened.repeated_chords(&next.triangles, &is_copied)?;
            if !repeated.is_empty() {
                open.append(&mut repeats.next_exclusions(&without, &repeated)?);
                continue;
            }
            let cost = next.cost.plus(cost_of_bridge_bends(&scale, &tree, &next.triangles)?);
            if least.is_none_or(|least| scale.is_cheaper(&cost, least)) {
                best = Some((next.triangles, cost));
            }
        }
        Ok(best.map(|(triangles, cost)| OpenedLoopsTriangulation { opened, triangles, cost }))
    }

    /// Returns the cost of any triangles that close the loops, over the vertices of all loops.
    pub(super) fn cost_of_closing(&self, triangles: &[[u32; 3]]) -> Result<TriangulationCost> {
        let rims = self.rims;
        let scale = CostEvaluator::for_opened_loops(&rims.all_vertices, self.weight, self.normalisation, &[]);
        let sides = |&[a, b, c]: &[u32; 3]| [[b, c], [c, a], [a, b]];
        let bulge = |[u, v]: [u32; 2]| {
            if rims.is_rim_edge(u, v) { 0.0 } else { scale.bulge_of_any_chord([u as usize, v as usize]) }
        };
        let mut total = TriangulationCost::ZERO;
        let mut normals = alloc::with_capacity(triangles.len())?;
        for triangle in triangles {
            let [x, y, z] = sides(triangle).map(bulge);
            let (normal, own) = scale.triangle_cost(triangle.map(|v| v as usize), [z, x, y]);
            total = total.plus(own);
            normals.push(normal);
        }
        let each = triangles
            .iter()
            .zip(&normals)
            .flat_map(|(triangle, &normal)| sides(triangle).map(|[u, v]| (u.min(v) as usize, (u.max(v), normal))));
        let mut each = Buckets::new(rims.vertex_count(), (0, DVec3::ZERO), each)?;
        for u in 0..rims.vertex_count() as u32 {
            let sides = each.get_mut(u as usize);
            sort::sort_stable(sides, &|x, y| x.0.cmp(&y.0));
            for pair in sides.chunk_by(|a, b| a.0 == b.0) {
                let (v, normal) = pair[0];
                let from = if rims.next_vertex(u) == v { u } else { v };
                let beyond = if rims.is_rim_edge(u, v) {
                    rims.all_vertices.normals_across_edges[from as usize]
                } else {
                    pair[pair.len() - 1].1
                };
                total = total.plus(scale.bend_cost([u as usize, v as usize], normal, beyond));
            }
        }
        Ok(total)
    }
}

/// Returns the cost of the bends across bridges, which the search of the polygon does not see.
fn cost_of_bridge_bends(
    scale: &CostEvaluator<'_>,
    tree: &[([u32; 2], [usize; 2])],
    triangles: &[[u32; 3]],
) -> Result<TriangulationCost> {
    let points = &scale.polygon().points;
    let n = points.len() as u32;
    let passes = || tree.iter().flat_map(|(_, places)| places.iter().copied());
    let mut normals = alloc::filled(DVec3::ZERO, 2 * tree.len())?;
    for &[i, m, k] in triangles {
        // Look for sides that are edges of the polygon, and for their start.
        for (u, _) in [(i, m), (m, k), (k, i)].into_iter().filter(|&(u, v)| (u + 1) % n == v) {
            if let Some(at) = passes().position(|place| place == u as usize) {
                normals[at] = scale.triangle_cost([i, m, k].map(|v| v as usize), [0.0; 3]).0;
            }
        }
    }
    let pairs = tree.iter().zip(normals.chunks_exact(2));
    let bend = |(&(_, [p, _]), pair): (&([u32; 2], [usize; 2]), &[DVec3])| {
        scale.bend_cost([p, (p + 1) % points.len()], pair[0], pair[1])
    };
    Ok(pairs.map(bend).fold(TriangulationCost::ZERO, TriangulationCost::plus))
}
