//! Curves on a surface: the form of sections, contours and intersections.

use super::Place;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::ops::Range;

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
    /// Of intersections: where the surfaces touch.
    pub contacts: Vec<Contact>,
}

/// What surfaces have in common where they touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactKind {
    /// One point: all round it they are apart, or deeper in each other by less than the tolerance.
    Point,
    /// A point where two branches of the intersection cross, or pass it within the tolerance.
    Crossing,
}

/// A place where two surfaces touch, to the tolerance: their normals there are parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// What is there.
    pub kind: ContactKind,
    /// Where it is on the first surface.
    pub place: Place,
    /// Where it is on the second one.
    pub other: Place,
    /// How far the first surface is above the second one, along the normal of the first.
    pub gap: f64,
    /// Near the contact, points of the one surface that are within the tolerance of the other one
    /// are within this distance of it, but for those on branches that cross there.
    pub radius: f64,
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
        &self.points[self.range(k)]
    }

    /// Where path k is among the points.
    pub(crate) fn range(&self, k: usize) -> Range<usize> {
        self.ends[k] as usize..self.ends[k + 1] as usize
    }

    /// Leaves out points of paths of intersections that are no farther than `least` from the one
    /// before, but for first and last ones: at a pole parameters move and the point does not.
    pub(super) fn drop_repeats(&mut self, least: f64) {
        let mut kept = 0;
        for path in 0..self.len() {
            let (range, first) = (self.range(path), kept);
            self.ends[path] = first as u32;
            for n in range.clone() {
                let is_repeat = n > range.start && self.points[n].distance(self.points[kept - 1]) <= least;
                if is_repeat && n + 1 < range.end {
                    continue;
                }
                // The last one stays, in place of the one before.
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

    /// Makes room for `count` more points.
    pub(super) fn reserve(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.places, count)?;
        alloc::reserve(&mut self.points, count)?;
        alloc::reserve(&mut self.normals, count)
    }

    /// Adds a point to the path that has not ended.
    pub(super) fn push(&mut self, place: Place, point: DVec3, normal: DVec3) -> Result<()> {
        alloc::push(&mut self.places, place)?;
        alloc::push(&mut self.points, point)?;
        alloc::push(&mut self.normals, normal)
    }

    /// Leaves the first `count` points.
    pub(super) fn truncate(&mut self, count: usize) {
        self.places.truncate(count);
        self.points.truncate(count);
        self.normals.truncate(count);
    }

    /// Ends a path with the last point.
    pub(super) fn end(&mut self, closed: bool, level: u32) -> Result<()> {
        Error::check_count("points of curves", self.points.len() as u64, u32::MAX.into())?;
        alloc::push(&mut self.ends, self.points.len() as u32)?;
        alloc::push(&mut self.closed, closed)?;
        alloc::push(&mut self.levels, level)
    }
}
