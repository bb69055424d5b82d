//! Reads the XML of a model part.

use super::mf_attributes::{attribute, colour_from_text, local_attribute, matrix, missing, whole};
use super::mf_model::{Component, Group, Model, Object, ResourceId};
use super::mf_package::{MAX_TOKEN_BYTES, Package, TokenLimit, part_key};
use super::mf_properties::{TriangleProperties, apply_properties};
use crate::budget::Budget;
use crate::document::{Document, Placement};
use crate::error::{Note, Place, ReadError, printable};
use crate::material::{Image, ImageData, Material};
use crate::mesh::{Mesh, Positions};
use crate::text::number;
use gusset_base::alloc;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::collections::BTreeSet;
use std::io::{BufRead, Read};
use std::sync::Arc;

/// Units of length in metres.
pub(super) const UNITS: [(&str, f64); 6] =
    [("micron", 1e-6), ("millimeter", 1e-3), ("centimeter", 1e-2), ("inch", 0.0254), ("foot", 0.3048), ("meter", 1.0)];

/// Most tags inside each other.
const MAX_DEPTH: usize = 256;

/// State of the reader of one part.
pub(super) struct ModelReader<'r> {
    pub(super) package: &'r Package<'r>,
    pub(super) model: &'r mut Model,
    pub(super) document: &'r mut Document,
    pub(super) budget: &'r mut Budget,
    /// Index of the part.
    part: u32,
    part_name: String,
    object: Option<Object>,
    mesh: Option<OpenMesh>,
    group: Option<(ResourceId, Group)>,
    /// Kinds of content that are left out.
    unread: BTreeSet<&'static str>,
}

#[derive(Default)]
struct OpenMesh {
    points: Vec<[f64; 3]>,
    corners: Vec<u32>,
    properties: TriangleProperties,
}

/// Replaces bytes beyond ASCII, for parts that are not valid UTF-8.
struct AsciiReader<R>(R);

impl<R: Read> Read for AsciiReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.0.read(buffer)?;
        buffer[..count].iter_mut().filter(|byte| !byte.is_ascii()).for_each(|byte| *byte = b'?');
        Ok(count)
    }
}

impl<'r> ModelReader<'r> {
    pub(super) fn new(
        package: &'r Package<'r>,
        model: &'r mut Model,
        document: &'r mut Document,
        budget: &'r mut Budget,
        part: u32,
    ) -> Self {
        let part_name = model.parts[part as usize].clone();
        Self {
            package,
            model,
            document,
            budget,
            part,
            part_name,
            object: None,
            mesh: None,
            group: None,
            unread: BTreeSet::new(),
        }
    }

    /// Reads the part into the model.
    pub(super) fn read(&mut self) -> Result<(), ReadError> {
        let key = part_key(&self.part_name);
        let (bytes, limit, _) = self.package.part(&key)?.split();
        if self.read_events(bytes, &limit)? {
            self.forget_part();
            let text = format!("the part {key} is not valid UTF-8; characters beyond ASCII are replaced");
            alloc::push(&mut self.document.notes, Note::new(Place::Whole, text))?;
            let (bytes, limit, _) = self.package.part(&key)?.split();
            self.read_events(std::io::BufReader::with_capacity(1 << 16, AsciiReader(bytes)), &limit)?;
        }
        for name in std::mem::take(&mut self.unread) {
            alloc::push(&mut self.document.notes, Note::new(Place::Whole, format!("{name} are not read")))?;
        }
        Ok(())
    }

    /// Removes what an attempt to read the part has added.
    fn forget_part(&mut self) {
        let part = self.part;
        self.model.objects.retain(|id, _| id.0 != part);
        self.model.groups.retain(|id, _| id.0 != part);
        self.model.items.clear();
        (self.object, self.mesh, self.group) = (None, None, None);
    }

    /// Handles all tags. Returns true if the text is not valid UTF-8.
    fn read_events(&mut self, bytes: impl BufRead, limit: &TokenLimit) -> Result<bool, ReadError> {
        let mut xml = Reader::from_reader(bytes);
        let config = xml.config_mut();
        (config.check_comments, config.allow_unmatched_ends, config.allow_dangling_amp) = (false, true, true);
        // A tag never exceeds this, so that the buffer does not grow.
        let mut buffer = alloc::with_capacity(MAX_TOKEN_BYTES as usize + (1 << 17))?;
        let mut depth = 0;
        loop {
            limit.next_token();
            buffer.clear();
            alloc::check_reserve()?;
            match xml.read_event_into(&mut buffer) {
                Ok(Event::Start(tag)) => {
                    depth += 1;
                    if depth > MAX_DEPTH {
                        let message =
                            format!("the part {} has more than {MAX_DEPTH} tags inside each other", self.part_name);
                        return Err(ReadError::malformed(Place::Whole, message));
                    }
                    self.start(&tag)?;
                }
                Ok(Event::Empty(tag)) => {
                    self.start(&tag)?;
                    self.end(tag.local_name().into_inner())?;
                }
                Ok(Event::End(tag)) => {
                    depth = depth.saturating_sub(1);
                    self.end(tag.local_name().into_inner())?;
                }
                Ok(Event::Eof) => break,
                Ok(_) => {}
                Err(quick_xml::Error::Encoding(_)) => return Ok(true),
                Err(error) => return Err(limit.error(&self.part_name, &printable(&error.to_string()))),
            }
        }
        if let Some(object) = &self.object {
            let message = format!("object {}: the part {} ends inside of it", object.id.1, self.part_name);
            return Err(ReadError::malformed(Place::Whole, message));
        }
        Ok(false)
    }

    fn start(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        match tag.local_name().into_inner() {
            "vertex" => self.vertex(tag),
            "triangle" => self.triangle(tag),
            "model" => self.model_tag(tag),
            "object" => self.start_object(tag),
            "mesh" => {
                self.mesh = Some(OpenMesh::default());
                Ok(())
            }
            "component" => {
                let component = self.component(tag)?;
                if let Some(object) = &mut self.object {
                    self.budget.take_bytes_of::<Component>(1)?;
                    alloc::push(&mut object.components, component)?;
                }
                Ok(())
            }
            "item" => {
                self.budget.take_bytes_of::<Component>(1)?;
                let item = self.component(tag)?;
                // Only the main part says what is built.
                if self.part == 0 {
                    alloc::push(&mut self.model.items, item)?;
                }
                Ok(())
            }
            "basematerials" | "colorgroup" | "texture2dgroup" | "compositematerials" | "multiproperties" => {
                self.start_group(tag)
            }
            "base" => self.base_material(tag),
            "color" => self.colour(tag),
            "tex2coord" => self.texcoord(tag),
            "texture2d" => self.texture(tag),
            "beamlattice" => self.leave_out("beam lattices"),
            "slicestack" => self.leave_out("slices"),
            "displacementmesh" => self.leave_out("displacements"),
            "booleanshape" => self.leave_out("Boolean operations"),
            "volumedata" | "levelset" => self.leave_out("volumes"),
            _ => Ok(()),
        }
    }

    fn leave_out(&mut self, name: &'static str) -> Result<(), ReadError> {
        self.unread.insert(name);
        Ok(())
    }

    fn end(&mut self, name: &str) -> Result<(), ReadError> {
        match name {
            "object" => self.end_object(),
            "basematerials" | "colorgroup" | "texture2dgroup" | "compositematerials" | "multiproperties" => {
                if let Some((id, group)) = self.group.take() {
                    self.model.groups.insert(id, group);
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn model_tag(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let unit = attribute(tag, "unit");
        let known = UNITS.iter().find(|(name, _)| unit.as_deref().is_some_and(|unit| unit.eq_ignore_ascii_case(name)));
        let metres = match (&unit, known) {
            (_, Some((_, metres))) => *metres,
            (None, None) => 1e-3,
            (Some(unit), None) => {
                let text = format!("the unit {} is unknown; millimetres are assumed", printable(unit));
                alloc::push(&mut self.document.notes, Note::new(Place::Whole, text))?;
                1e-3
            }
        };
        self.model.metres_per_unit.get_or_insert(metres);
        for prefix in attribute(tag, "requiredextensions").unwrap_or_default().split_ascii_whitespace() {
            let address = attribute(tag, &format!("xmlns:{prefix}")).unwrap_or_default();
            if address.contains("securecontent") {
                let message = "the file is encrypted (3MF Secure Content); export it without encryption";
                return Err(ReadError::unsupported(message));
            }
            if !address.contains("/material/") && !address.contains("/production/") {
                let text = format!("the required extension {} is not read", printable(&address));
                alloc::push(&mut self.document.notes, Note::new(Place::Whole, text))?;
            }
        }
        Ok(())
    }

    fn start_object(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let id = (self.part, whole(tag, "id").ok_or_else(|| missing("an object", "id"))?);
        let kind = attribute(tag, "type").unwrap_or_default();
        let name = attribute(tag, "name").unwrap_or_default();
        // Maps of objects and of their sizes take about as much again.
        self.budget.take_bytes_of::<(ResourceId, Object, [u64; 12])>(1)?;
        self.budget.take_bytes_of::<u8>(4 * name.len() as u64)?;
        let property = whole(tag, "pid").map(|group| (group, whole(tag, "pindex").unwrap_or(0)));
        let is_support = kind.ends_with("support");
        self.object = Some(Object { id, name, is_support, property, ..Object::default() });
        Ok(())
    }

    fn end_object(&mut self) -> Result<(), ReadError> {
        let Some(mut object) = self.object.take() else { return Ok(()) };
        if let Some(open) = self.mesh.take() {
            self.budget.take_bytes_of::<Mesh>(1)?;
            object.mesh = Some(Box::new(self.finished_mesh(open, &object)?));
        }
        let id = object.id;
        if self.model.objects.insert(id, object).is_some() {
            return Err(ReadError::malformed(Place::Whole, format!("two objects have the number {}", id.1)));
        }
        Ok(())
    }

    fn finished_mesh(&mut self, open: OpenMesh, object: &Object) -> Result<Mesh, ReadError> {
        let count = open.points.len();
        if let Some(place) = open.corners.iter().position(|&vertex| vertex as usize >= count) {
            let (face, corner, vertex) = (place / 3, place % 3, open.corners[place]);
            return Err(ReadError::malformed(
                Place::Whole,
                format!(
                    "object {}, face {face}, corner {corner}: vertex {vertex} does not exist (the mesh has {count})",
                    object.id.1
                ),
            ));
        }
        let faces = open.corners.len() / 3;
        let mut face_offsets = self.budget.allocate_vector(faces as u64 + 1)?;
        face_offsets.extend((0..=faces as u32).map(|face| 3 * face));
        let mut mesh = Mesh {
            name: object.name.clone(),
            positions: Positions::F64(open.points),
            face_offsets,
            corners: open.corners,
            ..Mesh::default()
        };
        apply_properties(&mut mesh, &open.properties, object, self.model, self.document, self.budget)?;
        Ok(mesh)
    }

    fn vertex(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some(mesh) = &mut self.mesh else { return Ok(()) };
        let mut point = [None; 3];
        for attribute in tag.attributes().with_checks(false).flatten() {
            let axis = match attribute.key.into_inner() {
                "x" => 0,
                "y" => 1,
                "z" => 2,
                _ => continue,
            };
            point[axis] = number(attribute.value.trim().as_bytes());
        }
        let [Some(x), Some(y), Some(z)] = point else {
            let object = self.object.as_ref().map_or(0, |object| object.id.1);
            let message = format!("object {object}, vertex {}: x, y or z is not a number", mesh.points.len());
            return Err(ReadError::malformed(Place::Whole, message));
        };
        if mesh.points.len() == mesh.points.capacity() {
            let more = mesh.points.capacity().max(64);
            self.budget.take_bytes_of::<[f64; 3]>(more as u64)?;
            mesh.points.try_reserve_exact(more)?;
        }
        mesh.points.push([x, y, z]);
        Ok(())
    }

    fn triangle(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some(mesh) = &mut self.mesh else { return Ok(()) };
        let mut corners = [None; 3];
        let (mut group, mut entries) = (None, [None; 3]);
        for attribute in tag.attributes().with_checks(false).flatten() {
            let value = || attribute.value.trim().parse::<u32>().ok();
            match attribute.key.into_inner() {
                "v1" => corners[0] = value(),
                "v2" => corners[1] = value(),
                "v3" => corners[2] = value(),
                "pid" => group = value(),
                "p1" => entries[0] = value(),
                "p2" => entries[1] = value(),
                "p3" => entries[2] = value(),
                _ => {}
            }
        }
        let [Some(a), Some(b), Some(c)] = corners else {
            let object = self.object.as_ref().map_or(0, |object| object.id.1);
            let face = mesh.corners.len() / 3;
            let message = format!("object {object}, face {face}: v1, v2 or v3 is not a whole number from 0");
            return Err(ReadError::malformed(Place::Whole, message));
        };
        let faces = mesh.corners.len() / 3;
        if mesh.corners.len() + 3 > mesh.corners.capacity() {
            let more = mesh.corners.capacity().max(192);
            self.budget.take_bytes_of::<u32>(more as u64)?;
            mesh.corners.try_reserve_exact(more)?;
        }
        mesh.corners.extend([a, b, c]);
        if group.is_some() || entries[0].is_some() {
            mesh.properties.set(faces, group, entries, self.budget)?;
        }
        Ok(())
    }

    fn component(&mut self, tag: &BytesStart<'_>) -> Result<Component, ReadError> {
        let object = whole(tag, "objectid").ok_or_else(|| missing("a component or item", "objectid"))?;
        let part = match local_attribute(tag, "path") {
            None => self.part,
            Some(path) => {
                let known = self.model.known_parts.get(&part_key(&path)).copied();
                known.map_or_else(|| self.add_part(path), Ok)?
            }
        };
        let transform = match attribute(tag, "transform") {
            None => Placement::IDENTITY,
            Some(text) => matrix(&text).ok_or_else(|| {
                let shown = printable(&text.chars().take(60).collect::<String>());
                ReadError::malformed(Place::Whole, format!("the transform \"{shown}\" is not a list of 12 numbers"))
            })?,
        };
        Ok(Component { object: (part, object), transform })
    }

    fn add_part(&mut self, path: String) -> Result<u32, ReadError> {
        let key = part_key(&path);
        if !self.package.has(&key) {
            let message = format!("the part {} is missing", printable(&path));
            return Err(ReadError::malformed(Place::Whole, message));
        }
        alloc::push(&mut self.model.parts, path)?;
        let index = self.model.parts.len() as u32 - 1;
        self.model.known_parts.insert(key, index);
        Ok(index)
    }

    fn start_group(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some(id) = whole(tag, "id") else { return Ok(()) };
        self.budget.take_bytes_of::<(ResourceId, Group, [u64; 4])>(1)?;
        let group = match tag.local_name().into_inner() {
            "basematerials" => Group::Materials { first: self.document.materials.len() as u32, count: 0 },
            "colorgroup" => Group::Colours(Vec::new()),
            "texture2dgroup" => {
                let image = whole(tag, "texid").and_then(|image| self.model.texture_materials.get(&(self.part, image)));
                match image {
                    Some(&material) => Group::Texcoords { pairs: Vec::new(), material },
                    None => Group::Other,
                }
            }
            _ => {
                self.unread.insert("mixed materials");
                Group::Other
            }
        };
        self.group = Some(((self.part, id), group));
        Ok(())
    }

    fn base_material(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some((_, Group::Materials { count, .. })) = &mut self.group else { return Ok(()) };
        let name = attribute(tag, "name").unwrap_or_default();
        self.budget.take_bytes_of::<Material>(2)?;
        self.budget.take_bytes_of::<u8>(name.len() as u64)?;
        let colour = attribute(tag, "displaycolor").and_then(|text| colour_from_text(&text)).unwrap_or([1.0; 4]);
        alloc::push(&mut self.document.materials, Material { name, colour, ..Material::default() })?;
        *count += 1;
        Ok(())
    }

    fn colour(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some((_, Group::Colours(colours))) = &mut self.group else { return Ok(()) };
        self.budget.take_bytes_of::<[f32; 4]>(2)?;
        let colour = attribute(tag, "color").and_then(|text| colour_from_text(&text)).unwrap_or([1.0; 4]);
        alloc::push(colours, colour)?;
        Ok(())
    }

    fn texcoord(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let Some((_, Group::Texcoords { pairs, .. })) = &mut self.group else { return Ok(()) };
        self.budget.take_bytes_of::<[f64; 2]>(2)?;
        let [u, v] = ["u", "v"].map(|name| attribute(tag, name).and_then(|text| number(text.trim().as_bytes())));
        alloc::push(pairs, [u.unwrap_or(0.0), v.unwrap_or(0.0)])?;
        Ok(())
    }

    /// Reads an image, and makes a material that shows it.
    fn texture(&mut self, tag: &BytesStart<'_>) -> Result<(), ReadError> {
        let (Some(id), Some(path)) = (whole(tag, "id"), attribute(tag, "path")) else { return Ok(()) };
        let key = part_key(&path);
        let name = key.rsplit('/').next().unwrap_or_default().to_owned();
        if !self.package.has(&key) {
            let text = format!("the image {} is missing", printable(&path));
            alloc::push(&mut self.document.notes, Note::new(Place::Whole, text))?;
            return Ok(());
        }
        let image = match self.model.images.get(&key) {
            Some(&image) => image,
            None => {
                let bytes = self.package.part(&key)?.read_all(self.budget.left_bytes() / 2)?;
                self.budget.take_bytes_of::<u8>(2 * bytes.len() as u64)?;
                let media_type = attribute(tag, "contenttype").unwrap_or_default();
                let data = ImageData::Bytes(Arc::new(bytes));
                alloc::push(&mut self.document.images, Image { name: name.clone(), media_type, data })?;
                let image = self.document.images.len() as u32 - 1;
                self.model.images.insert(key, image);
                image
            }
        };
        self.budget.take_bytes_of::<(Material, ResourceId)>(2)?;
        let material = self.document.materials.len() as u32;
        alloc::push(&mut self.document.materials, Material { name, image: Some(image), ..Material::default() })?;
        self.model.texture_materials.insert((self.part, id), material);
        Ok(())
    }
}
