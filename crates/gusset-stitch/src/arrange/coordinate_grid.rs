//! The grid on which given points are integers.

use super::wide_int::MAX_COORDINATE_BITS;
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;

/// The step of the grid, 2^`exponent`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    exponent: i32,
}

/// Returns e such that 2^e <= |x| < 2^(e + 1). x is not 0.
fn exponent_of(x: f64) -> i32 {
    libm::ilogb(x)
}

/// Returns the exponent of the lowest bit that is set. x is not 0.
fn lowest_bit(x: f64) -> i32 {
    let mantissa = x.to_bits() & ((1 << 52) - 1);
    let field = ((x.to_bits() >> 52) & 0x7ff) as i32;
    let mantissa = if field == 0 { mantissa } else { mantissa | 1 << 52 };
    field.max(1) - 1075 + mantissa.trailing_zeros() as i32
}

impl Grid {
    /// Returns the coarsest grid that has all points, if coordinates have then at most
    /// [`MAX_COORDINATE_BITS`] bits; otherwise the finest with so few bits.
    pub(super) fn from_points(points: impl Iterator<Item = DVec3>) -> Grid {
        let (mut highest, mut lowest) = (i32::MIN, i32::MAX);
        for x in points.flat_map(|p| p.to_array()).filter(|&x| x != 0.0) {
            highest = highest.max(exponent_of(x));
            lowest = lowest.min(lowest_bit(x));
        }
        if highest == i32::MIN {
            return Grid { exponent: 0 };
        }
        Grid { exponent: lowest.max(highest + 1 - MAX_COORDINATE_BITS) }
    }

    /// Returns the nearest point of the grid, in steps.
    pub(super) fn steps(&self, p: DVec3) -> DVec3 {
        // Adding 0 turns -0 into 0.
        DVec3::from_array(p.to_array().map(|x| libm::rint(libm::scalbn(x, -self.exponent)) + 0.0))
    }

    /// Returns a point given in steps, rounded to nearest.
    pub(super) fn position(&self, p: DVec3) -> DVec3 {
        DVec3::from_array(p.to_array().map(|x| libm::scalbn(x, self.exponent)))
    }
}

/// Returns for each used vertex the smallest vertex with its position, and `NONE` for the others.
pub(super) fn first_at_position(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    job: &Job<'_>,
    stage: &'static str,
) -> Result<Vec<u32>> {
    let mut first = alloc::filled(NONE, points.len())?;
    triangles.as_flattened().iter().for_each(|&v| first[v as usize] = v);
    let mut order = alloc::gather(first.iter().copied().filter(|&v| v != NONE))?;
    let at = |v: u32| points[v as usize];
    let by_position = |&i: &u32, &j: &u32| {
        let (p, q) = (at(i), at(j));
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z)).then(i.cmp(&j))
    };
    sort(&mut order, by_position, job, stage)?;
    for same in order.chunk_by(|&i, &j| at(i) == at(j)) {
        same.iter().for_each(|&v| first[v as usize] = same[0]);
    }
    Ok(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_are_integers_on_their_grid() {
        let points = [DVec3::new(0.1, -1e-5, 3.0), DVec3::new(1e3, 0.0, 2f64.powi(-60))];
        let grid = Grid::from_points(points.into_iter());
        for p in points {
            let steps = grid.steps(p);
            assert_eq!(grid.position(steps), p);
            assert_eq!(steps, steps.round());
            assert!(steps.abs().max_element() < 2f64.powi(MAX_COORDINATE_BITS));
        }
        let grid = Grid::from_points([DVec3::new(2f64.powi(60), 3.0, 5e-324)].into_iter());
        assert_eq!(grid.position(grid.steps(DVec3::splat(5e-324))), DVec3::ZERO, "beyond the finest grid");
        for extreme in [f64::MAX, 5e-324] {
            let p = DVec3::new(extreme, -extreme, 0.0);
            let grid = Grid::from_points([p].into_iter());
            assert_eq!(grid.position(grid.steps(p)), p);
        }
    }
}
