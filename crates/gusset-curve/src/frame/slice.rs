//! New sections of a frame by planes, and the girth, area and centre of sections.

use crate::curve::{CurveView, Place};
use crate::identify::{Fit, Options, Outlines, Points, fit};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// A section of a frame by a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// The curve through the points where the plane crosses the curves along.
    pub curve: Fit,
    /// The place of the crossing on each of the curves along.
    pub places: Vec<Place>,
    /// Curves along that the plane crosses more than once. The slice uses the first crossing.
    pub ambiguous: Vec<u32>,
}

/// Cuts the curves along a body by the plane through `point` perpendicular to `normal`. Fits a
/// curve through the crossings in the order of the columns, closed if `closed`. O(segments) for the
/// crossings.
///
/// # Errors
/// [`Error::OptionOutOfRange`] (the normal), [`Error::NotFinite`] (point 0 is `point`, point 1 is
/// `normal`), [`Error::NoNode`] (section 0, and the curve that the plane does not cross), and the
/// errors of [`fit`](crate::fit()).
pub fn slice(
    along: &Fit,
    point: DVec3,
    normal: DVec3,
    closed: bool,
    options: &Options,
    job: &Job<'_>,
) -> Result<Slice> {
    let mut points = alloc::with_capacity(along.len())?;
    let mut places = alloc::with_capacity(along.len())?;
    let mut ambiguous = Vec::new();
    for i in 0..along.len() {
        let curve = along.curve(i);
        let crossings = curve.intersect_plane(point, normal, &job.sub_job(0.0, 0.5).sub_job_of_item(i, along.len()))?;
        let inside = crossings.inside.first().map(|&segment| Place { segment, t: 0.0 });
        let Some(place) = crossings.places.first().copied().or(inside) else {
            return Err(Error::NoNode { section: 0, column: i as u32 });
        };
        if crossings.places.len() > 1 || !crossings.inside.is_empty() {
            alloc::push(&mut ambiguous, i as u32)?;
        }
        points.push(curve.point(place)?.to_array());
        places.push(place);
    }
    let outline = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
    Ok(Slice { curve: fit(&outline, options, &job.sub_job(0.5, 1.0))?, places, ambiguous })
}

/// The measures of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// The length; for a closed section, of the whole contour.
    pub girth: f64,
    /// The length of the area vector: the largest area of the section's projection onto a plane.
    /// The chord from end to start closes an open section.
    pub area: f64,
    /// The mean of the section's points by arc length.
    pub centre: DVec3,
}

impl Measure {
    /// Measures a curve; see [`CurveView::centre`] for the centre.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn from_curve(curve: CurveView<'_>) -> Result<Self> {
        let job = Job::default();
        let girth = curve.arc_lengths(&job)?.total_length();
        Ok(Measure { girth, area: curve.area_vector(&job)?.length(), centre: curve.centre(&job)? })
    }
}
