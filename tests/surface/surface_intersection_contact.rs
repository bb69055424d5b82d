//! Intersection curves beside contacts of surfaces: they are not lost, altered, or joined through
//! empty space.

use crate::common::some_of;
use crate::pairs::{flat, grid, length, meet, one, summary, surface};
use crate::shapes::Shape;
use glam::DVec3;
use gusset::Job;
use gusset::surface::{Patches, Paths, Scheme, Sheet, Surface};
use std::f64::consts::TAU;

/// A torus of radii 2 and 0.8 that lies on the plane z = 0, which it touches along a circle.
fn lying_torus(n: usize) -> Shape {
    let point = |u: f64, v: f64| {
        let (x, z) = (2.0 + 0.8 * (TAU * v).cos(), 0.8 * (1.0 + (TAU * v).sin()));
        DVec3::new(x * (TAU * u).cos(), x * (TAU * u).sin(), z)
    };
    Shape { name: "torus", cells: [n, n], closed: [true, true], point }
}

/// An upright rectangle that crosses the plane z = 0 from one point to another.
fn upright(from: DVec3, to: DVec3) -> Sheet<'static> {
    let points = [from, to].map(|p| [p - 0.45 * DVec3::Z, p + 0.55 * DVec3::Z]);
    Sheet::Cubic(Patches::new(points.as_flattened(), [1, 1], 1, 1).unwrap())
}

/// The plane z = 0 with sides of 6, `n` times `n` cells.
fn plane(n: usize) -> Surface<'static> {
    surface(&flat(n, n), |p| 1.5 * p + DVec3::new(0.013, 0.017, 0.0))
}

/// Whether one of the paths is the segment.
fn has_segment(paths: &Paths, from: DVec3, to: DVec3) -> bool {
    (0..paths.len()).any(|k| {
        let points = paths.points_of(k);
        let ends = [points[0], points[points.len() - 1]];
        let steps: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let is = |[a, b]: [DVec3; 2]| a.distance(from) < 1e-9 && b.distance(to) < 1e-9;
        !paths.closed[k] && (steps - from.distance(to)).abs() < 1e-9 && (is(ends) || is([ends[1], ends[0]]))
    })
}

#[test]
fn a_crossing_within_a_ring_of_contact() {
    let segments = [(8, 4, -0.7, -0.6, 0.2), (8, 4, 0.3, -0.1, 0.6), (8, 4, -0.2, 0.4, 0.6), (16, 8, -0.497, 0.1, 1.0)];
    for (cells, planes, x, y, width) in some_of(4, segments.into_iter()) {
        let (from, to) = (DVec3::new(x, y, 0.0), DVec3::new(x + width, y, 0.0));
        let torus = Sheet::Grid(grid(&lying_torus(cells), Scheme::SixTap, |p| p));
        let both = Surface::new(vec![torus, upright(from, to)], None, &Job::default()).unwrap();
        let paths = meet(&plane(planes), &both);
        assert!(has_segment(&paths, from, to), "{cells} {x} {y}: {}", summary(&paths));
        assert!(!paths.unresolved.is_empty());
    }
}

#[test]
fn a_crossing_beside_a_line_of_contact() {
    let pipe = |u: f64, v: f64| {
        let angle = TAU * (v - 0.25);
        DVec3::new(4.0 * u - 2.0, angle.cos(), 1.0 + angle.sin())
    };
    let pipe = Shape { name: "pipe", cells: [6, 16], closed: [false, true], point: pipe };
    let (from, to) = (DVec3::new(0.7, 0.6, 0.0), DVec3::new(0.7, 1.4, 0.0));
    let sheets = vec![Sheet::Grid(grid(&pipe, Scheme::SixTap, |p| p)), upright(from, to)];
    let paths = meet(&plane(12), &Surface::new(sheets, None, &Job::default()).unwrap());
    assert!(has_segment(&paths, from, to), "{}", summary(&paths));
}

#[test]
fn paths_of_tori_that_nearly_touch_stay_on_both() {
    for overlap in some_of(2, [1e-4, 1e-6, 1e-8].into_iter()) {
        let shape = lying_torus(8);
        let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| p + (1.6 - overlap) * DVec3::Z));
        let paths = meet(&a, &b);
        // The default of the chords: 1e-4 of the diagonal.
        let chord = 1e-4 * a.bounds()[0].distance(a.bounds()[1]);
        for k in 0..paths.len() {
            let points = paths.points_of(k);
            let count = if paths.closed[k] { points.len() } else { points.len() - 1 };
            for n in 0..count {
                let middle = points[n].midpoint(points[(n + 1) % points.len()]);
                let far = [&a, &b].map(|surface| surface.closest(middle, f64::INFINITY).unwrap().distance);
                assert!(far[0].max(far[1]) < 1.1 * chord, "{overlap} {k}: {middle} {far:?} {}", summary(&paths));
            }
        }
        assert!(length(&paths) < 1.01 * 2.0 * TAU * 2.0, "{overlap}: {} {}", length(&paths), summary(&paths));
    }
}

#[test]
fn joints_in_a_plane_across_any_direction() {
    // As near to a plane as rounding allows, whatever direction the joints are sorted by.
    let torus = Shape {
        name: "torus",
        cells: [80, 80],
        closed: [true, true],
        point: |u, v| {
            let ring = 2.0 + 0.8 * (TAU * v).cos();
            DVec3::new(ring * (TAU * u).cos(), ring * (TAU * u).sin(), 0.8 * (TAU * v).sin())
        },
    };
    let torus = surface(&torus, |p| p);
    for normal in [DVec3::new(0.540_302, 0.612_372, 0.577_35), DVec3::new(1.0, 1.0, 1.0), DVec3::Y] {
        let normal = normal.normalize();
        let along = normal.any_orthonormal_vector();
        let across = normal.cross(along);
        let plane = surface(&flat(5, 5), |p| 2.0 * ((p.x - 0.005) * along + (p.y - 0.015) * across));
        let paths = meet(&torus, &plane);
        assert!(paths.len() == 2 && paths.closed == [true, true], "{normal}: {}", summary(&paths));
    }
}

#[test]
fn a_curve_that_goes_round_one_patch() {
    // A tube over a loop of one cubic, which begins and ends in one point.
    let corners = [[0.0, 0.0], [2.0, 1.0], [-2.0, 1.0], [0.0, 0.0]];
    let points: Vec<DVec3> = corners
        .into_iter()
        .flat_map(|[x, y]| [0, 1, 2, 3].map(|k| DVec3::new(x, y, f64::from(k) / 3.0 - 0.45)))
        .collect();
    let tube = one(Sheet::Cubic(Patches::new(&points, [3, 3], 1, 1).unwrap()));
    let paths = meet(&tube, &surface(&flat(1, 1), |p| p));
    let bezier = |t: f64| {
        let s = 1.0 - t;
        let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        corners.iter().zip(weights).map(|(c, w)| w * DVec3::new(c[0], c[1], 0.0)).sum::<DVec3>()
    };
    let around: f64 = (0..1000).map(|k| bezier(1e-3 * f64::from(k)).distance(bezier(1e-3 * f64::from(k + 1)))).sum();
    assert!(paths.len() == 1 && paths.closed[0], "{}", summary(&paths));
    assert!((length(&paths) / around - 1.0).abs() < 1e-3, "{} {around}", length(&paths));
}
