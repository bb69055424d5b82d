//! Descent steps of the energy.

use super::anderson::AndersonAcceleration;
use super::composite::{BridgeElements, CompositeModel};
use super::energy::{BridgeEnergies, BridgeLine};
use super::motion::RigidMotion;
use super::parts::{BODY_SLOT_FLAG, NO_BODY};
use super::rotate_bodies::rotate_bodies;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The maximum number of halvings of a step.
const MAX_STEP_HALVINGS: u32 = 30;
/// The relative rounding error of the energy.
const RELATIVE_ENERGY_ROUNDING: f64 = 1e-15;

/// The result of the descent.
pub(super) struct DescentResult {
    pub(super) iterations: u32,
    /// The largest force on an unknown.
    pub(super) residual: f64,
    pub(super) converged: bool,
}

/// Descends until a step is within the tolerance, or its gain is within the rounding of the energy.
pub(super) fn descend_to_equilibrium(
    composite: &mut CompositeModel,
    tolerance: f64,
    max_iterations: u32,
    job: &Job<'_>,
) -> Result<DescentResult> {
    let mut descent = DescentResult { iterations: 0, residual: 0.0, converged: composite.model.unknown_count == 0 };
    if descent.converged {
        return Ok(descent);
    }
    let model = &composite.model;
    let mut energy = model.bridge_energies(&composite.points).total_energy();
    let are_held = model.translation_unknown_of_body.iter().all(|&unknown| unknown == NO_BODY);
    let mut anderson = AndersonAcceleration::default();
    let at = |k: u32| 1.0 - 0.9f64.powi(k as i32);
    while !descent.converged && descent.iterations < max_iterations {
        let job = job.sub_job(at(descent.iterations), at(descent.iterations + 1));
        let (x, motions) = (&composite.points, &composite.motion_of_body);
        let terms = model.energy_terms(x)?;
        let gradient = model.gradient(&terms, x)?;
        let step = model.minimising_step(&terms, &gradient, &job)?;
        descent.iterations += 1;
        let Some(mut next) = halve_until_lower(composite, &step, energy, &job)? else {
            descent.converged = is_gain_within_rounding(composite, &step, &gradient, 1e3, energy);
            break;
        };
        let mut turned = (alloc::copied(&next.0)?, alloc::copied(&next.1)?);
        rotate_bodies(model, &terms, &mut turned.0, &mut turned.1);
        let after = model.bridge_energies(&turned.0).total_energy();
        if after <= next.2 {
            next = (turned.0, turned.1, after);
        }
        let largest = max_displacement(composite, x, motions, &next);
        let gained = energy - next.2;
        descent.converged = largest <= tolerance
            || (gained <= RELATIVE_ENERGY_ROUNDING * energy
                && is_gain_within_rounding(composite, &step, &gradient, 1.0, energy));
        if are_held && !descent.converged {
            let unknowns = current_unknowns(composite)?;
            if let Some(step) = anderson.accelerate_step(&unknowns, &step)? {
                let (x, motions) = model.displace_points(x, motions, &step, 1.0)?;
                let after = model.bridge_energies(&x).total_energy();
                if after < next.2 {
                    next = (x, motions, after);
                }
            }
        }
        (composite.points, composite.motion_of_body, energy) = next;
    }
    let terms = model.energy_terms(&composite.points)?;
    let forces = model.gradient(&terms, &composite.points)?;
    descent.residual = forces.iter().map(|force| force.length()).fold(0.0, f64::max);
    Ok(descent)
}

/// Returns true if the gain of a step is at most `roundings` rounding errors of the total energy.
/// Each bridge's gain must also be that small against its own energy. A much stiffer bridge could
/// hide it in the total.
fn is_gain_within_rounding(
    composite: &CompositeModel,
    step: &[DVec3],
    gradient: &[DVec3],
    roundings: f64,
    energy: f64,
) -> bool {
    let gain = |unknowns: Range<usize>| -> f64 {
        step[unknowns.clone()].iter().zip(&gradient[unknowns]).map(|(s, g)| -s.dot(*g)).sum()
    };
    let is_within = |gain: f64, energy: f64| gain <= roundings * RELATIVE_ENERGY_ROUNDING * energy;
    let energy_of = |share: &BridgeElements| {
        let (lines, quads) = (&composite.model.lines[share.lines.clone()], &composite.model.quads[share.quads.clone()]);
        let mut sum = BridgeEnergies::default();
        lines.iter().for_each(|line| line.add_energies(&composite.points, &mut sum));
        let films: f64 = quads.iter().map(|quad| quad.film_energy(&composite.points)).sum();
        sum.total_energy() + films + lines.iter().map(BridgeLine::spring_energy_scale).sum::<f64>()
    };
    is_within(gain(0..step.len()), energy)
        && composite.elements_of_bridges.iter().all(|share| is_within(gain(share.unknowns.clone()), energy_of(share)))
}

/// Returns the current unknowns.
fn current_unknowns(composite: &CompositeModel) -> Result<Vec<DVec3>> {
    let mut unknowns = alloc::filled(DVec3::ZERO, composite.model.unknown_count)?;
    for (&p, &slot) in composite
        .points
        .iter()
        .zip(&composite.model.unknown_or_body_of_point)
        .filter(|(_, slot)| **slot < BODY_SLOT_FLAG)
    {
        unknowns[slot as usize] = p;
    }
    Ok(unknowns)
}

/// Points, motions and their energy.
type DescentState = (Vec<DVec3>, Vec<RigidMotion>, f64);

/// Returns the state after the whole step, a half, a quarter and so on, once the energy is not
/// larger.
fn halve_until_lower(
    composite: &CompositeModel,
    step: &[DVec3],
    energy: f64,
    job: &Job<'_>,
) -> Result<Option<DescentState>> {
    let mut part = 1.0;
    for _ in 0..MAX_STEP_HALVINGS {
        job.sub_job(1.0, 1.0).step(0.0, "settle")?;
        let (x, motions) = composite.model.displace_points(&composite.points, &composite.motion_of_body, step, part)?;
        let after = composite.model.bridge_energies(&x).total_energy();
        if after <= energy * (1.0 + RELATIVE_ENERGY_ROUNDING) {
            return Ok(Some((x, motions, after)));
        }
        part /= 2.0;
    }
    Ok(None)
}

/// Returns the largest displacement of an unknown or of a point of a body.
fn max_displacement(composite: &CompositeModel, x: &[DVec3], motions: &[RigidMotion], next: &DescentState) -> f64 {
    let own = composite
        .model
        .unknown_or_body_of_point
        .iter()
        .zip(x.iter().zip(&next.0))
        .filter(|(slot, _)| **slot < BODY_SLOT_FLAG);
    let own = own.map(|(_, (p, q))| p.distance(*q)).fold(0.0, f64::max);
    let carried =
        composite.model.carried_points_and_positions.iter().map(|&(p, _)| x[p as usize].distance(next.0[p as usize]));
    let shifts = motions.iter().zip(&next.1).map(|(a, b)| a.translation.distance(b.translation));
    carried.chain(shifts).fold(own, f64::max)
}
