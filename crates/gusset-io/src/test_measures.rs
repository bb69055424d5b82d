//! Measures of meshes, files in memory and changes of files, for tests.

use crate::mesh::{Mesh, Positions};
use crate::polygons::triangulate_face;
use crate::{Document, Format, Loss, NoResources, Target, WriteError, WriteOptions, write};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Makes a mesh of faces.
pub(crate) fn mesh_from_faces(points: &[[f64; 3]], faces: &[&[u32]]) -> Mesh {
    let mut mesh = Mesh { positions: Positions::F64(points.to_vec()), ..Mesh::default() };
    for face in faces {
        mesh.corners.extend_from_slice(face);
        mesh.face_offsets.push(mesh.corners.len() as u32);
    }
    mesh
}

/// Returns the mesh with its faces split into triangles.
pub(crate) fn triangulated(mesh: &Mesh) -> Mesh {
    let mut made = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
    let mut triangles = Vec::new();
    for face in 0..mesh.face_count() {
        triangulate_face(mesh, face, &mut triangles).unwrap();
        assert_eq!(triangles.len(), mesh.face(face).len().saturating_sub(2));
        for triangle in &triangles {
            made.corners.extend(triangle.map(|place| mesh.face(face)[place as usize]));
            made.face_offsets.push(made.corners.len() as u32);
        }
    }
    made
}

/// Returns the sum of areas of a mesh of triangles, and its volume.
pub(crate) fn area_and_volume(mesh: &Mesh) -> (f64, f64) {
    let (mut area, mut volume) = (0.0, 0.0);
    for face in 0..mesh.face_count() {
        let corners: [u32; 3] = mesh.face(face).try_into().expect("a triangle");
        let [a, b, c] = corners.map(|vertex| mesh.positions.get(vertex as usize));
        let [u, v] = [b, c].map(|end| [end[0] - a[0], end[1] - a[1], end[2] - a[2]]);
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        area += normal.iter().map(|part| part * part).sum::<f64>().sqrt() / 2.0;
        volume += normal.iter().zip(a).map(|(part, coordinate)| part * coordinate).sum::<f64>() / 6.0;
    }
    (area, volume)
}

/// Returns whether faces pass each edge as often in one direction as in the other.
pub(crate) fn is_closed(mesh: &Mesh) -> bool {
    let mut passes: BTreeMap<(u32, u32), i64> = BTreeMap::new();
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        for (place, &start) in vertices.iter().enumerate() {
            let end = vertices[(place + 1) % vertices.len()];
            *passes.entry((start.min(end), start.max(end))).or_default() += if start < end { 1 } else { -1 };
        }
    }
    passes.values().all(|&count| count == 0)
}

/// Writes a document into memory. Returns the bytes and the losses.
pub(crate) fn write_to_bytes(
    document: &Document,
    format: Format,
    options: &WriteOptions,
) -> Result<(Vec<u8>, Vec<String>), WriteError> {
    let mut bytes = Vec::new();
    let mut refuse = |name: &str, _: &[u8]| Err(std::io::Error::other(name.to_string()));
    let mut target = Target { main_file: &mut bytes, stem: "test", beside: &mut refuse, resources: &NoResources };
    let losses = write(document, format, &mut target, options)?;
    Ok((bytes, losses.into_iter().map(|Loss(text)| text).collect()))
}

/// A change of a file: kind, place and length as fractions of the file, and a byte.
pub(crate) type Mutation = (u8, f64, f64, u8);

/// Makes lists of changes.
pub(crate) fn mutations() -> impl Strategy<Value = Vec<Mutation>> {
    prop::collection::vec((0_u8..6, 0.0..1.0, 0.0..0.3, any::<u8>()), 1..8)
}

/// Flips, cuts, repeats, inserts or replaces bytes.
pub(crate) fn mutate(bytes: &mut Vec<u8>, changes: &[Mutation]) {
    for &(kind, place, length, byte) in changes {
        let start = ((place * bytes.len() as f64) as usize).min(bytes.len());
        let end = (start + (length * bytes.len() as f64) as usize).min(bytes.len());
        match kind {
            0 => bytes.iter_mut().skip(start).take(1).for_each(|value| *value ^= byte),
            1 => bytes.truncate(start),
            2 => {
                let repeated = bytes[start..end].to_vec();
                bytes.splice(start..start, repeated);
            }
            3 => bytes.insert(start, byte),
            4 => drop(bytes.drain(start..end)),
            _ => bytes
                .iter_mut()
                .skip(start)
                .take(1)
                .for_each(|value| *value = b"0123456789-+.eE \n#/,"[byte as usize % 20]),
        }
    }
}

/// Returns the signed area of a polygon in the plane.
pub(crate) fn polygon_area(points: &[[f64; 2]]) -> f64 {
    (0..points.len())
        .map(|place| (points[place], points[(place + 1) % points.len()]))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum::<f64>()
        / 2.0
}
