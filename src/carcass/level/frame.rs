//! Points with their normals, without making patches.

use crate::carcass::axis::{Axis, TAPS};
use crate::carcass::{Carcass, Grid, Jet, Place, Sheet};
use glam::DVec3;

/// The weights of the nodes that a parameter within a cell depends on, and those of the derivative.
fn weights(axis: &Axis, cell: usize, t: f64) -> ([usize; TAPS], [[f64; 2]; TAPS]) {
    let (lines, weights) = axis.taps(cell);
    let s = 1.0 - t;
    let bernstein = [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t];
    let slopes = [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t];
    let sum = |by: &[f64; 4], node: usize| (0..4).map(|b| by[b] * weights[b][node]).sum();
    (lines, std::array::from_fn(|node| [sum(&bernstein, node), sum(&slopes, node)]))
}

impl Grid<'_> {
    /// The point at parameters (u, v) of a cell, S_u and S_v.
    fn frame(&self, [i, j]: [usize; 2], u: f64, v: f64) -> [DVec3; 3] {
        let [across, along] = self.axes();
        let ((rows, by_u), (columns, by_v)) = (weights(across, i, u), weights(along, j, v));
        let mut sums = [DVec3::ZERO; 3];
        for (row, [weight, slope]) in rows.into_iter().zip(by_u) {
            let (mut point, mut tangent) = (DVec3::ZERO, DVec3::ZERO);
            for (&column, by) in columns.iter().zip(&by_v) {
                let node = self.nodes().get(row, column);
                point += by[0] * node;
                tangent += by[1] * node;
            }
            sums[0] += weight * point;
            sums[1] += slope * point;
            sums[2] += weight * tangent;
        }
        sums
    }
}

impl Carcass<'_> {
    /// The point at a place and the unit normal there, or its limit at a pole.
    pub(super) fn point_and_normal(&self, place: Place) -> (DVec3, DVec3) {
        let cell = place.cell.map(|k| k as usize);
        let jet = match self.sheet(place.sheet as usize) {
            Sheet::Grid(grid) => {
                let [point, u, v] = grid.frame(cell, place.u, place.v);
                Jet { point, u, v, uu: DVec3::ZERO, uv: DVec3::ZERO, vv: DVec3::ZERO }
            }
            sheet => sheet.jet(cell[0], cell[1], place.u, place.v),
        };
        (jet.point, self.normal_by(place, &jet))
    }
}
