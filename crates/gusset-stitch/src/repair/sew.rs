//! Sewing of borders that coincide, also where they do not match vertex by vertex.
//!
//! Borders that match are welded first ([`weld`](super::weld)). Then a vertex of one border may lie
//! inside a free edge of another (a T-junction). The edge is split there if that makes matching
//! pieces (`junctions`), its face is split too (`split_mesh`), and the borders are welded again.
//! Welding does not create edges with three faces or degenerate faces, and neither does sewing:
//! each free edge has one face and is split in one way. Vertices of the input do not move.

use super::corner_origins::CornerOrigins;
use super::near_borders::NearBorders;
use super::split_mesh::{SplitMesh, split_edges};
use super::t_junctions::TJunctions;
use super::weld::{Options, Vertices, Weld, rebuild_mesh, weld_within};
use super::weld_tolerance::ToleranceSource;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, Topology};

const STAGE: &str = "sewing borders";

/// A sewn mesh, and the origins of its elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Sew {
    /// The old faces in their order. Triangles with split edges become consecutive triangles;
    /// larger faces gain corners. Merged vertices are replaced by the smallest, whose position
    /// keeps its bits; remaining new vertices come last.
    pub mesh: Mesh,
    /// For each old vertex, the new one; [`NONE`] if it was removed as unused.
    pub vertex_map: Vec<u32>,
    /// For each old face, the first of its new faces; [`NONE`] if it was dropped.
    pub face_map: Vec<u32>,
    /// For each new face, the old face that it is, or is a part of; ascending.
    pub face_origin: Vec<u32>,
    /// The number of corners of the old mesh.
    pub old_corners: usize,
    /// For each corner of the mesh, its origin; `None` if the corners are unchanged.
    pub corner_origins: Option<CornerOrigins>,
    /// The remaining new vertices, which come last in the mesh: the ends of the edge that each was
    /// inserted on, and the position along that edge.
    pub new_vertices: Vec<([u32; 2], f64)>,
    /// Old vertices that coincide with another vertex, or lie inside a free edge, and are not sewn
    /// to it; ascending.
    pub left_vertices: Vec<u32>,
    /// New vertices that were merged from several old vertices or points of edges; ascending.
    pub seam_vertices: Vec<u32>,
    /// The number of vertices that were merged into a smaller one.
    pub welded_vertices: u32,
    /// The number of edges with two faces that were free edges, or parts of free edges.
    pub sewn_edges: u32,
    /// The number of points at which free edges were split.
    pub splits: u32,
    /// The number of old faces that were cut or gained corners.
    pub split_faces: u32,
    /// The number of old faces that were dropped.
    pub dropped_faces: u32,
    /// The largest allowed distance between coincident vertices; less at short edges.
    pub tolerance: f64,
    /// Free edges that coincide with others beyond the tolerance.
    pub near: NearBorders,
}

/// Sews a mesh. With [`Vertices::All`] all vertices are welded before edges are split, and borders
/// afterwards. O(n log n) for meshes of bounded degree; linear extra memory.
///
/// # Errors
/// As for [`weld`](super::weld::weld), and [`Error::TooLarge`](gusset_base::Error::TooLarge) if the result has too
/// many elements.
pub fn sew(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Sew> {
    let given = ToleranceSource::from_option(options.tolerance)?;
    let first = weld_within(mesh, options, given, &job.sub_job(0.0, 0.4))?;
    let source = match given {
        ToleranceSource::Data => ToleranceSource::Earlier(first.tolerance),
        given => given,
    };
    let mut sewn = Sew::from_weld(first)?;
    if sewn.mesh.face_count() == 0 {
        return Ok(sewn);
    }
    let (split, left) = {
        let view = sewn.mesh.view(&job.sub_job(0.4, 0.45))?;
        let topology = Topology::new(&view, &job.sub_job(0.45, 0.5))?;
        let junctions = TJunctions::find(&view, &topology, source, &job.sub_job(0.5, 0.7))?;
        (split_edges(&view, &junctions, &job.sub_job(0.7, 0.75))?, junctions.vertices_on_unsplit_edges)
    };
    let second = match split.split_faces {
        0 => None,
        _ => {
            // Split vertices are used by no face until the faces' own split vertices are restored.
            let remove_unused = options.remove_unused && !mesh.faces().is_merged();
            let options = Options { vertices: Vertices::Boundary, remove_unused, ..*options };
            let view = split.mesh.view(&job.sub_job(0.75, 0.8))?;
            Some(weld_within(&view, &options, source, &job.sub_job(0.8, 1.0))?)
        }
    };
    sewn.list_vertices_left(&left, second.as_ref())?;
    if let Some(second) = second {
        sewn.follow_second_weld(split, second)?;
    }
    sewn.near.note_hint(job);
    job.step(1.0, STAGE)?;
    Ok(sewn)
}

impl Sew {
    /// Converts the result of welding alone.
    pub fn from_weld(weld: Weld) -> Result<Self> {
        let kept = weld.face_map.iter().zip(0..).filter(|&(&new, _)| new != NONE);
        let mut sources = alloc::filled(0u8, weld.mesh.positions.len())?;
        count_sources_saturating(&weld.vertex_map, |_| 1, &mut sources);
        Ok(Sew {
            seam_vertices: vertices_with_several_sources(&sources)?,
            face_origin: alloc::gather(kept.map(|(_, old)| old))?,
            old_corners: weld.old_corners,
            corner_origins: weld.corners_left.map(|corners| CornerOrigins { corners, on_edges: Vec::new() }),
            new_vertices: Vec::new(),
            mesh: weld.mesh,
            vertex_map: weld.vertex_map,
            face_map: weld.face_map,
            left_vertices: weld.left_vertices,
            welded_vertices: weld.welded_vertices,
            sewn_edges: weld.sewn_edges,
            splits: 0,
            split_faces: 0,
            dropped_faces: weld.dropped_faces,
            tolerance: weld.tolerance,
            near: weld.near,
        })
    }

    /// Lists the old vertices that are not sewn: the vertices `left` of the mesh, and the vertices
    /// that welding left, by its second pass if there was one.
    fn list_vertices_left(&mut self, left: &[u32], again: Option<&Weld>) -> Result<()> {
        let mut is_left = alloc::filled(false, self.mesh.positions.len())?;
        left.iter().for_each(|&v| is_left[v as usize] = true);
        match again {
            // The vertices of splits come after these.
            Some(weld) => weld.left_vertices.iter().for_each(|&v| {
                if let Some(is_left) = is_left.get_mut(v as usize) {
                    *is_left = true;
                }
            }),
            None => {
                let now = self.left_vertices.iter().map(|&v| self.vertex_map[v as usize]);
                now.filter(|&v| v != NONE).for_each(|v| is_left[v as usize] = true);
            }
        }
        let is_marked = |&(&new, _): &(&u32, u32)| new != NONE && is_left[new as usize];
        self.left_vertices = alloc::gather(self.vertex_map.iter().zip(0..).filter(is_marked).map(|(_, old)| old))?;
        Ok(())
    }

    /// Replaces this mesh by the mesh with split edges after it was welded again.
    fn follow_second_weld(&mut self, split: SplitMesh, weld: Weld) -> Result<()> {
        let before = self.corner_origins.take();
        let left = before.as_ref().map(|origins| &origins.corners[..]);
        self.corner_origins =
            Some(split.corner_origins.select_corners(weld.corners_left.as_deref())?.composed_with_earlier(left));
        self.list_new_vertices(&split.new_vertices, &weld)?;
        self.splits = (split.mesh.positions.len() - self.mesh.positions.len()) as u32;
        let mut origin = alloc::with_capacity(weld.mesh.face_count())?;
        let kept = weld.face_map.iter().zip(&split.face_origin).filter(|&(&new, _)| new != NONE);
        origin.extend(kept.map(|(_, &middle)| self.face_origin[middle as usize]));
        self.face_map.fill(NONE);
        for (new, &old) in origin.iter().enumerate().rev() {
            self.face_map[old as usize] = new as u32;
        }
        let mut sources = alloc::filled(0u8, weld.mesh.positions.len())?;
        let before = |v: usize| 1 + u8::from(self.seam_vertices.binary_search(&(v as u32)).is_ok());
        count_sources_saturating(&weld.vertex_map, before, &mut sources);
        self.seam_vertices = vertices_with_several_sources(&sources)?;
        self.face_origin = origin;
        self.dropped_faces = self.face_map.iter().filter(|&&new| new == NONE).count() as u32;
        for new in self.vertex_map.iter_mut().filter(|new| **new != NONE) {
            *new = weld.vertex_map[*new as usize];
        }
        self.mesh = weld.mesh;
        self.split_faces = split.split_faces;
        self.sewn_edges += weld.sewn_edges;
        self.near = weld.near;
        self.count_welded_vertices()
    }

    /// Lists the vertices at splits that are not old vertices.
    fn list_new_vertices(&mut self, new: &[([u32; 2], f64)], weld: &Weld) -> Result<()> {
        let (old, of_splits) = weld.vertex_map.split_at(self.mesh.positions.len());
        let mut next = old.iter().filter(|&&name| name != NONE).max().map_or(0, |last| last + 1);
        for (&name, &(ends, at)) in of_splits.iter().zip(new) {
            // List the first of several merged vertices.
            if name == next {
                alloc::push(&mut self.new_vertices, (ends.map(|v| old[v as usize]), at))?;
                next += 1;
            }
        }
        Ok(())
    }

    /// Merges further vertices of the mesh. `representative` has the smallest vertex of the merged
    /// set of each vertex. No face may have two vertices of a set. Returns the new vertex of each.
    pub(crate) fn merge_vertices(&mut self, representative: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
        let view = self.mesh.view(&job.sub_job(0.0, 0.5))?;
        let welded = rebuild_mesh(&view, representative, &Options::default(), &job.sub_job(0.5, 1.0))?;
        let mut sources = alloc::filled(0u8, welded.mesh.positions.len())?;
        let before = |v: usize| 1 + u8::from(self.seam_vertices.binary_search(&(v as u32)).is_ok());
        count_sources_saturating(&welded.vertex_map, before, &mut sources);
        self.seam_vertices = vertices_with_several_sources(&sources)?;
        let mut is_new =
            (self.mesh.positions.len() - self.new_vertices.len()..).map(|v| representative[v] as usize == v);
        self.new_vertices.retain(|_| is_new.next() == Some(true));
        self.new_vertices.iter_mut().flat_map(|(ends, _)| ends).for_each(|v| *v = welded.vertex_map[*v as usize]);
        for new in self.vertex_map.iter_mut().filter(|new| **new != NONE) {
            *new = welded.vertex_map[*new as usize];
        }
        let (seam, map) = (&self.seam_vertices, &self.vertex_map);
        self.left_vertices.retain(|&old| seam.binary_search(&map[old as usize]).is_err());
        self.mesh = welded.mesh;
        self.count_welded_vertices()?;
        Ok(welded.vertex_map)
    }

    fn count_welded_vertices(&mut self) -> Result<()> {
        let mut seen = alloc::filled(false, self.mesh.positions.len())?;
        let again = |&&new: &&u32| new != NONE && std::mem::replace(&mut seen[new as usize], true);
        self.welded_vertices = self.vertex_map.iter().filter(again).count() as u32;
        Ok(())
    }
}

/// Counts the vertices that were merged into each new vertex, saturating at two. `weight` returns
/// the count of an old vertex.
fn count_sources_saturating(vertex_map: &[u32], weight: impl Fn(usize) -> u8, sources: &mut [u8]) {
    for (old, &new) in vertex_map.iter().enumerate().filter(|&(_, &new)| new != NONE) {
        let count = &mut sources[new as usize];
        *count = (*count + weight(old)).min(2);
    }
}

/// Returns the vertices with several sources.
fn vertices_with_several_sources(sources: &[u8]) -> Result<Vec<u32>> {
    alloc::gather(sources.iter().zip(0..).filter(|&(&count, _)| count > 1).map(|(_, v)| v))
}
