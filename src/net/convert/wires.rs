//! Wires: edges of cells that are reduced to less than a face.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::shape::sorted_pair;

/// The edges, as pairs of classes, that belong to no face, each once, in order. O(e log e) for e
/// edges, and O(faces log e) if there are any.
pub(super) fn without_faces(
    mut edges: Vec<[u32; 2]>,
    offsets: &[u32],
    nodes: &[u32],
    classes: &[u32],
    job: &Job<'_>,
    stage: &'static str,
) -> Result<Vec<[u32; 2]>> {
    edges.iter_mut().for_each(|edge| *edge = sorted_pair(*edge));
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
                let edge = sorted_pair([classes[node as usize], classes[next as usize]]);
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
