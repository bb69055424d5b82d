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
    packer.write_object(|packer| {
        packer.write_list("meshes", &document.meshes, Packer::pack_mesh)?;
        packer.write_list("placements", &document.placements, |packer, placement| {
            packer.write_object(|packer| {
                packer.write_text("name", &placement.name)?;
                packer.write_number("mesh", f64::from(placement.mesh))
            })
        })?;
        let transforms = alloc::collect(document.placements.iter().map(|placement| placement.transform))?;
        packer.write_array("transforms", "f64", 12, &transforms)?;
        packer.write_key("curves")?;
        packer.pack_curves(&document.curves)?;
        packer.write_key("points")?;
        packer.pack_points(&document.points)?;
        packer.write_list("materials", &document.materials, Packer::pack_material)?;
        packer.write_list("images", &document.images, Packer::pack_image)?;
        packer.write_optional_number("metres_per_unit", document.metres_per_unit)?;
        packer.write_list("notes", &document.notes, Packer::pack_note)
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
    fn write_comma_if_needed(&mut self) -> Result<(), ReadError> {
        self.reserve(1)?;
        if !self.json.is_empty() && !self.json.ends_with(['{', '[', ':']) {
            self.json.push(',');
        }
        Ok(())
    }

    fn write_key(&mut self, name: &str) -> Result<(), ReadError> {
        self.write_value_of_text(name)?;
        self.reserve(1)?;
        self.json.push(':');
        Ok(())
    }

    fn write_value(&mut self, text: &str) -> Result<(), ReadError> {
        self.write_comma_if_needed()?;
        self.reserve(text.len())?;
        self.json.push_str(text);
        Ok(())
    }

    fn write_value_of_text(&mut self, text: &str) -> Result<(), ReadError> {
        self.write_comma_if_needed()?;
        // A character may take 6 bytes where it took one.
        self.reserve(6 * text.len() + 2)?;
        push_text(&mut self.json, text);
        Ok(())
    }

    fn write_value_of_number(&mut self, number: f64) -> Result<(), ReadError> {
        const MAX_DIGITS: usize = 32;
        self.write_comma_if_needed()?;
        self.reserve(MAX_DIGITS)?;
        push_number(&mut self.json, number);
        Ok(())
    }

    fn write_value_of_optional(&mut self, number: Option<f64>) -> Result<(), ReadError> {
        if let Some(number) = number { self.write_value_of_number(number) } else { self.write_value("null") }
    }

    fn write_object(&mut self, members: impl FnOnce(&mut Self) -> Result<(), ReadError>) -> Result<(), ReadError> {
        self.write_value("{")?;
        members(self)?;
        self.reserve(1)?;
        self.json.push('}');
        Ok(())
    }

    fn write_list<T>(
        &mut self,
        name: &str,
        items: &[T],
        mut write: impl FnMut(&mut Self, &T) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        self.write_key(name)?;
        self.write_value("[")?;
        items.iter().try_for_each(|item| write(self, item))?;
        self.reserve(1)?;
        self.json.push(']');
        Ok(())
    }

    fn write_text(&mut self, name: &str, text: &str) -> Result<(), ReadError> {
        self.write_key(name)?;
        self.write_value_of_text(text)
    }

    fn write_number(&mut self, name: &str, number: f64) -> Result<(), ReadError> {
        self.write_key(name)?;
        self.write_value_of_number(number)
    }

    fn write_optional_number(&mut self, name: &str, number: Option<f64>) -> Result<(), ReadError> {
        self.write_key(name)?;
        self.write_value_of_optional(number)
    }

    fn write_flag(&mut self, name: &str, flag: bool) -> Result<(), ReadError> {
        self.write_key(name)?;
        self.write_value(if flag { "true" } else { "false" })
    }

    /// Appends an array of `width` numbers for each element.
    fn write_array<T: NoUninit>(
        &mut self,
        name: &str,
        kind: &str,
        width: usize,
        values: &[T],
    ) -> Result<(), ReadError> {
        const ALIGNMENT: usize = 8;
        let bytes: &[u8] = bytemuck::cast_slice(values);
        alloc::reserve(&mut self.arrays, bytes.len() + ALIGNMENT)?;
        self.arrays.resize(self.arrays.len().next_multiple_of(ALIGNMENT), 0);
        let at = self.arrays.len();
        self.arrays.extend_from_slice(bytes);
        self.write_key(name)?;
        self.write_object(|packer| {
            packer.write_number("at", at as f64)?;
            packer.write_number("count", values.len() as f64)?;
            packer.write_text("type", kind)?;
            packer.write_number("width", width as f64)
        })
    }

    /// Appends an array that is absent if it is empty.
    fn write_optional<T: NoUninit>(
        &mut self,
        name: &str,
        kind: &str,
        width: usize,
        values: &[T],
    ) -> Result<(), ReadError> {
        if values.is_empty() {
            self.write_key(name)?;
            return self.write_value("null");
        }
        self.write_array(name, kind, width, values)
    }

    fn pack_positions(&mut self, positions: &Positions) -> Result<(), ReadError> {
        match positions {
            Positions::F32(points) => self.write_array("positions", "f32", 3, points),
            Positions::F64(points) => self.write_array("positions", "f64", 3, points),
        }
    }

    fn pack_attribute<const N: usize>(&mut self, name: &str, values: &Values<N>) -> Result<(), ReadError> {
        self.write_key(name)?;
        let (at_corners, values) = match values {
            Values::Absent => return self.write_value("null"),
            Values::Vertices(values) => (false, values),
            Values::Corners(values) => (true, values),
        };
        self.write_object(|packer| {
            packer.write_flag("at_corners", at_corners)?;
            packer.write_array("values", "f64", N, values)
        })
    }

    fn pack_mesh(&mut self, mesh: &Mesh) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.write_text("name", &mesh.name)?;
            packer.pack_positions(&mesh.positions)?;
            packer.write_array("face_offsets", "u32", 1, &mesh.face_offsets)?;
            packer.write_array("corners", "u32", 1, &mesh.corners)?;
            packer.write_optional("merge", "u32", 1, &mesh.merge)?;
            packer.pack_attribute("normals", &mesh.normals)?;
            packer.pack_attribute("texcoords", &mesh.texcoords)?;
            packer.write_optional("vertex_colours", "f32", 4, &mesh.vertex_colours)?;
            packer.write_optional("face_colours", "f32", 4, &mesh.face_colours)?;
            packer.write_optional("face_materials", "u32", 1, &mesh.face_materials)?;
            packer.write_list("properties", &mesh.properties, Self::pack_property)
        })
    }

    fn pack_property(&mut self, property: &Property) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.write_text("name", &property.name)?;
            packer.write_text("kind", kind_name(property.kind))?;
            packer.write_flag("at_faces", property.domain == Domain::Faces)?;
            packer.write_array("values", "f64", 1, &property.values)
        })
    }

    fn pack_curves(&mut self, curves: &Curves) -> Result<(), ReadError> {
        let closed = alloc::collect(curves.closed.iter().map(|&closed| u8::from(closed)))?;
        self.write_object(|packer| {
            packer.pack_positions(&curves.positions)?;
            packer.write_array("offsets", "u32", 1, &curves.offsets)?;
            packer.write_array("closed", "u8", 1, &closed)
        })
    }

    fn pack_points(&mut self, points: &PointCloud) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.pack_positions(&points.positions)?;
            packer.write_optional("normals", "f64", 3, &points.normals)?;
            packer.write_optional("colours", "f32", 4, &points.colours)
        })
    }

    fn pack_image(&mut self, image: &Image) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.write_text("name", &image.name)?;
            packer.write_text("media_type", &image.media_type)?;
            match &image.data {
                ImageData::File(name) => packer.write_text("file", name),
                ImageData::Bytes(bytes) => packer.write_array("bytes", "u8", 1, bytes),
            }
        })
    }

    fn pack_material(&mut self, material: &Material) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.write_text("name", &material.name)?;
            packer.write_list("colour", &material.colour, |packer, &part| {
                packer.write_value_of_number(f64::from(part))
            })?;
            packer.write_optional_number("image", material.image.map(f64::from))?;
            packer.write_key("native")?;
            match &material.native {
                None => packer.write_value("null"),
                Some(NativeMaterial::Mtl(lines)) => packer.write_object(|packer| {
                    packer.write_list("mtl", lines, |packer, line: &String| packer.write_value_of_text(line))
                }),
                Some(NativeMaterial::Gltf { material, textures }) => packer.write_object(|packer| {
                    packer.write_text("gltf", material)?;
                    packer.write_list("textures", textures, Self::pack_texture)
                }),
            }
        })
    }

    fn pack_texture(&mut self, (sampler, image): &(String, Option<u32>)) -> Result<(), ReadError> {
        self.write_value("[")?;
        self.write_value_of_text(sampler)?;
        self.write_value_of_optional(image.map(f64::from))?;
        self.reserve(1)?;
        self.json.push(']');
        Ok(())
    }

    fn pack_note(&mut self, note: &Note) -> Result<(), ReadError> {
        self.write_object(|packer| {
            packer.write_text("text", &note.text)?;
            match note.place {
                Place::Whole => Ok(()),
                Place::Line(line) => packer.write_number("line", line as f64),
                Place::Byte(byte) => packer.write_number("byte", byte as f64),
            }
        })
    }
}

/// The number types of properties, with their names in descriptions.
pub(super) const NUMBER_KIND_NAMES: [(NumberKind, &str); 8] = [
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
    NUMBER_KIND_NAMES.iter().find(|(one, _)| *one == kind).map_or("f64", |(_, name)| name)
}
