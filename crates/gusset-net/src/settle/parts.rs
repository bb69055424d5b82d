//! The parts between whole bridges, and the rigid bodies that they make. O(nodes).

use super::SettleOptions;
use crate::{Bridge, BridgeMode, BridgeProperties, Direction, Net, NodeClasses};
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort;
use std::ops::Range;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;
/// Marks a vertex that has neither a body nor an unknown, and a body without an unknown.
pub(super) const NO_BODY: u32 = u32::MAX;
/// The slot of a vertex of a body is this plus the index of the body.
pub(super) const BODY_SLOT_FLAG: u32 = 1 << 31;

/// The parts and bridges of a composite net, along one direction.
pub(super) struct CompositeParts {
    pub(super) direction: Direction,
    /// The indices of the whole bridges, sorted by place.
    pub(super) bridges: Vec<usize>,
    /// The rows (`Down`) or columns of each part: one more than bridges.
    pub(super) lines_of_part: Vec<Range<usize>>,
    /// The body of each part.
    pub(super) bodies: Vec<u32>,
    /// True for bodies that stay. Only entries of the first part of each body are used.
    pub(super) is_held_body: Vec<bool>,
    /// The parts that the caller holds.
    pub(super) held_parts: Vec<bool>,
}

/// Returns the properties of a bridge that has a force; `None` if it has none.
pub(super) fn properties_with_force(bridge: &Bridge) -> Option<BridgeProperties> {
    let p = bridge.properties;
    let pulls = p.tension > 0.0 || p.elasticity > 0.0 || p.stiffness > 0.0;
    (bridge.mode == BridgeMode::Keep && pulls).then_some(p)
}

/// Returns true if a bridge and its sides move as one body.
pub(super) fn is_rigid(bridge: &Bridge) -> bool {
    properties_with_force(bridge).is_some_and(|p| p.stiffness == f64::INFINITY)
}

/// Returns [`Error::BadProperty`] for a property that is negative, NaN, or infinite; stiffness may
/// be infinite.
fn check_properties(index: usize, p: BridgeProperties) -> Result<()> {
    for (property, value) in [("tension", p.tension), ("elasticity", p.elasticity), ("stiffness", p.stiffness)] {
        let is_valid = value >= 0.0 && (value.is_finite() || property == "stiffness");
        if !is_valid {
            return Err(Error::BadProperty { bridge: index as u32, property, value });
        }
    }
    Ok(())
}

impl CompositeParts {
    /// Returns the parts between the whole bridges in the direction of the last of them.
    pub(super) fn new(net: &Net<'_>, options: &SettleOptions<'_>) -> Result<Self> {
        let all = net.bridges();
        let whole = |bridge: &Bridge| bridge.spans_net_from_side_to_side(net.shape());
        let direction = all.iter().rfind(|bridge| whole(bridge)).map_or(Direction::Down, |bridge| bridge.direction);
        let indices = (0..all.len()).filter(|&index| whole(&all[index]) && all[index].direction == direction);
        let mut bridges = alloc::gather(indices)?;
        sort::sort_stable(&mut bridges, &|&i, &k| all[i].at.cmp(&all[k].at).then(i.cmp(&k)));
        let (mut ranges, mut start) = (alloc::with_capacity(bridges.len() + 1)?, 0);
        for &index in &bridges {
            check_properties(index, all[index].properties)?;
            let (at, rows) = (all[index].at, all[index].rows);
            let is_inside = rows < at && (at as usize) < direction.line_count_and_length(net.shape()).0;
            if !is_inside || (all[index].last_line_of_first_net() as usize) < start {
                // The bridge does not belong to this net, or lies within another.
                return Err(Error::NoSuch { element: Element::Bridge, index: index as u64, count: all.len() as u64 });
            }
            ranges.push(start..all[index].last_line_of_first_net() as usize + 1);
            start = all[index].at as usize;
        }
        ranges.push(start..direction.line_count_and_length(net.shape()).0);
        let (needed, given) = (ranges.len(), options.free.len());
        if given != 0 && given < needed {
            return Err(Error::ArrayTooShort { what: "free", needed: needed as u64, given: given as u64 });
        }
        let is_held = |part: usize| !options.free.get(part).is_some_and(|&free| free);
        let held_parts = alloc::collect((0..needed).map(is_held))?;
        let (bodies, held) = (alloc::collect(0..needed as u32)?, Vec::new());
        Ok(CompositeParts { direction, bridges, lines_of_part: ranges, bodies, is_held_body: held, held_parts })
    }

    /// Returns the class of the node at place `k` of row or column `i`.
    pub(super) fn vertex_at(&self, classes: &NodeClasses, i: usize, k: usize) -> u32 {
        let (i, j) = self.direction.swap_unless_down(i, k);
        classes.representative(classes.shape().node(i, j))
    }

    /// Unites parts that are glued or joined by rigid bridges into bodies. Returns a slot for each
    /// class of nodes: [`BODY_SLOT_FLAG`] plus the index of its body, or [`NO_BODY`] if no part
    /// contains it.
    pub(super) fn unite_into_bodies(
        &mut self,
        net: &Net<'_>,
        classes: &NodeClasses,
        job: &Job<'_>,
    ) -> Result<Vec<u32>> {
        let shape = net.shape();
        let along = self.direction.line_count_and_length(shape).1;
        let mut slots = alloc::filled(NO_BODY, shape.node_count())?;
        let mut sets = DisjointSets::new(self.lines_of_part.len())?;
        let mut join = |a: u32, b: u32| {
            let (a, b) = (sets.find(a), sets.find(b));
            sets.attach(a.max(b), a.min(b));
        };
        let mut done = 0;
        for (part, rows) in (0u32..).zip(&self.lines_of_part) {
            for i in rows.clone() {
                for k in 0..along {
                    job.step_every(NODES_PER_REPORT, done, shape.node_count(), "settle")?;
                    done += 1;
                    let slot = &mut slots[self.vertex_at(classes, i, k) as usize];
                    if *slot == NO_BODY {
                        *slot = BODY_SLOT_FLAG + part;
                    } else if *slot != BODY_SLOT_FLAG + part {
                        join(*slot - BODY_SLOT_FLAG, part);
                    }
                }
            }
        }
        for (part, &index) in (0u32..).zip(&self.bridges) {
            if is_rigid(&net.bridges()[index]) {
                join(part, part + 1);
            }
        }
        (0u32..).zip(&mut self.bodies).for_each(|(part, body)| *body = sets.find(part));
        slots
            .iter_mut()
            .filter(|slot| **slot != NO_BODY)
            .for_each(|slot| *slot = BODY_SLOT_FLAG + self.bodies[(*slot - BODY_SLOT_FLAG) as usize]);
        self.choose_fixed_bodies(net)?;
        Ok(slots)
    }

    /// Determines the bodies that stay: bodies with a held part, and the first of a group of bodies
    /// that bridges join if none of them is held.
    fn choose_fixed_bodies(&mut self, net: &Net<'_>) -> Result<()> {
        let count = self.lines_of_part.len();
        self.is_held_body = alloc::filled(false, count)?;
        let mut sets = DisjointSets::new(count)?;
        for (part, &body) in self.bodies.iter().enumerate() {
            self.is_held_body[body as usize] |= self.held_parts[part];
        }
        for (part, &index) in self.bridges.iter().enumerate() {
            if properties_with_force(&net.bridges()[index]).is_some() {
                let (a, b) = (sets.find(self.bodies[part]), sets.find(self.bodies[part + 1]));
                sets.attach(a.max(b), a.min(b));
            }
        }
        let mut has_held = alloc::filled(false, count)?;
        for &body in &self.bodies {
            has_held[sets.find(body) as usize] |= self.is_held_body[body as usize];
        }
        for &body in &self.bodies {
            let whole = sets.find(body) as usize;
            self.is_held_body[body as usize] |= !has_held[whole];
            has_held[whole] = true;
        }
        Ok(())
    }
}
