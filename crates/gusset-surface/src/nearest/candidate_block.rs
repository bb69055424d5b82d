//! Selects the cells of a block that may contain the nearest point, from corners and displacements
//! alone.
//!
//! Corners are points of the surface. The surface also has a point close to the nearest point of
//! each bilinear patch. Both lower the upper bound before any patch is computed. The bounds of
//! `block_corners` then exclude most cells. The others become candidates with a lower bound and a
//! start for the descent. O(1).

use super::block_corners::{BlockCorners, CentredDisplacementBox, min_ignoring_nan};
use super::incumbent::DistanceUpperBound;
use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use crate::index::BoxPyramid;
use glam::{DVec2, DVec3};

/// A cell that may contain the nearest point.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellCandidate {
    /// A lower bound of the cell's distance.
    pub(super) distance_bound: f64,
    /// The unit vector to the query from the nearest point of the cell's bilinear patch, and
    /// parameters close to that point.
    pub(super) direction: DVec3,
    pub(super) start_parameters: DVec2,
    pub(super) cell: [u32; 2],
}

/// A block of the lowest level.
pub(super) struct CandidateBlock<'a, C, const N: usize> {
    pub(super) cells: &'a C,
    pub(super) index: &'a BoxPyramid,
    pub(super) row: usize,
    pub(super) column: usize,
}

impl<C: SheetCells<N>, const N: usize> CandidateBlock<'_, C, N> {
    /// Lowers the upper bound, and adds the cells that may contain the nearest point to the
    /// candidates. `direction` is the unit vector from the nearest answer to the query, or zero.
    /// Returns the block's extent.
    pub(super) fn find_candidates(
        &self,
        query: DVec3,
        direction: DVec3,
        upper: &mut DistanceUpperBound,
        candidates: &mut Vec<CellCandidate>,
    ) -> f64 {
        let [rows, columns] = self.cells.cell_counts();
        let (top, left) = (self.row * CELLS_PER_BLOCK_SIDE, self.column * CELLS_PER_BLOCK_SIDE);
        let (rows, columns) = (CELLS_PER_BLOCK_SIDE.min(rows - top), CELLS_PER_BLOCK_SIDE.min(columns - left));
        let corners = BlockCorners::from_cells(self.cells, [top, left], [rows, columns], query);
        upper.lower_to_distance(corners.min_squared_corner_distance().sqrt());
        let displacement = CentredDisplacementBox::new(self.index.displacement_box(self.row, self.column));
        let max_examined_distance = upper.max_examined_distance();
        // The half-space through the nearest answer.
        let mut bounds = [[0.0; CELLS_PER_BLOCK_SIDE]; CELLS_PER_BLOCK_SIDE];
        if direction != DVec3::ZERO {
            bounds =
                corners.cell_distance_bounds_by_half_spaces(direction, displacement.max_displacement_along(direction));
            let least = bounds.as_flattened().iter().copied().fold(f64::INFINITY, min_ignoring_nan);
            if least > max_examined_distance {
                return corners.distance_between_extreme_corners();
            }
        }
        let squares = corners.squared_box_distances(&displacement);
        let middles = corners.squared_mean_distances_times_16();
        // The remaining cells, sorted by the distance of their middle.
        let mut order = [0_u8; CELLS_PER_BLOCK_SIDE * CELLS_PER_BLOCK_SIDE];
        let mut count = 0;
        for (r, bounds) in bounds[..rows].iter().enumerate() {
            for (c, &bound) in bounds[..columns].iter().enumerate() {
                if bound > max_examined_distance || squares[r][c] > max_examined_distance * max_examined_distance {
                    continue;
                }
                let mut at = count;
                while at > 0 && middles.as_flattened()[usize::from(order[at - 1])] > middles[r][c] {
                    order[at] = order[at - 1];
                    at -= 1;
                }
                order[at] = (CELLS_PER_BLOCK_SIDE * r + c) as u8;
                count += 1;
            }
        }
        for &cell in &order[..count] {
            let (r, c) = (usize::from(cell) / CELLS_PER_BLOCK_SIDE, usize::from(cell) % CELLS_PER_BLOCK_SIDE);
            if squares[r][c] > upper.max_examined_distance() * upper.max_examined_distance() {
                continue;
            }
            let quad = corners.cell_corners(r, c);
            if is_hull_beyond(&quad, upper.max_examined_distance() + displacement.max_length) {
                continue;
            }
            let NearestOnBilinear { distance, direction, near_parameters: start } = nearest_on_bilinear(&quad);
            upper.lower_to_distance(distance + displacement.max_length);
            // The hull of the corners contains the bilinear patch.
            let along = quad.map(|corner| -corner.dot(direction)).into_iter().fold(f64::INFINITY, min_ignoring_nan);
            let bound = along - displacement.max_displacement_along(direction);
            if bound > upper.max_examined_distance() {
                continue;
            }
            candidates.push(CellCandidate {
                distance_bound: bound,
                direction,
                start_parameters: start,
                cell: [(top + r) as u32, (left + c) as u32],
            });
        }
        corners.distance_between_extreme_corners()
    }
}

/// True if the hull of four corners is farther from the origin than `limit`. Tests the half-space
/// perpendicular to the direction of their mean, which is the sharpest test for distant cells.
#[inline(always)]
fn is_hull_beyond(corners: &[DVec3; 4], limit: f64) -> bool {
    let [a, b, c, d] = *corners;
    let middle = (a + b) + (c + d);
    let along = min_ignoring_nan(
        min_ignoring_nan(a.dot(middle), b.dot(middle)),
        min_ignoring_nan(c.dot(middle), d.dot(middle)),
    );
    along > 0.0 && along * along > limit * limit * middle.length_squared()
}

/// The approximate nearest point of a bilinear patch.
struct NearestOnBilinear {
    /// An upper bound of the distance.
    distance: f64,
    /// A unit vector to the origin from a point close to the nearest one.
    direction: DVec3,
    /// Parameters close to the nearest point.
    near_parameters: DVec2,
}

/// Approximates the nearest point to the origin on the bilinear patch through four corners (00, 01,
/// 10, 11).
///
/// With s and t measured from the middle, the patch is m + s u + t v + s t w. It is within |w| / 4
/// of the parallelogram without the twist w, whose nearest point is computed.
fn nearest_on_bilinear(corners: &[DVec3; 4]) -> NearestOnBilinear {
    let [p00, p01, p10, p11] = *corners;
    let (low, high) = (p00 + p01, p10 + p11);
    let (left, right) = (p00 + p10, p01 + p11);
    let (middle, u, v) = (0.25 * (low + high), 0.5 * (high - low), 0.5 * (right - left));
    let twist = (p00 - p01) - (p10 - p11);
    let (uu, uv, vv, mu, mv) = (u.length_squared(), u.dot(v), v.length_squared(), middle.dot(u), middle.dot(v));
    let (area, inner) = (uu * vv - uv * uv, [uv * mv - vv * mu, uv * mu - uu * mv]);
    let spans = area > 1e-12 * uu * vv;
    let outside = inner.map(|x| x.abs() > 0.5 * area);
    let value = |[s, t]: [f64; 2]| (middle + s * u + t * v).length_squared();
    let (square, [s, t]) = if spans && outside == [false; 2] {
        let place = inner.map(|x| x / area);
        (value(place), place)
    } else {
        // The nearest point lies on a side beyond which the nearest point of the plane lies. For a
        // degenerate parallelogram, it may lie on any side.
        let clamped_ratio = |above: f64, below: f64| if below > 0.0 { (above / below).clamp(-0.5, 0.5) } else { 0.0 };
        let mut best = (f64::INFINITY, [0.0; 2]);
        let mut consider = |place: [f64; 2]| {
            let square = value(place);
            if square < best.0 {
                best = (square, place);
            }
        };
        for end in [-0.5, 0.5] {
            if !spans || (outside[0] && inner[0] * end > 0.0) {
                consider([end, clamped_ratio(-mv - end * uv, vv)]);
            }
            if !spans || (outside[1] && inner[1] * end > 0.0) {
                consider([clamped_ratio(-mu - end * uv, uu), end]);
            }
        }
        best
    };
    let distance = square.sqrt();
    let direction = if distance > 0.0 { (middle + s * u + t * v) / -distance } else { DVec3::ZERO };
    NearestOnBilinear {
        distance: distance + 0.25 * twist.length(),
        direction,
        near_parameters: DVec2::new(s + 0.5, t + 0.5),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Grid, Nodes, Scheme};
    use gusset_base::job::Job;
    use gusset_base::testing::case_count;

    /// A block of 4 x 3 cells through rough nodes.
    fn rough_grid(seed: u32) -> Grid<'static> {
        let number = |k: u32| f64::from((seed * 1000 + k).wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24);
        let nodes = (0..20).flat_map(|k| {
            let flat = [f64::from(k / 4), f64::from(k % 4), 0.0];
            [0, 1, 2].map(|axis| flat[axis as usize] + 0.8 * number(3 * k + axis))
        });
        Grid::new(Nodes::strided(nodes.collect::<Vec<_>>(), 5, 4, 0, 0).unwrap(), [false; 2], Scheme::SixTap).unwrap()
    }

    fn nearest_by_sampling(grid: &Grid<'_>, [i, j]: [usize; 2], query: DVec3) -> f64 {
        let patch = grid.patch(i, j);
        let places = (0..289).map(|k| [f64::from(k / 17) / 16.0, f64::from(k % 17) / 16.0]);
        places.map(|[u, v]| patch.point(u, v).distance(query)).fold(f64::INFINITY, f64::min)
    }

    fn sample_queries() -> impl Iterator<Item = DVec3> {
        (0..60).map(|k| {
            let t = f64::from(k);
            DVec3::new(2.0 + 3.0 * t.sin(), 2.0 + 3.0 * (2.3 * t).cos(), 4.0 * (0.7 * t).sin())
        })
    }

    /// Compares with points of all cells. Bounds of candidates hold, excluded cells are beyond the
    /// prune bound, and the upper bound is at least the smallest distance.
    #[test]
    fn cells_with_nearer_points_are_never_excluded() {
        let (mut candidates, mut asked, mut excluded) = (Vec::new(), 0, 0);
        for (seed, query) in (0..case_count(12)).flat_map(|seed| sample_queries().map(move |query| (seed, query))) {
            let grid = rough_grid(seed);
            let index = BoxPyramid::build(&grid, &Job::default()).unwrap();
            let all: Vec<[usize; 2]> = (0..12).map(|k| [k / 3, k % 3]).collect();
            let truth: Vec<f64> = all.iter().map(|&cell| nearest_by_sampling(&grid, cell, query)).collect();
            let least = truth.iter().copied().fold(f64::INFINITY, f64::min);
            let direction = (query - grid.patch(1, 1).point(0.5, 0.5)).normalize();
            // The bound that an answer would give, for which an excessive cell bound would exclude
            // a tie.
            for (limit, direction) in [(f64::INFINITY, DVec3::ZERO), (least, DVec3::ZERO), (least, direction)] {
                candidates.clear();
                let mut upper = DistanceUpperBound::new(limit, 0.0);
                let leaf = CandidateBlock { cells: &grid, index: &index, row: 0, column: 0 };
                leaf.find_candidates(query, direction, &mut upper, &mut candidates);
                // Points of the lattice are close to the nearest point, but not equal to it.
                assert!(upper.distance >= least - 0.05, "{seed} {query}");
                for (&[i, j], &truth) in all.iter().zip(&truth) {
                    let found = candidates.iter().find(|candidate| candidate.cell == [i as u32, j as u32]);
                    match found {
                        Some(candidate) => assert!(candidate.distance_bound <= truth, "{seed} {query} {i} {j}"),
                        None => assert!(truth >= upper.distance, "{seed} {query} {i} {j}"),
                    }
                    asked += 1;
                    excluded += usize::from(found.is_none());
                }
            }
        }
        // The corners exclude this many cells, although the nodes are random.
        assert!(excluded * 25_920 > asked * 7_500, "{excluded} of {asked}");
    }

    /// Tests each bound of all cells of a block separately, on a surface with large displacements.
    #[test]
    fn bounds_of_blocks_hold() {
        for (seed, query) in (0..case_count(12)).flat_map(|seed| sample_queries().map(move |query| (seed, query))) {
            let grid = rough_grid(seed);
            let index = BoxPyramid::build(&grid, &Job::default()).unwrap();
            let displacement = CentredDisplacementBox::new(index.displacement_box(0, 0));
            let corners = BlockCorners::from_cells(&grid, [0, 0], [4, 3], query);
            let direction = (query - grid.patch(2, 1).point(0.5, 0.5)).normalize();
            let spaces =
                corners.cell_distance_bounds_by_half_spaces(direction, displacement.max_displacement_along(direction));
            let squares = corners.squared_box_distances(&displacement);
            for [i, j] in (0..12).map(|k| [k / 3, k % 3]) {
                let truth = nearest_by_sampling(&grid, [i, j], query);
                assert!(spaces[i][j] <= truth, "{seed} {query} {i} {j}");
                assert!(squares[i][j].sqrt() <= truth, "{seed} {query} {i} {j}");
                let quad = corners.cell_corners(i, j);
                assert!(!is_hull_beyond(&quad, truth + displacement.max_length), "{seed} {query} {i} {j}");
                let near = nearest_on_bilinear(&quad);
                assert!(near.distance + displacement.max_length >= truth - 0.05, "{seed} {query} {i} {j}");
                let [a, b, c, d] = quad;
                let (s, t) = (near.near_parameters.x, near.near_parameters.y);
                let point = (a * (1.0 - t) + b * t) * (1.0 - s) + (c * (1.0 - t) + d * t) * s;
                assert!(point.length() <= near.distance + 1e-12, "{seed} {query} {i} {j}");
            }
        }
    }

    /// Without displacements, the bounds of a plane are exact, so a weaker bound would be noticed.
    #[test]
    fn bounds_of_a_plane_are_exact() {
        let nodes = (0..25).flat_map(|k| [f64::from(k / 5), f64::from(k % 5), 0.0]).collect::<Vec<_>>();
        let grid = Grid::new(Nodes::strided(nodes, 5, 5, 0, 0).unwrap(), [false; 2], Scheme::SixTap).unwrap();
        let index = BoxPyramid::build(&grid, &Job::default()).unwrap();
        let displacement = CentredDisplacementBox::new(index.displacement_box(0, 0));
        let query = DVec3::new(-1.0, -2.0, 2.0);
        let corners = BlockCorners::from_cells(&grid, [0, 0], [4, 4], query);
        for [i, j] in (0..16).map(|k| [k / 4, k % 4]) {
            let corner = DVec3::new(i as f64, j as f64, 0.0);
            let truth = corner.distance(query);
            let direction = (query - corner) / truth;
            assert!((corners.squared_box_distances(&displacement)[i][j].sqrt() - truth).abs() < 1e-9);
            assert!(
                (corners
                    .cell_distance_bounds_by_half_spaces(direction, displacement.max_displacement_along(direction))[i]
                    [j]
                    - truth)
                    .abs()
                    < 1e-9
            );
            assert!((nearest_on_bilinear(&corners.cell_corners(i, j)).distance - truth).abs() < 1e-9);
        }
        assert!((corners.min_squared_corner_distance() - 9.0).abs() < 1e-12);
        assert!(is_hull_beyond(&corners.cell_corners(3, 3), 5.0) && !is_hull_beyond(&corners.cell_corners(3, 3), 9.0));
        let mut candidates = Vec::new();
        let leaf = CandidateBlock { cells: &grid, index: &index, row: 0, column: 0 };
        leaf.find_candidates(query, DVec3::ZERO, &mut DistanceUpperBound::new(f64::INFINITY, 0.0), &mut candidates);
        assert_eq!(candidates.iter().map(|candidate| candidate.cell).collect::<Vec<_>>(), [[0, 0]]);
    }
}
