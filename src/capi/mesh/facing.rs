//! Facing arcs: Finds facing vertices of two loops.
//!
//! @source Nesterenko, algorithm 2.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, fill_buffer, lend_list, read_choice};
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::stitch_options::{gusset_centres, gusset_facing_run, gusset_tolerance_mode, to_tolerance};
use crate::capi::status::{Failure, gusset_status};
use crate::error::{Allowed, Error};
use crate::mesh::MAX_ELEMENTS;
use crate::stitch::facing::{Arc, Facing, Options, facing};
use crate::stitch::meridian::index_rule::index_rule;
use glam::DVec3;
use gusset_base::alloc;
use std::ptr;

/// Facing vertices of two loops.
pub struct gusset_facing {
    facing: Facing,
    runs: [Vec<[u32; 2]>; 2],
}

handle! { gusset_facing }

/// Options of gusset_facing_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_facing_options {
    /// sizeof(gusset_facing_options).
    pub struct_size: usize,
    /// Choice among runs of facing vertices.
    pub run: gusset_facing_run,
    /// Source of the tolerance.
    pub tolerance_mode: gusset_tolerance_mode,
    /// As in gusset_stitch_options.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// Centre of a loop.
    pub centres: gusset_centres,
    /// 0.
    pub reserved: u32,
}

/// Facing vertices; index 0 is loop A, 1 is loop B.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_facing_view {
    /// sizeof(gusset_facing_view).
    pub struct_size: usize,
    /// Centres C_1 and C_2, equation 5.
    pub centre: [[f64; 3]; 2],
    /// Normals C_2 - C_1 and C_1 - C_2 of the planes, equations 6 and 7.
    pub normal: [[f64; 3]; 2],
    /// Signed distance of each vertex from its plane, positive towards the other loop.
    /// @shape counts
    pub distances: [*const f64; 2],
    /// First index and length of each run of facing vertices, alternating; runs may pass the loop's
    /// end.
    /// @shape * 2
    pub runs: [gusset_indices; 2],
    /// The chosen run, as arc_a and arc_b of gusset_stitch_options.
    pub taken: [[u32; 2]; 2],
    /// Vertices of each loop.
    pub counts: [usize; 2],
}

versioned! { gusset_facing_options: 24 reserved, gusset_facing_view: 184 }

impl gusset_facing_options {
    fn checked(self) -> Result<Options, Failure> {
        let tolerance = to_tolerance(self.tolerance_mode, self.tolerance)?;
        Ok(Options { run: read_choice(self.run)?, tolerance, centres: read_choice(self.centres)? })
    }
}

/// Returns the first place of a run, and its number of vertices.
fn first_and_count(arc: &Arc) -> [u32; 2] {
    [arc.first as u32, arc.count as u32]
}

/// Reads the caller's packed points.
pub(crate) fn read_loop_points(data: *const f64, count: usize, name: &'static str) -> Result<Vec<DVec3>, Failure> {
    Error::check_count(name, count as u64, MAX_ELEMENTS)?;
    Ok(alloc::collect(input::input_items(data.cast(), count, name)?.map(DVec3::from_array))?)
}

/// Finds the vertices of two loops that face each other.
///
/// @param points_a count_a vertices in order, at least 1.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (the centres
///     coincide, or no vertex of a loop exceeds the tolerance)
/// @complexity O((N + M) log M).
/// @source Nesterenko, algorithm 2, equations 5-7.
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
    create_handle(context, facing, "facing", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let a = read_loop_points(points_a, count_a, "points_a")?;
        let b = read_loop_points(points_b, count_b, "points_b").map_err(|failure| failure.with_input(1))?;
        let found = self::facing(&a, &b, &options, job)?;
        let pairs = |arcs: &[Arc]| alloc::collect(arcs.iter().map(first_and_count));
        let runs = [pairs(&found.runs[0])?, pairs(&found.runs[1])?];
        Ok(gusset_facing { facing: found, runs })
    })
}

/// Destroys facing vertices.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_facing_destroy(facing: *mut gusset_facing) {
    handle::destroy(facing);
}

/// Lends the facing vertices.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_facing_get_view(
    facing: *const gusset_facing,
    view: *mut gusset_facing_view,
) -> gusset_status {
    lend!(facing, view, |gusset_facing { facing: found, runs }| gusset_facing_view {
        struct_size: size_of::<gusset_facing_view>(),
        centre: found.planes.centres.map(|c| c.to_array()),
        normal: found.planes.normals.map(|n| n.to_array()),
        distances: found.distances.each_ref().map(|list| lend_list(list)),
        runs: runs.each_ref().map(|list| gusset_indices::lend_indices(list.as_flattened())),
        taken: found.taken.each_ref().map(first_and_count),
        counts: found.distances.each_ref().map(Vec::len),
    })
}

/// Computes GUSSET_MERIDIANS_INDEX. For each i = 0 .. n, j of 0 .. m makes |m i - n j| least; on
/// ties the later one.
///
/// @param n segments of the longer polyline: N - 1 if open with N vertices, N if closed.
/// @param m segments of the other polyline, at most n (OUT_OF_RANGE).
/// @param j receives n + 1 numbers.
/// @param written receives the count.
/// @errors OUT_OF_RANGE, BUFFER_TOO_SMALL
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_meridians_index(
    n: u32,
    m: u32,
    j: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    guard_changing_call(ptr::null(), |job| {
        let written = input::cleared_output(written, 0, "written")?;
        if m > n {
            return Err(
                Error::OptionOutOfRange { option: "m", value: m.into(), allowed: Allowed::AtMost(n.into()) }.into()
            );
        }
        fill_buffer((j, capacity, "j"), n as usize + 1, written, job, || Ok(index_rule(n, m)))
    })
}
