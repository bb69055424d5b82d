//! Sections, contours and curves of angle: against fine sampling, against circles, and against what
//! closed surfaces demand.

use crate::common::Silent;
use crate::contours::{check, length, surface};
use crate::shapes::{Random, SHAPES, Shape, curvatures, grid, torus};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::{Grid, Nodes, Paths, Scheme, Sheet, Surface};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};

pub(crate) fn torus_of(cells: [usize; 2]) -> Surface<'static> {
    surface(&Shape { name: "torus", cells, closed: [true, true], point: |u, v| torus(u, v, 0.0) })
}

/// Connected parts of the zero set by marching over a very fine sampling of the surface: closed and
/// open ones.
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
    // Triangles: no saddles to decide. Edges are numbered by node and direction, and linked through
    // triangles.
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
    let (grid, surface) = (grid(shape), surface(shape));
    let job = Job::default();
    let mut random = Random(seed);
    let counts = |paths: &Paths| {
        let closed = paths.closed.iter().filter(|&&closed| closed).count();
        [closed, paths.len() - closed]
    };
    let mut total = 0;
    for k in 0..planes {
        let (point, normal) = (random.point(0.7), random.point(1.0));
        let paths = surface.section(&Planes { point, normal, levels: &[0.0] }, PointSpacing::Auto, &job).unwrap();
        check(&surface, &paths, shape.name);
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
        let paths = surface.isophotes(axis, &[angle], false, PointSpacing::Auto, &job).unwrap();
        check(&surface, &paths, shape.name);
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
pub(crate) fn off_torus(point: DVec3) -> f64 {
    let ring = (point.x * point.x + point.y * point.y).sqrt() - 1.0;
    ((ring * ring + point.z * point.z).sqrt() - 0.4).abs()
}

#[test]
fn circles_and_orders() {
    let job = Job::default();
    let mut errors = Vec::new();
    for h in [16, 32, 64] {
        let surface = torus_of([h, 2 * h]);
        let offsets = [-0.35, -0.1, 0.0, 0.2];
        let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, levels: &offsets };
        let chord = 1e-5;
        let paths = surface.section(&planes, PointSpacing::Chord(chord), &job).unwrap();
        check(&surface, &paths, "torus");
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
                // Chords are within the bound from the interpolant, and the interpolant is within
                // its bound from the torus.
                let middle = 0.5 * (*point + points[(i + 1) % points.len()]);
                worst[1] = worst[1].max((middle.truncate().length() - truth).abs());
            }
            let (found, circle) = (length(&paths, k), std::f64::consts::TAU * truth);
            assert!((found - circle).abs() < 1e-4 + 20.0 * worst[0], "{h} {k}: {found} {circle}");
        }
        assert!(worst[1] < 1.01 * chord + 10.0 * worst[0], "{h}: {worst:?}");
        // Tilted planes, the chords refined: points between the lines too.
        let tilted = Planes { point: DVec3::new(0.1, 0.0, 0.05), normal: DVec3::new(0.3, -0.2, 1.0), levels: &[0.0] };
        let paths = surface.section(&tilted, PointSpacing::Chord(1e-4), &job).unwrap();
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
            let surface = torus_of([h, 2 * h]);
            let paths = surface.isophotes(axis, &angles, false, PointSpacing::CellEdges, &job).unwrap();
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
        let surface = torus_of([h, 2 * h]);
        let nodes = (0..=h).flat_map(|i| (0..=2 * h).map(move |j| (i % h, j % (2 * h))));
        let values: Vec<f64> = nodes.map(|(i, j)| surface.sheet(0).normal(i, j, 0.0, 0.0).dot(axis)).collect();
        let paths = surface.contours(&values, &[1.1_f64.cos()], PointSpacing::CellEdges, &job).unwrap();
        let angle = |point: &DVec3| (point.truncate().normalize().extend(0.0) - *point).angle_between(axis);
        errors.push(paths.points.iter().map(|point| (angle(point) - 1.1).abs()).fold(0.0, f64::max));
    }
    println!("angles of contours of cosines at nodes: {errors:?}");
    assert!(errors.windows(2).all(|pair| (pair[0] / pair[1]).log2() >= 3.8), "{errors:?}");
}

#[test]
fn lines_of_the_surface_and_tangent_planes() {
    let job = Job::default();
    let surface = torus_of([20, 36]);
    // Planes through whole lines of nodes, exactly or nearly.
    for (normal, count) in [(DVec3::Z, 2), (DVec3::Y, 2), (DVec3::X, 2)] {
        for offset in [0.0, 1e-17, -1e-17, 1e-14] {
            let planes = Planes { point: DVec3::ZERO, normal, levels: &[offset] };
            let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
            check(&surface, &paths, "lines");
            assert_eq!(paths.len(), count, "{normal} {offset}");
            assert!(paths.closed.iter().all(|&closed| closed) && paths.unresolved.is_empty(), "{normal} {offset}");
        }
    }
    // Villarceau's circles: the plane touches the torus twice; and planes that touch it along a
    // circle, and once.
    let villarceau = DVec3::new(0.4, 0.0, (1.0_f64 - 0.16).sqrt());
    for (normal, offset) in [(villarceau, 0.0), (DVec3::Z, 0.4), (DVec3::X, 0.6), (DVec3::X, 1.4)] {
        for shift in [0.0, 1e-9, -1e-9, 1e-5, -1e-5, 1e-15] {
            let planes = Planes { point: DVec3::ZERO, normal, levels: &[offset + shift] };
            let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
            check(&surface, &paths, "tangent");
            assert!(paths.closed.iter().all(|&closed| closed), "{normal} {offset} {shift}");
        }
    }
    // A plane sheet in the plane itself.
    let flat: Vec<f64> = (0..30).flat_map(|k| [f64::from(k / 6), f64::from(k % 6), 0.25]).collect();
    let sheet = Grid::new(Nodes::strided(flat, 5, 6, 0, 0).unwrap(), [false; 2], Scheme::SixTap).unwrap();
    let surface = Surface::new(vec![Sheet::Grid(sheet)], None, &job).unwrap();
    let normal = DVec3::new(0.0, 0.0, 3.0);
    let paths =
        surface.section(&Planes { point: DVec3::ZERO, normal, levels: &[0.25] }, PointSpacing::Auto, &job).unwrap();
    assert_eq!((paths.len(), paths.unresolved.len()), (0, 20));
}

#[test]
fn loops_round_every_summit() {
    let (shape, job) = (&SHAPES[2], Job::default());
    let surface = surface(shape);
    let tops = surface.isophotes(DVec3::Z, &[0.0], false, PointSpacing::Auto, &job).unwrap();
    check_points(&surface, &tops);
    assert!(tops.len() > 3 && tops.unresolved.is_empty(), "{tops:?}");
    let mut loops = 0;
    for &top in &tops.points {
        // A little below a summit, above a pit: a closed curve round it, within a cell; or none, at
        // saddles.
        for shift in [-1e-8, 1e-8] {
            let planes = Planes { point: top, normal: DVec3::Z, levels: &[shift] };
            let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
            let near = |k: &usize| paths.points_of(*k).iter().all(|point| point.distance(top) < 1e-3);
            let small: Vec<usize> = (0..paths.len()).filter(near).collect();
            loops += small.len();
            assert!(small.iter().all(|&k| paths.closed[k]));
        }
    }
    // Summits and pits outnumber saddles, or are as many, on such a sheet.
    let curved = tops.places.iter().filter(|&&place| curvatures(&surface.jet(place)).unwrap().1 > 0.0).count();
    assert!(curved > 2 && loops == curved, "{loops} {curved} of {}", tops.len());
}

pub(crate) fn check_points(surface: &Surface<'_>, paths: &Paths) {
    assert!(paths.ends.windows(2).all(|pair| pair[1] == pair[0] + 1));
    for (&place, &point) in paths.places.iter().zip(&paths.points) {
        assert!(surface.jet(place).point.distance(point) < 1e-13);
        assert!(surface.normal(place).cross(DVec3::Z).length() < 1e-9);
    }
}

#[test]
fn contours_of_heights_are_sections() {
    let job = Job::default();
    for shape in &SHAPES {
        let (grid, surface) = (grid(shape), surface(shape));
        let nodes = grid.nodes();
        let all = (0..nodes.rows()).flat_map(|i| (0..nodes.columns()).map(move |j| (i, j)));
        let values: Vec<f64> = all.map(|(i, j)| nodes.get(i, j).z).collect();
        let levels = [-0.11, 0.017, 0.05, 0.1];
        let contours = surface.contours(&values, &levels, PointSpacing::Auto, &job).unwrap();
        let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, levels: &levels };
        let sections = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
        assert!(!sections.is_empty() && sections.ends == contours.ends && sections.levels == contours.levels);
        assert!(sections.points.iter().zip(&contours.points).all(|(a, b)| a.distance(*b) < 1e-12), "{}", shape.name);
        // Greater values to the left.
        for k in 0..contours.len() {
            let points = contours.points_of(k);
            let at = contours.ends[k] as usize;
            let (along, normal) = (points[1] - points[0], contours.normals[at]);
            let jet = surface.jet(contours.places[at]);
            let left = normal.cross(along);
            // The direction in the surface in which z rises.
            let rise = DVec3::Z - normal.z * normal;
            assert!(jet.point.distance(points[0]) < 1e-13 && left.dot(rise) > 0.0, "{} {k}", shape.name);
        }
    }
}

#[test]
fn stacks_threads_and_chains() {
    let surface = surface(&SHAPES[1]);
    let offsets: Vec<f64> = (0..9).map(|k| 0.11 * f64::from(k) - 0.5).collect();
    let (point, normal) = (DVec3::new(0.1, 0.2, 0.0), DVec3::new(1.0, 0.3, 0.4));
    let planes = Planes { point, normal, levels: &offsets };
    let one = surface.section(&planes, PointSpacing::Auto, &Job::new(1, &Silent)).unwrap();
    assert_eq!(one, surface.section(&planes, PointSpacing::Auto, &Job::new(3, &Silent)).unwrap());
    let angles = [0.3, 1.0, FRAC_PI_2, 3.0];
    let round = surface.isophotes(normal, &angles, false, PointSpacing::Auto, &Job::new(1, &Silent)).unwrap();
    assert_eq!(round, surface.isophotes(normal, &angles, false, PointSpacing::Auto, &Job::new(3, &Silent)).unwrap());
    // One by one.
    let mut count = 0;
    for (k, &offset) in offsets.iter().enumerate() {
        let single = Planes { point, normal, levels: &[offset] };
        let paths = surface.section(&single, PointSpacing::Auto, &Job::default()).unwrap();
        for own in 0..paths.len() {
            assert_eq!((one.levels[count], one.points_of(count)), (k as u32, paths.points_of(own)));
            count += 1;
        }
    }
    assert_eq!(count, one.len());
    // The paper's chains: nearer to the torus than the chords are.
    let surface = torus_of([30, 60]);
    let planes = Planes { point: DVec3::ZERO, normal: DVec3::Z, levels: &[0.1] };
    let chords = surface.section(&planes, PointSpacing::CellEdges, &Job::default()).unwrap();
    let cubics = surface.section(&planes, PointSpacing::Leus(1), &Job::default()).unwrap();
    assert_eq!(cubics.points.len(), 2 * chords.points.len());
    let middles = (0..chords.points_of(0).len() - 1).map(|k| 0.5 * (chords.points[k] + chords.points[k + 1]));
    let worst = |points: &mut dyn Iterator<Item = DVec3>| points.map(off_torus).fold(0.0, f64::max);
    let (linear, cubic) = (worst(&mut middles.clone()), worst(&mut cubics.points.iter().copied()));
    assert!(cubic < 0.02 * linear, "{cubic} {linear}");
}

#[test]
fn nearest_angles() {
    for shape in &SHAPES {
        let (grid, surface) = (grid(shape), surface(shape));
        let mut random = Random(4);
        for k in 0..6 {
            let (axis, unsigned) = (random.point(1.0).normalize(), k % 3 == 2);
            let angle = random.next() * if unsigned { FRAC_PI_2 } else { PI };
            let found = surface.nearest_angle(axis, angle, unsigned, &Job::default()).unwrap().unwrap();
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
