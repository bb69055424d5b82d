//! Which vertices of two loops face each other: the paper's algorithm 2, corrected.
//!
//! Each loop has a centre C, the mean of its vertices (5). The vectors between the centres, a_1 =
//! C_2 - C_1 and a_2 = -a_1 (6), are the normals of two planes through the centres (7). A vertex
//! faces the other loop if it lies on that loop's side of its own plane: (V - C) . a > 0.
//!
//! Where the paper's text does not suffice:
//!
//! * **Undecided planes.** Two coaxial rims lie in their planes, the commonest case of all, and the
//!   sign is round-off. So a vertex faces the other loop if its distance from the plane is more
//!   than a tolerance, and where no vertex of a loop is farther from its plane than that, or the
//!   centres coincide, the planes cannot decide, which is said.
//! * **Runs.** The vertices that face the other loop need not be neighbours. They fall into runs;
//!   the one with the closest pair of vertices is taken, or the longest.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::{Element, Error, Result, Side};
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::Scalar;
use std::ops::Range;

/// Looks at points between two progress reports, if a search looks at all of them.
const REPORT_INTERVAL: usize = 1 << 23;

const STAGE: &str = "looking for facing arcs";

/// Two planes, each through a loop's centre and perpendicular to the line of the centres: equations
/// 5 to 7.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planes {
    /// C_1 and C_2.
    pub centres: [DVec3; 2],
    /// a_1 = C_2 - C_1 and a_2 = C_1 - C_2.
    pub normals: [DVec3; 2],
}

impl Planes {
    /// The planes of two loops.
    pub fn of(a: &[DVec3], b: &[DVec3], centres: Centres) -> Self {
        let centre = match centres {
            Centres::Vertices => centre,
            Centres::Length => centre_of_length,
        };
        let centres = [centre(a), centre(b)];
        Planes { centres, normals: [centres[1] - centres[0], centres[0] - centres[1]] }
    }

    /// The distance of `p` from the plane of loop `side`, positive on the side of the other loop; 0
    /// if the centres coincide.
    pub fn distance(&self, side: Side, p: DVec3) -> f64 {
        let k = side as usize;
        (p - self.centres[k]).dot(self.normals[k].normalize_or_zero())
    }
}

/// Equation 5: the mean of the vertices.
pub fn centre(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// The mean of a closed polyline's points, which vertices that lie close together do not draw to
/// them; the mean of the vertices if it has no length.
pub fn centre_of_length(points: &[DVec3]) -> DVec3 {
    let n = points.len();
    let edges = (0..n).map(|i| (points[i], points[(i + 1) % n]));
    let (sum, length) = edges.fold((DVec3::ZERO, 0.0), |(sum, length), (p, q)| {
        let edge = p.distance(q);
        (sum + p.midpoint(q) * edge, length + edge)
    });
    if length > 0.0 { sum / length } else { centre(points) }
}

/// What the centre of a loop is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Centres {
    /// The mean of its vertices, as the paper has it: equation 5.
    #[default]
    Vertices,
    /// The mean of its points, whatever the spacing of its vertices.
    Length,
}

choices! { for Centres:
    Vertices => "Mean of the points", "As in the paper.";
    Length => "Mean of the curve", "Independent of the spacing of the points.";
}

/// How facing vertices are found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// Which run is taken.
    pub run: Run,
    /// A vertex must be farther from its plane than this, in the unit of the points; `None` for
    /// what round-off of double precision can do.
    pub tolerance: Option<f64>,
    /// The loops' centres.
    pub centres: Centres,
}

/// Which of several runs is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Run {
    /// On each loop the one with the closest pair of facing vertices.
    #[default]
    Closest,
    /// On each loop the one of the most vertices, of equal ones the first.
    Longest,
}

choices! { for Run:
    Closest => "Closest", "The one with the closest pair of points.";
    Longest => "Longest", "The one with the most points.";
}

/// An arc of a loop: its first place and its number of vertices. It may pass the loop's end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Arc {
    /// The place of its first vertex.
    pub first: usize,
    /// Its number of vertices, at most the loop's.
    pub count: usize,
}

/// What algorithm 2 found.
#[derive(Debug, Clone, PartialEq)]
pub struct Facing {
    /// The planes.
    pub planes: Planes,
    /// The distance of each vertex of each loop from its plane, positive on the side of the other
    /// loop.
    pub distances: [Vec<f64>; 2],
    /// All runs of facing vertices, for each loop, in order of their first places (a run that
    /// passes the loop's end last).
    pub runs: [Vec<Arc>; 2],
    /// The run taken on each loop.
    pub taken: [Arc; 2],
}

/// Finds the runs of vertices of loop `a` and of loop `b` that face the other loop; O((N + M) log
/// M).
///
/// # Errors
/// [`Error::LoopTooShort`] for a loop without vertices, [`Error::NotFinite`],
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or not finite;
/// [`Error::PlanesUndecided`] with the loop that has no vertex beyond the tolerance, or if the
/// centres are no farther apart than that; [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn facing(a: &[DVec3], b: &[DVec3], options: &Options, job: &Job<'_>) -> Result<Facing> {
    job.step(0.0, STAGE)?;
    for (side, points) in [(Side::A, a), (Side::B, b)] {
        if points.is_empty() {
            return Err(Error::LoopTooShort { side, count: 0 });
        }
        check_points(side, points)?;
    }
    check_tolerance(options.tolerance)?;
    // In a unit in which products neither overflow nor vanish.
    let unit = common_unit(a.iter().chain(b));
    let small = |points: &[DVec3]| alloc::collect(points.iter().map(|&p| p / unit));
    let (small_a, small_b) = (small(a)?, small(b)?);
    let limit = options.tolerance.map_or(2.0 * round_off(Scalar::F64), |t| t / unit);
    let planes = Planes::of(&small_a, &small_b, options.centres);
    let mut found = facing_in_unit(&small_a, &small_b, planes, limit, options.run, &job.part(0.1, 1.0))?;
    found.planes.centres = found.planes.centres.map(|c| c * unit);
    found.planes.normals = found.planes.normals.map(|n| n * unit);
    found.distances.iter_mut().flatten().for_each(|d| *d *= unit);
    Ok(found)
}

/// # Errors
/// [`Error::NotFinite`].
pub(super) fn check_points(side: Side, points: &[DVec3]) -> Result<()> {
    let mut numbered = (0..).zip(points);
    numbered.try_for_each(|(i, &p)| Error::check_finite(Element::LoopPoint(side), i, p))
}

/// Of the largest coordinate: less than this is round-off, 64 units in the last place of the host's
/// own numbers.
pub(super) fn round_off(scalar: Scalar) -> f64 {
    64.0 * match scalar {
        Scalar::F32 => f64::from(f32::EPSILON),
        Scalar::F64 => f64::EPSILON,
    }
}

/// # Errors
/// [`Error::OptionOutOfRange`].
pub(super) fn check_tolerance(tolerance: Option<f64>) -> Result<()> {
    let value = tolerance.unwrap_or(0.0);
    Error::require((0.0..f64::INFINITY).contains(&value), "tolerance", value)
}

/// Algorithm 2 on points whose coordinates are at most 2.
pub(super) fn facing_in_unit(
    a: &[DVec3],
    b: &[DVec3],
    planes: Planes,
    tolerance: f64,
    run: Run,
    job: &Job<'_>,
) -> Result<Facing> {
    if planes.normals[0].length() <= tolerance {
        return Err(Error::PlanesUndecided { side: Side::A });
    }
    let distances = |side, points: &[DVec3]| alloc::collect(points.iter().map(|&p| planes.distance(side, p)));
    let distances = [distances(Side::A, a)?, distances(Side::B, b)?];
    let runs_of = |list: &[f64]| cyclic_runs(list, |&d| d > tolerance);
    let runs = [runs_of(&distances[0])?, runs_of(&distances[1])?];
    for side in [Side::A, Side::B] {
        if runs[side as usize].is_empty() {
            return Err(Error::PlanesUndecided { side });
        }
    }
    let taken = match run {
        Run::Longest => [longest(&runs[0]), longest(&runs[1])],
        Run::Closest => closest(a, b, &runs, job)?,
    };
    Ok(Facing { planes, distances, runs, taken })
}

/// The runs of values that have a property, round a cycle.
pub fn cyclic_runs<T>(values: &[T], has: impl Fn(&T) -> bool) -> Result<Vec<Arc>> {
    let n = values.len();
    // Start behind a gap, so that no run is cut in two.
    let Some(gap) = values.iter().position(|value| !has(value)) else {
        return Ok(vec![Arc { first: 0, count: n }]);
    };
    let mut runs: Vec<Arc> = Vec::new();
    for place in (gap + 1..gap + n).map(|i| i % n).filter(|&i| has(&values[i])) {
        match runs.last_mut() {
            Some(run) if (run.first + run.count) % n == place => run.count += 1,
            _ => alloc::push(&mut runs, Arc { first: place, count: 1 })?,
        }
    }
    sort::stable(&mut runs, &|a, b| a.first.cmp(&b.first));
    Ok(runs)
}

fn longest(runs: &[Arc]) -> Arc {
    runs.iter().copied().rev().max_by_key(|run| run.count).unwrap_or(Arc { first: 0, count: 0 })
}

/// The runs that contain the closest pair of facing vertices.
fn closest(a: &[DVec3], b: &[DVec3], runs: &[Vec<Arc>; 2], job: &Job<'_>) -> Result<[Arc; 2]> {
    let total = runs[1].iter().map(|run| run.count).sum();
    let (mut points, mut owner) = (alloc::with_capacity(total)?, alloc::with_capacity(total)?);
    for (k, run) in runs[1].iter().enumerate() {
        points.extend(run.places(b.len()).map(|j| b[j]));
        owner.extend((0..run.count).map(|_| k));
    }
    let tree = KdTree::boxed(&points, &job.part(0.0, 0.5), STAGE)?;
    let job = job.part(0.5, 1.0);
    let interval = (REPORT_INTERVAL / total.max(1)).clamp(1, 1 << 12);
    let (mut best, mut done) = ((f64::INFINITY, [0, 0]), 0);
    for (k, run) in runs[0].iter().enumerate() {
        for i in run.places(a.len()) {
            job.step_every(interval, done, a.len(), STAGE)?;
            done += 1;
            if let Some((distance, j)) = tree.nearest(a[i], best.0, |_| true)
                && distance < best.0
            {
                best = (distance, [k, owner[j as usize]]);
            }
        }
    }
    Ok([runs[0][best.1[0]], runs[1][best.1[1]]])
}

impl Arc {
    /// The places of its vertices on a loop of `n`.
    pub fn places(self, n: usize) -> impl ExactSizeIterator<Item = usize> + Clone {
        let range: Range<usize> = 0..self.count;
        range.map(move |k| (self.first + k) % n)
    }
}

/// How well each loop faces the other one: |cosine| of the angle between its normal (the vector
/// area of its polygon) and the line of the centres. 1 for coaxial rims, which are best joined
/// whole; 0 for loops side by side in a plane.
pub fn squareness(points: &[DVec3], planes: &Planes) -> f64 {
    normal(points).dot(planes.normals[0].normalize_or_zero()).abs()
}

/// The direction of the vector area of a closed polyline, seen from its centre; 0 if it has none.
pub(super) fn normal(points: &[DVec3]) -> DVec3 {
    let (n, centre) = (points.len(), centre(points));
    let area: DVec3 = (0..n).map(|i| (points[i] - centre).cross(points[(i + 1) % n] - centre)).sum();
    area.normalize_or_zero()
}
