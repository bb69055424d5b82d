//! All common roots of two fields over a patch.
//!
//! A part of the patch is done when one of three proofs holds, else it is cut into four:
//! * *none*: a field, or a combination of the two that makes the middle Jacobian the identity, has coefficients of one sign;
//! * *at most one*: the Jacobian of the combined fields has a dominant diagonal all over the part, so that they take no pair of values
//!   twice; then Newton's method finds the root, if it stays;
//! * *too small*: all values of a field are within the tolerance; parts that touch are reported as one unresolved spot. That is where
//!   the two curves touch, or coincide.

use super::field::{Field, Slope};
use super::spots::{Open, add_spots};
use glam::DVec2;

/// Halvings before a part is given up.
const DEPTH: u32 = 22;
/// Parts that may be looked at for one patch: curves that coincide would take them without end.
const PARTS: usize = 4096;
/// The same where something else is tried then.
const FEW: usize = 256;
/// How far outside a part a root may be found, as a fraction of it, besides rounding: roots on borders are found from both sides.
const MARGIN: f64 = 1e-12;

/// What was found on patches, and room for the work.
#[derive(Debug, Clone, Default)]
pub(crate) struct Roots<const N: usize> {
    /// Parameters of simple roots, each once.
    pub(crate) simple: Vec<DVec2>,
    /// Spots that could not be resolved: where the values are least, and how far the spot reaches.
    pub(crate) unresolved: Vec<(DVec2, f64)>,
    parts: Vec<Part<N>>,
    open: Vec<Open>,
}

#[derive(Debug, Clone)]
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

/// Adds the common roots of two fields. `noise`: values up to that, in absolute terms, may be 0; `tolerance`: parts that have no greater
/// ones need no resolving.
pub(crate) fn roots<const N: usize>(fields: [Field<N>; 2], noise: f64, tolerance: f64, found: &mut Roots<N>) {
    if !search(fields, noise, tolerance, PARTS, found) {
        let mut spots = Vec::new();
        add_spots(&found.open, &mut spots);
        found.unresolved.extend(spots.iter().map(|spot| {
            let reach = (spot.high - spot.place).max(spot.place - spot.low);
            (spot.place.truncate(), reach.length())
        }));
    }
}

/// Adds the common roots of two fields if all can be resolved with little work; else returns false, and what was found is of no use.
pub(crate) fn simple_roots<const N: usize>(
    fields: [Field<N>; 2],
    noise: f64,
    tolerance: f64,
    found: &mut Roots<N>,
) -> bool {
    search(fields, noise, tolerance, FEW, found)
}

/// Adds simple roots; false if parts were left open. With less than the usual patience it ends with the first of them.
fn search<const N: usize>(
    fields: [Field<N>; 2],
    noise: f64,
    tolerance: f64,
    patience: usize,
    found: &mut Roots<N>,
) -> bool {
    let known = found.simple.len();
    found.open.clear();
    found.parts.clear();
    let mut next = Some(Part { fields, from: DVec2::ZERO, size: 1.0, depth: 0 });
    let mut looked_at = 0;
    while let Some(part) = next.take().or_else(|| found.parts.pop()) {
        looked_at += 1;
        if part.fields.iter().any(|field| has_none(field, noise)) {
            continue;
        }
        match decide(&part.fields, noise) {
            Verdict::None => {}
            Verdict::One(place, margin) => {
                let place = part.from + part.size * place;
                // Found again on the border of parts, if it is within what rounding allows.
                let near = 2.0 * part.size * margin.max_element() + 1e-11;
                if !found.simple[known..].iter().any(|other| (*other - place).abs().max_element() <= near) {
                    found.simple.push(place.clamp(DVec2::ZERO, DVec2::ONE));
                }
            }
            Verdict::Open if part.depth == DEPTH || looked_at >= patience || part.is_within(tolerance) => {
                let value = part.fields.iter().map(|field| field.at(0.5, 0.5).value.abs()).fold(0.0, f64::max);
                let half = DVec2::splat(0.5 * part.size).extend(0.0);
                found.open.push(Open { middle: part.from.extend(0.0) + half, half, value });
                if patience < PARTS {
                    return false;
                }
            }
            Verdict::Open => {
                let half = 0.5 * part.size;
                let [f, g] = part.fields.map(|field| field.quarters());
                let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
                for ((f, g), corner) in f.into_iter().zip(g).zip(corners) {
                    let from = part.from + half * corner;
                    found.parts.push(Part { fields: [f, g], from, size: half, depth: part.depth + 1 });
                }
            }
        }
    }
    found.open.is_empty()
}

/// What can be said of a part.
enum Verdict {
    None,
    /// A root, and how far outside the part it may be for rounding.
    One(DVec2, DVec2),
    Open,
}

fn has_none<const N: usize>(field: &Field<N>, noise: f64) -> bool {
    let [low, high] = field.range();
    low > noise || high < -noise
}

fn decide<const N: usize>(fields: &[Field<N>; 2], noise: f64) -> Verdict {
    let middle = fields.map(|field| field.at(0.5, 0.5));
    let determinant = middle[0].u * middle[1].v - middle[0].v * middle[1].u;
    let square = |slope: &Slope| slope.u * slope.u + slope.v * slope.v;
    let scale = square(&middle[0]) * square(&middle[1]);
    if determinant * determinant <= 1e-18 * scale || scale == 0.0 {
        return Verdict::Open;
    }
    // The inverse of the Jacobian takes the fields to ones that are nearly u - u0 and v - v0.
    let [a, b] = [middle[1].v / determinant, -middle[0].v / determinant];
    let [c, d] = [-middle[1].u / determinant, middle[0].u / determinant];
    let first = fields[0].combined(a, &fields[1], b);
    let second = fields[0].combined(c, &fields[1], d);
    let play = noise * DVec2::new(a.abs() + b.abs(), c.abs() + d.abs());
    if has_none(&first, play.x) || has_none(&second, play.y) {
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
        // The steps shrink quadratically: the next one would be below rounding.
        if step.abs().max_element() <= 1e-9 {
            break;
        }
    }
    let margin = MARGIN + 4.0 * play;
    let inside = place.clamp(-margin, 1.0 + margin) == place;
    if inside { Verdict::One(place, margin) } else { Verdict::Open }
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

    fn solve(f: impl Fn(f64, f64) -> f64, g: impl Fn(f64, f64) -> f64) -> Roots<4> {
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
        assert!(!touch.unresolved.is_empty());
        // What rounding makes a root there is in the spot.
        let in_spot = |at: &DVec2| touch.unresolved.iter().any(|(place, reach)| place.distance(*at) <= *reach);
        assert!(touch.simple.iter().all(in_spot), "{touch:?}");
        assert!(touch.unresolved.iter().all(|(place, _)| (place.x - 0.37).abs() < 1e-3 && place.y < 1e-3));
        // One curve twice.
        let same = solve(|u, v| u - v, |u, v| 2.0 * (u - v));
        assert!(!same.unresolved.is_empty() && same.unresolved.len() <= PARTS);
    }
}
