//! Compares bridges in equilibrium with closed forms, and with random neighbours of the solution.

use crate::common::{Silent, StopAt};
use crate::space::{Random, bits, sheet, sphere};
use glam::{DQuat, DVec3};
use gusset::mesh::Scalar;
use gusset::net::settle::{SettleOptions, Settled, settle};
use gusset::net::{
    Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction, JoinOptions, Net, Shape, Sides, Topology,
    concatenate_all,
};
use gusset::{Element, Error, Job};

fn properties(tension: f64, elasticity: f64, stiffness: f64) -> BridgeProperties {
    BridgeProperties { tension, elasticity, stiffness, user: 0 }
}

/// Nets one below the other.
fn joined(nets: &[&Net<'_>], rows: u32, properties: BridgeProperties) -> Net<'static> {
    let options = JoinOptions { rows, properties, turn: true, ..JoinOptions::new(Direction::Down) };
    concatenate_all(nets, &options, &Job::default()).unwrap()
}

fn run(net: &mut Net<'_>, options: SettleOptions<'_>) -> Settled {
    settle(net, &options, &Job::default()).unwrap()
}

fn mapped(net: &Net<'_>, map: impl Fn(DVec3) -> DVec3) -> Net<'static> {
    let mut made = net.copied().unwrap();
    for i in 0..net.shape().rows() {
        (0..net.shape().columns()).for_each(|j| made.coordinates_mut().set(i, j, map(net.get(i, j))));
    }
    made
}

fn set(net: &mut Net<'_>, i: usize, j: usize, p: DVec3) {
    net.coordinates_mut().set(i, j, p);
}

/// A strip of two columns and two rows from z = 0 to z = -1, or of any place.
fn strip(height: f64, slope: f64) -> Net<'static> {
    let topology = Topology::from_sides(Shape::new(2, 2).unwrap(), Sides::SHEET);
    Net::from_fn(topology, Scalar::F64, |i, j| DVec3::new(height + i as f64, slope * i as f64, j as f64)).unwrap()
}

/// An open cylinder of radius 1 between two heights.
fn ring(columns: usize, from: f64, to: f64) -> Net<'static> {
    let sides = Sides { rows_closed: true, ..Sides::SHEET };
    Net::from_fn(Topology::from_sides(Shape::new(2, columns + 1).unwrap(), sides), Scalar::F64, |i, j| {
        let (sin, cos) = (std::f64::consts::TAU * (j % columns) as f64 / columns as f64).sin_cos();
        DVec3::new(cos, sin, if i == 0 { from } else { to })
    })
    .unwrap()
}

#[test]
fn a_thread_under_tension_is_straight_and_even() {
    let [a, b] = [0.0, 5.0].map(|x| mapped(&sphere(9, 13, Scalar::F64), |p| p + DVec3::new(x, 0.0, x)));
    let mut net = joined(&[&a, &b], 6, properties(2.5, 0.0, 0.0));
    assert_eq!(net.bridges()[0].kind, BridgeKind::Thread);
    let (mut random, [p, q]) = (Random(3), [net.get(8, 0), net.get(15, 0)]);
    for i in 9..15 {
        let at = net.get(i, 0) + random.vector();
        (0..13).for_each(|j| set(&mut net, i, j, at));
    }
    let done = run(&mut net, SettleOptions::default());
    assert!(done.converged, "{done:?}");
    for i in 9..15 {
        let wanted = p.lerp(q, (i - 8) as f64 / 7.0);
        assert!((0..13).all(|j| net.get(i, j).distance(wanted) < 1e-12 * 7.0), "{i}");
    }
    assert!((done.tension_energy - 2.5 * p.distance(q)).abs() < 1e-12);
    assert!(done.energy_before > done.tension_energy + 1.0 && done.residual_force < 1e-11);
}

#[test]
fn a_film_between_circles_is_a_catenoid() {
    // Half the height over the radius of the neck a: 1 = a cosh(0.5 / a), by bisection.
    let (mut low, mut high) = (0.6f64, 1.0f64);
    for _ in 0..80 {
        let a = (low + high) / 2.0;
        if a * (0.5 / a).cosh() < 1.0 { low = a } else { high = a }
    }
    let error = |n: usize| {
        let mut net =
            joined(&[&ring(4 * n, -1.5, -0.5), &ring(4 * n, 0.5, 1.5)], n as u32 - 1, properties(1.0, 0.0, 0.0));
        assert_eq!(net.bridges()[0].kind, BridgeKind::Tube);
        let done = run(&mut net, SettleOptions { tolerance: 1e-10, ..SettleOptions::default() });
        assert!(done.converged && done.collapsed == 0, "{done:?}");
        let errors = (1..=n).flat_map(|i| (0..4 * n).map(move |k| (i, k))).map(|(i, k)| {
            let p = net.get(i, k);
            (p.x.hypot(p.y) - low * (p.z / low).cosh()).abs()
        });
        (errors.fold(0.0, f64::max), done.iterations)
    };
    let errors = [4, 8, 16].map(error);
    println!("catenoid errors and steps: {errors:?}");
    assert!(errors[0].0 / errors[1].0 > 3.5 && errors[1].0 / errors[2].0 > 3.5, "{errors:?}");
    assert!(errors[2].0 < 2e-3);
}

#[test]
fn a_film_beyond_its_limit_says_so() {
    let mut net = joined(&[&ring(16, -2.0, -1.0), &ring(16, 1.0, 2.0)], 9, properties(1.0, 0.0, 0.0));
    let done = run(&mut net, SettleOptions { max_iterations: 300, ..SettleOptions::default() });
    println!("{done:?}");
    assert!(!done.converged, "{done:?}");
}

#[test]
fn films_and_beams_in_any_frame_unit_and_number_of_threads() {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize(), 0.7);
    for (rings, given) in [(true, [2.0, 0.0]), (false, [0.0, 1.5]), (false, [1.0, 1.5])] {
        let ends = if rings { [ring(24, -1.5, -0.5), ring(24, 0.5, 1.5)] } else { [strip(0.0, 0.4), strip(3.0, -0.2)] };
        // Bending has the dimension of tension times a square of lengths.
        let at_rest = |map: &dyn Fn(DVec3) -> DVec3, unit: f64, threads: usize| {
            let [a, b] = ends.each_ref().map(|net| mapped(net, map));
            let mut net = joined(&[&a, &b], 6, properties(given[0], 0.0, given[1] * unit * unit));
            let done = settle(&mut net, &SettleOptions::default(), &Job::new(threads, &Silent)).unwrap();
            assert!(done.converged, "{given:?}: {done:?}");
            net
        };
        let plain = at_rest(&|p| p, 1.0, 1);
        for threads in [2, 8] {
            assert_eq!(bits(&plain), bits(&at_rest(&|p| p, 1.0, threads)));
        }
        for unit in [1.0, 2f64.powi(-460), 2f64.powi(460)] {
            let map = |p: DVec3| (turn * p + DVec3::new(3.0, -1.0, 2.0)) * unit;
            let moved = at_rest(&map, unit, 1);
            for (i, j) in (0..plain.shape().rows()).flat_map(|i| (0..2).map(move |j| (i, j))) {
                let off = moved.get(i, j).distance(map(plain.get(i, j))) / unit;
                assert!(off < 1e-7, "{given:?}, unit {unit:e}, node {i} {j}: {off:e}");
            }
        }
    }
}

#[test]
fn springs_in_series_balance() {
    // The middle part is free: (l1 - r1) Y1 / r1 = (l2 - r2) Y2 / r2, and l1 + l2 + 1 is given.
    let (y1, y2) = (3.0, 7.0);
    let parts = [strip(0.0, 0.0), strip(3.0, 0.0), strip(6.0, 0.0)];
    for rows in [0, 1, 4] {
        let mut net = joined(&[&parts[0], &parts[1], &parts[2]], rows, properties(0.0, y1, 0.0));
        net.bridges_mut()[1].properties.elasticity = y2;
        let reference = net.copied().unwrap();
        for i in (4 + 2 * rows as usize)..(6 + 2 * rows as usize) {
            (0..2).for_each(|j| set(&mut net, i, j, reference.get(i, j) + 2.0 * DVec3::X));
        }
        let options =
            SettleOptions { reference: Some(&reference), free: &[false, true, false], ..SettleOptions::default() };
        let done = run(&mut net, options);
        assert!(done.converged && done.settled == 2, "{done:?}");
        // Rest lengths 2 and 2; the last part is 2 further off.
        let l1 = 2.0 + 2.0 * y2 / (y1 + y2);
        let at = net.get(2 + rows as usize, 0);
        assert!(at.distance(DVec3::new(1.0 + l1, 0.0, 0.0)) < 1e-10, "{rows}: {at} {done:?}");
        assert!(net.get(3 + rows as usize, 1).distance(DVec3::new(2.0 + l1, 0.0, 1.0)) < 1e-10);
        let energy = 2.0 * (y1 / 4.0 * (l1 - 2.0).powi(2) + y2 / 4.0 * (4.0 - l1).powi(2));
        assert!((done.elastic_energy - energy).abs() < 1e-10, "{done:?} {energy}");
    }
}

/// The position of node i of a beam of n links of length h, clamped to slopes at both ends. It is
/// the cubic q with q(1) - q(-1) = 2 h slope, and likewise at the other end.
fn cubic(n: usize, h: f64, ends: [f64; 2], slopes: [f64; 2]) -> impl Fn(usize) -> f64 {
    // q(i) = a + b i + c i^2 + d i^3: b + d = h s0; a + ... at n; b + 2 c n + d (3 n^2 + 1) = h s1.
    let (m, [p, q], [s, t]) = (n as f64, ends, slopes.map(|slope| slope * h));
    // b = s - d: q - p = s m - d m + c m^2 + d m^3; t - s = 2 c m + 3 d m^2.
    let d = ((t - s) * m / 2.0 - (q - p - s * m)) / (1.5 * m * m * m - (m * m * m - m));
    let c = (t - s - 3.0 * d * m * m) / (2.0 * m);
    move |i| p + (s - d) * i as f64 + c * (i * i) as f64 + d * (i * i * i) as f64
}

#[test]
fn stiffness_alone_gives_the_clamped_cubic() {
    let (n, mut random) = (7, Random(5));
    let a = strip(0.0, 0.75);
    let b = mapped(&strip(0.0, -0.2), |p| p + DVec3::new(5.0, 2.0, 0.0));
    let mut net = joined(&[&a, &b], n as u32 - 1, properties(0.0, 0.0, 4.0));
    let h = net.get(1, 0).distance(net.get(2, 0));
    let reference = net.copied().unwrap();
    for i in 2..n + 1 {
        (0..2).for_each(|j| set(&mut net, i, j, reference.get(i, j) + random.vector()));
    }
    let done = run(&mut net, SettleOptions { reference: Some(&reference), ..SettleOptions::default() });
    assert!(done.converged, "{done:?}");
    let (first, last) = (DVec3::new(1.0, 0.75, 0.0).normalize(), DVec3::new(1.0, -0.2, 0.0).normalize());
    for axis in 0..2 {
        let ends = [net.get(1, 0)[axis], net.get(n + 1, 0)[axis]];
        let wanted = cubic(n, h, ends, [first[axis], last[axis]]);
        for i in 0..=n {
            assert!((net.get(1 + i, 0)[axis] - wanted(i)).abs() < 1e-10, "{axis} {i} {done:?}");
        }
    }
}

/// The energy of the lines of a bridge, from its definition.
fn line_energy(net: &Net<'_>, [first, last]: [usize; 2], k: usize, p: BridgeProperties, h: f64) -> f64 {
    let at = |i: usize| net.get(i, k);
    let n = (last - first) as f64;
    let lengths: Vec<f64> = (first..last).map(|i| at(i).distance(at(i + 1))).collect();
    let stretched = p.tension * (n * lengths.iter().map(|l| l * l).sum::<f64>()).sqrt();
    let springs: f64 = lengths.iter().map(|l| p.elasticity / 2.0 * (l - h) * (l - h) / h).sum();
    let bends: f64 = (first + 1..last).map(|i| (at(i - 1) - 2.0 * at(i) + at(i + 1)).length_squared()).sum();
    let aim = |end: usize, before: usize| at(end) + h * (at(end) - at(before)).normalize();
    let clamps = (at(first + 1) - aim(first, first - 1)).length_squared()
        + (at(last - 1) - aim(last, last + 1)).length_squared();
    stretched + springs + p.stiffness / (2.0 * h.powi(3)) * (bends + 2.0 * clamps)
}

#[test]
fn what_is_found_is_a_minimum() {
    let mut random = Random(11);
    for case in 0..40 {
        let pick = |random: &mut Random| if random.next() > 0.0 { 1.0 + random.next().abs() } else { 0.0 };
        let p = properties(pick(&mut random), pick(&mut random), pick(&mut random));
        let n = 2 + case % 5;
        let turn = DQuat::from_scaled_axis(0.3 * random.vector());
        let a = strip(0.0, 0.4 * random.next());
        let b = mapped(&strip(4.0, 0.4 * random.next()), |p| turn * p);
        let mut net = joined(&[&a, &b], n as u32 - 1, p);
        let reference = net.copied().unwrap();
        let before: Vec<f64> =
            (0..2).map(|k| reference.get(1, k).distance(reference.get(1 + n, k)) * 0.8 / n as f64).collect();
        for i in 2..n + 1 {
            (0..2).for_each(|j| set(&mut net, i, j, reference.get(i, j) + 0.3 * random.vector()));
        }
        let given = bits(&net);
        // At the rest lengths of straight lines, springs lack transverse stiffness.
        let options = SettleOptions { reference: Some(&reference), rest_ratio: 0.8, ..SettleOptions::default() };
        let done = run(&mut net, options);
        if p == BridgeProperties::default() {
            assert!(done.converged && done.idle == 1 && bits(&net) == given);
            continue;
        }
        assert!(done.converged, "{p:?} {done:?}");
        let energy = |net: &Net<'_>| (0..2).map(|k| line_energy(net, [1, 1 + n], k, p, before[k])).sum::<f64>();
        let found = energy(&net);
        assert!((done.tension_energy + done.elastic_energy + done.bending_energy - found).abs() < 1e-9 * (1.0 + found));
        for size in [1e-1, 1e-3, 1e-5] {
            let mut other = net.copied().unwrap();
            for i in 2..n + 1 {
                (0..2).for_each(|j| set(&mut other, i, j, net.get(i, j) + size * random.vector()));
            }
            assert!(energy(&other) >= found * (1.0 - 1e-12), "{case} {size} {p:?} {} {found}", energy(&other));
        }
    }
}

#[test]
fn rigid_bridges_carry_their_neighbours() {
    let parts = [strip(0.0, 0.1), strip(4.0, 0.3)];
    let reference = joined(&[&parts[0], &parts[1]], 3, properties(0.0, 0.0, f64::INFINITY));
    let turn = DQuat::from_scaled_axis(DVec3::new(0.4, -1.2, 2.0));
    let motion = |p: DVec3| turn * p + DVec3::new(3.0, 4.0, -7.0);
    let mut net = reference.copied().unwrap();
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        set(&mut net, i, j, motion(reference.get(i, j)));
    }
    let options = SettleOptions { reference: Some(&reference), free: &[false, true], ..SettleOptions::default() };
    let done = run(&mut net, options);
    assert!(done.converged);
    for i in 0..7 {
        (0..2).for_each(|j| assert!(net.get(i, j).distance(motion(reference.get(i, j))) < 1e-12, "{i} {j}"));
    }
}

#[test]
fn properties_and_options_that_are_refused() {
    let parts = [strip(0.0, 0.1), strip(4.0, 0.3)];
    let refused = |p: BridgeProperties, options: SettleOptions<'_>| {
        let mut net = joined(&[&parts[0], &parts[1]], 3, p);
        let before = bits(&net);
        let error = settle(&mut net, &options, &Job::default()).unwrap_err();
        assert_eq!(bits(&net), before);
        error
    };
    let none = SettleOptions::default();
    let bad = |property, value| Error::BadProperty { bridge: 0, property, value };
    assert_eq!(refused(properties(-1.0, 0.0, 0.0), none), bad("tension", -1.0));
    assert_eq!(refused(properties(0.0, -2.0, 0.0), none), bad("elasticity", -2.0));
    assert_eq!(refused(properties(0.0, f64::INFINITY, 0.0), none), bad("elasticity", f64::INFINITY));
    assert_eq!(refused(properties(0.0, 0.0, -3.0), none), bad("stiffness", -3.0));
    assert!(matches!(refused(properties(f64::NAN, 0.0, 0.0), none), Error::BadProperty { property: "tension", .. }));
    let good = properties(1.0, 0.0, 0.0);
    let option = |option, value| Error::OptionOutOfRange { option, value, allowed: "finite and at least 0".into() };
    assert_eq!(refused(good, SettleOptions { tolerance: -1.0, ..none }), option("tolerance", -1.0));
    assert_eq!(refused(good, SettleOptions { rest_ratio: -1.0, ..none }), option("rest_ratio", -1.0));
    let few = Error::ArrayTooShort { what: "free", needed: 2, given: 1 };
    assert_eq!(refused(good, SettleOptions { free: &[true], ..none }), few);
    let other = sheet(3, 3, Scalar::F64);
    let sizes = Error::SidesDiffer { a: 14, b: 9 };
    assert_eq!(refused(good, SettleOptions { reference: Some(&other), ..none }), sizes);
}

#[test]
fn tension_and_stiffness_make_a_beam() {
    // B y'''' = T y'' between clamps in line, shifted by `shift`: y = c0 + c1 x + c2 cosh k x + c3
    // sinh k x, odd about the middle: y = a u + b sinh(k u), u from -1/2 to 1/2, y'(1/2) = 0,
    // y(1/2) = shift / 2.
    let (tension, stiffness, shift) = (9.0f64, 1.0f64, 1e-4);
    let k = (tension / stiffness).sqrt();
    let b = shift / 2.0 / ((k / 2.0).sinh() - k / 2.0 * (k / 2.0).cosh());
    let a = -b * k * (k / 2.0).cosh();
    let error = |n: usize| {
        let (first, second) = (strip(-1.0, 0.0), mapped(&strip(1.0, 0.0), |p| p + shift * DVec3::Y));
        let mut net = joined(&[&first, &second], n as u32 - 1, properties(tension, 0.0, stiffness));
        let straight = joined(&[&first, &strip(1.0, 0.0)], n as u32 - 1, properties(0.0, 0.0, 0.0));
        let done = run(&mut net, SettleOptions { reference: Some(&straight), ..SettleOptions::default() });
        assert!(done.converged, "{done:?}");
        let errors = (0..=n).map(|i| {
            let u = i as f64 / n as f64 - 0.5;
            (net.get(1 + i, 0).y - shift / 2.0 - a * u - b * (k * u).sinh()).abs() / shift
        });
        errors.fold(0.0, f64::max)
    };
    let errors = [8, 16, 32].map(error);
    println!("beam errors: {errors:?}");
    assert!(errors[0] / errors[1] > 3.6 && errors[1] / errors[2] > 3.6 && errors[2] < 1e-3, "{errors:?}");
}

/// A composite with a film, a free part and springs, displaced.
fn composite(map: impl Fn(DVec3) -> DVec3, [tension, others]: [f64; 2]) -> (Net<'static>, Net<'static>) {
    let parts = [ring(12, -1.5, -0.5), ring(12, 0.3, 0.9), ring(12, 1.7, 2.0)];
    let mut net = joined(&[&parts[0], &parts[1], &parts[2]], 3, properties(0.4 * tension, 2.0 * others, 0.0));
    let reference = mapped(&net, &map);
    let turn = DQuat::from_scaled_axis(DVec3::new(0.05, 0.1, -0.2));
    let shape = net.shape();
    for i in 5..7 {
        (0..shape.columns()).for_each(|j| {
            let at = turn * net.get(i, j) + DVec3::new(0.1, 0.05, 0.1);
            set(&mut net, i, j, at);
        });
    }
    (mapped(&net, map), reference)
}

#[test]
fn whatever_stops_it_the_net_stays() {
    let (given, reference) = composite(|p| p, [1.0, 1.0]);
    let mut stops = 0;
    loop {
        let mut net = given.copied().unwrap();
        let at = StopAt::new(stops);
        let free = [false, true, false];
        let options =
            SettleOptions { reference: Some(&reference), max_iterations: 5, free: &free, ..SettleOptions::default() };
        match settle(&mut net, &options, &Job::new(1, &at)) {
            Ok(_) => break,
            Err(error) => assert_eq!((error, bits(&net)), (Error::Cancelled, bits(&given)), "{stops}"),
        }
        stops += 1;
    }
    assert!(stops > 10, "{stops}");
}

#[test]
fn hidden_missing_and_collapsed_places_are_let_alone() {
    let parts = [strip(0.0, 0.0), strip(4.0, 0.0)];
    let mut net = joined(&[&parts[0], &parts[1]], 3, properties(1.0, 1.0, 1.0));
    set(&mut net, 3, 0, DVec3::new(2.0, 5.0, 0.0));
    net.set_bridge_mode(0, gusset::net::BridgeMode::Hide, 0.0).unwrap();
    let before = bits(&net);
    let done = run(&mut net, SettleOptions::default());
    assert!(done.converged && (done.settled, done.idle) == (0, 1) && bits(&net) == before);
    net.set_bridge_mode(0, gusset::net::BridgeMode::Keep, 0.0).unwrap();
    assert!(net.set_bridge_mode(0, gusset::net::BridgeMode::Weld, f64::INFINITY).is_err());
    // A line with a missing node stays, the other one goes its way.
    set(&mut net, 3, 0, DVec3::NAN);
    set(&mut net, 2, 0, DVec3::new(1.5, 7.0, 0.0));
    set(&mut net, 3, 1, DVec3::new(2.5, 1.0, 1.0));
    let done = run(&mut net, SettleOptions::default());
    assert!(done.converged && net.get(2, 0).y == 7.0 && net.get(3, 0).is_nan(), "{done:?}");
    assert!(net.get(3, 1).distance(DVec3::new(2.5, 0.0, 1.0)) < 1e-7, "{}", net.get(3, 1));
    // All nodes in one place.
    let point = strip(0.0, 0.0);
    let point = mapped(&point, |_| DVec3::ONE);
    let mut net = joined(&[&point, &point], 3, properties(1.0, 1.0, 1.0));
    let before = bits(&net);
    let done = run(&mut net, SettleOptions::default());
    assert!(done.converged && bits(&net) == before, "{done:?}");
}

#[test]
fn bridges_with_rows_come_back_from_streams() {
    use gusset::net::stream::{StreamMode, StreamOptions, decode, encode};
    for direction in [Direction::Down, Direction::Right] {
        let options = JoinOptions { rows: 5, properties: properties(1.0, 2.0, 3.0), ..JoinOptions::new(direction) };
        let a = sheet(6, 6, Scalar::F64);
        let net = concatenate_all(&[&a, &a, &a], &options, &Job::default()).unwrap();
        let bytes = encode(&net, &StreamOptions::new(StreamMode::Lossless), &Job::default()).unwrap();
        let back = decode(&bytes, &Job::default()).unwrap();
        assert!(back.bridges() == net.bridges() && bits(&back) == bits(&net));
        assert_eq!(back.bridges()[1].rows, 5);
    }
}

/// A finding of the fuzzer `net_edit`: an index out of bounds.
#[test]
fn bridges_beyond_the_net_are_refused() {
    // Six rows: the last row before the bridge and the first one behind it must be among them.
    for (at, rows, fits) in
        [(5, 1, true), (6, 1, false), (5, 5, false), (5, 4, true), (u32::MAX, 1, false), (0, 0, false)]
    {
        let mut net = sheet(6, 5, Scalar::F64);
        let mut bridge = Bridge::new(Direction::Down, at, 5, BridgeKind::Ribbon, BridgeMode::Keep);
        (bridge.rows, bridge.properties.tension) = (rows, 1.0);
        net.bridges_mut().push(bridge);
        let done = settle(&mut net, &SettleOptions::default(), &Job::default());
        let refused = Error::NoSuch { element: Element::Bridge, index: 0, count: 1 };
        assert_eq!(done.err(), (!fits).then_some(refused), "{at} {rows}");
    }
}

/// Two bridges between three strips: the first one straight, the second one not.
fn two_bridges(first: BridgeProperties) -> Net<'static> {
    let nets = [strip(0.0, 0.0), strip(6.0, 0.0), strip(12.0, -0.4)];
    let mut net = joined(&nets.each_ref(), 4, properties(1.0, 0.5, 0.3));
    net.bridges_mut()[0].properties = first;
    net
}

#[test]
fn a_bridge_comes_to_rest_beside_one_that_is_much_stiffer() {
    let mut alone = two_bridges(properties(1.0, 0.5, 0.3));
    assert!(run(&mut alone, SettleOptions::default()).iterations > 4);
    for factor in [1e8, 1e16, 1e20] {
        let mut net = two_bridges(properties(factor, 0.5 * factor, 0.3 * factor));
        let done = run(&mut net, SettleOptions::default());
        assert!(done.converged, "{factor:e} {done:?}");
        // Each within the rounding error of its own energy.
        let off = (0..14).map(|i| net.get(i, 0).distance(alone.get(i, 0))).fold(0.0, f64::max);
        assert!(off < 1e-7, "{factor:e} {off:e}");
    }
}

#[test]
fn stiffness_bends_alike_in_any_unit() {
    let bent = |unit: f64, properties: BridgeProperties| {
        let nets = [strip(0.0, 0.0), strip(6.0, 0.7)].map(|net| mapped(&net, |p| unit * p));
        let mut net = joined(&nets.each_ref(), 4, properties);
        let done = run(&mut net, SettleOptions::default());
        assert!(done.converged && done.residual_force.is_finite(), "{unit:e} {done:?}");
        (mapped(&net, |p| p / unit), done.bending_energy * unit)
    };
    let (wanted, energy) = bent(1.0, properties(0.0, 0.0, 1.0));
    assert!(energy > 0.1 && wanted.get(3, 0).distance(DVec3::new(3.0, 0.0, 0.0)) > 0.2);
    for unit in [1e-140, 1e-60, 1e60, 1e140, 1e170, 1e250] {
        // A tension that is negligible in small units, and dominant in large ones.
        let tension = if unit < 1.0 { 1e-8 } else { 0.0 };
        let (net, found) = bent(unit, properties(tension, 0.0, 1.0));
        assert!((0..8).all(|i| net.get(i, 0).distance(wanted.get(i, 0)) < 1e-12), "{unit:e}");
        assert!((found / energy - 1.0).abs() < 1e-12, "{unit:e} {found:e}");
    }
    // In large units tension leaves nothing of the stiffness: the line is straight.
    let (straight, _) = bent(1e170, properties(1.0, 0.0, 1.0));
    let [p, q] = [straight.get(1, 0), straight.get(6, 0)];
    assert!((1..7).all(|i| straight.get(i, 0).distance(p.lerp(q, (i - 1) as f64 / 5.0)) < 1e-9));
}

#[test]
fn links_without_a_rest_length_leave_the_others_theirs() {
    let [a, b] = [strip(0.0, 0.0), strip(6.0, 0.0)];
    let mut net = joined(&[&a, &b], 4, properties(0.0, 1.0, 0.0));
    let mut reference = net.copied().unwrap();
    (0..2).for_each(|j| set(&mut reference, 2, j, DVec3::NAN));
    let done =
        run(&mut net, SettleOptions { reference: Some(&reference), rest_ratio: 0.9, ..SettleOptions::default() });
    // The two links at the missing node yield: the other three are 0.9 long, from the end on.
    assert!(done.converged && done.elastic_energy < 1e-24, "{done:?}");
    for (i, x) in [(3, 3.3), (4, 4.2), (5, 5.1), (6, 6.0)] {
        assert!(net.get(i, 0).distance(DVec3::new(x, 0.0, 0.0)) < 1e-9, "{i} {}", net.get(i, 0));
    }
}

#[test]
fn nets_far_apart_are_joined_by_many_rows() {
    // Ranges of rows, of which threads take one each, begin between the nets.
    let wide = |z: f64| mapped(&sheet(2, 2000, Scalar::F64), |p| p + DVec3::new(0.0, 200.0 * z, z));
    let net = joined(&[&wide(0.0), &wide(1.0)], 200, properties(0.0, 0.0, 0.0));
    assert_eq!(net.shape().rows(), 204);
    assert!((0..2000).all(|j| net.get(202, j) == DVec3::new(j as f64, 200.0, 1.0)));
}
