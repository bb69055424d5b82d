//! Self-intersections of a surface.
//!
//! Pairs of cells are solved as for two surfaces, each pair once. Cells with common points by
//! declaration are halved until it is proven that they have no others (`adjacent_cells`). Arcs are
//! joined without regard to which of the two pieces is the first (`trails`).

use super::adjacent_cells::AdjacentCellPair;
use super::arc_links::ArcChain;
use super::cell_joints::SheetJoints;
use super::cell_pairs::CellPair;
use super::chain_bridges::ChainsWithBalls;
use super::coordinate_net::CoordinateNet;
use super::pair_places::PairPlaces;
use super::pair_search::FoundArcsAndBalls;
use super::solution_chart::ParameterBox;
use super::trails::{ArcTrail, TrailBuilder, TrailStep};
use super::{Options, SurfaceIntersection, net_rounding_error, positive_or_default};
use crate::cells::SheetCells;
use crate::{Paths, Place, Surface, each_sheet};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};

/// Number of pairs of cells classified between two progress reports.
const PAIRS_PER_REPORT: usize = 1 << 16;
/// Number of arcs whose normals are evaluated between two progress reports.
const ARCS_PER_REPORT: usize = 1 << 12;
/// Number of boxes examined for cells with common points before they are postponed.
const MAX_BOXES_BEFORE_POSTPONING: usize = 1 << 11;
/// Number of boxes examined for all postponed pairs together.
const MAX_POSTPONED_BOXES: usize = 1 << 22;
/// Largest number of boxes for a postponed pair. A pinch point takes about 2^15.
const MAX_BOXES_PER_POSTPONED_PAIR: usize = 1 << 16;
/// Trails with fewer arcs may be scraps, which lie within the places reported as unresolved.
const MIN_ARCS_OF_KEPT_TRAIL: usize = 8;
/// Control points within this number of rounding errors are the same point.
const MAX_SAME_POINT_DISTANCE_IN_ROUNDINGS: f64 = 4.0;

impl Surface<'_> {
    /// Finds the curves in which a surface intersects itself. `places` are on one of the two
    /// pieces, `others` on the other. Curves run along N x N', where N is the normal at `places`.
    /// Each curve is returned once. The two pieces may change places along a closed curve, as on a
    /// Klein bottle. The curve then ends where it begins in space, with `places` and `others`
    /// exchanged.
    ///
    /// Finds every branch longer than the tolerance outside the cells in `unresolved`. A tolerance
    /// above the surface's own one is reduced to it.
    ///
    /// Pieces that are joined count as one. Cells are joined if they share a side or a corner, also
    /// across a seam, or if they are around the same pole. Opposite borders of a sheet are joined
    /// if their control points agree within rounding, in either order. Joined cells that are proven
    /// to have no other common points are skipped.
    ///
    /// The proof fails where the tangents are dependent, as at a crease, or where a curve ends in a
    /// pinch point (Whitney's umbrella). The cell is then listed in `unresolved`, and curves end
    /// within the tolerance of the place. Cells that touch or coincide are listed too. Borders that
    /// different sheets share count as intersections.
    ///
    /// Time and memory are proportional to the number of cells and of pairs of cells that may meet,
    /// with a limit for each pair.
    ///
    /// # Errors
    /// The errors of [`Surface::meet`].
    /// As [`Surface::meet`].
    pub fn meet_itself(&self, options: &Options, job: &Job<'_>) -> Result<Paths> {
        let chord = positive_or_default("chord", options.chord, 1e-4 * self.box_diagonal())?;
        let tolerance = positive_or_default("tolerance", options.tolerance, self.tolerance())?;
        Error::require(tolerance.is_finite(), "tolerance", tolerance, "finite and above 0")?;
        // Adjacent cells are close to each other without touching.
        let rounding = net_rounding_error(self.box_diagonal());
        let tolerance = tolerance.min(self.tolerance()).max(8.0 * rounding);
        let (joints, pairs) = self.joints_and_candidate_pairs(tolerance, &job.sub_job(0.0, 0.2))?;
        let (mut near, mut far) = (Vec::new(), Vec::new());
        for (k, pair) in pairs.iter().enumerate() {
            job.sub_job(0.2, 0.2).step_every(PAIRS_PER_REPORT, k, pairs.len(), "pairs of cells")?;
            let [a, b] = pair.sheets;
            let joined = a == b && joints[a as usize].do_cells_share_points(pair.cells);
            alloc::push(if joined { &mut near } else { &mut far }, k as u32)?;
        }
        let intersection = SurfaceIntersection {
            pair_places: PairPlaces {
                surfaces: [self, self],
                pairs: &pairs,
                origin: 0.5 * (self.bounds()[0] + self.bounds()[1]),
            },
            tolerance,
            resolution: tolerance,
            // Pinch points are located within the tolerance, and belong to the cells that are
            // closer to them.
            max_lost_length: 0.5 * tolerance,
            chord_tolerance: chord.max(tolerance),
        };
        let mut pieces = intersection.solve_pairs(&far, &job.sub_job(0.2, 0.5))?;
        intersection.solve_adjacent_pairs(&near, &joints, &mut pieces, &job.sub_job(0.5, 0.9))?;
        let pieces = intersection.cut_overlapping_arcs(&pieces, &job.sub_job(0.9, 0.92))?.unwrap_or(pieces);
        let trails = intersection.build_trails(&pieces, &job.sub_job(0.92, 0.95))?;
        intersection.build_trail_paths(&pieces, &trails, &job.sub_job(0.95, 1.0))
    }

    /// The joints of each sheet's cells, and the pairs of cells that may meet elsewhere.
    fn joints_and_candidate_pairs(&self, tolerance: f64, job: &Job<'_>) -> Result<(Vec<SheetJoints>, Vec<CellPair>)> {
        let noise = MAX_SAME_POINT_DISTANCE_IN_ROUNDINGS * net_rounding_error(self.max_coordinate());
        let joints = alloc::try_collect::<_, Error>((0..self.len()).map(|k| {
            let sheet = self.sheet(k);
            each_sheet!(sheet, cells => SheetJoints::new(cells, sheet.is_closed(), noise, &job.sub_job(0.0, 0.0)))
        }))?;
        let proved = |pair: &CellPair| {
            let [a, b] = pair.sheets;
            a == b && joints[a as usize].are_cells_proved_injective(pair.cells)
        };
        let pairs = self.candidate_pairs_of_itself(tolerance, &proved, job)?;
        Ok((joints, pairs))
    }
}

impl SurfaceIntersection<'_> {
    /// Adds the arcs of cells that have points in common.
    fn solve_adjacent_pairs(
        &self,
        pairs: &[u32],
        joints: &[SheetJoints],
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        self.solve_adjacent_pairs_with_limit(
            pairs,
            joints,
            MAX_BOXES_BEFORE_POSTPONING,
            false,
            pieces,
            &job.sub_job(0.0, 0.5),
        )?;
        let again = std::mem::take(&mut pieces.exhausted_pairs);
        if !again.is_empty() {
            let max_boxes =
                (MAX_POSTPONED_BOXES / again.len()).clamp(MAX_BOXES_BEFORE_POSTPONING, MAX_BOXES_PER_POSTPONED_PAIR);
            self.solve_adjacent_pairs_with_limit(&again, joints, max_boxes, true, pieces, &job.sub_job(0.5, 1.0))?;
        }
        sort::sort_stable(&mut pieces.arcs, &|a, b| (a.pair, a.first_point).cmp(&(b.pair, b.first_point)));
        sort::sort_stable(&mut pieces.balls, &|a, b| a.pair.cmp(&b.pair));
        Ok(())
    }

    /// Adds the arcs of cells that have points in common, with at most `max_boxes` boxes for each
    /// pair. If `last`, the remaining boxes are reported.
    fn solve_adjacent_pairs_with_limit(
        &self,
        pairs: &[u32],
        joints: &[SheetJoints],
        max_boxes: usize,
        last: bool,
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let together = if last { 1 } else { 16 };
        let found = par::map_jobs(job, "intersection", pairs.chunks(together), |part, job| {
            let mut found = FoundArcsAndBalls::default();
            for &k in part {
                let number = self.pair_places.pairs[k as usize].sheets[0] as usize;
                each_sheet!(self.pair_places.surfaces[0].sheet(number), cells => {
                    self.solve_adjacent_pair(cells, k, &joints[number], (max_boxes, last), &mut found, job)?;
                });
            }
            Ok(found)
        })?;
        found.iter().try_for_each(|found| pieces.append_arcs(found))
    }

    /// Adds the arcs of two cells that have points in common.
    fn solve_adjacent_pair<const N: usize>(
        &self,
        sheet: &impl SheetCells<N>,
        k: u32,
        joints: &SheetJoints,
        (max_boxes, last): (usize, bool),
        found: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let cells = self.pair_places.pairs[k as usize].cells;
        let [(a, size), (b, other)] =
            cells.map(|[i, j]| CoordinateNet::new(&sheet.cell_patch(i as usize, j as usize), self.pair_places.origin));
        let mut whole = ParameterBox::<N, N>::WHOLE_PATCHES;
        (whole.nets.a, whole.nets.b) = (a, b);
        let task = self.pair_task(k, net_rounding_error(size.max(other)), max_boxes, last);
        AdjacentCellPair { task: &task, cells, joints }.solve_pair(&whole, found, job)
    }

    /// Joins the arcs to trails.
    fn build_trails(&self, pieces: &FoundArcsAndBalls, job: &Job<'_>) -> Result<Vec<ArcTrail>> {
        let count = 2 * pieces.arcs.len();
        let normals = alloc::try_collect::<_, Error>((0..count).map(|k| {
            job.sub_job(0.0, 0.5).step_every(ARCS_PER_REPORT, k, count, "paths")?;
            let arc = pieces.arcs[k / 2];
            let at = if k % 2 == 0 { arc.first_point } else { arc.end_point - 1 };
            let places = self.pair_places.clamped_places(arc.pair, pieces.points[at as usize]);
            Ok(places.map(|place| self.pair_places.surfaces[0].normal(place)))
        }))?;
        let trails = TrailBuilder { arcs: &pieces.arcs, normals: &normals, resolution: self.resolution };
        let mut trails = trails.build_trails(&job.sub_job(0.5, 1.0))?;
        trails.retain(|trail| trail.steps.len() >= MIN_ARCS_OF_KEPT_TRAIL || !self.is_scrap_trail(pieces, trail));
        // Removes duplicates.
        let chains = alloc::try_collect::<_, Error>(trails.iter().map(|trail| {
            let arcs = alloc::collect(trail.steps.iter().map(|step| step.arc))?;
            Ok(ArcChain { arcs, closed: trail.closed })
        }))?;
        let mut dropped = alloc::filled(false, pieces.arcs.len())?;
        let bridges = ChainsWithBalls {
            arcs_and_balls: pieces,
            surfaces: self,
            tolerance: self.tolerance,
            resolution: self.resolution,
        };
        bridges.drop_repeated_chains(&chains, &mut dropped)?;
        trails.retain(|trail| !dropped[trail.steps[0].arc as usize]);
        Ok(trails)
    }

    /// Whether all ends of a trail lie in unresolved balls of their pairs of cells.
    fn is_scrap_trail(&self, pieces: &FoundArcsAndBalls, trail: &ArcTrail) -> bool {
        trail.steps.iter().all(|step| {
            let arc = pieces.arcs[step.arc as usize];
            let first = pieces.balls.partition_point(|ball| ball.pair < arc.pair);
            let mut own = pieces.balls[first..].iter().take_while(|ball| ball.pair == arc.pair);
            own.any(|ball| arc.ends.iter().all(|end| end.distance(ball.centre) <= ball.radius + 4.0 * self.resolution))
        })
    }

    /// Converts trails to paths, and lists the unresolved cells.
    fn build_trail_paths(&self, pieces: &FoundArcsAndBalls, trails: &[ArcTrail], job: &Job<'_>) -> Result<Paths> {
        let mut paths = Paths { ends: alloc::filled(0, 1)?, ..Paths::default() };
        for (k, trail) in trails.iter().enumerate() {
            job.step_every(1 << 10, k, trails.len(), "paths")?;
            self.add_trail_path(pieces, trail, &mut paths)?;
        }
        self.evaluate_paths(&mut paths)?;
        let key = |place: &Place| (place.sheet, place.cell);
        paths.unresolved = alloc::gather(
            pieces.balls.iter().flat_map(|ball| self.pair_places.clamped_places(ball.pair, ball.parameters)),
        )?;
        sort::sort_stable(&mut paths.unresolved, &|a, b| key(a).cmp(&key(b)));
        paths.unresolved.dedup_by_key(|place| key(place));
        Ok(paths)
    }

    /// Adds the points of a trail. A long trail omits joints within a pair of cells, where boxes
    /// were halved, if they are closer together than the chord tolerance.
    fn add_trail_path(&self, pieces: &FoundArcsAndBalls, trail: &ArcTrail, paths: &mut Paths) -> Result<()> {
        let arc = |step: &TrailStep| &pieces.arcs[step.arc as usize];
        let is_long =
            trail.steps.len() > 8 && trail.steps.iter().any(|step| arc(step).pair != arc(&trail.steps[0]).pair);
        let mut last: Option<(u32, DVec3)> = None;
        for (n, step) in trail.steps.iter().enumerate() {
            let own = arc(step);
            let first = own.ends[usize::from(step.is_reversed)];
            let spare = last.is_some_and(|(pair, point)| {
                is_long && pair == own.pair && point.distance(first) < self.chord_tolerance
            });
            if !spare {
                last = Some((own.pair, first));
            }
            // The next arc begins at the end of this one.
            let ends_here = n + 1 == trail.steps.len() && !trail.closed;
            let count = own.point_count();
            for at in usize::from(spare)..count - usize::from(!ends_here) {
                let at = own.first_point as usize + if step.is_reversed { count - 1 - at } else { at };
                let [place, other] = self.pair_places.clamped_places(own.pair, pieces.points[at]);
                let [place, other] = if step.are_surfaces_swapped { [other, place] } else { [place, other] };
                alloc::push(&mut paths.places, place)?;
                alloc::push(&mut paths.others, other)?;
            }
        }
        alloc::push(&mut paths.ends, paths.places.len() as u32)?;
        alloc::push(&mut paths.closed, trail.closed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Grid, Nodes, Scheme, Sheet};
    use std::f64::consts::TAU;

    /// A ball with few rows of many cells. The pairs around its poles are proven, and as many as
    /// the square of the columns, so none of them is stored. All other pairs are stored once.
    #[test]
    fn pairs_around_poles_are_not_stored() {
        let columns = 64;
        let point = |k: usize| {
            let (u, v) = ((k / (columns + 1)) as f64 / 4.0, (k % (columns + 1) % columns) as f64 / columns as f64);
            let ring = if u == 0.0 || u == 1.0 { 0.0 } else { (0.5 * TAU * u).sin() };
            [ring * (TAU * v).cos(), ring * (TAU * v).sin(), (0.5 * TAU * u).cos()]
        };
        let data = (0..5 * (columns + 1)).flat_map(point).collect::<Vec<f64>>();
        let nodes = Nodes::strided(data, 5, columns + 1, 0, 0).unwrap();
        let sheet = Sheet::Grid(Grid::new(nodes, [false, true], Scheme::SixTap).unwrap());
        let ball = Surface::new(vec![sheet], None, &Job::default()).unwrap();
        let (_, pairs) = ball.joints_and_candidate_pairs(ball.tolerance(), &Job::default()).unwrap();
        let rows = |row: u32| pairs.iter().filter(|pair| pair.cells.iter().all(|cell| cell[0] == row)).count();
        assert!(rows(0) == 0 && rows(3) == 0, "{} {}", rows(0), rows(3));
        // Elsewhere, each cell forms a pair with itself and with the next one.
        assert!((1..3).all(|row| rows(row) >= 2 * columns), "{} {}", rows(1), rows(2));
        assert!(pairs.windows(2).all(|two| two[0] < two[1]) && pairs.iter().all(|pair| pair.cells.is_sorted()));
        assert!(ball.meet_itself(&Options::default(), &Job::default()).unwrap().is_empty());
    }
}
