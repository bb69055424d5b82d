//! A polynomial piece of degree 7 that is nearly the best approximation of a rational one.
//!
//! In each direction, the piece has the values and first derivatives of the rational piece at both
//! ends, and its values at four inner parameters. The parameters minimise the largest value of x^2
//! (1 - x)^2 times the product of the distances from them, to which the error is proportional. This
//! value is 7.4e-5. The Chebyshev polynomial without conditions at the ends has 3.1e-5; four
//! derivatives at both ends would give 3.9e-3.
//!
//! The piece is a tensor product. Its sides depend only on the rational sides, and its cross
//! derivatives only on the rational ones there. Adjacent pieces therefore share their sides. Their
//! tangents are continuous wherever the tangents of the rational surface are.

use super::super::spline::PieceNet;
use crate::MAX_DEGREE;
use glam::DVec3;
use glam::DVec4;
use gusset_base::error::Result;
use gusset_base::geom::bernstein::{bernstein_values, evaluate};
use gusset_base::geom::linear::dense::DenseMatrix;

/// Number of data in each direction: the value and derivative at 0, inner values, the derivative
/// and value at 1.
const DATA_PER_DIRECTION: usize = MAX_DEGREE + 1;

/// The inner parameters: the zeros of (1 - t^2)^2 (t^2 - A) (t^2 - B) over -1 <= t <= 1. For A =
/// 0.048143381178 and B = 0.393282575607, all extrema have equal magnitude.
const INNER_PARAMETERS: [f64; 4] =
    [0.186_438_771_685_935_4, 0.390_291_999_860_562_7, 0.609_708_000_139_437_3, 0.813_561_228_314_064_6];

/// The parameters of these extrema.
const PARAMETERS_OF_EXTREME_ERROR: [f64; 5] = [0.0983, 0.2846, 0.5, 0.7154, 0.9017];

/// The indices of the data that are values.
const DATA_INDICES_OF_VALUES: [usize; 6] = [0, 2, 3, 4, 5, 7];

/// For each datum, the index of the value at the same parameter.
const VALUE_INDEX_OF_DATUM: [usize; DATA_PER_DIRECTION] = [0, 0, 2, 3, 4, 5, 7, 7];

/// Rows of factors of control points, or of data.
type DataMatrix<const ROWS: usize> = [[f64; DATA_PER_DIRECTION]; ROWS];

/// Points of a piece that are known exactly, at its corners and along its sides.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct ExactBorderPoints {
    /// The sides at u = 0 and u = 1, then at v = 0 and v = 1. Contains the point if the side is a
    /// single point.
    pub(super) points_of_sides: [[Option<DVec3>; 2]; 2],
    /// The corners, indexed by u and v.
    pub(super) corners: [[Option<DVec3>; 2]; 2],
}

impl ExactBorderPoints {
    pub(super) fn map_points(self, to: impl Fn(DVec3) -> DVec3) -> Self {
        let all = |points: [[Option<DVec3>; 2]; 2]| points.map(|pair| pair.map(|point| point.map(&to)));
        ExactBorderPoints { points_of_sides: all(self.points_of_sides), corners: all(self.corners) }
    }

    /// Overwrites the control points that are known exactly.
    pub(super) fn overwrite_exact_points(&self, points: &mut PieceNet<DVec3>) {
        for (end, k) in [(0, 0), (1, MAX_DEGREE)] {
            for (other, l) in [(0, 0), (1, MAX_DEGREE)] {
                points[k][l] = self.corners[end][other].unwrap_or(points[k][l]);
            }
            if let Some(point) = self.points_of_sides[0][end] {
                points[k] = [point; DATA_PER_DIRECTION];
            }
            if let Some(point) = self.points_of_sides[1][end] {
                points.iter_mut().for_each(|row| row[k] = point);
            }
        }
    }
}

/// The factors that all pieces of two degrees share.
pub(super) struct FitMatrices {
    degrees: [usize; 2],
    /// Factors that compute the data from control points, in u and in v.
    data_from_controls: [DataMatrix<DATA_PER_DIRECTION>; 2],
    /// Factors that compute the values at [`PARAMETERS_OF_EXTREME_ERROR`].
    between: [DataMatrix<5>; 2],
    /// Factors that compute the control points of degree 7 from data.
    control: DataMatrix<DATA_PER_DIRECTION>,
}

/// A piece: its data, which neighbours share at sides, and its control points.
pub(super) struct FittedPiece {
    data: PieceNet<DVec3>,
    /// The control points.
    pub(super) points: PieceNet<DVec3>,
}

/// The factors that compute data from control points.
fn data_from_controls(degree: usize) -> DataMatrix<DATA_PER_DIRECTION> {
    let (mut rows, n) = ([[0.0; DATA_PER_DIRECTION]; DATA_PER_DIRECTION], degree as f64);
    rows[0][0] = 1.0;
    (rows[1][0], rows[1][1]) = (-n, n);
    for (row, t) in rows[2..].iter_mut().zip(INNER_PARAMETERS) {
        bernstein_values(&mut row[..=degree], t);
    }
    (rows[6][degree - 1], rows[6][degree]) = (-n, n);
    rows[7][degree] = 1.0;
    rows
}

/// The weighted sum of values.
fn weighted_sum_of_values<T: Default + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>>(
    factors: &[f64],
    value: impl Fn(usize) -> T,
) -> T {
    factors.iter().enumerate().map(|(k, &factor)| value(k) * factor).fold(T::default(), |sum, term| sum + term)
}

impl FitMatrices {
    pub(super) fn new(degrees: [usize; 2]) -> Result<Self> {
        let mut system = DenseMatrix::default();
        system.resize(DATA_PER_DIRECTION)?;
        data_from_controls(MAX_DEGREE).iter().enumerate().for_each(|(k, row)| system.row(k).copy_from_slice(row));
        // The determinant of the system is a nonzero constant.
        system.factorise();
        let mut control = [[0.0; DATA_PER_DIRECTION]; DATA_PER_DIRECTION];
        for datum in 0..DATA_PER_DIRECTION {
            let mut column: [DVec3; DATA_PER_DIRECTION] =
                std::array::from_fn(|k| DVec3::splat(f64::from(u8::from(k == datum))));
            system.solve(&mut column);
            control.iter_mut().zip(column).for_each(|(row, x)| row[datum] = x.x);
        }
        let between = degrees.map(|degree| {
            PARAMETERS_OF_EXTREME_ERROR.map(|t| {
                let mut row = [0.0; DATA_PER_DIRECTION];
                bernstein_values(&mut row[..=degree], t);
                row
            })
        });
        Ok(FitMatrices { degrees, data_from_controls: degrees.map(data_from_controls), between, control })
    }

    /// Fits a rational piece with the given homogeneous control points: w x, w y, w z and w.
    pub(super) fn fit_piece(&self, homogeneous: &PieceNet<DVec4>, known: &ExactBorderPoints) -> FittedPiece {
        let data = self.project_to_space(&self.homogeneous_data(homogeneous), known);
        // First along the rows, then across them, so that sides depend on data at the sides only.
        let along = data.map(|row| self.controls_from_data(&row));
        let columns: PieceNet<DVec3> = std::array::from_fn(|b| self.controls_from_data(&along.map(|row| row[b])));
        let mut points: PieceNet<DVec3> = std::array::from_fn(|a| std::array::from_fn(|b| columns[b][a]));
        known.overwrite_exact_points(&mut points);
        FittedPiece { data, points }
    }

    fn homogeneous_data(&self, net: &PieceNet<DVec4>) -> PieceNet<DVec4> {
        let [p, q] = self.degrees;
        let along =
            net.map(|points| self.data_from_controls[1].map(|row| weighted_sum_of_values(&row[..=q], |b| points[b])));
        self.data_from_controls[0]
            .map(|row| std::array::from_fn(|l| weighted_sum_of_values(&row[..=p], |a| along[a][l])))
    }

    /// Values and derivatives of S = P / w from values and derivatives of P and w. They follow from
    /// P = w S, P_u =
    /// w_u S + w S_u and P_uv = w_uv S + w_u S_v + w_v S_u + w S_uv.
    fn project_to_space(&self, data: &PieceNet<DVec4>, known: &ExactBorderPoints) -> PieceNet<DVec3> {
        let mut out = PieceNet::<DVec3>::default();
        for (k, l) in DATA_INDICES_OF_VALUES.into_iter().flat_map(|k| DATA_INDICES_OF_VALUES.map(|l| (k, l))) {
            out[k][l] = data[k][l].truncate() / data[k][l].w;
        }
        for (end, at) in [(0, 0), (1, DATA_PER_DIRECTION - 1)] {
            for (other, far) in [(0, 0), (1, DATA_PER_DIRECTION - 1)] {
                out[at][far] = known.corners[end][other].unwrap_or(out[at][far]);
            }
            known.points_of_sides[0][end]
                .into_iter()
                .for_each(|point| DATA_INDICES_OF_VALUES.into_iter().for_each(|l| out[at][l] = point));
            known.points_of_sides[1][end]
                .into_iter()
                .for_each(|point| DATA_INDICES_OF_VALUES.into_iter().for_each(|k| out[k][at] = point));
        }
        let slopes = [1, DATA_PER_DIRECTION - 2];
        // Along a side that is a single point, the derivative is set to 0 exactly.
        let is_point = |d: usize, l: usize| {
            (l == 0 && known.points_of_sides[d][0].is_some())
                || (l == DATA_PER_DIRECTION - 1 && known.points_of_sides[d][1].is_some())
        };
        for (k, l) in slopes.into_iter().flat_map(|k| DATA_INDICES_OF_VALUES.map(|l| (k, l))) {
            let at = VALUE_INDEX_OF_DATUM[k];
            let slope = |rise: DVec4, value: DVec4, point: DVec3| (rise.truncate() - rise.w * point) / value.w;
            out[k][l] = if is_point(1, l) { DVec3::ZERO } else { slope(data[k][l], data[at][l], out[at][l]) };
            out[l][k] = if is_point(0, l) { DVec3::ZERO } else { slope(data[l][k], data[l][at], out[l][at]) };
        }
        for (k, l) in slopes.into_iter().flat_map(|k| slopes.map(|l| (k, l))) {
            let (a, b) = (VALUE_INDEX_OF_DATUM[k], VALUE_INDEX_OF_DATUM[l]);
            let rest = data[k][l].w * out[a][b] + data[k][b].w * out[a][l] + data[a][l].w * out[k][b];
            out[k][l] = (data[k][l].truncate() - rest) / data[a][b].w;
        }
        out
    }

    /// The control points of a curve of degree 7 with the given data.
    fn controls_from_data(&self, data: &[DVec3; DATA_PER_DIRECTION]) -> [DVec3; DATA_PER_DIRECTION] {
        // Relative to the first value, so that rounding is proportional to the size of the piece.
        let from = data[0];
        let steps: [DVec3; DATA_PER_DIRECTION] =
            std::array::from_fn(|k| if DATA_INDICES_OF_VALUES.contains(&k) { data[k] - from } else { data[k] });
        let mut points = self.control.map(|row| from + weighted_sum_of_values(&row, |k| steps[k]));
        (points[0], points[DATA_PER_DIRECTION - 1]) = (from, data[DATA_PER_DIRECTION - 1]);
        points
    }

    /// The largest errors in u alone and in v alone, sampled where the error is largest. The error
    /// in one direction is visible where the data of the other direction are values.
    pub(super) fn max_errors_by_direction(&self, piece: &FittedPiece, homogeneous: &PieceNet<DVec4>) -> [f64; 2] {
        [0, 1].map(|d| {
            let mut worst = 0.0_f64;
            for l in DATA_INDICES_OF_VALUES {
                let curve = self.controls_from_data(&std::array::from_fn(|k| {
                    if d == 0 { piece.data[k][l] } else { piece.data[l][k] }
                }));
                let row = &self.data_from_controls[1 - d][l][..=self.degrees[1 - d]];
                for (t, between) in PARAMETERS_OF_EXTREME_ERROR.into_iter().zip(&self.between[d]) {
                    let at = |k: usize| {
                        weighted_sum_of_values(row, |m| if d == 0 { homogeneous[k][m] } else { homogeneous[m][k] })
                    };
                    let point = weighted_sum_of_values(&between[..=self.degrees[d]], at);
                    worst = worst.max(evaluate(&curve, t).distance(point.truncate() / point.w));
                }
            }
            worst
        })
    }
}
