//! Sections and contours through nodes, and isophotes next to poles and creases: every point lies
//! at its reported place.

use crate::contours::surface;
use crate::shapes::{Random, SHAPES, Shape, grid, rough};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::{Grid, Nodes, NormalKind, Paths, Place, Scheme, Sheet, Surface};
use std::f64::consts::{FRAC_PI_2, PI};

/// The other scheme through the same nodes.
fn creased(shape: &Shape) -> Grid<'static> {
    Grid::new(grid(shape).nodes().clone(), shape.closed, Scheme::FourPoint).unwrap()
}

/// Sections by random planes through nodes, and contours at values of nodes: the path stays on the
/// plane beside a corner with the value 0.
fn through_nodes(grid: Grid<'static>, closed: [bool; 2], scheme: Scheme, planes: usize, levels: usize) {
    let job = Job::default();
    let ([h, w], nodes) = (grid.cells(), grid.nodes().clone());
    let surface = Surface::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
    let mut random = Random(41);
    let all_closed = |paths: &Paths| closed != [true; 2] || paths.closed.iter().all(|&closed| closed);
    let node = |random: &mut Random| [h, w].map(|count| (random.next() * count as f64) as usize);
    for k in 0..planes {
        let [i, j] = node(&mut random);
        let point = nodes.get(i, j);
        let small = random.point(4.0).round();
        let normal = if k % 3 == 0 && small != DVec3::ZERO { small } else { random.point(1.0) };
        let paths = surface.section(&Planes { point, normal, levels: &[0.0] }, PointSpacing::Auto, &job).unwrap();
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
        let paths = surface.contours(&values, &[level], PointSpacing::Auto, &job).unwrap();
        let value = |at: &Place| field.patch(at.cell[0] as usize, at.cell[1] as usize).point(at.u, at.v).x;
        let off = paths.places.iter().map(|at| (value(at) - level).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12 && all_closed(&paths), "{k}: {off:e} from the value at node {i} {j}");
    }
}

#[test]
fn planes_and_contours_through_nodes() {
    let job = Job::default();
    // Examples: the arc next to the node is on the other side of a line of the surface.
    let example = |shape: &Shape, [i, j]: [usize; 2], normal: DVec3| {
        let point = grid(shape).nodes().get(i, j);
        let planes = Planes { point, normal, levels: &[0.0] };
        let paths = surface(shape).section(&planes, PointSpacing::Auto, &job).unwrap();
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

/// Every point of a curve of angle has the angle, or its cell is reported. Returns how many points
/// were looked at, and how many are in reported cells only.
fn check_angles(surface: &Surface<'_>, axis: DVec3, angle: f64) -> [usize; 2] {
    let paths = surface.isophotes(axis, &[angle], false, PointSpacing::Auto, &Job::default()).unwrap();
    let mut counts = [0; 2];
    for &place in &paths.places {
        let local = surface.local_geometry(place);
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
    let of = |grid: Grid<'static>| Surface::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap();
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
        for surface in [&round, &bumpy] {
            let axis = random.point(1.0).normalize();
            let angle = if k % 2 == 0 { FRAC_PI_2 } else { 0.3 + 2.5 * random.next() };
            let [_, wrong] = check_angles(surface, axis, angle);
            assert_eq!(wrong, 0, "{axis} {angle}");
        }
    }
    // With places where the normal vanishes nearly.
    for (cells, closed, scheme, seed) in [
        ([8, 9], [false; 2], Scheme::SixTap, 3),
        ([12, 17], [true; 2], Scheme::SixTap, 4),
        ([12, 17], [true; 2], Scheme::FourPoint, 5),
    ] {
        let surface = of(rough(cells, closed, scheme, seed));
        check_angles(&surface, DVec3::Z, 1.5217083479313647);
        for _ in 0..4 {
            check_angles(&surface, random.point(1.0).normalize(), 0.3 + 2.5 * random.next());
        }
    }
}
