//! The pieces that are aligned with each other, and the pairs that are near.

use super::pose::Pose;
use super::rim_sample_pairs::find_rim_sample_pairs;
use super::sample_pairs::{PosedPiece, STAGE, SamplePairReport, find_sample_pairs};
use super::sampled_piece::SampledPiece;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;

/// Smallest number of pairs that couples two pieces.
pub(super) const MIN_COUPLING_PAIRS: usize = 10;

/// The pieces that are aligned with each other.
pub(super) struct AlignmentScene<'a> {
    pub(super) sampled_pieces: Vec<SampledPiece<'a>>,
    /// The largest distance of a pair of points.
    pub(super) max_pair_distance: f64,
    /// The pieces whose poses are unknown, which do not take part.
    pub(super) is_left_out: Vec<bool>,
}

/// A search for the samples of one piece on another, up to a distance.
#[derive(Clone, Copy)]
pub(super) struct PieceSearch {
    pub(super) pieces: [usize; 2],
    pub(super) max_distance: f64,
}

impl<'a> AlignmentScene<'a> {
    /// Returns a scene of two of the pieces.
    pub(super) fn sub_scene_of_two_pieces(&self, i: usize, k: usize) -> Result<AlignmentScene<'a>> {
        Ok(AlignmentScene {
            sampled_pieces: alloc::collect([i, k].map(|k| self.sampled_pieces[k]).into_iter())?,
            max_pair_distance: self.max_pair_distance,
            is_left_out: alloc::filled(false, 2)?,
        })
    }

    /// Returns the spacing of the coarser of two pieces.
    pub(super) fn coarser_spacing(&self, pieces: [usize; 2]) -> f64 {
        let [a, b] = pieces.map(|k| {
            let member = &self.sampled_pieces[k];
            member.rim.map_or(member.scan.spacing, |(rim, _)| rim.step)
        });
        a.max(b)
    }

    /// Returns the searches between pieces that are near enough, in both directions.
    pub(super) fn list_searches_of_near_pieces(&self, poses: &[Pose]) -> Result<Vec<PieceSearch>> {
        let bounds = |k: usize| &self.sampled_pieces[k].scan.bounds;
        let has_faces = |k: usize| !self.sampled_pieces[k].scan.vertices_with_normal.is_empty();
        let is_there = |k: usize| has_faces(k) && !self.is_left_out[k];
        let is_near = |[i, k]: [usize; 2]| {
            let [p, q] = [i, k].map(|k| poses[k].transform_point(bounds(k).centre()));
            p.distance(q) <= (bounds(i).diagonal() + bounds(k).diagonal()) / 2.0 + self.max_pair_distance
        };
        let count = self.sampled_pieces.len();
        let all = (0..count).flat_map(|i| (0..count).map(move |k| [i, k]));
        let near = all.filter(|&[i, k]| i != k && is_there(i) && is_there(k) && is_near([i, k]));
        alloc::gather(near.map(|pieces| PieceSearch { pieces, max_distance: self.max_pair_distance }))
    }

    /// Runs the searches, each with every `sample_stride`-th sample. Points within
    /// `max_on_surface_spacings` spacings are on a surface.
    pub(super) fn run_searches(
        &self,
        poses: &[Pose],
        looks: &[PieceSearch],
        sample_stride: usize,
        max_on_surface_spacings: f64,
        job: &Job<'_>,
    ) -> Result<Vec<([usize; 2], SamplePairReport)>> {
        let reports = par::map_jobs(job, STAGE, looks.iter(), |look_at, job| {
            let [a, b] = look_at.pieces.map(|k| PosedPiece { sampled_piece: &self.sampled_pieces[k], pose: poses[k] });
            let max_on_surface_distance = max_on_surface_spacings * self.coarser_spacing(look_at.pieces);
            let samples = a.sampled_piece.samples;
            match (a.sampled_piece.rim, b.sampled_piece.rim) {
                (Some((rim, _)), Some(other)) => {
                    find_rim_sample_pairs(&a, rim, &b, other, look_at.max_distance, max_on_surface_distance, job)
                }
                _ => find_sample_pairs(
                    &a,
                    samples.iter().step_by(sample_stride),
                    &b,
                    look_at.max_distance,
                    max_on_surface_distance,
                    job,
                ),
            }
        })?;
        alloc::collect(looks.iter().zip(reports).map(|(look, report)| (look.pieces, report)))
    }

    /// Searches between all near pieces, within this number of spacings.
    pub(super) fn search_near_pieces_within(
        &self,
        poses: &[Pose],
        max_spacings: f64,
        max_on_surface_spacings: f64,
        job: &Job<'_>,
    ) -> Result<Vec<([usize; 2], SamplePairReport)>> {
        let mut looks = self.list_searches_of_near_pieces(poses)?;
        // No pair is farther apart than the reach.
        looks.iter_mut().for_each(|look| {
            look.max_distance = (max_spacings * self.coarser_spacing(look.pieces)).min(self.max_pair_distance);
        });
        self.run_searches(poses, &looks, 1, max_on_surface_spacings, job)
    }
}
