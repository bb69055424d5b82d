//! A walk that passes a vertex twice, cut into loops that do not.

use super::walk::Dart;
use crate::alloc;
use crate::error::Result;
use crate::mesh::{MeshView, NONE};

/// Cuts `walk` at every vertex that it passes again and gives each simple piece to `emit`, with whether it is closed.
///
/// The walk is laid on a stack; when it arrives at a vertex that is still on the stack, what lies above that vertex is a
/// simple loop and is taken off. Linear time. `place` has one entry for each vertex of the mesh, all [`NONE`], and is left so.
pub(super) fn split_simple(
    mesh: &MeshView<'_>,
    walk: &[Dart],
    place: &mut [u32],
    mut emit: impl FnMut(&[Dart], bool) -> Result<()>,
) -> Result<()> {
    // place[v] = position on the stack of the dart that leaves v.
    let mut stack: Vec<Dart> = alloc::with_capacity(walk.len())?;
    for &dart in walk {
        place[dart.tail(mesh) as usize] = stack.len() as u32;
        stack.push(dart);
        let at = place[dart.head(mesh) as usize];
        if at != NONE {
            emit(&stack[at as usize..], true)?;
            for dart in stack.drain(at as usize..) {
                place[dart.tail(mesh) as usize] = NONE;
            }
        }
    }
    // A closed walk ends where it began, and its last arrival has emptied the stack; what is left is an open chain.
    if !stack.is_empty() {
        emit(&stack, false)?;
        stack.iter().for_each(|dart| place[dart.tail(mesh) as usize] = NONE);
    }
    Ok(())
}
