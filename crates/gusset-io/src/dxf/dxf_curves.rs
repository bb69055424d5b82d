//! Curves of entities.

use super::dxf_entity::{Entity, Frame, cross, unit_vector};
use super::dxf_spline::draw_spline;
use crate::error::ReadError;
use crate::outline_pen::{OutlinePen, Vector, ellipse_point};
use crate::text::number;
use std::f64::consts::TAU;

/// A vertex of a polyline, in its own system of coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct PolylineVertex {
    pub(super) point: Vector,
    /// Tangent of a quarter of the angle of the arc to the next vertex; 0 for a line.
    pub(super) bulge: f64,
}

/// Draws an entity. Returns false if it is not a curve.
pub(super) fn draw_curve(entity: &Entity<'_>, frame: &Frame, pen: &mut OutlinePen) -> Result<bool, ReadError> {
    match entity.kind {
        b"LINE" => {
            pen.begin_outline(frame.map_point(entity.point_of_code(10)))?;
            pen.line_to(frame.map_point(entity.point_of_code(11)))?;
            pen.end_outline(false)?;
        }
        b"LWPOLYLINE" => {
            let vertices = lightweight_vertices(entity)?;
            let is_closed = entity.integer_of_code(70) & 1 != 0;
            draw_polyline(&vertices, is_closed, &frame.compose_after(&entity.object_frame()), pen)?;
        }
        b"CIRCLE" | b"ARC" => draw_circle(entity, &frame.compose_after(&entity.object_frame()), pen)?,
        b"ELLIPSE" => draw_ellipse(entity, frame, pen)?,
        b"SPLINE" => draw_spline(entity, frame, pen)?,
        _ => return Ok(false),
    }
    Ok(true)
}

fn lightweight_vertices(entity: &Entity<'_>) -> Result<Vec<PolylineVertex>, ReadError> {
    let elevation = entity.number_of_code(38).unwrap_or(0.0);
    let mut vertices: Vec<PolylineVertex> = Vec::new();
    for pair in &entity.pairs {
        let value = number(pair.value).unwrap_or(0.0);
        match (pair.code, vertices.last_mut()) {
            (10, _) => {
                vertices.try_reserve(1)?;
                vertices.push(PolylineVertex { point: [value, 0.0, elevation], bulge: 0.0 });
            }
            (20, Some(vertex)) => vertex.point[1] = value,
            (42, Some(vertex)) => vertex.bulge = value,
            _ => {}
        }
    }
    Ok(vertices)
}

/// Draws a polyline with arcs.
pub(super) fn draw_polyline(
    vertices: &[PolylineVertex],
    is_closed: bool,
    frame: &Frame,
    pen: &mut OutlinePen,
) -> Result<(), ReadError> {
    let Some(first) = vertices.first() else { return Ok(()) };
    pen.begin_outline(frame.map_point(first.point))?;
    let ends = vertices[1..].iter().chain(is_closed.then_some(first));
    for (start, end) in vertices.iter().zip(ends) {
        let target = frame.map_point(end.point);
        if start.bulge == 0.0 || !start.bulge.is_finite() {
            pen.line_to(target)?;
            continue;
        }
        let [dx, dy] = [0, 1].map(|axis| end.point[axis] - start.point[axis]);
        let height = (1.0 - start.bulge * start.bulge) / (4.0 * start.bulge);
        let centre = [
            (start.point[0] + end.point[0]) / 2.0 - dy * height,
            (start.point[1] + end.point[1]) / 2.0 + dx * height,
            start.point[2],
        ];
        let [x, y] = [0, 1].map(|axis| start.point[axis] - centre[axis]);
        let ellipse = [frame.map_point(centre), frame.map_vector([x, y, 0.0]), frame.map_vector([-y, x, 0.0])];
        pen.arc_to(ellipse, [0.0, 4.0 * start.bulge.atan()], target)?;
    }
    pen.end_outline(is_closed)
}

fn draw_circle(entity: &Entity<'_>, frame: &Frame, pen: &mut OutlinePen) -> Result<(), ReadError> {
    let radius = entity.number_of_code(40).unwrap_or(0.0);
    let axes = [[radius, 0.0, 0.0], [0.0, radius, 0.0]].map(|axis| frame.map_vector(axis));
    let ellipse = [frame.map_point(entity.point_of_code(10)), axes[0], axes[1]];
    if entity.kind == b"CIRCLE" {
        return pen.draw_ellipse(ellipse);
    }
    let [start, end] = [50, 51].map(|code| entity.number_of_code(code).unwrap_or(0.0).to_radians());
    draw_arc(ellipse, [start, end], pen)
}

/// Draws an arc from an angle to another, anticlockwise.
fn draw_arc(ellipse: [Vector; 3], [start, end]: [f64; 2], pen: &mut OutlinePen) -> Result<(), ReadError> {
    let sweep = (end - start).rem_euclid(TAU);
    let sweep = if sweep == 0.0 { TAU } else { sweep };
    pen.begin_outline(ellipse_point(ellipse, start))?;
    pen.arc_to(ellipse, [start, sweep], ellipse_point(ellipse, end))?;
    pen.end_outline(false)
}

fn draw_ellipse(entity: &Entity<'_>, frame: &Frame, pen: &mut OutlinePen) -> Result<(), ReadError> {
    let major = entity.point_of_code(11);
    let has_normal = entity.number_of_code(230).is_some();
    let normal = if has_normal { unit_vector(entity.point_of_code(210)) } else { None }.unwrap_or([0.0, 0.0, 1.0]);
    let ratio = entity.number_of_code(40).unwrap_or(1.0);
    let minor = cross(normal, major).map(|part| ratio * part);
    let ellipse = [frame.map_point(entity.point_of_code(10)), frame.map_vector(major), frame.map_vector(minor)];
    let (start, end) = (entity.number_of_code(41).unwrap_or(0.0), entity.number_of_code(42).unwrap_or(TAU));
    // Full turns are written with many roundings of their end.
    const MAX_ROUNDING: f64 = 1e-9;
    if (end - start).abs() >= TAU - MAX_ROUNDING {
        return pen.draw_ellipse(ellipse);
    }
    draw_arc(ellipse, [start, end], pen)
}
