//! Origins of results that keep all faces of their inputs: stitched, filled and oriented meshes,
//! and meshes side by side. Also of strips.

use super::domain::Counts;
use super::origins::{KeptElements, Origins};
use super::table::{STAGE, SourceTable};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_mesh::section::Sections;
use gusset_mesh::{Mesh, MeshView};
use gusset_stitch::develop::Developed;
use gusset_stitch::fill::Filled;
use gusset_stitch::repair::orient::Oriented;
use gusset_stitch::stitch::{Ruled, Stitch};

impl Origins {
    /// The origins of a stitched mesh.
    ///
    /// # Errors
    /// [`Error::TooLarge`](gusset_base::Error::TooLarge),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn from_stitch(stitch: &Stitch, job: &Job<'_>) -> Result<Origins> {
        let mesh = &stitch.mesh;
        let (mut first_face, mut first_corner) = (0, 0);
        let mut inputs = Vec::new();
        for map in stitch.maps.iter().filter(|map| !map.faces.is_empty()) {
            first_face += map.faces.len();
            let end = mesh.face_offsets[first_face] as usize;
            let (vertices, corners, faces) = (map.vertices.len(), end - first_corner, map.faces.len());
            alloc::push(&mut inputs, Counts { vertices, corners, faces })?;
            first_corner = end;
        }
        let mut turned = face_bit_set(mesh, &stitch.turned_outwards)?;
        stitch.turned_faces.iter().for_each(|&f| turned.toggle(f));
        let is_turned = |f: usize| turned.contains(f as u32);
        let old = mesh.positions.len() - stitch.parents.len();
        let part = job.sub_job(0.0, 0.3);
        let vertices = |job: &Job<'_>| vertices_of_stitch(stitch, old, job);
        let kept = collect_kept_elements(mesh, inputs, vertices, first_face, is_turned, &part)?;
        let parents = stitch.parents.iter().copied().zip(stitch.weights.iter().copied());
        Origins::new(mesh, kept, parents, &job.sub_job(0.3, 0.9))?.with_turned_faces(
            mesh,
            |f| f < first_face && is_turned(f),
            &job.sub_job(0.9, 1.0),
        )
    }

    /// The origins of a mesh whose holes were filled.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_filled(filled: &Filled, job: &Job<'_>) -> Result<Origins> {
        let mesh = &filled.mesh;
        let new_faces = filled.holes.iter().map(|hole| hole.faces.start as usize).min();
        let old_faces = new_faces.unwrap_or(mesh.face_count());
        let old = mesh.positions.len() - filled.parents.len();
        let turned = face_bit_set(mesh, &filled.turned_outwards)?;
        let is_turned = |f: usize| turned.contains(f as u32);
        let counts = Counts { vertices: old, corners: mesh.face_offsets[old_faces] as usize, faces: old_faces };
        let vertices = |job: &Job<'_>| SourceTable::from_single_sources(0..old as u32, job);
        let kept = collect_kept_elements(mesh, vec![counts], vertices, old_faces, is_turned, &job.sub_job(0.0, 0.3))?;
        let parents = filled.parents.iter().copied().zip(filled.weights.iter().copied());
        Origins::new(mesh, kept, parents, &job.sub_job(0.3, 0.9))?.with_turned_faces(
            mesh,
            |f| f < old_faces && is_turned(f),
            &job.sub_job(0.9, 1.0),
        )
    }

    /// The origins of an oriented mesh.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_oriented(oriented: &Oriented, job: &Job<'_>) -> Result<Origins> {
        let (mesh, is_turned) = (&oriented.mesh, |f: usize| oriented.turned[f]);
        let (vertices, corners, faces) = (mesh.positions.len(), mesh.face_corners.len(), mesh.face_count());
        let counts = Counts { vertices, corners, faces };
        let vertices = |job: &Job<'_>| SourceTable::from_single_sources(0..counts.vertices as u32, job);
        let kept = collect_kept_elements(mesh, vec![counts], vertices, faces, is_turned, &job.sub_job(0.0, 0.7))?;
        Origins::from_kept(kept)?.with_turned_faces(mesh, is_turned, &job.sub_job(0.7, 1.0))
    }

    /// The origins of a developed mesh.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_developed(done: &Developed, job: &Job<'_>) -> Result<Origins> {
        let (corners, faces) = (done.mesh.face_corners.len(), done.mesh.face_count());
        Origins::from_kept(KeptElements {
            inputs: vec![Counts { vertices: done.old_vertices, corners, faces }],
            vertices: SourceTable::from_single_sources(done.vertex_map.iter().copied(), &job.sub_job(0.0, 0.3))?,
            corners: SourceTable::from_single_sources(0..corners as u32, &job.sub_job(0.3, 0.7))?,
            faces: SourceTable::from_single_sources(0..faces as u32, &job.sub_job(0.7, 1.0))?,
        })
    }

    /// The origins of a mesh with the vertices and faces of the first input, whose vertices were
    /// moved.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_moved(inputs: &[MeshView<'_>], job: &Job<'_>) -> Result<Origins> {
        let inputs = alloc::collect(inputs.iter().map(Counts::from_mesh))?;
        let first = inputs.first().copied().unwrap_or_default();
        origins_of_first_elements(inputs, first, job)
    }

    /// The origins of a mesh with the vertices and faces of all inputs side by side, whose vertices
    /// may have been moved.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_side_by_side(inputs: &[MeshView<'_>], job: &Job<'_>) -> Result<Origins> {
        let inputs = alloc::collect(inputs.iter().map(Counts::from_mesh))?;
        let sum = |of: fn(&Counts) -> usize| inputs.iter().map(of).sum();
        let all = Counts { vertices: sum(|c| c.vertices), corners: sum(|c| c.corners), faces: sum(|c| c.faces) };
        origins_of_first_elements(inputs, all, job)
    }

    /// The origins of a strip between two polylines. The inputs are the points of the polylines.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_ruled(ruled: &Ruled, job: &Job<'_>) -> Result<Origins> {
        let [n, m] = ruled.counts;
        let points = |count: u32| Counts { vertices: count as usize, ..Counts::default() };
        let inputs = vec![points(n), points(m)];
        let vertices = SourceTable::from_single_sources(0..n + m, &job.sub_job(0.0, 0.1))?;
        let none = || SourceTable::with_capacity(0, 0);
        let kept = KeptElements { inputs, vertices, corners: none()?, faces: none()? };
        let parents = ruled.parents.iter().zip(&ruled.weights);
        let parents = parents.map(|(&[a, b], &weight)| ([a, b, b], [1.0 - weight, weight, 0.0]));
        Origins::new(&ruled.mesh, kept, parents, &job.sub_job(0.1, 1.0))
    }

    /// The origins of the sections of a mesh with these counts. The vertices of the result are the
    /// points, its faces the segments after the points; it has no corners.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_sections(sections: &Sections, counts: Counts, job: &Job<'_>) -> Result<Origins> {
        let points = sections.points().len();
        let mut vertices = SourceTable::with_capacity(points, 2 * points)?;
        job.sub_job(0.0, 0.6).work_in_ranges(STAGE, points, |range| {
            range.clone().try_for_each(|k| {
                let ([a, b], t) = (sections.edges()[k], sections.parameters()[k]);
                vertices.push([(a, 1.0 - t), (b, t)])
            })
        })?;
        Origins::from_kept(KeptElements {
            inputs: vec![counts],
            vertices,
            corners: SourceTable::with_capacity(0, 0)?,
            faces: SourceTable::from_single_sources(sections.faces().iter().copied(), &job.sub_job(0.6, 1.0))?,
        })
    }
}

/// The origins of a result whose elements are the first `count` elements of the inputs, in order.
fn origins_of_first_elements(inputs: Vec<Counts>, count: Counts, job: &Job<'_>) -> Result<Origins> {
    Origins::from_kept(KeptElements {
        inputs,
        vertices: SourceTable::from_single_sources(0..count.vertices as u32, &job.sub_job(0.0, 0.2))?,
        corners: SourceTable::from_single_sources(0..count.corners as u32, &job.sub_job(0.2, 0.8))?,
        faces: SourceTable::from_single_sources(0..count.faces as u32, &job.sub_job(0.8, 1.0))?,
    })
}

/// The set of the given faces of a mesh.
fn face_bit_set(mesh: &Mesh, given: &[u32]) -> Result<BitSet> {
    let mut set = BitSet::new(mesh.face_count())?;
    given.iter().for_each(|&f| set.insert(f));
    Ok(set)
}

/// The sources of the `old` vertices of a stitched mesh. A vertex that stitching merged has two.
fn vertices_of_stitch(stitch: &Stitch, old: usize, job: &Job<'_>) -> Result<SourceTable> {
    let [a, b] = stitch.maps.each_ref().map(|map| map.vertices.as_slice());
    if a.len() + b.len() == old {
        return SourceTable::from_single_sources(0..old as u32, job);
    }
    let mut map = alloc::copied(a)?;
    alloc::append(&mut map, b)?;
    SourceTable::from_map(old, map.into_iter(), job)
}

/// The old elements of a result that begins with the faces of its inputs, in order. `vertices`
/// returns the sources of its old vertices.
fn collect_kept_elements(
    mesh: &Mesh,
    inputs: Vec<Counts>,
    vertices: impl FnOnce(&Job<'_>) -> Result<SourceTable>,
    faces: usize,
    is_turned: impl Fn(usize) -> bool,
    job: &Job<'_>,
) -> Result<KeptElements> {
    let mut corners = alloc::with_capacity(mesh.face_offsets[faces] as usize)?;
    for f in 0..faces {
        job.step_within_list(f, STAGE)?;
        corners.extend(corners_before_turning(mesh, f, is_turned(f)));
    }
    Ok(KeptElements {
        inputs,
        vertices: vertices(&job.sub_job(0.2, 0.4))?,
        corners: SourceTable::from_single_sources(corners.into_iter(), &job.sub_job(0.4, 0.8))?,
        faces: SourceTable::from_single_sources(0..faces as u32, &job.sub_job(0.8, 1.0))?,
    })
}

/// The positions of a face's corners before it was turned over, if it was. The first corner keeps
/// its position.
pub(super) fn corners_before_turning(mesh: &Mesh, f: usize, turned: bool) -> impl Iterator<Item = u32> {
    let [first, end] = [f, f + 1].map(|k| mesh.face_offsets[k]);
    (first..end).map(move |corner| if turned && corner > first { end - (corner - first) } else { corner })
}
