//! Cells made plane: against best planes, against other plane nets nearby, on real grids.

use crate::common::StopAt;
use crate::space::{Random, bits, glued_bits_agree, sheet, sphere, torus};
use glam::{DMat3, DVec3};
use gusset::mesh::Scalar;
use gusset::net::planarise::{PlanariseOptions, Planarised, planarise};
use gusset::net::{Net, NodeClasses, Shape, Sides, Topology};
use gusset::{Error, Job};

/// The largest distance of a corner from the best plane of its cell, by the smallest eigenvalue of
/// the scatter (power iteration on its complement); independent of diagonals.
fn worst_plane(net: &Net<'_>) -> f64 {
    let shape = net.shape();
    let cells = (0..shape.rows() - 1).flat_map(|i| (0..shape.columns() - 1).map(move |j| (i, j)));
    let corners = |(i, j): (usize, usize)| [net.get(i, j), net.get(i, j + 1), net.get(i + 1, j + 1), net.get(i + 1, j)];
    cells.map(corners).filter(|c| c.iter().all(|p| p.is_finite())).map(|c| best_plane(&c).1).fold(0.0, f64::max)
}

/// The sum of the squared distances of points from the plane nearest to them, and the largest.
fn best_plane(points: &[DVec3; 4]) -> (f64, f64) {
    let mean = points.iter().sum::<DVec3>() / 4.0;
    let away = points.map(|p| p - mean);
    let scatter = away.iter().fold(DMat3::ZERO, |sum, &p| sum + DMat3::from_cols(p.x * p, p.y * p, p.z * p));
    // Inverse iteration, shifted a little below 0.
    let trace = scatter.x_axis.x + scatter.y_axis.y + scatter.z_axis.z;
    let inverse = (scatter + DMat3::from_diagonal(DVec3::splat(1e-15 * trace))).inverse();
    let mut normal = DVec3::new(0.3, 0.5, 0.8);
    for _ in 0..200 {
        normal = (inverse * normal).normalize();
    }
    let distances = away.map(|p| p.dot(normal).abs());
    (distances.iter().map(|d| d * d).sum(), distances.into_iter().fold(0.0, f64::max))
}

fn bumpy(rows: usize, columns: usize, height: f64, seed: u64) -> Net<'static> {
    let mut random = Random(seed);
    let topology = sheet(rows, columns, Scalar::F64).topology().clone();
    Net::from_fn(topology, Scalar::F64, |i, j| {
        let (x, y) = (j as f64, i as f64);
        DVec3::new(x, y, (0.4 * x).sin() * (0.3 * y).cos() + height * random.next())
    })
    .unwrap()
}

fn made_plane(net: &mut Net<'_>, options: &PlanariseOptions<'_>) -> Planarised {
    planarise(net, options, &Job::default()).unwrap()
}

fn squares(a: &Net<'_>, b: &Net<'_>) -> f64 {
    let classes = NodeClasses::new(a.topology()).unwrap();
    let vertices = (0..a.shape().node_count() as u32).filter(|&node| classes.representative(node) == node);
    vertices.map(|node| a.shape().row_and_column(node)).map(|(i, j)| a.get(i, j).distance_squared(b.get(i, j))).sum()
}

#[test]
fn one_cell_goes_to_its_best_plane() {
    let mut random = Random(3);
    for _ in 0..50 {
        let topology = sheet(2, 2, Scalar::F64).topology().clone();
        let given =
            Net::from_fn(topology, Scalar::F64, |i, j| DVec3::new(j as f64, i as f64, 7.0) + 0.3 * random.vector())
                .unwrap();
        let mut net = given.copied().unwrap();
        let report = made_plane(&mut net, &PlanariseOptions::default());
        let corners = [given.get(0, 0), given.get(0, 1), given.get(1, 1), given.get(1, 0)];
        let least = best_plane(&corners).0;
        assert!(report.converged && worst_plane(&net) < 1e-10, "{report:?}");
        assert!((squares(&given, &net) / least - 1.0).abs() < 1e-3, "{} {least}", squares(&given, &net));
    }
}

#[test]
fn cells_become_plane_and_gluing_stays() {
    let mut random = Random(5);
    for (name, mut net) in [
        ("sheet", bumpy(13, 17, 0.05, 9)),
        ("torus", torus(17, 25, Scalar::F64)),
        ("sphere", sphere(17, 25, Scalar::F64)),
        ("large", bumpy(60, 70, 0.05, 11)),
    ] {
        let classes = NodeClasses::new(net.topology()).unwrap();
        let offsets: Vec<_> = (0..net.shape().node_count()).map(|_| 0.02 * random.vector()).collect();
        for node in 0..net.shape().node_count() as u32 {
            let (i, j) = net.shape().row_and_column(node);
            let moved = net.get(i, j) + offsets[classes.representative(node) as usize];
            net.coordinates_mut().set(i, j, moved);
        }
        gusset::net::field::snap_glued_nodes(&mut net).unwrap();
        let given = net.copied().unwrap();
        let report = made_plane(&mut net, &PlanariseOptions::default());
        assert!(report.converged, "{name}: {report:?}");
        assert!(report.deviation_before > 1e-3 && report.deviation_after <= 1e-10 * report.size, "{name}: {report:?}");
        assert!(worst_plane(&net) <= 1e-10 * report.size, "{name}");
        assert!(glued_bits_agree(&net), "{name}");
        // Displacements are small, and as reported.
        let rms = (squares(&given, &net) / vertex_count(&net)).sqrt();
        assert!((rms / report.rms_displacement - 1.0).abs() < 1e-12, "{name}: {rms} {report:?}");
        assert!(report.max_displacement < 0.8, "{name}: {report:?}");
        println!("{name}: {report:?}");
        // No plane net nearby is nearer to the net that was given: perturb, make plane again.
        let least = squares(&given, &net);
        for _ in 0..3 {
            let mut other = net.copied().unwrap();
            for node in 0..net.shape().node_count() as u32 {
                let (i, j) = net.shape().row_and_column(node);
                let towards = net.get(i, j) + 0.3 * (given.get(i, j) - net.get(i, j)) + 1e-3 * random.vector();
                other.coordinates_mut().set(i, j, towards);
            }
            gusset::net::field::snap_glued_nodes(&mut other).unwrap();
            assert!(made_plane(&mut other, &PlanariseOptions::default()).converged);
            assert!(squares(&given, &other) > least * 0.97, "{name}: {} < {least}", squares(&given, &other));
        }
    }
}

/// The vertices of cells of four corners; poles have none.
fn vertex_count(net: &Net<'_>) -> f64 {
    let classes = NodeClasses::new(net.topology()).unwrap();
    let mut seen = std::collections::BTreeSet::new();
    for cell in (0..net.shape().rows() - 1).flat_map(|i| (0..net.shape().columns() - 1).map(move |j| (i, j))) {
        let corners = classes.representatives_of_corners(cell.0, cell.1);
        if corners.iter().collect::<std::collections::BTreeSet<_>>().len() == 4 {
            seen.extend(corners);
        }
    }
    seen.len() as f64
}

#[test]
fn nets_of_revolution_keep_every_bit() {
    for scalar in [Scalar::F64, Scalar::F32] {
        for mut net in [sphere(33, 65, scalar), torus(33, 65, scalar), sheet(9, 9, scalar)] {
            let before = bits(&net);
            let report = made_plane(&mut net, &PlanariseOptions::default());
            assert!(report.converged && report.iterations == 0 && report.max_displacement == 0.0, "{report:?}");
            assert_eq!(bits(&net), before);
        }
    }
}

#[test]
fn what_is_fixed_stays_and_what_cannot_be_plane_is_told() {
    let given = bumpy(12, 15, 0.05, 21);
    let mut net = given.copied().unwrap();
    let report = made_plane(&mut net, &PlanariseOptions { keep_boundary: true, ..Default::default() });
    assert!(report.converged && worst_plane(&net) <= 1e-10 * report.size, "{report:?}");
    let on_rim = |i: usize, j: usize| i == 0 || j == 0 || i == 11 || j == 14;
    for (i, j) in (0..12).flat_map(|i| (0..15).map(move |j| (i, j))) {
        assert!(!on_rim(i, j) || net.get(i, j) == given.get(i, j));
    }
    // Every other node stays.
    let fixed: Vec<bool> = (0..180).map(|node| (node / 15 + node % 15) % 2 == 0).collect();
    let mut net = given.copied().unwrap();
    let report = made_plane(&mut net, &PlanariseOptions { fixed: &fixed, ..Default::default() });
    for node in (0..180).filter(|&node| fixed[node]) {
        assert_eq!(net.get(node / 15, node % 15), given.get(node / 15, node % 15));
    }
    assert_eq!(report.converged, report.deviation_after <= report.tolerance);
    // All stay: nothing can be done, and the report says so.
    let mut net = given.copied().unwrap();
    let report = made_plane(&mut net, &PlanariseOptions { fixed: &[true; 180], ..Default::default() });
    assert!(!report.converged && report.deviation_after == report.deviation_before && report.max_displacement == 0.0);
    assert_eq!(bits(&net), bits(&given));
    // Too few steps.
    let mut net = given.copied().unwrap();
    let report = made_plane(&mut net, &PlanariseOptions { max_iterations: 2, ..Default::default() });
    assert!(!report.converged && report.iterations == 2 && report.deviation_after < report.deviation_before);
}

#[test]
fn missing_nodes_hidden_cells_and_bad_options() {
    let mut net = bumpy(9, 9, 0.05, 1);
    net.coordinates_mut().set(4, 4, DVec3::NAN);
    let report = made_plane(&mut net, &PlanariseOptions::default());
    assert!(report.converged && net.get(4, 4).is_nan() && worst_plane(&net) <= 1e-10 * report.size);
    // Single precision: to the rounding of its numbers.
    let mut single = bumpy(9, 9, 0.05, 1).converted(Scalar::F32).unwrap();
    let report = made_plane(&mut single, &PlanariseOptions::default());
    assert!(report.converged && report.deviation_after <= 4e-7 * report.size, "{report:?}");
    let mut far = bumpy(9, 9, 0.05, 2);
    for (i, j) in (0..9).flat_map(|i| (0..9).map(move |j| (i, j))) {
        let moved = 1e-3 * far.get(i, j) + DVec3::new(1e3, -2e3, 5.0);
        far.coordinates_mut().set(i, j, moved);
    }
    assert!(made_plane(&mut far, &PlanariseOptions::default()).converged, "far from the origin");
    let topology = Topology::from_sides(Shape::new(3, 3).unwrap(), Sides::SHEET);
    let mut nothing = Net::from_fn(topology, Scalar::F64, |_, _| DVec3::NAN).unwrap();
    let report = made_plane(&mut nothing, &PlanariseOptions::default());
    assert!(report.converged && report.worst_cell.is_none());
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        let options = PlanariseOptions { tolerance, ..Default::default() };
        let refused = planarise(&mut net, &options, &Job::default());
        assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "tolerance", .. })));
    }
    let options = PlanariseOptions { fixed: &[true; 80], ..Default::default() };
    assert!(matches!(planarise(&mut net, &options, &Job::default()), Err(Error::ArrayTooShort { .. })));
}

#[test]
fn real_grids_become_plane() {
    for (file, stop) in [("comb_i0_25x33", 64), ("comb_k0_33x57", 64), ("bun000_range_214x313", 48)] {
        let Some((size, numbers)) = crate::grids::npz(&format!("{file}.npz"), "xyz") else { return };
        // A part in the middle of the large scan, with holes where the scanner saw nothing.
        let (rows, columns) = (size[0].min(stop), size[1].min(stop));
        let [i0, j0] = [(size[0] - rows) / 2, (size[1] - columns) / 2];
        let topology = sheet(rows, columns, Scalar::F64).topology().clone();
        let given = Net::from_fn(topology, Scalar::F64, |i, j| {
            let k = 3 * ((i0 + i) * size[1] + j0 + j);
            DVec3::new(numbers[k], numbers[k + 1], numbers[k + 2])
        })
        .unwrap();
        let mut net = given.copied().unwrap();
        let report = made_plane(&mut net, &PlanariseOptions::default());
        println!("{file}: {report:?}");
        assert!(report.converged && worst_plane(&net) <= 1e-10 * report.size, "{file}: {report:?}");
        assert!(report.deviation_before > 1e-8 * report.size && report.max_displacement < 0.1 * report.size, "{file}");
    }
}

#[test]
fn whatever_stops_it_the_net_stays_and_any_unit_will_do() {
    let before = bumpy(5, 6, 0.3, 4);
    let mut done = false;
    for stop in 0..2000 {
        let mut net = before.copied().unwrap();
        let at = StopAt::new(stop);
        match planarise(&mut net, &PlanariseOptions::default(), &Job::new(1, &at)) {
            Ok(report) => {
                assert!(report.converged);
                done = true;
                break;
            }
            Err(error) => assert_eq!((error, squares(&net, &before)), (gusset::Error::Cancelled, 0.0), "{stop}"),
        }
    }
    assert!(done);
    for unit in [1e-250, 1e-150, 1e-90, 1e78, 1e150, 1e250] {
        let mut net = before.copied().unwrap();
        for node in 0..30 {
            let at = before.get(node / 6, node % 6) * unit;
            net.coordinates_mut().set(node / 6, node % 6, at);
        }
        let report = made_plane(&mut net, &PlanariseOptions::default());
        assert!(report.converged && report.iterations > 0, "{unit}: {report:?}");
        assert!(report.deviation_before > 1e-3 * report.size && report.size.is_finite(), "{unit}: {report:?}");
        assert!(report.deviation_after <= 1e-10 * report.size, "{unit}: {report:?}");
    }
}
