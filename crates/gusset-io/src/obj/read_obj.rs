//! OBJ files as documents.

use super::obj_assembly::{Content, read_content};
use super::obj_chunk::{Lists, Names, Omission, Tally};
use super::obj_materials::read_materials;
use super::obj_objects::{document_from_faces, is_split_by_objects};
use crate::document::{Curves, Document, PointCloud};
use crate::error::{Note, Place, ReadError, quoted};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::Positions;
use crate::options::ReadOptions;
use crate::resources::Resources;
use crate::text_encoding::decode_text;
use gusset_base::alloc;

/// Reads an OBJ file and its material libraries.
pub(crate) fn read_obj(bytes: &[u8], resources: &dyn Resources, _: &ReadOptions) -> Result<Document, ReadError> {
    let text = decode_text(bytes)?;
    let content = read_content(&text).map_err(|error| refuse_foreign_file(bytes).unwrap_or(error))?;
    if let Some(word) = content.unknown
        && !content.has_known
    {
        let line = content.omissions[Omission::Unknown as usize].first_line + 1;
        return Err(refuse_foreign_file(bytes).unwrap_or_else(|| refuse_foreign_text(word, line)));
    }
    document_from_content(content, resources)
}

pub(super) fn document_from_content(
    mut content: Content<'_>,
    resources: &dyn Resources,
) -> Result<Document, ReadError> {
    let mut notes = omission_notes(&content);
    let is_split = is_split_by_objects(&content)?;
    if (!is_split && content.objects.len() > 1) || content.groups == Names::Several {
        let what =
            if is_split { "groups: left out" } else { "objects and groups: left out; the file is read as one mesh" };
        notes.push(Note::new(Place::Whole, format!("names of {what}")));
    }
    scale_colours(&mut content.colours, &mut notes);
    let curves = curves_from_lists(&content.polylines, &content.positions)?;
    let face_count = content.face_offsets.len() - 1;
    let materials = read_materials(&content.materials, &content.libraries, face_count, resources)?;
    notes.extend(materials.notes);
    let is_cloud = face_count == 0
        && content.polylines.list_ends.is_empty()
        && content.omissions[Omission::FreeForms as usize].count == 0;
    if is_cloud && content.points.list_ends.is_empty() && !content.positions.is_empty() {
        let text = "the file has neither faces nor lines nor points: its vertices are read as points";
        notes.push(Note::new(Place::Whole, text));
        content.points.vertices = alloc::collect(0..content.positions.len() as u32)?;
    }
    let points = cloud_from_points(&mut content, is_cloud)?;
    let mut document = if face_count == 0 {
        Document::default()
    } else {
        drop_element_vertices(&mut content)?;
        document_from_faces(content, materials.faces, is_split)?
    };
    document.curves = curves;
    document.points = points;
    document.materials = materials.materials;
    document.images = materials.images;
    document.notes = notes;
    Ok(document)
}

fn refuse_foreign_text(word: &[u8], line: u64) -> ReadError {
    let known = [
        (&b"ply"[..], "a PLY file; name it .ply"),
        (b"OFF", "an OFF file; name it .off"),
        (b"solid", "an STL file; name it .stl"),
        (b"{", "a JSON file; if it is a glTF file, name it .gltf"),
    ];
    let text = match known.iter().find(|(start, _)| word.starts_with(start)) {
        Some((_, what)) => format!("this is not an OBJ file: it is {what}"),
        None => format!("this is not an OBJ file: it has no statement like v or f; the first word is {}", quoted(word)),
    };
    ReadError::malformed(Place::Line(line), text)
}

fn omission_notes(content: &Content<'_>) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut add = |tally: Tally, text: String| {
        if tally.count > 0 {
            notes.push(Note::new(Place::Line(tally.first_line + 1), text));
        }
    };
    let omitted = |omission: Omission| content.omissions[omission as usize];
    let unknown = omitted(Omission::Unknown);
    let word = quoted(content.unknown.unwrap_or_default());
    add(
        unknown,
        format!("{} that OBJ files do not have are ignored; the first is {word}", counted(unknown, "statement")),
    );
    let small = omitted(Omission::SmallFaces);
    add(small, format!("{} of fewer than 3 corners: left out", counted(small, "face")));
    let short = omitted(Omission::ShortPolylines);
    add(short, format!("{} of fewer than 2 vertices: left out", counted(short, "polyline")));
    let forms = omitted(Omission::FreeForms);
    add(forms, format!("{}: left out", counted(forms, "free-form curve or surface")));
    let calls = omitted(Omission::Calls);
    add(calls, format!("{} that name other files or programs: not followed", counted(calls, "statement")));
    add(omitted(Omission::Weights), "a fourth number of vertices, which weights free-form curves: ignored".into());
    let at_line = |tally: Tally| Tally { first_line: tally.first_line.saturating_sub(1), ..tally };
    let normals = content.missing_normals;
    add(at_line(normals), format!("{} without its normal, which does not exist", counted(normals, "corner")));
    let texcoords = content.missing_texcoords;
    let text = format!("{} without its texture coordinate, which does not exist", counted(texcoords, "corner"));
    add(at_line(texcoords), text);
    notes
}

fn counted(tally: Tally, noun: &str) -> String {
    format!("{} {noun}{}", tally.count, if tally.count == 1 { "" } else { "s" })
}

/// Divides red, green and blue by 255 if one of them exceeds 1, and so opacity. Missing parts, which are NaN, become 1.
fn scale_colours(colours: &mut [[f32; 4]], notes: &mut Vec<Note>) {
    let exceeds = |places: std::ops::Range<usize>| {
        colours.iter().any(|colour| colour[places.clone()].iter().any(|&part| part > 1.0))
    };
    let full = [exceeds(0..3), exceeds(3..4)].map(|has_steps| if has_steps { 255.0 } else { 1.0 });
    if full != [1.0; 2] {
        notes.push(Note::new(Place::Whole, "colours exceed 1: they are read as steps from 0 to 255"));
    }
    for colour in colours {
        for (part, full) in colour.iter_mut().zip([full[0], full[0], full[0], full[1]]) {
            *part = if part.is_nan() { 1.0 } else { (*part / full).clamp(0.0, 1.0) };
        }
    }
}

fn curves_from_lists(lists: &Lists, positions: &[[f64; 3]]) -> Result<Curves, ReadError> {
    let mut curves = Curves::default();
    let mut points = Vec::new();
    points.try_reserve_exact(lists.vertices.len())?;
    curves.offsets.try_reserve_exact(lists.list_ends.len())?;
    curves.closed.try_reserve_exact(lists.list_ends.len())?;
    let mut start = 0;
    for &end in &lists.list_ends {
        let vertices = &lists.vertices[start..end as usize];
        let is_closed = vertices.len() > 1 && vertices.first() == vertices.last();
        let kept = &vertices[..vertices.len() - usize::from(is_closed)];
        points.extend(kept.iter().map(|&vertex| positions[vertex as usize]));
        curves.offsets.push(points.len() as u32);
        curves.closed.push(is_closed);
        start = end as usize;
    }
    curves.positions = Positions::F64(points);
    Ok(curves)
}

/// Makes points with the colours of their vertices. If the file is a cloud with as many normals as points, each point gets one.
fn cloud_from_points(content: &mut Content<'_>, is_cloud: bool) -> Result<PointCloud, ReadError> {
    let vertices = &content.points.vertices;
    let mut points = Vec::new();
    points.try_reserve_exact(vertices.len())?;
    points.extend(vertices.iter().map(|&vertex| content.positions[vertex as usize]));
    let mut colours = Vec::new();
    if !content.colours.is_empty() {
        colours.try_reserve_exact(vertices.len())?;
        colours.extend(vertices.iter().map(|&vertex| content.colours[vertex as usize]));
    }
    let is_each_vertex =
        vertices.len() == content.positions.len() && (0..).zip(vertices).all(|(place, &vertex)| place == vertex);
    let has_normals = is_cloud && is_each_vertex && content.normals.len() == vertices.len();
    let normals = if has_normals { std::mem::take(&mut content.normals) } else { Vec::new() };
    Ok(PointCloud { positions: Positions::F64(points), normals, colours })
}

/// Drops vertices at the end of the list that polylines and points use but faces do not. Curves and points have copies of them, and
/// the numbers of other vertices stay.
fn drop_element_vertices(content: &mut Content<'_>) -> Result<(), ReadError> {
    let elements = [&content.polylines.vertices, &content.points.vertices];
    if elements.iter().all(|vertices| vertices.is_empty()) {
        return Ok(());
    }
    let face_end = content.corners.iter().max().map_or(0, |&vertex| vertex as usize + 1);
    let mut is_used = Vec::new();
    is_used.try_reserve_exact(content.positions.len() - face_end)?;
    is_used.resize(content.positions.len() - face_end, false);
    for &vertex in elements.into_iter().flatten() {
        if let Some(place) = (vertex as usize).checked_sub(face_end) {
            is_used[place] = true;
        }
    }
    let kept = face_end + is_used.iter().rposition(|&used| !used).map_or(0, |last| last + 1);
    content.positions.truncate(kept);
    content.colours.truncate(kept);
    Ok(())
}
