//! Developments: Cuts surfaces open and lays them out in the plane with little distortion.
//!
//! @source W. Tutte (1963); B. Levy and others (2002); J. Erickson and K. Whittlesey (2005); M.
//!     Ben-Chen and others (2008); M. Rabinovich and others (2017).

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice};
use crate::capi::mesh::develop_report::{Development, gusset_develop_report};
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::develop::{Cuts, Distortion, Options, develop};

/// The distortion that a development minimises.
pub type gusset_distortion = u32;
/// Lengths and areas: stretch and compression count alike, by the symmetric Dirichlet energy.
pub const GUSSET_DISTORTION_SYMMETRIC: gusset_distortion = 0;
/// Lengths: as rigid as possible.
pub const GUSSET_DISTORTION_RIGID: gusset_distortion = 1;
/// Angles: a least squares conformal map, which may stretch areas.
pub const GUSSET_DISTORTION_CONFORMAL: gusset_distortion = 2;

/// How a surface is developed; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_develop_options {
    /// sizeof(gusset_develop_options), set by the caller.
    pub struct_size: usize,
    /// Which distortion is least.
    pub distortion: gusset_distortion,
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

versioned! { gusset_develop_options: 64 reserved }

c_enum! { distortion: Distortion {
    GUSSET_DISTORTION_SYMMETRIC => Symmetric, GUSSET_DISTORTION_RIGID => Rigid, GUSSET_DISTORTION_CONFORMAL => Conformal
} }

impl gusset_develop_options {
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
/// The result is a flat mesh in the scalar type of the surface, with z = 0. It has the faces of the mesh in their
/// order, each from its own first corner and all counterclockwise in the plane. Charts are turned so that the mean square of their borders'
/// distances from the middle is greatest along x. A vertex on a cut becomes several; of merged
/// vertices the smallest is meant. Edges of three or more faces, and those whose two faces disagree in
/// orientation, are borders, and no cuts. Polygons are measured by triangles they are cut into; a
/// triangle flatter than 1e-7 of its longest side, or smaller than 1e-7 of the mean edge, counts as
/// that large. Conformal maps have the area of the surface.
///
/// Nets and sheets are developed by their meshes; see gusset_net_to_mesh and
/// gusset_sheet_to_mesh.
///
/// @errors as gusset_mesh_view, OUT_OF_RANGE (max_stretch), BAD_OFFSETS (cut_offsets),
///     INDEX_OUT_OF_RANGE (a vertex of a cut; the report's input is the cut, the index the place in
///     it), CUT_NOT_CONNECTED (the same), REPEATED_CORNER (a face)
/// @complexity O(H log H) for H half-edges if charts unfold; else, for each step of the descent and
///     each dart, O(n^1.5) for n vertices of the chart. Memory O(n log n).
/// @source M. Rabinovich et al., Scalable locally injective mappings (2017), for the descent; B.
///     Levy et al., Least squares conformal maps (2002); J. Erickson, K. Whittlesey, Greedy optimal
///     homotopy and homology generators (2005), for the cuts that open; M. Ben-Chen et al.,
///     Conformal flattening by curvature prescription and metric scaling (2008), for darts.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_develop(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_develop_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?;
        let cuts = mesh::indices(&raw const options.cuts, "cuts")?.unwrap_or_default();
        let offsets = mesh::indices(&raw const options.cut_offsets, "cut_offsets")?.unwrap_or_default();
        let options = options.checked(&cuts, &offsets)?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let done = self::develop(&given_mesh.view(), &options, &job.part(0.1, 1.0))?;
        Ok(gusset_result(Made::Develop(Development::new(done, &job.part(1.0, 1.0))?)))
    })
}

/// Lends the places in the plane, the places they come from, and the report on each chart, for results of gusset_develop.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_develop(
    result: *const gusset_result,
    report: *mut gusset_develop_report,
) -> gusset_status {
    report!(result, report, "gusset_develop", Made::Develop(development) => development.report())
}
