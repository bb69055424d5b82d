//! Meridians: the pairs of vertices that a strip joins.
//!
//! A set of meridians is a list of pairs (i, j) from (0, 0) to (N, M), with i on rim A and j on rim
//! B. On closed rims (N, M) is the start again. Each pair advances by one vertex on A, on B, or on
//! both. The list is a path through the lattice of all pairs: the paper's matrix H read row by row.
//! [`Meridians`] lists the ways to choose it.
//!
//! | file | subject |
//! |---|---|
//! | [`index_rule`](mod@index_rule) | the paper's rule, by index alone |
//! | `rim_pair` | the two polylines, and the lattice nodes that no path may pass |
//! | `greedy` | by arc length, and by a greedy rule |
//! | `step_metric`, `strip_bends` | costs: area, lengths; bends |
//! | `lattice_path` | the cheapest path, if the cost of a step depends only on that step |
//! | `state_search` | the cheapest path by bends, or without repeated meridians |
//! | `lattice_band`, `coarse_to_fine` | coarse-to-fine search of large lattices |

mod lattice_band;
mod strip_bends;
mod coarse_to_fine;
mod greedy;
pub mod index_rule;
mod lattice_path;
mod step_metric;
mod rim_pair;
mod state_search;
#[cfg(test)]
mod tests;

use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use index_rule::meridians_by_index_rule;
use lattice_band::LatticeBand;
pub use rim_pair::MeridianEnds;
pub(super) use rim_pair::STAGE;
pub(crate) use rim_pair::{RimPair, StepPenalty, sorted_forbidden_nodes};
use state_search::{PathCost, cheapest_path, is_simple_path};
use step_metric::StepMetric;
use strip_bends::{StripBends, weight_of_squared_lengths};

/// The choice of meridians.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Meridians {
    /// The strip of triangles that best continues both surfaces.
    ///
    /// Neighbouring triangles turn little, above all along the rims, and meridians lie on the
    /// surface that the faces beside the rims suggest. The search is limited to a band around the
    /// strip of least area. Without known faces, the result is the strip of least area.
    #[default]
    Continuation,
    /// The strip of triangles with the least area.
    MinArea,
    /// The paper's index rule: O(N + M). Good for evenly spaced rims.
    Index,
    /// A walk along both rims at the same pace, by arc length: O(N + M).
    ArcLength,
    /// A walk that always takes the shorter of the two next meridians: O(N + M).
    Greedy,
    /// The strip of triangles with the least total length of meridians.
    MinDiagonal,
    /// The strip of triangles with the least bends: the sum over its edges, including the rims, of
    /// length times (1 - cos of the angle between the normals).
    Smooth,
    /// Steps on both rims at once wherever that reduces the sum of the meridians' squared lengths
    /// (dynamic time warping). Gives quads where both sides advance, and triangles elsewhere. Meant
    /// for strips with interior rows.
    Quad,
}

choices! { for Meridians:
    Continuation => "Continuation", "The strip of triangles that best continues both surfaces.";
    MinArea => "Least area", "The strip of triangles of least area, for rims of any shape.";
    Index => "By index", "The rule of the paper: fastest, for evenly spaced rims.";
    ArcLength => "By arc length", "Both rims traversed in proportion to arc length: fast, for rims of similar shape.";
    Greedy => "Greedy", "Always the shorter of the two next meridians: fast.";
    MinDiagonal => "Shortest meridians", "The strip of triangles of least total length of meridians.";
    Smooth => "Least bend", "The strip of triangles that bends least, along the rims too.";
    Quad => "Quads", "Quads wherever both rims advance alike; for strips with rows.";
}

/// The effort of the search for the best meridians.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MeridianSearch {
    /// Exact up to 2^21 pairs of vertices, and coarse to fine beyond.
    ///
    /// Coarse to fine takes nearly linear time and linear memory. On smooth and on jagged rims its
    /// results were within a few hundredths of a per cent of the best. On noisy or crowded vertices
    /// it may lose several per cent.
    #[default]
    Auto,
    /// Exact. O(N M) time.
    ///
    /// Memory is one byte for each of up to 2^26 pairs of vertices, and 8 M bytes for each started
    /// block of 2^26 pairs. [`Meridians::Continuation`] and [`Meridians::Smooth`] take 2 bytes per
    /// pair, or 8 if the best strip would repeat a meridian. With more than one thread and two
    /// starts, memory doubles.
    Exact,
}

/// Lattices with more nodes are searched from coarse to fine.
const MAX_EXACT_LATTICE_NODES: usize = 1 << 21;

/// Holds the chosen meridians, which are lines from rim A to rim B. Also holds their total cost by
/// the metric of the rule.
pub(crate) struct MeridianChoice {
    pub(crate) pairs: Vec<MeridianEnds>,
    /// The cost of all meridians. Costs are comparable only for the same rims and the same
    /// [`Meridians`] rule.
    pub(crate) cost: f64,
}

/// Returns the meridians of `choice` that pass no forbidden node and, on closed rims, do not
/// repeat. Returns `None` if there are none. The index rule ignores both conditions.
pub(crate) fn choose_meridians(
    rims: &RimPair<'_>,
    choice: Meridians,
    search: MeridianSearch,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let (a, b) = (rims.a, rims.b);
    job.step(0.0, STAGE)?;
    let paper = meridians_by_index_rule(a.len() as u32 - 1, b.len() as u32 - 1)?;
    job.step(0.0, STAGE)?;
    let area = StepMetric::area_with_tie_break(a, b, &paper);
    let chosen =
        |metric: StepMetric, pairs: Vec<MeridianEnds>| MeridianChoice { cost: metric.path_cost(a, b, &pairs), pairs };
    let simple = match choice {
        Meridians::Index => return Ok(Some(chosen(area, paper))),
        Meridians::ArcLength => greedy::arc_length_meridians(rims)?,
        Meridians::Greedy => greedy::greedy_meridians(rims)?,
        Meridians::Continuation => return meridians_of_best_continuation(rims, &paper, search, job),
        Meridians::MinArea => return cheapest_meridians(rims, area, search, job),
        Meridians::MinDiagonal => return cheapest_meridians(rims, StepMetric::Diagonal, search, job),
        Meridians::Quad => return cheapest_meridians(rims, StepMetric::Quad, search, job),
        Meridians::Smooth => return smoothest_meridians(rims, &paper, search, job),
    };
    if is_simple_path(rims, &simple) && !simple.iter().any(|&pair| rims.is_forbidden(pair)) {
        return Ok(Some(chosen(StepMetric::Diagonal, simple)));
    }
    cheapest_meridians(rims, StepMetric::Diagonal, search, job)
}

/// Half the width of the band for other meridians.
const NEAR_PATH_HALF_BAND_NODES: usize = 32;

/// Returns the best meridians near `path`, with penalties on some steps. Minimises the area, the
/// total length or the bends for those choices, and maximises the continuation for all others.
pub(crate) fn choose_meridians_near_path(
    rims: &RimPair<'_>,
    choice: Meridians,
    path: &[MeridianEnds],
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let paper = meridians_by_index_rule(n as u32, m as u32)?;
    let band = LatticeBand::around_path(path, n, m, NEAR_PATH_HALF_BAND_NODES)?;
    let metric = match choice {
        Meridians::MinArea => StepMetric::area_with_tie_break(rims.a, rims.b, &paper),
        Meridians::MinDiagonal => StepMetric::Diagonal,
        _ => {
            let tie = weight_of_squared_lengths(rims, &paper);
            let bends = match choice {
                Meridians::Smooth => StripBends::for_least_bends(rims, tie)?,
                _ => StripBends::for_best_continuation(rims, tie)?,
            };
            return least_bends_in_band(rims, &bends, &band, None, job);
        }
    };
    let found = cheapest_path(rims, &PathCost::StepCosts(metric), &band, rims.closed, None, job)?;
    Ok(found.map(|(cost, pairs)| MeridianChoice { cost, pairs }))
}

/// Returns the cheapest path for a metric that depends only on each step.
fn cheapest_meridians(
    rims: &RimPair<'_>,
    metric: StepMetric,
    search: MeridianSearch,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let find = |rims: &RimPair<'_>, band: &LatticeBand, job: &Job<'_>| match lattice_path::cheapest_path(
        rims,
        metric,
        band,
        &job.sub_job(0.0, 0.5),
    )? {
        // The best of all paths is usually proper, and is then the best proper path.
        Some(path) if !is_simple_path(rims, &path) => {
            Ok(cheapest_path(rims, &PathCost::StepCosts(metric), band, true, None, &job.sub_job(0.5, 1.0))?
                .map(|(_, path)| path))
        }
        found => Ok(found),
    };
    let pairs = search_lattice(rims, search, &find, job)?;
    Ok(pairs.map(|pairs| MeridianChoice { cost: metric.path_cost(rims.a, rims.b, &pairs), pairs }))
}

/// Returns the path with the least bends.
fn smoothest_meridians(
    rims: &RimPair<'_>,
    paper: &[MeridianEnds],
    search: MeridianSearch,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let cost = std::cell::Cell::new(f64::INFINITY);
    let tie = weight_of_squared_lengths(rims, paper);
    let find = |rims: &RimPair<'_>, band: &LatticeBand, job: &Job<'_>| {
        let found = least_bends_in_band(rims, &StripBends::for_least_bends(rims, tie)?, band, None, job)?;
        Ok(found.map(|found| {
            cost.set(found.cost);
            found.pairs
        }))
    };
    let pairs = search_lattice(rims, search, &find, job)?;
    Ok(pairs.map(|pairs| MeridianChoice { cost: cost.get(), pairs }))
}

/// Half the width of the band around the strip of least area in which the best continuation is
/// searched, in places on either rim.
const GUIDE_HALF_BAND_NODES: usize = 16;

/// Returns the path of the best continuation, near the strip of least area unless the search is
/// exact.
fn meridians_of_best_continuation(
    rims: &RimPair<'_>,
    paper: &[MeridianEnds],
    search: MeridianSearch,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let guide = cheapest_meridians(
        rims,
        StepMetric::area_with_tie_break(rims.a, rims.b, paper),
        search,
        &job.sub_job(0.0, 0.5),
    )?;
    match guide {
        Some(guide) if rims.has_faces_along_rims() => {
            let first = (search != MeridianSearch::Exact).then_some(guide.pairs[1]);
            let band = match search {
                MeridianSearch::Auto => {
                    LatticeBand::around_path(&guide.pairs, rims.a.len() - 1, rims.b.len() - 1, GUIDE_HALF_BAND_NODES)?
                }
                MeridianSearch::Exact => LatticeBand::whole_lattice(rims.a.len() - 1, rims.b.len() - 1)?,
            };
            let bends = StripBends::for_best_continuation(rims, weight_of_squared_lengths(rims, paper))?;
            let found = least_bends_in_band(rims, &bends, &band, first, &job.sub_job(0.5, 1.0))?;
            Ok(Some(found.unwrap_or(guide)))
        }
        guide => Ok(guide),
    }
}

/// Returns the path of least bends within `band`. `first` is the end of its first step, if given.
fn least_bends_in_band(
    rims: &RimPair<'_>,
    bends: &StripBends<'_>,
    band: &LatticeBand,
    first: Option<MeridianEnds>,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let cost = PathCost::Bends(bends);
    // The best of all paths is usually proper, and is then the best proper path.
    let found = match cheapest_path(rims, &cost, band, false, first, &job.sub_job(0.0, 0.5))? {
        Some((_, path)) if !is_simple_path(rims, &path) => {
            cheapest_path(rims, &cost, band, true, first, &job.sub_job(0.5, 1.0))?
        }
        found => found,
    };
    Ok(found.map(|(cost, pairs)| MeridianChoice { cost, pairs }))
}

/// Searches the whole lattice, or from coarse to fine.
fn search_lattice(
    rims: &RimPair<'_>,
    search: MeridianSearch,
    find: &impl Fn(&RimPair<'_>, &LatticeBand, &Job<'_>) -> Result<Option<Vec<MeridianEnds>>>,
    job: &Job<'_>,
) -> Result<Option<Vec<MeridianEnds>>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    if search == MeridianSearch::Auto && (n + 1) * (m + 1) > MAX_EXACT_LATTICE_NODES {
        return coarse_to_fine::search_coarse_to_fine(rims, find, job);
    }
    find(rims, &LatticeBand::whole_lattice(n, m)?, job)
}
