//! Improves a triangulation by cutting it open along other bridges and searching again.

use super::super::chords::{AllChords, ChordsNearTriangulation};
use super::super::triangulation_search::{
    MAX_EXACT_VERTICES, MAX_SEARCHED_VERTICES, MIN_RELATIVE_GAIN, band_widths_to_try,
};
use super::closing_task::{ClosingTask, OpenedLoopsTriangulation, RepeatedEdgeTreatment};
use super::numbered_rims::NumberedRims;
use super::opened_loops::cut_open_along_tree;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort;

/// Largest number of searches along other bridges in all, ...
const MAX_IMPROVEMENT_ROUNDS: usize = 16;
/// ... and in succession without gain.
const MAX_ROUNDS_WITHOUT_GAIN: usize = 2;
/// Largest number of additional searches of one polygon for repeated edges.
pub(super) const MAX_REPEATED_EDGE_SEARCHES: usize = 16;
pub(super) const NO_TAKEN_EDGE: &dyn Fn(u32, u32) -> bool = &|_, _| false;

/// Cuts the surface open along bridges far from the earlier ones, and searches again, while that
/// improves it.
pub(super) fn improve_along_other_bridges(
    task: &ClosingTask<'_>,
    mut best: OpenedLoopsTriangulation,
    job: &Job<'_>,
) -> Result<OpenedLoopsTriangulation> {
    let n = best.opened.len();
    let rounds = if n <= MAX_EXACT_VERTICES {
        MAX_IMPROVEMENT_ROUNDS
    } else {
        (MAX_SEARCHED_VERTICES / n).clamp(1, MAX_IMPROVEMENT_ROUNDS)
    };
    let mut old = alloc::collect(best.opened.bridge_tree()?.iter().map(|&(ends, _)| ends))?;
    let mut vain = 0;
    for round in 0..rounds {
        let triangles = best.opened.places_to_vertices(&best.triangles)?;
        let tree = farthest_spanning_tree(task, &triangles, &old)?;
        let Some((opened, places)) = cut_open_along_tree(task.rims, &triangles, &tree)? else {
            break;
        };
        alloc::append(&mut old, &tree)?;
        let limit = Some(&best.cost);
        let job = job.sub_job_of_item(round, rounds);
        let found = if n <= MAX_EXACT_VERTICES {
            task.search_polygon(
                opened,
                &AllChords(n),
                NO_TAKEN_EDGE,
                limit,
                RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
                &job,
            )?
        } else {
            let same = alloc::collect((0..n).map(|place| place as u32))?;
            let band = band_widths_to_try(n).next().unwrap_or(1);
            let chords = ChordsNearTriangulation::new(n, &places, &same, band)?;
            task.search_polygon(
                opened,
                &chords,
                NO_TAKEN_EDGE,
                limit,
                RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
                &job,
            )?
        };
        let gain = found.as_ref().map_or(0.0, |found| found.cost.relative_gain_over(&best.cost));
        best = found.unwrap_or(best);
        vain = if gain > MIN_RELATIVE_GAIN { 0 } else { vain + 1 };
        if vain == MAX_ROUNDS_WITHOUT_GAIN {
            break;
        }
    }
    Ok(best)
}

/// Returns a spanning tree of sides that lead from loop to loop, as far along the loops as possible
/// from the ends of the `old` bridges.
pub(super) fn farthest_spanning_tree(
    task: &ClosingTask<'_>,
    triangles: &[[u32; 3]],
    old: &[[u32; 2]],
) -> Result<Vec<[u32; 2]>> {
    let rims = task.rims;
    let distances = distances_along_loops(rims, old.as_flattened())?;
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    // Each side occurs once in each direction.
    let sides = sides.filter(|&[u, v]| u < v && rims.joins_two_loops(u, v));
    let far = |[u, v]: [u32; 2]| distances[u as usize] + distances[v as usize];
    let mut sides = alloc::gather(sides.map(|ends| (far(ends), ends)))?;
    sort::sort_stable(&mut sides, &|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    spanning_tree(rims, sides.iter().map(|&(_, ends)| ends))
}

/// Returns each vertex's distance along its loop from the nearest of `ends`, as a fraction of the
/// loop's vertices. It is at least 1 on a loop without ends.
fn distances_along_loops(rims: &NumberedRims, ends: &[u32]) -> Result<Vec<f64>> {
    let mut is_end = alloc::filled(false, rims.vertex_count())?;
    ends.iter().for_each(|&v| is_end[v as usize] = true);
    let mut distances = alloc::filled(f64::INFINITY, rims.vertex_count())?;
    for ring in 0..rims.loop_count() {
        let range = rims.loop_vertices(ring);
        let n = range.len() as f64;
        // The first round finds an end, and the second counts from there.
        let mut sweep = |order: &mut dyn Iterator<Item = u32>| {
            let mut steps = n;
            for v in order.map(|v| v as usize) {
                steps = if is_end[v] { 0.0 } else { steps + 1.0 };
                distances[v] = distances[v].min(steps / n);
            }
        };
        sweep(&mut range.clone().chain(range.clone()));
        sweep(&mut range.clone().rev().chain(range.rev()));
    }
    Ok(distances)
}

/// Returns the bridges that join loops that the earlier bridges do not join.
fn spanning_tree(rims: &NumberedRims, bridges: impl Iterator<Item = [u32; 2]>) -> Result<Vec<[u32; 2]>> {
    let mut joined = DisjointSets::new(rims.loop_count())?;
    let mut tree = Vec::new();
    for [u, v] in bridges {
        if joined.union(rims.loop_of_vertex[u as usize], rims.loop_of_vertex[v as usize]) {
            alloc::push(&mut tree, [u, v])?;
            if tree.len() + 1 == rims.loop_count() {
                break;
            }
        }
    }
    Ok(tree)
}
