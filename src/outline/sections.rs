//! The sections of all points by themselves: what the paper's methods are about, before anything is joined.

use super::curve::check_finite;
use super::fit::{check, span};
use super::method::{
    Method, Section, power, section_by_end_tangent, section_by_start_tangent, section_by_tangent, through,
};
use super::request::{Constraint, Demand, Outlines, PointStatus, Points};
use crate::alloc;
use crate::error::{Error, Result};
use crate::geom::scale::power_of_two;
use crate::job::Job;
use glam::DVec3;
use std::ops::Range;

/// Points between two reports of progress.
const REPORT: usize = 1 << 16;

/// The sections of outlines, one for each point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sections {
    /// The control point of each section; the section of point i is the quadratic from point i - 1 over it to point i + 1. At
    /// the ends of open outlines, which have no section, the point itself.
    pub controls: Vec<DVec3>,
    /// The parameter of the point on its section; 0 and 1 at the ends of open outlines.
    pub parameters: Vec<f64>,
    /// What became of each point.
    pub statuses: Vec<PointStatus>,
}

/// Finds the section of each point with its two neighbours.
///
/// A tangent demanded at a point makes its section pass in that direction; one demanded at the first or last point of an open
/// outline is that of its neighbour's section there. Where the tangent or the normal cannot be had, the method (the bisector
/// instead of the normal) takes its place, and the status says so. Corners mean nothing here. O(n); memory for the result.
///
/// # Errors
/// Those of [`fit`](super::fit()), but for the constraints' corners.
///
/// Source: Nadopta, the methods of the normal, tangent, bisector and median; closed forms.
pub fn sections(outlines: &Outlines<'_>, method: Method, job: &Job<'_>) -> Result<Sections> {
    let count = check(outlines)?;
    let alpha = method.alpha().unwrap_or(0.5);
    if !(0.0..=1.0).contains(&alpha) {
        return Err(Error::OptionOutOfRange { option: "alpha", value: alpha });
    }
    let points = &outlines.points;
    let scale = scale(outlines)?;
    let total = points.len();
    let mut found = Sections {
        controls: alloc::with_capacity(total)?,
        parameters: alloc::with_capacity(total)?,
        statuses: alloc::with_capacity(total)?,
    };
    let mut constraints = outlines.constraints;
    let mut reported = 0;
    job.step(0.0, STAGE)?;
    for k in 0..count {
        let span = span(outlines, k);
        let (first, last) = (span.start, span.end.saturating_sub(1));
        let (own, rest) = constraints.split_at(constraints.partition_point(|c| (c.point as usize) < span.end));
        constraints = rest;
        let closed = outlines.closed && span.len() > 2;
        if let (true, [], Some(alpha)) = (closed, own, method.alpha()) {
            for from in span.clone().step_by(REPORT) {
                if from - reported >= REPORT {
                    reported = from;
                    job.step(from as f64 / total as f64, STAGE)?;
                }
                let some = from..span.end.min(from + REPORT);
                plain(points, &span, some, scale, method, alpha, &mut found);
            }
            continue;
        }
        for i in span {
            if i - reported >= REPORT {
                reported = i;
                job.step(i as f64 / total as f64, STAGE)?;
            }
            let p = points.get(i);
            let (section, status) = if !closed && (i == first || i == last) {
                (Section { control: p, t: if i == first { 0.0 } else { 1.0 } }, PointStatus::Ok)
            } else {
                let before = points.get(if i == first { last } else { i - 1 });
                let after = points.get(if i == last { first } else { i + 1 });
                let triple = [before, p, after].map(|p| p * scale);
                let tangents = match own {
                    [] => [None; 3],
                    _ => [
                        (!closed && i == first + 1).then(|| tangent(own, first)).flatten(),
                        tangent(own, i),
                        (!closed && i + 1 == last).then(|| tangent(own, last)).flatten(),
                    ],
                };
                let (section, status) = one(triple, tangents, method);
                (Section { control: section.control / scale, ..section }, status)
            };
            found.controls.push(section.control);
            found.parameters.push(section.t);
            found.statuses.push(status);
        }
    }
    job.step(1.0, STAGE)?;
    Ok(found)
}

const STAGE: &str = "finding sections";

/// The sections of some points of a closed outline of which nothing is demanded, by a method with an exponent: each chord is
/// measured once.
fn plain(
    points: &Points<'_>,
    outline: &Range<usize>,
    some: Range<usize>,
    scale: f64,
    method: Method,
    alpha: f64,
    found: &mut Sections,
) {
    // Exact, as the scale is a power of two.
    let back = 1.0 / scale;
    let at = |i: usize| points.get(i) * scale;
    let (mut before, mut p) =
        (at(if some.start == outline.start { outline.end } else { some.start } - 1), at(some.start));
    let mut arriving = power(before.distance(p), alpha);
    for i in some {
        let after = at(if i + 1 == outline.end { outline.start } else { i + 1 });
        let leaving = power(p.distance(after), alpha);
        let section = through(before, p, after, arriving / (arriving + leaving));
        let (section, status) = match section {
            Ok(section) => (section, PointStatus::Ok),
            Err(_) => one([before, p, after], [None; 3], method),
        };
        found.controls.push(section.control * back);
        found.parameters.push(section.t);
        found.statuses.push(status);
        (before, p, arriving) = (p, after, leaving);
    }
}

/// A power of two that brings coordinates near 1 if squares of them could overflow or vanish; else 1.
fn scale(outlines: &Outlines<'_>) -> Result<f64> {
    let mut largest = 0.0f64;
    for i in 0..outlines.points.len() {
        let p = outlines.points.get(i);
        check_finite(i, p)?;
        largest = largest.max(p.abs().max_element());
    }
    if (1e-60..1e100).contains(&largest) || largest == 0.0 {
        return Ok(1.0);
    }
    Ok(1.0 / power_of_two(largest))
}

/// The tangent demanded at a point.
fn tangent(constraints: &[Constraint], point: usize) -> Option<DVec3> {
    let at = constraints.binary_search_by_key(&point, |constraint| constraint.point as usize).ok()?;
    match constraints[at].demand {
        Demand::Tangent(tangent) => Some(tangent),
        Demand::Corner => None,
    }
}

/// The section through three points; tangents at the first, the middle and the last one, the middle one first of all.
#[inline]
fn one([a, p, c]: [DVec3; 3], tangents: [Option<DVec3>; 3], method: Method) -> (Section, PointStatus) {
    let wanted = match tangents {
        [_, Some(tau), _] => section_by_tangent(a, p, c, tau),
        [Some(tau), None, _] => section_by_start_tangent(a, p, c, tau),
        [None, None, Some(tau)] => section_by_end_tangent(a, p, c, tau),
        [None, None, None] => method.section(a, p, c),
    };
    match wanted {
        Ok(section) => (section, PointStatus::Ok),
        Err(status) => {
            let stand_in = match method {
                Method::Normal => Method::Bisector.section(a, p, c),
                _ => method.section(a, p, c),
            };
            // Where P repeats A or C the median still goes through all three.
            let section = stand_in.or_else(|_| through(a, p, c, 0.5));
            (section.unwrap_or(Section { control: p, t: 0.5 }), status)
        }
    }
}
