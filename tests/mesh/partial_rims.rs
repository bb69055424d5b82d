//! Rims that coincide in part: whole loops that share edges or touch at vertices, and are apart elsewhere.

use crate::common::{Soup, edge_counts, euler, faces_of, some_of};
use gusset::Job;
use gusset::assemble::{self, Assembly, Outcome, assemble};
use gusset::mesh::{Mesh, MeshView};
use gusset::stitch::{self, Finish, Meridians, Request, Rows, Stitch, stitch};
use std::f64::consts::TAU;

/// A tube whose rim has the given angles, radii and heights, from there to the height `end`, where it is closed unless `open`.
fn cup(rim: &[[f64; 3]], end: f64, open: bool) -> Soup {
    let n = rim.len() as u32;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for ring in 0..4 {
        let share = f64::from(ring) / 4.0;
        for &[angle, radius, height] in rim {
            let z = height + share * (end - height);
            let radius = radius + share * (1.0 - radius);
            soup.points.push([radius * angle.cos(), radius * angle.sin(), z]);
        }
    }
    if !open {
        soup.points.push([0.0, 0.0, end]);
    }
    let up = end > 0.0;
    let mut add = |face: &[u32]| match up {
        true => soup.face(face),
        false => soup.face(&face.iter().rev().copied().collect::<Vec<_>>()),
    };
    for i in 0..n {
        let j = (i + 1) % n;
        for ring in 0..3 {
            let [from, to] = [ring * n, (ring + 1) * n];
            add(&[from + i, from + j, to + j]);
            add(&[from + i, to + j, to + i]);
        }
        if !open {
            add(&[3 * n + i, 3 * n + j, 4 * n]);
        }
    }
    soup
}

/// How two rims coincide.
#[derive(Clone, Debug)]
struct Case {
    /// The number of edges of the first rim.
    edges: usize,
    /// The places of the first rim where the second coincides: runs of first place and number of edges.
    common: Vec<(usize, usize)>,
    /// The vertices of the second rim for each vertex of the first between the runs.
    finer: usize,
    /// The height of the second rim above the first between the runs, in radii.
    gap: f64,
    /// True if the second rim rises gradually.
    ramp: bool,
    /// The radius of the second rim between the runs.
    flare: f64,
    /// True if the far ends of both tubes are open.
    open: bool,
    turned: [bool; 2],
}

fn random_case(random: &mut fastrand::Rng) -> Case {
    let edges = random.usize(18..60);
    let common = match random.u32(0..3) {
        // One shared run.
        0 => vec![(random.usize(0..edges), random.usize(1..edges * 3 / 4))],
        // Two shared runs, of which one may be a vertex.
        1 => {
            let first = random.usize(0..edges / 8);
            vec![
                (first, random.usize(0..edges / 4)),
                (edges / 2 + random.usize(0..edges / 8), random.usize(1..edges / 4)),
            ]
        }
        // One to three vertices.
        _ => (0..random.usize(1..4)).map(|k| (k * edges / 3 + random.usize(0..edges / 6), 0)).collect(),
    };
    let gap = 0.3 + 0.9 * random.f64();
    let (finer, ramp, turned) = (random.usize(1..3), random.bool(), [random.bool(), random.bool()]);
    Case { edges, common, finer, gap, ramp, flare: 0.8 + 0.4 * random.f64(), open: random.bool(), turned }
}

/// The two cups of a case.
fn cups(case: &Case) -> [Soup; 2] {
    let n = case.edges;
    let angle = |place: f64| TAU * place / n as f64;
    let first: Vec<[f64; 3]> = (0..n).map(|i| [angle(i as f64), 1.0, 0.0]).collect();
    let mut second = Vec::new();
    // The distance in places from the runs, along the gap that contains a place.
    let from_runs = |place: f64| {
        let apart = |&(start, edges): &(usize, usize)| {
            let offset = (place - start as f64).rem_euclid(n as f64);
            if offset <= edges as f64 { 0.0 } else { (offset - edges as f64).min(n as f64 - offset) }
        };
        case.common.iter().map(apart).fold(f64::INFINITY, f64::min)
    };
    for i in 0..n {
        let in_run = |place: f64| from_runs(place) == 0.0;
        let parts = if in_run(i as f64) && in_run(i as f64 + 0.5) { 1 } else { case.finer };
        for k in 0..parts {
            let place = i as f64 + k as f64 / parts as f64;
            let away = from_runs(place);
            let share = match case.ramp {
                _ if away == 0.0 => 0.0,
                true => (away / 4.0).min(1.0),
                false => 1.0,
            };
            second.push([angle(place), 1.0 + share * (case.flare - 1.0), share * case.gap]);
        }
    }
    let [below, above] = [cup(&first, -3.0, case.open), cup(&second, 4.0, case.open)];
    let turn = |soup: Soup, turned: bool| if turned { soup.turned() } else { soup };
    [turn(below, case.turned[0]), turn(above, case.turned[1])]
}

/// The number of faces without area.
fn flat_faces(mesh: &Mesh) -> usize {
    let at = |v: u32| mesh.positions.get(v);
    let is_flat = |face: &&[u32]| {
        let [p, q, r] = [at(face[0]), at(face[1]), at(face[2])];
        let longest = p.distance(q).max(q.distance(r)).max(r.distance(p));
        (q - p).cross(r - p).length() <= 1e-9 * longest * longest
    };
    faces_of(mesh).filter(is_flat).count()
}

fn joined(pieces: &[Soup], options: &assemble::Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

/// The faults of an assembly that should be one sphere, or one tube with two rims of `ends` edges in all.
fn faults(done: &Assembly, case: &Case, ends: usize) -> Vec<String> {
    let (loops, chi) = if case.open { (2, 0) } else { (0, 2) };
    let counts = edge_counts(faces_of(&done.mesh));
    let open = counts.values().filter(|&&counts| counts != (1, 1)).count();
    let checks = [
        (open != ends, format!("{open} edges are not shared by two faces")),
        (euler(faces_of(&done.mesh)) != chi, format!("Euler {}", euler(faces_of(&done.mesh)))),
        (
            done.loops_left != loops,
            format!(
                "{} loops: {:?}",
                done.loops_left,
                done.left.iter().map(|l| (l.reason, l.gap, l.allowed_gap)).collect::<Vec<_>>()
            ),
        ),
        (flat_faces(&done.mesh) > 0, format!("{} faces without area", flat_faces(&done.mesh))),
        (done.joints.iter().any(|joint| joint.outcome != Outcome::Joined), "a joint failed".into()),
    ];
    checks.into_iter().filter(|(wrong, _)| *wrong).map(|(_, text)| text).collect()
}

#[test]
fn rims_that_coincide_in_part_are_joined() {
    let mut bad = 0;
    for seed in some_of(5, 0..200) {
        let case = random_case(&mut fastrand::Rng::with_seed(seed));
        let pieces = cups(&case);
        let mut options = assemble::Options { weld: Some(Default::default()), ..Default::default() };
        options.strip.finish = if seed % 4 == 3 { Finish::Blend } else { Finish::Strip };
        let done = joined(&pieces, &options);
        let ends = if case.open { pieces.iter().map(|cup| cup.points.len() / 4).sum() } else { 0 };
        let faults = faults(&done, &case, ends);
        if !faults.is_empty() {
            println!("{seed} {case:?}: {faults:?}");
            bad += 1;
        }
    }
    assert_eq!(bad, 0);
}

const RULES: [Meridians; 8] = [
    Meridians::Continuation,
    Meridians::MinArea,
    Meridians::Index,
    Meridians::ArcLength,
    Meridians::Greedy,
    Meridians::MinDiagonal,
    Meridians::Smooth,
    Meridians::Quad,
];

/// The faults of a stitch of two cups, whose rims come first.
fn faults_of_stitch(done: &Stitch, case: &Case, pieces: &[Soup; 2]) -> Vec<String> {
    let counts = edge_counts(faces_of(&done.mesh));
    let open = counts.values().filter(|&&counts| counts != (1, 1)).count();
    let ends: usize = if case.open { pieces.iter().map(|cup| cup.points.len() / 4).sum() } else { 0 };
    let chi = if case.open { 0 } else { 2 };
    let common = |k: usize| {
        let other = &pieces[1 - k].points;
        pieces[k].points.iter().filter(|p| other.iter().any(|q| (0..3).all(|c| (p[c] - q[c]).abs() < 1e-12))).count()
    };
    let vertices = pieces.iter().map(|cup| cup.points.len()).sum::<usize>() - common(0);
    let moved = (0..2).any(|k| {
        let at = |v: u32| done.mesh.positions.get(v).to_array();
        let maps = pieces[k].points.iter().zip(&done.maps[k].vertices);
        maps.into_iter().any(|(p, &v)| (0..3).any(|c| (at(v)[c] - p[c]).abs() > 1e-12))
    });
    let steps = done.meridians.windows(2).all(|pair| {
        let by = [0, 1].map(|k| pair[1][k].wrapping_sub(pair[0][k]));
        by.iter().all(|&by| by < 2) && by != [0, 0]
    });
    let last = done.rims.each_ref().map(|rim| rim.len() as u32);
    let is_path = steps && done.meridians.first() == Some(&[0, 0]) && done.meridians.last() == Some(&last);
    let corners = |mesh: &Mesh, from: usize| -> Vec<glam::DVec3> {
        mesh.face_corners[mesh.face_offsets[from] as usize..].iter().map(|&v| mesh.positions.get(v)).collect()
    };
    let same_strip = corners(&done.strip, 0) == corners(&done.mesh, done.strip_faces.start as usize);
    let flat = flat_faces(&done.mesh);
    let checks = [
        (open != ends, format!("{open} edges are not shared by two faces")),
        (euler(faces_of(&done.mesh)) != chi, format!("Euler {}", euler(faces_of(&done.mesh)))),
        (done.mesh.positions.len() - done.parents.len() != vertices, format!("not {vertices} old vertices")),
        (flat > 0, format!("{flat} faces without area")),
        (moved, "a map names another place".into()),
        (!is_path, format!("meridians {:?}", done.meridians)),
        (!same_strip, "the strip differs from the faces of the mesh".into()),
    ];
    checks.into_iter().filter(|(wrong, _)| *wrong).map(|(_, text)| text).collect()
}

#[test]
fn rims_that_coincide_in_part_are_stitched_without_flat_faces() {
    for seed in some_of(3, 0..600) {
        let mut random = fastrand::Rng::with_seed(seed);
        let case = random_case(&mut random);
        let pieces = cups(&case);
        let mut options = stitch::Options { meridians: RULES[random.usize(0..8)], ..Default::default() };
        options.rows = if random.u32(0..4) == 0 { Rows::Count(2) } else { Rows::None };
        options.finish = if random.u32(0..4) == 0 { Finish::Blend } else { Finish::Strip };
        let loops = pieces.each_ref().map(|cup| {
            let rim = if case.open { cup.points.len() / 4 } else { (cup.points.len() - 1) / 4 } as u32;
            let mut rim: Vec<u32> = (0..rim).collect();
            let start = random.usize(0..rim.len());
            rim.rotate_left(start);
            if random.bool() {
                rim.reverse();
            }
            rim
        });
        let views = pieces.each_ref().map(Soup::view);
        let request = Request { a: &views[0], loop_a: Some(&loops[0]), b: Some(&views[1]), loop_b: Some(&loops[1]) };
        let done = stitch(&request, &options, &Job::default()).unwrap();
        let faults = faults_of_stitch(&done, &case, &pieces);
        assert!(faults.is_empty(), "{seed} {case:?} {:?}: {faults:?}", options.meridians);
    }
}
