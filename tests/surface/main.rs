//! Smooth surfaces: construction, evaluation, nearest points, contours, intersections.

#[path = "../common/mod.rs"]
mod common;

mod arcs;
mod bounds;
mod cones;
mod construct;
mod contour;
mod contour_angles;
mod contour_nodes;
mod contour_patches;
mod contour_poles;
mod contour_simple;
mod contours;
mod curve;
mod data;
mod distance;
mod errata;
mod evaluate;
mod halving;
mod line_intersection;
mod line_intersection_creases;
mod literal;
mod minima;
mod model;
mod nearest;
mod nearest_exhaustive;
mod offset;
mod oracle;
mod pairs;
mod range;
mod rational;
mod reference;
mod self_intersection;
mod self_intersection_sampled;
mod shapes;
mod surface_intersection;
mod surface_intersection_along;
mod surface_intersection_beside;
mod surface_intersection_contact;
mod surface_intersection_degenerate;
mod surface_intersection_poles;
mod surface_intersection_tolerance;
mod surface_tangency;
