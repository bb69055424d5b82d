//! Creases ironed out: where a fine surface folds over itself, its vertices move to the means of
//! their neighbours, until no side bends by more than is asked.

use super::patch_mesh::PatchMesh;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;
use glam::DVec3;

/// Rounds over all triangles.
const MAX_ROUNDS: usize = 40;
/// How far a vertex moves towards the mean of its neighbours.
const STEP: f64 = 0.5;

impl PatchMesh {
    /// Moves the vertices from `rim` on of triangles whose normal has a cosine with that of a
    /// neighbour below `least`, until none have or the rounds are used up.
    ///
    /// O(triangles) a round.
    pub(crate) fn iron(&mut self, rim: usize, least: f64, job: &Job<'_>) -> Result<()> {
        let sides = || self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let ends = sides().flat_map(|(u, v)| [(u as usize, v), (v as usize, u)]);
        let neighbours = Buckets::new(self.points.len(), 0u32, ends)?;
        for round in 0..MAX_ROUNDS {
            job.step(round as f64 / MAX_ROUNDS as f64, "refining")?;
            let normals = alloc::collect((0..self.triangles.len()).map(|t| {
                let [a, b, c] = self.corners(t);
                (b - a).cross(c - a).normalize_or_zero()
            }))?;
            let bends =
                |t: usize| (0..3).filter_map(|k| self.beyond(t, k)).any(|(s, _)| normals[t].dot(normals[s]) < least);
            let mut moves = alloc::filled(false, self.points.len())?;
            for (t, triangle) in self.triangles.iter().enumerate() {
                if bends(t) {
                    triangle.iter().for_each(|&v| moves[v as usize] = true);
                }
            }
            moves[..rim].fill(false);
            if !moves.contains(&true) {
                break;
            }
            for v in (rim..self.points.len()).filter(|&v| moves[v]) {
                let around = neighbours.get(v);
                let mean = around.iter().map(|&w| self.points[w as usize]).sum::<DVec3>() / around.len() as f64;
                self.points[v] = self.points[v].lerp(mean, STEP);
            }
        }
        Ok(())
    }
}
