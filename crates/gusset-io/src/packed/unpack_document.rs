//! Reads documents from the packed form, which a host has made.

use super::pack_document::NUMBER_KIND_NAMES;
use crate::document::{Curves, Document, Placement, PointCloud};
use crate::error::{Place, ReadError};
use crate::json_tape::{OUT_OF_MEMORY, Tape, Value};
use crate::material::{Image, ImageData, Material, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use crate::parallel_fill::make_vector;
use crate::text_encoding::owned_text;
use bytemuck::AnyBitPattern;
use gusset_base::alloc;
use std::sync::Arc;

/// Unpacks a document. Members that are absent or `null` are empty.
///
/// # Errors
/// `Malformed`, with the name of the member, if the text is not of this form, an array leaves `arrays`, or an index does not exist.
/// `OutOfMemory`.
pub fn unpack(description: &str, arrays: &[u8]) -> Result<Document, ReadError> {
    let tape = Tape::parse(description.as_bytes()).map_err(|error| match error.message {
        OUT_OF_MEMORY => ReadError::out_of_memory(),
        message => wrong(&format!("the description is not JSON: {message}")),
    })?;
    let unpacked = PackedArrays { arrays }.unpack_document(tape.root());
    tape.check_memory()?;
    unpacked
}

struct PackedArrays<'a> {
    arrays: &'a [u8],
}

fn wrong(message: &str) -> ReadError {
    ReadError::malformed(Place::Whole, message)
}

/// Makes the items of a list; none if it is absent.
fn list<'t, T>(
    parent: Value<'t>,
    name: &str,
    mut item: impl FnMut(Value<'t>) -> Result<T, ReadError>,
) -> Result<Vec<T>, ReadError> {
    let Some(value) = parent.get(name) else { return Ok(Vec::new()) };
    if !value.is_array() {
        return Err(wrong(&format!("{name} is not a list")));
    }
    alloc::try_collect(value.items().map(|value| {
        alloc::check_reserve()?;
        item(value)
    }))
}

/// Returns a text; empty if it is absent.
fn text(value: Option<Value<'_>>) -> Result<String, ReadError> {
    owned_text(value.and_then(Value::text).unwrap_or_default().as_bytes())
}

fn index(value: Option<Value<'_>>, name: &str) -> Result<u32, ReadError> {
    let index = value.and_then(Value::whole_number).and_then(|index| u32::try_from(index).ok());
    index.ok_or_else(|| wrong(&format!("{name} is not an index")))
}

fn is_true(parent: Value<'_>, name: &str) -> bool {
    parent.get(name).is_some_and(Value::is_true)
}

impl PackedArrays<'_> {
    fn unpack_document(&self, root: Value<'_>) -> Result<Document, ReadError> {
        let mut document = Document {
            meshes: list(root, "meshes", |mesh| self.unpack_mesh(mesh))?,
            curves: root.get("curves").map_or_else(|| Ok(Curves::default()), |curves| self.unpack_curves(curves))?,
            points: root
                .get("points")
                .map_or_else(|| Ok(PointCloud::default()), |points| self.unpack_points(points))?,
            materials: list(root, "materials", material)?,
            images: list(root, "images", |image| self.unpack_image(image))?,
            metres_per_unit: root.get("metres_per_unit").and_then(Value::number),
            ..Document::default()
        };
        document.metres_per_unit = document.metres_per_unit.filter(|metres| *metres > 0.0 && metres.is_finite());
        document.placements = self.unpack_placements(root, document.meshes.len())?;
        document.check()?;
        Ok(document)
    }

    /// Returns the elements of an array, each of `WIDTH` numbers; none if it is absent.
    fn unpack_array<T: AnyBitPattern + Send, const WIDTH: usize>(
        &self,
        value: Option<Value<'_>>,
        kind: &str,
        name: &str,
    ) -> Result<Vec<[T; WIDTH]>, ReadError> {
        let Some(value) = value else { return Ok(Vec::new()) };
        let number = |name| value.get(name).and_then(Value::whole_number);
        let is_right = value.get("type").is_some_and(|own| own.equals_text(kind))
            && number("width").is_some_and(|own| own == WIDTH as u64);
        let range = number("at").zip(number("count")).and_then(|(at, count)| {
            let at = usize::try_from(at).ok()?;
            let size = usize::try_from(count).ok()?.checked_mul(WIDTH * size_of::<T>())?;
            self.arrays.get(at..at.checked_add(size)?)
        });
        let Some(bytes) = range.filter(|_| is_right) else {
            return Err(wrong(&format!("{name} is not an array of {WIDTH} x {kind} within the given bytes")));
        };
        let size = WIDTH * size_of::<T>();
        let number = |start: usize| bytemuck::pod_read_unaligned(&bytes[start..][..size_of::<T>()]);
        make_vector(bytes.len() / size, |item| {
            std::array::from_fn(|place| number(item * size + place * size_of::<T>()))
        })
    }

    fn unpack_numbers<T: AnyBitPattern + Send>(
        &self,
        value: Option<Value<'_>>,
        kind: &str,
        name: &str,
    ) -> Result<Vec<T>, ReadError> {
        Ok(self.unpack_array::<T, 1>(value, kind, name)?.into_flattened())
    }

    /// Returns offsets, which begin with 0.
    fn unpack_offsets(&self, parent: Value<'_>, name: &str) -> Result<Vec<u32>, ReadError> {
        let mut offsets = self.unpack_numbers(parent.get(name), "u32", name)?;
        if offsets.is_empty() {
            offsets.push(0);
        }
        Ok(offsets)
    }

    fn unpack_positions(&self, value: Option<Value<'_>>, name: &str) -> Result<Positions, ReadError> {
        if value.and_then(|value| value.get("type")).is_some_and(|kind| kind.equals_text("f32")) {
            return Ok(Positions::F32(self.unpack_array(value, "f32", name)?));
        }
        Ok(Positions::F64(self.unpack_array(value, "f64", name)?))
    }

    fn unpack_attribute<const N: usize>(&self, mesh: Value<'_>, name: &str) -> Result<Values<N>, ReadError> {
        let Some(value) = mesh.get(name) else { return Ok(Values::Absent) };
        let values = self.unpack_array(value.get("values"), "f64", name)?;
        Ok(if is_true(value, "at_corners") { Values::Corners(values) } else { Values::Vertices(values) })
    }

    fn unpack_mesh(&self, value: Value<'_>) -> Result<Mesh, ReadError> {
        Ok(Mesh {
            name: text(value.get("name"))?,
            positions: self.unpack_positions(value.get("positions"), "positions")?,
            face_offsets: self.unpack_offsets(value, "face_offsets")?,
            corners: self.unpack_numbers(value.get("corners"), "u32", "corners")?,
            merge: self.unpack_numbers(value.get("merge"), "u32", "merge")?,
            normals: self.unpack_attribute(value, "normals")?,
            texcoords: self.unpack_attribute(value, "texcoords")?,
            vertex_colours: self.unpack_array(value.get("vertex_colours"), "f32", "vertex_colours")?,
            face_colours: self.unpack_array(value.get("face_colours"), "f32", "face_colours")?,
            face_materials: self.unpack_numbers(value.get("face_materials"), "u32", "face_materials")?,
            properties: list(value, "properties", |one| self.unpack_property(one))?,
        })
    }

    fn unpack_property(&self, value: Value<'_>) -> Result<Property, ReadError> {
        let kind = value.get("kind").and_then(|own| NUMBER_KIND_NAMES.iter().find(|(_, name)| own.equals_text(name)));
        let domain = if is_true(value, "at_faces") { Domain::Faces } else { Domain::Vertices };
        Ok(Property {
            name: text(value.get("name"))?,
            kind: kind.map_or(NumberKind::F64, |(kind, _)| *kind),
            domain,
            values: self.unpack_numbers(value.get("values"), "f64", "values")?,
        })
    }

    fn unpack_curves(&self, value: Value<'_>) -> Result<Curves, ReadError> {
        let closed: Vec<u8> = self.unpack_numbers(value.get("closed"), "u8", "closed")?;
        Ok(Curves {
            positions: self.unpack_positions(value.get("positions"), "positions of curves")?,
            offsets: self.unpack_offsets(value, "offsets")?,
            closed: alloc::collect(closed.into_iter().map(|closed| closed != 0))?,
        })
    }

    fn unpack_points(&self, value: Value<'_>) -> Result<PointCloud, ReadError> {
        Ok(PointCloud {
            positions: self.unpack_positions(value.get("positions"), "positions of points")?,
            normals: self.unpack_array(value.get("normals"), "f64", "normals of points")?,
            colours: self.unpack_array(value.get("colours"), "f32", "colours of points")?,
        })
    }

    /// Returns the scene; each mesh once, unmoved, if the text names none.
    fn unpack_placements(&self, root: Value<'_>, mesh_count: usize) -> Result<Vec<Placement>, ReadError> {
        if root.get("placements").is_none() {
            let unmoved = |mesh| Placement { name: String::new(), mesh, transform: Placement::IDENTITY };
            return Ok(alloc::collect((0..mesh_count as u32).map(unmoved))?);
        }
        let transforms: Vec<[f64; 12]> = self.unpack_array(root.get("transforms"), "f64", "transforms")?;
        let mut rows = transforms.iter();
        let mut count = 0;
        let placements = list(root, "placements", |value| {
            count += 1;
            let rows = rows.next().copied().unwrap_or_default();
            let transform = std::array::from_fn(|row| std::array::from_fn(|column| rows[4 * row + column]));
            let mesh = index(value.get("mesh"), "mesh of a placement")?;
            Ok(Placement { name: text(value.get("name"))?, mesh, transform })
        })?;
        if transforms.len() != count {
            return Err(wrong("placements and transforms have different counts"));
        }
        Ok(placements)
    }

    fn unpack_image(&self, value: Value<'_>) -> Result<Image, ReadError> {
        let data = match value.get("file").filter(|name| name.is_text()) {
            Some(name) => ImageData::File(text(Some(name))?),
            None => ImageData::Bytes(Arc::new(self.unpack_numbers(value.get("bytes"), "u8", "bytes of an image")?)),
        };
        Ok(Image { name: text(value.get("name"))?, media_type: text(value.get("media_type"))?, data })
    }
}

fn optional_index(value: Option<Value<'_>>, name: &str) -> Result<Option<u32>, ReadError> {
    value.map(|value| index(Some(value), name)).transpose()
}

fn material(value: Value<'_>) -> Result<Material, ReadError> {
    let mut colour = [1.0; 4];
    let mut parts = colour.iter_mut();
    list(value, "colour", |given| {
        if let (Some(part), Some(given)) = (parts.next(), given.number()) {
            *part = given as f32;
        }
        Ok(())
    })?;
    let native = match value.get("native") {
        None => None,
        Some(native) => native_material(native)?,
    };
    let image = optional_index(value.get("image"), "image of a material")?;
    Ok(Material { name: text(value.get("name"))?, colour, image, native })
}

fn native_material(native: Value<'_>) -> Result<Option<NativeMaterial>, ReadError> {
    if let Some(material) = native.get("gltf").filter(|material| material.is_text()) {
        let textures = list(native, "textures", |one| {
            let mut parts = one.items();
            let (sampler, image) = (parts.next(), parts.next().filter(|image| image.raw_text() != b"null"));
            Ok((text(sampler)?, optional_index(image, "image of a texture")?))
        })?;
        let material = Arc::new(text(Some(material))?);
        return Ok(Some(NativeMaterial::Gltf { material, textures: Arc::new(textures) }));
    }
    if native.get("mtl").is_none() {
        return Ok(None);
    }
    Ok(Some(NativeMaterial::Mtl(list(native, "mtl", |line| text(Some(line)))?)))
}
