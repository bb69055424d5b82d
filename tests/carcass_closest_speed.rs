//! What nearest points take; prints figures and asserts nothing.

mod surfaces;

use glam::DVec3;
use gusset::carcass::{Carcass, Grid, Nodes, Scheme, Sheet};
use gusset::{Job, Progress};
use std::ops::ControlFlow;
use std::time::Instant;
use surfaces::{Random, torus};

struct Silent;

impl Progress for Silent {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

fn sheet(h: usize, w: usize, closed: bool, point: impl Fn(f64, f64) -> DVec3) -> Grid<'static> {
    let at = |k: usize, n: usize| (if closed { k % n } else { k }) as f64 / n as f64;
    let mut data = Vec::new();
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        data.extend(point(at(i, h), at(j, w)).to_array());
    }
    Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), [closed; 2], Scheme::SixTap).unwrap()
}

/// The least of several times, in seconds.
fn least(count: usize, mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..count).map(time).fold(f64::INFINITY, f64::min)
}

fn measure(name: &str, grid: &Grid<'static>, point: impl Fn(f64, f64) -> DVec3) {
    let [one, two] = [1, 2].map(|threads| Job::new(threads, &Silent));
    let build = |job: &Job<'_>| least(5, || drop(Carcass::new(vec![Sheet::Grid(grid.clone())], None, job)));
    let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &one).unwrap();
    let nodes = (grid.nodes().rows() * grid.nodes().columns()) as f64;
    println!(
        "{name}: build {:.1} ms, 2 threads {:.1} ms, index {:.2} B/node",
        1e3 * build(&one),
        1e3 * build(&two),
        carcass.index_bytes() as f64 / nodes
    );
    let mut random = Random(1);
    let count = 40_000;
    let near: Vec<DVec3> = (0..count).map(|_| point(random.next(), random.next()) + random.point(0.02)).collect();
    let far: Vec<DVec3> = (0..count).map(|_| random.point(2.5)).collect();
    for (kind, queries) in [("near", &near), ("far", &far)] {
        let run = |job: &Job<'_>| {
            1e6 / count as f64 * least(9, || drop(carcass.closest_all(queries, f64::INFINITY, job).unwrap()))
        };
        let single = 1e6 / count as f64
            * least(3, || queries.iter().for_each(|&query| drop(carcass.closest(query, f64::INFINITY).unwrap())));
        let found = carcass.closest_all(queries, f64::INFINITY, &one).unwrap();
        let unproven = found.iter().flatten().filter(|found| !found.proven).count();
        println!(
            "  {kind}: {:.2} us, 2 threads {:.2} us, one by one {single:.2} us, unproven {unproven}",
            run(&one),
            run(&two)
        );
    }
}

fn wavy(u: f64, v: f64) -> DVec3 {
    DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.2 * (9.0 * u).sin() * (7.0 * v + 1.0).cos())
}

#[test]
#[ignore = "prints figures"]
fn exhaustive_speed_of_closest() {
    let plain = |u: f64, v: f64| torus(u, v, 0.0);
    let bumpy = |u: f64, v: f64| torus(u, v, 0.15);
    measure("torus 25 x 49", &sheet(24, 48, true, plain), plain);
    measure("torus 101 x 101", &sheet(100, 100, true, plain), plain);
    measure("torus 708 x 1413", &sheet(707, 1412, true, plain), plain);
    measure("bumpy torus 708 x 1413", &sheet(707, 1412, true, bumpy), bumpy);
    measure("wavy sheet 1000 x 1000", &sheet(999, 999, false, wavy), wavy);
    if std::env::var_os("SLOW").is_some() {
        measure("torus 2237 x 4471", &sheet(2236, 4470, true, plain), plain);
    }
}
