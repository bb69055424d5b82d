//! Bytes that meshoptimizer 1.3 encoded, and what its decoder makes of them.

use super::gltf_test_files::*;
use super::meshopt::{Codec, decode_view};
use crate::json_tape::Tape;

fn bytes_from_hex(digits: &str) -> Vec<u8> {
    (0..digits.len() / 2).map(|k| u8::from_str_radix(&digits[2 * k..2 * k + 2], 16).expect("hexadecimal")).collect()
}

fn decoded(digits: &str, json: &str) -> Option<Vec<u8>> {
    decoded_bytes(&bytes_from_hex(digits), json)
}

fn decoded_bytes(bytes: &[u8], json: &str) -> Option<Vec<u8>> {
    let Ok(tape) = Tape::parse(json.as_bytes()) else { panic!("JSON") };
    let codec = Codec::from_json(tape.root()).expect("known");
    decode_view(bytes, &codec).expect("small")
}

/// The bytes that were encoded: partly smooth, partly random.
fn source(count: usize, stride: usize) -> Vec<u8> {
    let mut state = 1_u32;
    let mut now = vec![0_u8; stride];
    let mut made = Vec::new();
    for k in 0..count {
        for (b, byte) in now.iter_mut().enumerate() {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let random = (state >> 24) as u8;
            if b % 4 == 3 || k % 16 == 0 {
                *byte = random;
            } else if b % 4 == 1 {
                *byte = byte.wrapping_add(random % 3);
            } else if b % 4 == 2 {
                *byte = byte.wrapping_add(random % 29);
            }
        }
        made.extend_from_slice(&now);
    }
    made
}

const V0: &str = "a014c0000000a6c0000000bf1a0242402422224440f44222222220442210ef0c0000370404041f000c000818143402041a2a0234220c10b4040c22\
22162612120016340e241026fffb0000761814361c100c1f008f384d5659b53a33ecdf39e18f2af1c36425411a01a28ca8930bd5dae24446ffff00005f6bfe69f0519\
c3514c00000000fc0000000eb160240444422040422ec2202087a04fac20000e304041f0004240c2a1412100036140600181e36f53214060a0028280c10120a08181e\
32ebcf0000b2142812101f00daac47edec4bd36fb6d1a1a88853dd8f4dc04a0988fe5bb15e0bf7777d38bdffff000045b5a72a0f04138c00000000000000000000000\
00000000000000000000000003c5e81b40c5ec68e";

const V1: &str = "a1f4f4140100a60100bf0a0242402422224440f442222222204422104f003702040404000c000818143402041a2a0234220c10b4040c2222162612\
120016340e241026761814361c10020c008f384d5659b53a33ecdf39e18f2af1c36425411a01a28ca8930bd5dae244465f6bfe69f0519c351401000f0100eb1602404\
44422040422ec2202087a04fac20000e304040004240c2a1412100036140600181e36f53214060a0028280c10120a08181e32b20202142800121000daac47edec4bd3\
6fb6d1a1a88853dd8f4dc04a0988fe5bb15e0bf7777d38bd45b5a72a0f04138c00000000000000000000000000003c5e81b40c5ec68e0000";

#[test]
fn decodes_attributes() {
    let json = r#"{"mode":"ATTRIBUTES","count":40,"byteStride":8}"#;
    assert_eq!(decoded(V0, json), Some(source(40, 8)));
    assert_eq!(decoded(V1, json), Some(source(40, 8)));
}

const TRIANGLES: &str = "e1fe0dfe13fe12fe12fe12fe0dfe03fe02fe02fe02ff0dff03ff02ff02ff02ff0dff03ff02ff02ff02fe1fff0f0ef304f202f202f202af04af0\
4af02af02af02af090eaf090eaf0b0eaf0b0eaf0b0eaf090eaf090eaf0b0eaf0b0eaf0b0ef1331cffa601c801c801007687566778a9866589689801690000";

const CORNERS: [u32; 129] = [
    0, 1, 7, 0, 7, 6, 2, 8, 1, 1, 8, 7, 3, 9, 2, 2, 9, 8, 4, 10, 3, 3, 10, 9, 5, 11, 4, 4, 11, 10, 6, 7, 13, 6, 13, 12,
    7, 8, 14, 7, 14, 13, 8, 9, 15, 8, 15, 14, 9, 10, 16, 9, 16, 15, 10, 11, 17, 10, 17, 16, 12, 13, 19, 12, 19, 18, 13,
    14, 20, 13, 20, 19, 14, 15, 21, 14, 21, 20, 15, 16, 22, 15, 22, 21, 16, 17, 23, 16, 23, 22, 18, 19, 25, 18, 25, 24,
    19, 20, 26, 19, 26, 25, 20, 21, 27, 20, 27, 26, 21, 22, 28, 21, 28, 27, 22, 23, 29, 22, 29, 28, 11, 3, 29, 29, 3,
    17, 100, 200, 300,
];

#[test]
fn decodes_indices() {
    let triangles = decoded(TRIANGLES, r#"{"mode":"TRIANGLES","count":129,"byteStride":4}"#).expect("valid");
    assert_eq!(triangles, CORNERS.iter().flat_map(|corner| corner.to_le_bytes()).collect::<Vec<u8>>());
    let sequence =
        decoded("d100040004000400910303108bc3cdb204040400000000", r#"{"mode":"INDICES","count":13,"byteStride":4}"#);
    let numbers = [0, 1, 1, 2, 2, 3, 3, 100, 99, 7, 4_000_000_000_u32, 8, 9];
    assert_eq!(sequence, Some(numbers.iter().flat_map(|number| number.to_le_bytes()).collect()));
}

#[test]
fn undoes_filters() {
    let json = |count: u32, stride: u32, filter: &str| {
        format!(r#"{{"mode":"ATTRIBUTES","count":{count},"byteStride":{stride},"filter":"{filter}"}}"#)
    };
    let octahedral = decoded(
        "a0013f000000fe4546013f000000fe5ca600000000000000000000000000000000000000000000000000000000000000007f00",
        &json(4, 4, "OCTAHEDRAL"),
    );
    let expected: [i8; 16] = [0, 0, 127, 0, 0, 0, -127, 0, 76, -60, -82, 0, 127, 0, 0, 0];
    assert_eq!(octahedral, Some(expected.map(|x| x as u8).to_vec()));
    let quaternions = decoded(
        "a0013f000000b2f342013f0000000b0804013f000000b18641013d0000000a04013f000000b26f41013d0000000b0e013a0000000500000000000000\
         000000000000000000000000000000000000000000000000ff07",
        &json(4, 8, "QUATERNION"),
    );
    let expected: [i16; 16] =
        [0, 0, 0, 32767, 16399, -16378, 16378, -16378, 3271, 22943, -3271, 22932, 19661, 0, 26213, 0];
    assert_eq!(quaternions, Some(expected.iter().flat_map(|x| x.to_le_bytes()).collect()));
    let exponential = decoded(
        "a001300000007501300000001f000130000000130130000000700130000000ba012000000001300000002e0130000000ff0130000000bb0110000000\
         0130000000170000000000000000000000000000000000000000003000f300dcfff4803e00fc",
        &json(2, 12, "EXPONENTIAL"),
    );
    assert_eq!(exponential, Some(floats(&[1.5, -2.25, 1000.0, 0.001_000_046_7, 29_999_104.0, -0.125])));
    let colours = decoded(
        "a0013f000000e0cccd013f000000bd656601300000001e013f000000fdcc4b00000000000000000000000000000000000000000000000000000000\
         905ff1ff",
        &json(4, 4, "COLOR"),
    );
    assert_eq!(colours, Some(vec![254, 129, 64, 255, 0, 0, 0, 0, 51, 102, 153, 204, 255, 255, 255, 128]));
}

#[test]
fn refuses_damaged_bytes() {
    for (digits, json) in [
        (V0, r#"{"mode":"ATTRIBUTES","count":40,"byteStride":8}"#),
        (V1, r#"{"mode":"ATTRIBUTES","count":40,"byteStride":8}"#),
        (TRIANGLES, r#"{"mode":"TRIANGLES","count":129,"byteStride":4}"#),
    ] {
        let bytes = bytes_from_hex(digits);
        assert!(decoded_bytes(&bytes[1..], json).is_none());
        for length in 0..bytes.len() {
            let _ = decoded_bytes(&bytes[..length], json);
        }
        for place in 0..bytes.len() {
            for bit in 0..8 {
                let mut changed = bytes.clone();
                changed[place] ^= 1 << bit;
                let _ = decoded_bytes(&changed, json);
            }
        }
    }
}

#[test]
fn reads_a_compressed_mesh() {
    let bytes = bytes_from_hex(TRIANGLES);
    let mut binary = floats(&(0..903).map(|k| k as f32).collect::<Vec<_>>());
    let start = binary.len();
    binary.extend_from_slice(&bytes);
    let file = |count: u64| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"extensionsRequired":["EXT_meshopt_compression"],
            "buffers":[{{"byteLength":{}}},{{"byteLength":999}}],
            "bufferViews":[{{"buffer":0,"byteLength":{start}}},{{"buffer":1,"byteLength":516,"extensions":{{"EXT_meshopt_compression":
                {{"buffer":0,"byteOffset":{start},"byteLength":{},"byteStride":4,"count":{count},"mode":"TRIANGLES"}}}}}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":301,"type":"VEC3"}},
                {{"bufferView":1,"componentType":5125,"count":129,"type":"SCALAR"}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}]}}"#,
            binary.len(),
            bytes.len()
        )
    };
    let mesh = &read(&glb(&file(129), &binary)).expect("valid").meshes[0];
    assert_eq!(mesh.corners, CORNERS);
    assert_eq!(read(&glb(&file(4_000_000_000), &binary)).expect_err("too many").kind, crate::ReadErrorKind::TooLarge);
    assert!(error_text(&glb(&file(132), &binary)).contains("compressed by meshopt, and its bytes are not valid"));
}
