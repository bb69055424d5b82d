//! Ends of the old surface's creases on a rim.

use super::super::patch_rim::PatchRim;
use super::crease_curve::angle_between;
use crate::blend::MAX_FAN_TRIANGLES;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort;
use gusset_base::sort::{Buckets, select_by_rank};

/// An old edge is sharp if the normals of its faces differ by at least this angle, in radians ...
const MIN_CREASE_RADIANS: f64 = 0.6;
/// ... and by at least this multiple of the median over the old edges that end on the rim.
const MIN_BEND_TO_MEDIAN_RATIO: f64 = 6.0;
/// An edge is also sharp if it bends by more than this fraction of the sharpest edge at the same
/// vertex.
const MIN_BEND_TO_SHARPEST_RATIO: f64 = 0.5;
/// The rim follows a crease along edges that turn by less than this angle, given as its cosine, ...
const MIN_FOLLOWING_COSINE: f64 = 0.9;
/// ... and by less than this angle from the crease's last edge, given as its cosine.
const MIN_TOTAL_FOLLOWING_COSINE: f64 = 0.75;
/// Largest angle between the surfaces on the hole's side at the two ends of a crease along
/// the rim, in radians.
const MAX_SIDE_MISFIT_RADIANS: f64 = 0.7;

/// The end of a crease on a rim.
pub(super) struct CreaseEnd {
    /// The rim vertex at which the crease's last edge inside the surface ends.
    pub(super) base_vertex: usize,
    /// Number of rim edges that follow the crease from the base; negative if they run backwards.
    pub(super) following_rim_edges: isize,
    /// The rim vertex at which the crease leaves the rim; the base if the rim does not follow the
    /// crease.
    pub(super) tip_vertex: usize,
    /// The crease's vertex before the tip.
    pub(super) point_before_tip: DVec3,
    /// The unit vector from `point_before_tip` to the tip.
    pub(super) direction: DVec3,
    /// The old triangles at the base on the two sides of the crease. The first side is beside the
    /// rim edge that ends at the base, the second beside the rim edge that begins there.
    pub(super) triangles_beside: [Vec<u32>; 2],
    /// The unit normals of the surface on these sides.
    pub(super) normals: [DVec3; 2],
}

impl CreaseEnd {
    /// Returns a positive value for a convex crease, or a negative value; the same sign convention
    /// for all ends.
    pub(super) fn convexity(&self) -> f64 {
        self.normals[1].cross(self.normals[0]).dot(self.direction)
    }

    /// Returns the vertices of a rim of `count` vertices along which the crease runs, in rim order.
    pub(super) fn rim_vertices_along_crease(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        let first = if self.following_rim_edges < 0 { self.tip_vertex } else { self.base_vertex };
        (0..=self.following_rim_edges.unsigned_abs()).map(move |k| (first + k) % count)
    }
}

/// A run of rim edges along a crease that does not enter the hole.
pub(super) struct CreaseAlongRim {
    /// The run starts at this vertex and has this number of edges; 0 if the crease only touches the
    /// rim.
    pub(super) first_vertex: usize,
    pub(super) edge_count: usize,
    /// The old triangles on the hole's side of the crease, at the first and at the last vertex.
    pub(super) triangles_at_ends: [Vec<u32>; 2],
}

impl CreaseAlongRim {
    /// Returns the vertices of the run on a rim of `count` vertices, in rim order.
    pub(super) fn rim_vertices_along_crease(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        let first = self.first_vertex;
        (0..=self.edge_count).map(move |k| (first + k) % count)
    }
}

/// Corners of triangles at the rim's vertices: (the triangle, its corner before, its corner after).
pub(super) type RimCorners = Buckets<(u32, u32, u32)>;

pub(super) fn collect_rim_corners(rim: &PatchRim) -> Result<RimCorners> {
    let given =
        rim.first_ring.iter().zip(0..).flat_map(|(&[a, b, c], t)| [(b, (t, a, c)), (c, (t, b, a)), (a, (t, c, b))]);
    let at_rim = given.filter(|&(v, _)| (v as usize) < rim.rim_vertex_count).map(|(v, corner)| (v as usize, corner));
    Buckets::new(rim.rim_vertex_count, (0, 0, 0), at_rim)
}

/// Finds the crease ends on a rim, ordered by their tips, and the creases along it. No two share a
/// vertex. O(n) for n triangles.
pub(super) fn find_crease_ends(rim: &PatchRim, corners: &RimCorners) -> Result<(Vec<CreaseEnd>, Vec<CreaseAlongRim>)> {
    let mut bends = Vec::new();
    let mut sharpest = Vec::new();
    for v in 0..rim.rim_vertex_count {
        let fan = triangle_fan(rim, corners, v)?;
        let start = bends.len();
        alloc::extend(&mut bends, fan.windows(2).map(|pair| fan_bend_angle(rim, pair)))?;
        let most = bends[start..].iter().copied().fold(0.0, f64::max);
        if most >= MIN_CREASE_RADIANS {
            alloc::push(&mut sharpest, (v, most, start..bends.len(), fan))?;
        }
    }
    let usual = median(&bends)?;
    let (mut ends, mut along_rim) = (Vec::new(), Vec::new());
    for (base, most, own, fan) in
        sharpest.into_iter().filter(|&(_, most, _, _)| most >= MIN_BEND_TO_MEDIAN_RATIO * usual)
    {
        let own = &bends[own];
        let sharp = || (0..own.len()).filter(|&k| own[k] > MIN_BEND_TO_SHARPEST_RATIO * most);
        let (Some(first), Some(last)) = (sharp().next(), sharp().next_back()) else {
            continue;
        };
        match sharp().count() {
            1 => alloc::push(&mut ends, crease_end(rim, base, first, &fan)?)?,
            2 => add_creases_at_corner(rim, base, [&fan[last + 1..], &fan[..=first]], &mut ends, &mut along_rim)?,
            _ => {}
        }
    }
    let ends = extract_creases_along_rim(ends, &mut along_rim, rim.rim_vertex_count)?;
    drop_creases_with_shared_vertices(ends, along_rim, rim.rim_vertex_count)
}

/// Replaces each pair of ends between which the rim follows a crease by a crease along the rim.
/// Returns the remaining ends.
fn extract_creases_along_rim(
    ends: Vec<CreaseEnd>,
    along_rim: &mut Vec<CreaseAlongRim>,
    count: usize,
) -> Result<Vec<CreaseEnd>> {
    let mut used = alloc::filled(false, ends.len())?;
    // The ends are in the order of their bases.
    for i in 0..ends.len() {
        let j = (i + 1) % ends.len();
        let (a, b) = (&ends[i], &ends[j]);
        let edges = (b.base_vertex + count - a.base_vertex) % count;
        let reaches = a.following_rim_edges >= edges as isize || -b.following_rim_edges >= edges as isize;
        let fits = || {
            angle_between(a.normals[0], b.normals[1]) < MAX_SIDE_MISFIT_RADIANS && a.convexity() * b.convexity() > 0.0
        };
        if i != j && reaches && !used[i] && !used[j] && fits() {
            (used[i], used[j]) = (true, true);
            let sides = [alloc::copied(&a.triangles_beside[0])?, alloc::copied(&b.triangles_beside[1])?];
            alloc::push(
                along_rim,
                CreaseAlongRim { first_vertex: a.base_vertex, edge_count: edges, triangles_at_ends: sides },
            )?;
        }
    }
    let mut used = used.into_iter();
    alloc::gather(ends.into_iter().filter(|_| used.next() == Some(false)))
}

fn median(values: &[f64]) -> Result<f64> {
    let mut numbers = alloc::collect(0..values.len() as u32)?;
    let middle = numbers.len() / 2;
    if numbers.is_empty() {
        return Ok(0.0);
    }
    select_by_rank(&mut numbers, middle, |k| values[k as usize]);
    Ok(values[numbers[middle] as usize])
}

/// Returns the triangles around a vertex, from its outgoing to its incoming rim edge. Each comes
/// with the vertex that it shares with the next. The result is empty if they do not form a fan, or
/// if the fan has too many triangles.
fn triangle_fan(rim: &PatchRim, corners: &RimCorners, v: usize) -> Result<Vec<(u32, u32)>> {
    let own = corners.get(v);
    let [before, after] =
        [(v + rim.rim_vertex_count - 1) % rim.rim_vertex_count, (v + 1) % rim.rim_vertex_count].map(|v| v as u32);
    let mut fan = Vec::new();
    let mut side = after;
    while side != before {
        let next = own.iter().find(|&&(_, from, _)| from == side);
        let Some(&(t, _, to)) = next.filter(|_| fan.len() < own.len().min(MAX_FAN_TRIANGLES)) else {
            return Ok(Vec::new());
        };
        alloc::push(&mut fan, (t, to))?;
        side = to;
    }
    Ok(fan)
}

fn double_area_vector(rim: &PatchRim, t: u32) -> DVec3 {
    let [a, b, c] = rim.first_ring[t as usize].map(|v| rim.points[v as usize]);
    (b - a).cross(c - a)
}

/// Returns the angle between two triangles of a fan; 0 if one of them is degenerate.
fn fan_bend_angle(rim: &PatchRim, pair: &[(u32, u32)]) -> f64 {
    angle_between(double_area_vector(rim, pair[0].0), double_area_vector(rim, pair[1].0))
}

fn side_of_fan(rim: &PatchRim, fan: &[(u32, u32)]) -> Result<(Vec<u32>, DVec3)> {
    let normal = fan.iter().map(|&(t, _)| double_area_vector(rim, t)).sum::<DVec3>().normalize_or_zero();
    Ok((alloc::collect(fan.iter().map(|&(t, _)| t))?, normal))
}

/// Handles a vertex at which two creases pass or end, with the triangles beyond them on either
/// side. If these triangles bend against each other, a new crease starts along their line of
/// intersection.
fn add_creases_at_corner(
    rim: &PatchRim,
    base: usize,
    fans: [&[(u32, u32)]; 2],
    ends: &mut Vec<CreaseEnd>,
    along_rim: &mut Vec<CreaseAlongRim>,
) -> Result<()> {
    let [(before, n), (after, m)] = [side_of_fan(rim, fans[0])?, side_of_fan(rim, fans[1])?];
    let sides = [before, after];
    if angle_between(n, m) < MIN_CREASE_RADIANS {
        return alloc::push(along_rim, CreaseAlongRim { first_vertex: base, edge_count: 0, triangles_at_ends: sides });
    }
    let corner = rim.points[base];
    let centre = rim.points[..rim.rim_vertex_count].iter().sum::<DVec3>() / rim.rim_vertex_count as f64;
    let line = n.cross(m).normalize_or_zero();
    let direction = if line.dot(centre - corner) < 0.0 { -line } else { line };
    let from = corner - direction * corner.distance(rim.points[(base + 1) % rim.rim_vertex_count]);
    alloc::push(
        ends,
        CreaseEnd {
            base_vertex: base,
            following_rim_edges: 0,
            tip_vertex: base,
            point_before_tip: from,
            direction,
            triangles_beside: sides,
            normals: [n, m],
        },
    )
}

/// Returns where the crease between the triangles k and k + 1 of a fan meets the rim, and its
/// direction there.
fn crease_end(rim: &PatchRim, base: usize, k: usize, fan: &[(u32, u32)]) -> Result<CreaseEnd> {
    let (after, before) = fan.split_at(k + 1);
    let [(before, n), (after, m)] = [side_of_fan(rim, before)?, side_of_fan(rim, after)?];
    let from = rim.points[fan[k].1 as usize];
    let (following, from) = follow_crease_along_rim(rim, base, from);
    let tip = base.wrapping_add_signed(following + rim.rim_vertex_count as isize) % rim.rim_vertex_count;
    let direction = (rim.points[tip] - from).normalize_or_zero();
    Ok(CreaseEnd {
        base_vertex: base,
        following_rim_edges: following,
        tip_vertex: tip,
        point_before_tip: from,
        direction,
        triangles_beside: [before, after],
        normals: [n, m],
    })
}

/// Returns the number of rim edges that continue a crease from its base, signed by their direction,
/// and the crease's vertex before the tip.
fn follow_crease_along_rim(rim: &PatchRim, base: usize, from: DVec3) -> (isize, DVec3) {
    let n = rim.rim_vertex_count;
    let at = |by: isize| rim.points[base.wrapping_add_signed(by + n as isize) % n];
    let direction = |p: DVec3, q: DVec3| (q - p).normalize_or_zero();
    let turn = |way: isize| direction(from, at(0)).dot(direction(at(0), at(way)));
    let way = if turn(1) >= turn(-1) { 1 } else { -1 };
    let (mut steps, mut last) = (0isize, from);
    while steps.unsigned_abs() + 2 < n {
        let (here, next) = (at(steps), at(steps + way));
        let goes = direction(here, next);
        if direction(last, here).dot(goes) < MIN_FOLLOWING_COSINE
            || direction(from, at(0)).dot(goes) < MIN_TOTAL_FOLLOWING_COSINE
        {
            break;
        }
        (steps, last) = (steps + way, here);
    }
    (steps, last)
}

/// Keeps the ends and creases along the rim that share no rim vertex with another. Sorts the ends
/// by their tips.
fn drop_creases_with_shared_vertices(
    mut ends: Vec<CreaseEnd>,
    mut along_rim: Vec<CreaseAlongRim>,
    count: usize,
) -> Result<(Vec<CreaseEnd>, Vec<CreaseAlongRim>)> {
    let mut uses = alloc::filled(0u32, count)?;
    ends.iter().flat_map(|end| end.rim_vertices_along_crease(count)).for_each(|v| uses[v] += 1);
    along_rim.iter().flat_map(|crease| crease.rim_vertices_along_crease(count)).for_each(|v| uses[v] += 1);
    ends.retain(|end| end.rim_vertices_along_crease(count).all(|v| uses[v] == 1));
    along_rim.retain(|crease| crease.rim_vertices_along_crease(count).all(|v| uses[v] == 1));
    sort::sort_stable(&mut ends, &|x, y| x.tip_vertex.cmp(&y.tip_vertex));
    Ok((ends, along_rim))
}
