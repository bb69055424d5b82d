//! What can be trusted: pairs that fit, and the pieces that hang together by them.

use super::align_request::{Overlap, Reason};
use super::freedom::holds;
use super::member::Member;
use super::sample_pairs::Found;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Points within so many spacings of a piece are near it, and those within one on it.
pub(super) const NEAR: f64 = 8.0;
pub(super) const ON: f64 = 1.0;
/// Fewer points that lie on the other piece are no overlap.
const MIN_COUNT: usize = 30;
/// At least this share of the points near a piece lies on it.
const MIN_FIT: f64 = 2.0 / 3.0;
/// Less holds no piece, whatever the noise of normals: the square of half a degree's sine.
const MIN_HOLD: f64 = 7.6e-5;
/// More than this of what holds a piece may not be noise.
const MAX_NOISE: f64 = 0.5;
/// Pieces that are so many times as large or small as the first are in other units.
const OTHER_SIZE: f64 = 50.0;

/// Whether a piece is trusted, and how well it is held.
pub(super) type Verdict = (Reason, f64);

/// The overlaps, and for each piece what is known and how it is held.
pub(super) fn judge(
    members: &[Member<'_>],
    found: &[([usize; 2], Found)],
    unit: f64,
) -> Result<(Vec<Overlap>, Vec<Verdict>)> {
    let mut overlaps: Vec<Overlap> = Vec::new();
    let mut opposite = alloc::filled([0usize; 2], members.len())?;
    for ([i, k], one) in found.iter().filter(|([i, k], _)| i < k) {
        let back = found.binary_search_by_key(&[*k, *i], |(pair, _)| *pair).ok().map(|at| &found[at].1);
        let ways = [Some(one), back];
        let sum = |of: &dyn Fn(&Found) -> f64| ways.iter().flatten().map(|found| of(found)).sum::<f64>();
        let on = sum(&|f| f.on as f64);
        let near = sum(&|f| f.near as f64);
        for piece in [*i, *k] {
            opposite[piece][0] += sum(&|f| f.opposite as f64) as usize;
            opposite[piece][1] += near as usize;
        }
        if on == 0.0 {
            continue;
        }
        let share = |found: Option<&Found>| found.map_or(0.0, |f| f.on as f64 / f.samples.max(1) as f64);
        let fit = on / near.max(1.0);
        alloc::push(
            &mut overlaps,
            Overlap {
                pieces: [*i as u32, *k as u32],
                shares: ways.map(share),
                count: on as u32,
                mean: unit * sum(&|f| f.on as f64 * f.mean) / on,
                rms: unit * (sum(&|f| f.on as f64 * f.square) / on).sqrt(),
                fit,
                trusted: on as usize >= MIN_COUNT && fit >= MIN_FIT,
            },
        )?;
    }
    let holds = holds(members.len(), found)?;
    let size = |k: usize| members[k].scan.bounds.diagonal();
    let mut reasons = alloc::with_capacity(members.len())?;
    for k in 0..members.len() {
        let own = || overlaps.iter().filter(|overlap| overlap.pieces.contains(&(k as u32)));
        let hold = holds[k];
        let [against, with] = opposite[k];
        let ratio = size(k).max(f64::MIN_POSITIVE) / size(0).max(f64::MIN_POSITIVE);
        let reason = if k == 0 && !members[0].scan.used.is_empty() {
            Reason::Trusted
        } else if against > MIN_COUNT && against > 2 * with {
            Reason::FacesOtherWay
        } else if own().all(|overlap| (overlap.count as usize) < MIN_COUNT) {
            if (1.0 / OTHER_SIZE..=OTHER_SIZE).contains(&ratio) || members[k].scan.used.is_empty() {
                Reason::NoOverlap
            } else {
                Reason::OtherSize
            }
        } else if own().all(|overlap| !overlap.trusted) {
            Reason::PoorFit
        } else if hold.least < MIN_HOLD || hold.noise > MAX_NOISE * hold.least {
            Reason::Undetermined
        } else {
            Reason::TrustedByNone
        };
        reasons.push((reason, if k == 0 { 1.0 } else { hold.least.sqrt().min(1.0) }));
    }
    // Trust spreads from the first piece along pairs that fit.
    let mut spreads = true;
    while spreads {
        spreads = false;
        for overlap in overlaps.iter().filter(|overlap| overlap.trusted) {
            let [i, k] = overlap.pieces.map(|piece| piece as usize);
            for (from, to) in [(i, k), (k, i)] {
                if reasons[from].0 == Reason::Trusted && reasons[to].0 == Reason::TrustedByNone {
                    reasons[to].0 = Reason::Trusted;
                    spreads = true;
                }
            }
        }
    }
    Ok((overlaps, reasons))
}
