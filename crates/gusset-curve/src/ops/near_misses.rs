//! Near misses of two curves in space: the places where their distance is least, if it is small
//! enough.
//!
//! Pairs of parts are halved until a proof holds:
//!
//! * *apart*: their hulls are farther from each other than asked for, along an axis or across both
//!   chords;
//! * *empty*: one of the slopes of f = |A(s) - B(t)|^2 / 2 has one sign all over the pair, and
//!   leads into the next part;
//! * *unique*: the Hessian of f is positive definite for all s and t of the pair, or f falls
//!   towards the end of a segment and is convex along that end: then Newton's method finds the only
//!   least distance. All by bounds over the control points.
//!
//! Parts that run beside each other have no such proof: those left at the least size are clustered
//! into overlaps, if the distance is least there and near enough.
//!
//! Source: Hanniel and Elber, 2007, for halving that ends where one solution at most is proved; the
//! bounds of slopes and Hessian are ours. Cost: at most [`MAX_PAIRS`] pairs of parts for two
//! segments, O(degree^2) each.

use super::intersect::Overlap;
use super::near_miss_bounds::{Descent, apart, count_minima, minimise_distance};
use super::part::{Part, by_places, halve, sort_distinct};
use crate::curve::segment::{self, SegmentBuffer, jet};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::subdivision::{
    BoxTest, Limits, Stack, Subdivision, UnresolvedBox, UnresolvedCluster, cluster, subdivide,
};
use gusset_base::geom::{Aabb, box_tree::BoxTree};
use gusset_base::job::Job;
use gusset_base::sort;

/// Two places of two curves, between which their distance is least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearMiss {
    /// On the first curve.
    pub a: Place,
    /// On the second.
    pub b: Place,
    /// How far the points there are apart.
    pub distance: f64,
}

/// Where two curves come near to each other.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NearMisses {
    /// By their places on the first curve.
    pub places: Vec<NearMiss>,
    /// Parts that stay near, or touch so closely that no place can be told from the next; the
    /// nearest places of each are among the places. On the second curve: the places between which
    /// the near points are.
    pub overlaps: Vec<Overlap>,
    /// True if parts were given up that may be near enough and are not among the overlaps.
    pub undecided: bool,
}

/// Distances below this, in a frame of size 1, are rounding.
const ROUNDING: f64 = 1e-12;

/// Parts are not halved below this length of their parameter.
const MIN_PART_LENGTH: f64 = 1.0 / 1024.0;

/// Pairs of parts that are examined for two segments before halving ends.
const MAX_PAIRS: usize = 20_000;

/// Pairs of segments given up, after which the rest has the effort of plain minima only.
const MAX_GIVEN_UP: u32 = 32;

/// The pairs of parts that plain minima need.
const MAX_PAIRS_OF_PLAIN: usize = 300;

/// Pairs of segments between two progress reports: each takes up to 20 ms.
const PAIRS_PER_REPORT: usize = 4;

/// Descents between two progress reports.
const DESCENTS_PER_REPORT: usize = 256;
const STAGE: &str = "near misses of curves";

/// Places whose parameters differ by less are one.
const SAME_PARAMETER: f64 = 1e-7;

/// Descents along one valley end no farther apart than this, in the parameters.
const SAME_VALLEY: f64 = 1e-5;

/// Slopes below this, relative to the size of the segment and the distance, are rounding.
const SLOPE_ROUNDING: f64 = 1e-12;

/// The slope, relative likewise, below which a descent has come to rest: along a valley the distance
/// itself is rounding sooner than its slope.
const MAX_SLOPE: f64 = 1e-6;

/// The least determinant of the Hessian, relative to the product of its diagonal, where the distance
/// has one least place and not a flat valley of them.
const MIN_BEND: f64 = 1e-12;

/// A least distance, in the frame; the places as numbers, segment and parameter added.
#[derive(Clone, Copy)]
struct Minimum {
    at: DVec2,
    distance: f64,
}

/// A cluster of unresolved pairs: the least distance that it leads down to, and its box, as numbers.
struct Valley {
    minimum: Minimum,
    low: DVec2,
    high: DVec2,
    /// Whether the least distance is among the pairs.
    has_minimum: bool,
}

impl CurveView<'_> {
    /// Where two curves in space come as near to each other as `within`: each place where their
    /// distance is least, once; of curves that stay near, the parts where they do. `within` below
    /// 1e-12 of the curves' size is taken as that. Bounded work for each pair of segments whose
    /// boxes are near.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (`within` is negative or not finite),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn near_misses(&self, other: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<NearMisses> {
        if self.is_empty() || other.is_empty() {
            return Err(Error::EmptyCurve);
        }
        Error::require((0.0..f64::INFINITY).contains(&within), "within", within)?;
        let frame = UnitFrame::of(self.points().iter().chain(other.points()));
        let points = [frame.points(self.points())?, frame.points(other.points())?];
        let sides = [
            CurveView::trusted(&points[0], self.ends(), self.is_closed()),
            CurveView::trusted(&points[1], other.ends(), other.is_closed()),
        ];
        // No two points of the frame are farther apart than 2 sqrt(3): more could be infinite in it.
        let within = frame.length(within).clamp(ROUNDING, 4.0);
        let mut search =
            NearMissSearch { sides, within, minima: Vec::new(), unresolved: Vec::new(), given_up: 0, undecided: false };
        let numbers = [lasting(&sides[0])?, lasting(&sides[1])?];
        let tree = BoxTree::new(numbers[1].iter().map(|&j| Aabb::from_points(sides[1].segment(j as usize))))?;
        let (searching, mut pairs) = (job.part(0.0, 0.8), 0usize);
        for (k, &i) in numbers[0].iter().enumerate() {
            searching.step_every(16, k, numbers[0].len(), STAGE)?;
            let i = i as usize;
            tree.overlapping(&Aabb::from_points(sides[0].segment(i)), within, |leaf| {
                pairs += 1;
                if pairs.is_multiple_of(PAIRS_PER_REPORT) {
                    searching.step(k as f64 / numbers[0].len() as f64, STAGE)?;
                }
                search.search_pair([i, numbers[1][leaf] as usize])
            })?;
        }
        search.finish(&frame, &job.part(0.8, 1.0))
    }
}

/// The segments that are not points, as the ends of their neighbours are where those are; of a curve
/// that is nothing else the first.
fn lasting(curve: &CurveView<'_>) -> Result<Vec<u32>> {
    let all = (0..curve.len() as u32).filter(|&k| !segment::is_point(curve.segment(k as usize)));
    let found = alloc::gather(all)?;
    if found.is_empty() { alloc::filled(0, 1) } else { Ok(found) }
}

/// The direction in which a curve goes on beyond segment k at one of its ends; `None` if it ends
/// there.
fn leg_beyond(curve: &CurveView<'_>, k: usize, at_end: bool) -> Option<DVec3> {
    let (count, last) = (curve.len(), if at_end { curve.len() - 1 } else { 0 });
    if k == last && !curve.is_closed() {
        return None;
    }
    let next = curve.segment(if at_end { (k + 1) % count } else { (k + count - 1) % count });
    Some(if at_end { segment::first_leg(next) } else { -segment::last_leg(next) })
}

struct NearMissSearch<'a> {
    sides: [CurveView<'a>; 2],
    within: f64,
    minima: Vec<Minimum>,
    /// Pairs of parts without a proof at the least size: the places as numbers, and the distance in
    /// the middle.
    unresolved: Vec<UnresolvedBox>,
    /// Pairs of segments given up so far.
    given_up: u32,
    undecided: bool,
}

/// The search of two segments, by their numbers.
struct PairSearch<'s, 'a> {
    search: &'s mut NearMissSearch<'a>,
    numbers: [usize; 2],
    whole: [&'a [DVec3]; 2],
    /// Whether halving ended at the limit.
    exhausted: bool,
}

impl Subdivision<[Part; 2], 2> for PairSearch<'_, '_> {
    type Solution = ();
    /// The number of the part that is halved.
    type Split = usize;
    type Stop = Error;

    fn classify(&mut self, [p, q]: &[Part; 2]) -> Result<BoxTest<(), usize>> {
        if apart(&p.controls, &q.controls, self.search.within) {
            return Ok(BoxTest::Empty);
        }
        Ok(match count_minima(p, q) {
            Some(0) => BoxTest::Empty,
            Some(_) => BoxTest::Unique(()),
            None => match [p, q].map(|part| part.to - part.from <= MIN_PART_LENGTH) {
                [true, true] => BoxTest::Unresolved,
                [false, true] => BoxTest::Undecided(0),
                [true, false] => BoxTest::Undecided(1),
                [false, false] => BoxTest::Undecided(usize::from(p.size() < q.size())),
            },
        })
    }

    fn accept(&mut self, pair: [Part; 2], (): ()) -> Result<()> {
        self.search.add_local_minimum(self.whole, self.numbers, pair)
    }

    fn give_up(&mut self, [p, q]: [Part; 2], exhausted: bool) -> Result<()> {
        self.search.undecided |= exhausted;
        self.exhausted |= exhausted;
        let [low, high] = corners(&[p, q]);
        let middle = (low + high) * 0.5;
        let [x, y] = [segment::point(self.whole[0], middle.x), segment::point(self.whole[1], middle.y)];
        let half = ((high - low) * 0.5).extend(0.0);
        let middle = (number_of(self.numbers) + middle).extend(0.0);
        alloc::push(&mut self.search.unresolved, UnresolvedBox { middle, half, residual: x.distance(y) })
    }

    fn split(&mut self, pair: [Part; 2], number: usize) -> [[Part; 2]; 2] {
        halve(pair, number)
    }

    fn reserve(stack: &mut Stack<[Part; 2]>) -> Result<()> {
        alloc::reserve(stack, 2)
    }
}

impl NearMissSearch<'_> {
    fn search_pair(&mut self, numbers: [usize; 2]) -> Result<()> {
        let whole = [0, 1].map(|k| self.sides[k].segment(numbers[k]));
        let first = whole.map(|controls| Part::whole(SegmentBuffer::new(controls)));
        let max_pairs = if self.given_up < MAX_GIVEN_UP { MAX_PAIRS } else { MAX_PAIRS_OF_PLAIN };
        let limits = Limits { max_depth: u32::MAX, max_boxes: max_pairs + 1 };
        let mut search = PairSearch { search: self, numbers, whole, exhausted: false };
        subdivide(&mut search, first, &mut Vec::new(), limits)?;
        self.given_up += u32::from(search.exhausted);
        Ok(())
    }

    /// Adds the least distance of a pair that has only one, if it is one of the curves too and near
    /// enough.
    fn add_local_minimum(&mut self, whole: [&[DVec3]; 2], numbers: [usize; 2], pair: [Part; 2]) -> Result<()> {
        let [low, high] = corners(&pair);
        let descent = minimise_distance(whole, 0.5 * (low + high), low, high);
        let distance = descent.gap.length();
        if distance <= self.within && !self.goes_on_beyond(whole, numbers, &descent, low, high) {
            alloc::push(&mut self.minima, Minimum { at: number_of(numbers) + descent.at, distance })?;
        }
        Ok(())
    }

    /// Whether a descent ended where the box does and the distance of the curves falls on beyond.
    fn goes_on_beyond(
        &self,
        whole: [&[DVec3]; 2],
        numbers: [usize; 2],
        &Descent { at, gap, gradient }: &Descent,
        low: DVec2,
        high: DVec2,
    ) -> bool {
        (0..2).any(|k| {
            let (at_low, at_high) = (at[k] <= low[k], at[k] >= high[k]);
            let falls = if at_low { gradient[k] } else { -gradient[k] };
            let slope_rounding = || SLOPE_ROUNDING * Aabb::from_points(whole[k]).size().max_element() * gap.length();
            if gap.length() <= ROUNDING || !(at_low || at_high) || falls <= slope_rounding() {
                return false;
            }
            // At an inner end of a part the next part has it; at a joint the next segment, if it
            // goes down there.
            let at_joint = at[k] == 0.0 || at[k] == 1.0;
            let sign = if k == 0 { 1.0 } else { -1.0 };
            let goes_on = |along: DVec3| sign * gap.dot(along) < 0.0;
            !at_joint || leg_beyond(&self.sides[k], numbers[k], at_high).is_some_and(goes_on)
        })
    }

    /// The least distance to which an unresolved pair leads, wherever it is on the two segments;
    /// `None` if the distance falls on beyond them, or the descent did not come to rest.
    fn minimum_below(&mut self, start: &UnresolvedBox) -> Option<Minimum> {
        let middle = start.middle.truncate();
        let numbers = [0, 1].map(|k| (middle[k].max(0.0) as usize).min(self.sides[k].len() - 1));
        let whole = [0, 1].map(|k| self.sides[k].segment(numbers[k]));
        let (low, high) = (DVec2::ZERO, DVec2::ONE);
        let descent = minimise_distance(whole, middle - number_of(numbers), low, high);
        let distance = descent.gap.length();
        if self.goes_on_beyond(whole, numbers, &descent, low, high) {
            return None;
        }
        let at_rest = distance <= ROUNDING
            || (0..2).all(|k| {
                let size = Aabb::from_points(whole[k]).size().max_element();
                let inside = descent.at[k] > 0.0 && descent.at[k] < 1.0;
                !inside || descent.gradient[k].abs() <= MAX_SLOPE * size * distance
            });
        self.undecided |= !at_rest && distance <= self.within;
        at_rest.then_some(Minimum { at: number_of(numbers) + descent.at, distance })
    }

    /// Whether the distance rises to all sides of a least one by more than rounding, within the
    /// segments.
    fn stands_out(&self, minimum: &Minimum) -> bool {
        let numbers = [0, 1].map(|k| (minimum.at[k] as usize).min(self.sides[k].len() - 1));
        let at = minimum.at - number_of(numbers);
        let [a, b] = [0, 1].map(|k| jet::<3>(self.sides[k].segment(numbers[k]), at[k]));
        let gap = a[0] - b[0];
        let (x, y) = (a[1].length_squared() + gap.dot(a[2]), b[1].length_squared() - gap.dot(b[2]));
        let mixed = a[1].dot(b[1]);
        x > 0.0 && y > 0.0 && x * y - mixed * mixed > MIN_BEND * x * y
    }

    /// Adds the clusters of unresolved pairs as overlaps, with their least distances: descents begin
    /// at every pair that is nearer than those that touch it. Clusters that lead down to the same
    /// place are parts of one valley, and one overlap; where that place is in none of them, they are
    /// slopes towards a place that was proved.
    fn add_overlaps(
        &mut self,
        place: impl Fn(usize, f64) -> Place,
        overlaps: &mut Vec<Overlap>,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut unresolved = std::mem::take(&mut self.unresolved);
        sort::stable(&mut unresolved, &|x, y| by_places(x.middle.truncate().into(), y.middle.truncate().into()));
        let mut clusters = Vec::new();
        let cluster_of = cluster(&unresolved, &mut clusters, || job.step(0.0, STAGE))?;
        let mut valleys = Vec::new();
        for (k, start) in unresolved.iter().enumerate() {
            job.step_every(DESCENTS_PER_REPORT, k, unresolved.len(), STAGE)?;
            if !is_lowest(&unresolved, k) {
                continue;
            }
            if let Some(minimum) = self.minimum_below(start)
                && minimum.distance <= self.within
            {
                let UnresolvedCluster { best, low, high } = clusters[cluster_of[k] as usize];
                // Along a flat valley rounding makes many, of which the cluster's best is one.
                if best.middle != start.middle && !self.stands_out(&minimum) {
                    continue;
                }
                let (low, high, reach) = (low.truncate(), high.truncate(), 2.0 * start.half.truncate());
                let inside = minimum.at.cmpge(low - reach).all() && minimum.at.cmple(high + reach).all();
                alloc::push(&mut valleys, Valley { minimum, low, high, has_minimum: inside })?;
            }
        }
        sort::stable(&mut valleys, &|x, y| by_places(x.minimum.at.into(), y.minimum.at.into()));
        let same = |x: &Valley, y: &Valley| (x.minimum.at - y.minimum.at).abs().max_element() <= SAME_VALLEY;
        for valley in valleys.chunk_by(same) {
            if let Some(holder) = valley.iter().find(|part| part.has_minimum) {
                alloc::push(&mut self.minima, holder.minimum)?;
                let low = valley.iter().fold(holder.low, |low, part| low.min(part.low));
                let high = valley.iter().fold(holder.high, |high, part| high.max(part.high));
                let ends = |k: usize| [place(k, low[k]), place(k, high[k])];
                alloc::push(overlaps, Overlap { a: ends(0), b: ends(1) })?;
            }
        }
        sort::stable(overlaps, &|x, y| {
            let start = |overlap: &Overlap| [overlap.a[0].along(), overlap.b[0].along()];
            by_places(start(x), start(y))
        });
        overlaps.dedup();
        Ok(())
    }

    /// Clusters the unresolved pairs, sorts, and merges repeats.
    fn finish(mut self, frame: &UnitFrame, job: &Job<'_>) -> Result<NearMisses> {
        let mut found = NearMisses::default();
        let sides = self.sides;
        let place = |k: usize, at: f64| {
            let segment = (at.max(0.0) as usize).min(sides[k].len() - 1);
            Place { segment: segment as u32, t: (at - segment as f64).clamp(0.0, 1.0) }
        };
        self.add_overlaps(place, &mut found.overlaps, job)?;
        found.undecided = self.undecided;
        let periods = sides.map(|curve| curve.period());
        sort_distinct(&mut self.minima, |found| found.at.to_array(), periods, SAME_PARAMETER);
        found.places = alloc::collect(self.minima.iter().map(|found| {
            let (a, b) = (place(0, found.at.x), place(1, found.at.y));
            NearMiss { a, b, distance: frame.length_back(found.distance) }
        }))?;
        Ok(found)
    }
}

/// The smallest and the largest parameters of a pair of parts.
fn corners([p, q]: &[Part; 2]) -> [DVec2; 2] {
    [DVec2::new(p.from, q.from), DVec2::new(p.to, q.to)]
}

/// The numbers of two segments, for places as numbers.
fn number_of(numbers: [usize; 2]) -> DVec2 {
    DVec2::new(numbers[0] as f64, numbers[1] as f64)
}

/// Whether no pair that touches one, of pairs sorted by their places, is nearer; of equally near
/// ones the first counts as nearer.
fn is_lowest(pairs: &[UnresolvedBox], k: usize) -> bool {
    let own = &pairs[k];
    let reach = own.half.x + MIN_PART_LENGTH;
    let near = |other: &&UnresolvedBox| (other.middle.x - own.middle.x).abs() <= reach;
    let (mut before, mut after) = (pairs[..k].iter().rev().take_while(near), pairs[k + 1..].iter().take_while(near));
    !before.any(|other| other.residual <= own.residual && other.touches(own))
        && !after.any(|other| other.residual < own.residual && other.touches(own))
}
