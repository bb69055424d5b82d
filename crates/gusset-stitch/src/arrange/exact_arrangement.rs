//! The arrangement of triangles with exact points.

use super::clusters::{Cluster, Segment, SplitCluster, TrianglePart};
use super::contacts::{Contact, ContactPoint, TriangleCorners, find_contact, projection_axis};
use super::coordinate_grid::{Grid, first_at_position};
use super::exact_points::{ExactPoints, Plane};
use crate::intersect::{TriangleSoup, intersecting_pairs};
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::{Buckets, sort, sort_distinct};

/// Number of pairs, points or clusters that a thread takes at a time.
const PAIRS_PER_TASK: usize = 1 << 10;
const POINTS_PER_TASK: usize = 1 << 8;
const CLUSTERS_PER_TASK: usize = 1 << 4;

const STAGE: &str = "arranging triangles";

/// Triangles that meet in common vertices and edges only, or coincide.
pub(super) struct ExactArrangement {
    pub(super) grid: Grid,
    /// The given vertices, then the constructed points. Some are not used.
    pub(super) points: ExactPoints<'static>,
    /// The parts, in the order of the given triangles. Vertices with equal positions have equal
    /// numbers.
    pub(super) parts: Vec<TrianglePart>,
    /// The first given vertex at the position of each.
    pub(super) first_vertex_at_position: Vec<u32>,
    /// The given triangles that could not be split.
    pub(super) unsplit: Vec<u32>,
}

/// Triangles on a grid, and the pairs of them that intersect.
pub(super) struct GridTriangles {
    grid: Grid,
    /// The vertices in steps of the grid.
    vertices_in_grid_steps: Vec<DVec3>,
    /// The first given vertex at the position of each.
    pub(super) first_vertex_at_position: Vec<u32>,
    solid: SolidTriangles,
    /// True if some triangles are degenerate.
    pub(super) has_degenerate: bool,
    /// The pairs that intersect, the smaller number first, in ascending order.
    pub(super) pairs: Vec<[u32; 2]>,
}

impl GridTriangles {
    /// Puts triangles on a grid and finds the pairs that intersect. If there are `suspects`, only pairs with one of
    /// them are tested.
    pub(super) fn new(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        suspects: Option<&BitSet>,
        job: &Job<'_>,
    ) -> Result<GridTriangles> {
        let grid = Grid::from_points(triangles.as_flattened().iter().map(|&v| points[v as usize]));
        let mut steps = alloc::filled(DVec3::ZERO, points.len())?;
        job.step(0.0, STAGE)?;
        triangles.as_flattened().iter().for_each(|&v| steps[v as usize] = grid.steps(points[v as usize]));
        let first = first_at_position(&steps, triangles, &job.sub_job(0.0, 0.2), STAGE)?;
        let solid = SolidTriangles::new(&steps, triangles, &first)?;
        let pairs = solid.intersecting_pairs(&steps, suspects, &job.sub_job(0.2, 1.0))?;
        let has_degenerate = solid.corners.len() < triangles.len();
        Ok(GridTriangles {
            grid,
            vertices_in_grid_steps: steps,
            first_vertex_at_position: first,
            solid,
            has_degenerate,
            pairs,
        })
    }

    /// Splits the triangles where they meet. Degenerate ones have no parts.
    pub(super) fn arrange(self, job: &Job<'_>) -> Result<ExactArrangement> {
        let solid = self.solid;
        let mut made = ExactArrangement {
            grid: self.grid,
            points: ExactPoints::from_integral(self.vertices_in_grid_steps)?,
            parts: Vec::new(),
            first_vertex_at_position: self.first_vertex_at_position,
            unsplit: Vec::new(),
        };
        let pairs = alloc::collect(self.pairs.iter().map(|pair| pair.map(|t| solid.place_of(t))))?;
        let parts = made.split(&solid.corners, &pairs, job)?;
        let number = |t: u32| solid.number_of_triangle[t as usize];
        made.parts = alloc::collect(parts.into_iter().map(|(part, t)| (part, number(t))))?;
        made.unsplit.iter_mut().for_each(|t| *t = number(*t));
        Ok(made)
    }
}

impl ExactArrangement {
    fn split(&mut self, triangles: &[[u32; 3]], pairs: &[[u32; 2]], job: &Job<'_>) -> Result<Vec<TrianglePart>> {
        if pairs.is_empty() {
            return alloc::gather(triangles.iter().copied().zip(0..));
        }
        let contacts = find_contacts(triangles, pairs, &self.points, &job.sub_job(0.0, 0.1))?;
        let crossings = self.add_crossings(triangles, &contacts, &job.sub_job(0.1, 0.2))?;
        let given = alloc::gather(pairs.as_flattened().iter().flat_map(|&t| triangles[t as usize]))?;
        let names = self.unite_equal_points(given, crossings.first_number, &job.sub_job(0.2, 0.3))?;
        let name = |point: ContactPoint| match point {
            ContactPoint::Vertex(v) => v,
            ContactPoint::Crossing(..) => {
                let k = crossings.crossing_points.binary_search(&point).unwrap_or(0);
                names[k]
            }
        };
        let mut sets = DisjointSets::new(triangles.len())?;
        let coplanar = pairs.iter().zip(&contacts).filter(|(_, contact)| contact.is_coplanar);
        coplanar.for_each(|(&[s, t], _)| _ = sets.union(s, t));
        let roots = sets.into_roots(&job.sub_job(0.3, 0.3), STAGE)?;
        let (mut points, mut segments) = (Vec::new(), Vec::new());
        for (&[s, t], contact) in pairs.iter().zip(&contacts) {
            let [mut low, mut high] = [NONE; 2];
            for point in contact.points().map(name) {
                if low == NONE || self.points.compare(point, low).is_lt() {
                    low = point;
                }
                if high == NONE || self.points.compare(point, high).is_gt() {
                    high = point;
                }
            }
            let [in_s, in_t] = [s, t].map(|t| roots[t as usize] as usize);
            if low != high {
                alloc::extend(&mut segments, [(in_s, ([low, high], t)), (in_t, ([low, high], s))])?;
            } else if low != NONE {
                alloc::extend(&mut points, [(in_s, low), (in_t, low)])?;
            }
        }
        let (count, silent) = (triangles.len(), job.sub_job(0.3, 0.3));
        let points = Buckets::new_cancellable(count, 0, points.iter().copied(), &silent, STAGE)?;
        let segments: Buckets<Segment> =
            Buckets::new_cancellable(count, ([0; 2], 0), segments.iter().copied(), &silent, STAGE)?;
        let members =
            Buckets::new_cancellable(count, 0, roots.iter().map(|&root| root as usize).zip(0..), &silent, STAGE)?;
        let is_split = |root: &u32| {
            let k = *root as usize;
            members.get(k).len() > 1 || !points.get(k).is_empty() || !segments.get(k).is_empty()
        };
        let busy = alloc::gather((0..count as u32).filter(|&t| roots[t as usize] == t).filter(is_split))?;
        let corners = |t: u32| triangles[t as usize];
        let split_part = job.sub_job(0.3, 0.9);
        let tasks = par::split_into_ranges(busy.len(), CLUSTERS_PER_TASK);
        let base = &self.points;
        let split = par::map_jobs(&split_part, STAGE, tasks, |range, job| {
            let cluster = |&root: &u32| Cluster {
                triangles: members.get(root as usize),
                points: points.get(root as usize),
                segments: segments.get(root as usize),
            };
            alloc::try_collect(busy[range].iter().map(|root| cluster(root).split(base, &corners, job)))
        })?;
        let mut untouched = alloc::filled(true, count)?;
        busy.iter().flat_map(|&root| members.get(root as usize)).for_each(|&t| untouched[t as usize] = false);
        let whole = (0..count as u32).filter(|&t| untouched[t as usize]).map(|t| (corners(t), t));
        let mut parts = alloc::gather(whole)?;
        let start = self.points.end();
        for cluster in split.iter().flatten() {
            self.add_cluster(cluster, start, &mut parts)?;
        }
        self.rename_equal_points(&crossings, start, &mut parts, &job.sub_job(0.9, 1.0))?;
        parts.sort_by_key(|&(_, t)| t);
        Ok(parts)
    }

    /// Adds the points and parts of a cluster, whose own points begin at `first_number`.
    fn add_cluster(&mut self, cluster: &SplitCluster, first_number: u32, parts: &mut Vec<TrianglePart>) -> Result<()> {
        let shift = self.points.end() - first_number;
        self.points.append(&cluster.points)?;
        let rename = |p: u32| if p < first_number { p } else { p + shift };
        alloc::extend(parts, cluster.parts.iter().map(|&(part, t)| (part.map(rename), t)))?;
        if !cluster.is_complete {
            alloc::extend(&mut self.unsplit, cluster.parts.iter().map(|&(_, t)| t))?;
        }
        Ok(())
    }

    /// Adds the points in which edges cross triangles.
    fn add_crossings(&mut self, triangles: &[[u32; 3]], contacts: &[Contact], job: &Job<'_>) -> Result<Crossings> {
        let is_crossing = |point: &ContactPoint| matches!(point, ContactPoint::Crossing(..));
        let mut keys = alloc::gather(contacts.iter().flat_map(Contact::points).filter(is_crossing))?;
        sort_distinct(&mut keys);
        let start = self.points.end();
        let base = &self.points;
        let tasks = par::split_into_ranges(keys.len(), POINTS_PER_TASK);
        let made = par::map_jobs(job, STAGE, tasks, |range, _| {
            let mut points = ExactPoints::extending(base);
            for key in &keys[range] {
                if let ContactPoint::Crossing(edge, t) = *key {
                    let plane = Plane::from_triangle(triangles[t as usize].map(|v| base.rounded(v)));
                    points.push(&plane.meet_line(edge.map(|v| base.rounded(v))))?;
                }
            }
            Ok(points.into_own())
        })?;
        made.iter().try_for_each(|points| self.points.append(points))?;
        Ok(Crossings { crossing_points: keys, first_number: start })
    }

    /// Returns for each point from `first_number` on the first point that equals it, among these and the
    /// given ones.
    fn unite_equal_points(&self, mut given: Vec<u32>, first_number: u32, job: &Job<'_>) -> Result<Vec<u32>> {
        let mut names = alloc::collect((first_number as usize..self.points.end() as usize).map(|p| p as u32))?;
        sort_distinct(&mut given);
        alloc::append(&mut given, &names)?;
        sort(&mut given, |&i, &j| self.points.compare(i, j).then(i.cmp(&j)), job, STAGE)?;
        for same in given.chunk_by(|&i, &j| self.points.compare(i, j).is_eq()) {
            same.iter().filter(|&&p| p >= first_number).for_each(|&p| names[(p - first_number) as usize] = same[0]);
        }
        Ok(names)
    }

    /// Gives one number to equal points, where clusters made them from `first_number` on.
    fn rename_equal_points(
        &self,
        crossings: &Crossings,
        first_number: u32,
        parts: &mut [TrianglePart],
        job: &Job<'_>,
    ) -> Result<()> {
        if self.points.end() == first_number {
            return Ok(());
        }
        let corners = parts.iter().flat_map(|(part, _)| *part);
        let old = alloc::gather(corners.filter(|p| (crossings.first_number..first_number).contains(p)))?;
        let names = self.unite_equal_points(old, first_number, job)?;
        for p in parts.iter_mut().flat_map(|(part, _)| part) {
            if *p >= first_number {
                *p = names[(*p - first_number) as usize];
            }
        }
        Ok(())
    }
}

/// Points in which edges cross triangles, in ascending order, and the number of the first.
struct Crossings {
    crossing_points: Vec<ContactPoint>,
    first_number: u32,
}

/// The triangles that are not degenerate, with the first vertices at their positions.
struct SolidTriangles {
    corners: Vec<[u32; 3]>,
    /// The number of each among the given triangles.
    number_of_triangle: Vec<u32>,
}

impl SolidTriangles {
    fn new(points: &[DVec3], triangles: &[[u32; 3]], first: &[u32]) -> Result<Self> {
        let mut made = SolidTriangles {
            corners: alloc::with_capacity(triangles.len())?,
            number_of_triangle: alloc::with_capacity(triangles.len())?,
        };
        for (t, corners) in triangles.iter().enumerate() {
            let corners = corners.map(|v| first[v as usize]);
            if projection_axis(corners.map(|v| points[v as usize])).is_some() {
                made.corners.push(corners);
                made.number_of_triangle.push(t as u32);
            }
        }
        Ok(made)
    }

    /// Returns the place of a given triangle, which is not degenerate, in the list.
    fn place_of(&self, t: u32) -> u32 {
        self.number_of_triangle.partition_point(|&number| number < t) as u32
    }

    /// Returns the pairs of given triangles that intersect. See [`GridTriangles::new`].
    fn intersecting_pairs(&self, points: &[DVec3], suspects: Option<&BitSet>, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let is_suspect =
            |k: &u32| suspects.is_none_or(|suspects| suspects.contains(self.number_of_triangle[*k as usize]));
        let all = 0..self.corners.len() as u32;
        let mut order = alloc::gather(all.clone().filter(is_suspect))?;
        let suspect_count = order.len();
        alloc::extend(&mut order, all.filter(|k| !is_suspect(k)))?;
        let corners = alloc::collect(order.iter().map(|&k| self.corners[k as usize]))?;
        let (new, old) = corners.split_at(suspect_count);
        let mut pairs = intersecting_pairs(
            &TriangleSoup { position_of_vertex: |v| points[v as usize], new_triangles: new, old_triangles: old },
            job,
        )?;
        for pair in &mut pairs {
            *pair = pair.map(|k| self.number_of_triangle[order[k as usize] as usize]);
            pair.sort_unstable();
        }
        pairs.sort_unstable();
        Ok(pairs)
    }
}

fn find_contacts(
    triangles: &[[u32; 3]],
    pairs: &[[u32; 2]],
    points: &ExactPoints<'_>,
    job: &Job<'_>,
) -> Result<Vec<Contact>> {
    let corners = |t: u32| {
        let vertices = triangles[t as usize];
        TriangleCorners { triangle: t, vertices, positions: vertices.map(|v| points.rounded(v)) }
    };
    let tasks = par::split_into_ranges(pairs.len(), PAIRS_PER_TASK);
    let found = par::map_jobs(job, STAGE, tasks, |range, _| {
        alloc::collect(pairs[range].iter().map(|&[s, t]| find_contact(&corners(s), &corners(t))))
    })?;
    alloc::gather(found.into_iter().flatten())
}
