//! Writer of PLY files.

use super::ply_layout::{Colours, FaceLayout, VertexLayout, property_name};
use super::row_writer::RowWriter;
use crate::document::Document;
use crate::error::{Loss, WriteError};
use crate::merging::merge_vertices;
use crate::mesh::{NumberKind, Positions, Property};
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::row_blocks::write_rows;
use crate::scene::colour_step;
use crate::text::TextWriter;
use std::io;

/// Writes the meshes of the scene as one, or the points if the scene has no vertices.
pub(crate) fn write_ply(
    document: &Document,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let joined = document.joined()?;
    let merged = merge_vertices(&joined)?;
    let has_mesh = !merged.mesh.positions.is_empty();
    let mut losses = Losses(Vec::new());
    if has_mesh {
        let vertices = VertexLayout::from_mesh(&merged.mesh)?;
        let faces = FaceLayout::new(&merged.mesh, &vertices, document)?;
        let normals = "normals that differ at the corners of a vertex: PLY files hold one for each vertex";
        losses.add_if(!merged.mesh.normals.is_absent() && vertices.normals.is_none(), normals);
        losses.add_colours(&[&vertices.colours, &faces.colours]);
        let colours = "colours that differ at a split vertex: PLY files hold one for each vertex";
        losses.add_if(merged.loses_colours, colours);
        for name in &merged.lost_properties {
            let text = format!("values of {name} that differ at a split vertex: PLY files hold one for each vertex");
            losses.add_if(true, &text);
        }
        losses.add_if(faces.textures.loses_materials, "materials, which PLY files do not hold");
        write_file(&vertices, Some(&faces), target, options)?;
    } else {
        let vertices = VertexLayout::from_points(&document.points);
        losses.add_colours(&[&vertices.colours]);
        write_file(&vertices, None, target, options)?;
    }
    let points = "points beside a mesh, which PLY files do not hold";
    losses.add_if(has_mesh && !document.points.positions.is_empty(), points);
    losses.add_if(!document.curves.closed.is_empty(), "curves, which PLY files do not hold");
    let has_names = document.placements.iter().any(|placement| !placement.name.is_empty());
    losses.add_if(document.placements.len() > 1 && has_names, "names of objects, which PLY files do not hold");
    Ok(losses.0)
}

struct Losses(Vec<Loss>);

impl Losses {
    fn add_if(&mut self, is_lost: bool, text: &str) {
        if is_lost {
            self.0.push(Loss(text.into()));
        }
    }

    fn add_colours(&mut self, colours: &[&Colours<'_>]) {
        self.add_if(colours.iter().any(|colours| colours.is_rounded()), "shades of colours between 256 steps");
    }
}

fn write_file(
    vertices: &VertexLayout<'_>,
    faces: Option<&FaceLayout<'_>>,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> io::Result<()> {
    if !options.text {
        const HEADER_ROOM: usize = 4096;
        let corners = faces.map_or(0, |faces| faces.mesh.face_count() + 4 * faces.mesh.corners.len());
        target.main_file.reserve_in_place(HEADER_ROOM + 12 * vertices.positions.len() + corners)?;
    }
    let mut out = TextWriter::new(target.main_file)?;
    out.text("ply\nformat ")?;
    out.text(if options.text { "ascii" } else { "binary_little_endian" })?;
    out.text(" 1.0\ncomment gusset\n")?;
    for name in faces.map_or(&[][..], |faces| &faces.textures.names) {
        out.text(&format!("comment TextureFile {}\n", target.resources.written_name(name)))?;
    }
    announce_vertices(&mut out, vertices)?;
    if let Some(faces) = faces {
        announce_faces(&mut out, faces)?;
    }
    out.text("end_header\n")?;
    out.finish()?;
    match vertices.positions {
        Positions::F32(points) if !options.text && vertices.has_positions_only() => {
            write_rows(target.main_file, points.len(), |point| {
                let mut row = [0; 12];
                row.copy_from_slice(points[point].map(f32::to_le_bytes).as_flattened());
                row
            })?;
        }
        _ => {
            let mut rows = RowWriter::new(TextWriter::new(target.main_file)?, options.text);
            (0..vertices.positions.len()).try_for_each(|vertex| write_vertex(&mut rows, vertices, vertex))?;
            rows.out.finish()?;
        }
    }
    let Some(faces) = faces else { return Ok(()) };
    match faces.mesh.triangles() {
        Some(triangles) if !options.text && faces.has_corners_only() => {
            write_rows(target.main_file, triangles.len(), |triangle| triangle_bytes(triangles[triangle]))?;
            target.main_file.flush()
        }
        _ => {
            let mut rows = RowWriter::new(TextWriter::new(target.main_file)?, options.text);
            (0..faces.mesh.face_count()).try_for_each(|face| write_face(&mut rows, faces, face))?;
            rows.out.finish()
        }
    }
}

/// Returns a triangle as a list with a length of one byte.
fn triangle_bytes(vertices: [u32; 3]) -> [u8; 13] {
    let mut row = [3; 13];
    row[1..].copy_from_slice(vertices.map(u32::to_le_bytes).as_flattened());
    row
}

fn announce_vertices(out: &mut TextWriter<'_>, vertices: &VertexLayout<'_>) -> io::Result<()> {
    out.text(&format!("element vertex {}\n", vertices.positions.len()))?;
    announce(out, real_type(vertices.is_single), &["x", "y", "z"])?;
    if let Some(normals) = &vertices.normals {
        announce(out, real_type(normals.is_single), &["nx", "ny", "nz"])?;
    }
    announce_colours(out, &vertices.colours)?;
    if let Some(texcoords) = &vertices.texcoords {
        announce(out, real_type(texcoords.is_single), &["s", "t"])?;
    }
    announce_properties(out, &vertices.properties)
}

fn announce_faces(out: &mut TextWriter<'_>, faces: &FaceLayout<'_>) -> io::Result<()> {
    let length = if faces.has_short_lists { "uchar" } else { "uint" };
    let index = if i32::try_from(faces.mesh.positions.len()).is_ok() { "int" } else { "uint" };
    out.text(&format!("element face {}\n", faces.mesh.face_count()))?;
    out.text(&format!("property list {length} {index} vertex_indices\n"))?;
    announce_colours(out, &faces.colours)?;
    if let Some(texcoords) = &faces.texcoords {
        out.text(&format!("property list {length} {} texcoord\n", real_type(texcoords.is_single)))?;
    }
    if faces.textures.has_numbers {
        announce(out, "int", &["texnumber"])?;
    }
    announce_properties(out, &faces.properties)
}

fn real_type(is_single: bool) -> &'static str {
    if is_single { "float" } else { "double" }
}

fn announce(out: &mut TextWriter<'_>, kind: &str, names: &[&str]) -> io::Result<()> {
    names.iter().try_for_each(|name| out.text(&format!("property {kind} {name}\n")))
}

fn announce_colours(out: &mut TextWriter<'_>, colours: &Colours<'_>) -> io::Result<()> {
    match (colours.values.is_empty(), colours.is_opaque) {
        (true, _) => Ok(()),
        (false, true) => announce(out, "uchar", &["red", "green", "blue"]),
        (false, false) => announce(out, "uchar", &["red", "green", "blue", "alpha"]),
    }
}

fn announce_properties(out: &mut TextWriter<'_>, properties: &[&Property]) -> io::Result<()> {
    for property in properties {
        let kind = match property.kind {
            NumberKind::I8 => "char",
            NumberKind::U8 => "uchar",
            NumberKind::I16 => "short",
            NumberKind::U16 => "ushort",
            NumberKind::I32 => "int",
            NumberKind::U32 => "uint",
            NumberKind::F32 => "float",
            NumberKind::F64 => "double",
        };
        announce(out, kind, &[&property_name(&property.name)])?;
    }
    Ok(())
}

fn write_vertex(rows: &mut RowWriter<'_>, vertices: &VertexLayout<'_>, vertex: usize) -> io::Result<()> {
    match vertices.positions {
        Positions::F32(points) => points[vertex].iter().try_for_each(|&x| rows.real(f64::from(x), true))?,
        Positions::F64(points) => points[vertex].iter().try_for_each(|&x| rows.real(x, vertices.is_single))?,
    }
    if let Some(normals) = &vertices.normals {
        normals.values[vertex].iter().try_for_each(|&x| rows.present(x, normals.is_single))?;
    }
    write_colour(rows, &vertices.colours, vertex)?;
    if let Some(texcoords) = &vertices.texcoords {
        texcoords.values[vertex].iter().try_for_each(|&x| rows.present(x, texcoords.is_single))?;
    }
    write_properties(rows, &vertices.properties, vertex)?;
    rows.end_row()
}

fn write_face(rows: &mut RowWriter<'_>, faces: &FaceLayout<'_>, face: usize) -> io::Result<()> {
    let range = faces.mesh.face_range(face);
    rows.length(range.len(), faces.has_short_lists)?;
    faces.mesh.corners[range.clone()].iter().try_for_each(|&vertex| rows.index(vertex))?;
    write_colour(rows, &faces.colours, face)?;
    if let Some(texcoords) = &faces.texcoords {
        // A face has all of them or none.
        let all = &texcoords.values[range];
        let all = if all.iter().any(|pair| pair[0].is_nan()) { &[] } else { all };
        rows.length(2 * all.len(), faces.has_short_lists)?;
        all.iter().flatten().try_for_each(|&x| rows.real(x, texcoords.is_single))?;
    }
    if faces.textures.has_numbers {
        let number = faces.mesh.face_materials.get(face).map_or(-1, |&material| faces.textures.number(material));
        rows.integer(i64::from(number), 4)?;
    }
    write_properties(rows, &faces.properties, face)?;
    rows.end_row()
}

fn write_colour(rows: &mut RowWriter<'_>, colours: &Colours<'_>, index: usize) -> io::Result<()> {
    let Some(colour) = colours.values.get(index) else { return Ok(()) };
    let parts = if colours.is_opaque { &colour[..3] } else { colour };
    parts.iter().try_for_each(|&part| rows.byte(colour_step(part)))
}

fn write_properties(rows: &mut RowWriter<'_>, properties: &[&Property], index: usize) -> io::Result<()> {
    properties.iter().try_for_each(|property| rows.number(property.values[index], property.kind))
}
