//! Outlines: Bézier curves through given points.
//!
//! The inverse problem of Bézier curves: the points of an outline are given, and the control points are sought. The paper
//! (Nadopta, 2008) takes three neighbouring points at a time: the quadratic through the middle one whose control point lies
//! on a guide, the normal of the chord, the bisector, the median, or a tangent.
//!
//! * [`Method`]: the sections by themselves, closed forms.
//! * [`sections`](sections()): the sections of all points of outlines.
//! * [`fit`](fit()): whole outlines, many at a time, open or closed, by the [`Mode`]s.
//! * [`CurveView`], [`Curve`]: what comes out.
//! * [`frame`]: curves across and along a body, through a grid of nodes.
//! * [`ops`]: what can be asked of curves, and what can be made of them.

mod blend;
mod composite;
mod consistent;
mod cubic;
mod curvature;
mod curve;
mod fit;
pub mod frame;
mod guided;
mod joints;
mod judge;
mod method;
pub mod ops;
mod request;
mod run;
mod sections;
mod segment;
mod single;
mod stepping;
mod sweeps;
mod worker;

pub use curve::{Curve, CurveView, MAX_DEGREE, Place};
pub use fit::{Fit, fit};
pub use method::{
    Method, Section, section_by_end_tangent, section_by_start_tangent, section_by_tangent, tangent_of_angle,
};
pub use request::{
    Constraint, Demand, Ends, FitStatus, Joint, Lock, MAX_POINTS, Mode, Options, Outlines, PointStatus, Points, Report,
    Solver,
};
pub use sections::{Sections, sections};
pub use stepping::step_section;
