//! Matches: samples of two pieces with similar features.

use super::surface_features::{SurfaceFeature, feature_distance_squared};
use super::surface_samples::STAGE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// Number of most similar samples that each sample is matched with.
const MATCHES_PER_SAMPLE: usize = 2;
/// Largest number of matches between two pieces.
const MAX_MATCHES: usize = 2000;
/// Number of samples between two progress reports.
const SAMPLES_PER_REPORT: usize = 1 << 5;

/// A sample of the first piece, and a sample of the second.
pub(super) type Match = [u32; 2];

/// The most similar samples of one sample, the most similar first.
type Similar = [(f32, u32); MATCHES_PER_SAMPLE];

/// Returns the matches of two pieces by each of their lists of features, at most 2,000. Matches
/// that both samples choose come first. O(samples^2).
pub(super) fn match_features(features: [&[Vec<SurfaceFeature>]; 2], job: &Job<'_>) -> Result<Vec<Match>> {
    let mut ranked: Vec<(usize, Match)> = Vec::new();
    for (scale, (own, theirs)) in features[0].iter().zip(features[1]).enumerate() {
        let job = job.sub_job_of_item(scale, features[0].len());
        let ahead = find_most_similar(own, theirs, &job.sub_job(0.0, 0.5))?;
        let back = find_most_similar(theirs, own, &job.sub_job(0.5, 1.0))?;
        let rank_in = |table: &[Similar], i: usize, k: u32| {
            table[i].iter().position(|(_, other)| *other == k).unwrap_or(2 * MATCHES_PER_SAMPLE)
        };
        for (i, similar) in ahead.iter().enumerate() {
            for (rank, &(_, k)) in similar.iter().enumerate().filter(|(_, (_, k))| *k != NONE) {
                alloc::push(&mut ranked, (rank + rank_in(&back, k as usize, i as u32), [i as u32, k]))?;
            }
        }
        for (k, similar) in back.iter().enumerate() {
            for (rank, &(_, i)) in similar.iter().enumerate().filter(|(_, (_, i))| *i != NONE) {
                alloc::push(&mut ranked, (rank + rank_in(&ahead, i as usize, k as u32), [i, k as u32]))?;
            }
        }
    }
    // Keeps the best rank of a match.
    ranked.sort_unstable_by_key(|&(rank, pair)| (pair, rank));
    ranked.dedup_by_key(|(_, pair)| *pair);
    // Spreads the matches of one rank evenly over the samples.
    let spread = |[i, k]: Match| (i.wrapping_mul(0x9E37_79B1) ^ k.wrapping_mul(0x85EB_CA77)).wrapping_mul(0xC2B2_AE3D);
    ranked.sort_unstable_by_key(|&(rank, pair)| (rank, spread(pair), pair));
    ranked.truncate(MAX_MATCHES);
    alloc::collect(ranked.into_iter().map(|(_, pair)| pair))
}

/// Returns for each feature the most similar of the others.
fn find_most_similar(own: &[SurfaceFeature], theirs: &[SurfaceFeature], job: &Job<'_>) -> Result<Vec<Similar>> {
    let mut found = alloc::filled([(f32::INFINITY, NONE); MATCHES_PER_SAMPLE], own.len())?;
    let is_empty = |feature: &SurfaceFeature| feature.iter().all(|&x| x == 0.0);
    let is_missing = alloc::collect(theirs.iter().map(is_empty))?;
    for (i, (feature, best)) in own.iter().zip(&mut found).enumerate() {
        job.step_every(SAMPLES_PER_REPORT, i, own.len(), STAGE)?;
        if is_empty(feature) {
            continue;
        }
        for (k, other) in theirs.iter().enumerate() {
            let distance = feature_distance_squared(feature, other);
            if distance < best[MATCHES_PER_SAMPLE - 1].0 && !is_missing[k] {
                best[MATCHES_PER_SAMPLE - 1] = (distance, k as u32);
                best.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
            }
        }
    }
    Ok(found)
}
