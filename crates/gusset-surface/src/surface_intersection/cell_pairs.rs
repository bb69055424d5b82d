//! Pairs of cells that may meet. Both pyramids are descended together, and separated pairs of
//! blocks are discarded.
//!
//! Separating axes: Gottschalk, Lin and Manocha (1996, "OBBTree"). Invariant: boxes contain the
//! surface over their cells, so that no pair that meets is discarded. Cost: O(pairs of blocks close
//! to each other).

use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells, cells_of_block};
use crate::index::{BoxPyramid, OrientedBox};
use crate::{Sheet, Surface, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::sort;

/// A pair of cells of two surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellPair {
    /// The sheets of the first and of the second surface.
    pub sheets: [u32; 2],
    /// Row and column of the cell of the first surface, and of the second.
    pub cells: [[u32; 2]; 2],
}

/// Largest number of pairs of cells.
pub const MAX_PAIRS: u64 = 1 << 26;

/// Number of pairs of blocks, or of cells, between two progress reports.
const PAIRS_PER_REPORT: usize = 1 << 16;

/// A sheet and its index.
struct IndexedSheet<'a> {
    sheet_number: u32,
    sheet: &'a Sheet<'a>,
    index: &'a BoxPyramid,
}

/// A block of one of the sheets.
struct PyramidBlock {
    level: usize,
    row: usize,
    column: usize,
    bounds: Aabb,
    oriented_solid: Option<Parallelepiped>,
}

/// A parallelepiped: centre, half edges and their lengths, cross products of two half edges, and
/// the triple product of all.
#[derive(Clone, Copy)]
struct Parallelepiped {
    centre: DVec3,
    half_edges: [DVec3; 3],
    lengths: [f64; 3],
    normals: [DVec3; 3],
    volume: f64,
}

impl Parallelepiped {
    fn new(centre: DVec3, half: [DVec3; 3]) -> Parallelepiped {
        let [x, y, z] = half;
        let normals = [y.cross(z), z.cross(x), x.cross(y)];
        Parallelepiped {
            centre,
            half_edges: half,
            lengths: half.map(DVec3::length),
            normals,
            volume: x.dot(normals[0]).abs(),
        }
    }

    fn from_oriented_box(oriented: &OrientedBox, shift: DVec3) -> Parallelepiped {
        let (centre, half) = oriented.centre_and_half_edges();
        Parallelepiped::new(centre + shift, half)
    }

    /// False if a separating axis proves that the solids are farther apart than `gap`. The axes are
    /// the normals of faces, and the cross products of pairs of edges. Extents along them are sums
    /// of products of the half edges of one solid and the normals of the other.
    fn may_meet(&self, other: &Parallelepiped, gap: f64) -> bool {
        let between = other.centre - self.centre;
        let products = |one: &Parallelepiped, other: &Parallelepiped| {
            one.normals.map(|n| other.half_edges.map(|half| half.dot(n).abs()))
        };
        let beyond = |one: &Parallelepiped, products: &[[f64; 3]; 3]| {
            (0..3).any(|k| {
                let area = one.lengths[(k + 1) % 3] * one.lengths[(k + 2) % 3];
                between.dot(one.normals[k]).abs() > one.volume + products[k].iter().sum::<f64>() + gap * area
            })
        };
        let of_other = products(self, other);
        if beyond(self, &of_other) {
            return false;
        }
        let of_self = products(other, self);
        if beyond(other, &of_self) {
            return false;
        }
        // Half edges not parallel to the axis a x b contribute: (c, a, b) = (a x b, c), up to the
        // sign.
        let edges = |i: usize, j: usize| {
            let extent =
                of_other[(i + 1) % 3][j] + of_other[(i + 2) % 3][j] + of_self[(j + 1) % 3][i] + of_self[(j + 2) % 3][i];
            let across = between.dot(self.half_edges[i].cross(other.half_edges[j]));
            across.abs() > extent + gap * self.lengths[i] * other.lengths[j]
        };
        !(0..9).any(|k| edges(k / 3, k % 3))
    }
}

impl PyramidBlock {
    fn whole_sheet(index: &BoxPyramid, shift: DVec3) -> PyramidBlock {
        let bounds = translate_box(index.bounding_box(), shift - index.origin());
        PyramidBlock { level: index.levels().len(), row: 0, column: 0, bounds, oriented_solid: None }
    }

    /// Child k, if it exists and may be within `gap` of another block.
    fn child_near_block(
        &self,
        k: usize,
        index: &BoxPyramid,
        shift: DVec3,
        near: &PyramidBlock,
        gap: f64,
    ) -> Option<PyramidBlock> {
        let level = &index.levels()[self.level - 1];
        // The boxes of blocks that do not exist are empty.
        let bounds = translate_box(level.child_boxes(self.row, self.column).child_box(k), shift);
        if !are_boxes_within(&bounds, &near.bounds, gap) {
            return None;
        }
        let (row, column) = (2 * self.row + k / 2, 2 * self.column + k % 2);
        let solid = level.oriented_box(row, column).map(|oriented| Parallelepiped::from_oriented_box(oriented, shift));
        let apart =
            solid.as_ref().zip(near.oriented_solid.as_ref()).is_some_and(|(one, other)| !one.may_meet(other, gap));
        (!apart).then_some(PyramidBlock { level: self.level - 1, row, column, bounds, oriented_solid: solid })
    }

    fn longest_side(&self) -> f64 {
        (self.bounds.high - self.bounds.low).max_element()
    }
}

fn translate_box(bounds: Aabb, shift: DVec3) -> Aabb {
    Aabb { low: bounds.low + shift, high: bounds.high + shift }
}

fn are_boxes_within(a: &Aabb, b: &Aabb, gap: f64) -> bool {
    (a.low - gap).cmple(b.high).all() && (b.low - gap).cmple(a.high).all()
}

/// The quadrilateral of a cell, relative to the common origin: the points c + x a + y b + x y t for
/// x and y from -1 to 1.
#[derive(Clone, Copy)]
struct CellQuadrilateral {
    cell: [u32; 2],
    bounds: Aabb,
    centre: DVec3,
    half_edges: [DVec3; 2],
    twist: DVec3,
    lengths: [f64; 2],
    /// a x b, and the extent of t along it.
    normal: DVec3,
    max_height_over_plane: f64,
}

impl CellQuadrilateral {
    fn new(cell: [u32; 2], [[p, q], [r, s]]: [[DVec3; 2]; 2], bounds: Aabb) -> CellQuadrilateral {
        let half = [0.25 * (r + s - p - q), 0.25 * (q + s - p - r)];
        let (twist, normal) = (0.25 * (p + s - q - r), half[0].cross(half[1]));
        CellQuadrilateral {
            cell,
            bounds,
            centre: 0.25 * (p + q + r + s),
            half_edges: half,
            twist,
            lengths: half.map(DVec3::length),
            normal,
            max_height_over_plane: twist.dot(normal).abs(),
        }
    }

    /// False if a separating axis of the two parallelograms, with their twists added, proves that
    /// the quadrilaterals are farther apart than `gap`.
    fn may_meet(&self, other: &CellQuadrilateral, gap: f64) -> bool {
        if !are_boxes_within(&self.bounds, &other.bounds, gap) {
            return false;
        }
        let between = other.centre - self.centre;
        let along = |one: &CellQuadrilateral, other: &CellQuadrilateral| {
            other.half_edges.map(|half| half.dot(one.normal).abs())
        };
        let beyond = |one: &CellQuadrilateral, other: &CellQuadrilateral, [x, y]: [f64; 2]| {
            let extent = one.max_height_over_plane + x + y + other.twist.dot(one.normal).abs();
            between.dot(one.normal).abs() > extent + gap * one.lengths[0] * one.lengths[1]
        };
        let of_other = along(self, other);
        if beyond(self, other, of_other) {
            return false;
        }
        let of_self = along(other, self);
        if beyond(other, self, of_self) {
            return false;
        }
        let edges = |i: usize, j: usize| {
            let axis = self.half_edges[i].cross(other.half_edges[j]);
            let extent = of_other[j] + of_self[i] + self.twist.dot(axis).abs() + other.twist.dot(axis).abs();
            between.dot(axis).abs() > extent + gap * self.lengths[i] * other.lengths[j]
        };
        !(0..4).any(|k| edges(k / 2, k % 2))
    }
}

/// The corners of the cells of a block, and the cells that may meet another block.
struct BlockQuadrilaterals {
    block_row_and_column: [usize; 2],
    corners: [[DVec3; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1],
    /// Bound of the distance between the surface and the cells' quadrilaterals.
    deviation: f64,
    quads: Vec<CellQuadrilateral>,
}

impl BlockQuadrilaterals {
    const NO_BLOCK: BlockQuadrilaterals = BlockQuadrilaterals {
        block_row_and_column: [usize::MAX; 2],
        corners: [[DVec3::ZERO; CELLS_PER_BLOCK_SIDE + 1]; CELLS_PER_BLOCK_SIDE + 1],
        deviation: 0.0,
        quads: Vec::new(),
    };

    /// Reads the block at a node, unless it is the current one.
    fn read_block(&mut self, sheet: &IndexedSheet<'_>, node: &PyramidBlock, origin: DVec3) {
        if self.block_row_and_column == [node.row, node.column] {
            return;
        }
        self.block_row_and_column = [node.row, node.column];
        self.deviation = sheet.index.distance_bound_from_bilinear_patches(node.row, node.column);
        let [rows, columns] = sheet.sheet.cells();
        let [first, left] = self.block_row_and_column.map(|at| at * CELLS_PER_BLOCK_SIDE);
        each_sheet!(sheet.sheet, cells => {
            for (i, line) in (first..=rows).zip(&mut self.corners) {
                for (j, corner) in (left..=columns).zip(line) {
                    *corner = cells.corner_point(i, j) - origin;
                }
            }
        });
    }

    /// Selects the cells that may be within `gap` of a box.
    fn select_cells_near(&mut self, sheet: &Sheet<'_>, near: &Aabb, gap: f64) {
        self.quads.clear();
        for [i, j] in cells_of_block(self.block_row_and_column, sheet.cells()) {
            let (r, c) = (i % CELLS_PER_BLOCK_SIDE, j % CELLS_PER_BLOCK_SIDE);
            let corners = [0, 1].map(|k| [self.corners[r + k][c], self.corners[r + k][c + 1]]);
            let [[p, q], [s, t]] = corners;
            let bounds = Aabb { low: p.min(q).min(s.min(t)), high: p.max(q).max(s.max(t)) };
            if are_boxes_within(&bounds, near, gap) {
                self.quads.push(CellQuadrilateral::new([i as u32, j as u32], corners, bounds));
            }
        }
    }
}

impl Surface<'_> {
    /// Returns the pairs of cells of the two surfaces that may be within `within` of each other,
    /// sorted by sheets and cells. With 0, these are the pairs that may meet. The list is complete,
    /// and contains few other pairs.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the distance is negative or not finite; [`Error::TooLarge`]
    /// above [`MAX_PAIRS`]; [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn candidate_cell_pairs(&self, other: &Surface<'_>, within: f64, job: &Job<'_>) -> Result<Vec<CellPair>> {
        let sheet_pairs = (0..self.len()).flat_map(|k| (0..other.len()).map(move |n| [k, n]));
        self.candidate_pairs_among(sheet_pairs, other, (within, &|_| true), job)
    }

    /// Returns the pairs of cells of the surface with itself, each once. Omits pairs that are
    /// `proved` to have no undeclared common points. Around a pole, their number is the square of
    /// its cells.
    ///
    /// # Errors
    /// The errors of [`Surface::candidate_cell_pairs`].
    pub(super) fn candidate_pairs_of_itself(
        &self,
        within: f64,
        proved: &dyn Fn(&CellPair) -> bool,
        job: &Job<'_>,
    ) -> Result<Vec<CellPair>> {
        let once = (0..self.len()).flat_map(|k| (k..self.len()).map(move |n| [k, n]));
        let wanted = |pair: &CellPair| {
            let ([a, b], [p, q]) = (pair.sheets, pair.cells);
            (a, p) <= (b, q) && !proved(pair)
        };
        self.candidate_pairs_among(once, self, (within, &wanted), job)
    }

    fn candidate_pairs_among(
        &self,
        sheets: impl Iterator<Item = [usize; 2]>,
        other: &Surface<'_>,
        (within, wanted): (f64, &dyn Fn(&CellPair) -> bool),
        job: &Job<'_>,
    ) -> Result<Vec<CellPair>> {
        Error::require(within >= 0.0 && within.is_finite(), "within", within, "finite and at least 0")?;
        let mut cell_pairs = Vec::new();
        for [k, n] in sheets {
            let [a, b] = [(self, k), (other, n)].map(|(surface, k)| {
                let (sheet, index) = surface.sheet_and_index(k);
                IndexedSheet { sheet_number: k as u32, sheet, index }
            });
            add_pairs_of_sheets(&a, &b, (within, wanted), &mut cell_pairs, job)?;
        }
        Ok(cell_pairs)
    }
}

/// Adds the wanted pairs of cells of two sheets that may be within `within`, sorted.
fn add_pairs_of_sheets(
    a: &IndexedSheet<'_>,
    b: &IndexedSheet<'_>,
    (within, wanted): (f64, &dyn Fn(&CellPair) -> bool),
    found: &mut Vec<CellPair>,
    job: &Job<'_>,
) -> Result<()> {
    let origin = a.index.origin();
    let shift = b.index.origin() - origin;
    // Boxes contain the surface exactly, but the shift between the two origins rounds.
    let size = [a, b].map(|sheet| {
        let Aabb { low, high } = sheet.index.bounding_box();
        low.abs().max(high.abs()).max_element()
    });
    let by = within + 8.0 * f64::EPSILON * size[0].max(size[1]);
    let before = found.len();
    let blocks = [BlockQuadrilaterals::NO_BLOCK; 2];
    let mut descent = PyramidPairDescent {
        a,
        b,
        origin,
        shift,
        max_gap: by,
        is_wanted_pair: wanted,
        blocks,
        pairs_since_report: 0,
        cell_pairs: found,
        job,
    };
    descent.visit_block_pair(
        &PyramidBlock::whole_sheet(a.index, DVec3::ZERO),
        &PyramidBlock::whole_sheet(b.index, shift),
    )?;
    let key = |pair: &CellPair| {
        let [[i, j], [k, l]] = pair.cells.map(|cell| cell.map(u128::from));
        i << 96 | j << 64 | k << 32 | l
    };
    sort::sort(&mut found[before..], |one, other| key(one).cmp(&key(other)), &job.sub_job(0.0, 0.0), "pairs of cells")
}

/// The simultaneous descent of both pyramids.
struct PyramidPairDescent<'a> {
    a: &'a IndexedSheet<'a>,
    b: &'a IndexedSheet<'a>,
    /// The origin of coordinates, and the shift of B's boxes to it.
    origin: DVec3,
    shift: DVec3,
    max_gap: f64,
    /// Tells which pairs of cells are wanted.
    is_wanted_pair: &'a dyn Fn(&CellPair) -> bool,
    /// The most recent blocks of A and of B.
    blocks: [BlockQuadrilaterals; 2],
    /// Number of pairs since the last progress report.
    pairs_since_report: usize,
    cell_pairs: &'a mut Vec<CellPair>,
    job: &'a Job<'a>,
}

impl PyramidPairDescent<'_> {
    /// Counts examined pairs, and reports progress.
    fn count_examined_pairs(&mut self, pairs: usize) -> Result<()> {
        self.pairs_since_report += pairs;
        if self.pairs_since_report >= PAIRS_PER_REPORT {
            self.pairs_since_report = 0;
            self.job.step(0.0, "pairs of cells")?;
        }
        Ok(())
    }

    /// Adds the pairs of cells of two blocks of any level.
    fn visit_block_pair(&mut self, one: &PyramidBlock, other: &PyramidBlock) -> Result<()> {
        self.count_examined_pairs(1)?;
        if one.level == 0 && other.level == 0 {
            return self.add_cell_pairs(one, other);
        }
        let PyramidPairDescent { a, b, shift, max_gap: by, .. } = *self;
        let halves_a = one.level > 0 && (other.level == 0 || one.longest_side() >= other.longest_side());
        for k in 0..4 {
            if halves_a {
                if let Some(child) = one.child_near_block(k, a.index, DVec3::ZERO, other, by) {
                    self.visit_block_pair(&child, other)?;
                }
            } else if let Some(child) = other.child_near_block(k, b.index, shift, one, by) {
                self.visit_block_pair(one, &child)?;
            }
        }
        Ok(())
    }

    /// Adds the pairs of cells of two blocks of level 0.
    fn add_cell_pairs(&mut self, one: &PyramidBlock, other: &PyramidBlock) -> Result<()> {
        let PyramidPairDescent { a, b, is_wanted_pair: wanted, ref mut blocks, cell_pairs: ref mut found, .. } = *self;
        let [left, right] = blocks;
        left.read_block(a, one, self.origin);
        right.read_block(b, other, self.origin);
        let by = self.max_gap + left.deviation + right.deviation;
        left.select_cells_near(a.sheet, &other.bounds, by);
        right.select_cells_near(b.sheet, &one.bounds, by);
        for (p, q) in left.quads.iter().flat_map(|p| right.quads.iter().map(move |q| (p, q))) {
            let pair = CellPair { sheets: [a.sheet_number, b.sheet_number], cells: [p.cell, q.cell] };
            if wanted(&pair) && p.may_meet(q, by) {
                alloc::push(found, pair)?;
            }
        }
        Error::check_count("pairs of cells", found.len() as u64, MAX_PAIRS)?;
        let looked_at = left.quads.len() * right.quads.len();
        self.count_examined_pairs(looked_at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Randomly rotated boxes, a gap apart along an axis through a face, or through an edge of
    /// each.
    #[test]
    fn boxes_a_gap_apart_meet_exactly_within_the_gap() {
        let mut random = fastrand::Rng::with_seed(3);
        for k in 0..10_000 {
            let mut turned = || {
                let [x, y] = [0, 1].map(|_| DVec3::from_array([0, 1, 2].map(|_| random.f64() - 0.5)));
                let x = x.normalize();
                let y = x.cross(y).normalize();
                [x, y, x.cross(y)].map(|axis| (0.1 + random.f64()) * axis)
            };
            let [one, mut other] = [0, 1].map(|_| Parallelepiped::new(DVec3::ZERO, turned()));
            let axes = [
                one.half_edges[k % 3],
                other.half_edges[k % 3],
                one.half_edges[k % 3].cross(other.half_edges[k / 3 % 3]),
            ];
            let along = axes[k / 9 % 3].normalize();
            let corner = |solid: &Parallelepiped| -> DVec3 {
                solid.half_edges.map(|half| half * half.dot(along).signum()).iter().sum()
            };
            let gap = 0.01 + random.f64();
            // The gap runs from the farthest corner of one box to the nearest of the other, so it
            // is the distance between them.
            other.centre = corner(&one) + gap * along + corner(&other);
            assert!(one.may_meet(&other, gap * (1.0 + 1e-9)), "{k}");
            assert!(!one.may_meet(&other, 0.5 * gap), "{k}");
        }
    }
}
