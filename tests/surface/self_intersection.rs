//! Where one surface meets itself: against equations. Against triangles: `self_intersection_sampled`.

use crate::common::{Silent, some_of};
use crate::pairs::{ball, flat, grid, length, one, ring, summary};
use crate::shapes::{Random, SHAPES, Shape, torus};
use glam::DVec3;
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Grid, Nodes, Patches, Paths, Place, Scheme, Sheet, Surface};
use std::f64::consts::{PI, TAU};

/// The paths, after what holds for all results: one point on both pieces, at different parameters.
pub(crate) fn meet(surface: &Surface<'_>) -> Paths {
    let paths = surface.meet_itself(&Options::default(), &Job::new(1, &Silent)).unwrap();
    check(&paths, surface);
    paths
}

fn check(paths: &Paths, surface: &Surface<'_>) {
    let count = paths.points.len();
    assert!(paths.places.len() == count && paths.others.len() == count && paths.normals.len() == count);
    assert!(paths.ends.len() == paths.len() + 1 && paths.levels.len() == paths.len());
    let size = surface.bounds()[0].abs().max(surface.bounds()[1].abs()).max_element();
    for (k, &point) in paths.points.iter().enumerate() {
        assert_eq!(surface.jet(paths.places[k]).point, point);
        let miss = surface.jet(paths.others[k]).point.distance(point);
        assert!(miss <= 1e-11 * size, "{k}: {miss}");
        assert_ne!(paths.places[k], paths.others[k]);
    }
}

fn solid(shape: &Shape) -> Surface<'static> {
    one(Sheet::Grid(grid(shape, Scheme::SixTap, |p| p)))
}

/// The Bernstein coefficients of a polynomial of degree `n` on 0 to 1 by its values at k / n.
fn bernstein(values: &[DVec3]) -> Vec<DVec3> {
    let n = values.len() - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |x, i| x * (n - i) as f64 / (i + 1) as f64);
    let mut rows: Vec<(Vec<f64>, DVec3)> = (0..=n)
        .map(|i| {
            let t = i as f64 / n as f64;
            let row = (0..=n).map(|k| binomial(n, k) * t.powi(k as i32) * (1.0 - t).powi((n - k) as i32)).collect();
            (row, values[i])
        })
        .collect();
    for k in 0..=n {
        let best = (k..=n).max_by(|&i, &j| rows[i].0[k].abs().total_cmp(&rows[j].0[k].abs())).unwrap();
        rows.swap(k, best);
        let (own, value) = rows[k].clone();
        for i in (0..=n).filter(|&i| i != k) {
            let factor = rows[i].0[k] / own[k];
            (0..=n).for_each(|m| rows[i].0[m] -= factor * own[m]);
            rows[i].1 -= factor * value;
        }
    }
    (0..=n).map(|k| rows[k].1 / rows[k].0[k]).collect()
}

/// A polynomial over a rectangle, as patches.
fn polynomial(
    f: impl Fn(f64, f64) -> DVec3,
    degree: usize,
    cells: [usize; 2],
    [[u0, u1], [v0, v1]]: [[f64; 2]; 2],
) -> Surface<'static> {
    let mut points = Vec::new();
    for (i, j) in (0..cells[0]).flat_map(|i| (0..cells[1]).map(move |j| (i, j))) {
        let at = |i: usize, k: usize, n: usize| (i as f64 + k as f64 / degree as f64) / n as f64;
        let rows: Vec<Vec<DVec3>> = (0..=degree)
            .map(|a| {
                let u = u0 + (u1 - u0) * at(i, a, cells[0]);
                let row: Vec<_> = (0..=degree).map(|b| f(u, v0 + (v1 - v0) * at(j, b, cells[1]))).collect();
                bernstein(&row)
            })
            .collect();
        let columns: Vec<Vec<DVec3>> =
            (0..=degree).map(|b| bernstein(&rows.iter().map(|row| row[b]).collect::<Vec<_>>())).collect();
        points.extend((0..=degree).flat_map(|a| columns.iter().map(move |column| column[a]).collect::<Vec<_>>()));
    }
    one(Sheet::Cubic(Patches::new(&points, [degree; 2], cells[0], cells[1]).unwrap()))
}

#[test]
fn a_cylinder_over_a_figure_of_eight_has_one_line() {
    for (cells, shift) in [([4, 36], 0.0), ([4, 36], 0.3), ([1, 7], 0.1), ([5, 37], 0.0), ([3, 12], 0.5)] {
        let point = move |u: f64, v: f64| {
            let t = TAU * (v + shift / cells[1] as f64);
            DVec3::new(t.sin(), t.sin() * t.cos(), u)
        };
        let surface = lattice(cells, [false, true], point);
        let paths = meet(&surface);
        println!("eight {cells:?} {shift}: {} {:?}", summary(&paths), paths.unresolved);
        assert!(paths.len() == 1 && !paths.closed[0] && paths.unresolved.is_empty(), "{cells:?}: {}", summary(&paths));
        let points = paths.points_of(0);
        let far = points.iter().map(|p| p.truncate().length()).fold(0.0, f64::max);
        assert!((length(&paths) - 1.0).abs() < 1e-9 && far < if cells[1] > 30 { 1e-3 } else { 0.2 }, "{far}");
        let straight = points.iter().map(|p| (p - points[0]).truncate().length()).fold(0.0, f64::max);
        assert!(straight < 1e-9, "{straight}");
    }
}

/// A grid of the values of a function.
pub(crate) fn lattice([h, w]: [usize; 2], closed: [bool; 2], point: impl Fn(f64, f64) -> DVec3) -> Surface<'static> {
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let data: Vec<f64> = (0..=h)
        .flat_map(|i| (0..=w).map(move |j| (i, j)))
        .flat_map(|(i, j)| point(at(i, h, closed[0]), at(j, w, closed[1])).to_array())
        .collect();
    let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
    one(Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap).unwrap()))
}

#[test]
fn whitneys_umbrella_ends_in_a_pinch() {
    let umbrella = |u: f64, v: f64| DVec3::new(u * v, u, v * v);
    for cells in [[1, 1], [2, 2], [3, 3], [4, 5]] {
        for from in [-1.0, -1.25] {
            let surface = polynomial(umbrella, 2, cells, [[from, 1.0], [from, 1.0]]);
            let paths = meet(&surface);
            println!("umbrella {cells:?} {from}: {}", summary(&paths));
            assert!(paths.len() == 1 && !paths.closed[0], "{cells:?} {from}: {}", summary(&paths));
            let points = paths.points_of(0);
            let far = points.iter().map(|p| p.truncate().length()).fold(0.0, f64::max);
            let [low, high] = [points[0].z, points[points.len() - 1].z];
            let (low, high) = (low.min(high), low.max(high));
            assert!(far < 1e-9 && (high - 1.0).abs() < 1e-9, "{far} {low} {high}");
            assert!((length(&paths) - (high - low)).abs() < 1e-9);
            assert!((0.0..=4.0 * surface.tolerance()).contains(&low), "{low} {}", surface.tolerance());
            assert!((1..=4).contains(&paths.unresolved.len()));
            // As near to the pinch the two pieces are within the tolerance of each other.
            let near = 4.0 * surface.tolerance().sqrt();
            assert!(paths.unresolved.iter().all(|&place| surface.jet(place).point.length() < near));
        }
    }
}

#[test]
fn enneper() {
    let point =
        |u: f64, v: f64| DVec3::new(u - u * u * u / 3.0 + u * v * v, v - v * v * v / 3.0 + v * u * u, u * u - v * v);
    for cells in [[1, 1], [4, 4], [5, 7]] {
        let surface = polynomial(point, 3, cells, [[-2.0, 2.0]; 2]);
        let paths = meet(&surface);
        println!("enneper {cells:?}: {}", summary(&paths));
        assert!(paths.len() == 2 && paths.unresolved.is_empty(), "{cells:?} {}", summary(&paths));
        // x = 0, u^2 = 3 + 3 v^2, and the same turned.
        let last = (1.0_f64 / 3.0).sqrt();
        for k in 0..2 {
            let points = paths.points_of(k);
            for p in points {
                let (across, along, z) = if p.x.abs() < 1e-9 { (p.x, p.y, p.z) } else { (p.y, p.x, -p.z) };
                let v = ((z - 3.0) / 2.0).max(0.0).sqrt();
                assert!(across.abs() < 1e-9, "{p}");
                assert!((along.abs() - (4.0 * v + 8.0 * v * v * v / 3.0)).abs() < 1e-6, "{p}");
            }
            let reach = 4.0 * last + 8.0 * last.powi(3) / 3.0;
            for end in [points[0], points[points.len() - 1]] {
                assert!((end.x.abs().max(end.y.abs()) - reach).abs() < 1e-9, "{end}");
            }
        }
    }
}

#[test]
fn a_figure_of_eight_turned_about_an_axis_has_a_circle() {
    for (cells, shift) in [([24, 36], 0.0), ([25, 36], 0.3), ([31, 53], 0.1)] {
        let surface = lattice(cells, [true, true], |u, v| {
            let (t, a) = (TAU * (u + shift / cells[0] as f64), TAU * v);
            let (r, z) = (2.0 + 0.7 * t.sin(), 0.7 * t.sin() * t.cos());
            DVec3::new(r * a.cos(), r * a.sin(), z)
        });
        let paths = meet(&surface);
        println!("circle {cells:?}: {}", summary(&paths));
        assert!(paths.len() == 1 && paths.closed[0] && paths.unresolved.is_empty(), "{}", summary(&paths));
        assert!((length(&paths) / (2.0 * TAU) - 1.0).abs() < 1e-3);
        assert!(paths.points.iter().all(|p| p.z.abs() < 1e-3 && (p.truncate().length() - 2.0).abs() < 2e-3));
    }
}

#[test]
fn bohemian_dome() {
    let surface = lattice([32, 37], [true, true], |u, v| {
        let (u, v) = (TAU * (u + 0.004), TAU * (v + 0.007));
        DVec3::new(0.5 * u.cos(), v.cos() + 0.5 * u.sin(), v.sin())
    });
    let paths = meet(&surface);
    println!("dome: {}", summary(&paths));
    // y = 0: two curves between two pinches each.
    assert!(paths.len() == 2 && paths.closed == [false, false], "{}", summary(&paths));
    for k in 0..2 {
        let points = paths.points_of(k);
        for p in points {
            let z = (1.0 - 0.25 * (1.0 - 4.0 * p.x * p.x)).sqrt();
            assert!(p.y.abs() < 1e-3 && (p.z.abs() - z).abs() < 2e-3, "{p}");
        }
        let ends = [points[0], points[points.len() - 1]];
        assert!((ends[0].x * ends[1].x + 0.25).abs() < 1e-4, "{ends:?}");
        for end in ends {
            let near = 4.0 * surface.tolerance().sqrt();
            let pinch = |place: &Place| surface.jet(*place).point.distance(end) < near;
            assert!(paths.unresolved.iter().any(pinch), "{end} {:?}", paths.unresolved);
        }
    }
}

fn klein(u: f64, v: f64) -> DVec3 {
    let (u, v) = (TAU * u, TAU * v);
    let (s, c) = (0.5 * u).sin_cos();
    let (x, z) = (c * v.sin() - s * (2.0 * v).sin(), s * v.sin() + c * (2.0 * v).sin());
    DVec3::new((3.0 + x) * u.cos(), (3.0 + x) * u.sin(), z)
}

#[test]
fn kleins_bottle_has_its_core() {
    for cells in [[40, 36], [41, 37]] {
        let surface = lattice(cells, [false, true], klein);
        let paths = meet(&surface);
        println!("klein {cells:?}: {}", summary(&paths));
        assert!(paths.len() == 1 && paths.closed[0] && paths.unresolved.is_empty(), "{}", summary(&paths));
        assert!((length(&paths) / (3.0 * TAU) - 1.0).abs() < 1e-3, "{}", length(&paths));
        assert!(paths.points.iter().all(|p| p.z.abs() < 1e-3 && (p.truncate().length() - 3.0).abs() < 1e-3));
    }
}

#[test]
fn a_bump_through_the_other_leaf_of_a_fold_has_a_loop() {
    // Leaves at z = 0 and z = 1/2, and a bump of the lower one that is 1/2 high along a circle.
    let surface = lattice([60, 30], [false, false], |u, v| {
        let y = 2.0 * v - 1.0;
        if u < 0.4 {
            let x = 1.0 - 5.0 * u;
            let r = (x * x + y * y).sqrt();
            DVec3::new(x, y, 1.2 * (-6.0 * r * r).exp())
        } else if u > 0.6 {
            DVec3::new(-1.0 + 5.0 * (u - 0.6), y, 0.5)
        } else {
            let t = PI * (u - 0.4) / 0.2;
            DVec3::new(-1.0 - 0.25 * t.sin(), y, 0.25 - 0.25 * t.cos())
        }
    });
    let paths = meet(&surface);
    println!("bump: {}", summary(&paths));
    let radius = ((1.2_f64 / 0.5).ln() / 6.0).sqrt();
    assert!(paths.len() == 1 && paths.closed[0] && paths.unresolved.is_empty(), "{}", summary(&paths));
    assert!(paths.points.iter().all(|p| (p.truncate().length() - radius).abs() < 2e-3));
    assert!((length(&paths) / (TAU * radius) - 1.0).abs() < 2e-3);
}

/// A circle turned about a line that cuts it. Its rows are one curve, scaled and lifted. The
/// surface through the nodes meets itself only where the factor is 0: in two points, each a whole
/// row of parameters. All cells of that row are unresolved, no others.
#[test]
fn a_spindle_torus_has_two_points() {
    for (cells, shift) in some_of(2, [([12, 6], 0.0), ([25, 7], 0.1)].into_iter()) {
        let surface = lattice(cells, [true, true], |u, v| {
            let (t, a) = (TAU * (u + shift / cells[0] as f64), TAU * v);
            let r = 0.5 + t.cos();
            DVec3::new(r * a.cos(), r * a.sin(), t.sin())
        });
        let paths = meet(&surface);
        println!("spindle {cells:?} {shift}: {} {}", summary(&paths), paths.unresolved.len());
        // Where the first column crosses the axis, by halving.
        let radius = |i: usize, u: f64| surface.jet(Place { sheet: 0, cell: [i as u32, 0], u, v: 0.0 }).point.x;
        let mut truth: Vec<u32> = Vec::new();
        for i in 0..cells[0] {
            let [low, high] = [0.0, 1.0].map(|u| radius(i, u));
            // A node on the axis is in the cells on both sides.
            if low.abs() < 1e-12 || high.abs() < 1e-12 || (low > 0.0) != (high > 0.0) {
                truth.extend((0..cells[1]).map(|_| i as u32));
            }
        }
        let rows: Vec<u32> = paths.unresolved.iter().map(|place| place.cell[0]).collect();
        assert_eq!(rows, truth, "{cells:?} {shift}");
        assert!(paths.is_empty(), "{}", summary(&paths));
        for &place in &paths.unresolved {
            let off = surface.jet(place).point.truncate().length();
            assert!(off < 2e-3, "{place:?} {off}");
        }
    }
}

fn torus_of(u: f64, v: f64) -> DVec3 {
    torus(u, v, 0.0)
}

#[test]
fn surfaces_that_do_not_meet_themselves() {
    let tube = |u: f64, v: f64| DVec3::new((TAU * v).cos(), (TAU * v).sin(), 4.0 * u);
    let cone = |u: f64, v: f64| DVec3::new(u * (TAU * v).cos(), u * (TAU * v).sin(), 2.0 * u);
    let strip = |u: f64, v: f64| {
        let (a, w) = (TAU * u, v - 0.5);
        let r = 1.0 + w * (0.5 * a).cos();
        DVec3::new(r * a.cos(), r * a.sin(), w * (0.5 * a).sin())
    };
    let turned = |u: f64, v: f64| DVec3::new(3.0 * u - v, u + 3.0 * v, 0.1 * u);
    let mut cases = vec![
        ("plane", solid(&flat(7, 5))),
        ("plane, turned", lattice([40, 4], [false, false], turned)),
        (
            "paraboloid",
            lattice([8, 8], [false, false], |u, v| {
                let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
                DVec3::new(x, y, x * x + y * y)
            }),
        ),
        ("torus", solid(&ring(24, 48))),
        ("torus of few cells", lattice([6, 9], [true, true], torus_of)),
        ("sphere", solid(&ball(18, 36))),
        ("sphere of few cells", solid(&ball(4, 7))),
        ("tube", lattice([6, 12], [false, true], tube)),
        ("tube of few cells", lattice([1, 5], [false, true], tube)),
        ("cone", lattice([6, 12], [false, true], cone)),
        ("Moebius strip", lattice([40, 4], [false, false], strip)),
    ];
    cases.extend(SHAPES.iter().map(|shape| (shape.name, solid(shape))));
    for (name, surface) in &cases {
        let paths = meet(surface);
        println!("{name}: {}", summary(&paths));
        assert!(paths.is_empty() && paths.unresolved.is_empty(), "{name}: {} {:?}", summary(&paths), paths.unresolved);
    }
}

/// A sheet of heights at random nodes.
fn heights(random: &mut Random, cells: [usize; 2], size: f64) -> Surface<'static> {
    let heights: Vec<f64> = (0..(cells[0] + 1) * (cells[1] + 1)).map(|_| size * random.next()).collect();
    let at = |u: f64, v: f64| {
        let (i, j) = ((u * cells[0] as f64).round() as usize, (v * cells[1] as f64).round() as usize);
        DVec3::new(u, v, heights[i * (cells[1] + 1) + j])
    };
    lattice(cells, [false, false], at)
}

#[test]
fn graphs_do_not_meet_themselves() {
    let mut random = Random(11);
    for k in 0..200 {
        let size = 10.0_f64.powf(2.0 * random.next() - 2.0);
        let surface = heights(&mut random, [9, 11], size);
        let paths = meet(&surface);
        assert!(paths.is_empty() && paths.unresolved.is_empty(), "{k} {size}: {}", summary(&paths));
    }
}

/// Three flat leaves of one strip, in the planes of coordinates, and bends between them.
#[test]
fn three_leaves_through_a_point() {
    // By u: the middle of the strip, and the direction across it. Along leaves both are exact.
    let leaf = |k: usize, t: f64| {
        let mut axis = [DVec3::ZERO; 2];
        (axis[0][k], axis[1][(k + 1) % 3]) = (t, 1.0);
        axis
    };
    let knots: Vec<[DVec3; 2]> = (0..3).flat_map(|k| (0..17).map(move |n| leaf(k, f64::from(n) / 8.0 - 1.0))).collect();
    let mut rows = Vec::new();
    for (n, knot) in knots.iter().enumerate() {
        if n > 0 && n % 17 == 0 {
            // A cubic from the one leaf to the next, far round.
            let ([p, d], [q, e]) = (knots[n - 1], *knot);
            for m in 1..16 {
                let t = f64::from(m) / 16.0;
                let (s, away) = (1.0 - t, 3.0);
                let point = s * s * s * p + 3.0 * s * s * t * (p * away) + 3.0 * s * t * t * (q * away) + t * t * t * q;
                rows.push([point, s * d + t * e]);
            }
        }
        rows.push(*knot);
    }
    let columns = 5;
    let data: Vec<f64> = rows
        .iter()
        .flat_map(|[point, across]| {
            (0..=columns).flat_map(move |j| (*point + (2.0 * j as f64 / columns as f64 - 1.0) * *across).to_array())
        })
        .collect();
    let nodes = Nodes::strided(data, rows.len(), columns + 1, 0, 0).unwrap();
    let surface = one(Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap()));
    let paths = meet(&surface);
    println!("leaves: {}", summary(&paths));
    // The three axes: each a whole curve, though the others cross it in the middle.
    let mut through = [0; 3];
    for k in 0..paths.len() {
        let points = paths.points_of(k);
        for (axis, count) in through.iter_mut().enumerate().map(|(axis, count)| (DVec3::AXES[axis], count)) {
            let on = points.iter().filter(|p| p.abs().max_element() < 0.5).all(|p| p.reject_from(axis).length() < 1e-9);
            let along = points.iter().map(|p| p.dot(axis)).fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(x), b.max(x)]);
            *count += usize::from(on && along[0] < -0.5 && along[1] > 0.5);
        }
    }
    assert_eq!(through, [1, 1, 1], "{}", summary(&paths));
    // The bends meet each other, too, and are pinched.
    assert!(paths.unresolved.iter().all(|&place| surface.jet(place).point.length() > 0.5));
}

#[test]
fn the_same_for_any_number_of_threads_and_cancelled() {
    struct Stop(std::sync::atomic::AtomicUsize, usize);
    impl gusset::Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
            let count = self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            if count >= self.1 { std::ops::ControlFlow::Break(()) } else { std::ops::ControlFlow::Continue(()) }
        }
    }
    let surface = lattice([40, 36], [false, true], klein);
    let run = |threads| surface.meet_itself(&Options::default(), &Job::new(threads, &Silent)).unwrap();
    let paths = [1, 2, 5].map(run);
    assert!(paths[0] == paths[1] && paths[0] == paths[2]);
    for after in [0, 1, 2, 5, 10, 40] {
        let stop = Stop(std::sync::atomic::AtomicUsize::new(0), after);
        assert_eq!(surface.meet_itself(&Options::default(), &Job::new(2, &stop)), Err(gusset::Error::Cancelled));
    }
    for bad in [0.0, -1.0, f64::NAN] {
        let chord = surface.meet_itself(&Options { chord: Some(bad), ..Options::default() }, &Job::default());
        assert!(matches!(chord, Err(gusset::Error::OptionOutOfRange { option: "chord", .. })));
        let tolerance = surface.meet_itself(&Options { tolerance: Some(bad), ..Options::default() }, &Job::default());
        assert!(matches!(tolerance, Err(gusset::Error::OptionOutOfRange { option: "tolerance", .. })));
    }
}

/// One pair of cells with a pinch is a long search, and heard all along.
#[test]
fn searches_of_one_pair_of_cells_are_heard() {
    struct Heard(std::cell::RefCell<Vec<f64>>);
    impl gusset::Progress for Heard {
        fn step(&self, fraction: f64, _: &'static str) -> std::ops::ControlFlow<()> {
            self.0.borrow_mut().push(fraction);
            std::ops::ControlFlow::Continue(())
        }
    }
    let umbrella = polynomial(|u, v| DVec3::new(u * v, u, v * v), 2, [1, 1], [[-1.0, 1.0]; 2]);
    let heard = Heard(std::cell::RefCell::default());
    umbrella.meet_itself(&Options::default(), &Job::new(1, &heard)).unwrap();
    let steps = heard.0.into_inner();
    println!("{} steps", steps.len());
    assert!(steps.len() > 12 && steps.is_sorted() && steps.iter().all(|x| (0.0..=1.0).contains(x)), "{steps:?}");
}
