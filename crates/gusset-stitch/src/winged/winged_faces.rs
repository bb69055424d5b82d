//! The faces of a table of edges: the conversion from equation 2 back to a list of polygons.
//!
//! A side of an edge is a half-edge of its face. As R it runs from M to N; b follows it and d
//! precedes it. As L it runs from N to M; e follows it and c precedes it. A table belongs to a mesh
//! if the sides of each face, linked by the wings, form one cycle. This is checked for every side;
//! invalid tables are rejected, not repaired.

use super::winged_edges::{Winding, WingedEdge};
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{MAX_ELEMENTS, NONE};

/// Faces as consecutive corners, and the edges along them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct WingedFaces {
    /// The start of each face's corners, and the total number of corners.
    pub offsets: Vec<u32>,
    /// The vertices of the corners, face after face.
    pub corners: Vec<u32>,
    /// For each corner, the edge that leaves it.
    pub edges: Vec<u32>,
}

/// Number of sides between two progress reports.
const SIDES_PER_REPORT: usize = 1 << 16;

/// One side of an edge, in the direction in which its face runs in the tables.
#[derive(Clone, Copy)]
struct WingedSide {
    face: u32,
    start_vertex: u32,
    end_vertex: u32,
    edge_before: u32,
    edge_after: u32,
}

/// Returns the two sides of an edge: R, then L.
fn edge_sides(edge: &WingedEdge) -> [WingedSide; 2] {
    let &WingedEdge { m, n, b, c, d, e, left, right, .. } = edge;
    [
        WingedSide { face: right, start_vertex: m, end_vertex: n, edge_before: d, edge_after: b },
        WingedSide { face: left, start_vertex: n, end_vertex: m, edge_before: c, edge_after: e },
    ]
}

/// Returns the faces of a table of edges between `vertex_count` vertices, in the order of their
/// numbers.
///
/// Each face begins at its edge in `first_edges`. If both sides of that edge belong to the face, it
/// begins at the side that runs from M to N. Without `first_edges` it begins at its edge with the
/// smallest number. The marks are not read. Linear time and memory.
///
/// Edges and first edges of [`WingedEdges::new`](super::WingedEdges::new) give back the original
/// faces, corner for corner.
///
/// # Errors
/// [`Error::BadWings`] with the first edge whose record does not belong to a mesh;
/// [`Error::FaceTooSmall`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn faces(
    edges: &[WingedEdge],
    vertex_count: usize,
    first_edges: Option<&[u32]>,
    winding: Winding,
    job: &Job<'_>,
) -> Result<WingedFaces> {
    Error::check_count("edges", edges.len() as u64, MAX_ELEMENTS / 2)?;
    let bad = |edge: usize, why| Err(Error::BadWings { edge: edge as u64, why });
    let (checking, walking) = (job.sub_job(0.0, 0.4), job.sub_job(0.4, 1.0));
    let mut face_count = 0;
    for (i, edge) in edges.iter().enumerate() {
        checking.step_every(SIDES_PER_REPORT, i, edges.len(), "reading edges")?;
        if let Some(why) = invalid_reason(edge, edges.len(), vertex_count) {
            return bad(i, why);
        }
        let named = edge_sides(edge).map(|side| if side.face == NONE { 0 } else { side.face as usize + 1 });
        face_count = face_count.max(named[0]).max(named[1]);
    }
    let mut sizes = alloc::filled(0_u32, face_count)?;
    let named = |edge: &WingedEdge| edge_sides(edge).into_iter().filter(|side| side.face != NONE);
    edges.iter().flat_map(named).for_each(|side| sizes[side.face as usize] += 1);
    if let Some(face) = sizes.iter().position(|&size| size < 3) {
        return Err(Error::FaceTooSmall { face: face as u32, corners: sizes[face] });
    }
    let starts = first_sides(edges, face_count, first_edges, winding)?;

    let total = sizes.iter().map(|&size| size as usize).sum();
    let mut result = WingedFaces {
        offsets: alloc::with_capacity(face_count + 1)?,
        corners: alloc::with_capacity(total)?,
        edges: alloc::with_capacity(total)?,
    };
    result.offsets.push(0);
    for (face, (&size, start)) in sizes.iter().zip(starts).enumerate() {
        walking.step_every(SIDES_PER_REPORT, face, face_count, "walking round faces")?;
        let mut at = start;
        for step in 1..=size {
            let side = edge_sides(&edges[at.0 as usize])[at.1];
            // The faces of the mesh run in the opposite direction if they are counter-clockwise.
            let (corner, next) = match winding {
                Winding::Clockwise => (side.start_vertex, next_side(edges, at)),
                Winding::CounterClockwise => (side.end_vertex, previous_side(edges, at)),
            };
            result.corners.push(corner);
            result.edges.push(at.0);
            let Some(next) = next else {
                return bad(at.0 as usize, "it has a wing that is not next to it along its face");
            };
            // A walk that returns to the start for the first time after `size` steps has passed
            // each side once.
            if (next == start) != (step == size) {
                return bad(at.0 as usize, "the wings of its face do not form one cycle");
            }
            at = next;
        }
        result.offsets.push(result.corners.len() as u32);
    }
    job.step(1.0, "walking round faces")?;
    Ok(result)
}

/// Returns the reason why a record by itself is invalid.
fn invalid_reason(edge: &WingedEdge, edge_count: usize, vertex_count: usize) -> Option<&'static str> {
    let exists = |wing: u32| (wing as usize) < edge_count;
    if [edge.m, edge.n].iter().any(|&v| v as usize >= vertex_count) {
        return Some("it ends at a vertex that does not exist");
    }
    if edge.left == NONE && edge.right == NONE {
        return Some("it has no face");
    }
    for side in edge_sides(edge) {
        let wings = [side.edge_before, side.edge_after];
        match side.face {
            NONE if wings != [NONE; 2] => return Some("it has a wing on a side that has no face"),
            NONE => {}
            _ if !wings.into_iter().all(exists) => return Some("it has a wing that does not exist"),
            // Every face has at least three sides, so there are fewer faces than edges.
            face if face as usize >= edge_count => return Some("its face number is too large for the number of edges"),
            _ => {}
        }
    }
    None
}

/// Returns the first side of each face: an edge, and the index of its side in [`edge_sides`].
fn first_sides(
    edges: &[WingedEdge],
    face_count: usize,
    first_edges: Option<&[u32]>,
    winding: Winding,
) -> Result<Vec<(u32, usize)>> {
    // First the side on which a face of the mesh runs from M to N, then the other side.
    let order = match winding {
        Winding::Clockwise => [0, 1],
        Winding::CounterClockwise => [1, 0],
    };
    let at = |edge: u32, face: u32| {
        let found = order.into_iter().find(|&k| edge_sides(&edges[edge as usize])[k].face == face);
        found.map(|k| (edge, k))
    };
    let Some(given) = first_edges else {
        let mut starts = alloc::filled((NONE, 0), face_count)?;
        for edge in (0..edges.len() as u32).rev() {
            for k in [order[1], order[0]] {
                let face = edge_sides(&edges[edge as usize])[k].face;
                if face != NONE {
                    starts[face as usize] = (edge, k);
                }
            }
        }
        return Ok(starts);
    };
    if given.len() != face_count {
        return Err(Error::OptionOutOfRange {
            option: "first_edges",
            value: given.len() as f64,
            allowed: Allowed::from(face_count as f64..=face_count as f64),
        });
    }
    let mut starts = alloc::with_capacity(face_count)?;
    for (face, &edge) in given.iter().enumerate() {
        if edge as usize >= edges.len() {
            return Err(Error::BadWings {
                edge: edge.into(),
                why: "it is given as the first edge of a face, but does not exist",
            });
        }
        let Some(start) = at(edge, face as u32) else {
            return Err(Error::BadWings {
                edge: edge.into(),
                why: "it is given as the first edge of a face that it does not border",
            });
        };
        starts.push(start);
    }
    Ok(starts)
}

/// Returns the side that follows a side along its face, if the wings agree.
fn next_side(edges: &[WingedEdge], (edge, k): (u32, usize)) -> Option<(u32, usize)> {
    let side = edge_sides(&edges[edge as usize])[k];
    let next = edge_sides(&edges[side.edge_after as usize]);
    (0..2)
        .find(|&j| next[j].face == side.face && next[j].start_vertex == side.end_vertex && next[j].edge_before == edge)
        .map(|j| (side.edge_after, j))
}

/// Returns the side that precedes a side along its face, if the wings agree.
fn previous_side(edges: &[WingedEdge], (edge, k): (u32, usize)) -> Option<(u32, usize)> {
    let side = edge_sides(&edges[edge as usize])[k];
    let last = edge_sides(&edges[side.edge_before as usize]);
    (0..2)
        .find(|&j| last[j].face == side.face && last[j].end_vertex == side.start_vertex && last[j].edge_after == edge)
        .map(|j| (side.edge_before, j))
}
