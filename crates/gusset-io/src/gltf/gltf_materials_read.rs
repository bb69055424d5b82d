//! Materials as JSON text, with their samplers and images.

use super::base64::decode_percent;
use super::gltf_buffers::{Buffers, data_address, element, malformed};
use super::gltf_colour::srgb_from_linear;
use crate::document::Document;
use crate::error::{Note, Place, ReadError};
use crate::json_tape::Value;
use crate::json_text::{Edit, push_edited};
use crate::material::{Image, ImageData, Material, NativeMaterial};
use gusset_base::alloc;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Extensions of textures that name another image, for programs that can decode it.
pub(super) const IMAGE_EXTENSIONS: [(&str, &str); 4] = [
    ("KHR_texture_basisu", "image/ktx2"),
    ("EXT_texture_webp", "image/webp"),
    ("EXT_texture_avif", "image/avif"),
    ("MSFT_texture_dds", "image/vnd-ms.dds"),
];

/// Members of materials by their types: other programs refuse files in which one has another type.
const OBJECTS: [&str; 7] = [
    "pbrMetallicRoughness",
    "baseColorTexture",
    "metallicRoughnessTexture",
    "normalTexture",
    "occlusionTexture",
    "emissiveTexture",
    "extensions",
];
const LISTS: [&str; 2] = ["baseColorFactor", "emissiveFactor"];
const NUMBERS: [&str; 3] = ["metallicFactor", "roughnessFactor", "alphaCutoff"];

/// Returns the name of a member that has a wrong type.
fn wrong_member(material: Value<'_>) -> Option<&'static str> {
    if !material.is_object() {
        return Some("the material");
    }
    let inner = material.get("pbrMetallicRoughness").into_iter().flat_map(Value::members);
    material.members().chain(inner).find_map(|(key, value)| {
        let named = |names: &[&'static str], is_right: bool| {
            names.iter().find(|name| !is_right && key.equals_text(name)).copied()
        };
        named(&OBJECTS, value.is_object())
            .or_else(|| named(&LISTS, value.is_array()))
            .or_else(|| named(&NUMBERS, value.number().is_some()))
            .or_else(|| named(&["name", "alphaMode"], value.is_text()))
            .or_else(|| named(&["doubleSided"], matches!(value.raw_text(), b"true" | b"false")))
    })
}

/// Reads the materials that faces use, once each.
pub(super) struct MaterialReader<'a> {
    materials: Vec<Value<'a>>,
    textures: Vec<Value<'a>>,
    images: Vec<Value<'a>>,
    samplers: Vec<Value<'a>>,
    /// Indices in the document by indices in the file.
    index_of_known_material: BTreeMap<usize, u32>,
    known_images: BTreeMap<usize, Option<u32>>,
}

impl<'a> MaterialReader<'a> {
    pub(super) fn new(root: Value<'a>) -> Result<Self, ReadError> {
        Ok(Self {
            materials: root.list("materials")?,
            textures: root.list("textures")?,
            images: root.list("images")?,
            samplers: root.list("samplers")?,
            index_of_known_material: BTreeMap::new(),
            known_images: BTreeMap::new(),
        })
    }

    /// Returns the document's index of a material of the file. Adds it to the document at its first use.
    pub(super) fn find_or_read_material(
        &mut self,
        index: usize,
        document: &mut Document,
        buffers: &mut Buffers<'a>,
    ) -> Result<u32, ReadError> {
        if let Some(&known) = self.index_of_known_material.get(&index) {
            return Ok(known);
        }
        let json = element(&self.materials, index, "material")?;
        let made = self.read(json, index, document, buffers)?;
        let place = document.materials.len() as u32;
        alloc::push(&mut document.materials, made)?;
        self.index_of_known_material.insert(index, place);
        alloc::check_reserve()?;
        Ok(place)
    }

    fn read(
        &mut self,
        json: Value<'a>,
        index: usize,
        document: &mut Document,
        buffers: &mut Buffers<'a>,
    ) -> Result<Material, ReadError> {
        let name = json.get("name").and_then(Value::text).filter(|name| !name.is_empty());
        let mut textures: Vec<(String, Option<u32>)> = Vec::new();
        // Indices in `textures` by indices in the file.
        let mut places: BTreeMap<usize, usize> = BTreeMap::new();
        let mut failure = None;
        let mut text = text_for_copy(json)?;
        let is_whole = push_edited(&mut text, json, |parent, key, value| {
            let is_texture = parent.and_then(Value::text).is_some_and(|name| name.ends_with("Texture"));
            if !is_texture || !key.equals_text("index") {
                return Edit::Keep;
            }
            let index = value.whole_number().map_or(usize::MAX, |index| index as usize);
            let next = places.len();
            let place = *places.entry(index).or_insert(next);
            if place == next {
                match self.read_texture(index, document, buffers) {
                    Ok(texture) => textures.push(texture),
                    Err(error) => _ = failure.get_or_insert(error),
                }
            }
            Edit::Replace(place.to_string())
        });
        if let Some(error) = failure {
            return Err(error);
        }
        let base = BaseColour::from_json(json);
        let image = base.texture.and_then(|texture| {
            let place = *places.get(&texture)?;
            textures.get(place)?.1
        });
        if !is_whole {
            let text = format!("material {index} is deeper than 100 levels and is reduced to its colour");
            alloc::push(&mut document.notes, Note::new(Place::Whole, text))?;
        }
        let wrong = wrong_member(json);
        if let Some(name) = wrong {
            let text = format!("material {index}: {name} has a wrong type; the material is reduced to its colour");
            alloc::push(&mut document.notes, Note::new(Place::Whole, text))?;
        }
        Ok(Material {
            name: name.map_or_else(|| format!("material_{index}"), std::borrow::Cow::into_owned),
            colour: base.colour,
            image,
            native: (is_whole && wrong.is_none())
                .then(|| NativeMaterial::Gltf { material: Arc::new(text), textures: Arc::new(textures) }),
        })
    }

    /// Returns the sampler and the image of a texture.
    fn read_texture(
        &mut self,
        index: usize,
        document: &mut Document,
        buffers: &mut Buffers<'a>,
    ) -> Result<(String, Option<u32>), ReadError> {
        let Some(&texture) = self.textures.get(index) else { return Ok((String::new(), None)) };
        let mut sampler = String::new();
        alloc::check_reserve()?;
        if let Some(place) = texture.get("sampler").and_then(Value::whole_number)
            && let Some(&json) = self.samplers.get(place as usize)
        {
            sampler = text_for_copy(json)?;
            if !push_edited(&mut sampler, json, |_, _, _| Edit::Keep) {
                sampler.clear();
            }
            sampler.shrink_to_fit();
        }
        buffers.budget.take_bytes_of::<u8>(sampler.len() as u64)?;
        let extended = || {
            let extensions = texture.get("extensions")?;
            IMAGE_EXTENSIONS.iter().find_map(|(name, _)| extensions.get(name)?.get("source"))
        };
        let source = texture.get("source").or_else(extended).and_then(Value::whole_number);
        let image =
            source.map(|image| self.find_or_read_image(image as usize, document, buffers)).transpose()?.flatten();
        Ok((sampler, image))
    }

    fn find_or_read_image(
        &mut self,
        index: usize,
        document: &mut Document,
        buffers: &mut Buffers<'a>,
    ) -> Result<Option<u32>, ReadError> {
        if let Some(&known) = self.known_images.get(&index) {
            return Ok(known);
        }
        let json = self.images.get(index).copied();
        let data = json.map(|json| image_data(json, index, buffers)).transpose()?.flatten();
        alloc::reserve(&mut document.images, 1)?;
        let place = data.zip(json).map(|((data, told), json)| {
            let text = |key| json.get(key).and_then(Value::text).unwrap_or_default().into_owned();
            let media_type = match &data {
                ImageData::Bytes(bytes) => media_type_from_bytes(bytes).map_or(told, str::to_owned),
                ImageData::File(_) => text("mimeType"),
            };
            document.images.push(Image { name: text("name"), media_type, data });
            document.images.len() as u32 - 1
        });
        self.known_images.insert(index, place);
        Ok(place)
    }
}

/// Returns an image's bytes or file, and the media type that the JSON tells.
fn image_data<'a>(
    json: Value<'a>,
    index: usize,
    buffers: &mut Buffers<'a>,
) -> Result<Option<(ImageData, String)>, ReadError> {
    let told = json.get("mimeType").and_then(Value::text).unwrap_or_default().into_owned();
    if let Some(view) = json.get("bufferView").and_then(Value::whole_number) {
        let view = buffers.read_view(view as usize)?;
        buffers.budget.take_bytes_of::<u8>(view.bytes.len() as u64)?;
        return Ok(Some((ImageData::Bytes(Arc::new(alloc::copied(&view.bytes)?)), told)));
    }
    let Some(address) = json.get("uri").and_then(Value::text) else { return Ok(None) };
    let Some(data) = data_address(&address) else {
        return Ok(Some((ImageData::File(decode_percent(&address)?), told)));
    };
    let bytes = data.decode()?.ok_or_else(|| malformed(format!("image {index} has an address of invalid base64")))?;
    let told = if told.is_empty() { data.media_type.to_owned() } else { told };
    Ok(Some((ImageData::Bytes(Arc::new(bytes)), told)))
}

/// Makes an empty text with room for a copy of a value. A character may take 6 bytes where it took one.
pub(super) fn text_for_copy(value: Value<'_>) -> Result<String, ReadError> {
    let mut text = String::new();
    text.try_reserve_exact(6 * value.raw_text().len() + 32)?;
    Ok(text)
}

/// Returns the media type of an encoded image by its first bytes.
pub(super) fn media_type_from_bytes(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some("image/png"),
        [0xff, 0xd8, 0xff, ..] => Some("image/jpeg"),
        [0xab, b'K', b'T', b'X', b' ', b'2', b'0', ..] => Some("image/ktx2"),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Some("image/webp"),
        [b'D', b'D', b'S', b' ', ..] => Some("image/vnd-ms.dds"),
        [_, _, _, _, b'f', b't', b'y', b'p', b'a', b'v', b'i', b'f', ..] => Some("image/avif"),
        _ => None,
    }
}

/// Base colour of a material, and the texture of it in the file.
struct BaseColour {
    colour: [f32; 4],
    texture: Option<usize>,
}

impl BaseColour {
    fn from_json(material: Value<'_>) -> Self {
        let metallic = material.get("pbrMetallicRoughness");
        let specular = material.get("extensions").and_then(|all| all.get("KHR_materials_pbrSpecularGlossiness"));
        let (object, factor, texture) = match (metallic, specular) {
            (_, Some(object)) => (Some(object), "diffuseFactor", "diffuseTexture"),
            (object, None) => (object, "baseColorFactor", "baseColorTexture"),
        };
        let linear = object.and_then(|object| object.get(factor)?.numbers::<4>()).unwrap_or([1.0; 4]);
        let mut colour = linear.map(|part| part as f32);
        for (part, &linear) in colour.iter_mut().zip(&linear).take(3) {
            *part = srgb_from_linear(linear) as f32;
        }
        // Only the first set of texture coordinates is kept.
        let info = object.and_then(|object| object.get(texture));
        let is_first_set = info.and_then(|info| info.get("texCoord")).is_none_or(|set| set.whole_number() == Some(0));
        let texture = info.filter(|_| is_first_set).and_then(|info| info.get("index")?.whole_number());
        Self { colour, texture: texture.map(|index| index as usize) }
    }
}
