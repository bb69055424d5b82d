//! The border of a solid as a manifold mesh.
//!
//! At an edge with more than two faces of the border, the two faces on the sides of one wedge of
//! solid belong to one sheet. A vertex is split into one copy for each fan of faces.

use super::exact_arrangement::ExactArrangement;
use super::face_groups::{EdgeOrder, FaceGroups, HalfPlane, are_oriented_alike};
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

const STAGE: &str = "joining sheets";
const EDGES_PER_REPORT: usize = 1 << 12;

/// A face of the border of a solid.
#[derive(Debug, Clone, Copy)]
pub(super) struct BorderFace {
    /// The distinct triangle.
    pub(super) group: u32,
    /// True if the border is oriented against the corners of the distinct triangle.
    pub(super) is_turned: bool,
    /// The part from which the face comes.
    pub(super) part: u32,
}

/// The vertices of a mesh made of border faces.
pub(super) struct SheetMesh {
    /// The vertices of each face, oriented outwards.
    pub(super) faces: Vec<[u32; 3]>,
    /// For each vertex, the point, and the given vertex that it continues, or `NONE`.
    pub(super) vertices: Vec<[u32; 2]>,
    /// Pairs of faces whose common edge has the ends of another edge: the faces, then the ends.
    pub(super) doubled: Vec<[u32; 4]>,
}

/// Returns the distinct triangles that separate a winding number of at most 0 from one of at least
/// 1, in the order of their parts.
pub(super) fn border_faces(
    arrangement: &ExactArrangement,
    groups: &FaceGroups,
    [front, back]: [&[i32]; 2],
) -> Result<Vec<BorderFace>> {
    let mut faces = Vec::new();
    for (group, &corners) in groups.corners.iter().enumerate() {
        let [is_front_solid, is_back_solid] = [front[group] > 0, back[group] > 0];
        if is_front_solid != is_back_solid {
            let members = groups.parts_of_group.get(group);
            let fits = |&&i: &&u32| are_oriented_alike(arrangement.parts[i as usize].0, corners) != is_front_solid;
            let part = members.iter().find(fits).or(members.first()).copied().unwrap_or(0);
            alloc::push(&mut faces, BorderFace { group: group as u32, is_turned: is_front_solid, part })?;
        }
    }
    faces.sort_unstable_by_key(|face| face.part);
    Ok(faces)
}

/// Makes a mesh of border faces.
pub(super) fn join_sheets(
    arrangement: &ExactArrangement,
    groups: &FaceGroups,
    triangles: &[[u32; 3]],
    border: &[BorderFace],
    job: &Job<'_>,
) -> Result<SheetMesh> {
    let (fans, mut pinched) = join_corners(arrangement, groups, triangles, border, &job.sub_job(0.0, 0.7))?;
    let mut fans = fans.into_roots(&job.sub_job(0.7, 0.7), STAGE)?;
    // The given vertex of each fan: the smallest that a corner of its faces has in its triangle.
    let mut given = alloc::filled(NONE, fans.len())?;
    let point_of = |corner: usize| {
        let face = border[corner / 3];
        arrangement.parts[face.part as usize].0[corner % 3]
    };
    for corner in 0..fans.len() {
        let part = arrangement.parts[border[corner / 3].part as usize];
        let own = triangles[part.1 as usize]
            .into_iter()
            .find(|&v| arrangement.first_vertex_at_position[v as usize] == point_of(corner));
        let is_given = (point_of(corner) as usize) < arrangement.first_vertex_at_position.len();
        let own = own.unwrap_or(if is_given { point_of(corner) } else { NONE });
        let held = &mut given[fans[corner] as usize];
        *held = own.min(*held);
    }
    job.step(0.8, STAGE)?;
    // Vertices in the order of the given ones, then of the points, then of the faces.
    let roots = (0..).zip(&fans).filter(|&(corner, &root)| corner == root).map(|(corner, _)| corner);
    let mut order = alloc::gather(roots.map(|root| (given[root as usize], point_of(root as usize), root)))?;
    order.sort_unstable();
    let mut numbers = alloc::filled(NONE, fans.len())?;
    order.iter().zip(0..).for_each(|(&(_, _, root), number)| numbers[root as usize] = number);
    fans.iter_mut().for_each(|fan| *fan = numbers[*fan as usize]);
    let faces = border.iter().enumerate().map(|(k, face)| {
        let [a, b, c] = [0, 1, 2].map(|j| fans[3 * k + j]);
        let part = arrangement.parts[face.part as usize].0;
        let is_alike = are_oriented_alike(part, groups.corners[face.group as usize]);
        if is_alike == face.is_turned { [a, c, b] } else { [a, b, c] }
    });
    // Edges of four or more faces that have one pair of ends after all.
    let ends = |&[a, b, _]: &[u32; 3]| [fans[a as usize], fans[b as usize]];
    pinched.sort_unstable_by_key(|edge| (ends(edge), *edge));
    let same_ends = pinched.chunk_by(|a, b| ends(a) == ends(b)).filter(|same| same.len() > 1).flatten();
    let with_ends = |edge: &[u32; 3]| [edge[0] / 3, edge[2] / 3, ends(edge)[0], ends(edge)[1]];
    Ok(SheetMesh {
        doubled: alloc::gather(same_ends.map(with_ends))?,
        faces: alloc::collect(faces)?,
        vertices: alloc::collect(order.iter().map(|&(given, point, _)| [point, given]))?,
    })
}

/// Joins the corners 3 f + k, corner k of the part of border face f, that belong to one fan. Also returns
/// the pairs of faces at edges of more than two faces: the first face's corners at both ends, and a corner
/// of the second face.
fn join_corners(
    arrangement: &ExactArrangement,
    groups: &FaceGroups,
    triangles: &[[u32; 3]],
    border: &[BorderFace],
    job: &Job<'_>,
) -> Result<(DisjointSets, Vec<[u32; 3]>)> {
    let mut faces = alloc::filled(NONE, groups.corners.len())?;
    border.iter().zip(0..).for_each(|(face, k)| faces[face.group as usize] = k);
    let mut fans = DisjointSets::new(3 * border.len())?;
    let corner = |h: u32, p: u32| {
        let face = faces[h as usize / 3];
        let part = arrangement.parts[border[face as usize].part as usize].0;
        3 * face + part.iter().position(|&q| q == p).unwrap_or(0) as u32
    };
    // Whether the border passes a half-edge from a point on.
    let is_forward = |h: u32, from: u32| groups.begins_at(h, from) != border[faces[h as usize / 3] as usize].is_turned;
    let (mut kept, mut pinched) = (Vec::new(), Vec::new());
    for (k, edge) in groups.edges().enumerate() {
        job.step_every(EDGES_PER_REPORT, k, groups.half_edges.len(), STAGE)?;
        let [from, to, _] = edge[0];
        kept.clear();
        alloc::extend(&mut kept, edge.iter().map(|side| side[2]).filter(|&h| faces[h as usize / 3] != NONE))?;
        let mut join = |g: u32, h: u32| {
            fans.union(corner(g, from), corner(h, from));
            fans.union(corner(g, to), corner(h, to));
        };
        if let [g, h] = kept[..] {
            join(g, h);
        } else if kept.len() > 2 {
            let plane = |&h: &u32| EdgeOrder::half_plane(arrangement, groups, h, from, triangles);
            let mut around: Vec<HalfPlane> = alloc::collect(kept.iter().map(plane))?;
            EdgeOrder::new(arrangement, from, to).sort(&mut around);
            for (k, plane) in around.iter().enumerate() {
                let next = &around[(k + 1) % around.len()];
                // Solid follows a face that the border passes backwards, counter-clockwise.
                if !is_forward(plane.half_edge, from) && is_forward(next.half_edge, from) {
                    let (g, h) = (plane.half_edge, next.half_edge);
                    join(g, h);
                    alloc::push(&mut pinched, [corner(g, from), corner(g, to), corner(h, from)])?;
                }
            }
        }
    }
    Ok((fans, pinched))
}
