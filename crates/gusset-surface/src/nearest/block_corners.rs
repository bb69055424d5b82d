//! Corners of a block's cells, and lower bounds of the distances of all its cells at once.
//!
//! The surface over a cell is its bilinear patch plus a vector of the block's
//! [`CentredDisplacementBox`]. The bilinear patch lies in the hull of the four corners. Each bound
//! is therefore a bound for the corners, reduced by the extent of the displacement box. All bounds
//! are computed without branches, on arrays of fixed size, one axis after the other.

use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use glam::DVec3;
use gusset_base::geom::aabb::Aabb;

/// A box of the vectors from the bilinear patches of a block's cells to the surface.
pub(super) struct CentredDisplacementBox {
    low: [f64; 3],
    high: [f64; 3],
    middle: DVec3,
    half_size: DVec3,
    /// An upper bound of the lengths of the vectors.
    pub(super) max_length: f64,
}

impl CentredDisplacementBox {
    pub(super) fn new(bounds: Aabb) -> CentredDisplacementBox {
        let Aabb { low, high } = bounds;
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        CentredDisplacementBox {
            low: low.to_array(),
            high: high.to_array(),
            middle,
            half_size: half,
            max_length: bounds.max_vector_length(),
        }
    }

    /// How far the surface extends beyond the bilinear patches in a direction.
    #[inline(always)]
    pub(super) fn max_displacement_along(&self, direction: DVec3) -> f64 {
        self.middle.dot(direction) + self.half_size.dot(direction.abs())
    }
}

/// The corners of a block's cells relative to the query, stored by axis for vector instructions.
/// The last corners repeat if the edge of the sheet cuts the block.
pub(super) struct BlockCorners {
    axes: [[[f64; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1]; 3],
}

/// The smaller number. Unlike [`f64::min`], it ignores NaN rules and is a single
/// instruction.
#[inline(always)]
pub(super) fn min_ignoring_nan(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The larger number, in a single instruction.
#[inline(always)]
fn max_ignoring_nan(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl BlockCorners {
    /// Reads the corners of a block of cells, relative to `query`.
    #[inline(always)]
    pub(super) fn from_cells<const N: usize>(
        cells: &impl SheetCells<N>,
        [top, left]: [usize; 2],
        [rows, columns]: [usize; 2],
        query: DVec3,
    ) -> BlockCorners {
        let mut axes = [[[0.0; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1]; 3];
        let [xs, ys, zs] = &mut axes;
        for (r, ((xs, ys), zs)) in xs.iter_mut().zip(ys).zip(zs).enumerate() {
            let line = cells.corner_points_of_row(top + r.min(rows), left, columns);
            for (c, [x, y, z]) in line.into_iter().enumerate() {
                (xs[c], ys[c], zs[c]) = (x - query.x, y - query.y, z - query.z);
            }
        }
        BlockCorners { axes }
    }

    /// The corners of a cell of the block: 00, 01, 10, 11.
    #[inline(always)]
    pub(super) fn cell_corners(&self, r: usize, c: usize) -> [DVec3; 4] {
        let [x, y, z] = &self.axes;
        [(r, c), (r, c + 1), (r + 1, c), (r + 1, c + 1)].map(|(r, c)| DVec3::new(x[r][c], y[r][c], z[r][c]))
    }

    /// The distance from the first corner to the last.
    #[inline(always)]
    pub(super) fn distance_between_extreme_corners(&self) -> f64 {
        let [x, y, z] = self.axes.each_ref().map(|axis| axis[CELLS_PER_BLOCK_SIDE][CELLS_PER_BLOCK_SIDE] - axis[0][0]);
        (x * x + y * y + z * z).sqrt()
    }

    /// Lower bounds of the distances of the cells, by half-spaces perpendicular to a direction
    /// towards the query. `displacement` bounds how far the surface extends beyond the bilinear
    /// patches along it.
    #[inline(always)]
    pub(super) fn cell_distance_bounds_by_half_spaces(
        &self,
        direction: DVec3,
        displacement: f64,
    ) -> [[f64; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE] {
        let [x, y, z] = &self.axes;
        let mut along = [[0.0; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1];
        for r in 0..=CELLS_PER_BLOCK_SIDE {
            for c in 0..=CELLS_PER_BLOCK_SIDE {
                along[r][c] = x[r][c] * direction.x + y[r][c] * direction.y + z[r][c] * direction.z;
            }
        }
        let mut bounds = [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE];
        for r in 0..CELLS_PER_BLOCK_SIDE {
            for c in 0..CELLS_PER_BLOCK_SIDE {
                let most = max_ignoring_nan(
                    max_ignoring_nan(along[r][c], along[r][c + 1]),
                    max_ignoring_nan(along[r + 1][c], along[r + 1][c + 1]),
                );
                bounds[r][c] = -most - displacement;
            }
        }
        bounds
    }

    /// The smallest squared distance of a corner.
    #[inline(always)]
    pub(super) fn min_squared_corner_distance(&self) -> f64 {
        let [x, y, z] = &self.axes;
        let mut least = [f64::INFINITY; CELLS_PER_BLOCK_SIDE + 1];
        for r in 0..=CELLS_PER_BLOCK_SIDE {
            for (c, least) in least.iter_mut().enumerate() {
                *least = min_ignoring_nan(*least, x[r][c] * x[r][c] + y[r][c] * y[r][c] + z[r][c] * z[r][c]);
            }
        }
        least.into_iter().fold(f64::INFINITY, min_ignoring_nan)
    }

    /// For each cell, 16 times the squared distance of the mean of its corners.
    #[inline(always)]
    pub(super) fn squared_mean_distances_times_16(&self) -> [[f64; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE] {
        let mut squares = [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE];
        for axis in &self.axes {
            for r in 0..CELLS_PER_BLOCK_SIDE {
                for c in 0..CELLS_PER_BLOCK_SIDE {
                    let sum = (axis[r][c] + axis[r][c + 1]) + (axis[r + 1][c] + axis[r + 1][c + 1]);
                    squares[r][c] += sum * sum;
                }
            }
        }
        squares
    }

    /// The squared distances of boxes around the cells. A box contains the corners, and is enlarged
    /// by the displacement box.
    #[inline(always)]
    pub(super) fn squared_box_distances(
        &self,
        displacement: &CentredDisplacementBox,
    ) -> [[f64; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE] {
        let mut squares = [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE];
        for (k, axis) in self.axes.iter().enumerate() {
            let (mut low, mut high) = (
                [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE + 1],
                [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE + 1],
            );
            for r in 0..=CELLS_PER_BLOCK_SIDE {
                for c in 0..CELLS_PER_BLOCK_SIDE {
                    low[r][c] = min_ignoring_nan(axis[r][c], axis[r][c + 1]);
                    high[r][c] = max_ignoring_nan(axis[r][c], axis[r][c + 1]);
                }
            }
            for r in 0..CELLS_PER_BLOCK_SIDE {
                for c in 0..CELLS_PER_BLOCK_SIDE {
                    let (low, high) =
                        (min_ignoring_nan(low[r][c], low[r + 1][c]), max_ignoring_nan(high[r][c], high[r + 1][c]));
                    let outside = max_ignoring_nan(
                        max_ignoring_nan(low + displacement.low[k], -high - displacement.high[k]),
                        0.0,
                    );
                    squares[r][c] += outside * outside;
                }
            }
        }
        squares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The extent of a displacement box equals the extent of its farthest corner, in any direction.
    #[test]
    fn displacement_extents_are_exact() {
        let bounds = Aabb { low: DVec3::new(-1.0, 0.25, -3.0), high: DVec3::new(0.5, 2.0, -1.0) };
        let displacement = CentredDisplacementBox::new(bounds);
        let corner = |k: usize| {
            let side = |axis: usize| if k >> axis & 1 == 0 { bounds.low[axis] } else { bounds.high[axis] };
            DVec3::new(side(0), side(1), side(2))
        };
        for k in 0..100 {
            let t = f64::from(k);
            let direction = DVec3::new(t.sin(), (2.0 * t).cos(), (3.0 * t).sin());
            let reach = (0..8).map(|k| corner(k).dot(direction)).fold(f64::NEG_INFINITY, f64::max);
            assert!((displacement.max_displacement_along(direction) - reach).abs() < 1e-12, "{direction}");
        }
        assert_eq!(displacement.max_length, DVec3::new(1.0, 2.0, 3.0).length());
    }
}
