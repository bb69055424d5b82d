//! Nets of curves in any order: the surface, and the curve that breaks the order.

use crate::construct::{distance_from, through};
use glam::DVec3;
use gusset::curve::{Curve, CurveView};
use gusset::surface::Sheet;
use gusset::surface::construct::CurveNet;
use gusset::{Error, Job};
use std::f64::consts::TAU;

/// A net on a paraboloid, open or closed in v, whose curves are listed in any order and run in any
/// direction, makes the same surface.
#[test]
fn nets_in_any_order() {
    let job = Job::default();
    let mut random = fastrand::Rng::with_seed(4);
    for case in 0..40 {
        let closed = case % 2 == 1;
        let (height, width) = (3 + case % 4, 4 + case / 8);
        let point = |u: f64, v: f64| {
            let (r, angle) = (1.0 + u, v * if closed { TAU } else { 2.0 });
            DVec3::new(r * angle.cos(), r * angle.sin(), r * r)
        };
        let u_of = |k: usize| k as f64 / (height - 1) as f64;
        let v_of = |l: usize| l as f64 / if closed { width } else { width - 1 } as f64;
        // Joints of the curves are the nodes, and two points between two nodes.
        let parts = if closed { 3 * width } else { 3 * (width - 1) };
        let row = |k: usize| {
            let count = if closed { parts } else { parts + 1 };
            through(&(0..count).map(|i| point(u_of(k), i as f64 / parts as f64)).collect::<Vec<_>>(), closed)
        };
        let column = |l: usize| {
            let count = 3 * (height - 1);
            through(&(0..=count).map(|i| point(i as f64 / count as f64, v_of(l))).collect::<Vec<_>>(), false)
        };
        let (rows, columns): (Vec<Curve>, Vec<Curve>) =
            ((0..height).map(row).collect(), (0..width).map(column).collect());
        let make = |rows: &[&Curve], columns: &[&Curve]| {
            let [rows, columns] =
                [rows, columns].map(|curves| curves.iter().map(|curve| curve.view()).collect::<Vec<_>>());
            Sheet::from_curves(
                &CurveNet { rows: &rows, columns: &columns, closed: [false, closed], tolerance: Some(1e-9) },
                &job,
            )
        };
        // Another order than the given one or its reverse, which is kept.
        let mut shuffled = |count: usize, first: usize| {
            let mut order: Vec<usize> = (0..count).collect();
            while order.windows(2).skip(first).all(|pair| pair[0] < pair[1])
                || order.windows(2).skip(first).all(|pair| pair[0] > pair[1])
            {
                random.shuffle(&mut order[first..]);
            }
            order
        };
        let sorted = make(&rows.iter().collect::<Vec<_>>(), &columns.iter().collect::<Vec<_>>()).unwrap();
        let these: Vec<usize> = shuffled(height, 0);
        let those: Vec<&Curve> = shuffled(width, usize::from(closed)).into_iter().map(|l| &columns[l]).collect();
        let made = make(&these.iter().map(|&k| &rows[k]).collect::<Vec<_>>(), &those).unwrap();
        assert!((0..sorted.cells()[0]).all(|i| made.jet(i, 1, 0.3, 0.6) == sorted.jet(i, 1, 0.3, 0.6)), "{case}");
        // If some rows run backwards, the surface may begin at another corner.
        let turned: Vec<Curve> =
            these
                .iter()
                .map(|&k| {
                    if k % 2 == 0 { rows[k].view().reversed(&job).unwrap() } else { rows[k].view().to_owned().unwrap() }
                })
                .collect();
        let made = make(&turned.iter().collect::<Vec<_>>(), &those).unwrap();
        for curve in rows.iter().chain(&columns) {
            assert!(distance_from(&made, curve.view()) < 1e-9, "{case}");
        }
    }
}

#[test]
fn the_curve_that_breaks_the_order_is_named() {
    let job = Job::default();
    let line = |points: &[DVec3]| {
        let ends: Vec<u32> = (0..points.len() as u32).collect();
        CurveView::new(points, &ends, false).unwrap().to_owned().unwrap()
    };
    for bad in 0..4 {
        // Row `bad` crosses the columns in the order 0, 2, 1, 3.
        let row = |k: usize| {
            let order = if k == bad { [0, 2, 1, 3] } else { [0, 1, 2, 3] };
            let points = order.map(|l| DVec3::new(k as f64, f64::from(l), 0.0));
            let beside = (0..3).map(|i| points[i].lerp(points[i + 1], 0.5) + 0.1 * DVec3::Z);
            let [a, b, c]: [DVec3; 3] = beside.collect::<Vec<_>>().try_into().unwrap();
            line(&[points[0], a, points[1], b, points[2], c, points[3]])
        };
        let rows: Vec<Curve> = (0..4).map(row).collect();
        let columns: Vec<Curve> =
            (0..4).map(|l| line(&[DVec3::new(0.0, f64::from(l), 0.0), DVec3::new(3.0, f64::from(l), 0.0)])).collect();
        let [rows, columns] = [&rows, &columns].map(|curves| curves.iter().map(Curve::view).collect::<Vec<_>>());
        let net = CurveNet { rows: &rows, columns: &columns, closed: [false; 2], tolerance: None };
        let refused = Sheet::from_curves(&net, &job).unwrap_err();
        assert!(
            matches!(refused, Error::CurvesOutOfOrder { row, curve: "row", .. } if row as usize == bad),
            "{bad}: {refused}"
        );
    }
}
