//! The curve of an outline under construction, near the origin.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Control points and ends, segment by segment, and the joints that are corners.
#[derive(Default)]
pub(super) struct CurveBuilder {
    pub(super) points: Vec<DVec3>,
    /// 0, then the index of the last control point of each segment.
    pub(super) segment_ends: Vec<u32>,
    /// Joints that may be corners, by the number of segments before them, in ascending order.
    corners: Vec<u32>,
}

impl CurveBuilder {
    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.segment_ends.clear();
        self.corners.clear();
        self.segment_ends.push(0);
    }

    /// Sets the start of the curve, unless it has begun.
    pub(super) fn begin_at_point(&mut self, point: DVec3) -> Result<()> {
        match self.points.is_empty() {
            true => alloc::push(&mut self.points, point),
            false => Ok(()),
        }
    }

    /// Appends a segment. `controls_after_first` has its control points except the first.
    #[inline]
    pub(super) fn push_segment(&mut self, controls_after_first: &[DVec3]) -> Result<()> {
        alloc::append(&mut self.points, controls_after_first)?;
        alloc::push(&mut self.segment_ends, (self.points.len() - 1) as u32)
    }

    /// Makes the whole curve of `n` quadratic segments, and returns their control points to be
    /// filled in.
    pub(super) fn allocate_closed_quadratics(&mut self, n: usize) -> Result<&mut [DVec3]> {
        self.clear();
        alloc::grow(&mut self.points, 2 * n + 1, DVec3::ZERO)?;
        alloc::extend(&mut self.segment_ends, (1..=n as u32).map(|k| 2 * k))?;
        Ok(&mut self.points)
    }

    /// Allows a corner at the current end of the curve.
    pub(super) fn mark_corner(&mut self) -> Result<()> {
        let at = self.len() as u32;
        alloc::push(&mut self.corners, at)
    }

    pub(super) fn len(&self) -> usize {
        self.segment_ends.len() - 1
    }

    pub(super) fn is_empty(&self) -> bool {
        self.len() == 0
    }

    pub(super) fn segment(&self, k: usize) -> &[DVec3] {
        &self.points[self.segment_ends[k] as usize..=self.segment_ends[k + 1] as usize]
    }

    pub(super) fn corner_joints(&self) -> &[u32] {
        &self.corners
    }
}
