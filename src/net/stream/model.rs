//! How probable each symbol is: adaptive models, and the contexts of residuals.
//!
//! A residual is expected to be as large as those around it. What is expected chooses one of many models, each of which learns
//! how residuals are distributed there; so that small nets need not learn from nothing, it begins with a geometric
//! distribution of the expected mean.

use super::coder::Coder;
use constriction::stream::model::{DecoderModel, EncoderModel, EntropyModel};
use std::num::NonZeroU32;

/// Bits of a probability.
pub(super) const PRECISION: usize = 15;
const WHOLE: u32 = 1 << PRECISION;
/// What one observation adds to a count, and the sum of counts at which all are halved.
const STEP: u16 = 24;
const LIMIT: u32 = 1 << 15;
/// The sum of counts with which a model begins, for each of its symbols.
const PRIOR: f64 = 20.0;

/// N symbols with probabilities from counts. Probabilities are computed anew only now and then, the later the more rarely.
#[derive(Debug, Clone)]
pub(super) struct Model<const N: usize> {
    /// The sum of the probabilities of the symbols before each.
    lower: [u16; N],
    counts: [u16; N],
    /// Observations until probabilities are computed anew, and how many that were the last time.
    left: u16,
    interval: u16,
}

impl<const N: usize> Model<N> {
    /// With prior weights, not all zero.
    pub(super) fn new(weights: [f64; N]) -> Self {
        let sum: f64 = weights.iter().sum();
        let counts = weights.map(|weight| (PRIOR * N as f64 * weight / sum) as u16 + 1);
        let mut model = Model { lower: [0; N], counts, left: 0, interval: 4 };
        model.renew();
        model
    }

    #[inline(always)]
    pub(super) fn learn(&mut self, symbol: usize) {
        self.counts[symbol] += STEP;
        self.left -= 1;
        if self.left == 0 {
            self.renew();
        }
    }

    /// Probabilities from counts: at least 1 each, and what rounding leaves over goes to the last symbol.
    #[inline(never)]
    fn renew(&mut self) {
        let mut total: u32 = self.counts.iter().map(|&count| u32::from(count)).sum();
        if total > LIMIT {
            self.counts.iter_mut().for_each(|count| *count = count.div_ceil(2));
            total = self.counts.iter().map(|&count| u32::from(count)).sum();
        }
        let scale = ((WHOLE - N as u32) << 16) / total;
        let mut sum = 0;
        for (lower, &count) in self.lower.iter_mut().zip(&self.counts) {
            *lower = sum;
            sum += 1 + ((u32::from(count) * scale) >> 16) as u16;
        }
        self.interval = (self.interval + self.interval / 2).min(128);
        self.left = self.interval;
    }

    #[inline(always)]
    fn upper(&self, symbol: usize) -> u32 {
        if symbol + 1 < N { self.lower[symbol + 1].into() } else { WHOLE }
    }

    /// The probability of a symbol.
    #[inline(always)]
    fn width(&self, symbol: usize) -> NonZeroU32 {
        // Widths are 1 at least; the other branch is never taken.
        NonZeroU32::new(self.upper(symbol) - u32::from(self.lower[symbol])).unwrap_or(NonZeroU32::MIN)
    }
}

impl<const N: usize> EntropyModel<PRECISION> for &Model<N> {
    type Symbol = usize;
    type Probability = u32;
}

impl<const N: usize> EncoderModel<PRECISION> for &Model<N> {
    #[inline(always)]
    fn left_cumulative_and_probability(&self, symbol: impl std::borrow::Borrow<usize>) -> Option<(u32, NonZeroU32)> {
        let symbol = *symbol.borrow();
        Some((self.lower[symbol].into(), self.width(symbol)))
    }
}

impl<const N: usize> DecoderModel<PRECISION> for &Model<N> {
    #[inline(always)]
    fn quantile_function(&self, quantile: u32) -> (usize, u32, NonZeroU32) {
        // Without branches: how many symbols begin at the quantile or before it.
        let quantile = quantile as i16;
        let count: i16 = self.lower.iter().map(|&lower| i16::from(lower as i16 <= quantile)).sum();
        let symbol = (count - 1) as usize & (N - 1);
        (symbol, self.lower[symbol].into(), self.width(symbol))
    }
}

/// Symbols of residuals: 16 ranges of magnitude, of either sign.
const RANGES: usize = 16;
const SYMBOLS: usize = 2 * RANGES;
/// Where each range begins, and the bits that tell its members apart. The last one has no end.
const STARTS: [u64; RANGES] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 72, 136];
const WIDTHS: [u32; RANGES] = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3, 4, 5, 6, 0];

/// Levels of expectation: two for each power of two.
const LEVELS: usize = 64;
/// How residuals of the other coordinates of the node were, compared with what was expected of them.
pub(super) const SURPRISES: usize = 4;

/// The sum of weights with which magnitudes around are added up: expectations are in these parts of a unit.
pub(super) const PARTS: u64 = 10;

/// Codes residuals of one coordinate.
pub(super) struct Residuals {
    models: Vec<Model<SYMBOLS>>,
}

impl Residuals {
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(super) fn new() -> crate::error::Result<Self> {
        let model = |at: usize| Model::new(geometric(at / SURPRISES));
        Ok(Residuals { models: crate::alloc::collect((0..LEVELS * SURPRISES).map(model))? })
    }

    /// Codes a residual where `expected` is the mean magnitude expected, in [`PARTS`] of a unit.
    #[inline(always)]
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, residual: i64, expected: u64, surprise: usize) -> i64 {
        let level = level(expected);
        let shift = shift(level);
        let model = &mut self.models[level.min(LEVELS - 1) * SURPRISES + (surprise & (SURPRISES - 1))];
        let above = residual >> shift;
        let magnitude = (above ^ (above >> 63)) as u64;
        let range = range(magnitude);
        let symbol = coder.symbol(model, if above < 0 { SYMBOLS - 1 - range } else { range });
        let (negative, range) = if symbol < RANGES { (0, symbol) } else { (-1, SYMBOLS - 1 - symbol) };
        let beyond = if range + 1 < RANGES {
            coder.bits(magnitude.wrapping_sub(STARTS[range]), WIDTHS[range])
        } else {
            endless(coder, magnitude.wrapping_sub(STARTS[range]))
        };
        let above = (STARTS[range].wrapping_add(beyond)) as i64 ^ negative;
        let below = coder.bits(residual as u64, shift);
        (above.wrapping_shl(shift)) | below as i64
    }
}

/// A number of any size: its length in bits, then its bits.
#[cold]
fn endless<C: Coder>(coder: &mut C, value: u64) -> u64 {
    let length = coder.bits(u64::from(64 - value.leading_zeros()), 7).min(64) as u32;
    coder.bits(value, length)
}

/// The range of a magnitude.
#[inline(always)]
fn range(magnitude: u64) -> usize {
    // From 16 on, 8 below a power of two starts each range.
    match magnitude {
        0..8 => magnitude as usize,
        8..12 => 4 + (magnitude / 2) as usize,
        12..16 => 10,
        16..136 => 10 + (magnitude - 8).ilog2() as usize - 2,
        _ => RANGES - 1,
    }
}

/// 0 for nothing, then two for each power of two.
#[inline(always)]
fn level(expected: u64) -> usize {
    if expected == 0 {
        return 0;
    }
    let log = expected.ilog2();
    let half = if log == 0 { 0 } else { expected >> (log - 1) & 1 };
    1 + 2 * log as usize + half as usize
}

/// The low bits of residuals that are as good as random where the mean magnitude is of this level: those that leave a mean of
/// about 3 to 6.
#[inline(always)]
fn shift(level: usize) -> u32 {
    ((level.max(1) - 1) as u32 / 2).saturating_sub(5)
}

/// The prior weights of a level: a two-sided geometric distribution with its mean magnitude.
fn geometric(level: usize) -> [f64; SYMBOLS] {
    let log = (level.max(1) - 1) as u32 / 2;
    let least = if log < 63 { (1u64 << log) as f64 } else { 9.3e18 };
    let expected = if level == 0 { 0.3 } else { least * (1.2 + 0.5 * ((level - 1) % 2) as f64) };
    let mean = expected / PARTS as f64 / (1u64 << shift(level)) as f64;
    let ratio = mean / (mean + 1.0);
    let power = |k: u64| (0..k).fold(1.0, |power: f64, _| power * ratio);
    let mut weights = [0.0; SYMBOLS];
    for range in 0..RANGES {
        let end = STARTS.get(range + 1).map_or(0.0, |&end| power(end));
        let weight = power(STARTS[range]) - end + 1e-3;
        weights[range] = weight;
        // A negative number of magnitude m is -1 - m, which is farther from 0.
        weights[SYMBOLS - 1 - range] = weight * if shift(level) == 0 { ratio } else { 1.0 };
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_magnitude_is_in_its_range() {
        for magnitude in 0..1000 {
            let found = range(magnitude);
            assert!(STARTS[found] <= magnitude);
            assert!(found + 1 == RANGES || magnitude < STARTS[found + 1], "{magnitude}");
            assert!(found + 1 == RANGES || magnitude - STARTS[found] < 1 << WIDTHS[found]);
        }
    }

    #[test]
    fn probabilities_are_positive_and_whole() {
        for level in 0..LEVELS {
            let mut model = Model::new(geometric(level));
            for k in 0..5000 {
                let widths = (0..SYMBOLS).map(|s| model.width(s).get());
                assert_eq!(widths.sum::<u32>(), WHOLE);
                model.learn(if k < 3000 { 7 } else { k % SYMBOLS });
            }
            let quantile = u32::from(model.lower[9]);
            assert_eq!((&model).quantile_function(quantile).0, 9);
        }
    }
}
