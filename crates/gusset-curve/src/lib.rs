//! Outlines: Bézier curves through given points, and operations on curves.
//!
//! The crate follows T. Nadopta, *Theoretical foundations of the identification of outline curves*
//! (2008). The paper solves the inverse problem of Bézier curves: the points of an outline are
//! given, and the control points are sought. The errata of the paper are in `docs/errata.md`.
//!
//! | module | task | main items |
//! |---|---|---|
//! | `curve` | piecewise Bézier curves of any degrees, borrowed or owned | [`CurveView`], [`Curve`], [`Place`] |
//! | `identify` | fits curves through points, with a report on each point | [`fit`](fit()), [`Outlines`], [`CurveKind`], [`Method`]; [`sections`](sections()) for single points |
//! | [`ops`] | answers queries and builds new curves, as methods of [`CurveView`] | lengths, areas, nearest points, intersections, offsets, SVG paths |
//! | [`frame`] | curves across and along a body, through a grid of nodes | [`frame()`](frame::frame()) |
//!
//! Each module uses only modules above it in the table. Curves are in double precision. Every
//! operation first moves its curve near the origin and to a size near 1, so that any unit serves.

mod curve;
pub mod frame;
mod identify;
pub mod ops;

pub use curve::{Curve, CurveView, MAX_DEGREE, Place};
pub use identify::{
    Constraint, CurveKind, Cycle, Ends, Fit, FitStatus, JointParameter, Lock, MAX_POINTS, Method, Options, Outlines,
    PointConstraint, PointStatus, Points, Report, Section, Sections, Solver, fit, section_by_end_tangent,
    section_by_start_tangent, section_by_tangent, sections, step_section, visit_sections,
};
