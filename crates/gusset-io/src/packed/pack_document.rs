//! Writes documents in the packed form.

use super::Packed;
use crate::document::{Curves, Document, PointCloud};
use crate::error::{Note, Place, ReadError};
use crate::json_text::{push_number, push_text};
use crate::material::{Image, ImageData, Material, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use bytemuck::NoUninit;
use gusset_base::alloc;

/// Packs a document.
///
/// # Errors
/// `OutOfMemory`.
pub fn pack(document: &Document) -> Result<Packed, ReadError> {
    let mut packer = Packer::default();
    packer.object(|packer| {
        packer.list("meshes", &document.meshes, Packer::mesh)?;
        packer.list("placements", &document.placements, |packer, placement| {
            packer.object(|packer| {
                packer.text("name", &placement.name)?;
                packer.number("mesh", f64::from(placement.mesh))
            })
        })?;
        let transforms = alloc::collect(document.placements.iter().map(|placement| placement.transform))?;
        packer.array("transforms", "f64", 12, &transforms)?;
        packer.key("curves")?;
        packer.curves(&document.curves)?;
        packer.key("points")?;
        packer.points(&document.points)?;
        packer.list("materials", &document.materials, Packer::material)?;
        packer.list("images", &document.images, Packer::image)?;
        packer.optional_number("metres_per_unit", document.metres_per_unit)?;
        packer.list("notes", &document.notes, Packer::note)
    })?;
    Ok(Packed { description: packer.json, arrays: packer.arrays })
}

/// The JSON text and the arrays so far.
#[derive(Default)]
struct Packer {
    json: String,
    arrays: Vec<u8>,
}

impl Packer {
    /// Makes room for more of the text.
    fn reserve(&mut self, bytes: usize) -> Result<(), ReadError> {
        self.json.try_reserve(bytes)?;
        Ok(alloc::check_reserve()?)
    }

    /// Separates a value from the one before, if there is one.
    fn separate(&mut self) -> Result<(), ReadError> {
        self.reserve(1)?;
        if !self.json.is_empty() && !self.json.ends_with(['{', '[', ':']) {
            self.json.push(',');
        }
        Ok(())
    }

    fn key(&mut self, name: &str) -> Result<(), ReadError> {
        self.value_of_text(name)?;
        self.reserve(1)?;
        self.json.push(':');
        Ok(())
    }

    fn value(&mut self, text: &str) -> Result<(), ReadError> {
        self.separate()?;
        self.reserve(text.len())?;
        self.json.push_str(text);
        Ok(())
    }

    fn value_of_text(&mut self, text: &str) -> Result<(), ReadError> {
        self.separate()?;
        // A character may take 6 bytes where it took one.
        self.reserve(6 * text.len() + 2)?;
        push_text(&mut self.json, text);
        Ok(())
    }

    fn value_of_number(&mut self, number: f64) -> Result<(), ReadError> {
        const MAX_DIGITS: usize = 32;
        self.separate()?;
        self.reserve(MAX_DIGITS)?;
        push_number(&mut self.json, number);
        Ok(())
    }

    fn value_of_optional(&mut self, number: Option<f64>) -> Result<(), ReadError> {
        if let Some(number) = number { self.value_of_number(number) } else { self.value("null") }
    }

    fn object(&mut self, members: impl FnOnce(&mut Self) -> Result<(), ReadError>) -> Result<(), ReadError> {
        self.value("{")?;
        members(self)?;
        self.reserve(1)?;
        self.json.push('}');
        Ok(())
    }

    fn list<T>(
        &mut self,
        name: &str,
        items: &[T],
        mut write: impl FnMut(&mut Self, &T) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        self.key(name)?;
        self.value("[")?;
        items.iter().try_for_each(|item| write(self, item))?;
        self.reserve(1)?;
        self.json.push(']');
        Ok(())
    }

    fn text(&mut self, name: &str, text: &str) -> Result<(), ReadError> {
        self.key(name)?;
        self.value_of_text(text)
    }

    fn number(&mut self, name: &str, number: f64) -> Result<(), ReadError> {
        self.key(name)?;
        self.value_of_number(number)
    }

    fn optional_number(&mut self, name: &str, number: Option<f64>) -> Result<(), ReadError> {
        self.key(name)?;
        self.value_of_optional(number)
    }

    fn flag(&mut self, name: &str, flag: bool) -> Result<(), ReadError> {
        self.key(name)?;
        self.value(if flag { "true" } else { "false" })
    }

    /// Appends an array of `width` numbers for each element.
    fn array<T: NoUninit>(&mut self, name: &str, kind: &str, width: usize, values: &[T]) -> Result<(), ReadError> {
        const ALIGNMENT: usize = 8;
        let bytes: &[u8] = bytemuck::cast_slice(values);
        alloc::reserve(&mut self.arrays, bytes.len() + ALIGNMENT)?;
        self.arrays.resize(self.arrays.len().next_multiple_of(ALIGNMENT), 0);
        let at = self.arrays.len();
        self.arrays.extend_from_slice(bytes);
        self.key(name)?;
        self.object(|packer| {
            packer.number("at", at as f64)?;
            packer.number("count", values.len() as f64)?;
            packer.text("type", kind)?;
            packer.number("width", width as f64)
        })
    }

    /// Appends an array that is absent if it is empty.
    fn optional<T: NoUninit>(&mut self, name: &str, kind: &str, width: usize, values: &[T]) -> Result<(), ReadError> {
        if values.is_empty() {
            self.key(name)?;
            return self.value("null");
        }
        self.array(name, kind, width, values)
    }

    fn positions(&mut self, positions: &Positions) -> Result<(), ReadError> {
        match positions {
            Positions::F32(points) => self.array("positions", "f32", 3, points),
            Positions::F64(points) => self.array("positions", "f64", 3, points),
        }
    }

    fn attribute<const N: usize>(&mut self, name: &str, values: &Values<N>) -> Result<(), ReadError> {
        self.key(name)?;
        let (at_corners, values) = match values {
            Values::Absent => return self.value("null"),
            Values::Vertices(values) => (false, values),
            Values::Corners(values) => (true, values),
        };
        self.object(|packer| {
            packer.flag("at_corners", at_corners)?;
            packer.array("values", "f64", N, values)
        })
    }

    fn mesh(&mut self, mesh: &Mesh) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.text("name", &mesh.name)?;
            packer.positions(&mesh.positions)?;
            packer.array("face_offsets", "u32", 1, &mesh.face_offsets)?;
            packer.array("corners", "u32", 1, &mesh.corners)?;
            packer.optional("merge", "u32", 1, &mesh.merge)?;
            packer.attribute("normals", &mesh.normals)?;
            packer.attribute("texcoords", &mesh.texcoords)?;
            packer.optional("vertex_colours", "f32", 4, &mesh.vertex_colours)?;
            packer.optional("face_colours", "f32", 4, &mesh.face_colours)?;
            packer.optional("face_materials", "u32", 1, &mesh.face_materials)?;
            packer.list("properties", &mesh.properties, Self::property)
        })
    }

    fn property(&mut self, property: &Property) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.text("name", &property.name)?;
            packer.text("kind", kind_name(property.kind))?;
            packer.flag("at_faces", property.domain == Domain::Faces)?;
            packer.array("values", "f64", 1, &property.values)
        })
    }

    fn curves(&mut self, curves: &Curves) -> Result<(), ReadError> {
        let closed = alloc::collect(curves.closed.iter().map(|&closed| u8::from(closed)))?;
        self.object(|packer| {
            packer.positions(&curves.positions)?;
            packer.array("offsets", "u32", 1, &curves.offsets)?;
            packer.array("closed", "u8", 1, &closed)
        })
    }

    fn points(&mut self, points: &PointCloud) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.positions(&points.positions)?;
            packer.optional("normals", "f64", 3, &points.normals)?;
            packer.optional("colours", "f32", 4, &points.colours)
        })
    }

    fn image(&mut self, image: &Image) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.text("name", &image.name)?;
            packer.text("media_type", &image.media_type)?;
            match &image.data {
                ImageData::File(name) => packer.text("file", name),
                ImageData::Bytes(bytes) => packer.array("bytes", "u8", 1, bytes),
            }
        })
    }

    fn material(&mut self, material: &Material) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.text("name", &material.name)?;
            packer.list("colour", &material.colour, |packer, &part| packer.value_of_number(f64::from(part)))?;
            packer.optional_number("image", material.image.map(f64::from))?;
            packer.key("native")?;
            match &material.native {
                None => packer.value("null"),
                Some(NativeMaterial::Mtl(lines)) => packer
                    .object(|packer| packer.list("mtl", lines, |packer, line: &String| packer.value_of_text(line))),
                Some(NativeMaterial::Gltf { material, textures }) => packer.object(|packer| {
                    packer.text("gltf", material)?;
                    packer.list("textures", textures, Self::texture)
                }),
            }
        })
    }

    fn texture(&mut self, (sampler, image): &(String, Option<u32>)) -> Result<(), ReadError> {
        self.value("[")?;
        self.value_of_text(sampler)?;
        self.value_of_optional(image.map(f64::from))?;
        self.reserve(1)?;
        self.json.push(']');
        Ok(())
    }

    fn note(&mut self, note: &Note) -> Result<(), ReadError> {
        self.object(|packer| {
            packer.text("text", &note.text)?;
            match note.place {
                Place::Whole => Ok(()),
                Place::Line(line) => packer.number("line", line as f64),
                Place::Byte(byte) => packer.number("byte", byte as f64),
            }
        })
    }
}

/// Names of the types of properties.
pub(super) const KIND_NAMES: [(NumberKind, &str); 8] = [
    (NumberKind::I8, "i8"),
    (NumberKind::U8, "u8"),
    (NumberKind::I16, "i16"),
    (NumberKind::U16, "u16"),
    (NumberKind::I32, "i32"),
    (NumberKind::U32, "u32"),
    (NumberKind::F32, "f32"),
    (NumberKind::F64, "f64"),
];

fn kind_name(kind: NumberKind) -> &'static str {
    KIND_NAMES.iter().find(|(one, _)| *one == kind).map_or("f64", |(_, name)| name)
}
