//! OFF files from meshes and points.

use crate::colour_steps::{are_colours_exact_as_bytes, has_transparency, nearest_step};
use crate::document::{Document, PointCloud};
use crate::error::{Loss, WriteError};
use crate::merging::merge_vertices;
use crate::mesh::{Mesh, Positions, Values};
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::scene::{Attribute, list_lost_content, scene_mesh};
use crate::text::TextWriter;
use gusset_base::alloc;

pub(crate) fn write_off(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let scene = scene_mesh(document)?;
    let merged = merge_vertices(&scene)?;
    let held = [Attribute::VertexColours, Attribute::FaceColours, Attribute::Normals, Attribute::Texcoords];
    let mut losses = list_lost_content(document, &scene, "OFF", &held);
    let mesh = &*merged.mesh;
    for (is_lost, text) in [
        (
            matches!(mesh.normals, Values::Corners(_)),
            "normals that differ at the corners of a vertex: OFF files hold one for each vertex",
        ),
        (
            matches!(mesh.texcoords, Values::Corners(_)),
            "texture coordinates that differ at the corners of a vertex: OFF files hold one pair for each vertex",
        ),
        (merged.loses_colours, "colours that differ at a split vertex: OFF files hold one for each vertex"),
    ] {
        if is_lost {
            losses.push(Loss(text.into()));
        }
    }
    let mut out = TextWriter::new(target.main_file)?;
    if mesh.positions.is_empty() && !document.points.positions.is_empty() {
        losses.retain(|Loss(text)| !text.starts_with("points beside"));
        write_mesh(&mesh_from_points(&document.points)?, &mut out)?;
    } else {
        write_mesh(mesh, &mut out)?;
    }
    out.finish()?;
    Ok(losses)
}

fn mesh_from_points(points: &PointCloud) -> Result<Mesh, WriteError> {
    let normals =
        if points.normals.is_empty() { Values::Absent } else { Values::Vertices(alloc::copied(&points.normals)?) };
    Ok(Mesh {
        positions: points.positions.try_clone()?,
        normals,
        vertex_colours: alloc::copied(&points.colours)?,
        ..Mesh::default()
    })
}

fn write_mesh(mesh: &Mesh, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    let normals = at_vertices(&mesh.normals);
    let texcoords = at_vertices(&mesh.texcoords);
    let colours = &mesh.vertex_colours[..];
    let prefix = [(texcoords.is_some(), "ST"), (!colours.is_empty(), "C"), (normals.is_some(), "N")];
    for (is_present, letters) in prefix {
        if is_present {
            out.text(letters)?;
        }
    }
    out.text("OFF\n")?;
    out.integer(mesh.positions.len() as u64)?;
    out.text(" ")?;
    out.integer(mesh.face_count() as u64)?;
    out.text(" 0\n")?;
    let are_colours_bytes = are_colours_exact_as_bytes(colours, true);
    for vertex in 0..mesh.positions.len() {
        write_position(&mesh.positions, vertex, out)?;
        if let Some(normals) = normals {
            write_vector(normals[vertex], out)?;
        }
        if let Some(&colour) = colours.get(vertex) {
            write_colour(colour, true, are_colours_bytes, out)?;
        }
        if let Some(texcoords) = texcoords {
            write_vector(texcoords[vertex], out)?;
        }
        out.text("\n")?;
    }
    write_faces(mesh, out)
}

fn at_vertices<const N: usize>(values: &Values<N>) -> Option<&[[f64; N]]> {
    if let Values::Vertices(values) = values { Some(values) } else { None }
}

fn write_position(positions: &Positions, vertex: usize, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    for axis in 0..3 {
        if axis > 0 {
            out.text(" ")?;
        }
        match positions {
            Positions::F32(points) => out.single(points[vertex][axis])?,
            Positions::F64(points) => out.double(points[vertex][axis])?,
        }
    }
    Ok(())
}

/// Writes a vector, or zeros if it is missing.
fn write_vector<const N: usize>(vector: [f64; N], out: &mut TextWriter<'_>) -> std::io::Result<()> {
    let is_missing = vector[0].is_nan();
    for value in vector {
        out.text(" ")?;
        out.attribute(if is_missing { 0.0 } else { value })?;
    }
    Ok(())
}

fn write_faces(mesh: &Mesh, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    let has_opacity = has_transparency(&mesh.face_colours);
    let are_colours_bytes = are_colours_exact_as_bytes(&mesh.face_colours, has_opacity);
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        out.integer(vertices.len() as u64)?;
        for &vertex in vertices {
            out.text(" ")?;
            out.integer(u64::from(vertex))?;
        }
        if let Some(&colour) = mesh.face_colours.get(face) {
            write_colour(colour, has_opacity, are_colours_bytes, out)?;
        }
        out.text("\n")?;
    }
    Ok(())
}

fn write_colour(colour: [f32; 4], has_opacity: bool, steps: bool, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    for part in &colour[..if has_opacity { 4 } else { 3 }] {
        out.text(" ")?;
        if steps { out.integer(u64::from(nearest_step(*part)))? } else { out.single(*part)? }
    }
    Ok(())
}
