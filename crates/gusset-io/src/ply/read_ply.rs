//! Reader of PLY files.

use super::ply_columns::{FaceColumns, VertexColumns, index_list, keep_common_properties, other_lists};
use super::ply_faces::FaceParts;
use super::ply_header::{Column, Element, Encoding, Header, MAX_NOTES, read_header};
use super::ply_rows::{BinaryRows, Rows, TextRows, believed_count};
use super::ply_vertices::{VertexAttributeFlags, read_vertices};
use super::range_grid::{UNSEEN, add_range_faces};
use crate::document::{Document, PointCloud};
use crate::error::{Note, Place, ReadError, ReadErrorKind, quoted};
use crate::material::{Image, ImageData, Material};
use crate::mesh::{Domain, Mesh, Values};
use crate::options::ReadOptions;
use crate::text_encoding::owned_text;
use gusset_base::alloc;

/// Reads a mesh, or points if the file has no faces.
pub(crate) fn read_ply(bytes: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    let header = read_header(bytes)?;
    let content = match header.encoding {
        Encoding::Text => Content::read(&header, TextRows::new(bytes, &header)),
        Encoding::LittleEndian => Content::read(&header, BinaryRows::<false>::new(bytes, &header)),
        Encoding::BigEndian => Content::read(&header, BinaryRows::<true>::new(bytes, &header)),
    }?;
    content.into_document(&header)
}

/// The role of an element of a PLY file: vertices, faces, triangle strips, a range image or none.
enum ElementRole {
    Vertices(Box<VertexColumns>),
    Faces(Box<FaceColumns>),
    /// Column of the list of vertices.
    Strips(usize),
    Grid,
    Other,
}

/// Mesh that grows with the elements.
struct Content {
    mesh: Mesh,
    /// A range image: a vertex or [`UNSEEN`] for each place, row by row.
    grid: Vec<u32>,
    notes: Vec<Note>,
}

impl Content {
    fn read<R: Rows>(header: &Header<'_>, mut rows: R) -> Result<Self, ReadError> {
        let mut content = Self { mesh: Mesh::default(), grid: Vec::new(), notes: Vec::new() };
        let mut roles = alloc::with_capacity(header.elements.len())?;
        for element in &header.elements {
            roles.push(element_role(header, element)?);
            alloc::check_reserve()?;
        }
        let count: u64 = elements_with(header, &roles, |role| matches!(role, ElementRole::Vertices(_)))
            .map(|element| element.count)
            .fold(0, u64::saturating_add);
        let count = count.min(u64::from(u32::MAX) - 1) as u32;
        let vertex_parts = content.share_vertex_columns(header, &mut roles)?;
        let mut face_parts = content.share_face_columns(header, &mut roles, count)?;
        for (element, role) in header.elements.iter().zip(&roles).filter(|(element, _)| element.count > 0) {
            rows.begin(element)?;
            let believed = |list| believed_count(element, header.encoding, rows.remaining(), list);
            let mesh = &mut content.mesh;
            match role {
                ElementRole::Vertices(columns) => {
                    let believed = believed(None);
                    read_vertices(&mut rows, element, columns, vertex_parts, believed, mesh, &mut content.notes)?;
                }
                ElementRole::Faces(columns) => {
                    let believed = believed(Some((columns.vertices, 3)));
                    face_parts.read_faces(&mut rows, element, columns, believed, mesh)?;
                }
                ElementRole::Strips(list) => face_parts.read_strips(&mut rows, element, *list, mesh)?,
                ElementRole::Grid => {
                    let believed = believed(None);
                    content.grid = read_grid(&mut rows, element, believed, count)?;
                }
                ElementRole::Other => rows.skip(element)?,
            }
        }
        let mut notes = face_parts.finish(&mut content.mesh);
        content.notes.append(&mut notes);
        content.note_left_over(header, &roles);
        content.notes.extend(rows.note_rest());
        Ok(content)
    }

    /// Finds the attributes that all vertex elements have, and adds their properties to the mesh.
    fn share_vertex_columns(
        &mut self,
        header: &Header<'_>,
        roles: &mut [ElementRole],
    ) -> Result<VertexAttributeFlags, ReadError> {
        let is_vertices = |role: &ElementRole| matches!(role, ElementRole::Vertices(_));
        let elements = alloc::gather(elements_with(header, roles, is_vertices))?;
        let of_vertices = roles
            .iter_mut()
            .filter_map(|role| if let ElementRole::Vertices(columns) = role { Some(columns) } else { None });
        let mut columns = alloc::gather(of_vertices)?;
        let parts = VertexAttributeFlags {
            is_single: elements
                .iter()
                .zip(&columns)
                .all(|(element, found)| found.position.iter().all(|&x| element.columns[x].number_type.fits_single())),
            has_normals: columns.iter().all(|found| found.normal.is_some()),
            has_texcoords: columns.iter().all(|found| found.texcoord.is_some()),
            has_colours: columns.iter().all(|found| found.colour.is_some()),
        };
        let mut rest = alloc::collect(columns.iter_mut().map(|found| &mut found.property_columns))?;
        let (properties, left) = keep_common_properties(&elements, &mut rest, Domain::Vertices)?;
        self.mesh.properties = properties;
        let is_shared = |has: bool, one: &dyn Fn(&VertexColumns) -> bool| has || !columns.iter().any(|c| one(c));
        let is_complete = is_shared(parts.has_normals, &|found| found.normal.is_some())
            && is_shared(parts.has_texcoords, &|found| found.texcoord.is_some())
            && is_shared(parts.has_colours, &|found| found.colour.is_some());
        self.note_shared("vertex", elements.len(), left > 0 || !is_complete);
        Ok(parts)
    }

    /// Finds the attributes that all face elements have, and adds their properties to the mesh. Strips have none.
    fn share_face_columns(
        &mut self,
        header: &Header<'_>,
        roles: &mut [ElementRole],
        vertex_count: u32,
    ) -> Result<FaceParts, ReadError> {
        let has_strips = roles.iter().any(|role| matches!(role, ElementRole::Strips(_)));
        let is_faces = |role: &ElementRole| matches!(role, ElementRole::Faces(_));
        let elements = alloc::gather(elements_with(header, roles, is_faces))?;
        let of_faces = roles
            .iter_mut()
            .filter_map(|role| if let ElementRole::Faces(columns) = role { Some(columns) } else { None });
        let mut columns = alloc::gather(of_faces)?;
        if has_strips {
            columns.iter_mut().for_each(|found| found.property_columns.clear());
        }
        let has_colours = !has_strips && columns.iter().all(|found| found.colour.is_some());
        let has_texcoords = !has_strips && !columns.is_empty() && columns.iter().all(|found| found.texcoord.is_some());
        let mut rest = alloc::collect(columns.iter_mut().map(|found| &mut found.property_columns))?;
        let (properties, left) = keep_common_properties(&elements, &mut rest, Domain::Faces)?;
        let start = self.mesh.properties.len();
        alloc::extend(&mut self.mesh.properties, properties)?;
        let is_complete = (has_colours || !columns.iter().any(|found| found.colour.is_some()))
            && (has_texcoords || !columns.iter().any(|found| found.texcoord.is_some()));
        self.note_shared("face", elements.len(), left > 0 || !is_complete);
        Ok(FaceParts::new(vertex_count, start, header.textures.len(), has_colours, has_texcoords))
    }

    fn note_shared(&mut self, name: &str, count: usize, is_reduced: bool) {
        if count > 1 {
            let text = format!("{count} elements are called \"{name}\"; their rows are joined");
            self.notes.push(Note::new(Place::Whole, text));
        }
        if is_reduced {
            let text = format!("properties that only some {name} elements have are left out");
            self.notes.push(Note::new(Place::Whole, text));
        }
    }

    fn note_left_over(&mut self, header: &Header<'_>, roles: &[ElementRole]) {
        for (element, role) in header.elements.iter().zip(roles).filter(|(element, _)| element.count > 0) {
            let lists = match role {
                ElementRole::Vertices(_) => other_lists(element, &[]),
                ElementRole::Faces(columns) => {
                    let texcoord = columns.texcoord.unwrap_or(columns.vertices);
                    other_lists(element, &[columns.vertices, texcoord])
                }
                _ => String::new(),
            };
            if self.notes.len() == MAX_NOTES {
                self.notes.push(Note::new(Place::Whole, "further elements or lists are left out"));
                break;
            }
            let name = quoted(element.name);
            if !lists.is_empty() {
                self.notes.push(Note::new(Place::Whole, format!("lists of the element {name} are left out: {lists}")));
            }
            if matches!(role, ElementRole::Other) {
                let rows = if element.count == 1 { "1 row".into() } else { format!("{} rows", element.count) };
                let text = format!("the element {name} of {rows} is left out{}", reason_of_loss(header, element));
                self.notes.push(Note::new(Place::Whole, text));
            }
        }
    }

    fn into_document(mut self, header: &Header<'_>) -> Result<Document, ReadError> {
        if !self.grid.is_empty() {
            let columns = usize::try_from(header.grid_columns).map_err(|_| ReadError::out_of_memory())?;
            add_range_faces(&mut self.mesh, &self.grid, columns)?;
        }
        let mut notes = header.notes.clone();
        notes.append(&mut self.notes);
        if self.mesh.face_count() == 0 {
            return points_document(self.mesh, notes);
        }
        let mesh = &mut self.mesh;
        mesh.texcoords = std::mem::take(&mut mesh.texcoords).simplified(&mesh.corners, mesh.positions.len())?;
        let mut document = Document { notes, ..Document::from_mesh(self.mesh) };
        if document.meshes[0].texcoords.is_absent() {
            document.meshes[0].face_materials = Vec::new();
        } else {
            add_texture_materials(&mut document, header)?;
        }
        Ok(document)
    }
}

/// Returns why a range image is left out, behind a comma; nothing for other elements.
fn reason_of_loss(header: &Header<'_>, element: &Element<'_>) -> &'static str {
    if !element.is_named("range_grid") {
        ""
    } else if header.grid_columns == 0 || header.grid_rows == 0 {
        ", because the header lacks \"obj_info num_cols\" and \"obj_info num_rows\""
    } else {
        ", because it lacks a list for each of num_rows times num_cols places, or because the file has faces"
    }
}

/// Adds an image, and a material that shows it, for each texture file that the header names.
fn add_texture_materials(document: &mut Document, header: &Header<'_>) -> Result<(), ReadError> {
    document.materials.try_reserve_exact(header.textures.len())?;
    document.images.try_reserve_exact(header.textures.len())?;
    for (image, name) in header.textures.iter().enumerate() {
        let name = owned_text(name)?;
        let media_type = match name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).as_deref() {
            Some("png") => "image/png",
            Some("jpg" | "jpeg") => "image/jpeg",
            _ => "",
        };
        let file = name.rsplit(['/', '\\']).next().unwrap_or(&name);
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
        document.materials.push(Material { name: stem.clone(), image: Some(image as u32), ..Material::default() });
        document.images.push(Image { name: stem, media_type: media_type.into(), data: ImageData::File(name) });
        alloc::check_reserve()?;
    }
    Ok(())
}

fn points_document(mesh: Mesh, mut notes: Vec<Note>) -> Result<Document, ReadError> {
    let names = mesh
        .properties
        .iter()
        .filter(|property| property.domain == Domain::Vertices)
        .map(|property| &property.name[..])
        .chain((!mesh.texcoords.is_absent()).then_some("texture coordinates"));
    let names = alloc::gather(names)?;
    if !names.is_empty() && !mesh.positions.is_empty() {
        notes.push(Note::new(Place::Whole, format!("points keep only normals and colours, not {}", names.join(", "))));
    }
    let normals = if let Values::Vertices(normals) = mesh.normals { normals } else { Vec::new() };
    let points = PointCloud { positions: mesh.positions, normals, colours: mesh.vertex_colours };
    Ok(Document { points, notes, ..Document::default() })
}

fn elements_with<'a>(
    header: &'a Header<'a>,
    roles: &[ElementRole],
    is_wanted: impl Fn(&ElementRole) -> bool,
) -> impl Iterator<Item = &'a Element<'a>> {
    header.elements.iter().zip(roles).filter(move |(_, role)| is_wanted(role)).map(|(element, _)| element)
}

/// Returns the role of an element by its name and properties. Elements without rows have none.
fn element_role(header: &Header<'_>, element: &Element<'_>) -> Result<ElementRole, ReadError> {
    let malformed = |message: &str| Err(ReadError::new(ReadErrorKind::Malformed, message));
    if element.count == 0 {
        return Ok(ElementRole::Other);
    }
    if element.is_named("vertex") {
        let columns = VertexColumns::find(element)?;
        return columns.map_or_else(
            || malformed("the vertices lack the properties x, y and z"),
            |found| Ok(ElementRole::Vertices(Box::new(found))),
        );
    }
    if element.is_named("face") {
        let columns = FaceColumns::find(element)?;
        return columns.map_or_else(
            || malformed("the faces lack the list vertex_indices"),
            |found| Ok(ElementRole::Faces(Box::new(found))),
        );
    }
    if element.is_named("tristrips") {
        let list = index_list(element);
        return list.map_or_else(
            || malformed("the strips lack the list vertex_indices"),
            |list| Ok(ElementRole::Strips(list)),
        );
    }
    // A place of one byte could become 36 bytes of triangles.
    let is_wide = |column: &Column<'_>| column.list_length_type.is_some() || column.number_type.size() > 1;
    let is_grid = element.is_named("range_grid")
        && element.columns.first().is_some_and(is_wide)
        && header.grid_rows.checked_mul(header.grid_columns) == Some(element.count)
        && !header
            .elements
            .iter()
            .any(|other| other.count > 0 && (other.is_named("face") || other.is_named("tristrips")));
    Ok(if is_grid { ElementRole::Grid } else { ElementRole::Other })
}

/// Reads a range image.
fn read_grid<R: Rows>(rows: &mut R, element: &Element<'_>, believed: usize, count: u32) -> Result<Vec<u32>, ReadError> {
    let mut grid = Vec::new();
    grid.try_reserve_exact(believed)?;
    let is_list = element.columns[0].list_length_type.is_some();
    for row in 0..element.count {
        rows.advance(element, row)?;
        if rows.list_length(0) == 0 {
            grid.push(UNSEEN);
            continue;
        }
        let value = rows.item(0, 0);
        if !is_list && value < 0.0 {
            grid.push(UNSEEN);
        } else if value >= 0.0 && value < f64::from(count) && value.fract() == 0.0 {
            grid.push(value as u32);
        } else {
            let name = element.row_name(row);
            let text = format!("{name}: vertex {value} does not exist (the mesh has {count})");
            return Err(ReadError::malformed(rows.place(), text));
        }
    }
    Ok(grid)
}
