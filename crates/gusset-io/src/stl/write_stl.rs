//! STL files from meshes.

use super::stl_parts::{FACET_BYTES, FACETS_START, HEADER_BYTES};
use crate::document::Document;
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::mesh::{Mesh, Positions};
use crate::options::WriteOptions;
use crate::polygons::triangulate_face;
use crate::precision::check_rounding;
use crate::repeated_points::count_repeated_points;
use crate::resources::Target;
use crate::row_blocks::write_rows;
use crate::scene::{counted, list_lost_content, scene_mesh};
use crate::text::TextWriter;
use gusset_base::alloc;
use std::borrow::Cow;

/// Name of a solid whose mesh has none, and header of binary files.
const DEFAULT_NAME: &str = "gusset";

pub(crate) fn write_stl(
    document: &Document,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let mesh = scene_mesh(document)?;
    let mut losses = list_lost_content(document, &mesh, "STL", &[]);
    let (mut polygons, mut left_out) = (0, 0);
    for face in 0..mesh.face_count() {
        let corners = mesh.face_range(face).len();
        polygons += usize::from(corners > 3);
        left_out += usize::from(corners < 3);
    }
    if polygons > 0 {
        let faces = counted(polygons, "face", "faces");
        losses.push(Loss(format!("{faces} of more than three corners: cut into triangles")));
    }
    if left_out > 0 {
        losses.push(Loss(format!("{} of fewer than three corners", counted(left_out, "face", "faces"))));
    }
    if options.text {
        write_text(&mesh, target)?;
    } else {
        let remedy = "write the STL file as text, or permit the loss";
        let largest = check_rounding(&mesh, [0.0; 3], options.lossy, remedy)?;
        if largest > 0.0 {
            losses.push(Loss(format!("positions rounded to single precision, by up to {largest:.1e}")));
        }
        write_binary(&mesh, target)?;
    }
    list_lost_vertices(&mesh, options.text, &mut losses)?;
    Ok(losses)
}

/// Returns the vertices of all triangles.
fn all_triangles(mesh: &Mesh) -> Result<Cow<'_, [[u32; 3]]>, WriteError> {
    if let Some(triangles) = mesh.triangles() {
        return Ok(Cow::Borrowed(triangles));
    }
    let (mut all, mut places) = (alloc::with_capacity(mesh.corners.len() / 2)?, Vec::new());
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        if let &[a, b, c] = vertices {
            alloc::push(&mut all, [a, b, c])?;
            continue;
        }
        triangulate_face(mesh, face, &mut places)?;
        alloc::extend(&mut all, places.iter().map(|places| places.map(|place| vertices[place as usize])))?;
    }
    Ok(Cow::Owned(all))
}

fn write_binary(mesh: &Mesh, target: &mut Target<'_>) -> Result<(), WriteError> {
    let triangles = all_triangles(mesh)?;
    let Ok(count) = u32::try_from(triangles.len()) else {
        let message = format!("{} triangles are more than 2^32 - 1", triangles.len());
        return Err(WriteError::new(WriteErrorKind::Unsupported, message));
    };
    target.main_file.reserve_in_place(FACETS_START + FACET_BYTES * triangles.len())?;
    let mut head = [b' '; FACETS_START];
    head[..DEFAULT_NAME.len()].copy_from_slice(DEFAULT_NAME.as_bytes());
    head[HEADER_BYTES..].copy_from_slice(&count.to_le_bytes());
    target.main_file.write_all(&head)?;
    match &mesh.positions {
        Positions::F32(points) => {
            let facet =
                |index: usize| facet_bytes(triangles[index].map(|vertex: u32| points[vertex as usize].map(f64::from)));
            write_rows(target.main_file, triangles.len(), facet)?;
        }
        Positions::F64(points) => {
            let facet = |index: usize| facet_bytes(triangles[index].map(|vertex: u32| points[vertex as usize]));
            write_rows(target.main_file, triangles.len(), facet)?;
        }
    }
    Ok(target.main_file.flush()?)
}

/// Returns the normal and the corners of a triangle as a facet without attributes.
fn facet_bytes(corners: [[f64; 3]; 3]) -> [u8; FACET_BYTES] {
    let mut facet = [0; FACET_BYTES];
    let vectors = [unit_normal(corners), corners[0], corners[1], corners[2]];
    for (bytes, part) in facet.as_chunks_mut::<4>().0.iter_mut().zip(vectors.as_flattened()) {
        *bytes = (*part as f32).to_le_bytes();
    }
    facet
}

fn write_text(mesh: &Mesh, target: &mut Target<'_>) -> Result<(), WriteError> {
    let is_single = matches!(mesh.positions, Positions::F32(_));
    let name =
        if mesh.name.trim().is_empty() { DEFAULT_NAME.into() } else { crate::error::printable(mesh.name.trim()) };
    let mut out = TextWriter::new(target.main_file)?;
    out.text("solid ")?;
    out.text(&name)?;
    for triangle in &*all_triangles(mesh)? {
        let corners = triangle.map(|vertex| mesh.positions.get(vertex as usize));
        out.text("\nfacet normal")?;
        for part in unit_normal(corners) {
            out.text(" ")?;
            out.single(part as f32)?;
        }
        out.text("\nouter loop")?;
        for corner in corners {
            out.text("\nvertex")?;
            for coordinate in corner {
                out.text(" ")?;
                if is_single { out.single(coordinate as f32)? } else { out.double(coordinate)? }
            }
        }
        out.text("\nendloop\nendfacet")?;
    }
    out.text("\nendsolid ")?;
    out.text(&name)?;
    out.text("\n")?;
    Ok(out.finish()?)
}

/// Returns the normal of a triangle with length 1, or 0 if the triangle has no area.
fn unit_normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [b, c].map(|end| [end[0] - a[0], end[1] - a[1], end[2] - a[2]]);
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
    // The sum adds 0 so that no part is -0. One division takes less time than three.
    let scale = 1.0 / length;
    if scale > 0.0 && scale.is_finite() { normal.map(|part| part * scale + 0.0) } else { [0.0; 3] }
}

/// Adds vertices that no face uses, and vertices that will be merged with others at their positions.
fn list_lost_vertices(mesh: &Mesh, text: bool, losses: &mut Vec<Loss>) -> Result<(), WriteError> {
    let count = mesh.positions.len();
    let mut is_used = Vec::new();
    is_used.try_reserve_exact(count)?;
    is_used.resize(count, false);
    for &vertex in &mesh.corners {
        is_used[vertex as usize] = true;
    }
    let unused = is_used.iter().filter(|&&used| !used).count();
    if unused > 0 {
        losses.push(Loss(format!("{} that no face uses", counted(unused, "vertex", "vertices"))));
    }
    // Vertices that the mesh itself merges count once.
    for vertex in 0..mesh.merge.len() {
        let representative = mesh.merge[vertex] as usize;
        if is_used[vertex] && representative != vertex {
            is_used[vertex] = false;
            is_used[representative] = true;
        }
    }
    let equal = match &mesh.positions {
        Positions::F64(points) if text => {
            count_repeated_points(count, |vertex| is_used[vertex].then(|| points[vertex]))
        }
        Positions::F64(points) => {
            count_repeated_points(count, |vertex| is_used[vertex].then(|| points[vertex].map(|part| part as f32)))
        }
        Positions::F32(points) => count_repeated_points(count, |vertex| is_used[vertex].then(|| points[vertex])),
    }?;
    if equal > 0 {
        let vertices = counted(equal, "vertex", "vertices");
        losses.push(Loss(format!("the difference between {vertices} and others at the same positions")));
    }
    Ok(())
}
