//! Loops in one plane, one round the others.
//!
//! Bridges from each inner loop to what is round it join them to one polygon that crosses itself
//! nowhere; its ears are clipped. The bridge starts at the inner loop's leftmost vertex: of the
//! edges to the left of it the nearest one has an end that is seen, or another vertex is, in the
//! triangle between (D. Eberly, *Triangulation by ear clipping*, 2002).

use super::super::clip::{clip_ears, is_planar};
use super::numbered_rims::Rims;
use super::opened::Opened;
use super::task::Task;
use crate::remesh::PatchMesh;
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// By how much of it the area may differ from the loops': what is more is an overlap.
const MAX_EXCESS: f64 = 1e-9;

/// The normal of the plane that all loops lie in; `None` if they lie in none, or enclose no area on
/// the whole.
pub(super) fn common_plane(rims: &Rims) -> Option<DVec3> {
    let first = *rims.all.points.first()?;
    let normal = rims.points().map(|points| area_vector(points, first)).sum::<DVec3>().try_normalize()?;
    is_planar(&rims.all.points, normal).then_some(normal)
}

/// Newell's formula: twice the area, along the normal.
fn area_vector(points: &[DVec3], origin: DVec3) -> DVec3 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(&p, &q)| (p - origin).cross(q - origin)).sum()
}

/// Triangles without an overlap; `None` if the loops are not one round the others, or none were
/// found.
///
/// O(k n) for the bridges of k loops of n vertices in all, and O(n log n).
pub(super) fn nested(task: &Task<'_>, normal: DVec3, job: &Job<'_>) -> Result<Option<Vec<[u32; 3]>>> {
    let rims = task.rims;
    let x = normal.any_orthonormal_vector();
    let (y, origin) = (normal.cross(x), rims.all.points[0]);
    let flat = rims.all.points.iter().map(|&p| DVec2::new((p - origin).dot(x), (p - origin).dot(y)));
    let flat = alloc::collect(flat)?;
    let areas = alloc::gather(rims.points().map(|points| area_vector(points, origin).dot(normal)))?;
    let mut outer = (0..rims.loops()).filter(|&ring| areas[ring] > 0.0);
    let (Some(outer), None) = (outer.next(), outer.next()) else {
        return Ok(None);
    };
    let Some(opened) = opened(task, &flat, outer, &job.part(0.0, 0.3))? else {
        return Ok(None);
    };
    let points = opened.polygon(rims)?.points;
    let tree = opened.tree()?;
    let taken = |i: u32, k: u32| {
        let [u, v] = [i, k].map(|place| opened.order[place as usize]);
        task.forbids(u, v) || tree.binary_search_by_key(&[u.min(v), u.max(v)], |&(ends, _)| ends).is_ok()
    };
    let Some(triangles) = clip_ears(&points, &taken, &job.part(0.3, 0.7))? else {
        return Ok(None);
    };
    let triangles = opened.named(&triangles)?;
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| flat[v as usize]);
        (b - a).perp_dot(c - a).abs()
    };
    let exact: f64 = areas.iter().sum();
    if triangles.iter().map(area).sum::<f64>() > exact * (1.0 + MAX_EXCESS) {
        return Ok(None);
    }
    let mut mesh = PatchMesh::new(alloc::copied(&rims.all.points)?, triangles)?;
    mesh.relax(rims.count(), &|u, v| (task.taken)(u, v), &job.part(0.7, 1.0))?;
    Ok(Some(mesh.triangles))
}

/// The polygon of all loops; `None` if an inner loop sees nothing of the others.
fn opened(task: &Task<'_>, flat: &[DVec2], outer: usize, job: &Job<'_>) -> Result<Option<Opened>> {
    let rims = task.rims;
    let mut opened = Opened::loop_of(rims.range(outer))?;
    let leftmost = |ring: usize| rims.range(ring).min_by(|&u, &v| order(flat[u as usize], flat[v as usize]));
    let inner = (0..rims.loops()).filter(|&ring| ring != outer);
    let mut inner = alloc::gather(inner.filter_map(|ring| leftmost(ring).map(|v| (v, ring))))?;
    sort::stable(&mut inner, &|&(u, _), &(v, _)| order(flat[u as usize], flat[v as usize]));
    let count = inner.len();
    for (done, (v, ring)) in inner.into_iter().enumerate() {
        job.step(done as f64 / count as f64, "triangulating holes")?;
        let Some(place) = seen(&opened, flat, flat[v as usize]) else {
            return Ok(None);
        };
        if (task.taken)(opened.order[place], v) {
            return Ok(None);
        }
        opened = opened.joined(place, rims.range(ring), v)?;
    }
    Ok(Some(opened))
}

fn order(p: DVec2, q: DVec2) -> std::cmp::Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

/// A place of the polygon, which is round `p`, that a bridge from there may lead to.
fn seen(opened: &Opened, flat: &[DVec2], p: DVec2) -> Option<usize> {
    let n = opened.len();
    let at = |place: usize| flat[opened.order[place % n] as usize];
    // Edges on the left of what is inside run down.
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
    // Is p between the edges at a place, on the polygon's inside?
    let looks = |place: usize| {
        let (before, here, after) = (at(place + n - 1), at(place), at(place + 1));
        let (left, right) = (turn(here, after, p) >= 0.0, turn(before, here, p) >= 0.0);
        if turn(before, here, after) > 0.0 { left && right } else { left || right }
    };
    let slope = |q: DVec2| (p.y - q.y).abs() / (p.x - q.x);
    let inside = (0..n).filter(|&place| at(place).x < p.x && holds(at(place)) && looks(place));
    // The least steep one hides behind nothing; the nearest of several.
    let least = inside.min_by(|&i, &j| slope(at(i)).total_cmp(&slope(at(j))).then(at(j).x.total_cmp(&at(i).x)));
    Some(least.unwrap_or(end))
}
