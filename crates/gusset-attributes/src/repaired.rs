//! Origins of meshes in which some vertices and faces were merged or removed: welded, sewn,
//! assembled, trimmed and triangulated meshes.

use super::domain::Counts;
use super::joined::corners_before_turning;
use super::origins::{KeptElements, Origins};
use super::table::{STAGE, SourceTable};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, TriangulatedMesh};
use gusset_stitch::assemble::Assembly;
use gusset_stitch::repair::corner_origins::{CornerOnEdge, CornerOrigins};
use gusset_stitch::repair::sew::Sew;
use gusset_stitch::repair::weld::Weld;
use gusset_stitch::solid::Repaired;
use gusset_stitch::trim::TrimmedPieces;

impl Origins {
    /// The origins of a welded mesh.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_weld(weld: &Weld, job: &Job<'_>) -> Result<Origins> {
        let (vertices, corners, faces) = (weld.vertex_map.len(), weld.old_corners, weld.face_map.len());
        let repaired = RepairedMesh {
            mesh: &weld.mesh,
            old_face_count: weld.mesh.face_count(),
            new_vertex_count: 0,
            corner_origins: weld.corners_left.as_deref().map(|corners| (corners, &[][..])),
        };
        let face_origin =
            alloc::gather(weld.face_map.iter().zip(0..).filter(|&(&new, _)| new != NONE).map(|(_, old)| old))?;
        let counts = vec![Counts { vertices, corners, faces }];
        let kept =
            repaired.kept_elements(counts, weld.vertex_map.iter().copied(), Some(&face_origin), |_| false, job)?;
        Origins::from_kept(kept)
    }

    /// The origins of a sewn mesh.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_sew(sew: &Sew, job: &Job<'_>) -> Result<Origins> {
        let repaired = RepairedMesh {
            mesh: &sew.mesh,
            old_face_count: sew.mesh.face_count(),
            new_vertex_count: sew.new_vertices.len(),
            corner_origins: sew.corner_origins.as_ref().map(corner_origin_parts),
        };
        let (vertices, corners, faces) = (sew.vertex_map.len(), sew.old_corners, sew.face_map.len());
        let counts = vec![Counts { vertices, corners, faces }];
        let map = sew.vertex_map.iter().copied();
        let kept = repaired.kept_elements(counts, map, Some(&sew.face_origin), |_| false, &job.sub_job(0.0, 0.7))?;
        let new = sew.new_vertices.iter().map(|&([a, b], at)| ([a, b, b], [1.0 - at, at, 0.0]));
        Origins::new(&sew.mesh, kept, new, &job.sub_job(0.7, 1.0))
    }

    /// The origins of a repaired mesh.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_repaired(done: &Repaired, job: &Job<'_>) -> Result<Origins> {
        let history = &done.history;
        let counts = |&[vertices, corners, faces]: &[usize; 3]| Counts { vertices, corners, faces };
        let is_old = |&&origin: &&u32| origin != NONE;
        let [old_vertices, old_faces] =
            [&done.vertex_origin, &done.face_origin].map(|origins| origins.iter().take_while(is_old).count());
        let mut corner_sources = SourceTable::with_capacity(history.corners.len(), history.corners.len())?;
        for (k, place) in history.corners.iter().enumerate() {
            job.sub_job(0.0, 0.2).step_within_list(k, STAGE)?;
            let sources = place.corners.into_iter().zip(place.weights);
            corner_sources.push(sources.filter(|&(corner, _)| corner != NONE))?;
        }
        let of_old = |origins: &[u32], count: usize, job: &Job<'_>| {
            SourceTable::from_single_sources(origins[..count].iter().copied(), job)
        };
        let kept = KeptElements {
            inputs: alloc::collect(history.inputs.iter().map(counts))?,
            vertices: {
                let mut vertices = of_old(&done.vertex_origin, old_vertices, &job.sub_job(0.2, 0.3))?;
                for &(sources, weights) in &history.placed {
                    vertices.push(sources.into_iter().zip(weights))?;
                }
                vertices
            },
            corners: corner_sources,
            faces: of_old(&done.face_origin, old_faces, &job.sub_job(0.3, 0.4))?,
        };
        let new = history.parents.iter().copied().zip(history.weights.iter().copied());
        let is_turned = |f: usize| f < old_faces && done.turned[f];
        Origins::new(&done.mesh, kept, new, &job.sub_job(0.4, 0.9))?.with_turned_faces(
            &done.mesh,
            is_turned,
            &job.sub_job(0.9, 1.0),
        )
    }

    /// Returns the sources of each vertex, corner and face of an assembly in the input pieces.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_assembly(assembly: &Assembly, job: &Job<'_>) -> Result<Origins> {
        let (mesh, history) = (&assembly.mesh, &assembly.history);
        let repaired = RepairedMesh {
            mesh,
            old_face_count: assembly.turned.len(),
            new_vertex_count: history.parents.len(),
            corner_origins: history.corner_origins.as_ref().map(corner_origin_parts),
        };
        let counts = assembly.maps.iter().zip(&history.corner_counts);
        let counts = alloc::collect(counts.map(|(map, &corners)| Counts {
            vertices: map.vertices.len(),
            corners,
            faces: map.faces.len(),
        }))?;
        let mut map = alloc::with_capacity(counts.iter().map(|counts| counts.vertices).sum())?;
        assembly.maps.iter().for_each(|piece| map.extend_from_slice(&piece.vertices));
        let is_turned = |f: usize| assembly.turned.get(f) == Some(&true);
        let origin = history.face_origin.as_deref();
        let kept = repaired.kept_elements(counts, map.into_iter(), origin, is_turned, &job.sub_job(0.0, 0.3))?;
        let new = history.parents.iter().copied().zip(history.weights.iter().copied());
        Origins::new(mesh, kept, new, &job.sub_job(0.3, 0.9))?.with_turned_faces(
            mesh,
            is_turned,
            &job.sub_job(0.9, 1.0),
        )
    }

    /// The origins of a mesh whose faces were split into triangles.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_triangulated(split: &TriangulatedMesh, job: &Job<'_>) -> Result<Origins> {
        let (vertices, triangles) = (split.mesh.positions.len(), split.faces.len());
        let faces = split.faces.last().map_or(0, |&face| face as usize + 1);
        // A face of n corners has n - 2 triangles.
        let counts = Counts { vertices, corners: triangles + 2 * faces, faces };
        Origins::from_kept(KeptElements {
            inputs: vec![counts],
            vertices: SourceTable::from_single_sources(0..vertices as u32, &job.sub_job(0.0, 0.3))?,
            corners: SourceTable::from_single_sources(split.corners.iter().copied(), &job.sub_job(0.3, 0.8))?,
            faces: SourceTable::from_single_sources(split.faces.iter().copied(), &job.sub_job(0.8, 1.0))?,
        })
    }

    /// The origins of the remains of trimmed pieces. The pieces are the inputs.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_trimmed(inputs: &[MeshView<'_>], remains: &TrimmedPieces, job: &Job<'_>) -> Result<Origins> {
        let inputs = alloc::collect(inputs.iter().map(Counts::from_mesh))?;
        let (count, map) = (remains.mesh.positions.len(), remains.vertex_map.iter().copied());
        Origins::from_kept(KeptElements {
            inputs,
            vertices: SourceTable::from_map(count, map, &job.sub_job(0.0, 0.3))?,
            corners: SourceTable::from_single_sources(remains.corners.iter().copied(), &job.sub_job(0.3, 0.8))?,
            faces: SourceTable::from_single_sources(remains.faces.iter().copied(), &job.sub_job(0.8, 1.0))?,
        })
    }
}

/// Old corners, and old corners on edges.
type RepairedCorners<'a> = (&'a [u32], &'a [CornerOnEdge]);

fn corner_origin_parts(origins: &CornerOrigins) -> RepairedCorners<'_> {
    (&origins.corners, &origins.on_edges)
}

/// A repaired mesh, before it received new faces.
struct RepairedMesh<'a> {
    mesh: &'a Mesh,
    /// The number of faces that are old ones, or parts of old ones.
    old_face_count: usize,
    /// The number of new vertices, which are the last ones.
    new_vertex_count: usize,
    /// The origins of corners; `None` if all corners remain.
    corner_origins: Option<RepairedCorners<'a>>,
}

impl RepairedMesh<'_> {
    /// The old elements. `map` holds the vertex that each old one became, `face_origin` the old
    /// face of each face. Faces `is_turned` run in the opposite direction now.
    fn kept_elements(
        &self,
        inputs: Vec<Counts>,
        map: impl ExactSizeIterator<Item = u32> + Clone,
        face_origin: Option<&[u32]>,
        is_turned: impl Fn(usize) -> bool,
        job: &Job<'_>,
    ) -> Result<KeptElements> {
        let vertices =
            SourceTable::from_map(self.mesh.positions.len() - self.new_vertex_count, map, &job.sub_job(0.0, 0.4))?;
        let count = self.mesh.face_offsets[self.old_face_count] as usize;
        let mut corners = SourceTable::with_capacity(count, count)?;
        for f in 0..self.old_face_count {
            job.step_within_list(f, STAGE)?;
            for corner in corners_before_turning(self.mesh, f, is_turned(f)) {
                corners.push(self.sources_of_corner(corner))?;
            }
        }
        let faces = self.old_face_count as u32;
        let faces = match face_origin {
            Some(origin) => SourceTable::from_single_sources(origin.iter().copied(), &job.sub_job(0.8, 1.0))?,
            None => SourceTable::from_single_sources(0..faces, &job.sub_job(0.8, 1.0))?,
        };
        Ok(KeptElements { inputs, vertices, corners, faces })
    }

    /// The old corners whose values a corner takes.
    fn sources_of_corner(&self, corner: u32) -> impl Iterator<Item = (u32, f64)> {
        let Some((corners, on_edges)) = self.corner_origins else {
            return [(corner, 1.0), (corner, 0.0)].into_iter();
        };
        let start = corners[corner as usize];
        match on_edges.binary_search_by_key(&corner, |on| on.corner) {
            Ok(k) => [(start, 1.0 - on_edges[k].edge_parameter), (on_edges[k].end_corner, on_edges[k].edge_parameter)]
                .into_iter(),
            Err(_) => [(start, 1.0), (start, 0.0)].into_iter(),
        }
    }
}
