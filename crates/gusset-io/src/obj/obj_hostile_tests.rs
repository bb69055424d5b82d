//! Files made to break the reader.

use super::{read_obj, write_obj};
use crate::document::Document;
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{NoResources, Target};
use proptest::prelude::*;
use std::time::{Duration, Instant};

fn read_and_write(bytes: &[u8]) {
    let Ok(document) = read_obj(bytes, &NoResources, &ReadOptions::default()) else { return };
    document.check().expect("all indices are valid");
    let mut main = Vec::new();
    let mut target = Target { main_file: &mut main, stem: "x", beside: &mut |_, _| Ok(()), resources: &NoResources };
    write_obj(&document, &mut target, &WriteOptions::default()).expect("memory is written");
    let back = read_obj(&main, &NoResources, &ReadOptions::default()).expect("the written file is valid");
    let faces = |document: &Document| document.meshes.iter().map(crate::mesh::Mesh::face_count).sum::<usize>();
    assert_eq!(faces(&back), faces(&document));
    assert_eq!(back.curves.closed, document.curves.closed);
}

const VALID: &str = "mtllib a.mtl\no part\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nv 1 1 1e3\nvt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 1 0 0\n\
                     usemtl red\nf 1/1/1 2/2/2 3/1/-1\nf -1 -2 \\\n -3\nusemtl blue\nf 1//1 2//1 4//2 3//1\nl 1 2 3 1\nl 3/1 4/2\np 1 -1\n\
                     cstype bezier\ncurv 0 1 1 2\nend\ng group\ns 1\n# end\n";

/// A change of a file.
#[derive(Clone, Debug)]
enum Mutation {
    Flip(usize, u8),
    Cut(usize, usize),
    Repeat(usize, usize),
    Insert(usize, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let words = [
        "-",
        "/",
        "//",
        " ",
        "\n",
        "\\\n",
        "\\",
        "0",
        "99999999999",
        "-9",
        "nan",
        "#",
        "f ",
        "v ",
        "l 1 ",
        "\0",
        "\u{ff}",
        "usemtl\n",
        "p\n",
        "\r",
    ];
    let place = 0..400_usize;
    prop_oneof![
        (place.clone(), any::<u8>()).prop_map(|(place, bits)| Mutation::Flip(place, bits)),
        (place.clone(), 1..40_usize).prop_map(|(place, length)| Mutation::Cut(place, length)),
        (place.clone(), 1..40_usize).prop_map(|(place, length)| Mutation::Repeat(place, length)),
        (place, proptest::sample::select(words.to_vec())).prop_map(|(place, word)| Mutation::Insert(place, word)),
    ]
}

fn mutated(bytes: &[u8], mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for mutation in mutations {
        let length = bytes.len();
        let range = |place: usize, count: usize| place % (length + 1)..(place % (length + 1) + count).min(length);
        match *mutation {
            Mutation::Flip(place, bits) => {
                if let Some(byte) = bytes.get_mut(place) {
                    *byte ^= bits;
                }
            }
            Mutation::Cut(place, count) => drop(bytes.drain(range(place, count))),
            Mutation::Repeat(place, count) => bytes.extend_from_within(range(place, count)),
            Mutation::Insert(place, word) => {
                let place = place % (length + 1);
                bytes.splice(place..place, word.bytes());
            }
        }
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]
    #[test]
    fn mutations_never_panic(mutations in proptest::collection::vec(mutation(), 1..8)) {
        read_and_write(&mutated(VALID.as_bytes(), &mutations));
    }

    #[test]
    fn any_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        read_and_write(&bytes);
    }
}

#[test]
fn the_unchanged_file_is_valid() {
    let document = read_obj(VALID.as_bytes(), &NoResources, &ReadOptions::default()).expect("the file is valid");
    assert_eq!((document.meshes[0].face_count(), document.materials.len()), (3, 2));
    read_and_write(VALID.as_bytes());
}

#[test]
fn hostile_files_take_linear_time() {
    let repeat = |text: &str| text.repeat((1 << 19) / text.len());
    let files = [
        repeat("\\"),
        repeat("\\ "),
        format!("v 0 0 0 \\{}x", " ".repeat(1 << 19)),
        format!("v {}", repeat("\\\n")),
        format!("v {}", repeat("1 ")),
        format!("f {}", repeat("1/1/1 ")),
        format!("f 1 {}", repeat("1")),
        format!("v 0 0 {}", repeat("9")),
        format!("v 0 0 0.{}", repeat("0")),
        format!("v 0 0 0\n{}", repeat("f -1 -1 -1\n")),
        format!("v 0 0 0\nvn nan nan nan\n{}f 1//1 1//1 1\n", repeat("f 1//1 1//1 1//1\n")),
        format!("v 0 0 0\n{}f 9 9 9\n", repeat("f 1 1 1\n")),
        repeat("mtllib a.mtl b.mtl\n"),
        format!("mtllib {}\n", repeat("a ")),
        repeat("usemtl a\n"),
        repeat("o\ng\n"),
        repeat("# \\\n"),
        repeat("\r"),
        repeat("unknown\n"),
        repeat("l 1\np\n"),
        repeat("\0"),
    ];
    for bytes in files {
        let start = Instant::now();
        let _ = read_obj(bytes.as_bytes(), &NoResources, &ReadOptions::default());
        assert!(start.elapsed() < Duration::from_secs(5), "{:?}: {:?}", &bytes[..20], start.elapsed());
    }
}

#[test]
fn distinct_libraries_are_limited() {
    let text: String = (0..100_000).map(|k| format!("mtllib {k}.mtl\n")).collect();
    let document = read_obj(text.as_bytes(), &NoResources, &ReadOptions::default()).expect("the file is valid");
    assert!(document.notes.len() < 300);
    assert!(document.notes.iter().any(|note| note.text.contains("not read")));
}
