//! One-to-one pairing: a matching of greatest weight.
//!
//! Ends that are connected by possible pairs form a group. For groups of up to
//! [`MAX_EXACT_GROUP_ENDS`] ends the optimum is computed by dynamic programming over the sets of
//! ends (2^n sets). In larger groups the best pair is chosen greedily. Then two pairs, or a pair
//! and a free end, exchange partners as long as that improves the sum.

use super::candidates::STAGE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::{self, Buckets};

/// Largest number of ends in a group that is solved exactly.
const MAX_EXACT_GROUP_ENDS: usize = 16;
/// Number of sets of ends between two progress reports.
const SETS_PER_REPORT: usize = 1 << 18;

/// A possible pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct PossiblePair {
    /// The two ends, the smaller first.
    pub(super) ends: [u32; 2],
    /// The weight, above 0.
    pub(super) gain: f64,
}

/// Returns the indices of the chosen pairs, in ascending order. No end belongs to two pairs.
pub(super) fn choose_best_pairs(matches: &[PossiblePair], job: &Job<'_>) -> Result<Vec<usize>> {
    let count = matches.iter().map(|pair| pair.ends[1] as usize + 1).max().unwrap_or(0);
    let mut sets = DisjointSets::new(count)?;
    matches.iter().for_each(|pair| {
        sets.union(pair.ends[0], pair.ends[1]);
    });
    let mut numbered = alloc::collect((0..matches.len()).map(|number| (sets.find(matches[number].ends[0]), number)))?;
    numbered.sort_unstable();
    let mut chosen = alloc::with_capacity(matches.len())?;
    let mut sets_seen = 0;
    for group in numbered.chunk_by(|x, y| x.0 == y.0) {
        let mut ends = alloc::gather(group.iter().flat_map(|&(_, number)| matches[number].ends))?;
        ends.sort_unstable();
        ends.dedup();
        let place = |end: u32| ends.partition_point(|&other| other < end) as u32;
        let local =
            alloc::collect(group.iter().map(|&(_, number)| PossiblePair {
                ends: matches[number].ends.map(place),
                gain: matches[number].gain,
            }))?;
        let of_group = if ends.len() <= MAX_EXACT_GROUP_ENDS {
            sets_seen += 1usize << ends.len();
            if sets_seen >= SETS_PER_REPORT {
                job.step(0.0, STAGE)?;
                sets_seen = 0;
            }
            match_exactly(&local, ends.len())?
        } else {
            match_greedily(&local, ends.len(), job)?
        };
        chosen.extend(of_group.into_iter().map(|k| group[k].1));
    }
    chosen.sort_unstable();
    Ok(chosen)
}

/// Computes the optimum for each set of free ends, starting with the pairs of its smallest end.
fn match_exactly(matches: &[PossiblePair], ends: usize) -> Result<Vec<usize>> {
    let sets = 1usize << ends;
    // The gain, and 1 plus the index of the pair at the smallest end (0 for none).
    let mut best = alloc::filled((0.0f64, 0usize), sets)?;
    let of_end = Buckets::new(ends, 0usize, matches.iter().zip(0..).map(|(pair, k)| (pair.ends[0] as usize, k)))?;
    for set in 1..sets {
        let smallest = set.trailing_zeros() as usize;
        best[set] = (best[set & (set - 1)].0, 0);
        for &k in of_end.get(smallest) {
            let pair = &matches[k];
            let both = 1 << pair.ends[0] | 1 << pair.ends[1];
            if set & both == both && best[set & !both].0 + pair.gain > best[set].0 {
                best[set] = (best[set & !both].0 + pair.gain, k + 1);
            }
        }
    }
    let (mut set, mut chosen) = (sets - 1, Vec::new());
    while set != 0 {
        match best[set].1 {
            0 => set &= set - 1,
            taken => {
                alloc::push(&mut chosen, taken - 1)?;
                matches[taken - 1].ends.iter().for_each(|&end| set &= !(1 << end));
            }
        }
    }
    Ok(chosen)
}

/// Chooses the best pairs greedily, then exchanges partners.
fn match_greedily(matches: &[PossiblePair], ends: usize, job: &Job<'_>) -> Result<Vec<usize>> {
    const UNMATCHED: usize = usize::MAX;
    let mut order = alloc::collect(0..matches.len())?;
    sort::sort_stable(&mut order, &|&x, &y| matches[y].gain.total_cmp(&matches[x].gain).then(x.cmp(&y)));
    let mut partner = alloc::filled(UNMATCHED, ends)?;
    for &k in &order {
        if matches[k].ends.iter().all(|&end| partner[end as usize] == UNMATCHED) {
            matches[k].ends.iter().for_each(|&end| partner[end as usize] = k);
        }
    }
    let gain = |k: usize| if k == UNMATCHED { 0.0 } else { matches[k].gain };
    let other = |k: usize, end: u32| matches[k].ends[usize::from(matches[k].ends[0] == end)];
    let mut sorted = alloc::collect(0..matches.len())?;
    sort::sort_stable(&mut sorted, &|&i, &k| matches[i].ends.cmp(&matches[k].ends));
    let between = |p: u32, q: u32| {
        let ends = [p.min(q), p.max(q)];
        sorted.binary_search_by_key(&ends, |&k| matches[k].ends).map_or(UNMATCHED, |at| sorted[at])
    };
    // Each exchange gains, so the process terminates; the number of rounds bounds the time.
    for _ in 0..ends {
        let mut changed = false;
        job.step(0.0, STAGE)?;
        for (n, &k) in order.iter().enumerate() {
            job.step_within_list(n, STAGE)?;
            let [p, q] = matches[k].ends;
            let (old_p, old_q) = (partner[p as usize], partner[q as usize]);
            if old_p == k {
                continue;
            }
            // The two former partners may form a pair.
            let left = match (old_p, old_q) {
                (UNMATCHED, _) | (_, UNMATCHED) => UNMATCHED,
                (x, y) => between(other(x, p), other(y, q)),
            };
            if gain(k) + gain(left) > (gain(old_p) + gain(old_q)) * (1.0 + f64::EPSILON) {
                for old in [old_p, old_q].into_iter().filter(|&old| old != UNMATCHED) {
                    matches[old].ends.iter().for_each(|&end| partner[end as usize] = UNMATCHED);
                }
                for new in [k, left].into_iter().filter(|&new| new != UNMATCHED) {
                    matches[new].ends.iter().for_each(|&end| partner[end as usize] = new);
                }
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    partner.retain(|&k| k != UNMATCHED);
    partner.sort_unstable();
    partner.dedup();
    Ok(partner)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the greatest gain by enumeration.
    fn greatest_gain_by_enumeration(matches: &[PossiblePair], used: u32) -> f64 {
        let Some((first, rest)) = matches.split_first() else {
            return 0.0;
        };
        let both = 1 << first.ends[0] | 1 << first.ends[1];
        let without = greatest_gain_by_enumeration(rest, used);
        if used & both != 0 {
            without
        } else {
            without.max(first.gain + greatest_gain_by_enumeration(rest, used | both))
        }
    }

    fn random_pairs(random: &mut fastrand::Rng, ends: u32, count: usize) -> Vec<PossiblePair> {
        let mut matches: Vec<PossiblePair> = (0..count)
            .map(|_| {
                let (p, q) = (random.u32(0..ends), random.u32(0..ends - 1));
                let q = if q >= p { q + 1 } else { q };
                PossiblePair { ends: [p.min(q), p.max(q)], gain: 0.1 + random.f64() }
            })
            .collect();
        matches.sort_by_key(|pair| pair.ends);
        matches.dedup_by_key(|pair| pair.ends);
        matches
    }

    fn total_gain(matches: &[PossiblePair], chosen: &[usize]) -> f64 {
        let mut ends: Vec<u32> = chosen.iter().flat_map(|&k| matches[k].ends).collect();
        ends.sort_unstable();
        assert!(ends.windows(2).all(|w| w[0] != w[1]), "an end is in two pairs");
        chosen.iter().map(|&k| matches[k].gain).sum()
    }

    #[test]
    fn the_best_of_all_choices_is_found() {
        let mut rng = fastrand::Rng::with_seed(1);
        for _ in 0..300 {
            let (ends, count) = (rng.u32(2..9), rng.usize(1..14));
            let matches = random_pairs(&mut rng, ends, count);
            let best = greatest_gain_by_enumeration(&matches, 0);
            assert!(
                (total_gain(&matches, &choose_best_pairs(&matches, &Job::default()).unwrap()) - best).abs() < 1e-12
            );
            // The greedy choice gains at least half of the optimum.
            let quick = total_gain(&matches, &match_greedily(&matches, ends as usize, &Job::default()).unwrap());
            assert!(quick <= best + 1e-12 && quick >= 0.5 * best, "{quick} {best}");
        }
    }

    #[test]
    fn a_near_wrong_pair_gives_way_to_two_right_ones() {
        let pair = |p, q, gain| PossiblePair { ends: [p, q], gain };
        // Ends 1 and 2 are nearest to each other, but then 0 and 3 stay free.
        let matches = [pair(0, 1, 0.8), pair(1, 2, 0.9), pair(2, 3, 0.8)];
        assert_eq!(choose_best_pairs(&matches, &Job::default()).unwrap(), [0, 2]);
        assert_eq!(match_greedily(&matches, 4, &Job::default()).unwrap(), [1]);
        assert!(choose_best_pairs(&[], &Job::default()).unwrap().is_empty());
    }

    #[test]
    fn groups_too_large_for_enumeration_are_matched_well() {
        // A ring of 40 ends; every second pair is slightly better.
        let mut matches: Vec<PossiblePair> =
            (0..39).map(|k| PossiblePair { ends: [k, k + 1], gain: 1.0 + f64::from(k % 2) * 0.01 }).collect();
        matches.push(PossiblePair { ends: [0, 39], gain: 1.01 });
        let chosen = choose_best_pairs(&matches, &Job::default()).unwrap();
        assert!((total_gain(&matches, &chosen) - 20.2).abs() < 1e-9);
    }
}
