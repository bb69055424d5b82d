//! The equations of all motions, solved by conjugate gradients.
//!
//! The matrix has a 6 x 6 block for each piece and for each pair of pieces that overlap. It is
//! preconditioned by the pieces' own blocks; M. Hestenes and E. Stiefel, *Methods of conjugate
//! gradients for solving linear systems* (1952).

use super::sample_pairs::MotionEquations;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::cholesky;

/// Addition to the diagonal, relative to its mean: a piece does not move in directions in which
/// nothing holds it.
const RELATIVE_DAMPING: f64 = 1e-3;
/// Sufficient reduction of the residual. The equations change in every round.
const RELATIVE_RESIDUAL_TOLERANCE: f64 = 1e-8;
/// Largest number of iterations per unknown.
const MAX_ITERATIONS_PER_UNKNOWN: usize = 2;

pub(super) type MotionVector = [f64; 6];

/// The symmetric equations of the pieces' motions.
pub(super) struct MotionSystem {
    diagonal_blocks: Vec<[MotionVector; 6]>,
    right_side: Vec<MotionVector>,
    /// For pieces i and j, the block of i's rows and j's columns.
    off_diagonal_blocks: Vec<([usize; 2], [MotionVector; 6])>,
    is_fixed: Vec<bool>,
}

impl MotionSystem {
    pub(super) fn new(is_fixed: &[bool]) -> Result<MotionSystem> {
        let count = is_fixed.len();
        Ok(MotionSystem {
            diagonal_blocks: alloc::filled([[0.0; 6]; 6], count)?,
            right_side: alloc::filled([0.0; 6], count)?,
            off_diagonal_blocks: Vec::new(),
            is_fixed: alloc::copied(is_fixed)?,
        })
    }

    /// Adds the equations of two pieces.
    pub(super) fn add_pair_equations(&mut self, pieces: [usize; 2], equations: &MotionEquations) -> Result<()> {
        let at = |i: usize, j: usize| equations.matrix[i.max(j)][i.min(j)];
        for (k, piece) in pieces.into_iter().enumerate() {
            for i in 0..6 {
                self.right_side[piece][i] += equations.right_side[6 * k + i];
                (0..6).for_each(|j| self.diagonal_blocks[piece][i][j] += at(6 * k + i, 6 * k + j));
            }
        }
        let block = std::array::from_fn(|i| std::array::from_fn(|j| at(i, 6 + j)));
        alloc::push(&mut self.off_diagonal_blocks, (pieces, block))
    }

    /// Returns the motions: for each piece a rotation, in units of its radius, and a translation; 0
    /// for fixed pieces. At most O(pieces * pairs), and usually far less.
    pub(super) fn solve_motions(&mut self) -> Result<Vec<MotionVector>> {
        for own in &mut self.diagonal_blocks {
            let mean = (0..6).map(|i| own[i][i]).sum::<f64>() / 6.0;
            (0..6).for_each(|i| own[i][i] += RELATIVE_DAMPING * mean);
        }
        let count = self.diagonal_blocks.len();
        let mut x = alloc::filled([0.0; 6], count)?;
        let mut residual = alloc::copied(&self.right_side)?;
        self.clear_fixed_motions(&mut residual);
        let mut conditioned = self.apply_block_preconditioner(&residual)?;
        let mut direction = alloc::copied(&conditioned)?;
        let mut product = alloc::filled([0.0; 6], count)?;
        let mut size = dot_product(&residual, &conditioned);
        let enough = RELATIVE_RESIDUAL_TOLERANCE * RELATIVE_RESIDUAL_TOLERANCE * size;
        for _ in 0..MAX_ITERATIONS_PER_UNKNOWN * 6 * count {
            if size <= enough {
                break;
            }
            self.multiply_by_matrix(&direction, &mut product);
            let curvature = dot_product(&direction, &product);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let step = size / curvature;
            add_scaled(&mut x, step, &direction);
            add_scaled(&mut residual, -step, &product);
            conditioned = self.apply_block_preconditioner(&residual)?;
            let before = size;
            size = dot_product(&residual, &conditioned);
            let turn = size / before;
            direction.iter_mut().zip(&conditioned).for_each(|(d, c)| (0..6).for_each(|i| d[i] = c[i] + turn * d[i]));
        }
        Ok(x)
    }

    fn clear_fixed_motions(&self, x: &mut [MotionVector]) {
        x.iter_mut().zip(&self.is_fixed).filter(|(_, fixed)| **fixed).for_each(|(x, _)| *x = [0.0; 6]);
    }

    fn multiply_by_matrix(&self, x: &[MotionVector], out: &mut [MotionVector]) {
        for ((out, own), x) in out.iter_mut().zip(&self.diagonal_blocks).zip(x) {
            *out = std::array::from_fn(|i| (0..6).map(|j| own[i][j] * x[j]).sum());
        }
        for ([a, b], block) in &self.off_diagonal_blocks {
            for i in 0..6 {
                for j in 0..6 {
                    out[*a][i] += block[i][j] * x[*b][j];
                    out[*b][j] += block[i][j] * x[*a][i];
                }
            }
        }
        self.clear_fixed_motions(out);
    }

    /// Solves each piece's own block.
    fn apply_block_preconditioner(&self, x: &[MotionVector]) -> Result<Vec<MotionVector>> {
        alloc::collect(x.iter().zip(&self.diagonal_blocks).map(|(x, own)| {
            let mut lower = *own;
            let mut right = x.map(|x| DVec3::new(x, 0.0, 0.0));
            let empty = (0..6).all(|i| own[i][i] <= 0.0);
            if !empty {
                cholesky::solve(&mut lower, &mut right);
            }
            right.map(|x| if empty { 0.0 } else { x.x })
        }))
    }
}

fn dot_product(a: &[MotionVector], b: &[MotionVector]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (0..6).map(|i| a[i] * b[i]).sum::<f64>()).sum()
}

fn add_scaled(x: &mut [MotionVector], by: f64, other: &[MotionVector]) {
    x.iter_mut().zip(other).for_each(|(x, other)| (0..6).for_each(|i| x[i] += by * other[i]));
}
