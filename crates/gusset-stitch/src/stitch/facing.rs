//! Facing arcs of two loops: the paper's algorithm 2, corrected.
//!
//! Each loop has a centre C, the mean of its vertices (5). The vectors between the centres, a_1 =
//! C_2 - C_1 and a_2 = -a_1 (6), are the normals of two planes through the centres (7). A vertex
//! faces the other loop if it lies on the other loop's side of its own plane: (V - C) . a > 0.
//!
//! The paper's text is incomplete in two places:
//!
//! * **Undecided planes.** Two coaxial rims, the most common case, lie in their own planes, so that
//!   round-off decides the sign. Here a vertex faces the other loop only if its distance from the
//!   plane exceeds a tolerance. The planes are undecided if no vertex of a loop exceeds it, or if
//!   the centres coincide; this is an error.
//! * **Runs.** The vertices that face the other loop may form several runs. The run with the
//!   closest pair of vertices is selected, or the longest run.

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

/// Number of visited points between two progress reports, if each search visits all points.
const POINTS_PER_REPORT: usize = 1 << 23;

const STAGE: &str = "looking for facing arcs";

/// Two planes, each through the centre of a loop and perpendicular to the line of centres:
/// equations 5 to 7.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planes {
    /// C_1 and C_2.
    pub centres: [DVec3; 2],
    /// a_1 = C_2 - C_1 and a_2 = C_1 - C_2.
    pub normals: [DVec3; 2],
}

impl Planes {
    /// Creates the planes of two loops.
    pub fn new(a: &[DVec3], b: &[DVec3], centres: Centres) -> Self {
        let centre = match centres {
            Centres::Vertices => centre,
            Centres::Length => length_centre,
        };
        let centres = [centre(a), centre(b)];
        Planes { centres, normals: [centres[1] - centres[0], centres[0] - centres[1]] }
    }

    /// Returns the signed distance of `p` from the plane of loop `side`, positive on the side of
    /// the other loop; 0 if the centres coincide.
    pub fn distance(&self, side: Side, p: DVec3) -> f64 {
        let k = side as usize;
        (p - self.centres[k]).dot(self.normals[k].normalize_or_zero())
    }
}

/// Returns the mean of the vertices: equation 5.
pub fn centre(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// Returns the mean of a closed polyline's points, weighted by length, so that dense vertices do
/// not attract it. Returns the mean of the vertices if the length is 0.
pub fn length_centre(points: &[DVec3]) -> DVec3 {
    let n = points.len();
    let edges = (0..n).map(|i| (points[i], points[(i + 1) % n]));
    let (sum, length) = edges.fold((DVec3::ZERO, 0.0), |(sum, length), (p, q)| {
        let edge = p.distance(q);
        (sum + p.midpoint(q) * edge, length + edge)
    });
    if length > 0.0 { sum / length } else { centre(points) }
}

/// The definition of a loop's centre.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Centres {
    /// The mean of the vertices, as in the paper: equation 5.
    #[default]
    Vertices,
    /// The mean of the curve's points, independent of the spacing of the vertices.
    Length,
}

choices! { for Centres:
    Vertices => "Mean of the points", "As in the paper.";
    Length => "Mean of the curve", "Independent of the spacing of the points.";
}

/// Options of [`facing`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The run to select.
    pub run: Run,
    /// A vertex must be farther from its plane than this, in the unit of the points; `None` for the
    /// round-off of double precision.
    pub tolerance: Option<f64>,
    /// The definition of the loops' centres.
    pub centres: Centres,
}

/// Which of several runs is selected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Run {
    /// On each loop, the run with the closest pair of facing vertices.
    #[default]
    Closest,
    /// On each loop, the run with the most vertices, the first of equals.
    Longest,
}

choices! { for Run:
    Closest => "Closest", "The one with the closest pair of points.";
    Longest => "Longest", "The one with the most points.";
}

/// An arc of a loop: its first place, and its number of vertices. It may wrap around the loop's
/// end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Arc {
    /// The place of the first vertex.
    pub first: usize,
    /// The number of vertices, at most the loop's.
    pub count: usize,
}

/// The result of algorithm 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Facing {
    /// The planes.
    pub planes: Planes,
    /// The signed distance of each vertex of each loop from its plane, positive on the side of the
    /// other loop.
    pub distances: [Vec<f64>; 2],
    /// All runs of facing vertices of each loop, in order of their first places. A run that wraps
    /// around the loop's end comes last.
    pub runs: [Vec<Arc>; 2],
    /// The selected run on each loop.
    pub taken: [Arc; 2],
}

/// Finds the runs of vertices of loop `a` and of loop `b` that face the other loop. O((N + M) log
/// M).
///
/// # Errors
/// * [`Error::LoopTooShort`] for a loop without vertices.
/// * [`Error::OptionOutOfRange`] for a tolerance that is negative or not finite.
/// * [`Error::PlanesUndecided`] for a loop without a vertex beyond the tolerance, or if the
///   distance of the centres is within the tolerance.
/// * [`Error::NotFinite`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn facing(a: &[DVec3], b: &[DVec3], options: &Options, job: &Job<'_>) -> Result<Facing> {
    job.step(0.0, STAGE)?;
    for (side, points) in [(Side::A, a), (Side::B, b)] {
        if points.is_empty() {
            return Err(Error::LoopTooShort { side, count: 0 });
        }
        check_points(side, points)?;
    }
    check_tolerance(options.tolerance)?;
    // Scale to a unit in which products do not overflow or vanish.
    let unit = common_unit(a.iter().chain(b));
    let small = |points: &[DVec3]| alloc::collect(points.iter().map(|&p| p / unit));
    let (small_a, small_b) = (small(a)?, small(b)?);
    let limit = options.tolerance.map_or(2.0 * relative_round_off(Scalar::F64), |t| t / unit);
    let planes = Planes::new(&small_a, &small_b, options.centres);
    let mut facing_runs = find_facing_scaled(&small_a, &small_b, planes, limit, options.run, &job.sub_job(0.1, 1.0))?;
    facing_runs.planes.centres = facing_runs.planes.centres.map(|c| c * unit);
    facing_runs.planes.normals = facing_runs.planes.normals.map(|n| n * unit);
    facing_runs.distances.iter_mut().flatten().for_each(|d| *d *= unit);
    Ok(facing_runs)
}

/// # Errors
/// [`Error::NotFinite`].
pub(super) fn check_points(side: Side, points: &[DVec3]) -> Result<()> {
    let mut numbered = (0..).zip(points);
    numbered.try_for_each(|(i, &p)| Error::check_finite(Element::LoopPoint(side), i, p))
}

/// Returns the round-off relative to the largest coordinate: 64 units in the last place of the
/// scalar type.
pub(super) fn relative_round_off(scalar: Scalar) -> f64 {
    64.0 * match scalar {
        Scalar::F32 => f64::from(f32::EPSILON),
        Scalar::F64 => f64::EPSILON,
    }
}

/// # Errors
/// [`Error::OptionOutOfRange`].
pub(super) fn check_tolerance(tolerance: Option<f64>) -> Result<()> {
    let value = tolerance.unwrap_or(0.0);
    Error::require((0.0..f64::INFINITY).contains(&value), "tolerance", value, "finite and at least 0")
}

/// Runs algorithm 2 on points whose coordinates are at most 2.
pub(super) fn find_facing_scaled(
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
        Run::Longest => [longest_run(&runs[0]), longest_run(&runs[1])],
        Run::Closest => closest_runs(a, b, &runs, job)?,
    };
    Ok(Facing { planes, distances, runs, taken })
}

/// Returns the cyclic runs of values that have a property.
pub fn cyclic_runs<T>(values: &[T], has: impl Fn(&T) -> bool) -> Result<Vec<Arc>> {
    let n = values.len();
    // Start after a gap, so that no run is cut in two.
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
    sort::sort_stable(&mut runs, &|a, b| a.first.cmp(&b.first));
    Ok(runs)
}

fn longest_run(runs: &[Arc]) -> Arc {
    runs.iter().copied().rev().max_by_key(|run| run.count).unwrap_or(Arc { first: 0, count: 0 })
}

/// Returns the runs that contain the closest pair of facing vertices.
fn closest_runs(a: &[DVec3], b: &[DVec3], runs: &[Vec<Arc>; 2], job: &Job<'_>) -> Result<[Arc; 2]> {
    let total = runs[1].iter().map(|run| run.count).sum();
    let (mut points, mut owner) = (alloc::with_capacity(total)?, alloc::with_capacity(total)?);
    for (k, run) in runs[1].iter().enumerate() {
        points.extend(run.places(b.len()).map(|j| b[j]));
        owner.extend((0..run.count).map(|_| k));
    }
    let tree = KdTree::with_range_boxes(&points, &job.sub_job(0.0, 0.5), STAGE)?;
    let job = job.sub_job(0.5, 1.0);
    let interval = (POINTS_PER_REPORT / total.max(1)).clamp(1, 1 << 12);
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
    /// Returns the places of the arc's vertices on a loop of `n` vertices.
    pub fn places(self, n: usize) -> impl ExactSizeIterator<Item = usize> + Clone {
        let range: Range<usize> = 0..self.count;
        range.map(move |k| (self.first + k) % n)
    }
}

/// Returns how squarely a loop faces the other one: the |cosine| of the angle between its normal
/// (the vector area of its polygon) and the line of centres. Coaxial rims give 1, and should be
/// joined whole; loops side by side in a plane give 0.
pub fn squareness(points: &[DVec3], planes: &Planes) -> f64 {
    area_vector_direction(points).dot(planes.normals[0].normalize_or_zero()).abs()
}

/// Returns the direction of a closed polyline's vector area; 0 for a degenerate polyline.
pub(super) fn area_vector_direction(points: &[DVec3]) -> DVec3 {
    let (n, centre) = (points.len(), centre(points));
    let area: DVec3 = (0..n).map(|i| (points[i] - centre).cross(points[(i + 1) % n] - centre)).sum();
    area.normalize_or_zero()
}
