//! The search of the index for a line.

use super::{Hit, Line, Which};
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::index::{Bounds, Pyramid};
use crate::carcass::solve::{Field, Roots, roots};
use crate::carcass::{Patch, Place};
use glam::{DVec2, DVec3};

/// What the search needs to know of the line.
struct Ray {
    /// Relative to the index's origin.
    origin: DVec3,
    direction: DVec3,
    inverse: DVec3,
    /// Two directions across the line, and each other.
    across: [DVec3; 2],
}

/// Adds the hits of one sheet.
pub(super) fn search<const N: usize>(
    cells: &impl Cells<N>,
    index: &Pyramid,
    sheet: u32,
    line: &Line,
    which: Which,
    tolerance: f64,
    hits: &mut Vec<Hit>,
) {
    let (first, second) = line.direction.normalize().any_orthonormal_pair();
    let ray = Ray {
        origin: line.origin - index.origin(),
        direction: line.direction,
        inverse: line.direction.recip(),
        across: [first, second],
    };
    let levels = index.levels();
    let mut stack = vec![(line.from, levels.len(), 0, 0)];
    let own = hits.len();
    while let Some((from, level, row, column)) = stack.pop() {
        let farthest = match which {
            Which::First => hits.iter().map(|hit| hit.t).fold(line.to, f64::min),
            _ => line.to,
        };
        if from > farthest {
            continue;
        }
        if level == 0 {
            let leaf = Leaf { cells, index, sheet, line, ray: &ray, tolerance, own };
            leaf.search(row, column, hits);
            if which == Which::Any && hits.len() > own {
                return;
            }
            continue;
        }
        let level_below = &levels[level - 1];
        let group = level_below.group(row, column);
        let mut children = [None; 4];
        for (child, entry) in children.iter_mut().enumerate() {
            let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
            if let Some([from, to]) = ray.through(&group.get(child), line.from, farthest)
                && from <= to
                && level_below
                    .oriented(row, column)
                    .is_none_or(|oriented| oriented.meets_line(ray.origin, ray.direction))
            {
                *entry = Some((from, level - 1, row, column));
            }
        }
        // The nearest last, to be taken first.
        children.sort_by(|a, b| {
            let from = |entry: &Option<(f64, usize, usize, usize)>| entry.map_or(f64::INFINITY, |entry| entry.0);
            from(b).total_cmp(&from(a))
        });
        stack.extend(children.into_iter().flatten());
    }
}

impl Ray {
    /// The part of from..to in which the line is in a box.
    #[inline]
    fn through(&self, bounds: &Bounds, from: f64, to: f64) -> Option<[f64; 2]> {
        if bounds.is_empty() {
            return None;
        }
        let (mut near, mut far) = (from, to);
        for axis in 0..3 {
            let (low, high) = (bounds.low[axis] - self.origin[axis], bounds.high[axis] - self.origin[axis]);
            if self.direction[axis] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let (a, b) = (low * self.inverse[axis], high * self.inverse[axis]);
            // A little wider than the box, for rounding.
            let play = 4.0 * f64::EPSILON * a.abs().max(b.abs());
            near = near.max(a.min(b) - play);
            far = far.min(a.max(b) + play);
        }
        (near <= far).then_some([near, far])
    }
}

/// What the search of a block needs.
struct Leaf<'a, C> {
    cells: &'a C,
    index: &'a Pyramid,
    sheet: u32,
    line: &'a Line,
    ray: &'a Ray,
    tolerance: f64,
    /// The first hit of this sheet.
    own: usize,
}

impl<C> Leaf<'_, C> {
    fn search<const N: usize>(&self, row: usize, column: usize, hits: &mut Vec<Hit>)
    where
        C: Cells<N>,
    {
        let [rows, columns] = self.cells.counts();
        let (first, last) = (row * BLOCK, rows.min((row + 1) * BLOCK));
        let (left, right) = (column * BLOCK, columns.min((column + 1) * BLOCK));
        let deviation = self.index.deviation(row, column);
        let mut corners = [[DVec2::ZERO; BLOCK + 1]; BLOCK + 1];
        for i in first..=last {
            for j in left..=right {
                corners[i - first][j - left] = self.across(self.cells.corner(i, j));
            }
        }
        for i in first..last {
            for j in left..right {
                let (r, c) = (i - first, j - left);
                let quad = [corners[r][c], corners[r][c + 1], corners[r + 1][c + 1], corners[r + 1][c]];
                if may_hold_origin(&quad, deviation) {
                    self.cell(i, j, hits);
                }
            }
        }
    }

    /// Where a point is, seen along the line.
    fn across(&self, point: DVec3) -> DVec2 {
        let from = point - self.line.origin;
        DVec2::from_array(self.ray.across.map(|direction| from.dot(direction)))
    }

    fn cell<const N: usize>(&self, i: usize, j: usize, hits: &mut Vec<Hit>)
    where
        C: Cells<N>,
    {
        let patch = self.cells.patch(i, j);
        let fields = self.ray.across.map(|direction| Field {
            c: patch.points.map(|row| row.map(|point| (point - self.line.origin).dot(direction))),
        });
        let reach = (patch.points[0][0] - self.line.origin).length() + self.line.origin.length();
        let noise = 8.0 * f64::EPSILON * reach;
        let mut found = Roots::default();
        roots(fields, noise, self.tolerance, &mut found);
        for place in found.simple {
            self.add(&patch, [i, j], place, None, hits);
        }
        for (place, size) in found.unresolved {
            self.add(&patch, [i, j], place, Some(size), hits);
        }
    }

    /// Adds a hit, unless it is one that was found in a neighbouring cell.
    fn add<const N: usize>(
        &self,
        patch: &Patch<N>,
        [i, j]: [usize; 2],
        at: DVec2,
        unresolved: Option<f64>,
        hits: &mut Vec<Hit>,
    ) {
        let jet = patch.jet(at.x, at.y);
        let (point, tangent) = (jet.point, unresolved.is_some());
        let t = (point - self.line.origin).dot(self.line.direction) / self.line.direction.length_squared();
        if t < self.line.from || t > self.line.to {
            return;
        }
        let place = Place { sheet: self.sheet, cell: [i as u32, j as u32], u: at.x, v: at.y };
        let hit = Hit { t, place, point, tangent };
        // Of the same sheet: on a side between cells, as near as answers are proved; or a part that may touch, next to another.
        let near = unresolved.map_or(self.tolerance, |reach| 2.0 * reach * (jet.u.length() + jet.v.length()));
        let same =
            |other: &Hit| other.point.distance(point) <= near && other.tangent == tangent && (tangent || on_side(at));
        match hits[self.own..].iter_mut().find(|other| same(other)) {
            // The first cell's, whatever the order of the search.
            Some(other) if hit.place.cell < other.place.cell => *other = hit,
            Some(_) => {}
            None => hits.push(hit),
        }
    }
}

/// True next to a side of the cell.
fn on_side(at: DVec2) -> bool {
    let near = |x: f64| x <= 1e-9 || x >= 1.0 - 1e-9;
    near(at.x) || near(at.y)
}

/// False if the origin is farther than `by` from the hull of four points, as one of the lines through two of them shows.
fn may_hold_origin(quad: &[DVec2; 4], by: f64) -> bool {
    let separated = |normal: DVec2| {
        let length = by * normal.length();
        let along = quad.map(|corner| corner.dot(normal));
        along.iter().all(|&x| x > length) || along.iter().all(|&x| x < -length)
    };
    let sides = (0..4).map(|k| (quad[(k + 1) % 4] - quad[k]).perp());
    !([DVec2::X, DVec2::Y].into_iter().chain(sides).any(separated))
}
