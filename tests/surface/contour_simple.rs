//! Compares cells that corners decide with the general algorithm: a section is the contour of the
//! plane's function, given only at nodes.

use crate::contours::length;
use crate::shapes::{Random, SHAPES, Shape, grid, rough};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::{Grid, Nodes, Paths, Place, Scheme, Sheet, Surface};

/// True if both have the same curves through the same cells; false where cells are unresolved. A
/// `tangent` plane at a saddle cuts two crossing branches. Rounding decides which of the four arms
/// are joined: f is known to eps, so the curve f = 0 to the root of eps.
/// Then both are compared as sets of points.
fn same(surface: &Surface<'_>, nodes: &Nodes<'_>, [point, normal]: [DVec3; 2], tangent: bool, name: &str) -> bool {
    let (normal, job) = (normal.normalize(), Job::default());
    let offsets = [-0.07, 0.0, 0.011];
    let cut = |between| surface.section(&Planes { point, normal, levels: &offsets }, between, &job).unwrap();
    let values: Vec<f64> = (0..nodes.rows())
        .flat_map(|i| (0..nodes.columns()).map(move |j| (i, j)))
        .map(|(i, j)| (nodes.get(i, j) - point).dot(normal))
        .collect();
    let contours = |between| surface.contours(&values, &offsets, between, &job).unwrap();
    [PointSpacing::CellEdges, PointSpacing::Auto, PointSpacing::Chord(1e-5)].into_iter().all(|between| {
        let (a, b) = (cut(between), contours(between));
        if !a.unresolved.is_empty() || !b.unresolved.is_empty() {
            return false;
        }
        let name = format!("{name}, {between:?}: plane through {point}, normal {normal}");
        if tangent {
            check_sets(&a, &b, &name);
        } else {
            check(&a, &b, &name);
        }
        true
    })
}

fn check(a: &Paths, b: &Paths, name: &str) {
    assert_eq!((&a.ends, &a.closed, &a.levels), (&b.ends, &b.closed, &b.levels), "{name}");
    for (k, (x, y)) in a.places.iter().zip(&b.places).enumerate() {
        assert_eq!(x.cell, y.cell, "{name}: point {k}");
        assert!((x.u - y.u).abs().max((x.v - y.v).abs()) < 1e-7, "{name}: {x:?} {y:?}");
        assert!(a.points[k].distance(b.points[k]) < 1e-9, "{name}: {x:?} {y:?}");
        assert!(a.normals[k].distance(b.normals[k]) < 1e-6, "{name}: {x:?} {y:?}");
    }
}

fn check_sets(a: &Paths, b: &Paths, name: &str) {
    for [x, y] in [[a, b], [b, a]] {
        for point in &x.points {
            let nearest = y.points.iter().map(|p| p.distance(*point)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-6, "{name}: {point} is {nearest} from the other's points");
        }
    }
    let [x, y] = [a, b].map(|paths| (0..paths.ends.len() - 1).map(|k| length(paths, k)).sum::<f64>());
    assert!((x - y).abs() < 1e-5, "{name}: {x} and {y} long");
}

/// Random planes, planes through nodes, along axes too, and planes that touch the surface, or
/// nearly.
fn planes(name: &str, grid: Grid<'static>, count: usize) {
    let ([h, w], nodes) = (grid.cells(), grid.nodes().clone());
    let surface = Surface::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap();
    let mut random = Random(23);
    let mut compared = 0;
    for k in 0..count {
        let (mut point, mut normal) = (random.point(0.8), random.point(1.0));
        let cell = [h, w].map(|count| (random.next() * count as f64) as u32);
        if k % 4 == 1 || k % 4 == 2 {
            point = nodes.get(cell[0] as usize, cell[1] as usize);
        }
        if k % 4 == 2 {
            normal = [DVec3::X, DVec3::Y, DVec3::Z][k / 4 % 3];
        }
        if k % 4 == 3 {
            let place = Place { sheet: 0, cell, u: random.next(), v: random.next() };
            normal = surface.normal(place);
            point = surface.jet(place).point + [0.0, 1e-5, -1e-5][k / 4 % 3] * normal;
        }
        let tangent = k % 4 == 3 && k / 4 % 3 == 0;
        compared += usize::from(same(&surface, &nodes, [point, normal], tangent, name));
    }
    assert!(5 * compared >= 4 * count, "{name}: {compared} of {count}");
}

fn all(count: usize, fine: usize) {
    for shape in &SHAPES {
        planes(shape.name, grid(shape), count);
        // So fine that nearly all cells are simple.
        let cells = shape.cells.map(|cells| fine * cells);
        planes(shape.name, grid(&Shape { cells, ..*shape }), count);
        let creased = Grid::new(grid(shape).nodes().clone(), shape.closed, Scheme::FourPoint).unwrap();
        planes(shape.name, creased, count);
    }
    for (k, closed) in [[false, false], [true, true]].into_iter().enumerate() {
        planes("rough", rough([24, 31], closed, Scheme::SixTap, 7 + k as u64), count);
    }
}

#[test]
fn sections_are_contours() {
    all(24, 5);
}

#[test]
#[ignore = "minutes"]
fn exhaustive_sections_are_contours() {
    all(2000, 5);
}
