//! Bridges at rest: Settles bridges under tension, elasticity and stiffness.

use crate::capi::context::{answer_struct, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::net::{edit, gusset_net, read};
use crate::capi::status::gusset_status;
use crate::net::settle::{SettleOptions, settle};
use gusset_base::alloc;

/// How gusset_net_settle works. All zeros: the defaults.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_settle_options {
    /// sizeof(gusset_settle_options), set by the caller.
    pub struct_size: usize,
    /// The displacement below which a step is the last, as a part of the diagonal of the net's box;
    /// 0: 1e-12.
    pub tolerance: f64,
    /// Rest lengths as a multiple of those in the reference, above 0; 0: 1.
    pub rest_ratio: f64,
    /// The net at rest, of the same size, which gives rest lengths and the shape of rigid bridges;
    /// NULL: the net as it is given.
    pub reference: *const gusset_net,
    /// A byte for each part, the nets between the bridges that run from side to side, in their
    /// order: 1 for one that moves, as a rigid body, and 0 for one that is held; NULL: all are
    /// held.
    pub free: *const u8,
    /// The number of bytes: bridges + 1 at least; 0 with NULL.
    pub free_count: usize,
    /// The largest number of steps; 0: 1000.
    pub max_iterations: u32,
    /// 0.
    pub reserved: u32,
}

/// What gusset_net_settle has done. Energies are force times length, in the units of the properties
/// and the coordinates.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_settle_report {
    /// sizeof(gusset_settle_report), set by the caller.
    pub struct_size: usize,
    /// The energy before, rigid bridges in their shape.
    pub energy_before: f64,
    /// The energy of tension now.
    pub tension_energy: f64,
    /// The energy of springs now.
    pub elastic_energy: f64,
    /// The energy of bending now.
    pub bending_energy: f64,
    /// The largest force on an inner point or a free body now.
    pub residual_force: f64,
    /// The largest displacement of a point.
    pub max_displacement: f64,
    /// The steps that were taken.
    pub iterations: u32,
    /// The bridges from side to side that have a force.
    pub settled: u32,
    /// Those without: hidden or welded ones, and those whose properties are all 0; their nodes
    /// stay.
    pub idle: u32,
    /// The films that have collapsed: to less than a millionth of their area in places.
    pub collapsed: u32,
    /// 1 if the last step was within the tolerance, or too small to lower the energy, and no film
    /// has collapsed; else 0, and the net is as near as the steps came.
    pub converged: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_settle_options: 56 reserved, gusset_settle_report: 80 }

/// Moves the nodes of bridges that are their own, and parts that are free, to the equilibrium of
/// the bridges' properties.
///
/// The sum of these energies becomes least, for each line of links across a bridge: tension times
/// its length, its nodes becoming evenly spaced, or in a tube times the area of the film;
/// elasticity / 2 (l - r)^2 / r for each link of length l and rest length r; stiffness / 2 h^3
/// times the squared second differences, h being the mean rest length, lines leaving parts in the
/// direction of these. A bridge of infinite stiffness and both its sides are one body. Bridges
/// within a part do not count, nor do those across the direction of the last. If of parts that
/// bridges join none is held, the first is. What is found is a local minimum, and the energy never
/// grows on the way.
///
/// @param report receives what was done, its struct_size set; that the steps did not converge is no
///     error.
/// @errors UNKNOWN_VALUE (a byte of free), SIZE_OVERFLOW (free_count is too small), SIDES_DIFFER
///     (the reference has another size), OUT_OF_RANGE (tolerance, rest_ratio; a property that is
///     negative, NaN or infinite, with the bridge), NO_SUCH_ELEMENT (a bridge lies within another,
///     the net is then unchanged)
/// @complexity For each step O(n^1.5) operations and O(n log n) memory for n inner nodes, and
///     O(nodes).
/// @threads One thread; the same bits always.
/// @source Deryagin, "Concatenation"; Schek 1974; Pinkall and Polthier 1993.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_settle(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_settle_options,
    report: *mut gusset_settle_report,
) -> gusset_status {
    answer_struct(context, (report, "report"), |job| {
        let given = input::read(options, true, "options")?;
        // The reference may be the net itself.
        let reference = if given.reference.is_null() { None } else { Some(read(given.reference)?.copied()?) };
        let bytes = input::bytes(given.free.cast(), given.free_count, 1, "free")?;
        let free: Vec<bool> = alloc::try_collect(bytes.iter().map(|&byte| flag(byte.into(), "free")))?;
        let options = SettleOptions {
            tolerance: given.tolerance,
            max_iterations: given.max_iterations,
            rest_ratio: given.rest_ratio,
            reference: reference.as_ref(),
            free: &free,
        };
        let done = settle(edit(net, job)?, &options, job)?;
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
