use super::read_off;
use crate::test_measures::{area_and_volume, is_closed, mesh_from_faces, mutate, mutations, write_to_bytes};
use crate::{Document, Format, Mesh, Positions, ReadOptions, Values, WriteOptions};
use proptest::prelude::*;

const TAIL: &str = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const POINTS: &str = "0 0 0\n30 0 0\n0 20 0\n0 0 10\n";

fn read(bytes: impl AsRef<[u8]>) -> Document {
    read_off(bytes.as_ref(), &ReadOptions::default()).expect("a file that is accepted")
}

fn message(bytes: impl AsRef<[u8]>) -> String {
    read_off(bytes.as_ref(), &ReadOptions::default()).expect_err("a file that is refused").to_string()
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| note.text.as_str()).collect()
}

fn write(document: &Document) -> (String, Vec<String>) {
    let (bytes, losses) = write_to_bytes(document, Format::Off, &WriteOptions::default()).expect("a mesh");
    (String::from_utf8(bytes).expect("text"), losses)
}

#[test]
fn headers_are_read_in_many_spellings() {
    for (head, note) in [
        ("OFF\n4 4 0\n", ""),
        ("OFF4 4 0\n", ""),
        ("OFF 4 4 0\n", ""),
        ("off\n4 4 6\n", ""),
        ("OFF\n4 4\n", ""),
        ("OFF\n4\n4\n6\n", ""),
        ("\u{feff}# by hand\n\n  OFF # word\n# counts\n4 4 6 # counts\n\n", ""),
        ("nOFF\n3\n4 4 0\n", ""),
        ("4 4 0\n", "the word OFF is missing"),
    ] {
        let document = read(format!("{head}{POINTS}# faces\n{TAIL}"));
        let mesh = &document.meshes[0];
        assert_eq!((mesh.positions.len(), mesh.face_count()), (4, 4), "{head}");
        assert!(is_closed(mesh) && (area_and_volume(mesh).1 - 1000.0).abs() < 1e-9);
        assert_eq!(notes(&document).join(""), note);
        let returns = format!("{head}{POINTS}# faces\n{TAIL}").replace('\n', "\r");
        assert_eq!(read(returns).meshes[0].face_count(), 4);
    }
    let document = read(format!("4OFF\n4 4 0\n0 0 0 1\n60 0 0 2\n0 10 0 0.5\n0 0 10 1\n{TAIL}"));
    assert!((area_and_volume(&document.meshes[0]).1 - 1000.0).abs() < 1e-9);
}

#[test]
fn colours_normals_and_texture_coordinates_are_told_apart() {
    let triangle = "3 0 1 2\n";
    let file = |word: &str, rows: [&str; 3]| {
        let lines: Vec<String> =
            ["0 0 0", "1 0 0", "0 1 0"].iter().zip(rows).map(|(point, row)| format!("{point} {row}\n")).collect();
        read(format!("{word}\n3 1 0\n{}{triangle}", lines.concat())).meshes[0].clone()
    };
    // As MeshLab writes: colours before normals, which need not have length 1.
    let mesh = file("NCOFF", ["255 0 0 255 0 0 2.5", "0 255 0 255 0 0.5 2", "0 0 255 255 0 0 1"]);
    assert_eq!(mesh.vertex_colours, [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]]);
    assert_eq!(mesh.normals, Values::Vertices(vec![[0.0, 0.0, 2.5], [0.0, 0.5, 2.0], [0.0, 0.0, 1.0]]));
    // As Geomview has it: normals first, and parts from 0 to 1.
    for word in ["CNOFF", "NCOFF"] {
        let mesh = file(word, ["0 0 1 1 0 0 1", "0 0 1 0 1 0 1", "0 0 1 0 0 .2 .6"]);
        assert_eq!(mesh.vertex_colours, [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 0.2, 0.6]]);
        assert_eq!(mesh.normals, Values::Vertices(vec![[0.0, 0.0, 1.0]; 3]));
    }
    let mesh = file("COFF", ["9 8 7", "6 5 4 # green", "3 2 255"]);
    assert_eq!(mesh.vertex_colours[2], [3.0 / 255.0, 2.0 / 255.0, 1.0, 1.0]);
    let mesh = file("STCNOFF", ["0 0 1 1 0 0 1 .25 .5", "0 0 1 0 1 0 1 1 0", "0 0 1 0 0 1 1 0 1"]);
    assert_eq!(mesh.texcoords, Values::Vertices(vec![[0.25, 0.5], [1.0, 0.0], [0.0, 1.0]]));
    let mesh = read(format!("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n{}", "3 0 1 2 255 128 0\n3 0 1 2 0 0 0 51\n"));
    let colours = [[1.0; 4], [1.0, 128.0 / 255.0, 0.0, 1.0], [0.0, 0.0, 0.0, 0.2]];
    assert_eq!(mesh.meshes[0].face_colours, colours);
}

#[test]
fn deviations_are_noted() {
    let document = read(format!("OFF\n4 5 0\n{}2 0 1\n{TAIL}7 8\n", POINTS.replace("0 0 0", "0 0 0 1 2")));
    assert_eq!(document.meshes[0].face_count(), 4);
    assert_eq!(
        notes(&document),
        [
            "2 numbers behind each vertex, which the letters before OFF do not name, left out",
            "1 face with fewer than 3 corners left out",
            "\"7\" and what follows the last face are ignored",
        ]
    );
    let document = read(format!("OFF\n4 4 0\n{POINTS}{}", TAIL.replace("2 1\n", "2 1 7\n")));
    assert!(document.meshes[0].face_colours.is_empty());
    assert_eq!(notes(&document), ["1 face has its colour by a number in a table, which the file lacks, left out"]);
}

#[test]
fn points_without_faces_are_points() {
    let document = read("COFF\n2 0 0\n0 0 0 255 0 0\n1 2 3 0 0 255\n");
    assert!(document.meshes.is_empty());
    assert_eq!(document.points.positions, Positions::F64(vec![[0.0; 3], [1.0, 2.0, 3.0]]));
    assert_eq!(document.points.colours, [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]]);
    let (text, losses) = write(&document);
    assert_eq!(text, "COFF\n2 0 0\n0 0 0 255 0 0 255\n1 2 3 0 0 255 255\n");
    assert_eq!(losses, [""; 0]);
    assert_eq!(read("OFF 0 0 0").meshes[0].face_count(), 0);
}

#[test]
fn errors_name_line_and_element() {
    for (text, wanted) in [
        ("OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "4: vertex 1: \"x\" is not a number"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n", "5: vertex 2: the file ends before its numbers"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "6: face 0, corner 2: vertex 3 does not exist (the mesh has 3)"),
        (
            "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n",
            "6: face 0, corner 1: \"-1\" is not a whole number from 0 to 2^32 - 1",
        ),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1", "6: face 0, corner 2: the file ends"),
        ("solid\n", "1: the file begins with \"solid\", not with OFF"),
        ("", "1: the file is empty"),
        (
            "COFF\n1 1 0\n0 0 0 1\n",
            "3: vertex 0: 1 number follows its position, which does not fit the letters before OFF",
        ),
        ("OFF\n-3 1 0\n", "2: count of vertices: -3 is not between 0 and 2^32 - 2"),
        ("OFF\n4000000000 4000000000 0\n", "3: vertex 0: the file ends before its numbers"),
        ("OFF\n1 1 0\n0 0 0\n4000000000 0 0", "4: face 0, corner 2: the file ends"),
        ("nOFF\n5\n3 1 0\n", "points have 5 coordinates; only 3 are read"),
        ("PK\x03\x04", "this is a ZIP archive; unpack it by unzip, or name it .3mf if it is a 3MF file"),
    ] {
        assert_eq!(message(text), wanted);
    }
}

fn binary_file() -> Vec<u8> {
    let mut bytes = b"COFF BINARY\n".to_vec();
    let mut add = |value: u32| bytes.extend(value.to_be_bytes());
    [4, 4, 0].into_iter().for_each(&mut add);
    for point in [[0.0_f32; 3], [30.0, 0.0, 0.0], [0.0, 20.0, 0.0], [0.0, 0.0, 10.0]] {
        point.into_iter().for_each(|part| add(part.to_bits()));
        [1.0_f32, 0.5, 0.0, 1.0].into_iter().for_each(|part| add(part.to_bits()));
    }
    for face in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] {
        add(3);
        face.into_iter().for_each(&mut add);
        add(0);
    }
    bytes
}

#[test]
fn binary_files_are_read() {
    let bytes = binary_file();
    let mesh = &read(&bytes).meshes[0];
    assert!(is_closed(mesh) && (area_and_volume(mesh).1 - 1000.0).abs() < 1e-9);
    assert_eq!(mesh.vertex_colours, [[1.0, 0.5, 0.0, 1.0]; 4]);
    assert!(message(&bytes[..100]).starts_with("byte 80: vertex 2: the file ends; it announces 4 vertices"));
    assert!(message(&bytes[..bytes.len() - 1]).ends_with("face 3: the file ends"));
}

#[test]
fn files_come_back_as_they_were() {
    let points = [[0.1, 1.0 / 3.0, -1.000_000_000_000_000_2], [1e-300, 2e17, 3.0], [0.7, 0.0, 1e22], [0.0; 3]];
    let mut mesh = mesh_from_faces(&points, &[&[0, 1, 2], &[0, 3, 2, 1]]);
    mesh.normals = Values::Vertices(vec![[0.1, 0.2, 0.3], [0.5, 0.25, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
    mesh.texcoords = Values::Vertices(vec![[0.5, 0.25]; 4]);
    mesh.vertex_colours = vec![[1.0, 128.0 / 255.0, 0.0, 0.0]; 4];
    mesh.face_colours = vec![[0.1, 0.2, 0.3, 1.0], [1.0, 0.0, 0.0, 1.0]];
    let document = Document::from_mesh(mesh.clone());
    let (text, losses) = write(&document);
    assert_eq!(losses, [""; 0]);
    assert_eq!(read(&text).meshes[0], mesh, "{text}");
    for darkest in [0.0, 1.0 / 255.0, 2.0 / 255.0] {
        mesh.face_colours = vec![[darkest, 0.0, darkest, 1.0]; 2];
        let (text, _) = write(&Document::from_mesh(mesh.clone()));
        assert_eq!(read(&text).meshes[0], mesh, "{text}");
    }
    mesh.positions = Positions::F32(vec![[0.1, 0.2, 0.3]; 4]);
    assert!(write(&Document::from_mesh(mesh)).0.contains("\n0.1 0.2 0.3 "));
}

#[test]
fn split_vertices_are_merged() {
    let mut mesh =
        mesh_from_faces(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]], &[&[0, 1, 2], &[2, 3, 0]]);
    mesh.merge = vec![0, 1, 2, 1];
    mesh.normals = Values::Vertices(vec![[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
    mesh.face_materials = vec![0, crate::NO_MATERIAL];
    let mut document = Document::from_mesh(mesh);
    document.materials.push(crate::Material::default());
    let (text, losses) = write(&document);
    assert_eq!(text, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n");
    assert_eq!(
        losses,
        [
            "materials, which OFF files do not hold",
            "normals that differ at the corners of a vertex: OFF files hold one for each vertex"
        ]
    );
}

fn is_valid(mesh: &Mesh) -> bool {
    let (vertices, faces) = (mesh.positions.len(), mesh.face_count());
    mesh.corners.iter().all(|&vertex| (vertex as usize) < vertices)
        && mesh.face_offsets.last() == Some(&(mesh.corners.len() as u32))
        && mesh.face_offsets.windows(2).all(|pair| pair[0] + 3 <= pair[1])
        && [0, faces].contains(&mesh.face_colours.len())
        && [0, vertices].contains(&mesh.vertex_colours.len())
        && [&mesh.normals].iter().all(|values| match values {
            Values::Absent => true,
            Values::Vertices(values) => values.len() == vertices,
            Values::Corners(_) => false,
        })
}

proptest! {
    #[test]
    fn mutations_never_panic(kind in 0..3, changes in mutations()) {
        let mut bytes = match kind {
            0 => format!("OFF\n4 4 0\n{POINTS}{TAIL}").into_bytes(),
            1 => b"STNCOFF\n3 1 0\n0 0 0 1 2 3 4 5 6 .1 .2\n1 0 0 1 2 3 4 5 6 .1 .2\n0 1 0 1 2 3 4 5 6 .1 .2\n3 0 1 2 9 9 9\n".to_vec(),
            _ => binary_file(),
        };
        mutate(&mut bytes, &changes);
        if let Ok(document) = read_off(&bytes, &ReadOptions::default()) {
            prop_assert!(document.meshes.iter().all(is_valid));
            prop_assert!([0, document.points.positions.len()].contains(&document.points.colours.len()));
        }
    }
}
