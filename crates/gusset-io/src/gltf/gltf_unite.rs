//! Split vertices: those that this library split are joined again, and others at equal positions get a common representative.

use crate::budget::Budget;
use crate::error::ReadError;
use crate::mesh::{Mesh, Positions, Values};
use std::collections::TryReserveError;

/// Joins vertices with their origins, which `origins` lists for each vertex. Attributes that differ go to corners.
pub(super) fn unite_vertices(mesh: &mut Mesh, origins: &[u32], budget: &mut Budget) -> Result<(), ReadError> {
    if origins.iter().enumerate().all(|(vertex, &origin)| vertex == origin as usize) {
        return Ok(());
    }
    let normals = std::mem::take(&mut mesh.normals);
    mesh.normals = gathered(normals, origins, &mesh.corners, budget)?;
    let texcoords = std::mem::take(&mut mesh.texcoords);
    mesh.texcoords = gathered(texcoords, origins, &mesh.corners, budget)?;
    let is_kept = |vertex: usize| origins[vertex] as usize == vertex;
    match &mut mesh.positions {
        Positions::F32(points) => keep(points, is_kept),
        Positions::F64(points) => keep(points, is_kept),
    }
    keep(&mut mesh.vertex_colours, is_kept);
    let mut places = budget.vector::<u32>(origins.len() as u64)?;
    let mut kept = 0;
    for vertex in 0..origins.len() {
        places.push(kept);
        kept += u32::from(is_kept(vertex));
    }
    for vertex in &mut mesh.corners {
        *vertex = places[origins[*vertex as usize] as usize];
    }
    Ok(())
}

fn keep<T>(values: &mut Vec<T>, is_kept: impl Fn(usize) -> bool) {
    let mut place = 0;
    values.retain(|_| {
        place += 1;
        is_kept(place - 1)
    });
}

/// Returns values of the origins if all vertices agree with theirs, or else values of corners.
fn gathered<const N: usize>(
    values: Values<N>,
    origins: &[u32],
    corners: &[u32],
    budget: &mut Budget,
) -> Result<Values<N>, ReadError> {
    let Values::Vertices(mut values) = values else { return Ok(values) };
    let bits = |vertex: usize| values[vertex].map(f64::to_bits);
    if (0..origins.len()).all(|vertex| bits(vertex) == bits(origins[vertex] as usize)) {
        keep(&mut values, |vertex| origins[vertex] as usize == vertex);
        return Ok(Values::Vertices(values));
    }
    let mut at_corners = budget.vector(corners.len() as u64)?;
    at_corners.extend(corners.iter().map(|&vertex| values[vertex as usize]));
    Ok(Values::Corners(at_corners))
}

/// Gives vertices at equal positions the first of them as representative. NaN equals nothing, and -0 equals 0.
pub(super) fn merge_equal_positions(mesh: &mut Mesh, budget: &mut Budget) -> Result<(), ReadError> {
    budget.take::<[u32; 4]>(mesh.positions.len() as u64)?;
    let merge = match &mesh.positions {
        Positions::F32(points) => representatives(points, single_key)?,
        Positions::F64(points) => representatives(points, |point| point.map(|x| (x + 0.0).to_bits()))?,
    };
    if merge.iter().enumerate().any(|(vertex, &first)| vertex != first as usize) {
        mesh.merge = merge;
    }
    Ok(())
}

/// Returns whether two points are equal.
pub(super) fn has_equal_positions(points: &[[f32; 3]]) -> Result<bool, TryReserveError> {
    let merge = representatives(points, single_key)?;
    Ok(merge.iter().enumerate().any(|(vertex, &first)| vertex != first as usize))
}

fn single_key(point: [f32; 3]) -> [u64; 3] {
    point.map(|x| u64::from((x + 0.0).to_bits()))
}

/// An empty place of the table.
const EMPTY: u32 = u32::MAX;

fn representatives<T: Copy + PartialOrd>(
    points: &[[T; 3]],
    key: impl Fn([T; 3]) -> [u64; 3],
) -> Result<Vec<u32>, TryReserveError> {
    let size = (points.len() + points.len() / 2 + 1).next_power_of_two();
    let mut table = Vec::new();
    table.try_reserve_exact(size)?;
    table.resize(size, EMPTY);
    let mut merge = Vec::new();
    merge.try_reserve_exact(points.len())?;
    for (vertex, &point) in points.iter().enumerate() {
        let vertex = vertex as u32;
        // A NaN is not comparable with itself.
        if point.iter().any(|x| x.partial_cmp(x).is_none()) {
            merge.push(vertex);
            continue;
        }
        let own = key(point);
        let mut place = hash(own) as usize & (size - 1);
        let first = loop {
            match table[place] {
                EMPTY => {
                    table[place] = vertex;
                    break vertex;
                }
                known if key(points[known as usize]) == own => break known,
                _ => place = (place + 1) & (size - 1),
            }
        };
        merge.push(first);
    }
    Ok(merge)
}

/// Mixes all bits of three numbers.
fn hash(key: [u64; 3]) -> u64 {
    const MULTIPLIER: u64 = 0x9E37_79B9_7F4A_7C15;
    let mut hash = 0_u64;
    for part in key {
        hash = (hash ^ part).wrapping_mul(MULTIPLIER);
        hash ^= hash >> 32;
    }
    hash
}
