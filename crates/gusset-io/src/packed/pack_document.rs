//! Writes documents in the packed form.

use super::Packed;
use crate::document::{Curves, Document, PointCloud};
use crate::error::{Note, Place, ReadError};
use crate::material::{Image, ImageData, Material, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use bytemuck::NoUninit;
use serde_json::{Value, json};

/// Packs a document.
///
/// # Errors
/// `OutOfMemory`.
pub fn pack(document: &Document) -> Result<Packed, ReadError> {
    let mut arrays = Arrays::default();
    let meshes = document.meshes.iter().map(|mesh| arrays.mesh(mesh)).collect::<Result<Vec<_>, _>>()?;
    let transforms: Vec<[[f64; 4]; 3]> = document.placements.iter().map(|placement| placement.transform).collect();
    let placements: Vec<Value> =
        document.placements.iter().map(|placement| json!({ "name": placement.name, "mesh": placement.mesh })).collect();
    let description = json!({
        "meshes": meshes,
        "placements": placements,
        "transforms": arrays.add("f64", 12, &transforms)?,
        "curves": arrays.curves(&document.curves)?,
        "points": arrays.points(&document.points)?,
        "materials": document.materials.iter().map(describe_material).collect::<Vec<_>>(),
        "images": document.images.iter().map(|image| arrays.image(image)).collect::<Result<Vec<_>, _>>()?,
        "metres_per_unit": document.metres_per_unit,
        "notes": document.notes.iter().map(describe_note).collect::<Vec<_>>(),
    });
    Ok(Packed { description: description.to_string(), arrays: arrays.bytes })
}

/// Bytes of the arrays so far.
#[derive(Default)]
struct Arrays {
    bytes: Vec<u8>,
}

impl Arrays {
    /// Appends an array. Returns its description.
    fn add<T: NoUninit>(&mut self, kind: &str, width: usize, values: &[T]) -> Result<Value, ReadError> {
        const ALIGNMENT: usize = 8;
        let bytes: &[u8] = bytemuck::cast_slice(values);
        self.bytes.try_reserve(bytes.len() + ALIGNMENT)?;
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
        let at = self.bytes.len();
        self.bytes.extend_from_slice(bytes);
        Ok(json!({ "at": at, "count": values.len(), "type": kind, "width": width }))
    }

    /// Appends an array that may be absent, as an empty one.
    fn optional<T: NoUninit>(&mut self, kind: &str, width: usize, values: &[T]) -> Result<Value, ReadError> {
        if values.is_empty() { Ok(Value::Null) } else { self.add(kind, width, values) }
    }

    fn positions(&mut self, positions: &Positions) -> Result<Value, ReadError> {
        match positions {
            Positions::F32(points) => self.add("f32", 3, points),
            Positions::F64(points) => self.add("f64", 3, points),
        }
    }

    fn attribute<const N: usize>(&mut self, values: &Values<N>) -> Result<Value, ReadError> {
        let (at_corners, values) = match values {
            Values::Absent => return Ok(Value::Null),
            Values::Vertices(values) => (false, values),
            Values::Corners(values) => (true, values),
        };
        let flat: &[f64] = values.as_flattened();
        let mut described = self.add("f64", N, flat)?;
        described["count"] = json!(values.len());
        Ok(json!({ "at_corners": at_corners, "values": described }))
    }

    fn mesh(&mut self, mesh: &Mesh) -> Result<Value, ReadError> {
        Ok(json!({
            "name": mesh.name,
            "positions": self.positions(&mesh.positions)?,
            "face_offsets": self.add("u32", 1, &mesh.face_offsets)?,
            "corners": self.add("u32", 1, &mesh.corners)?,
            "merge": self.optional("u32", 1, &mesh.merge)?,
            "normals": self.attribute(&mesh.normals)?,
            "texcoords": self.attribute(&mesh.texcoords)?,
            "vertex_colours": self.optional("f32", 4, &mesh.vertex_colours)?,
            "face_colours": self.optional("f32", 4, &mesh.face_colours)?,
            "face_materials": self.optional("u32", 1, &mesh.face_materials)?,
            "properties": mesh.properties.iter().map(|property| self.property(property)).collect::<Result<Vec<_>, _>>()?,
        }))
    }

    fn property(&mut self, property: &Property) -> Result<Value, ReadError> {
        Ok(json!({
            "name": property.name,
            "kind": kind_name(property.kind),
            "at_faces": property.domain == Domain::Faces,
            "values": self.add("f64", 1, &property.values)?,
        }))
    }

    fn curves(&mut self, curves: &Curves) -> Result<Value, ReadError> {
        let closed: Vec<u8> = curves.closed.iter().map(|&closed| u8::from(closed)).collect();
        Ok(json!({
            "positions": self.positions(&curves.positions)?,
            "offsets": self.add("u32", 1, &curves.offsets)?,
            "closed": self.add("u8", 1, &closed)?,
        }))
    }

    fn points(&mut self, points: &PointCloud) -> Result<Value, ReadError> {
        Ok(json!({
            "positions": self.positions(&points.positions)?,
            "normals": self.optional("f64", 3, &points.normals)?,
            "colours": self.optional("f32", 4, &points.colours)?,
        }))
    }

    fn image(&mut self, image: &Image) -> Result<Value, ReadError> {
        let mut described = json!({ "name": image.name, "media_type": image.media_type });
        match &image.data {
            ImageData::File(name) => described["file"] = json!(name),
            ImageData::Bytes(bytes) => described["bytes"] = self.add("u8", 1, bytes)?,
        }
        Ok(described)
    }
}

fn describe_material(material: &Material) -> Value {
    let native = match &material.native {
        None => Value::Null,
        Some(NativeMaterial::Mtl(lines)) => json!({ "mtl": lines }),
        Some(NativeMaterial::Gltf { material, textures }) => {
            json!({ "gltf": &**material, "textures": textures.iter().map(|(sampler, image)| json!([sampler, image])).collect::<Vec<_>>() })
        }
    };
    json!({ "name": material.name, "colour": material.colour, "image": material.image, "native": native })
}

fn describe_note(note: &Note) -> Value {
    match note.place {
        Place::Whole => json!({ "text": note.text }),
        Place::Line(line) => json!({ "text": note.text, "line": line }),
        Place::Byte(byte) => json!({ "text": note.text, "byte": byte }),
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
