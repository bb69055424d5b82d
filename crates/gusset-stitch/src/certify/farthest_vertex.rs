//! The input vertex that is farthest from the result's vertices.

use super::numbered_points::NumberedPoints;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::scale::{common_unit, overflow_safe_distance};
use gusset_base::job::Job;
use gusset_base::par;
use gusset_mesh::{MeshView, NONE};

/// Number of vertices that a thread looks up at a time.
const VERTICES_PER_TASK: usize = 1 << 10;

const STAGE: &str = "measuring moves";

/// The input vertex that is farthest from the nearest vertex of the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarthestVertex {
    /// The distance, rounded.
    pub distance: f64,
    /// The piece.
    pub piece: u32,
    /// The vertex of the piece.
    pub vertex: u32,
    /// The nearest vertex of the result.
    pub nearest: u32,
}

/// Finds the vertex of the meshes but the last that is farthest from the nearest vertex of the last.
/// Only vertices of faces count. `None` if the result has a vertex at each of their positions.
/// O(n log n) for n vertices.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub(super) fn find_farthest_vertex(
    meshes: &[&MeshView<'_>],
    points: &NumberedPoints,
    job: &Job<'_>,
) -> Result<Option<FarthestVertex>> {
    let [inputs @ .., result] = meshes else { return Ok(None) };
    let mut is_seen = BitSet::new(points.count())?;
    let (mut places, mut vertices) = (Vec::new(), Vec::new());
    for v in 0..result.positions().len() as u32 {
        let number = points.number(inputs.len(), v);
        if number != NONE && !is_seen.contains(number) {
            is_seen.insert(number);
            alloc::push(&mut places, result.positions().get(v))?;
            alloc::push(&mut vertices, v)?;
        }
    }
    let mut moved = Vec::new();
    for (m, mesh) in inputs.iter().enumerate() {
        for v in 0..mesh.positions().len() as u32 {
            job.sub_job(0.0, 0.0).step_within_list(v as usize, STAGE)?;
            let number = points.number(m, v);
            if number != NONE && !is_seen.contains(number) {
                is_seen.insert(number);
                alloc::push(&mut moved, [m as u32, v])?;
            }
        }
    }
    if moved.is_empty() {
        return Ok(None);
    }
    let at = |[m, v]: [u32; 2]| inputs[m as usize].positions().get(v);
    let largest = moved.iter().map(|&place| at(place)).chain(places.iter().copied());
    let unit = common_unit(&[largest.fold(DVec3::ZERO, |most, p| most.max(p.abs()))]);
    places.iter_mut().for_each(|p| *p /= unit);
    let tree = KdTree::new(&places, &job.sub_job(0.0, 0.3), STAGE)?;
    let tasks = par::split_into_ranges(moved.len(), VERTICES_PER_TASK);
    let farthest = par::map_jobs(&job.sub_job(0.3, 1.0), STAGE, tasks, |task, job| {
        let mut farthest: Option<(f64, [u32; 2], u32)> = None;
        for (k, &place) in moved[task].iter().enumerate() {
            job.step_within_heavy_list(1 << 6, k, STAGE)?;
            if let Some((squared, k)) = tree.nearest(at(place) / unit, f64::INFINITY, |_| true)
                && farthest.is_none_or(|(most, ..)| squared > most)
            {
                farthest = Some((squared, place, vertices[k as usize]));
            }
        }
        Ok(farthest)
    })?;
    // Ties go to the first vertex.
    let farthest = farthest.into_iter().flatten().reduce(|a, b| if b.0 > a.0 { b } else { a });
    Ok(farthest.map(|(_, [piece, vertex], nearest)| FarthestVertex {
        distance: overflow_safe_distance(at([piece, vertex]), result.positions().get(nearest)),
        piece,
        vertex,
        nearest,
    }))
}
