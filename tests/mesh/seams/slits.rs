//! Borders that coincide along a part: sewn there, joined elsewhere.

use crate::common::{Soup, cap, edge_counts, euler, faces_of};
use gusset::Job;
use gusset::assemble::{Assembly, Extent, MaxGap, Options, Outcome, Reason, Selector, assemble};
use gusset::mesh::MeshView;
use gusset::stitch::Finish;

fn run(pieces: &[Soup], options: &Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

fn sewing() -> Options<'static> {
    Options { weld: Some(gusset::repair::weld::Options::default()), ..Options::default() }
}

fn assert_closed(done: &Assembly, name: &str) {
    assert_eq!((done.loops_left, done.near_loops_left, done.left.len()), (0, 0, 0), "{name}");
    assert_eq!(done.non_manifold_edges, 0, "{name}");
    assert!(edge_counts(faces_of(&done.mesh)).values().all(|&count| count == (1, 1)), "{name}");
    assert_eq!(euler(faces_of(&done.mesh)), 2, "{name}");
    assert!(done.joints.iter().all(|joint| joint.outcome == Outcome::Joined), "{name}");
}

/// The lower and the upper half of a ball with `n` vertices on their rims; Upper vertices are
/// raised by `z`.
fn halves(n: u32, z: impl Fn(u32) -> f64) -> [Soup; 2] {
    let (lower, mut upper) = (cap(n, 6, 0.0, -1.0), cap(n, 6, 0.0, 1.0));
    // The upper rim takes over the nearest vertices of the lower one, which runs the other way.
    let rim = |soup: &Soup| soup.points.len() - n as usize..soup.points.len();
    let (from, to) = (rim(&lower), rim(&upper));
    for i in 0..n as usize {
        let [x, y, _] = lower.points[from.start + (2 * n as usize - 4 - i) % n as usize];
        upper.points[to.start + i] = [x, y, z(i as u32)];
    }
    [lower, upper]
}

#[test]
fn borders_that_coincide_in_some_edges_are_closed_between_them() {
    let n = 24;
    let patterns: [(&str, &dyn Fn(u32) -> bool); 7] = [
        ("one edge", &|i| i < 2),
        ("three edges", &|i| i < 4),
        ("half", &|i| i < 13),
        ("all but one vertex", &|i| i != 5),
        ("two runs", &|i| i < 4 || (9..12).contains(&i)),
        ("an edge and a point", &|i| i < 2 || i == 9),
        ("every third edge", &|i| i % 3 < 2),
    ];
    for (name, together) in patterns {
        for gap in [1e-3, -1e-3, 0.05] {
            for finish in [Finish::Strip, Finish::Blend] {
                let name = format!("{name} {gap} {finish:?}");
                let pieces = halves(n, |i| if together(i) { 0.0 } else { gap });
                let mut options = sewing();
                options.strip.finish = finish;
                let done = run(&pieces, &options);
                assert!(done.sewn_edges > 0 && !done.joints.is_empty(), "{name}");
                assert_closed(&done, &name);
                // Either order of the pieces, and one of them inside out.
                let [lower, upper] = &pieces;
                assert_closed(&run(&[upper.turned(), lower.clone()], &options), &name);
            }
        }
    }
}

/// As files have them: one piece rounded to three decimals, the other cut off after them.
#[test]
fn text_with_three_decimals() {
    for n in [24, 60, 91] {
        let [mut lower, mut upper] = halves(n, |_| 0.0);
        let to = |soup: &mut Soup, write: fn(f64) -> f64| {
            soup.points.iter_mut().flatten().for_each(|x| *x = write(*x * 1e3) / 1e3);
        };
        to(&mut lower, f64::round);
        to(&mut upper, f64::floor);
        for first in [false, true] {
            let pieces = if first { [lower.clone(), upper.clone()] } else { [upper.clone(), lower.clone()] };
            assert_closed(&run(&pieces, &sewing()), &format!("{n} {first}"));
        }
    }
}

#[test]
fn patches_side_by_side_are_sewn_and_not_folded_together() {
    let sheet = |from: f64| {
        let mut soup = crate::common::sheet(3, 5);
        soup.points.iter_mut().for_each(|p| p[0] += from);
        soup
    };
    let done = run(&[sheet(0.0), sheet(3.0)], &sewing());
    assert_eq!((done.sewn_edges, done.joints.len(), done.loops_left), (5, 0, 1));
    // Needles side by side.
    let needle = |tip: f64| Soup::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.5, tip, 0.0]], &[&[0, 1, 2]]);
    let done = run(&[needle(0.01), needle(-0.01)], &sewing());
    assert_eq!((done.sewn_edges, done.joints.len(), done.loops_left), (1, 0, 1));
}

/// Half a washer, or half a pipe of one row of quads: an arc of `n` quads from angle `from` on, half
/// round, between two circles.
fn half_ring(n: u32, from: f64, point: impl Fn(f64, bool) -> [f64; 3]) -> Soup {
    let angle = |i: u32| from + std::f64::consts::PI * f64::from(i) / f64::from(n);
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for outer in [false, true] {
        soup.points.extend((0..=n).map(|i| point(angle(i), outer)));
    }
    (0..n).for_each(|i| soup.face(&[i, i + 1, n + 2 + i, n + 1 + i]));
    soup
}

#[test]
fn holes_that_a_seam_crosses_stay_open() {
    let exact = |x: f64| (x * 1e6).round() / 1e6;
    let washer = |t: f64, outer: bool| {
        let r = if outer { 3.0 } else { 1.0 };
        [exact(r * t.cos()), exact(r * t.sin()), 0.0]
    };
    let pipe = |t: f64, outer: bool| [exact(t.cos()), exact(t.sin()), if outer { 5.0 } else { 0.0 }];
    for n in [6, 12, 40] {
        for (name, shape) in [("washer", &washer as &dyn Fn(f64, bool) -> [f64; 3]), ("pipe", &pipe)] {
            let halves = [half_ring(n, 0.0, shape), half_ring(n, std::f64::consts::PI, shape)];
            let done = run(&halves, &sewing());
            assert_eq!((done.sewn_edges, done.joints.len(), done.loops_left), (2, 0, 2), "{name} {n}");
        }
    }
}

/// The lower half of a ball is itself of two parts: the slit passes their seam, too.
#[test]
fn a_slit_that_another_seam_crosses() {
    let [lower, upper] = halves(24, |i| if i < 4 { 0.0 } else { 1e-3 });
    let part = |keep: &dyn Fn(f64) -> bool| {
        let mut soup = Soup { points: lower.points.clone(), offsets: vec![0], ..Soup::default() };
        for face in lower.faces() {
            let middle = face.iter().map(|&v| lower.points[v as usize][0]).sum::<f64>();
            if keep(middle) {
                soup.face(face);
            }
        }
        soup
    };
    let pieces = [part(&|x| x < 0.0), part(&|x| x >= 0.0), upper];
    let done = run(&pieces, &sewing());
    assert_eq!((done.loops_left, done.non_manifold_edges, euler(faces_of(&done.mesh))), (0, 0, 2));
}

#[test]
fn gaps_pairs_and_exclusions_are_minded() {
    let pieces = halves(24, |i| if i < 4 { 0.0 } else { 0.05 });
    let narrow = Options { max_gap: MaxGap::Given(0.01), ..sewing() };
    let done = run(&pieces, &narrow);
    assert_eq!((done.joints.len(), done.left.len(), done.left[0].reason), (0, 1, Reason::TooFar));
    let [gap, allowed] = [done.left[0].gap, done.left[0].allowed_gap];
    assert!((0.03..0.051).contains(&gap) && (allowed - 0.01).abs() < 1e-12, "{gap} {allowed}");
    let none = Options { max_gap: MaxGap::Given(0.0), ..sewing() };
    assert_eq!(run(&pieces, &none).joints.len(), 0);
    let whole = Options { extent: Extent::WholeLoops, ..sewing() };
    assert_eq!(run(&pieces, &whole).joints.len(), 0);
    let excluded = [[Selector::piece(0), Selector::piece(1)]];
    let done = run(&pieces, &Options { excluded: &excluded, ..sewing() });
    assert_eq!((done.joints.len(), done.loops_left), (0, 1));
    // The loops that a pair names may be one by now.
    let last = |k: usize| Selector { piece: k as u32, vertex: pieces[k].points.len() as u32 - 12 };
    let pair = [[last(0), last(1)]];
    assert_closed(&run(&pieces, &Options { pairs: &pair, ..narrow }), "pair");
}

/// A rim of few long sides and one of many: the long side's own ends are sewn, and between them lies
/// a side that bulges.
#[test]
fn a_side_without_vertices() {
    let square = |z: f64, fine: bool| {
        let mut rim: Vec<[f64; 3]> = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
        if fine {
            let bulge = (1..4).map(|k| [f64::from(k), 0.0, 0.05 * f64::from(k * (4 - k))]);
            rim.splice(1..1, bulge);
        }
        let n = rim.len() as u32;
        rim.push([2.0, 2.0, z]);
        let faces: Vec<[u32; 3]> =
            (0..n).map(|i| if z > 0.0 { [i, (i + 1) % n, n] } else { [(i + 1) % n, i, n] }).collect();
        Soup::new(rim, &faces.iter().map(|face| &face[..]).collect::<Vec<_>>())
    };
    for finish in [Finish::Strip, Finish::Blend] {
        let mut options = sewing();
        options.strip.finish = finish;
        let excluded = [[Selector::piece(0), Selector::piece(1)]];
        let fine_first = [square(2.0, true), square(-2.0, false)];
        let left = run(&fine_first, &Options { excluded: &excluded, ..options });
        assert_eq!((left.joints.len(), left.loops_left), (0, 1));
        let done = run(&[square(-2.0, false), square(2.0, true)], &options);
        assert_eq!(done.sewn_edges, 3);
        assert_closed(&done, "bulge");
    }
}
