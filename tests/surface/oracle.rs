//! The paper's search, corrected, against the index: the same answers, cell for cell and value for
//! value, on six surfaces. They have nothing in common but the patches.

use crate::halving::{cells_within, closest};
use crate::shapes::{Random, SHAPES, Shape, grid, rough};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::reference::{CellGridShape, CellMask, Diameters, PointPlaneOrLine};
use gusset::surface::{Grid, Patches, Place, Scheme, Sheet, Surface};
use std::path::{Path, PathBuf};

struct Case {
    name: &'static str,
    sheet: Sheet<'static>,
    diameters: Diameters,
    surface: Surface<'static>,
    /// To which answers are compared.
    tolerance: f64,
}

impl Case {
    fn new(name: &'static str, sheet: Sheet<'static>) -> Case {
        let diameters = Diameters::new(&sheet, &Job::default()).unwrap();
        let surface = Surface::new(vec![sheet.clone()], None, &Job::default()).unwrap();
        let tolerance = surface.tolerance();
        Case { name, sheet, diameters, surface, tolerance }
    }

    fn lattice(&self) -> CellGridShape {
        CellGridShape::new(&self.sheet)
    }

    fn centre(&self) -> (DVec3, f64) {
        let [low, high] = self.surface.bounds();
        (0.5 * (low + high), 0.5 * low.distance(high))
    }
}

/// The patches of a grid as given ones.
fn as_patches(grid: &Grid<'_>) -> Sheet<'static> {
    let [rows, columns] = grid.cells();
    let cells = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let points: Vec<DVec3> = cells.flat_map(|(i, j)| grid.patch(i, j).points.concat()).collect();
    Sheet::Cubic(Patches::new(&points, [3, 3], rows, columns).unwrap())
}

/// Patches of degree 6 over a sheet of waves.
fn high() -> Sheet<'static> {
    let (n, mut points) = (6, Vec::new());
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        for (a, b) in (0..7).flat_map(|a| (0..7).map(move |b| (a, b))) {
            let (x, y) = ((i as f64 + f64::from(a) / 6.0) / n as f64, (j as f64 + f64::from(b) / 6.0) / n as f64);
            points.push(DVec3::new(x, y, 0.15 * (9.0 * x).sin() * (8.0 * y).cos()));
        }
    }
    Sheet::High(Patches::new(&points, [6, 6], n, n).unwrap())
}

fn cases() -> Vec<Case> {
    let [torus, bumpy, wavy, pole] = &SHAPES;
    let four = Grid::new(
        gusset::surface::Nodes::strided(nodes_of(wavy), wavy.cells[0] + 1, wavy.cells[1] + 1, 0, 0).unwrap(),
        wavy.closed,
        Scheme::FourPoint,
    );
    let mut cases = vec![
        Case::new(torus.name, Sheet::Grid(grid(torus))),
        Case::new(bumpy.name, Sheet::Grid(grid(bumpy))),
        Case::new(wavy.name, Sheet::Grid(grid(wavy))),
        Case::new(pole.name, Sheet::Grid(grid(pole))),
        Case::new("patches", as_patches(&four.unwrap())),
        Case::new("degree 6", high()),
        Case::new("rough", Sheet::Grid(rough([12, 17], [true, false], Scheme::SixTap, 9))),
    ];
    cases.extend(teapot());
    cases
}

fn nodes_of(shape: &Shape) -> Vec<f64> {
    let [h, w] = shape.cells;
    let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i as f64 / h as f64, j as f64 / w as f64)));
    nodes.flat_map(|(u, v)| (shape.point)(u, v).to_array()).collect()
}

/// Some patches of the teapot, where the data are.
fn teapot() -> Vec<Case> {
    let given = std::env::var_os("GUSSET_DATA").map(PathBuf::from);
    let data = given.unwrap_or_else(|| Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("../shared/data"));
    let Ok(text) = std::fs::read_to_string(data.join("carcass/teapot_bezier.json")) else {
        println!("SKIPPED: no teapot in {}; set GUSSET_DATA", data.display());
        return Vec::new();
    };
    let read: serde_json::Value = serde_json::from_str(&text).unwrap();
    let vertex = |k: &serde_json::Value| {
        let at = &read["vertices"][k.as_u64().unwrap() as usize];
        DVec3::from_array([0, 1, 2].map(|axis| at[axis].as_f64().unwrap()))
    };
    let patches = read["patches"].as_array().unwrap();
    let points = |patch: &serde_json::Value| -> Vec<DVec3> {
        let flat = patch
            .as_array()
            .unwrap()
            .iter()
            .flat_map(|row| row.as_array().map_or(vec![row], |row| row.iter().collect()));
        flat.map(vertex).collect()
    };
    let sheet = |patch| Sheet::Cubic(Patches::new(&points(patch), [3, 3], 1, 1).unwrap());
    patches.iter().step_by(5).map(|patch| Case::new("teapot", sheet(patch))).collect()
}

/// Task a): the same distance, and a point that has it.
#[test]
fn nearest_points() {
    compare_nearest(40, 21);
}

/// The same, many times.
#[test]
#[ignore = "takes long"]
fn exhaustive_nearest_points() {
    compare_nearest(3000, 121);
}

fn compare_nearest(queries: usize, seed: u64) {
    for case in cases() {
        let (centre, size) = case.centre();
        let mut random = Random(seed);
        for k in 0..queries {
            let query = centre + random.point(size * [0.7, 10.0][k % 2]);
            let near = closest(&case.sheet, &case.diameters, query, case.tolerance);
            let distance = near.distance;
            assert!(near.bound <= distance && near.bound >= distance - 2.0 * case.tolerance, "{}: {near:?}", case.name);
            let found = case.surface.closest(query, f64::INFINITY).unwrap();
            assert!((distance - found.distance).abs() <= 2.0 * case.tolerance, "{}: {distance} {found:?}", case.name);
            let there = case.surface.jet(near.place).point.distance(query);
            assert!((there - distance).abs() <= 1e-12 * (distance + size), "{}: {near:?}", case.name);
        }
    }
}

/// The mask of cells within a distance of a point: the paper's equals the index's, except cells
/// within the tolerance of the distance.
#[test]
fn regions_of_cells() {
    let mut count = 0;
    for case in cases() {
        let (centre, size) = case.centre();
        let mut random = Random(25);
        for _ in 0..12 {
            let query = centre + random.point(0.8 * size);
            let nearest = case.surface.closest(query, f64::INFINITY).unwrap().distance;
            let radius = nearest + 0.2 * size;
            let within = |radius| {
                cells_within(&case.sheet, &case.diameters, PointPlaneOrLine::Point(query), radius, case.tolerance)
            };
            let region = case.surface.cells_in_ball(query, radius, &Job::default()).unwrap();
            let (least, most) = (within(radius - 4.0 * case.tolerance), within(radius + 4.0 * case.tolerance));
            for k in 0..case.lattice().len() {
                let (cell, has) = (case.lattice().cell(k), region.contains(k as u64));
                assert!(has || !least.get(cell), "{}: {query} {radius} lacks {cell:?}", case.name);
                assert!(!has || most.get(cell), "{}: {query} {radius} has {cell:?}", case.name);
                count += usize::from(has);
            }
            assert!(region.cells.len() < case.lattice().len() || case.lattice().len() < 50, "{}", case.name);
        }
    }
    assert!(count > 500, "{count}");
}

/// True if a point of one of the places is in a cell, or on its edge.
fn has(case: &Case, cell: [usize; 2], places: &[Place]) -> bool {
    let own = |place: &Place| place.cell == cell.map(|k| k as u32);
    let near = |place: &Place| {
        let at = place.cell.map(|k| k as usize);
        let on_edge = [place.u, place.v].iter().any(|x| !(1e-5..=1.0 - 1e-5).contains(x));
        on_edge && case.lattice().neighbours(at).any(|other| other == cell)
    };
    places.iter().any(own) || places.iter().any(near)
}

/// The cells of the scale are those with places, and those beside them that have the same points.
fn compare(case: &Case, scale: &CellMask, places: &[Place], what: &dyn std::fmt::Debug) -> usize {
    for place in places {
        assert!(scale.get(place.cell.map(|k| k as usize)), "{}: {what:?} {place:?}", case.name);
    }
    let mut count = 0;
    for cell in scale.cells() {
        assert!(has(case, cell, places), "{}: {what:?} {cell:?}", case.name);
        count += 1;
    }
    count
}

/// Task c): the cells that a line meets.
#[test]
fn cells_of_lines() {
    let count = compare_lines(60, 22);
    assert!(count > 200, "{count}");
}

/// The same, many times.
#[test]
#[ignore = "takes long"]
fn exhaustive_cells_of_lines() {
    compare_lines(3000, 122);
}

fn compare_lines(lines: usize, seed: u64) -> usize {
    let mut count = 0;
    for case in cases() {
        let (centre, size) = case.centre();
        let mut random = Random(seed);
        for _ in 0..lines {
            let line = Line::new(centre + random.point(0.5 * size), random.point(1.0));
            let hits = case.surface.line(&line, HitSelection::All).unwrap();
            let object = PointPlaneOrLine::Line(line);
            let scale = cells_within(&case.sheet, &case.diameters, object, 0.0, case.tolerance);
            let places: Vec<Place> = hits.iter().map(|hit| hit.place).collect();
            count += compare(&case, &scale, &places, &line);
        }
    }
    count
}

/// Task d): the cells that a plane crosses, against the sections that the index finds: each has a
/// piece of a curve, or is listed as unresolved.
#[test]
fn cells_of_sections() {
    let mut count = 0;
    for case in cases() {
        let (centre, size) = case.centre();
        let mut random = Random(24);
        for _ in 0..10 {
            let (point, normal) = (centre + random.point(0.4 * size), random.point(1.0).normalize());
            let planes = Planes { point, normal, levels: &[0.0] };
            let paths = case.surface.section(&planes, PointSpacing::Chord(1e-3 * size), &Job::default()).unwrap();
            let object = PointPlaneOrLine::Plane { point, normal };
            let scale = cells_within(&case.sheet, &case.diameters, object, 0.0, case.tolerance);
            let places: Vec<Place> = paths.places.iter().chain(&paths.unresolved).copied().collect();
            count += compare(&case, &scale, &places, &planes);
        }
    }
    assert!(count > 500, "{count}");
}

/// Task d): the cells that a plane crosses, against all of them one by one.
#[test]
fn cells_of_planes() {
    for case in cases() {
        let (centre, size) = case.centre();
        let mut random = Random(23);
        for _ in 0..20 {
            let (point, normal) = (centre + random.point(0.4 * size), random.point(1.0).normalize());
            let object = PointPlaneOrLine::Plane { point, normal };
            let scale = cells_within(&case.sheet, &case.diameters, object, 0.0, case.tolerance);
            for k in 0..case.lattice().len() {
                let cell = case.lattice().cell(k);
                let at =
                    |k: u32| case.sheet.jet(cell[0], cell[1], f64::from(k / 7) / 6.0, f64::from(k % 7) / 6.0).point;
                let heights: Vec<f64> = (0..49).map(|k| (at(k) - point).dot(normal)).collect();
                let crosses = heights.iter().any(|&x| x > 0.0) && heights.iter().any(|&x| x < 0.0);
                assert!(!crosses || scale.get(cell), "{}: {cell:?}", case.name);
                // One that shows no change of sign comes near at least.
                let nearest = heights.iter().fold(f64::INFINITY, |least, x| least.min(x.abs()));
                let reach = 0.3 * case.diameters.intrinsic.get(cell);
                assert!(!scale.get(cell) || crosses || nearest < reach, "{}: {cell:?}", case.name);
            }
        }
    }
}
