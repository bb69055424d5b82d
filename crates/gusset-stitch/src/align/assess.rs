//! The assessment: pairs that fit, and the pieces that are connected by them.

use super::align_request::{Overlap, Reason};
use super::hold_stiffness::measure_hold_stiffness;
use super::sample_pairs::SamplePairReport;
use super::sampled_piece::SampledPiece;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Points are near a piece within this number of spacings, ...
pub(super) const MAX_NEAR_SPACINGS: f64 = 8.0;
/// ... and on it within this number.
pub(super) const MAX_ON_SURFACE_SPACINGS: f64 = 1.0;
/// Smallest number of points on the other piece that make an overlap.
const MIN_OVERLAP_POINTS: usize = 30;
/// Smallest share of the points near a piece that must lie on it.
const MIN_FITTING_SHARE: f64 = 2.0 / 3.0;
/// Smallest stiffness that holds a piece, for any noise of the normals: the square of half a
/// degree's sine.
const MIN_HOLD_STIFFNESS: f64 = 7.6e-5;
/// Largest part of the stiffness that may be noise.
const MAX_NOISE_SHARE_OF_STIFFNESS: f64 = 0.5;
/// If a piece without overlaps differs from the first piece by more than this factor in size, it
/// probably uses another unit of length.
const MIN_OTHER_UNIT_SIZE_RATIO: f64 = 50.0;

/// The reason, and the stiffness with which a piece is held.
pub(super) type PieceVerdict = (Reason, f64);

/// Returns the overlaps, and for each piece the reason and the stiffness.
pub(super) fn assess_alignment(
    sampled_pieces: &[SampledPiece<'_>],
    reports: &[([usize; 2], SamplePairReport)],
    unit: f64,
) -> Result<(Vec<Overlap>, Vec<PieceVerdict>)> {
    let mut overlaps: Vec<Overlap> = Vec::new();
    let mut opposite = alloc::filled([0usize; 2], sampled_pieces.len())?;
    for ([i, k], one) in reports.iter().filter(|([i, k], _)| i < k) {
        let back = reports.binary_search_by_key(&[*k, *i], |(pair, _)| *pair).ok().map(|at| &reports[at].1);
        let ways = [Some(one), back];
        let sum = |of: &dyn Fn(&SamplePairReport) -> f64| ways.iter().flatten().map(|report| of(report)).sum::<f64>();
        let on = sum(&|f| f.samples_on_surface as f64);
        let near = sum(&|f| f.near_samples as f64);
        for piece in [*i, *k] {
            opposite[piece][0] += sum(&|f| f.opposite_samples as f64) as usize;
            opposite[piece][1] += near as usize;
        }
        if on == 0.0 {
            continue;
        }
        let share = |report: Option<&SamplePairReport>| {
            report.map_or(0.0, |f| f.samples_on_surface as f64 / f.samples.max(1) as f64)
        };
        let fit = on / near.max(1.0);
        alloc::push(
            &mut overlaps,
            Overlap {
                pieces: [*i as u32, *k as u32],
                shares: ways.map(share),
                count: on as u32,
                mean: unit * sum(&|f| f.samples_on_surface as f64 * f.mean_distance) / on,
                rms: unit * (sum(&|f| f.samples_on_surface as f64 * f.mean_squared_distance) / on).sqrt(),
                fit,
                trusted: on as usize >= MIN_OVERLAP_POINTS && fit >= MIN_FITTING_SHARE,
            },
        )?;
    }
    let holds = measure_hold_stiffness(sampled_pieces.len(), reports)?;
    let size = |k: usize| sampled_pieces[k].scan.bounds.diagonal();
    let mut reasons = alloc::with_capacity(sampled_pieces.len())?;
    for k in 0..sampled_pieces.len() {
        let own = || overlaps.iter().filter(|overlap| overlap.pieces.contains(&(k as u32)));
        let hold = holds[k];
        let [against, with] = opposite[k];
        let ratio = size(k).max(f64::MIN_POSITIVE) / size(0).max(f64::MIN_POSITIVE);
        let reason = if k == 0 && !sampled_pieces[0].scan.vertices_with_normal.is_empty() {
            Reason::Trusted
        } else if against > MIN_OVERLAP_POINTS && against > 2 * with {
            Reason::FacesOtherWay
        } else if own().all(|overlap| (overlap.count as usize) < MIN_OVERLAP_POINTS) {
            if (1.0 / MIN_OTHER_UNIT_SIZE_RATIO..=MIN_OTHER_UNIT_SIZE_RATIO).contains(&ratio)
                || sampled_pieces[k].scan.vertices_with_normal.is_empty()
            {
                Reason::NoOverlap
            } else {
                Reason::OtherSize
            }
        } else if own().all(|overlap| !overlap.trusted) {
            Reason::PoorFit
        } else if hold.least_eigenvalue < MIN_HOLD_STIFFNESS
            || hold.eigenvalue_part_by_noise > MAX_NOISE_SHARE_OF_STIFFNESS * hold.least_eigenvalue
        {
            Reason::Undetermined
        } else {
            Reason::TrustedByNone
        };
        reasons.push((reason, if k == 0 { 1.0 } else { hold.least_eigenvalue.sqrt().min(1.0) }));
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
