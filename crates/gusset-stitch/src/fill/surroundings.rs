//! The old faces that touch the rims: which of their vertices share a face, their normals along the
//! rims, and their sides.

use super::patch_rim::{OldFaces, Rim};
use crate::fair::Continuity;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::distance;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{MeshView, NONE};

/// Which old faces touch the rims of all holes.
pub(super) struct Surroundings<'a> {
    mesh: &'a MeshView<'a>,
    /// Per vertex of the mesh, how many loops and chains pass it.
    passes: &'a [u8],
    /// (rim vertex, face), sorted.
    corners: Vec<(u32, u32)>,
    /// (vertex of a face that touches a rim, face that touches none), sorted; empty if no curvature
    /// is asked for.
    beyond: Vec<(u32, u32)>,
    /// Per vertex of the mesh, scratch.
    names: Vec<u32>,
}

/// Faces between two progress reports; where they are taken for a rim, which is more work, fewer.
const REPORT_INTERVAL: usize = 1 << 16;
const FACES_PER_REPORT: usize = 1 << 14;

const STAGE: &str = "looking round the holes";

impl<'a> Surroundings<'a> {
    /// `near`: faces, ascending; all that touch a rim are among them. For continuous curvature the
    /// faces next to those are looked for as well, in another pass over all faces. Extra memory: 4
    /// bytes a vertex of the mesh, 8 a corner at a rim, and 8 a corner of what is next to it.
    pub(super) fn new(
        mesh: &'a MeshView<'a>,
        passes: &'a [u8],
        near: &[u32],
        continuity: Continuity,
        job: &Job<'_>,
    ) -> Result<Self> {
        let mut corners = Vec::new();
        for (k, &f) in near.iter().enumerate() {
            job.step_every(REPORT_INTERVAL, k, near.len(), STAGE)?;
            for v in mesh.face(f as usize).filter(|&v| passes[v as usize] > 0) {
                alloc::push(&mut corners, (v, f))?;
            }
        }
        sort_distinct(&mut corners);
        let beyond = match continuity {
            Continuity::C1 => Vec::new(),
            Continuity::C2 => beyond(mesh, passes, &corners, job)?,
        };
        Ok(Surroundings { mesh, passes, corners, beyond, names: alloc::filled(NONE, mesh.positions().len())? })
    }

    fn faces_at(&self, v: u32) -> &[(u32, u32)] {
        corners_of(&self.corners, v)
    }

    /// True if a face has both of two rim vertices: as an edge of it, or as a diagonal, which is an
    /// edge once the face is cut into triangles. O(log n), times the fewer faces at either.
    pub(super) fn share_face(&self, u: u32, v: u32) -> bool {
        let (few, many) = (self.faces_at(u), self.faces_at(v));
        let (few, many) = if few.len() <= many.len() { (few, many) } else { (many, few) };
        few.iter().any(|&(_, face)| many.binary_search_by_key(&face, |&(_, face)| face).is_ok())
    }

    /// The rim of a patch of loops, each with the surface on the left, and the rim's vertices in
    /// the mesh; `None` if two of the loops have a vertex in common.
    pub(super) fn rim<'b>(
        &mut self,
        loops: impl Iterator<Item = &'b [u32]>,
        job: &Job<'_>,
    ) -> Result<Option<(Rim, Vec<u32>)>> {
        let job = job.part(0.0, 0.0);
        let mesh = self.mesh;
        let (mut names, mut next, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for vertices in loops {
            let (first, n) = (names.len(), vertices.len());
            alloc::append(&mut names, &turned(mesh, vertices)?)?;
            alloc::extend(&mut next, (1..=n).map(|i| (first + i % n) as u32))?;
            alloc::push(&mut lengths, n)?;
        }
        let rim = alloc::copied(&names)?;
        let n = rim.len();
        let mut is_simple = true;
        for (&v, i) in rim.iter().zip(0..) {
            is_simple &= self.names[v as usize] == NONE;
            self.names[v as usize] = i;
        }
        if !is_simple {
            rim.iter().for_each(|&v| self.names[v as usize] = NONE);
            return Ok(None);
        }
        let mut faces = Vec::new();
        for (k, &v) in rim.iter().enumerate() {
            ask_within(k, &job)?;
            alloc::extend(&mut faces, self.faces_at(v).iter().map(|&(_, face)| face))?;
        }
        sort_distinct(&mut faces);

        let mut around = Vec::new();
        let mut sides = Vec::new();
        let mut across = alloc::filled(DVec3::ZERO, n)?;
        let mut own = Vec::new();
        for (k, &f) in faces.iter().enumerate() {
            ask_within(k, &job)?;
            self.name(f, &mut names, &mut own)?;
            let point = |name: u32| mesh.positions().get(names[name as usize]);
            let area = direction(&own, point);
            alloc::extend(&mut around, own[1..].windows(2).map(|pair| [own[0], pair[0], pair[1]]))?;
            for (&u, &v) in own.iter().zip(own.iter().cycle().skip(1)) {
                alloc::push(&mut sides, (u, v))?;
                // The old face runs its rim edge against the new ones.
                if next.get(v as usize) == Some(&u) {
                    across[v as usize] = area;
                }
            }
        }
        let next_to = names[n..].iter().flat_map(|&v| corners_of(&self.beyond, v));
        let mut next_to = alloc::gather(next_to.map(|&(_, face)| face))?;
        sort_distinct(&mut next_to);
        let mut beyond = Vec::new();
        for (k, &f) in next_to.iter().enumerate() {
            ask_within(k, &job)?;
            self.name(f, &mut names, &mut own)?;
            alloc::extend(&mut beyond, own[1..].windows(2).map(|pair| [own[0], pair[0], pair[1]]))?;
        }
        let points = alloc::collect_cancellable(names.iter().map(|&v| mesh.positions().get(v)), &job, STAGE)?;
        let whole = alloc::collect(rim.iter().map(|&v| self.passes[v as usize] == 1))?;
        names.iter().for_each(|&v| self.names[v as usize] = NONE);
        Ok(Some((Rim::new(&points, lengths, OldFaces { around, beyond, sides }, across, whole)?, rim)))
    }
}

/// Asks within a long list, at none of a short one.
fn ask_within(k: usize, job: &Job<'_>) -> Result<()> {
    if k % FACES_PER_REPORT == FACES_PER_REPORT - 1 { job.step(0.0, STAGE) } else { Ok(()) }
}

fn corners_of(corners: &[(u32, u32)], v: u32) -> &[(u32, u32)] {
    let start = corners.partition_point(|&(u, _)| u < v);
    let count = corners[start..].partition_point(|&(u, _)| u == v);
    &corners[start..start + count]
}

/// The corners of faces that touch no rim, at vertices of those that do.
fn beyond(mesh: &MeshView<'_>, passes: &[u8], corners: &[(u32, u32)], job: &Job<'_>) -> Result<Vec<(u32, u32)>> {
    let mut is_next = alloc::filled(false, mesh.positions().len())?;
    for &(_, f) in corners {
        mesh.face(f as usize).for_each(|v| is_next[v as usize] = true);
    }
    let mut found = Vec::new();
    for f in 0..mesh.faces().len() {
        job.step_every(REPORT_INTERVAL, f, mesh.faces().len(), STAGE)?;
        if mesh.face(f).all(|v| passes[v as usize] == 0) {
            alloc::extend(&mut found, mesh.face(f).filter(|&v| is_next[v as usize]).map(|v| (v, f as u32)))?;
        }
    }
    sort_distinct(&mut found);
    Ok(found)
}

impl Surroundings<'_> {
    /// The corners of a face by name; vertices that have none get the next ones.
    fn name(&mut self, face: u32, names: &mut Vec<u32>, corners: &mut Vec<u32>) -> Result<()> {
        corners.clear();
        for v in self.mesh.face(face as usize) {
            let name = &mut self.names[v as usize];
            if *name == NONE {
                *name = names.len() as u32;
                alloc::push(names, v)?;
            }
            alloc::push(corners, *name)?;
        }
        Ok(())
    }
}

/// A loop against its direction. It ends with its longest side, of equals that at the first vertex,
/// wherever the caller's loop begins.
fn turned(mesh: &MeshView<'_>, vertices: &[u32]) -> Result<Vec<u32>> {
    let mut rim = alloc::collect(vertices.iter().rev().copied())?;
    let length = |i: usize| {
        let [p, q] = [i, (i + 1) % rim.len()].map(|i| mesh.positions().get(rim[i]));
        distance(p, q)
    };
    let by_length = |&i: &usize, &j: &usize| length(i).total_cmp(&length(j)).then(rim[j].cmp(&rim[i]));
    let last = (0..rim.len()).max_by(by_length).unwrap_or(0);
    let first = (last + 1) % rim.len();
    rim.rotate_left(first);
    Ok(rim)
}

/// The direction of a face's area vector, by Newell's formula, seen from a corner, at a scale of
/// its own.
fn direction(face: &[u32], point: impl Fn(u32) -> DVec3) -> DVec3 {
    let first = point(face[0]);
    let reach = face.iter().map(|&v| (point(v) - first).abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let leg = |v: u32| (point(v) - first) / reach;
    face[1..].windows(2).map(|pair| leg(pair[0]).cross(leg(pair[1]))).sum::<DVec3>().normalize_or_zero()
}
