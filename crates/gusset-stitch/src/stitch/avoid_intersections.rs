//! Avoidance of intersections: searches for another strip if one intersects itself or a piece.
//!
//! The steps whose triangles intersect get a penalty of a few mean steps. The cheapest meridians
//! near the old ones are then searched again: the strip changes there, and stays as it was
//! elsewhere. Remaining intersections get further penalties. After some rounds the search starts
//! again from the strips of other measures. The strip with the fewest intersections is kept, the
//! first of equals.
//!
//! **Wide gaps.** Across a gap of more than a radius, the tangent planes at the rims say little about
//! the middle. There the strip of least bends competes: it replaces a strip with more intersections,
//! or with as many and much sharper bends.

use super::existing_edges::ExistingEdges;
use super::meridian::{MeridianEnds, Meridians, StepPenalty};
use super::stitch_request::Options;
use super::strip::{Strip, meridians_from_given_start, meridians_near_path};
use super::strip_neighbourhood::{IntersectingTriangles, StripNeighbourhood};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::Mesh;

/// The measures to try, in order.
const MERIDIAN_MEASURES_TO_TRY: [Meridians; 4] =
    [Meridians::Continuation, Meridians::MinArea, Meridians::MinDiagonal, Meridians::Smooth];

/// A strip across a wide gap is compared with the strip of least bends if it intersects, or if the unit
/// normals of two neighbouring triangles differ by more than this length. 1 is an angle of 60 degrees.
const MAX_NORMAL_DISTANCE_WITHOUT_COMPARISON: f64 = 1.0;

/// The largest distance between unit normals of neighbours in a strip that replaces another one with the same
/// number of intersections. 1.08 is an angle of about 65 degrees. The ratio is relative to the replaced strip.
const MAX_NORMAL_DISTANCE_OF_REPLACEMENT: f64 = 1.08;
const MAX_NORMAL_DISTANCE_RATIO_OF_REPLACEMENT: f64 = 0.65;

/// Number of strips to try for each measure.
const MAX_STRIPS_PER_MEASURE: usize = 12;

/// The penalty of a step for an intersection, in mean steps; doubled for an intersection with an
/// old face.
const PENALTY_MEAN_STEPS: f64 = 4.0;

/// Looks for intersecting faces of a strip without rows. If there are any, searches for another
/// strip. Returns the remaining pairs of faces; see
/// [`Stitch::intersections`](super::Stitch::intersections).
pub(super) fn search_strip_without_intersections(
    whole: &Mesh,
    strip: &mut Strip,
    existing: &ExistingEdges,
    unit: f64,
    options: &Options,
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    let old = StripNeighbourhood::new(whole, strip, unit, Vec::new())?.old_triangles_nearby(&[], job)?;
    let test = |strip: &Strip, job: &Job<'_>| {
        StripNeighbourhood::new(whole, strip, unit, Vec::new())?.find_intersections(&old, job)
    };
    let mut best = test(strip, &job.sub_job(0.0, 0.1))?;
    if strip.has_wide_gap()
        && (!best.pairs.is_empty() || largest_normal_distance(strip) > MAX_NORMAL_DISTANCE_WITHOUT_COMPARISON)
    {
        replace_by_least_bends_if_better(strip, &mut best, existing, options, &test, &job.sub_job(0.1, 0.1))?;
    }
    if !best.pairs.is_empty() {
        start_far_from_intersections(strip, &best)?;
        let mut best_meridians = alloc::copied(&strip.meridians)?;
        // The start has moved, and the faces are numbered from the start.
        strip.set_meridians(alloc::copied(&best_meridians)?, 0, existing, options)?;
        best = test(strip, &job.sub_job(0.1, 0.15))?;
        for (k, measure) in MERIDIAN_MEASURES_TO_TRY.into_iter().enumerate() {
            let part = job.sub_job(0.15 + 0.2 * k as f64, 0.35 + 0.2 * k as f64);
            let how = Options { meridians: measure, ..*options };
            let mut search = AvoidanceSearch { strip, existing, options: &how, test: &test };
            search.try_strips(&mut best, &mut best_meridians, &part)?;
            if best.pairs.is_empty() {
                break;
            }
        }
        strip.set_meridians(best_meridians, 0, existing, options)?;
    }
    StripNeighbourhood::new(whole, strip, unit, Vec::new())?.pairs_of_faces(&old, &best)
}

/// Replaces a strip by the strip of least bends if that has fewer intersections, or as many and a
/// much smaller largest bend.
fn replace_by_least_bends_if_better(
    strip: &mut Strip,
    best: &mut IntersectingTriangles,
    existing: &ExistingEdges,
    options: &Options,
    test: &impl Fn(&Strip, &Job<'_>) -> Result<IntersectingTriangles>,
    job: &Job<'_>,
) -> Result<()> {
    let how = Options { meridians: Meridians::Smooth, ..*options };
    let Some(smooth) = meridians_from_given_start(&strip.a, &strip.b, existing, &how, job)? else {
        return Ok(());
    };
    let (bend, own) = (largest_normal_distance(strip), alloc::copied(&strip.meridians)?);
    match strip.set_meridians(smooth.pairs, 0, existing, options) {
        Err(Error::NoStrip { .. }) => {}
        other => {
            other?;
            let found = test(strip, job)?;
            let is_smoother = largest_normal_distance(strip)
                < MAX_NORMAL_DISTANCE_OF_REPLACEMENT.min(MAX_NORMAL_DISTANCE_RATIO_OF_REPLACEMENT * bend);
            if found.pairs.len() < best.pairs.len() || found.pairs.len() == best.pairs.len() && is_smoother {
                *best = found;
                return Ok(());
            }
        }
    }
    strip.set_meridians(own, 0, existing, options)
}

/// Returns the largest distance between the unit normals of neighbours: triangles of a strip without
/// rows, and the faces along the rims. Degenerate triangles do not count.
fn largest_normal_distance(strip: &Strip) -> f64 {
    let at = |k: u32| strip.grid.points[k as usize];
    let normal = |&[p, q, r]: &[u32; 3]| (at(q) - at(p)).cross(at(r) - at(p)).normalize_or_zero();
    let triangles = strip.faces.corners.as_chunks::<3>().0;
    let bend = |p: DVec3, q: DVec3| if p == DVec3::ZERO || q == DVec3::ZERO { 0.0 } else { p.distance(q) };
    let mut before = if strip.a.closed { triangles.last().map_or(DVec3::ZERO, normal) } else { DVec3::ZERO };
    let mut largest = 0.0;
    for (triangle, step) in triangles.iter().zip(strip.meridians.windows(2)) {
        let ([i, j], [next, _]) = (step[0], step[1]);
        let (rim, k) = if next > i { (&strip.a, i) } else { (&strip.b, j) };
        let side = rim.normals[k as usize % rim.normals.len()];
        let own = normal(triangle);
        largest = f64::max(largest, bend(before, own).max(bend(side, own)));
        before = own;
    }
    largest
}

/// Rotates closed rims so that the first meridian, which stays fixed, is far from intersections: in
/// the middle of the longest run of triangles that do not intersect.
fn start_far_from_intersections(strip: &mut Strip, found: &IntersectingTriangles) -> Result<()> {
    if !strip.a.closed {
        return Ok(());
    }
    let count = strip.meridians.len() - 1;
    let mut cuts = alloc::gather(found.pairs.as_flattened().iter().copied().filter(|&k| (k as usize) < count))?;
    cuts.sort_unstable();
    let next = |k: usize| cuts.get(k + 1).map_or(cuts[0] as usize + count, |&cut| cut as usize);
    let runs = (0..cuts.len()).map(|k| (next(k) - cuts[k] as usize, cuts[k] as usize));
    let Some((length, after)) = runs.max_by_key(|&(length, after)| (length, std::cmp::Reverse(after))) else {
        return Ok(());
    };
    let first = (after + length.div_ceil(2)) % count;
    let [n, m] = strip.meridians[count];
    let [i, j] = strip.meridians[first];
    strip.a.rotate_to_start_at((i % n) as usize);
    strip.b.rotate_to_start_at((j % m) as usize);
    strip.meridians.pop();
    strip.meridians.rotate_left(first);
    strip.meridians.iter_mut().for_each(|pair| *pair = [(pair[0] + n - i) % n, (pair[1] + m - j) % m]);
    // Indices on the second round must exceed the indices before them.
    for k in 1..count {
        let before = strip.meridians[k - 1];
        for (place, (before, round)) in strip.meridians[k].iter_mut().zip(before.into_iter().zip([n, m])) {
            if *place < before {
                *place += round;
            }
        }
    }
    strip.meridians.push([n, m]);
    Ok(())
}

/// The search with one measure.
struct AvoidanceSearch<'a, T> {
    strip: &'a mut Strip,
    existing: &'a ExistingEdges,
    options: &'a Options,
    test: &'a T,
}

impl<T: Fn(&Strip, &Job<'_>) -> Result<IntersectingTriangles>> AvoidanceSearch<'_, T> {
    /// Tries strips until one is free of intersections, or no other strip is left. Keeps the best.
    fn try_strips(
        &mut self,
        best: &mut IntersectingTriangles,
        kept: &mut Vec<MeridianEnds>,
        job: &Job<'_>,
    ) -> Result<()> {
        let Some(first) = meridians_from_given_start(
            &self.strip.a,
            &self.strip.b,
            self.existing,
            self.options,
            &job.sub_job(0.0, 0.1),
        )?
        else {
            return Ok(());
        };
        let unit = PENALTY_MEAN_STEPS * first.cost / first.pairs.len() as f64;
        let mut penalties: Vec<StepPenalty> = Vec::new();
        let mut path = first.pairs;
        for round in 0..MAX_STRIPS_PER_MEASURE {
            let part = job.sub_job(
                0.1 + 0.9 * round as f64 / MAX_STRIPS_PER_MEASURE as f64,
                0.1 + 0.9 * (round + 1) as f64 / MAX_STRIPS_PER_MEASURE as f64,
            );
            match self.strip.set_meridians(alloc::copied(&path)?, 0, self.existing, self.options) {
                Err(Error::NoStrip { .. }) => return Ok(()),
                other => other?,
            }
            let found = (self.test)(self.strip, &part.sub_job(0.0, 0.6))?;
            self.penalise_intersecting_steps(&path, &found, unit, &mut penalties)?;
            let is_free = found.pairs.is_empty();
            if found.pairs.len() < best.pairs.len() {
                (*best, *kept) = (found, alloc::copied(&path)?);
            }
            if is_free {
                return Ok(());
            }
            let again = meridians_near_path(
                &self.strip.a,
                &self.strip.b,
                self.existing,
                self.options,
                &path,
                &penalties,
                &part.sub_job(0.6, 1.0),
            )?;
            let Some(next) = again else {
                return Ok(());
            };
            path = next.pairs;
        }
        Ok(())
    }

    /// Adds penalties to the steps whose triangles intersect.
    fn penalise_intersecting_steps(
        &self,
        path: &[MeridianEnds],
        found: &IntersectingTriangles,
        unit: f64,
        penalties: &mut Vec<StepPenalty>,
    ) -> Result<()> {
        for pair in &found.pairs {
            let with_old = pair.iter().any(|&k| k as usize >= path.len() - 1);
            for &k in pair.iter().filter(|&&k| (k as usize) < path.len() - 1) {
                let (from, to) = (path[k as usize], path[k as usize + 1]);
                let extra = if with_old { 2.0 * unit } else { unit };
                alloc::push(penalties, StepPenalty { end_node: to, on_b: to[0] == from[0], additional_cost: extra })?;
            }
        }
        sort::sort_stable(penalties, &|a, b| (a.end_node, a.on_b).cmp(&(b.end_node, b.on_b)));
        Ok(())
    }
}
