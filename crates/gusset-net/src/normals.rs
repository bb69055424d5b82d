//! Unit normals at the nodes.
//!
//! The normal of a vertex is the direction of a sum of cross products over the corners of its
//! cells. Each corner adds the cross product of the two sides that meet there. Cells are reduced
//! after gluing, and the sum includes the corners of all nodes of the class.
//!
//! At a node with four whole cells, the sum simplifies to the product of central differences, (E -
//! W) x (S - N), which is the fast path. Poles and seams need the full sum, because the sum over
//! unreduced cells vanishes at a pole. Invariant: nodes of one class get the same bits. O(nodes),
//! with memory for the glued nodes only.

use super::chunks::{lines_per_block, zip3};
use super::hidden_cells::HiddenCells;
use super::shape::rows_and_columns_of_corners;
use super::topology::{NodeGroups, ReducedCell};
use super::{Coordinates, Net, NodeClasses, Real, XyzMatrices};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::simd::{self, Kernel};

/// Classes that one thread takes at a time.
const CLASSES_PER_TASK: usize = 1 << 10;

const STAGE: &str = "normals";

/// Returns the unit normals of a net, and the number of nodes without a normal; see
/// [`normals_into`].
///
/// # Errors
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn normals(net: &Net<'_>, job: &Job<'_>) -> Result<(Coordinates<'static>, u64)> {
    let mut out = Coordinates::zeroed(net.shape(), net.coordinates().scalar())?;
    let without = normals_into(net, &mut out, job)?;
    Ok((out, without))
}

/// Writes the unit normal of every node, in the net's type; nodes of one class get the same bits.
/// Returns the number of nodes without a normal, which get zeros: missing nodes, and nodes where
/// the areas vanish or cancel.
///
/// The normal is the axis of the right-handed rotation from the direction of columns to the
/// direction of rows; it is opposite for reversed topologies. At open rims, next to missing nodes
/// and next to hidden bridges, only existing cells count. O(nodes), with memory for the glued nodes
/// only.
///
/// # Errors
/// [`Error::MixedScalars`] if the normals have another type, [`Error::ArrayTooShort`] if they have
/// another size, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn normals_into(net: &Net<'_>, out: &mut Coordinates<'_>, job: &Job<'_>) -> Result<u64> {
    if net.shape() != out.shape() {
        let (needed, given) = (net.shape().node_count() as u64, out.shape().node_count() as u64);
        return Err(Error::ArrayTooShort { what: "normals", needed, given });
    }
    match (net.coordinates(), out) {
        (Coordinates::F32(planes), Coordinates::F32(out)) => write_normals(net, planes, out, job),
        (Coordinates::F64(planes), Coordinates::F64(out)) => write_normals(net, planes, out, job),
        _ => Err(Error::MixedScalars),
    }
}

fn write_normals<T: Real>(
    net: &Net<'_>,
    planes: &XyzMatrices<'_, T>,
    out: &mut XyzMatrices<'_, T>,
    job: &Job<'_>,
) -> Result<u64> {
    job.step(0.0, STAGE)?;
    let corners = CornerNormalSums::new(net, planes)?;
    let without: u64 = write_unglued_normals(&corners, out, &job.sub_job(0.0, 0.8))?.into_iter().sum();
    Ok(without + write_glued_normals(&corners, out, &job.sub_job(0.8, 1.0))?)
}

/// The data for sums over the corners at a node.
struct CornerNormalSums<'a, T> {
    planes: &'a XyzMatrices<'a, T>,
    matrices: [&'a [T]; 3],
    hidden: HiddenCells,
    classes: NodeClasses,
    groups: NodeGroups,
    /// The nodes that are glued to others.
    glued: BitSet,
    sign: f64,
}

impl<'a, T: Real> CornerNormalSums<'a, T> {
    fn new(net: &'a Net<'_>, planes: &'a XyzMatrices<'_, T>) -> Result<Self> {
        let classes = NodeClasses::new(net.topology())?;
        let groups = classes.glued_classes()?;
        let mut glued = BitSet::new(net.shape().node_count())?;
        groups.nodes().iter().for_each(|&node| glued.insert(node));
        Ok(CornerNormalSums {
            planes,
            matrices: planes.matrices(),
            hidden: HiddenCells::new(net)?,
            classes,
            groups,
            glued,
            sign: if net.topology().is_reversed() { -1.0 } else { 1.0 },
        })
    }

    fn is_glued(&self, i: usize, j: usize) -> bool {
        self.glued.contains(self.planes.shape().node(i, j))
    }

    fn position(&self, i: usize, j: usize) -> DVec3 {
        let at = i * self.planes.stride() + j;
        DVec3::from_array(self.matrices.map(|matrix| matrix[at].into()))
    }

    /// Returns the sum over the corners of the existing cells at node (i, j). If several corners of
    /// a cell belong to one vertex, the cell counts once, at the first of them.
    fn sum_at_node(&self, i: usize, j: usize) -> BoundedVectorSum {
        let shape = self.planes.shape();
        let mut sum = BoundedVectorSum::default();
        for (ci, corner_row) in [(i.wrapping_sub(1), 1), (i, 0)] {
            for (cj, corner_column) in [(j.wrapping_sub(1), 1), (j, 0)] {
                if ci < shape.rows() - 1 && cj < shape.columns() - 1 && !self.hidden.contains(ci, cj) {
                    let corner = if corner_row == 0 { corner_column } else { 3 - corner_column };
                    sum = sum.add(BoundedVectorSum::new(self.corner_cross_product(ci, cj, corner)));
                }
            }
        }
        sum
    }

    /// Returns the cross product of the sides at a corner of cell (i, j); zero if the cell is
    /// missing or reduced to a line or a point.
    fn corner_cross_product(&self, i: usize, j: usize, corner: usize) -> DVec3 {
        let points = rows_and_columns_of_corners(i, j).map(|(i, j)| self.position(i, j));
        if !points.iter().all(|point| point.is_finite()) {
            return DVec3::ZERO;
        }
        let classes = self.classes.representatives_of_corners(i, j);
        let is_first = !classes[..corner].contains(&classes[corner]);
        if !is_first || ReducedCell::new(classes).polygon().is_none() {
            return DVec3::ZERO;
        }
        let other = |step: usize| {
            let mut places = (1..4).map(|k| (corner + k * step) % 4);
            places.find(|&place| classes[place] != classes[corner]).map_or(points[corner], |place| points[place])
        };
        (other(1) - points[corner]).cross(other(3) - points[corner])
    }

    /// Returns the unit vector along a sum, or zero if the terms cancel up to rounding.
    fn normalise_sum(&self, sum: BoundedVectorSum) -> DVec3 {
        // Scaled first, as squares of small sums would underflow.
        let largest = sum.vector.abs().max_element();
        if largest.is_finite() && largest > 8.0 * f64::EPSILON * sum.sum_of_norms {
            self.sign * (sum.vector / largest).normalize()
        } else {
            DVec3::ZERO
        }
    }

    /// Returns true if a node near (i, j) is missing.
    fn has_missing_neighbour(&self, i: usize, j: usize) -> bool {
        (i - 1..=i + 1).any(|i| (j - 1..=j + 1).any(|j| !self.position(i, j).is_finite()))
    }

    fn touches_hidden_cell(&self, i: usize, j: usize) -> bool {
        !self.hidden.is_empty() && (i - 1..=i).any(|i| (j - 1..=j).any(|j| self.hidden.contains(i, j)))
    }
}

/// A sum of vectors, and of their 1-norms, which bounds its rounding error.
#[derive(Debug, Clone, Copy, Default)]
struct BoundedVectorSum {
    vector: DVec3,
    sum_of_norms: f64,
}

impl BoundedVectorSum {
    fn new(vector: DVec3) -> Self {
        BoundedVectorSum { vector, sum_of_norms: vector.abs().element_sum() }
    }

    fn add(self, other: Self) -> Self {
        BoundedVectorSum { vector: self.vector + other.vector, sum_of_norms: self.sum_of_norms + other.sum_of_norms }
    }
}

/// Writes the normals of all nodes that are not glued; inner nodes use the fast path. Returns the
/// number of nodes without a normal for each block.
fn write_unglued_normals<T: Real>(
    corners: &CornerNormalSums<'_, T>,
    out: &mut XyzMatrices<'_, T>,
    job: &Job<'_>,
) -> Result<Vec<u64>> {
    let (shape, stride) = (out.shape(), out.stride());
    let lines = lines_per_block(stride);
    let blocks = zip3(out.matrices_mut().map(|matrix| matrix.chunks_mut(lines * stride)));
    par::map_cancellable(job, STAGE, blocks.enumerate(), |(block, matrices)| {
        let rows = zip3(matrices.map(|matrix| matrix.chunks_mut(stride))).enumerate();
        rows.map(|(line, rows)| {
            write_normals_of_row(corners, block * lines + line, rows.map(|row| &mut row[..shape.columns()]))
        })
        .sum()
    })
}

/// Writes the normals of row i, except at glued nodes. Returns the number of nodes without a
/// normal.
fn write_normals_of_row<T: Real>(corners: &CornerNormalSums<'_, T>, i: usize, mut out: [&mut [T]; 3]) -> u64 {
    let shape = corners.planes.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let mut without = 0;
    let mut exact = |j: usize, out: &mut [&mut [T]; 3]| {
        if corners.is_glued(i, j) {
            return;
        }
        let normal = corners.normalise_sum(corners.sum_at_node(i, j)).to_array();
        (0..3).for_each(|axis| out[axis][j] = T::from_f64(normal[axis]));
        without += u64::from(normal == [0.0; 3]);
    };
    // With three columns none of the differences reads the middle node, which may be missing.
    if i == 0 || i + 1 == h || w < 4 {
        (0..w).for_each(|j| exact(j, &mut out));
        return without;
    }
    exact(0, &mut out);
    exact(w - 1, &mut out);
    let rows = [i - 1, i, i + 1].map(|i| corners.planes.row(i));
    let [x, y, z] = &mut out;
    let all_in_range = simd::run(CentralDifferences { rows, sign: T::from_f64(corners.sign), x, y, z });
    let mut ends = [i - 1, i, i + 1].into_iter().flat_map(|i| [corners.position(i, 0), corners.position(i, w - 1)]);
    if !all_in_range || !ends.all(DVec3::is_finite) || !corners.hidden.is_empty() {
        for j in 1..w - 1 {
            // If the squared length overflowed or underflowed, the length is not 1.
            let square = DVec3::from_array([0, 1, 2].map(|axis| out[axis][j].into())).length_squared();
            let is_unit = (square - 1.0).abs() < 1e-5;
            if !is_unit || corners.has_missing_neighbour(i, j) || corners.touches_hidden_cell(i, j) {
                exact(j, &mut out);
            }
        }
    }
    without
}

/// Writes the normals of glued nodes, from the sum over all nodes of each class. Returns the
/// number of nodes without a normal.
fn write_glued_normals<T: Real>(
    corners: &CornerNormalSums<'_, T>,
    out: &mut XyzMatrices<'_, T>,
    job: &Job<'_>,
) -> Result<u64> {
    let (shape, groups) = (out.shape(), &corners.groups);
    let places = |k: usize| groups.get(k).iter().map(|&node| shape.row_and_column(node));
    let mut normals = alloc::zeroed(groups.len())?;
    par::map_cancellable(job, STAGE, normals.chunks_mut(CLASSES_PER_TASK).enumerate(), |(chunk, normals)| {
        for (normal, k) in normals.iter_mut().zip(CLASSES_PER_TASK * chunk..) {
            let sum = places(k).fold(BoundedVectorSum::default(), |sum, (i, j)| sum.add(corners.sum_at_node(i, j)));
            *normal = corners.normalise_sum(sum).to_array();
        }
    })?;
    let mut without = 0;
    let (stride, mut matrices) = (out.stride(), out.matrices_mut());
    for (k, normal) in normals.into_iter().enumerate() {
        for (i, j) in places(k) {
            (0..3).for_each(|axis| matrices[axis][i * stride + j] = T::from_f64(normal[axis]));
            without += u64::from(normal == [0.0; 3]);
        }
    }
    Ok(without)
}

/// Central differences for the middle one of three rows, without its first and last node. Returns
/// true if every squared length was in the range that keeps its digits.
struct CentralDifferences<'a, T> {
    rows: [[&'a [T]; 3]; 3],
    sign: T,
    x: &'a mut [T],
    y: &'a mut [T],
    z: &'a mut [T],
}

impl<T: Real> Kernel for CentralDifferences<'_, T> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        central_differences(self.rows, self.sign, self.x, self.y, self.z)
    }
}

/// This is a separate function, because only arguments are known not to alias.
#[inline(always)]
fn central_differences<T: Real>(
    [north, middle, south]: [[&[T]; 3]; 3],
    sign: T,
    x: &mut [T],
    y: &mut [T],
    z: &mut [T],
) -> bool {
    let (min, max) = (T::from_f64(1e-30), T::from_f64(1e30));
    let inner = x.len() - 2;
    let [west_x, west_y, west_z] = middle.map(|row| &row[..inner]);
    let [east_x, east_y, east_z] = middle.map(|row| &row[2..][..inner]);
    let [north_x, north_y, north_z] = north.map(|row| &row[1..][..inner]);
    let [south_x, south_y, south_z] = south.map(|row| &row[1..][..inner]);
    let (x, y, z) = (&mut x[1..][..inner], &mut y[1..][..inner], &mut z[1..][..inner]);
    let mut out_of_range = 0u32;
    for j in 0..inner {
        let (a, b, c) = (east_x[j] - west_x[j], east_y[j] - west_y[j], east_z[j] - west_z[j]);
        let (d, e, f) = (south_x[j] - north_x[j], south_y[j] - north_y[j], south_z[j] - north_z[j]);
        let (nx, ny, nz) = (b * f - c * e, c * d - a * f, a * e - b * d);
        let square = nx * nx + ny * ny + nz * nz;
        out_of_range += u32::from(!(square > min && square < max));
        let scale = sign / square.sqrt();
        x[j] = nx * scale;
        y[j] = ny * scale;
        z[j] = nz * scale;
    }
    out_of_range == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_equal_for_any_vector_width() {
        let numbers = |k: usize| (0..61).map(|n| ((n * k) as f32).sin()).collect::<Vec<f32>>();
        let rows: [Vec<f32>; 9] = std::array::from_fn(|k| numbers(2 * k + 3));
        let rows = [0, 3, 6].map(|k| [&rows[k][..], &rows[k + 1][..], &rows[k + 2][..]]);
        let [wide, narrow] = [true, false].map(|wide| {
            let [mut x, mut y, mut z] = [0; 3].map(|_| vec![0.0f32; 61]);
            let kernel = CentralDifferences { rows, sign: -1.0, x: &mut x, y: &mut y, z: &mut z };
            assert!(if wide { simd::run(kernel) } else { kernel.run() });
            [x, y, z].concat().into_iter().map(f32::to_bits).collect::<Vec<u32>>()
        });
        assert_eq!(wide, narrow);
        assert!(wide[1] != 0 && wide[0] == 0, "all but the first and the last");
    }
}
