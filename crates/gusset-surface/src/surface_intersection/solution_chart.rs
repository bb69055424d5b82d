//! Proofs about A = B over a box of parameters.
//!
//! - *Empty*: two flat pieces are apart exactly if one of six directions separates them. The
//!   directions are the two normals, and the cross products of a side of one piece with a side of
//!   the other. Each of them removes two of the four parameters from the equation. Control nets are
//!   compared along it.
//! - *A graph*: the free parameter is the one along which the curve runs. The equation is
//!   multiplied by the inverse of the derivatives with respect to the other three parameters, x, in
//!   the middle. Suppose that the derivatives with respect to x stay near the identity (a dominant
//!   diagonal) all over the box. Then x is a function of the free parameter on the solutions, and
//!   loops are impossible. The difference quotients of any two solutions obey the same bounds as
//!   the slopes. They tell whether the curve can return through a side that it left by.
//!
//! A - B is a difference of functions of different parameters. Its bounds are therefore sums of
//! bounds over control nets.
//!
//! The second proof is the contraction of the interval Newton method in the form of a dominant
//! diagonal (Krawczyk 1969; Hanniel and Elber 2007). Cost: O(N^2 + M^2) for a test, O(N^3 + M^3)
//! for a split.

use super::coordinate_net::CoordinateNet;
use super::intersection_equation::{DifferenceFrame, IntersectionEquation, OTHER_PARAMETERS};
use crate::Patch;
use crate::subdivision::BernsteinField;
use glam::{DVec3, DVec4};
use gusset_base::geom::subdivision::BoxTest;

/// Distance outside a box up to which a graph is proven, as a fraction of the box.
pub(super) const GRAPH_MARGIN_FRACTION: f64 = 1.0 / 32.0;

/// A box of parameters, and the control nets over it.
#[derive(Clone)]
pub(super) struct ParameterBox<const N: usize, const M: usize> {
    pub(super) nets: IntersectionEquation<N, M>,
    pub(super) low: DVec4,
    pub(super) size: DVec4,
}

/// A proof that the solutions in a box, and within [`GRAPH_MARGIN_FRACTION`] of it, are a graph.
#[derive(Debug, Clone, Copy)]
pub(super) struct SolutionGraphProof {
    /// The parameter on which the other three depend.
    pub(super) free_parameter: usize,
    /// The point of the line of the middle at the middle of the free parameter.
    pub(super) line_middle: DVec4,
    /// The slopes of the line of the middle.
    pub(super) line_slopes: DVec4,
    /// Bounds of the slopes; 1 for the free parameter.
    pub(super) slope_ranges: [[f64; 2]; 4],
}

/// A proof that a box is empty, or that its solutions form a graph.
pub(super) type ChartTest = BoxTest<SolutionGraphProof, ()>;

/// Factor by which the range of the coefficients of a polynomial of total degree `degree` may grow
/// if its box grows by [`GRAPH_MARGIN_FRACTION`] on each side. The weights of extrapolation sum to
/// 1, their absolute values to (1 + 2 m)^degree.
fn coefficient_growth_factor(degree: usize) -> f64 {
    (0..degree).fold(1.0, |product, _| product * (1.0 + 2.0 * GRAPH_MARGIN_FRACTION))
}

fn scale_about_middle([low, high]: [f64; 2], by: f64) -> [f64; 2] {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low) * by);
    [middle - half, middle + half]
}

/// The gap between the ranges of two fields; negative if the ranges overlap.
fn gap_between_fields<const N: usize, const M: usize>(a: &BernsteinField<N>, b: &BernsteinField<M>) -> f64 {
    let ([low, high], [others_low, others_high]) = (a.coefficient_range(), b.coefficient_range());
    let (above, below) = (low - others_high, others_low - high);
    if above > below { above } else { below }
}

/// The index of the component with the largest absolute value.
fn index_of_largest_component(tangent: DVec4) -> usize {
    (0..4).fold(0, |best, k| if tangent[k].abs() > tangent[best].abs() { k } else { best })
}

impl<const N: usize, const M: usize> ParameterBox<N, M> {
    /// The whole of two patches, whose nets are not yet set.
    pub(super) const WHOLE_PATCHES: Self = ParameterBox {
        nets: IntersectionEquation { a: CoordinateNet::ZERO, b: CoordinateNet::ZERO },
        low: DVec4::ZERO,
        size: DVec4::ONE,
    };

    pub(super) fn middle_point(&self) -> DVec4 {
        self.low + 0.5 * self.size
    }

    /// Proves that the box has no solution, or that its solutions form a graph. Otherwise returns
    /// `Undecided`.
    ///
    /// `frame` holds the derivatives in the middle of the box, with respect to the parameters of the
    /// cells. Surfaces farther apart than `tolerance` have no solution. Where they are nowhere
    /// parallel, a distance above `rounding_error` suffices.
    pub(super) fn prove_empty_or_graph(
        &self,
        frame: &DifferenceFrame,
        rounding_error: f64,
        tolerance: f64,
    ) -> ChartTest {
        let mut columns = frame.derivatives;
        (0..4).for_each(|k| columns[k] *= self.size[k]);
        let tangent = DifferenceFrame { derivatives: columns, ..*frame }.parameter_tangent();
        let free = index_of_largest_component(tangent);
        let others = OTHER_PARAMETERS[free];
        let [x, y, z] = others.map(|k| columns[k]);
        let normals = [y.cross(z), z.cross(x), x.cross(y)];
        let lengths = x.length() * y.length() * z.length();
        let determinant = x.dot(normals[0]);
        let regular = determinant.abs() > 1e-10 * lengths;
        let rows = normals.map(|normal| if regular { normal / determinant } else { normal });

        let (a, b) =
            (rows.map(|row| self.nets.a.component_along(row)), rows.map(|row| self.nets.b.component_along(row)));
        let mut is_apart = false;
        for k in 0..3 {
            let (gap, length) = (gap_between_fields(&a[k], &b[k]), rows[k].length());
            if gap > tolerance * length {
                return BoxTest::Empty;
            }
            is_apart |= gap > rounding_error * length;
        }
        if !regular {
            // Some directions of degenerate pieces are zero, so the bounding boxes are tested too.
            let apart = || DVec3::AXES.into_iter().any(|axis| self.are_pieces_separated_along(axis, tolerance));
            return if self.is_proven_empty_otherwise(frame, tolerance) || apart() {
                BoxTest::Empty
            } else {
                BoxTest::Undecided(())
            };
        }
        let line = others.map(|k| tangent[k] / tangent[free]);
        let Some(slopes) = slope_bounds_by_free_parameter(&a, &b, others, free) else {
            return if self.is_proven_empty_otherwise(frame, tolerance) {
                BoxTest::Empty
            } else {
                BoxTest::Undecided(())
            };
        };
        // The surfaces are nowhere parallel here.
        if is_apart {
            return BoxTest::Empty;
        }
        let mut chart = SolutionGraphProof {
            free_parameter: free,
            line_middle: self.middle_point(),
            line_slopes: DVec4::ONE,
            slope_ranges: [[1.0; 2]; 4],
        };
        for (k, &other) in others.iter().enumerate() {
            // From fractions of the box to parameters of the cells.
            let scale = self.size[other] / self.size[free];
            chart.line_middle[other] -= rows[k].dot(frame.difference) * self.size[other];
            chart.line_slopes[other] = line[k] * scale;
            chart.slope_ranges[other] = slopes[k].map(|slope| slope * scale);
        }
        BoxTest::Unique(chart)
    }

    /// True if a direction that [`ParameterBox::prove_empty_or_graph`] does not try for graphs
    /// proves the box empty. Tries the cross products with the derivative along which the curve
    /// runs, and [`Self::are_pieces_separated_sideways`].
    pub(super) fn is_proven_empty_otherwise(&self, frame: &DifferenceFrame, rounding_error: f64) -> bool {
        let columns: [DVec3; 4] = std::array::from_fn(|k| frame.derivatives[k] * self.size[k]);
        let tangent = DifferenceFrame { derivatives: columns, ..*frame }.parameter_tangent();
        let free = index_of_largest_component(tangent);
        OTHER_PARAMETERS[free]
            .into_iter()
            .any(|k| self.are_pieces_separated_along(columns[k].cross(columns[free]), rounding_error))
            || self.are_pieces_separated_sideways(frame, rounding_error)
    }

    /// True if a direction in a tangent plane, perpendicular to a side of a piece, separates the
    /// pieces.
    fn are_pieces_separated_sideways(&self, frame: &DifferenceFrame, rounding_error: f64) -> bool {
        let normals = frame.normals();
        (0..4).any(|k| self.are_pieces_separated_along(normals[k / 2].cross(frame.derivatives[k]), rounding_error))
    }

    fn are_pieces_separated_along(&self, axis: DVec3, rounding_error: f64) -> bool {
        gap_between_fields(&self.nets.a.component_along(axis), &self.nets.b.component_along(axis))
            > rounding_error * axis.length()
    }

    /// True if the pieces are flat and close, so that details of their intersection are below the
    /// tolerance. Along either normal, each piece lies between two planes `thickness` apart, and
    /// the pieces are within `tolerance` of each other.
    pub(super) fn are_pieces_flat_and_close(&self, frame: &DifferenceFrame, thickness: f64, tolerance: f64) -> bool {
        let thin = |normal: DVec3| {
            let (a, b) = (
                self.nets.a.component_along(normal).coefficient_range(),
                self.nets.b.component_along(normal).coefficient_range(),
            );
            let thickest = (a[1] - a[0]).max(b[1] - b[0]);
            thickest <= thickness && a[1].max(b[1]) - a[0].min(b[0]) <= tolerance + 2.0 * thickness
        };
        frame.normals().into_iter().all(|normal| normal.try_normalize().is_some_and(thin))
    }

    /// Approximate extents of the pieces in the four directions: the longest legs of the control
    /// nets, times their number.
    pub(super) fn piece_extents(&self) -> [f64; 4] {
        let ([s, t], [u, v]) =
            (derivative_bounds_by_legs(&self.nets.a.to_patch()), derivative_bounds_by_legs(&self.nets.b.to_patch()));
        [s, t, u, v]
    }

    /// Whether all points are on one side of the box, within `slack`.
    pub(super) fn are_points_on_one_side(&self, points: [DVec4; 2], slack: f64) -> bool {
        let on = |side: DVec4| points.map(|x| (x - side).abs().cmple(DVec4::splat(slack)));
        [self.low, self.low + self.size].map(on).into_iter().any(|[first, last]| (first & last).any())
    }

    /// The halves by parameter k.
    pub(super) fn halve_by_parameter(&self, k: usize) -> [Self; 2] {
        let mut parts = [self.clone(), self.clone()];
        let IntersectionEquation { a, b } = &self.nets;
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

/// The length of the longest leg of a net times the number of legs, in u and in v.
fn derivative_bounds_by_legs<const N: usize>(patch: &Patch<N>) -> [f64; 2] {
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

/// Bounds of the slopes of three parameters with respect to the free one, in fractions of the box.
/// Returns `None` if the diagonal may not be dominant.
fn slope_bounds_by_free_parameter<const N: usize, const M: usize>(
    a: &[BernsteinField<N>; 3],
    b: &[BernsteinField<M>; 3],
    others: [usize; 3],
    free: usize,
) -> Option<[[f64; 2]; 3]> {
    let (growth_a, growth_b) = (coefficient_growth_factor(2 * N - 3), coefficient_growth_factor(2 * M - 3));
    // (I + E) x' = r, |E| <= errors.
    let (mut errors, mut right) = ([[0.0; 3]; 3], [[0.0; 2]; 3]);
    for k in 0..3 {
        let ([s, t], [u, v]) = (a[k].derivative_ranges(), b[k].derivative_ranges());
        let (of_a, of_b) =
            ([s, t].map(|x| scale_about_middle(x, growth_a)), [u, v].map(|x| scale_about_middle(x, growth_b)));
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
    // x' = r - E x', with |x'| <= max. The second pass uses the bounds from the first.
    let first: [f64; 3] = std::array::from_fn(|k| size(right[k]) + max * errors[k].iter().sum::<f64>());
    Some(std::array::from_fn(|k| {
        let off: f64 = errors[k].iter().zip(first).map(|(error, bound)| error * bound.min(max)).sum();
        // Rounding of the steps above.
        let off = off + 1e-13 * (1.0 + max);
        [right[k][0] - off, right[k][1] + off]
    }))
}
