//! Sides of about the length that is wanted: long ones are halved, short ones collapsed.
//!
//! Source: M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling* (2004).

use super::REPORT_INTERVAL;
use super::patch_mesh::PatchMesh;
use super::sizing::Sizing;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Sides that are longer, in sizes, are halved.
const MAX_LENGTH: f64 = 1.5;
/// Sides that are shorter are collapsed.
const MIN_LENGTH: f64 = 0.7;
/// Passes over all sides, with flips between.
const MAX_PASSES: u32 = 10;
/// No collapse makes a triangle of less doubled area, as part of the squares of its sides.
const FLAT: f64 = 0.01;
/// No collapse turns a triangle by more: the cosine.
const MIN_TURN: f64 = 0.5;

/// Sides so many times too long are halved before others.
const MUCH_TOO_LONG: f64 = 8.0;

/// Makes the sides inside the patch as long as `sizing` says, by halving the long ones, which
/// leaves the surface as it is, and collapsing the short ones. The vertices below `rim` stay. Where
/// halving long needles would make more vertices than there is room for, sides of twice the length
/// come first, whose short ones are collapsed before.
///
/// O(passes * triangles), for each doubling of the length that comes first.
pub(crate) fn even(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut Sizing,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    let side = |t: usize, k: usize| mesh.corners(t)[k].distance(mesh.corners(t)[(k + 1) % 3]);
    let longest = |t: usize| side(t, 0).max(side(t, 1)).max(side(t, 2)) / sizing.of(mesh.triangles[t]);
    let halves = (0..mesh.triangles.len()).map(longest).filter(|count| count.is_finite()).sum::<f64>();
    let room = sizing.limit.saturating_sub(mesh.points.len()).max(1) as f64;
    let coarser = libm::ceil(libm::log2(halves / room)).clamp(0.0, 64.0) as usize;
    let scale = |sizing: &mut Sizing, by: f64| sizing.size.iter_mut().for_each(|size| *size *= by);
    scale(sizing, libm::exp2(coarser as f64));
    for level in 0..coarser {
        even_once(mesh, rim, sizing, taken, &job.share(level, coarser + 1))?;
        scale(sizing, 0.5);
    }
    even_once(mesh, rim, sizing, taken, &job.share(coarser, coarser + 1))
}

fn even_once(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut Sizing,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    let mut star = Vec::new();
    let mut limited = true;
    for pass in 0..MAX_PASSES {
        let part = job.share(pass as usize, MAX_PASSES as usize + 1);
        // Again if the limit was in the way before something collapsed.
        if limited {
            limited = halve(mesh, sizing, &part.part(0.0, 0.5))?;
        }
        mesh.relax(rim, taken, &part.part(0.5, 1.0))?;
        let before = mesh.points.len();
        for t in 0..mesh.triangles.len() {
            part.part(1.0, 1.0).step_every(REPORT_INTERVAL, t, mesh.triangles.len(), "refining")?;
            for k in 0..3 {
                if !mesh.is_gone(t) && (mesh.triangles[t][k] as usize) >= rim {
                    collapse(mesh, rim, sizing, taken, (t, k), &mut star)?;
                }
            }
        }
        let kept = mesh.compact(rim)?;
        sizing.keep(&kept);
        if kept.len() == before {
            break;
        }
    }
    mesh.relax(rim, taken, &job.share(MAX_PASSES as usize, MAX_PASSES as usize + 1))
}

/// Halves long sides; those that are far too long first, so that opposite sides of long needles are
/// cut alike. True if the limit was in the way.
fn halve(mesh: &mut PatchMesh, sizing: &mut Sizing, job: &Job<'_>) -> Result<bool> {
    job.step(0.0, "refining")?;
    let longest = (0..mesh.triangles.len())
        .filter_map(|t| longest_inside(mesh, sizing, t).filter(|found| found.1.is_finite()))
        .fold(0.0, |x, y| y.1.max(x));
    let mut length = MAX_LENGTH;
    while MUCH_TOO_LONG * length < longest {
        length *= 2.0;
    }
    loop {
        let mut t = 0;
        while t < mesh.triangles.len() {
            job.step_every(REPORT_INTERVAL, t, mesh.triangles.len(), "refining")?;
            match longest_inside(mesh, sizing, t).filter(|found| found.1 > length) {
                None => t += 1,
                Some(_) if mesh.points.len() >= sizing.limit => return Ok(true),
                Some((k, _, beyond)) => {
                    let [u, v] = [k, (k + 1) % 3].map(|k| mesh.triangles[t][k]);
                    let middle = mesh.points[u as usize].midpoint(mesh.points[v as usize]);
                    sizing.insert([u, v, v], [0.5, 0.5, 0.0])?;
                    mesh.split_side((t, k), beyond, middle)?;
                }
            }
        }
        if length <= MAX_LENGTH {
            return Ok(false);
        }
        length /= 2.0;
    }
}

/// The longest side of a triangle, its length in sizes and the side beyond, if it is inside the
/// patch: beside a longer one on the rim nothing becomes shorter than its half.
fn longest_inside(mesh: &PatchMesh, sizing: &Sizing, t: usize) -> Option<(usize, f64, (usize, usize))> {
    let length = |k: usize| mesh.corners(t)[k].distance(mesh.corners(t)[(k + 1) % 3]);
    let k = (0..3).fold(0, |k, j| if length(j) > length(k) { j } else { k });
    let [u, v] = [k, (k + 1) % 3].map(|k| mesh.triangles[t][k]);
    Some((k, length(k) / sizing.between(u, v), mesh.beyond(t, k)?))
}

/// Moves corner `k` of triangle `t`, a vertex inside the patch, onto the next corner if they are
/// too near each other and nothing speaks against it.
fn collapse(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &Sizing,
    taken: &dyn Fn(u32, u32) -> bool,
    (t, k): (usize, usize),
    star: &mut Vec<(usize, usize)>,
) -> Result<()> {
    let [from, onto] = [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]];
    let [p, q] = [from, onto].map(|v| mesh.points[v as usize]);
    if p.distance(q) >= MIN_LENGTH * sizing.between(from, onto) || !mesh.round(t, k, star)? || star.len() < 4 {
        return Ok(());
    }
    // All neighbours but the two beside the side.
    for &(s, j) in &star[1..star.len() - 1] {
        let [v, w] = [(j + 1) % 3, (j + 2) % 3].map(|j| mesh.triangles[s][j]);
        let [r, x] = [v, w].map(|v| mesh.points[v as usize]);
        let [old, new] = [(r - p).cross(x - p), (r - q).cross(x - q)];
        let turns = old.dot(new) < MIN_TURN * old.length() * new.length()
            || new.length() <= FLAT * (r - x).length_squared().max((r - q).length_squared());
        // The last one ends at the second vertex beside the side, which has its edge already.
        let is_new = s != star[star.len() - 2].0;
        let is_taken = || mesh.has_edge(t, (k + 1) % 3, w) || (w.max(onto) as usize) < rim && taken(w, onto);
        if turns || is_new && (q.distance(x) > MAX_LENGTH * sizing.between(onto, w) || is_taken()) {
            return Ok(());
        }
    }
    mesh.collapse((t, k), star);
    Ok(())
}
