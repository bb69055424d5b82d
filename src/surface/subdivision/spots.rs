//! What could not be resolved: parts of a parameter space that touch are one spot.

use glam::DVec3;

/// A part in which something may be. Of a patch only, z is 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Open {
    /// Its middle.
    pub(crate) middle: DVec3,
    /// Half its sides.
    pub(crate) half: DVec3,
    /// What is to be 0, in the middle: the less, the likelier.
    pub(crate) value: f64,
}

/// A spot: the box of its parts, and the likeliest place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot {
    /// The middle of the part of least value.
    pub(crate) place: DVec3,
    /// The least parameters of its parts.
    pub(crate) low: DVec3,
    /// The greatest.
    pub(crate) high: DVec3,
}

/// Adds the spots that the parts make. O(parts^2).
pub(crate) fn add_spots(open: &[Open], spots: &mut Vec<Spot>) {
    let mut spot_of: Vec<usize> = (0..open.len()).collect();
    for (i, part) in open.iter().enumerate() {
        for (j, other) in open[..i].iter().enumerate() {
            let gap = (part.middle - other.middle).abs() - 1.000_001 * (part.half + other.half);
            if gap.max_element() <= 0.0 && spot_of[i] != spot_of[j] {
                let (from, to) = (spot_of[i].max(spot_of[j]), spot_of[i].min(spot_of[j]));
                spot_of[..=i].iter_mut().for_each(|spot| *spot = if *spot == from { to } else { *spot });
            }
        }
    }
    for spot in (0..open.len()).filter(|&spot| spot_of[spot] == spot) {
        let members = || open.iter().zip(&spot_of).filter(|&(_, &of)| of == spot).map(|(part, _)| part);
        let best = members().fold(&open[spot], |best, part| if part.value < best.value { part } else { best });
        let low = members().map(|part| part.middle - part.half).fold(DVec3::INFINITY, DVec3::min);
        let high = members().map(|part| part.middle + part.half).fold(DVec3::NEG_INFINITY, DVec3::max);
        spots.push(Spot { place: best.middle, low, high });
    }
}
