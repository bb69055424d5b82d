//! A mesh with split edges: triangles become triangles, larger faces gain corners.

use super::corner_origins::CornerOrigins;
use super::junctions::Junctions;
use super::split_face::SplitFace;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::{Mesh, MeshView, PositionBuffer, check_size};

/// Faces between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

const STAGE: &str = "splitting edges";

/// A mesh with split edges.
pub(super) struct SplitMesh {
    /// The old vertices, then one for each split.
    pub(super) mesh: Mesh,
    /// Per face, the old one.
    pub(super) face_origin: Vec<u32>,
    pub(super) corner_origins: CornerOrigins,
    /// Per new vertex, the ends of its edge, and how far along it is.
    pub(super) new_vertices: Vec<([u32; 2], f64)>,
    /// How many faces were split or gained corners.
    pub(super) split_faces: u32,
}

/// Splits the edges: each split has a vertex of its own, at the position of the one that it is
/// split at. O(V + H).
pub(super) fn split_edges(mesh: &MeshView<'_>, junctions: &Junctions, job: &Job<'_>) -> Result<SplitMesh> {
    let Junctions { edges, splits, .. } = junctions;
    let (vertices, faces) = (mesh.positions().len(), mesh.faces().len());
    check_size((vertices + splits.len()) as u64, (mesh.faces().half_edge_count() + 6 * splits.len()) as u64)?;
    let mut positions = PositionBuffer::with_capacity(mesh.positions().scalar(), vertices + splits.len())?;
    positions.append(mesh.positions())?;
    let sources = alloc::collect(splits.iter().map(|split| split.vertex))?;
    positions.append(&PositionBuffer::gather(mesh.positions(), &sources)?.view())?;

    let mut done = SplitMesh {
        mesh: Mesh::new(positions, alloc::filled(0, 1)?, Vec::new()),
        face_origin: Vec::new(),
        corner_origins: CornerOrigins::default(),
        new_vertices: alloc::collect(splits.iter().map(|split| (edges[split.edge as usize].ends, split.at)))?,
        split_faces: 0,
    };
    let face_of = |k: usize| splits.get(k).map(|split| edges[split.edge as usize].face as usize);
    let (mut next, mut split_face) = (0, SplitFace::default());
    for f in 0..faces {
        job.step_every(REPORT_INTERVAL, f, faces, STAGE)?;
        let first = next;
        while face_of(next) == Some(f) {
            next += 1;
        }
        if first == next {
            alloc::extend(&mut done.mesh.face_corners, mesh.face(f))?;
            alloc::extend(&mut done.corner_origins.corners, mesh.faces().range(f).map(|h| h as u32))?;
            done.end_face(f)?;
            continue;
        }
        let half_edge = |k: usize| edges[splits[k].edge as usize].half_edge;
        split_face.set(mesh, f, (first..next).map(|k| (half_edge(k), splits[k].at, (vertices + k) as u32)))?;
        done.split_faces += 1;
        split_face.parts(|part| {
            for &(v, origin) in part {
                alloc::push(&mut done.mesh.face_corners, v)?;
                done.corner_origins.push(origin)?;
            }
            done.end_face(f)
        })?;
    }
    Ok(done)
}

impl SplitMesh {
    /// Ends a face that was a part of face `f`.
    fn end_face(&mut self, f: usize) -> Result<()> {
        alloc::push(&mut self.mesh.face_offsets, self.mesh.face_corners.len() as u32)?;
        alloc::push(&mut self.face_origin, f as u32)
    }
}
