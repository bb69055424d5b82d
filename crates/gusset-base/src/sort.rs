//! Sorting and selection: cancellable and in place, stable without allocation, and by counting.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use std::cmp::Ordering;
use std::ops::Range;

/// Elements sorted between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 16;
/// The largest number of elements in which a selection runs without a progress report.
const MAX_UNREPORTED_ELEMENTS: usize = 1 << 19;
/// The sample size for the pivot of a larger selection. Odd, so that the sample has a median.
const PIVOT_SAMPLE_COUNT: usize = 63;
const MAX_PIVOT_DIVISIONS: usize = 16;

/// Sorts in place, unstably, on the calling thread. `compare` must be a total order without ties
/// for the result to be deterministic.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled); the order of the elements is then unspecified.
pub fn sort<T>(
    items: &mut [T],
    compare: impl Fn(&T, &T) -> Ordering,
    job: &Job<'_>,
    stage: &'static str,
) -> Result<()> {
    let whole = items.len().max(1) as f64;
    // Returns early if the elements are in order; an unordered list fails this test soon.
    let in_order = |k: usize| k == 0 || compare(&items[k - 1], &items[k]).is_le();
    let (mut ordered, looking) = (0, job.sub_job(0.0, 0.0));
    while ordered < items.len() && in_order(ordered) {
        looking.step_every(ELEMENTS_PER_REPORT, ordered, items.len(), stage)?;
        ordered += 1;
    }
    if ordered == items.len() {
        return Ok(());
    }
    // Parts still to be sorted, the first on top, each with the number of divisions it may still
    // take. The limit is twice the number that halving takes. A part that reaches it is sorted at
    // once, which bounds the total to O(n log n).
    let divisions = 2 * (items.len().ilog2() + 1);
    let mut parts = vec![(items, divisions)];
    let mut done = 0;
    while let Some((part, divisions)) = parts.pop() {
        job.step(done as f64 / whole, stage)?;
        if part.len() <= ELEMENTS_PER_REPORT || divisions == 0 {
            part.sort_unstable_by(&compare);
            done += part.len();
        } else {
            let equal = partition_near_median(part, &compare, &mut || job.step(done as f64 / whole, stage))?;
            done += equal.len();
            let (first, rest) = part.split_at_mut(equal.start);
            parts.extend([&mut rest[equal.len()..], first].map(|part| (part, divisions - 1)));
        }
    }
    Ok(())
}

/// Partitions so that the element of rank `middle` is in its place, with smaller elements before
/// it. Calls `report` regularly. O(n).
fn select_with_reports<T>(
    items: &mut [T],
    middle: usize,
    compare: &impl Fn(&T, &T) -> Ordering,
    report: &mut impl FnMut() -> Result<()>,
) -> Result<()> {
    let mut left = 0..items.len();
    for _ in 0..MAX_PIVOT_DIVISIONS {
        if left.len() <= MAX_UNREPORTED_ELEMENTS {
            break;
        }
        let equal = partition_near_median(&mut items[left.clone()], compare, report)?;
        let (start, end) = (left.start + equal.start, left.start + equal.end);
        if middle < start {
            left.end = start;
        } else if middle < end {
            return Ok(());
        } else {
            left.start = end;
        }
    }
    items[left.clone()].select_nth_unstable_by(middle - left.start, compare);
    report()
}

/// Partitions about a pivot near the median. Returns the range of elements that are known to equal
/// the pivot; smaller ones lie before it and the rest after. O(n).
fn partition_near_median<T>(
    items: &mut [T],
    compare: &impl Fn(&T, &T) -> Ordering,
    report: &mut impl FnMut() -> Result<()>,
) -> Result<Range<usize>> {
    let mut samples = scattered_positions(items.len());
    sort_stable(&mut samples, &|&a, &b| compare(&items[a], &items[b]));
    items.swap(0, samples[PIVOT_SAMPLE_COUNT / 2]);
    let less = partition_by_first(items, Ordering::Equal, compare, report)?;
    items.swap(0, less);
    // Also groups the elements equal to the pivot, if there may be many.
    let few = less < items.len() / 8;
    let equal = if few { partition_by_first(&mut items[less..], Ordering::Greater, compare, report)? } else { 0 };
    Ok(less..less + 1 + equal)
}

/// Draws one random position from each of `PIVOT_SAMPLE_COUNT` equal ranges. Random positions avoid
/// resonance with the periodic lists that meshes produce.
fn scattered_positions(count: usize) -> [usize; PIVOT_SAMPLE_COUNT] {
    let range = count / PIVOT_SAMPLE_COUNT;
    let mut number = count as u64;
    std::array::from_fn(|k| {
        // D. Knuth's linear congruential generator. Its high bits are the better ones.
        number = number.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        k * range + (number >> 33) as usize % range
    })
}

/// Moves the elements whose comparison with the first element is less than `bound` next to it, and
/// returns how many there are.
fn partition_by_first<T>(
    items: &mut [T],
    bound: Ordering,
    compare: &impl Fn(&T, &T) -> Ordering,
    report: &mut impl FnMut() -> Result<()>,
) -> Result<usize> {
    let mut before = 0;
    if let Some((pivot, rest)) = items.split_first_mut() {
        for k in 0..rest.len() {
            if k % ELEMENTS_PER_REPORT == 0 {
                report()?;
            }
            // Branch-free: an element between the two ends is not smaller either.
            let is_before = compare(&rest[k], pivot) < bound;
            rest.swap(before, k);
            before += usize::from(is_before);
        }
    }
    Ok(before)
}

/// Runs of this length are sorted by insertion before they are merged.
const INSERTION_SORTED_RUN: usize = 16;

/// Sorts in place, stably, without allocating (the standard library's stable sort allocates
/// infallibly). `compare` is a trait object, so that the code is compiled once for each element
/// type. Intended for lists that are short or nearly sorted. O(n log^2 n).
pub fn sort_stable<T>(items: &mut [T], compare: &dyn Fn(&T, &T) -> Ordering) {
    for run in items.chunks_mut(INSERTION_SORTED_RUN) {
        for k in 1..run.len() {
            let place = run[..k].partition_point(|item| compare(item, &run[k]).is_le());
            run[place..=k].rotate_right(1);
        }
    }
    let mut width = INSERTION_SORTED_RUN;
    while width < items.len() {
        for pair in items.chunks_mut(2 * width).filter(|pair| pair.len() > width) {
            merge_sorted_runs(pair, width, compare);
        }
        width *= 2;
    }
}

/// Merges two sorted non-empty runs that meet at `middle`. Halves the longer run, rotates the
/// matching part of the other run to the half's far side, and merges both sides recursively.
fn merge_sorted_runs<T>(items: &mut [T], middle: usize, compare: &dyn Fn(&T, &T) -> Ordering) {
    if compare(&items[middle - 1], &items[middle]).is_le() {
        return;
    }
    // Two elements need one comparison, even if `compare` is not a total order.
    if let [first, last] = items {
        return std::mem::swap(first, last);
    }
    let (first, last) = items.split_at(middle);
    let (low, high) = if first.len() >= last.len() {
        let low = first.len() / 2;
        (low, middle + last.partition_point(|item| compare(item, &first[low]).is_lt()))
    } else {
        let high = last.len() / 2;
        (first.partition_point(|item| compare(item, &last[high]).is_le()), middle + high)
    };
    items[low..high].rotate_left(middle - low);
    let turned = low + high - middle;
    let (before, after) = items.split_at_mut(turned);
    if low > 0 && turned > low {
        merge_sorted_runs(before, low, compare);
    }
    if middle > low && high < before.len() + after.len() {
        merge_sorted_runs(after, middle - low, compare);
    }
}

/// Partitions indices so that the index of rank `middle` by key is in its place, with smaller ones
/// before it. Breaks ties by the smaller index. O(n).
pub fn select_by_rank(numbers: &mut [u32], middle: usize, key: impl Fn(u32) -> f64) {
    numbers.select_nth_unstable_by(middle, |&i, &j| key(i).total_cmp(&key(j)).then(i.cmp(&j)));
}

/// [`select_by_rank`] for long lists: calls `report` regularly.
pub fn select_by_rank_reported(
    numbers: &mut [u32],
    middle: usize,
    key: impl Fn(u32) -> f64,
    report: &mut impl FnMut() -> Result<()>,
) -> Result<()> {
    select_with_reports(numbers, middle, &|&i, &j| key(i).total_cmp(&key(j)).then(i.cmp(&j)), report)
}

/// Sorts and removes duplicates.
pub fn sort_distinct<T: Ord>(items: &mut Vec<T>) {
    items.sort_unstable();
    items.dedup();
}

/// Items grouped into numbered buckets by a counting sort. Takes 4 bytes a bucket besides the
/// items.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Buckets<T> {
    /// Bucket k has the items from `start[k]` to `start[k + 1]`.
    bucket_starts: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Buckets<T> {
    /// Puts each item, of fewer than 2^32, into the bucket paired with it. Items keep their order
    /// within a bucket. `blank` initialises the memory. O(items + count).
    pub fn new(count: usize, blank: T, given: impl Iterator<Item = (usize, T)> + Clone) -> Result<Self> {
        Buckets::new_cancellable(count, blank, given, &Job::default(), "")
    }

    /// [`new`](Self::new) for many items: the host can cancel.
    pub fn new_cancellable(
        count: usize,
        blank: T,
        given: impl Iterator<Item = (usize, T)> + Clone,
        job: &Job<'_>,
        stage: &'static str,
    ) -> Result<Self> {
        let job = job.sub_job(0.0, 0.0);
        // Counts two buckets ahead, so that the running sums become the starts of the buckets while
        // they are filled.
        let mut start = alloc::filled(0u32, count + 2)?;
        for (k, (bucket, _)) in given.clone().enumerate() {
            job.step_within_list(k, stage)?;
            start[bucket + 2] += 1;
        }
        for bucket in 2..count + 2 {
            start[bucket] += start[bucket - 1];
        }
        let total = start[count + 1] as usize;
        let mut items = alloc::with_capacity(total)?;
        job.work_in_ranges(stage, total, |range| {
            items.resize(range.end, blank);
            Ok(())
        })?;
        for (k, (bucket, item)) in given.enumerate() {
            job.step_within_list(k, stage)?;
            let place = &mut start[bucket + 1];
            items[*place as usize] = item;
            *place += 1;
        }
        start.truncate(count + 1);
        Ok(Buckets { bucket_starts: start, items })
    }

    /// Returns the range of a bucket in [`items`](Self::items).
    #[inline]
    pub fn range(&self, bucket: usize) -> Range<usize> {
        self.bucket_starts[bucket] as usize..self.bucket_starts[bucket + 1] as usize
    }

    /// Returns the items of a bucket.
    #[inline]
    pub fn get(&self, bucket: usize) -> &[T] {
        &self.items[self.range(bucket)]
    }

    /// Returns the items of a bucket, mutable.
    #[inline]
    pub fn get_mut(&mut self, bucket: usize) -> &mut [T] {
        let range = self.range(bucket);
        &mut self.items[range]
    }

    /// Returns all items, bucket by bucket.
    pub fn items(&self) -> &[T] {
        &self.items
    }

    /// Returns the end offsets of the buckets (after a leading 0) and the items.
    pub fn into_parts(self) -> (Vec<u32>, Vec<T>) {
        (self.bucket_starts, self.items)
    }
}

/// Sorts items whose order compares a bucket number below `count` first. Long lists are sorted by
/// counting. O(items + count) if each bucket has few items.
pub fn sort_by_bucket<T: Ord + Copy>(items: &mut Vec<T>, count: usize, bucket: impl Fn(&T) -> u32) -> Result<()> {
    if items.len() < count / 8 || items.len() < 256 || items.len() > u32::MAX as usize {
        items.sort_unstable();
        return Ok(());
    }
    let mut sorted = Buckets::new(count, items[0], items.iter().map(|item| (bucket(item) as usize, *item)))?;
    (0..count).for_each(|k| sorted.get_mut(k).sort_unstable());
    *items = sorted.items;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Progress;
    use proptest::prelude::*;
    use std::cell::Cell;
    use std::ops::ControlFlow;

    /// Random numbers, with some repetitions.
    fn scrambled_numbers(count: u64) -> Vec<u64> {
        (0..count).map(|k| (k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 20) % (count / 2 + 1)).collect()
    }

    #[test]
    fn sort_and_select_agree_with_the_standard_library() {
        let large = MAX_UNREPORTED_ELEMENTS as u64 + 17;
        // Also with so few distinct keys that every division is uneven.
        let few = [1, 2, 3].map(|keys| (large, keys));
        for (count, keys) in [0, 1, 2, 1000, large].map(|count| (count, u64::MAX)).into_iter().chain(few) {
            let mut ours: Vec<u64> = scrambled_numbers(count).into_iter().map(|number| number % keys).collect();
            let mut plain = ours.clone();
            sort(&mut ours, u64::cmp, &Job::default(), "sorting").unwrap();
            plain.sort_unstable();
            assert_eq!(ours, plain);
        }
    }

    proptest! {
        #[test]
        fn stable_agrees_with_the_standard_library(keys in prop::collection::vec(0u8..40, 0..300)) {
            let mut ours: Vec<(u8, usize)> = keys.into_iter().zip(0..).collect();
            let mut plain = ours.clone();
            sort_stable(&mut ours, &|a, b| a.0.cmp(&b.0));
            plain.sort_by_key(|&(key, _)| key);
            prop_assert_eq!(ours, plain);
        }

        #[test]
        fn buckets_agree_with_a_stable_sort(keys in prop::collection::vec(0usize..7, 0..50)) {
            let mut given: Vec<(usize, usize)> = keys.into_iter().zip(0..).collect();
            let mut buckets = Buckets::new(7, 0, given.iter().copied()).unwrap();
            given.sort_by_key(|&(key, _)| key);
            prop_assert!(buckets.items().iter().eq(given.iter().map(|(_, item)| item)));
            for bucket in 0..7 {
                let expected: Vec<usize> = given.iter().filter(|&&(key, _)| key == bucket).map(|&(_, item)| item).collect();
                prop_assert_eq!(buckets.get(bucket), &expected[..]);
                prop_assert_eq!(buckets.get_mut(bucket), &expected[..]);
            }
            let (start, items) = buckets.into_parts();
            prop_assert_eq!((start.len(), start[7] as usize), (8, items.len()));
        }

        #[test]
        fn select_agrees_with_a_sort(keys in prop::collection::vec(0u8..9, 1..60)) {
            let key = |i: u32| f64::from(keys[i as usize]);
            let mut sorted: Vec<u32> = (0..keys.len() as u32).collect();
            let mut selected = sorted.clone();
            sorted.sort_by_key(|&i| keys[i as usize]);
            let middle = keys.len() / 2;
            select_by_rank(&mut selected, middle, key);
            prop_assert_eq!(selected[middle], sorted[middle]);
            selected[..middle].sort_by_key(|&i| (keys[i as usize], i));
            prop_assert_eq!(&selected[..middle], &sorted[..middle]);
        }
    }

    /// Keys of meshes whose vertices are numbered ring by ring, or row by row in alternating
    /// directions.
    #[test]
    fn periodic_keys_are_divided_evenly() {
        for (period, rings) in [(126, true), (252, true), (63, false), (189, false), (64, true)] {
            let count = 1 << 18;
            let keys: Vec<u64> = (0..count)
                .map(|k| {
                    let along = (k * period % count) as f64 / count as f64;
                    let x = if rings { (std::f64::consts::TAU * along).cos() } else { (along - 0.5).abs() };
                    ((x + 1.0) * 1e9) as u64 * count + k
                })
                .collect();
            let (mut order, compared): (Vec<u64>, _) = ((0..count).collect(), Cell::new(0u64));
            let by_key = |&i: &u64, &j: &u64| {
                compared.set(compared.get() + 1);
                keys[i as usize].cmp(&keys[j as usize])
            };
            sort(&mut order, by_key, &Job::default(), "sorting").unwrap();
            assert!(order.is_sorted_by_key(|&k| keys[k as usize]));
            let each = compared.get() as f64 / count as f64;
            assert!(each < 1.4 * (count as f64).log2(), "{period} {rings}: {each}");
        }
    }

    #[test]
    fn select_reported_agrees_with_a_sort() {
        let count = MAX_UNREPORTED_ELEMENTS as u64 + 17;
        let shuffled = |keys: u64| scrambled_numbers(count).into_iter().map(|number| number % keys).collect();
        let half = count as usize / 2;
        // With few distinct keys too, and in ascending order.
        let cases: [(Vec<u64>, usize); 4] =
            [(shuffled(u64::MAX), half), (shuffled(3), half), (shuffled(1), 5), ((0..count).rev().collect(), 5)];
        for (keys, middle) in cases {
            let mut sorted: Vec<u32> = (0..count as u32).collect();
            let mut selected = sorted.clone();
            sorted.sort_by_key(|&i| keys[i as usize]);
            let mut reports = 0;
            let mut report = || {
                reports += 1;
                Ok(())
            };
            select_by_rank_reported(&mut selected, middle, |i| keys[i as usize] as f64, &mut report).unwrap();
            assert!(reports > 8, "{reports}");
            assert_eq!(selected[middle], sorted[middle]);
            let before = &mut selected[..middle];
            before.sort_by_key(|&i| (keys[i as usize], i));
            assert_eq!(before, &sorted[..middle]);
        }
    }

    #[test]
    fn a_host_can_cancel() {
        struct CancelsAfterSteps(Cell<u32>);
        impl Progress for CancelsAfterSteps {
            fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
                assert!((0.0..=1.0).contains(&fraction));
                self.0.set(self.0.get() + 1);
                if self.0.get() == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
        }
        let counter = CancelsAfterSteps(Cell::new(0));
        let done =
            sort(&mut scrambled_numbers(4 * ELEMENTS_PER_REPORT as u64), u64::cmp, &Job::new(1, &counter), "sorting");
        assert_eq!((done, counter.0.get()), (Err(crate::Error::Cancelled), 5));
    }
}
