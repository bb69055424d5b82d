//! The one arc that a graph has within a box.
//!
//! The two points where the curve leaves the box are looked for along the line of the middle, or,
//! if that does not lead to them, from a solution inside. That it does not come back is proved by
//! the bounds of slopes: each parameter either always rises or always falls along the curve, or it
//! stays inside. A curve that runs along a side of the box, to rounding, does neither: it is of the
//! boxes on both sides, and found by each (`overlap`).
//!
//! Cost: a few steps of Newton's method an end, O(N^2 + M^2) each.

use super::chart::{Chart, MARGIN, ParameterBox};
use super::equation::{Equation, Frame};
use glam::{DVec3, DVec4};
use gusset_base::geom::aabb::range;
use gusset_base::geom::subdivision::BoxTest;

/// As much of a cell is rounding where a curve crosses a side.
pub(super) const PARAMETER_ROUNDING: f64 = 1e-13;
/// How many times as near to a side as the noise of a solution points tell nothing.
const ROUNDINGS: f64 = 64.0;
/// How much nearer than [`ArcSearch::close`] to a side a curve is that runs along it.
const ALONG_SIDE_SHARE: f64 = 1.0 / 32.0;
/// A parameter's slope, in widths of its bounds, from which smaller boxes prove that it has a sign.
const MIN_SLOPE_SHARE: f64 = 1.0 / 64.0;

/// Curves that are farther from the sides than this part of a box are in the middle of it.
const MIN_ROOM: f64 = 1.0 / 16.0;

/// A line that is in the box for less of the free parameter tells little of the curve.
const MIN_LINE_SHARE: f64 = 1.0 / 64.0;

/// An end of an arc, and the directions in which it goes on: by parameters, and in space.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub(super) x: DVec4,
    pub(super) tangent: DVec4,
    pub(super) direction: DVec3,
}

/// A solution, and the derivatives there.
type Start = (DVec4, Frame);

/// Nearly how the curve runs by the free parameter f: x + f rates + f^2 bend.
struct LocalCurve {
    x: DVec4,
    rates: DVec4,
    bend: DVec4,
}

/// It cannot be told.
struct Unclear;

/// The part of a graph within a box: nothing but runs that may be lost, or one arc between two
/// ends, by rising free parameter; undecided, the parameter that the box is to be halved by, if
/// that is known.
pub(super) type ArcTest = BoxTest<[End; 2], Option<usize>>;

/// The search for the arc of a box.
pub(super) struct ArcSearch<'a, const N: usize, const M: usize> {
    pub(super) equation: &'a Equation<N, M>,
    pub(super) chart: &'a Chart,
    low: DVec4,
    high: DVec4,
    margin: DVec4,
    /// Runs of a curve beyond a side up to this may be lost, or be found twice.
    shortest: f64,
    rounding_error: f64,
    /// A length: where curves are as near to a side, points of them tell whether they run along it.
    close: f64,
}

impl<'a, const N: usize, const M: usize> ArcSearch<'a, N, M> {
    /// `shortest`: arcs up to this may be lost; `rounding_error`: lengths up to that may be
    /// rounding.
    pub(super) fn new(
        equation: &'a Equation<N, M>,
        part: &ParameterBox<N, M>,
        chart: &'a Chart,
        [resolution, shortest]: [f64; 2],
        rounding_error: f64,
    ) -> Self {
        let (low, high) = (part.low, part.low + part.size);
        // Directions across a side are hardly ever as flat to the curve as 1 to 16: what runs along
        // a side is nearer than 16 times the noise.
        let close = (1e-3 * resolution).max(512.0 * rounding_error);
        ArcSearch { equation, chart, low, high, margin: MARGIN * part.size, shortest, rounding_error, close }
    }

    /// The arc, if the line of the middle leads to its ends: the usual case. `middle`: the
    /// derivatives in the middle of the box.
    pub(super) fn along_line(&self, middle: &Frame) -> Option<ArcTest> {
        let Chart { free, base, line, .. } = *self.chart;
        let [from, to] = self.line_inside();
        if to - from < MIN_LINE_SHARE * (self.high[free] - self.low[free]) {
            return None;
        }
        let half = 0.5 * (from + to);
        let first = self.exit(&LocalCurve { x: base + half * line, rates: line, bend: DVec4::ZERO }, -1.0)?;
        // The parabola that has the slopes at this end and in the middle.
        let rates = first.tangent / first.tangent[free];
        let bend = (line - rates) / (2.0 * (base[free] - first.x[free]));
        let step = base[free] + half - first.x[free];
        let x = first.x + step * (rates + step * bend);
        let last = self.exit(&LocalCurve { x, rates: rates + 2.0 * step * bend, bend }, 1.0)?;
        Some(self.found(middle, first, last))
    }

    /// The same from a solution inside.
    pub(super) fn through_inside(&self, middle: &Frame) -> ArcTest {
        let (x, frame) = match self.start() {
            Ok(Some(start)) => start,
            Ok(None) => return BoxTest::Empty,
            Err(Unclear) => return BoxTest::Undecided(None),
        };
        let curve = LocalCurve { x, rates: self.rates(&frame), bend: DVec4::ZERO };
        match (self.exit(&curve, -1.0), self.exit(&curve, 1.0)) {
            (Some(first), Some(last)) => self.found(middle, first, last),
            _ => BoxTest::Undecided(None),
        }
    }

    /// Classifies a curve that leaves the box at these ends.
    fn found(&self, middle: &Frame, first: End, last: End) -> ArcTest {
        match self.stays(middle, &first, &last) {
            Stay::Inside => BoxTest::Unique([first, last]),
            Stay::Outside => BoxTest::Empty,
            Stay::Unknown(k) => BoxTest::Undecided(k),
        }
    }

    /// The slopes of all parameters by the free one.
    fn rates(&self, frame: &Frame) -> DVec4 {
        let tangent = frame.tangent();
        tangent / tangent[self.chart.free]
    }

    /// True if a parameter surely rises, or surely falls, with the free one.
    fn is_monotone(&self, k: usize) -> bool {
        let [low, high] = self.chart.slopes[k];
        low > 0.0 || high < 0.0
    }

    /// The parameter of [`ArcSearch::close`], or what may be rounding where the surfaces are nearly
    /// parallel.
    fn close(&self, frame: &Frame, k: usize) -> f64 {
        let rounding = self.rounding_error * frame.sensitivity(self.chart.free, k);
        (self.close / frame.columns[k].length()).max(ROUNDINGS * rounding).min(1e-3)
    }

    /// A solution inside the box, if there is one worth the while.
    fn start(&self) -> Result<Option<Start>, Unclear> {
        let free = self.chart.free;
        let mut guess = self.on_line();
        for _ in 0..4 {
            let Some((x, frame)) = self.equation.solve(guess, free) else {
                return Err(Unclear);
            };
            if x.cmplt(self.low - self.margin).any() || x.cmpgt(self.high + self.margin).any() {
                return Err(Unclear);
            }
            let slack = |k: usize| {
                if self.is_monotone(k) { PARAMETER_ROUNDING } else { self.close(&frame, k) }
            };
            if (0..4).all(|k| x[k] >= self.low[k] - slack(k) && x[k] <= self.high[k] + slack(k)) {
                return Ok(Some((x, frame)));
            }
            // Where else it may be, by the bounds of slopes.
            let parts = [-1.0, 1.0].map(|way| (way, self.permitted(x, way)));
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

    /// Where the line of the middle is inside the box, by the free parameter, from its middle on;
    /// if it is nowhere, the first is the greater.
    fn line_inside(&self) -> [f64; 2] {
        let Chart { free, base, line, .. } = *self.chart;
        let (mut from, mut to) = (self.low[free] - base[free], self.high[free] - base[free]);
        for k in (0..4).filter(|&k| k != free && line[k].abs() > 1e-6) {
            let ends = [self.low[k] - base[k], self.high[k] - base[k]].map(|x| x / line[k]);
            (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
        }
        [from, to]
    }

    /// Where the line of the middle is deepest inside the box, or comes nearest to it.
    fn on_line(&self) -> DVec4 {
        let Chart { free, base, line, .. } = *self.chart;
        let [from, to] = self.line_inside();
        let step = (0.5 * (from + to)).clamp(self.low[free] - base[free], self.high[free] - base[free]);
        base + step * line
    }

    /// From a solution, how far along the free parameter, upwards or downwards (`way`), others may
    /// be in the box.
    fn permitted(&self, x: DVec4, way: f64) -> [f64; 2] {
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

    /// Where the curve leaves the box upwards or downwards (`way`) by the free parameter.
    fn exit(&self, curve: &LocalCurve, way: f64) -> Option<End> {
        let free = self.chart.free;
        // The side that a parameter moves to.
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
            // The sides passed before.
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
                let end = End { x, tangent: frame.tangent(), direction: frame.direction() };
                return self.sound(inside, x, way).then_some(end);
            };
            guess = x - back(earlier) * rate;
            through = earlier;
        }
        None
    }

    /// Whether a point where the curve leaves is on the right side of the one inside, and itself in
    /// the box.
    fn sound(&self, inside: DVec4, x: DVec4, way: f64) -> bool {
        let free = self.chart.free;
        let within = |k: usize| {
            let slack = if self.is_monotone(k) { 2.0 * PARAMETER_ROUNDING } else { self.margin[k] };
            x[k] >= self.low[k] - slack && x[k] <= self.high[k] + slack
        };
        way * (x[free] - inside[free]) >= -2.0 * PARAMETER_ROUNDING && (0..4).all(within)
    }

    /// Whether the parameters that are not monotone stay in the box between two solutions.
    fn stays(&self, frame: &Frame, first: &End, last: &End) -> Stay {
        let free = self.chart.free;
        let length = (last.x[free] - first.x[free]).max(0.0);
        let mut samples = None;
        for k in (0..4).filter(|&k| k != free && !self.is_monotone(k)) {
            let [low, high] = self.chart.slopes[k];
            let (from, to) = (first.x[k], last.x[k]);
            // The highest and the lowest point of the two cones of slopes.
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
                return Stay::Unknown(Some(k));
            };
            match self.beside(k, &samples, frame) {
                Stay::Inside => {}
                other => return other,
            }
        }
        Stay::Inside
    }

    /// Classifies a curve next to a side across parameter k: if it runs along it, to rounding, it
    /// is of the boxes on both sides; if it touches it, of the box that it comes from. One that
    /// crosses it is cut there by smaller boxes: beside poles, where lines of parameters are near
    /// together, it may be that near to the side for several resolutions.
    fn beside(&self, k: usize, samples: &[DVec4; 5], frame: &Frame) -> Stay {
        let close = self.close(frame, k);
        let [min, max] = range(samples.map(|x| x[k]));
        // Halved across k, a curve that is in the middle, and hardly moves that way, comes no
        // farther from the sides: shorter pieces of it have narrower bounds.
        let room = (min - self.low[k]).min(self.high[k] - max);
        let is_central = room >= MIN_ROOM * (self.high[k] - self.low[k]);
        let mut all = Stay::Unknown(if is_central { None } else { Some(k) });
        for (side, is_high) in [(self.low[k], false), (self.high[k], true)] {
            if min < side - close || max > side + close {
                continue;
            }
            let (below, above) = (max <= side + ALONG_SIDE_SHARE * close, min >= side - ALONG_SIDE_SHARE * close);
            if !below && !above {
                return Stay::Unknown(Some(k));
            }
            let stays = if is_high { below } else { above };
            let outwards = if is_high == stays { 1.0 } else { -1.0 };
            if self.crosses(k, samples, (side, outwards), frame) {
                return Stay::Unknown(None);
            }
            if !stays {
                return Stay::Outside;
            }
            all = Stay::Inside;
        }
        all
    }

    /// Whether a curve clearly rises or falls across a side, with more of it beyond, to the side
    /// that it is said not to be on, than may be lost.
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

    /// Both ends and three points between them.
    fn samples(&self, first: &End, last: &End) -> Option<[DVec4; 5]> {
        let mut samples = [first.x; 5];
        for (sample, part) in samples.iter_mut().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
            (*sample, _) = self.equation.solve(first.x.lerp(last.x, part), self.chart.free)?;
        }
        Some(samples)
    }
}

/// The course of parameters that are not monotone.
enum Stay {
    /// They stay in the box.
    Inside,
    /// The curve touches a side from another box.
    Outside,
    /// It cannot be told: the box is to be halved by this parameter, if that is known.
    Unknown(Option<usize>),
}
