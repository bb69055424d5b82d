//! How one side of a narrow opening sees the other side.

use super::candidates::STAGE;
use super::whole_loops::edge_conormal;
use crate::boundary::Loop;
use crate::stitch::facing::Arc;
use crate::stitch::polyline::nearest_point_on_adjacent_edges;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Sides are near if their distance is at most this fraction of the depth of the faces along them,
/// or of shorter edges.
const MAX_NEAR_GAP_TO_DEPTH_RATIO: f64 = 0.25;

/// Smallest sum of the sides' looks at each other.
const MIN_FACING_COSINE_SUM: f64 = 0.3;

/// Smallest sum of the looks of sides whose surfaces continue each other. It is near 0 where the
/// opening lies across the surface, like a step.
const MIN_FACING_COSINE_SUM_OF_STEP: f64 = -0.3;

/// Largest distance between the sides of a narrow opening, relative to the shorter side.
const MAX_WIDTH_TO_LENGTH_RATIO: f64 = 0.3;

/// Smallest fraction of the length of one side that sees the other side between its ends, for sides
/// that face each other at any distance.
const MIN_LENGTH_SHARE_BETWEEN_ENDS: f64 = 0.5;

/// A run of vertices of a rim.
#[derive(Clone, Copy)]
pub(super) struct RimRun<'a> {
    pub(super) rim: &'a Rim,
    pub(super) arc: Arc,
}

/// How the vertices of one run see another run: means weighted by length.
#[derive(Clone, Copy)]
pub(super) struct SideFacing {
    /// The mean distance to the other run.
    pub(super) mean_gap: f64,
    /// The largest distance to the other run.
    pub(super) max_gap: f64,
    /// The mean cosine between conormals and directions to the other run.
    pub(super) mean_facing_cosine: f64,
    /// The mean cosine between conormals of both runs.
    pub(super) mean_conormal_cosine: f64,
    /// The fraction of the length whose nearest place on the other run is between its ends.
    pub(super) fraction_between_ends: f64,
    /// The length of the shorter run.
    pub(super) length: f64,
}

impl RimRun<'_> {
    /// Returns the lengths of the run's edges.
    pub(super) fn edge_lengths(&self) -> impl Iterator<Item = f64> + '_ {
        let (points, n) = (&self.rim.points, self.rim.points.len());
        let places = (self.arc.first..self.arc.first + self.arc.count - 1).map(move |i| [i % n, (i + 1) % n]);
        places.map(|[i, j]| points[i].distance(points[j]))
    }

    /// Returns the conormal at vertex `k` of the run, by the edges of the run alone.
    fn conormal_at(&self, k: usize) -> DVec3 {
        let n = self.rim.points.len();
        let edges = k.saturating_sub(1)..(k + 1).min(self.arc.count - 1);
        edges.map(|k| edge_conormal(self.rim, (self.arc.first + k) % n)).sum::<DVec3>().normalize_or_zero()
    }

    /// Measures how the inner vertices of this run see the run `other`; `None` without inner
    /// vertices.
    ///
    /// O((n + m) log m) for n and m vertices.
    pub(super) fn measure_facing(&self, other: &RimRun<'_>, job: &Job<'_>) -> Result<Option<SideFacing>> {
        let places = |run: &RimRun<'_>| run.arc.places(run.rim.points.len());
        let line = alloc::collect(places(other).map(|k| other.rim.points[k]))?;
        let tree = KdTree::new(&line, &job.sub_job(0.0, 0.5), STAGE)?;
        let (points, n) = (&self.rim.points, self.rim.points.len());
        let side = |i: usize| points[i].distance(points[(i + 1) % n]);
        let mut sum = 0.0;
        let mut all = SideFacing {
            mean_gap: 0.0,
            max_gap: 0.0,
            mean_facing_cosine: 0.0,
            mean_conormal_cosine: 0.0,
            fraction_between_ends: 0.0,
            length: 0.0,
        };
        for (k, i) in places(self).enumerate().take(self.arc.count - 1).skip(1) {
            job.sub_job(0.5, 1.0).step_every(1 << 12, k, self.arc.count, STAGE)?;
            let p = points[i];
            let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
                continue;
            };
            let nearest = nearest_point_on_adjacent_edges(&line, false, v as usize, p);
            let is_between = nearest != line[0] && nearest != line[line.len() - 1];
            let way = nearest - p;
            let (weight, distance) = (side((i + n - 1) % n) + side(i), way.length());
            let conormal = self.conormal_at(k);
            sum += weight;
            all.mean_gap += weight * distance;
            all.max_gap = all.max_gap.max(distance);
            all.mean_facing_cosine += weight * if distance > 0.0 { way.dot(conormal) / distance } else { 1.0 };
            all.mean_conormal_cosine += weight * conormal.dot(other.conormal_at(v as usize));
            all.fraction_between_ends += if is_between { weight } else { 0.0 };
        }
        let mean = |total: f64| total / sum;
        Ok((sum > 0.0).then(|| SideFacing {
            mean_gap: mean(all.mean_gap),
            max_gap: all.max_gap,
            mean_facing_cosine: mean(all.mean_facing_cosine),
            mean_conormal_cosine: mean(all.mean_conormal_cosine),
            fraction_between_ends: mean(all.fraction_between_ends),
            length: self.edge_lengths().sum::<f64>().min(other.edge_lengths().sum()),
        }))
    }
}

impl SideFacing {
    /// Returns true if the opening between the sides may be closed. `is_near` tells that the gap is
    /// small relative to the faces.
    ///
    /// The sides face each other, or the surfaces along them continue each other: their conormals
    /// are opposite. Conormals of two pages of a book are parallel.
    pub(super) fn may_close(&self, is_near: bool) -> bool {
        let continues = self.mean_conormal_cosine < 0.0 && self.mean_facing_cosine >= MIN_FACING_COSINE_SUM_OF_STEP;
        is_near || continues || self.mean_facing_cosine >= MIN_FACING_COSINE_SUM
    }

    /// Returns true if the sides face each other along their length, at any distance.
    ///
    /// The sides of a hole that a seam crosses see each other's ends instead, and their conormals
    /// agree there.
    pub(super) fn is_opposed(&self) -> bool {
        self.mean_conormal_cosine < 0.0
            && self.mean_facing_cosine >= MIN_FACING_COSINE_SUM
            && self.fraction_between_ends >= MIN_LENGTH_SHARE_BETWEEN_ENDS
    }

    /// Returns true if the opening is narrow relative to its length.
    pub(super) fn is_narrow(&self) -> bool {
        self.max_gap <= MAX_WIDTH_TO_LENGTH_RATIO * self.length
    }

    /// Measures how two runs see each other: the larger distances and shares, and the sums of the
    /// cosines. A side without inner vertices sees what the other sees.
    pub(super) fn between(first: &RimRun<'_>, second: &RimRun<'_>, job: &Job<'_>) -> Result<Option<Self>> {
        let (there, back) = (first.measure_facing(second, job)?, second.measure_facing(first, job)?);
        let sum = |(x, y): (Self, Self)| SideFacing {
            mean_gap: x.mean_gap.max(y.mean_gap),
            max_gap: x.max_gap.max(y.max_gap),
            mean_facing_cosine: x.mean_facing_cosine + y.mean_facing_cosine,
            mean_conormal_cosine: x.mean_conormal_cosine + y.mean_conormal_cosine,
            fraction_between_ends: x.fraction_between_ends.max(y.fraction_between_ends),
            length: x.length,
        };
        Ok(there.or(back).zip(back.or(there)).map(sum))
    }
}

/// For each edge of a rim: its length, and the depth of the face along it, or the length if that is
/// smaller.
pub(super) struct EdgeDepths(Vec<[f64; 2]>);

impl EdgeDepths {
    /// Measures the faces along the loop `found`, whose rim has points in `unit`.
    pub(super) fn measure(mesh: &MeshView<'_>, found: &Loop<'_>, rim: &Rim, unit: f64) -> Result<Self> {
        let n = rim.points.len();
        let of_edge = |i: usize| {
            let (p, q) = (rim.points[i], rim.points[(i + 1) % n]);
            let length = p.distance(q);
            [length, face_depth(mesh, found.faces[i], p, q, unit).min(length)]
        };
        alloc::collect((0..n).map(of_edge)).map(EdgeDepths)
    }

    /// Returns true if a gap along the given edges is small relative to the faces.
    pub(super) fn is_near_gap(&self, gap: f64, edges: impl Iterator<Item = usize>) -> bool {
        let (length, area) = edges
            .map(|i| self.0[i])
            .fold((0.0, 0.0), |(length, area), [edge, depth]| (length + edge, area + edge * depth));
        gap * length <= MAX_NEAR_GAP_TO_DEPTH_RATIO * area
    }

    /// Returns the number of edges.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }
}

/// Returns the depth of face `f` from its edge from `p` to `q`, in `unit`.
fn face_depth(mesh: &MeshView<'_>, f: u32, p: DVec3, q: DVec3, unit: f64) -> f64 {
    let along = (q - p).normalize_or_zero();
    let off = |v: u32| (mesh.positions().get(v) / unit - p).reject_from_normalized(along).length();
    mesh.face(f as usize).map(off).fold(0.0, f64::max)
}
