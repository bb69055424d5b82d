//! Rounds that remove the intersections which rounding makes.

use super::exact_arrangement::{ExactArrangement, GridTriangles};
use super::solid::Solid;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// Number of rounds without fewer intersections after which the search for a better result ends.
const MAX_ROUNDS_WITHOUT_GAIN: u32 = 4;
/// The search also ends at more than twice the fewest intersections, and this number.
const MAX_GROWTH: usize = 64;

/// The result of all rounds.
pub(super) struct Resolved {
    pub(super) solid: Solid,
    /// The pairs of triangles that still intersect.
    pub(super) intersections: Vec<[u32; 2]>,
    /// The number of rounds that changed the surface.
    pub(super) round_count: u32,
}

/// Repeats `step` until nothing intersects. Returns the result with the fewest intersections.
///
/// `step` makes a new surface from a surface and its arrangement. The step that made `solid` is the first of at most
/// `max_rounds` rounds. `is_counted` tells whether two triangles with common points count as an intersection.
pub(super) fn resolve_intersections(
    mut solid: Solid,
    scalar: Scalar,
    max_rounds: u32,
    is_counted: &impl Fn([u32; 3], [u32; 3]) -> bool,
    step: &impl Fn(&Solid, &ExactArrangement, &Job<'_>) -> Result<Solid>,
    job: &Job<'_>,
) -> Result<Resolved> {
    let mut best: Option<Resolved> = None;
    for round in 1..=max_rounds {
        // Later rounds are shorter.
        let [start, end] = [round - 1, round].map(|round| f64::from(round) / f64::from(round + 1));
        let job = job.sub_job(start, end);
        let mut found = solid.find_pairs(&job.sub_job(0.0, 0.3))?;
        let intersections = counted_pairs(&solid, &found, is_counted)?;
        if intersections.is_empty() && !found.has_degenerate {
            return Ok(Resolved { solid, intersections, round_count: round });
        }
        if best.as_ref().is_none_or(|held| intersections.len() < held.intersections.len()) {
            let solid = solid.copied()?;
            best = Some(Resolved { solid, intersections, round_count: round });
        } else if best.as_ref().is_some_and(|held| {
            round >= held.round_count + MAX_ROUNDS_WITHOUT_GAIN
                || intersections.len() > 2 * held.intersections.len() + MAX_GROWTH
        }) {
            break;
        }
        if round == max_rounds {
            break;
        }
        if solid.mend_pairs(&found.pairs, scalar, round)? {
            found = solid.find_pairs(&job.sub_job(0.3, 0.5))?;
        }
        solid = step(&solid, &found.arrange(&job.sub_job(0.5, 0.7))?, &job.sub_job(0.7, 1.0))?;
    }
    let unsearched = Resolved { solid, intersections: Vec::new(), round_count: max_rounds };
    Ok(best.unwrap_or(unsearched))
}

/// Returns the pairs of triangles that `is_counted` accepts as intersections.
pub(super) fn counted_pairs(
    solid: &Solid,
    found: &GridTriangles,
    is_counted: &impl Fn([u32; 3], [u32; 3]) -> bool,
) -> Result<Vec<[u32; 2]>> {
    let corners = |t: u32| solid.triangles[t as usize].map(|v| found.first_vertex_at_position[v as usize]);
    alloc::gather(found.pairs.iter().copied().filter(|&[s, t]| is_counted(corners(s), corners(t))))
}
