//! Patches in the mesh: where their vertices are, and what they come from.

use super::patch::{Attempt, Patch};
use super::patch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::common_unit;
use gusset_base::geom::triangle_places::nearest_places;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Scalar, check_size};
use std::ops::Range;

/// The vertices of the mesh, and those of patches, numbered after them.
pub(super) struct Pool<'a> {
    pub(super) mesh: &'a MeshView<'a>,
    /// A power of two near the size of the rims.
    pub(super) unit: f64,
    points: Vec<DVec3>,
}

impl<'a> Pool<'a> {
    /// `rims`: points of all rims.
    pub(super) fn new(mesh: &'a MeshView<'a>, rims: &[DVec3]) -> Self {
        Pool { mesh, unit: common_unit(rims), points: Vec::new() }
    }

    pub(super) fn at(&self, v: u32) -> DVec3 {
        match (v as usize).checked_sub(self.mesh.positions().len()) {
            None => self.mesh.positions().get(v),
            Some(k) => self.points[k],
        }
    }

    /// In the unit, which keeps products in range.
    pub(super) fn scaled(&self, v: u32) -> DVec3 {
        self.at(v) / self.unit
    }

    /// The number after the last.
    pub(super) fn end(&self) -> u32 {
        (self.mesh.positions().len() + self.points.len()) as u32
    }

    /// Forgets the vertices of the patch that was placed last.
    pub(super) fn forget(&mut self, patch: &Placed) {
        self.points.truncate(patch.vertices.start as usize - self.mesh.positions().len());
    }

    /// Moves the patch that was placed last to where vertices from `first` on are, which are forgotten.
    pub(super) fn move_down(&mut self, patch: &mut Placed, first: u32) {
        let Range { start, end } = patch.vertices;
        let old = self.mesh.positions().len();
        self.points.drain(first as usize - old..start as usize - old);
        patch.triangles.as_flattened_mut().iter_mut().filter(|v| **v >= start).for_each(|v| *v -= start - first);
        patch.vertices = first..end - (start - first);
    }

    /// Puts a patch among the others; `names`: the rim's vertices in the mesh.
    pub(super) fn place(
        &mut self,
        rim: &Rim,
        names: &[u32],
        patch: &Patch,
        attempt: Attempt,
        job: &Job<'_>,
    ) -> Result<Placed> {
        let first = self.mesh.positions().len() + self.points.len();
        let end = first + patch.points.len();
        check_size(end as u64, (self.mesh.faces().half_edge_count() + 3 * patch.triangles.len()) as u64)?;
        let name = |v: u32| match (v as usize).checked_sub(rim.count) {
            None => names[v as usize],
            Some(k) => (first + k) as u32,
        };
        // What is tested is what will be returned, in the result's scalar type.
        let single = self.mesh.positions().scalar() == Scalar::F32;
        let rounded = |p: DVec3| if single { p.as_vec3().as_dvec3() } else { p };
        alloc::extend(&mut self.points, patch.points.iter().map(|&p| rounded(rim.placed(p))))?;
        let own = self.points[self.points.len() - patch.points.len()..].iter().copied();
        let around = Aabb::from_points(names.iter().map(|&v| self.mesh.positions().get(v)).chain(own));
        // Of the first triangulation's triangle that each lay on, before fairing.
        let mut parents = nearest_places(&rim.points[..rim.count], &patch.coarse, &patch.unfaired, "refining", job)?;
        parents.iter_mut().for_each(|(corners, _)| *corners = corners.map(|v| names[v as usize]));
        let triangles = alloc::collect(patch.triangles.iter().map(|triangle| triangle.map(name)))?;
        Ok(Placed { vertices: first as u32..end as u32, triangles, around, attempt, parents })
    }
}

/// A patch in the mesh.
pub(super) struct Placed {
    /// Its new vertices, in the pool's numbers.
    pub(super) vertices: Range<u32>,
    /// Its faces, in the pool's numbers.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The box round it, in the mesh's own coordinates.
    pub(super) around: Aabb,
    pub(super) attempt: Attempt,
    /// Of each new vertex.
    pub(super) parents: Vec<([u32; 3], [f64; 3])>,
}
