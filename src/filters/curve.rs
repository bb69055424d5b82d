//! What filters of curves have in common: the Bézier curves that polylines stand for, and the plane
//! that they lie in.

use super::data::{Curves, Input};
use super::extent::{extent_of, plane_of, put};
use super::param::{Choice, PLACES, Param, ParamKind, Values};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::ops::Spacing;
use crate::outline::{Curve, CurveView, Mode, Options, Outlines, Points, fit};
use glam::DVec3;

pub(super) const CATEGORY: &str = "Curves";
pub(super) const REFERENCE: &str = "T. Nadopta, Theoretical foundations of the identification of outline curves, 2008";

/// What a polyline stands for.
pub(super) const BETWEEN: Param = Param::choice(
    "between",
    "Between the points",
    "What the curves are, of which the points are given.",
    &[
        Choice { label: "Straight", help: "The polylines themselves." },
        Choice { label: "Smooth", help: "Quadratic segments that meet smoothly, one for each point." },
        Choice { label: "Cubic spline", help: "Cubic segments with continuous curvature." },
    ],
);

/// How fine curves that come out are.
pub(super) const CHORD: Param = Param::relative(
    "chord_error",
    "Chord error",
    "How far the polylines that come out may be from the curves, relative to the diagonal of the box of all curves.",
);

/// The plane that curves are in.
pub(super) const PLANE: Param = Param::new(
    "plane",
    "Plane",
    "The plane that the curves lie in, within a millionth of their size; suggested is the one that they enclose most area in.",
    ParamKind::Plane,
    PLACES,
    &[0.0, 0.0, 1.0, 0.0],
);

/// Suggests [`PLANE`].
pub(super) fn suggest_plane(params: &[Param], inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(Input::Curves(curves)) = inputs.first()
        && let Some(plane) = plane_of(curves)
    {
        put(params, values, PLANE.id, &plane);
    }
}

/// The curve that a polyline stands for: one without segments if there are fewer than two different
/// points.
///
/// # Errors
/// Those of [`fit`].
pub(super) fn curve(points: &[[f64; 3]], closed: bool, between: usize, job: &Job<'_>) -> Result<Curve> {
    if between > 0 && !points.is_empty() {
        let options = Options { mode: [Mode::Composite, Mode::CubicC2][between - 1], ..Options::default() };
        let outlines = Outlines { points: Points::from(points), offsets: None, closed, constraints: &[] };
        return fit(&outlines, &options, job)?.curve(0).to_owned();
    }
    let mut controls: Vec<DVec3> = alloc::with_capacity(points.len() + 1)?;
    let again = points.first().filter(|_| closed);
    for point in points.iter().chain(again).map(|&point| DVec3::from(point)) {
        if controls.last() != Some(&point) {
            controls.push(point);
        }
    }
    let ends = alloc::collect((0..controls.len().max(1)).map(|k| k as u32))?;
    CurveView::new(&controls, &ends, closed)?.to_owned()
}

/// The curves that all polylines stand for.
///
/// # Errors
/// Those of [`Curves::each`] and [`fit`].
pub(super) fn curves(given: &Curves, values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Curve>> {
    laid(given, values, job, |_, points| alloc::copied(points))
}

/// The curves of polylines that were laid somewhere else first.
fn laid(
    given: &Curves,
    values: &Values<'_>,
    job: &Job<'_>,
    lay: impl Fn(usize, &[[f64; 3]]) -> Result<Vec<[f64; 3]>>,
) -> Result<Vec<Curve>> {
    let (each, between) = (given.each()?, values.chosen(BETWEEN.id));
    let mut curves = alloc::with_capacity(each.len())?;
    let mut first = 0;
    for (c, (points, closed)) in each.iter().enumerate() {
        let part = job.share(c, each.len());
        part.step(0.0, "curves")?;
        curves.push(curve(&lay(first, points)?, *closed, between, &part)?);
        first += points.len();
    }
    Ok(curves)
}

/// The length that chords are held to.
pub(super) fn chord(given: &Curves, values: &Values<'_>) -> f64 {
    let size = extent_of(&[Input::Curves(given)]).map_or(0.0, |extent| extent.diagonal());
    (values.number(CHORD.id) * size).max(f64::MIN_POSITIVE)
}

/// A curve as points of a polyline; one without segments is its point.
///
/// # Errors
/// Those of [`CurveView::sampled`].
pub(super) fn sampled(curve: &CurveView<'_>, spacing: Spacing, job: &Job<'_>) -> Result<Vec<DVec3>> {
    job.step(0.0, "points along a curve")?;
    if curve.is_empty() { alloc::copied(curve.points()) } else { Ok(curve.sampled(spacing, job)?.points) }
}

/// A plane with axes of its own: those of space for the plane z = 0.
pub(super) struct Flat {
    origin: DVec3,
    axes: [DVec3; 3],
}

impl Flat {
    /// The plane that is given as a parameter.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub(super) fn new(values: &Values<'_>) -> Result<Self> {
        let (normal, distance) = values.plane(PLANE.id)?;
        let (u, v) = normal.any_orthonormal_pair();
        // Right-handed, so that counter-clockwise is the same in the plane as seen against its
        // normal.
        let v = if u.cross(v).dot(normal) < 0.0 { -v } else { v };
        Ok(Flat { origin: normal * distance, axes: [u, v, normal] })
    }

    /// All curves in coordinates of the plane, z being 0.
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`] with a place among all points, and those of [`curves`].
    pub(super) fn curves(&self, given: &Curves, values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Curve>> {
        let largest = given.points.iter().flatten().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let size = extent_of(&[Input::Curves(given)]).map_or(0.0, |extent| extent.diagonal());
        let play = 1e-6 * size + 64.0 * f64::EPSILON * largest;
        laid(given, values, job, |first, points| {
            let mut flat = alloc::with_capacity(points.len())?;
            for (k, &point) in points.iter().enumerate() {
                let [x, y, z] = self.axes.map(|axis| axis.dot(DVec3::from(point) - self.origin));
                if z.abs() > play {
                    return Err(Error::CurveNotPlane { point: (first + k) as u32 });
                }
                flat.push([x, y, 0.0]);
            }
            Ok(flat)
        })
    }

    /// A point of the plane in space.
    pub(super) fn point(&self, point: DVec3) -> DVec3 {
        self.origin + point.x * self.axes[0] + point.y * self.axes[1]
    }
}
