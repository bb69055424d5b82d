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
        println!("{seed}: {:?} rounds {} {} angle {angle:.3} shift {shift:.3} % trusted {trusted} mean {:.3} um", time, found.rounds, found.converged, mean * 1e6);
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
