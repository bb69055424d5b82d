//! Extent of a stitch: whole loops, or their facing arcs.

use super::facing::{self, Arc, Planes, facing_in_unit, round_off, squareness};
use super::stitch_rim::Rim;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// How much of the loops is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// All of them, by a closed band.
    #[default]
    WholeLoops,
    /// The runs of vertices that face the other loop, as the paper has it (see
    /// [`facing`](super::facing)).
    OpenArcs,
    /// Whole loops if the loops face each other squarely, or if the planes cannot decide; else open
    /// arcs.
    Auto,
    /// The arcs given: on each loop the first place, and the number of vertices.
    Arcs([Arc; 2]),
}

/// Loops are joined whole if the mean |cosine| of the angles between their normals and the line of
/// their centres exceeds this: angles below 60 degrees.
const MIN_WHOLE_COSINE: f64 = 0.5;

/// The arcs that `extent` says, or `None` for whole loops. The rims are in a unit in which
/// coordinates are at most 2; so is the tolerance in `options`, `None` being the round-off of such
/// coordinates.
pub(super) fn arcs(
    a: &Rim,
    b: &Rim,
    extent: Extent,
    options: &facing::Options,
    scalar: Scalar,
    job: &Job<'_>,
) -> Result<Option<[Arc; 2]>> {
    let tolerance = options.tolerance.unwrap_or(2.0 * round_off(scalar));
    let planes = Planes::of(&a.points, &b.points, options.centres);
    let found = || {
        let found = facing_in_unit(&a.points, &b.points, planes, tolerance, options.run, job)?;
        Ok(Some(found.taken))
    };
    match extent {
        Extent::WholeLoops => Ok(None),
        Extent::OpenArcs => found(),
        Extent::Auto => {
            if squareness(&a.points, &planes) + squareness(&b.points, &planes) > 2.0 * MIN_WHOLE_COSINE {
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
                Error::require(arc.first < n, option, arc.first as f64)?;
                Error::require((1..=n).contains(&arc.count), option, arc.count as f64)?;
            }
            Ok(Some(arcs))
        }
    }
}
