//! Vertices that stay split because of the values they carry.
//!
//! Formats with a single index for all data of a vertex split vertices where texture coordinates or
//! normals jump. A merge map tells which vertices are the same ([`MeshView::merged`]), so that
//! operations see a surface without borders at seams. Afterwards, the faces of the result get the
//! split vertices back. An old corner gets its own vertex. A new corner at an old vertex gets the
//! vertex of the old corner whose values it has ([`Origins`]). The merge map of the result again
//! tells which vertices are the same.

use super::domain::Domain;
use super::origins::Origins;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, PieceOffsets};
use gusset_stitch::assemble::Assembly;
use gusset_stitch::fill::Filled;
use gusset_stitch::repair::orient::Oriented;
use gusset_stitch::repair::sew::Sew;
use gusset_stitch::repair::weld::Weld;
use gusset_stitch::stitch::Stitch;
use gusset_stitch::trim::TrimmedPieces;

const STAGE: &str = "keeping split vertices";

/// A result whose inputs may have split vertices.
pub trait KeepSplitVertices {
    /// Restores the split vertices of `inputs` in the faces of the result. Does nothing if the
    /// inputs have none. O(H log n) for H corners, n of which belong to new faces.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()>;
}

impl KeepSplitVertices for Stitch {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_stitch(self, &job.sub_job(0.0, 0.6))?;
        let [a, b] = &self.maps;
        let map = |input: usize, v: u32| if input == 0 { a.vertices[v as usize] } else { b.vertices[v as usize] };
        splits.restore_split_vertices(&mut self.mesh, &origins, map, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for Filled {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_filled(self, &job.sub_job(0.0, 0.6))?;
        splits.restore_split_vertices(&mut self.mesh, &origins, |_, v| v, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for Assembly {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_assembly(self, &job.sub_job(0.0, 0.6))?;
        let maps = &self.maps;
        let map = |input: usize, v: u32| maps[input].vertices[v as usize];
        splits.restore_split_vertices(&mut self.mesh, &origins, map, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for Weld {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_weld(self, &job.sub_job(0.0, 0.6))?;
        let map = |_, v: u32| self.vertex_map[v as usize];
        splits.restore_split_vertices(&mut self.mesh, &origins, map, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for Sew {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_sew(self, &job.sub_job(0.0, 0.6))?;
        let map = |_, v: u32| self.vertex_map[v as usize];
        splits.restore_split_vertices(&mut self.mesh, &origins, map, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for Oriented {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let origins = Origins::from_oriented(self, &job.sub_job(0.0, 0.6))?;
        splits.restore_split_vertices(&mut self.mesh, &origins, |_, v| v, &job.sub_job(0.6, 1.0))
    }
}

/// The inputs side by side, and the position of each.
impl KeepSplitVertices for (Mesh, Vec<PieceOffsets>) {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let views = alloc::collect(inputs.iter().map(|&view| *view))?;
        let origins = Origins::from_side_by_side(&views, &job.sub_job(0.0, 0.6))?;
        let (mesh, places) = self;
        splits.restore_split_vertices(mesh, &origins, |input, v| places[input].first_vertex + v, &job.sub_job(0.6, 1.0))
    }
}

impl KeepSplitVertices for TrimmedPieces {
    fn keep_split_vertices(&mut self, inputs: &[&MeshView<'_>], job: &Job<'_>) -> Result<()> {
        let Some(splits) = InputsWithSplitVertices::from_inputs(inputs) else { return Ok(()) };
        let views = alloc::collect(inputs.iter().map(|&view| *view))?;
        let origins = Origins::from_trimmed(&views, self, &job.sub_job(0.0, 0.6))?;
        let (map, places) = (&self.vertex_map, &self.piece_offsets);
        let map = |input: usize, v: u32| map[(places[input].first_vertex + v) as usize];
        splits.restore_split_vertices(&mut self.mesh, &origins, map, &job.sub_job(0.6, 1.0))
    }
}

/// The inputs of a result, some of which have split vertices.
struct InputsWithSplitVertices<'a>(&'a [&'a MeshView<'a>]);

impl<'a> InputsWithSplitVertices<'a> {
    /// Returns `None` unless an input has split vertices.
    fn from_inputs(inputs: &'a [&'a MeshView<'a>]) -> Option<Self> {
        inputs.iter().any(|mesh| mesh.faces().is_merged()).then_some(InputsWithSplitVertices(inputs))
    }

    /// Restores split vertices. `map` returns the vertex of the result that a vertex of an input
    /// became.
    fn restore_split_vertices(
        &self,
        mesh: &mut Mesh,
        origins: &Origins,
        map: impl Fn(usize, u32) -> u32,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut merge = alloc::collect(0..mesh.positions.len() as u32)?;
        for (input, view) in self.0.iter().enumerate() {
            for v in 0..view.positions().len() as u32 {
                job.sub_job(0.0, 0.3).step_within_list(v as usize, STAGE)?;
                let (own, of) = (map(input, v), map(input, view.faces().merged_vertex(v)));
                if own != NONE && of != NONE {
                    merge[own as usize] = of;
                }
            }
        }
        let (starts, corners) = (origins.first_sources_of_inputs(Domain::Corners), origins.table(Domain::Corners));
        for (k, corner) in mesh.face_corners.iter_mut().enumerate() {
            job.sub_job(0.3, 1.0).step_within_list(k, STAGE)?;
            // A corner with several sources is at a new vertex between old ones.
            let &[source] = corners.row(k).0 else { continue };
            let input = starts.partition_point(|&start| start <= source) - 1;
            let own = map(input, self.0[input].faces().corner_vertex_before_merging(source - starts[input]));
            // Vertices that welding merged with others stay merged, and dropped vertices stay
            // dropped.
            if own != NONE && merge[own as usize] == *corner {
                *corner = own;
            }
        }
        mesh.merge = merge;
        Ok(())
    }
}
