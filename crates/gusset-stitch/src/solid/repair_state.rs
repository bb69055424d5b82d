//! The mesh between the stages of a repair, and where its elements are from.

use super::corner_place::CornerPlace;
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
    /// For each corner, its place on a face of the input; [`CornerPlace::NONE`] for the faces of
    /// patches.
    pub(super) corner_places: Vec<CornerPlace>,
    /// The new vertices, each with three parents and their weights.
    pub(super) new_vertices: Vec<NewVertex>,
    /// For each face, true if it was turned over.
    pub(super) turned: Vec<bool>,
    /// The reason of each dropped face of the input, also of faces with remaining parts.
    pub(super) dropped: Vec<DroppedFace>,
    /// The number of changes so far, of any kind but turned faces.
    pub(super) changes: u32,
    /// The number of times that a face was turned over.
    turns: u64,
}

/// A number that tells one state of the mesh from another: its changes and turned faces.
pub(super) type Revision = (u32, u64);

/// A new vertex, three vertices that precede it, and their weights.
pub(super) type NewVertex = (u32, [u32; 3], [f64; 3]);

impl RepairState {
    /// Creates the state of the input before the first stage.
    pub(super) fn unchanged(mesh: Mesh) -> Result<RepairState> {
        let corners = (0..mesh.face_corners.len() as u32).map(CornerPlace::at_corner);
        Ok(RepairState {
            face_origin: alloc::collect((0..mesh.face_count()).map(|f| f as u32))?,
            vertex_origin: alloc::collect((0..mesh.positions.len()).map(|v| v as u32))?,
            corner_places: alloc::collect(corners)?,
            turned: alloc::filled(false, mesh.face_count())?,
            new_vertices: Vec::new(),
            dropped: Vec::new(),
            changes: 0,
            turns: 0,
            mesh,
        })
    }

    /// Returns the revision of the mesh.
    pub(super) fn revision(&self) -> Revision {
        (self.changes, self.turns)
    }

    /// Turns a face over. It keeps its first corner.
    pub(super) fn turn_face(&mut self, f: usize) {
        let [first, end] = [f, f + 1].map(|k| self.mesh.face_offsets[k] as usize);
        self.mesh.face_corners[first + 1..end].reverse();
        self.corner_places[first + 1..end].reverse();
        self.turned[f] ^= true;
        self.turns += 1;
    }

    /// Lists a dropped face.
    pub(super) fn list_dropped(&mut self, f: usize, reason: DropReason) -> Result<()> {
        match self.face_origin[f] {
            NONE => Ok(()),
            face => alloc::push(&mut self.dropped, DroppedFace { face, reason }),
        }
    }

    /// Appends copies of vertices.
    pub(super) fn copy_vertices(&mut self, copies: &[u32]) -> Result<()> {
        if copies.is_empty() {
            return Ok(());
        }
        self.changes += 1;
        let old = self.mesh.positions.len() as u32;
        let all = alloc::gather((0..old).chain(copies.iter().copied()))?;
        self.mesh.positions = self.mesh.positions.select_vertices(&all)?;
        for (v, &copied) in (old..).zip(copies) {
            let origin = self.vertex_origin[copied as usize];
            alloc::push(&mut self.vertex_origin, origin)?;
            // New vertices are listed in ascending order.
            if let Ok(k) = self.new_vertices.binary_search_by_key(&copied, |&(v, ..)| v) {
                let (_, parents, weights) = self.new_vertices[k];
                alloc::push(&mut self.new_vertices, (v, parents, weights))?;
            }
        }
        Ok(())
    }

    /// Drops the faces with a reason.
    pub(super) fn drop_faces(&mut self, reasons: &[Option<DropReason>]) -> Result<()> {
        // A mesh keeps its faces rather than become empty.
        if reasons.iter().all(Option::is_none) || reasons.iter().all(Option::is_some) {
            return Ok(());
        }
        self.changes += 1;
        for (f, reason) in reasons.iter().enumerate() {
            reason.map_or(Ok(()), |reason| self.list_dropped(f, reason))?;
        }
        let (mut faces, mut corners) = (0, 0);
        for (f, reason) in reasons.iter().enumerate() {
            let [start, end] = [f, f + 1].map(|k| self.mesh.face_offsets[k] as usize);
            if reason.is_none() {
                self.mesh.face_corners.copy_within(start..end, corners);
                self.corner_places.copy_within(start..end, corners);
                // The offsets of earlier faces are not read again.
                self.mesh.face_offsets[faces] = corners as u32;
                self.face_origin[faces] = self.face_origin[f];
                self.turned[faces] = self.turned[f];
                corners += end - start;
                faces += 1;
            }
        }
        self.mesh.face_offsets[faces] = corners as u32;
        self.mesh.face_offsets.truncate(faces + 1);
        self.mesh.face_corners.truncate(corners);
        self.corner_places.truncate(corners);
        self.face_origin.truncate(faces);
        self.turned.truncate(faces);
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
        self.changes += 1;
        let (vertices, half_edges) = (self.mesh.positions.len(), self.mesh.face_corners.len());
        // A vertex on a side adds at most two triangles.
        let most = half_edges + 6 * places.len();
        check_size(vertices as u64, most as u64)?;
        let (mut offsets, mut corners) =
            (alloc::with_capacity(self.face_origin.len() + 2 * places.len() + 1)?, alloc::with_capacity(most)?);
        offsets.push(0);
        let (mut origins, mut turned, mut dropped) = (Vec::new(), Vec::new(), Vec::new());
        let mut places_of_corners = alloc::with_capacity(most)?;
        {
            let view = self.mesh.view(&job.sub_job(0.0, 0.2))?;
            let (mut next, mut split) = (0, SplitFace::default());
            for (f, &reason) in reasons.iter().enumerate() {
                job.sub_job(0.2, 1.0).step_within_list(f, STAGE)?;
                let first = next;
                while places.get(next).is_some_and(|&(h, ..)| (h as usize) < view.faces().corner_range(f).end) {
                    next += 1;
                }
                if let Some(reason) = reason {
                    alloc::push(&mut dropped, (f, reason))?;
                    continue;
                }
                let mut end_face = |end: usize| {
                    alloc::push(&mut origins, self.face_origin[f])?;
                    alloc::push(&mut turned, self.turned[f])?;
                    alloc::push(&mut offsets, end as u32)
                };
                if first == next {
                    corners.extend(view.face(f));
                    places_of_corners.extend_from_slice(&self.corner_places[view.faces().corner_range(f)]);
                    end_face(corners.len())?;
                    continue;
                }
                split.set_face(&view, f, places[first..next].iter().copied())?;
                split.visit_parts(|part| {
                    for &(v, place) in part {
                        corners.push(v);
                        places_of_corners.push(CornerPlace::between(place, |h| self.corner_places[h as usize]));
                    }
                    end_face(corners.len())
                })?;
            }
        }
        dropped.into_iter().try_for_each(|(f, reason)| self.list_dropped(f, reason))?;
        (self.mesh.face_offsets, self.mesh.face_corners) = (offsets, corners);
        (self.face_origin, self.turned, self.corner_places) = (origins, turned, places_of_corners);
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
        let mut origins = alloc::with_capacity(self.mesh.face_corners.len())?;
        for (f, face) in self.mesh.faces().enumerate() {
            let first = self.mesh.face_offsets[f] as usize;
            let is_kept = |k: usize| face[k] != face[(k + face.len() - 1) % face.len()];
            if (0..face.len()).filter(|&k| is_kept(k)).count() < 3 {
                reasons[f] = Some(DropReason::Degenerate);
            }
            for k in (0..face.len()).filter(|&k| reasons[f].is_some() || is_kept(k)) {
                corners.push(face[k]);
                origins.push(self.corner_places[first + k]);
            }
            offsets.push(corners.len() as u32);
        }
        self.corner_places = origins;
        (self.mesh.face_offsets, self.mesh.face_corners) = (offsets, corners);
        self.drop_faces(&reasons)
    }

    /// Removes vertices that no face uses. Puts the vertices of the input first, then new vertices on faces of the
    /// input, whose places it returns. Copies of a vertex follow each other in the order of their first corners, so that
    /// another separation of them numbers them alike. Lists dropped faces only if no part remains.
    pub(super) fn finish(&mut self, input_faces: usize) -> Result<Vec<CornerPlace>> {
        let count = self.mesh.positions.len();
        let mut ranks = alloc::filled(None, count)?;
        let mut places = alloc::filled(CornerPlace::NONE, count)?;
        let mut first_corners = alloc::filled(NONE, count)?;
        for ((&v, &place), corner) in self.mesh.face_corners.iter().zip(&self.corner_places).zip(0..) {
            let v = v as usize;
            first_corners[v] = first_corners[v].min(corner);
            if self.vertex_origin[v] == NONE && places[v] == CornerPlace::NONE {
                places[v] = place;
            }
            let is_placed = places[v] != CornerPlace::NONE;
            ranks[v] = Some(if self.vertex_origin[v] != NONE { 0 } else { 2 - u32::from(is_placed) });
        }
        let ranks = &ranks;
        let all = alloc::collect((0..count).map(|v| v as u32))?;
        let ranked = |rank: u32| all.iter().copied().filter(move |&v| ranks[v as usize] == Some(rank));
        let mut order = alloc::gather(ranked(0).chain(ranked(1)).chain(ranked(2)))?;
        let origin = |v: u32| self.vertex_origin[v as usize];
        let old = order.partition_point(|&v| origin(v) != NONE);
        if !order[..old].is_sorted_by_key(|&v| origin(v)) {
            order[..old].sort_unstable_by_key(|&v| (origin(v), first_corners[v as usize]));
        }
        self.new_vertices.retain(|&(v, ..)| ranks[v as usize] == Some(2));
        let places = alloc::gather(ranked(1).map(|v| places[v as usize]))?;
        let mut numbers = alloc::filled(NONE, count)?;
        (0..).zip(&order).for_each(|(k, &v)| numbers[v as usize] = k);
        self.mesh.face_corners.iter_mut().for_each(|v| *v = numbers[*v as usize]);
        self.mesh.positions = self.mesh.positions.select_vertices(&order)?;
        self.vertex_origin = alloc::collect(order.iter().map(|&v| self.vertex_origin[v as usize]))?;
        self.renumber_parents(&numbers);
        let mut remains = alloc::filled(false, input_faces)?;
        self.face_origin.iter().filter(|&&f| f != NONE).for_each(|&f| remains[f as usize] = true);
        self.dropped.retain(|dropped| !remains[dropped.face as usize]);
        self.dropped.sort_unstable();
        self.dropped.dedup_by_key(|dropped| dropped.face);
        Ok(places)
    }

    /// Renumbers the parents of the used new vertices. A parent that is not used any more is
    /// replaced by the first one that is.
    fn renumber_parents(&mut self, numbers: &[u32]) {
        self.new_vertices.retain(|&(v, ..)| numbers[v as usize] != NONE);
        for (v, parents, _) in &mut self.new_vertices {
            *v = numbers[*v as usize];
            let renumbered = parents.map(|parent| numbers[parent as usize]);
            let used = renumbered.into_iter().find(|&parent| parent != NONE && parent < *v).unwrap_or(0);
            *parents = renumbered.map(|parent| if parent == NONE || parent >= *v { used } else { parent });
        }
        self.new_vertices.sort_unstable_by_key(|&(v, ..)| v);
    }
}
