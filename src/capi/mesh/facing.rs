//! Facing arcs: Finds which vertices of two loops face each other.
//!
//! @source Nesterenko, algorithm 2.

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, fill, lent};
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::stitch_options::{gusset_centres, gusset_facing_run, gusset_tolerance_mode, tolerance};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::stitch::facing::{Arc, Facing, Options, facing};
use crate::stitch::meridian::index_rule::index_rule;
use glam::DVec3;
use gusset_base::alloc;
use std::ptr;

/// Which vertices of two loops face each other. Opaque and immutable; it keeps nothing of the
/// points.
pub struct gusset_facing {
    found: Facing,
    runs: [Vec<[u32; 2]>; 2],
}

handle! { gusset_facing }

/// How facing vertices are found; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_facing_options {
    /// sizeof(gusset_facing_options), set by the caller.
    pub struct_size: usize,
    /// Which of several runs of facing vertices is joined.
    pub run: gusset_facing_run,
    /// The source of a tolerance.
    pub tolerance_mode: gusset_tolerance_mode,
    /// How far a vertex must be from its loop's plane, in the unit of the points, at least 0; read
    /// for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// The definition of the centre of a loop.
    pub centres: gusset_centres,
    /// 0.
    pub reserved: u32,
}

/// What algorithm 2 found. Index 0 is loop A, 1 is loop B. Pointers are valid until the handle is
/// destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_facing_view {
    /// sizeof(gusset_facing_view), set by the caller.
    pub struct_size: usize,
    /// The centres C_1 and C_2 (5): x, y, z of each.
    pub centre: [[f64; 3]; 2],
    /// The vectors C_2 - C_1 and C_1 - C_2 (6), the normals of the planes (7).
    pub normal: [[f64; 3]; 2],
    /// The distance of each vertex from its loop's plane, positive on the side of the other loop;
    /// as many as the loop has.
    pub distances: [*const f64; 2],
    /// All runs of facing vertices: first place and number of vertices, by turns; a run may pass
    /// the loop's end.
    pub runs: [gusset_indices; 2],
    /// The run taken: first place and number of vertices, as gusset_stitch_options takes them in
    /// arc_a and arc_b.
    pub taken: [[u32; 2]; 2],
}

versioned! { gusset_facing_options: 24 reserved, gusset_facing_view: 168 }

impl gusset_facing_options {
    fn checked(self) -> Result<Options, Failure> {
        let tolerance = tolerance(self.tolerance_mode, self.tolerance)?;
        Ok(Options { run: choice(self.run)?, tolerance, centres: choice(self.centres)? })
    }
}

/// The first place of a run, and its number of vertices.
fn pair(arc: &Arc) -> [u32; 2] {
    [arc.first as u32, arc.count as u32]
}

/// Packed points of the caller's.
pub(crate) fn points(data: *const f64, count: usize, name: &'static str) -> Result<Vec<DVec3>, Failure> {
    Error::check_count(name, count as u64, MAX_ELEMENTS)?;
    Ok(alloc::collect(input::items(data.cast(), count, name)?.map(DVec3::from_array))?)
}

/// Finds which vertices of two loops face each other.
///
/// @param points_a x, y, z of the vertices of each loop in order, packed, count_a and count_b of
///     them, at least 1 each.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (no vertex of a
///     loop is beyond the tolerance, as with coaxial rims, or the centres coincide)
/// @complexity O((N + M) log M); linear extra memory.
/// @source Nesterenko, algorithm 2, equations 5-7, with a tolerance, and runs instead of subsets.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_facing_create(
    context: *const gusset_context,
    points_a: *const f64,
    count_a: usize,
    points_b: *const f64,
    count_b: usize,
    options: *const gusset_facing_options,
    facing: *mut *mut gusset_facing,
) -> gusset_status {
    create(context, facing, "facing", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let a = points(points_a, count_a, "points_a")?;
        let b = points(points_b, count_b, "points_b").map_err(|failure| failure.of_input(1))?;
        let found = self::facing(&a, &b, &options, job)?;
        let pairs = |arcs: &[Arc]| alloc::collect(arcs.iter().map(pair));
        let runs = [pairs(&found.runs[0])?, pairs(&found.runs[1])?];
        Ok(gusset_facing { found, runs })
    })
}

/// Destroys what gusset_facing_create made; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_facing_destroy(facing: *mut gusset_facing) {
    handle::destroy(facing);
}

/// Lends what was found.
///
/// @param facing what was found.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_facing_get_view(
    facing: *const gusset_facing,
    view: *mut gusset_facing_view,
) -> gusset_status {
    lend!(facing, view, |gusset_facing { found, runs }| gusset_facing_view {
        struct_size: size_of::<gusset_facing_view>(),
        centre: found.planes.centres.map(|c| c.to_array()),
        normal: found.planes.normals.map(|n| n.to_array()),
        distances: found.distances.each_ref().map(|list| lent(list)),
        runs: runs.each_ref().map(|list| gusset_indices::lend(list.as_flattened())),
        taken: found.taken.each_ref().map(pair),
    })
}

/// The paper's rule for meridians: for each i = 0 .. n the j = 0 .. m that makes |m i - n j| least,
/// of two equal ones the later.
///
/// @param n segments of the longer and of the other polyline, m <= n (OUT_OF_RANGE): an open one of
///     N vertices has N - 1, a closed one N.
/// @param m see n.
/// @param j receives n + 1 numbers; NULL with capacity 0 asks for how many.
/// @param capacity of j.
/// @param written receives their number; may not be NULL.
/// @errors OUT_OF_RANGE, BUFFER_TOO_SMALL (nothing but the number is written)
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)), without the products.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_meridians_index(
    n: u32,
    m: u32,
    j: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    guard_change(ptr::null(), |job| {
        let written = input::output(written, 0, "written")?;
        if m > n {
            return Err(Error::OptionOutOfRange { option: "m", value: m.into() }.into());
        }
        fill((j, capacity, "j"), n as usize + 1, written, job, || Ok(index_rule(n, m)))
    })
}
