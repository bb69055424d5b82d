//! A mesh with split edges: triangles become triangles, larger faces gain corners.

use super::corner_origins::CornerOrigins;
use super::split_face::SplitFace;
use super::t_junctions::TJunctions;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, PositionBuffer, check_size};
use std::ops::Range;

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "splitting edges";

/// A mesh with split edges.
pub(super) struct SplitMesh {
    /// The old vertices, then one vertex for each split.
    pub(super) mesh: Mesh,
    /// For each face, the old face.
    pub(super) face_origin: Vec<u32>,
    pub(super) corner_origins: CornerOrigins,
    /// For each new vertex, the ends of its edge, and the position along the edge.
    pub(super) new_vertices: Vec<([u32; 2], f64)>,
    /// The number of faces that were split or gained corners.
    pub(super) split_faces: u32,
}

/// Splits the edges. Each split gets a vertex of its own, at the position of the vertex that lies
/// there. O(V + H).
pub(super) fn split_edges(mesh: &MeshView<'_>, junctions: &TJunctions, job: &Job<'_>) -> Result<SplitMesh> {
    let TJunctions { edges, splits, .. } = junctions;
    let (vertices, faces) = (mesh.positions().len(), mesh.faces().len());
    check_size((vertices + splits.len()) as u64, (mesh.faces().half_edge_count() + 6 * splits.len()) as u64)?;
    let mut positions = PositionBuffer::with_capacity(mesh.positions().scalar(), vertices + splits.len())?;
    job.sub_job(0.0, 0.0).work_in_ranges(STAGE, vertices, |range| positions.append(mesh.positions(), range))?;
    let sources = alloc::collect(splits.iter().map(|split| split.vertex))?;
    positions.append(&PositionBuffer::gather(mesh.positions(), &sources)?.view(), 0..sources.len())?;

    // A split adds at most two faces or one corner.
    let (corners, count) = (mesh.faces().half_edge_count() + 6 * splits.len(), faces + 2 * splits.len());
    let mut face_offsets = alloc::with_capacity(count + 1)?;
    face_offsets.push(0);
    let mut result = SplitMesh {
        mesh: Mesh::new(positions, face_offsets, alloc::with_capacity(corners)?),
        face_origin: alloc::with_capacity(count)?,
        corner_origins: CornerOrigins { corners: alloc::with_capacity(corners)?, on_edges: Vec::new() },
        new_vertices: alloc::collect(
            splits.iter().map(|split| (edges[split.edge as usize].ends, split.edge_parameter)),
        )?,
        split_faces: 0,
    };
    let face_of = |k: usize| splits.get(k).map(|split| edges[split.edge as usize].face as usize);
    let (mut next, mut split_face) = (0, SplitFace::default());
    let (mut f, mut reported) = (0, 0);
    while f < faces {
        if f >= reported + FACES_PER_REPORT {
            job.step(f as f64 / faces as f64, STAGE)?;
            reported = f;
        }
        // Append runs of unchanged faces at once.
        let until = face_of(next).unwrap_or(faces).min(f + FACES_PER_REPORT);
        if f < until {
            result.append_unchanged_faces(mesh, f..until)?;
            f = until;
            continue;
        }
        let first = next;
        while face_of(next) == Some(f) {
            next += 1;
        }
        let half_edge = |k: usize| edges[splits[k].edge as usize].half_edge;
        split_face.set_face(
            mesh,
            f,
            (first..next).map(|k| (half_edge(k), splits[k].edge_parameter, (vertices + k) as u32)),
        )?;
        result.split_faces += 1;
        split_face.visit_parts(|part| {
            for &(v, origin) in part {
                alloc::push(&mut result.mesh.face_corners, v)?;
                result.corner_origins.push(origin)?;
            }
            result.end_part_of_face(f)
        })?;
        f += 1;
    }
    Ok(result)
}

impl SplitMesh {
    /// Appends a non-empty range of unchanged faces.
    fn append_unchanged_faces(&mut self, mesh: &MeshView<'_>, range: Range<usize>) -> Result<()> {
        let given = mesh.faces();
        let corners = given.corner_range(range.start).start..given.corner_range(range.end - 1).end;
        let shift = self.mesh.face_corners.len();
        let ends = range.clone().map(|f| (given.corner_range(f).end - corners.start + shift) as u32);
        alloc::extend(&mut self.mesh.face_offsets, ends)?;
        alloc::extend(&mut self.mesh.face_corners, given.corners(corners.clone()))?;
        alloc::extend(&mut self.corner_origins.corners, corners.map(|h| h as u32))?;
        alloc::extend(&mut self.face_origin, range.map(|f| f as u32))
    }

    /// Ends a face that is a part of face `f`.
    fn end_part_of_face(&mut self, f: usize) -> Result<()> {
        alloc::push(&mut self.mesh.face_offsets, self.mesh.face_corners.len() as u32)?;
        alloc::push(&mut self.face_origin, f as u32)
    }
}
