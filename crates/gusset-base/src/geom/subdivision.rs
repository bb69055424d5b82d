//! Adaptive subdivision with proofs: finds all solutions of a system of equations over a box of
//! parameters.
//!
//! Each box is classified by the control points of the equations over it. Bernstein coefficients
//! bound a polynomial, so a test that excludes solutions proves their absence. If a Jacobian is
//! diagonally dominant over the whole box, the box has at most one solution, and Newton's method
//! finds it. A box without either proof is split by de Casteljau's algorithm. Boxes that remain
//! undecided when they are too small, too deep or too many are clustered and reported.
//!
//! The scheme is due to Sherbrooke and Patrikalakis (1993, "Computation of the solutions of
//! nonlinear polynomial systems"). Mourrain and Pavone (2009, "Subdivision methods for solving
//! polynomial equations") precondition it by the inverse of the middle Jacobian. Hanniel and Elber
//! (2007, "Subdivision termination criteria in subdivision multivariate solvers") stop at boxes
//! that hold at most one root.
//!
//! Invariant: the boxes on the stack, the abandoned ones and the decided ones together cover the
//! first box. Cost: one classification a box. At most `max_boxes` boxes are examined, plus those
//! that are on the stack at that time. The stack is depth first and holds at most (K - 1)
//! `max_depth` + 1 boxes.

use crate::alloc;
use crate::error::Result;
use crate::geom::disjoint_sets::DisjointSets;
use crate::sort;
use glam::DVec3;

/// The result of classifying a box.
pub enum BoxTest<U, S> {
    /// The box contains no solution.
    Empty,
    /// The box contains this solution, or a part of it, and no other.
    Unique(U),
    /// Undecided: split the box in this way.
    Undecided(S),
    /// Undecided, and the parts would not differ beyond the tolerance.
    Unresolved,
}

/// The limits of the search.
#[derive(Debug, Clone, Copy)]
pub struct SubdivisionLimits {
    /// The maximum number of splits between the first box and the smallest.
    pub max_depth: u32,
    /// The maximum number of boxes to split. The box of this number and later ones are examined but
    /// not split.
    pub max_boxes: usize,
}

/// A system of equations, and the receiver of its solutions.
///
/// `P` is a box of parameters with the control points over it; K is the number of parts into which
/// it splits.
pub trait Subdivision<P, const K: usize> {
    /// A solution that is alone in its box.
    type Solution;
    /// The way to split a box, such as a direction.
    type Split;
    /// The reason for stopping the search early.
    type Stop;

    fn classify_box(&mut self, part: &P) -> Result<BoxTest<Self::Solution, Self::Split>, Self::Stop>;

    /// Receives the only solution of a box.
    fn record_solution(&mut self, part: P, solution: Self::Solution) -> Result<(), Self::Stop>;

    /// Receives a box that will not be split further. `exhausted` tells whether `max_boxes` boxes
    /// have been examined.
    fn record_unresolved(&mut self, part: P, exhausted: bool) -> Result<(), Self::Stop>;

    /// Splits a box. The last part is examined first.
    fn split_box(&mut self, part: P, split: Self::Split) -> [P; K];

    /// Makes room for K parts. Override it to report a lack of memory as an error.
    #[inline(always)]
    fn reserve_stack(_stack: &mut BoxStack<P>) -> Result<(), Self::Stop> {
        Ok(())
    }
}

/// The waiting boxes, each with its depth.
pub type BoxStack<P> = Vec<(P, u32)>;

/// Examines a box, the boxes on the stack, and all their parts, depth first.
#[inline]
pub fn subdivide<P, const K: usize, S: Subdivision<P, K>>(
    system: &mut S,
    first: P,
    stack: &mut BoxStack<P>,
    limits: SubdivisionLimits,
) -> Result<(), S::Stop> {
    let mut next = Some((first, 0));
    let mut examined = 0;
    while let Some((part, depth)) = next.take().or_else(|| stack.pop()) {
        examined += 1;
        let exhausted = examined >= limits.max_boxes;
        match system.classify_box(&part)? {
            BoxTest::Empty => {}
            BoxTest::Unique(solution) => system.record_solution(part, solution)?,
            BoxTest::Undecided(split) if depth < limits.max_depth && !exhausted => {
                S::reserve_stack(stack)?;
                stack.extend(system.split_box(part, split).map(|part| (part, depth + 1)));
            }
            BoxTest::Undecided(_) | BoxTest::Unresolved => system.record_unresolved(part, exhausted)?,
        }
    }
    Ok(())
}

/// A box that remained undecided. With fewer than three parameters the other coordinates are 0.
#[derive(Debug, Clone, Copy)]
pub struct UnresolvedBox {
    pub middle: DVec3,
    /// Half the lengths of the box's sides.
    pub half_size: DVec3,
    /// The absolute value, at the centre of the box, of the function whose zero is sought.
    pub residual: f64,
}

/// Undecided boxes that touch each other.
#[derive(Debug, Clone, Copy)]
pub struct UnresolvedCluster {
    /// The first box with the smallest residual.
    pub best_box: UnresolvedBox,
    /// The corners of the bounding box.
    pub low: DVec3,
    pub high: DVec3,
}

/// Boxes examined between two progress reports.
const CLUSTERED_BOXES_PER_REPORT: usize = 1 << 11;

/// The growth of boxes in tests of contact, which absorbs rounding.
const CONTACT_GROWTH_FACTOR: f64 = 1.000_001;

impl UnresolvedBox {
    #[inline]
    pub fn touches(&self, other: &UnresolvedBox) -> bool {
        let gap = (self.middle - other.middle).abs() - CONTACT_GROWTH_FACTOR * (self.half_size + other.half_size);
        gap.max_element() <= 0.0
    }
}

/// Appends the clusters of boxes in the order of their first boxes, and returns the index of each
/// box's cluster. Calls `ask` regularly and returns its error. O(n log n + pairs that overlap along
/// the first parameter).
pub fn cluster_touching_boxes(
    boxes: &[UnresolvedBox],
    clusters: &mut Vec<UnresolvedCluster>,
    mut ask: impl FnMut() -> Result<()>,
) -> Result<Vec<u32>> {
    // A sweep along the first parameter finds the pairs. The root of each tree in the forest is its
    // first box.
    let ends = |k: u32| {
        let UnresolvedBox { middle, half_size: half, .. } = boxes[k as usize];
        [middle.x - CONTACT_GROWTH_FACTOR * half.x, middle.x + CONTACT_GROWTH_FACTOR * half.x]
    };
    let mut order = alloc::collect(0..boxes.len() as u32)?;
    sort::sort_stable(&mut order, &|&a, &b| ends(a)[0].total_cmp(&ends(b)[0]).then(a.cmp(&b)));
    let mut sets = DisjointSets::new(boxes.len())?;
    let mut active: Vec<u32> = alloc::with_capacity(boxes.len())?;
    for (place, &k) in order.iter().enumerate() {
        if place.is_multiple_of(CLUSTERED_BOXES_PER_REPORT) {
            ask()?;
        }
        // The ends are rounded, so keep boxes that just touch.
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
        let (low, high) = (part.middle - part.half_size, part.middle + part.half_size);
        let root = sets.find(k as u32) as usize;
        if root == k {
            cluster_of[k] = clusters.len() as u32;
            alloc::push(clusters, UnresolvedCluster { best_box: *part, low, high })?;
        } else {
            cluster_of[k] = cluster_of[root];
            let cluster = &mut clusters[cluster_of[k] as usize];
            if part.residual < cluster.best_box.residual {
                cluster.best_box = *part;
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

    /// Solves x^2 = 2 over an interval, from the values at the ends of its parts.
    struct SquareRootSystem {
        found: Vec<f64>,
        given_up: Vec<[f64; 2]>,
        examined: usize,
    }

    impl Subdivision<[f64; 2], 2> for SquareRootSystem {
        type Solution = f64;
        type Split = ();
        type Stop = ();

        fn classify_box(&mut self, &[low, high]: &[f64; 2]) -> Result<BoxTest<f64, ()>, ()> {
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

        fn record_solution(&mut self, [low, high]: [f64; 2], root: f64) -> Result<(), ()> {
            assert!((low..=high).contains(&root));
            self.found.push(root);
            Ok(())
        }

        fn record_unresolved(&mut self, part: [f64; 2], exhausted: bool) -> Result<(), ()> {
            self.given_up.push(part);
            if exhausted { Err(()) } else { Ok(()) }
        }

        fn split_box(&mut self, [low, high]: [f64; 2], (): ()) -> [[f64; 2]; 2] {
            let middle = 0.25 * low + 0.75 * high;
            [[middle, high], [low, middle]]
        }
    }

    fn square_roots(max_depth: u32, max_boxes: usize) -> (SquareRootSystem, Result<(), ()>) {
        let mut problem = SquareRootSystem { found: Vec::new(), given_up: Vec::new(), examined: 0 };
        let done = subdivide(&mut problem, [-3.0, 9.0], &mut Vec::new(), SubdivisionLimits { max_depth, max_boxes });
        (problem, done)
    }

    #[test]
    fn all_solutions_are_found_in_order() {
        let (problem, done) = square_roots(40, 1000);
        assert_eq!(problem.found, [-(2.0_f64.sqrt()), 2.0_f64.sqrt()]);
        assert!(problem.given_up.is_empty() && done.is_ok());
    }

    #[test]
    fn limits_hold_and_no_box_is_dropped() {
        let (problem, done) = square_roots(0, 1000);
        assert_eq!((problem.given_up.as_slice(), done), ([[-3.0, 9.0]].as_slice(), Ok(())));
        let (problem, done) = square_roots(40, 1);
        assert_eq!((problem.examined, problem.given_up.len(), done), (1, 1, Err(())));
    }

    #[test]
    fn touching_boxes_form_one_cluster() {
        let part = |x: f64, y: f64, residual: f64| UnresolvedBox {
            middle: DVec2::new(x, y).extend(0.0),
            half_size: DVec2::splat(0.5).extend(0.0),
            residual,
        };
        // Two rows that a later box connects, and an isolated box.
        let boxes = [
            part(0.0, 0.0, 3.0),
            part(9.0, 9.0, 0.0),
            part(0.0, 2.0, 1.0),
            part(1.0, 0.0, 2.0),
            part(1.0, 2.0, 1.0),
            part(2.0, 1.0, 5.0),
        ];
        let mut clusters = Vec::new();
        assert_eq!(cluster_touching_boxes(&boxes, &mut clusters, || Ok(())).unwrap(), [0, 1, 0, 0, 0, 0]);
        assert_eq!(clusters.len(), 2);
        assert_eq!((clusters[0].best_box.middle, clusters[0].best_box.residual), (boxes[2].middle, 1.0));
        assert_eq!((clusters[0].low, clusters[0].high), (DVec3::new(-0.5, -0.5, 0.0), DVec3::new(2.5, 2.5, 0.0)));
        assert_eq!((clusters[1].low, clusters[1].high), (DVec3::new(8.5, 8.5, 0.0), DVec3::new(9.5, 9.5, 0.0)));
    }
}
