//! Proofs about A = B over a box of parameters.
//!
//! * *Nothing there*: two flat pieces are apart exactly if one of six directions shows it: the
//!   normals, and the products of a side of the one with a side of the other. Each takes two of the
//!   four parameters out of the equation; the control nets are compared along it.
//! * *A graph*: take the parameter along which the curve runs as the free one, and multiply the
//!   equation by the inverse of the derivatives by the other three, x, in the middle. If the
//!   derivatives by x stay near the identity (a dominant diagonal) all over the box, then x is a
//!   function of the free parameter on the solutions: no loop can be there. The quotients of
//!   differences of any two solutions are bounded by the same intervals as the slopes, which tells
//!   whether the curve can come back through a side that it left by.
//!
//! As A - B is the difference of functions of different parameters, its bounds are the sums of
//! bounds over control nets.
//!
//! The second is interval Newton's contraction in the form of a dominant diagonal (Krawczyk 1969;
//! Hanniel and Elber 2007). Cost: O(N^2 + M^2) a test, O(N^3 + M^3) a split.

use super::coordinate_net::Net;
use super::equation::{Equation, Frame, OTHERS};
use crate::Patch;
use crate::subdivision::Field;
use glam::{DVec3, DVec4};
use gusset_base::geom::subdivision::BoxTest;

/// How far outside a box a graph is proved, as a fraction of the box.
pub(super) const MARGIN: f64 = 1.0 / 32.0;

/// A box of parameters, and the control nets over it.
#[derive(Clone)]
pub(super) struct ParameterBox<const N: usize, const M: usize> {
    pub(super) nets: Equation<N, M>,
    pub(super) low: DVec4,
    pub(super) size: DVec4,
}

/// A proof that the solutions in a box, and within [`MARGIN`] of it, are a graph.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chart {
    /// The parameter of which the others are functions.
    pub(super) free: usize,
    /// Where the line of the middle is when the free parameter is in the middle.
    pub(super) base: DVec4,
    /// The slopes of that line.
    pub(super) line: DVec4,
    /// Bounds of the slopes; 1 for the free parameter.
    pub(super) slopes: [[f64; 2]; 4],
}

/// Proof that a box holds no solution, or that its solutions are a graph.
pub(super) type ChartTest = BoxTest<Chart, ()>;

/// How much wider the range of a polynomial's coefficients, of total degree `degree`, may be over a
/// box that is wider by [`MARGIN`] on each side: the weights of extrapolation sum to 1, and their
/// absolute values to (1 + 2 m)^degree.
fn growth(degree: usize) -> f64 {
    (0..degree).fold(1.0, |product, _| product * (1.0 + 2.0 * MARGIN))
}

fn scaled_about_middle([low, high]: [f64; 2], by: f64) -> [f64; 2] {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low) * by);
    [middle - half, middle + half]
}

/// How far the values of two fields are apart: negative if their bounds overlap.
fn gap<const N: usize, const M: usize>(a: &Field<N>, b: &Field<M>) -> f64 {
    let ([low, high], [others_low, others_high]) = (a.range(), b.range());
    let (above, below) = (low - others_high, others_low - high);
    if above > below { above } else { below }
}

/// The component with the greatest absolute value.
fn max(tangent: DVec4) -> usize {
    (0..4).fold(0, |best, k| if tangent[k].abs() > tangent[best].abs() { k } else { best })
}

impl<const N: usize, const M: usize> ParameterBox<N, M> {
    /// All of two patches, still to be set.
    pub(super) const WHOLE: Self =
        ParameterBox { nets: Equation { a: Net::ZERO, b: Net::ZERO }, low: DVec4::ZERO, size: DVec4::ONE };

    pub(super) fn middle(&self) -> DVec4 {
        self.low + 0.5 * self.size
    }

    /// Tests the box. `frame`: in the middle, by the parameters of the cells; `rounding_error`:
    /// lengths up to that may be rounding; `tolerance`: surfaces that are nearer to each other and
    /// may be parallel may touch.
    pub(super) fn prove(&self, frame: &Frame, rounding_error: f64, tolerance: f64) -> ChartTest {
        let mut columns = frame.columns;
        (0..4).for_each(|k| columns[k] *= self.size[k]);
        let tangent = Frame { columns, ..*frame }.tangent();
        let free = max(tangent);
        let others = OTHERS[free];
        let [x, y, z] = others.map(|k| columns[k]);
        let normals = [y.cross(z), z.cross(x), x.cross(y)];
        let lengths = x.length() * y.length() * z.length();
        let determinant = x.dot(normals[0]);
        let regular = determinant.abs() > 1e-10 * lengths;
        let rows = normals.map(|normal| if regular { normal / determinant } else { normal });

        let (a, b) = (rows.map(|row| self.nets.a.along(row)), rows.map(|row| self.nets.b.along(row)));
        let mut is_apart = false;
        for k in 0..3 {
            let (gap, length) = (gap(&a[k], &b[k]), rows[k].length());
            if gap > tolerance * length {
                return BoxTest::Empty;
            }
            is_apart |= gap > rounding_error * length;
        }
        if !regular {
            // Of degenerate pieces some directions are 0: at least the boxes must meet.
            let apart = || DVec3::AXES.into_iter().any(|axis| self.separated(axis, tolerance));
            return if self.is_apart(frame, tolerance) || apart() { BoxTest::Empty } else { BoxTest::Undecided(()) };
        }
        let line = others.map(|k| tangent[k] / tangent[free]);
        let Some(slopes) = slopes(&a, &b, others, free) else {
            return if self.is_apart(frame, tolerance) { BoxTest::Empty } else { BoxTest::Undecided(()) };
        };
        // The surfaces are nowhere parallel.
        if is_apart {
            return BoxTest::Empty;
        }
        let mut chart = Chart { free, base: self.middle(), line: DVec4::ONE, slopes: [[1.0; 2]; 4] };
        for (k, &other) in others.iter().enumerate() {
            // From parts of the box to parameters of the cells.
            let scale = self.size[other] / self.size[free];
            chart.base[other] -= rows[k].dot(frame.miss) * self.size[other];
            chart.line[other] = line[k] * scale;
            chart.slopes[other] = slopes[k].map(|slope| slope * scale);
        }
        BoxTest::Unique(chart)
    }

    /// True if there is no solution, as the directions show that [`ParameterBox::prove`] does not
    /// try of graphs: products with the one of the derivatives that the curve runs along.
    pub(super) fn is_apart(&self, frame: &Frame, rounding_error: f64) -> bool {
        let columns: [DVec3; 4] = std::array::from_fn(|k| frame.columns[k] * self.size[k]);
        let tangent = Frame { columns, ..*frame }.tangent();
        let free = max(tangent);
        OTHERS[free].into_iter().any(|k| self.separated(columns[k].cross(columns[free]), rounding_error))
            || self.is_beside(frame, rounding_error)
    }

    /// True if the pieces are side by side: apart along a direction in a tangent plane, across a
    /// side of the one.
    fn is_beside(&self, frame: &Frame, rounding_error: f64) -> bool {
        let normals = frame.normals();
        (0..4).any(|k| self.separated(normals[k / 2].cross(frame.columns[k]), rounding_error))
    }

    fn separated(&self, axis: DVec3, rounding_error: f64) -> bool {
        gap(&self.nets.a.along(axis), &self.nets.b.along(axis)) > rounding_error * axis.length()
    }

    /// True if each piece lies between two planes that are `thickness` apart, along the one's
    /// normal and along the other's, and they are within `tolerance` of each other there: how they
    /// meet is below the tolerance.
    pub(super) fn is_within(&self, frame: &Frame, thickness: f64, tolerance: f64) -> bool {
        let thin = |normal: DVec3| {
            let (a, b) = (self.nets.a.along(normal).range(), self.nets.b.along(normal).range());
            let thickest = (a[1] - a[0]).max(b[1] - b[0]);
            thickest <= thickness && a[1].max(b[1]) - a[0].min(b[0]) <= tolerance + 2.0 * thickness
        };
        frame.normals().into_iter().all(|normal| normal.try_normalize().is_some_and(thin))
    }

    /// How long the pieces may be in the four directions, nearly: by the longest legs of the
    /// control nets.
    pub(super) fn extents(&self) -> [f64; 4] {
        let ([s, t], [u, v]) = (legs(&self.nets.a.patch()), legs(&self.nets.b.patch()));
        [s, t, u, v]
    }

    /// Whether points are all on one side of the box, but for a slack.
    pub(super) fn has_on_side(&self, points: [DVec4; 2], slack: f64) -> bool {
        let on = |side: DVec4| points.map(|x| (x - side).abs().cmple(DVec4::splat(slack)));
        [self.low, self.low + self.size].map(on).into_iter().any(|[first, last]| (first & last).any())
    }

    /// The halves by parameter k.
    pub(super) fn halves(&self, k: usize) -> [Self; 2] {
        let mut parts = [self.clone(), self.clone()];
        let Equation { a, b } = &self.nets;
        match k {
            0 => [parts[0].nets.a, parts[1].nets.a] = a.halves(),
            1 => [parts[0].nets.a, parts[1].nets.a] = a.transposed().halves().map(|half| half.transposed()),
            2 => [parts[0].nets.b, parts[1].nets.b] = b.halves(),
            _ => [parts[0].nets.b, parts[1].nets.b] = b.transposed().halves().map(|half| half.transposed()),
        }
        let half = 0.5 * self.size[k];
        parts[1].low[k] += half;
        parts.iter_mut().for_each(|part| part.size[k] = half);
        parts
    }
}

/// The longest legs of a net, in u and in v, times their number.
fn legs<const N: usize>(patch: &Patch<N>) -> [f64; 2] {
    let points = &patch.points;
    let mut longest = [0.0_f64; 2];
    for a in 0..N {
        for b in 0..N {
            if a + 1 < N {
                longest[0] = longest[0].max(points[a + 1][b].distance_squared(points[a][b]));
            }
            if b + 1 < N {
                longest[1] = longest[1].max(points[a][b + 1].distance_squared(points[a][b]));
            }
        }
    }
    longest.map(|square| square.sqrt() * (N - 1) as f64)
}

/// Bounds of the slopes of three parameters by the free one, by parts of the box; `None` if the
/// diagonal may not be dominant.
fn slopes<const N: usize, const M: usize>(
    a: &[Field<N>; 3],
    b: &[Field<M>; 3],
    others: [usize; 3],
    free: usize,
) -> Option<[[f64; 2]; 3]> {
    let (growth_a, growth_b) = (growth(2 * N - 3), growth(2 * M - 3));
    // (I + E) x' = r, |E| <= errors.
    let (mut errors, mut right) = ([[0.0; 3]; 3], [[0.0; 2]; 3]);
    for k in 0..3 {
        let ([s, t], [u, v]) = (a[k].slope_ranges(), b[k].slope_ranges());
        let (of_a, of_b) =
            ([s, t].map(|x| scaled_about_middle(x, growth_a)), [u, v].map(|x| scaled_about_middle(x, growth_b)));
        let columns = [of_a[0], of_a[1], [-of_b[0][1], -of_b[0][0]], [-of_b[1][1], -of_b[1][0]]];
        for (n, &other) in others.iter().enumerate() {
            let identity = if n == k { 1.0 } else { 0.0 };
            let [low, high] = columns[other];
            errors[k][n] = (low - identity).abs().max((high - identity).abs());
        }
        right[k] = [-columns[free][1], -columns[free][0]];
    }
    let size = |[low, high]: [f64; 2]| low.abs().max(high.abs());
    let mut max = 0.0_f64;
    for k in 0..3 {
        let off: f64 = errors[k].iter().sum();
        if off >= 1.0 - 1e-9 {
            return None;
        }
        max = max.max(size(right[k]) / (1.0 - off));
    }
    // x' = r - E x', with |x'| <= greatest, and once more with what follows from that.
    let first: [f64; 3] = std::array::from_fn(|k| size(right[k]) + max * errors[k].iter().sum::<f64>());
    Some(std::array::from_fn(|k| {
        let off: f64 = errors[k].iter().zip(first).map(|(error, bound)| error * bound.min(max)).sum();
        // And what was rounded on the way.
        let off = off + 1e-13 * (1.0 + max);
        [right[k][0] - off, right[k][1] + off]
    }))
}
