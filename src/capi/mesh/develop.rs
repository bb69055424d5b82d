//! C interface: developments.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::develop::{Chart, CutKind, Cuts, Developed, Distortion, Finish, Options, develop};
use gusset_base::alloc;

/// Lengths and areas: stretch and compression count alike, by the symmetric Dirichlet energy.
pub const GUSSET_DISTORTION_SYMMETRIC: u32 = 0;
/// Lengths: as rigid as possible.
pub const GUSSET_DISTORTION_RIGID: u32 = 1;
/// Angles: a least squares conformal map, which may stretch areas.
pub const GUSSET_DISTORTION_CONFORMAL: u32 = 2;

/// By unfolding about edges: every edge has its length.
pub const GUSSET_CHART_EXACT: u32 = 0;
/// By descent until nothing was gained.
pub const GUSSET_CHART_CONVERGED: u32 = 1;
/// By descent, ended by the number of steps.
pub const GUSSET_CHART_ITERATION_LIMIT: u32 = 2;
/// The conformal map that was asked for.
pub const GUSSET_CHART_CONFORMAL: u32 = 3;
/// The conformal map folds or overlaps: the chart has the least symmetric distortion instead.
pub const GUSSET_CHART_NOT_CONFORMAL: u32 = 4;
/// No map without folds was found: some triangles are turned over.
pub const GUSSET_CHART_FOLDED: u32 = 5;
/// By descent until no step was possible that gains: the border would meet itself, or rounding hides
/// it. Cuts or darts may help.
pub const GUSSET_CHART_STALLED: u32 = 6;

/// On a path that was given.
pub const GUSSET_CUT_GIVEN: u32 = 0;
/// To make a disc of a chart.
pub const GUSSET_CUT_OPENING: u32 = 1;
/// For a dart.
pub const GUSSET_CUT_DART: u32 = 2;

/// How a surface is developed; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_development_options {
    /// sizeof(gusset_development_options), set by the caller.
    pub struct_size: usize,
    /// Which distortion is least: GUSSET_DISTORTION_...
    pub distortion: u32,
    /// Darts at the most: cuts from the border of a chart to where its curvature is.
    pub max_darts: u32,
    /// Vertices of the mesh, path after path, along which it is cut. Vertices that follow one
    /// another are connected by the shortest path along edges; a path of one vertex cuts nothing.
    pub cuts: gusset_indices,
    /// Where each path begins among them, and the end of the last; empty for one path of all.
    pub cut_offsets: gusset_indices,
    /// No more darts are made once no length changes by a larger factor; above 1, or 0: all darts
    /// are made.
    pub max_stretch: f64,
    /// Steps of each descent at the most; 0: 200. A chart whose border would meet itself takes more
    /// than one, and so does one as rigid as possible.
    pub max_iterations: u32,
    /// 0.
    pub reserved: u32,
}

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
    /// How it came about: GUSSET_CHART_...
    pub finish: u32,
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

/// A development. Pointers are valid until it is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_development_view {
    /// sizeof(gusset_development_view), set by the caller.
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

/// A surface in the plane. Opaque and immutable; it keeps nothing of the mesh it was made from.
pub struct gusset_development {
    pub(crate) done: Developed,
    charts: Vec<gusset_chart>,
    cut_edges: Vec<u32>,
    cut_kinds: Vec<u32>,
}

handle! { gusset_development }

versioned! { gusset_development_options: 64 reserved, gusset_development_view: 112 reserved }
fixed! { gusset_chart: 72 }

c_enum! { distortion: Distortion {
    GUSSET_DISTORTION_SYMMETRIC => Symmetric, GUSSET_DISTORTION_RIGID => Rigid, GUSSET_DISTORTION_CONFORMAL => Conformal
} }

impl gusset_development_options {
    fn checked<'a>(&self, vertices: &'a [u32], offsets: &'a [u32]) -> Result<Options<'a>, Failure> {
        Ok(Options {
            distortion: choice(self.distortion)?,
            cuts: Cuts { vertices, offsets },
            max_darts: self.max_darts,
            max_stretch: (self.max_stretch != 0.0).then_some(self.max_stretch),
            max_iterations: self.max_iterations,
        })
    }
}

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

/// Lays a surface out in the plane with the least distortion: the pattern to cut it from.
///
/// The surface is cut along the paths given. What is no disc then, as a tube, a closed surface, one
/// with holes or handles, is opened along short paths. Each connected component of the rest is a
/// chart. One that can be unfolded about its edges, as cylinders, cones and tangent developables in
/// plane strips can, keeps the length of every edge to 1e-10 of it (of 1e-3 mean edges, if it is
/// shorter), before rounding: charts lie beside
/// one another, and far from the origin places are rounded more. It may overlap itself; triangles
/// without area may then be turned over by rounding. Any other chart descends to the least
/// distortion; no triangle is turned over, and the border does not meet itself, so that the map is
/// one to one. Where that ends the descent early, its finish is STALLED. Darts are made as long as
/// they lower the distortion: each is a cut from the border to the vertex whose scale in a conformal
/// map would be the worst.
///
/// The result has the faces of the mesh in their order, each from its own first corner and all
/// counterclockwise in the plane. Charts are turned so that the mean square of their borders'
/// distances from the middle is greatest along x. A vertex on a cut becomes several; of merged
/// vertices the smallest is meant. Edges of three or more faces, and those whose two faces disagree in
/// orientation, are borders, and no cuts. Polygons are measured by triangles they are cut into; a
/// triangle flatter than 1e-7 of its longest side, or smaller than 1e-7 of the mean edge, counts as
/// that large. Conformal maps have the area of the surface.
///
/// Nets and sheets are developed by their meshes; see gusset_net_mesh_create and
/// gusset_sheet_mesh_create.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param mesh the surface.
/// @param options NULL for the defaults.
/// @param[out] development receives the result, for gusset_development_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_RANGE
///     (max_stretch), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (a vertex of a cut; the
///     report's input is the cut, the index the place in it), CUT_NOT_CONNECTED (the same),
///     REPEATED_CORNER (a face), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(H log H) for H half-edges if charts unfold; else, for each step of the descent and
///     each dart, O(n^1.5) for n vertices of the chart. Memory O(n log n).
/// @source M. Rabinovich et al., Scalable locally injective mappings (2017), for the descent; B.
///     Levy et al., Least squares conformal maps (2002); J. Erickson, K. Whittlesey, Greedy optimal
///     homotopy and homology generators (2005), for the cuts that open; M. Ben-Chen et al.,
///     Conformal flattening by curvature prescription and metric scaling (2008), for darts.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_development_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_development_options,
    development: *mut *mut gusset_development,
) -> gusset_status {
    create(context, development, "development", |job| {
        let options = input::read(options, true, "options")?;
        let cuts = mesh::indices(&raw const options.cuts, "cuts")?.unwrap_or_default();
        let offsets = mesh::indices(&raw const options.cut_offsets, "cut_offsets")?.unwrap_or_default();
        let options = options.checked(&cuts, &offsets)?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let done = self::develop(&given_mesh.view(), &options, &job.part(0.1, 1.0))?;
        let stage = "putting the pieces together";
        Ok(gusset_development {
            charts: alloc::collect_cancellable(done.charts.iter().map(gusset_chart::from), &job.part(1.0, 1.0), stage)?,
            cut_edges: alloc::gather(done.cut_edges.iter().flat_map(|&(ends, _)| ends))?,
            cut_kinds: alloc::collect(done.cut_edges.iter().map(|&(_, why)| kind(why)))?,
            done,
        })
    })
}

/// Destroys a development; NULL is allowed.
///
/// @param[in,out] development the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_development_destroy(development: *mut gusset_development) {
    handle::destroy(development);
}

/// Lends the flat mesh, in the scalar type of the surface, with z = 0, valid until the development
/// is destroyed.
///
/// @param development the development.
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_development_get_mesh(
    development: *const gusset_development,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    lend!(development, view, |development| mesh::lend(&development.done.mesh))
}

/// Lends the places in the plane, where they come from, and the account of each chart.
///
/// @param development the development.
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: those of gusset_development_get_mesh.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_development_get_view(
    development: *const gusset_development,
    view: *mut gusset_development_view,
) -> gusset_status {
    lend!(development, view, |development| gusset_development_view {
        struct_size: size_of::<gusset_development_view>(),
        points: input::lent(&development.done.points).cast(),
        vertex_map: gusset_indices::lend(&development.done.vertex_map),
        face_charts: gusset_indices::lend(&development.done.face_charts),
        stretches: input::lent(&development.done.stretches).cast(),
        charts: input::lent(&development.charts),
        chart_count: development.charts.len(),
        cut_edges: gusset_indices::lend(&development.cut_edges),
        cut_kinds: gusset_indices::lend(&development.cut_kinds),
        darts: development.done.darts,
        reserved: 0,
    })
}
