//! The walk from free edge to free edge, through the fan of faces around each vertex.
//!
//! Source: Nesterenko, algorithm 1, as corrected (see the parent module). Every free edge has one
//! successor and one predecessor, so the walk is a permutation of the free edges and visits each
//! once. O(faces of the fans).

use super::options::NonManifold;
use super::simple_loops::STAGE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Opposite, Topology};

/// A half-edge with a direction of travel; `forward` means its own direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct DirectedHalfEdge {
    pub(super) half_edge: u32,
    pub(super) forward: bool,
}

impl DirectedHalfEdge {
    pub(super) fn reversed(self) -> DirectedHalfEdge {
        DirectedHalfEdge { forward: !self.forward, ..self }
    }

    /// Returns the start vertex.
    pub(super) fn tail(self, mesh: &MeshView<'_>) -> u32 {
        if self.forward { start_vertex(mesh, self.half_edge) } else { end_vertex(mesh, self.half_edge) }
    }

    /// Returns the end vertex.
    pub(super) fn head(self, mesh: &MeshView<'_>) -> u32 {
        self.reversed().tail(mesh)
    }
}

fn start_vertex(mesh: &MeshView<'_>, h: u32) -> u32 {
    mesh.faces().corner(h)
}

fn end_vertex(mesh: &MeshView<'_>, h: u32) -> u32 {
    mesh.faces().corner(mesh.faces().next(h))
}

/// Finds the walks along the border one after another.
pub(super) struct BorderWalker<'m, 'a> {
    mesh: &'m MeshView<'a>,
    topology: &'m Topology,
    non_manifold_mode: NonManifold,
    /// The half-edges of free and of non-manifold edges, ascending.
    border: Vec<u32>,
    /// For each entry of `border`, true if it belongs to a walk.
    visited: Vec<bool>,
    /// The next entry of `border` to start from.
    next_border_entry: usize,
    /// For each vertex, true if a walk passed it and its faces form more than one fan.
    bow_tie: Vec<bool>,
}

impl<'m, 'a> BorderWalker<'m, 'a> {
    pub(super) fn new(
        mesh: &'m MeshView<'a>,
        topology: &'m Topology,
        mode: NonManifold,
        job: &Job<'_>,
    ) -> Result<Self> {
        let border = topology.border_half_edges(job)?;
        let visited = alloc::filled(false, border.len())?;
        let bow_tie = alloc::zeroed(mesh.positions().len())?;
        Ok(BorderWalker { mesh, topology, non_manifold_mode: mode, border, visited, next_border_entry: 0, bow_tie })
    }

    /// Returns the fraction of the border that has been visited.
    pub(super) fn visited_fraction(&self) -> f64 {
        self.next_border_entry as f64 / self.border.len().max(1) as f64
    }

    /// Returns true if the edge of `h` has three or more faces.
    pub(super) fn is_non_manifold_edge(&self, h: u32) -> bool {
        self.topology.opposite(h) == Opposite::Singular
    }

    /// Returns true if a walk passed `v` and its faces form more than one fan.
    pub(super) fn is_bow_tie(&self, v: u32) -> bool {
        self.bow_tie[v as usize]
    }

    /// Writes the next walk to `walk`, and returns whether it is closed; `None` if every free edge
    /// has been visited. Walks start only at free edges: a walk of non-manifold edges alone does
    /// not bound a hole.
    pub(super) fn next_walk(&mut self, walk: &mut Vec<DirectedHalfEdge>, job: &Job<'_>) -> Result<Option<bool>> {
        walk.clear();
        let start = loop {
            let Some(&h) = self.border.get(self.next_border_entry) else {
                return Ok(None);
            };
            self.next_border_entry += 1;
            if !self.visited[self.next_border_entry - 1] && !self.is_non_manifold_edge(h) {
                break DirectedHalfEdge { half_edge: h, forward: true };
            }
        };
        if self.follow_border(start, walk, job)? {
            return Ok(Some(true));
        }
        // An open chain: walk back from the start too, and join the two parts.
        let mut back = Vec::new();
        self.follow_border(start.reversed(), &mut back, job)?;
        alloc::reserve(walk, back.len())?;
        let ahead = walk.len();
        walk.extend(back[1..].iter().map(|dart| dart.reversed()).rev());
        walk.rotate_left(ahead);
        Ok(Some(false))
    }

    /// Appends the walk from `start`. Returns true if it came back to the start.
    fn follow_border(
        &mut self,
        start: DirectedHalfEdge,
        walk: &mut Vec<DirectedHalfEdge>,
        job: &Job<'_>,
    ) -> Result<bool> {
        let mut dart = start;
        loop {
            job.step_within_list(walk.len(), STAGE)?;
            alloc::push(walk, dart)?;
            if let Ok(i) = self.border.binary_search(&dart.half_edge) {
                self.visited[i] = true;
            }
            match self.next_border_dart(dart) {
                None => return Ok(false),
                Some(next) if next == start => return Ok(true),
                Some(next) => dart = next,
            }
        }
    }

    /// Returns the border edge that follows `dart` around the fan at its head; `None` at a
    /// non-manifold edge that ends walks.
    fn next_border_dart(&mut self, dart: DirectedHalfEdge) -> Option<DirectedHalfEdge> {
        let v = dart.head(self.mesh);
        let mut corners = 0;
        // `arriving` tells whether half-edge h runs towards v. If so, the other edge at v follows
        // h; otherwise it precedes h.
        let (mut h, mut arriving) = (dart.half_edge, dart.forward);
        loop {
            corners += 1;
            let other = if arriving { self.topology.next(self.mesh, h) } else { self.topology.previous(self.mesh, h) };
            let across = self.topology.opposite(other);
            if let Opposite::Mate(mate) = across {
                h = mate;
                arriving = start_vertex(self.mesh, mate) != v;
                continue;
            }
            if corners < self.topology.corner_count(v) {
                self.bow_tie[v as usize] = true;
            }
            let stop = across == Opposite::Singular && self.non_manifold_mode == NonManifold::Stop;
            return (!stop).then_some(DirectedHalfEdge { half_edge: other, forward: arriving });
        }
    }

    /// Returns the bow-tie vertices that walks passed, ascending.
    pub(super) fn bow_ties(&self) -> impl Iterator<Item = u32> + '_ {
        self.bow_tie.iter().enumerate().filter(|&(_, &is)| is).map(|(v, _)| v as u32)
    }
}
