//! Curves on a surface: the result of sections, contours and intersections.

use super::Place;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::ops::Range;

/// Polylines with points on the surface, one after the other.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Paths {
    /// 0, then the end of each path among the points.
    pub ends: Vec<u32>,
    /// For each path, whether it returns to its first point. The point is not repeated.
    pub closed: Vec<bool>,
    /// The places of the points.
    pub places: Vec<Place>,
    /// The points.
    pub points: Vec<DVec3>,
    /// The unit normals at the points; zero where none exists.
    pub normals: Vec<DVec3>,
    /// For each path, the index of its plane, level or angle in the query; 0 if the query had only
    /// one.
    pub levels: Vec<u32>,
    /// For intersections of two surfaces, the places of the points on the second surface; else
    /// empty.
    pub others: Vec<Place>,
    /// Cells that may contain unresolved parts of the answer: tangential contacts, or pieces
    /// smaller than the tolerance.
    pub unresolved: Vec<Place>,
    /// For intersections, where the surfaces touch.
    pub contacts: Vec<Contact>,
}

/// The common part of two surfaces where they touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactKind {
    /// A single point. Around it the surfaces are apart, or penetrate each other by less than the
    /// tolerance.
    Point,
    /// A point where two branches of the intersection cross, or pass within the tolerance of it.
    Crossing,
}

/// A place where two surfaces touch within the tolerance. Their normals there are parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// The kind of contact.
    pub kind: ContactKind,
    /// The place on the first surface.
    pub place: Place,
    /// The place on the second surface.
    pub other: Place,
    /// Signed height of the first surface above the second one, along the normal of the first one.
    pub gap: f64,
    /// Near the contact, all points of one surface that are within the tolerance of the other one
    /// lie within this distance of the contact. Points on branches that cross there are the
    /// exception.
    pub radius: f64,
}

impl Paths {
    /// The number of paths.
    pub fn len(&self) -> usize {
        self.closed.len()
    }

    /// True if the list is empty.
    pub fn is_empty(&self) -> bool {
        self.closed.is_empty()
    }

    /// The points of path k.
    pub fn points_of(&self, k: usize) -> &[DVec3] {
        &self.points[self.point_range(k)]
    }

    /// The range of the points of path k.
    pub(crate) fn point_range(&self, k: usize) -> Range<usize> {
        self.ends[k] as usize..self.ends[k + 1] as usize
    }

    /// Removes points of intersection paths that are at most `max_gap` from the previous point,
    /// except first and last ones. At a pole the parameters move, but the point does not.
    pub(super) fn drop_repeated_points(&mut self, max_gap: f64) {
        let mut kept = 0;
        for path in 0..self.len() {
            let (range, first) = (self.point_range(path), kept);
            self.ends[path] = first as u32;
            for n in range.clone() {
                let is_repeat = n > range.start && self.points[n].distance(self.points[kept - 1]) <= max_gap;
                if is_repeat && n + 1 < range.end {
                    continue;
                }
                // The last point of the path replaces the previous one.
                kept -= usize::from(is_repeat && kept > first + 1);
                self.places[kept] = self.places[n];
                self.others[kept] = self.others[n];
                self.points[kept] = self.points[n];
                self.normals[kept] = self.normals[n];
                kept += 1;
            }
        }
        self.ends[self.closed.len()] = kept as u32;
        self.places.truncate(kept);
        self.others.truncate(kept);
        self.points.truncate(kept);
        self.normals.truncate(kept);
    }

    /// Reserves memory for `count` more points.
    pub(super) fn reserve_points(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.places, count)?;
        alloc::reserve(&mut self.points, count)?;
        alloc::reserve(&mut self.normals, count)
    }

    /// Adds a point to the unfinished path.
    pub(super) fn push_point(&mut self, place: Place, point: DVec3, normal: DVec3) -> Result<()> {
        alloc::push(&mut self.places, place)?;
        alloc::push(&mut self.points, point)?;
        alloc::push(&mut self.normals, normal)
    }

    /// Keeps only the first `count` points.
    pub(super) fn truncate_points(&mut self, count: usize) {
        self.places.truncate(count);
        self.points.truncate(count);
        self.normals.truncate(count);
    }

    /// Ends the unfinished path at the last point.
    pub(super) fn finish_current_path(&mut self, closed: bool, level: u32) -> Result<()> {
        Error::check_count("points of curves", self.points.len() as u64, u32::MAX.into())?;
        alloc::push(&mut self.ends, self.points.len() as u32)?;
        alloc::push(&mut self.closed, closed)?;
        alloc::push(&mut self.levels, level)
    }
}
