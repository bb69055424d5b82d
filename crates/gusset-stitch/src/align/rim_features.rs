//! An initial alignment by features of rims: pieces are joined where their rims match.
//!
//! Where two pieces of one surface meet, their rims run in opposite directions with a common
//! normal. One pair of samples therefore determines a motion. The pairs with the most similar
//! signatures are tried, and the motion with the longest common rim is kept.

use super::alignment_scene::AlignmentScene;
use super::pose::Pose;
use super::sampled_rims::{MIN_RIM_NORMAL_COSINE, RimSignature, STAGE, SampledRims};
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::rotation::rotation_maximising_trace;
use gusset_base::job::Job;
use gusset_base::par;

/// Number of pairs of samples to try.
const MAX_TRIED_SAMPLE_PAIRS: usize = 64;
/// Number of rounds that fit a motion to the coincident rims.
const MOTION_FIT_ROUNDS: usize = 6;
/// Rims coincide within this number of steps.
const MAX_COINCIDENCE_DISTANCE_STEPS: f64 = 1.5;
/// Smallest number of coincident samples of a match, and smallest share of the shorter rim.
const MIN_COINCIDENT_SAMPLES: usize = 12;
const MIN_COINCIDENT_SHARE: f64 = 0.1;

/// The best way to join a piece to another: the number of its samples on the other's rims, and the
/// motion into the other's coordinates.
type RimMatch = (usize, Pose);

/// Returns the poses that join the pieces along matching rims, starting from the first piece, the
/// best match first. A piece without a match does not move. O(pieces^2 * samples^2).
pub(super) fn align_matching_rims(scene: &AlignmentScene<'_>, job: &Job<'_>) -> Result<Vec<Pose>> {
    let count = scene.sampled_pieces.len();
    let mut poses = alloc::filled(Pose::IDENTITY, count)?;
    let pairs = alloc::gather((0..count).flat_map(|i| (0..count).map(move |k| [i, k])).filter(|[i, k]| i < k))?;
    let matches = par::map_cancellable(job, STAGE, pairs.iter(), |&[i, k]| {
        match (scene.sampled_pieces[i].rim, scene.sampled_pieces[k].rim) {
            (Some((onto, tree)), Some((from, _))) => best_rim_match(onto, tree, from),
            _ => Ok(None),
        }
    })?;
    let matches = alloc::try_collect(matches)?;
    let mut is_placed = alloc::filled(false, count)?;
    if let Some(first) = is_placed.first_mut() {
        *first = true;
    }
    loop {
        // The best match between a placed piece and one that is not placed.
        let open = pairs.iter().zip(&matches).filter(|(pair, _)| is_placed[pair[0]] != is_placed[pair[1]]);
        let best = open.filter_map(|(&pair, found)| found.map(|found| (pair, found)));
        let Some(([i, k], (_, pose))) = best.reduce(|x, y| if y.1.0 > x.1.0 { y } else { x }) else {
            return Ok(poses);
        };
        let (placed, new, motion) = if is_placed[i] { (i, k, pose) } else { (k, i, pose.inverse()) };
        poses[new] = motion.followed_by(&poses[placed]);
        is_placed[new] = true;
    }
}

/// Returns the motion of `from` that puts most of its samples on the rims of `onto`; `None` without
/// a match.
fn best_rim_match(onto: &SampledRims, tree: &KdTree<'_>, from: &SampledRims) -> Result<Option<RimMatch>> {
    let (theirs, own) = (onto.sample_signatures(false)?, from.sample_signatures(true)?);
    let mut trials: Vec<(f64, usize, usize)> = Vec::new();
    let differ = |a: &RimSignature, b: &RimSignature| a.iter().zip(b).map(|(a, b)| a.distance_squared(*b)).sum::<f64>();
    for (i, a) in theirs.iter().enumerate() {
        // Keep the most similar sample only: its neighbours lead to a similar motion.
        let all = own.iter().enumerate().map(|(k, b)| (differ(a, b), i, k));
        alloc::extend(&mut trials, all.reduce(|x, y| if y.0 < x.0 { y } else { x }))?;
    }
    trials.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
    trials.truncate(MAX_TRIED_SAMPLE_PAIRS);
    let mut best: Option<RimMatch> = None;
    for (_, i, k) in trials {
        let rotation = onto.sample_frame(i, false) * from.sample_frame(k, true).transpose();
        let mut pose = Pose { rotation, translation: onto.points[i] - rotation * from.points[k] };
        for _ in 0..MOTION_FIT_ROUNDS {
            let near = find_coincident_samples(onto, tree, from, &pose)?;
            if best.is_none_or(|(count, _)| near.len() > count) {
                best = Some((near.len(), pose));
            }
            let Some(fitted) = best_fit_motion(onto, from, &near) else {
                break;
            };
            pose = fitted;
        }
    }
    let shorter = onto.points.len().min(from.points.len()) as f64;
    Ok(best.filter(|&(count, _)| count >= MIN_COINCIDENT_SAMPLES && count as f64 >= MIN_COINCIDENT_SHARE * shorter))
}

/// Returns the samples of `from` that lie on the rims of `onto`, with the samples there.
fn find_coincident_samples(
    onto: &SampledRims,
    tree: &KdTree<'_>,
    from: &SampledRims,
    pose: &Pose,
) -> Result<Vec<[usize; 2]>> {
    let max_distance = MAX_COINCIDENCE_DISTANCE_STEPS * onto.step;
    alloc::gather((0..from.points.len()).filter_map(|k| {
        let (along, normal) = (pose.rotate_direction(from.directions[k]), pose.rotate_direction(from.normals[k]));
        let fits = |w: u32| {
            onto.directions[w as usize].dot(along) < -MIN_RIM_NORMAL_COSINE
                && onto.normals[w as usize].dot(normal) > MIN_RIM_NORMAL_COSINE
        };
        tree.nearest(pose.transform_point(from.points[k]), max_distance * max_distance, fits)
            .map(|(_, w)| [k, w as usize])
    }))
}

/// Returns the motion that minimises the squared distances of the pairs; `None` for fewer than
/// three pairs.
fn best_fit_motion(onto: &SampledRims, from: &SampledRims, pairs: &[[usize; 2]]) -> Option<Pose> {
    if pairs.len() < 3 {
        return None;
    }
    let n = pairs.len() as f64;
    let mean = |at: &dyn Fn(&[usize; 2]) -> DVec3| pairs.iter().map(at).sum::<DVec3>() / n;
    let (source, target) = (mean(&|pair| from.points[pair[0]]), mean(&|pair| onto.points[pair[1]]));
    let mut covariance = DMat3::ZERO;
    for [k, w] in pairs {
        let (p, q) = (from.points[*k] - source, onto.points[*w] - target);
        covariance += DMat3::from_cols(p.x * q, p.y * q, p.z * q);
    }
    let rotation = DMat3::from_quat(rotation_maximising_trace(covariance));
    Some(Pose { rotation, translation: target - rotation * source })
}
