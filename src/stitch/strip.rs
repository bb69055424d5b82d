//! The triangles between the meridians.
//!
//! Rim A runs with its surface on the left, rim B the opposite way (so that they run side by side): the old faces run
//! A_i -> A_i+1 and B_j+1 -> B_j, and the strip must run the other way. Its triangles are (A_i+1, A_i, B_j) where the next meridian
//! advances on A, (B_j, B_j+1, A_i) where it advances on B, and one of each where it advances on both (the paper's quad), split
//! by its shorter diagonal.

use super::meridian::Pair;
use super::rim::{Bridges, Rim};
use crate::alloc;
use crate::error::{Error, Result};

/// A corner of the strip: a place on rim A or on rim B.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Corner {
    A(u32),
    B(u32),
}

pub(super) type Triangle = [Corner; 3];

/// The strip over `pairs`.
///
/// # Errors
/// [`Error::NoStrip`] if a meridian, or both diagonals of a quad, repeat an edge that the mesh already has.
pub(super) fn triangles(a: &Rim, b: &Rim, pairs: &[Pair], bridges: &Bridges) -> Result<Vec<Triangle>> {
    let (n, m) = (a.vertices.len() as u32, b.vertices.len() as u32);
    let (wrap_a, wrap_b) = (|i: u32| if i == n { 0 } else { i }, |j: u32| if j == m { 0 } else { j });
    let taken = |i: u32, j: u32| bridges.has(a.vertices[i as usize], b.vertices[j as usize]);
    let blocked = |i: u32| Err(Error::NoStrip { vertex: a.vertices[i as usize] });
    let squared = |i: u32, j: u32| a.points[i as usize].distance_squared(b.points[j as usize]);

    let mut triangles = alloc::with_capacity((n + m) as usize)?;
    for step in pairs.windows(2) {
        let [i, j] = [wrap_a(step[0][0]), wrap_b(step[0][1])];
        let [i2, j2] = [wrap_a(step[1][0]), wrap_b(step[1][1])];
        if taken(i, j) {
            return blocked(i);
        }
        let on_a = |j| [Corner::A(i2), Corner::A(i), Corner::B(j)];
        let on_b = |i| [Corner::B(j), Corner::B(j2), Corner::A(i)];
        match (step[1][0] > step[0][0], step[1][1] > step[0][1]) {
            (true, false) => triangles.push(on_a(j)),
            (false, true) => triangles.push(on_b(i)),
            _ => match (taken(i2, j), taken(i, j2)) {
                (true, true) => return blocked(i),
                (a_first_taken, b_first_taken) => {
                    let a_first = !a_first_taken && (b_first_taken || squared(i2, j) <= squared(i, j2));
                    triangles.extend(if a_first { [on_a(j), on_b(i2)] } else { [on_b(i), on_a(j2)] });
                }
            },
        }
    }
    Ok(triangles)
}
