//! Finds the single arc of a box whose solutions form a graph.
//!
//! The search looks for the two exits of the curve from the box along the line of the middle. If
//! the line does not lead to them, it starts at a solution inside. Bounds of slopes prove that the
//! curve does not return: each parameter is monotone along the curve, or stays inside the box. A
//! curve that runs along a side of the box within rounding does neither. It belongs to the boxes on
//! both sides, and each of them finds it (`overlap`).
//!
//! Cost: a few Newton steps for each exit, O(N^2 + M^2) each.

use super::chart::{Chart, MARGIN, ParameterBox};
use super::equation::{Equation, Frame};
use glam::{DVec3, DVec4};
use gusset_base::geom::aabb::range;
use gusset_base::geom::subdivision::BoxTest;

/// Rounding of the parameter at which a curve crosses a side, as a fraction of the cell.
pub(super) const PARAMETER_ROUNDING: f64 = 1e-13;
/// Points closer to a side than this multiple of a solution's rounding error tell nothing.
const ROUNDINGS: f64 = 64.0;
/// A curve runs along a side if its distance is below this fraction of [`ArcSearch::close`].
const ALONG_SIDE_SHARE: f64 = 1.0 / 32.0;
/// Slope of a parameter, relative to the width of its bounds, above which smaller boxes prove its
/// sign.
const MIN_SLOPE_SHARE: f64 = 1.0 / 64.0;

/// A curve whose distance from the sides is at least this fraction of the box is in the middle of
/// it.
const MIN_ROOM: f64 = 1.0 / 16.0;

/// Smallest fraction of the free parameter's range over which the line of the middle must lie in
/// the box to describe the curve.
const MIN_LINE_SHARE: f64 = 1.0 / 64.0;

/// An end of an arc, and the directions in which the arc continues, in parameters and in space.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcEnd {
    pub(super) x: DVec4,
    pub(super) tangent: DVec4,
    pub(super) direction: DVec3,
}

/// A solution, and the derivatives at it.
type Start = (DVec4, Frame);

/// Approximation of the curve by its free parameter f: x + f rates + f^2 bend.
struct LocalCurve {
    x: DVec4,
    rates: DVec4,
    bend: DVec4,
}

/// The search could not decide.
struct Unclear;

/// The arc in a box whose solutions form a graph. `Empty`: only runs that may be lost. `Unique`:
/// one arc between two ends, by rising free parameter. `Undecided`: the parameter to halve the box
/// by, if known.
pub(super) type ArcTest = BoxTest<[ArcEnd; 2], Option<usize>>;

/// The search for the arc in a box.
pub(super) struct ArcSearch<'a, const N: usize, const M: usize> {
    pub(super) equation: &'a Equation<N, M>,
    pub(super) chart: &'a Chart,
    low: DVec4,
    high: DVec4,
    margin: DVec4,
    /// Runs of a curve beyond a side up to this length may be lost, or be found twice.
    shortest: f64,
    rounding_error: f64,
    /// If a curve is within this length of a side, its points tell whether it runs along the side.
    close: f64,
}

impl<'a, const N: usize, const M: usize> ArcSearch<'a, N, M> {
    /// Creates the search in a box. Arcs no longer than `shortest` may be lost. Lengths up to
    /// `rounding_error` may be rounding.
    pub(super) fn new(
        equation: &'a Equation<N, M>,
        part: &ParameterBox<N, M>,
        chart: &'a Chart,
        [resolution, shortest]: [f64; 2],
        rounding_error: f64,
    ) -> Self {
        let (low, high) = (part.low, part.low + part.size);
        // A curve that runs along a side is hardly ever inclined to it by more than 1 in 16, so its
        // distance is below 16 times the noise.
        let close = (1e-3 * resolution).max(512.0 * rounding_error);
        ArcSearch { equation, chart, low, high, margin: MARGIN * part.size, shortest, rounding_error, close }
    }

    /// Finds the arc if the line of the middle leads to its ends, which is the usual case. `middle`
    /// holds the derivatives in the middle of the box.
    pub(super) fn find_along_line(&self, middle: &Frame) -> Option<ArcTest> {
        let Chart { free, base, line, .. } = *self.chart;
        let [from, to] = self.line_inside();
        if to - from < MIN_LINE_SHARE * (self.high[free] - self.low[free]) {
            return None;
        }
        let half = 0.5 * (from + to);
        let first = self.find_exit(&LocalCurve { x: base + half * line, rates: line, bend: DVec4::ZERO }, -1.0)?;
        // The parabola with the slopes at this end and in the middle.
        let rates = first.tangent / first.tangent[free];
        let bend = (line - rates) / (2.0 * (base[free] - first.x[free]));
        let step = base[free] + half - first.x[free];
        let x = first.x + step * (rates + step * bend);
        let last = self.find_exit(&LocalCurve { x, rates: rates + 2.0 * step * bend, bend }, 1.0)?;
        Some(self.classify_exits(middle, first, last))
    }

    /// Finds the arc from a solution inside the box.
    pub(super) fn find_from_inside(&self, middle: &Frame) -> ArcTest {
        let (x, frame) = match self.find_start() {
            Ok(Some(start)) => start,
            Ok(None) => return BoxTest::Empty,
            Err(Unclear) => return BoxTest::Undecided(None),
        };
        let curve = LocalCurve { x, rates: self.rates(&frame), bend: DVec4::ZERO };
        match (self.find_exit(&curve, -1.0), self.find_exit(&curve, 1.0)) {
            (Some(first), Some(last)) => self.classify_exits(middle, first, last),
            _ => BoxTest::Undecided(None),
        }
    }

    /// Classifies a curve that leaves the box at two ends.
    fn classify_exits(&self, middle: &Frame, first: ArcEnd, last: ArcEnd) -> ArcTest {
        match self.classify_course(middle, &first, &last) {
            Course::Inside => BoxTest::Unique([first, last]),
            Course::Outside => BoxTest::Empty,
            Course::Unknown(k) => BoxTest::Undecided(k),
        }
    }

    /// The slopes of all parameters with respect to the free one.
    fn rates(&self, frame: &Frame) -> DVec4 {
        let tangent = frame.tangent();
        tangent / tangent[self.chart.free]
    }

    /// True if a parameter is proven to be monotone in the free one.
    fn is_monotone(&self, k: usize) -> bool {
        let [low, high] = self.chart.slopes[k];
        low > 0.0 || high < 0.0
    }

    /// [`ArcSearch::close`] as a distance in parameter k. Larger where the surfaces are nearly
    /// parallel, and rounding is larger.
    fn side_distance(&self, frame: &Frame, k: usize) -> f64 {
        let rounding = self.rounding_error * frame.sensitivity(self.chart.free, k);
        (self.close / frame.columns[k].length()).max(ROUNDINGS * rounding).min(1e-3)
    }

    /// A solution inside the box, if the box holds an arc longer than the shortest one.
    fn find_start(&self) -> Result<Option<Start>, Unclear> {
        let free = self.chart.free;
        let mut guess = self.deepest_on_line();
        for _ in 0..4 {
            let Some((x, frame)) = self.equation.solve(guess, free) else {
                return Err(Unclear);
            };
            if x.cmplt(self.low - self.margin).any() || x.cmpgt(self.high + self.margin).any() {
                return Err(Unclear);
            }
            let slack = |k: usize| {
                if self.is_monotone(k) { PARAMETER_ROUNDING } else { self.side_distance(&frame, k) }
            };
            if (0..4).all(|k| x[k] >= self.low[k] - slack(k) && x[k] <= self.high[k] + slack(k)) {
                return Ok(Some((x, frame)));
            }
            // Bounds of slopes tell where else a solution may be.
            let parts = [-1.0, 1.0].map(|way| (way, self.feasible_range(x, way)));
            let longest = parts.into_iter().max_by(|a, b| (a.1[1] - a.1[0]).total_cmp(&(b.1[1] - b.1[0])));
            let Some((way, [from, to])) = longest else {
                return Err(Unclear);
            };
            let speed = frame.direction().length() / frame.tangent()[free].abs();
            if (to - from) * speed <= self.shortest {
                return Ok(None);
            }
            let step = way * 0.5 * (from + to);
            guess = x + step * self.rates(&frame);
            guess[free] = x[free] + step;
        }
        Err(Unclear)
    }

    /// The range of the free parameter, relative to its middle, in which the line of the middle is
    /// inside the box. If it is empty, the first bound is the greater one.
    fn line_inside(&self) -> [f64; 2] {
        let Chart { free, base, line, .. } = *self.chart;
        let (mut from, mut to) = (self.low[free] - base[free], self.high[free] - base[free]);
        for k in (0..4).filter(|&k| k != free && line[k].abs() > 1e-6) {
            let ends = [self.low[k] - base[k], self.high[k] - base[k]].map(|x| x / line[k]);
            (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
        }
        [from, to]
    }

    /// Returns the point of `chart.line`, the tangent line of the solution curve, at the middle of
    /// its part inside the box. If the line misses the box, returns a point near it.
    fn deepest_on_line(&self) -> DVec4 {
        let Chart { free, base, line, .. } = *self.chart;
        let [from, to] = self.line_inside();
        let step = (0.5 * (from + to)).clamp(self.low[free] - base[free], self.high[free] - base[free]);
        base + step * line
    }

    /// The distances from a solution, upwards or downwards (`way`) along the free parameter, at
    /// which other solutions may be in the box.
    fn feasible_range(&self, x: DVec4, way: f64) -> [f64; 2] {
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        // slope * d <= room for d >= 0.
        let mut restrict = |slope: f64, room: f64| {
            let room = room + PARAMETER_ROUNDING;
            if slope > 0.0 {
                to = to.min(room / slope);
            } else if room < 0.0 {
                from = if slope < 0.0 { from.max(room / slope) } else { f64::INFINITY };
            }
        };
        for k in 0..4 {
            let [low, high] = self.chart.slopes[k].map(|slope| slope * way);
            let (min, max) = (low.min(high), low.max(high));
            restrict(min, self.high[k] - x[k]);
            restrict(-max, x[k] - self.low[k]);
        }
        if from == f64::INFINITY { [0.0, -1.0] } else { [from, to] }
    }

    /// The exit of the curve from the box, upwards or downwards (`way`) along the free parameter.
    fn find_exit(&self, curve: &LocalCurve, way: f64) -> Option<ArcEnd> {
        let free = self.chart.free;
        // The side towards which a parameter moves.
        let rises = |k: usize| k == free && way > 0.0 || k != free && self.chart.slopes[k][0] * way > 0.0;
        let side = |k: usize| if rises(k) { self.high[k] } else { self.low[k] };
        let leaves = |k: usize| k == free || self.is_monotone(k);
        let inside = curve.x;
        let nearest = |rates: DVec4| {
            let mut best = (free, f64::INFINITY);
            for k in (0..4).filter(|&k| leaves(k)) {
                let step = ((side(k) - inside[k]) / (way * rates[k])).max(0.0);
                best = if step < best.1 { (k, step) } else { best };
            }
            best
        };
        let chord = |step: f64| curve.rates + way * step * curve.bend;
        let (_, roughly) = nearest(curve.rates);
        let (mut through, step) = nearest(chord(roughly));
        let mut guess = inside + way * step * chord(step);
        for _ in 0..8 {
            guess[through] = side(through);
            let (x, frame) = self.equation.solve(guess, through)?;
            let rate = way * self.rates(&frame);
            // Sides that the curve has passed already.
            let passed = |k: usize| {
                if rises(k) { x[k] - side(k) } else { side(k) - x[k] }
            };
            let back = |k: usize| {
                if passed(k) > PARAMETER_ROUNDING { passed(k) / rate[k].abs() } else { 0.0 }
            };
            let earlier = (0..4)
                .filter(|&k| k != through && leaves(k) && back(k) > 0.0)
                .max_by(|&k, &n| back(k).total_cmp(&back(n)));
            let Some(earlier) = earlier else {
                let end = ArcEnd { x, tangent: frame.tangent(), direction: frame.direction() };
                return self.is_valid_exit(inside, x, way).then_some(end);
            };
            guess = x - back(earlier) * rate;
            through = earlier;
        }
        None
    }

    /// Whether an exit is in the box, and in the right direction from the point inside.
    fn is_valid_exit(&self, inside: DVec4, x: DVec4, way: f64) -> bool {
        let free = self.chart.free;
        let within = |k: usize| {
            let slack = if self.is_monotone(k) { 2.0 * PARAMETER_ROUNDING } else { self.margin[k] };
            x[k] >= self.low[k] - slack && x[k] <= self.high[k] + slack
        };
        way * (x[free] - inside[free]) >= -2.0 * PARAMETER_ROUNDING && (0..4).all(within)
    }

    /// Whether the parameters that are not monotone stay in the box between two solutions.
    fn classify_course(&self, frame: &Frame, first: &ArcEnd, last: &ArcEnd) -> Course {
        let free = self.chart.free;
        let length = (last.x[free] - first.x[free]).max(0.0);
        let mut samples = None;
        for k in (0..4).filter(|&k| k != free && !self.is_monotone(k)) {
            let [low, high] = self.chart.slopes[k];
            let (from, to) = (first.x[k], last.x[k]);
            // The highest and the lowest point that the bounds of slopes at both ends allow.
            let until = |slope: f64, other: f64| {
                let time = (to - other * length - from) / (slope - other);
                from + slope * time.clamp(0.0, length)
            };
            let (max, min) = (until(high, low).max(from).max(to), until(low, high).min(from).min(to));
            if min >= self.low[k] - PARAMETER_ROUNDING && max <= self.high[k] + PARAMETER_ROUNDING {
                continue;
            }
            let samples = *samples.get_or_insert_with(|| self.samples(first, last));
            let Some(samples) = samples else {
                return Course::Unknown(Some(k));
            };
            match self.classify_beside_side(k, &samples, frame) {
                Course::Inside => {}
                other => return other,
            }
        }
        Course::Inside
    }

    /// Classifies a curve next to a side across parameter k. A curve that runs along the side
    /// within rounding belongs to the boxes on both sides. A curve that touches it belongs to the
    /// box it comes from. Smaller boxes cut a curve that crosses it. Beside poles, where parameter
    /// lines are close together, such a curve may be close to the side for several resolutions.
    fn classify_beside_side(&self, k: usize, samples: &[DVec4; 5], frame: &Frame) -> Course {
        let close = self.side_distance(frame, k);
        let [min, max] = range(samples.map(|x| x[k]));
        // Halving across k does not bring a curve in the middle that hardly moves in k closer to
        // the sides. Shorter pieces of it have narrower bounds.
        let room = (min - self.low[k]).min(self.high[k] - max);
        let is_central = room >= MIN_ROOM * (self.high[k] - self.low[k]);
        let mut course = Course::Unknown(if is_central { None } else { Some(k) });
        for (side, is_high) in [(self.low[k], false), (self.high[k], true)] {
            if min < side - close || max > side + close {
                continue;
            }
            let (below, above) = (max <= side + ALONG_SIDE_SHARE * close, min >= side - ALONG_SIDE_SHARE * close);
            if !below && !above {
                return Course::Unknown(Some(k));
            }
            let stays = if is_high { below } else { above };
            let outwards = if is_high == stays { 1.0 } else { -1.0 };
            if self.crosses(k, samples, (side, outwards), frame) {
                return Course::Unknown(None);
            }
            if !stays {
                return Course::Outside;
            }
            course = Course::Inside;
        }
        course
    }

    /// Whether a curve clearly rises or falls across a side, and runs farther beyond it than may be
    /// lost. `outwards` is the direction away from the part that would be kept.
    fn crosses(&self, k: usize, samples: &[DVec4; 5], (side, outwards): (f64, f64), frame: &Frame) -> bool {
        let free = self.chart.free;
        let [low, high] = self.chart.slopes[k];
        let [first, .., last] = samples;
        let rise = (last[k] - first[k]).abs();
        if rise <= MIN_SLOPE_SHARE * (high - low) * (last[free] - first[free]) {
            return false;
        }
        let rounding = self.rounding_error * frame.sensitivity(free, k);
        let beyond = |x: &DVec4| outwards * (x[k] - side) - rounding;
        let run = |pair: &[DVec4]| {
            let [from, to] = [0, 1].map(|n| beyond(&pair[n]));
            let (least, most) = (from.min(to), from.max(to));
            if most <= 0.0 {
                return 0.0;
            }
            let share = if least >= 0.0 { 1.0 } else { most / (most - least) };
            share * self.equation.point(pair[0]).distance(self.equation.point(pair[1]))
        };
        samples.windows(2).map(run).sum::<f64>() > self.shortest
    }

    /// Solutions at both ends and at three parameters between them.
    fn samples(&self, first: &ArcEnd, last: &ArcEnd) -> Option<[DVec4; 5]> {
        let mut samples = [first.x; 5];
        for (sample, part) in samples.iter_mut().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
            (*sample, _) = self.equation.solve(first.x.lerp(last.x, part), self.chart.free)?;
        }
        Some(samples)
    }
}

/// The course of the parameters that are not monotone.
enum Course {
    /// All of them stay in the box.
    Inside,
    /// The curve belongs to another box, and touches a side from there.
    Outside,
    /// Undecided. Contains the parameter to halve the box by, if it is known.
    Unknown(Option<usize>),
}
