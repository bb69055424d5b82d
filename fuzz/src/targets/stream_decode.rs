//! Bytes that claim to be a stream: an error, or a net, whole and in pieces alike, or a scene. Checksums are not
//! put right here: libFuzzer finds its way past them (`-use_value_profile=1`), and
//! tests/net/stream.rs forges them.

use gusset::Job;
use gusset::net::scene::{decode_scene_within, encode_scene};
use gusset::net::stream::{StreamDecoder, StreamMode, StreamOptions, decode, encode};

/// Nodes; what claims to have more is refused in pieces.
const LIMIT: u64 = 1 << 22;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    if let Ok(scene) = decode_scene_within(bytes, LIMIT, &Job::default()) {
        encode_scene(&scene, &StreamOptions::new(StreamMode::Lossless), &Job::default())
            .expect("a scene can be encoded");
    }
    let whole = decode(bytes, &Job::default());
    let mut decoder = StreamDecoder::new(LIMIT);
    let pushed = bytes.chunks(61).try_for_each(|piece| decoder.decode_next_bytes(piece).map(|_| ()));
    let pieces = pushed.and_then(|()| decoder.finish());
    let small = |net: &gusset::net::Net<'_>| net.shape().node_count() as u64 <= LIMIT;
    assert_eq!(whole.as_ref().is_ok_and(small), pieces.is_ok());
    if let Ok(net) = whole {
        let again =
            encode(&net, &StreamOptions::new(StreamMode::Lossless), &Job::default()).expect("a net can be encoded");
        decode(&again, &Job::default()).expect("what was encoded can be decoded");
    }
}
