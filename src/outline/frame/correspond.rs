//! The nodes of a frame: which points of one section belong to which of the next.
//!
//! Each correspondence gives every section the same number of nodes: the points themselves, equal
//! parts of the arc length, the intersections with half-planes through an axis, or equal parts
//! between landmarks. One fit and, but for the points themselves, one length of each section;
//! O(columns log segments) more, with angles O(columns x segments).

use crate::outline::curve::{CurveView, Place};

use super::options::{Correspondence, FrameOptions};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::identify::{Fit, Outlines, fit};
use crate::outline::ops::Lengths;
use glam::DVec3;
use std::f64::consts::TAU;

/// The nodes of all sections, row by row.
pub(super) struct SectionNodes {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) nodes: Vec<DVec3>,
    pub(super) turned: Vec<u8>,
    pub(super) ambiguous: Vec<u32>,
}

pub(super) fn correspond(sections: &Outlines<'_>, options: &FrameOptions<'_>, job: &Job<'_>) -> Result<SectionNodes> {
    let rows = sections.offsets.map_or(1, |offsets| offsets.len().saturating_sub(1));
    let curves = fit(sections, &options.across, &job.part(0.0, 0.5))?;
    let job = job.part(0.5, 1.0);
    let mut found =
        SectionNodes { rows, columns: 0, nodes: Vec::new(), turned: alloc::filled(0, rows)?, ambiguous: Vec::new() };
    match options.correspondence {
        Correspondence::Given => add_given(sections, &mut found)?,
        Correspondence::ArcLength { columns } => {
            found.reserve(columns)?;
            let mut first_turn = None;
            for k in 0..rows {
                job.step(k as f64 / rows as f64, "finding nodes")?;
                let curve = curve_of(&curves, k)?;
                let turn = turn_of(sections, k);
                let backwards = sections.closed && turn.dot(*first_turn.get_or_insert(turn)) < 0.0;
                found.turned[k] = backwards.into();
                let lengths = curve.lengths(&Job::default())?;
                let start = curves.place(sections.span(k).start);
                let (whole, steps) = match sections.closed {
                    true => (lengths.total(), columns),
                    false => (lengths.total() - lengths.up_to(start)?, columns.saturating_sub(1)),
                };
                let whole = if backwards { -whole } else { whole };
                add_even(&lengths, start, whole, [steps, columns], sections.closed, &mut found.nodes)?;
            }
        }
        Correspondence::Angle { columns, point, direction, reference } => {
            let [along, first, second] = axes(direction, reference)?;
            found.reserve(columns)?;
            for k in 0..rows {
                job.step(k as f64 / rows as f64, "finding nodes")?;
                let curve = curve_of(&curves, k)?;
                for i in 0..columns {
                    let angle = TAU * i as f64 / columns as f64;
                    let ray = first * libm::cos(angle) + second * libm::sin(angle);
                    found.add_farthest(&curve, k, point, ray, along.cross(ray))?;
                }
            }
        }
        Correspondence::Landmarks { points, parts } => add_landmarks(sections, &curves, points, parts, &mut found)?,
    }
    Ok(found)
}

fn curve_of(curves: &Fit, k: usize) -> Result<CurveView<'_>> {
    let curve = curves.curve(k);
    if curve.is_empty() { Err(Error::NoNode { section: k as u32, column: 0 }) } else { Ok(curve) }
}

impl SectionNodes {
    /// Room for `columns` nodes in each row.
    fn reserve(&mut self, columns: usize) -> Result<()> {
        let count = (self.rows as u64).saturating_mul(columns as u64);
        Error::check_count("nodes", count, u32::MAX.into())?;
        self.columns = columns;
        alloc::reserve(&mut self.nodes, count as usize)
    }

    /// Adds the intersection of a section with the half-plane from the axis through `point` towards
    /// `ray`, the farthest from the axis.
    fn add_farthest(
        &mut self,
        curve: &CurveView<'_>,
        section: usize,
        point: DVec3,
        ray: DVec3,
        normal: DVec3,
    ) -> Result<()> {
        let crossings = curve.intersect_plane(point, normal)?;
        let (mut hits, mut farthest) = (0, None);
        let mut greatest = 0.0;
        for p in curve.points_at(&crossings.places)? {
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

fn add_given(sections: &Outlines<'_>, found: &mut SectionNodes) -> Result<()> {
    let columns = if found.rows == 0 { 0 } else { sections.span(0).len() };
    found.reserve(columns)?;
    for k in 0..found.rows {
        let span = sections.span(k);
        if span.len() != columns {
            let (count, expected) = (span.len() as u32, columns as u32);
            return Err(Error::SectionsDiffer { section: k as u32, count, expected });
        }
        found.nodes.extend(span.map(|i| sections.points.get(i)));
    }
    Ok(())
}

/// The axis that the polygon of a section turns round, of length 1 or 0.
fn turn_of(sections: &Outlines<'_>, k: usize) -> DVec3 {
    let span = sections.span(k);
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

/// Adds `count` nodes from a place on, each by the same of `steps` parts of a length farther along,
/// backwards if that is negative; round the end of a curve that is `closed`.
fn add_even(
    lengths: &Lengths<'_>,
    from: Place,
    whole: f64,
    [steps, count]: [usize; 2],
    closed: bool,
    nodes: &mut Vec<DVec3>,
) -> Result<()> {
    let (start, total) = (lengths.up_to(from)?, lengths.total());
    nodes.push(lengths.curve().point(from)?);
    for i in 1..count {
        let at = match start + whole * (i as f64 / steps as f64) {
            at if closed && at < 0.0 => at + total,
            at if closed && at >= total => at - total,
            at => at,
        };
        nodes.push(lengths.curve().point(lengths.place(at)?)?);
    }
    Ok(())
}

/// Adds, for each section, its landmarks and the nodes between them.
fn add_landmarks(
    sections: &Outlines<'_>,
    curves: &Fit,
    points: &[u32],
    parts: usize,
    found: &mut SectionNodes,
) -> Result<()> {
    let check = |value: usize, allowed: bool| Error::require(allowed, "landmarks", value as f64);
    check(points.len(), found.rows > 0 && !points.is_empty() && points.len().is_multiple_of(found.rows))?;
    Error::require(parts > 0, "parts", parts as f64)?;
    let each = points.len() / found.rows;
    let columns = if sections.closed { each.checked_mul(parts) } else { (each - 1).checked_mul(parts).map(|n| n + 1) };
    found.reserve(columns.unwrap_or(usize::MAX))?;
    for k in 0..found.rows {
        let curve = curve_of(curves, k)?;
        let span = sections.span(k);
        let own = &points[k * each..(k + 1) * each];
        // In order along the section; a closed one may pass its first point once on the way.
        let descents = (0..each).filter(|&i| own[i] >= own[(i + 1) % each]).count();
        let may_descend = sections.closed && descents <= 1;
        let wrong =
            (0..each).find(|&i| own[i] as usize >= span.len() || (i > 0 && own[i] <= own[i - 1] && !may_descend));
        check(k * each + wrong.unwrap_or(0), wrong.is_none())?;
        let place = |landmark: u32| curves.place(span.start + landmark as usize);
        let lengths = curve.lengths(&Job::default())?;
        for (i, &landmark) in own.iter().enumerate() {
            let last = i + 1 == each;
            if last && !sections.closed {
                found.nodes.push(curve.point(place(landmark))?);
                break;
            }
            let (from, to) = (place(landmark), place(own[(i + 1) % each]));
            let mut whole = lengths.up_to(to)? - lengths.up_to(from)?;
            // Landmarks at one place have nothing between them; the only one has all round.
            if whole < 0.0 || each == 1 {
                whole += lengths.total();
            }
            add_even(&lengths, from, whole, [parts, parts], true, &mut found.nodes)?;
        }
    }
    Ok(())
}

/// Three directions at right angles: along the axis, towards the reference, and on from there.
fn axes(direction: DVec3, reference: DVec3) -> Result<[DVec3; 3]> {
    let unit = |v: DVec3, option: &'static str| {
        let largest = v.abs().max_element();
        Error::require(v.is_finite() && largest > 0.0, option, largest)?;
        Ok((v / largest).normalize())
    };
    let along = unit(direction, "axis")?;
    let reference = unit(reference, "reference")?;
    let across = reference - along * reference.dot(along);
    Error::require(across.length() >= 1e-9, "reference", across.length())?;
    let first = across.normalize();
    Ok([along, first, along.cross(first)])
}
