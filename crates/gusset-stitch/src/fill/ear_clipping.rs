//! Ear clipping of long loops.
//!
//! Dynamic programming takes cubic time, so long planar loops are clipped instead. An ear is a
//! triangle of three consecutive vertices. In projection along the loop's mean normal it must be
//! convex and contain no other vertex; every simple polygon has two ears (G. Meisters, *Polygons
//! have ears*, 1975). The shortest ear is cut off first. If the projected loop intersects itself
//! and lacks ears, the shortest triangle of consecutive vertices is cut off. A grid over the
//! projected vertices keeps each test local: about O(n log n) for loops that fill their box evenly.

use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// Largest number of grid cells along each axis.
const MAX_GRID_CELLS: f64 = 1024.0;
/// Largest distance of planar points from their plane, relative to the size of the point set.
const MAX_PLANAR_DEVIATION: f64 = 1e-6;
/// Ears between two progress reports.
const EARS_PER_REPORT: usize = 1 << 10;

/// Triangulates the loop through `points`. Returns `None` if every remaining ear has a `taken`
/// edge.
///
/// O(n log n) for n points, plus the vertices near each ear; linear memory, about 150 bytes per
/// point.
pub(crate) fn clip_ears(
    points: &[DVec3],
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = points.len();
    let mut ring = RemainingLoop::new(points)?;
    let mut triangles = alloc::with_capacity(n - 2)?;
    // Shortest ear first. Outdated entries are skipped when they are popped.
    let mut ears = BinaryHeap::from(alloc::with_capacity(4 * n)?);
    for strict in [true, false] {
        ears.clear();
        ears.extend((0..n as u32).filter(|&v| ring.turns_left(v)).map(|v| Reverse(ring.ear_with_size(points, v))));
        while let (Some(Reverse((_, [a, b, c]))), true) = (ears.pop(), triangles.len() + 3 < n) {
            let stale = !ring.turns_left(b) || ring.previous[b as usize] != a || ring.next[b as usize] != c;
            if stale || taken(a, c) || strict && !ring.is_free_of_reflex_vertices([a, b, c]) {
                continue;
            }
            job.step_every(EARS_PER_REPORT, triangles.len(), n, "triangulating holes")?;
            triangles.push([a, b, c]);
            ring.remove_vertex(b);
            ears.extend([a, c].map(|v| Reverse(ring.ear_with_size(points, v))));
        }
    }
    let Some(v) = (0..n as u32).find(|&v| ring.turns_left(v)) else {
        return Ok(None);
    };
    triangles.push([ring.previous[v as usize], v, ring.next[v as usize]]);
    Ok((triangles.len() == n - 2).then_some(triangles))
}

/// The remaining loop.
struct RemainingLoop {
    /// The loop projected along its mean normal, counter-clockwise.
    flat: Vec<DVec2>,
    previous: Vec<u32>,
    next: Vec<u32>,
    /// True for vertices that are not convex. Only these can lie inside an ear.
    reflex: Vec<bool>,
    grid: ReflexGrid,
}

impl RemainingLoop {
    fn new(points: &[DVec3]) -> Result<RemainingLoop> {
        let n = points.len();
        let flat = project_to_plane(points)?;
        let previous = alloc::collect((0..n).map(|i| ((i + n - 1) % n) as u32))?;
        let next = alloc::collect((0..n).map(|i| ((i + 1) % n) as u32))?;
        let reflex =
            alloc::collect((0..n).map(|i| signed_turn(flat[(i + n - 1) % n], flat[i], flat[(i + 1) % n]) <= 0.0))?;
        let grid = ReflexGrid::new(&flat, &reflex)?;
        Ok(RemainingLoop { flat, previous, next, reflex, grid })
    }

    fn turns_left(&self, v: u32) -> bool {
        self.next[v as usize] != v
    }

    /// Returns the ear at `v` after the bits of its squared length, which sort like the lengths.
    fn ear_with_size(&self, points: &[DVec3], v: u32) -> (u64, [u32; 3]) {
        let (a, c) = (self.previous[v as usize], self.next[v as usize]);
        (points[a as usize].distance_squared(points[c as usize]).to_bits(), [a, v, c])
    }

    fn is_free_of_reflex_vertices(&self, ear: [u32; 3]) -> bool {
        let [a, b, c] = ear.map(|v| self.flat[v as usize]);
        if self.reflex[ear[1] as usize] {
            return false;
        }
        // Exclude the corners: the polygon passes the ends of a bridge more than once.
        let at_corner = |p: DVec2| p == a || p == b || p == c;
        let holds = |p: DVec2| {
            signed_turn(a, b, p) >= 0.0 && signed_turn(b, c, p) >= 0.0 && signed_turn(c, a, p) >= 0.0 && !at_corner(p)
        };
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let blocks = |&v: &u32| {
            self.reflex[v as usize] && self.turns_left(v) && !ear.contains(&v) && holds(self.flat[v as usize])
        };
        !self.grid.vertex_ranges_of_rows(low, high).any(|row| self.grid.vertices.items()[row].iter().any(blocks))
    }

    fn remove_vertex(&mut self, v: u32) {
        let (a, c) = (self.previous[v as usize], self.next[v as usize]);
        self.next[a as usize] = c;
        self.previous[c as usize] = a;
        self.next[v as usize] = v;
        for v in [a, c].map(|v| v as usize) {
            let (p, q) = (self.previous[v] as usize, self.next[v] as usize);
            self.reflex[v] = signed_turn(self.flat[p], self.flat[v], self.flat[q]) <= 0.0;
        }
    }
}

/// Returns a positive value if the path from `a` through `b` to `c` turns left.
fn signed_turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Returns the unit normal of a loop by Newell's formula; the z axis for a degenerate loop.
pub(super) fn mean_normal(points: &[DVec3]) -> DVec3 {
    let next = points.iter().cycle().skip(1);
    let normal: DVec3 = points.iter().zip(next).map(|(&p, &q)| (p - points[0]).cross(q - points[0])).sum();
    normal.try_normalize().unwrap_or(DVec3::Z)
}

/// Returns true if all points lie in the plane through the first point with this normal, up to
/// single-precision round-off.
pub(super) fn is_planar(points: &[DVec3], normal: DVec3) -> bool {
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    points.iter().all(|&p| (p - points[0]).dot(normal).abs() <= MAX_PLANAR_DEVIATION * size)
}

/// Projects the loop along its mean normal, counter-clockwise.
fn project_to_plane(points: &[DVec3]) -> Result<Vec<DVec2>> {
    let (origin, normal) = (points[0], mean_normal(points));
    let x = normal.any_orthonormal_vector();
    let y = normal.cross(x);
    alloc::collect(points.iter().map(|&p| DVec2::new((p - origin).dot(x), (p - origin).dot(y))))
}

/// The initial reflex vertices of the loop in square cells, row by row.
struct ReflexGrid {
    low: DVec2,
    cell: f64,
    columns: usize,
    vertices: Buckets<u32>,
}

impl ReflexGrid {
    fn new(flat: &[DVec2], reflex: &[bool]) -> Result<ReflexGrid> {
        let low = flat.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let size = flat.iter().fold(DVec2::ZERO, |size, &p| size.max(p - low));
        let cells = (flat.len() as f64).sqrt().ceil().min(MAX_GRID_CELLS);
        let cell = (size.max_element() / cells).max(f64::MIN_POSITIVE);
        let columns = (size.x / cell) as usize + 1;
        let rows = (size.y / cell) as usize + 1;
        let mut grid = ReflexGrid { low, cell, columns, vertices: Buckets::default() };
        let inside = (0..flat.len()).filter(|&v| reflex[v]).map(|v| {
            let (column, row) = grid.cell_of(flat[v]);
            (row * columns + column, v as u32)
        });
        grid.vertices = Buckets::new(rows * columns, 0, inside)?;
        Ok(grid)
    }

    fn cell_of(&self, p: DVec2) -> (usize, usize) {
        let cell = (p - self.low) / self.cell;
        ((cell.x as usize).min(self.columns - 1), cell.y as usize)
    }

    /// For each row of cells that the box touches, returns the range of its vertices.
    fn vertex_ranges_of_rows(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = Range<usize>> + '_ {
        let ((left, bottom), (right, top)) = (self.cell_of(low), self.cell_of(high));
        (bottom..=top).map(move |row| {
            let at = |column: usize| self.vertices.range(row * self.columns + column);
            at(left).start..at(right).end
        })
    }
}
