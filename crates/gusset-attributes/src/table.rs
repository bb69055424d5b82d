//! Rows of sources with weights, in compressed form.

use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::NONE;
use std::ops::Range;

/// The name of the stage in progress reports.
pub(super) const STAGE: &str = "finding origins";
/// Number of new faces between two progress reports. Each has many sources.
pub(super) const FACES_PER_REPORT: usize = 1 << 12;

/// For each element of a result, its sources and their weights.
///
/// Row k has the entries `offsets()[k]` to `offsets()[k + 1]`. An element without sources has an
/// empty row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SourceTable {
    offsets: Vec<u32>,
    sources: Vec<u32>,
    weights: Vec<f64>,
}

impl SourceTable {
    /// Creates a table without rows, with memory for the given numbers of rows and sources.
    pub(crate) fn with_capacity(rows: usize, sources: usize) -> Result<SourceTable> {
        let mut offsets = alloc::with_capacity(rows + 1)?;
        offsets.push(0);
        Ok(SourceTable { offsets, sources: alloc::with_capacity(sources)?, weights: alloc::with_capacity(sources)? })
    }

    /// Creates rows with one source each, or without sources for [`NONE`].
    pub(crate) fn from_single_sources(
        sources: impl ExactSizeIterator<Item = u32>,
        job: &Job<'_>,
    ) -> Result<SourceTable> {
        let mut table = SourceTable::with_capacity(sources.len(), sources.len())?;
        let (mut sources, count) = (sources, table.offsets.capacity() - 1);
        job.work_in_ranges(STAGE, count, |range| {
            for source in sources.by_ref().take(range.len()) {
                if source != NONE {
                    table.sources.push(source);
                    table.weights.push(1.0);
                }
                table.offsets.push(table.sources.len() as u32);
            }
            Ok(())
        })?;
        Ok(table)
    }

    /// Creates `rows` rows. Row r has all sources that `map` maps to r, in ascending order and with
    /// equal weights. Sources mapped to [`NONE`] are dropped.
    pub(crate) fn from_map(
        rows: usize,
        map: impl ExactSizeIterator<Item = u32> + Clone,
        job: &Job<'_>,
    ) -> Result<SourceTable> {
        job.step(0.0, STAGE)?;
        let pairs = map.zip(0..).filter(|&(row, _)| row != NONE).map(|(row, source)| (row as usize, source));
        let (offsets, sources) = Buckets::new(rows, 0u32, pairs)?.into_parts();
        let mut weights = alloc::with_capacity(sources.len())?;
        job.work_in_ranges(STAGE, rows, |range| {
            for row in range {
                let count = (offsets[row + 1] - offsets[row]) as usize;
                weights.extend(std::iter::repeat_n(1.0 / count as f64, count));
            }
            Ok(())
        })?;
        Ok(SourceTable { offsets, sources, weights })
    }

    /// Adds a row of few sources. Merges repeated sources, and drops sources of weight 0.
    pub(crate) fn push(&mut self, row: impl IntoIterator<Item = (u32, f64)>) -> Result<()> {
        let start = self.sources.len();
        for (source, weight) in row.into_iter().filter(|&(_, weight)| weight != 0.0) {
            match self.sources[start..].iter().position(|&other| other == source) {
                Some(at) => self.weights[start + at] += weight,
                None => {
                    alloc::push(&mut self.sources, source)?;
                    alloc::push(&mut self.weights, weight)?;
                }
            }
        }
        Error::check_count("sources", self.sources.len() as u64, u32::MAX.into())?;
        alloc::push(&mut self.offsets, self.sources.len() as u32)
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// True if the table lacks rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The sources of an element, and their weights.
    #[inline]
    pub fn row(&self, k: usize) -> (&[u32], &[f64]) {
        let range = self.entry_range(k);
        (&self.sources[range.clone()], &self.weights[range])
    }

    /// The range of the sources of an element.
    #[inline]
    pub(crate) fn entry_range(&self, k: usize) -> Range<usize> {
        self.offsets[k] as usize..self.offsets[k + 1] as usize
    }

    /// The sources of an element, each with its weight.
    pub(crate) fn entries(&self, k: usize) -> impl Iterator<Item = (u32, f64)> + Clone {
        let (sources, weights) = self.row(k);
        sources.iter().copied().zip(weights.iter().copied())
    }

    /// The source with the largest weight, the first of equal ones; [`NONE`] for an empty row.
    #[inline]
    pub(crate) fn main_source(&self, k: usize) -> u32 {
        let (sources, weights) = self.row(k);
        let mut main = (NONE, f64::NEG_INFINITY);
        for (&source, &weight) in sources.iter().zip(weights) {
            if weight > main.1 {
                main = (source, weight);
            }
        }
        main.0
    }

    /// The start of each row among sources and weights, then the end of the last row.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Returns the indices of all sources, row by row.
    pub fn source_indices(&self) -> &[u32] {
        &self.sources
    }

    /// Returns the weight of each source. The weights of a row have the sum 1.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }
}
