//! Bytes that claim to be a 3MF package.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Memory that the reader's budget gives to each file.
const LEAST_MEMORY: u64 = 24 << 20;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected { least_memory: LEAST_MEMORY, ..Expected::new(Format::ThreeMf) });
}

/// The checksum of zip archives.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32| if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 };
    !bytes.iter().fold(u32::MAX, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), |sum, _| step(sum)))
}

/// Returns an archive of files that are stored without compression.
fn archive(files: &[(&str, &str)]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    let long = |value: usize| (value as u32).to_le_bytes();
    for (name, text) in files {
        let start = bytes.len();
        let sizes = [checksum(text.as_bytes()).to_le_bytes(), long(text.len()), long(text.len())].concat();
        let common = [&[20, 0, 0, 0, 0, 0, 0, 0, 0x21, 0][..], &sizes, &[name.len() as u8, 0, 0, 0]].concat();
        bytes.extend([b"PK\x03\x04", &common[..], name.as_bytes(), text.as_bytes()].concat());
        let place = [&[0; 10][..], &long(start)].concat();
        directory.extend([b"PK\x01\x02\x14\0", &common[..], &place, name.as_bytes()].concat());
    }
    let count = files.len() as u8;
    let end = [&[0, 0, 0, 0, count, 0, count, 0][..], &long(directory.len()), &long(bytes.len()), &[0, 0]].concat();
    [&bytes[..], &directory, b"PK\x05\x06", &end].concat()
}

const TYPES: &str = "<?xml version=\"1.0\"?><Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
    <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
    <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>";
const RELATIONS: &str = "<?xml version=\"1.0\"?>\
    <Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Id=\"r\" \
    Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"/3D/3dmodel.model\"/></Relationships>";
const TRIANGLE: &str = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>\
    <vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh>";

fn package(resources: &str, build: &str) -> Vec<u8> {
    let model = format!(
        "<?xml version=\"1.0\"?><model unit=\"millimeter\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>{resources}</resources>\
         <build>{build}</build></model>"
    );
    archive(&[("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONS), ("3D/3dmodel.model", &model)])
}

/// Makes packages, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let object = |id: u32, inner: &str| format!("<object id=\"{id}\" name=\"o{id}\" type=\"model\">{inner}</object>");
    let component = |id: u32| format!("<component objectid=\"{id}\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>");
    let components = |inner: &str| format!("<components>{inner}</components>");
    let triangle = object(1, TRIANGLE);
    let item = "<item objectid=\"1\"/>";
    // Each object has the one before it twice.
    let doubled: String = (2..24).map(|id| object(id, &components(&component(id - 1).repeat(2)))).collect();
    let coloured = "<basematerials id=\"9\"><base name=\"red\" displaycolor=\"#FF0000\"/></basematerials>".to_owned()
        + &object(1, TRIANGLE).replace("type=", "pid=\"9\" pindex=\"0\" type=");
    let whole = package(&triangle, item);
    let mut cut = whole.clone();
    cut.truncate(whole.len() / 2);
    vec![
        whole,
        package(&coloured, "<item objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 1 2 3\"/>"),
        package(&(triangle.clone() + &object(2, &components(&component(1)))), "<item objectid=\"2\"/>"),
        package(&(triangle.clone() + &doubled), "<item objectid=\"23\"/>"),
        package(&object(1, &components(&component(1))), item),
        package(&triangle.replace("v3=\"2\"", "v3=\"4000000000\""), item),
        package(&triangle.replace("x=\"1\"", "x=\"nan\""), item),
        package(&"<a>".repeat(100), item),
        cut,
        archive(&[]),
        archive(&[("3D/3dmodel.model", "<model/>"), ("../../outside", "")]),
    ]
}
