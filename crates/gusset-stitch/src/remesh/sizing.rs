//! The wanted lengths of the sides of triangles, vertex by vertex.

use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle::double_area;

/// The attributes of a patch's vertices besides their positions.
pub(crate) struct VertexSizes {
    /// The wanted length of the sides at each vertex.
    pub(crate) wanted_side_lengths: Vec<f64>,
    /// The position of each vertex without fairing.
    pub(crate) points_before_fairing: Vec<DVec3>,
    /// The rest curvature at each vertex; see [`RestShape`](crate::fair::RestShape).
    pub(crate) curvature: Vec<DVec3>,
    /// The largest number of vertices.
    pub(crate) max_vertices: usize,
    /// Sharp triangles whose shortest side is below this fraction of the size are not refined.
    pub(crate) min_shortest_side_in_sizes: f64,
}

impl VertexSizes {
    pub(crate) fn try_clone(&self) -> Result<VertexSizes> {
        let [unfaired, curvature] = [alloc::copied(&self.points_before_fairing)?, alloc::copied(&self.curvature)?];
        Ok(VertexSizes {
            wanted_side_lengths: alloc::copied(&self.wanted_side_lengths)?,
            points_before_fairing: unfaired,
            curvature,
            ..*self
        })
    }

    /// Appends the attributes of a new vertex at a weighted mean of three others.
    pub(super) fn insert_mean(&mut self, parents: [u32; 3], weights: [f64; 3]) -> Result<()> {
        let parts = || parents.into_iter().zip(weights).filter(|&(_, weight)| weight > 0.0);
        let size = parts().map(|(v, weight)| weight * self.wanted_side_lengths[v as usize]).sum();
        let mean = |of: &[DVec3]| parts().map(|(v, weight)| weight * of[v as usize]).sum::<DVec3>();
        let (unfaired, curvature) = (mean(&self.points_before_fairing), mean(&self.curvature));
        alloc::push(&mut self.wanted_side_lengths, size)?;
        alloc::push(&mut self.points_before_fairing, unfaired)?;
        alloc::push(&mut self.curvature, curvature)
    }

    /// Keeps only these vertices, in ascending order.
    pub(super) fn keep_vertices(&mut self, kept: &[u32]) {
        for (new, &old) in kept.iter().enumerate() {
            self.wanted_side_lengths[new] = self.wanted_side_lengths[old as usize];
            self.points_before_fairing[new] = self.points_before_fairing[old as usize];
            self.curvature[new] = self.curvature[old as usize];
        }
        self.wanted_side_lengths.truncate(kept.len());
        self.points_before_fairing.truncate(kept.len());
        self.curvature.truncate(kept.len());
    }

    /// Returns the mean size of a triangle.
    pub(super) fn mean_triangle_size(&self, corners: [u32; 3]) -> f64 {
        corners.iter().map(|&v| self.wanted_side_lengths[v as usize]).sum::<f64>() / 3.0
    }

    /// Returns the mean size of a side.
    pub(super) fn mean_side_size(&self, u: u32, v: u32) -> f64 {
        (self.wanted_side_lengths[u as usize] + self.wanted_side_lengths[v as usize]) / 2.0
    }
}

/// Returns the factor of all sizes that keeps the number of new vertices below `max_vertices`.
pub(crate) fn size_growth_for_limit(mesh: &PatchMesh, size: &[f64], max_vertices: u32) -> f64 {
    (estimate_new_vertices(mesh, size) / f64::from(max_vertices)).sqrt().max(1.0)
}

/// Estimates the number of new vertices for these sizes: one for each two equilateral triangles.
pub(crate) fn estimate_new_vertices(mesh: &PatchMesh, size: &[f64]) -> f64 {
    let needed = |t: usize| {
        let [a, b, c] = mesh.corner_points(t);
        let mean = mesh.triangles[t].iter().map(|&v| size[v as usize]).sum::<f64>() / 3.0;
        double_area(a, b, c) / (3f64.sqrt() * mean * mean)
    };
    (0..mesh.triangles.len()).map(needed).sum()
}
