//! New sections of a frame by planes, and the girth, area and centre of sections.

use crate::curve::{CurveView, Place};
use crate::identify::{Fit, Options, Outlines, Points, fit};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// A section of a frame by a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// The curve through the points where the plane crosses the curves along.
    pub curve: Fit,
    /// Where on each of them that is.
    pub places: Vec<Place>,
    /// Curves along that the plane crosses more than once; the first crossing was taken.
    pub ambiguous: Vec<u32>,
}

/// Cuts the curves along a body by the plane through `point` across `normal`, and draws a curve
/// through the crossings in the order of the columns, `closed` or not. O(segments) for crossings.
///
/// # Errors
/// [`Error::OptionOutOfRange`] (the normal), [`Error::NotFinite`] (point 0 is `point`, 1 is
/// `normal`), [`Error::NoNode`] (section 0, and the curve that the plane does not cross), those of
/// [`fit`](crate::fit()).
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
        let crossings = curve.intersect_plane(point, normal, &job.part(0.0, 0.5).share(i, along.len()))?;
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
    Ok(Slice { curve: fit(&outline, options, &job.part(0.5, 1.0))?, places, ambiguous })
}

/// The measures of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// Its length: of a closed section all round.
    pub girth: f64,
    /// The area within, seen from where it is largest; that of an open section is closed by its
    /// chord.
    pub area: f64,
    /// The mean of its points by arc length.
    pub centre: DVec3,
}

impl Measure {
    /// Measures a curve. The centre is that of 16 points of each segment at equal steps of the
    /// parameter, weighted by length.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn of(curve: CurveView<'_>) -> Result<Self> {
        let job = Job::default();
        let girth = curve.lengths(&job)?.total();
        let mut weighted = DVec3::ZERO;
        let mut weight = 0.0;
        let start = curve.points().first().copied().unwrap_or(DVec3::ZERO);
        let unit = common_unit(curve.points());
        for k in 0..curve.len() {
            let mut before = DVec3::ZERO;
            for i in 0..=CHORDS_PER_SEGMENT {
                let p = curve.point(Place { segment: k as u32, t: f64::from(i) / f64::from(CHORDS_PER_SEGMENT) })?
                    / unit
                    - start / unit;
                if i > 0 {
                    let length = before.distance(p);
                    weighted += before.midpoint(p) * length;
                    weight += length;
                }
                before = p;
            }
        }
        let centre = if weight > 0.0 { start + weighted / weight * unit } else { start };
        Ok(Measure { girth, area: curve.area_vector(&job)?.length(), centre })
    }
}

/// The chords of a segment by which its centre is measured.
const CHORDS_PER_SEGMENT: u32 = 16;
