//! Objects as meshes.

use super::obj_tests::read;
use crate::document::Document;
use crate::mesh::Mesh;
use proptest::prelude::*;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";

fn names(document: &Document) -> Vec<&str> {
    document.meshes.iter().map(|mesh| &*mesh.name).collect()
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| &*note.text).collect()
}

#[test]
fn one_object_names_the_mesh() {
    assert_eq!(names(&read(&format!("o  my part \n{TRIANGLE}"))), ["my part"]);
    assert_eq!(names(&read(&format!("{TRIANGLE}o tail\n"))), ["tail"]);
    assert_eq!(names(&read(&format!("o none\no some\n{TRIANGLE}"))), ["some"]);
    assert_eq!(names(&read(&format!("o a\n{TRIANGLE}o a\nf 1 3 2\n"))), ["a"]);
}

#[test]
fn objects_with_vertices_of_their_own_are_meshes() {
    let document = read(&format!(
        "mtllib a.mtl\no a\nusemtl m\n{TRIANGLE}v 9 9 9 1 0 0\nvn 0 0 1\nvt 0 0\ng x\no b\n{TRIANGLE}f 5//1 7//1 6//1\n\
         o path\nv 5 5 5\nv 6 6 6\nl -1 -2\no a\nusemtl n\n{TRIANGLE}f -3/1 -2/1 -1/1\n"
    ));
    assert_eq!(names(&document), ["a", "b", "a"]);
    let placed: Vec<_> = document.placements.iter().map(|placement| (&*placement.name, placement.mesh)).collect();
    assert_eq!(placed, [("a", 0), ("b", 1), ("a", 2)]);
    let sizes: Vec<_> = document.meshes.iter().map(|mesh| (mesh.positions.len(), mesh.face_count())).collect();
    assert_eq!(sizes, [(4, 1), (3, 2), (3, 2)]);
    assert_eq!(document.meshes[1].corners, [0, 1, 2, 0, 2, 1]);
    assert_eq!(document.meshes[0].vertex_colours[3], [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(document.meshes[2].face_materials, [1, 1]);
    let has_normals: Vec<_> = document.meshes.iter().map(|mesh| !mesh.normals.is_absent()).collect();
    assert_eq!(has_normals, [false, true, false]);
    assert_eq!(document.curves.positions.get(0), [6.0; 3]);
    assert!(!notes(&document).iter().any(|note| note.starts_with("names of")));
}

#[test]
fn objects_that_share_vertices_are_one_mesh() {
    for text in [
        format!("o a\n{TRIANGLE}o b\nf 1 3 2\n"),
        format!("o a\n{TRIANGLE}o b\n{TRIANGLE}f 1 4 5\n"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no a\nf 1 2 3\no b\nf 1 2 4\n".to_owned(),
        // The loose vertex would be lost.
        format!("o a\n{TRIANGLE}o loose\nv 5 5 5\no b\n{TRIANGLE}"),
        // A face of the first object names a later vertex.
        format!("o a\n{TRIANGLE}f 1 2 4\no b\n{TRIANGLE}"),
    ] {
        let document = read(&text);
        assert_eq!(names(&document), [""], "{text}");
        assert_eq!(notes(&document), ["names of objects and groups: left out; the file is read as one mesh"]);
    }
    let document = read(&format!("o a\n{TRIANGLE}g x\no b\n{TRIANGLE}g y\n"));
    assert_eq!((names(&document), notes(&document)), (vec!["a", "b"], vec!["names of groups: left out"]));
}

/// Returns what a mesh says of each corner, and of each face.
fn told(mesh: &Mesh) -> String {
    let corners = mesh.corners.iter().zip(0..).map(|(&vertex, corner)| {
        let colour = mesh.vertex_colours.get(vertex as usize);
        (vertex, mesh.positions.get(vertex as usize), mesh.normals.at_corner(corner, vertex), colour)
    });
    let pairs = mesh.corners.iter().zip(0..).map(|(&vertex, corner)| mesh.texcoords.at_corner(corner, vertex));
    let materials: Vec<_> =
        (0..mesh.face_count()).map(|face| mesh.face_materials.get(face).copied().unwrap_or(u32::MAX)).collect();
    let points = mesh.positions.len();
    format!(
        "{points} {:?} {:?} {:?} {materials:?}",
        mesh.face_offsets,
        corners.collect::<Vec<_>>(),
        pairs.collect::<Vec<_>>()
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]
    #[test]
    fn objects_change_nothing_but_names(statements in proptest::collection::vec(0..12_usize, 1..40)) {
        let lines = [
            "o a", "o b", "v 0 0 1", "v 1 2 3 1 0 0", "v 4 5 6", "vn 0 0 1", "vt 0.5 1", "f -1 -1 -1", "f -1/-1/1 -2/1/-1 -1", "f -1 -2 -3",
            "usemtl m", "usemtl n",
        ];
        // Enough values, so that all indices are valid.
        let start = "vn 1 0 0\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
        let text: Vec<&str> = statements.iter().map(|&k| lines[k]).collect();
        let plain: Vec<&str> = text.iter().copied().filter(|line| !line.starts_with("o ")).collect();
        let [whole, plain] = [text, plain].map(|lines| read(&format!("{start}{}\n", lines.join("\n"))));
        let [whole, plain] = [whole, plain].map(|document| document.into_joined(1000).expect("it is small").meshes.remove(0));
        prop_assert_eq!(told(&whole), told(&plain));
    }
}
