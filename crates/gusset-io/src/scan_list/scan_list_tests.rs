//! Lists of scans whose files are in memory.

use super::read_scan_list;
use crate::document_checks::{Mutation, assert_valid};
use crate::{Document, Placement, Positions, ReadError, ReadErrorKind, ReadOptions, Resources};
use proptest::prelude::*;
use std::cell::RefCell;
use std::collections::BTreeMap;

const TRIANGLE: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
    element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const POINTS: &str = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
    property float nx\nproperty float ny\nproperty float nz\nend_header\n1 2 3 0 0 1\n4 5 6 1 0 0\n";

/// Files by their names, and the names that were asked for.
struct Files {
    files: BTreeMap<String, Vec<u8>>,
    loads: RefCell<Vec<String>>,
}

impl Files {
    fn new(files: &[(&str, &str)]) -> Self {
        let files = files.iter().map(|(name, text)| ((*name).into(), text.as_bytes().to_vec())).collect();
        Self { files, loads: RefCell::default() }
    }
}

impl Resources for Files {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        self.loads.borrow_mut().push(name.into());
        let missing = || ReadError::new(ReadErrorKind::Unreadable, format!("{name}: the file does not exist"));
        self.files.get(name).cloned().ok_or_else(missing)
    }
}

fn read(list: &str, files: &Files) -> Result<Document, ReadError> {
    let document = read_scan_list(list.as_bytes(), files, &ReadOptions::default(), crate::read)?;
    assert_valid(&document);
    Ok(document)
}

/// Points of all placed meshes in the scene.
fn placed(document: &Document) -> Vec<[f64; 3]> {
    document.clone().into_joined(1000).expect("a small scene").meshes[0].positions.iter().collect()
}

#[test]
fn scans_are_placed() {
    let files = Files::new(&[("one.ply", TRIANGLE), ("part 2/two.ply", TRIANGLE), ("points.ply", POINTS)]);
    let half = 0.5_f64.sqrt();
    let list = format!(
        "\u{feff}camera 0 0 0 0 0 0 1\r\nbmesh one.ply 0 0 0 0 0 0 1 # the first\n\n\
         bmesh part 2\\two.ply 100 0 0 0 0 {half} {half}\nbmesh points.ply 0 0 10 0 0 2 2"
    );
    let document = read(&list, &files).expect("a scene");
    assert_eq!(document.meshes.len(), 2);
    let names: Vec<_> = document.placements.iter().map(|placement| &placement.name[..]).collect();
    assert_eq!(names, ["one", "two"]);
    assert_eq!(document.placements[0].transform, Placement::IDENTITY);
    // The quaternion turns the axes by a quarter, and so the points back by one.
    let near = |found: [f64; 3], expected: [f64; 3]| {
        assert!((0..3).all(|axis| (found[axis] - expected[axis]).abs() < 1e-12), "{found:?} {expected:?}");
    };
    let points = placed(&document);
    for (k, [x, y, z]) in points[..3].iter().enumerate() {
        near(points[3 + k], [100.0 + y, -x, *z]);
    }
    near(document.points.positions.get(0), [2.0, -1.0, 13.0]);
    near(document.points.normals[1], [0.0, -1.0, 0.0]);
}

#[test]
fn a_scan_is_loaded_once() {
    let files =
        Files::new(&[("one.ply", TRIANGLE), ("points.ply", POINTS), ("again.conf", "bmesh one.ply 0 0 0 0 0 0 1")]);
    let lines: String = (0..100).map(|k| format!("bmesh {}one.ply {k} 0 0 0 0 0 1\n", "./".repeat(k))).collect();
    let document = read(&lines, &files).expect("a scene");
    assert_eq!((document.meshes.len(), document.placements.len(), files.loads.borrow().len()), (1, 100, 1));
    assert_eq!(placed(&document)[297], [99.0, 0.0, 0.0]);
    let error = read(&"bmesh points.ply 0 0 0 0 0 0 1\n".repeat(2), &files).expect_err("repeated points");
    assert_eq!(error.to_string(), "2: points.ply is named in line 1 too; only scans of one mesh can be repeated");
    let error = read("bmesh again.conf 0 0 0 0 0 0 1", &files).expect_err("a list in a list");
    assert_eq!(error.to_string(), "1: again.conf: a list of scans cannot name another list");
}

#[test]
fn points_without_normals_take_the_normals_away() {
    let plain = POINTS.replace("nx", "a").replace("ny", "b").replace("nz", "c");
    let files = Files::new(&[("a.ply", POINTS), ("b.ply", &plain)]);
    for order in [["a", "b"], ["b", "a"]] {
        let lines: String = order.iter().map(|name| format!("bmesh {name}.ply 0 0 0 0 0 0 1\n")).collect();
        let document = read(&lines, &files).expect("points");
        assert!(matches!(&document.points.positions, Positions::F32(points) if points.len() == 4));
        assert!(document.points.normals.is_empty());
    }
}

#[test]
fn invalid_lists_are_explained() {
    let broken = TRIANGLE.replace("3 0 1 2", "3 0 1 3");
    let files = Files::new(&[("one.ply", TRIANGLE), ("broken.ply", &broken), ("one.xyy", "")]);
    let needs = "\"bmesh\" needs a file, three numbers of a translation and four numbers of a quaternion";
    let none = "the list names no scans: each line is \"bmesh FILE\", a translation and a quaternion";
    let cases = [
        ("", none.to_owned()),
        ("bmeshes one.ply 0 0 0 0 0 0 1\n", none.to_owned()),
        ("bmesh one.ply 0 0 0 0 0 0 0\n", "1: the quaternion has length 0".into()),
        ("\nbmesh one.ply 0 0 0 0 x 0 1\n", format!("2: {needs}")),
        ("bmesh one.ply 0 0 0\n", format!("1: {needs}")),
        ("bmesh 0 0 0 0 0 0 1\n", format!("1: {needs}")),
        ("bmesh one.ply 0 0 nan 0 0 0 1\n", format!("1: {needs}")),
        ("bmesh", format!("1: {needs}")),
        ("bmesh none.ply 0 0 0 0 0 0 1\n", "1: none.ply: the file does not exist".into()),
        (
            "bmesh one.xyy 0 0 0 0 0 0 1\n",
            "1: one.xyy: the extension is unknown; rename the file after its format".into(),
        ),
        (
            "bmesh broken.ply 0 0 0 0 0 0 1\n",
            "1: broken.ply:13: face 0, corner 2: vertex 3 does not exist (the mesh has 3)".into(),
        ),
    ];
    for (list, message) in cases {
        assert_eq!(read(list, &files).expect_err("an invalid list").to_string(), message, "{list}");
    }
}

#[test]
fn quaternions_of_any_length_turn_alike() {
    let files = Files::new(&[("one.ply", TRIANGLE)]);
    let placement = |scale: f64| {
        let list = format!("bmesh one.ply 1 2 3 {} {} 0 {}", 0.5 * scale, -0.25 * scale, scale);
        read(&list, &files).expect("a scene").placements[0].transform
    };
    for scale in [1e-300, 1e300, -1.0] {
        for (row, expected) in placement(scale).iter().zip(placement(1.0)) {
            assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15));
        }
    }
}

proptest! {
    #[test]
    fn changed_lists_never_panic(changes in proptest::collection::vec(Mutation::strategy(), 1..5)) {
        let files = Files::new(&[("one.ply", TRIANGLE), ("points.ply", POINTS)]);
        let mut list = b"bmesh one.ply 0 0 0 0 0 0 1\nbmesh points.ply 1 2 3 0.5 0 0 1\nbmesh one.ply 1 0 0 0 0 1 1\n".to_vec();
        changes.iter().for_each(|change| change.apply(&mut list));
        if let Ok(document) = read_scan_list(&list, &files, &ReadOptions::default(), crate::read) {
            assert_valid(&document);
        }
    }
}
