//! Alignment of pieces that overlap.

use crate::common::{Soup, data};
use glam::{DMat3, DQuat, DVec3};
use gusset::Job;
use gusset::align::{Options, Pose, Reason, Start, align};
use gusset::mesh::MeshView;

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

#[test]
fn experiment() {
    let Some((scans, poses)) = bunny() else { return };
    let views: Vec<MeshView<'_>> = scans.iter().map(Soup::view).collect();
    for seed in 0..20 {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut unit = || loop {
            let v = DVec3::new(random.f64(), random.f64(), random.f64()) * 2.0 - 1.0;
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        };
        let disturbed: Vec<Pose> = scans
            .iter()
            .zip(&poses)
            .enumerate()
            .map(|(k, (scan, pose))| {
                if k == 0 || seed == 0 {
                    return *pose;
                }
                let centre =
                    scan.points.iter().map(|&p| pose.point(DVec3::from(p))).sum::<DVec3>() / scan.points.len() as f64;
                let rotation = DMat3::from_axis_angle(unit(), 3f64.to_radians());
                let shift = unit() * 0.03 * 0.25;
                let turned = Pose { rotation, translation: centre + shift - rotation * centre };
                pose.then(&turned)
            })
            .collect();
        let start = std::time::Instant::now();
        let options = Options { start: Start::Poses(&disturbed), ..Options::default() };
        let found = align(&views, &options, &Job::default()).unwrap();
        let time = start.elapsed();
        let still = Options { max_rounds: 1, start: Start::Poses(&poses), ..Options::default() };
        let _ = still;
        let (mut angle, mut shift) = (0.0f64, 0.0f64);
        for ((own, pose), scan) in found.pieces.iter().zip(&poses).zip(&scans) {
            let turn = own.pose.rotation * pose.rotation.transpose();
            angle = angle.max(DQuat::from_mat3(&turn).to_axis_angle().1.to_degrees());
            let centre = scan.points.iter().map(|&p| DVec3::from(p)).sum::<DVec3>() / scan.points.len() as f64;
            shift = shift.max(own.pose.point(centre).distance(pose.point(centre)) / 0.25 * 100.0);
        }
        let trusted = found.pieces.iter().filter(|piece| piece.reason == Reason::Trusted).count();
        let counts: f64 = found.overlaps.iter().map(|o| f64::from(o.count)).sum();
        let mean = found.overlaps.iter().map(|o| f64::from(o.count) * o.mean).sum::<f64>() / counts;
        println!(
            "{seed}: {:?} rounds {} {} angle {angle:.3} shift {shift:.3} % trusted {trusted} mean {:.3} um",
            time,
            found.rounds,
            found.converged,
            mean * 1e6
        );
        if seed == 0 {
            for overlap in &found.overlaps {
                println!("{overlap:?}");
            }
            for piece in &found.pieces {
                println!("{piece:?}");
            }
        }
    }
}

/// The faces that are kept, with the vertices that they use.
fn part(soup: &Soup, pose: &Pose, kept: &[u32]) -> Soup {
    let faces: Vec<&[u32]> = soup.faces().collect();
    let mut names = std::collections::HashMap::new();
    let mut out = Soup { offsets: vec![0], ..Soup::default() };
    for &f in kept {
        let face: Vec<u32> = faces[f as usize]
            .iter()
            .map(|&v| {
                *names.entry(v).or_insert_with(|| {
                    out.points.push(pose.point(DVec3::from(soup.points[v as usize])).to_array());
                    out.points.len() as u32 - 1
                })
            })
            .collect();
        out.face(&face);
    }
    out
}

fn write_off(name: &str, points: impl Iterator<Item = DVec3>, faces: impl Iterator<Item = Vec<u32>>) {
    use std::fmt::Write;
    let points: Vec<_> = points.collect();
    let faces: Vec<_> = faces.collect();
    let mut text = format!("OFF\n{} {} 0\n", points.len(), faces.len());
    points.iter().for_each(|p| writeln!(text, "{} {} {}", p.x, p.y, p.z).unwrap());
    faces.iter().for_each(|f| {
        write!(text, "{}", f.len()).unwrap();
        f.iter().for_each(|v| write!(text, " {v}").unwrap());
        text.push('\n');
    });
    std::fs::write(name, text).unwrap();
}

#[test]
fn trimmed() {
    use gusset::stitch::assemble::{self, MaxGap};
    let Some((scans, poses)) = bunny() else { return };
    let views: Vec<MeshView<'_>> = scans.iter().map(Soup::view).collect();
    let options = Options { start: Start::Poses(&poses), ..Options::default() };
    let found = align(&views, &options, &Job::default()).unwrap();
    let placed: Vec<Soup> = scans
        .iter()
        .zip(&found.pieces)
        .map(|(scan, piece)| part(scan, &piece.pose, &(0..scan.faces().count() as u32).collect::<Vec<_>>()))
        .collect();
    let views: Vec<MeshView<'_>> = placed.iter().map(Soup::view).collect();
    let start = std::time::Instant::now();
    let trimmed = gusset::trim::trim(&views, &gusset::trim::Options::default(), &Job::default()).unwrap();
    println!("trim {:?} crossings {}", start.elapsed(), trimmed.crossings);
    for (k, kept) in trimmed.kept.iter().enumerate() {
        println!(
            "{k}: {} of {} faces, {} covered of {}",
            kept.len(),
            placed[k].faces().count(),
            trimmed.covered[k],
            placed[k].points.len()
        );
    }
    let pieces: Vec<Soup> =
        placed.iter().zip(&trimmed.kept).map(|(soup, kept)| part(soup, &Pose::IDENTITY, kept)).collect();
    let pieces: Vec<Soup> = pieces.into_iter().filter(|piece| !piece.points.is_empty()).collect();
    let all = pieces.iter().skip(1).fold(pieces[0].clone(), |all, piece| all.and(piece));
    write_off("/tmp/trimmed.off", all.points.iter().map(|&p| p.into()), all.faces().map(<[u32]>::to_vec));
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let start = std::time::Instant::now();
    let views: Vec<MeshView<'_>> = placed.iter().map(Soup::view).collect();
    let options = assemble::Options {
        overlaps: assemble::Overlaps::Trim(gusset::trim::Options::default()),
        within_components: std::env::var_os("WITHIN").is_some(),
        max_gap: std::env::var("GAP").map_or(MaxGap::Auto, |gap| MaxGap::Given(gap.parse().unwrap())),
        keep_orientation: true,
        fill: std::env::var_os("FILL").map(|_| gusset::fill::Options::default()),
        ..Default::default()
    };
    let whole = assemble::assemble(&views, &options, &Job::default()).unwrap();
    println!(
        "assemble {:?}: loops {} near {} non-manifold {}",
        start.elapsed(),
        whole.loops_left,
        whole.near_loops_left,
        whole.non_manifold_edges
    );
    println!(
        "joints {} {:?}",
        whole.joints.len(),
        whole
            .joints
            .iter()
            .map(|j| (j.outcome, j.whole, j.sides[0].len(), j.sides[1].len(), j.intersections.as_ref().map(Vec::len)))
            .collect::<Vec<_>>()
    );
    for left in whole.left.iter().filter(|l| l.vertices.len() > 20) {
        println!("left {} {:?} gap {} {}", left.vertices.len(), left.reason, left.gap, left.allowed_gap);
    }
    let mesh = &whole.mesh;
    println!(
        "holes {:?}",
        whole.holes.iter().filter(|h| h.rim.len() > 12).map(|h| (h.rim.len(), h.status, h.finish)).collect::<Vec<_>>()
    );
    write_off(
        "/tmp/joined.off",
        (0..mesh.positions.len() as u32).map(|v| mesh.positions.get(v)),
        mesh.faces().map(<[u32]>::to_vec),
    );
}
