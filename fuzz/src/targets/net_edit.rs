//! Nets resampled, thinned out, made plane, brought to rest and morphed: ends keep their bits, nothing moves
//! farther than the report says, and no error changes a net.

use crate::agree::agreed;
use crate::input::{self, SmallNet};
use gusset::net::field::snap_glued_nodes;
use gusset::net::planarise::PlanariseOptions;
use gusset::net::resample::{Interpolation, decimate, pyramid, resample};
use gusset::net::settle::SettleOptions;
use gusset::net::{Bridge, BridgeKind, BridgeMode, Direction, MorphPath, Net, morph, planarise, settle};

fn bits(net: &Net<'_>) -> Vec<[u64; 3]> {
    let (rows, columns) = (net.shape().rows(), net.shape().columns());
    (0..rows * columns).map(|k| net.get(k / columns, k % columns).to_array().map(f64::to_bits)).collect()
}

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((a, b, [rows, columns, what, tolerance, choice])) = input::taken::<(SmallNet, SmallNet, [u8; 5])>(bytes)
    else {
        return;
    };
    let Some(mut net) = a.net() else { return };
    // Nodes that are one have one place.
    snap_glued_nodes(&mut net).expect("few nodes");
    let interpolation = if what & 8 == 0 { Interpolation::Bilinear } else { Interpolation::Bicubic };
    match what % 6 {
        0 => {
            let [rows, columns] = [rows, columns].map(|count| usize::from(count % 20));
            let made = agreed(choice, |job| resample(&net, rows, columns, interpolation, job).map(|net| bits(&net)));
            assert!(made.is_err() || made.is_ok_and(|made| made.len() == rows * columns));
        }
        1 => {
            let _ = agreed(choice, |job| Ok(pyramid(&net, interpolation, job)?.iter().map(bits).collect::<Vec<_>>()));
        }
        2 => {
            let tolerance = f64::from(tolerance) / 8.0;
            if let Ok((deviation, rows, columns, new)) = agreed(choice, |job| {
                decimate(&net, tolerance, job).map(|made| (made.deviation, made.rows, made.columns, bits(&made.net)))
            }) {
                assert!(deviation <= tolerance);
                let width = net.shape().columns();
                let old = bits(&net);
                assert_eq!(new.len(), rows.len() * columns.len());
                for (place, found) in kept_places(&rows, &columns, width).zip(&new) {
                    assert_eq!(old[place], *found);
                }
            }
        }
        3 => planed(&net, choice),
        4 => rested(net, [rows, columns], tolerance, choice),
        _ => morphed(&net, b.net(), f64::from(tolerance) / 255.0, choice),
    }
}

fn kept_places<'a>(rows: &'a [usize], columns: &'a [usize], width: usize) -> impl Iterator<Item = usize> + 'a {
    rows.iter().flat_map(move |&i| columns.iter().map(move |&j| i * width + j))
}

fn planed(net: &Net<'_>, choice: u8) {
    let options = PlanariseOptions { max_iterations: 6, ..PlanariseOptions::default() };
    let found = agreed(choice, |job| {
        let mut moved = net.copied()?;
        let report = planarise(&mut moved, &options, job);
        assert!(report.is_ok() || bits(&moved) == bits(net), "an error changes nothing");
        report.map(|report| (report, bits(&moved)))
    });
    if let Ok((report, moved)) = found {
        assert!(!report.converged || report.deviation_after <= report.tolerance);
        assert!(report.iterations > 0 || moved == bits(net));
        assert!(report.max_displacement.is_finite() && report.deviation_after.is_finite());
    }
}

fn rested(mut net: Net<'static>, [at, count]: [u8; 2], ratio: u8, choice: u8) {
    let direction = if at < 128 { Direction::Down } else { Direction::Right };
    let (at, count) = (u32::from(at % 16), 1 + u32::from(count % 4));
    net.bridges_mut().push(Bridge::new(direction, at, count, BridgeKind::Ribbon, BridgeMode::default()));
    net.bridges_mut()[0].properties.tension = 1.0;
    let options = SettleOptions { max_iterations: 10, rest_ratio: f64::from(ratio) / 64.0, ..SettleOptions::default() };
    let found = agreed(choice, |job| {
        let mut moved = net.copied()?;
        let report = settle(&mut moved, &options, job);
        assert!(report.is_ok() || bits(&moved) == bits(&net), "an error changes nothing");
        report
    });
    if let Ok(report) = found {
        let after = report.tension_energy + report.elastic_energy + report.bending_energy;
        assert!(after <= report.energy_before * (1.0 + 1e-9) + 1e-300, "{report:?}");
    }
}

fn morphed(net: &Net<'_>, other: Option<Net<'static>>, t: f64, choice: u8) {
    let Some(other) = other else { return };
    for path in [MorphPath::Linear, MorphPath::Rigid] {
        if agreed(choice, |job| morph(net, &other, t, path, job).map(|net| bits(&net))).is_ok() {
            let end = |t: f64| morph(net, &other, t, path, &gusset::Job::default()).map(|net| bits(&net));
            assert_eq!(end(0.0), Ok(bits(net)));
            assert_eq!(end(1.0), Ok(bits(&other)));
        }
    }
}
