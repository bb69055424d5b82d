//! The rims of a piece at equal steps.
//!
//! Each sample has a frame of the rim's direction, the surface's normal and the conormal. Its
//! signature lists the positions of the rim some steps before and after it, in that frame.

use super::centred_piece::CentredPiece;
use crate::boundary::{self, LoopFlags, boundary_loops};
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

pub(super) const STAGE: &str = "comparing rims";
/// Largest number of samples of all rims of a piece.
const MAX_RIM_SAMPLES_PER_PIECE: f64 = 512.0;
/// The offsets of a signature, in steps before and after.
const SIGNATURE_OFFSET_STEPS: [usize; 4] = [3, 6, 12, 24];
/// Smallest cosine between the normals of matching rims, and between one direction and the opposite
/// of the other.
pub(super) const MIN_RIM_NORMAL_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The positions of the rim some steps before and after a sample.
pub(super) type RimSignature = [DVec3; 2 * SIGNATURE_OFFSET_STEPS.len()];

/// The rims of a piece at equal steps.
pub(super) struct SampledRims {
    pub(crate) points: Vec<DVec3>,
    pub(super) directions: Vec<DVec3>,
    pub(crate) normals: Vec<DVec3>,
    /// The start of each loop, and the number of samples.
    loop_starts: Vec<usize>,
    pub(super) step: f64,
}

/// Returns the step for the rims of all pieces: their longest mean edge, or the step that limits
/// the number of samples.
pub(super) fn common_sampling_step(meshes: &[MeshView<'_>], unit: f64, job: &Job<'_>) -> Result<f64> {
    let mut step = 0.0f64;
    for (k, mesh) in meshes.iter().enumerate() {
        let found = boundary_loops(mesh, &boundary::Options::default(), &job.sub_job_of_item(k, meshes.len()))?;
        let length = found.iter().map(|rim| rim.length / unit).sum::<f64>();
        step = step.max(length / MAX_RIM_SAMPLES_PER_PIECE).max(length / found.edge_count().max(1) as f64);
    }
    Ok(step)
}

impl SampledRims {
    /// Samples the rims of a piece. O(F), plus the samples.
    pub(super) fn new(mesh: &MeshView<'_>, scan: &CentredPiece, step: f64, job: &Job<'_>) -> Result<SampledRims> {
        let found = boundary_loops(mesh, &boundary::Options::default(), job)?;
        let mut rim =
            SampledRims { points: Vec::new(), directions: Vec::new(), normals: Vec::new(), loop_starts: vec![0], step };
        for walk in found.iter().filter(|walk| !walk.flags.any(LoopFlags::OPEN)) {
            rim.add_loop_samples(walk.vertices, scan)?;
        }
        Ok(rim)
    }

    /// Adds the samples of one loop.
    fn add_loop_samples(&mut self, vertices: &[u32], scan: &CentredPiece) -> Result<()> {
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
        alloc::extend(&mut self.directions, directions.map(DVec3::normalize_or_zero))?;
        alloc::push(&mut self.loop_starts, self.points.len())
    }

    /// Returns the frame of a sample; if `turned`, for the opposite direction of the rim.
    pub(super) fn sample_frame(&self, k: usize, turned: bool) -> DMat3 {
        let along = if turned { -self.directions[k] } else { self.directions[k] };
        let normal = (self.normals[k] - along * along.dot(self.normals[k])).normalize_or_zero();
        DMat3::from_cols(along, normal, along.cross(normal))
    }

    /// Returns the signatures of all samples; if `turned`, for the opposite direction of the rims.
    pub(super) fn sample_signatures(&self, turned: bool) -> Result<Vec<RimSignature>> {
        let mut all = alloc::with_capacity(self.points.len())?;
        for range in self.loop_starts.windows(2) {
            let n = range[1] - range[0];
            for k in range[0]..range[1] {
                let back = self.sample_frame(k, turned).transpose();
                all.push(std::array::from_fn(|i| {
                    let offset = SIGNATURE_OFFSET_STEPS[i / 2] % n;
                    let by = if (i % 2 == 0) == turned { n - offset } else { offset };
                    let other = self.points[range[0] + (k - range[0] + by) % n];
                    back * (other - self.points[k]) / (SIGNATURE_OFFSET_STEPS[i / 2] as f64 * self.step)
                }));
            }
        }
        Ok(all)
    }
}
