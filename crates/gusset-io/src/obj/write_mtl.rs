//! Material libraries beside OBJ files.

use super::mtl_line::with_renamed_file;
use crate::document::Document;
use crate::error::{Loss, WriteError};
use crate::material::{ImageData, Material, NO_MATERIAL, NativeMaterial};
use crate::memory_file::MemoryFile;
use crate::resources::Target;
use crate::text::TextWriter;
use gusset_base::alloc;
use std::borrow::Cow;
use std::collections::HashMap;
use std::io;

/// Materials of placed faces in the order of faces, with names that differ.
pub(super) struct UsedMaterials {
    /// Indices into the document's materials.
    materials_in_face_order: Vec<u32>,
    /// Name of each of the document's materials; empty for unused ones.
    pub(super) names: Vec<String>,
    /// Name for faces without a material, which no material has.
    unused_name: String,
}

impl UsedMaterials {
    pub(super) fn from_document(document: &Document) -> Result<Self, WriteError> {
        let mut used = Self { materials_in_face_order: Vec::new(), names: Vec::new(), unused_name: "none".into() };
        let mut names = UniqueNames::default();
        for placement in &document.placements {
            for &material in &document.meshes[placement.mesh as usize].face_materials {
                if material == NO_MATERIAL {
                    continue;
                }
                if used.names.is_empty() {
                    used.names = alloc::filled(String::new(), document.materials.len())?;
                }
                if used.names[material as usize].is_empty() {
                    let name = one_line(&document.materials[material as usize].name)?;
                    used.names[material as usize] =
                        names.make_unique_name(if name.is_empty() { "material" } else { &name })?;
                    alloc::push(&mut used.materials_in_face_order, material)?;
                    alloc::check_reserve()?;
                }
            }
        }
        while names.next_number_of_name.contains_key(&used.unused_name) {
            used.unused_name = format!("({})", used.unused_name);
        }
        Ok(used)
    }

    /// Returns the name of a material or of `NO_MATERIAL`.
    pub(super) fn name(&self, material: u32) -> &str {
        self.names.get(material as usize).unwrap_or(&self.unused_name)
    }
}

/// Names of which no two are equal.
#[derive(Default)]
struct UniqueNames {
    /// Names that were given, and the number that the next equal one gets.
    next_number_of_name: HashMap<String, u64>,
}

impl UniqueNames {
    /// Returns the name, or the name with the first free number behind it: `name_2`.
    fn make_unique_name(&mut self, name: &str) -> Result<String, WriteError> {
        self.next_number_of_name.try_reserve(2)?;
        let mut number = *self.next_number_of_name.entry(name.to_string()).or_insert(1);
        let mut made = name.to_string();
        while number > 1 && self.next_number_of_name.contains_key(&made) {
            made = format!("{name}_{number}");
            number += 1;
        }
        self.next_number_of_name.insert(name.to_string(), number.max(2));
        self.next_number_of_name.entry(made.clone()).or_insert(2);
        Ok(made)
    }
}

/// Replaces control characters, which would end a line, and drops blanks at the ends.
pub(super) fn one_line(name: &str) -> io::Result<Cow<'_, str>> {
    if !name.contains(char::is_control) {
        return Ok(Cow::Borrowed(name.trim()));
    }
    let mut made = String::new();
    // A control character has at least one byte.
    made.try_reserve(name.len()).map_err(|_| io::ErrorKind::OutOfMemory)?;
    made.extend(name.trim().chars().map(|c| if c.is_control() { '_' } else { c }));
    Ok(Cow::Owned(made))
}

/// Writes the library of the materials, and the images without a file. Returns its name; `None` without materials.
pub(super) fn write_library(
    document: &Document,
    materials: &UsedMaterials,
    target: &mut Target<'_>,
    losses: &mut Vec<Loss>,
) -> Result<Option<String>, WriteError> {
    if materials.materials_in_face_order.is_empty() {
        return Ok(None);
    }
    let mut bytes = MemoryFile::default();
    let mut images = ImageFiles { written: HashMap::new(), names: UniqueNames::default() };
    let mut reduced = 0_usize;
    let mut text = TextWriter::new(&mut bytes)?;
    for &index in &materials.materials_in_face_order {
        let material = &document.materials[index as usize];
        let name = materials.name(index);
        text.text("newmtl ")?;
        text.text(name)?;
        text.bytes(b"\n")?;
        if let Some(NativeMaterial::Mtl(lines)) = &material.native {
            for line in lines {
                let line = with_renamed_file(line, |name| target.resources.written_name(name))?;
                text.text(&one_line(&line)?)?;
                text.bytes(b"\n")?;
                alloc::check_reserve()?;
            }
            continue;
        }
        reduced += usize::from(has_more_than_colour(material));
        let image = match material.image {
            Some(image) => images.find_or_write_file(document, image, name, target)?,
            None => None,
        };
        write_colour(&mut text, material, image.as_deref())?;
    }
    text.finish()?;
    if reduced > 0 {
        let plural = if reduced == 1 { "" } else { "s" };
        losses.push(Loss(format!(
            "all of {reduced} material{plural} but base colour and image, which alone OBJ files hold"
        )));
    }
    let library = format!("{}.mtl", one_line(target.stem)?);
    target.write_beside(&library, bytes.bytes())?;
    Ok(Some(library))
}

fn write_colour(text: &mut TextWriter<'_>, material: &Material, image: Option<&str>) -> io::Result<()> {
    text.text("Kd")?;
    for &part in &material.colour[..3] {
        text.bytes(b" ")?;
        text.single(part)?;
    }
    text.bytes(b"\n")?;
    if material.colour[3] < 1.0 {
        text.text("d ")?;
        text.single(material.colour[3])?;
        text.bytes(b"\n")?;
    }
    if let Some(image) = image {
        text.text("map_Kd ")?;
        text.text(&one_line(image)?)?;
        text.bytes(b"\n")?;
    }
    Ok(())
}

/// Files of images that were written.
struct ImageFiles {
    written: HashMap<u32, String>,
    names: UniqueNames,
}

impl ImageFiles {
    /// Returns the file of an image, which is written beside the library if it has none.
    fn find_or_write_file(
        &mut self,
        document: &Document,
        index: u32,
        material: &str,
        target: &mut Target<'_>,
    ) -> Result<Option<String>, WriteError> {
        let Some(image) = document.images.get(index as usize) else { return Ok(None) };
        let bytes = match &image.data {
            ImageData::File(name) => return Ok(Some(target.resources.written_name(name))),
            // The reader refused to follow its name.
            ImageData::Bytes(bytes) if bytes.is_empty() => return Ok(None),
            ImageData::Bytes(bytes) => bytes,
        };
        if let Some(name) = self.written.get(&index) {
            return Ok(Some(name.clone()));
        }
        let stem = file_name_part(&format!("{}_{material}", target.stem));
        let name = format!("{}.{}", self.names.make_unique_name(&stem)?, image_extension(bytes, &image.media_type));
        target.write_beside(&name, bytes)?;
        self.written.try_reserve(1)?;
        alloc::check_reserve()?;
        self.written.insert(index, name.clone());
        Ok(Some(name))
    }
}

/// Replaces characters that a file name cannot have on some system, and shortens long names.
fn file_name_part(name: &str) -> String {
    const MAX_CHARACTERS: usize = 60;
    let is_refused = |c: char| c.is_control() || c.is_whitespace() || "/\\:*?\"<>|".contains(c);
    name.chars().take(MAX_CHARACTERS).map(|c| if is_refused(c) { '_' } else { c }).collect()
}

fn image_extension(bytes: &[u8], media_type: &str) -> &'static str {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => "png",
        [0xff, 0xd8, 0xff, ..] => "jpg",
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "webp",
        [0xab, b'K', b'T', b'X', ..] => "ktx2",
        _ if media_type == "image/jpeg" => "jpg",
        _ => "png",
    }
}

/// Returns whether a glTF material says more than what MTL files get: names of JSON members except base colours.
fn has_more_than_colour(material: &Material) -> bool {
    const KEPT: [&str; 10] = [
        "name",
        "pbrMetallicRoughness",
        "baseColorFactor",
        "baseColorTexture",
        "index",
        "texCoord",
        "metallicFactor",
        "alphaMode",
        "doubleSided",
        "extras",
    ];
    let Some(NativeMaterial::Gltf { material, .. }) = &material.native else { return false };
    member_names(material).iter().any(|name| !KEPT.contains(name))
}

/// Returns the names of all members in JSON text.
fn member_names(json: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let mut rest = json;
    while let Some(start) = rest.find('"') {
        let inner = &rest[start + 1..];
        let mut is_escaped = false;
        let end = inner.find(|c| {
            let ends = c == '"' && !is_escaped;
            is_escaped = c == '\\' && !is_escaped;
            ends
        });
        let Some(end) = end else { break };
        rest = &inner[end + 1..];
        if rest.trim_start().starts_with(':') {
            names.push(&inner[..end]);
        }
    }
    names
}
