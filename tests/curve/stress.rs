//! Every operation on curves, on input that means no good: no panic, an end in time, nothing that
//! is not a number where there is one.

use glam::DVec3;
use gusset::Job;
use gusset::curve::ops::{OffsetOptions, SampleSpacing};
use gusset::curve::{CurveView, Place};
use proptest::prelude::*;

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -1.0..1.0f64,
        2 => Just(0.0),
        1 => Just(1.0),
        1 => Just(1.7e308),
        1 => Just(-1.7e308),
        1 => Just(5e-324),
        1 => Just(1e-200),
        1 => Just(-1e200),
        1 => -1e-9..1e-9f64,
    ]
}

fn curves() -> impl Strategy<Value = (Vec<DVec3>, Vec<u32>, bool)> {
    let degrees = proptest::collection::vec(prop_oneof![4 => 1usize..5, 1 => 5usize..65], 0..4);
    (degrees, any::<bool>(), any::<bool>(), any::<bool>()).prop_flat_map(|(degrees, closed, flat, tame)| {
        let count = degrees.iter().sum::<usize>() + 1;
        let xyz = if tame {
            (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64).boxed()
        } else {
            (coordinate(), coordinate(), coordinate()).boxed()
        };
        proptest::collection::vec(xyz, count).prop_map(move |raw| {
            let mut points: Vec<DVec3> =
                raw.iter().map(|&(x, y, z)| DVec3::new(x, y, if flat { 0.0 } else { z })).collect();
            if closed {
                points[count - 1] = points[0];
            }
            let ends = std::iter::once(0).chain(degrees.iter().scan(0, |sum, &n| {
                *sum += n as u32;
                Some(*sum)
            }));
            (points, ends.collect(), closed)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn everything_comes_to_an_end(
        (points, ends, closed) in curves(), t in 0.0..=1.0f64, x in coordinate(), y in coordinate(), z in coordinate()
    ) {
        let curve = CurveView::new(&points, &ends, closed).unwrap();
        let job = Job::default();
        let q = DVec3::new(x, y, z);
        let place = Place { segment: (curve.len() / 2) as u32, t };
        let places = [place];
        let _ = (curve.point(place), curve.derivatives_at(&places, 5, &Job::default()), curve.curvatures_at(&places, &Job::default()));
        if let Ok(tangents) = curve.tangents_at(&places, &Job::default()) {
            prop_assert!(tangents[0].is_finite() && tangents[0].length() < 1.0 + 1e-9);
        }
        let _ = (curve.split(place, &Job::default()), curve.sub_curve(place, Place { segment: 0, t: 0.5 }, &Job::default()), curve.reversed(&Job::default()).unwrap());
        let _ = (curve.with_degree_elevated_by(3, &Job::default()), curve.with_degree_elevated_to(64, &Job::default()), curve.with_reduced_degree(3, x, &Job::default()), curve.with_reduced_degree(2, f64::INFINITY, &Job::default()));
        if let Ok(found) = curve.nearest_to_each_query(&[q], &job) {
            prop_assert!(!found[0].distance.is_nan() && (0.0..=1.0).contains(&found[0].place.t));
        }
        prop_assert!(!curve.length().unwrap().is_nan());
        if let Ok(half) = curve.arc_lengths(&Job::default()).unwrap().place_at_length(0.5 * curve.length().unwrap()) {
            prop_assert!((0.0..=1.0).contains(&half.t));
        }
        let _ = (curve.area_vector(&Job::default()), curve.moments(&Job::default()), curve.bounding_box(&Job::default()).unwrap());
        if let Ok(found) = curve.intersect_plane(q, DVec3::new(y, z, x), &Job::default()) {
            prop_assert!(found.places.iter().all(|p| (0.0..=1.0).contains(&p.t)));
        }
        let _ = curve.intersect_line(DVec3::new(x, y, 0.0), DVec3::new(z, x, 0.0), &Job::default());
        if let Ok(found) = curve.self_intersections(&job) {
            prop_assert!(found.points.iter().all(|m| curve.point(m.a).is_ok() && curve.point(m.b).is_ok()));
        }
        let back = curve.reversed(&Job::default()).unwrap();
        let _ = curve.intersections(&back.view(), &job);
        let _ = [SampleSpacing::Count(7), SampleSpacing::Step(curve.length().unwrap() / 9.0)].map(|spacing| curve.sample_points(spacing, &Job::default()));
        let _ = (curve.to_svg_path(&Job::default()), curve.to_truetype_contour(0.0, &Job::default()), curve.to_clamped_spline(&Job::default()));
        let options = OffsetOptions { degree: 3, tolerance: 1e-3, max_segments: 50 };
        if let Ok(done) = curve.offset(x, &options, &Job::default()) {
            prop_assert!(done.curve.view().points().iter().all(|p| !p.is_nan()));
        }
    }
}
