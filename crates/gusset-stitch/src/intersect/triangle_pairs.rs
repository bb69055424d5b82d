//! All pairs of intersecting triangles with at least one new triangle.

use super::predicates::triangles_intersect;
use super::triangle_fans::{TriangleFans, TrianglePlanes};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::geom::oriented_box::OrientedBox;
use gusset_base::job::Job;
use gusset_base::par;

/// Number of new triangles in a leaf of the tree of boxes.
const MAX_LEAF_TRIANGLES: usize = 4;

/// Number of triangles that a thread tests at a time.
const TRIANGLES_PER_TASK: usize = 1 << 9;
/// Number of triangles between two progress reports.
const TRIANGLES_PER_REPORT: usize = 1 << 15;

/// Number of visited leaves between two progress reports. If all triangles coincide, each visits
/// all leaves.
const LEAVES_PER_REPORT: usize = 1 << 11;

/// Number of groups of triangles between two progress reports while the tree is built.
const GROUPS_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "looking for intersections";

/// New and old triangles over common points, in a unit that keeps products in range.
pub(crate) struct TriangleSoup<'a, P: Fn(u32) -> DVec3 + Sync> {
    /// Returns the position of a vertex.
    pub(crate) position_of_vertex: P,
    /// The new triangles.
    pub(crate) new_triangles: &'a [[u32; 3]],
    /// The old triangles to test.
    pub(crate) old_triangles: &'a [[u32; 3]],
}

/// Returns an oriented box for each node of the tree over groups of triangles in this order.
/// Triangles of strips between dense rims are needles, whose axis-aligned boxes would overlap
/// thousands of others.
fn oriented_boxes(order: &[u32], corners: impl Fn(u32) -> [DVec3; 3], job: &Job<'_>) -> Result<Vec<OrientedBox>> {
    let groups = order.chunks(MAX_LEAF_TRIANGLES);
    let leaves = groups.len().next_power_of_two();
    let empty = std::iter::repeat_n(OrientedBox::EMPTY, 2 * leaves);
    let mut boxes = alloc::collect_cancellable(empty, &job.sub_job(0.0, 0.0), STAGE)?;
    for (k, (turned, group)) in boxes[leaves..].iter_mut().zip(groups).enumerate() {
        job.step_every(GROUPS_PER_REPORT, k, leaves, STAGE)?;
        *turned = OrientedBox::from_triangles(group.iter().map(|&i| corners(i)));
    }
    for node in (1..leaves).rev() {
        job.step_every(GROUPS_PER_REPORT, node, leaves, STAGE)?;
        boxes[node] = boxes[2 * node].union(&boxes[2 * node + 1]);
    }
    Ok(boxes)
}

/// Returns the pairs (new, other) of triangles that intersect, in ascending order. Old triangle k
/// has the index `soup.new.len()` + k. In a pair of two new triangles the smaller index comes
/// first. See [`triangles_intersect`] for the pairs that count.
///
/// O((n + o) log n + overlapping pairs of boxes) for n new and o old triangles; extra memory about
/// 200 bytes per new triangle.
pub(crate) fn intersecting_pairs(
    soup: &TriangleSoup<'_, impl Fn(u32) -> DVec3 + Sync>,
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    intersecting_pairs_where(soup, &|_, _| true, &|_, _| true, job)
}

/// Returns the [`intersecting_pairs`] among the `wanted` pairs for which `list` returns true.
/// `list` is called only for pairs that intersect.
pub(crate) fn intersecting_pairs_where(
    soup: &TriangleSoup<'_, impl Fn(u32) -> DVec3 + Sync>,
    wanted: &(impl Fn(u32, u32) -> bool + Sync),
    list: &(impl Fn(u32, u32) -> bool + Sync),
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    if soup.new_triangles.is_empty() {
        return Ok(Vec::new());
    }
    job.step(0.0, STAGE)?;
    let around = |t: &[u32; 3]| Aabb::from_points(t.map(&soup.position_of_vertex));
    let boxes = alloc::collect_cancellable(soup.new_triangles.iter().map(around), &job.sub_job(0.0, 0.0), STAGE)?;
    let order = spatial_order(&boxes, MAX_LEAF_TRIANGLES, &job.sub_job(0.0, 0.1), STAGE)?;
    let job = job.sub_job(0.1, 1.0);
    let leaf_box = |leaf: &[u32]| leaf.iter().fold(Aabb::EMPTY, |whole, &i| whole.union(boxes[i as usize]));
    let tree = BoxTree::new_cancellable(order.chunks(MAX_LEAF_TRIANGLES).map(leaf_box), &job.sub_job(0.0, 0.0), STAGE)?;
    job.step(0.0, STAGE)?;
    let turned = oriented_boxes(
        &order,
        |i| soup.new_triangles[i as usize].map(&soup.position_of_vertex),
        &job.sub_job(0.0, 0.0),
    )?;
    let report = |k| job.sub_job(0.0, 0.0).step_every(GROUPS_PER_REPORT, k, order.len(), STAGE);
    let fans = TriangleFans::new(&order, MAX_LEAF_TRIANGLES, soup.new_triangles, &soup.position_of_vertex, &report)?;
    let n = soup.new_triangles.len();
    let pairs_of = |range: std::ops::Range<usize>, job: &Job<'_>| -> Result<Vec<[u32; 2]>> {
        let (mut pairs_of_chunk, mut leaves) = (Vec::new(), 0usize);
        for k in range {
            let (triangle, query) = if k < n {
                (soup.new_triangles[k], boxes[k])
            } else {
                (soup.old_triangles[k - n], around(&soup.old_triangles[k - n]))
            };
            let corners = triangle.map(&soup.position_of_vertex);
            let sides = TrianglePlanes::new(triangle, corners);
            let enter = |node: usize, b: &Aabb| {
                b.overlaps(&query) && !turned[node].is_beside(&corners) && !fans.meets_fan_only_in_apex(node, &sides)
            };
            tree.visit_accepted(enter, |leaf| {
                leaves += 1;
                if leaves.is_multiple_of(LEAVES_PER_REPORT) {
                    job.step(0.0, STAGE)?;
                }
                let of_leaf = &order[MAX_LEAF_TRIANGLES * leaf..n.min(MAX_LEAF_TRIANGLES * (leaf + 1))];
                let met = |&&i: &&u32| {
                    (i as usize) < k
                        && boxes[i as usize].overlaps(&query)
                        && wanted(i, k as u32)
                        && !sides
                            .meets_only_in_common_vertices(soup.new_triangles[i as usize], &soup.position_of_vertex)
                        && triangles_intersect(soup.new_triangles[i as usize], triangle, &soup.position_of_vertex)
                        && list(i, k as u32)
                };
                of_leaf.iter().filter(met).try_for_each(|&i| alloc::push(&mut pairs_of_chunk, [i, k as u32]))
            })?;
        }
        Ok(pairs_of_chunk)
    };
    let mut pairs = Vec::new();
    let total = n + soup.old_triangles.len();
    for start in (0..total).step_by(TRIANGLES_PER_REPORT) {
        let count = TRIANGLES_PER_REPORT.min(total - start);
        let part = job.sub_job(start as f64 / total as f64, (start + count) as f64 / total as f64);
        let pairs_of_chunk =
            par::map_jobs(&part, STAGE, par::split_into_ranges(count, TRIANGLES_PER_TASK), |range, job| {
                pairs_of(start + range.start..start + range.end, job)
            })?;
        alloc::append_all(&mut pairs, pairs_of_chunk.into_iter().map(Ok))?;
    }
    pairs.sort_unstable();
    job.step(1.0, STAGE)?;
    Ok(pairs)
}
