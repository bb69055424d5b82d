//! Lines against many starts of Newton's method in every cell, and against parity.

mod surfaces;

use glam::{DMat3, DVec3};
use gusset::carcass::line::{Hit, Line, Which};
use gusset::carcass::{Carcass, Grid, Nodes, Patches, Place, Scheme, Sheet};
use gusset::outline::CurveView;
use gusset::{Error, Job};
use surfaces::{Random, SHAPES, Shape, grid};

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
        let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let mut random = Random(3);
        let mut total = 0;
        for k in 0..80 {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let line = match k % 3 {
                0 => Line::new(a, b - a),
                1 => Line::ray(a, b - a),
                _ => Line::segment(a, b),
            };
            let hits = carcass.line(&line, Which::All).unwrap();
            let truth = by_force(&grid, &line);
            let found: Vec<f64> = hits.iter().filter(|hit| !hit.tangent).map(|hit| hit.t).collect();
            assert_eq!(found.len(), truth.len(), "{} {k}: {line:?}: {hits:?} {truth:?}", shape.name);
            for ((t, expected), hit) in found.iter().zip(&truth).zip(&hits) {
                assert!((t - expected).abs() < 1e-9, "{} {k}: {found:?} {truth:?}", shape.name);
                assert_eq!(carcass.jet(hit.place).point, hit.point);
            }
            if shape.closed == [true, true] && k % 3 == 0 {
                assert!(hits.len().is_multiple_of(2), "{} {k}: {hits:?}", shape.name);
            }
            let first = carcass.line(&line, Which::First).unwrap();
            assert_eq!(first.first().map(|hit| hit.t), hits.first().map(|hit| hit.t));
            assert_eq!(carcass.line(&line, Which::Any).unwrap().is_empty(), hits.is_empty());
            total += hits.len();
        }
        assert!(total > 30, "{}: {total}", shape.name);
    }
}

#[test]
fn through_nodes_and_along_seams() {
    // A torus: lines through nodes and along the seam circle's plane.
    let shape = &SHAPES[0];
    let carcass = Carcass::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap();
    let line = Line::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X);
    let hits = carcass.line(&line, Which::All).unwrap();
    let expected = [1.6, 2.4, 3.6, 4.4];
    assert_eq!(hits.len(), 4, "{hits:?}");
    for (hit, t) in hits.iter().zip(expected) {
        assert!((hit.t - t).abs() < 2e-4, "{hits:?}");
    }
    // A line that touches the top of the ring.
    let top = carcass.jet(gusset::carcass::Place { sheet: 0, cell: [5, 0], u: 0.0, v: 0.0 }).point;
    let line = Line::new(DVec3::new(top.x, -3.0, top.z), DVec3::Y);
    let hits = carcass.line(&line, Which::All).unwrap();
    assert!(!hits.is_empty() && hits.len() <= 2, "{hits:?}");
}

#[test]
fn lines_that_are_none() {
    let carcass = Carcass::new(vec![Sheet::Grid(grid(&SHAPES[2]))], None, &Job::default()).unwrap();
    for line in [
        Line::new(DVec3::ZERO, DVec3::ZERO),
        Line::new(DVec3::splat(f64::NAN), DVec3::X),
        Line::new(DVec3::ZERO, DVec3::INFINITY),
        Line { from: 1.0, to: 0.0, ..Line::new(DVec3::ZERO, DVec3::X) },
    ] {
        assert!(carcass.line(&line, Which::All).is_err());
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
    let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
    let mut random = Random(11);
    for k in 0..count {
        let (a, b) = (random.point(1.5), random.point(1.2));
        let line = if k % 2 == 0 { Line::new(a, b - a) } else { Line::segment(a, b) };
        let hits = carcass.line(&line, Which::All).unwrap();
        let truth = by_force(&grid, &line);
        let found: Vec<f64> = hits.iter().filter(|hit| !hit.tangent).map(|hit| hit.t).collect();
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
        let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let lines = lines(&grid, 1200);
        for which in [Which::All, Which::First, Which::Any] {
            let one = carcass.lines(&lines, which, &Job::new(1, &Quiet)).unwrap();
            for threads in [2, 5] {
                assert_eq!(carcass.lines(&lines, which, &Job::new(threads, &Quiet)).unwrap(), one);
            }
            for (k, line) in lines.iter().enumerate() {
                assert_eq!(carcass.line(line, which).unwrap(), one.hits_of(k), "{} {line:?}", shape.name);
            }
        }
        let all = carcass.lines(&lines, Which::All, &Job::default()).unwrap();
        let first = carcass.first_hits(&lines, &Job::default()).unwrap();
        for k in 0..lines.len() {
            assert_eq!(all.hits_of(k).first().copied(), first[k], "{} {:?}", shape.name, lines[k]);
            for hit in all.hits_of(k) {
                assert_eq!(hit.normal, carcass.normal(hit.place));
                assert!((hit.normal.length() - 1.0).abs() < 1e-12, "{hit:?}");
            }
        }
    }
}

struct Quiet;

impl gusset::Progress for Quiet {
    fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
        std::ops::ControlFlow::Continue(())
    }
}

#[test]
fn through_any_node_once() {
    for shape in &shapes() {
        let grid = grid(shape);
        let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let [h, w] = grid.cells();
        let mut random = Random(8);
        for k in 0..300 {
            let node = grid.nodes().get((k * 5) % (h + 1), (k * 11) % (w + 1));
            let direction = random.point(1.0);
            let line = Line::new(node, direction);
            let hits = carcass.line(&line, Which::All).unwrap();
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
    let two = Carcass::new(vec![part(0..7), part(7..h)], None, &Job::default()).unwrap();
    let whole = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
    let mut random = Random(2);
    for k in 0..200 {
        let node = grid.nodes().get(if k % 2 == 0 { 7 } else { 0 }, k % w);
        let line = Line::new(node, random.point(1.0));
        let (a, b) = (two.line(&line, Which::All).unwrap(), whole.line(&line, Which::All).unwrap());
        assert_eq!(a.len(), b.len(), "{k}: {a:?} {b:?}");
        assert!(a.iter().zip(&b).all(|(a, b)| (a.t - b.t).abs() < 1e-9 && a.multiplicity == b.multiplicity));
    }
}

#[test]
fn touching_and_running_inside() {
    let grid_of = |cells, closed, point| grid(&Shape { name: "", cells, closed, point });
    // At a node of the outer equator, along its tangent.
    let torus = grid(&SHAPES[0]);
    let carcass = Carcass::new(vec![Sheet::Grid(torus.clone())], None, &Job::default()).unwrap();
    for j in [0, 5, 11] {
        let place = gusset::carcass::Place { sheet: 0, cell: [0, j], u: 0.0, v: 0.0 };
        let jet = carcass.jet(place);
        for along in [jet.v, jet.u + 0.3 * jet.v, jet.u] {
            let line = Line::new(jet.point, along);
            let hits = carcass.line(&line, Which::All).unwrap();
            let here: Vec<_> = hits.iter().filter(|hit| hit.point.distance(jet.point) < 1e-3).collect();
            assert_eq!(here.len(), 1, "{j} {along}: {hits:?}");
            assert_eq!((here[0].multiplicity, here[0].tangent), (2, true), "{hits:?}");
            assert!(here[0].point.distance(jet.point) < 1e-4 && here[0].span[0] <= 0.0 && here[0].span[1] >= 0.0);
            assert_eq!(carcass.line(&line, Which::First).unwrap()[0], hits[0]);
        }
    }
    // In a plane: in the middle of cells, along their sides, and across.
    let plane = |u: f64, v: f64| DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
    let carcass = Carcass::new(vec![Sheet::Grid(grid_of([12, 17], [false; 2], plane))], None, &Job::default()).unwrap();
    for (a, b, from, to) in [
        (DVec3::new(-2.0, 0.03, 0.0), DVec3::new(2.0, 0.03, 0.0), 0.25, 0.75),
        (DVec3::new(-2.0, -1.0, 0.0), DVec3::new(2.0, -1.0, 0.0), 0.25, 0.75),
        (DVec3::new(-2.0, -2.0, 0.0), DVec3::new(2.0, 2.0, 0.0), 0.25, 0.75),
        (DVec3::new(-0.3, 0.1, 0.0), DVec3::new(0.3, 0.2, 0.0), 0.0, 1.0),
    ] {
        let hits = carcass.line(&Line::segment(a, b), Which::All).unwrap();
        assert_eq!(hits.len(), 1, "{a} {b}: {hits:?}");
        assert_eq!((hits[0].multiplicity, hits[0].tangent), (0, true));
        let [start, end] = hits[0].span;
        assert!((start - from).abs() < 0.01 && (end - to).abs() < 0.01, "{a} {b}: {hits:?}");
        assert_eq!(carcass.line(&Line::segment(a, b), Which::First).unwrap(), hits);
    }
    // In the same plane, past the sheet.
    let past = Line::new(DVec3::new(-2.0, 0.5, 0.0), DVec3::new(1.0, 1.0, 0.0));
    assert!(carcass.line(&past, Which::All).unwrap().is_empty());
    // Rulings of a cylinder.
    let cylinder = |u: f64, v: f64| {
        let turn = std::f64::consts::TAU * v;
        DVec3::new(turn.cos(), turn.sin(), 2.0 * u - 1.0)
    };
    let pipe = grid_of([9, 40], [false, true], cylinder);
    let carcass = Carcass::new(vec![Sheet::Grid(pipe.clone())], None, &Job::default()).unwrap();
    for (j, v) in [(0, 0.0), (3, 0.5), (39, 0.25)] {
        let foot = pipe.patch(4, j).point(0.5, v);
        let hits = carcass.line(&Line::new(foot, DVec3::Z), Which::All).unwrap();
        assert_eq!(hits.len(), 1, "{j}: {hits:?}");
        let span = hits[0].span;
        assert!(hits[0].multiplicity == 0 && (span[0] + 1.0).abs() < 0.02 && (span[1] - 1.0).abs() < 0.02, "{hits:?}");
    }
}

#[test]
fn any_size_and_anywhere() {
    let shape = &SHAPES[1];
    let plain = grid(shape);
    let carcass = Carcass::new(vec![Sheet::Grid(plain.clone())], None, &Job::default()).unwrap();
    for (scale, shift) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)] {
        let moved = |p: DVec3| scale * p + DVec3::new(shift, -0.5 * shift, 0.25 * shift);
        let [h, w] = plain.cells();
        let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j)));
        let data: Vec<f64> = nodes.flat_map(|(i, j)| moved(plain.nodes().get(i, j)).to_array()).collect();
        let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
        let other = Grid::new(nodes, shape.closed, Scheme::SixTap).unwrap();
        let other = Carcass::new(vec![Sheet::Grid(other)], None, &Job::default()).unwrap();
        let mut random = Random(21);
        for k in 0..100 {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let hits = carcass.line(&Line::new(a, b - a), Which::All).unwrap();
            let same = other.line(&Line::new(moved(a), scale * (b - a)), Which::All).unwrap();
            assert_eq!(hits.len(), same.len(), "{scale} {shift} {k}: {hits:?} {same:?}");
            let play = if shift == 0.0 { 1e-10 } else { 1e-6 };
            assert!(hits.iter().zip(&same).all(|(x, y)| (x.t - y.t).abs() < play), "{scale} {shift} {k}");
        }
    }
}

/// Parameters at which a line meets the torus: the roots of a quartic, by bisection between dense samples.
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
        let carcass = Carcass::new(vec![Sheet::Grid(grid(&shape))], None, &Job::default()).unwrap();
        let mut random = Random(4);
        let mut worst = 0.0_f64;
        for _ in 0..400 {
            let direction = random.point(1.0).normalize();
            let line = Line::new(random.point(1.0), direction);
            let hits = carcass.line(&line, Which::All).unwrap();
            // Not where it nearly touches: there the parameter is far off for little.
            if hits.iter().any(|hit| hit.normal.dot(direction).abs() < 0.3) {
                continue;
            }
            let truth = torus_roots(&line);
            assert_eq!(hits.len(), truth.len(), "{n} {line:?}");
            worst = hits.iter().zip(&truth).fold(worst, |worst, (hit, t)| worst.max((hit.t - t).abs()));
        }
        worst
    });
    let orders = [errors[0] / errors[1], errors[1] / errors[2]].map(f64::log2);
    println!("lines and a torus: errors {errors:?}, orders {orders:?}");
    assert!(orders[1] > 3.8 && errors[2] < 1e-6, "{errors:?} {orders:?}");
}

#[test]
fn directions_whose_squares_vanish_or_overflow() {
    let surface = Carcass::new(vec![Sheet::Grid(grid(&SHAPES[0]))], None, &Job::default()).unwrap();
    let job = Job::default();
    let along = |length: f64| Line::ray(DVec3::new(-9.0, 0.1, 0.0), DVec3::new(length, 0.0, 0.0));
    for length in [1e-320, 1e-160, 1e160] {
        assert!(surface.line(&along(length), Which::First).is_err(), "{length}");
        let lines = [along(1.0), along(length)];
        let refused = surface.first_hits(&lines, &job).unwrap_err();
        assert!(matches!(refused, Error::BadLine { line: 1, value } if value == length), "{refused:?}");
    }
    for length in [1e-150, 1e150] {
        let hit = surface.line(&along(length), Which::First).unwrap();
        assert!(hit[0].t.is_finite() && hit[0].t > 0.0, "{hit:?}");
    }
}

/// A sheet through points, closed lines of which are repeated to the bit.
fn sheet_of(
    [h, w]: [usize; 2],
    closed: [bool; 2],
    scheme: Scheme,
    point: impl Fn(f64, f64) -> DVec3,
) -> Carcass<'static> {
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j)));
    let data: Vec<f64> = nodes.flat_map(|(i, j)| point(at(i, h, closed[0]), at(j, w, closed[1])).to_array()).collect();
    let grid = Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap();
    Carcass::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap()
}

fn multiplicities(hits: &[Hit]) -> u32 {
    hits.iter().map(|hit| hit.multiplicity).sum()
}

/// A line through a node, or through any point of a line of nodes.
fn through_a_node_or_side(carcass: &Carcass<'_>, random: &mut Random, k: usize) -> Line {
    let [h, w] = carcass.sheet(0).cells();
    let cell = [(random.next() * h as f64) as u32, (random.next() * w as f64) as u32];
    let v = if k.is_multiple_of(2) { 0.0 } else { random.next() };
    let point = carcass.jet(Place { sheet: 0, cell, u: 0.0, v }).point;
    let direction = random.point(1.0);
    Line::new(point - direction, direction)
}

#[test]
fn poles_have_normals_and_count_by_their_cells() {
    // Rows at the poles are one point each. The surface is not quite smooth there: some lines touch the tip.
    let sphere = sheet_of([10, 20], [false, true], Scheme::SixTap, |u, v| {
        let (polar, turn) = (std::f64::consts::PI * u, std::f64::consts::TAU * v);
        let ring = if u == 0.0 || u == 1.0 { 0.0 } else { polar.sin() };
        DVec3::new(ring * turn.cos(), ring * turn.sin(), polar.cos())
    });
    let mut random = Random(1);
    let mut lines: Vec<Line> = (0..1000)
        .map(|k| {
            let (pole, direction) = (DVec3::new(0.0, 0.0, if k % 2 == 0 { 1.0 } else { -1.0 }), random.point(1.0));
            Line::new(pole - direction, direction)
        })
        .collect();
    lines.push(Line::new(DVec3::new(0.0, 0.0, 3.0), DVec3::Z));
    lines.push(Line::new(DVec3::new(0.0, 2.6313462855769325, 1.0), DVec3::Y));
    let mut touches = 0;
    for line in &lines {
        let hits = sphere.line(line, Which::All).unwrap();
        let here: Vec<_> = hits.iter().filter(|hit| (hit.point.z.abs() - 1.0).abs() < 1e-12).collect();
        assert!(!here.is_empty(), "{line:?}");
        for hit in here {
            assert!(hit.normal.dot(hit.point).abs() > 0.999, "{line:?} {hit:?}");
            assert_eq!(hit.normal, sphere.normal(hit.place));
            touches += u32::from(hit.tangent);
            let found = sphere.closest(hit.point, f64::INFINITY).unwrap();
            assert!(found.normal.dot(hit.point).abs() > 0.999, "{found:?}");
        }
        assert!(multiplicities(&hits).is_multiple_of(2), "{line:?} {hits:?}");
    }
    assert!(touches < 20, "{touches}");
    assert!(sphere.line(&lines[1001], Which::All).unwrap()[1].tangent);
}

#[test]
fn one_crossing_is_one_hit_far_from_the_origin() {
    for (far, count) in [(1e5, 1500), (1e6, 500), (1e7, 500)] {
        let shift = far * DVec3::new(1.0, -2.0, 0.5);
        let torus = sheet_of([20, 37], [true, true], Scheme::SixTap, |u, v| (SHAPES[0].point)(u, v) + shift);
        let mut random = Random(2);
        let mut lines: Vec<Line> = (0..count).map(|k| through_a_node_or_side(&torus, &mut random, k)).collect();
        if far == 1e5 {
            lines.push(Line::new(
                DVec3::new(99999.86540072673, -199998.63329539832, 50000.399954971566),
                DVec3::new(-0.4379682910236875, -0.5468478601505982, 4.502843727727246e-5),
            ));
        }
        for line in &lines {
            let hits = torus.line(line, Which::All).unwrap();
            let in_doubt = hits.iter().any(|hit| hit.tangent);
            assert!(in_doubt || multiplicities(&hits).is_multiple_of(2), "{far} {line:?} {hits:?}");
        }
        let in_doubt = |line: &&Line| torus.line(line, Which::All).unwrap().iter().any(|hit| hit.tangent);
        assert!(lines.iter().filter(in_doubt).count() <= 2);
    }
}

#[test]
fn creases_are_touched_or_passed() {
    let bumpy = sheet_of([31, 53], [true, true], Scheme::FourPoint, SHAPES[1].point);
    let rough = surfaces::rough([12, 17], [true, true], Scheme::FourPoint, 5);
    let rough = Carcass::new(vec![Sheet::Grid(rough)], None, &Job::default()).unwrap();
    for carcass in [&bumpy, &rough] {
        let mut random = Random(2);
        let mut touches = 0;
        for k in 0..1500 {
            let line = through_a_node_or_side(carcass, &mut random, k);
            let hits = carcass.line(&line, Which::All).unwrap();
            assert!(multiplicities(&hits).is_multiple_of(2), "{line:?} {hits:?}");
            let touch = hits.iter().find(|hit| hit.tangent);
            touches += u32::from(touch.is_some());
            assert!(touch.is_none_or(|hit| hit.multiplicity == 2), "{hits:?}");
            assert_eq!(carcass.line(&line, Which::First).unwrap().first(), hits.first());
            // As a curve of one segment, straight and raised.
            if k % 10 == 0 || touch.is_some() {
                let [a, b] = [-10.0, 10.0].map(|t| line.origin + t * line.direction);
                let cubic: Vec<DVec3> = (0..4).map(|k| a.lerp(b, f64::from(k) / 3.0)).collect();
                for points in [vec![a, b], cubic] {
                    let starts = [0, points.len() as u32 - 1];
                    let curve = CurveView::new(&points, &starts, false).unwrap();
                    let found = carcass.curve(&curve, Which::All, &Job::default()).unwrap();
                    assert!(
                        found.iter().map(|hit| hit.multiplicity).sum::<u32>().is_multiple_of(2),
                        "{line:?} {found:?}"
                    );
                }
            }
        }
        assert!(touches > 10, "{touches}");
    }
    let line = Line::new(DVec3::new(0.9826822705510558, 8.016941675008606, -0.34147652693884484), DVec3::Y);
    let hits = bumpy.line(&line, Which::All).unwrap();
    assert_eq!(
        hits.iter().map(|hit| (hit.multiplicity, hit.tangent)).collect::<Vec<_>>(),
        [(1, false), (2, true), (1, false)]
    );
}

#[test]
fn what_is_simple_is_on_the_line() {
    // Cells of sizes from 1e-8 to 1, and of 1e4 to 1.
    let far = |t: f64| 10_f64.powf(-8.0 + 8.0 * t);
    let uneven = sheet_of([20, 20], [false; 2], Scheme::SixTap, |u, v| {
        let (x, y) = (far(u), far(v));
        DVec3::new(x, y, 0.1 * (3.0 * x).sin() * (2.0 * y).cos())
    });
    let long = sheet_of([30, 30], [false; 2], Scheme::SixTap, |u, v| {
        DVec3::new(3e5 * u, 30.0 * v, (21.0 * u).sin() + 0.1 * (30.0 * v).cos())
    });
    let bumpy = sheet_of([31, 53], [true, true], Scheme::SixTap, SHAPES[1].point);
    for carcass in [&uneven, &long, &bumpy] {
        let [low, high] = carcass.bounds();
        let size = low.distance(high);
        let [h, w] = carcass.sheet(0).cells();
        let mut random = Random(3);
        for _ in 0..1500 {
            let cell = [(random.next() * h as f64) as u32, (random.next() * w as f64) as u32];
            let v = if random.next() < 0.5 { 0.0 } else { random.next() };
            let jet = carcass.jet(Place { sheet: 0, cell, u: 0.0, v });
            // Along the surface, nearly.
            let direction = size * (random.next() * jet.u + random.next() * jet.v).normalize();
            let line = Line::new(jet.point - direction, direction);
            for hit in carcass.line(&line, Which::All).unwrap() {
                assert!(hit.span[0] <= hit.t && hit.t <= hit.span[1], "{line:?} {hit:?}");
                let miss = (hit.point - line.origin).cross(direction.normalize()).length();
                assert!(hit.tangent || miss <= 1.01 * carcass.tolerance(), "{line:?} {hit:?}: {miss}");
            }
        }
    }
}

#[test]
fn creases_between_sheets() {
    // The keel of a hull of two sides: touched across the ship, passed from above.
    let sides = surfaces::wigley_hull().map(Sheet::Grid);
    let hull = Carcass::new(sides.into(), None, &Job::default()).unwrap();
    for j in [3, 11, 20, 29] {
        let keel = hull.jet(Place { sheet: 0, cell: [j, 0], u: 0.3, v: 0.0 }).point;
        for (direction, expected) in [(DVec3::Y, (2, true)), (DVec3::new(0.1, 0.0, 1.0), (1, false))] {
            let hits = hull.line(&Line::new(keel - direction, direction), Which::All).unwrap();
            let here: Vec<_> = hits.iter().filter(|hit| hit.point.distance(keel) < 1e-9).collect();
            assert_eq!(here.len(), 1, "{hits:?}");
            assert_eq!((here[0].multiplicity, here[0].tangent), expected, "{hits:?}");
        }
    }
}
