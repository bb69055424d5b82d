//! Removes scraps of chains in unresolved balls, and joins loose ends in them.
//!
//! Balls keep the extent they were found with. A row of balls marks a curve along which the
//! surfaces touch. A chain that passes through the middle of a ring of balls, or ends there, is
//! unrelated to it. A ball concerns only arcs of its own two sheets.
//!
//! Cost: O(log n) for each ball, for each end of a chain, and for each close pair of them.

use super::arc_links::{ArcChain, ArcLinks, NO_LINKED_ARC};
use super::contact::CriticalPoint;
use super::pair_search::{FoundArcsAndBalls, IntersectionArc, UnresolvedBall};
use glam::DVec3;
use glam::DVec4;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;
use gusset_base::sort;

/// Chains with fewer arcs may be scraps.
const MIN_ARCS_OF_KEPT_CHAIN: usize = 8;
/// Chains shorter than this number of resolutions may be scraps.
const MAX_SCRAP_LENGTH_IN_RESOLUTIONS: f64 = 64.0;
/// Largest number of chain ends in a ball. With more ends, the joints would be ambiguous.
const MAX_CHAIN_ENDS_PER_BALL: usize = 64;
/// Ends within this number of resolutions may be a single point.
const MAX_SAME_POINT_DISTANCE_IN_RESOLUTIONS: f64 = 8.0;
/// Duplicates of parts of a longer chain: the largest length of the duplicate, and its largest
/// distance from the longer chain, both in resolutions.
const MAX_DUPLICATE_LENGTH_AND_DISTANCE_IN_RESOLUTIONS: [f64; 2] = [8.0, 2.0];

/// The properties of the intersected surfaces that bridges depend on.
pub(super) trait IntersectedSurfaces {
    /// The sheets of a pair of cells.
    fn sheets_of_pair(&self, pair: u32) -> [u32; 2];
    /// Returns the cell of the first surface, which is reported where something is unresolved.
    fn cell_of_first_surface(&self, pair: u32) -> [u32; 2];
    /// The point at parameters of a pair of cells.
    fn point_of_pair(&self, pair: u32, x: DVec4) -> DVec3;
    /// Whether a chord is as close to both surfaces as the chords of the curves are.
    fn is_chord_near_surfaces(&self, chord: [DVec3; 2]) -> bool;
}

/// The end of a chain at which a bridge may begin or end. Chain k has the ends 2 k and 2 k + 1.
#[derive(Clone, Copy)]
struct LooseChainEnd {
    arc: u32,
    point: DVec3,
    direction: DVec3,
    /// Whether the end is at the border of a sheet, or where an arc was cut.
    is_bound: bool,
}

/// Joints of branches that cross or pass each other.
#[derive(Debug, Default)]
pub(super) struct JoinedCrossings {
    /// Pairs of an arc that ends at a critical point on its path, and that point's index, sorted.
    pub(super) nodes: Vec<(u32, u32)>,
    /// For each critical point, whether the branches around it are joined.
    pub(super) is_joined_crossing: Vec<bool>,
}

/// Joins chains of arcs across unresolved balls.
pub(super) struct ChainsWithBalls<'a, S> {
    pub(super) arcs_and_balls: &'a FoundArcsAndBalls,
    pub(super) surfaces: &'a S,
    pub(super) tolerance: f64,
    /// Accuracy of ends.
    pub(super) resolution: f64,
}

/// Builds the tree of some points.
fn build_point_tree(points: &[DVec3]) -> Result<KdTree<'_>> {
    KdTree::new(points, &Job::default(), "")
}

fn positive_radius(length: f64) -> ScaledRadius {
    ScaledRadius::new(length.max(f64::MIN_POSITIVE))
}

impl<S: IntersectedSurfaces> ChainsWithBalls<'_, S> {
    /// The radius within which a ball may have ended a chain. It includes arcs shorter than the
    /// resolution, which may be lost beside the ball.
    fn chain_end_radius(&self, ball: &UnresolvedBall) -> f64 {
        ball.radius + 4.0 * self.resolution
    }

    /// Pairs of a ball and a point of an arc in it, on the same sheets. `points` holds each point
    /// with the pair of cells of its arc.
    fn points_in_balls(&self, points: &[(DVec3, u32)]) -> Result<Vec<(u32, u32)>> {
        let places = alloc::collect(points.iter().map(|&(point, _)| point))?;
        let tree = build_point_tree(&places)?;
        let mut ball_points = Vec::new();
        for (k, ball) in self.arcs_and_balls.balls.iter().enumerate() {
            let (mut result, sheets) = (Ok(()), self.surfaces.sheets_of_pair(ball.pair));
            tree.for_each_within(ball.centre, positive_radius(self.chain_end_radius(ball)), &mut |_, n| {
                if self.surfaces.sheets_of_pair(points[n as usize].1) == sheets && result.is_ok() {
                    result = alloc::push(&mut ball_points, (k as u32, n));
                }
            });
            result?;
        }
        Ok(ball_points)
    }

    /// Removes scraps: short chains whose points all lie in balls of their own cell. Balls of other
    /// cells do not count, because balls may be as wide as cells, and cover whole branches
    /// elsewhere. `is_used` tells for each ball whether it may contain arcs.
    pub(super) fn drop_scrap_chains(
        &self,
        chains: &[ArcChain],
        dropped: &mut [bool],
        is_used: &dyn Fn(u32) -> bool,
    ) -> Result<()> {
        let arcs = &self.arcs_and_balls.arcs;
        let is_scrap = |chain: &ArcChain| {
            !chain.closed && chain.arcs.len() < MIN_ARCS_OF_KEPT_CHAIN
                || self.chain_length(chain) <= MAX_SCRAP_LENGTH_IN_RESOLUTIONS * self.resolution
        };
        let short = || chains.iter().filter(|chain| is_scrap(chain));
        let mut points = Vec::new();
        for &arc in short().flat_map(|chain| &chain.arcs) {
            let arc = &arcs[arc as usize];
            alloc::extend(&mut points, self.points_of_arc(arc).map(|point| (point, arc.pair)))?;
        }
        let mut within = alloc::filled(false, points.len())?;
        for (ball, point) in self.points_in_balls(&points)? {
            let [own, other] = [self.arcs_and_balls.balls[ball as usize].pair, points[point as usize].1];
            within[point as usize] |=
                is_used(ball) && self.surfaces.cell_of_first_surface(own) == self.surfaces.cell_of_first_surface(other);
        }
        let mut rest = within.as_slice();
        for chain in short() {
            let count = chain.arcs.iter().map(|&arc| arcs[arc as usize].point_count()).sum();
            let (own, others) = rest.split_at(count);
            rest = others;
            if own.iter().all(|&within| within) {
                chain.arcs.iter().for_each(|&arc| dropped[arc as usize] = true);
            }
        }
        Ok(())
    }

    /// Removes chains no longer than the resolution. Returns whether there were any.
    pub(super) fn drop_short_chains(&self, chains: &[ArcChain], dropped: &mut [bool]) -> bool {
        let short = || chains.iter().filter(|chain| self.chain_length(chain) <= self.resolution);
        short().flat_map(|chain| &chain.arcs).for_each(|&arc| dropped[arc as usize] = true);
        short().next().is_some()
    }

    /// The length of a chain: the sum of the chords of its arcs, or the length of a closed arc.
    fn chain_length(&self, chain: &ArcChain) -> f64 {
        let length = |arc: &IntersectionArc| match arc.is_closed {
            true => self.points_of_arc(arc).zip(self.points_of_arc(arc).skip(1)).map(|(p, q)| p.distance(q)).sum(),
            false => arc.ends[0].distance(arc.ends[1]),
        };
        chain.arcs.iter().map(|&arc| length(&self.arcs_and_balls.arcs[arc as usize])).sum()
    }

    /// The points of an arc.
    fn points_of_arc(&self, arc: &IntersectionArc) -> impl Iterator<Item = DVec3> {
        let parameters = &self.arcs_and_balls.points[arc.first_point as usize..arc.end_point as usize];
        parameters.iter().map(|&x| self.surfaces.point_of_pair(arc.pair, x))
    }

    /// Removes short chains whose ends all lie on a longer one. Returns whether there were any.
    /// Beside poles, parameter lines are so close together that curves are found from both sides.
    /// Their arcs are too short to be told from successive arcs.
    pub(super) fn drop_repeated_chains<'a>(&'a self, chains: &'a [ArcChain], dropped: &mut [bool]) -> Result<bool> {
        let arcs = &self.arcs_and_balls.arcs;
        let [longest, near] = MAX_DUPLICATE_LENGTH_AND_DISTANCE_IN_RESOLUTIONS.map(|count| count * self.resolution);
        let is_short =
            |chain: &ArcChain| chain.arcs.len() < MIN_ARCS_OF_KEPT_CHAIN && self.chain_length(chain) <= longest;
        if !chains.iter().any(is_short) {
            return Ok(false);
        }
        let ends = |chain: &'a ArcChain| chain.arcs.iter().flat_map(|&arc| arcs[arc as usize].ends);
        let others = alloc::gather(chains.iter().filter(|chain| !is_short(chain)).flat_map(ends))?;
        let tree = build_point_tree(&others)?;
        let mut any = false;
        for chain in chains.iter().filter(|chain| is_short(chain)) {
            if ends(chain).all(|end| tree.nearest(end, near * near, |_| true).is_some()) {
                chain.arcs.iter().for_each(|&arc| dropped[arc as usize] = true);
                any = true;
            }
        }
        Ok(any)
    }

    /// Removes chains within a contact: rims of lenses thinner than the tolerance, and scraps of
    /// crossing branches.
    pub(super) fn drop_chains_within_contacts(
        &self,
        points: &[CriticalPoint],
        chains: &[ArcChain],
        dropped: &mut [bool],
    ) -> Result<()> {
        let firsts =
            alloc::collect(chains.iter().map(|chain| self.arcs_and_balls.arcs[chain.arcs[0] as usize].ends[0]))?;
        let tree = build_point_tree(&firsts)?;
        for point in points.iter().filter(|point| !point.is_saddle || point.gap.abs() <= self.tolerance) {
            let limit = point.radius + MAX_SAME_POINT_DISTANCE_IN_RESOLUTIONS * self.resolution;
            tree.for_each_within(point.point, positive_radius(limit), &mut |_, n| {
                let arcs = || chains[n as usize].arcs.iter().map(|&arc| &self.arcs_and_balls.arcs[arc as usize]);
                let within = |end: DVec3| end.distance(point.point) <= limit;
                if arcs().all(|arc| arc.ends.into_iter().all(within)) {
                    chains[n as usize].arcs.iter().for_each(|&arc| dropped[arc as usize] = true);
                }
            });
        }
        Ok(())
    }

    /// Joins the four ends around each point where two branches cross or pass each other.
    ///
    /// The sign of the gap tells on which side branches pass each other. At a crossing, N_A x N_B
    /// points alternately towards the point and away from it, so that paths turn there. A path is
    /// joined to itself if possible, and otherwise as straight as possible.
    pub(super) fn join_crossings(
        &self,
        points: &[CriticalPoint],
        chains: &[ArcChain],
        links: &mut ArcLinks,
    ) -> Result<JoinedCrossings> {
        let mut crossings =
            JoinedCrossings { nodes: Vec::new(), is_joined_crossing: alloc::filled(false, points.len())? };
        let ends = self.loose_chain_ends(chains)?;
        // For each end, the other end of its path. The path grows while chains are joined.
        let mut others = alloc::collect((0..ends.len()).map(|k| k ^ 1))?;
        let places = alloc::collect(ends.iter().map(|end| end.point))?;
        let tree = build_point_tree(&places)?;
        for (k, point) in points.iter().enumerate().filter(|(_, point)| point.is_saddle) {
            let mut near = [[0; 2]; 2];
            let mut counts = [0; 2];
            let limit = point.radius + MAX_SAME_POINT_DISTANCE_IN_RESOLUTIONS * self.resolution;
            tree.for_each_within(point.point, positive_radius(limit), &mut |_, n| {
                let of = n as usize % 2;
                if counts[of] < 2 {
                    near[of][counts[of]] = n as usize;
                }
                counts[of] += 1;
            });
            if counts != [2, 2] {
                continue;
            }
            near.iter_mut().for_each(|pair| pair.sort_unstable());
            let [starts, lasts] = near;
            let is_crossing = point.gap.abs() <= self.tolerance;
            let score = |last: usize, start: usize| {
                let (from, to) = (ends[last].direction, ends[start].direction);
                if is_crossing {
                    let is_one = others[last] == start;
                    from.dot(to) + if is_one { 4.0 } else { 0.0 }
                } else {
                    point.side_on_which_branches_pass() * from.cross(to).dot(point.normal)
                }
            };
            let straight = score(lasts[0], starts[0]) + score(lasts[1], starts[1]);
            let crossed = score(lasts[0], starts[1]) + score(lasts[1], starts[0]);
            let order = if straight >= crossed { [0, 1] } else { [1, 0] };
            for (last, start) in lasts.into_iter().zip(order.map(|n| starts[n])) {
                links.join_arcs(ends[last].arc, ends[start].arc);
                let (first, end) = (others[last], others[start]);
                (others[first], others[end]) = (end, first);
                if is_crossing {
                    alloc::push(&mut crossings.nodes, (ends[last].arc, k as u32))?;
                }
            }
            crossings.is_joined_crossing[k] = true;
        }
        crossings.nodes.sort_unstable();
        Ok(crossings)
    }

    /// Joins loose ends in a ball, or in two that touch, as straight as possible. Where two
    /// branches cross, N_A x N_B points towards the crossing on one branch and away from it on the
    /// other, so that a path turns from one to the other. `is_used` tells for each ball whether it
    /// joins ends.
    pub(super) fn bridge_loose_chain_ends(
        &self,
        chains: &[ArcChain],
        links: &mut ArcLinks,
        is_used: &dyn Fn(u32) -> bool,
    ) -> Result<()> {
        let ends = self.loose_chain_ends(chains)?;
        let mut bridges = Vec::new();
        for [end, start] in self.joinable_end_pairs(&ends, is_used)? {
            let (from, to) = (ends[end as usize], ends[start as usize]);
            let chord = to.point - from.point;
            let is_point = chord.length() <= MAX_SAME_POINT_DISTANCE_IN_RESOLUTIONS * self.resolution;
            if (from.is_bound || to.is_bound) && !is_point {
                continue;
            }
            // The chord between ends that nearly coincide says little.
            let along = from.direction + to.direction;
            let straightness = (chord + 4.0 * self.resolution * along).normalize_or_zero().dot(along);
            if straightness >= 0.0 {
                alloc::push(&mut bridges, (-straightness, end, start, is_point))?;
            }
        }
        sort::sort_stable(&mut bridges, &|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        for (_, end, start, is_point) in bridges {
            let (from, to) = (ends[end as usize], ends[start as usize]);
            if links.can_arc_follow(from.arc, to.arc)
                && (is_point || self.surfaces.is_chord_near_surfaces([from.point, to.point]))
            {
                links.join_arcs(from.arc, to.arc);
            }
        }
        Ok(())
    }

    /// The two ends of each open chain.
    fn loose_chain_ends(&self, chains: &[ArcChain]) -> Result<Vec<LooseChainEnd>> {
        let open = chains.iter().filter(|chain| !chain.closed);
        alloc::gather(open.flat_map(|chain| {
            let ends = [chain.arcs.first(), chain.arcs.last()].into_iter().flatten().enumerate();
            ends.map(|(k, &arc)| {
                let end_arc = &self.arcs_and_balls.arcs[arc as usize];
                let is_bound = end_arc.at_border[k] || end_arc.is_cut[k];
                LooseChainEnd { arc, point: end_arc.ends[k], direction: end_arc.directions[k], is_bound }
            })
        }))
    }

    /// Pairs of an end and a start of chains in one ball, or in two that touch.
    fn joinable_end_pairs(&self, ends: &[LooseChainEnd], is_used: &dyn Fn(u32) -> bool) -> Result<Vec<[u32; 2]>> {
        let points =
            alloc::collect(ends.iter().map(|end| (end.point, self.arcs_and_balls.arcs[end.arc as usize].pair)))?;
        let mut members = self.points_in_balls(&points)?;
        members.retain(|&(ball, _)| is_used(ball));
        let groups: Vec<&[(u32, u32)]> =
            alloc::gather(members.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() <= MAX_CHAIN_ENDS_PER_BALL))?;
        let ball = |k: usize| &self.arcs_and_balls.balls[groups[k][0].0 as usize];
        let centres = alloc::collect((0..groups.len()).map(|k| ball(k).centre))?;
        let tree = build_point_tree(&centres)?;
        let mut pairs = Vec::new();
        for (k, group) in groups.iter().enumerate() {
            let (own, mut result) = (self.chain_end_radius(ball(k)), Ok(()));
            // Only smaller balls count, so all of them are within twice the radius.
            tree.for_each_within(centres[k], positive_radius(2.0 * own), &mut |_, n| {
                let (n, other) = (n as usize, self.chain_end_radius(ball(n as usize)));
                if result.is_ok() && (other, n) <= (own, k) && centres[k].distance(centres[n]) <= own + other {
                    result = add_end_pairs(group, groups[n], &mut pairs);
                }
            });
            result?;
        }
        pairs.sort_unstable();
        pairs.dedup();
        Ok(pairs)
    }

    /// For each ball, whether a joint explains it. An explained ball is hardly larger than the
    /// resolution, and a chain passes through it, as at poles.
    pub(super) fn which_balls_a_joint_explains(&self, links: &ArcLinks) -> Result<Vec<bool>> {
        let followed =
            self.arcs_and_balls.arcs.iter().zip(&links.successors).filter(|(_, after)| **after != NO_LINKED_ARC);
        let limit = MAX_SAME_POINT_DISTANCE_IN_RESOLUTIONS * self.resolution;
        let is_small = |ball: &UnresolvedBall| ball.radius <= limit;
        let any_small = self.arcs_and_balls.balls.iter().any(is_small);
        let joints = alloc::gather(followed.filter(|_| any_small).map(|(arc, _)| arc.ends[1]))?;
        let tree = build_point_tree(&joints)?;
        let passed =
            |ball: &UnresolvedBall| is_small(ball) && tree.nearest(ball.centre, limit * limit, |_| true).is_some();
        alloc::collect(self.arcs_and_balls.balls.iter().map(passed))
    }
}

/// Adds pairs of an end and a start in two balls, which may be the same ball.
fn add_end_pairs(group: &[(u32, u32)], other: &[(u32, u32)], pairs: &mut Vec<[u32; 2]>) -> Result<()> {
    for (&(_, p), &(_, q)) in group.iter().flat_map(|p| other.iter().map(move |q| (p, q))) {
        match [p % 2, q % 2] {
            [1, 0] => alloc::push(pairs, [p, q])?,
            [0, 1] => alloc::push(pairs, [q, p])?,
            _ => {}
        }
    }
    Ok(())
}
