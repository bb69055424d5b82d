//! Topologies of joined nets: stacked row by row, or side by side through their transposes.
//!
//! Closing links within a row stay closing links. Closing links from the last row of a net become
//! seams. O(contracted links + pairs of seams), plus O(nodes) if sides do not suffice.

use crate::topology::{ContractedLinks, LinkMatrix, Seam, SeamRun, Sides};
use crate::{Bridge, BridgeKind, Direction, Net, Shape, Topology};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::borrow::Cow;
use std::ops::Range;

/// Returns the gluings of all nets, and of `inner` rows or columns between them. Nets are glued to
/// each other only if `weld` is set.
pub(super) fn join_topologies(nets: &[&Net<'_>], direction: Direction, weld: bool, inner: u32) -> Result<Topology> {
    let topologies = alloc::try_collect(nets.iter().map(|net| match direction {
        Direction::Down => Ok(Cow::Borrowed(net.topology())),
        Direction::Right => net.topology().transposed().map(Cow::Owned),
    }))?;
    let stacked = stack_topologies(&topologies, weld, inner as usize)?;
    let topology = if direction == Direction::Down { stacked } else { stacked.transposed()? };
    if weld {
        topology.check_crossed_cells()?;
    }
    Ok(topology)
}

/// One topology below the other.
fn stack_topologies(topologies: &[Cow<'_, Topology>], weld: bool, inner: usize) -> Result<Topology> {
    if let [only] = topologies {
        return Ok(only.clone().into_owned());
    }
    let columns = topologies[0].shape().columns();
    let own: usize = topologies.iter().map(|topology| topology.shape().rows()).sum();
    let rows = own + inner * (topologies.len() - 1);
    let shape = Shape::new(rows, columns)?;
    let reversed = topologies[0].is_reversed();
    // Rows closed alike, and no poles: sides suffice without a matrix.
    let rows_closed = topologies[0].sides().is_some_and(|sides| sides.rows_closed);
    let plain = Sides { rows_closed, ..Sides::SHEET };
    let is_plain = |topology: &Cow<'_, Topology>| {
        topology.sides().is_some_and(|sides| Sides { columns_closed: false, ..sides } == plain)
    };
    let all_plain = !weld && topologies.iter().all(is_plain);
    let mut links = if all_plain { None } else { Some(LinkMatrix::empty(shape)?) };
    let mut seams = Vec::new();
    let mut first = 0;
    for (k, topology) in topologies.iter().enumerate() {
        if let Some(links) = &mut links {
            let own = topology.shape();
            let (shift, last) = (shape.horizontal_link(first, 0), own.horizontal_link(own.rows() - 1, 0));
            // The links that close columns become seams.
            let kept = topology.contracted_links().filter(|link| *link < last || link % 2 == 0);
            kept.for_each(|link| links.set_contracted(shift + link, true));
            if weld && k + 1 < topologies.len() {
                links.contract_links_below_row(shape, first + own.rows() - 1);
            }
            if let Some(next) = topologies.get(k + 1) {
                contract_inner_rows(links, [topology, next], first + own.rows()..first + own.rows() + inner, shape);
            }
        }
        add_closing_seams(topology, first, &mut seams)?;
        for seam in topology.seams() {
            let down = |run: SeamRun| SeamRun { row: run.row + first as u32, ..run };
            alloc::push(&mut seams, Seam { a: down(seam.a), b: down(seam.b), ..*seam })?;
        }
        first += topology.shape().rows() + inner;
    }
    let links = links.map_or(ContractedLinks::Sides(plain), ContractedLinks::Matrix);
    Ok(Topology::assemble_unchecked(shape, links, seams, reversed))
}

/// Contracts the links along the inner rows of a bridge that both its sides contract: for a thread
/// all of them, for a tube the closing one.
fn contract_inner_rows(links: &mut LinkMatrix, [a, b]: [&Topology; 2], rows: Range<usize>, shape: Shape) {
    if rows.is_empty() {
        return;
    }
    let (kind, last) = (bridge_kind(a, b, Direction::Down), a.shape().rows() - 1);
    let end = shape.columns() - 1;
    for k in 0..=end {
        let along = |topology: &Topology, i: usize| topology.is_contracted(topology.shape().horizontal_link(i, k));
        let by_kind = kind == BridgeKind::Thread || (kind == BridgeKind::Tube && k == end);
        if by_kind || (along(a, last) && along(b, 0)) {
            rows.clone().for_each(|i| links.set_contracted(shape.horizontal_link(i, k), true));
        }
    }
}

/// The links that close columns, as seams: one for each run of them.
fn add_closing_seams(topology: &Topology, first: usize, seams: &mut Vec<Seam>) -> Result<()> {
    let shape = topology.shape();
    let [top, bottom] = [first, first + shape.rows() - 1].map(|row| row as u32);
    let mut add = |from: usize, to: usize| {
        let run = |row: u32| SeamRun::along_row(row, from as u32, 1);
        let seam = Seam { a: run(top), b: run(bottom), count: (to - from) as u32 };
        if from < to { alloc::push(seams, seam) } else { Ok(()) }
    };
    match topology.contracted_link_set() {
        ContractedLinks::Sides(sides) => add(0, if sides.columns_closed { shape.columns() } else { 0 }),
        ContractedLinks::Matrix(matrix) => {
            let mut from = 0;
            for j in 0..shape.columns() {
                if !matrix.is_contracted(shape.vertical_link(shape.rows() - 1, j)) {
                    add(from, j)?;
                    from = j + 1;
                }
            }
            add(from, shape.columns())
        }
    }
}

/// Returns the topology with the links across a bridge contracted if `weld`, else with them free.
pub(super) fn with_bridge_links_contracted(topology: &Topology, bridge: &Bridge, weld: bool) -> Result<Topology> {
    let shape = topology.shape();
    let mut matrix: LinkMatrix = topology.to_link_matrix()?;
    for k in bridge.start as usize..bridge.end as usize {
        matrix.set_contracted(bridge.link_across(shape, k), weld);
    }
    let seams = alloc::copied(topology.seams())?;
    let topology = Topology::assemble_unchecked(shape, ContractedLinks::Matrix(matrix), seams, topology.is_reversed());
    topology.check_crossed_cells()?;
    Ok(topology)
}

/// Returns the form of the bridge between two nets.
pub(super) fn bridge_kind(a: &Topology, b: &Topology, direction: Direction) -> BridgeKind {
    let last = direction.line_count_and_length(a.shape()).0 - 1;
    match [ClosureOfSide::new(a, direction, last), ClosureOfSide::new(b, direction, 0)] {
        [ClosureOfSide::Point, ClosureOfSide::Point] => BridgeKind::Thread,
        [ClosureOfSide::Open, _] | [_, ClosureOfSide::Open] => BridgeKind::Ribbon,
        _ => BridgeKind::Tube,
    }
}

/// Returns true if a seam glues a whole side to nodes that contracted links identify. The side
/// belongs to a net whose links closed to its opposite pole before it was joined.
fn is_side_seamed_to_point(topology: &Topology, direction: Direction, i: usize) -> bool {
    let shape = topology.shape();
    let along = direction.line_count_and_length(shape).1;
    let is_side = |run: SeamRun| {
        let ends = [run.row_and_column_of_node(0), run.row_and_column_of_node(along as u32 - 1)];
        let [p, q] = ends.map(|(i, j)| direction.swap_unless_down(i, j));
        p.0 == i as i64 && q.0 == i as i64 && (p.1 - q.1).unsigned_abs() as usize == along - 1
    };
    let contracts = |pair: [u32; 2]| shape.links_between(pair).any(|link| topology.is_contracted(link));
    let is_point =
        |run: SeamRun| (1..along as u32).all(|k| contracts([run.node_index(shape, k - 1), run.node_index(shape, k)]));
    let mut seams = topology.seams().iter().filter(|seam| seam.count as usize == along);
    seams.any(|seam| (is_side(seam.a) && is_point(seam.b)) || (is_side(seam.b) && is_point(seam.a)))
}

/// The closure of a side: by the links along it, and the links and seams that glue it to others.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ClosureOfSide {
    Open,
    Closed,
    Point,
}

impl ClosureOfSide {
    fn new(topology: &Topology, direction: Direction, i: usize) -> Self {
        let shape = topology.shape();
        let (count, along) = direction.line_count_and_length(shape);
        let opposite = count - 1 - i;
        let is_opposite =
            || (0..along).all(|k| topology.is_contracted(direction.link_to_next_line(shape, count - 1, k)));
        let is_point = topology.is_line_contracted(direction, i)
            || (topology.is_line_contracted(direction, opposite) && is_opposite())
            || is_side_seamed_to_point(topology, direction, i);
        if is_point {
            ClosureOfSide::Point
        } else if topology.is_contracted(direction.link_within_line(shape, i, along - 1)) {
            ClosureOfSide::Closed
        } else {
            ClosureOfSide::Open
        }
    }
}
