//! What is known of the loops among which those are looked for that face each other.

use crate::stitch::facing::Arc;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::cell::Cell;

pub(super) const STAGE: &str = "looking for loops that face each other";
const LOOKS_PER_REPORT: usize = 1 << 18;

/// Two loops, by their numbers, or arcs of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facing {
    pub(super) rims: [usize; 2],
    pub(super) arcs: Option<[Arc; 2]>,
    /// The mean distance from the vertices of one to the nearest of the other, the larger of the
    /// two means.
    pub(super) gap: f64,
}

/// Measures of a loop.
pub(super) struct Candidate {
    /// Pairs of one component are not looked for unless `within` says so.
    pub(super) component: u32,
    /// The piece that its first vertex is of.
    pub(super) piece: u32,
    /// The largest extent of its component along an axis.
    pub(super) size: f64,
    /// The mean distance of its vertices from their centre.
    pub(super) radius: f64,
    pub(super) length: f64,
    /// The mean length of its edges.
    pub(super) spacing: f64,
}

impl Candidate {
    pub(super) fn new(rim: &Rim, component: u32, piece: u32, size: f64) -> Self {
        let n = rim.points.len();
        let length = (0..n).map(|i| rim.points[i].distance(rim.points[(i + 1) % n])).sum::<f64>();
        Candidate { component, piece, size, radius: rim.radius(), length, spacing: length / n as f64 }
    }
}

/// A loop whose sides were one border each.
#[derive(Clone, Copy)]
pub(super) struct Slit {
    /// The side with both ends, and the other one.
    pub(super) arcs: [Arc; 2],
    /// The mean distance from the vertices of a side to the other, the larger of the two.
    pub(super) gap: f64,
    /// The sides look at each other, or are near.
    pub(super) closes: bool,
}

pub(super) struct FacingSearch<'a> {
    pub(super) rims: &'a [Rim],
    pub(super) candidates: &'a [Candidate],
    /// Loops that are already joined.
    pub(super) used: &'a [bool],
    /// Of those that sewing left of two, how they lie.
    pub(super) slits: &'a [Option<Slit>],
    /// Pairs (smaller, larger) that are not wanted, in ascending order.
    pub(super) excluded: &'a [[u32; 2]],
    pub(super) within_components: bool,
    pub(super) arcs: bool,
    /// In the rims' unit; `None` for [`MaxGap::Auto`](super::MaxGap::Auto).
    pub(super) max_gap: Option<f64>,
}

/// The vertices of all loops, one loop after another.
pub(super) struct LoopVertices {
    pub(super) points: Vec<DVec3>,
    /// Of each, its loop.
    pub(super) owners: Vec<u32>,
    /// Of each, what nothing is looked for among.
    pub(super) groups: Vec<u32>,
    /// Of each loop, the number of its first vertex.
    pub(super) firsts: Vec<u32>,
}

/// Counts loops that are looked at, so that no host waits where many meet in a vertex and each is
/// looked at from most of the others.
#[derive(Default)]
pub(super) struct Looks(Cell<usize>);

impl Looks {
    pub(super) fn add(&self) {
        self.0.set(self.0.get() + 1);
    }

    /// Whether there have been so many that it is time for a report; they are forgotten then.
    pub(super) fn were_many(&self) -> bool {
        let many = self.0.get() >= LOOKS_PER_REPORT;
        if many {
            self.0.set(0);
        }
        many
    }
}

impl FacingSearch<'_> {
    pub(super) fn may_join(&self, r: usize, k: usize) -> bool {
        let [r, k] = [r.min(k), r.max(k)];
        !self.used[k]
            && (self.within_components || self.candidates[r].component != self.candidates[k].component)
            && !self.is_excluded(r, k)
    }

    pub(super) fn is_excluded(&self, r: usize, k: usize) -> bool {
        self.excluded.binary_search(&[r.min(k) as u32, r.max(k) as u32]).is_ok()
    }

    pub(super) fn all_vertices(&self) -> Result<LoopVertices> {
        let total = self.rims.iter().map(|rim| rim.points.len()).sum();
        let (mut points, mut owners) = (alloc::with_capacity::<DVec3>(total)?, alloc::with_capacity(total)?);
        let mut firsts = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            firsts.push(points.len() as u32);
            points.extend(&rim.points);
            owners.extend(std::iter::repeat_n(r as u32, rim.points.len()));
        }
        // Of one component at a time nothing is looked for: whole parts of the tree are passed
        // over.
        let groups = alloc::collect(owners.iter().map(|&r| match self.within_components {
            true => r,
            false => self.candidates[r as usize].component,
        }))?;
        Ok(LoopVertices { points, owners, groups, firsts })
    }
}
