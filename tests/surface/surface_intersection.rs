//! Intersections of two surfaces: against equations, against dense sampling, and against each
//! other.

use crate::common::Silent;
use crate::pairs::{
    ball, changes, check, distance, flat, from_torus, grid, length, meet, one, ring, summary, surface, turn,
};
use crate::shapes::{Random, Shape, torus};
use glam::{DMat3, DVec3};
use gusset::job::Progress;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Patches, Place, Scheme, Sheet, Surface};
use gusset::{Error, Job};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

#[test]
fn tori_by_equations_and_sampling() {
    let shape = ring(24, 48);
    let a = surface(&shape, |p| p);
    let own = grid(&shape, Scheme::SixTap, |p| p);
    let mut random = Random(5);
    for k in 0..24 {
        let (turn, shift) = (turn(&mut random), random.point(0.9));
        let b = surface(&shape, |p| turn * p + shift);
        let paths = meet(&a, &b);
        assert!(paths.closed.iter().all(|&closed| closed), "{k}: {}", summary(&paths));
        assert!(paths.unresolved.is_empty(), "{k}: {}", summary(&paths));
        let back = turn.transpose();
        for &point in &paths.points {
            let miss = from_torus(point).abs().max(from_torus(back * (point - shift)).abs());
            assert!(miss < 1e-5, "{k}: {point} {miss}");
        }
        // Near tangency the tori differ from their interpolants by more: there the place of the
        // curve does too.
        let truth = changes(&own, 8, |point| from_torus(back * (point - shift)));
        let far = truth.iter().map(|&point| distance(&paths, point)).fold(0.0, f64::max);
        assert!(far < 5e-3, "{k}: {far} {}", summary(&paths));
        assert_eq!(truth.is_empty(), paths.is_empty());
    }
}

#[test]
fn fourth_order_on_tori() {
    let turn = DMat3::from_rotation_x(1.1) * DMat3::from_rotation_z(0.3);
    let shift = DVec3::new(0.5, 0.13, 0.07);
    let errors = [16, 32, 64].map(|h| {
        let shape = ring(h, 2 * h);
        let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| turn * p + shift));
        let options = Options { chord: Some(1e-5), tolerance: None };
        let paths = a.meet(&b, &options, &Job::default()).unwrap();
        check(&paths, &a, &b);
        let miss = |&p: &DVec3| from_torus(p).abs().max(from_torus(turn.transpose() * (p - shift)).abs());
        paths.points.iter().map(miss).fold(0.0, f64::max)
    });
    assert!((errors[0] / errors[1]).log2() >= 3.8 && (errors[1] / errors[2]).log2() >= 3.8, "{errors:?}");
}

#[test]
fn planes_cut_tori_in_known_curves() {
    let shape = ring(24, 48);
    let a = surface(&shape, |p| p);
    // Through lines of nodes: two circles, of radius 0.6 and 1.4. Through the axis: two of radius
    // 0.4. Villarceau's: two of radius 1.
    let villarceau = (0.4_f64).asin();
    let cases = [
        (DMat3::IDENTITY, [0.6, 1.4], 1e-3),
        (DMat3::from_rotation_x(0.25 * TAU), [0.4, 0.4], 1e-3),
        (DMat3::from_rotation_x(villarceau), [1.0, 1.0], 1e-2),
    ];
    for (k, (turn, radii, exact)) in cases.into_iter().enumerate() {
        for plane in [flat(1, 1), flat(7, 5), flat(16, 16), flat(33, 20)] {
            let b = surface(&plane, |p| turn * p);
            for (paths, way) in [(meet(&a, &b), "a b"), (meet(&b, &a), "b a")] {
                let expected = TAU * (radii[0] + radii[1]);
                let found = length(&paths);
                assert!(
                    (found / expected - 1.0).abs() < exact,
                    "{k} {way} {:?}: {found}: {}",
                    plane.cells,
                    summary(&paths)
                );
                assert!(paths.closed.iter().all(|&closed| closed), "{k} {way}: {}", summary(&paths));
                assert!(k == 2 || paths.len() == 2 && paths.unresolved.is_empty(), "{k} {way}: {}", summary(&paths));
                let normal = turn * DVec3::Z;
                assert!(paths.points.iter().all(|p| p.dot(normal).abs() < 1e-9 && from_torus(*p).abs() < 1e-5));
            }
        }
    }
}

#[test]
fn wavy_sheets_by_sampling() {
    let wave = |u: f64, v: f64| DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.2 * (9.0 * u).sin() * (7.0 * v + 1.0).cos());
    let ripple = |u: f64, v: f64| DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.1 * (11.0 * u + 5.0 * v).sin() + 0.02);
    let first = Shape { name: "wave", cells: [20, 26], closed: [false, false], point: wave };
    for cells in [[20, 26], [13, 37], [5, 5]] {
        let second = Shape { name: "ripple", cells, closed: [false, false], point: ripple };
        let (a, b) = (surface(&first, |p| p), surface(&second, |p| p));
        let other = grid(&second, Scheme::SixTap, |p| p);
        // x and y of the interpolant are linear in its parameters: its height at (x, y) is known.
        let height = |x: f64, y: f64| {
            let at = |x: f64, n: usize| {
                let t = 0.5 * (x + 1.0) * n as f64;
                let cell = (t.floor().max(0.0) as usize).min(n - 1);
                (cell, t - cell as f64)
            };
            let ((i, u), (j, v)) = (at(x, cells[0]), at(y, cells[1]));
            other.patch(i, j).point(u, v).z
        };
        let paths = meet(&a, &b);
        let truth = changes(&grid(&first, Scheme::SixTap, |p| p), 8, |p| p.z - height(p.x, p.y));
        assert!(truth.len() > 1000 && paths.unresolved.is_empty());
        let far = truth.iter().map(|&point| distance(&paths, point)).fold(0.0, f64::max);
        assert!(far < 2e-3, "{cells:?}: {far} {}", summary(&paths));
        // Open ends are on the edges of the sheets.
        for k in (0..paths.len()).filter(|&k| !paths.closed[k]) {
            let points = paths.points_of(k);
            for end in [points[0], points[points.len() - 1]] {
                assert!(end.x.abs().max(end.y.abs()) > 1.0 - 1e-9, "{cells:?}: {end}");
            }
        }
        // The other way round: the same curves.
        let back = meet(&b, &a);
        assert_eq!(
            (back.len(), back.closed.iter().filter(|&&c| c).count()),
            (paths.len(), paths.closed.iter().filter(|&&c| c).count())
        );
        assert!((length(&back) / length(&paths) - 1.0).abs() < 1e-3);
        let far = back.points.iter().map(|&point| distance(&paths, point)).fold(0.0, f64::max);
        assert!(far < 3e-4, "{cells:?}: {far}");
    }
}

#[test]
fn loops_within_one_pair_of_cells() {
    // A paraboloid that pierces the middle of a flat cell by less and less.
    for depth in [1e-2, 1e-4, 1e-6, 1e-7] {
        let bump = Shape {
            name: "bump",
            cells: [3, 3],
            closed: [false, false],
            point: |u, v| {
                let (x, y) = (2.0 * u - 1.03, 2.0 * v - 0.98);
                DVec3::new(x, y, 0.5 * (x * x + y * y))
            },
        };
        let a = surface(&flat(3, 3), |p| p);
        let b = surface(&bump, |p| p - DVec3::new(0.0, 0.0, depth));
        for paths in [meet(&a, &b), meet(&b, &a)] {
            assert!(paths.len() == 1 && paths.closed[0], "{depth}: {}", summary(&paths));
            let radius = (2.0 * depth).sqrt();
            assert!(paths.points.iter().all(|p| (p.truncate().length() / radius - 1.0).abs() < 1e-6), "{depth}");
            assert!(paths.unresolved.is_empty(), "{depth}: {}", summary(&paths));
        }
    }
}

#[test]
fn the_same_for_any_number_of_threads_and_any_scale() {
    let shape = ring(24, 48);
    let turn = DMat3::from_rotation_y(0.7);
    let shift = DVec3::new(0.4, 0.3, 0.2);
    let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| turn * p + shift));
    let paths = [1, 2, 5].map(|threads| a.meet(&b, &Options::default(), &Job::new(threads, &Silent)).unwrap());
    assert!(paths[0] == paths[1] && paths[0] == paths[2] && !paths[0].is_empty());
    for scale in [1e-9, 1e9] {
        let (a, b) = (surface(&shape, |p| scale * p), surface(&shape, |p| scale * (turn * p + shift)));
        let scaled = meet(&a, &b);
        assert_eq!(scaled.closed, paths[0].closed);
        assert!((length(&scaled) / length(&paths[0]) / scale - 1.0).abs() < 1e-6);
    }
    let far = DVec3::new(1e6, -2e6, 1e6);
    let (a, b) = (surface(&shape, |p| p + far), surface(&shape, |p| turn * p + shift + far));
    // Nodes are rounded there, so that a chord more or less may be needed: fine ones, whose lengths
    // hardly tell their number.
    let fine = Options { chord: Some(1e-6), ..Options::default() };
    let moved = a.meet(&b, &fine, &Job::default()).unwrap();
    assert_eq!(moved.closed, paths[0].closed);
    let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| turn * p + shift));
    let here = a.meet(&b, &fine, &Job::default()).unwrap();
    assert!((length(&moved) / length(&here) - 1.0).abs() < 1e-8);
}

#[test]
fn rotations_change_nothing() {
    let shape = ring(16, 32);
    let (first, second) = (DMat3::from_rotation_x(1.3), DVec3::new(0.3, 0.2, 0.1));
    let mut random = Random(8);
    let mut lengths = Vec::new();
    for _ in 0..6 {
        let turn = turn(&mut random);
        let (a, b) = (surface(&shape, |p| turn * p), surface(&shape, |p| turn * (first * p + second)));
        let paths = meet(&a, &b);
        assert!(paths.closed.iter().all(|&closed| closed));
        lengths.push((paths.len(), length(&paths)));
    }
    assert!(lengths.iter().all(|l| l.0 == lengths[0].0 && (l.1 / lengths[0].1 - 1.0).abs() < 1e-3), "{lengths:?}");
}

#[test]
fn candidates_hold_all_that_meets() {
    let shape = ring(16, 32);
    let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| DMat3::from_rotation_x(0.9) * p + 0.2));
    let job = Job::default();
    let pairs = a.candidate_cell_pairs(&b, 0.0, &job).unwrap();
    assert!(pairs.is_sorted() && pairs.windows(2).all(|pair| pair[0] != pair[1]));
    let near: Vec<DVec3> = meet(&a, &b).points;
    assert!(pairs.len() < 4 * near.len());
    let paths = meet(&a, &b);
    for (place, other) in paths.places.iter().zip(&paths.others) {
        assert!(pairs.iter().any(|pair| pair.cells == [place.cell, other.cell]));
    }
    // By distance: all pairs of cells with samples as near as that.
    let within = 0.1;
    let wide: std::collections::HashSet<_> =
        a.candidate_cell_pairs(&b, within, &job).unwrap().into_iter().map(|pair| pair.cells).collect();
    let cells = |k: u32| [k / 32, k % 32];
    let samples = |of: &Surface<'_>, cell: [u32; 2]| {
        [0.0, 0.5, 1.0]
            .map(|u| [0.0, 0.5, 1.0].map(|v| of.jet(Place { sheet: 0, cell, u, v }).point))
            .as_flattened()
            .to_vec()
    };
    let of_b: Vec<_> = (0..512).map(|k| samples(&b, cells(k))).collect();
    for k in 0..512 {
        let own = samples(&a, cells(k));
        for (n, other) in of_b.iter().enumerate() {
            let meets = own.iter().any(|p| other.iter().any(|q| p.distance(*q) <= within));
            assert!(!meets || wide.contains(&[cells(k), cells(n as u32)]));
        }
    }
    assert!(wide.len() < 512 * 512 / 8);
}

#[test]
fn bad_options_and_cancel() {
    let shape = ring(16, 32);
    let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| p + 0.3));
    let job = Job::default();
    for bad in [0.0, -1.0, f64::NAN] {
        let chord = a.meet(&b, &Options { chord: Some(bad), ..Options::default() }, &job);
        assert!(matches!(chord, Err(Error::OptionOutOfRange { option: "chord", .. })));
        let tolerance = a.meet(&b, &Options { tolerance: Some(bad), ..Options::default() }, &job);
        assert!(matches!(tolerance, Err(Error::OptionOutOfRange { option: "tolerance", .. })));
    }
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let found = a.candidate_cell_pairs(&b, bad, &job);
        assert!(matches!(found, Err(Error::OptionOutOfRange { option: "within", .. })));
    }
    struct Stop;
    impl Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    assert_eq!(a.meet(&b, &Options::default(), &Job::new(1, &Stop)), Err(Error::Cancelled));
    // Apart: nothing.
    let far = surface(&shape, |p| p + 10.0);
    assert!(meet(&a, &far).is_empty());
}

/// Random positions of several pairs of shapes, against dense sampling: nothing is lost, everything
/// is closed.
#[test]
#[ignore = "some minutes"]
fn exhaustive_random_positions() {
    let bumpy = Shape { name: "bumpy torus", cells: [31, 53], closed: [true, true], point: |u, v| torus(u, v, 0.15) };
    let smooth = ring(24, 48);
    let round = ball(18, 36);
    let mut random = Random(77);
    let (mut points, mut unresolved) = (0, 0);
    for k in 0..300 {
        let own = [&bumpy, &smooth, &round][k % 3];
        let a = surface(own, |p| p);
        let (turn, shift) = (turn(&mut random), random.point(1.2));
        let b = surface(&smooth, |p| turn * p + shift);
        let paths = meet(&a, &b);
        assert!(paths.closed.iter().all(|&closed| closed), "{k}: {}", summary(&paths));
        let height = |p: DVec3| from_torus(turn.transpose() * (p - shift));
        let truth = changes(&grid(own, Scheme::SixTap, |p| p), 8, height);
        for &point in &truth {
            let far = distance(&paths, point);
            // Where the surfaces nearly touch, the surfaces by equation and by nodes may meet in
            // different places.
            let place = a.closest(point, f64::INFINITY).unwrap().place;
            let step = 1e-6 * a.normal(place).any_orthonormal_vector();
            let other = 1e-6 * a.normal(place).cross(step).normalize();
            let slope = (height(point + step) - height(point)).hypot(height(point + other) - height(point)) / 1e-6;
            assert!(far < 2e-3 + 1e-4 / slope.max(1e-3), "{k}: {point} {far} {slope} {}", summary(&paths));
        }
        points += truth.len();
        unresolved += usize::from(!paths.unresolved.is_empty());
    }
    assert!(points > 100_000 && unresolved == 0, "{points} {unresolved}");
}

/// A wave of the fifth degree along whose chord both ends and the middle lie: what a cubic through
/// the ends does not show.
#[test]
fn waves_between_points_are_seen() {
    for c in [0.05, 0.25, 1.0, 4.0] {
        // x^2 (1 - x)^2 (1 - 2x), by its coefficients.
        let wave = [0.0, 0.0, 0.1, -0.1, 0.0, 0.0].map(|x: f64| c * x);
        let point = |a: usize, b: usize| DVec3::new(a as f64 / 5.0, b as f64, b as f64 - 0.5 - wave[a]);
        let points: Vec<DVec3> = (0..12).map(|k| point(k / 2, k % 2)).collect();
        let bent = Sheet::High(Patches::new(&points, [5, 1], 1, 1).unwrap());
        let corners = [[-1.0, -1.0], [-1.0, 2.0], [2.0, -1.0], [2.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let plane = Sheet::Cubic(Patches::new(&corners, [1, 1], 1, 1).unwrap());
        let [a, b] = [bent, plane].map(|sheet| Surface::new(vec![sheet], None, &Job::default()).unwrap());
        let chord = 1e-3;
        let paths = a.meet(&b, &Options { chord: Some(chord), ..Options::default() }, &Job::default()).unwrap();
        assert_eq!(paths.len(), 1);
        for k in 0..=1000 {
            let x = f64::from(k) / 1000.0;
            let at = DVec3::new(x, 0.5 + c * (x * (1.0 - x)).powi(2) * (1.0 - 2.0 * x), 0.0);
            let near = paths.points.windows(2).map(|ends| {
                let along = ends[1] - ends[0];
                let t = ((at - ends[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                at.distance(ends[0] + t * along)
            });
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near <= 1.01 * chord, "{c}, {x}: {near}");
        }
    }
}

/// Whitney's umbrella, (u v, u, v^2), cut beside its pinch: parabolas as thin as the distance from
/// it, with tips beyond the chords from leg to leg.
#[test]
fn tips_of_hairpins_are_seen() {
    for (distance_of_cut, [from, to]) in [0.1, 0.01, 3e-3, 1e-3]
        .into_iter()
        .flat_map(|y| [[-1.0, 1.0], [-1.0, 1.2], [-0.3, 1.0], [-1.0, 0.1], [-0.11, 0.1]].map(|range| (y, range)))
    {
        let (u, v) = ([0.0, 0.5, 1.0], [from, 0.5 * (from + to), to]);
        let square = [from * from, from * to, to * to];
        let umbrella: Vec<DVec3> = (0..9).map(|k| DVec3::new(u[k / 3] * v[k % 3], u[k / 3], square[k % 3])).collect();
        let plane =
            [[-2.0, -1.0], [-2.0, 2.0], [2.0, -1.0], [2.0, 2.0]].map(|[x, z]| DVec3::new(x, distance_of_cut, z));
        let [umbrella, plane] = [(umbrella.as_slice(), 2), (plane.as_slice(), 1)]
            .map(|(points, degree)| one(Sheet::Cubic(Patches::new(points, [degree; 2], 1, 1).unwrap())));
        let chord = 1e-3;
        let options = Options { chord: Some(chord), tolerance: None };
        let paths = umbrella.meet(&plane, &options, &Job::new(1, &Silent)).unwrap();
        check(&paths, &umbrella, &plane);
        assert!(paths.len() == 1 && !paths.closed[0] && paths.unresolved.is_empty(), "{}", summary(&paths));
        let truth = |k: i32| {
            let v = from + (to - from) * f64::from(k) / 1000.0;
            DVec3::new(distance_of_cut * v, distance_of_cut, v * v)
        };
        let far = (0..=1000).map(|k| distance(&paths, truth(k))).fold(0.0, f64::max);
        // The height of an arc is nearly the height of the cubic with its tangents.
        assert!(far <= 1.1 * chord, "{distance_of_cut} {from} {to}: {far} {}", summary(&paths));
    }
}
