//! Properties of the loops among which the search looks for pairs that face each other.

use super::assemble_request::Extent;
use crate::stitch::facing::Arc;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::cell::Cell;

pub(super) const STAGE: &str = "looking for loops that face each other";
const VISITS_PER_REPORT: usize = 1 << 18;

/// Two loops by their indices, or arcs of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacingLoops {
    pub(super) rims: [usize; 2],
    pub(super) arcs: Option<[Arc; 2]>,
    /// The mean distance from the vertices of one to the nearest vertex of the other, the larger of
    /// both means.
    pub(super) mean_gap: f64,
}

/// Measures of a loop.
pub(super) struct LoopMeasures {
    /// The component. Loops of one component are paired only if `within_components` is true.
    pub(super) component: u32,
    /// The piece of the loop's first vertex.
    pub(super) piece: u32,
    /// The largest extent of the component along an axis.
    pub(super) component_size: f64,
    /// The mean distance of the loop's vertices from their centre.
    pub(super) mean_radius: f64,
    pub(super) length: f64,
    /// The mean length of the loop's edges.
    pub(super) mean_edge_length: f64,
}

impl LoopMeasures {
    pub(super) fn new(rim: &Rim, component: u32, piece: u32, size: f64) -> Self {
        let n = rim.points.len();
        let length = (0..n).map(|i| rim.points[i].distance(rim.points[(i + 1) % n])).sum::<f64>();
        LoopMeasures {
            component,
            piece,
            component_size: size,
            mean_radius: rim.mean_radius(),
            length,
            mean_edge_length: length / n as f64,
        }
    }
}

/// A loop whose two sides belonged to two borders before sewing.
#[derive(Clone, Copy)]
pub(super) struct SlitLoop {
    /// The side with both ends, and the other side.
    pub(super) arcs: [Arc; 2],
    /// The mean distance from the vertices of a side to the other side, the larger of both.
    pub(super) mean_gap: f64,
    /// True if the sides are near each other relative to their length.
    pub(super) is_narrow: bool,
    /// True if the sides face each other along their length, at any distance.
    pub(super) is_opposed: bool,
    /// True if the sides face each other, are near, or bound surfaces that continue each other.
    pub(super) may_be_closed: bool,
}

pub(super) struct FacingSearch<'a> {
    pub(super) rims: &'a [Rim],
    pub(super) candidates: &'a [LoopMeasures],
    /// True for loops that are already joined.
    pub(super) is_joined_loop: &'a [bool],
    /// The sides of each loop that is a slit.
    pub(super) slits: &'a [Option<SlitLoop>],
    /// Excluded pairs (smaller, larger), in ascending order.
    pub(super) excluded: &'a [[u32; 2]],
    pub(super) within_components: bool,
    pub(super) extent: Extent,
    /// The limit in the rims' unit; `None` for [`MaxGap::Auto`](super::MaxGap::Auto).
    pub(super) max_gap: Option<f64>,
    /// The factor of the default limit of whole loops.
    pub(super) whole_loop_gap_factor: f64,
}

/// The vertices of all loops, one loop after another.
pub(super) struct LoopVertices {
    pub(super) points: Vec<DVec3>,
    /// The loop of each vertex.
    pub(super) loop_of_vertex: Vec<u32>,
    /// The group of each vertex. A search from a vertex skips its own group.
    pub(super) groups: Vec<u32>,
    /// The index of each loop's first vertex.
    pub(super) firsts: Vec<u32>,
}

/// Counts visits to loops. A host can then cancel in time even if many loops meet in a vertex and
/// each visits most of the others.
#[derive(Default)]
pub(super) struct LoopVisitCounter(Cell<usize>);

impl LoopVisitCounter {
    pub(super) fn count_visit(&self) {
        self.0.set(self.0.get() + 1);
    }

    /// Returns true, and resets the count, if it is time for a progress report.
    pub(super) fn take_report_due(&self) -> bool {
        let many = self.0.get() >= VISITS_PER_REPORT;
        if many {
            self.0.set(0);
        }
        many
    }
}

impl FacingSearch<'_> {
    pub(super) fn may_join_loops(&self, r: usize, k: usize) -> bool {
        let [r, k] = [r.min(k), r.max(k)];
        !self.is_joined_loop[k]
            && (self.within_components || self.candidates[r].component != self.candidates[k].component)
            && !self.is_excluded_pair(r, k)
    }

    pub(super) fn is_excluded_pair(&self, r: usize, k: usize) -> bool {
        self.excluded.binary_search(&[r.min(k) as u32, r.max(k) as u32]).is_ok()
    }

    pub(super) fn collect_loop_vertices(&self) -> Result<LoopVertices> {
        let total = self.rims.iter().map(|rim| rim.points.len()).sum();
        let (mut points, mut owners) = (alloc::with_capacity::<DVec3>(total)?, alloc::with_capacity(total)?);
        let mut firsts = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            firsts.push(points.len() as u32);
            points.extend(&rim.points);
            owners.extend(std::iter::repeat_n(r as u32, rim.points.len()));
        }
        // Searches skip the vertices of one component, so that whole subtrees are passed over.
        let groups = alloc::collect(owners.iter().map(|&r| match self.within_components {
            true => r,
            false => self.candidates[r as usize].component,
        }))?;
        Ok(LoopVertices { points, loop_of_vertex: owners, groups, firsts })
    }
}
