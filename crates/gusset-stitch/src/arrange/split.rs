//! Splits triangles where they meet.

use super::exact_arrangement::ExactArrangement;
use super::rounds::{Resolved, resolve_intersections};
use super::solid::Solid;
use super::unite::Options;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, MeshView};

const STAGE: &str = "splitting faces";

/// Triangles that meet in common vertices and edges only, or coincide. See [`split_intersecting_faces`].
#[derive(Debug, Clone, PartialEq)]
pub struct SplitFaces {
    /// The triangles, in the order of the faces of the input. The vertices of the input come first, with
    /// their numbers and bits.
    pub mesh: Mesh,
    /// The face of the input from which each triangle comes. Triangles without an area are left out.
    pub face_origins: Vec<u32>,
    /// For each triangle the first one with its vertices: itself, unless triangles coincide.
    pub first_coincident: Vec<u32>,
    /// The number of pairs of triangles of the input that intersect, including those that coincide.
    pub intersection_count: u64,
    /// The number of rounds that changed the mesh.
    pub round_count: u32,
    /// The pairs of triangles of the result that still intersect, by about the rounding error of
    /// positions. Empty unless the rounds do not suffice.
    pub intersections: Vec<[u32; 2]>,
}

/// Splits the faces of a mesh where they meet, so that two triangles of the result have a common vertex
/// or edge, coincide, or are disjoint. Coincident vertices count as one.
///
/// The mesh may be open, and its faces may be oriented in any way. Decides and rounds as
/// [`unite`](super::unite()). Triangles that no other meets keep their vertices.
///
/// O((n + k) log n) for n triangles and k intersecting pairs with their crossings.
///
/// # Errors
/// [`Error::OptionOutOfRange`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn split_intersecting_faces(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<SplitFaces> {
    Error::require(options.max_rounds >= 1, "max_rounds", options.max_rounds.into(), "at least 1")?;
    let scalar = mesh.positions().scalar();
    let solid = Solid::from_mesh(mesh, &job.sub_job(0.0, 0.05))?;
    let found = solid.find_pairs(&job.sub_job(0.05, 0.3))?;
    let pair_count = found.pairs.len() as u64;
    let sorted = |mut t: [u32; 3]| {
        t.sort_unstable();
        t
    };
    let is_counted = |s: [u32; 3], t: [u32; 3]| sorted(s) != sorted(t);
    let arrangement = found.arrange(&job.sub_job(0.3, 0.5))?;
    let split = solid.split(&arrangement, scalar)?;
    let is_unchanged = split.triangles == solid.triangles && split.points == solid.points;
    let step = |solid: &Solid, arrangement: &ExactArrangement, job: &Job<'_>| {
        job.step(0.0, STAGE)?;
        solid.split(arrangement, scalar)
    };
    let Resolved { solid, intersections, round_count } = if is_unchanged {
        Resolved { solid: split, intersections: Vec::new(), round_count: 0 }
    } else {
        resolve_intersections(split, scalar, options.max_rounds, &is_counted, &step, &job.sub_job(0.5, 0.9))?
    };
    // Coincident triangles, by the positions of their vertices.
    let first_at =
        super::coordinate_grid::first_at_position(&solid.points, &solid.triangles, &job.sub_job(0.9, 0.95), STAGE)?;
    let key = |t: &[u32; 3]| sorted(t.map(|v| first_at[v as usize]));
    let mut keys = alloc::gather(solid.triangles.iter().map(key).zip(0u32..))?;
    sort(&mut keys, Ord::cmp, &job.sub_job(0.95, 1.0), STAGE)?;
    let mut first_coincident = alloc::filled(0, keys.len())?;
    for same in keys.chunk_by(|a, b| a.0 == b.0) {
        same.iter().for_each(|&(_, t)| first_coincident[t as usize] = same[0].1);
    }
    let made = solid.to_mesh(mesh)?;
    job.step(1.0, STAGE)?;
    Ok(SplitFaces {
        mesh: made,
        face_origins: solid.faces,
        first_coincident,
        intersection_count: pair_count,
        round_count,
        intersections,
    })
}
