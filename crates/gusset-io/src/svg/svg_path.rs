//! Path data, and points of polygons.

use super::svg_arc::CentredArc;
use super::svg_numbers::NumberReader;
use super::svg_transform::Transform;
use crate::error::ReadError;
use crate::outline_pen::OutlinePen;

type Point = [f64; 2];

/// Curve commands whose control point the next smooth command reflects.
#[derive(Clone, Copy, PartialEq)]
enum Reflected {
    Nothing,
    Quadratic(Point),
    Cubic(Point),
}

/// Draws in the coordinates of an element.
pub(super) struct PathPen<'a> {
    pen: &'a mut OutlinePen,
    transform: &'a Transform,
    current: Point,
    start: Point,
    reflected: Reflected,
    has_moved: bool,
    is_drawing: bool,
}

/// Draws path data up to the first mistake. Returns whether there is one.
pub(super) fn draw_path(pen: &mut OutlinePen, transform: &Transform, data: &str) -> Result<bool, ReadError> {
    let mut path = PathPen::new(pen, transform);
    let mut reader = NumberReader::new(data);
    let mut command = 0;
    let mut is_wrong = false;
    while !reader.is_at_end() && !path.pen.is_full() && !is_wrong {
        command = match command {
            _ if reader.peek().is_some_and(|byte| byte.is_ascii_alphabetic()) => reader.byte().unwrap_or(0),
            // Further points of a move are lines. Nothing may follow the end of an outline.
            b'M' => b'L',
            b'm' => b'l',
            b'Z' | b'z' => 0,
            _ => command,
        };
        is_wrong = !path.draw_command(command, &mut reader)?;
    }
    path.finish()?;
    Ok(is_wrong)
}

impl<'a> PathPen<'a> {
    pub(super) fn new(pen: &'a mut OutlinePen, transform: &'a Transform) -> Self {
        Self {
            pen,
            transform,
            current: [0.0; 2],
            start: [0.0; 2],
            reflected: Reflected::Nothing,
            has_moved: false,
            is_drawing: false,
        }
    }

    pub(super) fn move_to(&mut self, point: Point) {
        (self.current, self.start) = (point, point);
        (self.has_moved, self.is_drawing) = (true, false);
    }

    pub(super) fn line_to(&mut self, point: Point) -> Result<(), ReadError> {
        self.begin_outline()?;
        self.current = point;
        self.pen.line_to(self.transform.point(point))
    }

    pub(super) fn close(&mut self) -> Result<(), ReadError> {
        if self.is_drawing {
            self.pen.end_outline(true)?;
        }
        self.is_drawing = false;
        self.current = self.start;
        Ok(())
    }

    /// Ends an outline that is open.
    pub(super) fn finish(self) -> Result<(), ReadError> {
        self.pen.end_outline(false)
    }

    pub(super) fn arc_to(
        &mut self,
        radii: Point,
        rotation: f64,
        flags: [bool; 2],
        end: Point,
    ) -> Result<(), ReadError> {
        self.begin_outline()?;
        let Some(arc) = CentredArc::from_ends(self.current, end, radii, rotation, flags) else {
            return self.line_to(end);
        };
        let [u, v] = arc.axes.map(|axis| self.transform.vector(axis));
        self.current = end;
        self.pen.arc_to([self.transform.point(arc.centre), u, v], arc.angles, self.transform.point(end))
    }

    fn begin_outline(&mut self) -> Result<(), ReadError> {
        if !self.is_drawing {
            self.is_drawing = true;
            self.pen.begin_outline(self.transform.point(self.current))?;
        }
        Ok(())
    }

    /// Draws one command. Returns false if its numbers are wrong or it is unknown.
    fn draw_command(&mut self, command: u8, reader: &mut NumberReader<'_>) -> Result<bool, ReadError> {
        let base = if command.is_ascii_lowercase() { self.current } else { [0.0; 2] };
        let mut point = || Some([reader.number()? + base[0], reader.number()? + base[1]]);
        let letter = command.to_ascii_uppercase();
        if letter != b'M' && !self.has_moved {
            return Ok(false);
        }
        let mut reflected = Reflected::Nothing;
        match letter {
            b'M' => {
                let Some(target) = point() else { return Ok(false) };
                self.move_to(target);
            }
            b'L' => {
                let Some(target) = point() else { return Ok(false) };
                self.line_to(target)?;
            }
            b'H' | b'V' => {
                let Some(number) = reader.number() else { return Ok(false) };
                let [x, y] = self.current;
                self.line_to(if letter == b'H' { [number + base[0], y] } else { [x, number + base[1]] })?;
            }
            b'C' | b'S' => {
                let first = if letter == b'C' { point() } else { Some(self.reflected_point(true)) };
                let (Some(first), Some(second), Some(end)) = (first, point(), point()) else { return Ok(false) };
                self.bezier([self.current, first, second, end])?;
                reflected = Reflected::Cubic(second);
            }
            b'Q' | b'T' => {
                let control = if letter == b'Q' { point() } else { Some(self.reflected_point(false)) };
                let (Some(control), Some(end)) = (control, point()) else { return Ok(false) };
                self.bezier([self.current, control, end])?;
                reflected = Reflected::Quadratic(control);
            }
            b'A' => return self.draw_arc(base, reader),
            b'Z' => self.close()?,
            _ => return Ok(false),
        }
        self.reflected = reflected;
        Ok(true)
    }

    fn draw_arc(&mut self, base: Point, reader: &mut NumberReader<'_>) -> Result<bool, ReadError> {
        self.reflected = Reflected::Nothing;
        let (Some(rx), Some(ry), Some(rotation)) = (reader.number(), reader.number(), reader.number()) else {
            return Ok(false);
        };
        let (Some(is_large), Some(is_positive)) = (reader.flag(), reader.flag()) else { return Ok(false) };
        let (Some(x), Some(y)) = (reader.number(), reader.number()) else { return Ok(false) };
        self.arc_to([rx, ry], rotation, [is_large, is_positive], [x + base[0], y + base[1]])?;
        Ok(true)
    }

    /// Returns the control point that continues the last curve of the same degree.
    fn reflected_point(&self, is_cubic: bool) -> Point {
        match self.reflected {
            Reflected::Cubic(control) if is_cubic => [0, 1].map(|axis| 2.0 * self.current[axis] - control[axis]),
            Reflected::Quadratic(control) if !is_cubic => [0, 1].map(|axis| 2.0 * self.current[axis] - control[axis]),
            _ => self.current,
        }
    }

    fn bezier<const N: usize>(&mut self, control: [Point; N]) -> Result<(), ReadError> {
        self.begin_outline()?;
        self.current = control[N - 1];
        self.pen.bezier_to(control.map(|point| self.transform.point(point)))
    }
}
