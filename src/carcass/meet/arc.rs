//! The one arc that a graph has within a box.
//!
//! A solution inside is looked for, and from there the two points where the curve leaves the box. That it does not come back is proved by the
//! bounds of slopes: each parameter either always rises or always falls along the curve, or it stays inside. A parameter that does neither
//! because the curve runs along a side of the box, to rounding, belongs to the box above that side.

use super::chart::{Chart, MARGIN, Part};
use super::equation::{Equation, Frame};
use glam::DVec4;

/// As much of a cell is rounding where a curve runs along a side.
const CLOSE: f64 = 1e-10;
/// As much of a cell is rounding where it crosses one.
const ROUNDING: f64 = 1e-12;

/// An end of an arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub(super) x: DVec4,
    pub(super) frame: Frame,
}

/// What a graph has within a box.
pub(super) enum Found {
    /// Nothing that is longer than the tolerance.
    Nothing,
    /// One arc between two ends, by rising free parameter.
    Arc([End; 2]),
    /// It cannot be told.
    Open,
}

/// The search for the arc of a box.
pub(super) struct Search<'a, const N: usize, const M: usize> {
    pub(super) equation: &'a Equation<N, M>,
    pub(super) chart: &'a Chart,
    low: DVec4,
    high: DVec4,
    margin: DVec4,
    tolerance: f64,
    /// By parameter: whether another box follows above this one.
    followed: [bool; 4],
}

impl<'a, const N: usize, const M: usize> Search<'a, N, M> {
    /// `followed`: by parameter, whether there is a cell above the whole cell.
    pub(super) fn new(
        equation: &'a Equation<N, M>,
        part: &Part<N, M>,
        chart: &'a Chart,
        tolerance: f64,
        followed: [bool; 4],
    ) -> Self {
        let (low, high) = (part.low, part.low + part.size);
        let followed = std::array::from_fn(|k| followed[k] || high[k] < 1.0);
        Search { equation, chart, low, high, margin: MARGIN * part.size, tolerance, followed }
    }

    /// The arc.
    pub(super) fn arc(&self) -> Found {
        let inside = match self.inside() {
            Ok(end) => end,
            Err(verdict) => return verdict,
        };
        let (Some(first), Some(last)) = (self.exit(&inside, -1.0), self.exit(&inside, 1.0)) else {
            return Found::Open;
        };
        match self.stays(&first, &last) {
            Stay::Inside => Found::Arc([first, last]),
            Stay::Next => Found::Nothing,
            Stay::Unknown => Found::Open,
        }
    }

    /// True if a parameter surely rises, or surely falls, with the free one.
    fn is_monotone(&self, k: usize) -> bool {
        let [low, high] = self.chart.slopes[k];
        low > 0.0 || high < 0.0
    }

    /// A solution inside the box.
    fn inside(&self) -> Result<End, Found> {
        let free = self.chart.free;
        let mut guess = self.on_line();
        for _ in 0..4 {
            let Some((x, frame)) = self.equation.solve(guess, free) else { return Err(Found::Open) };
            if x.cmplt(self.low - self.margin).any() || x.cmpgt(self.high + self.margin).any() {
                return Err(Found::Open);
            }
            let play = |k: usize| if self.is_monotone(k) { ROUNDING } else { 4.0 * CLOSE };
            if (0..4).all(|k| x[k] >= self.low[k] - play(k) && x[k] <= self.high[k] + play(k)) {
                return Ok(End { x, frame });
            }
            // Where else it may be, by the bounds of slopes.
            let parts = [-1.0, 1.0].map(|way| (way, self.permitted(x, way)));
            let longest = parts.into_iter().max_by(|a, b| (a.1[1] - a.1[0]).total_cmp(&(b.1[1] - b.1[0])));
            let Some((way, [from, to])) = longest else { return Err(Found::Open) };
            let speed = frame.direction().length() / frame.tangent()[free].abs();
            if !((to - from) * speed > 0.25 * self.tolerance) {
                return Err(if to - from < f64::INFINITY { Found::Nothing } else { Found::Open });
            }
            let step = way * 0.5 * (from + to);
            let tangent = frame.tangent();
            guess = x + step * tangent / tangent[free];
            guess[free] = x[free] + step;
        }
        Err(Found::Open)
    }

    /// Where the line of the middle is deepest inside the box, or comes nearest to it.
    fn on_line(&self) -> DVec4 {
        let Chart { free, base, line, .. } = *self.chart;
        let (mut from, mut to) = (self.low[free] - base[free], self.high[free] - base[free]);
        for k in (0..4).filter(|&k| k != free && line[k].abs() > 1e-6) {
            let ends = [self.low[k] - base[k], self.high[k] - base[k]].map(|x| x / line[k]);
            (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
        }
        let step = (0.5 * (from + to)).clamp(self.low[free] - base[free], self.high[free] - base[free]);
        base + step * line
    }

    /// From a solution, how far along the free parameter, upwards or downwards (`way`), others may be in the box.
    fn permitted(&self, x: DVec4, way: f64) -> [f64; 2] {
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        // slope * d <= room for d >= 0.
        let mut restrict = |slope: f64, room: f64| {
            let room = room + ROUNDING;
            if slope > 0.0 {
                to = to.min(room / slope);
            } else if room < 0.0 {
                from = if slope < 0.0 { from.max(room / slope) } else { f64::INFINITY };
            }
        };
        for k in 0..4 {
            let [low, high] = self.chart.slopes[k].map(|slope| slope * way);
            let (least, most) = (low.min(high), low.max(high));
            restrict(least, self.high[k] - x[k]);
            restrict(-most, x[k] - self.low[k]);
        }
        if from == f64::INFINITY { [0.0, -1.0] } else { [from, to] }
    }

    /// Where the curve leaves the box upwards or downwards (`way`) by the free parameter.
    fn exit(&self, inside: &End, way: f64) -> Option<End> {
        let free = self.chart.free;
        let rates = |frame: &Frame| {
            let tangent = frame.tangent();
            way * tangent / tangent[free]
        };
        // The side that a parameter moves to.
        let rises = |k: usize| k == free && way > 0.0 || k != free && self.chart.slopes[k][0] * way > 0.0;
        let side = |k: usize| if rises(k) { self.high[k] } else { self.low[k] };
        let leaves = |k: usize| k == free || self.is_monotone(k);
        let rate = rates(&inside.frame);
        let step = |k: usize| ((side(k) - inside.x[k]) / rate[k]).max(0.0);
        let first = (0..4).filter(|&k| leaves(k)).min_by(|&k, &n| step(k).total_cmp(&step(n)))?;
        let mut through = first;
        let mut guess = inside.x + step(first) * rate;
        for _ in 0..8 {
            guess[through] = side(through);
            let (x, frame) = self.equation.solve(guess, through)?;
            let rate = rates(&frame);
            // What it has passed before it comes here.
            let passed = |k: usize| if rises(k) { x[k] - side(k) } else { side(k) - x[k] };
            let back = |k: usize| if passed(k) > ROUNDING { passed(k) / rate[k].abs() } else { 0.0 };
            let earlier = (0..4)
                .filter(|&k| k != through && leaves(k) && back(k) > 0.0)
                .max_by(|&k, &n| back(k).total_cmp(&back(n)));
            let Some(earlier) = earlier else {
                return self.sound(inside, x, way).then_some(End { x, frame });
            };
            guess = x - back(earlier) * rate;
            through = earlier;
        }
        None
    }

    /// Whether a point where the curve leaves is on the right side of the one inside, and itself in the box.
    fn sound(&self, inside: &End, x: DVec4, way: f64) -> bool {
        let free = self.chart.free;
        let within = |k: usize| {
            let play = if self.is_monotone(k) { 2.0 * ROUNDING } else { self.margin[k] };
            x[k] >= self.low[k] - play && x[k] <= self.high[k] + play
        };
        way * (x[free] - inside.x[free]) >= -2.0 * ROUNDING && (0..4).all(within)
    }

    /// Whether the parameters that are not monotone stay in the box between two solutions.
    fn stays(&self, first: &End, last: &End) -> Stay {
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
            let (most, least) = (until(high, low).max(from).max(to), until(low, high).min(from).min(to));
            if least >= self.low[k] - ROUNDING && most <= self.high[k] + ROUNDING {
                continue;
            }
            let samples = *samples.get_or_insert_with(|| self.samples(first, last));
            let Some(samples) = samples else { return Stay::Unknown };
            let along = |side: f64, play: f64| samples.iter().all(|x| (x[k] - side).abs() <= play);
            if self.followed[k] && along(self.high[k], CLOSE) {
                return Stay::Next;
            }
            let at_top = !self.followed[k] && along(self.high[k], 4.0 * CLOSE);
            if !(at_top || along(self.low[k], 4.0 * CLOSE)) {
                return Stay::Unknown;
            }
        }
        Stay::Inside
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

/// What parameters do that are not monotone.
enum Stay {
    /// They stay in the box.
    Inside,
    /// The curve runs along a side, and belongs to the next box.
    Next,
    /// It cannot be told.
    Unknown,
}
