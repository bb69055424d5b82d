//! The options of a frame.

use crate::identify::Options;
use glam::DVec3;

/// Which points of the sections belong together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Correspondence<'a> {
    /// The points themselves, by their places: all sections have equally many.
    Given,
    /// Equal parts of the arc length of each section, or of the lengths between corners that all
    /// sections have. Closed sections start where they are turned least against each other, wherever
    /// their first points are; one that runs the other way round than the first one is taken
    /// backwards. Open sections go from their first points to their last.
    ArcLength {
        /// The number of nodes in a section.
        columns: usize,
    },
    /// Equal angles round an axis: nodes where the half-planes from the axis meet each section, the
    /// farthest where there are several.
    Angle {
        /// The number of nodes in a section.
        columns: usize,
        /// The axis; seen against its direction angles grow counter-clockwise.
        axis: Axis<'a>,
        /// Towards the nodes of column 0; any vector not along the axis, at its first point if it is
        /// bent.
        reference: DVec3,
    },
    /// Landmarks: points of each section that belong together, and equal parts of the arc length
    /// between them.
    Landmarks {
        /// For each section its landmarks in order, as places among its own points; as many for
        /// each.
        points: &'a [u32],
        /// How many parts there are from each landmark to the next.
        parts: usize,
    },
}

/// What angles are counted about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axis<'a> {
    /// A straight line.
    Line {
        /// A point of it.
        point: DVec3,
        /// Its direction, of any length but 0.
        direction: DVec3,
    },
    /// A curve, of which each section has a point. It passes them along the circles through three of
    /// them at a time, and the reference goes along without turning about it.
    Points(&'a [DVec3]),
}

/// The options of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameOptions<'a> {
    /// Which points of the sections belong together.
    pub correspondence: Correspondence<'a>,
    /// Of the curves across, those of the given sections too.
    pub across: Options,
    /// Of the curves along.
    pub along: Options,
    /// The last section is followed by the first one, as in a ring.
    pub ring: bool,
    /// Closed sections start at their first points, or at the corner after the first section's;
    /// read by [`Correspondence::ArcLength`].
    pub given_starts: bool,
    /// Corners that only the points' polygon has are drawn smooth. Otherwise a point is a corner
    /// where that turns by 40 degrees and far more than usual, or by [`Options::corner_angle`] if
    /// that is less than pi: curves across turn sharply there.
    pub smooth_corners: bool,
    /// Points that are missing, counted over all sections, in any order; what stands in their places
    /// is not read. With [`Correspondence::Given`] only: they are filled along the body.
    pub missing: &'a [u32],
}

impl<'a> FrameOptions<'a> {
    /// With the defaults of all else.
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
