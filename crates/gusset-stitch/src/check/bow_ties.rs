//! Bow-tie vertices: vertices whose faces form more than one fan. Linear time.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Opposite, Topology};

/// Number of half-edges between two progress reports.
const HALF_EDGES_PER_REPORT: usize = 1 << 18;

/// Returns the vertices whose faces form more than one fan, ascending. Faces are neighbours in a
/// fan if they share an edge with exactly two faces.
pub(super) fn find_bow_tie_vertices(mesh: &MeshView<'_>, topology: &Topology, job: &Job<'_>) -> Result<Vec<u32>> {
    let faces = mesh.faces();
    let count = faces.half_edge_count();
    // A corner is identified by the half-edge that leaves it. Corners are joined across every edge
    // with two faces, at both ends.
    let mut corners = DisjointSets::new(count)?;
    let joining = job.sub_job(0.0, 0.7);
    for h in 0..count as u32 {
        joining.step_every(HALF_EDGES_PER_REPORT, h as usize, count, "checking fans")?;
        if topology.is_ignored(h) {
            continue;
        }
        if let Opposite::Mate(mate) = topology.opposite(h)
            && h < mate
        {
            join_corners_at_edge(mesh, topology, [h, mate], &mut corners);
        }
    }
    job.step(0.7, "checking fans")?;
    let mut fans = alloc::filled(0u32, mesh.positions().len())?;
    for h in (0..count as u32).filter(|&h| !topology.is_ignored(h)) {
        if corners.find(h) == h {
            fans[faces.corner(h) as usize] += 1;
        }
    }
    alloc::gather((0..).zip(fans).filter(|&(_, fans)| fans > 1).map(|(v, _)| v))
}

/// Joins the corners of two faces at both ends of their common edge.
pub(crate) fn join_corners_at_edge(
    mesh: &MeshView<'_>,
    topology: &Topology,
    [h, mate]: [u32; 2],
    corners: &mut DisjointSets,
) {
    let (next, mate_next) = (topology.next(mesh, h), topology.next(mesh, mate));
    if mesh.faces().corner(h) == mesh.faces().corner(mate) {
        corners.union(h, mate);
        corners.union(next, mate_next);
    } else {
        corners.union(h, mate_next);
        corners.union(next, mate);
    }
}
