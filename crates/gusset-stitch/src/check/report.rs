//! Result and entry point of the check.
//!
//! Components, edges and boundary come from the pairing of half-edges. Euler's formula V - E + F =
//! 2 - 2g - b gives the genus of an orientable manifold. O(H log d) time for H half-edges and
//! vertices of degree at most d; linear memory.

use super::bow_ties::find_bow_tie_vertices;
use super::duplicate_faces::find_duplicate_faces;
use crate::boundary::{self, boundary_loops};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::{DisjointSets, ParitySets};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Defect, MeshView, Opposite, Topology, unordered};

/// The result of [`check`]. Lists are ascending.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Check {
    /// The number of vertices, including unused ones.
    pub vertices: u32,
    /// The number of distinct edges: pairs of different vertices that are consecutive in a face.
    /// Degenerate faces are ignored.
    pub edges: u32,
    /// The number of faces.
    pub faces: u32,
    /// The number of components. Faces that share an edge belong to one component.
    pub components: u32,
    /// The number of walks around the boundary, fan by fan.
    pub boundary_walks: u32,
    /// Used vertices - edges + faces, including degenerate faces. Without these it is the Euler
    /// characteristic.
    pub euler: i64,
    /// True if there are edges, and every edge has exactly two faces. Degenerate faces are ignored.
    pub closed: bool,
    /// True without non-manifold edges and non-manifold vertices.
    pub manifold: bool,
    /// True if the two faces of every edge run it in opposite directions.
    pub oriented: bool,
    /// True if the faces can be oriented consistently by turning some over. Faces are compared
    /// across edges with two faces.
    pub orientable: bool,
    /// The total number of handles of all components; `None` unless the mesh is manifold and
    /// orientable without degenerate faces.
    pub genus: Option<u32>,

    /// The half-edges of the edges with exactly one face.
    pub boundary_edges: Vec<u32>,
    /// The first half-edge of each edge with three or more faces.
    pub non_manifold_edges: Vec<u32>,
    /// The ends of the non-manifold edges, and the bow-ties.
    pub non_manifold_vertices: Vec<u32>,
    /// Vertices whose faces form more than one fan. Fans end at edges with three or more faces, so
    /// the ends of these edges are usually included.
    pub bow_ties: Vec<u32>,
    /// The first half-edge of each edge whose two faces run it in the same direction.
    pub orientation_conflicts: Vec<u32>,
    /// Faces with the same cycle of vertices, in either direction, as an earlier face; without
    /// degenerate faces.
    pub duplicate_faces: Vec<u32>,
    /// Faces that repeat a vertex.
    pub degenerate_faces: Vec<u32>,
    /// Other faces without area: their vector area is 0 up to rounding.
    pub zero_area_faces: Vec<u32>,
    /// Vertices that no face uses.
    pub unused_vertices: Vec<u32>,
}

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

/// Number of half-edges between two progress reports.
const HALF_EDGES_PER_REPORT: usize = 1 << 20;

/// Checks a mesh. O(H log d) for H half-edges and vertices of degree d; linear extra memory, about
/// 40 bytes per half-edge.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled). Defects are not errors.
pub fn check(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Check> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.3))?;
    let mut report =
        Check { vertices: mesh.positions().len() as u32, faces: mesh.faces().len() as u32, ..Check::default() };
    report.list_defects(&topology)?;
    report.boundary_walks = boundary_loops(mesh, &boundary::Options::default(), &job.sub_job(0.3, 0.7))?.walk_count();
    report.bow_ties = find_bow_tie_vertices(mesh, &topology, &job.sub_job(0.7, 0.8))?;
    report.list_non_manifold_vertices(mesh, &job.sub_job(0.8, 0.8))?;
    report.duplicate_faces = find_duplicate_faces(mesh, &report.degenerate_faces, &job.sub_job(0.8, 0.85))?;
    report.count_edges(mesh, &topology, &job.sub_job(0.85, 0.85))?;
    report.count_components(mesh, &topology, &job.sub_job(0.85, 0.9))?;
    job.step(0.9, "checking areas")?;
    report.list_unused_vertices(mesh)?;
    report.zero_area_faces = find_zero_area_faces(mesh, &job.sub_job(0.9, 1.0))?;
    report.zero_area_faces.retain(|f| report.degenerate_faces.binary_search(f).is_err());

    report.manifold = report.non_manifold_edges.is_empty() && report.non_manifold_vertices.is_empty();
    report.oriented = report.orientation_conflicts.is_empty();
    report.closed = report.edges > 0 && report.boundary_edges.is_empty() && report.non_manifold_edges.is_empty();
    let used = i64::from(report.vertices) - report.unused_vertices.len() as i64;
    report.euler = used - i64::from(report.edges) + i64::from(report.faces);
    if report.manifold && report.orientable && report.degenerate_faces.is_empty() {
        // chi = 2 c - 2 g - b for c components, b boundary loops and g handles.
        let double = 2 * i64::from(report.components) - i64::from(report.boundary_walks) - report.euler;
        report.genus = u32::try_from(double / 2).ok();
    }
    job.step(1.0, "checking areas")?;
    Ok(report)
}

impl Check {
    fn list_defects(&mut self, topology: &Topology) -> Result<()> {
        for defect in topology.defects() {
            match *defect {
                Defect::DegenerateFace { face, .. } => alloc::push(&mut self.degenerate_faces, face)?,
                Defect::OrientationConflict { half_edges: [h, _] } => {
                    alloc::push(&mut self.orientation_conflicts, h)?;
                }
                Defect::NonManifoldEdge { half_edge, .. } => alloc::push(&mut self.non_manifold_edges, half_edge)?,
                Defect::BowTie { .. } => {}
            }
        }
        Ok(())
    }

    fn list_non_manifold_vertices(&mut self, mesh: &MeshView<'_>, job: &Job<'_>) -> Result<()> {
        let ends = self.non_manifold_edges.iter().flat_map(|&h| [h, mesh.faces().next(h)]);
        let vertices = self.bow_ties.iter().copied().chain(ends.map(|h| mesh.faces().corner(h)));
        self.non_manifold_vertices = alloc::gather(vertices)?;
        sort(&mut self.non_manifold_vertices, Ord::cmp, job, "checking faces")?;
        self.non_manifold_vertices.dedup();
        Ok(())
    }

    /// Counts the edges by the kind of their half-edges, and lists the boundary edges.
    fn count_edges(&mut self, mesh: &MeshView<'_>, topology: &Topology, job: &Job<'_>) -> Result<()> {
        let (mut halves, count) = (0, mesh.faces().half_edge_count());
        for h in 0..count as u32 {
            job.step_every(HALF_EDGES_PER_REPORT, h as usize, count, "checking faces")?;
            if topology.is_ignored(h) {
                continue;
            }
            match topology.opposite(h) {
                Opposite::Free => alloc::push(&mut self.boundary_edges, h)?,
                Opposite::Mate(_) => halves += 1,
                Opposite::Singular => {}
            }
        }
        self.edges = (self.boundary_edges.len() + halves / 2 + self.non_manifold_edges.len()) as u32;
        Ok(())
    }

    /// Counts the components, and determines whether all are orientable.
    fn count_components(&mut self, mesh: &MeshView<'_>, topology: &Topology, job: &Job<'_>) -> Result<()> {
        let faces = mesh.faces();
        let mut pieces = DisjointSets::new(faces.len())?;
        let mut orientations = ParitySets::new(faces.len())?;
        self.orientable = true;
        let mut singular = Vec::new();
        for f in 0..faces.len() {
            job.step_every(FACES_PER_REPORT, f, faces.len(), "checking pieces")?;
            for h in faces.corner_range(f) {
                if topology.is_ignored(h as u32) {
                    continue;
                }
                match topology.opposite(h as u32) {
                    Opposite::Free => {}
                    Opposite::Singular => {
                        let ends = [h as u32, faces.next(h as u32)].map(|h| faces.corner(h));
                        alloc::push(&mut singular, (unordered(ends), f as u32))?;
                    }
                    Opposite::Mate(mate) => {
                        let (f, g) = (f as u32, faces.face_of_half_edge(mate));
                        pieces.union(f, g);
                        let opposed = faces.corner(h as u32) == faces.corner(mate);
                        self.orientable &= orientations.union(f, g, opposed);
                    }
                }
            }
        }
        singular.sort_unstable();
        for pair in singular.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            pieces.union(pair[0].1, pair[1].1);
        }
        job.step(1.0, "checking pieces")?;
        self.components = pieces.roots().count() as u32;
        Ok(())
    }

    fn list_unused_vertices(&mut self, mesh: &MeshView<'_>) -> Result<()> {
        let mut used = alloc::filled(false, mesh.positions().len())?;
        for v in mesh.faces().corners(0..mesh.faces().half_edge_count()) {
            used[v as usize] = true;
        }
        self.unused_vertices = alloc::gather((0..).zip(used).filter(|&(_, used)| !used).map(|(v, _)| v))?;
        Ok(())
    }
}

/// Returns the faces without area: their vector area, the sum of (p_k - p_0) x (p_(k+1) - p_0) / 2,
/// is 0 up to the rounding of its terms. Ascending; O(H).
pub(crate) fn find_zero_area_faces(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<u32>> {
    let (mut points, mut found): (Vec<DVec3>, _) = (Vec::new(), Vec::new());
    for f in 0..mesh.faces().len() {
        job.step_every(FACES_PER_REPORT, f, mesh.faces().len(), "checking areas")?;
        points.clear();
        alloc::reserve(&mut points, mesh.faces().corner_range(f).len())?;
        points.extend(mesh.face(f).map(|v| mesh.positions().get(v)));
        let unit = common_unit(&points);
        let largest = points.iter().map(|p| (*p / unit).abs().max_element()).fold(0.0, f64::max);
        let origin = points[0] / unit;
        let (mut area, mut reach) = (DVec3::ZERO, 0.0_f64);
        for pair in points[1..].windows(2) {
            let (p, q) = (pair[0] / unit - origin, pair[1] / unit - origin);
            area += p.cross(q);
            reach = reach.max(p.length()).max(q.length());
        }
        // Each coordinate is known to half a unit in the last place of the largest one.
        let rounding = 8.0 * f64::EPSILON * largest * reach * points.len() as f64;
        if area.length() <= rounding {
            alloc::push(&mut found, f as u32)?;
        }
    }
    Ok(found)
}
