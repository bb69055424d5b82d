//! A start by features of rims: where two rims run alike, the pieces are put together there.
//!
//! Where two pieces of one surface meet, their rims run against each other under one normal, so
//! that one pair of samples gives a motion; those whose signatures agree best are tried, and the
//! one after which most of the rims lie on each other is taken.

use super::pose::Pose;
use super::sampled_rim::{MIN_COSINE, Rim, STAGE, Signature};
use super::scene::Scene;
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::rotation::best_rotation;
use gusset_base::job::Job;
use gusset_base::par;

/// Pairs of samples that are tried.
const TRIALS: usize = 64;
/// Rounds in which the motion is fitted to the rims that lie on each other.
const FITS: usize = 6;
/// Rims lie on each other within so many steps.
const NEAR: f64 = 1.5;
/// Fewer samples that lie on the other rim are no match; nor is a smaller share of the shorter rim.
const MIN_MATCHES: usize = 12;
const MIN_SHARE: f64 = 0.1;

/// The best way to put a piece beside another: how many of its samples lie on the other's rims
/// then, and the motion into the other's coordinates.
type Match = (usize, Pose);

/// The poses that put the pieces together along rims that run alike, piece by piece from the first
/// on, the best match first; a piece without one stays where it is. O(pieces^2 * samples^2).
pub(super) fn by_rims(scene: &Scene<'_>, job: &Job<'_>) -> Result<Vec<Pose>> {
    let count = scene.members.len();
    let mut poses = alloc::filled(Pose::IDENTITY, count)?;
    let pairs = alloc::gather((0..count).flat_map(|i| (0..count).map(move |k| [i, k])).filter(|[i, k]| i < k))?;
    let found =
        par::map_cancellable(job, STAGE, pairs.iter(), |&[i, k]| match (scene.members[i].rim, scene.members[k].rim) {
            (Some((onto, tree)), Some((from, _))) => best_match(onto, tree, from),
            _ => Ok(None),
        })?;
    let found = alloc::try_collect(found)?;
    let mut is_placed = alloc::filled(false, count)?;
    if let Some(first) = is_placed.first_mut() {
        *first = true;
    }
    loop {
        // The best match of a piece that is placed and one that is not.
        let open = pairs.iter().zip(&found).filter(|(pair, _)| is_placed[pair[0]] != is_placed[pair[1]]);
        let best = open.filter_map(|(&pair, found)| found.map(|found| (pair, found)));
        let Some(([i, k], (_, pose))) = best.reduce(|x, y| if y.1.0 > x.1.0 { y } else { x }) else {
            return Ok(poses);
        };
        let (placed, new, motion) = if is_placed[i] { (i, k, pose) } else { (k, i, pose.inverse()) };
        poses[new] = motion.then(&poses[placed]);
        is_placed[new] = true;
    }
}

/// The motion of `from` after which most of its samples lie on the rims of `onto`; `None` if none
/// is a match.
fn best_match(onto: &Rim, tree: &KdTree<'_>, from: &Rim) -> Result<Option<Match>> {
    let (theirs, own) = (onto.signatures(false)?, from.signatures(true)?);
    let mut trials: Vec<(f64, usize, usize)> = Vec::new();
    let differ = |a: &Signature, b: &Signature| a.iter().zip(b).map(|(a, b)| a.distance_squared(*b)).sum::<f64>();
    for (i, a) in theirs.iter().enumerate() {
        // Of each sample the one that is most alike: its neighbours would say the same.
        let all = own.iter().enumerate().map(|(k, b)| (differ(a, b), i, k));
        alloc::extend(&mut trials, all.reduce(|x, y| if y.0 < x.0 { y } else { x }))?;
    }
    trials.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
    trials.truncate(TRIALS);
    let mut best: Option<Match> = None;
    for (_, i, k) in trials {
        let rotation = onto.frame(i, false) * from.frame(k, true).transpose();
        let mut pose = Pose { rotation, translation: onto.points[i] - rotation * from.points[k] };
        for _ in 0..FITS {
            let near = near_samples(onto, tree, from, &pose)?;
            if best.is_none_or(|(count, _)| near.len() > count) {
                best = Some((near.len(), pose));
            }
            let Some(fitted) = fitted(onto, from, &near) else {
                break;
            };
            pose = fitted;
        }
    }
    let shorter = onto.points.len().min(from.points.len()) as f64;
    Ok(best.filter(|&(count, _)| count >= MIN_MATCHES && count as f64 >= MIN_SHARE * shorter))
}

/// The samples of `from` that lie on the rims of `onto`, with the samples there.
fn near_samples(onto: &Rim, tree: &KdTree<'_>, from: &Rim, pose: &Pose) -> Result<Vec<[usize; 2]>> {
    let gate = NEAR * onto.step;
    alloc::gather((0..from.points.len()).filter_map(|k| {
        let (along, normal) = (pose.direction(from.directions[k]), pose.direction(from.normals[k]));
        let fits = |w: u32| {
            onto.directions[w as usize].dot(along) < -MIN_COSINE && onto.normals[w as usize].dot(normal) > MIN_COSINE
        };
        tree.nearest(pose.point(from.points[k]), gate * gate, fits).map(|(_, w)| [k, w as usize])
    }))
}

/// The motion that brings pairs nearest to each other; `None` of fewer than three.
fn fitted(onto: &Rim, from: &Rim, pairs: &[[usize; 2]]) -> Option<Pose> {
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
    let rotation = DMat3::from_quat(best_rotation(covariance));
    Some(Pose { rotation, translation: target - rotation * source })
}
