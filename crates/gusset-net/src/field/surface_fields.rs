//! Deformations that depend on the net: displacement along its normals, a host's function of rows,
//! and [`snap_glued_nodes`], which makes glued nodes equal again. O(nodes).

use crate::chunks;
use crate::normals::normals;
use crate::topology::NodeGroups;
use crate::{Coordinates, Net, NodeClasses, Real, XyzMatrices, each};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// Gives all nodes of a class the position of its representative, bit for bit. Returns the number
/// of nodes that moved.
///
/// O(H + W) for a net that is glued only along its sides, otherwise O(nodes).
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn snap_glued_nodes(net: &mut Net<'_>) -> Result<u64> {
    let groups = NodeClasses::new(net.topology())?.glued_classes()?;
    Ok(snap_groups(&groups, net))
}

/// [`snap_glued_nodes`] for known classes. It cannot fail after nodes have moved.
pub(crate) fn snap_groups(groups: &NodeGroups, net: &mut Net<'_>) -> u64 {
    let mut moved = 0;
    for class in groups.iter() {
        each!(net.coordinates_mut(), planes => moved += snap_class_to_first(planes, class));
    }
    moved
}

fn snap_class_to_first<T: Real>(planes: &mut XyzMatrices<'_, T>, class: &[u32]) -> u64 {
    let (shape, stride) = (planes.shape(), planes.stride());
    let at = |node: u32| {
        let (i, j) = shape.row_and_column(node);
        i * stride + j
    };
    let (mut moved, mut matrices) = (0, planes.matrices_mut());
    for &node in &class[1..] {
        let mut differs = false;
        for matrix in &mut matrices {
            let (from, to) = (matrix[at(class[0])], &mut matrix[at(node)]);
            differs |= bytemuck::bytes_of(to) != bytemuck::bytes_of(&from);
            *to = from;
        }
        moved += u64::from(differs);
    }
    moved
}

/// Moves every node by `distance` along its unit normal. Nodes without a normal stay. O(nodes),
/// with as much extra memory as the coordinates take.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if the distance is not finite, [`Error::FieldUndefined`] for the
/// first node whose coordinates would overflow (no node is moved), [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn displace_along_normals(net: &mut Net<'_>, distance: f64, job: &Job<'_>) -> Result<()> {
    Error::require(distance.is_finite(), "distance", distance, "finite")?;
    let (normals, _) = normals(net, job)?;
    let groups = NodeClasses::new(net.topology())?.glued_classes()?;
    job.check_memory()?;
    match (net.coordinates_mut(), &normals) {
        (Coordinates::F32(planes), Coordinates::F32(normals)) => add_scaled_normals(planes, normals, distance)?,
        (Coordinates::F64(planes), Coordinates::F64(normals)) => add_scaled_normals(planes, normals, distance)?,
        _ => {}
    }
    // Normals of a class are equal, but its positions may have differed.
    snap_groups(&groups, net);
    Ok(())
}

fn add_scaled_normals<T: Real>(
    planes: &mut XyzMatrices<'_, T>,
    normals: &XyzMatrices<'_, T>,
    distance: f64,
) -> Result<()> {
    let distance = T::from_f64(distance);
    let shape = planes.shape();
    for i in 0..shape.rows() {
        for (row, normal) in planes.row(i).into_iter().zip(normals.row(i)) {
            let overflows = |(&x, &n): (&T, &T)| x.into().is_finite() && !(x + distance * n).into().is_finite();
            if let Some(j) = row.iter().zip(normal).position(overflows) {
                return Err(Error::FieldUndefined { node: shape.node(i, j) });
            }
        }
    }
    for i in 0..shape.rows() {
        for (row, normal) in planes.row_mut(i).into_iter().zip(normals.row(i)) {
            row.iter_mut().zip(normal).for_each(|(x, &n)| *x = *x + distance * n);
        }
    }
    Ok(())
}

/// Coordinates of consecutive nodes, in the net's type.
#[derive(Debug)]
pub enum RowsMut<'a> {
    /// Single precision.
    F32([&'a mut [f32]; 3]),
    /// Double precision.
    F64([&'a mut [f64]; 3]),
}

/// Moves the nodes by a function of the host, then [`snap_glued_nodes`]s.
///
/// `map` is called on the calling thread with the index of the first node and the coordinates of
/// consecutive nodes, from the first node to the last. It changes the coordinates in place. If it
/// fails, or the host cancels, earlier changes remain.
///
/// # Errors
/// The errors of `map`, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn deform_by_callback(
    net: &mut Net<'_>,
    mut map: impl FnMut(usize, RowsMut<'_>) -> Result<()>,
    job: &Job<'_>,
) -> Result<()> {
    let (count, mut next_step) = (net.shape().node_count() as f64, 0);
    let mut step = |first: usize| {
        if first < next_step {
            return Ok(());
        }
        next_step = first + (1 << 20);
        job.step_without_memory_check(first as f64 / count, "deform")
    };
    let groups = NodeClasses::new(net.topology())?.glued_classes()?;
    job.check_memory()?;
    match net.coordinates_mut() {
        Coordinates::F32(planes) => chunks::for_each_chunk_in_order(planes, |first, rows| {
            step(first).and_then(|()| map(first, RowsMut::F32(rows)))
        })?,
        Coordinates::F64(planes) => chunks::for_each_chunk_in_order(planes, |first, rows| {
            step(first).and_then(|()| map(first, RowsMut::F64(rows)))
        })?,
    }
    snap_groups(&groups, net);
    Ok(())
}
