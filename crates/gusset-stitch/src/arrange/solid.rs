//! A closed surface between two rounds of a union.

use super::cells::windings;
use super::exact_arrangement::{ExactArrangement, GridTriangles};
use super::face_groups::FaceGroups;
use super::sheets::{border_faces, join_sheets};
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::scale::floor_to_power_of_two;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{FaceTriangles, Mesh, MeshView, PositionBuffer, Scalar};

/// The largest height of a triangle to mend, in the first round, as a power of two of the largest
/// coordinate. It doubles in each round, a few times.
const MEND_EXPONENT: i32 = -49;
const MEND_EXPONENT_F32: i32 = -21;
const MAX_DOUBLINGS: i32 = 6;

/// Triangles of a closed surface.
pub(super) struct Solid {
    pub(super) points: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The face of the input of each triangle.
    pub(super) faces: Vec<u32>,
    /// The vertex of the input of each point, or `NONE`.
    pub(super) vertices: Vec<u32>,
    /// The triangles that may intersect. `None`: all.
    pub(super) suspects: Option<BitSet>,
}

/// Returns the triangles of pairs.
fn triangles_of(pairs: &[[u32; 2]]) -> Result<Vec<u32>> {
    let mut triangles = alloc::copied(pairs.as_flattened())?;
    sort_distinct(&mut triangles);
    Ok(triangles)
}

/// Returns the numbers below `count` for which `is_wanted` returns true.
pub(super) fn numbers_where(count: usize, is_wanted: impl Fn(usize) -> bool) -> Result<BitSet> {
    let mut wanted = BitSet::new(count)?;
    (0..count).filter(|&k| is_wanted(k)).for_each(|k| wanted.insert(k as u32));
    Ok(wanted)
}

fn rounded(p: DVec3, scalar: Scalar) -> DVec3 {
    match scalar {
        Scalar::F32 => p.as_vec3().as_dvec3(),
        Scalar::F64 => p,
    }
}

impl Solid {
    /// Splits the faces of a mesh into triangles.
    pub(super) fn from_mesh(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Solid> {
        let FaceTriangles { corners: triangles, faces, .. } = FaceTriangles::from_mesh(mesh, job)?;
        let count = mesh.positions().len();
        let points = alloc::collect((0..count).map(|v| mesh.positions().get(v as u32)))?;
        let vertices = alloc::collect((0..count).map(|v| v as u32))?;
        Ok(Solid { points, triangles, faces, vertices, suspects: None })
    }

    /// Lets only triangles of some faces intersect others.
    pub(super) fn suspect_faces(&mut self, faces: &BitSet) -> Result<()> {
        self.suspects = Some(numbers_where(self.triangles.len(), |t| faces.contains(self.faces[t]))?);
        Ok(())
    }

    /// Lets only triangles with points from `first_new` on intersect others, after an arrangement: these points were
    /// rounded, and all other triangles were split exactly.
    fn suspect_rounded(&mut self, arrangement: &ExactArrangement, first_new: u32) -> Result<()> {
        let is_rounded = |t: usize| self.triangles[t].iter().any(|&v| v >= first_new);
        if arrangement.unsplit.is_empty() {
            self.suspects = Some(numbers_where(self.triangles.len(), is_rounded)?);
        }
        Ok(())
    }

    /// Returns the triangles as a mesh. Vertices of the input keep their bits.
    pub(super) fn to_mesh(&self, input: &MeshView<'_>) -> Result<Mesh> {
        let mut positions = PositionBuffer::with_capacity(input.positions().scalar(), self.points.len())?;
        for (&v, &point) in self.vertices.iter().zip(&self.points) {
            if v == NONE {
                positions.extend(std::iter::once(point))?;
            } else {
                positions.append(input.positions(), v as usize..v as usize + 1)?;
            }
        }
        let offsets = alloc::collect((0..self.triangles.len() + 1).map(|t| 3 * t as u32))?;
        Ok(Mesh::new(positions, offsets, alloc::copied(self.triangles.as_flattened())?))
    }

    pub(super) fn copied(&self) -> Result<Solid> {
        Ok(Solid {
            points: alloc::copied(&self.points)?,
            triangles: alloc::copied(&self.triangles)?,
            faces: alloc::copied(&self.faces)?,
            vertices: alloc::copied(&self.vertices)?,
            suspects: None,
        })
    }

    /// Finds the pairs of triangles that intersect.
    pub(super) fn find_pairs(&self, job: &Job<'_>) -> Result<GridTriangles> {
        GridTriangles::new(&self.points, &self.triangles, self.suspects.as_ref(), job)
    }

    /// Mends the triangles of the pairs that intersect, in a round from 1 on. Returns false if nothing changes.
    pub(super) fn mend_pairs(&mut self, pairs: &[[u32; 2]], scalar: Scalar, round: u32) -> Result<bool> {
        let largest = self.points.iter().fold(0.0, |largest: f64, p| largest.max(p.abs().max_element()));
        let exponent = if scalar == Scalar::F32 { MEND_EXPONENT_F32 } else { MEND_EXPONENT };
        let doublings = MAX_DOUBLINGS.min(round as i32 - 1);
        self.mend_flat_triangles(
            &triangles_of(pairs)?,
            floor_to_power_of_two(largest) * libm::scalbn(1.0, exponent + doublings),
        )
    }

    /// Removes faces inside and parts outside. New points are rounded.
    pub(super) fn unite(
        &self,
        arrangement: &ExactArrangement,
        groups: &FaceGroups,
        scalar: Scalar,
        job: &Job<'_>,
    ) -> Result<Solid> {
        let numbers = windings(arrangement, groups, &self.triangles, &job.sub_job(0.0, 0.5))?;
        let border = border_faces(arrangement, groups, [&numbers.windings_in_front, &numbers.windings_behind])?;
        let sheets = join_sheets(arrangement, groups, &self.triangles, &border, &job.sub_job(0.5, 1.0))?;
        let place = |&[point, given]: &[u32; 2]| match self.points.get(given as usize) {
            Some(&own) => own,
            None => rounded(arrangement.grid.position(arrangement.points.rounded(point)), scalar),
        };
        let origin = |&[_, given]: &[u32; 2]| self.vertices.get(given as usize).copied().unwrap_or(NONE);
        let face = |part: u32| self.faces[arrangement.parts[part as usize].1 as usize];
        let mut made = Solid {
            points: alloc::collect(sheets.vertices.iter().map(place))?,
            triangles: sheets.faces,
            faces: alloc::collect(border.iter().map(|border| face(border.part)))?,
            vertices: alloc::collect(sheets.vertices.iter().map(origin))?,
            suspects: None,
        };
        made.split_doubled_edges(&sheets.doubled, scalar)?;
        // New vertices are listed last.
        let first_new = sheets.vertices.partition_point(|&[_, given]| given != NONE);
        made.suspect_rounded(arrangement, first_new as u32)?;
        Ok(made)
    }

    /// Gives each pair of faces at a doubled edge a vertex of its own in the middle of the edge. A face
    /// that is split already keeps its other edges.
    fn split_doubled_edges(&mut self, doubled: &[[u32; 4]], scalar: Scalar) -> Result<()> {
        let mut is_split = BitSet::new(self.triangles.len())?;
        for &[f, g, p, q] in doubled {
            if is_split.contains(f) || is_split.contains(g) {
                continue;
            }
            let middle = self.points.len() as u32;
            let [a, b] = [p, q].map(|v| self.points[v as usize]);
            alloc::push(&mut self.points, rounded(a + 0.5 * (b - a), scalar))?;
            alloc::push(&mut self.vertices, NONE)?;
            for face in [f, g] {
                is_split.insert(face);
                let triangle = self.triangles[face as usize];
                let Some(k) = (0..3).find(|&k| ![p, q].contains(&triangle[(k + 2) % 3])) else { continue };
                let [from, to, tip] = [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
                self.triangles[face as usize] = [from, middle, tip];
                alloc::push(&mut self.triangles, [middle, to, tip])?;
                let origin = self.faces[face as usize];
                alloc::push(&mut self.faces, origin)?;
            }
        }
        Ok(())
    }

    /// Splits the triangles where they meet. New points are rounded.
    pub(super) fn split(&self, arrangement: &ExactArrangement, scalar: Scalar) -> Result<Solid> {
        let given = self.points.len() as u32;
        let mut made = Solid {
            points: alloc::copied(&self.points)?,
            triangles: alloc::with_capacity(arrangement.parts.len())?,
            faces: alloc::collect(arrangement.parts.iter().map(|&(_, t)| self.faces[t as usize]))?,
            vertices: alloc::copied(&self.vertices)?,
            suspects: None,
        };
        let mut names = alloc::filled(NONE, (arrangement.points.end() - given) as usize)?;
        for &(part, t) in &arrangement.parts {
            let own = self.triangles[t as usize];
            let mut triangle = part;
            for p in &mut triangle {
                if *p < given {
                    // A corner keeps its number among vertices at one position.
                    *p =
                        own.into_iter().find(|&v| arrangement.first_vertex_at_position[v as usize] == *p).unwrap_or(*p);
                    continue;
                }
                let name = &mut names[(*p - given) as usize];
                if *name == NONE {
                    *name = made.points.len() as u32;
                    let place = rounded(arrangement.grid.position(arrangement.points.rounded(*p)), scalar);
                    alloc::push(&mut made.points, place)?;
                    alloc::push(&mut made.vertices, NONE)?;
                }
                *p = *name;
            }
            made.triangles.push(triangle);
        }
        made.suspect_rounded(arrangement, given)?;
        Ok(made)
    }
}
