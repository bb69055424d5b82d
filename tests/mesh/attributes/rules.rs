//! The rules that average values, and refused channels.

use super::carried;
use super::fields::{cases, job, stitched};
use crate::common::{Soup, cap, sheet};
use glam::DVec3;
use gusset::assemble::{self, assemble};
use gusset::attributes::{Channel, Domain, Origins, Output, Rule, ValueType, carry_values_over};
use gusset::error::Element;
use gusset::repair::weld;
use gusset::stitch::{Options, Rows};
use gusset::{Error, Job};

/// Two caps and three rows between them.
fn caps() -> super::Case {
    let (top, bottom) = (cap(24, 5, 0.3, 1.0), cap(17, 4, 0.3, -1.0));
    stitched("rows", &top, Some(&bottom), &Options { rows: Rows::Count(3), ..Options::default() })
}

fn applied<T: bytemuck::Pod>(origins: &Origins, channel: &Channel<'_>, components: usize) -> Result<Vec<T>, Error> {
    let count = origins.table(Domain::Vertices).len();
    let mut out = vec![T::zeroed(); count * components];
    carry_values_over(
        origins,
        channel,
        &mut Output::new(bytemuck::cast_slice_mut(&mut out), 0, count, channel.value_type_and_components())?,
        &job(),
    )?;
    Ok(out)
}

#[test]
fn normals_have_length_one_and_turn_with_faces() {
    for case in cases() {
        let normals = |soup: &crate::common::Soup| {
            let of = |p: &[f64; 3]| DVec3::new(p[0] + 0.3, 1.0 + p[1], p[2] - 2.0).normalize().to_array();
            soup.points.iter().flat_map(of).collect::<Vec<_>>()
        };
        let inputs: Vec<_> = case.pieces.iter().map(normals).collect();
        let found = carried(&case.origins, Domain::Vertices, Rule::Normal, 3, &inputs);
        assert!(found.chunks_exact(3).all(|n| (DVec3::from_slice(n).length() - 1.0).abs() < 1e-12), "{}", case.name);
    }
    let (top, bottom) = (cap(24, 5, 0.3, 1.0), cap(17, 4, 0.3, -1.0).turned());
    let case = stitched("turned", &top, Some(&bottom), &Options::default());
    // Inwards on the piece that is inside out, which is turned over.
    let inputs = [&top, &bottom].map(|soup| soup.points.iter().flatten().copied().collect::<Vec<_>>());
    let inputs = [inputs[0].clone(), inputs[1].iter().map(|x| -x).collect()];
    let found = carried(&case.origins, Domain::Vertices, Rule::Normal, 3, &inputs);
    let outwards = |(n, v): (&[f64], u32)| DVec3::from_slice(n).dot(case.at(v)) > 0.9;
    assert!(found.chunks_exact(3).zip(0..).all(outwards));
    // Other rules do not turn.
    let plain = carried(&case.origins, Domain::Vertices, Rule::Linear, 3, &inputs);
    assert_eq!(plain[3 * top.points.len()..][..inputs[1].len()], inputs[1]);
}

#[test]
fn the_mean_of_two_normals_is_on_the_great_circle() {
    let case = caps();
    let (a, b) = (DVec3::X, DVec3::new(-0.6, 0.8, 0.0));
    let inputs = [a, b].map(|n| n.to_array()).into_iter().zip(&case.pieces);
    let inputs: Vec<_> = inputs.map(|(n, piece)| n.repeat(piece.points.len())).collect();
    let found = carried(&case.origins, Domain::Vertices, Rule::Normal, 3, &inputs);
    let table = case.origins.table(Domain::Vertices);
    for (k, n) in found.chunks_exact(3).enumerate().skip(case.pieces.iter().map(|piece| piece.points.len()).sum()) {
        let (_, weights) = table.row(k);
        let angle = a.angle_between(b) * weights[1];
        assert!((DVec3::from_slice(n).angle_between(a) - angle).abs() < 1e-7, "{k}");
    }
}

#[test]
fn skin_weights_are_few_and_have_the_sum_1() {
    let case = caps();
    // Each piece has other bones.
    let share = |k: usize, v: usize| ((v * 7 + k * 3) % 11) as f64 / 11.0 + 0.01;
    let row = |piece: usize, v: usize| {
        let mut row = [0.0; 8];
        (0..4).for_each(|k| row[4 * piece + k] = share(k, v));
        let sum: f64 = row.iter().sum();
        row.map(|share| share / sum)
    };
    let inputs: Vec<Vec<f64>> =
        (0..2).map(|piece| (0..case.pieces[piece].points.len()).flat_map(|v| row(piece, v)).collect()).collect();
    let mut channel =
        Channel::new(Domain::Vertices, ValueType::F64, 8, Rule::SkinWeights).unwrap().with_max_influences(3);
    inputs.iter().for_each(|input| channel.push(bytemuck::cast_slice(input), 0, input.len() / 8).unwrap());
    let found: Vec<f64> = applied(&case.origins, &channel, 8).unwrap();
    let old: usize = case.pieces.iter().map(|piece| piece.points.len()).sum();
    assert_eq!(found[..8 * old], inputs.concat());
    for (k, row) in found.chunks_exact(8).enumerate().skip(old) {
        assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        let kept: Vec<_> = (0..8).filter(|&c| row[c] > 0.0).collect();
        assert!(kept.len() <= 3 && !kept.is_empty());
        // The largest of the mean, in its proportions.
        let (sources, weights) = case.origins.table(Domain::Vertices).row(k);
        let all = inputs.concat();
        let mean = |c: usize| sources.iter().zip(weights).map(|(&s, w)| w * all[8 * s as usize + c]).sum::<f64>();
        let least = kept.iter().map(|&c| mean(c)).fold(f64::INFINITY, f64::min);
        assert!((0..8).filter(|c| !kept.contains(c)).all(|c| mean(c) <= least));
        assert!(kept.iter().all(|&c| (row[c] / row[kept[0]] - mean(c) / mean(kept[0])).abs() < 1e-9));
    }

    // As bytes, whose sum is 255 to the last one.
    let bytes: Vec<Vec<u8>> = inputs.iter().map(|rows| rows.iter().map(|x| (255.0 * x) as u8).collect()).collect();
    let mut channel = Channel::new(Domain::Vertices, ValueType::U8, 8, Rule::SkinWeights).unwrap();
    bytes.iter().for_each(|input| channel.push(input, 0, input.len() / 8).unwrap());
    let found: Vec<u8> = applied(&case.origins, &channel, 8).unwrap();
    assert!(found.chunks_exact(8).skip(old).all(|row| row.iter().map(|&x| u32::from(x)).sum::<u32>() == 255));
}

#[test]
fn other_types_are_rounded_and_numbers_are_those_of_sources() {
    let case = caps();
    let numbers: Vec<Vec<u32>> =
        case.pieces.iter().map(|piece| (0..piece.points.len() as u32).map(|v| v * 1000 + 7).collect()).collect();
    for rule in [Rule::Linear, Rule::Nearest] {
        let mut channel = Channel::new(Domain::Vertices, ValueType::U32, 1, rule).unwrap();
        numbers.iter().for_each(|input| channel.push(bytemuck::cast_slice(input), 0, input.len()).unwrap());
        let found: Vec<u32> = applied(&case.origins, &channel, 1).unwrap();
        let all = numbers.concat();
        for (k, &value) in found.iter().enumerate() {
            let (sources, weights) = case.origins.table(Domain::Vertices).row(k);
            let mean: f64 = sources.iter().zip(weights).map(|(&s, w)| w * f64::from(all[s as usize])).sum();
            let largest = weights.iter().copied().fold(0.0, f64::max);
            match rule {
                Rule::Linear => assert!((f64::from(value) - mean).abs() <= 0.5 + 1e-6),
                _ => assert!(sources.iter().zip(weights).any(|(&s, &w)| all[s as usize] == value && w == largest)),
            }
        }
    }
    // If one piece lacks a channel, the strip has the values of the other piece, and the rest is
    // empty.
    let mut channel = Channel::new(Domain::Vertices, ValueType::U16, 1, Rule::Linear).unwrap();
    let ones = vec![40_000u16; case.pieces[0].points.len()];
    channel.push(bytemuck::cast_slice(&ones), 0, ones.len()).unwrap();
    channel.push_missing().unwrap();
    let found: Vec<u16> = applied(&case.origins, &channel, 1).unwrap();
    let (first, second) = (ones.len(), case.pieces[1].points.len());
    assert!(found[..first].iter().chain(&found[first + second..]).all(|&x| x == 40_000));
    assert!(found[first..first + second].iter().all(|&x| x == 0));
}

#[test]
fn the_same_for_any_threads_and_strides() {
    let soup = sheet(200, 150).and(&sheet(150, 100));
    let options = weld::Options { vertices: weld::Vertices::All, tolerance: Some(0.0), ..weld::Options::default() };
    let done = weld::weld(&soup.view(), &options, &job()).unwrap();
    let origins = Origins::from_weld(&done, &job()).unwrap();
    let values: Vec<f32> = (0..4 * soup.points.len()).map(|k| (k as f32).sin()).collect();
    let mut all = Vec::new();
    for (threads, stride) in [(1, 0), (2, 0), (3, 17), (2, 17)] {
        // Three of four components, at an odd place.
        let mut channel = Channel::new(Domain::Vertices, ValueType::F32, 3, Rule::Linear).unwrap();
        channel.push(bytemuck::cast_slice(&values), 16, soup.points.len()).unwrap();
        let count = origins.table(Domain::Vertices).len();
        let step = if stride == 0 { 12 } else { stride };
        let mut out = vec![0xAAu8; 1 + (count - 1) * step + 12];
        let mut output = Output::new(&mut out[1..], stride, count, channel.value_type_and_components()).unwrap();
        carry_values_over(&origins, &channel, &mut output, &Job::new(threads, &crate::common::Silent)).unwrap();
        if step > 12 {
            assert!(out[1 + 12..].chunks(step).all(|gap| gap.iter().take(step - 12).all(|&byte| byte == 0xAA)));
        }
        all.push((0..count).flat_map(|k| out[1 + k * step..][..12].to_vec()).collect::<Vec<_>>());
    }
    assert!(all.iter().all(|out| *out == all[0]));
}

#[test]
fn what_does_not_fit_is_refused() {
    let case = caps();
    let [n, m] = [0, 1].map(|k| case.pieces[k].points.len());
    let refused = |rule: Rule, inputs: &[Vec<f32>]| {
        let mut channel = Channel::new(Domain::Vertices, ValueType::F32, 1, rule).unwrap();
        inputs.iter().for_each(|input| channel.push(bytemuck::cast_slice(input), 0, input.len()).unwrap());
        applied::<f32>(&case.origins, &channel, 1).err()
    };
    let good = || vec![vec![1.0; n], vec![1.0; m]];
    assert_eq!(refused(Rule::Linear, &good()), None);
    assert_eq!(refused(Rule::Linear, &good()[..1]), Some(Error::InputsDiffer { given: 1, needed: 2 }));
    let short = [vec![1.0; n], vec![1.0; m - 1]];
    let differ = Error::ValuesDiffer { input: 1, given: m as u64 - 1, needed: m as u64 };
    assert_eq!(refused(Rule::Linear, &short), Some(differ));
    for (value, rule, is_bad) in [
        (f32::INFINITY, Rule::Linear, true),
        (f32::NEG_INFINITY, Rule::Texture, true),
        (-1e-30, Rule::SkinWeights, true),
        (-0.0, Rule::SkinWeights, false),
        (f32::INFINITY, Rule::Nearest, false),
        (-1.0, Rule::Linear, false),
    ] {
        let mut inputs = good();
        inputs[1][5] = value;
        inputs[1][9] = value;
        let bad = Error::BadValue { element: Element::Vertex, index: 5, input: 1, value: value.into() };
        assert_eq!(refused(rule, &inputs), is_bad.then_some(bad));
    }
    for (components, value_type, rule) in [
        (0, ValueType::F32, Rule::Linear),
        (1 << 13, ValueType::F32, Rule::Linear),
        (2, ValueType::F32, Rule::Normal),
        (3, ValueType::U8, Rule::Normal),
    ] {
        assert!(matches!(
            Channel::new(Domain::Faces, value_type, components, rule),
            Err(Error::OptionOutOfRange { .. })
        ));
    }
    let channel = Channel::new(Domain::Vertices, ValueType::F64, 1, Rule::Linear).unwrap();
    assert!(matches!(
        Output::new(&mut [0; 23], 0, 3, channel.value_type_and_components()),
        Err(Error::ArrayTooShort { .. })
    ));
    assert!(matches!(
        Output::new(&mut [0; 24], 7, 3, channel.value_type_and_components()),
        Err(Error::StrideTooSmall { .. })
    ));
}

fn welding() -> assemble::Options<'static> {
    assemble::Options { weld: Some(weld::Options::default()), ..assemble::Options::default() }
}

/// A piece that is turned over is welded to one that is not: its normals are turned, the other's are
/// not.
#[test]
fn normals_of_welded_pieces_turn_one_by_one() {
    let quad = |x: f64, corners: [u32; 4]| {
        Soup::new(vec![[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x + 1.0, 1.0, 0.0], [x, 1.0, 0.0]], &[&corners])
    };
    for first_turned in [false, true] {
        let turned = |k: usize| if (k == 0) == first_turned { [3, 2, 1, 0] } else { [0, 1, 2, 3] };
        let pieces = [quad(0.0, turned(0)), quad(1.0, turned(1))];
        let views = pieces.each_ref().map(Soup::view);
        let done = assemble(&views, &welding(), &job()).unwrap();
        let origins = Origins::from_assembly(&done, &job()).unwrap();
        // As the faces of each piece have them.
        let up = |k: usize| if turned(k)[0] == 0 { 1.0 } else { -1.0 };
        let given = [0, 1].map(|k| [0.0, 0.0, up(k)].repeat(4));
        for domain in [Domain::Vertices, Domain::Corners] {
            let found = carried(&origins, domain, Rule::Normal, 3, &given);
            let all = if done.turned[0] == first_turned { 1.0 } else { -1.0 };
            assert!(found.chunks_exact(3).all(|normal| normal == [0.0, 0.0, all]), "{domain:?} {found:?}");
        }
    }
}

/// The largest and the smallest numbers have means, too.
#[test]
fn means_of_extreme_values_are_finite() {
    let quad = |x: f64| {
        Soup::new(vec![[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x + 1.0, 1.0, 0.0], [x, 1.0, 0.0]], &[&[0, 1, 2, 3]])
    };
    let pieces = [quad(0.0), quad(1.0)];
    let views = pieces.each_ref().map(Soup::view);
    let done = assemble(&views, &welding(), &job()).unwrap();
    let origins = Origins::from_assembly(&done, &job()).unwrap();
    let found = carried(&origins, Domain::Vertices, Rule::Linear, 1, &[vec![1e308; 4], vec![-1e308; 4]]);
    assert!(found.iter().all(|x| x.is_finite()) && found.contains(&0.0), "{found:?}");
    for size in [5e-324, 1e-200, 1e200, 1e308] {
        let given = [[size, 0.0, 0.0].repeat(4), [0.0, size, 0.0].repeat(4)];
        let found = carried(&origins, Domain::Vertices, Rule::Normal, 3, &given);
        let mixed = found.chunks_exact(3).filter(|normal| normal[0] > 0.0 && normal[1] > 0.0);
        assert_eq!(mixed.map(|normal| (normal[0].hypot(normal[1]) - 1.0).abs()).filter(|off| *off < 1e-12).count(), 2);
    }
}
