//! Other common points of two cells that have points in common by declaration.
//!
//! Let the parts P and Q of equal size be the same, or share a side or a corner, so that S(p) =
//! S(q) for p = q. To prove that they have no other common points, find two rows L for which the
//! derivatives of L S have a dominant diagonal over both parts. The way from p to q through a
//! common point is monotone in each parameter. So L S(q) - L S(p) = M d, and the entries of M obey
//! the bounds of the derivatives. M d = 0 requires |m_11| |d_1| <= |m_12| |d_2| and |m_22|
//! |d_2| <= |m_21| |d_1|. If min |m_11| min |m_22| > max |m_12| max |m_21|, only d = 0 satisfies
//! both. L is the inverse of the tangents in the middle. This is the mean value theorem on a convex
//! set of parameters; for the dominance see Hanniel and Elber (2007, "Subdivision termination
//! criteria").
//!
//! If the proof fails, the parts are halved. Parts without common parameters are solved like two
//! surfaces. Where the tangents are dependent, as at the end of a self-intersection (Whitney's
//! umbrella), halving stops once both parts are straight lines within the resolution.
//!
//! Cost: O(N^2) for a test, O(N^3) for a split; a few parts for each halving around a singular
//! point.

use super::cell_joints::{CellJoint, CellPartRelation, SheetJoints};
use super::coordinate_net::CoordinateNet;
use super::pair_search::{CellPairSearch, CellPairTask, FoundArcsAndBalls, SearchStop};
use super::solution_chart::ParameterBox;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Largest number of pairs of parts with common points that are not proven to have no others.
/// Beyond it, the parts are reported as unresolved.
const MAX_UNPROVEN_PART_PAIRS: usize = 512;
/// Number of parts between two progress reports.
const PARTS_PER_REPORT: usize = 1 << 8;

/// Two cells of one sheet that have points in common.
pub(super) struct AdjacentCellPair<'a> {
    pub(super) task: &'a CellPairTask,
    pub(super) cells: [[u32; 2]; 2],
    pub(super) joints: &'a SheetJoints,
}

/// Bounds [low, high] of the derivatives of L S: by row of the matrix L, then by parameter (u, v)
/// of the surface S.
type ProjectedDerivativeRanges = [[[f64; 2]; 2]; 2];

impl AdjacentCellPair<'_> {
    /// Adds the arcs of the pair.
    pub(super) fn solve_pair<const N: usize>(
        &self,
        whole: &ParameterBox<N, N>,
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut search = self.task.begin_search(&whole.nets, pieces, job);
        let outcome = self.examine_parts_level_by_level(&mut search, whole);
        search.finish_pair(outcome, whole)
    }

    /// Processes the parts level by level.
    fn examine_parts_level_by_level<const N: usize>(
        &self,
        search: &mut CellPairSearch<'_, N, N>,
        whole: &ParameterBox<N, N>,
    ) -> Result<(), SearchStop> {
        let mut parts = alloc::filled(whole.clone(), 1)?;
        while !parts.is_empty() {
            let mut left = Vec::new();
            for (k, part) in parts.into_iter().enumerate() {
                if (k + 1).is_multiple_of(PARTS_PER_REPORT) {
                    search.report_progress()?;
                }
                let joint = match self.joints.relation_of_parts(self.cells, &part) {
                    CellPartRelation::Injective => continue,
                    CellPartRelation::Apart => {
                        search.search_box_of_adjacent_cells(&part)?;
                        continue;
                    }
                    CellPartRelation::Joined(joint) => Some(joint),
                    CellPartRelation::AtPole => None,
                };
                if !joint.is_some_and(|joint| self.is_proven_injective(&part, joint)) {
                    alloc::push(&mut left, part)?;
                }
            }
            let is_last = left.len() > MAX_UNPROVEN_PART_PAIRS;
            parts = Vec::new();
            for part in left {
                if is_last || self.are_parts_near_one_line(&part) {
                    search.report_ball(&part, false);
                } else {
                    self.split_into_quarter_pairs(&part, &mut parts)?;
                }
            }
        }
        Ok(())
    }

    /// True if both parts are within half the resolution of one line. All parts so close to a pinch
    /// point, of any size, are within the resolution of each other.
    fn are_parts_near_one_line<const N: usize>(&self, part: &ParameterBox<N, N>) -> bool {
        let [centre, u, v] = part.nets.a.point_and_tangents(0.5, 0.5);
        let longer = if u.length_squared() >= v.length_squared() { u } else { v };
        let axis = longer.normalize_or_zero();
        let far = |p: &DVec3| (p - centre - axis * axis.dot(p - centre)).length();
        let nets = [&part.nets.a, &part.nets.b].map(CoordinateNet::to_patch);
        nets.iter().flat_map(|net| net.points.as_flattened()).all(|p| far(p) <= 0.5 * self.task.resolution)
    }

    /// Adds the 16 pairs of quarters of both parts. If both parts are the same, adds each pair
    /// once.
    fn split_into_quarter_pairs<const N: usize>(
        &self,
        part: &ParameterBox<N, N>,
        parts: &mut Vec<ParameterBox<N, N>>,
    ) -> Result<()> {
        let is_one = self.cells[0] == self.cells[1] && part.low.x == part.low.z && part.low.y == part.low.w;
        alloc::reserve(parts, 16)?;
        for half in part.halve_by_parameter(0) {
            for quarter in half.halve_by_parameter(1) {
                for eighth in quarter.halve_by_parameter(2) {
                    let both = eighth.halve_by_parameter(3).into_iter();
                    let key = |x: f64, y: f64| (x > part.low.x, y > part.low.y);
                    parts.extend(
                        both.filter(|part| !is_one || key(part.low.x, part.low.y) <= key(part.low.z, part.low.w)),
                    );
                }
            }
        }
        Ok(())
    }

    /// True if S(p) = S(q) over the two parts is proven to have only the trivial solutions.
    fn is_proven_injective<const N: usize>(&self, part: &ParameterBox<N, N>, joint: CellJoint) -> bool {
        let signs = joint.flips.map(|flips| if flips { -1.0 } else { 1.0 });
        let [_, u, v] = part.nets.a.point_and_tangents(0.5, 0.5);
        let [_, other_u, other_v] = part.nets.b.point_and_tangents(0.5, 0.5);
        let (u, v) = (u + signs[0] * other_u, v + signs[1] * other_v);
        let normal = u.cross(v);
        let factor = 2.0 / normal.length_squared();
        if !factor.is_finite() {
            return false;
        }
        let rows = [v.cross(normal) * factor, normal.cross(u) * factor];
        let noise = |row: DVec3| 4.0 * (N - 1) as f64 * self.task.rounding_error * row.length();
        let (a, b) = (
            derivative_ranges_along_rows(&part.nets.a, rows, [1.0; 2]),
            derivative_ranges_along_rows(&part.nets.b, rows, signs),
        );
        let [[least, x], [y, other]] = [0, 1].map(|k| {
            [0, 1].map(|n| {
                let [low, high] = [a[k][n][0].min(b[k][n][0]), a[k][n][1].max(b[k][n][1])];
                if k == n { low - noise(rows[k]) } else { low.abs().max(high.abs()) + noise(rows[k]) }
            })
        });
        least > 0.0 && other > 0.0 && least * other > (1.0 + 1e-9) * x * y
    }
}

/// Bounds of the derivatives of a net along two rows. A negative sign reverses a parameter.
fn derivative_ranges_along_rows<const N: usize>(
    net: &CoordinateNet<N>,
    rows: [DVec3; 2],
    signs: [f64; 2],
) -> ProjectedDerivativeRanges {
    rows.map(|row| {
        let ranges = net.component_along(row).derivative_ranges();
        [0, 1].map(|k| {
            let [low, high] = ranges[k];
            if signs[k] < 0.0 { [-high, -low] } else { [low, high] }
        })
    })
}
