//! Sections and contours at the limits: any size and place, sheets without normals, arguments that are refused.

use crate::contours::{length, surface};
use crate::shapes::{SHAPES, grid};
use glam::DVec3;
use gusset::Job;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Element, Error, Progress};
use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;

#[test]
fn what_is_refused() {
    let (surface, job) = (surface(&SHAPES[2]), Job::default());
    let plane = |point: DVec3, normal: DVec3, offsets: &[f64]| {
        surface.section(&Planes { point, normal, levels: offsets }, PointSpacing::Auto, &job).map(|paths| paths.len())
    };
    let out = |result: Result<usize, Error>| matches!(result, Err(Error::OptionOutOfRange { .. }));
    assert!(out(plane(DVec3::NAN, DVec3::Z, &[0.0])) && out(plane(DVec3::ZERO, DVec3::ZERO, &[0.0])));
    assert!(out(plane(DVec3::ZERO, DVec3::INFINITY, &[0.0])) && out(plane(DVec3::ZERO, DVec3::Z, &[0.0, 0.0])));
    assert!(out(plane(DVec3::ZERO, DVec3::Z, &[0.1, f64::NAN])));
    assert_eq!((plane(DVec3::ZERO, DVec3::Z, &[]), plane(DVec3::ZERO, DVec3::Z, &[1e300])), (Ok(0), Ok(0)));
    assert_eq!(plane(DVec3::ZERO, 1e-300 * DVec3::Z, &[0.01]), plane(DVec3::ZERO, 1e300 * DVec3::Z, &[0.01]));
    let values = vec![0.5; 41 * 53];
    assert!(matches!(
        surface.contours(&values[1..], &[0.1], PointSpacing::Auto, &job),
        Err(Error::ArrayTooShort { .. })
    ));
    let mut bad = values.clone();
    bad[77] = f64::NAN;
    assert!(matches!(
        surface.contours(&bad, &[0.1], PointSpacing::Auto, &job),
        Err(Error::NotFinite { element: Element::Node, index: 77, .. })
    ));
    bad.push(0.0);
    assert!(matches!(surface.contours(&bad, &[0.1], PointSpacing::Auto, &job), Err(Error::TooLarge { .. })));
    let around = |angles: &[f64], unsigned| {
        surface.isophotes(DVec3::X, angles, unsigned, PointSpacing::Auto, &job).map(|paths| paths.len())
    };
    assert!(out(around(&[-0.1], false)) && out(around(&[1.7], true)) && out(around(&[3.2], false)));
    assert!(out(around(&[f64::NAN], false)) && out(around(&[1.0, 0.5], false)));
    for between in [PointSpacing::Chord(0.0), PointSpacing::Chord(f64::NAN), PointSpacing::Leus(2000)] {
        assert!(out(surface
            .section(&Planes { point: DVec3::ZERO, normal: DVec3::Z, levels: &[0.0] }, between, &job)
            .map(|paths| paths.len())));
    }
    assert!(surface.nearest_angle(DVec3::X, -1.0, false, &job).is_err());
    struct Stop;
    impl Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    let stopped = surface.isophotes(DVec3::X, &[1.0], false, PointSpacing::Auto, &Job::new(1, &Stop));
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
        let surface = Surface::new(vec![Sheet::Grid(sheet)], None, &job).unwrap();
        let normal = DVec3::new(0.2, 0.5, 0.9);
        let offsets = [-0.1 * size, 0.07 * size];
        let planes = Planes { point: moved(DVec3::new(0.05, 0.0, 0.01)), normal, levels: &offsets };
        let paths = surface.section(&planes, PointSpacing::Auto, &job).unwrap();
        let truth = self::surface(&SHAPES[1]);
        let planes = Planes { point: DVec3::new(0.05, 0.0, 0.01), normal, levels: &[-0.1, 0.07] };
        let truth = truth.section(&planes, PointSpacing::Auto, &job).unwrap();
        assert_eq!((paths.len(), &paths.levels), (truth.len(), &truth.levels), "{size} {shift}");
        assert!(paths.closed.iter().all(|&closed| closed) && paths.unresolved.is_empty(), "{size} {shift}");
        for k in 0..paths.len() {
            let (a, b) = (length(&paths, k) / size, length(&truth, k));
            assert!((a - b).abs() < 1e-6 * b, "{size} {shift}: {a} {b}");
        }
    }
}

#[test]
fn a_sheet_without_normals_has_no_angle() {
    let job = Job::default();
    let nodes: Vec<f64> = (0..36).flat_map(|k| [f64::from(k / 6), f64::from(k / 6), 0.0]).collect();
    let nodes = Nodes::strided(nodes, 6, 6, 0, 0).unwrap();
    let grid = Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap();
    let line = Surface::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
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
    let line = Surface::new(vec![Sheet::Grid(grid)], None, &job).unwrap();
    // No angle of any cell can be told.
    let angles: Vec<f64> = (1..20).map(|k| 0.1 * f64::from(k)).collect();
    let paths = line.isophotes(DVec3::Z, &angles, false, PointSpacing::Auto, &job).unwrap();
    let mut cells: Vec<_> = paths.unresolved.iter().map(|place| (place.sheet, place.cell)).collect();
    cells.sort_unstable();
    assert_eq!(cells.len(), 25);
    cells.dedup();
    assert_eq!(cells.len(), 25);
}
