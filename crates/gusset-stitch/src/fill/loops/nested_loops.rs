//! Planar loops, one around the others.
//!
//! Bridges join each inner loop to the loops around it, until one polygon without
//! self-intersections is left, whose ears are clipped. The bridge starts at the inner loop's
//! leftmost vertex. It leads to an end of the nearest edge on the left, or to a vertex inside the
//! triangle between them, whichever is visible (D. Eberly, *Triangulation by ear clipping*, 2002).

use super::super::planar_loops::{clip_ears, is_planar};
use super::closing_task::ClosingTask;
use super::numbered_rims::NumberedRims;
use super::opened_loops::OpenedLoops;
use crate::remesh::PatchMesh;
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// Largest relative excess of the triangles' area over the area of the loops. A larger excess means
/// an overlap.
const MAX_RELATIVE_AREA_EXCESS: f64 = 1e-9;

/// Returns the normal of the plane of all loops. Returns `None` if they are not coplanar, or if
/// their total area vector is 0.
pub(super) fn normal_of_common_plane(rims: &NumberedRims) -> Option<DVec3> {
    let first = *rims.all_vertices.points.first()?;
    let normal = rims.loop_points().map(|points| double_area_vector(points, first)).sum::<DVec3>().try_normalize()?;
    is_planar(&rims.all_vertices.points, normal).then_some(normal)
}

/// Returns twice the area vector, by Newell's formula.
fn double_area_vector(points: &[DVec3], origin: DVec3) -> DVec3 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(&p, &q)| (p - origin).cross(q - origin)).sum()
}

/// Triangulates nested loops without overlaps. Returns `None` if the loops are not nested, or if no
/// triangulation is found.
///
/// O(k n) for the bridges of k loops with n vertices in all, plus O(n log n).
pub(super) fn triangulate_nested_loops(
    task: &ClosingTask<'_>,
    normal: DVec3,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let rims = task.rims;
    let x = normal.any_orthonormal_vector();
    let (y, origin) = (normal.cross(x), rims.all_vertices.points[0]);
    let flat = rims.all_vertices.points.iter().map(|&p| DVec2::new((p - origin).dot(x), (p - origin).dot(y)));
    let flat = alloc::collect(flat)?;
    let areas = alloc::gather(rims.loop_points().map(|points| double_area_vector(points, origin).dot(normal)))?;
    let mut outer = (0..rims.loop_count()).filter(|&ring| areas[ring] > 0.0);
    let (Some(outer), None) = (outer.next(), outer.next()) else {
        return Ok(None);
    };
    let Some(opened) = join_nested_loops(task, &flat, outer, &job.sub_job(0.0, 0.3))? else {
        return Ok(None);
    };
    let points = opened.build_polygon(rims)?.points;
    let tree = opened.bridge_tree()?;
    let taken = |i: u32, k: u32| {
        let [u, v] = [i, k].map(|place| opened.vertex_at_place[place as usize]);
        task.forbids_chord(u, v) || tree.binary_search_by_key(&[u.min(v), u.max(v)], |&(ends, _)| ends).is_ok()
    };
    let Some(triangles) = clip_ears(&points, &taken, &job.sub_job(0.3, 0.7))? else {
        return Ok(None);
    };
    let triangles = opened.places_to_vertices(&triangles)?;
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| flat[v as usize]);
        (b - a).perp_dot(c - a).abs()
    };
    let exact: f64 = areas.iter().sum();
    if triangles.iter().map(area).sum::<f64>() > exact * (1.0 + MAX_RELATIVE_AREA_EXCESS) {
        return Ok(None);
    }
    let mut mesh = PatchMesh::new(alloc::copied(&rims.all_vertices.points)?, triangles)?;
    mesh.flip_edges_to_delaunay(rims.vertex_count(), &|u, v| (task.is_forbidden_edge)(u, v), &job.sub_job(0.7, 1.0))?;
    Ok(Some(mesh.triangles))
}

/// Joins all loops into one polygon; `None` if an inner loop sees no other loop.
fn join_nested_loops(
    task: &ClosingTask<'_>,
    flat: &[DVec2],
    outer: usize,
    job: &Job<'_>,
) -> Result<Option<OpenedLoops>> {
    let rims = task.rims;
    let mut opened = OpenedLoops::from_loop(rims.loop_vertices(outer))?;
    let leftmost =
        |ring: usize| rims.loop_vertices(ring).min_by(|&u, &v| compare_points(flat[u as usize], flat[v as usize]));
    let inner = (0..rims.loop_count()).filter(|&ring| ring != outer);
    let mut inner = alloc::gather(inner.filter_map(|ring| leftmost(ring).map(|v| (v, ring))))?;
    sort::sort_stable(&mut inner, &|&(u, _), &(v, _)| compare_points(flat[u as usize], flat[v as usize]));
    let count = inner.len();
    for (done, (v, ring)) in inner.into_iter().enumerate() {
        job.step(done as f64 / count as f64, "triangulating holes")?;
        let Some(place) = place_visible_from(&opened, flat, flat[v as usize]) else {
            return Ok(None);
        };
        if (task.is_forbidden_edge)(opened.vertex_at_place[place], v) {
            return Ok(None);
        }
        opened = opened.extended_by_loop(place, rims.loop_vertices(ring), v)?;
    }
    Ok(Some(opened))
}

fn compare_points(p: DVec2, q: DVec2) -> std::cmp::Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

/// Returns a place of the polygon around `p` to which a bridge from `p` may lead.
fn place_visible_from(opened: &OpenedLoops, flat: &[DVec2], p: DVec2) -> Option<usize> {
    let n = opened.len();
    let at = |place: usize| flat[opened.vertex_at_place[place % n] as usize];
    // Edges with the inside on their right-hand side in x run downwards.
    let mut hit: Option<(f64, usize)> = None;
    for place in 0..n {
        let (a, b) = (at(place), at(place + 1));
        if a.y >= p.y && p.y >= b.y && a.y > b.y {
            let x = a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
            if x <= p.x && hit.is_none_or(|(nearest, _)| x > nearest) {
                hit = Some((x, if a.x < b.x { place } else { (place + 1) % n }));
            }
        }
    }
    let (x, end) = hit?;
    let corner = at(end);
    let triangle = if p.y < corner.y { [p, corner, DVec2::new(x, p.y)] } else { [DVec2::new(x, p.y), corner, p] };
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let holds = |q: DVec2| {
        let [a, b, c] = triangle;
        turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0
    };
    // Tells whether `p` lies between the edges at a place, inside the polygon.
    let looks = |place: usize| {
        let (before, here, after) = (at(place + n - 1), at(place), at(place + 1));
        let (left, right) = (turn(here, after, p) >= 0.0, turn(before, here, p) >= 0.0);
        if turn(before, here, after) > 0.0 { left && right } else { left || right }
    };
    let slope = |q: DVec2| (p.y - q.y).abs() / (p.x - q.x);
    let inside = (0..n).filter(|&place| at(place).x < p.x && holds(at(place)) && looks(place));
    // Nothing hides the least steep one; of several, take the nearest.
    let least = inside.min_by(|&i, &j| slope(at(i)).total_cmp(&slope(at(j))).then(at(j).x.total_cmp(&at(i).x)));
    Some(least.unwrap_or(end))
}
