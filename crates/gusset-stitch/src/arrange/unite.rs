//! The union of solids.

use super::solid::Solid;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_mesh::{FaceTriangles, Mesh, MeshView, PositionBuffer};

const STAGE: &str = "uniting";

/// Number of rounds without fewer intersections after which the search for a better result ends.
const PATIENCE: u32 = 4;

/// Options of [`unite`].
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
    /// The vertex of the input that each vertex continues, bit for bit, or [`NONE`] for a new one.
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
/// their vertices bit for bit. Faces of more than three corners are split as [`FaceTriangles`] does.
///
/// O((n + k) log n) for n triangles and k intersecting pairs, and the triangles that one ray from each
/// component meets.
///
/// # Errors
/// [`Error::MeshNotClosed`], [`Error::OptionOutOfRange`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn unite(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Union> {
    Error::require(options.max_rounds >= 1, "max_rounds", options.max_rounds.into())?;
    let FaceTriangles { corners: triangles, faces, .. } = FaceTriangles::from_mesh(mesh, &job.part(0.0, 0.05))?;
    let positions = mesh.positions();
    let count = positions.len() as u32;
    let mut solid = Solid {
        points: alloc::collect((0..count as usize).map(|v| positions.get(v as u32)))?,
        triangles,
        faces,
        vertices: alloc::collect((0..count as usize).map(|v| v as u32))?,
    };
    let scalar = positions.scalar();
    let (mut round_count, mut intersection_count) = (0, 0);
    // The solid with the fewest intersections between triangles, these pairs, and the round.
    let mut best: Option<(Solid, Vec<[u32; 2]>, u32)> = None;
    for round in 0..=options.max_rounds {
        // Later rounds are shorter.
        let [start, end] = [round, round + 1].map(|round| 0.05 + 0.9 * f64::from(round) / f64::from(round + 1));
        let job = job.part(start, end);
        let mut arrangement = solid.arrange(&job.part(0.0, 0.4))?;
        if round == 0 {
            intersection_count = arrangement.pairs.len() as u64;
            if let Some(triangle) = solid.unbalanced_triangle(&arrangement, &job.part(0.4, 0.5))? {
                return Err(Error::MeshNotClosed { face: solid.faces[triangle as usize] });
            }
        } else {
            let is_better = best.as_ref().is_none_or(|(_, pairs, _)| arrangement.pairs.len() < pairs.len());
            let is_clean = solid.is_clean(&arrangement);
            if is_better || is_clean {
                best = Some((solid.copied()?, alloc::copied(&arrangement.pairs)?, round));
            }
            let last = best.as_ref().map_or(0, |(.., round)| *round);
            if is_clean || round == options.max_rounds || round >= last + PATIENCE {
                break;
            }
            if solid.mend_pairs(&arrangement.pairs, scalar, round)? {
                arrangement = solid.arrange(&job.part(0.5, 0.7))?;
            }
        }
        let next = solid.unite(&arrangement, scalar, &job.part(0.7, 1.0))?;
        let is_same = next.triangles == solid.triangles && next.points == solid.points;
        solid = next;
        if is_same && round == 0 {
            best = None;
            break;
        }
        round_count += 1;
    }
    let (solid, intersections) = match best {
        Some((solid, pairs, round)) => {
            round_count = round;
            (solid, pairs)
        }
        None => (solid, Vec::new()),
    };
    job.step(0.95, STAGE)?;
    let mut is_kept = BitSet::new(mesh.faces().len())?;
    solid.faces.iter().for_each(|&face| is_kept.insert(face));
    let all = 0..mesh.faces().len() as u32;
    let dropped_faces = alloc::gather(all.filter(|&face| !is_kept.contains(face)))?;
    let mut made = PositionBuffer::with_capacity(positions.scalar(), solid.points.len())?;
    for (v, &point) in solid.vertices.iter().zip(&solid.points) {
        if *v == NONE {
            made.extend(std::iter::once(point))?;
        } else {
            made.append(positions, *v as usize..*v as usize + 1)?;
        }
    }
    let offsets = alloc::collect((0..solid.triangles.len() + 1).map(|t| 3 * t as u32))?;
    let corners = alloc::copied(solid.triangles.as_flattened())?;
    job.step(1.0, STAGE)?;
    Ok(Union {
        mesh: Mesh::new(made, offsets, corners),
        face_origins: solid.faces,
        vertex_origins: solid.vertices,
        dropped_faces,
        intersection_count,
        round_count,
        intersections,
    })
}
