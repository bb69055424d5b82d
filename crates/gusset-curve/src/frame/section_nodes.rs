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
    apportion_parts, find_corners_of_sections, match_corners, nodes_with_sharp_turn, point_constraints_with_corners,
};
use crate::identify::{Fit, Options, Outlines, fit};
use crate::ops::ArcLengths;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
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
    let curves = fit(&Outlines { constraints: &constraints, ..*sections }, &across, &job.part(0.0, 0.5))?;
    let job = job.part(0.5, 1.0);
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
            found.reserve_columns(columns)?;
            if sections.closed {
                add_nodes_of_closed_sections(sections, &curves, &corners, options, &mut found, &job)?;
            } else {
                add_nodes_of_open_sections(sections, &curves, &corners, &mut found, &job)?;
            }
        }
        Correspondence::Angle { columns, axis, reference } => {
            let frames = axis_frames(axis, reference, rows, options.ring)?;
            found.reserve_columns(columns)?;
            for (k, &(point, [along, first, second])) in frames.iter().enumerate() {
                let (curve, of_section) = (outline_curve(&curves, k)?, job.share(k, rows));
                for i in 0..columns {
                    let angle = TAU * i as f64 / columns as f64;
                    let ray = first * libm::cos(angle) + second * libm::sin(angle);
                    found.add_farthest_crossing(
                        &curve,
                        k,
                        point,
                        ray,
                        along.cross(ray),
                        &of_section.share(i, columns),
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
        let crossings = curve.intersect_plane(point, normal, &job.part(0.0, 0.9))?;
        let (mut hits, mut farthest) = (0, None);
        let mut greatest = 0.0;
        for p in curve.points_at(&crossings.places, &job.part(0.9, 1.0))? {
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

/// Adds the nodes of closed sections at equal fractions of their lengths. They start where the
/// sections are twisted least, or are spread between the corners that all sections share.
fn add_nodes_of_closed_sections(
    sections: &Outlines<'_>,
    curves: &Fit,
    corners: &[Vec<u32>],
    options: &FrameOptions<'_>,
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<()> {
    let (rows, columns) = (found.rows, found.columns);
    let rings = orient_closed_sections(sections, curves, options, found, &job.part(0.0, 0.4))?;
    let place = |k: usize, mark: u32| curves.place(sections.point_range(k).start + mark as usize);
    let mut along = alloc::collect(corners.iter().map(|_| Vec::new()))?;
    for (k, (along, own)) in along.iter_mut().zip(corners).enumerate() {
        alloc::append(along, own)?;
        // Two corners at one place are one corner.
        along.dedup_by_key(|&mut mark| place(k, mark));
        if along.len() > 1 && place(k, along[0]) == place(k, along[along.len() - 1]) {
            along.pop();
        }
        if rings[k].backwards {
            along.reverse();
        }
    }
    let mut marks = shared_corners(sections, &along, columns, &job.part(0.4, 0.5))?;
    let count = marks.first().map_or(0, Vec::len);
    if count == 0 {
        let starts = if options.given_starts {
            alloc::filled(0.0, rows)?
        } else {
            section_start_fractions(&rings, options.ring, &job.part(0.5, 0.5))?
        };
        for (k, (ring, start)) in rings.iter().zip(starts).enumerate() {
            job.step(0.5 + 0.5 * k as f64 / rows as f64, "finding nodes")?;
            let total = ring.lengths.total_length();
            let whole = if ring.backwards { -total } else { total };
            add_evenly_spaced_nodes(
                &ring.lengths,
                ring.place_at_fraction(start)?,
                whole,
                [columns, columns],
                true,
                &mut found.nodes,
            )?;
        }
        return Ok(());
    }
    let first = match options.given_starts {
        true => {
            let far = alloc::try_collect(marks[0].iter().map(|&mark| rings[0].length_from_anchor(place(0, mark))))?;
            (0..count).min_by(|&i, &j| far[i].total_cmp(&far[j])).unwrap_or(0)
        }
        false => farthest_from_mean(
            marks[0].iter().map(|&mark| sections.points.get(sections.point_range(0).start + mark as usize)),
        ),
    };
    marks.iter_mut().for_each(|marks| marks.rotate_left(first));
    // The interval of the section from each corner to the next.
    let span = |k: usize, i: usize| {
        let [from, to] = [i, (i + 1) % count].map(|i| rings[k].length_from_anchor(place(k, marks[k][i])));
        let by = to? - from?;
        Ok(if by > 0.0 { by } else { by + rings[k].lengths.total_length() })
    };
    add_nodes_between_landmarks(&marks, &rings, curves, sections, columns, &span, found)
}

/// Returns the closed sections, each oriented like the previous one instead of the first, because a
/// body may be bent.
fn orient_closed_sections<'a>(
    sections: &Outlines<'_>,
    curves: &'a Fit,
    options: &FrameOptions<'_>,
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<Vec<AnchoredSection<'a>>> {
    let mut rings = alloc::with_capacity(found.rows)?;
    let mut before = DVec3::ZERO;
    for k in 0..found.rows {
        job.step(k as f64 / found.rows as f64, "finding nodes")?;
        let lengths = outline_curve(curves, k)?.arc_lengths(&job.share(k, found.rows))?;
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
        rings.push(AnchoredSection { lengths, anchor, backwards });
    }
    Ok(rings)
}

/// Adds the nodes of open sections at equal fractions of their lengths, or of the lengths between
/// corners that all sections share.
fn add_nodes_of_open_sections(
    sections: &Outlines<'_>,
    curves: &Fit,
    corners: &[Vec<u32>],
    found: &mut SectionNodes,
    job: &Job<'_>,
) -> Result<()> {
    let (rows, columns) = (found.rows, found.columns);
    let mut rings = alloc::with_capacity(rows)?;
    for k in 0..rows {
        job.step(0.8 * k as f64 / rows as f64, "finding nodes")?;
        let lengths = outline_curve(curves, k)?.arc_lengths(&job.part(0.0, 0.8).share(k, rows))?;
        rings.push(AnchoredSection { lengths, anchor: 0.0, backwards: false });
    }
    let mut marks = shared_corners(sections, corners, columns.saturating_sub(2), &job.part(0.8, 1.0))?;
    for (k, marks) in marks.iter_mut().enumerate() {
        alloc::push(marks, sections.point_range(k).len() as u32 - 1)?;
        marks.insert(0, 0);
    }
    let at = |k: usize, i: usize| {
        rings[k].lengths.length_to(curves.place(sections.point_range(k).start + marks[k][i] as usize))
    };
    let span = |k: usize, i: usize| Ok(at(k, i + 1)? - at(k, i)?);
    add_nodes_between_landmarks(&marks, &rings, curves, sections, columns, &span, found)?;
    found.corners.retain(|&node| !matches!(node as usize % columns, i if i == 0 || i + 1 == columns));
    Ok(())
}

/// Returns the corners that all sections share, at most `max_count`; see [`match_corners`].
fn shared_corners(
    sections: &Outlines<'_>,
    corners: &[Vec<u32>],
    max_count: usize,
    job: &Job<'_>,
) -> Result<Vec<Vec<u32>>> {
    let points = |k: usize| sections.point_range(k).map(|i| sections.points.get(i));
    let centre = |k: usize| points(k).map(|p| p / points(k).len() as f64).sum::<DVec3>();
    let centres = alloc::collect((0..corners.len()).map(centre))?;
    let unit = corner_distance_unit(sections, corners, &centres)?;
    let at =
        |k: usize, i: u32| sections.points.get(sections.point_range(k).start + i as usize) / unit - centres[k] / unit;
    match_corners(corners, sections.closed, max_count, &at, job)
}

/// Returns a unit of length in which the squares of corner distances are in range.
fn corner_distance_unit(sections: &Outlines<'_>, corners: &[Vec<u32>], centres: &[DVec3]) -> Result<f64> {
    let of = |(k, own): (usize, &'_ Vec<u32>)| {
        let first = sections.point_range(k).start;
        own.iter().fold(DVec3::ZERO, move |most, &i| most.max(sections.points.get(first + i as usize).abs()))
    };
    let mut most = alloc::collect(corners.iter().enumerate().map(of))?;
    alloc::append(&mut most, centres)?;
    Ok(common_unit(&most))
}

/// Adds the nodes between landmarks. Each interval gets a number of parts in proportion to its mean
/// length. `span` returns interval i of section k.
fn add_nodes_between_landmarks(
    marks: &[Vec<u32>],
    rings: &[AnchoredSection<'_>],
    curves: &Fit,
    sections: &Outlines<'_>,
    columns: usize,
    span: &dyn Fn(usize, usize) -> Result<f64>,
    found: &mut SectionNodes,
) -> Result<()> {
    let Some(count) = marks.first().map(Vec::len).filter(|_| columns > 1) else {
        return Ok(());
    };
    let (intervals, parts) = if sections.closed { (count, columns) } else { (count - 1, columns - 1) };
    let mut shares = alloc::filled(0.0, intervals)?;
    for (k, ring) in rings.iter().enumerate() {
        for (i, share) in shares.iter_mut().enumerate() {
            *share += span(k, i)? / ring.lengths.total_length();
        }
    }
    let counts = apportion_parts(&shares, parts)?;
    for (k, ring) in rings.iter().enumerate() {
        let place = |i: usize| curves.place(sections.point_range(k).start + marks[k][i] as usize);
        for (i, &parts) in counts.iter().enumerate() {
            alloc::push(&mut found.corners, found.nodes.len() as u32)?;
            let whole = if ring.backwards { -span(k, i)? } else { span(k, i)? };
            add_evenly_spaced_nodes(&ring.lengths, place(i), whole, [parts, parts], sections.closed, &mut found.nodes)?;
        }
        if !sections.closed {
            found.nodes.push(ring.lengths.curve().point(place(intervals))?);
        }
    }
    Ok(())
}

fn add_given_points(sections: &Outlines<'_>, corners: &[Vec<u32>], found: &mut SectionNodes) -> Result<()> {
    let columns = sections.points_per_outline(found.rows)?;
    found.reserve_columns(columns)?;
    for (k, corners) in corners.iter().enumerate() {
        found.nodes.extend(sections.point_range(k).map(|i| sections.points.get(i)));
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
    let check = |value: usize, allowed: bool| Error::require(allowed, "landmarks", value as f64);
    check(points.len(), found.rows > 0 && !points.is_empty() && points.len().is_multiple_of(found.rows))?;
    Error::require(parts > 0, "parts", parts as f64)?;
    let each = points.len() / found.rows;
    let columns = if sections.closed { each.checked_mul(parts) } else { (each - 1).checked_mul(parts).map(|n| n + 1) };
    found.reserve_columns(columns.unwrap_or(usize::MAX))?;
    for k in 0..found.rows {
        let (curve, of_section) = (outline_curve(curves, k)?, job.share(k, found.rows));
        let span = sections.point_range(k);
        let own = &points[k * each..(k + 1) * each];
        // The landmarks must be in order along the section. In a closed section the order may wrap
        // around once.
        let descents = (0..each).filter(|&i| own[i] >= own[(i + 1) % each]).count();
        let may_descend = sections.closed && descents <= 1;
        let wrong =
            (0..each).find(|&i| own[i] as usize >= span.len() || (i > 0 && own[i] <= own[i - 1] && !may_descend));
        check(k * each + wrong.unwrap_or(0), wrong.is_none())?;
        let place = |landmark: u32| curves.place(span.start + landmark as usize);
        let lengths = curve.arc_lengths(&of_section.part(0.0, 0.5))?;
        let of_section = of_section.part(0.5, 1.0);
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
