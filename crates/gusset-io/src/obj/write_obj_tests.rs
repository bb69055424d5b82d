//! Written OBJ files, and the documents that they give back.

use super::mtl_tests::Files;
use super::obj_tests::{is_closed, read, volume};
use super::{read_obj, write_obj};
use crate::document::{Curves, Document, Placement, PointCloud};
use crate::material::{Image, ImageData, Material, NO_MATERIAL, NativeMaterial};
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{NoResources, Target};
use std::collections::HashMap;

/// Returns the file, the files beside it, and the losses.
fn written(document: &Document) -> (String, HashMap<String, Vec<u8>>, Vec<String>) {
    let (mut main, mut beside) = (Vec::new(), HashMap::new());
    let mut add = |name: &str, bytes: &[u8]| {
        assert!(beside.insert(name.to_string(), bytes.to_vec()).is_none(), "{name} is written twice");
        Ok(())
    };
    let mut target = Target { main_file: &mut main, stem: "a b", beside: &mut add, resources: &NoResources };
    let losses = write_obj(document, &mut target, &WriteOptions::default()).expect("memory is written");
    (String::from_utf8(main).expect("OBJ is text"), beside, losses.into_iter().map(|loss| loss.0).collect())
}

fn triangle() -> Mesh {
    Mesh {
        positions: Positions::F32(vec![[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        face_offsets: vec![0, 3],
        corners: vec![0, 1, 2],
        ..Mesh::default()
    }
}

#[test]
fn numbers_are_the_shortest() {
    let mut mesh = triangle();
    assert_eq!(written(&Document::from_mesh(mesh.clone())).0, "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    mesh.positions = Positions::F64(vec![[f64::from(0.1_f32), 0.1, 1e300], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    mesh.vertex_colours = vec![[0.2, 0.0, 1.5, 1.0], [f32::NAN, 1.0, 1.0, 1.0], [0.0, 0.0, 0.0, 0.5]];
    let (text, _, losses) = written(&Document::from_mesh(mesh.clone()));
    assert_eq!(text, "v 0.10000000149011612 0.1 1e300 0.2 0 1\nv 1 0 0 0 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
    assert_eq!(losses, ["the opacity of vertices, which OBJ files do not hold"]);
    assert_eq!(read(&text).meshes[0].positions, mesh.positions);
}

/// A cube with its own vertices for each face, flat normals and texture coordinates.
fn split_cube() -> Mesh {
    let mut mesh = Mesh::default();
    let (mut points, mut normals, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
    for axis in 0..3 {
        for side in [0.0, 1.0] {
            for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
                let mut point = [0.0; 3];
                point[axis] = side;
                (point[(axis + 1) % 3], point[(axis + 2) % 3]) = if side > 0.0 { (u, v) } else { (v, u) };
                points.push(point);
                let mut normal = [0.0; 3];
                normal[axis] = 2.0 * f64::from(side) - 1.0;
                normals.push(normal);
                pairs.push([f64::from(u), f64::from(v)]);
            }
            mesh.corners.extend(mesh.corners.len() as u32..points.len() as u32);
            mesh.face_offsets.push(points.len() as u32);
        }
    }
    mesh.merge =
        points.iter().map(|point| points.iter().position(|other| other == point).unwrap_or(0) as u32).collect();
    (mesh.positions, mesh.normals, mesh.texcoords) =
        (Positions::F32(points), Values::Vertices(normals), Values::Vertices(pairs));
    mesh
}

#[test]
fn split_vertices_are_written_once() {
    let cube = split_cube();
    assert!(!is_closed(&cube));
    let (text, beside, losses) = written(&Document::from_mesh(cube.clone()));
    assert!(beside.is_empty() && losses.is_empty());
    assert_eq!(text.lines().filter(|line| line.starts_with("v ")).count(), 8);
    assert_eq!(text.lines().filter(|line| line.starts_with("vn ")).count(), 6);
    assert_eq!(text.lines().filter(|line| line.starts_with("vt ")).count(), 4);
    let back = read(&text).meshes.remove(0);
    assert!(is_closed(&back));
    assert_eq!(volume(&back), 1.0);
    for corner in 0..cube.corners.len() {
        let [was, now] = [&cube, &back].map(|mesh| {
            let vertex = mesh.corners[corner];
            let position = mesh.positions.get(vertex as usize);
            (position, mesh.normals.at_corner(corner, vertex), mesh.texcoords.at_corner(corner, vertex))
        });
        assert_eq!(was, now);
    }
    assert_eq!(written(&Document::from_mesh(cube)).0, text);
}

#[test]
fn placements_become_objects() {
    let mirrored = [[-1.0, 0.0, 0.0, 1e6], [0.0, 1.0, 0.0, 0.25], [0.0, 0.0, 1.0, 0.0]];
    let mut document = Document { meshes: vec![split_cube(), triangle()], ..Document::default() };
    for (name, mesh, transform) in
        [("first\nf 9 9 9", 0, Placement::IDENTITY), ("", 1, Placement::IDENTITY), ("second", 0, mirrored)]
    {
        document.placements.push(Placement { name: name.into(), mesh, transform });
    }
    let (text, ..) = written(&document);
    let objects: Vec<_> = text.lines().filter(|line| line.starts_with("o ")).collect();
    assert_eq!(objects, ["o first_f 9 9 9", "o object_2", "o second"]);
    let back = read(&text);
    let names: Vec<_> = back.meshes.iter().map(|mesh| &*mesh.name).collect();
    assert_eq!(names, ["first_f 9 9 9", "object_2", "second"]);
    let back = back.into_joined(u64::MAX).expect("it is small").meshes.remove(0);
    let flat = document.into_joined(u64::MAX).expect("it is small").meshes.remove(0);
    assert_eq!(back.face_count(), flat.face_count());
    for (now, was) in (0..back.face_count()).map(|face| (back.face_range(face), flat.face_range(face))) {
        for (now, was) in now.zip(was) {
            let values = |mesh: &Mesh, corner: usize| {
                let vertex = mesh.corners[corner];
                (mesh.positions.get(vertex as usize), mesh.normals.at_corner(corner, vertex))
            };
            assert_eq!(values(&back, now).0.map(|part| part as f32), values(&flat, was).0.map(|part| part as f32));
            assert_eq!(values(&back, now).1, values(&flat, was).1);
        }
    }
    assert_eq!(volume(&back), 2.0);
}

#[test]
fn curves_and_points_follow_the_mesh() {
    let document = Document {
        curves: Curves {
            positions: Positions::F64(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [5.0; 3], [6.0; 3]]),
            offsets: vec![0, 3, 3, 5],
            closed: vec![true, false, false],
        },
        points: PointCloud {
            positions: Positions::F64(vec![[7.0; 3]]),
            normals: vec![[0.0, 0.0, 1.0]],
            colours: vec![[1.0, 0.0, 0.0, 1.0]],
        },
        ..Document::from_mesh(triangle())
    };
    let (text, _, losses) = written(&document);
    assert!(text.ends_with("l 4 5 6 4\nl 7 8\nv 7 7 7 1 0 0\np 9\n"), "{text}");
    assert_eq!(losses, ["normals of points, which OBJ files hold only without meshes and curves"]);
    let back = read(&text);
    assert_eq!(back.meshes[0].positions.len(), 3);
    assert_eq!(back.curves.positions, document.curves.positions);
    assert_eq!((back.curves.offsets, back.curves.closed), (vec![0, 3, 5], vec![true, false]));
    assert_eq!(back.points.colours, document.points.colours);
    let cloud = Document { points: document.points, ..Document::default() };
    let (text, _, losses) = written(&cloud);
    assert!(losses.is_empty());
    assert_eq!(read(&text).points, cloud.points);
}

#[test]
fn libraries_keep_all_lines() {
    let library = "newmtl scan\nKd 1 0 0\nNs 10\nmap_Kd -s 1 1 1 skin of it.png\nnewmtl none\nKd 0 0 1\n";
    let files = Files([("all.mtl", library.as_bytes().to_vec())].into());
    let text = "mtllib all.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl scan\nf 1 2 3\nusemtl none\nf 1 2 3\nusemtl scan\nf 1 2 3\nf 3 2 1\nusemtl other\nf 1 2 3\nusemtl null\nf 1 2 3\n";
    let document = read_obj(text.as_bytes(), &files, &ReadOptions::default()).expect("the file is valid");
    let (text, mut beside, losses) = written(&document);
    assert!(losses.is_empty());
    assert_eq!(
        text,
        "mtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl scan\nf 1 2 3\nusemtl none\nf 1 2 3\nusemtl scan\nf 1 2 3\nf 3 2 1\nusemtl other\nf 1 2 3\nusemtl (none)\nf 1 2 3\n"
    );
    let written_library = beside.remove("a b.mtl").expect("it is written");
    assert_eq!(String::from_utf8_lossy(&written_library), format!("{library}newmtl other\nKd 1 1 1\n"));
    let again = Files([("a b.mtl", written_library)].into());
    let back = read_obj(text.as_bytes(), &again, &ReadOptions::default()).expect("the file is valid");
    assert_eq!(back.meshes[0].face_materials, [NO_MATERIAL, 0, 1, 0, 0, 2, NO_MATERIAL]);
    assert_eq!(back.materials[..2], document.materials[..2]);
}

#[test]
fn materials_of_other_formats_give_colour_and_image() {
    let png = std::sync::Arc::new(b"\x89PNG\r\n\x1a\n".to_vec());
    let gltf =
        |json: &str| Some(NativeMaterial::Gltf { material: json.to_owned().into(), textures: Vec::new().into() });
    let material =
        |name: &str, image, native| Material { name: name.into(), colour: [1.0, 0.5, 0.0, 0.5], image, native };
    let document = Document {
        materials: vec![
            material(
                "sc/an",
                Some(0),
                gltf(r#"{"name":"a \"x\": b","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1]}}"#),
            ),
            material("scan\nnewmtl x", Some(0), gltf(r#"{"emissiveFactor" : [1,1,1]}"#)),
            material("sc/an", Some(1), None),
            material("", None, None),
        ],
        images: vec![
            Image { name: String::new(), media_type: String::new(), data: ImageData::Bytes(png) },
            Image { name: String::new(), media_type: String::new(), data: ImageData::File("my image.jpg".into()) },
        ],
        ..Document::from_mesh(Mesh {
            face_offsets: vec![0, 3, 6, 9, 12],
            corners: [0, 1, 2].repeat(4),
            face_materials: vec![0, 1, 2, 3],
            ..triangle()
        })
    };
    let (_, mut beside, losses) = written(&document);
    assert_eq!(losses, ["all of 1 material but base colour and image, which alone OBJ files hold"]);
    let library = String::from_utf8(beside.remove("a b.mtl").expect("it is written")).expect("MTL is text");
    assert_eq!(
        library,
        "newmtl sc/an\nKd 1 0.5 0\nd 0.5\nmap_Kd a_b_sc_an.png\nnewmtl scan_newmtl x\nKd 1 0.5 0\nd 0.5\nmap_Kd a_b_sc_an.png\n\
         newmtl sc/an_2\nKd 1 0.5 0\nd 0.5\nmap_Kd my image.jpg\nnewmtl material\nKd 1 0.5 0\nd 0.5\n"
    );
    assert_eq!(beside.into_iter().collect::<Vec<_>>(), [("a_b_sc_an.png".to_string(), b"\x89PNG\r\n\x1a\n".to_vec())]);
}

#[test]
fn losses_are_named() {
    let property = |name: &str, domain, count| Property {
        name: name.into(),
        kind: NumberKind::F32,
        domain,
        values: vec![0.0; count],
    };
    let mesh = Mesh {
        face_colours: vec![[1.0; 4]],
        properties: vec![property("quality", Domain::Vertices, 3), property("region", Domain::Faces, 1)],
        merge: vec![0, 1, 1],
        vertex_colours: vec![[1.0; 4], [0.5, 0.5, 0.5, 1.0], [1.0; 4]],
        ..triangle()
    };
    assert_eq!(
        written(&Document::from_mesh(mesh)).2,
        [
            "colours of faces, which OBJ files do not hold",
            "colours that differ at one vertex, which OBJ files do not hold",
            "quality of vertices, which PLY files alone hold",
            "region of faces, which PLY files alone hold"
        ]
    );
}

#[test]
fn missing_values_leave_their_face_without() {
    let mut mesh = triangle();
    mesh.face_offsets.push(6);
    mesh.corners = vec![0, 1, 2, 2, 1, 0];
    let missing = Values::<2>::MISSING;
    mesh.texcoords = Values::Corners(vec![[0.0, 0.5], [1.0, 0.0], [0.0, 0.5], missing, [1.0, 0.0], [0.0, 0.0]]);
    let (text, ..) = written(&Document::from_mesh(mesh));
    assert!(text.ends_with("vt 0 0.5\nvt 1 0\nvt 0 0\nf 1/1 2/2 3/1\nf 3 2 1\n"), "{text}");
}

#[test]
fn materials_are_lost_where_no_file_can_be_beside() {
    let document = Document {
        materials: vec![Material { name: "red".into(), ..Material::default() }],
        ..Document::from_mesh(Mesh { face_materials: vec![0], ..triangle() })
    };
    let mut main = Vec::new();
    let mut refuse =
        |_: &str, _: &[u8]| Err(std::io::Error::new(std::io::ErrorKind::Unsupported, "there is no folder"));
    let mut target = Target { main_file: &mut main, stem: "a", beside: &mut refuse, resources: &NoResources };
    let losses = write_obj(&document, &mut target, &WriteOptions::default()).expect("memory is written");
    assert_eq!(losses[0].0, "materials, which need a file beside the OBJ file: there is no folder");
    assert_eq!(String::from_utf8_lossy(&main), "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    let mut fail = |_: &str, _: &[u8]| Err(std::io::ErrorKind::StorageFull.into());
    let mut target = Target { main_file: &mut main, stem: "a", beside: &mut fail, resources: &NoResources };
    let error = write_obj(&document, &mut target, &WriteOptions::default()).expect_err("the disk is full");
    assert_eq!(error.to_string(), "no space is left on the disk");
}

#[test]
fn objects_share_values() {
    let mut mesh = triangle();
    mesh.normals = Values::Vertices(vec![[0.0, 0.0, 1.0]; 3]);
    let mut document = Document::from_mesh(mesh);
    let shift = [[1.0, 0.0, 0.0, 5.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    document.placements.push(Placement { name: "b".into(), mesh: 0, transform: shift });
    let (text, ..) = written(&document);
    assert_eq!(text.matches("vn").count(), 1);
    assert!(text.ends_with("f 4//1 5//1 6//1\n"), "{text}");
}
