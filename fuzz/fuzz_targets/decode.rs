//! Any bytes at all: decoding them gives a net or an error, the same whole and in pieces; a net can be encoded again.
#![no_main]

use gusset::Job;
use gusset::net::stream::{Mode, StreamDecoder, StreamOptions, decode, encode};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let job = Job::default();
    let whole = decode(bytes, &job);
    let mut decoder = StreamDecoder::new(1 << 20);
    let pieces = bytes.chunks(37).try_for_each(|piece| decoder.push(piece).map(drop));
    let in_pieces = pieces.and_then(|()| decoder.finish());
    if let Ok(net) = whole {
        assert!(in_pieces.is_ok() || net.shape().node_count() > 1 << 20);
        let again = encode(&net, &StreamOptions::new(Mode::Lossless), &job).expect("a net can be encoded");
        assert_eq!(decode(&again, &job).expect("what was encoded can be decoded").shape(), net.shape());
    }
});
