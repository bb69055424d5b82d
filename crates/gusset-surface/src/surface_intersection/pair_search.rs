//! All arcs of the intersection of a pair of cells. [`subdivide`] halves boxes of the four
//! parameters across their longest sides.
//!
//! A box is decided if it is proven to contain no solution, or if its solutions are proven to form
//! a graph (`solution_chart`) whose arc is found (`arc_search`). A box is unresolved if the two
//! pieces over it are within the tolerance of each other everywhere: the surfaces touch there, or
//! coincide. Cost: O(N^2) for a test, O(N^3) for a split, at most `max_boxes` boxes.

use super::arc_refinement::ArcRefinement;
use super::arc_search::{ArcBoxSearch, ArcEnd, MAX_CROSSING_PARAMETER_ROUNDING};
use super::intersection_equation::IntersectionEquation;
use super::solution_chart::ParameterBox;
use crate::Patch;
use glam::{DVec3, DVec4};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::subdivision::{BoxTest, Subdivision, SubdivisionLimits, subdivide};
use gusset_base::job::Job;
use std::borrow::Cow;

/// Number of boxes after which the cells are tested for multiple contacts and for zero area.
/// Transversal intersections need fewer boxes.
const BOXES_BEFORE_DEGENERACY_TEST: usize = 12;

/// In boxes up to this many tolerances long, the search does not report a contact if the surfaces
/// are transversal and proved apart. The width of a contact is the square root of the tolerance
/// times the radius of curvature.
const MAX_SLENDER_BOX_IN_TOLERANCES: f64 = 64.0;
/// In boxes up to this many resolutions long, the search does not report a contact if the surfaces
/// are proved apart.
const MAX_CONTACT_EXCLUDING_BOX_IN_RESOLUTIONS: f64 = 4.0;
/// Thickness of pieces below which they are not halved further, in tolerances. It is smaller than
/// the lens between surfaces that overlap by more than the tolerance, so the complete rim of a lens
/// is found.
const MIN_HALVED_THICKNESS_IN_TOLERANCES: f64 = 1.0 / 32.0;

/// Boxes smaller than this in a parameter are halved in another parameter.
const MIN_HALVED_PARAMETER_SIZE: f64 = 1e-8;
/// A curve may run along a side if both ends are within this distance of it, in parameters.
const MAX_ALONG_SIDE_DISTANCE: f64 = 1e-6;
/// Largest slope of a curve that runs along a side, in parameters.
const MAX_ALONG_SIDE_SLOPE: f64 = 1e-2;

/// Number of boxes of a pair between two progress reports.
const BOXES_PER_REPORT: usize = 1 << 10;

/// Largest number of separate balls of one pair.
const MAX_BALLS_PER_PAIR: usize = 64;

/// An arc of the intersection over one pair of cells, in the direction N_A x N_B.
#[derive(Debug, Clone, Copy)]
pub(super) struct IntersectionArc {
    /// The index of the pair.
    pub(super) pair: u32,
    /// The range of its points in [`FoundArcsAndBalls`].
    pub(super) first_point: u32,
    pub(super) end_point: u32,
    /// The first and the last point, and the directions at them.
    pub(super) ends: [DVec3; 2],
    pub(super) directions: [DVec3; 2],
    /// Whether each end is on the border of a sheet.
    pub(super) at_border: [bool; 2],
    /// Whether the arc was cut at each end.
    pub(super) is_cut: [bool; 2],
    /// Whether the arc is a closed curve around a closed cell.
    pub(super) is_closed: bool,
    /// Whether both ends are on one side of its box. The adjacent box may then find the arc too.
    pub(super) is_along_side: bool,
}

impl IntersectionArc {
    /// The number of points.
    pub(super) fn point_count(&self) -> usize {
        (self.end_point - self.first_point) as usize
    }
}

/// A ball around a place where cells touch, or may touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct UnresolvedBall {
    pub(super) pair: u32,
    pub(super) parameters: DVec4,
    pub(super) centre: DVec3,
    pub(super) radius: f64,
    /// Distance between the cells at x.
    pub(super) gap: f64,
    /// The box of the parameters.
    pub(super) low: DVec4,
    pub(super) high: DVec4,
    /// Whether the ball represents both whole cells.
    pub(super) is_whole: bool,
}

/// The arcs and the unresolved balls of some pairs.
#[derive(Debug, Default)]
pub(super) struct FoundArcsAndBalls {
    pub(super) points: Vec<DVec4>,
    pub(super) arcs: Vec<IntersectionArc>,
    pub(super) balls: Vec<UnresolvedBall>,
    /// Pairs that need more boxes than permitted.
    pub(super) exhausted_pairs: Vec<u32>,
}

impl FoundArcsAndBalls {
    /// The numbers of points, arcs and balls.
    fn item_counts(&self) -> [usize; 3] {
        [self.points.len(), self.arcs.len(), self.balls.len()]
    }

    /// Removes all points, arcs and balls beyond the given counts.
    fn truncate_to_counts(&mut self, [points, arcs, balls]: [usize; 3]) {
        self.points.truncate(points);
        self.arcs.truncate(arcs);
        self.balls.truncate(balls);
    }

    /// Adds the arcs and balls of other pairs.
    pub(super) fn append_arcs(&mut self, other: &FoundArcsAndBalls) -> Result<()> {
        let before = self.points.len() as u32;
        alloc::append(&mut self.points, &other.points)?;
        let moved = |arc: &IntersectionArc| {
            let [first_point, end_point] = [arc.first_point, arc.end_point].map(|point| point + before);
            IntersectionArc { first_point, end_point, ..*arc }
        };
        alloc::extend(&mut self.arcs, other.arcs.iter().map(moved))?;
        alloc::append(&mut self.balls, &other.balls)?;
        alloc::append(&mut self.exhausted_pairs, &other.exhausted_pairs)
    }
}

/// The parameters for solving a pair of cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellPairTask {
    pub(super) pair: u32,
    /// For each parameter, whether the sheet has another cell before and after.
    pub(super) neighbours: [[bool; 2]; 4],
    /// Distance up to which surfaces may touch.
    pub(super) tolerance: f64,
    /// Accuracy of ends; at most the tolerance.
    pub(super) resolution: f64,
    /// Length up to which arcs may be lost.
    pub(super) max_lost_length: f64,
    /// Largest distance of a chord from the curve.
    pub(super) chord_tolerance: f64,
    /// Largest number of boxes to examine.
    pub(super) max_boxes: usize,
    /// Whether boxes beyond the limit are reported; else the pair is added to `exhausted_pairs`.
    pub(super) is_last_round: bool,
    /// Length up to which a difference may be rounding.
    pub(super) rounding_error: f64,
}

impl CellPairTask {
    /// Whether each end of an arc is on a side without another cell beyond it. A side along which
    /// the arc runs does not count.
    fn are_ends_at_border(&self, ends: [DVec4; 2], is_along_side: bool) -> [bool; 2] {
        let sides = |x: f64, slack: f64| [x <= slack, x >= 1.0 - slack];
        // A short arc that ends at a side has both ends close to it.
        let run = (ends[1] - ends[0]).abs();
        let is_level = |k: usize| run[k] <= MAX_ALONG_SIDE_SLOPE * run.max_element();
        let runs_along = |k: usize, side: usize| {
            is_along_side && is_level(k) && ends.iter().all(|x| sides(x[k], MAX_ALONG_SIDE_DISTANCE)[side])
        };
        let ends_at = |x: DVec4, k: usize, side: usize| {
            sides(x[k], MAX_CROSSING_PARAMETER_ROUNDING)[side] && !self.neighbours[k][side] && !runs_along(k, side)
        };
        ends.map(|x| (0..4).any(|k| (0..2).any(|side| ends_at(x, k, side))))
    }

    /// Adds the arcs of the pair.
    pub(super) fn solve_pair<const N: usize, const M: usize>(
        &self,
        whole: &ParameterBox<N, M>,
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut search = self.begin_search(&whole.nets, pieces, job);
        // Most pairs have one box, so it is borrowed and no memory is allocated.
        let outcome = search.search_box(Cow::Borrowed(whole));
        search.finish_pair(outcome, whole)
    }

    /// Begins a search whose boxes share the limit of the pair. The caller runs it.
    pub(super) fn begin_search<'a, const N: usize, const M: usize>(
        &'a self,
        equation: &'a IntersectionEquation<N, M>,
        found: &'a mut FoundArcsAndBalls,
        job: &'a Job<'a>,
    ) -> CellPairSearch<'a, N, M> {
        let counts_before = found.item_counts();
        CellPairSearch { task: self, equation, counts_before, examined: 0, splits_widest_range: false, found, job }
    }
}

/// The largest distance of control points from a point.
fn max_control_distance<const N: usize>(centre: DVec3, patch: &Patch<N>) -> f64 {
    patch.points.as_flattened().iter().map(|corner| corner.distance(centre)).fold(0.0, f64::max)
}

/// The search in one pair of cells.
pub(super) struct CellPairSearch<'a, const N: usize, const M: usize> {
    task: &'a CellPairTask,
    equation: &'a IntersectionEquation<N, M>,
    /// The counts before the search.
    counts_before: [usize; 3],
    examined: usize,
    /// Whether boxes are split across the widest range instead of the longest side.
    splits_widest_range: bool,
    found: &'a mut FoundArcsAndBalls,
    job: &'a Job<'a>,
}

/// The reason why a search ends early.
pub(super) enum SearchStop {
    /// The cells touch at many places, or have zero area.
    Degenerate,
    /// The limit of boxes is reached.
    Exhausted,
    Failed(Error),
}

impl From<Error> for SearchStop {
    fn from(error: Error) -> Self {
        SearchStop::Failed(error)
    }
}

impl<'a, const N: usize, const M: usize> Subdivision<Cow<'a, ParameterBox<N, M>>, 2> for CellPairSearch<'_, N, M> {
    /// The ends of an arc, and its free parameter.
    type Solution = ([ArcEnd; 2], usize);
    /// The parameter to halve.
    type Split = usize;
    type Stop = SearchStop;

    fn classify_box(
        &mut self,
        part: &Cow<'a, ParameterBox<N, M>>,
    ) -> Result<BoxTest<([ArcEnd; 2], usize), usize>, SearchStop> {
        let (CellPairTask { tolerance, resolution, rounding_error, .. }, equation) = (*self.task, self.equation);
        self.examined += 1;
        if self.examined.is_multiple_of(BOXES_PER_REPORT) {
            self.report_progress()?;
        }
        let has_no_area = || equation.a.to_patch().has_zero_area() && equation.b.to_patch().has_zero_area();
        if self.examined == BOXES_BEFORE_DEGENERACY_TEST && (has_no_area() || self.do_cells_coincide()) {
            return Err(SearchStop::Degenerate);
        }
        if self.examined > self.task.max_boxes {
            return if self.task.is_last_round { Ok(BoxTest::Unresolved) } else { Err(SearchStop::Exhausted) };
        }
        // If half of the boxes did not resolve a contact, more will not. The other half is spent on
        // branches elsewhere, and contacts are left unresolved at the tolerance.
        let is_put_back = !self.task.is_last_round && resolution < tolerance;
        let is_fine = self.examined <= self.task.max_boxes / 2 || is_put_back;
        let frame = equation.frame_at(part.middle_point());
        let mut unclear = None;
        match part.prove_empty_or_graph(&frame, rounding_error, if is_fine { tolerance } else { rounding_error }) {
            BoxTest::Empty => {
                // Separated, but by less than an option that is greater than the surfaces' own
                // tolerance.
                let is_near = !is_fine && resolution < tolerance && !frame.is_transversal();
                let touches = is_near && part.are_pieces_flat_and_close(&frame, tolerance, tolerance);
                return Ok(if touches { BoxTest::Unresolved } else { BoxTest::Empty });
            }
            BoxTest::Unique(chart) => {
                let search =
                    ArcBoxSearch::new(equation, part, &chart, [resolution, self.task.max_lost_length], rounding_error);
                let arc_test = match search.find_arc_along_line(&frame) {
                    Some(arc_test) => arc_test,
                    None if part.is_proven_empty_otherwise(&frame, rounding_error) => BoxTest::Empty,
                    None => search.find_arc_from_inside(&frame),
                };
                match arc_test {
                    BoxTest::Empty => return Ok(BoxTest::Empty),
                    BoxTest::Unique(ends) => return Ok(BoxTest::Unique((ends, chart.free_parameter))),
                    BoxTest::Undecided(k) => unclear = k,
                    _ => {}
                }
            }
            _ => {}
        }
        let extents = part.piece_extents();
        let longest = (0..4).fold(0, |best, k| if extents[k] > extents[best] { k } else { best });
        let is_slender = extents[longest] <= MAX_SLENDER_BOX_IN_TOLERANCES * tolerance && frame.is_transversal();
        let may_exclude_contact = extents[longest] <= MAX_CONTACT_EXCLUDING_BOX_IN_RESOLUTIONS * resolution;
        if (may_exclude_contact || is_slender)
            && matches!(part.prove_empty_or_graph(&frame, rounding_error, rounding_error), BoxTest::Empty)
        {
            return Ok(BoxTest::Empty);
        }
        let [thickness, reach] = match is_fine {
            true => [(MIN_HALVED_THICKNESS_IN_TOLERANCES * tolerance).max(4.0 * rounding_error), tolerance],
            false => [tolerance, -tolerance],
        };
        // Beside poles, and in cells that are small relative to the tolerance, crossing pieces may
        // be as thin in both directions.
        let unresolved = extents[longest] <= 0.25 * resolution
            || !is_slender && part.are_pieces_flat_and_close(&frame, thickness, reach);
        let widest = || (0..4).fold(longest, |best, k| if part.size[k] > part.size[best] { k } else { best });
        // Near poles, pieces are too short in one direction for it ever to be the longest one.
        let is_long = |&k: &usize| part.size[k] > MIN_HALVED_PARAMETER_SIZE && frame.is_transversal();
        let split = if self.splits_widest_range { widest() } else { unclear.filter(is_long).unwrap_or(longest) };
        Ok(if unresolved { BoxTest::Unresolved } else { BoxTest::Undecided(split) })
    }

    /// Adds an arc, unless it is short enough to be dropped.
    fn record_solution(
        &mut self,
        part: Cow<'a, ParameterBox<N, M>>,
        (ends, free): ([ArcEnd; 2], usize),
    ) -> Result<(), SearchStop> {
        // The ends come by rising free parameter, but the curve runs along N_A x N_B.
        let rises = ends[0].tangent[free] > 0.0;
        let ends = if rises { ends } else { [ends[1], ends[0]] };
        let (equation, points) = (self.equation, &mut self.found.points);
        let places = ends.map(|end| equation.point_of_first_patch(end.parameters));
        let is_near = |point: DVec3| places[0].distance(point) <= self.task.max_lost_length;
        let is_closed = is_near(places[1]);
        // The point half way around the curve, if the arc is not a single point.
        let middle = ends[0].parameters.midpoint(ends[1].parameters);
        let half_way = || equation.solve_with_fixed_parameter(middle, free).map(|(x, _)| x);
        let is_within = |x: DVec4| (x - 0.5).abs().max_element() <= 0.5 + MAX_CROSSING_PARAMETER_ROUNDING;
        let is_away = |x: &DVec4| is_within(*x) && !is_near(equation.point_of_first_patch(*x));
        let away = if is_closed { half_way().filter(is_away) } else { None };
        if is_closed && away.is_none() {
            return Ok(());
        }
        let from = points.len() as u32;
        alloc::push(points, ends[0].parameters)?;
        ArcRefinement { equation, free, chord_tolerance: self.task.chord_tolerance }
            .insert_points(ends, places, points)?;
        if let Some(away) = away.filter(|_| points.len() as u32 == from + 1) {
            alloc::push(points, away)?;
        }
        alloc::push(points, ends[1].parameters)?;
        let to = points.len() as u32;
        let pair = self.task.pair;
        let is_along_side =
            !is_closed && part.are_points_on_one_side(ends.map(|end| end.parameters), MAX_ALONG_SIDE_DISTANCE);
        let at_border = self.task.are_ends_at_border(ends.map(|end| end.parameters), is_along_side);
        // Directions from the last Newton iterate are off by the last step divided by the distance
        // from a crossing.
        let exact = |end: ArcEnd| {
            if is_along_side { equation.frame_at(end.parameters).curve_direction() } else { end.direction }
        };
        let directions = ends.map(|end| exact(end).normalize_or_zero());
        let ends = places;
        let arc = IntersectionArc {
            pair,
            first_point: from,
            end_point: to,
            ends,
            directions,
            at_border,
            is_cut: [false; 2],
            is_closed,
            is_along_side,
        };
        Ok(alloc::push(&mut self.found.arcs, arc)?)
    }

    fn record_unresolved(&mut self, part: Cow<'a, ParameterBox<N, M>>, _exhausted: bool) -> Result<(), SearchStop> {
        self.report_ball(&part, false);
        Ok(())
    }

    fn split_box(&mut self, part: Cow<'a, ParameterBox<N, M>>, longest: usize) -> [Cow<'a, ParameterBox<N, M>>; 2] {
        let [low, high] = part.halve_by_parameter(longest);
        [Cow::Owned(high), Cow::Owned(low)]
    }
}

impl<const N: usize, const M: usize> CellPairSearch<'_, N, M> {
    /// Finds the arcs in a box.
    fn search_box(&mut self, part: Cow<'_, ParameterBox<N, M>>) -> Result<(), SearchStop> {
        let limits = SubdivisionLimits { max_depth: u32::MAX, max_boxes: usize::MAX };
        subdivide(self, part, &mut Vec::new(), limits)
    }

    /// Finds the arcs in a box of a pair of cells with common points. Multiple contacts mean
    /// nothing for such cells. Boxes closer to a pinch point are more elongated, which does not
    /// affect the proofs.
    pub(super) fn search_box_of_adjacent_cells(&mut self, part: &ParameterBox<N, M>) -> Result<(), SearchStop> {
        self.examined = self.examined.max(BOXES_BEFORE_DEGENERACY_TEST);
        self.splits_widest_range = true;
        self.search_box(Cow::Borrowed(part))
    }

    /// Reports progress. The remaining work of a pair is unknown.
    pub(super) fn report_progress(&self) -> Result<()> {
        self.job.step(0.0, "intersection")
    }

    /// Ends the search in a pair.
    #[expect(clippy::needless_pass_by_value, reason = "what a search ends with ends here")]
    pub(super) fn finish_pair(mut self, done: Result<(), SearchStop>, whole: &ParameterBox<N, M>) -> Result<()> {
        match done {
            Ok(()) => Ok(()),
            Err(SearchStop::Degenerate) => {
                self.found.truncate_to_counts(self.counts_before);
                self.report_ball(whole, true);
                Ok(())
            }
            Err(SearchStop::Exhausted) => {
                self.found.truncate_to_counts(self.counts_before);
                alloc::push(&mut self.found.exhausted_pairs, self.task.pair)
            }
            Err(SearchStop::Failed(error)) => Err(error),
        }
    }

    /// Reports a box as a ball around it. Merges balls of the same pair that touch.
    pub(super) fn report_ball(&mut self, part: &ParameterBox<N, M>, is_whole: bool) {
        let (CellPairTask { pair, resolution, .. }, equation) = (*self.task, self.equation);
        let x = part.middle_point();
        let frame = equation.frame_at(x);
        // Common points lie in both pieces. If one piece is much smaller, it locates them better.
        let (a, b) = (equation.point_of_first_patch(x), equation.point_of_first_patch(x) - frame.difference);
        let (of_a, of_b) =
            (max_control_distance(a, &part.nets.a.to_patch()), max_control_distance(b, &part.nets.b.to_patch()));
        let (centre, radius) = if of_a <= 2.0 * of_b { (a, of_a) } else { (b, of_b) };
        let gap = frame.difference.length();
        let (low, high) = (part.low, part.low + part.size);
        let ball = UnresolvedBall { pair, parameters: x, centre, radius, gap, low, high, is_whole };
        let own = &mut self.found.balls[self.counts_before[2]..];
        let touches = |other: &UnresolvedBall| other.centre.distance(centre) <= other.radius + radius + resolution;
        // Beyond the largest number of separate balls, the nearest ball absorbs the new one.
        let beyond = |ball: &UnresolvedBall| ball.centre.distance(centre) - ball.radius;
        let nearest = || (0..own.len()).min_by(|&k, &n| beyond(&own[k]).total_cmp(&beyond(&own[n])));
        let target = own.iter().position(touches).or_else(|| nearest().filter(|_| own.len() >= MAX_BALLS_PER_PAIR));
        match target {
            Some(k) => {
                let nearer = if gap < own[k].gap { ball } else { own[k] };
                let radius = |ball: &UnresolvedBall| nearer.centre.distance(ball.centre) + ball.radius;
                own[k] = UnresolvedBall {
                    radius: radius(&ball).max(radius(&own[k])),
                    low: low.min(own[k].low),
                    high: high.max(own[k].high),
                    is_whole: is_whole || own[k].is_whole,
                    ..nearer
                };
            }
            None => self.found.balls.push(ball),
        }
    }

    /// Whether a few sample points show that the cells touch in at least three places. More
    /// subdivision would then be useless.
    fn do_cells_coincide(&self) -> bool {
        let mut contacts = [DVec3::ZERO; 3];
        let mut count = 0;
        for k in 0..18 {
            let (along, across) = (0.5 * f64::from(k / 3 % 3), 0.5 * f64::from(k % 3));
            let Some(contact) = self.contact_point_at(along, across, k < 9) else {
                continue;
            };
            if contacts[..count].iter().all(|other| other.distance(contact) > 64.0 * self.task.tolerance) {
                contacts[count] = contact;
                count += 1;
            }
            if count == 3 {
                return true;
            }
        }
        false
    }

    /// The point of one cell at the given parameters, if the other cell touches it there.
    fn contact_point_at(&self, along: f64, across: f64, on_a: bool) -> Option<DVec3> {
        let equation = self.equation;
        let fixed = if on_a { 0 } else { 2 };
        let mut x = DVec4::splat(0.5);
        (x[fixed], x[fixed + 1]) = (along, across);
        let (p, q) = (2 - fixed, 3 - fixed);
        for _ in 0..8 {
            let frame = equation.frame_at(x);
            let [a, b] = frame.normals();
            let (one, other) = (frame.derivatives[p], frame.derivatives[q]);
            if frame.difference.length() <= self.task.tolerance {
                let touches = a.cross(b).length() <= 1e-4 * a.length() * b.length();
                return touches.then(|| equation.point_of_first_patch(x));
            }
            // A Gauss-Newton step towards the nearest point.
            let (aa, ab, bb) = (one.length_squared(), one.dot(other), other.length_squared());
            let determinant = aa * bb - ab * ab;
            let (f, g) = (frame.difference.dot(one), frame.difference.dot(other));
            x[p] = (x[p] - (f * bb - g * ab) / determinant).clamp(0.0, 1.0);
            x[q] = (x[q] - (g * aa - f * ab) / determinant).clamp(0.0, 1.0);
            if !x.is_finite() {
                return None;
            }
        }
        None
    }
}
