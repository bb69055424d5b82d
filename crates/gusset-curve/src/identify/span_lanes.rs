//! Tests of many plane spans at once: which may cross themselves, the next one, or the next but one.
//!
//! The control points of a span are in columns, so that each test is a loop over spans without
//! branches. A line that separates the control points of two spans settles that they do not cross.

use gusset_base::simd::Kernel;

/// The spans that are tested at once.
pub(super) const SPANS_PER_TEST: usize = 8;
/// These and two more, up to a multiple of 4.
const LANES: usize = 12;

/// The control points of consecutive spans.
#[derive(Clone)]
pub(super) struct SpanLanes<const H: usize> {
    /// The coordinates of the control points, span by span in each row.
    x: [[f64; LANES]; H],
    y: [[f64; LANES]; H],
    /// The spans whose control points are not known, by their bits.
    unknown_span_bits: u32,
}

/// The spans that may cross, by their bits.
#[derive(Clone, Copy)]
pub(super) struct MayCross {
    pub(super) spans_and_themselves: u32,
    pub(super) spans_and_next: u32,
    pub(super) spans_and_next_but_one: u32,
}

impl<const H: usize> SpanLanes<H> {
    pub(super) fn new() -> Self {
        SpanLanes { x: [[0.0; LANES]; H], y: [[0.0; LANES]; H], unknown_span_bits: 0 }
    }

    pub(super) fn set_span(&mut self, lane: usize, points: Option<&[glam::DVec2; H]>) {
        self.unknown_span_bits &= !(1 << lane);
        match points {
            Some(points) => {
                for (i, p) in points.iter().enumerate() {
                    (self.x[i][lane], self.y[i][lane]) = (p.x, p.y);
                }
            }
            None => self.unknown_span_bits |= 1 << lane,
        }
    }
}

impl<const H: usize> Kernel for &SpanLanes<H> {
    type Output = MayCross;

    #[inline(always)]
    fn run(self) -> MayCross {
        let itself = self.itself();
        let next = self.next();
        let farther = self.next_but_one();
        let unknown = self.unknown_span_bits;
        MayCross {
            spans_and_themselves: itself | unknown,
            spans_and_next: next | unknown | unknown >> 1,
            spans_and_next_but_one: farther | unknown | unknown >> 1 | unknown >> 2,
        }
    }
}

/// A vector.
type Pair = (f64, f64);

#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn dot(a: Pair, b: Pair) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

#[inline(always)]
fn cross(a: Pair, b: Pair) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

#[inline(always)]
fn minus(a: Pair, b: Pair) -> Pair {
    (a.0 - b.0, a.1 - b.1)
}

/// The outermost vectors on both sides of a tangent.
struct OutermostVectors {
    tangent: Pair,
    leftmost: Pair,
    rightmost: Pair,
    /// Whether a vector opposes the tangent.
    has_opposing_vector: bool,
}

impl OutermostVectors {
    #[inline(always)]
    fn add_vector(&mut self, v: Pair) {
        let side = cross(self.tangent, v);
        let is_left = (side > 0.0) & (cross(self.leftmost, v) > 0.0);
        let is_right = (side < 0.0) & (cross(self.rightmost, v) < 0.0);
        self.leftmost = (if is_left { v.0 } else { self.leftmost.0 }, if is_left { v.1 } else { self.leftmost.1 });
        self.rightmost = (if is_right { v.0 } else { self.rightmost.0 }, if is_right { v.1 } else { self.rightmost.1 });
        self.has_opposing_vector |= (side == 0.0) & (dot(self.tangent, v) < 0.0);
    }
}

/// The bits of the negative scores.
#[inline(always)]
fn bits_of_negative_scores(scores: &[f64; SPANS_PER_TEST]) -> u32 {
    let mut bits = 0;
    for (k, &score) in scores.iter().enumerate() {
        bits |= u32::from(score < 0.0) << k;
    }
    bits
}

impl<const H: usize> SpanLanes<H> {
    /// Control point i of span k.
    #[inline(always)]
    fn control_point(&self, i: usize, k: usize) -> Pair {
        (self.x[i][k], self.y[i][k])
    }

    /// A span that advances along its chord, or turns by less than a half turn, does not cross itself.
    #[inline(always)]
    fn itself(&self) -> u32 {
        let mut scores = [0.0; SPANS_PER_TEST];
        for (k, score) in scores.iter_mut().enumerate() {
            let chord = minus(self.control_point(H - 1, k), self.control_point(0, k));
            let mut advance = f64::INFINITY;
            for i in 0..H - 1 {
                advance = min(advance, dot(minus(self.control_point(i + 1, k), self.control_point(i, k)), chord));
            }
            if H == 4 {
                let [a, b, c] = [0, 1, 2];
                let (a, b, c) = (
                    minus(self.control_point(a + 1, k), self.control_point(a, k)),
                    minus(self.control_point(b + 1, k), self.control_point(b, k)),
                    minus(self.control_point(c + 1, k), self.control_point(c, k)),
                );
                let (first, second, both) = (cross(a, b), cross(b, c), cross(a, c));
                let sides = first * second;
                // Turns to opposite sides, or to one side by less than a half turn together.
                let turn = if sides < 0.0 { 1.0 } else { first * both };
                let turn = if sides == 0.0 { -1.0 } else { turn };
                advance = max(advance, turn);
            }
            *score = advance;
        }
        bits_of_negative_scores(&scores)
    }

    /// Spans do not cross if a line through their common point separates them: if the vectors from the control points
    /// of the first to the common point, and from there to the control points of the next one, are within a half turn.
    #[inline(always)]
    fn next(&self) -> u32 {
        let mut scores = [0.0; SPANS_PER_TEST];
        for (k, score) in scores.iter_mut().enumerate() {
            let shared = self.control_point(0, k + 1);
            let tangent = minus(self.control_point(1, k + 1), self.control_point(H - 2, k));
            let mut sides = OutermostVectors {
                tangent,
                leftmost: tangent,
                rightmost: tangent,
                has_opposing_vector: dot(tangent, tangent) <= 0.0,
            };
            for i in 0..H - 1 {
                sides.add_vector(minus(shared, self.control_point(i, k)));
                sides.add_vector(minus(self.control_point(i + 1, k + 1), shared));
            }
            *score = if sides.has_opposing_vector { -1.0 } else { cross(sides.rightmost, sides.leftmost) };
        }
        bits_of_negative_scores(&scores)
    }

    /// Spans do not cross if a line along or across the chord between them separates them. Spans
    /// whose chords turn by a half turn or more are not compared.
    #[inline(always)]
    fn next_but_one(&self) -> u32 {
        let mut scores = [0.0; SPANS_PER_TEST];
        for (k, score) in scores.iter_mut().enumerate() {
            let (end, start) = (self.control_point(0, k + 1), self.control_point(0, k + 2));
            let (a, b, c) = (
                minus(end, self.control_point(0, k)),
                minus(start, end),
                minus(self.control_point(H - 1, k + 2), start),
            );
            let (first, second, both) = (cross(a, b), cross(b, c), cross(a, c));
            let sides = first * second;
            // Across the chord if the line turns to both sides, else along it.
            let normal = if sides < 0.0 { (-b.1, b.0) } else { b };
            let apart = max(
                self.gap_along_normal(k, normal),
                max(self.gap_along_normal(k, (-a.1, a.0)), self.gap_along_normal(k, (-c.1, c.0))),
            );
            let is_turn = sides > 0.0 && first * both <= 0.0;
            *score = if is_turn { 1.0 } else { apart };
        }
        bits_of_negative_scores(&scores)
    }

    /// Negative, unless a line with a normal separates span k from the next but one.
    #[inline(always)]
    fn gap_along_normal(&self, k: usize, normal: Pair) -> f64 {
        let end = self.control_point(0, k + 1);
        let (mut own_high, mut own_low) = (f64::NEG_INFINITY, f64::INFINITY);
        let (mut high, mut low) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..H {
            let own = dot(minus(self.control_point(i, k), end), normal);
            let other = dot(minus(self.control_point(i, k + 2), end), normal);
            (own_high, own_low) = (max(own_high, own), min(own_low, own));
            (high, low) = (max(high, other), min(low, other));
        }
        max(low - own_high, own_low - high)
    }
}
