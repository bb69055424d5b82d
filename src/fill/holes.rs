//! The patches of all selected holes, appended to a copy of the mesh in the order of the loops.

use super::choose::{Candidate, all_loops, given_loops};
use super::patch::{Patch, patch};
use super::request::{Fairing, Filled, Hole, HoleStatus, Options, Refinement};
use super::surroundings::Surroundings;
use crate::alloc;
use crate::boundary::{self, Survey, boundary_loops};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::mesh::{MeshView, check_size, concat};
use crate::repair::orient::{Outward, turn_outwards};
use crate::stitch::{FaceList, Quality, part_alone};
use std::collections::BTreeSet;

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round
/// them.
///
/// `loops`: the vertices of each in order, in either direction, each consecutive pair (and the last
/// with the first) being an edge with exactly one face; `None` for all loops that the mesh has, cut
/// into simple ones where the boundary touches itself. Loops that cannot be filled are left, and
/// the account of each says why; nothing of this is an error.
///
/// A loop of n <= 500 vertices gets its triangulation of least weight by dynamic programming, in
/// O(n^3); by area it is the least there is. A longer one loses its shortest ear again and again,
/// in O(n log n) and linear memory, and edges are flipped to Delaunay's rule. No new edge repeats
/// an old one. A planar hole is triangulated without overlaps by the area and by the default
/// weight, however concave it is, if its rim does not cross itself; whether a patch meets other
/// parts of the surface is not looked at.
///
/// O(H) for H half-edges besides (O(H log d) where the boundary is odd), and what refinement and
/// fairing of m new vertices need: O(m^1.5). Extra memory is linear, but for 40 n^2 bytes, at most
/// 10 MB, for the table of the hole at work.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a limit that is no number or negative; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn fill_holes(mesh: &MeshView<'_>, loops: Option<&[&[u32]]>, options: &Options, job: &Job<'_>) -> Result<Filled> {
    for (option, limit) in [("max_length", options.limits.length), ("max_diameter", options.limits.diameter)] {
        let limit = limit.unwrap_or(0.0);
        Error::require(limit >= 0.0, option, limit)?;
    }
    if options.fairing == Fairing::ThinPlate && options.refinement == Refinement::None {
        job.note("fairing moves the new vertices inside holes, and none were asked for: it does nothing");
    }
    let survey = boundary::Options { survey: Survey::BoundaryOnly, ..boundary::Options::default() };
    let boundary = boundary_loops(mesh, &survey, &job.part(0.0, 0.2))?;
    let candidates = match loops {
        Some(loops) => given_loops(mesh, &boundary, loops, &options.limits)?,
        None => all_loops(mesh, &boundary, options)?,
    };
    let mut passes = alloc::filled(0u8, mesh.positions().len())?;
    for found in boundary.iter() {
        found.vertices.iter().for_each(|&v| passes[v as usize] = passes[v as usize].saturating_add(1));
    }
    let mut plan = Plan::new(mesh, &candidates, &passes, &job.part(0.2, 0.3))?;
    let all: usize = candidates.iter().map(|candidate| candidate.vertices.len()).sum();
    let mut done = 0;
    for candidate in &candidates {
        let part = |vertices: usize| 0.3 + 0.4 * vertices as f64 / all as f64;
        let job = job.part(part(done), part(done + candidate.vertices.len()));
        done += candidate.vertices.len();
        plan.enter(candidate, options, &job)?;
    }
    plan.finish(options.outward, &job.part(0.7, 1.0))
}

/// The patches of the holes so far.
struct Plan<'a> {
    mesh: &'a MeshView<'a>,
    /// Per vertex of the mesh, how many loops pass it.
    passes: &'a [u8],
    surroundings: Surroundings,
    /// New edges between old vertices that more than one loop passes: no later hole may repeat
    /// them.
    bridges: BTreeSet<(u32, u32)>,
    holes: Vec<Hole>,
    rims: Vec<u32>,
    /// Faces over the vertices of the result.
    faces: FaceList,
    points: Vec<glam::DVec3>,
}

impl<'a> Plan<'a> {
    fn new(mesh: &'a MeshView<'a>, candidates: &[Candidate], passes: &'a [u8], job: &Job<'_>) -> Result<Self> {
        let mut on_rim = alloc::filled(false, mesh.positions().len())?;
        for candidate in candidates.iter().filter(|candidate| candidate.status == HoleStatus::Filled) {
            candidate.vertices.iter().for_each(|&v| on_rim[v as usize] = true);
        }
        Ok(Plan {
            mesh,
            passes,
            surroundings: Surroundings::new(mesh, &on_rim, job)?,
            bridges: BTreeSet::new(),
            holes: alloc::with_capacity(candidates.len())?,
            rims: Vec::new(),
            faces: FaceList { offsets: vec![0], corners: Vec::new() },
            points: Vec::new(),
        })
    }

    fn enter(&mut self, candidate: &Candidate, options: &Options, job: &Job<'_>) -> Result<()> {
        let (mesh, passes) = (self.mesh, self.passes);
        let [first_face, first_vertex] = self.counts();
        let mut status = candidate.status;
        if status == HoleStatus::Filled {
            let rim = self.surroundings.rim(mesh, &candidate.vertices, |v| passes[v as usize] == 1)?;
            let n = rim.count;
            // The rim runs against the loop.
            let name = |v: u32| candidate.vertices[n - 1 - v as usize];
            let taken = |u: u32, v: u32| {
                let (u, v) = (name(u), name(v));
                self.surroundings.has_edge(u, v) || self.bridges.contains(&(u.min(v), u.max(v)))
            };
            match patch(&rim, options, &taken, job)? {
                Some(patch) => self.add(&patch, n, name)?,
                None => status = HoleStatus::NoTriangulation,
            }
        }
        let [end_face, end_vertex] = self.counts();
        let start = self.rims.len();
        alloc::append(&mut self.rims, &candidate.vertices)?;
        self.holes.push(Hole {
            status,
            rim: start..self.rims.len(),
            faces: first_face..end_face,
            vertices: first_vertex..end_vertex,
        });
        Ok(())
    }

    /// The faces and the vertices of the result so far.
    fn counts(&self) -> [u32; 2] {
        let faces = self.mesh.faces().len() + self.faces.offsets.len() - 1;
        [faces as u32, (self.mesh.positions().len() + self.points.len()) as u32]
    }

    /// Adds a patch whose rim vertex v is `name(v)` of the mesh.
    fn add(&mut self, patch: &Patch, rim: usize, name: impl Fn(u32) -> u32) -> Result<()> {
        let (mesh, passes) = (self.mesh, self.passes);
        let first = mesh.positions().len() + self.points.len();
        let corners = mesh.faces().half_edge_count() + self.faces.corners.len() + 3 * patch.triangles.len();
        check_size((first + patch.points.len()) as u64, corners as u64)?;
        let whole_name = |v: u32| if (v as usize) < rim { name(v) } else { (first + v as usize - rim) as u32 };
        let shared = |v: u32| (v as usize) < rim && passes[name(v) as usize] > 1;
        alloc::append(&mut self.points, &patch.points)?;
        alloc::reserve(&mut self.faces.corners, 3 * patch.triangles.len())?;
        alloc::reserve(&mut self.faces.offsets, patch.triangles.len())?;
        for triangle in &patch.triangles {
            self.faces.push(&triangle.map(whole_name));
            for k in 0..3 {
                let (u, v) = (triangle[k], triangle[(k + 1) % 3]);
                if shared(u) && shared(v) {
                    let (u, v) = (name(u), name(v));
                    self.bridges.insert((u.min(v), u.max(v)));
                }
            }
        }
        Ok(())
    }

    fn finish(self, outward: Outward, job: &Job<'_>) -> Result<Filled> {
        let mesh = self.mesh;
        job.step(0.0, "putting the pieces together")?;
        let room = [self.points.len(), self.faces.iter().len(), self.faces.corners.len()];
        let mut whole = concat::empty(std::iter::once(mesh), room)?;
        concat::append(&mut whole, mesh, |_| false)?;
        whole.positions.extend(self.points.into_iter())?;
        for face in self.faces.iter() {
            whole.face_corners.extend_from_slice(face);
            whole.face_offsets.push(whole.face_corners.len() as u32);
        }
        job.step(0.1, "putting the pieces together")?;
        let part = part_alone(&whole, mesh.faces().len(), &job.part(0.1, 0.3))?;
        let measured = if outward == Outward::Closed { 0.7 } else { 1.0 };
        let quality = Quality::of(&whole, &part, &job.part(0.3, measured))?;
        let turned_outwards = match outward {
            Outward::Keep => Vec::new(),
            Outward::Closed => turn_outwards(&mut whole, &job.part(measured, 1.0))?.turned,
        };
        Ok(Filled { mesh: whole, holes: self.holes, rims: self.rims, turned_outwards, quality })
    }
}
