//! Rounds of an iteration: points that do not converge in a round fall back, and the others
//! continue.

use crate::identify::identify_options::JointParameter;
use crate::identify::report::ReportInProgress;
use crate::identify::subcurve::Subcurve;

/// The rounds in which individual points fall back, before all points do.
pub(super) const MAX_FALLBACK_ROUNDS: u32 = 3;

/// Returns the number of iterations that a round of a lock may take: half of the rest of
/// [`Options::max_sweeps`](super::super::Options), in the last round all of it. Continuous
/// curvature reserves half for itself.
pub(super) fn max_iterations_of_round(sub: &Subcurve<'_>, report: &ReportInProgress, round: u32) -> u32 {
    let all = match sub.options.joint {
        JointParameter::G2 => sub.options.max_sweeps.div_ceil(2),
        _ => sub.options.max_sweeps,
    };
    let left = all.saturating_sub(report.iterations);
    if round < MAX_FALLBACK_ROUNDS { left.div_ceil(2) } else { left }
}
