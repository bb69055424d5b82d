//! Faces of patches that cut each other or old faces.

use super::placed::{Placed, Pool};
use crate::intersect::{Soup, intersecting_pairs};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;

/// Faces between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

/// The old faces near the holes, as triangles.
pub(super) struct Old {
    corners: Vec<[u32; 3]>,
    faces: Vec<u32>,
}

impl Old {
    /// Quads are split by their shorter diagonals, other polygons as fans from their first corners.
    pub(super) fn new(mesh: &MeshView<'_>, near: &[u32], job: &Job<'_>) -> Result<Old> {
        let at = |v: u32| mesh.positions().get(v);
        let (mut corners, mut faces, mut face) = (Vec::new(), Vec::new(), Vec::new());
        for (k, &f) in near.iter().enumerate() {
            job.step_every(REPORT_INTERVAL, k, near.len(), "looking for intersections")?;
            face.clear();
            alloc::extend(&mut face, mesh.face(f as usize))?;
            let squared = |p: usize, q: usize| at(face[p]).distance_squared(at(face[q]));
            let first = usize::from(face.len() == 4 && squared(0, 2) > squared(1, 3));
            let corner = |k: usize| face[(first + k) % face.len()];
            for k in 1..face.len() - 1 {
                alloc::push(&mut corners, [corner(0), corner(k), corner(k + 1)])?;
                alloc::push(&mut faces, f)?;
            }
        }
        Ok(Old { corners, faces })
    }

    /// Pairs of faces of the result for pairs of triangles of `patches`, numbered through, and after
    /// them the old ones: the larger number first, which is a patch's; each pair once, ascending.
    pub(super) fn faces_of(&self, pairs: &[[u32; 2]], patches: &[Placed], first_new: u32) -> Result<Vec<[u32; 2]>> {
        let count: usize = patches.iter().map(|patch| patch.triangles.len()).sum();
        let face = |t: u32| match (t as usize).checked_sub(count) {
            Some(k) => self.faces[k],
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

/// The pairs of triangles that cut each other and of which at least one is a patch's: those of the
/// patches are numbered through, the old ones come after them.
pub(super) fn cuts(pool: &Pool<'_>, patches: &[Placed], old: &Old, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
    let mut new = alloc::with_capacity(patches.iter().map(|patch| patch.triangles.len()).sum())?;
    patches.iter().for_each(|patch| new.extend_from_slice(&patch.triangles));
    intersecting_pairs(&Soup { at: |v| pool.scaled(v), new: &new, old: &old.corners }, job)
}

/// The patches that have triangles among pairs of [`cuts`], ascending.
pub(super) fn cutting(pairs: &[[u32; 2]], patches: &[Placed]) -> Result<Vec<usize>> {
    let mut ends = alloc::with_capacity(patches.len())?;
    for patch in patches {
        ends.push(ends.last().unwrap_or(&0) + patch.triangles.len());
    }
    let of = |&t: &u32| ends.partition_point(|&end| end <= t as usize);
    let mut found = alloc::gather(pairs.as_flattened().iter().map(of).filter(|&k| k < patches.len()))?;
    sort_distinct(&mut found);
    Ok(found)
}

/// Answers how often single patches cut.
pub(super) struct Trials<'a> {
    old: &'a Old,
    /// Over boxes of single old triangles.
    triangles: Boxes,
    /// Over those that patches stay in.
    rooms: Boxes,
}

/// A tree over single boxes, in this order.
struct Boxes {
    tree: BoxTree,
    order: Vec<u32>,
}

impl Boxes {
    fn new(boxes: &[Aabb], job: &Job<'_>) -> Result<Self> {
        let order = spatial_order(boxes, 1, job, "looking for intersections")?;
        let leaves = order.iter().map(|&k| boxes[k as usize]);
        let leaves = alloc::collect_cancellable(leaves, &job.part(1.0, 1.0), "looking for intersections")?;
        let tree = BoxTree::new_cancellable(leaves.into_iter(), &job.part(1.0, 1.0), "looking for intersections")?;
        Ok(Boxes { tree, order })
    }

    /// The boxes that overlap one.
    fn at(&self, around: &Aabb, mut found: impl FnMut(usize) -> Result<()>) -> Result<()> {
        self.tree.overlapping(around, 0.0, |leaf| self.order.get(leaf).map_or(Ok(()), |&k| found(k as usize)))
    }
}

impl<'a> Trials<'a> {
    /// `rooms`: of each patch, what it stays in, whichever way it is made. O(n log n) for n old
    /// triangles and patches.
    pub(super) fn new(pool: &Pool<'_>, old: &'a Old, rooms: &[Aabb], job: &Job<'_>) -> Result<Self> {
        let boxes = old.corners.iter().map(|triangle| Aabb::from_points(triangle.map(|v| pool.at(v))));
        let boxes = alloc::collect_cancellable(boxes, &job.part(0.0, 0.0), "looking for intersections")?;
        Ok(Trials {
            old,
            triangles: Boxes::new(&boxes, &job.part(0.0, 0.5))?,
            rooms: Boxes::new(rooms, &job.part(0.5, 1.0))?,
        })
    }

    /// How many pairs of triangles cut each other if `patch` takes the place of patch `k`: its own,
    /// and its with others.
    pub(super) fn count(
        &self,
        pool: &Pool<'_>,
        patches: &[Placed],
        k: usize,
        patch: &Placed,
        job: &Job<'_>,
    ) -> Result<usize> {
        // The unit is a power of two, and what is far below it became 0.
        let around = patch.around.inflated(f64::MIN_POSITIVE * pool.unit);
        let mut others = Vec::new();
        self.triangles.at(&around, |t| alloc::push(&mut others, self.old.corners[t]))?;
        self.rooms.at(&around, |j| {
            let other = &patches[j];
            if j != k && other.around.overlaps(&around) { alloc::append(&mut others, &other.triangles) } else { Ok(()) }
        })?;
        let soup = Soup { at: |v| pool.scaled(v), new: &patch.triangles, old: &others };
        Ok(intersecting_pairs(&soup, job)?.len())
    }
}
