//! Parts of a curve, and the curve backwards.

use super::super::curve::{Curve, CurveView, MAX_DEGREE, Place};
use super::super::segment;
use super::append;
use crate::alloc;
use crate::error::{Error, Result};
use glam::DVec3;

/// The control points of one segment of any degree.
pub(super) type Controls = [DVec3; MAX_DEGREE + 1];

/// Splits a segment by de Casteljau's scheme: `right` holds the segment and keeps the part after `t`, `left` receives the one
/// before.
pub(super) fn split_segment(right: &mut [DVec3], t: f64, left: &mut [DVec3]) {
    let n = right.len() - 1;
    let s = 1.0 - t;
    for (k, first) in left.iter_mut().enumerate().take(n + 1) {
        *first = right[0];
        for i in 0..n - k {
            right[i] = right[i] * s + right[i + 1] * t;
        }
    }
}

/// The control points of a segment between two parameters, `from < to`; ends that are ends of the segment stay as they are.
pub(super) fn part(controls: &[DVec3], from: f64, to: f64) -> Controls {
    let n = controls.len();
    let (mut work, mut other) = ([DVec3::ZERO; MAX_DEGREE + 1], [DVec3::ZERO; MAX_DEGREE + 1]);
    work[..n].copy_from_slice(controls);
    let mut end = to;
    if from > 0.0 {
        split_segment(&mut work[..n], from, &mut other[..n]);
        end = (to - from) / (1.0 - from);
    }
    if to < 1.0 {
        split_segment(&mut work[..n], end, &mut other[..n]);
        return other;
    }
    work
}

impl CurveView<'_> {
    /// The parts before and after a place. Both are open; a part without extent has one control point and no segments.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OutOfMemory`]. O(points).
    pub fn split(&self, at: Place) -> Result<[Curve; 2]> {
        self.check_place(0, at)?;
        let last = Place { segment: self.len() as u32 - 1, t: 1.0 };
        Ok([self.between(Place { segment: 0, t: 0.0 }, at)?, self.between(at, last)?])
    }

    /// The part from one place to another, open. On a closed curve it may run over the start, and from a place to itself it
    /// goes round once; on an open one that is a single point.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OptionOutOfRange`] (an open curve, and `to` before `from`), [`Error::TooLarge`],
    /// [`Error::OutOfMemory`]. O(points).
    pub fn sub_curve(&self, from: Place, to: Place) -> Result<Curve> {
        self.check_place(0, from)?;
        self.check_place(1, to)?;
        let order = from.segment.cmp(&to.segment).then(from.t.total_cmp(&to.t));
        if order.is_lt() || (order.is_eq() && !self.is_closed()) {
            return self.between(from, to);
        }
        if !self.is_closed() {
            return Err(Error::OptionOutOfRange { option: "to", value: to.t });
        }
        let last = Place { segment: self.len() as u32 - 1, t: 1.0 };
        let mut curve = self.between(from, last)?;
        let rest = self.between(Place { segment: 0, t: 0.0 }, to)?;
        for segment in rest.view().segments() {
            append(&mut curve, &segment[1..])?;
        }
        Ok(curve)
    }

    /// The part from one place to a later one.
    fn between(&self, from: Place, to: Place) -> Result<Curve> {
        let mut curve: Option<Curve> = None;
        for k in from.segment..=to.segment {
            let a = if k == from.segment { from.t } else { 0.0 };
            let b = if k == to.segment { to.t } else { 1.0 };
            if a >= b {
                continue;
            }
            let controls = self.segment(k as usize);
            let buffer = part(controls, a, b);
            let piece = &buffer[..controls.len()];
            match &mut curve {
                Some(curve) => append(curve, &piece[1..])?,
                None => append(curve.insert(Curve::from_point(piece[0])?), &piece[1..])?,
            }
        }
        match curve {
            Some(curve) => Ok(curve),
            None => Curve::from_point(segment::point(self.segment(from.segment as usize), from.t)),
        }
    }

    /// The same curve run through from its end to its start. O(points).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn reversed(&self) -> Result<Curve> {
        let mut points = alloc::copied(self.points())?;
        points.reverse();
        let last = self.ends().last().copied().unwrap_or(0);
        let ends = alloc::collect(self.ends().iter().rev().map(|&end| last - end))?;
        Ok(Curve { points, ends, closed: self.is_closed() })
    }
}
