//! Finds the single arc of a box whose solutions form a graph.
//!
//! The search looks for the two exits of the curve from the box along the line of the middle. If
//! the line does not lead to them, it starts at a solution inside. Bounds of slopes prove that the
//! curve does not return: each parameter is monotone along the curve, or stays inside the box. A
//! curve that runs along a side of the box within rounding does neither. It belongs to the boxes on
//! both sides, and each of them finds it (`overlapping_arcs`).
//!
//! Cost: a few Newton steps for each exit, O(N^2 + M^2) each.

use super::intersection_equation::{DifferenceFrame, IntersectionEquation};
use super::solution_chart::{GRAPH_MARGIN_FRACTION, ParameterBox, SolutionGraphProof};
use glam::{DVec3, DVec4};
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::subdivision::BoxTest;

/// Rounding of the parameter at which a curve crosses a side, as a fraction of the cell.
pub(super) const MAX_CROSSING_PARAMETER_ROUNDING: f64 = 1e-13;
/// Points closer to a side than this multiple of a solution's rounding error tell nothing.
const MIN_SIDE_DISTANCE_IN_ROUNDINGS: f64 = 64.0;
/// A curve runs along a side if its distance is below this fraction of [`ArcBoxSearch::close_distance`].
const MAX_ALONG_SIDE_FRACTION_OF_CLOSE: f64 = 1.0 / 32.0;
/// Slope of a parameter, relative to the width of its bounds, above which smaller boxes prove its
/// sign.
const MIN_PROVABLE_SLOPE_FRACTION: f64 = 1.0 / 64.0;

/// A curve whose distance from the sides is at least this fraction of the box is in the middle of
/// it.
const MIN_MIDDLE_DISTANCE_FRACTION: f64 = 1.0 / 16.0;

/// Smallest fraction of the free parameter's range over which the line of the middle must lie in
/// the box to describe the curve.
const MIN_LINE_FRACTION_IN_BOX: f64 = 1.0 / 64.0;

/// An end of an arc, and the directions in which the arc continues, in parameters and in space.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcEnd {
    pub(super) parameters: DVec4,
    pub(super) tangent: DVec4,
    pub(super) direction: DVec3,
}

/// A solution, and the derivatives at it.
type SolutionAndFrame = (DVec4, DifferenceFrame);

/// Approximation of the curve by its free parameter f: x + f rates + f^2 bend.
struct LocalCurveApproximation {
    parameters: DVec4,
    first_coefficient: DVec4,
    second_coefficient: DVec4,
}

/// The search could not decide.
struct UndecidedArc;

/// The arc in a box whose solutions form a graph. `Empty`: only runs that may be lost. `Unique`:
/// one arc between two ends, by rising free parameter. `Undecided`: the parameter to halve the box
/// by, if known.
pub(super) type ArcBoxTest = BoxTest<[ArcEnd; 2], Option<usize>>;

/// The search for the arc in a box.
pub(super) struct ArcBoxSearch<'a, const N: usize, const M: usize> {
    pub(super) equation: &'a IntersectionEquation<N, M>,
    pub(super) graph_proof: &'a SolutionGraphProof,
    low: DVec4,
    high: DVec4,
    graph_margin: DVec4,
    /// Runs of a curve beyond a side up to this length may be lost, or be found twice.
    max_lost_length: f64,
    rounding_error: f64,
    /// If a curve is within this length of a side, its points tell whether it runs along the side.
    close_distance: f64,
}

impl<'a, const N: usize, const M: usize> ArcBoxSearch<'a, N, M> {
    /// Creates the search in a box. Arcs no longer than `max_lost_length` may be lost. Lengths up to
    /// `rounding_error` may be rounding.
    pub(super) fn new(
        equation: &'a IntersectionEquation<N, M>,
        part: &ParameterBox<N, M>,
        chart: &'a SolutionGraphProof,
        [resolution, max_lost_length]: [f64; 2],
        rounding_error: f64,
    ) -> Self {
        let (low, high) = (part.low, part.low + part.size);
        // A curve that runs along a side is hardly ever inclined to it by more than 1 in 16, so its
        // distance is below 16 times the noise.
        let close = (1e-3 * resolution).max(512.0 * rounding_error);
        ArcBoxSearch {
            equation,
            graph_proof: chart,
            low,
            high,
            graph_margin: GRAPH_MARGIN_FRACTION * part.size,
            max_lost_length,
            rounding_error,
            close_distance: close,
        }
    }

    /// Finds the arc if the line of the middle leads to its ends, which is the usual case. `middle`
    /// holds the derivatives in the middle of the box.
    pub(super) fn find_arc_along_line(&self, middle: &DifferenceFrame) -> Option<ArcBoxTest> {
        let SolutionGraphProof { free_parameter: free, line_middle: base, line_slopes: line, .. } = *self.graph_proof;
        let [from, to] = self.line_range_inside_box();
        if to - from < MIN_LINE_FRACTION_IN_BOX * (self.high[free] - self.low[free]) {
            return None;
        }
        let half = 0.5 * (from + to);
        let first = self.find_exit(
            &LocalCurveApproximation {
                parameters: base + half * line,
                first_coefficient: line,
                second_coefficient: DVec4::ZERO,
            },
            -1.0,
        )?;
        // The parabola with the slopes at this end and in the middle.
        let rates = first.tangent / first.tangent[free];
        let bend = (line - rates) / (2.0 * (base[free] - first.parameters[free]));
        let step = base[free] + half - first.parameters[free];
        let x = first.parameters + step * (rates + step * bend);
        let last = self.find_exit(
            &LocalCurveApproximation {
                parameters: x,
                first_coefficient: rates + 2.0 * step * bend,
                second_coefficient: bend,
            },
            1.0,
        )?;
        Some(self.classify_exits(middle, first, last))
    }

    /// Finds the arc from a solution inside the box.
    pub(super) fn find_arc_from_inside(&self, middle: &DifferenceFrame) -> ArcBoxTest {
        let (x, frame) = match self.find_solution_inside() {
            Ok(Some(start)) => start,
            Ok(None) => return BoxTest::Empty,
            Err(UndecidedArc) => return BoxTest::Undecided(None),
        };
        let curve = LocalCurveApproximation {
            parameters: x,
            first_coefficient: self.slopes_by_free_parameter(&frame),
            second_coefficient: DVec4::ZERO,
        };
        match (self.find_exit(&curve, -1.0), self.find_exit(&curve, 1.0)) {
            (Some(first), Some(last)) => self.classify_exits(middle, first, last),
            _ => BoxTest::Undecided(None),
        }
    }

    /// Classifies a curve that leaves the box at two ends.
    fn classify_exits(&self, middle: &DifferenceFrame, first: ArcEnd, last: ArcEnd) -> ArcBoxTest {
        match self.classify_parameter_course(middle, &first, &last) {
            ParameterCourse::Inside => BoxTest::Unique([first, last]),
            ParameterCourse::Outside => BoxTest::Empty,
            ParameterCourse::Unknown(k) => BoxTest::Undecided(k),
        }
    }

    /// The slopes of all parameters with respect to the free one.
    fn slopes_by_free_parameter(&self, frame: &DifferenceFrame) -> DVec4 {
        let tangent = frame.parameter_tangent();
        tangent / tangent[self.graph_proof.free_parameter]
    }

    /// True if a parameter is proven to be monotone in the free one.
    fn is_parameter_monotone(&self, k: usize) -> bool {
        let [low, high] = self.graph_proof.slope_ranges[k];
        low > 0.0 || high < 0.0
    }

    /// [`ArcBoxSearch::close_distance`] as a distance in parameter k. Larger where the surfaces are nearly
    /// parallel, and rounding is larger.
    fn close_distance_in_parameter(&self, frame: &DifferenceFrame, k: usize) -> f64 {
        let rounding = self.rounding_error * frame.parameter_change_per_miss(k, self.graph_proof.free_parameter);
        (self.close_distance / frame.derivatives[k].length()).max(MIN_SIDE_DISTANCE_IN_ROUNDINGS * rounding).min(1e-3)
    }

    /// A solution inside the box, if the box holds an arc longer than the shortest one.
    fn find_solution_inside(&self) -> Result<Option<SolutionAndFrame>, UndecidedArc> {
        let free = self.graph_proof.free_parameter;
        let mut guess = self.middle_of_line_in_box();
        for _ in 0..4 {
            let Some((x, frame)) = self.equation.solve_with_fixed_parameter(guess, free) else {
                return Err(UndecidedArc);
            };
            if x.cmplt(self.low - self.graph_margin).any() || x.cmpgt(self.high + self.graph_margin).any() {
                return Err(UndecidedArc);
            }
            let slack = |k: usize| {
                if self.is_parameter_monotone(k) {
                    MAX_CROSSING_PARAMETER_ROUNDING
                } else {
                    self.close_distance_in_parameter(&frame, k)
                }
            };
            if (0..4).all(|k| x[k] >= self.low[k] - slack(k) && x[k] <= self.high[k] + slack(k)) {
                return Ok(Some((x, frame)));
            }
            // Bounds of slopes tell where else a solution may be.
            let parts = [-1.0, 1.0].map(|way| (way, self.feasible_range(x, way)));
            let longest = parts.into_iter().max_by(|a, b| (a.1[1] - a.1[0]).total_cmp(&(b.1[1] - b.1[0])));
            let Some((way, [from, to])) = longest else {
                return Err(UndecidedArc);
            };
            let speed = frame.curve_direction().length() / frame.parameter_tangent()[free].abs();
            if (to - from) * speed <= self.max_lost_length {
                return Ok(None);
            }
            let step = way * 0.5 * (from + to);
            guess = x + step * self.slopes_by_free_parameter(&frame);
            guess[free] = x[free] + step;
        }
        Err(UndecidedArc)
    }

    /// The range of the free parameter, relative to its middle, in which the line of the middle is
    /// inside the box. If it is empty, the first bound is the greater one.
    fn line_range_inside_box(&self) -> [f64; 2] {
        let SolutionGraphProof { free_parameter: free, line_middle: base, line_slopes: line, .. } = *self.graph_proof;
        let (mut from, mut to) = (self.low[free] - base[free], self.high[free] - base[free]);
        for k in (0..4).filter(|&k| k != free && line[k].abs() > 1e-6) {
            let ends = [self.low[k] - base[k], self.high[k] - base[k]].map(|x| x / line[k]);
            (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
        }
        [from, to]
    }

    /// Returns the point of `chart.line`, the tangent line of the solution curve, at the middle of
    /// its part inside the box. If the line misses the box, returns its point near the box.
    fn middle_of_line_in_box(&self) -> DVec4 {
        let SolutionGraphProof { free_parameter: free, line_middle: base, line_slopes: line, .. } = *self.graph_proof;
        let [from, to] = self.line_range_inside_box();
        let step = (0.5 * (from + to)).clamp(self.low[free] - base[free], self.high[free] - base[free]);
        base + step * line
    }

    /// The distances from a solution, upwards or downwards (`direction`) along the free parameter,
    /// at which other solutions may be in the box.
    fn feasible_range(&self, x: DVec4, direction: f64) -> [f64; 2] {
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        // slope * d <= room for d >= 0.
        let mut restrict = |slope: f64, room: f64| {
            let room = room + MAX_CROSSING_PARAMETER_ROUNDING;
            if slope > 0.0 {
                to = to.min(room / slope);
            } else if room < 0.0 {
                from = if slope < 0.0 { from.max(room / slope) } else { f64::INFINITY };
            }
        };
        for k in 0..4 {
            let [low, high] = self.graph_proof.slope_ranges[k].map(|slope| slope * direction);
            let (min, max) = (low.min(high), low.max(high));
            restrict(min, self.high[k] - x[k]);
            restrict(-max, x[k] - self.low[k]);
        }
        if from == f64::INFINITY { [0.0, -1.0] } else { [from, to] }
    }

    /// The exit of the curve from the box, upwards or downwards (`direction`) along the free
    /// parameter.
    fn find_exit(&self, curve: &LocalCurveApproximation, direction: f64) -> Option<ArcEnd> {
        let free = self.graph_proof.free_parameter;
        // The side towards which a parameter moves.
        let rises = |k: usize| {
            k == free && direction > 0.0 || k != free && self.graph_proof.slope_ranges[k][0] * direction > 0.0
        };
        let side = |k: usize| if rises(k) { self.high[k] } else { self.low[k] };
        let leaves = |k: usize| k == free || self.is_parameter_monotone(k);
        let inside = curve.parameters;
        let nearest = |rates: DVec4| {
            let mut best = (free, f64::INFINITY);
            for k in (0..4).filter(|&k| leaves(k)) {
                let step = ((side(k) - inside[k]) / (direction * rates[k])).max(0.0);
                best = if step < best.1 { (k, step) } else { best };
            }
            best
        };
        let chord = |step: f64| curve.first_coefficient + direction * step * curve.second_coefficient;
        let (_, roughly) = nearest(curve.first_coefficient);
        let (mut through, step) = nearest(chord(roughly));
        let mut guess = inside + direction * step * chord(step);
        for _ in 0..8 {
            guess[through] = side(through);
            let (x, frame) = self.equation.solve_with_fixed_parameter(guess, through)?;
            let rate = direction * self.slopes_by_free_parameter(&frame);
            // Sides that the curve has passed already.
            let passed = |k: usize| {
                if rises(k) { x[k] - side(k) } else { side(k) - x[k] }
            };
            let back = |k: usize| {
                if passed(k) > MAX_CROSSING_PARAMETER_ROUNDING { passed(k) / rate[k].abs() } else { 0.0 }
            };
            let earlier = (0..4)
                .filter(|&k| k != through && leaves(k) && back(k) > 0.0)
                .max_by(|&k, &n| back(k).total_cmp(&back(n)));
            let Some(earlier) = earlier else {
                let end =
                    ArcEnd { parameters: x, tangent: frame.parameter_tangent(), direction: frame.curve_direction() };
                return self.is_exit_in_box_and_ahead(inside, x, direction).then_some(end);
            };
            guess = x - back(earlier) * rate;
            through = earlier;
        }
        None
    }

    /// Whether an exit is in the box, and in the right direction from the point inside.
    fn is_exit_in_box_and_ahead(&self, inside: DVec4, x: DVec4, direction: f64) -> bool {
        let free = self.graph_proof.free_parameter;
        let within = |k: usize| {
            let slack = if self.is_parameter_monotone(k) {
                2.0 * MAX_CROSSING_PARAMETER_ROUNDING
            } else {
                self.graph_margin[k]
            };
            x[k] >= self.low[k] - slack && x[k] <= self.high[k] + slack
        };
        direction * (x[free] - inside[free]) >= -2.0 * MAX_CROSSING_PARAMETER_ROUNDING && (0..4).all(within)
    }

    /// Whether the parameters that are not monotone stay in the box between two solutions.
    fn classify_parameter_course(&self, frame: &DifferenceFrame, first: &ArcEnd, last: &ArcEnd) -> ParameterCourse {
        let free = self.graph_proof.free_parameter;
        let length = (last.parameters[free] - first.parameters[free]).max(0.0);
        let mut samples = None;
        for k in (0..4).filter(|&k| k != free && !self.is_parameter_monotone(k)) {
            let [low, high] = self.graph_proof.slope_ranges[k];
            let (from, to) = (first.parameters[k], last.parameters[k]);
            // The highest and the lowest point that the bounds of slopes at both ends allow.
            let until = |slope: f64, other: f64| {
                let time = (to - other * length - from) / (slope - other);
                from + slope * time.clamp(0.0, length)
            };
            let (max, min) = (until(high, low).max(from).max(to), until(low, high).min(from).min(to));
            if min >= self.low[k] - MAX_CROSSING_PARAMETER_ROUNDING
                && max <= self.high[k] + MAX_CROSSING_PARAMETER_ROUNDING
            {
                continue;
            }
            let samples = *samples.get_or_insert_with(|| self.sample_solutions(first, last));
            let Some(samples) = samples else {
                return ParameterCourse::Unknown(Some(k));
            };
            match self.classify_course_beside_side(k, &samples, frame) {
                ParameterCourse::Inside => {}
                other => return other,
            }
        }
        ParameterCourse::Inside
    }

    /// Classifies a curve next to a side across parameter k. A curve that runs along the side
    /// within rounding belongs to the boxes on both sides. A curve that touches it belongs to the
    /// box it comes from. Smaller boxes cut a curve that crosses it. Beside poles, where parameter
    /// lines are close together, such a curve may be close to the side for several resolutions.
    fn classify_course_beside_side(&self, k: usize, samples: &[DVec4; 5], frame: &DifferenceFrame) -> ParameterCourse {
        let close = self.close_distance_in_parameter(frame, k);
        let [min, max] = range_of_values(samples.map(|x| x[k]));
        // Halving across k does not bring a curve in the middle that hardly moves in k closer to
        // the sides. Shorter pieces of it have narrower bounds.
        let room = (min - self.low[k]).min(self.high[k] - max);
        let is_central = room >= MIN_MIDDLE_DISTANCE_FRACTION * (self.high[k] - self.low[k]);
        let mut course = ParameterCourse::Unknown(if is_central { None } else { Some(k) });
        for (side, is_high) in [(self.low[k], false), (self.high[k], true)] {
            if min < side - close || max > side + close {
                continue;
            }
            let (below, above) = (
                max <= side + MAX_ALONG_SIDE_FRACTION_OF_CLOSE * close,
                min >= side - MAX_ALONG_SIDE_FRACTION_OF_CLOSE * close,
            );
            if !below && !above {
                return ParameterCourse::Unknown(Some(k));
            }
            let stays = if is_high { below } else { above };
            let outwards = if is_high == stays { 1.0 } else { -1.0 };
            if self.crosses_side_clearly(k, samples, (side, outwards), frame) {
                return ParameterCourse::Unknown(None);
            }
            if !stays {
                return ParameterCourse::Outside;
            }
            course = ParameterCourse::Inside;
        }
        course
    }

    /// Whether a curve clearly rises or falls across a side, and runs farther beyond it than may be
    /// lost. `outwards` is the direction away from the part that would be kept.
    fn crosses_side_clearly(
        &self,
        k: usize,
        samples: &[DVec4; 5],
        (side, outwards): (f64, f64),
        frame: &DifferenceFrame,
    ) -> bool {
        let free = self.graph_proof.free_parameter;
        let [low, high] = self.graph_proof.slope_ranges[k];
        let [first, .., last] = samples;
        let rise = (last[k] - first[k]).abs();
        if rise <= MIN_PROVABLE_SLOPE_FRACTION * (high - low) * (last[free] - first[free]) {
            return false;
        }
        let rounding = self.rounding_error * frame.parameter_change_per_miss(k, free);
        let beyond = |x: &DVec4| outwards * (x[k] - side) - rounding;
        let run = |pair: &[DVec4]| {
            let [from, to] = [0, 1].map(|n| beyond(&pair[n]));
            let (least, most) = (from.min(to), from.max(to));
            if most <= 0.0 {
                return 0.0;
            }
            let share = if least >= 0.0 { 1.0 } else { most / (most - least) };
            share * self.equation.point_of_first_patch(pair[0]).distance(self.equation.point_of_first_patch(pair[1]))
        };
        samples.windows(2).map(run).sum::<f64>() > self.max_lost_length
    }

    /// Solutions at both ends and at three parameters between them.
    fn sample_solutions(&self, first: &ArcEnd, last: &ArcEnd) -> Option<[DVec4; 5]> {
        let mut samples = [first.parameters; 5];
        for (sample, part) in samples.iter_mut().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
            (*sample, _) = self.equation.solve_with_fixed_parameter(
                first.parameters.lerp(last.parameters, part),
                self.graph_proof.free_parameter,
            )?;
        }
        Some(samples)
    }
}

/// The course of the parameters that are not monotone.
enum ParameterCourse {
    /// All of them stay in the box.
    Inside,
    /// The curve belongs to another box, and touches a side from there.
    Outside,
    /// Undecided. Contains the parameter to halve the box by, if it is known.
    Unknown(Option<usize>),
}
