//! Contact points: resolves clusters of unresolved balls by the relative second form.
//!
//! Where two surfaces nearly touch, both are graphs over a common tangent plane. They meet where
//! the difference D of their heights is 0. The second derivatives of D are called the relative
//! second form (Patrikalakis and Maekawa 2002, section 6). A cluster of balls is resolved if this
//! form is proven to be positive definite, negative definite or indefinite over all boxes of the
//! cluster. Newton's method then finds its critical point, where the normals are parallel. The
//! value of D there decides:
//!
//! | D at the critical point | definite | indefinite |
//! |---|---|---|
//! | 0, to the tolerance | the surfaces touch in a point | two branches cross |
//! | positive | D > 0: they are apart | two branches pass each other |
//! | negative | a loop, which `pair_search` finds | two branches pass each other, on the other sides |
//!
//! The table assumes a positive form. D is convex where the form is definite, so it has at most one
//! critical point and one loop. All other clusters are reported as unresolved.
//!
//! Cost: O(n log n) for n balls, O(N^3) for each ball, and a few evaluations for each cluster.

use super::cell_pairs::CellPair;
use super::height_graph::{FormDefiniteness, HeightDerivativeIntervals, Interval};
use super::pair_search::UnresolvedBall;
use crate::{Place, Surface, each_sheet};
use glam::{DMat2, DMat3, DVec4};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;

/// Largest number of balls in a cluster. A larger cluster is not a contact point.
const MAX_BALLS_PER_CLUSTER: usize = 4096;
/// Largest number of balls of a cluster from which Newton's method starts.
const MAX_NEWTON_STARTS_PER_CLUSTER: usize = 32;
/// Number of neighbouring balls visited between two progress reports.
const NEIGHBOURS_PER_REPORT: usize = 1 << 18;
/// Largest size of a contact, in radii of its rim, sqrt(2 tolerance / smallest curvature). Boxes
/// are not halved below that size.
const MAX_CONTACT_SIZE_IN_RIM_RADII: f64 = 4.0;
/// Largest number of Newton steps.
const MAX_NEWTON_STEPS: usize = 32;
/// How far outside its cells a critical point may be, in parameters. A point on a side belongs to
/// the cells on both sides.
const MAX_PARAMETER_OUTSIDE_CELL: f64 = 1e-6;

/// A critical point of D: a place where two surfaces touch, or nearly touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct CriticalPoint {
    /// The place: a pair of cells, and parameters of both.
    pub(super) pair: u32,
    pub(super) parameters: DVec4,
    /// The position relative to the origin of the balls.
    pub(super) point: DVec3,
    /// The unit normal of the first surface.
    pub(super) normal: DVec3,
    /// Signed height of the first surface above the second one, along the normal of the first one.
    pub(super) gap: f64,
    /// The cluster lies within this distance. So does the neighbourhood in which the heights at a
    /// minimum differ by at most the tolerance.
    pub(super) radius: f64,
    /// Whether the relative second form is indefinite.
    pub(super) is_saddle: bool,
    /// Whether the normals are opposite.
    pub(super) is_opposed: bool,
}

impl CriticalPoint {
    /// The side to which branches turn when they pass each other, seen against the normal: 1 is
    /// left.
    ///
    /// Along N_A x N_B, A is above B on the right, or below it if the normals are opposite.
    pub(super) fn side_on_which_branches_pass(&self) -> f64 {
        if self.is_opposed { -self.gap.signum() } else { self.gap.signum() }
    }
}

/// The clusters that were resolved.
#[derive(Debug, Default)]
pub(super) struct CriticalPoints {
    pub(super) points: Vec<CriticalPoint>,
    /// For each ball, the index of the point that explains it, [`EXPLAINED_AS_APART`] or
    /// [`NOT_EXPLAINED`].
    pub(super) explanations: Vec<u32>,
}

/// Marks balls in which the surfaces are farther apart than the tolerance.
pub(super) const EXPLAINED_AS_APART: u32 = u32::MAX - 1;
/// Marks balls that are not explained.
pub(super) const NOT_EXPLAINED: u32 = u32::MAX;

/// The result of Newton's method from a ball.
enum CriticalPointOutcome {
    Found(CriticalPoint),
    /// The iteration left the ball's cells, towards about this point.
    Beyond(DVec3),
}

/// The search for critical points of two surfaces.
pub(super) struct ContactSearch<'a> {
    pub(super) surfaces: [&'a Surface<'a>; 2],
    pub(super) pairs: &'a [CellPair],
    pub(super) balls: &'a [UnresolvedBall],
    /// The origin of the balls' coordinates.
    pub(super) origin: DVec3,
    pub(super) tolerance: f64,
    /// Accuracy of places.
    pub(super) resolution: f64,
}

/// Returns an orthonormal frame whose third axis is `normal`.
fn frame_with_normal(normal: DVec3) -> DMat3 {
    let (x, y) = normal.any_orthonormal_pair();
    DMat3::from_cols(x, y, normal)
}

impl ContactSearch<'_> {
    /// Resolves all clusters that can be resolved.
    pub(super) fn resolve_clusters(&self, job: &Job<'_>) -> Result<CriticalPoints> {
        let mut critical =
            CriticalPoints { points: Vec::new(), explanations: alloc::filled(NOT_EXPLAINED, self.balls.len())? };
        if self.balls.is_empty() {
            return Ok(critical);
        }
        for (k, cluster) in self.cluster_balls(job)?.iter().enumerate() {
            if k.is_multiple_of(64) {
                job.step(0.0, "contact")?;
            }
            let Some(point) = self.resolve_cluster(cluster) else { continue };
            let is_apart = !point.is_saddle && point.gap.abs() > self.tolerance;
            let number = if is_apart { EXPLAINED_AS_APART } else { critical.points.len() as u32 };
            cluster.iter().for_each(|&ball| critical.explanations[ball as usize] = number);
            if !is_apart {
                alloc::push(&mut critical.points, point)?;
            }
        }
        self.assign_balls_on_contact_rims(&mut critical);
        Ok(critical)
    }

    /// Assigns remaining balls within a contact to it. They lie on the rim of a lens thinner than
    /// the tolerance. Arcs on the rim are removed too.
    fn assign_balls_on_contact_rims(&self, found: &mut CriticalPoints) {
        for (ball, number) in
            self.balls.iter().zip(&mut found.explanations).filter(|(_, number)| **number == NOT_EXPLAINED)
        {
            let is_of = |point: &CriticalPoint| {
                let sheets = [ball.pair, point.pair].map(|pair| self.pairs[pair as usize].sheets);
                let is_near = ball.centre.distance(point.point) + ball.radius <= point.radius;
                !point.is_saddle && is_near && sheets[0] == sheets[1]
            };
            if let Some(k) = found.points.iter().position(is_of) {
                *number = k as u32;
            }
        }
    }

    /// Groups balls that are close to each other, whatever their sheets. Between the balls of a
    /// crossing there may be boxes that are resolved.
    fn cluster_balls(&self, job: &Job<'_>) -> Result<Vec<Vec<u32>>> {
        let balls = self.balls;
        let centres = alloc::collect(balls.iter().map(|ball| ball.centre))?;
        let tree = KdTree::new(&centres, job, "contact")?;
        let mut sets = DisjointSets::new(balls.len())?;
        let mut visits = 0;
        for (k, ball) in balls.iter().enumerate() {
            // If all balls coincide, each of them has all others as neighbours.
            if visits >= NEIGHBOURS_PER_REPORT || k == 0 {
                job.step(0.0, "contact")?;
                visits = 0;
            }
            visits += 1;
            // Only smaller balls count, so all of them are within four times the radius.
            let limit = 4.0 * ball.radius + 4.0 * self.resolution;
            tree.for_each_within(ball.centre, ScaledRadius::new(limit.max(f64::MIN_POSITIVE)), &mut |_, n| {
                visits += 1;
                let other = &balls[n as usize];
                let touch = 2.0 * (ball.radius + other.radius) + 4.0 * self.resolution;
                if other.radius <= ball.radius && other.centre.distance(ball.centre) <= touch {
                    sets.union(k as u32, n);
                }
            });
        }
        let mut clusters: Vec<Vec<u32>> = Vec::new();
        let mut number = alloc::filled(u32::MAX, balls.len())?;
        for k in 0..balls.len() as u32 {
            let root = sets.find(k) as usize;
            if number[root] == u32::MAX {
                number[root] = clusters.len() as u32;
                alloc::push(&mut clusters, Vec::new())?;
            }
            alloc::push(&mut clusters[number[root] as usize], k)?;
        }
        Ok(clusters)
    }

    /// The critical point of a cluster, if it is proven to be the only one, and explains the
    /// cluster.
    fn resolve_cluster(&self, cluster: &[u32]) -> Option<CriticalPoint> {
        let ball = |&k: &u32| &self.balls[k as usize];
        if cluster.len() > MAX_BALLS_PER_CLUSTER || cluster.iter().any(|k| ball(k).is_whole) {
            return None;
        }
        let mut order: Vec<&UnresolvedBall> = alloc::collect(cluster.iter().map(ball)).ok()?;
        order.sort_by(|a, b| a.gap.total_cmp(&b.gap).then(a.pair.cmp(&b.pair)));
        let found = self.critical_point_among(&order)?;
        let mut forms = cluster.iter().map(|k| self.definiteness_over_ball(ball(k), &frame_with_normal(found.normal)));
        let form = forms.next()??;
        if form == FormDefiniteness::Unknown || forms.any(|other| other != Some(form)) {
            return None;
        }
        let is_saddle = form == FormDefiniteness::Indefinite;
        let height = if form == FormDefiniteness::Negative { -found.gap } else { found.gap };
        // The critical point inside a loop does not explain the loop.
        (is_saddle || height >= -self.tolerance).then_some(CriticalPoint { is_saddle, ..found })
    }

    fn places_of_pair(&self, pair: u32, x: DVec4) -> [Place; 2] {
        let CellPair { sheets: [a, b], cells: [p, q] } = self.pairs[pair as usize];
        [Place { sheet: a, cell: p, u: x.x, v: x.y }, Place { sheet: b, cell: q, u: x.z, v: x.w }]
    }

    /// Finds the critical point of some balls. Starts at the ball with the smallest gap, and
    /// continues with the ball nearest to the point towards which the previous start led.
    fn critical_point_among(&self, balls: &[&UnresolvedBall]) -> Option<CriticalPoint> {
        let mut left = alloc::collect(0..balls.len()).ok()?;
        let mut towards: Option<DVec3> = None;
        for _ in 0..MAX_NEWTON_STARTS_PER_CLUSTER.min(balls.len()) {
            let far = |&k: &usize| towards.map_or(0.0, |point| balls[k].centre.distance_squared(point));
            let (at, &ball) =
                left.iter().enumerate().min_by(|a, b| far(a.1).total_cmp(&far(b.1)).then(a.1.cmp(b.1)))?;
            left.swap_remove(at);
            match self.find_critical_point(balls[ball], balls) {
                Some(CriticalPointOutcome::Found(point)) => return Some(point),
                Some(CriticalPointOutcome::Beyond(point)) => towards = Some(point),
                None => {}
            }
        }
        None
    }

    /// Newton's method for the point near a ball where the normals are parallel, and the difference
    /// of the two points is along them. The result counts if it is in the ball's cells and in one
    /// of `balls`.
    ///
    /// Let p and q be the points in the tangent plane of the first surface, g and h the slopes, G
    /// and H the second derivatives. If the first point moves by d and the second by d + p - q, the
    /// points coincide in the plane. The slopes become g + G d and h + H (d + p - q), which must be
    /// equal.
    fn find_critical_point(&self, ball: &UnresolvedBall, balls: &[&UnresolvedBall]) -> Option<CriticalPointOutcome> {
        let (mut x, mut last) = (ball.parameters, f64::INFINITY);
        for _ in 0..MAX_NEWTON_STEPS {
            let [a, b] = self.places_of_pair(ball.pair, x);
            let (jets, normal) = ([self.surfaces[0].jet(a), self.surfaces[1].jet(b)], self.surfaces[0].normal(a));
            let frame = frame_with_normal(normal.try_normalize()?);
            let [one, other] = [
                HeightDerivativeIntervals::from_jet(&jets[0], &frame)?,
                HeightDerivativeIntervals::from_jet(&jets[1], &frame)?,
            ];
            let away = (frame.transpose() * (jets[0].point - jets[1].point)).truncate();
            let second = |graph: &HeightDerivativeIntervals| {
                let [xx, xy, yy] = graph.second.map(Interval::middle);
                DMat2::from_cols(DVec2::new(xx, xy), DVec2::new(xy, yy))
            };
            let slopes = |graph: &HeightDerivativeIntervals| DVec2::from_array(graph.slopes.map(Interval::middle));
            let (g, h) = (second(&one), second(&other));
            let in_plane = (g - h).inverse() * (slopes(&other) - slopes(&one) + h * away);
            let by_parameters = |graph: &HeightDerivativeIntervals, step: DVec2| {
                graph.inverse.map(|[x, y]| x.middle() * step.x + y.middle() * step.y)
            };
            let ([s, t], [u, v]) = (by_parameters(&one, in_plane), by_parameters(&other, in_plane + away));
            let step = DVec4::new(s, t, u, v);
            if !step.is_finite() {
                return None;
            }
            // A polynomial says little beyond its cell.
            if step.abs().max_element() > 1.0 {
                return Some(CriticalPointOutcome::Beyond(jets[0].point - self.origin + frame * in_plane.extend(0.0)));
            }
            x += step;
            let length = step.abs().max_element();
            // In small cells, only rounding may remain before that.
            let is_rounding = length <= 1e-8 && length > 0.25 * last;
            last = length;
            if length <= 1e-12 || is_rounding {
                let inside = (x - 0.5).abs().max_element() <= 0.5 + MAX_PARAMETER_OUTSIDE_CELL;
                let x = x.clamp(DVec4::ZERO, DVec4::ONE);
                let [a, b] = self.places_of_pair(ball.pair, x);
                let [point, other] = [(0, a), (1, b)].map(|(k, place)| self.surfaces[k].jet(place).point - self.origin);
                let normal = frame.z_axis;
                let radius = balls.iter().map(|ball| ball.centre.distance(point) + ball.radius).fold(0.0, f64::max);
                let gap = (point - other).dot(normal);
                // The centre of a ball is a point of either surface.
                let reach = gap.abs() + 4.0 * self.resolution;
                let within = |ball: &&UnresolvedBall| ball.centre.distance(point) <= ball.radius + reach;
                // D grows at least with the smallest curvature: lambda r^2 / 2.
                let form = g - h;
                let [trace, determinant] = [form.x_axis.x + form.y_axis.y, form.determinant()];
                let greatest = 0.5 * (trace.abs() + (trace * trace - 4.0 * determinant).max(0.0).sqrt());
                let least = (determinant / greatest).abs().max(f64::MIN_POSITIVE);
                let rim = (2.0 * (self.tolerance + gap.abs()) / least).sqrt();
                // The surfaces are close to each other over a larger area, for another reason than
                // this point.
                if self.resolution < self.tolerance && radius > MAX_CONTACT_SIZE_IN_RIM_RADII * rim {
                    return None;
                }
                let radius = if rim.is_finite() && determinant > 0.0 { radius.max(1.1 * rim) } else { radius };
                if !(inside && balls.iter().any(within)) {
                    return Some(CriticalPointOutcome::Beyond(point));
                }
                let is_opposed = jets[1].normal().dot(normal) < 0.0;
                let found = CriticalPoint {
                    pair: ball.pair,
                    parameters: x,
                    point,
                    normal,
                    gap,
                    radius,
                    is_saddle: false,
                    is_opposed,
                };
                return Some(CriticalPointOutcome::Found(found));
            }
        }
        None
    }

    /// Definiteness of the relative second form over the box of a ball.
    fn definiteness_over_ball(&self, ball: &UnresolvedBall, frame: &DMat3) -> Option<FormDefiniteness> {
        let places = self.places_of_pair(ball.pair, ball.low);
        let size = ball.high - ball.low;
        let over = |k: usize, size: [f64; 2]| {
            let Place { sheet, cell: [i, j], u, v } = places[k];
            let part = [[u, u + size[0]], [v, v + size[1]]].map(|[from, to]| [from, to.min(1.0)]);
            each_sheet!(self.surfaces[k].sheet(sheet as usize), cells => {
                let patch = crate::cells::SheetCells::cell_patch(cells, i as usize, j as usize);
                HeightDerivativeIntervals::from_patch(&patch, part, frame)
            })
        };
        Some(FormDefiniteness::from_difference(&over(0, [size.x, size.y])?, &over(1, [size.z, size.w])?))
    }
}
