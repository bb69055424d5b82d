//! Which samples of a piece lie on another one, and what they ask of the motions of the two.

use super::member::Member;
use super::pose::Pose;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

pub(super) const STAGE: &str = "aligning the pieces";
/// Samples between two progress reports: far from what is looked for each takes long.
pub(super) const SAMPLES_PER_REPORT: usize = 1 << 7;
/// The least cosine between the normals of a pair: 45 degrees.
const MIN_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Pairs that are so many standard deviations off have no weight: J. Tukey's biweight, at 95 % of
/// the efficiency of least squares.
const CUT: f64 = 4.685;
/// The standard deviation over the median of the absolute values, of normal errors.
const DEVIATION: f64 = 1.4826;
/// The median residual counts as at least this part of the spacing of points: less is below what
/// meshes say.
const MIN_RESIDUAL: f64 = 1e-6;

/// Equations of two pieces' motions: a turn and a shift of each, twelve unknowns.
#[derive(Clone)]
pub(super) struct Equations {
    /// The matrix, its lower triangle.
    pub(super) matrix: [[f64; 12]; 12],
    pub(super) right: [f64; 12],
    /// The sum of the weights.
    pub(super) weight: f64,
}

/// What the samples of one piece found on another.
#[derive(Clone)]
pub(super) struct Found {
    pub(super) equations: Equations,
    /// The samples that were looked for.
    pub(super) samples: usize,
    /// Those whose nearest point is within the gate, on no rim, and faces the same way.
    pub(super) near: usize,
    /// Those whose nearest point faces the other way.
    pub(super) opposite: usize,
    /// Those that lie on the other piece.
    pub(super) on: usize,
    /// The mean and the mean square of the distances of those, along the normals.
    pub(super) mean: f64,
    pub(super) square: f64,
    /// The mean of 1 less the cosine between the normals: what noise turns them by.
    pub(super) turn: f64,
    /// The root of the mean square of the distances of those near.
    pub(super) distance: f64,
}

/// A piece, and where it lies now.
#[derive(Clone, Copy)]
pub(super) struct Placed<'a> {
    pub(super) member: &'a Member<'a>,
    pub(super) pose: Pose,
}

/// A pair of points, a direction along which they should not differ, and by how much they do.
pub(super) struct Pair {
    pub(super) points: [DVec3; 2],
    pub(super) along: DVec3,
    pub(super) off: f64,
}

impl Pair {
    pub(super) fn new(points: [DVec3; 2], along: DVec3) -> Pair {
        Pair { points, along, off: (points[0] - points[1]).dot(along) }
    }
}

/// What a piece met while it looked.
#[derive(Default)]
pub(super) struct Met {
    /// Pairs, so many entries for each.
    pub(super) pairs: Vec<Pair>,
    pub(super) entries: usize,
    pub(super) samples: usize,
    pub(super) opposite: usize,
    /// Sums over the pairs: of 1 less the cosine between their normals, of squared distances.
    pub(super) turn: f64,
    pub(super) squares: f64,
}

/// Looks for samples of `a` on `b`, up to a distance. `reach`: what counts as on the surface.
pub(super) fn look<'s>(
    a: &Placed<'_>,
    samples: impl ExactSizeIterator<Item = &'s u32>,
    b: &Placed<'_>,
    gate: f64,
    reach: f64,
    job: &Job<'_>,
) -> Result<Found> {
    let across = a.pose.then(&b.pose.inverse());
    let [from, onto] = [a.member.scan, b.member.scan];
    let pairs = alloc::with_capacity(samples.len())?;
    let mut met = Met { pairs, entries: 1, samples: samples.len(), ..Met::default() };
    let count = samples.len();
    for (k, &v) in samples.enumerate() {
        job.step_every(SAMPLES_PER_REPORT, k, count, STAGE)?;
        let at = across.point(from.points[v as usize]);
        if onto.bounds.distance_squared(at) > gate * gate {
            continue;
        }
        let is_used = |w: u32| onto.normals[w as usize] != DVec3::ZERO;
        let Some((squared, w)) = b.member.tree.nearest(at, gate * gate, is_used) else {
            continue;
        };
        if onto.rim.contains(w) {
            continue;
        }
        let (m, n) = (across.direction(from.normals[v as usize]), onto.normals[w as usize]);
        let cosine = m.dot(n);
        if cosine < MIN_COSINE {
            met.opposite += usize::from(cosine < -MIN_COSINE);
            continue;
        }
        let points = [at, onto.points[w as usize]].map(|p| b.pose.point(p));
        met.pairs.push(Pair::new(points, b.pose.direction((m + n).normalize_or(n))));
        met.turn += 1.0 - cosine;
        met.squares += squared;
    }
    Found::of(&met, [a, b], from.spacing.max(onto.spacing), reach)
}

impl Found {
    /// The equations of what was met, and the account of it.
    pub(super) fn of(met: &Met, [a, b]: [&Placed<'_>; 2], spacing: f64, reach: f64) -> Result<Found> {
        let near = met.pairs.len() / met.entries;
        let count = near.max(1) as f64;
        let mut sizes = alloc::collect(met.pairs.iter().map(|pair| pair.off.abs()))?;
        let median = match sizes.len() {
            0 => 0.0,
            n => *sizes.select_nth_unstable_by(n / 2, f64::total_cmp).1,
        };
        let cut = CUT * DEVIATION * median.max(MIN_RESIDUAL * spacing);
        let mut found = Found {
            equations: Equations { matrix: [[0.0; 12]; 12], right: [0.0; 12], weight: 0.0 },
            samples: met.samples,
            near,
            opposite: met.opposite,
            on: 0,
            mean: 0.0,
            square: 0.0,
            turn: met.turn / count,
            distance: (met.squares / count).sqrt(),
        };
        let centres = [a, b].map(|placed| placed.pose.point(placed.member.scan.mean));
        let radii = [a, b].map(|placed| placed.member.scan.radius);
        for pair in met.pairs.chunks_exact(met.entries) {
            for entry in pair {
                let part = 1.0 - (entry.off / cut).powi(2);
                if part > 0.0 {
                    found.equations.enter(entry, part * part, centres, radii);
                }
            }
            let square = pair.iter().map(|entry| entry.off * entry.off).sum::<f64>();
            if square.sqrt() <= reach {
                found.on += 1;
                found.mean += square.sqrt();
                found.square += square;
            }
        }
        found.mean /= found.on.max(1) as f64;
        found.square /= found.on.max(1) as f64;
        Ok(found)
    }
}

impl Equations {
    /// Enters (x - y) . n + (u + w x (x - g)) . n - (u' + w' x (y - g')) . n = 0, with turns in
    /// radii of the pieces, so that they are as long as shifts.
    fn enter(&mut self, pair: &Pair, weight: f64, centres: [DVec3; 2], radii: [f64; 2]) {
        let [x, y] = pair.points;
        let along = pair.along;
        let turns = [(x - centres[0]).cross(along) / radii[0], (y - centres[1]).cross(along) / -radii[1]];
        let [[a, b, c], [d, e, f]] = turns.map(|turn| turn.to_array());
        let [p, q, r] = along.to_array();
        let row = [a, b, c, p, q, r, d, e, f, -p, -q, -r];
        for i in 0..12 {
            let weighted = weight * row[i];
            (0..=i).for_each(|j| self.matrix[i][j] += weighted * row[j]);
            self.right[i] -= weighted * pair.off;
        }
        self.weight += weight;
    }
}
