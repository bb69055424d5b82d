//! Entropy coding: the range coder of the crate `constriction` with adaptive models, and beside it
//! a plain bit stream for incompressible bits.
//!
//! Invariant: one routine drives encoder and decoder through [`EntropyCoder`], so that they cannot
//! differ.

use super::symbol_model::{PROBABILITY_BITS, SymbolModel};
use constriction::backends::{Cursor, WriteWords};
use constriction::stream::queue::{DefaultRangeDecoder, DefaultRangeEncoder};
use constriction::stream::{Decode, Encode};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};

/// An encoder or a decoder of a sequence of numbers. An encoder writes each number that it is
/// given. A decoder ignores its argument and returns the number that it reads.
pub(super) trait EntropyCoder {
    /// Codes a symbol by an adaptive model, and updates the model.
    fn code_symbol<const N: usize>(&mut self, model: &mut SymbolModel<N>, symbol: usize) -> usize;
    /// Encodes the `count` low bits of `value`, or decodes and returns as many bits. `count` is at
    /// most 64.
    fn code_bits(&mut self, value: u64, count: u32) -> u64;
}

/// A fallible output buffer.
#[derive(Debug, Default)]
struct WordBuffer {
    words: Vec<u32>,
}

impl WriteWords<u32> for WordBuffer {
    type WriteError = Error;

    fn write(&mut self, word: u32) -> Result<()> {
        alloc::push(&mut self.words, word)
    }
}

/// The encoder. Failures to allocate are reported at the end.
pub(super) struct RangeEncoder {
    encoder: DefaultRangeEncoder<WordBuffer>,
    bits: Vec<u64>,
    /// Bits of an incomplete word, and their number.
    pending_bits: u64,
    pending_count: u32,
    failed: bool,
}

impl RangeEncoder {
    pub(super) fn new() -> Self {
        let range = DefaultRangeEncoder::with_write_backend(WordBuffer::default());
        RangeEncoder { encoder: range, bits: Vec::new(), pending_bits: 0, pending_count: 0, failed: false }
    }

    /// Returns the words of the range coder, and the bytes of the bits.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(super) fn finish(self) -> Result<(Vec<u32>, Vec<u8>)> {
        let last = (self.pending_count as usize).div_ceil(8);
        let mut bytes = alloc::with_capacity(8 * self.bits.len() + last)?;
        self.bits.iter().for_each(|word| bytes.extend_from_slice(&word.to_le_bytes()));
        bytes.extend_from_slice(&self.pending_bits.to_le_bytes()[..last]);
        let words = self.encoder.into_compressed()?.words;
        if self.failed { Err(Error::OutOfMemory { bytes: 4 * words.len() as u64 }) } else { Ok((words, bytes)) }
    }
}

impl EntropyCoder for RangeEncoder {
    #[inline(always)]
    fn code_symbol<const N: usize>(&mut self, model: &mut SymbolModel<N>, symbol: usize) -> usize {
        self.failed |= Encode::<PROBABILITY_BITS>::encode_symbol(&mut self.encoder, symbol, &*model).is_err();
        model.count_symbol(symbol);
        symbol
    }

    #[inline(always)]
    fn code_bits(&mut self, value: u64, count: u32) -> u64 {
        if count == 0 {
            return 0;
        }
        let value = value & (u64::MAX >> (64 - count));
        self.pending_bits |= value << self.pending_count;
        let filled = self.pending_count + count;
        if filled >= 64 {
            self.failed |= alloc::push(&mut self.bits, self.pending_bits).is_err();
            // The bits that did not fit, if any.
            let used = 64 - self.pending_count;
            self.pending_bits = if used < 64 { value >> used } else { 0 };
        }
        self.pending_count = filled % 64;
        value
    }
}

/// The decoder. It reads zeros beyond the end; malformed input is reported at the end.
pub(super) struct RangeDecoder<'a> {
    decoder: DefaultRangeDecoder<Cursor<u32, Vec<u32>>>,
    bits: &'a [u8],
    /// The next bit.
    next_bit: u64,
    failed: bool,
}

impl<'a> RangeDecoder<'a> {
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(super) fn new(words: &[u8], bits: &'a [u8]) -> Result<Self> {
        let word = |bytes: &[u8]| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        let words = alloc::collect(words.chunks_exact(4).map(word))?;
        let Ok(range) = DefaultRangeDecoder::from_compressed(words);
        Ok(RangeDecoder { decoder: range, bits, next_bit: 0, failed: false })
    }

    /// Returns true if exactly the input was read.
    pub(super) fn has_read_all_input(&self) -> bool {
        !self.failed && self.next_bit.div_ceil(8) == self.bits.len() as u64
    }
}

impl EntropyCoder for RangeDecoder<'_> {
    #[inline(always)]
    fn code_symbol<const N: usize>(&mut self, model: &mut SymbolModel<N>, _: usize) -> usize {
        let symbol = Decode::<PROBABILITY_BITS>::decode_symbol(&mut self.decoder, &*model).unwrap_or_else(|_| {
            self.failed = true;
            0
        });
        model.count_symbol(symbol);
        symbol
    }

    #[inline(always)]
    fn code_bits(&mut self, _: u64, count: u32) -> u64 {
        if count == 0 {
            return 0;
        }
        let (byte, shift) = ((self.next_bit / 8) as usize, (self.next_bit % 8) as u32);
        let Some(window) = self.bits.get(byte..).and_then(|rest| rest.first_chunk()) else {
            return self.decode_bits_at_end(count);
        };
        let mut value = u64::from_le_bytes(*window) >> shift;
        if shift + count > 64 {
            value |= u64::from(self.bits.get(byte + 8).copied().unwrap_or(0)) << (64 - shift);
        }
        self.next_bit += u64::from(count);
        value & (u64::MAX >> (64 - count))
    }
}

impl RangeDecoder<'_> {
    /// `code_bits` within the last eight bytes.
    #[cold]
    fn decode_bits_at_end(&mut self, count: u32) -> u64 {
        let bit = |at: u64| u64::from(self.bits.get((at / 8) as usize).copied().unwrap_or(0)) >> (at % 8) & 1;
        let value = (0..count).fold(0, |value, k| value | bit(self.next_bit + u64::from(k)) << k);
        self.next_bit += u64::from(count);
        value
    }
}
