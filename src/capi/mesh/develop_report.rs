//! Developments: reports: Charts, cuts and distortion.

use crate::capi::glue::{fixed, versioned};
use crate::capi::input::lend_list;
use crate::capi::mesh::gusset_indices;
use crate::develop::{Chart, CutKind, Developed, Finish};
use crate::error::Error;
use crate::job::Job;
use gusset_base::alloc;

/// Outcome of the layout of a chart.
pub type gusset_chart_finish = u32;
/// Unfolded about edges: all edges keep their lengths.
pub const GUSSET_CHART_EXACT: gusset_chart_finish = 0;
/// Descended until nothing was gained.
pub const GUSSET_CHART_CONVERGED: gusset_chart_finish = 1;
/// Descended until max_iterations.
pub const GUSSET_CHART_ITERATION_LIMIT: gusset_chart_finish = 2;
/// The requested conformal map.
pub const GUSSET_CHART_CONFORMAL: gusset_chart_finish = 3;
/// The map with the least symmetric distortion: the conformal map folds or overlaps.
pub const GUSSET_CHART_NOT_CONFORMAL: gusset_chart_finish = 4;
/// Some triangles are turned over: no map without folds was found.
pub const GUSSET_CHART_FOLDED: gusset_chart_finish = 5;
/// Descended until no step gained: the border would meet itself, or rounding hides the gain. Cuts
/// or darts may help.
pub const GUSSET_CHART_STALLED: gusset_chart_finish = 6;

/// Reason for a cut.
pub type gusset_cut_kind = u32;
/// On a given path.
pub const GUSSET_CUT_GIVEN: gusset_cut_kind = 0;
/// To open a component to a disc.
pub const GUSSET_CUT_OPENING: gusset_cut_kind = 1;
/// For a dart.
pub const GUSSET_CUT_DART: gusset_cut_kind = 2;

/// Connected component of a development.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_chart {
    /// First vertex in the result; the chart's vertices are consecutive.
    pub first_vertex: u32,
    /// Number of vertices.
    pub vertex_count: u32,
    /// Number of faces.
    pub face_count: u32,
    /// Outcome of the layout of a chart.
    pub finish: gusset_chart_finish,
    /// Steps of all descents.
    pub iterations: u32,
    /// Pairs of border edges that meet in the plane, except neighbours. GUSSET_CHART_EXACT:
    /// crossings by over 1e-8 of the area's root. GUSSET_CHART_FOLDED: all. Else 0.
    pub overlaps: u32,
    /// Triangles turned over, by GUSSET_CHART_FOLDED only.
    pub folds: u32,
    /// 0.
    pub reserved: u32,
    /// Symmetric Dirichlet energy: the area's mean of the sum of s^2 + 1 / s^2 over both singular
    /// values s of the map; 4 for an isometry, else more; infinite if a triangle is turned over
    /// or flat, up to rounding.
    pub energy: f64,
    /// Largest factor by which a length grows.
    pub max_stretch: f64,
    /// Smallest factor by which a length grows.
    pub min_stretch: f64,
    /// Area of the surface.
    pub area: f64,
    /// Area in the plane.
    pub flat_area: f64,
}

/// Points, charts and cuts of a development.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_develop_report {
    /// sizeof(gusset_develop_report).
    pub struct_size: usize,
    /// x, y of each vertex in the plane.
    /// @shape vertex_map 2
    pub points: *const f64,
    /// Vertex of the surface for each vertex; repeats on cuts.
    pub vertex_map: gusset_indices,
    /// Chart of each face.
    pub face_charts: gusset_indices,
    /// Largest and smallest factor by which each face's lengths grow.
    /// @shape face_charts 2
    pub stretches: *const f64,
    /// Charts in the order of their first faces, side by side along x.
    /// @shape chart_count
    pub charts: *const gusset_chart,
    /// Number of charts.
    pub chart_count: usize,
    /// Cut edges of the surface, two vertices each: given, opening, then dart cuts.
    /// @shape * 2
    pub cut_edges: gusset_indices,
    /// GUSSET_CUT_... of each cut edge.
    /// @choice gusset_cut_kind
    pub cut_kinds: gusset_indices,
    /// Darts.
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

fn cut_kind_code(kind: CutKind) -> u32 {
    match kind {
        CutKind::Given => GUSSET_CUT_GIVEN,
        CutKind::Opening => GUSSET_CUT_OPENING,
        CutKind::Dart => GUSSET_CUT_DART,
    }
}

/// A surface in the plane, and the reports on its charts and cuts.
pub(crate) struct DevelopedSurface {
    pub(crate) developed: Developed,
    charts: Vec<gusset_chart>,
    cut_edges: Vec<u32>,
    cut_kinds: Vec<u32>,
}

impl DevelopedSurface {
    pub(crate) fn new(done: Developed, job: &Job<'_>) -> Result<Self, Error> {
        let stage = "putting the pieces together";
        Ok(DevelopedSurface {
            charts: alloc::collect_cancellable(done.charts.iter().map(gusset_chart::from), job, stage)?,
            cut_edges: alloc::gather(done.cut_edges.iter().flat_map(|&(ends, _)| ends))?,
            cut_kinds: alloc::collect(done.cut_edges.iter().map(|&(_, why)| cut_kind_code(why)))?,
            developed: done,
        })
    }

    pub(crate) fn develop_report(&self) -> gusset_develop_report {
        gusset_develop_report {
            struct_size: size_of::<gusset_develop_report>(),
            points: lend_list(&self.developed.points).cast(),
            vertex_map: gusset_indices::lend_indices(&self.developed.vertex_map),
            face_charts: gusset_indices::lend_indices(&self.developed.face_charts),
            stretches: lend_list(&self.developed.stretches).cast(),
            charts: lend_list(&self.charts),
            chart_count: self.charts.len(),
            cut_edges: gusset_indices::lend_indices(&self.cut_edges),
            cut_kinds: gusset_indices::lend_indices(&self.cut_kinds),
            darts: self.developed.darts,
            reserved: 0,
        }
    }
}
