//! The two rims that meridians join, as polylines, and the forbidden nodes of their lattice.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The progress message of the search for meridians.
pub(in crate::stitch) const STAGE: &str = "finding the best meridians";

/// One meridian: the places on rim A and on rim B.
pub type MeridianEnds = [u32; 2];

/// The two polylines that meridians join, of N + 1 and M + 1 points. The last point of a closed
/// polyline repeats the first.
#[derive(Clone, Copy)]
pub(crate) struct RimPair<'a> {
    pub(crate) a: &'a [DVec3],
    pub(crate) b: &'a [DVec3],
    pub(crate) closed: bool,
    /// The forbidden nodes, in ascending order.
    pub(crate) forbidden: &'a [MeridianEnds],
    /// For each edge of A and of B, the unit normal of the old face along it. The strip's triangles
    /// run A_i A_i-1 B_j seen from the side of this normal.
    pub(crate) face_normals_along_rims: Option<[&'a [DVec3]; 2]>,
    /// Additional costs of steps, in ascending order of the nodes that they lead to.
    pub(crate) penalties: &'a [StepPenalty],
}

/// An additional cost of the step that leads to node `end_node` on the path of meridians.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepPenalty {
    /// The node that the step leads to.
    pub(crate) end_node: MeridianEnds,
    /// True for a step on rim B.
    pub(crate) on_b: bool,
    pub(crate) additional_cost: f64,
}

impl RimPair<'_> {
    /// Returns true if faces along the rims are known.
    pub(super) fn has_faces_along_rims(&self) -> bool {
        self.face_normals_along_rims
            .is_some_and(|sides| sides.iter().any(|side| side.iter().any(|&normal| normal != DVec3::ZERO)))
    }

    pub(super) fn forbidden_in_row(&self, i: usize) -> &[MeridianEnds] {
        let from = self.forbidden.partition_point(|&[row, _]| (row as usize) < i);
        let count = self.forbidden[from..].partition_point(|&[row, _]| row as usize == i);
        &self.forbidden[from..from + count]
    }

    /// Returns the additional costs of the steps into row i.
    pub(super) fn penalties_in_row(&self, i: usize) -> &[StepPenalty] {
        let from = self.penalties.partition_point(|step| (step.end_node[0] as usize) < i);
        let count = self.penalties[from..].partition_point(|step| step.end_node[0] as usize == i);
        &self.penalties[from..from + count]
    }

    pub(super) fn is_forbidden(&self, node: MeridianEnds) -> bool {
        !self.forbidden.is_empty() && self.forbidden.binary_search(&node).is_ok()
    }
}

/// Returns lattice nodes in ascending order, with the ends of closed rims listed twice. The input
/// `nodes` have i < N and j < M.
pub(crate) fn sorted_forbidden_nodes(
    nodes: impl Iterator<Item = MeridianEnds>,
    n: u32,
    m: u32,
    closed: bool,
) -> Result<Vec<MeridianEnds>> {
    let mut all = Vec::new();
    for [i, j] in nodes {
        alloc::push(&mut all, [i, j])?;
        if closed {
            for (again, node) in [(i == 0, [n, j]), (j == 0, [i, m]), (i == 0 && j == 0, [n, m])] {
                if again {
                    alloc::push(&mut all, node)?;
                }
            }
        }
    }
    all.sort_unstable();
    Ok(all)
}
