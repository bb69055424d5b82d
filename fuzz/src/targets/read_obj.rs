//! Bytes that claim to be an OBJ file, beside a material library.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let library = b"newmtl red\nKd 1 0 0\nd 0.5\nmap_Kd -s 1 1 1 a b.png\nnewmtl green\nKd 0 1 0\n";
    let files = Files::new(&[("m.mtl", library), ("a b.png", b"\x89PNG")]);
    check(bytes, &files, Expected { is_exact: true, ..Expected::new(Format::Obj) });
}

/// Makes files of all kinds of lines, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let wide = format!("{corners}f{}\n", " 1 2 3".repeat(100));
    let texts = [
        format!(
            "# a comment\nmtllib m.mtl\no box\n{corners}vt 0 0\nvt 1 0 0\nvt 1 1\nvn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/3/1\n\
             g other\nusemtl green\ns 1\nf -4/-3 -2/-2 -1/-1\n"
        ),
        format!("{corners}f 1// 2// 3//\nf 1/1/ 2/1/ 3/1/\nf 1//1 2//2 3//9\nf 1/7 2/8 3/9\n"),
        format!("{corners}f 1 2 \\\n3 4\nl 1 2 3 1\nl -1 -2\np 1 2\n"),
        "v 1 2 3 0.5 0.25 1\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nf 1 2 3\nv 5 5 5\nf -1 -2 -3\n".into(),
        wide,
        format!("\u{feff}{}", corners.replace('\n', "\r\n") + "f 1 2 3\r\n"),
        format!("{corners}f 1 2 5\n"),
        format!("{corners}f 0 1 2\nf 1 2\nf\n"),
        "v nan inf -inf\nv 1e999 -1e999 1e-999\nv 0 0 0\nf 1 2 3\n".into(),
        "f 99999999999999999999 -99999999999999999999 4294967297\n".into(),
        "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\nvp 1 2\n".into(),
    ];
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}
