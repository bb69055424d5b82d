//! Intersections of two surfaces against analytic truth, sampling, and each other.

mod surfaces;

use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::carcass::meet::Options;
use gusset::carcass::{Carcass, Grid, Nodes, Paths, Scheme, Sheet};
use surfaces::{Random, Shape, torus};

fn place(shape: &Shape, turn: DMat3, shift: DVec3) -> Grid<'static> {
    let [h, w] = shape.cells;
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let mut data = Vec::new();
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        let point = (shape.point)(at(i, h, shape.closed[0]), at(j, w, shape.closed[1]));
        data.extend((turn * point + shift).to_array());
    }
    Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), shape.closed, Scheme::SixTap).unwrap()
}

fn carcass(shape: &Shape, turn: DMat3, shift: DVec3) -> Carcass<'static> {
    Carcass::new(vec![Sheet::Grid(place(shape, turn, shift))], None, &Job::default()).unwrap()
}

fn ring(h: usize, w: usize) -> Shape {
    Shape { name: "torus", cells: [h, w], closed: [true, true], point: |u, v| torus(u, v, 0.0) }
}

fn describe(paths: &Paths) -> String {
    let lengths: Vec<_> = (0..paths.len()).map(|k| (paths.points_of(k).len(), paths.closed[k])).collect();
    format!("{} paths {lengths:?}, {} unresolved", paths.len(), paths.unresolved.len())
}

#[test]
fn explore() {
    let turn = DMat3::from_rotation_x(1.1) * DMat3::from_rotation_z(0.3);
    for (h, w) in [(16, 32), (32, 64), (64, 128), (128, 256)] {
        let shape = ring(h, w);
        for (name, turn, shift) in [
            ("shift x", DMat3::IDENTITY, DVec3::new(0.5, 0.0, 0.0)),
            ("shift xyz", DMat3::IDENTITY, DVec3::new(0.5, 0.13, 0.07)),
            ("turned", turn, DVec3::new(0.5, 0.13, 0.07)),
        ] {
            let (a, b) = (carcass(&shape, DMat3::IDENTITY, DVec3::ZERO), carcass(&shape, turn, shift));
            let job = Job::new(1, &Quiet);
            let start = std::time::Instant::now();
            let pairs = a.candidates(&b, 0.0, &job).unwrap();
            let first = start.elapsed();
            let start = std::time::Instant::now();
            let paths = a.meet(&b, &Options::default(), &job).unwrap();
            let second = start.elapsed();
            println!("{h} {name}: {} pairs {first:?}, {second:?}: {}", pairs.len(), describe(&paths));
            let worst =
                paths.points.iter().zip(&paths.others).map(|(p, &o)| p.distance(b.jet(o).point)).fold(0.0, f64::max);
            println!("   apart {worst:e}");
        }
    }
}

struct Quiet;
impl gusset::job::Progress for Quiet {
    fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
        std::ops::ControlFlow::Continue(())
    }
}
