//! Intersections with many lines.

use super::line::{Hit, HitSelection, Line};
use super::line_search::LineWorkspace;
use crate::Surface;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Number of lines that a thread processes in one task.
const LINES_PER_TASK: usize = 512;

/// The hits of many lines.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lines {
    /// 0, then the end of each line's hits in `hits`.
    pub ends: Vec<u64>,
    /// The hits, line by line, each by ascending t.
    pub hits: Vec<Hit>,
}

impl Lines {
    /// The hits of line k.
    pub fn hits_of(&self, k: usize) -> &[Hit] {
        &self.hits[self.ends[k] as usize..self.ends[k + 1] as usize]
    }
}

impl Surface<'_> {
    /// Intersects many lines with the surface, on the job's threads. The hits of each line equal
    /// the result of [`Surface::line`].
    ///
    /// # Errors
    /// [`Error::BadLine`] with the first line that is not finite or lacks a direction,
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn lines(&self, lines: &[Line], selection: HitSelection, job: &Job<'_>) -> Result<Lines> {
        let mut line_hits = Lines { ends: alloc::with_capacity(lines.len() + 1)?, hits: Vec::new() };
        line_hits.ends.push(0);
        let each = |lines: &[Line], workspace: &mut LineWorkspace| {
            let (mut counts, mut hits) = (alloc::with_capacity(lines.len())?, Vec::new());
            for line in lines {
                self.find_hits(line, selection, workspace)?;
                counts.push(workspace.hits.len() as u64);
                alloc::append(&mut hits, &workspace.hits)?;
            }
            Ok((counts, hits))
        };
        process_in_batches(lines, job, each, |(counts, hits)| {
            for count in counts {
                line_hits.ends.push(line_hits.ends[line_hits.ends.len() - 1] + count);
            }
            alloc::append(&mut line_hits.hits, &hits)
        })?;
        Ok(line_hits)
    }

    /// Finds the first hit of each of many lines, as [`Surface::line`] returns it.
    ///
    /// # Errors
    /// The errors of [`Surface::lines`].
    pub fn first_hits(&self, lines: &[Line], job: &Job<'_>) -> Result<Vec<Option<Hit>>> {
        let mut first_hits = alloc::with_capacity(lines.len())?;
        let each = |lines: &[Line], workspace: &mut LineWorkspace| {
            let mut hits = alloc::with_capacity(lines.len())?;
            for line in lines {
                self.find_hits(line, HitSelection::First, workspace)?;
                hits.push(workspace.hits.first().copied());
            }
            Ok(hits)
        };
        process_in_batches(lines, job, each, |hits| alloc::append(&mut first_hits, &hits))?;
        Ok(first_hits)
    }
}

/// Checks lines, processes them in batches, and passes the results to `receive` in their order.
fn process_in_batches<R: Send>(
    lines: &[Line],
    job: &Job<'_>,
    process: impl Fn(&[Line], &mut LineWorkspace) -> Result<R> + Sync,
    mut receive: impl FnMut(R) -> Result<()>,
) -> Result<()> {
    job.step(0.0, "lines")?;
    for (k, line) in lines.iter().enumerate() {
        line.check_finite_with_direction().map_err(|error| match error {
            Error::OptionOutOfRange { option, value, .. } => {
                let why = match option {
                    "origin" => "needs an origin with coordinates up to 1e150",
                    "direction" => "needs a direction with a length from 1e-150 to 1e150",
                    _ => "needs `from` to be at most `to`",
                };
                Error::BadLine { line: k as u64, why, value }
            }
            other => other,
        })?;
    }
    // One workspace for each thread, reused from batch to batch.
    let threads = par::resolve_thread_count(lines.len().div_ceil(LINES_PER_TASK), job.requested_threads());
    let mut workspaces = alloc::collect((0..threads).map(|_| LineWorkspace::default()))?;
    let round = LINES_PER_TASK * threads;
    for (k, some) in lines.chunks(round).enumerate() {
        job.step((k * round) as f64 / lines.len() as f64, "lines")?;
        let parts = some.chunks(LINES_PER_TASK).zip(&mut workspaces);
        for part in par::map(threads, parts, |(batch, workspace)| process(batch, workspace))? {
            receive(part?)?;
        }
    }
    Ok(())
}
