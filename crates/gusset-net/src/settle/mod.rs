//! The equilibrium of a composite net: bridges under tension, elasticity and stiffness (Deryagin,
//! "Concatenation", Fig. 9: a bridge "can be given physical properties").
//!
//! The inner nodes of whole bridges, and free parts as rigid bodies, move to the minimum of the sum
//! of these energies. Lines run across a bridge and have N links each; glued lines count once.
//!
//! - Tension T of a thread or ribbon: for each line, T times the square root of N times the sum of
//!   its squared link lengths. It equals T times the line's length once its nodes are evenly
//!   spaced, as in equilibrium.
//! - Tension T of a tube: T times the area of its film. The area of a cell is the mean of both
//!   triangulations.
//! - Elasticity Y: Y / 2 (l - r)^2 / r for each link across, of length l and rest length r.
//! - Stiffness B: B / 2 h^3 times the sum of squared second differences along each line, plus 2
//!   (p1 - p0 - h d)^2 at each end. h is the mean rest length of the line's links and d the
//!   direction of the part's last link.
//!
//! The tension of a ribbon acts in its lines, because a film with free edges would shrink to zero
//! area. A bridge of infinite stiffness is one body with both its sides. Hidden bridges exert no
//! force. Welded bridges lack inner nodes and unite two bodies.
//!
//! Each step minimises a sum of squares that bounds the energy from above and touches it at the
//! current net. For lines these are force densities (H.-J. Schek, *The force density method for
//! form finding*, 1974). For films they use the cotangents of U. Pinkall and K. Polthier
//! (*Computing discrete minimal surfaces*, 1993), which are the natural force densities of R.
//! Pauletti and P. Pimenta (2008). Bodies are translated with the nodes and then rotated one by
//! one. If all parts are held, steps are accelerated (`anderson`) whenever that lowers the energy
//! further. The energy therefore never grows. Convergence is linear, and slow for films near the
//! limit of stability. A step takes O(n^1.5) operations and O(n log n) memory for n inner nodes, on
//! one thread.

mod anderson;
mod composite;
mod descent;
mod energy;
mod energy_model;
mod motion;
mod parts;
mod quadratic_term;
mod rotate_bodies;
mod settle_options;

use super::Net;
use super::planarise::PlanariseOptions;
use super::planarise::scaled_vertices::ScaledVertices;
use composite::{CompositeModel, build_composite};
use descent::descend_to_equilibrium;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use parts::{BODY_SLOT_FLAG, CompositeParts, NO_BODY};
pub use settle_options::SettleOptions;

/// The result of [`settle`]. Energies are in units of force times length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Settled {
    /// The initial energy, with rigid bridges in their rest shape.
    pub energy_before: f64,
    /// The final energy of tension.
    pub tension_energy: f64,
    /// The final energy of springs.
    pub elastic_energy: f64,
    /// The final energy of bending.
    pub bending_energy: f64,
    /// The largest remaining force on an inner vertex or a free body.
    pub residual_force: f64,
    /// The largest displacement of a vertex.
    pub max_displacement: f64,
    /// The number of steps.
    pub iterations: u32,
    /// The number of whole bridges with a force.
    pub settled: u32,
    /// The number of whole bridges without a force: hidden or welded ones, and bridges whose
    /// properties are all 0.
    pub idle: u32,
    /// The number of collapsed films, in which a cell has less than a millionth of the mean area.
    pub collapsed: u32,
    /// Whether the last step was within the tolerance, or too small to lower the energy, and no
    /// film has collapsed.
    pub converged: bool,
}

/// The default limit on steps.
const DEFAULT_ITERATIONS: u32 = 1000;
/// The default tolerance.
const DEFAULT_TOLERANCE: f64 = 1e-12;
/// A film has collapsed if a cell is below this fraction of the initial mean area.
const MIN_RELATIVE_CELL_AREA: f64 = 1e-6;

/// Moves the inner nodes of the whole bridges of a net, and its free parts, to equilibrium.
///
/// Whole bridges run from side to side; only bridges in the direction of the last one count. In a
/// group of parts that bridges join, the first part is held if the caller holds none. Lines with a
/// missing node exert no force, and links without a rest length lack elasticity. If the steps do
/// not converge, the result says so.
///
/// # Errors
/// - [`Error::BadProperty`].
/// - [`Error::OptionOutOfRange`]: the tolerance or the ratio.
/// - [`Error::ArrayTooShort`]: flags of some parts only.
/// - [`Error::SidesDiffer`]: a reference of another size.
/// - [`Error::NoSuch`]: bridges that overlap or leave the net.
/// - [`Error::OutOfMemory`], [`Error::Cancelled`].
///
/// The net is then unchanged.
pub fn settle(net: &mut Net<'_>, options: &SettleOptions<'_>, job: &Job<'_>) -> Result<Settled> {
    let (tolerance, ratio) = (options.tolerance, options.rest_ratio);
    Error::require(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", tolerance, "finite and at least 0")?;
    Error::require(ratio >= 0.0 && ratio.is_finite(), "rest_ratio", ratio, "finite and at least 0")?;
    if let Some(reference) = options.reference.filter(|reference| reference.shape() != net.shape()) {
        let [a, b] = [net.shape(), reference.shape()].map(|shape| shape.node_count() as u32);
        return Err(Error::SidesDiffer { a, b });
    }
    job.step(0.0, "settle")?;
    let mut parts = CompositeParts::new(net, options)?;
    let surface = ScaledVertices::new(net, &PlanariseOptions::default(), &job.sub_job(0.0, 0.1))?;
    let slots = parts.unite_into_bodies(net, &surface.classes, &job.sub_job(0.1, 0.15))?;
    let mut composite = build_composite(net, options, (&parts, &surface, slots), &job.sub_job(0.15, 0.2))?;
    let tolerance = if tolerance == 0.0 { DEFAULT_TOLERANCE } else { tolerance } * surface.box_diagonal;
    let max = if options.max_iterations == 0 { DEFAULT_ITERATIONS } else { options.max_iterations };
    let [energy_unit, force_unit] = composite.energy_unit;
    let energy_before = composite.model.bridge_energies(&composite.points).total_energy();
    let done = descend_to_equilibrium(&mut composite, tolerance, max, &job.sub_job(0.2, 0.95))?;
    let after = composite.model.bridge_energies(&composite.points);
    let collapsed = composite.count_collapsed_films();
    let mut moved = composite.vertex_positions(surface.positions.len())?;
    surface.round_to_scalar(&mut moved, net.coordinates().scalar());
    job.step(1.0, "settle")?;
    // Nothing below can fail.
    surface.move_nodes(net, &moved);
    let displacements = moved.iter().zip(&surface.positions).map(|(p, q)| p.distance(*q));
    Ok(Settled {
        energy_before: energy_before * energy_unit,
        tension_energy: after.tension * energy_unit,
        elastic_energy: after.elastic * energy_unit,
        bending_energy: after.bending * energy_unit,
        residual_force: done.residual * force_unit,
        max_displacement: displacements.fold(0.0, f64::max) * surface.unit,
        iterations: done.iterations,
        settled: composite.settled_bridges,
        idle: composite.idle_bridges,
        collapsed,
        converged: done.converged && collapsed == 0,
    })
}

impl CompositeModel {
    /// Returns the number of films with a collapsed cell.
    fn count_collapsed_films(&self) -> u32 {
        let has_collapsed = |(quads, area): &&(std::ops::Range<usize>, f64)| {
            let least = MIN_RELATIVE_CELL_AREA * area / quads.len().max(1) as f64;
            let mut cells = self.model.quads[quads.clone()].iter();
            cells.any(|quad| quad.quad_area(&self.initial_points) >= least && quad.quad_area(&self.points) < least)
        };
        self.film_quads_and_areas.iter().filter(has_collapsed).count() as u32
    }

    /// Where all vertices of the net are.
    fn vertex_positions(&self, count: usize) -> Result<Vec<glam::DVec3>> {
        let mut moved = alloc::copied(&self.points[..count])?;
        for ((v, &start), &slot) in moved.iter_mut().zip(&self.initial_points).zip(&self.model.unknown_or_body_of_point)
        {
            if (BODY_SLOT_FLAG..NO_BODY).contains(&slot)
                && self.model.translation_unknown_of_body[(slot - BODY_SLOT_FLAG) as usize] != NO_BODY
            {
                *v = self.motion_of_body[(slot - BODY_SLOT_FLAG) as usize].apply(start);
            }
        }
        Ok(moved)
    }
}
