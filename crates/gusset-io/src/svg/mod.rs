//! SVG, Scalable Vector Graphics: outlines.
//!
//! The source is SVG 1.1 and 2 of the W3C. Paths, polygons, polylines, lines, rectangles, circles and ellipses become polylines, with all
//! transforms, view boxes and elements that `use` repeats. The y axis of SVG points down; here it points up, so that y changes its sign.
//! Coordinates are in units of the outermost view box. If the width of the drawing has a unit of length, the document gets its scale.
//!
//! - Curves are drawn within 1e-5 of the drawing's diagonal.
//! - A path is closed if it says so or ends where it begins.
//! - Hidden elements (`display: none`), and elements in `defs`, `clipPath`, `mask`, `pattern` and `marker`, are left out.
//! - Text and images are left out and noted. A path is read up to the first mistake, as the standard demands.
//!
//! The writer makes one element for each curve, and drops z. Reading takes time linear in the file, times the number of readings
//! (2 if there are curves), and memory for the points.

mod read_svg;
mod svg_arc;
mod svg_numbers;
mod svg_path;
mod svg_shapes;
#[cfg(test)]
mod svg_tests;
mod svg_transform;
mod write_svg;

pub(crate) use read_svg::read_svg;
pub(crate) use write_svg::write_svg;
