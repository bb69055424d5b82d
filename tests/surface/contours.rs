//! Shared by the tests of sections and contours.

#![allow(dead_code, unreachable_pub, reason = "shared by several tests")]

use crate::shapes::{Shape, grid};
use gusset::Job;
use gusset::surface::{Paths, Sheet, Surface};

/// A surface of one sheet.
pub fn surface(shape: &Shape) -> Surface<'static> {
    Surface::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap()
}

/// The length of a path.
pub fn length(paths: &Paths, k: usize) -> f64 {
    let points = paths.points_of(k);
    let around = if paths.closed[k] { points.len() } else { points.len() - 1 };
    (0..around).map(|i| points[i].distance(points[(i + 1) % points.len()])).sum()
}

/// Checks all curves: offsets, flags, points at their places, normals.
pub fn check(surface: &Surface<'_>, paths: &Paths, name: &str) {
    assert_eq!(paths.ends.len(), paths.len() + 1, "{name}");
    assert_eq!((paths.levels.len(), paths.normals.len()), (paths.len(), paths.points.len()), "{name}");
    assert_eq!((paths.ends[0], paths.ends[paths.len()] as usize), (0, paths.points.len()), "{name}");
    assert!(paths.levels.is_sorted(), "{name}");
    for k in 0..paths.len() {
        assert!(paths.points_of(k).len() >= if paths.closed[k] { 3 } else { 2 }, "{name}");
        let points = paths.points_of(k);
        assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "{name}: repeated points");
    }
    for ((&place, &point), &normal) in paths.places.iter().zip(&paths.points).zip(&paths.normals) {
        assert!((0.0..=1.0).contains(&place.u) && (0.0..=1.0).contains(&place.v), "{name}: {place:?}");
        assert!(surface.jet(place).point.distance(point) < 1e-13, "{name}: {place:?}");
        assert!(surface.normal(place).distance(normal) < 1e-9, "{name}: {place:?}");
    }
}
