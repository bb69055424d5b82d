//! Selection of the loops to fill, and the reason for each that is not.

use super::request::{HoleStatus, Limits, Options};
use crate::alloc;
use crate::boundary::{Boundary, Loop, LoopFlags};
use crate::error::Result;
use crate::geom::{Aabb, scale::distance};
use crate::mesh::MeshView;
use crate::stitch::{FreeEdges, check_loop};
use std::collections::BTreeSet;

/// A loop, and whether it is to be filled.
pub(super) struct Candidate {
    /// With the surface on the left, if it is to be filled.
    pub(super) vertices: Vec<u32>,
    pub(super) status: HoleStatus,
}

pub(super) fn all_loops(mesh: &MeshView<'_>, boundary: &Boundary, options: &Options) -> Result<Vec<Candidate>> {
    let usable = |found: &Loop<'_>| status_of(found.flags) == HoleStatus::Filled;
    let longest = boundary
        .iter()
        .enumerate()
        .filter(|(_, found)| usable(found))
        // Of equally long ones the first.
        .max_by(|(i, a), (j, b)| a.length.total_cmp(&b.length).then(j.cmp(i)))
        .map(|(i, _)| i);
    let mut candidates = alloc::with_capacity(boundary.len())?;
    for (i, found) in boundary.iter().enumerate() {
        let status = match status_of(found.flags) {
            HoleStatus::Filled if options.keep_longest && longest == Some(i) => HoleStatus::Longest,
            HoleStatus::Filled => size_status(mesh, found.vertices, &options.limits),
            status => status,
        };
        candidates.push(Candidate { vertices: alloc::copied(found.vertices)?, status });
    }
    Ok(candidates)
}

fn status_of(flags: LoopFlags) -> HoleStatus {
    if flags.any(LoopFlags::OPEN) {
        HoleStatus::Open
    } else if flags.any(LoopFlags::NON_MANIFOLD) {
        HoleStatus::NonManifold
    } else if flags.any(LoopFlags::NOT_ORIENTED) {
        HoleStatus::NotOriented
    } else {
        HoleStatus::Filled
    }
}

/// The loops given, in either direction.
pub(super) fn given_loops(
    mesh: &MeshView<'_>,
    boundary: &Boundary,
    loops: &[&[u32]],
    limits: &Limits,
) -> Result<Vec<Candidate>> {
    let edges = FreeEdges::of(boundary)?;
    let mut used = BTreeSet::new();
    let mut candidates = alloc::with_capacity(loops.len())?;
    for (number, given) in (0..).zip(loops) {
        check_loop(mesh, number, given)?;
        let mut vertices = alloc::copied(given)?;
        let mut status = given_status(&edges, &vertices)?;
        if status == HoleStatus::Filled {
            if edges.face_that_runs(vertices[0], vertices[1]).is_none() {
                vertices.reverse();
            }
            let steps = || vertices.iter().zip(vertices.iter().cycle().skip(1)).map(|(&u, &v)| (u, v));
            status = if steps().any(|edge| used.contains(&edge)) {
                HoleStatus::NotFree
            } else {
                size_status(mesh, &vertices, limits)
            };
            if status == HoleStatus::Filled {
                used.extend(steps());
            }
        }
        candidates.push(Candidate { vertices, status });
    }
    Ok(candidates)
}

fn given_status(edges: &FreeEdges, vertices: &[u32]) -> Result<HoleStatus> {
    let mut sorted = alloc::copied(vertices)?;
    sorted.sort_unstable();
    if vertices.len() < 3 || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
        return Ok(HoleStatus::NotSimple);
    }
    let steps = vertices.iter().zip(vertices.iter().cycle().skip(1));
    let (mut along, mut against) = (0, 0);
    for (&u, &v) in steps {
        match (edges.face_that_runs(u, v), edges.face_that_runs(v, u)) {
            (Some(_), _) => along += 1,
            (None, Some(_)) => against += 1,
            (None, None) => return Ok(HoleStatus::NotFree),
        }
    }
    Ok(if along > 0 && against > 0 { HoleStatus::NotOriented } else { HoleStatus::Filled })
}

fn size_status(mesh: &MeshView<'_>, vertices: &[u32], limits: &Limits) -> HoleStatus {
    let point = |i: usize| mesh.positions().get(vertices[i % vertices.len()]);
    let n = vertices.len();
    let exceeds = |limit: Option<f64>, measure: &dyn Fn() -> f64| limit.is_some_and(|limit| measure() > limit);
    let length = || (0..n).map(|i| distance(point(i), point(i + 1))).sum::<f64>();
    let diameter = || {
        let whole = Aabb::of((0..n).map(point));
        distance(whole.low, whole.high)
    };
    if limits.edges.is_some_and(|limit| n > limit as usize)
        || exceeds(limits.length, &length)
        || exceeds(limits.diameter, &diameter)
    {
        HoleStatus::TooLarge
    } else {
        HoleStatus::Filled
    }
}
