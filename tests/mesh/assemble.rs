//! Assembly: surfaces by formula are cut into pieces, moved apart, turned inside out and put
//! together again; Euler's formula, volumes and the maps say whether that worked.

use crate::common::{Soup, Steady, edge_counts, euler, faces_of, sheet, torus, volume};
use crate::pieces::{around, cube, cut, shrunk, sphere};
use gusset::assemble::{Assembly, Extent, MaxGap, Options, Outcome, Reason, Selector, assemble};
use gusset::check::check;
use gusset::fill;
use gusset::mesh::{Mesh, MeshView, NONE};
use gusset::repair::orient::Outward;
use gusset::repair::weld;
use gusset::stitch::{self, Fairing, Rows};
use gusset::{Error, Job};
use proptest::prelude::*;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

pub(crate) fn run(pieces: &[Soup], options: &Options<'_>) -> Assembly {
    run_with(pieces, options, &Job::default())
}

pub(crate) fn run_with(pieces: &[Soup], options: &Options<'_>, job: &Job<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let done = assemble(&views, options, job).unwrap();
    assert_account(pieces, &done);
    done
}

pub(crate) fn welding() -> Options<'static> {
    Options { weld: Some(weld::Options::default()), ..Options::default() }
}

pub(crate) fn filling() -> Options<'static> {
    Options { fill: Some(fill::Options::default()), ..Options::default() }
}

pub(crate) fn position(mesh: &Mesh, v: u32) -> [f64; 3] {
    mesh.positions.get(v).to_array()
}

pub(crate) fn volume_of(done: &Assembly) -> f64 {
    volume(|v| position(&done.mesh, v), faces_of(&done.mesh))
}

/// Checks every assembly. The maps lead to faces and positions of the pieces, reversed where the
/// report says so. Each new face and vertex belongs to one joint or hole. Counts agree with the
/// mesh.
pub(crate) fn assert_account(pieces: &[Soup], done: &Assembly) {
    let faces: Vec<&[u32]> = faces_of(&done.mesh).collect();
    assert_eq!(done.maps.len(), pieces.len());
    let (mut taken, mut old) = (vec![0; faces.len()], 0);
    for (piece, map) in pieces.iter().zip(&done.maps) {
        for (face, &now) in piece.faces().zip(&map.faces) {
            let mut expected: Vec<_> = face.iter().map(|&v| piece.points[v as usize]).collect();
            if done.turned[now as usize] {
                expected[1..].reverse();
            }
            let found: Vec<_> = faces[now as usize].iter().map(|&v| position(&done.mesh, v)).collect();
            assert!(found.iter().flatten().zip(expected.iter().flatten()).all(|(x, y)| x == y), "{now}");
            taken[now as usize] += 1;
            old += 1;
        }
        let same = |(&v, p): (&u32, &[f64; 3])| v == NONE || position(&done.mesh, v) == *p;
        assert!(map.vertices.iter().zip(&piece.points).all(same));
    }
    assert_eq!(done.turned.len(), old);
    let kept: usize = pieces.iter().map(|piece| piece.points.len()).sum::<usize>() - done.welded_vertices as usize;
    let mut made = vec![0; done.mesh.positions.len()];
    made[..kept].fill(1);
    let joints = done.joints.iter().map(|joint| (joint.vertices.clone(), joint.faces.clone()));
    for (vertices, new) in joints.chain(done.holes.iter().map(|hole| (hole.vertices.clone(), hole.faces.clone()))) {
        vertices.for_each(|v| made[v as usize] += 1);
        new.for_each(|f| taken[f as usize] += 1);
    }
    assert!(taken.iter().all(|&n| n == 1) && made.iter().all(|&n| n == 1), "{taken:?} {made:?}");
    assert!((0..made.len() as u32).all(|v| done.mesh.positions.get(v).is_finite()));

    let found = check(&done.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert_eq!(found.non_manifold_edges.len(), done.non_manifold_edges as usize);
    for joint in &done.joints {
        assert_eq!(joint.outcome == Outcome::Joined, !joint.faces.is_empty());
        assert!(joint.gap >= 0.0 && joint.gap.is_finite());
        let rims: Vec<u32> = joint.sides.concat();
        for f in joint.faces.clone() {
            let hangs = |v: &u32| rims.contains(v) || joint.vertices.contains(v);
            assert!(faces[f as usize].iter().all(hangs));
        }
    }
}

/// Closed, two-manifold, oriented, of one component.
pub(crate) fn assert_closed(done: &Assembly, chi: i64) {
    assert!(edge_counts(faces_of(&done.mesh)).values().all(|&counts| counts == (1, 1)), "{:?}", done.left);
    let found = check(&done.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.closed && found.manifold && found.oriented, "{:?}", found.bow_ties);
    assert_eq!((euler(faces_of(&done.mesh)), found.components, done.loops_left), (chi, 1, 0));
}

/// Pieces that share their borders come together as the surface that they were cut from.
pub(crate) fn assert_restored(whole: &Soup, pieces: &[Soup]) -> Assembly {
    let done = run(pieces, &welding());
    assert_closed(&done, euler(whole.faces()));
    assert_eq!((done.mesh.positions.len(), done.mesh.face_count()), (whole.points.len(), whole.offsets.len() - 1));
    assert!(done.joints.is_empty() && done.left.is_empty() && done.one_sided.is_empty());
    let free: usize = pieces.iter().map(|p| edge_counts(p.faces()).values().filter(|c| c.0 + c.1 == 1).count()).sum();
    assert_eq!(done.sewn_edges as usize * 2, free);
    done
}

#[test]
fn pieces_that_share_their_borders_are_sewn() {
    for whole in [sphere(13, 9), torus(14, 9), cube(4)] {
        let planes: [fn([f64; 3]) -> usize; 4] = [
            |p| usize::from(p[2] > 0.1),
            |p| (around(p) * 5.0) as usize,
            |p| usize::from(p[0] > 0.0) + 2 * usize::from(p[1] > 0.1) + 4 * usize::from(p[2] > -0.1),
            |p| ((p[0] + 2.0 * p[1] + 3.0 * p[2] + 9.0) * 2.0) as usize,
        ];
        for plane in planes {
            assert_restored(&whole, &cut(&whole, |p| Some(plane(p))));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn pieces_by_any_colours_are_sewn(
        colours in prop::collection::vec(0usize..6, 126), turns in prop::collection::vec(any::<bool>(), 6),
    ) {
        let whole = torus(14, 9);
        let next = Cell::new(0);
        let mut pieces = cut(&whole, |_| Some(colours[next.replace(next.get() + 1)]));
        assert_restored(&whole, &pieces);
        // Some of them inside out: in the end they are turned, and no others, as the whole faces outwards.
        let mut turned = 0;
        for (piece, &turn) in pieces.iter_mut().zip(&turns) {
            if turn {
                turned += piece.offsets.len() - 1;
                *piece = piece.turned();
            }
        }
        let done = assert_restored(&whole, &pieces);
        prop_assert!(volume_of(&done) > 0.0);
        let flipped = done.turned.iter().filter(|&&turned| turned).count();
        prop_assert_eq!(flipped, turned);
        let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
        let kept = assemble(&views, &Options { outward: Outward::Keep, ..welding() }, &Job::default()).unwrap();
        prop_assert!(turned == 63 || (volume_of(&kept) > 0.0) == (turned < 63));
        prop_assert_eq!(kept.turned.iter().filter(|&&turned| turned).count(), turned.min(126 - turned));
    }
}

/// A sphere in slabs, a torus in sectors, with a row of cells missing between them.
pub(crate) fn with_gaps() -> Vec<(Vec<Soup>, i64, usize)> {
    let slabs = |p: [f64; 3]| {
        let ring = (p[2].clamp(-1.0, 1.0).acos() / (TAU / 2.0) * 16.0) as usize;
        [0, 0, 0, 0, 0, 9, 1, 1, 1, 1, 9, 2, 2, 2, 2, 2][ring.min(15)]
    };
    let sectors = |p: [f64; 3]| [0, 0, 0, 0, 9, 1, 1, 1, 9, 2, 2, 2, 2, 2, 2, 9][(around(p) * 16.0) as usize];
    let some = |c: usize| (c < 9).then_some(c);
    vec![
        (cut(&sphere(24, 15), |p| some(slabs(p))), 2, 2),
        (cut(&torus(16, 20), |p| some(sectors(p))), 0, 3),
        (shrunk(cut(&torus(20, 24), |p| Some((around(p) * 5.0) as usize)), 0.05), 0, 5),
        (shrunk(cut(&sphere(24, 15), |p| Some(usize::from(p[2] > 0.01))), 0.03), 2, 1),
    ]
}

#[test]
fn pieces_inside_out_agree_with_the_first() {
    for (pieces, chi, _) in with_gaps() {
        for set in 0..1u32 << pieces.len() {
            let is_turned = |k: usize| set >> k & 1 == 1;
            let given: Vec<Soup> =
                pieces.iter().enumerate().map(|(k, p)| if is_turned(k) { p.turned() } else { p.clone() }).collect();
            let done = run(&given, &Options { outward: Outward::Keep, ..Options::default() });
            assert_closed(&done, chi);
            assert_eq!(volume_of(&done) > 0.0, !is_turned(0));
            for (k, map) in done.maps.iter().enumerate() {
                let expected = is_turned(k) != is_turned(0);
                assert!(map.faces.iter().all(|&f| done.turned[f as usize] == expected), "{set:b} {k}");
            }
            // Where nothing may be turned, nothing is.
            let kept = run(&given, &Options { keep_orientation: true, ..Options::default() });
            assert!(!kept.turned.contains(&true));
        }
    }
}

/// The loops of the joints, by the bits of their positions.
pub(crate) fn sides(done: &Assembly) -> BTreeSet<BTreeSet<[u64; 3]>> {
    let at = |&v: &u32| position(&done.mesh, v).map(f64::to_bits);
    done.joints.iter().map(|joint| joint.sides.iter().flatten().map(at).collect()).collect()
}

#[test]
fn a_face_may_be_turned_twice() {
    // The second piece is inside out except one face, which is reversed to agree with its piece,
    // and then with the first piece.
    let (mut pieces, chi, _) = with_gaps().swap_remove(0);
    let (kept, mut other) =
        (pieces[1].clone(), Soup { points: pieces[1].points.clone(), offsets: vec![0], ..Soup::default() });
    for (f, face) in kept.faces().enumerate() {
        let mut face = face.to_vec();
        if f != 5 {
            face.reverse();
        }
        other.face(&face);
    }
    pieces[1] = other;
    let done = run(&pieces, &Options::default());
    assert_closed(&done, chi);
    for (f, &now) in done.maps[1].faces.iter().enumerate() {
        assert_eq!(done.turned[now as usize], f != 5);
    }
}

#[test]
fn a_strip_beside_a_ring_of_single_faces_repeats_no_edge_of_it() {
    for n in [5, 6, 11] {
        // Both ends of a short tube: the best strip would be the tube itself.
        let mut ring = Soup { offsets: vec![0], ..Soup::default() };
        for k in 0..2 * n {
            let t = TAU * f64::from(k % n) / f64::from(n);
            ring.points.push([t.cos(), t.sin(), f64::from(k / n)]);
        }
        (0..n).for_each(|i| ring.face(&[i, (i + 1) % n, n + (i + 1) % n, n + i]));
        let pair = [Selector { piece: 0, vertex: 0 }, Selector { piece: 0, vertex: n }];
        for rows in [Rows::None, Rows::Count(1)] {
            let strip = stitch::Options { rows, ..stitch::Options::default() };
            let done = run(std::slice::from_ref(&ring), &Options { pairs: &[pair], strip, ..Options::default() });
            assert_closed(&done, 0);
            assert_eq!(done.joints[0].outcome, Outcome::Joined);
        }
    }
}

#[test]
fn exclusions_and_pairs_are_minded() {
    let (pieces, ..) = with_gaps().swap_remove(1);
    // Each vertex of piece 0 on the side of piece 1.
    let near = |p: &[f64; 3]| (around(*p) - 0.25).abs() < 1e-9;
    let vertex = pieces[0].points.iter().position(near).unwrap() as u32;
    let there = pieces[1].points.iter().position(|p| (around(*p) - 0.3125).abs() < 1e-9).unwrap() as u32;
    let one = [Selector { piece: 0, vertex }, Selector { piece: 1, vertex: there }];
    for excluded in [one, [Selector::piece(1), Selector::piece(0)], [one[1], Selector::piece(0)]] {
        let done = run(&pieces, &Options { excluded: &[excluded], ..Options::default() });
        assert_eq!((done.joints.len(), done.loops_left, euler(faces_of(&done.mesh))), (2, 2, 0));
        let reasons: Vec<_> = done.left.iter().map(|left| left.reason).collect();
        assert_eq!(reasons, [Reason::Excluded; 2]);
        assert!(done.left[0].vertices.contains(&done.maps[0].vertices[vertex as usize]));
    }
    // A pair that was given comes first, and is joined when no other is.
    let none = Options { max_gap: MaxGap::Given(0.0), ..Options::default() };
    assert_eq!((run(&pieces, &none).joints.len(), run(&pieces, &none).loops_left), (0, 6));
    let done = run(&pieces, &Options { pairs: &[one], ..none });
    assert_eq!((done.joints.len(), done.loops_left), (1, 4));
    assert!(done.joints[0].sides[0].contains(&done.maps[0].vertices[vertex as usize]));
    let done = run(&pieces, &Options { pairs: &[one], ..Options::default() });
    assert_closed(&done, 0);
    assert!(done.joints[0].sides[0].contains(&done.maps[0].vertices[vertex as usize]));
    // The gap is a sixteenth of the torus, 0.39 along the inner and 1.17 along the outer equator.
    let measured = done.joints[0].gap;
    assert!(measured > 0.6 && measured < 0.9, "{measured}");
    for (factor, joined) in [(0.99, false), (1.01, true)] {
        let max_gap = MaxGap::Given(measured * factor);
        let done = run(&pieces, &Options { max_gap, extent: Extent::WholeLoops, ..Options::default() });
        assert_eq!(done.joints.len(), if joined { 3 } else { 0 }, "{factor}");
    }

    let wrong = |vertex| [Selector { piece: 0, vertex }, one[1]];
    for pair in [wrong(NONE), wrong(u32::MAX - 1), [one[0], one[0]]] {
        let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
        let refused = assemble(&views, &Options { pairs: &[pair], ..Options::default() }, &Job::default());
        assert!(matches!(refused, Err(Error::BadLoopPair { option: "pairs", pair: 0, .. })));
    }
}

#[test]
fn pieces_that_face_nothing_are_left() {
    let far = |x: f64| {
        let mut soup = sheet(4, 4);
        soup.points.iter_mut().for_each(|p| p[0] += x);
        soup
    };
    let done = run(&[sheet(4, 4)], &welding());
    assert_eq!((done.loops_left, done.left.len(), done.left[0].reason), (1, 1, Reason::Alone));
    let done = run(&[far(0.0), far(1000.0), far(-1000.0)], &welding());
    assert!(done.joints.is_empty());
    assert_eq!(done.left.iter().map(|left| left.reason).collect::<Vec<_>>(), [Reason::TooFar; 3]);
    assert!(done.left.iter().all(|left| left.gap > 990.0 && left.allowed_gap < 5.0) && done.near_loops_left == 0);
    // A closed piece has nothing to be joined.
    let done = run(&[cube(3), far(0.5)], &Options::default());
    assert_eq!((done.joints.len(), done.left.len(), done.loops_left), (0, 1, 1));
    assert_eq!(assemble(&[], &Options::default(), &Job::default()).unwrap_err(), Error::EmptyMesh { what: "pieces" });
    // A tube's own ends face each other within one component only if that is wanted.
    let ring = cut(&torus(16, 12), |p| (around(p) < 0.95).then_some(0));
    let within = |within_components| run(&ring, &Options { within_components, ..Options::default() });
    assert_eq!((within(false).loops_left, within(false).left.len()), (2, 2));
    assert_closed(&within(true), 0);
}

#[test]
fn the_same_piece_twice_and_thrice() {
    let piece = sheet(3, 2);
    // Two sheets that lie on one another are sewn all round, as a pillow; of three none is
    // preferred.
    let done = run(&[piece.clone(), piece.clone()], &welding());
    assert_eq!((done.loops_left, done.non_manifold_edges, done.sewn_edges), (0, 0, 10));
    assert_closed(&done, 2);
    // It encloses no volume, and the report says so.
    assert_eq!(done.zero_volume.len(), 1);
    let [lower, upper] = [-1.0, 1.0].map(|side| crate::common::cap(12, 3, 0.2, side));
    let notes = crate::answers::Notes::default();
    let done = run_with(&[lower.clone(), lower, upper], &welding(), &Job::new(1, &notes));
    assert_eq!(done.zero_volume.len(), 1);
    assert!(notes.0.borrow().iter().any(|note| note.contains("without volume")));
    let done =
        run(&[piece.clone(), piece.clone(), piece.clone()], &Options { max_gap: MaxGap::Given(0.0), ..welding() });
    assert_eq!((done.loops_left, done.sewn_edges, done.welded_vertices), (3, 0, 0));
    // Joined without a gap: the mesh is still manifold.
    let done = run(&[piece.clone(), piece.clone(), piece], &Options::default());
    let found = check(&done.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.manifold && found.oriented);
}

#[test]
fn a_piece_that_is_no_manifold_stays_as_it_is() {
    // Three sheets on one edge: no loop of theirs is simple, and nothing is hung on it.
    let book = Soup::new(
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.5, -1.0, 0.3], [0.5, 0.2, 1.0]],
        &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]],
    );
    let mut near = sheet(3, 2);
    near.points.iter_mut().for_each(|p| *p = [p[0] * 0.3, p[1] * 0.5, -0.2]);
    for options in [welding(), Options { fill: Some(fill::Options::default()), ..welding() }] {
        let done = run(&[book.clone(), near.clone()], &options);
        assert_eq!(done.non_manifold_edges, 1);
        assert!(done.left.iter().any(|left| left.reason == Reason::NotSimple));
    }
}

#[test]
fn the_order_of_vertices_and_the_threads_do_not_matter() {
    let rows = stitch::Options { rows: Rows::Count(1), fairing: Fairing::ThinPlate, ..stitch::Options::default() };
    let mut all: Vec<Vec<Soup>> = with_gaps().into_iter().map(|(pieces, ..)| pieces).collect();
    all.push(shrunk(cut(&sphere(24, 15), |p| Some((0..3).map(|k| usize::from(p[k] > 0.0) << k).sum())), 0.04));
    for pieces in all {
        let options = Options { strip: rows, ..filling() };
        let expected = run(&pieces, &options);
        for threads in [1, 2, 7] {
            assert_eq!(run_with(&pieces, &options, &Job::new(threads, &Steady::default())), expected, "{threads}");
        }
        // Vertices numbered backwards: strips join the same points.
        let backwards = |soup: &Soup| {
            let last = soup.points.len() as u32 - 1;
            let mut other =
                Soup { points: soup.points.iter().rev().copied().collect(), offsets: vec![0], ..Soup::default() };
            soup.faces().for_each(|face| other.face(&face.iter().map(|v| last - v).collect::<Vec<_>>()));
            other
        };
        let other = run(&pieces.iter().map(backwards).collect::<Vec<_>>(), &options);
        assert_eq!(other.joints.len(), expected.joints.len());
        let gaps = |done: &Assembly| done.joints.iter().map(|joint| joint.gap).collect::<Vec<_>>();
        assert!(gaps(&other).iter().zip(gaps(&expected)).all(|(x, y)| (x - y).abs() < 1e-12));
        assert_eq!((other.mesh.face_count(), other.loops_left), (expected.mesh.face_count(), expected.loops_left));
        assert!((volume_of(&other) - volume_of(&expected)).abs() < 1e-3 * volume_of(&expected).abs());
    }
}
