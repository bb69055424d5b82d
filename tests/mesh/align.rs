//! Alignment of pieces that overlap.

use crate::common::{Silent, Soup, data, edge_counts, faces_of, some_of, torus};
use glam::{DMat3, DQuat, DVec3};
use gusset::align::{Options, Pose, Reason, Start, align};
use gusset::assemble::{self, Overlaps};
use gusset::mesh::{MeshView, NONE};
use gusset::{Job, fill, trim};
use std::collections::HashMap;

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

/// The mean distance of points of each view from the planes at the nearest points of other views.
/// Pairs count within 1.5 mm, off borders, and with normals on one side. The search uses cells, not
/// the library.
fn mean_residual(scans: &[Soup], poses: &[Pose]) -> f64 {
    const CELL: f64 = 0.0015;
    let cell = |p: DVec3| (p / CELL).floor().to_array().map(|x| x as i64);
    let mut views = Vec::new();
    for (scan, pose) in scans.iter().zip(poses) {
        let points: Vec<DVec3> = scan.points.iter().map(|&p| pose.transform_point(p.into())).collect();
        let mut normals = vec![DVec3::ZERO; points.len()];
        for face in scan.faces() {
            let [p, q, r] = [0, 1, 2].map(|k| points[face[k] as usize]);
            face.iter().for_each(|&v| normals[v as usize] += (q - p).cross(r - p));
        }
        let mut is_border = vec![false; points.len()];
        let edges = edge_counts(scan.faces());
        let free = edges.iter().filter(|&(_, &(f, b))| f + b == 1);
        free.for_each(|(&(u, v), _)| [u, v].into_iter().for_each(|v| is_border[v as usize] = true));
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        (0..points.len())
            .filter(|&v| normals[v] != DVec3::ZERO)
            .for_each(|v| cells.entry(cell(points[v])).or_default().push(v));
        normals.iter_mut().for_each(|n| *n = n.normalize_or_zero());
        views.push((points, normals, is_border, cells));
    }
    let (mut sum, mut count) = (0.0, 0.0);
    for (i, k) in (0..views.len()).flat_map(|i| (0..10).map(move |k| (i, k))).filter(|(i, k)| i != k) {
        let ((points, normals, is_border, _), (others, theirs, ends, cells)) = (&views[i], &views[k]);
        for v in (0..points.len()).step_by(29).filter(|&v| !is_border[v] && normals[v] != DVec3::ZERO) {
            let [x, y, z] = cell(points[v]);
            let round = (-1..2).flat_map(|a| (-1..2).flat_map(move |b| (-1..2).map(move |c| [x + a, y + b, z + c])));
            let near = round.filter_map(|at| cells.get(&at)).flatten();
            let nearest =
                near.min_by(|&&u, &&w| others[u].distance(points[v]).total_cmp(&others[w].distance(points[v])));
            let Some(&w) = nearest else { continue };
            let apart = others[w] - points[v];
            if apart.length() < CELL && !ends[w] && normals[v].dot(theirs[w]) > 0.7 {
                sum += apart.dot((normals[v] + theirs[w]).normalize()).abs();
                count += 1.0;
            }
        }
    }
    sum / count
}

/// The ten views, each disturbed by 3 degrees and 3 % of the size, return to their published poses
/// within half a degree and half a percent, and are trusted.
#[test]
fn views_of_the_bunny_find_back() {
    let Some((scans, poses)) = bunny() else { return };
    let views: Vec<MeshView<'_>> = scans.iter().map(Soup::view).collect();
    let published = mean_residual(&scans, &poses);
    // The bunny is 0.25 high, wide and deep along the diagonal.
    let size = 0.25;
    for seed in some_of(10, 0..20) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut disturbed = poses.clone();
        for (pose, scan) in disturbed.iter_mut().zip(&scans).skip(1) {
            let [axis, shift] = [(); 2].map(|()| direction(&mut random));
            let centre = pose.transform_point(middle(scan));
            *pose = pose.followed_by(&motion(centre, axis, 3f64.to_radians(), 0.03 * size * shift));
        }
        let options = Options { start: Start::Poses(&disturbed), ..Options::default() };
        let found = align(&views, &options, &Job::default()).unwrap();
        assert!(found.converged, "{seed}");
        let own: Vec<Pose> = found.pieces.iter().map(|piece| piece.pose).collect();
        let residual = mean_residual(&scans, &own);
        println!("{seed}: mean residual {residual:.3e}, at the published poses {published:.3e}");
        assert!(residual <= published, "{seed}: {residual} {published}");
        for ((piece, pose), scan) in found.pieces.iter().zip(&poses).zip(&scans) {
            assert_eq!(piece.reason, Reason::Trusted, "{seed}");
            let turn = DQuat::from_mat3(&(piece.pose.rotation * pose.rotation.transpose())).to_axis_angle().1;
            assert!(turn.to_degrees() < 0.5, "{seed}: {turn}");
            let off = piece.pose.transform_point(middle(scan)).distance(pose.transform_point(middle(scan)));
            assert!(off < 0.005 * size, "{seed}: {off}");
        }
    }
}

/// A closed surface without symmetries, cut in two along a wavy line: the halves, whose rims have the
/// same vertices.
fn halves() -> [Soup; 2] {
    let mut whole = torus(64, 32);
    let flat = whole.clone();
    for p in &mut whole.points {
        let [x, y, z] = *p;
        *p = [x + 0.2 * (1.3 * y).sin(), y + 0.15 * (0.9 * z + x).cos(), 1.2 * z + 0.1 * (x * y).sin()];
    }
    [1.0, -1.0].map(|side: f64| {
        whole.part(|face| {
            let middle = flat.middle(face);
            side * (middle.x + 0.3 * (3.0 * middle.y).sin() + 0.2 * (4.0 * middle.z).cos()) > 0.0
        })
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
        let moved = two.points.iter().map(|&p| away.transform_point(DVec3::from_array(p)).to_array()).collect();
        let moved = Soup { points: moved, ..two.clone() };
        let options = Options { start: Start::Rims, ..Options::default() };
        let found = align(&[one.view(), moved.view()], &options, &Job::default()).unwrap();
        let back = away.followed_by(&found.pieces[1].pose);
        let worst = two.points.iter().map(|&p| back.transform_point(p.into()).distance(p.into())).fold(0.0, f64::max);
        assert!(worst < 1e-3, "{seed}: {worst}");
        assert_eq!(found.pieces[1].reason, Reason::Trusted, "{seed}");
    }
}

/// Threads, and places far from the origin or in other units, change nothing that matters.
#[test]
fn the_same_bits_for_any_number_of_threads() {
    let [one, _] = halves();
    let away = motion(middle(&one), DVec3::Z, 0.02, DVec3::new(0.02, -0.01, 0.03));
    let moved = one.points.iter().map(|&p| away.transform_point(DVec3::from_array(p)).to_array()).collect();
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
            let off = found.pieces[1].pose.transform_point(DVec3::from_array(*q)).distance(DVec3::from_array(*p));
            assert!(off < 1e-4 * unit, "{unit} {shift}: {off}");
        }
    }
}

/// The faces that are there, moved.
fn placed(soup: &Soup, pose: &Pose) -> Soup {
    let points = soup.points.iter().map(|&p| pose.transform_point(p.into()).to_array()).collect();
    Soup { points, ..soup.clone() }
}

/// Ten views become a closed mesh, and most of its vertices equal a vertex of a view bit for bit.
#[test]
fn views_of_the_bunny_become_a_closed_mesh() {
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
    // One view has a flake that floats off the surface, which no other view covers.
    let outline: Vec<u32> =
        whole.left.iter().filter(|left| !left.filled).flat_map(|left| left.vertices.clone()).collect();
    assert!(outline.len() < 20, "{}", outline.len());
    assert_eq!((whole.loops_left, whole.non_manifold_edges), (1, 0));
    let open = edge_counts(faces_of(&whole.mesh)).into_iter().filter(|&(_, counts)| counts != (1, 1));
    let open: Vec<(u32, u32)> = open.map(|(edge, _)| edge).collect();
    assert!(open.len() == outline.len() && open.iter().all(|(a, b)| outline.contains(a) && outline.contains(b)));
    let old = whole.maps.iter().flat_map(|map| &map.vertices).filter(|&&v| v != NONE).count();
    println!("{old} of {} vertices are those of views", whole.mesh.positions.len());
    assert!(old as f64 > 0.9 * whole.mesh.positions.len() as f64);
    for (map, piece) in whole.maps.iter().zip(&pieces) {
        for (&v, p) in map.vertices.iter().zip(&piece.points).filter(|(v, _)| **v != NONE) {
            assert_eq!(whole.mesh.positions.get(v).to_array(), *p);
        }
    }
}
