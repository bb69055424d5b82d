//! Lines: Intersections of lines, rays, segments and curves with a surface.

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::curve::{gusset_curve, gusset_place, view};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, lent};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, read};
use crate::curve::Place;
use crate::surface::line_intersection::{CurveHit, Hit, HitSelection, Line, Lines};
use glam::DVec3;
use gusset_base::alloc;

/// A line, ray or segment: the points origin + t * direction for t from `from` to `to`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_line {
    /// x, y, z of the point where t is 0; from -1e150 to 1e150.
    pub origin: [f64; 3],
    /// x, y, z of the direction; of a length whose square neither vanishes nor overflows, such as
    /// any from 1e-150 to 1e150. t counts lengths of it.
    pub direction: [f64; 3],
    /// The least t: -INFINITY for lines, 0 for rays and segments; not INFINITY.
    pub from: f64,
    /// The greatest t: INFINITY for lines and rays; not below `from`, and not -INFINITY.
    pub to: f64,
}

/// Which hits are wanted.
pub type gusset_hit_selection = u32;
/// All, in the order of the line.
pub const GUSSET_HITS_ALL: gusset_hit_selection = 0;
/// The first one.
pub const GUSSET_HITS_FIRST: gusset_hit_selection = 1;
/// Any one: whether there is one.
pub const GUSSET_HITS_ANY: gusset_hit_selection = 2;

/// The kind of a hit.
pub type gusset_hit_kind = u32;
/// None.
pub const GUSSET_HIT_NONE: gusset_hit_kind = 0;
/// It passes through the surface: proved, except at poles, where the surface is not regular.
pub const GUSSET_HIT_CROSSING: gusset_hit_kind = 1;
/// It touches the surface within the tolerance: one point, two close to each other, or none.
pub const GUSSET_HIT_TOUCH: gusset_hit_kind = 2;
/// It runs in the surface, within the tolerance, all over the span.
pub const GUSSET_HIT_INSIDE: gusset_hit_kind = 3;

/// A point that a line or a curve and a surface have in common.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_hit {
    /// Where on the line; of a curve the number of the segment and the parameter on it, added.
    pub t: f64,
    /// From where to where it cannot be told from the surface, within the tolerance; t twice at
    /// crossings.
    pub span: [f64; 2],
    /// Where on the surface.
    pub place: gusset_surface_place,
    /// x, y, z of the point of the surface.
    pub point: [f64; 3],
    /// x, y, z of the unit normal there, its limit at a pole, or 0 if there is none.
    pub normal: [f64; 3],
    /// The kind of a hit.
    pub kind: gusset_hit_kind,
    /// 0.
    pub reserved: u32,
}

/// Where lines and a curve meet a surface. Opaque and immutable; it keeps nothing of the surface.
pub struct gusset_surface_hits {
    ends: Vec<u64>,
    hits: Vec<gusset_surface_hit>,
    on_curve: Vec<[gusset_place; 3]>,
}

handle! { gusset_surface_hits }

/// The hits. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_hits_view {
    /// sizeof(gusset_surface_hits_view), set by the caller.
    pub struct_size: usize,
    /// How many were asked about: the lines, and after them the curve, if there is one.
    pub query_count: usize,
    /// How many hits there are in all.
    pub hit_count: usize,
    /// 0, then the end of each query's hits among all: query k has the hits from ends[k] until
    /// ends[k + 1]. query_count + 1 numbers.
    pub ends: *const u64,
    /// The hits, query after query, each by rising t.
    pub hits: *const gusset_surface_hit,
    /// For each hit of the curve three places on the curve: the hit, and where its span begins and
    /// ends. NULL without a curve.
    pub on_curve: *const gusset_place,
    /// The number of places on the curve.
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

/// The caller's lines, at any alignment.
pub(crate) fn lines(lines: *const gusset_line, count: usize) -> Result<Vec<Line>, Failure> {
    let lines = input::items(lines, count, "lines")?.map(|line: gusset_line| {
        let (origin, direction) = (DVec3::from_array(line.origin), DVec3::from_array(line.direction));
        Line { origin, direction, from: line.from, to: line.to }
    });
    Ok(alloc::collect(lines)?)
}

c_enum! { selection: HitSelection { GUSSET_HITS_ALL => All, GUSSET_HITS_FIRST => First, GUSSET_HITS_ANY => Any } }

/// Finds where lines, rays, segments and a curve in space meet a surface; for each line what a call
/// with it alone gives.
///
/// A point on a side between cells, on one that sheets share, at a joint of the curve's segments, or
/// at a pole is found once, and none is missed: where a line or the curve touches the surface or runs
/// in it, a hit says from where to where.
///
/// @param lines count of them, at any alignment; NULL for none.
/// @param count see lines.
/// @param curve of degree 7 at most; NULL for none. Its hits follow the hits of the lines, in the
///     order of the curve.
/// @errors OUT_OF_RANGE (with the line that is not finite, has no direction, ends before it begins,
///     for a degree), EMPTY_CURVE
/// @complexity About O(log cells) a line and O(1) a hit; bounded in each cell that a line runs in.
///     About O(log cells) for each cell that the curve comes near to; bounded for each segment and
///     cell that run in each other. Threads.
/// @source Leus, "Carcasses on smooth surfaces", task c.
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
    create(context, hits, "hits", |job| {
        let (surface, selection) = (read(surface)?, choice(selection)?);
        let split = if curve.is_null() { 1.0 } else { 0.5 };
        let Lines { mut ends, hits } = surface.lines(&self::lines(lines, count)?, selection, &job.part(0.0, split))?;
        let mut hits = alloc::collect(hits.iter().map(gusset_surface_hit::from))?;
        let mut on_curve = Vec::new();
        if !curve.is_null() {
            let found = surface.curve(&view(curve, "curve")?, selection, &job.part(split, 1.0))?;
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

/// Finds the first hit of each of many lines, rays or segments: the hit of least t, which
/// gusset_surface_hits_create gives first.
///
/// @param lines count of them, at any alignment.
/// @param count see lines.
/// @param hits receives count results, one a line; kind is GUSSET_HIT_NONE, and all else 0, where
///     there is none, and everywhere on failure.
/// @errors as gusset_surface_hits_create, MISALIGNED_ARGUMENT (hits)
/// @complexity About O(log cells) a line; threads.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_first_hits(
    context: *const gusset_context,
    surface: *const gusset_surface,
    lines: *const gusset_line,
    count: usize,
    hits: *mut gusset_surface_hit,
) -> gusset_status {
    let out = input::cleared(hits, count, "hits");
    guard_change(context, |job| {
        let (out, surface) = (out?, read(surface)?);
        let found = surface.first_hits(&self::lines(lines, count)?, job)?;
        job.memory()?;
        for (out, hit) in out.iter_mut().zip(&found) {
            *out = hit.as_ref().map_or(bytemuck::Zeroable::zeroed(), gusset_surface_hit::from);
        }
        Ok(())
    })
}

/// The hits, lent until they are destroyed.
///
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
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
        ends: lent(&found.ends),
        hits: lent(&found.hits),
        on_curve: lent(found.on_curve.as_flattened()),
        on_curve_count: 3 * found.on_curve.len(),
    })
}

/// Frees hits; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_hits_destroy(hits: *mut gusset_surface_hits) {
    handle::destroy(hits);
}
