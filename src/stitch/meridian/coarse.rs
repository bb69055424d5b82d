//! Coarse to fine: a nearly best path through a lattice that is too large to be searched whole.
//!
//! Every second vertex of the rims is left out, again and again, until the lattice is small; there the best path is found
//! exactly. On the way back each path shows where the next finer one is looked for: within a band round it. What is lost
//! was at most a few hundredths of a per cent on the study's rims.

use super::band::Band;
use super::{Pair, Rails};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// A lattice of at most so many nodes is searched whole.
const COARSEST: usize = 1 << 16;

/// A rim of fewer segments than this is not thinned out further.
const FEWEST: usize = 32;

/// Half the width of the band.
const WIDTH: usize = 8;

/// Searches the lattice coarse to fine. `search` finds the best path within a band of the lattice of some rails, the given ones thinned
/// out. Time and memory: the search of about (2 WIDTH + 1) (N + M) nodes, and half as many, and so on.
pub(super) fn coarse_to_fine(
    rails: &Rails<'_>,
    search: &impl Fn(&Rails<'_>, &Band, &Job<'_>) -> Result<Option<Vec<Pair>>>,
    job: &Job<'_>,
) -> Result<Option<Vec<Pair>>> {
    let (n, m) = (rails.a.len() - 1, rails.b.len() - 1);
    let thin = [n >= FEWEST, m >= FEWEST];
    if (n + 1) * (m + 1) <= COARSEST || thin == [false, false] {
        return search(rails, &Band::full(n, m)?, job);
    }
    let (a, b) = (thinned(rails.a, thin[0])?, thinned(rails.b, thin[1])?);
    let sides = match rails.sides {
        Some([side_a, side_b]) => Some([thinned_sides(side_a, thin[0])?, thinned_sides(side_b, thin[1])?]),
        None => None,
    };
    // A forbidden meridian forbids nothing in the large.
    let sides = sides.as_ref().map(|[side_a, side_b]| [side_a.as_slice(), side_b.as_slice()]);
    let coarse = Rails { a: &a, b: &b, closed: rails.closed, forbidden: &[], sides };
    let Some(mut path) = coarse_to_fine(&coarse, search, &job.part(0.0, 0.4))? else {
        return Ok(None);
    };
    let back = |i: u32, thin: bool, last: usize| if thin { (2 * i as usize).min(last) as u32 } else { i };
    path.iter_mut().for_each(|[i, j]| (*i, *j) = (back(*i, thin[0], n), back(*j, thin[1], m)));
    search(rails, &Band::around(&path, n, m, WIDTH)?, &job.part(0.4, 1.0))
}

/// Every second point, and the last.
fn thinned(points: &[DVec3], thin: bool) -> Result<Vec<DVec3>> {
    if !thin {
        return alloc::copied(points);
    }
    let mut kept = alloc::with_capacity(points.len() / 2 + 1)?;
    kept.extend(points.iter().step_by(2));
    if points.len().is_multiple_of(2) {
        kept.extend(points.last());
    }
    Ok(kept)
}

/// The mean normals of every two edges.
fn thinned_sides(normals: &[DVec3], thin: bool) -> Result<Vec<DVec3>> {
    if !thin {
        return alloc::copied(normals);
    }
    alloc::collect(normals.chunks(2).map(|pair| pair.iter().sum::<DVec3>().normalize_or_zero()))
}
