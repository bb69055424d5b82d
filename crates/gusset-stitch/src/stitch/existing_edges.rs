//! The edges of a mesh that already join two rims.

use super::stitch_rim::Rim;
use gusset_base::alloc;
use gusset_base::error::{Result, Side};
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;

/// The existing edges between two rims of one mesh. A meridian must not repeat one of them, because
/// the edge would get four faces.
pub struct ExistingEdges(Vec<(u32, u32)>);

impl ExistingEdges {
    /// Returns the empty set, for rims on different meshes.
    pub(super) fn empty() -> Self {
        ExistingEdges(Vec::new())
    }

    /// Creates the set from edges that lead from rim A to rim B, in ascending order.
    pub(crate) fn from_edges(edges: Vec<(u32, u32)>) -> Self {
        ExistingEdges(edges)
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
        Ok(ExistingEdges(edges))
    }

    /// Returns true if the mesh has an edge between vertex `u` of rim A and vertex `v` of rim B.
    pub(super) fn contains(&self, u: u32, v: u32) -> bool {
        !self.0.is_empty() && self.0.binary_search(&(u, v)).is_ok()
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
        let mut nodes = alloc::with_capacity(self.0.len())?;
        nodes.extend(self.0.iter().filter_map(|&(u, v)| Some([find(&on_a, u)?, find(&on_b, v)?])));
        Ok(nodes)
    }

    /// Returns true if no edge joins the rims.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
