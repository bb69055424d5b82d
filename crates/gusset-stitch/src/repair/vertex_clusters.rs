//! Clusters of vertices that lie together.
//!
//! In ascending order, each unclaimed vertex becomes a representative. It claims the unclaimed
//! vertices at its position, or within mutual reach: nearest first, and the smallest of equally
//! near ones. See [`weld`](super::weld) for the consequences.
//!
//! Equal positions are found by sorting, near ones in a k-d tree: O(n log n), because
//! representatives are apart, so that a point is within reach of few of them. If corners of one
//! face are kept apart, each coincident corner becomes a representative in turn.

use super::sew_edges::free_vertices;
use super::vertex_corners::VertexCorners;
use super::weld_tolerance::{ToleranceSource, WeldDistances};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE, Topology};

/// A partition of the vertices into clusters.
pub(super) struct VertexClusters {
    /// For each vertex of the mesh, the smallest vertex of its cluster; the vertex itself if it is
    /// not clustered.
    pub(super) representative: Vec<u32>,
    /// Coincident vertices that were kept apart because they are corners of one face; unordered.
    pub(super) kept_apart: Vec<u32>,
}

/// Number of claims between two progress reports.
const CLAIMS_PER_REPORT: usize = 1 << 14;

/// Number of candidates of one claim between two progress reports.
const CANDIDATES_PER_REPORT: usize = 1 << 18;

/// Sorting this number of candidates reports progress.
const MIN_CANDIDATES_SORTED_WITH_REPORTS: usize = 1 << 14;

const STAGE: &str = "clustering vertices";

/// Returns for each vertex the smallest border vertex that coincides with it; the vertex itself if
/// none does. `tolerance` is limited at short edges.
pub(crate) fn border_clusters(mesh: &MeshView<'_>, tolerance: f64, job: &Job<'_>) -> Result<Vec<u32>> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.4))?;
    let members = free_vertices(mesh, &topology)?;
    let source = ToleranceSource::Earlier(tolerance);
    let distances = WeldDistances::find_for_members(mesh, &members, source, false, &job.sub_job(0.4, 0.5))?;
    let clusters = VertexClusters::cluster_members(
        mesh,
        &members,
        &distances.max_distance_of_member,
        None,
        &job.sub_job(0.5, 1.0),
    )?;
    Ok(clusters.representative)
}

impl VertexClusters {
    /// Clusters `members`, which are ascending and have finite positions.
    ///
    /// `reach` has a length, at least 0, for each member; it is empty for equal positions. With
    /// `corners`, no cluster has two corners of one face.
    pub(super) fn cluster_members(
        mesh: &MeshView<'_>,
        members: &[u32],
        reach: &[f64],
        corners: Option<&VertexCorners>,
        job: &Job<'_>,
    ) -> Result<Self> {
        let positions = members.iter().map(|&v| mesh.positions().get(v));
        let points = alloc::collect_cancellable(positions, &job.sub_job(0.0, 0.0), STAGE)?;
        job.step(0.0, STAGE)?;
        let near = NearVertexSearch::new(&points, reach, &job.sub_job(0.0, 0.4))?;
        let job = job.sub_job(0.4, 1.0);
        job.step(0.0, STAGE)?;
        let mut guard = FaceCornerGuard::new(mesh, corners)?;
        let mut clusters = VertexClusters {
            representative: alloc::collect((0..mesh.positions().len()).map(|v| v as u32))?,
            kept_apart: Vec::new(),
        };
        job.step(0.0, STAGE)?;
        let mut claimed = alloc::filled(false, members.len())?;
        let mut candidates = Vec::new();
        for (i, &representative) in members.iter().enumerate() {
            job.step_every(CLAIMS_PER_REPORT, i, members.len(), STAGE)?;
            if claimed[i] {
                continue;
            }
            claimed[i] = true;
            candidates.clear();
            let here = i as f64 / members.len() as f64;
            near.append_near_members(&points, i, &mut candidates, &job.sub_job(here, here))?;
            guard.admit_to_cluster(representative, representative);
            for (k, &(_, j)) in (1..).zip(&candidates) {
                if k % CANDIDATES_PER_REPORT == 0 {
                    job.step(here, STAGE)?;
                }
                let (j, v) = (j as usize, members[j as usize]);
                if claimed[j] {
                    continue;
                }
                if guard.admit_to_cluster(representative, v) {
                    claimed[j] = true;
                    clusters.representative[v as usize] = representative;
                } else {
                    alloc::append(&mut clusters.kept_apart, &[representative, v])?;
                }
            }
        }
        Ok(clusters)
    }
}

/// The search for nearby vertices.
enum NearVertexSearch<'a> {
    /// The members in the order of their positions, and for each member the start of its group in
    /// that order.
    Equal {
        order: Vec<u32>,
        begin: Vec<u32>,
    },
    Within {
        tree: KdTree<'a>,
        reach: &'a [f64],
    },
}

impl<'a> NearVertexSearch<'a> {
    fn new(points: &'a [DVec3], reach: &'a [f64], job: &Job<'_>) -> Result<Self> {
        if !reach.is_empty() {
            return Ok(NearVertexSearch::Within { tree: KdTree::new(points, job, STAGE)?, reach });
        }
        job.step(0.0, STAGE)?;
        // Convert -0 to 0, so that the order of bits is the order of numbers.
        let numbered = points.iter().enumerate().map(|(i, &p)| (p + DVec3::ZERO, i as u32));
        let mut sorted = alloc::collect_cancellable(numbered, &job.sub_job(0.0, 0.0), STAGE)?;
        let by_position = |(p, i): &(DVec3, u32), (q, j): &(DVec3, u32)| {
            p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z)).then(i.cmp(j))
        };
        sort(&mut sorted, by_position, job, STAGE)?;
        let order = alloc::collect_cancellable(sorted.iter().map(|&(_, i)| i), &job.sub_job(1.0, 1.0), STAGE)?;
        drop(sorted);
        job.step(1.0, STAGE)?;
        let mut begin = alloc::filled(0u32, points.len())?;
        let mut group = 0;
        for (k, &i) in order.iter().enumerate() {
            job.sub_job(1.0, 1.0).step_within_list(k, STAGE)?;
            if points[i as usize] != points[order[group] as usize] {
                group = k;
            }
            begin[i as usize] = group as u32;
        }
        Ok(NearVertexSearch::Equal { order, begin })
    }

    /// Appends the members near member `i`, including itself, as (squared distance, member),
    /// nearest first.
    fn append_near_members(&self, points: &[DVec3], i: usize, out: &mut Vec<(f64, u32)>, job: &Job<'_>) -> Result<()> {
        match self {
            NearVertexSearch::Equal { order, begin } => {
                let group = order[begin[i] as usize..].iter().take_while(|&&j| points[j as usize] == points[i]);
                for &j in group {
                    alloc::push(out, (0.0, j))?;
                    if out.len().is_multiple_of(CANDIDATES_PER_REPORT) {
                        job.step(0.0, STAGE)?;
                    }
                }
            }
            NearVertexSearch::Within { tree, reach } => {
                let mut outcome = Ok(());
                let radius = |i: usize| ScaledRadius::new(reach[i].max(f64::from_bits(1)));
                tree.for_each_within(points[i], radius(i), &mut |squared, j| {
                    let difference = points[j as usize] - points[i];
                    if outcome.is_ok() && (reach[j as usize] >= reach[i] || radius(j as usize).contains(difference)) {
                        outcome = alloc::push(out, (squared, j));
                        if out.len().is_multiple_of(CANDIDATES_PER_REPORT) && outcome.is_ok() {
                            outcome = job.step(0.0, STAGE);
                        }
                    }
                });
                outcome?;
                let nearest_first = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
                if out.len() < MIN_CANDIDATES_SORTED_WITH_REPORTS {
                    sort::sort_stable(out, &nearest_first);
                } else {
                    sort(out, nearest_first, job, STAGE)?;
                }
            }
        }
        Ok(())
    }
}

/// Keeps corners of one face apart.
struct FaceCornerGuard<'a> {
    corners: Option<&'a VertexCorners>,
    /// For each face, the representative that last got one of its corners.
    last_representative_of_face: Vec<u32>,
}

impl<'a> FaceCornerGuard<'a> {
    fn new(mesh: &MeshView<'_>, corners: Option<&'a VertexCorners>) -> Result<Self> {
        let faces = if corners.is_some() { mesh.faces().len() } else { 0 };
        Ok(FaceCornerGuard { corners, last_representative_of_face: alloc::filled(NONE, faces)? })
    }

    /// Admits `v` to the cluster of `representative`. Returns false if a face has both `v` and an
    /// earlier vertex of the cluster.
    fn admit_to_cluster(&mut self, representative: u32, v: u32) -> bool {
        let Some(corners) = self.corners else { return true };
        if corners
            .corners_at_vertex(v)
            .iter()
            .any(|&h| self.last_representative_of_face[corners.face_of_corner(h)] == representative)
        {
            return false;
        }
        for &h in corners.corners_at_vertex(v) {
            self.last_representative_of_face[corners.face_of_corner(h)] = representative;
        }
        true
    }
}
