//! The mesh between the stages of a repair, and where its elements are from.

use super::repair_request::{DropReason, DroppedFace};
use crate::repair::split_face::SplitFace;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, NONE, check_size};

const STAGE: &str = "splitting faces";

/// A mesh under repair.
pub(super) struct RepairState {
    pub(super) mesh: Mesh,
    /// For each face, its face in the input; [`NONE`] for faces of patches.
    pub(super) face_origin: Vec<u32>,
    /// For each vertex, its vertex in the input; [`NONE`] for new vertices.
    pub(super) vertex_origin: Vec<u32>,
    /// For each face, true if it was turned over.
    pub(super) turned: Vec<bool>,
    /// The reason of each dropped face of the input, also of faces with remaining parts.
    pub(super) dropped: Vec<DroppedFace>,
}

impl RepairState {
    /// Drops the faces with a reason.
    pub(super) fn drop_faces(&mut self, reasons: &[Option<DropReason>]) -> Result<()> {
        if reasons.iter().all(Option::is_none) {
            return Ok(());
        }
        for (&origin, &reason) in self.face_origin.iter().zip(reasons) {
            if let (Some(reason), true) = (reason, origin != NONE) {
                alloc::push(&mut self.dropped, DroppedFace { face: origin, reason })?;
            }
        }
        retain_faces(&mut self.mesh, |f| reasons[f].is_none());
        retain_where(&mut self.face_origin, |f| reasons[f].is_none());
        retain_where(&mut self.turned, |f| reasons[f].is_none());
        Ok(())
    }

    /// Drops the faces with a reason, and inserts vertices on half-edges: places are triples of the
    /// half-edge, the position along it, and the vertex, ascending. Triangles become triangles, and
    /// larger faces gain corners.
    pub(super) fn drop_and_insert(
        &mut self,
        reasons: &[Option<DropReason>],
        places: &[(u32, f64, u32)],
        job: &Job<'_>,
    ) -> Result<()> {
        let (vertices, half_edges) = (self.mesh.positions.len(), self.mesh.face_corners.len());
        // A vertex on a side adds at most two triangles.
        let most = half_edges + 6 * places.len();
        check_size(vertices as u64, most as u64)?;
        let (mut offsets, mut corners) =
            (alloc::with_capacity(self.face_origin.len() + 2 * places.len() + 1)?, alloc::with_capacity(most)?);
        offsets.push(0);
        let (mut origins, mut turned) = (Vec::new(), Vec::new());
        {
            let view = self.mesh.view(&job.part(0.0, 0.2))?;
            let (mut next, mut split) = (0, SplitFace::default());
            for f in 0..view.faces().len() {
                job.part(0.2, 1.0).step_within_list(f, STAGE)?;
                let first = next;
                while places.get(next).is_some_and(|&(h, ..)| (h as usize) < view.faces().corner_range(f).end) {
                    next += 1;
                }
                if let Some(reason) = reasons[f] {
                    if self.face_origin[f] != NONE {
                        alloc::push(&mut self.dropped, DroppedFace { face: self.face_origin[f], reason })?;
                    }
                    continue;
                }
                let mut end_face = |end: usize| {
                    alloc::push(&mut origins, self.face_origin[f])?;
                    alloc::push(&mut turned, self.turned[f])?;
                    alloc::push(&mut offsets, end as u32)
                };
                if first == next {
                    corners.extend(view.face(f));
                    end_face(corners.len())?;
                    continue;
                }
                split.set_face(&view, f, places[first..next].iter().copied())?;
                split.visit_parts(|part| {
                    corners.extend(part.iter().map(|&(v, _)| v));
                    end_face(corners.len())
                })?;
            }
        }
        (self.mesh.face_offsets, self.mesh.face_corners) = (offsets, corners);
        (self.face_origin, self.turned) = (origins, turned);
        Ok(())
    }

    /// Replaces vertices in all faces. Pairs are (replaced vertex, vertex), ascending; no vertex is in
    /// two pairs.
    pub(super) fn replace_vertices(&mut self, pairs: &[(u32, u32)]) {
        for v in &mut self.mesh.face_corners {
            if let Ok(k) = pairs.binary_search_by_key(v, |pair| pair.0) {
                *v = pairs[k].1;
            }
        }
    }

    /// Removes corners that repeat the corner before them, and faces with fewer than three left.
    pub(super) fn collapse_repeated_corners(&mut self) -> Result<()> {
        let mut reasons = alloc::filled(None, self.mesh.face_count())?;
        let (mut offsets, mut corners) = (vec![0], alloc::with_capacity(self.mesh.face_corners.len())?);
        alloc::reserve(&mut offsets, self.mesh.face_count())?;
        for (f, face) in self.mesh.faces().enumerate() {
            let start = corners.len();
            let before = |k: usize| face[(k + face.len() - 1) % face.len()];
            corners.extend((0..face.len()).filter(|&k| face[k] != before(k)).map(|k| face[k]));
            if corners.len() < start + 3 {
                corners.truncate(start);
                corners.extend(face);
                reasons[f] = Some(DropReason::Degenerate);
            }
            offsets.push(corners.len() as u32);
        }
        (self.mesh.face_offsets, self.mesh.face_corners) = (offsets, corners);
        self.drop_faces(&reasons)
    }

    /// Removes vertices that no face uses, and puts the vertices of the input first. Lists dropped
    /// faces only if no part remains.
    pub(super) fn finish(&mut self, input_faces: usize) -> Result<()> {
        let count = self.mesh.positions.len();
        let mut is_used = alloc::filled(false, count)?;
        self.mesh.face_corners.iter().for_each(|&v| is_used[v as usize] = true);
        let used = |is_old: bool| {
            let (is_used, origin) = (&is_used, &self.vertex_origin);
            (0..count as u32).filter(move |&v| is_used[v as usize] && (origin[v as usize] != NONE) == is_old)
        };
        let order = alloc::gather(used(true).chain(used(false)))?;
        let mut numbers = alloc::filled(NONE, count)?;
        (0..).zip(&order).for_each(|(k, &v)| numbers[v as usize] = k);
        self.mesh.face_corners.iter_mut().for_each(|v| *v = numbers[*v as usize]);
        self.mesh.positions = self.mesh.positions.select_vertices(&order)?;
        self.vertex_origin = alloc::collect(order.iter().map(|&v| self.vertex_origin[v as usize]))?;
        let mut remains = alloc::filled(false, input_faces)?;
        self.face_origin.iter().filter(|&&f| f != NONE).for_each(|&f| remains[f as usize] = true);
        self.dropped.retain(|dropped| !remains[dropped.face as usize]);
        self.dropped.sort_unstable();
        self.dropped.dedup_by_key(|dropped| dropped.face);
        Ok(())
    }
}

/// Keeps the faces for which `keep` returns true.
fn retain_faces(mesh: &mut Mesh, keep: impl Fn(usize) -> bool) {
    let (mut faces, mut corners) = (0, 0);
    for f in 0..mesh.face_count() {
        let [start, end] = [f, f + 1].map(|k| mesh.face_offsets[k] as usize);
        if keep(f) {
            mesh.face_corners.copy_within(start..end, corners);
            corners += end - start;
            // The end of an earlier face is not read again.
            mesh.face_offsets[faces] = (corners - (end - start)) as u32;
            faces += 1;
        }
    }
    mesh.face_offsets[faces] = corners as u32;
    mesh.face_offsets.truncate(faces + 1);
    mesh.face_corners.truncate(corners);
}

fn retain_where<T>(items: &mut Vec<T>, keep: impl Fn(usize) -> bool) {
    let mut k = 0;
    items.retain(|_| {
        k += 1;
        keep(k - 1)
    });
}
