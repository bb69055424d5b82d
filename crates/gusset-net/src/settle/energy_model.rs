//! The energy of a composite as sums over lines across its bridges and cells of films, and the
//! quadratic sums that bound it from above. O(nodes of bridges).

use super::energy::{BridgeEnergies, BridgeLine, FilmQuad};
use super::motion::RigidMotion;
use super::parts::{BODY_SLOT_FLAG, NO_BODY};
use super::quadratic_term::QuadraticTerm;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_base::sparse::SparseSymmetric;

/// The fraction of the diagonal that is added to it, so that unconstrained unknowns stay.
const RELATIVE_DAMPING: f64 = 1e-11;

/// Everything that has forces, scaled by the unit. Points are the classes of nodes, followed by the
/// targets of clamps, which move with the bodies.
pub(super) struct EnergyModel {
    /// For each point the index of its unknown, or [`BODY_SLOT_FLAG`] plus the index of its body.
    pub(super) unknown_or_body_of_point: Vec<u32>,
    /// The unknown that is the translation of each body; [`NO_BODY`] for bodies that stay.
    pub(super) translation_unknown_of_body: Vec<u32>,
    /// The points of moving bodies in the terms, and their initial positions.
    pub(super) carried_points_and_positions: Vec<(u32, DVec3)>,
    pub(super) unknown_count: usize,
    pub(super) lines: Vec<BridgeLine>,
    pub(super) quads: Vec<FilmQuad>,
}

impl EnergyModel {
    /// Returns the unknown that moves a point, if any does.
    fn unknown_of_point(&self, point: u32) -> Option<usize> {
        let slot = self.unknown_or_body_of_point[point as usize];
        let unknown = match slot {
            NO_BODY => NO_BODY,
            body if body >= BODY_SLOT_FLAG => self.translation_unknown_of_body[(body - BODY_SLOT_FLAG) as usize],
            own => own,
        };
        (unknown != NO_BODY).then_some(unknown as usize)
    }

    /// Returns the numbers of unknowns, lines and quads.
    pub(super) fn element_counts(&self) -> [usize; 3] {
        [self.unknown_count, self.lines.len(), self.quads.len()]
    }

    /// Moves the points of moving bodies.
    pub(super) fn place_moving_bodies(&self, motions: &[RigidMotion], x: &mut [DVec3]) {
        for &(point, start) in &self.carried_points_and_positions {
            x[point as usize] =
                motions[(self.unknown_or_body_of_point[point as usize] - BODY_SLOT_FLAG) as usize].apply(start);
        }
    }

    pub(super) fn bridge_energies(&self, x: &[DVec3]) -> BridgeEnergies {
        let mut sum = BridgeEnergies::default();
        self.lines.iter().for_each(|line| line.add_energies(x, &mut sum));
        self.quads.iter().for_each(|quad| sum.tension += quad.film_energy(x));
        sum
    }

    /// Returns the terms of a sum of squares that bounds the energy from above, up to a constant,
    /// and touches it at x.
    pub(super) fn energy_terms(&self, x: &[DVec3]) -> Result<Vec<QuadraticTerm>> {
        let mut terms = Vec::new();
        for line in &self.lines {
            line.push_quadratic_terms(x, &mut terms)?;
        }
        for quad in &self.quads {
            quad.push_quadratic_terms(x, &mut terms)?;
        }
        Ok(terms)
    }

    /// Returns the gradient of the sum for each unknown.
    pub(super) fn gradient(&self, terms: &[QuadraticTerm], x: &[DVec3]) -> Result<Vec<DVec3>> {
        let mut gradient = alloc::filled(DVec3::ZERO, self.unknown_count)?;
        for term in terms {
            let force = term.weight * term.residual(x);
            for (&point, &c) in term.points.iter().zip(&term.factors).filter(|&(_, &c)| c != 0.0) {
                if let Some(unknown) = self.unknown_of_point(point) {
                    gradient[unknown] += c * force;
                }
            }
        }
        Ok(gradient)
    }

    /// Returns the displacements of the unknowns to the minimum of the sum, with bodies that do not
    /// rotate.
    pub(super) fn minimising_step(
        &self,
        terms: &[QuadraticTerm],
        gradient: &[DVec3],
        job: &Job<'_>,
    ) -> Result<Vec<DVec3>> {
        let matrix = self.system_matrix(terms, &job.sub_job(0.0, 0.2))?;
        let mut solution = alloc::collect(gradient.iter().map(|&g| -g))?;
        matrix.factorise(&job.sub_job(0.2, 0.9))?.solve(&mut solution, &job.sub_job(0.9, 1.0))?;
        Ok(solution)
    }

    fn system_matrix(&self, terms: &[QuadraticTerm], job: &Job<'_>) -> Result<SparseSymmetric> {
        let pairs = |term: &QuadraticTerm| {
            let unknowns = term.points.map(|point| self.unknown_of_point(point));
            let (factors, weight) = (term.factors, term.weight);
            let entry = move |(i, j): (usize, usize)| {
                let (Some(p), Some(q)) = (unknowns[i], unknowns[j]) else { return None };
                let value = weight * factors[i] * factors[j];
                (p <= q && value != 0.0).then_some((q, (p as u32, value)))
            };
            (0..9).filter_map(move |k| entry((k / 3, k % 3)))
        };
        job.step(0.0, "settle")?;
        let mut columns = Buckets::new(self.unknown_count, (0, 0.0), terms.iter().flat_map(pairs))?;
        let (mut start, mut entries) = (alloc::with_capacity(self.unknown_count + 1)?, Vec::new());
        let mut diagonal = alloc::filled(0.0, self.unknown_count)?;
        start.push(0);
        for (k, diagonal) in diagonal.iter_mut().enumerate() {
            job.step_every(1 << 14, k, self.unknown_count, "settle")?;
            let column = columns.get_mut(k);
            column.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            for same in column.chunk_by(|a, b| a.0 == b.0) {
                let sum: f64 = same.iter().map(|&(_, value)| value).sum();
                if same[0].0 as usize == k {
                    *diagonal = sum * (1.0 + RELATIVE_DAMPING);
                } else {
                    alloc::push(&mut entries, (same[0].0, sum))?;
                }
            }
            start.push(entries.len());
        }
        Ok(SparseSymmetric { column_starts: start, entries, diagonal })
    }

    /// Returns the points and the motions after displacements, or after a fraction of them.
    pub(super) fn displace_points(
        &self,
        x: &[DVec3],
        motions: &[RigidMotion],
        step: &[DVec3],
        fraction: f64,
    ) -> Result<(Vec<DVec3>, Vec<RigidMotion>)> {
        let (mut x, mut motions) = (alloc::copied(x)?, alloc::copied(motions)?);
        for (point, &slot) in x.iter_mut().zip(&self.unknown_or_body_of_point) {
            if slot < BODY_SLOT_FLAG {
                *point += fraction * step[slot as usize];
            }
        }
        for (motion, &unknown) in motions.iter_mut().zip(&self.translation_unknown_of_body) {
            if unknown != NO_BODY {
                motion.translation += fraction * step[unknown as usize];
            }
        }
        self.place_moving_bodies(&motions, &mut x);
        Ok((x, motions))
    }
}
