//! Cells that bulge far out of the quadrilaterals of their corners: objects that meet only the top
//! of a bulge are found. Half the bound of the bulge would lose them.

use crate::pairs::meet;
use glam::DVec3;
use gusset::Job;
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};

/// A sheet of `count` x `count` nodes one apart round the origin, of the given heights.
fn sheet(count: usize, height: impl Fn(f64, f64) -> f64) -> Surface<'static> {
    let at = |k: usize| k as f64 - 0.5 * (count - 1) as f64;
    let nodes = (0..count * count).flat_map(|k| {
        let (x, y) = (at(k / count), at(k % count));
        [x, y, height(x, y)]
    });
    let nodes = Nodes::strided(nodes.collect::<Vec<_>>(), count, count, 0, 0).unwrap();
    let grid = Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap();
    Surface::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap()
}

/// Its top is the middle of a cell, half a unit above the corners.
fn hill() -> Surface<'static> {
    sheet(10, |x, y| -x * x - y * y)
}

#[test]
fn lines_through_the_top_of_a_bulge_are_hits() {
    let hill = hill();
    for k in 0..40 {
        let (sin, cos) = (0.157 * f64::from(k)).sin_cos();
        let along = DVec3::new(cos, sin, 0.0);
        let line =
            Line { origin: DVec3::new(0.0, 0.0, -0.01) - 3.0 * along, direction: along, from: 0.0, to: f64::INFINITY };
        let hits = hill.line(&line, HitSelection::All).unwrap();
        assert_eq!(hits.len(), 2, "{along}");
        for (hit, expected) in hits.iter().zip([2.9, 3.1]) {
            assert!((hit.at - expected).abs() < 1e-9, "{along}: {}", hit.at);
        }
    }
}

#[test]
fn sheets_through_the_top_of_a_bulge_meet_it() {
    let (hill, flat) = (hill(), sheet(6, |_, _| -0.01));
    for paths in [meet(&hill, &flat), meet(&flat, &hill)] {
        assert_eq!((paths.len(), &paths.closed[..]), (1, &[true][..]));
        for point in &paths.points {
            assert!((point.truncate().length() - 0.1).abs() < 1e-6 && (point.z + 0.01).abs() < 1e-6, "{point}");
        }
    }
}
