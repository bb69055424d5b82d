//! The places where two curves meet, or where a curve meets itself. In the plane they are
//! intersections, in space minima of the distance.

use super::intersect::{Intersection, Intersections};
use super::near_misses::{NearMiss, NearMisses};
use crate::curve::CurveView;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

impl CurveView<'_> {
    /// Finds the places where two curves meet or come as near to each other as `within`. Without
    /// `other` finds the places where a plane curve meets itself, and `within` must be 0.
    ///
    /// If `within` is 0 and both curves are plane, the places are
    /// [`intersections`](Self::intersections), else [`near_misses`](Self::near_misses).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (`within` is negative or not finite, or not 0 without `other`),
    /// [`Error::CurveNotPlane`] (without `other`), [`Error::EmptyCurve`] (near misses),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn intersections_or_near_misses(
        &self,
        other: Option<&CurveView<'_>>,
        within: f64,
        job: &Job<'_>,
    ) -> Result<NearMisses> {
        let Some(other) = other else {
            Error::require(within == 0.0, "within", within, "0 without a second curve")?;
            return self.self_intersections(job)?.into_near_misses();
        };
        if within == 0.0 && self.check_in_xy_plane().is_ok() && other.check_in_xy_plane().is_ok() {
            return self.intersections(other, job)?.into_near_misses();
        }
        self.near_misses(other, within, job)
    }
}

impl Intersections {
    fn into_near_misses(self) -> Result<NearMisses> {
        let Intersections { points, overlaps, undecided } = self;
        let places = alloc::collect(points.iter().map(|&Intersection { a, b }| NearMiss { a, b, distance: 0.0 }))?;
        Ok(NearMisses { places, overlaps, undecided })
    }
}
