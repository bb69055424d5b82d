//! Insertion of vertices in large or sharp triangles: Delaunay refinement.
//!
//! Sources: L. P. Chew, *Guaranteed-quality mesh generation for curved surfaces* (1993); J.
//! Ruppert, *A Delaunay refinement algorithm for quality 2-dimensional mesh generation* (1995); A.
//! Üngör, *Off-centers* (2004).
//!
//! A triangle is refined if its circumcircle is too large for the sizes of its corners, or if its
//! least angle is below [`MIN_TRIANGLE_RADIANS`]. The new vertex lies at its circumcentre, or
//! nearer, where it makes a good triangle with the shortest side. The place is found by unfolding
//! the triangles on the way into one plane. Rim edges cannot be split: a place that would see one
//! under a flat angle is rejected.

use super::ELEMENTS_PER_REPORT;
use super::patch_mesh::PatchMesh;
use super::sizing::VertexSizes;
use glam::{DVec2, DVec3};
use gusset_base::error::Result;
use gusset_base::geom::triangle::{double_area, min_angle};
use gusset_base::job::Job;

/// Triangles with a smaller angle are refined; in radians, 25 degrees.
const MIN_TRIANGLE_RADIANS: f64 = 25.0 * std::f64::consts::PI / 180.0;
/// The height of a good triangle over its shortest side, in lengths of this side. It is 0.95 of 1 /
/// (2 tan(MIN_TRIANGLE_RADIANS / 2)). At the full height the angle would be
/// [`MIN_TRIANGLE_RADIANS`] itself, and round-off would decide whether it is sharp.
const OFF_CENTRE_HEIGHT_RATIO: f64 = 0.95 * 2.2553542518310286;
/// Largest circumradius relative to the size; an equilateral triangle has 0.577.
const MAX_CIRCUMRADIUS_IN_SIZES: f64 = 0.85;
/// Sides longer than this many sizes are too long.
const MAX_SIDE_LENGTH_IN_SIZES: f64 = 1.5;
/// Needles whose shortest side is below this fraction of the size have a large circumcircle at any
/// length. Only the longest side counts for them.
const MIN_SHORTEST_SIDE_IN_SIZES: f64 = 0.3;
/// Smallest distance of a new vertex from others, relative to the shortest side of the refined
/// triangle.
const MIN_RELATIVE_VERTEX_SPACING: f64 = 1.0;
/// The cosine of the flattest angle under which a new vertex may see a rim edge.
const MIN_RIM_EDGE_COSINE: f64 = -0.7;
/// Largest number of passes over all triangles.
const MAX_REFINEMENT_PASSES: u32 = 40;
/// Largest number of triangles on the way to a new vertex.
const MAX_WALKED_TRIANGLES: usize = 64;
/// A place nearer to a side than this fraction of the height splits the side.
const MAX_ON_SIDE_HEIGHT_RATIO: f64 = 0.05;

/// The place of a new vertex: a triangle, and barycentric coordinates in it.
struct NewVertexPlace {
    triangle: usize,
    weights: [f64; 3],
}

/// Refines a mesh: inserts vertices until no triangle is larger than its size or sharper than
/// [`MIN_TRIANGLE_RADIANS`], as far as the rim (the vertices below `rim`) allows. For `taken` see
/// [`PatchMesh::flip_edges_to_delaunay`].
///
/// O(passes * triangles), times the number of triangles at a vertex.
pub(crate) fn refine_by_insertion(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut VertexSizes,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    for pass in 1..=MAX_REFINEMENT_PASSES {
        let part = job.sub_job(1.0 - 1.0 / f64::from(pass), 1.0 - 1.0 / f64::from(pass + 1));
        mesh.flip_edges_to_delaunay(rim, taken, &part)?;
        let before = mesh.points.len();
        for t in 0..mesh.triangles.len() {
            part.sub_job(1.0, 1.0).step_every(ELEMENTS_PER_REPORT, t, mesh.triangles.len(), "refining")?;
            if mesh.points.len() >= sizing.max_vertices {
                break;
            }
            let Some((place, spacing)) = place_of_wanted_vertex(mesh, t, sizing) else {
                continue;
            };
            insert_vertex(mesh, rim, sizing, taken, &place, spacing)?;
        }
        if mesh.points.len() == before {
            return Ok(());
        }
    }
    mesh.flip_edges_to_delaunay(rim, taken, &job.sub_job(1.0, 1.0))
}

/// Returns the place of a new vertex that improves triangle `t`, and the least distance that the new
/// vertex must keep from other vertices.
fn place_of_wanted_vertex(mesh: &PatchMesh, t: usize, sizing: &VertexSizes) -> Option<(NewVertexPlace, f64)> {
    let corners = mesh.corner_points(t);
    let side = |k: usize| corners[k].distance(corners[(k + 1) % 3]);
    let sides = [side(0), side(1), side(2)];
    let shortest = (0..3).fold(0, |k, j| if sides[j] < sides[k] { j } else { k });
    let e = sides[shortest];
    let double = double_area(corners[0], corners[1], corners[2]);
    if double.is_nan() || double <= 1e-9 * sides[(shortest + 1) % 3].powi(2) || e <= 0.0 {
        return None;
    }
    let radius = sides[0] * sides[1] * sides[2] / (2.0 * double);
    let size = sizing.mean_triangle_size(mesh.triangles[t]);
    let longest = sides[0].max(sides[1]).max(sides[2]);
    let large = longest > MAX_SIDE_LENGTH_IN_SIZES * size
        || (radius > MAX_CIRCUMRADIUS_IN_SIZES * size && e >= MIN_SHORTEST_SIDE_IN_SIZES * size);
    let sharp = || {
        e >= sizing.min_shortest_side_in_sizes * size
            && min_angle(corners[0], corners[1], corners[2]) < MIN_TRIANGLE_RADIANS
    };
    if !large && !sharp() {
        return None;
    }
    // Use the plane of the triangle, with its shortest side along x.
    let [p, q, r] = [0, 1, 2].map(|k| corners[(shortest + k) % 3]);
    let x = (q - p) / e;
    let flat = |v: DVec3| DVec2::new((v - p).dot(x), ((v - p) - x * (v - p).dot(x)).length());
    let apex = flat(r);
    // The bisector of the shortest side, up to the circumcentre.
    let up = (apex.length_squared() - apex.x * e) / (2.0 * apex.y);
    let height = up.min(OFF_CENTRE_HEIGHT_RATIO * e);
    let target = DVec2::new(e / 2.0, height);
    let plane = [DVec2::ZERO, DVec2::new(e, 0.0), apex];
    Some((walk_to_target(mesh, t, shortest, plane, target)?, MIN_RELATIVE_VERTEX_SPACING * e))
}

/// Follows the unfolded triangles from `t` to the triangle that contains `target`. The corners of
/// `t` from `first` are at `plane`. Returns `None` if the rim is in the way.
fn walk_to_target(
    mesh: &PatchMesh,
    mut t: usize,
    mut first: usize,
    mut plane: [DVec2; 3],
    target: DVec2,
) -> Option<NewVertexPlace> {
    for _ in 0..MAX_WALKED_TRIANGLES {
        let whole = (plane[1] - plane[0]).perp_dot(plane[2] - plane[0]);
        let part = |k: usize| (plane[(k + 1) % 3] - target).perp_dot(plane[(k + 2) % 3] - target) / whole;
        let weights = [part(0), part(1), part(2)];
        if !weights.iter().all(|w| w.is_finite()) {
            return None;
        }
        let least = (0..3).fold(0, |k, j| if weights[j] < weights[k] { j } else { k });
        if weights[least] >= 0.0 {
            let mut own = [0.0; 3];
            (0..3).for_each(|k| own[(first + k) % 3] = weights[k]);
            return Some(NewVertexPlace { triangle: t, weights: own });
        }
        // Step across the side opposite to that corner.
        let from = (least + 1) % 3;
        let (s, j) = mesh.triangle_across(t, (first + from) % 3)?;
        let (p, q) = (plane[from], plane[(from + 1) % 3]);
        let [u, v, w] = [0, 1, 2].map(|k| mesh.points[mesh.triangles[s][(j + k) % 3] as usize]);
        // u is at q, and v at p.
        let length = u.distance(v);
        let x = (v - u) / length;
        let along = (w - u).dot(x);
        let off = ((w - u) - x * along).length();
        let axis = (p - q) / length;
        (t, first, plane) = (s, j, [q, p, q + axis * along + axis.perp() * off]);
    }
    None
}

/// Inserts a vertex, unless it would be too near to others, or see a rim edge under a flat angle.
fn insert_vertex(
    mesh: &mut PatchMesh,
    rim: usize,
    sizing: &mut VertexSizes,
    taken: &dyn Fn(u32, u32) -> bool,
    place: &NewVertexPlace,
    spacing: f64,
) -> Result<()> {
    let t = place.triangle;
    let corners = mesh.corner_points(t);
    let mut weights = place.weights;
    let least = (0..3).fold(0, |k, j| if weights[j] < weights[k] { j } else { k });
    let across =
        if weights[least] < MAX_ON_SIDE_HEIGHT_RATIO { mesh.triangle_across(t, (least + 1) % 3) } else { None };
    if across.is_some() {
        let sum = 1.0 - weights[least];
        weights[least] = 0.0;
        weights.iter_mut().for_each(|w| *w /= sum);
    }
    let point = (0..3).map(|k| corners[k] * weights[k]).sum::<DVec3>();
    if !point.is_finite() || !is_clear_of_vertices_and_rim(mesh, t, point, spacing) {
        return Ok(());
    }
    if across.is_some_and(|(s, _)| !is_clear_of_vertices_and_rim(mesh, s, point, spacing)) {
        return Ok(());
    }
    sizing.insert_mean(mesh.triangles[t], weights)?;
    match across {
        Some(beyond) => {
            let parts = mesh.split_side((t, (least + 1) % 3), beyond, point)?;
            mesh.flip_to_delaunay_around(rim, taken, &parts)
        }
        None => {
            let parts = mesh.split_triangle(t, point)?;
            mesh.flip_to_delaunay_around(rim, taken, &parts)
        }
    }
}

/// Returns true if a vertex at `point` in triangle `t` is far enough from the corners, and sees no
/// near rim edge under a flat angle.
fn is_clear_of_vertices_and_rim(mesh: &PatchMesh, t: usize, point: DVec3, spacing: f64) -> bool {
    let sees_flat = |t: usize| {
        let corners = mesh.corner_points(t);
        (0..3).filter(|&k| mesh.triangle_across(t, k).is_none()).any(|k| {
            let (u, v) = (corners[k] - point, corners[(k + 1) % 3] - point);
            u.dot(v) < MIN_RIM_EDGE_COSINE * u.length() * v.length()
        })
    };
    (0..3).all(|k| mesh.corner_points(t)[k].distance(point) >= spacing && !mesh.any_triangle_around(t, k, sees_flat))
}
