//! Random polygons of several kinds, judged by their exact area, by all pairs of triangles and by
//! the sides of triangles.

use super::{clip_ears, triangulate_polygon};
use crate::job::Job;
use fastrand::Rng;
use glam::{DMat3, DQuat, DVec2, DVec3, EulerRot};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Cases of each kind of polygon.
const CASES: u64 = if cfg!(debug_assertions) { 60 } else { 400 };

fn split(points: &[DVec3]) -> Vec<[u32; 3]> {
    let mut triangles = vec![[7; 3]; 5];
    triangulate_polygon(points, &mut triangles, &Job::default()).unwrap();
    assert_eq!(triangles.len(), points.len().saturating_sub(2));
    triangles
}

fn area(outline: &[DVec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| (*a - outline[0]).perp_dot(*b - outline[0])).sum::<f64>() / 2.0
}

/// Asserts that each side of the polygon is a side of one triangle, and each diagonal of two that
/// run it in opposite directions.
fn assert_closes(count: usize, triangles: &[[u32; 3]]) {
    let mut sides: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for &[a, b, c] in triangles {
        for side in [[a, b], [b, c], [c, a]] {
            assert_eq!(*sides.entry(side).and_modify(|uses| *uses += 1).or_insert(1), 1, "{side:?} twice");
        }
    }
    let count = count as u32;
    for k in 0..count {
        assert_eq!(sides.remove(&[k, (k + 1) % count]), Some(1), "side {k}");
    }
    for &[a, b] in sides.keys() {
        assert!(sides.contains_key(&[b, a]), "{a} to {b} has one triangle");
    }
}

/// Returns whether two triangles share inner points: no line along a side of one separates them.
fn overlaps(one: [DVec2; 3], other: [DVec2; 3], slack: f64) -> bool {
    let separates = |[a, b]: [DVec2; 2], points: [DVec2; 3]| points.iter().all(|&p| (b - a).perp_dot(p - a) <= slack);
    let sides = |[a, b, c]: [DVec2; 3]| [[a, b], [b, c], [c, a]];
    !sides(one).iter().any(|&side| separates(side, other)) && !sides(other).iter().any(|&side| separates(side, one))
}

/// Asserts all that holds of a split of a simple polygon, whose outline may pass a bridge twice.
fn assert_split(outline: &[DVec2], place: impl Fn(DVec2) -> DVec3, name: &str) {
    let points: Vec<DVec3> = outline.iter().map(|&point| place(point)).collect();
    let triangles = split(&points);
    assert_closes(points.len(), &triangles);
    let flat: Vec<[DVec2; 3]> = triangles.iter().map(|t| t.map(|corner| outline[corner as usize])).collect();
    let wanted = area(outline);
    let total: f64 = flat.iter().map(|triangle| area(triangle).abs()).sum();
    assert!((total / wanted - 1.0).abs() < 1e-9, "{name}: area {total}, not {wanted}");
    let slack = 1e-9 * wanted;
    for (k, &one) in flat.iter().enumerate() {
        assert!(area(&one) > -slack, "{name}: triangle {k} is turned over");
        for &other in &flat[..k] {
            assert!(!overlaps(one, other, slack), "{name}: {one:?} and {other:?}");
        }
    }
}

/// Returns a random rotation, shift and unit.
fn random_place(rng: &mut Rng) -> impl Fn(DVec2) -> DVec3 {
    let angles = [rng.f64() * TAU, rng.f64() * TAU, rng.f64() * TAU];
    let turned = match rng.u8(0..4) {
        0 => DMat3::IDENTITY,
        1 => DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X),
        _ => DMat3::from_quat(DQuat::from_euler(EulerRot::XYZ, angles[0], angles[1], angles[2])),
    };
    let unit = 10_f64.powi(rng.i32(-150..150));
    let shift = DVec3::new(rng.f64(), rng.f64(), rng.f64()) * if rng.bool() { 100.0 } else { 0.0 };
    move |point| (turned * point.extend(0.0) + shift) * unit
}

fn star(rng: &mut Rng) -> Vec<DVec2> {
    let count = rng.usize(5..100);
    (0..count).map(|k| DVec2::from_angle(k as f64 / count as f64 * TAU) * (0.2 + rng.f64())).collect()
}

/// A band along a spiral of up to three turns.
fn spiral(rng: &mut Rng) -> Vec<DVec2> {
    let turns = 0.5 + 2.5 * rng.f64();
    let count = (turns * 12.0) as usize + rng.usize(4..12);
    let side = |k: usize, offset: f64| {
        let along = k as f64 / count as f64 * turns;
        DVec2::from_angle(along * TAU) * (1.0 + along + offset)
    };
    let outer = (0..=count).map(|k| side(k, 0.4));
    // Chords of the outer side stay outside the inner side.
    outer.chain((0..=count).rev().map(|k| side(k, -0.3))).collect()
}

fn comb(rng: &mut Rng) -> Vec<DVec2> {
    let teeth = rng.usize(2..25);
    let mut outline = vec![DVec2::new(0.0, -rng.f64() - 0.1), DVec2::new(teeth as f64, -0.5)];
    for k in (0..teeth).rev() {
        let (height, gap) = (1.0 + 5.0 * rng.f64(), 0.3 + 0.4 * rng.f64());
        let x = k as f64;
        outline.extend([DVec2::new(x + 1.0, height), DVec2::new(x + gap, height), DVec2::new(x + gap, 0.1)]);
        outline.push(DVec2::new(x + 0.1, 0.1));
    }
    outline
}

/// A rectangle with windows in a row. Each is reached by a bridge that is passed both ways, from the
/// window before it or from the outline. Windows lie ever lower, so that bridges miss them.
fn keyholes(rng: &mut Rng) -> Vec<DVec2> {
    let windows = rng.usize(1..20);
    let width = 3.0 * windows as f64 + 1.0;
    let mut outline = vec![DVec2::ZERO];
    let mut way_back = Vec::new();
    for k in 0..windows {
        let low = DVec2::new(1.0 + 3.0 * k as f64, 1.0 - 0.8 * (k as f64 + rng.f64()) / windows as f64);
        let (x, y) = (DVec2::X * (0.5 + rng.f64()), DVec2::Y * (0.5 + rng.f64()));
        outline.extend([low, low + y, low + y + x, low + x, low]);
        way_back.push(low);
    }
    way_back.pop();
    outline.extend(way_back.iter().rev());
    outline.extend([DVec2::ZERO, DVec2::new(width, 0.0), DVec2::new(width, 4.0), DVec2::new(0.0, 4.0)]);
    outline
}

/// Adds corners on sides, and repeats corners.
fn crowd(outline: &mut Vec<DVec2>, rng: &mut Rng) {
    for _ in 0..rng.usize(0..5) {
        let k = rng.usize(0..outline.len());
        let next = outline[(k + 1) % outline.len()];
        let share = [0.0, 0.25, 0.5][rng.usize(0..3)];
        outline.insert(k + 1, outline[k] * (1.0 - share) + next * share);
    }
}

#[test]
fn simple_polygons_are_covered_once() {
    type Make = fn(&mut Rng) -> Vec<DVec2>;
    let kinds: [(&str, Make); 4] = [("star", star), ("spiral", spiral), ("comb", comb), ("keyholes", keyholes)];
    for (name, make) in kinds {
        for seed in 0..CASES {
            let rng = &mut Rng::with_seed(seed);
            let mut outline = make(rng);
            if seed % 2 == 1 {
                crowd(&mut outline, rng);
            }
            let first = rng.usize(0..outline.len());
            outline.rotate_left(first);
            assert_split(&outline, random_place(rng), &format!("{name} {seed}"));
        }
    }
}

#[test]
fn convex_polygons_become_fans() {
    for count in [5, 6, 17, 1000] {
        let circle = (0..count).map(|k| DVec2::from_angle(f64::from(k) / f64::from(count) * TAU).extend(0.0));
        let fan: Vec<[u32; 3]> = (1..count as u32 - 1).map(|k| [0, k, k + 1]).collect();
        assert_eq!(split(&circle.collect::<Vec<_>>()), fan);
    }
}

#[test]
fn quads_take_the_better_diagonal() {
    let flat = |points: [[f64; 2]; 4]| points.map(|[x, y]| DVec3::new(x, y, 0.0));
    let arrow = flat([[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]]);
    for first in 0..4 {
        let turned: Vec<DVec2> = (0..4).map(|k| arrow[(first + k) % 4].truncate()).collect();
        assert_split(&turned, |point| point.extend(0.0), "arrow");
    }
    let long = flat([[0.0, 0.0], [1.0, -0.1], [4.0, 0.0], [1.0, 0.1]]);
    for unit in [1.0, 1e-200, 1e200] {
        assert_eq!(split(&long.map(|point| point * unit)), [[1, 2, 3], [1, 3, 0]]);
    }
    // A square that is turned by rounding: always from the first corner.
    for step in 0..100 {
        let (sin, cos) = f64::from(step).sin_cos();
        let square = flat([[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]]);
        assert_eq!(split(&square), [[0, 1, 2], [0, 2, 3]]);
    }
}

#[test]
fn no_triangle_is_flat_where_corners_lie_on_sides() {
    let corners = [[0, 0], [2, 0], [4, 0], [6, 0], [4, 2], [2, 4], [0, 6], [0, 3]];
    let outline: Vec<DVec2> = corners.iter().map(|&[x, y]| DVec2::new(f64::from(x), f64::from(y))).collect();
    for seed in 0..CASES {
        let rng = &mut Rng::with_seed(seed);
        let mut outline = outline.clone();
        outline.rotate_left(seed as usize % 8);
        let place = random_place(rng);
        let points: Vec<DVec3> = outline.iter().map(|&point| place(point)).collect();
        for triangle in split(&points) {
            assert!(area(&triangle.map(|corner| outline[corner as usize])) > 0.5, "{seed}: {triangle:?}");
        }
    }
}

/// A warped polygon around a cylinder's side, whose projection along its mean normal folds over
/// nothing.
#[test]
fn warped_polygons_are_covered_once() {
    let at = |k: u32| DVec2::from_angle(f64::from(k) / 12.0 * TAU);
    let points: Vec<DVec3> = (0..12).map(at).map(|p| p.extend(0.4 * (p.x * p.x - p.y * p.y))).collect();
    for triangle in split(&points) {
        assert!(area(&triangle.map(|corner| points[corner as usize].truncate())) > 0.0);
    }
    for seed in 0..CASES {
        let rng = &mut Rng::with_seed(seed);
        let outline = star(rng);
        let lift: Vec<f64> = outline.iter().map(|_| 0.02 * rng.f64()).collect();
        let points: Vec<DVec3> = outline.iter().zip(lift).map(|(&point, lift)| point.extend(lift)).collect();
        let triangles = split(&points);
        assert_closes(points.len(), &triangles);
        let total: f64 = triangles.iter().map(|t| area(&t.map(|corner| outline[corner as usize])).abs()).sum();
        assert!((total / area(&outline) - 1.0).abs() < 1e-9, "{seed}");
    }
}

#[test]
fn polygons_that_cross_themselves_close() {
    let lattice = |rng: &mut Rng| DVec3::new(f64::from(rng.u8(0..4)), f64::from(rng.u8(0..4)), f64::from(rng.u8(0..4)));
    for seed in 0..CASES {
        let rng = &mut Rng::with_seed(seed);
        let points: Vec<DVec3> = (0..rng.usize(3..80)).map(|_| lattice(rng)).collect();
        assert_closes(points.len(), &split(&points));
    }
    let pentagram: Vec<DVec2> = (0..5).map(|k| DVec2::from_angle(f64::from(2 * k) / 5.0 * TAU)).collect();
    let triangles = split(&pentagram.iter().map(|p| p.extend(0.0)).collect::<Vec<_>>());
    assert_closes(5, &triangles);
}

#[test]
fn degenerate_points_give_all_triangles() {
    let line = |count: u32| (0..count).map(|k| DVec3::X * f64::from(k)).collect::<Vec<_>>();
    let cases = [
        vec![DVec3::ONE; 9],
        vec![DVec3::ZERO; 5000],
        line(50),
        line(3000),
        vec![DVec3::NAN; 70],
        vec![DVec3::NAN; 4],
        vec![DVec3::new(f64::INFINITY, 0.0, 1.0); 70],
        vec![DVec3::new(1e308, -1e308, 1e308); 6],
        vec![DVec3::splat(5e-324); 6],
        (0..200)
            .map(|k| DVec3::new(f64::from(k * k % 17) * 1e300, f64::from(k * 7 % 13) * -1e300, f64::from(k % 5)))
            .collect(),
        Vec::new(),
        line(2),
    ];
    for points in cases {
        split(&points);
    }
}

/// A comb of many teeth, and a star with random radii: longer than the search for overlaps takes.
#[test]
fn large_polygons_keep_their_area() {
    let count = 20_000;
    let rng = &mut Rng::with_seed(1);
    let comb = (0..count).map(|k| DVec2::new(f64::from(k / 2), if k % 2 == 0 { 0.5 } else { 1.0 }));
    let ends = [DVec2::new(f64::from(count), 0.0), DVec2::new(-1.0, 0.0)];
    let comb: Vec<DVec2> = comb.chain(ends).rev().collect();
    let star = |k: i32| DVec2::from_angle(f64::from(k) / f64::from(count) * TAU);
    let star: Vec<DVec2> = (0..count).map(|k| star(k) * (1.0 + rng.f64())).collect();
    for outline in [comb, star] {
        let triangles = split(&outline.iter().map(|p| p.extend(0.0)).collect::<Vec<_>>());
        let total: f64 = triangles.iter().map(|t| area(&t.map(|corner| outline[corner as usize])).abs()).sum();
        assert!((total / area(&outline) - 1.0).abs() < 1e-9, "{total} {}", area(&outline));
    }
    let points: Vec<DVec3> = (0..2000).map(|_| DVec3::new(rng.f64(), rng.f64(), 0.0)).collect();
    split(&points);
}

#[test]
fn taken_diagonals_are_avoided() {
    for seed in 0..CASES {
        let rng = &mut Rng::with_seed(seed);
        let outline = star(rng);
        let points: Vec<DVec3> = outline.iter().map(|p| p.extend(0.0)).collect();
        let n = points.len() as u32;
        let taken = (rng.u32(0..n), rng.u32(0..n));
        let is_taken = |u: u32, v: u32| (u, v) == taken || (v, u) == taken;
        if let Some(ears) = clip_ears(&points, &outline, &is_taken, &Job::default()).unwrap() {
            assert_closes(outline.len(), &ears);
            // The last three corners have no diagonal of their own.
            let sides = ears.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            let is_side = |u: u32, v: u32| (u + 1) % n == v || (v + 1) % n == u;
            assert!(!sides.clone().any(|[u, v]| is_taken(u, v) && !is_side(u, v)), "{seed}");
        }
    }
}
