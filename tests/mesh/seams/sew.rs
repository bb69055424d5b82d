//! Sews borders whose vertices do not match. Cut meshes become closed again, with their volume and
//! Euler characteristic. Borders that touch without matching stay open.

mod borders;

use crate::common::{Soup, edge_counts, euler, faces_of, sheet, torus, volume};
use borders::{cut, places, triangulated};
use gusset::assemble::{self, MaxGap, assemble};
use gusset::check::check;
use gusset::mesh::{Faces, Mesh, MeshView, NONE, Positions};
use gusset::repair::sew::{Sew, sew};
use gusset::repair::weld::{Options, Vertices};
use gusset::{Error, Job, Progress};
use proptest::prelude::*;
use std::cell::Cell;
use std::collections::{HashMap, HashSet};
use std::ops::ControlFlow;

fn sewn(soup: &Soup, options: &Options) -> Sew {
    let done = sew(&soup.view(), options, &Job::default()).unwrap();
    assert_account(soup, &done);
    done
}

fn area<'a>(point: impl Fn(u32) -> [f64; 3], faces: impl Iterator<Item = &'a [u32]>) -> f64 {
    let mut sum = 0.0;
    for face in faces {
        // Newell's sum, which is right for any flat polygon.
        let mut normal = [0.0; 3];
        for (k, &u) in face.iter().enumerate() {
            let (p, q) = (point(u), point(face[(k + 1) % face.len()]));
            for (axis, n) in normal.iter_mut().enumerate() {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                *n += p[i] * q[j] - p[j] * q[i];
            }
        }
        sum += normal.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0;
    }
    sum
}

fn soup_positions(soup: &Soup) -> impl Fn(u32) -> [f64; 3] + '_ {
    |v| soup.points[v as usize]
}

fn mesh_positions(mesh: &Mesh) -> impl Fn(u32) -> [f64; 3] + '_ {
    |v| mesh.positions.get(v).to_array()
}

fn non_manifold_edges<'a>(faces: impl Iterator<Item = &'a [u32]>) -> usize {
    edge_counts(faces).values().filter(|&&(a, b)| a + b > 2).count()
}

fn degenerate_faces<'a>(faces: impl Iterator<Item = &'a [u32]>) -> usize {
    faces.filter(|face| face.iter().collect::<HashSet<_>>().len() < face.len()).count()
}

/// Checks any sewing: maps have valid indices, old vertices keep their positions, triangles stay
/// triangles, defects do not increase.
#[track_caller]
fn assert_account(soup: &Soup, done: &Sew) {
    let new: Vec<&[u32]> = faces_of(&done.mesh).collect();
    let old: Vec<&[u32]> = soup.faces().collect();
    assert_eq!(
        (done.vertex_map.len(), done.face_map.len(), done.face_origin.len()),
        (soup.points.len(), old.len(), new.len())
    );
    let mut first = HashMap::new();
    for (v, &now) in done.vertex_map.iter().enumerate().filter(|&(_, &now)| now != NONE) {
        let &mut kept = first.entry(now).or_insert(v);
        let [kept, place] = [soup.points[kept], done.mesh.positions.get(now).to_array()];
        assert!(kept.map(f64::to_bits) == place.map(f64::to_bits), "the smallest keeps its bits");
    }
    assert!(done.face_origin.is_sorted());
    for (f, &now) in done.face_map.iter().enumerate() {
        assert_eq!(done.face_origin.iter().position(|&origin| origin == f as u32).map_or(NONE, |k| k as u32), now);
    }
    for (face, &origin) in new.iter().zip(&done.face_origin) {
        assert_eq!(face.len() == 3, old[origin as usize].len() == 3);
    }
    assert!(non_manifold_edges(new.iter().copied()) <= non_manifold_edges(old.iter().copied()));
    assert!(degenerate_faces(new.iter().copied()) <= degenerate_faces(old.iter().copied()));
    assert!(done.left_vertices.is_sorted());
}

#[track_caller]
fn assert_closed(mesh: &Mesh, chi: i64) {
    assert_eq!(euler(faces_of(mesh)), chi);
    assert!(edge_counts(faces_of(mesh)).values().all(|&(a, b)| a + b == 2));
    assert_eq!(degenerate_faces(faces_of(mesh)), 0);
    let found = check(&mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.manifold && found.closed);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn a_cut_mesh_comes_back_closed(
        (n, m) in (3u32..9, 3u32..9),
        pieces in prop::collection::vec(0usize..4, 128),
        seed in any::<u64>(),
        // Splits on both sides, on the side of odd pieces, on the side of even pieces.
        sides in 0usize..3,
        (triangles, fans) in (any::<bool>(), any::<bool>()),
        exponent in -200i32..200,
        shift in -2.0..2.0,
    ) {
        let mut whole = torus(n, m);
        whole.points.iter_mut().flatten().for_each(|x| *x = (*x + shift) * 2f64.powi(exponent));
        if triangles {
            whole = triangulated(&whole);
        }
        let more = |piece: usize, edge| match sides {
            1 | 2 if piece % 2 == sides - 1 => Vec::new(),
            _ => places(seed, piece, edge, 1, 5),
        };
        let parts = cut(&whole, |f| pieces[f], more, fans);
        let done = sewn(&parts, &Options::default());
        assert_closed(&done.mesh, 0);
        let unit = 2f64.powi(exponent);
        let [old, new] = [
            volume(soup_positions(&parts), parts.faces()) / unit.powi(3),
            volume(mesh_positions(&done.mesh), faces_of(&done.mesh)) / unit.powi(3),
        ];
        // Flat faces keep their volume; quads of a torus that gain corners are not flat.
        if triangles {
            prop_assert!((old / new - 1.0).abs() < 1e-9, "{} {}", old, new);
            let [old, new] = [area(soup_positions(&whole), whole.faces()), area(mesh_positions(&done.mesh), faces_of(&done.mesh))];
            prop_assert!((old / new - 1.0).abs() < 1e-9, "{} {}", old, new);
        }
        prop_assert!(done.left_vertices.is_empty());
        prop_assert_eq!(done.dropped_faces, 0);
        // Nothing is left to do, and threads change nothing.
        let view = done.mesh.view(&Job::default()).unwrap();
        let again = sew(&view, &Options::default(), &Job::default()).unwrap();
        prop_assert_eq!((again.splits, again.sewn_edges, &again.mesh), (0, 0, &done.mesh));
        let alone = Job::default();
        prop_assert_eq!(&sew(&parts.view(), &Options::default(), &alone).unwrap(), &done);
    }

    /// Triangles on a coarse lattice, with every kind of coincidence, and any tolerance.
    #[test]
    fn nothing_becomes_worse(
        cells in prop::collection::vec((0u8..4, 0u8..4, 0u8..2), 6..40),
        corners in prop::collection::vec((0usize..40, 0usize..40, 0usize..40), 1..30),
        tolerance in prop::option::of(prop_oneof![Just(0.0), 0.0..2.0, Just(1e300)]),
        (all, collapse, remove_unused) in (any::<bool>(), any::<bool>(), any::<bool>()),
    ) {
        let points: Vec<_> = cells.iter().map(|&(x, y, z)| [f64::from(x), f64::from(y), f64::from(z)]).collect();
        let index = |i: usize| (i % points.len()) as u32;
        let faces: Vec<_> = corners.iter().map(|&(a, b, c)| [index(a), index(b), index(c)]).collect();
        let list: Vec<&[u32]> = faces.iter().map(<[u32; 3]>::as_slice).collect();
        let soup = Soup::new(points, &list);
        let vertices = if all { Vertices::All } else { Vertices::Boundary };
        let options = Options { vertices, tolerance, collapse, remove_unused };
        let done = sew(&soup.view(), &options, &Job::default()).unwrap();
        let proper = |face: &&[u32]| face.iter().collect::<HashSet<_>>().len() == 3;
        if all {
            // Welding all vertices may add defects; sewing afterwards adds none.
            let weld = gusset::repair::weld::weld(&soup.view(), &options, &Job::default()).unwrap();
            let worse = |mesh: &Mesh| (non_manifold_edges(faces_of(mesh).filter(proper)), degenerate_faces(faces_of(mesh)));
            let [before, after] = [worse(&weld.mesh), worse(&done.mesh)];
            prop_assert!(after.0 <= before.0 && after.1 <= before.1, "{:?} {:?}", before, after);
        } else {
            prop_assert!(non_manifold_edges(faces_of(&done.mesh).filter(proper)) <= non_manifold_edges(soup.faces().filter(proper)));
            prop_assert!(degenerate_faces(faces_of(&done.mesh)) <= degenerate_faces(soup.faces()));
        }
    }
}

/// A row of `count` triangles below the x axis, from `from` on, `step` wide.
fn comb(from: f64, step: f64, count: u32, y: f64) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for i in 0..=count {
        soup.points.push([from + step * f64::from(i), 0.0, 0.0]);
    }
    soup.points.push([from + step * f64::from(count) / 2.0, y, 0.0]);
    for i in 0..count {
        soup.face(&[i, i + 1, count + 1]);
    }
    soup
}

#[test]
fn a_long_edge_is_split_at_all_vertices_of_the_border_on_it() {
    let upper = Soup::new(vec![[0.0; 3], [10.0, 0.0, 0.0], [5.0, 4.0, 0.0]], &[&[0, 1, 2]]);
    let soup = upper.and(&comb(0.0, 1.0, 10, -3.0));
    let done = sewn(&soup, &Options::default());
    assert_eq!((done.splits, done.split_faces, done.sewn_edges, done.welded_vertices), (9, 1, 10, 2));
    assert_eq!((done.mesh.face_count(), done.mesh.positions.len()), (20, 13));
    assert_eq!(&done.face_origin[..11], [[0; 10].as_slice(), &[1]].concat());
    assert_eq!(&done.face_map[..3], [0, 10, 11]);
    assert_eq!(euler(faces_of(&done.mesh)), 1);
    assert!(done.left_vertices.is_empty());
    let flat = area(mesh_positions(&done.mesh), faces_of(&done.mesh));
    assert!((flat - area(soup_positions(&soup), soup.faces())).abs() < 1e-12);
    // A larger face gains corners instead.
    let upper = Soup::new(vec![[0.0; 3], [10.0, 0.0, 0.0], [10.0, 4.0, 0.0], [0.0, 4.0, 0.0]], &[&[0, 1, 2, 3]]);
    let done = sewn(&upper.and(&comb(0.0, 1.0, 10, -3.0)), &Options::default());
    assert_eq!((done.splits, done.sewn_edges, done.mesh.face_count()), (9, 10, 11));
    assert_eq!(faces_of(&done.mesh).next().unwrap().len(), 13);
}

#[test]
fn a_triangle_split_on_all_sides() {
    let points = [[0.0, 0.0], [6.0, 0.0], [0.0, 6.0]].map(|[x, y]| [x, y, 0.0]);
    for counts in [[1, 2, 3], [3, 1, 2], [0, 2, 2], [4, 0, 1], [0, 0, 5]] {
        let mut soup = Soup::new(points.to_vec(), &[&[0, 1, 2]]);
        let mut sides = 0;
        for k in 0..3 {
            let (p, q) = (points[k], points[(k + 1) % 3]);
            let n = counts[k] + 1;
            let out = [[3.0, -5.0, 0.0], [6.0, 6.0, 0.0], [-5.0, 3.0, 0.0]][k];
            let mut fan = Soup { points: vec![out], offsets: vec![0], corners: Vec::new() };
            for i in 0..=n {
                fan.points.push([0, 1, 2].map(|axis| p[axis] + (q[axis] - p[axis]) * f64::from(i) / f64::from(n)));
            }
            (1..=n).for_each(|i| fan.face(&[i + 1, i, 0]));
            sides += n;
            soup = soup.and(&fan);
        }
        let done = sewn(&soup, &Options::default());
        assert_eq!((done.splits, done.sewn_edges), (counts.iter().sum(), sides), "{counts:?}");
        assert_eq!(euler(faces_of(&done.mesh)), 1);
        assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(a, b)| a <= 1 && b <= 1), "oriented");
        let parts: Vec<&[u32]> =
            faces_of(&done.mesh).zip(&done.face_origin).filter(|&(_, &f)| f == 0).map(|(face, _)| face).collect();
        assert_eq!(parts.len(), counts.iter().sum::<u32>() as usize + 1);
        assert!((area(mesh_positions(&done.mesh), parts.iter().copied()) - 18.0).abs() < 1e-12);
        for part in parts {
            assert!(area(mesh_positions(&done.mesh), [part].into_iter()) > 0.1);
        }
    }
}

#[test]
fn what_touches_without_matching_is_left_and_listed() {
    let upper = Soup::new(vec![[0.0; 3], [10.0, 0.0, 0.0], [5.0, 4.0, 0.0]], &[&[0, 1, 2]]);
    // The tip of a triangle in the middle of an edge.
    let tip = Soup::new(vec![[4.0, 0.0, 0.0], [3.0, -2.0, 0.0], [5.0, -2.0, 0.0]], &[&[0, 1, 2]]);
    let done = sewn(&upper.and(&tip), &Options::default());
    assert_eq!((done.splits, done.sewn_edges, done.welded_vertices), (0, 0, 0));
    assert_eq!(done.left_vertices, [3]);
    assert_eq!(done.mesh.face_corners, upper.and(&tip).corners);
    // A border that lies on a part of the edge is sewn there, and a tip beside it left.
    let done = sewn(&upper.and(&comb(6.0, 1.0, 3, -3.0)).and(&tip), &Options::default());
    assert_eq!((done.splits, done.sewn_edges), (4, 3));
    assert_eq!(done.left_vertices, [8]);
    assert_eq!(euler(faces_of(&done.mesh)), 2);
    // Too far away for the default, not for a tolerance that is given.
    let mut above = comb(0.0, 1.0, 10, -3.0);
    above.points.iter_mut().for_each(|p| p[2] = 1e-3);
    let soup = upper.and(&above);
    assert_eq!(sewn(&soup, &Options::default()).sewn_edges, 0);
    assert_eq!(sewn(&soup, &Options { tolerance: Some(2e-3), ..Options::default() }).sewn_edges, 10);
    assert_eq!(sewn(&soup, &Options { tolerance: Some(0.0), ..Options::default() }).sewn_edges, 0);
    // Three sheets on one line: none is preferred.
    let mut third = comb(0.0, 2.0, 5, -3.0);
    third.points.last_mut().unwrap()[2] = 3.0;
    let mut fourth = comb(0.0, 1.0, 10, -3.0);
    fourth.points.last_mut().unwrap()[2] = -3.0;
    let three = upper.and(&third).and(&fourth);
    let done = sewn(&three, &Options::default());
    assert_eq!((done.splits, done.sewn_edges, non_manifold_edges(faces_of(&done.mesh))), (0, 0, 0));
    assert!(!done.left_vertices.is_empty());
    // A face does not meet itself: a corner on a side of its own is nothing to sew.
    let spike = Soup::new(vec![[0.0; 3], [4.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 3.0, 0.0]], &[&[0, 1, 2, 3]]);
    assert_eq!(sewn(&spike, &Options::default()).splits, 0);
}

#[test]
fn what_files_round_apart_is_sewn_too() {
    let mut whole = triangulated(&torus(14, 9));
    for p in &mut whole.points {
        let [x, y, z] = *p;
        *p = [0.6 * x - 0.48 * y + 0.64 * z, 0.8 * x + 0.36 * y - 0.48 * z, 0.8 * y + 0.6 * z];
    }
    let exact = cut(&whole, |f| f / 2 % 3, |piece, edge| places(5, piece, edge, 1, 5), false);
    let mut written = exact.clone();
    written.points.iter_mut().flatten().for_each(|x| *x = format!("{x:.6e}").parse().unwrap());
    let done = sewn(&written, &Options::default());
    assert_closed(&done.mesh, 0);
    let [old, new] =
        [volume(soup_positions(&exact), exact.faces()), volume(mesh_positions(&done.mesh), faces_of(&done.mesh))];
    assert!((old / new - 1.0).abs() < 1e-6);
    let points: Vec<[f32; 3]> = exact.points.iter().map(|p| p.map(|x| x as f32)).collect();
    let faces = Faces::polygons(&exact.offsets, &exact.corners).unwrap();
    let view = MeshView::new(Positions::from(points.as_slice()), faces, &Job::default()).unwrap();
    assert_closed(&sew(&view, &Options::default(), &Job::default()).unwrap().mesh, 0);
    // Equal positions only: rounded vertices are beside the edges.
    let strict = sewn(&written, &Options { tolerance: Some(0.0), ..Options::default() });
    assert!(strict.sewn_edges < done.sewn_edges && !strict.left_vertices.is_empty());
}

#[test]
fn no_part_of_a_triangle_is_turned_over() {
    // Vertices within the tolerance of an edge, and beyond the corner across.
    let flat = Soup::new(vec![[0.0; 3], [10.0, 0.0, 0.0], [5.0, 0.1, 0.0]], &[&[0, 1, 2]]);
    let mut beside = comb(0.0, 2.0, 5, -3.0);
    (1..5).for_each(|i| beside.points[i][1] = 0.2);
    let options = Options { tolerance: Some(0.3), ..Options::default() };
    let done = sewn(&flat.and(&beside), &options);
    assert_eq!((done.splits, done.left_vertices.is_empty()), (0, false));
    // With the corner far enough away they are sewn.
    let mut high = flat.clone();
    high.points[2][1] = 4.0;
    assert_eq!(sewn(&high.and(&beside), &options).sewn_edges, 5);
}

#[test]
fn edges_of_the_tolerances_size_are_not_split() {
    // Two edges bulge away from one of length 1.5, by 0.5.
    let upper = Soup::new(vec![[0.0; 3], [1.5, 0.0, 0.0], [0.75, 3.0, 0.0]], &[&[0, 1, 2]]);
    let points = vec![[0.0; 3], [0.75, -0.5, 0.0], [1.5, 0.0, 0.0], [0.75, -3.0, 0.0]];
    let soup = upper.and(&Soup::new(points, &[&[1, 0, 3], &[2, 1, 3]]));
    for (tolerance, edges) in [(0.4, 0), (0.6, 2), (0.8, 0)] {
        let done = sewn(&soup, &Options { tolerance: Some(tolerance), ..Options::default() });
        assert_eq!(done.sewn_edges, edges, "{tolerance}");
    }
}

#[test]
fn a_slit_with_different_vertices_on_its_sides_closes() {
    // A square round its centre, slit along the x axis: 0 to 2 above, 0 to 1 to 2 below.
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [-4.0, 0.0], [0.0, -4.0], [1.0, 0.0], [4.0, 0.0]];
    let points: Vec<_> = points.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let soup = Soup::new(points, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 5], &[5, 4, 6]]);
    let done = sewn(&soup, &Options::default());
    assert_eq!((done.splits, done.sewn_edges, done.welded_vertices), (1, 2, 1));
    assert_eq!(euler(faces_of(&done.mesh)), 1);
    assert_eq!(edge_counts(faces_of(&done.mesh)).values().filter(|&&(a, b)| a + b == 1).count(), 4);
}

#[test]
fn bad_input_is_refused_or_left_as_it_is() {
    let soup = sheet(3, 2);
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let options = Options { tolerance: Some(bad), ..Options::default() };
        let found = sew(&soup.view(), &options, &Job::default());
        assert!(matches!(found, Err(Error::OptionOutOfRange { option: "tolerance", .. })));
    }
    // A sheet without neighbours is unchanged at any tolerance.
    for tolerance in [0.0, 1e-300, 0.3, 0.9, 3.0, 1e300] {
        let done = sewn(&soup, &Options { tolerance: Some(tolerance), ..Options::default() });
        assert_eq!((done.mesh.face_count(), done.splits, euler(faces_of(&done.mesh))), (6, 0, 1), "{tolerance}");
    }
    // All faces collapse.
    let done = sew(
        &soup.view(),
        &Options { tolerance: Some(1e3), collapse: true, vertices: Vertices::All, remove_unused: true },
        &Job::default(),
    );
    assert_eq!(done.unwrap().mesh.face_count(), 0);
    for size in [1e-300, 1e300] {
        let mut parts =
            Soup::new(vec![[0.0; 3], [10.0, 0.0, 0.0], [5.0, 4.0, 0.0]], &[&[0, 1, 2]]).and(&comb(0.0, 1.0, 10, -3.0));
        parts.points.iter_mut().flatten().for_each(|x| *x *= size);
        parts.points.push([f64::NAN; 3]);
        assert_eq!(sewn(&parts, &Options { remove_unused: true, ..Options::default() }).sewn_edges, 10, "{size}");
    }
}

/// Cancels after this many reports.
struct Impatient(Cell<u32>);

impl Progress for Impatient {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        let left = self.0.get();
        self.0.set(left.saturating_sub(1));
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn sewing_can_be_stopped_at_any_report() {
    let whole = torus(6, 5);
    let parts = cut(&whole, |f| f % 3, |piece, edge| places(3, piece, edge, 1, 4), true);
    let mut reports = 0;
    loop {
        let progress = Impatient(Cell::new(reports));
        match sew(&parts.view(), &Options::default(), &Job::new(1, &progress)) {
            Err(Error::Cancelled) => reports += 1,
            done => {
                assert_closed(&done.unwrap().mesh, 0);
                break;
            }
        }
    }
    assert!(reports > 20);
    let steady = crate::common::Steady::default();
    sew(&parts.view(), &Options::default(), &Job::new(1, &steady)).unwrap();
}

#[test]
fn pieces_that_do_not_match_are_assembled_closed() {
    let whole = triangulated(&torus(9, 7));
    let all = cut(&whole, |f| f / 2 % 3, |piece, edge| places(11, piece, edge, 1, 5), true);
    let components = components(&all);
    // Pieces with vertices of their own, some of them turned over.
    let part = |wanted: usize| {
        let mut piece = Soup { offsets: vec![0], ..Soup::default() };
        let mut names = HashMap::new();
        for face in all.faces() {
            // Faces of one piece are connected by vertices: the piece of a face is the component of
            // its first vertex.
            if components[face[0] as usize] % 3 != wanted as u32 {
                continue;
            }
            let mut own: Vec<u32> = Vec::new();
            for &v in face {
                own.push(*names.entry(v).or_insert_with(|| {
                    piece.points.push(all.points[v as usize]);
                    piece.points.len() as u32 - 1
                }));
            }
            if wanted == 1 {
                own.reverse();
            }
            piece.face(&own);
        }
        piece
    };
    let pieces: Vec<Soup> = (0..3).map(part).filter(|piece| piece.offsets.len() > 1).collect();
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let options =
        assemble::Options { weld: Some(Options::default()), max_gap: MaxGap::Given(0.0), ..Default::default() };
    let done = assemble(&views, &options, &Job::default()).unwrap();
    assert_closed(&done.mesh, 0);
    assert!(done.splits > 0 && done.loops_left == 0);
    // The maps name the first part of each face, which contains one of its corners at least, and
    // all parts lie within the face: areas add up.
    let parts: Vec<&[u32]> = faces_of(&done.mesh).collect();
    for (piece, map) in pieces.iter().zip(&done.maps) {
        for (face, &first) in piece.faces().zip(&map.faces) {
            let next = done.maps.iter().flat_map(|map| &map.faces).filter(|&&f| f > first).min();
            let end = next.map_or(parts.len(), |&f| f as usize);
            let [old, new] = [
                area(soup_positions(piece), [face].into_iter()),
                area(mesh_positions(&done.mesh), parts[first as usize..end].iter().copied()),
            ];
            assert!((old / new - 1.0).abs() < 1e-9, "{old} {new}");
        }
    }
    let strict = assemble(&views, &assemble::Options { edge_to_edge: true, ..options }, &Job::default()).unwrap();
    assert!(strict.loops_left > 0 && strict.splits == 0);
}

/// Per vertex, the smallest vertex that hangs together with it by faces.
fn components(soup: &Soup) -> Vec<u32> {
    let mut smallest: Vec<u32> = (0..soup.points.len() as u32).collect();
    loop {
        let before = smallest.clone();
        for face in soup.faces() {
            let least = face.iter().map(|&v| smallest[v as usize]).min().unwrap();
            face.iter().for_each(|&v| smallest[v as usize] = least);
        }
        if smallest == before {
            return smallest;
        }
    }
}
