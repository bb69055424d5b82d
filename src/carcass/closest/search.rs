//! The search of the index for the nearest point: near children first, and whatever cannot be nearer is dropped.

use super::cell::{Found, Scratch, nearest};
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::index::Pyramid;
use glam::{DVec2, DVec3};

/// A block to be looked at: a lower bound of the square of its distance, and where it is.
#[derive(Debug, Clone, Copy, Default)]
struct Entry {
    bound: f64,
    level: u32,
    row: u32,
    column: u32,
}

/// The most entries that wait: three for each level of a pyramid over 2^31 nodes, which has at most 30 levels.
const WAITING: usize = 3 * 30 + 4;

/// The nearest point of a sheet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Nearest {
    pub(crate) found: Found,
    pub(crate) cell: [usize; 2],
    /// No point of the sheet is nearer than this.
    pub(crate) bound: f64,
}

/// The nearest point of a sheet to `query` that is no farther than `limit`.
///
/// Of several at the same distance, the first cell's: what cannot be nearer than what was found is dropped only if it is farther.
pub(crate) fn search<const N: usize>(
    cells: &impl Cells<N>,
    index: &Pyramid,
    query: DVec3,
    limit: f64,
    tolerance: f64,
    scratch: &mut Scratch<N>,
) -> Option<Nearest> {
    let local = query - index.origin();
    let levels = index.levels();
    let mut stack = [Entry::default(); WAITING];
    let mut count = 1;
    stack[0].level = levels.len() as u32;
    let mut best: Option<Nearest> = None;
    let (mut reach, mut bound) = (limit, f64::INFINITY);
    while count > 0 {
        count -= 1;
        let entry = stack[count];
        if entry.bound > reach * reach {
            continue;
        }
        if entry.level == 0 {
            let leaf = Leaf { cells, index, query, row: entry.row as usize, column: entry.column as usize };
            leaf.search(&mut reach, &mut best, &mut bound, tolerance, scratch);
            continue;
        }
        let level = &levels[entry.level as usize - 1];
        let (row, column) = (entry.row as usize, entry.column as usize);
        let distances = level.group(row, column).distances_squared(local);
        let first = count;
        for (child, &box_distance) in distances.iter().enumerate() {
            if box_distance > reach * reach || box_distance == f64::INFINITY {
                continue;
            }
            let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
            let oriented = level.oriented(row, column).map_or(0.0, |oriented| oriented.distance_squared(local));
            let distance = box_distance.max(oriented);
            if distance > reach * reach {
                continue;
            }
            let entry = Entry { bound: distance, level: entry.level - 1, row: row as u32, column: column as u32 };
            // Sorted as they come: the nearest is taken first, being last.
            let mut at = count;
            while at > first && stack[at - 1].bound < distance {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = entry;
            count += 1;
        }
    }
    best.map(|best| Nearest { bound: bound.min(best.found.distance), ..best })
}

/// A block whose cells are looked at.
struct Leaf<'a, C> {
    cells: &'a C,
    index: &'a Pyramid,
    query: DVec3,
    row: usize,
    column: usize,
}

/// A cell that may have the nearest point.
#[derive(Clone, Copy, Default)]
struct Candidate {
    /// No point of the cell is nearer.
    bound: f64,
    start: DVec2,
    i: usize,
    j: usize,
}

impl<C> Leaf<'_, C> {
    fn search<const N: usize>(
        &self,
        reach: &mut f64,
        best: &mut Option<Nearest>,
        bound: &mut f64,
        tolerance: f64,
        scratch: &mut Scratch<N>,
    ) where
        C: Cells<N>,
    {
        let [rows, columns] = self.cells.counts();
        let (first, last) = (self.row * BLOCK, rows.min((self.row + 1) * BLOCK));
        let (left, right) = (self.column * BLOCK, columns.min((self.column + 1) * BLOCK));
        let deviation = self.index.deviation(self.row, self.column);
        // Corners are points of the surface: what is farther than the nearest of them is out.
        let mut corners = [[DVec3::ZERO; BLOCK + 1]; BLOCK + 1];
        let mut least = f64::INFINITY;
        for i in first..=last {
            for j in left..=right {
                let corner = self.cells.corner(i, j) - self.query;
                corners[i - first][j - left] = corner;
                least = least.min(corner.length_squared());
            }
        }
        // The corner itself is found with its cell, and its distance computed there: with some play for rounding.
        let mut limit = reach.min(least.sqrt() * (1.0 + 1e-12));
        let mut candidates = [Candidate::default(); BLOCK * BLOCK];
        let mut count = 0;
        for i in first..last {
            for j in left..right {
                let (r, c) = (i - first, j - left);
                let quad = [corners[r][c], corners[r][c + 1], corners[r + 1][c], corners[r + 1][c + 1]];
                let (distance, start) = bilinear(&quad);
                let bound = distance - deviation;
                if bound <= limit {
                    let mut at = count;
                    while at > 0 && candidates[at - 1].bound > bound {
                        candidates[at] = candidates[at - 1];
                        at -= 1;
                    }
                    candidates[at] = Candidate { bound, start, i, j };
                    count += 1;
                }
            }
        }
        for candidate in &candidates[..count] {
            if candidate.bound > limit {
                break;
            }
            let patch = self.cells.patch(candidate.i, candidate.j);
            let found = nearest(&patch, self.query, candidate.start, limit, tolerance, scratch);
            *bound = bound.min(found.bound);
            if found.distance > limit {
                continue;
            }
            let cell = [candidate.i, candidate.j];
            let nearer = |best: &Nearest| (found.distance, cell) < (best.found.distance, best.cell);
            if best.as_ref().is_none_or(nearer) {
                *best = Some(Nearest { found, cell, bound: 0.0 });
                *reach = reach.min(found.distance);
                limit = limit.min(found.distance);
            }
        }
    }
}

/// A lower bound of the distance of the origin from the bilinear patch through four corners (00, 01, 10, 11), and parameters near the
/// nearest point: from its two triangles, from which it is a quarter of its twist away.
fn bilinear(corners: &[DVec3; 4]) -> (f64, DVec2) {
    let [p00, p01, p10, p11] = *corners;
    let (first, at_first) = triangle(p00, p10 - p00, p01 - p00);
    let (second, at_second) = triangle(p11, p01 - p11, p10 - p11);
    let twist = 0.25 * (p00 + p11 - p10 - p01).length();
    if first <= second { (first.sqrt() - twist, at_first) } else { (second.sqrt() - twist, DVec2::ONE - at_second) }
}

/// The square of the distance of the origin from the triangle a, a + u, a + v, and the parameters of the nearest point.
fn triangle(a: DVec3, u: DVec3, v: DVec3) -> (f64, DVec2) {
    let (uu, uv, vv) = (u.length_squared(), u.dot(v), v.length_squared());
    let (au, av) = (-a.dot(u), -a.dot(v));
    let area = uu * vv - uv * uv;
    let inner = DVec2::new(au * vv - av * uv, av * uu - au * uv);
    let ratio = |above: f64, below: f64| if below > 0.0 { (above / below).clamp(0.0, 1.0) } else { 0.0 };
    let place = if area > 0.0 && inner.x >= 0.0 && inner.y >= 0.0 && inner.x + inner.y <= area {
        inner / area
    } else {
        // The nearest point of the three sides.
        let along = ratio(uu - uv + av - au, uu - 2.0 * uv + vv);
        let sides = [DVec2::new(ratio(au, uu), 0.0), DVec2::new(0.0, ratio(av, vv)), DVec2::new(1.0 - along, along)];
        let distance = |place: DVec2| (a + place.x * u + place.y * v).length_squared();
        let nearer = |x: DVec2, y: DVec2| if distance(y) < distance(x) { y } else { x };
        nearer(nearer(sides[0], sides[1]), sides[2])
    };
    ((a + place.x * u + place.y * v).length_squared(), place)
}
