//! All boundary loops of a mesh: options, results and the entry point.
//!
//! Chooses between `fast`, which reads the faces once, and the exact walk of `walk` over paired
//! half-edges. Orders the loops by their smallest half-edges. O(H log d) for H half-edges and
//! vertices of degree at most d; linear extra memory.

use super::border_walker::{BorderWalker, DirectedHalfEdge};
use super::options::{Options, Survey};
use super::regular_walks::find_regular_walks;
use super::simple_loops::{STAGE, split_into_simple_loops};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_mesh::{Defect, MeshView, NONE, Topology};
use std::ops::Range;

/// Properties of a loop, as a set of bits; 0 for a regular closed loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LoopFlags(pub u32);

impl LoopFlags {
    /// The chain is open: it has one vertex more than it has edges. A chain that ends at its first
    /// vertex, but in another fan, counts as closed.
    pub const OPEN: u32 = 1;
    /// The loop passes a vertex at which the surface touches itself.
    pub const BOW_TIE: u32 = 2;
    /// The loop was cut from a walk that passes a vertex more than once.
    pub const SPLIT: u32 = 4;
    /// The loop runs along, or ends at, an edge with three or more faces.
    pub const NON_MANIFOLD: u32 = 8;
    /// The faces along the loop have inconsistent orientations.
    pub const NOT_ORIENTED: u32 = 16;
    /// The loop has an edge of length 0.
    pub const ZERO_LENGTH: u32 = 32;

    /// Returns true if any of `bits` is set.
    pub fn any(self, bits: u32) -> bool {
        self.0 & bits != 0
    }
}

/// Properties of one edge of a loop, as a set of bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeFlags(pub u8);

impl EdgeFlags {
    /// The loop runs the edge against its face.
    pub const REVERSED: u8 = 1;
    /// The edge has three or more faces.
    pub const NON_MANIFOLD: u8 = 2;
    /// The edge has length 0.
    pub const ZERO_LENGTH: u8 = 4;
}

/// One loop, or one open chain. Edge `i` runs from vertex `i` to vertex `i + 1`; the last edge of a
/// closed loop runs back to vertex 0.
#[derive(Debug, Clone, Copy)]
pub struct Loop<'a> {
    /// The vertices, each once.
    pub vertices: &'a [u32],
    /// The half-edge (corner index) of each edge.
    pub half_edges: &'a [u32],
    /// The face along each edge.
    pub faces: &'a [u32],
    /// The [`EdgeFlags`] of each edge.
    pub edge_flags: &'a [u8],
    /// The properties of the loop.
    pub flags: LoopFlags,
    /// The number of the closed walk or chain that this loop was cut from, counted from 0.
    pub walk: u32,
    /// The sum of the edge lengths, in the unit of the positions.
    pub length: f64,
}

struct LoopRecord {
    /// The smallest half-edge.
    smallest: u32,
    vertices: Range<usize>,
    edges: Range<usize>,
    flags: u32,
    walk: u32,
    length: f64,
}

/// The boundary of a mesh.
#[derive(Default)]
pub struct Boundary {
    records: Vec<LoopRecord>,
    vertices: Vec<u32>,
    half_edges: Vec<u32>,
    faces: Vec<u32>,
    edge_flags: Vec<u8>,
    defects: Vec<Defect>,
    walks: u32,
}

impl Boundary {
    /// Returns the number of loops and open chains.
    pub fn len(&self) -> usize {
        self.records.len()
    }

    /// Returns true if the mesh is closed.
    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Returns loop `i`. Loops are ordered by their smallest half-edges, at which closed loops
    /// start.
    pub fn get(&self, i: usize) -> Option<Loop<'_>> {
        self.records.get(i).map(|r| Loop {
            vertices: &self.vertices[r.vertices.clone()],
            half_edges: &self.half_edges[r.edges.clone()],
            faces: &self.faces[r.edges.clone()],
            edge_flags: &self.edge_flags[r.edges.clone()],
            flags: LoopFlags(r.flags),
            walk: r.walk,
            length: r.length,
        })
    }

    /// Returns all loops in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Loop<'_>> {
        (0..self.len()).map(|i| self.get(i).expect("i < len"))
    }

    /// Returns the number of edges of all loops.
    pub fn edge_count(&self) -> usize {
        self.half_edges.len()
    }

    /// Returns the number of walks before they were cut into simple loops.
    pub fn walk_count(&self) -> u32 {
        self.walks
    }

    /// Returns the defects in sorted order: degenerate faces, orientation conflicts and
    /// non-manifold edges of the whole mesh, and the bow-tie vertices on loops.
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }
}

/// Number of walks between two progress reports.
const WALKS_PER_REPORT: usize = 1 << 12;

/// Finds every free boundary loop of `mesh`.
///
/// O(H log d) for H half-edges and vertices of degree d. Extra memory is linear: [`Topology`], 5
/// bytes per vertex, and several copies of the border. With [`Survey::BoundaryOnly`] and a regular
/// boundary of B edges: O(H + B log B), and 4 bytes per vertex for each of at most 8 threads.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled). Irregularities of the mesh are not errors;
/// see [`LoopFlags`] and [`Boundary::defects`].
pub fn boundary_loops(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Boundary> {
    if options.survey == Survey::BoundaryOnly
        && let Some(walks) = find_regular_walks(mesh, &job.sub_job(0.0, 0.5))?
    {
        let mut boundary = Boundary { walks: walks.len() as u32, ..Boundary::default() };
        let walking = job.sub_job(0.5, 1.0);
        for (number, darts) in walks.iter().enumerate() {
            walking.step_every(WALKS_PER_REPORT, number, walks.len(), STAGE)?;
            let piece =
                SimpleWalkPiece { darts, closed: true, walk: number as u32, walk_closed: true, is_split: false };
            boundary.append_piece(mesh, &piece, None, &walking.sub_job_of_item(number, walks.len()))?;
        }
        job.step(1.0, STAGE)?;
        return Ok(boundary);
    }
    let done = if options.survey == Survey::BoundaryOnly { 0.5 } else { 0.0 };
    let job = &job.sub_job(done, 1.0);
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.9))?;
    job.step(0.9, STAGE)?;
    let mut boundary = Boundary { defects: alloc::copied(topology.defects())?, ..Boundary::default() };
    let mut walker = BorderWalker::new(mesh, &topology, options.non_manifold, job)?;
    job.step(0.9, STAGE)?;
    let mut place = alloc::filled(NONE, mesh.positions().len())?;
    let mut walk = Vec::new();
    let mut walking = job.sub_job(0.9, 1.0);
    while let Some(walk_closed) = walker.next_walk(&mut walk, &walking)? {
        walking = job.sub_job(0.9 + 0.1 * walker.visited_fraction(), 1.0);
        walking.step(0.0, STAGE)?;
        let number = boundary.walks;
        boundary.walks += 1;
        let add = |darts: &[DirectedHalfEdge], closed: bool| {
            let piece =
                SimpleWalkPiece { darts, closed, walk: number, walk_closed, is_split: darts.len() < walk.len() };
            boundary.append_piece(mesh, &piece, Some(&walker), &walking)
        };
        split_into_simple_loops(&walk, |dart| dart.tail(mesh), |dart| dart.head(mesh), &mut place, &walking, add)?;
    }
    // Sort in place: a stable sort would need memory that may be refused.
    boundary.records.sort_unstable_by_key(|r| r.smallest);
    alloc::extend(&mut boundary.defects, walker.bow_ties().map(|vertex| Defect::BowTie { vertex }))?;
    job.step(1.0, STAGE)?;
    Ok(boundary)
}

/// A simple loop or chain, and the properties of the walk that it was cut from.
struct SimpleWalkPiece<'a> {
    darts: &'a [DirectedHalfEdge],
    closed: bool,
    walk: u32,
    walk_closed: bool,
    /// True if the walk has other pieces.
    is_split: bool,
}

impl SimpleWalkPiece<'_> {
    /// Returns the darts as edges of the loop: reversed if `turned`, and from the smallest
    /// half-edge if closed.
    fn loop_edges(&self, turned: bool) -> impl Iterator<Item = DirectedHalfEdge> {
        let n = self.darts.len();
        let smallest = (0..n).min_by_key(|&i| self.darts[i].half_edge).unwrap_or(0);
        let first = match (self.closed, turned) {
            (false, _) => 0,
            (true, false) => smallest,
            (true, true) => n - 1 - smallest,
        };
        (first..first + n).map(move |i| match turned {
            true => self.darts[n - 1 - i % n].reversed(),
            false => self.darts[i % n],
        })
    }
}

impl Boundary {
    /// Appends a piece. `walker` knows the irregular edges and vertices; `None` if there are none.
    fn append_piece(
        &mut self,
        mesh: &MeshView<'_>,
        piece: &SimpleWalkPiece<'_>,
        walker: Option<&BorderWalker<'_, '_>>,
        job: &Job<'_>,
    ) -> Result<()> {
        let count = piece.darts.len();
        let against = piece.darts.iter().filter(|dart| !dart.forward).count();
        let mut flags = (u32::from(!piece.closed) * LoopFlags::OPEN)
            | (u32::from(piece.is_split) * LoopFlags::SPLIT)
            | (u32::from(against != 0 && against != count) * LoopFlags::NOT_ORIENTED)
            | (u32::from(!piece.walk_closed) * LoopFlags::NON_MANIFOLD);
        let bow_tie = |v: u32| u32::from(walker.is_some_and(|walker| walker.is_bow_tie(v))) * LoopFlags::BOW_TIE;

        let (vertex_start, edge_start) = (self.vertices.len(), self.half_edges.len());
        alloc::reserve(&mut self.vertices, count + 1)?;
        alloc::reserve(&mut self.half_edges, count)?;
        alloc::reserve(&mut self.faces, count)?;
        alloc::reserve(&mut self.edge_flags, count)?;
        let (mut length, mut end) = (0.0, NONE);
        for (k, dart) in piece.loop_edges(2 * against > count).enumerate() {
            job.step_within_list(k, STAGE)?;
            let (tail, head) = (dart.tail(mesh), dart.head(mesh));
            let (from, to) = (mesh.positions().get(tail), mesh.positions().get(head));
            length += overflow_safe_distance(from, to);
            let singular = walker.is_some_and(|walker| walker.is_non_manifold_edge(dart.half_edge));
            flags |= (u32::from(singular) * LoopFlags::NON_MANIFOLD)
                | (u32::from(from == to) * LoopFlags::ZERO_LENGTH)
                | bow_tie(tail);
            self.vertices.push(tail);
            self.half_edges.push(dart.half_edge);
            self.faces.push(mesh.faces().face_of_half_edge(dart.half_edge));
            self.edge_flags.push(
                (u8::from(!dart.forward) * EdgeFlags::REVERSED)
                    | (u8::from(singular) * EdgeFlags::NON_MANIFOLD)
                    | (u8::from(from == to) * EdgeFlags::ZERO_LENGTH),
            );
            end = head;
        }
        if !piece.closed {
            self.vertices.push(end);
            flags |= bow_tie(end);
        }
        let record = LoopRecord {
            smallest: self.half_edges[edge_start..].iter().copied().min().unwrap_or(NONE),
            vertices: vertex_start..self.vertices.len(),
            edges: edge_start..self.half_edges.len(),
            flags,
            walk: piece.walk,
            length,
        };
        alloc::push(&mut self.records, record)
    }
}
