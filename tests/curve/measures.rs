//! Several measures in one call, segments of degrees within limits, and where curves meet: each against
//! the functions that compute one of them.

use crate::curves::{Given, curves, v};
use gusset::curve::ops::{MeasureSelection, Measures};
use gusset::{Error, Job};
use proptest::prelude::*;

fn job() -> Job<'static> {
    Job::default()
}

const NONE: MeasureSelection =
    MeasureSelection { length: false, bounds: false, centre: false, area: false, moments: false };

proptest! {
    #[test]
    fn measures_are_those_of_single_functions(given in curves(true)) {
        let curve = given.view();
        let (length, area_vector) = (curve.length().unwrap(), curve.area_vector(&job()).unwrap());
        let area = Measures { area_vector: Some(area_vector), ..Measures::default() }.area();
        let found = curve.measures(MeasureSelection::ALL, &job());
        if !length.is_finite() || !area.is_finite() {
            let is_named = matches!(found, Err(Error::CoordinateTooLarge { value, .. }) if value.abs() > 1e150);
            prop_assert!(is_named, "{:?}", found);
            return Ok(());
        }
        let all = found.unwrap();
        prop_assert_eq!(all.length, Some(length));
        prop_assert_eq!(all.bounds, Some(curve.bounding_box(&job()).unwrap()));
        prop_assert_eq!(all.centre, Some(curve.centre(&job()).unwrap()));
        prop_assert_eq!(all.area_vector, Some(area_vector));
        // Moments that overflow are left out.
        let moments = format!("{:?}", curve.moments(&job()).unwrap());
        let expected = if moments.contains("inf") || moments.contains("NaN") { None } else { Some(moments) };
        prop_assert_eq!(all.moments.map(|moments| format!("{moments:?}")), expected);
        // Only the requested measures.
        let length = curve.measures(MeasureSelection { length: true, ..NONE }, &job()).unwrap();
        prop_assert_eq!(length, Measures { length: all.length, ..Measures::default() });
    }

    #[test]
    fn degrees_within_limits(given in curves(false), lowest in 1usize..8, more in 0usize..4) {
        let (curve, highest) = (given.view(), lowest + more);
        let changed = curve.with_degrees([lowest, highest], f64::INFINITY, &job()).unwrap();
        let view = changed.curve.view();
        for k in 0..curve.len() {
            let (old, new) = (curve.segment(k).len() - 1, view.segment(k).len() - 1);
            prop_assert_eq!(new, if changed.kept.contains(&(k as u32)) { old } else { old.clamp(lowest, highest) });
            prop_assert!(old > highest || changed.deviations[k] == 0.0);
        }
        let raised = curve.with_degrees([lowest, 64], 0.0, &job()).unwrap().curve;
        prop_assert_eq!(raised, curve.with_degree_elevated_to(lowest, &job()).unwrap());
    }
}

#[test]
fn measures_that_a_curve_lacks() {
    let bent = Given { points: vec![v(0.0, 0.0, 0.0), v(1.0, 0.0, 1.0)], ends: vec![0, 1], closed: false };
    let found = bent.view().measures(MeasureSelection::ALL, &job()).unwrap();
    assert!(found.moments.is_none() && found.bounds.is_some());
    assert!(found.centre.unwrap().distance(v(0.5, 0.0, 0.5)) < 1e-15);
    let empty = Given { points: vec![], ends: vec![0], closed: false };
    let found = empty.view().measures(MeasureSelection::ALL, &job()).unwrap();
    assert_eq!(found, Measures { length: Some(0.0), area_vector: Some(glam::DVec3::ZERO), ..Measures::default() });
    assert_eq!(found.area(), 0.0);
}

#[test]
fn limits_of_degrees_are_refused() {
    let line = Given::one(&[v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0)]);
    for (limits, option) in [([0, 3], "degree"), ([1, 65], "degree"), ([3, 2], "lowest")] {
        let error = line.view().with_degrees(limits, 0.0, &job()).unwrap_err();
        assert!(matches!(error, Error::OptionOutOfRange { option: found, .. } if found == option), "{error}");
    }
}

#[test]
fn curves_meet_exactly_in_the_plane_and_within_a_distance_in_space() {
    let arch = Given::one(&[v(-1.0, 0.0, 0.0), v(0.0, 2.0, 0.0), v(1.0, 0.0, 0.0)]);
    let across = |z: f64| Given::one(&[v(-1.0, 0.5, z), v(1.0, 0.5, z)]);
    let (low, high) = (across(0.0), across(0.1));
    let meet = |other: Option<&Given>, within| {
        let other = other.map(Given::view);
        arch.view().intersections_or_near_misses(other.as_ref(), within, &job())
    };
    let exact = arch.view().intersections(&low.view(), &job()).unwrap();
    let found = meet(Some(&low), 0.0).unwrap();
    assert_eq!(found.places.len(), 2);
    for (place, point) in found.places.iter().zip(&exact.points) {
        assert_eq!((place.a, place.b, place.distance), (point.a, point.b, 0.0));
    }
    assert_eq!(meet(Some(&high), 0.0).unwrap().places.len(), 0);
    assert_eq!(meet(Some(&high), 0.2).unwrap(), arch.view().near_misses(&high.view(), 0.2, &job()).unwrap());
    assert_eq!(meet(None, 0.0).unwrap().places.len(), 0);
    for (other, within) in [(None, 0.1), (Some(&low), -0.1), (Some(&low), f64::NAN), (Some(&high), f64::INFINITY)] {
        assert!(matches!(meet(other, within), Err(Error::OptionOutOfRange { option: "within", .. })), "{within}");
    }
    assert!(matches!(high.view().intersections_or_near_misses(None, 0.0, &job()), Err(Error::CurveNotPlane { .. })));
}
