//! Equal positions of several meshes have one number.

use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{MAX_ELEMENTS, MeshView, NONE};
use std::cmp::Ordering;

const STAGE: &str = "comparing positions";

/// The positions of the vertices that faces use, numbered from 0 in lexicographic order.
pub(super) struct NumberedPoints {
    /// The start of each mesh's vertices in `number_of_vertex`.
    mesh_starts: Vec<usize>,
    /// For each vertex of all meshes, the number of its position; [`NONE`] if no face uses it.
    number_of_vertex: Vec<u32>,
    /// The number of different positions.
    distinct_count: usize,
}

/// A vertex of all meshes, and its position.
struct PlacedVertex {
    point: [f64; 3],
    vertex: u32,
}

impl NumberedPoints {
    /// Numbers the positions of meshes. -0 equals 0. O(n log n) for n vertices.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub(super) fn new(meshes: &[&MeshView<'_>], job: &Job<'_>) -> Result<Self> {
        let total: u64 = meshes.iter().map(|mesh| mesh.positions().len() as u64).sum();
        Error::check_count("vertices", total, MAX_ELEMENTS)?;
        let mut starts = alloc::with_capacity(meshes.len())?;
        let mut numbers = alloc::filled(NONE, total as usize)?;
        let mut placed = Vec::new();
        let mut start = 0;
        for mesh in meshes {
            let own = &mut numbers[start..start + mesh.positions().len()];
            job.sub_job(0.0, 0.2).work_in_ranges(STAGE, mesh.faces().half_edge_count(), |corners| {
                mesh.faces().corners(corners).for_each(|v| own[v as usize] = 0);
                Ok(())
            })?;
            let used = own.iter().zip(0..).filter(|&(&number, _)| number != NONE);
            // Adding 0 turns -0 into 0.
            let place = |v: u32| PlacedVertex {
                point: mesh.positions().get(v).to_array().map(|x| x + 0.0),
                vertex: start as u32 + v,
            };
            alloc::extend(&mut placed, used.map(|(_, v)| place(v)))?;
            starts.push(start);
            start += mesh.positions().len();
        }
        sort(&mut placed, |a, b| compare_points(a, b).then(a.vertex.cmp(&b.vertex)), &job.sub_job(0.2, 0.9), STAGE)?;
        let mut count = 0;
        for (k, equal) in placed.chunk_by(|a, b| compare_points(a, b).is_eq()).enumerate() {
            job.sub_job(0.9, 1.0).step_within_list(k, STAGE)?;
            equal.iter().for_each(|placed| numbers[placed.vertex as usize] = count);
            count += 1;
        }
        Ok(NumberedPoints { mesh_starts: starts, number_of_vertex: numbers, distinct_count: count as usize })
    }

    /// Returns the number of different positions.
    pub(super) fn count(&self) -> usize {
        self.distinct_count
    }

    /// Returns the number of a vertex's position; [`NONE`] if no face uses the vertex.
    pub(super) fn number(&self, mesh: usize, vertex: u32) -> u32 {
        self.number_of_vertex[self.mesh_starts[mesh] + vertex as usize]
    }
}

fn compare_points(a: &PlacedVertex, b: &PlacedVertex) -> Ordering {
    let orders = a.point.iter().zip(&b.point).map(|(x, y)| x.total_cmp(y));
    orders.reduce(Ordering::then).unwrap_or(Ordering::Equal)
}
