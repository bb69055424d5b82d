//! Points along a curve: so many, so far apart, or so that the polygon through them is near enough.

use super::super::curve::{CurveView, MAX_DEGREE, Place};
use super::super::request::MAX_POINTS;
use super::super::segment;
use super::frame::Frame;
use super::split::{Room, split_segment};
use crate::alloc;
use crate::error::{Error, Result};
use glam::DVec3;

/// Points along a curve, in its order. Of a closed curve the start is not repeated at the end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Samples {
    /// Where they are.
    pub places: Vec<Place>,
    /// The points there.
    pub points: Vec<DVec3>,
}

impl CurveView<'_> {
    /// `count` points at equal arc lengths: an open curve from its start to its end (at least 2), a closed one from its start
    /// once round (at least 1). Lengths as exact as [`lengths`](Self::lengths). O(points + count log points).
    ///
    /// # Errors
    /// [`Error::EmptyCurve`] (no segments), [`Error::OptionOutOfRange`] (too small a count), [`Error::TooLarge`] (above
    /// [`MAX_POINTS`]), [`Error::OutOfMemory`].
    pub fn sampled_by_count(&self, count: usize) -> Result<Samples> {
        self.check_sampling("count", count as f64, if self.is_closed() { 1.0 } else { 2.0 })?;
        within_limit(count as u64)?;
        let lengths = self.lengths()?;
        let gaps = if self.is_closed() { count } else { count - 1 };
        let mut samples = Samples::with_room(count)?;
        for k in 0..count {
            samples.add(self, lengths.place_of_part(k, gaps))?;
        }
        Ok(samples)
    }

    /// Points every `step` along the curve, in the unit of the points, above 0: at 0, step, 2 step and so on; the end of an
    /// open curve is always the last point, however near the one before, and of a closed one never.
    ///
    /// # Errors
    /// As for [`sampled_by_count`](Self::sampled_by_count).
    pub fn sampled_by_step(&self, step: f64) -> Result<Samples> {
        self.check_sampling("step", step, f64::MIN_POSITIVE)?;
        let lengths = self.lengths()?;
        let total = lengths.total();
        let whole = (total / step).floor();
        within_limit(if whole < MAX_POINTS as f64 { whole as u64 } else { u64::MAX })?;
        let mut samples = Samples::with_room(whole as usize + 2)?;
        for k in 0..=whole as usize {
            let at = k as f64 * step;
            // The last step may end at the end but for rounding.
            if k == 0 || total - at > 1e-12 * total {
                samples.add(self, lengths.place(at)?)?;
            }
        }
        if !self.is_closed() {
            samples.add(self, Place { segment: self.len() as u32 - 1, t: 1.0 })?;
        }
        Ok(samples)
    }

    /// Points such that no point of the curve is farther than `tolerance` (above 0, in the unit of the points) from the chord
    /// between its neighbours: segments are halved until their control points prove it, at most 20 times, which leaves 1e-12
    /// of a segment's size.
    ///
    /// # Errors
    /// As for [`sampled_by_count`](Self::sampled_by_count). O(points found).
    pub fn sampled_by_chord(&self, tolerance: f64) -> Result<Samples> {
        self.check_sampling("tolerance", tolerance, f64::MIN_POSITIVE)?;
        let frame = Frame::of(self.points());
        let mut samples = Samples::default();
        samples.add(self, Place { segment: 0, t: 0.0 })?;
        for (k, controls) in self.segments().enumerate() {
            let mut local: Room = [DVec3::ZERO; MAX_DEGREE + 1];
            for (to, &p) in local.iter_mut().zip(controls) {
                *to = frame.point(p);
            }
            let flat = Flatten { curve: self, segment: k as u32, tolerance: frame.length(tolerance) };
            flat.halve(&mut local[..controls.len()], 0.0, 1.0, 20, &mut samples)?;
        }
        if self.is_closed() && samples.places.len() > 1 {
            samples.places.pop();
            samples.points.pop();
        }
        Ok(samples)
    }

    fn check_sampling(&self, option: &'static str, value: f64, least: f64) -> Result<()> {
        if value.is_nan() || value < least {
            return Err(Error::OptionOutOfRange { option, value });
        }
        if self.is_empty() { Err(Error::EmptyCurve) } else { Ok(()) }
    }
}

fn within_limit(count: u64) -> Result<()> {
    let limit = MAX_POINTS as u64;
    if count > limit { Err(Error::TooLarge { what: "points", count, limit }) } else { Ok(()) }
}

impl Samples {
    fn with_room(count: usize) -> Result<Self> {
        Ok(Samples { places: alloc::with_capacity(count)?, points: alloc::with_capacity(count)? })
    }

    fn add(&mut self, curve: &CurveView<'_>, place: Place) -> Result<()> {
        within_limit(self.places.len() as u64 + 1)?;
        alloc::push(&mut self.places, place)?;
        alloc::push(&mut self.points, segment::point(curve.segment(place.segment as usize), place.t))
    }
}

struct Flatten<'a> {
    curve: &'a CurveView<'a>,
    segment: u32,
    tolerance: f64,
}

impl Flatten<'_> {
    /// Adds the ends of the chords of one part, but not its start.
    ///
    /// The distance d from the chord is convex and 0 at its ends, so d(C(t)) <= sum of b_i(t) d(B_i) over the inner control
    /// points, whose weights have the sum 1 - (1 - t)^n - t^n <= 1 - 2^(1 - n).
    fn halve(&self, controls: &mut [DVec3], from: f64, to: f64, left: u32, samples: &mut Samples) -> Result<()> {
        let n = controls.len() - 1;
        let most = controls[1..n].iter().map(|&p| off_chord(p, controls[0], controls[n])).fold(0.0, f64::max);
        if left == 0 || most * (1.0 - libm::ldexp(2.0, -(n as i32))) <= self.tolerance {
            return samples.add(self.curve, Place { segment: self.segment, t: to });
        }
        let mut before = [DVec3::ZERO; MAX_DEGREE + 1];
        split_segment(controls, 0.5, &mut before[..=n]);
        let middle = 0.5 * (from + to);
        self.halve(&mut before[..=n], from, middle, left - 1, samples)?;
        self.halve(controls, middle, to, left - 1, samples)
    }
}

/// The distance of p from the chord from a to b.
fn off_chord(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let chord = b - a;
    let squared = chord.length_squared();
    let t = if squared > 0.0 { ((p - a).dot(chord) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + chord * t)).length()
}
