//! Division of a walk that repeats vertices into simple loops.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// The progress message of the walks.
pub(super) const STAGE: &str = "walking along the boundary";

/// Cuts `walk` at every vertex that it repeats. Its steps lead from `tail` to `head`. Calls
/// `visit_loop` with each simple piece, and whether it is closed.
///
/// The steps are pushed on a stack. If a step arrives at a vertex that is on the stack, the steps
/// above the vertex form a simple loop and are popped. Linear time. `place` has an entry for each
/// vertex of the mesh, all [`NONE`], and is restored.
pub(crate) fn split_into_simple_loops<Step: Copy>(
    walk: &[Step],
    tail: impl Fn(Step) -> u32,
    head: impl Fn(Step) -> u32,
    place: &mut [u32],
    job: &Job<'_>,
    mut visit_loop: impl FnMut(&[Step], bool) -> Result<()>,
) -> Result<()> {
    // place[v] is the position on the stack of the step that leaves v.
    let mut stack: Vec<Step> = alloc::with_capacity(walk.len())?;
    for (k, &step) in walk.iter().enumerate() {
        job.step_within_list(k, STAGE)?;
        place[tail(step) as usize] = stack.len() as u32;
        stack.push(step);
        let at = place[head(step) as usize];
        if at != NONE {
            visit_loop(&stack[at as usize..], true)?;
            for (k, step) in stack.drain(at as usize..).enumerate() {
                job.step_within_list(k, STAGE)?;
                place[tail(step) as usize] = NONE;
            }
        }
    }
    // The last step of a closed walk empties the stack. The remaining steps form an open chain.
    if !stack.is_empty() {
        visit_loop(&stack, false)?;
        stack.iter().for_each(|&step| place[tail(step) as usize] = NONE);
    }
    Ok(())
}
