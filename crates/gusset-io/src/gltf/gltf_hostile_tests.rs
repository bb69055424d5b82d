//! Files that try to exhaust memory or time, and random damage.

use super::gltf_test_files::*;
use super::read_gltf;
use crate::error::ReadErrorKind;
use crate::json_tape::Tape;
use crate::mesh::{Mesh, Values};
use crate::options::ReadOptions;
use crate::{Document, NO_MATERIAL};
use proptest::prelude::*;
use std::time::{Duration, Instant};

/// Far more than any of these files may take without optimisation.
const PATIENCE: Duration = Duration::from_secs(20);

#[test]
fn reads_deep_json() {
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        let deep = format!("{}{}{}", open.repeat(100_000), 1, close.repeat(100_000));
        let file = triangle_file(&format!("\"extras\":{deep}"));
        assert_eq!(read(&file).expect("valid").meshes.len(), 1);
        let cut = format!("{{\"asset\":{}", open.repeat(100_000));
        assert!(error_text(cut.as_bytes()).contains("the JSON text ends too early"));
        let material = format!("\"materials\":[{{\"extras\":{deep}}}]");
        let json = format!("{{{TRIANGLE_LISTS},{material}}}").replace("\"indices\":1", "\"indices\":1,\"material\":0");
        let document = read(&glb(&json, &triangle_bytes())).expect("valid");
        assert!(document.materials[0].native.is_none());
        assert!(document.notes.iter().any(|note| note.text.contains("deeper than 100 levels")));
    }
}

#[test]
fn materials_of_wrong_types_are_reduced_to_their_colours() {
    for (material, name) in [
        (r#"{"name":"a","pbrMetallicRoughness":["x"]}"#, "pbrMetallicRoughness"),
        (r#"{"pbrMetallicRoughness":{"baseColorTexture":1}}"#, "baseColorTexture"),
        (r#"{"pbrMetallicRoughness":{"baseColorFactor":"x"}}"#, "baseColorFactor"),
        (r#"{"alphaCutoff":"x"}"#, "alphaCutoff"),
        (r#"{"doubleSided":1,"extras":"x"}"#, "doubleSided"),
        (r#"{"name":null}"#, "name"),
        (r#""x""#, "the material"),
    ] {
        let json = format!("{{{TRIANGLE_LISTS},\"materials\":[{material}]}}");
        let json = json.replace("\"indices\":1", "\"indices\":1,\"material\":0");
        let document = read(&glb(&json, &triangle_bytes())).expect("valid");
        assert_eq!(document.materials[0].native, None, "{material}");
        let text = format!("material 0: {name} has a wrong type; the material is reduced to its colour");
        assert_eq!(document.notes.iter().map(|note| &note.text).collect::<Vec<_>>(), [&text]);
    }
}

#[test]
fn follows_a_long_chain_of_nodes() {
    let mut nodes = String::new();
    for child in 1..200_000 {
        nodes.push_str(&format!("{{\"children\":[{child}],\"translation\":[1,0,0]}},"));
    }
    let start = Instant::now();
    let document = read(&triangle_file(&format!("\"nodes\":[{nodes}{{\"mesh\":0}}],\"scenes\":[{{\"nodes\":[0]}}]")));
    assert_eq!(document.expect("valid").placements[0].transform[0], [1.0, 0.0, 0.0, 199_999.0]);
    assert!(start.elapsed() < PATIENCE);
}

#[test]
fn refuses_nodes_that_double() {
    let nodes: Vec<String> =
        (1..28).map(|child| format!("{{\"children\":[{child}]}},{{\"children\":[{child}]}}")).collect();
    let file = triangle_file(&format!("\"nodes\":[{},{{\"mesh\":0}}],\"scenes\":[{{\"nodes\":[0]}}]", nodes.join(",")));
    assert!(error_text(&file).contains("is a child of node 0 and of node 1"));
}

#[test]
fn believes_no_count() {
    for count in ["4000000000", "9007199254740991", "1e300", "-3", "2.5"] {
        for view in ["\"bufferView\":0,", ""] {
            let json = format!("{{{TRIANGLE_LISTS}}}").replace(
                "{\"bufferView\":0,\"componentType\":5126,\"count\":3",
                &format!("{{{view}\"componentType\":5126,\"count\":{count}"),
            );
            assert!(read(&glb(&json, &triangle_bytes())).is_err(), "{count} {view}");
        }
        let json = format!("{{{TRIANGLE_LISTS}}}")
            .replace("\"byteLength\":36", &format!("\"byteOffset\":{count},\"byteLength\":{count}"));
        assert!(read(&glb(&json, &triangle_bytes())).is_err(), "{count}");
    }
    // Elements that overlap: each byte begins one.
    let json = format!("{{{TRIANGLE_LISTS}}}")
        .replace("\"byteLength\":36", "\"byteStride\":1,\"byteLength\":1000000")
        .replace("\"count\":3,\"type\":\"VEC3\"", "\"count\":999980,\"type\":\"VEC3\"");
    let bytes = [triangle_bytes(), vec![0; 1_000_000]].concat();
    let document = read(&glb(&json, &bytes)).expect("12 times the file");
    assert_eq!(document.meshes[0].positions.len(), 999_980);
    // The table of merging would need more than the rest of 32 times.
    assert!(document.notes.iter().any(|note| note.text.contains("is not merged")));
}

#[test]
fn limits_repeated_use_of_a_buffer() {
    // 3000 meshes of the same 100 000 points would take 3.6 gigabytes.
    let points = floats(&vec![0.5; 300_000]);
    let meshes = vec![r#"{"primitives":[{"attributes":{"POSITION":0}}]}"#; 3000].join(",");
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":1200000}}],"bufferViews":[{{"buffer":0}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":100000,"type":"VEC3"}}],"meshes":[{meshes}]}}"#
    );
    let start = Instant::now();
    assert_eq!(read(&glb(&json, &points)).expect_err("too large").kind, ReadErrorKind::TooLarge);
    // One mesh may name them often.
    let primitives = vec![r#"{"attributes":{"POSITION":0},"mode":4,"indices":1}"#; 3000].join(",");
    let json = json.replace(&meshes, &format!("{{\"primitives\":[{primitives}]}}")).replace(
        "\"type\":\"VEC3\"}",
        "\"type\":\"VEC3\"},{\"bufferView\":0,\"componentType\":5125,\"count\":0,\"type\":\"SCALAR\"}",
    );
    assert_eq!(read(&glb(&json, &points)).expect("valid").meshes.len(), 0);
    assert!(start.elapsed() < PATIENCE);
}

#[test]
fn reads_many_points_without_numbers_fast() {
    let start = Instant::now();
    let nan = vec![f32::NAN; 900_000];
    for points in [nan, vec![-0.0; 900_000]] {
        let json = r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":3600000}],"bufferViews":[{"buffer":0}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":300000,"type":"VEC3"}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]}"#;
        let mesh = &read(&glb(json, &floats(&points))).expect("valid").meshes[0];
        assert_eq!(mesh.face_count(), 100_000);
        assert_eq!(mesh.merge.is_empty(), points[0].is_nan());
    }
    assert!(start.elapsed() < PATIENCE);
}

#[test]
fn parses_json_as_it_should() {
    let good = [
        "{}",
        "[]",
        "1",
        "\"\\u0041\\ud83d\\ude00\"",
        "[1,-2.5e3,true,null]",
        "{\"a\":[{}],\"b\":\"\\\"\"}",
        " [ ] \0\0",
    ];
    for text in good {
        assert!(Tape::parse(text.as_bytes()).is_ok(), "{text}");
    }
    for text in [
        "", "{", "[1 2]", "[1}", "{\"a\"}", "{1:2}", "\"a", "\"\\", "[nul]", "}", ",", "[,]", "[1,,2]", "{\"a\":}",
        "tru",
    ] {
        assert!(Tape::parse(text.as_bytes()).is_err(), "{text}");
    }
    let Ok(tape) = Tape::parse(good[3].as_bytes()) else { panic!("valid") };
    assert_eq!(tape.root().text().as_deref(), Some("A\u{1f600}"));
}

/// Checks that every index of a document names something.
fn check_indices(document: &Document) {
    let value_count = |values: &Values<3>, mesh: &Mesh| match values {
        Values::Absent => true,
        Values::Vertices(all) => all.len() == mesh.positions.len(),
        Values::Corners(all) => all.len() == mesh.corners.len(),
    };
    for mesh in &document.meshes {
        let (vertices, faces) = (mesh.positions.len(), mesh.face_count());
        assert!(mesh.corners.iter().chain(&mesh.merge).all(|&vertex| (vertex as usize) < vertices));
        assert!(mesh.merge.iter().all(|&vertex| mesh.representative(vertex) == vertex));
        assert!(mesh.face_offsets.is_sorted() && mesh.face_offsets[faces] as usize == mesh.corners.len());
        assert!(mesh.vertex_colours.is_empty() || mesh.vertex_colours.len() == vertices);
        assert!(mesh.face_materials.is_empty() || mesh.face_materials.len() == faces);
        let materials = document.materials.len();
        assert!(mesh.face_materials.iter().all(|&own| own == NO_MATERIAL || (own as usize) < materials));
        assert!(value_count(&mesh.normals, mesh));
    }
    assert!(document.placements.iter().all(|own| (own.mesh as usize) < document.meshes.len()));
    assert_eq!(document.curves.offsets.last().map(|&end| end as usize), Some(document.curves.positions.len()));
    let images = document.images.len();
    assert!(document.materials.iter().filter_map(|own| own.image).all(|image| (image as usize) < images));
}

/// Returns valid files of all features.
fn seeds() -> Vec<Vec<u8>> {
    let rich = format!("{{{TRIANGLE_LISTS}}}")
        .replace("\"POSITION\":0", "\"POSITION\":0,\"NORMAL\":0,\"COLOR_0\":0,\"_VERTEX\":2")
        .replace("\"indices\":1", r#""indices":1,"material":0,"extensions":{"FB_ngon_encoding":{}},"extras":{"gusset_polygons":[[0,1,0,1,2]]}"#)
        .replace("\"type\":\"SCALAR\"}", r#""type":"SCALAR"},{"bufferView":0,"componentType":5123,"count":3,"type":"VEC2",
            "sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}}"#)
        .replace("\"meshes\"", r#""materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],"images":[{"bufferView":1}],
            "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"children":[1]},{"mesh":0,"rotation":[1,0,0,0]}],"meshes""#);
    let mesh = box_mesh();
    let (binary, _) = written(&Document::from_mesh(mesh.clone()), true, &crate::NoResources);
    let (text, _) = written(&Document::from_mesh(mesh), false, &crate::NoResources);
    vec![glb(&rich, &triangle_bytes()), binary, text]
}

/// Damages bytes: turns bits, cuts, repeats and inserts.
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

#[test]
fn reads_every_beginning_without_panic() {
    for seed in seeds() {
        check_indices(&read(&seed).expect("valid"));
        for length in 0..seed.len() {
            if let Ok(document) = read(&seed[..length]) {
                check_indices(&document);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn reads_damaged_files_without_panic(
        seed in 0..3_usize,
        changes in prop::collection::vec((any::<u8>(), any::<u16>(), any::<u16>(), any::<u8>()), 1..4),
    ) {
        let file = damaged(&seeds()[seed], &changes);
        if let Ok(document) = read_gltf(&file, &crate::NoResources, &ReadOptions::default()) {
            check_indices(&document);
        }
    }

    /// Numbers in the JSON text, which damage rarely changes to other numbers.
    #[test]
    fn reads_other_numbers_without_panic(place in 0..80_usize, number in prop::sample::select(vec!["0", "1", "7", "-1", "4294967295", "4294967296", "1e30", "5121", "2", "null", "[]"])) {
        let file = seeds().swap_remove(0);
        let length = u32::from_le_bytes([file[12], file[13], file[14], file[15]]) as usize;
        let json = String::from_utf8_lossy(&file[20..20 + length]).into_owned();
        let starts: Vec<usize> = json.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).collect();
        let at = starts[place % starts.len()];
        let end = at + json[at..].find(|c: char| !c.is_ascii_digit()).unwrap_or(0);
        let changed = format!("{}{number}{}", &json[..at], &json[end..]);
        if let Ok(document) = read(&glb(&changed, &triangle_bytes())) {
            check_indices(&document);
        }
    }
}
