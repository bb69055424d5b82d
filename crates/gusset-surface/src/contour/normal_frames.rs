//! Points with their normals, computed without patches.

use crate::axis::{BezierWeights, GridAxis, NODES_PER_CUBIC};
use crate::{Grid, Jet, Place, Sheet, Surface};
use glam::DVec3;
use gusset_base::simd::{self, Kernel};

/// The nodes that a parameter within a cell depends on, their weights, and the weights of the
/// derivative.
#[inline(always)]
fn node_weights_at(axis: &GridAxis, cell: usize, t: f64) -> ([usize; NODES_PER_CUBIC], [[f64; NODES_PER_CUBIC]; 2]) {
    let (lines, weights) = axis.nodes_and_weights(cell);
    let s = 1.0 - t;
    let bernstein = [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t];
    let slopes = [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t];
    (lines, [blend_bezier_weights(&bernstein, weights), blend_bezier_weights(&slopes, weights)])
}

/// Sums of the nodes' weights in four Bézier points.
#[inline(always)]
fn blend_bezier_weights(by: &[f64; 4], weights: &BezierWeights) -> [f64; NODES_PER_CUBIC] {
    let mut sum = [0.0; NODES_PER_CUBIC];
    for (by, weights) in by.iter().zip(weights) {
        sum.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += by * weight);
    }
    sum
}

impl Grid<'_> {
    /// The point at parameters (u, v) of a cell, then S_u and S_v.
    #[inline(always)]
    fn point_and_tangents(&self, [i, j]: [usize; 2], u: f64, v: f64) -> [DVec3; 3] {
        let [across, along] = self.axes();
        let ((rows, [by_u, slopes_u]), (columns, [by_v, slopes_v])) =
            (node_weights_at(across, i, u), node_weights_at(along, j, v));
        let node = self.nodes().reader_of_four_numbers();
        // Most places are on a line of the surface, where the other lines have weight 0.
        if v == 0.0 || v == 1.0 {
            let [point, along_v, along_u] =
                weighted_node_sums([&by_v, &slopes_v], [&by_u, &slopes_u], |column, row| {
                    node(rows[row], columns[column])
                });
            return [point, along_u, along_v];
        }
        weighted_node_sums([&by_u, &slopes_u], [&by_v, &slopes_v], |row, column| node(rows[row], columns[column]))
    }
}

/// The sum of nodes, weighted by products of two weights. Then the sums in which the first or the
/// second weight is replaced by the weight of the derivative. Skips lines of weight 0.
#[inline(always)]
fn weighted_node_sums(
    [outer, outer_slopes]: [&[f64; NODES_PER_CUBIC]; 2],
    [inner, inner_slopes]: [&[f64; NODES_PER_CUBIC]; 2],
    node: impl Fn(usize, usize) -> [f64; 4],
) -> [DVec3; 3] {
    let [mut point, mut along_outer, mut along_inner] = [[0.0; 4]; 3];
    let add = |sum: &mut [f64; 4], weight: f64, node: &[f64; 4]| {
        sum.iter_mut().zip(node).for_each(|(sum, x)| *sum += weight * x);
    };
    for o in 0..NODES_PER_CUBIC {
        let (weight, slope) = (outer[o], outer_slopes[o]);
        if weight == 0.0 && slope == 0.0 {
            continue;
        }
        // Sums along the line come first, so that its points depend on no other nodes.
        let (mut sum, mut slopes) = ([0.0; 4], [0.0; 4]);
        for i in 0..NODES_PER_CUBIC {
            let node = node(o, i);
            add(&mut sum, inner[i], &node);
            add(&mut slopes, inner_slopes[i], &node);
        }
        add(&mut point, weight, &sum);
        add(&mut along_outer, slope, &sum);
        add(&mut along_inner, weight, &slopes);
    }
    let cut = |[x, y, z, _]: [f64; 4]| DVec3::new(x, y, z);
    [cut(point), cut(along_outer), cut(along_inner)]
}

/// Computes points and normals at places of a grid.
struct PointAndNormalKernel<'a> {
    surface: &'a Surface<'a>,
    places: &'a [Place],
    points: &'a mut [DVec3],
    normals: &'a mut [DVec3],
}

impl Kernel for PointAndNormalKernel<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for ((&place, point), normal) in self.places.iter().zip(self.points).zip(self.normals) {
            (*point, *normal) = self.surface.point_and_normal(place);
        }
    }
}

impl Surface<'_> {
    /// Computes [`Surface::point_and_normal`] for many places.
    pub(super) fn points_and_normals(&self, places: &[Place], points: &mut [DVec3], normals: &mut [DVec3]) {
        simd::run(PointAndNormalKernel { surface: self, places, points, normals });
    }

    /// The point at a place, and the unit normal there or its limit at a pole.
    #[inline(always)]
    pub(super) fn point_and_normal(&self, place: Place) -> (DVec3, DVec3) {
        let cell = place.cell.map(|k| k as usize);
        let jet = match self.sheet(place.sheet as usize) {
            Sheet::Grid(grid) => {
                let [point, u, v] = grid.point_and_tangents(cell, place.u, place.v);
                Jet { point, u, v, uu: DVec3::ZERO, uv: DVec3::ZERO, vv: DVec3::ZERO }
            }
            sheet => sheet.jet(cell[0], cell[1], place.u, place.v),
        };
        (jet.point, self.normal_with_known_jet(place, &jet))
    }
}
