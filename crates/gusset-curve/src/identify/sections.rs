//! The sections of all points independently: the paper's methods before sections are joined. O(n).

use super::identify_options::{Options, Solver};
use super::input_points::Points;
use super::method::{
    Method, Section, power_by_roots_if_possible, section_at_parameter, section_by_end_tangent,
    section_by_start_tangent, section_by_tangent,
};
use super::outlines::{Constraint, Outlines};
use super::report::PointStatus;
use super::stepping::{ControlLine, step_control_point};
use crate::curve::check_finite;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::floor_to_power_of_two;
use gusset_base::job::Job;
use std::ops::Range;

const POINTS_PER_REPORT: usize = 1 << 16;

/// The sections of outlines, one for each point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sections {
    /// The control point of each section. The section of point i is the quadratic from point i - 1
    /// to point i + 1 with this control point. The ends of open outlines lack a section, and the
    /// entry is the point itself.
    pub controls: Vec<DVec3>,
    /// The parameter of the point on its section; 0 and 1 at the ends of open outlines.
    pub parameters: Vec<f64>,
    /// The outcome at each point.
    pub statuses: Vec<PointStatus>,
    /// The steps of the stepping solver, over all sections.
    pub steps: u64,
}

/// Finds the section of each point with its two neighbours.
///
/// A tangent constraint at a point makes its section pass in that direction. At the first or last
/// point of an open outline, it applies to the neighbour's section there. If the tangent or the
/// normal is impossible, the method replaces it (for the normal, the bisector), and the status says
/// so. Corners are ignored.
///
/// Only the options `method` and `solver` are read. With [`Solver::Step`], the paper's steps find
/// the control point: on the guide, or on the tangent at an end of the section. A section that uses up its steps is found in closed
/// form, with the status [`PointStatus::NotConverged`]. O(n), plus the steps; memory for the
/// result.
///
/// # Errors
/// The errors of [`fit`](super::fit()), except for corner constraints.
///
/// Source: Nadopta, the methods of the normal, tangent, bisector and median; closed forms.
pub fn sections(outlines: &Outlines<'_>, options: &Options, job: &Job<'_>) -> Result<Sections> {
    let total = outlines.points.len();
    let mut found = Sections {
        controls: alloc::with_capacity(total)?,
        parameters: alloc::with_capacity(total)?,
        statuses: alloc::with_capacity(total)?,
        steps: 0,
    };
    found.steps = visit_sections(outlines, options, |section, status| found.push_section(section, status), job)?;
    Ok(found)
}

/// Calls `visit` with the section and the outcome of each point, in order; otherwise like
/// [`sections`]. Returns the steps of the stepping solver. Allocates nothing.
///
/// # Errors
/// The errors of [`sections`]. Some points may already have been visited.
pub fn visit_sections(
    outlines: &Outlines<'_>,
    options: &Options,
    mut visit: impl FnMut(Section, PointStatus),
    job: &Job<'_>,
) -> Result<u64> {
    options.check_ranges()?;
    let (count, method) = (outlines.check_offsets_and_constraints()?, options.method);
    let finder =
        SectionFinder { points: &outlines.points, options, method, scale: overflow_guard_scale(outlines)?, job };
    let total = outlines.points.len();
    let mut steps = 0;
    let mut constraints = outlines.constraints;
    let mut reported = 0;
    job.step(0.0, PROGRESS_STAGE)?;
    for k in 0..count {
        let span = outlines.point_range(k);
        let (own, rest) = constraints.split_at(constraints.partition_point(|c| (c.point as usize) < span.end));
        constraints = rest;
        let closed = outlines.closed && span.len() > 2;
        for from in span.clone().step_by(POINTS_PER_REPORT) {
            if from - reported >= POINTS_PER_REPORT {
                reported = from;
                job.step(from as f64 / total as f64, PROGRESS_STAGE)?;
            }
            let some = from..span.end.min(from + POINTS_PER_REPORT);
            if let (true, [], Some(_), Solver::Fast) = (closed, own, method.chord_exponent(), options.solver) {
                finder.visit_unconstrained(&span, some, &mut visit);
            } else {
                for i in some {
                    let (section, status) = finder.find_constrained_section(&span, own, closed, i, &mut steps)?;
                    visit(section, status);
                }
            }
        }
    }
    job.step(1.0, PROGRESS_STAGE)?;
    Ok(steps)
}

const PROGRESS_STAGE: &str = "finding sections";

impl Sections {
    #[inline]
    fn push_section(&mut self, section: Section, status: PointStatus) {
        self.controls.push(section.control);
        self.parameters.push(section.t);
        self.statuses.push(status);
    }
}

/// Finds the sections of the points.
struct SectionFinder<'a> {
    points: &'a Points<'a>,
    options: &'a Options,
    method: Method,
    scale: f64,
    job: &'a Job<'a>,
}

impl SectionFinder<'_> {
    /// Returns the section of point `i` of an outline with the constraints `own`.
    fn find_constrained_section(
        &self,
        outline: &Range<usize>,
        own: &[Constraint],
        closed: bool,
        i: usize,
        steps: &mut u64,
    ) -> Result<(Section, PointStatus)> {
        let (first, last) = (outline.start, outline.end - 1);
        let p = self.points.get(i);
        if !closed && (i == first || i == last) {
            return Ok((Section { control: p, t: if i == first { 0.0 } else { 1.0 } }, PointStatus::Ok));
        }
        let before = self.points.get(if i == first { last } else { i - 1 });
        let after = self.points.get(if i == last { first } else { i + 1 });
        let triple = [before, p, after].map(|p| p * self.scale);
        let tangents = match own {
            [] => [None; 3],
            _ => [
                (!closed && i == first + 1).then(|| tangent_constraint_at(own, first)).flatten(),
                tangent_constraint_at(own, i),
                (!closed && i + 1 == last).then(|| tangent_constraint_at(own, last)).flatten(),
            ],
        };
        let (mut section, mut status) = section_or_fallback(triple, tangents, self.method);
        if self.options.solver == Solver::Step {
            let line = match tangents {
                [Some(tangent), None, _] if status == PointStatus::Ok => ControlLine::TangentAtStart(tangent),
                [None, None, Some(tangent)] if status == PointStatus::Ok => ControlLine::TangentAtEnd(tangent),
                _ => ControlLine::Guide,
            };
            match step_control_point(triple, section.t, line, self.options, self.job)? {
                Ok((stepped, count)) => {
                    section = stepped;
                    *steps += count;
                }
                Err(failed) if status == PointStatus::Ok => status = failed,
                Err(_) => {}
            }
        }
        Ok((Section { control: section.control / self.scale, ..section }, status))
    }

    /// The sections of some points of a closed outline without constraints, by a method with an
    /// exponent. Each chord is measured once.
    fn visit_unconstrained(
        &self,
        outline: &Range<usize>,
        some: Range<usize>,
        visit: &mut impl FnMut(Section, PointStatus),
    ) {
        let alpha = self.method.chord_exponent().unwrap_or(0.5);
        // Exact, as the scale is a power of two.
        let back = 1.0 / self.scale;
        let at = |i: usize| self.points.get(i) * self.scale;
        let mut before = at(if some.start == outline.start { outline.end } else { some.start } - 1);
        let mut p = at(some.start);
        let mut arriving = power_by_roots_if_possible(before.distance(p), alpha);
        for i in some {
            let after = at(if i + 1 == outline.end { outline.start } else { i + 1 });
            let leaving = power_by_roots_if_possible(p.distance(after), alpha);
            let (section, status) = match section_at_parameter(before, p, after, arriving / (arriving + leaving)) {
                Ok(section) => (section, PointStatus::Ok),
                Err(_) => section_or_fallback([before, p, after], [None; 3], self.method),
            };
            visit(Section { control: section.control * back, ..section }, status);
            (before, p, arriving) = (p, after, leaving);
        }
    }
}

/// Returns a power of two that scales coordinates close to 1 if their squares could overflow or
/// underflow; otherwise 1.
fn overflow_guard_scale(outlines: &Outlines<'_>) -> Result<f64> {
    let mut largest = 0.0f64;
    for i in 0..outlines.points.len() {
        let p = outlines.points.get(i);
        check_finite(i, p)?;
        largest = largest.max(p.abs().max_element());
    }
    if (1e-60..1e100).contains(&largest) || largest == 0.0 {
        return Ok(1.0);
    }
    Ok(1.0 / floor_to_power_of_two(largest))
}

/// Returns the tangent required at a point.
fn tangent_constraint_at(constraints: &[Constraint], point: usize) -> Option<DVec3> {
    let at = constraints.binary_search_by_key(&point, |constraint| constraint.point as usize).ok()?;
    constraints[at].kind.tangent()
}

/// Returns the section through three points. Tangents at the first, the middle and the last point
/// apply if possible, the middle one with priority.
#[inline]
fn section_or_fallback([a, p, c]: [DVec3; 3], tangents: [Option<DVec3>; 3], method: Method) -> (Section, PointStatus) {
    let wanted = match tangents {
        [_, Some(tau), _] => section_by_tangent(a, p, c, tau),
        [Some(tau), None, _] => section_by_start_tangent(a, p, c, tau),
        [None, None, Some(tau)] => section_by_end_tangent(a, p, c, tau),
        [None, None, None] => method.compute_section(a, p, c),
    };
    match wanted {
        Ok(section) => (section, PointStatus::Ok),
        Err(status) => {
            let stand_in = match method {
                Method::Normal => Method::Bisector.compute_section(a, p, c),
                _ => method.compute_section(a, p, c),
            };
            // If P coincides with A or C, the median still passes all three points.
            let section = stand_in.or_else(|_| section_at_parameter(a, p, c, 0.5));
            (section.unwrap_or(Section { control: p, t: 0.5 }), status)
        }
    }
}
