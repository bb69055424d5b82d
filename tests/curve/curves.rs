//! Shared by the tests of curves.

#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]

use glam::DVec3;
use gusset::Job;
use gusset::curve::{CurveView, Place};
use proptest::prelude::*;

pub fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

pub fn at(segment: u32, t: f64) -> Place {
    Place { segment, t }
}

/// Owned points and ends.
#[derive(Debug, Clone)]
pub struct Given {
    pub points: Vec<DVec3>,
    pub ends: Vec<u32>,
    pub closed: bool,
}

impl Given {
    pub fn view(&self) -> CurveView<'_> {
        CurveView::new(&self.points, &self.ends, self.closed).unwrap()
    }

    pub fn one(points: &[DVec3]) -> Self {
        Given { points: points.to_vec(), ends: vec![0, points.len() as u32 - 1], closed: false }
    }

    /// The point counted over all segments: the whole number is the segment.
    pub fn point(&self, at: f64) -> DVec3 {
        let k = (at.floor() as usize).min(self.ends.len() - 2);
        self.view().point(Place { segment: k as u32, t: at - k as f64 }).unwrap()
    }
}

/// Curves of up to 5 segments of degrees 1 to 6; some degenerate, some of extreme size.
pub fn curves(flat: bool) -> impl Strategy<Value = Given> {
    let degrees = proptest::collection::vec(1usize..7, 1..6);
    let scale = prop_oneof![4 => Just(1.0), 1 => Just(1e200), 1 => Just(1e-200), 1 => Just(1e6)];
    (degrees, any::<bool>(), scale, 0..6u32).prop_flat_map(move |(degrees, closed, scale, kind)| {
        let count = degrees.iter().sum::<usize>() + 1;
        let point = (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64);
        proptest::collection::vec(point, count).prop_map(move |raw| {
            let mut points: Vec<DVec3> =
                raw.iter().map(|&(x, y, z)| v(x, y, if flat { 0.0 } else { z }) * scale).collect();
            match kind {
                0 => points.fill(v(0.25, 0.5, 0.0) * scale),
                1 => points.iter_mut().for_each(|p| *p = v(p.x, 0.5 * p.x, 0.0)),
                2 => points[count / 2] = points[0],
                _ => {}
            }
            if closed {
                points[count - 1] = points[0];
            }
            let ends = degrees.iter().scan(0, |sum, &n| {
                *sum += n as u32;
                Some(*sum)
            });
            Given { points, ends: std::iter::once(0).chain(ends).collect(), closed }
        })
    })
}

pub fn size(given: &Given) -> f64 {
    given.points.iter().fold(0.0, |m, p| p.abs().max_element().max(m))
}

/// y = x^2 from x = a to b: exactly a quadratic.
pub fn parabola(a: f64, b: f64) -> Given {
    Given::one(&[v(a, a * a, 0.0), v((a + b) / 2.0, a * b, 0.0), v(b, b * b, 0.0)])
}

/// The length of y = x^2 from 0 to x.
pub fn parabola_length(x: f64) -> f64 {
    0.5 * x * (1.0 + 4.0 * x * x).sqrt() + 0.25 * (2.0 * x).asinh()
}

/// A circle of n cubics, each within about 2.7e-4 (4 of them) of it.
pub fn circle(radius: f64, n: u32) -> Given {
    let k = 4.0 / 3.0 * (std::f64::consts::FRAC_PI_2 / f64::from(n)).tan();
    let mut points = vec![];
    for i in 0..n {
        let angle = |i: u32| std::f64::consts::TAU * f64::from(i % n) / f64::from(n);
        let at = |a: f64| v(a.cos(), a.sin(), 0.0) * radius;
        let tangent = |a: f64| v(-a.sin(), a.cos(), 0.0) * radius * k;
        points.extend([at(angle(i)), at(angle(i)) + tangent(angle(i)), at(angle(i + 1)) - tangent(angle(i + 1))]);
    }
    points.push(points[0]);
    Given { points, ends: (0..=n).map(|i| 3 * i).collect(), closed: true }
}

/// The greatest distance between two curves of as many segments at the same parameters.
pub fn apart(a: &CurveView<'_>, b: &CurveView<'_>) -> f64 {
    assert_eq!(a.len(), b.len());
    let places: Vec<Place> =
        (0..a.len() as u32).flat_map(|k| (0..=10).map(move |i| at(k, f64::from(i) / 10.0))).collect();
    let (a, b) = (a.points_at(&places, &Job::default()).unwrap(), b.points_at(&places, &Job::default()).unwrap());
    a.iter().zip(b).fold(0.0, |m, (p, q)| (*p - q).abs().max_element().max(m))
}
