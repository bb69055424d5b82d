//! A prepared piece: its points in a common unit, smoothed normals, borders, and samples to look
//! for on other pieces.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Topology, half_edges};

const STAGE: &str = "looking at the pieces";
/// Number of smoothing passes over the normals, which are noisy in scans.
const NORMAL_SMOOTHING_PASSES: usize = 3;

/// A piece with positions relative to its own centre, in the common unit.
pub(crate) struct CentredPiece {
    /// The positions of vertices that faces use; the centre for other vertices.
    pub(crate) points: Vec<DVec3>,
    /// The unit normals; 0 for vertices without a face of positive area.
    pub(crate) normals: Vec<DVec3>,
    /// The vertices on borders, and on edges with three or more faces.
    pub(crate) is_rim_vertex: BitSet,
    /// The vertices with a normal, ascending.
    pub(crate) vertices_with_normal: Vec<u32>,
    /// The centre of the piece's box in the common unit.
    pub(crate) centre: DVec3,
    /// The box of the vertices with a normal.
    pub(crate) bounds: Aabb,
    /// The mean of the faces' corners, weighted by area.
    pub(crate) mean_of_corners: DVec3,
    /// The covariance of the faces' corners, weighted by area.
    pub(crate) covariance_of_corners: [[f64; 3]; 3],
    /// The root mean square distance from `mean_of_corners`.
    pub(crate) radius: f64,
    /// The mean length of the faces' sides.
    pub(crate) spacing: f64,
}

impl CentredPiece {
    /// Prepares a piece. `centre` replaces the centre of the piece's box. O(H log V).
    pub(crate) fn new(mesh: &MeshView<'_>, unit: f64, centre: Option<DVec3>, job: &Job<'_>) -> Result<CentredPiece> {
        let count = mesh.positions().len();
        job.step(0.0, STAGE)?;
        let at = |v: u32| mesh.positions().get(v) / unit;
        let mut is_used = BitSet::new(count)?;
        for f in 0..mesh.faces().len() {
            job.step_within_list(f, STAGE)?;
            mesh.face(f).for_each(|v| is_used.insert(v));
        }
        job.step(0.0, STAGE)?;
        let all = Aabb::from_points((0..count as u32).filter(|&v| is_used.contains(v)).map(at));
        job.step(0.0, STAGE)?;
        let centre = centre.unwrap_or(if all.is_empty() { DVec3::ZERO } else { all.centre() });
        let mut points = alloc::filled(DVec3::ZERO, count)?;
        for v in (0..count as u32).filter(|&v| is_used.contains(v)) {
            points[v as usize] = at(v) - centre;
        }
        let topology = Topology::new(mesh, &job.sub_job(0.1, 0.4))?;
        let mut rim = BitSet::new(count)?;
        for h in topology.border_half_edges(&job.sub_job(0.4, 0.4))? {
            [h, mesh.faces().next(h)].into_iter().for_each(|h| rim.insert(mesh.faces().corner(h)));
        }
        let (normals, spacing) = smoothed_vertex_normals(mesh, &points, &job.sub_job(0.4, 0.8))?;
        job.step(0.8, STAGE)?;
        let bounds = Aabb::from_points((0..count).filter(|&v| normals[v] != DVec3::ZERO).map(|v| points[v]));
        let used = alloc::gather((0..count as u32).filter(|&v| normals[v as usize] != DVec3::ZERO))?;
        let (mean, covariance) = mean_and_covariance_of_corners(mesh, &points, &job.sub_job(0.8, 1.0))?;
        let radius = (0..3).map(|k| covariance[k][k]).sum::<f64>().sqrt();
        Ok(CentredPiece {
            points,
            normals,
            is_rim_vertex: rim,
            vertices_with_normal: used,
            centre,
            bounds,
            mean_of_corners: mean,
            covariance_of_corners: covariance,
            radius,
            spacing,
        })
    }

    /// Returns a tree over the points.
    pub(crate) fn build_point_tree(&self, job: &Job<'_>) -> Result<KdTree<'_>> {
        KdTree::new(&self.points, job, STAGE)
    }

    /// Returns up to `count` vertices that are not on a rim, spread evenly over `order`.
    pub(crate) fn choose_samples(&self, order: &[u32], count: usize) -> Result<Vec<u32>> {
        let inside = |&&v: &&u32| self.normals[v as usize] != DVec3::ZERO && !self.is_rim_vertex.contains(v);
        let all = alloc::gather(order.iter().filter(inside).copied())?;
        let count = count.min(all.len());
        alloc::collect((0..count).map(|k| all[k * all.len() / count]))
    }
}

/// Returns the normals of vertices, weighted by the areas of their faces and smoothed over their
/// neighbours, and the mean length of the sides.
fn smoothed_vertex_normals(mesh: &MeshView<'_>, points: &[DVec3], job: &Job<'_>) -> Result<(Vec<DVec3>, f64)> {
    let mut normals = alloc::filled(DVec3::ZERO, points.len())?;
    let (mut length, mut sides) = (0.0, 0.0);
    for f in 0..mesh.faces().len() {
        job.step_within_list(f, STAGE)?;
        // Newell's formula: twice the area, also for polygons.
        let mut normal = DVec3::ZERO;
        for (_, u, v) in half_edges(mesh, f) {
            let [p, q] = [u, v].map(|v| points[v as usize]);
            normal += p.cross(q);
            length += p.distance(q);
            sides += 1.0;
        }
        mesh.face(f).for_each(|v| normals[v as usize] += normal);
    }
    job.step(0.0, STAGE)?;
    normals.iter_mut().for_each(|n| *n = n.normalize_or_zero());
    for pass in 0..NORMAL_SMOOTHING_PASSES {
        let before = alloc::copied(&normals)?;
        let job = job.sub_job_of_item(pass, NORMAL_SMOOTHING_PASSES);
        job.step(0.0, STAGE)?;
        for f in 0..mesh.faces().len() {
            job.step_within_list(f, STAGE)?;
            let sum = mesh.face(f).map(|v| before[v as usize]).sum::<DVec3>();
            mesh.face(f).for_each(|v| normals[v as usize] += sum);
        }
        for (n, old) in normals.iter_mut().zip(&before) {
            *n = n.normalize_or(*old);
        }
    }
    Ok((normals, if sides > 0.0 { length / sides } else { 0.0 }))
}

/// Returns the mean and the covariance of the faces' corners, weighted by area.
fn mean_and_covariance_of_corners(
    mesh: &MeshView<'_>,
    points: &[DVec3],
    job: &Job<'_>,
) -> Result<(DVec3, [[f64; 3]; 3])> {
    let (mut sum, mut area) = (DVec3::ZERO, 0.0);
    let mut square = [[0.0; 3]; 3];
    for f in 0..mesh.faces().len() {
        job.step_within_list(f, STAGE)?;
        let normal = half_edges(mesh, f).map(|(_, u, v)| points[u as usize].cross(points[v as usize])).sum::<DVec3>();
        let part = normal.length() / mesh.face(f).len() as f64;
        for p in mesh.face(f).map(|v| points[v as usize]) {
            (sum, area) = (sum + part * p, area + part);
            (0..3).for_each(|i| (0..3).for_each(|j| square[i][j] += part * p[i] * p[j]));
        }
    }
    if area <= 0.0 {
        return Ok((DVec3::ZERO, [[0.0; 3]; 3]));
    }
    let mean = sum / area;
    let covariance = std::array::from_fn(|i| std::array::from_fn(|j| square[i][j] / area - mean[i] * mean[j]));
    Ok((mean, covariance))
}
