//! Patches in the mesh: the positions and parents of their vertices.

use super::patch::{Patch, PatchAttempt};
use super::patch_rim::PatchRim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::common_unit;
use gusset_base::geom::triangle_places::nearest_places;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Scalar, check_size};
use std::ops::Range;

/// The vertices of the mesh, and after them the vertices of the patches.
pub(super) struct MeshAndPatchVertices<'a> {
    pub(super) mesh: &'a MeshView<'a>,
    /// A power of two near the size of the rims.
    pub(super) unit: f64,
    points: Vec<DVec3>,
}

impl<'a> MeshAndPatchVertices<'a> {
    /// Creates the numbering of a mesh without patches. `rims` has the points of all rims.
    pub(super) fn new(mesh: &'a MeshView<'a>, rims: &[DVec3]) -> Self {
        MeshAndPatchVertices { mesh, unit: common_unit(rims), points: Vec::new() }
    }

    pub(super) fn position(&self, v: u32) -> DVec3 {
        match (v as usize).checked_sub(self.mesh.positions().len()) {
            None => self.mesh.positions().get(v),
            Some(k) => self.points[k],
        }
    }

    /// Returns a position divided by the unit, so that products stay in range.
    pub(super) fn scaled_position(&self, v: u32) -> DVec3 {
        self.position(v) / self.unit
    }

    /// Returns the number after the last vertex.
    pub(super) fn end_vertex_number(&self) -> u32 {
        (self.mesh.positions().len() + self.points.len()) as u32
    }

    /// Removes the vertices of the last patch.
    pub(super) fn remove_last_patch(&mut self, patch: &PlacedPatch) {
        self.points.truncate(patch.vertices.start as usize - self.mesh.positions().len());
    }

    /// Moves the vertices of the last patch down to `first`, and removes the vertices between.
    pub(super) fn move_last_patch_down(&mut self, patch: &mut PlacedPatch, first: u32) {
        let Range { start, end } = patch.vertices;
        let old = self.mesh.positions().len();
        self.points.drain(first as usize - old..start as usize - old);
        patch.triangles.as_flattened_mut().iter_mut().filter(|v| **v >= start).for_each(|v| *v -= start - first);
        patch.vertices = first..end - (start - first);
    }

    /// Adds a patch. `names` maps the rim's vertices to the mesh.
    pub(super) fn place_patch(
        &mut self,
        rim: &PatchRim,
        names: &[u32],
        patch: &Patch,
        attempt: PatchAttempt,
        job: &Job<'_>,
    ) -> Result<PlacedPatch> {
        let first = self.mesh.positions().len() + self.points.len();
        let end = first + patch.points.len();
        check_size(end as u64, (self.mesh.faces().half_edge_count() + 3 * patch.triangles.len()) as u64)?;
        let name = |v: u32| match (v as usize).checked_sub(rim.rim_vertex_count) {
            None => names[v as usize],
            Some(k) => (first + k) as u32,
        };
        // Round to the scalar type of the result, so that the tested positions are the returned
        // ones.
        let single = self.mesh.positions().scalar() == Scalar::F32;
        let rounded = |p: DVec3| if single { p.as_vec3().as_dvec3() } else { p };
        alloc::extend(&mut self.points, patch.points.iter().map(|&p| rounded(rim.to_mesh_coordinates(p))))?;
        let own = self.points[self.points.len() - patch.points.len()..].iter().copied();
        let around = Aabb::from_points(names.iter().map(|&v| self.mesh.positions().get(v)).chain(own));
        // The parents are the corners of the initial triangle that each new vertex lay on before
        // fairing.
        let mut parents = nearest_places(
            &rim.points[..rim.rim_vertex_count],
            &patch.coarse_triangles,
            &patch.points_before_fairing,
            "refining",
            job,
        )?;
        parents.iter_mut().for_each(|(corners, _)| *corners = corners.map(|v| names[v as usize]));
        let triangles = alloc::collect(patch.triangles.iter().map(|triangle| triangle.map(name)))?;
        Ok(PlacedPatch { vertices: first as u32..end as u32, triangles, bounding_box: around, attempt, parents })
    }
}

/// A patch whose vertices have numbers in [`MeshAndPatchVertices`].
pub(super) struct PlacedPatch {
    /// The new vertices of the patch.
    pub(super) vertices: Range<u32>,
    /// The faces of the patch.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The bounding box in mesh coordinates.
    pub(super) bounding_box: Aabb,
    pub(super) attempt: PatchAttempt,
    /// The parents of each new vertex, with their weights.
    pub(super) parents: Vec<([u32; 3], [f64; 3])>,
}
