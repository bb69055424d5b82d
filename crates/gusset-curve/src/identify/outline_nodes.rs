//! The nodes of an outline: its points near the origin, without repetitions, and cut at corners and
//! tangents. O(n log n).

use super::identify_options::{Ends, Options};
use super::outlines::{Constraint, Outlines};
use super::report::PointStatus;
use super::subcurve::{PointResult, Subcurve};
use crate::curve::check_finite;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::floor_to_power_of_two;
use gusset_base::sort;
use std::ops::Range;

/// The nodes of one outline; outlines reuse the memory.
#[derive(Default)]
pub(super) struct OutlineNodes {
    /// The points that differ from their neighbours. A closed outline with cuts begins at its first
    /// cut and repeats that point at the end.
    pub(super) points: Vec<DVec3>,
    /// For each point of the outline its node.
    pub(super) point_nodes: Vec<u32>,
    /// The outcome at each node.
    pub(super) results: Vec<PointResult>,
    /// Nodes where the outline is cut or ends, and the directions there.
    pub(super) dividing_nodes: Vec<CornerNode>,
    /// Whether the nodes form a closed outline; two nodes do not.
    pub(super) closed: bool,
    pub(super) placement: NormalisationOfOutline,
}

#[derive(Clone, Copy)]
pub(super) struct CornerNode {
    pub(super) node: u32,
    /// The unit tangent.
    pub(super) tangent: Option<DVec3>,
}

/// The position of an outline: point = origin + unit * node.
#[derive(Clone, Copy, Default)]
pub(super) struct NormalisationOfOutline {
    pub(super) origin: DVec3,
    /// A power of two.
    pub(super) unit: f64,
    /// The longest side of the nodes' bounding box: between 1 and 4, except for outlines without
    /// extent.
    pub(super) box_longest_side: f64,
}

impl OutlineNodes {
    /// Reads the nodes of some points, and cuts them.
    pub(super) fn normalise_and_divide(
        &mut self,
        outlines: &Outlines<'_>,
        span: &Range<usize>,
        constraints: &[Constraint],
        options: &Options,
    ) -> Result<()> {
        self.normalise_points(outlines, span, options.repeat_tolerance)?;
        self.closed = outlines.closed && self.points.len() > 2;
        self.find_dividing_nodes(span, constraints, options)
    }

    /// Moves the points near the origin, scales them to a size near 1, and merges repetitions.
    fn normalise_points(&mut self, outlines: &Outlines<'_>, span: &Range<usize>, repeat_tolerance: f64) -> Result<()> {
        let OutlineNodes { points, point_nodes, .. } = self;
        points.clear();
        point_nodes.clear();
        alloc::reserve(points, span.len() + 1)?;
        alloc::reserve(point_nodes, span.len())?;
        outlines.points.append_range_to(span.clone(), points);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        // The sum of zeros is 0 unless a coordinate is not finite.
        let mut zeros = DVec3::ZERO;
        for &p in points.iter() {
            (low, high) = (low.min(p), high.max(p));
            zeros += p * 0.0;
        }
        if zeros != DVec3::ZERO {
            (span.start..).zip(points.iter()).try_for_each(|(point, &p)| check_finite(point, p))?;
        }
        let half = (high * 0.5 - low * 0.5).max_element();
        if points.is_empty() || half == 0.0 {
            let origin = points.first().copied().unwrap_or(DVec3::ZERO);
            points.truncate(1);
            points.iter_mut().for_each(|p| *p = DVec3::ZERO);
            point_nodes.resize(span.len(), 0);
            self.placement = NormalisationOfOutline { origin, unit: 1.0, box_longest_side: 0.0 };
            return Ok(());
        }
        // Exact: the scale is a power of two, far from the ends of the range.
        let unit = floor_to_power_of_two(half);
        let (origin, scale) = (points[0], 1.0 / unit);
        let size = half * scale * 2.0;
        // If the box is far larger than the unit, only repetitions are omitted.
        let shift = origin * scale;
        points.iter_mut().for_each(|p| *p = *p * scale - shift);
        self.placement = NormalisationOfOutline { origin, unit, box_longest_side: size };
        self.merge_repeated_points(outlines.closed, (repeat_tolerance * size).powi(2));
        Ok(())
    }

    /// Merges neighbours whose squared distance is at most `max_squared_distance`.
    fn merge_repeated_points(&mut self, closed: bool, max_squared_distance: f64) {
        let OutlineNodes { points, point_nodes, .. } = self;
        point_nodes.extend(0..points.len() as u32);
        let mut count = points.len();
        if points.windows(2).any(|pair| pair[0].distance_squared(pair[1]) <= max_squared_distance) {
            count = 1;
            for i in 1..points.len() {
                if points[i].distance_squared(points[count - 1]) > max_squared_distance {
                    points[count] = points[i];
                    count += 1;
                }
                point_nodes[i] = count as u32 - 1;
            }
        }
        while closed && count > 1 && points[count - 1].distance_squared(points[0]) <= max_squared_distance {
            count -= 1;
        }
        let closing = point_nodes.partition_point(|&node| (node as usize) < count);
        point_nodes[closing..].fill(0);
        points.truncate(count);
    }

    /// Finds the nodes that divide the outline into separately fitted subcurves. Rotates a closed
    /// outline so that it begins at such a node.
    fn find_dividing_nodes(
        &mut self,
        span: &Range<usize>,
        constraints: &[Constraint],
        options: &Options,
    ) -> Result<()> {
        self.dividing_nodes.clear();
        self.results.clear();
        alloc::reserve(&mut self.results, self.points.len() + 1)?;
        self.results.resize(self.points.len(), PointResult::default());
        for constraint in constraints {
            let node = self.point_nodes[constraint.point as usize - span.start];
            let given = constraint.kind.tangent();
            let tangent = given.and_then(unit_direction);
            if given.is_some() && tangent.is_none() {
                self.results[node as usize].status = PointStatus::NoTangent;
                continue;
            }
            alloc::push(&mut self.dividing_nodes, CornerNode { node, tangent })?;
        }
        self.add_dividing_nodes_at_sharp_turns(options.corner_angle)?;
        let last = self.points.len().saturating_sub(1) as u32;
        if !self.closed {
            alloc::append(&mut self.dividing_nodes, &[0, last].map(|node| CornerNode { node, tangent: None }))?;
        }
        // The first of several cuts at a node counts.
        sort::sort_stable(&mut self.dividing_nodes, &|x, y| x.node.cmp(&y.node));
        self.dividing_nodes.dedup_by_key(|cut| cut.node);
        if let (true, Some(&first)) = (self.closed, self.dividing_nodes.first()) {
            let n = self.points.len() as u32;
            self.points.rotate_left(first.node as usize);
            self.results.rotate_left(first.node as usize);
            self.points.push(self.points[0]);
            self.results.push(self.results[0]);
            self.point_nodes.iter_mut().for_each(|node| *node = (*node + n - first.node) % n);
            self.dividing_nodes.iter_mut().for_each(|cut| cut.node -= first.node);
            alloc::push(&mut self.dividing_nodes, CornerNode { node: n, ..first })?;
        }
        Ok(())
    }

    /// Adds the nodes where the polygon turns by more than an angle.
    fn add_dividing_nodes_at_sharp_turns(&mut self, angle: f64) -> Result<()> {
        let n = self.points.len();
        if angle >= std::f64::consts::PI || n < 3 {
            return Ok(());
        }
        let min_cosine = libm::cos(angle);
        let inner = if self.closed { 0..n } else { 1..n - 1 };
        let is_corner = |&i: &usize| {
            let [a, p, c] = [self.points[(i + n - 1) % n], self.points[i], self.points[(i + 1) % n]];
            let (u, v) = (p - a, c - p);
            u.dot(v) < min_cosine * u.length() * v.length()
        };
        let corners = inner.filter(is_corner).map(|i| CornerNode { node: i as u32, tangent: None });
        alloc::extend(&mut self.dividing_nodes, corners)
    }

    /// Returns a closed outline without a cut as one subcurve, and the results of its nodes.
    pub(super) fn whole_outline_as_subcurve<'a>(
        &'a mut self,
        options: &'a Options,
    ) -> (Subcurve<'a>, &'a mut [PointResult]) {
        let size = self.placement.box_longest_side;
        (
            Subcurve { points: &self.points, closed: true, tangents: [None, None], outline_size: size, options },
            &mut self.results,
        )
    }

    /// Returns the subcurve from cut `k` to the next, and the results of its nodes.
    pub(super) fn subcurve_after_cut<'a>(
        &'a mut self,
        k: usize,
        options: &'a Options,
    ) -> (Subcurve<'a>, &'a mut [PointResult]) {
        let [from, to] = [self.dividing_nodes[k], self.dividing_nodes[k + 1]];
        let nodes = from.node as usize..to.node as usize + 1;
        let results = &mut self.results[nodes.clone()];
        let tangents = [from.tangent, to.tangent];
        let size = self.placement.box_longest_side;
        let mut sub = Subcurve { points: &self.points[nodes], closed: false, tangents, outline_size: size, options };
        set_free_end_directions(&mut sub, results);
        (sub, results)
    }
}

/// Returns a unit vector; `None` if the vector lacks a direction.
fn unit_direction(tangent: DVec3) -> Option<DVec3> {
    let largest = tangent.abs().max_element();
    (largest > 0.0).then(|| (tangent * (1.0 / largest).min(f64::MAX)).normalize())
}

/// Gives the free ends of a subcurve the directions of the options.
fn set_free_end_directions(sub: &mut Subcurve<'_>, results: &mut [PointResult]) {
    let (ends, last) = (sub.options.ends, sub.len() - 1);
    if ends == Ends::Free {
        return;
    }
    for (end, sign) in [(0, 1.0), (1, -1.0)] {
        if sub.tangents[end].is_some() {
            continue;
        }
        // From the end inwards.
        let at = |k: usize| sub.points[if end == 0 { k.min(last) } else { last.saturating_sub(k) }];
        let (leg, chord) = (at(1) - at(0), at(2) - at(0));
        let across = leg - chord * (leg.dot(chord) / chord.length_squared());
        let turns = last >= 2 && across.length() > 1e-9 * leg.length();
        let inwards = match ends {
            Ends::Perpendicular if !turns => {
                results[end * last].status = PointStatus::Collinear;
                continue;
            }
            Ends::Free | Ends::Perpendicular => across.normalize(),
            Ends::Level => orient_axis_towards(DVec3::X, leg, chord),
            Ends::Upright => orient_axis_towards(DVec3::Y, leg, chord),
            // The farther the chord is from an axis, the closer its perpendicular is to the axis.
            Ends::LevelOrUpright if chord.x.abs() < chord.y.abs() => orient_axis_towards(DVec3::X, leg, chord),
            Ends::LevelOrUpright => orient_axis_towards(DVec3::Y, leg, chord),
        };
        sub.tangents[end] = Some(inwards * sign);
    }
}

/// Returns an axis in the direction of a leg, or of the chord if the leg is perpendicular.
fn orient_axis_towards(axis: DVec3, leg: DVec3, chord: DVec3) -> DVec3 {
    let sense = if leg.dot(axis) == 0.0 { chord.dot(axis) } else { leg.dot(axis) };
    if sense < 0.0 { -axis } else { axis }
}
