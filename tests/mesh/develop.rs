//! Developments, held against shapes that unfold, the best radial map of a cap, Euler's formula and
//! the definitions of distortion.

use crate::common::{Soup, data, edge_counts, euler, faces_of, sheet, some_of};
use glam::{DVec2, DVec3};
use gusset::develop::{Cuts, Developed, Distortion, Finish, Options, develop};
use gusset::{Error, Job};
use std::collections::HashSet;
use std::f64::consts::TAU;

pub(crate) fn developed(soup: &Soup, options: &Options<'_>) -> Developed {
    let done = develop(&soup.view(), options, &Job::default()).unwrap();
    assert_sound(soup, &done);
    done
}

pub(crate) fn at(soup: &Soup, v: u32) -> DVec3 {
    DVec3::from_array(soup.points[v as usize])
}

/// Properties of every development of any surface.
pub(crate) fn assert_sound(soup: &Soup, done: &Developed) {
    let faces: Vec<&[u32]> = faces_of(&done.mesh).collect();
    assert_eq!(faces.len(), soup.faces().count());
    // The faces are the old ones, corner by corner.
    for (face, old) in faces.iter().zip(soup.faces()) {
        assert!(face.iter().map(|&v| done.vertex_map[v as usize]).eq(old.iter().copied()));
    }
    let mut vertices = 0;
    for (number, chart) in done.charts.iter().enumerate() {
        assert_eq!(chart.vertices.start, vertices);
        vertices = chart.vertices.end;
        let own: Vec<&[u32]> =
            faces.iter().zip(&done.face_charts).filter(|&(_, &c)| c as usize == number).map(|(f, _)| *f).collect();
        assert_eq!(own.len(), chart.faces as usize);
        assert!(own.iter().flat_map(|face| face.iter()).all(|v| chart.vertices.contains(v)));
        // A disc: Euler's number is 1, and the border is one loop.
        assert_eq!(euler(own.iter().copied()), 1, "chart {number}");
        let border = edge_counts(own.iter().copied()).values().filter(|&&(a, b)| a + b == 1).count();
        assert!(border >= 3 || own.is_empty());
        assert!(chart.energy >= 4.0 - 1e-9, "{chart:?}");
        if chart.finish != Finish::Folded {
            assert_eq!(chart.folds, 0);
            for face in own.iter().filter(|face| face.len() == 3) {
                let [a, b, c] = [0, 1, 2].map(|k| done.points[face[k] as usize]);
                assert!((b - a).perp_dot(c - a) >= -1e-12, "a triangle is turned over");
            }
        }
        if chart.finish != Finish::Exact && chart.finish != Finish::Folded {
            assert_eq!(chart.overlaps, 0);
        }
    }
    assert_eq!(vertices as usize, done.points.len());
    assert!(done.points.iter().all(|p| p.is_finite()));
    // Each cut is an edge that was inside, and is named once.
    let edges = edge_counts(soup.faces());
    let mut seen = HashSet::new();
    for &([u, v], _) in &done.cut_edges {
        let edge = (u.min(v), u.max(v));
        assert!(edges.contains_key(&edge) && seen.insert(edge), "{edge:?}");
    }
}

/// Every side of every face keeps its length.
pub(crate) fn assert_isometric(soup: &Soup, done: &Developed, tolerance: f64) {
    assert!(done.charts.iter().all(|chart| chart.finish == Finish::Exact && chart.overlaps == 0), "{:?}", done.charts);
    for face in faces_of(&done.mesh) {
        for k in 0..face.len() {
            for j in 0..k {
                let [u, v] = [face[j], face[k]];
                let flat = done.points[u as usize].distance(done.points[v as usize]);
                let wanted = at(soup, done.vertex_map[u as usize]).distance(at(soup, done.vertex_map[v as usize]));
                assert!((flat - wanted).abs() <= tolerance * wanted, "{flat} for {wanted}");
            }
        }
    }
}

/// A grid of points as quads or triangles.
pub(crate) fn grid(rows: usize, columns: usize, triangles: bool, point: impl Fn(f64, f64) -> DVec3) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for i in 0..rows {
        for j in 0..columns {
            soup.points.push(point(i as f64 / (rows - 1) as f64, j as f64 / (columns - 1) as f64).to_array());
        }
    }
    for i in 0..rows - 1 {
        for j in 0..columns - 1 {
            let [a, b, c, d] = [[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]].map(|[i, j]| (i * columns + j) as u32);
            if triangles {
                let (one, other) = if (i + j) % 2 == 0 { ([a, b, c], [a, c, d]) } else { ([a, b, d], [b, c, d]) };
                soup.face(&one);
                soup.face(&other);
            } else {
                soup.face(&[a, b, c, d]);
            }
        }
    }
    soup
}

#[test]
fn developable_surfaces_keep_every_length() {
    let apex = DVec3::new(0.4, -0.3, 2.0);
    let round = |t: f64| DVec3::new((TAU * 0.9 * t).cos(), (TAU * 0.9 * t).sin(), 0.0);
    type Shape = Box<dyn Fn(f64, f64) -> DVec3>;
    let shapes: [(&str, Shape); 4] = [
        ("cylinder", Box::new(move |s, t| round(t) + 3.0 * s * DVec3::Z)),
        ("sheared cylinder", Box::new(move |s, t| round(t) + s * DVec3::new(1.0, 0.5, 2.0))),
        ("cone", Box::new(move |s, t| (0.1 + 0.9 * s) * round(t) + (1.0 - s) * 2.0 * DVec3::Z)),
        ("oblique cone", Box::new(move |s, t| apex + (0.2 + 0.8 * s) * (round(t) - apex))),
    ];
    for (name, shape) in &shapes {
        for (rows, columns, triangles) in [(9, 33, true), (2, 65, true), (17, 40, false), (60, 200, true)] {
            let soup = grid(rows, columns, triangles, shape);
            let done = developed(&soup, &Options::default());
            assert_eq!(done.charts.len(), 1, "{name}");
            assert_isometric(&soup, &done, 1e-9);
            let chart = &done.charts[0];
            assert!((chart.area / chart.flat_area - 1.0).abs() < 1e-9 && (chart.energy - 4.0).abs() < 1e-9);
        }
    }
}

/// The lines of neighbouring edges of a polygon meet: strips between them are plane.
#[test]
fn tangent_developables_keep_every_length() {
    let curve = |k: f64| DVec3::new((0.1 * k).cos(), (0.1 * k).sin(), 0.03 * k);
    let soup = grid(8, 41, true, |s, t| {
        let k = 40.0 * t;
        let (from, to) = (curve(k), curve(k + 1.0));
        from + (1.2 + 9.0 * s) * (to - from)
    });
    assert_isometric(&soup, &developed(&soup, &Options::default()), 1e-9);
}

pub(crate) fn cube() -> Soup {
    let points = (0..8).map(|k| [f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)]).collect();
    Soup::new(points, &[&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[1, 3, 7, 5], &[3, 2, 6, 7], &[2, 0, 4, 6]])
}

pub(crate) fn tetrahedron() -> Soup {
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.3, 0.9, 0.0], [0.4, 0.3, 0.8]];
    Soup::new(points, &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]])
}

/// The energy of the best map of a cap that maps circles about its centre to circles: r(a) for the
/// angle a from the centre, computed by a one-dimensional search.
pub(crate) fn best_radial_energy(rim: f64) -> f64 {
    let n = 400;
    let h = rim / n as f64;
    let mut r: Vec<f64> = (0..=n).map(|k| k as f64 * h).collect();
    let value = |s: f64| s * s + 1.0 / (s * s);
    let slope = |s: f64| 2.0 * s - 2.0 / (s * s * s);
    let bend = |s: f64| 2.0 + 6.0 / (s * s * s * s);
    // For ring k the sine of its middle, and the two singular values.
    let ring = |r: &[f64], k: usize| {
        let sine = ((k as f64 + 0.5) * h).sin();
        (sine, (r[k + 1] - r[k]) / h, (r[k + 1] + r[k]) / 2.0 / sine)
    };
    let energy = |r: &[f64]| {
        let of = |k| {
            let (sine, s, t) = ring(r, k);
            if s > 0.0 && t > 0.0 { (value(s) + value(t)) * sine * h } else { f64::INFINITY }
        };
        (0..n).map(of).sum::<f64>()
    };
    // Newton's method with a tridiagonal matrix.
    for _ in 0..50 {
        let (mut g, mut d, mut e) = (vec![0.0; n + 1], vec![0.0; n + 1], vec![0.0; n + 1]);
        for k in 0..n {
            let (sine, s, t) = ring(&r, k);
            let w = sine * h;
            let (along, round) = (1.0 / h, 0.5 / sine);
            g[k] += w * (-slope(s) * along + slope(t) * round);
            g[k + 1] += w * (slope(s) * along + slope(t) * round);
            for i in [k, k + 1] {
                d[i] += w * (bend(s) * along * along + bend(t) * round * round);
            }
            e[k] = w * (-bend(s) * along * along + bend(t) * round * round);
        }
        // The centre stays.
        let mut step = g.clone();
        for k in 1..n {
            let m = e[k] / d[k];
            d[k + 1] -= m * e[k];
            step[k + 1] -= m * step[k];
        }
        for k in (1..=n).rev() {
            let next = if k < n { e[k] * step[k + 1] } else { 0.0 };
            step[k] = (step[k] - next) / d[k];
        }
        step[0] = 0.0;
        let old = energy(&r);
        let mut part = 1.0;
        loop {
            let moved: Vec<f64> = r.iter().zip(&step).map(|(r, s)| r - part * s).collect();
            if energy(&moved) < old || part < 1e-9 {
                r = moved;
                break;
            }
            part /= 2.0;
        }
    }
    energy(&r) / (1.0 - rim.cos())
}

/// A cap of the unit sphere up to an angle from its pole, in triangles of about one size.
pub(crate) fn dome(rings: u32, rim: f64) -> Soup {
    let mut soup = Soup { points: vec![[0.0, 0.0, 1.0]], offsets: vec![0], ..Soup::default() };
    let start = |i: u32| if i == 0 { 0 } else { 1 + 3 * i * (i - 1) };
    for i in 1..=rings {
        let a = rim * f64::from(i) / f64::from(rings);
        for j in 0..6 * i {
            let b = TAU * f64::from(j) / f64::from(6 * i);
            soup.points.push([a.sin() * b.cos(), a.sin() * b.sin(), a.cos()]);
        }
        for j in 0..6 * i {
            let (side, place) = (j / i, j % i);
            let outer = |j: u32| start(i) + j % (6 * i);
            let inner = |k: u32| if i == 1 { 0 } else { start(i - 1) + (side * (i - 1) + k) % (6 * (i - 1)) };
            soup.face(&[outer(j), outer(j + 1), inner(place)]);
            if place + 1 < i {
                soup.face(&[outer(j + 1), inner(place + 1), inner(place)]);
            }
        }
    }
    soup
}

#[test]
fn caps_are_as_flat_as_the_best_radial_map() {
    for (rim, rings) in [(0.5, 20), (1.0, 24), (1.5, 30)] {
        let soup = dome(rings, rim);
        let done = developed(&soup, &Options::default());
        assert_eq!(done.charts[0].finish, Finish::Converged, "{:?}", done.charts);
        let (found, best) = (done.charts[0].energy - 4.0, best_radial_energy(rim) - 4.0);
        println!("rim {rim}: {found} beside {best}, {} steps", done.charts[0].iterations);
        assert!((found / best - 1.0).abs() < 0.01, "rim {rim}: {found} for {best}");
    }
}

/// The sums of the definitions, from the singular values of the triangles' maps.
pub(crate) fn energy_of(soup: &Soup, done: &Developed, one: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut area) = (0.0, 0.0);
    for face in faces_of(&done.mesh) {
        let [a, b, c] = [0, 1, 2].map(|k| at(soup, done.vertex_map[face[k] as usize]));
        let [p, q, r] = [0, 1, 2].map(|k| done.points[face[k] as usize]);
        let (u, v) = (b - a, c - a);
        let e = u.normalize();
        let f = (v - v.dot(e) * e).normalize();
        let from = glam::DMat2::from_cols(DVec2::new(u.length(), 0.0), DVec2::new(v.dot(e), v.dot(f)));
        let map = glam::DMat2::from_cols(q - p, r - p) * from.inverse();
        let (trace, det) = ((map.transpose() * map).x_axis.x + (map.transpose() * map).y_axis.y, map.determinant());
        let root = (trace * trace / 4.0 - det * det).max(0.0).sqrt();
        let own = u.cross(v).length();
        sum += own * (one((trace / 2.0 + root).sqrt()) + one((trace / 2.0 - root).max(0.0).sqrt()));
        area += own;
    }
    sum / area
}

#[test]
fn distortions_are_least_of_their_kind() {
    let soup = dome(14, 1.3);
    let of = |distortion| developed(&soup, &Options { distortion, ..Options::default() });
    let [symmetric, rigid, conformal] = [Distortion::Symmetric, Distortion::Rigid, Distortion::Conformal].map(of);
    let dirichlet = |done: &Developed| energy_of(&soup, done, |s| s * s + 1.0 / (s * s));
    let stiff = |done: &Developed| energy_of(&soup, done, |s| (s - 1.0) * (s - 1.0));
    assert!((dirichlet(&symmetric) - symmetric.charts[0].energy).abs() < 1e-9);
    assert!(dirichlet(&symmetric) < dirichlet(&rigid) && dirichlet(&symmetric) < dirichlet(&conformal));
    assert!(stiff(&rigid) < stiff(&symmetric) && stiff(&rigid) < stiff(&conformal));
    // Angles: the ratio of the singular values.
    let skew = |done: &Developed| done.stretches.iter().map(|[a, b]| a / b).fold(1.0, f64::max);
    assert_eq!(conformal.charts[0].finish, Finish::Conformal);
    assert!(skew(&conformal) < 1.06 && skew(&symmetric) > 1.2, "{} {}", skew(&conformal), skew(&symmetric));
    // Triangles half as large are half as skew.
    let fine = developed(&dome(28, 1.3), &Options { distortion: Distortion::Conformal, ..Options::default() });
    assert!(skew(&fine) - 1.0 < 0.6 * (skew(&conformal) - 1.0), "{}", skew(&fine));
    // A minimum: no small change of the places gains.
    let mut random = fastrand::Rng::with_seed(5);
    let lowest = dirichlet(&symmetric);
    for _ in 0..200 {
        let mut moved = symmetric.clone();
        let size = 10f64.powf(-2.0 - 3.0 * random.f64());
        let v = random.usize(..moved.points.len());
        moved.points[v] += size * DVec2::from_angle(TAU * random.f64());
        assert!(dirichlet(&moved) > lowest - 1e-9);
    }
}

#[test]
fn mistakes_are_named() {
    let soup = sheet(3, 3);
    let error = |options: &Options<'_>| develop(&soup.view(), options, &Job::default()).unwrap_err();
    let cut = |vertices, offsets| Options { cuts: Cuts { vertices, offsets }, ..Options::default() };
    let count = soup.points.len() as u32;
    assert_eq!(error(&cut(&[0, 99], &[])), Error::LoopIndexOutOfRange { number: 0, place: 1, vertex: 99, count });
    assert_eq!(error(&cut(&[0, 1], &[0, 3])), Error::BadOffsets { entry: 1, value: 3 });
    assert_eq!(error(&cut(&[0, 1], &[1, 2])), Error::BadOffsets { entry: 0, value: 1 });
    for stretch in [1.0, 0.5, f64::NAN, f64::INFINITY] {
        let found = error(&Options { max_stretch: Some(stretch), ..Options::default() });
        assert!(matches!(found, Error::OptionOutOfRange { option: "max_stretch", .. }));
    }
    let apart = sheet(1, 1).and(&sheet(1, 1));
    let found = develop(&apart.view(), &cut(&[0, 1, 5], &[]), &Job::default()).unwrap_err();
    assert_eq!(found, Error::CutNotConnected { cut: 0, place: 2, vertex: 5 });
    let repeated = Soup::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[&[0, 1, 2], &[0, 1, 1]]);
    let found = develop(&repeated.view(), &Options::default(), &Job::default()).unwrap_err();
    assert!(matches!(found, Error::RepeatedCorner { face: 1, vertex: 1 }), "{found:?}");
}

/// Rough ground, slivers, triangles without area, pieces that touch, wrong orientation, three faces
/// at an edge: each gives a development without folds, or one that reports its folds.
#[test]
fn rough_surfaces_do_not_fold() {
    for seed in some_of(6, 0..60) {
        let mut random = fastrand::Rng::with_seed(seed);
        let (w, h) = (random.u32(2..14), random.u32(2..14));
        let mut soup = sheet(w, h);
        let height = 2.0 * random.f64();
        for p in &mut soup.points {
            p[2] = height * random.f64() * (p[0] * 0.7).sin();
            if random.u32(..6) == 0 {
                p[0] += 0.9 * random.f64();
            }
        }
        if seed % 3 == 1 {
            // Vertices in one place, and on one line.
            let (v, w) = (random.usize(..soup.points.len()), random.usize(..soup.points.len()));
            soup.points[v] = soup.points[w];
        }
        if seed % 4 == 2 {
            let gone = random.u32(..w * h);
            let mut rest = Soup { points: soup.points.clone(), offsets: vec![0], ..Soup::default() };
            for (f, face) in soup.faces().enumerate() {
                let turned: Vec<u32> = face.iter().rev().copied().collect();
                if f as u32 != gone {
                    rest.face(if f % 17 == 5 { &turned } else { face });
                }
            }
            soup = rest;
        }
        let done = develop(&soup.view(), &Options::default(), &Job::default()).unwrap();
        assert!(done.points.iter().all(|p| p.is_finite()));
        for chart in &done.charts {
            assert!(chart.finish != Finish::Folded || chart.folds > 0, "{seed}: {chart:?}");
        }
        let folded = done.charts.iter().filter(|chart| chart.finish == Finish::Folded).count();
        assert_eq!(folded, 0, "seed {seed}: {:?}", done.charts);
    }
}

/// The same in other units, elsewhere, and in any number of threads.
#[test]
fn units_do_not_matter() {
    let mut soup = dome(8, 1.0);
    soup.points.iter_mut().for_each(|p| p[0] *= 2.0);
    let base = developed(&soup, &Options::default());
    for scale in [1e-12, 1024.0, 1e30] {
        let mut other = soup.clone();
        other.points.iter_mut().flatten().for_each(|x| *x *= scale);
        let done = developed(&other, &Options::default());
        assert!((done.charts[0].energy - base.charts[0].energy).abs() < 1e-6);
        for (p, q) in done.points.iter().zip(&base.points) {
            assert!((*p / scale).distance(*q) < 1e-4, "{p} {q}");
        }
    }
}

#[test]
fn real_surfaces_do_not_fold() {
    for name in ["pairs/bunny_cut/head.off", "pairs/bunny_cut/body.off"] {
        let Some(soup) = data::off(name) else {
            return;
        };
        let done = developed(&soup, &Options { max_iterations: 3, ..Options::default() });
        assert!(done.charts.iter().all(|chart| chart.finish != Finish::Folded), "{name}: {:?}", done.charts);
    }
}

pub(crate) fn bumps(n: usize) -> Soup {
    grid(n, n, true, |u, v| DVec3::new(u, v, 0.3 * (3.0 * u).sin() * (4.0 * v).cos()))
}

/// Rough ground whose border touches itself during the iteration: the map continues.
#[test]
fn borders_that_touch_on_the_way_do_not_stop_a_descent() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut soup = grid(20, 20, true, |u, v| DVec3::new(u, v, 0.0));
    soup.points.iter_mut().for_each(|p| p[2] = 0.4 * random.f64());
    let done = developed(&soup, &Options::default());
    let chart = &done.charts[0];
    // At a minimum the gradient is 0: no vertex moved by itself gains.
    assert!(matches!(chart.finish, Finish::Converged | Finish::IterationLimit), "{chart:?}");
    let dirichlet = |done: &Developed| energy_of(&soup, done, |s| s * s + 1.0 / (s * s));
    let lowest = dirichlet(&done);
    for k in 0..60 {
        let mut moved = done.clone();
        let v = random.usize(..moved.points.len());
        moved.points[v] += 1e-4 * DVec2::from_angle(f64::from(k));
        assert!(dirichlet(&moved) > lowest * (1.0 - 1e-5));
    }
}

/// Triangles that are points, and charts that are.
#[test]
fn points_spoil_nothing() {
    let mut soup = bumps(10);
    let spared = developed(&soup, &Options::default()).charts[0].energy;
    soup.points[60] = soup.points[72];
    soup.points[61] = soup.points[72];
    let done = developed(&soup, &Options::default());
    assert!(done.charts[0].energy < 1.2 * spared, "{:?}", done.charts);
    let point = Soup::new(vec![[0.0; 3]; 4], &[&[0, 1, 2], &[0, 2, 3]]);
    for soup in [&point, &point.and(&bumps(4))] {
        let done = develop(&soup.view(), &Options::default(), &Job::default()).unwrap();
        assert!(done.points.iter().all(|p| p.is_finite()));
        assert!(done.charts.iter().all(|chart| chart.energy.is_finite() || chart.finish == Finish::Exact));
    }
}
