//! Gaps between borders that share vertices but not edges.
//!
//! Surfaces of different detail meet in this way: both borders pass some common points, and between
//! two of them each has vertices of its own. The region between the two runs is a **lens**. A lens
//! may also begin at the end of a seam, where sewing merged the borders.
//!
//! A lens is closed if it is narrow: no vertex of one run is farther from the other run than
//! three tenths of the length of the shorter run, and the mean distance is at most the longest edge
//! of both. A wider lens is closed if its sides face each other, and belong to two whole loops that
//! face each other ([`unsewn_pairs`](super::unsewn_pairs)). The surfaces of a narrow lens must face or continue each other, unless the gap is small relative to the
//! faces along it. The common points become one vertex each, and a strip of M + N - 2 triangles
//! joins the runs. Lenses are closed narrowest first, and each border edge belongs to at most one. A
//! lens stays open if closing it would create a non-manifold edge. The criteria are our own.
//!
//! This happens before components are oriented, so that orientation follows the strips. Runs of two
//! components may therefore have the same direction or opposite directions.

use super::assemble_request::{Extent, Joint, MaxGap, Options, Outcome, Selector};
use super::loop_edges::LoopEdges;
use super::side_facing::{EdgeDepths, RimRun, SideFacing};
use super::unsewn_pairs::UnsewnLoopPairs;
use crate::boundary::{self, boundary_loops};
use crate::repair::sew::Sew;
use crate::repair::sew_edges::{RunEnds, merge_run_ends};
use crate::repair::{border_clusters, orient};
use crate::stitch::combine::append_strip;
use crate::stitch::facing::Arc;
use crate::stitch::fair_and_check::fair_and_check;
use crate::stitch::sense::arcs_run_the_same_way;
use crate::stitch::stitch_rim::{Rim, is_usable};
use crate::stitch::strip::Strip;
use crate::stitch::{self, Finish, Rows};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::{Mesh, Topology, vertex_components};

/// Largest ratio of the lengths of both runs.
const MAX_LENGTH_RATIO: f64 = 2.0;

/// Number of common points that a run may pass because the other run does not pass them.
const MAX_POINTS_PASSED: usize = 4;

/// Points where more borders meet are not compared.
const MAX_BORDERS_AT_POINT: usize = 32;

/// Number of points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 10;

const STAGE: &str = "closing gaps between touching borders";

/// A part of a loop: the place of its first vertex, and its number of edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Run {
    rim: usize,
    first: usize,
    count: usize,
}

impl Run {
    fn vertex_at(&self, rims: &[Rim], k: usize) -> u32 {
        let vertices = &rims[self.rim].vertices;
        vertices[(self.first + k) % vertices.len()]
    }
}

/// Two runs with common ends.
#[derive(Clone, Copy, Debug)]
struct Lens {
    runs: [Run; 2],
    /// True if both runs start at the same end; otherwise each starts where the other ends.
    same_way: bool,
    /// The mean distance from the vertices of a run to the other run, the larger of both.
    mean_gap: f64,
}

impl Lens {
    fn ends(&self, rims: &[Rim]) -> RunEnds {
        let [[a, c], [b, d]] = self.runs.map(|run| [run.vertex_at(rims, 0), run.vertex_at(rims, run.count)]);
        if self.same_way { [[a, b], [c, d]] } else { [[a, d], [c, b]] }
    }
}

/// The edges of each rim that lenses use.
struct UsedEdges(Vec<Vec<bool>>);

impl UsedEdges {
    fn new(rims: &[Rim]) -> Result<Self> {
        alloc::try_collect(rims.iter().map(|rim| alloc::filled(false, rim.vertices.len()))).map(UsedEdges)
    }

    fn places(&self, run: Run) -> impl Iterator<Item = usize> + use<> {
        let n = self.0[run.rim].len();
        (run.first..run.first + run.count).map(move |place| place % n)
    }

    fn are_free(&self, runs: &[Run; 2]) -> bool {
        runs.iter().all(|&run| self.places(run).all(|place| !self.0[run.rim][place]))
    }

    /// Sorts lenses by their gaps, and keeps those whose edges are free when their turn comes.
    fn keep_free_lenses(&mut self, lenses: &mut Vec<Lens>) {
        sort::sort_stable(lenses, &|x, y| x.mean_gap.total_cmp(&y.mean_gap));
        lenses.retain(|lens| {
            let free = self.are_free(&lens.runs);
            for run in lens.runs.iter().filter(|_| free) {
                self.places(*run).for_each(|place| self.0[run.rim][place] = true);
            }
            free
        });
    }
}

/// A vertex of a loop at a common point.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct CommonPoint {
    cluster: u32,
    rim: usize,
    place: usize,
}

/// The loops of a mesh with consistently oriented components.
struct TouchingLoops {
    rims: Vec<Rim>,
    components: DisjointSets,
    /// The points of each loop, by place.
    points: Vec<Vec<CommonPoint>>,
    /// The depths of the faces along each loop.
    edge_depths: Vec<EdgeDepths>,
    unit: f64,
    tolerance: f64,
}

/// Closes the narrow lenses of a sewn mesh, except between loops that `options` excludes. Returns a
/// joint for each lens; their faces follow the faces of the pieces. `vertices_of` returns the
/// vertices of the sewn mesh that a selector names. `unsewn_pairs` finds the whole loops that faced
/// each other before sewing.
///
/// O(B log B) for B border vertices, if some of them coincide and are not sewn.
pub(super) fn close_touching_borders(
    sewn: &mut Sew,
    options: &Options<'_>,
    vertices_of: impl Fn(&[u32], Selector) -> Result<Vec<u32>>,
    unsewn_pairs: impl Fn(&[u32], &Job<'_>) -> Result<UnsewnLoopPairs>,
    job: &Job<'_>,
) -> Result<Vec<Joint>> {
    if sewn.left_vertices.is_empty() || options.extent == Extent::WholeLoops || options.max_gap == MaxGap::Given(0.0) {
        return Ok(Vec::new());
    }
    let mut loops = TouchingLoops::new(sewn, options, &job.sub_job(0.0, 0.4))?;
    let excluded = loops.list_excluded_rims(options, |selector| vertices_of(&sewn.vertex_map, selector))?;
    let unsewn_pairs = |job: &Job<'_>| unsewn_pairs(&sewn.vertex_map, job);
    let lenses = loops.find_lenses(options, &excluded, unsewn_pairs, &job.sub_job(0.4, 0.6))?;
    if lenses.is_empty() {
        return Ok(Vec::new());
    }
    let view = sewn.mesh.view(&job.sub_job(0.6, 0.6))?;
    let topology = Topology::new(&view, &job.sub_job(0.6, 0.65))?;
    let ends = alloc::collect(lenses.iter().map(|lens| lens.ends(&loops.rims)))?;
    let (merged, representative) = merge_run_ends(&view, &topology, &ends, &job.sub_job(0.65, 0.7))?;
    let vertex_map = sewn.merge_vertices(&representative, &job.sub_job(0.7, 0.8))?;
    for vertex in loops.rims.iter_mut().flat_map(|rim| &mut rim.vertices) {
        *vertex = vertex_map[*vertex as usize];
    }
    let closed = alloc::gather(lenses.iter().zip(&merged).filter(|&(_, &merged)| merged).map(|(&lens, _)| lens))?;
    loops.append_strips(&mut sewn.mesh, &closed, options, &job.sub_job(0.8, 1.0))
}

impl TouchingLoops {
    fn new(sewn: &Sew, options: &Options<'_>, job: &Job<'_>) -> Result<Self> {
        let view = sewn.mesh.view(&job.sub_job(0.0, 0.1))?;
        let oriented = match options.keep_orientation {
            true => None,
            false => Some(orient::orient(&view, &orient::Options::default(), &job.sub_job(0.1, 0.4))?.mesh),
        };
        let view = oriented.as_ref().unwrap_or(&sewn.mesh).view(&job.sub_job(0.4, 0.5))?;
        let boundary = boundary_loops(&view, &boundary::Options::default(), &job.sub_job(0.5, 0.8))?;
        let usable = boundary.iter().filter(is_usable);
        let mut rims = alloc::try_collect(usable.map(|found| Rim::from_loop(&view, &found)))?;
        let clusters = border_clusters(&view, sewn.tolerance, &job.sub_job(0.8, 1.0))?;
        let mut members = alloc::filled(0u32, clusters.len())?;
        for &vertex in rims.iter().flat_map(|rim| &rim.vertices) {
            members[clusters[vertex as usize] as usize] += 1;
        }
        let is_common = |vertex: u32| {
            members[clusters[vertex as usize] as usize] > 1 || sewn.seam_vertices.binary_search(&vertex).is_ok()
        };
        let points = alloc::try_collect(rims.iter().enumerate().map(|(rim, found)| {
            let common = found.vertices.iter().enumerate().filter(|&(_, &vertex)| is_common(vertex));
            alloc::gather(common.map(|(place, &v)| CommonPoint { cluster: clusters[v as usize], rim, place }))
        }))?;
        let unit = common_unit(rims.iter().flat_map(|rim| &rim.points));
        rims.iter_mut().flat_map(|rim| &mut rim.points).for_each(|p| *p /= unit);
        let with_loops = rims.iter().zip(boundary.iter().filter(is_usable));
        let depths = alloc::try_collect(with_loops.map(|(rim, found)| EdgeDepths::measure(&view, &found, rim, unit)))?;
        let (components, tolerance) = (vertex_components(&view)?, sewn.tolerance / unit);
        Ok(TouchingLoops { rims, components, points, edge_depths: depths, unit, tolerance })
    }

    /// Returns the pairs of rims that the options exclude, in ascending order.
    fn list_excluded_rims(
        &self,
        options: &Options<'_>,
        vertices_of: impl Fn(Selector) -> Result<Vec<u32>>,
    ) -> Result<Vec<[usize; 2]>> {
        let mut excluded = Vec::new();
        for pair in options.excluded {
            let mut rims = [Vec::new(), Vec::new()];
            for (rims, &selector) in rims.iter_mut().zip(pair) {
                let mut vertices = vertices_of(selector)?;
                sort::sort_distinct(&mut vertices);
                let passes =
                    |rim: &usize| self.rims[*rim].vertices.iter().any(|vertex| vertices.binary_search(vertex).is_ok());
                *rims = alloc::gather((0..self.rims.len()).filter(passes))?;
            }
            let [first, second] = &rims;
            alloc::extend(
                &mut excluded,
                first.iter().flat_map(|&r| second.iter().map(move |&k| [r.min(k), r.max(k)])),
            )?;
        }
        sort::sort_distinct(&mut excluded);
        Ok(excluded)
    }

    /// Returns the lenses to close, narrowest first. No edge belongs to two of them, and no lens to
    /// an excluded pair of rims.
    fn find_lenses(
        &mut self,
        options: &Options<'_>,
        excluded: &[[usize; 2]],
        unsewn_pairs: impl Fn(&Job<'_>) -> Result<UnsewnLoopPairs>,
        job: &Job<'_>,
    ) -> Result<Vec<Lens>> {
        let mut all = alloc::gather(self.points.iter().flatten().copied())?;
        all.sort_unstable();
        let mut candidates = Vec::new();
        for together in all.chunk_by(|x, y| x.cluster == y.cluster).filter(|some| some.len() <= MAX_BORDERS_AT_POINT) {
            for x in together {
                for y in together {
                    let component = |point: &CommonPoint| self.rims[point.rim].vertices[0];
                    let [i, j] = [component(x), component(y)].map(|v| self.components.find(v));
                    let ways = if i == j || options.keep_orientation { &[false][..] } else { &[false, true][..] };
                    for &same_way in ways {
                        let found = self.trace_lens(x, y, same_way).map(|mut runs| {
                            runs.sort_unstable();
                            (runs, same_way)
                        });
                        alloc::extend(&mut candidates, found)?;
                    }
                }
            }
        }
        candidates.retain(|(runs, _)| excluded.binary_search(&runs.map(|run| run.rim)).is_err());
        sort::sort_distinct(&mut candidates);
        let (mut lenses, mut others) = (Vec::new(), Vec::new());
        for (number, &(runs, same_way)) in candidates.iter().enumerate() {
            job.step_every(POINTS_PER_REPORT, number, candidates.len(), STAGE)?;
            match self.narrow_gap_between(runs, options, job)? {
                Some(gap) if self.fits_direction(runs, same_way)? => {
                    alloc::push(&mut lenses, Lens { runs, same_way, mean_gap: gap })?;
                }
                _ => alloc::push(&mut others, (runs, same_way))?,
            }
        }
        let mut used = UsedEdges::new(&self.rims)?;
        used.keep_free_lenses(&mut lenses);
        if UnsewnLoopPairs::may_exist(options) {
            let mut wide = self.find_wide_lenses(&others, &lenses, &used, unsewn_pairs, job)?;
            used.keep_free_lenses(&mut wide);
            alloc::append(&mut lenses, &wide)?;
        }
        Ok(lenses)
    }

    /// Returns the lenses among `candidates` to close at any width: their sides face each other, and
    /// belong to whole loops that face each other, or that one of `narrow` joins.
    fn find_wide_lenses(
        &self,
        candidates: &[([Run; 2], bool)],
        narrow: &[Lens],
        used: &UsedEdges,
        unsewn_pairs: impl Fn(&Job<'_>) -> Result<UnsewnLoopPairs>,
        job: &Job<'_>,
    ) -> Result<Vec<Lens>> {
        let mut wide = Vec::new();
        for (number, &(runs, same_way)) in candidates.iter().enumerate() {
            job.step_every(POINTS_PER_REPORT, number, candidates.len(), STAGE)?;
            if !used.are_free(&runs) {
                continue;
            }
            if let Some(gap) = self.wide_gap_between(runs, job)?
                && self.fits_direction(runs, same_way)?
            {
                alloc::push(&mut wide, Lens { runs, same_way, mean_gap: gap })?;
            }
        }
        if wide.is_empty() {
            return Ok(wide);
        }
        let rims = |lens: &Lens| lens.runs.map(|run| run.rim);
        let mut joined = alloc::gather(narrow.iter().map(rims).filter(|[r, k]| r != k))?;
        joined.sort_unstable();
        let pairs = unsewn_pairs(job)?;
        let is_paired = |lens: &Lens| -> Result<bool> {
            let vertices = |run: Run| alloc::collect((0..run.count + 1).map(|k| run.vertex_at(&self.rims, k)));
            Ok(joined.binary_search(&rims(lens)).is_ok()
                || pairs.join_runs(&vertices(lens.runs[0])?, &vertices(lens.runs[1])?)?)
        };
        let mut paired = alloc::try_collect(wide.iter().map(is_paired))?.into_iter();
        wide.retain(|_| paired.next() == Some(true));
        Ok(wide)
    }

    /// Follows two borders from a common point to the next one: the border of `x` forwards, and
    /// the border of `y` forwards if `same_way`, otherwise backwards.
    fn trace_lens(&self, x: &CommonPoint, y: &CommonPoint, same_way: bool) -> Option<[Run; 2]> {
        let counts = [x, y].map(|start| self.rims[start.rim].vertices.len());
        let next = |start: &CommonPoint, forwards: bool, k: usize| -> Option<&CommonPoint> {
            let points = &self.points[start.rim];
            let own = points.partition_point(|point| point.place < start.place);
            let step = if forwards { own + k } else { own + points.len() - k };
            (k <= points.len()).then(|| &points[step % points.len()])
        };
        let edges_to = |start: &CommonPoint, end: &CommonPoint, n: usize| match (end.place + n - start.place) % n {
            0 => n,
            edges => edges,
        };
        // The fewest points in all; of equals, the fewest on the first border.
        (2..=2 * MAX_POINTS_PASSED).find_map(|sum| {
            (1..sum).find_map(|i| {
                let (end_x, end_y) = (next(x, true, i)?, next(y, same_way, sum - i)?);
                if end_x.cluster != end_y.cluster || (x == y && end_x == end_y) {
                    return None;
                }
                let a = Run { rim: x.rim, first: x.place, count: edges_to(x, end_x, counts[0]) };
                let b = match same_way {
                    true => Run { rim: y.rim, first: y.place, count: edges_to(y, end_y, counts[1]) },
                    false => Run { rim: y.rim, first: end_y.place, count: edges_to(end_y, y, counts[1]) },
                };
                let fits = x.rim != y.rim || a.count + b.count <= counts[0];
                (fits && a.count + b.count > 2).then_some([a, b])
            })
        })
    }

    /// Returns the gap of a lens if the lens is narrow.
    fn narrow_gap_between(&self, runs: [Run; 2], options: &Options<'_>, job: &Job<'_>) -> Result<Option<f64>> {
        let sides = self.sides_of_lens(runs);
        let [a, b] = sides.map(|side| side.edge_lengths().sum::<f64>());
        if a.max(b) > MAX_LENGTH_RATIO * a.min(b) {
            return Ok(None);
        }
        let Some(seen) = SideFacing::between(&sides[0], &sides[1], &job.sub_job(0.0, 0.0))? else {
            return Ok(None);
        };
        let is_near = |run: Run| {
            let depths = &self.edge_depths[run.rim];
            depths.is_near_gap(seen.mean_gap, (run.first..run.first + run.count).map(|place| place % depths.len()))
        };
        let allowed = match options.max_gap {
            MaxGap::Auto => sides.iter().flat_map(RimRun::edge_lengths).fold(0.0, f64::max),
            MaxGap::Given(gap) => gap / self.unit,
        };
        let is_open = seen.is_narrow() && (self.tolerance < seen.max_gap) && seen.mean_gap <= allowed;
        Ok((is_open && seen.may_close(runs.into_iter().all(is_near))).then_some(seen.mean_gap))
    }

    /// Returns the gap of a lens of any width if its sides face each other along their length.
    fn wide_gap_between(&self, runs: [Run; 2], job: &Job<'_>) -> Result<Option<f64>> {
        let sides = self.sides_of_lens(runs);
        let seen = SideFacing::between(&sides[0], &sides[1], &job.sub_job(0.0, 0.0))?;
        Ok(seen.filter(|seen| self.tolerance < seen.max_gap && seen.is_opposed()).map(|seen| seen.mean_gap))
    }

    fn sides_of_lens(&self, runs: [Run; 2]) -> [RimRun<'_>; 2] {
        runs.map(|run| RimRun { rim: &self.rims[run.rim], arc: Arc { first: run.first, count: run.count + 1 } })
    }

    /// Returns true if the direction of two runs is possible. The ends of the runs decide, unless
    /// the runs are whole rims with one common point.
    fn fits_direction(&self, runs: [Run; 2], same_way: bool) -> Result<bool> {
        if runs.iter().any(|run| run.count < self.rims[run.rim].vertices.len()) {
            return Ok(true);
        }
        let [a, b] = runs.map(|run| self.rims[run.rim].arc_of_run(run.first, run.count + 1));
        Ok(arcs_run_the_same_way(&a?.points, &b?.points)? == same_way)
    }

    /// Appends the strips of the lenses, whose rims are numbered as in `mesh`. Returns their joints.
    fn append_strips(
        &self,
        mesh: &mut Mesh,
        lenses: &[Lens],
        options: &Options<'_>,
        job: &Job<'_>,
    ) -> Result<Vec<Joint>> {
        let mut places = Vec::new();
        for (lens, k) in lenses.iter().zip(0u32..) {
            for run in lens.runs {
                alloc::extend(&mut places, (0..run.count + 1).map(|place| (run.vertex_at(&self.rims, place), k)))?;
            }
        }
        sort::sort_distinct(&mut places);
        let mut edges = LoopEdges::new(mesh, places)?;
        let plain = options.strip.strip_options();
        let strips = stitch::Options { twist: 0, rows: Rows::None, finish: Finish::Strip, ..plain };
        let mut joints = alloc::with_capacity(lenses.len())?;
        for (k, lens) in lenses.iter().enumerate() {
            let part = job.sub_job_of_item(k, lenses.len());
            let mut sides = self.sides_of_strip(lens)?;
            let mut joint = Joint {
                sides: [alloc::copied(&sides[0].vertices)?, alloc::copied(&sides[1].vertices)?],
                whole: false,
                gap: lens.mean_gap * self.unit,
                outcome: Outcome::NoStrip,
                finish: Finish::Strip,
                vertices: 0..0,
                faces: 0..0,
                intersections: None,
                cut_length: 0.0,
                blend_avoids_cuts: false,
            };
            let existing = edges.existing_edges_between([k, k], &sides)?;
            sides[1].reverse();
            let [a, b] = sides;
            match Strip::build(a, b, &existing, &strips, || 1.0, &part.sub_job(0.0, 0.6)) {
                Err(Error::NoStrip { .. }) => {}
                Err(error) => return Err(error),
                Ok(mut strip) => {
                    let part = part.sub_job(0.6, 1.0);
                    let checked = fair_and_check(mesh, &mut strip, self.unit, &existing, &strips, &part)?;
                    if strip_has_area(&strip) && !repeats_edges(&strip)? {
                        let attached = append_strip(mesh, &strip, self.unit)?;
                        edges.add_strip_edges(&strip)?;
                        joint.outcome = Outcome::Joined;
                        joint.sides = [strip.a.vertices, strip.b.vertices];
                        joint.faces = attached.faces;
                        joint.intersections = checked.intersections;
                    }
                }
            }
            joints.push(joint);
        }
        Ok(joints)
    }

    /// Returns the sides of a strip, in opposite directions: the run with fewer edges, with both
    /// ends, and the vertices between the ends of the other run.
    fn sides_of_strip(&self, lens: &Lens) -> Result<[Rim; 2]> {
        let fewer = usize::from(lens.runs[1].count < lens.runs[0].count);
        let [a, b] = [lens.runs[fewer], lens.runs[1 - fewer]];
        let mut sides = [
            self.rims[a.rim].arc_of_run(a.first, a.count + 1)?,
            self.rims[b.rim].arc_of_run((b.first + 1) % self.rims[b.rim].vertices.len(), b.count - 1)?,
        ];
        if lens.same_way {
            sides[1].adapt_to_turned_surface();
        }
        Ok(sides)
    }
}

/// Returns true if no triangle of a strip has its corners on one line, up to rounding.
fn strip_has_area(strip: &Strip) -> bool {
    let at = |v: u32| strip.grid.points[v as usize];
    strip.faces.iter().all(|face| {
        let [p, q, r] = [face[0], face[1], face[2]].map(at);
        let (u, v) = (q - p, r - p);
        let size = u.length_squared().max(v.length_squared()).max(u.distance_squared(v));
        u.cross(v).length() > 1e-9 * size
    })
}

/// Returns true if a strip has an edge twice because its first vertex is also the last of the side.
fn repeats_edges(strip: &Strip) -> Result<bool> {
    let a = &strip.a.vertices;
    let last = a.len() as u32 - 1;
    if a.first() != a.last() {
        return Ok(false);
    }
    let mut from_ends = alloc::gather(strip.faces.iter().flat_map(|face| {
        let starts = face.contains(&0) || face.contains(&last);
        face.iter().filter(move |&&v| starts && v > last).map(move |&v| (v, face.contains(&last)))
    }))?;
    sort::sort_distinct(&mut from_ends);
    Ok(from_ends.windows(2).any(|pair| pair[0].0 == pair[1].0))
}
