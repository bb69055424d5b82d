//! Nearest points of six surfaces against full brute force, dense samples, and their own lower
//! bounds: long, in release.

use crate::shapes::{Random, SHAPES, Shape, curvatures, grid};
use glam::DVec3;
use gusset::Job;
use gusset::surface::{Closest, Jet, Patches, Place, Sheet, Surface};
use std::path::PathBuf;

/// One side of Wigley's hull: y = B / 2 (1 - 4 x^2 / L^2) (1 - z^2 / T^2).
const HULL: Shape = Shape {
    name: "hull",
    cells: [12, 40],
    closed: [false, false],
    point: |u, v| {
        let (x, z) = (2.0 * v - 1.0, u - 1.0);
        DVec3::new(2.0 * x, 0.4 * (1.0 - x * x) * (1.0 - z * z), 0.5 * z)
    },
};

/// The teapot's patches of $GUSSET_DATA, one a sheet.
fn teapot() -> Option<Vec<Sheet<'static>>> {
    let folder = std::env::var_os("GUSSET_DATA").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("../shared/data"),
        PathBuf::from,
    );
    let text = std::fs::read_to_string(folder.join("carcass/teapot_bezier.json")).ok()?;
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let vertices: Vec<DVec3> = data["vertices"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| DVec3::new(number(&point[0]), number(&point[1]), number(&point[2])))
        .collect();
    let sheet = |patch: &serde_json::Value| {
        let flat = |value: &serde_json::Value| -> Vec<usize> {
            let values = value.as_array().unwrap().iter();
            values
                .flat_map(|v| v.as_array().map_or_else(|| vec![v.clone()], Clone::clone))
                .map(|v| v.as_u64().unwrap() as usize)
                .collect()
        };
        let points: Vec<DVec3> = flat(patch).into_iter().map(|k| vertices[k]).collect();
        Sheet::Cubic(Patches::new(&points, [3, 3], 1, 1).unwrap())
    };
    Some(data["patches"].as_array().unwrap().iter().map(sheet).collect())
}

fn all() -> Vec<(&'static str, Surface<'static>)> {
    let mut all: Vec<_> = SHAPES
        .iter()
        .chain([&HULL])
        .map(|shape| {
            let sheets = vec![Sheet::Grid(grid(shape))];
            (shape.name, Surface::new(sheets, None, &Job::default()).unwrap())
        })
        .collect();
    match teapot() {
        Some(sheets) => all.push(("teapot", Surface::new(sheets, None, &Job::default()).unwrap())),
        None => println!("no teapot: skipped"),
    }
    all
}

fn cells(surface: &Surface<'_>) -> Vec<(u32, [u32; 2])> {
    let of = |k: usize| {
        let [h, w] = surface.sheet(k).cells();
        (0..h).flat_map(move |i| (0..w).map(move |j| (k as u32, [i as u32, j as u32])))
    };
    (0..surface.len()).flat_map(of).collect()
}

/// Points of every cell, `n + 1` each way, with their places.
fn samples(surface: &Surface<'_>, n: u32) -> Vec<(DVec3, Place)> {
    let at = |k: u32| f64::from(k) / f64::from(n);
    let mut samples = Vec::new();
    for (sheet, cell) in cells(surface) {
        for (a, b) in (0..=n).flat_map(|a| (0..=n).map(move |b| (a, b))) {
            let place = Place { sheet, cell, u: at(a), v: at(b) };
            samples.push((surface.jet(place).point, place));
        }
    }
    samples
}

/// Near the surface, far away, and at its centres of curvature.
fn query(surface: &Surface<'_>, cells: &[(u32, [u32; 2])], random: &mut Random, k: usize) -> DVec3 {
    let [low, high] = surface.bounds();
    let size = low.distance(high);
    let (sheet, cell) = cells[(random.next() * cells.len() as f64) as usize];
    let jet = surface.jet(Place { sheet, cell, u: random.next(), v: random.next() });
    match k % 4 {
        0 => jet.point + random.point(0.01 * size),
        1 => 0.5 * (low + high) + random.point(0.6 * size),
        2 => random.point(5.0 * size),
        _ => focus(&jet, random).unwrap_or(0.5 * (low + high)),
    }
}

/// A centre of principal curvature.
fn focus(jet: &Jet, random: &mut Random) -> Option<DVec3> {
    let (mean, gauss) = curvatures(jet)?;
    let root = (mean * mean - gauss).max(0.0).sqrt();
    let curvature = if random.next() < 0.5 { mean + root } else { mean - root };
    Some(jet.point + jet.normal().try_normalize()? / curvature).filter(|point| point.is_finite())
}

/// The distance of the best place that steps of Newton's method, shortened and kept within the
/// cell, lead to.
fn improved(surface: &Surface<'_>, query: DVec3, start: Place) -> f64 {
    let mut place = start;
    let mut jet = surface.jet(place);
    let mut best = jet.point.distance(query);
    for _ in 0..30 {
        let from = jet.point - query;
        let (gu, gv) = (from.dot(jet.u), from.dot(jet.v));
        let (uu, uv) = (jet.u.dot(jet.u) + from.dot(jet.uu), jet.u.dot(jet.v) + from.dot(jet.uv));
        let vv = jet.v.dot(jet.v) + from.dot(jet.vv);
        let area = uu * vv - uv * uv;
        // Newton's step, that along one parameter alone, and the gradient's.
        let steps = [
            [(vv * gu - uv * gv) / area, (uu * gv - uv * gu) / area],
            [gu / uu.abs(), 0.0],
            [0.0, gv / vv.abs()],
            [gu / jet.u.length_squared(), gv / jet.v.length_squared()],
        ];
        let mut next = None;
        for (step, length) in steps.iter().flat_map(|step| [1.0, 0.3, 0.05, 0.002].map(|length| (step, length))) {
            let (u, v) = (place.u - length * step[0], place.v - length * step[1]);
            if u.is_nan() || v.is_nan() {
                continue;
            }
            let there = Place { u: u.clamp(0.0, 1.0), v: v.clamp(0.0, 1.0), ..place };
            let distance = surface.jet(there).point.distance(query);
            if distance < best {
                (best, next) = (distance, Some(there));
            }
        }
        let Some(there) = next else { break };
        place = there;
        jet = surface.jet(place);
    }
    best
}

/// The least distance from many starts in every cell.
fn by_force(surface: &Surface<'_>, samples: &[(DVec3, Place)], each: usize, query: DVec3) -> f64 {
    let mut best = f64::INFINITY;
    let mut starts: Vec<(f64, Place)> = Vec::new();
    for cell in samples.chunks(each) {
        let mut near: Vec<(f64, Place)> = cell.iter().map(|(point, place)| (point.distance(query), *place)).collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        // How far the nearest point of the cell may be from its samples.
        let reach = cell[0].0.distance(cell[each - 1].0);
        best = near[0].0.min(best);
        starts.extend(near.into_iter().take(3).map(|(distance, place)| (distance - 0.5 * reach, place)));
    }
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (bound, start) in starts {
        if bound > best {
            break;
        }
        best = best.min(improved(surface, query, start));
    }
    best
}

/// Checks every answer.
fn check(surface: &Surface<'_>, name: &str, query: DVec3, found: &Closest, truth: f64) {
    let tolerance = surface.tolerance() + 1e-14 * query.length();
    assert!(found.bound <= truth + 1e-14 * (1.0 + query.length()), "{name}: {query} {found:?} {truth}: bound");
    assert!(found.bound <= found.distance, "{name}: {query} {found:?}");
    if found.proven {
        assert!(found.distance <= truth + tolerance, "{name}: {query} {found:?} {truth}: wrong");
    }
    assert_eq!(surface.jet(found.place).point, found.point);
    assert_eq!(found.point.distance(query), found.distance);
}

#[test]
#[ignore = "long"]
fn exhaustive_closest_by_force() {
    for (name, surface) in all() {
        let n = if name == "teapot" { 16 } else { 4 };
        let each = ((n + 1) * (n + 1)) as usize;
        let (samples, cells) = (samples(&surface, n), cells(&surface));
        let mut random = Random(17);
        let queries: Vec<DVec3> = (0..10_000).map(|k| query(&surface, &cells, &mut random, k)).collect();
        let found = surface.closest_all(&queries, f64::INFINITY, &Job::default()).unwrap();
        let (mut open, mut many, mut force_worse) = (0, 0, 0);
        for (&query, found) in queries.iter().zip(&found) {
            let found = found.as_ref().unwrap();
            let truth = by_force(&surface, &samples, each, query);
            check(&surface, name, query, found, truth);
            force_worse += u32::from(truth > found.distance + surface.tolerance());
            open += u32::from(!found.proven);
            many += u32::from(found.is_ambiguous);
        }
        println!("{name}: 10000 queries, {open} unproven, {many} with many, brute force worse {force_worse} times");
    }
}

/// A tree of samples, each node's point between the halves.
fn sort(points: &mut [DVec3], axis: usize) {
    if points.len() > 1 {
        let middle = points.len() / 2;
        points.select_nth_unstable_by(middle, |a, b| a[axis].total_cmp(&b[axis]));
        let (low, high) = points.split_at_mut(middle);
        sort(low, (axis + 1) % 3);
        sort(&mut high[1..], (axis + 1) % 3);
    }
}

fn nearest(points: &[DVec3], axis: usize, query: DVec3, best: &mut f64) {
    if points.is_empty() {
        return;
    }
    let middle = points.len() / 2;
    let point = points[middle];
    *best = best.min(point.distance(query));
    let (low, high) = (&points[..middle], &points[middle + 1..]);
    let beyond = query[axis] - point[axis];
    let (near, far) = if beyond < 0.0 { (low, high) } else { (high, low) };
    nearest(near, (axis + 1) % 3, query, best);
    if beyond.abs() < *best {
        nearest(far, (axis + 1) % 3, query, best);
    }
}

#[test]
#[ignore = "long"]
fn exhaustive_closest_million() {
    for (name, surface) in all() {
        let n = if name == "teapot" { 60 } else { 10 };
        let mut points: Vec<DVec3> = samples(&surface, n).into_iter().map(|(point, _)| point).collect();
        sort(&mut points, 0);
        let cells = cells(&surface);
        let mut random = Random(23);
        let queries: Vec<DVec3> = (0..170_000).map(|k| query(&surface, &cells, &mut random, k)).collect();
        let found = surface.closest_all(&queries, f64::INFINITY, &Job::default()).unwrap();
        let mut open = 0;
        for (&query, found) in queries.iter().zip(&found) {
            let mut upper = f64::INFINITY;
            nearest(&points, 0, query, &mut upper);
            check(&surface, name, query, found.as_ref().unwrap(), upper);
            open += u32::from(!found.unwrap().proven);
        }
        println!("{name}: 170000 queries, {open} unproven");
    }
}
