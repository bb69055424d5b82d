//! Materials, textures, samplers and images of a written file. Images are in the buffer, so that the file needs no others.

use super::gltf_binary::{Binary, JsonList};
use super::gltf_colour::linear_from_srgb;
use super::gltf_materials_read::{IMAGE_EXTENSIONS, media_type_from_bytes, text_for_copy};
use crate::document::Document;
use crate::error::{Loss, ReadError, ReadErrorKind, WriteError};
use crate::json_tape::{Tape, Value};
use crate::json_text::{Edit, push_edited, push_numbers, push_text};
use crate::material::{ImageData, Material, NativeMaterial};
use crate::resources::Resources;
use crate::text_encoding::owned_text;
use gusset_base::alloc;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Texture of a material that the file does not get.
const NO_TEXTURE: u32 = u32::MAX;

/// Writes the materials that faces use, in the order of their first use.
pub(super) struct MaterialWriter<'d> {
    document: &'d Document,
    resources: &'d dyn Resources,
    pub(super) materials: JsonList,
    pub(super) textures: JsonList,
    pub(super) images: JsonList,
    pub(super) samplers: JsonList,
    pub(super) extensions: BTreeSet<String>,
    pub(super) losses: Vec<Loss>,
    index_of_written_material: BTreeMap<u32, u32>,
    known_images: BTreeMap<u32, Option<WrittenImage>>,
    known_textures: BTreeMap<String, u32>,
    known_samplers: BTreeMap<String, u32>,
    /// Places in the buffer and indices of written images: equal images are written once.
    stored: Vec<(std::ops::Range<usize>, WrittenImage)>,
}

#[derive(Clone, Copy)]
struct WrittenImage {
    index: u32,
    media_type: &'static str,
}

impl<'d> MaterialWriter<'d> {
    pub(super) fn new(document: &'d Document, resources: &'d dyn Resources) -> Self {
        Self {
            document,
            resources,
            materials: JsonList::default(),
            textures: JsonList::default(),
            images: JsonList::default(),
            samplers: JsonList::default(),
            extensions: BTreeSet::new(),
            losses: Vec::new(),
            index_of_written_material: BTreeMap::new(),
            known_images: BTreeMap::new(),
            known_textures: BTreeMap::new(),
            known_samplers: BTreeMap::new(),
            stored: Vec::new(),
        }
    }

    /// Returns the file's index of a material of the document.
    pub(super) fn find_or_write_material(&mut self, index: u32, binary: &mut Binary) -> Result<u32, WriteError> {
        if let Some(&known) = self.index_of_written_material.get(&index) {
            return Ok(known);
        }
        let material = &self.document.materials[index as usize];
        let native = match &material.native {
            Some(NativeMaterial::Gltf { material: text, textures }) => {
                self.native_material(material, text, textures, binary)?
            }
            _ => None,
        };
        let text = match native {
            Some(text) => text,
            None => self.plain_material(material, binary)?,
        };
        let made = self.materials.push(&text)?;
        self.index_of_written_material.insert(index, made);
        alloc::check_reserve()?;
        Ok(made)
    }

    /// Returns the material's own JSON with textures of this file; `None` if it is not valid.
    fn native_material(
        &mut self,
        material: &Material,
        text: &str,
        textures: &[(String, Option<u32>)],
        binary: &mut Binary,
    ) -> Result<Option<String>, WriteError> {
        let Ok(tape) = Tape::parse(text.as_bytes()) else { return Ok(None) };
        let root = tape.root();
        if !root.is_object() {
            return Ok(None);
        }
        // Indices in the file by indices in `textures`.
        let mut written: BTreeMap<u64, u32> = BTreeMap::new();
        let mut failure = None;
        let mut made = text_for_copy(root)?;
        let is_whole = push_edited(&mut made, root, |parent, key, value| {
            let is_texture = |name: Value<'_>| name.text().is_some_and(|name| name.ends_with("Texture"));
            if parent.is_none() && key.equals_text("name") {
                return Edit::Drop;
            }
            if parent.is_some_and(|name| name.equals_text("extensions")) {
                self.extensions.insert(key.text().unwrap_or_default().into_owned());
            }
            let index = |value: Value<'_>| value.whole_number().unwrap_or(u64::MAX);
            if is_texture(key) && value.get("index").is_some() {
                let own = value.get("index").map_or(u64::MAX, index);
                let texture = self.texture_index_in_file(material, value, own, textures, binary);
                match texture {
                    Ok(NO_TEXTURE) => return Edit::Drop,
                    Ok(texture) => _ = written.insert(own, texture),
                    Err(error) => _ = failure.get_or_insert(error),
                }
            }
            match written.get(&index(value)) {
                Some(texture) if key.equals_text("index") && parent.is_some_and(is_texture) => {
                    Edit::Replace(texture.to_string())
                }
                _ => Edit::Keep,
            }
        });
        if let Some(error) = failure {
            return Err(error);
        }
        if !is_whole {
            return Ok(None);
        }
        tape.check_memory()?;
        let mut named = named_object(&material.name)?;
        named.try_reserve(made.len())?;
        if named.len() > 1 && made.len() > 2 {
            named.push(',');
        }
        named.push_str(&made[1..]);
        Ok(Some(named))
    }

    /// Returns the file's index of a texture that a material shows; `NO_TEXTURE` if the file does not get it.
    fn texture_index_in_file(
        &mut self,
        material: &Material,
        info: Value<'_>,
        index: u64,
        textures: &[(String, Option<u32>)],
        binary: &mut Binary,
    ) -> Result<u32, WriteError> {
        if info.get("texCoord").is_some_and(|set| set.whole_number() != Some(0)) {
            let name = &material.name;
            self.add_loss(&format!("a texture of material {name} that other texture coordinates show"));
            return Ok(NO_TEXTURE);
        }
        let Some((sampler, image)) = textures.get(usize::try_from(index).unwrap_or(usize::MAX)) else {
            return Ok(NO_TEXTURE);
        };
        let image = image.map(|image| self.find_or_write_image(image, binary)).transpose()?.flatten();
        image.map_or(Ok(NO_TEXTURE), |image| self.find_or_write_texture(sampler, image))
    }

    fn find_or_write_texture(&mut self, sampler: &str, image: WrittenImage) -> Result<u32, WriteError> {
        let mut text = String::from("{");
        if !sampler.is_empty() {
            let index = match self.known_samplers.get(sampler) {
                Some(&index) => index,
                None => {
                    let index = self.samplers.push(sampler)?;
                    self.known_samplers.insert(owned_text(sampler.as_bytes())?, index);
                    index
                }
            };
            text.push_str(&format!("\"sampler\":{index},"));
        }
        let source = format!("\"source\":{}", image.index);
        match IMAGE_EXTENSIONS.iter().find(|(_, media_type)| *media_type == image.media_type) {
            Some((extension, _)) => {
                self.extensions.insert((*extension).to_owned());
                text.push_str(&format!("\"extensions\":{{\"{extension}\":{{{source}}}}}}}"));
            }
            None => text.push_str(&format!("{source}}}")),
        }
        if let Some(&index) = self.known_textures.get(&text) {
            return Ok(index);
        }
        let index = self.textures.push(&text)?;
        self.known_textures.insert(text, index);
        Ok(index)
    }

    /// Returns a material of a base colour and its image.
    fn plain_material(&mut self, material: &Material, binary: &mut Binary) -> Result<String, WriteError> {
        let mut text = named_object(&material.name)?;
        if text.len() > 1 {
            text.push(',');
        }
        let [r, g, b, opacity] = material.colour.map(f64::from);
        let [r, g, b] = [r, g, b].map(linear_from_srgb);
        text.push_str("\"pbrMetallicRoughness\":{\"baseColorFactor\":");
        push_numbers(&mut text, &[r, g, b, opacity]);
        text.push_str(",\"metallicFactor\":0");
        if let Some(image) = material.image.map(|image| self.find_or_write_image(image, binary)).transpose()?.flatten()
        {
            let texture = self.find_or_write_texture("", image)?;
            text.push_str(&format!(",\"baseColorTexture\":{{\"index\":{texture}}}"));
        }
        text.push('}');
        if opacity < 1.0 {
            text.push_str(",\"alphaMode\":\"BLEND\"");
        }
        text.push('}');
        if let Some(NativeMaterial::Mtl(lines)) = &material.native
            && lines.iter().any(|line| !is_plain_line(line))
        {
            self.add_loss(&format!("all of material {} except its diffuse colour and image", material.name));
        }
        Ok(text)
    }

    /// Returns a written image; `None` if it does not exist or programs could not show it.
    fn find_or_write_image(&mut self, index: u32, binary: &mut Binary) -> Result<Option<WrittenImage>, WriteError> {
        if let Some(&known) = self.known_images.get(&index) {
            return Ok(known);
        }
        let image = &self.document.images[index as usize];
        let (bytes, name): (Cow<'_, [u8]>, _) = match &image.data {
            ImageData::Bytes(bytes) => (Cow::Borrowed(bytes), "inside of the file"),
            ImageData::File(name) => (Cow::Owned(self.load_image_file(name)?), name.as_str()),
        };
        let written = match media_type_from_bytes(&bytes) {
            Some(media_type) => Some(self.store_image(&image.name, &bytes, media_type, binary)?),
            None if bytes.is_empty() => {
                self.add_loss(&format!("the image {name}, which is not there"));
                None
            }
            None => {
                self.add_loss(&format!("the image {name}, which is neither PNG nor JPEG"));
                None
            }
        };
        self.known_images.insert(index, written);
        Ok(written)
    }

    fn store_image(
        &mut self,
        name: &str,
        bytes: &[u8],
        media_type: &'static str,
        binary: &mut Binary,
    ) -> Result<WrittenImage, WriteError> {
        if let Some((_, known)) = self.stored.iter().find(|(range, _)| binary.bytes[range.clone()] == *bytes) {
            return Ok(*known);
        }
        let start = binary.bytes.len();
        let view = binary.push_bytes(bytes)?;
        let mut text = named_object(name)?;
        if text.len() > 1 {
            text.push(',');
        }
        text.push_str(&format!("\"bufferView\":{view},\"mimeType\":\"{media_type}\"}}"));
        let made = WrittenImage { index: self.images.push(&text)?, media_type };
        alloc::push(&mut self.stored, (start..start + bytes.len(), made))?;
        Ok(made)
    }

    /// Loads an image; nothing if it is not there.
    fn load_image_file(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        match self.resources.load(name) {
            Err(error) if error.kind == ReadErrorKind::OutOfMemory => Err(error),
            loaded => Ok(loaded.unwrap_or_default()),
        }
    }

    fn add_loss(&mut self, text: &str) {
        let loss = Loss(crate::error::printable(text));
        if !self.losses.contains(&loss) {
            self.losses.push(loss);
        }
    }
}

/// Returns the start of an object with a name, if there is one.
pub(super) fn named_object(name: &str) -> Result<String, WriteError> {
    // A character may take 6 bytes where it took one.
    let mut text = String::new();
    text.try_reserve(6 * name.len() + 64)?;
    text.push('{');
    if !name.is_empty() {
        text.push_str("\"name\":");
        push_text(&mut text, name);
    }
    Ok(text)
}

/// Returns whether a line of an MTL library says nothing beyond diffuse colour, opacity and image.
fn is_plain_line(line: &str) -> bool {
    let mut words = line.split_ascii_whitespace();
    match words.next() {
        None | Some("Kd" | "d" | "newmtl") => true,
        Some("map_Kd") => !words.next().is_some_and(|word| word.starts_with('-')),
        Some(word) => word.starts_with('#'),
    }
}
