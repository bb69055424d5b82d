//! Nets of other sizes: what must stay exactly, what must be close, what must be refused.

use crate::space::{Random, bits, glued_bits_agree, sheet, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::complex::Complex;
use gusset::net::resample::{Interpolation, decimate, pyramid, resample};
use gusset::net::topology::{ContractedLinks, SeamRun};
use gusset::net::*;
use gusset::{Error, Job};

const BOTH: [Interpolation; 2] = [Interpolation::Bilinear, Interpolation::Bicubic];

#[test]
fn the_same_size_is_the_same_net_and_multiples_keep_the_nodes() {
    for interpolation in BOTH {
        for net in [sphere(9, 13, Scalar::F32), torus(9, 13, Scalar::F64), sheet(9, 13, Scalar::F64)] {
            let same = resample(&net, 9, 13, interpolation, &Job::default()).unwrap();
            assert_eq!((bits(&same), same.topology()), (bits(&net), net.topology()));
            let fine = resample(&net, 8 * 3 + 1, 12 * 2 + 1, interpolation, &Job::default()).unwrap();
            assert!(glued_bits_agree(&fine));
            assert_eq!(fine.topology().sides(), net.topology().sides());
            for i in 0..9 {
                for j in 0..13 {
                    assert_eq!(fine.get(3 * i, 2 * j), net.get(i, j));
                }
            }
            let coarse = resample(&net, 5, 7, interpolation, &Job::default()).unwrap();
            assert_eq!(coarse.get(2, 3), net.get(4, 6));
        }
    }
}

#[test]
fn planes_and_for_cubics_parabolas_are_reproduced() {
    let net = sheet(7, 11, Scalar::F64);
    for interpolation in BOTH {
        let other = resample(&net, 23, 6, interpolation, &Job::default()).unwrap();
        for i in 0..23 {
            for j in 0..6 {
                let expected = DVec3::new(j as f64 * 10.0 / 5.0, i as f64 * 6.0 / 22.0, 0.0);
                assert!(other.get(i, j).distance(expected) < 1e-13);
            }
        }
    }
    // Away from the ends, Catmull and Rom's splines reproduce parabolas.
    let parabola = |p: DVec3| DVec3::new(p.x, p.y, p.x * p.x - 2.0 * p.x * p.y + 3.0 * p.y * p.y);
    let bowl = Net::from_fn(net.topology().clone(), Scalar::F64, |i, j| parabola(net.get(i, j))).unwrap();
    let fine = resample(&bowl, 61, 101, Interpolation::Bicubic, &Job::default()).unwrap();
    for i in 10..=50 {
        for j in 10..=90 {
            let p = fine.get(i, j);
            assert!((p - parabola(p)).length() < 1e-11, "{i} {j}");
        }
    }
}

#[test]
fn cubics_go_smoothly_across_seams() {
    let net = torus(17, 33, Scalar::F64);
    let off = |net: &Net<'_>| {
        let nodes = (0..net.shape().rows()).flat_map(|i| (0..net.shape().columns()).map(move |j| (i, j)));
        let distance = |p: DVec3| ((p.x.hypot(p.y) - 3.0).hypot(p.z) - 1.0).abs();
        nodes.map(|(i, j)| distance(net.get(i, j))).fold(0.0, f64::max)
    };
    let [flat, smooth] = BOTH.map(|interpolation| {
        let fine = resample(&net, 64, 128, interpolation, &Job::default()).unwrap();
        assert!(glued_bits_agree(&fine));
        off(&fine)
    });
    assert!(smooth < 0.01 && flat > 3.0 * smooth, "{flat} {smooth}: seams and all");
    // The seam is nowhere special: a torus whose columns begin elsewhere is resampled to the same
    // surface.
    let turned = Net::from_fn(net.topology().clone(), Scalar::F64, |i, j| net.get((i + 5) % 16, (j + 7) % 32)).unwrap();
    let [a, b] = [&net, &turned].map(|net| resample(net, 33, 65, Interpolation::Bicubic, &Job::default()).unwrap());
    for i in 0..33 {
        for j in 0..65 {
            assert!(b.get(i, j).distance(a.get((i + 10) % 32, (j + 14) % 64)) < 1e-14);
        }
    }
}

#[test]
fn poles_stay_points_and_reversed_stays_reversed() {
    let net = sphere(9, 13, Scalar::F32);
    let topology = net.topology().clone().with_reversed(true);
    let net = Net::from_fn(topology, Scalar::F32, |i, j| net.get(i, j)).unwrap();
    for interpolation in BOTH {
        let other = resample(&net, 14, 9, interpolation, &Job::default()).unwrap();
        assert!(glued_bits_agree(&other) && other.topology().is_reversed());
        assert!((0..9).all(|j| other.get(0, j) == DVec3::NEG_Z && other.get(13, j) == DVec3::Z));
    }
}

#[test]
fn missing_nodes_spread_to_what_they_have_a_part_in_only() {
    let mut net = sheet(9, 9, Scalar::F64);
    net.coordinates_mut().set(4, 4, DVec3::NAN);
    let fine = resample(&net, 17, 17, Interpolation::Bilinear, &Job::default()).unwrap();
    for i in 0..17 {
        for j in 0..17 {
            let near = (7..10).contains(&i) && (7..10).contains(&j);
            assert_eq!(fine.get(i, j).is_finite(), !near, "{i} {j}");
        }
    }
}

#[test]
fn what_is_glued_elsewhere_is_refused() {
    let mut net = sheet(6, 8, Scalar::F64);
    let seam = Seam { a: SeamRun::along_column(0, 7, 1), b: SeamRun::along_column(5, 0, -1), count: 6 };
    net.set_topology(Topology::new(net.shape(), ContractedLinks::Sides(Sides::SHEET), &[seam]).unwrap());
    let job = Job::default();
    assert_eq!(resample(&net, 9, 9, Interpolation::Bicubic, &job).unwrap_err(), Error::GluedInside);
    assert_eq!(pyramid(&net, Interpolation::Bicubic, &job).unwrap_err(), Error::GluedInside);
    assert_eq!(decimate(&net, 1.0, &job).unwrap_err(), Error::GluedInside);
    let net = sheet(6, 8, Scalar::F64);
    assert!(matches!(resample(&net, 1, 9, Interpolation::Bicubic, &job), Err(Error::NetTooSmall { .. })));
    assert!(matches!(resample(&net, 1 << 20, 1 << 20, Interpolation::Bicubic, &job), Err(Error::TooLarge { .. })));
    assert!(matches!(decimate(&net, f64::NAN, &job), Err(Error::OptionOutOfRange { .. })));
    let tiny = sheet(2, 2, Scalar::F64);
    assert_eq!(resample(&tiny, 3, 3, Interpolation::Bicubic, &job).unwrap().get(1, 1), DVec3::new(0.5, 0.5, 0.0));
}

#[test]
fn pyramids_have_sizes_of_powers_of_two_and_each_level_is_part_of_the_finer_one() {
    for (net, least) in [
        (torus(20, 33, Scalar::F32), (5, 5)),
        (sphere(17, 50, Scalar::F64), (3, 5)),
        (sheet(9, 3, Scalar::F64), (2, 2)),
    ] {
        let levels = pyramid(&net, Interpolation::Bicubic, &Job::default()).unwrap();
        for level in &levels {
            let shape = level.shape();
            assert!((shape.rows() - 1).is_power_of_two() && (shape.columns() - 1).is_power_of_two());
            assert!(glued_bits_agree(level));
            assert_eq!(level.topology().sides(), net.topology().sides());
        }
        for pair in levels.windows(2) {
            let (fine, coarse) = (pair[0].shape(), pair[1].shape());
            let step = |fine: usize, coarse: usize| (fine - 1) / (coarse - 1);
            let (rows, columns) = (step(fine.rows(), coarse.rows()), step(fine.columns(), coarse.columns()));
            assert!(rows <= 2 && columns <= 2 && rows * columns > 1);
            for i in 0..coarse.rows() {
                for j in 0..coarse.columns() {
                    assert_eq!(pair[1].get(i, j), pair[0].get(rows * i, columns * j));
                }
            }
        }
        let last = levels.last().unwrap().shape();
        assert_eq!((last.rows(), last.columns()), least);
    }
    let exact = torus(17, 33, Scalar::F64);
    assert_eq!(bits(&pyramid(&exact, Interpolation::Bicubic, &Job::default()).unwrap()[0]), bits(&exact));
}

/// From a point to a net's triangles, by going through all of them.
fn distance(point: DVec3, net: &Net<'_>) -> f64 {
    let triangle = |a: DVec3, b: DVec3, c: DVec3| {
        // The nearest of many points of the triangle.
        let n = 24u32;
        let places =
            (0..=n).flat_map(|k| (0..=n - k).map(move |l| (f64::from(k) / f64::from(n), f64::from(l) / f64::from(n))));
        places.map(|(u, v)| (a + u * (b - a) + v * (c - a)).distance(point)).fold(f64::INFINITY, f64::min)
    };
    let mut least = f64::INFINITY;
    for i in 0..net.shape().rows() - 1 {
        for j in 0..net.shape().columns() - 1 {
            let [a, b, c, d] = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| net.get(i, j));
            least = least.min(triangle(a, b, c)).min(triangle(a, c, d));
        }
    }
    least
}

#[test]
fn decimation_keeps_corners_and_the_tolerance() {
    // Flat except one fold: only its rows are needed, with an error of rounding.
    let topology = sheet(40, 31, Scalar::F64).topology().clone();
    let roof = Net::from_fn(topology, Scalar::F64, |i, j| {
        let x = (j * j) as f64;
        DVec3::new(x, i as f64, (x - 100.0).abs())
    })
    .unwrap();
    let found = decimate(&roof, 1e-9, &Job::default()).unwrap();
    assert_eq!((found.rows, found.columns), (vec![0, 39], vec![0, 10, 30]));
    assert!(found.deviation < 1e-12);
    assert_eq!(found.net.get(1, 1), roof.get(39, 10));
    let all = decimate(&roof, f64::INFINITY, &Job::default()).unwrap();
    assert_eq!((all.rows.len(), all.columns.len()), (2, 2));
    // A torus to a tolerance: the result is within it, closed, and much smaller.
    let net = torus(65, 97, Scalar::F64);
    let found = decimate(&net, 0.1, &Job::default()).unwrap();
    assert!(glued_bits_agree(&found.net) && found.net.topology().sides() == net.topology().sides());
    assert!(found.deviation <= 0.1 && found.deviation > 0.05);
    assert!(found.rows.len() * found.columns.len() < 65 * 97 / 8, "{} {}", found.rows.len(), found.columns.len());
    let mut random = Random(8);
    for _ in 0..60 {
        let (i, j) = ((32.0 + 32.0 * random.next()) as usize, (48.0 + 48.0 * random.next()) as usize);
        let off = distance(net.get(i, j), &found.net);
        assert!(off < found.deviation + 0.02, "{off}");
    }
    // Closed nets keep three distinct columns at any tolerance; holes are kept.
    let least = decimate(&torus(9, 13, Scalar::F64), f64::INFINITY, &Job::default()).unwrap();
    assert_eq!((least.rows.len(), least.columns.len()), (4, 4));
    let mut holed = sheet(9, 9, Scalar::F64);
    holed.coordinates_mut().set(4, 4, DVec3::NAN);
    let kept = decimate(&holed, f64::INFINITY, &Job::default()).unwrap();
    assert!(
        kept.rows.contains(&4) && kept.columns.contains(&4) && !kept.net.get(1, 1).is_finite() || kept.rows.len() > 3
    );
}

/// The remaining rows and columns lie on the surface, however few they are.
#[test]
fn coarse_nets_are_the_surface_that_fine_ones_are() {
    let job = Job::default();
    let surface = |net: &Net<'_>| {
        let complex = Complex::from_topology(net.topology(), &job).unwrap();
        (complex.euler_characteristic(), complex.is_closed(), complex.wires.len(), complex.branches.len())
    };
    for bits in 0..64u32 {
        let on = |k: u32| bits >> k & 1 == 1;
        let sides = Sides {
            rows_closed: on(0),
            columns_closed: on(1),
            pole_top: on(2),
            pole_bottom: on(3),
            pole_left: on(4),
            pole_right: on(5),
        };
        for (h, w) in [(9, 17), (17, 6)] {
            let topology = Topology::from_sides(Shape::new(h, w).unwrap(), sides);
            let place = |i: usize, j: usize| DVec3::new(i as f64, j as f64, (i * j) as f64);
            let net = Net::from_fn(topology, Scalar::F64, place).unwrap();
            for level in pyramid(&net, Interpolation::Bilinear, &job).unwrap() {
                assert_eq!(surface(&level), surface(&net), "{:?} {sides:?}", level.shape());
            }
            let least = decimate(&net, f64::INFINITY, &job).unwrap().net;
            assert_eq!(surface(&least), surface(&net), "{:?} {sides:?}", least.shape());
            assert!(least.shape().rows() <= 4 && least.shape().columns() <= 4);
        }
    }
}
