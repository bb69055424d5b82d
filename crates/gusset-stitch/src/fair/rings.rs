//! One-rings of a patch: the neighbours of each vertex and their weights, uniform or cotangents
//! (Pinkall and Polthier 1993), clamped so that slivers neither dominate nor detach a vertex.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle::double_area;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::Buckets;

/// The discrete Laplacian L x(v) = s(v) sum over neighbours w of weight(v, w) (x(w) - x(v)).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weights {
    /// Every neighbour weighs the same. The result depends on the connectivity alone, and vertices
    /// spread evenly.
    Uniform,
    /// The cotangent weights of the triangles as they are, over the vertex's share of the area: the
    /// Laplacian of the surface. The shape of the result hardly depends on the triangulation.
    Cotangent,
}

/// The neighbours of every vertex, ascending, with weights that are the same both ways, and each
/// vertex's scale.
pub(super) struct Rings {
    start: Vec<u32>,
    entries: Vec<(u32, f64)>,
    /// Less the sum of the weights round a vertex.
    middle: Vec<f64>,
    /// The square of s(v) times the vertex's share of the area.
    scale: Vec<f64>,
}

/// Cotangents are kept within these bounds, those of 2.9 and 177.1 degrees: slivers must not
/// outweigh all others.
const MAX_COTANGENT: f64 = 20.0;
/// An edge weighs at least this much, so that no vertex is let go by its neighbours.
const MIN_COTANGENT: f64 = 1e-3;
/// Areas below this part of the mean are taken to be this part.
const MIN_AREA_SHARE: f64 = 1e-6;
/// Vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 15;

impl Rings {
    /// O(T) for T triangles, which may repeat vertices or be without area; extra memory: about 100
    /// bytes a triangle.
    pub(super) fn new(points: &[DVec3], triangles: &[[u32; 3]], weights: Weights, job: &Job<'_>) -> Result<Self> {
        let proper = triangles.iter().filter(|[a, b, c]| a != b && b != c && c != a);
        let double_area = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            double_area(a, b, c)
        };
        // Once for both passes of the buckets.
        let cotangents = alloc::gather(proper.clone().map(|triangle| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            let double_area = double_area(triangle);
            [(a, b, c), (b, c, a), (c, a, b)].map(|(p, q, r)| cotangent((q - p).dot(r - p), double_area) / 2.0)
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
        let mut rings = Rings { start, entries, middle: Vec::new(), scale: area };
        rings.merge(&job.part(0.5, 1.0))?;
        rings.weigh(points.len(), weights)?;
        Ok(rings)
    }

    /// Makes one entry of the two or more that an edge has, with the sum of their weights.
    fn merge(&mut self, job: &Job<'_>) -> Result<()> {
        let mut kept = 0;
        let mut from = 0;
        for v in 1..self.start.len() {
            job.step_every(REPORT_INTERVAL, v, self.start.len(), "fairing")?;
            let to = self.start[v] as usize;
            // By weight too, so that the sum does not depend on the order of the triangles.
            sort::stable(&mut self.entries[from..to], &|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            let first = kept;
            for i in from..to {
                let (w, weight) = self.entries[i];
                if kept > first && self.entries[kept - 1].0 == w {
                    self.entries[kept - 1].1 += weight;
                } else {
                    self.entries[kept] = (w, weight);
                    kept += 1;
                }
            }
            from = to;
            self.start[v] = kept as u32;
        }
        self.entries.truncate(kept);
        Ok(())
    }

    /// Replaces the cotangents by the weights asked for, and the areas by scales.
    fn weigh(&mut self, count: usize, weights: Weights) -> Result<()> {
        let used = self.scale.iter().filter(|&&area| area > 0.0).count().max(1) as f64;
        let least_area = (MIN_AREA_SHARE * self.scale.iter().sum::<f64>() / used).max(f64::MIN_POSITIVE);
        self.middle = alloc::with_capacity(count)?;
        for v in 0..count {
            let range = self.start[v] as usize..self.start[v + 1] as usize;
            let valence = range.len().max(1) as f64;
            for entry in &mut self.entries[range.clone()] {
                entry.1 = match weights {
                    Weights::Uniform => 1.0,
                    Weights::Cotangent => entry.1.max(MIN_COTANGENT),
                };
            }
            let sum = self.entries[range].iter().map(|e| e.1).sum::<f64>();
            self.middle.push(-sum);
            self.scale[v] = match weights {
                Weights::Uniform => 1.0 / (valence * valence),
                Weights::Cotangent => 1.0 / self.scale[v].max(least_area),
            };
        }
        Ok(())
    }

    /// The neighbours of `v` and their weights.
    pub(super) fn ring(&self, v: usize) -> &[(u32, f64)] {
        &self.entries[self.start[v] as usize..self.start[v + 1] as usize]
    }

    /// The rows of L before scaling. They are its columns too.
    pub(super) fn rows(&self) -> Rows<'_> {
        Rows { start: &self.start, entries: &self.entries, middle: &self.middle }
    }

    /// What the square of row `v` is multiplied by in the energy.
    pub(super) fn scale(&self, v: usize) -> f64 {
        self.scale[v]
    }
}

/// The rows of a matrix that couples neighbours.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    start: &'a [u32],
    entries: &'a [(u32, f64)],
    middle: &'a [f64],
}

impl<'a> Rows<'a> {
    /// With the neighbours of rings and other entries.
    pub(super) fn new(rings: &'a Rings, entries: &'a [(u32, f64)], middle: &'a [f64]) -> Self {
        Rows { start: &rings.start, entries, middle }
    }

    /// The entry of a row in the column of a neighbour.
    pub(super) fn entry(self, v: usize, w: u32) -> f64 {
        let ring = &self.entries[self.start[v] as usize..self.start[v + 1] as usize];
        ring.binary_search_by_key(&w, |&(w, _)| w).map_or(0.0, |at| ring[at].1)
    }

    /// The row of a vertex, itself first.
    pub(super) fn row(self, v: usize) -> impl Iterator<Item = (usize, f64)> + 'a {
        let ring = &self.entries[self.start[v] as usize..self.start[v + 1] as usize];
        std::iter::once((v, self.middle[v])).chain(ring.iter().map(|&(w, weight)| (w as usize, weight)))
    }
}

/// The cotangent of an angle from the product and the cross product of its legs, kept within
/// bounds.
fn cotangent(dot: f64, cross: f64) -> f64 {
    // Not a quotient where the cross product is small or 0.
    if dot.abs() >= MAX_COTANGENT * cross { MAX_COTANGENT.copysign(dot) } else { dot / cross }
}
