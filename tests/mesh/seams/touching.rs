//! Borders that share points but not edges: surfaces of different detail, in any place, size and
//! orientation. They must become one surface without an edge, or a face, of no size.

use crate::common::{Soup, edge_counts, euler, faces_of, is_exhaustive};
use glam::{DMat3, DQuat, DVec3};
use gusset::Job;
use gusset::assemble::{Assembly, Options, Outcome, Selector, assemble};
use gusset::mesh::MeshView;
use std::collections::HashSet;
use std::f64::consts::TAU;

fn join(pieces: &[Soup], options: &Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

fn sewing() -> Options<'static> {
    Options { weld: Some(gusset::repair::weld::Options::default()), ..Options::default() }
}

/// A rotation, a unit from microns to kilometres, and a place.
pub(super) struct Pose(DMat3, DVec3);

impl Pose {
    pub(super) fn random(random: &mut fastrand::Rng) -> Pose {
        let mut number = || random.f64() - 0.5;
        let turn = DQuat::from_xyzw(number(), number(), number(), number()).normalize();
        let unit = 10f64.powf(9.0 * number());
        Pose(DMat3::from_quat(turn) * unit, 10.0 * unit * DVec3::new(number(), number(), number()))
    }

    pub(super) fn moved(&self, mut soup: Soup) -> Soup {
        soup.points.iter_mut().for_each(|p| *p = (self.0 * DVec3::from_array(*p) + self.1).to_array());
        soup
    }
}

/// The wall of a tube of `n` segments between two heights.
fn tube(n: u32, low: f64, high: f64) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for z in [low, high] {
        soup.points.extend((0..n).map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(n)).sin_cos();
            [cos, sin, z]
        }));
    }
    (0..n).for_each(|k| soup.face(&[k, (k + 1) % n, n + (k + 1) % n, n + k]));
    soup
}

/// A band of quads along the line x = 0, `width` wide, with these points on the line.
fn band(line: &[[f64; 3]], width: f64) -> Soup {
    let n = line.len() as u32;
    let beyond = line.iter().map(|&[x, y, z]| [x + width, y, z]);
    let mut soup = Soup::new(line.iter().copied().chain(beyond).collect(), &[]);
    for k in 0..n - 1 {
        let face = [k, k + 1, n + k + 1, n + k];
        soup.face(&if width < 0.0 { face } else { [face[3], face[2], face[1], face[0]] });
    }
    soup
}

/// Returns true if a joint between borders that share a single point failed, which is reported.
fn is_told(done: &Assembly, shared: u32) -> bool {
    shared == 1 && done.joints.iter().any(|joint| joint.outcome != Outcome::Joined)
}

/// Checks a manifold without faces of no area, of as many loops, vertices, and this characteristic.
fn assert_surface(done: &Assembly, [loops, vertices]: [usize; 2], characteristic: i64, name: &str) {
    assert_eq!(done.loops_left as usize, loops, "{name}: loops");
    let edges = edge_counts(faces_of(&done.mesh));
    assert!(
        edges.values().all(|&(there, back)| there < 2 && back < 2),
        "{name}: an edge is run twice in one direction"
    );
    assert_eq!(euler(faces_of(&done.mesh)), characteristic, "{name}: characteristic");
    let used: HashSet<u32> = done.mesh.face_corners.iter().copied().collect();
    assert_eq!((used.len(), done.mesh.positions.len()), (vertices, vertices), "{name}: vertices");
    let at = |v: u32| done.mesh.positions.get(v);
    for face in faces_of(&done.mesh) {
        let [p, q, r] = [face[0], face[1], face[2]].map(at);
        let size = (q - p).length().max((r - p).length());
        assert!((q - p).cross(r - p).length() > 1e-6 * size * size, "{name}: face {face:?}");
    }
    assert!(done.joints.iter().all(|joint| joint.outcome == Outcome::Joined), "{name}: {:?}", done.joints);
    assert!(done.left.iter().all(|left| !left.vertices.is_empty()), "{name}");
}

fn greatest_common_divisor(n: u32, m: u32) -> u32 {
    if m == 0 { n } else { greatest_common_divisor(m, n % m) }
}

fn cases() -> u64 {
    if is_exhaustive() { 2000 } else { 200 }
}

#[test]
fn tubes_of_different_segments() {
    let mut told = 0;
    for seed in 0..cases() {
        let mut random = fastrand::Rng::with_seed(seed);
        let (n, m) = (random.u32(3..40), random.u32(3..40));
        let pose = Pose::random(&mut random);
        let mut pieces = [pose.moved(tube(n, 0.0, 0.5 + random.f64())), pose.moved(tube(m, -0.5 - random.f64(), 0.0))];
        if random.bool() {
            pieces[1] = pieces[1].turned();
        }
        if random.bool() {
            pieces.swap(0, 1);
        }
        let shared = greatest_common_divisor(n, m);
        let done = join(&pieces, &sewing());
        if is_told(&done, shared) {
            told += 1;
            continue;
        }
        assert_surface(&done, [2, (2 * (n + m) - shared) as usize], 0, &format!("{seed}: {n} and {m} segments"));
        assert_eq!(done.mesh.face_count() as u32, n + m + if n == m { 0 } else { n + m - 2 * shared }, "{seed}");
    }
    assert!(told * 50 <= cases(), "{told} of {} tubes", cases());
}

#[test]
fn sheets_of_different_detail() {
    for seed in 0..cases() {
        let mut random = fastrand::Rng::with_seed(seed);
        let count = random.u32(3..30);
        let mut shared = vec![true; count as usize];
        let mut height = vec![0.0; count as usize];
        for k in 1..count as usize - 1 {
            shared[k] = random.u8(0..3) > 0 || (k > 3 && !shared[k - 3..k].contains(&true));
            height[k] = (0.1 + 0.2 * random.f64()) * if random.bool() { 1.0 } else { -1.0 };
        }
        let line: Vec<[f64; 3]> = (0..count as usize).map(|k| [0.0, k as f64, height[k]]).collect();
        let coarse: Vec<[f64; 3]> = (0..count as usize).filter(|&k| shared[k]).map(|k| line[k]).collect();
        let pose = Pose::random(&mut random);
        let width = 1.0 + 3.0 * random.f64();
        let mut pieces = [pose.moved(band(&line, width)), pose.moved(band(&coarse, -width))];
        if random.bool() {
            pieces[1] = pieces[1].turned();
        }
        if random.bool() {
            pieces.swap(0, 1);
        }
        let done = join(&pieces, &sewing());
        assert_surface(&done, [1, line.len() * 2 + coarse.len()], 1, &format!("{seed}: {shared:?}"));
    }
}

/// A tile of terrain of `n` x `n` cells, from `x`, `y` on.
fn tile(x: f64, y: f64, n: u32) -> Soup {
    let height = |x: f64, y: f64| 0.05 * (3.0 * x).sin() * (2.0 * y + 1.0).cos();
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let at = |i: u32, j: u32| j * (n + 1) + i;
    for j in 0..=n {
        for i in 0..=n {
            let [x, y] = [x + f64::from(i) / f64::from(n), y + f64::from(j) / f64::from(n)];
            soup.points.push([x, y, height(x, y)]);
        }
    }
    for j in 0..n {
        for i in 0..n {
            soup.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            soup.face(&[at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    soup
}

#[test]
fn tiles_of_terrain_with_levels_of_detail() {
    for seed in 0..cases() / 4 {
        let mut random = fastrand::Rng::with_seed(seed);
        let (columns, rows) = (random.usize(1..5), random.usize(1..5));
        let detail: Vec<u32> = (0..columns * rows).map(|_| 2 << random.u32(0..3)).collect();
        let pose = Pose::random(&mut random);
        let place = |k: usize| ((k % columns) as f64, (k / columns) as f64);
        let pieces: Vec<Soup> =
            (0..columns * rows).map(|k| pose.moved(tile(place(k).0, place(k).1, detail[k]))).collect();
        let done = join(&pieces, &sewing());
        // The points of all tiles: a finer border has the points of a coarser one.
        let own = |k: usize| ((detail[k] + 1) * (detail[k] + 1)) as usize;
        let mut vertices: usize = (0..columns * rows).map(own).sum();
        for k in 0..columns * rows {
            let mut seam = |other: usize| vertices -= detail[k].min(detail[other]) as usize + 1;
            if k % columns + 1 < columns {
                seam(k + 1);
            }
            if k / columns + 1 < rows {
                seam(k + columns);
            }
        }
        vertices += (columns - 1) * (rows - 1);
        assert_surface(&done, [1, vertices], 1, &format!("{seed}: {columns} x {rows}, {detail:?}"));
    }
}

#[test]
fn pairs_that_are_excluded_stay_apart() {
    let pieces = [tube(8, 0.0, 1.0), tube(12, -1.0, 0.0)];
    let excluded = [[Selector::piece(0), Selector::piece(1)]];
    let done = join(&pieces, &Options { excluded: &excluded, ..sewing() });
    assert_eq!((done.joints.len(), done.loops_left, done.mesh.positions.len()), (0, 4, 40));
}

/// Pieces that touch in single points only, and have wide openings between them, stay as they are.
#[test]
fn points_alone_join_nothing() {
    // Two sheets that touch at a corner.
    let corner = [tile(0.0, 0.0, 4), tile(1.0, 1.0, 4)];
    let done = join(&corner, &sewing());
    let joined = |done: &Assembly| done.joints.iter().filter(|joint| joint.outcome == Outcome::Joined).count();
    assert_eq!((joined(&done), done.loops_left, done.welded_vertices), (0, 2, 0));
    // Two halves of a frame that touch at both ends, around a square opening.
    let arm = |sign: f64| {
        let points = vec![[0.0, -1.0, 0.0], [sign, 0.0, 0.0], [0.0, 1.0, 0.0], [3.0 * sign, 0.0, 0.0]];
        Soup::new(points, if sign > 0.0 { &[&[0, 3, 1], &[1, 3, 2]] } else { &[&[0, 1, 3], &[1, 2, 3]] })
    };
    let done = join(&[arm(1.0), arm(-1.0)], &sewing());
    assert_eq!((joined(&done), done.welded_vertices), (0, 0));
}
