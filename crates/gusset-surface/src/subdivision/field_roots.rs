//! All common roots of two fields over a patch, by [`subdivide`] into quarters.
//!
//! Proofs follow Mourrain and Pavone (2009) and Hanniel and Elber (2007), see
//! [`gusset_base::geom::subdivision`]:
//! - *empty*: all coefficients of a field have one sign. The fields tested are the two given ones,
//!   and two combinations of them that make the middle Jacobian the identity.
//! - *unique*: the Jacobian of the combinations is diagonally dominant all over the part, so that
//!   they take no pair of values twice. Newton's method finds the root, if it stays near the part.
//! - *unresolved*: all values of a field are within the tolerance. The two zero curves touch or
//!   coincide there.
//!
//! Cost: O(N^3) for each part, at most [`MAX_EXAMINED_PARTS`] parts.

use super::bernstein_field::{BernsteinField, FieldJet};
use glam::DVec2;
use gusset_base::error::Result;
use gusset_base::geom::subdivision::{
    BoxStack, BoxTest, Subdivision, SubdivisionLimits, UnresolvedBox, UnresolvedCluster, cluster_touching_boxes,
    subdivide,
};

/// Number of halvings of each parameter after which a part is given up.
const MAX_SUBDIVISION_DEPTH: u32 = 22;
/// Largest number of parts examined for one patch. Without a limit, curves that coincide would
/// never end.
const MAX_EXAMINED_PARTS: usize = 4096;
/// Largest number of parts if another method takes over when they do not suffice.
const MAX_EXAMINED_PARTS_IF_SIMPLE: usize = 256;
/// How far outside a part a root may be found besides rounding, as a fraction of the part. Both
/// sides of a border find the roots on it.
const MAX_FRACTION_OUTSIDE_PART: f64 = 1e-12;

/// Common roots of fields on patches, and memory that searches reuse.
#[derive(Debug, Clone, Default)]
pub(crate) struct FieldRoots<const N: usize> {
    /// Parameters of simple roots, each once.
    pub(crate) simple_roots: Vec<DVec2>,
    /// Where roots could not be resolved.
    pub(crate) unresolved: Vec<UnresolvedCluster>,
    stack: BoxStack<FieldPairPart<N>>,
    boxes: Vec<UnresolvedBox>,
}

#[derive(Debug, Clone)]
struct FieldPairPart<const N: usize> {
    fields: [BernsteinField<N>; 2],
    low_corner: DVec2,
    size: f64,
}

/// The search for roots on one patch.
struct FieldRootSearch<'a> {
    rounding_error: f64,
    tolerance: f64,
    simple_roots: &'a mut Vec<DVec2>,
    boxes: &'a mut Vec<UnresolvedBox>,
    /// Whether to stop at the first unresolved part.
    simple_only: bool,
}

/// Finds the common roots of two fields. Values up to `rounding_error` may be 0. Parts whose values
/// are all within `tolerance` need not be resolved.
pub(crate) fn find_roots<const N: usize>(
    fields: [BernsteinField<N>; 2],
    rounding_error: f64,
    tolerance: f64,
    found: &mut FieldRoots<N>,
) -> Result<()> {
    search_roots(fields, rounding_error, tolerance, false, found);
    cluster_touching_boxes(&found.boxes, &mut found.unresolved, || Ok(()))?;
    Ok(())
}

/// Finds the common roots of two fields if all of them can be resolved with little work. Otherwise
/// returns false, and `found` is meaningless.
pub(crate) fn find_simple_roots<const N: usize>(
    fields: [BernsteinField<N>; 2],
    rounding_error: f64,
    tolerance: f64,
    found: &mut FieldRoots<N>,
) -> bool {
    search_roots(fields, rounding_error, tolerance, true, found)
}

/// Finds simple roots. Returns false if the search stopped early.
#[inline]
fn search_roots<const N: usize>(
    fields: [BernsteinField<N>; 2],
    rounding_error: f64,
    tolerance: f64,
    simple_only: bool,
    found: &mut FieldRoots<N>,
) -> bool {
    let FieldRoots { simple_roots: simple, unresolved, stack, boxes } = found;
    simple.clear();
    unresolved.clear();
    boxes.clear();
    stack.clear();
    let mut search = FieldRootSearch { rounding_error, tolerance, simple_roots: simple, boxes, simple_only };
    let whole = FieldPairPart { fields, low_corner: DVec2::ZERO, size: 1.0 };
    let max_boxes = if simple_only { MAX_EXAMINED_PARTS_IF_SIMPLE } else { MAX_EXAMINED_PARTS };
    subdivide(&mut search, whole, stack, SubdivisionLimits { max_depth: MAX_SUBDIVISION_DEPTH, max_boxes }).is_ok()
}

/// Signals that a search for simple roots met an unresolved part.
struct NotSimpleRoot;

impl<const N: usize> Subdivision<FieldPairPart<N>, 4> for FieldRootSearch<'_> {
    /// The root in the part's parameters, and how far outside the part it may be because of
    /// rounding.
    type Solution = [DVec2; 2];
    type Split = ();
    type Stop = NotSimpleRoot;

    #[inline]
    fn classify_box(&mut self, part: &FieldPairPart<N>) -> Result<BoxTest<[DVec2; 2], ()>, NotSimpleRoot> {
        if part.fields.iter().any(|field| is_field_nonzero(field, self.rounding_error)) {
            return Ok(BoxTest::Empty);
        }
        let test = classify_fields(&part.fields, self.rounding_error);
        // Within the tolerance, values no longer tell where the other field's roots are.
        let is_within = |field: &BernsteinField<N>| {
            let [low, high] = field.coefficient_range();
            low >= -self.tolerance && high <= self.tolerance
        };
        let unresolved = matches!(test, BoxTest::Undecided(())) && part.fields.iter().any(is_within);
        Ok(if unresolved { BoxTest::Unresolved } else { test })
    }

    fn record_solution(&mut self, part: FieldPairPart<N>, [place, margin]: [DVec2; 2]) -> Result<(), NotSimpleRoot> {
        let place = part.low_corner + part.size * place;
        // A part on the other side of a border may have found the same root.
        let near = 2.0 * part.size * margin.max_element() + 1e-11;
        if !self.simple_roots.iter().any(|other| (*other - place).abs().max_element() <= near) {
            self.simple_roots.push(place.clamp(DVec2::ZERO, DVec2::ONE));
        }
        Ok(())
    }

    fn record_unresolved(&mut self, part: FieldPairPart<N>, _exhausted: bool) -> Result<(), NotSimpleRoot> {
        if self.simple_only {
            return Err(NotSimpleRoot);
        }
        let residual = part.fields.iter().map(|field| field.evaluate_jet(0.5, 0.5).value.abs()).fold(0.0, f64::max);
        let half = DVec2::splat(0.5 * part.size).extend(0.0);
        self.boxes.push(UnresolvedBox { middle: part.low_corner.extend(0.0) + half, half_size: half, residual });
        Ok(())
    }

    fn split_box(&mut self, part: FieldPairPart<N>, (): ()) -> [FieldPairPart<N>; 4] {
        let size = 0.5 * part.size;
        let [f, g] = part.fields.map(|field| field.quarters());
        let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
        std::array::from_fn(|k| FieldPairPart {
            fields: [f[k], g[k]],
            low_corner: part.low_corner + size * corners[k],
            size,
        })
    }
}

fn is_field_nonzero<const N: usize>(field: &BernsteinField<N>, rounding_error: f64) -> bool {
    let [low, high] = field.coefficient_range();
    low > rounding_error || high < -rounding_error
}

/// Tests a pair of fields. A root comes with the distance outside the part that rounding allows,
/// both in the part's parameters.
fn classify_fields<const N: usize>(fields: &[BernsteinField<N>; 2], rounding_error: f64) -> BoxTest<[DVec2; 2], ()> {
    let middle = fields.map(|field| field.evaluate_jet(0.5, 0.5));
    let determinant = middle[0].u * middle[1].v - middle[0].v * middle[1].u;
    let square = |slope: &FieldJet| slope.u * slope.u + slope.v * slope.v;
    let scale = square(&middle[0]) * square(&middle[1]);
    if determinant * determinant <= 1e-18 * scale || scale == 0.0 {
        return BoxTest::Undecided(());
    }
    // The inverse of the Jacobian maps the fields to nearly u - u0 and v - v0.
    let [a, b] = [middle[1].v / determinant, -middle[0].v / determinant];
    let [c, d] = [-middle[1].u / determinant, middle[0].u / determinant];
    let first = fields[0].linear_combination(a, &fields[1], b);
    let second = fields[0].linear_combination(c, &fields[1], d);
    let slack = rounding_error * DVec2::new(a.abs() + b.abs(), c.abs() + d.abs());
    if is_field_nonzero(&first, slack.x) || is_field_nonzero(&second, slack.y) {
        return BoxTest::Empty;
    }
    let [first_u, first_v] = first.derivative_ranges();
    let [second_u, second_v] = second.derivative_ranges();
    let max_abs = |range: [f64; 2]| range[0].abs().max(range[1].abs());
    if first_u[0] <= max_abs(first_v) || second_v[0] <= max_abs(second_u) {
        return BoxTest::Undecided(());
    }
    // Newton steps with the middle Jacobian, which is now the identity, would converge linearly.
    // With the Jacobian at the current place they converge quadratically.
    let mut place = DVec2::splat(0.5);
    for _ in 0..32 {
        let (f, g) = (first.evaluate_jet(place.x, place.y), second.evaluate_jet(place.x, place.y));
        let determinant = f.u * g.v - f.v * g.u;
        let step = DVec2::new(f.value * g.v - g.value * f.v, g.value * f.u - f.value * g.u) / determinant;
        // A dominant diagonal keeps the determinant positive within the part.
        if !step.is_finite() {
            return BoxTest::Undecided(());
        }
        let next = place - step;
        if next.clamp(DVec2::splat(-0.5), DVec2::splat(1.5)) != next {
            return BoxTest::Undecided(());
        }
        place = next;
        // Steps shrink quadratically, so the next one would be below rounding.
        if step.abs().max_element() <= 1e-9 {
            break;
        }
    }
    let margin = MAX_FRACTION_OUTSIDE_PART + 4.0 * slack;
    let inside = place.clamp(-margin, 1.0 + margin) == place;
    if inside { BoxTest::Unique([place, margin]) } else { BoxTest::Undecided(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A bicubic field from its values at the nodes of a regular 4 x 4 lattice.
    fn field_from_function(f: impl Fn(f64, f64) -> f64) -> BernsteinField<4> {
        // Interpolation of bicubics: Bernstein coefficients from values at 0, 1/3, 2/3, 1.
        let invert = |y: [f64; 4]| {
            let [a, b, c, d] = y;
            [a, (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0, (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0, d]
        };
        let at = |k: usize| k as f64 / 3.0;
        let rows: [[f64; 4]; 4] = std::array::from_fn(|a| invert(std::array::from_fn(|b| f(at(a), at(b)))));
        let columns: [[f64; 4]; 4] = std::array::from_fn(|b| invert(std::array::from_fn(|a| rows[a][b])));
        BernsteinField { coefficients: std::array::from_fn(|a| std::array::from_fn(|b| columns[b][a])) }
    }

    fn solve_roots(f: impl Fn(f64, f64) -> f64, g: impl Fn(f64, f64) -> f64) -> FieldRoots<4> {
        let mut found = FieldRoots::default();
        find_roots([field_from_function(f), field_from_function(g)], 1e-14, 1e-9, &mut found).unwrap();
        found.simple_roots.sort_by(|a, b| a.x.total_cmp(&b.x));
        found
    }

    #[test]
    fn all_roots_are_found_whether_none_one_or_nine() {
        assert!(solve_roots(|u, v| u + v + 0.1, |u, v| u - v).simple_roots.is_empty());
        let one = solve_roots(|u, _| u - 0.3, |_, v| v - 0.7);
        assert!(one.simple_roots.len() == 1 && one.simple_roots[0].distance(DVec2::new(0.3, 0.7)) < 1e-14);
        // A parabola and a line meet twice.
        let two = solve_roots(|u, v| v - 4.0 * (u - 0.5) * (u - 0.5), |_, v| v - 0.25);
        assert_eq!(two.simple_roots.len(), 2);
        assert!((two.simple_roots[0].x - 0.25).abs() < 1e-13 && (two.simple_roots[1].x - 0.75).abs() < 1e-13);
        // Two cubics with nine common roots: u takes three values on each of three lines.
        let cubic = |t: f64| (t - 0.2) * (t - 0.5) * (t - 0.9);
        let nine = solve_roots(move |u, _| cubic(u), move |_, v| cubic(v));
        assert_eq!((nine.simple_roots.len(), nine.unresolved.len()), (9, 0));
        // Roots at corners of parts are found once.
        let corner = solve_roots(|u, _| u - 0.5, |_, v| v - 0.5);
        assert_eq!(corner.simple_roots.len(), 1);
    }

    #[test]
    fn touching_curves_are_reported() {
        let touch = solve_roots(|u, v| v - (u - 0.37) * (u - 0.37), |_, v| v);
        assert!(!touch.unresolved.is_empty());
        // Roots that rounding creates there lie in the cluster.
        let is_near = |at: DVec2, cluster: &UnresolvedCluster| {
            let best = cluster.best_box.middle;
            best.truncate().distance(at) <= (cluster.high - best).max(best - cluster.low).length()
        };
        let in_cluster = |&at: &DVec2| touch.unresolved.iter().any(|cluster| is_near(at, cluster));
        assert!(touch.simple_roots.iter().all(in_cluster), "{touch:?}");
        let is_right = |at: DVec3| (at.x - 0.37).abs() < 1e-3 && at.y < 1e-3;
        assert!(touch.unresolved.iter().all(|cluster| is_right(cluster.best_box.middle)));
        // Two equal curves.
        let same = solve_roots(|u, v| u - v, |u, v| 2.0 * (u - v));
        assert!(!same.unresolved.is_empty() && same.unresolved.len() <= MAX_EXAMINED_PARTS);
    }
}
