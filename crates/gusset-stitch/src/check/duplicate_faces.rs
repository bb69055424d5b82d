//! Duplicate faces: faces with the same cycle of vertices, in either direction.
//!
//! Each cycle is rotated to start at its smallest vertex and to run towards the smaller neighbour.
//! Equal cycles are then adjacent after sorting. O(F log F) comparisons of cycles.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::MeshView;

/// Returns the faces with the same cycle of vertices as a face with a smaller index, from any
/// corner and in either direction; ascending. Skips the faces in `degenerate`, which repeat a
/// vertex. O(F log F) comparisons, most of which end at the first vertex.
pub(super) fn find_duplicate_faces(mesh: &MeshView<'_>, degenerate: &[u32], job: &Job<'_>) -> Result<Vec<u32>> {
    let groups = duplicate_face_groups(mesh, degenerate, job)?;
    let repeats = groups.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    let mut duplicates = alloc::gather(repeats.map(|pair| pair[1].1))?;
    duplicates.sort_unstable();
    Ok(duplicates)
}

/// Returns the groups of faces with the same cycle of vertices as (first face of the group, face),
/// group after group, each ascending. Faces without a duplicate are in no group. Skips the faces in
/// `degenerate`. O(F log F) comparisons.
pub(crate) fn duplicate_face_groups(mesh: &MeshView<'_>, degenerate: &[u32], job: &Job<'_>) -> Result<Vec<(u32, u32)>> {
    job.step(0.0, "checking faces")?;
    // Sort the faces by the first edges of their cycles. Few faces have the same one.
    let mut starts = alloc::with_capacity(mesh.faces().len())?;
    starts.extend((0..mesh.faces().len()).map(|f| CycleStart::find_smallest(mesh, f)));
    let proper = (0..mesh.faces().len() as u32).filter(|f| degenerate.binary_search(f).is_err());
    let mut order = alloc::gather(proper.map(|f| (starts[f as usize].first_edge(mesh, f as usize), f)))?;
    sort(&mut order, Ord::cmp, &job.sub_job(0.2, 0.9), "checking faces")?;
    let cycle = |f: u32| starts[f as usize].vertex_cycle(mesh, f as usize);
    let mut groups = Vec::new();
    for faces in order.chunk_by_mut(|a, b| a.0 == b.0).filter(|faces| faces.len() > 1) {
        sort(faces, |a, b| cycle(a.1).cmp(cycle(b.1)).then(a.1.cmp(&b.1)), &job.sub_job(0.9, 1.0), "checking faces")?;
        for group in faces.chunk_by(|a, b| cycle(a.1).eq(cycle(b.1))).filter(|group| group.len() > 1) {
            alloc::extend(&mut groups, group.iter().map(|&(_, f)| (group[0].1, f)))?;
        }
    }
    Ok(groups)
}

/// The corner and the direction in which a face's cycle is lexicographically smallest.
#[derive(Clone, Copy)]
struct CycleStart {
    corner: u32,
    backwards: bool,
}

impl CycleStart {
    fn find_smallest(mesh: &MeshView<'_>, f: usize) -> CycleStart {
        let smallest = mesh.face(f).enumerate().min_by_key(|&(_, v)| v);
        let corner = smallest.map_or(0, |(i, _)| i as u32);
        let [forwards, backwards] = [false, true].map(|backwards| CycleStart { corner, backwards });
        if backwards.vertex_cycle(mesh, f).lt(forwards.vertex_cycle(mesh, f)) { backwards } else { forwards }
    }

    /// Returns the first two vertices of the cycle; of an empty face, the largest number.
    fn first_edge(&self, mesh: &MeshView<'_>, f: usize) -> u64 {
        let mut cycle = self.vertex_cycle(mesh, f).map(u64::from);
        cycle.next().zip(cycle.next()).map_or(u64::MAX, |(u, v)| u << 32 | v)
    }

    fn vertex_cycle<'m>(&self, mesh: &'m MeshView<'_>, f: usize) -> impl Iterator<Item = u32> + 'm {
        let range = mesh.faces().corner_range(f);
        let (n, corner, backwards) = (range.len(), self.corner as usize, self.backwards);
        (0..n).map(move |i| {
            let at = if backwards { (corner + n - i) % n } else { (corner + i) % n };
            mesh.faces().corner((range.start + at) as u32)
        })
    }
}
