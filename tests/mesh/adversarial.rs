//! Joins difficult rims by every kind of strip. The result is always a valid surface, and the
//! reported intersections are true. Units, axes, vertex numbers and threads do not change the
//! result.

use crate::common::{Soup, Steady, edge_counts, euler, faces_of};

use gusset::Job;
use gusset::check::check;
use gusset::mesh::PositionBuffer;
use gusset::stitch::{Cells, Fairing, Intersections, Meridians, Options, Request, Rows, Start, Stitch, stitch};
use gusset_oracles::cuts::{Point, cut_pairs, have_area};
use proptest::prelude::*;
use std::collections::{BTreeSet, HashSet};
use std::f64::consts::TAU;

const ALL: [Meridians; 8] = [
    Meridians::Continuation,
    Meridians::Index,
    Meridians::ArcLength,
    Meridians::Greedy,
    Meridians::MinArea,
    Meridians::MinDiagonal,
    Meridians::Smooth,
    Meridians::Quad,
];

pub(crate) type P = [f64; 3];

/// A ring of faces behind a rim, whose vertices are the first ones.
#[derive(Clone)]
pub(crate) struct Shell {
    pub(crate) soup: Soup,
    pub(crate) rim: Vec<u32>,
}

pub(crate) fn shell(rim: &[P], back: impl Fn(P) -> P, split: bool) -> Shell {
    let n = rim.len() as u32;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    soup.points.extend(rim.iter().copied().chain(rim.iter().map(|&p| back(p))));
    for i in 0..n {
        let j = (i + 1) % n;
        if split {
            soup.face(&[i, j, n + i]);
            soup.face(&[j, n + j, n + i]);
        } else {
            soup.face(&[i, j, n + j, n + i]);
        }
    }
    Shell { soup, rim: (0..n).collect() }
}

pub(crate) fn ring(n: u32, point: impl Fn(f64) -> P) -> Vec<P> {
    (0..n).map(|i| point(TAU * f64::from(i) / f64::from(n))).collect()
}

fn moved([x, y, z]: P, by: P) -> P {
    [x + by[0], y + by[1], z + by[2]]
}

pub(crate) fn down(p: P) -> P {
    moved(p, [0.0, 0.0, -0.3])
}

pub(crate) fn up(p: P) -> P {
    moved(p, [0.0, 0.0, 0.3])
}

fn ellipse(t: f64, turn: f64, z: f64) -> P {
    let (x, y) = (2.0 * t.cos(), t.sin());
    [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), z]
}

/// A C: an arc of 300 degrees there and back.
fn letter_c(t: f64) -> P {
    let way = t / TAU * 2.0;
    let (r, s) = if way < 1.0 { (1.0, way) } else { (0.6, 2.0 - way) };
    let angle = TAU * (5.0 / 6.0 * s + 1.0 / 12.0);
    [r * angle.cos(), r * angle.sin(), 0.0]
}

/// Angles whose steps grow from 1 to 10^6.
fn uneven(n: u32, z: f64, turn: f64) -> Vec<P> {
    let step = |k: u32| 10f64.powf(6.0 * f64::from(k) / f64::from(n - 1));
    let total: f64 = (0..n).map(step).sum();
    let mut before = 0.0;
    let point = |k: u32| {
        let t = TAU * (before / total + turn);
        before += step(k);
        [t.cos(), t.sin(), z]
    };
    (0..n).map(point).collect()
}

pub(crate) fn cases() -> Vec<(&'static str, Shell, Shell)> {
    let circle = |r: f64, z: f64| move |t: f64| [r * t.cos(), r * t.sin(), z];
    let wavy = |k: f64, z: f64| move |t: f64| [t.cos(), t.sin(), z + 0.4 * (k * t).sin()];
    let radial = |by: f64| move |[x, y, z]: P| [x * by, y * by, z];
    vec![
        ("a C and a circle", shell(&ring(30, letter_c), down, false), shell(&ring(17, circle(1.0, 0.8)), up, false)),
        (
            "ellipses crossed at 60 degrees",
            shell(&ring(24, |t| ellipse(t, 0.0, 0.0)), down, false),
            shell(&ring(20, |t| ellipse(t, TAU / 6.0, 0.7)), up, true),
        ),
        ("wavy rims", shell(&ring(26, wavy(5.0, 0.0)), down, true), shell(&ring(31, wavy(4.0, 0.5)), up, false)),
        ("wild spacing", shell(&uneven(20, 0.0, 0.0), down, false), shell(&uneven(17, 0.6, 0.4), up, false)),
        ("few and many", shell(&ring(3, circle(1.0, 0.0)), down, false), shell(&ring(90, circle(1.1, 0.5)), up, false)),
        (
            "linked rings",
            shell(&ring(18, circle(1.0, 0.0)), radial(1.2), false),
            shell(&ring(16, |t| [1.0 + t.cos(), 0.1 * t.cos(), t.sin()]), |[x, y, z]| [x, y + 0.3, z], false),
        ),
        (
            "side by side in a plane",
            shell(&ring(14, circle(1.0, 0.0)), radial(0.7), false),
            shell(&ring(12, |t| [3.0 + t.cos(), t.sin(), 0.0]), |[x, y, z]| [0.7 * x + 0.9, 0.7 * y, z], true),
        ),
        (
            "concentric in a plane",
            shell(&ring(16, circle(1.0, 0.0)), radial(0.7), false),
            shell(&ring(23, circle(2.0, 0.0)), radial(1.3), false),
        ),
        (
            "the same rim",
            shell(&ring(12, circle(1.0, 0.0)), down, false),
            shell(&ring(12, circle(1.0, 0.0)), up, false),
        ),
    ]
}

pub(crate) fn join_with(a: &Shell, b: &Shell, options: &Options, job: &Job<'_>) -> Stitch {
    let (va, vb) = (a.soup.view(), b.soup.view());
    let request = Request { a: &va, loop_a: Some(&a.rim), b: Some(&vb), loop_b: Some(&b.rim) };
    stitch(&request, options, job).unwrap()
}

pub(crate) fn join(a: &Shell, b: &Shell, options: &Options) -> Stitch {
    join_with(a, b, options, &Job::default())
}

pub(crate) fn bits(positions: &PositionBuffer) -> Vec<[u64; 3]> {
    let PositionBuffer::F64(points) = positions else { panic!("single precision") };
    points.iter().map(|p| p.map(f64::to_bits)).collect()
}

/// The result is an oriented two-manifold with the Euler characteristic and loops of the pieces
/// minus the two rims. Old vertices are kept bit for bit, or merged; old faces are kept or reversed. No
/// coordinate is NaN, and each reported pair of faces exists once.
pub(crate) fn assert_valid(a: &Shell, b: &Shell, joined: &Stitch, what: &str) {
    assert!(edge_counts(faces_of(&joined.mesh)).values().all(|&(f, g)| f <= 1 && g <= 1), "{what}");
    let found = check(&joined.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.manifold && found.oriented && found.components == 1 && found.unused_vertices.is_empty(), "{what}");
    let walks = |s: &Shell| check(&s.soup.view(), &Job::default()).unwrap().boundary_walks;
    assert_eq!(found.boundary_walks, walks(a) + walks(b) - 2, "{what}");
    assert_eq!(euler(faces_of(&joined.mesh)), euler(a.soup.faces()) + euler(b.soup.faces()), "{what}");
    let quality = joined.quality;
    assert_eq!((quality.non_manifold_edges, quality.orientation_conflicts), (0, 0), "{what}");
    assert_eq!(quality.loops_left, found.boundary_walks, "{what}");

    let now = bits(&joined.mesh.positions);
    let maps = joined.maps.each_ref().map(|map| map.vertices.as_slice());
    for (soup, map) in [&a.soup, &b.soup].into_iter().zip(maps) {
        assert!(soup.points.iter().zip(map).all(|(p, &v)| p.map(f64::to_bits) == now[v as usize]), "{what}");
    }
    let old: HashSet<u32> = maps.concat().into_iter().collect();
    assert_eq!(old.len() + joined.parents.len(), now.len(), "{what}");
    assert!((0..now.len() as u32).all(|v| joined.mesh.positions.get(v).is_finite()), "{what}");
    let given = a.soup.faces().map(|f| (f, maps[0], false)).chain(b.soup.faces().map(|f| (f, maps[1], joined.turned)));
    for ((face, map, turned), found) in given.zip(faces_of(&joined.mesh)) {
        let mut expected: Vec<u32> = face.iter().map(|&v| map[v as usize]).collect();
        if turned {
            expected[1..].reverse();
        }
        assert_eq!(found, expected, "{what}");
    }
    assert!(quality.min_angle >= 0.0 && quality.max_aspect >= 1.0 && quality.area.is_finite(), "{what}: {quality:?}");

    let pairs = joined.intersections.as_ref().unwrap();
    assert!(pairs.windows(2).all(|w| w[0] < w[1]), "{what}: {pairs:?}");
    // A quad whose two triangles lie on one another cuts itself.
    let is_quad = |f: u32| joined.mesh.face_offsets[f as usize + 1] - joined.mesh.face_offsets[f as usize] == 4;
    let allowed = |&[f, g]: &[u32; 2]| joined.strip_faces.contains(&f) && (g < f || g == f && is_quad(f));
    assert!(pairs.iter().all(allowed), "{what}: {pairs:?}");
}

#[test]
fn every_way_gives_a_valid_surface() {
    for (name, a, b) in cases() {
        for meridians in ALL {
            for cells in [Cells::Triangles, Cells::Quads] {
                for rows in [0, 1, 4] {
                    let intersections = Intersections::Report;
                    let options =
                        Options { meridians, cells, rows: Rows::Count(rows), intersections, ..Options::default() };
                    let what = format!("{name}: {meridians:?} {cells:?} {rows}");
                    let straight = join(&a, &b, &options);
                    assert_valid(&a, &b, &straight, &what);
                    assert_eq!(straight.back_offs, 0);
                    let faired = join(&a, &b, &Options { fairing: Fairing::ThinPlate, ..options });
                    assert_valid(&a, &b, &faired, &what);
                    assert_eq!((&faired.meridians, &faired.matrix), (&straight.meridians, &straight.matrix));
                    // Fairing makes no cuts that were not there: it is taken back.
                    let count = |joined: &Stitch| joined.intersections.as_ref().unwrap().len();
                    assert!(count(&faired) <= count(&straight), "{what}: {} {}", count(&faired), count(&straight));
                    if rows == 0 {
                        assert_eq!(faired, straight, "{what}");
                    }
                }
            }
        }
    }
}

#[test]
fn rims_apart_and_convex_are_joined_without_cuts() {
    for (name, a, b) in cases() {
        let plain = ["few and many", "ellipses crossed at 60 degrees"].contains(&name);
        for meridians in [Meridians::MinArea, Meridians::MinDiagonal, Meridians::Quad] {
            for fairing in [Fairing::None, Fairing::ThinPlate] {
                let options = Options {
                    meridians,
                    fairing,
                    rows: Rows::Count(3),
                    intersections: Intersections::Report,
                    ..Options::default()
                };
                let joined = join(&a, &b, &options);
                assert!(!plain || joined.intersections == Some(vec![]), "{name} {meridians:?} {fairing:?}");
            }
        }
    }
}

#[test]
fn three_against_three_thousand() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin(), z]);
    // Every triangle of a fan is near every other one: few ways will do.
    for (n, m, ways) in [(3, 3000, &[Meridians::MinArea][..]), (3000, 3, &[Meridians::Quad]), (3, 200, &ALL)] {
        let (a, b) = (shell(&circle(n, 0.0), down, false), shell(&circle(m, 1.0), up, false));
        for &meridians in ways {
            let options = Options {
                meridians,
                rows: Rows::Count(1),
                fairing: Fairing::ThinPlate,
                intersections: Intersections::Report,
                ..Options::default()
            };
            assert_valid(&a, &b, &join(&a, &b, &options), &format!("{n} {m} {meridians:?}"));
        }
    }
}

/// All pairs of triangles with an area that cut, one of them at least of the strip, and the
/// library's own without the others.
fn compare_cuts(joined: &Stitch, unit: f64) -> (BTreeSet<[u32; 2]>, BTreeSet<[u32; 2]>) {
    let at = |v: u32| -> Point {
        joined.mesh.positions.get(v).to_array().map(|x| {
            assert_eq!((x * unit).fract(), 0.0);
            (x * unit) as i64
        })
    };
    let triangles: Vec<[Point; 3]> = faces_of(&joined.mesh).map(|f| <[u32; 3]>::try_from(f).unwrap().map(at)).collect();
    let has_area = have_area(&triangles);
    let pairs = joined.intersections.iter().flatten().copied();
    let found = pairs.filter(|pair| pair.iter().all(|&f| has_area[f as usize])).collect();
    (found, cut_pairs(&triangles, joined.strip_faces.clone()).into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(150) })]

    #[test]
    fn cuts_equal_brute_force(
        a in prop::collection::vec(prop::array::uniform3(-9i32..10), 3..9),
        b in prop::collection::vec(prop::array::uniform3(-9i32..10), 3..9),
        backs in prop::array::uniform2(prop::array::uniform3(-9i32..10)),
        flat in 0..8,
    ) {
        let rim = |points: &[[i32; 3]]| points.iter().map(|p| {
            [f64::from(p[0]), f64::from(p[1]), if flat == 0 { 0.0 } else { f64::from(p[2]) }]
        }).collect::<Vec<P>>();
        let back = |k: usize| move |p: P| moved(p, backs[k].map(f64::from));
        let (a, b) = (shell(&rim(&a), back(0), true), shell(&rim(&b), back(1), true));
        for meridians in ALL {
            for rows in [0, 1, 3] {
                let intersections = Intersections::Report;
                let options = Options { meridians, rows: Rows::Count(rows), intersections, ..Options::default() };
                let joined = join(&a, &b, &options);
                assert_valid(&a, &b, &joined, &format!("{meridians:?} {rows} {:?}", joined.meridians));
                let (found, expected) = compare_cuts(&joined, 4.0);
                prop_assert_eq!(found, expected, "{:?} {}", meridians, rows);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    /// On a small lattice most rims touch: they have one point in common, or more.
    #[test]
    fn rims_that_touch_give_valid_surfaces(
        a in prop::collection::vec(prop::array::uniform3(-2i32..3), 3..7),
        b in prop::collection::vec(prop::array::uniform3(-2i32..3), 3..7),
        is_flat: bool,
    ) {
        let rim = |points: &[[i32; 3]]| -> Vec<P> {
            points.iter().map(|&[x, y, z]| [x, y, if is_flat { 0 } else { z }].map(f64::from)).collect()
        };
        let (a, b) = (shell(&rim(&a), down, true), shell(&rim(&b), up, true));
        for meridians in ALL {
            for cells in [Cells::Triangles, Cells::Quads] {
                let intersections = Intersections::Report;
                let options = Options { meridians, cells, intersections, ..Options::default() };
                let joined = join(&a, &b, &options);
                assert_valid(&a, &b, &joined, &format!("{meridians:?} {cells:?} {:?}", joined.meridians));
            }
        }
    }
}

#[test]
fn the_better_of_two_starts_is_kept() {
    let area = |a: &Shell, b: &Shell, start| {
        join(a, b, &Options { start, meridians: Meridians::MinArea, ..Options::default() }).quality.area
    };
    for (name, a, b) in cases() {
        let (auto, closest) = (area(&a, &b, Start::Auto), area(&a, &b, Start::Closest));
        assert!(auto <= closest * (1.0 + 1e-5), "{name}: {auto} {closest}");
    }
    // One vertex of A comes near B in a wrong place, a third of a turn away; numbers tell nothing
    // of the places.
    for shift in [0, 7, 20] {
        let circle = |z: f64| ring(30, |t| [t.cos(), 0.8 * t.sin(), z + 0.2 * (3.0 * t).sin()]);
        let (mut low, mut high) = (circle(0.0), circle(0.6));
        low[10] = high[20].map(|x| 0.98 * x);
        low.rotate_left(3);
        high.rotate_left(shift);
        let (a, b) = (shell(&low, down, false), shell(&high, up, false));
        let (auto, closest) = (area(&a, &b, Start::Auto), area(&a, &b, Start::Closest));
        assert!(auto < 0.99 * closest, "{shift}: {auto} {closest}");
    }
}

/// Rims on which nothing is as near as anything else.
pub(crate) fn generic() -> (Shell, Shell) {
    let jitter = |k: f64, s: f64| 0.03 * (s * 12.9898 * (k + 1.0)).sin();
    let a = ring(37, |t| [t.cos() + jitter(t, 1.0), t.sin() + jitter(t, 2.0), jitter(t, 7.0)]);
    let b = ring(29, |t| {
        let t = t + 0.7;
        [1.1 * t.cos() + jitter(t, 3.0), t.sin() + jitter(t, 5.0), 0.9 + 0.3 * (2.0 * t).sin() + jitter(t, 4.0)]
    });
    (shell(&a, down, false), shell(&b, up, true))
}

pub(crate) fn ways() -> impl Iterator<Item = Options> {
    ALL.into_iter().flat_map(|meridians| {
        [(0, Fairing::None), (2, Fairing::None), (3, Fairing::ThinPlate)].map(|(rows, fairing)| Options {
            meridians,
            fairing,
            rows: Rows::Count(rows),
            intersections: Intersections::Report,
            ..Options::default()
        })
    })
}

#[test]
fn units_that_are_powers_of_two_change_no_bit() {
    let (a, b) = generic();
    for options in ways() {
        let expected = join(&a, &b, &options);
        for power in [-320, -31, 1, 40, 320] {
            let unit = 2f64.powi(power);
            let scaled = |s: &Shell| {
                let mut s = s.clone();
                s.soup.points.iter_mut().flatten().for_each(|x| *x *= unit);
                s
            };
            let mut found = join(&scaled(&a), &scaled(&b), &options);
            for mesh in [&mut found.mesh, &mut found.strip] {
                let PositionBuffer::F64(points) = &mut mesh.positions else { panic!("single precision") };
                points.iter_mut().flatten().for_each(|x| *x /= unit);
            }
            found.quality.max_edge /= unit;
            found.quality.area = found.quality.area / unit / unit;
            assert_eq!(found, expected, "{power} {options:?}");
        }
    }
}

#[test]
fn turning_the_axes_changes_no_face() {
    let (a, b) = generic();
    for options in ways() {
        let expected = join(&a, &b, &options);
        for turn in [1, 2] {
            let turned = |s: &Shell| {
                let mut s = s.clone();
                s.soup.points.iter_mut().for_each(|p| p.rotate_left(turn));
                s
            };
            let found = join(&turned(&a), &turned(&b), &options);
            assert_eq!(found.mesh.face_corners, expected.mesh.face_corners, "{options:?}");
            assert_eq!((&found.meridians, &found.intersections), (&expected.meridians, &expected.intersections));
            for v in 0..found.mesh.positions.len() as u32 {
                let mut p = expected.mesh.positions.get(v).to_array();
                p.rotate_left(turn);
                let q = found.mesh.positions.get(v).to_array();
                let off = p.iter().zip(q).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                assert!(off <= if options.fairing == Fairing::None { 0.0 } else { 1e-12 }, "{off} {options:?}");
            }
        }
    }
}

#[test]
fn other_numbers_give_the_same_strip() {
    let (a, b) = generic();
    // Vertex v becomes 31 v mod count; the rim from another place, and backwards.
    let renumbered = |s: &Shell, first: usize, backwards: bool| {
        let count = s.soup.points.len() as u32;
        let name = |v: u32| 31 * v % count;
        let mut other = Soup { points: vec![[0.0; 3]; count as usize], offsets: vec![0], ..Soup::default() };
        (0..count).for_each(|v| other.points[name(v) as usize] = s.soup.points[v as usize]);
        let faces: Vec<&[u32]> = s.soup.faces().collect();
        faces.iter().rev().for_each(|face| other.face(&face.iter().map(|&v| name(v)).collect::<Vec<_>>()));
        let mut rim: Vec<u32> = s.rim.iter().map(|&v| name(v)).collect();
        rim.rotate_left(first);
        if backwards {
            rim.reverse();
        }
        Shell { soup: other, rim }
    };
    // Columns of matrix P by the bits of their positions, independent of vertex numbers.
    let columns = |joined: &Stitch| -> BTreeSet<Vec<[u64; 3]>> {
        let (all, count) = (bits(&joined.mesh.positions), joined.meridians.len());
        let column = |k: usize| joined.matrix[k..].iter().step_by(count).map(|&v| all[v as usize]).collect();
        (0..count).map(column).collect()
    };
    for options in ways().filter(|options| options.fairing == Fairing::None) {
        let options = Options { start: Start::Closest, ..options };
        let expected = join(&a, &b, &options);
        for (first, backwards) in [(0, false), (11, false), (5, true)] {
            let (a, b) = (renumbered(&a, first, backwards), renumbered(&b, 2 * first, !backwards));
            let found = join(&a, &b, &options);
            assert_eq!(columns(&found), columns(&expected), "{first} {options:?}");
            let count = |joined: &Stitch| joined.intersections.as_ref().map(Vec::len);
            assert_eq!(count(&found), count(&expected));
        }
    }
}

#[test]
fn the_threads_change_no_bit() {
    let circle = |n: u32, z: f64| ring(n, |t| [t.cos(), t.sin() + 0.2 * (3.0 * t).sin(), z + 0.2 * (5.0 * t).cos()]);
    let large = (shell(&circle(1600, 0.0), down, false), shell(&circle(1500, 1.0), up, false));
    let many = [(generic(), &ALL[..]), (large, &[Meridians::Smooth])];
    for ((a, b), ways_of) in &many {
        for options in ways().filter(|o| o.fairing == Fairing::ThinPlate && ways_of.contains(&o.meridians)) {
            let options = Options { rows: Rows::Count(1), ..options };
            let one = join_with(a, b, &options, &Job::new(1, &Steady::default()));
            for threads in [2, 7] {
                let other = join_with(a, b, &options, &Job::new(threads, &Steady::default()));
                assert_eq!(bits(&other.mesh.positions), bits(&one.mesh.positions), "{threads} {options:?}");
                assert_eq!(other, one, "{threads} {options:?}");
            }
        }
    }
}
