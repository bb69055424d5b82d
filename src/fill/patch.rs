//! The patch of one hole: its triangulation, and a blend in its place if new vertices are asked for,
//! in as many ways as may be tried.

use super::clip::{clip_ears, mean_normal};
use super::request::{Fairing, Finish, Options, Refinement, Weight};
use super::rim::Rim;
use super::search::{MAX_EXACT, minimum_weight};
use super::weigh::Polygon;
use crate::alloc;
use crate::blend::{self, Limits, Way};
use crate::error::Result;
use crate::geom::Aabb;
use crate::job::Job;
use crate::remesh::PatchMesh;
use glam::DVec3;

/// A rim is planar if it deviates from a plane by no more than this part of its size.
const MAX_RELATIVE_DEVIATION: f64 = 1e-6;
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
}

impl Attempt {
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
    let ways: Vec<_> = match (options.refinement, options.fairing) {
        (Refinement::None, _) => vec![None],
        (Refinement::RimDensity(_), Fairing::None) => vec![Some(Way::UNFAIRED), None],
        (Refinement::RimDensity(_), Fairing::ThinPlate) => WAYS.into_iter().map(Some).chain([None]).collect(),
    };
    let of = |weight| ways.iter().map(move |&way| Attempt { weight, way });
    weights.into_iter().flat_map(of).collect()
}

/// The rim's vertices keep their numbers in the [`Rim`], and `points` come after them.
pub(super) struct Patch {
    /// The new vertices, in the rim's unit from its origin.
    pub(super) points: Vec<DVec3>,
    /// Where they would be without fairing: on the triangles of the first triangulation.
    pub(super) unfaired: Vec<DVec3>,
    /// The first triangulation.
    pub(super) coarse: Vec<[u32; 3]>,
    /// The new faces.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// Plans how one hole is filled.
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

    /// True if the last patch had no triangulation without an edge that is taken.
    pub(super) fn is_stuck(&self) -> bool {
        self.coarse.is_none()
    }

    /// The patch; `None` if every triangulation would have an edge that is taken, or if the patch
    /// would leave the neighbourhood of its rim.
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
        if let (Refinement::RimDensity(limit), None, true) =
            (self.options.refinement, &self.plan, attempt.way.is_some())
        {
            let [new, at_rim] = if limit == 0 { [MAX_NEW_VERTICES, MAX_NEW_AT_RIM] } else { [limit, 0] };
            let limits = Limits { new, at_rim, growth: f64::INFINITY };
            let copy = alloc::copied(coarse)?;
            self.plan = blend::Plan::new(rim.old_ring()?, copy, limits, self.taken, &job.part(0.4, 0.6))?;
        }
        let coarse = alloc::copied(coarse)?;
        let (Some(plan), Some(way)) = (&self.plan, attempt.way) else {
            let triangles = alloc::copied(&coarse)?;
            return Ok(Some(Patch { points: Vec::new(), unfaired: Vec::new(), coarse, triangles }));
        };
        let made = plan.blend(way, &job.part(0.6, 1.0))?;
        let room = neighbourhood(&rim.points[..rim.count]);
        if !made.points.iter().all(|&p| room.outside(p) == DVec3::ZERO) {
            return Ok(None);
        }
        // Without fairing they have moved along the plain triangles only.
        let unfaired = if way == Way::UNFAIRED { alloc::copied(&made.points)? } else { made.unfaired };
        Ok(Some(Patch { points: made.points, unfaired, coarse, triangles: made.triangles }))
    }
}

/// What no patch leaves.
pub(super) fn neighbourhood(rim: &[DVec3]) -> Aabb {
    let around = Aabb::of(rim);
    around.inflated(MAX_BULGE * around.diagonal())
}

fn triangulate(
    rim: &Rim,
    weight: Weight,
    taken: &impl Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let points = &rim.points[..rim.count];
    let n = points.len();
    // Without overlaps a planar triangulation has the least area, too.
    let planar = matches!(weight, Weight::Continuation | Weight::Area) && is_planar(points);
    if planar
        && n > MAX_EXACT
        && let Some(triangles) = clip_ears(points, taken, &job.part(0.0, 0.5))?
    {
        return relaxed(points, triangles, taken, &job.part(0.5, 1.0)).map(Some);
    }
    let own = |of: &[DVec3]| alloc::copied(&of[..n]);
    let polygon = Polygon::new(own(points)?, own(&rim.across)?, own(&rim.normals)?);
    // On a plane the surface beyond the rim has no say.
    let weight = if planar { Weight::Area } else { weight };
    let found = minimum_weight(&polygon, weight, &|i, k| taken(i as u32, k as u32), job)?;
    let Some(triangles) = found else {
        // Of a long rim only chords in bands were tried.
        return if n > MAX_EXACT { clip_ears(points, taken, job) } else { Ok(None) };
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
    taken: &impl Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Vec<[u32; 3]>> {
    let mut mesh = PatchMesh::new(alloc::copied(points)?, triangles)?;
    mesh.relax(points.len(), taken, job)?;
    Ok(mesh.triangles)
}

/// True if all points are as near to their mean plane as round-off of single precision may have
/// left them.
fn is_planar(points: &[DVec3]) -> bool {
    let normal = mean_normal(points);
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    points.iter().all(|&p| (p - points[0]).dot(normal).abs() <= MAX_RELATIVE_DEVIATION * size)
}
