//! Materials of faces, and the libraries that define them.

use super::read_mtl::{Definition, Library, add_definitions, material_from_lines};
use crate::error::{Note, Place, ReadError, ReadErrorKind, printable};
use crate::material::{Image, ImageData, Material, NO_MATERIAL};
use crate::resources::Resources;
use crate::text_encoding::{lossy_text, owned_text};
use gusset_base::alloc;
use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

/// Largest number of material libraries that a file may name, so that reading takes linear time.
const MAX_LIBRARIES: usize = 256;

/// Longest line of library names that is read.
const MAX_NAME_BYTES: usize = 1 << 14;

/// Material of each face; empty if no face has one.
pub(super) type FaceMaterials = Vec<u32>;

/// Materials, and which face has which.
#[derive(Default)]
pub(super) struct Materials {
    pub(super) faces: FaceMaterials,
    pub(super) materials: Vec<Material>,
    pub(super) images: Vec<Image>,
    pub(super) notes: Vec<Note>,
}

/// Makes the materials that `uses` names: each entry is a number of faces and the name of the faces behind them.
pub(super) fn read_materials(
    uses: &[(u32, &[u8])],
    library_lines: &[&[u8]],
    face_count: usize,
    resources: &dyn Resources,
) -> Result<Materials, ReadError> {
    let mut made = Materials::default();
    let libraries = load_libraries(library_lines, resources, &mut made.notes)?;
    let mut known = HashMap::new();
    for library in &libraries {
        add_definitions(library, &mut known)?;
    }
    let mut numbers: HashMap<&[u8], u32> = HashMap::new();
    let mut images = HashMap::new();
    made.faces.try_reserve_exact(face_count)?;
    let mut current = NO_MATERIAL;
    for &(face, name) in uses {
        made.faces.resize(face as usize, current);
        numbers.try_reserve(1)?;
        current = match numbers.entry(name) {
            Entry::Occupied(entry) => *entry.get(),
            Entry::Vacant(entry) => *entry.insert(made.add_material(name, known.get(name), &mut images)?),
        };
        alloc::check_reserve()?;
    }
    made.faces.resize(face_count, current);
    if made.faces.iter().all(|&material| material == NO_MATERIAL) {
        made.faces = Vec::new();
    }
    Ok(made)
}

impl Materials {
    /// Adds a material. Returns its number, or `NO_MATERIAL` if the name says that there is none.
    fn add_material(
        &mut self,
        name: &[u8],
        definition: Option<&Definition<'_>>,
        images: &mut HashMap<String, u32>,
    ) -> Result<u32, ReadError> {
        let number = self.materials.len() as u32;
        let material = match definition {
            Some(&definition) => {
                let (mut material, file) = material_from_lines(name, definition)?;
                material.image = file.map(|file| self.find_or_add_image(file, images)).transpose()?;
                material
            }
            None if means_none(name) => return Ok(NO_MATERIAL),
            None => Material { name: owned_text(name)?, ..Material::default() },
        };
        alloc::push(&mut self.materials, material)?;
        Ok(number)
    }

    fn find_or_add_image(&mut self, file: String, known: &mut HashMap<String, u32>) -> Result<u32, ReadError> {
        if let Some(&number) = known.get(&file) {
            return Ok(number);
        }
        let number = self.images.len() as u32;
        known.try_reserve(1)?;
        known.insert(file.clone(), number);
        let name = file.rsplit('/').next().unwrap_or_default().to_string();
        let media_type = media_type_from_name(&name).to_string();
        alloc::push(&mut self.images, Image { name, media_type, data: ImageData::File(file) })?;
        Ok(number)
    }
}

fn media_type_from_name(name: &str) -> &'static str {
    match name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).as_deref() {
        Some("png") => "image/png",
        Some("jpg" | "jpeg") => "image/jpeg",
        _ => "",
    }
}

/// Returns whether a name says that faces have no material: nothing, `none` or `null`, in parentheses or not.
fn means_none(name: &[u8]) -> bool {
    let mut name = name;
    while let [b'(', inner @ .., b')'] = name {
        name = inner;
    }
    name.is_empty() || name.eq_ignore_ascii_case(b"none") || name.eq_ignore_ascii_case(b"null")
}

/// Loads each library once. A line names one file whose name may have blanks, or several files.
fn load_libraries(
    lines: &[&[u8]],
    resources: &dyn Resources,
    notes: &mut Vec<Note>,
) -> Result<Vec<Library>, ReadError> {
    let mut libraries = Vec::new();
    let mut tried: HashSet<String> = HashSet::new();
    for line in lines {
        let line = lossy_text(line)?;
        if line.len() > MAX_NAME_BYTES {
            continue;
        }
        let line = line.replace('\\', "/");
        if tried.contains(&line) {
            continue;
        }
        let whole = load_library(&line, &mut tried, resources)?;
        let mut missing = Vec::new();
        match whole {
            Ok(library) => libraries.push(library),
            Err(error) if !line.contains([' ', '\t']) => missing.push((line, error)),
            Err(_) => {
                for name in line.split_ascii_whitespace() {
                    if tried.contains(name) || tried.len() > MAX_LIBRARIES {
                        continue;
                    }
                    match load_library(name, &mut tried, resources)? {
                        Ok(library) => libraries.push(library),
                        Err(error) => missing.push((name.to_string(), error)),
                    }
                }
            }
        }
        notes.extend(missing.into_iter().map(|(name, error)| missing_library(&name, &error)));
        alloc::check_reserve()?;
        if tried.len() > MAX_LIBRARIES {
            notes
                .push(Note::new(Place::Whole, format!("material libraries after the first {MAX_LIBRARIES}: not read")));
            break;
        }
    }
    Ok(libraries)
}

/// Returns the library, or why it cannot be read. Fails if memory runs out.
fn load_library(
    name: &str,
    tried: &mut HashSet<String>,
    resources: &dyn Resources,
) -> Result<Result<Library, ReadError>, ReadError> {
    tried.insert(name.to_string());
    match resources.load(name) {
        Ok(bytes) => {
            let folder = name.rfind('/').map_or("", |end| &name[..=end]).to_string();
            Ok(Ok(Library { bytes, folder }))
        }
        Err(error) if error.kind == ReadErrorKind::OutOfMemory => Err(error),
        Err(error) => Ok(Err(error)),
    }
}

fn missing_library(name: &str, error: &ReadError) -> Note {
    let why =
        error.message.strip_prefix(&*printable(name)).map_or(&*error.message, |rest| rest.trim_start_matches(": "));
    Note::new(Place::Whole, format!("material library {}: {why}; its materials have names only", printable(name)))
}
