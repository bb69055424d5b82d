//! A pose of one sampled surface on another: how well it fits, and the motion that fits better.
//!
//! A sample of the moved surface is compared with the nearest dense point of the fixed surface that
//! faces the same side. If that point is beside the sample rather than above or below it, the fixed
//! surface ends there, and the sample says nothing.

use super::motion_system::MotionVector;
use super::pose::Pose;
use super::surface_features::SurfaceFeature;
use super::surface_matches::Match;
use super::surface_samples::{OrientedPoints, STAGE};
use glam::{DMat3, DVec3};
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::linear::cholesky;
use gusset_base::geom::linear::eigen::symmetric_eigen;
use gusset_base::geom::rotation::rotation_maximising_trace;
use gusset_base::job::Job;

/// Samples are compared with points within this number of spacings, ...
const MAX_COMPARED_DISTANCE: f64 = 2.0;
/// ... beside them by at most this number.
const MAX_DISTANCE_ASIDE: f64 = 0.6;
/// Samples within this number of spacings of the tangent plane are on the surface, ...
const MAX_ON_SURFACE_DISTANCE: f64 = 0.4;
/// ... if the cosine of the angle between the normals is at least this number.
const MIN_ON_SURFACE_COSINE: f64 = 0.8;
/// Addition to the diagonal of the equations, relative to its mean.
const RELATIVE_DAMPING: f64 = 1e-6;
/// Number of samples between two progress reports.
const SAMPLES_PER_REPORT: usize = 1 << 7;

/// A surface as samples and dense points.
#[derive(Clone, Copy)]
pub(super) struct SampledSurface<'a> {
    pub(super) samples: &'a OrientedPoints,
    pub(super) dense: &'a OrientedPoints,
    /// The tree over the dense points.
    pub(super) tree: &'a KdTree<'a>,
    /// The lists of features of the samples.
    pub(super) features: &'a [Vec<SurfaceFeature>],
    /// The root mean square distance of the points from their mean.
    pub(super) radius: f64,
}

/// How well a surface fits another one in a pose.
#[derive(Clone)]
pub(super) struct SurfaceFit {
    /// The number of samples that were compared.
    pub(super) compared: usize,
    /// The number of samples on the surface.
    pub(super) on_surface: usize,
    /// The mean square distance of the samples on the surface.
    pub(super) mean_squared_distance: f64,
    /// The mean of 1 minus the cosine between the normals of samples on the surface.
    pub(super) mean_normal_deviation: f64,
    /// The largest distance of samples on the surface.
    tolerance: f64,
    matrix: [MotionVector; 6],
    right_side: MotionVector,
    centre: DVec3,
}

/// The samples that are compared, and the tolerance.
#[derive(Clone, Copy)]
pub(super) struct Comparison {
    /// Scales the largest distance of samples on the surface.
    pub(super) tolerance: f64,
    /// The interval of the compared samples.
    pub(super) stride: usize,
}

impl Comparison {
    /// Compares all samples.
    pub(super) const FINAL: Comparison = Comparison { tolerance: 1.0, stride: 1 };
}

/// Compares samples of the second surface, moved by the pose, with the first surface.
pub(super) fn measure_surface_fit(
    [fixed, moved]: [&SampledSurface<'_>; 2],
    pose: &Pose,
    spacing: f64,
    Comparison { tolerance, stride }: Comparison,
    job: &Job<'_>,
) -> Result<SurfaceFit> {
    let reach = (MAX_COMPARED_DISTANCE * spacing).powi(2);
    let centre = pose.transform_point(DVec3::ZERO);
    let mut fit = SurfaceFit {
        compared: 0,
        on_surface: 0,
        mean_squared_distance: 0.0,
        mean_normal_deviation: 0.0,
        tolerance: tolerance * MAX_ON_SURFACE_DISTANCE * spacing,
        matrix: [[0.0; 6]; 6],
        right_side: [0.0; 6],
        centre,
    };
    let count = moved.samples.points.len();
    for (round, i) in (0..count).step_by(stride).enumerate() {
        job.step_every(SAMPLES_PER_REPORT, round, count.div_ceil(stride), STAGE)?;
        let point = pose.transform_point(moved.samples.points[i]);
        let normal = pose.rotate_direction(moved.samples.normals[i]);
        let faces_same_side = |k: u32| fixed.dense.normals[k as usize].dot(normal) > 0.0;
        let Some((_, k)) = fixed.tree.nearest(point, reach, faces_same_side) else { continue };
        let (other, n) = (fixed.dense.points[k as usize], fixed.dense.normals[k as usize]);
        let apart = point - other;
        let along = (normal + n).normalize_or(n);
        let distance = apart.dot(along);
        if (apart - distance * along).length() > MAX_DISTANCE_ASIDE * spacing {
            continue;
        }
        fit.compared += 1;
        let cosine = normal.dot(n);
        if distance.abs() > fit.tolerance || cosine < MIN_ON_SURFACE_COSINE {
            continue;
        }
        fit.on_surface += 1;
        fit.mean_squared_distance += distance * distance;
        fit.mean_normal_deviation += 1.0 - cosine;
        let turn = (point - centre).cross(along) / moved.radius;
        let row = [turn.x, turn.y, turn.z, along.x, along.y, along.z];
        for a in 0..6 {
            (0..6).for_each(|b| fit.matrix[a][b] += row[a] * row[b]);
            fit.right_side[a] -= row[a] * distance;
        }
    }
    let count = fit.on_surface.max(1) as f64;
    fit.mean_squared_distance /= count;
    fit.mean_normal_deviation /= count;
    Ok(fit)
}

impl SurfaceFit {
    /// Returns the number of samples on the surface, weighted by their distances, less those that
    /// contradict the pose. If a pose is wrong, the distances are distributed evenly, and the
    /// weights are 0 on average.
    pub(super) fn score(&self) -> f64 {
        let off = (self.compared - self.on_surface) as f64;
        (self.on_surface as f64 * self.sharpness() - off).max(0.0)
    }

    /// Returns how sharply the distances concentrate at 0: 1 if all are 0, and 0 if they are
    /// distributed evenly.
    pub(super) fn sharpness(&self) -> f64 {
        1.0 - 3.0 * self.mean_squared_distance / (self.tolerance * self.tolerance)
    }

    /// Returns the pose followed by the motion that minimises the squared distances of the samples
    /// on the surface.
    pub(super) fn improve_pose(&self, pose: &Pose, radius: f64) -> Option<Pose> {
        let mean = (0..6).map(|a| self.matrix[a][a]).sum::<f64>() / 6.0;
        if mean <= 0.0 {
            return None;
        }
        let mut lower = self.matrix;
        (0..6).for_each(|a| lower[a][a] += RELATIVE_DAMPING * mean);
        let mut right = self.right_side.map(|x| DVec3::new(x, 0.0, 0.0));
        cholesky::solve(&mut lower, &mut right);
        let [a, b, c, x, y, z] = right.map(|x| x.x);
        let (turn, shift) = (DVec3::new(a, b, c) / radius, DVec3::new(x, y, z));
        let is_finite = turn.is_finite() && shift.is_finite();
        is_finite.then(|| pose.followed_by(&Pose::rotation_about(self.centre, turn, shift)).with_orthonormal_axes())
    }

    /// Returns the least eigenvalue of the mean of the equations, and the part that noise of the
    /// normals explains; see [`hold_stiffness`](super::hold_stiffness).
    pub(super) fn hold_stiffness(&self) -> [f64; 2] {
        let count = self.on_surface.max(1) as f64;
        let (values, _) = symmetric_eigen(self.matrix.map(|row| row.map(|x| x / count)));
        [values.into_iter().fold(f64::INFINITY, f64::min).max(0.0), self.mean_normal_deviation / 4.0]
    }
}

/// Returns the motion that minimises the squared distances of matched samples and of their normals,
/// which count as points at `normal_length`. Takes the first piece as fixed.
pub(super) fn fit_matches(samples: [&OrientedPoints; 2], matches: &[Match], normal_length: f64) -> Pose {
    let [fixed, moved] = samples;
    let count = matches.len().max(1) as f64;
    let mean = |k: usize| matches.iter().map(|pair| samples[k].points[pair[k] as usize]).sum::<DVec3>() / count;
    let (target, source) = (mean(0), mean(1));
    let mut covariance = DMat3::ZERO;
    for &[i, k] in matches {
        let (p, q) = (moved.points[k as usize] - source, fixed.points[i as usize] - target);
        let (m, n) = (moved.normals[k as usize] * normal_length, fixed.normals[i as usize] * normal_length);
        covariance += DMat3::from_cols(p.x * q + m.x * n, p.y * q + m.y * n, p.z * q + m.z * n);
    }
    let rotation = DMat3::from_quat(rotation_maximising_trace(covariance));
    Pose { rotation, translation: target - rotation * source }.with_orthonormal_axes()
}
