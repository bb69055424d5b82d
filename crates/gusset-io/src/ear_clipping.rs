//! Ear clipping of a polygon in the plane.
//!
//! An ear is a convex corner whose triangle with its neighbours holds no other part of the polygon. Each step cuts one ear off, so that
//! `n` corners always give `n - 2` triangles. Signs are exact (Shewchuk's predicates). Corners at equal positions are allowed, and so
//! are edges that are passed twice: a keyhole. Where no ear is left, because the polygon crosses itself or has no area, weaker rules
//! choose a corner.
//!
//! Only corners that are not convex can lie in an ear; a grid finds them. Tests are limited to a number for each corner. If they run
//! out, the rest of the polygon is cut without tests.

use crate::error::ReadError;
use gusset_base::alloc;
use robust::{Coord, orient2d};

/// Tests of a corner against a corner or a row of cells, for each corner of the polygon, before the rest is cut without tests.
const MAX_TESTS_PER_CORNER: u64 = 1000;
/// Polygons of fewer corners have one cell.
const MIN_GRID_CORNERS: usize = 64;

/// Rules for the next corner, from the one that keeps triangles apart to the one that any corner fulfils.
#[derive(Clone, Copy, PartialEq)]
enum Rule {
    /// The corner is convex, and no other part of the polygon is in its triangle or on the triangle's border.
    Apart,
    /// The corner is convex, and nothing is inside its triangle.
    Touching,
    /// The corner is on a line with its neighbours.
    Flat,
    /// The corner is convex.
    Convex,
    /// Any corner.
    Any,
}

impl Rule {
    fn weakened(self) -> Self {
        match self {
            Self::Apart => Self::Touching,
            Self::Touching => Self::Flat,
            Self::Flat => Self::Convex,
            Self::Convex | Self::Any => Self::Any,
        }
    }
}

/// Splits an anticlockwise polygon of at least three corners into triangles, which it appends. Takes time linear in the corners, times
/// at most [`MAX_TESTS_PER_CORNER`].
pub(crate) fn clip_ears(points: &[[f64; 2]], triangles: &mut Vec<[u32; 3]>) -> Result<(), ReadError> {
    alloc::reserve(triangles, points.len())?;
    let mut clipper = EarClipper::new(points)?;
    let mut remaining = points.len();
    let (mut corner, mut passed, mut rule) = (0, 0, Rule::Apart);
    while remaining > 3 {
        if clipper.tests_left == 0 {
            rule = Rule::Any;
        }
        if clipper.fulfils(corner, rule) {
            triangles.push(clipper.triangle(corner).map(|place| place as u32));
            corner = clipper.cut_off(corner);
            (remaining, passed, rule) = (remaining - 1, 0, Rule::Apart);
        } else {
            corner = clipper.next[corner] as usize;
            passed += 1;
            if passed == remaining {
                (passed, rule) = (0, rule.weakened());
            }
        }
    }
    triangles.push(clipper.triangle(corner).map(|place| place as u32));
    Ok(())
}

/// Remaining corners as a ring, and the reflex corners among them.
struct EarClipper<'a> {
    points: &'a [[f64; 2]],
    previous: Vec<u32>,
    next: Vec<u32>,
    is_reflex: Vec<bool>,
    grid: Grid,
    tests_left: u64,
}

impl<'a> EarClipper<'a> {
    fn new(points: &'a [[f64; 2]]) -> Result<Self, ReadError> {
        let count = points.len() as u32;
        let mut clipper = Self {
            points,
            previous: alloc::collect((0..count).map(|corner| if corner == 0 { count - 1 } else { corner - 1 }))?,
            next: alloc::collect((0..count).map(|corner| if corner + 1 == count { 0 } else { corner + 1 }))?,
            is_reflex: alloc::filled(false, points.len())?,
            grid: Grid::default(),
            tests_left: MAX_TESTS_PER_CORNER * u64::from(count),
        };
        for corner in 0..points.len() {
            clipper.is_reflex[corner] = !clipper.is_convex(corner);
        }
        clipper.grid = Grid::new(points, &clipper.is_reflex)?;
        Ok(clipper)
    }

    /// Returns a corner between its neighbours.
    fn triangle(&self, corner: usize) -> [usize; 3] {
        [self.previous[corner] as usize, corner, self.next[corner] as usize]
    }

    fn turn(&self, a: usize, b: usize, c: usize) -> f64 {
        let [a, b, c] = [a, b, c].map(|corner| Coord { x: self.points[corner][0], y: self.points[corner][1] });
        orient2d(a, b, c)
    }

    fn is_convex(&self, corner: usize) -> bool {
        let [a, b, c] = self.triangle(corner);
        self.turn(a, b, c) > 0.0
    }

    fn fulfils(&mut self, corner: usize, rule: Rule) -> bool {
        self.tests_left = self.tests_left.saturating_sub(1);
        match rule {
            Rule::Apart | Rule::Touching => self.is_convex(corner) && !self.is_blocked(corner, rule == Rule::Apart),
            Rule::Flat => {
                let [a, b, c] = self.triangle(corner);
                self.turn(a, b, c) == 0.0
            }
            Rule::Convex => self.is_convex(corner),
            Rule::Any => true,
        }
    }

    /// Returns whether a part of the polygon is in the triangle of a convex corner, or on its border if `is_closed`.
    fn is_blocked(&mut self, corner: usize, is_closed: bool) -> bool {
        let triangle = self.triangle(corner);
        let corners = triangle.map(|place| self.points[place]);
        let low = [0, 1].map(|axis| corners[0][axis].min(corners[1][axis]).min(corners[2][axis]));
        let high = [0, 1].map(|axis| corners[0][axis].max(corners[1][axis]).max(corners[2][axis]));
        for row in self.grid.rows_between(low[1], high[1]) {
            let cells = self.grid.cells_in_row(row, &corners);
            // The corners of neighbouring cells follow each other.
            let range = self.grid.starts[cells.start] as usize..self.grid.starts[cells.end] as usize;
            self.tests_left = self.tests_left.saturating_sub(1 + range.len() as u64);
            for place in range {
                let other = self.grid.corners[place] as usize;
                let point = self.points[other];
                if self.is_reflex[other]
                    && (low[0] <= point[0] && point[0] <= high[0] && low[1] <= point[1] && point[1] <= high[1])
                    && self.blocks(other, triangle, is_closed)
                {
                    return true;
                }
            }
        }
        false
    }

    fn blocks(&self, other: usize, [a, tip, b]: [usize; 3], is_closed: bool) -> bool {
        let point = self.points[other];
        if point == self.points[a] || point == self.points[b] {
            // An edge from there into the triangle ends at a corner inside.
            return false;
        }
        if point == self.points[tip] {
            // The edges from there may cross the triangle without a corner inside.
            return other != tip
                && [self.previous[other], self.next[other]]
                    .iter()
                    .any(|&end| self.turn(a, tip, end as usize) > 0.0 && self.turn(tip, b, end as usize) > 0.0);
        }
        let turns = [self.turn(a, tip, other), self.turn(tip, b, other), self.turn(b, a, other)];
        if is_closed { turns.iter().all(|&turn| turn >= 0.0) } else { turns.iter().all(|&turn| turn > 0.0) }
    }

    /// Takes a corner out of the ring. Returns the corner after the next, so that triangles do not gather at one corner.
    fn cut_off(&mut self, corner: usize) -> usize {
        let [before, _, after] = self.triangle(corner);
        self.next[before] = after as u32;
        self.previous[after] = before as u32;
        self.is_reflex[corner] = false;
        for neighbour in [before, after] {
            if self.is_reflex[neighbour] && self.is_convex(neighbour) {
                self.is_reflex[neighbour] = false;
            }
        }
        self.next[after] as usize
    }
}

/// Cells of the plane with the corners that were not convex at first.
#[derive(Default)]
struct Grid {
    low: [f64; 2],
    cells_per_unit: [f64; 2],
    /// Number of rows, and of columns.
    side: usize,
    /// First place of each cell in `corners`, and the end.
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl Grid {
    fn new(points: &[[f64; 2]], is_reflex: &[bool]) -> Result<Self, ReadError> {
        let listed = alloc::gather((0..points.len() as u32).filter(|&corner| is_reflex[corner as usize]))?;
        let side =
            if points.len() < MIN_GRID_CORNERS { 1 } else { (listed.len() as f64).sqrt().ceil().max(1.0) as usize };
        let low = [0, 1].map(|axis| points.iter().fold(f64::INFINITY, |least, point| least.min(point[axis])));
        let high = [0, 1].map(|axis| points.iter().fold(f64::NEG_INFINITY, |most, point| most.max(point[axis])));
        let cells_per_unit = [0, 1].map(|axis| {
            let scale = side as f64 / (high[axis] - low[axis]);
            if scale.is_finite() && scale > 0.0 { scale } else { 0.0 }
        });
        let starts = alloc::filled(0, side * side + 1)?;
        let mut grid = Self { low, cells_per_unit, side, starts, corners: alloc::filled(0, listed.len())? };
        let cells = alloc::collect(listed.iter().map(|&corner| grid.cell(points[corner as usize])))?;
        for &cell in &cells {
            grid.starts[cell + 1] += 1;
        }
        for cell in 0..side * side {
            grid.starts[cell + 1] += grid.starts[cell];
        }
        let mut ends = alloc::copied(&grid.starts)?;
        for (&corner, &cell) in listed.iter().zip(&cells) {
            grid.corners[ends[cell] as usize] = corner;
            ends[cell] += 1;
        }
        Ok(grid)
    }

    /// Returns a coordinate in cells.
    fn scaled(&self, axis: usize, coordinate: f64) -> f64 {
        (coordinate - self.low[axis]) * self.cells_per_unit[axis]
    }

    /// Returns the column or row of a scaled coordinate. Conversion from NaN gives 0.
    fn place(&self, scaled: f64) -> usize {
        (scaled as usize).min(self.side - 1)
    }

    fn cell(&self, point: [f64; 2]) -> usize {
        self.place(self.scaled(1, point[1])) * self.side + self.place(self.scaled(0, point[0]))
    }

    fn rows_between(&self, low: f64, high: f64) -> std::ops::RangeInclusive<usize> {
        self.place(self.scaled(1, low))..=self.place(self.scaled(1, high))
    }

    /// Returns the cells of a row that a triangle meets, and at times one more at either end.
    fn cells_in_row(&self, row: usize, triangle: &[[f64; 2]; 3]) -> std::ops::Range<usize> {
        const MARGIN: f64 = 1e-6;
        let (bottom, top) = (row as f64 - MARGIN, row as f64 + 1.0 + MARGIN);
        let scaled = triangle.map(|point| [self.scaled(0, point[0]), self.scaled(1, point[1])]);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for (a, b) in [(scaled[0], scaled[1]), (scaled[1], scaled[2]), (scaled[2], scaled[0])] {
            let (a, b) = if a[1] <= b[1] { (a, b) } else { (b, a) };
            if b[1] < bottom || a[1] > top {
                continue;
            }
            let at =
                |height: f64| if b[1] > a[1] { a[0] + (b[0] - a[0]) * ((height - a[1]) / (b[1] - a[1])) } else { a[0] };
            let ends = if b[1] > a[1] { [at(a[1].max(bottom)), at(b[1].min(top))] } else { [a[0], b[0]] };
            low = low.min(ends[0]).min(ends[1]);
            high = high.max(ends[0]).max(ends[1]);
        }
        let (first, last) = (self.place(low - MARGIN), self.place(high + MARGIN));
        let start = row * self.side;
        start + first.min(last)..start + last + 1
    }
}
