//! Patches: faces that are connected across edges with two faces.

use super::edge_fans::EdgeFans;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::{MeshView, Opposite, Topology};

const STAGE: &str = "finding patches";

/// The patches of a mesh.
pub(super) struct Patches {
    /// The patch of each face: its smallest face.
    patch_of_face: Vec<u32>,
    is_open: Vec<bool>,
    /// The fans of edges without the faces of open patches.
    pub(super) closed_fans: EdgeFans,
}

impl Patches {
    /// Finds the patches. A patch is open if it has a free edge, or an edge at which all other
    /// faces belong to open patches. O(H) for H half-edges.
    pub(super) fn find(mesh: &MeshView<'_>, topology: &Topology, fans: &EdgeFans, job: &Job<'_>) -> Result<Self> {
        let faces = mesh.faces();
        let mut sets = DisjointSets::new(faces.len())?;
        let half_edges = (0..faces.half_edge_count() as u32).filter(|&h| !topology.is_ignored(h));
        for (k, h) in half_edges.enumerate() {
            job.sub_job(0.0, 0.5).step_within_list(k, STAGE)?;
            if let Opposite::Mate(mate) = topology.opposite(h)
                && h < mate
            {
                sets.union(faces.face_of_half_edge(h), faces.face_of_half_edge(mate));
            }
        }
        let of_faces = sets.into_roots(&job.sub_job(0.5, 0.6), STAGE)?;
        let patch = |h: u32| of_faces[faces.face_of_half_edge(h) as usize] as usize;
        let at_patches = fans.iter().enumerate().flat_map(|(k, fan)| fan.iter().map(move |&h| (patch(h), k as u32)));
        let edges = Buckets::new_cancellable(faces.len(), 0u32, at_patches, &job.sub_job(0.6, 0.7), STAGE)?;
        let ranges = alloc::gather(fans.iter())?;
        let mut closed_faces = alloc::collect(ranges.iter().map(|fan| fan.len()))?;
        let (mut is_open, mut reached) = (alloc::filled(false, faces.len())?, Vec::new());
        let mut open = |patch: usize, reached: &mut Vec<usize>| {
            if std::mem::replace(&mut is_open[patch], true) { Ok(()) } else { alloc::push(reached, patch) }
        };
        for h in topology.border_half_edges(&job.sub_job(0.7, 0.8))? {
            if topology.opposite(h) == Opposite::Free {
                open(patch(h), &mut reached)?;
            }
        }
        let mut next = 0;
        while let Some(&now) = reached.get(next) {
            job.sub_job(0.8, 1.0).step_within_list(next, STAGE)?;
            next += 1;
            for &edge in edges.get(now) {
                closed_faces[edge as usize] -= 1;
                // The patch of the last face cannot be closed there. Other faces are open already.
                if closed_faces[edge as usize] == 1 {
                    ranges[edge as usize].iter().try_for_each(|&h| open(patch(h), &mut reached))?;
                }
            }
        }
        let closed_fans = fans.filtered(|h| !is_open[patch(h)])?;
        Ok(Patches { is_open, closed_fans, patch_of_face: of_faces })
    }

    pub(super) fn is_closed(&self, f: u32) -> bool {
        !self.is_open[self.patch_of_face[f as usize] as usize]
    }
}
