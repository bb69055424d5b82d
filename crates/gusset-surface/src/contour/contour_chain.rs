//! Links the arcs of a sheet to open and closed paths by the marks that they share, and sorts the
//! paths.
//!
//! Invariant: an arc ends with the key with which the next one begins, because cells that share a
//! side share its marks. Cost: O(arcs) for each level, O(arcs log arcs) if fields are
//! discontinuous.

use super::contour_lattice::ContourLattice;
use super::contour_search::{ContourArc, ContourArcs};
use crate::Place;
use glam::DVec2;
use gusset_base::error::{Error, Result};
use gusset_base::sort;
use gusset_base::sort::Buckets;
use gusset_base::{alloc, par};
use std::collections::VecDeque;

/// A curve on a sheet.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContourPath {
    pub(super) level: u32,
    pub(super) closed: bool,
    /// The half-open range of the path's points in [`ContourPaths::places`].
    pub(super) place_range: [usize; 2],
}

/// The curves on sheets, sheet by sheet. The curves of a sheet are sorted by level, then by their
/// first cell, row by row.
#[derive(Debug, Default)]
pub(super) struct ContourPaths {
    pub(super) paths: Vec<ContourPath>,
    pub(super) places: Vec<Place>,
}

impl ContourPaths {
    pub(super) fn append_paths(&mut self, other: ContourPaths) -> Result<()> {
        // With one level and sheet, no copy is needed.
        if self.paths.is_empty() {
            *self = other;
            return Ok(());
        }
        let shift = self.places.len();
        alloc::append(&mut self.places, &other.places)?;
        let moved = |path: ContourPath| ContourPath { place_range: path.place_range.map(|at| at + shift), ..path };
        alloc::extend(&mut self.paths, other.paths.into_iter().map(moved))
    }
}

const NO_SUCCESSOR: u32 = u32::MAX;

/// A hash table of arcs by the keys of the marks where they begin, with open addressing.
struct ArcTableByStart<'a> {
    arcs: &'a [ContourArc],
    slots: Vec<u32>,
    shift: u32,
}

impl<'a> ArcTableByStart<'a> {
    fn new(arcs: &'a [ContourArc]) -> Result<Self> {
        let bits = usize::BITS - (2 * arcs.len()).leading_zeros();
        let mut table =
            ArcTableByStart { arcs, slots: alloc::filled(NO_SUCCESSOR, 1 << bits)?, shift: u64::BITS - bits };
        for (k, arc) in arcs.iter().enumerate() {
            let at = table.slot_of_key(arc.end_keys[0]);
            table.slots[at] = k as u32;
        }
        Ok(table)
    }

    /// The slot of a key, or the free slot for it.
    fn slot_of_key(&self, key: u64) -> usize {
        let mut at = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> self.shift) as usize;
        while self.slots[at] != NO_SUCCESSOR && self.arcs[self.slots[at] as usize].end_keys[0] != key {
            at = (at + 1) & (self.slots.len() - 1);
        }
        at
    }

    fn arc_beginning_at(&self, key: u64) -> Option<usize> {
        let arc = self.slots[self.slot_of_key(key)];
        (arc != NO_SUCCESSOR).then_some(arc as usize)
    }
}

/// Links the arcs of a sheet, and adds its paths. `has_jumps` tells whether the cells at a side
/// have separate marks, which are linked first.
pub(super) fn chain_arcs(
    sheet: u32,
    found: &mut ContourArcs,
    lattice: &ContourLattice,
    has_jumps: bool,
    threads: usize,
    found_paths: &mut ContourPaths,
) -> Result<()> {
    sort_arcs_by_level(&mut found.arcs)?;
    if has_jumps {
        link_arcs_across_sides(&mut found.arcs, lattice)?;
    }
    let levels = alloc::gather(found.arcs.chunk_by(|a, b| a.level == b.level))?;
    let parts = par::map(threads, levels.into_iter(), |arcs| paths_of_level(sheet, arcs, &found.inner_places))?;
    parts.into_iter().try_for_each(|part| found_paths.append_paths(part?))
}

/// Sorts arcs by level. Cells come in the order of the search, each with its levels. The sort is
/// stable.
fn sort_arcs_by_level(arcs: &mut Vec<ContourArc>) -> Result<()> {
    if arcs.is_sorted_by_key(|arc| arc.level) {
        return Ok(());
    }
    let count = arcs.iter().map(|arc| arc.level as usize + 1).max().unwrap_or(0);
    let of_levels = Buckets::new(count, arcs[0], arcs.iter().map(|arc| (arc.level as usize, *arc)))?;
    *arcs = of_levels.into_parts().1;
    Ok(())
}

/// For each arc, the index of its successor or [`NO_SUCCESSOR`], and whether it has a predecessor.
fn find_successors(arcs: &[ContourArc]) -> Result<(Vec<u32>, Vec<bool>)> {
    let table = ArcTableByStart::new(arcs)?;
    let mut next = alloc::filled(NO_SUCCESSOR, arcs.len())?;
    let mut entered = alloc::filled(false, arcs.len())?;
    for (k, arc) in arcs.iter().enumerate() {
        if let Some(after) = table.arc_beginning_at(arc.end_keys[1]).filter(|&after| !entered[after]) {
            next[k] = after as u32;
            entered[after] = true;
        }
    }
    Ok((next, entered))
}

/// The paths of one level, sorted by the first cell of each, row by row, then by its mark there.
fn paths_of_level(sheet: u32, arcs: &[ContourArc], inner: &[DVec2]) -> Result<ContourPaths> {
    let (next, entered) = find_successors(arcs)?;
    let count = arcs.len() + arcs.iter().map(|arc| (arc.inner_range[1] - arc.inner_range[0]) as usize).sum::<usize>();
    let (mut paths, mut places) = (Vec::new(), alloc::with_capacity(count)?);
    let lowest = |k: usize| (arcs[k].cell, arcs[k].end_keys[0]);
    let mut used = alloc::filled(false, arcs.len())?;
    // First open paths from their beginnings, then closed ones.
    let open = (0..arcs.len()).filter(|&k| !entered[k]);
    for head in open.chain(0..arcs.len()) {
        if used[head] {
            continue;
        }
        let (mut min, mut last) = (head, head);
        loop {
            used[last] = true;
            if lowest(last) < lowest(min) {
                min = last;
            }
            if next[last] == NO_SUCCESSOR || next[last] as usize == head {
                break;
            }
            last = next[last] as usize;
        }
        let closed = next[last] != NO_SUCCESSOR;
        let first = places.len();
        let mut at = if closed { min } else { head };
        loop {
            let arc = &arcs[at];
            let place = |&at: &DVec2| Place { sheet, cell: arc.cell, u: at.x, v: at.y };
            let [from, to] = arc.inner_range.map(|k| k as usize);
            alloc::push(&mut places, place(&arc.end_places[0]))?;
            alloc::extend(&mut places, inner[from..to].iter().map(place))?;
            if arc.jumps || next[at] == NO_SUCCESSOR {
                alloc::push(&mut places, place(&arc.end_places[1]))?;
            }
            if next[at] == NO_SUCCESSOR || (closed && next[at] as usize == min) {
                break;
            }
            at = next[at] as usize;
        }
        let path = ContourPath { level: arcs[head].level, closed, place_range: [first, places.len()] };
        alloc::push(&mut paths, (lowest(min), path))?;
    }
    sort::sort_stable(&mut paths, &|a, b| a.0.cmp(&b.0));
    Ok(ContourPaths { paths: alloc::collect(paths.into_iter().map(|(_, path)| path))?, places })
}

/// An end of an arc on a side between cells with discontinuous fields.
#[derive(Clone, Copy)]
struct ArcEndOnSide {
    level: u32,
    /// The index of the side or the corner.
    group: u64,
    side_parameter: f64,
    key: u64,
    arc: usize,
    is_exit: bool,
}

/// Links the ends of arcs that leave one cell to those that enter the adjacent one, or the same one
/// again. Along each side, the k-th exit is linked to the k-th entry. Where the two fields have
/// opposite signs, the side itself belongs to the zero set between exit and entry. Cells may
/// disagree on the sign at a corner, which leaves some ends over. They are linked around the
/// nearest corner.
fn link_arcs_across_sides(arcs: &mut [ContourArc], lattice: &ContourLattice) -> Result<()> {
    let mut ends = alloc::with_capacity(2 * arcs.len())?;
    for (k, arc) in arcs.iter().enumerate() {
        for (key, at, exit) in [(arc.end_keys[0], arc.end_places[0], false), (arc.end_keys[1], arc.end_places[1], true)]
        {
            let side = key >> 7;
            let inside = key >> 63 == 1;
            if !inside && !lattice.is_side_on_open_edge(arc.cell, side) {
                ends.push(ArcEndOnSide {
                    level: arc.level,
                    group: side,
                    side_parameter: at[(side & 1) as usize],
                    key,
                    arc: k,
                    is_exit: exit,
                });
            }
        }
    }
    let mut left = link_exits_to_entries(ends, arcs)?;
    for end in &mut left {
        end.group = lattice.corner_index_of_side(end.group, end.side_parameter >= 0.5);
        // The distance from the corner.
        end.side_parameter = end.side_parameter.min(1.0 - end.side_parameter);
    }
    link_exits_to_entries(left, arcs)?;
    Ok(())
}

/// Links exits to entries of the same level and group, in order. Returns the remaining ends.
fn link_exits_to_entries(mut ends: Vec<ArcEndOnSide>, arcs: &mut [ContourArc]) -> Result<Vec<ArcEndOnSide>> {
    sort::sort_stable(&mut ends, &|a, b| {
        let by = |end: &ArcEndOnSide| (end.level, end.group);
        by(a).cmp(&by(b)).then(a.side_parameter.total_cmp(&b.side_parameter)).then(a.key.cmp(&b.key))
    });
    let mut waiting: VecDeque<ArcEndOnSide> = VecDeque::new();
    let mut left = Vec::new();
    for group in ends.chunk_by(|a, b| (a.level, a.group) == (b.level, b.group)) {
        let bytes = size_of_val(group) as u64;
        waiting.try_reserve(group.len()).map_err(|_| Error::OutOfMemory { bytes })?;
        for &end in group {
            match waiting.pop_front() {
                Some(first) if end.is_exit != first.is_exit => {
                    let (exit, entry) = if end.is_exit { (end, first) } else { (first, end) };
                    arcs[exit.arc].end_keys[1] = entry.key;
                    arcs[exit.arc].jumps = true;
                }
                Some(first) => {
                    waiting.push_front(first);
                    waiting.push_back(end);
                }
                None => waiting.push_back(end),
            }
        }
        alloc::extend(&mut left, waiting.drain(..))?;
    }
    Ok(left)
}
