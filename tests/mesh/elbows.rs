//! Joints between the ends of a bent tube, beside the torus that was there: strips bend as little as
//! flat faces can, blends and rows follow the bend, and nothing intersects.

use crate::common::{Soup, faces_of};
use glam::{DMat3, DQuat, DVec3};
use gusset::Job;
use gusset::stitch::{Fairing, Finish, Options, Request, Rows, Stitch, stitch};
use gusset_oracles::cuts::{Point, cut_pairs};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Two straight tubes of radius 1 whose axes continue each other along an arc, in another place.
struct Elbow {
    pieces: [Soup; 2],
    angle: f64,
    bend_radius: f64,
    turn: DMat3,
    size: f64,
    shift: DVec3,
}

const ROWS: u32 = 6;

impl Elbow {
    fn new(degrees: f64, bend_radius: f64, segments: [u32; 2], random: &mut fastrand::Rng) -> Elbow {
        let mut any = || random.f64() - 0.5;
        let turn = DMat3::from_quat(DQuat::from_xyzw(any(), any(), any(), any()).normalize());
        let (phase, size) = (TAU * any(), (10.0 * any()).exp());
        let shift = 3.0 * size * DVec3::new(any(), any(), any());
        let angle = degrees.to_radians();
        let mut elbow = Elbow { pieces: [Soup::default(), Soup::default()], angle, bend_radius, turn, size, shift };
        for (k, count) in segments.into_iter().enumerate() {
            let (start, along) = ([0.0, angle][k], [-1.0, 1.0][k]);
            let mut soup = Soup { offsets: vec![0], ..Soup::default() };
            for (row, i) in (0..=ROWS).flat_map(|row| (0..count).map(move |i| (row, i))) {
                let t = TAU * f64::from(i) / f64::from(count) + phase * k as f64;
                let [middle, side, forward] = elbow.frame(start);
                let p = middle + t.cos() * DVec3::X + t.sin() * side + along * 0.3 * f64::from(row) * forward;
                soup.points.push((size * (turn * p) + shift).to_array());
            }
            for (row, i) in (0..ROWS).flat_map(|row| (0..count).map(move |i| (row, i))) {
                let at = |row: u32, i: u32| row * count + i % count;
                let [p, q, r, s] = [at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)];
                let faces = [[p, q, r], [p, r, s]];
                faces.iter().for_each(|&[p, q, r]| soup.face(&if k == 0 { [p, r, q] } else { [p, q, r] }));
            }
            elbow.pieces[k] = soup;
        }
        elbow
    }

    /// A point of the axis, the direction away from the bend's centre, and the axis's direction.
    fn frame(&self, t: f64) -> [DVec3; 3] {
        let side = DVec3::new(0.0, t.cos(), -t.sin());
        let centre = DVec3::new(0.0, -self.bend_radius, 0.0);
        [centre + self.bend_radius * side, side, DVec3::new(0.0, -t.sin(), -t.cos())]
    }

    /// The distance of a point from the axis, in radii of the tube.
    fn distance_from_axis(&self, p: DVec3) -> f64 {
        let p = self.turn.transpose() * ((p - self.shift) / self.size) + self.bend_radius * DVec3::Y;
        let t = (-p.z).atan2(p.y).clamp(0.0, self.angle);
        p.distance(self.bend_radius * DVec3::new(0.0, t.cos(), -t.sin()))
    }

    /// The intersecting faces, one of them new, by brute force in whole numbers.
    fn cuts(&self, joined: &Stitch) -> Vec<[u32; 2]> {
        let at = |v: u32| -> Point {
            let p = (joined.mesh.positions.get(v) - self.shift) / self.size;
            p.to_array().map(|x| (x * 1e4).round() as i64)
        };
        let triangles: Vec<_> = faces_of(&joined.mesh).map(|face| [at(face[0]), at(face[1]), at(face[2])]).collect();
        cut_pairs(&triangles, joined.strip_faces.clone())
    }

    fn join(&self, options: &Options) -> Stitch {
        let [a, b] = [0, 1].map(|k| self.pieces[k].view());
        let rims = [0, 1].map(|k| (0..(self.pieces[k].points.len() as u32) / (ROWS + 1)).collect::<Vec<_>>());
        let request = Request { a: &a, loop_a: Some(&rims[0]), b: Some(&b), loop_b: Some(&rims[1]) };
        stitch(&request, options, &Job::default()).unwrap()
    }
}

/// The largest angle between neighbouring faces, one of them new, in degrees.
fn sharpest_bend(joined: &Stitch) -> f64 {
    let normal = |face: &[u32]| {
        let [p, q, r] = [0, 1, 2].map(|k| joined.mesh.positions.get(face[k]));
        (q - p).cross(r - p).normalize()
    };
    let mut sides = HashMap::new();
    let mut most: f64 = 0.0;
    for (f, face) in faces_of(&joined.mesh).enumerate() {
        for (k, &u) in face.iter().enumerate() {
            let v = face[(k + 1) % face.len()];
            let before = sides.insert((u.min(v), u.max(v)), normal(face));
            if let Some(other) = before.filter(|_| f as u32 >= joined.strip_faces.start) {
                most = most.max(normal(face).angle_between(other).to_degrees());
            }
        }
    }
    most
}

fn check(degrees: f64, bend_radius: f64, segments: [u32; 2], random: &mut fastrand::Rng) {
    let elbow = Elbow::new(degrees, bend_radius, segments, random);
    let name = format!("{degrees} {bend_radius:.2} {segments:?}");
    let blend = Options { finish: Finish::Blend, ..Options::default() };
    let rows = Options { rows: Rows::MeanEdge, fairing: Fairing::ThinPlate, ..Options::default() };
    // Neighbouring facets of the tubes meet at this angle.
    let facet = 360.0 / f64::from(segments[0].min(segments[1]));
    for (kind, options) in [("strip", Options::default()), ("blend", blend), ("rows", rows)] {
        let joined = elbow.join(&options);
        assert_eq!(joined.intersections.as_deref(), Some(&[][..]), "{kind} {name}");
        assert_eq!(elbow.cuts(&joined), [[0; 2]; 0], "{kind} {name}");
        assert_eq!(joined.finish, options.finish, "{kind} {name}");
        // Straight meridians turn by half the angle at either rim.
        let bend = sharpest_bend(&joined);
        assert!(bend < degrees / 2.0 + facet, "{kind} {name}: {bend}");
        if kind == "blend" {
            let (neck, off) = if degrees <= 90.0 { (0.92, 0.08) } else { (0.85, 0.15) };
            for face in faces_of(&joined.mesh).skip(joined.strip_faces.start as usize) {
                let at = |k: usize| joined.mesh.positions.get(face[k % 3]);
                for k in 0..3 {
                    let radius = elbow.distance_from_axis(at(k).midpoint(at(k + 1)));
                    assert!(radius > neck && radius < 1.0 + off, "{name}: {radius}");
                }
            }
        }
    }
}

#[test]
fn bent_tubes_are_joined_by_bent_tubes() {
    let mut random = fastrand::Rng::with_seed(57);
    for degrees in [60.0, 75.0, 90.0, 120.0] {
        check(degrees, 2.5, [48, 40], &mut random);
        for _ in 0..if crate::common::is_exhaustive() { 20 } else { 1 } {
            let segments = [0, 1].map(|_| random.u32(28..64));
            check(degrees, 1.5 + 2.5 * random.f64(), segments, &mut random);
        }
    }
}
