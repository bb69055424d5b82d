//! Bytes that claim to be a list of scans, beside a few scans.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let points = format!("{ply}end_header\n0 0 0\n1 0 0\n0 1 0\n");
    let mesh = format!(
        "{ply}element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    );
    let files = Files::new(&[
        ("a.ply", mesh.as_bytes()),
        ("b.ply", points.as_bytes()),
        ("c.obj", b"mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nl 1 2\n"),
        ("d/e.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("m.mtl", b"newmtl m\nKd 1 0 0\nmap_Kd a.png\n"),
        ("f.conf", b"bmesh a.ply 0 0 0 0 0 0 1\n"),
    ]);
    check(bytes, &files, Expected::new(Format::ScanList));
}

/// Makes lists of all scans, of one scan again and again, and of none.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let again: String = (0..30).map(|k| format!("bmesh ./{}a.ply {k} 0 0 0 0 0 1\n", "./".repeat(k % 5))).collect();
    let points = "bmesh b.ply 0 0 0 0 0 0 1\n".repeat(3);
    [
        "camera 0 0 0 0 0 0 1\nbmesh a.ply 0 0 0 0 0 0 1\nbmesh b.ply 1 2 3 0.5 0 0 0.5 # b\nbmesh d\\e.obj 0 0 0 0 0 0 -2\n",
        "\u{feff}bmesh c.obj 1e308 1e308 0 1e-300 0 0 1e300\r\nbmesh b.ply 0 0 0 0 0 0 1\r\n",
        &again,
        &points,
        "bmesh f.conf 0 0 0 0 0 0 1\n",
        "bmesh ../a.ply 0 0 0 0 0 0 1\n",
        "bmesh a.ply 0 0 0 0 0 0 0\n",
        "",
    ]
    .iter()
    .map(|text| text.as_bytes().to_vec())
    .collect()
}
