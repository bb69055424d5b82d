//! Widens ranges by weighted sums of six lines, with vector instructions.

use super::axis::NODES_PER_CUBIC;
use gusset_base::simd::Kernel;

/// Weights of `K` sums.
pub(super) type SumWeights<const K: usize> = [[f64; NODES_PER_CUBIC]; K];

/// Widens ranges to include weighted sums of six lines, coordinate by coordinate.
pub(super) struct WidenRangesKernel<'a, const K: usize> {
    pub(super) sums: SumWeights<K>,
    pub(super) lines: [&'a [f64]; NODES_PER_CUBIC],
    pub(super) low: &'a mut [f64],
    pub(super) high: &'a mut [f64],
}

impl<const K: usize> Kernel for WidenRangesKernel<'_, K> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let WidenRangesKernel { sums, lines, low, high } = self;
        widen_ranges(&sums, lines, low, high);
    }
}

#[inline(always)]
pub(super) fn widen_ranges<const K: usize>(
    sums: &SumWeights<K>,
    lines: [&[f64]; NODES_PER_CUBIC],
    low: &mut [f64],
    high: &mut [f64],
) {
    let count = low.len();
    let high = &mut high[..count];
    let [a, b, c, d, e, f] = lines.map(|line| &line[..count]);
    for k in 0..count {
        let taps = [a[k], b[k], c[k], d[k], e[k], f[k]];
        let (mut least, mut most) = (low[k], high[k]);
        for w in sums {
            let x = ((w[0] * taps[0] + w[1] * taps[1]) + (w[2] * taps[2] + w[3] * taps[3]))
                + (w[4] * taps[4] + w[5] * taps[5]);
            least = if x < least { x } else { least };
            most = if x > most { x } else { most };
        }
        (low[k], high[k]) = (least, most);
    }
}
