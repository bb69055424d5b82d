//! Winding numbers of the cells of an arrangement.
//!
//! The winding number of a point counts how often the triangles enclose it. It is constant in each
//! cell, and grows by the multiplicity of a triangle from its front, to which the normal points, to
//! its back. Cells are found as sets of sides of triangles: the sides that face each other across
//! an edge belong to one cell. One ray from each connected component finds the winding number
//! outside it. All decisions are exact.
//!
//! * Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, Mesh arrangements for solid geometry, ACM
//!   Transactions on Graphics 35, 2016.

use super::exact_arrangement::ExactArrangement;
use super::face_groups::{EdgeOrder, FaceGroups};
use super::outer_cells::OuterCells;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;

const STAGE: &str = "computing winding numbers";
const EDGES_PER_REPORT: usize = 1 << 12;

/// The winding numbers in front and behind each distinct triangle.
pub(super) struct Windings {
    pub(super) windings_in_front: Vec<i32>,
    pub(super) windings_behind: Vec<i32>,
}

/// Returns a given triangle at an edge whose triangles do not cancel, or `None` if all edges are
/// balanced: if as many triangles pass each edge in one direction as in the other.
pub(super) fn unbalanced_triangle(arrangement: &ExactArrangement, groups: &FaceGroups) -> Option<u32> {
    groups.edges().find_map(|edge| {
        let sum: i32 = edge
            .iter()
            .map(|&[low, _, h]| {
                let multiplicity = groups.multiplicities[h as usize / 3];
                if groups.begins_at(h, low) { multiplicity } else { -multiplicity }
            })
            .sum();
        let group = edge.first()?[2] / 3;
        let part = groups.parts_of_group.get(group as usize).first()?;
        (sum != 0).then(|| arrangement.parts[*part as usize].1)
    })
}

/// Computes the winding numbers of an arrangement of `triangles`, whose edges are balanced.
pub(super) fn windings(
    arrangement: &ExactArrangement,
    groups: &FaceGroups,
    triangles: &[[u32; 3]],
    job: &Job<'_>,
) -> Result<Windings> {
    let count = groups.corners.len();
    let mut cells = DisjointSets::new(2 * count)?;
    let edge_count = groups.half_edges.len();
    for (k, edge) in groups.edges().enumerate() {
        job.sub_job(0.0, 0.3).step_every(EDGES_PER_REPORT, k, edge_count, STAGE)?;
        let [from, to, _] = edge[0];
        let mut join = |half_edge: u32, next: u32| {
            let ([after, _], [_, before]) = (groups.sides(half_edge, from), groups.sides(next, from));
            cells.union(after, before);
        };
        if edge.len() <= 2 {
            join(edge[0][2], edge[edge.len() - 1][2]);
            join(edge[edge.len() - 1][2], edge[0][2]);
            continue;
        }
        let around = |&[_, _, h]: &[u32; 3]| EdgeOrder::half_plane(arrangement, groups, h, from, triangles);
        let mut around = alloc::collect(edge.iter().map(around))?;
        EdgeOrder::new(arrangement, from, to).sort(&mut around);
        (0..around.len()).for_each(|k| join(around[k].half_edge, around[(k + 1) % around.len()].half_edge));
    }
    let cells = cells.into_roots(&job.sub_job(0.3, 0.3), STAGE)?;
    let starts = OuterCells::new(arrangement, groups, triangles)?.find(&job.sub_job(0.3, 0.6))?;
    // Spreads the winding numbers from the outer cells.
    let around = cells.iter().map(|&cell| cell as usize).zip(0u32..);
    let sides_of_cells = Buckets::new_cancellable(2 * count, 0, around, &job.sub_job(0.6, 0.7), STAGE)?;
    let mut numbers = alloc::filled(None, 2 * count)?;
    let mut stack = Vec::new();
    for (side, number) in starts {
        let cell = cells[side as usize];
        if numbers[cell as usize].is_none() {
            numbers[cell as usize] = Some(number);
            alloc::push(&mut stack, cell)?;
        }
        while let Some(cell) = stack.pop() {
            let number: i32 = numbers[cell as usize].unwrap_or(0);
            for &side in sides_of_cells.get(cell as usize) {
                let beyond = cells[side as usize ^ 1];
                let step = groups.multiplicities[side as usize / 2];
                if numbers[beyond as usize].is_none() {
                    numbers[beyond as usize] = Some(if side % 2 == 0 { number + step } else { number - step });
                    alloc::push(&mut stack, beyond)?;
                }
            }
        }
    }
    job.step(1.0, STAGE)?;
    let number = |side: usize| numbers[cells[side] as usize].unwrap_or(0);
    Ok(Windings {
        windings_in_front: alloc::collect((0..count).map(|g| number(2 * g)))?,
        windings_behind: alloc::collect((0..count).map(|g| number(2 * g + 1)))?,
    })
}
