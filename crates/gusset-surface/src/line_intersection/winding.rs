//! Whether a line crosses the surface at a side, a corner or a pole, where tangents may jump.
//!
//! In projection along the line, the tangents into the cells around a point turn about it. If the
//! line crosses the surface, they turn once. If the line enters through one cell and leaves through
//! another, they do not turn. In general, the line crosses if the number of turns is odd, because
//! each turn is a sheet between its two sides.

use crate::{Place, Surface};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// If the number of turns differs more from an integer, the cells are not all around the point.
const MAX_TURN_COUNT_ERROR: f64 = 0.01;

impl Surface<'_> {
    /// The place moved to a side of its cell, if it is within `tolerance` of one.
    pub(super) fn snap_to_cell_side(&self, place: Place, tolerance: f64) -> Option<Place> {
        let jet = self.jet(place);
        let snapped = |x: f64, tangent: DVec3| {
            let slack = tolerance / tangent.length();
            if x <= slack && x <= 0.5 {
                0.0
            } else if 1.0 - x <= slack {
                1.0
            } else {
                x
            }
        };
        let there = Place { u: snapped(place.u, jet.u), v: snapped(place.v, jet.v), ..place };
        let is_end = |x: f64| x == 0.0 || x == 1.0;
        (is_end(there.u) || is_end(there.v)).then_some(there)
    }

    /// True if a line only touches the surface at places on sides of cells that are the same point:
    /// it stays on one side of the surrounding cells. False at a border, where cells are not all
    /// around.
    pub(super) fn does_line_only_touch(&self, places: &[Place], direction: DVec3) -> bool {
        let mut cells: Vec<Place> = Vec::new();
        for place in places {
            if !cells.iter().any(|known| (known.sheet, known.cell) == (place.sheet, place.cell)) {
                cells.extend(self.cells_around_place(*place));
            }
        }
        let along = direction.normalize();
        let (x, y) = along.any_orthonormal_pair();
        // Counter-clockwise seen against the direction, or clockwise; both work.
        let seen = |tangent: DVec3| DVec2::new(tangent.dot(x), tangent.dot(y));
        let (mut forth, mut back) = (0.0, 0.0);
        for &place in &cells {
            let angle = self.projected_corner_angle(place, seen) / TAU;
            *if angle < 0.0 { &mut back } else { &mut forth } += angle;
        }
        let (turns, turned) = (forth + back, forth.min(-back) > 0.0);
        let whole = turns.round();
        // A fan that turns little, and never back, is at a border.
        (turns - whole).abs() <= MAX_TURN_COUNT_ERROR && whole % 2.0 == 0.0 && (turned || whole != 0.0)
    }

    /// True if a direction only touches the surface at a place next to a side, as far as the
    /// rounding of numbers up to `largest` allows.
    pub(super) fn does_direction_only_touch(&self, place: Place, direction: DVec3, largest: f64) -> bool {
        let (size, sine) = (self.box_diagonal(), self.normal(place).dot(direction).abs());
        let rounding_error = 64.0 * f64::EPSILON * largest.max(size);
        let tolerance = rounding_error / sine.max((rounding_error / size).sqrt());
        let on_side = self.snap_to_cell_side(place, tolerance);
        on_side.is_some_and(|place| self.does_line_only_touch(&[place], direction))
    }

    /// True if the side of its cell that a place is on, across u (direction 0) or v, is a single
    /// point.
    fn is_side_pole(&self, place: Place, direction: usize) -> bool {
        let at = if direction == 0 { place.u } else { place.v };
        let [i, j] = place.cell.map(|k| k as usize);
        (at == 0.0 || at == 1.0) && self.sheet(place.sheet as usize).is_cell_side_point(direction, i, j, at == 1.0)
    }

    /// The cells of the sheet around a place on a side, each with its parameters of the place. At a
    /// pole, all cells with a side there.
    fn cells_around_place(&self, place: Place) -> Vec<Place> {
        let sheet = self.sheet(place.sheet as usize);
        let (counts, closed) = (sheet.cells(), sheet.is_closed());
        let lines = |direction: usize, at: f64| {
            let (cell, count) = (place.cell[direction], counts[direction] as u32);
            let wraps = closed[direction];
            let next = if at == 0.0 {
                (cell > 0 || wraps).then(|| ((cell + count - 1) % count, 1.0))
            } else if at == 1.0 {
                (cell + 1 < count || wraps).then(|| ((cell + 1) % count, 0.0))
            } else {
                None
            };
            std::iter::once((cell, at)).chain(next)
        };
        let point = self.jet(place).point;
        let is_here = |other: &Place| self.jet(*other).point.distance(point) <= 1e-12 * self.box_diagonal();
        let mut cells = Vec::new();
        for direction in 0..2 {
            if self.is_side_pole(place, direction) {
                let at = if direction == 0 { place.u } else { place.v };
                for (line, at) in lines(direction, at) {
                    cells.extend((0..counts[1 - direction] as u32).map(|k| match direction {
                        0 => Place { cell: [line, k], u: at, v: 0.5, ..place },
                        _ => Place { cell: [k, line], u: 0.5, v: at, ..place },
                    }));
                }
                cells.retain(|other| self.is_side_pole(*other, direction) && is_here(other));
                return cells;
            }
        }
        for (i, u) in lines(0, place.u) {
            cells.extend(lines(1, place.v).map(|(j, v)| Place { cell: [i, j], u, v, ..place }));
        }
        cells
    }

    /// Returns the angle between the tangents from a place into its cell, in projection.
    fn projected_corner_angle(&self, place: Place, project: impl Fn(DVec3) -> DVec2) -> f64 {
        let between = |[a, b]: [DVec2; 2]| libm::atan2(a.perp_dot(b), a.dot(b));
        let at = |u: f64, v: f64| self.jet(Place { u, v, ..place });
        // At a pole, the tangents of the lines that meet there, turning in the sense from S_u to
        // S_v.
        let fan = [0.0, 0.5, 1.0];
        let turn = |[a, b, c]: [DVec2; 3]| between([a, b]) + between([b, c]);
        if self.is_side_pole(place, 0) {
            let inwards = if place.u == 0.0 { 1.0 } else { -1.0 };
            return turn(fan.map(|v| project(inwards * at(place.u, if place.u == 0.0 { v } else { 1.0 - v }).u)));
        }
        if self.is_side_pole(place, 1) {
            let inwards = if place.v == 0.0 { 1.0 } else { -1.0 };
            return turn(fan.map(|u| project(inwards * at(if place.v == 1.0 { u } else { 1.0 - u }, place.v).v)));
        }
        let jet = at(place.u, place.v);
        let tangents = [jet.u, jet.v, -jet.u, -jet.v].map(&project);
        let inside = [place.u < 1.0, place.v < 1.0, place.u > 0.0, place.v > 0.0];
        (0..4)
            .map(|k| (k, (k + 1) % 4))
            .filter(|&(a, b)| inside[a] && inside[b])
            .map(|(a, b)| between([tangents[a], tangents[b]]))
            .sum()
    }
}
