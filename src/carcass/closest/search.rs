//! The search of the index for the nearest point: near children first, and whatever cannot be nearer is dropped.

use super::cell::{Scratch, nearest};
use super::hunt::{Answer, Hunt};
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::index::{Oriented, Pyramid};
use glam::{DVec2, DVec3};

/// A block to be looked at: a lower bound of the square of its distance, in single precision (see [`Sight`]), and where it is.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Entry {
    bound: f32,
    level: u32,
    row: u32,
    column: u32,
}

/// The query as boxes see it, in single precision.
struct Sight {
    /// Relative to the index's origin.
    local: DVec3,
    single: [f32; 3],
    /// How far a bound may be above the distance, by the rounding of the query.
    play: f64,
}

impl Sight {
    fn new(index: &Pyramid, query: DVec3) -> Sight {
        let local = query - index.origin();
        let play = 2.0 * f64::from(f32::EPSILON) * local.abs().max_element();
        Sight { local, single: local.to_array().map(|x| x as f32), play }
    }

    /// What squares of bounds are compared with: greater ones are farther than `limit`. Sums of three squares are right to 2^-22.
    #[inline(always)]
    fn threshold(&self, limit: f64) -> f32 {
        if limit < 0.0 {
            return f32::NEG_INFINITY;
        }
        let most = (limit + self.play) * (1.0 + 2e-6);
        (most * most) as f32
    }

    /// The distance that the square of a bound proves.
    fn distance(&self, bound: f32) -> f64 {
        (f64::from(bound).sqrt() * (1.0 - 2e-6) - self.play).max(0.0)
    }
}

/// Looks for a nearer point in a sheet, number `sheet` of its carcass.
pub(super) fn search<const N: usize>(
    cells: &impl Cells<N>,
    index: &Pyramid,
    sheet: u32,
    hunt: &mut Hunt,
    scratch: &mut Scratch<N>,
) {
    let sight = Sight::new(index, hunt.query);
    let levels = index.levels();
    let mut stack = std::mem::take(&mut hunt.stack);
    stack.clear();
    stack.push(Entry { level: levels.len() as u32, ..Entry::default() });
    while let Some(entry) = stack.pop() {
        if entry.bound > sight.threshold(hunt.limit()) {
            hunt.drop(|| sight.distance(entry.bound));
            continue;
        }
        let (row, column) = (entry.row as usize, entry.column as usize);
        if entry.level == 0 {
            Leaf { cells, index, sheet, row, column }.search(hunt, scratch);
            continue;
        }
        let level = &levels[entry.level as usize - 1];
        let distances = level.group(row, column).single_distances_squared(sight.single);
        let threshold = sight.threshold(hunt.limit());
        let first = stack.len();
        for (child, &boxed) in distances.iter().enumerate() {
            let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
            if !level.has(row, column) {
                continue;
            }
            let bound = if boxed > threshold {
                boxed
            } else {
                let oriented = |oriented: &Oriented| oriented.distance_squared(sight.local) as f32;
                level.oriented(row, column).map_or(0.0, oriented).max(boxed)
            };
            if bound > threshold {
                hunt.drop(|| sight.distance(bound));
                continue;
            }
            // Sorted as they come: the nearest is taken first, being last.
            let mut at = stack.len();
            stack.push(Entry { bound, level: entry.level - 1, row: row as u32, column: column as u32 });
            while at > first && stack[at - 1].bound < bound {
                stack.swap(at, at - 1);
                at -= 1;
            }
        }
    }
    hunt.stack = stack;
}

/// A block whose cells are looked at.
struct Leaf<'a, C> {
    cells: &'a C,
    index: &'a Pyramid,
    sheet: u32,
    row: usize,
    column: usize,
}

impl<C> Leaf<'_, C> {
    fn search<const N: usize>(&self, hunt: &mut Hunt, scratch: &mut Scratch<N>)
    where
        C: Cells<N>,
    {
        hunt.leaves += 1;
        let [rows, columns] = self.cells.counts();
        let (top, left) = (self.row * BLOCK, self.column * BLOCK);
        let (rows, columns) = (BLOCK.min(rows - top), BLOCK.min(columns - left));
        let corners = Corners::new(self.cells, [top, left], [rows, columns], hunt.query);
        // Corners are points of the surface: what is farther than the nearest of them is out.
        hunt.reaches(corners.least_square().sqrt());
        let deviation = self.index.deviation(self.row, self.column);
        let squares = corners.box_squares();
        let far = square(hunt.limit() + deviation);
        let middles = corners.middle_squares();
        // The cells that are left, the one whose middle is nearest first.
        let mut order = [0_u8; BLOCK * BLOCK];
        let mut count = 0;
        for (cell, &boxed) in squares.as_flattened().iter().enumerate() {
            if boxed > far {
                hunt.drop(|| boxed.sqrt() - deviation);
            } else if cell / BLOCK < rows && cell % BLOCK < columns {
                let middle = middles.as_flattened()[cell];
                let mut at = count;
                while at > 0 && middles.as_flattened()[usize::from(order[at - 1])] > middle {
                    order[at] = order[at - 1];
                    at -= 1;
                }
                order[at] = cell as u8;
                count += 1;
            }
        }
        for &cell in &order[..count] {
            let (limit, boxed) = (hunt.limit(), squares.as_flattened()[usize::from(cell)]);
            if boxed > square(limit + deviation) {
                hunt.drop(|| boxed.sqrt() - deviation);
                continue;
            }
            let (r, c) = (usize::from(cell) / BLOCK, usize::from(cell) % BLOCK);
            let quad = corners.quad(r, c);
            // The half-space through the nearest point found so far.
            let half_space = quad.map(|corner| -corner.dot(hunt.direction())).into_iter().fold(f64::INFINITY, lesser);
            if half_space - deviation > limit {
                hunt.drop(|| half_space - deviation);
                continue;
            }
            let (distance, start) = bilinear(&quad);
            if distance - deviation > limit {
                hunt.drop(|| distance - deviation);
                continue;
            }
            self.cell(top + r, left + c, start, hunt, scratch);
        }
    }

    /// Looks for a nearer point in a cell.
    fn cell<const N: usize>(&self, i: usize, j: usize, start: DVec2, hunt: &mut Hunt, scratch: &mut Scratch<N>)
    where
        C: Cells<N>,
    {
        let limit = hunt.limit();
        let patch = self.cells.patch(i, j);
        if patch.half_space(hunt.query, hunt.direction()) > limit {
            hunt.drop(|| limit);
            return;
        }
        match nearest(&patch, hunt.query, start, limit, hunt.tolerance, scratch, &mut hunt.work) {
            Some(found) => hunt.add(Answer { found, sheet: self.sheet, cell: [i as u32, j as u32] }),
            None => hunt.drop(|| limit),
        }
    }
}

/// The square of a limit; below 0 for less than none.
#[inline(always)]
fn square(limit: f64) -> f64 {
    if limit < 0.0 { limit } else { limit * limit }
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
        for r in 0..=BLOCK {
            for c in 0..=BLOCK {
                let corner = cells.corner(top + r.min(rows), left + c.min(columns)) - query;
                (axes[0][r][c], axes[1][r][c], axes[2][r][c]) = (corner.x, corner.y, corner.z);
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

    /// The squares of the distances of the boxes of the cells' corners.
    #[inline(always)]
    fn box_squares(&self) -> [[f64; BLOCK]; BLOCK] {
        let mut squares = [[0.0; BLOCK]; BLOCK];
        for axis in &self.axes {
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
                    let outside = greater(greater(low, -high), 0.0);
                    squares[r][c] += outside * outside;
                }
            }
        }
        squares
    }
}

/// A lower bound of the distance of the origin from the bilinear patch through four corners (00, 01, 10, 11), and parameters near the
/// nearest point.
///
/// With s and t from the middle, the patch is m + s u + t v + s t w: a quarter of |w| at most from the parallelogram without the twist w, whose
/// nearest point is found.
fn bilinear(corners: &[DVec3; 4]) -> (f64, DVec2) {
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
    (square.sqrt() - 0.25 * twist.length(), DVec2::new(s + 0.5, t + 0.5))
}

/// A block of any level, with a lower bound of its distance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub(super) bound: f64,
    pub(super) level: usize,
    pub(super) row: usize,
    pub(super) column: usize,
}

impl Block {
    /// The whole sheet.
    pub(super) fn root(index: &Pyramid) -> Block {
        Block { bound: 0.0, level: index.levels().len(), row: 0, column: 0 }
    }

    /// The blocks that it consists of, with their bounds.
    pub(super) fn children(&self, index: &Pyramid, query: DVec3) -> [Option<Block>; 4] {
        let (level, local) = (&index.levels()[self.level - 1], query - index.origin());
        let distances = level.group(self.row, self.column).distances_squared(local);
        std::array::from_fn(|child| {
            let (row, column) = (2 * self.row + child / 2, 2 * self.column + child % 2);
            let boxed = distances[child];
            let exists = boxed < f64::INFINITY;
            exists.then(|| {
                let oriented = level.oriented(row, column).map_or(0.0, |oriented| oriented.distance_squared(local));
                Block { bound: boxed.max(oriented).sqrt(), level: self.level - 1, row, column }
            })
        })
    }

    /// The cells of a block of the lowest level.
    pub(super) fn cells<const N: usize, C: Cells<N>>(
        &self,
        cells: &C,
    ) -> impl Iterator<Item = (usize, usize)> + use<N, C> {
        let [rows, columns] = cells.counts();
        let (top, left) = (self.row * BLOCK, self.column * BLOCK);
        let (bottom, right) = (rows.min(top + BLOCK), columns.min(left + BLOCK));
        (top..bottom).flat_map(move |i| (left..right).map(move |j| (i, j)))
    }
}
