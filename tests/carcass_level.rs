//! Sections, contours and curves of angle: against fine sampling, against circles, and against what closed surfaces demand.

mod surfaces;

use glam::DVec3;
use gusset::Job;
use gusset::carcass::level::{Between, Planes};
use gusset::carcass::{Carcass, Grid, Nodes, NormalKind, Patches, Paths, Place, Scheme, Sheet};
use gusset::{Error, Progress};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;
use surfaces::{Random, SHAPES, Shape, grid, rough, torus};

fn carcass(shape: &Shape) -> Carcass<'static> {
    Carcass::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap()
}

fn torus_of(cells: [usize; 2]) -> Carcass<'static> {
    carcass(&Shape { name: "torus", cells, closed: [true, true], point: |u, v| torus(u, v, 0.0) })
}

fn length(paths: &Paths, k: usize) -> f64 {
    let points = paths.points_of(k);
    let around = if paths.closed[k] { points.len() } else { points.len() - 1 };
    (0..around).map(|i| points[i].distance(points[(i + 1) % points.len()])).sum()
}

/// What holds of all curves: offsets, flags, points at their places, normals.
fn check(carcass: &Carcass<'_>, paths: &Paths, name: &str) {
    assert_eq!(paths.ends.len(), paths.len() + 1, "{name}");
    assert_eq!((paths.levels.len(), paths.normals.len()), (paths.len(), paths.points.len()), "{name}");
    assert_eq!((paths.ends[0], paths.ends[paths.len()] as usize), (0, paths.points.len()), "{name}");
    assert!(paths.levels.is_sorted(), "{name}");
    for k in 0..paths.len() {
        assert!(paths.points_of(k).len() >= if paths.closed[k] { 3 } else { 2 }, "{name}");
        let points = paths.points_of(k);
        assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "{name}: repeated points");
    }
    for ((&place, &point), &normal) in paths.places.iter().zip(&paths.points).zip(&paths.normals) {
        assert!((0.0..=1.0).contains(&place.u) && (0.0..=1.0).contains(&place.v), "{name}: {place:?}");
        assert!(carcass.jet(place).point.distance(point) < 1e-13, "{name}: {place:?}");
        assert!(carcass.normal(place).distance(normal) < 1e-9, "{name}: {place:?}");
    }
}

/// Connected parts of the zero set by marching over a very fine sampling of the surface: closed and open ones.
fn by_sampling(
    grid: &Grid<'_>,
    closed: [bool; 2],
    fine: usize,
    value: impl Fn(&Grid<'_>, usize, usize, f64, f64) -> f64,
) -> [usize; 2] {
    let [h, w] = grid.cells();
    let (rows, columns) = (h * fine, w * fine);
    let at = |r: usize, c: usize| {
        let split =
            |k: usize, n: usize| if k == n * fine { (n - 1, 1.0) } else { (k / fine, (k % fine) as f64 / fine as f64) };
        let ((i, u), (j, v)) = (split(r, h), split(c, w));
        value(grid, i, j, u, v) >= 0.0
    };
    let mut signs = vec![false; (rows + 1) * (columns + 1)];
    for (r, c) in (0..=rows).flat_map(|r| (0..=columns).map(move |c| (r, c))) {
        let (r0, c0) = (if closed[0] { r % rows } else { r }, if closed[1] { c % columns } else { c });
        signs[r * (columns + 1) + c] = at(r0, c0);
    }
    // Triangles: no saddles to decide. Edges are numbered by node and direction, and linked through triangles.
    let sign = |r: usize, c: usize| signs[r * (columns + 1) + c];
    let node = |r: usize, c: usize| {
        (if closed[0] { r % rows } else { r }) * (columns + 1) + if closed[1] { c % columns } else { c }
    };
    let mut parent: HashMap<usize, usize> = HashMap::new();
    let mut count: HashMap<usize, usize> = HashMap::new();
    fn root(parent: &mut HashMap<usize, usize>, mut k: usize) -> usize {
        while let Some(&up) = parent.get(&k) {
            if up == k {
                break;
            }
            k = up;
        }
        k
    }
    for (r, c) in (0..rows).flat_map(|r| (0..columns).map(move |c| (r, c))) {
        let edges = [
            (3 * node(r, c), (r, c), (r, c + 1)),
            (3 * node(r, c + 1) + 1, (r, c + 1), (r + 1, c + 1)),
            (3 * node(r, c) + 2, (r, c), (r + 1, c + 1)),
            (3 * node(r + 1, c), (r + 1, c), (r + 1, c + 1)),
            (3 * node(r, c) + 1, (r, c), (r + 1, c)),
        ];
        for triangle in [[0, 1, 2], [2, 3, 4]] {
            let crossed: Vec<usize> = triangle
                .into_iter()
                .filter(|&k| sign(edges[k].1.0, edges[k].1.1) != sign(edges[k].2.0, edges[k].2.1))
                .map(|k| edges[k].0)
                .collect();
            if let [a, b] = crossed[..] {
                for k in [a, b] {
                    parent.entry(k).or_insert(k);
                    *count.entry(k).or_insert(0) += 1;
                }
                let (a, b) = (root(&mut parent, a), root(&mut parent, b));
                if a != b {
                    parent.insert(a.max(b), a.min(b));
                }
            }
        }
    }
    let mut open: HashMap<usize, bool> = HashMap::new();
    let keys: Vec<usize> = parent.keys().copied().collect();
    for k in keys {
        let top = root(&mut parent, k);
        *open.entry(top).or_insert(false) |= count[&k] == 1;
    }
    let opened = open.values().filter(|&&open| open).count();
    [open.len() - opened, opened]
}

/// Sections by random planes and isophotes of random directions against sampling.
fn by_random(shape: &Shape, planes: usize, angles: usize, fine: usize, seed: u64) {
    let (grid, carcass) = (grid(shape), carcass(shape));
    let job = Job::default();
    let mut random = Random(seed);
    let counts = |paths: &Paths| {
        let closed = paths.closed.iter().filter(|&&closed| closed).count();
        [closed, paths.len() - closed]
    };
    let mut total = 0;
    for k in 0..planes {
        let (point, normal) = (random.point(0.7), random.point(1.0));
        let paths = carcass.section(&Planes { point, normal, offsets: &[0.0] }, Between::Auto, &job).unwrap();
        check(&carcass, &paths, shape.name);
        let unit = normal.normalize();
        for (&at, &direction) in paths.points.iter().zip(&paths.normals) {
            assert!((at - point).dot(unit).abs() < 1e-13 && direction.length() > 0.99, "{} {k}", shape.name);
        }
        let value = |grid: &Grid<'_>, i, j, u, v| (grid.patch(i, j).point(u, v) - point).dot(unit);
        assert_eq!(counts(&paths), by_sampling(&grid, shape.closed, fine, value), "{} {k}: plane", shape.name);
        assert!(paths.unresolved.is_empty(), "{} {k}: {:?}", shape.name, paths.unresolved);
        total += paths.len();
    }
    assert!(total > planes / 2, "{}", shape.name);
    for k in 0..angles {
        let axis = random.point(1.0).normalize();
        let angle = if k % 2 == 0 { FRAC_PI_2 } else { 0.2 + 2.5 * random.next() };
        let paths = carcass.isophotes(axis, &[angle], false, Between::Auto, &job).unwrap();
        check(&carcass, &paths, shape.name);
        for normal in &paths.normals {
            // Near a pole normals are limits.
            assert!((normal.angle_between(axis) - angle).abs() < 1e-9, "{} {k}: {normal}", shape.name);
        }
        if shape.name == "sheet with pole" {
            continue;
        }
        let value =
            |grid: &Grid<'_>, i, j, u, v| grid.patch(i, j).jet(u, v).normal().normalize().dot(axis) - angle.cos();
        assert_eq!(counts(&paths), by_sampling(&grid, shape.closed, fine, value), "{} {k}: {angle}", shape.name);
        assert!(paths.unresolved.is_empty(), "{} {k}: {:?}", shape.name, paths.unresolved);
    }
}

#[test]
fn curves_by_sampling() {
    for shape in &SHAPES {
        by_random(shape, 5, 4, 6, 11);
    }
}

#[test]
#[ignore = "takes minutes"]
fn exhaustive_curves_by_sampling() {
    for shape in &SHAPES {
        by_random(shape, 60, 40, 14, 12);
    }
}

/// The distance from the true torus.
fn off_torus(point: DVec3) -> f64 {
    let ring = (point.x * point.x + point.y * point.y).sqrt() - 1.0;
    ((ring * ring + point.z * point.z).sqrt() - 0.4).abs()
}

#[test]
fn circles_and_orders() {
    let job = Job::default();
    let mut errors = Vec::new();
    for h in [16, 32, 64] {
        let carcass = torus_of([h, 2 * h]);
        let offsets = [-0.35, -0.1, 0.0, 0.2];
        let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, offsets: &offsets };
        let chord = 1e-5;
        let paths = carcass.section(&planes, Between::Chord(chord), &job).unwrap();
        check(&carcass, &paths, "torus");
        assert_eq!(paths.levels, [0, 0, 1, 1, 2, 2, 3, 3]);
        assert!(paths.closed.iter().all(|&closed| closed));
        let mut worst = [0.0_f64; 2];
        for k in 0..paths.len() {
            let half = (0.16 - offsets[paths.levels[k] as usize].powi(2)).sqrt();
            let radius = paths.points_of(k)[0].truncate().length();
            let truth = if radius > 1.0 { 1.0 + half } else { 1.0 - half };
            let points = paths.points_of(k);
            for (i, point) in points.iter().enumerate() {
                worst[0] = worst[0].max(off_torus(*point));
                // Chords are no farther from the interpolant, and this from the torus, than they may be.
                let middle = 0.5 * (*point + points[(i + 1) % points.len()]);
                worst[1] = worst[1].max((middle.truncate().length() - truth).abs());
            }
            let (found, circle) = (length(&paths, k), std::f64::consts::TAU * truth);
            assert!((found - circle).abs() < 1e-4 + 20.0 * worst[0], "{h} {k}: {found} {circle}");
        }
        assert!(worst[1] < 1.01 * chord + 10.0 * worst[0], "{h}: {worst:?}");
        // Tilted planes, the chords refined: points between the lines too.
        let tilted = Planes { point: DVec3::new(0.1, 0.0, 0.05), normal: DVec3::new(0.3, -0.2, 1.0), offsets: &[0.0] };
        let paths = carcass.section(&tilted, Between::Chord(1e-4), &job).unwrap();
        errors.push(paths.points.iter().map(|&point| off_torus(point)).fold(worst[0], f64::max));
    }
    println!("points of sections: {errors:?}");
    assert!(errors.windows(2).all(|pair| (pair[0] / pair[1]).log2() >= 3.8), "{errors:?}");
}

#[test]
fn angles_of_contours() {
    let job = Job::default();
    let axis = DVec3::new(0.3, -0.4, 0.8).normalize();
    for (angles, name) in [([FRAC_PI_2, 2.0], "at"), ([0.6, 1.1], "of")] {
        let mut errors = Vec::new();
        for h in [32, 64, 128] {
            let carcass = torus_of([h, 2 * h]);
            let paths = carcass.isophotes(axis, &angles, false, Between::Nothing, &job).unwrap();
            assert!(paths.len() == 4 && paths.closed.iter().all(|&closed| closed), "{h}: {}", paths.len());
            let mut worst = 0.0_f64;
            for k in 0..paths.len() {
                for point in paths.points_of(k) {
                    let ring = point.truncate().normalize().extend(0.0);
                    // The normals of this torus point inwards.
                    let angle = (ring - *point).angle_between(axis);
                    worst = worst.max((angle - angles[paths.levels[k] as usize]).abs());
                }
            }
            errors.push(worst);
        }
        println!("angles {name} contours: {errors:?}");
        assert!(errors.windows(2).all(|pair| (pair[0] / pair[1]).log2() >= 2.9), "{errors:?}");
    }
    // Slopes at nodes are of order four, and so are contours of the cosines there.
    let mut errors = Vec::new();
    for h in [32, 64, 128] {
        let carcass = torus_of([h, 2 * h]);
        let nodes = (0..=h).flat_map(|i| (0..=2 * h).map(move |j| (i % h, j % (2 * h))));
        let values: Vec<f64> = nodes.map(|(i, j)| carcass.sheet(0).normal(i, j, 0.0, 0.0).dot(axis)).collect();
        let paths = carcass.contours(&values, &[1.1_f64.cos()], Between::Nothing, &job).unwrap();
        let angle = |point: &DVec3| (point.truncate().normalize().extend(0.0) - *point).angle_between(axis);
        errors.push(paths.points.iter().map(|point| (angle(point) - 1.1).abs()).fold(0.0, f64::max));
    }
    println!("angles of contours of cosines at nodes: {errors:?}");
    assert!(errors.windows(2).all(|pair| (pair[0] / pair[1]).log2() >= 3.8), "{errors:?}");
}

#[test]
fn lines_of_the_carcass_and_tangent_planes() {
    let job = Job::default();
    let carcass = torus_of([20, 36]);
    // Planes through whole lines of nodes, exactly or nearly.
    for (normal, count) in [(DVec3::Z, 2), (DVec3::Y, 2), (DVec3::X, 2)] {
        for offset in [0.0, 1e-17, -1e-17, 1e-14] {
            let planes = Planes { point: DVec3::ZERO, normal, offsets: &[offset] };
            let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
            check(&carcass, &paths, "lines");
            assert_eq!(paths.len(), count, "{normal} {offset}");
            assert!(paths.closed.iter().all(|&closed| closed) && paths.unresolved.is_empty(), "{normal} {offset}");
        }
    }
    // Villarceau's circles: the plane touches the torus twice; and planes that touch it along a circle, and once.
    let villarceau = DVec3::new(0.4, 0.0, (1.0_f64 - 0.16).sqrt());
    for (normal, offset) in [(villarceau, 0.0), (DVec3::Z, 0.4), (DVec3::X, 0.6), (DVec3::X, 1.4)] {
        for shift in [0.0, 1e-9, -1e-9, 1e-5, -1e-5, 1e-15] {
            let planes = Planes { point: DVec3::ZERO, normal, offsets: &[offset + shift] };
            let start = std::time::Instant::now();
            let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
            check(&carcass, &paths, "tangent");
            assert!(paths.closed.iter().all(|&closed| closed), "{normal} {offset} {shift}");
            assert!(start.elapsed().as_secs() < 20, "{normal} {offset} {shift}");
        }
    }
    // A plane sheet in the plane itself.
    let flat: Vec<f64> = (0..30).flat_map(|k| [f64::from(k / 6), f64::from(k % 6), 0.25]).collect();
    let sheet = Grid::new(Nodes::strided(flat, 5, 6, 0, 0).unwrap(), [false; 2], Scheme::SixTap).unwrap();
    let carcass = Carcass::new(vec![Sheet::Grid(sheet)], None, &job).unwrap();
    let normal = DVec3::new(0.0, 0.0, 3.0);
    let paths = carcass.section(&Planes { point: DVec3::ZERO, normal, offsets: &[0.25] }, Between::Auto, &job).unwrap();
    assert_eq!((paths.len(), paths.unresolved.len()), (0, 20));
}

/// The other scheme through the same nodes.
fn creased(shape: &Shape) -> Grid<'static> {
    Grid::new(grid(shape).nodes().clone(), shape.closed, Scheme::FourPoint).unwrap()
}

/// Sections by random planes through nodes, and contours at nodes' values: 0 at a corner is no reason to leave the plane next to it.
fn through_nodes(grid: Grid<'static>, closed: [bool; 2], scheme: Scheme, planes: usize, levels: usize) {
    let job = Job::default();
    let ([h, w], nodes) = (grid.cells(), grid.nodes().clone());
    let carcass = Carcass::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
    let mut random = Random(41);
    let all_closed = |paths: &Paths| closed != [true; 2] || paths.closed.iter().all(|&closed| closed);
    let node = |random: &mut Random| [h, w].map(|count| (random.next() * count as f64) as usize);
    for k in 0..planes {
        let [i, j] = node(&mut random);
        let point = nodes.get(i, j);
        let small = random.point(4.0).round();
        let normal = if k % 3 == 0 && small != DVec3::ZERO { small } else { random.point(1.0) };
        let paths = carcass.section(&Planes { point, normal, offsets: &[0.0] }, Between::Auto, &job).unwrap();
        let unit = normal.normalize();
        let off = paths.points.iter().map(|&at| (at - point).dot(unit).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12 && all_closed(&paths), "{k}: {off:e} from the plane through node {i} {j}, normal {normal}");
    }
    let random_values: Vec<f64> = (0..h * w + h + w + 1).map(|_| random.next()).collect();
    let round = |k: usize, count: usize, closed: bool| if closed { k % count } else { k };
    let values: Vec<f64> = (0..=h)
        .flat_map(|i| (0..=w).map(move |j| (i, j)))
        .map(|(i, j)| random_values[round(i, h, closed[0]) * (w + 1) + round(j, w, closed[1])])
        .collect();
    let data: Vec<f64> = values.iter().flat_map(|&value| [value, 0.0, 0.0]).collect();
    let field = Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap();
    for k in 0..levels {
        let [i, j] = node(&mut random);
        let level = values[i * (w + 1) + j];
        let paths = carcass.contours(&values, &[level], Between::Auto, &job).unwrap();
        let value = |at: &Place| field.patch(at.cell[0] as usize, at.cell[1] as usize).point(at.u, at.v).x;
        let off = paths.places.iter().map(|at| (value(at) - level).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12 && all_closed(&paths), "{k}: {off:e} from the value at node {i} {j}");
    }
}

#[test]
fn planes_and_contours_through_nodes() {
    let job = Job::default();
    // Examples: the arc next to the node is on the other side of a line of the carcass.
    let example = |shape: &Shape, [i, j]: [usize; 2], normal: DVec3| {
        let point = grid(shape).nodes().get(i, j);
        let planes = Planes { point, normal, offsets: &[0.0] };
        let paths = carcass(shape).section(&planes, Between::Auto, &job).unwrap();
        let off = paths.points.iter().map(|&at| (at - point).dot(normal.normalize()).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12 && paths.unresolved.is_empty(), "{} {i} {j}: {off:e}", shape.name);
    };
    example(&SHAPES[3], [4, 10], DVec3::new(-0.4005429391700355, 0.26455396103711837, -0.9883190180791992));
    example(&SHAPES[0], [14, 29], DVec3::new(-3.0, 0.0, -3.0));
    for shape in &SHAPES {
        through_nodes(grid(shape), shape.closed, Scheme::SixTap, 150, 10);
    }
    through_nodes(creased(&SHAPES[1]), [true; 2], Scheme::FourPoint, 60, 5);
    through_nodes(rough([12, 17], [true; 2], Scheme::SixTap, 4), [true; 2], Scheme::SixTap, 150, 40);
    through_nodes(rough([8, 9], [false; 2], Scheme::SixTap, 3), [false; 2], Scheme::SixTap, 150, 40);
}

/// Every point of a curve of angle has the angle, or its cell is reported. Returns how many points were looked at, and how many are in
/// reported cells only.
fn check_angles(carcass: &Carcass<'_>, axis: DVec3, angle: f64) -> [usize; 2] {
    let paths = carcass.isophotes(axis, &[angle], false, Between::Auto, &Job::default()).unwrap();
    let mut counts = [0; 2];
    for &place in &paths.places {
        let local = carcass.local(place);
        if local.normal.kind != NormalKind::Regular {
            continue;
        }
        counts[0] += 1;
        if (local.normal.direction.angle_between(axis) - angle).abs() > 1e-6 {
            counts[1] += 1;
            let reported = paths.unresolved.iter().any(|at| at.cell == place.cell);
            assert!(reported, "{axis} {angle}: {place:?} {}", local.normal.direction.angle_between(axis));
        }
    }
    counts
}

/// A sphere, its poles repeated.
fn sphere() -> Grid<'static> {
    let point = |i: usize, j: usize| {
        let (polar, around) = (PI * i as f64 / 10.0, 2.0 * PI * (j % 20) as f64 / 20.0);
        let ring = if [0, 10].contains(&i) { 0.0 } else { polar.sin() };
        DVec3::new(ring * around.cos(), ring * around.sin(), polar.cos())
    };
    let data = (0..=10).flat_map(|i| (0..=20).flat_map(move |j| point(i, j).to_array())).collect::<Vec<f64>>();
    Grid::new(Nodes::strided(data, 11, 21, 0, 0).unwrap(), [false, true], Scheme::SixTap).unwrap()
}

#[test]
fn angles_next_to_poles_and_of_one_sign() {
    let of = |grid: Grid<'static>| Carcass::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap();
    let mut random = Random(13);
    let round = of(sphere());
    let axis = DVec3::new(0.08893091432537499, -0.9623978257264392, -0.25667434136328304);
    let [count, wrong] = check_angles(&round, axis, FRAC_PI_2);
    assert!(count > 100 && wrong == 0, "{wrong} of {count}");
    // Where curves of alpha and pi - alpha are next to each other at creases.
    let bumpy = of(creased(&SHAPES[1]));
    let [count, wrong] = check_angles(&bumpy, DVec3::Z, 1.5217083479313647);
    assert!(count > 1000 && wrong == 0, "{wrong} of {count}");
    for k in 0..6 {
        for carcass in [&round, &bumpy] {
            let axis = random.point(1.0).normalize();
            let angle = if k % 2 == 0 { FRAC_PI_2 } else { 0.3 + 2.5 * random.next() };
            let [_, wrong] = check_angles(carcass, axis, angle);
            assert_eq!(wrong, 0, "{axis} {angle}");
        }
    }
    // With places where the normal vanishes nearly.
    for (cells, closed, scheme, seed) in [
        ([8, 9], [false; 2], Scheme::SixTap, 3),
        ([12, 17], [true; 2], Scheme::SixTap, 4),
        ([12, 17], [true; 2], Scheme::FourPoint, 5),
    ] {
        let carcass = of(rough(cells, closed, scheme, seed));
        check_angles(&carcass, DVec3::Z, 1.5217083479313647);
        for _ in 0..4 {
            check_angles(&carcass, random.point(1.0).normalize(), 0.3 + 2.5 * random.next());
        }
    }
}

#[test]
fn loops_round_every_summit() {
    let (shape, job) = (&SHAPES[2], Job::default());
    let carcass = carcass(shape);
    let tops = carcass.isophotes(DVec3::Z, &[0.0], false, Between::Auto, &job).unwrap();
    check_points(&carcass, &tops);
    assert!(tops.len() > 3 && tops.unresolved.is_empty(), "{tops:?}");
    let mut loops = 0;
    for &top in &tops.points {
        // A little below a summit, above a pit: a closed curve round it, within a cell; or none, at saddles.
        for shift in [-1e-8, 1e-8] {
            let planes = Planes { point: top, normal: DVec3::Z, offsets: &[shift] };
            let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
            let near = |k: &usize| paths.points_of(*k).iter().all(|point| point.distance(top) < 1e-3);
            let small: Vec<usize> = (0..paths.len()).filter(near).collect();
            loops += small.len();
            assert!(small.iter().all(|&k| paths.closed[k]));
        }
    }
    // Summits and pits outnumber saddles, or are as many, on such a sheet.
    let curved = tops.places.iter().filter(|&&place| carcass.jet(place).curvatures().unwrap().1 > 0.0).count();
    assert!(curved > 2 && loops == curved, "{loops} {curved} of {}", tops.len());
}

fn check_points(carcass: &Carcass<'_>, paths: &Paths) {
    assert!(paths.ends.windows(2).all(|pair| pair[1] == pair[0] + 1));
    for (&place, &point) in paths.places.iter().zip(&paths.points) {
        assert!(carcass.jet(place).point.distance(point) < 1e-13);
        assert!(carcass.normal(place).cross(DVec3::Z).length() < 1e-9);
    }
}

/// All cells of a grid as patches, in sheets of some columns each.
fn patched<const N: usize>(grid: &Grid<'static>, columns: usize) -> Vec<Patches<N>> {
    let [h, w] = grid.cells();
    let sheet = |first: usize| {
        let cells = (0..h).flat_map(|i| (first..w.min(first + columns)).map(move |j| (i, j)));
        let points: Vec<DVec3> =
            cells.flat_map(|(i, j)| grid.patch(i, j).points.into_iter().flatten().collect::<Vec<_>>()).collect();
        Patches::new(&points, [3, 3], h, w.min(first + columns) - first).unwrap()
    };
    (0..w).step_by(columns).map(sheet).collect()
}

#[test]
fn patches_and_several_sheets() {
    let job = Job::default();
    let shape = &SHAPES[1];
    let (whole, grid) = (carcass(shape), grid(shape));
    let of = |sheets: Vec<Sheet<'static>>| Carcass::new(sheets, None, &job).unwrap();
    let cubic = of(patched::<4>(&grid, 53).into_iter().map(Sheet::Cubic).collect());
    let pieces = of(patched::<4>(&grid, 17).into_iter().map(Sheet::Cubic).collect());
    let high = of(patched::<8>(&grid, 30).into_iter().map(Sheet::High).collect());
    let mut random = Random(21);
    for k in 0..6 {
        let planes = Planes { point: random.point(0.5), normal: random.point(1.0), offsets: &[-0.2, 0.0, 0.1] };
        let truth = whole.section(&planes, Between::Nothing, &job).unwrap();
        let mut lengths: Vec<f64> = (0..truth.len()).map(|k| length(&truth, k)).collect();
        lengths.sort_by(f64::total_cmp);
        for other in [&cubic, &pieces, &high] {
            let paths = other.section(&planes, Between::Nothing, &job).unwrap();
            check(other, &paths, "patches");
            assert!(paths.closed.iter().all(|&closed| closed), "{k}");
            assert!(paths.unresolved.is_empty(), "{k}: {:?}", paths.unresolved);
            let mut found: Vec<f64> = (0..paths.len()).map(|k| length(&paths, k)).collect();
            found.sort_by(f64::total_cmp);
            assert_eq!(found.len(), lengths.len(), "{k}");
            assert!(found.iter().zip(&lengths).all(|(a, b)| (a - b).abs() < 1e-9), "{k}: {found:?} {lengths:?}");
        }
    }
    // Silhouettes: the normals of patches agree but for rounding, and no more is known of them.
    let truth = whole.isophotes(DVec3::new(0.1, 0.7, 0.3), &[FRAC_PI_2], false, Between::Nothing, &job).unwrap();
    let paths = cubic.isophotes(DVec3::new(0.1, 0.7, 0.3), &[FRAC_PI_2], false, Between::Nothing, &job).unwrap();
    let all = |paths: &Paths| (0..paths.len()).map(|k| length(paths, k)).sum::<f64>();
    assert!((all(&truth) - all(&paths)).abs() < 1e-7, "{} {}", all(&truth), all(&paths));
    assert_eq!((paths.len(), paths.closed.iter().all(|&closed| closed)), (truth.len(), true));
}

#[test]
fn normals_that_jump() {
    // The four-point scheme has creases along all lines.
    let job = Job::default();
    let (mut total, mut ended, mut whole) = (0, 0, 0);
    for shape in &SHAPES[..2] {
        let smooth = grid(shape);
        let nodes = smooth.nodes().clone();
        let carcass =
            Carcass::new(vec![Sheet::Grid(Grid::new(nodes, shape.closed, Scheme::FourPoint).unwrap())], None, &job)
                .unwrap();
        let other = self::carcass(shape);
        let mut random = Random(31);
        for k in 0..12 {
            let axis = random.point(1.0);
            let angles = [0.4 + 0.8 * random.next(), FRAC_PI_2, 2.0];
            let paths = carcass.isophotes(axis, &angles, false, Between::Nothing, &job).unwrap();
            // Where a crease itself is the curve for more than a cell, curves end, and their ends are reported.
            let open = paths.closed.iter().filter(|&&closed| !closed).count();
            // Both ends may be in one cell, which is listed once.
            assert!(paths.unresolved.len() >= open, "{} {k}: {open} {:?}", shape.name, paths.unresolved);
            (total, ended) = (total + paths.len(), ended + open);
            let truth = other.isophotes(axis, &angles, false, Between::Nothing, &job).unwrap();
            let all = |paths: &Paths| (0..paths.len()).map(|k| length(paths, k)).sum::<f64>();
            // What is missing is along creases that are listed.
            let (found, expected) = (all(&paths), all(&truth));
            let near = (found / expected - 1.0).abs() < 0.05;
            assert!(near || !paths.unresolved.is_empty(), "{} {k}: {found} {expected}", shape.name);
            whole += usize::from(near);
        }
        // Seen along the axis, the silhouettes of the torus are creases.
        let paths = carcass.isophotes(DVec3::Z, &[FRAC_PI_2], false, Between::Nothing, &job).unwrap();
        assert!(paths.len() >= 2 || paths.unresolved.len() > 10, "{}: {paths:?}", shape.name);
    }
    assert!(total > 60 && ended * 2 < total && whole > 12, "{ended} of {total}, {whole}");
}

/// The teapot's patches, a sheet each; `None` where there are no data.
fn teapot() -> Option<Carcass<'static>> {
    let folder =
        std::env::var("GUSSET_DATA").unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/data").into());
    let text = std::fs::read_to_string(format!("{folder}/carcass/teapot_bezier.json")).ok()?;
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let vertices: Vec<DVec3> =
        data["vertices"].as_array().unwrap().iter().map(|vertex| DVec3::from_slice(&numbers(vertex))).collect();
    let patches = data["patches"].as_array().unwrap().iter().map(|patch| {
        let points: Vec<DVec3> = numbers(patch).into_iter().map(|k| vertices[k as usize]).collect();
        Sheet::Cubic(Patches::new(&points, [3, 3], 1, 1).unwrap())
    });
    Some(Carcass::new(patches.collect(), None, &Job::default()).unwrap())
}

#[test]
fn teapot_patches_are_joined() {
    let Some(carcass) = teapot() else { return println!("skipped: no data") };
    let job = Job::default();
    // Round the body, below the lid: no plane section of a teapot's body ends.
    let planes = Planes { point: DVec3::ZERO, normal: DVec3::Y, offsets: &[0.1, 0.2, 0.35, 0.5] };
    let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
    check(&carcass, &paths, "teapot");
    for level in 0..4 {
        let round = |k: &usize| {
            let box_of =
                |axis: fn(&DVec3) -> f64| paths.points_of(*k).iter().map(axis).fold(f64::NEG_INFINITY, f64::max);
            paths.closed[*k] && paths.levels[*k] == level && box_of(|p| p.z) > 0.3 && box_of(|p| -p.z) > 0.3
        };
        assert_eq!((0..paths.len()).filter(round).count(), 1, "{level}");
    }
    // Any plane: no two ends are left that fit.
    let mut random = Random(8);
    for k in 0..20 {
        let planes = Planes { point: random.point(0.4), normal: random.point(1.0), offsets: &[0.0] };
        let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
        check(&carcass, &paths, "teapot");
        let open: Vec<usize> = (0..paths.len()).filter(|&k| !paths.closed[k]).collect();
        for (&a, &b) in open.iter().flat_map(|a| open.iter().map(move |b| (a, b))) {
            let (tail, head) = (paths.points_of(a).last().unwrap(), paths.points_of(b)[0]);
            assert!(tail.distance(head) > 1e-8, "{k}: {a} {b}");
        }
    }
}

#[test]
fn contours_of_heights_are_sections() {
    let job = Job::default();
    for shape in &SHAPES {
        let (grid, carcass) = (grid(shape), carcass(shape));
        let nodes = grid.nodes();
        let all = (0..nodes.rows()).flat_map(|i| (0..nodes.columns()).map(move |j| (i, j)));
        let values: Vec<f64> = all.map(|(i, j)| nodes.get(i, j).z).collect();
        let levels = [-0.11, 0.017, 0.05, 0.1];
        let contours = carcass.contours(&values, &levels, Between::Auto, &job).unwrap();
        let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, offsets: &levels };
        let sections = carcass.section(&planes, Between::Auto, &job).unwrap();
        assert!(!sections.is_empty() && sections.ends == contours.ends && sections.levels == contours.levels);
        assert!(sections.points.iter().zip(&contours.points).all(|(a, b)| a.distance(*b) < 1e-12), "{}", shape.name);
        // Greater values to the left.
        for k in 0..contours.len() {
            let points = contours.points_of(k);
            let at = contours.ends[k] as usize;
            let (along, normal) = (points[1] - points[0], contours.normals[at]);
            let jet = carcass.jet(contours.places[at]);
            let left = normal.cross(along);
            // The direction in the surface in which z rises.
            let rise = DVec3::Z - normal.z * normal;
            assert!(jet.point.distance(points[0]) < 1e-13 && left.dot(rise) > 0.0, "{} {k}", shape.name);
        }
    }
}

#[test]
fn stacks_threads_and_chains() {
    let carcass = carcass(&SHAPES[1]);
    let offsets: Vec<f64> = (0..9).map(|k| 0.11 * f64::from(k) - 0.5).collect();
    let (point, normal) = (DVec3::new(0.1, 0.2, 0.0), DVec3::new(1.0, 0.3, 0.4));
    let planes = Planes { point, normal, offsets: &offsets };
    let one = carcass.section(&planes, Between::Auto, &Job::new(1, &Quiet)).unwrap();
    assert_eq!(one, carcass.section(&planes, Between::Auto, &Job::new(3, &Quiet)).unwrap());
    let angles = [0.3, 1.0, FRAC_PI_2, 3.0];
    let round = carcass.isophotes(normal, &angles, false, Between::Auto, &Job::new(1, &Quiet)).unwrap();
    assert_eq!(round, carcass.isophotes(normal, &angles, false, Between::Auto, &Job::new(3, &Quiet)).unwrap());
    // One by one.
    let mut count = 0;
    for (k, &offset) in offsets.iter().enumerate() {
        let single = Planes { point, normal, offsets: &[offset] };
        let paths = carcass.section(&single, Between::Auto, &Job::default()).unwrap();
        for own in 0..paths.len() {
            assert_eq!((one.levels[count], one.points_of(count)), (k as u32, paths.points_of(own)));
            count += 1;
        }
    }
    assert_eq!(count, one.len());
    // The paper's chains: nearer to the torus than the chords are.
    let carcass = torus_of([30, 60]);
    let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, offsets: &[0.1] };
    let chords = carcass.section(&planes, Between::Nothing, &Job::default()).unwrap();
    let cubics = carcass.section(&planes, Between::Leus(1), &Job::default()).unwrap();
    assert_eq!(cubics.points.len(), 2 * chords.points.len());
    let middles = (0..chords.points_of(0).len() - 1).map(|k| 0.5 * (chords.points[k] + chords.points[k + 1]));
    let worst = |points: &mut dyn Iterator<Item = DVec3>| points.map(off_torus).fold(0.0, f64::max);
    let (linear, cubic) = (worst(&mut middles.clone()), worst(&mut cubics.points.iter().copied()));
    assert!(cubic < 0.02 * linear, "{cubic} {linear}");
}

#[test]
fn nearest_angles() {
    for shape in &SHAPES {
        let (grid, carcass) = (grid(shape), carcass(shape));
        let mut random = Random(4);
        for k in 0..6 {
            let (axis, unsigned) = (random.point(1.0).normalize(), k % 3 == 2);
            let angle = random.next() * if unsigned { FRAC_PI_2 } else { PI };
            let found = carcass.nearest_angle(axis, angle, unsigned, &Job::default()).unwrap().unwrap();
            let deviation = |normal: DVec3| {
                let given = normal.angle_between(axis);
                (if unsigned { given.min(PI - given) } else { given } - angle).abs()
            };
            let mut least = f64::INFINITY;
            let [h, w] = grid.cells();
            for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
                let patch = grid.patch(i, j);
                for s in 0..36 {
                    let normal = patch.jet(f64::from(s / 6) / 5.0, f64::from(s % 6) / 5.0).normal();
                    if normal.length() > 1e-9 {
                        least = least.min(deviation(normal));
                    }
                }
            }
            assert!(
                found.deviation <= least + 1e-9 && found.bound <= least + 1e-12,
                "{} {k}: {found:?} {least}",
                shape.name
            );
            assert!((deviation(found.normal) - found.deviation).abs() < 1e-7, "{} {k}: {found:?}", shape.name);
            assert!(found.bound >= found.deviation - 1.1e-9, "{} {k}: {found:?} {least}", shape.name);
        }
    }
}

#[test]
fn what_is_refused() {
    let (carcass, job) = (carcass(&SHAPES[2]), Job::default());
    let plane = |point: DVec3, normal: DVec3, offsets: &[f64]| {
        carcass.section(&Planes { point, normal, offsets }, Between::Auto, &job).map(|paths| paths.len())
    };
    let out = |result: Result<usize, Error>| matches!(result, Err(Error::OptionOutOfRange { .. }));
    assert!(out(plane(DVec3::NAN, DVec3::Z, &[0.0])) && out(plane(DVec3::ZERO, DVec3::ZERO, &[0.0])));
    assert!(out(plane(DVec3::ZERO, DVec3::INFINITY, &[0.0])) && out(plane(DVec3::ZERO, DVec3::Z, &[0.0, 0.0])));
    assert!(out(plane(DVec3::ZERO, DVec3::Z, &[0.1, f64::NAN])));
    assert_eq!((plane(DVec3::ZERO, DVec3::Z, &[]), plane(DVec3::ZERO, DVec3::Z, &[1e300])), (Ok(0), Ok(0)));
    assert_eq!(plane(DVec3::ZERO, 1e-300 * DVec3::Z, &[0.01]), plane(DVec3::ZERO, 1e300 * DVec3::Z, &[0.01]));
    let values = vec![0.5; 41 * 53];
    assert!(matches!(carcass.contours(&values[1..], &[0.1], Between::Auto, &job), Err(Error::ArrayTooShort { .. })));
    let mut bad = values.clone();
    bad[77] = f64::NAN;
    assert!(matches!(carcass.contours(&bad, &[0.1], Between::Auto, &job), Err(Error::NodeNotFinite { node: 77, .. })));
    bad.push(0.0);
    assert!(matches!(carcass.contours(&bad, &[0.1], Between::Auto, &job), Err(Error::TooLarge { .. })));
    let around = |angles: &[f64], unsigned| {
        carcass.isophotes(DVec3::X, angles, unsigned, Between::Auto, &job).map(|paths| paths.len())
    };
    assert!(out(around(&[-0.1], false)) && out(around(&[1.7], true)) && out(around(&[3.2], false)));
    assert!(out(around(&[f64::NAN], false)) && out(around(&[1.0, 0.5], false)));
    for between in [Between::Chord(0.0), Between::Chord(f64::NAN), Between::Leus(2000)] {
        assert!(out(carcass
            .section(&Planes { point: DVec3::ZERO, normal: DVec3::Z, offsets: &[0.0] }, between, &job)
            .map(|paths| paths.len())));
    }
    assert!(carcass.nearest_angle(DVec3::X, -1.0, false, &job).is_err());
    struct Stop;
    impl Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    let stopped = carcass.isophotes(DVec3::X, &[1.0], false, Between::Auto, &Job::new(1, &Stop));
    assert_eq!(stopped.err(), Some(Error::Cancelled));
}

#[test]
fn any_size_and_place() {
    let job = Job::default();
    for (size, shift) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e6), (1e3, -1e7)] {
        let moved = |point: DVec3| size * point + DVec3::splat(shift);
        let data: Vec<f64> = {
            let grid = grid(&SHAPES[1]);
            let nodes = grid.nodes();
            let all = (0..nodes.rows()).flat_map(|i| (0..nodes.columns()).map(move |j| (i, j)));
            all.flat_map(|(i, j)| moved(nodes.get(i, j)).to_array()).collect()
        };
        let sheet = Grid::new(Nodes::strided(data, 32, 54, 0, 0).unwrap(), [true; 2], Scheme::SixTap).unwrap();
        let carcass = Carcass::new(vec![Sheet::Grid(sheet)], None, &job).unwrap();
        let normal = DVec3::new(0.2, 0.5, 0.9);
        let offsets = [-0.1 * size, 0.07 * size];
        let planes = Planes { point: moved(DVec3::new(0.05, 0.0, 0.01)), normal, offsets: &offsets };
        let paths = carcass.section(&planes, Between::Auto, &job).unwrap();
        let truth = self::carcass(&SHAPES[1]);
        let planes = Planes { point: DVec3::new(0.05, 0.0, 0.01), normal, offsets: &[-0.1, 0.07] };
        let truth = truth.section(&planes, Between::Auto, &job).unwrap();
        assert_eq!((paths.len(), &paths.levels), (truth.len(), &truth.levels), "{size} {shift}");
        assert!(paths.closed.iter().all(|&closed| closed) && paths.unresolved.is_empty(), "{size} {shift}");
        for k in 0..paths.len() {
            let (a, b) = (length(&paths, k) / size, length(&truth, k));
            assert!((a - b).abs() < 1e-6 * b, "{size} {shift}: {a} {b}");
        }
    }
}

#[test]
#[ignore = "timing"]
fn timing() {
    let carcass = torus_of([707, 1412]);
    let job = Job::new(1, &Quiet);
    // Of this thread alone, in milliseconds: the machine may have others to serve.
    let clock = || {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
        text.split_whitespace().next().unwrap().parse::<f64>().unwrap() * 1e-6
    };
    let least = |run: &mut dyn FnMut() -> usize| {
        // The clock ticks every few milliseconds.
        let start = clock();
        let count = (0..100).map(|_| run()).last().unwrap();
        ((clock() - start) / 100.0, count)
    };
    let mut random = Random(5);
    for k in 0..4 {
        let planes = Planes { point: random.point(0.2), normal: random.point(1.0), offsets: &[0.0] };
        for between in [Between::Nothing, Between::Auto] {
            let (time, count) = least(&mut || carcass.section(&planes, between, &job).unwrap().points.len());
            println!("plane {k} {between:?}: {time:.3} ms, {count} points, {:.0} ns each", time * 1e6 / count as f64);
        }
    }
    let offsets: Vec<f64> = (0..100).map(|k| 0.01 * f64::from(k) - 0.5).collect();
    let planes = Planes { point: DVec3::ZERO, normal: DVec3::new(0.3, 0.2, 1.0), offsets: &offsets };
    let (time, count) = least(&mut || carcass.section(&planes, Between::Nothing, &job).unwrap().points.len());
    println!("100 planes: {time:.2} ms, {count} points");
    for angle in [FRAC_PI_2, 1.0] {
        let axis = DVec3::new(0.3, 0.2, 1.0);
        let start = clock();
        let paths = carcass.isophotes(axis, &[angle], false, Between::Nothing, &job).unwrap();
        println!("isophote {angle}: {:.1} ms, {} points", clock() - start, paths.points.len());
        let start = clock();
        let found = carcass.nearest_angle(axis, angle, false, &job).unwrap().unwrap();
        println!("nearest angle: {:.1} ms, {:.1e}", clock() - start, found.deviation);
    }
}

struct Quiet;

impl Progress for Quiet {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

#[test]
fn a_sheet_without_normals_has_no_angle() {
    let job = Job::default();
    let nodes: Vec<f64> = (0..36).flat_map(|k| [f64::from(k / 6), f64::from(k / 6), 0.0]).collect();
    let nodes = Nodes::strided(nodes, 6, 6, 0, 0).unwrap();
    let grid = Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap();
    let line = Carcass::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
    for angle in [0.0, 0.3, FRAC_PI_2] {
        assert_eq!(line.nearest_angle(DVec3::new(0.3, 0.2, 1.0), angle, false, &job).unwrap(), None);
    }
}

#[test]
fn a_cell_is_unresolved_once() {
    let job = Job::default();
    let nodes: Vec<f64> = (0..36).flat_map(|k| [f64::from(k / 6), f64::from(k / 6), 0.0]).collect();
    let nodes = Nodes::strided(nodes, 6, 6, 0, 0).unwrap();
    let grid = Grid::new(nodes, [false; 2], Scheme::FourPoint).unwrap();
    let line = Carcass::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
    // No angle of any cell can be told.
    let angles: Vec<f64> = (1..20).map(|k| 0.1 * f64::from(k)).collect();
    let paths = line.isophotes(DVec3::Z, &angles, false, Between::Auto, &job).unwrap();
    let mut cells: Vec<_> = paths.unresolved.iter().map(|place| (place.sheet, place.cell)).collect();
    cells.sort_unstable();
    assert_eq!(cells.len(), 25);
    cells.dedup();
    assert_eq!(cells.len(), 25);
}
