//! The cells of a block: which of them may have the nearest point, as their corners and what the surface may be off by say; and the search of
//! those.

use super::hunt::Hunt;
use super::wait::{Look, Waiting, What};
use crate::surface::cells::{BLOCK, Cells};
use crate::surface::index::{Bounds, Pyramid};
use glam::{DVec2, DVec3};

/// A block whose cells are looked at.
pub(super) struct Leaf<'a, C> {
    pub(super) cells: &'a C,
    pub(super) index: &'a Pyramid,
    pub(super) row: usize,
    pub(super) column: usize,
}

impl<C> Leaf<'_, C> {
    /// Adds the cells that may have the nearest point to the candidates; how large the block is.
    pub(super) fn search<const N: usize>(&self, hunt: &mut Hunt) -> f64
    where
        C: Cells<N>,
    {
        hunt.leaf();
        let [rows, columns] = self.cells.counts();
        let (top, left) = (self.row * BLOCK, self.column * BLOCK);
        let (rows, columns) = (BLOCK.min(rows - top), BLOCK.min(columns - left));
        let corners = Corners::new(self.cells, [top, left], [rows, columns], hunt.query);
        // Corners are points of the surface: what is farther than the nearest of them is out.
        hunt.reaches(corners.least_square().sqrt());
        let shift = Shift::new(self.index.displacement(self.row, self.column));
        let limit = hunt.limit();
        // By the half-space through the nearest point found so far.
        let direction = hunt.direction();
        let mut bounds = [[0.0; BLOCK]; BLOCK];
        if direction != DVec3::ZERO {
            bounds = corners.half_spaces(direction, shift.along(direction));
            let least = bounds.as_flattened().iter().copied().fold(f64::INFINITY, lesser);
            if least > limit {
                return corners.extent();
            }
        }
        let squares = corners.box_squares(&shift);
        let middles = corners.middle_squares();
        // The cells that are left, the one whose middle is nearest first.
        let mut order = [0_u8; BLOCK * BLOCK];
        let mut count = 0;
        for (r, bounds) in bounds[..rows].iter().enumerate() {
            for (c, &bound) in bounds[..columns].iter().enumerate() {
                if bound > limit || squares[r][c] > limit * limit {
                    continue;
                }
                let mut at = count;
                while at > 0 && middles.as_flattened()[usize::from(order[at - 1])] > middles[r][c] {
                    order[at] = order[at - 1];
                    at -= 1;
                }
                order[at] = (BLOCK * r + c) as u8;
                count += 1;
            }
        }
        for &cell in &order[..count] {
            let (r, c) = (usize::from(cell) / BLOCK, usize::from(cell) % BLOCK);
            if squares[r][c] > hunt.limit() * hunt.limit() {
                continue;
            }
            let quad = corners.quad(r, c);
            if is_beyond(&quad, hunt.limit() + shift.most) {
                continue;
            }
            let Nearest { distance, direction, start } = bilinear(&quad);
            // The surface is next to the point of the bilinear patch.
            hunt.reaches(distance + shift.most);
            // The bilinear patch is in the hull of its corners.
            let along = quad.map(|corner| -corner.dot(direction)).into_iter().fold(f64::INFINITY, lesser);
            let bound = along - shift.along(direction);
            if bound > hunt.limit() {
                continue;
            }
            hunt.candidates.push(Candidate { bound, direction, start, cell: [(top + r) as u32, (left + c) as u32] });
        }
        corners.extent()
    }
}

/// A cell that may have the nearest point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    /// No point of the cell is nearer.
    bound: f64,
    /// The unit vector to the query from the nearest point of the cell's bilinear patch, and parameters near it.
    direction: DVec3,
    start: DVec2,
    cell: [u32; 2],
}

/// Candidates that are kept before they are looked at.
pub(super) const KEPT: usize = 64;

impl Candidate {
    pub(super) fn waiting(&self, sheet: u32) -> Waiting {
        let Candidate { bound, start, cell, .. } = *self;
        Waiting { bound: bound.max(0.0), sheet, what: What::Cell { cell, start } }
    }
}

/// Looks for a nearer point in the cells that were found to be candidates: those first that may be nearest.
pub(super) fn decide<const N: usize>(cells: &impl Cells<N>, sheet: u32, hunt: &mut Hunt) {
    let mut candidates = std::mem::take(&mut hunt.candidates);
    candidates.sort_unstable_by(|a, b| a.bound.total_cmp(&b.bound).then_with(|| a.cell.cmp(&b.cell)));
    for &Candidate { bound, direction, start, cell } in &candidates {
        let limit = hunt.limit();
        if bound > limit {
            // So are all that follow.
            break;
        }
        let patch = cells.patch(cell[0] as usize, cell[1] as usize);
        let far = |direction: DVec3| patch.half_space(hunt.query, direction) > limit;
        if !far(direction) && !far(hunt.direction()) {
            Look { patch: &patch, sheet, cell }.whole(0.0, start, hunt);
        }
    }
    candidates.clear();
    hunt.candidates = candidates;
}

/// The box of the vectors from the bilinear patches of cells to the surface.
struct Shift {
    low: [f64; 3],
    high: [f64; 3],
    middle: DVec3,
    half: DVec3,
    /// The greatest length of a vector.
    most: f64,
}

impl Shift {
    fn new(bounds: Bounds) -> Shift {
        let Bounds { low, high } = bounds;
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        Shift { low: low.to_array(), high: high.to_array(), middle, half, most: bounds.farthest() }
    }

    /// How far the surface may be in a direction from the bilinear patches.
    #[inline(always)]
    fn along(&self, direction: DVec3) -> f64 {
        self.middle.dot(direction) + self.half.dot(direction.abs())
    }
}

/// The corners of a block's cells as seen from the query, by axis; of a block that is cut off, the last ones are repeated.
struct Corners {
    axes: [[[f64; BLOCK + 1]; BLOCK + 1]; 3],
}

/// The lesser and the greater one. Unlike those of `f64`, they need not care for NaN, and are one instruction each.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl Corners {
    #[inline(always)]
    fn new<const N: usize>(
        cells: &impl Cells<N>,
        [top, left]: [usize; 2],
        [rows, columns]: [usize; 2],
        query: DVec3,
    ) -> Corners {
        let mut axes = [[[0.0; BLOCK + 1]; BLOCK + 1]; 3];
        let [xs, ys, zs] = &mut axes;
        for (r, ((xs, ys), zs)) in xs.iter_mut().zip(ys).zip(zs).enumerate() {
            let line = cells.line(top + r.min(rows), left, columns);
            for (c, [x, y, z]) in line.into_iter().enumerate() {
                (xs[c], ys[c], zs[c]) = (x - query.x, y - query.y, z - query.z);
            }
        }
        Corners { axes }
    }

    /// The corners of a cell of the block: 00, 01, 10, 11.
    #[inline(always)]
    fn quad(&self, r: usize, c: usize) -> [DVec3; 4] {
        let [x, y, z] = &self.axes;
        [(r, c), (r, c + 1), (r + 1, c), (r + 1, c + 1)].map(|(r, c)| DVec3::new(x[r][c], y[r][c], z[r][c]))
    }

    /// Across the block.
    #[inline(always)]
    fn extent(&self) -> f64 {
        let [x, y, z] = self.axes.each_ref().map(|axis| axis[BLOCK][BLOCK] - axis[0][0]);
        (x * x + y * y + z * z).sqrt()
    }

    /// How far the cells are at least from the query against a direction, if their surface is off by `play` along it.
    #[inline(always)]
    fn half_spaces(&self, direction: DVec3, play: f64) -> [[f64; BLOCK]; BLOCK] {
        let [x, y, z] = &self.axes;
        let mut along = [[0.0; BLOCK + 1]; BLOCK + 1];
        for r in 0..=BLOCK {
            for c in 0..=BLOCK {
                along[r][c] = x[r][c] * direction.x + y[r][c] * direction.y + z[r][c] * direction.z;
            }
        }
        let mut bounds = [[0.0; BLOCK]; BLOCK];
        for r in 0..BLOCK {
            for c in 0..BLOCK {
                let most =
                    greater(greater(along[r][c], along[r][c + 1]), greater(along[r + 1][c], along[r + 1][c + 1]));
                bounds[r][c] = -most - play;
            }
        }
        bounds
    }

    /// The least square of a distance of a corner.
    #[inline(always)]
    fn least_square(&self) -> f64 {
        let [x, y, z] = &self.axes;
        let mut least = [f64::INFINITY; BLOCK + 1];
        for r in 0..=BLOCK {
            for (c, least) in least.iter_mut().enumerate() {
                *least = lesser(*least, x[r][c] * x[r][c] + y[r][c] * y[r][c] + z[r][c] * z[r][c]);
            }
        }
        least.into_iter().fold(f64::INFINITY, lesser)
    }

    /// The squares of the distances of the middles of the cells' corners, times 16.
    #[inline(always)]
    fn middle_squares(&self) -> [[f64; BLOCK]; BLOCK] {
        let mut squares = [[0.0; BLOCK]; BLOCK];
        for axis in &self.axes {
            for r in 0..BLOCK {
                for c in 0..BLOCK {
                    let sum = (axis[r][c] + axis[r][c + 1]) + (axis[r + 1][c] + axis[r + 1][c + 1]);
                    squares[r][c] += sum * sum;
                }
            }
        }
        squares
    }

    /// The squares of the distances of boxes round the cells: those of their corners, and what the surface may be off by.
    #[inline(always)]
    fn box_squares(&self, shift: &Shift) -> [[f64; BLOCK]; BLOCK] {
        let mut squares = [[0.0; BLOCK]; BLOCK];
        for (k, axis) in self.axes.iter().enumerate() {
            let (mut low, mut high) = ([[0.0; BLOCK]; BLOCK + 1], [[0.0; BLOCK]; BLOCK + 1]);
            for r in 0..=BLOCK {
                for c in 0..BLOCK {
                    low[r][c] = lesser(axis[r][c], axis[r][c + 1]);
                    high[r][c] = greater(axis[r][c], axis[r][c + 1]);
                }
            }
            for r in 0..BLOCK {
                for c in 0..BLOCK {
                    let (low, high) = (lesser(low[r][c], low[r + 1][c]), greater(high[r][c], high[r + 1][c]));
                    let outside = greater(greater(low + shift.low[k], -high - shift.high[k]), 0.0);
                    squares[r][c] += outside * outside;
                }
            }
        }
        squares
    }
}

/// True if the hull of four corners is farther from the origin than `limit`, by the half-space across the direction of their middle: from
/// afar, that is nearly all there is to say of a cell.
#[inline(always)]
fn is_beyond(corners: &[DVec3; 4], limit: f64) -> bool {
    let [a, b, c, d] = *corners;
    let middle = (a + b) + (c + d);
    let along = lesser(lesser(a.dot(middle), b.dot(middle)), lesser(c.dot(middle), d.dot(middle)));
    along > 0.0 && along * along > limit * limit * middle.length_squared()
}

/// The nearest point of a bilinear patch, nearly.
struct Nearest {
    /// A point of the patch is no farther than this; the direction is a unit vector from about there to the origin.
    distance: f64,
    direction: DVec3,
    /// Parameters near the nearest point.
    start: DVec2,
}

/// The nearest point of the bilinear patch through four corners (00, 01, 10, 11) to the origin.
///
/// With s and t from the middle, the patch is m + s u + t v + s t w: a quarter of |w| at most from the parallelogram without the twist w, whose
/// nearest point is found.
fn bilinear(corners: &[DVec3; 4]) -> Nearest {
    let [p00, p01, p10, p11] = *corners;
    let (low, high) = (p00 + p01, p10 + p11);
    let (left, right) = (p00 + p10, p01 + p11);
    let (middle, u, v) = (0.25 * (low + high), 0.5 * (high - low), 0.5 * (right - left));
    let twist = (p00 - p01) - (p10 - p11);
    let (uu, uv, vv, mu, mv) = (u.length_squared(), u.dot(v), v.length_squared(), middle.dot(u), middle.dot(v));
    let (area, inner) = (uu * vv - uv * uv, [uv * mv - vv * mu, uv * mu - uu * mv]);
    let sound = area > 1e-12 * uu * vv;
    let outside = inner.map(|x| x.abs() > 0.5 * area);
    let value = |[s, t]: [f64; 2]| (middle + s * u + t * v).length_squared();
    let (square, [s, t]) = if sound && outside == [false; 2] {
        let place = inner.map(|x| x / area);
        (value(place), place)
    } else {
        // The nearest point is on a side beyond which the one of the whole plane is; of a flat parallelogram, on any.
        let divided = |above: f64, below: f64| if below > 0.0 { (above / below).clamp(-0.5, 0.5) } else { 0.0 };
        let mut best = (f64::INFINITY, [0.0; 2]);
        let mut take = |place: [f64; 2]| {
            let square = value(place);
            if square < best.0 {
                best = (square, place);
            }
        };
        for end in [-0.5, 0.5] {
            if !sound || (outside[0] && inner[0] * end > 0.0) {
                take([end, divided(-mv - end * uv, vv)]);
            }
            if !sound || (outside[1] && inner[1] * end > 0.0) {
                take([divided(-mu - end * uv, uu), end]);
            }
        }
        best
    };
    let distance = square.sqrt();
    let direction = if distance > 0.0 { (middle + s * u + t * v) / -distance } else { DVec3::ZERO };
    Nearest { distance: distance + 0.25 * twist.length(), direction, start: DVec2::new(s + 0.5, t + 0.5) }
}
