//! Edges that are left of cells without a face.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;

/// Those of some edges, as classes, that no face has, each once, in order. O(e log e) for e edges, and a look at every face if
/// there are any.
pub(super) fn without_faces(
    mut edges: Vec<[u32; 2]>,
    offsets: &[u32],
    nodes: &[u32],
    classes: &[u32],
    job: &Job<'_>,
    stage: &'static str,
) -> Result<Vec<[u32; 2]>> {
    edges.iter_mut().for_each(|edge| edge.sort_unstable());
    edges.sort_unstable();
    edges.dedup();
    if edges.is_empty() {
        return Ok(edges);
    }
    let mut has_face = alloc::filled(false, edges.len())?;
    job.ranges(stage, offsets.len() - 1, |range| {
        for ends in offsets[range.start..=range.end].windows(2) {
            let face = &nodes[ends[0] as usize..ends[1] as usize];
            let nexts = face.iter().skip(1).chain(face.first());
            for (&node, &next) in face.iter().zip(nexts) {
                let mut edge = [classes[node as usize], classes[next as usize]];
                edge.sort_unstable();
                if let Ok(at) = edges.binary_search(&edge) {
                    has_face[at] = true;
                }
            }
        }
        Ok(())
    })?;
    let mut has_face = has_face.into_iter();
    edges.retain(|_| has_face.next() == Some(false));
    Ok(edges)
}
