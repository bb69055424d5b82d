//! The errata of the paper's search, E1 to E8: each counterexample is lost by the rule to the
//! letter and kept by the corrected one.

use crate::halving::cells_within;
use crate::literal::literal;
use crate::shapes::{Random, torus};
use glam::DVec3;
use gusset::Job;
use gusset::surface::reference::{
    AngleTarget, CellGridShape, Diameters, PointPlaneOrLine, SearchGoal, SearchOptions, SearchOutcome, curvature_bound,
    find_cells_near_object, find_cells_with_angle, normal_variation_by_curvature,
};
use gusset::surface::{Grid, Nodes, Patches, Scheme, Sheet};
use std::f64::consts::{FRAC_PI_2, PI};

/// A sheet through nodes given by a function.
fn sheet(cells: [usize; 2], closed: [bool; 2], node: impl Fn(usize, usize) -> DVec3) -> Sheet<'static> {
    let [h, w] = cells;
    let at = |k: usize, n: usize, closed: bool| if closed { k % n } else { k };
    let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j)));
    let data: Vec<f64> = nodes.flat_map(|(i, j)| node(at(i, h, closed[0]), at(j, w, closed[1])).to_array()).collect();
    let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
    Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap).unwrap())
}

/// The study's surface of the errata: 101 x 101 nodes.
fn bumpy(n: usize) -> Sheet<'static> {
    sheet([n, n], [true, true], |i, j| torus(i as f64 / n as f64, j as f64 / n as f64, 0.15))
}

fn all_cells(lattice: CellGridShape) -> impl Iterator<Item = [usize; 2]> {
    (0..lattice.len()).map(move |k| lattice.cell(k))
}

fn corner_distances(sheet: &Sheet<'_>, [i, j]: [usize; 2], point: DVec3, normal: DVec3) -> [f64; 4] {
    [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| (sheet.corner(i, j) - point).dot(normal))
}

fn within(sheet: &Sheet<'_>, diameters: &Diameters, object: PointPlaneOrLine, tau: f64) -> SearchOutcome {
    find_cells_near_object(sheet, diameters, object, &SearchOptions::new(SearchGoal::Within(tau)), &Job::default())
        .unwrap()
}

/// E1, the strip: cells 1 x 0.01, the plane x = 0.5, visits at x = -3 and x = 4 zero all four
/// corners of the cells that it crosses.
#[test]
fn e1_nodes_on_rims_are_corners_outside() {
    let strip = sheet([7, 3], [false; 2], |i, j| DVec3::new(i as f64 - 3.0, 0.01 * j as f64, 0.0));
    let diameters = Diameters::new(&strip, &Job::default()).unwrap();
    let d = diameters.euclidean.largest_bound();
    assert!((d - 1.0_f64.hypot(0.01)).abs() < 1e-12, "{d}");
    let object = PointPlaneOrLine::Plane { point: DVec3::new(0.5, 0.0, 0.0), normal: DVec3::X };
    let target = object.as_orthonormal_box().unwrap();
    let lattice = CellGridShape::new(&strip);
    let left = literal(lattice, d, |[i, j]| target.distance(strip.corner(i, j)), false);
    assert!((0..3).all(|j| !left.has_cell([3, j])), "the literal rule keeps what it is known to lose");
    let found = within(&strip, &diameters, object, 0.0);
    assert!((0..3).all(|j| found.possible_cells.get([3, j])));
}

/// E1 on a closed surface with random planes: many lose cells to the rule as written, none to the
/// corrected one.
#[test]
fn e1_random_planes() {
    let bumpy = bumpy(100);
    let diameters = Diameters::new(&bumpy, &Job::default()).unwrap();
    let d = diameters.euclidean.largest_bound();
    let lattice = CellGridShape::new(&bumpy);
    let mut random = Random(1);
    let (mut planes, mut lost, mut crossing) = (0, 0, 0);
    for _ in 0..200 {
        let (point, normal) = (random.point(0.8), random.point(1.0).normalize());
        let distance = |[i, j]: [usize; 2]| (bumpy.corner(i, j) - point).dot(normal).abs();
        let left = literal(lattice, d, distance, false);
        let found = within(&bumpy, &diameters, PointPlaneOrLine::Plane { point, normal }, 0.0);
        let mut own = 0;
        for cell in all_cells(lattice) {
            let corners = corner_distances(&bumpy, cell, point, normal);
            if corners.iter().any(|&x| x > 0.0) && corners.iter().any(|&x| x < 0.0) {
                crossing += 1;
                own += usize::from(!left.has_cell(cell));
                assert!(found.possible_cells.get(cell), "{cell:?}");
            }
        }
        (planes, lost) = (planes + usize::from(own > 0), lost + own);
    }
    println!("{planes} of 200 planes lose {lost} of {crossing} crossing cells");
    assert!(planes > 30 && lost >= planes);
}

/// E2: with r = J d exactly, the block touches the object.
#[test]
fn e2_blocks_must_not_touch() {
    // Cells that are segments of length 1: their diameters are exact.
    let line = sheet([6, 1], [false; 2], |i, _| DVec3::new(i as f64, 0.0, 0.0));
    let diameters = Diameters::new(&line, &Job::default()).unwrap();
    assert!((diameters.euclidean.largest_bound() - 1.0).abs() < 1e-12);
    let object = PointPlaneOrLine::Point(DVec3::new(3.0, 0.0, 0.0));
    let target = object.as_orthonormal_box().unwrap();
    let left = literal(CellGridShape::new(&line), 1.0, |[i, j]| target.distance(line.corner(i, j)), false);
    // The node is at the point, and zeroed by the first one.
    assert!(!left.has_node([3, 0]) && target.distance(line.corner(3, 0)) == 0.0);
    let found = within(&line, &diameters, object, 0.0);
    assert!(found.possible_cells.get([2, 0]) && found.possible_cells.get([3, 0]));
    // With tau: J = ceil((r - tau) / d) - 1.
    let found = within(&line, &diameters, object, 1.0);
    assert!((1..5).all(|i| found.possible_cells.get([i, 0])) && !found.possible_cells.get([0, 0]));
}

/// E3: the nearest node excludes itself if it is farther than d.
#[test]
fn e3_the_rule_does_not_find_the_nearest() {
    let bumpy = bumpy(100);
    let diameters = Diameters::new(&bumpy, &Job::default()).unwrap();
    let lattice = CellGridShape::new(&bumpy);
    let [rows, columns] = lattice.lines();
    let mut random = Random(3);
    let mut lost = 0;
    for _ in 0..500 {
        let query = random.point(1.5);
        let distance = |[i, j]: [usize; 2]| bumpy.corner(i, j).distance(query);
        let nodes = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
        let nearest = nodes.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
        let left = literal(lattice, diameters.euclidean.largest_bound(), distance, false);
        lost += usize::from(!left.has_node(nearest));
        let options = SearchOptions::new(SearchGoal::Least);
        let found =
            find_cells_near_object(&bumpy, &diameters, PointPlaneOrLine::Point(query), &options, &Job::default())
                .unwrap();
        assert_eq!(found.nearest_node_and_distance.1, distance(nearest));
    }
    println!("{lost} of 500 nearest nodes lost");
    assert!(lost > 350, "{lost}");
}

/// E4: at an angle other than 0 the rule compares the wrong thing; the deviation from the angle is
/// right.
#[test]
fn e4_angles() {
    let job = Job::default();
    let ring = sheet([100, 100], [true, true], |i, j| torus(i as f64 / 100.0, j as f64 / 100.0, 0.0));
    let diameters = Diameters::new(&ring, &job).unwrap();
    let curvature = curvature_bound(&ring, &job).unwrap();
    let variation = normal_variation_by_curvature(&ring, &diameters, curvature, &job).unwrap();
    let lattice = CellGridShape::new(&ring);
    let mut random = Random(4);
    let mut lost = 0;
    for _ in 0..10 {
        let target = AngleTarget { direction: random.point(1.0), angle: FRAC_PI_2, unsigned: false };
        let truth = target.normalized().unwrap();
        let normal = |i: usize, j: usize| ring.normal(i % 100, j % 100, 0.0, 0.0);
        // As the paper has it: the angle with the direction itself, and K d.
        let phi = |[i, j]: [usize; 2]| normal(i, j).dot(truth.direction).clamp(-1.0, 1.0).acos();
        let left = literal(lattice, variation.largest_bound(), phi, false);
        let found =
            find_cells_with_angle(&ring, &variation, target, &SearchOptions::new(SearchGoal::Within(0.0)), &job)
                .unwrap();
        for cell in all_cells(lattice) {
            let [i, j] = cell;
            let corners = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| phi([i, j]) - FRAC_PI_2);
            if corners.iter().any(|&x| x > 0.0) && corners.iter().any(|&x| x < 0.0) {
                lost += usize::from(!left.has_cell(cell));
                assert!(found.possible_cells.get(cell));
            }
        }
    }
    println!("{lost} crossing cells lost");
    assert!(lost > 100, "{lost}");
    // Without sign, the nearer of both.
    let target = AngleTarget { direction: DVec3::Z, angle: 0.2, unsigned: true };
    assert!((target.deviation(-DVec3::Z) - 0.2).abs() < 1e-15);
    assert!((AngleTarget { unsigned: false, ..target }.deviation(-DVec3::Z) - (PI - 0.2)).abs() < 1e-15);
}

/// E5: lines dropped where the block does not reach from side to side, or in the middle.
#[test]
fn e5_lines_that_must_not_be_dropped() {
    // A comb: columns far apart, so that a block in the first ones says nothing of the last.
    let wide = sheet([6, 4], [false; 2], |i, j| DVec3::new(i as f64, 1.0 * j as f64, 0.0));
    let diameters = Diameters::new(&wide, &Job::default()).unwrap();
    let d = diameters.euclidean.largest_bound();
    let object = PointPlaneOrLine::Point(DVec3::new(0.2, 4.0, 0.0));
    let target = object.as_orthonormal_box().unwrap();
    let distance = |[i, j]: [usize; 2]| target.distance(wide.corner(i, j));
    let lattice = CellGridShape::new(&wide);
    // From the first node: r = 4.004, d = sqrt 2, J = 2, 2 J = 4: within the dimension. A lower d,
    // as for cells without width, exceeds it.
    let left = literal(lattice, 1.0, distance, true);
    assert!(!left.has_cell([0, 3]));
    let found = within(&wide, &diameters, object, 0.0);
    assert!(found.possible_cells.get([0, 3]) && d > 1.0);

    // A strip that turns back: a block amid it is dropped, and the two ends, taken for neighbours,
    // exclude each other.
    let strip = sheet([40, 1], [false; 2], |i, j| {
        let x = if i <= 20 { i as f64 } else { 40.0 - i as f64 };
        DVec3::new(x, 0.0, 0.001 * j as f64 + if i <= 20 { 0.0 } else { 0.5 })
    });
    let diameters = Diameters::new(&strip, &Job::default()).unwrap();
    let d = diameters.euclidean.largest_bound();
    let mut random = Random(5);
    let (mut lost, mut dropped, lattice) = (0, 0, CellGridShape::new(&strip));
    for _ in 0..100 {
        let point = DVec3::new(20.0 * random.next(), 0.0, 0.0);
        let object = PointPlaneOrLine::Plane { point, normal: DVec3::X };
        let distance = |[i, j]: [usize; 2]| (strip.corner(i, j).x - point.x).abs();
        let left = literal(lattice, d, distance, true);
        let found = within(&strip, &diameters, object, 0.0);
        let plain = SearchOptions { drop_lines: false, ..SearchOptions::new(SearchGoal::Within(0.0)) };
        let plain = find_cells_near_object(&strip, &diameters, object, &plain, &Job::default()).unwrap();
        // Dropping lines spares nothing else.
        assert_eq!(found.possible_cells, plain.possible_cells);
        dropped += found.dropped;
        for cell in all_cells(lattice) {
            let corners = corner_distances(&strip, cell, point, DVec3::X);
            if corners.iter().any(|&x| x > 0.0) && corners.iter().any(|&x| x < 0.0) {
                lost += usize::from(!left.has_cell(cell));
                assert!(found.possible_cells.get(cell));
            }
        }
    }
    assert!(lost > 0 && dropped > 0, "{lost} {dropped}");
    // The negative answer at once: the first node excludes all.
    let far = within(&strip, &diameters, PointPlaneOrLine::Point(DVec3::new(0.0, 1e4, 0.0)), 0.0);
    assert_eq!((far.possible_cells.count(), far.evaluations, far.blocks), (0, 1, 1));
}

/// A patch over the unit square, flat at its edge, with a bump of height about `height` inside.
fn bump(height: f64) -> Sheet<'static> {
    let mut points = Vec::new();
    for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
        let inside = (1..3).contains(&a) && (1..3).contains(&b);
        let z = if inside { 16.0 / 9.0 * height } else { 0.0 };
        points.push(DVec3::new(f64::from(a) / 3.0, f64::from(b) / 3.0, z));
    }
    Sheet::Cubic(Patches::new(&points, [3, 3], 1, 1).unwrap())
}

/// E6: a bump may hide in a cell; half the perimeter does not bound its diameter.
#[test]
fn e6_half_the_perimeter_is_no_bound() {
    let bump = bump(10.0);
    let diameters = Diameters::new(&bump, &Job::default()).unwrap();
    let (top, corner) = (bump.jet(0, 0, 0.5, 0.5).point, bump.corner(0, 0));
    let half_perimeter = 2.0;
    assert!(top.distance(corner) > half_perimeter);
    assert!(diameters.euclidean.largest_bound() >= top.distance(corner));
    // With half the perimeter for d, the cell is excluded, and its top is lost.
    let object = PointPlaneOrLine::Point(top);
    let target = object.as_orthonormal_box().unwrap();
    let lattice = CellGridShape::new(&bump);
    let left = literal(lattice, half_perimeter, |[i, j]| target.distance(bump.corner(i, j)), false);
    assert!(!left.has_cell([0, 0]));
    assert!(within(&bump, &diameters, object, 0.0).possible_cells.get([0, 0]));
}

/// E7: a section may be a loop within one cell, cross a side twice, or touch; the signs at the
/// nodes do not show it.
#[test]
fn e7_what_signs_at_nodes_do_not_show() {
    let bump = bump(1.0);
    let diameters = Diameters::new(&bump, &Job::default()).unwrap();
    let job = Job::default();
    let crossed = |point: DVec3, normal: DVec3| {
        cells_within(&bump, &diameters, PointPlaneOrLine::Plane { point, normal }, 0.0, 1e-9).count() == 1
    };
    // A loop: all corners are below.
    let loop_at = DVec3::new(0.5, 0.5, 0.5);
    assert!(corner_distances(&bump, [0, 0], loop_at, DVec3::Z).iter().all(|&x| x < 0.0));
    assert!(crossed(loop_at, DVec3::Z));
    // Touching at the top, and above it.
    let top = bump.jet(0, 0, 0.5, 0.5).point;
    assert!(crossed(top, DVec3::Z) && !crossed(top + 1e-6 * DVec3::Z, DVec3::Z));
    // A curved side, crossed twice, with all corners on one side.
    let mut points = Vec::new();
    for (a, b) in (0..3).flat_map(|a| (0..3).map(move |b| (a, b))) {
        let z = if a == 0 && b == 1 { 1.0 } else { 0.0 };
        points.push(DVec3::new(f64::from(a), f64::from(b), z));
    }
    let arch = Sheet::Cubic(Patches::new(&points, [2, 2], 1, 1).unwrap());
    let diameters = Diameters::new(&arch, &job).unwrap();
    let object = PointPlaneOrLine::Plane { point: DVec3::new(0.0, 0.0, 0.25), normal: DVec3::Z };
    assert!(corner_distances(&arch, [0, 0], DVec3::new(0.0, 0.0, 0.25), DVec3::Z).iter().all(|&x| x < 0.0));
    assert_eq!(cells_within(&arch, &diameters, object, 0.0, 1e-9).count(), 1);
}

/// E8: the Euclidean diameter suffices for distances, and excludes more.
#[test]
fn e8_euclidean_suffices() {
    let job = Job::default();
    // Every other row of nodes raised: cells are bent, and ways on the surface longer than chords.
    let folded =
        sheet([40, 40], [false; 2], |i, j| DVec3::new(i as f64, j as f64, 1.5 * if i % 4 == 0 { 1.0 } else { 0.0 }));
    let diameters = Diameters::new(&folded, &job).unwrap();
    let lattice = CellGridShape::new(&folded);
    assert!(diameters.euclidean.values().iter().zip(diameters.intrinsic.values()).all(|(chord, way)| chord <= way));
    assert!(diameters.euclidean.largest_bound() < 0.95 * diameters.intrinsic.largest_bound());
    let long_way = Diameters { euclidean: diameters.intrinsic.clone(), intrinsic: diameters.intrinsic.clone() };
    let mut random = Random(8);
    let mut evaluations = [0, 0];
    for _ in 0..20 {
        let object = PointPlaneOrLine::Plane { point: 20.0 + random.point(20.0), normal: random.point(1.0) };
        let [chord, way] = [&diameters, &long_way].map(|diameters| within(&folded, diameters, object, 0.0));
        evaluations = [evaluations[0] + chord.evaluations, evaluations[1] + way.evaluations];
        let exact = cells_within(&folded, &diameters, object, 0.0, 1e-9);
        for cell in all_cells(lattice).filter(|&cell| exact.get(cell)) {
            assert!(chord.possible_cells.get(cell) && way.possible_cells.get(cell));
        }
    }
    assert!(evaluations[0] < evaluations[1], "{evaluations:?}");
}
