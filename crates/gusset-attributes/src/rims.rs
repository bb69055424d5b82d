//! Where new faces adjoin old ones.
//!
//! A **rim edge** is an edge shared by an old face and a new one. The **base** of a new face is one
//! of its own rim edges, or the base of a neighbour closer to the rims. A breadth-first search from
//! all rim edges at once finds the bases, so that the bases of a strip's faces meet in the middle.

use super::table::STAGE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_base::sort::{Buckets, sort};
use gusset_mesh::{Mesh, NONE};

/// An end of a rim edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RimEdgeEnd {
    pub(super) vertex: u32,
    pub(super) edge: u32,
    /// The corner of the old face at this end.
    pub(super) corner: u32,
}

/// Holds the rim edges of a result. Gives for each new face its base, the nearest rim edge.
pub(super) struct RimEdges {
    /// For each rim edge, the corners of its old face at the start and the end.
    pub(super) edges: Vec<[u32; 2]>,
    /// The base of each new face; [`NONE`] if the face is not connected to an old one.
    pub(super) base_of_new_face: Vec<u32>,
    /// Both ends of all edges, sorted by vertex and edge.
    pub(super) edge_ends: Vec<RimEdgeEnd>,
    /// For each old vertex of a new face that is not on a rim edge: the vertex, and a corner of an
    /// old face there. Sorted by vertex.
    vertices_and_corners_off_rims: Vec<(u32, u32)>,
}

impl RimEdges {
    /// Finds the rims of the faces from `first_face` onwards. O(H log n) for H corners of the mesh,
    /// n of which belong to new faces.
    pub(super) fn find(mesh: &Mesh, first_face: usize, job: &Job<'_>) -> Result<RimEdges> {
        let first_corner = mesh.face_offsets[first_face];
        let new = alloc::collect((first_corner as usize..mesh.face_corners.len()).map(|corner| mesh.corner(corner)))?;
        let mut is_new = BitSet::new(mesh.positions.len())?;
        new.iter().for_each(|&v| is_new.insert(v));

        // All edges of new faces, and the edges of old faces that may coincide with them.
        let mut sides = alloc::with_capacity(new.len())?;
        for f in first_face..mesh.face_count() {
            job.step_within_list(f, STAGE)?;
            sides.extend(face_sides(mesh, f));
        }
        job.sub_job(0.0, 0.4).work_in_ranges(STAGE, first_face, |faces| {
            for f in faces {
                let may = |&([u, v], _): &([u32; 2], u32)| is_new.contains(u) && is_new.contains(v);
                alloc::extend(&mut sides, face_sides(mesh, f).filter(may))?;
            }
            Ok(())
        })?;
        // All three lists are sorted as triples of numbers, so that the sort is compiled once.
        let mut keyed = alloc::collect(sides.iter().map(|&([u, v], corner)| (u.min(v), u.max(v), corner)))?;
        sort(&mut keyed, Ord::cmp, &job.sub_job(0.4, 0.6), STAGE)?;
        let count = mesh.face_count() - first_face;
        let face_of = |corner: u32| mesh.face_of_corner(corner) as u32;
        let (mut edges, mut own, mut links) = (Vec::new(), Vec::new(), Vec::new());
        for (k, together) in keyed.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).enumerate() {
            job.sub_job(0.6, 0.6).step_within_list(k, STAGE)?;
            let old = together.partition_point(|&(_, _, corner)| corner < first_corner);
            let faces = together[old..].iter().map(|&(_, _, corner)| face_of(corner) - first_face as u32);
            if old > 0 && old < together.len() {
                alloc::extend(
                    &mut own,
                    faces.zip(together[old..].iter()).map(|(f, side)| (side.2, f, edges.len() as u32)),
                )?;
                alloc::push(&mut edges, together[0].2)?;
            } else if old == 0 {
                alloc::extend(&mut links, faces.clone().zip(faces.skip(1)))?;
            }
        }
        // Sorted in the order of the faces' corners.
        sort(&mut own, Ord::cmp, &job.sub_job(0.6, 0.7), STAGE)?;
        let bases = find_face_bases(count, &own, &links, &job.sub_job(0.7, 0.8))?;
        job.step(0.8, STAGE)?;
        let after = |corner: u32| {
            let f = face_of(corner) as usize;
            if corner + 1 == mesh.face_offsets[f + 1] { mesh.face_offsets[f] } else { corner + 1 }
        };
        let edges = alloc::collect(edges.into_iter().map(|corner| [corner, after(corner)]))?;
        let at = |corner: u32| mesh.corner(corner as usize);
        let mut ends = alloc::gather(
            edges.iter().zip(0..).flat_map(|(corners, edge)| corners.map(|corner| (at(corner), edge, corner))),
        )?;
        sort(&mut ends, Ord::cmp, &job.sub_job(0.8, 0.9), STAGE)?;
        let ends = alloc::collect(ends.into_iter().map(|(vertex, edge, corner)| RimEdgeEnd { vertex, edge, corner }))?;
        let mut rims =
            RimEdges { edges, base_of_new_face: bases, edge_ends: ends, vertices_and_corners_off_rims: Vec::new() };
        rims.find_corners_off_rims(mesh, &new, &job.sub_job(0.9, 1.0))?;
        Ok(rims)
    }

    /// Finds corners of old faces at the old vertices of new faces that are not on a rim edge.
    fn find_corners_off_rims(&mut self, mesh: &Mesh, new: &[u32], job: &Job<'_>) -> Result<()> {
        let old = mesh.face_corners.len() - new.len();
        let mut wanted = BitSet::new(mesh.positions.len())?;
        let mut any = false;
        for (k, &v) in new.iter().enumerate() {
            job.step_within_list(k, STAGE)?;
            if self.first_rim_end_at(v).is_none() {
                wanted.insert(v);
                any = true;
            }
        }
        if any {
            job.work_in_ranges(STAGE, old, |range| {
                let named = range.map(|corner| (mesh.corner(corner), corner as u32));
                let found = named.filter(|&(v, _)| wanted.contains(v));
                alloc::extend(&mut self.vertices_and_corners_off_rims, found)
            })?;
            sort(&mut self.vertices_and_corners_off_rims, Ord::cmp, &job.sub_job(1.0, 1.0), STAGE)?;
            self.vertices_and_corners_off_rims.dedup_by_key(|&mut (v, _)| v);
        }
        Ok(())
    }

    fn first_rim_end_at(&self, v: u32) -> Option<&RimEdgeEnd> {
        self.edge_ends.get(self.edge_ends.partition_point(|end| end.vertex < v)).filter(|end| end.vertex == v)
    }

    /// The old corner whose values a new face with this base uses at an old vertex; [`NONE`] if it
    /// does not exist.
    pub(super) fn old_corner_at(&self, v: u32, base: u32) -> u32 {
        let key = (v, base);
        let own =
            self.edge_ends.binary_search_by(|end| (end.vertex, end.edge).cmp(&key)).ok().map(|at| &self.edge_ends[at]);
        match own.or_else(|| self.first_rim_end_at(v)) {
            Some(end) => end.corner,
            None => self
                .vertices_and_corners_off_rims
                .binary_search_by_key(&v, |&(v, _)| v)
                .map_or(NONE, |at| self.vertices_and_corners_off_rims[at].1),
        }
    }
}

/// The sides of a face: both vertices, and the corner where the side starts.
fn face_sides(mesh: &Mesh, f: usize) -> impl Iterator<Item = ([u32; 2], u32)> + use<'_> {
    let [first, end] = [f, f + 1].map(|k| mesh.face_offsets[k] as usize);
    let after = move |corner: usize| if corner + 1 == end { first } else { corner + 1 };
    (first..end).map(move |corner| ([mesh.corner(corner), mesh.corner(after(corner))], corner as u32))
}

/// The bases of `count` faces. `own` lists faces with rim edges of their own, as (corner, face,
/// edge). `links` lists neighbours.
fn find_face_bases(count: usize, own: &[(u32, u32, u32)], links: &[(u32, u32)], job: &Job<'_>) -> Result<Vec<u32>> {
    let both = links.iter().flat_map(|&(f, g)| [(f as usize, g), (g as usize, f)]);
    let neighbours = Buckets::new(count, 0u32, both)?;
    let mut bases = alloc::filled(NONE, count)?;
    let mut queue = alloc::with_capacity(count)?;
    for &(_, f, edge) in own {
        if bases[f as usize] == NONE {
            bases[f as usize] = edge;
            queue.push(f);
        }
    }
    let mut next = 0;
    while let Some(&f) = queue.get(next) {
        job.step_within_list(next, STAGE)?;
        next += 1;
        for &g in neighbours.get(f as usize) {
            if bases[g as usize] == NONE {
                bases[g as usize] = bases[f as usize];
                queue.push(g);
            }
        }
    }
    Ok(bases)
}
