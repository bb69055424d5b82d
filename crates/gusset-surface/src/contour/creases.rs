//! Creases: sides between cells across which the angle of the normals jumps past a given one. They
//! belong to the isophote, but no cell contains the angle.

use super::cone_culling;
use super::contour_lattice::ContourLattice;
use super::projected_normals::ProjectedNormals;
use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use crate::index::ConePyramid;
use glam::DVec2;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::f64::consts::PI;

/// Finds creases, each as a cell and the middle of its side. At both ends of the side, the angle is
/// below one of `angles` in one of the two cells, and above it in the other.
pub(super) fn find_creases_at_angles<C: SheetCells<N>, const N: usize>(
    normals: &ProjectedNormals<'_, C, N>,
    cones: &ConePyramid,
    lattice: &ContourLattice,
    angles: &[f64],
    unsigned: bool,
    job: &Job<'_>,
) -> Result<Vec<([u32; 2], DVec2)>> {
    let angle = |[i, j]: [usize; 2], [u, v]: [f64; 2]| {
        let normal = normals.cells.cell_patch(i, j).jet(u, v).normal();
        let [x, y, z] = normals.frame.map(|axis| axis.dot(normal));
        libm::atan2((x * x + y * y).sqrt(), if unsigned { z.abs() } else { z })
    };
    // An angle can be skipped only if it is in the joint range of a block and the blocks behind it.
    let may_jump = |r: usize, c: usize| {
        let behind = |k: usize, d: usize| if k + 1 == lattice.block_counts()[d] { 0 } else { k + 1 };
        let around = [(r, c), (behind(r, 0), c), (r, behind(c, 1))];
        let ranges = around
            .into_iter()
            .filter_map(|(r, c)| Some(cones.cone_of_block(0, r, c)?.angle_range_to(normals.frame[2])));
        let whole = ranges.fold([PI, 0.0], |[low, high]: [f64; 2], [from, to]| [low.min(from), high.max(to)]);
        cone_culling::may_have_angle(angles, unsigned, whole)
    };
    let [rows, columns] = lattice.counts;
    let (mut found, mut jumps_in) = (Vec::new(), Vec::new());
    for i in 0..rows {
        job.step(i as f64 / rows as f64, "creases")?;
        if i % CELLS_PER_BLOCK_SIDE == 0 {
            jumps_in.clear();
            jumps_in.extend((0..lattice.block_counts()[1]).map(|c| may_jump(i / CELLS_PER_BLOCK_SIDE, c)));
        }
        for j in (0..columns).filter(|j| jumps_in[j / CELLS_PER_BLOCK_SIDE]) {
            for direction in 0..2 {
                let (behind, end) = lattice.owner_of_side_or_corner([i, j], [direction == 0, direction == 1]);
                if end != [false; 2] {
                    continue;
                }
                // A place of the side, which is line 1 of the cell and line 0 of the cell behind
                // it.
                let at = |t: f64, line: f64| if direction == 0 { [line, t] } else { [t, line] };
                let [[a, b], [c, d]] =
                    [([i, j], 1.0), (behind, 0.0)].map(|(cell, line)| [0.0, 1.0].map(|t| angle(cell, at(t, line))));
                let jumps =
                    |goal: &f64| (a.max(b) < *goal && *goal < c.min(d)) || (c.max(d) < *goal && *goal < a.min(b));
                if angles.iter().any(jumps) {
                    alloc::push(&mut found, ([i as u32, j as u32], DVec2::from_array(at(0.5, 1.0))))?;
                }
            }
        }
    }
    Ok(found)
}
