//! Reformatting: replicates rows and columns, which changes the size of a net but not its surface
//! (Deryagin, "Reformatting", Fig. 7; the paper leaves open which row is repeated).
//!
//! Copies follow their original, and the links between them are contracted. The links along a copy
//! equal the original's, and a closing link of the last row starts at its last copy. Invariant:
//! classes, faces and volume stay the same. O(nodes).

use super::arrange::{Rearrangement, map_seam, merge_seams};
use super::topology::{ContractedLinks, LinkMatrix, Seam, SeamRun};
use super::{Bridge, Direction, Net, Real, Shape, Topology, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use std::ops::Add;

/// The rows, or columns, that are replicated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Replication {
    /// All, as evenly as possible.
    #[default]
    Uniform,
    /// The first one.
    First,
    /// The last one.
    Last,
    /// The one with this index.
    At(u32),
    /// Poles among the first and the last line, in equal shares; without a pole like `Uniform`.
    AtPoles,
}

impl Net<'_> {
    /// Enlarges the net to `rows` and `columns`, at least the current numbers. The surface stays
    /// the same. O(nodes).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for fewer rows or columns than now, or for the index of a line
    /// that does not exist, [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn enlarged_to(
        &self,
        rows: usize,
        columns: usize,
        replication: [Replication; 2],
        job: &Job<'_>,
    ) -> Result<Net<'static>> {
        // The error then names both numbers.
        Shape::new(rows, columns)?;
        let row_starts = starts_of_replicated_lines(self.topology(), Direction::Down, rows, replication[0], "rows")?;
        let column_starts =
            starts_of_replicated_lines(self.topology(), Direction::Right, columns, replication[1], "columns")?;
        let mut topology = self.topology().replicate_rows(&row_starts)?;
        if columns > self.shape().columns() {
            topology =
                topology.map_rows_or_columns(Direction::Right, |topology| topology.replicate_rows(&column_starts))?;
        }
        let map = Rearrangement::Selection {
            rows: &old_index_of_each_row(&row_starts)?,
            columns: &old_index_of_each_row(&column_starts)?,
        };
        let mut net = self.with_rearranged_nodes(&map, topology, job)?;
        for bridge in self.bridges() {
            let bridge = bridge.with_moved_lines(|i| row_starts[i as usize], |j| column_starts[j as usize]);
            alloc::push(net.bridges_mut(), bridge)?;
        }
        Ok(net)
    }

    /// Removes rows and columns that duplicate the previous one. In a duplicate, all links to the
    /// previous line are contracted, and links and coordinates along both lines are equal bit for
    /// bit. At least two rows and columns are left, and lines where a bridge ends are kept. It is
    /// the inverse of [`Net::enlarged_to`] for nets without duplicates; seams that continue each
    /// other are merged. O(nodes).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn compacted(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let rows = self.duplicate_lines(Direction::Down)?;
        let net = self.without_lines(Direction::Down, &rows, &job.sub_job(0.0, 0.5))?;
        let columns = net.duplicate_lines(Direction::Right)?;
        net.without_lines(Direction::Right, &columns, &job.sub_job(0.5, 1.0))
    }

    /// Returns the rows (`Down`) or columns that duplicate the previous one.
    fn duplicate_lines(&self, axis: Direction) -> Result<Vec<u32>> {
        let count = axis.line_count_and_length(self.shape()).0;
        let mut needed = alloc::filled(false, count)?;
        for bridge in self.bridges() {
            let line = if bridge.direction == axis { bridge.at } else { bridge.start };
            needed[line as usize] = true;
        }
        let mut found = Vec::new();
        for (i, &needed) in needed.iter().enumerate().skip(1) {
            if count - found.len() > 2
                && !needed
                && self.topology().is_duplicate_line(axis, i)
                && each!(self.coordinates(), planes => planes.is_duplicate_line(axis, i))
            {
                alloc::push(&mut found, i as u32)?;
            }
        }
        Ok(found)
    }

    /// Returns the net without some of its rows (`Down`) or columns, given by ascending indices; at
    /// least two are left.
    pub(crate) fn without_lines(&self, axis: Direction, removed: &[u32], job: &Job<'_>) -> Result<Net<'static>> {
        if removed.is_empty() {
            return self.copied();
        }
        let kept = indices_not_removed(axis.line_count_and_length(self.shape()).0, removed)?;
        let topology = self.topology().map_rows_or_columns(axis, |topology| topology.keep_rows(&kept))?;
        let mut net = self.with_selected_lines(axis, &kept, topology, job)?;
        let place = |i: u32| kept.partition_point(|&k| k < i) as u32;
        for bridge in self.bridges() {
            let bridge = match axis {
                Direction::Down => bridge.with_moved_lines(place, |j| j),
                Direction::Right => bridge.with_moved_lines(|i| i, place),
            };
            if bridge.at > bridge.rows && bridge.end > bridge.start + 1 {
                alloc::push(net.bridges_mut(), bridge)?;
            }
        }
        Ok(net)
    }

    /// Returns the nodes of a list of rows (`Down`) or columns under a new topology; without
    /// bridges.
    pub(crate) fn with_selected_lines(
        &self,
        axis: Direction,
        lines: &[u32],
        topology: Topology,
        job: &Job<'_>,
    ) -> Result<Net<'static>> {
        let all = alloc::collect((0..axis.line_count_and_length(topology.shape()).1).map(|i| i as u32))?;
        let (rows, columns) = axis.swap_unless_down(lines, &all);
        self.with_rearranged_nodes(&Rearrangement::Selection { rows, columns }, topology, job)
    }
}

impl Bridge {
    /// Returns the bridge in a net whose rows and columns move. An end moves like the line that it
    /// excludes.
    fn with_moved_lines(&self, row: impl Fn(u32) -> u32, column: impl Fn(u32) -> u32) -> Bridge {
        let inner = self.at - self.rows;
        let (at, inner, start, end) = match self.direction {
            Direction::Right => (column(self.at), column(inner), row(self.start), row(self.end)),
            Direction::Down => (row(self.at), row(inner), column(self.start), column(self.end)),
        };
        Bridge { at, rows: at - inner, start, end, ..self.without_adaptations() }
    }
}

/// Returns the start of each row (`Down`) or column after enlarging to `count`; one entry more than
/// there are now. `option` names the count in an error.
pub(crate) fn starts_of_replicated_lines(
    topology: &Topology,
    axis: Direction,
    count: usize,
    replication: Replication,
    option: &'static str,
) -> Result<Vec<u32>> {
    let old = axis.line_count_and_length(topology.shape()).0;
    Error::require(count >= old, option, count as f64, Allowed::AtLeast(old as f64))?;
    let copies = count - old;
    let mut times: Vec<u32> = alloc::filled(1, old)?;
    let poles = [0, old - 1].map(|i| topology.is_line_contracted(axis, i));
    match (replication, poles) {
        (Replication::First, _) => times[0] += copies as u32,
        (Replication::Last, _) => times[old - 1] += copies as u32,
        (Replication::At(i), _) => {
            let index = if axis == Direction::Down { "row_index" } else { "column_index" };
            Error::require((i as usize) < old, index, i.into(), Allowed::IndexBelow(old as u64))?;
            times[i as usize] += copies as u32;
        }
        (Replication::AtPoles, [true, _] | [_, true]) => {
            let last = match poles {
                [true, true] => copies / 2,
                [true, false] => 0,
                _ => copies,
            };
            times[0] += (copies - last) as u32;
            times[old - 1] += last as u32;
        }
        (Replication::Uniform | Replication::AtPoles, _) => {
            let share = |i: usize| (i as u64 * copies as u64 / old as u64) as u32;
            times.iter_mut().enumerate().for_each(|(i, times)| *times += share(i + 1) - share(i));
        }
    }
    prefix_sums(times.into_iter())
}

/// Returns the prefix sums of a list, starting with 0.
pub(crate) fn prefix_sums<T: Copy + Default + Add<Output = T>>(
    items: impl ExactSizeIterator<Item = T>,
) -> Result<Vec<T>> {
    let mut sums = alloc::filled(T::default(), items.len() + 1)?;
    for (k, item) in items.enumerate() {
        sums[k + 1] = sums[k] + item;
    }
    Ok(sums)
}

/// Returns the old index of each new row.
fn old_index_of_each_row(starts: &[u32]) -> Result<Vec<u32>> {
    alloc::gather((0..).zip(starts.windows(2)).flat_map(|(i, ends)| (ends[0]..ends[1]).map(move |_| i)))
}

/// Returns the new rows that are copies of the previous one.
pub(crate) fn copied_rows_from_starts(starts: &[u32]) -> Result<Vec<u32>> {
    alloc::gather(starts.windows(2).flat_map(|ends| ends[0] + 1..ends[1]))
}

/// Returns the starts of rows among `count`, given which are copies.
pub(crate) fn row_starts_from_copies(count: usize, copies: &[u32]) -> Result<Vec<u32>> {
    let mut starts = indices_not_removed(count, copies)?;
    alloc::push(&mut starts, count as u32)?;
    Ok(starts)
}

/// Returns the numbers of 0..count that an ascending list does not contain.
fn indices_not_removed(count: usize, removed: &[u32]) -> Result<Vec<u32>> {
    let mut removed = removed.iter().peekable();
    alloc::gather((0..count as u32).filter(|i| removed.next_if_eq(&i).is_none()))
}

impl Topology {
    /// Returns true if all links along row i (`Down`) or column i are contracted by name.
    pub(crate) fn is_line_contracted(&self, axis: Direction, i: usize) -> bool {
        let shape = self.shape();
        (0..axis.line_count_and_length(shape).1 - 1).all(|k| self.is_contracted(axis.link_within_line(shape, i, k)))
    }

    /// Returns true if row or column i, not the first, is glued to the previous one link by link,
    /// and both are glued within themselves in the same way.
    fn is_duplicate_line(&self, axis: Direction, i: usize) -> bool {
        let shape = self.shape();
        let along = |i: usize, k: usize| self.is_contracted(axis.link_within_line(shape, i, k));
        (0..axis.line_count_and_length(shape).1)
            .all(|k| self.is_contracted(axis.link_to_next_line(shape, i - 1, k)) && along(i - 1, k) == along(i, k))
    }

    /// Row i is rows `starts[i]..starts[i + 1]`. O(contracted links + pairs of seams).
    pub(crate) fn replicate_rows(&self, starts: &[u32]) -> Result<Self> {
        let (old, rows) = (self.shape(), starts[self.shape().rows()] as usize);
        if rows == old.rows() {
            return Ok(self.clone());
        }
        let shape = Shape::new(rows, old.columns())?;
        let mut links = LinkMatrix::empty(shape)?;
        self.contracted_links().for_each(|link| {
            let (i, j) = old.row_and_column(link / 2);
            // A vertical link starts at the last copy.
            let copies = if link % 2 == 0 { starts[i]..starts[i + 1] } else { starts[i + 1] - 1..starts[i + 1] };
            copies.for_each(|i| links.set_contracted(2 * shape.node(i as usize, j) + link % 2, true));
        });
        copied_rows_from_starts(starts)?
            .into_iter()
            .for_each(|i| links.contract_links_below_row(shape, i as usize - 1));
        let mut seams = Vec::new();
        for &seam in self.seams() {
            if let Some(seam) = replicate_seam_along_rows(seam, starts) {
                alloc::push(&mut seams, seam)?;
            } else {
                map_seam(seam, |(i, j)| Some((i64::from(starts[i as usize]), j)), &mut seams)?;
            }
        }
        Ok(Topology::assemble_unchecked(shape, ContractedLinks::Matrix(links), seams, self.is_reversed()))
    }

    /// The topology of the rows of a list, which is in order and has at least two; the others are
    /// taken to duplicate the one before. Rows that become neighbours are glued where all links
    /// between them were contracted.
    pub(crate) fn keep_rows(&self, kept: &[u32]) -> Result<Self> {
        let old = self.shape();
        let (h, w) = (old.rows(), old.columns());
        let shape = Shape::new(kept.len(), w)?;
        let mut links = LinkMatrix::empty(shape)?;
        for (new, &i) in kept.iter().enumerate() {
            let i = i as usize;
            // The rows up to the next that is kept.
            let end = kept.get(new + 1).map_or(h + kept[0] as usize, |&next| next as usize);
            for j in 0..w {
                if self.is_contracted(old.horizontal_link(i, j)) {
                    links.set_contracted(shape.horizontal_link(new, j), true);
                }
                if (i..end).all(|i| self.is_contracted(old.vertical_link(i % h, j))) {
                    links.set_contracted(shape.vertical_link(new, j), true);
                }
            }
        }
        let mut seams = Vec::new();
        let place = |i: i64| kept.partition_point(|&k| i64::from(k) <= i).saturating_sub(1) as i64;
        for &seam in self.seams() {
            map_seam(seam, |(i, j)| Some((place(i), j)), &mut seams)?;
        }
        Ok(Topology::assemble_unchecked(
            shape,
            ContractedLinks::Matrix(links),
            merge_seams(&seams)?,
            self.is_reversed(),
        ))
    }
}

/// Returns a seam from column to column within the same rows, as closed rows of a net within a
/// larger one make, extended through all copies.
fn replicate_seam_along_rows(seam: Seam, starts: &[u32]) -> Option<Seam> {
    let Seam { a, b, count } = seam;
    let same = a.row == b.row && a.row_step == b.row_step && a.column_step == 0 && b.column_step == 0;
    if !same || a.row_step.abs() != 1 {
        return None;
    }
    let last = a.row_and_column_of_node(count - 1).0 as u32;
    let (first, last) = (a.row.min(last) as usize, a.row.max(last) as usize);
    let run = |run: SeamRun| SeamRun::along_column(starts[first], run.column, 1);
    Some(Seam { a: run(a), b: run(b), count: starts[last + 1] - starts[first] })
}

impl<T: Real> XyzMatrices<'_, T> {
    /// Returns true if row i (`Down`) or column i has the bits of the one before.
    fn is_duplicate_line(&self, axis: Direction, i: usize) -> bool {
        let stride = self.stride();
        self.matrices().into_iter().all(|matrix| match axis {
            Direction::Down => {
                let row = |i: usize| &matrix[i * stride..][..self.shape().columns()];
                bytemuck::cast_slice::<T, u8>(row(i)) == bytemuck::cast_slice::<T, u8>(row(i - 1))
            }
            Direction::Right => {
                matrix.chunks(stride).all(|row| bytemuck::bytes_of(&row[i]) == bytemuck::bytes_of(&row[i - 1]))
            }
        })
    }
}
