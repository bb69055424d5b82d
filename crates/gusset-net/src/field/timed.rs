//! Keyframe animation: the strength of a field as a function of time. O(log keys).

use super::space_map::check_parameters_finite;
use gusset_base::error::{Error, Result};

/// The interpolation of strengths between two times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Easing {
    /// Linear in time.
    #[default]
    Linear,
    /// The smoothstep 3 t^2 - 2 t^3, at rest at both ends.
    Smooth,
    /// Constant up to the next time.
    Hold,
}

/// A strength given at times and interpolated between them; constant before the first time and
/// after the last.
///
/// For each frame, [`deform`](super::deform) a copy of the net at rest with the strength of its
/// time.
#[derive(Debug, Clone, Copy)]
pub struct TimedStrength<'a> {
    keys: &'a [[f64; 2]],
    easing: Easing,
}

impl<'a> TimedStrength<'a> {
    /// Creates a strength from `keys`, pairs of time and strength. There must be at least one key,
    /// and times must increase.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub fn new(keys: &'a [[f64; 2]], easing: Easing) -> Result<Self> {
        keys.iter()
            .try_for_each(|&[time, strength]| check_parameters_finite(&[("time", time), ("strength", strength)]))?;
        keys.windows(2).try_for_each(|pair| {
            Error::require(pair[0][0] < pair[1][0], "time", pair[1][0], "later than the previous time")
        })?;
        Error::require(!keys.is_empty(), "keys", 0.0, "at least 1")?;
        Ok(TimedStrength { keys, easing })
    }

    /// Returns the strength at a time. At a key's own time it is exactly the key's. O(log keys).
    pub fn strength_at(&self, time: f64) -> f64 {
        let after = self.keys.partition_point(|key| key[0] <= time);
        let before = self.keys[after.max(1) - 1];
        match self.keys.get(after) {
            Some(next) if after > 0 => {
                let t = (time - before[0]) / (next[0] - before[0]);
                let eased = match self.easing {
                    Easing::Linear => t,
                    Easing::Smooth => t * t * (3.0 - 2.0 * t),
                    Easing::Hold => 0.0,
                };
                before[1] + eased * (next[1] - before[1])
            }
            _ => before[1],
        }
    }
}
