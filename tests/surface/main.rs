//! Smooth surfaces: construction, evaluation, nearest points, contours, intersections.

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
mod errata;
mod evaluate;
mod line_intersection;
mod line_intersection_creases;
mod minima;
mod model;
mod nearest;
mod nearest_exhaustive;
mod oracle;
mod pairs;
mod range;
mod reference;
mod shapes;
mod surface_intersection;
mod surface_intersection_degenerate;
