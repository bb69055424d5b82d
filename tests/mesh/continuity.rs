//! How patches go on: their distance to the surface that was there, and the curvature on both sides
//! of their rims.

use crate::common::{Soup, cap};
use glam::DVec3;
use gusset::Job;
use gusset::fill::{
    Continuity, Fairing, Filled, Finish, HoleStatus, Keep, LoopSelection, Options, Refinement, Together, fill_holes,
};
use std::f64::consts::TAU;

fn fair(continuity: Continuity) -> Options {
    let (refinement, fairing) = (Refinement::RimDensity(0), Fairing::ThinPlate);
    Options { refinement, fairing, continuity, keep: Keep::Longest, ..Options::default() }
}

/// A surface as places over a plane, and as f = 0.
#[derive(Clone, Copy)]
struct Surface {
    name: &'static str,
    place: fn(f64, f64) -> DVec3,
    f: fn(DVec3) -> f64,
}

impl Surface {
    fn gradient(&self, p: DVec3) -> DVec3 {
        const STEP: f64 = 1e-5;
        let along = |axis: DVec3| ((self.f)(p + axis * STEP) - (self.f)(p - axis * STEP)) / (2.0 * STEP);
        DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
    }

    /// To first order.
    fn distance(&self, p: DVec3) -> f64 {
        (self.f)(p).abs() / self.gradient(p).length()
    }
}

const SURFACES: [Surface; 5] = [
    Surface {
        name: "sphere",
        place: |x, y| DVec3::new(x, y, (1.0 - x * x - y * y).sqrt()),
        f: |p| p.length_squared() - 1.0,
    },
    Surface {
        name: "ellipsoid",
        place: |x, y| DVec3::new(x, y, 0.8 * (1.0 - x * x / 1.69 - y * y / 0.81).sqrt()),
        f: |p| p.x * p.x / 1.69 + p.y * p.y / 0.81 + p.z * p.z / 0.64 - 1.0,
    },
    Surface {
        name: "torus",
        place: |x, y| {
            let (u, v) = (x / 1.7, 0.4 + y);
            let r = 1.0 + 0.6 * v.cos();
            DVec3::new(r * u.cos(), r * u.sin(), 0.6 * v.sin())
        },
        f: |p| {
            let r = p.truncate().length() - 1.0;
            r * r + p.z * p.z - 0.36
        },
    },
    Surface {
        name: "paraboloid",
        place: |x, y| DVec3::new(x, y, 0.7 * x * x + 0.3 * y * y - 0.2 * x * y),
        f: |p| 0.7 * p.x * p.x + 0.3 * p.y * p.y - 0.2 * p.x * p.y - p.z,
    },
    Surface {
        name: "waves",
        place: |x, y| DVec3::new(x, y, 0.1 * (4.0 * x).sin() * (3.0 * y).cos()),
        f: |p| 0.1 * (4.0 * p.x).sin() * (3.0 * p.y).cos() - p.z,
    },
];

/// A square of irregular triangles with a hole of this radius round its middle, and the edge's
/// length.
fn holed(surface: &Surface, cells: u32, radius: f64) -> (Soup, f64) {
    let mut random = fastrand::Rng::with_seed(5);
    let step = 1.1 / f64::from(cells);
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for j in 0..=cells {
        for i in 0..=cells {
            let mut place = |k: u32| step * (f64::from(k) - f64::from(cells) / 2.0 + 0.3 * (random.f64() - 0.5));
            soup.points.push((surface.place)(place(i), place(j)).to_array());
        }
    }
    for (i, j) in (0..cells).flat_map(|j| (0..cells).map(move |i| (i, j))) {
        let middle = |k: u32| step * (f64::from(k) + 0.5 - f64::from(cells) / 2.0);
        if middle(i).hypot(middle(j)) < radius {
            continue;
        }
        let at = |i: u32, j: u32| j * (cells + 1) + i;
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        let halves = if random.bool() { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        halves.iter().for_each(|half| soup.face(half));
    }
    (soup, step)
}

fn filled(soup: &Soup, options: &Options) -> Filled {
    fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap()
}

/// The largest and the mean distance of new vertices to the surface.
fn distances(filled: &Filled, surface: &Surface) -> (f64, f64) {
    let hole = filled.holes.iter().find(|hole| hole.finish == Finish::Faired && !hole.vertices.is_empty()).unwrap();
    let distances = hole.vertices.clone().map(|v| surface.distance(filled.mesh.positions.get(v)));
    let count = hole.vertices.len() as f64;
    (distances.clone().fold(0.0, f64::max), distances.sum::<f64>() / count)
}

/// The jump of the normal curvature across the rim, minus the jump on the surface itself at these
/// places: the mean over the rim. The curvature on a side is measured by circles in normal planes
/// at a vertex of the rim, through it and vertices up to three edges away across the rim.
fn curvature_jump(filled: &Filled, surface: &Surface, edge: f64) -> f64 {
    let hole = filled.holes.iter().find(|hole| !hole.vertices.is_empty()).unwrap();
    let rim = &filled.rims[hole.rim.clone()];
    let at = |v: u32| filled.mesh.positions.get(v);
    let truth = |v: u32| {
        let (p, gradient) = (at(v), surface.gradient(at(v)));
        p - gradient * ((surface.f)(p) / gradient.length_squared())
    };
    let centre = rim.iter().map(|&v| at(v)).sum::<DVec3>() / rim.len() as f64;
    let (mut sum, mut count) = (0.0, 0.0);
    for &v in rim {
        let p = at(v);
        let normal = surface.gradient(p).normalize();
        let inwards = (centre - p).reject_from(normal).normalize();
        let across = |leg: DVec3| {
            (1.2 * edge..3.2 * edge).contains(&leg.length()) && leg.dot(inwards).abs() > 0.85 * leg.length()
        };
        let mean = |vertices: std::ops::Range<u32>, place: &dyn Fn(u32) -> DVec3| {
            let legs: Vec<_> = vertices.filter(|&w| across(at(w) - p)).map(|w| place(w) - p).collect();
            legs.iter().map(|leg| 2.0 * leg.dot(normal) / leg.length_squared()).sum::<f64>() / legs.len() as f64
        };
        let old = mean(0..hole.vertices.start, &at);
        let [jump, own] = [&at as &dyn Fn(u32) -> DVec3, &truth].map(|place| mean(hole.vertices.clone(), place) - old);
        if jump.is_finite() {
            sum += (jump - own).abs();
            count += 1.0;
        }
    }
    assert!(count > rim.len() as f64 / 2.0);
    sum / count
}

#[test]
fn curvature_goes_on() {
    for surface in &SURFACES {
        for (cells, radius) in [(30, 0.2), (40, 0.15), (60, 0.2)] {
            let (soup, edge) = holed(surface, cells, radius);
            let [c1, c2] = [Continuity::C1, Continuity::C2].map(|continuity| {
                let made = filled(&soup, &fair(continuity));
                assert!(made.intersections.as_ref().unwrap().is_empty(), "{} {cells} {continuity:?}", surface.name);
                assert!(made.quality.min_angle > 0.3, "{} {cells} {continuity:?}", surface.name);
                (distances(&made, surface), curvature_jump(&made, surface, edge))
            });
            let what = format!("{} {cells} {radius}: {c1:?} {c2:?}", surface.name);
            assert!(c2.0.0 < c1.0.0 / 2.0 && c2.0.1 < c1.0.1 / 3.0, "{what}");
            assert!(c2.1 < c1.1 / 5.0, "{what}");
        }
    }
}

/// A cap with an opening of nearly 70 degrees to all sides.
#[test]
fn a_sphere_comes_back() {
    for (rim, bound) in [(0.9, 1e-3), (0.6, 2e-3), (0.4, 2e-2)] {
        let open = cap(48, 24, -rim, 1.0);
        let [c1, c2] = [Continuity::C1, Continuity::C2].map(|continuity| {
            let made = filled(&open, &Options { keep: Keep::None, ..fair(continuity) });
            assert_eq!(made.quality.loops_left, 0);
            made.holes[0]
                .vertices
                .clone()
                .map(|v| (made.mesh.positions.get(v).length() - 1.0).abs())
                .fold(0.0, f64::max)
        });
        assert!(c2 < bound && c2 < c1 / 3.0, "{rim}: {c1} {c2}");
    }
}

/// A ball without a belt, whose two rims get one patch.
#[test]
fn several_loops_have_one_curvature() {
    let two = cap(48, 16, 0.35, 1.0).and(&cap(48, 16, 0.35, -1.0));
    let [c1, c2] = [Continuity::C1, Continuity::C2].map(|continuity| {
        let made = filled(&two, &Options { keep: Keep::None, together: Together::One, ..fair(continuity) });
        assert_eq!((made.quality.loops_left, made.holes[0].patch, made.holes[1].patch), (0, 0, 0));
        assert!(made.intersections.unwrap().is_empty());
        let off = made.holes[0].vertices.clone().map(|v| (made.mesh.positions.get(v).length() - 1.0).abs());
        off.fold(0.0, f64::max)
    });
    assert!(c2 < 1e-3 && c2 < c1 / 10.0, "{c1} {c2}");
}

/// A spike beside the hole has a curvature that leads nowhere.
#[test]
fn patches_stay_near_their_rims() {
    for spike in [0.0, 0.5, 1.0, 2.0] {
        let mut open = cap(24, 6, 0.2, 1.0);
        let rim = open.points.len() - 24;
        for p in &mut open.points[rim - 24..rim] {
            *p = [p[0] * (1.0 + spike), p[1] * (1.0 + spike), p[2] - spike];
        }
        let made = filled(&open, &Options { keep: Keep::None, ..fair(Continuity::C2) });
        let hole = &made.holes[0];
        let points: Vec<_> = made.rims[hole.rim.clone()].iter().map(|&v| made.mesh.positions.get(v)).collect();
        let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), &p| (low.min(p), high.max(p)));
        let room = 0.5 * low.distance(high) + 1e-9;
        for v in hole.vertices.clone() {
            let p = made.mesh.positions.get(v);
            assert!(p.cmpge(low - room).all() && p.cmple(high + room).all(), "{spike}: {p}");
        }
        assert_eq!(made.intersections.as_deref(), Some(&[][..]), "{spike}");
        assert_eq!(made.quality.loops_left, 0);
    }
}

/// A patch exists even if only the faces at the rim are known, if the surface is one face wide, or
/// if the next faces belong to another hole.
#[test]
fn narrow_surroundings_are_enough() {
    let ring = |rows: u32| {
        let mut soup = Soup { offsets: vec![0], ..Soup::default() };
        for row in 0..=rows {
            for k in 0..40 {
                let angle = TAU * f64::from(k) / 40.0;
                let r = 1.0 + 0.15 * f64::from(row);
                soup.points.push([r * angle.cos(), r * angle.sin(), -0.2 * r * r]);
            }
        }
        for (row, k) in (0..rows).flat_map(|row| (0..40).map(move |k| (row, k))) {
            let (a, b) = (40 * row + k, 40 * row + (k + 1) % 40);
            soup.face(&[a, a + 40, b + 40, b]);
        }
        soup
    };
    for rows in 1..=4 {
        let made = filled(&ring(rows), &fair(Continuity::C2));
        let hole = made.holes.iter().find(|hole| hole.status == HoleStatus::Filled).unwrap();
        assert_eq!((hole.finish, hole.rim.len()), (Finish::Faired, 40), "{rows}");
        assert!(made.intersections.unwrap().is_empty(), "{rows}");
        for v in hole.vertices.clone() {
            let p = made.mesh.positions.get(v);
            let off = (p.z + 0.2 * p.truncate().length_squared()).abs();
            assert!(off < if rows < 3 { 0.1 } else { 0.01 }, "{rows}: {off}");
        }
    }
}
