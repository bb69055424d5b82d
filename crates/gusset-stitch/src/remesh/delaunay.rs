//! Edge flips to Delaunay's rule: the angles opposite to an edge are at most half a turn together.

use super::REPORT_INTERVAL;
use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Passes over all edges in which flips may follow from flips.
const MAX_PASSES: usize = 30;
/// Flips that may follow from one new vertex.
const MAX_LOCAL_FLIPS: usize = 200;
/// An edge is not flipped where the new one would bend by more than the old one did and more than
/// this: 1 - cosine of 60 degrees.
const MAX_BEND: f64 = 0.5;
/// Angles whose sum exceeds half a turn by less than this are left alone: the sine.
const COCIRCULAR: f64 = 1e-9;
/// No flip makes a triangle whose doubled area is less than this part of its sides' squares.
const FLAT: f64 = 1e-6;

impl PatchMesh {
    /// Flips edges until all keep Delaunay's rule, or the passes are used up. `taken`: true of two
    /// rim vertices, those below `rim`, that must not get an edge.
    ///
    /// O(triangles) a pass.
    pub(crate) fn relax(&mut self, rim: usize, taken: &dyn Fn(u32, u32) -> bool, job: &Job<'_>) -> Result<()> {
        for pass in 0..MAX_PASSES {
            let pass = job.share(pass, MAX_PASSES);
            let mut flipped = false;
            for t in 0..self.triangles.len() {
                pass.step_every(REPORT_INTERVAL, t, self.triangles.len(), "refining")?;
                for k in 0..3 {
                    flipped |= self.relax_side(rim, taken, t, k).is_some();
                }
            }
            if !flipped {
                break;
            }
        }
        Ok(())
    }

    /// Flips the sides of `triangles`, and what follows from it: Lawson's algorithm.
    pub(crate) fn relax_round(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        triangles: &[usize],
    ) -> Result<()> {
        let mut waiting = alloc::copied(triangles)?;
        let mut flips = 0;
        while let Some(t) = waiting.pop() {
            if let Some(s) = (0..3).find_map(|k| self.relax_side(rim, taken, t, k)) {
                flips += 1;
                if flips == MAX_LOCAL_FLIPS {
                    break;
                }
                alloc::extend(&mut waiting, [t, s])?;
            }
        }
        Ok(())
    }

    /// Flips side `k` of triangle `t` if the angles opposite to it are more than half a turn
    /// together; if it did, the triangle beyond.
    pub(crate) fn relax_side(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        t: usize,
        k: usize,
    ) -> Option<usize> {
        let (s, j) = self.beyond(t, k)?;
        let [u, v] = [self.triangles[t][(k + 2) % 3], self.triangles[s][(j + 2) % 3]];
        let [p, q] = [self.triangles[t][k], self.triangles[t][(k + 1) % 3]].map(|v| self.points[v as usize]);
        let [c, d] = [u, v].map(|v| self.points[v as usize]);
        // sin(alpha + beta), up to a positive factor, negative beyond half a turn.
        let legs = [p - c, q - c, p - d, q - d];
        let (sine, other_sine) = (legs[0].cross(legs[1]).length(), legs[2].cross(legs[3]).length());
        let sum = sine * legs[2].dot(legs[3]) + other_sine * legs[0].dot(legs[1]);
        let size = legs.iter().map(|leg| leg.length()).product::<f64>();
        if sum >= -COCIRCULAR * size {
            return None;
        }
        let rims = (u as usize) < rim && (v as usize) < rim;
        if rims && taken(u, v) || self.has_edge(t, (k + 2) % 3, v) {
            return None;
        }
        let new_normals = [(d - p).cross(c - p), (q - d).cross(c - d)];
        if new_normals.iter().any(|normal| normal.length() <= FLAT * size.sqrt()) {
            return None;
        }
        let bend = |a: DVec3, b: DVec3| 1.0 - a.normalize_or_zero().dot(b.normalize_or_zero());
        let old = bend((q - p).cross(c - p), (d - p).cross(q - p));
        let new = bend(new_normals[0], new_normals[1]);
        if new > old && new > MAX_BEND {
            return None;
        }
        self.flip((t, k), (s, j));
        Some(s)
    }
}
