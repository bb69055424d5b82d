//! Meridians: the pairs of vertices that a strip joins.
//!
//! A set of meridians is a list of pairs (i, j), i = 0..=N on rim A and j = 0..=M on rim B,
//! from (0, 0) to (N, M) (the start again, if the rims are closed), in which each pair advances
//! by one vertex on A, on B, or on both. It is a path through the lattice of all pairs, and the
//! paper's matrix H read row by row. [`Meridians`] lists the ways to choose it.
//!
//! | file | subject |
//! |---|---|
//! | [`index_rule`](mod@index_rule) | the paper's rule, by index alone |
//! | `rim_pair` | the two polylines, and the lattice nodes that no path may pass |
//! | `greedy` | by arc length, and greedily |
//! | `metric`, `bend` | costs: area, lengths; bends |
//! | `lattice` | the cheapest path, where the cost of a step depends on that step alone |
//! | `states` | the cheapest path by bends, or without using a meridian twice |
//! | `band`, `coarse` | coarse-to-fine search of large lattices |

mod band;
mod bend;
mod coarse;
mod greedy;
pub mod index_rule;
mod lattice;
mod metric;
mod rim_pair;
mod states;
#[cfg(test)]
mod tests;

use band::Band;
use bend::{Bends, tie_break};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use index_rule::index_meridians;
use metric::Metric;
pub use rim_pair::Pair;
pub(super) use rim_pair::STAGE;
pub(crate) use rim_pair::{RimPair, StepPenalty, forbidden_nodes};
use states::{Cost, cheapest, is_simple};

/// How meridians are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Meridians {
    /// The strip of triangles that best continues both surfaces: little turn between neighbours,
    /// along the rims above all, and meridians that lie on the surface which the faces beside the
    /// rims suggest. It is looked for near the strip of least area, which is also the answer where
    /// no faces are known.
    #[default]
    Continuation,
    /// The strip of triangles of least area.
    MinArea,
    /// The paper's rule by index: O(N + M). Good for evenly spaced rims.
    Index,
    /// Both rims walked at the same pace, by arc length: O(N + M).
    ArcLength,
    /// Always on to the shorter of the two next meridians: O(N + M).
    Greedy,
    /// The strip of triangles whose meridians have the least total length.
    MinDiagonal,
    /// The strip of triangles with the least bends: the sum over its edges, rims included, of
    /// length times (1 - cos of the angle between the normals).
    Smooth,
    /// Steps on both rims at once wherever that makes the sum of the meridians' squared lengths
    /// less (dynamic time warping): quads where both sides advance, triangles elsewhere. Meant for
    /// strips with interior rows.
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

/// How hard the best meridians are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Search {
    /// Exactly for up to 2^21 pairs of vertices, beyond that coarse to fine: nearly linear time and
    /// linear memory, and a result that was within a few hundredths of a per cent of the best on
    /// smooth and on jagged rims; where vertices are noise or crowd together it may lose several
    /// per cent.
    #[default]
    Auto,
    /// Exactly: O(N M) time, one byte of memory for each of up to 2^26 pairs of vertices, and 8 M
    /// bytes for each 2^26 pairs begun; 2 bytes for each pair with [`Meridians::Continuation`] and
    /// [`Meridians::Smooth`]; 8 where the best strip would use a meridian twice. With more than one
    /// thread and two starts, twice that.
    Exact,
}

/// Lattices of more nodes than this are searched coarse to fine.
const MAX_EXACT_NODES: usize = 1 << 21;

/// Meridians, and what they cost in the measure of their choice.
pub(crate) struct MeridianChoice {
    pub(crate) pairs: Vec<Pair>,
    /// To be compared with others of the same rims and choice only.
    pub(crate) cost: f64,
}

/// The meridians of `choice` that pass no forbidden node, and of closed rims use none twice; `None`
/// if there are none. The rule by index minds neither.
pub(crate) fn meridians(
    rims: &RimPair<'_>,
    choice: Meridians,
    search: Search,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let (a, b) = (rims.a, rims.b);
    job.step(0.0, STAGE)?;
    let paper = index_meridians(a.len() as u32 - 1, b.len() as u32 - 1)?;
    job.step(0.0, STAGE)?;
    let area = Metric::area(a, b, &paper);
    let chosen = |metric: Metric, pairs: Vec<Pair>| MeridianChoice { cost: metric.of_path(a, b, &pairs), pairs };
    let simple = match choice {
        Meridians::Index => return Ok(Some(chosen(area, paper))),
        Meridians::ArcLength => greedy::by_arc_length(rims)?,
        Meridians::Greedy => greedy::greedily(rims)?,
        Meridians::Continuation => return continuation(rims, &paper, search, job),
        Meridians::MinArea => return additive(rims, area, search, job),
        Meridians::MinDiagonal => return additive(rims, Metric::Diagonal, search, job),
        Meridians::Quad => return additive(rims, Metric::Quad, search, job),
        Meridians::Smooth => return smooth(rims, &paper, search, job),
    };
    if is_simple(rims, &simple) && !simple.iter().any(|&pair| rims.is_forbidden(pair)) {
        return Ok(Some(chosen(Metric::Diagonal, simple)));
    }
    additive(rims, Metric::Diagonal, search, job)
}

/// Half the width of the band in which other meridians are looked for.
const NEAR_HALF_BAND: usize = 32;

/// The best meridians near `path`, where some steps may have penalties: those of the strip of least area,
/// of the least total length, or of the best continuation, which stands for all others.
pub(crate) fn meridians_near(
    rims: &RimPair<'_>,
    choice: Meridians,
    path: &[Pair],
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let paper = index_meridians(n as u32, m as u32)?;
    let band = Band::around(path, n, m, NEAR_HALF_BAND)?;
    let metric = match choice {
        Meridians::MinArea => Metric::area(rims.a, rims.b, &paper),
        Meridians::MinDiagonal => Metric::Diagonal,
        _ => return best_continuation(rims, &paper, &band, None, job),
    };
    let found = cheapest(rims, &Cost::StepCosts(metric), &band, rims.closed, None, job)?;
    Ok(found.map(|(cost, pairs)| MeridianChoice { cost, pairs }))
}

/// The cheapest path for a metric that depends on each step alone.
fn additive(rims: &RimPair<'_>, metric: Metric, search: Search, job: &Job<'_>) -> Result<Option<MeridianChoice>> {
    let find = |rims: &RimPair<'_>, band: &Band, job: &Job<'_>| match lattice::cheapest(
        rims,
        metric,
        band,
        &job.part(0.0, 0.5),
    )? {
        // The best of all paths is usually proper, and then the best of the proper ones.
        Some(path) if !is_simple(rims, &path) => {
            Ok(cheapest(rims, &Cost::StepCosts(metric), band, true, None, &job.part(0.5, 1.0))?.map(|(_, path)| path))
        }
        found => Ok(found),
    };
    let pairs = search_lattice(rims, search, &find, job)?;
    Ok(pairs.map(|pairs| MeridianChoice { cost: metric.of_path(rims.a, rims.b, &pairs), pairs }))
}

/// The path of the least bends.
fn smooth(rims: &RimPair<'_>, paper: &[Pair], search: Search, job: &Job<'_>) -> Result<Option<MeridianChoice>> {
    let cost = std::cell::Cell::new(f64::INFINITY);
    let tie = tie_break(rims, paper);
    let find = |rims: &RimPair<'_>, band: &Band, job: &Job<'_>| {
        let (first, second) = (job.part(0.0, 0.5), job.part(0.5, 1.0));
        let bends = Bends::smooth(rims, tie)?;
        // As with the others: the best of all paths is usually proper.
        let found = match cheapest(rims, &Cost::Bends(&bends), band, false, None, &first)? {
            Some((_, path)) if !is_simple(rims, &path) => {
                cheapest(rims, &Cost::Bends(&bends), band, true, None, &second)?
            }
            found => found,
        };
        Ok(found.map(|(least, path)| {
            cost.set(least);
            path
        }))
    };
    let pairs = search_lattice(rims, search, &find, job)?;
    Ok(pairs.map(|pairs| MeridianChoice { cost: cost.get(), pairs }))
}

/// How far from the strip of least area the best continuation is looked for, in places on either
/// rim.
const GUIDE_HALF_BAND: usize = 16;

/// The path of the best continuation, near that of least area unless the search is to be exact.
fn continuation(rims: &RimPair<'_>, paper: &[Pair], search: Search, job: &Job<'_>) -> Result<Option<MeridianChoice>> {
    let guide = additive(rims, Metric::area(rims.a, rims.b, paper), search, &job.part(0.0, 0.5))?;
    match guide {
        Some(guide) if rims.has_sides() => {
            let first = (search != Search::Exact).then_some(guide.pairs[1]);
            let band = match search {
                Search::Auto => Band::around(&guide.pairs, rims.a.len() - 1, rims.b.len() - 1, GUIDE_HALF_BAND)?,
                Search::Exact => Band::full(rims.a.len() - 1, rims.b.len() - 1)?,
            };
            let found = best_continuation(rims, paper, &band, first, &job.part(0.5, 1.0))?;
            Ok(Some(found.unwrap_or(guide)))
        }
        guide => Ok(guide),
    }
}

/// The best continuation within `band`; `first`: the end of its first step, where that is given.
fn best_continuation(
    rims: &RimPair<'_>,
    paper: &[Pair],
    band: &Band,
    first: Option<Pair>,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    let bends = Bends::continuation(rims, tie_break(rims, paper))?;
    let cost = Cost::Bends(&bends);
    let found = match cheapest(rims, &cost, band, false, first, &job.part(0.0, 0.5))? {
        Some((_, path)) if !is_simple(rims, &path) => cheapest(rims, &cost, band, true, first, &job.part(0.5, 1.0))?,
        found => found,
    };
    Ok(found.map(|(cost, pairs)| MeridianChoice { cost, pairs }))
}

/// Searches the whole lattice, or coarse to fine.
fn search_lattice(
    rims: &RimPair<'_>,
    search: Search,
    find: &impl Fn(&RimPair<'_>, &Band, &Job<'_>) -> Result<Option<Vec<Pair>>>,
    job: &Job<'_>,
) -> Result<Option<Vec<Pair>>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    if search == Search::Auto && (n + 1) * (m + 1) > MAX_EXACT_NODES {
        return coarse::coarse_to_fine(rims, find, job);
    }
    find(rims, &Band::full(n, m)?, job)
}
