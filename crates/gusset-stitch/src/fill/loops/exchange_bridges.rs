//! Search for many loops with few vertices: starts from a tree of short bridges, and exchanges them
//! for better ones.

use super::super::chords::AllChords;
use super::bridge_trees::{MAX_EXAMINED_TRIANGLES, estimate_polygon_work};
use super::closing_task::{ClosingTask, OpenedLoopsTriangulation, RepeatedEdgeTreatment};
use super::improve_along_bridges::{MAX_REPEATED_EDGE_SEARCHES, NO_TAKEN_EDGE};
use super::numbered_rims::NumberedRims;
use super::opened_loops::OpenedLoops;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

/// Number of the shortest alternative bridges that are tried in place of a bridge.
const MAX_REPLACEMENT_BRIDGES: usize = 8;

/// Estimates the number of triangles to examine in one pass for loops of these lengths.
pub(super) fn estimate_pass_work(lengths: impl Iterator<Item = usize> + Clone) -> f64 {
    let loops = lengths.clone().count();
    let opened = lengths.sum::<usize>() + 2 * loops - 2;
    (MAX_REPLACEMENT_BRIDGES * (loops - 1)) as f64 * estimate_polygon_work(opened)
}

/// Returns a good triangulation, not always the best.
///
/// O(k n^3) for k loops with n vertices in all.
pub(super) fn exchange_bridges(task: &ClosingTask<'_>, job: &Job<'_>) -> Result<Option<OpenedLoopsTriangulation>> {
    let rims = task.rims;
    let n = rims.vertex_count() as u32;
    let pairs = (0..n).flat_map(|u| (u + 1..n).map(move |v| [u, v]));
    let mut bridges =
        alloc::gather(pairs.filter(|&[u, v]| rims.joins_two_loops(u, v) && !(task.is_forbidden_edge)(u, v)))?;
    bridges.sort_unstable_by(|&x, &y| {
        rims.squared_distance(x[0], x[1]).total_cmp(&rims.squared_distance(y[0], y[1])).then(x.cmp(&y))
    });
    let Some(mut tree) = shortest_spanning_tree(rims, &bridges)? else {
        return Ok(None);
    };
    let mut left = (2.0 * MAX_EXAMINED_TRIANGLES / estimate_polygon_work(n as usize + 2 * tree.len())) as usize;
    let allowed = left.max(1) as f64;
    let search = |tree: &[[u32; 2]], best: &Option<OpenedLoopsTriangulation>, left: usize| {
        let opened = open_loops_along_tree(rims, tree)?;
        let limit = best.as_ref().map(|best| &best.cost);
        let chords = AllChords(opened.len());
        task.search_polygon(
            opened,
            &chords,
            NO_TAKEN_EDGE,
            limit,
            RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
            &job.sub_job(1.0 - left as f64 / allowed, 1.0),
        )
    };
    let mut best = search(&tree, &None, left)?;
    let mut at = 0;
    let mut vain = 0;
    while left > 0 && vain < tree.len() {
        vain += 1;
        for bridge in replacement_bridges(rims, &bridges, &tree, at)? {
            if left == 0 {
                break;
            }
            left -= 1;
            let old = std::mem::replace(&mut tree[at], bridge);
            match search(&tree, &best, left)? {
                None => tree[at] = old,
                found => (best, vain) = (found, 0),
            }
        }
        at = (at + 1) % tree.len();
    }
    Ok(best)
}

/// Returns the shortest bridges that join all loops, without common ends if possible.
fn shortest_spanning_tree(rims: &NumberedRims, bridges: &[[u32; 2]]) -> Result<Option<Vec<[u32; 2]>>> {
    let mut joined = DisjointSets::new(rims.loop_count())?;
    let mut tree = Vec::<[u32; 2]>::new();
    for apart in [true, false] {
        for &[u, v] in bridges {
            if apart && tree.as_flattened().iter().any(|&end| end == u || end == v) {
                continue;
            }
            if joined.union(rims.loop_of_vertex[u as usize], rims.loop_of_vertex[v as usize]) {
                alloc::push(&mut tree, [u, v])?;
            }
            if tree.len() + 1 == rims.loop_count() {
                return Ok(Some(tree));
            }
        }
    }
    Ok(None)
}

/// Returns the shortest bridges that join the two parts of a tree without its bridge `removed`.
fn replacement_bridges(
    rims: &NumberedRims,
    bridges: &[[u32; 2]],
    tree: &[[u32; 2]],
    removed: usize,
) -> Result<Vec<[u32; 2]>> {
    let mut joined = DisjointSets::new(rims.loop_count())?;
    let ring = |v: u32| rims.loop_of_vertex[v as usize];
    for (_, &[u, v]) in tree.iter().enumerate().filter(|&(k, _)| k != removed) {
        joined.union(ring(u), ring(v));
    }
    let mut apart = |&[u, v]: &[u32; 2]| joined.find(ring(u)) != joined.find(ring(v)) && [u, v] != tree[removed];
    alloc::gather(bridges.iter().filter(|bridge| apart(bridge)).take(MAX_REPLACEMENT_BRIDGES).copied())
}

/// Returns the polygon along a tree of bridges. Several bridges at one vertex come in any order.
fn open_loops_along_tree(rims: &NumberedRims, tree: &[[u32; 2]]) -> Result<OpenedLoops> {
    let ring = |v: u32| rims.loop_of_vertex[v as usize] as usize;
    let mut opened = OpenedLoops::from_loop(rims.loop_vertices(ring(tree[0][0])))?;
    let mut is_joined = alloc::filled(false, rims.loop_count())?;
    is_joined[ring(tree[0][0])] = true;
    for _ in tree {
        let next = tree.iter().find(|[u, v]| is_joined[ring(*u)] != is_joined[ring(*v)]);
        let Some(&[u, v]) = next else {
            break;
        };
        let [u, v] = if is_joined[ring(u)] { [u, v] } else { [v, u] };
        if let Some(place) = opened.vertex_at_place.iter().position(|&w| w == u) {
            opened = opened.extended_by_loop(place, rims.loop_vertices(ring(v)), v)?;
        }
        is_joined[ring(v)] = true;
    }
    Ok(opened)
}
