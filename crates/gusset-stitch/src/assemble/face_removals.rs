//! Removal of faces from trimmed pieces after a trial joint.

use super::assemble_request::Assembly;
use super::covered_faces::visit_covering_triangles;
use crate::trim::{KeptFacesOfPieces, SameSurfaceLimits};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE};
use std::ops::Range;

/// A patch that intersects other faces.
#[derive(Debug, Clone, PartialEq)]
struct IntersectingPatch {
    faces: Range<u32>,
    /// The number of vertices on its rims.
    rim_vertex_count: usize,
    /// The number of these vertices beside trimmed faces.
    rim_vertices_beside_trimmed_faces: usize,
    /// The number of faces of the part that it closes.
    faces_of_closed_part: usize,
}

impl IntersectingPatch {
    /// Returns true if the rim surrounds most of the part that the patch closes, rather than a gap
    /// or a hole in it. A disc of F triangles has a rim of about 2.3 sqrt(F) edges, and a square
    /// 2.8 sqrt(F).
    fn covers_surface(&self) -> bool {
        2 * self.rim_vertices_beside_trimmed_faces <= self.rim_vertex_count
            && self.rim_vertex_count * self.rim_vertex_count > 2 * self.faces_of_closed_part
    }
}

/// The intersecting patches, in the order of their faces.
struct IntersectingPatches(Vec<IntersectingPatch>);

impl IntersectingPatches {
    /// Collects the intersecting patches. `beside` is the set of vertices beside trimmed faces. `size`
    /// returns the number of faces of a vertex's part. O(size + c log c) for c
    /// intersections.
    fn new(
        done: &Assembly,
        cuts: &[[u32; 2]],
        beside: &BitSet,
        size: impl Fn(u32) -> u32,
    ) -> Result<IntersectingPatches> {
        let mut cutting = alloc::copied(cuts.as_flattened())?;
        cutting.sort_unstable();
        let mut patches: Vec<IntersectingPatch> = Vec::new();
        let patched = done.holes.iter().filter(|hole| !hole.faces.is_empty());
        let mut holes = alloc::gather(patched)?;
        holes.sort_unstable_by_key(|hole| (hole.faces.start, hole.rim.start));
        for hole in holes {
            let at = |end: u32| cutting.partition_point(|&f| f < end);
            if at(hole.faces.end) == at(hole.faces.start) {
                continue;
            }
            // Several loops may share a patch.
            if patches.last().is_none_or(|patch| patch.faces != hole.faces) {
                alloc::push(
                    &mut patches,
                    IntersectingPatch {
                        faces: hole.faces.clone(),
                        rim_vertex_count: 0,
                        rim_vertices_beside_trimmed_faces: 0,
                        faces_of_closed_part: 0,
                    },
                )?;
            }
            let last = patches.len() - 1;
            let rim = &done.hole_rims[hole.rim.clone()];
            patches[last].rim_vertex_count += rim.len();
            patches[last].faces_of_closed_part =
                patches[last].faces_of_closed_part.max(rim.first().map_or(0, |&v| size(v) as usize));
            patches[last].rim_vertices_beside_trimmed_faces += rim.iter().filter(|&&v| beside.contains(v)).count();
        }
        Ok(IntersectingPatches(patches))
    }

    /// Returns the intersecting patch of a face, if any.
    fn intersecting_patch_of_face(&self, face: u32) -> Option<&IntersectingPatch> {
        let after = self.0.partition_point(|patch| patch.faces.start <= face);
        self.0[..after].last().filter(|patch| patch.faces.contains(&face))
    }
}

/// The faces to remove: small parts that were cut, stay unjoined and are covered by other parts, and
/// one ring of faces around
/// the patches and strips that intersect.
pub(super) struct FaceRemovals {
    /// Vertices of the result whose faces are removed.
    vertices: BitSet,
    /// Faces of the result on unjoined parts that other parts cover.
    covered_faces: BitSet,
    has_intersections: bool,
    /// True if there are small unjoined parts.
    has_small_unjoined_parts: bool,
    /// True if other parts cover some of them.
    are_some_parts_covered: bool,
}

impl FaceRemovals {
    /// Selects the faces to remove. `cuts` are pairs of intersecting faces. Parts with fewer than
    /// `min_part_faces` faces are small. If `whole`, the faces at whole rims of intersecting patches are
    /// removed. An unjoined part is removed only if each of its faces is within `same` of a face of
    /// another part. O(size log size).
    pub(super) fn new(
        pieces: &[MeshView<'_>],
        done: &Assembly,
        cuts: &[[u32; 2]],
        min_part_faces: u32,
        whole: bool,
        same: SameSurfaceLimits,
        job: &Job<'_>,
    ) -> Result<FaceRemovals> {
        let mesh = &done.mesh;
        let old = done.turned.len();
        let mut spoilt = BitSet::new(mesh.positions.len())?;
        let (mut parts_alone, mut alone) = (false, BitSet::new(mesh.face_count())?);
        // The vertices beside trimmed faces.
        let mut beside = BitSet::new(mesh.positions.len())?;
        for (map, piece) in done.maps.iter().zip(pieces) {
            for f in (0..map.faces.len()).filter(|&f| map.faces[f] == NONE) {
                let left = piece.face(f).map(|v| map.vertices[v as usize]).filter(|&v| v != NONE);
                left.for_each(|v| beside.insert(v));
            }
        }
        // Strips and seams connect parts; patches do not.
        let unfilled = done.holes.iter().map(|hole| hole.faces.start).min().unwrap_or(mesh.face_count() as u32);
        let mut parts = DisjointSets::new(mesh.positions.len())?;
        for (k, face) in mesh.faces().take(unfilled as usize).enumerate() {
            job.step_within_list(k, "putting the pieces together")?;
            face.windows(2).for_each(|side| {
                parts.union(side[0], side[1]);
            });
        }
        let roots = parts.into_roots(job, "putting the pieces together")?;
        let mut sizes = alloc::filled(0u32, roots.len())?;
        mesh.faces().take(unfilled as usize).for_each(|face| sizes[roots[face[0] as usize] as usize] += 1);
        // Mark the corners of intersecting faces, and whole rims of patches if that did not
        // suffice. A patch over the border of an open surface lies on it: ignore it.
        let size = |v: u32| sizes[roots[v as usize] as usize];
        let patches = IntersectingPatches::new(done, cuts, &beside, size)?;
        let mut is_spoilt = false;
        for pair in cuts {
            if pair.iter().filter_map(|&f| patches.intersecting_patch_of_face(f)).any(IntersectingPatch::covers_surface)
            {
                continue;
            }
            is_spoilt = true;
            for &face in pair {
                let corners = mesh.face_offsets[face as usize]..mesh.face_offsets[face as usize + 1];
                corners.for_each(|corner| spoilt.insert(mesh.corner(corner as usize)));
            }
        }
        for hole in &done.holes {
            if patches
                .intersecting_patch_of_face(hole.faces.start)
                .is_some_and(|patch| whole && !patch.covers_surface())
            {
                done.hole_rims[hole.rim.clone()].iter().for_each(|&v| spoilt.insert(v));
            }
        }
        let largest = sizes.iter().copied().max().unwrap_or(0);
        // A part was cut if it has a vertex of a removed face.
        let mut is_cut = alloc::filled(false, roots.len())?;
        for v in (0..mesh.positions.len()).filter(|&v| beside.contains(v as u32)) {
            is_cut[roots[v] as usize] = true;
        }
        for (f, face) in mesh.faces().take(old).enumerate() {
            let root = roots[face[0] as usize] as usize;
            if sizes[root] < min_part_faces.min(largest) && is_cut[root] {
                parts_alone = true;
                alone.insert(f as u32);
            }
        }
        let mut of_alone_parts = Vec::new();
        for (map, k) in done.maps.iter().zip(0..) {
            let is_alone = |&(_, &name): &(u32, &u32)| name != NONE && alone.contains(name);
            alloc::extend(&mut of_alone_parts, (0..).zip(&map.faces).filter(is_alone).map(|(f, _)| [k, f]))?;
        }
        let part_of_face = |name: u32| roots[mesh.corner(mesh.face_offsets[name as usize] as usize) as usize];
        let mut is_bare = alloc::filled(false, roots.len())?;
        visit_covering_triangles(
            pieces,
            done,
            &of_alone_parts,
            |f| !alone.contains(f),
            same,
            job,
            |[k, f], is_covered| {
                is_bare[part_of_face(done.maps[k as usize].faces[f as usize]) as usize] |= !is_covered;
                Ok(())
            },
        )?;
        let (mut covers, mut covered) = (false, BitSet::new(mesh.face_count())?);
        for f in (0..old as u32).filter(|&f| alone.contains(f) && !is_bare[part_of_face(f) as usize]) {
            covers = true;
            covered.insert(f);
        }
        Ok(FaceRemovals {
            vertices: spoilt,
            covered_faces: covered,
            has_intersections: is_spoilt,
            has_small_unjoined_parts: parts_alone,
            are_some_parts_covered: covers,
        })
    }

    /// Returns true if there are unjoined parts.
    pub(super) fn has_unjoined_parts(&self) -> bool {
        self.has_small_unjoined_parts
    }

    /// Removes the selected faces from the trimmed pieces, and faces of unjoined parts only if
    /// `removes_parts`. Returns false if nothing was removed.
    pub(super) fn remove_faces_from(
        &self,
        pieces: &[MeshView<'_>],
        trimmed: &mut KeptFacesOfPieces,
        done: &Assembly,
        removes_parts: bool,
    ) -> bool {
        if !(self.has_intersections || self.are_some_parts_covered && removes_parts) {
            return false;
        }
        let mut less = false;
        for ((kept, map), piece) in trimmed.kept.iter_mut().zip(&done.maps).zip(pieces) {
            let before = kept.len();
            kept.retain(|&f| {
                let name = map.faces[f as usize];
                let is_dropped = removes_parts && name != NONE && self.covered_faces.contains(name);
                let mut corners = piece.face(f as usize).map(|v| map.vertices[v as usize]);
                !is_dropped && !corners.any(|v| v != NONE && self.vertices.contains(v))
            });
            less |= kept.len() < before;
        }
        less
    }
}
