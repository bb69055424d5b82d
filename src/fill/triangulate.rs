//! The triangulation of least weight of a loop, without new vertices.
//!
//! Source: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995), and P. Liepa (2003). Dynamic
//! programming over the chords (i, k): the best triangulation of the part of the loop from i to k has a triangle (i, m, k) on
//! its chord and the best triangulations of both sides of it.

use super::Weight;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;
use std::cmp::Ordering;

/// A loop to be triangulated: triangles run its edges from each point to the next.
pub(super) struct Polygon<'a> {
    pub(super) points: &'a [DVec3],
    /// The unit normal of the face across the edge from each point to the next; 0 if it is not known.
    pub(super) across: &'a [DVec3],
}

/// What a triangulation costs; less is better, item by item.
#[derive(Clone, Copy)]
struct Cost {
    /// Triangles without area.
    degenerate: u32,
    /// The largest bend across an edge, 1 - cosine in steps of 2^-20, so that rounding does not decide before the area.
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
const STEPS: f64 = (1 << 20) as f64;

const NOTHING: Cost = Cost { degenerate: 0, bend: 0, area: 0.0, sides: 0.0 };

impl Cost {
    fn and(self, other: Cost) -> Cost {
        Cost {
            degenerate: self.degenerate + other.degenerate,
            bend: self.bend.max(other.bend),
            area: self.area + other.area,
            sides: self.sides + other.sides,
        }
    }

    /// True if whatever has `parts` costs more.
    fn is_passed_by(&self, parts: &Cost, rounding: f64) -> bool {
        match (parts.degenerate, parts.bend).cmp(&(self.degenerate, self.bend)) {
            Ordering::Less => false,
            Ordering::Equal => parts.area > self.area + rounding,
            Ordering::Greater => true,
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

/// The triangles (i, m, k), i < m < k, of the triangulation of least weight in which no chord is `taken`; `None` if there is none.
///
/// By area it is the least there is. Bends are treated as Liepa treats them: each part of the loop takes its own best triangulation, seen
/// from inside, which need not be the best when the triangle beyond its chord is known.
///
/// O(n^3) time, less what is passed over; 64 bytes for each of n (n - 1) / 2 chords.
pub(super) fn least_weight(
    polygon: &Polygon<'_>,
    weight: Weight,
    taken: impl Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = polygon.points.len();
    let start = polygon.points[0];
    let size = polygon.points.iter().map(|p| p.distance_squared(start)).fold(0.0, f64::max);
    let mut table = Table { polygon, weight, rounding: ROUNDING * size, cells: alloc::filled(None, n * (n - 1) / 2)? };
    for i in 0..n - 1 {
        table.cells[at(i, i + 1)] = Some(Cell { cost: NOTHING, apex: 0, normal: polygon.across[i] });
    }
    let (mut done, all) = (0.0, (n as f64).powi(3) / 6.0);
    for span in 2..n {
        job.step(done / all, "triangulating holes")?;
        done += ((n - span) * span) as f64;
        for i in 0..n - span {
            let k = i + span;
            if span == n - 1 || !taken(i, k) {
                table.cells[at(i, k)] = table.best(i, k);
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
}

impl Table<'_> {
    fn best(&self, i: usize, k: usize) -> Option<Cell> {
        let mut best: Option<Cell> = None;
        for m in i + 1..k {
            let (Some(left), Some(right)) = (&self.cells[at(i, m)], &self.cells[at(m, k)]) else {
                continue;
            };
            let parts = left.cost.and(right.cost);
            // The triangle itself can only add to it.
            if best.as_ref().is_some_and(|best| best.cost.is_passed_by(&parts, self.rounding)) {
                continue;
            }
            let [p, q, r] = [i, m, k].map(|place| self.polygon.points[place]);
            let cross = (q - p).cross(r - p);
            let double_area = cross.length();
            let sides = p.distance_squared(q) + q.distance_squared(r) + r.distance_squared(p);
            let flat = double_area <= FLAT * sides;
            let normal = if flat { DVec3::ZERO } else { cross / double_area };
            let at_root = k - i + 1 == self.polygon.points.len();
            let beyond = [left.normal, right.normal, if at_root { self.polygon.across[k] } else { DVec3::ZERO }];
            let bends = beyond.map(|other| bend_between(normal, other));
            let mut own = Cost { degenerate: u32::from(flat), bend: 0, area: 0.5 * double_area, sides };
            match self.weight {
                Weight::Area => {}
                Weight::BendThenArea => own.bend = (STEPS * bends.into_iter().fold(0.0, f64::max)).round() as u32,
                Weight::AreaAndBend => {
                    let edges = [p.distance_squared(q), q.distance_squared(r), r.distance_squared(p)];
                    own.area += (0..3).map(|e| bends[e] * edges[e]).sum::<f64>();
                }
            }
            let cost = parts.and(own);
            if best.as_ref().is_none_or(|best| cost.is_less(&best.cost, self.rounding)) {
                best = Some(Cell { cost, apex: m as u32, normal });
            }
        }
        best
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
