//! Writes a scene as one file, whose buffer is inside.

use super::base64::encode_base64;
use super::gltf_binary::{Binary, JsonList};
use super::gltf_faces_read::POLYGON_EXTENSION;
use super::gltf_materials_write::{MaterialWriter, named_object};
use super::gltf_matrix::Matrix;
use super::gltf_mesh_write::{MeshLosses, write_curves, write_mesh, write_points};
use crate::document::{Document, Placement};
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::json_text::{push_numbers, push_text};
use crate::options::WriteOptions;
use crate::resources::Target;
use gusset_base::alloc;
use std::collections::BTreeMap;

/// Writes JSON text with the buffer as base64.
pub(crate) fn write_gltf(
    document: &Document,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let scene = SceneWriter::new(document, target.resources).write(options)?;
    let bytes = &scene.binary.bytes;
    let (head, tail) = scene.json()?;
    let out = &mut *target.main_file;
    out.write_all(head.as_bytes())?;
    if !bytes.is_empty() {
        out.write_all(format!(",\"buffers\":[{{\"byteLength\":{},\"uri\":\"", bytes.len()).as_bytes())?;
        out.write_all(b"data:application/octet-stream;base64,")?;
        encode_base64(bytes, |digits| out.write_all(digits))?;
        out.write_all(b"\"}]")?;
    }
    out.write_all(tail.as_bytes())?;
    out.write_all(b"\n")?;
    out.flush()?;
    Ok(scene.losses)
}

/// Writes the binary container.
pub(crate) fn write_glb(
    document: &Document,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let scene = SceneWriter::new(document, target.resources).write(options)?;
    let bytes = &scene.binary.bytes;
    let (mut json, tail) = scene.json()?;
    if !bytes.is_empty() {
        json.push_str(&format!(",\"buffers\":[{{\"byteLength\":{}}}]", bytes.len()));
    }
    json.try_reserve(tail.len() + 4)?;
    json.push_str(&tail);
    while json.len() % 4 != 0 {
        json.push(' ');
    }
    let chunks = if bytes.is_empty() { 8 } else { 16 };
    let size = u32::try_from(12 + chunks + json.len() + bytes.len()).map_err(|_| {
        let message = "the mesh needs a binary glTF file of more than 4 gigabytes; write PLY";
        WriteError::new(WriteErrorKind::Unsupported, message)
    })?;
    let out = &mut *target.main_file;
    out.reserve(size as usize)?;
    let mut head = b"glTF\x02\0\0\0".to_vec();
    head.extend_from_slice(&size.to_le_bytes());
    head.extend_from_slice(&(json.len() as u32).to_le_bytes());
    head.extend_from_slice(b"JSON");
    out.write_all(&head)?;
    out.write_all(json.as_bytes())?;
    if !bytes.is_empty() {
        out.write_all(&(bytes.len() as u32).to_le_bytes())?;
        out.write_all(b"BIN\0")?;
        out.write_all(bytes)?;
    }
    out.flush()?;
    Ok(scene.losses)
}

/// A scene as pieces of JSON and a buffer.
struct SceneWriter<'d> {
    document: &'d Document,
    binary: Binary,
    materials: MaterialWriter<'d>,
    nodes: JsonList,
    meshes: JsonList,
    has_polygons: bool,
    losses: Vec<Loss>,
}

impl<'d> SceneWriter<'d> {
    fn new(document: &'d Document, resources: &'d dyn crate::resources::Resources) -> Self {
        Self {
            document,
            binary: Binary::default(),
            materials: MaterialWriter::new(document, resources),
            nodes: JsonList::default(),
            meshes: JsonList::default(),
            has_polygons: false,
            losses: Vec::new(),
        }
    }

    fn write(mut self, options: &WriteOptions) -> Result<Self, WriteError> {
        let mut lost = MeshLosses::default();
        // The file's mesh and its origin, by the document's meshes.
        let mut known: BTreeMap<u32, Option<(u32, [f64; 3])>> = BTreeMap::new();
        for placement in &self.document.placements {
            let written = match known.get(&placement.mesh) {
                Some(&written) => written,
                None => {
                    let mesh = &self.document.meshes[placement.mesh as usize];
                    let made = write_mesh(mesh, &mut self.binary, &mut self.materials, options, &mut lost)?;
                    let written = match made {
                        Some(made) => {
                            self.has_polygons |= made.has_polygons;
                            Some((self.meshes.push(&made.json)?, made.origin))
                        }
                        None => None,
                    };
                    known.insert(placement.mesh, written);
                    written
                }
            };
            if let Some((mesh, origin)) = written {
                let node = node_text(&placement.name, mesh, &moved_by(&placement.transform, origin))?;
                self.nodes.push(&node)?;
            }
            alloc::check_reserve()?;
        }
        let (curves, points) = (&self.document.curves, &self.document.points);
        for (name, made) in [
            ("curves", write_curves(curves, &mut self.binary, &mut lost)?),
            ("points", write_points(points, &mut self.binary, &mut lost)?),
        ] {
            if let Some((mesh, origin)) = made {
                let mesh = self.meshes.push(&mesh)?;
                self.nodes.push(&node_text(name, mesh, &moved_by(&Placement::IDENTITY, origin))?)?;
            }
        }
        self.losses = lost.into_losses(self.document);
        self.losses.append(&mut self.materials.losses);
        Ok(self)
    }

    /// Returns the JSON text before and after the buffer's entry.
    fn json(&self) -> Result<(String, String), WriteError> {
        let lists = self.lists();
        let mut head = String::new();
        let length: usize = lists.iter().map(|(name, list)| name.len() + list.text.len() + 8).sum();
        // The list of nodes, and the texts below.
        head.try_reserve(length + 11 * self.nodes.count as usize + 200)?;
        head.push_str("{\"asset\":{\"version\":\"2.0\",\"generator\":\"gusset\"},\"scene\":0,\"scenes\":[{");
        if self.nodes.count > 0 {
            head.push_str("\"nodes\":[");
            for node in 0..self.nodes.count {
                head.push_str(&format!("{}{node}", if node > 0 { "," } else { "" }));
            }
            head.push(']');
        }
        head.push_str("}]");
        for (name, list) in lists.into_iter().filter(|(_, list)| list.count > 0) {
            head.push_str(&format!(",\"{name}\":["));
            head.push_str(&list.text);
            head.push(']');
        }
        let mut tail = String::new();
        let mut extensions = self.materials.extensions.clone();
        if self.has_polygons {
            extensions.insert(POLYGON_EXTENSION.to_owned());
        }
        for (place, extension) in extensions.iter().enumerate() {
            tail.push_str(if place == 0 { ",\"extensionsUsed\":[" } else { "," });
            push_text(&mut tail, extension);
        }
        tail.push_str(if extensions.is_empty() { "}" } else { "]}" });
        Ok((head, tail))
    }

    fn lists(&self) -> [(&'static str, &JsonList); 8] {
        [
            ("nodes", &self.nodes),
            ("meshes", &self.meshes),
            ("materials", &self.materials.materials),
            ("textures", &self.materials.textures),
            ("images", &self.materials.images),
            ("samplers", &self.materials.samplers),
            ("accessors", &self.binary.accessors),
            ("bufferViews", &self.binary.views),
        ]
    }
}

/// Returns the transform of points that are relative to `origin`.
fn moved_by(transform: &Matrix, origin: [f64; 3]) -> Matrix {
    let mut made = *transform;
    if origin != [0.0; 3] {
        for row in &mut made {
            row[3] += row[0] * origin[0] + row[1] * origin[1] + row[2] * origin[2];
        }
    }
    made
}

fn node_text(name: &str, mesh: u32, m: &Matrix) -> Result<String, WriteError> {
    let mut text = named_object(name)?;
    text.push_str(if text.len() > 1 { ",\"mesh\":" } else { "\"mesh\":" });
    text.push_str(&mesh.to_string());
    let translation = m.map(|row| row[3]);
    let is_moved_only = (0..3).all(|row| m[row][..3] == Placement::IDENTITY[row][..3]);
    if !is_moved_only {
        let column = |k: usize| [m[0][k], m[1][k], m[2][k], if k == 3 { 1.0 } else { 0.0 }];
        text.push_str(",\"matrix\":");
        push_numbers(&mut text, [column(0), column(1), column(2), column(3)].as_flattened());
    } else if translation != [0.0; 3] {
        text.push_str(",\"translation\":");
        push_numbers(&mut text, &translation);
    }
    text.push('}');
    Ok(text)
}
