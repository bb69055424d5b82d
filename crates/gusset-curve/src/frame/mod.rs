//! The frame of outlines: curves across and curves along a body, through a common grid of nodes.
//!
//! The paper's application: a body is described by its cross sections, which are closed outlines
//! one behind another, and by curves along it. Both families pass through the same nodes. The
//! curves along the body give cross sections at any plane.
//!
//! - frame_options: [`Correspondence`] of points, and the options of the curves.
//! - correspond: the nodes; which points of neighbouring sections correspond.
//! - align: the starting points of closed sections, and the twist of a body.
//! - axis: the axis for correspondence by angle.
//! - missing: missing nodes of sections.
//! - frame_offset: the offset of a frame.
//! - section_corners: the corners of sections.
//! - section_landmarks: the correspondence of corners.
//! - repeated_sections: sections that coincide with an earlier one.
//! - [`frame`](frame()): the curves through the nodes.
//! - slice: new sections, and girth and area along the body.
//!
//! Nodes come row by row, with a row for each section. This is the layout of regular nets: H rows
//! of W nodes.
//!
//! Source: Nadopta, introduction; the correspondences are ours.

mod section_alignment;
mod axis;
mod section_corners;
mod section_landmarks;
mod section_nodes;
mod frame_offset;
mod frame_options;
mod missing_nodes;
mod repeated_sections;
mod slice;

pub use frame_offset::node_distances;
pub use frame_offset::{OffsetDirection, offset};
pub use frame_options::{Axis, Correspondence, FrameOptions};
pub use repeated_sections::{RepeatedSection, repeated_sections};
pub use slice::{Measure, Slice, slice};

use crate::identify::{Constraint, Fit, Options, Outlines, PointConstraint, Points, fit};

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::{Aabb, scale::common_unit};
use gusset_base::job::Job;

/// The nodes of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeGrid {
    /// The number of sections.
    pub rows: usize,
    /// The number of nodes in a section.
    pub columns: usize,
    /// Row by row.
    pub nodes: Vec<DVec3>,
    /// The unit directions of the curves across at the nodes; 0 where undefined.
    pub across: Vec<DVec3>,
    /// The unit directions of the curves along the body at the nodes; 0 where undefined.
    pub along: Vec<DVec3>,
    /// 1 for each section that was reversed.
    pub turned: Vec<u8>,
    /// Nodes with alternatives, because a half-plane meets their section more than once.
    pub ambiguous: Vec<u32>,
    /// Nodes at which the curve across turns sharply, ascending.
    pub corners: Vec<u32>,
    /// Nodes that were missing and have been interpolated, ascending.
    pub filled: Vec<u32>,
    /// The largest angle, in radians, by which the nodes of a closed section are rotated against
    /// the previous section's. It is small for an untwisted body, and 0 for open sections.
    pub max_twist: f64,
    /// The largest distance between the two curves at a node, relative to the size of the nodes'
    /// bounding box.
    pub max_gap: f64,
    /// The smallest sine of the angle at which two curves cross at a node.
    pub min_sine: f64,
}

/// A frame: nodes, and two families of curves through them.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The nodes.
    pub grid: NodeGrid,
    /// The curve of each section. Node i of row k is its point i, and point k W + i of all.
    pub across: Fit,
    /// The curve along each column. Node i of row k is its point k, and point i H + k of all.
    pub along: Fit,
}

/// Makes the frame of sections, closed or open, one behind another. A section of one point, or of
/// coincident points, is a pole: all its nodes are there.
///
/// # Errors
/// - [`Error::OptionOutOfRange`]: fewer than 2 sections, or than 3 in a ring; fewer than 2 columns,
///   or than 3 for closed sections; landmarks that differ in number or are not in order; a bad axis
///   or reference.
/// - [`Error::SectionsDiffer`].
/// - [`Error::NoNode`]: a half-plane does not meet a section; one with landmarks is a point; a missing
///   node lacks a node of its column before or behind it.
/// - [`Error::OnlyTips`]: by arc length, all sections are points.
/// - [`Error::NoSuch`]: a missing point does not exist.
/// - The errors of [`fit`](super::fit()).
///
/// Time and memory of the fits; by angle, also O(columns x segments) for each section.
pub fn frame(sections: &Outlines<'_>, options: &FrameOptions<'_>, job: &Job<'_>) -> Result<Frame> {
    if !options.missing.is_empty() {
        let (points, filled) = missing_nodes::fill_missing(sections, options)?;
        let sections = Outlines { points: Points::from(&points[..]), ..*sections };
        let mut made = frame(&sections, &FrameOptions { missing: &[], ..*options }, job)?;
        made.grid.filled = filled;
        return Ok(made);
    }
    let rows = sections.check_offsets_and_constraints()?;
    let least = |closed: bool| if closed { 3 } else { 2 };
    Error::require(rows >= least(options.ring), "sections", rows as f64, Allowed::AtLeast(least(options.ring) as f64))?;
    let found = section_nodes::compute_section_nodes(sections, options, &job.sub_job(0.0, 0.4))?;
    let columns = found.columns;
    Error::require(
        columns >= least(sections.closed),
        "columns",
        columns as f64,
        Allowed::AtLeast(least(sections.closed) as f64),
    )?;
    let kind = PointConstraint::Corner;
    let corners = alloc::collect(found.corners.iter().map(|&point| Constraint { point, kind }))?;
    let smooth = Options { corner_angle: std::f64::consts::PI, ..options.across };
    let across = fit_row_curves(&found.nodes, columns, sections.closed, &corners, &smooth, &job.sub_job(0.4, 0.6))?;
    let turned_back = |point: usize| (point % rows) * columns + point / rows;
    let turned_about = alloc::collect((0..found.nodes.len()).map(|point| found.nodes[turned_back(point)]))?;
    let along = fit_row_curves(&turned_about, rows, options.ring, &[], &options.along, &job.sub_job(0.6, 0.8))?;
    let (on_across, directions_across) =
        points_and_tangents_at_nodes(&across, columns, rows, |point| point, &job.sub_job(0.8, 0.9))?;
    let (on_along, directions_along) =
        points_and_tangents_at_nodes(&along, rows, columns, turned_back, &job.sub_job(0.9, 1.0))?;
    let mut grid = NodeGrid {
        rows,
        columns,
        nodes: found.nodes,
        across: directions_across,
        along: directions_along,
        turned: found.turned,
        ambiguous: found.ambiguous,
        corners: found.corners,
        filled: Vec::new(),
        max_twist: 0.0,
        max_gap: 0.0,
        min_sine: 1.0,
    };
    if sections.closed {
        grid.max_twist = section_alignment::max_twist_between_rows(&grid.nodes, columns, options.ring);
    }
    let unit = common_unit(&grid.nodes);
    let size = Aabb::from_points(grid.nodes.iter().map(|&p| p / unit)).size().max_element();
    for (node, (&p, &q)) in on_across.iter().zip(&on_along).enumerate() {
        grid.max_gap = grid.max_gap.max((p / unit).distance(q / unit) / size);
        grid.min_sine = grid.min_sine.min(grid.across[node].cross(grid.along[node]).length());
    }
    if size == 0.0 {
        (grid.max_gap, grid.min_sine) = (0.0, 0.0);
    }
    Ok(Frame { grid, across, along })
}

/// Fits curves through rows of `width` nodes each.
fn fit_row_curves(
    nodes: &[DVec3],
    width: usize,
    closed: bool,
    constraints: &[Constraint],
    options: &Options,
    job: &Job<'_>,
) -> Result<Fit> {
    let offsets = alloc::collect((0..nodes.len() / width + 1).map(|k| (k * width) as u32))?;
    let rows = alloc::collect(nodes.iter().map(DVec3::to_array))?;
    let points = Points::from(&rows[..]);
    fit(&Outlines { points, offsets: Some(&offsets), closed, constraints }, options, job)
}

/// Returns where the curves pass their points, and their directions there. `place` returns the
/// index at which each point's data are stored.
fn points_and_tangents_at_nodes(
    fit: &Fit,
    width: usize,
    count: usize,
    place: impl Fn(usize) -> usize,
    job: &Job<'_>,
) -> Result<(Vec<DVec3>, Vec<DVec3>)> {
    let mut points = alloc::filled(DVec3::ZERO, width * count)?;
    let mut directions = alloc::filled(DVec3::ZERO, width * count)?;
    for k in 0..count {
        let job = job.sub_job_of_item(k, count);
        job.step(0.0, "directions at nodes")?;
        let (curve, own) = (fit.curve(k), k * width..(k + 1) * width);
        if curve.is_empty() {
            // An outline without extent: all its points coincide.
            own.for_each(|i| points[place(i)] = curve.points()[0]);
            continue;
        }
        let places = alloc::collect(own.clone().map(|i| fit.place(i)))?;
        let (on_curve, along) =
            (curve.points_at(&places, &job.sub_job(0.0, 0.5))?, curve.tangents_at(&places, &job.sub_job(0.5, 1.0))?);
        for ((i, p), direction) in own.zip(on_curve).zip(along) {
            (points[place(i)], directions[place(i)]) = (p, direction);
        }
    }
    Ok((points, directions))
}
