//! Written files: what comes back, what is lost, and what other programs rely on.

use super::gltf_test_files::*;
use super::{read_gltf, write_glb};
use crate::document::{Document, Placement};
use crate::error::WriteErrorKind;
use crate::material::{Image, ImageData, Material, NO_MATERIAL, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{NoResources, Target};

/// Returns the corners of a face from its least vertex on.
fn turned(mesh: &Mesh, face: usize) -> Vec<u32> {
    let corners = mesh.face(face);
    let first = (0..corners.len()).min_by_key(|&place| corners[place]).unwrap_or(0);
    [&corners[first..], &corners[..first]].concat()
}

fn assert_same_faces(a: &Mesh, b: &Mesh) {
    assert_eq!(a.face_count(), b.face_count());
    for face in 0..a.face_count() {
        assert_eq!(turned(a, face), turned(b, face), "face {face}");
    }
}

/// Returns the triangles of a written file.
fn flat_triangles(document: &Document) -> Mesh {
    let (text, _) = written(document, false, &NoResources);
    let text = String::from_utf8_lossy(&text).replace("FB_ngon_encoding", "none").replace("gusset_polygons", "none");
    flat(text.as_bytes())
}

#[test]
fn keeps_polygons() {
    let mesh = box_mesh();
    let again = returned(&Document::from_mesh(mesh.clone()));
    assert_same_faces(&again.meshes[0], &mesh);
    assert_eq!(area_and_volume(&again.meshes[0]), (22.0, 6.0));
    assert!(is_closed(&again.meshes[0]));
    // Other programs see 12 triangles.
    let (bytes, losses) = written(&Document::from_mesh(mesh), true, &NoResources);
    assert!(losses.is_empty());
    assert!(bytes.windows(10).any(|window| window == b"\"count\":36"));
}

#[test]
fn keeps_polygons_that_no_fan_covers() {
    // A U, beside a square and a triangle that share its vertices.
    let outline = [[0, 0], [7, 0], [7, 6], [5, 6], [5, 2], [2, 2], [2, 6], [0, 6]];
    let points = outline.iter().map(|&[x, y]| [f64::from(x), f64::from(y), 0.0]).collect();
    let mesh = Mesh {
        positions: Positions::F64(points),
        face_offsets: vec![0, 8, 12, 15, 23],
        corners: vec![0, 1, 2, 3, 4, 5, 6, 7, 3, 6, 5, 4, 3, 2, 6, 7, 6, 5, 4, 3, 2, 1, 0],
        ..Mesh::default()
    };
    assert_same_faces(&returned(&Document::from_mesh(mesh.clone())).meshes[0], &mesh);
    // Programs without the extension see triangles that cover the same area: 30 twice, and 12.
    let triangles = flat_triangles(&Document::from_mesh(mesh.clone()));
    assert_eq!((triangles.face_count(), area_and_volume(&triangles).0), (15, 72.0));
    // Extras that do not fit are ignored.
    let (text, _) = written(&Document::from_mesh(mesh), false, &NoResources);
    let text = String::from_utf8_lossy(&text).replace("[[0,6,0,", "[[0,6,4,");
    let document = read(text.as_bytes()).expect("valid");
    assert!(document.notes[0].text.contains("extras do not fit"));
}

#[test]
fn keeps_seams_as_values_of_corners() {
    let mut mesh = box_mesh();
    mesh.texcoords =
        Values::Corners((0..24).map(|corner| [f64::from(corner % 4) / 4.0, f64::from(corner / 12)]).collect());
    mesh.normals = Values::Vertices(vec![[0.0, 0.6_f32.into(), 0.8_f32.into()]; 8]);
    let again = returned(&Document::from_mesh(mesh.clone()));
    let made = &again.meshes[0];
    assert_eq!(made.positions.len(), 8);
    assert!(is_closed(made));
    assert_eq!(made.normals, mesh.normals);
    for face in 0..6 {
        for (place, &vertex) in made.face(face).iter().enumerate() {
            let old = mesh.face(face).iter().position(|&own| own == vertex).expect("same vertices");
            let corner = |mesh: &Mesh, place| mesh.texcoords.at_corner(mesh.face_range(face).start + place, vertex);
            assert_eq!(corner(made, place), corner(&mesh, old));
        }
    }
}

#[test]
fn keeps_different_vertices_at_one_place() {
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0_f32]];
    let mut mesh = Mesh {
        positions: Positions::F32(points),
        face_offsets: vec![0, 3, 6],
        corners: vec![0, 1, 2, 3, 4, 5],
        ..Mesh::default()
    };
    let again = &returned(&Document::from_mesh(mesh.clone())).meshes[0];
    assert_eq!((&again.positions, &again.corners), (&mesh.positions, &mesh.corners));
    assert!(again.merge.is_empty());
    mesh.merge = vec![0, 1, 2, 0, 1, 5];
    let again = &returned(&Document::from_mesh(mesh)).meshes[0];
    assert_eq!((again.positions.len(), &again.corners[..]), (4, &[0, 1, 2, 0, 1, 3][..]));
}

#[test]
fn ignores_numbers_of_vertices_that_another_program_has_moved() {
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0_f32]];
    let merge = vec![0, 1, 2, 0, 1, 5];
    let mesh = Mesh {
        positions: Positions::F32(points),
        face_offsets: vec![0, 3, 6],
        corners: (0..6).collect(),
        merge,
        ..Mesh::default()
    };
    let (mut bytes, _) = written(&Document::from_mesh(mesh), true, &NoResources);
    let start = bytes.windows(4).position(|window| window == b"BIN\0").expect("binary") + 4;
    // Vertices 2 and 3 change places.
    let (a, b) = (start + 24, start + 36);
    for byte in 0..12 {
        bytes.swap(a + byte, b + byte);
    }
    let made = &read(&bytes).expect("valid").meshes[0];
    assert_eq!((made.positions.len(), &made.merge[..]), (6, &[0, 1, 0, 3, 1, 5][..]));
}

#[test]
fn puts_a_far_origin_into_the_node() {
    // 4.5 million metres away with steps of 0.125: 24 bits reach 0.5 there.
    let shift = [4_512_345.0, 312_000.0, 100.0];
    let mut mesh = box_mesh();
    if let Positions::F64(points) = &mut mesh.positions {
        points.iter_mut().for_each(|point| *point = std::array::from_fn(|axis| 0.125 * point[axis] + shift[axis]));
    }
    let document = Document::from_mesh(mesh.clone());
    let (bytes, losses) = written(&document, true, &NoResources);
    assert!(losses.is_empty(), "{losses:?}");
    let made = flat(&bytes);
    assert_eq!(made.positions, mesh.positions);
    // Thirds are rounded where steps are small, and it is said.
    if let Positions::F64(points) = &mut mesh.positions {
        points.iter_mut().flatten().for_each(|x| *x += 1.0 / 3.0);
    }
    let (bytes, losses) = written(&Document::from_mesh(mesh.clone()), true, &NoResources);
    assert_eq!(losses[0].0, "positions rounded to single precision");
    for (a, b) in flat(&bytes).positions.iter().zip(mesh.positions.iter()) {
        assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-6));
    }
}

#[test]
fn refuses_to_move_points_far() {
    let points = vec![[0.0; 3], [1e9, 0.0, 0.0], [0.5, 1e-3, 0.1], [0.501, 2e-3, 0.1], [1e9 + 0.01, 0.0, 0.0]];
    let corners: Vec<u32> = std::iter::repeat_n([2, 3, 2], 5).flatten().chain([1, 4, 1]).collect();
    let faces = corners.len() as u32 / 3;
    let mesh = Mesh {
        positions: Positions::F64(points),
        face_offsets: (0..=faces).map(|face| 3 * face).collect(),
        corners,
        ..Mesh::default()
    };
    let document = Document::from_mesh(mesh);
    let mut bytes = Vec::new();
    let mut target = Target { main_file: &mut bytes, stem: "a", beside: &mut |_, _| Ok(()), resources: &NoResources };
    let error = write_glb(&document, &mut target, &WriteOptions::default()).expect_err("lossy");
    assert_eq!(error.kind, WriteErrorKind::Lossy);
    let lossy = WriteOptions { lossy: true, ..WriteOptions::default() };
    assert!(write_glb(&document, &mut target, &lossy).is_ok());
}

#[test]
fn keeps_scenes_names_and_transforms() {
    let transform = [[0.0, -1.0, 0.0, 0.1], [1.0, 0.0, 0.0, 1.0 / 3.0], [0.0, 0.0, 1.0, 1e6]];
    let mut document = Document::from_mesh(Mesh { name: "box \"1\"\n".into(), ..box_mesh() });
    document.placements.push(Placement { name: "turned".into(), mesh: 0, transform });
    let again = returned(&document);
    assert_eq!(again.placements, document.placements);
    assert_eq!(again.meshes[0].name, document.meshes[0].name);
}

#[test]
fn keeps_curves_and_points() {
    let mut document = Document::default();
    document.curves.positions = Positions::F64((0..9).map(|k| [f64::from(k), 0.5 * f64::from(k * k), 1e7]).collect());
    document.curves.offsets = vec![0, 3, 7, 9];
    document.curves.closed = vec![true, false, false];
    document.points.positions = Positions::F64(vec![[0.5, 1.0, 2.0], [3.0, 4.0, 5.0]]);
    document.points.normals = vec![[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    document.points.colours = vec![[1.0, 0.0, 0.2, 1.0], [0.0, 1.0, 0.6, 0.5]];
    let again = returned(&document);
    assert_eq!((again.curves, again.points), (document.curves, document.points));
}

#[test]
fn keeps_colours() {
    let steps: Vec<[f32; 4]> = (0..8).map(|k| [k * 36, k * 7, 255 - k, 128].map(|part| part as f32 / 255.0)).collect();
    let mesh = Mesh { vertex_colours: steps.clone(), ..box_mesh() };
    assert_eq!(returned(&Document::from_mesh(mesh)).meshes[0].vertex_colours, steps);
}

const PNG: &[u8] = b"\x89PNG\r\n\x1a\nand so on";

fn textured_document() -> Document {
    let image = |data| Image { name: String::new(), media_type: String::new(), data };
    let native = NativeMaterial::Gltf {
        material: r#"{"name":"old","normalTexture":{"index":0,"scale":2},"occlusionTexture":{"index":0,"texCoord":1},
            "emissiveTexture":{"index":1},"extensions":{"KHR_materials_ior":{"ior":1.4}}}"#
            .to_owned()
            .into(),
        textures: vec![("{\"magFilter\":9728}".into(), Some(0)), (String::new(), Some(1))].into(),
    };
    let lines = ["Kd 1 0 0", "map_Kd red.png", "Ns 10"].map(str::to_owned).to_vec();
    let mut document = Document::from_mesh(Mesh { face_materials: vec![1, NO_MATERIAL, 2, 1, 0, 2], ..box_mesh() });
    document.materials = vec![
        Material { name: "plain".into(), colour: [1.0, 0.0, 0.5, 0.5], ..Material::default() },
        Material {
            name: "red".into(),
            image: Some(2),
            native: Some(NativeMaterial::Mtl(lines)),
            ..Material::default()
        },
        Material { name: "new".into(), native: Some(native), ..Material::default() },
    ];
    document.images = vec![
        image(ImageData::Bytes(PNG.to_vec().into())),
        image(ImageData::File("gone.png".into())),
        image(ImageData::File("red.png".into())),
    ];
    document
}

#[test]
fn writes_materials_with_their_images() {
    let files = Files([("red.png".to_owned(), PNG.to_vec())].into());
    let (bytes, losses) = written(&textured_document(), true, &files);
    let losses: Vec<&str> = losses.iter().map(|loss| loss.0.as_str()).collect();
    assert_eq!(
        losses,
        [
            "all of material red except its diffuse colour and image",
            "a texture of material new that other texture coordinates show",
            "the image gone.png, which is not there",
        ]
    );
    let again = read_gltf(&bytes, &NoResources, &ReadOptions::default()).expect("valid");
    // In the order of their first use; faces without a material come last.
    let names: Vec<&str> = again.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["red", "new", "plain"]);
    assert_eq!(again.meshes[0].face_materials, [0, 0, 1, 1, 2, NO_MATERIAL]);
    assert_eq!(again.images.len(), 1, "equal images are stored once");
    assert!(matches!(&again.images[0].data, ImageData::Bytes(bytes) if **bytes == *PNG));
    assert_eq!((again.materials[0].image, again.materials[2].colour), (Some(0), [1.0, 0.0, 0.5, 0.5]));
    let Some(NativeMaterial::Gltf { material, textures }) = &again.materials[1].native else { panic!("native") };
    assert_eq!(
        &**material,
        r#"{"name":"new","normalTexture":{"index":0,"scale":2},"extensions":{"KHR_materials_ior":{"ior":1.4}}}"#
    );
    assert_eq!(textures[..], [("{\"magFilter\":9728}".to_owned(), Some(0))]);
    assert!(bytes.windows(21).any(|window| window == b"[\"FB_ngon_encoding\",\""));
}

#[test]
fn tells_losses() {
    let mut mesh = box_mesh();
    mesh.face_colours = vec![[1.0; 4]; 6];
    let quality =
        Property { name: "quality".into(), kind: NumberKind::F32, domain: Domain::Vertices, values: vec![0.0; 8] };
    mesh.properties = vec![quality];
    mesh.normals = Values::Vertices(vec![[0.1; 3]; 8]);
    mesh.texcoords = Values::Corners(vec![[f64::NAN; 2]; 24]);
    mesh.face_offsets.push(24);
    let mut document = Document::from_mesh(mesh);
    document.metres_per_unit = Some(0.001);
    document.meshes.push(Mesh::default());
    document.placements.push(Placement { name: String::new(), mesh: 1, transform: Placement::IDENTITY });
    let (_, losses) = written(&document, true, &NoResources);
    let losses: Vec<&str> = losses.iter().map(|loss| loss.0.as_str()).collect();
    assert_eq!(
        losses,
        [
            "normals rounded to single precision",
            "colours of faces, which glTF files do not hold",
            "quality of vertices, which glTF files do not hold",
            "1 face of fewer than three corners",
            "1 mesh without faces, which glTF files do not hold",
            "which corners lack texture coordinates: glTF files hold some for each",
            "the unit of length, 0.001 metres: numbers stay, and glTF files are in metres",
        ]
    );
    let (empty, _) = written(&Document::default(), true, &NoResources);
    assert_eq!(read(&empty).expect("valid"), Document::default());
}
