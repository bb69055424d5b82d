//! Intersections of patches with each other and with old faces.

use super::placed_patch::{MeshAndPatchVertices, PlacedPatch};
use crate::intersect::{TriangleSoup, intersecting_pairs};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{FaceTriangles, MeshView};

/// Faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

/// The old faces near the holes, as triangles.
pub(super) struct OldTriangles(FaceTriangles);

impl OldTriangles {
    pub(super) fn new(mesh: &MeshView<'_>, near: &[u32], job: &Job<'_>) -> Result<OldTriangles> {
        let (mut triangles, mut face) = (FaceTriangles::default(), Vec::new());
        for (k, &f) in near.iter().enumerate() {
            job.step_every(FACES_PER_REPORT, k, near.len(), "looking for intersections")?;
            face.clear();
            alloc::extend(&mut face, mesh.face(f as usize))?;
            let within = job.sub_job_of_item(k, near.len());
            triangles.append_face(face.len(), |k| mesh.positions().get(face[k]), |k| face[k], f, &within)?;
        }
        Ok(OldTriangles(triangles))
    }

    /// Converts pairs of triangles to pairs of faces of the result. The triangles of `patches` are
    /// numbered consecutively, and the old triangles follow. The larger number comes first, and is
    /// a patch's face. Each pair occurs once, in ascending order.
    pub(super) fn pairs_of_faces(
        &self,
        pairs: &[[u32; 2]],
        patches: &[PlacedPatch],
        first_new: u32,
    ) -> Result<Vec<[u32; 2]>> {
        let count: usize = patches.iter().map(|patch| patch.triangles.len()).sum();
        let face = |t: u32| match (t as usize).checked_sub(count) {
            Some(k) => self.0.faces[k],
            None => first_new + t,
        };
        let mut faces = alloc::collect(pairs.iter().map(|pair| {
            let [f, g] = pair.map(face);
            [f.max(g), f.min(g)]
        }))?;
        sort_distinct(&mut faces);
        Ok(faces)
    }
}

/// Finds the pairs of intersecting triangles with at least one patch triangle. The triangles of the
/// patches are numbered consecutively, and the old triangles follow.
pub(super) fn find_patch_intersections(
    vertices: &MeshAndPatchVertices<'_>,
    patches: &[PlacedPatch],
    old: &OldTriangles,
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    let mut new = alloc::with_capacity(patches.iter().map(|patch| patch.triangles.len()).sum())?;
    patches.iter().for_each(|patch| new.extend_from_slice(&patch.triangles));
    intersecting_pairs(
        &TriangleSoup {
            position_of_vertex: |v| vertices.scaled_position(v),
            new_triangles: &new,
            old_triangles: &old.0.corners,
        },
        job,
    )
}

/// Returns the patches with triangles among pairs of [`find_patch_intersections`], ascending.
pub(super) fn intersecting_patches(pairs: &[[u32; 2]], patches: &[PlacedPatch]) -> Result<Vec<usize>> {
    let mut ends = alloc::with_capacity(patches.len())?;
    for patch in patches {
        ends.push(ends.last().unwrap_or(&0) + patch.triangles.len());
    }
    let of = |&t: &u32| ends.partition_point(|&end| end <= t as usize);
    let mut cutting = alloc::gather(pairs.as_flattened().iter().map(of).filter(|&k| k < patches.len()))?;
    sort_distinct(&mut cutting);
    Ok(cutting)
}

/// Counts the intersections of single patches.
pub(super) struct IntersectionCounter<'a> {
    old_triangles: &'a OldTriangles,
    /// Boxes of single old triangles.
    patch_triangles: OrderedBoxTree,
    /// Boxes that contain the patches.
    patch_boxes: OrderedBoxTree,
}

/// A tree over boxes in spatial order.
struct OrderedBoxTree {
    tree: BoxTree,
    order: Vec<u32>,
}

impl OrderedBoxTree {
    fn new(boxes: &[Aabb], job: &Job<'_>) -> Result<Self> {
        let order = spatial_order(boxes, 1, job, "looking for intersections")?;
        let leaves = order.iter().map(|&k| boxes[k as usize]);
        let leaves = alloc::collect_cancellable(leaves, &job.sub_job(1.0, 1.0), "looking for intersections")?;
        let tree = BoxTree::new_cancellable(leaves.into_iter(), &job.sub_job(1.0, 1.0), "looking for intersections")?;
        Ok(OrderedBoxTree { tree, order })
    }

    /// Visits the boxes that overlap a box.
    fn visit_overlapping_boxes(&self, around: &Aabb, mut visit: impl FnMut(usize) -> Result<()>) -> Result<()> {
        self.tree.visit_overlapping(around, 0.0, |leaf| self.order.get(leaf).map_or(Ok(()), |&k| visit(k as usize)))
    }
}

impl<'a> IntersectionCounter<'a> {
    /// Builds the trees. `patch_boxes` has a box for each patch that contains every attempt at it. O(n
    /// log n) for n old triangles and patches.
    pub(super) fn new(
        vertices: &MeshAndPatchVertices<'_>,
        old: &'a OldTriangles,
        patch_boxes: &[Aabb],
        job: &Job<'_>,
    ) -> Result<Self> {
        let boxes = old.0.corners.iter().map(|triangle| Aabb::from_points(triangle.map(|v| vertices.position(v))));
        let boxes = alloc::collect_cancellable(boxes, &job.sub_job(0.0, 0.0), "looking for intersections")?;
        Ok(IntersectionCounter {
            old_triangles: old,
            patch_triangles: OrderedBoxTree::new(&boxes, &job.sub_job(0.0, 0.5))?,
            patch_boxes: OrderedBoxTree::new(patch_boxes, &job.sub_job(0.5, 1.0))?,
        })
    }

    /// Counts the pairs of intersecting triangles if `patch` replaces patch `k`: pairs within the
    /// patch, and pairs with other triangles.
    pub(super) fn count_intersections(
        &self,
        vertices: &MeshAndPatchVertices<'_>,
        patches: &[PlacedPatch],
        k: usize,
        patch: &PlacedPatch,
        job: &Job<'_>,
    ) -> Result<usize> {
        // Enlarge the box: scaling by the unit, a power of two, may round tiny coordinates to 0.
        let around = patch.bounding_box.grown_by(f64::MIN_POSITIVE * vertices.unit);
        let mut others = Vec::new();
        self.patch_triangles
            .visit_overlapping_boxes(&around, |t| alloc::push(&mut others, self.old_triangles.0.corners[t]))?;
        self.patch_boxes.visit_overlapping_boxes(&around, |j| {
            let other = &patches[j];
            if j != k && other.bounding_box.overlaps(&around) {
                alloc::append(&mut others, &other.triangles)
            } else {
                Ok(())
            }
        })?;
        let soup = TriangleSoup {
            position_of_vertex: |v| vertices.scaled_position(v),
            new_triangles: &patch.triangles,
            old_triangles: &others,
        };
        Ok(intersecting_pairs(&soup, job)?.len())
    }
}
