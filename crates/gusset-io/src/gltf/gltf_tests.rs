//! Files as other programs write them.

use super::gltf_test_files::*;
use super::read_gltf;
use crate::mesh::{Mesh, Positions, Values};
use crate::options::ReadOptions;
use crate::{Document, ImageData, NativeMaterial, ReadErrorKind};

/// The box of CASES.md: each face has vertices and a normal of its own.
fn flat_box() -> Vec<u8> {
    let whole = box_mesh();
    let (mut positions, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for face in 0..6 {
        let normal =
            [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
        for &vertex in whole.face(face) {
            positions.extend(whole.positions.get(vertex as usize).map(|x| x as f32));
            normals.extend(normal[face]);
        }
        let first = 4 * face as u16;
        indices.extend([first, first + 1, first + 2, first, first + 2, first + 3]);
    }
    let json = r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":648}],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "bufferViews":[{"buffer":0,"byteLength":288},{"buffer":0,"byteOffset":288,"byteLength":288},{"buffer":0,"byteOffset":576}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":24,"type":"VEC3"},
            {"bufferView":1,"componentType":5126,"count":24,"type":"VEC3"},
            {"bufferView":2,"componentType":5123,"count":36,"type":"SCALAR"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}]}"#;
    glb(json, &[floats(&positions), floats(&normals), shorts(&indices)].concat())
}

#[test]
fn merges_a_box_of_flat_normals() {
    let document = read(&flat_box()).expect("valid");
    let mesh = &document.meshes[0];
    assert_eq!((mesh.positions.len(), mesh.face_count()), (24, 12));
    assert!(is_closed(mesh));
    assert_eq!(mesh.merge.iter().collect::<std::collections::BTreeSet<_>>().len(), 8);
    let (area, volume) = area_and_volume(mesh);
    assert!((area - 22.0).abs() < 1e-12 && (volume - 6.0).abs() < 1e-12);
    // After writing and reading, the vertices are joined and the normals are at corners.
    let again = returned(&document);
    assert_eq!(again.meshes[0].positions.len(), 8);
    assert!(again.meshes[0].merge.is_empty() && is_closed(&again.meshes[0]));
    assert!(matches!(&again.meshes[0].normals, Values::Corners(all) if all.len() == 36));
    let plain =
        read_gltf(&flat_box(), &crate::NoResources, &ReadOptions { merge_repeated: false, ..Default::default() });
    assert!(plain.expect("valid").meshes[0].merge.is_empty());
}

#[test]
fn reads_text_with_data_addresses_and_files() {
    let digits = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIAAAA=";
    let data = format!("\"uri\":\"data:application/octet-stream;base64,{digits}\",");
    for (address, prefix) in [(data.as_str(), ""), ("\"uri\":\"my%20buffer.bin\",", "\u{feff}\r\n")] {
        let json = format!("{prefix}{{{TRIANGLE_LISTS},}}")
            .replace("{\"byteLength\":44}", &format!("{{{address}\"byteLength\":44}}"));
        let files = Files([("my buffer.bin".to_owned(), triangle_bytes())].into());
        let document = read_gltf(json.as_bytes(), &files, &ReadOptions::default()).expect("valid");
        assert_eq!(document.meshes[0].positions, Positions::F32(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]));
        assert_eq!(document.notes[0].text, "commas precede closing brackets");
    }
    let json = format!("{{{TRIANGLE_LISTS}}}").replace("{\"byteLength\":44}", "{\"uri\":\"../b\"}");
    assert_eq!(read(json.as_bytes()).expect_err("not given").kind, ReadErrorKind::Unreadable);
}

/// Returns the positions of a file of one triangle whose accessor 0 and bytes are given.
fn positions(accessors: &str, views: &str, bytes: &[u8]) -> Positions {
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],"bufferViews":[{views}],"accessors":[{accessors}],
           "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}]}}"#,
        bytes.len()
    );
    read(&glb(&json, bytes)).expect("valid").meshes[0].positions.clone()
}

#[test]
fn reads_all_types_of_numbers() {
    let view = r#"{"buffer":0}"#;
    let accessor =
        |code: u32, more: &str| format!(r#"{{"bufferView":0,"componentType":{code},"count":3,"type":"VEC3"{more}}}"#);
    let bytes: Vec<u8> = vec![0, 127, 129, 128, 1, 2, 3, 4, 5];
    let signed = positions(&accessor(5120, ""), view, &bytes);
    assert_eq!(signed, Positions::F32(vec![[0.0, 127.0, -127.0], [-128.0, 1.0, 2.0], [3.0, 4.0, 5.0]]));
    let normalised = positions(&accessor(5120, ",\"normalized\":true"), view, &bytes);
    assert_eq!(normalised.get(0), [0.0, 1.0, -1.0]);
    assert_eq!(normalised.get(1), [-1.0, 1.0 / 127.0, 2.0 / 127.0].map(|x: f64| f64::from(x as f32)));
    let unsigned = positions(&accessor(5121, ",\"normalized\":true"), view, &[255, 0, 51, 0, 0, 0, 0, 0, 0]);
    assert_eq!(unsigned.get(0), [1.0, 0.0, f64::from(0.2_f32)]);
    let words = shorts(&[65535, 32768, 32767, 0, 0, 0, 0, 0, 0]);
    assert_eq!(positions(&accessor(5122, ""), view, &words).get(0), [-1.0, -32768.0, 32767.0]);
    assert_eq!(positions(&accessor(5123, ""), view, &words).get(0), [65535.0, 32768.0, 32767.0]);
    let doubles: Vec<u8> =
        [0.1, 1e-300, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0_f64].iter().flat_map(|x| x.to_le_bytes()).collect();
    assert_eq!(positions(&accessor(5130, ""), view, &doubles).get(0), [0.1, 1e-300, 3.0]);
    let integers: Vec<u8> = [4_000_000_001_u32; 9].iter().flat_map(|x| x.to_le_bytes()).collect();
    assert_eq!(positions(&accessor(5125, ""), view, &integers).get(2), [4_000_000_001.0; 3]);
    // Interleaved with 4 bytes between elements.
    let mut strided = Vec::new();
    for k in 0..3 {
        strided.extend(floats(&[k as f32, 1.0, 2.0, f32::NAN]));
    }
    assert_eq!(positions(&accessor(5126, ""), r#"{"buffer":0,"byteStride":16}"#, &strided).get(2), [2.0, 1.0, 2.0]);
}

#[test]
fn reads_sparse_accessors() {
    let sparse = r#""sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0,"byteOffset":36}}"#;
    let views = r#"{"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":2}"#;
    let mut bytes = floats(&[1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 7.0, 7.0, 7.0, 8.0, 8.0, 8.0]);
    bytes.extend([0, 2]);
    let based = format!(r#"{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",{sparse}}}"#);
    assert_eq!(positions(&based, views, &bytes), Positions::F32(vec![[7.0; 3], [2.0; 3], [8.0; 3]]));
    let alone = format!(r#"{{"componentType":5126,"count":3,"type":"VEC3",{sparse}}}"#);
    assert_eq!(positions(&alone, views, &bytes), Positions::F32(vec![[7.0; 3], [0.0; 3], [8.0; 3]]));
    let json = format!("{{{TRIANGLE_LISTS}}}").replace("\"type\":\"VEC3\"", &format!("\"type\":\"VEC3\",{sparse}"));
    assert!(
        error_text(&glb(&json, &triangle_bytes())).contains("the sparse part of accessor 0 reaches beyond its buffer")
    );
}

/// Returns the mesh of 6 points of a strip of 4 triangles, read in a mode.
fn document_from_mode(mode: u32, indices: &[u16], more: &str) -> Document {
    let mut points = Vec::new();
    for k in 0..6_u8 {
        points.extend([f32::from(k / 2), f32::from(k % 2), 0.0]);
    }
    let bytes = [floats(&points), shorts(indices)].concat();
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],"scenes":[{{"nodes":[0]}}],"scene":0,
        "nodes":[{{"mesh":0,"translation":[0,0,5]}}],
        "bufferViews":[{{"buffer":0,"byteLength":72}},{{"buffer":0,"byteOffset":72}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"}},
            {{"bufferView":1,"componentType":5123,"count":{},"type":"SCALAR"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"mode":{mode}{more}}}]}}]}}"#,
        bytes.len(),
        indices.len()
    );
    read(&glb(&json, &bytes)).expect("valid")
}

#[test]
fn reads_strips_fans_lines_and_points() {
    let normal_sum = |mesh: &Mesh| {
        (0..mesh.face_count())
            .map(|face| {
                let [a, b, c] = [0, 1, 2].map(|k| mesh.positions.get(mesh.face(face)[k] as usize));
                0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
            })
            .sum::<f64>()
    };
    // The strip turns its triangles alike: from below, with area 2. A repeated index makes no face.
    let strip = document_from_mode(5, &[0, 1, 2, 3, 4, 5, 5, 5], "");
    assert_eq!(strip.meshes[0].face_count(), 4);
    assert_eq!(normal_sum(&strip.meshes[0]), -2.0);
    let fan = document_from_mode(6, &[0, 2, 4, 5, 3, 1], "");
    assert_eq!((fan.meshes[0].face_count(), normal_sum(&fan.meshes[0])), (4, 2.0));
    let lines = document_from_mode(1, &[0, 1, 1, 3, 3, 0, 4, 5, 2], "");
    assert!(lines.meshes.is_empty() && lines.placements.is_empty());
    assert_eq!((&lines.curves.offsets[..], &lines.curves.closed[..]), (&[0, 3, 5][..], &[true, false][..]));
    assert_eq!(lines.curves.positions.get(2), [1.0, 1.0, 5.0]);
    let looped = document_from_mode(2, &[0, 2, 3], "");
    assert_eq!(looped.curves.closed, [true]);
    let open = document_from_mode(3, &[0, 2, 3], "");
    assert_eq!((&open.curves.closed[..], open.curves.positions.len()), (&[false][..], 3));
    let points = document_from_mode(0, &[5, 1], "");
    assert_eq!(points.points.positions, Positions::F64(vec![[2.0, 1.0, 5.0], [0.0, 1.0, 5.0]]));
}

#[test]
fn joins_triangles_that_were_polygons() {
    let more = r#","extensions":{"FB_ngon_encoding":{}}"#;
    let quads = document_from_mode(4, &[0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3], more);
    assert_eq!(quads.meshes[0].face_offsets, [0, 4, 8]);
    assert_eq!(quads.meshes[0].corners, [0, 2, 3, 1, 2, 4, 5, 3]);
    let plain = document_from_mode(4, &[0, 2, 3, 0, 3, 1, 2, 4, 5, 2], "");
    assert_eq!(plain.meshes[0].face_count(), 3);
    assert_eq!(plain.notes[0].text, "1 index follows after the last triangle and is ignored");
}

#[test]
fn applies_matrices_of_nodes() {
    let mirrored =
        flat(&triangle_file(r#""scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[1,2,3],"scale":[2,2,-2]}]"#));
    assert_eq!(mirrored.positions, Positions::F64(vec![[1.0, 2.0, 3.0], [3.0, 2.0, 3.0], [1.0, 4.0, 3.0]]));
    assert_eq!(mirrored.corners, [0, 2, 1]);
    // A quarter turn about z, after a shift; the quaternion need not have length 1.
    let turned = flat(&triangle_file(
        r#""scene":0,"scenes":[{"nodes":[0,2]}],
           "nodes":[{"children":[1],"rotation":[0,0,3,3]},{"mesh":0,"translation":[1,0,0]},
                    {"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,10,20,30,1]}]"#,
    ));
    let expected =
        [[0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 1.0, 0.0], [10.0, 20.0, 30.0], [10.0, 21.0, 30.0], [9.0, 20.0, 30.0]];
    for (point, expected) in turned.positions.iter().zip(expected) {
        assert!((0..3).all(|axis| (point[axis] - expected[axis]).abs() < 1e-15), "{point:?}");
    }
}

#[test]
fn tolerates_harmless_scenes_and_refuses_others() {
    let shown = |scene: &str| read(&triangle_file(scene)).expect("valid").placements.len();
    assert_eq!(shown(r#""nodes":[{"mesh":0}],"scenes":[{"nodes":[0,0]}]"#), 1);
    assert_eq!(shown(r#""nodes":[{"children":[1,1]},{"mesh":0}],"scenes":[{"nodes":[0,1]}]"#), 1);
    assert_eq!(shown(r#""nodes":[{"children":[1]},{"mesh":0}],"scenes":[{"nodes":[1]}]"#), 1);
    assert_eq!(shown(r#""nodes":[{"mesh":0},{"mesh":0}]"#), 2);
    assert_eq!(shown(r#""scenes":[{}]"#), 0);
    let refused = |scene: &str| error_text(&triangle_file(scene));
    let parents = refused(r#""nodes":[{"children":[2]},{"children":[2]},{"mesh":0}],"scenes":[{"nodes":[0]}]"#);
    assert_eq!(parents, "node 2 is a child of node 0 and of node 1");
    assert_eq!(refused(r#""nodes":[{"children":[0]}],"scenes":[{"nodes":[0]}]"#), "node 0 is its own ancestor");
    assert_eq!(refused(r#""nodes":[{"mesh":3}],"scenes":[{"nodes":[0]}]"#), "mesh 3 does not exist (the file has 1)");
    assert_eq!(refused(r#""nodes":[{}],"scenes":[{"nodes":[7]}]"#), "node 7 does not exist (the file has 1)");
    assert_eq!(refused(r#""scene":1,"scenes":[{}]"#), "scene 1 does not exist (the file has 1)");
}

#[test]
fn copies_instances() {
    let json = format!("{{{TRIANGLE_LISTS}}}").replace(
        "\"meshes\"",
        r#""nodes":[{"mesh":0,"translation":[0,0,1],
        "extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}}],"meshes""#,
    );
    let document = read(&glb(&json, &triangle_bytes())).expect("valid");
    let places: Vec<[f64; 3]> = document.placements.iter().map(|own| own.transform.map(|row| row[3])).collect();
    assert_eq!(places, [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]);
}

#[test]
fn names_what_is_wrong() {
    let lost = format!("{{{TRIANGLE_LISTS}}}").replace("5123,\"count\":3", "5121,\"count\":6");
    let mut bytes = triangle_bytes();
    bytes[36..42].copy_from_slice(&[0, 1, 2, 0, 1, 7]);
    let text = error_text(&glb(&lost, &bytes));
    assert!(text.ends_with("face 1, corner 2: vertex 7 does not exist (the mesh has 3)"), "{text}");
    let required = |name: &str| error_text(&triangle_file(&format!(r#""extensionsRequired":["{name}"]"#)));
    assert!(required("KHR_draco_mesh_compression").contains("gltf-transform"));
    assert!(required("EXT_unknown").contains("requires the extension EXT_unknown"));
    assert!(
        read(&triangle_file(
            r#""extensionsRequired":["KHR_texture_basisu","KHR_materials_unlit","KHR_technique_webgl"]"#
        ))
        .is_ok()
    );
    let draco = r#"{"componentType":5126,"count":3,"type":"VEC3"}"#;
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"accessors":[{draco}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},
        "extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0}}}}}}]}}]}}"#
    );
    assert!(error_text(json.as_bytes()).contains("KHR_draco_mesh_compression"));
    assert_eq!(
        error_text(b"[1, 2"),
        "this is neither a glTF file, which begins with {, nor a binary one, which begins with glTF"
    );
    assert_eq!(
        error_text(b"{\n\"asset\": {},\n\"meshes\": [1 2]}"),
        "3: JSON: a comma or a closing bracket is missing"
    );
    assert_eq!(error_text(b"{}"), "this JSON is not glTF: it has neither asset nor meshes");
    assert!(error_text(br#"{"asset":{"version":"1.1"},"meshes":{}}"#).contains("gltf-pipeline"));
    assert!(error_text(b"\x1f\x8b\x08").contains("gunzip"));
    assert!(error_text(b"glTF\x01\0\0\0").contains("glTF 1.0"));
    assert!(read(br#"{"asset":{"version":"2.0"}}"#).expect("valid").meshes.is_empty());
}

#[test]
fn converts_colours_from_linear() {
    let json = format!("{{{TRIANGLE_LISTS}}}")
        .replace("\"POSITION\":0", "\"POSITION\":0,\"COLOR_0\":2,\"_ID\":2,\"TEXCOORD_1\":2")
        .replace(
            "\"type\":\"SCALAR\"}",
            "\"type\":\"SCALAR\"},{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}",
        )
        .replace("\"meshes\"", "\"animations\":[{}],\"meshes\"");
    let mut bytes = triangle_bytes();
    bytes[..36].copy_from_slice(&floats(&[0.5, 0.0, 1.0, 0.001, 0.214_041_14, 1.0, 0.0, 0.0, 0.0]));
    let document = read(&glb(&json, &bytes)).expect("valid");
    let colours = &document.meshes[0].vertex_colours;
    // 0.5 is 0.735357 in sRGB (IEC 61966-2-1), and 0.21404 is 0.5.
    assert!((f64::from(colours[0][0]) - 0.735_357).abs() < 1e-6 && colours[0][1..] == [0.0, 1.0, 1.0]);
    assert!((f64::from(colours[1][0]) - 0.012_92).abs() < 1e-7 && (colours[1][1] - 0.5).abs() < 1e-6);
    let notes: Vec<&str> = document.notes.iter().map(|note| note.text.as_str()).collect();
    for name in [
        "the vertex attribute TEXCOORD_1 is not read",
        "the vertex attribute _ID is not read",
        "animations are not read",
    ] {
        assert!(notes.contains(&name), "{notes:?}");
    }
}

#[test]
fn keeps_materials_with_their_textures() {
    let json = format!("{{{TRIANGLE_LISTS}}}").replace("\"indices\":1", "\"indices\":1,\"material\":1").replace(
        "\"meshes\"",
        r#""materials":[{},{"name":"brass","pbrMetallicRoughness":{"baseColorFactor":[0.5,0,1,0.25],
            "baseColorTexture":{"index":2,"extensions":{"KHR_texture_transform":{"offset":[0.5,0]}}}},
            "normalTexture":{"index":0, "scale":5e-1},"extras":{"a\"":[null,true,"\u00e9\n"]}}],
          "textures":[{"source":1},{"source":1},{"sampler":0,"source":0}],"samplers":[{"magFilter":9728}],
          "images":[{"bufferView":1,"mimeType":"image/png"},{"uri":"my%20image.png"}],"meshes""#,
    );
    let mut bytes = triangle_bytes();
    bytes[36..42].copy_from_slice(b"\x89PNG\0\0");
    let json =
        json.replace("{\"bufferView\":1,\"componentType\":5123,\"count\":3", "{\"componentType\":5123,\"count\":3");
    let document = read(&glb(&json, &bytes)).expect("valid");
    assert_eq!((document.materials.len(), document.images.len()), (1, 2));
    let material = &document.materials[0];
    assert_eq!((material.name.as_str(), material.image), ("brass", Some(0)));
    assert!((material.colour[0] - 0.735_357).abs() < 1e-6 && material.colour[3] == 0.25);
    assert!(matches!(&document.images[0].data, ImageData::Bytes(bytes) if bytes[..4] == *b"\x89PNG"));
    assert_eq!(document.images[1].data, ImageData::File("my image.png".into()));
    let Some(NativeMaterial::Gltf { material: text, textures }) = &material.native else { panic!("native") };
    assert_eq!(
        &**text,
        "{\"name\":\"brass\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0,1,0.25],\"baseColorTexture\":{\"index\":0,\
         \"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0]}}}},\"normalTexture\":{\"index\":1,\"scale\":5e-1},\
         \"extras\":{\"a\\\"\":[null,true,\"\u{e9}\\u000a\"]}}"
    );
    assert_eq!(textures[..], [("{\"magFilter\":9728}".to_owned(), Some(0)), (String::new(), Some(1))]);
}
