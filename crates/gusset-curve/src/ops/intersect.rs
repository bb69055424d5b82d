//! Intersections of two plane curves, and self-intersections. A tree finds the pairs of segments
//! whose boxes meet.

use super::segment_intersection::{
    IgnoredSharedJoints, MAX_COMMON_POINT_DISTANCE, MAX_SAME_PARAMETER_GAP, MAX_TOUCHING_BOX_GAP, SegmentIntersections,
    advances_along_chord, intersect_segments,
};
use super::segment_part::{SegmentPart, compare_places, do_places_coincide, sort_and_remove_duplicates};
use crate::curve::segment;
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, box_tree::BoxTree};
use gusset_base::job::Job;
use gusset_base::sort;

/// A common point of two curves, or of two places of one curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intersection {
    /// The place on the first curve; for a self-intersection, the earlier place.
    pub a: Place,
    /// The place on the second curve; for a self-intersection, the later place.
    pub b: Place,
}

/// A common part of two segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// The ends on the first segment, in its direction.
    pub a: [Place; 2],
    /// The corresponding ends on the second segment.
    pub b: [Place; 2],
}

/// The intersections of two curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Intersections {
    /// Crossings and touches, sorted by their places on the first curve. None lies within an
    /// overlap.
    pub points: Vec<Intersection>,
    /// Common parts, one for each pair of segments.
    pub overlaps: Vec<Overlap>,
    /// True if the search gave up on a pair of segments that run beside each other within rounding
    /// without being the same curve. Some of their common points may be missing.
    pub undecided: bool,
}

/// A part of a segment; the part does not intersect itself.
struct SimpleSegmentPart {
    controls: Vec<DVec3>,
    segment: u32,
    start_parameter: f64,
    end_parameter: f64,
}

impl SimpleSegmentPart {
    fn bounding_box(&self) -> Aabb {
        Aabb::from_points(&self.controls)
    }

    fn place_on_curve(&self, t: f64) -> Place {
        let t = if t == 1.0 {
            self.end_parameter
        } else {
            self.start_parameter + (self.end_parameter - self.start_parameter) * t
        };
        Place { segment: self.segment, t }
    }
}

/// The maximum number of times that a segment is halved to exclude self-intersections.
const MAX_SEGMENT_HALVINGS: u32 = 20;
/// Pairs of segments between two progress reports; each pair takes up to 20 ms.
const PAIRS_PER_REPORT: usize = 4;

const PROGRESS_STAGE: &str = "intersections";

impl CurveView<'_> {
    /// Returns the common points of two plane curves. Crossings are exact up to rounding, touches
    /// up to about 1e-7 in the parameters. Curves touch if their distance is at most 1e-12 of the
    /// size of both. Intersections that differ by less than 1e-6 in both parameters count as one.
    /// Common parts are reported as overlaps. The work for each pair of segments whose boxes meet
    /// is bounded; each intersection takes about O(log(1 / distance)) halvings.
    ///
    /// # Errors
    /// [`CurveNotPlane`](gusset_base::Error::CurveNotPlane),
    /// [`OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn intersections(&self, other: &CurveView<'_>, job: &Job<'_>) -> Result<Intersections> {
        self.check_in_xy_plane()?;
        other.check_in_xy_plane()?;
        let frame = UnitFrame::from_points(self.points().iter().chain(other.points()));
        let (ours, theirs) = (self.divide_into_simple_parts(&frame, 0)?, other.divide_into_simple_parts(&frame, 0)?);
        let mut all =
            Intersections::from_simple_parts(&ours, &theirs, |_, _| Some(IgnoredSharedJoints::default()), job)?;
        all.sort_and_merge([self.segment_count_if_closed(), other.segment_count_if_closed()])?;
        Ok(all)
    }

    /// Returns the self-intersections of a plane curve: crossings, touches, parts that are
    /// traversed twice, and loops within a segment. Joints of neighbouring segments, the closing
    /// point of a closed curve, and cusps do not count. Loops shorter than 1e-5 of a segment's
    /// parameter range are missed. Otherwise see [`intersections`](Self::intersections).
    ///
    /// # Errors
    /// The errors of [`intersections`](Self::intersections).
    pub fn self_intersections(&self, job: &Job<'_>) -> Result<Intersections> {
        self.check_in_xy_plane()?;
        let frame = UnitFrame::from_points(self.points());
        let pieces = self.divide_into_simple_parts(&frame, MAX_SEGMENT_HALVINGS)?;
        let last = pieces.len().saturating_sub(1);
        let joined = |k: usize, i: usize| {
            (i > k).then_some(IgnoredSharedJoints {
                at_first_end: i == k + 1,
                at_first_start: self.is_closed() && k == 0 && i == last,
            })
        };
        let mut all = Intersections::from_simple_parts(&pieces, &pieces, joined, job)?;
        let period = self.segment_count_if_closed();
        for found in &mut all.points {
            // The end of a closed curve is its start.
            if found.b.global_parameter() >= period - MAX_SAME_PARAMETER_GAP {
                *found = Intersection { a: Place::START, b: found.a };
            }
        }
        all.points.retain(|found| {
            let gap = (found.b.global_parameter() - found.a.global_parameter()).abs();
            gap.min((period - gap).abs()) > 10.0 * MAX_SAME_PARAMETER_GAP
        });
        all.sort_and_merge([period; 2])?;
        Ok(all)
    }

    /// Returns the segments in a frame. Segments that may intersect themselves are halved until
    /// they cannot, at most `max_halvings` times. Segments that are points are skipped, because
    /// they coincide with the ends of their neighbours. If all segments are points, the first is
    /// kept, unless `max_halvings` asks for self-intersections.
    fn divide_into_simple_parts(&self, frame: &UnitFrame, max_halvings: u32) -> Result<Vec<SimpleSegmentPart>> {
        let mut pieces = alloc::with_capacity(self.len())?;
        for (k, controls) in self.segments().enumerate().filter(|(_, controls)| !segment::is_single_point(controls)) {
            push_simple_parts(
                SegmentPart::from_whole_segment(frame.segment_to_frame(controls)),
                k as u32,
                max_halvings,
                &mut pieces,
            )?;
        }
        if pieces.is_empty() && max_halvings == 0 && !self.is_empty() {
            push_simple_parts(
                SegmentPart::from_whole_segment(frame.segment_to_frame(self.segment(0))),
                0,
                max_halvings,
                &mut pieces,
            )?;
        }
        Ok(pieces)
    }
}

/// Appends a part of a segment, or its halves if it may intersect itself. A part that is too small
/// for rounding to resolve counts as one piece.
fn push_simple_parts(part: SegmentPart, segment: u32, depth: u32, pieces: &mut Vec<SimpleSegmentPart>) -> Result<()> {
    let small = |controls: &[DVec3]| Aabb::from_points(controls).size().max_element() <= MAX_COMMON_POINT_DISTANCE;
    if depth == 0 || advances_along_chord(&part.controls) || small(&part.controls) {
        let SegmentPart { ref controls, start_parameter: from, end_parameter: to } = part;
        return alloc::push(
            pieces,
            SimpleSegmentPart { controls: alloc::copied(controls)?, segment, start_parameter: from, end_parameter: to },
        );
    }
    part.into_halves().into_iter().try_for_each(|half| push_simple_parts(half, segment, depth - 1, pieces))
}

impl Intersections {
    /// Finds the intersections of two lists of pieces. `joined` returns `None` for a pair that must
    /// not be compared.
    fn from_simple_parts(
        ours: &[SimpleSegmentPart],
        theirs: &[SimpleSegmentPart],
        joined: impl Fn(usize, usize) -> Option<IgnoredSharedJoints>,
        job: &Job<'_>,
    ) -> Result<Self> {
        let tree = BoxTree::new(theirs.iter().map(SimpleSegmentPart::bounding_box))?;
        let (mut all, mut found) = (Intersections::default(), SegmentIntersections::default());
        let mut pairs = 0usize;
        for (k, piece) in ours.iter().enumerate() {
            job.step_every(64, k, ours.len(), PROGRESS_STAGE)?;
            tree.visit_overlapping(&piece.bounding_box(), MAX_TOUCHING_BOX_GAP, |i| match joined(k, i) {
                Some(joined) => {
                    if pairs % PAIRS_PER_REPORT == PAIRS_PER_REPORT - 1 {
                        job.step(k as f64 / ours.len() as f64, PROGRESS_STAGE)?;
                    }
                    pairs += 1;
                    all.add_intersections_of_parts(piece, &theirs[i], joined, &mut found)
                }
                None => Ok(()),
            })?;
        }
        Ok(all)
    }

    fn add_intersections_of_parts(
        &mut self,
        p: &SimpleSegmentPart,
        q: &SimpleSegmentPart,
        joined: IgnoredSharedJoints,
        found: &mut SegmentIntersections,
    ) -> Result<()> {
        intersect_segments(&p.controls, &q.controls, joined, found)?;
        let points =
            found.parameters.iter().map(|&[s, t]| Intersection { a: p.place_on_curve(s), b: q.place_on_curve(t) });
        alloc::extend(&mut self.points, points)?;
        let places =
            |[s, t]: [[f64; 2]; 2]| Overlap { a: s.map(|s| p.place_on_curve(s)), b: t.map(|t| q.place_on_curve(t)) };
        alloc::extend(&mut self.overlaps, found.overlaps.iter().copied().map(places))?;
        self.undecided |= found.undecided;
        Ok(())
    }

    /// Sorts the points, and removes ends of overlaps and duplicates from joints.
    fn sort_and_merge(&mut self, periods: [f64; 2]) -> Result<()> {
        let start = |overlap: &Overlap| [overlap.a[0].global_parameter(), overlap.b[0].global_parameter()];
        sort::sort_stable(&mut self.overlaps, &|x, y| compare_places(start(x), start(y)));
        let mut ends = alloc::with_capacity(2 * self.overlaps.len())?;
        ends.extend(
            self.overlaps.iter().flat_map(|o| [0, 1].map(|i| [o.a[i].global_parameter(), o.b[i].global_parameter()])),
        );
        sort::sort_stable(&mut ends, &|&x, &y| compare_places(x, y));
        self.points.retain(|m| {
            let [a, b] = [m.a.global_parameter(), m.b.global_parameter()];
            // The end of a closed curve is its start.
            let at_end = |shift: f64| {
                let from = ends.partition_point(|end| end[0] < a + shift - MAX_SAME_PARAMETER_GAP);
                let mut near = ends[from..].iter().take_while(|end| end[0] <= a + shift + MAX_SAME_PARAMETER_GAP);
                near.any(|end| do_places_coincide(end[1], b, periods[1], MAX_SAME_PARAMETER_GAP))
            };
            ![0.0, periods[0], -periods[0]].into_iter().any(at_end)
        });
        sort_and_remove_duplicates(
            &mut self.points,
            |m| [m.a.global_parameter(), m.b.global_parameter()],
            periods,
            MAX_SAME_PARAMETER_GAP,
        );
        Ok(())
    }
}
