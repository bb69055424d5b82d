//! Which vertices lie together.
//!
//! In ascending order, each vertex that is still unclaimed becomes a representative and claims the
//! unclaimed ones that lie at its position, or within reach of it as it is within theirs: nearest
//! first, of equally near ones the smallest. What that means: see [`weld`](super::weld).
//!
//! Equal positions are found by sorting, near ones in a k-d tree: O(n log n), as representatives
//! lie apart and a point is within reach of few. Where corners of one face are kept apart, those
//! that lie together each have a turn.

use super::corners::Corners;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, Radius};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE};

/// Vertices by representatives.
pub(super) struct Clusters {
    /// Per vertex of the mesh, its representative: the smallest vertex of its cluster; itself if it
    /// takes no part.
    pub(super) of: Vec<u32>,
    /// Vertices that lie together and were kept apart, as they are corners of one face; unordered.
    pub(super) kept_apart: Vec<u32>,
}

/// Claims between two progress reports.
const REPORT_INTERVAL: usize = 1 << 14;

/// Candidates of one claim between two progress reports.
const CANDIDATES_PER_REPORT: usize = 1 << 18;

/// From so many on, sorting them reports progress.
const MANY_CANDIDATES: usize = 1 << 14;

const STAGE: &str = "clustering vertices";

impl Clusters {
    /// Clusters `members`, which are ascending and have finite positions. `reach`: of each member,
    /// at least 0; empty for equal positions. With `corners`, no cluster gets two corners of one
    /// face.
    pub(super) fn find(
        mesh: &MeshView<'_>,
        members: &[u32],
        reach: &[f64],
        corners: Option<&Corners>,
        job: &Job<'_>,
    ) -> Result<Self> {
        let positions = members.iter().map(|&v| mesh.positions().get(v));
        let points = alloc::collect_cancellable(positions, &job.part(0.0, 0.0), STAGE)?;
        job.step(0.0, STAGE)?;
        let near = Near::new(&points, reach, &job.part(0.0, 0.4))?;
        let job = job.part(0.4, 1.0);
        job.step(0.0, STAGE)?;
        let mut guard = Guard::new(mesh, corners)?;
        let mut found =
            Clusters { of: alloc::collect((0..mesh.positions().len()).map(|v| v as u32))?, kept_apart: Vec::new() };
        job.step(0.0, STAGE)?;
        let mut claimed = alloc::filled(false, members.len())?;
        let mut candidates = Vec::new();
        for (i, &representative) in members.iter().enumerate() {
            job.step_every(REPORT_INTERVAL, i, members.len(), STAGE)?;
            if claimed[i] {
                continue;
            }
            claimed[i] = true;
            candidates.clear();
            let here = i as f64 / members.len() as f64;
            near.candidates(&points, i, &mut candidates, &job.part(here, here))?;
            guard.admits(representative, representative);
            for (k, &(_, j)) in (1..).zip(&candidates) {
                if k % CANDIDATES_PER_REPORT == 0 {
                    job.step(here, STAGE)?;
                }
                let (j, v) = (j as usize, members[j as usize]);
                if claimed[j] {
                    continue;
                }
                if guard.admits(representative, v) {
                    claimed[j] = true;
                    found.of[v as usize] = representative;
                } else {
                    alloc::append(&mut found.kept_apart, &[representative, v])?;
                }
            }
        }
        Ok(found)
    }
}

/// Who lies near whom.
enum Near<'a> {
    /// Places in the order of their positions, and for each place where its group begins in that
    /// order.
    Equal {
        order: Vec<u32>,
        begin: Vec<u32>,
    },
    Within {
        tree: KdTree<'a>,
        reach: &'a [f64],
    },
}

impl<'a> Near<'a> {
    fn new(points: &'a [DVec3], reach: &'a [f64], job: &Job<'_>) -> Result<Self> {
        if !reach.is_empty() {
            return Ok(Near::Within { tree: KdTree::new(points, job, STAGE)?, reach });
        }
        job.step(0.0, STAGE)?;
        // -0 becomes 0, so that the order of bits is the order of numbers.
        let numbered = points.iter().enumerate().map(|(i, &p)| (p + DVec3::ZERO, i as u32));
        let mut sorted = alloc::collect_cancellable(numbered, &job.part(0.0, 0.0), STAGE)?;
        let by_position = |(p, i): &(DVec3, u32), (q, j): &(DVec3, u32)| {
            p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z)).then(i.cmp(j))
        };
        sort(&mut sorted, by_position, job, STAGE)?;
        let order = alloc::collect_cancellable(sorted.iter().map(|&(_, i)| i), &job.part(1.0, 1.0), STAGE)?;
        drop(sorted);
        job.step(1.0, STAGE)?;
        let mut begin = alloc::filled(0u32, points.len())?;
        let mut group = 0;
        for (k, &i) in order.iter().enumerate() {
            job.part(1.0, 1.0).step_within(k, STAGE)?;
            if points[i as usize] != points[order[group] as usize] {
                group = k;
            }
            begin[i as usize] = group as u32;
        }
        Ok(Near::Equal { order, begin })
    }

    /// Appends the places that lie with place `i`, itself too, as (squared distance, place),
    /// nearest first.
    fn candidates(&self, points: &[DVec3], i: usize, out: &mut Vec<(f64, u32)>, job: &Job<'_>) -> Result<()> {
        match self {
            Near::Equal { order, begin } => {
                let group = order[begin[i] as usize..].iter().take_while(|&&j| points[j as usize] == points[i]);
                for &j in group {
                    alloc::push(out, (0.0, j))?;
                    if out.len().is_multiple_of(CANDIDATES_PER_REPORT) {
                        job.step(0.0, STAGE)?;
                    }
                }
            }
            Near::Within { tree, reach } => {
                let mut outcome = Ok(());
                let radius = |i: usize| Radius::new(reach[i].max(f64::from_bits(1)));
                tree.for_each_within(points[i], radius(i), &mut |squared, j| {
                    let difference = points[j as usize] - points[i];
                    if outcome.is_ok() && (reach[j as usize] >= reach[i] || radius(j as usize).contains(difference)) {
                        outcome = alloc::push(out, (squared, j));
                        if out.len().is_multiple_of(CANDIDATES_PER_REPORT) && outcome.is_ok() {
                            outcome = job.step(0.0, STAGE);
                        }
                    }
                });
                outcome?;
                let nearest_first = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
                if out.len() < MANY_CANDIDATES {
                    sort::stable(out, &nearest_first);
                } else {
                    sort(out, nearest_first, job, STAGE)?;
                }
            }
        }
        Ok(())
    }
}

/// Keeps corners of one face apart.
struct Guard<'a> {
    corners: Option<&'a Corners>,
    /// Per face, the representative that last got a corner of it.
    owner: Vec<u32>,
}

impl<'a> Guard<'a> {
    fn new(mesh: &MeshView<'_>, corners: Option<&'a Corners>) -> Result<Self> {
        let faces = if corners.is_some() { mesh.faces().len() } else { 0 };
        Ok(Guard { corners, owner: alloc::filled(NONE, faces)? })
    }

    /// True if no face has both `v` and a vertex admitted to the same representative before; `v` is
    /// then admitted.
    fn admits(&mut self, representative: u32, v: u32) -> bool {
        let Some(corners) = self.corners else { return true };
        if corners.at(v).iter().any(|&h| self.owner[corners.face(h)] == representative) {
            return false;
        }
        for &h in corners.at(v) {
            self.owner[corners.face(h)] = representative;
        }
        true
    }
}
