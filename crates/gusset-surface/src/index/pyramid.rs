//! The pyramid of boxes of one sheet.

use super::super::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use super::boxes::{ChildBoxes, OrientedBox};
use super::normal_cones::ConePyramid;
use super::schedule::block_rows_per_task;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, par};
use std::sync::OnceLock;

/// Number of levels with oriented boxes, beginning with the lowest.
const LEVELS_WITH_ORIENTED_BOXES: usize = 4;

/// The pyramid of one sheet.
#[derive(Debug)]
pub(crate) struct BoxPyramid {
    origin: DVec3,
    /// The levels, from the blocks up to the root's four children.
    levels: Vec<BoxLevel>,
    /// For each block, a box of the vectors from the bilinear patches of its cells to the surface.
    displacements: Vec<PackedDisplacementBox>,
    cones: OnceLock<ConePyramid>,
}

/// A box of vectors in 10 bytes: low x, y, z and high x, y, z in units of 1 / 127 of the largest
/// length.
#[derive(Debug, Clone, Copy, Default)]
struct PackedDisplacementBox {
    max_length: f32,
    scaled_bounds: [i8; 6],
}

impl PackedDisplacementBox {
    /// Packs a box, rounding outwards.
    fn new(bounds: Aabb) -> PackedDisplacementBox {
        let max_length = (bounds.max_vector_length() as f32).next_up();
        let unit = f64::from(max_length) / 127.0;
        // No vector is longer than `max_length`, so quotients are within -127 to 127, except for
        // rounding.
        let low = bounds.low.to_array().map(|x| (x / unit - 1e-9).floor() as i8);
        let high = bounds.high.to_array().map(|x| (x / unit + 1e-9).ceil() as i8);
        PackedDisplacementBox { max_length, scaled_bounds: [low[0], low[1], low[2], high[0], high[1], high[2]] }
    }

    #[inline(always)]
    fn unpack(&self) -> Aabb {
        let unit = f64::from(self.max_length) / 127.0;
        let [a, b, c, d, e, f] = self.scaled_bounds.map(|x| f64::from(x) * unit);
        Aabb { low: DVec3::new(a, b, c), high: DVec3::new(d, e, f) }
    }
}

/// The boxes of one level.
#[derive(Debug)]
pub(crate) struct BoxLevel {
    rows: usize,
    columns: usize,
    /// Indexed by the block of the level above.
    child_boxes: Vec<ChildBoxes>,
    oriented: Vec<OrientedBox>,
}

impl BoxLevel {
    fn new(rows: usize, columns: usize, oriented: bool) -> Result<Self> {
        Ok(BoxLevel {
            rows,
            columns,
            child_boxes: alloc::filled(ChildBoxes::EMPTY, rows.div_ceil(2) * columns.div_ceil(2))?,
            oriented: alloc::filled(OrientedBox::default(), if oriented { rows * columns } else { 0 })?,
        })
    }

    /// True if block (r, c) exists.
    #[inline(always)]
    pub(crate) fn has_block(&self, r: usize, c: usize) -> bool {
        r < self.rows && c < self.columns
    }

    /// The boxes of the children of block (r, c) of the level above.
    #[inline(always)]
    pub(crate) fn child_boxes(&self, r: usize, c: usize) -> &ChildBoxes {
        &self.child_boxes[r * self.columns.div_ceil(2) + c]
    }

    /// The oriented box of block (r, c), if this level has oriented boxes.
    #[inline(always)]
    pub(crate) fn oriented_box(&self, r: usize, c: usize) -> Option<&OrientedBox> {
        self.oriented.get(r * self.columns + c)
    }
}

impl BoxPyramid {
    /// Builds the index on the job's threads.
    pub(crate) fn build<const N: usize>(cells: &impl SheetCells<N>, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = cells.cell_counts().map(|count| count.div_ceil(CELLS_PER_BLOCK_SIDE));
        let origin = centre_of_some_corners(cells);
        let mut base = BoxLevel::new(rows, columns, true)?;
        let mut displacements = alloc::filled(PackedDisplacementBox::default(), rows * columns)?;
        let (across, rows_together) = (columns.div_ceil(2), block_rows_per_task(columns));
        let parts = base.child_boxes.chunks_mut(rows_together / 2 * across);
        let parts = parts.zip(base.oriented.chunks_mut(rows_together * columns));
        let parts = parts.zip(displacements.chunks_mut(rows_together * columns)).enumerate();
        par::map_cancellable(&job.sub_job(0.0, 0.8), "index", parts, |(k, ((groups, oriented), displacements))| {
            let first = rows_together * k;
            let mut bounds = alloc::filled(Aabb::EMPTY, displacements.len())?;
            cells.fill_displacement_boxes(first..first + displacements.len() / columns, &mut bounds)?;
            let parts = oriented.chunks_mut(columns).zip(displacements.chunks_mut(columns)).zip(bounds.chunks(columns));
            for (r, ((oriented, displacements), bounds)) in parts.enumerate() {
                let groups = &mut groups[r / 2 * across..][..across];
                build_block_row(cells, first + r, origin, bounds, groups, oriented, displacements);
            }
            Ok(())
        })?
        .into_iter()
        .collect::<Result<()>>()?;
        job.step(0.8, "index")?;
        let mut levels = vec![base];
        while let Some(last) = levels.last().filter(|last| last.child_boxes.len() > 1) {
            let next = box_level_above(last, levels.len() < LEVELS_WITH_ORIENTED_BOXES)?;
            levels.push(next);
        }
        Ok(BoxPyramid { origin, levels, displacements, cones: OnceLock::new() })
    }

    /// The point that coordinates of boxes are relative to.
    pub(crate) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The levels, beginning with the blocks.
    pub(crate) fn levels(&self) -> &[BoxLevel] {
        &self.levels
    }

    /// An upper bound of the distance between the surface and the bilinear patches of the cells of
    /// block (r, c), at equal parameters.
    #[inline(always)]
    pub(crate) fn distance_bound_from_bilinear_patches(&self, r: usize, c: usize) -> f64 {
        self.displacements[r * self.levels[0].columns + c].max_length.into()
    }

    /// A box of the vectors from the bilinear patches of the cells of block (r, c) to the surface,
    /// at equal parameters.
    #[inline(always)]
    pub(crate) fn displacement_box(&self, r: usize, c: usize) -> Aabb {
        self.displacements[r * self.levels[0].columns + c].unpack()
    }

    /// The bounding box of the sheet.
    pub(crate) fn bounding_box(&self) -> Aabb {
        let whole = self.levels.last().map_or(Aabb::EMPTY, |level| level.child_boxes(0, 0).union_of_children());
        Aabb { low: whole.low + self.origin, high: whole.high + self.origin }
    }

    /// Size in bytes, without the cones.
    pub(crate) fn byte_size(&self) -> usize {
        let level = |level: &BoxLevel| size_of_val(&level.child_boxes[..]) + size_of_val(&level.oriented[..]);
        self.levels.iter().map(level).sum::<usize>() + size_of_val(&self.displacements[..])
    }

    /// The cones, built at the first call. Two threads may build them at once, with equal bits. A
    /// thread does not wait for the other one, which may be its own caller.
    pub(crate) fn get_or_build_cones<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        job: &Job<'_>,
    ) -> Result<&ConePyramid> {
        if let Some(cones) = self.cones.get() {
            return Ok(cones);
        }
        let Aabb { low, high } = self.bounding_box();
        let made = ConePyramid::build(cells, low.abs().max(high.abs()).max_element(), job)?;
        // The surface keeps this memory, so it must not come from the reserve.
        job.check_memory()?;
        Ok(self.cones.get_or_init(|| made))
    }

    /// The cones, if they were built.
    pub(crate) fn cones_if_built(&self) -> Option<&ConePyramid> {
        self.cones.get()
    }

    /// Makes the cones exclude nothing, for comparisons in tests.
    #[cfg(test)]
    pub(crate) fn replace_cones_by_full_cones(&mut self) {
        self.cones.get_mut().into_iter().for_each(ConePyramid::replace_all_by_full_cones);
    }
}

/// A point in the middle of the surface: the centre of the bounding box of some of its corners.
fn centre_of_some_corners<const N: usize>(cells: &impl SheetCells<N>) -> DVec3 {
    let [rows, columns] = cells.cell_counts();
    let places = (0..=8).flat_map(|k| (0..=8).map(move |n| (k * rows / 8, n * columns / 8)));
    Aabb::from_points(places.map(|(i, j)| cells.corner_point(i, j))).centre()
}

/// Builds the boxes of a row of blocks. `bounds` are the displacement boxes of its blocks.
fn build_block_row<const N: usize>(
    cells: &impl SheetCells<N>,
    row: usize,
    origin: DVec3,
    bounds: &[Aabb],
    groups: &mut [ChildBoxes],
    oriented: &mut [OrientedBox],
    displacements: &mut [PackedDisplacementBox],
) {
    let [rows, columns] = cells.cell_counts();
    let (first, last) = (row * CELLS_PER_BLOCK_SIDE, rows.min((row + 1) * CELLS_PER_BLOCK_SIDE));
    let mut points = [DVec3::ZERO; (CELLS_PER_BLOCK_SIDE + 1) * (CELLS_PER_BLOCK_SIDE + 1)];
    for (c, &displacement) in bounds.iter().enumerate() {
        let (left, right) = (c * CELLS_PER_BLOCK_SIDE, columns.min((c + 1) * CELLS_PER_BLOCK_SIDE));
        let mut count = 0;
        let mut hull = Aabb::EMPTY;
        for i in first..=last {
            for j in left..=right {
                points[count] = cells.corner_point(i, j) - origin;
                hull.add(points[count]);
                count += 1;
            }
        }
        // Enlarged by the rounding of the coordinates in these steps.
        let size = hull.low.abs().max(hull.high.abs()).max(origin.abs()).max_element();
        let displacement = displacement.grown_by(16.0 * f64::EPSILON * size);
        displacements[c] = PackedDisplacementBox::new(displacement);
        groups[c / 2].set_child_box(2 * (row % 2) + c % 2, hull.minkowski_sum(displacement));
        let width = right - left + 1;
        let (a, b) = (points[0], points[width - 1]);
        let (d, e) = (points[count - width], points[count - 1]);
        oriented[c] = OrientedBox::from_points(&points[..count], d + e - a - b, b + e - a - d, displacement);
    }
}

/// Builds the level above another one.
fn box_level_above(below: &BoxLevel, with_oriented: bool) -> Result<BoxLevel> {
    let (rows, columns) = (below.rows.div_ceil(2), below.columns.div_ceil(2));
    let mut level = BoxLevel::new(rows, columns, with_oriented)?;
    for r in 0..rows {
        for c in 0..columns {
            let group = below.child_boxes(r, c);
            level.child_boxes[r / 2 * columns.div_ceil(2) + c / 2]
                .set_child_box(2 * (r % 2) + c % 2, group.union_of_children());
            if with_oriented {
                level.oriented[r * columns + c] = oriented_box_above(below, r, c);
            }
        }
    }
    Ok(level)
}

/// The oriented box around the boxes of the children of block (r, c).
fn oriented_box_above(below: &BoxLevel, r: usize, c: usize) -> OrientedBox {
    let mut points = [DVec3::ZERO; 32];
    let mut centres = [None; 4];
    let mut count = 0;
    for (child, centre) in centres.iter_mut().enumerate() {
        let (row, column) = (2 * r + child / 2, 2 * c + child % 2);
        if row < below.rows && column < below.columns {
            let corners = below.oriented[row * below.columns + column].corners();
            points[count..count + 8].copy_from_slice(&corners);
            *centre = Some(0.5 * (corners[0] + corners[7]));
            count += 8;
        }
    }
    // Axes from child to child, or the axes of a single child.
    let span = |pairs: [(usize, usize); 2], own: DVec3| {
        let steps = pairs.into_iter().filter_map(|(a, b)| Some(centres[b]? - centres[a]?));
        let sum: DVec3 = steps.sum();
        if sum == DVec3::ZERO { own } else { sum }
    };
    let along_u = span([(0, 2), (1, 3)], points[1] - points[0]);
    let along_v = span([(0, 1), (2, 3)], points[2] - points[0]);
    let exactly = Aabb { low: DVec3::ZERO, high: DVec3::ZERO };
    OrientedBox::from_points(&points[..count], along_u, along_v, exactly)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that packed boxes contain the exact boxes. No side moves outwards by more than
    /// `max_length` / 127. `max_length` is at least the length of every displacement in the box.
    #[test]
    fn packed_boxes_contain_the_exact_boxes() {
        for k in 0..4000_u32 {
            let part = |by: u32| f64::from(k.wrapping_mul(by) >> 8) / f64::from(1 << 23) - 1.0;
            let (a, b) = (
                DVec3::new(part(2_654_435_761), part(2_246_822_519), part(3_266_489_917)),
                DVec3::new(part(668_265_263), part(374_761_393), part(2_869_860_233)),
            );
            // Thin boxes, boxes that touch 0, and points.
            let b = [b, a + 1e-3 * b, a, DVec3::ZERO][k as usize % 4];
            let bounds = Aabb::from_points([a, b]);
            let packed = PackedDisplacementBox::new(bounds);
            let (held, length) = (packed.unpack(), f64::from(packed.max_length));
            assert!(
                length >= bounds.max_vector_length() && length <= bounds.max_vector_length() * (1.0 + 1e-6),
                "{bounds:?}"
            );
            let off = (bounds.low - held.low).min(held.high - bounds.high);
            assert!(off.min_element() >= 0.0, "{bounds:?} {held:?}");
            let off = (bounds.low - held.low).max(held.high - bounds.high);
            assert!(off.max_element() <= length / 127.0 * (1.0 + 1e-6), "{bounds:?} {held:?}");
        }
    }
}
