//! Arcs along sides shared by cells: cuts each of them where others end.
//!
//! A curve along a side of a cell, or of a box, is found from both sides. The arcs end at different
//! places, because boxes on both sides are halved differently. Cut at each other's ends, the arcs
//! become copies of each other, and `intersection_chain` keeps one. A cut of an arc without copies
//! is harmless, because the two parts are joined again.
//!
//! Cost: O(log n) for each arc along a side, and a few evaluations for each close end.

use super::pair_places::{IntersectionCurvePoint, PairPlaces};
use super::pair_search::{FoundArcsAndBalls, IntersectionArc};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;
use gusset_base::sort;

/// Number of arcs along sides between two progress reports.
const ARCS_PER_REPORT: usize = 1 << 6;

/// Ends of other arcs within this fraction of an arc's length count as its own ends. The limit is
/// clamped to this range of resolutions.
const MAX_OWN_END_DISTANCE_FRACTION: f64 = 0.25;
const OWN_END_DISTANCE_RANGE_IN_RESOLUTIONS: [f64; 2] = [0.125, 2.0];

/// A cut through an arc, behind one of its points.
struct ArcCut {
    arc: u32,
    point_before_cut: u32,
    /// Fraction of the chord at the cut.
    chord_fraction: f64,
    cut_point: IntersectionCurvePoint,
}

/// Cuts the arcs of all pairs of cells.
pub(super) struct OverlappingArcs<'a> {
    pub(super) arcs_and_balls: &'a FoundArcsAndBalls,
    pub(super) pair_places: &'a PairPlaces<'a>,
    /// Accuracy of ends.
    pub(super) resolution: f64,
    pub(super) chord_tolerance: f64,
}

impl OverlappingArcs<'_> {
    /// Cuts the arcs along sides. Returns `None` if no cut was needed.
    pub(super) fn cut_arcs_along_sides(&self, job: &Job<'_>) -> Result<Option<FoundArcsAndBalls>> {
        let along = || self.arcs_and_balls.arcs.iter().filter(|arc| arc.is_along_side);
        let ends = alloc::gather(along().flat_map(|arc| arc.ends))?;
        if ends.len() < 4 {
            return Ok(None);
        }
        let tree = KdTree::new(&ends, &job.sub_job(0.0, 0.1), "paths")?;
        let mut cuts = Vec::new();
        let arcs = &self.arcs_and_balls.arcs;
        for (k, arc) in arcs.iter().enumerate().filter(|(_, arc)| arc.is_along_side) {
            job.sub_job(0.1, 1.0).step_every(ARCS_PER_REPORT, k, arcs.len(), "paths")?;
            self.add_cuts_of_arc(k as u32, arc, &ends, &tree, &mut cuts)?;
        }
        sort::sort_stable(&mut cuts, &|a, b| {
            (a.arc, a.point_before_cut)
                .cmp(&(b.arc, b.point_before_cut))
                .then(a.chord_fraction.total_cmp(&b.chord_fraction))
        });
        if cuts.is_empty() { Ok(None) } else { self.apply_cuts(&cuts).map(Some) }
    }

    /// The distance up to which an end of another arc counts as one of this arc's ends. For short
    /// arcs, as beside poles, it is a fraction of their length.
    fn max_distance_of_own_end(&self, arc: &IntersectionArc) -> f64 {
        let length = arc.ends[0].distance(arc.ends[1]);
        self.resolution
            * (MAX_OWN_END_DISTANCE_FRACTION * length / self.resolution)
                .clamp(OWN_END_DISTANCE_RANGE_IN_RESOLUTIONS[0], OWN_END_DISTANCE_RANGE_IN_RESOLUTIONS[1])
    }

    /// Adds the cuts of one arc: at ends of other arcs that lie on it.
    fn add_cuts_of_arc(
        &self,
        k: u32,
        arc: &IntersectionArc,
        ends: &[DVec3],
        tree: &KdTree<'_>,
        cuts: &mut Vec<ArcCut>,
    ) -> Result<()> {
        let points = &self.arcs_and_balls.points[arc.first_point as usize..arc.end_point as usize];
        let within = self.max_distance_of_own_end(arc);
        let mut from = self.pair_places.point_of_first_surface(arc.pair, points[0]);
        for (n, pair) in points.windows(2).enumerate() {
            let to = self.pair_places.point_of_first_surface(arc.pair, pair[1]);
            let (whole, mut result) = (to - from, Ok(()));
            // Without a chord tolerance, an arc turns little, because its box is small.
            let chord = self.chord_tolerance.min(whole.length());
            let reach = ScaledRadius::new((0.5 * whole.length() + chord).max(f64::MIN_POSITIVE));
            tree.for_each_within(from.midpoint(to), reach, &mut |_, end| {
                let end = ends[end as usize];
                let way = (end - from).dot(whole) / whole.length_squared();
                let off = (end - from - way * whole).length();
                let is_own = arc.ends.into_iter().any(|own| own.distance(end) <= within);
                if result.is_err() || is_own || !(0.0..=1.0).contains(&way) || off > 2.0 * chord {
                    return;
                }
                let at =
                    self.pair_places.nearest_curve_point(arc.pair, pair[0].lerp(pair[1], way), end, self.resolution);
                if let Some(at) = at.filter(|at| at.point.distance(end) <= within) {
                    result = alloc::push(
                        cuts,
                        ArcCut { arc: k, point_before_cut: n as u32, chord_fraction: way, cut_point: at },
                    );
                }
            });
            result?;
            from = to;
        }
        Ok(())
    }

    /// Applies the cuts, which are sorted.
    fn apply_cuts(&self, cuts: &[ArcCut]) -> Result<FoundArcsAndBalls> {
        let mut made = FoundArcsAndBalls {
            points: alloc::copied(&self.arcs_and_balls.points)?,
            arcs: alloc::with_capacity(self.arcs_and_balls.arcs.len() + cuts.len())?,
            balls: alloc::copied(&self.arcs_and_balls.balls)?,
            exhausted_pairs: Vec::new(),
        };
        let mut rest = cuts;
        for (k, arc) in self.arcs_and_balls.arcs.iter().enumerate() {
            let (own, others) = rest.split_at(rest.partition_point(|cut| cut.arc as usize == k));
            rest = others;
            let mut last = None;
            for cut in own {
                // The ends of several other arcs may nearly coincide.
                let before = last.map_or(arc.ends[0], |cut: &ArcCut| cut.cut_point.point);
                if before.distance(cut.cut_point.point) > self.max_distance_of_own_end(arc) {
                    self.add_part_of_arc(arc, [last, Some(cut)], &mut made)?;
                    last = Some(cut);
                }
            }
            if last.is_some() { self.add_part_of_arc(arc, [last, None], &mut made)? } else { made.arcs.push(*arc) }
        }
        Ok(made)
    }

    /// Adds the part of an arc between two cuts. `None` means the arc's own end.
    fn add_part_of_arc(
        &self,
        arc: &IntersectionArc,
        cuts: [Option<&ArcCut>; 2],
        made: &mut FoundArcsAndBalls,
    ) -> Result<()> {
        let [from, to] = cuts.map(|cut| cut.map(|cut| arc.first_point + cut.point_before_cut + 1));
        let inner = from.unwrap_or(arc.first_point) as usize..to.unwrap_or(arc.end_point) as usize;
        let mut part = IntersectionArc { first_point: made.points.len() as u32, ..*arc };
        let [first, last] = cuts.map(|cut| cut.map(|cut| cut.cut_point.parameters));
        alloc::extend(&mut made.points, first)?;
        alloc::append(&mut made.points, &self.arcs_and_balls.points[inner])?;
        alloc::extend(&mut made.points, last)?;
        part.end_point = made.points.len() as u32;
        for (k, cut) in cuts.into_iter().enumerate() {
            if let Some(IntersectionCurvePoint { point, direction, .. }) = cut.map(|cut| cut.cut_point) {
                (part.ends[k], part.directions[k], part.is_cut[k]) = (point, direction, true);
            }
        }
        made.arcs.push(part);
        Ok(())
    }
}
