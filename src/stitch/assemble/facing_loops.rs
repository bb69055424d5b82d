//! Loops that face each other across a gap.
//!
//! Each vertex of each loop finds the nearest vertex of another loop. Two loops are joined as
//! wholes if nearly all vertices of each have their nearest vertex on the other, and either their
//! distances are similar or these nearest vertices wind once round the other loop; seen from a loop
//! that lies beside another they run forth and back. Otherwise runs of neighbouring vertices whose
//! nearest vertices lie on one loop, mutually, form facing arcs, as at the border of two scans that
//! overlap others elsewhere.
//!
//! O(V log V) for V vertices, by a k-d tree over all loops; the criteria are ours.

use crate::alloc;
use crate::error::Result;
use crate::geom::kd_tree::KdTree;
use crate::job::Job;
use crate::mesh::NONE;
use crate::sort::sort_distinct;
use crate::stitch::facing::{Arc, centre, cyclic_runs};
use crate::stitch::polyline;
use crate::stitch::rim::Rim;
use glam::DVec3;

/// Share of each loop's vertices whose nearest vertex is on the other, for whole loops to be
/// joined.
const MIN_FACING_SHARE: f64 = 0.9;

/// Largest ratio of the ninth decile of the distances to the first one, or to the spacing.
const MAX_DISTANCE_RATIO: f64 = 4.0;

/// Largest gap between facing arcs, in mean edge lengths, unless one is given.
const MAX_ARC_GAP: f64 = 4.0;

const MIN_ARC_VERTICES: usize = 2;

/// Vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

/// Two loops, by their numbers, or arcs of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facing {
    pub(super) rims: [usize; 2],
    pub(super) arcs: Option<[Arc; 2]>,
    /// The mean distance from the vertices of one to the nearest of the other, the larger of the
    /// two means.
    pub(super) gap: f64,
}

/// Measures of a loop.
pub(super) struct Candidate {
    /// Pairs of one component are not looked for unless `within` says so.
    pub(super) component: u32,
    /// The mean distance of its vertices from their centre.
    radius: f64,
    /// The mean length of its edges.
    spacing: f64,
}

impl Candidate {
    pub(super) fn new(rim: &Rim, component: u32) -> Self {
        let middle = centre(&rim.points);
        let n = rim.points.len();
        let radius = rim.points.iter().map(|p| p.distance(middle)).sum::<f64>() / n as f64;
        let length = (0..n).map(|i| rim.points[i].distance(rim.points[(i + 1) % n])).sum::<f64>();
        Candidate { component, radius, spacing: length / n as f64 }
    }
}

pub(super) struct FacingSearch<'a> {
    pub(super) rims: &'a [Rim],
    pub(super) candidates: &'a [Candidate],
    /// Loops that are already joined.
    pub(super) used: &'a [bool],
    /// Pairs (smaller, larger) that are not wanted, in ascending order.
    pub(super) excluded: &'a [[u32; 2]],
    pub(super) within_components: bool,
    pub(super) arcs: bool,
    /// In the rims' unit; `None` for [`MaxGap::Auto`](super::MaxGap::Auto).
    pub(super) max_gap: Option<f64>,
}

/// Vertices of one loop whose nearest vertices lie on another.
struct LoopProximity {
    rims: [u32; 2],
    count: usize,
    mean: f64,
    /// Whether the distances are similar, or the nearest vertices wind once round the other loop.
    round: bool,
}

#[derive(Clone, Copy)]
struct NearestVertex {
    /// The loop, or [`NONE`].
    rim: u32,
    place: u32,
    distance: f64,
}

impl FacingSearch<'_> {
    /// The greatest distance between loops `r` and `k`, if they are joined as wholes.
    fn limit(&self, r: usize, k: usize) -> f64 {
        self.max_gap.unwrap_or(self.candidates[r].radius.min(self.candidates[k].radius))
    }

    /// The same for arcs of them.
    fn arc_limit(&self, r: usize, k: usize) -> f64 {
        let edges = MAX_ARC_GAP * self.candidates[r].spacing.max(self.candidates[k].spacing);
        self.max_gap.unwrap_or(edges.min(0.5 * self.limit(r, k)))
    }

    fn may_join(&self, r: usize, k: usize) -> bool {
        let [r, k] = [r.min(k), r.max(k)];
        !self.used[k]
            && (self.within_components || self.candidates[r].component != self.candidates[k].component)
            && self.excluded.binary_search(&[r as u32, k as u32]).is_err()
    }

    /// The pairs, nearest first. No loop is in two pairs of wholes; arcs do not overlap.
    ///
    /// O(V log V) for V vertices on loops that have others near them.
    pub(super) fn run(&self, job: &Job<'_>) -> Result<Vec<Facing>> {
        let nearest_vertices = self.nearest_vertices(job)?;
        let mut found = Vec::new();
        let mut whole = alloc::filled(false, self.rims.len())?;
        let proximities = self.proximities(&nearest_vertices)?;
        for proximity in &proximities {
            let [r, k] = proximity.rims.map(|rim| rim as usize);
            if r > k {
                continue;
            }
            let Ok(back) = proximities.binary_search_by_key(&[k as u32, r as u32], |proximity| proximity.rims) else {
                continue;
            };
            let back = &proximities[back];
            let most =
                |count: usize, rim: usize| count as f64 >= MIN_FACING_SHARE * self.rims[rim].vertices.len() as f64;
            let gap = proximity.mean.max(back.mean);
            if most(proximity.count, r)
                && most(back.count, k)
                && proximity.round
                && back.round
                && gap <= self.limit(r, k)
            {
                (whole[r], whole[k]) = (true, true);
                alloc::push(&mut found, Facing { rims: [r, k], arcs: None, gap })?;
            }
        }
        if self.arcs {
            self.find_arcs(&nearest_vertices, &whole, &mut found)?;
        }
        let first = |found: &Facing| found.arcs.map_or(0, |arcs| arcs[0].first);
        found.sort_unstable_by(|x, y| x.gap.total_cmp(&y.gap).then(x.rims.cmp(&y.rims)).then(first(x).cmp(&first(y))));
        Ok(found)
    }

    /// What each vertex of each loop looks at, within twice the limit.
    fn nearest_vertices(&self, job: &Job<'_>) -> Result<Vec<Vec<NearestVertex>>> {
        let total = self.rims.iter().map(|rim| rim.points.len()).sum();
        let (mut points, mut owners) = (alloc::with_capacity::<DVec3>(total)?, alloc::with_capacity(total)?);
        let mut firsts = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            firsts.push(points.len() as u32);
            points.extend(&rim.points);
            owners.extend(std::iter::repeat_n(r as u32, rim.points.len()));
        }
        // Of one component at a time nothing is looked for: whole parts of the tree are passed
        // over.
        let groups = alloc::collect(owners.iter().map(|&r| match self.within_components {
            true => r,
            false => self.candidates[r as usize].component,
        }))?;
        let tree = KdTree::grouped(&points, &groups)?;
        let mut nearest_vertices = alloc::with_capacity(self.rims.len())?;
        let mut done = 0;
        for (r, rim) in self.rims.iter().enumerate() {
            let mut of_rim = alloc::with_capacity(rim.points.len())?;
            let widest = self.max_gap.unwrap_or(self.candidates[r].radius);
            let own = groups[firsts[r] as usize];
            for &p in &rim.points {
                job.step_every(REPORT_INTERVAL, done, total, "looking for loops that face each other")?;
                done += 1;
                let limit = 4.0 * widest * widest;
                let accept = |v: u32| owners[v as usize] as usize != r && self.may_join(r, owners[v as usize] as usize);
                let nearest = if self.used[r] { None } else { tree.nearest_elsewhere(p, limit, own, accept) };
                of_rim.push(match nearest {
                    Some((squared, v)) => {
                        let k = owners[v as usize];
                        NearestVertex { rim: k, place: v - firsts[k as usize], distance: squared.sqrt() }
                    }
                    None => NearestVertex { rim: NONE, place: NONE, distance: f64::INFINITY },
                });
            }
            nearest_vertices.push(of_rim);
        }
        Ok(nearest_vertices)
    }

    /// What each loop sees of each other one, in ascending order of the loops.
    fn proximities(&self, nearest_vertices: &[Vec<NearestVertex>]) -> Result<Vec<LoopProximity>> {
        let lengths = alloc::try_collect(self.rims.iter().map(|rim| polyline::lengths(&rim.points, true)))?;
        let mut proximities = Vec::new();
        for (r, of_rim) in nearest_vertices.iter().enumerate() {
            let mut pairs = alloc::collect(of_rim.iter().enumerate().map(|(i, look)| (look.rim, i as u32)))?;
            pairs.retain(|&(k, _)| k != NONE);
            pairs.sort_unstable();
            for group in pairs.chunk_by(|x, y| x.0 == y.0) {
                let mut distances = alloc::collect(group.iter().map(|&(_, i)| of_rim[i as usize].distance))?;
                let mean = distances.iter().sum::<f64>() / group.len() as f64;
                distances.sort_unstable_by(f64::total_cmp);
                let [low, high] = [1, 9].map(|tenth| distances[(distances.len() - 1) * tenth / 10]);
                let even = high <= MAX_DISTANCE_RATIO * low.max(self.candidates[r].spacing);
                let k = group[0].0 as usize;
                let round = even || winds_once(&lengths[k], group.iter().map(|&(_, i)| of_rim[i as usize].place));
                let rims = [r as u32, group[0].0];
                alloc::push(&mut proximities, LoopProximity { rims, count: group.len(), mean, round })?;
            }
        }
        Ok(proximities)
    }

    /// Adds the arcs that face each other of loops that are not joined as wholes.
    fn find_arcs(
        &self,
        nearest_vertices: &[Vec<NearestVertex>],
        whole: &[bool],
        found: &mut Vec<Facing>,
    ) -> Result<()> {
        let near = |r: usize, look: &NearestVertex| {
            look.rim != NONE
                && look.distance <= self.arc_limit(r, look.rim as usize)
                && !whole[r]
                && !whole[look.rim as usize]
        };
        // A vertex sees another loop if that looks back at its loop, and not at a part of it that
        // is far nearer.
        let sees = |r: usize, look: &NearestVertex| {
            near(r, look) && {
                let k = look.rim as usize;
                let back = nearest_vertices[k][look.place as usize];
                let spacing = self.candidates[r].spacing.max(self.candidates[k].spacing);
                near(k, &back) && back.rim as usize == r && look.distance <= 2.0 * back.distance + spacing
            }
        };
        // (loop, loop it faces, arc), and for each vertex the number of its arc.
        let mut arcs: Vec<(usize, usize, Arc)> = Vec::new();
        let mut of_vertex = alloc::with_capacity(nearest_vertices.len())?;
        for (r, of_rim) in nearest_vertices.iter().enumerate() {
            let mut numbers = alloc::filled(NONE, of_rim.len())?;
            let mut faced = alloc::collect(of_rim.iter().map(|look| if sees(r, look) { look.rim } else { NONE }))?;
            sort_distinct(&mut faced);
            for &k in faced.iter().filter(|&&k| k != NONE) {
                for arc in cyclic_runs(of_rim, |look| look.rim == k && sees(r, look))? {
                    let arc = trimmed(arc, of_rim);
                    if arc.count >= MIN_ARC_VERTICES && arc.count < of_rim.len() {
                        arc.places(of_rim.len()).for_each(|i| numbers[i] = arcs.len() as u32);
                        alloc::push(&mut arcs, (r, k as usize, arc))?;
                    }
                }
            }
            of_vertex.push(numbers);
        }
        // Each arc faces the one that holds most of its nearest vertices; arcs that face each other
        // are joined.
        let partner = |&(r, k, arc): &(usize, usize, Arc)| -> Result<(u32, f64)> {
            let mut facing = alloc::with_capacity(arc.count)?;
            let places = arc.places(nearest_vertices[r].len());
            facing.extend(places.clone().map(|i| of_vertex[k][nearest_vertices[r][i].place as usize]));
            facing.sort_unstable();
            let groups = facing.chunk_by(|x, y| x == y).filter(|group| group[0] != NONE);
            let most = groups.rev().max_by_key(|group| group.len()).map_or(NONE, |group| group[0]);
            Ok((most, places.map(|i| nearest_vertices[r][i].distance).sum::<f64>() / arc.count as f64))
        };
        let partners = alloc::try_collect(arcs.iter().map(partner))?;
        for (x, &(y, gap)) in partners.iter().enumerate() {
            if y != NONE && x < y as usize && partners[y as usize].0 as usize == x {
                let (first, second) = (arcs[x], arcs[y as usize]);
                let gap = gap.max(partners[y as usize].1);
                alloc::push(found, Facing { rims: [first.0, second.0], arcs: Some([first.2, second.2]), gap })?;
            }
        }
        Ok(())
    }
}

/// Trims end vertices that share their nearest vertex with their neighbour, from farther away: they
/// look back at a corner.
fn trimmed(arc: Arc, nearest_vertices: &[NearestVertex]) -> Arc {
    let look = |i: usize| &nearest_vertices[(arc.first + i) % nearest_vertices.len()];
    let (mut first, mut last) = (0, arc.count.saturating_sub(1));
    let behind = |i: usize, next: usize| look(i).place == look(next).place && look(i).distance > look(next).distance;
    while first < last && behind(first, first + 1) {
        first += 1;
    }
    while first < last && behind(last, last - 1) {
        last -= 1;
    }
    Arc { first: (arc.first + first) % nearest_vertices.len(), count: last + 1 - first }
}

/// Whether some places in order go round a rim of these lengths once, each next one reached the
/// shorter way.
fn winds_once(lengths: &[f64], places: impl Iterator<Item = u32> + Clone) -> bool {
    let around = lengths.last().copied().unwrap_or_default();
    let at = |place: u32| lengths[place as usize];
    let shorter = |by: f64| by - around * (by / around).round();
    let next = places.clone().cycle().skip(1);
    let turned: f64 = places.zip(next).map(|(from, to)| shorter(at(to) - at(from))).sum();
    around > 0.0 && (turned.abs() / around - 1.0).abs() < 0.5
}
