//! Alignment of pieces that overlap.

use crate::common::{Silent, Soup, data, edge_counts, faces_of, some_of, torus};
use glam::{DMat3, DQuat, DVec3};
use gusset::align::{Options, Pose, Reason, Start, align};
use gusset::mesh::{MeshView, NONE};
use gusset::stitch::assemble::{self, Overlaps};
use gusset::{Job, fill, trim};

/// The views of the bunny, and the poses that were published with them.
fn bunny() -> Option<(Vec<Soup>, Vec<Pose>)> {
    let text = data::text("scans/bun.conf")?;
    let mut scans = Vec::new();
    let mut poses = Vec::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let ["bmesh", name, numbers @ ..] = &words[..] {
            let n: Vec<f64> = numbers.iter().map(|x| x.parse().unwrap()).collect();
            // The file gives the rotation of the axes.
            let rotation = DMat3::from_quat(DQuat::from_xyzw(n[3], n[4], n[5], n[6]).normalize().conjugate());
            poses.push(Pose { rotation, translation: DVec3::new(n[0], n[1], n[2]) });
            scans.push(data::range_scan(&format!("scans/{name}"))?);
        }
    }
    Some((scans, poses))
}

/// A direction by chance.
fn direction(random: &mut fastrand::Rng) -> DVec3 {
    loop {
        let v = DVec3::new(random.f64(), random.f64(), random.f64()) * 2.0 - 1.0;
        if (0.1..1.0).contains(&v.length()) {
            return v.normalize();
        }
    }
}

/// A turn about a centre and a shift.
fn motion(centre: DVec3, axis: DVec3, angle: f64, shift: DVec3) -> Pose {
    let rotation = DMat3::from_axis_angle(axis, angle);
    Pose { rotation, translation: centre + shift - rotation * centre }
}

fn middle(soup: &Soup) -> DVec3 {
    soup.points.iter().map(|&p| DVec3::from_array(p)).sum::<DVec3>() / soup.points.len() as f64
}

/// The ten views, disturbed by 3 degrees and 3 % of the size each, are back where they were published,
/// to half a degree and half a percent, and trusted.
#[test]
fn views_of_the_bunny_find_back() {
    let Some((scans, poses)) = bunny() else { return };
    let views: Vec<MeshView<'_>> = scans.iter().map(Soup::view).collect();
    // The bunny is 0.25 high, wide and deep along the diagonal.
    let size = 0.25;
    for seed in some_of(10, 0..20) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut disturbed = poses.clone();
        for (pose, scan) in disturbed.iter_mut().zip(&scans).skip(1) {
            let [axis, shift] = [(); 2].map(|()| direction(&mut random));
            let centre = pose.point(middle(scan));
            *pose = pose.then(&motion(centre, axis, 3f64.to_radians(), 0.03 * size * shift));
        }
        let options = Options { start: Start::Poses(&disturbed), ..Options::default() };
        let found = align(&views, &options, &Job::default()).unwrap();
        assert!(found.converged, "{seed}");
        for ((piece, pose), scan) in found.pieces.iter().zip(&poses).zip(&scans) {
            assert_eq!(piece.reason, Reason::Trusted, "{seed}");
            let turn = DQuat::from_mat3(&(piece.pose.rotation * pose.rotation.transpose())).to_axis_angle().1;
            assert!(turn.to_degrees() < 0.5, "{seed}: {turn}");
            let off = piece.pose.point(middle(scan)).distance(pose.point(middle(scan)));
            assert!(off < 0.005 * size, "{seed}: {off}");
        }
    }
}

/// A closed surface without symmetries, cut in two along a wavy line: the halves, whose rims have the
/// same vertices.
fn halves() -> [Soup; 2] {
    let whole = torus(64, 32);
    let bent = |p: [f64; 3]| {
        let [x, y, z] = p;
        DVec3::new(x + 0.2 * (1.3 * y).sin(), y + 0.15 * (0.9 * z + x).cos(), 1.2 * z + 0.1 * (x * y).sin())
    };
    [1.0, -1.0].map(|side: f64| {
        let mut half = Soup { offsets: vec![0], ..Soup::default() };
        let mut names = std::collections::HashMap::new();
        for face in whole.faces() {
            let middle =
                face.iter().map(|&v| DVec3::from_array(whole.points[v as usize])).sum::<DVec3>() / face.len() as f64;
            if side * (middle.x + 0.3 * (3.0 * middle.y).sin() + 0.2 * (4.0 * middle.z).cos()) <= 0.0 {
                continue;
            }
            let named: Vec<u32> = face
                .iter()
                .map(|&v| {
                    *names.entry(v).or_insert_with(|| {
                        half.points.push(bent(whole.points[v as usize]).to_array());
                        half.points.len() as u32 - 1
                    })
                })
                .collect();
            half.face(&named);
        }
        half
    })
}

/// Broken in two, one half anywhere: their rims say how they belong together.
#[test]
fn rims_that_run_alike_put_pieces_together() {
    let [one, two] = halves();
    for seed in 0..6 {
        let mut random = fastrand::Rng::with_seed(seed);
        let [axis, shift] = [(); 2].map(|()| direction(&mut random));
        let away = motion(middle(&two), axis, 3.0 * random.f64(), 5.0 * shift);
        let moved = two.points.iter().map(|&p| away.point(DVec3::from_array(p)).to_array()).collect();
        let moved = Soup { points: moved, ..two.clone() };
        let options = Options { start: Start::Rims, ..Options::default() };
        let found = align(&[one.view(), moved.view()], &options, &Job::default()).unwrap();
        let back = away.then(&found.pieces[1].pose);
        let worst = two.points.iter().map(|&p| back.point(p.into()).distance(p.into())).fold(0.0, f64::max);
        assert!(worst < 1e-3, "{seed}: {worst}");
        assert_eq!(found.pieces[1].reason, Reason::Trusted, "{seed}");
    }
}

/// Threads, and places far from the origin or in other units, change nothing that matters.
#[test]
fn the_same_bits_for_any_number_of_threads() {
    let [one, _] = halves();
    let away = motion(middle(&one), DVec3::Z, 0.02, DVec3::new(0.02, -0.01, 0.03));
    let moved = one.points.iter().map(|&p| away.point(DVec3::from_array(p)).to_array()).collect();
    let moved = Soup { points: moved, ..one.clone() };
    let views = [one.view(), moved.view()];
    let run = |threads| align(&views, &Options::default(), &Job::new(threads, &Silent)).unwrap();
    let single = run(1);
    assert!(single.pieces[1].reason == Reason::Trusted && single.converged);
    (2..5).for_each(|threads| assert_eq!(run(threads), single));
    for (unit, shift) in [(1e-120, 0.0), (1e120, 0.0), (1.0, 1e5)] {
        let place = |soup: &Soup| {
            let points = soup.points.iter().map(|&p| p.map(|x| (x + shift) * unit)).collect();
            Soup { points, ..soup.clone() }
        };
        let (a, b) = (place(&one), place(&moved));
        let found = align(&[a.view(), b.view()], &Options::default(), &Job::default()).unwrap();
        for (p, q) in a.points.iter().zip(&b.points) {
            let off = found.pieces[1].pose.point(DVec3::from_array(*q)).distance(DVec3::from_array(*p));
            assert!(off < 1e-4 * unit, "{unit} {shift}: {off}");
        }
    }
}

/// The faces that are there, moved.
fn placed(soup: &Soup, pose: &Pose) -> Soup {
    let points = soup.points.iter().map(|&p| pose.point(p.into()).to_array()).collect();
    Soup { points, ..soup.clone() }
}

/// Ten views become one closed mesh, most of whose vertices are those of a view, bit for bit.
#[test]
fn views_of_the_bunny_become_one_closed_mesh() {
    let Some((scans, poses)) = bunny() else { return };
    let views: Vec<MeshView<'_>> = scans.iter().map(Soup::view).collect();
    let options = Options { start: Start::Poses(&poses), ..Options::default() };
    let found = align(&views, &options, &Job::default()).unwrap();
    let pieces: Vec<Soup> = scans.iter().zip(&found.pieces).map(|(scan, piece)| placed(scan, &piece.pose)).collect();
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let options = assemble::Options {
        overlaps: Overlaps::Trim(trim::Options::default()),
        fill: Some(fill::Options::default()),
        ..assemble::Options::default()
    };
    let whole = assemble::assemble(&views, &options, &Job::default()).unwrap();
    assert_eq!((whole.loops_left, whole.non_manifold_edges), (0, 0));
    let counts = edge_counts(faces_of(&whole.mesh));
    assert!(counts.values().all(|&counts| counts == (1, 1)));
    let old = whole.maps.iter().flat_map(|map| &map.vertices).filter(|&&v| v != NONE).count();
    assert!(old as f64 > 0.9 * whole.mesh.positions.len() as f64);
    for (map, piece) in whole.maps.iter().zip(&pieces) {
        for (&v, p) in map.vertices.iter().zip(&piece.points).filter(|(v, _)| **v != NONE) {
            assert_eq!(whole.mesh.positions.get(v).to_array(), *p);
        }
    }
}
