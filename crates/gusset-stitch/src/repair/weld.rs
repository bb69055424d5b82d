//! Welding: merging of vertices that lie together.
//!
//! By default borders are **sewn**: pairs of coincident free edges become one edge, and their ends
//! are merged. If more than two coincide, none is preferred. A pair is skipped if sewing it would
//! merge two corners of a face, or put more than two faces at an edge: a manifold stays a manifold.
//! With [`Vertices::All`], **all** coincident vertices are merged, as triangle soups need, whatever
//! happens to the edges. The orientation of the faces does not matter: sheets may be inside out
//! relative to each other.
//!
//! With a tolerance, each unclaimed vertex in ascending order claims the unclaimed vertices within
//! the tolerance, nearest first. So clusters do not chain. Groups of vertices that are narrower
//! than the tolerance, and farther apart than it, are found for any vertex order. The default
//! tolerance covers the rounding of the coordinates, and keeps the ends of every edge apart: see
//! `tolerance`.

use super::near_borders::NearBorders;
use super::sew_edges::{free_vertices, is_free, sew_coincident_edges};
use super::vertex_clusters::VertexClusters;
use super::vertex_corners::VertexCorners;
use super::weld_tolerance::{ToleranceSource, WeldDistances};
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, MeshView, NONE, PositionBuffer, Topology, half_edges, unordered};

/// Number of faces, or edges, between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 18;

const STAGE: &str = "welding";

/// The vertices to weld.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Vertices {
    /// The ends of free edges. Borders that coincide are sewn edge to edge.
    #[default]
    Boundary,
    /// All vertices that faces use.
    All,
}

choices! { for Vertices:
    Boundary => "Borders", "Coincident pairs of boundary edges become one edge.";
    All => "All vertices", "All coincident vertices become one, even if an edge then has three or more faces.";
}

/// Options of [`weld`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The vertices to weld.
    pub vertices: Vertices,
    /// The largest distance between vertices that are merged, finite and at least 0. 0 requires
    /// equal positions, where -0 equals 0.
    ///
    /// `None` derives it from the data: it covers rounding to the coordinates' type, or to their
    /// visible decimal digits. At each vertex it is limited to a quarter of the shortest edge
    /// there, so that edges do not collapse. If `collapse` is set, edges within the rounding of the
    /// coordinates' type are not counted.
    pub tolerance: Option<f64>,
    /// If true, corners of one face may be merged. Successive equal corners become one, and a face
    /// with fewer than three different vertices is dropped. If false, corners of one face stay
    /// apart.
    pub collapse: bool,
    /// If true, vertices that no face of the result uses are removed.
    pub remove_unused: bool,
}

/// A welded mesh and its maps. Indices refer to the old mesh; lists are ascending.
#[derive(Debug, Clone, PartialEq)]
pub struct Weld {
    /// The old faces in their order, each from its own first corner, and the remaining vertices in
    /// their order. Merged vertices are replaced by the smallest, whose position keeps its bits.
    pub mesh: Mesh,
    /// For each old vertex, the new one; [`NONE`] if it was removed as unused.
    pub vertex_map: Vec<u32>,
    /// For each old face, the new one; [`NONE`] if it was dropped.
    pub face_map: Vec<u32>,
    /// The number of corners of the old mesh.
    pub old_corners: usize,
    /// For each corner of the mesh, the old one; `None` if all remain.
    pub corners_left: Option<Vec<u32>>,
    /// The number of vertices that were merged into a smaller one.
    pub welded_vertices: u32,
    /// The largest allowed distance between coincident vertices; less at short edges.
    pub tolerance: f64,
    /// The number of edges with two faces that were two free edges.
    pub sewn_edges: u32,
    /// The number of dropped faces.
    pub dropped_faces: u32,
    /// Half-edges of free edges that coincide with another edge but were not sewn to it: three or
    /// more edges coincide, or sewing would do harm. With [`Vertices::All`] they may now form one
    /// edge with three or more faces.
    pub left_edges: Vec<u32>,
    /// Vertices that coincide with another vertex but were not merged with it.
    pub left_vertices: Vec<u32>,
    /// Free edges that coincide with others beyond the tolerance.
    pub near: NearBorders,
}

/// Welds a mesh. O(n log n) for meshes of bounded degree; linear extra memory.
///
/// # Errors
/// [`OptionOutOfRange`](gusset_base::Error::OptionOutOfRange) for a tolerance that is negative or not finite,
/// [`OutOfMemory`](gusset_base::Error::OutOfMemory), [`Cancelled`](gusset_base::Error::Cancelled).
pub fn weld(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Weld> {
    let welded = weld_within(mesh, options, ToleranceSource::from_option(options.tolerance)?, job)?;
    welded.near.note_hint(job);
    Ok(welded)
}

/// Welds with a tolerance from another source than the options.
pub(super) fn weld_within(
    mesh: &MeshView<'_>,
    options: &Options,
    source: ToleranceSource,
    job: &Job<'_>,
) -> Result<Weld> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.2))?;
    let sewing = options.vertices == Vertices::Boundary;
    job.step(0.2, STAGE)?;
    let members = weldable_vertices(mesh, &topology, sewing)?;
    let tolerance = WeldDistances::find_for_members(mesh, &members, source, options.collapse, &job.sub_job(0.2, 0.3))?;
    job.step(0.3, STAGE)?;
    let corners =
        if sewing || options.collapse { None } else { Some(VertexCorners::new(mesh, &job.sub_job(0.3, 0.3))?) };
    let part = job.sub_job(0.3, 0.6);
    let mut clusters = match source {
        ToleranceSource::Given(length) if length > 0.0 && sewing && !options.collapse => {
            VertexClusters::cluster_across_borders(mesh, &members, length, &part)?
        }
        _ => {
            VertexClusters::cluster_members(mesh, &members, &tolerance.max_distance_of_member, corners.as_ref(), &part)?
        }
    };
    let representative = match sewing {
        true => {
            sew_coincident_edges(mesh, &topology, &clusters.representative, options.collapse, &job.sub_job(0.6, 0.9))?
        }
        false => alloc::copied(&clusters.representative)?,
    };
    let mut welded = rebuild_mesh(mesh, &representative, options, &job.sub_job(0.9, 0.95))?;
    welded.tolerance = tolerance.max_distance;
    let places = [&clusters.representative[..], &representative];
    welded.count_sewn_edges(mesh, &topology, places, sewing, &job.sub_job(0.95, 0.97))?;
    if sewing {
        let (places, sewn) = (&clusters.representative, welded.sewn_edges);
        welded.near = NearBorders::find(mesh, &topology, &members, places, sewn, &job.sub_job(0.97, 1.0))?;
    }
    clusters.add_unmerged_members(&members, &representative, &job.sub_job(1.0, 1.0))?;
    welded.left_vertices = clusters.kept_apart;
    job.step(1.0, STAGE)?;
    Ok(welded)
}

/// Returns the vertices that may be welded, ascending.
fn weldable_vertices(mesh: &MeshView<'_>, topology: &Topology, boundary: bool) -> Result<Vec<u32>> {
    if boundary {
        return free_vertices(mesh, topology);
    }
    let mut marked = alloc::filled(false, mesh.positions().len())?;
    mesh.faces().corners(0..mesh.faces().half_edge_count()).for_each(|v| marked[v as usize] = true);
    alloc::gather((0..).zip(&marked).filter(|&(_, &m)| m).map(|(v, _)| v))
}

impl VertexClusters {
    /// Adds the members of clusters that were not merged into one vertex to those kept apart, and
    /// sorts these.
    fn add_unmerged_members(&mut self, members: &[u32], representative: &[u32], job: &Job<'_>) -> Result<()> {
        job.step(0.0, STAGE)?;
        let mut split = alloc::filled(false, self.representative.len())?;
        for &v in members {
            let cluster = self.representative[v as usize] as usize;
            split[cluster] |= representative[v as usize] != representative[cluster];
        }
        job.step(0.0, STAGE)?;
        let split = members.iter().filter(|&&v| split[self.representative[v as usize] as usize]);
        alloc::extend(&mut self.kept_apart, split.copied())?;
        sort(&mut self.kept_apart, Ord::cmp, job, STAGE)?;
        self.kept_apart.dedup();
        Ok(())
    }
}

/// Returns the mesh with each vertex replaced by its representative, and the maps.
pub(super) fn rebuild_mesh(
    mesh: &MeshView<'_>,
    representative: &[u32],
    options: &Options,
    job: &Job<'_>,
) -> Result<Weld> {
    job.step(0.0, STAGE)?;
    let faces = mesh.faces();
    let mut face_map = alloc::with_capacity(faces.len())?;
    let mut face_offsets = alloc::with_capacity(faces.len() + 1)?;
    let mut face_corners: Vec<u32> = alloc::with_capacity(faces.half_edge_count())?;
    face_offsets.push(0);
    let mut left = alloc::with_capacity(if options.collapse { faces.half_edge_count() } else { 0 })?;
    for f in 0..faces.len() {
        job.sub_job(0.0, 0.4).step_every(ELEMENTS_PER_REPORT, f, faces.len(), STAGE)?;
        let start = face_corners.len();
        face_corners.extend(mesh.face(f).map(|v| representative[v as usize]));
        if options.collapse {
            left.extend(faces.corner_range(f).map(|corner| corner as u32));
            if !merge_equal_corners(&mut face_corners, &mut left, start) {
                face_corners.truncate(start);
                left.truncate(start);
                face_map.push(NONE);
                continue;
            }
        }
        face_map.push(face_offsets.len() as u32 - 1);
        face_offsets.push(face_corners.len() as u32);
    }

    job.step(0.4, STAGE)?;
    let mut stays = alloc::filled(!options.remove_unused, representative.len())?;
    face_corners.iter().for_each(|&v| stays[v as usize] = true);
    if faces.is_merged() {
        // Keep the split vertices of merged faces, which are restored later.
        let mut stay = |h| stays[representative[faces.corner_vertex_before_merging(h) as usize] as usize] = true;
        match options.collapse {
            true => left.iter().copied().for_each(&mut stay),
            false => (0..faces.half_edge_count() as u32).for_each(&mut stay),
        }
    }
    let mut kept = Vec::new();
    let mut vertex_map = alloc::filled(NONE, representative.len())?;
    // A representative comes before the other vertices of its cluster.
    for (v, &r) in representative.iter().enumerate() {
        if r as usize != v {
            vertex_map[v] = vertex_map[r as usize];
        } else if stays[v] {
            vertex_map[v] = kept.len() as u32;
            alloc::push(&mut kept, r)?;
        }
    }
    job.step(0.7, STAGE)?;
    face_corners.iter_mut().for_each(|v| *v = vertex_map[*v as usize]);
    let positions = PositionBuffer::gather(mesh.positions(), &kept)?;
    Ok(Weld {
        welded_vertices: representative.iter().enumerate().filter(|&(v, &r)| r as usize != v).count() as u32,
        dropped_faces: (faces.len() + 1 - face_offsets.len()) as u32,
        mesh: Mesh::new(positions, face_offsets, face_corners),
        vertex_map,
        face_map,
        old_corners: faces.half_edge_count(),
        corners_left: (left.len() != mesh.faces().half_edge_count()).then_some(left).filter(|_| options.collapse),
        tolerance: 0.0,
        sewn_edges: 0,
        left_edges: Vec::new(),
        left_vertices: Vec::new(),
        near: NearBorders::default(),
    })
}

/// Merges successive equal corners of the face from corner `start`, and keeps the parallel list
/// `left` in step. Returns false if fewer than three different vertices remain.
fn merge_equal_corners(corners: &mut Vec<u32>, left: &mut Vec<u32>, start: usize) -> bool {
    let mut end = start;
    for k in start..corners.len() {
        if end == start || corners[k] != corners[end - 1] {
            (corners[end], left[end]) = (corners[k], left[k]);
            end += 1;
        }
    }
    while end > start + 1 && corners[end - 1] == corners[start] {
        end -= 1;
    }
    corners.truncate(end);
    left.truncate(end);
    let face = &corners[start..];
    face.iter().any(|&v| v != face[0] && v != face[1])
}

impl Weld {
    /// Counts the sewn edges, and lists the free edges that coincide with another edge and were not
    /// sewn.
    fn count_sewn_edges(
        &mut self,
        mesh: &MeshView<'_>,
        topology: &Topology,
        [clusters, representative]: [&[u32]; 2],
        free_only: bool,
        job: &Job<'_>,
    ) -> Result<()> {
        job.step(0.0, STAGE)?;
        // Sewing leaves edges with two faces alone; other welding does not.
        let taken = |h| if free_only { is_free(topology, h) } else { !topology.is_ignored(h) };
        let mut edges = Vec::new();
        for f in 0..mesh.faces().len() {
            job.sub_job(0.0, 0.2).step_every(ELEMENTS_PER_REPORT, f, mesh.faces().len(), STAGE)?;
            if self.face_map[f] == NONE {
                continue;
            }
            for (h, u, v) in half_edges(mesh, f).filter(|&(h, ..)| taken(h)) {
                let [now, place] = [representative, clusters].map(|of| [u, v].map(|v| of[v as usize]));
                if now[0] != now[1] {
                    alloc::push(&mut edges, (unordered(place), unordered(now), h))?;
                }
            }
        }
        sort(&mut edges, Ord::cmp, &job.sub_job(0.2, 0.8), STAGE)?;
        let (mut done, count, counting) = (0, edges.len(), job.sub_job(0.8, 0.9));
        for together in edges.chunk_by(|a, b| a.0 == b.0) {
            for edge in together.chunk_by(|a, b| a.1 == b.1) {
                if done / ELEMENTS_PER_REPORT < (done + edge.len()) / ELEMENTS_PER_REPORT {
                    counting.step(done as f64 / count as f64, STAGE)?;
                }
                done += edge.len();
                let free = |&&(_, _, h): &&(u64, u64, u32)| is_free(topology, h);
                if edge.len() == 2 && edge.iter().all(|e| free(&e)) {
                    self.sewn_edges += 1;
                } else if together.len() > 1 {
                    for some in edge.chunks(ELEMENTS_PER_REPORT) {
                        if some.len() == ELEMENTS_PER_REPORT {
                            counting.step(done as f64 / count as f64, STAGE)?;
                        }
                        alloc::extend(&mut self.left_edges, some.iter().filter(free).map(|&(_, _, h)| h))?;
                    }
                }
            }
        }
        sort(&mut self.left_edges, Ord::cmp, &job.sub_job(0.9, 1.0), STAGE)
    }
}
