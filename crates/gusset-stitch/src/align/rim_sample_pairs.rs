//! Pairs of rim samples of two pieces.

use super::sample_pairs::{Pair, PairList, PairReport, Placed, SAMPLES_PER_REPORT, STAGE};
use super::sampled_rim::{MIN_COSINE, SampledRim};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;

/// Finds the samples of the rims of `a` along the rims of `b`, up to a distance.
pub(super) fn find_rim_pairs(
    a: &Placed<'_>,
    rim: &SampledRim,
    b: &Placed<'_>,
    (other, tree): (&SampledRim, &KdTree<'_>),
    gate: f64,
    reach: f64,
    job: &Job<'_>,
) -> Result<PairReport> {
    let across = a.pose.then(&b.pose.inverse());
    let mut list = PairList { entries: 2, samples: rim.points.len(), ..PairList::default() };
    list.pairs = alloc::with_capacity(2 * rim.points.len())?;
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
            list.opposite += usize::from(cosine < -MIN_COSINE);
            continue;
        }
        let up = (normal + n).normalize_or(n);
        let aside = other.directions[w as usize].cross(up).normalize_or_zero();
        let points = [at, other.points[w as usize]].map(|p| b.pose.point(p));
        for direction in [up, aside] {
            list.pairs.push(Pair::new(points, b.pose.direction(direction)));
        }
        list.turn += 1.0 - cosine;
        list.squares += squared;
    }
    PairReport::new(&list, [a, b], rim.step, reach)
}
