//! Which samples of a piece's rims lie along the rims of another one.

use super::sample_pairs::{Found, Met, Pair, Placed, SAMPLES_PER_REPORT, STAGE};
use super::sampled_rim::{MIN_COSINE, Rim};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;

/// Looks for the rims of `a` along those of `b`, up to a distance.
pub(super) fn look_along(
    a: &Placed<'_>,
    rim: &Rim,
    b: &Placed<'_>,
    (other, tree): (&Rim, &KdTree<'_>),
    gate: f64,
    reach: f64,
    job: &Job<'_>,
) -> Result<Found> {
    let across = a.pose.then(&b.pose.inverse());
    let mut met = Met { entries: 2, samples: rim.points.len(), ..Met::default() };
    met.pairs = alloc::with_capacity(2 * rim.points.len())?;
    for k in 0..rim.points.len() {
        job.step_every(SAMPLES_PER_REPORT, k, rim.points.len(), STAGE)?;
        let at = across.point(rim.points[k]);
        let (along, normal) = (across.direction(rim.directions[k]), across.direction(rim.normals[k]));
        let runs_against = |w: u32| other.directions[w as usize].dot(along) < -MIN_COSINE;
        let Some((squared, w)) = tree.nearest(at, gate * gate, runs_against) else {
            continue;
        };
        let n = other.normals[w as usize];
        let cosine = normal.dot(n);
        if cosine < MIN_COSINE {
            met.opposite += usize::from(cosine < -MIN_COSINE);
            continue;
        }
        let up = (normal + n).normalize_or(n);
        let aside = other.directions[w as usize].cross(up).normalize_or_zero();
        let points = [at, other.points[w as usize]].map(|p| b.pose.point(p));
        for direction in [up, aside] {
            met.pairs.push(Pair::new(points, b.pose.direction(direction)));
        }
        met.turn += 1.0 - cosine;
        met.squares += squared;
    }
    Found::of(&met, [a, b], rim.step, reach)
}
