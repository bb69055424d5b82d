//! Splitting joined nets: the inverse of concatenation.
//!
//! Invariant: unless the joined net was edited, each part equals the original net bit for bit in
//! coordinates, links, seams and bridges. O(nodes).

use super::adapt::undo_adaptation;
use crate::arrange::Rearrangement;
use crate::{Bridge, BridgeMode, Direction, Net, Topology};
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use std::ops::Range;

impl Net<'_> {
    /// Splits the net at a bridge. Unless the net was edited, both nets are restored bit for bit,
    /// with the gluing that [`concatenate`](super::concatenate) found. The bridge must run from
    /// side to side of the net. If a net was joined several times, the last bridge does, and
    /// splitting in reverse order restores all nets. Gluings across the bridge are cut. O(nodes).
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a bridge that does not cross the whole net;
    /// [`Error::CrossingCell`] if a cell is crossed without the gluings across the bridge;
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn split(&self, index: usize, job: &Job<'_>) -> Result<[Net<'static>; 2]> {
        let no_such =
            Error::NoSuch { element: Element::Bridge, index: index as u64, count: self.bridges().len() as u64 };
        let bridge = self
            .bridges()
            .get(index)
            .filter(|bridge| bridge.spans_net_from_side_to_side(self.shape()))
            .ok_or(no_such)?;
        let parts = cut_out_bridges(self, bridge.direction, &[index], &job.sub_job(0.0, 0.5))?;
        let [first, second] = <[_; 2]>::try_from(parts).map_err(|_| no_such)?;
        let [a, b] = bridge.adaptations.each_ref().map(Option::as_deref);
        let first = undo_adaptation(first, a, bridge.direction, &job.sub_job(0.5, 0.75))?;
        Ok([first, undo_adaptation(second, b, bridge.direction, &job.sub_job(0.75, 1.0))?])
    }

    /// Splits the net at all of the last bridges of a direction that run from side to side: the
    /// inverse of [`concatenate_all`](super::concatenate_all). O(nodes).
    ///
    /// # Errors
    /// The errors of [`Net::split`].
    pub fn split_all(&self, direction: Direction, job: &Job<'_>) -> Result<Vec<Net<'static>>> {
        let whole = |bridge: &Bridge| bridge.direction == direction && bridge.spans_net_from_side_to_side(self.shape());
        let last = self.bridges().iter().filter(|bridge| whole(bridge)).map(|bridge| bridge.nesting).min();
        let whole = |bridge: &Bridge| whole(bridge) && Some(bridge.nesting) == last;
        let all = self.bridges().iter().enumerate();
        let mut indices = alloc::gather(all.filter(|(_, bridge)| whole(bridge)).map(|(index, _)| index))?;
        sort::sort_stable(&mut indices, &|&i, &k| self.bridges()[i].at.cmp(&self.bridges()[k].at).then(i.cmp(&k)));
        indices.dedup_by_key(|index| self.bridges()[*index].at);
        let parts = cut_out_bridges(self, direction, &indices, &job.sub_job(0.0, 0.5))?;
        let (mut nets, count, job) = (alloc::with_capacity(parts.len())?, parts.len(), job.sub_job(0.5, 1.0));
        for (k, part) in parts.into_iter().enumerate() {
            // The record of a net belongs to the bridge before it; the first net's record belongs
            // to the bridge after it.
            let adaptation = match k {
                0 => indices.first().and_then(|&index| self.bridges()[index].adaptations[0].as_deref()),
                _ => self.bridges()[indices[k - 1]].adaptations[1].as_deref(),
            };
            nets.push(undo_adaptation(part, adaptation, direction, &job.sub_job_of_item(k, count))?);
        }
        Ok(nets)
    }
}

/// Returns the nets before, between and after bridges, which are removed with their inner rows.
/// `removed` is in order.
fn cut_out_bridges(net: &Net<'_>, direction: Direction, removed: &[usize], job: &Job<'_>) -> Result<Vec<Net<'static>>> {
    let count = direction.line_count_and_length(net.shape()).0;
    let cuts = removed.iter().map(|&index| &net.bridges()[index]);
    let starts = [0].into_iter().chain(cuts.clone().map(|bridge| bridge.at as usize));
    let ends = cuts.map(|bridge| bridge.last_line_of_first_net() as usize + 1).chain([count]);
    let ranges = alloc::gather(starts.zip(ends).map(|(start, end)| start..end))?;
    let topologies = match direction {
        Direction::Down => net.topology().cut_into_row_ranges(&ranges)?,
        Direction::Right => alloc::try_collect(
            net.topology().transposed()?.cut_into_row_ranges(&ranges)?.iter().map(Topology::transposed),
        )?,
    };
    let welded = removed.iter().any(|&index| net.bridges()[index].mode == BridgeMode::Weld);
    let crossed = find_ranges_seamed_to_others(net.topology(), direction, &ranges)?;
    let bridges = bridges_of_ranges(net, direction, &ranges, removed)?;
    let mut parts = alloc::with_capacity(ranges.len())?;
    for (k, ((range, topology), bridges)) in ranges.iter().zip(topologies).zip(bridges).enumerate() {
        if welded || crossed[k] {
            topology.check_crossed_cells()?;
        }
        let (row, column) = direction.swap_unless_down(range.start, 0);
        let map = Rearrangement::Part { row, column };
        let mut part = net.with_rearranged_nodes(&map, topology, &job.sub_job_of_item(k, ranges.len()))?;
        *part.bridges_mut() = bridges;
        let innermost = part.bridges().iter().map(|bridge| bridge.nesting).min().unwrap_or(0);
        part.bridges_mut().iter_mut().for_each(|bridge| bridge.nesting -= innermost);
        parts.push(part);
    }
    Ok(parts)
}

/// For each range, whether a seam glues nodes of it to others.
fn find_ranges_seamed_to_others(
    topology: &Topology,
    direction: Direction,
    ranges: &[Range<usize>],
) -> Result<Vec<bool>> {
    let mut crossed = alloc::filled(false, ranges.len())?;
    for seam in topology.seams() {
        let range = |(i, j): (i64, i64)| {
            let (at, _) = direction.swap_unless_down(i, j);
            ranges.partition_point(|range| range.end as i64 <= at)
        };
        let ends = [seam.a, seam.b]
            .map(|run| [range(run.row_and_column_of_node(0)), range(run.row_and_column_of_node(seam.count - 1))]);
        let ends = ends.as_flattened();
        let (low, high) = ends.iter().fold((ends[0], ends[0]), |(low, high), &k| (low.min(k), high.max(k)));
        if low < high {
            crossed[low..=high].fill(true);
        }
    }
    Ok(crossed)
}

/// Returns each range's bridges, in order.
fn bridges_of_ranges(
    net: &Net<'_>,
    direction: Direction,
    ranges: &[Range<usize>],
    removed: &[usize],
) -> Result<Vec<Vec<Bridge>>> {
    let shape = net.shape();
    let all = 0..direction.line_count_and_length(shape).1;
    let mut cut = alloc::filled(Vec::new(), ranges.len())?;
    let mut is_removed = alloc::filled(false, net.bridges().len())?;
    removed.iter().for_each(|&index| is_removed[index] = true);
    for bridge in net.bridges().iter().zip(is_removed).filter_map(|(bridge, removed)| (!removed).then_some(bridge)) {
        let (low, high) = if bridge.direction == direction {
            (bridge.last_line_of_first_net() as usize, bridge.at as usize)
        } else {
            (bridge.start as usize, bridge.end as usize - 1)
        };
        let from = ranges.partition_point(|range| range.end <= low);
        for (range, bridges) in ranges[from..].iter().zip(&mut cut[from..]).take_while(|(range, _)| range.start <= high)
        {
            let (rows, columns) = direction.swap_unless_down(range, &all);
            if let Some(bridge) = bridge.clipped_to(rows, columns) {
                alloc::push(bridges, bridge)?;
            }
        }
    }
    Ok(cut)
}
