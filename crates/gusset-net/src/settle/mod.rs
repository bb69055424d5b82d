//! The equilibrium of a composite net: bridges under tension, elasticity and stiffness (Deryagin,
//! "Concatenation", Fig. 9: a bridge "can be given physical properties").
//!
//! The inner nodes of whole bridges, and parts that are free, each as a rigid body, move to where
//! the sum of these energies is least. Lines run across a bridge, N links each; glued lines count
//! once.
//!
//! | property | energy |
//! |---|---|
//! | tension T of a thread or ribbon | T times the root of N times the sum of the squared lengths
//! of links, for each line: T times its length once its nodes are evenly spaced, which they become
//! | | tension T of a tube | T times the area of its film, that of a cell being the mean of both
//! triangulations | | elasticity Y | Y / 2 (l - r)^2 / r for each link of length l and rest length
//! r across | | stiffness B | B / 2 h^3 times the sum of squared second differences along each
//! line, and 2 (p1 - p0 - h d)^2 at each end, h being the mean rest length of its links and d the
//! direction of the part's last link |
//!
//! The film of a ribbon would have free edges, and none is in equilibrium but one of no area: its
//! tension acts in its lines. A bridge of infinite stiffness is one body with both its sides.
//! Hidden bridges have no force, welded ones have no inner nodes and make one body of two.
//!
//! Each step goes to the minimum of a sum of squares that is nowhere below the energy and touches
//! it where the net is: force densities (H.-J. Schek, *The force density method for form finding*,
//! 1974), for films with the cotangents of U. Pinkall and K. Polthier (*Computing discrete minimal
//! surfaces*, 1993), which are the natural force densities of R. Pauletti and P. Pimenta (2008).
//! Bodies are translated with the nodes and then rotated each by itself. Where all parts are held,
//! steps are accelerated (`anderson`) if that lowers the energy further. So it never grows;
//! convergence is linear, and slow for films near the limit of stability. O(n^1.5) operations and
//! O(n log n) memory for n inner nodes a step. One thread: the same bits always.

mod anderson;
mod bodies;
mod build;
mod descent;
mod energy;
mod energy_model;
mod motion;
mod parts;
mod settle_options;
mod term;

use super::Net;
use super::planarise::PlanariseOptions;
use super::planarise::net_vertices::Surface;
use build::{Composite, build};
use descent::descend;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use parts::{BODY, NOWHERE, Parts};
pub use settle_options::SettleOptions;

/// What was done to a net. Energies are in units of force times length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Settled {
    /// The energy before, rigid bridges in their shape.
    pub energy_before: f64,
    /// The energy of tension now.
    pub tension_energy: f64,
    /// The energy of springs now.
    pub elastic_energy: f64,
    /// The energy of bending now.
    pub bending_energy: f64,
    /// The largest force on an inner vertex or a free body now.
    pub residual_force: f64,
    /// The largest displacement of a vertex.
    pub max_displacement: f64,
    /// The steps taken.
    pub iterations: u32,
    /// The whole bridges that have a force.
    pub settled: u32,
    /// The whole bridges without: hidden or welded ones, and those whose properties are all 0.
    pub idle: u32,
    /// The films that have collapsed: to less than a millionth of their area in places.
    pub collapsed: u32,
    /// True if the last step was within the tolerance, or too small to lower the energy, and no
    /// film has collapsed.
    pub converged: bool,
}

/// The steps unless options say otherwise.
const DEFAULT_ITERATIONS: u32 = 1000;
/// The tolerance unless options say otherwise.
const DEFAULT_TOLERANCE: f64 = 1e-12;
/// A cell of a film with less than this part of the mean area before has collapsed.
const COLLAPSED: f64 = 1e-6;

/// Moves the inner nodes of the whole bridges of a net, and its free parts, to equilibrium.
///
/// Whole bridges run from side to side; those count whose direction is that of the last. If of
/// parts that bridges join none is held, the first is. Lines with a missing node have no force, and
/// links without a rest length no elasticity. A step that does not converge is told by the result.
///
/// # Errors
/// [`Error::BadProperty`], [`Error::OptionOutOfRange`] for the tolerance and the ratio,
/// [`Error::ArrayTooShort`] for flags of some parts only, [`Error::SidesDiffer`] for a reference of
/// another size, [`Error::NoSuch`] for bridges that overlap or leave the net, [`Error::OutOfMemory`],
/// [`Error::Cancelled`]. The net is then unchanged.
pub fn settle(net: &mut Net<'_>, options: &SettleOptions<'_>, job: &Job<'_>) -> Result<Settled> {
    let (tolerance, ratio) = (options.tolerance, options.rest_ratio);
    Error::require(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", tolerance)?;
    Error::require(ratio >= 0.0 && ratio.is_finite(), "rest ratio", ratio)?;
    if let Some(reference) = options.reference.filter(|reference| reference.shape() != net.shape()) {
        let [a, b] = [net.shape(), reference.shape()].map(|shape| shape.node_count() as u32);
        return Err(Error::SidesDiffer { a, b });
    }
    job.step(0.0, "settle")?;
    let mut parts = Parts::of(net, options)?;
    let surface = Surface::of(net, &PlanariseOptions::default(), &job.part(0.0, 0.1))?;
    let slots = parts.unite(net, &surface.classes, &job.part(0.1, 0.15))?;
    let mut composite = build(net, options, (&parts, &surface, slots), &job.part(0.15, 0.2))?;
    let tolerance = if tolerance == 0.0 { DEFAULT_TOLERANCE } else { tolerance } * surface.size;
    let max = if options.max_iterations == 0 { DEFAULT_ITERATIONS } else { options.max_iterations };
    let [energy_unit, force_unit] = composite.energy_unit;
    let energy_before = composite.model.energies(&composite.points).sum();
    let done = descend(&mut composite, tolerance, max, &job.part(0.2, 0.95))?;
    let after = composite.model.energies(&composite.points);
    let collapsed = composite.collapsed();
    let mut moved = composite.positions(surface.positions.len())?;
    surface.round(&mut moved, net.coordinates().scalar());
    job.step(1.0, "settle")?;
    // Nothing can fail any more.
    surface.write(net, &moved);
    let displacements = moved.iter().zip(&surface.positions).map(|(p, q)| p.distance(*q));
    Ok(Settled {
        energy_before: energy_before * energy_unit,
        tension_energy: after.tension * energy_unit,
        elastic_energy: after.elastic * energy_unit,
        bending_energy: after.bending * energy_unit,
        residual_force: done.residual * force_unit,
        max_displacement: displacements.fold(0.0, f64::max) * surface.unit,
        iterations: done.iterations,
        settled: composite.settled,
        idle: composite.idle,
        collapsed,
        converged: done.converged && collapsed == 0,
    })
}

impl Composite {
    /// The films of which a cell has collapsed.
    fn collapsed(&self) -> u32 {
        let has_collapsed = |(quads, area): &&(std::ops::Range<usize>, f64)| {
            let least = COLLAPSED * area / quads.len().max(1) as f64;
            let mut cells = self.model.quads[quads.clone()].iter();
            cells.any(|quad| quad.area(&self.start) >= least && quad.area(&self.points) < least)
        };
        self.films.iter().filter(has_collapsed).count() as u32
    }

    /// Where all vertices of the net are.
    fn positions(&self, count: usize) -> Result<Vec<glam::DVec3>> {
        let mut moved = alloc::copied(&self.points[..count])?;
        for ((v, &start), &slot) in moved.iter_mut().zip(&self.start).zip(&self.model.slots) {
            if (BODY..NOWHERE).contains(&slot) && self.model.translations[(slot - BODY) as usize] != NOWHERE {
                *v = self.motions[(slot - BODY) as usize].apply(start);
            }
        }
        Ok(moved)
    }
}
