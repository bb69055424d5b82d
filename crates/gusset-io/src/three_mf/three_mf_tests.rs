//! Packages made by hand, with and without compression, and damage.

use super::{read_3mf, write_3mf};
use crate::document::{Document, Placement};
use crate::error::{Loss, ReadError, ReadErrorKind, WriteErrorKind};
use crate::material::{Material, NO_MATERIAL};
use crate::mesh::{Mesh, Positions, Values};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{NoResources, Target};
use proptest::prelude::*;
use std::io::Write;
use std::time::{Duration, Instant};

const RELATIONS: &str = r#"<Relationships><Relationship Target="/3D/main.model" Id="r"
    Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>"#;

/// Packs parts; those with a name in capitals without compression.
fn package(parts: &[(&str, &[u8])]) -> Vec<u8> {
    let mut made = Vec::new();
    let mut archive = rawzip::ZipArchiveWriter::new(&mut made);
    for (name, bytes) in parts {
        let is_stored = name.starts_with(char::is_uppercase);
        let method = if is_stored { rawzip::CompressionMethod::STORE } else { rawzip::CompressionMethod::DEFLATE };
        let (mut entry, config) = archive.new_file(*name).compression_method(method).start().expect("started");
        let descriptor = if is_stored {
            let mut out = config.wrap(&mut entry);
            out.write_all(bytes).expect("written");
            out.finish().expect("finished").1
        } else {
            let mut out = config.wrap(flate2::write::DeflateEncoder::new(&mut entry, flate2::Compression::best()));
            out.write_all(bytes).expect("written");
            let (encoder, descriptor) = out.finish().expect("finished");
            encoder.finish().expect("finished");
            descriptor
        };
        entry.finish(descriptor).expect("finished");
    }
    archive.finish().expect("finished");
    made
}

fn package_of_model(model: &str) -> Vec<u8> {
    package(&[("_rels/.rels", RELATIONS.as_bytes()), ("3d/Main.model", model.as_bytes())])
}

fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    read_3mf(bytes, &ReadOptions::default())
}

fn read_model(content: &str) -> Result<Document, ReadError> {
    read(&package_of_model(&format!(
        "\u{feff}<?xml version=\"1.0\"?><!-- by hand --><model unit=\"inch\" xmlns:m=\"x\">{content}</model>"
    )))
}

/// A tetrahedron of volume 1/6.
const TETRAHEDRON: &str = r#"<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x=" 0 " y='1' z="0"></vertex>
    <vertex x="0" y="0" z="1e0"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
    <triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>"#;

fn volume(mesh: &Mesh) -> f64 {
    (0..mesh.face_count())
        .map(|face| {
            let [a, b, c] = [0, 1, 2].map(|k| mesh.positions.get(mesh.face(face)[k] as usize));
            let n = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / 6.0
        })
        .sum()
}

#[test]
fn reads_objects_components_and_items() {
    let document = read_model(&format!(
        r#"<metadata name="Title">a &amp; b</metadata><resources><object id="7" name="a &lt; b">{TETRAHEDRON}</object>
        <object id="8" type="model"><components><component objectid="7" transform="2 0 0 0 2 0 0 0 2 1 2 3"/>
        <component objectid="7"/></components></object></resources>
        <build><item objectid="8" transform="0 1 0 -1 0 0 0 0 1 10 20 30"/></build>"#
    ))
    .expect("valid");
    assert_eq!(document.metres_per_unit, Some(0.0254));
    assert_eq!((document.meshes.len(), document.meshes[0].name.as_str()), (1, "a < b"));
    // A point is a row, which matrices multiply from the right: first doubled and shifted, then turned.
    let expected = [[0.0, -2.0, 0.0, 8.0], [2.0, 0.0, 0.0, 21.0], [0.0, 0.0, 2.0, 33.0]];
    assert_eq!(document.placements[0].transform, expected);
    assert_eq!(document.placements[1].transform[0], [0.0, -1.0, 0.0, 10.0]);
    let mesh = document.into_joined(1000).expect("small").meshes.remove(0);
    assert!((volume(&mesh) - 9.0 / 6.0).abs() < 1e-12);
}

#[test]
fn reads_parts_of_the_production_extension() {
    let other =
        format!(r#"<model unit="millimeter"><resources><object id="1">{TETRAHEDRON}</object></resources></model>"#);
    let main = r#"<model requiredextensions="p" xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06">
        <resources><object id="1"><components><component p:path="/3D/Objects/One.model" objectid="1"/></components></object></resources>
        <build><item objectid="1" p:UUID="0"/></build></model>"#;
    let parts: [(&str, &[u8]); 2] = [("3D/3dmodel.model", main.as_bytes()), ("3D/Objects/one.model", other.as_bytes())];
    let document = read(&package(&parts)).expect("valid");
    assert_eq!((document.placements.len(), document.meshes.len(), document.notes.len()), (1, 1, 0));
    assert_eq!(document.metres_per_unit, Some(0.001));
    assert!(read(&package(&parts[..1])).expect_err("missing").message.contains("One.model is missing"));
}

#[test]
fn reads_materials_and_colours() {
    let triangles = |own: [&str; 4]| {
        let mut text = TETRAHEDRON.to_owned();
        for (corner, own) in ["v3=\"1\"", "v2=\"1\" v3=\"3\"", "v3=\"2\"", "v2=\"2\" v3=\"3\""].into_iter().zip(own) {
            text = text.replacen(&format!("{corner}/>"), &format!("{corner} {own}/>"), 1);
        }
        text
    };
    let resources = r##"<basematerials id="1"><base name="red" displaycolor="#FF0000"/><base name="glass" displaycolor="#00FF0080"/></basematerials>
        <m:colorgroup id="2"><m:color color="#FF0000"/><m:color color="#0000FF"/></m:colorgroup>"##;
    let object = |property: &str, own| {
        let mesh = triangles(own);
        let content = format!(
            r#"<resources>{resources}<object id="3" {property}>{mesh}</object></resources><build><item objectid="3"/></build>"#
        );
        read_model(&content).expect("valid")
    };
    let document = object(r#"pid="1" pindex="1""#, ["", "pid=\"1\" p1=\"0\"", "p1=\"0\"", "pid=\"9\" p1=\"0\""]);
    assert_eq!(document.meshes[0].face_materials, [1, 0, 0, NO_MATERIAL]);
    assert_eq!(document.materials[1].colour, [0.0, 1.0, 0.0, 128.0 / 255.0]);
    assert!(document.notes[0].text.contains("1 triangles have properties that do not exist"));
    let faces = object("", ["pid=\"2\" p1=\"1\"", "pid=\"2\" p1=\"0\"", "", "pid=\"2\" p1=\"1\" p2=\"1\" p3=\"1\""]);
    let (red, blue) = ([1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]);
    assert_eq!(faces.meshes[0].face_colours, [blue, red, [1.0; 4], blue]);
    // Vertices 0, 2, 1 and 0, 1, 3 and so on: vertex 0 is red, and the others are blue.
    let own = "pid=\"2\" p1=\"0\" p2=\"1\" p3=\"1\"";
    let vertices = object("", [own, own, own, "pid=\"2\" p1=\"1\""]);
    assert_eq!(vertices.meshes[0].vertex_colours, [red, blue, blue, blue]);
    assert!(vertices.notes.is_empty());
}

#[test]
fn reads_texture_coordinates() {
    let mesh = TETRAHEDRON
        .replace("v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"2\" v3=\"1\" pid=\"5\" p1=\"0\" p2=\"1\" p3=\"1\"");
    let model = format!(
        r#"<model><resources><m:texture2d id="4" path="/3D/Textures/a.png" contenttype="image/png"/>
        <m:texture2dgroup id="5" texid="4"><m:tex2coord u="0.5" v="0.25"/><m:tex2coord u="1" v="0"/></m:texture2dgroup>
        <object id="1">{mesh}</object></resources><build><item objectid="1"/></build></model>"#
    );
    let document =
        read(&package(&[("3D/3dmodel.model", model.as_bytes()), ("3D/Textures/a.png", b"png")])).expect("valid");
    let Values::Corners(pairs) = &document.meshes[0].texcoords else { panic!("at corners") };
    assert_eq!((pairs[0], pairs[2], pairs[3][0].is_nan()), ([0.5, 0.25], [1.0, 0.0], true));
    assert_eq!(document.materials[document.meshes[0].face_materials[0] as usize].image, Some(0));
}

#[test]
fn names_what_is_wrong() {
    let error = |content: &str| read_model(content).expect_err("not valid").to_string();
    let mesh = |from: &str, to: &str| {
        format!("<resources><object id=\"4\">{}</object></resources>", TETRAHEDRON.replace(from, to))
    };
    assert_eq!(
        error(&mesh("v1=\"1\" v2", "v1=\"9\" v2")),
        "object 4, face 3, corner 0: vertex 9 does not exist (the mesh has 4)"
    );
    assert_eq!(
        error(&mesh("v1=\"1\" v2", "v1=\"-1\" v2")),
        "object 4, face 3: v1, v2 or v3 is not a whole number from 0"
    );
    assert_eq!(error(&mesh("z=\"1e0\"", "z=\"high\"")), "object 4, vertex 3: x, y or z is not a number");
    assert_eq!(error("<build><item objectid=\"2\"/></build>"), "object 2 does not exist");
    let loops = "<resources><object id=\"1\"><components><component objectid=\"1\"/></components></object></resources>";
    assert_eq!(error(loops), "object 1 is a component of itself");
    assert_eq!(
        error("<build><item objectid=\"2\" transform=\"1 2\"/></build>"),
        "the transform \"1 2\" is not a list of 12 numbers"
    );
    let kind = |bytes: &[u8]| read(bytes).expect_err("not valid").to_string();
    assert!(kind(b"PK\x03\x04").contains("cut off or damaged"));
    assert!(kind(b"solid").contains("not a 3MF file"));
    assert!(kind(&package(&[("a.txt", b"")])).contains("no 3D model part"));
    assert!(kind(&package_of_model("<model><resources><object id=\"1\"></model>")).contains("is damaged"));
    let secure = r#"<model requiredextensions="s" xmlns:s="http://schemas.microsoft.com/3dmanufacturing/securecontent/2019/04"/>"#;
    assert!(kind(&package_of_model(secure)).contains("encrypted"));
    // Without items, all objects are shown; bytes that are not UTF-8 are replaced.
    let latin = mesh("", "").replace("id=\"4\"", "id=\"4\" name=\"?\"").replace('?', "\u{1}");
    let mut bytes = format!("<model>{latin}</model>").into_bytes();
    bytes.iter_mut().filter(|byte| **byte == 1).for_each(|byte| *byte = 0xe9);
    let document = read(&package(&[("3d/3dmodel.model", &bytes)])).expect("valid");
    assert_eq!((document.placements.len(), document.meshes[0].name.as_str()), (1, "?"));
    assert_eq!(document.notes.len(), 2);
}

/// Far more than any of these files may take without optimisation.
const PATIENCE: Duration = Duration::from_secs(20);

#[test]
fn limits_components_that_double() {
    let start = Instant::now();
    for leaf in [TETRAHEDRON, ""] {
        let mut objects = format!("<object id=\"0\">{leaf}</object>");
        for id in 1..64 {
            let part = id - 1;
            objects.push_str(&format!(
                "<object id=\"{id}\"><components><component objectid=\"{part}\"/><component objectid=\"{part}\"/></components></object>"
            ));
        }
        let read = read_model(&format!("<resources>{objects}</resources><build><item objectid=\"63\"/></build>"));
        if leaf.is_empty() {
            assert!(read.expect("nothing to show").placements.is_empty());
        } else {
            assert_eq!(read.expect_err("too large").kind, ReadErrorKind::TooLarge);
        }
    }
    // A long chain is followed.
    let mut objects = format!("<object id=\"0\">{TETRAHEDRON}</object>");
    for id in 1..30_000 {
        objects.push_str(&format!(
            "<object id=\"{id}\"><components><component objectid=\"{}\"/></components></object>",
            id - 1
        ));
    }
    let chain = read_model(&format!("<resources>{objects}</resources><build><item objectid=\"29999\"/></build>"));
    assert_eq!(chain.expect("valid").placements.len(), 1);
    assert!(start.elapsed() < PATIENCE);
}

#[test]
fn limits_what_bombs_expand_to() {
    let start = Instant::now();
    let blanks = " ".repeat(10 << 20);
    let long = package_of_model(&format!("<model>{blanks}</model>"));
    assert!(long.len() < 20_000);
    let error = read(&long).expect_err("too large");
    assert_eq!(error.kind, ReadErrorKind::TooLarge);
    assert!(error.message.contains("more than 4 megabytes"));
    let vertices = "<vertex x=\"0\" y=\"0\" z=\"0\"/>".repeat(600_000);
    let many = package_of_model(&format!("<model><object id=\"1\"><mesh>{vertices}</mesh></object></model>"));
    assert_eq!(read(&many).expect_err("too large").kind, ReadErrorKind::TooLarge);
    let short = "<a/>".repeat(6 << 20);
    let error = read(&package_of_model(&format!("<model>{short}</model>"))).expect_err("too large");
    assert!(error.message.contains("256 times"), "{error}");
    assert!(start.elapsed() < 3 * PATIENCE);
}

fn written(document: &Document) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let mut target = Target {
        main_file: &mut bytes,
        stem: "a",
        beside: &mut |_, _| panic!("no other file"),
        resources: &NoResources,
    };
    let losses = write_3mf(document, &mut target, &WriteOptions::default()).expect("written");
    (bytes, losses)
}

fn box_mesh() -> Mesh {
    let points = (0..8).map(|v| [f64::from(v & 1), f64::from(v >> 1 & 1) / 3.0, f64::from(v >> 2) * 3e-7]).collect();
    let corners = vec![0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
    let face_offsets = (0..=6).map(|face| 4 * face).collect();
    Mesh { positions: Positions::F64(points), face_offsets, corners, ..Mesh::default() }
}

#[test]
fn writes_what_it_reads() {
    let transform = [[0.0, -1.0, 0.0, 0.1], [1.0, 0.0, 0.0, 1.0 / 3.0], [0.0, 0.0, 1.0, 1e6]];
    let name = "a < \"b\" & c";
    let mut document =
        Document::from_mesh(Mesh { name: name.into(), face_materials: vec![1, 1, 0, 0, NO_MATERIAL, 1], ..box_mesh() });
    document
        .meshes
        .push(Mesh { vertex_colours: (0..8).map(|k| [k as f32 / 255.0, 1.0, 0.0, 0.2]).collect(), ..box_mesh() });
    document.placements.push(Placement { name: String::new(), mesh: 1, transform });
    document.placements.push(Placement { name: name.into(), mesh: 0, transform });
    document.materials = ["red", "blue"].map(|name| Material { name: name.into(), ..Material::default() }).to_vec();
    document.metres_per_unit = Some(0.01);
    let (bytes, losses) = written(&document);
    assert_eq!(bytes, written(&document).0, "the bytes depend on the document alone");
    let losses: Vec<&str> = losses.iter().map(|loss| loss.0.as_str()).collect();
    assert_eq!(losses, ["12 faces of more than three corners: cut into triangles"]);
    let again = read(&bytes).expect("valid");
    assert_eq!((&again.placements, again.metres_per_unit), (&document.placements, document.metres_per_unit));
    assert_eq!(again.materials, document.materials);
    assert_eq!(again.meshes[0].positions, document.meshes[0].positions);
    assert_eq!(again.meshes[0].face_materials, [1, 1, 1, 1, 0, 0, 0, 0, NO_MATERIAL, NO_MATERIAL, 1, 1]);
    assert_eq!(again.meshes[1].vertex_colours, document.meshes[1].vertex_colours);
    assert!((volume(&again.meshes[0]) - 1e-7).abs() < 1e-20);
    assert_eq!(written(&again).0, bytes);
    document.meshes[1].positions = Positions::F32(vec![[f32::NAN; 3]; 8]);
    let mut target =
        Target { main_file: &mut Vec::new(), stem: "a", beside: &mut |_, _| Ok(()), resources: &NoResources };
    let error = write_3mf(&document, &mut target, &WriteOptions::default()).expect_err("not finite");
    assert_eq!(error.kind, WriteErrorKind::Unsupported);
}

fn check_indices(document: &Document) {
    for mesh in &document.meshes {
        assert!(mesh.corners.iter().all(|&vertex| (vertex as usize) < mesh.positions.len()));
        assert_eq!(mesh.face_offsets.last().map(|&end| end as usize), Some(mesh.corners.len()));
        assert!(mesh.face_materials.is_empty() || mesh.face_materials.len() == mesh.face_count());
        let materials = document.materials.len();
        assert!(mesh.face_materials.iter().all(|&own| own == NO_MATERIAL || (own as usize) < materials));
    }
    assert!(document.placements.iter().all(|own| (own.mesh as usize) < document.meshes.len()));
}

fn damaged(bytes: &[u8], changes: &[(u8, u16, u16, u8)]) -> Vec<u8> {
    let mut made = bytes.to_vec();
    for &(kind, place, length, value) in changes {
        let place = usize::from(place) % (made.len() + 1);
        let end = (place + usize::from(length) % 64).min(made.len());
        match kind % 4 {
            0 => made[place..].iter_mut().take(1).for_each(|byte| *byte ^= value),
            1 => _ = made.drain(place..end),
            2 => {
                let part = made[place..end].to_vec();
                made.splice(place..place, part);
            }
            _ => made.insert(place, value),
        }
    }
    made
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn reads_damaged_packages_without_panic(
        is_model in any::<bool>(),
        changes in prop::collection::vec((any::<u8>(), any::<u16>(), any::<u16>(), any::<u8>()), 1..4),
    ) {
        let model = format!(
            r##"<model><resources><basematerials id="1"><base name="a" displaycolor="#010203"/></basematerials>
            <m:colorgroup id="2"><m:color color="#FF0000"/></m:colorgroup><object id="3" pid="1" pindex="0">{TETRAHEDRON}</object>
            <object id="4"><components><component objectid="3" transform="1 0 0 0 1 0 0 0 1 0 0 0"/></components></object></resources>
            <build><item objectid="4"/></build></model>"##
        );
        // The names make these parts stored, so that damage stays where it is.
        let file = if is_model {
            package(&[("3D/3dmodel.model", &damaged(model.as_bytes(), &changes))])
        } else {
            damaged(&package_of_model(&model), &changes)
        };
        if let Ok(document) = read(&file) {
            check_indices(&document);
        }
    }
}
