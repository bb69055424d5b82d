//! Identification: curves through given points, the inverse problem of Bézier curves.
//!
//! The paper takes three neighbouring points at a time. It seeks the quadratic through the middle
//! one whose control point lies on a guide: the normal of the chord, the bisector, the median, or a
//! tangent. From the bottom up:
//!
//! - outlines, options, report, fit: input, choices, report and result.
//! - method, sections: closed forms for three points; stepping: the paper's steps; guide: the lines
//!   on which control points lie.
//! - nodes, subcurve, solution, curve_builder, residuals: one outline near the origin, its parts,
//!   and the curve through it.
//! - loops, crowded_runs, span_lanes, arc_crossing, spans: loops of the curve. crowded: nodes that almost repeat a
//!   neighbour.
//! - composite, single, blend, cubic_spline: the solvers, one for each kind of curve ([`CurveKind`]).
//! - driver: [`fit()`], which distributes outlines to threads.
//!
//! Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008. The
//! modules say where the readings of the set of sections are ours.

mod arc_crossing;
mod blended_curve;
mod composite;
mod crowded;
mod crowded_runs;
mod cubic_spline;
mod curve_builder;
mod outline_fitting;
mod fit;
mod guide;
mod identify_options;
mod input_points;
mod loops;
mod method;
mod outline_nodes;
mod outlines;
mod report;
mod residuals;
mod sections;
mod single;
mod composite_solution;
mod span_lanes;
mod spans;
mod stepping;
mod subcurve;

pub use fit::Fit;
pub use identify_options::{CurveKind, Ends, JointParameter, Lock, Options, Solver};
pub use input_points::{MAX_POINTS, Points};
pub use method::{Method, Section, section_by_end_tangent, section_by_start_tangent, section_by_tangent};
pub use outline_fitting::fit;
pub use outlines::{Constraint, Outlines, PointConstraint};
pub use report::{Cycle, FitStatus, PointStatus, Report};
pub use sections::{Sections, sections, visit_sections};
pub use stepping::step_section;
