//! Shapes other than paths.

use super::svg_numbers::{NumberReader, length};
use super::svg_path::{PathPen, draw_path};
use super::svg_transform::Transform;
use crate::error::ReadError;
use crate::outline_pen::OutlinePen;
use std::borrow::Cow;

/// Attributes of an element.
pub(super) struct Attributes<'e> {
    values: Vec<(&'e str, Cow<'e, str>)>,
    /// Width and height that percentages refer to.
    view: [f64; 2],
}

impl<'e> Attributes<'e> {
    pub(super) fn new(values: Vec<(&'e str, Cow<'e, str>)>, view: [f64; 2]) -> Self {
        Self { values, view }
    }

    pub(super) fn text(&self, name: &str) -> Option<&str> {
        self.values.iter().find(|(key, _)| *key == name).map(|(_, value)| &**value)
    }

    /// Returns a length along x, along y or in any direction.
    pub(super) fn length(&self, name: &str) -> Option<f64> {
        let [width, height] = self.view;
        let full = match name {
            "x" | "cx" | "rx" | "x1" | "x2" | "width" => width,
            "y" | "cy" | "ry" | "y1" | "y2" | "height" => height,
            _ => ((width * width + height * height) / 2.0).sqrt(),
        };
        length(self.text(name)?, full)
    }

    fn length_or_zero(&self, name: &str) -> f64 {
        self.length(name).unwrap_or(0.0)
    }

    /// Returns whether the element is hidden, by an attribute or in its style.
    pub(super) fn is_hidden(&self) -> bool {
        let has_none = |style: &str| {
            style.split(';').any(|part| {
                part.split_once(':').is_some_and(|(key, value)| key.trim() == "display" && value.trim() == "none")
            })
        };
        self.text("display").is_some_and(|value| value.trim() == "none") || self.text("style").is_some_and(has_none)
    }
}

/// Draws an element. Returns `None` if it is not a shape, or else whether its data hold a mistake.
pub(super) fn draw_shape(
    name: &str,
    attributes: &Attributes<'_>,
    transform: &Transform,
    pen: &mut OutlinePen,
) -> Result<Option<bool>, ReadError> {
    let is_wrong = match name {
        "path" => draw_path(pen, transform, attributes.text("d").unwrap_or(""))?,
        "polygon" | "polyline" => {
            draw_points(pen, transform, attributes.text("points").unwrap_or(""), name == "polygon")?
        }
        "line" => {
            let ends = [["x1", "y1"], ["x2", "y2"]].map(|end| end.map(|part| attributes.length_or_zero(part)));
            let mut path = PathPen::new(pen, transform);
            path.move_to(ends[0]);
            path.line_to(ends[1])?;
            path.finish()?;
            false
        }
        "rect" => {
            draw_rectangle(pen, transform, attributes)?;
            false
        }
        "circle" | "ellipse" => {
            let radii = if name == "circle" { ["r", "r"] } else { ["rx", "ry"] };
            let [rx, ry] = radii.map(|radius| attributes.length(radius));
            let (Some(rx), Some(ry)) = (rx.or(ry), ry.or(rx)) else { return Ok(Some(false)) };
            if rx > 0.0 && ry > 0.0 {
                let centre = ["cx", "cy"].map(|part| attributes.length_or_zero(part));
                pen.draw_ellipse([transform.point(centre), transform.vector([rx, 0.0]), transform.vector([0.0, ry])])?;
            }
            false
        }
        _ => return Ok(None),
    };
    Ok(Some(is_wrong))
}

fn draw_points(pen: &mut OutlinePen, transform: &Transform, text: &str, is_closed: bool) -> Result<bool, ReadError> {
    let mut reader = NumberReader::new(text);
    let mut path = PathPen::new(pen, transform);
    let mut is_first = true;
    while !reader.is_at_end() {
        let (Some(x), Some(y)) = (reader.number(), reader.number()) else {
            path.finish()?;
            return Ok(true);
        };
        if is_first {
            path.move_to([x, y]);
        } else {
            path.line_to([x, y])?;
        }
        is_first = false;
    }
    if is_closed {
        path.close()?;
    }
    path.finish()?;
    Ok(false)
}

fn draw_rectangle(pen: &mut OutlinePen, transform: &Transform, attributes: &Attributes<'_>) -> Result<(), ReadError> {
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| attributes.length_or_zero(name));
    if !(width > 0.0 && height > 0.0) {
        return Ok(());
    }
    let [rx, ry] = ["rx", "ry"].map(|name| attributes.length(name).filter(|radius| *radius >= 0.0));
    let (rx, ry) = (rx.or(ry).unwrap_or(0.0).min(width / 2.0), ry.or(rx).unwrap_or(0.0).min(height / 2.0));
    let (right, bottom) = (x + width, y + height);
    let mut path = PathPen::new(pen, transform);
    path.move_to([x + rx, y]);
    let corners = [
        ([right - rx, y], [right, y + ry]),
        ([right, bottom - ry], [right - rx, bottom]),
        ([x + rx, bottom], [x, bottom - ry]),
        ([x, y + ry], [x + rx, y]),
    ];
    for (start, end) in corners {
        path.line_to(start)?;
        if rx > 0.0 && ry > 0.0 {
            path.arc_to([rx, ry], 0.0, [false, true], end)?;
        }
    }
    path.close()
}
