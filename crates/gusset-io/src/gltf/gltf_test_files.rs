//! Hand-made files, and measures of meshes, for the tests.

use super::{read_gltf, write_glb, write_gltf};
use crate::document::Document;
use crate::error::{Loss, ReadError, ReadErrorKind};
use crate::mesh::Mesh;
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{NoResources, Resources, Target};
use std::collections::BTreeMap;

/// Files beside the one that is read.
#[derive(Default)]
pub(super) struct Files(pub(super) BTreeMap<String, Vec<u8>>);

impl Resources for Files {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        self.0.get(name).cloned().ok_or_else(|| ReadError::new(ReadErrorKind::Unreadable, name))
    }
}

pub(super) fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = binary.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let mut made = b"glTF\x02\0\0\0".to_vec();
    made.extend_from_slice(&((28 + json.len() + binary.len()) as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json), (b"BIN\0", &binary)] {
        made.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
        made.extend_from_slice(kind);
        made.extend_from_slice(chunk);
    }
    made
}

pub(super) fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

pub(super) fn shorts(values: &[u16]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// A triangle at (0, 0, 0), (1, 0, 0) and (0, 1, 0): positions at byte 0, indices at byte 36.
pub(super) fn triangle_bytes() -> Vec<u8> {
    [floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]), shorts(&[0, 1, 2, 0])].concat()
}

pub(super) const TRIANGLE_LISTS: &str = r#""asset":{"version":"2.0"},"buffers":[{"byteLength":44}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
    "meshes":[{"name":"t","primitives":[{"attributes":{"POSITION":0},"indices":1}]}]"#;

/// Returns a file of the triangle with other members of the JSON object.
pub(super) fn triangle_file(more: &str) -> Vec<u8> {
    glb(&format!("{{{TRIANGLE_LISTS},{more}}}"), &triangle_bytes())
}

pub(super) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    read_gltf(bytes, &NoResources, &ReadOptions::default())
}

pub(super) fn error_text(bytes: &[u8]) -> String {
    read(bytes).expect_err("the file is not valid").to_string()
}

/// Returns the document as one mesh.
pub(super) fn flat(bytes: &[u8]) -> Mesh {
    read(bytes).expect("valid").into_joined(1 << 30).expect("small").meshes.remove(0)
}

pub(super) fn written(document: &Document, is_binary: bool, resources: &dyn Resources) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let mut target =
        Target { main_file: &mut bytes, stem: "a", beside: &mut |_, _| panic!("the file needs no other"), resources };
    let write = if is_binary { write_glb } else { write_gltf };
    let losses = write(document, &mut target, &WriteOptions::default()).expect("written");
    (bytes, losses)
}

/// Returns a document after writing and reading.
pub(super) fn returned(document: &Document) -> Document {
    let (binary, _) = written(document, true, &NoResources);
    let (text, _) = written(document, false, &NoResources);
    let made = read(&binary).expect("valid");
    assert_eq!(made.meshes, read(&text).expect("valid").meshes);
    assert_eq!(binary, written(document, true, &NoResources).0, "the bytes depend on the document alone");
    made
}

/// Returns whether each edge has two faces in opposite directions, where vertices at one place are one.
pub(super) fn is_closed(mesh: &Mesh) -> bool {
    let mut edges: BTreeMap<(u32, u32), i32> = BTreeMap::new();
    for face in 0..mesh.face_count() {
        let vertices: Vec<u32> = mesh.face(face).iter().map(|&vertex| mesh.representative(vertex)).collect();
        for (place, &a) in vertices.iter().enumerate() {
            let b = vertices[(place + 1) % vertices.len()];
            *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    !edges.is_empty() && edges.values().all(|&sum| sum == 0)
}

/// Returns the area and the volume of a mesh whose polygons are convex.
pub(super) fn area_and_volume(mesh: &Mesh) -> (f64, f64) {
    let (mut area, mut volume) = (0.0, 0.0);
    for face in 0..mesh.face_count() {
        let points: Vec<[f64; 3]> = mesh.face(face).iter().map(|&v| mesh.positions.get(v as usize)).collect();
        for k in 1..points.len() - 1 {
            let [a, b, c] = [points[0], points[k], points[k + 1]];
            let [u, v]: [[f64; 3]; 2] = [b, c].map(|p| std::array::from_fn(|axis| p[axis] - a[axis]));
            let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            area += 0.5 * n.iter().map(|x| x * x).sum::<f64>().sqrt();
            volume += (0..3).map(|axis| n[axis] * a[axis]).sum::<f64>() / 6.0;
        }
    }
    (area, volume)
}

/// Returns a box of 1 x 2 x 3 with 8 vertices and 6 quads.
pub(super) fn box_mesh() -> Mesh {
    let points = (0..8).map(|v| [f64::from(v & 1), f64::from(v >> 1 & 1) * 2.0, f64::from(v >> 2) * 3.0]).collect();
    let corners = vec![0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
    Mesh {
        positions: crate::mesh::Positions::F64(points),
        face_offsets: (0..=6).map(|face| 4 * face).collect(),
        corners,
        ..Mesh::default()
    }
}
