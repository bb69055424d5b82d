//! Checks of documents and mutations of files for the tests of all formats.

use crate::document::Document;
use crate::material::NO_MATERIAL;
use crate::mesh::{Domain, Mesh, Values};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Panics if an index does not exist or a length does not agree.
pub(crate) fn assert_valid(document: &Document) {
    document.meshes.iter().for_each(|mesh| assert_valid_mesh(mesh, document.materials.len()));
    assert!(document.placements.iter().all(|placement| (placement.mesh as usize) < document.meshes.len()));
    let curves = &document.curves;
    assert_offsets(&curves.offsets, curves.closed.len(), curves.positions.len());
    let points = &document.points;
    assert!([0, points.positions.len()].contains(&points.normals.len()));
    assert!([0, points.positions.len()].contains(&points.colours.len()));
    let images = document.materials.iter().filter_map(|material| material.image);
    assert!(images.into_iter().all(|image| (image as usize) < document.images.len()));
}

fn assert_valid_mesh(mesh: &Mesh, material_count: usize) {
    let (vertices, faces) = (mesh.positions.len(), mesh.face_count());
    assert_offsets(&mesh.face_offsets, faces, mesh.corners.len());
    assert!((0..faces).all(|face| mesh.face_range(face).len() >= 3));
    assert!(mesh.corners.iter().all(|&vertex| (vertex as usize) < vertices));
    assert!([0, vertices].contains(&mesh.merge.len()));
    assert!(mesh.merge.iter().all(|&vertex| mesh.merge[vertex as usize] == vertex));
    assert_values(&mesh.normals, mesh);
    assert_values(&mesh.texcoords, mesh);
    assert!([0, vertices].contains(&mesh.vertex_colours.len()));
    assert!([0, faces].contains(&mesh.face_colours.len()));
    assert!(mesh.vertex_colours.iter().chain(&mesh.face_colours).flatten().all(|part| (0.0..=1.0).contains(part)));
    assert!([0, faces].contains(&mesh.face_materials.len()));
    assert!(mesh.face_materials.iter().all(|&m| m == NO_MATERIAL || (m as usize) < material_count));
    for property in &mesh.properties {
        assert_eq!(property.values.len(), if property.domain == Domain::Vertices { vertices } else { faces });
    }
}

fn assert_values<const N: usize>(values: &Values<N>, mesh: &Mesh) {
    match values {
        Values::Absent => {}
        Values::Vertices(values) => assert_eq!(values.len(), mesh.positions.len()),
        Values::Corners(values) => assert_eq!(values.len(), mesh.corners.len()),
    }
}

fn assert_offsets(offsets: &[u32], count: usize, end: usize) {
    assert_eq!(offsets.len(), count + 1);
    assert!(offsets[0] == 0 && offsets.is_sorted() && offsets[count] as usize == end);
}

/// Returns whether each edge of a mesh, between representatives, occurs once in each direction.
pub(crate) fn is_closed(mesh: &Mesh) -> bool {
    let mut edges: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for face in 0..mesh.face_count() {
        let vertices: Vec<u32> = mesh.face(face).iter().map(|&vertex| mesh.representative(vertex)).collect();
        for (place, &a) in vertices.iter().enumerate() {
            let b = vertices[(place + 1) % vertices.len()];
            *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { 1 << 16 };
        }
    }
    edges.values().all(|&count| count == 1 + (1 << 16))
}

/// A change of a file's bytes; places are parts of the length.
#[derive(Clone, Debug)]
pub(crate) enum Mutation {
    Flip { place: f64, bits: u8 },
    Cut { from: f64, to: f64 },
    Repeat { from: f64, to: f64 },
    Insert { place: f64, bytes: Vec<u8> },
}

impl Mutation {
    /// Makes one of all kinds of changes. Inserts words of headers too.
    pub(crate) fn strategy() -> impl Strategy<Value = Self> {
        const WORDS: [&[u8]; 8] =
            [b"-1", b"4000000000", b"99999999999999999999", b"nan", b"\n", b"0", b"\xff\xff\xff\xff", b"1e999"];
        let place = || 0.0..1.0_f64;
        let bytes = prop_oneof![
            proptest::collection::vec(any::<u8>(), 1..6),
            (0..WORDS.len()).prop_map(|word| WORDS[word].to_vec())
        ];
        prop_oneof![
            (place(), any::<u8>()).prop_map(|(place, bits)| Self::Flip { place, bits }),
            (place(), place()).prop_map(|(from, to)| Self::Cut { from, to }),
            (place(), place()).prop_map(|(from, to)| Self::Repeat { from, to }),
            (place(), bytes).prop_map(|(place, bytes)| Self::Insert { place, bytes }),
        ]
    }

    /// Changes the bytes. A cut or repeated range is a tenth of the file at most.
    pub(crate) fn apply(&self, file: &mut Vec<u8>) {
        let length = file.len() as f64;
        let range = |from: f64, to: f64| {
            let start = (from * length) as usize;
            start..(start + (to * length / 10.0) as usize + 1).min(file.len())
        };
        match self {
            Self::Flip { place, bits } => {
                if let Some(byte) = file.get_mut((place * length) as usize) {
                    *byte ^= bits;
                }
            }
            Self::Cut { from, to } => {
                let range = range(*from, *to);
                file.drain(range);
            }
            Self::Repeat { from, to } => {
                let range = range(*from, *to);
                let copy = file[range.clone()].to_vec();
                file.splice(range.end..range.end, copy);
            }
            Self::Insert { place, bytes } => {
                let place = (place * length) as usize;
                file.splice(place..place, bytes.iter().copied());
            }
        }
    }
}
