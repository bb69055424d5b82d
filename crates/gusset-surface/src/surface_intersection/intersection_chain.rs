//! Joins arcs to paths: removes duplicate arcs, and joins ends that are the same point.
//!
//! Cost: O(n log n) for n arcs.

use super::arc_links::{ArcChain, ArcLinks};
use super::chain_bridges::{ChainsWithBalls, IntersectedSurfaces, JoinedCrossings};
use super::contact::{CriticalPoints, EXPLAINED_AS_APART, NOT_EXPLAINED};
use super::pair_search::{FoundArcsAndBalls, IntersectionArc};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;
use gusset_base::sort;
use std::ops::ControlFlow;

/// Largest number of neighbours compared with a point. More neighbours are copies of the point.
const MAX_COMPARED_NEIGHBOURS: usize = 64;

/// Number of points between two progress reports.
const ENDS_PER_REPORT: usize = 1 << 12;

/// Largest number of points with similar positions along a direction that are compared pairwise.
/// For more points, a tree is faster.
const MAX_PAIRWISE_COMPARED_POINTS: usize = 16;

/// Finds the pairs of points at most `within` apart, with their distances.
///
/// Points are sorted along a direction that is not an axis. In a run of more than
/// [`MAX_PAIRWISE_COMPARED_POINTS`] points with similar positions in this order, a tree finds the
/// pairs. There, each point is compared with at most [`MAX_COMPARED_NEIGHBOURS`] neighbours.
pub(super) fn find_near_pairs(points: &[DVec3], within: f64, job: &Job<'_>) -> Result<Vec<(f64, u32, u32)>> {
    // Not an axis, because surfaces are often parallel to axes.
    let direction = DVec3::new(0.540_302, 0.612_372, 0.577_35);
    let mut order = alloc::collect(points.iter().enumerate().map(|(k, p)| (p.dot(direction), k as u32)))?;
    sort::sort_stable(&mut order, &|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut pairs = Vec::new();
    // Sort keys are rounded, so the limit is wider.
    let mut compared = 0;
    for run in order.chunk_by(|a, b| b.0 - a.0 <= 1.5 * within) {
        let own = job.sub_job(compared as f64 / points.len() as f64, 1.0);
        if run.len() > MAX_PAIRWISE_COMPARED_POINTS {
            add_near_pairs_by_tree(points, run, within, &mut pairs, &own.sub_job(0.0, 0.0))?;
            compared += run.len();
            continue;
        }
        if (compared + run.len()) / ENDS_PER_REPORT > compared / ENDS_PER_REPORT {
            own.step(0.0, "paths")?;
        }
        compared += run.len();
        for (at, &(_, k)) in run.iter().enumerate() {
            for &(_, n) in &run[at + 1..] {
                let distance = points[k as usize].distance(points[n as usize]);
                if distance <= within {
                    alloc::push(&mut pairs, (distance, k, n))?;
                }
            }
        }
    }
    Ok(pairs)
}

/// Adds the pairs of a run of many points.
fn add_near_pairs_by_tree(
    points: &[DVec3],
    run: &[(f64, u32)],
    within: f64,
    pairs: &mut Vec<(f64, u32, u32)>,
    job: &Job<'_>,
) -> Result<()> {
    let own = alloc::collect(run.iter().map(|&(_, k)| points[k as usize]))?;
    let (tree, reach) = (KdTree::new(&own, job, "paths")?, ScaledRadius::new(within.max(f64::MIN_POSITIVE)));
    for (at, &(_, k)) in run.iter().enumerate() {
        job.step_every(ENDS_PER_REPORT, at, run.len(), "paths")?;
        let (mut result, mut seen) = (Ok(()), 0);
        let _ = tree.try_for_each_within(own[at], reach, &mut |_, n| {
            seen += 1;
            if n as usize > at {
                let distance = own[at].distance(own[n as usize]);
                result = alloc::push(pairs, (distance, k, run[n as usize].1));
            }
            if result.is_err() || seen == MAX_COMPARED_NEIGHBOURS {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        result?;
    }
    Ok(())
}

/// Ends within this number of resolutions may be the same point.
pub(super) const MAX_JOINT_GAP_IN_RESOLUTIONS: f64 = 2.0;

/// Chains of arcs.
#[derive(Debug, Default)]
pub(super) struct ChainedArcs {
    /// Sequences of arcs, each of which continues where the previous one ends, within the
    /// resolution.
    pub(super) chains: Vec<ArcChain>,
    pub(super) crossings: JoinedCrossings,
    /// For each unresolved ball, whether a joint explains it.
    pub(super) is_ball_explained: Vec<bool>,
}

/// Joins the arcs to chains: at ends within [`MAX_JOINT_GAP_IN_RESOLUTIONS`] of each other, and across
/// unresolved balls.
///
/// `critical` holds the points where the surfaces touch within `tolerance`. `resolution` is the
/// accuracy of the arcs' ends. The search may miss arcs shorter than `resolution`.
pub(super) fn chain_arcs(
    pieces: &FoundArcsAndBalls,
    critical: &CriticalPoints,
    surroundings: &impl IntersectedSurfaces,
    [tolerance, resolution]: [f64; 2],
    job: &Job<'_>,
) -> Result<ChainedArcs> {
    let arcs = &pieces.arcs;
    // The start and the end of each arc.
    let ends = alloc::collect((0..2 * arcs.len()).map(|k| arcs[k / 2].ends[k % 2]))?;
    let near = find_near_pairs(&ends, MAX_JOINT_GAP_IN_RESOLUTIONS * resolution, job)?;
    let mut dropped = find_repeated_arcs(arcs, &near, false, resolution)?;
    let mut joints = Vec::new();
    for (distance, k, n) in near {
        let (end, start) = if k % 2 == 1 { (k, n) } else { (n, k) };
        let usable = end % 2 == 1 && start % 2 == 0 && (end / 2 != start / 2 || arcs[end as usize / 2].is_closed);
        if usable && !dropped[end as usize / 2] && !dropped[start as usize / 2] {
            alloc::push(&mut joints, (distance, end / 2, start / 2))?;
        }
    }
    // The closest pairs first.
    sort::sort_stable(&mut joints, &|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let bridges = ChainsWithBalls { arcs_and_balls: pieces, surfaces: surroundings, tolerance, resolution };
    let mut links = ArcLinks::from_joints(&joints, &dropped)?;
    let mut chains = links.build_chains(&dropped)?;
    // An arc that was removed may have taken the place of another one.
    if bridges.drop_short_chains(&chains, &mut dropped) | bridges.drop_repeated_chains(&chains, &mut dropped)? {
        links = ArcLinks::from_joints(&joints, &dropped)?;
        chains = links.build_chains(&dropped)?;
    }
    if pieces.balls.is_empty() {
        return Ok(ChainedArcs { chains: links.build_chains(&dropped)?, ..ChainedArcs::default() });
    }
    bridges
        .drop_scrap_chains(&chains, &mut dropped, &|ball| critical.explanations[ball as usize] != EXPLAINED_AS_APART)?;
    bridges.drop_chains_within_contacts(&critical.points, &chains, &mut dropped)?;
    // Branches that cross are joined after each of them is complete elsewhere.
    let elsewhere = |ball: u32| critical.explanations[ball as usize] == NOT_EXPLAINED;
    bridges.bridge_loose_chain_ends(&links.build_chains(&dropped)?, &mut links, &elsewhere)?;
    let crossings = bridges.join_crossings(&critical.points, &links.build_chains(&dropped)?, &mut links)?;
    bridges.bridge_loose_chain_ends(&links.build_chains(&dropped)?, &mut links, &|_| true)?;
    Ok(ChainedArcs {
        chains: links.build_chains(&dropped)?,
        crossings,
        is_ball_explained: bridges.which_balls_a_joint_explains(&links)?,
    })
}

/// Finds duplicates: arcs that were found from both sides of a side of cells or boxes. `near` holds
/// pairs of ends that are close to each other. Sheets may have opposite orientations, so a
/// duplicate in other cells may run in the opposite direction. If `either_way`, it may do so in the
/// same cells too, because neither piece is the first.
pub(super) fn find_repeated_arcs(
    arcs: &[IntersectionArc],
    near: &[(f64, u32, u32)],
    either_way: bool,
    resolution: f64,
) -> Result<Vec<bool>> {
    let mut dropped = alloc::filled(false, arcs.len())?;
    for &(_, p, q) in near {
        let (one, other) = (&arcs[p as usize / 2], &arcs[q as usize / 2]);
        let (e, f) = (p as usize % 2, q as usize % 2);
        // Most of these pairs are successive arcs.
        if other.ends[1 - f].distance(one.ends[1 - e]) > MAX_JOINT_GAP_IN_RESOLUTIONS * resolution {
            continue;
        }
        let way = if e == f { 1.0 } else { -1.0 };
        // Short successive arcs are at least as far apart as they are long.
        let chord = one.ends[1] - one.ends[0];
        let between = 0.5 * (one.ends[0] + one.ends[1] - other.ends[0] - other.ends[1]);
        let is_beside = between.dot(chord).abs() <= 0.25 * chord.length_squared();
        // Arcs with the same ends are duplicates if their directions agree within the resolution.
        // Beside crossings, where the surfaces are nearly parallel, directions are not known more
        // precisely.
        let angle = (resolution / chord.length().max(2.0 * resolution)).max(1e-5);
        let parallel = [0, 1].map(|k| one.directions[k].distance(way * other.directions[(k + e + f) % 2]) <= angle);
        let along = one.is_along_side && other.is_along_side;
        let may_be_one = one.pair != other.pair || along && (either_way || e == f) && p / 2 != q / 2;
        // Directions at poles are unknown.
        let is_parallel = parallel[0] && parallel[1] || along && (parallel[0] || parallel[1]);
        if may_be_one && is_parallel && is_beside {
            dropped[p.max(q) as usize / 2] = true;
        }
    }
    Ok(dropped)
}
