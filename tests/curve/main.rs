//! Curves: outlines through points, operations on curves, frames of outlines.

#[path = "../common/mod.rs"]
mod common;

mod construct;
mod curves;
mod frame_corners;
mod frame_missing;
mod intersect;
mod lines;
mod measures;
mod near;
mod ops;
mod outline;
mod outline_choices;
mod outline_cycles;
mod outline_curvature;
mod outline_data;
mod outline_export;
mod outline_frame;
mod outline_limits;
mod outline_loops;
mod outline_memory;
mod outline_single;
mod outline_solvers;
mod plane;
mod sections;
mod stress;
mod tangent_angle;
