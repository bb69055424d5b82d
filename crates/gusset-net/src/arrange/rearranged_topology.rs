//! Topologies of rearranged nodes: transposed, flipped, cut into ranges of rows.
//!
//! Sides stay sides. O(contracted links + pairs of seams), O(1) for sides alone.

use super::seams;
use crate::topology::{ContractedLinks, LinkMatrix, Seam, SeamRun, Sides};
use crate::{Direction, Shape, Topology};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

impl Topology {
    /// Returns the image under an exchange of rows and columns or a reversal of either, given the
    /// images of sides, links and runs. The face orientation is reversed, as every such map
    /// reverses it.
    fn map_elements(
        &self,
        shape: Shape,
        sides: impl Fn(Sides) -> Sides,
        link: impl Fn(u32) -> u32,
        run: impl Fn(SeamRun) -> SeamRun,
    ) -> Result<Self> {
        let links = match self.contracted_link_set() {
            ContractedLinks::Sides(old) => ContractedLinks::Sides(sides(*old)),
            ContractedLinks::Matrix(old) => {
                ContractedLinks::Matrix(LinkMatrix::from_links(shape, old.links().map(link))?)
            }
        };
        let seam = |seam: &Seam| Seam { a: run(seam.a), b: run(seam.b), count: seam.count };
        let seams = alloc::collect(self.seams().iter().map(seam))?;
        Ok(Topology::assemble_unchecked(shape, links, seams, !self.is_reversed()))
    }

    /// Rows and columns exchanged.
    pub(crate) fn transposed(&self) -> Result<Self> {
        let (old, shape) = (self.shape(), self.shape().transposed());
        let link = |link: u32| {
            let (i, j) = old.row_and_column(link / 2);
            2 * shape.node(j, i) + (1 - link % 2)
        };
        self.map_elements(shape, Sides::transposed, link, SeamRun::transposed)
    }

    /// Returns the last row first.
    pub(crate) fn flipped_rows(&self) -> Result<Self> {
        let shape = self.shape();
        let last = shape.rows() - 1;
        let link = |link: u32| {
            let (i, j) = shape.row_and_column(link / 2);
            match (link % 2, i == last) {
                (0, _) => shape.horizontal_link(last - i, j),
                // A closing link stays one; others begin where theirs ended, a row earlier.
                (_, true) => link,
                (_, false) => shape.vertical_link(last - i - 1, j),
            }
        };
        let sides = |sides: Sides| Sides { pole_top: sides.pole_bottom, pole_bottom: sides.pole_top, ..sides };
        self.map_elements(shape, sides, link, |run| SeamRun {
            row: last as u32 - run.row,
            row_step: -run.row_step,
            ..run
        })
    }

    /// Applies a map of rows to the rows (`Down`) or, through the transposed topology, to the
    /// columns.
    pub(crate) fn map_rows_or_columns(
        &self,
        axis: Direction,
        map: impl FnOnce(&Topology) -> Result<Topology>,
    ) -> Result<Self> {
        match axis {
            Direction::Down => map(self),
            Direction::Right => map(&self.transposed()?)?.transposed(),
        }
    }

    /// Cuts the topology into disjoint ranges of rows in order. Closing links survive only in a
    /// range of all rows. A seam that glues the last row of a range to its first becomes closing
    /// links.
    pub(crate) fn cut_into_row_ranges(&self, ranges: &[Range<usize>]) -> Result<Vec<Self>> {
        let seams = self.cut_seams_by_row_ranges(ranges)?;
        alloc::try_collect(ranges.iter().zip(seams).map(|(rows, seams)| self.restrict_to_rows(rows.clone(), &seams)))
    }

    /// Returns the topology within a range of rows, given the seams within it.
    pub(crate) fn restrict_to_rows(&self, rows: Range<usize>, seams: &[Seam]) -> Result<Self> {
        let (old, whole) = (self.shape(), rows.len() == self.shape().rows());
        let shape = Shape::new(rows.len(), old.columns())?;
        let first = old.horizontal_link(rows.start, 0);
        let mut links = match self.contracted_link_set() {
            ContractedLinks::Sides(sides) => ContractedLinks::Sides(Sides {
                columns_closed: sides.columns_closed && whole,
                pole_top: sides.pole_top && rows.start == 0,
                pole_bottom: sides.pole_bottom && rows.end == old.rows(),
                ..*sides
            }),
            ContractedLinks::Matrix(matrix) => {
                let last_row = shape.horizontal_link(rows.len() - 1, 0);
                let within =
                    matrix.contracted_links_in(first..first + shape.link_count() as u32).map(|link| link - first);
                // A link down from the last row leaves the part, unless it closes all rows.
                let kept = within.filter(|&link| link < last_row || link % 2 == 0 || whole);
                ContractedLinks::Matrix(LinkMatrix::from_links(shape, kept)?)
            }
        };
        let mut kept = Vec::new();
        for &seam in seams {
            match columns_closed_by_seam(shape, seam) {
                Some(columns) => {
                    let mut matrix = links.into_matrix(shape)?;
                    columns.for_each(|j| matrix.set_contracted(shape.vertical_link(rows.len() - 1, j as usize), true));
                    links = ContractedLinks::Matrix(matrix);
                }
                None => alloc::push(&mut kept, seam)?,
            }
        }
        Ok(Topology::assemble_unchecked(shape, links, kept, self.is_reversed()))
    }

    /// Returns the seams within each range, in its own row numbers.
    fn cut_seams_by_row_ranges(&self, ranges: &[Range<usize>]) -> Result<Vec<Vec<Seam>>> {
        let mut cut = alloc::filled(Vec::new(), ranges.len())?;
        for &seam in self.seams() {
            let ends = [seam.a.row_and_column_of_node(0).0, seam.a.row_and_column_of_node(seam.count - 1).0];
            let (low, high) = (ends[0].min(ends[1]) as usize, ends[0].max(ends[1]) as usize);
            let from = ranges.partition_point(|rows| rows.end <= low);
            let to = ranges.partition_point(|rows| rows.start <= high);
            for (rows, within) in ranges[from..to.max(from)].iter().zip(&mut cut[from..]) {
                let (start, end) = (rows.start as i64, rows.end as i64);
                let place = |(i, j)| (start..end).contains(&i).then_some((i - start, j));
                seams::map_seam(seam, place, within)?;
            }
        }
        Ok(cut)
    }
}

/// Returns the columns that a seam closes, if each of its pairs is the last and the first node of a
/// column.
fn columns_closed_by_seam(shape: Shape, seam: Seam) -> Option<impl Iterator<Item = i64>> {
    let Seam { a, b, count } = seam;
    let rows = [a.row.min(b.row), a.row.max(b.row)];
    let whole = rows == [0, shape.rows() as u32 - 1] && a.row_step == 0 && b.row_step == 0;
    let same = a.column == b.column && a.column_step == b.column_step;
    (whole && same).then(|| (0..count).map(move |k| a.row_and_column_of_node(k).1))
}

/// Returns the rows that a seam closes, if each of its pairs is the last and the first node of a
/// row.
pub(crate) fn rows_closed_by_seam(shape: Shape, seam: Seam) -> Option<impl Iterator<Item = usize>> {
    let transposed = Seam { a: seam.a.transposed(), b: seam.b.transposed(), ..seam };
    columns_closed_by_seam(shape.transposed(), transposed).map(|rows| rows.map(|i| i as usize))
}
