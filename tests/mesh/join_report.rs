//! The report of an assembly: cuts of strips and patches, left loops by piece and vertex, borders after trimming.

use crate::common::{Soup, cap, edge_counts, faces_of, sheet};
use gusset::Job;
use gusset::assemble::{Assembly, Options, Outcome, Overlaps, assemble};
use gusset::fill;
use gusset::mesh::{MeshView, NONE};
use gusset::trim;
use std::f64::consts::TAU;

fn run(pieces: &[Soup], options: &Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

/// A closed box.
fn block(low: [f64; 3], high: [f64; 3]) -> Soup {
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { low[axis] } else { high[axis] });
    let faces: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut soup = Soup { points: (0..8).map(corner).collect(), offsets: vec![0], ..Soup::default() };
    faces.iter().for_each(|face| soup.face(face));
    soup
}

/// A closed ring between two radii, of this half height.
fn ring(radii: [f64; 2], height: f64) -> Soup {
    let n = 96;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for (radius, z) in [(radii[0], -height), (radii[1], -height), (radii[1], height), (radii[0], height)] {
        soup.points.extend((0..n).map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(n)).sin_cos();
            [radius * cos, radius * sin, z]
        }));
    }
    for (k, i) in (0..4).flat_map(|k| (0..n).map(move |i| (k, i))) {
        let [here, next] = [k * n, (k + 1) % 4 * n];
        soup.face(&[here + i, here + (i + 1) % n, next + (i + 1) % n, next + i]);
    }
    soup
}

/// The upper and the lower part of a unit ball, with a gap between the heights -`rim` and `rim`.
fn ball(rim: f64) -> [Soup; 2] {
    [cap(96, 20, rim, 1.0), cap(96, 20, rim, -1.0)]
}

#[test]
fn cuts_are_measured_by_their_length() {
    let [upper, lower] = ball(0.3);
    // The strip is a cylinder of radius 0.954 up to the sagitta of 96 segments. A block across it cuts a rectangle of 0.2 by 0.2.
    let across = block([0.5, -0.1, -0.1], [1.5, 0.1, 0.1]);
    let done = run(&[upper, lower, across], &Options::default());
    let [joint] = &done.joints[..] else { panic!("{} joints", done.joints.len()) };
    assert!(joint.has_cuts() && joint.outcome == Outcome::Joined);
    assert!((joint.cut_length / 0.8 - 1.0).abs() < 0.01, "{}", joint.cut_length);
    assert!(!joint.blend_avoids_cuts, "the block reaches beyond the ball");
    let free = run(&ball(0.3), &Options::default());
    assert!(!free.joints[0].has_cuts() && free.joints[0].cut_length == 0.0 && !free.joints[0].blend_avoids_cuts);
}

#[test]
fn a_blend_is_offered_where_it_cuts_nothing() {
    let [upper, lower] = ball(0.3);
    // The strip has radius 0.954 here; the blend bulges to almost 1.
    let pieces = [upper, lower, ring([0.93, 0.965], 0.01)];
    let done = run(&pieces, &Options::default());
    assert!(done.joints[0].has_cuts(), "the strip cuts");
    assert!(done.joints[0].blend_avoids_cuts, "a blend is offered");
    let mut blend = Options::default();
    blend.strip.finish = gusset::stitch::Finish::Blend;
    let done = run(&pieces, &blend);
    assert!(!done.joints[0].has_cuts() && !done.joints[0].blend_avoids_cuts, "the offer holds");
}

#[test]
fn cuts_of_patches_are_listed() {
    // A flat hole, with a block across it.
    let mut holed = sheet(9, 9);
    holed = holed.part(|face| {
        let middle = holed.middle(face);
        !((3.0..6.0).contains(&middle.x) && (3.0..6.0).contains(&middle.y))
    });
    let across = block([4.0, 4.0, -1.0], [5.0, 5.0, 1.0]);
    let fill = fill::Options { limits: fill::Limits { edges: Some(20), ..Default::default() }, ..Default::default() };
    let done = run(&[holed, across], &Options { fill: Some(fill), ..Options::default() });
    let pairs = done.hole_intersections.as_deref().unwrap();
    let filled: Vec<usize> = (0..done.holes.len()).filter(|&k| !done.holes[k].faces.is_empty()).collect();
    let [hole] = filled[..] else { panic!("{} holes are filled", filled.len()) };
    assert!(!pairs.is_empty() && pairs.iter().all(|pair| done.holes[hole].faces.contains(&pair[0])));
    assert!((done.hole_cut_lengths[hole] - 4.0).abs() < 1e-6, "{}", done.hole_cut_lengths[hole]);
}

#[test]
fn left_loops_name_a_vertex_of_a_piece() {
    let far = |by: f64| {
        let mut soup = sheet(3, 2);
        soup.points.iter_mut().for_each(|p| p[0] += by);
        soup
    };
    let pieces = [far(0.0), far(3.0), far(40.0)];
    let done = run(&pieces, &Options { weld: Some(Default::default()), ..Options::default() });
    assert_eq!(done.left.len(), 2);
    for left in &done.left {
        let [piece, vertex] = left.origin;
        assert!(piece != NONE && left.vertices.contains(&done.maps[piece as usize].vertices[vertex as usize]));
    }
}

#[test]
fn borders_of_trimmed_scans_stay_open() {
    // A dome, in two scans that overlap about its middle.
    let dome = cap(64, 24, 0.2, 1.0);
    let scan = |side: f64| dome.part(|face| side * dome.middle(face).x < 0.3);
    let mut second = scan(-1.0);
    second.points.iter_mut().for_each(|p| *p = p.map(|x| x * 1.002));
    let options = Options {
        overlaps: Overlaps::Trim(trim::Options::default()),
        weld: Some(Default::default()),
        fill: Some(fill::Options::default()),
        ..Options::default()
    };
    let done = run(&[scan(1.0), second.clone()], &options);
    assert_eq!(done.loops_left, 1, "the rim of the dome");
    assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(there, back)| there < 2 && back < 2));
    let closed = fill::Options { keep: fill::Keep::None, ..fill::Options::default() };
    let done = run(&[scan(1.0), second], &Options { fill: Some(closed), ..options });
    assert_eq!(done.loops_left, 0);
}
