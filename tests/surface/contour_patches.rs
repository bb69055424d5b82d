//! Sections and curves of angle of patches that are given, of several sheets, and where normals
//! jump.

use crate::contours::{check, length, surface};
use crate::shapes::{Random, SHAPES, grid};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::{Grid, Patches, Paths, Scheme, Sheet, Surface};
use std::f64::consts::FRAC_PI_2;

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
    let (whole, grid) = (surface(shape), grid(shape));
    let of = |sheets: Vec<Sheet<'static>>| Surface::new(sheets, None, &job).unwrap();
    let cubic = of(patched::<4>(&grid, 53).into_iter().map(Sheet::Cubic).collect());
    let pieces = of(patched::<4>(&grid, 17).into_iter().map(Sheet::Cubic).collect());
    let high = of(patched::<8>(&grid, 30).into_iter().map(Sheet::High).collect());
    let mut random = Random(21);
    for k in 0..6 {
        let planes = Planes { point: random.point(0.5), normal: random.point(1.0), levels: &[-0.2, 0.0, 0.1] };
        let truth = whole.section(&planes, PointSpacing::CellEdges, &job).unwrap();
        let mut lengths: Vec<f64> = (0..truth.len()).map(|k| length(&truth, k)).collect();
        lengths.sort_by(f64::total_cmp);
        for other in [&cubic, &pieces, &high] {
            let paths = other.section(&planes, PointSpacing::CellEdges, &job).unwrap();
            check(other, &paths, "patches");
            assert!(paths.closed.iter().all(|&closed| closed), "{k}");
            assert!(paths.unresolved.is_empty(), "{k}: {:?}", paths.unresolved);
            let mut found: Vec<f64> = (0..paths.len()).map(|k| length(&paths, k)).collect();
            found.sort_by(f64::total_cmp);
            assert_eq!(found.len(), lengths.len(), "{k}");
            assert!(found.iter().zip(&lengths).all(|(a, b)| (a - b).abs() < 1e-9), "{k}: {found:?} {lengths:?}");
        }
    }
    // Silhouettes: the normals of patches agree only within rounding.
    let truth = whole.isophotes(DVec3::new(0.1, 0.7, 0.3), &[FRAC_PI_2], false, PointSpacing::CellEdges, &job).unwrap();
    let paths = cubic.isophotes(DVec3::new(0.1, 0.7, 0.3), &[FRAC_PI_2], false, PointSpacing::CellEdges, &job).unwrap();
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
        let surface =
            Surface::new(vec![Sheet::Grid(Grid::new(nodes, shape.closed, Scheme::FourPoint).unwrap())], None, &job)
                .unwrap();
        let other = crate::contours::surface(shape);
        let mut random = Random(31);
        for k in 0..12 {
            let axis = random.point(1.0);
            let angles = [0.4 + 0.8 * random.next(), FRAC_PI_2, 2.0];
            let paths = surface.isophotes(axis, &angles, false, PointSpacing::CellEdges, &job).unwrap();
            // Where a crease itself is the curve for more than a cell, curves end, and their ends
            // are reported.
            let open = paths.closed.iter().filter(|&&closed| !closed).count();
            // Both ends may be in one cell, which is listed once.
            assert!(paths.unresolved.len() >= open, "{} {k}: {open} {:?}", shape.name, paths.unresolved);
            (total, ended) = (total + paths.len(), ended + open);
            let truth = other.isophotes(axis, &angles, false, PointSpacing::CellEdges, &job).unwrap();
            let all = |paths: &Paths| (0..paths.len()).map(|k| length(paths, k)).sum::<f64>();
            // Missing parts lie along listed creases.
            let (found, expected) = (all(&paths), all(&truth));
            let near = (found / expected - 1.0).abs() < 0.05;
            assert!(near || !paths.unresolved.is_empty(), "{} {k}: {found} {expected}", shape.name);
            whole += usize::from(near);
        }
        // Seen along the axis, the silhouettes of the torus are creases.
        let paths = surface.isophotes(DVec3::Z, &[FRAC_PI_2], false, PointSpacing::CellEdges, &job).unwrap();
        assert!(paths.len() >= 2 || paths.unresolved.len() > 10, "{}: {paths:?}", shape.name);
    }
    assert!(total > 60 && ended * 2 < total && whole > 12, "{ended} of {total}, {whole}");
}

/// The teapot's patches, a sheet each; `None` without data.
fn teapot() -> Option<Surface<'static>> {
    let folder = std::env::var("GUSSET_DATA")
        .unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data").into());
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
    Some(Surface::new(patches.collect(), None, &Job::default()).unwrap())
}

#[test]
fn teapot_patches_are_joined() {
    let Some(surface) = teapot() else { return println!("skipped: no data") };
    let job = Job::default();
    // Round the body, below the lid: no plane section of a teapot's body ends.
    let planes = Planes { point: DVec3::ZERO, normal: DVec3::Y, levels: &[0.1, 0.2, 0.35, 0.5] };
    let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
    check(&surface, &paths, "teapot");
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
        let planes = Planes { point: random.point(0.4), normal: random.point(1.0), levels: &[0.0] };
        let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
        check(&surface, &paths, "teapot");
        let open: Vec<usize> = (0..paths.len()).filter(|&k| !paths.closed[k]).collect();
        for (&a, &b) in open.iter().flat_map(|a| open.iter().map(move |b| (a, b))) {
            let (tail, head) = (paths.points_of(a).last().unwrap(), paths.points_of(b)[0]);
            assert!(tail.distance(head) > 1e-8, "{k}: {a} {b}");
        }
    }
}
