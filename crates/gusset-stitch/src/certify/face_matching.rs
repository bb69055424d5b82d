//! The input faces that the result keeps, turns over or lacks.
//!
//! A face is the cycle of its corners' positions. Each result face answers for at most one input
//! face. Input faces are served in order: first those with a face of their own direction, then those
//! with a reversed one. Cycles are compared by their smallest rotations (Shiloach 1981).

use super::numbered_points::NumberedPoints;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::MeshView;
use std::cmp::Ordering;

const STAGE: &str = "matching faces";

/// The input faces, as (piece, face) ascending, and the result faces without an input face.
#[derive(Default)]
pub(super) struct MatchedFaces {
    pub(super) kept_count: u64,
    pub(super) turned_pairs: Vec<[u32; 2]>,
    pub(super) lost_faces: Vec<[u32; 2]>,
    pub(super) new_count: u32,
}

/// A face of a mesh, with its place in the list of cycles.
struct FaceCycle {
    start: usize,
    length: usize,
    mesh: u32,
    face: u32,
    is_reversed: bool,
}

/// Matches the faces of all meshes but the last with the faces of the last. O(H log F) comparisons
/// for H corners and F faces, most of which end at the first corner.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub(super) fn match_faces(meshes: &[&MeshView<'_>], points: &NumberedPoints, job: &Job<'_>) -> Result<MatchedFaces> {
    let corner_count = meshes.iter().map(|mesh| mesh.faces().half_edge_count()).sum();
    let face_count = meshes.iter().map(|mesh| mesh.faces().len()).sum();
    let (mut numbers, mut faces) = (alloc::with_capacity(corner_count)?, alloc::with_capacity(face_count)?);
    let mut scratch = Vec::new();
    for (m, mesh) in meshes.iter().enumerate() {
        for f in 0..mesh.faces().len() {
            job.sub_job(0.0, 0.0).step_within_list(f, STAGE)?;
            let start = numbers.len();
            numbers.extend(mesh.face(f).map(|v| points.number(m, v)));
            let cycle = &mut numbers[start..];
            let length = cycle.len();
            let is_reversed = make_canonical(cycle, &mut scratch)?;
            faces.push(FaceCycle { start, length, mesh: m as u32, face: f as u32, is_reversed });
        }
    }
    let cycle = |face: &FaceCycle| &numbers[face.start..face.start + face.length];
    let compare = |a: &FaceCycle, b: &FaceCycle| cycle(a).cmp(cycle(b));
    let place = |face: &FaceCycle| (face.mesh, face.face);
    let order = |a: &FaceCycle, b: &FaceCycle| compare(a, b).then(place(a).cmp(&place(b)));
    sort(&mut faces, order, &job.sub_job(0.1, 0.7), STAGE)?;
    let mut matched = MatchedFaces::default();
    let mut unserved = Vec::new();
    for (k, equal) in faces.chunk_by(|a, b| compare(a, b).is_eq()).enumerate() {
        job.sub_job(0.7, 0.8).step_within_list(k, STAGE)?;
        let inputs = equal.partition_point(|face| (face.mesh as usize) < meshes.len() - 1);
        matched.add_equal_faces(equal.split_at(inputs), &mut unserved)?;
    }
    sort(&mut matched.turned_pairs, Ord::cmp, &job.sub_job(0.8, 0.9), STAGE)?;
    sort(&mut matched.lost_faces, Ord::cmp, &job.sub_job(0.9, 1.0), STAGE)?;
    Ok(matched)
}

impl MatchedFaces {
    /// Serves the input faces of one cycle by the result faces of that cycle. Both are in order.
    fn add_equal_faces<'f>(
        &mut self,
        (inputs, results): (&'f [FaceCycle], &'f [FaceCycle]),
        unserved: &mut Vec<&'f FaceCycle>,
    ) -> Result<()> {
        let reversed = results.iter().filter(|face| face.is_reversed).count();
        let mut free = [results.len() - reversed, reversed];
        unserved.clear();
        for face in inputs {
            match &mut free[usize::from(face.is_reversed)] {
                0 => alloc::push(unserved, face)?,
                count => {
                    *count -= 1;
                    self.kept_count += 1;
                }
            }
        }
        for face in unserved {
            let place = [face.mesh, face.face];
            match &mut free[usize::from(!face.is_reversed)] {
                0 => alloc::push(&mut self.lost_faces, place)?,
                count => {
                    *count -= 1;
                    alloc::push(&mut self.turned_pairs, place)?;
                }
            }
        }
        self.new_count += (free[0] + free[1]) as u32;
        Ok(())
    }
}

/// Replaces a cycle by the smallest of all its rotations in both directions. Returns true if the
/// smallest one runs backwards. O(n).
fn make_canonical(cycle: &mut [u32], backwards: &mut Vec<u32>) -> Result<bool> {
    backwards.clear();
    alloc::extend(backwards, cycle.iter().rev().copied())?;
    let start = find_least_rotation(cycle);
    cycle.rotate_left(start);
    let start = find_least_rotation(backwards);
    backwards.rotate_left(start);
    let is_reversed = backwards[..] < *cycle;
    if is_reversed {
        cycle.copy_from_slice(backwards);
    }
    Ok(is_reversed)
}

/// Returns the start of the smallest rotation of a cycle. Two candidates are compared item by item;
/// the larger one skips all starts that are known to be larger. O(n).
fn find_least_rotation(cycle: &[u32]) -> usize {
    let n = cycle.len();
    let (mut first, mut second, mut equal) = (0, 1, 0);
    while first < n && second < n && equal < n {
        match cycle[(first + equal) % n].cmp(&cycle[(second + equal) % n]) {
            Ordering::Equal => {
                equal += 1;
                continue;
            }
            Ordering::Greater => first += equal + 1,
            Ordering::Less => second += equal + 1,
        }
        second += usize::from(first == second);
        equal = 0;
    }
    first.min(second)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_canonical_cycle_is_the_smallest_of_all_rotations(cycle in prop::collection::vec(0u32..4, 3..9)) {
            let n = cycle.len();
            let rotated = |reverse: bool, k: usize| -> Vec<u32> {
                (0..n).map(|i| cycle[if reverse { (2 * n - k - i) % n } else { (k + i) % n }]).collect()
            };
            let [forwards, backwards] = [false, true].map(|reverse| (0..n).map(|k| rotated(reverse, k)).min().unwrap());
            let mut made = cycle.clone();
            let is_reversed = make_canonical(&mut made, &mut Vec::new()).unwrap();
            prop_assert_eq!(is_reversed, backwards < forwards);
            prop_assert_eq!(made, forwards.min(backwards));
        }
    }
}
