//! Files made by hand, in all encodings.

use super::{read_ply, write_ply};
use crate::document_checks::{assert_valid, is_closed};
use crate::{
    Document, Domain, ImageData, Loss, Mesh, NO_MATERIAL, NoResources, NumberKind, Place, Positions, Property,
    ReadError, ReadOptions, Target, Values, WriteOptions,
};

pub(super) fn read(bytes: impl AsRef<[u8]>) -> Document {
    let document = read_ply(bytes.as_ref(), &ReadOptions::default()).expect("a valid file");
    assert_valid(&document);
    document
}

pub(super) fn failure(bytes: impl AsRef<[u8]>) -> ReadError {
    read_ply(bytes.as_ref(), &ReadOptions::default()).expect_err("an invalid file")
}

pub(super) fn written(document: &Document, text: bool) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let mut beside = |_: &str, _: &[u8]| Ok(());
    let mut target = Target { main_file: &mut bytes, stem: "mesh", beside: &mut beside, resources: &NoResources };
    let options = WriteOptions { text, ..WriteOptions::default() };
    let losses = write_ply(document, &mut target, &options).expect("a file");
    (bytes, losses)
}

/// Writes as text and binary, and reads both back: they agree.
pub(super) fn again(document: &Document) -> (Document, Vec<Loss>) {
    let (text, losses) = written(document, true);
    let (binary, losses_of_binary) = written(document, false);
    assert_eq!(losses, losses_of_binary);
    let [text, binary] = [read(text), read(binary)];
    assert_eq!(format!("{text:?}"), format!("{binary:?}"));
    (binary, losses)
}

pub(super) fn note_texts(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| &note.text[..]).collect()
}

/// A header of these lines, and rows of words. Encodes each word by the type that the header gives.
pub(super) fn encoded(lines: &str, rows: &str, format: &str) -> Vec<u8> {
    let mut file = format!("ply\nformat {format} 1.0\n{lines}end_header\n").into_bytes();
    if format == "ascii" {
        file.extend(rows.bytes());
        return file;
    }
    let mut words = rows.split_whitespace();
    let mut put = |kind: &str| -> (f64, Vec<u8>) {
        let value: f64 = words.next().expect("a word for each number").parse().expect("a number");
        let mut bytes = match kind {
            "char" | "int8" => (value as i8).to_le_bytes().to_vec(),
            "uchar" | "uint8" => (value as u8).to_le_bytes().to_vec(),
            "short" => (value as i16).to_le_bytes().to_vec(),
            "ushort" => (value as u16).to_le_bytes().to_vec(),
            "int" | "int32" => (value as i32).to_le_bytes().to_vec(),
            "uint" => (value as u32).to_le_bytes().to_vec(),
            "int64" => (value as i64).to_le_bytes().to_vec(),
            "uint64" => (value as u64).to_le_bytes().to_vec(),
            "float" => (value as f32).to_le_bytes().to_vec(),
            _ => value.to_le_bytes().to_vec(),
        };
        if format == "binary_big_endian" {
            bytes.reverse();
        }
        (value, bytes)
    };
    let mut elements: Vec<(usize, Vec<Vec<&str>>)> = Vec::new();
    for line in lines.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[0] {
            "element" => elements.push((words[2].parse().expect("a count"), Vec::new())),
            "property" => elements.last_mut().expect("an element").1.push(words[1..].to_vec()),
            _ => {}
        }
    }
    for (count, columns) in elements.into_iter().filter(|(_, columns)| !columns.is_empty()) {
        for column in std::iter::repeat_n(columns, count).flatten() {
            let length = if column[0] == "list" {
                let (length, bytes) = put(column[1]);
                file.extend(bytes);
                length as usize
            } else {
                1
            };
            for _ in 0..length {
                file.extend(put(column[if column[0] == "list" { 2 } else { 0 }]).1);
            }
        }
    }
    file
}

/// Reads the file in all three encodings, which agree.
pub(super) fn read_all(lines: &str, rows: &str) -> Document {
    let [text, little, big] =
        ["ascii", "binary_little_endian", "binary_big_endian"].map(|format| read(encoded(lines, rows, format)));
    assert_eq!(format!("{text:?}"), format!("{little:?}"));
    assert_eq!(format!("{text:?}"), format!("{big:?}"));
    text
}

pub(super) const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
pub(super) const LIST: &str = "property list uchar int vertex_indices\n";

pub(super) fn header(vertices: usize, faces: usize) -> String {
    format!("element vertex {vertices}\n{XYZ}element face {faces}\n{LIST}")
}

#[test]
fn all_attributes_are_read_in_all_encodings() {
    let lines = "comment of a scanner\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n\
        property float nx\nproperty float ny\nproperty float nz\nproperty uchar RED\nproperty uchar Green\n\
        property uchar blue\nproperty uchar Alpha\nproperty float s\nproperty float t\nproperty short quality\n\
        element face 2\nproperty uchar red\nproperty list uchar uint vertex_index\nproperty uchar green\n\
        property uchar blue\nproperty double area\nproperty list int float weights\n";
    let rows = "0 0 0 0 0 1 255 0 51 255 0 0 -7\n1 0.1 0 0 0 1 0 255 0 0 1 0 8\n\
        1 1 0.5 0 0 1 0 0 255 255 1 1 9\n0 1 0 0 1 0 1 2 3 4 0 1 10\n\
        10 3 0 1 2 20 30 0.5 0\n40 3 0 2 3 50 60 0.25 2 7 8\n";
    let document = read_all(lines, rows);
    let mesh = &document.meshes[0];
    assert_eq!(mesh.positions, Positions::F64(vec![[0.0; 3], [1.0, 0.1, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]]));
    assert_eq!((&mesh.face_offsets[..], &mesh.corners[..]), (&[0, 3, 6][..], &[0, 1, 2, 0, 2, 3][..]));
    assert_eq!(mesh.vertex_colours[0], [1.0, 0.0, 0.2, 1.0]);
    assert_eq!(mesh.vertex_colours[1], [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(mesh.face_colours[1], [40, 50, 60, 255].map(|part| part as f32 / 255.0));
    assert_eq!(mesh.normals.at_corner(5, 3), Some([0.0, 1.0, 0.0]));
    assert_eq!(mesh.texcoords.at_corner(2, 2), Some([1.0, 1.0]));
    let property = |name: &str, kind, domain, values: &[f64]| Property {
        name: name.into(),
        kind,
        domain,
        values: values.to_vec(),
    };
    let quality = property("quality", NumberKind::I16, Domain::Vertices, &[-7.0, 8.0, 9.0, 10.0]);
    assert_eq!(mesh.properties, [quality, property("area", NumberKind::F64, Domain::Faces, &[0.5, 0.25])]);
    assert_eq!(note_texts(&document), ["lists of the element \"face\" are left out: \"weights\""]);
    // Everything comes back, in text and binary.
    let (back, losses) = again(&document);
    assert_eq!((&back.meshes, losses), (&document.meshes, Vec::new()));
}

#[test]
fn lists_and_numbers_may_have_any_type() {
    let kinds = ["char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int64", "uint64"];
    for length in kinds {
        for index in kinds {
            let lines =
                format!("element vertex 3\n{XYZ}element face 1\nproperty list {length} {index} vertex_indices\n");
            let document = read_all(&lines, "0 0 0 1 0 0 0 1 0 3 2 1 0");
            assert_eq!(document.meshes[0].corners, [2, 1, 0], "{length} {index}");
        }
        let lines = header(3, 1).replace("float", length);
        let document = read_all(&lines, "0 0 0 1 0 0 0 100 0 3 2 1 0");
        assert_eq!(document.meshes[0].positions.get(2), [0.0, 100.0, 0.0]);
        let is_single = matches!(document.meshes[0].positions, Positions::F32(_));
        assert_eq!(is_single, ["char", "uchar", "short", "ushort", "float"].contains(&length));
    }
    // A list of another name that is the only one.
    let document = read_all(&header(3, 1).replace("vertex_indices", "corners"), "0 0 0 1 0 0 0 1 0 3 2 1 0");
    assert_eq!(document.meshes[0].corners, [2, 1, 0]);
    // Lists on vertices.
    let lines = header(3, 1).replace("property float y\n", "property list uchar float extra\nproperty float y\n");
    let document = read_all(&lines, "0 0 5 0 1 2 7 7 6 0 0 1 9 1 0 3 2 1 0");
    assert_eq!(document.meshes[0].positions.get(1), [1.0, 6.0, 0.0]);
}

#[test]
fn single_precision_is_rounded_once() {
    // Just above the middle between 1 and the next number of single precision; double precision rounds it to the middle.
    let rows = "1.00000005960464477539062500000001 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let document = read(encoded(&header(3, 1), rows, "ascii"));
    assert_eq!(document.meshes[0].positions.get(0)[0], f64::from(1.0_f32 + f32::EPSILON));
}

#[test]
fn headers_may_end_lines_in_any_way() {
    let file = encoded(&header(3, 1), "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "ascii");
    let text = String::from_utf8(file).expect("text");
    let expected = read(&text);
    for end in ["\r\n", "\r", " \n", "\n\n"] {
        assert_eq!(read(text.replace('\n', end)).meshes, expected.meshes, "{end:?}");
    }
    assert_eq!(read(format!("\u{feff}{text}")).meshes, expected.meshes);
    assert_eq!(read(text.replace("ply", "PLY").replace("element vertex", "ELEMENT Vertex")).meshes, expected.meshes);
    let binary = encoded(&header(3, 1), "13 10 0 1 0 0 0 1 0 3 0 1 2", "binary_little_endian");
    let at = binary.windows(11).position(|part| part == b"end_header\n").expect("a header") + 11;
    let head = String::from_utf8(binary[..at].to_vec()).expect("text");
    for end in ["\r\n", "\r"] {
        let changed: Vec<u8> = head.replace('\n', end).bytes().chain(binary[at..].iter().copied()).collect();
        assert_eq!(read(changed).meshes, read(&binary).meshes, "{end:?}");
    }
    let longer: Vec<u8> = binary.iter().copied().chain([0; 2]).collect();
    assert_eq!(note_texts(&read(longer)), ["2 bytes follow the last row and are ignored"]);
    let notes = read(text + "\n5 6\n7\n").notes;
    assert_eq!((notes.len(), notes[0].place), (1, Place::Line(15)));
}

#[test]
fn elements_come_in_any_order_and_number() {
    let triangle = "property list uchar uchar vertex_indices\n";
    let lines = format!(
        "element face 1\n{triangle}property float flag\nelement camera 1\nproperty int a\nproperty list uchar int b\n\
         element vertex 2\n{XYZ}property uchar label\nproperty float only\nelement vertex 0\nelement vertex 2\n\
         property double z\nproperty short label\nproperty double y\nproperty double x\n\
         element face 1\n{triangle}property float flag\nelement face 0\n"
    );
    let document = read_all(&lines, "3 0 1 2 0.5  6 1 7  0 0 0 1 5  1 0 0 2 5  0 -3 1 0  0 4 1 1  3 3 2 1 0.75");
    let mesh = &document.meshes[0];
    assert_eq!(mesh.positions, Positions::F64(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]));
    assert_eq!(mesh.corners, [0, 1, 2, 3, 2, 1]);
    let found: Vec<_> = mesh.properties.iter().map(|one| (&one.name[..], one.kind, &one.values[..])).collect();
    assert_eq!(
        found,
        [("label", NumberKind::F64, &[1.0, 2.0, -3.0, 4.0][..]), ("flag", NumberKind::F32, &[0.5, 0.75][..])]
    );
    assert_eq!(
        note_texts(&document),
        [
            "2 elements are called \"vertex\"; their rows are joined",
            "properties that only some vertex elements have are left out",
            "2 elements are called \"face\"; their rows are joined",
            "the element \"camera\" of 1 row is left out",
        ]
    );
}

#[test]
fn colours_have_several_forms() {
    let colour = |kind: &str, names: &str, rows: &str| {
        let lines: String = names.split(' ').map(|name| format!("property {kind} {name}\n")).collect();
        let lines = format!("element vertex 2\n{XYZ}{lines}");
        let document = read_all(&lines, rows);
        (document.points.colours.clone(), document.notes.len())
    };
    let half = 128.0 / 255.0;
    let expected = (vec![[1.0, 0.0, half, 1.0], [0.0, 0.0, 0.0, 1.0]], 0);
    assert_eq!(colour("uchar", "Red Green Blue", "0 0 0 255 0 128 0 0 0 0 0 0"), expected);
    assert_eq!(colour("int", "diffuse_red diffuse_green diffuse_blue", "0 0 0 255 -9 128 0 0 0 0 0 0"), expected);
    assert_eq!(colour("char", "red green blue", "0 0 0 -1 0 -128 0 0 0 0 0 0"), expected);
    assert_eq!(colour("ushort", "r g b", "0 0 0 65535 0 32896 0 0 0 0 0 0"), expected);
    let noted = (expected.0.clone(), 1);
    assert_eq!(colour("float", "red green blue", "0 0 0 255 0 128 0 0 0 0 0 0"), noted);
    let opaque = vec![[1.0, 0.0, 0.5, 0.25], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(colour("float", "red green blue alpha", "0 0 0 1 -2 0.5 0.25 0 0 0 0 0 0 1"), (opaque, 0));
    let nan = encoded(
        &format!("element vertex 1\n{XYZ}property float red\nproperty float green\nproperty float blue\n"),
        "0 0 0 nan inf 0",
        "ascii",
    );
    assert_eq!(read(nan).points.colours, [[0.0, 1.0, 0.0, 1.0]]);
}

#[test]
fn files_without_faces_are_points() {
    let lines = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
        property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
        property float intensity\nelement face 0\nproperty list uchar int vertex_indices\n";
    let document = read_all(lines, "1 2 3 0 0 1 255 0 0 9 4 5 6 0 1 0 0 0 255 9");
    assert!(document.meshes.is_empty() && document.placements.is_empty());
    assert_eq!(document.points.positions, Positions::F32(vec![[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
    assert_eq!(document.points.normals, [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
    assert_eq!(note_texts(&document), ["points keep only normals and colours, not intensity"]);
    let (back, losses) = again(&document);
    assert_eq!((back.points, losses), (document.points, Vec::new()));
    assert_eq!(read("ply\nformat ascii 1.0\nend_header\n"), Document::default());
    // Two corners are not a face.
    let document = read_all(&header(2, 2), "0 0 0 1 0 0 2 0 1 0");
    assert_eq!((document.points.positions.len(), document.meshes.len()), (2, 0));
    assert_eq!(note_texts(&document), ["2 faces with fewer than 3 corners are left out"]);
}

#[test]
fn strips_are_triangles() {
    let lines = format!("element vertex 5\n{XYZ}element tristrips 1\nproperty list int int vertex_indices\n");
    let points = "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 ";
    let document = read_all(&lines, &format!("{points} 9 0 1 2 3 -1 2 3 4 4"));
    assert_eq!(document.meshes[0].corners, [0, 1, 2, 2, 1, 3, 2, 3, 4]);
    let error = failure(encoded(&lines, &format!("{points} 3 0 1 5"), "ascii"));
    assert_eq!(error.to_string(), "10: tristrips 0, corner 2: vertex 5 does not exist (the mesh has 5)");
}

/// A plane with a step to another behind it, without a corner: the existing cells, and the cells of the step.
pub(super) fn range_image(rows: usize, columns: usize, info: bool) -> (String, String, usize) {
    let missing = [(0, 0), (4, 6)];
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let seen: Vec<_> = places.clone().filter(|place| !missing.contains(place)).collect();
    let info = if info { format!("obj_info num_cols {columns}\nobj_info num_rows {rows}\n") } else { String::new() };
    let (vertices, cells) = (seen.len(), rows * columns);
    let lines = format!(
        "{info}element vertex {vertices}\n{XYZ}element range_grid {cells}\nproperty list uchar int vertex_indices\n"
    );
    let points: String = seen.iter().map(|(i, j)| format!("{j} {i} {}\n", if *j < 8 { 0 } else { -20 })).collect();
    let grid: String = places
        .map(|place| {
            let vertex = seen.iter().position(|one| *one == place);
            vertex.map_or("0\n".into(), |vertex| format!("1 {vertex}\n"))
        })
        .collect();
    // Two triangles a cell, one for those with a missing corner, none across the step.
    (lines, points + &grid, 2 * (rows - 1) * (columns - 2) - 1 - 4)
}

#[test]
fn range_images_become_meshes() {
    let (lines, rows, faces) = range_image(9, 12, true);
    let document = read_all(&lines, &rows);
    assert_eq!((document.meshes[0].face_count(), document.notes.len()), (faces, 0));
    let error = failure(encoded(&lines, &(rows[..rows.rfind("1 ").expect("a place")].to_owned() + "1 999"), "ascii"));
    assert!(error.message.ends_with("vertex 999 does not exist (the mesh has 106)"), "{error}");
    let (lines, rows, _) = range_image(9, 12, false);
    let document = read_all(&lines, &rows);
    assert_eq!(document.points.positions.len(), 106);
    assert!(note_texts(&document)[0].contains("num_cols"));
    // Places that the scanner marks by NaN.
    let lines = format!("obj_info num_cols 2\nobj_info num_rows 2\nelement vertex 4\n{XYZ}element range_grid 4\n")
        + "property int vertex_index\n";
    assert_eq!(read_all(&lines, "0 0 0 1 0 0 1 1 0 NaN 0 0 0 1 3 2").meshes[0].corners, [0, 1, 2]);
    assert_eq!(read_all(&lines, "0 0 0 1 0 0 1 1 0 0 1 0 0 1 -1 2").meshes[0].corners, [0, 1, 2]);
}

/// A square of two triangles whose diagonal is a seam of the texture.
const SEAM: &str = "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0.5 0 1 1 0 1 -1\n3 0 3 4 0 0\n";

#[test]
fn texture_coordinates_at_corners_are_meshlabs() {
    let lines = format!(
        "comment TextureFile stone wall.png\ncomment TextureFile wood.jpg\nelement vertex 5\n{XYZ}element face 3\n{LIST}\
         property list uchar float texcoord\nproperty int texnumber\n"
    );
    let document = read_all(&lines, &format!("0 0 0 1 0 0 1 1 0 0 1 0 0 0 1\n{SEAM}"));
    let mesh = &document.meshes[0];
    let Values::Corners(pairs) = &mesh.texcoords else { panic!("{:?}", mesh.texcoords) };
    assert_eq!(pairs[..6], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert!(pairs[6..].iter().all(|pair| pair[0].is_nan()));
    assert_eq!(mesh.face_materials, [1, NO_MATERIAL, 0]);
    assert_eq!(document.images[0].data, ImageData::File("stone wall.png".into()));
    assert_eq!((&document.materials[1].name[..], document.materials[1].image), ("wood", Some(1)));
    let (back, losses) = again(&document);
    assert_eq!((format!("{:?}", back), losses.len()), (format!("{document:?}"), 0));
    // Without a seam they belong to vertices.
    let document = read_all(
        &lines,
        "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 3 0 1 2 6 0 0 1 0 1 1 0 3 0 2 3 6 0 0 1 1 0 1 0 \
        3 2 1 0 6 1 1 1 0 0 0 0",
    );
    assert!(matches!(document.meshes[0].texcoords, Values::Vertices(_)));
    let (bytes, _) = written(&document, true);
    let text = String::from_utf8(bytes).expect("text");
    assert!(
        text.contains("comment TextureFile stone wall.png\nelement vertex") && !text.contains("texnumber"),
        "{text}"
    );
}

#[test]
fn a_closed_mesh_of_split_vertices_stays_closed() {
    // A box of 6 faces with flat normals: 24 vertices that are 8.
    let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|x| x as f32);
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let normals = [[0, 0, -1], [0, 0, 1], [0, -1, 0], [0, 1, 0], [-1, 0, 0], [1, 0, 0]];
    let all: Vec<usize> = faces.into_iter().flatten().collect();
    let first = |k: usize| all.iter().position(|&one| one == k).expect("a corner") as u32;
    let mesh = Mesh {
        positions: Positions::F32(all.iter().map(|&k| corner(k)).collect()),
        face_offsets: (0..=6).map(|face| 4 * face).collect(),
        corners: (0..24).collect(),
        merge: all.iter().map(|&k| first(k)).collect(),
        normals: Values::Vertices((0..24).map(|k| normals[k / 4].map(f64::from)).collect()),
        texcoords: Values::Vertices((0..24).map(|k| [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]][k % 4]).collect()),
        vertex_colours: all.iter().map(|&k| [k as f32 / 255.0, 0.0, 0.0, 1.0]).collect(),
        ..Mesh::default()
    };
    assert!(is_closed(&mesh));
    let (back, losses) = again(&Document::from_mesh(mesh.clone()));
    let made = &back.meshes[0];
    assert_eq!((made.positions.len(), made.face_count(), is_closed(made)), (8, 6, true));
    let text = "normals that differ at the corners of a vertex: PLY files hold one for each vertex";
    assert_eq!(losses, [Loss(text.into())]);
    for corner in 0..24 {
        let vertex = made.corners[corner];
        assert_eq!(made.texcoords.at_corner(corner, vertex), mesh.texcoords.at_corner(corner, corner as u32));
        assert_eq!(made.vertex_colours[vertex as usize], mesh.vertex_colours[corner]);
    }
}

#[test]
fn written_numbers_are_exact_and_short() {
    let points = vec![[0.1, 1e-310, -0.0], [1.0 / 3.0, f64::NAN, f64::INFINITY], [500_000.123, 1e300, 2.0]];
    let mut mesh =
        Mesh { positions: Positions::F64(points), face_offsets: vec![0, 3], corners: vec![0, 1, 2], ..Mesh::default() };
    mesh.normals = Values::Vertices(vec![[0.5, 0.25, 1.0], Values::<3>::MISSING, [0.1, 0.2, 0.3]]);
    let kinds = [
        (NumberKind::I8, [-128.0, 127.0, 0.0]),
        (NumberKind::U8, [0.0, 255.0, 1.0]),
        (NumberKind::I16, [-32768.0, 32767.0, 1.0]),
        (NumberKind::U16, [65535.0, 0.0, 1.0]),
        (NumberKind::I32, [-2147483648.0, 2147483647.0, 1.0]),
        (NumberKind::U32, [4294967295.0, 0.0, 1.0]),
        (NumberKind::F32, [f64::from(0.1_f32), 0.0, 1e-3_f32.into()]),
        (NumberKind::F64, [0.1, 1e-320, -1e300]),
    ];
    mesh.properties = kinds
        .map(|(kind, values)| Property {
            name: format!("{kind:?}"),
            kind,
            domain: Domain::Vertices,
            values: values.to_vec(),
        })
        .to_vec();
    let document = Document::from_mesh(mesh);
    let (back, losses) = again(&document);
    let bits = |document: &Document| -> Vec<[u64; 3]> {
        document.meshes[0].positions.iter().map(|point| point.map(f64::to_bits)).collect()
    };
    assert_eq!(bits(&back), bits(&document));
    assert_eq!((&back.meshes[0].properties, losses.len()), (&document.meshes[0].properties, 0));
    let text = String::from_utf8(written(&document, true).0).expect("text");
    assert!(text.contains("\n0.1 1e-310 -0 0.5 0.25 1 -128 0 -32768 65535 -2147483648 4294967295 0.1 0.1\n"), "{text}");
    // Numbers that a type cannot hold become the nearest.
    let mut document = document;
    document.meshes[0].properties[1].values = vec![-5.0, 999.0, f64::NAN];
    assert_eq!(again(&document).0.meshes[0].properties[1].values, [0.0, 255.0, 0.0]);
    // Exact single precision is written as such.
    document.meshes[0].positions = Positions::F64(vec![[0.5, 0.25, 1.0]; 3]);
    assert!(matches!(again(&document).0.meshes[0].positions, Positions::F32(_)));
}

#[test]
fn faces_may_have_many_corners_and_names_are_words() {
    let count = 300_u32;
    let mut mesh = Mesh {
        positions: Positions::F32((0..count).map(|k| [k as f32, (k * k) as f32, 0.0]).collect()),
        face_offsets: vec![0, count],
        corners: (0..count).collect(),
        ..Mesh::default()
    };
    mesh.properties =
        vec![Property { name: "a b\n".into(), kind: NumberKind::U8, domain: Domain::Faces, values: vec![1.0] }];
    mesh.face_colours = vec![[0.3, 1.0, 0.0, 0.5]];
    let (back, losses) = again(&Document::from_mesh(mesh.clone()));
    assert_eq!((&back.meshes[0].corners, &back.meshes[0].properties[0].name[..]), (&mesh.corners, "a_b_"));
    assert_eq!(losses, [Loss("shades of colours between 256 steps".into())]);
}

#[test]
fn materials_and_curves_are_lost() {
    let mut document = read_all(&header(3, 1), "0 0 0 1 0 0 0 1 0 3 0 1 2");
    document.materials = vec![crate::Material::default()];
    document.meshes[0].face_materials = vec![0];
    document.curves.offsets.push(0);
    document.curves.closed.push(true);
    document.points.positions = Positions::F32(vec![[0.0; 3]]);
    let (_, losses) = again(&document);
    let texts: Vec<&str> = losses.iter().map(|loss| &loss.0[..]).collect();
    assert_eq!(
        texts,
        [
            "materials, which PLY files do not hold",
            "points beside a mesh, which PLY files do not hold",
            "curves, which PLY files do not hold",
        ]
    );
}
