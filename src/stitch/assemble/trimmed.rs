//! What has to go of trimmed pieces once what is left of them has been joined.

use super::request::Assembly;
use crate::alloc;
use crate::error::Result;
use crate::fill::Hole;
use crate::geom::bit_set::BitSet;
use crate::geom::disjoint_sets::DisjointSets;
use crate::job::Job;
use crate::mesh::{MeshView, NONE};
use crate::trim::Trimmed;

/// What has to go: small parts that nothing joined with the rest, where they were cut; and, round
/// what cuts, one ring of what patches and strips hang on.
pub(super) struct Spoilt {
    /// Vertices of the result.
    vertices: BitSet,
    /// Faces of it.
    alone: BitSet,
    cuts: bool,
    parts: bool,
}

impl Spoilt {
    /// `cuts`: pairs of faces that cut each other. `least`: what has fewer faces is small. O(size).
    pub(super) fn of(
        pieces: &[MeshView<'_>],
        done: &Assembly,
        cuts: &[[u32; 2]],
        least: u32,
        job: &Job<'_>,
    ) -> Result<Spoilt> {
        let mesh = &done.mesh;
        let old = done.turned.len();
        let mut spoilt = BitSet::new(mesh.positions.len())?;
        let (mut parts_alone, mut alone) = (false, BitSet::new(mesh.face_count())?);
        // Vertices beside what was trimmed.
        let mut beside = BitSet::new(mesh.positions.len())?;
        for (map, piece) in done.maps.iter().zip(pieces) {
            for f in (0..map.faces.len()).filter(|&f| map.faces[f] == NONE) {
                let left = piece.face(f).map(|v| map.vertices[v as usize]).filter(|&v| v != NONE);
                left.for_each(|v| beside.insert(v));
            }
        }
        // The rims of patches that cut, and the corners of what they cut: of gaps that trimming
        // left, as a patch over the border of what was seen may cut, too, and no surface is to go
        // for that.
        let is_gap = |rim: &[u32]| 2 * rim.iter().filter(|&&v| beside.contains(v)).count() > rim.len();
        let mut is_spoilt = false;
        for &[f, g] in cuts {
            let of_patch = |hole: &&Hole| hole.faces.contains(&f) || hole.faces.contains(&g);
            let mut rims = done.holes.iter().filter(of_patch).map(|hole| &done.hole_rims[hole.rim.clone()]);
            if !rims.clone().all(is_gap) {
                continue;
            }
            is_spoilt = true;
            rims.by_ref().flatten().for_each(|&v| spoilt.insert(v));
            for face in [f, g] {
                let corners = mesh.face_offsets[face as usize]..mesh.face_offsets[face as usize + 1];
                corners.for_each(|corner| spoilt.insert(mesh.corner(corner as usize)));
            }
        }
        // Parts that strips and seams hold together, patches apart.
        let unfilled = done.holes.iter().map(|hole| hole.faces.start).min().unwrap_or(mesh.face_count() as u32);
        let mut parts = DisjointSets::new(mesh.positions.len())?;
        for (k, face) in mesh.faces().take(unfilled as usize).enumerate() {
            job.step_within(k, "putting the pieces together")?;
            face.windows(2).for_each(|side| {
                parts.union(side[0], side[1]);
            });
        }
        let roots = parts.into_roots(job, "putting the pieces together")?;
        let mut sizes = alloc::filled(0u32, roots.len())?;
        mesh.faces().take(unfilled as usize).for_each(|face| sizes[roots[face[0] as usize] as usize] += 1);
        let largest = sizes.iter().copied().max().unwrap_or(0);
        // Those that were cut have a vertex of a face that is gone.
        let mut is_cut = alloc::filled(false, roots.len())?;
        for v in (0..mesh.positions.len()).filter(|&v| beside.contains(v as u32)) {
            is_cut[roots[v] as usize] = true;
        }
        for (f, face) in mesh.faces().take(old).enumerate() {
            let root = roots[face[0] as usize] as usize;
            if sizes[root] < least.min(largest) && is_cut[root] {
                parts_alone = true;
                alone.insert(f as u32);
            }
        }
        Ok(Spoilt { vertices: spoilt, alone, cuts: is_spoilt, parts: parts_alone })
    }

    /// True if there are parts that nothing joined.
    pub(super) fn has_alone(&self) -> bool {
        self.parts
    }

    /// Takes it out of what is left of the pieces, parts that are alone only if `parts` says so;
    /// false if there was nothing to take.
    pub(super) fn take_out(
        &self,
        pieces: &[MeshView<'_>],
        trimmed: &mut Trimmed,
        done: &Assembly,
        parts: bool,
    ) -> bool {
        if !(self.cuts || self.parts && parts) {
            return false;
        }
        let mut less = false;
        for ((kept, map), piece) in trimmed.kept.iter_mut().zip(&done.maps).zip(pieces) {
            let before = kept.len();
            kept.retain(|&f| {
                let name = map.faces[f as usize];
                let is_alone = parts && name != NONE && self.alone.contains(name);
                let mut corners = piece.face(f as usize).map(|v| map.vertices[v as usize]);
                !is_alone && !corners.any(|v| v != NONE && self.vertices.contains(v))
            });
            less |= kept.len() < before;
        }
        less
    }
}
