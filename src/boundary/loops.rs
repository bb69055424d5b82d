//! All boundary loops of a mesh: options, results and the entry point.
//!
//! Chooses between `fast`, which reads the faces once, and the exact walk of `walk` over paired
//! half-edges, and orders the loops by their smallest half-edge. O(H log d) for H half-edges
//! and at most d at a vertex; linear extra memory.

use super::fast::ordinary_walks;
use super::options::{Options, Survey};
use super::split::split_simple;
use super::walk::{Dart, Walker};
use crate::alloc;
use crate::error::Result;
use crate::geom::scale::distance;
use crate::job::Job;
use crate::mesh::{Defect, MeshView, NONE, Topology};
use std::ops::Range;

/// What is unusual about a loop; a set of bits, 0 for an ordinary closed loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LoopFlags(pub u32);

impl LoopFlags {
    /// The chain does not close: it has one vertex more than it has edges. (A chain that ends at
    /// the vertex where it began, in another fan, counts as closed.)
    pub const OPEN: u32 = 1;
    /// It passes a vertex where the surface touches itself.
    pub const BOW_TIE: u32 = 2;
    /// It was cut from a longer walk at a vertex that the walk passed twice.
    pub const SPLIT: u32 = 4;
    /// It runs along, or ends at, an edge with three or more faces.
    pub const NON_MANIFOLD: u32 = 8;
    /// The faces along it disagree in orientation.
    pub const NOT_ORIENTED: u32 = 16;
    /// It has an edge of length 0.
    pub const ZERO_LENGTH: u32 = 32;

    /// True if any of `bits` is set.
    pub fn any(self, bits: u32) -> bool {
        self.0 & bits != 0
    }
}

/// What is unusual about one edge of a loop; a set of bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeFlags(pub u8);

impl EdgeFlags {
    /// The loop runs this edge against its face.
    pub const REVERSED: u8 = 1;
    /// The edge has three or more faces.
    pub const NON_MANIFOLD: u8 = 2;
    /// The edge has length 0.
    pub const ZERO_LENGTH: u8 = 4;
}

/// One loop, or one open chain. Edge `i` runs from vertex `i` to vertex `i + 1`, the last one of a
/// closed loop back to vertex 0.
#[derive(Debug, Clone, Copy)]
pub struct Loop<'a> {
    /// The vertices, each once.
    pub vertices: &'a [u32],
    /// The half-edge (corner index) that each edge is.
    pub half_edges: &'a [u32],
    /// The face that each edge borders.
    pub faces: &'a [u32],
    /// [`EdgeFlags`] of each edge.
    pub edge_flags: &'a [u8],
    /// [`LoopFlags`].
    pub flags: LoopFlags,
    /// The number of the closed walk or chain that this loop was cut from; walks are numbered from
    /// 0.
    pub walk: u32,
    /// The sum of the edges' lengths, in the unit of the positions.
    pub length: f64,
}

struct Record {
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
    records: Vec<Record>,
    vertices: Vec<u32>,
    half_edges: Vec<u32>,
    faces: Vec<u32>,
    edge_flags: Vec<u8>,
    defects: Vec<Defect>,
    walks: u32,
}

impl Boundary {
    /// The number of loops and open chains.
    pub fn len(&self) -> usize {
        self.records.len()
    }

    /// True if the mesh is closed.
    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Loop `i`, in the order of each loop's smallest half-edge, which is where a closed loop
    /// starts.
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

    /// All loops in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Loop<'_>> {
        (0..self.len()).map(|i| self.get(i).expect("i < len"))
    }

    /// The number of edges of all loops.
    pub fn edge_count(&self) -> usize {
        self.half_edges.len()
    }

    /// The number of walks before they were cut into simple loops.
    pub fn walk_count(&self) -> u32 {
        self.walks
    }

    /// What is wrong or unusual, sorted: degenerate faces, orientation conflicts and non-manifold
    /// edges of the whole mesh, and the bow-tie vertices that loops pass.
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }
}

/// Walks between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

/// Finds every free boundary loop of `mesh`.
///
/// O(H log d) for H half-edges and vertices of degree d; extra memory is linear: that of
/// [`Topology`], 5 bytes a vertex, and the border several times over. With [`Survey::BoundaryOnly`]
/// O(H + B log B) for a boundary of B edges, and 4 bytes a vertex for each thread, of which at most
/// 8 take part, unless the boundary is odd.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory),
/// [`Error::Cancelled`](crate::Error::Cancelled). Odd places of the mesh are no errors: see
/// [`LoopFlags`] and [`Boundary::defects`].
pub fn boundary_loops(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Boundary> {
    if options.survey == Survey::BoundaryOnly
        && let Some(walks) = ordinary_walks(mesh, &job.part(0.0, 0.5))?
    {
        let mut boundary = Boundary { walks: walks.len() as u32, ..Boundary::default() };
        for (number, walk) in walks.iter().enumerate() {
            if number % REPORT_INTERVAL == 0 {
                job.step(0.5 + 0.5 * number as f64 / walks.len() as f64, "walking along the boundary")?;
            }
            let walk_of = Walk { number: number as u32, closed: true, is_split: false };
            boundary.add(mesh, walk, true, &Ordinary, &walk_of)?;
        }
        job.step(1.0, "walking along the boundary")?;
        return Ok(boundary);
    }
    let done = if options.survey == Survey::BoundaryOnly { 0.5 } else { 0.0 };
    let job = &job.part(done, 1.0);
    let topology = Topology::new(mesh, &job.part(0.0, 0.9))?;
    let mut boundary = Boundary { defects: alloc::copied(topology.defects())?, ..Boundary::default() };
    let mut walker = Walker::new(mesh, &topology, options.non_manifold, job)?;
    let mut place = alloc::filled(NONE, mesh.positions().len())?;
    let mut walk = Vec::new();
    while let Some(closed_walk) = walker.next_walk(&mut walk)? {
        job.step(0.9 + 0.1 * walker.fraction(), "walking along the boundary")?;
        let number = boundary.walks;
        boundary.walks += 1;
        split_simple(
            &walk,
            |dart| dart.tail(mesh),
            |dart| dart.head(mesh),
            &mut place,
            |piece, closed| {
                let is_split = piece.len() < walk.len();
                boundary.add(mesh, piece, closed, &walker, &Walk { number, closed: closed_walk, is_split })
            },
        )?;
    }
    // In place: a stable sort would ask for memory that may not be there.
    boundary.records.sort_unstable_by_key(|r| r.smallest);
    alloc::extend(&mut boundary.defects, walker.bow_ties().map(|vertex| Defect::BowTie { vertex }))?;
    job.step(1.0, "walking along the boundary")?;
    Ok(boundary)
}

/// What is known of the edges and vertices that a loop passes.
trait Marks {
    /// The edge of `h` has three or more faces.
    fn is_singular(&self, h: u32) -> bool;
    /// The faces at `v` form more than one fan.
    fn is_bow_tie(&self, v: u32) -> bool;
}

/// Nothing unusual.
struct Ordinary;

impl Marks for Ordinary {
    fn is_singular(&self, _: u32) -> bool {
        false
    }

    fn is_bow_tie(&self, _: u32) -> bool {
        false
    }
}

impl Marks for Walker<'_, '_> {
    fn is_singular(&self, h: u32) -> bool {
        self.is_singular(h)
    }

    fn is_bow_tie(&self, v: u32) -> bool {
        self.is_bow_tie(v)
    }
}

/// What a piece inherits from the walk that it was cut from.
struct Walk {
    number: u32,
    closed: bool,
    is_split: bool,
}

impl Boundary {
    /// Appends one simple loop or chain.
    fn add(
        &mut self,
        mesh: &MeshView<'_>,
        piece: &[Dart],
        closed: bool,
        marks: &impl Marks,
        walk: &Walk,
    ) -> Result<()> {
        let against = piece.iter().filter(|dart| !dart.forward).count();
        let turned = 2 * against > piece.len();
        let order = Order { piece, turned, first: first_place(piece, closed, turned) };

        let mut flags = 0;
        if !closed {
            flags |= LoopFlags::OPEN;
        }
        if walk.is_split {
            flags |= LoopFlags::SPLIT;
        }
        if against != 0 && against != piece.len() {
            flags |= LoopFlags::NOT_ORIENTED;
        }
        if !walk.closed {
            flags |= LoopFlags::NON_MANIFOLD;
        }

        let (vertex_start, edge_start) = (self.vertices.len(), self.half_edges.len());
        alloc::reserve(&mut self.vertices, piece.len() + 1)?;
        alloc::reserve(&mut self.half_edges, piece.len())?;
        alloc::reserve(&mut self.faces, piece.len())?;
        alloc::reserve(&mut self.edge_flags, piece.len())?;
        let mut length = 0.0;
        for dart in order.darts() {
            let (tail, head) = (dart.tail(mesh), dart.head(mesh));
            let (from, to) = (mesh.positions().get(tail), mesh.positions().get(head));
            length += distance(from, to);
            let mut edge = 0;
            if !dart.forward {
                edge |= EdgeFlags::REVERSED;
            }
            if marks.is_singular(dart.half_edge) {
                edge |= EdgeFlags::NON_MANIFOLD;
                flags |= LoopFlags::NON_MANIFOLD;
            }
            if from == to {
                edge |= EdgeFlags::ZERO_LENGTH;
                flags |= LoopFlags::ZERO_LENGTH;
            }
            if marks.is_bow_tie(tail) {
                flags |= LoopFlags::BOW_TIE;
            }
            self.vertices.push(tail);
            self.half_edges.push(dart.half_edge);
            self.faces.push(mesh.faces().face_of(dart.half_edge));
            self.edge_flags.push(edge);
            if !closed && self.half_edges.len() == edge_start + piece.len() {
                self.vertices.push(head);
                if marks.is_bow_tie(head) {
                    flags |= LoopFlags::BOW_TIE;
                }
            }
        }
        let record = Record {
            smallest: self.half_edges[edge_start..].iter().copied().min().unwrap_or(NONE),
            vertices: vertex_start..self.vertices.len(),
            edges: edge_start..self.half_edges.len(),
            flags,
            walk: walk.number,
            length,
        };
        alloc::push(&mut self.records, record)
    }
}

/// The order in which the darts of a piece become edges: turned round if most run against their
/// faces, and from the smallest half-edge on if closed.
struct Order<'a> {
    piece: &'a [Dart],
    turned: bool,
    first: usize,
}

impl Order<'_> {
    fn darts(&self) -> impl Iterator<Item = Dart> {
        let n = self.piece.len();
        (0..n).map(move |i| {
            let i = (self.first + i) % n;
            if self.turned { self.piece[n - 1 - i].turned() } else { self.piece[i] }
        })
    }
}

/// Where the smallest half-edge of a closed piece lies in the (possibly turned) order; 0 for an
/// open chain.
fn first_place(piece: &[Dart], closed: bool, turned: bool) -> usize {
    if !closed {
        return 0;
    }
    let smallest = (0..piece.len()).min_by_key(|&i| piece[i].half_edge).unwrap_or(0);
    if turned { piece.len() - 1 - smallest } else { smallest }
}
