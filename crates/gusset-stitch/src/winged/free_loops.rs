//! Algorithm 1 of the paper on the tables, with its errors corrected.
//!
//! The paper's criterion (3) for a free edge is printed as "L and R are NULL"; its text requires
//! exactly one. From a free edge the walk continues with the next one at the vertex reached, until
//! it returns. Here the next edge is found through the wings, from face to face around the vertex.
//! So a walk cannot leave its fan at a bow-tie, cannot turn back, and terminates. It starts in the
//! direction with the surface on the left, and is cut into simple loops.

use super::winged_edges::{EdgeMarks, WingedEdge, WingedEdges};
use crate::boundary::split_into_simple_loops;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::NONE;

/// Number of edges between two progress reports.
const EDGES_PER_REPORT: usize = 1 << 18;

const STAGE: &str = "walking along the boundary";

/// Simple closed loops of free edges, with the surface on the left.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FreeLoops {
    /// The vertices, loop after loop.
    pub vertices: Vec<u32>,
    /// The edges: edge i starts at vertex i.
    pub edges: Vec<u32>,
    /// The start of each loop in both lists, and the total length.
    pub offsets: Vec<u32>,
}

impl FreeLoops {
    /// Returns the vertices and the edges of each loop.
    pub fn iter(&self) -> impl Iterator<Item = (&[u32], &[u32])> {
        self.offsets.windows(2).map(|w| {
            let range = w[0] as usize..w[1] as usize;
            (&self.vertices[range.clone()], &self.edges[range])
        })
    }
}

/// An edge and the direction in which it is walked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct DirectedEdge {
    edge: u32,
    /// True from M to N, with L on the left; false from N to M, with R on the left.
    forward: bool,
}

/// Returns every loop of free edges, in the order of their smallest edges, from which each starts.
/// O(number of edges + the fans along the boundary).
///
/// An edge with several records has a border along each of them, as with
/// [`NonManifold::Cut`](crate::boundary::NonManifold::Cut). Here this includes edges whose faces
/// have inconsistent orientations. Walks start from edges without marks.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn free_loops(tables: &WingedEdges, job: &Job<'_>) -> Result<FreeLoops> {
    let edge = |step: DirectedEdge| &tables.edges()[step.edge as usize];
    let tail = |step: DirectedEdge| if step.forward { edge(step).m } else { edge(step).n };
    let head = |step: DirectedEdge| if step.forward { edge(step).n } else { edge(step).m };

    let mut seen = alloc::filled(false, tables.edges().len())?;
    let mut place = alloc::filled(NONE, tables.edge_of_vertex().len())?;
    let mut walk: Vec<DirectedEdge> = Vec::new();
    let mut loops: Vec<Vec<DirectedEdge>> = Vec::new();
    for (i, start) in tables.edges().iter().enumerate() {
        if !is_free_edge(start) || start.marks != 0 || seen[i] {
            continue;
        }
        let first = DirectedEdge { edge: i as u32, forward: start.left != NONE };
        let mut step = first;
        walk.clear();
        loop {
            job.step_every(EDGES_PER_REPORT, walk.len(), tables.edges().len(), STAGE)?;
            seen[step.edge as usize] = true;
            alloc::push(&mut walk, step)?;
            step = next_free_edge(tables, step, head(step));
            if step == first {
                break;
            }
        }
        job.step(0.0, STAGE)?;
        let keep = |piece: &[DirectedEdge], _| alloc::push(&mut loops, alloc::copied(piece)?);
        split_into_simple_loops(&walk, tail, head, &mut place, job, keep)?;
    }
    job.step(0.0, STAGE)?;
    for steps in &mut loops {
        let smallest = (0..steps.len()).min_by_key(|&k| steps[k].edge).unwrap_or(0);
        steps.rotate_left(smallest);
    }
    sort::sort_stable(&mut loops, &|a, b| a[0].edge.cmp(&b[0].edge));

    job.step(0.0, STAGE)?;
    let total = loops.iter().map(Vec::len).sum();
    let mut result = FreeLoops {
        vertices: alloc::with_capacity(total)?,
        edges: alloc::with_capacity(total)?,
        offsets: alloc::with_capacity(loops.len() + 1)?,
    };
    result.offsets.push(0);
    for steps in &loops {
        result.vertices.extend(steps.iter().map(|&step| tail(step)));
        result.edges.extend(steps.iter().map(|step| step.edge));
        result.offsets.push(result.edges.len() as u32);
    }
    job.step(1.0, STAGE)?;
    Ok(result)
}

/// Criterion (3) according to the text: exactly one side is NULL.
fn is_free_edge(edge: &WingedEdge) -> bool {
    (edge.left == NONE) != (edge.right == NONE) && edge.marks & EdgeMarks::DEGENERATE == 0
}

/// Returns the free edge that follows `step` at the vertex `v` where it arrives.
///
/// In the face on the step's left, another edge that arrives at v precedes the step's edge: the
/// wing c or d. If that edge lacks a face on its other side, it is the next edge, leaving v.
/// Otherwise the walk continues in that face. An edge with one face cannot be its own wing, because
/// a face has three proper edges.
fn next_free_edge(tables: &WingedEdges, step: DirectedEdge, v: u32) -> DirectedEdge {
    let mut at = &tables.edges()[step.edge as usize];
    let mut forward = step.forward;
    loop {
        // The face is L if the edge was reached running forward, otherwise R.
        let mut wing = if forward { at.c } else { at.d };
        at = &tables.edges()[wing as usize];
        // Skip degenerate edges, which lie within the face.
        while at.marks & EdgeMarks::DEGENERATE != 0 {
            wing = if at.left != NONE { at.c } else { at.d };
            at = &tables.edges()[wing as usize];
        }
        // The wing arrives at v. If it ends there, L is on its other side and runs it from N to M;
        // otherwise R is.
        let ends_here = at.n == v;
        let behind = if ends_here { at.left } else { at.right };
        if behind == NONE {
            return DirectedEdge { edge: wing, forward: !ends_here };
        }
        forward = ends_here;
    }
}
