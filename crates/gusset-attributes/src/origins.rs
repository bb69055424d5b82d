//! The sources of the elements of a result.

use super::continuation::ChartContinuation;
use super::domain::{Counts, Domain};
use super::rims::RimEdges;
use super::table::{FACES_PER_REPORT, STAGE, SourceTable};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, NONE};

/// Largest number of sources of a new vertex at a vertex that very many old ones became.
const MAX_SPREAD_SOURCES: usize = 16;

/// For each vertex, corner and face of a result, the elements of the inputs whose values it takes.
///
/// Sources are numbered through all inputs, beginning with the elements of the first one. An old
/// element has one source. A vertex that several vertices became has all of them as sources, with
/// equal weights. The sources of a new vertex are the vertices of the surrounding rims, weighted by
/// its position on plain triangles between them, before fairing. The source of a new face is the
/// face across the nearest rim edge. Its corners take the values of the old faces there.
#[derive(Debug, PartialEq)]
pub struct Origins {
    inputs: Vec<Counts>,
    /// For each domain, the first source of each input, then the number of all sources.
    first_sources: [Vec<u32>; 3],
    pub(super) tables: [SourceTable; 3],
    /// For each domain, the sources whose faces were turned over; `None` if no face was turned.
    pub(super) turned_sources: Option<[BitSet; 3]>,
    pub(super) continuation: ChartContinuation,
}

/// The old elements of a result, which come before its new ones.
pub(super) struct KeptElements {
    pub(super) inputs: Vec<Counts>,
    pub(super) vertices: SourceTable,
    /// The sources of the corners of old faces, in their order in the result.
    pub(super) corners: SourceTable,
    pub(super) faces: SourceTable,
}

/// The vertices of the result between which a new vertex lies, and their weights.
pub(super) type VertexParents = ([u32; 3], [f64; 3]);

impl Origins {
    /// The table of sources of a domain.
    pub fn table(&self, domain: Domain) -> &SourceTable {
        &self.tables[domain as usize]
    }

    /// The number of elements of each input.
    pub fn inputs(&self) -> &[Counts] {
        &self.inputs
    }

    /// The first source of each input in a domain, then the number of all sources.
    pub fn first_sources_of_inputs(&self, domain: Domain) -> &[u32] {
        &self.first_sources[domain as usize]
    }

    /// The origins of a result without new faces.
    pub(super) fn from_kept(kept: KeptElements) -> Result<Origins> {
        let KeptElements { inputs, vertices, corners, faces } = kept;
        Origins::from_tables(inputs, [vertices, corners, faces], ChartContinuation::default())
    }

    fn from_tables(inputs: Vec<Counts>, tables: [SourceTable; 3], continuation: ChartContinuation) -> Result<Origins> {
        let starts = |domain| {
            let mut starts = alloc::with_capacity(inputs.len() + 1)?;
            starts.push(0);
            for counts in &inputs {
                let end = u64::from(starts[starts.len() - 1]) + counts.count(domain) as u64;
                Error::check_count("sources", end, u32::MAX.into())?;
                starts.push(end as u32);
            }
            Ok::<_, Error>(starts)
        };
        let starts = [starts(Domain::Vertices)?, starts(Domain::Corners)?, starts(Domain::Faces)?];
        Ok(Origins { inputs, first_sources: starts, tables, turned_sources: None, continuation })
    }

    /// The origins of a result. The vertices after the kept ones have `parents`, which precede
    /// them; the faces after the kept ones are new. O(H log n) for H corners, n of which belong to
    /// new faces.
    pub(super) fn new(
        mesh: &Mesh,
        kept: KeptElements,
        parents: impl ExactSizeIterator<Item = VertexParents>,
        job: &Job<'_>,
    ) -> Result<Origins> {
        let (old_vertices, old_faces) = (kept.vertices.len(), kept.faces.len());
        // Expresses new vertices by vertices of old faces, at which chains of parents end: old
        // vertices, and new ones on edges of old faces.
        let mut is_end = BitSet::new(mesh.positions.len())?;
        (0..old_vertices as u32).for_each(|v| is_end.insert(v));
        job.sub_job(0.0, 0.0).work_in_ranges(STAGE, mesh.face_offsets[old_faces] as usize, |corners| {
            corners.for_each(|corner| is_end.insert(mesh.corner(corner)));
            Ok(())
        })?;
        let mut spread = SourceTable::with_capacity(parents.len(), 3 * parents.len())?;
        let mut row = Vec::new();
        for (k, (vertices, weights)) in parents.enumerate() {
            job.step_within_list(k, STAGE)?;
            row.clear();
            for (v, weight) in vertices.into_iter().zip(weights) {
                match is_end.contains(v) {
                    true => alloc::push(&mut row, (v, weight))?,
                    false => {
                        let of_parent = spread.entries(v as usize - old_vertices);
                        alloc::extend(&mut row, of_parent.map(|(v, share)| (v, weight * share)))?;
                    }
                }
            }
            spread.push(row.iter().copied())?;
        }
        let KeptElements { inputs, mut vertices, mut corners, mut faces } = kept;
        for k in 0..spread.len() {
            job.step_within_list(k, STAGE)?;
            row.clear();
            for (v, weight) in spread.entries(k) {
                let all = vertices.row(v as usize).0.len();
                if (v as usize) < old_vertices && all > MAX_SPREAD_SOURCES {
                    let own = vertices.entries(v as usize).take(MAX_SPREAD_SOURCES);
                    alloc::extend(&mut row, own.map(|(source, _)| (source, weight / MAX_SPREAD_SOURCES as f64)))?;
                } else {
                    alloc::extend(&mut row, vertices.entries(v as usize).map(|(s, share)| (s, weight * share)))?;
                }
            }
            vertices.push(row.iter().copied())?;
        }
        let rims = RimEdges::find(mesh, old_faces, &job.sub_job(0.0, 0.7))?;
        for (f, &base) in (old_faces..mesh.face_count()).zip(&rims.base_of_new_face) {
            job.sub_job(0.7, 0.8).step_every(FACES_PER_REPORT, f - old_faces, rims.base_of_new_face.len(), STAGE)?;
            let [first, end] = [f, f + 1].map(|k| mesh.face_offsets[k] as usize);
            for corner in first..end {
                row.clear();
                for (v, weight) in sources_after_spreading(&spread, &is_end, old_vertices, mesh.corner(corner)) {
                    let corner = rims.old_corner_at(v, base);
                    if corner != NONE {
                        alloc::extend(
                            &mut row,
                            corners.entries(corner as usize).map(|(s, share)| (s, weight * share)),
                        )?;
                    }
                }
                corners.push(row.iter().copied())?;
            }
            let across = rims.edges.get(base as usize).map(|&[corner, _]| mesh.face_of_corner(corner));
            let source = across.map_or(NONE, |face| faces.main_source(face));
            faces.push((source != NONE).then_some((source, 1.0)))?;
        }
        let continuation = ChartContinuation::new(
            mesh,
            old_faces,
            rims,
            |v| sources_after_spreading(&spread, &is_end, old_vertices, v),
            &job.sub_job(0.8, 1.0),
        )?;
        Origins::from_tables(inputs, [vertices, corners, faces], continuation)
    }

    /// Records that the faces `is_turned` run in the opposite direction of their sources.
    pub(super) fn with_turned_faces(
        mut self,
        mesh: &Mesh,
        is_turned: impl Fn(usize) -> bool,
        job: &Job<'_>,
    ) -> Result<Self> {
        let set = |domain| BitSet::new(self.first_sources_of_inputs(domain).last().map_or(0, |&count| count as usize));
        let mut turned = [set(Domain::Vertices)?, set(Domain::Corners)?, set(Domain::Faces)?];
        let mut any = false;
        job.work_in_ranges(STAGE, mesh.face_count(), |faces| {
            for f in faces.filter(|&f| is_turned(f)) {
                any = true;
                let insert = |set: &mut BitSet, table: &SourceTable, k: usize| {
                    table.row(k).0.iter().for_each(|&s| set.insert(s));
                };
                insert(&mut turned[2], &self.tables[2], f);
                // If pieces were welded, only the vertices of the face's own piece are turned.
                let face = self.tables[2].main_source(f);
                let input = self.first_sources[2].partition_point(|&start| start <= face).saturating_sub(1);
                let own = self.first_sources[0][input]..self.first_sources[0][(input + 1).min(self.inputs.len())];
                for c in mesh.face_offsets[f] as usize..mesh.face_offsets[f + 1] as usize {
                    insert(&mut turned[1], &self.tables[1], c);
                    let vertices = self.tables[0].row(mesh.face_corners[c] as usize).0;
                    vertices.iter().filter(|&source| own.contains(source)).for_each(|&s| turned[0].insert(s));
                }
            }
            Ok(())
        })?;
        self.turned_sources = any.then_some(turned);
        Ok(self)
    }
}

/// The vertices of old faces from which a vertex of the result takes its values: itself, or the
/// vertices that a new one is spread over.
fn sources_after_spreading(
    spread: &SourceTable,
    is_end: &BitSet,
    old: usize,
    v: u32,
) -> impl Iterator<Item = (u32, f64)> + Clone {
    let row = (!is_end.contains(v)).then(|| v as usize - old);
    let own = row.is_none().then_some((v, 1.0));
    own.into_iter().chain(row.into_iter().flat_map(|k| spread.entries(k)))
}
