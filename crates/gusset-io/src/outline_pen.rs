//! Curved outlines as polylines.
//!
//! A file of outlines is read at least twice. The first time finds the extent, and whether anything is curved. The second time draws
//! curves within [`RELATIVE_TOLERANCE`] of the extent. If the points would take more memory than the file's size allows, the file is
//! read again with a larger tolerance.

use crate::document::Curves;
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::mesh::Positions;
use std::f64::consts::TAU;

/// Largest distance between a curve and its polyline, relative to the diagonal of the drawing.
const RELATIVE_TOLERANCE: f64 = 1e-5;
/// Factor by which the tolerance grows if there are too many points: a quarter of them remains.
const TOLERANCE_GROWTH: f64 = 16.0;
/// Most readings of a file with a larger tolerance.
const MAX_COARSER_READINGS: usize = 12;
/// Points that any file may have, however small it is.
const MIN_POINT_LIMIT: usize = 1 << 18;
/// Fewest bytes of a file for each point: a file of lines alone never reaches the limit.
const MIN_POINT_BYTES: usize = 2;
/// Fewest and most segments of a full turn.
const TURN_SEGMENTS: [f64; 2] = [8.0, 65_536.0];
/// Most segments of a Bezier curve.
const MAX_BEZIER_SEGMENTS: f64 = 4096.0;

pub(crate) type Vector = [f64; 3];

/// Draws outlines as polylines.
pub(crate) struct OutlinePen {
    pub(crate) tolerance: f64,
    points: Vec<Vector>,
    offsets: Vec<u32>,
    closed: Vec<bool>,
    first_point_of_outline: usize,
    point_limit: usize,
    is_full: bool,
    has_curved_parts: bool,
}

/// Reads a drawing with a pen of the tolerance that fits. `read` is called for each tolerance.
pub(crate) fn read_outlines<T>(
    file_bytes: usize,
    mut read: impl FnMut(&mut OutlinePen) -> Result<T, ReadError>,
) -> Result<(T, Curves, Vec<Note>), ReadError> {
    let mut pen = OutlinePen::new(f64::INFINITY, file_bytes);
    let mut content = read(&mut pen)?;
    let mut notes = Vec::new();
    if pen.has_curved_parts && !pen.is_full {
        let mut tolerance = RELATIVE_TOLERANCE * pen.diagonal();
        for reading in 0..=MAX_COARSER_READINGS {
            pen = OutlinePen::new(tolerance, file_bytes);
            content = read(&mut pen)?;
            if !pen.is_full {
                if reading > 0 {
                    let text =
                        format!("curves are drawn within {tolerance:.1e}, because finer ones have too many points");
                    notes.push(Note::new(Place::Whole, text));
                }
                break;
            }
            tolerance *= TOLERANCE_GROWTH;
        }
    }
    if pen.is_full {
        let message = format!("the outlines have more than {} points", pen.point_limit);
        return Err(ReadError::new(ReadErrorKind::TooLarge, message));
    }
    let curves = Curves { positions: Positions::F64(pen.points), offsets: pen.offsets, closed: pen.closed };
    Ok((content, curves, notes))
}

impl OutlinePen {
    fn new(tolerance: f64, file_bytes: usize) -> Self {
        Self {
            tolerance,
            points: Vec::new(),
            offsets: vec![0],
            closed: Vec::new(),
            first_point_of_outline: 0,
            point_limit: (file_bytes / MIN_POINT_BYTES).clamp(MIN_POINT_LIMIT, u32::MAX as usize - 1),
            is_full: false,
            has_curved_parts: false,
        }
    }

    fn diagonal(&self) -> f64 {
        let finite = || self.points.iter().filter(|point| point.iter().all(|part| part.is_finite()));
        let extent = |axis: usize| {
            let low = finite().fold(f64::INFINITY, |least, point| least.min(point[axis]));
            let high = finite().fold(f64::NEG_INFINITY, |most, point| most.max(point[axis]));
            (high - low).max(0.0)
        };
        (0..3).map(|axis| extent(axis).powi(2)).sum::<f64>().sqrt()
    }

    /// Returns whether the limit of points is reached, so that reading on is of no use.
    pub(crate) fn is_full(&self) -> bool {
        self.is_full
    }

    /// Begins an outline. The one before stays open.
    pub(crate) fn begin_outline(&mut self, point: Vector) -> Result<(), ReadError> {
        self.end_outline(false)?;
        self.line_to(point)
    }

    /// Returns the last point of the outline that is being drawn.
    pub(crate) fn last_point(&self) -> Option<Vector> {
        self.points[self.first_point_of_outline..].last().copied()
    }

    /// Adds a point, unless it equals the last one.
    pub(crate) fn line_to(&mut self, point: Vector) -> Result<(), ReadError> {
        if self.last_point() == Some(point) || self.is_full {
            return Ok(());
        }
        if self.points.len() == self.point_limit {
            self.is_full = true;
            return Ok(());
        }
        if self.points.len() == self.points.capacity() {
            // Less than doubling, for the sake of memory.
            self.points.try_reserve_exact(64.max(self.points.len() / 4))?;
        }
        self.points.push(point);
        Ok(())
    }

    /// Ends an outline. It is closed if `is_closed`, or if its ends are equal. An outline of one point is dropped.
    pub(crate) fn end_outline(&mut self, is_closed: bool) -> Result<(), ReadError> {
        let drawn = &self.points[self.first_point_of_outline..];
        let bits = |point: &Vector| point.map(f64::to_bits);
        let is_repeated =
            drawn.len() > 3 && (drawn.first() == drawn.last() || drawn.first().map(bits) == drawn.last().map(bits));
        if is_repeated {
            self.points.pop();
        }
        if self.points.len() - self.first_point_of_outline < 2 {
            self.points.truncate(self.first_point_of_outline);
            return Ok(());
        }
        let is_polygon = self.points.len() - self.first_point_of_outline > 2;
        self.offsets.try_reserve(1)?;
        self.offsets.push(self.points.len() as u32);
        self.closed.try_reserve(1)?;
        self.closed.push(is_polygon && (is_closed || is_repeated));
        self.first_point_of_outline = self.points.len();
        Ok(())
    }

    /// Draws a Bezier curve of degree `N - 1` from its first point.
    pub(crate) fn bezier_to<const N: usize>(&mut self, control: [Vector; N]) -> Result<(), ReadError> {
        self.has_curved_parts = true;
        // The distance to a chord is at most the bound of the second derivative times the squared step over 8.
        let bend = (0..N.saturating_sub(2))
            .map(|k| [0, 1, 2].map(|axis| control[k][axis] - 2.0 * control[k + 1][axis] + control[k + 2][axis]))
            .map(|parts| parts.iter().map(|part| part * part).sum::<f64>().sqrt())
            .fold(0.0, f64::max);
        let factor = ((N - 1) * (N - 2)) as f64 / 8.0;
        let count = (factor * bend / self.tolerance).sqrt().ceil().clamp(1.0, MAX_BEZIER_SEGMENTS);
        let count = if count.is_nan() { 1 } else { count as usize };
        for step in 1..count {
            self.line_to(bezier_point(control, step as f64 / count as f64))?;
        }
        self.line_to(control[N - 1])
    }

    /// Draws an arc of the ellipse `centre + cos(angle) u + sin(angle) v` to the exact point `end`. Begins at the last point.
    pub(crate) fn arc_to(&mut self, ellipse: [Vector; 3], angles: [f64; 2], end: Vector) -> Result<(), ReadError> {
        self.has_curved_parts = true;
        let [start, sweep] = angles;
        let count = self.arc_segments(ellipse, sweep);
        for step in 1..count {
            self.line_to(ellipse_point(ellipse, start + sweep * (step as f64 / count as f64)))?;
        }
        self.line_to(end)
    }

    /// Draws a whole ellipse as an outline.
    pub(crate) fn draw_ellipse(&mut self, ellipse: [Vector; 3]) -> Result<(), ReadError> {
        self.begin_outline(ellipse_point(ellipse, 0.0))?;
        self.arc_to(ellipse, [0.0, TAU], ellipse_point(ellipse, 0.0))?;
        self.end_outline(true)
    }

    fn arc_segments(&self, [_, u, v]: [Vector; 3], sweep: f64) -> usize {
        // At least the larger radius.
        let radius = (0..3).map(|axis| u[axis].powi(2) + v[axis].powi(2)).sum::<f64>().sqrt();
        let step = 2.0 * (1.0 - (self.tolerance / radius).min(1.0)).acos();
        let per_turn = (TAU / step).clamp(TURN_SEGMENTS[0], TURN_SEGMENTS[1]);
        let count = (per_turn * sweep.abs() / TAU).ceil().clamp(1.0, TURN_SEGMENTS[1]);
        if count.is_nan() { 1 } else { count as usize }
    }

    /// Tells that a part is curved, for callers that draw it by lines.
    pub(crate) fn mark_curved(&mut self) {
        self.has_curved_parts = true;
    }
}

/// Returns the point of an ellipse at an angle.
pub(crate) fn ellipse_point([centre, u, v]: [Vector; 3], angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    [0, 1, 2].map(|axis| centre[axis] + cos * u[axis] + sin * v[axis])
}

fn bezier_point<const N: usize>(mut control: [Vector; N], t: f64) -> Vector {
    for count in (1..N).rev() {
        for k in 0..count {
            control[k] = [0, 1, 2].map(|axis| control[k][axis] + t * (control[k + 1][axis] - control[k][axis]));
        }
    }
    control[0]
}
