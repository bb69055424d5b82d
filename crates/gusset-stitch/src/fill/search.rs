//! Minimum-weight triangulation of a loop without new vertices.
//!
//! Source: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995), and
//! P. Liepa, *Filling holes in meshes* (2003). Dynamic programming over the chords (i, k): the
//! best triangulation of the part of the loop from i to k consists of a triangle (i, m, k) and
//! the best triangulations of both sides of it. O(n^3) time and O(n^2) memory for n vertices with
//! all chords.
//!
//! **Long loops** are solved from coarse to fine: every other vertex first, in the same way, and
//! then all, with chords near those that were best. The band is searched again round its own result
//! until that gains little. O(n) chords, and O(n) triangles on the whole.

use super::Weight;
use super::chords::{All, Chords, Near};
use super::weigh::{Cost, Polygon, Scale};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Loops of at most this many vertices are searched as a whole.
pub(super) const MAX_EXACT: usize = 128;
/// How far from the ends of a coarse chord those of finer ones may lie, in vertices: the first that
/// gives a triangulation, as taken chords may leave none.
const BANDS: [u32; 4] = [2, 4, 8, 16];
/// Longer loops begin with the narrowest band.
const MAX_WIDE: usize = 2_000;
const NARROW: u32 = 1;
/// A loop is searched again while that gains, and at most so often: this many vertices in all.
pub(super) const MAX_SEARCHED: usize = 8_000;
pub(super) const MIN_GAIN: f64 = 1e-3;
/// Chords between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

/// The triangles (i, m, k), i < m < k, of the triangulation of least weight in which no chord is
/// `taken`; `None` if none was found.
///
/// By area it is the least there is, up to [`MAX_EXACT`] vertices. Bends are treated as Liepa treats
/// them: each part of the loop takes its own best triangulation, seen from inside, which need not be
/// the best when the triangle beyond its chord is known.
///
/// O(n^3) time for n <= [`MAX_EXACT`], O(n) for longer loops; 30 n^2 bytes, or about 3 kB a vertex.
pub(super) fn minimum_weight(
    polygon: &Polygon,
    weight: Weight,
    taken: &dyn Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = polygon.points.len();
    if n <= MAX_EXACT {
        let scale = Scale::new(polygon, weight);
        return Ok(best(&scale, &All(n), taken, None, job)?.map(|found| found.triangles));
    }
    let (coarse, kept) = polygon.coarser()?;
    // What is taken does not matter yet.
    let Some(coarse) = minimum_weight(&coarse, weight, &|_, _| false, &job.part(0.0, 0.4))? else {
        return Ok(None);
    };
    let job = job.part(0.4, 1.0);
    let scale = Scale::new(polygon, weight);
    for band in bands(n) {
        let chords = Near::new(n, &coarse, &kept, band)?;
        if let Some(found) = best(&scale, &chords, taken, None, &job.part(0.0, 0.5))? {
            return again(&scale, found, band, taken, &job.part(0.5, 1.0)).map(Some);
        }
    }
    Ok(None)
}

/// The bands to be tried with so many vertices, in this order.
pub(super) fn bands(n: usize) -> impl Iterator<Item = u32> {
    (n > MAX_WIDE).then_some(NARROW).into_iter().chain(BANDS)
}

/// Searches round a result again.
fn again(
    scale: &Scale<'_>,
    mut found: Found,
    band: u32,
    taken: &dyn Fn(usize, usize) -> bool,
    job: &Job<'_>,
) -> Result<Vec<[u32; 3]>> {
    let n = scale.polygon().points.len();
    let same = alloc::collect(0..n as u32)?;
    let rounds = MAX_SEARCHED / n;
    for round in 0..rounds {
        let chords = Near::new(n, &found.triangles, &same, band)?;
        let Some(next) = best(scale, &chords, taken, None, &job.share(round, rounds))? else {
            break;
        };
        let gain = next.cost.gain_over(&found.cost);
        if gain > 0.0 {
            found = next;
        }
        if gain <= MIN_GAIN {
            break;
        }
    }
    Ok(found.triangles)
}

pub(super) struct Found {
    pub(super) cost: Cost,
    /// (i, m, k), i < m < k.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// The best triangulation of the part of the loop that a chord cuts off.
#[derive(Clone, Copy)]
struct Cell {
    cost: Cost,
    /// [`NOTHING`] if it has no triangulation.
    apex: u32,
    /// The unit normal of the triangle on the chord.
    normal: DVec3,
    bulge: f64,
}

const NOTHING: u32 = u32::MAX;

/// The best triangulation by these chords; `None` if there is none that costs less than `limit`.
pub(super) fn best(
    scale: &Scale<'_>,
    chords: &impl Chords,
    taken: &dyn Fn(usize, usize) -> bool,
    limit: Option<&Cost>,
    job: &Job<'_>,
) -> Result<Option<Found>> {
    let polygon = scale.polygon();
    let n = polygon.points.len();
    let none = Cell { cost: Cost::ZERO, apex: NOTHING, normal: DVec3::ZERO, bulge: 0.0 };
    let mut cells = alloc::filled(none, chords.count())?;
    chords.try_each(|number, [i, k]| {
        job.step_every(REPORT_INTERVAL, number, chords.count(), "triangulating holes")?;
        if k == i + 1 {
            cells[number] = Cell { apex: i as u32, normal: polygon.across[i], bulge: scale.bulge(i, k), ..none };
        } else if k - i + 1 == n || !taken(i, k) {
            cells[number] = cell(scale, chords, &cells, [i, k], limit).unwrap_or(none);
        }
        Ok(())
    })?;
    let Some(root) = chords.find(0, n - 1).map(|root| cells[root]).filter(|root| root.apex != NOTHING) else {
        return Ok(None);
    };
    let mut triangles = alloc::with_capacity(n - 2)?;
    let mut open = alloc::with_capacity(n)?;
    open.push((0, n - 1));
    while let Some((i, k)) = open.pop() {
        if let (true, Some(number)) = (k - i > 1, chords.find(i, k)) {
            let m = cells[number].apex;
            triangles.push([i as u32, m, k as u32]);
            open.extend([(m as usize, k), (i, m as usize)]);
        }
    }
    Ok(Some(Found { cost: root.cost, triangles }))
}

/// The best triangle on the chord (i, k).
fn cell(
    scale: &Scale<'_>,
    chords: &impl Chords,
    cells: &[Cell],
    [i, k]: [usize; 2],
    limit: Option<&Cost>,
) -> Option<Cell> {
    let polygon = scale.polygon();
    let bulge = scale.bulge(i, k);
    let at_root = k - i + 1 == polygon.points.len();
    let mut best: Option<Cell> = None;
    chords.each_apex(i, k, |m, sides| {
        let [left, right] = sides.map(|side| &cells[side]);
        if left.apex == NOTHING || right.apex == NOTHING {
            return;
        }
        // Costs only grow: what is no less already will not be.
        let least = best.as_ref().map(|best| &best.cost).or(limit);
        let is_less = |cost: &Cost| least.is_none_or(|least| scale.is_less(cost, least));
        let parts = left.cost.and(right.cost);
        if !is_less(&parts) {
            return;
        }
        let seam = scale.seam([i, m, k], [left.normal, right.normal]);
        let is_seam = seam.is_some();
        let (normal, own) = seam.unwrap_or_else(|| scale.triangle([i, m, k], [left.bulge, right.bulge, bulge]));
        let mut cost = parts.and(own);
        if !is_less(&cost) {
            return;
        }
        if !is_seam {
            cost = cost.and(scale.bend([i, m], normal, left.normal)).and(scale.bend([m, k], normal, right.normal));
        }
        if at_root {
            cost = cost.and(scale.bend([i, k], normal, polygon.across[k]));
        }
        if is_less(&cost) {
            best = Some(Cell { cost, apex: m as u32, normal, bulge });
        }
    });
    best
}
