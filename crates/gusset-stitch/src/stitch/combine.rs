//! Combination of the pieces and the strip into one mesh.
//!
//! The vertices of A come first, then the vertices of B, then the new vertices. The faces of A come
//! first, then the faces of B, then the strip. Positions keep their bits.

use super::stitch_request::IndexMap;
use super::strip::Strip;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, MeshView, check_size, concat};
use std::ops::Range;

/// Appends a piece. Turns over the faces that `turn` selects; each keeps its first corner.
pub(super) fn append_piece(
    whole: &mut Mesh,
    piece: &MeshView<'_>,
    job: &Job<'_>,
    turn: impl FnMut(usize) -> bool,
) -> Result<IndexMap> {
    let place = concat::append_piece(whole, piece, job, turn)?;
    Ok(IndexMap {
        vertices: alloc::collect((0..piece.positions().len()).map(|v| v as u32 + place.first_vertex))?,
        faces: alloc::collect((0..piece.faces().len()).map(|f| f as u32 + place.first_face))?,
    })
}

/// The place of a strip in the combined mesh.
pub(crate) struct AttachedStrip {
    /// The combined mesh's vertex for each strip vertex: both rims, then the new vertices.
    pub(crate) mesh_vertex_of_strip_vertex: Vec<u32>,
    /// The new vertices.
    pub(crate) vertices: Range<u32>,
    /// The strip's faces.
    pub(crate) faces: Range<u32>,
}

/// Appends a strip whose rim vertices are numbered as in `whole`. Multiplies its points by `unit`.
///
/// # Errors
/// [`TooLarge`](gusset_base::Error::TooLarge), [`OutOfMemory`](gusset_base::Error::OutOfMemory).
pub(crate) fn append_strip(whole: &mut Mesh, strip: &Strip, unit: f64) -> Result<AttachedStrip> {
    let (faces, new) = (&strip.faces, &strip.grid.points[strip.rim_count()..]);
    let (vertices, corners) = (whole.positions.len() + new.len(), whole.face_corners.len() + faces.corners.len());
    check_size(vertices as u64, corners as u64)?;
    let first_vertex = whole.positions.len() as u32;
    let mut names = alloc::with_capacity(strip.grid.points.len())?;
    names.extend(strip.a.vertices.iter().chain(&strip.b.vertices));
    names.extend(first_vertex..vertices as u32);
    whole.positions.extend(new.iter().map(|&p| p * unit))?;

    alloc::reserve(&mut whole.face_corners, faces.corners.len())?;
    alloc::reserve(&mut whole.face_offsets, faces.offsets.len())?;
    let first_face = whole.face_count() as u32;
    for face in faces.iter() {
        whole.face_corners.extend(face.iter().map(|&v| names[v as usize]));
        whole.face_offsets.push(whole.face_corners.len() as u32);
    }
    Ok(AttachedStrip {
        mesh_vertex_of_strip_vertex: names,
        vertices: first_vertex..vertices as u32,
        faces: first_face..whole.face_count() as u32,
    })
}

/// Returns the faces from `first_face` on as a separate mesh: the vertices of rim A in order, those
/// of rim B, and the vertices from `first_vertex` on. Faces name a common point by its place on A.
pub(super) fn strips_as_mesh(whole: &Mesh, [a, b]: [&Vec<u32>; 2], first_vertex: u32, first_face: u32) -> Result<Mesh> {
    let mut places = alloc::gather(a.iter().chain(b).copied().zip(0u32..))?;
    places.sort_unstable();
    places.dedup_by_key(|&mut (v, _)| v);
    let rims = (a.len() + b.len()) as u32;
    let place = |v: u32| match v.checked_sub(first_vertex) {
        Some(new) => rims + new,
        None => places.binary_search_by_key(&v, |&(v, _)| v).map_or(0, |at| places[at].1),
    };
    let start = whole.face_offsets[first_face as usize];
    let corners = alloc::collect(whole.face_corners[start as usize..].iter().map(|&v| place(v)))?;
    let offsets = alloc::collect(whole.face_offsets[first_face as usize..].iter().map(|offset| offset - start))?;
    let mut names = alloc::with_capacity(rims as usize + whole.positions.len() - first_vertex as usize)?;
    names.extend(a.iter().chain(b));
    names.extend(first_vertex..whole.positions.len() as u32);
    Ok(Mesh::new(whole.positions.select_vertices(&names)?, offsets, corners))
}

/// Returns the faces from `first` as a separate mesh, with the vertices that they use in ascending
/// order.
pub(crate) fn faces_as_mesh(whole: &Mesh, first: usize, job: &Job<'_>) -> Result<Mesh> {
    const STAGE: &str = "putting the pieces together";
    let start = whole.face_offsets[first];
    let corners = &whole.face_corners[start as usize..];
    let mut names = alloc::copied(corners)?;
    sort(&mut names, Ord::cmp, &job.sub_job(0.0, 0.5), STAGE)?;
    names.dedup();
    // Look up the corners in chunks, so that the host can cancel between them.
    let mut face_corners = alloc::with_capacity(corners.len())?;
    for part in corners.chunks(1 << 16) {
        job.step(0.5 + 0.5 * face_corners.len() as f64 / corners.len() as f64, STAGE)?;
        face_corners.extend(part.iter().map(|v| names.partition_point(|name| name < v) as u32));
    }
    let face_offsets = alloc::collect(whole.face_offsets[first..].iter().map(|offset| offset - start))?;
    Ok(Mesh::new(whole.positions.select_vertices(&names)?, face_offsets, face_corners))
}
