//! Grouping of loops that cost less to close with one patch than with one patch each.
//!
//! Agglomerative clustering: each loop starts as a group of its own. Two nearby loops are partners
//! if a trial on a few of their vertices predicts a gain from a common patch. Pairs of groups with
//! partners are then triangulated together. The pair with the largest relative gain is merged, and
//! the merged group is tried with its partners in turn, until no pair gains. Both costs of a pair
//! cover all its loops, with one origin and one unit.

use super::candidate_loops::CandidateLoop;
use super::faces_near_boxes::find_faces_near_boxes;
use super::fill_request::Weight;
use super::loops::{cost_of_closing, may_cost_less_together};
use super::old_faces_at_rims::OldFacesAtRims;
use super::patch::triangulate_rim;
use super::patch_rim::PatchRim;
use super::triangulation_search::MIN_RELATIVE_GAIN;
use crate::fair::Continuity;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::MeshView;
use std::cmp::Ordering;

/// Each loop's box is enlarged on all sides by this fraction of its diagonal. Two loops are near
/// each other if their enlarged boxes meet.
const RELATIVE_BOX_MARGIN: f64 = 0.5;
/// Largest number of nearest loops, or nearest groups, that a loop or group is tried with.
const MAX_TRIED_NEIGHBOURS: usize = 4;
/// Loops between two progress reports.
const LOOPS_PER_REPORT: usize = 64;
/// Largest number of loops that one patch closes, and of loops that propose one loop as a partner.
const MAX_LOOPS_PER_PATCH: usize = 16;
/// Largest number of trials in all; a trial of short loops takes up to 50 ms. A note reports that
/// pairs remain untried.
const MAX_GROUP_PAIR_TRIALS: usize = 256;

/// The triangulation of a group; `None` if none was found.
type GroupTriangulation = Option<Vec<[u32; 3]>>;

/// Loops that one patch closes.
struct LoopGroup {
    /// Indices into [`GroupSearch::loops`].
    loops: Vec<usize>,
    triangles: GroupTriangulation,
}

/// Two groups that cost less together than apart.
struct GroupPair {
    /// The relative gain: (cost apart - cost together) / cost apart.
    relative_gain: f64,
    groups: [usize; 2],
    triangles: Vec<[u32; 3]>,
}

/// Distance between the boxes of two loops, then distance between the centres of these boxes.
type BoxDistance = [f64; 2];

/// Two loops or groups, and their distance.
type NearbyPair = ([usize; 2], BoxDistance);

struct GroupSearch<'a> {
    surroundings: OldFacesAtRims<'a>,
    loops: Vec<&'a [u32]>,
    /// For each loop, the loops that may share a patch with it, and their distances.
    partners: Vec<Vec<(usize, BoxDistance)>>,
    weight: Weight,
    /// `None` for a group that was merged into a later one.
    groups: Vec<Option<LoopGroup>>,
    /// The group of each loop.
    group_of_loop: Vec<usize>,
    /// The remaining number of trials; `None` once a trial was refused.
    trials: Option<usize>,
}

/// Merges groups of single candidates into groups that one patch closes.
///
/// The search makes at most 256 trials for all loops. A loop or a merged group is tried with at
/// most 4 others. Each trial triangulates at most 16 loops together.
pub(super) fn group_by_cost(
    mesh: &MeshView<'_>,
    loops_through_vertex: &[u8],
    candidates: &[CandidateLoop],
    groups: &[Vec<usize>],
    weight: Weight,
    job: &Job<'_>,
) -> Result<Vec<Vec<usize>>> {
    let loops = alloc::collect(groups.iter().map(|group| candidates[group[0]].vertices.as_slice()))?;
    let around = |vertices: &&[u32]| Aabb::from_points(vertices.iter().map(|&v| mesh.positions().get(v)));
    let boxes = alloc::collect(loops.iter().map(around))?;
    let near = find_faces_near_boxes(mesh, &boxes, &job.sub_job(0.0, 0.05))?;
    let surroundings = OldFacesAtRims::new(mesh, loops_through_vertex, &near, Continuity::C1, &job.sub_job(0.05, 0.1))?;
    let partners = alloc::collect(loops.iter().map(|_| Vec::new()))?;
    let owner = alloc::collect(0..loops.len())?;
    // Each merge adds one group, and there are fewer merges than loops.
    let joined = alloc::with_capacity(2 * loops.len())?;
    let mut search = GroupSearch {
        surroundings,
        loops,
        partners,
        weight,
        groups: joined,
        group_of_loop: owner,
        trials: Some(MAX_GROUP_PAIR_TRIALS),
    };
    search.find_partner_groups(&boxes, &job.sub_job(0.1, 0.3))?;
    search.merge_groups(&job.sub_job(0.3, 1.0))?;
    let joined = search.groups.iter().flatten().map(|group| {
        let mut numbers = alloc::collect(group.loops.iter().map(|&k| groups[k][0]))?;
        numbers.sort_unstable();
        Ok(numbers)
    });
    let mut joined: Vec<_> = alloc::try_collect(joined)?;
    joined.sort_unstable();
    Ok(joined)
}

impl GroupSearch<'_> {
    fn find_partner_groups(&mut self, boxes: &[Aabb], job: &Job<'_>) -> Result<()> {
        let near = find_nearby_pairs(boxes, &job.sub_job(0.0, 0.2))?;
        let job = job.sub_job(0.2, 1.0);
        for (at, &([i, k], distance)) in near.iter().enumerate() {
            job.step(at as f64 / near.len() as f64, "triangulating holes")?;
            let Some((rim, _)) = self.surroundings.build_patch_rim([i, k].into_iter().map(|k| self.loops[k]), &job)?
            else {
                continue;
            };
            let polygons = rim.loop_polygons()?;
            if may_cost_less_together([&polygons[0], &polygons[1]], self.weight, &job.sub_job(1.0, 1.0))? {
                alloc::push(&mut self.partners[i], (k, distance))?;
                alloc::push(&mut self.partners[k], (i, distance))?;
            }
        }
        Ok(())
    }

    fn merge_groups(&mut self, job: &Job<'_>) -> Result<()> {
        let count = self.loops.len();
        let mut near = Vec::new();
        for k in 0..count {
            let alone = alloc::filled(k, 1)?;
            let found = if self.partners[k].is_empty() {
                None
            } else {
                self.triangulate_loops(&alone, &job.sub_job(0.0, 0.2).sub_job_of_item(k, count))?
            };
            let triangles = found.and_then(|(_, triangles)| triangles);
            self.groups.push(Some(LoopGroup { loops: alone, triangles }));
        }
        for k in 0..count {
            alloc::append(&mut near, &self.group_pairs_to_try(k)?)?;
        }
        // Spend the trials on the nearest pairs first.
        near.sort_unstable_by(compare_by_distance_then_index);
        near.dedup();
        let mut pairs = Vec::new();
        self.try_group_pairs(&near, &mut pairs, &job.sub_job(0.2, 0.6))?;
        while let Some(GroupPair { groups, triangles, .. }) = remove_best_pair(&mut pairs) {
            let [Some(one), Some(other)] = groups.map(|group| self.groups[group].take()) else {
                break;
            };
            let (new, mut loops) = (self.groups.len(), one.loops);
            alloc::append(&mut loops, &other.loops)?;
            loops.iter().for_each(|&k| self.group_of_loop[k] = new);
            self.groups.push(Some(LoopGroup { loops, triangles: Some(triangles) }));
            pairs.retain(|pair| pair.groups.iter().all(|&group| self.groups[group].is_some()));
            self.try_group_pairs(
                &self.group_pairs_to_try(new)?,
                &mut pairs,
                &job.sub_job(0.6, 1.0).sub_job_of_item(new - count, count),
            )?;
        }
        Ok(())
    }

    fn loops_of_group(&self, group: usize) -> &[usize] {
        self.groups[group].as_ref().map_or(&[], |group| &group.loops)
    }

    /// Returns the pairs of a group with its partner groups, nearest first.
    fn group_pairs_to_try(&self, group: usize) -> Result<Vec<NearbyPair>> {
        let own = self.loops_of_group(group);
        let mut neighbours = Vec::new();
        for &(k, distance) in own.iter().flat_map(|&k| &self.partners[k]) {
            let other = self.group_of_loop[k];
            if other != group && own.len() + self.loops_of_group(other).len() <= MAX_LOOPS_PER_PATCH {
                alloc::push(&mut neighbours, (other, distance))?;
            }
        }
        sort::sort_stable(&mut neighbours, &|(i, a), (k, b)| i.cmp(k).then(compare_distances(a, b)));
        neighbours.dedup_by_key(|&mut (other, _)| other);
        neighbours.sort_unstable_by(compare_by_distance_then_index);
        neighbours.truncate(MAX_TRIED_NEIGHBOURS);
        let pair = |&(other, distance): &(usize, BoxDistance)| ([group.min(other), group.max(other)], distance);
        alloc::collect(neighbours.iter().map(pair))
    }

    /// Adds the pairs that gain.
    fn try_group_pairs(&mut self, near: &[NearbyPair], pairs: &mut Vec<GroupPair>, job: &Job<'_>) -> Result<()> {
        for (at, &(groups, _)) in near.iter().enumerate() {
            let Some(left) = self.trials else {
                break;
            };
            self.trials = left.checked_sub(1);
            if self.trials.is_none() {
                job.note("too many loops are near each other, so some were not tried together: pass groups");
                break;
            }
            if let Some(pair) = self.triangulate_groups_together(groups, &job.sub_job_of_item(at, near.len()))? {
                alloc::push(pairs, pair)?;
            }
        }
        Ok(())
    }

    /// Triangulates two groups together; `None` if that gains nothing. If one of the groups lacks a
    /// triangulation of its own, the gain is 1.
    fn triangulate_groups_together(&mut self, groups: [usize; 2], job: &Job<'_>) -> Result<Option<GroupPair>> {
        let mut loops = Vec::new();
        for group in groups {
            alloc::append(&mut loops, self.loops_of_group(group))?;
        }
        let Some((rim, Some(triangles))) = self.triangulate_loops(&loops, job)? else {
            return Ok(None);
        };
        let [one, other] = groups.map(|group| self.groups[group].as_ref().and_then(|group| group.triangles.as_deref()));
        let gain = if let (Some(one), Some(other)) = (one, other) {
            let first: usize = self.loops_of_group(groups[0]).iter().map(|&k| self.loops[k].len()).sum();
            let mut apart = alloc::copied(one)?;
            alloc::extend(&mut apart, other.iter().map(|triangle| triangle.map(|v| v + first as u32)))?;
            let polygons = rim.loop_polygons()?;
            cost_of_closing(&polygons, &triangles, self.weight)?.relative_gain_over(&cost_of_closing(
                &polygons,
                &apart,
                self.weight,
            )?)
        } else {
            1.0
        };
        Ok((gain > MIN_RELATIVE_GAIN).then_some(GroupPair { relative_gain: gain, groups, triangles }))
    }

    /// Triangulates loops together; `None` if two of them share a vertex.
    fn triangulate_loops(&mut self, loops: &[usize], job: &Job<'_>) -> Result<Option<(PatchRim, GroupTriangulation)>> {
        let Some((rim, names)) = self.surroundings.build_patch_rim(loops.iter().map(|&k| self.loops[k]), job)? else {
            return Ok(None);
        };
        let taken = |u: u32, v: u32| self.surroundings.have_common_face(names[u as usize], names[v as usize]);
        let triangles = triangulate_rim(&rim, self.weight, &taken, job)?;
        Ok(Some((rim, triangles)))
    }
}

/// Removes the pair that gains most. Among equal pairs the earlier groups win.
fn remove_best_pair(pairs: &mut Vec<GroupPair>) -> Option<GroupPair> {
    let order = |(_, a): &(usize, &GroupPair), (_, b): &(usize, &GroupPair)| {
        a.relative_gain.total_cmp(&b.relative_gain).then(b.groups.cmp(&a.groups))
    };
    let best = pairs.iter().enumerate().max_by(order)?.0;
    Some(pairs.swap_remove(best))
}

fn compare_distances(a: &BoxDistance, b: &BoxDistance) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

/// Orders by distance, then by index.
fn compare_by_distance_then_index<T: Ord>((i, a): &(T, BoxDistance), (k, b): &(T, BoxDistance)) -> Ordering {
    compare_distances(a, b).then(i.cmp(k))
}

/// Returns the pairs of nearby boxes, nearest first.
///
/// Each box proposes its nearest boxes. At most [`MAX_LOOPS_PER_PATCH`] boxes may propose one box:
/// otherwise the border of a sheet would be near all holes in it.
fn find_nearby_pairs(boxes: &[Aabb], job: &Job<'_>) -> Result<Vec<NearbyPair>> {
    let rooms = alloc::collect(boxes.iter().map(|around| around.grown_by(RELATIVE_BOX_MARGIN * around.diagonal())))?;
    let order = spatial_order(&rooms, 1, &job.sub_job(0.0, 0.2), "triangulating holes")?;
    let tree = BoxTree::new(order.iter().map(|&k| rooms[k as usize]))?;
    let mut pairs = Vec::new();
    for (i, room) in rooms.iter().enumerate() {
        job.sub_job(0.2, 1.0).step_every(LOOPS_PER_REPORT, i, rooms.len(), "triangulating holes")?;
        let mut neighbours = Vec::new();
        tree.visit_overlapping(room, 0.0, |leaf| {
            let others = order.get(leaf).map(|&k| k as usize).filter(|&k| k != i);
            let distance = |k: usize| [boxes[i].distance(&boxes[k]), boxes[i].centre().distance(boxes[k].centre())];
            alloc::extend(&mut neighbours, others.map(|k| (k, distance(k))))
        })?;
        neighbours.sort_unstable_by(compare_by_distance_then_index);
        neighbours.truncate(MAX_TRIED_NEIGHBOURS);
        alloc::extend(&mut pairs, neighbours.iter().map(|&(k, distance)| ([i, k], distance)))?;
    }
    pairs.sort_unstable_by(compare_by_distance_then_index);
    let mut counts = alloc::filled(0, boxes.len())?;
    pairs.retain(|&([_, k], _)| {
        counts[k] += 1;
        counts[k] <= MAX_LOOPS_PER_PATCH
    });
    pairs.iter_mut().for_each(|(pair, _)| pair.sort_unstable());
    pairs.sort_unstable_by(compare_by_distance_then_index);
    pairs.dedup();
    Ok(pairs)
}
