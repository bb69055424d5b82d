//! A start by features of rims: where two rims run alike, the pieces are put together there.
//!
//! Rims are sampled at equal steps. Each sample has a frame, of the rim's direction, the surface's
//! normal and the conormal, and a signature: where the rim is some steps before and after it, in
//! that frame. Where two pieces of one surface meet, their rims run against each other under one
//! normal, so that one pair of samples gives a motion; those whose signatures agree best are tried,
//! and the one after which most of the rims lie on each other is taken.

use super::pairs::{Found, Met, Pair, Placed};
use super::pose::Pose;
use super::scan::Scan;
use super::scene::Scene;
use crate::alloc;
use crate::boundary::{self, LoopFlags, boundary_loops};
use crate::error::Result;
use crate::geom::kd_tree::KdTree;
use crate::geom::rotation::best_rotation;
use crate::job::Job;
use crate::mesh::MeshView;
use crate::par;
use glam::{DMat3, DVec3};

const STAGE: &str = "comparing rims";
/// Samples of all rims of a piece at the most.
const MAX_SAMPLES: f64 = 512.0;
/// Where a signature looks, in steps before and after.
const OFFSETS: [usize; 4] = [3, 6, 12, 24];
/// Pairs of samples that are tried.
const TRIALS: usize = 64;
/// Rounds in which the motion is fitted to the rims that lie on each other.
const FITS: usize = 6;
/// Rims lie on each other within so many steps.
const NEAR: f64 = 1.5;
/// The least cosine between their normals, and between their directions, one against the other.
const MIN_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Fewer samples that lie on the other rim are no match; nor is a smaller share of the shorter rim.
const MIN_MATCHES: usize = 12;
const MIN_SHARE: f64 = 0.1;

type Signature = [DVec3; 2 * OFFSETS.len()];

/// The rims of a piece at equal steps.
pub(super) struct Rim {
    pub(super) points: Vec<DVec3>,
    directions: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Where each loop starts, and the end.
    starts: Vec<usize>,
    pub(super) step: f64,
}

/// The step for the rims of all pieces: the longest mean edge of their rims, or what keeps the
/// samples few.
pub(super) fn common_step(meshes: &[MeshView<'_>], unit: f64, job: &Job<'_>) -> Result<f64> {
    let mut step = 0.0f64;
    for (k, mesh) in meshes.iter().enumerate() {
        let found = boundary_loops(mesh, &boundary::Options::default(), &job.share(k, meshes.len()))?;
        let length = found.iter().map(|rim| rim.length / unit).sum::<f64>();
        step = step.max(length / MAX_SAMPLES).max(length / found.edge_count().max(1) as f64);
    }
    Ok(step)
}

impl Rim {
    /// O(F) and the samples.
    pub(super) fn new(mesh: &MeshView<'_>, scan: &Scan, step: f64, job: &Job<'_>) -> Result<Rim> {
        let found = boundary_loops(mesh, &boundary::Options::default(), job)?;
        let mut rim =
            Rim { points: Vec::new(), directions: Vec::new(), normals: Vec::new(), starts: vec![0], step };
        for walk in found.iter().filter(|walk| !walk.flags.any(LoopFlags::OPEN)) {
            rim.enter(walk.vertices, scan)?;
        }
        Ok(rim)
    }

    /// Enters the samples of one loop.
    fn enter(&mut self, vertices: &[u32], scan: &Scan) -> Result<()> {
        let n = vertices.len();
        let at = |i: usize| scan.points[vertices[i % n] as usize];
        let lengths = alloc::collect((0..n).map(|i| at(i).distance(at(i + 1))))?;
        let whole: f64 = lengths.iter().sum();
        let count = (whole / self.step).round();
        if count.is_nan() || count < 3.0 {
            return Ok(());
        }
        let (mut i, mut before) = (0, 0.0);
        let first = self.points.len();
        for k in 0..count as usize {
            let place = whole * k as f64 / count;
            while i + 1 < n && before + lengths[i] <= place {
                before += lengths[i];
                i += 1;
            }
            let t = if lengths[i] > 0.0 { ((place - before) / lengths[i]).clamp(0.0, 1.0) } else { 0.0 };
            alloc::push(&mut self.points, at(i).lerp(at(i + 1), t))?;
            let [m, n] = [i, i + 1].map(|i| scan.normals[vertices[i % n] as usize]);
            alloc::push(&mut self.normals, m.lerp(n, t).normalize_or(m))?;
        }
        let samples = &self.points[first..];
        let around = |k: usize, by: usize| samples[(k + by) % samples.len()];
        let directions = (0..samples.len()).map(|k| around(k, 1) - around(k, samples.len() - 1));
        alloc::extend(&mut self.directions, directions.map(|d| d.normalize_or_zero()))?;
        alloc::push(&mut self.starts, self.points.len())
    }

    /// The frame of a sample; `turned`: as of a rim that runs against it.
    fn frame(&self, k: usize, turned: bool) -> DMat3 {
        let along = if turned { -self.directions[k] } else { self.directions[k] };
        let normal = (self.normals[k] - along * along.dot(self.normals[k])).normalize_or_zero();
        DMat3::from_cols(along, normal, along.cross(normal))
    }

    /// The signatures of all samples; `turned`: as of a rim that runs against it.
    fn signatures(&self, turned: bool) -> Result<Vec<Signature>> {
        let mut all = alloc::with_capacity(self.points.len())?;
        for range in self.starts.windows(2) {
            let n = range[1] - range[0];
            for k in range[0]..range[1] {
                let back = self.frame(k, turned).transpose();
                all.push(std::array::from_fn(|i| {
                    let offset = OFFSETS[i / 2] % n;
                    let by = if (i % 2 == 0) == turned { n - offset } else { offset };
                    let other = self.points[range[0] + (k - range[0] + by) % n];
                    back * (other - self.points[k]) / (OFFSETS[i / 2] as f64 * self.step)
                }));
            }
        }
        Ok(all)
    }
}

/// Looks for the rims of `a` along those of `b`, up to a distance.
pub(super) fn look_along(
    a: &Placed<'_>,
    rim: &Rim,
    b: &Placed<'_>,
    (other, tree): (&Rim, &KdTree<'_>),
    gate: f64,
    reach: f64,
) -> Result<Found> {
    let across = a.pose.then(&b.pose.inverse());
    let mut met = Met { entries: 2, samples: rim.points.len(), ..Met::default() };
    met.pairs = alloc::with_capacity(2 * rim.points.len())?;
    for k in 0..rim.points.len() {
        let at = across.point(rim.points[k]);
        let (along, normal) = (across.direction(rim.directions[k]), across.direction(rim.normals[k]));
        let runs_against = |w: u32| other.directions[w as usize].dot(along) < -MIN_COSINE;
        let Some((squared, w)) = tree.nearest(at, gate * gate, runs_against) else {
            continue;
        };
        let n = other.normals[w as usize];
        let cosine = normal.dot(n);
        if cosine < MIN_COSINE {
            met.opposite += usize::from(cosine < -MIN_COSINE);
            continue;
        }
        let up = (normal + n).normalize_or(n);
        let aside = other.directions[w as usize].cross(up).normalize_or_zero();
        let points = [at, other.points[w as usize]].map(|p| b.pose.point(p));
        for direction in [up, aside] {
            met.pairs.push(Pair::new(points, b.pose.direction(direction)));
        }
        met.turn += 1.0 - cosine;
        met.squares += squared;
    }
    Found::of(&met, [a, b], rim.step, reach)
}

/// The best way to put a piece beside another: how many of its samples lie on the other's rims then,
/// and the motion into the other's coordinates.
type Match = (usize, Pose);

/// The poses that put the pieces together along rims that run alike, piece by piece from the first
/// on, the best match first; a piece without one stays where it is. O(pieces^2 * samples^2).
pub(super) fn by_rims(scene: &Scene<'_>, job: &Job<'_>) -> Result<Vec<Pose>> {
    let count = scene.members.len();
    let mut poses = alloc::filled(Pose::IDENTITY, count)?;
    let pairs = alloc::gather((0..count).flat_map(|i| (0..count).map(move |k| [i, k])).filter(|[i, k]| i < k))?;
    let found = par::map_cancellable(job, STAGE, pairs.iter(), |&[i, k]| {
        match (scene.members[i].rim, scene.members[k].rim) {
            (Some((onto, tree)), Some((from, _))) => best_match(onto, tree, from),
            _ => Ok(None),
        }
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
