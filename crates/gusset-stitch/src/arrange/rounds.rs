//! Rounds that remove the intersections which rounding makes.

use super::exact_arrangement::ExactArrangement;
use super::solid::Solid;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// Number of rounds without fewer intersections after which the search for a better result ends.
const PATIENCE: u32 = 4;

/// The result of all rounds.
pub(super) struct Resolved {
    pub(super) solid: Solid,
    /// The pairs of triangles that still intersect.
    pub(super) intersections: Vec<[u32; 2]>,
    /// The number of rounds that changed the surface.
    pub(super) round_count: u32,
    /// The number of pairs that intersect at first.
    pub(super) intersection_count: u64,
}

/// Applies `step` to a surface and its arrangement, and again to the result until nothing intersects, at
/// most `max_rounds` times. Returns the result with the fewest intersections. `counts` tells whether a pair
/// of triangles with common points counts as one.
pub(super) fn resolve(
    mut solid: Solid,
    first: &ExactArrangement,
    scalar: Scalar,
    max_rounds: u32,
    counts: &impl Fn([u32; 3], [u32; 3]) -> bool,
    step: &impl Fn(&Solid, &ExactArrangement, &Job<'_>) -> Result<Solid>,
    job: &Job<'_>,
) -> Result<Resolved> {
    let intersections = |solid: &Solid, arrangement: &ExactArrangement| {
        let corners = |t: u32| solid.triangles[t as usize].map(|v| arrangement.first[v as usize]);
        alloc::gather(arrangement.pairs.iter().copied().filter(|&[s, t]| counts(corners(s), corners(t))))
    };
    let intersection_count = intersections(&solid, first)?.len() as u64;
    let next = step(&solid, first, &job.part(0.0, 0.4))?;
    if next.triangles == solid.triangles && next.points == solid.points {
        return Ok(Resolved { solid, intersections: Vec::new(), round_count: 0, intersection_count });
    }
    solid = next;
    let mut best: Option<Resolved> = None;
    for round in 1..=max_rounds {
        // Later rounds are shorter.
        let [start, end] = [round - 1, round].map(|round| 0.4 + 0.6 * f64::from(round) / f64::from(round + 1));
        let job = job.part(start, end);
        let mut arrangement = solid.arrange(&job.part(0.0, 0.4))?;
        let pairs = intersections(&solid, &arrangement)?;
        let is_clean = pairs.is_empty() && arrangement.parts.len() == solid.triangles.len();
        if is_clean || round == max_rounds {
            let is_best = best.as_ref().is_none_or(|held| pairs.len() <= held.intersections.len());
            let last = Resolved { solid, intersections: pairs, round_count: round, intersection_count };
            return Ok(best.filter(|_| !is_best).unwrap_or(last));
        }
        if best.as_ref().is_none_or(|held| pairs.len() < held.intersections.len()) {
            let intersections = alloc::copied(&pairs)?;
            best = Some(Resolved { solid: solid.copied()?, intersections, round_count: round, intersection_count });
        }
        if best.as_ref().is_some_and(|held| round >= held.round_count + PATIENCE) {
            break;
        }
        if solid.mend_pairs(&pairs, scalar, round)? {
            arrangement = solid.arrange(&job.part(0.5, 0.7))?;
        }
        solid = step(&solid, &arrangement, &job.part(0.7, 1.0))?;
    }
    let unsearched = Resolved { solid, intersections: Vec::new(), round_count: max_rounds, intersection_count };
    Ok(best.unwrap_or(unsearched))
}
