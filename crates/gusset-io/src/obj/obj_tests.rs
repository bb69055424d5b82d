//! Files that the reader of OBJ accepts, and its notes.

use super::obj_assembly::read_content_in_chunks;
use super::read_obj;
use super::read_obj::document_from_content;
use crate::document::Document;
use crate::error::{Place, ReadErrorKind};
use crate::material::NO_MATERIAL;
use crate::mesh::{Mesh, Values};
use crate::options::ReadOptions;
use crate::resources::NoResources;

pub(super) fn read(text: &str) -> Document {
    read_obj(text.as_bytes(), &NoResources, &ReadOptions::default()).expect("the file is valid")
}

fn read_mesh(text: &str) -> Mesh {
    read(text).meshes.remove(0)
}

fn error(text: &str) -> String {
    let error = read_obj(text.as_bytes(), &NoResources, &ReadOptions::default()).expect_err("the file is not valid");
    assert_eq!(error.kind, ReadErrorKind::Malformed);
    error.to_string()
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| &*note.text).collect()
}

/// Six times the signed volume of a triangle mesh.
pub(super) fn volume(mesh: &Mesh) -> f64 {
    let mut sum = 0.0;
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        for place in 1..vertices.len() - 1 {
            let [a, b, c] = [0, place, place + 1].map(|k| mesh.positions.get(vertices[k] as usize));
            sum += a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    sum / 6.0
}

/// Returns whether each edge has exactly two faces, in opposite directions.
pub(super) fn is_closed(mesh: &Mesh) -> bool {
    let mut edges = std::collections::HashMap::new();
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        for (place, &a) in vertices.iter().enumerate() {
            *edges.entry((a, vertices[(place + 1) % vertices.len()])).or_insert(0) += 1;
        }
    }
    edges.iter().all(|(&(a, b), &count)| count == 1 && edges.get(&(b, a)) == Some(&1))
}

const TETRAHEDRON: &str = "v 0 0 0\nv 30 0 0\nv 0 20 0\nv 0 0 10\n";

#[test]
fn slashes_without_indices_are_absent_values() {
    for (before, face) in [
        ("", "f 1// 3// 2//\nf 1// 2// 4//\nf 2// 3// 4//\nf 1// 4// 3//\n"),
        (
            "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n",
            "f 1/1/ 3/3/ 2/2/\nf 1/1/ 2/2/ 4/4/\nf 2/2/ 3/3/ 4/4/\nf 1/1/ 4/4/ 3/3/\n",
        ),
    ] {
        let document = read(&format!("{before}{TETRAHEDRON}{face}"));
        let mesh = &document.meshes[0];
        assert!(is_closed(mesh));
        assert_eq!(volume(mesh), 30.0 * 20.0 * 10.0 / 6.0);
        assert!(mesh.normals.is_absent());
        assert_eq!(mesh.texcoords.is_absent(), before.is_empty());
        assert!(document.notes.is_empty());
    }
}

#[test]
fn absent_normals_are_noted() {
    let document =
        read(&format!("{TETRAHEDRON}f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 2//2 3//3 4//4\nf 1//1 4//4 3//3\n"));
    assert!(is_closed(&document.meshes[0]));
    assert!(document.meshes[0].normals.is_absent());
    assert_eq!(notes(&document), ["12 corners without its normal, which does not exist"]);
    assert_eq!(document.notes[0].place, Place::Line(5));
}

#[test]
fn negative_indices_count_from_the_line() {
    let boxes: String = (0..3)
        .map(|k| {
            let x = 4 * k;
            format!(
                "g p{k}\nv {x} 0 0\nv {x} 0 1\nv {x} 1 0\nv {x} 1 1\nv {0} 0 0\nv {0} 0 1\nv {0} 1 0\nv {0} 1 1\n\
                 f -8 -7 -5 -6\nf -4 -2 -1 -3\nf -8 -4 -3 -7\nf -6 -5 -1 -2\nf -8 -6 -2 -4\nf -7 -3 -1 -5\n",
                x + 2
            )
        })
        .collect();
    let document = read(&boxes);
    let mesh = &document.meshes[0];
    assert!(is_closed(mesh));
    assert_eq!((mesh.positions.len(), mesh.face_count()), (24, 18));
    assert_eq!(volume(mesh).abs(), 6.0);
    assert!(notes(&document)[0].contains("names of objects and groups"));
}

#[test]
fn values_at_corners_may_differ() {
    let mesh = read_mesh(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.25\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 3/4/1 2/2/1 4/1/1\n",
    );
    let Values::Corners(pairs) = &mesh.texcoords else { panic!("they differ at vertex 2") };
    assert_eq!(pairs[..], [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.25], [1.0, 0.0], [0.0, 0.0]]);
    assert_eq!(mesh.normals, Values::Vertices(vec![[0.0, 0.0, 1.0]; 4]));
}

#[test]
fn corners_without_values_are_missing() {
    let mesh = read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 1\nvt nan 0\nf 1/1 2 3\nf 1/2 2 3/1/\n");
    let pairs: Vec<_> = (0..6).map(|corner| mesh.texcoords.at_corner(corner, mesh.corners[corner])).collect();
    assert_eq!(pairs, [Some([0.5, 1.0]), None, None, None, None, Some([0.5, 1.0])]);
}

#[test]
fn positions_keep_all_digits() {
    let mesh = read_mesh(
        "v 0.1 1e-300 -123456789.0123456789\nv +1 2. .5\nv inf -inf nan\nv 1D0 0 0\n"
            .replace("v 1D0 0 0\n", "f 1 2 3\n")
            .as_str(),
    );
    assert_eq!(mesh.positions.get(0), [0.1, 1e-300, -123_456_789.012_345_67]);
    assert_eq!(mesh.positions.get(1), [1.0, 2.0, 0.5]);
    assert!(mesh.positions.get(2)[0] == f64::INFINITY && mesh.positions.get(2)[2].is_nan());
}

#[test]
fn lines_may_continue_end_or_begin_oddly() {
    let plain = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    for text in [
        "\u{feff}v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4",
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n",
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r",
        "v 0 \\\n0 0\nv 1 0 0\\\n\nv 1 1 0\nv 0 1 0\nf \\\r\n1 2 \\  \n 3 4\\",
        "# made by C:\\dir\\\n  v\t0 0 0# zero\nV 1 0 0 # one\n\nv 1 1 0\nv 0 1 0\n\tF 1 2 3 4# all\n#",
        "v 0 0 0 1.0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nfo 1 2 3 4\ns off\nlod 3\n",
        "f 1 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n",
    ] {
        let document = read(text);
        assert_eq!(document, plain, "{text}");
    }
    let utf16: Vec<u8> =
        "\u{feff}v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read_obj(&utf16, &NoResources, &ReadOptions::default()), Ok(plain));
}

#[test]
fn faces_have_any_number_of_corners() {
    let corners: String = (1..=1000).map(|k| format!(" {k}")).collect();
    let points: String = (0..1000).map(|k| format!("v {k} {} 0\n", k * k)).collect();
    let document = read(&format!("{points}f{corners}\nf 1 2\nf\nf 3 2 1\n"));
    assert_eq!(document.meshes[0].face_count(), 2);
    assert_eq!(document.meshes[0].face(0).len(), 1000);
    assert_eq!(notes(&document), ["2 faces of fewer than 3 corners: left out"]);
    assert_eq!(document.notes[0].place, Place::Line(1002));
}

#[test]
fn vertices_have_colours_of_two_scales() {
    let mesh = read_mesh("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 0 0 1 0.25\nf 1 2 3\n");
    assert_eq!(mesh.vertex_colours, [[1.0; 4], [1.0, 0.5, 0.0, 1.0], [0.0, 0.0, 1.0, 0.25]]);
    let document = read("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 0 1 0 255 255 255\nf 1 2 3\n");
    assert_eq!(document.meshes[0].vertex_colours, [[1.0, 0.0, 0.2, 1.0], [0.0, 0.0, 0.0, 1.0], [1.0; 4]]);
    assert!(notes(&document)[0].contains("steps from 0 to 255"));
    let document = read("v 0 0 0 255 0 51 128\nv 1 0 0 nan -1 0 0\nv 0 1 0 255 255 255 255\nf 1 2 3\n");
    assert_eq!(document.meshes[0].vertex_colours, [[1.0, 0.0, 0.2, 128.0 / 255.0], [1.0, 0.0, 0.0, 0.0], [1.0; 4]]);
    let document = read("v 0 0 0 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert!(document.meshes[0].vertex_colours.is_empty());
    assert!(notes(&document)[0].contains("fourth number"));
}

#[test]
fn lines_become_curves() {
    let document = read("v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nl 1 2 3 4 1\nl 2/1 -1/2\nl 3\n");
    let curves = &document.curves;
    assert_eq!((&curves.offsets[..], &curves.closed[..]), (&[0, 4, 6][..], &[true, false][..]));
    assert_eq!(curves.positions.get(4), [8.0, 0.0, 0.0]);
    assert_eq!(curves.positions.get(5), [0.0, 8.0, 0.0]);
    assert!(document.meshes.is_empty() && document.placements.is_empty());
    assert_eq!(notes(&document), ["1 polyline of fewer than 2 vertices: left out"]);
}

#[test]
fn vertices_of_lines_behind_the_mesh_are_no_part_of_it() {
    let document = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 6 6\nv 7 7 7 1 0 0\nf 1 2 3\nl 1 5 6\np 6 2\n");
    let mesh = &document.meshes[0];
    // Vertex 3 belongs to nothing, so that it stays.
    assert_eq!((mesh.positions.len(), mesh.vertex_colours.len()), (4, 4));
    assert_eq!(document.curves.positions.iter().map(|p| p[0]).collect::<Vec<_>>(), [0.0, 6.0, 7.0]);
    assert_eq!(document.points.positions.iter().map(|p| p[0]).collect::<Vec<_>>(), [7.0, 1.0]);
    assert_eq!(document.points.colours, [[1.0, 0.0, 0.0, 1.0], [1.0; 4]]);
}

#[test]
fn vertices_alone_are_points() {
    let document = read("vn 0 0 1\nv 1 2 3\nvn 1 0 0\nv 4 5 6\n");
    assert!(document.meshes.is_empty());
    assert_eq!(document.points.positions.get(1), [4.0, 5.0, 6.0]);
    assert_eq!(document.points.normals, [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
    assert!(notes(&document)[0].contains("read as points"));
    let document = read("vn 0 0 1\nv 1 2 3\nv 4 5 6\np 1 2\n");
    assert!(document.points.normals.is_empty() && document.notes.is_empty());
    for text in ["", "# nothing\n", "\n\n", "o empty\n"] {
        assert!(read(text).points.positions.is_empty(), "{text}");
    }
}

#[test]
fn free_forms_are_noted() {
    let document = read(
        "v 0 0 0\nv 1 0 0\nv 2 1 0 0.5\nvp 0 1\ncstype bspline\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 0 0 1 1 1\nend\ncall other.obj\nxyzzy 1\n",
    );
    assert!(document.points.positions.is_empty());
    let notes = notes(&document).join("; ");
    for text in ["1 free-form curve or surface", "not followed", "\"xyzzy\"", "weights"] {
        assert!(notes.contains(text), "{notes}");
    }
}

#[test]
fn errors_name_line_element_and_value() {
    let cases = [
        ("v 0 0 0\nv 1 0 0\n\nv 1 one 0\n", "4: vertex 2: \"one\" is not a number"),
        ("v 0 0\n", "1: vertex 0: it has 2 coordinates instead of 3"),
        ("v\n", "1: vertex 0: it has 0 coordinates instead of 3"),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 5\n",
            "5: face 1, corner 2: vertex 5 does not exist (the mesh has 3)",
        ),
        ("v 0 0 0\nf 0 1 1\n", "2: face 0, corner 0: vertex 0 does not exist (vertices count from 1)"),
        ("v 0 0 0\n\nf 1 1 -2\n", "3: face 0, corner 2: vertex -2 does not exist (it counts back from this line)"),
        (
            "v 0 0 0\nf 1 1 99999999999999999999\n",
            "2: face 0, corner 2: vertex 99999999999999999999 does not exist (the mesh has 1)",
        ),
        (
            "v 0 0 0\nf 1 1 -99999999999999999999/2\n",
            "2: face 0, corner 2: vertex -99999999999999999999 does not exist (it counts back from this line)",
        ),
        ("v 0 0 0\nf 1 1\nf 1 1 \\\n2\n", "3: face 0, corner 2: vertex 2 does not exist (the mesh has 1)"),
        ("v 0 0 0\nf 1 1 1.5\n", "2: face 0: corner 2: \"1.5\" is not an index"),
        ("v 0 0 0\nf 1 1/a 1\n", "2: face 0: corner 1: \"1/a\" is not an index"),
        ("v 0 0 0\nf 1 1/1/1/1 1\n", "2: face 0: corner 1: \"1/1/1/1\" is not an index"),
        ("v 0 0 0\nf 1 1 / 1\n", "2: face 0: corner 2: \"/\" is not an index"),
        ("v 0 0 0\nl 1 1\nl 1 2\n", "3: polyline 1, corner 1: vertex 2 does not exist (the mesh has 1)"),
        ("v 0 0 0\np 1\np 1 7\n", "3: statement p 1, corner 1: vertex 7 does not exist (the mesh has 1)"),
        ("vn 0 0 1\nvn 0 x 1\n", "2: normal 1: \"x\" is not a number"),
        ("vt 0 0\nvt 0 1,5\n", "2: texture coordinate 1: \"1,5\" is not a number"),
        ("v 0 0 0 1 1 x\n", "1: vertex 0: \"x\" is not a number"),
        ("ply \nformat ascii 1.0\n", "1: this is not an OBJ file: it is a PLY file; name it .ply"),
        (
            "\u{1f}what\n",
            "1: this is not an OBJ file: it has no statement like v or f; the first word is \"\u{fffd}what\"",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(error(text), message, "{text}");
    }
    let gzip = read_obj(b"\x1f\x8b\x08\0\0", &NoResources, &ReadOptions::default()).expect_err("it is compressed");
    assert!(gzip.message.contains("gunzip"));
    let fbx = read_obj(b"Kaydara FBX Binary\nv x\n", &NoResources, &ReadOptions::default()).expect_err("it is FBX");
    assert!(fbx.message.contains("Blender"));
}

#[test]
fn chunks_do_not_change_the_result() {
    let text = "v 0 0 0\nv 1 0 0\nusemtl red\nv 0 1 0 1 0 0\nvt 0 0\nvn 0 0 1\nf -3 -2 -1\nusemtl blue\nv 1 1 0\nf 2/1 4 \\\n3/-1/1 # end\nl 1 \\\n\\\n 2\n\
                o a\nvt 1 1\nf 1//1 2//-1 3//9\nf 1 2\np 3\ncurv 0\nf 3/2 2/1 1/-1\nusemtl red\nf 1 2 3 4\nmtllib none.mtl\nl 3 4 3\nwhat\n";
    let whole = read(text);
    assert_eq!(whole.meshes[0].face_materials, [0, 1, 1, 1, 0]);
    for size in 1..text.len() {
        let content = read_content_in_chunks(text.as_bytes(), size).expect("the file is valid");
        let document = document_from_content(content, &NoResources).expect("the file is valid");
        // Missing values are NaN, so that `==` would not do.
        assert_eq!(format!("{document:?}"), format!("{whole:?}"), "chunks of {size} bytes");
    }
    for wrong in ["f 1 2 9\n", "v 1 2 z\n", "p 5\n"] {
        let text = format!("{text}{wrong}");
        let whole = error(&text);
        for size in 1..text.len() {
            let error = read_content_in_chunks(text.as_bytes(), size).expect_err("the file is not valid");
            assert_eq!(error.to_string(), whole);
        }
    }
}

#[test]
fn faces_before_the_first_material_have_none() {
    let mesh = read_mesh(
        "v 0 0 0\nf 1 1 1\nusemtl a\nf 1 1 1\nusemtl (null)\nf 1 1 1\nusemtl None\nf 1 1 1\nusemtl\nf 1 1 1\nusemtl a\nf 1 1 1\n",
    );
    assert_eq!(mesh.face_materials, [NO_MATERIAL, 0, NO_MATERIAL, NO_MATERIAL, NO_MATERIAL, 0]);
    assert!(read_mesh("v 0 0 0\nusemtl none\nf 1 1 1\n").face_materials.is_empty());
}
