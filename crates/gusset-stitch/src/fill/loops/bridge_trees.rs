//! Exact search over all trees of bridges, for few vertices.
//!
//! Every triangulation has one shortest tree of bridges, which Prim's algorithm grows from its
//! shortest bridge. With the bridges ordered by length, each step excludes all bridges that are
//! shorter than the chosen one and would join the same two sets of loops. So each triangulation
//! occurs only once, and longer bridges leave fewer chords to try.

use super::super::chords::AllChords;
use super::super::triangulation_cost::TriangulationCost;
use super::closing_task::{ClosingTask, OpenedLoopsTriangulation, RepeatedEdgeTreatment};
use super::numbered_rims::NumberedRims;
use super::opened_loops::OpenedLoops;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// Largest number of triangles that a search may examine; takes about 50 ms.
pub(super) const MAX_EXAMINED_TRIANGLES: f64 = 4e6;

/// Estimates the number of triangles to examine for loops of these lengths; infinite for more than
/// three loops.
pub(super) fn estimate_search_work(lengths: impl Iterator<Item = usize> + Clone) -> f64 {
    let loops = lengths.clone().count();
    let count: usize = lengths.clone().sum();
    let squares: usize = lengths.map(|n| n * n).sum();
    let bridges = (count * count - squares) as f64 / 2.0;
    let trees = match loops {
        2 => bridges,
        3 => bridges * bridges / 3.0,
        _ => f64::INFINITY,
    };
    trees * estimate_polygon_work(count + 2 * loops - 2)
}

/// Estimates the number of triangles to examine for one polygon with n vertices.
pub(super) fn estimate_polygon_work(n: usize) -> f64 {
    (n as f64).powi(3) / 6.0
}

/// The bridges sorted by length, and the rank of each.
struct SortedBridges {
    /// The ends of each bridge, the smaller first.
    sorted: Vec<[u32; 2]>,
    /// The rank of the bridge (u, v) is at index u n + v, for n vertices.
    rank_by_vertex_pair: Vec<u32>,
}

impl SortedBridges {
    fn new(task: &ClosingTask<'_>) -> Result<SortedBridges> {
        let n = task.rims.vertex_count() as u32;
        let pairs = (0..n).flat_map(|u| (u + 1..n).map(move |v| [u, v]));
        let mut sorted =
            alloc::gather(pairs.filter(|&[u, v]| task.rims.joins_two_loops(u, v) && !(task.is_forbidden_edge)(u, v)))?;
        let squared = |[u, v]: [u32; 2]| task.rims.squared_distance(u, v);
        sort::sort_stable(&mut sorted, &|&x, &y| squared(x).total_cmp(&squared(y)).then(x.cmp(&y)));
        let mut rank = alloc::filled(0, (n * n) as usize)?;
        for (&[u, v], at) in sorted.iter().zip(0..) {
            rank[(u * n + v) as usize] = at;
            rank[(v * n + u) as usize] = at;
        }
        Ok(SortedBridges { sorted, rank_by_vertex_pair: rank })
    }

    fn rank_of_bridge(&self, rims: &NumberedRims, u: u32, v: u32) -> u32 {
        self.rank_by_vertex_pair[u as usize * rims.vertex_count() + v as usize]
    }
}

/// Some loops joined by a tree of bridges.
struct PartialTree {
    opened: OpenedLoops,
    is_joined: Vec<bool>,
    /// At index i k + j, for k loops: the least rank that a bridge between the loops i and j may
    /// have.
    least_rank_by_loop_pair: Vec<u32>,
}

impl PartialTree {
    /// Returns the branch extended by one loop, joined at `place` to its vertex `v` by the bridge
    /// of this rank.
    fn extended_by_loop(&self, rims: &NumberedRims, place: usize, v: u32, rank: u32) -> Result<PartialTree> {
        let ring = rims.loop_of_vertex[v as usize] as usize;
        let (mut is_joined, mut least) =
            (alloc::copied(&self.is_joined)?, alloc::copied(&self.least_rank_by_loop_pair)?);
        let k = is_joined.len();
        for (i, j) in (0..k).flat_map(|i| (0..k).map(move |j| (i, j))) {
            if is_joined[i] != is_joined[j] {
                least[i * k + j] = least[i * k + j].max(rank);
            }
        }
        is_joined[ring] = true;
        Ok(PartialTree {
            opened: self.opened.extended_by_loop(place, rims.loop_vertices(ring), v)?,
            is_joined,
            least_rank_by_loop_pair: least,
        })
    }
}

struct BridgeTreeSearch<'a> {
    task: &'a ClosingTask<'a>,
    bridges: SortedBridges,
    best_triangulation: Option<OpenedLoopsTriangulation>,
    /// Triangulations that cost no less than this are skipped.
    cost_limit: Option<TriangulationCost>,
    repeated_searches_left: usize,
}

/// Returns the number of additional polygon searches, for repeated edges, that double the work.
pub(super) fn max_repeated_searches(rims: &NumberedRims) -> usize {
    (MAX_EXAMINED_TRIANGLES / estimate_polygon_work(rims.vertex_count() + 2 * rims.loop_count() - 2)) as usize
}

/// Returns the best triangulation that costs less than `cost_limit`, over all trees of bridges.
///
/// By area it is optimal, unless edges repeat in more searches than `max_repeated_searches`. Bends and bulges are
/// treated as in the search of a single loop. O(t n^3) for t trees.
pub(super) fn best_triangulation_over_trees(
    task: &ClosingTask<'_>,
    cost_limit: Option<TriangulationCost>,
    max_repeated_searches: usize,
    job: &Job<'_>,
) -> Result<Option<OpenedLoopsTriangulation>> {
    let (rims, k) = (task.rims, task.rims.loop_count());
    let mut search = BridgeTreeSearch {
        task,
        bridges: SortedBridges::new(task)?,
        best_triangulation: None,
        cost_limit,
        repeated_searches_left: max_repeated_searches,
    };
    let count = search.bridges.sorted.len();
    for rank in 0..count {
        let [u, v] = search.bridges.sorted[rank];
        let ring = rims.loop_of_vertex[u as usize] as usize;
        let range = rims.loop_vertices(ring);
        let place = (u - range.start) as usize;
        let mut is_joined = alloc::filled(false, k)?;
        is_joined[ring] = true;
        // The first bridge is the shortest in the tree.
        let least = alloc::filled(rank as u32, k * k)?;
        let alone = PartialTree { opened: OpenedLoops::from_loop(range)?, is_joined, least_rank_by_loop_pair: least };
        search.search_from_partial_tree(
            alone.extended_by_loop(rims, place, v, rank as u32)?,
            &job.sub_job_of_item(rank, count),
        )?;
    }
    Ok(search.best_triangulation)
}

impl BridgeTreeSearch<'_> {
    fn search_from_partial_tree(&mut self, branch: PartialTree, job: &Job<'_>) -> Result<()> {
        let rims = self.task.rims;
        let ring = |v: u32| rims.loop_of_vertex[v as usize] as usize;
        let k = rims.loop_count();
        let least = |u: u32, v: u32| branch.least_rank_by_loop_pair[ring(u) * k + ring(v)];
        if branch.is_joined.iter().all(|&is_joined| is_joined) {
            let bridges = &self.bridges;
            let excluded =
                |u: u32, v: u32| rims.joins_two_loops(u, v) && bridges.rank_of_bridge(rims, u, v) < least(u, v);
            let chords = AllChords(branch.opened.len());
            let limit = self.best_triangulation.as_ref().map(|best| &best.cost).or(self.cost_limit.as_ref());
            let repeats = RepeatedEdgeTreatment::Both(&mut self.repeated_searches_left);
            let found = self.task.search_polygon(branch.opened, &chords, &excluded, limit, repeats, job)?;
            self.best_triangulation = found.or(self.best_triangulation.take());
            return Ok(());
        }
        let others = (0..rims.vertex_count() as u32).filter(|&v| !branch.is_joined[ring(v)]);
        let places = branch.opened.vertex_at_place.iter().enumerate();
        let mut next = alloc::gather(others.flat_map(|v| places.clone().map(move |(place, &u)| (u, v, place))))?;
        next.retain(|&(u, v, _)| {
            !(self.task.is_forbidden_edge)(u, v) && self.bridges.rank_of_bridge(rims, u, v) > least(u, v)
        });
        sort::sort_stable(&mut next, &|x, y| {
            let key = |&(u, v, place): &(u32, u32, usize)| (self.bridges.rank_of_bridge(rims, u, v), place);
            key(x).cmp(&key(y))
        });
        for (u, v, place) in next {
            self.search_from_partial_tree(
                branch.extended_by_loop(rims, place, v, self.bridges.rank_of_bridge(rims, u, v))?,
                job,
            )?;
        }
        Ok(())
    }
}
