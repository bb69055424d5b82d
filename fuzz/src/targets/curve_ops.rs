//! Queries of any curve: answers within their ranges, or errors.

use crate::input;
use crate::input::{Cloud, Point, places};
use gusset::Job;
use gusset::curve::ops::{OffsetOptions, SampleSpacing};
use gusset::curve::{CurveView, Place};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Cloud, Vec<u8>, bool, Point, u8)>(bytes) else { return };
    let (points, degrees, closed, query, t) = input;
    let mut ends = vec![0];
    ends.extend(degrees.iter().take(8).scan(0, |end, &degree| {
        *end += 1 + u32::from(degree % 7);
        Some(*end)
    }));
    let needed = ends[ends.len() - 1] as usize + 1;
    let mut points: Vec<_> = places(&points).into_iter().cycle().take(needed).collect();
    if let (true, Some(&first)) = (closed, points.first()) {
        points[needed - 1] = first;
    }
    let Ok(curve) = CurveView::new(&points, &ends, closed) else { return };
    let (job, query, t) = (Job::default(), query.at(), f64::from(t) / 255.0);
    let place = Place { segment: 0, t };
    let _ = (
        curve.split(place, &Job::default()),
        curve.with_degree_elevated_by(2, &Job::default()),
        curve.with_reduced_degree(2, 0.1, &Job::default()),
        curve.bounding_box(&Job::default()),
        curve.moments(&Job::default()),
    );
    if let Ok(found) = curve.nearest_to_each_query(&[query], &job) {
        assert!(!found[0].distance.is_nan() && (0.0..=1.0).contains(&found[0].place.t));
    }
    if let Ok(found) = curve.intersect_plane(query, glam::DVec3::new(query.y, query.z, query.x), &Job::default()) {
        assert!(found.places.iter().all(|place| (0.0..=1.0).contains(&place.t)));
    }
    if let Ok(found) = curve.self_intersections(&job) {
        assert!(found.points.iter().all(|both| curve.point(both.a).is_ok() && curve.point(both.b).is_ok()));
    }
    let _ = (
        curve.sample_points(SampleSpacing::Count(7), &Job::default()),
        curve.to_svg_path(&Job::default()),
        curve.to_truetype_contour(0.0, &Job::default()),
        curve.to_clamped_spline(&Job::default()),
    );
    let options = OffsetOptions { degree: 3, tolerance: 1e-3, max_segments: 50 };
    if let Ok(done) = curve.offset(t, &options, &Job::default()) {
        assert!(done.curve.view().points().iter().all(|point| !point.is_nan()));
    }
}
