//! Components that have a vertex of their own.
//!
//! Nesting is decided at a vertex of a component that lies on no other component. If faces do not
//! intersect, a common point of two components is a vertex of both.

use super::numbered_points::NumberedPoints;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

/// Marks a position that several components share.
const SHARED: u32 = NONE - 1;

const STAGE: &str = "nesting components";

/// Returns true if each component has a vertex at a position where no other component has one. Faces
/// that share an edge with two faces belong to one component. O(n log n) for n corners.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub(super) fn have_own_vertices(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<bool> {
    let faces = mesh.faces();
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.4))?;
    let points = NumberedPoints::new(&[mesh], &job.sub_job(0.4, 0.8))?;
    let mut components = DisjointSets::new(faces.len())?;
    for f in 0..faces.len() {
        job.sub_job(0.8, 0.8).step_within_list(f, STAGE)?;
        for h in faces.corner_range(f) {
            if let Opposite::Mate(mate) = topology.opposite(h as u32) {
                components.union(f as u32, faces.face_of_half_edge(mate));
            }
        }
    }
    // For each position its only component.
    let mut owners = alloc::filled(NONE, points.count())?;
    for f in 0..faces.len() {
        job.sub_job(0.9, 0.9).step_within_list(f, STAGE)?;
        let component = components.find(f as u32);
        for v in mesh.face(f) {
            let owner = &mut owners[points.number(0, v) as usize];
            *owner = if [NONE, component].contains(owner) { component } else { SHARED };
        }
    }
    let mut has_own = alloc::filled(false, faces.len())?;
    owners.iter().filter(|&&owner| owner != SHARED).for_each(|&owner| has_own[owner as usize] = true);
    Ok(components.roots().all(|root| has_own[root as usize]))
}

#[cfg(test)]
mod tests {
    use super::super::certify;
    use super::have_own_vertices;
    use gusset_base::job::Job;
    use gusset_mesh::{Faces, MeshView, Positions};

    /// A cube whose squares are split along the edges of the tetrahedron 0 3 5 6, and that
    /// tetrahedron; both faces outwards.
    const CUBE: [[u32; 3]; 12] = [
        [0, 1, 3],
        [0, 3, 2],
        [4, 6, 5],
        [6, 7, 5],
        [0, 4, 5],
        [0, 5, 1],
        [2, 3, 6],
        [3, 7, 6],
        [0, 2, 6],
        [0, 6, 4],
        [1, 5, 3],
        [5, 7, 3],
    ];
    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 5, 3], [0, 3, 6], [0, 6, 5], [3, 5, 6]];

    /// The cube, and the tetrahedron on vertices of its own, made smaller and turned inside out.
    fn is_certain_and_outward(size: f64, inside_out: bool) -> (bool, bool) {
        let corner = |k: u32| [k >> 2 & 1, k >> 1 & 1, k & 1].map(f64::from);
        let mut points: Vec<[f64; 3]> = (0..8).map(corner).collect();
        points.extend((0..8).map(|k| corner(k).map(|x| 0.5 + size * (x - 0.5))));
        let mut faces = CUBE.to_vec();
        faces.extend(TETRAHEDRON.map(|[a, b, c]| if inside_out { [a, c, b] } else { [a, b, c] }.map(|v| v + 8)));
        let job = Job::default();
        let mesh = MeshView::new(Positions::from(&points[..]), Faces::triangles(&faces).unwrap(), &job).unwrap();
        (have_own_vertices(&mesh, &job).unwrap(), certify(&[], &mesh, &job).unwrap().outward)
    }

    #[test]
    fn a_tetrahedron_at_the_vertices_of_a_cube_is_undecided() {
        assert_eq!(is_certain_and_outward(1.0, false), (false, false));
        assert_eq!(is_certain_and_outward(1.0, true), (false, false));
        assert_eq!(is_certain_and_outward(0.5, false), (true, false));
        assert_eq!(is_certain_and_outward(0.5, true), (true, true));
    }
}
