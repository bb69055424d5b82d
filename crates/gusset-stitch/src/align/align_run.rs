//! The steps of an alignment, from the meshes to the report.

use super::align_request::{Aligned, Alignment, Options, Reason, Start};
use super::alignment_scene::AlignmentScene;
use super::assess::{MAX_NEAR_SPACINGS, MAX_ON_SURFACE_SPACINGS, assess_alignment};
use super::centred_piece::CentredPiece;
use super::free_start::find_poses_by_surface_features;
use super::pose::Pose;
use super::principal_axes::align_each_piece_by_principal_axes;
use super::rim_features::align_matching_rims;
use super::sampled_piece::SampledPiece;
use super::sampled_rims::{SampledRims, common_sampling_step};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Default number of samples of a piece.
const DEFAULT_SAMPLES_PER_PIECE: u32 = 2000;
/// Default limit on the rounds.
const DEFAULT_MAX_ROUNDS: u32 = 100;
/// Default limit on the distance of pairs, relative to the diagonal of the largest piece's box.
const DEFAULT_RELATIVE_REACH: f64 = 0.1;
/// Smallest default limit on the distance of pairs after a search, in the spacing of the coarsest piece.
const MIN_REACH_SPACINGS: f64 = 2.0;
/// Largest deviation of a pose from a rotation.
const MAX_POSE_SKEW: f64 = 1e-6;

/// Moves overlapping pieces rigidly to where they fit. The first piece is fixed.
///
/// Overlaps are found from the initial positions, which must be within `max_distance` of the right
/// ones; see [`Start`]. Pieces without overlaps do not move. [`Reason`] tells which pieces are
/// trusted.
///
/// O(V log V) for the pieces' vertices, and O(samples log V) for each piece and each of its
/// neighbours in each round, on the job's threads. Memory: linear in the vertices and faces.
///
/// # Errors
/// * [`Error::EmptyMesh`] without pieces.
/// * [`Error::OptionOutOfRange`] for a distance that is not positive and finite.
/// * [`Error::InputsDiffer`] for fewer poses than pieces.
/// * [`Error::NotRigid`] for a pose that is not a rotation and translation.
/// * [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn align(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Alignment> {
    if pieces.is_empty() {
        return Err(Error::EmptyMesh { what: "pieces" });
    }
    if let Some(distance) = options.max_distance {
        Error::require(distance > 0.0 && distance < f64::INFINITY, "max_distance", distance, "finite and above 0")?;
    }
    if let Start::Poses(poses) = options.start {
        check_poses(poses, pieces.len())?;
    }
    let unit = common_length_unit(pieces, job)?;
    let prepare = job.sub_job(0.0, 0.2);
    let mut scans = alloc::with_capacity(pieces.len())?;
    for (k, piece) in pieces.iter().enumerate() {
        scans.push(CentredPiece::new(piece, unit, None, &prepare.sub_job_of_item(k, pieces.len()))?);
    }
    let trees = alloc::try_collect(scans.iter().map(|scan| scan.build_point_tree(&prepare.sub_job(1.0, 1.0))))?;
    let count = if options.samples == 0 { DEFAULT_SAMPLES_PER_PIECE } else { options.samples } as usize;
    let samples =
        alloc::try_collect(scans.iter().zip(&trees).map(|(scan, tree)| scan.choose_samples(tree.tree_order(), count)))?;
    let mut rims = Vec::new();
    if options.start == Start::Rims {
        let step = common_sampling_step(pieces, unit, &prepare.sub_job(1.0, 1.0))?;
        for (piece, scan) in pieces.iter().zip(&scans) {
            alloc::push(&mut rims, SampledRims::new(piece, scan, step, &prepare.sub_job(1.0, 1.0))?)?;
        }
    }
    let rim_trees = alloc::try_collect(
        rims.iter().map(|rim| KdTree::new(&rim.points, &prepare.sub_job(1.0, 1.0), "comparing rims")),
    )?;
    let largest =
        scans.iter().map(|scan| if scan.vertices_with_normal.is_empty() { 0.0 } else { scan.bounds.diagonal() });
    let reach =
        options.max_distance.map_or(DEFAULT_RELATIVE_REACH * largest.fold(0.0, f64::max), |distance| distance / unit);
    let members = alloc::collect((0..pieces.len()).map(|k| SampledPiece {
        scan: &scans[k],
        tree: &trees[k],
        samples: &samples[k],
        rim: rims.get(k).zip(rim_trees.get(k)),
    }))?;
    let is_left_out = alloc::filled(false, pieces.len())?;
    let mut scene = AlignmentScene { sampled_pieces: members, max_pair_distance: reach, is_left_out };

    // Positions are relative to the centre of their own piece, and poses to the centre of the first
    // piece, to keep precision far from the origin.
    let origin = scans[0].centre;
    let started = job.sub_job(0.2, 0.4);
    let mut poses = match options.start {
        Start::AsGiven => alloc::collect(scans.iter().map(|scan| translation_pose(scan.centre - origin)))?,
        Start::Poses(given) => alloc::collect(scans.iter().zip(given).map(|(scan, pose)| {
            Pose { rotation: pose.rotation, translation: pose.transform_point(scan.centre * unit) / unit - origin }
                .with_orthonormal_axes()
        }))?,
        Start::PrincipalAxes => align_each_piece_by_principal_axes(&scene, &started)?,
        Start::Rims => align_matching_rims(&scene, &started)?,
        Start::Features => {
            let found = find_poses_by_surface_features(pieces, &scene, &started)?;
            let coarsest = scans.iter().map(|scan| scan.spacing).fold(0.0, f64::max);
            scene.max_pair_distance = reach.min(found.spacing.max(MIN_REACH_SPACINGS * coarsest));
            scene.is_left_out = alloc::collect(found.poses.iter().map(Option::is_none))?;
            let given = scans.iter().map(|scan| translation_pose(scan.centre - origin));
            alloc::collect(found.poses.iter().zip(given).map(|(pose, given)| pose.unwrap_or(given)))?
        }
    };
    let rounds = if options.max_rounds == 0 { DEFAULT_MAX_ROUNDS } else { options.max_rounds };
    let (rounds, converged) = scene.relax_poses(&mut poses, rounds, &job.sub_job(0.4, 0.9))?;
    let reports =
        scene.search_near_pieces_within(&poses, MAX_NEAR_SPACINGS, MAX_ON_SURFACE_SPACINGS, &job.sub_job(0.9, 1.0))?;
    let (overlaps, mut known) = assess_alignment(&scene.sampled_pieces, &reports, unit)?;
    for (k, (reason, _)) in known.iter_mut().enumerate() {
        // A piece without faces cannot overlap.
        if scene.is_left_out[k] && !scans[k].vertices_with_normal.is_empty() {
            *reason = Reason::Undetermined;
        }
    }
    let pieces = poses.iter().zip(&scans).zip(known).map(|((pose, scan), (reason, hold))| {
        // Rounding must not move a piece that stays.
        if *pose == translation_pose(scan.centre - origin) {
            return Aligned { pose: Pose::IDENTITY, reason, hold };
        }
        let back = pose.rotation * scan.centre;
        Aligned { pose: Pose { translation: unit * (pose.translation + origin - back), ..*pose }, reason, hold }
    });
    let pieces: Vec<Aligned> = alloc::collect(pieces)?;
    let untrusted = pieces.iter().filter(|piece| piece.reason != Reason::Trusted).count();
    if untrusted > 0 {
        let count = pieces.len();
        job.note(&format!("untrusted poses: {untrusted} of {count}; the report of the alignment gives the reasons"));
    }
    Ok(Alignment { pieces, overlaps, rounds, converged })
}

fn translation_pose(by: glam::DVec3) -> Pose {
    Pose { translation: by, ..Pose::IDENTITY }
}

fn check_poses(poses: &[Pose], count: usize) -> Result<()> {
    if poses.len() < count {
        return Err(Error::InputsDiffer { given: poses.len() as u64, needed: count as u64 });
    }
    for (k, pose) in poses.iter().enumerate() {
        // Test finiteness separately, because the maximum ignores NaN.
        let is_finite = pose.rotation.is_finite() && pose.translation.is_finite();
        if !is_finite || pose.deviation_from_rotation() > MAX_POSE_SKEW {
            return Err(Error::NotRigid { pose: k as u32 });
        }
    }
    Ok(())
}

/// Returns a power of two near the size of all coordinates that faces use.
pub(crate) fn common_length_unit(pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<f64> {
    let mut largest = glam::DVec3::ZERO;
    for piece in pieces {
        for f in 0..piece.faces().len() {
            job.step_within_list(f, "looking at the pieces")?;
            piece.face(f).for_each(|v| largest = largest.max(piece.positions().get(v).abs()));
        }
    }
    Ok(common_unit(&[largest]))
}
