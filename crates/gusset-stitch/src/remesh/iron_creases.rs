//! Smoothing of creases: where a fine surface folds over itself, vertices move to the means of
//! their neighbours, until no side bends by more than a limit.

use super::ELEMENTS_PER_REPORT;
use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;

/// Largest number of rounds over all triangles.
const MAX_IRONING_ROUNDS: usize = 40;
/// The process stops after this number of rounds without fewer bent triangles.
const MAX_ROUNDS_WITHOUT_GAIN: usize = 8;
/// Vertices within this number of edges from a rim crease stay, because the crease continues there.
const FIXED_CREASE_RINGS: usize = 2;
/// Fraction of the way to the mean of the neighbours that a vertex moves.
const STEP_TO_NEIGHBOUR_MEAN: f64 = 0.5;

impl PatchMesh {
    /// Smooths creases: moves the vertices of triangles whose normal has a cosine below
    /// `min_cosine` with a neighbour's normal. Stops when there are none, or when it does not help.
    /// The vertices below `rim` stay. `creased` marks rim vertices at which creases of the old
    /// surface end.
    ///
    /// O(triangles) per round.
    pub(crate) fn iron_out_creases(
        &mut self,
        rim: usize,
        min_cosine: f64,
        creased: &[bool],
        job: &Job<'_>,
    ) -> Result<()> {
        let sides = || self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let ends = sides().flat_map(|(u, v)| [(u as usize, v), (v as usize, u)]);
        let neighbours = Buckets::new(self.points.len(), 0u32, ends)?;
        let stays = fixed_vertices(&neighbours, self.points.len(), creased)?;
        let (mut fewest, mut gained) = (usize::MAX, 0);
        for round in 0..MAX_IRONING_ROUNDS {
            let round_job = job.sub_job_of_item(round, MAX_IRONING_ROUNDS);
            let mut moves = alloc::filled(false, self.points.len())?;
            let mut count = 0;
            for t in self.bent_triangles(min_cosine, &round_job)? {
                let free = self.triangles[t].iter().filter(|&&v| !stays[v as usize]);
                count += usize::from(free.clone().next().is_some());
                free.for_each(|&v| moves[v as usize] = true);
            }
            if count < fewest {
                (fewest, gained) = (count, round);
            }
            if count == 0 || round - gained >= MAX_ROUNDS_WITHOUT_GAIN {
                break;
            }
            for v in (rim..self.points.len()).filter(|&v| moves[v]) {
                let around = neighbours.get(v);
                let mean = around.iter().map(|&w| self.points[w as usize]).sum::<DVec3>() / around.len() as f64;
                self.points[v] = self.points[v].lerp(mean, STEP_TO_NEIGHBOUR_MEAN);
            }
        }
        Ok(())
    }

    /// Returns the triangles whose normal has a cosine below `min_cosine` with a neighbour's.
    /// Degenerate triangles lack a normal, and are skipped.
    fn bent_triangles(&self, min_cosine: f64, job: &Job<'_>) -> Result<Vec<usize>> {
        let normals = (0..self.triangles.len()).map(|t| {
            let [a, b, c] = self.corner_points(t);
            (b - a).cross(c - a).normalize_or_zero()
        });
        let normals = alloc::collect_cancellable(normals, &job.sub_job(0.0, 0.5), "refining")?;
        let is_bent = |t: usize, s: usize| {
            normals[t].dot(normals[s]) < min_cosine && normals[t] != DVec3::ZERO && normals[s] != DVec3::ZERO
        };
        let job = job.sub_job(0.5, 1.0);
        let mut bent = Vec::new();
        for t in 0..self.triangles.len() {
            job.step_every(ELEMENTS_PER_REPORT, t, self.triangles.len(), "refining")?;
            if (0..3).filter_map(|k| self.triangle_across(t, k)).any(|(s, _)| is_bent(t, s)) {
                alloc::push(&mut bent, t)?;
            }
        }
        Ok(bent)
    }
}

/// Returns the fixed vertices: the rim, and vertices near the ends of its creases.
fn fixed_vertices(neighbours: &Buckets<u32>, count: usize, creased: &[bool]) -> Result<Vec<bool>> {
    let mut stays = alloc::filled(false, count)?;
    stays[..creased.len()].copy_from_slice(creased);
    for _ in 0..FIXED_CREASE_RINGS {
        let before = alloc::copied(&stays)?;
        for (v, stays) in stays.iter_mut().enumerate() {
            *stays = before[v] || neighbours.get(v).iter().any(|&w| before[w as usize]);
        }
    }
    stays[..creased.len()].fill(true);
    Ok(stays)
}
