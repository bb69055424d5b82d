//! Sheets of a plane whose borders face each other along a part: only that part is joined.

use crate::common::{Soup, edge_counts, euler, faces_of};
use gusset::Job;
use gusset::assemble::{Options, assemble};
use gusset::mesh::{Mesh, MeshView};

/// A grid of unit-like cells: `n` columns of width `step` from `x` on, and two rows from `y` upwards.
fn band(x: f64, step: f64, n: u32, y: f64) -> Soup {
    let points = (0..=n).flat_map(|i| (0..3).map(move |j| [x + step * f64::from(i), y + f64::from(j), 0.0])).collect();
    let mut soup = Soup::new(points, &[]);
    for a in (0..n).flat_map(|i| [3 * i, 3 * i + 1]) {
        soup.face(&[a, a + 3, a + 4, a + 1]);
    }
    soup
}

fn area(mesh: &Mesh) -> f64 {
    let at = |v: u32| mesh.positions.get(v);
    let of_face = |face: &[u32]| {
        let fan = face[1..].windows(2).map(|edge| (at(edge[0]) - at(face[0])).cross(at(edge[1]) - at(face[0])));
        fan.sum::<glam::DVec3>().length() / 2.0
    };
    faces_of(mesh).map(of_face).sum()
}

#[test]
fn the_facing_part_of_two_sheets_is_joined() {
    for seed in 0..400 {
        let mut random = fastrand::Rng::with_seed(seed);
        let (long, short) = (random.u32(8..24), random.u32(3..7));
        let (gap, step) = (0.1 + 0.35 * random.f64(), 0.6 + 0.8 * random.f64());
        let width = step * f64::from(short);
        let start = 1.0 + random.f64() * (f64::from(long) - 2.0 - width).max(0.0);
        let pieces = [band(0.0, 1.0, long, 0.0), band(start, step, short, -gap - 2.0)];
        let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
        let done = assemble(&views, &Options::default(), &Job::default()).unwrap();
        let name = format!("{seed}: {long} and {short} edges, {gap} apart, {step} long");
        assert_eq!((done.loops_left, euler(faces_of(&done.mesh))), (1, 1), "{name}");
        let edges = edge_counts(faces_of(&done.mesh));
        assert!(edges.values().all(|&(there, back)| there < 2 && back < 2) && !done.turned.contains(&true), "{name}");
        // Whole edges of both borders face each other: about the width of the shorter one.
        let strip = area(&done.mesh) - 2.0 * f64::from(long) - 2.0 * width;
        assert!(0.5 * gap * width < strip && strip < (2.0 * width + 1.0) * gap, "{name}: area {strip}");
    }
}

#[test]
fn sheets_too_far_apart_stay_as_they_are() {
    for seed in 0..100 {
        let mut random = fastrand::Rng::with_seed(seed);
        let (long, short) = (random.u32(14..24), random.u32(3..5));
        let start = 1.0 + random.f64() * f64::from(long - 2 - short);
        let gap = 1.5 + random.f64();
        let pieces = [band(0.0, 1.0, long, 0.0), band(start, 1.0, short, -gap - 2.0)];
        let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
        let done = assemble(&views, &Options::default(), &Job::default()).unwrap();
        let faces = pieces.iter().map(|piece| piece.faces().count()).sum::<usize>();
        assert_eq!((done.mesh.face_count(), done.left.len()), (faces, 2), "{seed}: {long} and {short}, {gap} apart");
        assert!(!done.turned.contains(&true), "{seed}");
    }
}
