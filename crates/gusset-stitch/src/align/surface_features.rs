//! Features of a surface around a sample: histograms of the angles between the sample and its
//! neighbours.
//!
//! Source: R. Rusu, N. Blodow and M. Beetz, *Fast point feature histograms (FPFH) for 3D
//! registration* (2009). A pair of points with normals has three angles, which do not depend on the
//! pose. The paper adds the histograms of the neighbours. Here each histogram has many neighbours,
//! and each angle counts in two bins, so that the histogram is smooth without that sum.

use super::surface_samples::{OrientedPoints, STAGE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;

/// Number of bins for each of the three angles.
const BINS: usize = 11;
/// The number of entries of a histogram, padded to whole vectors of processors.
pub(super) const FEATURE_LENGTH: usize = 40;
/// Smallest number of neighbours that make a feature.
const MIN_NEIGHBOURS: f64 = 12.0;
/// Number of samples between two progress reports.
const SAMPLES_PER_REPORT: usize = 1 << 6;

/// The square roots of the entries of a histogram, so that the Euclidean distance of two features
/// is the Hellinger distance of their histograms.
pub(super) type SurfaceFeature = [f32; FEATURE_LENGTH];

/// Returns for each sample the feature of the points within a radius; zeros for samples with too
/// few of them. `tree` is over the points.
pub(super) fn compute_features(
    samples: &OrientedPoints,
    around: &OrientedPoints,
    tree: &KdTree<'_>,
    radius: f64,
    job: &Job<'_>,
) -> Result<Vec<SurfaceFeature>> {
    let mut features = alloc::filled([0.0; FEATURE_LENGTH], samples.points.len())?;
    for (i, feature) in features.iter_mut().enumerate() {
        job.step_every(SAMPLES_PER_REPORT, i, samples.points.len(), STAGE)?;
        let (point, normal) = (samples.points[i], samples.normals[i]);
        let mut histogram = [0.0f64; FEATURE_LENGTH];
        let mut count = 0.0;
        tree.for_each_within(point, ScaledRadius::new(radius), &mut |_, k| {
            let (other, m) = (around.points[k as usize], around.normals[k as usize]);
            if let Some(angles) = measure_pair_angles(point, normal, other, m) {
                count += 1.0;
                for (k, angle) in angles.into_iter().enumerate() {
                    add_to_histogram(&mut histogram[k * BINS..(k + 1) * BINS], angle);
                }
            }
        });
        if count >= MIN_NEIGHBOURS {
            *feature = histogram.map(|sum| (sum / count).sqrt() as f32);
        }
    }
    Ok(features)
}

/// Returns the three angles of a pair, each scaled to the range from 0 to 1. `None` if the
/// neighbour is along the normal, or lacks a normal.
fn measure_pair_angles(p: DVec3, u: DVec3, q: DVec3, m: DVec3) -> Option<[f64; 3]> {
    let d = (q - p).try_normalize()?;
    let v = d.cross(u).try_normalize()?;
    if m == DVec3::ZERO {
        return None;
    }
    let w = u.cross(v);
    let turn = libm::atan2(w.dot(m), u.dot(m)) / std::f64::consts::PI;
    Some([v.dot(m), u.dot(d), turn].map(|x| (x + 1.0) / 2.0))
}

/// Distributes 1 over the two bins whose centres are nearest to `x`, from 0 to 1.
fn add_to_histogram(bins: &mut [f64], x: f64) {
    let place = (x * bins.len() as f64 - 0.5).clamp(0.0, (bins.len() - 1) as f64);
    let low = (place as usize).min(bins.len() - 2);
    let part = place - low as f64;
    bins[low] += 1.0 - part;
    bins[low + 1] += part;
}

/// Returns the squared distance of two features. The order of the sum is fixed.
pub(super) fn feature_distance_squared(a: &SurfaceFeature, b: &SurfaceFeature) -> f32 {
    let mut lanes = [0.0f32; 8];
    for (a, b) in a.chunks_exact(8).zip(b.chunks_exact(8)) {
        for k in 0..8 {
            let difference = a[k] - b[k];
            lanes[k] += difference * difference;
        }
    }
    lanes.into_iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A saddle z = a x^2 + b y^2 with exact normals, rotated and moved.
    fn saddle(a: f64, b: f64, rotation: glam::DMat3, shift: DVec3) -> OrientedPoints {
        let mut patch = OrientedPoints::default();
        for i in -15..=15 {
            for j in -15..=15 {
                let (x, y) = (f64::from(i) / 15.0, f64::from(j) / 15.0);
                patch.points.push(rotation * DVec3::new(x, y, a * x * x + b * y * y) + shift);
                patch.normals.push(rotation * DVec3::new(-2.0 * a * x, -2.0 * b * y, 1.0).normalize());
            }
        }
        patch
    }

    fn middle_feature(patch: &OrientedPoints) -> SurfaceFeature {
        let job = Job::default();
        let tree = KdTree::new(&patch.points, &job, STAGE).unwrap();
        compute_features(patch, patch, &tree, 0.8, &job).unwrap()[patch.points.len() / 2]
    }

    /// Motions keep a feature; another curvature changes it.
    #[test]
    fn features_depend_on_the_shape_and_not_on_the_pose() {
        let away = glam::DMat3::from_quat(glam::DQuat::from_xyzw(0.1, -0.7, 0.4, 0.3).normalize());
        let own = middle_feature(&saddle(0.4, -0.2, glam::DMat3::IDENTITY, DVec3::ZERO));
        let moved = middle_feature(&saddle(0.4, -0.2, away, DVec3::new(3.0, -2.0, 5.0)));
        let other = middle_feature(&saddle(0.4, 0.2, away, DVec3::ZERO));
        assert!(feature_distance_squared(&own, &moved) < 1e-6);
        assert!(feature_distance_squared(&own, &other) > 0.05);
        // Each of the three histograms has the sum 1.
        assert!((own.iter().map(|x| x * x).sum::<f32>() - 3.0).abs() < 1e-4);
    }
}
