//! Points along a curve, by their number, by their spacing, or by the deviation of the polygon
//! through them.

use super::length::ArcLengths;
use crate::curve::segment::{self, SegmentBuffer};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place};
use crate::identify::MAX_POINTS;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;

const POINTS_PER_REPORT: usize = 1 << 8;
const PROGRESS_STAGE: &str = "points along a curve";

/// The spacing of points along a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampleSpacing {
    /// A number of points at equal arc lengths. An open curve gets at least 2, from start to end; a
    /// closed one at least 1, once around from its start. Lengths are as exact as
    /// [`arc_lengths`](CurveView::arc_lengths). O(points + count log points).
    Count(usize),
    /// Points at equal arc lengths, in the unit of the points, above 0: at 0, step, 2 step and so
    /// on. The end of an open curve is always the last point, even if it is close to the previous
    /// one. The end of a closed curve is never added.
    Step(f64),
    /// Points whose polygon deviates from the curve by at most this distance, above 0, in the unit
    /// of the points. Segments are halved until their control points prove it. The limit of 20
    /// halvings leaves 1e-12 of a segment's size. O(points found).
    Chord(f64),
}

/// Points along a curve, in order. The start of a closed curve is not repeated at the end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SampledPoints {
    /// The places of the points.
    pub places: Vec<Place>,
    /// The points.
    pub points: Vec<DVec3>,
}

impl CurveView<'_> {
    /// Samples points along the curve.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`] (the curve lacks segments), [`Error::OptionOutOfRange`] (a count, step
    /// or tolerance that is too small), [`Error::TooLarge`] (above [`MAX_POINTS`]),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn sample_points(&self, spacing: SampleSpacing, job: &Job<'_>) -> Result<SampledPoints> {
        let least_count = if self.is_closed() { 1.0 } else { 2.0 };
        let (option, value, least, allowed) = match spacing {
            SampleSpacing::Count(count) => ("count", count as f64, least_count, Allowed::AtLeast(least_count)),
            SampleSpacing::Step(step) => ("step", step, f64::MIN_POSITIVE, "finite and above 0".into()),
            SampleSpacing::Chord(tolerance) => ("tolerance", tolerance, f64::MIN_POSITIVE, "above 0".into()),
        };
        let is_bounded = value.is_finite() || !matches!(spacing, SampleSpacing::Step(_));
        Error::require(value >= least && is_bounded, option, value, allowed)?;
        if self.is_empty() {
            return Err(Error::EmptyCurve);
        }
        let (first, second) = (job.sub_job(0.0, 0.3), job.sub_job(0.3, 1.0));
        match spacing {
            SampleSpacing::Count(count) => {
                check_point_count(count as u64)?;
                PointCollector::new(self, count, &second)?.collect_by_count(count, &self.arc_lengths(&first)?)
            }
            SampleSpacing::Step(step) => {
                let lengths = self.arc_lengths(&first)?;
                let whole = (lengths.total_length() / step).floor();
                check_point_count(if whole < MAX_POINTS as f64 { whole as u64 } else { u64::MAX })?;
                PointCollector::new(self, whole as usize + 2, &second)?.collect_by_step(step, whole as usize, &lengths)
            }
            SampleSpacing::Chord(tolerance) => PointCollector::new(self, 0, job)?.collect_by_chord(tolerance),
        }
    }
}

fn check_point_count(count: u64) -> Result<()> {
    Error::check_count("points", count, MAX_POINTS as u64)
}

/// The points collected so far along a curve.
struct PointCollector<'a> {
    curve: &'a CurveView<'a>,
    samples: SampledPoints,
    job: &'a Job<'a>,
}

impl<'a> PointCollector<'a> {
    fn new(curve: &'a CurveView<'a>, count: usize, job: &'a Job<'a>) -> Result<Self> {
        let samples = SampledPoints { places: alloc::with_capacity(count)?, points: alloc::with_capacity(count)? };
        Ok(PointCollector { curve, samples, job })
    }

    fn add_place(&mut self, place: Place) -> Result<()> {
        let count = self.samples.places.len();
        if count.is_multiple_of(POINTS_PER_REPORT) {
            self.job.step(place.global_parameter() / self.curve.len() as f64, PROGRESS_STAGE)?;
        }
        check_point_count(count as u64 + 1)?;
        alloc::push(&mut self.samples.places, place)?;
        let point = segment::point_at(self.curve.segment(place.segment as usize), place.t);
        alloc::push(&mut self.samples.points, point)
    }

    fn collect_by_count(mut self, count: usize, lengths: &ArcLengths<'_>) -> Result<SampledPoints> {
        let gaps = if self.curve.is_closed() { count } else { count - 1 };
        (0..count).try_for_each(|k| self.add_place(lengths.place_at_fraction(k, gaps)))?;
        Ok(self.samples)
    }

    fn collect_by_step(mut self, step: f64, whole: usize, lengths: &ArcLengths<'_>) -> Result<SampledPoints> {
        let total = lengths.total_length();
        for k in 0..=whole {
            let at = k as f64 * step;
            // The last step may coincide with the end, up to rounding.
            if k == 0 || total - at > 1e-12 * total {
                self.add_place(lengths.place_at_length(at)?)?;
            }
        }
        if !self.curve.is_closed() {
            self.add_place(self.curve.end_place())?;
        }
        Ok(self.samples)
    }

    fn collect_by_chord(mut self, tolerance: f64) -> Result<SampledPoints> {
        let frame = UnitFrame::from_points(self.curve.points());
        self.add_place(Place::START)?;
        for (k, controls) in self.curve.segments().enumerate() {
            self.add_chord_ends(
                k as u32,
                frame.segment_to_frame(controls),
                [0.0, 1.0],
                frame.length_to_frame(tolerance),
                20,
            )?;
        }
        if self.curve.is_closed() && self.samples.places.len() > 1 {
            self.samples.places.pop();
            self.samples.points.pop();
        }
        Ok(self.samples)
    }

    /// Adds the ends of the chords of one part of a segment, without its start.
    ///
    /// The distance d from the chord is convex and 0 at its ends, so d(C(t)) <= sum of b_i(t)
    /// d(B_i) over the inner control points. Their weights add up to 1 - (1 - t)^n - t^n <= 1 -
    /// 2^(1 - n).
    fn add_chord_ends(
        &mut self,
        segment: u32,
        mut controls: SegmentBuffer,
        [from, to]: [f64; 2],
        tolerance: f64,
        halvings: u32,
    ) -> Result<()> {
        let n = controls.len() - 1;
        let most = controls[1..n].iter().map(|&p| distance_from_chord(p, controls[0], controls[n])).fold(0.0, f64::max);
        if halvings == 0 || most * (1.0 - libm::ldexp(2.0, -(n as i32))) <= tolerance {
            return self.add_place(Place { segment, t: to });
        }
        let before = controls.split_off_part_before(0.5);
        let middle = 0.5 * (from + to);
        self.add_chord_ends(segment, before, [from, middle], tolerance, halvings - 1)?;
        self.add_chord_ends(segment, controls, [middle, to], tolerance, halvings - 1)
    }
}

/// Returns the distance of p from the chord from a to b.
fn distance_from_chord(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let chord = b - a;
    let squared = chord.length_squared();
    let t = if squared > 0.0 { ((p - a).dot(chord) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + chord * t)).length()
}
