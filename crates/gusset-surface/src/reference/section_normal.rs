//! The paper's approximate normal, from two plane sections through the lines of the surface.
//!
//! Both planes pass through the point, and are parallel to b, the mean of the four normals at the
//! cell's corners. They are perpendicular to each other. Each plane crosses the coordinate curves
//! close to the cell, and a cubic through four crossings approximates the section. The tangents of
//! both sections span the tangent plane. The error is of third order in the size of cells, like the
//! derivative of a cubic through four points.

use super::cell_grid_shape::CellGridShape;
use crate::cells::SheetCells;
use crate::{Sheet, each_sheet};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::{evaluate, halves};

/// Number of lines that a section interpolates.
const LINES_PER_SECTION: usize = 4;
/// Number of cells on either side in which a crossing with a line is sought.
const MAX_CELLS_TO_CROSSING: usize = 8;
/// Number of cells by which lines are extrapolated beyond an open edge.
const MAX_EXTRAPOLATION_IN_CELLS: f64 = 0.5;
/// Number of halvings of an edge after which a crossing is accurate to the last bit.
const MAX_EDGE_HALVINGS: u32 = 60;

/// The approximate unit normal at parameters (u, v) of a cell, from two perpendicular plane
/// sections, on the side of S_u x S_v. Returns zero if a plane crosses fewer than two lines close
/// to the cell, or if the normals at its corners cancel.
///
/// It uses only the lines of the surface. [`Sheet::normal`] is also of third order, with a smaller
/// constant, and faster.
///
/// # Errors
/// [`Error::NoSuch`]; [`Error::OptionOutOfRange`] if a parameter is outside 0 to 1.
pub fn normal_by_sections(sheet: &Sheet<'_>, cell: [usize; 2], u: f64, v: f64) -> Result<DVec3> {
    CellGridShape::new(sheet).check_cell(cell)?;
    [("u", u), ("v", v)]
        .into_iter()
        .try_for_each(|(name, t)| Error::require((0.0..=1.0).contains(&t), name, t, "from 0 to 1"))?;
    let [i, j] = cell;
    let point = sheet.jet(i, j, u, v).point;
    let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    let mean: DVec3 = corners.iter().map(|&[u, v]| sheet.normal(i, j, u, v)).sum();
    let along_u = sheet.jet(i, j, 0.5, 0.5).u;
    let frame = mean.try_normalize().and_then(|b| Some((b, (along_u - along_u.dot(b) * b).try_normalize()?)));
    let Some((b, first)) = frame else { return Ok(DVec3::ZERO) };
    let second = b.cross(first);
    let lattice = CellGridShape::new(sheet);
    // The plane along `first` crosses lines of constant u, the plane along `second` lines of
    // constant v.
    let slope = |direction: usize, along: DVec3, across: DVec3| {
        let section = NormalPlaneSection { point, direction_in_plane: along, plane_normal: across, up: b };
        each_sheet!(sheet, cells => section.section_slope(cells, lattice, direction, cell))
    };
    let normal = slope(0, first, second).zip(slope(1, second, first)).map(|(s, t)| b - s * first - t * second);
    Ok(normal.map_or(DVec3::ZERO, DVec3::normalize_or_zero))
}

/// A plane section near a point of it.
struct NormalPlaneSection {
    point: DVec3,
    /// The direction in the plane perpendicular to `up`.
    direction_in_plane: DVec3,
    /// The plane's normal.
    plane_normal: DVec3,
    up: DVec3,
}

impl NormalPlaneSection {
    /// The slope, at the point, of the cubic through the crossings with lines of one direction
    /// around a cell.
    fn section_slope<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        lattice: CellGridShape,
        direction: usize,
        cell: [usize; 2],
    ) -> Option<f64> {
        let (count, at) = (lattice.cells[direction], cell[direction]);
        let (mut crossings, mut found) = ([[0.0; 2]; LINES_PER_SECTION], 0);
        for k in 0..LINES_PER_SECTION.min(count + 1) {
            let line = match lattice.closed[direction] {
                true => (at + count + k - 1) % count,
                // As central as the edges allow.
                false => at.saturating_sub(1).min((count + 1).saturating_sub(LINES_PER_SECTION)) + k,
            };
            if let Some(crossing) = self.crossing_with_line(cells, lattice, direction, line, cell[1 - direction]) {
                let from = crossing - self.point;
                crossings[found] = [from.dot(self.direction_in_plane), from.dot(self.up)];
                found += 1;
            }
        }
        let slope = polynomial_slope_at_origin(&crossings[..found]);
        (found >= 2 && slope.is_finite()).then_some(slope)
    }

    /// The point where the plane crosses a line of the surface close to place `near_place` on it.
    fn crossing_with_line<const N: usize>(
        &self,
        cells: &impl SheetCells<N>,
        lattice: CellGridShape,
        direction: usize,
        line: usize,
        near_place: usize,
    ) -> Option<DVec3> {
        let (count, closed) = (lattice.cells[1 - direction], lattice.closed[1 - direction]);
        let within = |place: usize, range: [f64; 2]| {
            let edge = line_controls_over_cell(cells, lattice, direction, line, place);
            let field = edge.map(|control| (control - self.point).dot(self.plane_normal));
            let root = first_root_in_interval(restrict_polynomial(field, range), MAX_EDGE_HALVINGS)?;
            Some(evaluate(&edge, range[0] + root * (range[1] - range[0])))
        };
        for offset in 0..=MAX_CELLS_TO_CROSSING {
            let wrapped = |place: Option<usize>| match place {
                Some(place) if place < count => Some(place),
                _ if !closed || offset >= count => None,
                Some(place) => Some(place - count),
                None => Some(near_place + count - offset),
            };
            let places =
                [near_place.checked_add(offset), near_place.checked_sub(offset)].into_iter().filter_map(wrapped);
            let crossings = places.filter_map(|place| within(place, [0.0, 1.0]));
            let nearest =
                crossings.min_by(|a, b| a.distance_squared(self.point).total_cmp(&b.distance_squared(self.point)));
            if nearest.is_some() {
                return nearest;
            }
        }
        // Close to an open edge, the crossing may be on the extension of the line's last cubic.
        let ends = [(0, [-MAX_EXTRAPOLATION_IN_CELLS, 0.0]), (count - 1, [1.0, 1.0 + MAX_EXTRAPOLATION_IN_CELLS])];
        let near = |&(place, _): &(usize, [f64; 2])| !closed && place.abs_diff(near_place) <= MAX_CELLS_TO_CROSSING;
        ends.into_iter().filter(near).find_map(|(place, range)| within(place, range))
    }
}

/// The Bézier points of a line of the surface over one cell. Direction 0 means lines of constant u.
fn line_controls_over_cell<const N: usize>(
    cells: &impl SheetCells<N>,
    lattice: CellGridShape,
    direction: usize,
    line: usize,
    place: usize,
) -> [DVec3; N] {
    // The last line of an open direction is the far side of the last cells.
    let is_far = line == lattice.cells[direction];
    let row = line - usize::from(is_far);
    let side = if is_far { N - 1 } else { 0 };
    match direction {
        0 => cells.cell_patch(row, place).points[side],
        _ => cells.cell_patch(place, row).transposed().points[side],
    }
}

/// A polynomial in Bernstein form, reparametrised to another interval by its blossom.
fn restrict_polynomial<const N: usize>(field: [f64; N], [from, to]: [f64; 2]) -> [f64; N] {
    std::array::from_fn(|ends| {
        let mut work = field;
        for (step, count) in (1..N).rev().enumerate() {
            let t = if step < ends { to } else { from };
            (0..count).for_each(|k| work[k] += t * (work[k + 1] - work[k]));
        }
        work[0]
    })
}

/// The first root of a polynomial in Bernstein form. Halves whose coefficients have one sign are
/// skipped.
fn first_root_in_interval<const N: usize>(field: [f64; N], depth: u32) -> Option<f64> {
    if field.iter().all(|&x| x > 0.0) || field.iter().all(|&x| x < 0.0) {
        return None;
    }
    if field[0] == 0.0 {
        return Some(0.0);
    }
    if depth == 0 {
        return Some(0.5);
    }
    let [low, high] = halves(&field);
    let first = first_root_in_interval(low, depth - 1).map(|t| 0.5 * t);
    first.or_else(|| first_root_in_interval(high, depth - 1).map(|t| 0.5 + 0.5 * t))
}

/// The slope at 0 of the polynomial through points (s, h). Not finite if two points have the same
/// s.
fn polynomial_slope_at_origin(points: &[[f64; 2]]) -> f64 {
    let mut slope = 0.0;
    for (k, &[s, h]) in points.iter().enumerate() {
        let others = || points.iter().enumerate().filter(move |&(m, _)| m != k).map(|(m, point)| (m, point[0]));
        // The derivative of the product of the factors (0 - s_l) / (s - s_l).
        for (m, from) in others() {
            let rest = others().filter(|&(l, _)| l != m).map(|(_, at)| -at / (s - at));
            slope += h / (s - from) * rest.product::<f64>();
        }
    }
    slope
}
