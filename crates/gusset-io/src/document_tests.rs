//! Scenes as one mesh: each corner keeps its values, whatever the other meshes have.

use crate::document::{Document, Placement};
use crate::error::ReadErrorKind;
use crate::material::NO_MATERIAL;
use crate::mesh::{Domain, Mesh, NumberKind, Positions, Property, Values};
use proptest::prelude::*;

/// A mesh of a triangle and a quad on 5 points, the last of which no face uses. Bits of `kinds` choose its attributes.
fn mesh(kinds: u32, seed: f64) -> Mesh {
    let points: Vec<[f64; 3]> = (0..5).map(|k| [f64::from(k) + seed, 0.5 * f64::from(k * k), seed]).collect();
    let values = |kind: u32, count: usize| -> Vec<[f64; 3]> {
        let value = |k: usize| if kind == 3 && k == 1 { [f64::NAN; 3] } else { [0.0, 0.6, 0.8 + seed * k as f64] };
        (0..count).map(value).collect()
    };
    let normals = match kinds & 3 {
        0 => Values::Absent,
        1 => Values::Vertices(values(1, 5)),
        kind => Values::Corners(values(kind, 7)),
    };
    let pairs = |count: usize| (0..count).map(|k| [k as f64, seed]).collect();
    let texcoords = match kinds >> 2 & 3 {
        0 => Values::Absent,
        1 => Values::Vertices(pairs(5)),
        _ => Values::Corners(pairs(7)),
    };
    let has = |bit: u32| kinds >> bit & 1 == 1;
    let property =
        |name: &str, domain, count, kind| Property { name: name.into(), kind, domain, values: vec![seed; count] };
    let mut properties = Vec::new();
    if has(4) {
        properties.push(property(
            "quality",
            Domain::Vertices,
            5,
            if has(5) { NumberKind::I32 } else { NumberKind::F32 },
        ));
    }
    if has(6) {
        properties.push(property("quality", Domain::Faces, 2, NumberKind::U8));
    }
    Mesh {
        positions: if has(7) {
            Positions::F32(points.iter().map(|point| point.map(|part| part as f32)).collect())
        } else {
            Positions::F64(points)
        },
        face_offsets: vec![0, 3, 7],
        corners: vec![0, 1, 2, 0, 2, 3, 1],
        merge: if has(8) { vec![0, 1, 2, 0, 4] } else { Vec::new() },
        normals,
        texcoords,
        vertex_colours: if has(9) { vec![[seed as f32; 4]; 5] } else { Vec::new() },
        face_colours: if has(10) { vec![[seed as f32; 4]; 2] } else { Vec::new() },
        face_materials: if has(11) { vec![0, NO_MATERIAL] } else { Vec::new() },
        properties,
        ..Mesh::default()
    }
}

const MIRROR_AND_MOVE: [[f64; 4]; 3] = [[-2.0, 0.0, 0.0, 10.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
const TURN: [[f64; 4]; 3] = [[0.0, -1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 5.0]];

/// Corners of the quad and the triangle in a mirrored mesh.
const BACKWARDS: [usize; 7] = [0, 2, 1, 3, 6, 5, 4];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]
    #[test]
    fn joined_corners_keep_their_values(scene in proptest::collection::vec((0..4096_u32, 0..3_usize), 1..6)) {
        let transforms = [Placement::IDENTITY, MIRROR_AND_MOVE, TURN];
        let meshes: Vec<Mesh> = scene.iter().zip(1..).map(|(&(kinds, _), k)| mesh(kinds, 0.125 * f64::from(k))).collect();
        let placements = scene.iter().zip(0..).map(|(&(_, transform), mesh)| Placement {
            name: String::new(),
            mesh,
            transform: transforms[transform],
        });
        let document = Document { placements: placements.collect(), meshes: meshes.clone(), ..Document::default() };
        let borrowed = document.joined().expect("it is small").into_owned();
        let joined = document.into_joined(1000).expect("it is small").meshes.remove(0);
        // Missing values are NaN, so that `==` would not do.
        prop_assert_eq!(format!("{:?}", borrowed), format!("{:?}", joined));
        prop_assert_eq!(joined.face_count(), 2 * meshes.len());
        for (part, (mesh, &(_, transform))) in meshes.iter().zip(&scene).enumerate() {
            check_part(&joined, part, mesh, transform);
        }
    }
}

fn check_part(joined: &Mesh, part: usize, mesh: &Mesh, transform: usize) {
    for (place, &mirrored) in BACKWARDS.iter().enumerate() {
        let (now, was) = (7 * part + place, if transform == 1 { mirrored } else { place });
        let (new_vertex, old_vertex) = (joined.corners[now], mesh.corners[was]);
        assert_eq!(new_vertex, old_vertex + 5 * part as u32);
        let [x, y, z] = mesh.positions.get(old_vertex as usize);
        let moved = [[x, y, z], [10.0 - 2.0 * x, y, z], [-y, x, z + 5.0]][transform];
        assert_eq!(joined.positions.get(new_vertex as usize), moved);
        assert_eq!(joined.texcoords.at_corner(now, new_vertex), mesh.texcoords.at_corner(was, old_vertex));
        let [new_normal, old_normal] = [(joined, now, new_vertex), (mesh, was, old_vertex)]
            .map(|(mesh, corner, vertex)| mesh.normals.at_corner(corner, vertex));
        assert_eq!(new_normal.is_some(), old_normal.is_some());
        if let (Some(now), Some([x, y, z])) = (new_normal, old_normal) {
            // The fixed axis of each transform keeps its part of the normal's direction.
            let wanted = [[x, y, z], [-x / 2.0, y, z], [-y, x, z]][transform];
            let length = if transform == 0 { 1.0 } else { wanted.iter().map(|part| part * part).sum::<f64>().sqrt() };
            assert!((0..3).all(|axis| (now[axis] - wanted[axis] / length).abs() < 1e-12), "{now:?} {wanted:?}");
        }
        let representative = mesh.representative(old_vertex) + 5 * part as u32;
        assert_eq!(joined.representative(new_vertex), representative);
        if !joined.vertex_colours.is_empty() {
            let colour = mesh.vertex_colours.get(old_vertex as usize).copied().unwrap_or([1.0; 4]);
            assert_eq!(joined.vertex_colours[new_vertex as usize], colour);
        }
    }
    for face in 0..2 {
        let material = mesh.face_materials.get(face).copied().unwrap_or(NO_MATERIAL);
        assert_eq!(joined.face_materials.get(2 * part + face).copied().unwrap_or(NO_MATERIAL), material);
        if !joined.face_colours.is_empty() {
            let colour = mesh.face_colours.get(face).copied().unwrap_or([1.0; 4]);
            assert_eq!(joined.face_colours[2 * part + face], colour);
        }
    }
    for property in &joined.properties {
        let count = if property.domain == Domain::Vertices { 5 } else { 2 };
        assert_eq!(property.values.len() % count, 0);
        let own = mesh.properties.iter().find(|own| own.domain == property.domain);
        let value = own.map_or(0.0, |own| own.values[0]);
        assert!(property.values[count * part..count * (part + 1)].iter().all(|&number| number == value));
        assert!(own.is_none_or(|own| own.kind == property.kind || property.kind == NumberKind::F64));
    }
}

#[test]
fn copies_of_meshes_are_limited() {
    let placement = Placement { name: String::new(), mesh: 0, transform: TURN };
    let document = Document { meshes: vec![mesh(0, 1.0)], placements: vec![placement; 100], ..Document::default() };
    let error = document.clone().into_joined(1199).expect_err("they have 1200 points and corners");
    assert_eq!(error.kind, ReadErrorKind::TooLarge);
    assert!(document.into_joined(1200).is_ok());
    let empty = Document::default().into_joined(0).expect("it is empty").meshes.remove(0);
    assert_eq!(empty, Mesh::default());
}
