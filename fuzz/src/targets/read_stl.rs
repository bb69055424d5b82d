//! Bytes that claim to be an STL file.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected::new(Format::Stl));
}

/// Returns a binary file of triangles, whose header holds a count.
fn binary(head: &[u8], count: u32, facets: &[[f32; 9]]) -> Vec<u8> {
    let mut file = head.to_vec();
    file.resize(80, b' ');
    file.extend(count.to_le_bytes());
    for facet in facets {
        file.extend([0; 12]);
        facet.iter().for_each(|x| file.extend(x.to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

/// Makes text and binary files, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let solid = format!("solid a\n{facet}endsolid a\n");
    let texts = [
        solid.clone(),
        solid.to_uppercase(),
        format!("\u{feff}  \n{solid}"),
        format!("# a comment\n{solid}{solid}"),
        solid.replace('\n', "\r"),
        solid.replace("0 1 0", "nan inf 1e999"),
        solid.replace("endloop", "vertex 1 1 0\nendloop"),
        "solid\nendsolid\n".into(),
        "solid".into(),
    ];
    let mut seeds: Vec<Vec<u8>> = texts.iter().map(|text| text.as_bytes().to_vec()).collect();
    let triangle = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let other = [0.0, 0.0, -0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    seeds.push(binary(b"binary", 2, &[triangle, other]));
    seeds.push(binary(b"solid binary", 1, &[triangle]));
    seeds.push([binary(b"solid", 1, &[triangle]), vec![0]].concat());
    seeds.push(binary(b"low count", 1, &[triangle, other]));
    seeds.push(binary(b"high count", u32::MAX, &[triangle, other]));
    seeds.push(binary(b"COLOR=\x01\x02\x03\xff", 1, &[triangle]));
    seeds.push(binary(b"no numbers", 4, &[[f32::NAN; 9], [f32::INFINITY; 9], [-0.0; 9], [f32::MAX; 9]]));
    seeds
}
