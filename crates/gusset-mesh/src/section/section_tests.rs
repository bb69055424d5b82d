//! Sections against independent truth: exact integers, volumes, analytic shapes, brute force.

use super::exact_plane::ExactPlane;
use super::*;
use crate::{Faces, MeshView, NONE, Positions, triangulate};
use glam::DVec3;
use gusset_base::error::Error;
use gusset_base::job::Job;
use proptest::prelude::*;

/// A mesh in arrays.
#[derive(Debug, Clone)]
struct Soup {
    points: Vec<[f64; 3]>,
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

impl Soup {
    fn view(&self) -> MeshView<'_> {
        let faces = Faces::polygons(&self.offsets, &self.corners).unwrap();
        MeshView::new(Positions::from(&self.points[..]), faces, &Job::default()).unwrap()
    }

    fn from_faces(points: Vec<[f64; 3]>, faces: &[Vec<u32>]) -> Soup {
        let mut offsets = vec![0];
        offsets.extend(faces.iter().scan(0, |end, face| {
            *end += face.len() as u32;
            Some(*end)
        }));
        Soup { points, offsets, corners: faces.concat() }
    }

    fn faces(&self) -> Vec<Vec<u32>> {
        self.offsets.windows(2).map(|w| self.corners[w[0] as usize..w[1] as usize].to_vec()).collect()
    }

    fn beside(&self, other: &Soup) -> Soup {
        let first = self.points.len() as u32;
        let mut faces = self.faces();
        faces.extend(other.faces().into_iter().map(|face| face.into_iter().map(|v| v + first).collect()));
        Soup::from_faces([self.points.clone(), other.points.clone()].concat(), &faces)
    }

    fn cut(&self, plane: Plane, in_plane: InPlane) -> Sections {
        cut_by_planes(&self.view(), &[plane], &Options { in_plane, tolerance: 0.0 }, &Job::default()).unwrap()
    }

    fn volume(&self) -> f64 {
        let p = |v: u32| DVec3::from(self.points[v as usize]);
        let fans = self.faces();
        let fan = |f: &Vec<u32>| (1..f.len() - 1).map(|k| p(f[0]).dot(p(f[k]).cross(p(f[k + 1])))).sum::<f64>() / 6.0;
        fans.iter().map(fan).sum()
    }
}

/// A box of quads, outwards.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Soup {
    let points =
        (0..8).map(|k| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { low[axis] } else { high[axis] })).collect();
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    Soup::from_faces(points, &faces.map(|face| face.to_vec()))
}

/// A torus of quads, outwards.
fn torus(around: u32, across: u32, radii: [f64; 2]) -> Soup {
    let at = |i: u32, n: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
    let point = |i: u32, j: u32| {
        let (a, b) = (at(i, around), at(j, across));
        let r = radii[0] + radii[1] * b.cos();
        [r * a.cos(), r * a.sin(), radii[1] * b.sin()]
    };
    let index = |i: u32, j: u32| i % around * across + j % across;
    let cells = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let faces: Vec<Vec<u32>> =
        cells.clone().map(|(i, j)| vec![index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]).collect();
    Soup::from_faces(cells.map(|(i, j)| point(i, j)).collect(), &faces)
}

/// A torus of triangles whose vertices are anywhere: closed and oriented, with degenerate and
/// intersecting faces.
fn any_closed_mesh() -> impl Strategy<Value = Soup> {
    (3u32..7, 3u32..7).prop_flat_map(|(n, m)| {
        prop::collection::vec(prop::array::uniform3(-3i32..4), (n * m) as usize).prop_map(move |points| {
            let index = |i: u32, j: u32| i % n * m + j % m;
            let faces: Vec<Vec<u32>> = (0..n)
                .flat_map(|i| (0..m).map(move |j| (i, j)))
                .flat_map(|(i, j)| {
                    let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
                    [vec![a, b, c], vec![a, c, d]]
                })
                .collect();
            Soup::from_faces(points.iter().map(|p| p.map(f64::from)).collect(), &faces)
        })
    })
}

fn any_plane() -> impl Strategy<Value = ([i32; 3], [i32; 3])> {
    let normal = prop::array::uniform3(-3i32..4).prop_filter("not 0", |n| *n != [0; 3]);
    (prop::array::uniform3(-3i32..4), normal)
}

fn vector(x: [i32; 3]) -> DVec3 {
    DVec3::from(x.map(f64::from))
}

fn total_area(sections: &Sections) -> f64 {
    sections.paths().iter().map(|path| path.area).sum()
}

const Z: DVec3 = DVec3::Z;

fn level(z: f64) -> Plane {
    Plane { point: DVec3::new(0.0, 0.0, z), normal: Z }
}

proptest! {
    /// Integers decide each side exactly. The crossings of each face's border are then counted, and
    /// all segments must appear, with their face, on their edges, closed.
    #[test]
    fn closed_meshes_give_closed_loops((mesh, (point, normal), below) in (any_closed_mesh(), any_plane(), any::<bool>())) {
        let in_plane = if below { InPlane::Below } else { InPlane::Above };
        let plane = Plane { point: vector(point), normal: vector(normal) };
        let sections = mesh.cut(plane, in_plane);
        prop_assert!(sections.paths().iter().all(|path| path.is_closed));
        let side = |v: u32| {
            let p = mesh.points[v as usize].map(|x| x as i32);
            (0..3).map(|k| normal[k] * (p[k] - point[k])).sum::<i32>()
        };
        let is_above = |v: u32| if below { side(v) > 0 } else { side(v) >= 0 };
        // The length of the section in each face, from the sides alone.
        let mut expected = 0.0;
        for face in mesh.faces() {
            let mut ends = Vec::new();
            for k in 0..3 {
                let (u, v) = (face[k], face[(k + 1) % 3]);
                if is_above(u) != is_above(v) {
                    let [a, b] = [u, v].map(|v| DVec3::from(mesh.points[v as usize]));
                    ends.push(a.lerp(b, f64::from(side(u)) / f64::from(side(u) - side(v))));
                }
            }
            if let [a, b] = ends[..] { expected += a.distance(b) }
        }
        let length: f64 = sections.paths().iter().map(|path| path.length).sum();
        prop_assert!((length - expected).abs() < 1e-9, "{length} {expected}");
        for k in 0..sections.paths().len() {
            let range = sections.range(k);
            for i in range.clone() {
                let [a, b] = sections.edges()[i];
                let [p, q] = [a, b].map(|v| DVec3::from(mesh.points[v as usize]));
                prop_assert!(p.lerp(q, sections.parameters()[i]).distance(sections.points()[i]) < 1e-14);
                prop_assert_eq!(a == b, side(a) == 0 || side(b) == 0);
                let next = if i + 1 == range.end { range.start } else { i + 1 };
                let face = &mesh.faces()[sections.faces()[i] as usize];
                let both = [sections.edges()[i], sections.edges()[next]].concat();
                prop_assert!(both.iter().all(|v| face.contains(v)));
                prop_assert!(sections.edges()[i] != sections.edges()[next] || a != b);
            }
        }
    }

    /// The area of a section is quadratic between the heights of vertices, so Simpson's rule gives
    /// the volume exactly. The planes at both ends of a slab pass through vertices.
    #[test]
    fn areas_add_up_to_the_volume(mesh in any_closed_mesh()) {
        let area = |z: f64, in_plane| total_area(&mesh.cut(level(z), in_plane));
        let volume: f64 = (-3..3).map(f64::from).map(|z| {
            area(z, InPlane::Below) + 4.0 * area(z + 0.5, InPlane::Above) + area(z + 1.0, InPlane::Above)
        }).sum::<f64>() / 6.0;
        prop_assert!((volume - mesh.volume()).abs() < 1e-10, "{} {}", volume, mesh.volume());
    }

    /// A stack, single planes and any number of threads agree.
    #[test]
    fn stacks_agree_with_single_planes((mesh, (point, normal), threads) in (any_closed_mesh(), any_plane(), 1usize..4)) {
        let normal = vector(normal);
        let offsets: Vec<f64> = (-6..7).map(|k| f64::from(k) / normal.length()).collect();
        let stack = PlaneStack { point: vector(point), normal: normal / normal.abs().max_element(), offsets: &offsets };
        let options = Options::default();
        let view = mesh.view();
        let cut = |threads| cut_by_stack(&view, &stack, &options, &Job::default().with_threads(threads)).unwrap();
        let all = cut(1);
        prop_assert_eq!(&all, &cut(threads));
        for (k, offset) in offsets.iter().enumerate() {
            let stack = PlaneStack { offsets: &[*offset], ..stack };
            let one = cut_by_stack(&view, &stack, &options, &Job::default()).unwrap();
            let paths: Vec<usize> = (0..all.paths().len()).filter(|&i| all.paths()[i].plane == k as u32).collect();
            prop_assert_eq!(paths.len(), one.paths().len());
            for (i, path) in paths.into_iter().enumerate() {
                prop_assert_eq!(&all.points()[all.range(path)], &one.points()[one.range(i)]);
                prop_assert_eq!(all.paths()[path].depth, one.paths()[i].depth);
            }
        }
    }

    /// Holes leave open paths: each free edge that crosses the plane ends one.
    #[test]
    fn open_paths_end_on_free_edges(
        (mesh, (point, normal), gone) in (any_closed_mesh(), any_plane(), prop::collection::vec(any::<prop::sample::Index>(), 1..6))
    ) {
        let mut faces = mesh.faces();
        for index in gone { faces.remove(index.index(faces.len())); }
        let open = Soup::from_faces(mesh.points.clone(), &faces);
        let plane = Plane { point: vector(point), normal: vector(normal) };
        let sections = open.cut(plane, InPlane::Above);
        let side = |v: u32| plane.normal.dot(DVec3::from(open.points[v as usize]) - plane.point) >= 0.0;
        let edges: Vec<[u32; 2]> = faces.iter().flat_map(|f| [[f[0], f[1]], [f[1], f[2]], [f[2], f[0]]]).collect();
        let is_free = |&[a, b]: &[u32; 2]| !edges.contains(&[b, a]);
        let expected = edges.iter().filter(|e| is_free(e) && side(e[0]) != side(e[1])).count();
        let open_paths = sections.paths().iter().filter(|path| !path.is_closed).count();
        // An open path round a vertex in the plane is a single point, and left out.
        prop_assert!(2 * open_paths <= expected);
        if (0..open.points.len() as u32).all(|v| plane.normal.dot(DVec3::from(open.points[v as usize]) - plane.point) != 0.0) {
            prop_assert_eq!(2 * open_paths, expected);
        }
    }

    /// The sign agrees with exact integers where rounding errors exceed the distance.
    #[test]
    fn sides_are_exact((o, n, along, off) in (
        prop::array::uniform3(-(1i64 << 44)..1 << 44),
        prop::array::uniform3(1i64..1 << 26),
        prop::array::uniform2(-(1i64 << 18)..1 << 18),
        prop::array::uniform3(-1i64..2),
    )) {
        let double = |x: [i64; 3]| DVec3::from(x.map(|x| x as f64));
        // Near the plane: o plus two vectors along it, plus a unit or so.
        let [s, t] = along;
        let step = [n[1] * s + off[0], n[2] * t - n[0] * s + off[1], -n[1] * t + off[2]];
        let p = [0, 1, 2].map(|k| o[k] + step[k]);
        let plane = ExactPlane::new(double(o), double(n)).unwrap();
        let exact: i128 = (0..3).map(|k| i128::from(n[k]) * i128::from(p[k] - o[k])).sum();
        let distance = plane.exact_distance(double(p), 0.0);
        prop_assert_eq!(distance > 0.0, exact > 0);
        prop_assert_eq!(distance < 0.0, exact < 0);
        let bounded = plane.bounded_value(double(p));
        prop_assert!((bounded.value - distance).abs() <= bounded.error_bound);
    }

    /// The simplified path is within the tolerance, keeps given points and has no more points.
    #[test]
    fn simplified_paths_are_near((mesh, tolerance) in (any_closed_mesh(), 0.01f64..2.0)) {
        let options = Options { tolerance, ..Options::default() };
        let full = mesh.cut(level(0.25), InPlane::Above);
        let few = cut_by_planes(&mesh.view(), &[level(0.25)], &options, &Job::default()).unwrap();
        prop_assert_eq!(full.paths(), few.paths());
        for k in 0..full.paths().len() {
            let (all, kept) = (&full.points()[full.range(k)], &few.points()[few.range(k)]);
            prop_assert!(kept.len() >= 2.min(all.len()));
            prop_assert!(kept.iter().all(|p| all.contains(p)));
            for p in all {
                let near = (0..kept.len()).map(|i| {
                    let (a, b) = (kept[i], kept[(i + 1) % kept.len()]);
                    let along = b - a;
                    let share = (*p - a).dot(along) / along.length_squared();
                    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
                    p.distance(a + along * share)
                });
                prop_assert!(near.fold(f64::INFINITY, f64::min) <= tolerance * (1.0 + 1e-12));
            }
        }
    }
}

#[test]
fn a_box_shows_the_rule_for_faces_in_the_plane() {
    let mesh = cuboid([0.0; 3], [2.0, 3.0, 1.0]);
    for (z, in_plane, count) in
        [(0.0, InPlane::Above, 0), (0.0, InPlane::Below, 1), (1.0, InPlane::Above, 1), (1.0, InPlane::Below, 0)]
    {
        let sections = mesh.cut(level(z), in_plane);
        assert_eq!(sections.paths().len(), count);
        assert!(sections.paths().iter().all(|path| path.area == 6.0 && path.length == 10.0));
    }
    let sections = mesh.cut(level(0.5), InPlane::Above);
    assert_eq!((total_area(&sections), sections.points().len()), (6.0, 4));
    assert_eq!(total_area(&mesh.cut(Plane { normal: -Z, ..level(0.5) }, InPlane::Above)), 6.0);
}

#[test]
fn peaks_give_nothing_and_ridges_run_there_and_back() {
    // A roof with its ridge at height 1, and a pyramid.
    let points =
        vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 2.0, 0.0], [0.0, 2.0, 0.0], [1.0, 1.0, 1.0], [3.0, 1.0, 1.0]];
    let faces = [vec![0, 3, 2, 1], vec![0, 1, 5, 4], vec![1, 2, 5], vec![2, 3, 4, 5], vec![3, 0, 4]];
    let roof = Soup::from_faces(points.clone(), &faces);
    let ridge = roof.cut(level(1.0), InPlane::Above);
    assert_eq!((ridge.paths().len(), ridge.points().len(), ridge.paths()[0].length), (1, 2, 4.0));
    assert!(roof.cut(level(1.0), InPlane::Below).paths().is_empty());
    let faces = [vec![0, 3, 2, 1], vec![0, 1, 4], vec![1, 2, 4], vec![2, 3, 4], vec![3, 0, 4]];
    let pyramid = Soup::from_faces(points, &faces);
    assert!(pyramid.cut(level(1.0), InPlane::Above).paths().is_empty());
}

#[test]
fn solids_that_share_an_edge_or_a_face_keep_their_own_loops() {
    let first = cuboid([0.0; 3], [1.0; 3]);
    for (low, shared) in [([1.0, 1.0, 0.0], 2), ([1.0, 0.0, 0.0], 4), ([-1.0, 1.0, 0.0], 2), ([-1.0, -1.0, 0.0], 2)] {
        let second = cuboid(low, low.map(|x| x + 1.0));
        let mut both = first.beside(&second);
        // Welds equal vertices.
        let points = both.points.clone();
        both.corners
            .iter_mut()
            .for_each(|v| *v = points.iter().position(|p| *p == points[*v as usize]).unwrap() as u32);
        let used: std::collections::HashSet<u32> = both.corners.iter().copied().collect();
        assert_eq!(used.len(), 16 - shared);
        let sections = both.cut(level(0.5), InPlane::Above);
        let paths = sections.paths();
        assert_eq!(paths.len(), 2, "{low:?}");
        assert!(paths.iter().all(|path| path.is_closed && path.area == 1.0 && path.depth == 0 && path.parent == NONE));
    }
}

#[test]
fn nesting_counts_the_loops_around() {
    // Two rings one in the other, and a box in the hole.
    let mesh = torus(60, 20, [4.0, 0.5]).beside(&torus(48, 16, [2.0, 0.5])).beside(&cuboid([-1.0; 3], [1.0; 3]));
    let sections = mesh.cut(level(0.1), InPlane::Above);
    let mut paths: Vec<SectionPath> = sections.paths().to_vec();
    paths.sort_by(|a, b| b.area.abs().total_cmp(&a.area.abs()));
    assert_eq!(paths.iter().map(|path| path.depth).collect::<Vec<_>>(), [0, 1, 2, 3, 4]);
    assert!(paths.iter().enumerate().all(|(k, path)| (path.area > 0.0) == (k % 2 == 0)));
    assert_eq!(paths[0].parent, NONE);
    for pair in paths.windows(2) {
        assert_eq!(sections.paths()[pair[1].parent as usize], pair[0]);
    }
    let ring = std::f64::consts::PI * 4.5f64.powi(2);
    assert!((paths[0].area / ring - 1.0).abs() < 0.02);
}

/// Boxes in boxes: those inside a box share its width unevenly. Each has its depth and its parent.
fn add_boxes(all: &mut Vec<([f64; 2], [f64; 2], usize, u32)>, parent: usize, shares: &mut impl Iterator<Item = u8>) {
    let (low, high, _, depth) = all[parent];
    let count = shares.next().unwrap_or(0) % 4;
    let is_across = shares.next().unwrap_or(0).is_multiple_of(2);
    for k in 0..count {
        let axis = usize::from(is_across);
        let place = |share: f64| low[axis] + (high[axis] - low[axis]) * (f64::from(k) + share) / f64::from(count);
        let (mut own_low, mut own_high) = (low, high);
        (own_low[axis], own_high[axis]) = (place(0.1), place(0.7 + 0.1 * f64::from(k % 3)));
        let margin = 0.1 * (high[1 - axis] - low[1 - axis]);
        (own_low[1 - axis], own_high[1 - axis]) = (low[1 - axis] + margin, high[1 - axis] - margin);
        all.push((own_low, own_high, parent, depth + 1));
    }
    for child in all.len() - usize::from(count)..all.len() {
        add_boxes(all, child, shares);
    }
}

proptest! {
    #[test]
    fn boxes_in_boxes_have_their_parents(shares in prop::collection::vec(any::<u8>(), 2..60), turn in 0.0f64..7.0) {
        let mut boxes = vec![([0.0; 2], [1.0; 2], usize::MAX, 0)];
        add_boxes(&mut boxes, 0, &mut shares.into_iter());
        let cuboids = boxes.iter().map(|(low, high, ..)| cuboid([low[0], low[1], -1.0], [high[0], high[1], 1.0]));
        let mut mesh = cuboids.reduce(|all, one| all.beside(&one)).unwrap();
        let (sine, cosine) = turn.sin_cos();
        mesh.points.iter_mut().for_each(|p| *p = [cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1], p[2]]);
        let sections = mesh.cut(level(0.25), InPlane::Above);
        prop_assert_eq!(sections.paths().len(), boxes.len());
        // Paths are in the order of their faces.
        for (path, &(.., parent, depth)) in sections.paths().iter().zip(&boxes) {
            let parent = if parent == usize::MAX { NONE } else { parent as u32 };
            prop_assert_eq!((path.depth, path.parent), (depth, parent));
        }
    }
}

#[test]
fn polygons_that_are_not_convex_are_cut_inside() {
    // A prism over a comb, lying on its side: the plane crosses its two large faces many times.
    let mut outline = vec![[0.0, 0.0], [7.0, 0.0]];
    for tooth in (0..4).rev() {
        let x = 2.0 * f64::from(tooth);
        outline.extend([[x + 1.0, 3.0], [x, 3.0]]);
        if tooth > 0 {
            outline.extend([[x, 1.0], [x - 1.0, 1.0]]);
        }
    }
    let n = outline.len() as u32;
    let points = [0.0, 1.0].into_iter().flat_map(|y| outline.iter().map(move |&[x, z]| [x, y, z])).collect();
    let mut faces: Vec<Vec<u32>> = (0..n).map(|k| vec![k, n + k, n + (k + 1) % n, (k + 1) % n]).collect();
    faces.extend([(0..n).collect(), (n..2 * n).rev().collect()]);
    let comb = Soup::from_faces(points, &faces);
    let split = triangulate(&comb.view(), &Job::default()).unwrap();
    let corners = split.mesh.face_corners.clone();
    let triangles: Vec<Vec<u32>> = corners.chunks(3).map(<[u32]>::to_vec).collect();
    let triangles = Soup::from_faces(comb.points.clone(), &triangles);
    assert!(comb.volume() > 0.0);
    for (plane, count) in [
        (level(2.0), 4),
        (Plane { point: DVec3::new(0.0, 0.0, 2.0), normal: DVec3::new(0.1, 0.2, 1.0) }, 4),
        (level(0.5), 1),
        (Plane { point: DVec3::new(0.5, 0.0, 2.0), normal: DVec3::new(1.0, 0.3, -1.0) }, 1),
    ] {
        let [ours, theirs] = [&comb, &triangles].map(|mesh| mesh.cut(plane, InPlane::Above));
        let (a, b) = (total_area(&ours), total_area(&theirs));
        assert!((a - b).abs() < 1e-12 && a > 0.0, "{a} {b}");
        assert_eq!([ours.paths().len(), theirs.paths().len()], [count; 2]);
        assert!(ours.paths().iter().all(|path| path.is_closed && path.area > 0.0));
    }
}

#[test]
fn planes_about_an_axis_contain_it() {
    let axis = DVec3::new(1.0, 2.0, -0.5);
    let point = DVec3::new(3.0, 1.0, 2.0);
    let planes = planes_about_axis(point, axis, DVec3::X, &[0.0, 0.5, 2.0]).unwrap();
    for (plane, angle) in planes.iter().zip([0.0, 0.5, 2.0]) {
        assert!(plane.normal.dot(axis).abs() < 1e-15 && (plane.normal.length() - 1.0).abs() < 1e-15);
        let across = axis.normalize().cross(DVec3::X).normalize();
        assert!((plane.normal.dot(across) - f64::cos(angle)).abs() < 1e-14);
    }
    assert!(planes_about_axis(point, axis, axis * 2.0, &[0.0]).is_err());
    // Sections of a torus through its axis: two circles each.
    let planes = planes_about_axis(DVec3::ZERO, Z, DVec3::X, &[0.1, 0.7, 1.9]).unwrap();
    let sections =
        cut_by_planes(&torus(90, 40, [2.0, 0.5]).view(), &planes, &Options::default(), &Job::default()).unwrap();
    assert_eq!((sections.plane_count(), sections.paths().len()), (3, 6));
    for path in sections.paths() {
        assert!(path.is_closed && path.depth == 0 && (path.area / (std::f64::consts::PI * 0.25) - 1.0).abs() < 0.02);
    }
}

#[test]
fn planes_across_a_polyline_follow_it() {
    let circle: Vec<DVec3> = (0..100)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 100.0)
        .map(|t| 2.0 * DVec3::new(t.cos(), t.sin(), 0.0))
        .collect();
    let distances = [0.0, 1.0, 5.0, 12.5];
    let planes = planes_across_polyline(&circle, true, &distances).unwrap();
    for (plane, distance) in planes.iter().zip(distances) {
        let t = distance / 2.0;
        assert!((plane.normal - DVec3::new(-t.sin(), t.cos(), 0.0)).length() < 3e-3, "{plane:?}");
        assert!((plane.point.length() - 2.0).abs() < 2e-3);
    }
    let line = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    let corner = planes_across_polyline(&line, false, &[0.0, 1.0, 2.0]).unwrap();
    assert_eq!(corner[0].normal, DVec3::X);
    assert_eq!(corner[2], Plane { point: line[3], normal: DVec3::Y });
    assert!((corner[1].normal - DVec3::new(0.5f64.sqrt(), 0.5f64.sqrt(), 0.0)).length() < 1e-15);
    assert_eq!(planes_across_polyline(&line[..2], false, &[0.0]), Err(Error::EmptyCurve));
    assert!(planes_across_polyline(&line, false, &[2.5]).is_err());
}

#[test]
fn bad_input_is_named() {
    let mesh = cuboid([0.0; 3], [1.0; 3]);
    let (view, job, options) = (mesh.view(), Job::default(), Options::default());
    let cut = |normal, offsets: &[f64], options: &Options| {
        cut_by_stack(&view, &PlaneStack { point: DVec3::ZERO, normal, offsets }, options, &job).map(|_| ())
    };
    let is_refused = |result: Result<(), Error>, name: &str| matches!(result, Err(Error::OptionOutOfRange { option, .. }) if option == name);
    assert!(is_refused(cut(DVec3::ZERO, &[0.0], &options), "normal"));
    assert!(is_refused(cut(Z, &[0.0, 0.0], &options), "offsets"));
    assert!(cut(Z, &[f64::NAN], &options).is_err());
    assert!(cut(Z, &[], &options).is_ok());
    let bad = Options { tolerance: -1.0, ..options };
    assert!(is_refused(cut(Z, &[0.5], &bad), "tolerance"));
    let mut large = mesh.clone();
    large.points[3][1] = -1e200;
    let found = cut_by_planes(&large.view(), &[level(0.5)], &options, &job).map(|_| ());
    assert_eq!(
        found,
        Err(Error::CoordinateTooLarge {
            element: gusset_base::error::Element::Vertex,
            index: 3,
            component: gusset_base::Component::Y,
            value: -1e200
        })
    );
    // A vertex that no face uses may hold anything.
    let mut unused = mesh.clone();
    unused.points.push([f64::NAN, 1.0, f64::INFINITY]);
    assert_eq!(unused.cut(level(0.5), InPlane::Above), mesh.cut(level(0.5), InPlane::Above));
}

#[test]
fn units_and_positions_do_not_change_the_section() {
    let mesh = torus(24, 12, [2.0, 0.7]);
    let plane = Plane { point: DVec3::new(0.1, 0.2, 0.05), normal: DVec3::new(0.3, -0.2, 1.0) };
    let expected = mesh.cut(plane, InPlane::Above);
    for unit in [2f64.powi(-300), 2f64.powi(400)] {
        let scaled = Soup { points: mesh.points.iter().map(|p| p.map(|x| x * unit)).collect(), ..mesh.clone() };
        let found = scaled.cut(Plane { point: plane.point * unit, normal: plane.normal / unit }, InPlane::Above);
        assert_eq!(found.edges(), expected.edges());
        assert_eq!(found.parameters(), expected.parameters());
        assert!((total_area(&found) / unit / unit / total_area(&expected) - 1.0).abs() < 1e-12);
    }
}
