//! Zipping of two loops that run side by side.
//!
//! If the loops are nearer to each other than the vertices of the thinned loops, the thinned loops
//! do not resolve the gap. From the shortest bridge, triangles advance around on the loop with the
//! shorter next bridge. The result is kept if it costs less.

use super::super::chords::ChordsNearTriangulation;
use super::super::triangulation_search::band_widths_to_try;
use super::closing_task::{ClosingTask, OpenedLoopsTriangulation, RepeatedEdgeTreatment};
use super::improve_along_bridges::{MAX_REPEATED_EDGE_SEARCHES, NO_TAKEN_EDGE};
use super::opened_loops::OpenedLoops;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Number of steps from loop to loop towards a local shortest bridge.
const MAX_BRIDGE_STEPS: usize = 4;

/// Returns the best triangulation near the zip if it costs less than `best`, or else `best`.
/// Returns `best` unless there are exactly two loops.
///
/// O(n log n).
pub(super) fn zip_loops(
    task: &ClosingTask<'_>,
    best: OpenedLoopsTriangulation,
    job: &Job<'_>,
) -> Result<OpenedLoopsTriangulation> {
    let rims = task.rims;
    let named = best.opened.places_to_vertices(&best.triangles)?;
    let sides = named.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let bridges = sides.filter(|&[u, v]| rims.loop_of_vertex[u as usize] < rims.loop_of_vertex[v as usize]);
    let length = |[u, v]: [u32; 2]| rims.squared_distance(u, v);
    let shortest = bridges.min_by(|&a, &b| length(a).total_cmp(&length(b)).then(a.cmp(&b)));
    let Some([mut u, mut v]) = shortest.filter(|_| rims.loop_count() == 2) else {
        return Ok(best);
    };
    // Step to and fro, to a place where the loops are near each other.
    let nearest = |ring: usize, to: u32| {
        let free = rims.loop_vertices(ring).filter(|&w| !(task.is_forbidden_edge)(to, w));
        free.min_by(|&a, &b| length([a, to]).total_cmp(&length([b, to]))).unwrap_or(to)
    };
    for _ in 0..MAX_BRIDGE_STEPS {
        v = nearest(1, u);
        u = nearest(0, v);
    }
    let opened =
        OpenedLoops::from_loop(rims.loop_vertices(0))?.extended_by_loop(u as usize, rims.loop_vertices(1), v)?;
    let triangles = zip_from_bridge(task, &opened, rims.loop_vertices(1).len())?;
    if !task.is_cheaper_by_loop_measure(&task.cost_of_closing(&opened.places_to_vertices(&triangles)?)?, &best.cost) {
        return Ok(best);
    }
    let n = opened.len();
    let same = alloc::collect((0..n).map(|place| place as u32))?;
    let chords = ChordsNearTriangulation::new(n, &triangles, &same, band_widths_to_try(n).next().unwrap_or(1))?;
    let found = task.search_polygon(
        opened,
        &chords,
        NO_TAKEN_EDGE,
        Some(&best.cost),
        RepeatedEdgeTreatment::One(MAX_REPEATED_EDGE_SEARCHES),
        job,
    )?;
    Ok(found.unwrap_or(best))
}

/// Zips from the last edge of the polygon. `first` is the place of the other end of the bridge.
fn zip_from_bridge(task: &ClosingTask<'_>, opened: &OpenedLoops, first: usize) -> Result<Vec<[u32; 3]>> {
    let squared = |i: usize, k: usize| task.rims.squared_distance(opened.vertex_at_place[i], opened.vertex_at_place[k]);
    let (mut i, mut k) = (0, opened.len() - 1);
    let mut triangles = alloc::with_capacity(k - 1)?;
    while i < first || k > first + 1 {
        let onwards = k == first + 1 || i < first && squared(i + 1, k) <= squared(i, k - 1);
        let m = if onwards { i + 1 } else { k - 1 };
        triangles.push([i as u32, m as u32, k as u32]);
        (i, k) = if onwards { (m, k) } else { (i, m) };
    }
    Ok(triangles)
}
