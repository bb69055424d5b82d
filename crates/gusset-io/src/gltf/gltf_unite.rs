//! Split vertices: those that this library split are joined again, and others at equal positions get a common representative.

use crate::budget::Budget;
use crate::error::{Note, Place, ReadError};
use crate::mesh::{Mesh, Positions, Values};
use crate::repeated_points::count_repeated_points;
use crate::vertex_merging::{Coordinate, VertexMerger};
use gusset_base::alloc;

/// Returns whether all vertices are where their origins are. Other programs may reorder vertices, and keep the numbers of the old order.
pub(super) fn are_origins_right(positions: &Positions, origins: &[u32]) -> bool {
    let is_equal = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
    origins.iter().enumerate().all(|(vertex, &origin)| {
        let (own, first) = (positions.get(vertex), positions.get(origin as usize));
        vertex == origin as usize || (0..3).all(|axis| is_equal(own[axis], first[axis]))
    })
}

/// Joins vertices with their origins, which `origins` lists for each vertex. Attributes that differ go to corners.
pub(super) fn unite_vertices(mesh: &mut Mesh, origins: &[u32], budget: &mut Budget) -> Result<(), ReadError> {
    if origins.iter().enumerate().all(|(vertex, &origin)| vertex == origin as usize) {
        return Ok(());
    }
    let normals = std::mem::take(&mut mesh.normals);
    mesh.normals = move_values_to_origins_or_corners(normals, origins, &mesh.corners, budget)?;
    let texcoords = std::mem::take(&mut mesh.texcoords);
    mesh.texcoords = move_values_to_origins_or_corners(texcoords, origins, &mesh.corners, budget)?;
    let is_kept = |vertex: usize| origins[vertex] as usize == vertex;
    match &mut mesh.positions {
        Positions::F32(points) => keep(points, is_kept),
        Positions::F64(points) => keep(points, is_kept),
    }
    keep(&mut mesh.vertex_colours, is_kept);
    let mut places = budget.allocate_vector::<u32>(origins.len() as u64)?;
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

/// Keeps the values of the origins if each vertex has its origin's value; otherwise copies each corner's value. Returns values
/// unchanged if they do not belong to vertices.
fn move_values_to_origins_or_corners<const N: usize>(
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
    let mut at_corners = budget.allocate_vector(corners.len() as u64)?;
    at_corners.extend(corners.iter().map(|&vertex| values[vertex as usize]));
    Ok(Values::Corners(at_corners))
}

/// Gives vertices at equal positions the first of them as representative. NaN equals nothing, and -0 equals 0. Merges nothing if the
/// table of positions exceeds the budget, and says so.
pub(super) fn merge_equal_positions(
    mesh: &mut Mesh,
    budget: &mut Budget,
    notes: &mut Vec<Note>,
) -> Result<(), ReadError> {
    let count = mesh.positions.len() as u64;
    if budget.take_bytes_of::<[u64; 6]>(count).is_err() {
        let text = format!("a mesh of {count} vertices is not merged at equal positions, because its file is small");
        alloc::push(notes, Note::new(Place::Whole, text))?;
        return Ok(());
    }
    let merge = match &mesh.positions {
        Positions::F32(points) => representatives(points)?,
        Positions::F64(points) => representatives(points)?,
    };
    budget.give_back_bytes_of::<[u64; 6]>(count);
    if let Some(merge) = merge {
        budget.take_bytes_of::<u32>(count)?;
        mesh.merge = merge;
    }
    Ok(())
}

/// Returns the first vertex at each position; `None` if all vertices differ.
fn representatives<T: Coordinate>(points: &[[T; 3]]) -> Result<Option<Vec<u32>>, ReadError> {
    if count_repeated_points(points.len(), |vertex| Some(points[vertex]))? == 0 {
        return Ok(None);
    }
    let mut merge = Vec::new();
    let mut merger = VertexMerger::new(points.len())?;
    merger.extend(points, &mut merge)?;
    // Numbers of positions follow their first occurrence.
    let mut firsts: Vec<u32> = Vec::new();
    firsts.try_reserve_exact(merger.len())?;
    for (vertex, number) in merge.iter_mut().enumerate() {
        if *number as usize == firsts.len() {
            firsts.push(vertex as u32);
        }
        *number = firsts[*number as usize];
    }
    Ok(Some(merge))
}
