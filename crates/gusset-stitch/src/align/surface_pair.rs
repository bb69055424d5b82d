//! The pose of one piece on another, by features of their surfaces, and its certificate.
//!
//! Each set of consistent matches gives a pose. A few samples screen the poses, and all samples
//! refine the best. The certificate compares the best pose with its rivals.

use super::consistent_matches::ConsistentMatches;
use super::pose::Pose;
use super::surface_matches::{Match, match_features};
use super::surface_pose::{Comparison, SampledSurface, SurfaceFit, fit_matches, measure_surface_fit};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Number of sets of matches that are tried.
const MAX_TRIED_SETS: usize = 64;
/// Number of samples for the first comparison of poses.
const SCREENING_SAMPLES: usize = 200;
/// Number of poses that are compared with all samples.
const MAX_REFINED_POSES: usize = 8;
/// Normals count as points at this number of spacings when a motion is fitted to matches.
const NORMAL_LENGTH: f64 = 2.0;
/// A motion explains a match if it moves one sample to within this number of spacings of the other.
const MAX_EXPLAINED_DISTANCE: f64 = 2.0;
/// Number of rounds that improve a pose. The tolerance falls from the first round to the last.
const SCREENING_ROUNDS: usize = 3;
const REFINING_ROUNDS: usize = 8;
const FIRST_TOLERANCE: f64 = 2.5;
/// Two poses are distinct if they move the points apart by more than this number of spacings, root
/// mean square.
const MIN_DISTINCT_DISTANCE: f64 = 3.0;

/// Smallest number of samples on the surface, and smallest share of the smaller piece's samples,
/// for a certain pose.
const MIN_CERTAIN_SAMPLES: usize = 60;
const MIN_CERTAIN_SHARE: f64 = 0.1;
/// Smallest share of the compared samples that are on the surface, for a certain pose.
const MIN_CERTAIN_FIT: f64 = 0.75;
/// Smallest concentration of the distances at 0, for a certain pose.
const MIN_CERTAIN_SHARPNESS: f64 = 0.6;
/// Largest score of a rival, relative to the score of a certain pose.
const MAX_CERTAIN_RIVAL: f64 = 0.5;
/// Poses are in conflict with a piece if they compare at least this number of samples with it, ...
const MIN_CONFLICTING_SAMPLES: usize = 60;
/// ... and less than this share of them is on its surface.
const MIN_FREE_OF_CONFLICT_SHARE: f64 = 0.5;

/// A pose of the second piece on the first.
#[derive(Clone)]
pub(super) struct SurfacePose {
    pub(super) pose: Pose,
    fit: SurfaceFit,
    /// The score of the best distinct pose.
    rival: f64,
}

impl SurfacePose {
    /// Returns the score of the pose.
    pub(super) fn score(&self) -> f64 {
        self.fit.score()
    }

    /// Returns true if the pose is certain: the pieces overlap enough, fit, and hold each other,
    /// and no distinct pose fits half as well. `self_score` is the score of the best motion that
    /// fits one of the pieces to itself: after it, another pose would fit too.
    pub(super) fn is_certain(&self, sample_counts: [usize; 2], self_score: f64) -> bool {
        let fit = &self.fit;
        let smaller = sample_counts[0].min(sample_counts[1]) as f64;
        let [stiffness, part_by_noise] = fit.hold_stiffness();
        fit.on_surface >= MIN_CERTAIN_SAMPLES
            && fit.on_surface as f64 >= MIN_CERTAIN_SHARE * smaller
            && fit.on_surface as f64 >= MIN_CERTAIN_FIT * fit.compared as f64
            && fit.sharpness() >= MIN_CERTAIN_SHARPNESS
            && stiffness > part_by_noise
            && self.rival.max(self_score) <= MAX_CERTAIN_RIVAL * fit.score()
    }
}

/// Returns true if the pose contradicts the surfaces: many samples are near the other surface, and
/// few are on it.
pub(super) fn are_in_conflict(
    surfaces: [&SampledSurface<'_>; 2],
    pose: &Pose,
    spacing: f64,
    job: &Job<'_>,
) -> Result<bool> {
    let fit = measure_surface_fit(surfaces, pose, spacing, Comparison::FINAL, job)?;
    let is_free = fit.on_surface as f64 >= MIN_FREE_OF_CONFLICT_SHARE * fit.compared as f64;
    Ok(fit.compared >= MIN_CONFLICTING_SAMPLES && !is_free)
}

/// Returns the best pose of `surfaces[1]` on `surfaces[0]` that satisfies `accept`; `None` if no
/// pose fits. O(samples^2 + matches^2).
pub(super) fn find_surface_pose(
    surfaces: [&SampledSurface<'_>; 2],
    spacing: f64,
    accept: impl Fn(&Pose) -> bool,
    job: &Job<'_>,
) -> Result<Option<SurfacePose>> {
    let matches = match_features(surfaces.map(|surface| surface.features), &job.sub_job(0.0, 0.3))?;
    let screened = screen_consistent_sets(surfaces, &matches, spacing, &job.sub_job(0.3, 0.7))?;
    let mut refined: Vec<(Pose, SurfaceFit)> = alloc::with_capacity(MAX_REFINED_POSES)?;
    let is_new = |pose: &Pose, refined: &[(Pose, SurfaceFit)]| {
        refined.iter().all(|(other, _)| are_distinct(pose, other, surfaces[1], spacing)) && accept(pose)
    };
    let mut tries = 0;
    for (pose, _) in &screened {
        if tries == MAX_REFINED_POSES || !is_new(pose, &refined) {
            continue;
        }
        let job = job.sub_job(0.7, 1.0).sub_job_of_item(tries, MAX_REFINED_POSES);
        tries += 1;
        let better = improve_pose(surfaces, *pose, spacing, 1, REFINING_ROUNDS, &job)?;
        if is_new(&better.0, &refined) {
            refined.push(better);
        }
    }
    sort_by_score(&mut refined);
    let rival = refined.get(1).map_or(0.0, |(_, fit)| fit.score());
    let best = refined.into_iter().next().filter(|(_, fit)| fit.score() > 0.0);
    Ok(best.map(|(pose, fit)| SurfacePose { pose, fit, rival }))
}

/// Returns the score of the best motion that fits a surface to itself, without the identity.
pub(super) fn find_self_score(surface: &SampledSurface<'_>, spacing: f64, job: &Job<'_>) -> Result<f64> {
    let moves = |pose: &Pose| are_distinct(pose, &Pose::IDENTITY, surface, spacing);
    let best = find_surface_pose([surface, surface], spacing, moves, job)?;
    Ok(best.map_or(0.0, |best| best.score()))
}

/// Returns the poses of consistent matches, compared with some of the samples, the best first. Each
/// pose begins with matches that no pose before explains.
fn screen_consistent_sets(
    surfaces: [&SampledSurface<'_>; 2],
    matches: &[Match],
    spacing: f64,
    job: &Job<'_>,
) -> Result<Vec<(Pose, SurfaceFit)>> {
    let samples = surfaces.map(|surface| surface.samples);
    let mut consistent = ConsistentMatches::new(samples, matches, spacing, &job.sub_job(0.0, 0.5))?;
    let stride = samples[1].points.len().div_ceil(SCREENING_SAMPLES).max(1);
    let mut screened: Vec<(Pose, SurfaceFit)> = alloc::with_capacity(MAX_TRIED_SETS)?;
    while screened.len() < MAX_TRIED_SETS {
        let job = job.sub_job(0.5, 1.0).sub_job_of_item(screened.len(), MAX_TRIED_SETS);
        let Some(set) = consistent.next_set()? else { break };
        let pose = fit_matches(samples, &set, NORMAL_LENGTH * spacing);
        let better = improve_pose(surfaces, pose, spacing, stride, SCREENING_ROUNDS, &job)?;
        for pose in [&pose, &better.0] {
            consistent.mark_explained(|[i, k]| {
                let moved = pose.transform_point(samples[1].points[k as usize]);
                moved.distance(samples[0].points[i as usize]) <= MAX_EXPLAINED_DISTANCE * spacing
            });
        }
        screened.push(better);
    }
    sort_by_score(&mut screened);
    Ok(screened)
}

/// Sorts poses by their scores, the best first. Equal poses keep their order.
fn sort_by_score(poses: &mut [(Pose, SurfaceFit)]) {
    // Insertion: at most 64 poses, without memory.
    for k in 1..poses.len() {
        let place = poses[..k].iter().position(|(_, fit)| fit.score() < poses[k].1.score()).unwrap_or(k);
        poses[place..=k].rotate_right(1);
    }
}

/// Improves a pose, and returns how well it fits.
fn improve_pose(
    surfaces: [&SampledSurface<'_>; 2],
    mut pose: Pose,
    spacing: f64,
    stride: usize,
    rounds: usize,
    job: &Job<'_>,
) -> Result<(Pose, SurfaceFit)> {
    for round in 0..rounds {
        let tolerance = FIRST_TOLERANCE + (1.0 - FIRST_TOLERANCE) * round as f64 / rounds as f64;
        let job = job.sub_job_of_item(round, rounds + 1);
        let fit = measure_surface_fit(surfaces, &pose, spacing, Comparison { tolerance, stride }, &job)?;
        let Some(better) = fit.improve_pose(&pose, surfaces[1].radius) else { break };
        pose = better;
    }
    let last = Comparison { stride, ..Comparison::FINAL };
    let fit = measure_surface_fit(surfaces, &pose, spacing, last, &job.sub_job(1.0, 1.0))?;
    Ok((pose, fit))
}

/// Returns true if two poses move the points apart. A rotation R moves isotropic points of radius r
/// by r |R| / sqrt(3), root mean square, with the Frobenius norm.
fn are_distinct(a: &Pose, b: &Pose, moved: &SampledSurface<'_>, spacing: f64) -> bool {
    let difference = a.rotation - b.rotation;
    let turned = difference.to_cols_array().iter().map(|x| x * x).sum::<f64>() / 3.0 * moved.radius * moved.radius;
    let shifted = (a.translation - b.translation).length_squared();
    turned + shifted > (MIN_DISTINCT_DISTANCE * spacing).powi(2)
}
