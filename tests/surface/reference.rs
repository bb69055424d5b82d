//! The theorems behind the paper's search, by brute force on surfaces without any regularity, and
//! cell regions.

use crate::common::Silent;
use crate::shapes::{Random, SHAPES, curvatures, grid, rough};
use glam::DVec3;
use gusset::surface::line_intersection::Line;
use gusset::surface::reference::{
    AngleTarget, CellBoundSum, CellGridShape, CellMask, CellSizeBounds, Diameters, PointPlaneOrLine, SearchGoal,
    SearchOptions, curvature_bound, find_cells_near_object, find_cells_with_angle, normal_by_sections,
    normal_variation_by_cones, normal_variation_by_curvature,
};
use gusset::surface::{Grid, MAX_DEGREE, Nodes, Patches, Scheme, Sheet};
use gusset::{Error, Job, Progress};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

/// A mask with all bits 0.
pub(crate) fn empty(lattice: CellGridShape) -> CellMask {
    CellMask::from_words(lattice, &vec![0; lattice.len().div_ceil(64)]).unwrap()
}

/// Rough sheets, open and closed, of all kinds.
pub(crate) fn sheets() -> Vec<Sheet<'static>> {
    let of = |cells, closed, scheme, seed| Sheet::Grid(rough(cells, closed, scheme, seed));
    vec![
        of([7, 11], [false, false], Scheme::SixTap, 1),
        of([9, 6], [true, false], Scheme::SixTap, 2),
        of([8, 13], [true, true], Scheme::FourPoint, 3),
        of([1, 5], [false, false], Scheme::SixTap, 4),
        Sheet::Grid(grid(&SHAPES[3])),
        patches::<4>(5, 6, 3, 5),
        patches::<8>(4, 3, 7, 6),
    ]
}

/// Patches whose sides meet nearly only: each net is disturbed.
fn patches<const N: usize>(rows: usize, columns: usize, degree: usize, seed: u64) -> Sheet<'static>
where
    Patches<N>: IntoSheet,
{
    let (mut random, mut points) = (Random(seed), Vec::new());
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        for (a, b) in (0..=degree).flat_map(|a| (0..=degree).map(move |b| (a, b))) {
            let at = |k: usize, c: usize| (k as f64 + c as f64 / degree as f64) / 3.0;
            let inside = if a % degree == 0 || b % degree == 0 { 0.01 } else { 0.1 };
            points.push(DVec3::new(at(i, a), at(j, b), (3.0 * at(i, a)).sin()) + random.point(inside));
        }
    }
    Patches::<N>::new(&points, [degree; 2], rows, columns).unwrap().into_sheet()
}

trait IntoSheet {
    fn into_sheet(self) -> Sheet<'static>;
}

impl IntoSheet for Patches<4> {
    fn into_sheet(self) -> Sheet<'static> {
        Sheet::Cubic(self)
    }
}

impl IntoSheet for Patches<8> {
    fn into_sheet(self) -> Sheet<'static> {
        Sheet::High(self)
    }
}

pub(crate) fn cells(lattice: CellGridShape) -> impl Iterator<Item = [usize; 2]> {
    (0..lattice.len()).map(move |k| lattice.cell(k))
}

/// Points and unit normals all over a cell.
pub(crate) fn samples(sheet: &Sheet<'_>, [i, j]: [usize; 2]) -> Vec<(DVec3, DVec3)> {
    let places = (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0));
    places.map(|(u, v)| (sheet.jet(i, j, u, v).point, sheet.normal(i, j, u, v))).collect()
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

#[test]
fn diameters_bound_distances_and_lengths() {
    for sheet in sheets() {
        let found = Diameters::new(&sheet, &Job::default()).unwrap();
        assert_eq!(found, Diameters::new(&sheet, &Job::new(1, &Silent)).unwrap());
        for cell in cells(found.euclidean.lattice()) {
            let [euclidean, intrinsic] = [found.euclidean.get(cell), found.intrinsic.get(cell)];
            let points = samples(&sheet, cell);
            for (a, _) in &points {
                assert!(points.iter().all(|(b, _)| a.distance(*b) <= euclidean));
            }
            // Straight in the parameters from corner to corner and from side to side: no path of
            // these is longer than the bound.
            for (a, b) in [((0.0, 0.0), (1.0, 1.0)), ((1.0, 0.0), (0.0, 1.0)), ((0.0, 0.3), (1.0, 0.8))] {
                let at = |t: f64| sheet.jet(cell[0], cell[1], a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)).point;
                let length: f64 = (0..50).map(|k| at(f64::from(k) / 50.0).distance(at(f64::from(k + 1) / 50.0))).sum();
                assert!(length <= intrinsic, "{length} {intrinsic}");
            }
            // Not too large either: no more than the control net allows.
            let widest = points.iter().flat_map(|a| points.iter().map(move |b| a.0.distance(b.0))).fold(0.0, f64::max);
            assert!(euclidean <= 6.0 * widest && intrinsic <= 12.0 * widest, "{euclidean} {intrinsic} {widest}");
        }
        assert_eq!(found.euclidean.largest_bound(), found.euclidean.values().iter().copied().fold(0.0, f64::max));
    }
}

/// T1: no point of a block is farther from its node than the sum of rings, and that is no more than
/// J d.
#[test]
fn blocks_stay_within_their_sums() {
    for sheet in sheets() {
        let sizes = Diameters::new(&sheet, &Job::default()).unwrap().euclidean;
        let variation = normal_variation_by_cones(&sheet, &Job::default()).unwrap();
        let lattice = sizes.lattice();
        let [rows, columns] = lattice.lines();
        let mut random = Random(5);
        for _ in 0..12 {
            let node = [rows, columns].map(|n| (random.next() * n as f64) as usize);
            let steps = 1 + (random.next() * 4.0) as usize;
            let from = sheet.corner(node[0], node[1]);
            let reach = sizes.sum_of_largest_ring_bounds(node, steps);
            assert!(reach <= steps as f64 * sizes.largest_bound() * (1.0 + 1e-12));
            let normal = normal_at(&sheet, node);
            for cell in block(lattice, node, steps) {
                for (point, there) in samples(&sheet, cell) {
                    assert!(point.distance(from) <= reach);
                    assert!(angle(normal, there) <= variation.sum_of_largest_ring_bounds(node, steps) + 1e-12);
                }
            }
            // The largest block within a limit: one more step would be too much.
            for sum in [CellBoundSum::Greatest, CellBoundSum::Rings] {
                let limit = 3.0 * random.next();
                let (most, reach) = sizes.max_steps_within_distance(node, limit, sum);
                assert!(reach < limit || most == 0);
                let bound = |steps: usize| match sum {
                    CellBoundSum::Greatest => steps as f64 * sizes.largest_bound() * (1.0 + 1e-14),
                    CellBoundSum::Rings => sizes.sum_of_largest_ring_bounds(node, steps),
                };
                let longest = lattice.cells[0].max(lattice.cells[1]);
                assert!(most == longest || bound(most + 1) * (1.0 + 1e-13) >= limit, "{most} {limit}");
            }
        }
    }
}

fn normal_at(sheet: &Sheet<'_>, [i, j]: [usize; 2]) -> DVec3 {
    let [rows, columns] = sheet.cells();
    let of = |at: usize, count: usize| if at < count { (at, 0.0) } else { (count - 1, 1.0) };
    let ((i, u), (j, v)) = (of(i, rows), of(j, columns));
    sheet.normal(i, j, u, v)
}

/// The cells of a block as the paper has it.
fn block(lattice: CellGridShape, node: [usize; 2], steps: usize) -> Vec<[usize; 2]> {
    let line = |k: usize| {
        let count = lattice.cells[k] as i64;
        let near = (0..count).filter(move |&c| {
            let off = (-1..=1).map(|turn| c - node[k] as i64 + if lattice.closed[k] { turn * count } else { 0 });
            off.into_iter().any(|off| off >= -(steps as i64) && off < steps as i64)
        });
        near.map(|c| c as usize).collect::<Vec<_>>()
    };
    let columns = line(1);
    line(0).into_iter().flat_map(|i| columns.iter().map(move |&j| [i, j])).collect()
}

/// All ways to search.
fn ways(goal: SearchGoal) -> Vec<SearchOptions> {
    let mut ways = Vec::new();
    for k in 0..8 {
        let sum = if k & 1 == 0 { CellBoundSum::Greatest } else { CellBoundSum::Rings };
        ways.push(SearchOptions { sum, by_rows: k & 2 != 0, drop_lines: k & 4 != 0, ..SearchOptions::new(goal) });
    }
    ways
}

/// T2: no cell with a point within tau is lost, for any object and order.
#[test]
fn nothing_within_reach_is_lost() {
    let mut spared = [0, 0];
    for (s, sheet) in sheets().into_iter().enumerate() {
        let diameters = Diameters::new(&sheet, &Job::default()).unwrap();
        let lattice = CellGridShape::new(&sheet);
        let [rows, columns] = lattice.lines();
        let samples: Vec<_> = cells(lattice).map(|cell| samples(&sheet, cell)).collect();
        let mut random = Random(s as u64);
        for k in 0..24 {
            let (point, direction) = (random.point(1.5), random.point(1.0));
            let object = match k % 4 {
                0 => PointPlaneOrLine::Point(point),
                1 => PointPlaneOrLine::Plane { point, normal: direction },
                2 => PointPlaneOrLine::Line(Line::new(point, direction)),
                _ => PointPlaneOrLine::Line(Line::segment(point, point + direction)),
            };
            let tau = if k % 3 == 0 { 0.0 } else { 0.3 * random.next() };
            let truth = object.as_orthonormal_box().unwrap();
            let mut least = usize::MAX;
            for options in ways(SearchGoal::Within(tau)) {
                let found = find_cells_near_object(&sheet, &diameters, object, &options, &Job::default()).unwrap();
                for cell in cells(lattice) {
                    let near = samples[lattice.index(cell)].iter().any(|(point, _)| truth.distance(*point) <= tau);
                    assert!(!near || found.possible_cells.get(cell), "{object:?} {options:?} {cell:?}");
                }
                assert!(found.evaluations <= (rows * columns) as u64);
                spared[0] += found.evaluations;
                spared[1] += (rows * columns) as u64;
                least = least.min(found.possible_cells.count());
                assert_eq!(found.possible_cells.cells().count(), found.possible_cells.count());
            }
            // The negative answer.
            if least == 0 && tau > 0.0 {
                assert!(samples.iter().flatten().all(|(point, _)| truth.distance(*point) > tau));
            }
        }
    }
    assert!(spared[0] < spared[1], "{spared:?}");
}

/// T3: the nearest node is recorded, and no cell with anything nearer is lost.
#[test]
fn the_nearest_is_kept() {
    for (s, sheet) in sheets().into_iter().enumerate() {
        let diameters = Diameters::new(&sheet, &Job::default()).unwrap();
        let lattice = CellGridShape::new(&sheet);
        let [rows, columns] = lattice.lines();
        let nodes = || (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
        let samples: Vec<_> = cells(lattice).map(|cell| samples(&sheet, cell)).collect();
        let mut random = Random(s as u64 + 50);
        for k in 0..20 {
            let query = random.point(if k % 2 == 0 { 1.5 } else { 30.0 });
            let distance = |node: [usize; 2]| sheet.corner(node[0], node[1]).distance(query);
            let nearest = nodes().min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
            for options in ways(SearchGoal::Least) {
                let found = find_cells_near_object(
                    &sheet,
                    &diameters,
                    PointPlaneOrLine::Point(query),
                    &options,
                    &Job::default(),
                )
                .unwrap();
                assert_eq!(found.nearest_node_and_distance.1, distance(nearest), "{options:?}");
                for cell in cells(lattice) {
                    let near = &samples[lattice.index(cell)];
                    let nearer =
                        near.iter().any(|(point, _)| point.distance(query) < found.nearest_node_and_distance.1);
                    assert!(!nearer || found.possible_cells.get(cell), "{options:?} {cell:?}");
                }
            }
        }
    }
}

/// T4: no cell with a normal within phi of the angle is lost, by cones and by curvature.
#[test]
fn normals_at_an_angle_are_kept() {
    for shape in &SHAPES[..3] {
        let sheet = Sheet::Grid(grid(shape));
        let (lattice, job) = (CellGridShape::new(&sheet), Job::default());
        let diameters = Diameters::new(&sheet, &job).unwrap();
        let curvature = curvature_bound(&sheet, &job).unwrap();
        assert!(curvature.is_finite(), "{}", shape.name);
        let cones = normal_variation_by_cones(&sheet, &job).unwrap();
        let bent = normal_variation_by_curvature(&sheet, &diameters, curvature, &job).unwrap();
        let samples: Vec<_> = cells(lattice).map(|cell| samples(&sheet, cell)).collect();
        assert!(cones.largest_bound() < bent.largest_bound(), "{} {}", cones.largest_bound(), bent.largest_bound());
        let mut random = Random(3);
        let mut left = [0, 0];
        for k in 0..8 {
            let angle = if k % 2 == 0 { 0.5 * PI } else { PI * random.next() };
            let target = AngleTarget { direction: random.point(1.0), angle, unsigned: k % 3 == 0 };
            let truth = target.normalized().unwrap();
            let least = |samples: &Vec<(DVec3, DVec3)>| {
                samples.iter().map(|(_, normal)| truth.deviation(*normal)).fold(PI, f64::min)
            };
            let least: Vec<_> = samples.iter().map(least).collect();
            for (which, variation) in [&cones, &bent].into_iter().enumerate() {
                for options in ways(SearchGoal::Within(0.02)) {
                    let found = find_cells_with_angle(&sheet, variation, target, &options, &job).unwrap();
                    left[which] += found.possible_cells.count();
                    for cell in cells(lattice) {
                        let near = least[lattice.index(cell)] <= 0.02;
                        assert!(!near || found.possible_cells.get(cell), "{} {target:?} {cell:?}", shape.name);
                    }
                }
            }
        }
        // Cones are tighter.
        assert!(left[0] < left[1], "{left:?}");
    }
}

/// The bound of the curvatures holds everywhere, and for fine nets it is near the truth.
#[test]
fn curvatures_are_bounded() {
    let bound_of = |n: usize| {
        let shape = crate::shapes::Shape { name: "", cells: [n, 2 * n], closed: [true, true], point: SHAPES[0].point };
        let sheet = Sheet::Grid(grid(&shape));
        let bound = curvature_bound(&sheet, &Job::default()).unwrap();
        for cell in cells(CellGridShape::new(&sheet)).step_by(7) {
            let jet = sheet.jet(cell[0], cell[1], 0.3, 0.8);
            let (mean, gauss) = curvatures(&jet).unwrap();
            assert!(mean.abs() + (mean * mean - gauss).max(0.0).sqrt() <= bound);
        }
        bound
    };
    // The tube's is 1 / 0.4.
    let [coarse, fine] = [bound_of(16), bound_of(128)];
    assert!((2.5..4.5).contains(&fine) && fine < coarse, "{coarse} {fine}");
    // A pole is not regular.
    assert_eq!(curvature_bound(&Sheet::Grid(grid(&SHAPES[3])), &Job::default()), Ok(f64::INFINITY));
}

/// The normal by two sections is of third order, as the derivative of a cubic through four points
/// is.
#[test]
fn normals_by_sections_are_of_third_order() {
    let error = |n: usize| {
        let shape = crate::shapes::Shape { name: "", cells: [n, 2 * n], closed: [true, true], point: SHAPES[0].point };
        let sheet = Sheet::Grid(grid(&shape));
        let mut worst = 0.0_f64;
        for k in 0..300 {
            let (i, j) = (k * 7 % n, k * 11 % (2 * n));
            let (s, t) = (f64::from((k % 5) as u32) / 4.0, f64::from((k % 7) as u32) / 6.0);
            let (u, v) = (TAU * (i as f64 + s) / n as f64, TAU * (j as f64 + t) / (2 * n) as f64);
            // The side of S_u x S_v, which look inwards here.
            let truth = -DVec3::new(u.cos() * v.cos(), u.cos() * v.sin(), u.sin());
            worst = worst.max(angle(normal_by_sections(&sheet, [i, j], s, t).unwrap(), truth));
        }
        worst
    };
    let errors = [16, 32, 64, 128].map(error);
    println!("{errors:?}");
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1]).log2() > 2.7, "{errors:?}");
    }
}

#[test]
fn normals_by_sections_anywhere() {
    for sheet in sheets() {
        let [rows, columns] = sheet.cells();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            for (u, v) in [(0.0, 0.0), (0.5, 0.4), (1.0, 1.0)] {
                let normal = normal_by_sections(&sheet, [i, j], u, v).unwrap();
                assert!(normal == DVec3::ZERO || (normal.length() - 1.0).abs() < 1e-12);
            }
        }
        assert!(normal_by_sections(&sheet, [rows, 0], 0.0, 0.0).is_err());
        assert!(normal_by_sections(&sheet, [0, 0], f64::NAN, 0.0).is_err());
    }
}

#[test]
fn what_is_refused() {
    let sheet = Sheet::Grid(grid(&SHAPES[2]));
    let job = Job::default();
    let diameters = Diameters::new(&sheet, &job).unwrap();
    let ask = |object, goal| find_cells_near_object(&sheet, &diameters, object, &SearchOptions::new(goal), &job);
    let nan = DVec3::splat(f64::NAN);
    for object in [
        PointPlaneOrLine::Point(nan),
        PointPlaneOrLine::Plane { point: nan, normal: DVec3::X },
        PointPlaneOrLine::Plane { point: DVec3::X, normal: DVec3::ZERO },
        PointPlaneOrLine::Line(Line::new(DVec3::ZERO, DVec3::ZERO)),
        PointPlaneOrLine::Line(Line { from: 2.0, ..Line::segment(DVec3::ZERO, DVec3::X) }),
        PointPlaneOrLine::Line(Line { from: f64::NAN, ..Line::segment(DVec3::ZERO, DVec3::X) }),
    ] {
        assert!(matches!(ask(object, SearchGoal::Least), Err(Error::OptionOutOfRange { .. })), "{object:?}");
    }
    for within in [-1.0, f64::NAN] {
        assert!(ask(PointPlaneOrLine::Point(DVec3::ZERO), SearchGoal::Within(within)).is_err());
    }
    assert!(normal_variation_by_curvature(&sheet, &diameters, f64::NAN, &job).is_err());
    let variation = normal_variation_by_cones(&sheet, &job).unwrap();
    for (direction, angle) in [(DVec3::ZERO, 0.0), (nan, 0.0), (DVec3::X, -0.1), (DVec3::X, 4.0), (DVec3::X, f64::NAN)]
    {
        let target = AngleTarget { direction, angle, unsigned: false };
        assert!(
            find_cells_with_angle(&sheet, &variation, target, &SearchOptions::new(SearchGoal::Least), &job).is_err()
        );
    }
    assert!(CellMask::from_words(CellGridShape::new(&sheet), &[0]).is_err());
    // Cancelled at once.
    struct Stop;
    impl Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    assert_eq!(Diameters::new(&sheet, &Job::new(1, &Stop)).unwrap_err(), Error::Cancelled);
}

/// A sheet of size 1e-9 or 1e9, or far away from the origin, is searched as well.
#[test]
fn bounds_hold_at_any_size_and_place() {
    assert_eq!(MAX_DEGREE, 7);
    for (scale, offset) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)] {
        let shape = &SHAPES[1];
        let [h, w] = shape.cells;
        let at = |k: usize| {
            let (i, j) = (k / (w + 1), k % (w + 1));
            scale * (shape.point)((i % h) as f64 / h as f64, (j % w) as f64 / w as f64) + offset
        };
        let data: Vec<f64> = (0..(h + 1) * (w + 1)).flat_map(|k| at(k).to_array()).collect();
        let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
        let sheet = Sheet::Grid(Grid::new(nodes, [true, true], Scheme::SixTap).unwrap());
        let diameters = Diameters::new(&sheet, &Job::default()).unwrap();
        let object = PointPlaneOrLine::Plane { point: DVec3::splat(offset), normal: DVec3::new(1.0, 2.0, 3.0) };
        let options = SearchOptions::new(SearchGoal::Within(0.0));
        let found = find_cells_near_object(&sheet, &diameters, object, &options, &Job::default()).unwrap();
        let crossing = cells(CellGridShape::new(&sheet)).filter(|&cell| {
            let PointPlaneOrLine::Plane { point, normal } = object else { unreachable!() };
            let signs: Vec<_> = samples(&sheet, cell).iter().map(|(p, _)| (*p - point).dot(normal) > 0.0).collect();
            signs.iter().any(|&sign| sign != signs[0])
        });
        let count = crossing.inspect(|&cell| assert!(found.possible_cells.get(cell))).count();
        assert!(count > 50 && found.possible_cells.count() < 6 * count, "{count} {}", found.possible_cells.count());
    }
}

/// One cell, collapsed to a point.
#[test]
fn degenerate_sheets() {
    for points in [vec![0.0; 12], vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]] {
        let nodes = Nodes::strided(points, 2, 2, 0, 0).unwrap();
        let sheet = Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap());
        let diameters = Diameters::new(&sheet, &Job::default()).unwrap();
        for goal in [SearchGoal::Least, SearchGoal::Within(0.5)] {
            for options in ways(goal) {
                let object = PointPlaneOrLine::Point(DVec3::new(0.0, 0.0, 3.0));
                let found = find_cells_near_object(&sheet, &diameters, object, &options, &Job::default()).unwrap();
                assert_eq!(found.nearest_node_and_distance.1, 3.0);
                assert_eq!(found.possible_cells.count(), usize::from(goal == SearchGoal::Least));
            }
        }
        let variation: CellSizeBounds = normal_variation_by_cones(&sheet, &Job::default()).unwrap();
        assert_eq!(variation.largest_bound(), PI);
        assert_eq!(normal_by_sections(&sheet, [0, 0], 0.5, 0.5), Ok(DVec3::ZERO));
    }
}
