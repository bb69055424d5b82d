//! Pairs of rim samples of two pieces.

use super::sample_pairs::{PosedPiece, SAMPLES_PER_REPORT, STAGE, SamplePair, SamplePairList, SamplePairReport};
use super::sampled_rims::{MIN_RIM_NORMAL_COSINE, SampledRims};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;

/// Pairs each rim sample of `a` with the nearest rim sample of `b`, at most `max_distance` away.
/// Pairs at most `max_on_surface_distance` apart count as on the surface.
pub(super) fn find_rim_sample_pairs(
    a: &PosedPiece<'_>,
    rim: &SampledRims,
    b: &PosedPiece<'_>,
    (other, tree): (&SampledRims, &KdTree<'_>),
    max_distance: f64,
    max_on_surface_distance: f64,
    job: &Job<'_>,
) -> Result<SamplePairReport> {
    let across = a.pose.followed_by(&b.pose.inverse());
    let mut list = SamplePairList { entries: 2, samples: rim.points.len(), ..SamplePairList::default() };
    list.pairs = alloc::with_capacity(2 * rim.points.len())?;
    for k in 0..rim.points.len() {
        job.step_every(SAMPLES_PER_REPORT, k, rim.points.len(), STAGE)?;
        let at = across.transform_point(rim.points[k]);
        let (along, normal) = (across.rotate_direction(rim.directions[k]), across.rotate_direction(rim.normals[k]));
        let runs_against = |w: u32| other.directions[w as usize].dot(along) < -MIN_RIM_NORMAL_COSINE;
        let Some((squared, w)) = tree.nearest(at, max_distance * max_distance, runs_against) else {
            continue;
        };
        let n = other.normals[w as usize];
        let cosine = normal.dot(n);
        if cosine < MIN_RIM_NORMAL_COSINE {
            list.opposite += usize::from(cosine < -MIN_RIM_NORMAL_COSINE);
            continue;
        }
        let up = (normal + n).normalize_or(n);
        let aside = other.directions[w as usize].cross(up).normalize_or_zero();
        let points = [at, other.points[w as usize]].map(|p| b.pose.transform_point(p));
        for direction in [up, aside] {
            list.pairs.push(SamplePair::new(points, b.pose.rotate_direction(direction)));
        }
        list.normal_deviation_sum += 1.0 - cosine;
        list.squared_distance_sum += squared;
    }
    SamplePairReport::new(&list, [a, b], rim.step, max_on_surface_distance)
}
