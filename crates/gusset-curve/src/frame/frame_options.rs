//! The options of a frame.

use crate::identify::Options;
use glam::DVec3;

/// The rule that makes points of neighbouring sections correspond.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Correspondence<'a> {
    /// Points with the same index correspond. All sections have the same number of points, except for
    /// poles of one point.
    Given,
    /// Equal parts of the arc length of each section, or of the lengths between corners. A corner of
    /// one section has a node on all sections. Closed sections start where they are twisted least,
    /// regardless of their first points. A section that runs against the previous one is reversed.
    /// Open sections run from their first points to their last.
    ArcLength {
        /// The number of nodes in a section, or more if the sections have more corners.
        columns: usize,
    },
    /// Equal angles around an axis. Half-planes from the axis intersect each section in its nodes;
    /// of several intersections the farthest from the axis counts.
    Angle {
        /// The number of nodes in a section.
        columns: usize,
        /// The axis. Seen against its direction, angles grow counter-clockwise.
        axis: Axis<'a>,
        /// The direction from the axis towards the nodes of column 0. It may be any vector not
        /// parallel to the axis. If the axis is bent, it applies at the axis's first point.
        reference: DVec3,
    },
    /// Landmarks, which are given points of each section that correspond, and equal parts of the
    /// arc length between them.
    Landmarks {
        /// The landmarks of each section in order, as indices among its own points. Every section
        /// has the same number of landmarks.
        points: &'a [u32],
        /// The number of parts from each landmark to the next.
        parts: usize,
    },
}

/// The axis for correspondence by angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axis<'a> {
    /// A straight line.
    Line {
        /// A point on the line.
        point: DVec3,
        /// The direction, of any length except 0.
        direction: DVec3,
    },
    /// A curve with a point for each section. The curve follows circles through three points at a
    /// time, and the reference follows it without rotating about it.
    Points(&'a [DVec3]),
}

/// The options of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameOptions<'a> {
    /// The correspondence of points.
    pub correspondence: Correspondence<'a>,
    /// The options of the curves across, including the fits of the given sections.
    pub across: Options,
    /// The options of the curves along the body.
    pub along: Options,
    /// Closes the body like a ring: the first section follows the last.
    pub ring: bool,
    /// Starts closed sections at their first points, or at the corner after the first section's
    /// first point. Only [`Correspondence::ArcLength`] reads it.
    pub given_starts: bool,
    /// Draws detected corners of the points' polygon smooth. If false, all points of a polygon are
    /// corners. Polygons are closed sections of at most 6 points, and sections whose points turn by
    /// more than 54 or less than 6 degrees. In other sections, a point is a corner if the section
    /// turns there by at least 40 degrees and much more than usual. If [`Options::corner_angle`] is
    /// less than pi, that angle decides instead. Curves across turn sharply at corners.
    pub smooth_corners: bool,
    /// The missing points, counted over all sections, in any order. Their coordinates are not read.
    /// Only with [`Correspondence::Given`]: they are interpolated along the body.
    pub missing: &'a [u32],
}

impl<'a> FrameOptions<'a> {
    /// Creates options with defaults for all other fields.
    pub fn new(correspondence: Correspondence<'a>) -> Self {
        let curves = Options::default();
        FrameOptions {
            correspondence,
            across: curves,
            along: curves,
            ring: false,
            given_starts: false,
            smooth_corners: false,
            missing: &[],
        }
    }
}
