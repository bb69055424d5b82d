//! Nearest points of many queries.
//!
//! Queries are sorted along the curve of G. M. Morton (1966), so that consecutive ones read the
//! same blocks of the index from the cache, and shared out among threads. Each is answered on its
//! own: the order and the number of threads do not change a bit. O(n log n) for the sort, whose
//! memory is limited to [`SORTED_QUERIES`] keys.

use super::closest::Closest;
use super::nearest_search::NearestSearch;
use super::query::check_query;
use crate::Surface;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Queries that are sorted at once.
const SORTED_QUERIES: usize = 1 << 16;
/// Queries between two chances to cancel.
const QUERIES_PER_STEP: usize = 1 << 13;
/// Queries that one thread takes at once.
const QUERIES_PER_TASK: usize = 1 << 9;

impl Surface<'_> {
    /// [`Surface::closest`] of many queries, in their order: each answer is the same to the bit as
    /// if it were asked for alone, for any order and any number of threads.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a limit that is negative or NaN, [`Error::NotFinite`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn closest_all(&self, queries: &[DVec3], limit: f64, job: &Job<'_>) -> Result<Vec<Option<Closest>>> {
        let mut found = alloc::filled(None, queries.len())?;
        self.closest_into(queries, limit, &mut found, |closest| closest, job)?;
        Ok(found)
    }

    /// [`Surface::closest_all`] with answers in the caller's form.
    pub fn closest_into<T: Send>(
        &self,
        queries: &[DVec3],
        limit: f64,
        out: &mut [T],
        form: impl Fn(Option<Closest>) -> T + Sync,
        job: &Job<'_>,
    ) -> Result<()> {
        Error::require(limit >= 0.0, "limit", limit)?;
        queries.iter().zip(0..).try_for_each(|(&query, index)| check_query(query, index))?;
        let mut order: Vec<(u64, u32)> = alloc::with_capacity(queries.len().min(SORTED_QUERIES))?;
        let mut done = 0;
        for (part, out) in queries.chunks(SORTED_QUERIES).zip(out.chunks_mut(SORTED_QUERIES)) {
            sort_along_curve(part, &mut order);
            for round in order.chunks(QUERIES_PER_STEP) {
                job.step(done as f64 / queries.len() as f64, "nearest points")?;
                done += round.len();
                let found = par::map(job.threads(), round.chunks(QUERIES_PER_TASK), |taken| {
                    let mut search = NearestSearch::default();
                    let each = |&(_, k): &(u64, u32)| form(self.closest_with(part[k as usize], limit, &mut search));
                    taken.iter().map(each).collect::<Vec<_>>()
                })?;
                for (&(_, k), found) in round.iter().zip(found.into_iter().flatten()) {
                    out[k as usize] = found;
                }
            }
        }
        Ok(())
    }
}

/// The queries' numbers in the order of Morton's curve through their box.
fn sort_along_curve(queries: &[DVec3], order: &mut Vec<(u64, u32)>) {
    let Aabb { low, high } = Aabb::from_points(queries);
    // 10 bits a coordinate: 2^30 places for 2^16 queries.
    let scale = 1023.0 / (0.5 * high - 0.5 * low).max_element().max(f64::MIN_POSITIVE);
    order.clear();
    order.extend(queries.iter().enumerate().map(|(k, &query)| {
        let along = ((0.5 * query - 0.5 * low) * scale).to_array();
        let [x, y, z] = along.map(|x| interleave(x as u32));
        (x | y << 1 | z << 2, k as u32)
    }));
    order.sort_unstable();
}

/// The bits of a number of 21 bits, each in the lowest place of three.
fn interleave(number: u32) -> u64 {
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
