//! Near misses of two curves in space: the minima of their distance, up to a limit.
//!
//! Pairs of parts are halved until a proof holds:
//!
//! - *apart*: the hulls are farther from each other than the limit, along an axis or across both
//!   chords;
//! - *empty*: one of the slopes of f = |A(s) - B(t)|^2 / 2 has a constant sign over the pair, and f
//!   falls into an adjacent part;
//! - *unique*: the Hessian of f is positive definite over the pair, or f falls towards the end of a
//!   segment and is convex along that end. Newton's method then finds the only minimum.
//!
//! All proofs use bounds over the control points. Parts that run beside each other admit none of
//! these proofs. The parts that remain at the smallest size are clustered into overlaps, if the
//! distance has a minimum there and is small enough.
//!
//! Source: Hanniel and Elber, 2007, for halving that ends once at most one solution is proven; the
//! bounds of slopes and Hessian are ours. Cost: at most [`MAX_PART_PAIRS`] pairs of parts for two
//! segments, O(degree^2) each.

use super::intersect::Overlap;
use super::near_miss_bounds::{DescentResult, are_hulls_apart, minimise_distance, proven_minimum_count};
use super::segment_part::{SegmentPart, compare_places, halve_one_of_pair, sort_and_remove_duplicates};
use crate::curve::segment::{self, SegmentBuffer, point_and_derivatives};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::subdivision::{
    BoxStack, BoxTest, Subdivision, SubdivisionLimits, UnresolvedBox, UnresolvedCluster, cluster_touching_boxes,
    subdivide,
};
use gusset_base::geom::{Aabb, box_tree::BoxTree};
use gusset_base::job::Job;
use gusset_base::sort;

/// A local minimum of the distance between two curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearMiss {
    /// The place on the first curve.
    pub a: Place,
    /// The place on the second curve.
    pub b: Place,
    /// The distance between the points at both places.
    pub distance: f64,
}

/// The near misses of two curves.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NearMisses {
    /// The minima, sorted by their places on the first curve.
    pub places: Vec<NearMiss>,
    /// Parts that stay close, or touch so closely that individual places cannot be resolved. The
    /// nearest places of each overlap are among the places. On the second curve, the overlap covers
    /// the places of the close points.
    pub overlaps: Vec<Overlap>,
    /// True if the search gave up on parts that may be close enough and are not among the overlaps.
    pub undecided: bool,
}

/// In a frame of size 1, distances below this count as rounding.
const DISTANCE_ROUNDING: f64 = 1e-12;

/// Parts are not halved below this length of their parameter range.
const MIN_PART_PARAMETER_LENGTH: f64 = 1.0 / 1024.0;

/// The maximum number of pairs of parts examined for two segments.
const MAX_PART_PAIRS: usize = 20_000;

/// The number of undecided pairs of segments after which further pairs get only the effort of
/// simple minima.
const MAX_UNDECIDED_SEGMENT_PAIRS: u32 = 32;

/// The number of pairs of parts that simple minima need.
const MAX_PART_PAIRS_FOR_SIMPLE_MINIMA: usize = 300;

/// Pairs of segments between two progress reports; each pair takes up to 20 ms.
const SEGMENT_PAIRS_PER_REPORT: usize = 4;

/// Descents between two progress reports.
const DESCENTS_PER_REPORT: usize = 256;
const PROGRESS_STAGE: &str = "near misses of curves";

/// Places whose parameters differ by less count as one.
const MAX_SAME_PARAMETER_GAP: f64 = 1e-7;

/// Descents along one valley end within this distance in the parameters.
const MAX_SAME_VALLEY_PARAMETER_GAP: f64 = 1e-5;

/// Slopes below this, relative to the size of the segment and the distance, count as rounding.
const RELATIVE_SLOPE_ROUNDING: f64 = 1e-12;

/// A descent has converged below this slope, relative likewise. Along a valley, the distance
/// reaches rounding before its slope does.
const MAX_CONVERGED_SLOPE: f64 = 1e-6;

/// The smallest determinant of the Hessian, relative to the product of its diagonal, at which a
/// minimum is isolated instead of part of a flat valley.
const MIN_RELATIVE_DETERMINANT: f64 = 1e-12;

/// A minimum of the distance, in the frame. Each place is a number: segment plus parameter.
#[derive(Clone, Copy)]
struct DistanceMinimum {
    places: DVec2,
    distance: f64,
}

/// A cluster of undecided pairs: the minimum that it descends to, and its bounding box.
struct DistanceValley {
    minimum: DistanceMinimum,
    low: DVec2,
    high: DVec2,
    /// Whether the minimum lies in one of the pairs.
    has_minimum: bool,
}

impl CurveView<'_> {
    /// Finds the places where two curves in space come within a distance of `within`. Each local
    /// minimum of the distance is reported once. Curves that stay close are reported as overlaps.
    /// `within` is raised to at least 1e-12 of the curves' size. The work for each pair of segments
    /// whose boxes are close is bounded.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (`within` is negative or not finite),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn near_misses(&self, other: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<NearMisses> {
        if self.is_empty() || other.is_empty() {
            return Err(Error::EmptyCurve);
        }
        Error::require((0.0..f64::INFINITY).contains(&within), "within", within, "finite and at least 0")?;
        let frame = UnitFrame::from_points(self.points().iter().chain(other.points()));
        let points = [frame.points_to_frame(self.points())?, frame.points_to_frame(other.points())?];
        let sides = [
            CurveView::new_unchecked(&points[0], self.ends(), self.is_closed()),
            CurveView::new_unchecked(&points[1], other.ends(), other.is_closed()),
        ];
        // Points of the frame are at most 2 sqrt(3) apart, and a larger limit could be infinite in
        // it.
        let within = frame.length_to_frame(within).clamp(DISTANCE_ROUNDING, 4.0);
        let mut search = NearMissSearch {
            curves: sides,
            within,
            minima: Vec::new(),
            unresolved: Vec::new(),
            given_up: 0,
            undecided: false,
        };
        let numbers = [segments_with_extent(&sides[0])?, segments_with_extent(&sides[1])?];
        let tree = BoxTree::new(numbers[1].iter().map(|&j| Aabb::from_points(sides[1].segment(j as usize))))?;
        let (searching, mut pairs) = (job.sub_job(0.0, 0.8), 0usize);
        for (k, &i) in numbers[0].iter().enumerate() {
            searching.step_every(16, k, numbers[0].len(), PROGRESS_STAGE)?;
            let i = i as usize;
            tree.visit_overlapping(&Aabb::from_points(sides[0].segment(i)), within, |leaf| {
                pairs += 1;
                if pairs.is_multiple_of(SEGMENT_PAIRS_PER_REPORT) {
                    searching.step(k as f64 / numbers[0].len() as f64, PROGRESS_STAGE)?;
                }
                search.search_segment_pair([i, numbers[1][leaf] as usize])
            })?;
        }
        search.cluster_sort_and_merge(&frame, &job.sub_job(0.8, 1.0))
    }
}

/// Returns the segments with extent; segments that are points coincide with the ends of their
/// neighbours. If all segments are points, returns the first.
fn segments_with_extent(curve: &CurveView<'_>) -> Result<Vec<u32>> {
    let all = (0..curve.len() as u32).filter(|&k| !segment::is_single_point(curve.segment(k as usize)));
    let found = alloc::gather(all)?;
    if found.is_empty() { alloc::filled(0, 1) } else { Ok(found) }
}

/// Returns the direction in which a curve continues beyond an end of segment k; `None` if it ends
/// there.
fn leg_beyond_segment_end(curve: &CurveView<'_>, k: usize, at_end: bool) -> Option<DVec3> {
    let (count, last) = (curve.len(), if at_end { curve.len() - 1 } else { 0 });
    if k == last && !curve.is_closed() {
        return None;
    }
    let next = curve.segment(if at_end { (k + 1) % count } else { (k + count - 1) % count });
    Some(if at_end {
        segment::vector_to_next_distinct_control(next)
    } else {
        -segment::vector_from_previous_distinct_control(next)
    })
}

struct NearMissSearch<'a> {
    curves: [CurveView<'a>; 2],
    within: f64,
    minima: Vec<DistanceMinimum>,
    /// Undecided pairs of parts at the smallest size, with their places and the distance at the
    /// centre.
    unresolved: Vec<UnresolvedBox>,
    /// The number of undecided pairs of segments so far.
    given_up: u32,
    undecided: bool,
}

/// The search of a pair of segments, given by their indices.
struct NearMissPairSearch<'s, 'a> {
    search: &'s mut NearMissSearch<'a>,
    segment_indices: [usize; 2],
    segments: [&'a [DVec3]; 2],
    /// Whether the search reached its limit.
    exhausted: bool,
}

impl Subdivision<[SegmentPart; 2], 2> for NearMissPairSearch<'_, '_> {
    type Solution = ();
    /// The index of the part to halve.
    type Split = usize;
    type Stop = Error;

    fn classify_box(&mut self, [p, q]: &[SegmentPart; 2]) -> Result<BoxTest<(), usize>> {
        if are_hulls_apart(&p.controls, &q.controls, self.search.within) {
            return Ok(BoxTest::Empty);
        }
        Ok(match proven_minimum_count(p, q) {
            Some(0) => BoxTest::Empty,
            Some(_) => BoxTest::Unique(()),
            None => match [p, q].map(|part| part.end_parameter - part.start_parameter <= MIN_PART_PARAMETER_LENGTH) {
                [true, true] => BoxTest::Unresolved,
                [false, true] => BoxTest::Undecided(0),
                [true, false] => BoxTest::Undecided(1),
                [false, false] => BoxTest::Undecided(usize::from(p.control_box_size() < q.control_box_size())),
            },
        })
    }

    fn record_solution(&mut self, pair: [SegmentPart; 2], (): ()) -> Result<()> {
        self.search.add_local_minimum(self.segments, self.segment_indices, pair)
    }

    fn record_unresolved(&mut self, [p, q]: [SegmentPart; 2], exhausted: bool) -> Result<()> {
        self.search.undecided |= exhausted;
        self.exhausted |= exhausted;
        let [low, high] = parameter_box_corners(&[p, q]);
        let middle = (low + high) * 0.5;
        let [x, y] = [segment::point_at(self.segments[0], middle.x), segment::point_at(self.segments[1], middle.y)];
        let half = ((high - low) * 0.5).extend(0.0);
        let middle = (segment_indices_as_offsets(self.segment_indices) + middle).extend(0.0);
        alloc::push(&mut self.search.unresolved, UnresolvedBox { middle, half_size: half, residual: x.distance(y) })
    }

    fn split_box(&mut self, pair: [SegmentPart; 2], number: usize) -> [[SegmentPart; 2]; 2] {
        halve_one_of_pair(pair, number)
    }

    fn reserve_stack(stack: &mut BoxStack<[SegmentPart; 2]>) -> Result<()> {
        alloc::reserve(stack, 2)
    }
}

impl NearMissSearch<'_> {
    fn search_segment_pair(&mut self, numbers: [usize; 2]) -> Result<()> {
        let whole = [0, 1].map(|k| self.curves[k].segment(numbers[k]));
        let first = whole.map(|controls| SegmentPart::from_whole_segment(SegmentBuffer::new(controls)));
        let max_pairs =
            if self.given_up < MAX_UNDECIDED_SEGMENT_PAIRS { MAX_PART_PAIRS } else { MAX_PART_PAIRS_FOR_SIMPLE_MINIMA };
        let limits = SubdivisionLimits { max_depth: u32::MAX, max_boxes: max_pairs + 1 };
        let mut search =
            NearMissPairSearch { search: self, segment_indices: numbers, segments: whole, exhausted: false };
        subdivide(&mut search, first, &mut Vec::new(), limits)?;
        self.given_up += u32::from(search.exhausted);
        Ok(())
    }

    /// Adds the only minimum of a pair, if it is also a minimum of the whole curves and small
    /// enough.
    fn add_local_minimum(&mut self, whole: [&[DVec3]; 2], numbers: [usize; 2], pair: [SegmentPart; 2]) -> Result<()> {
        let [low, high] = parameter_box_corners(&pair);
        let descent = minimise_distance(whole, 0.5 * (low + high), low, high);
        let distance = descent.gap.length();
        if distance <= self.within && !self.distance_falls_beyond_box(whole, numbers, &descent, low, high) {
            alloc::push(
                &mut self.minima,
                DistanceMinimum { places: segment_indices_as_offsets(numbers) + descent.parameters, distance },
            )?;
        }
        Ok(())
    }

    /// Returns true if a descent ended at the border of its box while the distance keeps falling
    /// beyond.
    fn distance_falls_beyond_box(
        &self,
        whole: [&[DVec3]; 2],
        numbers: [usize; 2],
        &DescentResult { parameters: at, gap, gradient }: &DescentResult,
        low: DVec2,
        high: DVec2,
    ) -> bool {
        (0..2).any(|k| {
            let (at_low, at_high) = (at[k] <= low[k], at[k] >= high[k]);
            let falls = if at_low { gradient[k] } else { -gradient[k] };
            let slope_rounding =
                || RELATIVE_SLOPE_ROUNDING * Aabb::from_points(whole[k]).size().max_element() * gap.length();
            if gap.length() <= DISTANCE_ROUNDING || !(at_low || at_high) || falls <= slope_rounding() {
                return false;
            }
            // At an inner end of a part, the next part has the minimum. At a joint, the next
            // segment has it if the distance falls there.
            let at_joint = at[k] == 0.0 || at[k] == 1.0;
            let sign = if k == 0 { 1.0 } else { -1.0 };
            let goes_on = |along: DVec3| sign * gap.dot(along) < 0.0;
            !at_joint || leg_beyond_segment_end(&self.curves[k], numbers[k], at_high).is_some_and(goes_on)
        })
    }

    /// Descends from an undecided pair to a minimum, which may be anywhere on the two segments.
    /// Returns `None` if the distance falls beyond the segments, or the descent does not converge.
    fn descend_to_minimum(&mut self, start: &UnresolvedBox) -> Option<DistanceMinimum> {
        let middle = start.middle.truncate();
        let numbers = [0, 1].map(|k| (middle[k].max(0.0) as usize).min(self.curves[k].len() - 1));
        let whole = [0, 1].map(|k| self.curves[k].segment(numbers[k]));
        let (low, high) = (DVec2::ZERO, DVec2::ONE);
        let descent = minimise_distance(whole, middle - segment_indices_as_offsets(numbers), low, high);
        let distance = descent.gap.length();
        if self.distance_falls_beyond_box(whole, numbers, &descent, low, high) {
            return None;
        }
        let at_rest = distance <= DISTANCE_ROUNDING
            || (0..2).all(|k| {
                let size = Aabb::from_points(whole[k]).size().max_element();
                let inside = descent.parameters[k] > 0.0 && descent.parameters[k] < 1.0;
                !inside || descent.gradient[k].abs() <= MAX_CONVERGED_SLOPE * size * distance
            });
        self.undecided |= !at_rest && distance <= self.within;
        at_rest
            .then_some(DistanceMinimum { places: segment_indices_as_offsets(numbers) + descent.parameters, distance })
    }

    /// Returns true if the distance rises by more than rounding in all directions from a minimum
    /// within the segments.
    fn is_isolated_minimum(&self, minimum: &DistanceMinimum) -> bool {
        let numbers = [0, 1].map(|k| (minimum.places[k] as usize).min(self.curves[k].len() - 1));
        let at = minimum.places - segment_indices_as_offsets(numbers);
        let [a, b] = [0, 1].map(|k| point_and_derivatives::<3>(self.curves[k].segment(numbers[k]), at[k]));
        let gap = a[0] - b[0];
        let (x, y) = (a[1].length_squared() + gap.dot(a[2]), b[1].length_squared() - gap.dot(b[2]));
        let mixed = a[1].dot(b[1]);
        x > 0.0 && y > 0.0 && x * y - mixed * mixed > MIN_RELATIVE_DETERMINANT * x * y
    }

    /// Adds the clusters of undecided pairs as overlaps, with their minima. A descent starts at
    /// every pair that is closer than the pairs that touch it. Clusters that descend to the same
    /// place belong to one valley and form one overlap. If none of them contains that place, they
    /// are slopes towards a proven minimum.
    fn add_overlaps(
        &mut self,
        place: impl Fn(usize, f64) -> Place,
        overlaps: &mut Vec<Overlap>,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut unresolved = std::mem::take(&mut self.unresolved);
        sort::sort_stable(&mut unresolved, &|x, y| {
            compare_places(x.middle.truncate().into(), y.middle.truncate().into())
        });
        let mut clusters = Vec::new();
        let cluster_of = cluster_touching_boxes(&unresolved, &mut clusters, || job.step(0.0, PROGRESS_STAGE))?;
        let mut valleys = Vec::new();
        for (k, start) in unresolved.iter().enumerate() {
            job.step_every(DESCENTS_PER_REPORT, k, unresolved.len(), PROGRESS_STAGE)?;
            if !is_closest_of_touching_pairs(&unresolved, k) {
                continue;
            }
            if let Some(minimum) = self.descend_to_minimum(start)
                && minimum.distance <= self.within
            {
                let UnresolvedCluster { best_box: best, low, high } = clusters[cluster_of[k] as usize];
                // Along a flat valley, rounding creates many minima; keep only the cluster's best.
                if best.middle != start.middle && !self.is_isolated_minimum(&minimum) {
                    continue;
                }
                let (low, high, reach) = (low.truncate(), high.truncate(), 2.0 * start.half_size.truncate());
                let inside = minimum.places.cmpge(low - reach).all() && minimum.places.cmple(high + reach).all();
                alloc::push(&mut valleys, DistanceValley { minimum, low, high, has_minimum: inside })?;
            }
        }
        sort::sort_stable(&mut valleys, &|x, y| compare_places(x.minimum.places.into(), y.minimum.places.into()));
        let same = |x: &DistanceValley, y: &DistanceValley| {
            (x.minimum.places - y.minimum.places).abs().max_element() <= MAX_SAME_VALLEY_PARAMETER_GAP
        };
        for valley in valleys.chunk_by(same) {
            if let Some(holder) = valley.iter().find(|part| part.has_minimum) {
                alloc::push(&mut self.minima, holder.minimum)?;
                let low = valley.iter().fold(holder.low, |low, part| low.min(part.low));
                let high = valley.iter().fold(holder.high, |high, part| high.max(part.high));
                let ends = |k: usize| [place(k, low[k]), place(k, high[k])];
                alloc::push(overlaps, Overlap { a: ends(0), b: ends(1) })?;
            }
        }
        sort::sort_stable(overlaps, &|x, y| {
            let start = |overlap: &Overlap| [overlap.a[0].global_parameter(), overlap.b[0].global_parameter()];
            compare_places(start(x), start(y))
        });
        overlaps.dedup();
        Ok(())
    }

    /// Clusters the undecided pairs, then sorts and merges duplicates.
    fn cluster_sort_and_merge(mut self, frame: &UnitFrame, job: &Job<'_>) -> Result<NearMisses> {
        let mut found = NearMisses::default();
        let sides = self.curves;
        let place = |k: usize, at: f64| {
            let segment = (at.max(0.0) as usize).min(sides[k].len() - 1);
            Place { segment: segment as u32, t: (at - segment as f64).clamp(0.0, 1.0) }
        };
        self.add_overlaps(place, &mut found.overlaps, job)?;
        found.undecided = self.undecided;
        let periods = sides.map(|curve| curve.segment_count_if_closed());
        sort_and_remove_duplicates(&mut self.minima, |found| found.places.to_array(), periods, MAX_SAME_PARAMETER_GAP);
        found.places = alloc::collect(self.minima.iter().map(|found| {
            let (a, b) = (place(0, found.places.x), place(1, found.places.y));
            NearMiss { a, b, distance: frame.length_from_frame(found.distance) }
        }))?;
        Ok(found)
    }
}

/// Returns the smallest and the largest parameters of a pair of parts.
fn parameter_box_corners([p, q]: &[SegmentPart; 2]) -> [DVec2; 2] {
    [DVec2::new(p.start_parameter, q.start_parameter), DVec2::new(p.end_parameter, q.end_parameter)]
}

/// Returns the indices of two segments, as offsets of places that are numbers.
fn segment_indices_as_offsets(numbers: [usize; 2]) -> DVec2 {
    DVec2::new(numbers[0] as f64, numbers[1] as f64)
}

/// Returns true if none of the pairs that touch pair `k` is closer; ties go to the first. The pairs
/// are sorted by their places.
fn is_closest_of_touching_pairs(pairs: &[UnresolvedBox], k: usize) -> bool {
    let own = &pairs[k];
    let reach = own.half_size.x + MIN_PART_PARAMETER_LENGTH;
    let near = |other: &&UnresolvedBox| (other.middle.x - own.middle.x).abs() <= reach;
    let (mut before, mut after) = (pairs[..k].iter().rev().take_while(near), pairs[k + 1..].iter().take_while(near));
    !before.any(|other| other.residual <= own.residual && other.touches(own))
        && !after.any(|other| other.residual < own.residual && other.touches(own))
}
