//! Descent steps of the energy.

use super::anderson::Anderson;
use super::bodies::rotate;
use super::build::{Composite, Share};
use super::energy::{Energies, Line};
use super::motion::Motion;
use super::parts::{BODY, NOWHERE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The maximum number of halvings of a step.
const MAX_HALVINGS: u32 = 30;
/// The relative rounding error of the energy.
const ROUNDING: f64 = 1e-15;

/// The result of the descent.
pub(super) struct Descent {
    pub(super) iterations: u32,
    /// The largest force on an unknown.
    pub(super) residual: f64,
    pub(super) converged: bool,
}

/// Descends until a step is within the tolerance, or its gain is within the rounding of the energy.
pub(super) fn descend(composite: &mut Composite, tolerance: f64, max: u32, job: &Job<'_>) -> Result<Descent> {
    let mut descent = Descent { iterations: 0, residual: 0.0, converged: composite.model.unknowns == 0 };
    if descent.converged {
        return Ok(descent);
    }
    let model = &composite.model;
    let mut energy = model.energies(&composite.points).sum();
    let are_held = model.translations.iter().all(|&unknown| unknown == NOWHERE);
    let mut anderson = Anderson::default();
    let at = |k: u32| 1.0 - 0.9f64.powi(k as i32);
    while !descent.converged && descent.iterations < max {
        let job = job.part(at(descent.iterations), at(descent.iterations + 1));
        let (x, motions) = (&composite.points, &composite.motions);
        let terms = model.terms(x)?;
        let gradient = model.gradient(&terms, x)?;
        let step = model.step(&terms, &gradient, &job)?;
        descent.iterations += 1;
        let Some(mut next) = lower(composite, &step, energy, &job)? else {
            descent.converged = is_rounding(composite, &step, &gradient, 1e3, energy);
            break;
        };
        let mut turned = (alloc::copied(&next.0)?, alloc::copied(&next.1)?);
        rotate(model, &terms, &mut turned.0, &mut turned.1);
        let after = model.energies(&turned.0).sum();
        if after <= next.2 {
            next = (turned.0, turned.1, after);
        }
        let largest = largest(composite, x, motions, &next);
        let gained = energy - next.2;
        descent.converged = largest <= tolerance
            || (gained <= ROUNDING * energy && is_rounding(composite, &step, &gradient, 1.0, energy));
        if are_held && !descent.converged {
            let unknowns = unknowns(composite)?;
            if let Some(step) = anderson.accelerated(&unknowns, &step)? {
                let (x, motions) = model.displace(x, motions, &step, 1.0)?;
                let after = model.energies(&x).sum();
                if after < next.2 {
                    next = (x, motions, after);
                }
            }
        }
        (composite.points, composite.motions, energy) = next;
    }
    let terms = model.terms(&composite.points)?;
    let forces = model.gradient(&terms, &composite.points)?;
    descent.residual = forces.iter().map(|force| force.length()).fold(0.0, f64::max);
    Ok(descent)
}

/// Returns true if the gain of a step is within a number of roundings of the total energy and of
/// each bridge's own energy. Next to a much stiffer bridge, another bridge's whole energy may be
/// rounding.
fn is_rounding(composite: &Composite, step: &[DVec3], gradient: &[DVec3], roundings: f64, energy: f64) -> bool {
    let gain = |unknowns: Range<usize>| -> f64 {
        step[unknowns.clone()].iter().zip(&gradient[unknowns]).map(|(s, g)| -s.dot(*g)).sum()
    };
    let is_within = |gain: f64, energy: f64| gain <= roundings * ROUNDING * energy;
    let energy_of = |share: &Share| {
        let (lines, quads) = (&composite.model.lines[share.lines.clone()], &composite.model.quads[share.quads.clone()]);
        let mut sum = Energies::default();
        lines.iter().for_each(|line| line.add_energies(&composite.points, &mut sum));
        let films: f64 = quads.iter().map(|quad| quad.energy(&composite.points)).sum();
        sum.sum() + films + lines.iter().map(Line::spring_scale).sum::<f64>()
    };
    is_within(gain(0..step.len()), energy)
        && composite.shares.iter().all(|share| is_within(gain(share.unknowns.clone()), energy_of(share)))
}

/// Returns the current unknowns.
fn unknowns(composite: &Composite) -> Result<Vec<DVec3>> {
    let mut unknowns = alloc::filled(DVec3::ZERO, composite.model.unknowns)?;
    for (&p, &slot) in composite.points.iter().zip(&composite.model.slots).filter(|(_, slot)| **slot < BODY) {
        unknowns[slot as usize] = p;
    }
    Ok(unknowns)
}

/// Points, motions and their energy.
type State = (Vec<DVec3>, Vec<Motion>, f64);

/// Returns the state after the whole step, a half, a quarter and so on, once the energy is not
/// larger.
fn lower(composite: &Composite, step: &[DVec3], energy: f64, job: &Job<'_>) -> Result<Option<State>> {
    let mut part = 1.0;
    for _ in 0..MAX_HALVINGS {
        job.part(1.0, 1.0).step(0.0, "settle")?;
        let (x, motions) = composite.model.displace(&composite.points, &composite.motions, step, part)?;
        let after = composite.model.energies(&x).sum();
        if after <= energy * (1.0 + ROUNDING) {
            return Ok(Some((x, motions, after)));
        }
        part /= 2.0;
    }
    Ok(None)
}

/// Returns the largest displacement of an unknown or of a point of a body.
fn largest(composite: &Composite, x: &[DVec3], motions: &[Motion], next: &State) -> f64 {
    let own = composite.model.slots.iter().zip(x.iter().zip(&next.0)).filter(|(slot, _)| **slot < BODY);
    let own = own.map(|(_, (p, q))| p.distance(*q)).fold(0.0, f64::max);
    let carried = composite.model.carried.iter().map(|&(p, _)| x[p as usize].distance(next.0[p as usize]));
    let shifts = motions.iter().zip(&next.1).map(|(a, b)| a.translation.distance(b.translation));
    carried.chain(shifts).fold(own, f64::max)
}
