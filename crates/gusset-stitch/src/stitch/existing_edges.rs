//! The edges of a mesh that already join two rims.

use super::stitch_rim::Rim;
use gusset_base::alloc;
use gusset_base::error::{Result, Side};
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;

/// The existing edges between two rims of one mesh. A meridian must not repeat one of them, because
/// the edge would get four faces.
pub struct ExistingEdges {
    edges: Vec<(u32, u32)>,
    /// True for the first and the last vertex of rim A if it has no fan: only one meridian meets it.
    ends_without_fan: [bool; 2],
}

impl ExistingEdges {
    /// Returns the empty set, for rims on different meshes.
    pub(super) fn empty() -> Self {
        ExistingEdges::from_edges(Vec::new())
    }

    /// Creates the set from edges that lead from rim A to rim B, in ascending order.
    pub(crate) fn from_edges(edges: Vec<(u32, u32)>) -> Self {
        ExistingEdges { edges, ends_without_fan: [false; 2] }
    }

    /// Returns the edges from rim B to rim A.
    pub(super) fn transposed(self) -> Result<Self> {
        let mut edges = alloc::collect(self.edges.iter().map(|&(u, v)| (v, u)))?;
        edges.sort_unstable();
        Ok(ExistingEdges { edges, ..self })
    }

    /// Excludes fans at the ends of rim A: only one meridian meets the first vertex, or the last.
    pub(super) fn without_fans(self, ends: [bool; 2]) -> Self {
        ExistingEdges { ends_without_fan: ends, ..self }
    }

    /// Finds the edges of `mesh` from a vertex of `a` to a vertex of `b`, in one pass over the
    /// half-edges.
    pub(super) fn find(mesh: &MeshView<'_>, a: &Rim, b: &Rim) -> Result<Self> {
        let mut side = alloc::filled(None, mesh.positions().len())?;
        a.vertices.iter().for_each(|&v| side[v as usize] = Some(Side::A));
        b.vertices.iter().for_each(|&v| side[v as usize] = Some(Side::B));
        let mut edges = Vec::new();
        for f in 0..mesh.faces().len() {
            let corners = mesh.face(f);
            for (u, v) in corners.clone().zip(corners.clone().cycle().skip(1)) {
                match (side[u as usize], side[v as usize]) {
                    (Some(Side::A), Some(Side::B)) => alloc::push(&mut edges, (u, v))?,
                    (Some(Side::B), Some(Side::A)) => alloc::push(&mut edges, (v, u))?,
                    _ => {}
                }
            }
        }
        sort_distinct(&mut edges);
        Ok(ExistingEdges::from_edges(edges))
    }

    /// Returns true if the mesh has an edge between vertex `u` of rim A and vertex `v` of rim B.
    pub(super) fn contains(&self, u: u32, v: u32) -> bool {
        !self.edges.is_empty() && self.edges.binary_search(&(u, v)).is_ok()
    }

    /// Returns true if a meridian or a diagonal must not join place `i` of rim A to place `j` of rim B.
    pub(super) fn forbid(&self, a: &Rim, b: &Rim, [i, j]: [usize; 2]) -> bool {
        let has_fan_at = |end: bool, corner: [usize; 2]| end && i == corner[0] && j != corner[1];
        has_fan_at(self.ends_without_fan[0], [0, 0])
            || has_fan_at(self.ends_without_fan[1], [a.vertices.len() - 1, b.vertices.len() - 1])
            || self.contains(a.vertices[i], b.vertices[j])
    }

    /// Returns the places (i, j) of the edges' ends on rims `a` and `b`.
    pub(super) fn lattice_nodes(&self, a: &Rim, b: &Rim) -> Result<Vec<[u32; 2]>> {
        if self.is_empty() {
            return Ok(Vec::new());
        }
        let places = |rim: &Rim| -> Result<Vec<(u32, u32)>> {
            let mut places = alloc::collect(rim.vertices.iter().enumerate().map(|(i, &v)| (v, i as u32)))?;
            places.sort_unstable();
            Ok(places)
        };
        let (on_a, on_b) = (places(a)?, places(b)?);
        let find = |places: &[(u32, u32)], v: u32| {
            places.binary_search_by_key(&v, |&(vertex, _)| vertex).ok().map(|at| places[at].1)
        };
        let mut nodes = alloc::with_capacity(self.edges.len() + 2 * b.vertices.len())?;
        nodes.extend(self.edges.iter().filter_map(|&(u, v)| Some([find(&on_a, u)?, find(&on_b, v)?])));
        let (last_a, last_b) = (a.vertices.len() as u32 - 1, b.vertices.len() as u32 - 1);
        if self.ends_without_fan[0] {
            nodes.extend((1..last_b + 1).map(|j| [0, j]));
        }
        if self.ends_without_fan[1] {
            nodes.extend((0..last_b).map(|j| [last_a, j]));
        }
        Ok(nodes)
    }

    /// Returns true if all meridians are possible.
    pub(super) fn is_empty(&self) -> bool {
        self.edges.is_empty() && self.ends_without_fan == [false; 2]
    }
}
