//! Rational B-splines.

use super::dxf_entity::{Entity, Frame};
use crate::error::ReadError;
use crate::outline_pen::{OutlinePen, Vector};
use crate::text::number;

const MAX_DEGREE: usize = 15;
/// Most segments between two knots.
const MAX_SEGMENTS_PER_SPAN: f64 = 1024.0;
/// Segments between two knots of a rational spline, as a multiple of those without weights.
const RATIONAL_SEGMENT_FACTOR: f64 = 2.0;

struct Spline {
    degree: usize,
    knots: Vec<f64>,
    /// Control points times their weights, and the weights.
    control: Vec<[f64; 4]>,
    is_rational: bool,
}

/// Draws a spline by its control points, or by lines between the points that it fits if it has no others. A spline whose knots do not fit
/// its control points is drawn by lines between these.
pub(super) fn draw_spline(entity: &Entity<'_>, frame: &Frame, pen: &mut OutlinePen) -> Result<(), ReadError> {
    let is_closed = entity.integer_of_code(70) & 1 != 0;
    let control = points_of_codes(entity, 10)?;
    let (spline, fallback) = if control.is_empty() {
        (None, points_of_codes(entity, 11)?)
    } else {
        (Spline::new(entity, &control, frame)?, control)
    };
    let Some(spline) = spline else {
        let mut points = fallback.iter().map(|&point| frame.map_point(point));
        if let Some(first) = points.next() {
            pen.begin_outline(first)?;
        }
        points.try_for_each(|point| pen.line_to(point))?;
        return pen.end_outline(is_closed);
    };
    pen.mark_curved();
    let (first, last) = (spline.degree, spline.control.len());
    pen.begin_outline(spline.point_on_span(first, spline.knots[first]))?;
    for span in first..last {
        let [start, end] = [spline.knots[span], spline.knots[span + 1]];
        if end > start {
            let count = spline.chord_count(span, pen.tolerance);
            for step in 1..=count {
                let t = if step == count { end } else { start + (end - start) * (step as f64 / count as f64) };
                pen.line_to(spline.point_on_span(span, t))?;
            }
        }
    }
    pen.end_outline(is_closed)
}

fn points_of_codes(entity: &Entity<'_>, code: i32) -> Result<Vec<Vector>, ReadError> {
    let mut points: Vec<Vector> = Vec::new();
    for pair in &entity.pairs {
        let value = number(pair.value).unwrap_or(0.0);
        match (pair.code - code, points.last_mut()) {
            (0, _) => {
                points.try_reserve(1)?;
                points.push([value, 0.0, 0.0]);
            }
            (10, Some(point)) => point[1] = value,
            (20, Some(point)) => point[2] = value,
            _ => {}
        }
    }
    Ok(points)
}

fn numbers_of_code(entity: &Entity<'_>, code: i32) -> Result<Vec<f64>, ReadError> {
    let mut numbers = Vec::new();
    for pair in entity.pairs.iter().filter(|pair| pair.code == code) {
        numbers.try_reserve(1)?;
        numbers.push(number(pair.value).unwrap_or(f64::NAN));
    }
    Ok(numbers)
}

impl Spline {
    /// Returns `None` if the numbers do not make a spline.
    fn new(entity: &Entity<'_>, points: &[Vector], frame: &Frame) -> Result<Option<Self>, ReadError> {
        let knots = numbers_of_code(entity, 40)?;
        // Some programs leave the degree out.
        let fitting = knots.len().saturating_sub(points.len() + 1);
        let degree = if entity.text_of_code(71).is_some() {
            usize::try_from(entity.integer_of_code(71)).unwrap_or(0)
        } else {
            fitting
        };
        let weights = numbers_of_code(entity, 41)?;
        let is_valid = (1..=MAX_DEGREE).contains(&degree)
            && points.len() > degree
            && knots.len() == points.len() + degree + 1
            && knots.is_sorted()
            && knots.iter().all(|knot| knot.is_finite())
            && (weights.is_empty() || weights.len() == points.len())
            && weights.iter().all(|&weight| weight > 0.0 && weight.is_finite());
        if !is_valid {
            return Ok(None);
        }
        let mut control = Vec::new();
        control.try_reserve_exact(points.len())?;
        control.extend(points.iter().enumerate().map(|(place, &point)| {
            let weight = weights.get(place).copied().unwrap_or(1.0);
            let [x, y, z] = frame.map_point(point);
            [weight * x, weight * y, weight * z, weight]
        }));
        let is_rational = weights.iter().any(|&weight| weight != 1.0);
        Ok(Some(Self { degree, knots, control, is_rational }))
    }

    /// Returns the point at a parameter between knot `span` and the next, by de Boor's algorithm.
    fn point_on_span(&self, span: usize, t: f64) -> Vector {
        let degree = self.degree;
        let first = span - degree;
        let mut local = [[0.0; 4]; MAX_DEGREE + 1];
        local[..=degree].copy_from_slice(&self.control[first..=span]);
        for level in 1..=degree {
            for k in (level..=degree).rev() {
                let (low, high) = (self.knots[first + k], self.knots[first + k + degree + 1 - level]);
                let part = if high > low { (t - low) / (high - low) } else { 0.0 };
                local[k] = [0, 1, 2, 3].map(|axis| local[k - 1][axis] + part * (local[k][axis] - local[k - 1][axis]));
            }
        }
        let [x, y, z, weight] = local[degree];
        [x / weight, y / weight, z / weight]
    }

    /// Returns the number of segments between knot `span` and the next, by the control points of the second derivative.
    fn chord_count(&self, span: usize, tolerance: f64) -> usize {
        let degree = self.degree;
        if degree < 2 {
            return 1;
        }
        let first = span - degree;
        let point = |k: usize| {
            let [x, y, z, weight] = self.control[first + k];
            [x / weight, y / weight, z / weight]
        };
        // Control point `k` of a derivative belongs to the knots from `k + order`.
        let quotient = |k: usize, order: usize, from: Vector, to: Vector| {
            let width = self.knots[first + k + degree + 1] - self.knots[first + k + order];
            let factor = if width > 0.0 { (degree + 1 - order) as f64 / width } else { 0.0 };
            [0, 1, 2].map(|axis| factor * (to[axis] - from[axis]))
        };
        let slope = |k: usize| quotient(k, 1, point(k), point(k + 1));
        let bend = (0..=degree - 2)
            .map(|k| quotient(k, 2, slope(k), slope(k + 1)))
            .map(|bend| bend.iter().map(|part| part * part).sum::<f64>().sqrt())
            .fold(0.0, f64::max);
        let length = self.knots[span + 1] - self.knots[span];
        let count =
            length * (bend / (8.0 * tolerance)).sqrt() * if self.is_rational { RATIONAL_SEGMENT_FACTOR } else { 1.0 };
        // Without a tolerance, only the extent matters.
        let least = if tolerance.is_finite() { 1.0 } else { degree as f64 };
        if count.is_nan() { 1 } else { count.ceil().clamp(least, MAX_SEGMENTS_PER_SPAN) as usize }
    }
}
