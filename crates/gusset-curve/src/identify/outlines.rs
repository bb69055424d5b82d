//! The input of an identification: outlines through points, and constraints.

use super::input_points::Points;
use glam::DVec3;
use gusset_base::error::{Element, Error, Result};
use std::ops::Range;

/// Outlines, with all their points one after another.
#[derive(Debug, Clone, Copy)]
pub struct Outlines<'a> {
    /// The points of all outlines.
    pub points: Points<'a>,
    /// Outline k has the points `offsets[k]..offsets[k + 1]`; `None` for a single outline of all
    /// points.
    pub offsets: Option<&'a [u32]>,
    /// Whether the outlines are closed, from the last point back to the first.
    pub closed: bool,
    /// The constraints, in ascending order of the points, at most one for each point. If points are
    /// merged, the first constraint holds.
    pub constraints: &'a [Constraint],
}

/// A constraint on the curve at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constraint {
    /// The point, counted over all outlines.
    pub point: u32,
    /// The constraint.
    pub kind: PointConstraint,
}

/// The requirement on the curve where it passes a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointConstraint {
    /// The curve may turn sharply: two curves meet at the point.
    Corner,
    /// The curve passes in this direction, of any length except 0.
    Tangent(DVec3),
    /// The curve passes at this angle, in radians counter-clockwise from the x-axis, in the plane
    /// of x and y.
    TangentAngle(f64),
}

impl PointConstraint {
    /// Returns the direction in which the curve passes.
    pub(super) fn tangent(self) -> Option<DVec3> {
        match self {
            PointConstraint::Corner => None,
            PointConstraint::Tangent(tangent) => Some(tangent),
            PointConstraint::TangentAngle(angle) => {
                let (sine, cosine) = libm::sincos(angle);
                Some(DVec3::new(cosine, sine, 0.0))
            }
        }
    }
}

impl Outlines<'_> {
    /// Checks offsets and constraints. Returns the number of outlines.
    pub(crate) fn check_offsets_and_constraints(&self) -> Result<usize> {
        let count = self.points.len();
        if let Some(offsets) = self.offsets {
            Error::check_offsets(offsets, count)?;
        }
        for (k, constraint) in self.constraints.iter().enumerate() {
            let follows = k == 0 || constraint.point > self.constraints[k - 1].point;
            if constraint.point as usize >= count || !follows {
                return Err(Error::BadConstraint { constraint: k as u32, point: constraint.point });
            }
            let given = match constraint.kind {
                PointConstraint::Corner => continue,
                PointConstraint::Tangent(tangent) => tangent,
                PointConstraint::TangentAngle(angle) => DVec3::new(angle, 0.0, 0.0),
            };
            Error::check_finite(Element::Constraint, k as u64, given)?;
        }
        Ok(self.offsets.map_or(1, |offsets| offsets.len() - 1))
    }

    /// Returns the number of points of each section, if it is the same for all sections that are not
    /// single points.
    pub(crate) fn points_per_section(&self, sections: usize) -> Result<usize> {
        let count = |k: usize| self.point_range(k).len();
        let columns = (0..sections).map(count).find(|&count| count != 1).unwrap_or(sections.min(1));
        let other = |&(_, count): &(usize, usize)| count != columns && count != 1;
        match (0..sections).map(|k| (k, count(k))).find(other) {
            Some((k, count)) => {
                Err(Error::SectionsDiffer { section: k as u32, count: count as u32, expected: columns as u32 })
            }
            None => Ok(columns),
        }
    }

    /// Returns the points of outline `k`.
    pub(crate) fn point_range(&self, k: usize) -> Range<usize> {
        match self.offsets {
            Some(offsets) => offsets[k] as usize..offsets[k + 1] as usize,
            None => 0..self.points.len(),
        }
    }
}
