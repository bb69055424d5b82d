use super::{pack, unpack};
use crate::{
    Curves, Document, Domain, Image, ImageData, Material, Mesh, NO_MATERIAL, NativeMaterial, NumberKind, Placement,
    PointCloud, Positions, Property, Values,
};

/// A document with something in each member.
fn rich() -> Document {
    let mesh = Mesh {
        name: "a \"name\"\n".into(),
        positions: Positions::F32(vec![[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.1, 0.0, 0.0]]),
        face_offsets: vec![0, 3, 7],
        corners: vec![0, 1, 2, 3, 2, 1, 0],
        merge: vec![0, 1, 2, 0],
        normals: Values::Vertices(vec![[0.0, 0.0, 1.0 / 3.0]; 4]),
        texcoords: Values::Corners(vec![[0.25, f64::MIN_POSITIVE]; 7]),
        vertex_colours: vec![[0.5, 0.25, 1.0, 1.0]; 4],
        face_colours: vec![[1.0, 0.0, 0.0, 0.5]; 2],
        face_materials: vec![1, NO_MATERIAL],
        properties: vec![Property {
            name: "quality".into(),
            kind: NumberKind::I16,
            domain: Domain::Faces,
            values: vec![-7.0, 1e300],
        }],
    };
    Document {
        meshes: vec![mesh],
        placements: vec![Placement {
            name: "node".into(),
            mesh: 0,
            transform: [[1.0 / 3.0, 0.0, 0.0, 1e17], [0.0, 1.0, 0.0, 0.1], [0.0, 0.0, 1.0, 0.0]],
        }],
        curves: Curves { positions: Positions::F64(vec![[0.1; 3], [0.2; 3]]), offsets: vec![0, 2], closed: vec![true] },
        points: PointCloud {
            positions: Positions::F64(vec![[5.0; 3]]),
            normals: vec![[0.0, 1.0, 0.0]],
            colours: vec![[0.0; 4]],
        },
        materials: vec![
            Material {
                name: "plain".into(),
                native: Some(NativeMaterial::Mtl(vec!["Kd 1 0 0".into()])),
                ..Material::default()
            },
            Material {
                colour: [0.1, 0.2, 0.3, 0.4],
                image: Some(1),
                native: Some(NativeMaterial::Gltf {
                    material: String::from("{}").into(),
                    textures: vec![("{}".into(), Some(0)), (String::new(), None)].into(),
                }),
                ..Material::default()
            },
        ],
        images: vec![
            Image { name: String::new(), media_type: "image/png".into(), data: ImageData::Bytes(vec![1, 2, 3].into()) },
            Image { name: "stone".into(), media_type: String::new(), data: ImageData::File("stone.png".into()) },
        ],
        metres_per_unit: Some(0.001),
        notes: Vec::new(),
    }
}

#[test]
fn packing_keeps_each_bit() {
    let document = rich();
    let packed = pack(&document).unwrap();
    assert_eq!(unpack(&packed.description, &packed.arrays).unwrap(), document);
}

#[test]
fn absent_members_are_empty() {
    assert_eq!(unpack("{}", &[]).unwrap(), Document::default());
    // A mesh without a scene is placed once, unmoved.
    let document = unpack(r#"{"meshes":[{}]}"#, &[]).unwrap();
    assert_eq!(document.placements.len(), 1);
    assert_eq!(document.placements[0].transform, Placement::IDENTITY);
}

#[test]
fn wrong_descriptions_name_the_member() {
    let message = |text: &str| unpack(text, &[0; 16]).unwrap_err().message;
    assert!(message("[").contains("JSON"));
    assert!(message(r#"{"meshes":7}"#).contains("meshes is not a list"));
    for array in [
        r#"{"at":0,"count":4294967296,"type":"u32","width":1}"#,
        r#"{"at":18446744073709551615,"count":1,"type":"u32","width":1}"#,
        r#"{"at":0,"count":5,"type":"u32","width":1}"#,
        r#"{"at":0,"count":1,"type":"f32","width":1}"#,
        r#"{"at":-1,"count":1,"type":"u32","width":1}"#,
        r#"{"at":0,"count":1,"type":"u32","width":3}"#,
        "true",
    ] {
        assert!(
            message(&format!(r#"{{"meshes":[{{"corners":{array}}}]}}"#)).contains("corners is not an array"),
            "{array}"
        );
    }
    let deep = "[".repeat(100_000);
    assert!(message(&deep).contains("JSON"));
}

#[test]
fn each_broken_rule_is_refused() {
    let broken = |change: fn(&mut Document)| {
        let mut document = rich();
        change(&mut document);
        let packed = pack(&document).unwrap();
        unpack(&packed.description, &packed.arrays).unwrap_err().message
    };
    assert_eq!(
        broken(|d| d.meshes[0].corners[4] = 17),
        "mesh 0: face 1, corner 1: vertex 17 does not exist (the mesh has 4)"
    );
    assert!(broken(|d| d.meshes[0].face_offsets[1] = 2).contains("face 0 has 2 corners"));
    assert!(broken(|d| d.meshes[0].face_offsets[1] = 9).contains("offset 2 is less than the previous one"));
    assert!(broken(|d| d.meshes[0].face_offsets[0] = 1).contains("instead of 0 to 7"));
    assert!(broken(|d| d.meshes[0].merge[3] = 4).contains("representative 4 does not exist"));
    assert!(broken(|d| d.meshes[0].merge = vec![1, 2, 2, 3]).contains("does not represent itself"));
    assert!(broken(|d| d.meshes[0].merge.truncate(3)).contains("merge have 3 entries"));
    assert!(broken(|d| d.meshes[0].normals = Values::Vertices(vec![])).contains("normals have 0"));
    assert!(broken(|d| d.meshes[0].texcoords = Values::Corners(vec![[0.0; 2]])).contains("texture coordinates have 1"));
    assert!(broken(|d| d.meshes[0].face_materials[0] = 2).contains("material 2 does not exist (there are 2)"));
    assert!(broken(|d| d.meshes[0].properties[0].values.truncate(1)).contains("property quality"));
    assert!(broken(|d| d.placements[0].mesh = 1).contains("placement 0: mesh 1"));
    assert!(broken(|d| d.materials[1].image = Some(2)).contains("material 1: image 2"));
    assert!(broken(|d| d.curves.closed.push(false)).contains("curves: 2 offsets instead of 3"));
    assert!(broken(|d| d.points.normals.push([0.0; 3])).contains("normals of points"));
}
