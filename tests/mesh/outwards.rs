//! Closed results are oriented outwards: by default in assembly, on request in stitching and
//! filling. Volumes by the divergence theorem say which way a result faces.

use crate::common::{Soup, cap, edge_counts, faces_of, sheet, torus, volume};
use crate::pieces::{cube, cut};
use gusset::assemble::{self, Assembly, assemble};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::mesh::{Mesh, MeshView};
use gusset::repair::orient::{Outward, turn_outwards};
use gusset::stitch::{self, Extent, Request, Rows, Stitch, stitch};
use gusset::{Error, Job, Progress};
use std::cell::RefCell;
use std::ops::ControlFlow;

fn volume_of(mesh: &Mesh) -> f64 {
    volume(|v| mesh.positions.get(v).to_array(), faces_of(mesh))
}

fn mesh_of(soup: &Soup) -> Mesh {
    gusset::mesh::concatenate(&[soup.view()], &Job::default()).unwrap().0
}

fn from_second_corner(face: &[u32]) -> Vec<u32> {
    let mut face = face.to_vec();
    face[1..].reverse();
    face
}

/// `now` is `before` with these faces turned over, and nothing else.
fn assert_turned(before: &Mesh, now: &Mesh, turned: &[u32]) {
    assert!(turned.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!((&now.positions, &now.face_offsets), (&before.positions, &before.face_offsets));
    for (f, (was, is)) in (0..).zip(faces_of(before).zip(faces_of(now))) {
        let expected = if turned.contains(&f) { from_second_corner(was) } else { was.to_vec() };
        assert_eq!(is, expected, "face {f}");
    }
}

/// Closed and consistently oriented.
fn assert_closed(mesh: &Mesh) {
    assert!(edge_counts(faces_of(mesh)).values().all(|&counts| counts == (1, 1)));
}

/// Keeps the notes.
#[derive(Default)]
struct Notes(RefCell<Vec<String>>);

impl Progress for Notes {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn note(&self, message: &str) {
        self.0.borrow_mut().push(message.to_owned());
    }
}

#[test]
fn whole_closed_consistent_components_are_turned_and_no_others() {
    let mut twisted = torus(4, 3).turned();
    twisted.corners.swap(4 * 5 + 1, 4 * 5 + 3);
    // Two cubes with a common edge, which has four faces then, are not closed: nothing says which of
    // them belong together.
    let cube = cube(1).turned();
    let mut book = cube.clone();
    let corner = |x: f64, y: f64, z: f64| cube.points.iter().position(|p| *p == [x, y, z]).unwrap() as u32;
    let names: Vec<u32> = (0..8)
        .map(|v| match cube.points[v as usize] {
            [-0.5, -0.5, z] => corner(0.5, 0.5, z),
            _ => v + 8,
        })
        .collect();
    book.points.extend(cube.points.iter().map(|p| [p[0] + 1.0, p[1] + 1.0, p[2]]));
    for face in cube.faces() {
        book.face(&face.iter().map(|&v| names[v as usize]).collect::<Vec<_>>());
    }
    assert_eq!(edge_counts(book.faces()).values().filter(|&&(m, n)| m + n == 4).count(), 1);

    let parts = [
        (torus(5, 4), false),
        (torus(5, 4).turned(), true),
        (torus(3, 3).turned(), true),
        (sheet(3, 2).turned(), false),
        (cap(6, 2, 0.2, 1.0).turned(), false),
        (twisted, false),
        (book, false),
        (Soup::flat(3, &[&[0, 2, 1], &[0, 1, 2]]), false),
    ];
    let mut whole = Soup { offsets: vec![0], ..Soup::default() };
    let mut expected = Vec::new();
    for (part, is_turned) in &parts {
        let first = whole.offsets.len() as u32 - 1;
        whole = whole.and(part);
        expected.extend((first..whole.offsets.len() as u32 - 1).filter(|_| *is_turned));
    }
    let before = mesh_of(&whole);
    for threads in [1, 3] {
        let mut mesh = before.clone();
        let notes = Notes::default();
        assert_eq!(turn_outwards(&mut mesh, &Job::new(threads, &notes)).unwrap().turned, expected);
        assert_turned(&before, &mesh, &expected);
        assert_eq!(notes.0.borrow().len(), 1);
        // A second call changes and reports nothing.
        assert!(turn_outwards(&mut mesh, &Job::new(threads, &notes)).unwrap().turned.is_empty());
        assert_turned(&before, &mesh, &expected);
        assert_eq!(notes.0.borrow().len(), 1);
    }
}

fn assembled(pieces: &[Soup], options: &assemble::Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

/// A row in each strip, and results as most of the first piece has them.
fn staying() -> assemble::Options<'static> {
    let strip = stitch::Options { rows: Rows::Count(1), ..stitch::Options::default() };
    assemble::Options { outward: Outward::Keep, strip, ..assemble::Options::default() }
}

#[test]
fn an_assembly_faces_outwards_unless_told_not_to() {
    // Two halves of a sphere, and a cube with a hole that is filled: each piece either way.
    let halves = [cap(12, 4, 0.1, 1.0), cap(15, 4, 0.1, -1.0)];
    let mut lid = cut(&cube(3), |p| (p[2] < 0.4).then_some(0)).remove(0);
    lid.points.iter_mut().for_each(|p| p[0] += 50.0);
    for set in 0..8u32 {
        let given: Vec<Soup> = [&halves[0], &halves[1], &lid]
            .iter()
            .zip(0..)
            .map(|(piece, k)| if set >> k & 1 == 1 { piece.turned() } else { (*piece).clone() })
            .collect();
        let fill = Some(fill::Options { outward: Outward::Closed, ..fill::Options::default() });
        let kept = assembled(&given, &assemble::Options { fill, ..staying() });
        let done = assembled(&given, &assemble::Options { fill, outward: Outward::Closed, ..staying() });
        for (result, outwards) in [(&kept, [set & 1 == 0, set & 4 == 0]), (&done, [true; 2])] {
            assert_closed(&result.mesh);
            assert_eq!((result.joints.len(), result.holes.len(), result.loops_left), (1, 1, 0));
            let is_far = |face: &&[u32]| result.mesh.positions.get(face[0]).x > 25.0;
            let at = |v: u32| (result.mesh.positions.get(v)).to_array();
            let near = volume(at, faces_of(&result.mesh).filter(|face| !is_far(face)));
            let far = volume(at, faces_of(&result.mesh).filter(is_far));
            assert_eq!([near > 0.0, far > 0.0], outwards, "{set}");
            // A face reported as reversed has the opposite direction of its piece.
            let faces: Vec<&[u32]> = faces_of(&result.mesh).collect();
            for (piece, map) in given.iter().zip(&result.maps) {
                for (face, &now) in piece.faces().zip(&map.faces) {
                    let named: Vec<u32> = face.iter().map(|&v| map.vertices[v as usize]).collect();
                    let expected = if result.turned[now as usize] { from_second_corner(&named) } else { named };
                    assert_eq!(faces[now as usize], expected);
                }
            }
            assert_eq!(result.turned.len(), given.iter().map(|piece| piece.faces().count()).sum::<usize>());
        }
        // In the end the pieces that were inside out are turned, and no others.
        for (k, map) in done.maps.iter().enumerate() {
            assert!(map.faces.iter().all(|&f| done.turned[f as usize] == (set >> k & 1 == 1)), "{set} {k}");
        }
        // Everything else is equal.
        let named = |result: &Assembly| (result.maps.clone(), result.joints.clone(), result.hole_rims.clone());
        assert_eq!(named(&done), named(&kept));
        let turned: Vec<u32> = (0..)
            .zip(faces_of(&kept.mesh).zip(faces_of(&done.mesh)))
            .filter(|(_, (was, is))| was != is)
            .map(|(f, _)| f)
            .collect();
        assert_turned(&kept.mesh, &done.mesh, &turned);
        // Without the option no face is reversed.
        let options = assemble::Options { keep_orientation: true, outward: Outward::Closed, fill, ..staying() };
        assert!(!assembled(&given, &options).turned.contains(&true));
    }
}

#[test]
fn an_open_assembly_is_the_same_bit_for_bit() {
    let mut beside = sheet(10, 10);
    beside.points.iter_mut().for_each(|p| p[0] += 10.5);
    let pieces = vec![sheet(10, 10), beside];
    for given in [pieces.clone(), pieces.iter().map(Soup::turned).collect()] {
        let kept = assembled(&given, &staying());
        assert!(kept.loops_left > 0 && !kept.joints.is_empty());
        assert_eq!(assembled(&given, &assemble::Options { outward: Outward::Closed, ..staying() }), kept);
    }
}

fn stitched(a: &Soup, b: &Soup, options: &stitch::Options) -> Result<Stitch, Error> {
    let (a, b) = (a.view(), b.view());
    stitch(&Request { a: &a, loop_a: None, b: Some(&b), loop_b: None }, options, &Job::default())
}

#[test]
fn a_stitch_faces_outwards_if_asked_to() {
    let (a, b) = (cap(12, 4, 0.2, 1.0), cap(9, 4, 0.2, -1.0));
    for rows in [Rows::None, Rows::Count(2)] {
        let keeping = stitch::Options { rows, ..stitch::Options::default() };
        let asked = stitch::Options { outward: Outward::Closed, ..keeping };
        for (a, b, turned) in [
            (a.clone(), b.clone(), false),
            (a.clone(), b.turned(), false),
            (a.turned(), b.clone(), true),
            (a.turned(), b.turned(), true),
        ] {
            let kept = stitched(&a, &b, &keeping).unwrap();
            assert_eq!((volume_of(&kept.mesh) > 0.0, kept.turned_outwards.is_empty()), (!turned, true));
            let done = stitched(&a, &b, &asked).unwrap();
            assert_closed(&done.mesh);
            assert!(volume_of(&done.mesh) > 3.0);
            let all: Vec<u32> = (0..done.mesh.face_count() as u32).filter(|_| turned).collect();
            assert_eq!(done.turned_outwards, all);
            assert_turned(&kept.mesh, &done.mesh, &all);
            // The separate strip equals the strip of the whole.
            let count = done.mesh.positions.len() as u32;
            let new = count - done.parents.len() as u32..count;
            let names: Vec<u32> = done.rims.iter().flatten().copied().chain(new).collect();
            let strip: Vec<Vec<u32>> =
                faces_of(&done.strip).map(|face| face.iter().map(|&v| names[v as usize]).collect()).collect();
            assert!(faces_of(&done.mesh).skip(done.strip_faces.start as usize).eq(strip.iter().map(Vec::as_slice)));
            // Everything else is unchanged, including the reversal of the second piece.
            let restored =
                Stitch { mesh: kept.mesh.clone(), strip: kept.strip.clone(), turned_outwards: Vec::new(), ..done };
            assert_eq!(restored, kept);
        }
    }
}

#[test]
fn an_open_stitch_is_the_same_bit_for_bit() {
    let mut beside = sheet(4, 5);
    beside.points.iter_mut().for_each(|p| p[0] += 5.0);
    let keeping = stitch::Options { extent: Extent::OpenArcs, ..stitch::Options::default() };
    let asked = stitch::Options { outward: Outward::Closed, ..keeping };
    for a in [sheet(4, 5), sheet(4, 5).turned()] {
        let kept = stitched(&a, &beside, &keeping).unwrap();
        assert!(kept.quality.loops_left > 0);
        assert_eq!(stitched(&a, &beside, &asked).unwrap(), kept);
    }
}

#[test]
fn a_filled_mesh_faces_outwards_if_asked_to() {
    let asked = fill::Options { outward: Outward::Closed, ..fill::Options::default() };
    let filled = |soup: &Soup, options: &fill::Options| {
        fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap()
    };
    for (soup, turned) in [(cap(12, 4, 0.2, 1.0), false), (cap(12, 4, 0.2, 1.0).turned(), true)] {
        let kept = filled(&soup, &fill::Options::default());
        assert_eq!((volume_of(&kept.mesh) > 0.0, kept.turned_outwards.is_empty()), (!turned, true));
        let done = filled(&soup, &asked);
        assert_closed(&done.mesh);
        assert!(volume_of(&done.mesh) > 1.0);
        let all: Vec<u32> = (0..done.mesh.face_count() as u32).filter(|_| turned).collect();
        assert_eq!(done.turned_outwards, all);
        assert_turned(&kept.mesh, &done.mesh, &all);
        assert_eq!(fill::Filled { mesh: kept.mesh.clone(), turned_outwards: Vec::new(), ..done }, kept);
        // An open result is unchanged.
        let limits = fill::Limits { edges: Some(3), ..fill::Limits::default() };
        let open = filled(&soup, &fill::Options { limits, ..asked });
        assert_eq!(open, filled(&soup, &fill::Options { limits, ..fill::Options::default() }));
        assert_turned(&mesh_of(&soup), &open.mesh, &[]);
    }
}
