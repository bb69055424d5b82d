//! The patch of one rim: its triangulation, and a blend in its place if new vertices are asked for,
//! in as many ways as may be tried.

use super::clip::{clip_ears, is_planar, mean_normal};
use super::creases::{Division, divide};
use super::fill_request::{Fairing, Finish, Options, Refinement, Weight};
use super::loops::triangulate_together;
use super::patch_rim::Rim;
use super::search::{MAX_EXACT, minimum_weight};
use crate::blend::{self, Limits, Way};
use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::triangle_places::nearest_places;
use gusset_base::job::Job;

/// New vertices of a hole at the most, by an estimate, if the caller says nothing.
const MAX_NEW_VERTICES: u32 = 50_000;
/// New vertices for each of the rim's that sharp angles there may ask for, if the caller says
/// nothing.
const MAX_NEW_AT_RIM: u32 = 4;
/// How blends are faired, one way after the other until nothing cuts.
const WAYS: [Way; 4] = [
    Way { rounds: 4, unfolds: false },
    Way { rounds: 4, unfolds: true },
    Way { rounds: 1, unfolds: true },
    Way::UNFAIRED,
];
/// Faired vertices stay in the box round the rim, larger on all sides by this part of its diagonal.
pub(super) const MAX_BULGE: f64 = 0.5;

/// One way to fill a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attempt {
    pub(super) weight: Weight,
    /// How the blend is faired; `None`: no new vertices.
    way: Option<Way>,
    /// Creases of the old surface go on; if there are none, this is no way.
    creased: bool,
}

impl Attempt {
    /// True of patches with new vertices.
    pub(super) fn is_blend(self) -> bool {
        self.way.is_some()
    }

    /// What comes of it.
    pub(super) fn finish(self) -> Finish {
        match self.way {
            None => Finish::Plain,
            Some(Way::UNFAIRED) => Finish::Refined,
            Some(_) => Finish::Faired,
        }
    }
}

/// The ways that options allow, the one that they ask for first.
pub(super) fn attempts(options: &Options) -> Vec<Attempt> {
    let mut weights = vec![options.weight];
    weights.extend(Weight::CHOICES.values.iter().copied().filter(|&weight| weight != options.weight));
    let blends: &[Way] = match (options.refinement, options.fairing) {
        (Refinement::None, _) => &[],
        (Refinement::RimDensity(_), Fairing::None) => &[Way::UNFAIRED],
        (Refinement::RimDensity(_), Fairing::ThinPlate) => &WAYS,
    };
    let mut ways = Vec::new();
    for weight in weights {
        let creases: &[bool] = if options.ignore_creases { &[false] } else { &[true, false] };
        for &creased in creases {
            ways.extend(blends.iter().map(|&way| Attempt { weight, way: Some(way), creased }));
        }
        ways.extend(creases.iter().map(|&creased| Attempt { weight, way: None, creased }));
    }
    ways
}

/// The rim's vertices keep their numbers in the [`Rim`], and `points` come after them.
pub(super) struct Patch {
    /// The new vertices, in the rim's unit from its origin.
    pub(super) points: Vec<DVec3>,
    /// Where they would be without fairing: on the triangles of the first triangulation, or, between
    /// creases, near them.
    pub(super) unfaired: Vec<DVec3>,
    /// The first triangulation.
    pub(super) coarse: Vec<[u32; 3]>,
    /// The new faces.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// Plans how one rim is filled.
pub(super) struct Planner<'a, T: Fn(u32, u32) -> bool> {
    rim: &'a Rim,
    options: &'a Options,
    /// True of two vertices of the rim that must not get an edge.
    taken: &'a T,
    /// The last triangulation, and what blends of it begin with.
    coarse: Option<(Weight, Vec<[u32; 3]>)>,
    plan: Option<blend::Plan<&'a T>>,
}

impl<'a, T: Fn(u32, u32) -> bool> Planner<'a, T> {
    pub(super) fn new(rim: &'a Rim, options: &'a Options, taken: &'a T) -> Self {
        Planner { rim, options, taken, coarse: None, plan: None }
    }

    /// True if the last patch had no triangulation.
    pub(super) fn is_stuck(&self) -> bool {
        self.coarse.is_none()
    }

    /// The patch; `None` if every triangulation would have an edge that is taken, if none was found
    /// that closes several loops, or if the patch would leave the neighbourhood of its rim.
    ///
    /// O(n^3) for a rim of n <= 128 vertices, O(n log n) for longer ones. Refinement and fairing of m
    /// new vertices: O(m log m), and O(m^1.5) for the sparse factor.
    pub(super) fn patch(&mut self, attempt: Attempt, job: &Job<'_>) -> Result<Option<Patch>> {
        let rim = self.rim;
        if self.coarse.as_ref().is_none_or(|&(weight, _)| weight != attempt.weight) {
            self.plan = None;
            let found = triangulate(rim, attempt.weight, self.taken, &job.part(0.0, 0.4))?;
            self.coarse = found.map(|triangles| (attempt.weight, triangles));
        }
        let Some((_, coarse)) = &self.coarse else {
            return Ok(None);
        };
        if attempt.creased {
            return self.creased(attempt, coarse, &job.part(0.4, 1.0));
        }
        if let (Refinement::RimDensity(limit), None, true) =
            (self.options.refinement, &self.plan, attempt.way.is_some())
        {
            let copy = alloc::copied(coarse)?;
            self.plan = blend::Plan::new(
                rim.old_ring(self.options.continuity)?,
                copy,
                limits(limit),
                self.taken,
                &job.part(0.4, 0.6),
            )?;
        }
        let coarse = alloc::copied(coarse)?;
        if attempt.is_blend() && self.plan.is_none() {
            return Ok(None);
        }
        let (Some(plan), Some(way)) = (&self.plan, attempt.way) else {
            let triangles = alloc::copied(&coarse)?;
            return Ok(Some(Patch { points: Vec::new(), unfaired: Vec::new(), coarse, triangles }));
        };
        let made = plan.blend(way, &job.part(0.6, 1.0))?;
        if !is_near(rim, &made.points) {
            return Ok(None);
        }
        if way != Way::UNFAIRED {
            return Ok(Some(Patch { points: made.points, unfaired: made.unfaired, coarse, triangles: made.triangles }));
        }
        // Flips and moves cut the corners of a bent triangulation: back to it, so that each vertex
        // is where the vertices that it comes from say.
        let points = on_triangles(&rim.points[..rim.count], &coarse, &made.points, &job.part(1.0, 1.0))?;
        Ok(Some(Patch { unfaired: alloc::copied(&points)?, points, coarse, triangles: made.triangles }))
    }

    /// The patch of parts between creases; `None` if none go on, too. `whole`: the first triangulation
    /// of the hole, which says what new vertices come from.
    fn creased(&self, attempt: Attempt, whole: &[[u32; 3]], job: &Job<'_>) -> Result<Option<Patch>> {
        let rim = self.rim;
        let limits = match self.options.refinement {
            Refinement::RimDensity(limit) if attempt.way.is_some() => Some(limits(limit)),
            _ => None,
        };
        // Half of them for the parts.
        let Some(Division { points, parts }) = divide(rim, self.taken, limits.map(|limits| limits.new / 2))? else {
            return Ok(None);
        };
        let unfaired = alloc::copied(&points)?;
        let mut patch = Patch { points, unfaired, coarse: alloc::copied(whole)?, triangles: Vec::new() };
        let all: usize = parts.iter().map(|part| part.names.len()).sum();
        for (k, part) in parts.iter().enumerate() {
            let job = job.share(k, parts.len());
            let taken = |u: u32, v: u32| part.is_taken(u, v, self.taken);
            let Some(mut triangles) = triangulate(&part.rim, attempt.weight, &taken, &job.part(0.0, 0.4))? else {
                return Ok(None);
            };
            let first = rim.count + patch.points.len();
            if let Some((way, limits)) = attempt.way.zip(limits) {
                let new = (u64::from(limits.new / 2) * part.names.len() as u64 / all as u64).max(1) as u32;
                let limits = Limits { new, ..limits };
                let plan = blend::Plan::new(
                    part.rim.old_ring(self.options.continuity)?,
                    triangles,
                    limits,
                    taken,
                    &job.part(0.4, 0.6),
                )?;
                let Some(plan) = plan else {
                    return Ok(None);
                };
                let made = plan.blend(way, &job.part(0.6, 1.0))?;
                let unfaired = if way == Way::UNFAIRED { &made.points } else { &made.unfaired };
                alloc::append(&mut patch.points, &made.points)?;
                alloc::append(&mut patch.unfaired, unfaired)?;
                triangles = made.triangles;
            }
            let name = |v: u32| match (v as usize).checked_sub(part.names.len()) {
                None => part.names[v as usize],
                Some(k) => (first + k) as u32,
            };
            alloc::extend(&mut patch.triangles, triangles.iter().map(|triangle| triangle.map(name)))?;
        }
        Ok(is_near(rim, &patch.points).then_some(patch))
    }
}

/// How many new vertices a hole gets; `limit`: the caller's, or 0.
fn limits(limit: u32) -> Limits {
    let [new, at_rim] = if limit == 0 { [MAX_NEW_VERTICES, MAX_NEW_AT_RIM] } else { [limit, 0] };
    Limits { new, at_rim, growth: f64::INFINITY }
}

/// The places on triangles that are nearest to points.
fn on_triangles(rim: &[DVec3], triangles: &[[u32; 3]], points: &[DVec3], job: &Job<'_>) -> Result<Vec<DVec3>> {
    let places = nearest_places(rim, triangles, points, "refining", job)?;
    let at = |v: u32| rim[v as usize];
    alloc::collect(places.iter().map(|&(of, weights)| of.into_iter().zip(weights).map(|(v, w)| w * at(v)).sum()))
}

fn is_near(rim: &Rim, points: &[DVec3]) -> bool {
    let room = neighbourhood(&rim.points[..rim.count]);
    points.iter().all(|&p| room.axis_distances(p) == DVec3::ZERO)
}

/// What no patch leaves.
pub(super) fn neighbourhood(rim: &[DVec3]) -> Aabb {
    let around = Aabb::from_points(rim);
    around.inflated(MAX_BULGE * around.diagonal())
}

/// The triangulation of least weight; `None` if none was found without an edge that is taken.
pub(super) fn triangulate(
    rim: &Rim,
    weight: Weight,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let polygons = rim.polygons()?;
    let [polygon] = polygons.as_slice() else {
        return triangulate_together(&polygons, weight, taken, job);
    };
    let points = polygon.points.as_slice();
    let n = points.len();
    // Without overlaps a planar triangulation has the least area, too.
    let planar = matches!(weight, Weight::Continuation | Weight::Area) && is_planar(points, mean_normal(points));
    if planar
        && n > MAX_EXACT
        && let Some(triangles) = clip_ears(points, taken, &job.part(0.0, 0.1))?
    {
        return relaxed(points, triangles, taken, &job.part(0.1, 1.0)).map(Some);
    }
    // On a plane the surface beyond the rim has no say.
    let weight = if planar { Weight::Area } else { weight };
    let found = minimum_weight(polygon, weight, &|i, k| taken(i as u32, k as u32), &job.part(0.1, 1.0))?;
    let Some(triangles) = found else {
        // Of a long rim only chords in bands were tried.
        return if n > MAX_EXACT { clip_ears(points, taken, &job.part(1.0, 1.0)) } else { Ok(None) };
    };
    if planar {
        return relaxed(points, triangles, taken, &job.part(1.0, 1.0)).map(Some);
    }
    Ok(Some(triangles))
}

/// Flipped to Delaunay's rule.
fn relaxed(
    points: &[DVec3],
    triangles: Vec<[u32; 3]>,
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Vec<[u32; 3]>> {
    let mut mesh = PatchMesh::new(alloc::copied(points)?, triangles)?;
    mesh.relax(points.len(), &taken, job)?;
    Ok(mesh.triangles)
}
