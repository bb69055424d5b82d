//! Pairs of samples of one piece on another, and their equations for the motions of both.

use super::pose::Pose;
use super::sampled_piece::SampledPiece;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

pub(super) const STAGE: &str = "aligning the pieces";
/// Number of samples between two progress reports. A search far from the other piece is slow.
pub(super) const SAMPLES_PER_REPORT: usize = 1 << 7;
/// Smallest cosine between the normals of a pair: 45 degrees.
const MIN_PAIR_NORMAL_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Pairs beyond this number of standard deviations get weight 0: J. Tukey's biweight, at 95 % of
/// the efficiency of least squares.
const TUKEY_CUTOFF_DEVIATIONS: f64 = 4.685;
/// The ratio of the standard deviation to the median absolute value, for normally distributed
/// errors.
const DEVIATION_PER_MEDIAN: f64 = 1.4826;
/// Lower bound of the median residual, relative to the spacing of points: smaller residuals are
/// below the precision of meshes.
const MIN_RELATIVE_RESIDUAL: f64 = 1e-6;

/// The equations for two pieces' motions: twelve unknowns, a rotation and a translation of each.
#[derive(Clone)]
pub(super) struct MotionEquations {
    /// The lower triangle of the matrix.
    pub(super) matrix: [[f64; 12]; 12],
    pub(super) right_side: [f64; 12],
    /// The sum of the weights.
    pub(super) weight_sum: f64,
}

/// The pairs between the samples of one piece and another piece: equations and statistics.
#[derive(Clone)]
pub(super) struct SamplePairReport {
    pub(super) equations: MotionEquations,
    /// The number of samples that were searched.
    pub(super) samples: usize,
    /// The number of samples whose nearest point is at most the largest distance away, not on a
    /// rim, and faces the same side.
    pub(super) near_samples: usize,
    /// The number of samples whose nearest point faces the opposite side.
    pub(super) opposite_samples: usize,
    /// The number of samples that lie on the other piece.
    pub(super) samples_on_surface: usize,
    /// The mean, and the mean square, of the distances of these samples along the normals.
    pub(super) mean_distance: f64,
    pub(super) mean_squared_distance: f64,
    /// The mean of 1 minus the cosine between the normals: their noise.
    pub(super) mean_normal_deviation: f64,
    /// The root mean square distance of the near samples.
    pub(super) rms_distance: f64,
}

/// A piece and its current pose.
#[derive(Clone, Copy)]
pub(super) struct PosedPiece<'a> {
    pub(super) sampled_piece: &'a SampledPiece<'a>,
    pub(super) pose: Pose,
}

/// A pair of points, the direction along which they should coincide, and their distance along it.
pub(super) struct SamplePair {
    pub(super) points: [DVec3; 2],
    pub(super) direction: DVec3,
    pub(super) signed_distance: f64,
}

impl SamplePair {
    pub(super) fn new(points: [DVec3; 2], along: DVec3) -> SamplePair {
        SamplePair { points, direction: along, signed_distance: (points[0] - points[1]).dot(along) }
    }
}

/// The pairs found by one search.
#[derive(Default)]
pub(super) struct SamplePairList {
    /// The pairs, with `entries` consecutive entries for each sample.
    pub(super) pairs: Vec<SamplePair>,
    pub(super) entries: usize,
    pub(super) samples: usize,
    pub(super) opposite: usize,
    /// The sums over the pairs of 1 minus the cosine between their normals, and of squared
    /// distances.
    pub(super) normal_deviation_sum: f64,
    pub(super) squared_distance_sum: f64,
}

/// Pairs each sample of `a` with the nearest vertex of `b`, at most `max_distance` away, with a
/// similar normal. Pairs at most `max_on_surface_distance` apart count as on the surface.
pub(super) fn find_sample_pairs<'s>(
    a: &PosedPiece<'_>,
    samples: impl ExactSizeIterator<Item = &'s u32>,
    b: &PosedPiece<'_>,
    max_distance: f64,
    max_on_surface_distance: f64,
    job: &Job<'_>,
) -> Result<SamplePairReport> {
    let across = a.pose.followed_by(&b.pose.inverse());
    let [from, onto] = [a.sampled_piece.scan, b.sampled_piece.scan];
    let pairs = alloc::with_capacity(samples.len())?;
    let mut list = SamplePairList { pairs, entries: 1, samples: samples.len(), ..SamplePairList::default() };
    let count = samples.len();
    for (k, &v) in samples.enumerate() {
        job.step_every(SAMPLES_PER_REPORT, k, count, STAGE)?;
        let at = across.transform_point(from.points[v as usize]);
        if onto.bounds.distance_squared(at) > max_distance * max_distance {
            continue;
        }
        let is_used = |w: u32| onto.normals[w as usize] != DVec3::ZERO;
        let Some((squared, w)) = b.sampled_piece.tree.nearest(at, max_distance * max_distance, is_used) else {
            continue;
        };
        if onto.is_rim_vertex.contains(w) {
            continue;
        }
        let (m, n) = (across.rotate_direction(from.normals[v as usize]), onto.normals[w as usize]);
        let cosine = m.dot(n);
        if cosine < MIN_PAIR_NORMAL_COSINE {
            list.opposite += usize::from(cosine < -MIN_PAIR_NORMAL_COSINE);
            continue;
        }
        let points = [at, onto.points[w as usize]].map(|p| b.pose.transform_point(p));
        list.pairs.push(SamplePair::new(points, b.pose.rotate_direction((m + n).normalize_or(n))));
        list.normal_deviation_sum += 1.0 - cosine;
        list.squared_distance_sum += squared;
    }
    SamplePairReport::new(&list, [a, b], from.spacing.max(onto.spacing), max_on_surface_distance)
}

impl SamplePairReport {
    /// Computes the equations and the statistics of the pairs.
    pub(super) fn new(
        list: &SamplePairList,
        [a, b]: [&PosedPiece<'_>; 2],
        spacing: f64,
        max_on_surface_distance: f64,
    ) -> Result<SamplePairReport> {
        let near = list.pairs.len() / list.entries;
        let count = near.max(1) as f64;
        let mut sizes = alloc::collect(list.pairs.iter().map(|pair| pair.signed_distance.abs()))?;
        let median = match sizes.len() {
            0 => 0.0,
            n => *sizes.select_nth_unstable_by(n / 2, f64::total_cmp).1,
        };
        let cut = TUKEY_CUTOFF_DEVIATIONS * DEVIATION_PER_MEDIAN * median.max(MIN_RELATIVE_RESIDUAL * spacing);
        let mut found = SamplePairReport {
            equations: MotionEquations { matrix: [[0.0; 12]; 12], right_side: [0.0; 12], weight_sum: 0.0 },
            samples: list.samples,
            near_samples: near,
            opposite_samples: list.opposite,
            samples_on_surface: 0,
            mean_distance: 0.0,
            mean_squared_distance: 0.0,
            mean_normal_deviation: list.normal_deviation_sum / count,
            rms_distance: (list.squared_distance_sum / count).sqrt(),
        };
        let centres = [a, b].map(|placed| placed.pose.transform_point(placed.sampled_piece.scan.mean_of_corners));
        let radii = [a, b].map(|placed| placed.sampled_piece.scan.radius);
        for pair in list.pairs.chunks_exact(list.entries) {
            for entry in pair {
                let part = 1.0 - (entry.signed_distance / cut).powi(2);
                if part > 0.0 {
                    found.equations.add_sample_pair(entry, part * part, centres, radii);
                }
            }
            let square = pair.iter().map(|entry| entry.signed_distance * entry.signed_distance).sum::<f64>();
            if square.sqrt() <= max_on_surface_distance {
                found.samples_on_surface += 1;
                found.mean_distance += square.sqrt();
                found.mean_squared_distance += square;
            }
        }
        found.mean_distance /= found.samples_on_surface.max(1) as f64;
        found.mean_squared_distance /= found.samples_on_surface.max(1) as f64;
        Ok(found)
    }
}

impl MotionEquations {
    /// Adds (x - y) . n + (u + w x (x - g)) . n - (u' + w' x (y - g')) . n = 0. Rotations are in
    /// units of the pieces' radii, so that they are comparable with translations.
    fn add_sample_pair(&mut self, pair: &SamplePair, weight: f64, centres: [DVec3; 2], radii: [f64; 2]) {
        let [x, y] = pair.points;
        let along = pair.direction;
        let turns = [(x - centres[0]).cross(along) / radii[0], (y - centres[1]).cross(along) / -radii[1]];
        let [[a, b, c], [d, e, f]] = turns.map(|turn| turn.to_array());
        let [p, q, r] = along.to_array();
        let row = [a, b, c, p, q, r, d, e, f, -p, -q, -r];
        for i in 0..12 {
            let weighted = weight * row[i];
            (0..=i).for_each(|j| self.matrix[i][j] += weighted * row[j]);
            self.right_side[i] -= weighted * pair.signed_distance;
        }
        self.weight_sum += weight;
    }
}
