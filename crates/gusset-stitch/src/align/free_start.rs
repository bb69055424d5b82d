//! An initial alignment by features of surfaces: overlapping pieces are found in any positions.
//!
//! Every two pieces are compared. The pieces are placed from the first piece on, the best certain
//! pose first. A pose that contradicts a placed piece is skipped.

use super::alignment_scene::AlignmentScene;
use super::pose::Pose;
use super::surface_features::compute_features;
use super::surface_pair::{SurfacePose, are_in_conflict, find_self_score, find_surface_pose};
use super::surface_pose::SampledSurface;
use super::surface_samples::{STAGE, choose_common_spacing, choose_sparse_points, place_dense_points};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_mesh::MeshView;

/// Radius of the features among dense points, in spacings, ...
const FINE_FEATURE_RADIUS: f64 = 4.0;
/// ... and of the features among samples.
const COARSE_FEATURE_RADIUS: f64 = 8.0;

/// The poses that a search found.
pub(super) struct FoundPoses {
    /// For each piece its pose relative to the first piece; `None` without a certain pose.
    pub(super) poses: Vec<Option<Pose>>,
    /// The spacing of the samples, which bounds the errors of the poses.
    pub(super) spacing: f64,
}

/// A certain pose of the second piece on the first.
type CertainPose = ([usize; 2], SurfacePose);

/// Finds the poses of the pieces by the features of their surfaces. O(pieces^2), each at most as
/// long as 1,600^2 features of a fixed length.
pub(super) fn find_poses_by_surface_features(
    pieces: &[MeshView<'_>],
    scene: &AlignmentScene<'_>,
    job: &Job<'_>,
) -> Result<FoundPoses> {
    let scans = alloc::collect(scene.sampled_pieces.iter().map(|piece| piece.scan))?;
    let spacing = choose_common_spacing(pieces.iter().zip(scans.iter().copied()), &job.sub_job(0.0, 0.0))?;
    let mut poses = alloc::filled(None, pieces.len())?;
    poses[0] = Some(Pose::IDENTITY);
    if spacing <= 0.0 {
        return Ok(FoundPoses { poses, spacing });
    }
    let dense = par::map_jobs(&job.sub_job(0.0, 0.1), STAGE, pieces.iter().zip(&scans), |(mesh, scan), job| {
        place_dense_points(mesh, scan, spacing, job)
    })?;
    let trees =
        alloc::try_collect(dense.iter().map(|dense| KdTree::new(&dense.points, &job.sub_job(0.1, 0.1), STAGE)))?;
    let described = par::map_jobs(&job.sub_job(0.1, 0.3), STAGE, dense.iter().zip(&trees), |(dense, tree), job| {
        let samples = choose_sparse_points(dense, tree, spacing, &job.sub_job(0.0, 0.2))?;
        let sparse_tree = KdTree::new(&samples.points, &job.sub_job(0.2, 0.2), STAGE)?;
        let [fine, coarse] = [FINE_FEATURE_RADIUS, COARSE_FEATURE_RADIUS].map(|radius| radius * spacing);
        let mut features = alloc::with_capacity(2)?;
        features.push(compute_features(&samples, dense, tree, fine, &job.sub_job(0.2, 0.6))?);
        features.push(compute_features(&samples, &samples, &sparse_tree, coarse, &job.sub_job(0.6, 1.0))?);
        Ok((samples, features))
    })?;
    let surfaces = alloc::collect((0..pieces.len()).map(|k| SampledSurface {
        samples: &described[k].0,
        dense: &dense[k],
        tree: &trees[k],
        features: &described[k].1,
        radius: scans[k].radius,
    }))?;
    let certain = find_certain_poses(&surfaces, spacing, &job.sub_job(0.3, 0.9))?;
    place_pieces(&surfaces, certain, &mut poses, spacing, &job.sub_job(0.9, 1.0))?;
    Ok(FoundPoses { poses, spacing })
}

/// Returns the certain poses between two pieces, the best first.
fn find_certain_poses(surfaces: &[SampledSurface<'_>], spacing: f64, job: &Job<'_>) -> Result<Vec<CertainPose>> {
    let self_scores = par::map_jobs(&job.sub_job(0.0, 0.2), STAGE, surfaces.iter(), |surface, job| {
        find_self_score(surface, spacing, job)
    })?;
    let count = surfaces.len();
    let pairs = alloc::gather((0..count).flat_map(|i| (i + 1..count).map(move |k| [i, k])))?;
    let found = par::map_jobs(&job.sub_job(0.2, 1.0), STAGE, pairs.iter(), |pair, job| {
        find_surface_pose(pair.map(|k| &surfaces[k]), spacing, |_| true, job)
    })?;
    let mut certain = Vec::new();
    for (pair, found) in pairs.into_iter().zip(found) {
        let counts = pair.map(|k| surfaces[k].samples.points.len());
        let self_score = self_scores[pair[0]].max(self_scores[pair[1]]);
        alloc::extend(
            &mut certain,
            found.filter(|found| found.is_certain(counts, self_score)).map(|found| (pair, found)),
        )?;
    }
    certain.sort_unstable_by(|x, y| y.1.score().total_cmp(&x.1.score()).then(x.0.cmp(&y.0)));
    Ok(certain)
}

/// Places the pieces, from those that have a pose on.
fn place_pieces(
    surfaces: &[SampledSurface<'_>],
    mut certain: Vec<CertainPose>,
    poses: &mut [Option<Pose>],
    spacing: f64,
    job: &Job<'_>,
) -> Result<()> {
    let is_open = |poses: &[Option<Pose>], [i, k]: [usize; 2]| poses[i].is_some() != poses[k].is_some();
    while let Some(at) = certain.iter().position(|(pair, _)| is_open(poses, *pair)) {
        let ([i, k], found) = certain.remove(at);
        let (new, pose) = match (poses[i], poses[k]) {
            (Some(placed), _) => (k, found.pose.followed_by(&placed)),
            (_, Some(placed)) => (i, found.pose.inverse().followed_by(&placed)),
            (None, None) => continue,
        };
        let mut is_contradicted = false;
        for (other, placed) in poses.iter().enumerate().filter_map(|(other, pose)| pose.map(|pose| (other, pose))) {
            let onto = pose.followed_by(&placed.inverse());
            is_contradicted |= are_in_conflict([&surfaces[other], &surfaces[new]], &onto, spacing, job)?;
        }
        if !is_contradicted {
            poses[new] = Some(pose);
        }
    }
    Ok(())
}
