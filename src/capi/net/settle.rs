//! Bridges at rest: Settles bridges under tension, elasticity and stiffness.

use crate::capi::context::{answer_into_struct, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, read_flag};
use crate::capi::net::{gusset_net, net_of_handle, net_of_handle_mut};
use crate::capi::status::gusset_status;
use crate::net::settle::{SettleOptions, settle};
use gusset_base::alloc;

/// Options of gusset_net_settle.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_settle_options {
    /// sizeof(gusset_settle_options).
    pub struct_size: usize,
    /// Largest displacement in the last step, relative to the box diagonal; 0: 1e-12.
    pub tolerance: f64,
    /// Ratio of rest lengths to lengths in the reference, above 0; 0: 1.
    pub rest_ratio: f64,
    /// Net of equal size for rest lengths and shapes of rigid bridges; NULL: itself.
    pub reference: *const gusset_net,
    /// For each part between bridges: 1 moves it as a rigid body, 0 holds it. NULL holds all.
    /// @shape free_count
    /// @flag
    pub free: *const u8,
    /// At least the number of parts; 0 with NULL.
    pub free_count: usize,
    /// Most steps; 0: 1000.
    pub max_iterations: u32,
    /// 0.
    pub reserved: u32,
}

/// Result of gusset_net_settle. Energies are forces times lengths.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_settle_report {
    /// sizeof(gusset_settle_report).
    pub struct_size: usize,
    /// Initial energy, rigid bridges in shape.
    pub energy_before: f64,
    /// Final energy of tension.
    pub tension_energy: f64,
    /// Final energy of elasticity.
    pub elastic_energy: f64,
    /// Final energy of bending.
    pub bending_energy: f64,
    /// Largest final force on an inner point or free body.
    pub residual_force: f64,
    /// Largest displacement of a point.
    pub max_displacement: f64,
    /// Steps.
    pub iterations: u32,
    /// Counted bridges with forces.
    pub settled: u32,
    /// Counted bridges without forces, whose nodes stay: hidden, welded, or with properties 0.
    pub idle: u32,
    /// Films with a cell below 1e-6 of the initial mean cell area.
    pub collapsed: u32,
    /// 1: no film collapsed, and the last step met the tolerance or was too small to lower the
    /// energy.
    /// @flag
    pub converged: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_settle_options: 56 reserved, gusset_settle_report: 80 }

/// Moves inner nodes of bridges, and free parts, to equilibrium.
///
/// Only bridges from side to side count, in the direction of the last. A bridge of infinite
/// stiffness and its sides are a rigid body. If connected parts lack a held one, the first is held.
///
/// The result is a local minimum of the sum of energies; no step increases it. Energies of a line
/// across a bridge:
///
/// - tension times its length, with evenly spaced nodes; in a tube, times the film's area.
/// - elasticity / 2 (l - r)^2 / r a link of length l and rest length r.
/// - stiffness / 2 h^3 times squared second differences, h the mean rest length. Lines leave parts
///   in their direction.
///
/// @errors COUNT_DIFFERS (free_count too small), SIDES_DIFFER (reference's size), OUT_OF_RANGE
///     (tolerance, rest_ratio; property negative, NaN or infinite, by bridge), NO_SUCH_ELEMENT
///     (overlapping bridges)
/// @complexity O(nodes), and O(n^1.5) time a step and O(n log n) memory for n inner nodes.
/// @threads Uses one thread.
/// @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_settle(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_settle_options,
    report: *mut gusset_settle_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let given = input::read_versioned_struct(options, true, "options")?;
        // The reference may be the net itself.
        let reference = if given.reference.is_null() { None } else { Some(net_of_handle(given.reference)?.copied()?) };
        let bytes = input::input_bytes(given.free.cast(), given.free_count, 1, "free")?;
        let free: Vec<bool> = alloc::try_collect(bytes.iter().map(|&byte| read_flag(byte.into(), "free")))?;
        let options = SettleOptions {
            tolerance: given.tolerance,
            max_iterations: given.max_iterations,
            rest_ratio: given.rest_ratio,
            reference: reference.as_ref(),
            free: &free,
        };
        let done = settle(net_of_handle_mut(net, job)?, &options, job)?;
        Ok(gusset_settle_report {
            struct_size: 0,
            energy_before: done.energy_before,
            tension_energy: done.tension_energy,
            elastic_energy: done.elastic_energy,
            bending_energy: done.bending_energy,
            residual_force: done.residual_force,
            max_displacement: done.max_displacement,
            iterations: done.iterations,
            settled: done.settled,
            idle: done.idle,
            collapsed: done.collapsed,
            converged: done.converged.into(),
            reserved: 0,
        })
    })
}
