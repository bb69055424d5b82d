//! Bytes that claim to be a DXF file.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected::new(Format::Dxf));
}

/// Returns the lines of a file with these pairs of code and value, separated by blanks, in its section of entities.
fn drawing(blocks: &str, entities: &str) -> String {
    let section = |name: &str, pairs: &str| format!("0 SECTION 2 {name} {pairs} 0 ENDSEC ");
    let all = section("HEADER", "9 $INSUNITS 70 4") + &section("BLOCKS", blocks) + &section("ENTITIES", entities);
    let words: Vec<&str> = all.split_whitespace().chain(["0", "EOF"]).collect();
    words.join("\n") + "\n"
}

/// Makes drawings of all entities, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let block = |name: &str, entities: &str| format!("0 BLOCK 2 {name} 10 0 20 0 {entities} 0 ENDBLK ");
    let texts = [
        drawing("", "0 LINE 8 0 10 0 20 0 11 1 21 1 0 CIRCLE 10 0 20 0 40 2 0 ARC 10 0 20 0 40 1 50 0 51 90"),
        drawing("", "0 LWPOLYLINE 90 3 70 1 10 0 20 0 42 0.5 10 1 20 0 10 1 20 1 0 POINT 10 1 20 2 30 3"),
        drawing("", "0 POLYLINE 66 1 70 0 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 1 20 1 0 SEQEND"),
        drawing("", "0 3DFACE 10 0 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0 13 0 23 1 33 0"),
        drawing(
            "",
            "0 ELLIPSE 10 0 20 0 11 2 21 0 40 0.5 41 0 42 6.28 0 SPLINE 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 \
                 40 1 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 3 20 2 10 4 20 0",
        ),
        drawing(
            "",
            "0 POLYLINE 70 64 71 3 72 1 0 VERTEX 70 192 10 0 20 0 0 VERTEX 70 192 10 1 20 0 0 VERTEX 70 192 10 0 \
                 20 1 0 VERTEX 70 128 71 1 72 2 73 3 0 SEQEND",
        ),
        drawing(&block("a", "0 LINE 10 0 20 0 11 1 21 1"), "0 INSERT 2 a 10 5 20 5 41 2 50 90 70 3 71 2 44 1 45 1"),
        drawing(&(block("a", "0 INSERT 2 b 0 INSERT 2 b") + &block("b", "0 INSERT 2 a 0 INSERT 2 a")), "0 INSERT 2 a"),
        drawing(
            "",
            "0 LINE 10 nan 20 1e999 11 x 21 - 0 CIRCLE 40 -1 0 LWPOLYLINE 90 4000000000 0 SPLINE 71 4000000000",
        ),
        drawing("", "0 INSERT 2 none 70 32767 71 32767"),
        "999\ncomment\n0\nSECTION\n".into(),
    ];
    let mut seeds: Vec<Vec<u8>> = texts.iter().map(|text| text.as_bytes().to_vec()).collect();
    seeds.push(texts[0].replace('\n', "\r\n").into_bytes());
    seeds.push(b"AutoCAD Binary DXF\r\n\x1a\0\0SECTION\0\x02ENTITIES\0\0ENDSEC\0\0EOF\0".to_vec());
    seeds
}
