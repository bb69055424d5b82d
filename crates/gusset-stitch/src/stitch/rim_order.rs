//! The order in which a strip takes its two rims. It does not depend on the order of the pieces, so
//! that the strip does not depend on it either.

use super::existing_edges::ExistingEdges;
use super::meridian::MeridianEnds;
use super::stitch_rim::Rim;
use super::strip::Strip;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Lengths are equal up to rounding if they differ by at most this, relative to the larger one.
const MAX_EQUAL_LENGTH_DIFFERENCE: f64 = 1e-9;

/// The order of the rims of a strip: the rim with more vertices first; of two rims with as many, the
/// longer one.
#[derive(Clone, Copy)]
pub(crate) struct RimOrder {
    /// True if rim B comes first.
    is_exchanged: bool,
}

impl RimOrder {
    /// Keeps the given order.
    pub(crate) const GIVEN: RimOrder = RimOrder { is_exchanged: false };

    /// Finds the order of two rims.
    pub(crate) fn new(a: &Rim, b: &Rim) -> Self {
        let is_exchanged = match a.vertices.len().cmp(&b.vertices.len()) {
            std::cmp::Ordering::Equal => {
                let [a, b] = [a, b].map(Rim::length);
                b - a > MAX_EQUAL_LENGTH_DIFFERENCE * b
            }
            order => order.is_lt(),
        };
        RimOrder { is_exchanged }
    }

    /// Puts two rims that run side by side in order. The first rim has its surface on the left, the
    /// second on the right.
    pub(crate) fn sort_rims(self, [mut a, mut b]: [Rim; 2]) -> [Rim; 2] {
        if !self.is_exchanged {
            return [a, b];
        }
        a.reverse();
        b.reverse();
        [b, a]
    }

    /// Returns existing edges from the first rim to the second.
    pub(crate) fn sort_edges(self, existing: ExistingEdges) -> Result<ExistingEdges> {
        if self.is_exchanged { existing.transposed() } else { Ok(existing) }
    }

    /// Returns the vertices of both rims of a strip in the given order, side by side from the first
    /// meridian on.
    pub(crate) fn given_rims(self, strip: &mut Strip) -> [Vec<u32>; 2] {
        let rims = [&mut strip.a, &mut strip.b].map(|rim| std::mem::take(&mut rim.vertices));
        if !self.is_exchanged {
            return rims;
        }
        let closed = strip.a.closed;
        let [a, b] = rims.map(|mut vertices| {
            vertices[usize::from(closed)..].reverse();
            vertices
        });
        [b, a]
    }

    /// Returns the meridians of a strip as places on the given rims.
    pub(super) fn given_meridians(self, strip: &Strip) -> Result<Vec<MeridianEnds>> {
        if !self.is_exchanged {
            return alloc::copied(&strip.meridians);
        }
        let [n, m] = [strip.b.segment_count(), strip.a.segment_count()];
        alloc::collect(strip.meridians.iter().rev().map(|&[i, j]| [n - j, m - i]))
    }

    /// Returns the matrix P of a strip from the given rim A to rim B.
    pub(super) fn given_matrix(self, mut matrix: Vec<u32>) -> Vec<u32> {
        if self.is_exchanged {
            matrix.reverse();
        }
        matrix
    }

    /// Returns the parents of a vertex in a row, and their weights: the end of its meridian on the
    /// given rim A, and the end on rim B twice.
    pub(super) fn given_parents(self, vertices: [u32; 3], weights: [f64; 3]) -> ([u32; 3], [f64; 3]) {
        let ([first, second, _], [of_first, _, _]) = (vertices, weights);
        if self.is_exchanged { ([second, first, first], [1.0 - of_first, of_first, 0.0]) } else { (vertices, weights) }
    }
}
