//! Bytes that claim to be a glTF file of JSON or binary, beside a buffer.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Memory that the reader's budget gives to each file.
const LEAST_MEMORY: u64 = 24 << 20;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let files = Files::new(&[("data.bin", &buffer()), ("a.png", b"\x89PNG")]);
    check(bytes, &files, Expected { least_memory: LEAST_MEMORY, ..Expected::new(Format::Glb) });
}

/// Positions of 4 points, then 6 indices of 2 bytes.
fn buffer() -> Vec<u8> {
    let points = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0_u8];
    let mut bytes: Vec<u8> = points.iter().flat_map(|&x| f32::from(x).to_le_bytes()).collect();
    bytes.extend([0, 1, 2, 0, 2, 3_u16].iter().flat_map(|index| index.to_le_bytes()));
    bytes
}

/// Returns a file of two triangles with more fields at the end, whose buffer has fields too.
fn json(buffer: &str, primitive: &str, more: &str) -> String {
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\
         \"buffers\":[{{\"byteLength\":60{buffer}}}],\"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}},\
         {{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}}],\"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\
         \"count\":4,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}},{{\"bufferView\":1,\"componentType\":5123,\
         \"count\":6,\"type\":\"SCALAR\"}}],\"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1\
         {primitive}}}]}}]{more}}}"
    )
}

fn binary(json: &str, buffer: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = 12 + 8 + json.len() + 8 + buffer.len();
    let word = |value: usize| (value as u32).to_le_bytes();
    [b"glTF", &word(2)[..], &word(length), &word(json.len()), b"JSON", &json, &word(buffer.len()), b"BIN\0", buffer]
        .concat()
}

/// Makes files of JSON and binary, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let uri = ",\"uri\":\"data.bin\"";
    let node = ",\"nodes\":[{\"mesh\":0}]";
    let base = json(uri, "", node);
    let chain: Vec<String> = (1..60).map(|child| format!("{{\"children\":[{child}]}}")).collect();
    let many = vec!["{\"mesh\":0}"; 60].join(",");
    let extension = |name: &str| {
        json(uri, "", &format!("{node},\"extensionsRequired\":[\"{name}\"],\"extensionsUsed\":[\"{name}\"]"))
    };
    let material = ",\"materials\":[{\"name\":\"m\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.5,0,1],\
        \"baseColorTexture\":{\"index\":0}}}],\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"a.png\"}]";
    let texts = [
        base.clone(),
        json(",\"uri\":\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAA\"", "", node),
        json(uri, ",\"material\":0,\"mode\":4", &format!("{node}{material}")),
        json(uri, ",\"mode\":5", ",\"nodes\":[{\"mesh\":0,\"matrix\":[2,0,0,0,0,2,0,0,0,0,-2,0,1e6,0,0,1]}]"),
        json(uri, "", ",\"nodes\":[{\"mesh\":0,\"rotation\":[0,0,1,0],\"scale\":[1,2,3],\"translation\":[1e9,0,0]}]"),
        json(
            uri,
            ",\"extensions\":{\"FB_ngon_encoding\":{}}",
            &format!("{node},\"extensionsUsed\":[\"FB_ngon_encoding\"]"),
        ),
        base.replace(
            "\"count\":4",
            "\"count\":4,\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,\"componentType\":5123},\
            \"values\":{\"bufferView\":0}}",
        ),
        base.replace("5126", "5122").replace("\"count\":4", "\"count\":4,\"normalized\":true"),
        extension("KHR_mesh_quantization").replace("5126", "5120"),
        extension("EXT_meshopt_compression"),
        extension("KHR_draco_mesh_compression"),
        json(uri, "", &format!(",\"nodes\":[{},{{\"mesh\":0}}]", chain.join(","))),
        json(uri, "", ",\"nodes\":[{\"mesh\":0,\"children\":[1]},{\"children\":[0]}]"),
        json(uri, "", &format!(",\"nodes\":[{many}]")).replace("\"nodes\":[0]", "\"nodes\":[0,1,2,3,4,5,6,7,8,9,9,9]"),
        base.replace("\"count\":6", "\"count\":4000000000"),
        base.replace("\"byteLength\":48", "\"byteLength\":18446744073709551615,\"byteOffset\":1"),
        base.replace("\"bufferView\":0,\"componentType\"", "\"componentType\"")
            .replace("\"count\":4", "\"count\":100000000"),
        base.replace("{\"buffer\":0,\"byteLength\":48}", "{\"buffer\":0,\"byteLength\":48,\"byteStride\":4000000000}"),
        format!("{}{}", "[".repeat(900), "]".repeat(900)),
        "{}".into(),
    ];
    let mut seeds: Vec<Vec<u8>> = texts.iter().map(|text| text.as_bytes().to_vec()).collect();
    let whole = binary(&json("", "", node), &buffer());
    let mut long = whole.clone();
    long[8..12].fill(0xff);
    let mut cut = whole.clone();
    cut.truncate(whole.len() - 7);
    seeds.extend([whole, long, cut]);
    seeds
}
