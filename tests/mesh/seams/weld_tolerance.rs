//! The default tolerance of welding: what files and 32 bits round apart comes together, and nothing
//! else does.

use crate::common::{Soup, edge_counts, euler, faces_of, sheet, torus};
use gusset::Job;
use gusset::assemble::{self, assemble};
use gusset::check::check;
use gusset::mesh::{Faces, Mesh, MeshView, Positions};
use gusset::repair::weld::{Options, Vertices, Weld, weld};
use std::collections::{HashMap, HashSet};

/// Numbers from 0 to 1, the same each time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// The mesh's faces in four pieces with vertices of their own, each coordinate off by up to `noise`
/// and then written by `write`.
fn pieces(whole: &Soup, noise: f64, write: impl Fn(f64) -> f64) -> Soup {
    let mut random = Random(7);
    let mut pieces = Soup { offsets: vec![0], ..Soup::default() };
    let mut names = HashMap::new();
    for (f, face) in whole.faces().enumerate() {
        let piece = (f / 3) % 4;
        let mut own = Vec::new();
        for &v in face {
            own.push(*names.entry((piece, v)).or_insert_with(|| {
                let point = whole.points[v as usize].map(|x| write(x + noise * (2.0 * random.next() - 1.0)));
                pieces.points.push(point);
                pieces.points.len() as u32 - 1
            }));
        }
        pieces.face(&own);
    }
    pieces
}

/// Written with this many significant digits.
fn digits(count: usize) -> impl Fn(f64) -> f64 {
    move |x| format!("{x:.*e}", count - 1).parse().unwrap()
}

/// Written with this many decimals.
fn decimals(count: usize) -> impl Fn(f64) -> f64 {
    move |x| format!("{x:.count$}").parse().unwrap()
}

fn turned(mut soup: Soup) -> Soup {
    for p in &mut soup.points {
        let [x, y, z] = *p;
        *p = [0.6 * x - 0.48 * y + 0.64 * z, 0.8 * x + 0.36 * y - 0.48 * z, 0.8 * y + 0.6 * z];
    }
    soup
}

fn mapped(soup: &Soup, map: impl Fn([f64; 3]) -> [f64; 3]) -> Soup {
    Soup { points: soup.points.iter().map(|&p| map(p)).collect(), ..soup.clone() }
}

fn welded(soup: &Soup, tolerance: Option<f64>) -> Weld {
    weld(&soup.view(), &Options { tolerance, ..Options::default() }, &Job::default()).unwrap()
}

/// The same in 32 bits.
fn welded_single(soup: &Soup) -> Weld {
    let points: Vec<[f32; 3]> = soup.points.iter().map(|p| p.map(|x| x as f32)).collect();
    let faces = Faces::polygons(&soup.offsets, &soup.corners).unwrap();
    let view = MeshView::new(Positions::from(points.as_slice()), faces, &Job::default()).unwrap();
    weld(&view, &Options::default(), &Job::default()).unwrap()
}

/// A closed torus of as many vertices and faces as `whole`, none of the faces degenerate.
#[track_caller]
fn assert_whole(mesh: &Mesh, whole: &Soup) {
    assert_eq!(mesh.positions.len(), whole.points.len());
    assert_eq!(mesh.face_count(), whole.faces().count());
    assert_eq!(euler(faces_of(mesh)), 0);
    assert!(edge_counts(faces_of(mesh)).values().all(|&count| count == (1, 1)));
    for face in faces_of(mesh) {
        assert_eq!(face.iter().collect::<HashSet<_>>().len(), face.len());
    }
    let found = check(&mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.manifold && found.oriented && found.closed);
}

#[test]
fn what_files_round_apart_comes_together() {
    let whole = turned(torus(30, 20));
    let edges = edge_counts(whole.faces()).len();
    let open = |soup: &Soup| {
        let inner = edge_counts(soup.faces()).values().filter(|&&(a, b)| a + b == 2).count();
        edges - inner
    };
    for (size, noise) in [(1.0, 1e-7), (0.03, 3e-9), (40.0, 4e-6)] {
        let whole = mapped(&whole, |p| p.map(|x| size * x));
        for (soup, wanted) in [
            (pieces(&whole, noise, digits(7)), [2e-6, 2e-8, 2e-4]),
            (pieces(&whole, noise, digits(6)), [2e-5, 2e-7, 2e-3]),
            (pieces(&whole, noise, digits(9)), [0.0; 3]),
        ] {
            let wanted = if size == 1.0 {
                wanted[0]
            } else if size < 1.0 {
                wanted[1]
            } else {
                wanted[2]
            };
            let exact = welded(&soup, Some(0.0));
            assert!(exact.left_edges.is_empty() && (exact.sewn_edges as usize) < open(&soup), "noise shows");
            if wanted == 0.0 {
                // More noise than the digits leave in doubt: it is not for the default to guess.
                assert!(welded(&soup, None).tolerance < noise);
                continue;
            }
            let done = welded(&soup, None);
            assert!((done.tolerance / wanted - 1.0).abs() < 1e-9, "{size}: {} {wanted}", done.tolerance);
            assert_whole(&done.mesh, &whole);
            assert_eq!(done.sewn_edges as usize, open(&soup));
            assert!(done.left_edges.is_empty() && done.left_vertices.is_empty());
            // Only the smallest copy's position stays, bit for bit.
            for (v, &new) in done.vertex_map.iter().enumerate() {
                let first = done.vertex_map.iter().position(|&other| other == new).unwrap();
                let [kept, own] = [first, v].map(|v| soup.points[v]);
                assert_eq!(done.mesh.positions.get(new).to_array(), kept);
                assert!((0..3).all(|k| (kept[k] - own[k]).abs() <= done.tolerance));
            }
        }
        assert_whole(&welded_single(&pieces(&whole, noise, digits(7))).mesh, &whole);
        assert_whole(&welded_single(&pieces(&whole, noise / 10.0, |x| x)).mesh, &whole);
    }
    for count in [5, 6, 8, 10] {
        let soup = pieces(&whole, 0.2 * 10f64.powi(-(count as i32)), decimals(count));
        let done = welded(&soup, None);
        assert!((done.tolerance / (2.0 * 10f64.powi(-(count as i32))) - 1.0).abs() < 1e-9, "{}", done.tolerance);
        assert_whole(&done.mesh, &whole);
    }
    // The error of 64-bit numbers computed in another order.
    let soup = pieces(&whole, 1e-15, |x| x);
    assert!((welded(&soup, Some(0.0)).sewn_edges as usize) < open(&soup));
    assert_whole(&welded(&soup, None).mesh, &whole);
}

#[test]
fn unit_and_place_change_no_decision() {
    let whole = turned(torus(24, 15));
    for soup in [pieces(&whole, 1e-7, digits(7)), pieces(&whole, 1e-7, decimals(6)), pieces(&whole, 1e-15, |x| x)] {
        let wanted = welded(&soup, None);
        assert_whole(&wanted.mesh, &whole);
        for unit in [1e-6, 1e-3, 0.1, 1e6, 10f64.powi(-9)] {
            let done = welded(&mapped(&soup, |p| p.map(|x| x * unit)), None);
            assert_eq!(done.vertex_map, wanted.vertex_map, "{unit}");
            assert!((done.tolerance / unit / wanted.tolerance - 1.0).abs() < 1e-6);
        }
        for shift in [
            [1.0, 2.0, 3.0],
            [100.0, -30.0, 7.3],
            [0.123_456_789_012_3, -3.1, 99.9],
            [0.577_215_664_901_5, 2.236_067_977_499, 1.618_033_988_749],
        ] {
            let done = welded(&mapped(&soup, |p| [p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]]), None);
            assert_eq!(done.vertex_map, wanted.vertex_map, "{shift:?}");
        }
    }
}

#[test]
fn fine_edges_do_not_collapse() {
    // Cells of 1e-6 in a mesh of size 1, whose coordinates have seven decimals.
    let fine = mapped(&sheet(25, 25), |p| [0.4 + 1e-6 * p[0], 0.2 + 1e-6 * p[1], 0.0]);
    let coarse = mapped(&turned(torus(12, 9)), |p| p.map(|x| 0.3 * x));
    let count = fine.faces().count();
    for places in [6, 7] {
        // A vertex with long edges does not take what its neighbour's short edges forbid.
        let long = Soup::new(vec![[0.4, 0.2, 0.0], [-0.3, 0.2, 0.1], [-0.3, 0.1, 0.1]], &[&[0, 1, 2]]);
        let soup = pieces(&coarse, 0.0, decimals(places)).and(&long).and(&fine);
        for vertices in [Vertices::All, Vertices::Boundary] {
            let options = Options { vertices, collapse: true, ..Options::default() };
            let done = weld(&soup.view(), &options, &Job::default()).unwrap();
            assert_eq!(done.dropped_faces, 0);
            let seen: HashSet<u32> =
                faces_of(&done.mesh).skip(soup.faces().count() - count).flatten().copied().collect();
            assert_eq!(seen.len(), fine.points.len());
            // A tolerance that is given is taken at its word.
            let given = Options { tolerance: Some(2e-6), ..options };
            let done = weld(&soup.view(), &given, &Job::default()).unwrap();
            assert!(done.dropped_faces > 0 || vertices == Vertices::Boundary);
        }
    }
    // Copies that lie nearer to each other than their edges are long are still found.
    let apart = pieces(&sheet(9, 9), 0.0, |x| x);
    let mut random = Random(3);
    let mut near = apart.clone();
    near.points.iter_mut().flatten().for_each(|x| *x = 0.4 + 1e-6 * *x + 2e-8 * random.next());
    let scattered = pieces(&torus(40, 30), 0.0, decimals(7)).and(&near);
    let done = welded(&scattered, None);
    assert!((done.tolerance / 2e-7 - 1.0).abs() < 1e-9);
    let seen: HashSet<u32> = faces_of(&done.mesh).skip(40 * 30).flatten().copied().collect();
    assert_eq!(seen.len(), 10 * 10);
}

#[test]
fn gaps_that_are_meant_stay() {
    // Full precision, and a gap far below what seven digits show.
    let one =
        turned(mapped(&sheet(9, 7), |[x, y, _]| [0.7371 * x.sqrt(), 0.2913 * y * y + 0.01 * x.sin(), 0.1 * y.cos()]));
    let shifted = mapped(&one, |p| [p[0], p[1], p[2] + 1e-9]);
    assert_eq!(welded(&one.and(&shifted), None).welded_vertices, 0);
    // Coordinates on a coarse grid, and a gap of one step of it.
    let one = mapped(&sheet(9, 7), |p| [3.0 * p[0], 3.0 * p[1], 0.0]);
    let beside = mapped(&one, |p| [p[0] + 27.01, p[1], p[2]]);
    let done = welded(&one.and(&beside), None);
    assert_eq!((done.welded_vertices, done.tolerance < 1e-12), (0, true));
    // Nothing to weld at all, and all in one point.
    let nothing = Soup::new(vec![[f64::NAN; 3]], &[]);
    let faces = Faces::polygons(&nothing.offsets, &nothing.corners).unwrap();
    assert!(MeshView::new(Positions::from(nothing.points.as_slice()), faces, &Job::default()).is_err());
    let point = Soup::new(vec![[0.0; 3]; 6], &[&[0, 1, 2], &[3, 4, 5]]);
    let done = welded(&point, None);
    assert_eq!((done.tolerance, done.welded_vertices, done.mesh.face_count()), (0.0, 0, 2));
    let huge = mapped(&sheet(2, 2), |p| p.map(|x| (x - 1.0) * f64::MAX));
    assert_eq!(welded(&huge, None).welded_vertices, 0);
    let tiny = mapped(&sheet(2, 2), |p| p.map(|x| x * 5e-324));
    assert_eq!(welded(&tiny, None).welded_vertices, 0);
}

#[test]
fn pieces_of_a_closed_mesh_are_assembled_closed() {
    let whole = turned(torus(30, 20));
    let soup = pieces(&whole, 1e-7, digits(7));
    let cut = |piece: usize| {
        let mut part = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
        soup.faces().enumerate().filter(|(f, _)| (f / 3) % 4 == piece).for_each(|(_, face)| part.face(face));
        part
    };
    let parts = [0, 1, 2, 3].map(cut);
    let views = parts.each_ref().map(Soup::view);
    let run = |weld| {
        let options =
            assemble::Options { weld: Some(weld), max_gap: assemble::MaxGap::Given(0.0), ..Default::default() };
        assemble(&views, &options, &Job::default()).unwrap()
    };
    let done = run(Options { remove_unused: true, ..Options::default() });
    assert_eq!((done.loops_left, done.non_manifold_edges), (0, 0));
    assert_whole(&done.mesh, &whole);
    assert!(run(Options { tolerance: Some(0.0), ..Options::default() }).loops_left > 0);
}
