//! Curves on a surface: the form of sections, contours and intersections.

use super::Place;
use glam::DVec3;

/// Polylines whose points lie on the surface, one after the other.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Paths {
    /// 0, then the end of each path among the points.
    pub ends: Vec<u32>,
    /// By path: true if it returns to its first point, which is not repeated.
    pub closed: Vec<bool>,
    /// Where the points are.
    pub places: Vec<Place>,
    /// The points.
    pub points: Vec<DVec3>,
    /// The unit normals there; 0 where there is none.
    pub normals: Vec<DVec3>,
    /// By path: the number of its plane, level or angle among those of the query; 0 if there was
    /// one.
    pub levels: Vec<u32>,
    /// Of intersections of two surfaces: where the points are on the other one; else empty.
    pub others: Vec<Place>,
    /// Cells in which something may be that could not be resolved: tangency, or pieces smaller than
    /// the tolerance.
    pub unresolved: Vec<Place>,
}

impl Paths {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.closed.len()
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.closed.is_empty()
    }

    /// The points of path k.
    pub fn points_of(&self, k: usize) -> &[DVec3] {
        &self.points[self.ends[k] as usize..self.ends[k + 1] as usize]
    }
}
