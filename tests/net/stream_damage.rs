//! Streams of nets that are damaged, forged or claim too much.

use crate::common::some_of;
use crate::stream::{MODES, bits, job, noise, odd_nets, torus};
use gusset::Error;
use gusset::mesh::Scalar;
use gusset::net::stream::{HEADER_SIZE, StreamDecoder, StreamInfo, StreamOptions, decode, encode};

#[test]
fn damage_is_found() {
    for net in odd_nets().iter().take(4).chain(odd_nets().last()) {
        for mode in MODES {
            let Ok(stream) = encode(net, &StreamOptions { rows_per_block: 4, ..StreamOptions::new(mode) }, &job())
            else {
                continue;
            };
            for length in some_of(5, 0..stream.len()) {
                assert!(matches!(decode(&stream[..length], &job()), Err(Error::BadStream { .. })), "cut at {length}");
            }
            for at in 0..stream.len() {
                for flip in some_of(3, [1, 0x80, 0xff].into_iter().cycle().skip(at).take(3)) {
                    let mut bad = stream.clone();
                    bad[at] ^= flip;
                    assert!(matches!(decode(&bad, &job()), Err(Error::BadStream { .. })), "byte {at} ^ {flip}");
                }
            }
            assert!(matches!(decode(&[&stream[..], &[0]].concat(), &job()), Err(Error::BadStream { .. })));
        }
    }
}

/// Corrects the checksums of a stream, so that the checks behind them are tested.
fn forge(bytes: &mut [u8]) {
    let number = |bytes: &[u8], at: usize| u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    if bytes.len() < HEADER_SIZE {
        return;
    }
    let structure = number(bytes, 32) as usize;
    let header = |bytes: &mut [u8]| {
        let sum = crc32fast::hash(&bytes[..HEADER_SIZE - 4]);
        bytes[HEADER_SIZE - 4..HEADER_SIZE].copy_from_slice(&sum.to_le_bytes());
    };
    header(bytes);
    let Ok(info) = StreamInfo::read(bytes) else { return };
    let table = HEADER_SIZE.saturating_add(structure);
    let end = table.saturating_add(12 * info.block_count());
    if end > bytes.len() {
        return;
    }
    let mut offset = info.prelude_size as usize;
    for block in 0..info.block_count() {
        let entry = table + 12 * block;
        let next = offset.saturating_add(number(bytes, entry) as usize);
        if next > bytes.len() {
            break;
        }
        let sum = crc32fast::hash(&bytes[offset..next]);
        bytes[entry + 8..entry + 12].copy_from_slice(&sum.to_le_bytes());
        offset = next;
    }
    let sum = crc32fast::hash(&bytes[HEADER_SIZE..end]);
    bytes[40..44].copy_from_slice(&sum.to_le_bytes());
    header(bytes);
}

#[test]
fn forged_streams_do_no_harm() {
    let nets = odd_nets();
    let (mut refused, mut taken) = (0, 0);
    for (n, net) in nets.iter().enumerate() {
        for mode in MODES {
            let Ok(stream) = encode(net, &StreamOptions { rows_per_block: 3, ..StreamOptions::new(mode) }, &job())
            else {
                continue;
            };
            for round in some_of(2, 0..120u64) {
                let mut bad = stream.clone();
                for k in 0..1 + round % 3 {
                    let random = |m: u64| noise(n as u64 * 1000 + m, 10 * round + k);
                    let at = (random(1) * bad.len() as f64) as usize;
                    bad[at] = match round % 4 {
                        0 => 0xff,
                        1 => 0,
                        _ => (random(2) * 256.0) as u8,
                    };
                }
                if round % 5 == 0 {
                    bad.truncate((noise(5, round) * bad.len() as f64) as usize);
                }
                forge(&mut bad);
                match decode(&bad, &job()) {
                    Ok(net) => {
                        taken += 1;
                        assert_eq!(bits(&net).len(), 3 * net.shape().node_count());
                    }
                    Err(Error::BadStream { byte, .. }) => {
                        refused += 1;
                        assert!(byte <= bad.len() as u64 + 12, "byte {byte} of {}", bad.len());
                    }
                    Err(other) => panic!("{other}"),
                }
                let mut decoder = StreamDecoder::new(1 << 16);
                let _ = bad.chunks(50).try_for_each(|piece| decoder.decode_next_bytes(piece).map(|_| ()));
            }
        }
    }
    assert!(refused > 2000 && taken > 100, "{refused} refused, {taken} taken");
}

#[test]
fn huge_claims_are_refused_at_once() {
    let net = torus(4, 4, Scalar::F32, 0.0);
    for mode in MODES {
        let stream = encode(&net, &StreamOptions::new(mode), &job()).unwrap();
        for (rows, columns) in [(1u32 << 30, 1u32), (2, 1 << 30), (46340, 46340), (u32::MAX, u32::MAX), (1, 1)] {
            let mut bad = stream.clone();
            bad[16..20].copy_from_slice(&rows.to_le_bytes());
            bad[20..24].copy_from_slice(&columns.to_le_bytes());
            bad[24..28].copy_from_slice(&rows.to_le_bytes());
            forge(&mut bad);
            assert!(matches!(decode(&bad, &job()), Err(Error::BadStream { .. })), "{rows} x {columns}");
        }
        for at in [32, 128, 130, 140] {
            let mut bad = stream.clone();
            bad[at..at + 8].fill(0xff);
            forge(&mut bad);
            assert!(matches!(decode(&bad, &job()), Err(Error::BadStream { .. })), "at {at}");
        }
    }
}
