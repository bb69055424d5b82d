//! Leus's search over the points of a curve, and with curves and surfaces as objects: it keeps
//! every arc or cell that contains a solution.

use crate::shapes::{Random, SHAPES, grid};
use glam::DVec3;
use gusset::curve::{Curve, CurveView, Place};
use gusset::surface::line_intersection::Line;
use gusset::surface::reference::{
    AngleTarget, CellBoundSum, CurveArcs, Diameters, Figure, PointPlaneOrLine, SearchGoal, SearchOptions,
    find_cells_near_figure,
};
use gusset::surface::{Sheet, Surface};
use gusset::{Error, Job};

fn random_curve(random: &mut Random, closed: bool) -> Curve {
    let mut points = vec![random.point(1.5)];
    (0..15).for_each(|_| points.push(*points.last().unwrap() + random.point(0.4)));
    if closed {
        *points.last_mut().unwrap() = points[0];
    }
    CurveView::new(&points, &[0, 3, 4, 6, 11, 15], closed).unwrap().to_owned().unwrap()
}

/// Points of arc k, and tangents.
fn samples(curve: &Curve, parts: usize, k: usize) -> Vec<(DVec3, DVec3)> {
    let at = |n: usize| {
        let t = ((k % parts) as f64 + n as f64 / 8.0) / parts as f64;
        Place { segment: (k / parts) as u32, t: t.min(1.0) }
    };
    let places: Vec<Place> = (0..=8).map(at).collect();
    let (points, tangents) = (
        curve.view().points_at(&places, &Job::default()).unwrap(),
        curve.view().tangents_at(&places, &Job::default()).unwrap(),
    );
    points.into_iter().zip(tangents).collect()
}

fn options(goal: SearchGoal, k: usize) -> SearchOptions {
    let sum = if k.is_multiple_of(2) { CellBoundSum::Greatest } else { CellBoundSum::Rings };
    SearchOptions { sum, by_rows: k.is_multiple_of(3), drop_lines: k % 4 < 2, ..SearchOptions::new(goal) }
}

/// Random curves, open and closed, and all objects.
#[test]
fn no_arc_is_lost() {
    let (job, mut random) = (Job::default(), Random(3));
    let torus = Surface::new(vec![Sheet::Grid(grid(&SHAPES[0]))], None, &job).unwrap();
    let (mut kept, mut arcs_in_all, mut evaluations) = (0, 0, 0);
    for case in 0..120 {
        let (curve, other) = (random_curve(&mut random, case % 2 == 0), random_curve(&mut random, false));
        let parts = [1, 7, 40][case % 3];
        let arcs = CurveArcs::new(&curve.view(), parts, &job).unwrap();
        let (point, direction) = (random.point(2.0), random.point(1.0));
        let figure = match case % 6 {
            0 => Figure::Object(PointPlaneOrLine::Point(point)),
            1 => Figure::Object(PointPlaneOrLine::Plane { point, normal: direction }),
            2 => Figure::Object(PointPlaneOrLine::Line(Line::new(point, direction))),
            3 => Figure::Object(PointPlaneOrLine::Line(Line::ray(point, direction))),
            4 => Figure::Curve(other.view()),
            _ => Figure::Surface(&torus),
        };
        let distance = |p: DVec3| match figure {
            Figure::Object(object) => object.as_orthonormal_box().unwrap().distance(p),
            Figure::Curve(curve) => curve.nearest_to_each_query(&[p], &job).unwrap()[0].distance,
            Figure::Surface(surface) => surface.closest(p, f64::INFINITY).unwrap().distance,
        };
        let truth: Vec<f64> = (0..5 * parts)
            .map(|k| samples(&curve, parts, k).iter().map(|&(p, _)| distance(p)).fold(f64::INFINITY, f64::min))
            .collect();
        let least = truth.iter().copied().fold(f64::INFINITY, f64::min);
        for goal in [SearchGoal::Within(0.0), SearchGoal::Within(least + 0.05), SearchGoal::Least] {
            let found = arcs.find_arcs_near_figure(figure, &options(goal, case), &job).unwrap();
            let within = match goal {
                SearchGoal::Within(within) => within,
                SearchGoal::Least => least,
            };
            for (k, &truth) in truth.iter().enumerate() {
                assert!(found.possible_cells.get([0, k]) || truth > within, "{case} {goal:?} {k}: {truth} {within}");
            }
            kept += found.possible_cells.count();
            arcs_in_all += truth.len();
            evaluations += found.evaluations;
        }
        // Tangents at an angle.
        let target = AngleTarget { direction, angle: 0.3 + 2.0 * random.next(), unsigned: case % 5 == 0 };
        let unit = target.normalized().unwrap();
        for goal in [SearchGoal::Within(0.01), SearchGoal::Least] {
            let found = arcs.find_cells_with_angle(target, &options(goal, case), &job).unwrap();
            let deviations: Vec<f64> = (0..5 * parts)
                .map(|k| {
                    samples(&curve, parts, k).iter().map(|&(_, t)| unit.deviation(t)).fold(f64::INFINITY, f64::min)
                })
                .collect();
            let least = deviations.iter().copied().fold(f64::INFINITY, f64::min);
            let within = if goal == SearchGoal::Least { least } else { 0.01 };
            for (k, &truth) in deviations.iter().enumerate() {
                assert!(found.possible_cells.get([0, k]) || truth > within, "{case} {goal:?} {k}: {truth}");
            }
        }
    }
    // It excludes most, and looks at few nodes.
    assert!(3 * kept < arcs_in_all && evaluations < arcs_in_all as u64, "{kept} {evaluations} {arcs_in_all}");
}

/// Cells of sheets near curves and surfaces: task c and e by the paper's search.
#[test]
fn no_cell_is_lost() {
    let (job, mut random) = (Job::default(), Random(11));
    let sheets: Vec<Sheet<'static>> = SHAPES.iter().map(|shape| Sheet::Grid(grid(shape))).collect();
    for case in 0..12 {
        let sheet = &sheets[case % 4];
        let diameters = Diameters::new(sheet, &job).unwrap();
        let curve = random_curve(&mut random, case % 2 == 0);
        let other = Surface::new(vec![sheets[(case + 1) % 4].clone()], None, &job).unwrap();
        let figure = if case % 3 == 2 { Figure::Surface(&other) } else { Figure::Curve(curve.view()) };
        let distance = |p: DVec3| match figure {
            Figure::Surface(surface) => surface.closest(p, f64::INFINITY).unwrap().distance,
            _ => curve.view().nearest_to_each_query(&[p], &job).unwrap()[0].distance,
        };
        let within = 0.02;
        let found = find_cells_near_figure(sheet, &diameters, figure, &options(SearchGoal::Within(within), case), &job)
            .unwrap();
        let [h, w] = sheet.cells();
        for cell in (0..h).flat_map(|i| (0..w).map(move |j| [i, j])) {
            let points =
                (0..9).map(|k| sheet.jet(cell[0], cell[1], f64::from(k / 3) / 2.0, f64::from(k % 3) / 2.0).point);
            let least = points.map(distance).fold(f64::INFINITY, f64::min);
            assert!(found.possible_cells.get(cell) || least > within, "{case} {cell:?}: {least}");
        }
        let nodes: Vec<[usize; 2]> = found.possible_cells.nodes().collect();
        assert!(found.possible_cells.count() > 0 || nodes.is_empty());
        assert!(nodes.len() >= found.possible_cells.count() / 4 && nodes.len() <= 4 * found.possible_cells.count());
        assert!(found.evaluations <= ((h + 1) * (w + 1)) as u64);
    }
}

/// Lengths bound arcs from above, and tend to them.
#[test]
fn lengths_are_bounds() {
    let (job, mut random) = (Job::default(), Random(5));
    let curve = random_curve(&mut random, false);
    let length = curve.view().length().unwrap();
    let mut last = f64::INFINITY;
    for parts in [1, 2, 4, 64] {
        let sum: f64 = CurveArcs::new(&curve.view(), parts, &job).unwrap().lengths.values().iter().sum();
        assert!(sum >= length * (1.0 - 1e-12) && sum <= last, "{parts}: {sum} {length}");
        last = sum;
    }
    assert!(last < length * 1.001);
}

/// Erratum E1 holds for curves, too: with bits of nodes, a crossing between two nodes is lost.
#[test]
fn bits_of_nodes_lose_crossings_of_curves() {
    // Arcs of length 1 along x, and the plane x = 0.5: from node -3, r = 3.5 and J = 3, from node 4
    // too. All nodes from -6 to 0 and from 1 to 7 are zeroed, and the arc that is crossed has none.
    let points: Vec<DVec3> = (-6..8).map(|k| DVec3::X * f64::from(k)).collect();
    let ends: Vec<u32> = (0..14).collect();
    let line = CurveView::new(&points, &ends, false).unwrap();
    let mut nodes = [true; 14];
    for visited in [3_usize, 10] {
        let r: f64 = (points[visited].x - 0.5).abs();
        let steps = r.floor() as usize;
        nodes[visited.saturating_sub(steps)..=(visited + steps).min(13)].fill(false);
    }
    assert!(!nodes.contains(&true), "the literal rule leaves none: {nodes:?}");
    let arcs = CurveArcs::new(&line, 1, &Job::default()).unwrap();
    let plane = Figure::Object(PointPlaneOrLine::Plane { point: DVec3::X * 0.5, normal: DVec3::X });
    let found =
        arcs.find_arcs_near_figure(plane, &SearchOptions::new(SearchGoal::Within(0.0)), &Job::default()).unwrap();
    assert!(found.possible_cells.get([0, 6]) && found.possible_cells.count() <= 3);
}

#[test]
fn arcs_are_checked() {
    let (job, mut random) = (Job::default(), Random(5));
    let curve = random_curve(&mut random, false);
    let none = CurveView::new(&[], &[0], false).unwrap();
    assert_eq!(CurveArcs::new(&none, 1, &job).unwrap_err(), Error::EmptyCurve);
    assert!(matches!(
        CurveArcs::new(&curve.view(), 0, &job).unwrap_err(),
        Error::OptionOutOfRange { option: "parts", .. }
    ));
    assert!(matches!(CurveArcs::new(&curve.view(), 1 << 40, &job).unwrap_err(), Error::TooLarge { .. }));
    let arcs = CurveArcs::new(&curve.view(), 1, &job).unwrap();
    let ask = |figure| arcs.find_arcs_near_figure(figure, &SearchOptions::new(SearchGoal::Least), &job);
    assert_eq!(ask(Figure::Curve(none)).unwrap_err(), Error::EmptyCurve);
    assert!(ask(Figure::Object(PointPlaneOrLine::Point(DVec3::NAN))).is_err());
}
