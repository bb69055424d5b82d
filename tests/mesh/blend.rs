//! Blends: the surface is nearer to the original than the strip, its triangles are as fine as the
//! surfaces beside it and not sharp, and every property of a strip holds for a blend.

use crate::adversarial::{Shell, assert_valid, cases, join, join_with, ring, shell, up};
use crate::answers::Notes;
use crate::common::{Soup, Steady, cap, edge_counts, faces_of, sheet};
use gusset::Job;
use gusset::mesh::{Faces, MeshView, PositionBuffer, Positions};
use gusset::stitch::facing::Arc;
use gusset::stitch::{
    Cells, Extent, Fairing, Finish, Intersections, Meridians, Options, Request, Rows, Stitch, stitch,
};

const BLEND: Options = Options { finish: Finish::Blend, ..OPTIONS };
const OPTIONS: Options = Options {
    meridians: Meridians::Continuation,
    search: gusset::stitch::MeridianSearch::Auto,
    start: gusset::stitch::Start::Auto,
    orientation: gusset::stitch::Orientation::Fix,
    twist: 0,
    extent: Extent::WholeLoops,
    run: gusset::stitch::facing::Run::Closest,
    tolerance: None,
    centres: gusset::stitch::facing::Centres::Vertices,
    rows: Rows::None,
    cells: Cells::Triangles,
    fairing: Fairing::None,
    finish: Finish::Strip,
    intersections: Intersections::Auto,
    outward: gusset::repair::orient::Outward::Keep,
};

fn both(a: &Soup, b: &Soup, options: &Options) -> Stitch {
    let (a, b) = (a.view(), b.view());
    stitch(&Request { a: &a, loop_a: None, b: Some(&b), loop_b: None }, options, &Job::default()).unwrap()
}

fn new_vertices(joined: &Stitch) -> Vec<[f64; 3]> {
    let first = joined.maps.iter().map(|map| map.vertices.len()).sum::<usize>() as u32;
    (first..joined.mesh.positions.len() as u32).map(|v| joined.mesh.positions.get(v).to_array()).collect()
}

/// The largest angle between neighbouring faces, one of them new, in degrees.
fn sharpest_bend(joined: &Stitch) -> f64 {
    let normal = |face: &[u32]| {
        let at = |k: usize| joined.mesh.positions.get(face[k]);
        (1..face.len() - 1).map(|k| (at(k) - at(0)).cross(at(k + 1) - at(0))).sum::<glam::DVec3>().normalize()
    };
    let mut sides = std::collections::HashMap::new();
    let mut most: f64 = 0.0;
    for (f, face) in faces_of(&joined.mesh).enumerate() {
        for (k, &u) in face.iter().enumerate() {
            let v = face[(k + 1) % face.len()];
            let before = sides.insert((u.min(v), u.max(v)), (f, normal(face)));
            if let Some((_, other)) = before.filter(|&(g, _)| f.max(g) as u32 >= joined.strip_faces.start) {
                most = most.max(normal(face).angle_between(other).to_degrees());
            }
        }
    }
    most
}

fn polygons(soup: &Soup) -> Faces<'_> {
    Faces::polygons(&soup.offsets, &soup.corners).unwrap()
}

fn radius_off([x, y, z]: [f64; 3]) -> f64 {
    (x.hypot(y).hypot(z) - 1.0).abs()
}

#[test]
fn the_ball_that_was_there_comes_back() {
    for (n, m, rims) in [(24, 31, [0.3, 0.25]), (40, 18, [0.5, 0.1]), (64, 60, [0.2, 0.2])] {
        let (a, b) = (cap(n, n / 4, rims[0], 1.0), cap(m, m / 4, rims[1], -1.0));
        let strip = both(&a, &b, &OPTIONS);
        let blend = both(&a, &b, &BLEND);
        assert_eq!((blend.quality.loops_left, blend.intersections.as_deref()), (0, Some(&[][..])), "{n} {m}");
        // The strip's edges across the gap are chords.
        let middle = |[i, j]: [u32; 2]| {
            let at = |rim: &[u32], k: u32| strip.mesh.positions.get(rim[k as usize % rim.len()]);
            at(&strip.rims[0], i).midpoint(at(&strip.rims[1], j)).to_array()
        };
        let worst = |points: &[[f64; 3]]| points.iter().map(|&p| radius_off(p)).fold(0.0, f64::max);
        let chords = worst(&strip.meridians.iter().map(|&pair| middle(pair)).collect::<Vec<_>>());
        let found = worst(&new_vertices(&blend));
        assert!(found < 0.25 * chords, "{n} {m}: {found} {chords}");
        // Old edges are between 0.1 and 0.4 long here; the rims bend by up to 20 degrees themselves.
        assert!(blend.quality.min_angle.to_degrees() > 15.0, "{n} {m}: {:?}", blend.quality);
        assert!(sharpest_bend(&blend) < 40.0, "{n} {m}: {}", sharpest_bend(&blend));
    }
}

#[test]
fn a_tube_stays_round_between_its_ends() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    let long_up = |[x, y, z]: [f64; 3]| [x, y, z + 0.2];
    let long_down = |[x, y, z]: [f64; 3]| [x, y, z - 0.2];
    for (n, m) in [(24, 24), (36, 17), (120, 40)] {
        let (a, b) = (shell(&circle(n, 0.0), long_down, false), shell(&circle(m, 0.8), long_up, false));
        let blend = join(&a, &b, &BLEND);
        assert_valid(&a, &b, &blend, "tube");
        for p in new_vertices(&blend) {
            // The rims are polygons: their sides are this much inside the circle.
            let inside = 1.0 - (std::f64::consts::PI / f64::from(n.min(m))).cos();
            assert!((p[0].hypot(p[1]) - 1.0).abs() < inside + 0.01, "{n} {m}: {p:?}");
            assert!(p[2] > 0.0 && p[2] < 0.8, "{p:?}");
        }
    }
}

/// However wide the gap is, no neck: a flat plate would be narrower by a quarter across three radii,
/// and closed across six.
#[test]
fn wide_gaps_are_bridged_by_tubes() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    for (n, m, widest) in [(24, 24, 80.0), (48, 35, 20.0)] {
        let gaps = [(0.5, 0.03), (2.0, 0.05), (4.0, 0.07), (6.0, 0.08), (10.0, 0.12), (20.0, 0.15), (80.0, 0.2)];
        for (gap, share) in gaps.into_iter().filter(|&(gap, _)| gap <= widest) {
            let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.2];
            let (a, b) = (shell(&circle(n, 0.0), down, false), shell(&circle(m, gap), up, false));
            let joined = join(&a, &b, &BLEND);
            assert_valid(&a, &b, &joined, "tube");
            let raise = |mut soup: Soup| {
                soup.points.iter_mut().for_each(|p| p[2] += gap);
                soup
            };
            let bowls = both(&cap(n, n / 4, 0.0, -1.0), &raise(cap(m, m / 4, 0.0, 1.0)), &BLEND);
            for (name, blend, most) in [("tube", &joined, share), ("bowls", &bowls, share + 0.12)] {
                assert_eq!(blend.intersections.as_deref(), Some(&[][..]), "{name} {n} {m} {gap}");
                for p in new_vertices(blend) {
                    let off = p[0].hypot(p[1]) - 1.0;
                    assert!((-share..most).contains(&off), "{name} {n} {m} {gap}: {p:?} {off}");
                }
            }
        }
    }
}

/// Ducts of three to six sides: triangles go round them in a few steps, and the blend keeps its width.
#[test]
fn ducts_of_few_sides_are_bridged() {
    for n in 3..=6 {
        // Three sides are too few to go far.
        for gap in [1.0, 3.0, 6.0].into_iter().take(if n == 3 { 2 } else { 3 }) {
            let circle = |z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
            let down = |[x, y, z]: [f64; 3]| [x, y, z - 1.0];
            let high = |[x, y, z]: [f64; 3]| [x, y, z + 1.0];
            let (a, b) = (shell(&circle(0.0), down, false), shell(&circle(gap), high, false));
            let blend = join(&a, &b, &BLEND);
            assert_valid(&a, &b, &blend, "duct");
            assert_eq!(blend.intersections.as_deref(), Some(&[][..]), "{n} {gap}");
            let inside = (std::f64::consts::PI / f64::from(n)).cos();
            for p in new_vertices(&blend) {
                assert!((0.6 * inside..1.3).contains(&p[0].hypot(p[1])), "{n} {gap}: {p:?}");
            }
        }
    }
}

/// A gap that would take very many vertices stays with its strip, quickly; the answer says so.
#[test]
fn far_too_wide_gaps_stay_with_the_strip() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.2];
    for gap in [1e4, 1e7, 1e12] {
        let (a, b) = (shell(&circle(40, 0.0), down, false), shell(&circle(30, gap), up, false));
        let notes = Notes::default();
        let [va, vb] = [a.soup.view(), b.soup.view()];
        let request = Request { a: &va, loop_a: Some(&a.rim), b: Some(&vb), loop_b: Some(&b.rim) };
        let joined = stitch(&request, &BLEND, &Job::new(1, &notes)).unwrap();
        assert_valid(&a, &b, &joined, "far");
        assert_eq!((joined.finish, new_vertices(&joined).len()), (Finish::Strip, 0));
        assert!(notes.0.borrow().iter().any(|note| note.contains("too many vertices")), "{gap}");
    }
}

#[test]
fn in_a_plane_it_covers_what_the_strip_covers_once() {
    let circle = |n: u32, r: f64| ring(n, |t| [r * t.cos(), r * t.sin(), 0.0]);
    let radial = |by: f64| move |[x, y, z]: [f64; 3]| [x * by, y * by, z];
    // The right side of a sheet and the left one of another.
    let mut offset = sheet(6, 4);
    offset.points.iter_mut().for_each(|p| p[0] += 8.5);
    let border: Vec<u32> =
        [6, 13, 20, 27].into_iter().chain((29..=34).rev()).chain([28, 21, 14, 7]).chain(0..6).collect();
    let [sheet_a, sheet_b] = [sheet(6, 4), offset].map(|soup| Shell { soup, rim: border.clone() });
    let arcs = [Arc { first: 0, count: 5 }, Arc { first: 10, count: 5 }];
    let arcs = Options { extent: Extent::Arcs(arcs), ..OPTIONS };
    let (inner, outer) = (shell(&circle(16, 1.0), radial(0.7), false), shell(&circle(23, 2.0), radial(1.3), false));
    let pairs = [
        (join(&inner, &outer, &OPTIONS), join(&inner, &outer, &BLEND)),
        (join(&sheet_a, &sheet_b, &arcs), join(&sheet_a, &sheet_b, &Options { finish: Finish::Blend, ..arcs })),
    ];
    for (strip, blend) in &pairs {
        assert!(new_vertices(blend).len() > 3, "{:?}", blend.quality);
        assert!(new_vertices(blend).iter().all(|p| p[2].abs() < 1e-12));
        assert!((blend.quality.area / strip.quality.area - 1.0).abs() < 1e-12, "{:?}", blend.quality);
        assert_eq!(blend.quality.loops_left, strip.quality.loops_left);
        assert!(sharpest_bend(blend) < 1e-6);
        assert_eq!((&blend.meridians, &blend.rims, blend.rows), (&strip.meridians, &strip.rims, 0));
    }
}

#[test]
fn sides_are_as_long_as_those_round_it() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    for (n, m) in [(30, 30), (30, 120), (200, 40)] {
        let back =
            |n: u32, sign: f64| move |[x, y, z]: [f64; 3]| [x, y, z + sign * std::f64::consts::TAU / f64::from(n)];
        let (a, b) = (shell(&circle(n, 0.0), back(n, -1.0), true), shell(&circle(m, 1.5), back(m, 1.0), true));
        let blend = join(&a, &b, &BLEND);
        assert_valid(&a, &b, &blend, "sides");
        let longest = std::f64::consts::TAU / f64::from(n.min(m));
        assert!(blend.quality.max_edge < 2.0 * longest, "{n} {m}: {} {longest}", blend.quality.max_edge);
        assert!(blend.quality.min_angle.to_degrees() > 20.0, "{n} {m}: {:?}", blend.quality);
    }
    // Neighbours of very different lengths on the rims: graded between.
    let uneven = |n: u32, z: f64| ring(n, |t| [(t + 0.9 * t.sin()).cos(), (t + 0.9 * t.sin()).sin(), z]);
    let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.2];
    let (a, b) = (shell(&uneven(60, 0.0), down, true), shell(&uneven(47, 0.7), up, true));
    let blend = join(&a, &b, &BLEND);
    assert!(blend.quality.min_angle.to_degrees() > 10.0, "{:?}", blend.quality);
}

#[test]
fn diagonals_of_polygons_are_no_sides() {
    // Two discs, each one face: the strip between is refined to their sides.
    let disc = |z: f64, up: bool| {
        let points = ring(60, |t| [t.cos(), t.sin(), z]);
        let rim: Vec<u32> = (0..60).collect();
        let face: Vec<u32> = if up { rim.clone() } else { rim.iter().rev().copied().collect() };
        Shell { soup: Soup::new(points, &[&face]), rim }
    };
    let blend = join(&disc(0.0, false), &disc(0.6, true), &BLEND);
    assert_eq!(blend.quality.loops_left, 0);
    assert!(blend.quality.max_edge < 0.25, "{:?}", blend.quality);
}

#[test]
fn every_pair_of_rims_gives_a_valid_surface() {
    for (name, a, b) in cases() {
        let strip = join(&a, &b, &OPTIONS);
        let blend = join(&a, &b, &BLEND);
        assert_valid(&a, &b, &blend, name);
        let same = blend.strip.face_corners == strip.strip.face_corners;
        assert!(strip.finish == Finish::Strip && (same || blend.finish == Finish::Blend), "{name}");
        // The strip is kept where the blend would cut more.
        let cuts = |joined: &Stitch| joined.intersections.as_ref().unwrap().len();
        assert!(cuts(&blend) <= cuts(&strip), "{name}: {} {}", cuts(&blend), cuts(&strip));
        let ignored = join(&a, &b, &Options { intersections: Intersections::Ignore, ..BLEND });
        assert_eq!(ignored.intersections, None);
        assert_eq!(
            (blend.parents.len(), blend.weights.len()),
            (new_vertices(&blend).len(), new_vertices(&blend).len())
        );
        for (parents, weights) in blend.parents.iter().zip(&blend.weights) {
            // Corners of a triangle of the strip: of both rims.
            assert!(blend.rims.iter().all(|rim| parents.iter().any(|parent| rim.contains(parent))), "{name}");
            assert!(parents.iter().all(|parent| blend.rims.iter().any(|rim| rim.contains(parent))), "{name}");
            assert!(weights.iter().all(|&w| w >= 0.0) && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{name}");
        }
    }
}

#[test]
fn neither_threads_nor_units_change_it_and_single_precision_does_little() {
    let (a, b) = (cap(24, 6, 0.3, 1.0), cap(31, 7, 0.25, -1.0));
    let expected = both(&a, &b, &BLEND);
    let (va, vb) = (a.view(), b.view());
    let request = Request { a: &va, loop_a: None, b: Some(&vb), loop_b: None };
    for threads in [1, 2, 7] {
        assert_eq!(stitch(&request, &BLEND, &Job::new(threads, &Steady::default())).unwrap(), expected);
    }
    for power in [-300, -20, 20, 300] {
        let unit = 2f64.powi(power);
        let scaled = |soup: &Soup| {
            let mut soup = soup.clone();
            soup.points.iter_mut().flatten().for_each(|x| *x *= unit);
            soup
        };
        let found = both(&scaled(&a), &scaled(&b), &BLEND);
        assert_eq!(found.mesh.face_corners, expected.mesh.face_corners);
        let back = |v: u32| found.mesh.positions.get(v) / unit;
        assert!((0..found.mesh.positions.len() as u32).all(|v| back(v) == expected.mesh.positions.get(v)), "{power}");
    }
    let points = |soup: &Soup| -> Vec<[f32; 3]> { soup.points.iter().map(|p| p.map(|x| x as f32)).collect() };
    let (pa, pb) = (points(&a), points(&b));
    let [va, vb] = [(&pa, &a), (&pb, &b)]
        .map(|(points, soup)| MeshView::new(Positions::from(&points[..]), polygons(soup), &Job::default()).unwrap());
    let single =
        stitch(&Request { a: &va, loop_a: None, b: Some(&vb), loop_b: None }, &BLEND, &Job::default()).unwrap();
    assert!(matches!(single.mesh.positions, PositionBuffer::F32(_)));
    assert_eq!((single.quality.loops_left, single.intersections.as_deref()), (0, Some(&[][..])));
    assert!(new_vertices(&single).iter().all(|&p| radius_off(p) < 0.01));
}

#[test]
fn a_corner_of_a_rim_in_a_hundred_thousandth_of_the_others_is_no_trouble() {
    // Each third vertex has a neighbour at 1e-5 of an edge.
    let doubled = |n: u32, z: f64| -> Vec<[f64; 3]> {
        let at = |t: f64| [t.cos(), t.sin(), z + 0.1 * (3.0 * t).sin()];
        let step = std::f64::consts::TAU / f64::from(n);
        (0..n)
            .flat_map(|i| {
                let t = step * f64::from(i);
                [Some(at(t)), (i % 3 == 0).then(|| at(t + 1e-5 * step))]
            })
            .flatten()
            .collect()
    };
    let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.2];
    let (a, b) = (shell(&doubled(30, 0.0), down, true), shell(&doubled(36, 0.6), up, true));
    let blend = join(&a, &b, &BLEND);
    assert_valid(&a, &b, &blend, "doubled");
    assert_eq!(blend.intersections.as_deref(), Some(&[][..]));
    assert!(new_vertices(&blend).len() < 3000, "{}", new_vertices(&blend).len());
    assert!(sharpest_bend(&blend) < 60.0, "{}", sharpest_bend(&blend));
}

#[test]
fn what_a_blend_does_not_read_is_noted() {
    let (a, b) = (cap(12, 3, 0.3, 1.0), cap(12, 3, 0.3, -1.0));
    let (va, vb) = (a.view(), b.view());
    let request = Request { a: &va, loop_a: None, b: Some(&vb), loop_b: None };
    let expected = both(&a, &b, &BLEND);
    for (options, count) in [
        (BLEND, 0),
        (Options { rows: Rows::Count(3), ..BLEND }, 1),
        (Options { cells: Cells::Quads, ..BLEND }, 1),
        (Options { fairing: Fairing::ThinPlate, ..BLEND }, 1),
    ] {
        let notes = Notes::default();
        let found = stitch(&request, &options, &Job::new(1, &notes)).unwrap();
        assert_eq!(notes.0.borrow().len(), count, "{options:?}");
        assert_eq!(found, expected, "{options:?}");
    }
}

#[test]
fn other_measures_of_meridians_lead_to_blends_too() {
    let wavy = |n: u32, k: f64, z: f64| ring(n, |t| [t.cos(), t.sin(), z + 0.2 * (k * t).sin()]);
    let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.3];
    let (a, b) = (shell(&wavy(40, 3.0, 0.0), down, true), shell(&wavy(33, 2.0, 1.0), up, false));
    for meridians in [Meridians::MinArea, Meridians::Index, Meridians::Greedy, Meridians::Smooth, Meridians::Quad] {
        let blend = join(&a, &b, &Options { meridians, ..BLEND });
        assert_valid(&a, &b, &blend, &format!("{meridians:?}"));
        assert_eq!(blend.intersections.as_deref(), Some(&[][..]), "{meridians:?}");
    }
}

#[test]
fn a_host_can_cancel_it() {
    struct Until(std::cell::Cell<u32>);
    impl gusset::Progress for Until {
        fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
            self.0.set(self.0.get().saturating_sub(1));
            if self.0.get() == 0 { std::ops::ControlFlow::Break(()) } else { std::ops::ControlFlow::Continue(()) }
        }
    }
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    let down = |[x, y, z]: [f64; 3]| [x, y, z - 0.1];
    let (a, b): (Shell, Shell) = (shell(&circle(60, 0.0), down, true), shell(&circle(70, 0.8), up, true));
    let count = Until(std::cell::Cell::new(u32::MAX));
    join_with(&a, &b, &BLEND, &Job::new(1, &count));
    let steps = u32::MAX - count.0.get();
    let (va, vb) = (a.soup.view(), b.soup.view());
    let request = Request { a: &va, loop_a: Some(&a.rim), b: Some(&vb), loop_b: Some(&b.rim) };
    for at in 1..=steps {
        let until = Until(std::cell::Cell::new(at));
        assert_eq!(stitch(&request, &BLEND, &Job::new(1, &until)).unwrap_err(), gusset::Error::Cancelled, "{at}");
    }
    assert!(edge_counts(a.soup.faces()).len() > 100);
}
