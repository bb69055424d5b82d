//! The patches of all selected holes, appended to a copy of the mesh in the order of the loops.

use super::choose::{Candidate, all_loops, given_loops};
use super::cuts::{Old, Trials, cuts, cutting};
use super::near::faces_near;
use super::patch::{Planner, attempts, neighbourhood};
use super::placed::{Placed, Pool};
use super::request::{Fairing, Filled, Finish, Hole, HoleStatus, Options, Refinement};
use super::rim::Rim;
use super::surroundings::Surroundings;
use crate::alloc;
use crate::boundary::{self, Survey, boundary_loops};
use crate::error::{Error, Result};
use crate::geom::Aabb;
use crate::geom::bit_set::BitSet;
use crate::geom::scale::distance;
use crate::job::Job;
use crate::mesh::{MeshView, concat};
use crate::repair::orient::{Outward, turn_outwards};
use crate::stitch::{Intersections, Quality, part_alone};
use std::collections::BTreeSet;

/// Fills holes of a mesh: closes boundary loops by new triangles, oriented as the surface round
/// them.
///
/// `loops`: the vertices of each in order, in either direction, each consecutive pair (and the last
/// with the first) being an edge with exactly one face; `None` for all loops that the mesh has, cut
/// into simple ones where the boundary touches itself. Loops that cannot be filled are left, and
/// the account of each says why; nothing of this is an error.
///
/// A loop of n <= 128 vertices gets its triangulation of least weight by dynamic programming over
/// all chords, in O(n^3); by area it is the least there is. A longer one is searched from coarse to
/// fine, in O(n); a long planar one is cut ear by ear, in O(n log n), and its edges flipped to
/// Delaunay's rule. No new edge joins two vertices of one old face, so that a result that is closed
/// stays so when its polygons are cut into triangles. A planar hole is triangulated without overlaps
/// by the default weight and by the area, however concave it is, if its rim does not cross itself.
///
/// Faces of a patch that cut each other or old faces are looked for, exactly. Where there are any,
/// less fairing, the other weights and no new vertices are tried, and what cuts least is taken;
/// [`Filled::intersections`] has what is left. No faired vertex leaves the box round its rim, larger
/// on all sides by half its diagonal.
///
/// O(H) for H half-edges besides (O(H log d) where the boundary is odd), and what refinement and
/// fairing of m new vertices need: O(m^1.5). The search for cuts takes O(n log n) for n faces near
/// the holes, and time for each pair whose boxes overlap: O(n^2) where many long triangles meet at
/// neighbouring vertices, as in plain patches of very long rims. Extra memory is linear.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a limit that is no number or negative; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn fill_holes(mesh: &MeshView<'_>, loops: Option<&[&[u32]]>, options: &Options, job: &Job<'_>) -> Result<Filled> {
    let limits = &options.limits;
    let named = [("max_length", limits.length), ("max_diameter", limits.diameter), ("max_area", limits.area)];
    for (option, limit) in named {
        let limit = limit.unwrap_or(0.0);
        Error::require(limit >= 0.0, option, limit)?;
    }
    if options.fairing == Fairing::ThinPlate && options.refinement == Refinement::None {
        job.note("fairing moves the new vertices inside holes, and none were asked for: it does nothing");
    }
    let survey = boundary::Options { survey: Survey::BoundaryOnly, ..boundary::Options::default() };
    let boundary = boundary_loops(mesh, &survey, &job.part(0.0, 0.2))?;
    let candidates = match loops {
        Some(loops) => given_loops(mesh, &boundary, loops, &options.limits)?,
        None => all_loops(mesh, &boundary, options)?,
    };
    let mut passes = alloc::filled(0u8, mesh.positions().len())?;
    for found in boundary.iter() {
        found.vertices.iter().for_each(|&v| passes[v as usize] = passes[v as usize].saturating_add(1));
    }
    let mut filling = Filling::new(mesh, &candidates, &passes, options, &job.part(0.2, 0.3))?;
    if !options.plan_only {
        filling.fill(&candidates, &job.part(0.3, 0.7))?;
    }
    filling.finish(&candidates, &job.part(0.7, 1.0))
}

/// The patches of the holes.
struct Filling<'a> {
    options: &'a Options,
    /// Per vertex of the mesh, how many loops pass it.
    passes: &'a [u8],
    /// The faces near the holes, ascending.
    near: Vec<u32>,
    surroundings: Surroundings,
    /// New edges between old vertices that more than one loop passes: no other hole may repeat them.
    bridges: BTreeSet<(u32, u32)>,
    pool: Pool<'a>,
    /// The candidates that have a patch, and the patches.
    numbers: Vec<usize>,
    patches: Vec<Placed>,
    intersections: Option<Vec<[u32; 2]>>,
}

fn to_fill(candidates: &[Candidate]) -> impl Iterator<Item = &Candidate> {
    candidates.iter().filter(|candidate| candidate.status == HoleStatus::Filled)
}

impl<'a> Filling<'a> {
    fn new(
        mesh: &'a MeshView<'a>,
        candidates: &[Candidate],
        passes: &'a [u8],
        options: &'a Options,
        job: &Job<'_>,
    ) -> Result<Self> {
        let mut on_rim = BitSet::new(mesh.positions().len())?;
        let mut points = Vec::new();
        let mut boxes = Vec::new();
        for candidate in to_fill(candidates) {
            candidate.vertices.iter().for_each(|&v| on_rim.insert(v));
            let first = points.len();
            alloc::extend(&mut points, candidate.vertices.iter().map(|&v| mesh.positions().get(v)))?;
            let rim = &points[first..];
            let bulges = options.fairing == Fairing::ThinPlate && options.refinement != Refinement::None;
            alloc::push(&mut boxes, if bulges { neighbourhood(rim) } else { Aabb::of(rim) })?;
        }
        let near = if options.plan_only { Vec::new() } else { faces_near(mesh, &boxes, &job.part(0.0, 0.9))? };
        let surroundings = Surroundings::new(mesh, &near, |v| on_rim.contains(v), &job.part(0.9, 1.0))?;
        Ok(Filling {
            options,
            passes,
            near,
            surroundings,
            bridges: BTreeSet::new(),
            pool: Pool::new(mesh, &points),
            numbers: Vec::new(),
            patches: Vec::new(),
            intersections: None,
        })
    }

    fn fill(&mut self, candidates: &[Candidate], job: &Job<'_>) -> Result<()> {
        let all: usize = to_fill(candidates).map(|candidate| candidate.vertices.len()).sum();
        let (mut done, make) = (0, job.part(0.0, 0.6));
        for (number, candidate) in candidates.iter().enumerate() {
            if candidate.status != HoleStatus::Filled {
                continue;
            }
            let end = done + candidate.vertices.len();
            let part = make.part(done as f64 / all as f64, end as f64 / all as f64);
            done = end;
            if let Some(placed) = self.first_patch(candidate, &part)? {
                alloc::push(&mut self.numbers, number)?;
                alloc::push(&mut self.patches, placed)?;
            }
        }
        if self.options.intersections != Intersections::Ignore {
            self.avoid_cuts(candidates, &job.part(0.6, 1.0))?;
        }
        Ok(())
    }

    /// A hole in numbers of its own.
    fn rim(&mut self, candidate: &Candidate) -> Result<(Rim, Vec<u32>)> {
        let (mesh, passes) = (self.pool.mesh, self.passes);
        // The rim runs against the loop.
        let mut names = alloc::collect(candidate.vertices.iter().rev().copied())?;
        // It ends with its longest side, of equals that at the first vertex, wherever the caller's
        // loop begins.
        let length = |i: usize| {
            let [p, q] = [i, (i + 1) % names.len()].map(|i| mesh.positions().get(names[i]));
            distance(p, q)
        };
        let by_length = |&i: &usize, &j: &usize| length(i).total_cmp(&length(j)).then(names[j].cmp(&names[i]));
        let last = (0..names.len()).max_by(by_length).unwrap_or(0);
        let first = (last + 1) % names.len();
        names.rotate_left(first);
        let rim = self.surroundings.rim(mesh, &names, |v| passes[v as usize] == 1)?;
        Ok((rim, names))
    }

    /// The first patch that can be had.
    fn first_patch(&mut self, candidate: &Candidate, job: &Job<'_>) -> Result<Option<Placed>> {
        let (rim, names) = self.rim(candidate)?;
        let taken =
            |u: u32, v: u32| is_taken(&self.surroundings, &self.bridges, [names[u as usize], names[v as usize]]);
        let mut planner = Planner::new(&rim, self.options, &taken);
        let mut found = None;
        let ways = attempts(self.options);
        for (i, &attempt) in ways.iter().enumerate() {
            if let Some(patch) = planner.patch(attempt, &job.share(i, ways.len()))? {
                found = Some(self.pool.place(&rim, &names, &patch, attempt)?);
            }
            if found.is_some() || planner.is_stuck() {
                break;
            }
        }
        drop(planner);
        self.bridges.extend(found.iter().flat_map(|placed| bridges(self.passes, placed)));
        Ok(found)
    }

    /// Looks for cuts, and lets the patches that have some try other ways.
    fn avoid_cuts(&mut self, candidates: &[Candidate], job: &Job<'_>) -> Result<()> {
        let old = Old::new(self.pool.mesh, &self.near, &job.part(0.0, 0.1))?;
        let mut pairs = cuts(&self.pool, &self.patches, &old, &job.part(0.1, 0.3))?;
        if !pairs.is_empty() && self.options.intersections == Intersections::Auto {
            let trials = Trials::new(&self.pool, &old)?;
            let cutting = cutting(&pairs, &self.patches)?;
            for (i, &k) in cutting.iter().enumerate() {
                let job = job.part(0.3, 0.8).share(i, cutting.len());
                self.try_others(&candidates[self.numbers[k]], k, &trials, &job)?;
            }
            pairs = cuts(&self.pool, &self.patches, &old, &job.part(0.8, 1.0))?;
        }
        let first_new = self.pool.mesh.faces().len() as u32;
        self.intersections = Some(old.faces_of(&pairs, &self.patches, first_new)?);
        Ok(())
    }

    /// Puts the patch that cuts least in the place of patch `k`, of equals the first.
    fn try_others(&mut self, candidate: &Candidate, k: usize, trials: &Trials<'_>, job: &Job<'_>) -> Result<()> {
        let (rim, names) = self.rim(candidate)?;
        let taken =
            |u: u32, v: u32| is_taken(&self.surroundings, &self.bridges, [names[u as usize], names[v as usize]]);
        let mut planner = Planner::new(&rim, self.options, &taken);
        let mut least = trials.count(&self.pool, &self.patches, k, &self.patches[k], job)?;
        let mut better = None;
        let ways = attempts(self.options);
        for (i, &attempt) in ways.iter().enumerate() {
            let job = job.share(i, ways.len());
            if least == 0 {
                break;
            }
            if attempt == self.patches[k].attempt {
                continue;
            }
            let Some(patch) = planner.patch(attempt, &job.part(0.0, 0.7))? else {
                continue;
            };
            let placed = self.pool.place(&rim, &names, &patch, attempt)?;
            let count = trials.count(&self.pool, &self.patches, k, &placed, &job.part(0.7, 1.0))?;
            if count < least {
                (least, better) = (count, Some(placed));
            }
        }
        drop(planner);
        self.bridges.extend(better.iter().flat_map(|placed| bridges(self.passes, placed)));
        if let Some(placed) = better {
            self.patches[k] = placed;
        }
        Ok(())
    }

    fn finish(self, candidates: &[Candidate], job: &Job<'_>) -> Result<Filled> {
        let mesh = self.pool.mesh;
        job.step(0.0, "putting the pieces together")?;
        let counts = self.patches.iter().map(|patch| [patch.vertices.len(), patch.triangles.len()]);
        let [points, faces] = counts.fold([0, 0], |sum, count| [sum[0] + count[0], sum[1] + count[1]]);
        let mut whole = concat::empty(std::iter::once(mesh), [points, faces, 3 * faces])?;
        concat::append(&mut whole, mesh, |_| false)?;
        let mut rims = Vec::new();
        let (mut parents, mut weights) = (alloc::with_capacity(points)?, alloc::with_capacity(points)?);
        let mut holes = alloc::with_capacity(candidates.len())?;
        let mut made = self.numbers.iter().zip(&self.patches).peekable();
        for (number, candidate) in candidates.iter().enumerate() {
            let [first_face, first_vertex] = [whole.face_count() as u32, whole.positions.len() as u32];
            let mut status = candidate.status;
            let patch = made.next_if(|&(&of, _)| of == number).map(|(_, patch)| patch);
            if let Some(patch) = patch {
                let old = mesh.positions().len() as u32;
                let name = |v: u32| if v < old { v } else { v - patch.vertices.start + first_vertex };
                whole.positions.extend(patch.vertices.clone().map(|v| self.pool.at(v)))?;
                for triangle in &patch.triangles {
                    whole.face_corners.extend(triangle.map(name));
                    whole.face_offsets.push(whole.face_corners.len() as u32);
                }
                parents.extend(patch.parents.iter().map(|&(of, _)| of));
                weights.extend(patch.parents.iter().map(|&(_, weights)| weights));
            } else if status == HoleStatus::Filled && !self.options.plan_only {
                status = HoleStatus::NoTriangulation;
            }
            let start = rims.len();
            alloc::append(&mut rims, &candidate.vertices)?;
            holes.push(Hole {
                status,
                rim: start..rims.len(),
                faces: first_face..whole.face_count() as u32,
                vertices: first_vertex..whole.positions.len() as u32,
                measures: candidate.measures,
                weight: patch.map_or(self.options.weight, |patch| patch.attempt.weight),
                finish: patch.map_or(Finish::Plain, |patch| patch.attempt.finish()),
            });
        }
        job.step(0.1, "putting the pieces together")?;
        let part = part_alone(&whole, mesh.faces().len(), &job.part(0.1, 0.3))?;
        let measured = if self.options.outward == Outward::Closed { 0.7 } else { 1.0 };
        let quality = Quality::of(&whole, &part, &job.part(0.3, measured))?;
        let turned_outwards = match self.options.outward {
            Outward::Keep => Vec::new(),
            Outward::Closed => turn_outwards(&mut whole, &job.part(measured, 1.0))?.turned,
        };
        let intersections = self.intersections;
        Ok(Filled { mesh: whole, holes, rims, parents, weights, intersections, turned_outwards, quality })
    }
}

/// True of two vertices of rims that must not get an edge.
fn is_taken(surroundings: &Surroundings, bridges: &BTreeSet<(u32, u32)>, [u, v]: [u32; 2]) -> bool {
    surroundings.share_face(u, v) || bridges.contains(&(u.min(v), u.max(v)))
}

/// The edges of a patch between two old vertices that more than one loop passes.
fn bridges(passes: &[u8], patch: &Placed) -> impl Iterator<Item = (u32, u32)> {
    let shared = |v: u32| passes.get(v as usize).is_some_and(|&count| count > 1);
    let sides = patch.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    sides.filter(move |&(u, v)| shared(u) && shared(v)).map(|(u, v)| (u.min(v), u.max(v)))
}
