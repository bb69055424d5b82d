//! Surfaces of frames, which the module of outlines computes.

use super::curve_net::GordonSurface;
use super::net_curve::{CurvePlace, NetCurve, max_segment_degree};
use super::section_skin::skin_sections;
use crate::{Grid, Nodes, Patches, Scheme, Sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::frame::{Frame, NodeGrid, repeated_sections};
use gusset_curve::{Fit, Place};

/// The parts of a frame that define the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum FrameSurface {
    /// The curves of the sections. Between two equal sections, one straight behind the other, the
    /// surface is their cylinder.
    #[default]
    Sections,
    /// The nodes, as a grid. If some curves have corners, which a grid would round, all curves are
    /// used instead. Fourth order between smooth sections.
    Nodes,
    /// The curves too: the Gordon surface, which contains them.
    Curves,
}

choices! { for FrameSurface:
    Sections => "Sections", "The curves of the sections, without bulges between them.";
    Nodes => "Nodes", "The nodes: bicubic patches from 6 x 6 of them each; the curves if some have corners.";
    Curves => "Curves", "All curves through the nodes, across and along.";
}

impl Sheet<'static> {
    /// Creates the surface of a frame. u runs along the body from section to section, v around it.
    /// `closed` tells whether the last section is followed by the first one, as in a ring, and
    /// whether each section is closed.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`]; [`Error::RepeatedSection`], as [`repeated_sections`] tells; with curves,
    /// the errors of [`Sheet::from_curves`], and [`Error::CurveNotClosed`]; [`Error::NotFinite`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn from_frame(frame: &Frame, closed: [bool; 2], kind: FrameSurface, job: &Job<'_>) -> Result<Self> {
        Sheet::from_frame_parts(&frame.grid, [&frame.across, &frame.along], closed, kind, job)
    }

    /// Creates the surface of a frame from its parts: nodes, and the curves across and along.
    pub fn from_frame_parts(
        grid: &NodeGrid,
        curves: [&Fit; 2],
        closed: [bool; 2],
        kind: FrameSurface,
        job: &Job<'_>,
    ) -> Result<Self> {
        let counts = [grid.rows, grid.columns];
        let min = closed.map(|closed| if closed { 3 } else { 2 });
        if grid.rows < min[0] || grid.columns < min[1] {
            return Err(Error::NetTooSmall { rows: grid.rows as u64, columns: grid.columns as u64 });
        }
        if let Some(repeat) = repeated_sections(grid, closed[0])?.first() {
            return Err(Error::RepeatedSection { section: repeat.section, earlier: repeat.earlier });
        }
        if kind == FrameSurface::Nodes && grid.corners.is_empty() {
            return node_sheet(counts, &grid.nodes, closed, job);
        }
        let used = if kind == FrameSurface::Sections { &curves[..1] } else { &curves[..] };
        let degree = max_segment_degree(used.iter().flat_map(|fit| (0..fit.len()).map(|k| fit.curve(k))))?;
        Ok(if degree <= 3 {
            Sheet::Cubic(patches_of_frame(grid, curves, closed, kind, job)?)
        } else {
            Sheet::High(patches_of_frame(grid, curves, closed, kind, job)?)
        })
    }
}

const PROGRESS_STAGE: &str = "surface of a frame";
/// Number of nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 17;

/// Creates the grid of the nodes. Repeats the first line at the end of a closed direction.
fn node_sheet(
    [rows, columns]: [usize; 2],
    nodes: &[DVec3],
    closed: [bool; 2],
    job: &Job<'_>,
) -> Result<Sheet<'static>> {
    let [height, width] = [rows + usize::from(closed[0]), columns + usize::from(closed[1])];
    let mut data = alloc::with_capacity(3 * height * width)?;
    let places = (0..height).flat_map(|i| (0..width).map(move |j| (i % rows, j % columns)));
    for (k, (i, j)) in places.enumerate() {
        job.step_every(NODES_PER_REPORT, k, height * width, PROGRESS_STAGE)?;
        data.extend(nodes[i * columns + j].to_array());
    }
    let nodes = Nodes::strided(data, height, width, 0, 0)?;
    Ok(Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap)?))
}

/// Creates the patches through the sections, or through all curves.
fn patches_of_frame<const N: usize>(
    grid: &NodeGrid,
    [across, along]: [&Fit; 2],
    closed: [bool; 2],
    kind: FrameSurface,
    job: &Job<'_>,
) -> Result<Patches<N>> {
    let (rows, columns) = (grid.rows, grid.columns);
    let net_curves = |fit: &Fit, job: &Job<'_>| {
        alloc::try_collect((0..fit.len()).map(|k| {
            job.step(k as f64 / fit.len() as f64, PROGRESS_STAGE)?;
            NetCurve::new(&fit.curve(k))
        }))
    };
    let at = |net_curve: &NetCurve<N>, place: Place| {
        let (segment, count) = (place.segment as usize, net_curve.segments.len());
        // A joint counts as the start of the next segment.
        match place.t {
            _ if net_curve.is_single_point() => CurvePlace { segment: 0, parameter: 0.0 },
            1.0 if net_curve.closed => CurvePlace { segment: (segment + 1) % count, parameter: 0.0 },
            1.0 if segment + 1 < count => CurvePlace { segment: segment + 1, parameter: 0.0 },
            t => CurvePlace { segment, parameter: t },
        }
    };
    let row_curves = net_curves(across, &job.sub_job(0.0, 0.05))?;
    let on_row = |n: usize| at(&row_curves[n / columns], across.place(n));
    if kind == FrameSurface::Sections {
        let places = (0..rows * columns).map(on_row);
        let places = alloc::collect_cancellable(places, &job.sub_job(0.05, 0.1), PROGRESS_STAGE)?;
        return skin_sections(row_curves, &places, &grid.nodes, closed, &job.sub_job(0.1, 1.0));
    }
    let column_curves = net_curves(along, &job.sub_job(0.05, 0.1))?;
    let places = (0..rows * columns).map(|n| {
        let (k, l) = (n / columns, n % columns);
        [on_row(n), at(&column_curves[l], along.place(l * rows + k))]
    });
    let places = alloc::collect_cancellable(places, &job.sub_job(0.1, 0.15), PROGRESS_STAGE)?;
    GordonSurface::from_crossing_curves(row_curves, column_curves, closed, &places, &job.sub_job(0.15, 0.5))?
        .compute_patches(&job.sub_job(0.5, 1.0))
}
