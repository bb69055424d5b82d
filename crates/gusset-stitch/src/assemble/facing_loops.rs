//! Search for loops that face each other across a gap.
//!
//! Whole loops that face each other are joined first (`whole_loops`). On the other loops, arcs are
//! runs of neighbouring vertices whose nearest vertices lie on one loop, and conversely. Their
//! distances are measured to the edges at these vertices, so that the spacing of the vertices does
//! not count. Arcs occur at the border of two scans that overlap others elsewhere. The only two loops, of two pieces, are
//! joined at any distance, like in [`stitch()`](crate::stitch::stitch()), unless they lie beside
//! each other: a strip would then close a pocket between two sheets.
//!
//! O(V log V) for V vertices, by a k-d tree over all loops. The criteria are our own.

use super::assemble_request::Extent;
use super::candidates::{FacingLoops, FacingSearch, LoopVertices, LoopVisitCounter, STAGE};
use super::whole_loops::{NearestLoopShare, add_nearest_loop_shares, rim_conormals};
use crate::stitch::facing::{Arc, cyclic_runs};
use crate::stitch::loop_pairing::mean_gap;
use crate::stitch::polyline::nearest_point_on_adjacent_edges;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::NONE;

/// Largest gap between facing arcs, in mean edge lengths, unless the caller sets a limit.
const MAX_ARC_GAP_MEAN_EDGES: f64 = 4.0;

const MIN_ARC_VERTICES: usize = 2;

/// An arc has at least this fraction of its loop's vertices.
const MIN_ARC_VERTEX_SHARE: f64 = 1.0 / 64.0;

/// Smallest sum of the looks of two arcs at each other. It excludes tubes side by side.
const MIN_FACING_COSINE_SUM_OF_ARCS: f64 = 0.3;

/// Distances are equal up to rounding if their ratio is at most this.
const MAX_EQUAL_DISTANCE_RATIO: f64 = 1.0 + 1e-9;

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 12;

#[derive(Clone, Copy)]
struct NearestLoopVertex {
    /// The loop, or [`NONE`].
    rim: u32,
    index_on_rim: u32,
    /// The vector to the nearest point on the edges at that vertex, and its length. The distance to
    /// the vertex itself would grow with the spacing of the vertices.
    way: DVec3,
    distance: f64,
}

impl FacingSearch<'_> {
    /// Returns the largest gap between arcs of loops `r` and `k`.
    fn max_arc_gap(&self, r: usize, k: usize) -> f64 {
        let [r, k] = [&self.candidates[r], &self.candidates[k]];
        self.max_gap.unwrap_or(
            (MAX_ARC_GAP_MEAN_EDGES * r.mean_edge_length.max(k.mean_edge_length))
                .min(0.5 * r.mean_radius.min(k.mean_radius)),
        )
    }

    /// Returns the pairs in no particular order. No loop belongs to two pairs of whole loops, and
    /// arcs do not overlap.
    ///
    /// O(V log V) for V vertices on loops that have others near them.
    pub(super) fn find_facing_loops(&self, job: &Job<'_>) -> Result<Vec<FacingLoops>> {
        let nearest_vertices = self.find_nearest_loop_vertices(&job.sub_job(0.0, 0.3))?;
        let mut found = match self.extent {
            Extent::Parts => Vec::new(),
            _ => self.pair_whole_loops(&shares_of_nearest_loops(&nearest_vertices)?, &job.sub_job(0.3, 1.0))?,
        };
        let mut whole = alloc::filled(false, self.rims.len())?;
        found.iter().flat_map(|facing| facing.rims).for_each(|r| whole[r] = true);
        if self.extent != Extent::WholeLoops {
            self.add_facing_arcs(&nearest_vertices, &whole, &mut found)?;
        }
        if found.is_empty() && self.extent != Extent::Parts {
            alloc::extend(&mut found, self.pair_only_two_loops(&job.sub_job(1.0, 1.0))?)?;
        }
        Ok(found)
    }

    /// Returns the only two loops if they belong to two pieces and may be joined, and no limit is
    /// given.
    fn pair_only_two_loops(&self, job: &Job<'_>) -> Result<Option<FacingLoops>> {
        let of_two_pieces = self.rims.len() == 2 && self.candidates[0].piece != self.candidates[1].piece;
        if !of_two_pieces || self.max_gap.is_some() || self.is_joined_loop[0] || !self.may_join_loops(0, 1) {
            return Ok(None);
        }
        if self.lie_beside_each_other(0, 1, job)? {
            return Ok(None);
        }
        Ok(Some(FacingLoops { rims: [0, 1], arcs: None, mean_gap: mean_gap(&self.rims[0], &self.rims[1], job)? }))
    }

    /// Returns the nearest vertex of another loop for each vertex, within twice the limit of whole
    /// loops.
    fn find_nearest_loop_vertices(&self, job: &Job<'_>) -> Result<Vec<Vec<NearestLoopVertex>>> {
        let LoopVertices { points, loop_of_vertex: owners, groups, firsts } = self.collect_loop_vertices()?;
        let total = points.len();
        let tree = KdTree::with_groups(&points, &groups, &job.sub_job(0.0, 0.1), STAGE)?;
        let mut nearest_vertices = alloc::with_capacity(self.rims.len())?;
        let mut done = 0;
        let looks = LoopVisitCounter::default();
        for (r, rim) in self.rims.iter().enumerate() {
            let mut of_rim = alloc::with_capacity(rim.points.len())?;
            let widest = self.max_gap.unwrap_or(self.candidates[r].mean_radius);
            let own = groups[firsts[r] as usize];
            for &p in &rim.points {
                if done % VERTICES_PER_REPORT == 0 || looks.take_report_due() {
                    job.step(0.1 + 0.9 * done as f64 / total as f64, STAGE)?;
                }
                done += 1;
                let limit = 4.0 * widest * widest;
                let accept = |v: u32| {
                    looks.count_visit();
                    owners[v as usize] as usize != r && self.may_join_loops(r, owners[v as usize] as usize)
                };
                let nearest =
                    if self.is_joined_loop[r] { None } else { tree.nearest_in_other_groups(p, limit, own, accept) };
                of_rim.push(match nearest {
                    Some((_, v)) => {
                        let k = owners[v as usize];
                        let (index_on_rim, line) = (v - firsts[k as usize], &self.rims[k as usize].points);
                        let way = nearest_point_on_adjacent_edges(line, true, index_on_rim as usize, p) - p;
                        NearestLoopVertex { rim: k, index_on_rim, way, distance: way.length() }
                    }
                    None => {
                        NearestLoopVertex { rim: NONE, index_on_rim: NONE, way: DVec3::ZERO, distance: f64::INFINITY }
                    }
                });
            }
            nearest_vertices.push(of_rim);
        }
        Ok(nearest_vertices)
    }

    /// Adds facing arcs of loops that are not joined as whole loops.
    fn add_facing_arcs(
        &self,
        nearest_vertices: &[Vec<NearestLoopVertex>],
        whole: &[bool],
        found: &mut Vec<FacingLoops>,
    ) -> Result<()> {
        let near = |r: usize, look: &NearestLoopVertex| {
            look.rim != NONE
                && look.distance <= self.max_arc_gap(r, look.rim as usize)
                && !whole[r]
                && !whole[look.rim as usize]
        };
        // A vertex sees another loop if its nearest vertex there looks back at the vertex's loop,
        // and not at a much nearer part of it.
        let sees = |r: usize, look: &NearestLoopVertex| {
            near(r, look) && {
                let k = look.rim as usize;
                let back = nearest_vertices[k][look.index_on_rim as usize];
                let spacing = self.candidates[r].mean_edge_length.max(self.candidates[k].mean_edge_length);
                near(k, &back) && back.rim as usize == r && look.distance <= 2.0 * back.distance + spacing
            }
        };
        // (Loop, loop it faces, arc), and for each vertex the index of its arc.
        let mut arcs: Vec<(usize, usize, Arc)> = Vec::new();
        let mut of_vertex = alloc::with_capacity(nearest_vertices.len())?;
        for (r, of_rim) in nearest_vertices.iter().enumerate() {
            let mut numbers = alloc::filled(NONE, of_rim.len())?;
            let mut faced = alloc::collect(of_rim.iter().map(|look| if sees(r, look) { look.rim } else { NONE }))?;
            sort_distinct(&mut faced);
            for &k in faced.iter().filter(|&&k| k != NONE) {
                for arc in cyclic_runs(of_rim, |look| look.rim == k && sees(r, look))? {
                    let arc = trim_arc_ends(arc, of_rim);
                    let least = MIN_ARC_VERTICES.max((MIN_ARC_VERTEX_SHARE * of_rim.len() as f64).ceil() as usize);
                    if arc.count >= least && arc.count < of_rim.len() {
                        arc.places(of_rim.len()).for_each(|i| numbers[i] = arcs.len() as u32);
                        alloc::push(&mut arcs, (r, k as usize, arc))?;
                    }
                }
            }
            of_vertex.push(numbers);
        }
        // Each arc faces the arc with most of its nearest vertices. Arcs that face each other are
        // joined.
        let partner = |&(r, k, arc): &(usize, usize, Arc)| -> Result<(u32, f64)> {
            let mut facing = alloc::with_capacity(arc.count)?;
            let places = arc.places(nearest_vertices[r].len());
            facing.extend(places.clone().map(|i| of_vertex[k][nearest_vertices[r][i].index_on_rim as usize]));
            facing.sort_unstable();
            let groups = facing.chunk_by(|x, y| x == y).filter(|group| group[0] != NONE);
            let most = groups.rev().max_by_key(|group| group.len()).map_or(NONE, |group| group[0]);
            Ok((most, places.map(|i| nearest_vertices[r][i].distance).sum::<f64>() / arc.count as f64))
        };
        let partners = alloc::try_collect(arcs.iter().map(partner))?;
        let conormals = alloc::try_collect(self.rims.iter().map(rim_conormals))?;
        let look = |&(r, _, arc): &(usize, usize, Arc)| {
            let cosine = |i: usize| {
                let NearestLoopVertex { way, distance, .. } = nearest_vertices[r][i];
                if distance == 0.0 { 1.0 } else { way.dot(conormals[r][i]) / distance }
            };
            arc.places(nearest_vertices[r].len()).map(cosine).sum::<f64>() / arc.count as f64
        };
        for (x, &(y, gap)) in partners.iter().enumerate() {
            if y != NONE && x < y as usize && partners[y as usize].0 as usize == x {
                let (first, second) = (arcs[x], arcs[y as usize]);
                if look(&first) + look(&second) < MIN_FACING_COSINE_SUM_OF_ARCS {
                    continue;
                }
                let gap = gap.max(partners[y as usize].1);
                alloc::push(
                    found,
                    FacingLoops { rims: [first.0, second.0], arcs: Some([first.2, second.2]), mean_gap: gap },
                )?;
            }
        }
        Ok(())
    }
}

/// Removes vertices that lie round a corner from the ends of an arc. A vertex there has the same
/// nearest vertex as the next vertex inwards, but is farther from it.
fn trim_arc_ends(arc: Arc, nearest_vertices: &[NearestLoopVertex]) -> Arc {
    let look = |i: usize| &nearest_vertices[(arc.first + i) % nearest_vertices.len()];
    let (mut first, mut last) = (0, arc.count.saturating_sub(1));
    let behind = |i: usize, next: usize| {
        look(i).index_on_rim == look(next).index_on_rim
            && look(i).distance > MAX_EQUAL_DISTANCE_RATIO * look(next).distance
    };
    while first < last && behind(first, first + 1) {
        first += 1;
    }
    while first < last && behind(last, last - 1) {
        last -= 1;
    }
    Arc { first: (arc.first + first) % nearest_vertices.len(), count: last + 1 - first }
}

/// Returns the loops with the nearest vertices of each loop, in ascending order.
fn shares_of_nearest_loops(nearest_vertices: &[Vec<NearestLoopVertex>]) -> Result<Vec<NearestLoopShare>> {
    let mut seen = Vec::new();
    for (of_rim, r) in nearest_vertices.iter().zip(0u32..) {
        let others = alloc::gather(of_rim.iter().map(|nearest| nearest.rim).filter(|&k| k != NONE))?;
        add_nearest_loop_shares(r, others, of_rim.len(), &mut seen)?;
    }
    Ok(seen)
}
