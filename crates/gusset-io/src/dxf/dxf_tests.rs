use super::read_dxf;
use crate::test_measures::{area_and_volume, is_closed, mutate, mutations, polygon_area, triangulated, write_to_bytes};
use crate::{Document, Format, Positions, ReadOptions, WriteOptions};
use proptest::prelude::*;
use std::f64::consts::PI;

/// Makes a file of pairs that are separated by blanks: `0 LINE 10 5`.
fn file(blocks: &str, entities: &str) -> Vec<u8> {
    let text = format!(
        "999 comment 0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC \
         0 SECTION 2 BLOCKS {blocks} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    );
    text.split_whitespace().flat_map(|word| [word.as_bytes(), b"\r\n"].concat()).collect()
}

fn read(bytes: impl AsRef<[u8]>) -> Document {
    read_dxf(bytes.as_ref(), &ReadOptions::default()).expect("a drawing that is accepted")
}

fn drawing(entities: &str) -> Document {
    read(file("", entities))
}

fn notes(document: &Document) -> Vec<&str> {
    document.notes.iter().map(|note| note.text.as_str()).collect()
}

fn outline(document: &Document, curve: usize) -> Vec<[f64; 3]> {
    let curves = &document.curves;
    (curves.offsets[curve] as usize..curves.offsets[curve + 1] as usize)
        .map(|point| curves.positions.get(point))
        .collect()
}

fn area(document: &Document, curve: usize) -> f64 {
    let points: Vec<[f64; 2]> = outline(document, curve).iter().map(|&[x, y, _]| [x, y]).collect();
    polygon_area(&points)
}

fn line([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> String {
    format!("0 LINE 8 0 10 {ax} 20 {ay} 11 {bx} 21 {by} ")
}

#[test]
fn lines_join_to_outlines() {
    let sides =
        [([0.0, 0.0], [3.0, 0.0]), ([3.0, 4.0], [3.0, 0.0]), ([0.0, 4.0], [0.0, 0.0]), ([3.0, 4.0], [0.0, 4.0 + 1e-9])];
    let text: String = sides.iter().map(|&(a, b)| line(a, b)).collect();
    let document = drawing(&text);
    assert_eq!(document.curves.closed, [true]);
    assert_eq!(outline(&document, 0).len(), 4);
    assert!((area(&document, 0) - 12.0).abs() < 1e-6);
    assert_eq!(document.metres_per_unit, Some(1e-3));
    // An open chain, and three lines that meet in a point.
    let document =
        drawing(&(line([1.0, 0.0], [2.0, 0.0]) + &line([0.0, 1.0], [1.0, 0.0]) + &line([2.0, 0.0], [5.0, 5.0])));
    assert_eq!(outline(&document, 0), [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [5.0, 5.0, 0.0]]);
    let star = line([0.0, 0.0], [1.0, 0.0]) + &line([0.0, 0.0], [0.0, 1.0]) + &line([0.0, 0.0], [-1.0, 0.0]);
    assert_eq!(drawing(&star).curves.closed, [false; 3]);
}

#[test]
fn curves_keep_their_area() {
    for (entities, wanted) in [
        ("0 CIRCLE 10 5 20 6 40 2", 4.0 * PI),
        // A half circle and its diameter.
        ("0 ARC 10 0 20 0 40 3 50 0 51 180 0 LINE 10 -3 20 0 11 3 21 0", 4.5 * PI),
        ("0 ARC 10 0 20 0 40 3 50 270 51 90 0 LINE 10 0 20 3 11 0 21 -3", 4.5 * PI),
        ("0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 4 20 0 42 1", 4.0 * PI),
        ("0 LWPOLYLINE 70 1 10 0 20 0 10 4 20 0 42 -1 10 4 20 4 10 0 20 4", 16.0 - 2.0 * PI),
        (
            "0 POLYLINE 66 1 70 1 0 VERTEX 10 0 20 0 0 VERTEX 10 4 20 0 42 1 0 VERTEX 10 4 20 4 0 VERTEX 10 0 20 4 0 SEQEND",
            16.0 + 2.0 * PI,
        ),
        ("0 ELLIPSE 10 1 20 1 11 3 21 0 31 0 40 .5 41 0 42 6.283185307179586", 4.5 * PI),
        ("0 ELLIPSE 10 1 20 1 11 0 21 3 31 0 40 .5 41 0 42 3.141592653589793 0 LINE 10 1 20 4 11 1 21 -2", 2.25 * PI),
        // The quadratic spline of a parabola over a box of 6 x 4, and a quarter circle as a rational spline.
        (
            "0 SPLINE 70 8 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 30 0 10 3 20 4 30 0 10 6 20 0 30 0 0 LINE 10 6 20 0 11 0 21 0",
            -8.0,
        ),
        (
            "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 10 2 20 0 10 2 20 2 10 0 20 2 \
             0 LINE 10 0 20 2 11 0 21 0 0 LINE 10 0 20 0 11 2 21 0",
            PI,
        ),
        // Without its degree.
        ("0 SPLINE 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 3 20 4 10 6 20 0 0 LINE 10 6 20 0 11 0 21 0", -8.0),
        // Fit points alone.
        ("0 SPLINE 70 1 71 3 11 0 21 0 11 3 21 0 11 3 21 4", 6.0),
        // The normal points down: x is mirrored.
        ("0 CIRCLE 10 -5 20 6 40 2 210 0 220 0 230 -1", -4.0 * PI),
    ] {
        let document = drawing(entities);
        assert_eq!(document.curves.closed, [true], "{entities}");
        let found = area(&document, 0);
        assert!((found - wanted).abs() < 1e-3, "{entities}: {found} {wanted}");
    }
    let mirrored = drawing("0 CIRCLE 10 -5 20 6 40 2 210 0 220 0 230 -1");
    assert!(outline(&mirrored, 0).iter().all(|[x, y, _]| ((x - 5.0).hypot(y - 6.0) - 2.0).abs() < 1e-12));
    let tilted = drawing("0 CIRCLE 10 1 20 2 30 3 40 2 210 1 220 0 230 0");
    assert!(
        outline(&tilted, 0)
            .iter()
            .all(|[x, y, z]| (x - 3.0).abs() < 1e-12 && ((y - 1.0).hypot(z - 2.0) - 2.0).abs() < 1e-12)
    );
}

#[test]
fn blocks_are_inserted() {
    let block =
        "0 BLOCK 2 Hole 10 1 20 1 0 CIRCLE 10 1 20 1 40 1 0 ENDBLK 0 BLOCK 2 two 0 INSERT 2 HOLE 10 4 20 0 0 ENDBLK";
    let document = read(file(
        block,
        "0 INSERT 2 two 10 10 20 0 50 90 41 2 42 2 0 INSERT 2 none 0 CIRCLE 67 1 40 1 0 TEXT 1 a 0 TEXT 1 b",
    ));
    assert_eq!(document.curves.closed, [true]);
    assert!(outline(&document, 0).iter().all(|[x, y, _]| ((x - 10.0).hypot(y - 8.0) - 2.0).abs() < 1e-9));
    assert_eq!(
        notes(&document),
        [
            "2 TEXT left out",
            "1 entity of the paper space left out",
            "1 insertion of blocks that the file lacks or that hold the insertion, left out"
        ]
    );
    let document = read(file(block, "0 INSERT 2 hole 70 3 71 2 44 10 45 20"));
    assert_eq!(document.curves.closed.len(), 6);
    assert!(outline(&document, 5).iter().all(|[x, y, _]| ((x - 20.0).hypot(y - 20.0) - 1.0).abs() < 1e-9));
}

#[test]
fn faces_become_a_mesh() {
    let (o, a, b, c) = ("0 0 0", "30 0 0", "0 20 0", "0 0 10");
    let face = |corners: [&str; 3]| {
        let mut text = String::from("0 3DFACE ");
        for (corner, words) in [corners[0], corners[1], corners[2], corners[2]].into_iter().enumerate() {
            for (axis, word) in words.split(' ').enumerate() {
                text += &format!("{} {word} ", 10 * (axis + 1) + corner);
            }
        }
        text
    };
    let faces = [[o, b, a], [o, a, c], [a, b, c], [o, c, b], [o, o, a]].map(face).concat();
    let document = drawing(&faces);
    let mesh = &document.meshes[0];
    assert_eq!((mesh.positions.len(), mesh.face_count()), (4, 4));
    assert!(is_closed(mesh) && (area_and_volume(mesh).1 - 1000.0).abs() < 1e-9);
    assert_eq!(notes(&document), ["1 face with fewer than 3 corners left out"]);
    let polyface = "0 POLYLINE 66 1 70 64 0 VERTEX 10 0 20 0 70 192 0 VERTEX 10 1 20 0 70 192 0 VERTEX 10 1 20 2 70 192 \
                    0 VERTEX 10 0 20 2 70 192 \
                    0 VERTEX 70 128 71 1 72 2 73 -3 74 4 0 VERTEX 70 128 71 1 72 2 73 9 0 SEQEND 0 POINT 10 1 20 2 30 3";
    let document = drawing(polyface);
    assert_eq!(document.meshes[0].corners, [0, 1, 2, 3]);
    assert_eq!(document.points.positions, Positions::F64(vec![[1.0, 2.0, 3.0]]));
    assert_eq!(notes(&document), ["1 face with vertices that do not exist, left out"]);
    let vertices: String = (0..12).map(|k| format!("0 VERTEX 10 {} 20 {} ", k % 4, k / 4)).collect();
    assert!(drawing("0 POLYLINE 66 1 70 16 0 SEQEND").meshes.is_empty());
    let document = drawing(&format!("0 POLYLINE 66 1 70 16 71 3 72 4 {vertices} 0 SEQEND"));
    assert_eq!(document.meshes[0].face_count(), 6);
    assert!((area_and_volume(&triangulated(&document.meshes[0])).0 - 6.0).abs() < 1e-12);
}

#[test]
fn errors_are_clear() {
    let message = |bytes: &[u8]| read_dxf(bytes, &ReadOptions::default()).expect_err("not a drawing").to_string();
    assert!(message(b"AutoCAD Binary DXF\r\n\x1a\0").contains("save it as text"));
    assert!(message(b"AC1015\0\0").contains("DWG"));
    assert_eq!(message(b""), "1: the file has no section of DXF");
    assert_eq!(message(b"0\nSECTION\n2\nENTITIES\nx\nLINE\n"), "5: \"x\" is not a group code");
}

#[test]
fn hostile_drawings_cost_little() {
    let start = std::time::Instant::now();
    let mut bomb = String::from("0 BLOCK 2 b0 0 LINE 10 1 20 1 0 ENDBLK ");
    for level in 1..15 {
        bomb += &format!("0 BLOCK 2 b{level} {} 0 ENDBLK ", format!("0 INSERT 2 b{} ", level - 1).repeat(10));
    }
    let error = read_dxf(&file(&bomb, "0 INSERT 2 b14"), &ReadOptions::default()).expect_err("a bomb").to_string();
    assert!(error.contains("16 times"), "{error}");
    let empty = file(
        "0 BLOCK 2 a 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 b 0 ENDBLK",
        "0 INSERT 2 b 0 INSERT 2 a 70 1000000 71 1000000",
    );
    assert!(read_dxf(&empty, &ReadOptions::default()).is_err());
    assert_eq!(drawing(&"0 CIRCLE 40 1e9 ".repeat(20_000)).curves.closed.len(), 20_000);
    assert_eq!(drawing(&"0 LINE 10 1 11 2 ".repeat(100_000)).curves.closed.len(), 100_000);
    let rays: String =
        (0..50_000).map(|k| line([0.0, 0.0], [f64::from(k), 1.0]) + &line([f64::from(k), 1.0], [0.5, 0.5])).collect();
    assert_eq!(drawing(&rays).curves.closed.len(), 50_000);
    drawing(
        "0 LWPOLYLINE 10 1e308 20 -1e308 42 1e-300 10 -1e308 42 nan 10 5 42 1e300 0 ARC 40 nan 50 inf 51 1 0 CIRCLE 40 1e-300",
    );
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}

#[test]
fn drawings_come_back_as_they_were() {
    let mut document = drawing(
        "0 LWPOLYLINE 70 1 38 7 10 0.1 20 0.30000000000000004 10 4 20 0 10 4 20 4 \
         0 POLYLINE 70 8 0 VERTEX 10 1 20 2 30 3 0 VERTEX 10 4 20 5 30 6 0 VERTEX 10 7 20 7 30 7 0 SEQEND 0 POINT 10 1 20 1 30 1",
    );
    document.metres_per_unit = Some(0.3048);
    let (bytes, losses) = write_to_bytes(&document, Format::Dxf, &WriteOptions::default()).expect("a drawing");
    assert_eq!(losses, [""; 0]);
    assert_eq!(read(&bytes), document);
    document.metres_per_unit = Some(0.3);
    let (_, losses) = write_to_bytes(&document, Format::Dxf, &WriteOptions::default()).expect("a drawing");
    assert_eq!(losses, ["the unit of 0.3 m, for which DXF files have no name"]);
}

proptest! {
    #[test]
    fn mutations_never_panic(changes in mutations()) {
        let mut bytes = file(
            "0 BLOCK 2 a 10 1 0 CIRCLE 40 1 0 ENDBLK",
            "0 INSERT 2 a 41 2 50 30 70 2 0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 4 20 0 0 ELLIPSE 11 3 40 .5 41 0 42 5 210 1 230 1 \
             0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 3 20 4 10 6 20 0 0 LINE 10 6 11 3 0 3DFACE 10 1 21 1 32 1 \
             0 POLYLINE 70 64 0 VERTEX 10 1 70 192 0 VERTEX 20 1 70 192 0 VERTEX 30 1 70 192 0 VERTEX 70 128 71 1 72 2 73 3 0 SEQEND",
        );
        mutate(&mut bytes, &changes);
        if let Ok(document) = read_dxf(&bytes, &ReadOptions::default()) {
            prop_assert_eq!(document.curves.offsets.last().copied(), Some(document.curves.positions.len() as u32));
            prop_assert_eq!(document.curves.offsets.len(), document.curves.closed.len() + 1);
            for mesh in &document.meshes {
                prop_assert!(mesh.corners.iter().all(|&vertex| (vertex as usize) < mesh.positions.len()));
                prop_assert_eq!(mesh.face_offsets.last().copied(), Some(mesh.corners.len() as u32));
            }
        }
    }
}
