//! Base64, as `data:` addresses hold it.

use crate::error::ReadError;
use crate::text_encoding::owned_text;
use gusset_base::alloc;

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Value of each character; 64 if it is not a digit.
const VALUES: [u8; 256] = {
    let mut values = [64; 256];
    let mut digit = 0;
    while digit < 64 {
        values[DIGITS[digit] as usize] = digit as u8;
        digit += 1;
    }
    values[b'-' as usize] = 62;
    values[b'_' as usize] = 63;
    values
};

/// Decodes digits of either alphabet, with or without padding. Skips white space. Returns `None` at any other character.
pub(super) fn decode_base64(digits: &[u8]) -> Result<Option<Vec<u8>>, ReadError> {
    let mut made = Vec::new();
    made.try_reserve_exact(digits.len() / 4 * 3 + 3)?;
    let (mut bits, mut count) = (0_u32, 0);
    for &digit in digits {
        let value = VALUES[digit as usize];
        if value == 64 {
            if digit == b'=' || digit.is_ascii_whitespace() {
                continue;
            }
            return Ok(None);
        }
        bits = (bits << 6) | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            made.push((bits >> count) as u8);
        }
    }
    Ok(Some(made))
}

/// Passes the digits of bytes to `out` in pieces.
pub(super) fn encode_base64(bytes: &[u8], mut out: impl FnMut(&[u8]) -> std::io::Result<()>) -> std::io::Result<()> {
    const PIECE_BYTES: usize = 3 << 12;
    let mut digits = Vec::with_capacity(PIECE_BYTES / 3 * 4);
    for piece in bytes.chunks(PIECE_BYTES) {
        digits.clear();
        for triple in piece.chunks(3) {
            let byte = |place: usize| u32::from(triple.get(place).copied().unwrap_or(0));
            let bits = (byte(0) << 16) | (byte(1) << 8) | byte(2);
            for place in 0..4 {
                let digit = DIGITS[(bits >> (18 - 6 * place)) as usize & 63];
                digits.push(if place <= triple.len() { digit } else { b'=' });
            }
        }
        out(&digits)?;
    }
    Ok(())
}

/// Decodes `%20` and the like.
pub(super) fn decode_percent(text: &str) -> Result<String, ReadError> {
    let bytes = text.as_bytes();
    let mut made = alloc::with_capacity(bytes.len())?;
    let mut place = 0;
    while let Some(&byte) = bytes.get(place) {
        let escaped = (byte == b'%')
            .then(|| text.get(place + 1..place + 3))
            .flatten()
            .filter(|digits| digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
            .and_then(|digits| u8::from_str_radix(digits, 16).ok());
        made.push(escaped.unwrap_or(byte));
        place += if escaped.is_some() { 3 } else { 1 };
    }
    String::from_utf8(made).or_else(|error| owned_text(error.as_bytes()))
}
