//! The old faces around a patch: the sizes they imply for its triangles, and the plate that is
//! clamped to them.

use super::fold_free_moves::move_without_folds;
use crate::fair::{Continuity, LaplacianWeights, Plate, RestShape, mean_curvature, minimise_plate_energy};
use crate::remesh::{PatchMesh, VertexSizes};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// The cosine of the smallest bend that makes a crease between new triangles. The bend must also
/// exceed twice the usual bend of the old faces at the rims.
pub(super) const MIN_SMOOTH_BEND_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// A rim vertex with more triangles is the apex of a fan, and says little about slopes.
pub(crate) const MAX_FAN_TRIANGLES: usize = 64;
/// The usual bend is this percentile of the bends of the old edges.
const USUAL_BEND_PERCENTILE: usize = 95;

/// The old faces that touch the rims. The rim vertices come first, rim by rim, then the others.
pub(crate) struct OldRing {
    /// The positions relative to `origin`, in a unit of about the rims' size.
    pub(crate) points: Vec<DVec3>,
    pub(crate) origin: DVec3,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The sides of the faces, face by face.
    pub(crate) sides: Vec<(u32, u32)>,
    /// True for rim vertices whose Laplacian enters the plate's energy.
    pub(crate) has_laplacian_in_energy: Vec<bool>,
    /// The length of each rim, and whether it is a loop.
    pub(crate) rim_lengths_and_closedness: Vec<(usize, bool)>,
    /// Blends wider than this follow the coarse triangles; see [`RestShape`].
    pub(crate) max_width_without_springs: f64,
    /// The rest shape of the plate after the first solution: `None` keeps the first one. Otherwise
    /// it is the solution's own curvature, including the rims, after this number of smoothing
    /// passes. Curvature that equals its own mean, as on a sphere, is preserved.
    pub(crate) smoothing_passes_of_rest_curvature: Option<u32>,
    /// The old surface beyond, for curvature continuity.
    pub(crate) second_ring: SecondRing,
}

/// The old faces next to those that touch the rims.
#[derive(Default)]
pub(crate) struct SecondRing {
    /// The required continuity with the old surface. Without curvature continuity the other fields
    /// are empty.
    pub(crate) continuity: Continuity,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// For each old vertex after the rims', in order, true if its Laplacian is known.
    pub(crate) is_laplacian_known: Vec<bool>,
}

impl OldRing {
    /// Measures the bends of the old faces at the rims. Returns the cosine that
    /// [`USUAL_BEND_PERCENTILE`] percent of the edges reach, at least 0, and for each rim vertex
    /// whether one of its edges bends by more than [`MIN_SMOOTH_BEND_COSINE`].
    pub(super) fn measure_bends(&self) -> Result<(f64, Vec<bool>)> {
        let rim = self.has_laplacian_in_energy.len();
        let mut edges = alloc::with_capacity(3 * self.triangles.len())?;
        for &[a, b, c] in &self.triangles {
            let [p, q, r] = [a, b, c].map(|v| self.points[v as usize]);
            let normal = (q - p).cross(r - p).normalize_or_zero();
            // A degenerate triangle lacks a normal.
            if normal != DVec3::ZERO {
                edges.extend([(a, b), (b, c), (c, a)].map(|(u, v)| (u.min(v), u.max(v), normal)));
            }
        }
        sort::sort_stable(&mut edges, &|x, y| (x.0, x.1).cmp(&(y.0, y.1)));
        let pairs = edges.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1));
        let mut bends = alloc::gather(pairs.map(|pair| (pair[0].2.dot(pair[1].2), [pair[0].0, pair[0].1])))?;
        let mut creased = alloc::filled(false, rim)?;
        for (_, ends) in bends.iter().filter(|(cosine, _)| *cosine < MIN_SMOOTH_BEND_COSINE) {
            ends.iter().filter(|&&v| (v as usize) < rim).for_each(|&v| creased[v as usize] = true);
        }
        sort::sort_stable(&mut bends, &|p, q| q.0.total_cmp(&p.0));
        let usual =
            bends.get(bends.len().saturating_sub(1) * USUAL_BEND_PERCENTILE / 100).map_or(1.0, |&(cosine, _)| cosine);
        Ok((usual.max(0.0), creased))
    }

    /// Returns the mean length of the old sides at each rim vertex, weighted by length, so that
    /// slivers count little. The sizes vary slowly along the rims: each is at least the size of a
    /// neighbour minus its distance. A corner that the rim cuts off says little about the surface.
    pub(super) fn mean_side_lengths_at_rims(&self) -> Result<Vec<f64>> {
        let rim = self.has_laplacian_in_energy.len();
        let mut sums = alloc::filled((0.0, 0.0), rim)?;
        for &(u, v) in &self.sides {
            let length = self.points[u as usize].distance(self.points[v as usize]);
            for end in [u, v].into_iter().filter(|&end| (end as usize) < rim) {
                sums[end as usize].0 += length * length;
                sums[end as usize].1 += length;
            }
        }
        let mut size = alloc::collect(sums.iter().map(|&(squares, sum)| if sum > 0.0 { squares / sum } else { 0.0 }))?;
        let mut first = 0;
        for &(n, closed) in &self.rim_lengths_and_closedness {
            // Twice around a loop, in both directions.
            let places = if closed { 2 * n } else { n };
            let mut pass = |u: usize, v: usize| {
                let distance = self.points[u].distance(self.points[v]);
                size[v] = f64::max(size[v], size[u] - distance);
            };
            let at = |k: usize| first + k % n;
            (1..places).for_each(|k| pass(at(k - 1), at(k)));
            (1..places).rev().for_each(|k| pass(at(k), at(k - 1)));
            first += n;
        }
        // If all sides have length 0, any size is valid.
        Ok(size)
    }

    /// Moves the old vertices beyond the rims towards them, to the distance of the next new
    /// vertices. The plate reads the slope at the rims from them, and distant vertices are a poor
    /// guide.
    ///
    /// Does nothing for curvature continuity, because the move would change the curvature.
    pub(super) fn draw_old_vertices_to_rims(&mut self, size: &[f64]) -> Result<()> {
        if self.second_ring.continuity == Continuity::C2 {
            return Ok(());
        }
        let rim = size.len();
        let mut anchors = alloc::filled((DVec3::ZERO, 0.0, 0.0), self.points.len() - rim)?;
        for triangle in &self.triangles {
            for &v in triangle.iter().filter(|&&v| v as usize >= rim) {
                for &end in triangle.iter().filter(|&&end| (end as usize) < rim) {
                    let (sum, reach, count) = &mut anchors[v as usize - rim];
                    *sum += self.points[end as usize];
                    *reach += size[end as usize];
                    *count += 1.0;
                }
            }
        }
        for (point, (sum, reach, count)) in self.points[rim..].iter_mut().zip(anchors) {
            if count > 0.0 {
                let (anchor, reach) = (sum / count, reach / count);
                *point = anchor + (*point - anchor).clamp_length_max(reach);
            }
        }
        Ok(())
    }

    /// Returns the ring's points followed by the new points of a patch, and all triangles over
    /// them.
    fn merged_with_patch(&self, mesh: &PatchMesh) -> Result<(Vec<DVec3>, Vec<[u32; 3]>)> {
        let rim = self.has_laplacian_in_energy.len();
        let old = self.points.len();
        let mut points = alloc::copied(&self.points)?;
        alloc::append(&mut points, &mesh.points[rim..])?;
        let name = |v: u32| if (v as usize) < rim { v } else { v + (old - rim) as u32 };
        let mut triangles = alloc::copied(&self.triangles)?;
        alloc::append(&mut triangles, &self.second_ring.triangles)?;
        alloc::extend(&mut triangles, mesh.triangles.iter().map(|triangle| triangle.map(name)))?;
        Ok((points, triangles))
    }

    /// Returns the curvature of a solved patch, including its rims; see [`mean_curvature`].
    pub(super) fn smoothed_curvature_of_patch(
        &self,
        mesh: &PatchMesh,
        passes: u32,
        job: &Job<'_>,
    ) -> Result<Vec<DVec3>> {
        let (rim, old) = (self.has_laplacian_in_energy.len(), self.points.len());
        let (points, triangles) = self.merged_with_patch(mesh)?;
        let all = mean_curvature(
            &points,
            &triangles,
            &|v| v >= old || v < rim && self.has_laplacian_in_energy[v],
            passes,
            job,
        )?;
        let mut own = alloc::copied(&all[..rim])?;
        alloc::append(&mut own, &all[old..])?;
        Ok(own)
    }

    /// Moves the vertices of `mesh` from `rim` to the minimum of the thin plate's energy.
    pub(super) fn fair_patch(
        &self,
        mesh: &mut PatchMesh,
        sizing: &VertexSizes,
        unfolds: bool,
        job: &Job<'_>,
    ) -> Result<()> {
        let rim = self.has_laplacian_in_energy.len();
        let (old, new) = (self.points.len(), mesh.points.len() - rim);
        let (mut points, triangles) = self.merged_with_patch(mesh)?;
        let mut free = alloc::filled(false, old + new)?;
        free[old..].fill(true);
        let mut centres = alloc::copied(&free)?;
        centres[..rim].copy_from_slice(&self.has_laplacian_in_energy);
        centres[rim..][..self.second_ring.is_laplacian_known.len()]
            .copy_from_slice(&self.second_ring.is_laplacian_known);
        let mut curvature = alloc::copied(&sizing.curvature[..rim])?;
        alloc::append(&mut curvature, &alloc::filled(DVec3::ZERO, old - rim)?)?;
        alloc::append(&mut curvature, &sizing.curvature[rim..])?;
        let mut places = alloc::copied(&self.points)?;
        alloc::append(&mut places, &sizing.points_before_fairing[rim..])?;
        // With curvature continuity, the old surface's curvature bends the plate.
        let is_bent = self.second_ring.continuity == Continuity::C1;
        let plate = Plate {
            triangles: &triangles,
            is_free_vertex: &free,
            has_laplacian_in_energy: &centres,
            weights: LaplacianWeights::Cotangent,
            continuity: self.second_ring.continuity,
            shape: is_bent.then_some(RestShape {
                curvature: &curvature,
                rest_positions: &places,
                max_width_without_springs: self.max_width_without_springs,
            }),
            ordering_positions: None,
        };
        minimise_plate_energy(&mut points, &plate, job)?;
        if unfolds {
            return move_without_folds(mesh, rim, &points[old..]);
        }
        mesh.points[rim..].copy_from_slice(&points[old..]);
        Ok(())
    }
}
