//! The old faces that touch the rims: shared faces of vertices, normals along the rims, and sides.

use super::patch_rim::{OldFaces, PatchRim};
use crate::fair::Continuity;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{FaceTriangles, MeshView, NONE};

/// The old faces that touch the rims of all holes.
pub(super) struct OldFacesAtRims<'a> {
    mesh: &'a MeshView<'a>,
    /// For each mesh vertex, the number of loops and chains that pass it.
    loops_through_vertex: &'a [u8],
    /// Sorted pairs (rim vertex, face).
    vertex_face_pairs: Vec<(u32, u32)>,
    /// Sorted pairs (vertex of a face that touches a rim, face that does not); empty for tangent
    /// continuity.
    vertices_of_second_ring: Vec<(u32, u32)>,
    /// For each mesh vertex, scratch space.
    rim_number_of_vertex: Vec<u32>,
}

/// Number of faces between two progress reports; smaller where each face takes more work.
const MAX_FACES_PER_REPORT: usize = 1 << 16;
const FACES_PER_REPORT: usize = 1 << 14;

const STAGE: &str = "looking round the holes";

impl<'a> OldFacesAtRims<'a> {
    /// Collects the old faces at the rims. `near` lists faces in ascending order, including all
    /// that touch a rim. For curvature continuity another pass over all faces collects the next
    /// ring. Extra memory: 4 bytes per mesh vertex, 8 per corner at a rim, and 8 per corner of the
    /// next ring.
    pub(super) fn new(
        mesh: &'a MeshView<'a>,
        loops_through_vertex: &'a [u8],
        near: &[u32],
        continuity: Continuity,
        job: &Job<'_>,
    ) -> Result<Self> {
        let mut corners = Vec::new();
        for (k, &f) in near.iter().enumerate() {
            job.step_every(MAX_FACES_PER_REPORT, k, near.len(), STAGE)?;
            for v in mesh.face(f as usize).filter(|&v| loops_through_vertex[v as usize] > 0) {
                alloc::push(&mut corners, (v, f))?;
            }
        }
        sort_distinct(&mut corners);
        let beyond = match continuity {
            Continuity::C1 => Vec::new(),
            Continuity::C2 => second_ring_corners(mesh, loops_through_vertex, &corners, job)?,
        };
        Ok(OldFacesAtRims {
            mesh,
            loops_through_vertex,
            vertex_face_pairs: corners,
            vertices_of_second_ring: beyond,
            rim_number_of_vertex: alloc::filled(NONE, mesh.positions().len())?,
        })
    }

    fn corners_at_rim_vertex(&self, v: u32) -> &[(u32, u32)] {
        corners_at_vertex(&self.vertex_face_pairs, v)
    }

    /// Returns true if one face has both rim vertices, as an edge or as a diagonal. A diagonal
    /// becomes an edge when the face is triangulated. O(log n), times the smaller number of faces
    /// at either vertex.
    pub(super) fn have_common_face(&self, u: u32, v: u32) -> bool {
        let (few, many) = (self.corners_at_rim_vertex(u), self.corners_at_rim_vertex(v));
        let (few, many) = if few.len() <= many.len() { (few, many) } else { (many, few) };
        few.iter().any(|&(_, face)| many.binary_search_by_key(&face, |&(_, face)| face).is_ok())
    }

    /// Returns the rim of a patch and its mesh vertices; `None` if two of the loops share a vertex.
    /// Each loop has the surface on the left.
    pub(super) fn build_patch_rim<'b>(
        &mut self,
        loops: impl Iterator<Item = &'b [u32]>,
        job: &Job<'_>,
    ) -> Result<Option<(PatchRim, Vec<u32>)>> {
        let job = job.sub_job(0.0, 0.0);
        let mesh = self.mesh;
        let (mut names, mut next, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for vertices in loops {
            let (first, n) = (names.len(), vertices.len());
            alloc::append(&mut names, &reverse_loop(mesh, vertices)?)?;
            alloc::extend(&mut next, (1..=n).map(|i| (first + i % n) as u32))?;
            alloc::push(&mut lengths, n)?;
        }
        let rim = alloc::copied(&names)?;
        let n = rim.len();
        let mut is_simple = true;
        for (&v, i) in rim.iter().zip(0..) {
            is_simple &= self.rim_number_of_vertex[v as usize] == NONE;
            self.rim_number_of_vertex[v as usize] = i;
        }
        if !is_simple {
            rim.iter().for_each(|&v| self.rim_number_of_vertex[v as usize] = NONE);
            return Ok(None);
        }
        let mut faces = Vec::new();
        for (k, &v) in rim.iter().enumerate() {
            report_within_long_list(k, &job)?;
            alloc::extend(&mut faces, self.corners_at_rim_vertex(v).iter().map(|&(_, face)| face))?;
        }
        sort_distinct(&mut faces);

        let mut around = FaceTriangles::default();
        let mut sides = Vec::new();
        let mut across = alloc::filled(DVec3::ZERO, n)?;
        let mut own = Vec::new();
        for (k, &f) in faces.iter().enumerate() {
            report_within_long_list(k, &job)?;
            self.number_corners(f, &mut names, &mut own)?;
            let point = |name: u32| mesh.positions().get(names[name as usize]);
            let area = unit_normal(&own, point);
            append_face(&mut around, &own, point, f, &job)?;
            for (&u, &v) in own.iter().zip(own.iter().cycle().skip(1)) {
                alloc::push(&mut sides, (u, v))?;
                // The old face runs along its rim edge in the direction opposite to the new faces.
                if next.get(v as usize) == Some(&u) {
                    across[v as usize] = area;
                }
            }
        }
        let next_to = names[n..].iter().flat_map(|&v| corners_at_vertex(&self.vertices_of_second_ring, v));
        let mut next_to = alloc::gather(next_to.map(|&(_, face)| face))?;
        sort_distinct(&mut next_to);
        let mut beyond = FaceTriangles::default();
        for (k, &f) in next_to.iter().enumerate() {
            report_within_long_list(k, &job)?;
            self.number_corners(f, &mut names, &mut own)?;
            append_face(&mut beyond, &own, |name| mesh.positions().get(names[name as usize]), f, &job)?;
        }
        let points = alloc::collect_cancellable(names.iter().map(|&v| mesh.positions().get(v)), &job, STAGE)?;
        let whole = alloc::collect(rim.iter().map(|&v| self.loops_through_vertex[v as usize] == 1))?;
        names.iter().for_each(|&v| self.rim_number_of_vertex[v as usize] = NONE);
        let old =
            OldFaces { first_ring: around.corners, second_ring_triangles: beyond.corners, first_ring_sides: sides };
        Ok(Some((PatchRim::new(&points, lengths, old, across, whole)?, rim)))
    }
}

/// Reports progress within a long list, but not within a short one.
fn report_within_long_list(k: usize, job: &Job<'_>) -> Result<()> {
    if k % FACES_PER_REPORT == FACES_PER_REPORT - 1 { job.step(0.0, STAGE) } else { Ok(()) }
}

fn corners_at_vertex(corners: &[(u32, u32)], v: u32) -> &[(u32, u32)] {
    let start = corners.partition_point(|&(u, _)| u < v);
    let count = corners[start..].partition_point(|&(u, _)| u == v);
    &corners[start..start + count]
}

/// Returns the corners of faces that touch no rim, at vertices of faces that touch one.
fn second_ring_corners(
    mesh: &MeshView<'_>,
    loops_through_vertex: &[u8],
    corners: &[(u32, u32)],
    job: &Job<'_>,
) -> Result<Vec<(u32, u32)>> {
    let mut is_next = alloc::filled(false, mesh.positions().len())?;
    for &(_, f) in corners {
        mesh.face(f as usize).for_each(|v| is_next[v as usize] = true);
    }
    let mut corners_beyond = Vec::new();
    for f in 0..mesh.faces().len() {
        job.step_every(MAX_FACES_PER_REPORT, f, mesh.faces().len(), STAGE)?;
        if mesh.face(f).all(|v| loops_through_vertex[v as usize] == 0) {
            alloc::extend(&mut corners_beyond, mesh.face(f).filter(|&v| is_next[v as usize]).map(|v| (v, f as u32)))?;
        }
    }
    sort_distinct(&mut corners_beyond);
    Ok(corners_beyond)
}

impl OldFacesAtRims<'_> {
    /// Converts the corners of a face to local numbers. New vertices get the next numbers.
    fn number_corners(&mut self, face: u32, names: &mut Vec<u32>, corners: &mut Vec<u32>) -> Result<()> {
        corners.clear();
        for v in self.mesh.face(face as usize) {
            let name = &mut self.rim_number_of_vertex[v as usize];
            if *name == NONE {
                *name = names.len() as u32;
                alloc::push(names, v)?;
            }
            alloc::push(corners, *name)?;
        }
        Ok(())
    }
}

/// Reverses a loop. The result ends with the longest side. Among equal sides it is the one at the
/// smallest vertex, so that the first vertex of the given loop does not matter.
fn reverse_loop(mesh: &MeshView<'_>, vertices: &[u32]) -> Result<Vec<u32>> {
    let mut rim = alloc::collect(vertices.iter().rev().copied())?;
    let length = |i: usize| {
        let [p, q] = [i, (i + 1) % rim.len()].map(|i| mesh.positions().get(rim[i]));
        overflow_safe_distance(p, q)
    };
    let by_length = |&i: &usize, &j: &usize| length(i).total_cmp(&length(j)).then(rim[j].cmp(&rim[i]));
    let last = (0..rim.len()).max_by(by_length).unwrap_or(0);
    let first = (last + 1) % rim.len();
    rim.rotate_left(first);
    Ok(rim)
}

/// Appends the triangles of a face. The diagonals of quads begin at their first corners: in a
/// regular grid they are parallel, and the fairing depends on it.
fn append_face(
    triangles: &mut FaceTriangles,
    face: &[u32],
    point: impl Fn(u32) -> DVec3,
    number: u32,
    job: &Job<'_>,
) -> Result<()> {
    if let [a, b, c, d] = *face {
        alloc::extend(&mut triangles.faces, [number; 2])?;
        return alloc::extend(&mut triangles.corners, [[a, b, c], [a, c, d]]);
    }
    triangles.append_face(face.len(), |k| point(face[k]), |k| face[k], number, job)
}

/// Returns the unit normal of a face by Newell's formula. Coordinates are relative to the first
/// corner and scaled by the face's own size.
fn unit_normal(face: &[u32], point: impl Fn(u32) -> DVec3) -> DVec3 {
    let first = point(face[0]);
    let reach = face.iter().map(|&v| (point(v) - first).abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let leg = |v: u32| (point(v) - first) / reach;
    face[1..].windows(2).map(|pair| leg(pair[0]).cross(leg(pair[1]))).sum::<DVec3>().normalize_or_zero()
}
