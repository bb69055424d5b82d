//! Lines: Hits of lines and curves on a surface.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::curve::{gusset_curve, gusset_place, view_of_curve};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, surface_of_handle};
use crate::curve::Place;
use crate::surface::line_intersection::{CurveHit, Hit, HitSelection, Line, Lines};
use glam::DVec3;
use gusset_base::alloc;

/// A line, ray or segment: origin + t * direction, `from` <= t <= `to`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_line {
    /// Point at t = 0.
    pub origin: [f64; 3],
    /// Its squared length must not under- or overflow: 1e-150 to 1e150 is safe.
    pub direction: [f64; 3],
    /// Least t: -INFINITY for a line, 0 for a ray or segment.
    pub from: f64,
    /// Greatest t: INFINITY for a line or ray; at least `from`.
    pub to: f64,
}

/// The hits to return.
pub type gusset_hit_selection = u32;
/// All hits, ordered along the line.
pub const GUSSET_HITS_ALL: gusset_hit_selection = 0;
/// The first hit.
pub const GUSSET_HITS_FIRST: gusset_hit_selection = 1;
/// Any one hit.
pub const GUSSET_HITS_ANY: gusset_hit_selection = 2;

/// Kind of a hit.
pub type gusset_hit_kind = u32;
/// No hit.
pub const GUSSET_HIT_NONE: gusset_hit_kind = 0;
/// It passes through the surface. Proved, except at poles.
pub const GUSSET_HIT_CROSSING: gusset_hit_kind = 1;
/// It touches within the tolerance, in one point, two close ones, or none.
pub const GUSSET_HIT_TOUCH: gusset_hit_kind = 2;
/// It runs in the surface within the tolerance, over the whole span.
pub const GUSSET_HIT_INSIDE: gusset_hit_kind = 3;

/// A common point of a surface and a line or curve.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_hit {
    /// Parameter on the line; on a curve, segment + its parameter.
    pub t: f64,
    /// Parameters between which both agree within the tolerance; crossings: t twice.
    pub span: [f64; 2],
    /// Place on the surface.
    pub place: gusset_surface_place,
    /// Point on the surface.
    pub point: [f64; 3],
    /// Unit normal; at a pole its limit; 0 if undefined.
    pub normal: [f64; 3],
    /// Kind of a hit.
    pub kind: gusset_hit_kind,
    /// 0.
    pub reserved: u32,
}

/// Hits on a surface.
pub struct gusset_surface_hits {
    ends: Vec<u64>,
    hits: Vec<gusset_surface_hit>,
    on_curve: Vec<[gusset_place; 3]>,
}

handle! { gusset_surface_hits }

/// Lent hits.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_hits_view {
    /// sizeof(gusset_surface_hits_view).
    pub struct_size: usize,
    /// Lines, and the curve if given.
    pub query_count: usize,
    /// Number of hits.
    pub hit_count: usize,
    /// Offsets into hits, by query.
    /// @shape query_count+1
    pub ends: *const u64,
    /// The hits, by rising t in each query.
    /// @shape hit_count
    pub hits: *const gusset_surface_hit,
    /// Curve: for each hit, places of hit, start and end of span.
    /// @shape on_curve_count/3 3
    pub on_curve: *const gusset_place,
    /// Number of places on the curve.
    pub on_curve_count: usize,
}

versioned! { gusset_surface_hits_view: 56 }
fixed! { gusset_line: 64, gusset_surface_hit: 112 }

impl From<&Hit> for gusset_surface_hit {
    fn from(hit: &Hit) -> Self {
        gusset_surface_hit {
            t: hit.at,
            span: hit.span,
            place: hit.place.into(),
            point: hit.point.to_array(),
            normal: hit.normal.to_array(),
            kind: match hit.multiplicity {
                0 => GUSSET_HIT_INSIDE,
                1 => GUSSET_HIT_CROSSING,
                _ => GUSSET_HIT_TOUCH,
            },
            reserved: 0,
        }
    }
}

/// Reads the caller's lines, at any alignment.
pub(crate) fn read_lines(lines: *const gusset_line, count: usize) -> Result<Vec<Line>, Failure> {
    let lines = input::input_items(lines, count, "lines")?.map(|line: gusset_line| {
        let (origin, direction) = (DVec3::from_array(line.origin), DVec3::from_array(line.direction));
        Line { origin, direction, from: line.from, to: line.to }
    });
    Ok(alloc::collect(lines)?)
}

c_enum! { selection: HitSelection { GUSSET_HITS_ALL => All, GUSSET_HITS_FIRST => First, GUSSET_HITS_ANY => Any } }

/// Finds the hits of lines and a curve on a surface.
///
/// No hit is missed or repeated, also at sides of cells and sheets, joints and poles. A line's hits
/// do not depend on others.
///
/// @param lines NULL: none.
/// @param curve of degree 7 at most; NULL: none.
/// @errors OUT_OF_RANGE (line not finite, without direction, or ending before it begins; degree),
///     EMPTY_CURVE
/// @complexity About O(log cells) a line and a cell near the curve, O(1) a hit, bounded in cells
///     that a line runs in; parallel.
/// @source Leus, task c.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_hits_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    lines: *const gusset_line,
    count: usize,
    curve: *const gusset_curve,
    selection: gusset_hit_selection,
    hits: *mut *mut gusset_surface_hits,
) -> gusset_status {
    create_handle(context, hits, "hits", |job| {
        let (surface, selection) = (surface_of_handle(surface)?, read_choice(selection)?);
        let split = if curve.is_null() { 1.0 } else { 0.5 };
        let Lines { mut ends, hits } =
            surface.lines(&self::read_lines(lines, count)?, selection, &job.sub_job(0.0, split))?;
        let mut hits = alloc::collect(hits.iter().map(gusset_surface_hit::from))?;
        let mut on_curve = Vec::new();
        if !curve.is_null() {
            let found = surface.curve(&view_of_curve(curve, "curve")?, selection, &job.sub_job(split, 1.0))?;
            let number = |place: Place| f64::from(place.segment) + place.t;
            let hit = |&CurveHit { at, span, place, point, normal, tangent, multiplicity }: &CurveHit| {
                (&Hit { at: number(at), span: span.map(number), place, point, normal, tangent, multiplicity }).into()
            };
            let places = |hit: &CurveHit| [hit.at, hit.span[0], hit.span[1]].map(gusset_place::from);
            alloc::extend(&mut hits, found.iter().map(hit))?;
            on_curve = alloc::collect(found.iter().map(places))?;
            alloc::push(&mut ends, hits.len() as u64)?;
        }
        Ok(gusset_surface_hits { ends, hits, on_curve })
    })
}

/// Finds each line's first hit, of least t.
///
/// @param hits receives count hits; GUSSET_HIT_NONE and 0 without one, or after an error.
/// @errors as gusset_surface_hits_create
/// @complexity About O(log cells) a line; parallel.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_first_hits(
    context: *const gusset_context,
    surface: *const gusset_surface,
    lines: *const gusset_line,
    count: usize,
    hits: *mut gusset_surface_hit,
) -> gusset_status {
    let out = input::cleared_result_buffer(hits, count, "hits");
    guard_changing_call(context, |job| {
        let (out, surface) = (out?, surface_of_handle(surface)?);
        let found = surface.first_hits(&self::read_lines(lines, count)?, job)?;
        job.finish()?;
        for (out, hit) in out.iter_mut().zip(&found) {
            *out = hit.as_ref().map_or(bytemuck::Zeroable::zeroed(), gusset_surface_hit::from);
        }
        Ok(())
    })
}

/// Lends the hits.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_hits_get_view(
    hits: *const gusset_surface_hits,
    view: *mut gusset_surface_hits_view,
) -> gusset_status {
    lend!(hits, view, |found| gusset_surface_hits_view {
        struct_size: 0,
        query_count: found.ends.len() - 1,
        hit_count: found.hits.len(),
        ends: lend_list(&found.ends),
        hits: lend_list(&found.hits),
        on_curve: lend_list(found.on_curve.as_flattened()),
        on_curve_count: 3 * found.on_curve.len(),
    })
}

/// Frees hits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_hits_destroy(hits: *mut gusset_surface_hits) {
    handle::destroy(hits);
}
