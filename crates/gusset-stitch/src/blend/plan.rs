//! The steps from coarse triangles to a blend.

use super::ring::{MAX_SMOOTH_BEND, OldRing};
use crate::fair::mean_curvature;
use crate::remesh::{PatchMesh, Sizing, even, growth, insert, needed};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// How long new sides are, in old ones.
const SIZE: f64 = 0.8;
/// Before that sharp triangles are left whose shortest side is below this part of the size.
const SHORTEST: f64 = 0.3;
/// And at last below this.
const SHORTEST_AT_LAST: f64 = 1e-3;
/// Rounds in which vertices move within the surface, before each solution and at last.
const SETTLE: [u32; 2] = [2, 5];
/// Averages over neighbours that make of the strip's curvature, which sits in its ridges, that of
/// the surface it stands for.
const SMOOTHING: u32 = 10;

/// How a blend is faired.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way {
    /// How often the plate is solved, with refinement before.
    pub(crate) rounds: u32,
    /// Vertices that fold a triangle stay behind: dearer in smoothness, where nothing cuts without.
    pub(crate) unfolds: bool,
}

impl Way {
    /// Without fairing.
    pub(crate) const UNFAIRED: Way = Way { rounds: 0, unfolds: true };
}

/// How many new vertices there may be.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    /// That the sizes may ask for, by an estimate. Where more would be needed, all sides grow; where
    /// the estimate does not fit the shape, there are at most twice as many.
    pub(crate) new: u32,
    /// For each of the rims' vertices so many may be asked for in any case, and as many again for
    /// sharp angles.
    pub(crate) at_rim: u32,
    /// Where sides would have to grow by more, there is no blend; nor, if this is finite, where the
    /// limits are met.
    pub(crate) growth: f64,
}

/// What takes the place of coarse triangles.
pub(crate) struct Blend {
    /// The rims' vertices keep their numbers; the new ones come after them.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The new vertices, in the unit of the [`OldRing`], but from 0.
    pub(crate) points: Vec<DVec3>,
    /// Where they would be without fairing.
    pub(crate) unfaired: Vec<DVec3>,
}

/// What all ways begin with.
pub(crate) struct Plan<T: Fn(u32, u32) -> bool> {
    ring: OldRing,
    /// True of two vertices of the rims that must not get an edge.
    taken: T,
    /// The coarse triangles with sides as long as is wanted.
    mesh: PatchMesh,
    sizing: Sizing,
    /// Creases of a smaller cosine are ironed out.
    min_cosine: f64,
    /// True of the rims' vertices where old creases end.
    creased: Vec<bool>,
}

impl<T: Fn(u32, u32) -> bool> Plan<T> {
    /// Of triangles between the rims; `None` if the limits do not allow a blend. O(T + n log n) for
    /// T triangles and n new vertices.
    pub(crate) fn new(
        mut ring: OldRing,
        triangles: Vec<[u32; 3]>,
        limits: Limits,
        taken: T,
        job: &Job<'_>,
    ) -> Result<Option<Self>> {
        let rim = ring.centred.len();
        let (usual, creased) = ring.bends()?;
        // Of twice the angle.
        let min_cosine = MAX_SMOOTH_BEND.min(2.0 * usual * usual - 1.0);
        let mut mesh = PatchMesh::new(alloc::copied(&ring.points[..rim])?, triangles)?;
        let mut size = ring.sizes()?;
        size.iter_mut().for_each(|s| *s *= SIZE);
        let at_rim = limits.at_rim.saturating_mul(rim as u32);
        let limit = limits.new.max(at_rim);
        let needed = needed(&mesh, &size);
        // Of sides without length.
        if !needed.is_finite() {
            return Ok(None);
        }
        let needed = needed.min(f64::from(limit));
        let grown = growth(&mesh, &size, limit);
        if grown > limits.growth {
            return Ok(None);
        }
        size.iter_mut().for_each(|s| *s *= grown);
        ring.draw_near(&size)?;
        let mut sizing = Sizing {
            size,
            unfaired: alloc::copied(&mesh.points)?,
            curvature: alloc::filled(DVec3::ZERO, rim)?,
            // Twice the estimate: for shapes that it does not fit.
            limit: rim + 2 * needed as usize + at_rim as usize,
            shortest: SHORTEST,
        };
        even(&mut mesh, rim, &mut sizing, &taken, &job.part(0.0, 0.5))?;
        insert(&mut mesh, rim, &mut sizing, &taken, &job.part(0.5, 0.8))?;
        if limits.growth.is_finite() && mesh.points.len() >= sizing.limit {
            return Ok(None);
        }
        mesh.settle(rim, &taken, SETTLE[0], &job.part(0.8, 1.0))?;
        let closed = |v: usize| v >= rim;
        sizing.curvature = mean_curvature(&mesh.points, &mesh.triangles, &closed, SMOOTHING, &job.part(1.0, 1.0))?;
        Ok(Some(Plan { ring, taken, mesh, sizing, min_cosine, creased }))
    }

    /// The blend. For n new vertices O(n log n) and the plate's O(n^1.5), nearly linear on a narrow
    /// strip.
    pub(crate) fn blend(&self, way: Way, job: &Job<'_>) -> Result<Blend> {
        let (ring, taken, rim) = (&self.ring, &self.taken, self.ring.centred.len());
        let (mut mesh, mut sizing) = (self.mesh.try_clone()?, self.sizing.try_clone()?);
        for round in 0..way.rounds {
            let part = job.part(0.0, 0.6).share(round as usize, way.rounds as usize);
            if round > 0 {
                insert(&mut mesh, rim, &mut sizing, taken, &part.part(0.0, 0.3))?;
                mesh.settle(rim, taken, SETTLE[0], &part.part(0.3, 0.4))?;
                if let Some(passes) = ring.follows {
                    sizing.curvature = ring.solved_curvature(&mesh, passes, &part.part(0.4, 0.4))?;
                }
            }
            ring.fair(&mut mesh, &sizing, way.unfolds, &part.part(0.4, 1.0))?;
        }
        mesh.iron(rim, self.min_cosine, &self.creased, &job.part(0.6, 0.7))?;
        sizing.shortest = SHORTEST_AT_LAST;
        insert(&mut mesh, rim, &mut sizing, taken, &job.part(0.7, 0.8))?;
        mesh.settle(rim, taken, SETTLE[1], &job.part(0.8, 1.0))?;
        let back = |points: &[DVec3]| alloc::collect(points[rim..].iter().map(|&p| p + ring.origin));
        Ok(Blend { points: back(&mesh.points)?, unfaired: back(&sizing.unfaired)?, triangles: mesh.triangles })
    }
}
