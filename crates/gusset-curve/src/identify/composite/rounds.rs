//! Rounds of an iteration: whatever does not converge in one falls back, and the others go on.

use crate::identify::identify_options::JointParameter;
use crate::identify::report::Account;
use crate::identify::subcurve::Subcurve;

/// Rounds in which points that do not converge fall back, before all do.
pub(super) const MAX_FALLBACK_ROUNDS: u32 = 3;

/// The iterations that a round of a lock may take: half of what is left of
/// [`Options::max_sweeps`](super::super::Options), the last round all of it. Continuous curvature
/// needs a half of its own.
pub(super) fn max_iterations(sub: &Subcurve<'_>, report: &Account, round: u32) -> u32 {
    let all = match sub.options.joint {
        JointParameter::G2 => sub.options.max_sweeps.div_ceil(2),
        _ => sub.options.max_sweeps,
    };
    let left = all.saturating_sub(report.iterations);
    if round < MAX_FALLBACK_ROUNDS { left.div_ceil(2) } else { left }
}
