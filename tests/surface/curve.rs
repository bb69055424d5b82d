//! Curves that meet surfaces, and curves as surfaces: through points, along sheets, near to each
//! other.

use crate::shapes::{Random, SHAPES, Shape, grid};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{Curve, CurveView, Place};
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::{Grid, Patches, Scheme, Sheet, Surface, curve_through};
use std::f64::consts::TAU;

fn surface(shape: &Shape) -> (Grid<'static>, Surface<'static>) {
    let grid = grid(shape);
    let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
    (grid, surface)
}

fn at(curve: &CurveView<'_>, place: Place) -> DVec3 {
    curve.point(place).unwrap()
}

#[test]
fn straight_curves_are_segments() {
    for shape in &SHAPES {
        let (_, surface) = surface(shape);
        let mut random = Random(17);
        let mut total = 0;
        for k in 0..120 {
            let (a, b) = (random.point(1.5), random.point(1.3));
            let lines = surface.line(&Line::segment(a, b), HitSelection::All).unwrap();
            // As a line, a cubic, and a curve of degree 7.
            for degree in [1_u32, 3, 7] {
                let points: Vec<DVec3> = (0..=degree).map(|n| a.lerp(b, f64::from(n) / f64::from(degree))).collect();
                let ends = [0, degree];
                let curve = CurveView::new(&points, &ends, false).unwrap();
                let hits = surface.curve(&curve, HitSelection::All, &Job::default()).unwrap();
                assert_eq!(hits.len(), lines.len(), "{} {k} {degree}: {lines:?} {hits:?}", shape.name);
                for (hit, line) in hits.iter().zip(&lines) {
                    assert_eq!((hit.tangent, hit.multiplicity), (line.tangent, line.multiplicity));
                    assert!(
                        (hit.at.t - line.at).abs() < 1e-8 && hit.point.distance(line.point) < 1e-8,
                        "{hit:?} {line:?}"
                    );
                    assert_eq!(hit.point, surface.jet(hit.place).point);
                }
                let first = surface.curve(&curve, HitSelection::First, &Job::default()).unwrap();
                assert_eq!(first.first(), hits.first());
                assert_eq!(
                    surface.curve(&curve, HitSelection::Any, &Job::default()).unwrap().is_empty(),
                    hits.is_empty()
                );
            }
            total += lines.len();
        }
        assert!(total > 15, "{}: {total}", shape.name);
    }
}

/// Compares curves of degree 3 and 5 with fine polylines.
fn compare(shape: &Shape, count: usize) {
    let (_, surface) = surface(shape);
    let mut random = Random(23);
    let mut total = 0;
    for k in 0..count {
        let degree = if k % 2 == 0 { 3 } else { 5 };
        let points: Vec<DVec3> = (0..=degree).map(|_| random.point(1.5)).collect();
        let ends = [0, degree];
        let curve = CurveView::new(&points, &ends, false).unwrap();
        let hits = surface.curve(&curve, HitSelection::All, &Job::default()).unwrap();
        for hit in &hits {
            assert!(at(&curve, hit.at).distance(hit.point) < if hit.tangent { 1e-6 } else { 1e-12 }, "{hit:?}");
        }
        let pieces = 2000_u32;
        let fine: Vec<DVec3> =
            (0..=pieces).map(|n| at(&curve, Place { segment: 0, t: f64::from(n) / f64::from(pieces) })).collect();
        let fine_ends: Vec<u32> = (0..=pieces).collect();
        let polyline = CurveView::new(&fine, &fine_ends, false).unwrap();
        let rough = surface.curve(&polyline, HitSelection::All, &Job::default()).unwrap();
        let rough: Vec<f64> =
            rough.iter().map(|hit| (f64::from(hit.at.segment) + hit.at.t) / f64::from(pieces)).collect();
        let fine: Vec<f64> = hits.iter().map(|hit| hit.at.t).collect();
        // Each point of one is near a point of the other, except pairs that nearly touch.
        let matched = |from: &[f64], to: &[f64], limit: f64| {
            from.iter().enumerate().all(|(n, t)| {
                let pair = from.iter().enumerate().any(|(m, s)| m != n && (s - t).abs() < 0.02);
                pair || to.iter().any(|s| (s - t).abs() < limit)
            })
        };
        assert!(matched(&fine, &rough, 1e-3), "{} {k}: {fine:?} {rough:?}", shape.name);
        assert!(matched(&rough, &fine, 1e-3), "{} {k}: {fine:?} {rough:?}", shape.name);
        total += hits.len();
    }
    assert!(total > count / 3, "{}: {total}", shape.name);
}

#[test]
fn curved_ones_against_polylines() {
    for shape in &SHAPES {
        compare(shape, 60);
    }
}

#[test]
#[ignore = "minutes"]
fn exhaustive_curves_against_polylines() {
    for shape in &SHAPES {
        compare(shape, 5_000);
    }
}

#[test]
fn joints_on_nodes_are_found_once() {
    for shape in &SHAPES {
        let (grid, surface) = surface(shape);
        let [h, w] = grid.cells();
        let mut random = Random(31);
        for k in 0..60 {
            let node = grid.nodes().get((5 * k + 1) % h, (7 * k) % w);
            let (a, b) = (random.point(1.6), random.point(1.6));
            // A polyline with its joint at a node, and two cubics.
            let polyline = ([a, node, b].to_vec(), vec![0, 1, 2]);
            let middle = 0.2 * random.point(1.0);
            let cubics = vec![a, a.lerp(node, 0.3), node - middle, node, node + middle, b.lerp(node, 0.3), b];
            for (points, ends) in [polyline, (cubics, vec![0, 3, 6])] {
                let curve = CurveView::new(&points, &ends, false).unwrap();
                let hits = surface.curve(&curve, HitSelection::All, &Job::default()).unwrap();
                let here = hits.iter().filter(|hit| hit.point.distance(node) < 1e-8).count();
                assert_eq!(here, 1, "{} {k}: {hits:?}", shape.name);
                assert!(hits.windows(2).all(|pair| {
                    let along = |at: Place| f64::from(at.segment) + at.t;
                    along(pair[0].at) <= along(pair[1].at)
                }));
            }
            // Closed: its start and end at the node.
            let triangle = [node, a, b, node];
            let curve = CurveView::new(&triangle, &[0, 1, 2, 3], true).unwrap();
            let hits = surface.curve(&curve, HitSelection::All, &Job::default()).unwrap();
            let here = hits.iter().filter(|hit| hit.point.distance(node) < 1e-8).count();
            assert_eq!(here, 1, "{} {k}: {hits:?}", shape.name);
        }
    }
}

#[test]
fn coordinate_curves_run_inside() {
    let (grid, surface) = surface(&SHAPES[2]);
    let sheet = Sheet::Grid(grid.clone());
    for (curve, cells) in
        [(sheet.row_curve(3.3, &Job::default()).unwrap(), 52), (sheet.column_curve(7.0, &Job::default()).unwrap(), 40)]
    {
        assert_eq!(curve.view().len(), cells);
        let hits = surface.curve(&curve.view(), HitSelection::All, &Job::default()).unwrap();
        assert_eq!(hits.len(), 1, "{hits:?}");
        assert_eq!((hits[0].multiplicity, hits[0].tangent), (0, true));
        let along = |at: Place| f64::from(at.segment) + at.t;
        assert!(along(hits[0].span[0]) < 0.05 && along(hits[0].span[1]) > cells as f64 - 0.05, "{hits:?}");
        let first = surface.curve(&curve.view(), HitSelection::First, &Job::default()).unwrap();
        assert_eq!(first, hits);
    }
}

#[test]
fn coordinate_curves_are_on_the_sheet() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let [h, w] = grid.cells();
        let points: Vec<DVec3> =
            (0..h * w).flat_map(|k| grid.patch(k / w, k % w).points.as_flattened().to_vec()).collect();
        let patches = Sheet::Cubic(Patches::<4>::new(&points, [3, 3], h, w).unwrap());
        for sheet in [Sheet::Grid(grid.clone()), patches] {
            let closed = matches!(sheet, Sheet::Grid(_));
            for k in 0..12 {
                let u = h as f64 * f64::from(k) / 11.0;
                let (i, within) = ((u as usize).min(h - 1), u - (u as usize).min(h - 1) as f64);
                let curve = sheet.row_curve(u, &Job::default()).unwrap();
                assert_eq!(curve.view().is_closed(), shape.closed[1] && closed);
                for j in 0..w {
                    for t in [0.0, 0.3, 1.0] {
                        let point = at(&curve.view(), Place { segment: j as u32, t });
                        assert!(point.distance(sheet.jet(i, j, within, t).point) < 1e-14, "{} {u} {j}", shape.name);
                    }
                }
                let v = w as f64 * f64::from(k) / 11.0;
                let (j, within) = ((v as usize).min(w - 1), v - (v as usize).min(w - 1) as f64);
                let curve = sheet.column_curve(v, &Job::default()).unwrap();
                for i in 0..h {
                    let point = at(&curve.view(), Place { segment: i as u32, t: 0.7 });
                    assert!(point.distance(sheet.jet(i, j, 0.7, within).point) < 1e-14, "{} {v} {i}", shape.name);
                }
            }
            assert!(
                sheet.row_curve(-0.1, &Job::default()).is_err()
                    && sheet.row_curve(h as f64 + 0.1, &Job::default()).is_err()
            );
            assert!(sheet.column_curve(f64::NAN, &Job::default()).is_err());
        }
    }
}

fn circle(count: usize, scheme: Scheme) -> Curve {
    let nodes: Vec<DVec3> = (0..=count)
        .map(|k| {
            let turn = TAU * (k % count) as f64 / count as f64;
            DVec3::new(turn.cos(), turn.sin(), 0.5 * (2.0 * turn).sin())
        })
        .collect();
    curve_through(&nodes, true, scheme, &Job::default()).unwrap()
}

#[test]
fn curves_through_points_are_of_fourth_order() {
    for (scheme, least) in [(Scheme::SixTap, 3.8), (Scheme::FourPoint, 3.8)] {
        let errors = [16, 32, 64, 128].map(|count| {
            let curve = circle(count, scheme);
            let mut worst = 0.0_f64;
            for k in 0..count {
                for n in 0..=8 {
                    let t = f64::from(n) / 8.0;
                    let turn = TAU * (k as f64 + t) / count as f64;
                    let truth = DVec3::new(turn.cos(), turn.sin(), 0.5 * (2.0 * turn).sin());
                    worst = worst.max(at(&curve.view(), Place { segment: k as u32, t }).distance(truth));
                }
            }
            worst
        });
        assert!((errors[2] / errors[3]).log2() > least, "{scheme:?} {errors:?}");
    }
    // A row of a grid is the curve through its nodes.
    let shape = &SHAPES[2];
    let grid = grid(shape);
    let nodes: Vec<DVec3> = (0..grid.nodes().columns()).map(|j| grid.nodes().get(6, j)).collect();
    let curve = curve_through(&nodes, false, Scheme::SixTap, &Job::default()).unwrap();
    let row = Sheet::Grid(grid).row_curve(6.0, &Job::default()).unwrap();
    let far = curve.view().points().iter().zip(row.view().points()).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(far < 1e-15);
    assert!(curve_through(&nodes[..1], false, Scheme::SixTap, &Job::default()).is_err());
    assert!(curve_through(&nodes, true, Scheme::SixTap, &Job::default()).is_err());
    let nan = [DVec3::ZERO, DVec3::NAN];
    assert!(curve_through(&nan, false, Scheme::SixTap, &Job::default()).is_err());
}

/// Local least distances of two curves, by dense samples.
fn sampled(a: &CurveView<'_>, b: &CurveView<'_>, within: f64) -> Vec<(f64, f64)> {
    let many = 60_usize;
    let points = |curve: &CurveView<'_>| -> Vec<DVec3> {
        (0..=many * curve.len())
            .map(|k| {
                let segment = (k / many).min(curve.len() - 1);
                at(curve, Place { segment: segment as u32, t: (k - segment * many) as f64 / many as f64 })
            })
            .collect()
    };
    let (p, q) = (points(a), points(b));
    let distance = |i: usize, j: usize| p[i].distance_squared(q[j]);
    let mut found = Vec::new();
    for (i, j) in (0..p.len()).flat_map(|i| (0..q.len()).map(move |j| (i, j))) {
        let here = distance(i, j);
        let around = (i.saturating_sub(1)..=(i + 1).min(p.len() - 1))
            .flat_map(|i| (j.saturating_sub(1)..=(j + 1).min(q.len() - 1)).map(move |j| (i, j)));
        if here.sqrt() < within && around.filter(|&near| near != (i, j)).all(|(i, j)| distance(i, j) > here) {
            // Valleys have false ones between samples: down the hill by ever smaller steps.
            let point = |curve: &CurveView<'_>, x: f64| {
                let x = x.clamp(0.0, curve.len() as f64);
                let segment = (x as usize).min(curve.len() - 1);
                at(curve, Place { segment: segment as u32, t: x - segment as f64 })
            };
            let value = |x: f64, y: f64| point(a, x).distance_squared(point(b, y));
            let (mut x, mut y, mut step) = (i as f64 / many as f64, j as f64 / many as f64, 0.01);
            while step > 1e-6 {
                let around = (0..32).map(|k| {
                    let turn = TAU * f64::from(k) / 32.0;
                    (x + step * turn.cos(), y + step * turn.sin())
                });
                let best = around.min_by(|p, q| value(p.0, p.1).total_cmp(&value(q.0, q.1))).unwrap();
                if value(best.0, best.1) < value(x, y) { (x, y) = best } else { step *= 0.5 }
            }
            found.push((x.clamp(0.0, a.len() as f64), y.clamp(0.0, b.len() as f64)));
        }
    }
    found
}

#[test]
fn approaches_against_samples() {
    let mut random = Random(41);
    let mut total = 0;
    for k in 0..40 {
        let nodes = |random: &mut Random| -> Vec<DVec3> { (0..7).map(|_| random.point(1.0)).collect() };
        let (a, b) = (nodes(&mut random), nodes(&mut random));
        let a = curve_through(&a, false, Scheme::SixTap, &Job::default()).unwrap();
        let b = curve_through(&b, false, Scheme::FourPoint, &Job::default()).unwrap();
        let within = 0.2;
        let found = a.view().near_misses(&b.view(), within, &Job::default()).unwrap();
        assert!(!found.undecided, "{k}: {found:?}");
        let along = |at: Place| f64::from(at.segment) + at.t;
        for approach in &found.places {
            let distance = at(&a.view(), approach.a).distance(at(&b.view(), approach.b));
            assert!((distance - approach.distance).abs() < 1e-12 && distance <= within, "{approach:?}");
        }
        // Intersections that samples show clearly are found.
        for (s, t) in sampled(&a.view(), &b.view(), 0.9 * within) {
            let near = |p: &&gusset::curve::ops::NearMiss| (along(p.a) - s).abs() < 0.1 && (along(p.b) - t).abs() < 0.1;
            assert!(found.places.iter().any(|place| near(&place)), "{k}: {s} {t} {found:?}");
        }
        total += found.places.len();
    }
    assert!(total > 40, "{total}");
}

#[test]
fn curves_that_cross_touch_and_run_together() {
    let job = Job::default();
    // Two circles through each other's points, in different planes; with a common point at a joint
    // of both.
    let ring = |turned: bool| -> Curve {
        let nodes: Vec<DVec3> = (0..=40)
            .map(|k| {
                let turn = TAU * f64::from(k % 40) / 40.0;
                let (x, y) = (turn.cos(), turn.sin());
                if turned { DVec3::new(x, 0.0, y) } else { DVec3::new(x, y, 0.0) }
            })
            .collect();
        curve_through(&nodes, true, Scheme::SixTap, &Job::default()).unwrap()
    };
    let (a, b) = (ring(false), ring(true));
    let found = a.view().near_misses(&b.view(), 1e-9, &job).unwrap();
    assert_eq!((found.places.len(), found.overlaps.len(), found.undecided), (2, 0, false), "{found:?}");
    assert!(found.places.iter().all(|place| place.distance < 1e-12));
    // The same curve twice.
    let found = a.view().near_misses(&a.view(), 1e-9, &job).unwrap();
    assert!(!found.overlaps.is_empty(), "{found:?}");
    // Lines: through the ring's middle none, across it two, along a tangent one.
    let across = Line::new(DVec3::new(-2.0, 0.0, 0.0), DVec3::X);
    let found = across.near_misses(&a.view(), 1e-9, &job).unwrap();
    assert_eq!(found.places.len(), 2, "{found:?}");
    for place in &found.places {
        assert!(at(&a.view(), place.a).distance(DVec3::new(place.b.t - 2.0, 0.0, 0.0)) < 1e-9, "{place:?}");
    }
    let through = Line::new(DVec3::ZERO, DVec3::Z);
    assert!(through.near_misses(&a.view(), 0.5, &job).unwrap().places.is_empty());
    let ray = Line::ray(DVec3::ZERO, DVec3::new(0.3, 0.4, 0.0));
    assert_eq!(ray.near_misses(&a.view(), 1e-4, &job).unwrap().places.len(), 1);
    let tangent = Line::new(DVec3::new(1.0, 0.0, 0.0), DVec3::Y);
    let found = tangent.near_misses(&a.view(), 1e-6, &job).unwrap();
    assert!(!found.places.is_empty() && found.places.iter().all(|place| place.b.t.abs() < 1e-2), "{found:?}");
    // A straight curve across a line, without a distance.
    let bar = curve_through(&[-1.0, 0.0, 1.0].map(|x| DVec3::new(x, 0.0, 0.0)), false, Scheme::SixTap, &job).unwrap();
    let line = Line::new(DVec3::new(0.25, -3.0, 0.0), DVec3::new(0.0, 2.0, 0.0));
    let found = line.near_misses(&bar.view(), 0.0, &job).unwrap();
    assert_eq!(found.places.len(), 1, "{found:?}");
    assert!((found.places[0].b.t - 1.5).abs() < 1e-12 && found.places[0].distance < 1e-12, "{found:?}");
    // In the plane meetings are exact: a line that touches the ring at a joint meets it once.
    let found = tangent.intersections_or_near_misses(&a.view(), 0.0, &job).unwrap();
    assert_eq!((found.places.len(), found.overlaps.len()), (1, 0), "{found:?}");
    assert_eq!(found.places[0].b.t, 0.0);
    let found = across.intersections_or_near_misses(&a.view(), 0.0, &job).unwrap();
    let exact = a.view().intersect_line(across.origin, across.direction, &job).unwrap();
    assert_eq!(found.places.iter().map(|place| place.a).collect::<Vec<_>>(), exact.places);
    // Its places are those between its ends.
    assert_eq!(ray.intersections_or_near_misses(&a.view(), 0.0, &job).unwrap().places.len(), 1);
    let up_to_it = Line::segment(DVec3::ZERO, DVec3::X);
    assert_eq!(up_to_it.intersections_or_near_misses(&a.view(), 0.0, &job).unwrap().places.len(), 1);
    let within_it = Line::segment(DVec3::ZERO, DVec3::X * 0.5);
    assert_eq!(within_it.intersections_or_near_misses(&a.view(), 0.0, &job).unwrap().places.len(), 0);
    // In space, with a distance, and along a segment they are near misses.
    assert_eq!(
        across.intersections_or_near_misses(&b.view(), 0.0, &job).unwrap(),
        across.near_misses(&b.view(), 0.0, &job).unwrap()
    );
    assert_eq!(
        across.intersections_or_near_misses(&a.view(), 0.1, &job).unwrap(),
        across.near_misses(&a.view(), 0.1, &job).unwrap()
    );
    assert!(!across.intersections_or_near_misses(&bar.view(), 0.0, &job).unwrap().overlaps.is_empty());
    for within in [f64::NAN, -1.0, f64::INFINITY] {
        assert!(across.intersections_or_near_misses(&a.view(), within, &job).is_err());
        assert!(a.view().near_misses(&b.view(), within, &job).is_err());
        assert!(across.near_misses(&a.view(), within, &job).is_err());
    }
}

#[test]
fn what_is_refused() {
    let (_, surface) = surface(&SHAPES[2]);
    let points: Vec<DVec3> = (0..9).map(|k| DVec3::splat(f64::from(k))).collect();
    let high = CurveView::new(&points, &[0, 8], false).unwrap();
    assert!(surface.curve(&high, HitSelection::All, &Job::default()).is_err());
    let empty = CurveView::new(&[], &[0], false).unwrap();
    assert!(surface.curve(&empty, HitSelection::All, &Job::default()).is_err());
    // Segments without extent, far away, and huge ones.
    for points in
        [[DVec3::ZERO; 4], [DVec3::splat(1e12); 4], [DVec3::splat(-1e100), DVec3::X, DVec3::Y, DVec3::splat(1e100)]]
    {
        let curve = CurveView::new(&points, &[0, 3], false).unwrap();
        assert!(surface.curve(&curve, HitSelection::All, &Job::default()).is_ok());
    }
}
