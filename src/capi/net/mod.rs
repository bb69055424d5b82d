//! Nets: Regular nets of quads with coordinates.
//!
//! @source Deryagin, tetragonal regular networks; functions beyond the paper are our own.

mod net_handle;
pub mod gluing;
pub mod glue;
pub mod classify;
pub mod primitive;
pub mod transform;
pub mod field;
pub mod measure;
pub mod mesh;
pub mod arrange;
pub mod resample;
pub mod join;
pub mod analyse;
pub mod complex;
pub mod morph;
pub mod normals;
pub mod planarise;
pub mod settle;
pub mod validate;

use crate::capi::context::{create_handle, guard_call, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle;
use crate::capi::input::{self, Choice, read_choice};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::gluing::{gusset_net_gluing, read_topology};
use crate::capi::status::gusset_status::{GUSSET_ERROR_BAD_STRIDE, GUSSET_ERROR_OVERLAP};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::{Coordinates, Net, Real, Shape, XyzMatrices, each};
use std::ffi::c_void;

pub use net_handle::gusset_net;
pub(crate) use net_handle::{net_of_handle, net_of_handle_mut};

/// Coordinate matrices, possibly interleaved or column-major: number (i, j) begins i * row_stride +
/// j * column_stride bytes after the first.
///
/// Normals point along increasing column x increasing row.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_view {
    /// sizeof(gusset_net_view).
    pub struct_size: usize,
    /// At least 2.
    pub rows: usize,
    /// At least 2; rows * columns at most INT32_MAX.
    pub columns: usize,
    /// First coordinates.
    pub x: *mut c_void,
    /// Second coordinates.
    pub y: *mut c_void,
    /// Third coordinates.
    pub z: *mut c_void,
    /// Stride of rows.
    pub row_stride: usize,
    /// Stride of numbers in a row.
    pub column_stride: usize,
    /// Type of coordinates.
    pub scalar: gusset_scalar,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_view: 72 reserved }

/// Memory of a net's coordinates.
pub type gusset_net_memory = u32;
/// A copy.
pub const GUSSET_NET_MEMORY_COPY: gusset_net_memory = 0;
/// The caller's memory, which changes with the net.
pub const GUSSET_NET_MEMORY_BORROW: gusset_net_memory = 1;

/// The layout of the caller's matrices: bytes from row to row, from number to number, and spanned
/// by one matrix.
struct MatrixLayout {
    row_stride: usize,
    column_stride: usize,
    byte_span: usize,
}

impl MatrixLayout {
    fn new(shape: Shape, arrays: &gusset_net_view, size: usize) -> Result<Self, Failure> {
        let overflow = || Failure::from(Error::SizeOverflow { what: "coordinates", count: shape.node_count() as u64 });
        let extent = |count: usize, stride: usize, each: usize| {
            (count - 1).checked_mul(stride).and_then(|n| n.checked_add(each)).ok_or_else(overflow)
        };
        let column = if arrays.column_stride == 0 { size } else { arrays.column_stride };
        let row = match arrays.row_stride {
            0 => shape.columns().checked_mul(column).ok_or_else(overflow)?,
            given => given,
        };
        // Row-major or column-major; in either case numbers must not overlap.
        let (width, height) = (extent(shape.columns(), column, size)?, extent(shape.rows(), row, size)?);
        let (what, stride, least) = if column < size || row < size {
            ("numbers", column.min(row), size)
        } else if row < width && column < height {
            ("rows", row, width)
        } else {
            let span = extent(shape.rows(), row, width)?;
            return if span <= isize::MAX as usize {
                Ok(MatrixLayout { row_stride: row, column_stride: column, byte_span: span })
            } else {
                Err(overflow())
            };
        };
        Err(Error::StrideTooSmall { what, stride: stride as u64, min: least as u64 }.into())
    }

    /// Returns the offset of number (i, j).
    fn byte_offset(&self, i: usize, j: usize) -> usize {
        i * self.row_stride + j * self.column_stride
    }
}

/// Returns the number of rows of a net to copy between two progress reports.
fn rows_per_report(shape: Shape) -> usize {
    ((1 << 17) / shape.columns()).max(1)
}

/// Copies the caller's matrices, which may have any alignment.
fn copy_matrices<T: Real>(
    shape: Shape,
    arrays: &gusset_net_view,
    job: &Job<'_>,
) -> Result<XyzMatrices<'static, T>, Failure> {
    let size = size_of::<T>();
    let layout = MatrixLayout::new(shape, arrays, size)?;
    let mut planes = XyzMatrices::zeroed(shape)?;
    for (axis, (from, name)) in [(arrays.x, "x"), (arrays.y, "y"), (arrays.z, "z")].into_iter().enumerate() {
        let (from, job) = (input::input_bytes(from, layout.byte_span, 1, name)?, job.sub_job_of_item(axis, 3));
        for i in 0..shape.rows() {
            job.step_every(rows_per_report(shape), i, shape.rows(), "copying a net")?;
            let to = &mut planes.row_mut(i)[axis];
            let from = &from[layout.byte_offset(i, 0)..];
            if layout.column_stride == size {
                bytemuck::cast_slice_mut::<T, u8>(to).copy_from_slice(&from[..shape.columns() * size]);
            } else {
                let numbers =
                    from.chunks(layout.column_stride).map(|bytes| bytemuck::pod_read_unaligned(&bytes[..size]));
                to.iter_mut().zip(numbers).for_each(|(to, number)| *to = number);
            }
        }
    }
    Ok(planes)
}

/// Borrows the caller's matrices.
fn borrow_matrices<T: Real>(shape: Shape, arrays: &gusset_net_view) -> Result<XyzMatrices<'static, T>, Failure> {
    let size = size_of::<T>();
    let layout = MatrixLayout::new(shape, arrays, size)?;
    if layout.column_stride != size || !layout.row_stride.is_multiple_of(size) {
        let message = "a net in the caller's memory needs contiguous numbers in a row, and rows a multiple of the number size apart";
        return Err(Failure { value: layout.column_stride as f64, ..Failure::new(GUSSET_ERROR_BAD_STRIDE, message) });
    }
    let starts = [arrays.x, arrays.y, arrays.z].map(|matrix| matrix as usize);
    if (0..3).any(|k| starts[k].abs_diff(starts[(k + 1) % 3]) < layout.byte_span)
        && starts.iter().all(|&start| start != 0)
    {
        return Err(Failure::new(GUSSET_ERROR_OVERLAP, "the matrices x, y and z overlap; pass separate arrays"));
    }
    let matrix = |data: *mut c_void, name| input::result_buffer::<T>(data.cast(), layout.byte_span / size, name);
    let matrices = [matrix(arrays.x, "x")?, matrix(arrays.y, "y")?, matrix(arrays.z, "z")?];
    Ok(XyzMatrices::borrowed(shape, layout.row_stride / size, matrices)?)
}

/// Copies coordinates to the caller's matrices, which may have any alignment.
fn write_matrices<T: Real>(net: &Net<'_>, arrays: &gusset_net_view, job: &Job<'_>) -> Result<(), Failure> {
    let (shape, size) = (net.shape(), size_of::<T>());
    let layout = MatrixLayout::new(shape, arrays, size)?;
    for (axis, (to, name)) in [(arrays.x, "x"), (arrays.y, "y"), (arrays.z, "z")].into_iter().enumerate() {
        let (to, job) = (input::result_buffer::<u8>(to.cast(), layout.byte_span, name)?, job.sub_job_of_item(axis, 3));
        for i in 0..shape.rows() {
            job.step_every(rows_per_report(shape), i, shape.rows(), "reading a net")?;
            each!(net.coordinates(), planes => {
                for (j, &value) in planes.row(i)[axis].iter().enumerate() {
                    let at = layout.byte_offset(i, j);
                    write_number::<T>(&mut to[at..at + size], value);
                }
            });
        }
    }
    Ok(())
}

/// Writes a number in another type, or in its own type bit for bit.
fn write_number<T: Real>(to: &mut [u8], value: impl Real) {
    if size_of_val(&value) == size_of::<T>() {
        to.copy_from_slice(bytemuck::bytes_of(&value));
    } else {
        to.copy_from_slice(bytemuck::bytes_of(&T::from_f64(value.into())));
    }
}

/// Makes a net from coordinates.
///
/// Borrowed matrices are aligned, apart from each other, and without gaps in rows; row_stride is a
/// multiple of the scalar's size. They stay valid until the net is destroyed.
///
/// @param gluing NULL: nothing is glued.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE, OVERLAP, OUT_OF_RANGE (a byte of the matrix),
///     BAD_SEAM, CROSSING_CELL
/// @complexity O(nodes + pairs of seams); 12 or 24 bytes a node, and 1/4 byte unless sides give the
///     gluing. Borrowed without matrix and seams: O(1).
/// @source Deryagin, "Model of the tetragonal regular network".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_create(
    context: *const gusset_context,
    view: *const gusset_net_view,
    gluing: *const gusset_net_gluing,
    memory: gusset_net_memory,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |job| match memory {
        GUSSET_NET_MEMORY_COPY => create_net_of_view(view, gluing, false, job),
        GUSSET_NET_MEMORY_BORROW => create_net_of_view(view, gluing, true, job),
        other => {
            Err(Failure::unknown_choice("memory", other, &constants![GUSSET_NET_MEMORY_COPY, GUSSET_NET_MEMORY_BORROW]))
        }
    })
}

/// Creates a net of the caller's matrices, borrowed or copied.
fn create_net_of_view(
    view: *const gusset_net_view,
    gluing: *const gusset_net_gluing,
    borrow: bool,
    job: &Job<'_>,
) -> Result<gusset_net, Failure> {
    fn read_matrices<T: Real>(
        shape: Shape,
        arrays: &gusset_net_view,
        borrow: bool,
        job: &Job<'_>,
    ) -> Result<XyzMatrices<'static, T>, Failure> {
        if borrow { borrow_matrices(shape, arrays) } else { copy_matrices(shape, arrays, job) }
    }
    let (arrays, shape) = read_view(view)?;
    let coordinates = match read_choice(arrays.scalar)? {
        Scalar::F32 => Coordinates::F32(read_matrices(shape, &arrays, borrow, &job.sub_job(0.0, 0.5))?),
        Scalar::F64 => Coordinates::F64(read_matrices(shape, &arrays, borrow, &job.sub_job(0.0, 0.5))?),
    };
    Ok(gusset_net::new(Net::new(coordinates, read_topology(shape, gluing, &job.sub_job(0.5, 1.0))?)))
}

fn read_view(view: *const gusset_net_view) -> Result<(gusset_net_view, Shape), Failure> {
    let arrays = input::read_versioned_struct(view, false, "view")?;
    Ok((arrays, Shape::new(arrays.rows, arrays.columns)?))
}

/// Destroys a net.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_destroy(net: *mut gusset_net) {
    handle::destroy(net);
}

fn lend_net(net: &Net<'_>) -> gusset_net_view {
    each!(net.coordinates(), planes => {
        let matrices = planes.matrices();
        let size = size_of_val(&matrices[0][0]);
        let [x, y, z] = matrices.map(|matrix| matrix.as_ptr().cast_mut().cast());
        gusset_net_view {
            struct_size: 0,
            rows: planes.shape().rows(),
            columns: planes.shape().columns(),
            x,
            y,
            z,
            row_stride: planes.stride() * size,
            column_stride: size,
            scalar: net.coordinates().scalar().number(),
            reserved: 0,
        }
    })
}

/// Lends the coordinates for reading.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_get_view(net: *const gusset_net, view: *mut gusset_net_view) -> gusset_status {
    lend!(net, view, |net| lend_net(net.net()))
}

/// Lends the coordinates for writing, until the next call with this net.
///
/// The caller keeps glued nodes equal (see snap of gusset_glue_options). Shared memory is copied
/// first.
///
/// @complexity O(1), with a copy O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_edit(
    context: *const gusset_context,
    net: *mut gusset_net,
    view: *mut gusset_net_view,
) -> gusset_status {
    let out = input::output_struct(view, "view");
    guard_changing_call(context, |job| {
        let out = out?;
        let net = net_of_handle_mut(net, job)?;
        let mut lent = lend_net(net);
        // The pointers must be derived from a mutable borrow, because the caller may write through
        // them.
        let pointers: [*mut c_void; 3] = each!(net.coordinates_mut(), planes => {
            planes.matrices_mut().map(|matrix| matrix.as_mut_ptr().cast())
        });
        [lent.x, lent.y, lent.z] = pointers;
        out.write_known_fields(lent);
        Ok(())
    })
}

/// Copies the coordinates to the caller's matrices.
///
/// @param view matrices of the net's size, of any layout and scalar type (float rounds). Gaps stay.
/// @errors SIDES_DIFFER (another size), BAD_STRIDE
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_read(
    context: *const gusset_context,
    net: *const gusset_net,
    view: *const gusset_net_view,
) -> gusset_status {
    guard_call(context, |job| {
        let net = net_of_handle(net)?;
        let (arrays, shape) = read_view(view)?;
        let (given, needed) = ([shape.rows(), shape.columns()], [net.shape().rows(), net.shape().columns()]);
        if let Some(k) = (0..2).find(|&k| given[k] != needed[k]) {
            return Err(Error::SidesDiffer { a: needed[k] as u32, b: given[k] as u32 }.into());
        }
        match read_choice(arrays.scalar)? {
            Scalar::F32 => write_matrices::<f32>(net, &arrays, job),
            Scalar::F64 => write_matrices::<f64>(net, &arrays, job),
        }
    })
}
