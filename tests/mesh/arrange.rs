//! The union of solids: volumes by formula and by inclusion and exclusion, winding numbers of random
//! points, and results that are manifold, do not intersect themselves, and stay as they are.

use crate::common::{Silent, Soup, Steady, StopAt, cap, edge_counts, euler, faces_of, some_of, torus, volume};
use glam::{DQuat, DVec3};
use gusset::arrange::{Options, Union, split_intersecting_faces, unite};
use gusset::check::find_intersecting_faces;
use gusset::mesh::{Faces, Mesh, MeshView, NONE, Positions};
use gusset::solid::unite_solids;
use gusset::{Error, Job};
use std::f64::consts::TAU;

/// The box between two corners, of quads that look outwards.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Soup {
    let corner = |k: usize| [0, 1, 2].map(|j| if k >> j & 1 == 1 { high[j] } else { low[j] });
    let faces: [&[u32]; 6] = [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]];
    Soup::new((0..8).map(corner).collect(), &faces)
}

/// The unit sphere, of `rings` rings of `n` vertices.
fn ball(n: u32, rings: u32) -> Soup {
    // The cap ends at a small circle, which a face closes.
    let mut soup = cap(n, rings, -0.9, 1.0);
    let first = soup.points.len() as u32 - n;
    soup.face(&(0..n).rev().map(|i| first + i).collect::<Vec<_>>());
    soup
}

/// All faces split into triangles that fan out from their first corners.
fn in_triangles(soup: &Soup) -> Soup {
    let mut split = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
    for face in soup.faces() {
        (1..face.len() - 1).for_each(|k| split.face(&[face[0], face[k], face[k + 1]]));
    }
    split
}

fn moved(soup: &Soup, place: impl Fn(DVec3) -> DVec3) -> Soup {
    Soup { points: soup.points.iter().map(|&p| place(DVec3::from_array(p)).to_array()).collect(), ..soup.clone() }
}

fn direction(random: &mut fastrand::Rng) -> DVec3 {
    loop {
        let p = DVec3::from_array([0; 3].map(|_| random.f64() - 0.5));
        if (0.01..0.25).contains(&p.length_squared()) {
            return p.normalize();
        }
    }
}

fn volume_of(soup: &Soup) -> f64 {
    volume(|v| soup.points[v as usize], soup.faces())
}

fn volume_of_mesh(mesh: &Mesh) -> f64 {
    volume(|v| mesh.positions.get(v).to_array(), faces_of(mesh))
}

/// Unites, and checks all that holds for every result.
fn checked_union(soup: &Soup) -> Union {
    let job = Job::default();
    let view = soup.view();
    let made = unite(&view, &Options::default(), &job).unwrap();
    assert!(made.intersections.is_empty(), "{} rounds", made.round_count);
    let edges = edge_counts(faces_of(&made.mesh));
    assert!(edges.values().all(|&counts| counts == (1, 1)), "closed, manifold and oriented");
    let result = made.mesh.view(&job).unwrap();
    assert_eq!(find_intersecting_faces(&result, &job).unwrap(), Vec::<[u32; 2]>::new());
    // Around each vertex the faces form one fan.
    let mut around = vec![Vec::new(); made.mesh.positions.len()];
    for [a, b, c] in faces_of(&made.mesh).map(|t| [t[0], t[1], t[2]]) {
        around[a as usize].push([b, c]);
        around[b as usize].push([c, a]);
        around[c as usize].push([a, b]);
    }
    for sides in &around {
        let (mut end, mut length) = (sides[0][1], 1);
        while end != sides[0][0] {
            end = sides.iter().find(|side| side[0] == end).unwrap()[1];
            length += 1;
        }
        assert_eq!(length, sides.len(), "one fan");
    }
    // Origins.
    for (v, &origin) in (0..).zip(&made.vertex_origins) {
        if origin != NONE {
            assert_eq!(made.mesh.positions.get(v).to_array(), soup.points[origin as usize]);
        }
    }
    let mut faces: Vec<u32> = made.face_origins.iter().chain(&made.dropped_faces).copied().collect();
    faces.sort_unstable();
    faces.dedup();
    assert_eq!(faces.len(), soup.faces().count(), "each face is an origin or dropped");
    assert!(made.dropped_faces.iter().all(|face| !made.face_origins.contains(face)));
    // A second run changes nothing.
    let again = unite(&result, &Options::default(), &job).unwrap();
    assert_eq!(again.mesh, made.mesh);
    assert_eq!((again.round_count, again.intersection_count, again.dropped_faces.len()), (0, 0, 0));
    made
}

/// The winding number of a point, by the sum of solid angles (van Oosterom and Strackee 1983).
fn winding(soup: &Soup, p: DVec3) -> f64 {
    let mut sum = 0.0;
    for face in in_triangles(soup).faces() {
        let [a, b, c] = [0, 1, 2].map(|k| DVec3::from_array(soup.points[face[k] as usize]) - p);
        let [x, y, z] = [a.length(), b.length(), c.length()];
        sum += 2.0 * a.dot(b.cross(c)).atan2(x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
    }
    sum / (2.0 * TAU)
}

/// Boxes with corners on a small lattice: coplanar, touching, nested, equal. The volume is the number
/// of covered cells.
#[test]
fn boxes_of_a_lattice_cover_cells() {
    for seed in some_of(8, 0..800u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let (mut soup, mut covered) = (Soup { offsets: vec![0], ..Soup::default() }, [false; 64]);
        for _ in 0..random.usize(1..7) {
            let low = [0; 3].map(|_| random.usize(0..3));
            let high = low.map(|x| random.usize(x + 1..5));
            let [a, b] = [low, high].map(|corner| corner.map(|x| x as f64));
            soup = soup.and(&in_triangles(&cuboid(a, b)));
            for (cell, covered) in covered.iter_mut().enumerate() {
                let place = [cell % 4, cell / 4 % 4, cell / 16];
                *covered |= (0..3).all(|k| low[k] <= place[k] && place[k] < high[k]);
            }
        }
        let made = checked_union(&soup);
        let cells = covered.iter().filter(|&&cell| cell).count() as f64;
        assert!((volume_of_mesh(&made.mesh) - cells).abs() < 1e-9, "seed {seed}");
        // Coordinates are halves at most where diagonals of faces cross, and parts lie in their faces.
        for (face, &origin) in faces_of(&made.mesh).zip(&made.face_origins) {
            let given = &soup.corners[3 * origin as usize..][..3];
            let [a, b, c] = [0, 1, 2].map(|k| DVec3::from_array(soup.points[given[k] as usize]));
            let normal = (b - a).cross(c - a);
            let [p, q, r] = [0, 1, 2].map(|k| made.mesh.positions.get(face[k]));
            assert!([p, q, r].iter().all(|p| (*p - a).dot(normal).abs() < 1e-12), "seed {seed}");
            assert!((q - p).cross(r - p).dot(normal) > 0.0, "seed {seed}: oriented like its face");
        }
    }
}

fn random_solid(random: &mut fastrand::Rng) -> Soup {
    let shape = match random.u32(0..3) {
        0 => in_triangles(&ball(random.u32(3..14), random.u32(2..8))),
        1 => moved(&in_triangles(&torus(random.u32(3..14), random.u32(3..9))), |p| p * 0.4),
        _ => in_triangles(&cuboid([-0.7; 3], [0.6, 0.8, 0.5])),
    };
    let turn = DQuat::from_axis_angle(direction(random), random.f64() * TAU);
    let shift = direction(random) * random.f64();
    moved(&shape, |p| turn * p + shift)
}

/// With a box D around both: the union of D - A and D - B is D less the intersection of A and B, and
/// the volumes of union and intersection add up to the volumes of A and B.
#[test]
fn union_and_intersection_add_up() {
    for seed in some_of(20, 0..1000u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let a = random_solid(&mut random);
        let b = match seed % 4 {
            0 => {
                let turn = DQuat::from_axis_angle(direction(&mut random), 10f64.powf(-2.0 - 14.0 * random.f64()));
                moved(&a, |p| turn * p)
            }
            1 => {
                let shift = direction(&mut random) * 10f64.powf(-16.0 * random.f64());
                moved(&a, |p| p + shift)
            }
            _ => random_solid(&mut random),
        };
        let domain = in_triangles(&cuboid([-4.0; 3], [4.0; 3]));
        let union = volume_of_mesh(&checked_union(&a.and(&b)).mesh);
        let parts = domain.and(&a.turned()).and(&domain).and(&b.turned());
        let intersection = 512.0 - volume_of_mesh(&checked_union(&parts).mesh);
        let (sum, expected) = (union + intersection, volume_of(&a) + volume_of(&b));
        assert!((sum - expected).abs() < 1e-9, "seed {seed}: {sum} instead of {expected}");
        assert!(union > volume_of(&a).max(volume_of(&b)) - 1e-9, "seed {seed}");
    }
}

/// A point is in the result where the input's winding number is at least 1, also for solids that are
/// turned inside out, and surfaces that cut themselves.
#[test]
fn points_are_inside_where_the_winding_number_is_positive() {
    for seed in some_of(8, 0..80u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut soup = random_solid(&mut random);
        for _ in 0..random.u32(1..5) {
            let next = random_solid(&mut random);
            soup = soup.and(&if random.u32(0..3) == 0 { next.turned() } else { next });
        }
        let made = checked_union(&soup);
        let PointsAndFaces(result) = PointsAndFaces::from_mesh(&made.mesh);
        for _ in 0..40 {
            let p = direction(&mut random) * 1.8 * random.f64();
            let [before, after] = [winding(&soup, p), winding(&result, p)];
            assert!((before - before.round()).abs() < 1e-6 && (after - after.round()).abs() < 1e-6);
            assert_eq!(after.round(), f64::from(before.round() >= 1.0), "seed {seed}, {p}: {before}");
        }
    }
}

struct PointsAndFaces(Soup);

impl PointsAndFaces {
    fn from_mesh(mesh: &Mesh) -> Self {
        let points = (0..mesh.positions.len() as u32).map(|v| mesh.positions.get(v).to_array()).collect();
        PointsAndFaces(Soup { points, offsets: mesh.face_offsets.clone(), corners: mesh.face_corners.clone() })
    }
}

#[test]
fn cavities_stay_and_solids_inside_go() {
    let outer = in_triangles(&cuboid([0.0; 3], [4.0; 3]));
    let inner = in_triangles(&cuboid([1.0; 3], [2.0; 3]));
    let hollow = checked_union(&outer.and(&inner.turned()));
    assert_eq!((hollow.mesh.face_count(), hollow.dropped_faces.len()), (24, 0));
    assert!((volume_of_mesh(&hollow.mesh) - 63.0).abs() < 1e-12);
    let filled = checked_union(&outer.and(&inner));
    assert_eq!(filled.dropped_faces, (12..24).collect::<Vec<_>>());
    // Turned inside out, the whole has no inside.
    let none = unite(&outer.turned().view(), &Options::default(), &Job::default()).unwrap();
    assert_eq!((none.mesh.face_count(), none.dropped_faces.len()), (0, 12));
    // Boxes that touch in an edge or a corner stay apart, with vertices of their own.
    for (corner, shared) in [([4.0, 4.0, 0.0], 2), ([4.0; 3], 1)] {
        let touching = outer.and(&in_triangles(&cuboid(corner, corner.map(|x| x + 4.0))));
        let mut one_name = touching.clone();
        for v in &mut one_name.corners {
            *v = touching.points.iter().position(|p| *p == touching.points[*v as usize]).unwrap() as u32;
        }
        for soup in [touching, one_name] {
            let made = checked_union(&soup);
            assert_eq!((made.mesh.positions.len(), euler(faces_of(&made.mesh))), (16, 4), "{shared} shared");
        }
    }
}

#[test]
fn far_faces_keep_their_vertices() {
    let a = in_triangles(&ball(24, 14));
    let b = moved(&a, |p| p + DVec3::new(1.7, 0.1, 0.0));
    let soup = a.and(&b);
    let made = checked_union(&soup);
    let mut kept = 0;
    for (face, &origin) in faces_of(&made.mesh).zip(&made.face_origins) {
        let given = &soup.corners[3 * origin as usize..][..3];
        let vertices: Vec<u32> = face.iter().map(|&v| made.vertex_origins[v as usize]).collect();
        kept += usize::from(vertices == given);
    }
    assert!(kept > soup.faces().count() * 3 / 4, "{kept}");
    assert!(made.intersection_count > 20);
}

#[test]
fn any_magnitude_is_exact() {
    let a = in_triangles(&torus(9, 6));
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let both = a.and(&moved(&a, |p| turn * p + DVec3::new(0.3, 0.2, 0.1)));
    let expected = checked_union(&both);
    for exponent in [-1020, -300, 490] {
        let scale = f64::powi(2.0, exponent);
        let made = checked_union(&moved(&both, |p| p * scale));
        assert_eq!(made.mesh.face_corners, expected.mesh.face_corners, "2^{exponent}");
    }
    // Single precision.
    let points: Vec<[f32; 3]> = both.points.iter().map(|p| p.map(|x| x as f32)).collect();
    let faces = Faces::polygons(&both.offsets, &both.corners).unwrap();
    let view = MeshView::new(Positions::from(points.as_slice()), faces, &Job::default()).unwrap();
    let made = unite(&view, &Options::default(), &Job::default()).unwrap();
    assert!(made.intersections.is_empty());
    let result = made.mesh.view(&Job::default()).unwrap();
    assert!(find_intersecting_faces(&result, &Job::default()).unwrap().is_empty());
    assert!((volume_of_mesh(&made.mesh) - volume_of_mesh(&expected.mesh)).abs() < 1e-4);
}

#[test]
fn mistakes_are_refused() {
    let job = Job::default();
    let closed = in_triangles(&cuboid([0.0; 3], [1.0; 3]));
    let mut open = closed.clone();
    open.corners.truncate(33);
    open.offsets.truncate(12);
    assert!(matches!(unite(&open.view(), &Options::default(), &job), Err(Error::MeshNotClosed { .. })));
    let mut turned = closed.clone();
    turned.corners[3..6].reverse();
    assert!(matches!(unite(&turned.view(), &Options::default(), &job), Err(Error::MeshNotClosed { .. })));
    let options = Options { max_rounds: 0 };
    let refused = unite(&closed.view(), &options, &job);
    assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "max_rounds", .. })));
}

/// Pieces keep their quads where no other meets them, and vertices and faces are numbered piece after piece.
#[test]
fn solids_are_united_piece_by_piece() {
    let job = Job::default();
    for seed in some_of(10, 0..200u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let pieces: Vec<Soup> = (0..random.usize(1..5))
            .map(|_| {
                let low = [0; 3].map(|_| random.f64());
                cuboid(low, low.map(|x| x + 0.1 + random.f64()))
            })
            .collect();
        let all = pieces.iter().fold(Soup { offsets: vec![0], ..Soup::default() }, |all, piece| all.and(piece));
        let views: Vec<_> = pieces.iter().map(Soup::view).collect();
        let made = unite_solids(&views, &job).unwrap();
        assert!(made.is_valid(), "seed {seed}");
        let expected = unite(&all.view(), &Options::default(), &job).unwrap();
        assert!((volume_of_mesh(&made.mesh) - volume_of_mesh(&expected.mesh)).abs() < 1e-12, "seed {seed}");
        let dropped: Vec<u32> = made.dropped.iter().map(|dropped| dropped.face).collect();
        assert_eq!(dropped, expected.dropped_faces, "seed {seed}");
        for (v, &origin) in (0..).zip(&made.vertex_origin).filter(|&(_, &origin)| origin != NONE) {
            assert_eq!(made.mesh.positions.get(v).to_array(), all.points[origin as usize], "seed {seed}");
        }
        let faces: Vec<&[u32]> = all.faces().collect();
        let met = find_intersecting_faces(&all.view(), &job).unwrap();
        for (face, &origin) in faces_of(&made.mesh).zip(&made.face_origin) {
            let kept: Vec<u32> = face.iter().map(|&v| made.vertex_origin[v as usize]).collect();
            if !met.as_flattened().contains(&origin) {
                assert_eq!(kept, faces[origin as usize], "seed {seed}: a face that meets none");
            }
        }
    }
    let (closed, mut open) = (cuboid([0.0; 3], [1.0; 3]), cuboid([0.5; 3], [1.5; 3]));
    open.corners.truncate(20);
    open.offsets.truncate(6);
    let refused = unite_solids(&[closed.view(), closed.view(), open.view()], &job);
    assert!(matches!(refused, Err(Error::MeshNotClosed { input: 2, face: 0..5 })));
    // A piece that coincides with a part of a closed one; two that close each other.
    let first_of = |faces: std::ops::Range<usize>| {
        let faces: Vec<&[u32]> = closed.faces().skip(faces.start).take(faces.len()).collect();
        Soup::new(closed.points.clone(), &faces)
    };
    let (start, rest) = (first_of(0..3), first_of(3..closed.faces().count()));
    let refused = unite_solids(&[closed.view(), start.view()], &job);
    assert!(matches!(refused, Err(Error::MeshNotClosed { input: 1, .. })));
    let refused = unite_solids(&[closed.view(), start.view(), rest.view()], &job);
    assert!(matches!(refused, Err(Error::MeshNotClosed { input: 1, .. })));
    assert!(matches!(unite_solids(&[], &job), Err(Error::EmptyMesh { .. })));
}

/// Faces without an area, and faces that appear twice in opposite directions, enclose nothing.
#[test]
fn flat_faces_enclose_nothing() {
    let solid = in_triangles(&cuboid([0.0; 3], [2.0; 3]));
    let mut soup = solid.clone();
    let first = soup.points.len() as u32;
    soup.points.extend([[-1.0, 1.0, 1.0], [3.0, 1.0, 1.0], [1.0, 3.0, 1.5], [1.0, 1.0, 1.0]]);
    for face in [[0, 1, 2], [2, 1, 0], [0, 1, 3], [3, 1, 0], [0, 0, 1], [1, 0, 0]] {
        soup.face(&face.map(|v| v + first));
    }
    let made = checked_union(&soup);
    assert!((volume_of_mesh(&made.mesh) - 8.0).abs() < 1e-12);
    assert!(made.dropped_faces.ends_with(&[12, 13, 14, 15, 16, 17]));
}

#[test]
fn jobs_are_heard_and_threads_do_not_matter() {
    let a = in_triangles(&ball(15, 9));
    let soup = a.and(&moved(&a, |p| p * 0.9 + DVec3::new(0.2, 0.3, 0.1))).and(&a);
    let view = soup.view();
    let expected = unite(&view, &Options::default(), &Job::new(1, &Steady::default())).unwrap();
    assert_eq!(unite(&view, &Options::default(), &Job::new(3, &Silent)).unwrap(), expected);
    let mut cancelled = 0;
    for report in 0..2000 {
        match unite(&view, &Options::default(), &Job::new(1, &StopAt::new(report))) {
            Err(error) => assert_eq!(error, Error::Cancelled),
            Ok(made) => {
                assert_eq!(made, expected);
                break;
            }
        }
        cancelled += 1;
    }
    assert!((20..2000).contains(&cancelled), "{cancelled}");
}

/// Splitting keeps every point of every face: areas of parts add up, and parts of open, unoriented and
/// repeated faces meet in common vertices and edges only, or coincide.
#[test]
fn split_faces_cover_the_faces() {
    let job = Job::default();
    for seed in some_of(8, 0..400u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let is_lattice = seed % 2 == 0;
        let point = |random: &mut fastrand::Rng| {
            [0; 3].map(|_| if is_lattice { f64::from(random.u32(0..4)) } else { random.f64() })
        };
        let count = random.u32(6..18);
        let mut soup =
            Soup { points: (0..count).map(|_| point(&mut random)).collect(), offsets: vec![0], ..Soup::default() };
        for _ in 0..random.u32(2..30) {
            let [a, b, c] = [0; 3].map(|_| random.u32(0..count));
            if a != b && b != c && c != a {
                soup.face(&[a, b, c]);
            }
        }
        if soup.offsets.len() < 3 {
            continue;
        }
        let view = soup.view();
        let made = split_intersecting_faces(&view, &Options::default(), &job).unwrap();
        assert!(made.intersections.is_empty(), "seed {seed}");
        let corner = |v: u32| made.mesh.positions.get(v);
        let area = |[a, b, c]: [DVec3; 3]| 0.5 * (b - a).cross(c - a).length();
        let mut areas = vec![0.0; soup.faces().count()];
        for (face, &origin) in faces_of(&made.mesh).zip(&made.face_origins) {
            let part = [0, 1, 2].map(|k| corner(face[k]));
            let given = &soup.corners[3 * origin as usize..][..3];
            let whole = [0, 1, 2].map(|k| DVec3::from_array(soup.points[given[k] as usize]));
            let normal = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
            assert!(area(part) < 1e-12 || normal(part).dot(normal(whole)) > 0.0, "seed {seed}: oriented alike");
            areas[origin as usize] += area(part);
        }
        for (face, sum) in soup.faces().zip(&areas) {
            let whole = area([0, 1, 2].map(|k| DVec3::from_array(soup.points[face[k] as usize])));
            assert!((sum - whole).abs() < 1e-9, "seed {seed}: {sum} instead of {whole}");
        }
        let result = made.mesh.view(&job).unwrap();
        let first = &made.first_coincident;
        let crossing = |&[s, t]: &[u32; 2]| first[s as usize] != first[t as usize];
        assert!(!find_intersecting_faces(&result, &job).unwrap().iter().any(crossing), "seed {seed}");
        (0..soup.points.len()).for_each(|v| assert_eq!(corner(v as u32).to_array(), soup.points[v]));
    }
}

/// Two wedges that share both ends of an edge, one sheet each, have no edge in common.
#[test]
fn doubled_edges_are_split() {
    // A ring of four boxes that touch in one edge, closed to a ring above and below it.
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for [low, high] in [
        [[0.0, 0.0, 0.0], [1.0, 1.0, 3.0]],
        [[1.0, 1.0, 0.0], [2.0, 2.0, 3.0]],
        [[0.0, 0.0, 3.0], [2.0, 2.0, 4.0]],
        [[0.0, 0.0, -1.0], [2.0, 2.0, 0.0]],
    ] {
        soup = soup.and(&in_triangles(&cuboid(low, high)));
    }
    let made = checked_union(&soup);
    assert!((volume_of_mesh(&made.mesh) - 14.0).abs() < 1e-12);
}
