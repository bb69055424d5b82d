//! Relative direction of two rims around the gap between them.
//!
//! Both rims have their surface on the left. If the pieces are parts of one oriented surface, the
//! rims run in opposite directions; if they run the same way, one piece is inside out. The test
//! compares the curves. Each is sampled at equal arc lengths and centred, and the second is fitted
//! to the first in both directions, at the best rotation.

use super::facing::{area_vector_direction, centre};
use super::polyline::samples_by_arc_length;
use super::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::error::Result;

/// Number of samples of each rim.
const SAMPLES_PER_RIM: usize = 64;

/// Smallest significant difference, relative to the rims' own spread. Below it the rims double back
/// on themselves, or are nearly mirror images.
const MIN_RELATIVE_DECISION_MARGIN: f64 = 0.01;

/// Returns true if rims `a` and `b` clearly run the same way, so that their surfaces disagree in
/// orientation.
fn do_rims_run_the_same_way(a: &[DVec3], b: &[DVec3]) -> Result<bool> {
    let (p, q) = (centred_samples(a)?, centred_samples(b)?);
    // The sum of squared distances is |p|^2 + |q|^2 - 2 sum(p . q): the least distance is the
    // greatest correlation.
    let best = |sign: usize| {
        (0..SAMPLES_PER_RIM)
            .map(|shift| (0..SAMPLES_PER_RIM).map(|k| p[k].dot(q[(shift + sign * k) % SAMPLES_PER_RIM])).sum::<f64>())
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let (same, opposite) = (best(1), best(SAMPLES_PER_RIM - 1));
    let spread = |s: &[DVec3]| s.iter().map(|v| v.length_squared()).sum::<f64>();
    Ok(2.0 * (same - opposite) > MIN_RELATIVE_DECISION_MARGIN * (spread(&p) + spread(&q)))
}

/// Returns true if the surfaces of whole rims `a` and `b`, each with its surface on the left,
/// clearly disagree in orientation.
///
/// Comparing the curves works if the gap bends by less than a right angle, or if one rim lies
/// inside the other. If both rims lead off their surfaces to the same side, like the ends of a
/// U-bend, each rim is judged by itself. Its outward direction points off the surface, and the rim
/// runs either clockwise or counter-clockwise around this direction. All ends of an oriented surface
/// run the same way around.
pub fn rims_disagree(a: &Rim, b: &Rim) -> Result<bool> {
    let leads = |rim: &Rim| rim.outward.length() > MIN_MEAN_DIRECTION_LENGTH;
    if leads(a) && leads(b) && a.outward.dot(b.outward) > 0.0 && !are_rims_nested(&a.points, &b.points) {
        let (u, v) = (outward_cosine(a), outward_cosine(b));
        return Ok(u.abs().min(v.abs()) > MIN_MEAN_DIRECTION_LENGTH && u * v < 0.0);
    }
    do_rims_run_the_same_way(&a.points, &b.points)
}

/// A rim has an outward direction if the mean of its unit vectors is longer than this.
const MIN_MEAN_DIRECTION_LENGTH: f64 = 0.3;

/// Returns the cosine of the angle between a rim's area vector and its outward direction.
fn outward_cosine(rim: &Rim) -> f64 {
    area_vector_direction(&rim.points).dot(rim.outward.normalize_or_zero())
}

/// Returns true if the centres are nearer than half the greatest radius of the larger rim.
fn are_rims_nested(a: &[DVec3], b: &[DVec3]) -> bool {
    let centres = [centre(a), centre(b)];
    let radius = |points: &[DVec3], c: DVec3| points.iter().map(|p| p.distance(c)).fold(0.0, f64::max);
    let largest = radius(a, centres[0]).max(radius(b, centres[1]));
    centres[0].distance(centres[1]) < 0.5 * largest
}

/// Returns true if arcs `a` and `b`, each with its surface on the left, clearly run the same way,
/// so that their surfaces disagree in orientation. The arcs are compared side by side in both
/// directions.
pub fn arcs_run_the_same_way(a: &[DVec3], b: &[DVec3]) -> Result<bool> {
    let (p, q) = (samples_by_arc_length(a, false, SAMPLES_PER_RIM)?, samples_by_arc_length(b, false, SAMPLES_PER_RIM)?);
    let apart = |at: fn(usize) -> usize| (0..SAMPLES_PER_RIM).map(|k| p[k].distance_squared(q[at(k)])).sum::<f64>();
    let (same, opposite) = (apart(|k| k), apart(|k| SAMPLES_PER_RIM - 1 - k));
    Ok(opposite - same > MIN_RELATIVE_DECISION_MARGIN * (opposite + same))
}

/// Returns samples of a closed polyline, centred at the origin.
fn centred_samples(points: &[DVec3]) -> Result<Vec<DVec3>> {
    let mut samples = samples_by_arc_length(points, true, SAMPLES_PER_RIM)?;
    let mean = samples.iter().sum::<DVec3>() / SAMPLES_PER_RIM as f64;
    samples.iter_mut().for_each(|s| *s -= mean);
    Ok(samples)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample_circle(n: usize, turn: f64, lift: f64) -> Vec<DVec3> {
        (0..n)
            .map(|i| {
                let t = turn + std::f64::consts::TAU * i as f64 / n as f64;
                DVec3::new(t.cos(), t.sin(), lift)
            })
            .collect()
    }

    #[test]
    fn circles_of_any_count_phase_and_distance_are_recognised() {
        for (n, m) in [(3, 4), (30, 20), (100, 7), (64, 64)] {
            for lift in [0.0, 0.1, 50.0] {
                for turn in [0.0, 1.0, 4.0] {
                    let (a, mut b) = (sample_circle(n, 0.0, 0.0), sample_circle(m, turn, lift));
                    assert!(do_rims_run_the_same_way(&a, &b).unwrap(), "{n} {m} {lift} {turn}");
                    b.reverse();
                    assert!(!do_rims_run_the_same_way(&a, &b).unwrap(), "{n} {m} {lift} {turn}");
                }
            }
        }
    }

    #[test]
    fn undecided_directions_are_left_alone() {
        let line: Vec<_> = (0..10).chain((1..9).rev()).map(|i| DVec3::X * f64::from(i)).collect();
        assert!(!do_rims_run_the_same_way(&line, &line).unwrap());
        assert!(!do_rims_run_the_same_way(&[DVec3::ONE; 3], &sample_circle(5, 0.0, 0.0)).unwrap());
    }
}
