//! The search of the paper: Leus's search by the logical scale, with corrections.
//!
//! @source V. Leus (see the README).

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::curve::{gusset_curve, view_of_curve};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle;
use crate::capi::input::{self, read_flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::evaluate::read_surface_places;
use crate::capi::surface::sheet::{gusset_sheet, sheet_of_handle};
use crate::capi::surface::{gusset_surface, gusset_surface_place};
use crate::curve::CurveView;
use crate::error::{Element, Error};
use crate::job::Job;
use crate::surface::line_intersection::Line;
use crate::surface::reference::{
    AngleTarget, CellBoundSum, CurveArcs, Diameters, Figure, PointPlaneOrLine, SearchGoal, SearchOptions,
    SearchOutcome, find_cells_near_figure, find_cells_with_angle, normal_by_sections, normal_variation_by_cones,
    normal_variation_by_curvature,
};
use crate::surface::{Place, Sheet};
use glam::DVec3;

/// Object of a search.
pub type gusset_reference_object = u32;
/// The point.
pub const GUSSET_REFERENCE_POINT: gusset_reference_object = 0;
/// The plane through `point` with the normal `direction`.
pub const GUSSET_REFERENCE_PLANE: gusset_reference_object = 1;
/// The line through `point` along `direction`.
pub const GUSSET_REFERENCE_LINE: gusset_reference_object = 2;
/// The segment from `point` to `point` + `direction`.
pub const GUSSET_REFERENCE_SEGMENT: gusset_reference_object = 3;
/// Normals at `angle` to `direction`. Distances are deviations from it.
pub const GUSSET_REFERENCE_ANGLE: gusset_reference_object = 4;

/// The curve.
pub const GUSSET_REFERENCE_CURVE: gusset_reference_object = 5;
/// The surface.
pub const GUSSET_REFERENCE_SURFACE: gusset_reference_object = 6;
/// The ray from `point` along `direction`.
pub const GUSSET_REFERENCE_RAY: gusset_reference_object = 7;

/// Task and method of Leus's search. Fields name their object without prefix.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_reference_task {
    /// sizeof(gusset_reference_task).
    pub struct_size: usize,
    /// Object of a search.
    pub object: gusset_reference_object,
    /// Cells to find: 0: those that may have a point `within`; 1: the nearest point's.
    pub find_nearest: u32,
    /// Not read for angles.
    pub point: [f64; 3],
    /// Not read for points.
    pub direction: [f64; 3],
    /// Largest distance; INFINITY: all cells. Not read with find_nearest.
    pub within: f64,
    /// ANGLE: 0 to pi.
    pub angle: f64,
    /// ANGLE: bound of the sheet's absolute principal curvatures, as from gusset_sheet_measure. 0:
    /// cones of normals, which are tighter.
    pub curvature: f64,
    /// ANGLE. 1: a normal and its opposite are equal.
    pub unsigned_normals: u32,
    /// Bound of blocks. 1: sum of each ring's greatest bound; 0: integer diameter times the
    /// greatest.
    pub by_rings: u32,
    /// 1: visits nodes row by row, like Leus; 0: distant ones first.
    pub by_rows: u32,
    /// 0: removes rows and columns of cells at an edge that an excluded block covers; 1: keeps
    /// them.
    pub keep_lines: u32,
    /// CURVE.
    pub curve: *const gusset_curve,
    /// SURFACE.
    pub surface: *const gusset_surface,
}

/// Result and work of Leus's search.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_reference_report {
    /// sizeof(gusset_reference_report).
    pub struct_size: usize,
    /// Cells that remain.
    pub cells: u64,
    /// Nodes evaluated.
    pub evaluations: u64,
    /// Blocks of cells excluded.
    pub blocks: u64,
    /// Lines of cells removed.
    pub dropped: u64,
    /// Least distance of evaluated nodes (find_nearest: of all).
    pub min_distance: f64,
    /// Row of its node.
    pub row: u32,
    /// Column of its node.
    pub column: u32,
}

versioned! { gusset_reference_task: 104, gusset_reference_report: 56 }

impl gusset_reference_task {
    fn search_options(&self) -> Result<SearchOptions, Failure> {
        let nearest = read_flag(self.find_nearest, "find_nearest")?;
        Ok(SearchOptions {
            goal: if nearest { SearchGoal::Least } else { SearchGoal::Within(self.within) },
            sum: if read_flag(self.by_rings, "by_rings")? { CellBoundSum::Rings } else { CellBoundSum::Greatest },
            by_rows: read_flag(self.by_rows, "by_rows")?,
            drop_lines: !read_flag(self.keep_lines, "keep_lines")?,
        })
    }

    /// Returns the object from which distances are measured; `None` for angles.
    fn distance_figure(&self) -> Result<Option<Figure<'_>>, Failure> {
        let (point, direction) = (DVec3::from_array(self.point), DVec3::from_array(self.direction));
        Ok(Some(match self.object {
            GUSSET_REFERENCE_POINT => Figure::Object(PointPlaneOrLine::Point(point)),
            GUSSET_REFERENCE_PLANE => Figure::Object(PointPlaneOrLine::Plane { point, normal: direction }),
            GUSSET_REFERENCE_LINE => Figure::Object(PointPlaneOrLine::Line(Line::new(point, direction))),
            GUSSET_REFERENCE_SEGMENT => Figure::Object(PointPlaneOrLine::Line(Line::segment(point, point + direction))),
            GUSSET_REFERENCE_RAY => Figure::Object(PointPlaneOrLine::Line(Line::ray(point, direction))),
            GUSSET_REFERENCE_CURVE => Figure::Curve(view_of_curve(self.curve, "curve")?),
            GUSSET_REFERENCE_SURFACE => Figure::Surface(&handle::get_object(self.surface, "surface")?.0),
            GUSSET_REFERENCE_ANGLE => return Ok(None),
            other => {
                return Err(Failure::unknown_choice(
                    "object",
                    other,
                    &constants![
                        GUSSET_REFERENCE_POINT,
                        GUSSET_REFERENCE_PLANE,
                        GUSSET_REFERENCE_LINE,
                        GUSSET_REFERENCE_SEGMENT,
                        GUSSET_REFERENCE_RAY,
                        GUSSET_REFERENCE_CURVE,
                        GUSSET_REFERENCE_SURFACE,
                        GUSSET_REFERENCE_ANGLE
                    ],
                ));
            }
        }))
    }

    fn angle_target(&self) -> Result<AngleTarget, Failure> {
        let unsigned = read_flag(self.unsigned_normals, "unsigned_normals")?;
        Ok(AngleTarget { direction: DVec3::from_array(self.direction), angle: self.angle, unsigned })
    }

    fn search_sheet(&self, sheet: &Sheet<'_>, job: &Job<'_>) -> Result<SearchOutcome, Failure> {
        let (options, target) = (self.search_options()?, self.angle_target()?);
        let Some(figure) = self.distance_figure()? else {
            return self.search_angle_incidence(sheet, target, &options, job);
        };
        let diameters = Diameters::new(sheet, &job.sub_job(0.0, 0.5))?;
        Ok(find_cells_near_figure(sheet, &diameters, figure, &options, &job.sub_job(0.5, 1.0))?)
    }

    fn search_curve(&self, curve: &CurveView<'_>, parts: usize, job: &Job<'_>) -> Result<SearchOutcome, Failure> {
        let (options, target, figure) = (self.search_options()?, self.angle_target()?, self.distance_figure()?);
        let arcs = CurveArcs::new(curve, parts, &job.sub_job(0.0, 0.5))?;
        let job = job.sub_job(0.5, 1.0);
        Ok(match figure {
            Some(figure) => arcs.find_arcs_near_figure(figure, &options, &job)?,
            None => arcs.find_cells_with_angle(target, &options, &job)?,
        })
    }

    fn search_angle_incidence(
        &self,
        sheet: &Sheet<'_>,
        target: AngleTarget,
        options: &SearchOptions,
        job: &Job<'_>,
    ) -> Result<SearchOutcome, Failure> {
        let (first, second) = (job.sub_job(0.0, 0.3), job.sub_job(0.3, 0.6));
        let variation = if self.curvature == 0.0 {
            normal_variation_by_cones(sheet, &second)?
        } else {
            normal_variation_by_curvature(sheet, &Diameters::new(sheet, &first)?, self.curvature, &second)?
        };
        Ok(find_cells_with_angle(sheet, &variation, target, options, &job.sub_job(0.6, 1.0))?)
    }
}

/// Finds the cells of a sheet that may satisfy a task, by Leus's search.
///
/// No qualifying cell is missing. gusset_surface answers faster.
///
/// @param words receives a bit a cell, as for gusset_sheet_mask_chain; 0 after an error.
/// @param report may be NULL.
/// @errors OUT_OF_RANGE (non-finite values, zero direction, within, angle), BUFFER_TOO_SMALL
/// @complexity O(cells), parallel, for bounds; O(cells / 64 + nodes evaluated) for the search.
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
    run_and_write_search(context, (words, capacity, written), report, task, |task, job| {
        task.search_sheet(sheet_of_handle(sheet)?, job)
    })
}

/// Runs a search and writes its mask and report.
fn run_and_write_search(
    context: *const gusset_context,
    (words, capacity, written): (*mut u64, usize, *mut usize),
    report: *mut gusset_reference_report,
    task: *const gusset_reference_task,
    search: impl FnOnce(&gusset_reference_task, &Job<'_>) -> Result<SearchOutcome, Failure>,
) -> gusset_status {
    let written = input::cleared_output(written, 0, "written");
    let buffer = input::cleared_result_buffer(words, if words.is_null() { 0 } else { capacity }, "words");
    let report = if report.is_null() { Ok(None) } else { input::output_struct(report, "report").map(Some) };
    guard_changing_call(context, |job| {
        let (written, report, task) = (written?, report?, input::read_versioned_struct(task, false, "task")?);
        buffer?;
        let found = search(&task, job)?;
        input::copy_to_buffer((words, capacity, "words"), found.possible_cells.words(), written, job)?;
        let ([row, column], min_distance) = found.nearest_node_and_distance;
        if let Some(report) = report {
            report.write_known_fields(gusset_reference_report {
                struct_size: 0,
                cells: found.possible_cells.count() as u64,
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

/// Finds the arcs of a curve that may satisfy a task.
///
/// Each segment has `parts` arcs of equal parameter length, numbered along the curve. No qualifying
/// arc is missing. GUSSET_REFERENCE_ANGLE refers to tangents, unsigned_normals to both directions;
/// curvature and keep_lines are not read.
///
/// @param parts arcs of each segment, at least 1; at most 2^30 arcs in all.
/// @param words receives a bit an arc: k is bit k % 64 of word k / 64; 0 after an error.
/// @param report row is 0, column the point of the curve; may be NULL.
/// @errors as gusset_sheet_reference_mask, EMPTY_CURVE, OUT_OF_RANGE (parts), TOO_LARGE
/// @complexity O(arcs degree^2) for lengths; O(arcs / 64 + nodes evaluated) for the search.
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
    run_and_write_search(context, (words, capacity, written), report, task, |task, job| {
        task.search_curve(&view_of_curve(curve, "curve")?, parts, job)
    })
}

/// Approximates normals by Leus's sections, to third order in the size of cells.
///
/// Two orthogonal planes parallel to the mean normal of the cell's corners cut the net's lines. In
/// each, a cubic through four crossings gives a tangent. gusset_surface_evaluate is exact.
///
/// @param places their sheet is not read.
/// @param normals receives count normals; 0 if undefined or after an error.
/// @errors NO_SUCH_ELEMENT (place; also a parameter outside 0 to 1)
/// @complexity O(1) a place.
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
    let out = input::cleared_result_buffer(normals.cast::<[f64; 3]>(), count, "normals");
    guard_changing_call(context, |job| {
        let (out, sheet, places) = (out?, sheet_of_handle(sheet)?, read_surface_places(places, count)?);
        let done = normals_at(sheet, &places, out, job).and_then(|()| Ok(job.finish()?));
        done.inspect_err(|_| out.fill([0.0; 3]))
    })
}

fn normals_at(sheet: &Sheet<'_>, places: &[Place], out: &mut [[f64; 3]], job: &Job<'_>) -> Result<(), Failure> {
    for (k, (out, place)) in out.iter_mut().zip(places).enumerate() {
        job.step_every(256, k, places.len(), "normals")?;
        // As for a surface: the place in the array is at fault, not one of its numbers.
        let missing = |_| Error::NoSuch { element: Element::Place, index: k as u64, count: 1 };
        *out = normal_by_sections(sheet, place.cell.map(|k| k as usize), place.u, place.v).map_err(missing)?.to_array();
    }
    Ok(())
}
