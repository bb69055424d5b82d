//! Edge lengths close to the sizing: long sides are halved, and short sides collapsed.
//!
//! Source: M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling* (2004).

use super::ELEMENTS_PER_REPORT;
use super::patch_mesh::PatchMesh;
use super::sizing::VertexSizes;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Sides longer than this many sizes are halved.
const MAX_SIDE_LENGTH_IN_SIZES: f64 = 1.5;
/// Sides shorter than this many sizes are collapsed.
const MIN_SIDE_LENGTH_IN_SIZES: f64 = 0.7;
/// Largest number of passes over all sides, with flips between.
const MAX_EVENING_PASSES: u32 = 10;
/// A collapse is rejected if it creates a triangle whose doubled area is below this fraction of its
/// sides' squares.
const MIN_TRIANGLE_AREA_RATIO: f64 = 0.01;
/// A collapse is rejected if it turns a triangle by more than this angle, given as its cosine.
const MIN_NORMAL_TURN_COSINE: f64 = 0.5;

/// Sides this many times too long are halved before others.
const FAR_TOO_LONG_RATIO: f64 = 8.0;

/// Adapts the sides inside the patch to `sizing`. Long sides are halved, which keeps the surface,
/// and short sides are collapsed. The vertices below `rim` stay.
///
/// Halving long needles may need more vertices than the limit. Then sides of twice the length are
/// made first, and short ones collapsed.
///
/// O(passes * triangles) for each such doubling.
pub(crate) fn even_out_side_lengths(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut VertexSizes,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    let side = |t: usize, k: usize| mesh.corner_points(t)[k].distance(mesh.corner_points(t)[(k + 1) % 3]);
    let longest = |t: usize| side(t, 0).max(side(t, 1)).max(side(t, 2)) / sizing.mean_triangle_size(mesh.triangles[t]);
    let halves = (0..mesh.triangles.len()).map(longest).filter(|count| count.is_finite()).sum::<f64>();
    let room = sizing.max_vertices.saturating_sub(mesh.points.len()).max(1) as f64;
    let coarser = libm::ceil(libm::log2(halves / room)).clamp(0.0, 64.0) as usize;
    let scale = |sizing: &mut VertexSizes, by: f64| sizing.wanted_side_lengths.iter_mut().for_each(|size| *size *= by);
    scale(sizing, libm::exp2(coarser as f64));
    for level in 0..coarser {
        halve_and_collapse_once(mesh, rim, sizing, taken, &job.sub_job_of_item(level, coarser + 1))?;
        scale(sizing, 0.5);
    }
    halve_and_collapse_once(mesh, rim, sizing, taken, &job.sub_job_of_item(coarser, coarser + 1))
}

fn halve_and_collapse_once(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut VertexSizes,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    let mut star = Vec::new();
    let mut limited = true;
    for pass in 0..MAX_EVENING_PASSES {
        let part = job.sub_job_of_item(pass as usize, MAX_EVENING_PASSES as usize + 1);
        // Halve again if the limit stopped the last pass.
        if limited {
            limited = halve_long_sides(mesh, sizing, &part.sub_job(0.0, 0.5))?;
        }
        mesh.flip_edges_to_delaunay(rim, taken, &part.sub_job(0.5, 1.0))?;
        let before = mesh.points.len();
        for t in 0..mesh.triangles.len() {
            part.sub_job(1.0, 1.0).step_every(ELEMENTS_PER_REPORT, t, mesh.triangles.len(), "refining")?;
            for k in 0..3 {
                if !mesh.is_removed(t) && (mesh.triangles[t][k] as usize) >= rim {
                    collapse_short_edge(mesh, rim, sizing, taken, (t, k), &mut star)?;
                }
            }
        }
        let kept = mesh.renumber_remaining(rim)?;
        sizing.keep_vertices(&kept);
        if kept.len() == before {
            break;
        }
    }
    mesh.flip_edges_to_delaunay(
        rim,
        taken,
        &job.sub_job_of_item(MAX_EVENING_PASSES as usize, MAX_EVENING_PASSES as usize + 1),
    )
}

/// Halves long sides, those far too long first, so that opposite sides of long needles are cut
/// alike. Returns true if the limit was reached.
fn halve_long_sides(mesh: &mut PatchMesh, sizing: &mut VertexSizes, job: &Job<'_>) -> Result<bool> {
    job.step(0.0, "refining")?;
    let longest = (0..mesh.triangles.len())
        .filter_map(|t| longest_side_if_inner(mesh, sizing, t).filter(|found| found.1.is_finite()))
        .fold(0.0, |x, y| y.1.max(x));
    let mut length = MAX_SIDE_LENGTH_IN_SIZES;
    while FAR_TOO_LONG_RATIO * length < longest {
        length *= 2.0;
    }
    loop {
        let mut t = 0;
        while t < mesh.triangles.len() {
            job.step_every(ELEMENTS_PER_REPORT, t, mesh.triangles.len(), "refining")?;
            match longest_side_if_inner(mesh, sizing, t).filter(|found| found.1 > length) {
                None => t += 1,
                Some(_) if mesh.points.len() >= sizing.max_vertices => return Ok(true),
                Some((k, _, beyond)) => {
                    let [u, v] = [k, (k + 1) % 3].map(|k| mesh.triangles[t][k]);
                    let middle = mesh.points[u as usize].midpoint(mesh.points[v as usize]);
                    sizing.insert_mean([u, v, v], [0.5, 0.5, 0.0])?;
                    mesh.split_side((t, k), beyond, middle)?;
                }
            }
        }
        if length <= MAX_SIDE_LENGTH_IN_SIZES {
            return Ok(false);
        }
        length /= 2.0;
    }
}

/// Returns the longest side of a triangle, its length in sizes, and the side across, if it is
/// inside the patch. Halving a shorter side beside a long rim side would not help.
fn longest_side_if_inner(mesh: &PatchMesh, sizing: &VertexSizes, t: usize) -> Option<(usize, f64, (usize, usize))> {
    let length = |k: usize| mesh.corner_points(t)[k].distance(mesh.corner_points(t)[(k + 1) % 3]);
    let k = (0..3).fold(0, |k, j| if length(j) > length(k) { j } else { k });
    let [u, v] = [k, (k + 1) % 3].map(|k| mesh.triangles[t][k]);
    Some((k, length(k) / sizing.mean_side_size(u, v), mesh.triangle_across(t, k)?))
}

/// Collapses the edge from corner `k` of triangle `t`, a vertex inside the patch, to the next
/// corner. Does nothing if the edge is long enough, or if the result would be invalid.
fn collapse_short_edge(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &VertexSizes,
    taken: &dyn Fn(u32, u32) -> bool,
    (t, k): (usize, usize),
    star: &mut Vec<(usize, usize)>,
) -> Result<()> {
    let [from, onto] = [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]];
    let [p, q] = [from, onto].map(|v| mesh.points[v as usize]);
    if p.distance(q) >= MIN_SIDE_LENGTH_IN_SIZES * sizing.mean_side_size(from, onto)
        || !mesh.one_ring(t, k, star)?
        || star.len() < 4
    {
        return Ok(());
    }
    // Visit all neighbours except the two beside the collapsed edge.
    for &(s, j) in &star[1..star.len() - 1] {
        let [v, w] = [(j + 1) % 3, (j + 2) % 3].map(|j| mesh.triangles[s][j]);
        let [r, x] = [v, w].map(|v| mesh.points[v as usize]);
        let [old, new] = [(r - p).cross(x - p), (r - q).cross(x - q)];
        let turns = old.dot(new) < MIN_NORMAL_TURN_COSINE * old.length() * new.length()
            || new.length() <= MIN_TRIANGLE_AREA_RATIO * (r - x).length_squared().max((r - q).length_squared());
        // The last triangle ends at the second vertex beside the edge, whose edge exists already.
        let is_new = s != star[star.len() - 2].0;
        let is_taken = || mesh.has_edge(t, (k + 1) % 3, w) || (w.max(onto) as usize) < rim && taken(w, onto);
        if turns || is_new && (q.distance(x) > MAX_SIDE_LENGTH_IN_SIZES * sizing.mean_side_size(onto, w) || is_taken())
        {
            return Ok(());
        }
    }
    mesh.collapse_edge((t, k), star);
    Ok(())
}
