//! Bytes that claim to be a PLY file.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let expected = Expected { is_exact: true, ..Expected::new(Format::Ply) };
    check(bytes, &Files::default(), expected);
}

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
const LIST: &str = "property list uchar int vertex_indices\n";
const POINTS: &str = "0 0 0\n1 0 0\n0 1 0\n";

/// Makes files of text and binary, and hostile headers.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let rich = format!(
        "comment TextureFile a.png\nelement vertex 3\n{XYZ}property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty short quality\n\
         element face 2\n{LIST}property list uchar float texcoord\nproperty int texnumber\nproperty double area\n\
         element edge 1\nproperty int vertex1\n"
    );
    let rich_rows = "0 0 0 0 0 1 1 2 3 4 5\n1 0 0 0 0 1 1 2 3 4 5\n0 1 0 0 0 1 1 2 3 4 5\n\
        3 0 1 2 6 0 0 1 0 0 1 0 0.5\n3 2 1 0 0 0 1\n7\n";
    let strips = format!("element vertex 3\n{XYZ}element tristrips 1\nproperty list int int vertex_indices\n");
    let range = format!(
        "obj_info num_cols 2\nobj_info num_rows 2\nelement vertex 3\n{XYZ}element range_grid 4\n\
         property list uchar int vertex_indices\n"
    );
    let twice = format!("element face 1\n{LIST}element vertex 2\n{XYZ}property char a\nelement vertex 1\n{XYZ}");
    let text = |lines: &str, rows: &str| format!("ply\nformat ascii 1.0\n{lines}end_header\n{rows}").into_bytes();
    let mut seeds = vec![
        text(&rich, rich_rows),
        text(&strips, &format!("{POINTS}5 0 1 2 -1 2\n")),
        text(&range, &format!("{POINTS}1 0\n1 1\n1 2\n0\n")),
        text(&twice, "3 0 1 2\n0 0 0 1\n1 0 0 1\n0 1 0\n"),
        text(&format!("element vertex 3\n{XYZ}"), POINTS),
        text(&format!("element vertex 3\n{XYZ}"), POINTS).iter().map(|&b| if b == b'\n' { b'\r' } else { b }).collect(),
        text("element vertex 1\nproperty double x\nproperty double y\nproperty double z\n", "1e999 -nan(ind) 0.1"),
        text("element nothing 4000000000\n", ""),
        text(&format!("element vertex 4000000000\n{XYZ}element face 4000000000\n{LIST}"), POINTS),
    ];
    for (format, is_big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let word = |value: u32| if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
        let mut face = vec![3];
        (0..3).for_each(|vertex| face.extend(word(vertex)));
        let points: Vec<u8> =
            [0, 0, 0, 1, 0, 0, 0, 1, 0_u8].iter().flat_map(|&x| word(f32::from(x).to_bits())).collect();
        for (count, lines) in [(1, LIST), (u32::MAX, LIST), (1, "property list uint double vertex_indices\n")] {
            let head =
                format!("ply\nformat {format} 1.0\nelement vertex 3\n{XYZ}element face {count}\n{lines}end_header\n");
            seeds.push([head.as_bytes(), &points, &face, &[0xff; 9]].concat());
        }
        // Lists of bytes whose texture coordinates are missing.
        let lines = "property list ushort uchar vertex_index\nproperty list uchar uchar texcoord\n";
        let head = format!("ply\nformat {format} 1.0\nelement vertex 3\n{XYZ}element face 1\n{lines}end_header\n");
        seeds.push([head.as_bytes(), &points, &[2, 2], &[1; 514], &[0]].concat());
    }
    seeds
}
