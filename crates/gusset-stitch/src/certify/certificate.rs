//! Facts about a result, and entry point.

use super::face_matching::match_faces;
use super::farthest_vertex::{FarthestVertex, find_farthest_vertex};
use super::numbered_points::NumberedPoints;
use super::own_vertices::have_own_vertices;
use crate::check::{check, find_intersecting_faces};
use crate::intersect::are_collinear;
use crate::repair::orient::find_wrong_components;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::{FaceTriangles, MeshView};

const STAGE: &str = "checking triangles";
/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

/// Facts about a result and the meshes that it was made from. Faces are matched by the positions of
/// their corners, from any corner, where -0 equals 0. Each result face matches at most one input
/// face.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// The number of vertices that faces use.
    pub vertices: u32,
    /// The number of edges: pairs of different vertices that are consecutive in a face. Faces with
    /// fewer than three edges that have different ends have none.
    pub edges: u32,
    /// The number of faces.
    pub faces: u32,
    /// The number of components. Faces that share an edge belong to one component.
    pub components: u32,
    /// True if there are edges, and every edge has exactly two faces.
    pub closed: bool,
    /// True if closed and oriented without intersecting pairs, and every component faces outwards. A
    /// component that an odd number of others encloses bounds a cavity, and has a negative volume;
    /// any other one has a positive volume. False if undecided: if a volume is 0 up to rounding, or
    /// if a component shares the positions of all its vertices with others.
    pub outward: bool,
    /// The number of edges with one face.
    pub boundary_edges: u32,
    /// The number of edges with three or more faces.
    pub non_manifold_edges: u32,
    /// The number of vertices that are ends of non-manifold edges, or whose faces form several fans.
    pub non_manifold_vertices: u32,
    /// The number of edges whose two faces run it in the same direction.
    pub orientation_conflicts: u32,
    /// The number of faces that repeat a vertex.
    pub degenerate_faces: u32,
    /// The number of faces with the vertices of an earlier face, in the same cyclic order or
    /// reversed; without degenerate faces.
    pub duplicate_faces: u32,
    /// The number of triangles with three different vertices on one line. Polygons count as their
    /// triangles.
    pub collinear_triangles: u32,
    /// The number of pairs of faces with common points other than common vertices and edges.
    pub intersecting_pairs: u64,
    /// The number of input faces that the result has.
    pub kept_faces: u64,
    /// The input faces that the result has only reversed, as (piece, face), ascending.
    pub turned_faces: Vec<[u32; 2]>,
    /// The input faces that the result lacks, as (piece, face), ascending.
    pub lost_faces: Vec<[u32; 2]>,
    /// The number of result faces without an input face.
    pub new_faces: u32,
    /// The input vertex that is farthest from the nearest result vertex. `None` if a vertex of the
    /// result lies at every vertex of an input face.
    pub farthest_vertex: Option<FarthestVertex>,
    /// Triangles of the faces with more than three corners, in the order of the faces, as
    /// half-edges. Each face of n corners has n - 2.
    pub polygon_triangles: Vec<[u32; 3]>,
}

/// Computes the facts about a result and the meshes that it was made from.
///
/// O(n log n) for n corners of all meshes, and the search for intersecting faces.
///
/// # Errors
/// [`Error::TooLarge`](gusset_base::Error::TooLarge) (vertices of all meshes),
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn certify(inputs: &[MeshView<'_>], result: &MeshView<'_>, job: &Job<'_>) -> Result<Certificate> {
    let found = check(result, &job.sub_job(0.0, 0.2))?;
    let pairs = find_intersecting_faces(result, &job.sub_job(0.2, 0.5))?;
    let may_face_outwards = found.closed && found.oriented && pairs.is_empty();
    let is_nesting_certain =
        may_face_outwards && (found.components < 2 || have_own_vertices(result, &job.sub_job(0.5, 0.53))?);
    let outward = is_nesting_certain && {
        let wrong = find_wrong_components(result, &job.sub_job(0.53, 0.6))?;
        wrong.turned.is_empty() && wrong.zero_volume.is_empty()
    };
    let polygon_triangles = split_polygons(result, &job.sub_job(0.6, 0.65))?;
    let collinear_triangles = count_collinear_triangles(result, &polygon_triangles, &job.sub_job(0.65, 0.7))?;
    let mut meshes = alloc::gather(inputs)?;
    alloc::push(&mut meshes, result)?;
    let points = NumberedPoints::new(&meshes, &job.sub_job(0.7, 0.8))?;
    let matched = match_faces(&meshes, &points, &job.sub_job(0.8, 0.9))?;
    let farthest_vertex = find_farthest_vertex(&meshes, &points, &job.sub_job(0.9, 1.0))?;
    let count = |list: &[u32]| list.len() as u32;
    Ok(Certificate {
        vertices: found.vertices - count(&found.unused_vertices),
        edges: found.edges,
        faces: found.faces,
        components: found.components,
        closed: found.closed,
        outward,
        boundary_edges: count(&found.boundary_edges),
        non_manifold_edges: count(&found.non_manifold_edges),
        non_manifold_vertices: count(&found.non_manifold_vertices),
        orientation_conflicts: count(&found.orientation_conflicts),
        degenerate_faces: count(&found.degenerate_faces),
        duplicate_faces: count(&found.duplicate_faces),
        collinear_triangles,
        intersecting_pairs: pairs.len() as u64,
        kept_faces: matched.kept_count,
        turned_faces: matched.turned_pairs,
        lost_faces: matched.lost_faces,
        new_faces: matched.new_count,
        farthest_vertex,
        polygon_triangles,
    })
}

/// Returns the triangles of all faces with more than three corners, as half-edges.
fn split_polygons(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<[u32; 3]>> {
    let faces = mesh.faces();
    let mut split = FaceTriangles::default();
    for f in 0..faces.len() {
        job.step_every(FACES_PER_REPORT, f, faces.len(), STAGE)?;
        let corners = faces.corner_range(f);
        if corners.len() > 3 {
            let half_edge = |k: usize| (corners.start + k) as u32;
            let at = |k: usize| mesh.positions().get(faces.corner(half_edge(k)));
            split.append_face(corners.len(), at, half_edge, f as u32, &job.sub_job_of_item(f, faces.len()))?;
        }
    }
    Ok(split.corners)
}

/// Counts the triangles, also of polygons, with three different vertices on one line.
fn count_collinear_triangles(mesh: &MeshView<'_>, of_polygons: &[[u32; 3]], job: &Job<'_>) -> Result<u32> {
    let (faces, positions) = (mesh.faces(), mesh.positions());
    let largest = faces.corners(0..faces.half_edge_count()).map(|v| positions.get(v).abs().max_element());
    let unit = common_unit(&[DVec3::splat(largest.fold(0.0, f64::max))]);
    let is_collinear = |triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|h| faces.corner(h));
        a != b && b != c && c != a && are_collinear([a, b, c].map(|v| positions.get(v) / unit))
    };
    let mut count = 0;
    for f in 0..faces.len() {
        job.step_every(FACES_PER_REPORT, f, faces.len(), STAGE)?;
        let corners = faces.corner_range(f);
        let first = corners.start as u32;
        count += u32::from(corners.len() == 3 && is_collinear([first, first + 1, first + 2]));
    }
    for (t, &triangle) in of_polygons.iter().enumerate() {
        job.step_every(FACES_PER_REPORT, t, of_polygons.len(), STAGE)?;
        count += u32::from(is_collinear(triangle));
    }
    Ok(count)
}
