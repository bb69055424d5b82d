//! Lines against many starts of Newton's method in every cell, and against parity.

use crate::common::Silent;
use crate::shapes::{Random, SHAPES, Shape, grid};
use glam::{DMat3, DVec3};
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::{Grid, Nodes, Patches, Scheme, Sheet, Surface};
use gusset::{Error, Job};

/// Parameters of all points that Newton's method finds from 7 x 7 starts in every cell.
fn by_force(grid: &Grid<'_>, line: &Line) -> Vec<f64> {
    let [h, w] = grid.cells();
    let mut found: Vec<(f64, DVec3)> = Vec::new();
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = grid.patch(i, j);
        let middle = patch.point(0.5, 0.5);
        let reach = patch.points.as_flattened().iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
        let across = (middle - line.origin).cross(line.direction).length() / line.direction.length();
        if across > 1.01 * reach {
            continue;
        }
        for k in 0..49 {
            let (mut u, mut v) = (f64::from(k / 7) / 6.0, f64::from(k % 7) / 6.0);
            let mut t = 0.0;
            for _ in 0..30 {
                let jet = patch.jet(u, v);
                t = (jet.point - line.origin).dot(line.direction) / line.direction.length_squared();
                let miss = jet.point - line.origin - t * line.direction;
                let jacobian = DMat3::from_cols(jet.u, jet.v, -line.direction);
                if jacobian.determinant().abs() < 1e-14 {
                    break;
                }
                let step = jacobian.inverse() * miss;
                (u, v) = ((u - step.x).clamp(-0.3, 1.3), (v - step.y).clamp(-0.3, 1.3));
            }
            let miss = (patch.point(u, v) - line.origin - t * line.direction).length();
            let inside = (-1e-12..=1.0 + 1e-12).contains(&u) && (-1e-12..=1.0 + 1e-12).contains(&v);
            if inside && miss < 1e-12 && t >= line.from && t <= line.to {
                let point = patch.point(u, v);
                if !found.iter().any(|(_, other)| other.distance(point) < 1e-8) {
                    found.push((t, point));
                }
            }
        }
    }
    let mut found: Vec<f64> = found.into_iter().map(|(t, _)| t).collect();
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn hits_by_force_and_parity() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let mut random = Random(3);
        let mut total = 0;
        for k in 0..80 {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let line = match k % 3 {
                0 => Line::new(a, b - a),
                1 => Line::ray(a, b - a),
                _ => Line::segment(a, b),
            };
            let hits = surface.line(&line, HitSelection::All).unwrap();
            let truth = by_force(&grid, &line);
            let found: Vec<f64> = hits.iter().filter(|hit| !hit.tangent).map(|hit| hit.at).collect();
            assert_eq!(found.len(), truth.len(), "{} {k}: {line:?}: {hits:?} {truth:?}", shape.name);
            for ((t, expected), hit) in found.iter().zip(&truth).zip(&hits) {
                assert!((t - expected).abs() < 1e-9, "{} {k}: {found:?} {truth:?}", shape.name);
                assert_eq!(surface.jet(hit.place).point, hit.point);
            }
            if shape.closed == [true, true] && k % 3 == 0 {
                assert!(hits.len().is_multiple_of(2), "{} {k}: {hits:?}", shape.name);
            }
            let first = surface.line(&line, HitSelection::First).unwrap();
            assert_eq!(first.first().map(|hit| hit.at), hits.first().map(|hit| hit.at));
            assert_eq!(surface.line(&line, HitSelection::Any).unwrap().is_empty(), hits.is_empty());
            total += hits.len();
        }
        assert!(total > 30, "{}: {total}", shape.name);
    }
}

#[test]
fn through_nodes_and_along_seams() {
    // A torus: lines through nodes and along the seam circle's plane.
    let shape = &SHAPES[0];
    let surface = Surface::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap();
    let line = Line::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X);
    let hits = surface.line(&line, HitSelection::All).unwrap();
    let expected = [1.6, 2.4, 3.6, 4.4];
    assert_eq!(hits.len(), 4, "{hits:?}");
    for (hit, t) in hits.iter().zip(expected) {
        assert!((hit.at - t).abs() < 2e-4, "{hits:?}");
    }
    // A line that touches the top of the ring.
    let top = surface.jet(gusset::surface::Place { sheet: 0, cell: [5, 0], u: 0.0, v: 0.0 }).point;
    let line = Line::new(DVec3::new(top.x, -3.0, top.z), DVec3::Y);
    let hits = surface.line(&line, HitSelection::All).unwrap();
    assert!(!hits.is_empty() && hits.len() <= 2, "{hits:?}");
}

#[test]
fn lines_that_are_none() {
    let surface = Surface::new(vec![Sheet::Grid(grid(&SHAPES[2]))], None, &Job::default()).unwrap();
    for line in [
        Line::new(DVec3::ZERO, DVec3::ZERO),
        Line::new(DVec3::splat(f64::NAN), DVec3::X),
        Line::new(DVec3::ZERO, DVec3::INFINITY),
        Line { from: 1.0, to: 0.0, ..Line::new(DVec3::ZERO, DVec3::X) },
        Line { from: f64::INFINITY, ..Line::new(DVec3::ZERO, DVec3::X) },
        Line { to: f64::NEG_INFINITY, ..Line::new(DVec3::ZERO, DVec3::X) },
    ] {
        assert!(surface.line(&line, HitSelection::All).is_err());
    }
}

/// A point of a sphere's upper cap and what hangs below it, with a pole at both ends.
fn egg(u: f64, v: f64) -> DVec3 {
    let (polar, turn) = (std::f64::consts::PI * u, std::f64::consts::TAU * v);
    let ring = if u == 1.0 { 0.0 } else { polar.sin() } * (1.0 + 0.2 * polar.cos());
    DVec3::new(ring * turn.cos(), 0.7 * ring * turn.sin(), polar.cos())
}

fn saddle(u: f64, v: f64) -> DVec3 {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    DVec3::new(x, y, x * (x * x - 3.0 * y * y))
}

/// The shapes that tests share, and two more.
fn shapes() -> Vec<Shape> {
    let mut shapes: Vec<Shape> = SHAPES.into_iter().take(4).collect();
    shapes.push(Shape { name: "egg", cells: [18, 26], closed: [false, true], point: egg });
    shapes.push(Shape { name: "monkey saddle", cells: [23, 31], closed: [false, false], point: saddle });
    shapes
}

/// Compares lines with brute force, and sums with parity.
fn compare(shape: &Shape, count: usize) {
    let grid = grid(shape);
    let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
    let mut random = Random(11);
    for k in 0..count {
        let (a, b) = (random.point(1.5), random.point(1.2));
        let line = if k % 2 == 0 { Line::new(a, b - a) } else { Line::segment(a, b) };
        let hits = surface.line(&line, HitSelection::All).unwrap();
        let truth = by_force(&grid, &line);
        let found: Vec<f64> = hits.iter().filter(|hit| !hit.tangent).map(|hit| hit.at).collect();
        // Near touches may be a pair for the one and a spot for the other.
        let spots = hits.iter().filter(|hit| hit.tangent);
        let free = |t: &f64| !spots.clone().any(|spot| spot.span[0] - 1e-3 <= *t && *t <= spot.span[1] + 1e-3);
        let rest: Vec<f64> = truth.iter().copied().filter(free).collect();
        let ours: Vec<f64> = found.iter().copied().filter(free).collect();
        assert_eq!(ours.len(), rest.len(), "{} {k}: {line:?}: {hits:?} {truth:?}", shape.name);
        assert!(ours.iter().zip(&rest).all(|(a, b)| (a - b).abs() < 1e-8), "{} {k}: {ours:?} {rest:?}", shape.name);
        if (shape.closed == [true, true] || shape.name == "egg") && k % 2 == 0 {
            let sum: u32 = hits.iter().map(|hit| hit.multiplicity).sum();
            assert!(sum.is_multiple_of(2), "{} {k}: {line:?} {hits:?}", shape.name);
        }
    }
}

#[test]
fn more_shapes() {
    for shape in &shapes()[4..] {
        compare(shape, 150);
    }
}

#[test]
#[ignore = "minutes: brute force"]
fn exhaustive_lines_by_force() {
    for shape in &shapes() {
        compare(shape, 10_000);
    }
}

/// Lines of all kinds in all directions; some through nodes.
fn lines(grid: &Grid<'_>, count: usize) -> Vec<Line> {
    let mut random = Random(5);
    let [h, w] = grid.cells();
    (0..count)
        .map(|k| {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let node = grid.nodes().get((k * 7) % (h + 1), (k * 13) % (w + 1));
            match k % 4 {
                0 => Line::new(a, b - a),
                1 => Line::ray(a, b - a),
                2 => Line::segment(a, b),
                _ => Line::new(a, node - a),
            }
        })
        .collect()
}

#[test]
fn batches_are_single_lines() {
    for shape in &shapes() {
        let grid = grid(shape);
        let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let lines = lines(&grid, 1200);
        for which in [HitSelection::All, HitSelection::First, HitSelection::Any] {
            let one = surface.lines(&lines, which, &Job::new(1, &Silent)).unwrap();
            for threads in [2, 5] {
                assert_eq!(surface.lines(&lines, which, &Job::new(threads, &Silent)).unwrap(), one);
            }
            for (k, line) in lines.iter().enumerate() {
                assert_eq!(surface.line(line, which).unwrap(), one.hits_of(k), "{} {line:?}", shape.name);
            }
        }
        let all = surface.lines(&lines, HitSelection::All, &Job::default()).unwrap();
        let first = surface.first_hits(&lines, &Job::default()).unwrap();
        for k in 0..lines.len() {
            assert_eq!(all.hits_of(k).first().copied(), first[k], "{} {:?}", shape.name, lines[k]);
            for hit in all.hits_of(k) {
                assert_eq!(hit.normal, surface.normal(hit.place));
                assert!((hit.normal.length() - 1.0).abs() < 1e-12, "{hit:?}");
            }
        }
    }
}

#[test]
fn through_any_node_once() {
    for shape in &shapes() {
        let grid = grid(shape);
        let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let [h, w] = grid.cells();
        let mut random = Random(8);
        for k in 0..300 {
            let node = grid.nodes().get((k * 5) % (h + 1), (k * 11) % (w + 1));
            let direction = random.point(1.0);
            let line = Line::new(node, direction);
            let hits = surface.line(&line, HitSelection::All).unwrap();
            let here: Vec<_> = hits.iter().filter(|hit| hit.point.distance(node) < 1e-7).collect();
            assert_eq!(here.len(), 1, "{} {k}: {line:?}: {hits:?}", shape.name);
            let normal = here[0].normal;
            if normal.dot(direction.normalize()).abs() > 0.05 {
                assert_eq!((here[0].multiplicity, here[0].tangent), (1, false), "{} {k}: {hits:?}", shape.name);
            }
            if shape.closed == [true, true] || shape.name == "egg" {
                let sum: u32 = hits.iter().map(|hit| hit.multiplicity).sum();
                assert!(sum.is_multiple_of(2), "{} {k}: {line:?} {hits:?}", shape.name);
            }
        }
    }
}

#[test]
fn sheets_that_share_sides_are_one_surface() {
    // The torus cut in two along rows: lines through nodes of the common rows.
    let grid = grid(&SHAPES[0]);
    let [h, w] = grid.cells();
    let part = |rows: std::ops::Range<usize>| {
        let mut points = Vec::new();
        for (i, j) in rows.clone().flat_map(|i| (0..w).map(move |j| (i, j))) {
            points.extend_from_slice(grid.patch(i, j).points.as_flattened());
        }
        Sheet::Cubic(Patches::<4>::new(&points, [3, 3], rows.len(), w).unwrap())
    };
    let two = Surface::new(vec![part(0..7), part(7..h)], None, &Job::default()).unwrap();
    let whole = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
    let mut random = Random(2);
    for k in 0..200 {
        let node = grid.nodes().get(if k % 2 == 0 { 7 } else { 0 }, k % w);
        let line = Line::new(node, random.point(1.0));
        let (a, b) = (two.line(&line, HitSelection::All).unwrap(), whole.line(&line, HitSelection::All).unwrap());
        assert_eq!(a.len(), b.len(), "{k}: {a:?} {b:?}");
        assert!(a.iter().zip(&b).all(|(a, b)| (a.at - b.at).abs() < 1e-9 && a.multiplicity == b.multiplicity));
    }
}

#[test]
fn touching_and_running_inside() {
    let grid_of = |cells, closed, point| grid(&Shape { name: "", cells, closed, point });
    // At a node of the outer equator, along its tangent.
    let torus = grid(&SHAPES[0]);
    let surface = Surface::new(vec![Sheet::Grid(torus.clone())], None, &Job::default()).unwrap();
    for j in [0, 5, 11] {
        let place = gusset::surface::Place { sheet: 0, cell: [0, j], u: 0.0, v: 0.0 };
        let jet = surface.jet(place);
        for along in [jet.v, jet.u + 0.3 * jet.v, jet.u] {
            let line = Line::new(jet.point, along);
            let hits = surface.line(&line, HitSelection::All).unwrap();
            let here: Vec<_> = hits.iter().filter(|hit| hit.point.distance(jet.point) < 1e-3).collect();
            assert_eq!(here.len(), 1, "{j} {along}: {hits:?}");
            assert_eq!((here[0].multiplicity, here[0].tangent), (2, true), "{hits:?}");
            assert!(here[0].point.distance(jet.point) < 1e-4 && here[0].span[0] <= 0.0 && here[0].span[1] >= 0.0);
            assert_eq!(surface.line(&line, HitSelection::First).unwrap()[0], hits[0]);
        }
    }
    // In a plane: in the middle of cells, along their sides, and across.
    let plane = |u: f64, v: f64| DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
    let surface = Surface::new(vec![Sheet::Grid(grid_of([12, 17], [false; 2], plane))], None, &Job::default()).unwrap();
    for (a, b, from, to) in [
        (DVec3::new(-2.0, 0.03, 0.0), DVec3::new(2.0, 0.03, 0.0), 0.25, 0.75),
        (DVec3::new(-2.0, -1.0, 0.0), DVec3::new(2.0, -1.0, 0.0), 0.25, 0.75),
        (DVec3::new(-2.0, -2.0, 0.0), DVec3::new(2.0, 2.0, 0.0), 0.25, 0.75),
        (DVec3::new(-0.3, 0.1, 0.0), DVec3::new(0.3, 0.2, 0.0), 0.0, 1.0),
    ] {
        let hits = surface.line(&Line::segment(a, b), HitSelection::All).unwrap();
        assert_eq!(hits.len(), 1, "{a} {b}: {hits:?}");
        assert_eq!((hits[0].multiplicity, hits[0].tangent), (0, true));
        let [start, end] = hits[0].span;
        assert!((start - from).abs() < 0.01 && (end - to).abs() < 0.01, "{a} {b}: {hits:?}");
        assert_eq!(surface.line(&Line::segment(a, b), HitSelection::First).unwrap(), hits);
    }
    // In the same plane, past the sheet.
    let past = Line::new(DVec3::new(-2.0, 0.5, 0.0), DVec3::new(1.0, 1.0, 0.0));
    assert!(surface.line(&past, HitSelection::All).unwrap().is_empty());
    // Rulings of a cylinder.
    let cylinder = |u: f64, v: f64| {
        let turn = std::f64::consts::TAU * v;
        DVec3::new(turn.cos(), turn.sin(), 2.0 * u - 1.0)
    };
    let pipe = grid_of([9, 40], [false, true], cylinder);
    let surface = Surface::new(vec![Sheet::Grid(pipe.clone())], None, &Job::default()).unwrap();
    for (j, v) in [(0, 0.0), (3, 0.5), (39, 0.25)] {
        let foot = pipe.patch(4, j).point(0.5, v);
        let hits = surface.line(&Line::new(foot, DVec3::Z), HitSelection::All).unwrap();
        assert_eq!(hits.len(), 1, "{j}: {hits:?}");
        let span = hits[0].span;
        assert!(hits[0].multiplicity == 0 && (span[0] + 1.0).abs() < 0.02 && (span[1] - 1.0).abs() < 0.02, "{hits:?}");
    }
}

#[test]
fn any_size_and_anywhere() {
    let shape = &SHAPES[1];
    let plain = grid(shape);
    let surface = Surface::new(vec![Sheet::Grid(plain.clone())], None, &Job::default()).unwrap();
    for (scale, shift) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)] {
        let moved = |p: DVec3| scale * p + DVec3::new(shift, -0.5 * shift, 0.25 * shift);
        let [h, w] = plain.cells();
        let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j)));
        let data: Vec<f64> = nodes.flat_map(|(i, j)| moved(plain.nodes().get(i, j)).to_array()).collect();
        let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
        let other = Grid::new(nodes, shape.closed, Scheme::SixTap).unwrap();
        let other = Surface::new(vec![Sheet::Grid(other)], None, &Job::default()).unwrap();
        let mut random = Random(21);
        for k in 0..100 {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let hits = surface.line(&Line::new(a, b - a), HitSelection::All).unwrap();
            let same = other.line(&Line::new(moved(a), scale * (b - a)), HitSelection::All).unwrap();
            assert_eq!(hits.len(), same.len(), "{scale} {shift} {k}: {hits:?} {same:?}");
            let play = if shift == 0.0 { 1e-10 } else { 1e-6 };
            assert!(hits.iter().zip(&same).all(|(x, y)| (x.at - y.at).abs() < play), "{scale} {shift} {k}");
        }
    }
}

/// Parameters at which a line meets the torus: the roots of a quartic, by bisection between dense
/// samples.
fn torus_roots(line: &Line) -> Vec<f64> {
    let f = |t: f64| {
        let p = line.origin + t * line.direction;
        let ring = (p.x * p.x + p.y * p.y).sqrt() - 1.0;
        ring * ring + p.z * p.z - 0.16
    };
    let count = 4000_u32;
    let at = |k: usize| -4.0 + 8.0 * k as f64 / f64::from(count);
    let mut roots = Vec::new();
    for k in 0..count as usize {
        let (mut low, mut high) = (at(k), at(k + 1));
        if f(low) * f(high) < 0.0 {
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if f(low) * f(middle) <= 0.0 { high = middle } else { low = middle }
            }
            roots.push(low);
        }
    }
    roots
}

#[test]
fn fourth_order_on_a_torus() {
    let errors = [16, 32, 64].map(|n| {
        let shape = Shape { name: "torus", cells: [n, 2 * n], ..SHAPES[0] };
        let surface = Surface::new(vec![Sheet::Grid(grid(&shape))], None, &Job::default()).unwrap();
        let mut random = Random(4);
        let mut worst = 0.0_f64;
        for _ in 0..400 {
            let direction = random.point(1.0).normalize();
            let line = Line::new(random.point(1.0), direction);
            let hits = surface.line(&line, HitSelection::All).unwrap();
            // Not where it nearly touches: there the parameter is far off for little.
            if hits.iter().any(|hit| hit.normal.dot(direction).abs() < 0.3) {
                continue;
            }
            let truth = torus_roots(&line);
            assert_eq!(hits.len(), truth.len(), "{n} {line:?}");
            worst = hits.iter().zip(&truth).fold(worst, |worst, (hit, t)| worst.max((hit.at - t).abs()));
        }
        worst
    });
    let orders = [errors[0] / errors[1], errors[1] / errors[2]].map(f64::log2);
    println!("lines and a torus: errors {errors:?}, orders {orders:?}");
    assert!(orders[1] > 3.8 && errors[2] < 1e-6, "{errors:?} {orders:?}");
}

#[test]
fn directions_whose_squares_vanish_or_overflow() {
    let surface = Surface::new(vec![Sheet::Grid(grid(&SHAPES[0]))], None, &Job::default()).unwrap();
    let job = Job::default();
    let along = |length: f64| Line::ray(DVec3::new(-9.0, 0.1, 0.0), DVec3::new(length, 0.0, 0.0));
    for length in [1e-320, 1e-160, 1e160] {
        assert!(surface.line(&along(length), HitSelection::First).is_err(), "{length}");
        let lines = [along(1.0), along(length)];
        let refused = surface.first_hits(&lines, &job).unwrap_err();
        assert!(matches!(refused, Error::BadLine { line: 1, value, .. } if value == length), "{refused:?}");
    }
    for length in [1e-150, 1e150] {
        let hit = surface.line(&along(length), HitSelection::First).unwrap();
        assert!(hit[0].at.is_finite() && hit[0].at > 0.0, "{hit:?}");
    }
}
