//! Outlines: Bézier curves through given points.
//!
//! The inverse problem of Bézier curves: the points of an outline are given, and the control points
//! are sought (Nadopta, 2008).
//!
//! * curve: [`CurveView`], [`Curve`], piecewise Bézier curves of any degrees.
//! * identify: [`fit`](fit()) for whole outlines, by the [`Mode`]s; [`sections`](sections()) for
//!   points by themselves, by the [`Method`]s.
//! * [`ops`]: measures, queries and constructions of curves.
//! * [`frame`]: curves across and along a body, through a grid of nodes.
//!
//! Each of these imports from those before it only.

mod curve;
pub mod frame;
mod identify;
pub mod ops;

pub use curve::{Curve, CurveView, MAX_DEGREE, Place};
pub use identify::{
    Constraint, Cycle, Ends, Fit, FitStatus, JointParameter, Lock, MAX_POINTS, Method, Mode, Options, Outlines,
    PointConstraint, PointStatus, Points, Report, Section, Sections, Solver, fit, section_by_end_tangent,
    section_by_start_tangent, section_by_tangent, sections, step_section,
};
