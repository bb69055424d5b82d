//! The normal equations of the thin-plate energy, and their solution for the free vertices.
//!
//! With the Laplacian L of the patch, the vertices C at which it is counted and the Laplacian h
//! that the plate has by itself, the energy is the sum over C of |L p - h|^2 by area, and that of the
//! springs of its [`Shape`]; its minimum over the free vertices solves a sparse symmetric system,
//! factored once for all three coordinates.

use super::order::dissect;
use super::rings::{Rings, Weights};
use super::sparse::Symmetric;
use crate::alloc;
use crate::error::Result;
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::mesh::NONE;
use glam::DVec3;

/// Vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 14;

/// A patch, and what is to be least.
#[derive(Clone, Copy)]
pub(crate) struct Plate<'a> {
    pub(crate) triangles: &'a [[u32; 3]],
    /// True of the vertices that may move.
    pub(crate) free: &'a [bool],
    /// True of the vertices whose Laplacian is counted. For a crease-free seam these are the free
    /// vertices and those fixed ones that border on a free one, each with its whole one-ring in
    /// `triangles`, old neighbours included.
    pub(crate) centres: &'a [bool],
    pub(crate) weights: Weights,
    /// The shape that the plate has by itself; `None`: flat. With [`Weights::Cotangent`] only.
    pub(crate) shape: Option<Shape<'a>>,
    /// Places of the vertices by which they are put in order, near each other where they are
    /// neighbours and spread evenly; `None` for the points themselves. The result does not depend
    /// on it but for round-off; time and memory do.
    pub(crate) layout: Option<&'a [DVec3]>,
}

/// What a plate does where nothing bends it.
#[derive(Clone, Copy)]
pub(crate) struct Shape<'a> {
    /// Its Laplacian h, vertex by vertex, in one over the points' unit.
    pub(crate) curvature: &'a [DVec3],
    /// Where it lies, x0.
    pub(crate) places: &'a [DVec3],
    /// What is wider than this length r hangs on its place by weak springs, in the points' unit:
    /// small errors of the curvature would add up across it.
    pub(crate) reach: f64,
}

/// Moves the free vertices of a plate to where the sum over all its centres v of A(v) |L x(v) -
/// h(v)|^2 and, over the free vertices, of A(v) |x(v) - x0(v)|^2 / r^4 is least, A being the areas;
/// the others stay. So does a vertex that no chain of free vertices connects with a fixed one, or
/// whose place the equations do not determine. Without a shape h is 0, and nothing hangs on
/// springs.
///
/// The displacement y of the free vertices solves A y = -G, G being the gradient of the energy
/// where they are now and A its second derivative, a sparse matrix that couples vertices with a
/// centre in common.
///
/// For n free vertices of a patch of T triangles O(T + n log n) and the factor: O(n^1.5) operations
/// and O(n log n) memory, some 10 bytes an entry, on a surface patch; nearly linear on a strip.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory),
/// [`Error::Cancelled`](crate::Error::Cancelled).
pub(crate) fn thin_plate(points: &mut [DVec3], plate: &Plate<'_>, job: &Job<'_>) -> Result<()> {
    job.step(0.0, "fairing")?;
    let unit = common_unit(&*points);
    // Relative to one of the points, so that a patch far from the origin loses no digits.
    let origin = points.first().map_or(DVec3::ZERO, |&p| p / unit);
    let local = alloc::collect(points.iter().map(|&p| p / unit - origin))?;
    let rings = Rings::new(&local, plate.triangles, plate.weights, &job.part(0.0, 0.15))?;
    let mut unknowns = anchored(&rings, plate.free)?;
    dissect(&mut unknowns, plate.layout.unwrap_or(&local), &rings, plate.centres, &job.part(0.15, 0.2))?;
    let (matrix, mut moves) = equations(&local, &rings, &unknowns, plate, (unit, origin), &job.part(0.2, 0.3))?;
    matrix.factor(&job.part(0.3, 0.9))?.solve(&mut moves, &job.part(0.9, 1.0))?;
    for (&v, &by) in unknowns.iter().zip(&moves) {
        let place = (local[v as usize] + by + origin) * unit;
        if by != DVec3::ZERO && place.is_finite() {
            points[v as usize] = place;
        }
    }
    Ok(())
}

/// The free vertices that a chain of free vertices connects with a fixed one.
fn anchored(rings: &Rings, free: &[bool]) -> Result<Vec<u32>> {
    let mut found = alloc::filled(false, free.len())?;
    let mut list = alloc::with_capacity(free.len())?;
    let neighbours = |v: u32| rings.ring(v as usize).iter().map(|&(w, _)| w as usize);
    for v in (0..free.len()).filter(|&v| free[v]) {
        if neighbours(v as u32).any(|w| !free[w]) {
            found[v] = true;
            list.push(v as u32);
        }
    }
    let mut next = 0;
    while next < list.len() {
        for w in neighbours(list[next]) {
            if free[w] && !found[w] {
                found[w] = true;
                list.push(w as u32);
            }
        }
        next += 1;
    }
    Ok(list)
}

/// The second derivative of the energy, in the order of `unknowns`, and less its gradient; both
/// halved. `points` in `unit` from `origin`, the plate's shape as it was given.
fn equations(
    points: &[DVec3],
    rings: &Rings,
    unknowns: &[u32],
    plate: &Plate<'_>,
    (unit, origin): (f64, DVec3),
    job: &Job<'_>,
) -> Result<(Symmetric, Vec<DVec3>)> {
    let centres = plate.centres;
    // How far the Laplacian of each centre is from the plate's own, scaled.
    let mut bend = alloc::filled(DVec3::ZERO, points.len())?;
    for c in (0..points.len()).filter(|&c| centres[c]) {
        let laplacian =
            rings.ring(c).iter().fold(DVec3::ZERO, |sum, &(w, weight)| sum + weight * (points[w as usize] - points[c]));
        bend[c] = rings.scale(c) * laplacian - plate.shape.map_or(DVec3::ZERO, |own| own.curvature[c] * unit);
    }
    let mut place = alloc::filled(NONE, points.len())?;
    for (k, &v) in unknowns.iter().enumerate() {
        place[v as usize] = k as u32;
    }
    let n = unknowns.len();
    let mut matrix = Symmetric {
        start: alloc::with_capacity(n + 1)?,
        entries: alloc::with_capacity(10 * n)?,
        diagonal: alloc::with_capacity(n)?,
    };
    matrix.start.push(0);
    let mut moves = alloc::with_capacity(n)?;
    let mut column = alloc::filled(0.0, n)?;
    let mut rows = Vec::new();
    let mut seen = alloc::filled(NONE, n)?;
    for (k, &v) in unknowns.iter().enumerate() {
        job.step_every(REPORT_INTERVAL, k + 1, n, "fairing")?;
        let mut gradient = DVec3::ZERO;
        for (c, factor) in rings.row(v as usize).filter(|&(c, _)| centres[c]) {
            gradient += factor * bend[c];
            let factor = factor * rings.scale(c);
            for (w, weight) in rings.row(c) {
                let i = place[w] as usize;
                // Also if it is no unknown.
                if i > k {
                    continue;
                }
                if seen[i] != k as u32 {
                    seen[i] = k as u32;
                    column[i] = 0.0;
                    alloc::push(&mut rows, i as u32)?;
                }
                column[i] += factor * weight;
            }
        }
        // A spring of strength area / reach^4.
        let spring = |own: Shape<'_>| {
            let squared = (own.reach / unit) * (own.reach / unit);
            let strength = 1.0 / (squared * squared * rings.scale(v as usize));
            (strength, points[v as usize] - (own.places[v as usize] / unit - origin))
        };
        let (strength, away) = plate.shape.map_or((0.0, DVec3::ZERO), spring);
        moves.push(-gradient - strength * away);
        let is_centred = seen[k] == k as u32;
        matrix.diagonal.push(if is_centred { column[k] + strength } else { 0.0 });
        alloc::reserve(&mut matrix.entries, rows.len())?;
        matrix.entries.extend(rows.drain(..).filter(|&i| i as usize != k).map(|i| (i, column[i as usize])));
        matrix.start.push(matrix.entries.len());
    }
    Ok((matrix, moves))
}
