//! Groups the loops that the caller wants to share a patch.

use super::candidate_loops::CandidateLoop;
use super::fill_request::{HoleStatus, LoopSelection, Together};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort;

/// Returns the candidates to fill by patch. Each group is ascending, and the groups are ordered by
/// their first candidates. Candidates that are left open belong to no group.
pub(super) fn group_candidates_by_patch(
    candidates: &[CandidateLoop],
    selection: LoopSelection<'_>,
    together: Together,
) -> Result<Vec<Vec<usize>>> {
    let to_fill = |&number: &usize| candidates[number].status == HoleStatus::Filled;
    let mut numbers = alloc::gather((0..candidates.len()).filter(to_fill))?;
    let group = |number: usize| match (selection, together) {
        (LoopSelection::Groups(loops), _) => loops[number].1 as usize,
        (_, Together::One) => 0,
        (_, Together::Apart | Together::Cheapest) => number,
    };
    sort::sort_stable(&mut numbers, &|&a, &b| (group(a), a).cmp(&(group(b), b)));
    let chunks = numbers.chunk_by(|&i, &k| group(i) == group(k));
    let mut groups = alloc::try_collect(chunks.map(alloc::copied))?;
    groups.sort_unstable();
    Ok(groups)
}
