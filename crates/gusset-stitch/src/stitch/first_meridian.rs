//! The first meridian of closed rims.
//!
//! The paper leaves the pairing of the rims' starts open. Two candidates are tried: the closest
//! pair of vertices, and the closest pair after the rotation that fits the rims to each other
//! best, which differs where one rim comes near the other in an unrelated place. Meridians are
//! found from both, and the better ones kept.

use super::polyline::{lengths, samples};
use super::stitch_rim::{Bridges, Rim};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use rustfft::algorithm::Radix4;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftDirection};

/// Which first meridians are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Start {
    /// The closest pair, and the one by rotation; the better strip is kept.
    #[default]
    Auto,
    /// The closest pair.
    Closest,
}

/// Vertices between two progress reports: where all are about equally far, each takes long.
const REPORT_INTERVAL: usize = 1 << 7;

/// The same where places along the other rim are looked up.
const LENGTHS_PER_REPORT: usize = 1 << 18;

const STAGE: &str = "looking for the closest pair";

/// Samples of each rim for the rotation.
const SAMPLES: usize = 1 << 10;

/// The places (i, j) of the closest vertices of the two rims that are not joined by an edge
/// already; of equally close pairs the smallest i, then j. `None` if every pair is joined. O((N +
/// M) log M).
pub(super) fn closest_pair(a: &Rim, b: &Rim, bridges: &Bridges, job: &Job<'_>) -> Result<Option<(usize, usize)>> {
    let tree = KdTree::new(&b.points, &job.part(0.0, 0.1), STAGE)?;
    let job = job.part(0.1, 1.0);
    let mut best = (f64::INFINITY, None);
    for (i, (&p, &u)) in a.points.iter().zip(&a.vertices).enumerate() {
        job.step_every(REPORT_INTERVAL, i, a.points.len(), STAGE)?;
        let found = tree.nearest(p, best.0, |j| !bridges.has(u, b.vertices[j as usize]));
        if let Some((distance, j)) = found
            && (distance < best.0 || best.1.is_none())
        {
            best = (distance, Some((i, j as usize)));
        }
    }
    Ok(best.1)
}

/// The places (i, j) of the closest vertices, not joined by an edge already, among those that meet
/// when rim B is turned along rim A so that the sum of squared distances between points at equal
/// arc lengths is least. The rims run side by side. O(N log M), and a Fourier transform of
/// [`SAMPLES`] samples.
pub(super) fn by_rotation(a: &Rim, b: &Rim, bridges: &Bridges, job: &Job<'_>) -> Result<Option<(usize, usize)>> {
    let shift = best_shift(&samples(&a.points, true, SAMPLES)?, &samples(&b.points, true, SAMPLES)?);
    job.step(0.0, STAGE)?;
    let (along_a, along_b) = (parts(&a.points)?, parts(&b.points)?);
    let m = b.points.len();
    let mut best = (f64::INFINITY, None);
    for (i, &t) in along_a.iter().enumerate() {
        job.step_every(LENGTHS_PER_REPORT, i, along_a.len(), STAGE)?;
        let t = t + shift;
        let t = if t < 1.0 { t } else { t - 1.0 };
        let after = along_b.partition_point(|&s| s < t);
        for j in [(after + m - 1) % m, after % m] {
            let distance = a.points[i].distance_squared(b.points[j]);
            if distance < best.0 && !bridges.has(a.vertices[i], b.vertices[j]) {
                best = (distance, Some((i, j)));
            }
        }
    }
    Ok(best.1)
}

/// How far along `q`, as a part of its length, the point lies that belongs to the start of `p`.
///
/// The sum of |p_k - q_(k + s)|^2 is least where the correlation sum of p_k . q_(k + s) is
/// greatest, and that is for all s at once the inverse transform of conj(P) Q. A power of two of
/// samples; without vector instructions of its own: the same bits anywhere.
fn best_shift(p: &[DVec3], q: &[DVec3]) -> f64 {
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

/// The part of a closed polyline's length that lies before each of its points.
fn parts(points: &[DVec3]) -> Result<Vec<f64>> {
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
                let t = std::f64::consts::TAU * (i as f64 / SAMPLES as f64 + turn);
                DVec3::new(t.cos(), t.sin(), 0.3 * (3.0 * t).sin() + 0.2 * (2.0 * t).cos())
            };
            (0..SAMPLES).map(point).collect()
        };
        for turn in [0.0, 0.125, 0.5, 0.984375] {
            // The start of the first lies at -turn on the second.
            assert_eq!(best_shift(&ring(0.0), &ring(turn)), (1.0 - turn) % 1.0);
        }
    }
}
