//! Triangulations of several loops by one patch of genus 0 without new vertices.
//!
//! The task follows M. Zou, T. Ju, N. Carr, *An algorithm for triangulating multiple 3D polygons*
//! (2013). The method differs: a surface that k loops bound is cut open along k - 1 bridges, which
//! are chords between two loops. The search for a single loop then triangulates the resulting
//! polygon.
//!
//! | file | subject |
//! |---|---|
//! | [`numbered_rims`](self) | loops with common vertex numbers, and thinned loops |
//! | [`opened_loops`](self) | loops cut open into one polygon |
//! | [`closing_task`](self) | the search for such a polygon, and costs |
//! | [`bridge_trees`](self) | two or three loops with few vertices: all trees of bridges |
//! | [`exchange_bridges`](self) | many loops with few vertices: exchange of bridges |
//! | [`improve_along_bridges`](self) | repeated search along other bridges |
//! | [`zip_loops`](self) | two loops side by side |
//! | [`nested_loops`](self) | planar loops, one around the others |

mod bridge_trees;
mod exchange_bridges;
#[cfg(test)]
mod exhaustive_triangulation;
mod improve_along_bridges;
mod nested_loops;
mod numbered_rims;
mod opened_loops;
mod closing_task;
#[cfg(test)]
mod tests;
mod zip_loops;

use super::Weight;
use super::chords::{AllChords, ChordsNearTriangulation};
use super::triangulation_cost::{CostNormalisation, Polygon, TriangulationCost};
use super::triangulation_search::{MAX_EXACT_VERTICES, band_widths_to_try, minimum_weight_triangulation};
use closing_task::{ClosingTask, OpenedLoopsTriangulation, RepeatedEdgeTreatment};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use improve_along_bridges::{MAX_REPEATED_EDGE_SEARCHES, NO_TAKEN_EDGE};
use numbered_rims::NumberedRims;

/// Largest number of vertices, bridges counted twice, that are searched at full density.
const MAX_DENSE_SEARCH_VERTICES: usize = 1_000;

/// Number of vertices to which each loop is thinned to predict whether two loops may share a patch.
const TRIAL_VERTICES_PER_LOOP: usize = 5;
/// The predicted cost of a common patch may exceed the cost apart by this factor.
const MAX_PREDICTED_COST_RATIO: f64 = 1.5;
/// Loops always become partners if a vertex of the coarser one is this near to the other, relative
/// to the sides of the thinned loop.
const MAX_PARTNER_DISTANCE_SIDES: f64 = 0.5;

/// Triangulates a surface of genus 0 that closes all `loops` together. Returns `None` if none is
/// found.
///
/// The triangles index the vertices of all loops in order, and run each loop's edges forwards. No
/// chord is `taken`.
///
/// With [`Weight::Area`] the area is optimal for two loops of up to 19 vertices each, and for three
/// loops of up to 5. Other lengths of equal work (50 ms) are optimal too. With other weights all
/// trees of bridges are tried, and each polygon is searched like a single loop. Longer loops are
/// thinned evenly to this size. The result is refined like the result for a long loop, then cut
/// open elsewhere and searched again while that improves it. Four or more loops start with their
/// shortest bridges, which are exchanged for better ones: a good triangulation, not always the
/// best.
///
/// **Planar loops**, one around the others, get triangles that do not overlap and satisfy the
/// Delaunay criterion, except at taken edges. The weight does not matter.
///
/// O(n log n) time for n vertices and few loops; about 4 kB per vertex. Up to some hundred loops:
/// O(m^3) for the m vertices that remain when every loop has three or four.
pub(super) fn triangulate_loops_together(
    loops: &[Polygon],
    weight: Weight,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    if loops.is_empty() || loops.iter().any(|polygon| polygon.points.len() < 3) {
        return Ok(None);
    }
    if let [polygon] = loops {
        return minimum_weight_triangulation(polygon, weight, &|i, k| taken(i as u32, k as u32), job);
    }
    let rims = NumberedRims::new(loops)?;
    let task = ClosingTask {
        rims: &rims,
        weight,
        normalisation: rims.common_cost_normalisation(),
        is_forbidden_edge: taken,
        is_finest: true,
    };
    let plane = nested_loops::normal_of_common_plane(&rims);
    if let Some(normal) = plane
        && let Some(triangles) = nested_loops::triangulate_nested_loops(&task, normal, &job.sub_job(0.0, 0.2))?
    {
        return Ok(Some(triangles));
    }
    // On a plane, the surface beyond the rims does not matter.
    let weight = if plane.is_some() && weight == Weight::Continuation { Weight::Area } else { weight };
    let found = close_loops_coarse_to_fine(loops, &ClosingTask { weight, ..task }, &job.sub_job(0.2, 1.0))?;
    found.map(|found| found.opened.places_to_vertices(&found.triangles)).transpose()
}

/// Returns the cost of triangles that close all loops, together or one by one. The triangles index
/// the vertices of all loops.
///
/// Costs of the same loops and weight can be compared, to tell which loops should share a patch.
/// The points need a common origin and unit. O(n log n).
pub(super) fn cost_of_closing(loops: &[Polygon], triangles: &[[u32; 3]], weight: Weight) -> Result<TriangulationCost> {
    let rims = NumberedRims::new(loops)?;
    let measure = CostNormalisation::new(rims.loop_points(), triangles.len());
    ClosingTask { rims: &rims, weight, normalisation: measure, is_forbidden_edge: NO_TAKEN_EDGE, is_finest: true }
        .cost_of_closing(triangles)
}

/// Returns false if two loops are unlikely to cost less together than apart. The prediction thins
/// each loop to a few vertices, and allows a margin. O(n).
pub(super) fn may_cost_less_together(loops: [&Polygon; 2], weight: Weight, job: &Job<'_>) -> Result<bool> {
    let few = alloc::try_collect(loops.map(|polygon| polygon.thinned_to_point_count(TRIAL_VERTICES_PER_LOOP)))?;
    let side = |polygon: &Polygon| polygon.perimeter() / polygon.points.len() as f64;
    let reach = MAX_PARTNER_DISTANCE_SIDES * side(&few[0]).min(side(&few[1]));
    // Measure from the thinned loop with the shorter sides.
    let (one, other) = if side(&few[0]) <= side(&few[1]) { (&few[0], loops[1]) } else { (&few[1], loops[0]) };
    if one.points.iter().any(|p| other.points.iter().any(|q| p.distance(*q) < reach)) {
        return Ok(true);
    }
    let mut apart = Vec::new();
    let mut first = 0;
    for polygon in &few {
        let own = minimum_weight_triangulation(polygon, weight, &|_, _| false, job)?.unwrap_or_default();
        alloc::extend(&mut apart, own.iter().map(|triangle| triangle.map(|v| first + v)))?;
        first += polygon.points.len() as u32;
    }
    let limit = cost_of_closing(&few, &apart, weight)?.scaled(MAX_PREDICTED_COST_RATIO);
    let rims = NumberedRims::new(&few)?;
    let task = ClosingTask {
        rims: &rims,
        weight,
        normalisation: rims.common_cost_normalisation(),
        is_forbidden_edge: NO_TAKEN_EDGE,
        is_finest: true,
    };
    Ok(bridge_trees::best_triangulation_over_trees(&task, Some(limit), MAX_REPEATED_EDGE_SEARCHES, job)?.is_some())
}

/// Triangulates from coarse to fine.
fn close_loops_coarse_to_fine(
    loops: &[Polygon],
    task: &ClosingTask<'_>,
    job: &Job<'_>,
) -> Result<Option<OpenedLoopsTriangulation>> {
    let lengths = loops.iter().map(|polygon| polygon.points.len());
    let n = task.rims.vertex_count() + 2 * loops.len() - 2;
    if bridge_trees::estimate_search_work(lengths.clone()) <= bridge_trees::MAX_EXAMINED_TRIANGLES {
        let best = bridge_trees::best_triangulation_over_trees(
            task,
            None,
            bridge_trees::max_repeated_searches(task.rims),
            &job.sub_job(0.0, 0.9),
        )?;
        return best
            .map(|best| improve_along_bridges::improve_along_other_bridges(task, best, &job.sub_job(0.9, 1.0)))
            .transpose();
    }
    let is_small =
        loops.len() > 3 && exchange_bridges::estimate_pass_work(lengths) <= bridge_trees::MAX_EXAMINED_TRIANGLES;
    let thin = if is_small { None } else { numbered_rims::thin_loops(loops)? };
    let Some((coarse, kept)) = thin else {
        if n > MAX_DENSE_SEARCH_VERTICES {
            return Ok(None);
        }
        let best = exchange_bridges::exchange_bridges(task, &job.sub_job(0.0, 0.8))?;
        return best
            .map(|best| improve_along_bridges::improve_along_other_bridges(task, best, &job.sub_job(0.8, 1.0)))
            .transpose();
    };
    let rims = NumberedRims::new(&coarse)?;
    let taken = |u: u32, v: u32| (task.is_forbidden_edge)(kept[u as usize], kept[v as usize]);
    let measure = rims.common_cost_normalisation().with_bulge_unit_of(task.normalisation);
    let coarse_task = ClosingTask {
        rims: &rims,
        weight: task.weight,
        normalisation: measure,
        is_forbidden_edge: &taken,
        is_finest: false,
    };
    let Some(coarse) = close_loops_coarse_to_fine(&coarse, &coarse_task, &job.sub_job(0.0, 0.4))? else {
        return Ok(None);
    };
    let Some(found) = refine_triangulation(task, &coarse, &kept, &job.sub_job(0.4, 0.7))? else {
        return Ok(None);
    };
    let found = zip_loops::zip_loops(task, found, &job.sub_job(0.7, 0.8))?;
    improve_along_bridges::improve_along_other_bridges(task, found, &job.sub_job(0.8, 1.0)).map(Some)
}

/// Refines a triangulation of thinned loops, with chords near the coarse ones.
fn refine_triangulation(
    task: &ClosingTask<'_>,
    coarse: &OpenedLoopsTriangulation,
    kept: &[u32],
    job: &Job<'_>,
) -> Result<Option<OpenedLoopsTriangulation>> {
    let n = task.rims.vertex_count() + 2 * task.rims.loop_count() - 2;
    if n <= MAX_EXACT_VERTICES {
        let (opened, _) = coarse.opened.refined_loops(task.rims, kept)?;
        if let Some(found) = task.search_polygon(
            opened,
            &AllChords(n),
            NO_TAKEN_EDGE,
            None,
            RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
            job,
        )? {
            return Ok(Some(found));
        }
    }
    // A narrow band has fewer chords, so fewer edges repeat.
    for band in band_widths_to_try(n) {
        let (opened, places) = coarse.opened.refined_loops(task.rims, kept)?;
        let chords = ChordsNearTriangulation::new(n, &coarse.triangles, &places, band)?;
        if let Some(found) = task.search_polygon(
            opened,
            &chords,
            NO_TAKEN_EDGE,
            None,
            RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
            job,
        )? {
            return Ok(Some(found));
        }
    }
    add_ears_at_finer_vertices(task, coarse, kept)
}

/// Returns the triangulation of the thinned loops with an ear at each additional vertex.
fn add_ears_at_finer_vertices(
    task: &ClosingTask<'_>,
    coarse: &OpenedLoopsTriangulation,
    kept: &[u32],
) -> Result<Option<OpenedLoopsTriangulation>> {
    let (opened, places) = coarse.opened.refined_loops(task.rims, kept)?;
    let n = opened.len() as u32;
    let mut triangles = alloc::collect(coarse.triangles.iter().map(|corners| corners.map(|p| places[p as usize])))?;
    let ends = places.iter().skip(1).chain([&n]);
    let ears = places.iter().zip(ends).filter(|&(&from, &to)| to == from + 2);
    let mut ears = alloc::gather(ears.map(|(&from, &to)| [from, from + 1, to % n]))?;
    ears.iter_mut().for_each(|ear| ear.sort_unstable());
    alloc::append(&mut triangles, &ears)?;
    let named = opened.places_to_vertices(&triangles)?;
    let mut sides = named.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    if sides.any(|[u, v]| !task.rims.is_rim_edge(u, v) && (task.is_forbidden_edge)(u, v)) {
        return Ok(None);
    }
    let cost = task.cost_of_closing(&named)?;
    Ok(Some(OpenedLoopsTriangulation { opened, triangles, cost }))
}
