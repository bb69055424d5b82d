//! One-rings of a patch: the neighbours of each vertex and their weights. The weights are uniform
//! or cotangents (Pinkall and Polthier 1993), clamped so that slivers do not dominate, and do not
//! detach a vertex.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle::double_area;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::Buckets;

/// The weights of the discrete Laplacian L x(v) = s(v) sum over neighbours w of weight(v, w) (x(w)
/// - x(v)).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LaplacianWeights {
    /// All neighbours have equal weights. The result depends only on the connectivity, and vertices
    /// spread evenly.
    Uniform,
    /// The cotangent weights of the triangles, divided by the vertex's area: the Laplacian of the
    /// surface. The result hardly depends on the triangulation.
    Cotangent,
}

/// The neighbours of every vertex, ascending, with symmetric weights, and the scale of each vertex.
pub(super) struct OneRings {
    ring_starts: Vec<u32>,
    neighbours_and_weights: Vec<(u32, f64)>,
    /// The negative sum of the weights around each vertex.
    negative_weight_sums: Vec<f64>,
    /// The square of s(v), times the vertex's area.
    energy_scales: Vec<f64>,
}

/// Cotangents are clamped to this, for angles of 2.9 and 177.1 degrees, so that slivers do not
/// dominate.
const MAX_COTANGENT: f64 = 20.0;
/// Smallest weight of an edge, so that no vertex is detached from its neighbours.
const MIN_COTANGENT_WEIGHT: f64 = 1e-3;
/// Smallest area of a vertex, relative to the mean.
const MIN_RELATIVE_VERTEX_AREA: f64 = 1e-6;
/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 15;

impl OneRings {
    /// Builds the rings. O(T) for T triangles, which may be degenerate; extra memory: about 100
    /// bytes per triangle.
    pub(super) fn new(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        weights: LaplacianWeights,
        job: &Job<'_>,
    ) -> Result<Self> {
        let proper = triangles.iter().filter(|[a, b, c]| a != b && b != c && c != a);
        let double_area = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            double_area(a, b, c)
        };
        // Computed once for both passes of the buckets.
        let cotangents = alloc::gather(proper.clone().map(|triangle| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            let double_area = double_area(triangle);
            [(a, b, c), (b, c, a), (c, a, b)].map(|(p, q, r)| clamped_cotangent((q - p).dot(r - p), double_area) / 2.0)
        }))?;
        let edges = proper.clone().zip(&cotangents).flat_map(|(&[a, b, c], &[at_a, at_b, at_c])| {
            let sides = [(b, c, at_a), (c, b, at_a), (c, a, at_b), (a, c, at_b), (a, b, at_c), (b, a, at_c)];
            sides.map(|(u, v, weight)| (u as usize, (v, weight)))
        });
        let (start, entries) = Buckets::new(points.len(), (0, 0.0), edges)?.into_parts();
        let mut area = alloc::filled(0.0, points.len())?;
        for triangle in proper {
            let share = double_area(triangle) / 6.0;
            triangle.iter().for_each(|&v| area[v as usize] += share);
        }
        let mut rings = OneRings {
            ring_starts: start,
            neighbours_and_weights: entries,
            negative_weight_sums: Vec::new(),
            energy_scales: area,
        };
        rings.merge_edge_entries(&job.sub_job(0.5, 1.0))?;
        rings.set_weights(points.len(), weights)?;
        Ok(rings)
    }

    /// Merges the entries of each edge, and adds their weights.
    fn merge_edge_entries(&mut self, job: &Job<'_>) -> Result<()> {
        let mut kept = 0;
        let mut from = 0;
        for v in 1..self.ring_starts.len() {
            job.step_every(VERTICES_PER_REPORT, v, self.ring_starts.len(), "fairing")?;
            let to = self.ring_starts[v] as usize;
            // Sort by weight too, so that the sum does not depend on the order of the triangles.
            sort::sort_stable(&mut self.neighbours_and_weights[from..to], &|a, b| {
                a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
            });
            let first = kept;
            for i in from..to {
                let (w, weight) = self.neighbours_and_weights[i];
                if kept > first && self.neighbours_and_weights[kept - 1].0 == w {
                    self.neighbours_and_weights[kept - 1].1 += weight;
                } else {
                    self.neighbours_and_weights[kept] = (w, weight);
                    kept += 1;
                }
            }
            from = to;
            self.ring_starts[v] = kept as u32;
        }
        self.neighbours_and_weights.truncate(kept);
        Ok(())
    }

    /// Replaces the cotangents by the chosen weights, and the areas by scales.
    fn set_weights(&mut self, count: usize, weights: LaplacianWeights) -> Result<()> {
        let used = self.energy_scales.iter().filter(|&&area| area > 0.0).count().max(1) as f64;
        let least_area =
            (MIN_RELATIVE_VERTEX_AREA * self.energy_scales.iter().sum::<f64>() / used).max(f64::MIN_POSITIVE);
        self.negative_weight_sums = alloc::with_capacity(count)?;
        for v in 0..count {
            let range = self.ring_starts[v] as usize..self.ring_starts[v + 1] as usize;
            let valence = range.len().max(1) as f64;
            for entry in &mut self.neighbours_and_weights[range.clone()] {
                entry.1 = match weights {
                    LaplacianWeights::Uniform => 1.0,
                    LaplacianWeights::Cotangent => entry.1.max(MIN_COTANGENT_WEIGHT),
                };
            }
            let sum = self.neighbours_and_weights[range].iter().map(|e| e.1).sum::<f64>();
            self.negative_weight_sums.push(-sum);
            self.energy_scales[v] = match weights {
                LaplacianWeights::Uniform => 1.0 / (valence * valence),
                LaplacianWeights::Cotangent => 1.0 / self.energy_scales[v].max(least_area),
            };
        }
        Ok(())
    }

    /// Returns the neighbours of `v` and their weights.
    pub(super) fn ring(&self, v: usize) -> &[(u32, f64)] {
        &self.neighbours_and_weights[self.ring_starts[v] as usize..self.ring_starts[v + 1] as usize]
    }

    /// Returns the rows of L before scaling, which are its columns too.
    pub(super) fn laplacian_rows(&self) -> MatrixRows<'_> {
        MatrixRows {
            row_starts: &self.ring_starts,
            off_diagonal_entries: &self.neighbours_and_weights,
            diagonal: &self.negative_weight_sums,
        }
    }

    /// Returns the factor of the square of row `v` in the energy.
    pub(super) fn energy_scale(&self, v: usize) -> f64 {
        self.energy_scales[v]
    }
}

/// The rows of a matrix that couples neighbours.
#[derive(Clone, Copy)]
pub(super) struct MatrixRows<'a> {
    row_starts: &'a [u32],
    off_diagonal_entries: &'a [(u32, f64)],
    diagonal: &'a [f64],
}

impl<'a> MatrixRows<'a> {
    /// Creates rows with the neighbours of `rings` and other entries.
    pub(super) fn new(rings: &'a OneRings, entries: &'a [(u32, f64)], middle: &'a [f64]) -> Self {
        MatrixRows { row_starts: &rings.ring_starts, off_diagonal_entries: entries, diagonal: middle }
    }

    /// Returns the entry of a row in the column of a neighbour.
    pub(super) fn row_entry(self, v: usize, w: u32) -> f64 {
        let ring = &self.off_diagonal_entries[self.row_starts[v] as usize..self.row_starts[v + 1] as usize];
        ring.binary_search_by_key(&w, |&(w, _)| w).map_or(0.0, |at| ring[at].1)
    }

    /// Returns the row of a vertex, the vertex itself first.
    pub(super) fn row(self, v: usize) -> impl Iterator<Item = (usize, f64)> + 'a {
        let ring = &self.off_diagonal_entries[self.row_starts[v] as usize..self.row_starts[v + 1] as usize];
        std::iter::once((v, self.diagonal[v])).chain(ring.iter().map(|&(w, weight)| (w as usize, weight)))
    }
}

/// Returns the clamped cotangent of an angle from the dot product and the cross product of its
/// legs.
fn clamped_cotangent(dot: f64, cross: f64) -> f64 {
    // Avoid the quotient if the cross product is small or 0.
    if dot.abs() >= MAX_COTANGENT * cross { MAX_COTANGENT.copysign(dot) } else { dot / cross }
}
