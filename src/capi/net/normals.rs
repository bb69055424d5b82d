//! Normals: Unit normals, exact at poles and seams.

use crate::capi::context::{answer_into_optional_output, gusset_context};
use crate::capi::input;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::gusset_status::{GUSSET_ERROR_BUFFER_TOO_SMALL, GUSSET_ERROR_OVERLAP};
use crate::capi::status::{Failure, gusset_status};
use crate::mesh::Scalar;
use crate::net::normals::normals_into;
use crate::net::{Coordinates, Net, Real, XyzMatrices, each};
use std::ffi::c_void;

/// Returns the caller's buffers as matrices of the net's size.
fn matrices_of_buffers<T: Real>(
    net: &Net<'_>,
    buffers: [*mut c_void; 3],
    capacity: usize,
) -> Result<XyzMatrices<'static, T>, Failure> {
    let count = net.shape().node_count();
    if capacity < count {
        let message = format!("x, y and z have room for {capacity} numbers; they need room for {count}");
        return Err(Failure { value: count as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    check_no_overlap(net, buffers, count * size_of::<T>())?;
    let [x, y, z] = buffers.map(<*mut c_void>::cast::<T>);
    let matrices = [
        input::result_buffer(x, count, "x")?,
        input::result_buffer(y, count, "y")?,
        input::result_buffer(z, count, "z")?,
    ];
    Ok(XyzMatrices::borrowed(net.shape(), 0, matrices)?)
}

/// Checks that the buffers do not overlap each other or the coordinates, which may have been lent
/// to the host.
fn check_no_overlap(net: &Net<'_>, buffers: [*mut c_void; 3], bytes: usize) -> Result<(), Failure> {
    let ranges: [(usize, usize); 3] = each!(net.coordinates(), planes => {
        planes.matrices().map(|matrix| (matrix.as_ptr() as usize, size_of_val(matrix)))
    });
    let own = buffers.map(|start| (start as usize, bytes));
    let apart = |(a, length_a): (usize, usize), (b, length_b): (usize, usize)| {
        a.saturating_add(length_a) <= b || b.saturating_add(length_b) <= a
    };
    let good = (0..3).all(|k| apart(own[k], own[(k + 1) % 3]) && ranges.iter().all(|&range| apart(own[k], range)));
    let is_null = buffers.iter().any(|start| start.is_null());
    if good || is_null {
        Ok(())
    } else {
        Err(Failure::new(GUSSET_ERROR_OVERLAP, "x, y, z and the net overlap; pass separate arrays"))
    }
}

/// Computes the unit normal of every node.
///
/// Directions are as in gusset_net_view, opposite if reversed. All cells at a glued point give its
/// nodes one normal, equal in bits. Absent cells do not count.
///
/// @param x receives x: rows x columns aligned numbers of the net's scalar type. Buffers must not
///     overlap each other or the net.
/// @param y receives y.
/// @param z receives z.
/// @param capacity numbers in each.
/// @param missing_count receives the number of nodes without a normal, which get 0: missing, or
///     their cells' areas vanish or cancel. May be NULL.
/// @errors BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(nodes); a bit a node, and memory for glued nodes.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_normals(
    context: *const gusset_context,
    net: *const gusset_net,
    x: *mut c_void,
    y: *mut c_void,
    z: *mut c_void,
    capacity: usize,
    missing_count: *mut u64,
) -> gusset_status {
    answer_into_optional_output(context, (missing_count, "missing_count"), 0, |job| {
        let net = net_of_handle(net)?;
        let mut out = match net.coordinates().scalar() {
            Scalar::F32 => Coordinates::F32(matrices_of_buffers(net, [x, y, z], capacity)?),
            Scalar::F64 => Coordinates::F64(matrices_of_buffers(net, [x, y, z], capacity)?),
        };
        Ok(normals_into(net, &mut out, job)?)
    })
}
