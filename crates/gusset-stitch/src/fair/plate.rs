//! The normal equations of the thin-plate energy, and their solution for the free vertices.
//!
//! With the Laplacian L of the patch, the vertices C at which it is counted and the Laplacian h
//! that the plate has by itself, the energy is the sum over C of |L p - h|^2 by area, and that of
//! the springs of its [`Shape`]; its minimum over the free vertices solves a sparse symmetric
//! system, factored once for all three coordinates. For continuous curvature the energy is the sum
//! over the edges between centres of the squared differences of L p - h by their weights: b^T S b
//! with the stiffness matrix S, b being L p - h.

use super::continuity::Continuity;
use super::couplings::Couplings;
use super::exact_laplacian::Exact;
use super::rings::{Rings, Rows, Weights};

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sparse::{Symmetric, dissect};
use gusset_mesh::NONE;

/// Vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

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
    /// What is least: the Laplacian, or, with [`Weights::Cotangent`] only, its gradient. Then the
    /// centres are the fixed vertices, too, that border on those.
    pub(crate) continuity: Continuity,
    /// The shape that the plate has by itself; `None`: flat. With [`Weights::Cotangent`] only, and
    /// [`Continuity::C1`].
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
/// h(v)|^2, or, over the edges between centres, that of their weights times the squared difference
/// of L x - h, and, over the free vertices, of A(v) |x(v) - x0(v)|^2 / r^4 is least, A being the
/// areas; the others stay. So does a vertex that no chain of free vertices connects with a fixed
/// one, or whose place the equations do not determine. Without a shape h is 0, and nothing hangs on
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
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub(crate) fn thin_plate(points: &mut [DVec3], plate: &Plate<'_>, job: &Job<'_>) -> Result<()> {
    job.step(0.0, "fairing")?;
    let unit = common_unit(&*points);
    // Relative to one of the points, so that a patch far from the origin loses no digits.
    let origin = points.first().map_or(DVec3::ZERO, |&p| p / unit);
    let local = alloc::collect(points.iter().map(|&p| p / unit - origin))?;
    let rings = Rings::new(&local, plate.triangles, plate.weights, &job.part(0.0, 0.15))?;
    let mut unknowns = anchored(&rings, plate.free)?;
    let couplings = Couplings { rings: &rings, is_row: plate.centres, continuity: plate.continuity };
    dissect(&mut unknowns, plate.layout.unwrap_or(&local), couplings, &job.part(0.15, 0.2))?;
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
    let exact = match plate.continuity {
        Continuity::C1 => None,
        Continuity::C2 => Some(Exact::new(points, plate.triangles, rings, &job.part(0.0, 0.3))?),
    };
    let (rows, columns) =
        exact.as_ref().map_or((rings.rows(), rings.rows()), |exact| (exact.rows(rings), exact.columns(rings)));
    let bend = bends(points, rings, rows, plate, unit)?;
    let mut place = alloc::filled(NONE, points.len())?;
    for (k, &v) in unknowns.iter().enumerate() {
        place[v as usize] = k as u32;
    }
    let (n, assembly) = (unknowns.len(), job.part(0.3, 1.0));
    let mut matrix = Symmetric {
        start: alloc::with_capacity(n + 1)?,
        entries: alloc::with_capacity(10 * n)?,
        diagonal: alloc::with_capacity(n)?,
    };
    matrix.start.push(0);
    let mut moves = alloc::with_capacity(n)?;
    let (mut shares, mut column) = (Sums::new(points.len())?, Sums::new(n)?);
    for (k, &v) in unknowns.iter().enumerate() {
        assembly.step_every(REPORT_INTERVAL, k + 1, n, "fairing")?;
        let mut gradient = DVec3::ZERO;
        for (c, factor) in columns.row(v as usize).filter(|&(c, _)| centres[c]) {
            gradient += factor * bend[c];
            match plate.continuity {
                Continuity::C1 => shares.add(c, factor * rings.scale(c))?,
                Continuity::C2 => {
                    for (other, weight) in edges(rings, centres, c) {
                        shares.add(c, factor * weight)?;
                        shares.add(other, -factor * weight)?;
                    }
                }
            }
        }
        for (c, share) in shares.drain() {
            for (w, weight) in rows.row(c) {
                let i = place[w] as usize;
                // Not if it is no unknown.
                if i <= k {
                    column.add(i, share * weight)?;
                }
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
        let mut diagonal = 0.0;
        alloc::reserve(&mut matrix.entries, column.len())?;
        for (i, value) in column.drain() {
            if i == k {
                diagonal = value + strength;
            } else {
                matrix.entries.push((i as u32, value));
            }
        }
        matrix.diagonal.push(diagonal);
        matrix.start.push(matrix.entries.len());
    }
    Ok((matrix, moves))
}

/// The derivative of the halved energy by the row of the Laplacian at each centre, as the rows have
/// it: L p - h, or, where it is the gradient that is least, the weighted sum of its differences.
fn bends(points: &[DVec3], rings: &Rings, rows: Rows<'_>, plate: &Plate<'_>, unit: f64) -> Result<Vec<DVec3>> {
    let centres = plate.centres;
    let scale = |c: usize| if plate.continuity == Continuity::C1 { rings.scale(c) } else { 1.0 };
    let mut bend = alloc::filled(DVec3::ZERO, points.len())?;
    for c in (0..points.len()).filter(|&c| centres[c]) {
        let neighbours = rows.row(c).skip(1);
        let laplacian = neighbours.fold(DVec3::ZERO, |sum, (w, weight)| sum + weight * (points[w] - points[c]));
        bend[c] = scale(c) * laplacian - plate.shape.map_or(DVec3::ZERO, |own| own.curvature[c] * unit);
    }
    if plate.continuity == Continuity::C1 {
        return Ok(bend);
    }
    let difference = |c: usize| edges(rings, centres, c).map(|(other, weight)| weight * (bend[c] - bend[other])).sum();
    alloc::collect((0..points.len()).map(|c| if centres[c] { difference(c) } else { DVec3::ZERO }))
}

/// The edges from a centre to others, and their weights.
fn edges(rings: &Rings, centres: &[bool], c: usize) -> impl Iterator<Item = (usize, f64)> {
    rings.ring(c).iter().map(|&(w, weight)| (w as usize, weight)).filter(|&(w, _)| centres[w])
}

/// Sums by number, most of them of nothing.
struct Sums {
    sums: Vec<f64>,
    has_terms: Vec<bool>,
    numbers: Vec<u32>,
}

impl Sums {
    fn new(count: usize) -> Result<Self> {
        let (sums, has_terms) = (alloc::filled(0.0, count)?, alloc::filled(false, count)?);
        Ok(Sums { sums, has_terms, numbers: Vec::new() })
    }

    fn add(&mut self, number: usize, value: f64) -> Result<()> {
        if !std::mem::replace(&mut self.has_terms[number], true) {
            alloc::push(&mut self.numbers, number as u32)?;
        }
        self.sums[number] += value;
        Ok(())
    }

    fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Those that have terms, in the order of their first ones; then none have.
    fn drain(&mut self) -> impl Iterator<Item = (usize, f64)> {
        let (sums, has_terms) = (&mut self.sums, &mut self.has_terms);
        self.numbers.drain(..).map(|number| {
            has_terms[number as usize] = false;
            (number as usize, std::mem::take(&mut sums[number as usize]))
        })
    }
}
