//! Edge flips to the Delaunay criterion: the two angles opposite to an edge sum to at most 180
//! degrees.

use super::ELEMENTS_PER_REPORT;
use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// Largest number of passes over all edges, because flips enable further flips.
const MAX_FLIP_PASSES: usize = 30;
/// Largest number of flips after one new vertex.
const MAX_LOCAL_FLIPS: usize = 200;
/// A flip is rejected if the new edge bends by more than the old one and by more than this: 1 -
/// cosine of 60 degrees.
const MIN_FLIP_BEND: f64 = 0.5;
/// Angles whose sum exceeds 180 degrees by less than this are not flipped; given as a sine.
const MAX_COCIRCULAR_SINE: f64 = 1e-9;
/// A flip is rejected if it creates a triangle whose doubled area is below this fraction of its
/// sides' squares.
const MIN_TRIANGLE_AREA_RATIO: f64 = 1e-6;

impl PatchMesh {
    /// Flips edges until all satisfy the Delaunay criterion, or the passes are used up. `taken`
    /// returns true if two rim vertices, with numbers below `rim`, must not get an edge.
    ///
    /// O(triangles) per pass.
    pub(crate) fn flip_edges_to_delaunay(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        job: &Job<'_>,
    ) -> Result<()> {
        // The last pass that changed each triangle, from 1 on. A side needs no test if neither of its triangles
        // changed in the last pass, or in this one.
        let mut last_change = alloc::filled(0, self.triangles.len())?;
        for pass in 1..=MAX_FLIP_PASSES {
            let part = job.sub_job_of_item(pass - 1, MAX_FLIP_PASSES);
            let mut flipped = false;
            for t in 0..self.triangles.len() {
                part.step_every(ELEMENTS_PER_REPORT, t, self.triangles.len(), "refining")?;
                for k in 0..3 {
                    let across = self.triangles_across_sides[t][k];
                    let is_old = |t: usize| last_change[t] + 1 < pass;
                    if across == NONE || is_old(t) && is_old(across as usize) {
                        continue;
                    }
                    if let Some(s) = self.flip_side_if_not_delaunay(rim, taken, t, k) {
                        (last_change[t], last_change[s]) = (pass, pass);
                        flipped = true;
                    }
                }
            }
            if !flipped {
                break;
            }
        }
        Ok(())
    }

    /// Flips the sides of `triangles`, and the sides that become illegal in turn: Lawson's
    /// algorithm.
    pub(crate) fn flip_to_delaunay_around(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        triangles: &[usize],
    ) -> Result<()> {
        let mut waiting = alloc::copied(triangles)?;
        let mut flips = 0;
        while let Some(t) = waiting.pop() {
            if let Some(s) = (0..3).find_map(|k| self.flip_side_if_not_delaunay(rim, taken, t, k)) {
                flips += 1;
                if flips == MAX_LOCAL_FLIPS {
                    break;
                }
                alloc::extend(&mut waiting, [t, s])?;
            }
        }
        Ok(())
    }

    /// Flips side `k` of triangle `t` if its opposite angles sum to more than 180 degrees. Returns
    /// the triangle across the side if it was flipped.
    pub(crate) fn flip_side_if_not_delaunay(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        t: usize,
        k: usize,
    ) -> Option<usize> {
        let (s, j) = self.triangle_across(t, k)?;
        let [u, v] = [self.triangles[t][(k + 2) % 3], self.triangles[s][(j + 2) % 3]];
        let [p, q] = [self.triangles[t][k], self.triangles[t][(k + 1) % 3]].map(|v| self.points[v as usize]);
        let [c, d] = [u, v].map(|v| self.points[v as usize]);
        // sin(alpha + beta) times a positive factor; negative beyond 180 degrees.
        let legs = [p - c, q - c, p - d, q - d];
        let cosines = [legs[0].dot(legs[1]), legs[2].dot(legs[3])];
        if cosines[0] >= 0.0 && cosines[1] >= 0.0 {
            return None;
        }
        let (sine, other_sine) = (legs[0].cross(legs[1]).length(), legs[2].cross(legs[3]).length());
        let sum = sine * cosines[1] + other_sine * cosines[0];
        let size = legs.iter().map(|leg| leg.length()).product::<f64>();
        if sum >= -MAX_COCIRCULAR_SINE * size {
            return None;
        }
        let rims = (u as usize) < rim && (v as usize) < rim;
        if rims && taken(u, v) || self.has_edge(t, (k + 2) % 3, v) {
            return None;
        }
        let new_normals = [(d - p).cross(c - p), (q - d).cross(c - d)];
        if new_normals.iter().any(|normal| normal.length() <= MIN_TRIANGLE_AREA_RATIO * size.sqrt()) {
            return None;
        }
        let bend = |a: DVec3, b: DVec3| 1.0 - a.normalize_or_zero().dot(b.normalize_or_zero());
        let old = bend((q - p).cross(c - p), (d - p).cross(q - p));
        let new = bend(new_normals[0], new_normals[1]);
        if new > old && new > MIN_FLIP_BEND {
            return None;
        }
        self.flip_side((t, k), (s, j));
        Some(s)
    }
}
