//! Shared by the tests of plane outlines.

#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]

use glam::DVec3;
use gusset::curve::Method;

pub const METHODS: [Method; 5] =
    [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian, Method::Alpha(0.3)];

/// The plane outlines of the data folder, contour by contour: name, points, and whether they are
/// closed; empty without the folder.
pub fn data() -> Vec<(String, Vec<[f64; 2]>, bool)> {
    let plane = |line: crate::outline_data::Line| {
        let points = line.points.iter().map(|p| [p.x, p.y]).collect();
        (line.name, points, line.closed)
    };
    crate::outline_data::outlines().into_iter().map(plane).collect()
}

/// De Casteljau's scheme, on its own.
pub fn casteljau(controls: &[DVec3], t: f64) -> DVec3 {
    let mut points = controls.to_vec();
    while points.len() > 1 {
        points = points.windows(2).map(|pair| pair[0].lerp(pair[1], t)).collect();
    }
    points[0]
}

pub fn lift(p: [f64; 2]) -> DVec3 {
    DVec3::new(p[0], p[1], 0.0)
}
