//! Minimum-weight triangulation of a loop without new vertices.
//!
//! Source: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995), and
//! P. Liepa, *Filling holes in meshes* (2003). Dynamic programming over the chords (i, k): the
//! best triangulation of the part of the loop from i to k consists of a triangle (i, m, k) and
//! the best triangulations of both sides of it. O(n^3) time and O(n^2) memory for n vertices.

use super::Weight;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;
use std::cmp::Ordering;
use std::ops::Range;

/// A loop to be triangulated: triangles run its edges from each point to the next.
pub(super) struct Polygon<'a> {
    pub(super) points: &'a [DVec3],
    /// The unit normal of the face across the edge from each point to the next; 0 if it is not
    /// known.
    pub(super) across: &'a [DVec3],
}

/// What a triangulation costs; less is better, item by item.
#[derive(Clone, Copy)]
struct Cost {
    /// Triangles without area.
    degenerate: u32,
    /// The largest bend across an edge, 1 - cosine in steps of 2^-20, so that rounding does not
    /// decide before the area.
    bend: u32,
    /// The area, with what bends add to it.
    area: f64,
    /// The squares of the sides of the triangles: chooses among flat triangulations.
    sides: f64,
}

/// The best triangulation of the part of the loop that a chord cuts off.
#[derive(Clone, Copy)]
struct Cell {
    cost: Cost,
    apex: u32,
    /// The unit normal of the triangle on the chord.
    normal: DVec3,
}

/// Areas that differ by this part of the squared size of the loop are equal.
const ROUNDING: f64 = 1e-14;
/// A triangle whose doubled area is this part of its sides' squares has none.
const FLAT: f64 = 1e-10;
/// Apexes looked at together.
const CHUNK: usize = 64;
const STEPS: f64 = (1 << 20) as f64;

const ZERO_COST: Cost = Cost { degenerate: 0, bend: 0, area: 0.0, sides: 0.0 };

impl Cost {
    fn and(self, other: Cost) -> Cost {
        Cost {
            degenerate: self.degenerate + other.degenerate,
            bend: self.bend.max(other.bend),
            area: self.area + other.area,
            sides: self.sides + other.sides,
        }
    }

    fn is_less(&self, other: &Cost, rounding: f64) -> bool {
        match (self.degenerate, self.bend).cmp(&(other.degenerate, other.bend)) {
            Ordering::Less => true,
            Ordering::Greater => false,
            Ordering::Equal if (self.area - other.area).abs() > rounding => self.area < other.area,
            Ordering::Equal => self.sides < other.sides,
        }
    }
}

/// The triangles (i, m, k), i < m < k, of the triangulation of least weight in which no chord is
/// `taken`; `None` if there is none.
///
/// By area it is the least there is. Bends are treated as Liepa treats them: each part of the loop
/// takes its own best triangulation, seen from inside, which need not be the best when the triangle
/// beyond its chord is known.
///
/// O(n^3) time, less what is passed over; 40 n^2 bytes.
pub(super) fn minimum_weight(
    polygon: &Polygon<'_>,
    weight: Weight,
    taken: impl Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = polygon.points.len();
    let start = polygon.points[0];
    let size = polygon.points.iter().map(|p| p.distance_squared(start)).fold(0.0, f64::max);
    let axis = |k: usize| alloc::collect(polygon.points.iter().map(|p| p[k]));
    let mut table = Table {
        polygon,
        weight,
        rounding: ROUNDING * size,
        cells: alloc::filled(None, n * (n - 1) / 2)?,
        bounds: alloc::filled(f64::INFINITY, n * n)?,
        axes: [axis(0)?, axis(1)?, axis(2)?],
    };
    for i in 0..n - 1 {
        table.enter(i, i + 1, Some(Cell { cost: ZERO_COST, apex: i as u32, normal: polygon.across[i] }));
    }
    let (mut done, all) = (0.0, (n as f64).powi(3) / 6.0);
    for span in 2..n {
        job.step(done / all, "triangulating holes")?;
        done += ((n - span) * span) as f64;
        for i in 0..n - span {
            let k = i + span;
            if span == n - 1 || !taken(i, k) {
                table.enter(i, k, table.best(i, k));
            }
        }
    }
    if table.cells[at(0, n - 1)].is_none() {
        return Ok(None);
    }
    table.triangles().map(Some)
}

fn at(i: usize, k: usize) -> usize {
    k * (k - 1) / 2 + i
}

struct Table<'a> {
    polygon: &'a Polygon<'a>,
    weight: Weight,
    rounding: f64,
    cells: Vec<Option<Cell>>,
    /// What rules out most apexes at a glance, an n x n matrix: at (i, k) and (k, i) the
    /// [`Table::bound`] of chord (i, k).
    bounds: Vec<f64>,
    /// The coordinates of the points, axis by axis.
    axes: [Vec<f64>; 3],
}

impl Table<'_> {
    fn enter(&mut self, i: usize, k: usize, cell: Option<Cell>) {
        let n = self.polygon.points.len();
        let bound = cell.as_ref().map_or(f64::INFINITY, |cell| self.bound(&cell.cost));
        self.bounds[i * n + k] = bound;
        self.bounds[k * n + i] = bound;
        self.cells[at(i, k)] = cell;
    }

    /// A number that orders costs as they are ordered, up to rounding, or, of bends, not against
    /// it.
    fn bound(&self, cost: &Cost) -> f64 {
        let degenerate = f64::from(cost.degenerate);
        match self.weight {
            Weight::BendThenArea => degenerate * 2f64.powi(32) + f64::from(cost.bend),
            Weight::Area | Weight::AreaAndBend => degenerate * self.rounding / ROUNDING * 1e6 + cost.area,
        }
    }

    fn best(&self, i: usize, k: usize) -> Option<Cell> {
        let mut best: Option<Cell> = None;
        let mut limit = f64::INFINITY;
        let mut consider = |m: usize, limit: &mut f64| {
            let Some(cell) = self.cell_with(i, m, k) else {
                return;
            };
            if best.as_ref().is_none_or(|best| cell.cost.is_less(&best.cost, self.rounding)) {
                let bound = self.bound(&cell.cost);
                *limit = bound + self.rounding + 1e-12 * bound;
                best = Some(cell);
            }
        };
        // The apexes of the chords beside are good guesses; most others are then ruled out at a
        // glance.
        for chord in [at(i, k - 1), at(i + 1, k)] {
            if let Some(cell) = &self.cells[chord] {
                consider((cell.apex as usize).clamp(i + 1, k - 1), &mut limit);
            }
        }
        let mut hits = [false; CHUNK];
        for first in (i + 1..k).step_by(CHUNK) {
            let range = first..k.min(first + CHUNK);
            self.discard(i, k, range.clone(), limit, &mut hits);
            range.zip(hits).filter(|&(_, hit)| hit).for_each(|(m, _)| consider(m, &mut limit));
        }
        best
    }

    /// Tells which apexes in `range` may make chord (i, k) cost no more than `limit`. Plain
    /// arithmetic on rows of numbers.
    fn discard(&self, i: usize, k: usize, range: Range<usize>, limit: f64, hits: &mut [bool; CHUNK]) {
        let n = self.polygon.points.len();
        let [left, right] = [i, k].map(|row| &self.bounds[row * n + range.start..row * n + range.end]);
        let parts = left.iter().zip(right);
        if self.weight == Weight::BendThenArea {
            hits.iter_mut().zip(parts).for_each(|(hit, (&left, &right))| *hit = left.max(right) <= limit);
            return;
        }
        let [x, y, z] = self.axes.each_ref().map(|axis| &axis[range.clone()]);
        let (p, r) = (self.polygon.points[i], self.polygon.points[k]);
        let to = r - p;
        for ((hit, (&left, &right)), ((&x, &y), &z)) in hits.iter_mut().zip(parts).zip(x.iter().zip(y).zip(z)) {
            let (x, y, z) = (x - p.x, y - p.y, z - p.z);
            let (a, b, c) = (y * to.z - z * to.y, z * to.x - x * to.z, x * to.y - y * to.x);
            // Left and right and the area of the triangle, without its root.
            let room = 2.0 * (limit - (left + right));
            *hit = room >= 0.0 && a * a + b * b + c * c <= room * room;
        }
    }

    /// Chord (i, k) with the triangle (i, m, k) on it.
    fn cell_with(&self, i: usize, m: usize, k: usize) -> Option<Cell> {
        let (Some(left), Some(right)) = (&self.cells[at(i, m)], &self.cells[at(m, k)]) else {
            return None;
        };
        let [p, q, r] = [i, m, k].map(|place| self.polygon.points[place]);
        let cross = (q - p).cross(r - p);
        let double_area = cross.length();
        let edges = [p.distance_squared(q), q.distance_squared(r), r.distance_squared(p)];
        let sides = edges.iter().sum();
        let flat = double_area <= FLAT * sides;
        let normal = if flat { DVec3::ZERO } else { cross / double_area };
        let at_root = k - i + 1 == self.polygon.points.len();
        let beyond = [left.normal, right.normal, if at_root { self.polygon.across[k] } else { DVec3::ZERO }];
        let bends = beyond.map(|other| bend_between(normal, other));
        let mut own = Cost { degenerate: u32::from(flat), bend: 0, area: 0.5 * double_area, sides };
        match self.weight {
            Weight::Area => {}
            Weight::BendThenArea => own.bend = (STEPS * bends.into_iter().fold(0.0, f64::max)).round() as u32,
            Weight::AreaAndBend => own.area += (0..3).map(|e| bends[e] * edges[e]).sum::<f64>(),
        }
        Some(Cell { cost: left.cost.and(right.cost).and(own), apex: m as u32, normal })
    }

    /// Reads the triangles from the root chord on.
    fn triangles(&self) -> Result<Vec<[u32; 3]>> {
        let n = self.polygon.points.len();
        let mut triangles = alloc::with_capacity(n - 2)?;
        let mut open = alloc::with_capacity(n)?;
        open.push((0, n - 1));
        while let Some((i, k)) = open.pop() {
            if let (true, Some(cell)) = (k - i > 1, &self.cells[at(i, k)]) {
                let m = cell.apex as usize;
                triangles.push([i as u32, cell.apex, k as u32]);
                open.extend([(m, k), (i, m)]);
            }
        }
        Ok(triangles)
    }
}

/// 1 - cosine of the angle between two unit normals; 0 if one is not known.
fn bend_between(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO || b == DVec3::ZERO { 0.0 } else { (1.0 - a.dot(b)).max(0.0) }
}
