//! Developments: reports: Charts, cuts and distortion of a development.

use crate::capi::glue::{fixed, versioned};
use crate::capi::input::lent;
use crate::capi::mesh::gusset_indices;
use crate::develop::{Chart, CutKind, Developed, Finish};
use crate::error::Error;
use crate::job::Job;
use gusset_base::alloc;

/// How a chart was laid out.
pub type gusset_chart_finish = u32;
/// By unfolding about edges: every edge has its length.
pub const GUSSET_CHART_EXACT: gusset_chart_finish = 0;
/// By descent until nothing was gained.
pub const GUSSET_CHART_CONVERGED: gusset_chart_finish = 1;
/// By descent, ended by the number of steps.
pub const GUSSET_CHART_ITERATION_LIMIT: gusset_chart_finish = 2;
/// The conformal map that was asked for.
pub const GUSSET_CHART_CONFORMAL: gusset_chart_finish = 3;
/// The conformal map folds or overlaps: the chart has the least symmetric distortion instead.
pub const GUSSET_CHART_NOT_CONFORMAL: gusset_chart_finish = 4;
/// No map without folds was found: some triangles are turned over.
pub const GUSSET_CHART_FOLDED: gusset_chart_finish = 5;
/// By descent until no step was possible that gains: the border would meet itself, or rounding hides
/// it. Cuts or darts may help.
pub const GUSSET_CHART_STALLED: gusset_chart_finish = 6;

/// The reason for a cut.
pub type gusset_cut_kind = u32;
/// On a path that was given.
pub const GUSSET_CUT_GIVEN: gusset_cut_kind = 0;
/// To make a disc of a chart.
pub const GUSSET_CUT_OPENING: gusset_cut_kind = 1;
/// For a dart.
pub const GUSSET_CUT_DART: gusset_cut_kind = 2;

/// A chart: a connected component of the development.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_chart {
    /// Its first vertex among those of the result.
    pub first_vertex: u32,
    /// How many follow one another.
    pub vertex_count: u32,
    /// The number of its faces; see face_charts.
    pub face_count: u32,
    /// How it came about.
    pub finish: gusset_chart_finish,
    /// Steps of all its descents.
    pub iterations: u32,
    /// Pairs of edges of its border that meet in the plane, neighbours apart; of EXACT charts those
    /// that cross by more than 1e-8 of the root of the area. Only EXACT and FOLDED charts can have
    /// some.
    pub overlaps: u32,
    /// Triangles that are turned over; 0 but for FOLDED.
    pub folds: u32,
    /// 0.
    pub reserved: u32,
    /// The symmetric Dirichlet energy: the mean over the area of the sum of s^2 + 1 / s^2 over both
    /// singular values s of the map to the plane; 4 for an isometry, which has the least.
    pub energy: f64,
    /// The largest factor by which a length grows.
    pub max_stretch: f64,
    /// The least.
    pub min_stretch: f64,
    /// The area of the surface, in the squared unit of the positions.
    pub area: f64,
    /// The area in the plane.
    pub flat_area: f64,
}

/// Where a surface lies in the plane. Pointers are valid until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_develop_report {
    /// sizeof(gusset_develop_report), set by the caller.
    pub struct_size: usize,
    /// x, y of each vertex in the plane, in the unit of the positions, in double precision whatever
    /// their type.
    pub points: *const f64,
    /// Of each vertex, that of the surface that it is; vertices on cuts are several.
    pub vertex_map: gusset_indices,
    /// Of each face its chart.
    pub face_charts: gusset_indices,
    /// Of each face two numbers: the largest factor by which lengths in it grow, and the least.
    pub stretches: *const f64,
    /// Charts, in the order of their first faces. They lie beside one another along x.
    pub charts: *const gusset_chart,
    /// How many.
    pub chart_count: usize,
    /// Edges of the surface that were cut, two vertices an edge; first those given, then those that
    /// open, then darts.
    pub cut_edges: gusset_indices,
    /// Of each of them GUSSET_CUT_...
    pub cut_kinds: gusset_indices,
    /// The number of darts.
    pub darts: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_develop_report: 112 reserved }
fixed! { gusset_chart: 72 }

impl From<&Chart> for gusset_chart {
    fn from(chart: &Chart) -> Self {
        gusset_chart {
            first_vertex: chart.vertices.start,
            vertex_count: chart.vertices.len() as u32,
            face_count: chart.faces,
            finish: match chart.finish {
                Finish::Exact => GUSSET_CHART_EXACT,
                Finish::Converged => GUSSET_CHART_CONVERGED,
                Finish::IterationLimit => GUSSET_CHART_ITERATION_LIMIT,
                Finish::Stalled => GUSSET_CHART_STALLED,
                Finish::Conformal => GUSSET_CHART_CONFORMAL,
                Finish::NotConformal => GUSSET_CHART_NOT_CONFORMAL,
                Finish::Folded => GUSSET_CHART_FOLDED,
            },
            iterations: chart.iterations,
            overlaps: chart.overlaps,
            folds: chart.folds,
            reserved: 0,
            energy: chart.energy,
            max_stretch: chart.stretch[0],
            min_stretch: chart.stretch[1],
            area: chart.area,
            flat_area: chart.flat_area,
        }
    }
}

fn kind(kind: CutKind) -> u32 {
    match kind {
        CutKind::Given => GUSSET_CUT_GIVEN,
        CutKind::Opening => GUSSET_CUT_OPENING,
        CutKind::Dart => GUSSET_CUT_DART,
    }
}

/// A surface in the plane, and the reports on its charts and cuts.
pub(crate) struct Development {
    pub(crate) done: Developed,
    charts: Vec<gusset_chart>,
    cut_edges: Vec<u32>,
    cut_kinds: Vec<u32>,
}

impl Development {
    pub(crate) fn new(done: Developed, job: &Job<'_>) -> Result<Self, Error> {
        let stage = "putting the pieces together";
        Ok(Development {
            charts: alloc::collect_cancellable(done.charts.iter().map(gusset_chart::from), job, stage)?,
            cut_edges: alloc::gather(done.cut_edges.iter().flat_map(|&(ends, _)| ends))?,
            cut_kinds: alloc::collect(done.cut_edges.iter().map(|&(_, why)| kind(why)))?,
            done,
        })
    }

    pub(crate) fn report(&self) -> gusset_develop_report {
        gusset_develop_report {
            struct_size: size_of::<gusset_develop_report>(),
            points: lent(&self.done.points).cast(),
            vertex_map: gusset_indices::lend(&self.done.vertex_map),
            face_charts: gusset_indices::lend(&self.done.face_charts),
            stretches: lent(&self.done.stretches).cast(),
            charts: lent(&self.charts),
            chart_count: self.charts.len(),
            cut_edges: gusset_indices::lend(&self.cut_edges),
            cut_kinds: gusset_indices::lend(&self.cut_kinds),
            darts: self.done.darts,
            reserved: 0,
        }
    }
}
