//! A curve of a net: Bézier segments of one degree, cut where other curves meet it.

use crate::MAX_DEGREE;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::bernstein::{elevate, evaluate, restrict};
use gusset_curve::CurveView;

/// Smallest fraction of the parameter of a piece that a segment takes.
const MIN_SEGMENT_PARAMETER_FRACTION: f64 = 1e-9;
/// Largest ratio between the length of a segment in the parameter and the length of its polygon,
/// both relative to the whole curve.
const MAX_PARAMETER_TO_LENGTH_RATIO: f64 = 16.0;

/// A place on a curve of a net.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct CurvePlace {
    pub(super) segment: usize,
    pub(super) parameter: f64,
}

/// Successive Bézier segments of degree N - 1.
pub(super) struct NetCurve<const N: usize> {
    pub(super) segments: Vec<[DVec3; N]>,
    /// The length of the parameter that each segment takes, chosen so that the lengths of
    /// derivatives are continuous.
    lengths: Vec<f64>,
    pub(super) closed: bool,
}

/// The part of a curve between two nodes.
pub(super) struct CurvePiece<const N: usize> {
    pub(super) segments: Vec<[DVec3; N]>,
    /// The ends of segments as fractions of the piece; the last one is 1.
    pub(super) segment_ends: Vec<f64>,
    /// Length of the piece in the curve's parameter.
    pub(super) length: f64,
}

/// The highest degree of the segments of some curves, at least 1.
///
/// # Errors
/// [`Error::EmptyCurve`] if a curve lacks points, [`Error::OptionOutOfRange`] if a degree is above
/// 7.
pub(super) fn max_segment_degree<'a>(mut curves: impl Iterator<Item = CurveView<'a>>) -> Result<usize> {
    curves.try_fold(1, |highest, curve| {
        if curve.points().is_empty() {
            return Err(Error::EmptyCurve);
        }
        let degree = curve.segments().map(|segment| segment.len() - 1).max().unwrap_or(1);
        Error::require(degree <= MAX_DEGREE, "degree", degree as f64, Allowed::AtMost(MAX_DEGREE as f64))?;
        Ok(degree.max(highest))
    })
}

impl<const N: usize> NetCurve<N> {
    /// Converts a curve of degree N - 1 or less.
    pub(super) fn new(curve: &CurveView<'_>) -> Result<Self> {
        let mut segments = alloc::with_capacity(curve.len().max(1))?;
        for controls in curve.segments() {
            let mut points = [DVec3::ZERO; N];
            points[..controls.len()].copy_from_slice(controls);
            elevate(&mut points, controls.len() - 1);
            // Exact copies keep a segment that is a single point exact.
            if are_points_equal(controls) {
                points = [controls[0]; N];
            }
            segments.push(points);
        }
        if segments.is_empty() {
            segments.push([curve.points()[0]; N]);
        }
        let mut net_curve = NetCurve { lengths: Vec::new(), segments, closed: curve.is_closed() };
        net_curve.lengths = net_curve.segment_parameter_lengths()?;
        Ok(net_curve)
    }

    /// True if the curve is a single point.
    pub(super) fn is_single_point(&self) -> bool {
        are_points_equal(self.segments.as_flattened())
    }

    /// Lengths of segments in a parameter with continuous lengths of derivatives. For a curve that
    /// is C1 in some knots, these are its knot intervals. Segments that are single points have
    /// length 0.
    fn segment_parameter_lengths(&self) -> Result<Vec<f64>> {
        let polygon = |points: &[DVec3; N]| points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
        let polygons = alloc::collect(self.segments.iter().map(polygon))?;
        let total: f64 = polygons.iter().sum();
        let mut lengths = alloc::filled(0.0, polygons.len())?;
        let mut before: Option<usize> = None;
        for (k, points) in self.segments.iter().enumerate().filter(|&(k, _)| polygons[k] > 0.0) {
            lengths[k] = before.map_or(polygons[k], |b| {
                let (start, end) = (points[1] - points[0], self.segments[b][N - 1] - self.segments[b][N - 2]);
                let (start, end) = (start.length(), end.length());
                let regular = start > 1e-6 * polygons[k] && end > 1e-6 * polygons[b];
                lengths[b] * if regular { start / end } else { polygons[k] / polygons[b] }
            });
            before = Some(k);
        }
        let sum: f64 = lengths.iter().sum();
        let wild = |(&length, &polygon): (&f64, &f64)| {
            let [length, polygon] = [length / sum, polygon / total];
            !(length <= MAX_PARAMETER_TO_LENGTH_RATIO * polygon && polygon <= MAX_PARAMETER_TO_LENGTH_RATIO * length)
        };
        if lengths.iter().zip(&polygons).any(wild) { Ok(polygons) } else { Ok(lengths) }
    }

    pub(super) fn point_at(&self, at: CurvePlace) -> DVec3 {
        evaluate(&self.segments[at.segment], at.parameter)
    }

    /// Reverses the curve.
    pub(super) fn reverse_direction(&mut self) {
        self.segments.reverse();
        self.segments.iter_mut().for_each(|points| points.reverse());
        self.lengths.reverse();
    }

    /// The place that corresponds to `at` after [`NetCurve::reverse_direction`].
    pub(super) fn reversed_place(&self, at: CurvePlace) -> CurvePlace {
        CurvePlace { segment: self.segments.len() - 1 - at.segment, parameter: 1.0 - at.parameter }
    }

    /// The pieces between successive places. On a closed curve, the last piece leads from the last
    /// place to the first. The pieces of a curve that is a single point are equal.
    pub(super) fn cut_at_places(&self, places: &[CurvePlace]) -> Result<Vec<CurvePiece<N>>> {
        let count = if self.closed { places.len() } else { places.len() - 1 };
        alloc::try_collect((0..count).map(|k| self.extract_piece_between(places[k], places[(k + 1) % places.len()])))
    }

    /// The whole curve as one piece.
    pub(super) fn whole_piece(&self) -> Result<CurvePiece<N>> {
        let last = self.segments.len() - 1;
        self.extract_piece_between(
            CurvePlace { segment: 0, parameter: 0.0 },
            CurvePlace { segment: last, parameter: 1.0 },
        )
    }

    fn extract_piece_between(&self, from: CurvePlace, to: CurvePlace) -> Result<CurvePiece<N>> {
        let mut piece = CurvePiece { segments: Vec::new(), segment_ends: Vec::new(), length: 0.0 };
        let mut add = |segment: usize, [start, end]: [f64; 2]| -> Result<()> {
            if end <= start || self.lengths[segment] == 0.0 {
                return Ok(());
            }
            piece.length += self.lengths[segment] * (end - start);
            alloc::push(&mut piece.segment_ends, piece.length)?;
            alloc::push(&mut piece.segments, restrict_segment(&self.segments[segment], [start, end]))
        };
        if from.segment == to.segment && from.parameter < to.parameter {
            add(from.segment, [from.parameter, to.parameter])?;
        } else {
            add(from.segment, [from.parameter, 1.0])?;
            let count = self.segments.len();
            let mut segment = (from.segment + 1) % count;
            while segment != to.segment {
                add(segment, [0.0, 1.0])?;
                segment = (segment + 1) % count;
            }
            add(to.segment, [0.0, to.parameter])?;
        }
        if piece.segments.is_empty() {
            alloc::push(&mut piece.segments, [self.point_at(from); N])?;
            alloc::push(&mut piece.segment_ends, 0.0)?;
        }
        piece.normalise_and_separate_segment_ends();
        Ok(piece)
    }
}

impl<const N: usize> CurvePiece<N> {
    /// Converts ends to fractions, and keeps a minimum distance between them.
    fn normalise_and_separate_segment_ends(&mut self) {
        let min = MIN_SEGMENT_PARAMETER_FRACTION * self.length;
        let (mut before, mut total) = (0.0, 0.0);
        for end in &mut self.segment_ends {
            let length = *end - before;
            before = *end;
            total += if length > min { length } else { min };
            *end = total;
        }
        let count = self.segment_ends.len();
        for (k, end) in self.segment_ends.iter_mut().enumerate() {
            *end = if k + 1 == count || total == 0.0 { (k + 1) as f64 / count as f64 } else { *end / total };
        }
    }

    /// Moves the ends of the piece to the given points. Moves all other points by linear
    /// interpolation.
    pub(super) fn move_ends(&mut self, from: DVec3, to: DVec3) {
        let last = self.segments.len() - 1;
        let (start, end) = (from - self.segments[0][0], to - self.segments[last][N - 1]);
        let mut before = 0.0;
        for (points, &after) in self.segments.iter_mut().zip(&self.segment_ends) {
            for (k, point) in points.iter_mut().enumerate() {
                let at = before + (after - before) * (k as f64 / (N - 1) as f64);
                *point += start.lerp(end, at);
            }
            before = after;
        }
        (self.segments[0][0], self.segments[last][N - 1]) = (from, to);
        for k in 0..last {
            self.segments[k + 1][0] = self.segments[k][N - 1];
        }
    }

    /// Appends the segments over the spans between breaks, the last of which is 1. `segment_ends` are the
    /// ends of the piece's segments, all of which are among the breaks.
    pub(super) fn append_refined_segments(
        &self,
        segment_ends: &[f64],
        breaks: &[f64],
        refined: &mut Vec<[DVec3; N]>,
    ) -> Result<()> {
        alloc::reserve(refined, breaks.len())?;
        let (mut segment, mut from) = (0, 0.0);
        let mut start = self.segments[0][0];
        for &to in breaks {
            let first = if segment == 0 { 0.0 } else { segment_ends[segment - 1] };
            let length = segment_ends[segment] - first;
            let [low, high] =
                [(from - first) / length, if to >= segment_ends[segment] { 1.0 } else { (to - first) / length }];
            let mut points = restrict_segment(&self.segments[segment], [low, high]);
            // Neighbours share their ends exactly.
            points[0] = start;
            start = points[N - 1];
            refined.push(points);
            if to >= segment_ends[segment] && segment + 1 < segment_ends.len() {
                segment += 1;
            }
            from = to;
        }
        Ok(())
    }
}

fn are_points_equal(points: &[DVec3]) -> bool {
    points.iter().all(|&p| p == points[0])
}

/// A segment restricted to a range of its parameters. The full range returns the segment unchanged.
pub(super) fn restrict_segment<const N: usize>(points: &[DVec3; N], range: [f64; 2]) -> [DVec3; N] {
    let mut part = *points;
    restrict(&mut part, range);
    part
}
