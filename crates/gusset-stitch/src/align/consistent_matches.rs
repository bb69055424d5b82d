//! Consistent matches: sets of matches that one motion explains.
//!
//! Two matches are consistent if the two samples of one piece are related to each other as their
//! partners on the other piece are: by distance, by the angles of their normals with each other and
//! with the line between them, and by the handedness of these three directions. A rigid motion
//! preserves these five numbers. Correct matches are consistent with all correct matches; a wrong
//! match is consistent with few others.
//!
//! Sources: B. Drost, M. Ulrich, N. Navab and S. Ilic, *Model globally, match locally* (2010), for
//! the numbers of a pair; Z. Chen, K. Sun, F. Yang and W. Tao, *SC2-PCR: a second order spatial
//! compatibility for efficient and robust point cloud registration* (2022), for ranking by common
//! neighbours.

use super::surface_matches::Match;
use super::surface_samples::{OrientedPoints, STAGE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Smallest distance of two consistent matches on both pieces, in spacings.
const MIN_DISTANCE: f64 = 2.0;
/// Largest difference of the distances, in spacings.
const MAX_DISTANCE_DIFFERENCE: f64 = 1.0;
/// Largest difference of the cosines, and of the triple products.
const MAX_COSINE_DIFFERENCE: f64 = 0.25;
/// Largest number of matches of a set.
const MAX_SET_SIZE: usize = 32;
/// Smallest number of matches of a set.
const MIN_SET_SIZE: usize = 4;
/// Number of matches between two progress reports.
const MATCHES_PER_REPORT: usize = 1 << 5;

/// Which matches are consistent with each other, as a symmetric matrix of bits.
struct ConsistencyGraph {
    words_per_row: usize,
    bits: Vec<u64>,
}

/// Matches, and the sets of them that are consistent.
pub(super) struct ConsistentMatches<'a> {
    matches: &'a [Match],
    graph: ConsistencyGraph,
    /// The matches in the order of their support, the next one last.
    seeds: Vec<usize>,
    is_explained: Vec<bool>,
}

/// The oriented points of a match.
struct MatchedPoints {
    points: [DVec3; 2],
    normals: [DVec3; 2],
}

impl<'a> ConsistentMatches<'a> {
    /// Finds the matches that are consistent. O(matches^2), and O(matches) for each consistent pair.
    pub(super) fn new(
        samples: [&OrientedPoints; 2],
        matches: &'a [Match],
        spacing: f64,
        job: &Job<'_>,
    ) -> Result<ConsistentMatches<'a>> {
        let graph = ConsistencyGraph::new(samples, matches, spacing, &job.sub_job(0.0, 0.7))?;
        let support = graph.measure_support(matches.len(), &job.sub_job(0.7, 1.0))?;
        let mut seeds = alloc::gather((0..matches.len()).filter(|&i| support[i] > 0))?;
        seeds.sort_unstable_by_key(|&i| (support[i], std::cmp::Reverse(i)));
        Ok(ConsistentMatches { matches, graph, seeds, is_explained: alloc::filled(false, matches.len())? })
    }

    /// Returns a set of consistent matches, at most 32: the match with the most support among those
    /// that nothing explains, and the matches that have the most in common with it. `None` if no
    /// set is left.
    pub(super) fn next_set(&mut self) -> Result<Option<Vec<Match>>> {
        while let Some(seed) = self.seeds.pop() {
            if self.is_explained[seed] {
                continue;
            }
            self.is_explained[seed] = true;
            let graph = &self.graph;
            let open = graph.neighbours(seed).filter(|&k| !self.is_explained[k]);
            let mut members = alloc::gather(open.map(|k| (graph.count_common(seed, k), k)))?;
            members.sort_unstable_by_key(|&(common, k)| (std::cmp::Reverse(common), k));
            let most = members.first().map_or(0, |&(common, _)| common);
            members.retain(|&(common, _)| 2 * common >= most);
            members.truncate(MAX_SET_SIZE - 1);
            if members.len() + 1 >= MIN_SET_SIZE {
                let set = std::iter::once(seed).chain(members.into_iter().map(|(_, k)| k));
                return Ok(Some(alloc::gather(set.map(|k| self.matches[k]))?));
            }
        }
        Ok(None)
    }

    /// Marks the matches that a motion explains. No later set contains them.
    pub(super) fn mark_explained(&mut self, is_explained: impl Fn(Match) -> bool) {
        for (pair, mark) in self.matches.iter().zip(&mut self.is_explained) {
            *mark |= is_explained(*pair);
        }
    }
}

impl ConsistencyGraph {
    fn new(samples: [&OrientedPoints; 2], matches: &[Match], spacing: f64, job: &Job<'_>) -> Result<Self> {
        let words_per_row = matches.len().div_ceil(64);
        let mut bits = alloc::zeroed::<u64>(matches.len() * words_per_row)?;
        let matched = alloc::collect(matches.iter().map(|pair| MatchedPoints {
            points: std::array::from_fn(|k| samples[k].points[pair[k] as usize]),
            normals: std::array::from_fn(|k| samples[k].normals[pair[k] as usize]),
        }))?;
        for i in 0..matched.len() {
            job.step_every(MATCHES_PER_REPORT, i, matched.len(), STAGE)?;
            for k in 0..i {
                if matched[i].is_consistent_with(&matched[k], spacing) {
                    bits[i * words_per_row + k / 64] |= 1 << (k % 64);
                    bits[k * words_per_row + i / 64] |= 1 << (i % 64);
                }
            }
        }
        Ok(ConsistencyGraph { words_per_row, bits })
    }

    fn row(&self, i: usize) -> &[u64] {
        &self.bits[i * self.words_per_row..(i + 1) * self.words_per_row]
    }

    /// Returns the matches that are consistent with a match, ascending.
    fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> {
        self.row(i).iter().enumerate().flat_map(|(at, &word)| {
            let mut left = word;
            std::iter::from_fn(move || {
                let bit = (left != 0).then(|| left.trailing_zeros())?;
                left &= left - 1;
                Some(64 * at + bit as usize)
            })
        })
    }

    /// Returns the number of matches that are consistent with both matches.
    fn count_common(&self, i: usize, k: usize) -> u32 {
        self.row(i).iter().zip(self.row(k)).map(|(a, b)| (a & b).count_ones()).sum()
    }

    /// Returns for each match the number of triangles of the graph at it, twice.
    fn measure_support(&self, count: usize, job: &Job<'_>) -> Result<Vec<u64>> {
        let mut support = alloc::filled(0, count)?;
        for (i, support) in support.iter_mut().enumerate() {
            job.step_every(MATCHES_PER_REPORT, i, count, STAGE)?;
            *support = self.neighbours(i).map(|k| u64::from(self.count_common(i, k))).sum();
        }
        Ok(support)
    }
}

impl MatchedPoints {
    fn is_consistent_with(&self, other: &MatchedPoints, spacing: f64) -> bool {
        let apart = [0, 1].map(|k| other.points[k] - self.points[k]);
        let [d, e] = apart.map(DVec3::length);
        if d.min(e) < MIN_DISTANCE * spacing || (d - e).abs() > MAX_DISTANCE_DIFFERENCE * spacing {
            return false;
        }
        let numbers = |k: usize, distance: f64| {
            let (along, m, n) = (apart[k] / distance, self.normals[k], other.normals[k]);
            [m.dot(n), along.dot(m), along.dot(n), m.cross(n).dot(along)]
        };
        let (own, theirs) = (numbers(0, d), numbers(1, e));
        own.into_iter().zip(theirs).all(|(a, b)| (a - b).abs() <= MAX_COSINE_DIFFERENCE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::align::pose::Pose;
    use crate::align::surface_pose::fit_matches;

    fn vector(random: &mut fastrand::Rng) -> DVec3 {
        DVec3::new(random.f64(), random.f64(), random.f64()) * 2.0 - 1.0
    }

    /// 30 correct matches among 600: the first set contains correct matches only, and gives the
    /// motion back. The next set shares none with it.
    #[test]
    fn a_set_contains_the_matches_of_one_motion() {
        for seed in 0..20 {
            let mut random = fastrand::Rng::with_seed(seed);
            let truth = Pose::rotation_about(vector(&mut random), 3.0 * vector(&mut random), vector(&mut random));
            let [mut fixed, mut moved] = [OrientedPoints::default(), OrientedPoints::default()];
            for _ in 0..100 {
                let (point, normal) = (10.0 * vector(&mut random), vector(&mut random).normalize());
                moved.points.push(point);
                moved.normals.push(normal);
                fixed.points.push(truth.transform_point(point));
                fixed.normals.push(truth.rotate_direction(normal));
            }
            let correct = (0..30).map(|k| [k, k]);
            let wrong = (0..570).map(|_| [random.u32(0..50), random.u32(50..100)]);
            let matches: Vec<Match> = correct.chain(wrong).collect();
            let job = Job::default();
            let mut sets = ConsistentMatches::new([&fixed, &moved], &matches, 0.5, &job).unwrap();
            let set = sets.next_set().unwrap().unwrap();
            assert!(set.len() > 15 && set.iter().all(|[i, k]| i == k), "{seed}: {set:?}");
            let found = fit_matches([&fixed, &moved], &set, 1.0);
            assert!(found.rotation.abs_diff_eq(truth.rotation, 1e-9), "{seed}");
            assert!(found.translation.distance(truth.translation) < 1e-8, "{seed}");
            sets.mark_explained(|[i, k]| i == k);
            let rest = sets.next_set().unwrap().unwrap_or_default();
            assert!(rest.iter().all(|[i, k]| i != k), "{seed}: {rest:?}");
        }
    }
}
