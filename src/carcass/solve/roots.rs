//! All common roots of two fields over a patch.
//!
//! A part of the patch is done when one of three proofs holds, else it is cut into four:
//! * *none*: a field, or a combination of the two that makes the middle Jacobian the identity, has coefficients of one sign;
//! * *at most one*: the Jacobian of the combined fields has a dominant diagonal all over the part, so that they take no pair of values
//!   twice; then Newton's method finds the root, if it stays;
//! * *too small*: all values of a field are within the tolerance; parts that touch are reported as one unresolved spot. That is where
//!   the two curves touch, or coincide.

use super::Field;
use glam::DVec2;

/// Halvings before a part is given up.
const DEPTH: u32 = 22;
/// Parts that may be looked at for one patch: curves that coincide would take them without end.
const PARTS: usize = 4096;
/// How far outside a part a root may be found, as a fraction of it: roots on borders are found from both sides.
const MARGIN: f64 = 1e-6;

/// What was found on a patch.
#[derive(Debug, Clone, Default)]
pub(crate) struct Roots {
    /// Parameters of simple roots; one on the border of parts may come more than once.
    pub(crate) simple: Vec<DVec2>,
    /// Spots that could not be resolved: where the values are least, and how far the spot reaches.
    pub(crate) unresolved: Vec<(DVec2, f64)>,
}

/// A part that could not be resolved.
struct Open {
    middle: DVec2,
    size: f64,
    /// The greater of the absolute values in the middle.
    value: f64,
}

struct Part<const N: usize> {
    fields: [Field<N>; 2],
    from: DVec2,
    size: f64,
    depth: u32,
}

impl<const N: usize> Part<N> {
    /// True if all values of a field are within the tolerance: it cannot say any more where the other's roots are.
    fn is_within(&self, tolerance: f64) -> bool {
        self.fields.iter().any(|field| {
            let [low, high] = field.range();
            low >= -tolerance && high <= tolerance
        })
    }
}

/// The common roots of two fields. `noise`: values up to that, in absolute terms, may be 0; `tolerance`: parts that have no greater ones need
/// no resolving.
pub(crate) fn roots<const N: usize>(fields: [Field<N>; 2], noise: f64, tolerance: f64, found: &mut Roots) {
    let mut parts = vec![Part { fields, from: DVec2::ZERO, size: 1.0, depth: 0 }];
    let (mut looked_at, mut open) = (0, Vec::new());
    while let Some(part) = parts.pop() {
        looked_at += 1;
        if part.fields.iter().any(|field| has_none(field, noise)) {
            continue;
        }
        match decide(&part.fields, noise) {
            Verdict::None => {}
            Verdict::One(place) => {
                let place = part.from + part.size * place;
                if !found.simple.iter().any(|other| other.distance(place) < 1e-9) {
                    found.simple.push(place.clamp(DVec2::ZERO, DVec2::ONE));
                }
            }
            Verdict::Open if part.depth == DEPTH || looked_at >= PARTS || part.is_within(tolerance) => {
                let value = part.fields.iter().map(|field| field.at(0.5, 0.5).value.abs()).fold(0.0, f64::max);
                open.push(Open { middle: part.from + 0.5 * part.size, size: part.size, value });
            }
            Verdict::Open => {
                let half = 0.5 * part.size;
                let [f, g] = part.fields.map(|field| field.quarters());
                let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
                for ((f, g), corner) in f.into_iter().zip(g).zip(corners) {
                    let from = part.from + half * corner;
                    parts.push(Part { fields: [f, g], from, size: half, depth: part.depth + 1 });
                }
            }
        }
    }
    spots(&open, &mut found.unresolved);
}

/// Parts that touch are one spot.
fn spots(open: &[Open], spots: &mut Vec<(DVec2, f64)>) {
    let mut spot_of: Vec<usize> = (0..open.len()).collect();
    for (i, part) in open.iter().enumerate() {
        for (j, other) in open[..i].iter().enumerate() {
            let apart = (part.middle - other.middle).abs().max_element();
            if apart <= 0.5000001 * (part.size + other.size) && spot_of[i] != spot_of[j] {
                let (from, to) = (spot_of[i].max(spot_of[j]), spot_of[i].min(spot_of[j]));
                spot_of.iter_mut().for_each(|spot| *spot = if *spot == from { to } else { *spot });
            }
        }
    }
    for spot in (0..open.len()).filter(|&spot| spot_of[spot] == spot) {
        let members = || open.iter().zip(&spot_of).filter(|&(_, &of)| of == spot).map(|(part, _)| part);
        let best = members().fold(&open[spot], |best, part| if part.value < best.value { part } else { best });
        let reach = members().map(|part| best.middle.distance(part.middle) + part.size).fold(0.0, f64::max);
        spots.push((best.middle, reach));
    }
}

/// What can be said of a part.
enum Verdict {
    None,
    One(DVec2),
    Open,
}

fn has_none<const N: usize>(field: &Field<N>, noise: f64) -> bool {
    let [low, high] = field.range();
    low > noise || high < -noise
}

fn decide<const N: usize>(fields: &[Field<N>; 2], noise: f64) -> Verdict {
    let middle = fields.map(|field| field.at(0.5, 0.5));
    let determinant = middle[0].u * middle[1].v - middle[0].v * middle[1].u;
    let scale = middle[0].u.hypot(middle[0].v) * middle[1].u.hypot(middle[1].v);
    if determinant.abs() <= 1e-9 * scale || scale == 0.0 {
        return Verdict::Open;
    }
    // The inverse of the Jacobian takes the fields to ones that are nearly u - u0 and v - v0.
    let [a, b] = [middle[1].v / determinant, -middle[0].v / determinant];
    let [c, d] = [-middle[1].u / determinant, middle[0].u / determinant];
    let first = fields[0].combined(a, &fields[1], b);
    let second = fields[0].combined(c, &fields[1], d);
    if has_none(&first, noise * (a.abs() + b.abs())) || has_none(&second, noise * (c.abs() + d.abs())) {
        return Verdict::None;
    }
    let [first_u, first_v] = first.slope_ranges();
    let [second_u, second_v] = second.slope_ranges();
    let most = |range: [f64; 2]| range[0].abs().max(range[1].abs());
    if first_u[0] <= most(first_v) || second_v[0] <= most(second_u) {
        return Verdict::Open;
    }
    // Newton's steps with the middle Jacobian, which is the identity now, converge; with the true one, quickly.
    let mut place = DVec2::splat(0.5);
    for _ in 0..32 {
        let (f, g) = (first.at(place.x, place.y), second.at(place.x, place.y));
        let determinant = f.u * g.v - f.v * g.u;
        let step = DVec2::new(f.value * g.v - g.value * f.v, g.value * f.u - f.value * g.u) / determinant;
        // A dominant diagonal keeps the determinant positive within the part.
        if !step.is_finite() {
            return Verdict::Open;
        }
        let next = place - step;
        if next.clamp(DVec2::splat(-0.5), DVec2::splat(1.5)) != next {
            return Verdict::Open;
        }
        place = next;
        if step.abs().max_element() <= 1e-15 {
            break;
        }
    }
    let inside = place.clamp(DVec2::splat(-MARGIN), DVec2::splat(1.0 + MARGIN)) == place;
    if inside { Verdict::One(place) } else { Verdict::Open }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The field (u - a) (v - b) - c and others, from values at the nodes of the Bernstein form of degree 1 raised to 3.
    fn of(f: impl Fn(f64, f64) -> f64) -> Field<4> {
        // Interpolation of bicubics: Bernstein coefficients from values at 0, 1/3, 2/3, 1.
        let invert = |y: [f64; 4]| {
            let [a, b, c, d] = y;
            [a, (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0, (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0, d]
        };
        let at = |k: usize| k as f64 / 3.0;
        let rows: [[f64; 4]; 4] = std::array::from_fn(|a| invert(std::array::from_fn(|b| f(at(a), at(b)))));
        let columns: [[f64; 4]; 4] = std::array::from_fn(|b| invert(std::array::from_fn(|a| rows[a][b])));
        Field { c: std::array::from_fn(|a| std::array::from_fn(|b| columns[b][a])) }
    }

    fn solve(f: impl Fn(f64, f64) -> f64, g: impl Fn(f64, f64) -> f64) -> Roots {
        let mut found = Roots::default();
        roots([of(f), of(g)], 1e-14, 1e-9, &mut found);
        found.simple.sort_by(|a, b| a.x.total_cmp(&b.x));
        found
    }

    #[test]
    fn none_one_and_many() {
        assert!(solve(|u, v| u + v + 0.1, |u, v| u - v).simple.is_empty());
        let one = solve(|u, _| u - 0.3, |_, v| v - 0.7);
        assert!(one.simple.len() == 1 && one.simple[0].distance(DVec2::new(0.3, 0.7)) < 1e-14);
        // A parabola and a line: two.
        let two = solve(|u, v| v - 4.0 * (u - 0.5) * (u - 0.5), |_, v| v - 0.25);
        assert_eq!(two.simple.len(), 2);
        assert!((two.simple[0].x - 0.25).abs() < 1e-13 && (two.simple[1].x - 0.75).abs() < 1e-13);
        // Two cubics, nine roots: u takes three values on each of three.
        let cubic = |t: f64| (t - 0.2) * (t - 0.5) * (t - 0.9);
        let nine = solve(move |u, _| cubic(u), move |_, v| cubic(v));
        assert_eq!((nine.simple.len(), nine.unresolved.len()), (9, 0));
        // At corners of parts, found once.
        let corner = solve(|u, _| u - 0.5, |_, v| v - 0.5);
        assert_eq!(corner.simple.len(), 1);
    }

    #[test]
    fn touching_curves_are_reported() {
        let touch = solve(|u, v| v - (u - 0.37) * (u - 0.37), |_, v| v);
        assert!(touch.simple.is_empty() && !touch.unresolved.is_empty());
        assert!(touch.unresolved.iter().all(|(place, _)| (place.x - 0.37).abs() < 1e-3 && place.y < 1e-3));
        // One curve twice.
        let same = solve(|u, v| u - v, |u, v| 2.0 * (u - v));
        assert!(!same.unresolved.is_empty() && same.unresolved.len() <= PARTS);
    }
}
