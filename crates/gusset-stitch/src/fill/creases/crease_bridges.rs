//! Curves that continue creases across a hole.

use super::super::patch_rim::PatchRim;
use super::crease_curve::{CubicCurve, tangent_of_circle};
use super::crease_ends::CreaseEnd;
use super::crease_joins::end_tangents;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Without new vertices, a chord replaces a curve that deviates at most this far from it, relative
/// to the chord's length.
const MAX_CHORD_SAG_RATIO: f64 = 0.1;

/// A path across the hole that continues one crease into another, from the end of one crease to the
/// end of the other.
pub(super) struct CreaseBridge {
    pub(super) other_end: usize,
    /// The curve that begins at this end.
    pub(super) curve: u32,
    /// The inner vertices, each with the one or two curves that it lies on.
    pub(super) inner_vertices: Vec<(u32, [u32; 2])>,
}

/// The bridges under construction.
pub(super) struct CreaseBridges<'a> {
    rim: &'a PatchRim,
    ends: &'a [CreaseEnd],
    pub(super) points: Vec<DVec3>,
    /// The bridge that starts at each crease end.
    pub(super) bridges: Vec<Option<CreaseBridge>>,
    curve_count: u32,
}

impl<'a> CreaseBridges<'a> {
    pub(super) fn new(rim: &'a PatchRim, ends: &'a [CreaseEnd]) -> Result<Self> {
        let bridges = alloc::collect(ends.iter().map(|_| None))?;
        Ok(CreaseBridges { rim, ends, points: Vec::new(), bridges, curve_count: 0 })
    }

    fn tip_position(&self, end: usize) -> DVec3 {
        self.rim.points[self.ends[end].tip_vertex]
    }

    /// Returns the length of a curve's pieces near an end: the mean length of the edges there.
    fn edge_length_near_end(&self, end: usize) -> f64 {
        let (n, tip) = (self.rim.rim_vertex_count, self.ends[end].tip_vertex);
        let around =
            [self.ends[end].point_before_tip, self.rim.points[(tip + 1) % n], self.rim.points[(tip + n - 1) % n]];
        around.iter().map(|p| p.distance(self.tip_position(end)) / 3.0).sum()
    }

    /// Returns the number of pieces of a curve: at most the number of rim edges, even if some are
    /// very short.
    fn count_pieces(&self, curve: &CubicCurve, spacing: f64, limit: usize) -> usize {
        let most = limit.min(self.rim.rim_vertex_count) as f64 + 1.0;
        ((curve.length() / spacing).round().min(most) as usize).max(1)
    }

    /// Adds inner points of a curve, and returns their vertex numbers.
    fn add_inner_points(&mut self, inner: &[DVec3]) -> Result<Vec<(u32, [u32; 2])>> {
        let first = (self.rim.rim_vertex_count + self.points.len()) as u32;
        let curve = self.curve_count;
        self.curve_count += 1;
        alloc::append(&mut self.points, inner)?;
        alloc::collect((first..first + inner.len() as u32).map(|name| (name, [curve; 2])))
    }

    /// Joins two ends by a curve. Without new vertices, joins them only if a chord is close enough.
    pub(super) fn join_two_ends(
        &mut self,
        [i, j]: [usize; 2],
        taken: &dyn Fn(u32, u32) -> bool,
        limit: Option<usize>,
    ) -> Result<()> {
        let pair = [i, j].map(|end| &self.ends[end]);
        let shape = CubicCurve::new([i, j].map(|end| self.tip_position(end)), end_tangents(self.rim, pair));
        let mut pieces = match limit {
            Some(limit) => self.count_pieces(
                &shape,
                (self.edge_length_near_end(i) + self.edge_length_near_end(j)) / 2.0,
                2 * limit,
            ),
            None if shape.relative_sag() <= MAX_CHORD_SAG_RATIO => 1,
            None => return Ok(()),
        };
        if pieces == 1 && taken(pair[0].tip_vertex as u32, pair[1].tip_vertex as u32) {
            if limit.is_none_or(|limit| limit == 0) {
                return Ok(());
            }
            pieces = 2;
        }
        let curve = self.curve_count;
        let inner = self.add_inner_points(&shape.inner_points(pieces)?)?;
        let back = alloc::collect(inner.iter().rev().copied())?;
        self.bridges[i] = Some(CreaseBridge { other_end: j, curve, inner_vertices: inner });
        self.bridges[j] = Some(CreaseBridge { other_end: i, curve, inner_vertices: back });
        Ok(())
    }

    /// Joins ends, given in the order of the rim, at a common point.
    pub(super) fn join_ends_at_point(&mut self, centre: DVec3, arms: &[usize], limit: usize) -> Result<()> {
        let first = self.curve_count;
        let mut inner = alloc::with_capacity(arms.len())?;
        for &arm in arms {
            let tip = self.tip_position(arm);
            let curve = CubicCurve::symmetric_arc(
                [tip, centre],
                tangent_of_circle(self.ends[arm].point_before_tip, tip, centre),
            );
            let pieces = self.count_pieces(&curve, self.edge_length_near_end(arm), limit - 1);
            let points = curve.inner_points(pieces)?;
            inner.push(self.add_inner_points(&points)?);
        }
        let name = (self.rim.rim_vertex_count + self.points.len()) as u32;
        alloc::push(&mut self.points, centre)?;
        // Each bridge leads from an arm to the arm before it: with the rim between them it encloses
        // a part.
        for (k, &arm) in arms.iter().enumerate() {
            let before = (k + arms.len() - 1) % arms.len();
            let mut way = alloc::copied(&inner[k])?;
            alloc::push(&mut way, (name, [first + k as u32, first + before as u32]))?;
            alloc::extend(&mut way, inner[before].iter().rev().copied())?;
            self.bridges[arm] =
                Some(CreaseBridge { other_end: arms[before], curve: first + k as u32, inner_vertices: way });
        }
        Ok(())
    }
}
