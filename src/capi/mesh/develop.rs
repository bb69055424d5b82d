//! Developments: Flattens surfaces with little distortion.
//!
//! @source W. Tutte (1963); B. Levy and others (2002); J. Erickson and K. Whittlesey (2005); M.
//!     Ben-Chen and others (2008); M. Rabinovich and others (2017).

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, read_choice};
use crate::capi::mesh::develop_report::{DevelopedSurface, gusset_develop_report};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::develop::{Cuts, Distortion, Options, develop};

/// Distortion that a development minimises.
pub type gusset_distortion = u32;
/// Lengths and areas, stretch and compression alike: the symmetric Dirichlet energy.
pub const GUSSET_DISTORTION_SYMMETRIC: gusset_distortion = 0;
/// Lengths: as rigid as possible.
pub const GUSSET_DISTORTION_RIGID: gusset_distortion = 1;
/// Angles: the least-squares conformal map, which may stretch areas.
pub const GUSSET_DISTORTION_CONFORMAL: gusset_distortion = 2;

/// Options of gusset_develop.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_develop_options {
    /// sizeof(gusset_develop_options).
    pub struct_size: usize,
    /// Distortion that a development minimises.
    pub distortion: gusset_distortion,
    /// Most darts: cuts from a chart's border to where it is curved.
    pub max_darts: u32,
    /// Vertices of paths to cut along, path after path, connected by shortest edge paths. A path of
    /// one vertex cuts nothing.
    pub cuts: gusset_indices,
    /// Start of each path in cuts, and the end of the last. Empty: one path.
    pub cut_offsets: gusset_indices,
    /// Darts stop once no length changes by a larger factor; above 1, finite; 0: none.
    pub max_stretch: f64,
    /// Most steps of a descent; 0: 200. Charts whose border would meet itself, and
    /// GUSSET_DISTORTION_RIGID, need several descents.
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
            distortion: read_choice(self.distortion)?,
            cuts: Cuts { vertices, offsets },
            max_darts: self.max_darts,
            max_stretch: (self.max_stretch != 0.0).then_some(self.max_stretch),
            max_iterations: self.max_iterations,
        })
    }
}

/// Flattens a surface with the least distortion.
///
/// The surface is cut along the given paths, then into discs along short paths. Each component is
/// then a chart. The result has the surface's scalar type and z = 0; faces keep their order and
/// first corners, counter-clockwise.
/// - A chart that unfolds about its edges keeps their lengths, to 1e-10 of the length, or of 1e-3
///   mean edges if more. Rounding errors grow with the distance from the origin. The chart may
///   overlap itself, and rounding may turn over triangles without area.
/// - Other charts descend to the least distortion. The map is one-to-one: no triangle is turned
///   over, and the border does not meet itself. If this ends the descent early, finish is
///   GUSSET_CHART_STALLED.
/// - Darts run from the border to the vertex with the worst conformal scale, while they lower the
///   distortion.
/// - Each chart's border has the greatest variance along x.
/// - A vertex on a cut becomes several. Merged vertices count as the smallest.
/// - Non-manifold edges, and edges whose faces disagree in orientation, are borders, not cuts.
/// - Polygons are measured by triangles. Triangles count as at least 1e-7 of their longest side
///   high, and 1e-7 of the mean edge large.
/// - A conformal map has the area of the surface.
///
/// @errors as gusset_mesh_view, OUT_OF_RANGE (max_stretch, coordinates beyond 1e150),
///     BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (input is the cut, index the place in it),
///     CUT_NOT_CONNECTED (likewise), REPEATED_CORNER
/// @complexity O(H log H) if charts unfold; else O(n^1.5) for n vertices of a chart, each step and
///     each dart; memory O(n log n).
/// @source Rabinovich et al. 2017, for the descent; Levy et al., Least squares conformal maps,
///     2002; Erickson and Whittlesey 2005, for opening cuts; Ben-Chen et al. 2008, for darts.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_develop(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_develop_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let cuts = mesh::read_indices(&raw const options.cuts, "cuts")?.unwrap_or_default();
        let offsets = mesh::read_indices(&raw const options.cut_offsets, "cut_offsets")?.unwrap_or_default();
        let options = options.checked(&cuts, &offsets)?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let done = self::develop(&given_mesh.mesh_view(), &options, &job.sub_job(0.1, 1.0))?;
        Ok(gusset_result(OperationResult::Develop(DevelopedSurface::new(done, &job.sub_job(1.0, 1.0))?)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_develop(
    result: *const gusset_result,
    report: *mut gusset_develop_report,
) -> gusset_status {
    report!(result, report, "gusset_develop", OperationResult::Develop(development) => development.develop_report())
}
