//! Division of a walk that visits a vertex twice into simple loops.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// What a host reads of walks and their parts.
pub(super) const STAGE: &str = "walking along the boundary";

/// Cuts `walk`, whose steps lead from `tail` to `head`, at every vertex that it passes again, and
/// gives each simple piece to `emit`, with whether it is closed.
///
/// The walk is laid on a stack; when it arrives at a vertex that is still on the stack, what lies
/// above that vertex is a simple loop and is taken off. Linear time. `place` has one entry for each
/// vertex of the mesh, all [`NONE`], and is left so.
pub(crate) fn split_simple<Step: Copy>(
    walk: &[Step],
    tail: impl Fn(Step) -> u32,
    head: impl Fn(Step) -> u32,
    place: &mut [u32],
    job: &Job<'_>,
    mut emit: impl FnMut(&[Step], bool) -> Result<()>,
) -> Result<()> {
    // place[v] = position on the stack of the step that leaves v.
    let mut stack: Vec<Step> = alloc::with_capacity(walk.len())?;
    for (k, &step) in walk.iter().enumerate() {
        job.step_within(k, STAGE)?;
        place[tail(step) as usize] = stack.len() as u32;
        stack.push(step);
        let at = place[head(step) as usize];
        if at != NONE {
            emit(&stack[at as usize..], true)?;
            for (k, step) in stack.drain(at as usize..).enumerate() {
                job.step_within(k, STAGE)?;
                place[tail(step) as usize] = NONE;
            }
        }
    }
    // A closed walk ends where it began, and its last arrival has emptied the stack; what is left
    // is an open chain.
    if !stack.is_empty() {
        emit(&stack, false)?;
        stack.iter().for_each(|&step| place[tail(step) as usize] = NONE);
    }
    Ok(())
}
