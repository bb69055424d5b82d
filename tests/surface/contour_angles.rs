//! Isophotes of many angles at once: each equals the isophote of its angle alone.

use crate::common::some_of;
use crate::shapes::{Random, SHAPES, grid, rough};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::PointSpacing;
use gusset::surface::{Paths, Scheme, Sheet, Surface};
use std::f64::consts::{FRAC_PI_2, PI};

/// The points of the paths of a level, in order.
fn level_points(paths: &Paths, level: u32) -> Vec<DVec3> {
    let points = |k: usize| paths.points[paths.ends[k] as usize..paths.ends[k + 1] as usize].to_vec();
    (0..paths.len()).filter(|&k| paths.levels[k] == level).flat_map(points).collect()
}

fn check(surface: &Surface<'_>, axis: DVec3, name: &str) -> usize {
    let (job, mut count) = (Job::default(), 0);
    for unsigned in [false, true] {
        let most = if unsigned { FRAC_PI_2 } else { PI };
        let angles: Vec<f64> = (0..150).map(|k| most * (f64::from(k) + 0.5) / 150.0).chain([most]).collect();
        let together = surface.isophotes(axis, &angles, unsigned, PointSpacing::CellEdges, &job).unwrap();
        for (level, &angle) in (0..).zip(&angles).step_by(6) {
            let alone = surface.isophotes(axis, &[angle], unsigned, PointSpacing::CellEdges, &job).unwrap();
            let found = level_points(&together, level);
            assert_eq!(found, level_points(&alone, 0), "{name}, {angle} {unsigned}");
            count += found.len();
        }
    }
    count
}

#[test]
fn each_angle_is_as_it_is_alone() {
    let mut random = Random(5);
    for shape in some_of(2, SHAPES.iter()) {
        let surface = Surface::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap();
        assert!(check(&surface, random.point(1.0), shape.name) > 100);
    }
    for scheme in [Scheme::SixTap, Scheme::FourPoint] {
        let sheet = Sheet::Grid(rough([14, 11], [false, false], scheme, 3));
        let surface = Surface::new(vec![sheet], None, &Job::default()).unwrap();
        assert!(check(&surface, DVec3::new(0.2, -0.3, 1.0), "rough") > 100);
    }
}
