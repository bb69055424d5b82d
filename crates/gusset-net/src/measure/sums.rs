//! Area, volume and bounding box, row by row in vector lanes. O(nodes), no memory that depends on
//! the net.

use crate::chunks::lines_per_block;
use crate::hidden_cells::HiddenCells;
use crate::{Net, Real, XyzMatrices, each};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::simd::{self, Kernel};

/// Cells, or nodes, that are computed before they are summed.
const CELLS_PER_CHUNK: usize = 64;

/// Partial sums that are accumulated in parallel.
const SUM_LANES: usize = 8;

/// The results of [`measure`]. Cells with a missing node and cells of hidden bridges do not count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// The area of all cells.
    pub area: f64,
    /// The sum of the area vectors; zero for closed surfaces.
    pub area_vector: DVec3,
    /// The enclosed volume of a closed surface, positive if the normals point outwards. For an open
    /// surface, the volume of the cone over it with its apex at the first existing node.
    pub volume: f64,
    /// The smallest coordinates of existing nodes; above `high` if all nodes are missing.
    pub low: DVec3,
    /// The largest coordinates.
    pub high: DVec3,
}

/// Area, volume and bounding box. O(nodes), with constant extra memory.
///
/// # Errors
/// [`Error::Cancelled`](gusset_base::Error::Cancelled),
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub fn measure(net: &Net<'_>, job: &Job<'_>) -> Result<Measures> {
    let sign = if net.topology().is_reversed() { -1.0 } else { 1.0 };
    let origin = first_existing_node(net);
    let total = each!(net.coordinates(), planes => {
        let hidden = HiddenCells::new(net)?;
        let ([rows, columns], part) = ([net.shape().rows(), net.shape().columns()], job.sub_job(0.0, 0.7));
        let parts = par::map_cancellable(&part, "measure", par::split_into_ranges(rows - 1, lines_per_block(columns - 1)), |rows| {
            rows.fold(AreaAndVolumeSums::default(), |sums, i| sums.add(sum_row(planes, &hidden, i, origin)))
        })?;
        parts.into_iter().fold(AreaAndVolumeSums::default(), AreaAndVolumeSums::add)
    });
    let Aabb { low, high } = bounds(net, &job.sub_job(0.7, 1.0))?;
    Ok(Measures {
        area: total.lengths / 2.0,
        area_vector: sign * total.vector / 2.0,
        volume: sign * total.cones / 24.0,
        low,
        high,
    })
}

/// Returns the first existing node. Volumes and moments are computed relative to it, because
/// distant nets would lose digits.
pub(super) fn first_existing_node(net: &Net<'_>) -> DVec3 {
    let shape = net.shape();
    let nodes = (0..shape.rows()).flat_map(|i| (0..shape.columns()).map(move |j| (i, j)));
    nodes.map(|(i, j)| net.get(i, j)).find(|point| point.is_finite()).unwrap_or(DVec3::ZERO)
}

/// Twice the area and the area vector, and 24 times the volume.
#[derive(Debug, Clone, Copy, Default)]
struct AreaAndVolumeSums {
    lengths: f64,
    vector: DVec3,
    cones: f64,
}

impl AreaAndVolumeSums {
    fn add(self, other: AreaAndVolumeSums) -> AreaAndVolumeSums {
        AreaAndVolumeSums {
            lengths: self.lengths + other.lengths,
            vector: self.vector + other.vector,
            cones: self.cones + other.cones,
        }
    }
}

fn sum_row<T: Real>(planes: &XyzMatrices<'_, T>, hidden: &HiddenCells, i: usize, origin: DVec3) -> AreaAndVolumeSums {
    let (above, below) = (planes.row(i), planes.row(i + 1));
    hidden.visible_runs(i).fold(AreaAndVolumeSums::default(), |sums, run| {
        let nodes = run.start..run.end + 1;
        let rows = [above, below].map(|rows| rows.map(|row| &row[nodes.clone()]));
        sums.add(simd::run(SumCellRowKernel { rows, origin: origin.to_array() }))
    })
}

/// A row of cells between two rows of nodes.
struct SumCellRowKernel<'a, T> {
    rows: [[&'a [T]; 3]; 2],
    origin: [f64; 3],
}

impl<T: Real> Kernel for SumCellRowKernel<'_, T> {
    type Output = AreaAndVolumeSums;

    #[inline(always)]
    fn run(self) -> AreaAndVolumeSums {
        let [above, below] = self.rows;
        let mut lanes = [[0.0; SUM_LANES]; 5];
        let mut cells = [[0.0; CELLS_PER_CHUNK]; 5];
        for start in (0..above[0].len() - 1).step_by(CELLS_PER_CHUNK) {
            let nodes = start..above[0].len().min(start + CELLS_PER_CHUNK + 1);
            // The entries that the last, shorter run does not overwrite.
            cells.iter_mut().for_each(|values| values[nodes.len() - 1..].fill(0.0));
            write_area_and_volume_terms(
                above.map(|row| &row[nodes.clone()]),
                below.map(|row| &row[nodes.clone()]),
                self.origin,
                &mut cells,
            );
            for (lanes, values) in lanes.iter_mut().zip(&cells) {
                for part in values.as_chunks::<SUM_LANES>().0 {
                    (0..SUM_LANES).for_each(|lane| lanes[lane] += part[lane]);
                }
            }
        }
        let [lengths, x, y, z, cones] = lanes.map(|lanes| lanes.into_iter().sum());
        AreaAndVolumeSums { lengths, vector: DVec3::new(x, y, z), cones }
    }
}

/// |N|, N and (a + b + c + d - 4 origin) . N of the cells between two rows of nodes; zeros for
/// cells with a missing corner.
#[inline(always)]
fn write_area_and_volume_terms<T: Real>(
    above: [&[T]; 3],
    below: [&[T]; 3],
    origin: [f64; 3],
    cells: &mut [[f64; CELLS_PER_CHUNK]; 5],
) {
    let [lengths, n_x, n_y, n_z, cones] = cells;
    let count = CELLS_PER_CHUNK.min(above[0].len() - 1);
    // Equal lengths, so that the loop needs no bounds checks.
    let [a_x, a_y, a_z] = above.map(|row| &row[..=count]);
    let [d_x, d_y, d_z] = below.map(|row| &row[..=count]);
    for j in 0..count {
        let a: [f64; 3] = [a_x[j].into(), a_y[j].into(), a_z[j].into()];
        let b: [f64; 3] = [a_x[j + 1].into(), a_y[j + 1].into(), a_z[j + 1].into()];
        let c: [f64; 3] = [d_x[j + 1].into(), d_y[j + 1].into(), d_z[j + 1].into()];
        let d: [f64; 3] = [d_x[j].into(), d_y[j].into(), d_z[j].into()];
        let p: [f64; 3] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let q: [f64; 3] = [d[0] - b[0], d[1] - b[1], d[2] - b[2]];
        let sum = [(a[0] + c[0]) + (b[0] + d[0]), (a[1] + c[1]) + (b[1] + d[1]), (a[2] + c[2]) + (b[2] + d[2])];
        let n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        let r = [sum[0] - 4.0 * origin[0], sum[1] - 4.0 * origin[1], sum[2] - 4.0 * origin[2]];
        // 0 times a coordinate is 0 unless it is NaN or infinite.
        let exists = 0.0 * sum[0] + 0.0 * sum[1] + 0.0 * sum[2] == 0.0;
        lengths[j] = if exists { (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt() } else { 0.0 };
        n_x[j] = if exists { n[0] } else { 0.0 };
        n_y[j] = if exists { n[1] } else { 0.0 };
        n_z[j] = if exists { n[2] } else { 0.0 };
        cones[j] = if exists { r[0] * n[0] + r[1] * n[1] + r[2] * n[2] } else { 0.0 };
    }
}

/// Returns the bounding box of all existing nodes.
///
/// # Errors
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
fn bounds(net: &Net<'_>, job: &Job<'_>) -> Result<Aabb> {
    each!(net.coordinates(), planes => {
        let lines = lines_per_block(net.shape().columns());
        let parts = par::map_cancellable(job, "measure", par::split_into_ranges(net.shape().rows(), lines), |rows| {
            rows.fold(Aabb::EMPTY, |bounds, i| bounds.union(simd::run(RowBoundsKernel(planes.row(i)))))
        })?;
        Ok(parts.into_iter().fold(Aabb::EMPTY, Aabb::union))
    })
}

/// The bounding box of a row of nodes.
struct RowBoundsKernel<'a, T>([&'a [T]; 3]);

impl<T: Real> Kernel for RowBoundsKernel<'_, T> {
    type Output = Aabb;

    #[inline(always)]
    fn run(self) -> Aabb {
        let mut low = [[T::from_f64(f64::INFINITY); SUM_LANES]; 3];
        let mut high = [[T::from_f64(f64::NEG_INFINITY); SUM_LANES]; 3];
        for start in (0..self.0[0].len()).step_by(CELLS_PER_CHUNK) {
            let rows = self.0.map(|row| &row[start..row.len().min(start + CELLS_PER_CHUNK)]);
            extend_bounds(rows, &mut low, &mut high);
        }
        let ends = |lanes: [[T; SUM_LANES]; 3], choose: fn(f64, f64) -> f64| {
            DVec3::from_array(lanes.map(|lanes| lanes.into_iter().map(T::into).reduce(choose).unwrap_or(f64::NAN)))
        };
        Aabb { low: ends(low, f64::min), high: ends(high, f64::max) }
    }
}

#[inline(always)]
fn extend_bounds<T: Real>(rows: [&[T]; 3], low: &mut [[T; SUM_LANES]; 3], high: &mut [[T; SUM_LANES]; 3]) {
    let count = CELLS_PER_CHUNK.min(rows[0].len());
    let [x, y, z] = rows.map(|row| &row[..count]);
    // 0, and NaN for missing nodes, which compares as not smaller and not larger. Entries after the
    // last node count as missing too.
    let (zero, mut missing) = (T::from_f64(0.0), [T::from_f64(f64::NAN); CELLS_PER_CHUNK]);
    for j in 0..count {
        missing[j] = zero * x[j] + zero * y[j] + zero * z[j];
    }
    for (axis, row) in [x, y, z].into_iter().enumerate() {
        let mut values = missing;
        for j in 0..count {
            values[j] = row[j] + values[j];
        }
        let (mut min, mut max) = (low[axis], high[axis]);
        for part in values.as_chunks::<SUM_LANES>().0 {
            for lane in 0..SUM_LANES {
                min[lane] = if part[lane] < min[lane] { part[lane] } else { min[lane] };
                max[lane] = if part[lane] > max[lane] { part[lane] } else { max[lane] };
            }
        }
        (low[axis], high[axis]) = (min, max);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_equal_for_any_vector_width() {
        let numbers = |k: usize| (0..2 * CELLS_PER_CHUNK + 13).map(|n| ((n * k) as f32).sin()).collect::<Vec<f32>>();
        let rows: [Vec<f32>; 6] = std::array::from_fn(|k| numbers(2 * k + 3));
        let rows = [0, 3].map(|k| [&rows[k][..], &rows[k + 1][..], &rows[k + 2][..]]);
        let strip = || SumCellRowKernel { rows, origin: [0.5, -1.0, 2.0] };
        let bits = |sums: AreaAndVolumeSums| {
            [sums.lengths, sums.vector.x, sums.vector.y, sums.vector.z, sums.cones].map(f64::to_bits)
        };
        assert_eq!(bits(simd::run(strip())), bits(strip().run()));
        assert_eq!(simd::run(RowBoundsKernel(rows[0])), RowBoundsKernel(rows[0]).run());
    }
}
