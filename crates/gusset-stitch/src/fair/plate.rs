//! The normal equations of the thin-plate energy, and their solution for the free vertices.
//!
//! L is the Laplacian of the patch, C the set of centres, and h the Laplacian of the rest shape.
//! The energy is the area-weighted sum over C of |L p - h|^2, plus the energy of the springs of the
//! [`RestShape`]. Its minimum over the free vertices solves a sparse symmetric system, which is
//! factorised once for all three coordinates. For curvature continuity, let b = L p - h. The energy
//! is b^T S b with the stiffness matrix S: the weighted sum of the squared differences of b over
//! the edges between centres.

use super::continuity::Continuity;
use super::exact_laplacian::ExactLaplacian;
use super::one_rings::{LaplacianWeights, MatrixRows, OneRings};
use super::plate_couplings::PlateCouplings;

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sparse::{SparseSymmetric, order_by_nested_dissection};
use gusset_mesh::NONE;

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 12;

/// A patch, and the energy to minimise.
#[derive(Clone, Copy)]
pub(crate) struct Plate<'a> {
    pub(crate) triangles: &'a [[u32; 3]],
    /// True for the vertices that may move.
    pub(crate) is_free_vertex: &'a [bool],
    /// True for the vertices whose Laplacian enters the energy. For a seam without a crease, these
    /// are the free vertices and the fixed vertices next to a free one. `triangles` must contain
    /// the whole one-ring of each, including old neighbours.
    pub(crate) has_laplacian_in_energy: &'a [bool],
    pub(crate) weights: LaplacianWeights,
    /// The energy: the Laplacian, or, with [`LaplacianWeights::Cotangent`] only, its gradient. In
    /// the latter case the fixed vertices next to those above are centres too.
    pub(crate) continuity: Continuity,
    /// The rest shape of the plate; `None` for a flat one. Only with
    /// [`LaplacianWeights::Cotangent`] and [`Continuity::C1`].
    pub(crate) shape: Option<RestShape<'a>>,
    /// Positions by which the vertices are ordered: evenly spread, with neighbours near each other;
    /// `None` for the points themselves. They affect time and memory, and the result only by
    /// round-off.
    pub(crate) ordering_positions: Option<&'a [DVec3]>,
}

/// The rest shape of a plate.
#[derive(Clone, Copy)]
pub(crate) struct RestShape<'a> {
    /// The Laplacian h at each vertex, in the reciprocal of the points' unit.
    pub(crate) curvature: &'a [DVec3],
    /// The rest positions x0.
    pub(crate) rest_positions: &'a [DVec3],
    /// The length r, in the points' unit. Weak springs tie a wider plate to its rest positions,
    /// because small errors of the curvature would add up across it.
    pub(crate) max_width_without_springs: f64,
}

/// Moves the free vertices of a plate to the minimum of its energy; the others are fixed.
///
/// The energy is the sum over all centres v of A(v) |L x(v) - h(v)|^2, with the areas A. For
/// curvature continuity it is the weighted sum over the edges between centres of the squared
/// difference of L x - h. The springs add the sum over the free vertices of A(v) |x(v) - x0(v)|^2 /
/// r^4. Without a shape h is 0, and no springs act. A free vertex does not move if no chain of free
/// vertices connects it with a fixed one, or if the equations do not determine its position.
///
/// The displacement y of the free vertices solves H y = -G. G is the gradient of the energy at the
/// current positions, and H the second derivative, a sparse matrix that couples vertices with a
/// common centre.
///
/// For n free vertices of a patch with T triangles: O(T + n log n), plus the factorisation with
/// O(n^1.5) operations and O(n log n) memory, about 10 bytes per entry, on a surface patch. On a
/// strip it is nearly linear.
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub(crate) fn minimise_plate_energy(points: &mut [DVec3], plate: &Plate<'_>, job: &Job<'_>) -> Result<()> {
    job.step(0.0, "fairing")?;
    let unit = common_unit(&*points);
    // Use coordinates relative to one of the points, to keep precision far from the origin.
    let origin = points.first().map_or(DVec3::ZERO, |&p| p / unit);
    let local = alloc::collect(points.iter().map(|&p| p / unit - origin))?;
    let rings = OneRings::new(&local, plate.triangles, plate.weights, &job.sub_job(0.0, 0.15))?;
    let mut unknowns = anchored_vertices(&rings, plate.is_free_vertex)?;
    let couplings =
        PlateCouplings { rings: &rings, is_row: plate.has_laplacian_in_energy, continuity: plate.continuity };
    order_by_nested_dissection(
        &mut unknowns,
        plate.ordering_positions.unwrap_or(&local),
        couplings,
        &job.sub_job(0.15, 0.2),
    )?;
    let (matrix, mut moves) =
        assemble_plate_equations(&local, &rings, &unknowns, plate, (unit, origin), &job.sub_job(0.2, 0.3))?;
    matrix.factorise(&job.sub_job(0.3, 0.9))?.solve(&mut moves, &job.sub_job(0.9, 1.0))?;
    for (&v, &by) in unknowns.iter().zip(&moves) {
        let place = (local[v as usize] + by + origin) * unit;
        if by != DVec3::ZERO && place.is_finite() {
            points[v as usize] = place;
        }
    }
    Ok(())
}

/// Returns the free vertices that a chain of free vertices connects with a fixed one.
fn anchored_vertices(rings: &OneRings, free: &[bool]) -> Result<Vec<u32>> {
    let mut is_anchored = alloc::filled(false, free.len())?;
    let mut list = alloc::with_capacity(free.len())?;
    let neighbours = |v: u32| rings.ring(v as usize).iter().map(|&(w, _)| w as usize);
    for v in (0..free.len()).filter(|&v| free[v]) {
        if neighbours(v as u32).any(|w| !free[w]) {
            is_anchored[v] = true;
            list.push(v as u32);
        }
    }
    let mut next = 0;
    while next < list.len() {
        for w in neighbours(list[next]) {
            if free[w] && !is_anchored[w] {
                is_anchored[w] = true;
                list.push(w as u32);
            }
        }
        next += 1;
    }
    Ok(list)
}

/// Returns the second derivative of the energy, in the order of `unknowns`, and its negative
/// gradient, both halved. `points` are in `unit` from `origin`, and the plate's shape is in the
/// original coordinates.
fn assemble_plate_equations(
    points: &[DVec3],
    rings: &OneRings,
    unknowns: &[u32],
    plate: &Plate<'_>,
    (unit, origin): (f64, DVec3),
    job: &Job<'_>,
) -> Result<(SparseSymmetric, Vec<DVec3>)> {
    let centres = plate.has_laplacian_in_energy;
    let exact = match plate.continuity {
        Continuity::C1 => None,
        Continuity::C2 => Some(ExactLaplacian::new(points, plate.triangles, rings, &job.sub_job(0.0, 0.3))?),
    };
    let (rows, columns) = exact.as_ref().map_or((rings.laplacian_rows(), rings.laplacian_rows()), |exact| {
        (exact.matrix_rows(rings), exact.matrix_columns(rings))
    });
    let bend = bend_derivatives(points, rings, rows, plate, unit)?;
    let mut place = alloc::filled(NONE, points.len())?;
    for (k, &v) in unknowns.iter().enumerate() {
        place[v as usize] = k as u32;
    }
    let (n, assembly) = (unknowns.len(), job.sub_job(0.3, 1.0));
    let mut matrix = SparseSymmetric {
        column_starts: alloc::with_capacity(n + 1)?,
        entries: alloc::with_capacity(10 * n)?,
        diagonal: alloc::with_capacity(n)?,
    };
    matrix.column_starts.push(0);
    let mut moves = alloc::with_capacity(n)?;
    let (mut shares, mut column) = (SparseSums::new(points.len())?, SparseSums::new(n)?);
    for (k, &v) in unknowns.iter().enumerate() {
        assembly.step_every(VERTICES_PER_REPORT, k + 1, n, "fairing")?;
        let mut gradient = DVec3::ZERO;
        for (c, factor) in columns.row(v as usize).filter(|&(c, _)| centres[c]) {
            gradient += factor * bend[c];
            match plate.continuity {
                Continuity::C1 => shares.add_term(c, factor * rings.energy_scale(c))?,
                Continuity::C2 => {
                    for (other, weight) in edges_to_centres(rings, centres, c) {
                        shares.add_term(c, factor * weight)?;
                        shares.add_term(other, -factor * weight)?;
                    }
                }
            }
        }
        for (c, share) in shares.drain_sums() {
            for (w, weight) in rows.row(c) {
                let i = place[w] as usize;
                // Skip vertices that are not unknowns.
                if i <= k {
                    column.add_term(i, share * weight)?;
                }
            }
        }
        // A spring with the strength area / reach^4.
        let spring = |own: RestShape<'_>| {
            let squared = (own.max_width_without_springs / unit) * (own.max_width_without_springs / unit);
            let strength = 1.0 / (squared * squared * rings.energy_scale(v as usize));
            (strength, points[v as usize] - (own.rest_positions[v as usize] / unit - origin))
        };
        let (strength, away) = plate.shape.map_or((0.0, DVec3::ZERO), spring);
        moves.push(-gradient - strength * away);
        let mut diagonal = 0.0;
        alloc::reserve(&mut matrix.entries, column.len())?;
        for (i, value) in column.drain_sums() {
            if i == k {
                diagonal = value + strength;
            } else {
                matrix.entries.push((i as u32, value));
            }
        }
        matrix.diagonal.push(diagonal);
        matrix.column_starts.push(matrix.entries.len());
    }
    Ok((matrix, moves))
}

/// Returns the derivative of the halved energy with respect to the row of the Laplacian at each
/// centre: L p - h, or for curvature continuity the weighted sum of its differences.
fn bend_derivatives(
    points: &[DVec3],
    rings: &OneRings,
    rows: MatrixRows<'_>,
    plate: &Plate<'_>,
    unit: f64,
) -> Result<Vec<DVec3>> {
    let centres = plate.has_laplacian_in_energy;
    let scale = |c: usize| if plate.continuity == Continuity::C1 { rings.energy_scale(c) } else { 1.0 };
    let mut bend = alloc::filled(DVec3::ZERO, points.len())?;
    for c in (0..points.len()).filter(|&c| centres[c]) {
        let neighbours = rows.row(c).skip(1);
        let laplacian = neighbours.fold(DVec3::ZERO, |sum, (w, weight)| sum + weight * (points[w] - points[c]));
        bend[c] = scale(c) * laplacian - plate.shape.map_or(DVec3::ZERO, |own| own.curvature[c] * unit);
    }
    if plate.continuity == Continuity::C1 {
        return Ok(bend);
    }
    let difference =
        |c: usize| edges_to_centres(rings, centres, c).map(|(other, weight)| weight * (bend[c] - bend[other])).sum();
    alloc::collect((0..points.len()).map(|c| if centres[c] { difference(c) } else { DVec3::ZERO }))
}

/// Returns the edges from a centre to other centres, and their weights.
fn edges_to_centres(rings: &OneRings, centres: &[bool], c: usize) -> impl Iterator<Item = (usize, f64)> {
    rings.ring(c).iter().map(|&(w, weight)| (w as usize, weight)).filter(|&(w, _)| centres[w])
}

/// Sparse sums by index.
struct SparseSums {
    sums: Vec<f64>,
    has_terms: Vec<bool>,
    indices_with_terms: Vec<u32>,
}

impl SparseSums {
    fn new(count: usize) -> Result<Self> {
        let (sums, has_terms) = (alloc::filled(0.0, count)?, alloc::filled(false, count)?);
        Ok(SparseSums { sums, has_terms, indices_with_terms: Vec::new() })
    }

    fn add_term(&mut self, number: usize, value: f64) -> Result<()> {
        if !std::mem::replace(&mut self.has_terms[number], true) {
            alloc::push(&mut self.indices_with_terms, number as u32)?;
        }
        self.sums[number] += value;
        Ok(())
    }

    fn len(&self) -> usize {
        self.indices_with_terms.len()
    }

    /// Returns the indices with terms, in the order of their first terms, and their sums. Resets
    /// all sums.
    fn drain_sums(&mut self) -> impl Iterator<Item = (usize, f64)> {
        let (sums, has_terms) = (&mut self.sums, &mut self.has_terms);
        self.indices_with_terms.drain(..).map(|number| {
            has_terms[number as usize] = false;
            (number as usize, std::mem::take(&mut sums[number as usize]))
        })
    }
}
