//! Coding of residuals: contexts by expected magnitude, with an adaptive model each.
//!
//! The magnitudes of neighbouring residuals predict the next magnitude and choose one of many
//! models. Each model starts from a geometric distribution of the expected mean, so that small nets
//! need not train it. Symbols are magnitude classes in the manner of Golomb-Rice codes; the bits
//! below are stored uncoded. O(1) a residual.

use super::coder::Coder;
use super::symbol_model::Model;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Magnitude classes; with a sign they are the symbols.
const CLASSES: usize = 16;
const SYMBOLS: usize = 2 * CLASSES;
/// The start of each class, and the number of bits that distinguish its members. The last class is
/// unbounded.
const STARTS: [u64; CLASSES] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 72, 136];
const WIDTHS: [u32; CLASSES] = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3, 4, 5, 6, 0];

/// Contexts of expected magnitude: two for each power of two.
const LEVELS: usize = 64;
/// Contexts of the ratio of observed to expected magnitude in the other coordinates of the node.
pub(super) const RATIO_CLASSES: usize = 4;

/// The sum of the weights of neighbouring magnitudes: expected magnitudes are in units of 1 / this.
const EXPECTATION_UNIT: u64 = 10;

/// Codes residuals of one coordinate.
pub(super) struct Residuals {
    models: Vec<Model<SYMBOLS>>,
}

impl Residuals {
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new() -> Result<Self> {
        let model = |at: usize| Model::new(geometric(at / RATIO_CLASSES));
        Ok(Residuals { models: alloc::collect((0..LEVELS * RATIO_CLASSES).map(model))? })
    }

    /// Codes a residual. `expected` is the expected magnitude in units of 1 / [`EXPECTATION_UNIT`].
    #[inline(always)]
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, residual: i64, expected: u64, ratio_class: usize) -> i64 {
        let level = level(expected);
        let shift = shift(level);
        let model = &mut self.models[level.min(LEVELS - 1) * RATIO_CLASSES + (ratio_class & (RATIO_CLASSES - 1))];
        let above = residual >> shift;
        let magnitude = (above ^ (above >> 63)) as u64;
        let range = range(magnitude);
        let symbol = coder.symbol(model, if above < 0 { SYMBOLS - 1 - range } else { range });
        let (negative, range) = if symbol < CLASSES { (0, symbol) } else { (-1, SYMBOLS - 1 - symbol) };
        let beyond = if range + 1 < CLASSES {
            coder.bits(magnitude.wrapping_sub(STARTS[range]), WIDTHS[range])
        } else {
            escape(coder, magnitude.wrapping_sub(STARTS[range]))
        };
        let above = (STARTS[range].wrapping_add(beyond)) as i64 ^ negative;
        let below = coder.bits(residual as u64, shift);
        (above.wrapping_shl(shift)) | below as i64
    }
}

/// Codes a large number: its length in bits, then its bits.
#[cold]
fn escape<C: Coder>(coder: &mut C, value: u64) -> u64 {
    let length = coder.bits(u64::from(64 - value.leading_zeros()), 7).min(64) as u32;
    coder.bits(value, length)
}

/// Returns the class of a magnitude.
#[inline(always)]
fn range(magnitude: u64) -> usize {
    // From 16 on, each class starts at 8 plus a power of two.
    match magnitude {
        0..8 => magnitude as usize,
        8..12 => 4 + (magnitude / 2) as usize,
        12..16 => 10,
        16..136 => 10 + (magnitude - 8).ilog2() as usize - 2,
        _ => CLASSES - 1,
    }
}

/// Returns the context of an expected magnitude: 0 for 0, then two for each power of two.
#[inline(always)]
fn level(expected: u64) -> usize {
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
fn shift(level: usize) -> u32 {
    ((level.max(1) - 1) as u32 / 2).saturating_sub(5)
}

/// Returns the prior weights of a level: a two-sided geometric distribution of its mean magnitude.
fn geometric(level: usize) -> [f64; SYMBOLS] {
    let log = (level.max(1) - 1) as u32 / 2;
    let start = if log < 63 { (1u64 << log) as f64 } else { 9.3e18 };
    let expected = if level == 0 { 0.3 } else { start * (1.2 + 0.5 * ((level - 1) % 2) as f64) };
    let mean = expected / EXPECTATION_UNIT as f64 / (1u64 << shift(level)) as f64;
    let ratio = mean / (mean + 1.0);
    let power = |k: u64| (0..k).fold(1.0, |power: f64, _| power * ratio);
    let mut weights = [0.0; SYMBOLS];
    for range in 0..CLASSES {
        let end = STARTS.get(range + 1).map_or(0.0, |&end| power(end));
        let weight = power(STARTS[range]) - end + 1e-3;
        weights[range] = weight;
        // A negative number of magnitude class m is -1 - m, one farther from 0.
        weights[SYMBOLS - 1 - range] = weight * if shift(level) == 0 { ratio } else { 1.0 };
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::super::symbol_model::TOTAL;
    use super::*;
    use constriction::stream::model::DecoderModel;

    #[test]
    fn every_magnitude_is_in_its_class() {
        for magnitude in 0..1000 {
            let found = range(magnitude);
            assert!(STARTS[found] <= magnitude);
            assert!(found + 1 == CLASSES || magnitude < STARTS[found + 1], "{magnitude}");
            assert!(found + 1 == CLASSES || magnitude - STARTS[found] < 1 << WIDTHS[found]);
        }
    }

    #[test]
    fn probabilities_are_positive_and_complete() {
        for level in 0..LEVELS {
            let mut model = Model::new(geometric(level));
            for k in 0..5000 {
                let widths = (0..SYMBOLS).map(|s| model.width(s).get());
                assert_eq!(widths.sum::<u32>(), TOTAL);
                model.learn(if k < 3000 { 7 } else { k % SYMBOLS });
            }
            let quantile = u32::from(model.lower[9]);
            assert_eq!((&model).quantile_function(quantile).0, 9);
        }
    }
}
