//! Points that two rims have in common: vertices that coincide up to the rounding of the positions.
//!
//! A strip would have faces without area at these points. They are merged instead, and divide the
//! strip into sections. Common points are pairs of places (i, j) that advance together along both
//! rims. Pairs in another order are not common points, because a strip would be twisted between
//! them.

use super::meridian::MeridianEnds;
use super::stitch_rim::Rim;
use crate::repair::coordinate_round_off;
use crate::repair::sew_edges::merge_run_ends;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, Topology};

const STAGE: &str = "comparing loops";

/// Largest distance of a common point, relative to the shorter edge of either rim at its vertex.
const MAX_DISTANCE_TO_EDGE_RATIO: f64 = 0.25;

/// An upper bound of the rounding of positions, relative to the largest coordinate.
const MAX_ROUND_OFF_TO_COORDINATE_RATIO: f64 = 1e-4;

/// Returns the common points of two rims that run side by side, ascending by the place on `a`. On
/// closed rims, the places on `b` ascend cyclically. The rims are numbered as in `whole`, and have
/// points in `unit`.
///
/// O((N + M) log M), and a pass over `whole` if some vertices are very near each other.
pub(super) fn find_common_points(
    whole: &Mesh,
    a: &Rim,
    b: &Rim,
    unit: f64,
    job: &Job<'_>,
) -> Result<Vec<MeridianEnds>> {
    let [box_a, box_b] = [a, b].map(|rim| Aabb::from_points(&rim.points));
    let largest = [box_a, box_b].map(|of| of.low.abs().max(of.high.abs()).max_element());
    let bound = MAX_ROUND_OFF_TO_COORDINATE_RATIO * largest[0].max(largest[1]);
    if !box_a.grown_by(bound).overlaps(&box_b) {
        return Ok(Vec::new());
    }
    let tree = KdTree::new(&b.points, &job.sub_job(0.0, 0.2), STAGE)?;
    let mut near: Vec<(f64, MeridianEnds)> = Vec::new();
    for (i, &p) in a.points.iter().enumerate() {
        job.sub_job(0.2, 0.6).step_within_list(i, STAGE)?;
        if let Some((squared, j)) = tree.nearest(p, f64::INFINITY, |_| true)
            && squared.sqrt() <= bound.min(reach_at(a, i)).min(reach_at(b, j as usize))
        {
            alloc::push(&mut near, (squared.sqrt(), [i as u32, j]))?;
        }
    }
    if near.is_empty() {
        return Ok(Vec::new());
    }
    let mut members = alloc::copied(&a.vertices)?;
    alloc::append(&mut members, &b.vertices)?;
    let view = whole.view(&job.sub_job(0.6, 0.8))?;
    let tolerance = coordinate_round_off(&view, &members, &job.sub_job(0.8, 1.0))? / unit;
    let mut found = alloc::gather(near.iter().filter(|&&(distance, _)| distance <= tolerance).map(|&(_, ends)| ends))?;
    keep_points_in_order(&mut found, a.closed)?;
    Ok(found)
}

/// Returns the largest distance of a common point by the edges of a rim at place `i`.
fn reach_at(rim: &Rim, i: usize) -> f64 {
    let n = rim.points.len();
    let edge = |k: usize| rim.points[k].distance(rim.points[(k + 1) % n]);
    let before = if rim.closed || i > 0 { edge((i + n - 1) % n) } else { f64::INFINITY };
    let after = if rim.closed || i + 1 < n { edge(i) } else { f64::INFINITY };
    MAX_DISTANCE_TO_EDGE_RATIO * before.min(after)
}

/// Keeps the most pairs whose second places ascend, or ascend cyclically if `cyclic`: the longest
/// ascending sequence from the pair with the smallest second place on.
fn keep_points_in_order(pairs: &mut Vec<MeridianEnds>, cyclic: bool) -> Result<()> {
    if cyclic && let Some(start) = (0..pairs.len()).min_by_key(|&k| pairs[k][1]) {
        pairs.rotate_left(start);
    }
    // For each length, the index of the least end of a sequence of that length.
    let mut ends: Vec<usize> = Vec::new();
    let mut before = alloc::filled(usize::MAX, pairs.len())?;
    for k in 0..pairs.len() {
        let at = ends.partition_point(|&end| pairs[end][1] < pairs[k][1]);
        before[k] = if at > 0 { ends[at - 1] } else { usize::MAX };
        match ends.get_mut(at) {
            Some(end) => *end = k,
            None => alloc::push(&mut ends, k)?,
        }
    }
    let mut kept = alloc::filled(false, pairs.len())?;
    let mut last = ends.last().copied().unwrap_or(usize::MAX);
    while last != usize::MAX {
        kept[last] = true;
        last = before[last];
    }
    let mut kept = kept.into_iter();
    pairs.retain(|_| kept.next() == Some(true));
    // Ascending again by the first place: only the rotation has changed the order.
    let start = (0..pairs.len()).min_by_key(|&k| pairs[k][0]).unwrap_or(0);
    pairs.rotate_left(start);
    Ok(())
}

/// Removes the pairs of `common` whose vertices cannot be merged: merging would make an edge
/// non-manifold, collapse a face, or leave two boundary edges with the same ends in different
/// sections. The rims are numbered as in `whole`.
pub(super) fn keep_mergeable_points(
    whole: &Mesh,
    a: &Rim,
    b: &Rim,
    common: &mut Vec<MeridianEnds>,
    job: &Job<'_>,
) -> Result<()> {
    let view = whole.view(&job.sub_job(0.0, 0.2))?;
    let topology = Topology::new(&view, &job.sub_job(0.2, 0.5))?;
    let ends = alloc::collect(common.iter().map(|&[i, j]| [[a.vertices[i as usize], b.vertices[j as usize]]; 2]))?;
    let (merged, _) = merge_run_ends(&view, &topology, &ends, &job.sub_job(0.5, 1.0))?;
    let mut merged = merged.into_iter();
    common.retain(|_| merged.next() == Some(true));
    if a.closed
        && let &[[i, j], [k, l]] = common.as_slice()
    {
        let (n, m) = (a.points.len() as u32, b.points.len() as u32);
        let edges = [[k - i, i + n - k], [(l + m - j) % m, (j + m - l) % m]];
        if edges[0][0] == 1 && edges[1][1] == 1 || edges[0][1] == 1 && edges[1][0] == 1 {
            common.truncate(1);
        }
    }
    Ok(())
}

/// Merges the vertices of `common` in the mesh, in the rims and in `maps`: the vertex of `b` is
/// replaced by the vertex of `a`. Other vertices keep their order.
pub(super) fn merge_common_points<'m>(
    whole: &mut Mesh,
    [a, b]: [&mut Rim; 2],
    common: &[MeridianEnds],
    maps: impl Iterator<Item = &'m mut Vec<u32>>,
) -> Result<()> {
    let count = whole.positions.len();
    let mut names = alloc::collect(0..count as u32)?;
    for &[i, j] in common {
        names[b.vertices[j as usize] as usize] = a.vertices[i as usize];
    }
    let kept = alloc::gather((0..count as u32).filter(|&v| names[v as usize] == v))?;
    for (new, &old) in (0..).zip(&kept) {
        names[old as usize] = new;
    }
    // A dropped vertex still has the old name of the vertex that replaces it.
    let (mut at, mut renamed) = (0, alloc::copied(&names)?);
    for v in 0..count {
        match kept.get(at) {
            Some(&old) if old as usize == v => at += 1,
            _ => renamed[v] = names[names[v] as usize],
        }
    }
    let rename = |v: &mut u32| *v = renamed[*v as usize];
    whole.face_corners.iter_mut().for_each(rename);
    a.vertices.iter_mut().chain(&mut b.vertices).for_each(rename);
    maps.flatten().for_each(rename);
    whole.positions = whole.positions.select_vertices(&kept)?;
    Ok(())
}
