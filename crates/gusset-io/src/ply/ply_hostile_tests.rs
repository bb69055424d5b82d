//! Invalid and hostile PLY files.

use super::ply_tests::{LIST, XYZ, again, encoded, failure, header, note_texts, range_image, read, read_all};
use super::read_ply;
use crate::document_checks::{Mutation, assert_valid};
use crate::{Document, Place, ReadErrorKind, ReadOptions};
use proptest::prelude::*;
use std::time::Instant;

#[test]
fn a_name_that_one_section_has_twice_is_shared_once() {
    let twice = format!("element vertex 1\n{XYZ}property int a\nproperty int a\n");
    let once = format!("element vertex 1\n{XYZ}property int a\n");
    for (lines, rows) in [
        (format!("{twice}{once}{once}"), "0 0 0 1 9\n1 0 0 2\n0 1 0 3\n"),
        (format!("{once}{twice}{once}"), "0 0 0 1\n1 0 0 2 9\n0 1 0 3\n"),
    ] {
        let document = read(encoded(&format!("{lines}element face 1\n{LIST}"), &format!("{rows}3 0 1 2"), "ascii"));
        let [property] = &document.meshes[0].properties[..] else { panic!("one property") };
        assert_eq!((&*property.name, &property.values[..]), ("a", &[1.0, 2.0, 3.0][..]));
        let notes = note_texts(&document);
        assert!(notes.iter().all(|note| !note.contains("18446744073709551615")), "{notes:?}");
    }
}

#[test]
fn invalid_files_are_explained() {
    let body = |lines: &str, rows: &str| String::from_utf8(encoded(lines, rows, "ascii")).expect("text");
    let xyz = format!("element vertex 1\n{XYZ}");
    let cases: &[(&str, &str)] = &[
        ("", "1: the first line is not \"ply\""),
        (
            "version https://git-lfs.github.com/spec/v1\n",
            "this is a pointer to a file in Git LFS; get the file by git lfs pull",
        ),
        ("ply", "1: the file ends before \"end_header\""),
        ("ply\nend_header\n", "2: the header lacks the line \"format\""),
        ("ply\nformat text 1.0\n", "2: \"text\" is not a format: use ascii, binary_little_endian or binary_big_endian"),
        ("ply\nformat ascii 1.0\nformat binary_big_endian 1.0\n", "3: the header names two formats"),
        ("ply\nformat ascii 2\nelement point\n", "3: an element needs a name and a count: \"element vertex 8\""),
        ("ply\nelement vertex -1\n", "2: an element needs a name and a count: \"element vertex 8\""),
        ("ply\nproperty float x\n", "2: a property comes before the first element"),
        (
            "ply\nelement vertex 1\nproperty long x\n",
            "3: \"long\" is not a type: use uchar, int, float, double or another",
        ),
        ("ply\nelement vertex 1\nproperty list int x\n", "3: a property needs a type and a name: \"property float x\""),
        ("ply\nfarmat ascii 1.0\n", "2: the file ends before \"end_header\""),
        (&body("element vertex 1\nproperty float x\n", "1"), "the vertices lack the properties x, y and z"),
        (&body(&format!("{xyz}element face 1\nproperty int a\n"), "0 0 0 1"), "the faces lack the list vertex_indices"),
        (&body(&xyz, "0 0\nzero"), "9: vertex 0: \"zero\" is not a number"),
        (&body(&xyz, "0 0\n"), "9: the file ends in vertex 0; the header announces 1"),
        (&body(&header(1, 1), "0 0 0\n3 0 0 1\n"), "11: face 0, corner 2: vertex 1 does not exist (the mesh has 1)"),
        (&body(&header(1, 1), "0 0 0\n3 0 -1 0\n"), "11: face 0, corner 1: vertex -1 does not exist (the mesh has 1)"),
        (
            &body(&header(1, 1), "0 0 0\n3 0 0.5 0\n"),
            "11: face 0, corner 1: vertex 0.5 does not exist (the mesh has 1)",
        ),
        (
            &body(&header(1, 1), "0 0 0\n-3 0\n"),
            "11: face 0: the list \"vertex_indices\" cannot have -3 numbers in the rest of the file",
        ),
    ];
    for (file, message) in cases {
        assert_eq!(failure(file).to_string(), *message, "{file}");
    }
    let mut binary = encoded(&header(3, 1), "0 0 0 1 0 0 0 1 0 3 0 1 -1", "binary_big_endian");
    let size = binary.len();
    let error = failure(&binary);
    assert_eq!(error.message, "face 0, corner 2: vertex -1 does not exist (the mesh has 3)");
    assert_eq!(error.place, Place::Byte(size as u64 - 13));
    binary.truncate(size - 1);
    let list = "face 0: the list \"vertex_indices\" cannot have 3 numbers in the rest of the file";
    assert_eq!(failure(&binary).message, list);
    binary.truncate(size - 14);
    assert_eq!(failure(&binary).message, "the file ends in vertex 2; the header announces 3");
    let name = "x".repeat(1000) + "\u{7}\u{202e}";
    let error = failure(format!("ply\n{name}\n"));
    assert!(error.message.len() < 300 && !error.message.contains('\u{7}'));
}

#[test]
fn claims_of_hostile_headers_cost_nothing() {
    let begun = Instant::now();
    // Elements without properties.
    let document = read_all("element nothing 4000000000\nelement x 18446744073709551\n", "");
    assert_eq!(note_texts(&document)[0], "the element \"nothing\" of 4000000000 rows is left out");
    let errors = [
        (format!("element vertex 4000000000\n{XYZ}"), "ends in vertex 0"),
        (format!("element vertex 999999999999999999\n{XYZ}"), "ends in vertex 0"),
        ("element vertex 4000000000\n".into(), "lack the properties"),
        ("element face 4000000000\n".into(), "lack the list"),
        ("element tristrips 4000000000\n".into(), "lack the list"),
        (format!("element vertex 0\n{XYZ}element face 4000000000\n{LIST}"), "ends in face 0"),
        (
            "obj_info num_cols 65536\nobj_info num_rows 65536\nelement range_grid 4294967296\n\
             property list uchar int vertex_indices\n"
                .into(),
            "ends in range_grid 0",
        ),
        ("element x 4000000000\nproperty list uint double y\n".into(), "ends in x 0"),
    ];
    for (lines, message) in &errors {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let head = format!("ply\nformat {format} 1.0\n{lines}end_header\n");
            let error = failure(&head);
            assert!(error.message.contains(message), "{head} {error}");
        }
    }
    // Lists whose length is beyond the file.
    for (kind, length) in [("uint", "4294967295"), ("double", "1e300"), ("double", "nan"), ("int64", "-1")] {
        let lines = format!("element a 1\nproperty list {kind} double b\n");
        let file = encoded(&lines, &format!("{length}\n"), "ascii");
        assert_eq!(failure(file).kind, ReadErrorKind::Malformed);
    }
    let lines = "element a 1\nproperty list uint double b\n";
    let mut file = encoded(lines, "0", "binary_little_endian");
    let size = file.len();
    file[size - 4..].fill(0xff);
    assert!(failure(file).message.contains("cannot have 4294967295 numbers"));
    // Many elements of one name, and many names.
    let many: String = (0..20_000).map(|k| format!("element vertex 1\n{XYZ}property char p{k}\n")).collect();
    let rows = "0 0 0 1\n".repeat(20_000);
    assert_eq!(read(encoded(&many, &rows, "ascii")).points.positions.len(), 20_000);
    let names: String = (0..100_000).map(|k| format!("element e{k} 1\n")).collect();
    assert!(read(encoded(&names, "", "ascii")).notes.len() < 20);
    let columns: String = (0..50_000).map(|k| format!("property char p{k}\n")).collect();
    let lines = format!("element vertex 1\n{XYZ}{columns}element vertex 1\n{XYZ}{columns}");
    let rows = ("0 0 0".to_owned() + &" 1".repeat(50_000) + "\n").repeat(2);
    assert_eq!(read(encoded(&lines, &rows, "ascii")).points.positions.len(), 2);
    assert!(begun.elapsed().as_secs() < 60);
}

fn seeds() -> Vec<Vec<u8>> {
    let rich = "comment TextureFile a.png\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n\
        property uchar blue\nproperty int label\nelement face 2\nproperty list uchar int vertex_indices\n\
        property list uchar float texcoord\nproperty int texnumber\nelement edge 1\nproperty int vertex1\n";
    let rows = "0 0 0 0 0 1 1 2 3 4 1 0 0 0 0 1 1 2 3 4 0 1 0 0 0 1 1 2 3 4 3 0 1 2 6 0 0 1 0 0 1 0 3 2 1 0 0 0 7";
    let strips = format!("element vertex 3\n{XYZ}element tristrips 1\nproperty list int int vertex_indices\n");
    let (range, places, _) = range_image(5, 8, true);
    let cases = [(rich, rows), (&strips, "0 0 0 1 0 0 0 1 0 5 0 1 2 -1 2"), (&range, &places)];
    let formats = ["ascii", "binary_little_endian", "binary_big_endian"];
    cases.iter().flat_map(|(lines, rows)| formats.map(|format| encoded(lines, rows, format))).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]
    #[test]
    fn changed_files_never_panic(seed in 0..9_usize, changes in proptest::collection::vec(Mutation::strategy(), 1..5)) {
        let mut file = seeds().swap_remove(seed);
        changes.iter().for_each(|change| change.apply(&mut file));
        if let Ok(document) = read_ply(&file, &ReadOptions::default()) {
            assert_valid(&document);
            let (back, _) = again(&document);
            let faces = |document: &Document| document.meshes.first().map(|mesh| mesh.corners.clone());
            prop_assert_eq!(faces(&back), faces(&document));
        }
    }
}

/// VCGLIB writes a list that the header calls four numbers, and some programs leave out the word before a remark.
#[test]
fn surplus_words_and_bare_remarks_are_ignored() {
    let text = "ply\nformat ascii 1.0\nCreated by hand\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nend_header\n\
                0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 1 1 1 1\n3 0 2 1 9 1 1 1 1\n";
    let document = read(text);
    assert_eq!(document.meshes[0].corners, [0, 1, 2, 0, 2, 1]);
    let notes: Vec<_> = document.notes.iter().map(|note| (note.place, note.text.as_str())).collect();
    assert_eq!(notes[0], (Place::Line(3), "\"Created\" is not a word of PLY headers; the line is ignored"));
    assert!(notes.iter().any(|(place, text)| *place == Place::Line(15) && text.starts_with("2 rows have more words")));
}
