//! Sources of the fields over cells, one for each kind of query.

use crate::axis::{GridAxis, NODES_PER_CUBIC};
use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use crate::subdivision::BernsteinField;
use glam::{DVec2, DVec3};
use gusset_base::geom::aabb::range_of_values;
use std::ops::Range;

/// How the fields of two cells agree along their common side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SideContinuity {
    /// The coefficients are equal to the last bit.
    Exact,
    /// The coefficients are equal except for rounding.
    UpToRounding,
    /// The fields may be discontinuous across the side.
    Discontinuous,
}

/// A field over each cell, for a number of levels.
pub(super) trait ContourSource<const M: usize>: Sync {
    /// The data that the cells of a block share.
    type BlockData;
    /// The data that the levels of a cell share.
    type CellData;
    /// Memory that the work on successive blocks reuses.
    type BlockCache: Default;

    /// Prepares a block of cells; `None` if no level crosses it.
    fn prepare_block(&self, cells: [Range<usize>; 2], cache: &mut Self::BlockCache) -> Option<Self::BlockData>;

    /// False if no level crosses a cell, by a cheap test.
    fn may_level_cross_cell(&self, _block: &Self::BlockData, _cell: [usize; 2]) -> bool {
        true
    }

    /// The data to test a cell by its corners, if they bound the field closely.
    #[inline]
    fn corner_test_data(&self, _block: &Self::BlockData, _cell: [usize; 2]) -> Option<CornerTestData> {
        None
    }

    /// The coefficients of the field along a side, bit for bit as in the cell's field. Only for
    /// sources with [`ContourSource::corner_test_data`].
    #[inline]
    fn field_coefficients_on_side(&self, _cell: [usize; 2], _side: usize, _level: usize) -> [f64; 4] {
        [0.0; 4]
    }

    /// The value that is subtracted for a level.
    #[inline]
    fn value_of_level(&self, _level: usize) -> f64 {
        0.0
    }

    /// Prepares a cell, whether or not a level crosses it.
    fn prepare_cell(
        &self,
        block: &Self::BlockData,
        cell: [usize; 2],
        cache: &mut Self::BlockCache,
    ) -> LevelsAndDataOfCell<Self::CellData>;

    /// The number of levels, at least 1.
    fn level_count(&self) -> usize {
        1
    }

    /// The field whose zero set belongs to a level.
    fn field_with_zeros_at_level(&self, base: &Self::CellData, level: usize) -> BernsteinField<M>;

    /// Whether an arc of the zero set of a cell's field belongs to the level, judged at three
    /// places on it. `None` if only a part of it does.
    fn does_arc_belong_to_level(
        &self,
        _cell: [usize; 2],
        _level: usize,
        _places: impl FnOnce() -> [DVec2; 3],
    ) -> Option<bool> {
        Some(true)
    }

    /// Bound of the deviation of the surface over a cell of the block, and of the field, from the
    /// bilinear ones through the cell's corners.
    fn bilinear_deviation(&self, _block: &Self::BlockData) -> f64 {
        f64::INFINITY
    }

    /// How cells agree along their sides.
    fn side_continuity(&self) -> SideContinuity;
}

/// The data of a cell that its levels share.
pub(super) struct LevelsAndDataOfCell<B> {
    /// The levels that may cross the cell.
    pub(super) levels: Range<usize>,
    /// Values up to this may be 0.
    pub(super) rounding_error: f64,
    /// The data that the levels share.
    pub(super) shared_data: B,
}

impl<const M: usize> LevelsAndDataOfCell<BernsteinField<M>> {
    /// Prepares a field from which levels are subtracted.
    #[inline]
    fn from_field(field: BernsteinField<M>, levels: &[f64], rounding_error: f64) -> Self {
        LevelsAndDataOfCell {
            levels: levels_between(levels, field.coefficient_range(), rounding_error),
            rounding_error,
            shared_data: field,
        }
    }
}

/// A field over a cell, known from its corners.
pub(super) struct CornerTestData {
    /// The levels that may cross the cell.
    pub(super) levels: Range<usize>,
    /// The values at the corners 2 u + v, from which levels are subtracted.
    pub(super) corners: [f64; 4],
    /// Bound of the difference between the coefficients of the field and of the bilinear field.
    pub(super) bilinear_deviation: f64,
    /// Values up to this may be 0.
    pub(super) rounding_error: f64,
}

/// The indices of the levels between `low` and `high`, with some slack. Levels are ascending.
#[inline]
pub(super) fn levels_between(levels: &[f64], [low, high]: [f64; 2], tolerance: f64) -> Range<usize> {
    if let &[level] = levels {
        return 0..usize::from(low - tolerance <= level && level <= high + tolerance);
    }
    let first = levels.partition_point(|&level| level < low - tolerance);
    let count = levels[first..].partition_point(|&level| level <= high + tolerance);
    first..first + count
}

/// Number of nodes in one direction that the cells of a block depend on.
const NODES_PER_WINDOW: usize = CELLS_PER_BLOCK_SIDE + NODES_PER_CUBIC - 1;

/// The scalars that the cells of a block depend on, and their weights.
pub(super) struct ScalarWindow {
    first_cell: [usize; 2],
    values: [[f64; NODES_PER_WINDOW]; NODES_PER_WINDOW],
    /// By direction and cell: the index of its first node.
    first_node_of_cell: [[usize; CELLS_PER_BLOCK_SIDE]; 2],
    rows: [[[f64; NODES_PER_CUBIC]; 4]; CELLS_PER_BLOCK_SIDE],
    /// By cell, node and coefficient.
    columns: [[[f64; 4]; NODES_PER_CUBIC]; CELLS_PER_BLOCK_SIDE],
}

impl ScalarWindow {
    /// Creates the window of the nodes that a block of cells depends on. `scalar_at_node` returns the scalar
    /// at a node.
    fn new(axes: [&GridAxis; 2], cells: &[Range<usize>; 2], scalar_at_node: impl Fn(usize, usize) -> f64) -> Self {
        let mut window = ScalarWindow {
            first_cell: [cells[0].start, cells[1].start],
            values: [[0.0; NODES_PER_WINDOW]; NODES_PER_WINDOW],
            first_node_of_cell: [[0; CELLS_PER_BLOCK_SIDE]; 2],
            rows: [[[0.0; NODES_PER_CUBIC]; 4]; CELLS_PER_BLOCK_SIDE],
            columns: [[[0.0; 4]; NODES_PER_CUBIC]; CELLS_PER_BLOCK_SIDE],
        };
        let mut lines = [[0; NODES_PER_WINDOW]; 2];
        let mut counts = [0; 2];
        for (d, (axis, range)) in axes.into_iter().zip(cells).enumerate() {
            let ([origin, ..], _) = axis.nodes_and_weights(range.start);
            for (k, cell) in range.clone().enumerate() {
                let (taps, weights) = axis.nodes_and_weights(cell);
                let first = if axis.is_closed() { k } else { taps[0] - origin };
                lines[d][first..first + NODES_PER_CUBIC].copy_from_slice(&taps);
                counts[d] = first + NODES_PER_CUBIC;
                window.first_node_of_cell[d][k] = first;
                if d == 0 {
                    window.rows[k] = *weights;
                } else {
                    window.columns[k] = std::array::from_fn(|node| std::array::from_fn(|b| weights[b][node]));
                }
            }
        }
        for (values, &i) in window.values.iter_mut().zip(&lines[0][..counts[0]]) {
            for (at, &j) in values.iter_mut().zip(&lines[1][..counts[1]]) {
                *at = scalar_at_node(i, j);
            }
        }
        // The last values repeat in place of missing ones.
        for values in &mut window.values[..counts[0]] {
            let last = values[counts[1] - 1];
            values[counts[1]..].fill(last);
        }
        let last = window.values[counts[0] - 1];
        window.values[counts[0]..].fill(last);
        window
    }

    /// The smallest and the largest scalar.
    fn scalar_range(&self) -> [f64; 2] {
        range_of_values(self.values.as_flattened().iter().copied())
    }

    /// The field over a cell. Sums along the rows come first, then across, so that the coefficients
    /// of a common side have the same bits in both cells.
    #[inline]
    fn cell_field(&self, [i, j]: [usize; 2]) -> BernsteinField<4> {
        let (r, c) = (i - self.first_cell[0], j - self.first_cell[1]);
        let (row, column) = (self.first_node_of_cell[0][r], self.first_node_of_cell[1][c]);
        let mut along = [[0.0; 4]; NODES_PER_CUBIC];
        for (sums, values) in along.iter_mut().zip(&self.values[row..]) {
            for (weights, value) in self.columns[c].iter().zip(&values[column..]) {
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    *sum += weight * value;
                }
            }
        }
        let mut field = BernsteinField { coefficients: [[0.0; 4]; 4] };
        for (sums, weights) in field.coefficients.iter_mut().zip(&self.rows[r]) {
            for (weight, values) in weights.iter().zip(&along) {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        field
    }
}

/// A block of cells with scalars at nodes.
pub(super) struct CornerScalarsOfBlock {
    cells: [Range<usize>; 2],
    /// The scalars at the corners of cells, if the deviation is finite.
    corners: [[f64; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1],
    /// Bound of how far the field over a cell may be outside the range of its corners.
    deviation: f64,
}

/// A lazily computed cache: the first cell of a block, and the scalars of the block's window. It is
/// filled when the corners of a cell do not decide.
type CachedWindow = Option<([usize; 2], ScalarWindow)>;

impl CornerScalarsOfBlock {
    /// The scalars at the corners 2 u + v of a cell.
    #[inline(always)]
    fn corner_values(&self, [i, j]: [usize; 2]) -> [f64; 4] {
        let (r, c) = (i - self.cells[0].start, j - self.cells[1].start);
        let [low, high] = [&self.corners[r], &self.corners[r + 1]];
        [low[c], low[c + 1], high[c], high[c + 1]]
    }

    /// A range of the field over a cell, from its corners.
    #[inline(always)]
    fn value_range(&self, cell: [usize; 2]) -> [f64; 2] {
        let [a, b, c, d] = self.corner_values(cell);
        // Comparisons instead of f64::min, because NaN may be ignored.
        let min = |a: f64, b: f64| if a < b { a } else { b };
        let max = |a: f64, b: f64| if a > b { a } else { b };
        [min(min(a, b), min(c, d)) - self.deviation, max(max(a, b), max(c, d)) + self.deviation]
    }
}

/// Scalars at nodes, interpolated like the nodes.
pub(super) struct NodalScalarSource<'a, F, D> {
    pub(super) axes: [&'a GridAxis; 2],
    pub(super) scalar_at_node: F,
    pub(super) levels: &'a [f64],
    pub(super) rounding_error: f64,
    /// Bound of how far values of cells may be outside the range of their nodes, relative to half
    /// of the range. The weights satisfy sum |w| <= 1 + `excess`.
    pub(super) excess: f64,
    /// For the first cell of a block: bound of how far the field over its cells may be outside the
    /// ranges of their corners.
    pub(super) deviation: D,
}

impl<F, D> ContourSource<4> for NodalScalarSource<'_, F, D>
where
    F: Fn(usize, usize) -> f64 + Sync,
    D: Fn(usize, usize) -> f64 + Sync,
{
    type BlockData = CornerScalarsOfBlock;
    type CellData = BernsteinField<4>;
    type BlockCache = CachedWindow;

    #[inline]
    fn prepare_block(&self, cells: [Range<usize>; 2], cache: &mut CachedWindow) -> Option<CornerScalarsOfBlock> {
        let deviation = (self.deviation)(cells[0].start, cells[1].start);
        let mut block = CornerScalarsOfBlock {
            cells,
            corners: [[0.0; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1],
            deviation,
        };
        if deviation.is_finite() {
            let [rows, columns] = &block.cells;
            for (i, values) in (rows.start..=rows.end).zip(&mut block.corners) {
                for (j, at) in (columns.start..=columns.end).zip(values) {
                    *at = (self.scalar_at_node)(i, j);
                }
            }
            return Some(block);
        }
        let [low, high] = self.scalar_window_of_block(&block, cache).scalar_range();
        let slack = 0.5 * self.excess * (high - low) + self.rounding_error;
        (!levels_between(self.levels, [low, high], slack).is_empty()).then_some(block)
    }

    #[inline]
    fn may_level_cross_cell(&self, block: &CornerScalarsOfBlock, cell: [usize; 2]) -> bool {
        !levels_between(self.levels, block.value_range(cell), self.rounding_error).is_empty()
    }

    /// A control point of the surface may differ by 2 deviations from the bilinear patch: see
    /// `projected_normals`.
    #[inline]
    fn corner_test_data(&self, block: &CornerScalarsOfBlock, cell: [usize; 2]) -> Option<CornerTestData> {
        block.deviation.is_finite().then(|| CornerTestData {
            levels: levels_between(self.levels, block.value_range(cell), self.rounding_error),
            corners: block.corner_values(cell),
            bilinear_deviation: 2.0 * block.deviation,
            rounding_error: self.rounding_error,
        })
    }

    #[inline]
    fn value_of_level(&self, level: usize) -> f64 {
        self.levels[level]
    }

    #[inline]
    fn field_coefficients_on_side(&self, [i, j]: [usize; 2], side: usize, level: usize) -> [f64; 4] {
        let along_u = side.is_multiple_of(2);
        let across = if along_u { j } else { i } + usize::from(side == 1 || side == 2);
        let (axis, cell) = if along_u { (self.axes[0], i) } else { (self.axes[1], j) };
        let ((lines, weights), place) = (axis.nodes_and_weights(cell), axis.index_of_interval_among_its_nodes(cell));
        let mut values = [0.0; NODES_PER_CUBIC];
        for (value, line) in values.iter_mut().zip(lines) {
            *value = if along_u { (self.scalar_at_node)(line, across) } else { (self.scalar_at_node)(across, line) };
        }
        // Sums in the same order as the window, so that results have the same bits.
        let sum = |weights: &[f64; NODES_PER_CUBIC]| {
            weights.iter().zip(&values).fold(0.0, |sum, (weight, x)| sum + weight * x)
        };
        let (inner, level) = ([sum(&weights[1]), sum(&weights[2])], self.levels[level]);
        [values[place] - level, inner[0] - level, inner[1] - level, values[place + 1] - level]
    }

    #[inline]
    fn prepare_cell(
        &self,
        block: &CornerScalarsOfBlock,
        cell: [usize; 2],
        cache: &mut CachedWindow,
    ) -> LevelsAndDataOfCell<BernsteinField<4>> {
        LevelsAndDataOfCell::from_field(
            self.scalar_window_of_block(block, cache).cell_field(cell),
            self.levels,
            self.rounding_error,
        )
    }

    fn level_count(&self) -> usize {
        self.levels.len().max(1)
    }

    #[inline]
    fn field_with_zeros_at_level(&self, base: &BernsteinField<4>, level: usize) -> BernsteinField<4> {
        subtract_level(base, self.levels[level])
    }

    #[inline]
    fn bilinear_deviation(&self, block: &CornerScalarsOfBlock) -> f64 {
        block.deviation
    }

    fn side_continuity(&self) -> SideContinuity {
        SideContinuity::Exact
    }
}

impl<F: Fn(usize, usize) -> f64, D> NodalScalarSource<'_, F, D> {
    fn scalar_window_of_block<'a>(
        &self,
        block: &CornerScalarsOfBlock,
        cache: &'a mut CachedWindow,
    ) -> &'a ScalarWindow {
        let first = [block.cells[0].start, block.cells[1].start];
        if cache.as_ref().is_some_and(|(of, _)| *of != first) {
            *cache = None;
        }
        &cache.get_or_insert_with(|| (first, ScalarWindow::new(self.axes, &block.cells, &self.scalar_at_node))).1
    }
}

/// The field minus a number.
#[inline]
fn subtract_level<const M: usize>(base: &BernsteinField<M>, level: f64) -> BernsteinField<M> {
    BernsteinField { coefficients: base.coefficients.map(|row| row.map(|x| x - level)) }
}

/// The signed distance from a plane, on patches.
pub(super) struct PlaneDistanceSource<'a, C, const N: usize> {
    pub(super) cells: &'a C,
    pub(super) normal: DVec3,
    pub(super) origin: DVec3,
    pub(super) levels: &'a [f64],
    pub(super) rounding_error: f64,
}

impl<C: SheetCells<N>, const N: usize> ContourSource<N> for PlaneDistanceSource<'_, C, N> {
    type BlockData = ();
    type CellData = BernsteinField<N>;
    type BlockCache = ();

    fn prepare_block(&self, _: [Range<usize>; 2], (): &mut ()) -> Option<()> {
        Some(())
    }

    fn prepare_cell(&self, (): &(), [i, j]: [usize; 2], (): &mut ()) -> LevelsAndDataOfCell<BernsteinField<N>> {
        let patch = self.cells.cell_patch(i, j);
        let heights = BernsteinField {
            coefficients: patch.points.map(|row| row.map(|point| (point - self.origin).dot(self.normal))),
        };
        LevelsAndDataOfCell::from_field(heights, self.levels, self.rounding_error)
    }

    fn level_count(&self) -> usize {
        self.levels.len().max(1)
    }

    fn field_with_zeros_at_level(&self, base: &BernsteinField<N>, level: usize) -> BernsteinField<N> {
        subtract_level(base, self.levels[level])
    }

    fn side_continuity(&self) -> SideContinuity {
        SideContinuity::Discontinuous
    }
}
