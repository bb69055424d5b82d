//! The extent of a stitch: whole loops, or their facing arcs.

use super::facing::{self, Arc, Planes, find_facing_scaled, relative_round_off, squareness};
use super::stitch_rim::Rim;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// Which part of the loops is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// The whole loops, by a closed band.
    #[default]
    WholeLoops,
    /// The runs of vertices that face the other loop, as in the paper; see
    /// [`super::facing`].
    OpenArcs,
    /// Whole loops if the loops face each other squarely, or if the planes are undecided; open arcs
    /// otherwise.
    Auto,
    /// The given arcs: on each loop the first place, and the number of vertices.
    Arcs([Arc; 2]),
}

/// Loops are joined whole if the mean |cosine| of the angles between their normals and the line of
/// centres exceeds this: angles below 60 degrees.
const MIN_MEAN_COSINE_FOR_WHOLE_LOOPS: f64 = 0.5;

/// Returns the arcs that `extent` selects, or `None` for whole loops. The coordinates of the rims
/// are at most 2. The tolerance in `options` has the same unit; `None` means the round-off of such
/// coordinates.
pub(super) fn select_arcs(
    a: &Rim,
    b: &Rim,
    extent: Extent,
    options: &facing::Options,
    scalar: Scalar,
    job: &Job<'_>,
) -> Result<Option<[Arc; 2]>> {
    let tolerance = options.tolerance.unwrap_or(2.0 * relative_round_off(scalar));
    let planes = Planes::new(&a.points, &b.points, options.centres);
    let found = || {
        let found = find_facing_scaled(&a.points, &b.points, planes, tolerance, options.run, job)?;
        Ok(Some(found.taken))
    };
    match extent {
        Extent::WholeLoops => Ok(None),
        Extent::OpenArcs => found(),
        Extent::Auto => {
            if squareness(&a.points, &planes) + squareness(&b.points, &planes) > 2.0 * MIN_MEAN_COSINE_FOR_WHOLE_LOOPS {
                return Ok(None);
            }
            match found() {
                Err(Error::PlanesUndecided { .. }) => Ok(None),
                other => other,
            }
        }
        Extent::Arcs(arcs) => {
            for (arc, rim, option) in [(arcs[0], a, "arc_a"), (arcs[1], b, "arc_b")] {
                let n = rim.vertices.len();
                Error::require(arc.first < n, option, arc.first as f64, Allowed::IndexBelow(n as u64))?;
                Error::require((1..=n).contains(&arc.count), option, arc.count as f64, 1.0..=n as f64)?;
            }
            Ok(Some(arcs))
        }
    }
}
