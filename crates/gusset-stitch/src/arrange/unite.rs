//! The union of solids.

use super::cells::unbalanced_triangle;
use super::exact_arrangement::ExactArrangement;
use super::face_groups::FaceGroups;
use super::rounds::{Resolved, resolve_intersections};
use super::solid::Solid;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView};

const STAGE: &str = "uniting";

/// Options of [`unite`] and [`split_intersecting_faces`](super::split_intersecting_faces).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The largest number of rounds, at least 1. Rounding new points to the positions' type may make
    /// new intersections, which the next round removes.
    pub max_rounds: u32,
}

impl Default for Options {
    /// At most 10 rounds.
    fn default() -> Self {
        Options { max_rounds: 10 }
    }
}

/// The union of solids. See [`unite`].
#[derive(Debug, Clone, PartialEq)]
pub struct Union {
    /// The border of the union, in triangles.
    pub mesh: Mesh,
    /// The face of the input from which each face comes.
    pub face_origins: Vec<u32>,
    /// The vertex of the input that each vertex continues, bit for bit, or [`NONE`](gusset_mesh::NONE) for a new one.
    pub vertex_origins: Vec<u32>,
    /// The faces of the input without a part in the result, in ascending order.
    pub dropped_faces: Vec<u32>,
    /// The number of pairs of triangles of the input that intersect.
    pub intersection_count: u64,
    /// The number of rounds that changed the mesh.
    pub round_count: u32,
    /// The pairs of faces of the result that still intersect, by about the rounding error of
    /// positions. Empty unless the rounds do not suffice.
    pub intersections: Vec<[u32; 2]>,
}

/// Returns the border of all points whose winding number is at least 1, as a manifold mesh.
///
/// The faces of the input must form a closed surface: as many faces pass each edge in one direction
/// as in the other. The surface may cut, touch or repeat itself, in one piece or many. Faces inside
/// are removed, and inverted parts outside. Coincident vertices count as one. Where parts touch in an
/// edge or vertex, they get copies of it. All decisions are exact, up to bits below 2^-120 of
/// the largest coordinate. New points are rounded to the type of the positions. Faces that no other meets keep
/// their vertices bit for bit. Faces of more than three corners are split as [`FaceTriangles`](gusset_mesh::FaceTriangles) does.
///
/// O((n + k) log n) for n triangles and k intersecting pairs, and the triangles that one ray from each
/// component meets.
///
/// # Errors
/// [`Error::MeshNotClosed`], [`Error::OptionOutOfRange`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn unite(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Union> {
    unite_with_suspects(mesh, None, options, job)
}

/// Returns a face at an edge that more faces pass in one direction than in the other, or `None` if
/// the surface is closed. Coincident vertices count as one, as for [`unite`].
///
/// O((n + k) log n) for n triangles and k intersecting pairs.
pub(crate) fn find_unbalanced_face(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Option<u32>> {
    let solid = Solid::from_mesh(mesh, &job.sub_job(0.0, 0.1))?;
    let arrangement = solid.find_pairs(&job.sub_job(0.1, 0.5))?.arrange(&job.sub_job(0.5, 0.8))?;
    let groups = FaceGroups::new(&arrangement, &job.sub_job(0.8, 1.0))?;
    Ok(unbalanced_triangle(&arrangement, &groups).map(|triangle| solid.faces[triangle as usize]))
}

/// Returns the union as [`unite`] does. If there are `suspects`, only pairs of faces with one of them intersect.
pub(crate) fn unite_with_suspects(
    mesh: &MeshView<'_>,
    suspects: Option<&BitSet>,
    options: &Options,
    job: &Job<'_>,
) -> Result<Union> {
    Error::require(options.max_rounds >= 1, "max_rounds", options.max_rounds.into(), "at least 1")?;
    let scalar = mesh.positions().scalar();
    let mut solid = Solid::from_mesh(mesh, &job.sub_job(0.0, 0.05))?;
    suspects.map_or(Ok(()), |faces| solid.suspect_faces(faces))?;
    let found = solid.find_pairs(&job.sub_job(0.05, 0.2))?;
    let intersection_count = found.pairs.len() as u64;
    let arrangement = found.arrange(&job.sub_job(0.2, 0.3))?;
    let groups = FaceGroups::new(&arrangement, &job.sub_job(0.3, 0.4))?;
    if let Some(triangle) = unbalanced_triangle(&arrangement, &groups) {
        return Err(Error::MeshNotClosed { input: 0, face: solid.faces[triangle as usize] });
    }
    let united = solid.unite(&arrangement, &groups, scalar, &job.sub_job(0.4, 0.6))?;
    let is_unchanged = united.triangles == solid.triangles && united.points == solid.points;
    let step = |solid: &Solid, arrangement: &ExactArrangement, job: &Job<'_>| {
        let groups = FaceGroups::new(arrangement, &job.sub_job(0.0, 0.3))?;
        solid.unite(arrangement, &groups, scalar, &job.sub_job(0.3, 1.0))
    };
    let Resolved { solid, intersections, round_count } = if is_unchanged {
        Resolved { solid: united, intersections: Vec::new(), round_count: 0 }
    } else {
        resolve_intersections(united, scalar, options.max_rounds, &|_, _| true, &step, &job.sub_job(0.6, 0.95))?
    };
    job.step(0.95, STAGE)?;
    let mut is_kept = BitSet::new(mesh.faces().len())?;
    solid.faces.iter().for_each(|&face| is_kept.insert(face));
    let all = 0..mesh.faces().len() as u32;
    let dropped_faces = alloc::gather(all.filter(|&face| !is_kept.contains(face)))?;
    let made = solid.to_mesh(mesh)?;
    job.step(1.0, STAGE)?;
    Ok(Union {
        mesh: made,
        face_origins: solid.faces,
        vertex_origins: solid.vertices,
        dropped_faces,
        intersection_count,
        round_count,
        intersections,
    })
}
