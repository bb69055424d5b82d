//! Minimum-weight triangulation of a loop without new vertices.
//!
//! Sources: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995), and P.
//! Liepa, *Filling holes in meshes* (2003). Dynamic programming over the chords (i, k) finds the
//! best triangulation of each part of the loop from i to k. It consists of a triangle (i, m, k) and
//! the best triangulations on both sides of the triangle. With all chords of n vertices it takes
//! O(n^3) time and O(n^2) memory.
//!
//! **Long loops** are solved from coarse to fine: first every other vertex, recursively, then all
//! vertices with the chords near the coarse solution. The search is repeated in a band around its
//! own result until the gain is small. There are O(n) chords and O(n) triangles in total.

use super::Weight;
use super::chords::{AllChords, ChordSet, ChordsNearTriangulation};
use super::triangulation_cost::{CostEvaluator, Polygon, TriangulationCost};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Loops of at most this many vertices are searched with all chords.
pub(super) const MAX_EXACT_VERTICES: usize = 128;
/// Largest distance, in vertices, between the ends of a fine chord and the ends of a coarse one.
/// The bands are tried in order, because a narrow one may lack a triangulation without taken
/// chords.
const CHORD_BAND_WIDTHS: [u32; 4] = [2, 4, 8, 16];
/// Loops with more vertices start with the narrowest band.
const MAX_WIDE_BAND_VERTICES: usize = 2_000;
const NARROW_BAND_WIDTH: u32 = 1;
/// Limit on the vertices of all repeated searches of a loop.
pub(super) const MAX_SEARCHED_VERTICES: usize = 8_000;
/// A search is repeated while its relative gain exceeds this.
pub(super) const MIN_RELATIVE_GAIN: f64 = 1e-3;
/// Chords between two progress reports.
const CHORDS_PER_REPORT: usize = 1 << 12;

/// Returns the triangles (i, m, k), i < m < k, of the triangulation of least weight without a
/// `taken` chord; `None` if none is found.
///
/// By area the result is optimal for up to [`MAX_EXACT_VERTICES`] vertices. Bends are treated as in
/// Liepa: each part of the loop keeps its own best triangulation, which ignores the triangle beyond
/// its chord.
///
/// O(n^3) time for n <= [`MAX_EXACT_VERTICES`], O(n) for longer loops; 30 n^2 bytes, or about 3 kB
/// per vertex.
pub(super) fn minimum_weight_triangulation(
    polygon: &Polygon,
    weight: Weight,
    taken: &dyn Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = polygon.points.len();
    if n <= MAX_EXACT_VERTICES {
        let scale = CostEvaluator::new(polygon, weight);
        return Ok(best_triangulation(&scale, &AllChords(n), taken, None, job)?.map(|found| found.triangles));
    }
    let (coarse, kept) = polygon.every_other_point()?;
    // Taken chords do not matter on the coarse level.
    let Some(coarse) = minimum_weight_triangulation(&coarse, weight, &|_, _| false, &job.sub_job(0.0, 0.4))? else {
        return Ok(None);
    };
    let job = job.sub_job(0.4, 1.0);
    let scale = CostEvaluator::new(polygon, weight);
    for band in band_widths_to_try(n) {
        let chords = ChordsNearTriangulation::new(n, &coarse, &kept, band)?;
        if let Some(found) = best_triangulation(&scale, &chords, taken, None, &job.sub_job(0.0, 0.5))? {
            return repeat_search_near(&scale, found, band, taken, &job.sub_job(0.5, 1.0)).map(Some);
        }
    }
    Ok(None)
}

/// Returns the bands to try, in order, for a loop of n vertices.
pub(super) fn band_widths_to_try(n: usize) -> impl Iterator<Item = u32> {
    (n > MAX_WIDE_BAND_VERTICES).then_some(NARROW_BAND_WIDTH).into_iter().chain(CHORD_BAND_WIDTHS)
}

/// Repeats the search around a result.
fn repeat_search_near(
    scale: &CostEvaluator<'_>,
    mut found: Triangulation,
    band: u32,
    taken: &dyn Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Vec<[u32; 3]>> {
    let n = scale.polygon().points.len();
    let same = alloc::collect(0..n as u32)?;
    let rounds = MAX_SEARCHED_VERTICES / n;
    for round in 0..rounds {
        let chords = ChordsNearTriangulation::new(n, &found.triangles, &same, band)?;
        let Some(next) = best_triangulation(scale, &chords, taken, None, &job.sub_job_of_item(round, rounds))? else {
            break;
        };
        let gain = next.cost.relative_gain_over(&found.cost);
        if gain > 0.0 {
            found = next;
        }
        if gain <= MIN_RELATIVE_GAIN {
            break;
        }
    }
    Ok(found.triangles)
}

/// A triangulation and its cost.
pub(super) struct Triangulation {
    pub(super) cost: TriangulationCost,
    /// Triples (i, m, k), i < m < k.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// The best triangulation of the part of the loop that a chord cuts off.
#[derive(Clone, Copy)]
struct ChordOptimum {
    cost: TriangulationCost,
    /// [`NO_APEX`] if the part lacks a triangulation.
    apex: u32,
    /// The unit normal of the triangle on the chord.
    normal: DVec3,
    bulge: f64,
}

const NO_APEX: u32 = u32::MAX;

/// Returns the best triangulation with these chords; `None` if none costs less than `limit`.
pub(super) fn best_triangulation(
    scale: &CostEvaluator<'_>,
    chords: &impl ChordSet,
    taken: &dyn Fn(usize, usize) -> bool,
    limit: Option<&TriangulationCost>,
    job: &Job<'_>,
) -> Result<Option<Triangulation>> {
    let polygon = scale.polygon();
    let n = polygon.points.len();
    let none = ChordOptimum { cost: TriangulationCost::ZERO, apex: NO_APEX, normal: DVec3::ZERO, bulge: 0.0 };
    let mut cells = alloc::filled(none, chords.chord_count())?;
    chords.try_each_chord(|number, [i, k]| {
        job.step_every(CHORDS_PER_REPORT, number, chords.chord_count(), "triangulating holes")?;
        if k == i + 1 {
            cells[number] = ChordOptimum {
                apex: i as u32,
                normal: polygon.normals_across_edges[i],
                bulge: scale.chord_bulge(i, k),
                ..none
            };
        } else if k - i + 1 == n || !taken(i, k) {
            cells[number] = best_triangle_on_chord(scale, chords, &cells, [i, k], limit).unwrap_or(none);
        }
        Ok(())
    })?;
    let Some(root) = chords.find_chord_number(0, n - 1).map(|root| cells[root]).filter(|root| root.apex != NO_APEX)
    else {
        return Ok(None);
    };
    let mut triangles = alloc::with_capacity(n - 2)?;
    let mut open = alloc::with_capacity(n)?;
    open.push((0, n - 1));
    while let Some((i, k)) = open.pop() {
        if let (true, Some(number)) = (k - i > 1, chords.find_chord_number(i, k)) {
            let m = cells[number].apex;
            triangles.push([i as u32, m, k as u32]);
            open.extend([(m as usize, k), (i, m as usize)]);
        }
    }
    Ok(Some(Triangulation { cost: root.cost, triangles }))
}

/// Returns the best triangle on the chord (i, k).
fn best_triangle_on_chord(
    scale: &CostEvaluator<'_>,
    chords: &impl ChordSet,
    cells: &[ChordOptimum],
    [i, k]: [usize; 2],
    limit: Option<&TriangulationCost>,
) -> Option<ChordOptimum> {
    let polygon = scale.polygon();
    let bulge = scale.chord_bulge(i, k);
    let at_root = k - i + 1 == polygon.points.len();
    let mut best: Option<ChordOptimum> = None;
    chords.visit_apexes(i, k, |m, sides| {
        let [left, right] = sides.map(|side| &cells[side]);
        if left.apex == NO_APEX || right.apex == NO_APEX {
            return;
        }
        // Costs only grow, so a partial cost that is not less can be dropped.
        let least = best.as_ref().map(|best| &best.cost).or(limit);
        let is_less = |cost: &TriangulationCost| least.is_none_or(|least| scale.is_cheaper(cost, least));
        let parts = left.cost.plus(right.cost);
        if !is_less(&parts) {
            return;
        }
        let seam = scale.seam_triangle_cost([i, m, k], [left.normal, right.normal]);
        let is_seam = seam.is_some();
        let (normal, own) = seam.unwrap_or_else(|| scale.triangle_cost([i, m, k], [left.bulge, right.bulge, bulge]));
        let mut cost = parts.plus(own);
        if !is_less(&cost) {
            return;
        }
        if !is_seam {
            cost = cost.plus(scale.bend_cost([i, m], normal, left.normal)).plus(scale.bend_cost(
                [m, k],
                normal,
                right.normal,
            ));
        }
        if at_root {
            cost = cost.plus(scale.bend_cost([i, k], normal, polygon.normals_across_edges[k]));
        }
        if is_less(&cost) {
            best = Some(ChordOptimum { cost, apex: m as u32, normal, bulge });
        }
    });
    best
}
