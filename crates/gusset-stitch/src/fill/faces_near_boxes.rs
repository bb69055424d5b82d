//! Finds the old faces near the holes, in one pass over all faces for all holes.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::job::Job;
use gusset_base::par;
use gusset_mesh::MeshView;
use std::cell::Cell;
use std::ops::Range;

/// Number of faces that a thread examines at a time.
const FACES_PER_TASK: usize = 1 << 14;

const STAGE: &str = "looking round the holes";

/// Returns the faces whose boxes meet one of `boxes`, in ascending order. O(F log n) for F faces
/// and n boxes; extra memory: 4 bytes per returned face, and about 200 per box.
pub(super) fn find_faces_near_boxes(mesh: &MeshView<'_>, boxes: &[Aabb], job: &Job<'_>) -> Result<Vec<u32>> {
    let order = spatial_order(boxes, 1, &job.sub_job(0.0, 0.1), STAGE)?;
    let job = job.sub_job(0.1, 1.0);
    let tree = BoxTree::new(order.iter().map(|&i| boxes[i as usize]))?;
    let chunk = |range: Range<usize>| -> Result<Vec<u32>> {
        let mut faces_found = Vec::new();
        for f in range {
            let around = Aabb::from_points(mesh.face(f).map(|v| mesh.positions().get(v)));
            let met = Cell::new(false);
            let enter = |_, node: &Aabb| !met.get() && node.overlaps(&around);
            tree.visit_accepted(enter, |_| {
                met.set(true);
                Ok(())
            })?;
            if met.get() {
                alloc::push(&mut faces_found, f as u32)?;
            }
        }
        Ok(faces_found)
    };
    let mut near = Vec::new();
    let faces_found =
        par::map_cancellable(&job, STAGE, par::split_into_ranges(mesh.faces().len(), FACES_PER_TASK), chunk)?;
    alloc::append_all(&mut near, faces_found)?;
    Ok(near)
}
