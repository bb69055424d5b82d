//! Several loops, one patch: triangulations of genus 0 without new vertices.
//!
//! Sources: M. Zou, T. Ju, N. Carr, *An algorithm for triangulating multiple 3D polygons* (2013),
//! for what is looked for. Here a surface that k loops bound is cut open along k - 1 bridges, chords
//! between two loops, and the search of a single loop triangulates the polygon that there is then.
//!
//! | file | subject |
//! |---|---|
//! | [`numbered_rims`](self) | loops in common numbers, and thinned ones |
//! | [`opened`](self) | loops cut open to one polygon |
//! | [`task`](self) | the search of such a polygon, and costs |
//! | [`bridge_trees`](self) | few vertices of two and three loops: all bridges |
//! | [`exchange`](self) | few vertices of many loops: bridges replaced by better ones |
//! | [`improve`](self) | cut open along other bridges |
//! | [`zip`](self) | two loops side by side |
//! | [`nested`](self) | loops in a plane, one round the others |

mod bridge_trees;
mod exchange;
#[cfg(test)]
mod exhaustive;
mod improve;
mod nested;
mod numbered_rims;
mod opened;
mod task;
#[cfg(test)]
mod tests;
mod zip;

use super::Weight;
use super::chords::{All, Near};
use super::search::{MAX_EXACT, bands, minimum_weight};
use super::weigh::{Cost, Measure, Polygon};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use improve::{FREE, REPEATS};
use numbered_rims::Rims;
use task::{Closed, Repeats, Task};

/// Many short loops that cannot be thinned are searched as a whole up to so many vertices.
const MAX_DENSE: usize = 1_000;

/// So many vertices say whether two loops may belong together.
const FEW: usize = 5;
/// And their surface may cost so many times what it costs apart.
const MARGIN: f64 = 1.5;
/// Loops nearer to each other than this part of a side of such a thinned one belong together as far
/// as these can say.
const NEAR: f64 = 0.5;

/// Triangles of a surface of genus 0 that closes all `loops` together, over their vertices numbered
/// through all of them; triangles run each loop's edges forwards. No chord is `taken`. `None` if no
/// triangulation was found.
///
/// With [`Weight::Area`] the area is the least there is for two loops of up to 19 vertices each and
/// three of up to 5 (or other lengths that are as much work: 50 ms); by other weights all bridges
/// are tried, and each polygon is searched as a single loop is. More vertices are thinned evenly
/// until they are so few; what was found is refined as for a long loop, then cut open elsewhere and
/// searched again while that improves it. Four loops and more begin with their shortest bridges,
/// each of which is replaced by better ones: good, but not always the best.
///
/// **Planar loops**, one round the others, get triangles that do not overlap, by Delaunay's rule
/// except where edges are taken, whatever the weight.
///
/// O(n log n) time for n vertices and few loops; about 4 kB a vertex. Many loops, up to some
/// hundred: O(m^3) for the m vertices that are left when every loop has three or four.
pub(super) fn triangulate_together(
    loops: &[Polygon],
    weight: Weight,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    if loops.is_empty() || loops.iter().any(|polygon| polygon.points.len() < 3) {
        return Ok(None);
    }
    if let [polygon] = loops {
        return minimum_weight(polygon, weight, &|i, k| taken(i as u32, k as u32), job);
    }
    let rims = Rims::new(loops)?;
    let task = Task { rims: &rims, weight, measure: rims.measure(), taken, is_finest: true };
    let plane = nested::common_plane(&rims);
    if let Some(normal) = plane
        && let Some(triangles) = nested::nested(&task, normal, &job.part(0.0, 0.2))?
    {
        return Ok(Some(triangles));
    }
    // On a plane the surface beyond the rims has no say.
    let weight = if plane.is_some() && weight == Weight::Continuation { Weight::Area } else { weight };
    let found = closed(loops, &Task { weight, ..task }, &job.part(0.2, 1.0))?;
    found.map(|found| found.opened.named(&found.triangles)).transpose()
}

/// What triangles over the vertices of all loops cost that close them, together or each by itself:
/// costs of the same loops and weight compare, so that it can be seen which belong together. The
/// points must have one origin and unit. O(n log n).
pub(super) fn cost(loops: &[Polygon], triangles: &[[u32; 3]], weight: Weight) -> Result<Cost> {
    let rims = Rims::new(loops)?;
    let measure = Measure::of(rims.points(), triangles.len());
    Task { rims: &rims, weight, measure, taken: FREE, is_finest: true }.cost(triangles)
}

/// False if two loops will hardly cost less together than apart: so say loops of a few of their
/// vertices, with a margin. O(n).
pub(super) fn may_gain(loops: [&Polygon; 2], weight: Weight, job: &Job<'_>) -> Result<bool> {
    let few = alloc::try_collect(loops.map(|polygon| polygon.of_few(FEW)))?;
    let side = |polygon: &Polygon| polygon.length() / polygon.points.len() as f64;
    let reach = NEAR * side(&few[0]).min(side(&few[1]));
    // From the few of the loop that has them closer together.
    let (one, other) = if side(&few[0]) <= side(&few[1]) { (&few[0], loops[1]) } else { (&few[1], loops[0]) };
    if one.points.iter().any(|p| other.points.iter().any(|q| p.distance(*q) < reach)) {
        return Ok(true);
    }
    let mut apart = Vec::new();
    let mut first = 0;
    for polygon in &few {
        let own = minimum_weight(polygon, weight, &|_, _| false, job)?.unwrap_or_default();
        alloc::extend(&mut apart, own.iter().map(|triangle| triangle.map(|v| first + v)))?;
        first += polygon.points.len() as u32;
    }
    let limit = cost(&few, &apart, weight)?.loosened(MARGIN);
    let rims = Rims::new(&few)?;
    let task = Task { rims: &rims, weight, measure: rims.measure(), taken: FREE, is_finest: true };
    Ok(bridge_trees::exact(&task, Some(limit), REPEATS, job)?.is_some())
}

/// From coarse to fine.
fn closed(loops: &[Polygon], task: &Task<'_>, job: &Job<'_>) -> Result<Option<Closed>> {
    let lengths = loops.iter().map(|polygon| polygon.points.len());
    let n = task.rims.count() + 2 * loops.len() - 2;
    if bridge_trees::work(lengths.clone()) <= bridge_trees::MAX_WORK {
        let best = bridge_trees::exact(task, None, bridge_trees::repeats(task.rims), &job.part(0.0, 0.9))?;
        return best.map(|best| improve::improved(task, best, &job.part(0.9, 1.0))).transpose();
    }
    let is_small = loops.len() > 3 && exchange::work(lengths) <= bridge_trees::MAX_WORK;
    let thin = if is_small { None } else { numbered_rims::thinned(loops)? };
    let Some((coarse, kept)) = thin else {
        if n > MAX_DENSE {
            return Ok(None);
        }
        let best = exchange::exchanged(task, &job.part(0.0, 0.8))?;
        return best.map(|best| improve::improved(task, best, &job.part(0.8, 1.0))).transpose();
    };
    let rims = Rims::new(&coarse)?;
    let taken = |u: u32, v: u32| (task.taken)(kept[u as usize], kept[v as usize]);
    let measure = rims.measure().in_unit_of(task.measure);
    let coarse_task = Task { rims: &rims, weight: task.weight, measure, taken: &taken, is_finest: false };
    let Some(coarse) = closed(&coarse, &coarse_task, &job.part(0.0, 0.4))? else {
        return Ok(None);
    };
    let Some(found) = finer(task, &coarse, &kept, &job.part(0.4, 0.7))? else {
        return Ok(None);
    };
    let found = zip::zipped(task, found, &job.part(0.7, 0.8))?;
    improve::improved(task, found, &job.part(0.8, 1.0)).map(Some)
}

/// Near a triangulation of thinned loops.
fn finer(task: &Task<'_>, coarse: &Closed, kept: &[u32], job: &Job<'_>) -> Result<Option<Closed>> {
    let n = task.rims.count() + 2 * task.rims.loops() - 2;
    if n <= MAX_EXACT {
        let (opened, _) = coarse.opened.finer(task.rims, kept)?;
        if let Some(found) = task.search(opened, &All(n), FREE, None, Repeats::One(REPEATS), job)? {
            return Ok(Some(found));
        }
    }
    // Few chords have few edges that come twice.
    for band in bands(n) {
        let (opened, places) = coarse.opened.finer(task.rims, kept)?;
        let chords = Near::new(n, &coarse.triangles, &places, band)?;
        if let Some(found) = task.search(opened, &chords, FREE, None, Repeats::One(REPEATS), job)? {
            return Ok(Some(found));
        }
    }
    with_ears(task, coarse, kept)
}

/// The triangulation of thinned loops itself, and an ear at each vertex more.
fn with_ears(task: &Task<'_>, coarse: &Closed, kept: &[u32]) -> Result<Option<Closed>> {
    let (opened, places) = coarse.opened.finer(task.rims, kept)?;
    let n = opened.len() as u32;
    let mut triangles = alloc::collect(coarse.triangles.iter().map(|corners| corners.map(|p| places[p as usize])))?;
    let ends = places.iter().skip(1).chain([&n]);
    let ears = places.iter().zip(ends).filter(|&(&from, &to)| to == from + 2);
    let mut ears = alloc::gather(ears.map(|(&from, &to)| [from, from + 1, to % n]))?;
    ears.iter_mut().for_each(|ear| ear.sort_unstable());
    alloc::append(&mut triangles, &ears)?;
    let named = opened.named(&triangles)?;
    let mut sides = named.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    if sides.any(|[u, v]| !task.rims.is_edge(u, v) && (task.taken)(u, v)) {
        return Ok(None);
    }
    let cost = task.cost(&named)?;
    Ok(Some(Closed { opened, triangles, cost }))
}
