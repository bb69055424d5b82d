//! Adaptive subdivision with proofs: all solutions of a system of equations over a box of
//! parameters, none missed.
//!
//! A box is classified by tests on the control points of the equations over it. Bernstein
//! coefficients bound the polynomial, so a test that excludes solutions is a proof of their
//! absence; a Jacobian whose diagonal dominates all over the box proves that there is one solution
//! at most, which Newton's method then finds. A box without either proof is split by de Casteljau's
//! algorithm, which is the scheme of Sherbrooke and Patrikalakis (1993, "Computation of the
//! solutions of nonlinear polynomial systems"), of Mourrain and Pavone (2009, "Subdivision methods
//! for solving polynomial equations"), who precondition by the inverse of the middle Jacobian, and
//! of Hanniel and Elber (2007, "Subdivision termination criteria in subdivision multivariate
//! solvers"), who end it where a box holds one root at most. Boxes that stay undecided when they
//! are too small, too deep or too many are clustered and reported.
//!
//! Invariant: the boxes on the stack, those given up and those decided cover the first one. Cost:
//! one classification a box; boxes examined number at most `max_boxes` and those still on the stack
//! then; the stack, depth first, holds at most (K - 1) `max_depth` + 1.

use crate::alloc;
use crate::error::Result;
use crate::geom::disjoint_sets::DisjointSets;
use crate::sort;
use glam::DVec3;

/// What is proved of a box.
pub enum BoxTest<U, S> {
    /// It holds no solution.
    Empty,
    /// It holds this solution, or part of one, and no other.
    Unique(U),
    /// Nothing: it is to be split in this way.
    Undecided(S),
    /// Nothing, and its parts would not differ beyond the tolerance.
    Unresolved,
}

/// When splitting ends.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Splits between the first box and the least.
    pub max_depth: u32,
    /// Boxes examined: that of this number, and those after it, are not split.
    pub max_boxes: usize,
}

/// A system of equations, with what was found of its solutions.
///
/// `P`: a box of parameters with the control points over it; K: the parts it is split into.
pub trait Subdivision<P, const K: usize> {
    /// A solution that is alone in its box.
    type Solution;
    /// How a box is split: a direction, or nothing.
    type Split;
    /// Why the whole search ends early.
    type Stop;

    fn classify(&mut self, part: &P) -> Result<BoxTest<Self::Solution, Self::Split>, Self::Stop>;

    /// Takes the only solution of a box.
    fn accept(&mut self, part: P, solution: Self::Solution) -> Result<(), Self::Stop>;

    /// Takes a box that is not split any more. `exhausted`: `max_boxes` have been examined.
    fn give_up(&mut self, part: P, exhausted: bool) -> Result<(), Self::Stop>;

    /// Splits a box; the last part is examined first.
    fn split(&mut self, part: P, split: Self::Split) -> [P; K];

    /// Makes room for K parts, where lack of memory is to be an error.
    #[inline(always)]
    fn reserve(_stack: &mut Stack<P>) -> Result<(), Self::Stop> {
        Ok(())
    }
}

/// Boxes that wait, each with its depth.
pub type Stack<P> = Vec<(P, u32)>;

/// Examines a box, those on the stack, and the parts of all of them, depth first.
#[inline]
pub fn subdivide<P, const K: usize, S: Subdivision<P, K>>(
    system: &mut S,
    first: P,
    stack: &mut Stack<P>,
    limits: Limits,
) -> Result<(), S::Stop> {
    let mut next = Some((first, 0));
    let mut examined = 0;
    while let Some((part, depth)) = next.take().or_else(|| stack.pop()) {
        examined += 1;
        let exhausted = examined >= limits.max_boxes;
        match system.classify(&part)? {
            BoxTest::Empty => {}
            BoxTest::Unique(solution) => system.accept(part, solution)?,
            BoxTest::Undecided(split) if depth < limits.max_depth && !exhausted => {
                S::reserve(stack)?;
                stack.extend(system.split(part, split).map(|part| (part, depth + 1)));
            }
            BoxTest::Undecided(_) | BoxTest::Unresolved => system.give_up(part, exhausted)?,
        }
    }
    Ok(())
}

/// A box that was given up. In fewer than three parameters the others are 0.
#[derive(Debug, Clone, Copy)]
pub struct UnresolvedBox {
    pub middle: DVec3,
    /// Half its sides.
    pub half: DVec3,
    /// The absolute value in the middle of the function whose zero is sought.
    pub residual: f64,
}

/// Unresolved boxes that touch each other.
#[derive(Debug, Clone, Copy)]
pub struct UnresolvedCluster {
    /// The first box of the least residual.
    pub best: UnresolvedBox,
    /// The corners of the box round all of them.
    pub low: DVec3,
    pub high: DVec3,
}

/// Boxes looked at before a host is asked again.
const BOXES_PER_REPORT: usize = 1 << 11;

/// How much larger than they are boxes count: those that touch do so but for rounding.
const GROWTH: f64 = 1.000_001;

impl UnresolvedBox {
    #[inline]
    pub fn touches(&self, other: &UnresolvedBox) -> bool {
        let gap = (self.middle - other.middle).abs() - GROWTH * (self.half + other.half);
        gap.max_element() <= 0.0
    }
}

/// Adds the clusters of boxes, by their first box, and returns the place of each box's cluster
/// among them; `ask` is called now and then, and what it returns as an error ends the work.
/// O(n log n + pairs that overlap along the first parameter).
pub fn cluster(
    boxes: &[UnresolvedBox],
    clusters: &mut Vec<UnresolvedCluster>,
    mut ask: impl FnMut() -> Result<()>,
) -> Result<Vec<u32>> {
    // A sweep along the first parameter finds the pairs; each tree of the forest has its first box
    // as its root.
    let ends = |k: u32| {
        let UnresolvedBox { middle, half, .. } = boxes[k as usize];
        [middle.x - GROWTH * half.x, middle.x + GROWTH * half.x]
    };
    let mut order = alloc::collect(0..boxes.len() as u32)?;
    sort::stable(&mut order, &|&a, &b| ends(a)[0].total_cmp(&ends(b)[0]).then(a.cmp(&b)));
    let mut sets = DisjointSets::new(boxes.len())?;
    let mut active: Vec<u32> = alloc::with_capacity(boxes.len())?;
    for (place, &k) in order.iter().enumerate() {
        if place.is_multiple_of(BOXES_PER_REPORT) {
            ask()?;
        }
        // Ends are rounded, so those that just touch are kept.
        let low = ends(k)[0] - f64::EPSILON * ends(k)[0].abs();
        active.retain(|&other| ends(other)[1] >= low);
        for &other in &active {
            if boxes[k as usize].touches(&boxes[other as usize]) {
                sets.union(k, other);
            }
        }
        active.push(k);
    }
    ask()?;
    let mut cluster_of = order;
    for (k, part) in boxes.iter().enumerate() {
        let (low, high) = (part.middle - part.half, part.middle + part.half);
        let root = sets.find(k as u32) as usize;
        if root == k {
            cluster_of[k] = clusters.len() as u32;
            alloc::push(clusters, UnresolvedCluster { best: *part, low, high })?;
        } else {
            cluster_of[k] = cluster_of[root];
            let cluster = &mut clusters[cluster_of[k] as usize];
            if part.residual < cluster.best.residual {
                cluster.best = *part;
            }
            (cluster.low, cluster.high) = (cluster.low.min(low), cluster.high.max(high));
        }
    }
    Ok(cluster_of)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    /// The places where x^2 = 2 over an interval, by its values at the ends of parts.
    struct SquareRoots {
        found: Vec<f64>,
        given_up: Vec<[f64; 2]>,
        examined: usize,
    }

    impl Subdivision<[f64; 2], 2> for SquareRoots {
        type Solution = f64;
        type Split = ();
        type Stop = ();

        fn classify(&mut self, &[low, high]: &[f64; 2]) -> Result<BoxTest<f64, ()>, ()> {
            self.examined += 1;
            let values = [low * low, high * high];
            let range = [if low * high < 0.0 { 0.0 } else { values[0].min(values[1]) }, values[0].max(values[1])];
            Ok(if range[0] > 2.0 || range[1] < 2.0 {
                BoxTest::Empty
            } else if low * high > 0.0 {
                BoxTest::Unique(2.0_f64.sqrt().copysign(low))
            } else {
                BoxTest::Undecided(())
            })
        }

        fn accept(&mut self, [low, high]: [f64; 2], root: f64) -> Result<(), ()> {
            assert!((low..=high).contains(&root));
            self.found.push(root);
            Ok(())
        }

        fn give_up(&mut self, part: [f64; 2], exhausted: bool) -> Result<(), ()> {
            self.given_up.push(part);
            if exhausted { Err(()) } else { Ok(()) }
        }

        fn split(&mut self, [low, high]: [f64; 2], (): ()) -> [[f64; 2]; 2] {
            let middle = 0.25 * low + 0.75 * high;
            [[middle, high], [low, middle]]
        }
    }

    fn square_roots(max_depth: u32, max_boxes: usize) -> (SquareRoots, Result<(), ()>) {
        let mut problem = SquareRoots { found: Vec::new(), given_up: Vec::new(), examined: 0 };
        let done = subdivide(&mut problem, [-3.0, 9.0], &mut Vec::new(), Limits { max_depth, max_boxes });
        (problem, done)
    }

    #[test]
    fn all_solutions_are_found_in_order() {
        let (problem, done) = square_roots(40, 1000);
        assert_eq!(problem.found, [-(2.0_f64.sqrt()), 2.0_f64.sqrt()]);
        assert!(problem.given_up.is_empty() && done.is_ok());
    }

    #[test]
    fn limits_hold_and_nothing_is_dropped() {
        let (problem, done) = square_roots(0, 1000);
        assert_eq!((problem.given_up.as_slice(), done), ([[-3.0, 9.0]].as_slice(), Ok(())));
        let (problem, done) = square_roots(40, 1);
        assert_eq!((problem.examined, problem.given_up.len(), done), (1, 1, Err(())));
    }

    #[test]
    fn boxes_that_touch_are_one_cluster() {
        let part = |x: f64, y: f64, residual: f64| UnresolvedBox {
            middle: DVec2::new(x, y).extend(0.0),
            half: DVec2::splat(0.5).extend(0.0),
            residual,
        };
        // Two rows that a box between joins at last, and one by itself.
        let boxes = [
            part(0.0, 0.0, 3.0),
            part(9.0, 9.0, 0.0),
            part(0.0, 2.0, 1.0),
            part(1.0, 0.0, 2.0),
            part(1.0, 2.0, 1.0),
            part(2.0, 1.0, 5.0),
        ];
        let mut clusters = Vec::new();
        assert_eq!(cluster(&boxes, &mut clusters, || Ok(())).unwrap(), [0, 1, 0, 0, 0, 0]);
        assert_eq!(clusters.len(), 2);
        assert_eq!((clusters[0].best.middle, clusters[0].best.residual), (boxes[2].middle, 1.0));
        assert_eq!((clusters[0].low, clusters[0].high), (DVec3::new(-0.5, -0.5, 0.0), DVec3::new(2.5, 2.5, 0.0)));
        assert_eq!((clusters[1].low, clusters[1].high), (DVec3::new(8.5, 8.5, 0.0), DVec3::new(9.5, 9.5, 0.0)));
    }
}
