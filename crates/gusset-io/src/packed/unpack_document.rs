//! Reads documents from the packed form, which a host has made.

use super::pack_document::KIND_NAMES;
use crate::document::{Curves, Document, Placement, PointCloud};
use crate::error::{Place, ReadError};
use crate::material::{Image, ImageData, Material, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use bytemuck::AnyBitPattern;
use serde_json::Value;

/// Unpacks a document. Members that are absent or `null` are empty.
///
/// # Errors
/// `Malformed`, with the name of the member, if the text is not of this form, an array leaves `arrays`, or an index does not exist.
/// `OutOfMemory`.
pub fn unpack(description: &str, arrays: &[u8]) -> Result<Document, ReadError> {
    let root: Value =
        serde_json::from_str(description).map_err(|error| wrong(&format!("the description is not JSON: {error}")))?;
    let packed = PackedArrays { arrays };
    let mut document = Document {
        meshes: list(&root["meshes"], "meshes")?.iter().map(|mesh| packed.mesh(mesh)).collect::<Result<_, _>>()?,
        curves: packed.curves(&root["curves"])?,
        points: packed.points(&root["points"])?,
        materials: list(&root["materials"], "materials")?.iter().map(material).collect::<Result<_, _>>()?,
        images: list(&root["images"], "images")?.iter().map(|image| packed.image(image)).collect::<Result<_, _>>()?,
        metres_per_unit: root["metres_per_unit"].as_f64().filter(|metres| *metres > 0.0 && metres.is_finite()),
        ..Document::default()
    };
    document.placements = packed.placements(&root, document.meshes.len())?;
    document.check()?;
    Ok(document)
}

struct PackedArrays<'a> {
    arrays: &'a [u8],
}

fn wrong(message: &str) -> ReadError {
    ReadError::malformed(Place::Whole, message)
}

/// Returns the items of a list; none if it is absent.
fn list<'a>(value: &'a Value, name: &str) -> Result<&'a [Value], ReadError> {
    match value {
        Value::Null => Ok(&[]),
        Value::Array(items) => Ok(items),
        _ => Err(wrong(&format!("{name} is not a list"))),
    }
}

/// Returns a text; empty if it is absent.
fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

fn index(value: &Value, name: &str) -> Result<u32, ReadError> {
    value.as_u64().and_then(|index| u32::try_from(index).ok()).ok_or_else(|| wrong(&format!("{name} is not an index")))
}

impl PackedArrays<'_> {
    /// Returns the elements of an array, each of `WIDTH` numbers; none if it is absent.
    fn array<T: AnyBitPattern, const WIDTH: usize>(
        &self,
        value: &Value,
        kind: &str,
        name: &str,
    ) -> Result<Vec<[T; WIDTH]>, ReadError> {
        if value.is_null() {
            return Ok(Vec::new());
        }
        let is_right = value["type"] == kind && value["width"].as_u64() == Some(WIDTH as u64);
        let range = value["at"].as_u64().zip(value["count"].as_u64()).and_then(|(at, count)| {
            let at = usize::try_from(at).ok()?;
            let size = usize::try_from(count).ok()?.checked_mul(WIDTH * size_of::<T>())?;
            self.arrays.get(at..at.checked_add(size)?)
        });
        let Some(bytes) = range.filter(|_| is_right) else {
            return Err(wrong(&format!("{name} is not an array of {WIDTH} x {kind} within the given bytes")));
        };
        let mut values = Vec::new();
        values.try_reserve_exact(bytes.len() / (WIDTH * size_of::<T>()))?;
        let item = |chunk: &[u8]| {
            std::array::from_fn(|place| {
                bytemuck::pod_read_unaligned(&chunk[place * size_of::<T>()..][..size_of::<T>()])
            })
        };
        values.extend(bytes.chunks_exact(WIDTH * size_of::<T>()).map(item));
        Ok(values)
    }

    fn numbers<T: AnyBitPattern>(&self, value: &Value, kind: &str, name: &str) -> Result<Vec<T>, ReadError> {
        Ok(self.array::<T, 1>(value, kind, name)?.into_iter().map(|[value]| value).collect())
    }

    fn positions(&self, value: &Value, name: &str) -> Result<Positions, ReadError> {
        if value["type"] == "f32" {
            return Ok(Positions::F32(self.array(value, "f32", name)?));
        }
        Ok(Positions::F64(self.array(value, "f64", name)?))
    }

    fn attribute<const N: usize>(&self, value: &Value, name: &str) -> Result<Values<N>, ReadError> {
        if value.is_null() {
            return Ok(Values::Absent);
        }
        let values = self.array(&value["values"], "f64", name)?;
        Ok(if value["at_corners"] == true { Values::Corners(values) } else { Values::Vertices(values) })
    }

    fn mesh(&self, value: &Value) -> Result<Mesh, ReadError> {
        let mut face_offsets = self.numbers(&value["face_offsets"], "u32", "face_offsets")?;
        if face_offsets.is_empty() {
            face_offsets.push(0);
        }
        Ok(Mesh {
            name: text(&value["name"]),
            positions: self.positions(&value["positions"], "positions")?,
            face_offsets,
            corners: self.numbers(&value["corners"], "u32", "corners")?,
            merge: self.numbers(&value["merge"], "u32", "merge")?,
            normals: self.attribute(&value["normals"], "normals")?,
            texcoords: self.attribute(&value["texcoords"], "texcoords")?,
            vertex_colours: self.array(&value["vertex_colours"], "f32", "vertex_colours")?,
            face_colours: self.array(&value["face_colours"], "f32", "face_colours")?,
            face_materials: self.numbers(&value["face_materials"], "u32", "face_materials")?,
            properties: list(&value["properties"], "properties")?
                .iter()
                .map(|one| self.property(one))
                .collect::<Result<_, _>>()?,
        })
    }

    fn property(&self, value: &Value) -> Result<Property, ReadError> {
        let kind =
            KIND_NAMES.iter().find(|(_, name)| value["kind"] == *name).map_or(NumberKind::F64, |(kind, _)| *kind);
        let domain = if value["at_faces"] == true { Domain::Faces } else { Domain::Vertices };
        Ok(Property {
            name: text(&value["name"]),
            kind,
            domain,
            values: self.numbers(&value["values"], "f64", "values")?,
        })
    }

    fn curves(&self, value: &Value) -> Result<Curves, ReadError> {
        let mut offsets = self.numbers(&value["offsets"], "u32", "offsets")?;
        if offsets.is_empty() {
            offsets.push(0);
        }
        let closed: Vec<u8> = self.numbers(&value["closed"], "u8", "closed")?;
        let positions = self.positions(&value["positions"], "positions of curves")?;
        Ok(Curves { positions, offsets, closed: closed.into_iter().map(|closed| closed != 0).collect() })
    }

    fn points(&self, value: &Value) -> Result<PointCloud, ReadError> {
        Ok(PointCloud {
            positions: self.positions(&value["positions"], "positions of points")?,
            normals: self.array(&value["normals"], "f64", "normals of points")?,
            colours: self.array(&value["colours"], "f32", "colours of points")?,
        })
    }

    /// Returns the scene; each mesh once, unmoved, if the text names none.
    fn placements(&self, root: &Value, mesh_count: usize) -> Result<Vec<Placement>, ReadError> {
        if root["placements"].is_null() {
            return Ok((0..mesh_count as u32)
                .map(|mesh| Placement { name: String::new(), mesh, transform: Placement::IDENTITY })
                .collect());
        }
        let transforms: Vec<[f64; 12]> = self.array(&root["transforms"], "f64", "transforms")?;
        let placements = list(&root["placements"], "placements")?;
        if transforms.len() != placements.len() {
            return Err(wrong("placements and transforms have different counts"));
        }
        let placement = |(value, rows): (&Value, [f64; 12])| {
            let transform = std::array::from_fn(|row| std::array::from_fn(|column| rows[4 * row + column]));
            Ok(Placement { name: text(&value["name"]), mesh: index(&value["mesh"], "mesh of a placement")?, transform })
        };
        placements.iter().zip(transforms).map(placement).collect()
    }

    fn image(&self, value: &Value) -> Result<Image, ReadError> {
        let data = match value["file"].as_str() {
            Some(name) => ImageData::File(name.to_owned()),
            None => ImageData::Bytes(self.numbers::<u8>(&value["bytes"], "u8", "bytes of an image")?.into()),
        };
        Ok(Image { name: text(&value["name"]), media_type: text(&value["media_type"]), data })
    }
}

fn optional_index(value: &Value, name: &str) -> Result<Option<u32>, ReadError> {
    if value.is_null() { Ok(None) } else { index(value, name).map(Some) }
}

fn material(value: &Value) -> Result<Material, ReadError> {
    let mut colour = [1.0; 4];
    for (part, given) in colour.iter_mut().zip(list(&value["colour"], "colour")?) {
        *part = given.as_f64().map_or(1.0, |given| given as f32);
    }
    let native = &value["native"];
    let native = if let Some(material) = native["gltf"].as_str() {
        let texture = |one: &Value| Ok((text(&one[0]), optional_index(&one[1], "image of a texture")?));
        let textures: Vec<_> =
            list(&native["textures"], "textures")?.iter().map(texture).collect::<Result<_, ReadError>>()?;
        Some(NativeMaterial::Gltf { material: material.into(), textures: textures.into() })
    } else if native["mtl"].is_null() {
        None
    } else {
        Some(NativeMaterial::Mtl(list(&native["mtl"], "mtl")?.iter().map(text).collect()))
    };
    Ok(Material {
        name: text(&value["name"]),
        colour,
        image: optional_index(&value["image"], "image of a material")?,
        native,
    })
}
