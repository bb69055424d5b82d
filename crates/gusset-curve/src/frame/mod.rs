//! The frame of outlines: curves across and curves along a body, through a common grid of nodes.
//!
//! The paper's application: a body is described by its cross sections, closed outlines one behind
//! another, and by curves along it. Both families pass the same nodes, so they meet there. From the
//! curves along come cross sections at any plane.
//!
//! * frame_options: [`Correspondence`] of points, and the options of the curves.
//! * correspond: the nodes; which points of one section belong to which of the next.
//! * align: where closed sections start, and by how much a body is wrung.
//! * axis: the axis that angles are counted about.
//! * missing: nodes that sections lack.
//! * frame_offset: the frame beside a frame.
//! * corners: the corners of sections, and which of them belong together.
//! * [`frame`](frame()): the curves through them.
//! * slice: new sections, and girth and area along the body.
//!
//! Nodes come row by row, a row for each section: the layout of regular nets, H rows of W nodes.
//!
//! Source: Nadopta, introduction; the correspondences are ours.

mod align;
mod axis;
mod corners;
mod correspond;
mod frame_offset;
mod frame_options;
mod missing;
mod slice;

pub use frame_offset::by_node;
pub use frame_offset::{OffsetDirection, offset};
pub use frame_options::{Axis, Correspondence, FrameOptions};
pub use slice::{Measure, Slice, slice};

use crate::identify::{Constraint, Fit, Options, Outlines, PointConstraint, Points, fit};

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
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
    /// The directions of the curves across at the nodes, of length 1, or 0 where there is none.
    pub across: Vec<DVec3>,
    /// The directions of the curves along.
    pub along: Vec<DVec3>,
    /// Which sections were taken backwards: 1 for those.
    pub turned: Vec<u8>,
    /// Nodes that could have been elsewhere, as a half-plane meets their section more than once.
    pub ambiguous: Vec<u32>,
    /// Nodes at which the curve across turns sharply, ascending.
    pub corners: Vec<u32>,
    /// Nodes that were missing and are filled, ascending.
    pub filled: Vec<u32>,
    /// The largest angle, in radians, by which the nodes of a closed section are turned against those
    /// of the section before it: a body that is not meant to be wrung has a small one. 0 of open ones.
    pub max_twist: f64,
    /// The largest distance between the two curves at a node, relative to the size of the nodes'
    /// box.
    pub max_gap: f64,
    /// The smallest sine of the angle at which two curves cross at a node.
    pub min_sine: f64,
}

/// A frame: nodes, and two families of curves through them.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The nodes.
    pub grid: NodeGrid,
    /// The curve of each section; node i of row k is its point i, point k W + i of all.
    pub across: Fit,
    /// The curve along each column; node i of row k is its point k, point i H + k of all.
    pub along: Fit,
}

/// Makes the frame of some sections, closed or open, one behind another.
///
/// # Errors
/// Those of [`fit`](super::fit()), [`Error::OptionOutOfRange`] (sections: fewer than 2, or than 3
/// in a ring; columns: fewer than 2, or than 3 of closed sections; landmarks: not as many for each
/// section, or not in order; axis, reference), [`Error::SectionsDiffer`], [`Error::NoNode`] (a
/// section that a half-plane does not meet, or that is no curve; a missing node that no node of its
/// column is before, or none behind), [`Error::NoSuch`] (a missing point). Time and memory: those of
/// the fits; with angles O(columns x segments) for each section.
pub fn frame(sections: &Outlines<'_>, options: &FrameOptions<'_>, job: &Job<'_>) -> Result<Frame> {
    if !options.missing.is_empty() {
        let (points, filled) = missing::filled(sections, options)?;
        let sections = Outlines { points: Points::from(&points[..]), ..*sections };
        let mut made = frame(&sections, &FrameOptions { missing: &[], ..*options }, job)?;
        made.grid.filled = filled;
        return Ok(made);
    }
    let rows = sections.check()?;
    let least = |closed: bool| if closed { 3 } else { 2 };
    Error::require(rows >= least(options.ring), "sections", rows as f64)?;
    let found = correspond::correspond(sections, options, &job.part(0.0, 0.4))?;
    let columns = found.columns;
    Error::require(columns >= least(sections.closed), "columns", columns as f64)?;
    let kind = PointConstraint::Corner;
    let corners = alloc::collect(found.corners.iter().map(|&point| Constraint { point, kind }))?;
    let smooth = Options { corner_angle: std::f64::consts::PI, ..options.across };
    let across = curves(&found.nodes, columns, sections.closed, &corners, &smooth, &job.part(0.4, 0.6))?;
    let turned_back = |point: usize| (point % rows) * columns + point / rows;
    let turned_about = alloc::collect((0..found.nodes.len()).map(|point| found.nodes[turned_back(point)]))?;
    let along = curves(&turned_about, rows, options.ring, &[], &options.along, &job.part(0.6, 0.8))?;
    let (on_across, directions_across) = at_nodes(&across, columns, rows, |point| point, &job.part(0.8, 0.9))?;
    let (on_along, directions_along) = at_nodes(&along, rows, columns, turned_back, &job.part(0.9, 1.0))?;
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
        grid.max_twist = align::twist(&grid.nodes, columns, options.ring);
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

/// Curves through rows of `width` nodes each.
fn curves(
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

/// Where the curves pass their points, and in which direction, put at the places that `place` gives
/// to the points.
fn at_nodes(
    fit: &Fit,
    width: usize,
    count: usize,
    place: impl Fn(usize) -> usize,
    job: &Job<'_>,
) -> Result<(Vec<DVec3>, Vec<DVec3>)> {
    let mut points = alloc::filled(DVec3::ZERO, width * count)?;
    let mut directions = alloc::filled(DVec3::ZERO, width * count)?;
    for k in 0..count {
        let job = job.share(k, count);
        job.step(0.0, "directions at nodes")?;
        let (curve, own) = (fit.curve(k), k * width..(k + 1) * width);
        if curve.is_empty() {
            // No extent: all its points are one.
            own.for_each(|i| points[place(i)] = curve.points()[0]);
            continue;
        }
        let places = alloc::collect(own.clone().map(|i| fit.place(i)))?;
        let (on_curve, along) =
            (curve.points_at(&places, &job.part(0.0, 0.5))?, curve.tangents_at(&places, &job.part(0.5, 1.0))?);
        for ((i, p), direction) in own.zip(on_curve).zip(along) {
            (points[place(i)], directions[place(i)]) = (p, direction);
        }
    }
    Ok((points, directions))
}
