//! The first meridian of closed rims.
//!
//! The paper does not say how to pair the starts of the rims. Two candidates are tried. The first
//! is the closest pair of vertices. The second is the closest pair after the best rotation of one
//! rim onto the other. They differ if one rim comes near the other in an unrelated place. The
//! meridians from both candidates are searched, and the better ones are kept.

use super::existing_edges::ExistingEdges;
use super::polyline::{lengths, samples_by_arc_length};
use super::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use rustfft::algorithm::Radix4;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftDirection};

/// The first meridians to try.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Start {
    /// The closest pair, and the pair by rotation. The better strip is kept.
    #[default]
    Auto,
    /// The closest pair only.
    Closest,
}

/// Number of vertices between two progress reports. A search is slow if all vertices are about
/// equally far.
const SEARCHES_PER_REPORT: usize = 1 << 7;

/// Number of vertices between two progress reports when arc lengths are looked up.
const LENGTHS_PER_REPORT: usize = 1 << 18;

const STAGE: &str = "looking for the closest pair";

/// Number of samples of each rim for the rotation.
const SAMPLES_PER_RIM: usize = 1 << 10;

/// Returns the places (i, j) of the closest vertices of the two rims that are not yet joined by an
/// edge. Among equally close pairs the smallest i wins, then the smallest j. Returns `None` if
/// every pair is joined. O((N + M) log M).
pub(super) fn closest_vertex_pair(
    a: &Rim,
    b: &Rim,
    existing: &ExistingEdges,
    job: &Job<'_>,
) -> Result<Option<(usize, usize)>> {
    let tree = KdTree::new(&b.points, &job.sub_job(0.0, 0.1), STAGE)?;
    let job = job.sub_job(0.1, 1.0);
    let mut best = (f64::INFINITY, None);
    for (i, (&p, &u)) in a.points.iter().zip(&a.vertices).enumerate() {
        job.step_every(SEARCHES_PER_REPORT, i, a.points.len(), STAGE)?;
        let found = tree.nearest(p, best.0, |j| !existing.contains(u, b.vertices[j as usize]));
        if let Some((distance, j)) = found
            && (distance < best.0 || best.1.is_none())
        {
            best = (distance, Some((i, j as usize)));
        }
    }
    Ok(best.1)
}

/// Returns the places (i, j) of the closest vertices after the best rotation, if no edge joins them
/// yet. The rotation of rim B along rim A minimises the sum of squared distances between points at
/// equal arc lengths. The rims run side by side. O(N log M), plus a Fourier transform of
/// [`SAMPLES_PER_RIM`] samples.
pub(super) fn vertex_pair_by_best_rotation(
    a: &Rim,
    b: &Rim,
    existing: &ExistingEdges,
    job: &Job<'_>,
) -> Result<Option<(usize, usize)>> {
    let shift = best_rotation_fraction(
        &samples_by_arc_length(&a.points, true, SAMPLES_PER_RIM)?,
        &samples_by_arc_length(&b.points, true, SAMPLES_PER_RIM)?,
    );
    job.step(0.0, STAGE)?;
    let (along_a, along_b) = (arc_fractions(&a.points)?, arc_fractions(&b.points)?);
    let m = b.points.len();
    let mut best = (f64::INFINITY, None);
    for (i, &t) in along_a.iter().enumerate() {
        job.step_every(LENGTHS_PER_REPORT, i, along_a.len(), STAGE)?;
        let t = t + shift;
        let t = if t < 1.0 { t } else { t - 1.0 };
        let after = along_b.partition_point(|&s| s < t);
        for j in [(after + m - 1) % m, after % m] {
            let distance = a.points[i].distance_squared(b.points[j]);
            if distance < best.0 && !existing.contains(a.vertices[i], b.vertices[j]) {
                best = (distance, Some((i, j)));
            }
        }
    }
    Ok(best.1)
}

/// Returns the fraction of `q`'s length at which the point that matches the start of `p` lies.
///
/// Minimising the sum of |p_k - q_(k + s)|^2 is maximising the correlation sum of p_k . q_(k + s).
/// For all s at once this is the inverse transform of conj(P) Q. The number of samples is a power
/// of two. The transform uses no platform-specific vector instructions, so that all platforms give
/// the same bits.
fn best_rotation_fraction(p: &[DVec3], q: &[DVec3]) -> f64 {
    let n = p.len();
    let [forward, inverse] = [FftDirection::Forward, FftDirection::Inverse].map(|way| Radix4::new(n, way));
    let mut product = vec![Complex::new(0.0, 0.0); n];
    for axis in 0..3 {
        let transformed = |points: &[DVec3]| {
            let mut values: Vec<_> = points.iter().map(|v| Complex::new(v[axis], 0.0)).collect();
            forward.process(&mut values);
            values
        };
        for (sum, (u, v)) in product.iter_mut().zip(transformed(p).into_iter().zip(transformed(q))) {
            *sum += u.conj() * v;
        }
    }
    inverse.process(&mut product);
    let mut best = 0;
    for (s, value) in product.iter().enumerate() {
        if value.re > product[best].re {
            best = s;
        }
    }
    best as f64 / n as f64
}

/// Returns, for each point of a closed polyline, the fraction of the length before it.
fn arc_fractions(points: &[DVec3]) -> Result<Vec<f64>> {
    let mut along = lengths(points, true)?;
    if let Some(length) = along.pop().filter(|&length| length > 0.0) {
        along.iter_mut().for_each(|t| *t /= length);
    }
    Ok(along)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_of_a_wavy_ring_is_found() {
        let ring = |turn: f64| -> Vec<DVec3> {
            let point = |i: usize| {
                let t = std::f64::consts::TAU * (i as f64 / SAMPLES_PER_RIM as f64 + turn);
                DVec3::new(t.cos(), t.sin(), 0.3 * (3.0 * t).sin() + 0.2 * (2.0 * t).cos())
            };
            (0..SAMPLES_PER_RIM).map(point).collect()
        };
        for turn in [0.0, 0.125, 0.5, 0.984375] {
            // The start of the first ring lies at -turn on the second.
            assert_eq!(best_rotation_fraction(&ring(0.0), &ring(turn)), (1.0 - turn) % 1.0);
        }
    }
}
