//! The nodes of a frame: which points of neighbouring sections correspond.
//!
//! Every correspondence gives each section the same number of nodes. The nodes are the given
//! points, equal parts of the arc length, the intersections with half-planes through an axis, or
//! equal parts between landmarks such as common corners. Cost: one fit and, except for given
//! points, one length of each section, plus O(columns log segments). By angle it is O(columns x
//! segments).

use crate::curve::{CurveView, Place};

use super::axis::axis_frames;
use super::frame_options::{Correspondence, FrameOptions};
use super::section_alignment::{AnchoredSection, farthest_from_mean, section_start_fractions};
use super::section_corners::{
    MAX_CORNERS_PER_SECTION, apportion_parts, find_corners_of_sections, nodes_with_sharp_turn,
    point_constraints_with_corners,
};
use super::section_landmarks::{Landmark, SectionCorners, find_landmarks};
use crate::identify::{Fit, Options, Outlines, fit};
use crate::ops::ArcLengths;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort;
use std::f64::consts::{PI, TAU};

/// Landmarks of a section between two progress reports.
const LANDMARKS_PER_REPORT: usize = 1 << 8;

/// The nodes of all sections, row by row.
pub(super) struct SectionNodes {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) nodes: Vec<DVec3>,
    pub(super) turned: Vec<u8>,
    pub(super) ambiguous: Vec<u32>,
    /// The nodes that are corners of their sections, ascending.
    pub(super) corners: Vec<u32>,
}

pub(super) fn compute_section_nodes(
    sections: &Outlines<'_>,
    options: &FrameOptions<'_>,
    job: &Job<'_>,
) -> Result<SectionNodes> {
    let rows = sections.check_offsets_and_constraints()?;
    let corners = find_corners_of_sections(sections, rows, options)?;
    let constraints = point_constraints_with_corners(sections, &corners)?;
    // The given points already include the corners.
    let across = Options { corner_angle: PI, ..options.across };
    let curves = fit(&Outlines { constraints: &constraints, ..*sections }, &across, &job.sub_job(0.0, 0.5))?;
    let job = job.sub_job(0.5, 1.0);
    let mut found = SectionNodes {
        rows,
        columns: 0,
        nodes: Vec::new(),
        turned: alloc::filled(0, rows)?,
        ambiguous: Vec::new(),
        corners: Vec::new(),
    };
    match options.correspondence {
        Correspondence::Given => add_given_points(sections, &corners, &mut found)?,
        Correspondence::ArcLength { columns } => {
            let least = if sections.closed { 3 } else { 2 };
            Error::require(columns >= least, "columns", columns as f64, Allowed::AtLeast(least as f64))?;
            add_nodes_by_arc_length(sections, &curves, &corners, columns, options, &mut found, &job)?;
        }
        Correspondence::Angle { columns, axis, reference } => {
            let frames = axis_frames(axis, reference, rows, options.ring)?;
            found.reserve_columns(columns)?;
            for (k, &(point, [along, first, second])) in frames.iter().enumerate() {
                let (curve, of_section) = (curves.curve(k), job.sub_job_of_item(k, rows));
                if let (true, Some(&pole)) = (curve.is_empty(), curve.points().first()) {
                    found.nodes.extend(std::iter::repeat_n(pole, columns));
                    continue;
                }
                for i in 0..columns {
                    let angle = TAU * i as f64 / columns as f64;
                    let ray = first * libm::cos(angle) + second * libm::sin(angle);
                    found.add_farthest_crossing(
                        &curve,
                        k,
                        point,
                        ray,
                        along.cross(ray),
                        &of_section.sub_job_of_item(i, columns),
                    )?;
                }
                if !options.smooth_corners {
                    let own = nodes_with_sharp_turn(&found.nodes[k * columns..], sections.closed, &options.across)?;
                    alloc::extend(&mut found.corners, own.iter().map(|&i| (k * columns) as u32 + i))?;
                }
            }
        }
        Correspondence::Landmarks { points, parts } => {
            add_landmark_nodes(sections, &curves, points, parts, &mut found, &job)?;
            let each = points.len() / rows;
            for (place, landmark) in points.iter().enumerate() {
                let (k, i) = (place / each, place % each);
                if corners[k].binary_search(landmark).is_ok() {
                    alloc::push(&mut found.corners, (k * found.columns + i * parts) as u32)?;
                }
            }
        }
    }
    Ok(found)
}

fn outline_curve(curves: &Fit, k: usize) -> Result<CurveView<'_>> {
    let curve = curves.curve(k);
    if curve.is_empty() { Err(Error::NoNode { section: k as u32, column: 0 }) } else { Ok(curve) }
}

impl SectionNodes {
    /// Reserves room for `columns` nodes in each row.
    fn reserve_columns(&mut self, columns: usize) -> Result<()> {
        let count = (self.rows as u64).saturating_mul(columns as u64);
        Error::check_count("nodes", count, u32::MAX.into())?;
        self.columns = columns;
        alloc::reserve(&mut self.nodes, count as usize)
    }

    /// Adds the intersection of a section with the half-plane from the axis through `point` towards
    /// `ray`. It takes the intersection farthest from the axis.
    fn add_farthest_crossing(
        &mut self,
        curve: &CurveView<'_>,
        section: usize,
        point: DVec3,
        ray: DVec3,
        normal: DVec3,
        job: &Job<'_>,
    ) -> Result<()> {
        let crossings = curve.intersect_plane(point, normal, &job.sub_job(0.0, 0.9))?;
        let (mut hits, mut farthest) = (0, None);
        let mut greatest = 0.0;
        for p in curve.points_at(&crossings.places, &job.sub_job(0.9, 1.0))? {
            let distance = (p - point).dot(ray);
            hits += usize::from(distance > 0.0);
            if distance > greatest {
                (greatest, farthest) = (distance, Some(p));
            }
        }
        let node = self.nodes.len();
        let Some(p) = farthest else {
            return Err(Error::NoNode { section: section as u32, column: (node - section * self.columns) as u32 });
        };
        if hits > 1 {
            alloc::push(&mut self.ambiguous, node as u32)?;
        }
        self.nodes.push(p);
        Ok(())
    }
}

/// Adds the nodes between landmarks. Each interval between landmarks gets a number of parts in
/// proportion to its mean length, at least one. A section that is one point has all its nodes there.
fn add_nodes_by_arc_length(
    sections: &Outlines<'_>,
    curves: &Fit,
    corners: &[Vec<u32>],
    columns: usize,
    options: &FrameOptions<'_>,
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<()> {
    let closed = sections.closed;
    let has_extent = |&k: &usize| !curves.curve(k).is_empty();
    let live = alloc::gather((0..found.rows).filter(has_extent))?;
    if live.is_empty() {
        return Err(Error::OnlyTips);
    }
    let measured = measure_sections(sections, curves, &live, options, found, &job.sub_job(0.0, 0.4))?;
    let place = |at: usize, mark: u32| curves.place(sections.point_range(live[at]).start + mark as usize);
    let mut marked = alloc::with_capacity(live.len())?;
    for (at, section) in measured.iter().enumerate() {
        let fraction =
            |mark: u32| Ok((mark, section.length_from_anchor(place(at, mark))? / section.lengths.total_length()));
        let mut own = Vec::new();
        if corners[live[at]].len() <= MAX_CORNERS_PER_SECTION {
            own = alloc::try_collect(corners[live[at]].iter().map(|&mark| fraction(mark)))?;
        }
        sort::sort_stable(&mut own, &|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        // Two corners at one place are one corner.
        own.dedup_by_key(|&mut (_, fraction)| fraction);
        marked.push(own);
    }
    let starts = if !closed || options.given_starts {
        alloc::filled(0.0, live.len())?
    } else {
        section_start_fractions(&measured, options.ring, &job.sub_job(0.4, 0.5))?
    };
    let position = corner_positions(sections, &live, &marked)?;
    let distance = |at: usize, i: u32, j: u32| position(at, i).distance_squared(position(at + 1, j));
    let mut marks = find_landmarks(&marked, closed, &starts, &distance, &job.sub_job(0.5, 0.7))?;
    if closed {
        let first = first_landmark(&marks, &measured[0], options)?;
        marks.rotate_left(first);
    }
    // The start of each section's interval after each landmark, and the interval's fraction.
    let span = |at: usize, i: usize| {
        let by = marks[(i + 1) % marks.len()].fractions[at] - marks[i].fractions[at];
        if by > 0.0 { by } else { by + 1.0 }
    };
    let intervals = if closed { marks.len() } else { marks.len() - 1 };
    let mut shares = alloc::filled(0.0, intervals)?;
    for (i, share) in shares.iter_mut().enumerate() {
        *share = (0..live.len()).map(|at| span(at, i)).sum();
    }
    let parts = if closed { columns } else { columns - 1 }.max(intervals);
    found.reserve_columns(if closed { parts } else { parts + 1 })?;
    let counts = apportion_parts(&shares, parts)?;
    let mut at = 0;
    for k in 0..found.rows {
        job.step(0.7 + 0.3 * k as f64 / found.rows as f64, "finding nodes")?;
        if live.get(at) != Some(&k) {
            found.nodes.extend(std::iter::repeat_n(curves.curve(k).points()[0], found.columns));
            continue;
        }
        let section = &measured[at];
        let place = |i: usize| match marks[i].corners[at] {
            Some(corner) => Ok(place(at, corner)),
            None if closed => section.place_at_fraction(marks[i].fractions[at]),
            None => section.lengths.place_at_length(marks[i].fractions[at] * section.lengths.total_length()),
        };
        let sign = if section.backwards { -1.0 } else { 1.0 };
        for (i, &parts) in counts.iter().enumerate() {
            if marks[i].corners[at].is_some() {
                alloc::push(&mut found.corners, found.nodes.len() as u32)?;
            }
            let whole = sign * span(at, i) * section.lengths.total_length();
            add_evenly_spaced_nodes(&section.lengths, place(i)?, whole, [parts, parts], closed, &mut found.nodes)?;
        }
        if !closed {
            found.nodes.push(section.lengths.curve().point(place(intervals)?)?);
        }
        at += 1;
    }
    Ok(())
}

/// Returns the lengths of the sections that are not single points. Each closed section is oriented
/// like the previous one instead of the first, because a body may be bent.
fn measure_sections<'a>(
    sections: &Outlines<'_>,
    curves: &'a Fit,
    live: &[usize],
    options: &FrameOptions<'_>,
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<Vec<AnchoredSection<'a>>> {
    let mut measured = alloc::with_capacity(live.len())?;
    let mut before = DVec3::ZERO;
    for (at, &k) in live.iter().enumerate() {
        job.step(at as f64 / live.len() as f64, "finding nodes")?;
        let lengths = outline_curve(curves, k)?.arc_lengths(&job.sub_job_of_item(at, live.len()))?;
        if !sections.closed {
            measured.push(AnchoredSection { lengths, anchor_length: 0.0, backwards: false });
            continue;
        }
        let turn = section_normal(sections, k);
        let backwards = turn.dot(before) < 0.0;
        if turn != DVec3::ZERO {
            before = if backwards { -turn } else { turn };
        }
        found.turned[k] = backwards.into();
        let span = sections.point_range(k);
        let start =
            if options.given_starts { 0 } else { farthest_from_mean(span.clone().map(|i| sections.points.get(i))) };
        let anchor = lengths.length_to(curves.place(span.start + start))?;
        measured.push(AnchoredSection { lengths, anchor_length: anchor, backwards });
    }
    Ok(measured)
}

/// Returns the landmark with which closed sections begin: the farthest from the first section's centre,
/// or the first one after its first point.
fn first_landmark(marks: &[Landmark], section: &AnchoredSection<'_>, options: &FrameOptions<'_>) -> Result<usize> {
    if options.given_starts {
        return Ok(0);
    }
    let place = |mark: &Landmark| section.lengths.curve().point(section.place_at_fraction(mark.fractions[0])?);
    let points = alloc::try_collect(marks.iter().map(place))?;
    Ok(farthest_from_mean(points.into_iter()))
}

/// Returns a function that returns the position of a section's corner relative to the section's centre,
/// in a unit that keeps squares in range.
fn corner_positions<'a>(
    sections: &'a Outlines<'a>,
    live: &'a [usize],
    marked: &[SectionCorners],
) -> Result<impl Fn(usize, u32) -> DVec3 + use<'a>> {
    let points = |k: usize| sections.point_range(k).map(move |i| sections.points.get(i));
    let centre = |&k: &usize| points(k).map(|p| p / points(k).len() as f64).sum::<DVec3>();
    let centres = alloc::collect(live.iter().map(centre))?;
    let mut all = alloc::copied(&centres)?;
    for (own, &k) in marked.iter().zip(live) {
        let first = sections.point_range(k).start;
        alloc::extend(&mut all, own.iter().map(|&(corner, _)| sections.points.get(first + corner as usize)))?;
    }
    let unit = common_unit(&all);
    Ok(move |at: usize, corner: u32| {
        let point = sections.points.get(sections.point_range(live[at]).start + corner as usize);
        point / unit - centres[at] / unit
    })
}

fn add_given_points(sections: &Outlines<'_>, corners: &[Vec<u32>], found: &mut SectionNodes) -> Result<()> {
    let columns = sections.points_per_section(found.rows)?;
    found.reserve_columns(columns)?;
    for (k, corners) in corners.iter().enumerate() {
        let span = sections.point_range(k);
        let repeats = if span.len() == 1 { columns } else { 1 };
        found.nodes.extend(span.flat_map(|i| std::iter::repeat_n(sections.points.get(i), repeats)));
        alloc::extend(&mut found.corners, corners.iter().map(|&corner| (k * columns) as u32 + corner))?;
    }
    Ok(())
}

/// Returns the normal about which the polygon of a section turns, of length 1 or 0.
fn section_normal(sections: &Outlines<'_>, k: usize) -> DVec3 {
    let span = sections.point_range(k);
    let start = sections.points.get(span.start);
    let seen = span.clone().map(|i| sections.points.get(i) * 0.25 - start * 0.25);
    let largest = seen.clone().fold(0.0, |m: f64, p| m.max(p.abs().max_element()));
    if largest == 0.0 {
        return DVec3::ZERO;
    }
    let scaled = seen.map(|p| p / largest);
    let area: DVec3 = scaled.clone().zip(scaled.skip(1)).map(|(p, q)| p.cross(q)).sum();
    area.normalize_or_zero()
}

/// Adds `count` nodes from a place on. Consecutive nodes are `length` / `steps` apart, backwards if
/// `length` is negative. A `closed` curve continues at its start.
fn add_evenly_spaced_nodes(
    lengths: &ArcLengths<'_>,
    from: Place,
    whole: f64,
    [steps, count]: [usize; 2],
    closed: bool,
    nodes: &mut Vec<DVec3>,
) -> Result<()> {
    let (start, total) = (lengths.length_to(from)?, lengths.total_length());
    nodes.push(lengths.curve().point(from)?);
    for i in 1..count {
        let at = match start + whole * (i as f64 / steps as f64) {
            at if closed && at < 0.0 => at + total,
            at if closed && at >= total => at - total,
            at => at,
        };
        nodes.push(lengths.curve().point(lengths.place_at_length(at)?)?);
    }
    Ok(())
}

/// Adds the landmarks of each section and the nodes between them.
fn add_landmark_nodes(
    sections: &Outlines<'_>,
    curves: &Fit,
    points: &[u32],
    parts: usize,
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<()> {
    let check = |value: usize, is_valid: bool, allowed: &'static str| {
        Error::require(is_valid, "landmarks", value as f64, allowed)
    };
    let is_even = found.rows > 0 && !points.is_empty() && points.len().is_multiple_of(found.rows);
    check(points.len(), is_even, "as many as a multiple of the sections")?;
    Error::require(parts > 0, "parts", parts as f64, "at least 1")?;
    let each = points.len() / found.rows;
    let columns = if sections.closed { each.checked_mul(parts) } else { (each - 1).checked_mul(parts).map(|n| n + 1) };
    found.reserve_columns(columns.unwrap_or(usize::MAX))?;
    for k in 0..found.rows {
        let (curve, of_section) = (outline_curve(curves, k)?, job.sub_job_of_item(k, found.rows));
        let span = sections.point_range(k);
        let own = &points[k * each..(k + 1) * each];
        // The landmarks must be in order along the section. In a closed section the order may wrap
        // around once.
        let descents = (0..each).filter(|&i| own[i] >= own[(i + 1) % each]).count();
        let may_descend = sections.closed && descents <= 1;
        let wrong =
            (0..each).find(|&i| own[i] as usize >= span.len() || (i > 0 && own[i] <= own[i - 1] && !may_descend));
        let allowed = "the index of a landmark that exists and follows the previous one in its section";
        check(k * each + wrong.unwrap_or(0), wrong.is_none(), allowed)?;
        let place = |landmark: u32| curves.place(span.start + landmark as usize);
        let lengths = curve.arc_lengths(&of_section.sub_job(0.0, 0.5))?;
        let of_section = of_section.sub_job(0.5, 1.0);
        for (i, &landmark) in own.iter().enumerate() {
            of_section.step_every(LANDMARKS_PER_REPORT, i, each, "finding nodes")?;
            let last = i + 1 == each;
            if last && !sections.closed {
                found.nodes.push(curve.point(place(landmark))?);
                break;
            }
            let (from, to) = (place(landmark), place(own[(i + 1) % each]));
            let mut whole = lengths.length_to(to)? - lengths.length_to(from)?;
            // Landmarks at one place enclose nothing; a single landmark encloses the whole section.
            if whole < 0.0 || each == 1 {
                whole += lengths.total_length();
            }
            add_evenly_spaced_nodes(&lengths, from, whole, [parts, parts], true, &mut found.nodes)?;
        }
    }
    Ok(())
}
