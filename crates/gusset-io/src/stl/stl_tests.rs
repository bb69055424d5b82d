use super::read_stl;
use crate::test_measures::{area_and_volume, is_closed, mesh_from_faces, triangulated, write_to_bytes};
use crate::{Document, Format, Mesh, Placement, Positions, ReadOptions, WriteErrorKind, WriteOptions};
use proptest::prelude::*;

/// A tetrahedron with legs 30, 20 and 10: volume 1000.
const FACETS: [[[f32; 3]; 3]; 4] = {
    let (o, a, b, c) = ([0.0; 3], [30.0, 0.0, 0.0], [0.0, 20.0, 0.0], [0.0, 0.0, 10.0]);
    [[o, b, a], [o, a, c], [a, b, c], [o, c, b]]
};

fn text_file(head: &str, tail: &str) -> String {
    let mut text = head.to_string();
    for facet in FACETS {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for [x, y, z] in facet {
            text += &format!("      vertex {x:.3} {y:.3} {z:.3}\n");
        }
        text += "    endloop\n  endfacet\n";
    }
    text + tail
}

fn binary_file(header: &[u8], count: u32, attributes: [u16; 4]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for (facet, attribute) in FACETS.iter().zip(attributes) {
        bytes.extend([0; 12]);
        bytes.extend(facet.as_flattened().iter().flat_map(|part| part.to_le_bytes()));
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

fn read(bytes: impl AsRef<[u8]>) -> Document {
    read_stl(bytes.as_ref(), &ReadOptions::default()).expect("a file that is accepted")
}

fn message(bytes: impl AsRef<[u8]>) -> String {
    read_stl(bytes.as_ref(), &ReadOptions::default()).expect_err("a file that is refused").to_string()
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| note.text.as_str()).collect()
}

fn assert_tetrahedron(document: &Document) {
    let mesh = &document.meshes[0];
    assert_eq!((mesh.positions.len(), mesh.face_count()), (4, 4));
    assert!(is_closed(mesh));
    let (_, volume) = area_and_volume(mesh);
    assert!((volume - 1000.0).abs() < 1e-9, "{volume}");
}

#[test]
fn text_is_read_in_many_spellings() {
    let plain = text_file("solid part_7\n", "endsolid part_7\n");
    for text in [
        plain.clone(),
        plain.to_uppercase(),
        format!("  {plain}"),
        format!("\n\n \t{plain}"),
        format!("\u{feff}{plain}"),
        plain.replace('\n', "\r\n"),
        plain.replace('\n', "\r"),
        plain.replace('\n', " "),
        plain.replace("part_7", ""),
        plain.replace("normal 0 0 0", "normal -nan(ind) 1.#QNAN nan"),
        plain.replace("normal 0 0 0", ""),
        plain.replace("30.000", "+3.0e+1"),
    ] {
        let document = read(&text);
        assert_tetrahedron(&document);
        assert_eq!(notes(&document), [""; 0], "{text}");
    }
    let utf16: Vec<u8> = format!("\u{feff}{plain}").encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_tetrahedron(&read(utf16));
    assert_eq!(read(&plain).meshes[0].name, "part_7");
    assert_eq!(read(plain.replace('\n', " ")).meshes[0].name, "part_7");
}

#[test]
fn deviations_of_text_are_noted() {
    let document = read(text_file("# made by hand\n// twice\nsolid a b\n", "endsolid\n"));
    assert_tetrahedron(&document);
    assert_eq!(notes(&document), ["comments before \"solid\" are ignored"]);
    assert_eq!(document.meshes[0].name, "a b");
    let document = read(text_file("solid a\n", ""));
    assert_tetrahedron(&document);
    assert_eq!(notes(&document), ["the file ends without \"endsolid\""]);
    let whole = text_file("solid a\n", "endsolid a\n");
    let words = whole.replace("endloop", "endloop of a").replace("endfacet", "endfacet b ");
    for text in [words.clone(), words.replace('\n', " ")] {
        let document = read(&text);
        assert_tetrahedron(&document);
        assert_eq!(notes(&document), ["words after \"endloop\" or \"endfacet\" are ignored"], "{text}");
    }
    let (first, second) = whole.split_at(whole.match_indices("  facet").nth(2).expect("four facets").0);
    let document = read(format!("{first}endsolid a\nsolid b\n{second}"));
    assert_tetrahedron(&document);
    assert_eq!(notes(&document), ["the 2 solids of the file become one mesh"]);
    let quad = "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 endloop endfacet\nendsolid";
    let document = read(quad);
    assert_eq!(document.meshes[0].corners, [0, 1, 2, 3]);
    assert_eq!(notes(&document), ["1 facet has more than 3 corners"]);
    assert_eq!(read("solid nothing\nendsolid nothing\n").meshes[0].face_count(), 0);
}

#[test]
fn binary_files_are_told_from_text() {
    for header in
        [&b"part"[..], b"solid part_7", b"solid", b"solid facet\n", b"SOLID\nfacet normal", b"\xef\xbb\xbfsolid"]
    {
        let exact = binary_file(header, 4, [0; 4]);
        assert_tetrahedron(&read(&exact));
        assert!(matches!(read(&exact).meshes[0].positions, Positions::F32(_)));
    }
    let mut longer = binary_file(b"solid part_7", 4, [0; 4]);
    longer.push(0);
    let document = read(&longer);
    assert_tetrahedron(&document);
    assert_eq!(notes(&document), ["1 byte follows the last facet, ignored"]);
    longer.extend([b'x'; 20]);
    assert_eq!(notes(&read(&longer)), ["21 bytes follow the last facet, ignored"]);
    for (count, note) in [(0, "0 facets"), (3, "3 facets"), (u32::MAX, "4294967295 facets")] {
        let document = read(binary_file(b"solid part_7", count, [0; 4]));
        assert_tetrahedron(&document);
        assert_eq!(notes(&document), [format!("the header announces {note}; all 4 facets of the file are read")]);
    }
}

#[test]
fn merging_can_be_left_out() {
    for bytes in [binary_file(b"", 4, [0; 4]), text_file("solid\n", "endsolid\n").into_bytes()] {
        let options = ReadOptions { merge_repeated: false, ..ReadOptions::default() };
        let document = read_stl(&bytes, &options).expect("a valid file");
        let mesh = &document.meshes[0];
        assert_eq!((mesh.positions.len(), mesh.face_count()), (12, 4));
        assert_eq!(mesh.corners, (0..12).collect::<Vec<u32>>());
        assert_eq!(mesh.positions.get(7), [0.0, 20.0, 0.0]);
        assert!((area_and_volume(mesh).1 - 1000.0).abs() < 1e-9);
    }
}

#[test]
fn zeros_of_either_sign_are_one_point_and_nan_is_none() {
    let facet = |a, b, c| format!("facet normal 0 0 0 outer loop vertex {a} vertex {b} vertex {c} endloop endfacet\n");
    let text = format!("solid\n{}{}endsolid", facet("0 0 0", "1 0 0", "0 1 0"), facet("-0 0 -0.0", "0 -1 0", "1 -0 0"));
    assert_eq!(read(&text).meshes[0].corners, [0, 1, 2, 0, 3, 1]);
    let text =
        format!("solid\n{}{}endsolid", facet("nan 0 0", "inf 0 0", "0 1 0"), facet("nan 0 0", "0 1 0", "inf 0 0"));
    assert_eq!(read(&text).meshes[0].corners, [0, 1, 2, 3, 2, 1]);
}

#[test]
fn colours_of_facets_are_read() {
    let document = read(binary_file(b"", 4, [0x8000 | 31 << 10, 0x8000 | 31, 0, 0x8000 | 31 << 5]));
    let [red, green, blue] = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]];
    assert_eq!(document.meshes[0].face_colours, [red, blue, [1.0; 4], green]);
    let document = read(binary_file(b"COLOR=\xff\x00\x33\xff", 4, [31, 31 << 5, 31 << 10, 0x8000]));
    assert_eq!(document.meshes[0].face_colours, [red, green, blue, [1.0, 0.0, 0.2, 1.0]]);
    let document = read(binary_file(b"", 4, [0, 7, 0, 0]));
    assert!(document.meshes[0].face_colours.is_empty());
    assert_eq!(notes(&document), ["the attribute bytes of facets are not colours, left out"]);
}

#[test]
fn errors_name_line_and_facet() {
    for (text, wanted) in [
        ("", "the file is empty"),
        ("no mesh at all\n", "1: the file does not begin with \"solid\", and is too short for a binary STL file"),
        (
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
            "6: facet 0: \"endloop\" where \"vertex\" must be",
        ),
        (
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n",
            "5: facet 0, corner 1: \"x\" is not a number",
        ),
        (
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1",
            "5: facet 0, corner 1: the file ends before its numbers",
        ),
        ("solid a\nfacet normal 0 0 1 0 0 0 0\n", "2: facet 0: \"outer loop\" does not follow the normal"),
        (
            "solid a\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0\nendloop a facet",
            "3: facet 0: \"facet\" where \"endfacet\" must be",
        ),
        (
            "solid a\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0\nendloop endfacet a\na facet",
            "4: facet 1: \"a\" where \"facet\" or \"endsolid\" must be",
        ),
        ("solid a\nsomething\n", "2: facet 0: \"something\" where \"facet\" or \"endsolid\" must be"),
    ] {
        assert_eq!(message(text), wanted);
    }
    assert_eq!(
        message("words ".repeat(40)),
        "byte 234: the file does not begin with \"solid\", and is not a binary STL file"
    );
    let mut short = binary_file(b"", 4, [0; 4]);
    short.truncate(84 + 120);
    assert_eq!(message(&short), "byte 184: facet 2: the file ends; its header announces 4 facets");
    assert!(message(b"\x1f\x8b\x08\x00 and so on").contains("gunzip"));
}

#[test]
fn files_come_back_as_they_were() {
    let points = [[0.1, 0.0, 0.0], [1.0 / 3.0, 0.0, 0.0], [0.0, 1e-300, 0.5], [0.0, 0.0, 1e22]];
    let tetrahedron = mesh_from_faces(&points, &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]]);
    let document = Document::from_mesh(tetrahedron);
    let text = WriteOptions { text: true, ..WriteOptions::default() };
    let (bytes, losses) = write_to_bytes(&document, Format::Stl, &text).expect("a mesh that can be written");
    assert_eq!(losses, [""; 0]);
    let back = &read(&bytes).meshes[0];
    let order = [0, 2, 1, 3];
    assert_eq!(back.positions, Positions::F64(order.map(|vertex| points[vertex]).to_vec()));
    assert_eq!(back.corners, [0, 1, 2, 0, 2, 3, 2, 1, 3, 0, 3, 1]);
    let (_, losses) = write_to_bytes(&document, Format::Stl, &WriteOptions::default()).expect("a small rounding");
    assert!(losses[0].starts_with("positions rounded to single precision, by up to "));
}

#[test]
fn binary_files_come_back_bit_for_bit() {
    for bytes in [binary_file(b"gusset", 4, [0; 4])] {
        let (mut written, losses) =
            write_to_bytes(&read(&bytes), Format::Stl, &WriteOptions::default()).expect("a mesh");
        assert_eq!(losses, [""; 0]);
        // Apart from normals.
        for facet in 0..4 {
            written[84 + 50 * facet..][..12].fill(0);
        }
        assert_eq!(written, bytes);
    }
}

#[test]
fn writer_tells_losses() {
    let mut mesh = mesh_from_faces(
        &[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [9.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
        &[&[0, 1, 2, 3], &[2, 5, 6], &[1, 2]],
    );
    mesh.vertex_colours = vec![[1.0; 4]; 7];
    let losses = |mesh: &Mesh| {
        let document = Document::from_mesh(mesh.clone());
        write_to_bytes(&document, Format::Stl, &WriteOptions::default()).expect("a mesh that can be written").1
    };
    let always = [
        "colours of vertices, which STL files do not hold",
        "1 face of more than three corners: cut into triangles",
        "1 face of fewer than three corners",
        "1 vertex that no face uses",
    ];
    let mut wanted = always.to_vec();
    wanted.push("the difference between 1 vertex and others at the same positions");
    assert_eq!(losses(&mesh), wanted);
    mesh.merge = vec![0, 1, 2, 3, 4, 1, 6];
    assert_eq!(losses(&mesh), always);
}

#[test]
fn far_points_need_permission() {
    let shift = 5e6;
    let points = [[shift, 0.0, 0.0], [shift + 0.3, 0.0, 0.0], [shift, 0.3, 0.0]];
    let document = Document::from_mesh(mesh_from_faces(&points, &[&[0, 1, 2]]));
    let error = write_to_bytes(&document, Format::Stl, &WriteOptions::default()).expect_err("a large rounding");
    assert_eq!(error.kind, WriteErrorKind::Lossy);
    let lossy = WriteOptions { lossy: true, ..WriteOptions::default() };
    let (_, losses) = write_to_bytes(&document, Format::Stl, &lossy).expect("a permitted rounding");
    assert_eq!(losses, ["positions rounded to single precision, by up to 2.0e-1"]);
}

#[test]
fn scenes_are_joined() {
    let mut document = read(binary_file(b"", 4, [0; 4]));
    let mut moved = Placement::IDENTITY;
    moved[0] = [-1.0, 0.0, 0.0, 100.0];
    document.placements.push(Placement { name: String::new(), mesh: 0, transform: moved });
    let (bytes, _) = write_to_bytes(&document, Format::Stl, &WriteOptions::default()).expect("a scene");
    let mesh = &read(&bytes).meshes[0];
    assert_eq!((mesh.positions.len(), mesh.face_count()), (8, 8));
    assert!((area_and_volume(&triangulated(mesh)).1 - 2000.0).abs() < 1e-6);
}

#[test]
fn hostile_counts_and_numbers_cost_little() {
    let start = std::time::Instant::now();
    let mut bytes = vec![b' '; 80];
    bytes.extend(100_000_u32.to_le_bytes());
    bytes.resize(84 + 50 * 100_000, 0xff);
    let document = read(&bytes);
    assert_eq!(document.meshes[0].positions.len(), 300_000);
    bytes[80..84].copy_from_slice(&0xffff_fff0_u32.to_le_bytes());
    assert!(message(&bytes).contains("announces 4294967280 facets"));
    message("solid ".repeat(200_000) + "x\ny");
    assert!(start.elapsed().as_secs() < 20);
}

fn is_valid(document: &Document) -> bool {
    document.meshes.iter().all(|mesh| {
        mesh.corners.iter().all(|&vertex| (vertex as usize) < mesh.positions.len())
            && mesh.face_offsets.last() == Some(&(mesh.corners.len() as u32))
            && mesh.face_offsets.is_sorted()
            && [0, mesh.face_count()].contains(&mesh.face_colours.len())
    })
}

proptest! {
    #[test]
    fn mutations_never_panic(is_text in any::<bool>(), merge_repeated in any::<bool>(), changes in crate::test_measures::mutations()) {
        let mut bytes = if is_text {
            text_file("solid a\n", "endsolid a\n").into_bytes()
        } else {
            binary_file(b"solid", 4, [0x8000, 0, 1, 2])
        };
        crate::test_measures::mutate(&mut bytes, &changes);
        let options = ReadOptions { merge_repeated, ..ReadOptions::default() };
        if let Ok(document) = read_stl(&bytes, &options) {
            prop_assert!(is_valid(&document));
        }
    }
}
