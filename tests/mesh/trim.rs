//! Overlaps trimmed and joined: pieces of known surfaces, each sampled for itself and with noise.

use crate::common::{Soup, edge_counts, euler, faces_of, some_of};
use glam::{DMat3, DQuat, DVec3};
use gusset::Job;
use gusset::assemble::{self, Assembly, Overlaps, assemble};
use gusset::fill::{self, Keep};
use gusset::mesh::{Mesh, MeshView};
use gusset::trim::{self, trim};
use std::collections::{BTreeSet, HashMap};
use std::f64::consts::TAU;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Sphere,
    Torus,
    Sheet,
}

/// A sphere of radius 1 in some 5,000 triangles, turned by chance.
fn sphere(turn: DMat3) -> Soup {
    let t = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points: Vec<DVec3> = Vec::new();
    for (a, b) in [(1.0, t), (-1.0, t), (1.0, -t), (-1.0, -t)] {
        points.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    let edge = 2.0;
    let mut faces: Vec<[u32; 3]> = Vec::new();
    let near = |i: u32, j: u32| (points[i as usize].distance(points[j as usize]) - edge).abs() < 1e-9;
    for (i, j, k) in (0..12).flat_map(|i| (i + 1..12).flat_map(move |j| (j + 1..12).map(move |k| (i, j, k)))) {
        if near(i, j) && near(j, k) && near(i, k) {
            let [p, q, r] = [i, j, k].map(|v| points[v as usize]);
            let outward = (q - p).cross(r - p).dot(p) > 0.0;
            faces.push(if outward { [i, j, k] } else { [i, k, j] });
        }
    }
    for _ in 0..4 {
        let mut middles = HashMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in faces {
            let mut middle = |u: u32, v: u32| {
                *middles.entry([u.min(v), u.max(v)]).or_insert_with(|| {
                    points.push(points[u as usize].midpoint(points[v as usize]));
                    points.len() as u32 - 1
                })
            };
            let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]]);
        }
        faces = finer;
    }
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    soup.points = points.into_iter().map(|p| (turn * p.normalize()).to_array()).collect();
    faces.iter().for_each(|face| soup.face(face));
    soup
}

/// A grid of nodes over parameters, closed in both directions or in none.
fn grid(n: u32, m: u32, closed: bool, at: impl Fn(f64, f64) -> DVec3) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let (rows, columns) = if closed { (n, m) } else { (n + 1, m + 1) };
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        soup.points.push(at(f64::from(i) / f64::from(n), f64::from(j) / f64::from(m)).to_array());
    }
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        let v = |i: u32, j: u32| (i % rows) * columns + j % columns;
        soup.face(&[v(i, j), v(i + 1, j), v(i + 1, j + 1)]);
        soup.face(&[v(i, j), v(i + 1, j + 1), v(i, j + 1)]);
    }
    soup
}

/// Pieces of a surface that overlap: each is sampled for itself.
fn pieces(shape: Shape, count: usize, random: &mut fastrand::Rng) -> Vec<Soup> {
    let mut centres: Vec<DVec3> = Vec::new();
    let place = |random: &mut fastrand::Rng| match shape {
        Shape::Sphere => loop {
            let p = DVec3::new(random.f64(), random.f64(), random.f64()) * 2.0 - 1.0;
            if (0.1..1.0).contains(&p.length()) {
                break p.normalize();
            }
        },
        Shape::Torus => torus_at(random.f64(), random.f64()),
        Shape::Sheet => sheet_at(random.f64(), random.f64()),
    };
    // Far from each other: the best of some.
    while centres.len() < count {
        let least = |p: &DVec3| centres.iter().map(|c| c.distance(*p)).fold(f64::INFINITY, f64::min);
        let tried: Vec<DVec3> = (0..12).map(|_| place(random)).collect();
        let best = tried.iter().fold(tried[0], |best, p| if least(p) > least(&best) { *p } else { best });
        centres.push(best);
    }
    (0..count)
        .map(|k| {
            let [a, b, c] = [random.f64(), random.f64(), random.f64()];
            let turn = DMat3::from_quat(DQuat::from_euler(glam::EulerRot::XYZ, TAU * a, TAU * b, TAU * c));
            let finer = random.u32(0..12);
            let mut whole = match shape {
                Shape::Sphere => sphere(turn),
                Shape::Torus => grid(90 + finer, 36 + finer / 2, true, |s, t| torus_at(s + a, t + b)),
                // Over the same square, so that all have its border.
                Shape::Sheet => grid(60 + finer, 60 + finer, false, sheet_at),
            };
            let edge = 0.07;
            for p in &mut whole.points {
                let noise = DVec3::new(random.f64(), random.f64(), random.f64()) - 0.5;
                let at_border = shape == Shape::Sheet && (0..2).any(|k| p[k] == 0.0 || p[k] == 4.0);
                let size = if at_border { 0.0 } else { 0.2 * edge };
                *p = (DVec3::from_array(*p) + size * noise).to_array();
            }
            let overlap = 0.5;
            whole.part(|face| {
                let middle = whole.middle(face);
                let others = centres.iter().map(|c| c.distance(middle)).fold(f64::INFINITY, f64::min);
                centres[k].distance(middle) <= others + overlap
            })
        })
        .collect()
}

fn torus_at(s: f64, t: f64) -> DVec3 {
    let [(sin_s, cos_s), (sin_t, cos_t)] = [s, t].map(|x| (TAU * x).sin_cos());
    DVec3::new(cos_s * (1.0 + 0.4 * cos_t), sin_s * (1.0 + 0.4 * cos_t), 0.4 * sin_t)
}

fn sheet_at(s: f64, t: f64) -> DVec3 {
    let [x, y] = [4.0 * s, 4.0 * t];
    DVec3::new(x, y, 0.3 * (2.0 * x).sin() + 0.2 * (3.0 * y).cos())
}

fn joined(pieces: &[Soup], shape: Shape) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let keep = if shape == Shape::Sheet { Keep::OuterBorders } else { Keep::None };
    let options = assemble::Options {
        overlaps: Overlaps::Trim(trim::Options::default()),
        fill: Some(fill::Options { keep, ..fill::Options::default() }),
        weld: Some(Default::default()),
        ..Default::default()
    };
    assemble(&views, &options, &Job::default()).unwrap()
}

/// How many parts hang together by vertices.
fn components(mesh: &Mesh) -> usize {
    let mut parent: Vec<usize> = (0..mesh.positions.len()).collect();
    fn root(parent: &mut [usize], mut v: usize) -> usize {
        while parent[v] != v {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        v
    }
    for face in faces_of(mesh) {
        for &v in face {
            let [a, b] = [face[0], v].map(|v| root(&mut parent, v as usize));
            parent[a.max(b)] = a.min(b);
        }
    }
    let used: BTreeSet<usize> = mesh
        .face_corners
        .iter()
        .map(|&v| v as usize)
        .collect::<Vec<_>>()
        .into_iter()
        .map(|v| root(&mut parent, v))
        .collect();
    used.len()
}

#[test]
fn generated_overlaps_are_closed_or_bordered_as_the_truth() {
    let mut bad = 0;
    for seed in some_of(10, 0..200) {
        let mut random = fastrand::Rng::with_seed(seed);
        let shape = [Shape::Sphere, Shape::Torus, Shape::Sheet][seed as usize % 3];
        let count = 2 + random.usize(0..11);
        let pieces = pieces(shape, count, &mut random);
        let done = joined(&pieces, shape);
        let counts = edge_counts(faces_of(&done.mesh));
        let wrong = counts.values().filter(|&&(f, b)| f > 1 || b > 1).count();
        let euler = euler(faces_of(&done.mesh));
        let expected = match shape {
            Shape::Sphere => (0, 2),
            Shape::Torus => (0, 0),
            Shape::Sheet => (1, 1),
        };
        let components = components(&done.mesh);
        let good = (done.loops_left, euler) == expected && components == 1 && wrong == 0;
        if !good {
            println!("{seed} {shape:?} {count}: loops {} euler {euler} components {components}", done.loops_left);
        }
        bad += usize::from(!good);
    }
    assert_eq!(bad, 0);
}

#[test]
fn nothing_is_trimmed_where_nothing_overlaps() {
    let [one, two] = [sphere(DMat3::IDENTITY), sphere(DMat3::IDENTITY)];
    let mut apart = two.clone();
    apart.points.iter_mut().for_each(|p| p[0] += 2.5);
    let views = [one.view(), apart.view()];
    let trimmed = trim(&views, &trim::Options::default(), &Job::default()).unwrap();
    assert_eq!(trimmed.covered, [0, 0]);
    assert!(trimmed.kept.iter().all(|kept| kept.len() == one.faces().count()));
    // If one piece is given twice, one copy is kept whole.
    let views = [one.view(), two.view()];
    let trimmed = trim(&views, &trim::Options::default(), &Job::default()).unwrap();
    assert_eq!(trimmed.kept[0].len(), one.faces().count());
    assert!(trimmed.kept[1].is_empty());
}

/// A sheet whose outer border is filled by an intersecting patch loses no face; pieces that only
/// touch lose no face.
#[test]
fn what_was_seen_stays_where_nothing_overlaps() {
    let sheet = grid(27, 27, false, sheet_at);
    let done = joined(std::slice::from_ref(&sheet), Shape::Sphere);
    assert_eq!((done.trimmed_faces, done.loops_left), (0, 0));
    let half = |side: bool| grid(20, 40, false, |s, t| sheet_at(if side { 0.5 + s / 2.0 } else { s / 2.0 }, t));
    let [left, right] = [half(false), half(true)];
    let done = joined(&[left, right], Shape::Sheet);
    assert_eq!((done.trimmed_faces, done.loops_left, done.welded_vertices), (0, 1, 41));
    // A coarse piece on a fine piece is trimmed entirely, in either order.
    for n in [8, 16, 20, 30] {
        let coarse = grid(n, n, false, |s, t| sheet_at(0.3 + 0.4 * s, 0.3 + 0.4 * t));
        let fine = grid(150, 150, false, sheet_at);
        for views in [[coarse.view(), fine.view()], [fine.view(), coarse.view()]] {
            let trimmed = trim(&views, &trim::Options::default(), &Job::default()).unwrap();
            let least = trimmed.kept.iter().map(Vec::len).min();
            assert_eq!(least, Some(0), "{n}");
        }
    }
}
