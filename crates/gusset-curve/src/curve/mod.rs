//! Piecewise Bézier curves: the data type of the whole crate.
//!
//! - here: [`CurveView`], borrowed control points, and [`Curve`], owned ones. Consecutive segments
//!   may have different degrees.
//! - segment: one segment by its control points.
//! - unit_frame: coordinates in which a curve is near the origin and has a size of about 1.

pub(crate) mod segment;
pub(crate) mod unit_frame;

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Element, Error, Result};
use gusset_base::job::Job;

pub use segment::MAX_DEGREE;

/// A borrowed curve. Segment k has the control points `ends[k]..=ends[k + 1]`, so it starts with
/// the last control point of the previous segment. A plane curve has z = 0 everywhere.
#[derive(Debug, Clone, Copy)]
pub struct CurveView<'a> {
    points: &'a [DVec3],
    ends: &'a [u32],
    closed: bool,
}

/// Checks that a point is finite; `point_index` is its index, for the error.
pub(crate) fn check_finite(point_index: usize, p: DVec3) -> Result<()> {
    Error::check_finite(Element::Point, point_index as u64, p)
}

/// A place on a curve: a segment and a parameter from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The segment's index, from 0.
    pub segment: u32,
    /// The parameter: 0 at the segment's first control point, 1 at its last.
    pub t: f64,
}

impl Place {
    pub(super) const START: Place = Place { segment: 0, t: 0.0 };

    /// Returns the place as one number: the segment plus the parameter.
    pub(super) fn global_parameter(self) -> f64 {
        f64::from(self.segment) + self.t
    }
}

impl<'a> CurveView<'a> {
    /// `ends` holds 0, then the index of the last control point of each segment, ending with
    /// `points.len() - 1`. If `closed`, the last control point must equal the first.
    ///
    /// # Errors
    /// [`Error::BadOffsets`] (`ends` does not start at 0, does not increase, or ends elsewhere),
    /// [`Error::OptionOutOfRange`] (a degree above [`MAX_DEGREE`]), [`Error::NotFinite`],
    /// [`Error::CurveNotClosed`].
    pub fn new(points: &'a [DVec3], ends: &'a [u32], closed: bool) -> Result<Self> {
        let bad =
            |entry: usize| Error::BadOffsets { entry: entry as u32, value: ends.get(entry).copied().unwrap_or(0) };
        if ends.first() != Some(&0) {
            return Err(bad(0));
        }
        for k in 1..ends.len() {
            if ends[k] <= ends[k - 1] || ends[k] as usize >= points.len() {
                return Err(bad(k));
            }
            let degree = (ends[k] - ends[k - 1]) as usize;
            Error::require(degree <= MAX_DEGREE, "degree", degree as f64, Allowed::AtMost(MAX_DEGREE as f64))?;
        }
        if ends.len() > 1 && ends[ends.len() - 1] as usize != points.len() - 1 {
            return Err(bad(ends.len() - 1));
        }
        points.iter().enumerate().try_for_each(|(point, &p)| check_finite(point, p))?;
        if closed && points.first() != points.last() {
            return Err(Error::CurveNotClosed);
        }
        Ok(CurveView { points, ends, closed })
    }

    /// Creates a curve without checking its points and ends.
    pub(super) fn new_unchecked(points: &'a [DVec3], ends: &'a [u32], closed: bool) -> Self {
        CurveView { points, ends, closed }
    }

    /// Returns all control points. A closed curve repeats its first one at the end.
    pub fn points(&self) -> &'a [DVec3] {
        self.points
    }

    /// Returns the offsets of the segments; see [`CurveView::new`].
    pub fn ends(&self) -> &'a [u32] {
        self.ends
    }

    /// Returns true if the curve is closed.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Returns the number of segments; 0 for the curve of an outline without extent.
    pub fn len(&self) -> usize {
        self.ends.len().saturating_sub(1)
    }

    /// Returns true if the curve lacks segments.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the control points of segment `k`: one more than its degree.
    ///
    /// # Panics
    /// If segment `k` does not exist.
    pub fn segment(&self, k: usize) -> &'a [DVec3] {
        &self.points[self.ends[k] as usize..=self.ends[k + 1] as usize]
    }

    /// Returns the control points of each segment.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = &'a [DVec3]> + Clone + use<'a> {
        let points = self.points;
        self.ends.windows(2).map(move |pair| &points[pair[0] as usize..=pair[1] as usize])
    }

    /// Checks that a place lies on the curve; `place_index` is its index, for the error.
    pub(super) fn check_place(&self, place_index: usize, place: Place) -> Result<()> {
        if (place.segment as usize) < self.len() && (0.0..=1.0).contains(&place.t) {
            return Ok(());
        }
        Err(Error::NoSuchPlace { index: place_index as u32, segment: place.segment, t: place.t })
    }

    /// Returns the end of the last segment.
    pub(super) fn end_place(&self) -> Place {
        Place { segment: self.len() as u32 - 1, t: 1.0 }
    }

    pub(super) fn check_not_empty(&self) -> Result<()> {
        if self.points.is_empty() { Err(Error::EmptyCurve) } else { Ok(()) }
    }

    /// Checks that the curve lies in the plane z = 0.
    pub(super) fn check_in_xy_plane(&self) -> Result<()> {
        let outside = self.points.iter().position(|p| p.z != 0.0);
        outside.map_or(Ok(()), |k| Err(Error::CurveNotPlane { point: k as u32, z: self.points[k].z }))
    }

    /// Returns the number of segments after which a closed curve repeats; infinite for an open one.
    pub(super) fn segment_count_if_closed(&self) -> f64 {
        if self.closed { self.len() as f64 } else { f64::INFINITY }
    }

    /// [`to_owned`](Self::to_owned) for long curves.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn to_owned_cancellable(&self, job: &Job<'_>) -> Result<Curve> {
        let stage = "copying a curve";
        let points = alloc::collect_cancellable(self.points.iter().copied(), &job.sub_job(0.0, 0.8), stage)?;
        let ends = alloc::collect_cancellable(self.ends.iter().copied(), &job.sub_job(0.8, 1.0), stage)?;
        Ok(Curve { points, ends, closed: self.closed })
    }

    /// Copies the curve with its points.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn to_owned(&self) -> Result<Curve> {
        Ok(Curve { points: alloc::copied(self.points)?, ends: alloc::copied(self.ends)?, closed: self.closed })
    }
}

/// A curve that owns its control points; see [`CurveView`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    pub(super) points: Vec<DVec3>,
    pub(super) ends: Vec<u32>,
    pub(super) closed: bool,
}

impl Curve {
    /// Creates a curve without segments, at a point.
    pub(super) fn from_point(start: DVec3) -> Result<Self> {
        let mut curve = Curve::default();
        alloc::push(&mut curve.points, start)?;
        alloc::push(&mut curve.ends, 0)?;
        Ok(curve)
    }

    /// Appends a segment. `controls_after_first` has its control points except the first, which is
    /// the current end of the curve.
    ///
    /// # Errors
    /// [`Error::TooLarge`] (more control points than 32 bits can count), [`Error::OutOfMemory`].
    pub(super) fn push_segment(&mut self, controls_after_first: &[DVec3]) -> Result<()> {
        Error::check_count("control points", (self.points.len() + controls_after_first.len()) as u64, u32::MAX.into())?;
        alloc::append(&mut self.points, controls_after_first)?;
        alloc::push(&mut self.ends, (self.points.len() - 1) as u32)
    }

    /// Borrows the curve.
    pub fn view(&self) -> CurveView<'_> {
        CurveView::new_unchecked(&self.points, &self.ends, self.closed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invalid_curves_are_rejected() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::Y];
        assert_eq!(CurveView::new(&points, &[0, 2], false).unwrap().segment(0), points);
        assert_eq!(CurveView::new(&points, &[0, 1, 2], false).unwrap().len(), 2);
        assert!(CurveView::new(&[], &[0], true).unwrap().is_empty());
        let bad = |ends: &[u32]| matches!(CurveView::new(&points, ends, false), Err(Error::BadOffsets { .. }));
        assert!(bad(&[]) && bad(&[1, 2]) && bad(&[0, 0, 2]) && bad(&[0, 1]) && bad(&[0, 3]) && bad(&[0, 2, 1]));
        assert_eq!(CurveView::new(&points, &[0, 2], true).unwrap_err(), Error::CurveNotClosed);
        let nan = [DVec3::ZERO, DVec3::new(0.0, f64::NAN, 0.0)];
        assert!(matches!(
            CurveView::new(&nan, &[0, 1], false),
            Err(Error::NotFinite { element: Element::Point, index: 1, .. })
        ));
        let many = vec![DVec3::ZERO; 66];
        assert!(matches!(CurveView::new(&many, &[0, 65], false), Err(Error::OptionOutOfRange { .. })));
    }
}
