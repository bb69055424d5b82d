//! The meridians whose triangles have the least total area: exact dynamic programming over the lattice of all pairs.
//!
//! Node (i, j) is the meridian from A_i to B_j. A step on A adds the triangle A_i A_i+1 B_j, a step on B the triangle
//! A_i B_j B_j+1, and every path from (0, 0) to (N, M) is a strip (Fuchs, Kedem and Uselton, 1977). Two refinements make the
//! result usable:
//!
//! **No meridian twice.** (i, 0) and (i, M) are the same edge, since B_M is B_0. A path through both takes all its B steps at one i:
//! it never advances on A while 0 < j < M. Likewise for (0, j) and (N, j). So a strip is proper if and only if its path has an
//! A step with 0 < j < M and a B step with 0 < i < N. To an inner node exactly two improper paths lead: all A steps first
//! (`ab`), and all B steps first (`ba`). The table therefore keeps three costs a node, those two and the least of all the
//! others (`best`), and the answer is exactly the least area of all proper strips. Between open polylines every path is proper.
//!
//! **Ties.** In a plane all strips without folds have the same area, and round-off would choose. Areas that differ by less than
//! 2^-32 of the paper's strip's area, shared out over the steps, count as equal, and then the smaller sum of squared
//! meridian lengths wins. Each node compares at most twice, so the area is within 2^-31 of that strip's area of the least one.

use super::Pair;
use super::index_rule::index_meridians;
use crate::alloc;
use crate::error::Result;
use crate::geom::triangle::double_area;
use crate::job::Job;
use glam::DVec3;

/// Nodes whose arrivals are kept at a time (one byte each). Longer tables are cut into blocks of rows: the first pass keeps
/// the costs at each block's start, and the way back computes each block once more.
const BLOCK: usize = 1 << 26;

/// Nodes between two progress reports.
const REPORT: usize = 1 << 19;

#[derive(Clone, Copy, PartialEq, Debug)]
struct Cost {
    area: f64,
    length: f64,
}

impl Cost {
    const ZERO: Cost = Cost { area: 0.0, length: 0.0 };
    const NEVER: Cost = Cost { area: f64::INFINITY, length: f64::INFINITY };

    fn plus(self, area: f64, length: f64) -> Cost {
        Cost { area: self.area + area, length: self.length + length }
    }

    fn less(self, other: Cost, tolerance: f64) -> bool {
        self.area < other.area - tolerance || (self.area <= other.area + tolerance && self.length < other.length)
    }
}

/// How a best path arrives at a node: the last step was on B.
const BY_B: u8 = 1;
/// How a best path arrives at a node: before the last step it was an improper path.
const FROM_IMPROPER: u8 = 2;

/// The costs of one row of nodes, j = 0..=M.
#[derive(Clone)]
struct Row {
    best: Vec<Cost>,
    ab: Vec<Cost>,
    ba: Vec<Cost>,
}

struct Table<'a, F> {
    /// N + 1 points; of a closed polyline the last is the first again.
    a: &'a [DVec3],
    /// M + 1 points.
    b: &'a [DVec3],
    closed: bool,
    forbidden: F,
    tolerance: f64,
    /// The areas of the steps into the nodes of one row, and their meridians' squared lengths.
    step_a: Vec<f64>,
    step_b: Vec<f64>,
    length: Vec<f64>,
}

/// The proper strip of least area between the polylines `a` of N + 1 points and `b` of M + 1, which are both open or both
/// closed, with the first point again at the end. The answer is the meridians from (0, 0) to (N, M); `None` if the forbidden
/// ones leave none. `forbidden(i, j)` takes 0 <= i <= N, 0 <= j <= M.
///
/// O(N M) time; extra memory one byte a node for at most 2^26 nodes, 72 (M + 1) bytes, and 48 (M + 1) more for each 2^26 nodes
/// begun.
pub(crate) fn min_area(
    a: &[DVec3],
    b: &[DVec3],
    closed: bool,
    forbidden: Option<impl Fn(usize, usize) -> bool>,
    job: &Job<'_>,
) -> Result<Option<Vec<Pair>>> {
    let (n, m) = (a.len() - 1, b.len() - 1);
    let paper = strip_area(a, b, &index_meridians(n as u32, m as u32)?);
    let mut table = Table {
        a,
        b,
        closed,
        forbidden,
        tolerance: paper * 0.5f64.powi(32) / (n + m).max(1) as f64,
        step_a: alloc::filled(0.0, m + 1)?,
        step_b: alloc::filled(0.0, m + 1)?,
        length: alloc::filled(0.0, m + 1)?,
    };

    let rows_per_block = (BLOCK / (m + 1)).clamp(1, n.max(1));
    let mut arrivals = alloc::filled(0u8, rows_per_block * (m + 1))?;
    let mut starts = alloc::with_capacity(n / rows_per_block + 1)?;
    let mut row = table.first_row()?;
    for i in 1..=n {
        if (i - 1) % rows_per_block == 0 {
            starts.push(row.try_clone()?);
        }
        if i * (m + 1) / REPORT != (i - 1) * (m + 1) / REPORT {
            job.step(i as f64 / n as f64, "finding the strip of least area")?;
        }
        table.next_row(i, &mut row, &mut arrivals[(i - 1) % rows_per_block * (m + 1)..][..m + 1]);
    }

    let mut path = Path { pairs: alloc::with_capacity(n + m + 1)?, i: n, j: m };
    path.pairs.push([n as u32, m as u32]);
    if !closed && row.ab[m].less(row.best[m], table.tolerance) && !row.ba[m].less(row.ab[m], table.tolerance) {
        path.back_to(n, 0);
        path.back_to(0, 0);
    } else if !closed && row.ba[m].less(row.best[m], table.tolerance) {
        path.back_to(0, m);
        path.back_to(0, 0);
    } else if row.best[m].area == f64::INFINITY {
        return Ok(None);
    }
    for (block, start) in starts.iter_mut().enumerate().rev() {
        let first = block * rows_per_block + 1;
        let last = n.min(first + rows_per_block - 1);
        // The last block's arrivals are still there.
        if last < n && path.i >= first {
            for i in first..=last {
                table.next_row(i, start, &mut arrivals[(i - first) * (m + 1)..][..m + 1]);
            }
            job.step(1.0, "finding the strip of least area")?;
        }
        while path.i >= first {
            path.step_back(arrivals[(path.i - first) * (m + 1) + path.j]);
        }
    }
    path.pairs.reverse();
    Ok(Some(path.pairs))
}

/// Twice the area of the strip over `pairs`; quads are split by the diagonal from the earlier vertex of `a`.
fn strip_area(a: &[DVec3], b: &[DVec3], pairs: &[Pair]) -> f64 {
    let (a_at, b_at) = (|i: u32| a[i as usize], |j: u32| b[j as usize]);
    let mut area = 0.0;
    for step in pairs.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        if j2 > j {
            area += double_area(a_at(i), b_at(j), b_at(j2));
        }
        if i2 > i {
            area += double_area(a_at(i), a_at(i2), b_at(j2));
        }
    }
    area
}

impl<F: Fn(usize, usize) -> bool> Table<'_, Option<F>> {
    fn is_forbidden(&self, i: usize, j: usize) -> bool {
        self.forbidden.as_ref().is_some_and(|forbidden| forbidden(i, j))
    }

    /// Row 0: the start, and the way along B from it.
    fn first_row(&mut self) -> Result<Row> {
        let m = self.b.len() - 1;
        let never = || alloc::filled(Cost::NEVER, m + 1);
        let mut row = Row { best: never()?, ab: never()?, ba: never()? };
        if !self.is_forbidden(0, 0) {
            row.ab[0] = Cost::ZERO;
            row.ba[0] = Cost::ZERO;
        }
        self.measure(0);
        for j in 1..=m {
            if !self.is_forbidden(0, j) {
                row.ba[j] = row.ba[j - 1].plus(self.step_b[j], self.length[j]);
            }
        }
        Ok(row)
    }

    /// Replaces row i - 1 by row i, and notes how the best paths arrive.
    #[allow(clippy::needless_range_loop, reason = "j is a place on rim B, and indexes seven arrays")]
    fn next_row(&mut self, i: usize, row: &mut Row, arrivals: &mut [u8]) {
        self.measure(i);
        let (n, m, open) = (self.a.len() - 1, self.b.len() - 1, !self.closed);
        let least = |x: Cost, y: Cost| {
            if y.less(x, self.tolerance) { (y, FROM_IMPROPER) } else { (x, 0) }
        };

        row.best[0] = Cost::NEVER;
        row.ba[0] = Cost::NEVER;
        row.ab[0] = if self.is_forbidden(i, 0) { Cost::NEVER } else { row.ab[0].plus(self.step_a[0], self.length[0]) };
        for j in 1..=m {
            if self.is_forbidden(i, j) {
                (row.best[j], row.ab[j], row.ba[j]) = (Cost::NEVER, Cost::NEVER, Cost::NEVER);
                continue;
            }
            // On A: row i - 1 still stands at j. An `ab` path becomes proper by an A step with 0 < j < M, between open
            // polylines with 0 < j. It is absent for i = 1, where the node before lies on the border i = 0.
            let improper = if j < m || open { row.ab[j] } else { Cost::NEVER };
            let (from_a, kind_a) = least(row.best[j], improper);
            let by_a = from_a.plus(self.step_a[j], self.length[j]);
            // On B: row i stands at j - 1. A `ba` path becomes proper by a B step with 0 < i < N, or with 0 < i.
            let improper = if i < n || open { row.ba[j - 1] } else { Cost::NEVER };
            let (from_b, kind_b) = least(row.best[j - 1], improper);
            let by_b = from_b.plus(self.step_b[j], self.length[j]);

            let b_wins = by_b.less(by_a, self.tolerance);
            row.best[j] = if b_wins { by_b } else { by_a };
            arrivals[j] = if b_wins { kind_b | BY_B } else { kind_a };
            row.ab[j] = row.ab[j - 1].plus(self.step_b[j], self.length[j]);
            row.ba[j] = row.ba[j].plus(self.step_a[j], self.length[j]);
        }
    }

    /// Fills in the steps into row i and its lengths. These loops have no branches, so that they run on vectors.
    fn measure(&mut self, i: usize) {
        let here = self.a[i];
        let edge = here - self.a[i.saturating_sub(1)];
        for (j, &b) in self.b.iter().enumerate() {
            let meridian = b - here;
            self.step_a[j] = edge.cross(meridian).length();
            self.length[j] = meridian.length_squared();
        }
        for (j, pair) in self.b.windows(2).enumerate() {
            self.step_b[j + 1] = (pair[1] - pair[0]).cross(here - pair[0]).length();
        }
    }
}

impl Row {
    fn try_clone(&self) -> Result<Row> {
        let copy = |costs: &Vec<Cost>| alloc::copied(costs);
        Ok(Row { best: copy(&self.best)?, ab: copy(&self.ab)?, ba: copy(&self.ba)? })
    }
}

/// The way back from (N, M).
struct Path {
    pairs: Vec<Pair>,
    i: usize,
    j: usize,
}

impl Path {
    fn step_back(&mut self, arrival: u8) {
        let by_b = arrival & BY_B != 0;
        self.back_to(self.i - usize::from(!by_b), self.j - usize::from(by_b));
        if arrival & FROM_IMPROPER != 0 {
            // A `ba` path came along i from (0, j), an `ab` path along j from (i, 0); then along the border.
            let corner = if by_b { (0, self.j) } else { (self.i, 0) };
            self.back_to(corner.0, corner.1);
            self.back_to(0, 0);
        }
    }

    fn back_to(&mut self, i: usize, j: usize) {
        while (self.i, self.j) != (i, j) {
            self.i -= usize::from(self.i > i);
            self.j -= usize::from(self.j > j);
            self.pairs.push([self.i as u32, self.j as u32]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    type Never = fn(usize, usize) -> bool;

    /// The edges that a path uses, those of a closed polyline's end being those of its start.
    fn edges(a: &[DVec3], b: &[DVec3], closed: bool, path: &[Pair]) -> Vec<[usize; 2]> {
        let (n, m) = if closed { (a.len() - 1, b.len() - 1) } else { (a.len(), b.len()) };
        let mut edges: Vec<_> = path.iter().map(|&[i, j]| [i as usize % n, j as usize % m]).collect();
        if closed {
            // The last meridian is the first, by definition.
            edges.pop();
        }
        edges.sort_unstable();
        edges
    }

    /// Every path, by recursion; those that use an edge twice are left out.
    fn brute_force(a: &[DVec3], b: &[DVec3], closed: bool, forbidden: &impl Fn(usize, usize) -> bool) -> f64 {
        let mut best = f64::INFINITY;
        let mut paths = vec![vec![[0, 0]]];
        while let Some(path) = paths.pop() {
            let [i, j] = *path.last().unwrap();
            if forbidden(i as usize, j as usize) {
                continue;
            }
            if (i as usize, j as usize) == (a.len() - 1, b.len() - 1) {
                if edges(a, b, closed, &path).windows(2).all(|pair| pair[0] != pair[1]) {
                    best = best.min(strip_area(a, b, &path));
                }
                continue;
            }
            for [di, dj] in [[1, 0], [0, 1]] {
                if ((i + di) as usize) < a.len() && ((j + dj) as usize) < b.len() {
                    paths.push([path.as_slice(), &[[i + di, j + dj]]].concat());
                }
            }
        }
        best
    }

    fn check(a: &[DVec3], b: &[DVec3], closed: bool, forbidden: &impl Fn(usize, usize) -> bool) {
        let least = brute_force(a, b, closed, forbidden);
        match min_area(a, b, closed, Some(forbidden), &Job::default()).unwrap() {
            None => assert_eq!(least, f64::INFINITY),
            Some(pairs) => {
                assert_eq!(pairs.len(), a.len() + b.len() - 1);
                let area = strip_area(a, b, &pairs);
                assert!(least.is_finite() && area >= least * (1.0 - 1e-12), "{area} {least}");
                let paper = strip_area(a, b, &index_meridians(a.len() as u32 - 1, b.len() as u32 - 1).unwrap());
                assert!(area <= least + paper * 0.5f64.powi(31), "{area} {least}");
                assert!(pairs.iter().all(|&[i, j]| !forbidden(i as usize, j as usize)));
                let edges = edges(a, b, closed, &pairs);
                assert!(edges.windows(2).all(|pair| pair[0] != pair[1]), "a meridian twice: {pairs:?}");
            }
        }
    }

    /// The first point again at the end.
    fn closed(points: &[DVec3]) -> Vec<DVec3> {
        points.iter().chain(&points[..1]).copied().collect()
    }

    fn polyline(coordinates: &[(i8, i8, i8)]) -> Vec<DVec3> {
        coordinates.iter().map(|&(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z))).collect()
    }

    proptest! {
        #[test]
        fn equals_brute_force(
            a in prop::collection::vec(any::<(i8, i8, i8)>(), 3..7),
            b in prop::collection::vec(any::<(i8, i8, i8)>(), 3..7),
            // A tiny second rim is where the least area of all paths uses a meridian twice.
            shrink in prop::sample::select(vec![1.0, 1e-3, 0.0]),
            forbidden in any::<u64>(),
            sparse in 1usize..5,
        ) {
            let a = polyline(&a);
            let b: Vec<_> = polyline(&b).iter().map(|&p| p * shrink).collect();
            let (n, m) = (a.len(), b.len());
            let some = |i: usize, j: usize| (i * 7 + j) % sparse == 3 && forbidden >> (i * 6 + j) & 1 == 1;
            for forbidden in [&(|_, _| false) as &dyn Fn(usize, usize) -> bool, &some] {
                check(&closed(&a), &closed(&b), true, &|i, j| forbidden(i % n, j % m));
                check(&a, &b, false, &|i, j| forbidden(i, j));
            }
        }

        #[test]
        fn open_polylines_of_few_points(
            a in prop::collection::vec(any::<(i8, i8, i8)>(), 1..4),
            b in prop::collection::vec(any::<(i8, i8, i8)>(), 1..6),
        ) {
            check(&polyline(&a), &polyline(&b), false, &|_, _| false);
        }
    }

    #[test]
    fn a_plane_ring_gets_short_meridians() {
        // All strips of a plane ring have the same area; the ties must not leave a fan.
        let circle = |n: usize, r: f64| -> Vec<DVec3> {
            let angle = |i| std::f64::consts::TAU * i as f64 / n as f64;
            (0..n).map(|i| DVec3::new(r * angle(i).cos(), r * angle(i).sin(), 0.0)).collect()
        };
        let (a, b) = (circle(48, 2.0), circle(32, 1.7));
        let pairs = min_area(&closed(&a), &closed(&b), true, None::<Never>, &Job::default()).unwrap().unwrap();
        let longest = pairs.iter().map(|&[i, j]| a[i as usize % 48].distance(b[j as usize % 32])).fold(0.0, f64::max);
        // None leans sideways by more than one edge: the gap is 0.3 wide, the longer edge 0.334 long.
        assert!(longest < 0.3f64.hypot(0.334), "{longest}");
    }
}
