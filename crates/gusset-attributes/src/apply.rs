//! Transfers a channel to a result.

use super::channel::{Channel, Rule};
use super::domain::Domain;
use super::origins::Origins;
use super::table::SourceTable;
use super::values::{Output, ValueType};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::select_by_rank;
use std::ops::Range;

const STAGE: &str = "carrying values over";
/// Number of elements that a thread processes in one task.
const ELEMENTS_PER_TASK: usize = 1 << 14;
/// Largest number of steps towards the mean of directions. Each step squares the error.
const MAX_SPHERICAL_MEAN_STEPS: usize = 16;
const MIN_STEP_RADIANS: f64 = 1e-15;

/// Transfers a channel: writes the values of each vertex, corner or face of the result.
///
/// An element with one source has the bits of its source. An element without sources, or whose
/// sources all lack the channel, has the value 0. O(elements and sources), on the job's threads.
/// Only [`Rule::Texture`] allocates memory, linear in the corners of new faces.
///
/// # Errors
/// [`Error::InputsDiffer`], [`Error::ValuesDiffer`], [`Error::BadValue`], [`Error::ArrayTooShort`]
/// if `out` is too small, [`Error::OptionOutOfRange`] if its values have another type or number of
/// components, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn carry_values_over(origins: &Origins, channel: &Channel<'_>, out: &mut Output<'_>, job: &Job<'_>) -> Result<()> {
    channel.check_inputs(origins.inputs(), &job.sub_job(0.0, 0.2))?;
    let table = origins.table(channel.domain);
    // The output must have the type and number of components of the channel.
    Error::require(
        out.value_type == channel.value_type && out.components == channel.components,
        "output",
        0.0,
        "of the channel's type and number of components",
    )?;
    let needed = (table.len() * out.stride).saturating_sub(out.stride - channel.bytes_per_value().min(out.stride));
    if out.bytes.len() < needed {
        return Err(Error::ArrayTooShort { what: "values", needed: needed as u64, given: out.bytes.len() as u64 });
    }
    let mixer = ValueMixer::new(origins, channel);
    let chunks = out
        .bytes
        .chunks_mut(ELEMENTS_PER_TASK * out.stride)
        .zip(par::split_into_ranges(table.len(), ELEMENTS_PER_TASK));
    let chunks = alloc::collect(chunks)?;
    let stride = out.stride;
    let done = par::map_cancellable(&job.sub_job(0.2, 0.9), STAGE, chunks.into_iter(), |(bytes, rows)| {
        mixer.mix_rows(rows, bytes, stride)
    })?;
    done.into_iter().collect::<Result<()>>()?;
    if channel.rule == Rule::Texture && channel.domain == Domain::Corners {
        origins.continuation.extend_charts(out, &job.sub_job(0.9, 1.0))?;
    }
    Ok(())
}

/// Mixes the values of sources.
struct ValueMixer<'a> {
    channel: &'a Channel<'a>,
    table: &'a SourceTable,
    turned_sources: Option<&'a BitSet>,
    /// The first source of each input, then the number of all sources.
    first_sources: &'a [u32],
}

impl<'a> ValueMixer<'a> {
    fn new(origins: &'a Origins, channel: &'a Channel<'a>) -> Self {
        let turned = origins.turned_sources.as_ref().map(|sets| &sets[channel.domain as usize]);
        let turned = turned.filter(|_| channel.rule == Rule::Normal);
        ValueMixer {
            channel,
            table: origins.table(channel.domain),
            turned_sources: turned,
            first_sources: origins.first_sources_of_inputs(channel.domain),
        }
    }

    /// The values of a source, if its input has the channel.
    #[inline]
    fn values_of_source(&self, source: u32) -> Option<&'a [u8]> {
        let input = match self.first_sources.len() {
            2 => 0,
            3 => usize::from(source >= self.first_sources[1]),
            _ => self.first_sources.partition_point(|&start| start <= source) - 1,
        };
        let values = self.channel.inputs[input].as_ref()?;
        Some(values.bytes((source - self.first_sources[input]) as usize))
    }

    fn mix_rows(&self, rows: Range<usize>, out: &mut [u8], stride: usize) -> Result<()> {
        // Copies of constant size are faster.
        match self.channel.bytes_per_value() {
            1 => self.mix_rows_of_size::<1>(rows, out, stride),
            2 => self.mix_rows_of_size::<2>(rows, out, stride),
            3 => self.mix_rows_of_size::<3>(rows, out, stride),
            4 => self.mix_rows_of_size::<4>(rows, out, stride),
            8 => self.mix_rows_of_size::<8>(rows, out, stride),
            12 => self.mix_rows_of_size::<12>(rows, out, stride),
            16 => self.mix_rows_of_size::<16>(rows, out, stride),
            24 => self.mix_rows_of_size::<24>(rows, out, stride),
            _ => self.mix_rows_of_size::<0>(rows, out, stride),
        }
    }

    /// Mixes rows whose values have `SIZE` bytes, or any number if `SIZE` is 0.
    fn mix_rows_of_size<const SIZE: usize>(&self, rows: Range<usize>, out: &mut [u8], stride: usize) -> Result<()> {
        let size = if SIZE == 0 { self.channel.bytes_per_value() } else { SIZE };
        let components = self.channel.components;
        let mut mean = alloc::filled(0.0, components)?;
        let mut order = alloc::filled(0, if self.channel.rule == Rule::SkinWeights { components } else { 0 })?;
        for (k, out) in rows.zip(out.chunks_mut(stride)) {
            let out = &mut out[..size];
            let (sources, weights) = self.table.row(k);
            match sources {
                &[source] if self.turned_sources.is_none_or(|turned| !turned.contains(source)) => {
                    match self.values_of_source(source) {
                        Some(values) => out.copy_from_slice(&values[..size]),
                        None => out.fill(0),
                    }
                }
                _ => self.mix_sources((sources, weights), &mut mean, &mut order, out),
            }
        }
        Ok(())
    }

    /// Mixes the values of an element with several sources.
    fn mix_sources(&self, (sources, weights): (&[u32], &[f64]), mean: &mut [f64], order: &mut [u32], out: &mut [u8]) {
        let entries = || sources.iter().zip(weights).filter_map(|(&s, &w)| Some((s, self.values_of_source(s)?, w)));
        let value_type = self.channel.value_type;
        let Some((_, first, _)) = entries().next() else {
            return out.fill(0);
        };
        match self.channel.rule {
            Rule::Nearest => {
                let heavier =
                    |best: (&'a [u8], f64), (_, values, weight)| if weight > best.1 { (values, weight) } else { best };
                return out.copy_from_slice(entries().fold((first, f64::NEG_INFINITY), heavier).0);
            }
            Rule::Normal => {
                let normal = |&(source, values, weight): &(u32, &[u8], f64)| {
                    let sign =
                        if self.turned_sources.is_some_and(|turned| turned.contains(source)) { -1.0 } else { 1.0 };
                    (sign * read_vector(value_type, values), weight)
                };
                let mut all = entries();
                if let (Some(only), None) = (all.next(), all.next()) {
                    // A single source keeps its values, apart from the turn.
                    normal(&only).0.to_array().iter().zip(mean.iter_mut()).for_each(|(x, mean)| *mean = *x);
                } else {
                    let mean_normal = spherical_mean(|| entries().map(|entry| normal(&entry)));
                    mean.copy_from_slice(&mean_normal.to_array());
                }
            }
            Rule::Linear | Rule::SkinWeights | Rule::Texture => {
                let total: f64 = entries().map(|(.., weight)| weight).sum();
                // Relative to the first value, so that equal values stay unchanged.
                let size = value_type.size();
                for (c, mean) in mean.iter_mut().enumerate() {
                    let at = |values: &[u8]| value_type.read(&values[c * size..]);
                    let base = at(first);
                    let off: f64 = entries().map(|(_, values, weight)| weight / total * (at(values) - base)).sum();
                    *mean = if total > 0.0 { base + off } else { base };
                    if !mean.is_finite() {
                        // The differences overflow, but the mean does not.
                        *mean = entries().map(|(_, values, weight)| weight / total * at(values)).sum();
                    }
                }
                if self.channel.rule == Rule::SkinWeights {
                    self.keep_largest_shares(mean, order);
                }
            }
        }
        let size = value_type.size();
        mean.iter().zip(out.chunks_exact_mut(size)).for_each(|(&mean, out)| value_type.write(mean, out));
    }

    /// Keeps the largest shares, the first of equal ones, and scales them to the sum that the type
    /// requires.
    fn keep_largest_shares(&self, shares: &mut [f64], order: &mut [u32]) {
        order.iter_mut().zip(0..).for_each(|(k, place)| *k = place);
        let most = self.channel.max_influences;
        if most > 0 && most < shares.len() {
            select_by_rank(order, most, |k| -shares[k as usize]);
            order[most..].iter().for_each(|&k| shares[k as usize] = 0.0);
        }
        let total: f64 = shares.iter().sum();
        if total <= 0.0 {
            return;
        }
        let Some(whole) = self.channel.value_type.largest_value() else {
            return shares.iter_mut().for_each(|share| *share /= total);
        };
        shares.iter_mut().for_each(|share| *share *= whole / total);
        // The remainder of rounding down goes to the shares that lost most.
        let lost = whole - shares.iter().map(|share| share.floor()).sum::<f64>();
        let lost = (lost.max(0.0) as usize).min(shares.len());
        if lost > 0 && lost < shares.len() {
            select_by_rank(order, lost, |k| shares[k as usize].floor() - shares[k as usize]);
        }
        order[..lost].iter().for_each(|&k| shares[k as usize] = shares[k as usize].floor() + 1.0);
        order[lost..].iter().for_each(|&k| shares[k as usize] = shares[k as usize].floor());
    }
}

fn read_vector(value_type: ValueType, values: &[u8]) -> DVec3 {
    let size = value_type.size();
    DVec3::new(value_type.read(values), value_type.read(&values[size..]), value_type.read(&values[2 * size..]))
}

/// Normalises a vector of any length; zero stays zero.
fn normalise_or_zero(v: DVec3) -> DVec3 {
    let size = v.abs().max_element();
    if size > 0.0 { (v / size).normalize() } else { DVec3::ZERO }
}

/// The weighted mean of directions on the sphere. It has length 1, unless all directions are zero.
fn spherical_mean<I: Iterator<Item = (DVec3, f64)>>(entries: impl Fn() -> I) -> DVec3 {
    let units = || entries().map(|(direction, weight)| (normalise_or_zero(direction), weight));
    let heaviest = units().fold((DVec3::ZERO, f64::NEG_INFINITY), |best, one| if one.1 > best.1 { one } else { best });
    let mut mean = units().map(|(direction, weight)| direction * weight).sum::<DVec3>().normalize_or_zero();
    if mean == DVec3::ZERO {
        return heaviest.0;
    }
    let total: f64 = units().map(|(_, weight)| weight).sum();
    for _ in 0..MAX_SPHERICAL_MEAN_STEPS {
        // Moves to the weighted mean of the directions in the tangent plane at the current mean, by
        // angles.
        let step = units().map(|(direction, weight)| {
            let off = direction - mean * direction.dot(mean);
            off.normalize_or_zero() * (libm::atan2(off.length(), direction.dot(mean)) * weight / total)
        });
        let step: DVec3 = step.sum();
        let angle = step.length();
        if angle <= MIN_STEP_RADIANS {
            break;
        }
        let (sine, cosine) = libm::sincos(angle);
        mean = (mean * cosine + step * (sine / angle)).normalize();
    }
    mean
}
