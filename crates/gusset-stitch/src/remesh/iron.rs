//! Creases ironed out: where a fine surface folds over itself, its vertices move to the means of
//! their neighbours, until no side bends by more than is asked.

use super::REPORT_INTERVAL;
use super::patch_mesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;

/// Rounds over all triangles.
const MAX_ROUNDS: usize = 40;
/// Rounds after which it is given up if no fewer triangles bend.
const MAX_ROUNDS_WITHOUT_GAIN: usize = 8;
/// Edges from a crease of the rim within which vertices stay: it goes on there.
const CREASE_RINGS: usize = 2;
/// How far a vertex moves towards the mean of its neighbours.
const STEP: f64 = 0.5;

impl PatchMesh {
    /// Moves the vertices from `rim` on of triangles whose normal has a cosine with that of a
    /// neighbour below `least`, until none have or that does not help. `creased`: the vertices of
    /// the rim where a crease of the old surface ends.
    ///
    /// O(triangles) a round.
    pub(crate) fn iron(&mut self, rim: usize, least: f64, creased: &[bool], job: &Job<'_>) -> Result<()> {
        let sides = || self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let ends = sides().flat_map(|(u, v)| [(u as usize, v), (v as usize, u)]);
        let neighbours = Buckets::new(self.points.len(), 0u32, ends)?;
        let stays = staying(&neighbours, self.points.len(), creased)?;
        let (mut fewest, mut gained) = (usize::MAX, 0);
        for round in 0..MAX_ROUNDS {
            let round_job = job.share(round, MAX_ROUNDS);
            let mut moves = alloc::filled(false, self.points.len())?;
            let mut count = 0;
            for t in self.bent(least, &round_job)? {
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
                self.points[v] = self.points[v].lerp(mean, STEP);
            }
        }
        Ok(())
    }

    /// The triangles whose normal has a cosine below `least` with that of a neighbour; one without
    /// area has no direction.
    fn bent(&self, least: f64, job: &Job<'_>) -> Result<Vec<usize>> {
        let normals = (0..self.triangles.len()).map(|t| {
            let [a, b, c] = self.corners(t);
            (b - a).cross(c - a).normalize_or_zero()
        });
        let normals = alloc::collect_cancellable(normals, &job.part(0.0, 0.5), "refining")?;
        let is_bent = |t: usize, s: usize| {
            normals[t].dot(normals[s]) < least && normals[t] != DVec3::ZERO && normals[s] != DVec3::ZERO
        };
        let job = job.part(0.5, 1.0);
        let mut bent = Vec::new();
        for t in 0..self.triangles.len() {
            job.step_every(REPORT_INTERVAL, t, self.triangles.len(), "refining")?;
            if (0..3).filter_map(|k| self.beyond(t, k)).any(|(s, _)| is_bent(t, s)) {
                alloc::push(&mut bent, t)?;
            }
        }
        Ok(bent)
    }
}

/// The vertices that stay: the rim, and those near where a crease ends on it.
fn staying(neighbours: &Buckets<u32>, count: usize, creased: &[bool]) -> Result<Vec<bool>> {
    let mut stays = alloc::filled(false, count)?;
    stays[..creased.len()].copy_from_slice(creased);
    for _ in 0..CREASE_RINGS {
        let before = alloc::copied(&stays)?;
        for (v, stays) in stays.iter_mut().enumerate() {
            *stays = before[v] || neighbours.get(v).iter().any(|&w| before[w as usize]);
        }
    }
    stays[..creased.len()].fill(true);
    Ok(stays)
}
