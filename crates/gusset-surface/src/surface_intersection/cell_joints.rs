//! Joints: which cells of a sheet have points in common by declaration. These are neighbours, also
//! across seams, and the cells around a pole.
//!
//! Two opposite borders of a sheet form a seam if the sheet is closed there, or if their control
//! points agree within rounding. The order of the control points may be reversed, as in a Möbius
//! band. A border whose control points are all the same point is a pole.
//!
//! Invariant: a joint maps the parameters of one cell continuously to the parameters of the other.
//! Cost: O(cells of the borders) for a sheet, O(1) for a pair of cells.

use super::poles;
use super::solution_chart::ParameterBox;
use crate::cells::SheetCells;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// How two opposite borders of a sheet are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum JoinOfOppositeBorders {
    Open,
    Straight,
    Reversed,
}

/// The position of a cell in the parameters of a cell that it has points in common with: its
/// offset, and whether its u and v run backwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CellJoint {
    pub(super) offset: [i64; 2],
    pub(super) flips: [bool; 2],
}

/// The joints of a sheet's cells.
#[derive(Debug)]
pub(super) struct SheetJoints {
    cells: [i64; 2],
    seams: [JoinOfOppositeBorders; 2],
    /// By direction and side: the pole at that border.
    poles: [[Option<BorderPole>; 2]; 2],
}

/// A border that is a single point.
#[derive(Debug, Clone, Copy)]
struct BorderPole {
    /// Gives the width of a band around the pole, as 2^-band of a cell. The sheet is proven not to
    /// meet itself there. `None` without a proof.
    band_halvings: Option<i32>,
}

/// A part of a cell: its row and column among parts of equal size.
#[derive(Debug, Clone, Copy)]
struct CellPart {
    cell: [i64; 2],
    row_and_column_of_part: [i64; 2],
    /// Number of parts in each direction of the cell.
    parts_per_direction: i64,
}

impl CellPart {
    fn whole_cell(cell: [u32; 2]) -> CellPart {
        CellPart { cell: cell.map(i64::from), row_and_column_of_part: [0; 2], parts_per_direction: 1 }
    }
}

/// The control points along a border of cell `k`, of rows (`direction` 0) or columns.
fn border_control_points<const N: usize>(
    cells: &impl SheetCells<N>,
    direction: usize,
    side: usize,
    k: usize,
) -> [DVec3; N] {
    poles::patch_from_border(cells, direction, side, k).points[0]
}

impl SheetJoints {
    /// Finds the joints of a sheet. Control points at most `noise` apart are the same point.
    pub(super) fn new<const N: usize>(
        cells: &impl SheetCells<N>,
        closed: [bool; 2],
        noise: f64,
        job: &Job<'_>,
    ) -> Result<Self> {
        let counts = cells.cell_counts();
        let mut joints = SheetJoints {
            cells: counts.map(|n| n as i64),
            seams: [JoinOfOppositeBorders::Open; 2],
            poles: [[None; 2]; 2],
        };
        let near = |p: &DVec3, q: &DVec3| p.distance(*q) <= noise;
        let is_pole = [0, 1].map(|d| {
            [0, 1].map(|s| {
                let first = border_control_points(cells, d, s, 0)[0];
                (0..counts[1 - d]).all(|k| border_control_points(cells, d, s, k).iter().all(|p| near(p, &first)))
            })
        });
        for d in 0..2 {
            let n = counts[1 - d];
            let same = |k: usize| {
                border_control_points(cells, d, 0, k)
                    .iter()
                    .zip(&border_control_points(cells, d, 1, k))
                    .all(|(p, q)| near(p, q))
            };
            let reversed = |k: usize| {
                let other = border_control_points(cells, d, 1, n - 1 - k);
                border_control_points(cells, d, 0, k).iter().zip(other.iter().rev()).all(|(p, q)| near(p, q))
            };
            joints.seams[d] = match () {
                () if closed[d] => JoinOfOppositeBorders::Straight,
                () if is_pole[d] != [false; 2] => JoinOfOppositeBorders::Open,
                () if (0..n).all(same) => JoinOfOppositeBorders::Straight,
                () if (0..n).all(reversed) => JoinOfOppositeBorders::Reversed,
                () => JoinOfOppositeBorders::Open,
            };
        }
        for (d, s) in [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter().filter(|&(d, s)| is_pole[d][s]) {
            let is_ring = joints.seams[1 - d] == JoinOfOppositeBorders::Straight;
            joints.poles[d][s] =
                Some(BorderPole { band_halvings: poles::halvings_until_injective_at_pole(cells, d, s, is_ring, job)? });
        }
        Ok(joints)
    }

    /// Whether two cells have points in common.
    pub(super) fn do_cells_share_points(&self, [p, q]: [[u32; 2]; 2]) -> bool {
        let [p, q] = [p, q].map(CellPart::whole_cell);
        self.joints_between(p.cell, q.cell).next().is_some() || self.poles_of_both_parts(p, q).next().is_some()
    }

    /// Whether two cells are proven to have only the declared points in common.
    pub(super) fn are_cells_proved_injective(&self, [p, q]: [[u32; 2]; 2]) -> bool {
        let [p, q] = [p, q].map(CellPart::whole_cell);
        self.are_parts_in_pole_band(p, q)
    }

    /// The ways in which two cells have points in common, except at poles.
    fn joints_between(&self, p: [i64; 2], q: [i64; 2]) -> impl Iterator<Item = CellJoint> + '_ {
        let steps = (0..9).map(|k| [k / 3 - 1, k % 3 - 1]);
        steps.filter_map(move |offset| {
            let (cell, flips) = self.neighbour_across_seams(p, offset)?;
            (cell == q).then_some(CellJoint { offset, flips })
        })
    }

    /// The cell at an offset, and whether its u and v run backwards.
    fn neighbour_across_seams(&self, cell: [i64; 2], offset: [i64; 2]) -> Option<([i64; 2], [bool; 2])> {
        let (mut at, mut flips) = ([cell[0] + offset[0], cell[1] + offset[1]], [false; 2]);
        for d in 0..2 {
            let n = self.cells[d];
            if (0..n).contains(&at[d]) {
                continue;
            }
            at[d] = at[d].rem_euclid(n);
            match self.seams[d] {
                JoinOfOppositeBorders::Open => return None,
                JoinOfOppositeBorders::Straight => {}
                JoinOfOppositeBorders::Reversed => {
                    at[1 - d] = self.cells[1 - d] - 1 - at[1 - d];
                    flips[1 - d] = !flips[1 - d];
                }
            }
        }
        // A reversed seam may lead outside the range of the first direction.
        (0..2).all(|d| (0..self.cells[d]).contains(&at[d])).then_some((at, flips))
    }

    /// The poles that both parts contain.
    fn poles_of_both_parts(&self, p: CellPart, q: CellPart) -> impl Iterator<Item = BorderPole> + '_ {
        (0..4).filter_map(move |k| {
            let (d, s) = (k / 2, k % 2);
            let is_at = |part: CellPart| match s {
                0 => part.cell[d] == 0 && part.row_and_column_of_part[d] == 0,
                _ => {
                    part.cell[d] == self.cells[d] - 1 && part.row_and_column_of_part[d] == part.parts_per_direction - 1
                }
            };
            self.poles[d][s].filter(|_| is_at(p) && is_at(q))
        })
    }

    /// Whether both parts are at the same pole, within the band where the sheet is proven
    /// injective.
    fn are_parts_in_pole_band(&self, p: CellPart, q: CellPart) -> bool {
        (0..4).any(|k| {
            let (d, s) = (k / 2, k % 2);
            let Some(band) = self.poles[d][s].and_then(|pole| pole.band_halvings) else {
                return false;
            };
            // The number of parts within the band.
            let deep = |part: CellPart| part.parts_per_direction >> band;
            let is_in = |part: CellPart| match s {
                0 => part.cell[d] == 0 && part.row_and_column_of_part[d] < deep(part),
                _ => {
                    part.cell[d] == self.cells[d] - 1
                        && part.row_and_column_of_part[d] >= part.parts_per_direction - deep(part)
                }
            };
            is_in(p) && is_in(q)
        })
    }

    /// The relation of two parts of cells, of equal size.
    pub(super) fn relation_of_parts<const N: usize>(
        &self,
        cells: [[u32; 2]; 2],
        part: &ParameterBox<N, N>,
    ) -> CellPartRelation {
        let count = (1.0 / part.size.x) as i64;
        let at = (part.low / part.size).to_array().map(|x| x as i64);
        let [p, q] = [0, 1].map(|k| CellPart {
            cell: cells[k].map(i64::from),
            row_and_column_of_part: [at[2 * k], at[2 * k + 1]],
            parts_per_direction: count,
        });
        if self.are_parts_in_pole_band(p, q) {
            return CellPartRelation::Injective;
        }
        let touches = |joint: &CellJoint| {
            (0..2).all(|d| {
                let own =
                    if joint.flips[d] { count - 1 - q.row_and_column_of_part[d] } else { q.row_and_column_of_part[d] };
                (own + joint.offset[d] * count - p.row_and_column_of_part[d]).abs() <= 1
            })
        };
        if let Some(joint) = self.joints_between(p.cell, q.cell).find(touches) {
            return CellPartRelation::Joined(joint);
        }
        if self.poles_of_both_parts(p, q).next().is_some() { CellPartRelation::AtPole } else { CellPartRelation::Apart }
    }
}

/// The relation of two parts of cells.
#[derive(Debug, Clone, Copy)]
pub(super) enum CellPartRelation {
    /// They do not have points in common by declaration.
    Apart,
    /// They are equal, or share a side or a corner.
    Joined(CellJoint),
    /// They are at the same pole.
    AtPole,
    /// They are near a pole around which the sheet is injective.
    Injective,
}
