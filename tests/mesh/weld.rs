//! Welding, against surfaces whose properties are known and against brute force.

use crate::common::{Soup, edge_counts, euler, faces_of, sheet, torus};
use gusset::check::check;
use gusset::mesh::{Faces, Mesh, MeshView, NONE, Positions};
use gusset::repair::orient::{self, orient};
use gusset::repair::weld::{Options, Vertices, Weld, weld};
use gusset::{Error, Job};
use proptest::prelude::*;
use std::collections::{HashMap, HashSet};

pub(crate) const ALL: Options =
    Options { vertices: Vertices::All, tolerance: None, collapse: false, remove_unused: false };

pub(crate) fn welded(soup: &Soup, options: &Options) -> Weld {
    weld(&soup.view(), options, &Job::default()).unwrap()
}

/// Welded by default, then oriented.
fn repaired(soup: &Soup) -> Mesh {
    let done = welded(soup, &Options::default());
    orient(&done.mesh.view(&Job::default()).unwrap(), &orient::Options::default(), &Job::default()).unwrap().mesh
}

/// The corners with vertices renumbered by their first use: equal for meshes that differ only in
/// numbering.
fn pattern(corners: &[u32]) -> Vec<usize> {
    let mut names = HashMap::new();
    corners
        .iter()
        .map(|&v| {
            let next = names.len();
            *names.entry(v).or_insert(next)
        })
        .collect()
}

/// The faces cut apart into pieces with vertices of their own; face f goes to piece `piece(f)` and
/// is turned over if `turn(f)`.
fn cut(soup: &Soup, piece: impl Fn(usize) -> usize, turn: impl Fn(usize) -> bool) -> Soup {
    let mut pieces = Soup { offsets: vec![0], ..Soup::default() };
    let mut names = HashMap::new();
    for (f, face) in soup.faces().enumerate() {
        let mut own: Vec<u32> = Vec::new();
        for &v in face {
            own.push(*names.entry((piece(f), v)).or_insert_with(|| {
                pieces.points.push(soup.points[v as usize]);
                pieces.points.len() as u32 - 1
            }));
        }
        if turn(f) {
            own.reverse();
        }
        pieces.face(&own);
    }
    pieces
}

/// Vertex v becomes vertex `order[v]`.
fn renumbered(soup: &Soup, order: &[u32]) -> Soup {
    let mut other = soup.clone();
    for (v, &to) in order.iter().enumerate() {
        other.points[to as usize] = soup.points[v];
    }
    other.corners.iter_mut().for_each(|v| *v = order[*v as usize]);
    other
}

/// Any order of the vertices of a soup that has up to 400.
fn order_of(count: usize, keys: &[u32]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_by_key(|&v| (keys[v as usize % keys.len()].wrapping_mul(v.wrapping_mul(2_654_435_761) | 1), v));
    order
}

proptest! {
    #[test]
    fn a_torus_cut_into_sheets_comes_back(
        (n, m) in (3u32..8, 3u32..8),
        pieces in prop::collection::vec(0usize..5, 64),
        turned in prop::collection::vec(any::<bool>(), 64),
        keys in prop::collection::vec(any::<u32>(), 40),
        exponent in -300i32..300,
    ) {
        let whole = torus(n, m);
        let parts = cut(&whole, |f| pieces[f], |f| turned[f]);
        let mut parts = renumbered(&parts, &order_of(parts.points.len(), &keys));
        parts.points.push([f64::NAN; 3]);
        parts.points.iter_mut().flatten().for_each(|x| *x *= 10f64.powi(exponent));
        let mesh = repaired(&parts);
        prop_assert_eq!(mesh.positions.len() as u32, n * m + 1);
        prop_assert_eq!(faces_of(&mesh).count() as u32, n * m);
        prop_assert_eq!(euler(faces_of(&mesh)), 0);
        prop_assert!(edge_counts(faces_of(&mesh)).values().all(|&count| count == (1, 1)));
        let found = check(&mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
        prop_assert!(found.manifold && found.oriented && found.closed);
        prop_assert_eq!((found.genus, found.components), (Some(1), 1));
        let done = welded(&parts, &Options::default());
        prop_assert!(done.left_edges.is_empty() && done.left_vertices.is_empty());
        // Nothing is left to do.
        let view = done.mesh.view(&Job::default()).unwrap();
        let again = weld(&view, &Options::default(), &Job::default()).unwrap();
        prop_assert_eq!((again.welded_vertices, again.sewn_edges), (0, 0));
        prop_assert_eq!(&again.mesh.face_corners, &done.mesh.face_corners);
    }

    #[test]
    fn numbers_motion_and_unit_change_nothing(
        pieces in prop::collection::vec(0usize..6, 30),
        keys in prop::collection::vec(any::<u32>(), 40),
        angle in 0.0..6.0,
        shift in -100.0..100.0,
        exponent in -900i32..900,
        all in any::<bool>(),
    ) {
        let options = if all { ALL } else { Options::default() };
        let parts = cut(&torus(6, 5), |f| pieces[f], |f| f % 3 == 0);
        let wanted = pattern(&welded(&parts, &options).mesh.face_corners);
        let other = renumbered(&parts, &order_of(parts.points.len(), &keys));
        prop_assert_eq!(&pattern(&welded(&other, &options).mesh.face_corners), &wanted);
        let mut moved = parts.clone();
        for p in &mut moved.points {
            let [x, y, z] = *p;
            *p = [x * f64::cos(angle) - y * f64::sin(angle) + shift, x * f64::sin(angle) + y * f64::cos(angle), z];
        }
        prop_assert_eq!(&pattern(&welded(&moved, &options).mesh.face_corners), &wanted);
        let unit = 2f64.powi(exponent);
        let mut scaled = parts.clone();
        scaled.points.iter_mut().flatten().for_each(|x| *x *= unit);
        prop_assert_eq!(&pattern(&welded(&scaled, &options).mesh.face_corners), &wanted);
        // With a tolerance too, of the size of the faces.
        let with = |soup: &Soup, t| welded(soup, &Options { tolerance: Some(t), ..options }).mesh.face_corners;
        prop_assert_eq!(with(&parts, 1.1), with(&scaled, 1.1 * unit));
    }

    /// Triangles on a coarse lattice: every kind of coincidence.
    #[test]
    fn sewing_keeps_its_promises(
        cells in prop::collection::vec((0u8..3, 0u8..3, 0u8..2), 6..40),
        corners in prop::collection::vec((0usize..40, 0usize..40, 0usize..40), 1..30),
    ) {
        let points: Vec<_> = cells.iter().map(|&(x, y, z)| [f64::from(x), f64::from(y), f64::from(z)]).collect();
        let index = |i: usize| (i % points.len()) as u32;
        let faces: Vec<_> = corners.iter().map(|&(a, b, c)| [index(a), index(b), index(c)]).collect();
        let list: Vec<&[u32]> = faces.iter().map(<[u32; 3]>::as_slice).collect();
        let soup = Soup::new(points, &list);
        let done = welded(&soup, &Options::default());
        let map = |v: u32| done.vertex_map[v as usize];

        // Vertices are one only where they lie together, and no face collapses.
        for (v, &new) in done.vertex_map.iter().enumerate() {
            prop_assert_eq!(done.mesh.positions.get(new).to_array(), soup.points[v]);
        }
        prop_assert_eq!(done.mesh.face_count(), faces.len());
        for (old, new) in soup.faces().zip(faces_of(&done.mesh)) {
            prop_assert_eq!(old.iter().map(|&v| map(v)).collect::<Vec<_>>(), new);
            let different = |face: &[u32]| face.iter().collect::<HashSet<_>>().len();
            prop_assert_eq!(different(old), different(new));
        }

        // Edges, separately for faces that repeat a vertex.
        let proper = |face: &&[u32]| face.iter().collect::<HashSet<_>>().len() == 3;
        let total = |face: &HashMap<(u32, u32), (u32, u32)>, key: (u32, u32)| face.get(&key).map_or(0, |&(a, b)| a + b);
        let before = edge_counts(soup.faces().filter(proper));
        let after = edge_counts(faces_of(&done.mesh).filter(proper));
        let mut origins: HashMap<(u32, u32), Vec<(u32, u32)>> = HashMap::new();
        for &(u, v) in before.keys() {
            let (a, b) = (map(u), map(v));
            origins.entry((a.min(b), a.max(b))).or_default().push((u, v));
        }
        let mut sewn = 0;
        for (key, from) in &origins {
            match from.as_slice() {
                [one] => prop_assert_eq!(total(&after, *key), total(&before, *one)),
                [one, other] => {
                    prop_assert_eq!((total(&before, *one), total(&before, *other)), (1, 1));
                    sewn += 1;
                }
                more => prop_assert!(false, "{} edges became one", more.len()),
            }
        }
        prop_assert_eq!(done.sewn_edges, sewn);

        // The expected result by brute force.
        let mut free = Vec::new();
        for (f, face) in soup.faces().enumerate().filter(|(_, face)| proper(face)) {
            for k in 0..3 {
                let (u, v) = (face[k], face[(k + 1) % 3]);
                let (a, b) = (map(u), map(v));
                if total(&before, (u.min(v), u.max(v))) == 1 {
                    let place = [u, v].map(|v| soup.points[v as usize].map(|x| x as u8));
                    let place = if place[0] < place[1] { place } else { [place[1], place[0]] };
                    free.push((3 * f as u32 + k as u32, place, total(&after, (a.min(b), a.max(b)))));
                }
            }
        }
        let company = |place| free.iter().filter(|other| other.1 == place).count() > 1;
        let left: Vec<u32> = free.iter().filter(|e| e.2 == 1 && company(e.1)).map(|e| e.0).collect();
        prop_assert_eq!(&done.left_edges, &left);
    }

    #[test]
    fn clusters_are_what_the_rule_says(
        cells in prop::collection::vec((0u8..9, 0u8..9, 0u8..3), 3..60),
        tolerance in 0.0..3.0,
    ) {
        let points: Vec<_> = cells.iter().map(|&(x, y, z)| [f64::from(x), f64::from(y), f64::from(z)]).collect();
        let faces: Vec<_> = (0..points.len() as u32 / 3).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
        let list: Vec<&[u32]> = faces.iter().map(<[u32; 3]>::as_slice).collect();
        let soup = Soup::new(points, &list);
        let used = 3 * faces.len();
        let options = Options { tolerance: Some(tolerance), collapse: true, ..ALL };
        let done = welded(&soup, &options);
        let mut expected: Vec<usize> = (0..soup.points.len()).collect();
        let mut claimed = vec![false; used];
        for i in 0..used {
            if !claimed[i] {
                for j in i..used {
                    let squared: f64 = (0..3).map(|k| (soup.points[i][k] - soup.points[j][k]).powi(2)).sum();
                    if !claimed[j] && squared <= tolerance * tolerance {
                        (claimed[j], expected[j]) = (true, i);
                    }
                }
            }
        }
        prop_assert_eq!(pattern(&done.vertex_map), pattern(&expected.iter().map(|&v| v as u32).collect::<Vec<_>>()));
        for face in faces_of(&done.mesh) {
            prop_assert_eq!(face.iter().collect::<HashSet<_>>().len(), 3);
        }
        // Without collapse, corners of a face stay apart.
        let apart = welded(&soup, &Options { collapse: false, ..options });
        for face in faces_of(&apart.mesh) {
            prop_assert_eq!(face.iter().collect::<HashSet<_>>().len(), 3);
        }
        prop_assert_eq!(apart.mesh.face_count(), faces.len());
        prop_assert_eq!(apart.left_vertices.is_empty(), done.dropped_faces == 0 && apart.welded_vertices == done.welded_vertices);
    }
}

/// The six sides of a cube, each with vertices of its own.
pub(crate) fn cube(at: [f64; 3]) -> Soup {
    let corner = |k: u32| [0, 1, 2].map(|axis| at[axis] + f64::from(k >> axis & 1));
    let sides: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let whole = Soup::new((0..8).map(corner).collect(), &sides.each_ref().map(|side| &side[..]));
    cut(&whole, |f| f, |_| false)
}

#[test]
fn cubes_that_touch_along_an_edge_stay_two() {
    let soup = cube([0.0; 3]).and(&cube([1.0, 1.0, 0.0]));
    let done = welded(&soup, &Options::default());
    assert_eq!((done.mesh.positions.len(), done.sewn_edges), (16, 24));
    // Four faces lie together there, two by two by now.
    assert!(done.left_edges.is_empty());
    assert_eq!(done.left_vertices.len(), 12);
    assert_eq!(euler(faces_of(&done.mesh)), 4);
    // All welded, they share the edge.
    let done = welded(&soup, &ALL);
    assert_eq!(done.mesh.positions.len(), 14);
    assert_eq!((done.sewn_edges, done.left_edges.len()), (22, 4));
    assert!(edge_counts(faces_of(&done.mesh)).values().any(|&(a, b)| a + b == 4));
}

#[test]
fn three_sheets_on_one_line_are_left_and_listed() {
    let mut soup = sheet(2, 1);
    for turn in 1..3 {
        let mut other = sheet(2, 1);
        let angle = 2.0 * f64::from(turn);
        other.points.iter_mut().for_each(|p| *p = [p[0], p[1] * angle.cos(), p[1] * angle.sin()]);
        soup = soup.and(&other);
    }
    let done = welded(&soup, &Options::default());
    assert_eq!((done.welded_vertices, done.sewn_edges), (0, 0));
    // The lower sides of both faces of each sheet: half-edges 0 and 4 of its eight.
    assert_eq!(done.left_edges, [0, 4, 8, 12, 16, 20]);
    assert_eq!(done.left_vertices, [0, 1, 2, 6, 7, 8, 12, 13, 14]);
    assert_eq!(done.mesh.face_corners, soup.corners);
    let done = welded(&soup, &ALL);
    assert_eq!((done.welded_vertices, done.sewn_edges), (6, 0));
    assert_eq!(done.left_edges, [0, 4, 8, 12, 16, 20]);
    assert!(done.left_vertices.is_empty());
}

#[test]
fn holes_that_touch_at_a_point_stay_apart() {
    // Two triangles that meet in a point, with a vertex each there.
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0; 3], [-1.0, 0.0, 0.0], [-1.0, -1.0, 0.0]];
    let soup = Soup::new(points, &[&[0, 1, 2], &[3, 4, 5]]);
    let done = welded(&soup, &Options::default());
    assert_eq!((done.welded_vertices, done.left_vertices.as_slice()), (0, &[0, 3][..]));
    assert!(done.left_edges.is_empty());
    assert_eq!(welded(&soup, &ALL).welded_vertices, 1);
}

#[test]
fn a_seam_closes_up_to_its_end() {
    // A square round its centre, slit from the centre to vertex 1 = 5: a cone closed by one seam.
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, -0.0]];
    let soup = Soup::new(points, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 5]]);
    let done = welded(&soup, &Options::default());
    assert_eq!((done.sewn_edges, done.vertex_map.as_slice()), (1, &[0, 1, 2, 3, 4, 1][..]));
    assert!(done.mesh.positions.get(1).z.is_sign_positive(), "the representative keeps its bits");
    // A sheet folded flat onto itself closes too.
    let fold = Soup::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]], &[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!(welded(&fold, &Options::default()).sewn_edges, 2);
}

#[test]
fn sheets_on_top_of_each_other_are_sewn_only_as_far_as_edges_inside_stay_two() {
    let twice = |faces: &[&[u32]]| {
        let one = Soup::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], faces);
        welded(&one.and(&one), &Options::default())
    };
    // Sewn all round, two squares make a pillow;
    let done = twice(&[&[0, 1, 2, 3]]);
    assert_eq!((done.sewn_edges, done.mesh.positions.len(), done.left_edges.len()), (4, 4, 0));
    // two squares with a diagonal cannot: at one of its ends they stay apart.
    let done = twice(&[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!((done.sewn_edges, done.mesh.positions.len()), (2, 5));
    assert_eq!((done.left_edges.len(), done.left_vertices.len()), (4, 2));
    assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(a, b)| a + b <= 2));
}

#[test]
fn a_line_within_the_tolerance_does_not_chain() {
    let points = (0..12).map(|i| [f64::from(i), 0.0, 0.0]).chain([[0.0, 50.0, 0.0], [0.0, 0.0, 50.0]]).collect();
    let faces: Vec<[u32; 3]> = (0..12).map(|i| [i, 12, 13]).collect();
    let list: Vec<&[u32]> = faces.iter().map(<[u32; 3]>::as_slice).collect();
    let soup = Soup::new(points, &list);
    let done = welded(&soup, &Options { tolerance: Some(1.5), ..ALL });
    assert_eq!(done.vertex_map, [0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 7]);
}

#[test]
fn tolerances_at_the_ends_of_the_range() {
    let at = |gap: f64, size: f64| {
        let points =
            vec![[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0], [gap, 0.0, 0.0], [0.0, -size, 0.0], [-size, 0.0, 0.0]];
        Soup::new(points, &[&[0, 1, 2], &[3, 4, 5]])
    };
    let count =
        |gap, size, tolerance| welded(&at(gap, size), &Options { tolerance: Some(tolerance), ..ALL }).welded_vertices;
    for (gap, size) in [(1e-320, 1.0), (1e-200, 1.0), (1e-300, 1e-290), (1.0, 1e300), (1e300, 1e307), (0.5, 1.0)] {
        assert_eq!(count(gap, size, gap), 1, "{gap}");
        assert_eq!(count(gap, size, gap * 1.01), 1, "{gap}");
        assert_eq!(count(gap, size, gap * 0.99), 0, "{gap}");
        assert_eq!(count(gap, size, 0.0), 0, "{gap}");
    }
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let options = Options { tolerance: Some(bad), ..ALL };
        match weld(&at(1.0, 1.0).view(), &options, &Job::default()) {
            Err(Error::OptionOutOfRange { option: "tolerance", value, .. }) => {
                assert_eq!(value.to_bits(), bad.to_bits());
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn collapse_closes_what_short_edges_leave() {
    // A border with an edge without length against one that has none: the triangle over it goes.
    let points =
        [[0., 0.], [1., 0.], [2., 0.], [2., 0.], [3., 0.], [1., 1.], [0., 0.], [1., 0.], [2., 0.], [3., 0.], [1., -1.]];
    let points: Vec<_> = points.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let faces: [[u32; 3]; 7] = [[0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 4, 5], [7, 6, 10], [8, 7, 10], [9, 8, 10]];
    let soup = Soup::new(points, &faces.each_ref().map(|face| &face[..]));
    let done = welded(&soup, &Options::default());
    assert_eq!((done.sewn_edges, done.dropped_faces, done.left_edges.as_slice()), (2, 0, &[9, 18][..]));
    assert_eq!(done.left_vertices, [2, 3, 4, 8, 9]);
    for options in [Options::default(), ALL] {
        let done = welded(&soup, &Options { collapse: true, ..options });
        assert_eq!((done.mesh.positions.len(), done.mesh.face_count(), done.dropped_faces), (6, 6, 1));
        assert_eq!(done.face_map, [0, 1, NONE, 2, 3, 4, 5]);
        assert!(done.left_edges.is_empty() && done.left_vertices.is_empty(), "{done:?}");
        assert_eq!(euler(faces_of(&done.mesh)), 1);
        let counts = edge_counts(faces_of(&done.mesh));
        assert!(counts.values().all(|&(a, b)| a + b <= 2));
        assert_eq!(counts.values().filter(|&&(a, b)| a + b == 1).count(), 4);
    }
    // The edge that a dropped face leaves is not a sewn edge.
    let sliver = Soup::new(vec![[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0]], &[&[0, 1, 2]]);
    let done = welded(&sliver, &Options { collapse: true, ..ALL });
    assert_eq!((done.dropped_faces, done.sewn_edges, done.mesh.face_count()), (1, 0, 0));
    // Two edges that shrink to one point are not sewn edges.
    let at = |s: f64| [[0.0; 3], [0.0; 3], [s, 0.0, 0.0], [s, s, 0.0]];
    let quads = Soup::new([at(1.0), at(-1.0)].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    let done = welded(&quads, &Options { collapse: true, ..ALL });
    assert_eq!((done.dropped_faces, done.sewn_edges, done.left_edges.len()), (0, 0, 0));
    assert_eq!(done.mesh.face_corners, [0, 1, 2, 0, 3, 4]);
    // A polygon loses successive corners only.
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
    let soup = Soup::new(points, &[&[0, 1, 2, 3, 4, 5]]);
    let done = welded(&soup, &Options { collapse: true, ..ALL });
    assert_eq!(done.mesh.face_corners, [0, 1, 2, 3]);
}

#[test]
fn an_edge_of_three_faces_does_not_keep_its_ends_from_others() {
    // Three triangles on the edge 0-1, and a fan of four that continues one of them with vertices
    // of its own.
    let angle = |k: u32| [f64::cos(f64::from(k)), f64::sin(f64::from(k)), 0.0];
    let below = |k: u32| [f64::from(k), f64::from(k * k), -1.0];
    let mut points = vec![[0.0; 3], [0.0, 0.0, 1.0], angle(0), angle(1), angle(2), [0.0; 3], angle(1)];
    points.extend((0..4).map(below));
    let faces: [[u32; 3]; 7] = [[0, 1, 2], [0, 1, 3], [0, 1, 4], [5, 6, 7], [5, 7, 8], [5, 8, 9], [5, 9, 10]];
    let soup = Soup::new(points, &faces.each_ref().map(|face| &face[..]));
    let done = welded(&soup, &Options::default());
    assert_eq!((done.sewn_edges, &done.vertex_map[5..]), (1, &[0, 3, 5, 6, 7, 8][..]));
}

#[test]
fn short_edges_are_sewn_by_their_neighbours() {
    // Two sheets with an edge far shorter than the tolerance on their common border, listed first
    // in both.
    let points = vec![
        [1.0, 0.0, 0.0],
        [1.001, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.001, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, -1.0, 0.0],
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
    ];
    let faces: [[u32; 3]; 6] = [[0, 1, 2], [5, 6, 7], [3, 0, 2], [1, 4, 2], [6, 8, 7], [9, 5, 7]];
    let soup = Soup::new(points, &faces.each_ref().map(|face| &face[..]));
    let done = welded(&soup, &Options { tolerance: Some(0.1), ..Options::default() });
    assert_eq!((done.sewn_edges, done.vertex_map.as_slice()), (3, &[0, 1, 2, 3, 4, 1, 0, 5, 3, 4][..]));
    assert!(done.left_edges.is_empty());
}

#[test]
fn the_nearest_corner_of_a_face_is_claimed() {
    let points = vec![[0.0; 3], [5.0, 0.0, 0.0], [5.0, 5.0, 0.0], [0.3, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, -5.0, 0.0]];
    let soup = Soup::new(points, &[&[0, 1, 2], &[3, 4, 5]]);
    let done = welded(&soup, &Options { tolerance: Some(0.5), ..ALL });
    assert_eq!((done.vertex_map[3], done.vertex_map[4]), (3, 0));
    assert_eq!(done.left_vertices, [0, 3]);
}

#[test]
fn zero_has_no_sign() {
    let points =
        vec![[0.0, 1.0, 0.0], [-0.0, 2.0, 0.0], [3.0, 0.0, 0.0], [-0.0, 1.0, -0.0], [0.0, 2.0, 0.0], [-3.0, 0.0, 0.0]];
    let soup = Soup::new(points, &[&[0, 1, 2], &[3, 4, 5]]);
    assert_eq!(welded(&soup, &ALL).vertex_map, [0, 1, 2, 0, 1, 3]);
}

#[test]
fn unused_vertices_stay_or_go() {
    let mut soup = torus(4, 3);
    soup.points.insert(0, [f64::NAN, f64::INFINITY, 7.0]);
    soup.points.push([0.5; 3]);
    soup.corners.iter_mut().for_each(|v| *v += 1);
    let kept = welded(&soup, &ALL);
    assert_eq!((kept.mesh.positions.len(), kept.welded_vertices), (14, 0));
    assert_eq!(kept.mesh.positions.get(0).x.to_bits(), f64::NAN.to_bits());
    let gone = welded(&soup, &Options { remove_unused: true, ..ALL });
    assert_eq!((gone.mesh.positions.len(), gone.vertex_map[0], gone.vertex_map[13]), (12, NONE, NONE));
    assert_eq!(gone.vertex_map[1..13], (0..12).collect::<Vec<u32>>());
}

#[test]
fn single_precision_keeps_its_bits() {
    let points =
        [[0.1f32, 0.2, 0.3], [1.1, 0.0, 0.0], [0.0, 1.3, -0.0], [1.1, -0.0, 0.0], [0.0, 1.3, 0.0], [1.0, 1.0, 1.0]];
    let faces = Faces::triangles(&[[0, 1, 2], [5, 4, 3]]).unwrap();
    let view = MeshView::new(Positions::from(&points[..]), faces, &Job::default()).unwrap();
    let done = weld(&view, &Options::default(), &Job::default()).unwrap();
    let gusset::mesh::PositionBuffer::F32(positions) = &done.mesh.positions else { panic!("f64") };
    let bits = |p: &[[f32; 3]]| p.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(positions), bits(&[points[0], points[1], points[2], points[5]]));
}

#[test]
fn any_number_of_threads_gives_the_same() {
    let parts = cut(&torus(20, 17), |f| f * 7 % 13, |f| f % 2 == 0);
    let options = Options { tolerance: Some(1e-6), ..Options::default() };
    let run = |threads| weld(&parts.view(), &options, &Job::new(threads, &Deaf)).unwrap();
    assert_eq!(run(1), run(4));
}

struct Deaf;

impl gusset::Progress for Deaf {
    fn step(&self, fraction: f64, _: &'static str) -> std::ops::ControlFlow<()> {
        assert!((0.0..=1.0).contains(&fraction));
        std::ops::ControlFlow::Continue(())
    }
}
