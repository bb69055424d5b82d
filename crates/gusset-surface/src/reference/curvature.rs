//! A bound of the principal curvatures, from control nets.
//!
//! The normal curvature in the direction a S_u + b S_v is N . (a^2 S_uu + 2 a b S_uv + b^2 S_vv)
//! divided by |a S_u + b S_v|^2. Let a^2 + b^2 = 1. The numerator is at most the larger eigenvalue
//! of the matrix of |S_uu|, |S_uv| and |S_vv|. The root of the denominator is at least the smaller
//! singular value of the mean of (S_u, S_v), less the deviation of both from their means.
//! Parameters are scaled so that the means have length 1.

use crate::cells::{SheetCells, compute_cell_values};
use crate::{Patch, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Number of halvings of a cell after which its surface counts as not regular.
const MAX_CELL_HALVINGS: u32 = 5;

/// The bound K of the absolute values of all principal curvatures of the sheet. It is infinite
/// where the surface is not regular, or nearly, as at poles: no bound exists there (erratum E4).
///
/// # Errors
/// [`gusset_base::Error::OutOfMemory`], [`gusset_base::Error::Cancelled`].
pub fn curvature_bound(sheet: &Sheet<'_>, job: &Job<'_>) -> Result<f64> {
    let of_cell = |[i, j]: [usize; 2]| {
        each_sheet!(sheet, cells => {
            SheetCells::cell_patch(cells, i, j).patch_curvature_bound(MAX_CELL_HALVINGS)
        })
    };
    Ok(compute_cell_values(sheet.cells(), "cells", job, of_cell)?.into_iter().fold(0.0, f64::max))
}

impl<const N: usize> Patch<N> {
    /// The bound of a patch, or the largest bound of its quarters if the whole patch cannot be
    /// bounded.
    fn patch_curvature_bound(&self, depth: u32) -> f64 {
        let degree = (N - 1) as f64;
        let indices = |rows: usize, columns: usize| (0..rows).flat_map(move |a| (0..columns).map(move |b| (a, b)));
        let p = &self.points;
        let u = VectorSpread::from_vectors(indices(N - 1, N).map(|(a, b)| degree * (p[a + 1][b] - p[a][b])));
        let v = VectorSpread::from_vectors(indices(N, N - 1).map(|(a, b)| degree * (p[a][b + 1] - p[a][b])));
        let (su, sv) = (u.mean.length(), v.mean.length());
        let cosine = u.mean.dot(v.mean) / (su * sv);
        // The smaller singular value of two unit vectors is sqrt(1 - |cosine|).
        let slowest = (1.0 - cosine.abs()).max(0.0).sqrt() - libm::hypot(u.radius / su, v.radius / sv);
        if slowest.is_nan() || slowest <= 1e-6 {
            return match depth {
                0 => f64::INFINITY,
                _ => self.quarters().iter().map(|part| part.patch_curvature_bound(depth - 1)).fold(0.0, f64::max),
            };
        }
        let second = degree * (degree - 1.0);
        let uu = indices(N - 2, N).map(|(a, b)| second * (p[a + 2][b] - 2.0 * p[a + 1][b] + p[a][b]) / (su * su));
        let vv = indices(N, N - 2).map(|(a, b)| second * (p[a][b + 2] - 2.0 * p[a][b + 1] + p[a][b]) / (sv * sv));
        let uv = indices(N - 1, N - 1)
            .map(|(a, b)| degree * degree * (p[a + 1][b + 1] - p[a + 1][b] - p[a][b + 1] + p[a][b]) / (su * sv));
        let (uu, uv, vv) = (max_length(uu), max_length(uv), max_length(vv));
        let greatest = 0.5 * (uu + vv) + (0.25 * (uu - vv) * (uu - vv) + uv * uv).sqrt();
        greatest / (slowest * slowest) * (1.0 + 1e-12)
    }
}

fn max_length(vectors: impl Iterator<Item = DVec3>) -> f64 {
    vectors.map(DVec3::length_squared).fold(0.0, f64::max).sqrt()
}

/// The mean of vectors, and their largest distance from it.
struct VectorSpread {
    mean: DVec3,
    radius: f64,
}

impl VectorSpread {
    fn from_vectors(vectors: impl Iterator<Item = DVec3> + Clone) -> VectorSpread {
        let (sum, count) = vectors.clone().fold((DVec3::ZERO, 0.0), |(sum, count), v| (sum + v, count + 1.0));
        let mean = sum / count;
        VectorSpread { mean, radius: max_length(vectors.map(|v| v - mean)) }
    }
}
