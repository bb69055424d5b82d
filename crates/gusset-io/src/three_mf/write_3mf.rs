//! Writes a package of one model part. The bytes depend on the document alone: no times, no random names.

use super::read_mf_model::UNITS;
use crate::document::{Document, Placement};
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::material::{Material, NO_MATERIAL};
use crate::mesh::{Domain, Mesh, Positions};
use crate::options::WriteOptions;
use crate::polygons::triangulate_face;
use crate::resources::Target;
use crate::scene::{colour_step, has_shades_between_steps};
use crate::text::TextWriter;
use gusset_base::alloc;
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::io::{self, Write};

const CONTENT_TYPES: &str = concat!(
    r#"<?xml version="1.0" encoding="UTF-8"?>"#,
    "\n",
    r#"<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">"#,
    r#"<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>"#,
    r#"<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>"#,
    "\n"
);

const RELATIONS: &str = concat!(
    r#"<?xml version="1.0" encoding="UTF-8"?>"#,
    "\n",
    r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship "#,
    r#"Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>"#,
    "</Relationships>\n"
);

/// Level of deflate. Level 4 takes twice the time for 9 % less.
const COMPRESSION_LEVEL: u32 = 2;

pub(crate) fn write_3mf(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    check_positions(document)?;
    let mut losses = Losses::default();
    let mut archive = ZipArchiveWriter::new(&mut *target.main_file);
    write_part(&mut archive, "[Content_Types].xml", |out| out.write_all(CONTENT_TYPES.as_bytes()))?;
    write_part(&mut archive, "_rels/.rels", |out| out.write_all(RELATIONS.as_bytes()))?;
    write_part(&mut archive, "3D/3dmodel.model", |out| ModelWriter::new(document, out, &mut losses)?.write())?;
    archive.finish().map_err(zip_error)?.flush()?;
    Ok(losses.into_losses(document))
}

fn zip_error(error: rawzip::Error) -> WriteError {
    WriteError::from(io::Error::other(error))
}

/// Writes a part with deflate.
fn write_part<W: Write>(
    archive: &mut ZipArchiveWriter<W>,
    name: &str,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    let time = UtcDateTime::from_components(1980, 1, 1, 0, 0, 0, 0);
    let mut builder = archive.new_file(name).compression_method(CompressionMethod::DEFLATE);
    if let Some(time) = time {
        builder = builder.last_modified(time);
    }
    let (mut entry, config) = builder.start().map_err(zip_error)?;
    let encoder = flate2::write::DeflateEncoder::new(&mut entry, flate2::Compression::new(COMPRESSION_LEVEL));
    let mut out = config.wrap(encoder);
    write(&mut out)?;
    let (encoder, descriptor) = out.finish().map_err(zip_error)?;
    encoder.finish()?;
    entry.finish(descriptor).map_err(zip_error)?;
    Ok(())
}

/// Refuses numbers that XML cannot hold.
fn check_positions(document: &Document) -> Result<(), WriteError> {
    for placement in &document.placements {
        let mesh = &document.meshes[placement.mesh as usize];
        if let Some(vertex) = mesh.positions.iter().position(|point| !point.iter().all(|x| x.is_finite())) {
            let message = format!("vertex {vertex} is not finite, and 3MF files hold finite numbers only");
            return Err(WriteError::new(WriteErrorKind::Unsupported, message));
        }
    }
    Ok(())
}

/// Content that the file does not hold.
#[derive(Default)]
struct Losses {
    polygons: usize,
    narrow_faces: usize,
    has_materials_beside_colours: bool,
    has_both_colours: bool,
    are_colours_rounded: bool,
}

/// Returns `1 face`, or `2 faces`.
fn faces_text(count: usize) -> String {
    format!("{count} {}", if count == 1 { "face" } else { "faces" })
}

impl Losses {
    fn into_losses(self, document: &Document) -> Vec<Loss> {
        let placed = || document.placements.iter().map(|placement| &document.meshes[placement.mesh as usize]);
        let mut names: Vec<String> = Vec::new();
        let mut add = |is_lost: bool, name: &str| {
            if is_lost && !names.iter().any(|known| known == name) {
                names.push(name.to_owned());
            }
        };
        add(placed().any(|mesh| !mesh.normals.is_absent()), "normals");
        add(placed().any(|mesh| !mesh.texcoords.is_absent()), "texture coordinates");
        add(document.materials.iter().any(|material| material.image.is_some()), "images");
        add(self.has_materials_beside_colours, "materials of meshes that also have colours");
        add(self.has_both_colours, "colours of faces of meshes whose vertices also have colours");
        add(!document.curves.closed.is_empty(), "curves");
        add(!document.points.positions.is_empty(), "points without faces");
        for property in placed().flat_map(|mesh| &mesh.properties) {
            let domain = if property.domain == Domain::Vertices { "vertices" } else { "faces" };
            add(true, &format!("{} of {domain}", property.name));
        }
        let is_rounded = |material: &Material| has_shades_between_steps(&[material.colour]);
        let are_materials_rounded = document.materials.iter().any(is_rounded);
        let mut losses: Vec<String> = names.iter().map(|name| format!("{name}, which 3MF files do not hold")).collect();
        if self.are_colours_rounded || are_materials_rounded {
            losses.push("shades of colours between 256 steps".into());
        }
        if self.polygons > 0 {
            losses.push(format!("{} of more than three corners: cut into triangles", faces_text(self.polygons)));
        }
        if self.narrow_faces > 0 {
            losses.push(format!("{} of fewer than three corners", faces_text(self.narrow_faces)));
        }
        if let Some(unit) = document.metres_per_unit.filter(|&unit| unit_name(Some(unit)).is_none()) {
            losses.push(format!("the unit of length, {unit} metres: numbers stay, and the file says millimetres"));
        }
        losses.into_iter().map(|text| Loss(crate::error::printable(&text))).collect()
    }
}

fn unit_name(metres: Option<f64>) -> Option<&'static str> {
    let metres = metres?;
    UNITS.iter().find(|(_, own)| (own - metres).abs() <= 1e-9 * own).map(|(name, _)| *name)
}

/// Properties of a mesh's triangles.
enum Properties {
    None,
    /// A material for each triangle.
    Materials,
    /// Materials for some triangles.
    SomeMaterials,
    /// Number of the group of colours.
    VertexColours(u32),
    FaceColours(u32),
}

struct ModelWriter<'w> {
    document: &'w Document,
    out: TextWriter<'w>,
    losses: &'w mut Losses,
    /// Number of the next resource.
    next_resource_id: u32,
}

/// The number of the group of materials.
const MATERIALS: u32 = 1;

impl<'w> ModelWriter<'w> {
    fn new(document: &'w Document, out: &'w mut dyn Write, losses: &'w mut Losses) -> io::Result<Self> {
        Ok(Self { document, out: TextWriter::new(out)?, losses, next_resource_id: MATERIALS + 1 })
    }

    fn write(mut self) -> io::Result<()> {
        let document = self.document;
        let unit = unit_name(document.metres_per_unit).unwrap_or("millimeter");
        self.out.text("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"")?;
        self.out.text(unit)?;
        self.out.text("\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" ")?;
        self.out.text("xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<resources>\n")?;
        self.materials()?;
        let mut objects: BTreeMap<u32, u32> = BTreeMap::new();
        for placement in &document.placements {
            if let Entry::Vacant(entry) = objects.entry(placement.mesh) {
                let mesh = &document.meshes[placement.mesh as usize];
                let name = if mesh.name.is_empty() { &placement.name } else { &mesh.name };
                entry.insert(self.object(mesh, name)?);
                alloc::check_reserve().map_err(|_| io::ErrorKind::OutOfMemory)?;
            }
        }
        self.out.text("</resources>\n<build>\n")?;
        for placement in &document.placements {
            self.item(objects[&placement.mesh], placement)?;
        }
        self.out.text("</build>\n</model>\n")?;
        self.out.finish()
    }

    fn materials(&mut self) -> io::Result<()> {
        if self.document.materials.is_empty() {
            return Ok(());
        }
        self.out.text(&format!("<basematerials id=\"{MATERIALS}\">\n"))?;
        for material in &self.document.materials {
            self.out.text("<base name=\"")?;
            self.escaped(&material.name)?;
            alloc::check_reserve().map_err(|_| io::ErrorKind::OutOfMemory)?;
            self.out.text(&format!("\" displaycolor=\"{}\"/>\n", colour_text(material.colour)))?;
        }
        self.out.text("</basematerials>\n")
    }

    /// Writes text as the value of an attribute.
    fn escaped(&mut self, text: &str) -> io::Result<()> {
        for c in text.chars() {
            match c {
                '&' => self.out.text("&amp;")?,
                '<' => self.out.text("&lt;")?,
                '>' => self.out.text("&gt;")?,
                '"' => self.out.text("&quot;")?,
                // XML cannot hold these.
                c if c < ' ' || matches!(c, '\u{fffe}' | '\u{ffff}') => self.out.text(" ")?,
                c => self.out.text(c.encode_utf8(&mut [0; 4]))?,
            }
        }
        Ok(())
    }

    /// Writes an object and its colours. Returns the object's number.
    fn object(&mut self, mesh: &Mesh, name: &str) -> io::Result<u32> {
        let properties = self.properties(mesh)?;
        let id = self.next_resource_id;
        self.next_resource_id += 1;
        self.out.text(&format!("<object id=\"{id}\" type=\"model\""))?;
        if !name.is_empty() {
            self.out.text(" name=\"")?;
            self.escaped(name)?;
            self.out.text("\"")?;
        }
        match properties {
            Properties::Materials => self.out.text(&format!(" pid=\"{MATERIALS}\" pindex=\"0\""))?,
            Properties::VertexColours(group) | Properties::FaceColours(group) => {
                self.out.text(&format!(" pid=\"{group}\" pindex=\"0\""))?;
            }
            // A group of the object would apply to all triangles.
            Properties::SomeMaterials | Properties::None => {}
        }
        self.out.text("><mesh>\n<vertices>\n")?;
        self.vertices(&mesh.positions)?;
        self.out.text("</vertices>\n<triangles>\n")?;
        self.triangles(mesh, &properties)?;
        self.out.text("</triangles>\n</mesh></object>\n")?;
        Ok(id)
    }

    /// Chooses what triangles refer to, and writes colours.
    fn properties(&mut self, mesh: &Mesh) -> io::Result<Properties> {
        let has_materials = mesh.face_materials.iter().any(|&material| material != NO_MATERIAL);
        let colours = if mesh.vertex_colours.is_empty() { &mesh.face_colours } else { &mesh.vertex_colours };
        if colours.is_empty() {
            let has_all = mesh.face_materials.iter().all(|&material| material != NO_MATERIAL);
            return Ok(match (has_materials, has_all) {
                (false, _) => Properties::None,
                (true, true) => Properties::Materials,
                (true, false) => Properties::SomeMaterials,
            });
        }
        self.losses.has_materials_beside_colours |= has_materials;
        self.losses.are_colours_rounded |= has_shades_between_steps(colours);
        self.losses.has_both_colours |= !mesh.vertex_colours.is_empty() && !mesh.face_colours.is_empty();
        let group = self.next_resource_id;
        self.next_resource_id += 1;
        self.out.text(&format!("<m:colorgroup id=\"{group}\">\n"))?;
        for &colour in colours {
            self.out.text("<m:color color=\"")?;
            self.out.text(&colour_text(colour))?;
            self.out.text("\"/>\n")?;
        }
        self.out.text("</m:colorgroup>\n")?;
        let is_at_vertices = !mesh.vertex_colours.is_empty();
        Ok(if is_at_vertices { Properties::VertexColours(group) } else { Properties::FaceColours(group) })
    }

    fn vertices(&mut self, positions: &Positions) -> io::Result<()> {
        for vertex in 0..positions.len() {
            for axis in 0..3 {
                self.out.text(["<vertex x=\"", "\" y=\"", "\" z=\""][axis])?;
                match positions {
                    Positions::F32(points) => self.out.single(points[vertex][axis])?,
                    Positions::F64(points) => self.out.double(points[vertex][axis])?,
                }
            }
            self.out.text("\"/>\n")?;
        }
        Ok(())
    }

    fn triangles(&mut self, mesh: &Mesh, properties: &Properties) -> io::Result<()> {
        let mut triangles = Vec::new();
        for face in 0..mesh.face_count() {
            let corners = mesh.face(face);
            triangles.clear();
            match corners.len() {
                0..3 => self.losses.narrow_faces += 1,
                3 => triangles.push([0, 1, 2]),
                _ => {
                    self.losses.polygons += 1;
                    triangulate_face(mesh, face, &mut triangles).map_err(|_| io::ErrorKind::OutOfMemory)?;
                }
            }
            for triangle in &triangles {
                self.triangle(mesh, face, triangle.map(|place| corners[place as usize]), properties)?;
            }
        }
        Ok(())
    }

    fn triangle(&mut self, mesh: &Mesh, face: usize, vertices: [u32; 3], properties: &Properties) -> io::Result<()> {
        for (name, vertex) in ["<triangle v1=\"", "\" v2=\"", "\" v3=\""].into_iter().zip(vertices) {
            self.out.text(name)?;
            self.out.integer(u64::from(vertex))?;
        }
        let entry = match properties {
            Properties::VertexColours(_) => {
                for (name, vertex) in ["\" p1=\"", "\" p2=\"", "\" p3=\""].into_iter().zip(vertices) {
                    self.out.text(name)?;
                    self.out.integer(u64::from(vertex))?;
                }
                None
            }
            Properties::FaceColours(_) => Some(face as u64),
            Properties::Materials => Some(u64::from(mesh.face_materials[face])),
            Properties::SomeMaterials if mesh.face_materials[face] != NO_MATERIAL => {
                self.out.text(&format!("\" pid=\"{MATERIALS}"))?;
                Some(u64::from(mesh.face_materials[face]))
            }
            Properties::SomeMaterials | Properties::None => None,
        };
        if let Some(entry) = entry {
            self.out.text("\" p1=\"")?;
            self.out.integer(entry)?;
        }
        self.out.text("\"/>\n")
    }

    fn item(&mut self, object: u32, placement: &Placement) -> io::Result<()> {
        self.out.text(&format!("<item objectid=\"{object}\""))?;
        if placement.transform != Placement::IDENTITY {
            self.out.text(" transform=\"")?;
            for column in 0..4 {
                for row in 0..3 {
                    self.out.text(if column + row > 0 { " " } else { "" })?;
                    self.out.double(placement.transform[row][column])?;
                }
            }
            self.out.text("\"")?;
        }
        self.out.text("/>\n")
    }
}

/// Returns `#RRGGBB`, or `#RRGGBBAA` if the colour is not opaque.
fn colour_text(colour: [f32; 4]) -> String {
    let [r, g, b, a] = colour.map(colour_step);
    if a == 255 { format!("#{r:02X}{g:02X}{b:02X}") } else { format!("#{r:02X}{g:02X}{b:02X}{a:02X}") }
}
