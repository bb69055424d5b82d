//! Topologies of nets that are joined.

use crate::alloc;
use crate::error::Result;
use crate::net::arrange::Collected;
use crate::net::topology::{Links, Matrix, Run, Seam, Sides};
use crate::net::{Bridge, BridgeKind, Direction, Net, Shape, Topology};
use std::borrow::Cow;

/// All nets' gluing, and nothing glued between them unless they are welded.
pub(super) fn joined(nets: &[&Net<'_>], direction: Direction, weld: bool) -> Result<Topology> {
    let mut topologies: Vec<Cow<'_, Topology>> = alloc::with_capacity(nets.len())?;
    for net in nets {
        topologies.push(match direction {
            Direction::Down => Cow::Borrowed(net.topology()),
            Direction::Right => Cow::Owned(net.topology().transposed()?),
        });
    }
    let stacked = stacked(&topologies, weld)?;
    let topology = match direction {
        Direction::Down => stacked,
        Direction::Right => stacked.transposed()?,
    };
    if weld {
        topology.check_crossings()?;
    }
    Ok(topology)
}

/// One below the other. A link that leads back within a row still does; one that leads back from the last row of a net
/// becomes part of a seam.
fn stacked(topologies: &[Cow<'_, Topology>], weld: bool) -> Result<Topology> {
    if let [only] = topologies {
        return Ok(only.clone().into_owned());
    }
    let columns = topologies[0].shape().columns();
    let rows: usize = topologies.iter().map(|topology| topology.shape().rows()).sum();
    let shape = Shape::new(rows, columns)?;
    let reversed = topologies[0].is_reversed();
    // Rows that are closed alike, and no poles: sides say it, and no matrix is needed.
    let rows_closed = topologies[0].sides().is_some_and(|sides| sides.rows_closed);
    let plain = Sides { rows_closed, ..Sides::SHEET };
    let is_plain = |topology: &Cow<'_, Topology>| {
        topology.sides().is_some_and(|sides| Sides { columns_closed: false, ..sides } == plain)
    };
    let all_plain = !weld && topologies.iter().all(is_plain);
    let mut links = Collected::new(shape);
    let mut seams = Vec::new();
    let mut first = 0;
    for (k, topology) in topologies.iter().enumerate() {
        if !all_plain {
            add_links(topology, first, &mut links)?;
        }
        close(topology, first, &mut seams)?;
        for seam in topology.seams() {
            let down = |run: Run| Run { row: run.row + first as u32, ..run };
            alloc::push(&mut seams, Seam { a: down(seam.a), b: down(seam.b), ..*seam })?;
        }
        first += topology.shape().rows();
        if weld && k + 1 < topologies.len() {
            (0..columns).try_for_each(|j| links.add(2 * shape.node(first - 1, j) + 1))?;
        }
    }
    let links = if all_plain { Links::Sides(plain) } else { links.links() };
    Topology::assembled(shape, links, seams, reversed)
}

/// The links of a net that starts at row `first`, but for those that lead back from its last row.
fn add_links(topology: &Topology, first: usize, links: &mut Collected) -> Result<()> {
    let shape = topology.shape();
    let (shift, last) = (2 * shape.node(first, 0), 2 * shape.node(shape.rows() - 1, 0));
    let mut done = Ok(());
    topology.each_contracted(|link| {
        if done.is_ok() && (link < last || link % 2 == 0) {
            done = links.add(shift + link);
        }
    });
    done
}

/// The links that lead back from the last row, as seams: one for each run of them.
fn close(topology: &Topology, first: usize, seams: &mut Vec<Seam>) -> Result<()> {
    let shape = topology.shape();
    let [top, bottom] = [first, first + shape.rows() - 1].map(|row| row as u32);
    let mut add = |from: usize, to: usize| {
        let run = |row: u32| Run::along_row(row, from as u32, 1);
        let seam = Seam { a: run(top), b: run(bottom), count: (to - from) as u32 };
        if from < to { alloc::push(seams, seam) } else { Ok(()) }
    };
    match topology.links() {
        Links::Sides(sides) => add(0, if sides.columns_closed { shape.columns() } else { 0 }),
        Links::Matrix(matrix) => {
            let mut from = 0;
            for j in 0..shape.columns() {
                if !matrix.get(2 * shape.node(shape.rows() - 1, j) + 1) {
                    add(from, j)?;
                    from = j + 1;
                }
            }
            add(from, shape.columns())
        }
    }
}

/// The same topology with the links across a bridge contracted, or not.
pub(super) fn welded(topology: &Topology, bridge: &Bridge, weld: bool) -> Result<Topology> {
    let shape = topology.shape();
    let mut matrix: Matrix = topology.matrix()?;
    for k in bridge.start as usize..bridge.end as usize {
        matrix.set(bridge.link(shape, k), weld);
    }
    let seams = alloc::copied(topology.seams())?;
    let topology = Topology::assembled(shape, Links::Matrix(matrix), seams, topology.is_reversed())?;
    topology.check_crossings()?;
    Ok(topology)
}

/// What the bridge between two nets looks like.
pub(super) fn kind(a: &Topology, b: &Topology, direction: Direction) -> Result<BridgeKind> {
    let last = direction.extent(a.shape()).0 - 1;
    let sides = [Side::new(a, direction, last), Side::new(b, direction, 0)];
    Ok(match sides {
        [Side::Point, Side::Point] => BridgeKind::Thread,
        [Side::Open, _] | [_, Side::Open] => BridgeKind::Ribbon,
        _ => BridgeKind::Tube,
    })
}

/// True if a seam says that a side is nodes that contracted links make a point: the side of a net whose links led back to its
/// opposite pole, before it was joined to others.
fn is_sewn_to_a_point(topology: &Topology, direction: Direction, i: usize) -> bool {
    let shape = topology.shape();
    let along = direction.extent(shape).1;
    let is_side = |run: Run| {
        let ends = [run.place(0), run.place(along as u32 - 1)];
        let [p, q] = ends.map(|(row, column)| if direction == Direction::Down { (row, column) } else { (column, row) });
        p.0 == i as i64 && q.0 == i as i64 && (p.1 - q.1).unsigned_abs() as usize == along - 1
    };
    let contracts = |[a, b]: [u32; 2]| {
        let links = [2 * a, 2 * a + 1, 2 * b, 2 * b + 1];
        links.into_iter().any(|link| {
            let [p, q] = shape.ends(link);
            ([p, q] == [a, b] || [q, p] == [a, b]) && topology.contracts(link)
        })
    };
    let is_point = |run: Run| {
        let node = |k: u32| {
            let (i, j) = run.place(k);
            shape.node(i as usize, j as usize)
        };
        (1..along as u32).all(|k| contracts([node(k - 1), node(k)]))
    };
    let mut seams = topology.seams().iter().filter(|seam| seam.count as usize == along);
    seams.any(|seam| (is_side(seam.a) && is_point(seam.b)) || (is_side(seam.b) && is_point(seam.a)))
}

/// What a side is, as the links along it say, and the links and seams that glue it to others.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Open,
    Closed,
    Point,
}

impl Side {
    fn new(topology: &Topology, direction: Direction, i: usize) -> Self {
        let shape = topology.shape();
        let (count, along) = direction.extent(shape);
        let back = |from_last: usize| match direction {
            Direction::Down => 2 * shape.node(count - 1, from_last) + 1,
            Direction::Right => 2 * shape.node(from_last, count - 1),
        };
        let closes = match direction {
            Direction::Down => 2 * shape.node(i, along - 1),
            Direction::Right => 2 * shape.node(along - 1, i) + 1,
        };
        let opposite = count - 1 - i;
        let same = || (0..along).all(|k| topology.contracts(back(k)));
        let point = topology.is_point(direction, i)
            || (topology.is_point(direction, opposite) && same())
            || is_sewn_to_a_point(topology, direction, i);
        if point {
            Side::Point
        } else if topology.contracts(closes) {
            Side::Closed
        } else {
            Side::Open
        }
    }
}
