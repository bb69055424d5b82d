//! Rounds of an iteration: points that do not converge in a round fall back, and the others
//! continue.

use crate::identify::identify_options::JointParameter;
use crate::identify::subcurve::Subcurve;

/// The rounds in which individual points fall back, before all points do.
pub(super) const MAX_FALLBACK_ROUNDS: u32 = 3;

/// Returns the number of iterations that a round of a lock may take:
/// [`Options::max_sweeps`](super::super::Options), and half as many in each further round. Before
/// continuous curvature, which iterates itself, a quarter of these.
pub(super) fn max_iterations_of_round(sub: &Subcurve<'_>, round: u32) -> u32 {
    let halvings = round + if sub.options.joint == JointParameter::G2 { 2 } else { 0 };
    (sub.options.max_sweeps >> halvings).max(1)
}
