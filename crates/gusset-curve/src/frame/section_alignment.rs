//! The starting points of closed sections.
//!
//! The first point in a section's list is arbitrary, and counting nodes from it would twist the
//! body. A section therefore starts where it is twisted least against the previous one. With points
//! P and Q at equal fractions of both lengths, the shift d minimises the mean of |P(u) - Q(u +
//! d)|^2. The shifts of different pairs are independent. In a ring, the excess after one round is
//! spread evenly over all pairs.
//!
//! The first section starts at its anchor, the point farthest from its centre. The anchor and the
//! shifts do not depend on where the lists of points begin.

use crate::curve::Place;
use crate::ops::ArcLengths;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The number of points of a section that are compared.
const SAMPLES_PER_SECTION: usize = 128;
/// Distances and sums whose relative difference is below this are equal, so that round-off does not
/// decide.
const RELATIVE_TIE_TOLERANCE: f64 = 1e-9;

/// A closed section, traversed from its anchor.
pub(super) struct AnchoredSection<'a> {
    pub(super) lengths: ArcLengths<'a>,
    /// The arc length at the anchor.
    pub(super) anchor_length: f64,
    pub(super) backwards: bool,
}

impl AnchoredSection<'_> {
    /// Returns the place that the section reaches after a fraction of its total length from the
    /// anchor.
    pub(super) fn place_at_fraction(&self, fraction: f64) -> Result<Place> {
        let total = self.lengths.total_length();
        let by = (fraction - fraction.floor()) * total;
        let at = self.anchor_length + if self.backwards { -by } else { by };
        let at = if at < 0.0 { at + total } else { at };
        self.lengths.place_at_length(if at >= total { at - total } else { at })
    }

    /// Returns the arc length from the anchor to a place: at least 0, less than the total length.
    pub(super) fn length_from_anchor(&self, place: Place) -> Result<f64> {
        let by = self.lengths.length_to(place)? - self.anchor_length;
        let by = if self.backwards { -by } else { by };
        Ok(if by < 0.0 { by + self.lengths.total_length() } else { by })
    }

    /// Returns points at equal fractions of the length, relative to their mean and scaled to size
    /// 1.
    fn normalised_samples(&self) -> Result<Vec<DVec3>> {
        let at = |k: usize| self.lengths.curve().point(self.place_at_fraction(k as f64 / SAMPLES_PER_SECTION as f64)?);
        let mut points = alloc::try_collect((0..SAMPLES_PER_SECTION).map(at))?;
        let mean = points.iter().map(|&p| p / SAMPLES_PER_SECTION as f64).sum::<DVec3>();
        points.iter_mut().for_each(|p| *p -= mean);
        let size = points.iter().map(|p| p.abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
        points.iter_mut().for_each(|p| *p /= size);
        Ok(points)
    }
}

/// Returns the index of the anchor among the points of a section: the point farthest from the mean.
/// Ties go to the largest x, then y, then z.
pub(super) fn farthest_from_mean(points: impl ExactSizeIterator<Item = DVec3> + Clone) -> usize {
    let count = points.len() as f64;
    let mean = points.clone().map(|p| p / count).sum::<DVec3>();
    let size = points.clone().map(|p| (p - mean).abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let far = |p: DVec3| ((p - mean) / size).length();
    let least = points.clone().map(far).fold(0.0, f64::max) * (1.0 - RELATIVE_TIE_TOLERANCE);
    let place = |p: DVec3| p.to_array();
    let all = points.enumerate().filter(|&(_, p)| far(p) >= least);
    let best = all.max_by(|&(_, p), &(_, q)| place(p).partial_cmp(&place(q)).unwrap_or(std::cmp::Ordering::Equal));
    best.map_or(0, |(k, _)| k)
}

/// Sections between two progress reports.
const SECTIONS_PER_REPORT: usize = 1 << 8;

/// Returns the fraction of its length after its anchor at which each section starts. If `ring`, the
/// first section follows the last. O(sections), with a comparison of 128 points with 128 for each.
pub(super) fn section_start_fractions(sections: &[AnchoredSection<'_>], ring: bool, job: &Job<'_>) -> Result<Vec<f64>> {
    let samples = alloc::try_collect(sections.iter().map(AnchoredSection::normalised_samples))?;
    let mut starts = alloc::with_capacity(sections.len())?;
    let mut start = 0.0;
    starts.push(start);
    for (k, pair) in samples.windows(2).enumerate() {
        job.step_every(SECTIONS_PER_REPORT, k, samples.len(), "finding nodes")?;
        start += best_cyclic_shift(&pair[0], &pair[1]);
        starts.push(start);
    }
    if let (true, Some(last), Some(first)) = (ring, samples.last(), samples.first()) {
        let over = start + best_cyclic_shift(last, first);
        let over = over - over.round();
        let count = sections.len() as f64;
        starts.iter_mut().zip(0..).for_each(|(start, k)| *start -= over * f64::from(k) / count);
    }
    Ok(starts)
}

/// Returns the shift of a section against the previous one, as a fraction of its length.
fn best_cyclic_shift(before: &[DVec3], section: &[DVec3]) -> f64 {
    let n = SAMPLES_PER_SECTION;
    // Both sums of squares are constant, so the largest product has the smallest distance.
    let product = |d: usize| (0..n).map(|k| before[k].dot(section[(k + d) % n])).sum::<f64>();
    let products: [f64; SAMPLES_PER_SECTION] = std::array::from_fn(product);
    let most = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let best = products.iter().position(|&product| product >= most - RELATIVE_TIE_TOLERANCE * most.abs()).unwrap_or(0);
    // Interpolate between samples by the parabola through three.
    let [left, right] = [products[(best + n - 1) % n], products[(best + 1) % n]];
    let bend = left - 2.0 * products[best] + right;
    let off = if bend < 0.0 { (0.5 * (left - right) / bend).clamp(-0.5, 0.5) } else { 0.0 };
    let shift = (best as f64 + off) / n as f64;
    if shift > 0.5 { shift - 1.0 } else { shift }
}

/// Returns the largest angle, in radians, by which a row of nodes around a body is rotated against
/// the previous row. It is the angle of the rotation about the rows' common axis that best aligns
/// them after both are centred.
pub(super) fn max_twist_between_rows(nodes: &[DVec3], columns: usize, ring: bool) -> f64 {
    let rows = nodes.len() / columns;
    let row = |k: usize| &nodes[(k % rows) * columns..(k % rows + 1) * columns];
    let pairs = if ring { rows } else { rows.saturating_sub(1) };
    (0..pairs).map(|k| aligning_rotation_angle(row(k), row(k + 1)).abs()).fold(0.0, f64::max)
}

fn aligning_rotation_angle(p: &[DVec3], q: &[DVec3]) -> f64 {
    let n = p.len();
    let mean = |row: &[DVec3]| row.iter().map(|&v| v / n as f64).sum::<DVec3>();
    let (p0, q0) = (mean(p), mean(q));
    let both = || p.iter().map(|&v| v - p0).chain(q.iter().map(|&v| v - q0));
    let size = both().map(|v| v.abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let at = |k: usize| ((p[k % n] - p0) / size, (q[k % n] - q0) / size);
    let (mut axis, mut cross, mut dot) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for k in 0..n {
        let ((u, v), (next_u, next_v)) = (at(k), at(k + 1));
        axis += u.cross(next_u) + v.cross(next_v);
        cross += u.cross(v);
        dot += u.dot(v);
    }
    libm::atan2(cross.dot(axis.normalize_or_zero()), dot)
}
