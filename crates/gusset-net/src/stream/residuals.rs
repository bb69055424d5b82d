//! Coding of residuals: contexts by expected magnitude, with an adaptive model each.
//!
//! The magnitudes of neighbouring residuals predict the next magnitude and choose one of many
//! models. Each model starts from a geometric distribution of the expected mean, so that small nets
//! need not train it. Symbols are magnitude classes in the manner of Golomb-Rice codes; the bits
//! below are stored uncoded. O(1) a residual.

use super::coder::EntropyCoder;
use super::symbol_model::SymbolModel;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Magnitude classes; with a sign they are the symbols.
const MAGNITUDE_CLASSES: usize = 16;
const SYMBOL_COUNT: usize = 2 * MAGNITUDE_CLASSES;
/// The start of each class, and the number of bits that distinguish its members. The last class is
/// unbounded.
const CLASS_STARTS: [u64; MAGNITUDE_CLASSES] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 72, 136];
const CLASS_EXTRA_BITS: [u32; MAGNITUDE_CLASSES] = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3, 4, 5, 6, 0];

/// Contexts of expected magnitude: two for each power of two.
const MAGNITUDE_CONTEXTS: usize = 64;
/// Contexts of the ratio of observed to expected magnitude in the other coordinates of the node.
pub(super) const MAGNITUDE_RATIO_CLASS_COUNT: usize = 4;

/// The sum of the weights of neighbouring magnitudes: expected magnitudes are in units of 1 / this.
const EXPECTATION_DENOMINATOR: u64 = 10;

/// Codes residuals of one coordinate.
pub(super) struct ResidualCoder {
    models: Vec<SymbolModel<SYMBOL_COUNT>>,
}

impl ResidualCoder {
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new() -> Result<Self> {
        let model = |at: usize| SymbolModel::new(geometric_prior(at / MAGNITUDE_RATIO_CLASS_COUNT));
        Ok(ResidualCoder { models: alloc::collect((0..MAGNITUDE_CONTEXTS * MAGNITUDE_RATIO_CLASS_COUNT).map(model))? })
    }

    /// Codes a residual. `expected` is the expected magnitude in units of 1 /
    /// [`EXPECTATION_DENOMINATOR`].
    #[inline(always)]
    pub(super) fn code_residual<C: EntropyCoder>(
        &mut self,
        coder: &mut C,
        residual: i64,
        expected: u64,
        ratio_class: usize,
    ) -> i64 {
        let level = context_of_expected_magnitude(expected);
        let shift = raw_low_bits_at_level(level);
        let model = &mut self.models[level.min(MAGNITUDE_CONTEXTS - 1) * MAGNITUDE_RATIO_CLASS_COUNT
            + (ratio_class & (MAGNITUDE_RATIO_CLASS_COUNT - 1))];
        let above = residual >> shift;
        let magnitude = (above ^ (above >> 63)) as u64;
        let range = magnitude_class(magnitude);
        let symbol = coder.code_symbol(model, if above < 0 { SYMBOL_COUNT - 1 - range } else { range });
        let (negative, range) = if symbol < MAGNITUDE_CLASSES { (0, symbol) } else { (-1, SYMBOL_COUNT - 1 - symbol) };
        let beyond = if range + 1 < MAGNITUDE_CLASSES {
            coder.code_bits(magnitude.wrapping_sub(CLASS_STARTS[range]), CLASS_EXTRA_BITS[range])
        } else {
            code_large_number(coder, magnitude.wrapping_sub(CLASS_STARTS[range]))
        };
        let above = (CLASS_STARTS[range].wrapping_add(beyond)) as i64 ^ negative;
        let below = coder.code_bits(residual as u64, shift);
        (above.wrapping_shl(shift)) | below as i64
    }
}

/// Codes a large number: its length in bits, then its bits.
#[cold]
fn code_large_number<C: EntropyCoder>(coder: &mut C, value: u64) -> u64 {
    let length = coder.code_bits(u64::from(64 - value.leading_zeros()), 7).min(64) as u32;
    coder.code_bits(value, length)
}

/// Returns the class of a magnitude.
#[inline(always)]
fn magnitude_class(magnitude: u64) -> usize {
    // From 16 on, each class starts at 8 plus a power of two.
    match magnitude {
        0..8 => magnitude as usize,
        8..12 => 4 + (magnitude / 2) as usize,
        12..16 => 10,
        16..136 => 10 + (magnitude - 8).ilog2() as usize - 2,
        _ => MAGNITUDE_CLASSES - 1,
    }
}

/// Returns the context of an expected magnitude: 0 for 0, then two for each power of two.
#[inline(always)]
fn context_of_expected_magnitude(expected: u64) -> usize {
    if expected == 0 {
        return 0;
    }
    let log = expected.ilog2();
    let half = if log == 0 { 0 } else { expected >> (log - 1) & 1 };
    1 + 2 * log as usize + half as usize
}

/// Returns the number of low bits that are nearly uniform at a level: the rest has a mean of about
/// 3 to 6.
#[inline(always)]
fn raw_low_bits_at_level(level: usize) -> u32 {
    ((level.max(1) - 1) as u32 / 2).saturating_sub(5)
}

/// Returns the prior weights of a level: a two-sided geometric distribution of its mean magnitude.
fn geometric_prior(level: usize) -> [f64; SYMBOL_COUNT] {
    let log = (level.max(1) - 1) as u32 / 2;
    let start = if log < 63 { (1u64 << log) as f64 } else { 9.3e18 };
    let expected = if level == 0 { 0.3 } else { start * (1.2 + 0.5 * ((level - 1) % 2) as f64) };
    let mean = expected / EXPECTATION_DENOMINATOR as f64 / (1u64 << raw_low_bits_at_level(level)) as f64;
    let ratio = mean / (mean + 1.0);
    let power = |k: u64| (0..k).fold(1.0, |power: f64, _| power * ratio);
    let mut weights = [0.0; SYMBOL_COUNT];
    for range in 0..MAGNITUDE_CLASSES {
        let end = CLASS_STARTS.get(range + 1).map_or(0.0, |&end| power(end));
        let weight = power(CLASS_STARTS[range]) - end + 1e-3;
        weights[range] = weight;
        // A negative number of magnitude class m is -1 - m, one farther from 0.
        weights[SYMBOL_COUNT - 1 - range] = weight * if raw_low_bits_at_level(level) == 0 { ratio } else { 1.0 };
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::super::symbol_model::TOTAL_PROBABILITY;
    use super::*;
    use constriction::stream::model::DecoderModel;

    #[test]
    fn every_magnitude_is_in_its_class() {
        for magnitude in 0..1000 {
            let found = magnitude_class(magnitude);
            assert!(CLASS_STARTS[found] <= magnitude);
            assert!(found + 1 == MAGNITUDE_CLASSES || magnitude < CLASS_STARTS[found + 1], "{magnitude}");
            assert!(found + 1 == MAGNITUDE_CLASSES || magnitude - CLASS_STARTS[found] < 1 << CLASS_EXTRA_BITS[found]);
        }
    }

    #[test]
    fn probabilities_are_positive_and_complete() {
        for level in 0..MAGNITUDE_CONTEXTS {
            let mut model = SymbolModel::new(geometric_prior(level));
            for k in 0..5000 {
                let widths = (0..SYMBOL_COUNT).map(|s| model.probability(s).get());
                assert_eq!(widths.sum::<u32>(), TOTAL_PROBABILITY);
                model.count_symbol(if k < 3000 { 7 } else { k % SYMBOL_COUNT });
            }
            let quantile = u32::from(model.lower_cumulative[9]);
            assert_eq!((&model).quantile_function(quantile).0, 9);
        }
    }
}
