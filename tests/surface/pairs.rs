//! Shared by the tests of intersections: shapes, checks of all results, and dense sampling.

#![allow(dead_code, unreachable_pub, reason = "shared by several tests, none of which needs all of it")]

use crate::common::Silent;
use crate::shapes::{Random, Shape, torus};
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Grid, Nodes, Paths, Scheme, Sheet, Surface};
use std::f64::consts::TAU;

/// A shape's grid, moved.
pub fn grid(shape: &Shape, scheme: Scheme, motion: impl Fn(DVec3) -> DVec3) -> Grid<'static> {
    let [h, w] = shape.cells;
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let mut data = Vec::new();
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        let point = (shape.point)(at(i, h, shape.closed[0]), at(j, w, shape.closed[1]));
        data.extend(motion(point).to_array());
    }
    Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), shape.closed, scheme).unwrap()
}

pub fn one(sheet: Sheet<'static>) -> Surface<'static> {
    Surface::new(vec![sheet], None, &Job::default()).unwrap()
}

pub fn surface(shape: &Shape, motion: impl Fn(DVec3) -> DVec3) -> Surface<'static> {
    one(Sheet::Grid(grid(shape, Scheme::SixTap, motion)))
}

pub fn ring(h: usize, w: usize) -> Shape {
    Shape { name: "torus", cells: [h, w], closed: [true, true], point: |u, v| torus(u, v, 0.0) }
}

pub fn ball(h: usize, w: usize) -> Shape {
    let point = |u: f64, v: f64| {
        // The poles are points to the bit.
        let ring = if u == 0.0 || u == 1.0 { 0.0 } else { (0.5 * TAU * u).sin() };
        DVec3::new(ring * (TAU * v).cos(), ring * (TAU * v).sin(), (0.5 * TAU * u).cos())
    };
    Shape { name: "ball", cells: [h, w], closed: [false, true], point }
}

pub fn flat(h: usize, w: usize) -> Shape {
    Shape {
        name: "plane",
        cells: [h, w],
        closed: [false, false],
        point: |u, v| DVec3::new(4.0 * u - 2.0, 4.0 * v - 2.0, 0.0),
    }
}

/// The equation of the torus: the distance from it.
pub fn from_torus(p: DVec3) -> f64 {
    (p.x.hypot(p.y) - 1.0).hypot(p.z) - 0.4
}

pub fn meet(a: &Surface<'_>, b: &Surface<'_>) -> Paths {
    let paths = a.meet(b, &Options::default(), &Job::new(1, &Silent)).unwrap();
    check(&paths, a, b);
    paths
}

/// Checks all results: arrays of equal lengths, points on both surfaces, the direction.
pub fn check(paths: &Paths, a: &Surface<'_>, b: &Surface<'_>) {
    let count = paths.points.len();
    assert!(paths.places.len() == count && paths.others.len() == count && paths.normals.len() == count);
    assert!(paths.ends.len() == paths.len() + 1 && paths.levels.len() == paths.len());
    assert_eq!((paths.ends[0], *paths.ends.last().unwrap() as usize), (0, count));
    let size = a.bounds()[0].abs().max(a.bounds()[1].abs()).max_element();
    for (k, &point) in paths.points.iter().enumerate() {
        assert_eq!(a.jet(paths.places[k]).point, point);
        let other = b.jet(paths.others[k]).point;
        // Nodes where branches cross are as near as the tolerance.
        let is_node = paths.contacts.iter().any(|contact| contact.place == paths.places[k]);
        let most = if is_node { a.tolerance().max(b.tolerance()) } else { 1e-11 * size };
        assert!(point.distance(other) <= most, "{k}: {point} {other}");
        let parameters = [paths.places[k].u, paths.places[k].v, paths.others[k].u, paths.others[k].v];
        assert!(parameters.iter().all(|x| (0.0..=1.0).contains(x)));
    }
    for k in 0..paths.len() {
        let (points, first) = (paths.points_of(k), paths.ends[k] as usize);
        assert!(points.len() >= 2, "path {k}: {points:?}");
        for n in 1..points.len() {
            let normal = |at: usize| (a.normal(paths.places[at]), b.normal(paths.others[at]));
            let directions = [first + n - 1, first + n].map(|at| {
                let (own, other) = normal(at);
                own.cross(other)
            });
            let chord = points[n] - points[n - 1];
            // Where the surfaces nearly touch, the direction is not known.
            let known = directions.iter().all(|d| d.length() > 1e-3);
            assert!(!known || directions.iter().any(|d| d.dot(chord) > 0.0), "path {k}, point {n}: {chord}");
        }
    }
}

/// The distance of a point from the paths.
pub fn distance(paths: &Paths, point: DVec3) -> f64 {
    let mut best = f64::INFINITY;
    for k in 0..paths.len() {
        let points = paths.points_of(k);
        let segments = if paths.closed[k] { points.len() } else { points.len() - 1 };
        for n in 0..segments {
            let (a, b) = (points[n], points[(n + 1) % points.len()]);
            let t = ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            best = best.min(point.distance(a.lerp(b, t)));
        }
    }
    best
}

pub fn length(paths: &Paths) -> f64 {
    let of = |k: usize| {
        let points = paths.points_of(k);
        let closing = if paths.closed[k] { points[0].distance(points[points.len() - 1]) } else { 0.0 };
        points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>() + closing
    };
    (0..paths.len()).map(of).sum()
}

pub fn summary(paths: &Paths) -> String {
    let sizes: Vec<_> = (0..paths.len()).map(|k| (paths.points_of(k).len(), paths.closed[k])).collect();
    format!("{} paths {sizes:?}, {} unresolved", paths.len(), paths.unresolved.len())
}

/// Places where a function of the points of A changes its sign along rows and columns of a dense
/// sampling.
pub fn changes(a: &Grid<'_>, dense: usize, f: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let [h, w] = a.cells();
    let mut found = Vec::new();
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = a.patch(i, j);
        let point = |r: usize, c: usize| patch.point(r as f64 / dense as f64, c as f64 / dense as f64);
        let mut add = |p: DVec3, q: DVec3| {
            let (f, g) = (f(p), f(q));
            if (f > 0.0) != (g > 0.0) {
                found.push(p.lerp(q, f / (f - g)));
            }
        };
        for (r, c) in (0..=dense).flat_map(|r| (0..=dense).map(move |c| (r, c))) {
            if c < dense {
                add(point(r, c), point(r, c + 1));
            }
            if r < dense {
                add(point(r, c), point(r + 1, c));
            }
        }
    }
    found
}

pub fn turn(random: &mut Random) -> DMat3 {
    DMat3::from_axis_angle(random.point(1.0).normalize(), TAU * random.next())
}
