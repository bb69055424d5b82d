//! A triangulation cut open along other bridges than it was found with, which may then change.

use super::super::chords::{All, Near};
use super::super::search::{MAX_EXACT, MAX_SEARCHED, MIN_GAIN, bands};
use super::numbered_rims::Rims;
use super::opened::cut_open;
use super::task::{Closed, Repeats, Task};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort;

/// So often a triangulation is searched again along other bridges, at the most and without gain.
const MAX_ROUNDS: usize = 16;
const MAX_VAIN: usize = 2;
/// Searches more of one polygon, where edges come twice.
pub(super) const REPEATS: usize = 16;
pub(super) const FREE: &dyn Fn(u32, u32) -> bool = &|_, _| false;

/// Cut open along other bridges, far from those before, and searched again, while that improves
/// it.
pub(super) fn improved(task: &Task<'_>, mut best: Closed, job: &Job<'_>) -> Result<Closed> {
    let n = best.opened.len();
    let rounds = if n <= MAX_EXACT { MAX_ROUNDS } else { (MAX_SEARCHED / n).clamp(1, MAX_ROUNDS) };
    let mut old = alloc::collect(best.opened.tree()?.iter().map(|&(ends, _)| ends))?;
    let mut vain = 0;
    for round in 0..rounds {
        let triangles = best.opened.named(&best.triangles)?;
        let tree = far_tree(task, &triangles, &old)?;
        let Some((opened, places)) = cut_open(task.rims, &triangles, &tree)? else {
            break;
        };
        alloc::append(&mut old, &tree)?;
        let limit = Some(&best.cost);
        let job = job.share(round, rounds);
        let found = if n <= MAX_EXACT {
            task.search(opened, &All(n), FREE, limit, Repeats::One(REPEATS), &job)?
        } else {
            let same = alloc::collect((0..n).map(|place| place as u32))?;
            let band = bands(n).next().unwrap_or(1);
            let chords = Near::new(n, &places, &same, band)?;
            task.search(opened, &chords, FREE, limit, Repeats::One(REPEATS), &job)?
        };
        let gain = found.as_ref().map_or(0.0, |found| found.cost.gain_over(&best.cost));
        best = found.unwrap_or(best);
        vain = if gain > MIN_GAIN { 0 } else { vain + 1 };
        if vain == MAX_VAIN {
            break;
        }
    }
    Ok(best)
}

/// A tree of those sides of a triangulation that lead from loop to loop, as far as can be, along
/// the loops, from the ends of `old` ones.
pub(super) fn far_tree(task: &Task<'_>, triangles: &[[u32; 3]], old: &[[u32; 2]]) -> Result<Vec<[u32; 2]>> {
    let rims = task.rims;
    let distances = distances(rims, old.as_flattened())?;
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    // Each comes once either way.
    let sides = sides.filter(|&[u, v]| u < v && rims.joins(u, v));
    let far = |[u, v]: [u32; 2]| distances[u as usize] + distances[v as usize];
    let mut sides = alloc::gather(sides.map(|ends| (far(ends), ends)))?;
    sort::stable(&mut sides, &|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    spanning(rims, sides.iter().map(|&(_, ends)| ends))
}

/// How far each vertex is from the nearest of `ends` on its loop, as a part of the loop's length in
/// vertices; 1 or more if there is none.
fn distances(rims: &Rims, ends: &[u32]) -> Result<Vec<f64>> {
    let mut is_end = alloc::filled(false, rims.count())?;
    ends.iter().for_each(|&v| is_end[v as usize] = true);
    let mut distances = alloc::filled(f64::INFINITY, rims.count())?;
    for ring in 0..rims.loops() {
        let range = rims.range(ring);
        let n = range.len() as f64;
        // Once round to find an end, and once more to count from there.
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

/// Those bridges that join what those before have not.
fn spanning(rims: &Rims, bridges: impl Iterator<Item = [u32; 2]>) -> Result<Vec<[u32; 2]>> {
    let mut joined = DisjointSets::new(rims.loops())?;
    let mut tree = Vec::new();
    for [u, v] in bridges {
        if joined.union(rims.ring[u as usize], rims.ring[v as usize]) {
            alloc::push(&mut tree, [u, v])?;
            if tree.len() + 1 == rims.loops() {
                break;
            }
        }
    }
    Ok(tree)
}
