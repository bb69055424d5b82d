//! Topologies whose nodes are arranged anew.

use super::runs;
use crate::alloc;
use crate::error::Result;
use crate::net::topology::{Links, Matrix, Run, Seam, Sides};
use crate::net::{Shape, Topology};
use std::ops::Range;

/// Contracted links that are being collected; no matrix as long as there are none.
pub(crate) struct Collected {
    shape: Shape,
    matrix: Option<Matrix>,
}

impl Collected {
    pub(crate) fn new(shape: Shape) -> Self {
        Collected { shape, matrix: None }
    }

    pub(crate) fn add(&mut self, link: u32) -> Result<()> {
        self.matrix()?.set(link, true);
        Ok(())
    }

    /// All links from row i to the next.
    pub(crate) fn add_row_down(&mut self, i: usize) -> Result<()> {
        let columns = self.shape.columns();
        self.matrix()?.contract_down(i * columns..(i + 1) * columns);
        Ok(())
    }

    fn matrix(&mut self) -> Result<&mut Matrix> {
        Ok(match &mut self.matrix {
            Some(matrix) => matrix,
            empty => empty.insert(Matrix::empty(self.shape)?),
        })
    }

    pub(crate) fn links(self) -> Links {
        self.matrix.map_or(Links::Sides(Sides::SHEET), Links::Matrix)
    }
}

impl Topology {
    /// The topology of the same size or the transposed one whose sides are these, if sides say all, else whose links and
    /// runs are the images of these. Faces are taken the other way round, as every such exchange turns them over.
    fn exchanged(
        &self,
        shape: Shape,
        sides: impl Fn(Sides) -> Sides,
        link: impl Fn(u32) -> u32,
        run: impl Fn(Run) -> Run,
    ) -> Result<Self> {
        let links = match self.links() {
            Links::Sides(old) => Links::Sides(sides(*old)),
            Links::Matrix(old) => {
                let mut matrix = Matrix::empty(shape)?;
                old.links().for_each(|old| matrix.set(link(old), true));
                Links::Matrix(matrix)
            }
        };
        let seam = |seam: &Seam| Seam { a: run(seam.a), b: run(seam.b), count: seam.count };
        let seams = alloc::collect(self.seams().iter().map(seam))?;
        Topology::assembled(shape, links, seams, !self.is_reversed())
    }

    /// Rows and columns exchanged.
    pub(crate) fn transposed(&self) -> Result<Self> {
        let (old, shape) = (self.shape(), self.shape().transposed());
        let link = |link: u32| {
            let (i, j) = old.place(link / 2);
            2 * shape.node(j, i) + (1 - link % 2)
        };
        self.exchanged(shape, Sides::transposed, link, Run::transposed)
    }

    /// The last row first.
    pub(crate) fn flipped_rows(&self) -> Result<Self> {
        let shape = self.shape();
        let last = shape.rows() - 1;
        let link = |link: u32| {
            let (i, j) = shape.place(link / 2);
            match (link % 2, i == last) {
                (0, _) => 2 * shape.node(last - i, j),
                // The link that leads back still does; others begin a row earlier than where theirs ended.
                (_, true) => link,
                (_, false) => 2 * shape.node(last - i - 1, j) + 1,
            }
        };
        let sides = |sides: Sides| Sides { pole_top: sides.pole_bottom, pole_bottom: sides.pole_top, ..sides };
        self.exchanged(shape, sides, link, |run| Run { row: last as u32 - run.row, row_step: -run.row_step, ..run })
    }

    /// The last column first.
    pub(crate) fn flipped_columns(&self) -> Result<Self> {
        self.transposed()?.flipped_rows()?.transposed()
    }

    /// What is glued within each of some ranges of rows, which are in order and do not overlap. A link that leads back stays
    /// one for all rows together, and a seam that says that the last row of a range is its first becomes one.
    ///
    /// O(contracted links + pairs of seams), and O(1) for sides.
    pub(crate) fn rows_cut(&self, ranges: &[Range<usize>]) -> Result<Vec<Self>> {
        let seams = self.seams_cut(ranges)?;
        let mut parts = alloc::with_capacity(ranges.len())?;
        for (rows, seams) in ranges.iter().zip(seams) {
            parts.push(self.row_part(rows.clone(), &seams)?);
        }
        Ok(parts)
    }

    fn row_part(&self, rows: Range<usize>, seams: &[Seam]) -> Result<Self> {
        let (old, whole) = (self.shape(), rows.len() == self.shape().rows());
        let shape = Shape::new(rows.len(), old.columns())?;
        let first = 2 * old.node(rows.start, 0);
        let mut links = Collected::new(shape);
        let mut said = Sides::SHEET;
        match self.links() {
            Links::Sides(sides) => {
                said = Sides {
                    columns_closed: sides.columns_closed && whole,
                    pole_top: sides.pole_top && rows.start == 0,
                    pole_bottom: sides.pole_bottom && rows.end == old.rows(),
                    ..*sides
                };
            }
            Links::Matrix(matrix) => {
                let last_row = 2 * shape.node(rows.len() - 1, 0);
                for link in matrix.links_in(first..first + 2 * shape.node_count() as u32) {
                    let link = link - first;
                    // Out of the last row and down leads out of the part, unless it leads back.
                    if link < last_row || link % 2 == 0 || whole {
                        links.add(link)?;
                    }
                }
            }
        }
        let mut kept = Vec::new();
        for &seam in seams {
            match closing(shape, seam) {
                Some(columns) => {
                    if said != Sides::SHEET {
                        let sides = std::mem::replace(&mut said, Sides::SHEET);
                        sides.links(shape).try_for_each(|link| links.add(link))?;
                    }
                    for j in columns {
                        links.add(2 * shape.node(rows.len() - 1, j as usize) + 1)?;
                    }
                }
                None => alloc::push(&mut kept, seam)?,
            }
        }
        let links = if said == Sides::SHEET { links.links() } else { Links::Sides(said) };
        Topology::assembled(shape, links, kept, self.is_reversed())
    }

    /// The seams within each range, in its own rows.
    fn seams_cut(&self, ranges: &[Range<usize>]) -> Result<Vec<Vec<Seam>>> {
        let mut cut = alloc::filled(Vec::new(), ranges.len())?;
        for &seam in self.seams() {
            let ends = [seam.a.place(0).0, seam.a.place(seam.count - 1).0];
            let (low, high) = (ends[0].min(ends[1]) as usize, ends[0].max(ends[1]) as usize);
            let from = ranges.partition_point(|rows| rows.end <= low);
            let to = ranges.partition_point(|rows| rows.start <= high);
            for (rows, seams) in ranges[from..to.max(from)].iter().zip(&mut cut[from..]) {
                let (start, end) = (rows.start as i64, rows.end as i64);
                let place = |(i, j)| (start..end).contains(&i).then_some((i - start, j));
                runs::carried(seam, place, seams)?;
            }
        }
        Ok(cut)
    }
}

/// The columns that a seam closes, if that is all it does: each of its pairs is the last and the first node of a column.
fn closing(shape: Shape, seam: Seam) -> Option<impl Iterator<Item = i64>> {
    let Seam { a, b, count } = seam;
    let rows = [a.row.min(b.row), a.row.max(b.row)];
    let whole = rows == [0, shape.rows() as u32 - 1] && a.row_step == 0 && b.row_step == 0;
    let same = a.column == b.column && a.column_step == b.column_step;
    (whole && same).then(|| (0..count).map(move |k| a.place(k).1))
}

/// The rows that a seam closes, if that is all it does: [`closing`] with rows and columns exchanged.
pub(crate) fn closing_rows(shape: Shape, seam: Seam) -> Option<impl Iterator<Item = usize>> {
    let transposed = Seam { a: seam.a.transposed(), b: seam.b.transposed(), ..seam };
    closing(shape.transposed(), transposed).map(|rows| rows.map(|i| i as usize))
}
