//! Vertex moves within the surface that increase the smallest angle around each vertex.

use super::ELEMENTS_PER_REPORT;
use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle::tangent_of_min_angle;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;

/// Fractions of the way to try, the largest first.
const STEP_FRACTIONS: [f64; 3] = [1.0, 0.5, 0.25];

impl PatchMesh {
    /// Moves each vertex from `rim` towards the centroid of its neighbours, perpendicular to its
    /// normal, as far as that increases its smallest angle. Repeats this `rounds` times, with flips
    /// between.
    pub(crate) fn move_vertices_within_surface(
        &mut self,
        rim: usize,
        taken: &dyn Fn(u32, u32) -> bool,
        rounds: u32,
        job: &Job<'_>,
    ) -> Result<()> {
        for round in 0..rounds {
            let part = job.sub_job_of_item(round as usize, rounds as usize);
            let corners = self.triangles.iter().enumerate().flat_map(|(t, corners)| corners.map(|v| (v as usize, t)));
            let around = Buckets::new(self.points.len(), 0usize, corners)?;
            let mut star = Vec::new();
            for v in rim..self.points.len() {
                part.sub_job(0.0, 0.5).step_every(ELEMENTS_PER_REPORT, v, self.points.len(), "refining")?;
                star.clear();
                alloc::extend(
                    &mut star,
                    around.get(v).iter().map(|&t| {
                        let k = (0..3).find(|&k| self.triangles[t][k] as usize == v).unwrap_or(0);
                        [self.triangles[t][(k + 1) % 3], self.triangles[t][(k + 2) % 3]]
                            .map(|w| self.points[w as usize])
                    }),
                )?;
                self.points[v] = better_position_in_star(self.points[v], &star);
            }
            self.flip_edges_to_delaunay(rim, taken, &part.sub_job(0.5, 1.0))?;
        }
        Ok(())
    }
}

/// Returns a better position for `point` inside the polygon of its `star`.
fn better_position_in_star(point: DVec3, star: &[[DVec3; 2]]) -> DVec3 {
    let tangents = |point: DVec3| star.iter().map(move |&[p, q]| tangent_of_min_angle(point, p, q));
    let area: DVec3 = star.iter().map(|&[p, q]| (p - point).cross(q - point)).sum();
    let normal = area.normalize_or_zero();
    let mut best = (tangents(point).fold(f64::INFINITY, f64::min), point);
    let centre = star.iter().map(|&[p, q]| p + q).sum::<DVec3>() / (2.0 * star.len() as f64);
    let way = (centre - point) - normal * (centre - point).dot(normal);
    for step in STEP_FRACTIONS {
        let place = point + step * way;
        let keeps = star.iter().all(|&[p, q]| (p - place).cross(q - place).dot(normal) > 0.0);
        if keeps && tangents(place).all(|tangent| tangent > best.0) {
            best = (tangents(place).fold(f64::INFINITY, f64::min), place);
        }
    }
    best.1
}
