//! Bytes that claim to be an SVG file.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected { is_rounded: true, ..Expected::new(Format::Svg) });
}

/// Makes drawings of all shapes, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let drawing = |body: &str| {
        let head = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
        format!("<?xml version=\"1.0\"?>\n{head} width=\"10mm\" height=\"10mm\" viewBox=\"0 0 100 100\">{body}</svg>")
    };
    let deep = "<g transform=\"scale(2)\">".repeat(60) + "<path d=\"M0 0 1 1\"/>" + &"</g>".repeat(60);
    let entities = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\"><!ENTITY c \"&b;&b;&b;\">]>";
    let texts = [
        drawing(
            "<path d=\"M10 10 L20 10 h5 v5 H0 V9 C1 2 3 4 5 6 s1 2 3 4 Q1 2 3 4 t5 6 A5 5 30 0 1 9 9z m1,1l2-3.5.5\"/>",
        ),
        drawing(
            "<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\" rx=\"1\"/><circle r=\"5\"/><ellipse rx=\"1\" ry=\"2\"/>",
        ),
        drawing(
            "<line x1=\"0\" y1=\"0\" x2=\"1\" y2=\"1\"/><polyline points=\"0,0 1,1 2 0\"/><polygon points=\"0 0 1 0 1 1\"/>",
        ),
        drawing(
            "<defs><g id=\"a\"><rect width=\"1\" height=\"1\"/></g></defs><use href=\"#a\" x=\"5\"/><use xlink:href=\"#a\"/>",
        ),
        drawing("<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/><use href=\"#a\"/></g>"),
        drawing("<g transform=\"translate(1 2) rotate(45) skewX(10) matrix(1 0 0 1 5 6)\"><path d=\"M0 0h1\"/></g>"),
        drawing(&deep),
        drawing("<path d=\"M0 0 A1e308 1e-308 0 0 0 1 1 L nan 1e999\"/><path d=\"M\"/><path d=\"z\"/>"),
        format!("{entities}{}", drawing("&c;<path d=\"M0 0 1 1\"/>")),
        "<svg><path d=\"M0 0 1 1\"".into(),
    ];
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}
