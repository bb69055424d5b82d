//! Adaptive models of symbols for the range coder: probabilities from counts.
//!
//! Invariant: encoder and decoder update a model from the same symbols in the same order, so that
//! their probabilities are equal. Probabilities are renewed at growing intervals; O(1) amortised a
//! symbol.

use constriction::stream::model::{DecoderModel, EncoderModel, EntropyModel};
use std::num::NonZeroU32;

/// Bits of a probability.
pub(super) const PROBABILITY_BITS: usize = 15;
/// The sum of all probabilities.
pub(super) const TOTAL_PROBABILITY: u32 = 1 << PROBABILITY_BITS;
/// The increment of a count for each observation.
const COUNT_INCREMENT: u16 = 24;
/// The sum of counts above which all are halved.
const MAX_COUNT_SUM: u32 = 1 << 15;
/// The initial sum of counts, per symbol.
const PRIOR_COUNT_PER_SYMBOL: f64 = 20.0;

/// N symbols with probabilities from counts, renewed at growing intervals.
#[derive(Debug, Clone)]
pub(super) struct SymbolModel<const N: usize> {
    /// The cumulative probability below each symbol.
    pub(super) lower_cumulative: [u16; N],
    counts: [u16; N],
    /// Observations until the next renewal, and the current interval.
    observations_until_renewal: u16,
    interval: u16,
}

impl<const N: usize> SymbolModel<N> {
    /// Returns a model with prior weights, not all zero.
    pub(super) fn new(weights: [f64; N]) -> Self {
        let sum: f64 = weights.iter().sum();
        let counts = weights.map(|weight| (PRIOR_COUNT_PER_SYMBOL * N as f64 * weight / sum) as u16 + 1);
        let mut model = SymbolModel { lower_cumulative: [0; N], counts, observations_until_renewal: 0, interval: 4 };
        model.recompute_probabilities();
        model
    }

    #[inline(always)]
    pub(super) fn count_symbol(&mut self, symbol: usize) {
        self.counts[symbol] += COUNT_INCREMENT;
        self.observations_until_renewal -= 1;
        if self.observations_until_renewal == 0 {
            self.recompute_probabilities();
        }
    }

    /// Probabilities from counts: at least 1 each; the rounding remainder goes to the last symbol.
    #[inline(never)]
    fn recompute_probabilities(&mut self) {
        let mut total: u32 = self.counts.iter().map(|&count| u32::from(count)).sum();
        if total > MAX_COUNT_SUM {
            self.counts.iter_mut().for_each(|count| *count = count.div_ceil(2));
            total = self.counts.iter().map(|&count| u32::from(count)).sum();
        }
        let scale = ((TOTAL_PROBABILITY - N as u32) << 16) / total;
        let mut sum = 0;
        for (lower, &count) in self.lower_cumulative.iter_mut().zip(&self.counts) {
            *lower = sum;
            sum += 1 + ((u32::from(count) * scale) >> 16) as u16;
        }
        self.interval = (self.interval + self.interval / 2).min(128);
        self.observations_until_renewal = self.interval;
    }

    #[inline(always)]
    fn upper_cumulative(&self, symbol: usize) -> u32 {
        if symbol + 1 < N { self.lower_cumulative[symbol + 1].into() } else { TOTAL_PROBABILITY }
    }

    /// Returns the probability of a symbol.
    #[inline(always)]
    pub(super) fn probability(&self, symbol: usize) -> NonZeroU32 {
        // At least 1; the other branch is never taken.
        NonZeroU32::new(self.upper_cumulative(symbol) - u32::from(self.lower_cumulative[symbol]))
            .unwrap_or(NonZeroU32::MIN)
    }
}

impl<const N: usize> EntropyModel<PROBABILITY_BITS> for &SymbolModel<N> {
    type Symbol = usize;
    type Probability = u32;
}

impl<const N: usize> EncoderModel<PROBABILITY_BITS> for &SymbolModel<N> {
    #[inline(always)]
    fn left_cumulative_and_probability(&self, symbol: impl std::borrow::Borrow<usize>) -> Option<(u32, NonZeroU32)> {
        let symbol = *symbol.borrow();
        Some((self.lower_cumulative[symbol].into(), self.probability(symbol)))
    }
}

impl<const N: usize> DecoderModel<PROBABILITY_BITS> for &SymbolModel<N> {
    #[inline(always)]
    fn quantile_function(&self, quantile: u32) -> (usize, u32, NonZeroU32) {
        // Branch-free: the number of symbols that start at or before the quantile.
        let quantile = quantile as i16;
        let count: i16 = self.lower_cumulative.iter().map(|&lower| i16::from(lower as i16 <= quantile)).sum();
        let symbol = (count - 1) as usize & (N - 1);
        (symbol, self.lower_cumulative[symbol].into(), self.probability(symbol))
    }
}
