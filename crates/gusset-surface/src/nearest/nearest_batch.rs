//! Nearest points of many queries.
//!
//! Queries are sorted along the curve of G. M. Morton (1966) and distributed among threads.
//! Consecutive queries then read the same blocks of the index from the cache. Each query is
//! answered separately, so results do not depend on the order or the number of threads. O(n log n)
//! for the sort, whose memory is limited to [`QUERIES_PER_SORT`] keys.

use super::closest::Closest;
use super::nearest_search::NearestPointSearch;
use super::query_checks::check_query_point;
use crate::Surface;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Number of queries sorted at once.
const QUERIES_PER_SORT: usize = 1 << 16;
/// Number of queries between two progress reports.
const QUERIES_PER_REPORT: usize = 1 << 13;
/// Number of queries that a thread answers in one task.
const QUERIES_PER_TASK: usize = 1 << 9;

impl Surface<'_> {
    /// Answers [`Surface::closest`] for many queries, in their order. Each answer has the same bits
    /// as that query alone, for any order and number of threads.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the limit is negative or NaN, [`Error::NotFinite`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn closest_all(&self, queries: &[DVec3], limit: f64, job: &Job<'_>) -> Result<Vec<Option<Closest>>> {
        let mut closest_points = alloc::filled(None, queries.len())?;
        self.closest_into(queries, limit, &mut closest_points, |closest| closest, job)?;
        Ok(closest_points)
    }

    /// [`Surface::closest_all`] with answers converted by `form`.
    pub fn closest_into<T: Send>(
        &self,
        queries: &[DVec3],
        limit: f64,
        out: &mut [T],
        form: impl Fn(Option<Closest>) -> T + Sync,
        job: &Job<'_>,
    ) -> Result<()> {
        Error::require(limit >= 0.0, "limit", limit, "at least 0")?;
        queries.iter().zip(0..).try_for_each(|(&query, index)| check_query_point(query, index))?;
        let mut order: Vec<(u64, u32)> = alloc::with_capacity(queries.len().min(QUERIES_PER_SORT))?;
        let mut answered = 0;
        for (part, out) in queries.chunks(QUERIES_PER_SORT).zip(out.chunks_mut(QUERIES_PER_SORT)) {
            sort_along_morton_curve(part, &mut order);
            for round in order.chunks(QUERIES_PER_REPORT) {
                job.step(answered as f64 / queries.len() as f64, "nearest points")?;
                answered += round.len();
                let answers = par::map(job.requested_threads(), round.chunks(QUERIES_PER_TASK), |taken| {
                    let mut search = NearestPointSearch::default();
                    let each =
                        |&(_, k): &(u64, u32)| form(self.closest_with_workspace(part[k as usize], limit, &mut search));
                    taken.iter().map(each).collect::<Vec<_>>()
                })?;
                for (&(_, k), answer) in round.iter().zip(answers.into_iter().flatten()) {
                    out[k as usize] = answer;
                }
            }
        }
        Ok(())
    }
}

/// Sorts the indices of the queries along Morton's curve through their bounding box.
fn sort_along_morton_curve(queries: &[DVec3], order: &mut Vec<(u64, u32)>) {
    let Aabb { low, high } = Aabb::from_points(queries);
    // 10 bits for each coordinate: 2^30 places for 2^16 queries.
    let scale = 1023.0 / (0.5 * high - 0.5 * low).max_element().max(f64::MIN_POSITIVE);
    order.clear();
    order.extend(queries.iter().enumerate().map(|(k, &query)| {
        let along = ((0.5 * query - 0.5 * low) * scale).to_array();
        let [x, y, z] = along.map(|x| spread_to_every_third_bit(x as u32));
        (x | y << 1 | z << 2, k as u32)
    }));
    order.sort_unstable();
}

/// Spreads the lowest 21 bits of a number: bit k becomes bit 3 k, and all others are 0.
fn spread_to_every_third_bit(number: u32) -> u64 {
    let mut bits = u64::from(number) & 0x1f_ffff;
    for (shift, mask) in [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ] {
        bits = (bits | bits << shift) & mask;
    }
    bits
}
