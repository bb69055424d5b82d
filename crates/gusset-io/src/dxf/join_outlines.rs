//! Open polylines joined at their ends.

use crate::document::Curves;
use crate::error::ReadError;
use crate::mesh::Positions;
use gusset_base::alloc;
use std::collections::HashMap;

/// Largest distance of ends that meet, relative to the diagonal of all ends.
const RELATIVE_DISTANCE: f64 = 1e-7;
/// Width of cells in distances of ends that meet: an end is near the border of a cell only at times.
const CELL_WIDTH: f64 = 8.0;

type Point = [f64; 3];

/// Joins open polylines where exactly two ends meet. The result has the order of the first polyline of each chain.
pub(super) fn join_outlines(curves: Curves) -> Result<Curves, ReadError> {
    let Positions::F64(points) = &curves.positions else { return Ok(curves) };
    let open = alloc::gather((0..curves.closed.len()).filter(|&curve| !curves.closed[curve]))?;
    let range = |curve: usize| curves.offsets[curve] as usize..curves.offsets[curve + 1] as usize;
    let ends = alloc::collect(open.iter().map(|&curve| [points[range(curve).start], points[range(curve).end - 1]]))?;
    let partners = pair_ends(&ends)?;
    if partners.iter().all(Option::is_none) {
        return Ok(curves);
    }
    let chains = chain_curves(&partners)?;
    let mut joined = Curves::default();
    alloc::reserve(&mut joined.closed, curves.closed.len())?;
    alloc::reserve(&mut joined.offsets, curves.closed.len())?;
    let mut all: Vec<Point> = Vec::new();
    all.try_reserve_exact(points.len())?;
    let mut chain_at: HashMap<usize, usize> = HashMap::new();
    chain_at.try_reserve(chains.len())?;
    chain_at.extend(
        chains
            .iter()
            .enumerate()
            .map(|(chain, parts)| (open[parts.links.iter().map(|link| link.curve).min().unwrap_or(0)], chain)),
    );
    for curve in 0..curves.closed.len() {
        if curves.closed[curve] {
            all.extend_from_slice(&points[range(curve)]);
            joined.closed.push(true);
        } else if let Some(&chain) = chain_at.get(&curve) {
            let start = all.len();
            for link in &chains[chain].links {
                let part = &points[range(open[link.curve])];
                let skipped = usize::from(all.len() > start);
                if link.is_backwards {
                    all.extend(part.iter().rev().skip(skipped));
                } else {
                    all.extend(part.iter().skip(skipped));
                }
            }
            let mut is_closed = chains[chain].is_closed;
            if is_closed {
                is_closed = all.len() - start > 3;
                all.truncate(all.len() - usize::from(is_closed));
            }
            joined.closed.push(is_closed);
        } else {
            continue;
        }
        joined.offsets.push(all.len() as u32);
    }
    joined.positions = Positions::F64(all);
    Ok(joined)
}

/// For each end of each curve, numbered `2 * curve + side`, the end that it meets.
fn pair_ends(ends: &[[Point; 2]]) -> Result<Vec<Option<u32>>, ReadError> {
    let flat = ends.as_flattened();
    let is_finite = |point: &&Point| point.iter().all(|part| part.is_finite());
    let extent = |axis: usize| {
        let low = flat.iter().filter(is_finite).fold(f64::INFINITY, |least, point| least.min(point[axis]));
        let high = flat.iter().filter(is_finite).fold(f64::NEG_INFINITY, |most, point| most.max(point[axis]));
        (high - low).max(0.0)
    };
    let diagonal = (0..3).map(|axis| extent(axis).powi(2)).sum::<f64>().sqrt();
    let distance = (RELATIVE_DISTANCE * diagonal).max(f64::MIN_POSITIVE);
    let mut nodes: Vec<JointNode> = Vec::new();
    let mut newest_in_cell: HashMap<[i64; 3], u32> = HashMap::new();
    let cell = |point: Point, shift: [f64; 3]| {
        [0, 1, 2].map(|axis| ((point[axis] + shift[axis] * distance) / (CELL_WIDTH * distance)).floor() as i64)
    };
    for (end, &point) in flat.iter().enumerate().filter(|(_, point)| is_finite(point)) {
        let (low, high) = (cell(point, [-1.0; 3]), cell(point, [1.0; 3]));
        let mut found = None;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let newest = newest_in_cell.get(&[x, y, z]).copied();
                    let is_near =
                        |node: &JointNode| (0..3).all(|axis| (node.point[axis] - point[axis]).abs() <= distance);
                    let mut listed = std::iter::successors(newest, |&node| nodes[node as usize].next_in_cell);
                    found = found.or_else(|| listed.find(|&node| is_near(&nodes[node as usize])));
                }
            }
        }
        if let Some(node) = found {
            let node = &mut nodes[node as usize];
            if let Some(place) = node.ends.get_mut(usize::from(node.end_count)) {
                *place = end as u32;
            }
            node.end_count = node.end_count.saturating_add(1);
        } else {
            nodes.try_reserve(1)?;
            newest_in_cell.try_reserve(1)?;
            let next_in_cell = newest_in_cell.insert(cell(point, [0.0; 3]), nodes.len() as u32);
            nodes.push(JointNode { point, ends: [end as u32, 0], end_count: 1, next_in_cell });
        }
    }
    let mut partners = alloc::filled(None, flat.len())?;
    for JointNode { ends: [a, b], .. } in nodes.iter().filter(|node| node.end_count == 2) {
        partners[*a as usize] = Some(*b);
        partners[*b as usize] = Some(*a);
    }
    Ok(partners)
}

/// A place where ends meet.
struct JointNode {
    point: Point,
    /// The first two ends.
    ends: [u32; 2],
    end_count: u8,
    /// Another node of the same cell.
    next_in_cell: Option<u32>,
}

struct Link {
    curve: usize,
    is_backwards: bool,
}

struct Chain {
    links: Vec<Link>,
    is_closed: bool,
}

/// Follows partners from curve to curve.
fn chain_curves(partners: &[Option<u32>]) -> Result<Vec<Chain>, ReadError> {
    let count = partners.len() / 2;
    let mut is_used = alloc::filled(false, count)?;
    let mut chains = Vec::new();
    for first in 0..count {
        if is_used[first] {
            continue;
        }
        // Go back to the beginning of the chain, or around it. Curve `first` keeps its direction.
        let mut entry = 2 * first;
        while let Some(partner) = partners[entry] {
            if partner as usize / 2 == first {
                break;
            }
            entry = partner as usize ^ 1;
        }
        let is_closed = partners[entry].is_some();
        let entry = if is_closed { 2 * first } else { entry };
        let links = follow_chain(partners, entry, &mut is_used)?;
        alloc::push(&mut chains, Chain { links, is_closed })?;
    }
    Ok(chains)
}

/// Lists the curves from the one that begins at `entry`.
fn follow_chain(partners: &[Option<u32>], entry: usize, is_used: &mut [bool]) -> Result<Vec<Link>, ReadError> {
    let mut links = Vec::new();
    let mut next = Some(entry);
    while let Some(start) = next.filter(|start| !is_used[start / 2]) {
        is_used[start / 2] = true;
        alloc::push(&mut links, Link { curve: start / 2, is_backwards: start % 2 == 1 })?;
        next = partners[start ^ 1].map(|partner| partner as usize);
    }
    Ok(links)
}
