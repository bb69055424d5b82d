//! The search of the paper: The search by the logical scale as printed, corrected: a documented
//! reference.
//!
//! @source Leus.

use crate::capi::context::{guard_change, gusset_context};
use crate::capi::curve::{gusset_curve, view};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input::{self, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::evaluate::surface_places;
use crate::capi::surface::sheet::{gusset_sheet, read};
use crate::capi::surface::{gusset_surface, gusset_surface_place};
use crate::curve::CurveView;
use crate::error::{Element, Error};
use crate::job::Job;
use crate::surface::line_intersection::Line;
use crate::surface::reference::{
    AngleTarget, Arcs, Diameters, Figure, Goal, Object, SearchOptions, SearchOutcome, Sum, angle_incidence,
    figure_incidence, normal_by_sections, normal_variation_by_cones, normal_variation_by_curvature,
};
use crate::surface::{Place, Sheet};
use glam::DVec3;

/// The object from which distances or angles are measured.
pub type gusset_reference_object = u32;
/// The point.
pub const GUSSET_REFERENCE_POINT: gusset_reference_object = 0;
/// The plane through the point, across the direction.
pub const GUSSET_REFERENCE_PLANE: gusset_reference_object = 1;
/// The line through the point, along the direction.
pub const GUSSET_REFERENCE_LINE: gusset_reference_object = 2;
/// The segment from the point to the point and the direction.
pub const GUSSET_REFERENCE_SEGMENT: gusset_reference_object = 3;
/// Normals at an angle to the direction; distances are deviations from the angle, in radians.
pub const GUSSET_REFERENCE_ANGLE: gusset_reference_object = 4;

/// The curve.
pub const GUSSET_REFERENCE_CURVE: gusset_reference_object = 5;
/// The surface.
pub const GUSSET_REFERENCE_SURFACE: gusset_reference_object = 6;
/// The ray from the point along the direction.
pub const GUSSET_REFERENCE_RAY: gusset_reference_object = 7;

/// The task of the paper's search, and its method.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_reference_task {
    /// sizeof(gusset_reference_task), set by the caller.
    pub struct_size: usize,
    /// The object from which distances or angles are measured.
    pub object: gusset_reference_object,
    /// 0: cells that may have something within `within`. 1: cells that may have the nearest.
    pub find_nearest: u32,
    /// A point of the object; not read for angles.
    pub point: [f64; 3],
    /// Its direction, of any length but 0; not read for points.
    pub direction: [f64; 3],
    /// A distance, 0 or more, in the unit of the nodes, for angles in radians; INFINITY: all cells;
    /// not read for the nearest.
    pub within: f64,
    /// For GUSSET_REFERENCE_ANGLE: the angle, 0 to pi.
    pub angle: f64,
    /// For GUSSET_REFERENCE_ANGLE: a bound of both principal curvatures all over the sheet, for the
    /// paper's K d, see gusset_sheet_measure; 0: cones of normals instead, which are
    /// tighter.
    pub curvature: f64,
    /// For GUSSET_REFERENCE_ANGLE: 1 if normals of the other side will do as well.
    pub unsigned_normals: u32,
    /// 1: blocks are bounded by sums of the greatest bound of each ring of cells, instead of J d.
    pub by_rings: u32,
    /// 1: nodes in the order of rows, as in the paper; 0: a few far apart first.
    pub by_rows: u32,
    /// 1: lines of nodes that a block covers from side to side are not left out at once.
    pub keep_lines: u32,
    /// For GUSSET_REFERENCE_CURVE: the curve; else not read.
    pub curve: *const gusset_curve,
    /// For GUSSET_REFERENCE_SURFACE: the surface; else not read.
    pub surface: *const gusset_surface,
}

/// A report on the search.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_reference_report {
    /// sizeof(gusset_reference_report), set by the caller.
    pub struct_size: usize,
    /// How many cells are left.
    pub cells: u64,
    /// How many nodes were looked at.
    pub evaluations: u64,
    /// How many blocks of cells were excluded.
    pub blocks: u64,
    /// How many lines of cells were left out at once.
    pub dropped: u64,
    /// The least distance of the nodes that were looked at; of the nearest task: of all nodes.
    pub min_distance: f64,
    /// The row of that node.
    pub row: u32,
    /// Its column.
    pub column: u32,
}

versioned! { gusset_reference_task: 104, gusset_reference_report: 56 }

impl gusset_reference_task {
    fn options(&self) -> Result<SearchOptions, Failure> {
        let nearest = flag(self.find_nearest, "find_nearest")?;
        Ok(SearchOptions {
            goal: if nearest { Goal::Least } else { Goal::Within(self.within) },
            sum: if flag(self.by_rings, "by_rings")? { Sum::Rings } else { Sum::Greatest },
            by_rows: flag(self.by_rows, "by_rows")?,
            drop_lines: !flag(self.keep_lines, "keep_lines")?,
        })
    }

    /// The object from which distances are measured; `None` for angles.
    fn figure(&self) -> Result<Option<Figure<'_>>, Failure> {
        let (point, direction) = (DVec3::from_array(self.point), DVec3::from_array(self.direction));
        Ok(Some(match self.object {
            GUSSET_REFERENCE_POINT => Figure::Object(Object::Point(point)),
            GUSSET_REFERENCE_PLANE => Figure::Object(Object::Plane { point, normal: direction }),
            GUSSET_REFERENCE_LINE => Figure::Object(Object::Line(Line::new(point, direction))),
            GUSSET_REFERENCE_SEGMENT => Figure::Object(Object::Line(Line::segment(point, point + direction))),
            GUSSET_REFERENCE_RAY => Figure::Object(Object::Line(Line::ray(point, direction))),
            GUSSET_REFERENCE_CURVE => Figure::Curve(view(self.curve, "curve")?),
            GUSSET_REFERENCE_SURFACE => Figure::Surface(&handle::get(self.surface, "surface")?.0),
            GUSSET_REFERENCE_ANGLE => return Ok(None),
            other => return Err(Failure::unknown("object", other.into())),
        }))
    }

    fn angle_target(&self) -> Result<AngleTarget, Failure> {
        let unsigned = flag(self.unsigned_normals, "unsigned_normals")?;
        Ok(AngleTarget { direction: DVec3::from_array(self.direction), angle: self.angle, unsigned })
    }

    fn search(&self, sheet: &Sheet<'_>, job: &Job<'_>) -> Result<SearchOutcome, Failure> {
        let (options, target) = (self.options()?, self.angle_target()?);
        let Some(figure) = self.figure()? else { return self.angle_incidence(sheet, target, &options, job) };
        let diameters = Diameters::new(sheet, &job.part(0.0, 0.5))?;
        Ok(figure_incidence(sheet, &diameters, figure, &options, &job.part(0.5, 1.0))?)
    }

    fn search_curve(&self, curve: &CurveView<'_>, parts: usize, job: &Job<'_>) -> Result<SearchOutcome, Failure> {
        let (options, target, figure) = (self.options()?, self.angle_target()?, self.figure()?);
        let arcs = Arcs::new(curve, parts, &job.part(0.0, 0.5))?;
        let job = job.part(0.5, 1.0);
        Ok(match figure {
            Some(figure) => arcs.incidence(figure, &options, &job)?,
            None => arcs.angle_incidence(target, &options, &job)?,
        })
    }

    fn angle_incidence(
        &self,
        sheet: &Sheet<'_>,
        target: AngleTarget,
        options: &SearchOptions,
        job: &Job<'_>,
    ) -> Result<SearchOutcome, Failure> {
        let (first, second) = (job.part(0.0, 0.3), job.part(0.3, 0.6));
        let variation = if self.curvature == 0.0 {
            normal_variation_by_cones(sheet, &second)?
        } else {
            normal_variation_by_curvature(sheet, &Diameters::new(sheet, &first)?, self.curvature, &second)?
        };
        Ok(angle_incidence(sheet, &variation, target, options, &job.part(0.6, 1.0))?)
    }
}

/// The paper's search with its logical scale, corrected: which cells of a sheet may have a point
/// within a distance of an object, or the nearest one, or a normal at an angle.
///
/// None that has is missing. It is the documented reference and looks at many nodes; a surface
/// (gusset_surface_create) answers the same and more from its index, much faster.
///
/// @param task what is looked for.
/// @param words receives a bit for each cell, laid out as for gusset_sheet_mask_chain; NULL with
///     capacity 0 for the size and the report alone; all words are 0 on failure.
/// @param capacity how many words it has room for.
/// @param written receives the number of words.
/// @param report what was done; its struct_size set by the caller; may be NULL.
/// @errors UNKNOWN_VALUE (object, flags), OUT_OF_RANGE (what is not finite, no direction, a
///     negative distance, an angle outside 0 to pi), BUFFER_TOO_SMALL
/// @complexity O(cells) for the bounds of cells, with threads; O(cells / 64) and the nodes looked
///     at for the search.
/// @source Leus; docs/errata.md lists its errata.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_reference_mask(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    task: *const gusset_reference_task,
    words: *mut u64,
    capacity: usize,
    written: *mut usize,
    report: *mut gusset_reference_report,
) -> gusset_status {
    mask(context, (words, capacity, written), report, task, |task, job| task.search(read(sheet)?, job))
}

/// Runs a search and writes its mask and report.
fn mask(
    context: *const gusset_context,
    (words, capacity, written): (*mut u64, usize, *mut usize),
    report: *mut gusset_reference_report,
    task: *const gusset_reference_task,
    search: impl FnOnce(&gusset_reference_task, &Job<'_>) -> Result<SearchOutcome, Failure>,
) -> gusset_status {
    let written = input::output(written, 0, "written");
    let buffer = input::cleared(words, if words.is_null() { 0 } else { capacity }, "words");
    let report = if report.is_null() { Ok(None) } else { input::output_struct(report, "report").map(Some) };
    guard_change(context, |job| {
        let (written, report, task) = (written?, report?, input::read(task, false, "task")?);
        buffer?;
        let found = search(&task, job)?;
        input::copy((words, capacity, "words"), found.mask.words(), written, job)?;
        let ([row, column], min_distance) = found.least;
        if let Some(report) = report {
            report.write(gusset_reference_report {
                struct_size: 0,
                cells: found.mask.count() as u64,
                evaluations: found.evaluations,
                blocks: found.blocks,
                dropped: found.dropped,
                min_distance,
                row: row as u32,
                column: column as u32,
            });
        }
        Ok(())
    })
}

/// The same search over a curve's own points, with the lengths of its arcs for diameters: which
/// arcs may have a point within a distance of an object, or the nearest one, or a tangent at an
/// angle.
///
/// Each segment is divided into as many arcs of equal length in the parameter; the cells of the mask
/// are the arcs in the order of the curve, its nodes their ends. No arc that has what is looked for
/// is missing.
///
/// @param parts arcs of each segment, at least 1; 2^30 of all at most.
/// @param task what is looked for; angles are those of tangents, for which curvature and lines are
///     not read, and unsigned_normals counts tangents of either direction.
/// @param words receives a bit for each arc: that of arc k is bit k % 64 of word k / 64; NULL with
///     capacity 0 for the size and the report alone; all words are 0 on failure.
/// @param capacity how many words it has room for.
/// @param written receives the number of words.
/// @param report what was done: columns are points of the curve, rows 0; its struct_size set by the
///     caller; may be NULL.
/// @errors as gusset_sheet_reference_mask, EMPTY_CURVE, OUT_OF_RANGE (parts), TOO_LARGE
/// @complexity O(arcs degree^2) for the lengths; O(arcs / 64) and the nodes looked at for the
///     search.
/// @source Leus, the last paragraph.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_reference_mask(
    context: *const gusset_context,
    curve: *const gusset_curve,
    parts: usize,
    task: *const gusset_reference_task,
    words: *mut u64,
    capacity: usize,
    written: *mut usize,
    report: *mut gusset_reference_report,
) -> gusset_status {
    mask(context, (words, capacity, written), report, task, |task, job| {
        task.search_curve(&view(curve, "curve")?, parts, job)
    })
}

/// The paper's approximate normals: at each place two orthogonal planes, parallel to the mean of
/// the normals at the cell's corners, cut the lines of the net; cubics through four crossings each
/// have tangents that span the tangent plane.
///
/// They are of third order in the size of cells; the exact normals of the surface are had from a surface.
///
/// @param places count places of the sheet, whose own number is not read, at any alignment; u and v
///     0 to 1.
/// @param count see places.
/// @param normals receives x, y, z of each; 0 where there is none, and everywhere on failure.
/// @errors UNKNOWN_VALUE (reserved), NO_SUCH_ELEMENT (with the first place that the sheet does not
///     have: no such cell, parameters that are not 0 to 1)
/// @complexity Bounded work for each.
/// @source Leus, fig. 1.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_normals_by_sections(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    places: *const gusset_surface_place,
    count: usize,
    normals: *mut f64,
) -> gusset_status {
    let out = input::cleared(normals.cast::<[f64; 3]>(), count, "normals");
    guard_change(context, |job| {
        let (out, sheet, places) = (out?, read(sheet)?, surface_places(places, count)?);
        let done = normals_at(sheet, &places, out, job).and_then(|()| Ok(job.memory()?));
        done.inspect_err(|_| out.fill([0.0; 3]))
    })
}

fn normals_at(sheet: &Sheet<'_>, places: &[Place], out: &mut [[f64; 3]], job: &Job<'_>) -> Result<(), Failure> {
    for (k, (out, place)) in out.iter_mut().zip(places).enumerate() {
        job.step_every(256, k, places.len(), "normals")?;
        // As a surface says it: one place in the array is wrong, whichever of its numbers it is.
        let missing = |_| Error::NoSuch { element: Element::Place, index: k as u64 };
        *out = normal_by_sections(sheet, place.cell.map(|k| k as usize), place.u, place.v).map_err(missing)?.to_array();
    }
    Ok(())
}
