//! The crossings on the sides of cells that `corner_crossing` decides, many at a time.

use gusset_base::simd::{self, Kernel};

/// Number of Newton steps for the crossing on a side of a cell.
const NEWTON_STEPS_PER_SIDE: usize = 4;

/// Number of sides whose roots are computed together.
const SIDES_PER_VECTOR: usize = 8;

/// Computes the roots of cubic polynomials along sides that
/// [`decide_crossing_by_corners`](super::corner_crossing::decide_crossing_by_corners) has proven to be crossed.
pub(super) fn compute_side_roots(sides: &[[f64; 4]], found: &mut Vec<f64>) {
    simd::run(SideRootKernel { side_polynomials: sides, roots: found });
}

struct SideRootKernel<'a> {
    side_polynomials: &'a [[f64; 4]],
    roots: &'a mut Vec<f64>,
}

impl Kernel for SideRootKernel<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for sides in self.side_polynomials.chunks(SIDES_PER_VECTOR) {
            let mut c = [[0.0; SIDES_PER_VECTOR]; 4];
            for lane in 0..SIDES_PER_VECTOR {
                let side = &sides[lane.min(sides.len() - 1)];
                (0..4).for_each(|k| c[k][lane] = side[k]);
            }
            let mut t = [0.0; SIDES_PER_VECTOR];
            solve_sides_by_newton(&c, &mut t);
            self.roots.extend_from_slice(&t[..sides.len()]);
        }
    }
}

#[inline(always)]
fn solve_sides_by_newton(c: &[[f64; SIDES_PER_VECTOR]; 4], t: &mut [f64; SIDES_PER_VECTOR]) {
    let clamped = |x: f64| {
        let x = if x > 0.0 { x } else { 0.0 };
        if x < 1.0 { x } else { 1.0 }
    };
    for lane in 0..SIDES_PER_VECTOR {
        t[lane] = clamped(c[0][lane] / (c[0][lane] - c[3][lane]));
    }
    for _ in 0..NEWTON_STEPS_PER_SIDE {
        for lane in 0..SIDES_PER_VECTOR {
            let [a, b, d, e] = [c[0][lane], c[1][lane], c[2][lane], c[3][lane]];
            let at = t[lane];
            // De Casteljau's algorithm.
            let (ab, bd, de) = (a + at * (b - a), b + at * (d - b), d + at * (e - d));
            let (low, high) = (ab + at * (bd - ab), bd + at * (de - bd));
            let rise = high - low;
            t[lane] = clamped(at - (low + at * rise) / (3.0 * rise));
        }
    }
    for lane in 0..SIDES_PER_VECTOR {
        // The value 0 at an end counts as positive, so the sign changes there.
        let start = if c[0][lane] == 0.0 { 0.0 } else { t[lane] };
        t[lane] = if c[3][lane] == 0.0 { 1.0 } else { start };
    }
}
