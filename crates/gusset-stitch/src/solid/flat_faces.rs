//! Faces without area.
//!
//! The corners of such a face lie on a line. If two of them coincide, they become one vertex. If the
//! longest side passes all other corners, these are inserted on the side's other faces, and the
//! face is dropped. No vertex moves but those that coincide. Other faces without area stay.

use super::repair_request::DropReason;
use super::repair_state::RepairState;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, MeshView, half_edges, unordered};

/// Two corners coincide if their distance is at most this fraction of the face's longest side.
const MAX_COINCIDENT_RATIO: f64 = 1e-10;

/// Two corners coincide, too, if their distance is at most this fraction of the face's largest coordinate: the rounding
/// of the coordinates, below which a face [has no area](crate::check::Check::zero_area_faces).
const MAX_COINCIDENT_ROUNDING: f64 = 24.0 * f64::EPSILON;

/// Largest number of passes. Each one removes the faces without area that are not neighbours.
const MAX_PASSES: usize = 64;

const STAGE: &str = "dropping faces without area";

/// How to remove a face without area.
enum Removal {
    /// Replace the second vertex by the first, smaller one.
    Merge([u32; 2]),
    /// Insert the vertices on the other faces at the side, each with its place along it from the
    /// smaller to the larger vertex.
    Insert { side: u64, vertices: Vec<(f64, u32)> },
}

/// Removes the faces without area that `is_flat` recognises. O(H log k) for H half-edges and each
/// pass; one pass suffices if no two of the k faces are neighbours.
pub(super) fn remove_flat_faces(
    state: &mut RepairState,
    mut flat: Vec<u32>,
    find: impl Fn(&MeshView<'_>, &Job<'_>) -> Result<Vec<u32>>,
    job: &Job<'_>,
) -> Result<()> {
    if !flat.is_empty() {
        state.collapse_repeated_corners()?;
        flat = find(&state.mesh.view(&job.sub_job(0.0, 0.0))?, &job.sub_job(0.0, 0.0))?;
    }
    for pass in 0..MAX_PASSES {
        let job = job.sub_job_of_item(pass, MAX_PASSES);
        if flat.is_empty() || !remove_separate_faces(state, &flat, &job.sub_job(0.0, 0.7))? {
            break;
        }
        flat = find(&state.mesh.view(&job.sub_job(0.7, 0.8))?, &job.sub_job(0.8, 1.0))?;
    }
    Ok(())
}

/// Removes faces whose neighbours are not removed at the same time. Returns true if it removed one.
fn remove_separate_faces(state: &mut RepairState, flat: &[u32], job: &Job<'_>) -> Result<bool> {
    let mesh = &state.mesh;
    let mut removals = Vec::new();
    for &f in flat {
        if let Some(removal) = plan_removal(mesh, f) {
            alloc::push(&mut removals, (f, removal))?;
        }
    }
    let sides = SideFaces::find(mesh, &removals, &job.sub_job(0.0, 0.5))?;
    let (mut touched, mut places, mut merges) = (BitSet::new(mesh.positions.len())?, Vec::new(), Vec::new());
    let (mut changed, mut reasons) = (BitSet::new(mesh.face_count())?, alloc::filled(None, mesh.face_count())?);
    for (f, removal) in &removals {
        let corners = |f: u32| face_corners(mesh, f).iter();
        match removal {
            Removal::Merge(pair) => {
                if corners(*f).any(|&v| touched.contains(v)) {
                    continue;
                }
                pair.iter().for_each(|&v| touched.insert(v));
                alloc::push(&mut merges, (pair[1], pair[0]))?;
            }
            Removal::Insert { side, vertices } => {
                let others = || sides.at(*side).iter().filter(|&&(_, h)| mesh.face_of_corner(h) as u32 != *f);
                let faces = || others().map(|&(_, h)| mesh.face_of_corner(h) as u32);
                let has_vertex = |g: u32| vertices.iter().any(|(_, v)| face_corners(mesh, g).contains(v));
                let is_busy = |g: u32| reasons[g as usize].is_some() || corners(g).any(|&v| touched.contains(v));
                if changed.contains(*f) || faces().chain([*f]).any(is_busy) || faces().any(has_vertex) {
                    continue;
                }
                for &(_, h) in others() {
                    let runs_up = u64::from(mesh.face_corners[h as usize]) == side >> 32;
                    let along = |at: f64| if runs_up { at } else { 1.0 - at };
                    alloc::extend(&mut places, vertices.iter().map(|&(at, v)| (h, along(at), v)))?;
                }
                faces().for_each(|g| changed.insert(g));
                reasons[*f as usize] = Some(DropReason::ZeroArea);
            }
        }
    }
    let is_dropped = |reason: &Option<_>| reason.is_some();
    if merges.is_empty() && (!reasons.iter().any(is_dropped) || reasons.iter().all(is_dropped)) {
        return Ok(false);
    }
    sort(&mut places, |a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)), &job.sub_job(0.5, 0.6), STAGE)?;
    merges.sort_unstable();
    for (_, _, v) in &mut places {
        if let Ok(k) = merges.binary_search_by_key(v, |pair| pair.0) {
            *v = merges[k].1;
        }
    }
    state.replace_vertices(&merges);
    state.drop_and_insert(&reasons, &places, &job.sub_job(0.6, 0.9))?;
    state.collapse_repeated_corners()?;
    Ok(true)
}

fn face_corners(mesh: &Mesh, f: u32) -> &[u32] {
    &mesh.face_corners[mesh.face_offsets[f as usize] as usize..mesh.face_offsets[f as usize + 1] as usize]
}

/// Returns how to remove a face; `None` if its corners go back and forth.
fn plan_removal(mesh: &Mesh, f: u32) -> Option<Removal> {
    let corners = face_corners(mesh, f);
    let n = corners.len();
    let box_corner = corners.iter().fold(DVec3::ZERO, |most, &v| most.max(mesh.positions.get(v).abs()));
    let unit = common_unit(&[box_corner]);
    let point = |k: usize| mesh.positions.get(corners[k % n]) / unit;
    let length = |k: usize| point(k).distance(point(k + 1));
    let longest = (0..n).max_by(|&i, &k| length(i).total_cmp(&length(k)))?;
    let shortest = (0..n).min_by(|&i, &k| length(i).total_cmp(&length(k)))?;
    let [a, b] = [corners[longest], corners[(longest + 1) % n]];
    let rounding = MAX_COINCIDENT_ROUNDING * box_corner.max_element() / unit;
    if length(shortest) <= rounding.max(MAX_COINCIDENT_RATIO * length(longest)) {
        let [u, v] = [corners[shortest], corners[(shortest + 1) % n]];
        return (u != v).then_some(Removal::Merge([u.min(v), u.max(v)]));
    }
    let (start, along) = (point(longest), point(longest + 1) - point(longest));
    // From the side's end back to its start.
    let places: Vec<(f64, u32)> = (longest + 2..longest + n)
        .map(|k| ((point(k) - start).dot(along) / along.length_squared(), corners[k % n]))
        .collect();
    let falls = places.windows(2).all(|pair| pair[0].0 > pair[1].0);
    let is_within = places.iter().all(|&(at, _)| at > 0.0 && at < 1.0);
    let place = |(at, v): (f64, u32)| (if a < b { at } else { 1.0 - at }, v);
    let vertices = places.into_iter().map(place).collect();
    (falls && is_within).then_some(Removal::Insert { side: unordered([a, b]), vertices })
}

/// The half-edges at the long sides of faces without area.
struct SideFaces {
    half_edges: Vec<(u64, u32)>,
}

impl SideFaces {
    fn find(mesh: &Mesh, removals: &[(u32, Removal)], job: &Job<'_>) -> Result<Self> {
        let sides = removals.iter().filter_map(|(_, removal)| match removal {
            Removal::Insert { side, .. } => Some(*side),
            Removal::Merge(_) => None,
        });
        let mut sides = alloc::gather(sides)?;
        sides.sort_unstable();
        let mut found = Vec::new();
        if !sides.is_empty() {
            let view = mesh.view(&job.sub_job(0.0, 0.2))?;
            for f in 0..mesh.face_count() {
                job.sub_job(0.2, 0.8).step_within_list(f, STAGE)?;
                let keyed = half_edges(&view, f).map(|(h, u, v)| (unordered([u, v]), h));
                alloc::extend(&mut found, keyed.filter(|(side, _)| sides.binary_search(side).is_ok()))?;
            }
        }
        sort(&mut found, Ord::cmp, &job.sub_job(0.8, 1.0), STAGE)?;
        Ok(SideFaces { half_edges: found })
    }

    fn at(&self, side: u64) -> &[(u64, u32)] {
        let start = self.half_edges.partition_point(|&(other, _)| other < side);
        let end = self.half_edges.partition_point(|&(other, _)| other <= side);
        &self.half_edges[start..end]
    }
}
