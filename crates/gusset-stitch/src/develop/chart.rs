//! One chart as triangles, each with its own shape.

use super::STAGE;
use super::cut_edges::CutSurface;
use super::split_surface::SurfaceSplitAtCuts;
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::polygon::triangulate_polygon;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{NONE, unordered};

/// Smallest height of a triangle relative to its longest side, and smallest size relative to the
/// mean edge. The gradients of a smaller triangle would be round-off.
const MIN_RELATIVE_TRIANGLE_HEIGHT: f64 = 1e-7;

/// The shape of a triangle in its own frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct TriangleShape {
    /// The gradients of the three barycentric coordinates: J = sum of x_i g_i^T is the derivative
    /// of the linear map that takes the corners to x_0, x_1 and x_2.
    pub(super) gradients: [DVec2; 3],
    pub(super) area: f64,
    /// True if the triangle is flat or too small, and has the limits for its base or height.
    pub(super) is_clamped: bool,
}

/// A triangulated chart.
pub(super) struct ChartMesh {
    /// Gives the position of each vertex on the uncut surface, divided by `unit`.
    pub(super) points: Vec<DVec3>,
    /// The corners of the triangles as vertices of the chart.
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each triangle, the number of its face in the chart.
    pub(super) faces: Vec<u32>,
    pub(super) shapes: Vec<TriangleShape>,
    /// For each triangle, the triangles across its sides, or [`NONE`].
    pub(super) triangles_across_sides: Vec<[u32; 3]>,
    /// The edges of the border, each in the direction of its face.
    pub(super) border: Vec<[u32; 2]>,
}

impl ChartMesh {
    /// Triangulates a chart. `unit` is the divisor of the positions. O(H log H).
    pub(super) fn new(
        surface: &CutSurface<'_, '_>,
        split: &SurfaceSplitAtCuts,
        chart: usize,
        unit: f64,
        job: &Job<'_>,
    ) -> Result<ChartMesh> {
        let mesh = surface.mesh;
        let vertices = split.vertices[chart].clone();
        let first = vertices.start;
        let at = |v: u32| mesh.positions().get(split.vertex_map[v as usize]) / unit;
        let points = alloc::collect_cancellable(vertices.map(at), &job.sub_job(0.0, 0.0), STAGE)?;
        let (mut triangles, mut faces) = (Vec::new(), Vec::new());
        let (mut corners, mut places, mut own) = (Vec::new(), Vec::new(), Vec::new());
        let mut sides = Vec::<TriangleSide>::new();
        for (k, &f) in (0..).zip(split.faces.get(chart)) {
            let count = split.faces.get(chart).len();
            job.step_every(1 << 16, k as usize, count, STAGE)?;
            corners.clear();
            let range = mesh.faces().corner_range(f as usize);
            let (start, size) = (range.start as u32, range.len() as u32);
            alloc::extend(&mut corners, split.corners[range].iter().map(|&v| v - first))?;
            places.clear();
            alloc::extend(&mut places, corners.iter().map(|&v: &u32| points[v as usize]))?;
            triangulate_polygon(&places, &mut own, &job.sub_job_of_item(k as usize, count))?;
            for &triangle in &own {
                for i in 0..3 {
                    let [a, b] = [triangle[i], triangle[(i + 1) % 3]];
                    let on = if (a + 1) % size == b {
                        let (h, mate) = (start + a, surface.mate_across(start + a));
                        (0, u64::from(if mate == NONE { h } else { h.min(mate) }))
                    } else {
                        (1 + k, unordered([a, b]))
                    };
                    let place = sides.len() as u32;
                    alloc::push(&mut sides, (on, place))?;
                }
                alloc::push(&mut triangles, triangle.map(|corner| corners[corner as usize]))?;
                alloc::push(&mut faces, k)?;
            }
        }
        job.step(1.0, STAGE)?;
        let at = |t: &[u32; 3]| t.map(|v| points[v as usize]);
        let perimeter = |[a, b, c]: [DVec3; 3]| a.distance(b) + b.distance(c) + c.distance(a);
        let mean = triangles.iter().map(|t| perimeter(at(t))).sum::<f64>() / (3 * triangles.len()) as f64;
        // A chart that is a point has mean edge 0; in the unit, the surface's size is about 1.
        let least = MIN_RELATIVE_TRIANGLE_HEIGHT * mean.max(MIN_RELATIVE_TRIANGLE_HEIGHT);
        let shapes = triangles.iter().map(|t| clamped_triangle_shape(at(t), least));
        let shapes = alloc::collect_cancellable(shapes, &job.sub_job(1.0, 1.0), STAGE)?;
        job.step(1.0, STAGE)?;
        let across = triangles_across_sides(sides, &job.sub_job(1.0, 1.0))?;
        job.step(1.0, STAGE)?;
        let sides = triangles.iter().zip(&across).flat_map(|(triangle, across)| {
            (0..3).filter(|&k| across[k] == NONE).map(|k| [triangle[k], triangle[(k + 1) % 3]])
        });
        let border = alloc::gather(sides)?;
        Ok(ChartMesh { points, triangles, faces, shapes, triangles_across_sides: across, border })
    }

    /// Returns the distance of two vertices on the surface.
    pub(super) fn surface_distance(&self, u: u32, v: u32) -> f64 {
        self.points[u as usize].distance(self.points[v as usize])
    }

    pub(super) fn total_area(&self) -> f64 {
        self.shapes.iter().map(|shape| shape.area).sum()
    }

    /// Returns twice the signed area of a triangle in the plane.
    pub(super) fn signed_double_area(&self, t: usize, x: &[DVec2]) -> f64 {
        let [a, b, c] = self.triangles[t].map(|v| x[v as usize]);
        (b - a).perp_dot(c - a)
    }

    /// Returns the number of triangles that are turned over or flat in the plane.
    pub(super) fn count_folded_triangles(&self, x: &[DVec2]) -> u32 {
        let stands = |t: usize| self.signed_double_area(t, x) > 0.0;
        (0..self.triangles.len()).filter(|&t| !stands(t)).count() as u32
    }
}

/// Returns the shape of a triangle. Limits its base and height to at least `least`, and to at least
/// [`MIN_RELATIVE_TRIANGLE_HEIGHT`] of its longest side.
fn clamped_triangle_shape([a, b, c]: [DVec3; 3], least: f64) -> TriangleShape {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    let least = least.max(MIN_RELATIVE_TRIANGLE_HEIGHT * longest);
    let length = (b - a).length();
    let along = (b - a).normalize_or(DVec3::X);
    let x = if b == a { (c - a).length() / 2.0 } else { (c - a).dot(along) };
    let distance = ((c - a) - x * along).length();
    let (base, height) = (length.max(least), distance.max(least));
    let corners = [DVec2::ZERO, DVec2::new(base, 0.0), DVec2::new(x, height)];
    let area = base * height / 2.0;
    // The opposite side, rotated inwards by a right angle, over twice the area.
    let gradient = |k: usize| (corners[(k + 2) % 3] - corners[(k + 1) % 3]).perp() / (2.0 * area);
    TriangleShape { gradients: [0, 1, 2].map(gradient), area, is_clamped: length < least || distance < least }
}

/// A side of a triangle: the identity of its edge, a half-edge of the surface or a diagonal, and
/// its index among all sides.
type TriangleSide = ((u32, u64), u32);

/// Returns for each triangle the triangles across its sides, or [`NONE`].
fn triangles_across_sides(mut sides: Vec<TriangleSide>, job: &Job<'_>) -> Result<Vec<[u32; 3]>> {
    let mut across = alloc::filled([NONE; 3], sides.len() / 3)?;
    sort(&mut sides, Ord::cmp, job, STAGE)?;
    for (k, pair) in sides.windows(2).enumerate() {
        job.step_within_list(k, STAGE)?;
        if pair[0].0 == pair[1].0 {
            let [a, b] = [pair[0].1, pair[1].1];
            across[a as usize / 3][a as usize % 3] = b / 3;
            across[b as usize / 3][b as usize % 3] = a / 3;
        }
    }
    Ok(across)
}
