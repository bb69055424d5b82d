//! Common parts of filters of curves: Bézier curves that interpolate polylines, and their plane.

use super::data::{Curves, Input};
use super::extent::{best_plane_of_curves, bounding_box_of_inputs};
use super::typed_param::{Param, PlaneValue, TypedParam};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_curve::ops::SampleSpacing;
use gusset_curve::{Curve, CurveKind, CurveView, Options, Outlines, Points, fit};

pub(super) const CATEGORY: &str = "Curves";
pub(super) const REFERENCE: &str = "T. Nadopta, Theoretical foundations of the identification of outline curves, 2008";

choices! {
    /// The interpolating curve; none for the polyline itself.
    CURVES_THROUGH: Option<CurveKind> =
        None => "Straight", "The polylines themselves.";
        Some(CurveKind::Composite) => "Smooth", "Quadratic segments that meet smoothly, one for each point.";
        Some(CurveKind::CubicC2) => "Cubic spline", "Cubic segments with continuous curvature.";
}

/// Chooses the curve through the points of polylines.
pub(super) const INTERPOLATION: TypedParam<Option<CurveKind>> =
    Param::choice("Between the points", "The curves through the given points.", CURVES_THROUGH);

/// Limits the distance of chords from curves.
pub(super) const CHORD_ERROR: TypedParam<f64> = Param::relative_error(
    "Chord error",
    "The largest distance of the resulting polylines from the curves, relative to the diagonal of the box of all curves.",
);

/// Sets the plane of curves.
pub(super) const PLANE: TypedParam<PlaneValue> = Param::plane(
    "Plane",
    "The plane of the curves, up to a millionth of their size. The plane in which they enclose the largest area is suggested.",
)
.suggested(|inputs, _| match inputs.first() {
    Some(Input::Curves(curves)) => best_plane_of_curves(curves),
    _ => None,
});

/// The curve through a polyline, without segments if there are fewer than two distinct points.
///
/// # Errors
/// The errors of [`fit`].
fn fit_curve(points: &[[f64; 3]], closed: bool, curve_kind: Option<CurveKind>, job: &Job<'_>) -> Result<Curve> {
    if let Some(curve_kind) = curve_kind.filter(|_| !points.is_empty()) {
        let options = Options { curve: curve_kind, ..Options::default() };
        let outlines = Outlines { points: Points::from(points), offsets: None, closed, constraints: &[] };
        return fit(&outlines, &options, job)?.curve(0).to_owned();
    }
    let again = points.first().filter(|_| closed);
    let mut controls = alloc::gather(points.iter().chain(again).map(|&point| DVec3::from(point)))?;
    controls.dedup();
    let ends = alloc::collect((0..controls.len().max(1)).map(|k| k as u32))?;
    CurveView::new(&controls, &ends, closed)?.to_owned()
}

/// The curves through all polylines.
///
/// # Errors
/// The errors of [`Curves::polylines`] and [`fit`].
pub(super) fn fit_curves(given: &Curves, curve_kind: Option<CurveKind>, job: &Job<'_>) -> Result<Vec<Curve>> {
    fit_mapped_curves(given, curve_kind, job, |_, points| alloc::copied(points))
}

/// The curves through mapped polylines. `map` gets the index of the first point and the points.
fn fit_mapped_curves(
    given: &Curves,
    curve_kind: Option<CurveKind>,
    job: &Job<'_>,
    map_points: impl Fn(usize, &[[f64; 3]]) -> Result<Vec<[f64; 3]>>,
) -> Result<Vec<Curve>> {
    let each = given.polylines()?;
    let mut curves = alloc::with_capacity(each.len())?;
    let mut first = 0;
    for (c, (points, closed)) in each.iter().enumerate() {
        let part = job.sub_job_of_item(c, each.len());
        part.step(0.0, "curves")?;
        curves.push(fit_curve(&map_points(first, points)?, *closed, curve_kind, &part)?);
        first += points.len();
    }
    Ok(curves)
}

/// The largest distance of chords that a relative [`CHORD_ERROR`] allows.
pub(super) fn absolute_chord_error(given: &Curves, chord_error: f64) -> f64 {
    let size = bounding_box_of_inputs(&[Input::Curves(given)]).map_or(0.0, |extent| extent.diagonal());
    (chord_error * size).max(f64::MIN_POSITIVE)
}

/// The points of a polyline along a curve. A curve without segments gives its only point.
///
/// # Errors
/// The errors of [`CurveView::sample_points`].
pub(super) fn sample_curve(curve: &CurveView<'_>, spacing: SampleSpacing, job: &Job<'_>) -> Result<Vec<DVec3>> {
    job.step(0.0, "points along a curve")?;
    if curve.is_empty() { alloc::copied(curve.points()) } else { Ok(curve.sample_points(spacing, job)?.points) }
}

/// A plane with axes. The plane z = 0 has the x and y axes of space.
pub(super) struct CurvePlane {
    origin: DVec3,
    axes: [DVec3; 3],
}

impl CurvePlane {
    /// The plane of a parameter.
    pub(super) fn new(PlaneValue { normal, distance }: PlaneValue) -> Self {
        let (u, v) = normal.any_orthonormal_pair();
        // Right-handed, so that orientation in the plane agrees with the view against its normal.
        let v = if u.cross(v).dot(normal) < 0.0 { -v } else { v };
        CurvePlane { origin: normal * distance, axes: [u, v, normal] }
    }

    /// All curves in the coordinates of the plane, with z = 0.
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`] with an index among all points, and the errors of [`fit_curves`].
    pub(super) fn fit_curves_in_plane(
        &self,
        given: &Curves,
        curve_kind: Option<CurveKind>,
        job: &Job<'_>,
    ) -> Result<Vec<Curve>> {
        let largest = given.points.iter().flatten().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let size = bounding_box_of_inputs(&[Input::Curves(given)]).map_or(0.0, |extent| extent.diagonal());
        let slack = 1e-6 * size + 64.0 * f64::EPSILON * largest;
        fit_mapped_curves(given, curve_kind, job, |first, points| {
            let mut flat = alloc::with_capacity(points.len())?;
            for (k, &point) in points.iter().enumerate() {
                let [x, y, z] = self.axes.map(|axis| axis.dot(DVec3::from(point) - self.origin));
                if z.abs() > slack {
                    return Err(Error::CurveNotPlane { point: (first + k) as u32, z });
                }
                flat.push([x, y, 0.0]);
            }
            Ok(flat)
        })
    }

    /// A point of the plane in space.
    pub(super) fn to_space(&self, point: DVec3) -> DVec3 {
        self.origin + point.x * self.axes[0] + point.y * self.axes[1]
    }
}
