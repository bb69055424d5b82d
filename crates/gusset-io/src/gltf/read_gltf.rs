//! Reads a whole file: checks version and extensions, then the scene, its meshes and their materials.

use super::glb_container::{OLD_VERSION, Parts, split_file};
use super::gltf_accessors::Accessors;
use super::gltf_buffers::{Buffers, MESHOPT_EXTENSIONS, element, malformed};
use super::gltf_faces_read::POLYGON_EXTENSION;
use super::gltf_materials_read::{IMAGE_EXTENSIONS, MaterialReader};
use super::gltf_mesh::{MeshReader, draco_error};
use super::gltf_notes::Unread;
use super::gltf_scene::{ShownMesh, shown_meshes};
use super::gltf_strands::Strands;
use crate::budget::Budget;
use crate::document::{Document, Placement};
use crate::error::{Note, Place, ReadError, printable};
use crate::json_tape::{OUT_OF_MEMORY, Tape, Value};
use crate::options::ReadOptions;
use crate::resources::Resources;
use gusset_base::alloc;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Required extensions that change nothing which is read, besides extensions of materials and textures.
const HARMLESS_EXTENSIONS: [&str; 10] = [
    POLYGON_EXTENSION,
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_lights_punctual",
    "KHR_animation_pointer",
    "KHR_node_visibility",
    "KHR_technique_webgl",
    "KHR_techniques_webgl",
    "KHR_xmp_json_ld",
    "EXT_mesh_gpu_instancing",
];

/// Reads a text or binary file; its first bytes tell which one it is.
pub(crate) fn read_gltf(bytes: &[u8], resources: &dyn Resources, options: &ReadOptions) -> Result<Document, ReadError> {
    let mut document = Document::default();
    let parts = split_file(bytes, &mut document.notes)?;
    let tape = Tape::parse(parts.json).map_err(|error| match error.message {
        OUT_OF_MEMORY => ReadError::out_of_memory(),
        message => ReadError::malformed(parts.place(error.offset), format!("JSON: {message}")),
    })?;
    note_deviations(&tape, &parts, &mut document.notes);
    let root = tape.root();
    check_version(root, &mut document.notes)?;
    check_extensions(root)?;
    let mut budget = Budget::new(bytes.len());
    budget.take_bytes_of::<u8>(tape.bytes())?;
    let read = read_scene(root, Buffers::new(root, parts.binary, resources, budget)?, options, &mut document);
    tape.check_memory()?;
    read.map(|()| document)
}

fn read_scene<'a>(
    root: Value<'a>,
    buffers: Buffers<'a>,
    options: &ReadOptions,
    document: &mut Document,
) -> Result<(), ReadError> {
    let mut accessors = Accessors::new(root, buffers)?;
    let shown = shown_meshes(root, &mut accessors, &mut document.notes)?;
    read_shown(root, &mut accessors, shown, options, document)
}

fn note_deviations(tape: &Tape<'_>, parts: &Parts<'_>, notes: &mut Vec<Note>) {
    let place = parts.place(0);
    if tape.has_trailing_commas {
        notes.push(Note::new(place, "commas precede closing brackets"));
    }
    if tape.has_text_after_value {
        notes.push(Note::new(place, "text follows the JSON object and is ignored"));
    }
}

fn check_version(root: Value<'_>, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let asset = root.get("asset");
    if asset.is_none() && ["meshes", "nodes", "scenes", "accessors"].iter().all(|name| root.get(name).is_none()) {
        return Err(malformed("this JSON is not glTF: it has neither asset nor meshes"));
    }
    match asset.and_then(|asset| asset.get("version")?.text()) {
        Some(version) if version.starts_with("2.") || version == "2" => Ok(()),
        Some(version) if version.starts_with('1') || version.starts_with('0') => {
            Err(ReadError::unsupported(OLD_VERSION))
        }
        Some(version) => Err(ReadError::unsupported(format!("this is glTF of version {version}; version 2 is read"))),
        // In version 1, meshes are members of an object.
        None if root.get("meshes").is_some_and(Value::is_object) => Err(ReadError::unsupported(OLD_VERSION)),
        None => {
            notes.push(Note::new(Place::Whole, "the file does not tell its version; it is read as glTF 2.0"));
            Ok(())
        }
    }
}

/// Refuses files that cannot be read without an extension.
fn check_extensions(root: Value<'_>) -> Result<(), ReadError> {
    for name in root.get("extensionsRequired").into_iter().flat_map(Value::items) {
        let name = name.text().unwrap_or_default();
        let is_known = HARMLESS_EXTENSIONS.contains(&&*name)
            || MESHOPT_EXTENSIONS.contains(&&*name)
            || IMAGE_EXTENSIONS.iter().any(|(known, _)| *known == name)
            || name.starts_with("KHR_materials_")
            || name.starts_with("EXT_materials_");
        if name == "KHR_draco_mesh_compression" {
            return Err(draco_error());
        }
        if !is_known {
            return Err(ReadError::unsupported(format!(
                "the file requires the extension {}, which is not read; export the file without it",
                printable(&name)
            )));
        }
    }
    Ok(())
}

/// A mesh of the file that was read.
struct KnownMesh {
    /// Index in the document, if it has faces or at least vertices.
    mesh: Option<u32>,
    strands: Strands,
}

fn read_shown<'a>(
    root: Value<'a>,
    accessors: &mut Accessors<'a>,
    shown: Vec<ShownMesh>,
    options: &ReadOptions,
    document: &mut Document,
) -> Result<(), ReadError> {
    let meshes = root.list("meshes")?;
    let mut materials = MaterialReader::new(root)?;
    let mut unread = Unread::default();
    let mut known: BTreeMap<usize, KnownMesh> = BTreeMap::new();
    for own in shown {
        unread.has_skins |= own.is_skinned;
        let KnownMesh { mesh, strands } = match known.entry(own.mesh) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let json = element(&meshes, own.mesh, "mesh")?;
                entry.insert(read_mesh(json, &own, accessors, &mut materials, &mut unread, options, document)?)
            }
        };
        strands.place_in_document(document, &own.transform, &mut accessors.buffers.budget)?;
        if let Some(mesh) = *mesh {
            let placement = Placement { name: own.name, mesh, transform: own.transform };
            alloc::push(&mut document.placements, placement)?;
        }
        alloc::check_reserve()?;
    }
    let hidden = meshes.len() - known.len();
    if hidden > 0 {
        let text = if hidden == 1 { "1 mesh is" } else { &format!("{hidden} meshes are") };
        document.notes.push(Note::new(Place::Whole, format!("{text} not in the scene and not read")));
    }
    unread.append_notes(root, &mut document.notes);
    Ok(())
}

fn read_mesh<'a>(
    json: Value<'a>,
    own: &ShownMesh,
    accessors: &mut Accessors<'a>,
    materials: &mut MaterialReader<'a>,
    unread: &mut Unread,
    options: &ReadOptions,
    document: &mut Document,
) -> Result<KnownMesh, ReadError> {
    let mut notes = std::mem::take(&mut document.notes);
    let reader = MeshReader::new(accessors, &mut notes, unread, options.merge_repeated);
    let (mesh, strands) =
        reader.read(json, own.mesh, |index, buffers| materials.find_or_read_material(index, document, buffers))?;
    notes.append(&mut document.notes);
    document.notes = notes;
    alloc::reserve(&mut document.meshes, 1)?;
    let is_shown = mesh.face_count() > 0;
    let place = is_shown.then(|| {
        document.meshes.push(mesh);
        document.meshes.len() as u32 - 1
    });
    Ok(KnownMesh { mesh: place, strands })
}
