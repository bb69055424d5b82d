//! The radial order of faces around an edge.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::{sort, sort_stable};
use gusset_mesh::{MeshView, Opposite, Topology, unordered};
use robust::{Coord3D, orient3d};
use std::cmp::Ordering;

const STAGE: &str = "ordering faces around edges";

/// The half-edges of the edges with three or more faces, edge by edge. At each edge they are in
/// counter-clockwise order about the direction from its smaller to its larger vertex.
///
/// The order of triangles is exact. A larger face is represented by a point beside the edge, in the
/// direction of its mean normal. Faces in the same direction are in the order of their indices.
pub(super) struct EdgeFans {
    half_edges: Vec<u32>,
    /// The end of each edge in `half_edges`.
    fan_ends: Vec<u32>,
}

impl EdgeFans {
    /// Finds the fans. O(H) for H half-edges, plus O(k^1.5) and at most O(k log^2 k) comparisons for
    /// an edge of k faces.
    pub(super) fn find(mesh: &MeshView<'_>, topology: &Topology, job: &Job<'_>) -> Result<Self> {
        let border = topology.border_half_edges(&job.sub_job(0.0, 0.2))?;
        let singular = border.into_iter().filter(|&h| topology.opposite(h) == Opposite::Singular);
        let ends_of = |h: u32| [mesh.faces().corner(h), mesh.faces().corner(topology.next(mesh, h))];
        let mut keyed = alloc::gather(singular.map(|h| (unordered(ends_of(h)), h)))?;
        sort(&mut keyed, Ord::cmp, &job.sub_job(0.2, 0.6), STAGE)?;
        let mut fans = EdgeFans { half_edges: alloc::with_capacity(keyed.len())?, fan_ends: Vec::new() };
        let order = RadialOrder::new(mesh, topology, &keyed);
        for (k, group) in keyed.chunk_by_mut(|a, b| a.0 == b.0).enumerate() {
            job.sub_job(0.6, 1.0).step_within_list(k, STAGE)?;
            order.sort_around_edge(group)?;
            fans.half_edges.extend(group.iter().map(|&(_, h)| h));
            alloc::push(&mut fans.fan_ends, fans.half_edges.len() as u32)?;
        }
        Ok(fans)
    }

    /// Returns the fans of the half-edges for which `keep` returns true, without empty ones.
    pub(super) fn filtered(&self, keep: impl Fn(u32) -> bool) -> Result<EdgeFans> {
        let mut fans = EdgeFans { half_edges: Vec::new(), fan_ends: Vec::new() };
        for fan in self.iter() {
            alloc::extend(&mut fans.half_edges, fan.iter().copied().filter(|&h| keep(h)))?;
            if fans.fan_ends.last().copied().unwrap_or(0) < fans.half_edges.len() as u32 {
                alloc::push(&mut fans.fan_ends, fans.half_edges.len() as u32)?;
            }
        }
        Ok(fans)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.half_edges.is_empty()
    }

    /// Returns the half-edges of each edge.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[u32]> + Clone {
        let starts = std::iter::once(0).chain(self.fan_ends.iter().copied());
        starts.zip(&self.fan_ends).map(|(start, &end)| &self.half_edges[start as usize..end as usize])
    }
}

/// Compares faces by their angles around an edge.
struct RadialOrder<'m> {
    mesh: &'m MeshView<'m>,
    topology: &'m Topology,
    /// The coordinates are in this unit, so that determinants do not overflow.
    unit: f64,
}

impl<'m> RadialOrder<'m> {
    fn new(mesh: &'m MeshView<'m>, topology: &'m Topology, half_edges: &[(u64, u32)]) -> Self {
        let faces = half_edges.iter().map(|&(_, h)| mesh.faces().face_of_half_edge(h) as usize);
        let corners = faces.flat_map(|f| mesh.face(f));
        let largest = corners.map(|v| mesh.positions().get(v).abs().max_element()).fold(0.0, f64::max);
        RadialOrder { mesh, topology, unit: common_unit(&[DVec3::splat(largest)]) }
    }

    fn point(&self, v: u32) -> DVec3 {
        self.mesh.positions().get(v) / self.unit
    }

    /// Sorts the half-edges of one edge counter-clockwise, from the first face on.
    fn sort_around_edge(&self, group: &mut [(u64, u32)]) -> Result<()> {
        let Some(&(edge, first)) = group.first() else { return Ok(()) };
        let [u, v] = [(edge >> 32) as u32, edge as u32].map(|v| self.point(v));
        // Comparisons look up points often.
        let mut keyed = alloc::with_capacity(group.len())?;
        keyed.extend(group.iter().map(|&(_, h)| (h, self.face_point(h))));
        let start = self.face_point(first);
        let half_turn = |p: DVec3| match six_volumes(u, v, start, p) {
            side if side > 0.0 => 1,
            side if side < 0.0 => 3,
            _ if (p - u).reject_from(v - u).dot(start - u) >= 0.0 => 0,
            _ => 2,
        };
        let compare = |a: &(u32, DVec3), b: &(u32, DVec3)| {
            let halves = half_turn(a.1).cmp(&half_turn(b.1));
            let turn = six_volumes(u, v, a.1, b.1);
            halves.then(if turn > 0.0 {
                Ordering::Less
            } else if turn < 0.0 {
                Ordering::Greater
            } else {
                a.0.cmp(&b.0)
            })
        };
        sort_stable(&mut keyed, &compare);
        group.iter_mut().zip(keyed).for_each(|(entry, (h, _))| entry.1 = h);
        Ok(())
    }

    /// Returns a point of the half-plane from the edge through its face: the third vertex of a
    /// triangle.
    fn face_point(&self, h: u32) -> DVec3 {
        let f = self.mesh.faces().face_of_half_edge(h) as usize;
        if self.mesh.face(f).len() == 3 {
            return self.point(self.mesh.faces().corner(self.topology.previous(self.mesh, h)));
        }
        let start = self.point(self.mesh.faces().corner(h));
        let along = self.point(self.mesh.faces().corner(self.topology.next(self.mesh, h))) - start;
        start + self.face_normal(f).cross(along)
    }

    /// Returns the unit normal of a face by Newell's formula.
    fn face_normal(&self, f: usize) -> DVec3 {
        let corners = self.mesh.face(f).map(|v| self.point(v));
        let next = corners.clone().cycle().skip(1);
        let Some(origin) = corners.clone().next() else { return DVec3::ZERO };
        corners.zip(next).map(|(p, q)| (p - origin).cross(q - origin)).sum::<DVec3>().normalize_or_zero()
    }
}

/// Returns six times the volume of the tetrahedron (u, v, a, b): positive if a counter-clockwise
/// turn of less than half a circle about u-v takes the half-plane of a to b.
fn six_volumes(u: DVec3, v: DVec3, a: DVec3, b: DVec3) -> f64 {
    let at = |p: DVec3| Coord3D { x: p.x, y: p.y, z: p.z };
    orient3d(at(v), at(a), at(b), at(u))
}
