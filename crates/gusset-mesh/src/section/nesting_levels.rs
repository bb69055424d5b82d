//! The nesting of the closed paths of one plane: which loops are around a loop.
//!
//! Vertical lines pierce all loops, as few as a greedy choice finds. On its line each loop gets a test
//! point: the middle of the widest gap between its own crossings. A loop is inside another one if the
//! other one has the larger area and an odd number of edges below the test point. Loops may therefore
//! touch and share edges. A walk up each line toggles the loops that it crosses, ranked by area, and
//! asks at each test point which of the larger loops are open.

use super::open_loops::OpenLoops;
use super::section_request::STAGE;
use super::sections::Sections;
use crate::NONE;
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;

/// An edge of a loop, from left to right.
#[derive(Clone, Copy, Default)]
struct LoopEdge {
    left: DVec2,
    right: DVec2,
    /// The index of the loop among the closed paths.
    loop_index: u32,
}

impl LoopEdge {
    fn new(start: DVec2, end: DVec2, loop_index: u32) -> Self {
        let [left, right] = if start.x < end.x { [start, end] } else { [end, start] };
        LoopEdge { left, right, loop_index }
    }

    /// Returns the height of the edge on the vertical line at `x`, which is between its ends.
    fn height_at(&self, x: f64) -> f64 {
        self.left.y + (self.right.y - self.left.y) * ((x - self.left.x) / (self.right.x - self.left.x))
    }
}

/// Sets the areas, parents and depths of the paths from `first_path` on, which are of one plane.
pub(super) fn nest_loops(sections: &mut Sections, first_path: usize, normal: DVec3, job: &Job<'_>) -> Result<()> {
    let closed = alloc::gather((first_path..sections.paths.len()).filter(|&k| sections.paths[k].is_closed))?;
    if closed.is_empty() {
        return Ok(());
    }
    let (u, v) = normal.any_orthonormal_pair();
    // Areas are more accurate about a near point.
    let origin = sections.points[sections.range(closed[0]).start];
    let flat = |p: DVec3| DVec2::new((p - origin).dot(u), (p - origin).dot(v));
    let count = closed.iter().map(|&k| sections.range(k).len()).sum();
    let mut edges: Vec<LoopEdge> = alloc::with_capacity(count)?;
    let mut loops: Vec<LoopOnLine> = alloc::with_capacity(closed.len())?;
    for (loop_index, &k) in (0..).zip(&closed) {
        job.step_within_list(edges.len(), STAGE)?;
        let points = &sections.points[sections.range(k)];
        let first = flat(points[0]);
        let mut double_area = 0.0;
        let mut own = LoopOnLine::new(first);
        for i in 0..points.len() {
            let [start, end] = [i, (i + 1) % points.len()].map(|i| flat(points[i]));
            double_area += (start - first).perp_dot(end - first);
            own.low = own.low.min(start.x);
            own.high = own.high.max(start.x);
            // A line never crosses a vertical edge.
            if start.x != end.x {
                edges.push(LoopEdge::new(start, end, loop_index));
            }
        }
        sections.paths[k].area = double_area / 2.0;
        loops.push(own);
    }
    if closed.len() == 1 {
        return Ok(());
    }
    let ranks = rank_by_area(&closed, sections, job)?;
    for (loop_index, found) in find_open_loops(edges, loops, &ranks, job)? {
        let path = &mut sections.paths[closed[loop_index as usize]];
        path.depth = found.count;
        path.parent = if found.nearest == NONE {
            NONE
        } else {
            closed[ranks.loop_of_rank[found.nearest as usize] as usize] as u32
        };
    }
    Ok(())
}

/// The loops from the smallest area to the largest. If two areas are equal, the first loop ranks higher.
struct AreaRanks {
    loop_of_rank: Vec<u32>,
    rank_of_loop: Vec<u32>,
}

fn rank_by_area(closed: &[usize], sections: &Sections, job: &Job<'_>) -> Result<AreaRanks> {
    let area = |k: u32| sections.paths[closed[k as usize]].area.abs();
    let mut loop_of_rank = alloc::collect(0..closed.len() as u32)?;
    sort(&mut loop_of_rank, |&a, &b| area(a).total_cmp(&area(b)).then(b.cmp(&a)), job, STAGE)?;
    let mut rank_of_loop = alloc::filled(0, closed.len())?;
    (0..).zip(&loop_of_rank).for_each(|(rank, &k)| rank_of_loop[k as usize] = rank);
    Ok(AreaRanks { loop_of_rank, rank_of_loop })
}

/// A loop and its crossings with its line.
#[derive(Clone, Copy)]
struct LoopOnLine {
    /// The range of its first coordinates.
    low: f64,
    high: f64,
    /// The index of its line.
    line: u32,
    /// The number of its crossings so far, and the height of the last one.
    crossing_count: u32,
    last_height: f64,
    /// The widest gap so far, and the height of its middle.
    widest_gap: f64,
    middle: f64,
}

impl LoopOnLine {
    fn new(first_point: DVec2) -> Self {
        LoopOnLine {
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            line: NONE,
            crossing_count: 0,
            last_height: 0.0,
            widest_gap: -1.0,
            middle: first_point.y,
        }
    }

    /// Returns the range in which a line may pierce the loop: the middle half of its width. Its start never exceeds
    /// its end, not even where rounding would exchange them.
    fn middle_half(&self) -> [f64; 2] {
        let [low, high] = [0.75 * self.low + 0.25 * self.high, 0.25 * self.low + 0.75 * self.high];
        [low.min(high), low.max(high)]
    }

    fn add_crossing(&mut self, height: f64) {
        self.crossing_count += 1;
        if self.crossing_count.is_multiple_of(2) && height - self.last_height > self.widest_gap {
            self.widest_gap = height - self.last_height;
            self.middle = f64::midpoint(self.last_height, height);
        }
        self.last_height = height;
    }
}

/// A vertical line, and the loops that have their test points on it: a range of the loops sorted by
/// line.
struct PiercingLine {
    x: f64,
    loops: std::ops::Range<usize>,
}

/// Assigns each loop a vertical line through the middle half of its width. Returns the lines from left
/// to right, and the loops line by line.
fn pierce_loops(loops: &mut [LoopOnLine], job: &Job<'_>) -> Result<(Vec<PiercingLine>, Vec<u32>)> {
    let mut by_end = alloc::collect(0..loops.len() as u32)?;
    let end = |k: u32| loops[k as usize].middle_half()[1];
    sort(&mut by_end, |&a, &b| end(a).total_cmp(&end(b)).then(a.cmp(&b)), job, STAGE)?;
    let mut lines: Vec<PiercingLine> = Vec::new();
    let mut start = 0;
    while start < by_end.len() {
        // All middle halves of a group contain the first end.
        let first_end = loops[by_end[start] as usize].middle_half()[1];
        let mut latest_start = f64::NEG_INFINITY;
        let mut end = start;
        while let Some(&k) = by_end.get(end)
            && let [low, _] = loops[k as usize].middle_half()
            && low <= first_end
        {
            job.step_within_list(end, STAGE)?;
            latest_start = latest_start.max(low);
            loops[k as usize].line = lines.len() as u32;
            end += 1;
        }
        alloc::push(&mut lines, PiercingLine { x: f64::midpoint(latest_start, first_end), loops: start..end })?;
        start = end;
    }
    Ok((lines, by_end))
}

/// The larger loops around a loop.
struct LoopsAround {
    count: u32,
    /// The rank of the smallest one, or [`NONE`].
    nearest: u32,
}

/// Finds the larger loops around each loop. Takes O(m log m + c log c) for m edges and c crossings of
/// lines and edges.
fn find_open_loops(
    mut edges: Vec<LoopEdge>,
    mut loops: Vec<LoopOnLine>,
    ranks: &AreaRanks,
    job: &Job<'_>,
) -> Result<Vec<(u32, LoopsAround)>> {
    sort(&mut edges, |a, b| a.left.x.total_cmp(&b.left.x), job, STAGE)?;
    let (lines, loops_by_line) = pierce_loops(&mut loops, job)?;
    let mut found = alloc::with_capacity(loops.len())?;
    let mut open = OpenLoops::new(loops.len())?;
    let (mut next, mut active): (usize, Vec<u32>) = (0, Vec::new());
    // Heights and loops.
    let mut crossings: Vec<(f64, u32)> = Vec::new();
    let mut tests: Vec<(f64, u32)> = Vec::new();
    for (line, PiercingLine { x, loops: range }) in (0..).zip(lines) {
        job.step_within_heavy_list(64, line as usize, STAGE)?;
        while next < edges.len() && edges[next].left.x <= x {
            alloc::push(&mut active, next as u32)?;
            next += 1;
        }
        // If two edges meet at x, one counts.
        active.retain(|&edge| x < edges[edge as usize].right.x);
        crossings.clear();
        alloc::extend(
            &mut crossings,
            active.iter().map(|&edge| {
                let edge = &edges[edge as usize];
                (edge.height_at(x), edge.loop_index)
            }),
        )?;
        let in_order = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        sort(&mut crossings, in_order, job, STAGE)?;
        for &(height, k) in &crossings {
            let crossed = &mut loops[k as usize];
            if crossed.line == line {
                crossed.add_crossing(height);
            }
        }
        tests.clear();
        alloc::extend(&mut tests, loops_by_line[range].iter().map(|&k| (loops[k as usize].middle, k)))?;
        sort(&mut tests, in_order, job, STAGE)?;
        let mut walked = crossings.iter().peekable();
        for &(height, k) in &tests {
            while let Some((_, crossed)) = walked.next_if(|(crossing, _)| *crossing < height) {
                open.toggle(ranks.rank_of_loop[*crossed as usize]);
            }
            let own = ranks.rank_of_loop[k as usize];
            found.push((k, LoopsAround { count: open.count_above(own), nearest: open.find_above(own) }));
        }
        walked.for_each(|(_, crossed)| open.toggle(ranks.rank_of_loop[*crossed as usize]));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Each loop gets one line within its width, also loops as narrow as a few roundings.
        #[test]
        fn every_loop_is_pierced(loops in prop::collection::vec((-4.0..4.0f64, 0u64..4), 1..40)) {
            let width = |&(low, steps): &(f64, u64)| LoopOnLine {
                low: low.min(f64::from_bits(low.to_bits() + steps)),
                high: low.max(f64::from_bits(low.to_bits() + steps)),
                ..LoopOnLine::new(DVec2::ZERO)
            };
            let mut loops: Vec<_> = loops.iter().map(width).collect();
            let (lines, by_line) = pierce_loops(&mut loops, &Job::default()).unwrap();
            let mut numbers = by_line.clone();
            numbers.sort_unstable();
            prop_assert_eq!(numbers, (0..loops.len() as u32).collect::<Vec<_>>());
            for PiercingLine { x, loops: range } in &lines {
                prop_assert!(by_line[range.clone()].iter().map(|&k| loops[k as usize]).all(|own| own.low <= *x && *x <= own.high));
            }
        }
    }
}
