//! Sizes of surfaces, creases against normals of single places, and how soon a cancel is heard.

use crate::shapes::{SHAPES, grid};
use glam::DVec3;
use gusset::job::Progress;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Error, Job};
use std::cell::Cell;
use std::ops::ControlFlow;

/// A bump over the unit square, times a factor.
fn bump(count: usize, factor: f64) -> Sheet<'static> {
    let at = |k: usize| k as f64 / (count - 1) as f64;
    let node = |i: usize, j: usize| [at(i), at(j), at(i) * (1.0 - at(i)) * at(j)].map(|x| x * factor);
    let data: Vec<f64> = (0..count * count).flat_map(|k| node(k / count, k % count)).collect();
    let nodes = Nodes::strided(data, count, count, 0, 0).unwrap();
    Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap())
}

#[test]
fn sizes_that_boxes_cannot_hold_are_refused_with_the_sheet() {
    let job = Job::default();
    for factor in [1e-30, 1e-9, 1.0, 1e36] {
        let surface = Surface::new(vec![bump(9, 2.0 * factor)], None, &job).unwrap();
        let [low, high] = surface.bounds();
        assert!(low.distance(high) < 6.0 * factor, "{factor}");
        assert!(surface.tolerance() <= 6e-9 * factor && surface.tolerance() >= 2e-9 * factor);
        let query = factor * DVec3::new(0.3, 0.7, 4.0);
        let found = surface.closest_all(&[query], f64::INFINITY, &job).unwrap()[0].unwrap();
        let off = (query - found.point).normalize().cross(found.normal).length();
        assert!(off < 1e-6, "{factor}: {off}");
    }
    for factor in [1e-300, 1e-60, 1e-31, 1e38, 1e39, 1e300, 1.7e308] {
        let refused = Surface::new(vec![bump(9, 1.0), bump(9, factor)], None, &job);
        assert!(matches!(refused, Err(Error::SheetOutOfRange { sheet: 1, .. })), "{factor}");
        assert!(Surface::new(vec![bump(2, factor)], None, &job).is_err());
    }
    let point = Surface::new(vec![bump(9, 0.0)], None, &job).unwrap();
    assert_eq!(point.tolerance(), 0.0);
}

#[test]
fn creases_are_those_of_normals_at_places() {
    for shape in &SHAPES {
        for scheme in [Scheme::SixTap, Scheme::FourPoint] {
            let sheet = Sheet::Grid(Grid::new(grid(shape).nodes().clone(), shape.closed, scheme).unwrap());
            let [rows, columns] = sheet.cells();
            let mut worst = 0.0_f64;
            let mut join = |a: DVec3, b: DVec3| {
                if a != DVec3::ZERO && b != DVec3::ZERO {
                    worst = worst.max(a.cross(b).length().atan2(a.dot(b)));
                }
            };
            for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
                for t in [0.0, 0.5, 1.0] {
                    if i + 1 < rows || shape.closed[0] {
                        join(sheet.normal(i, j, 1.0, t), sheet.normal((i + 1) % rows, j, 0.0, t));
                    }
                    if j + 1 < columns || shape.closed[1] {
                        join(sheet.normal(i, j, t, 1.0), sheet.normal(i, (j + 1) % columns, t, 0.0));
                    }
                }
            }
            let crease = sheet.largest_crease_angle(&Job::default()).unwrap();
            assert!((crease - worst).abs() < 1e-12, "{} {scheme:?}: {crease} {worst}", shape.name);
            assert_eq!(
                crease.to_bits(),
                sheet.largest_crease_angle(&Job::new(1, &Count::default())).unwrap().to_bits()
            );
        }
    }
}

/// Counts reports of progress, which do not go back.
#[derive(Default)]
struct Count(Cell<u32>, Cell<f64>);

impl Progress for Count {
    fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
        assert!(fraction >= self.1.get());
        self.0.set(self.0.get() + 1);
        self.1.set(fraction);
        ControlFlow::Continue(())
    }
}

#[test]
fn long_work_asks_often_whether_to_stop() {
    let sheet = bump(801, 1.0);
    let count = Count::default();
    let one = Surface::new(vec![sheet.clone(), sheet.clone()], None, &Job::new(2, &count)).unwrap();
    assert!(count.0.get() >= 6, "{}", count.0.get());
    let two = Surface::new(vec![sheet.clone(), sheet.clone()], None, &Job::new(1, &Count::default())).unwrap();
    assert_eq!(one.bounds(), two.bounds());
    let count = Count::default();
    sheet.largest_crease_angle(&Job::new(2, &count)).unwrap();
    assert!(count.0.get() >= 10, "{}", count.0.get());
}
