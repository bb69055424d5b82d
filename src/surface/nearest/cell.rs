//! The nearest point of one patch, with proof.
//!
//! A patch is done when one of the bounds (see `bounds`) comes within the tolerance of the best point found, else it is cut into parts: those
//! that may be nearest first.

use super::descend::{FEW_STEPS, Foot, STEPS, descend};
use crate::surface::Patch;
use crate::surface::construct::part;
use glam::{DVec2, DVec3};

/// The nearest point found on a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found {
    pub(crate) place: DVec2,
    pub(crate) distance: f64,
    /// No point of the patch is nearer than this.
    pub(crate) bound: f64,
}

impl Found {
    fn new(foot: &Foot, bound: f64) -> Found {
        Found { place: foot.place, distance: foot.distance, bound: bound.min(foot.distance) }
    }
}

/// How often a side may be halved.
pub(super) const DEPTH: i32 = 26;
/// Parts of one patch that are looked at before it is given up.
const PARTS: usize = 192;

/// Part of a patch: its control net, where it is, and a lower bound of its distance.
pub(super) struct Part<const N: usize> {
    pub(super) patch: Patch<N>,
    pub(super) from: DVec2,
    pub(super) size: DVec2,
    pub(super) bound: f64,
}

/// What a search of patches needs again and again.
pub(crate) struct Workspace<const N: usize> {
    /// By falling bounds.
    parts: Vec<Part<N>>,
}

impl<const N: usize> Default for Workspace<N> {
    fn default() -> Self {
        Workspace { parts: Vec::new() }
    }
}

impl<const N: usize> Workspace<N> {
    fn add(&mut self, part: Part<N>) {
        let at = self.parts.partition_point(|other| other.bound > part.bound);
        self.parts.insert(at, part);
    }
}

/// The nearest point of a patch to `query`, looked for from `start`; `None` if all of the patch is farther than `limit`.
///
/// What is found does not depend on the limit. It is nearest to within `tolerance`, unless the bound says that there is no proof within
/// [`PARTS`] parts and [`DEPTH`] halvings.
pub(crate) fn nearest<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    start: DVec2,
    limit: f64,
    tolerance: f64,
    workspace: &mut Workspace<N>,
) -> Option<Found> {
    let foot = descend(patch, query, start, STEPS);
    let proven = proven(patch, query, &foot, 0.0, tolerance);
    if proven > limit {
        return None;
    }
    if proven >= foot.distance - tolerance {
        return Some(Found::new(&foot, proven));
    }
    divided(patch, query, foot, limit, tolerance, workspace)
}

/// The better one of the bounds, of which the dearer one is looked at only if the other does not do.
pub(super) fn proven<const N: usize>(patch: &Patch<N>, query: DVec3, foot: &Foot, known: f64, tolerance: f64) -> f64 {
    let direction = (query - foot.jet.point).normalize_or_zero();
    let bound = known.max(patch.half_space(query, direction));
    if bound >= foot.distance - tolerance { bound } else { bound.max(patch.convex(query, foot)) }
}

/// As [`nearest`], where the whole patch cannot be proved at once.
#[cold]
fn divided<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    mut best: Foot,
    limit: f64,
    tolerance: f64,
    workspace: &mut Workspace<N>,
) -> Option<Found> {
    workspace.parts.clear();
    let whole = Part { patch: *patch, from: DVec2::ZERO, size: DVec2::ONE, bound: 0.0 };
    whole.divide(|part| workspace.add(part.bounded(query)));
    // The least bound of the parts that are done.
    let mut done = f64::INFINITY;
    let mut looked_at = 0;
    while let Some(part) = workspace.parts.pop() {
        let open = part.bound.min(done);
        if open > limit {
            return None;
        }
        if part.bound >= best.distance - tolerance || looked_at == PARTS {
            done = open;
            break;
        }
        looked_at += 1;
        let local = descend(&part.patch, query, DVec2::splat(0.5), FEW_STEPS);
        if local.distance < best.distance {
            // As the whole patch has it: the part's control points are rounded.
            let foot = Foot::at(patch, query, part.from + part.size * local.place);
            if foot.distance < best.distance {
                best = foot;
            }
        }
        let proven = proven(&part.patch, query, &local, part.bound, tolerance);
        if proven >= best.distance - tolerance || part.size.min_element() <= 0.5_f64.powi(DEPTH) {
            done = done.min(proven);
        } else {
            Part { bound: proven, ..part }.divide(|part| workspace.add(part.bounded(query)));
        }
    }
    (done <= limit).then(|| Found::new(&best, done))
}

impl<const N: usize> Part<N> {
    /// Cuts it across its longer direction, or both if they are alike.
    pub(super) fn divide(&self, mut add: impl FnMut(Part<N>)) {
        let half = 0.5 * self.size;
        let mut give = |patch, corner: DVec2, size| add(Part { patch, from: self.from + corner, size, ..*self });
        let [u, v] = self.patch.extents();
        if u > 2.0 * v {
            let [low, high] = self.patch.halves();
            give(low, DVec2::ZERO, DVec2::new(half.x, self.size.y));
            give(high, DVec2::new(half.x, 0.0), DVec2::new(half.x, self.size.y));
        } else if v > 2.0 * u {
            let [low, high] = self.patch.transposed().halves();
            give(low.transposed(), DVec2::ZERO, DVec2::new(self.size.x, half.y));
            give(high.transposed(), DVec2::new(0.0, half.y), DVec2::new(self.size.x, half.y));
        } else {
            let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
            for (patch, corner) in self.patch.quarters().into_iter().zip(corners) {
                give(patch, half * corner, half);
            }
        }
    }

    /// With the bounds that need no nearest point: by the box, and by the half-space through the middle.
    pub(super) fn bounded(mut self, query: DVec3) -> Part<N> {
        let [[a, b], [c, d]] = self.patch.corners();
        let direction = (4.0 * query - (a + b + c + d)).normalize_or_zero();
        let bound = self.patch.box_distance(query).max(self.patch.half_space(query, direction));
        self.bound = self.bound.max(bound);
        self
    }
}

impl<const N: usize> Patch<N> {
    /// The part between two pairs of parameters.
    pub(super) fn cut(&self, from: DVec2, to: DVec2) -> Patch<N> {
        let points = self.points.map(|row| part(&row, [from.y, to.y]));
        let across = Patch { points }.transposed();
        Patch { points: across.points.map(|row| part(&row, [from.x, to.x])) }.transposed()
    }

    /// The greatest distances between first and last control points, in u and in v.
    fn extents(&self) -> [f64; 2] {
        let p = &self.points;
        let across = |k: usize| [p[0][k].distance_squared(p[N - 1][k]), p[k][0].distance_squared(p[k][N - 1])];
        let all = (0..N).map(across).fold([0.0_f64; 2], |[u, v], [x, y]| [u.max(x), v.max(y)]);
        all.map(f64::sqrt)
    }
}
