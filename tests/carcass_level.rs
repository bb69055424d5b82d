//! Sections, contours and curves of angle: against fine sampling, against circles, and against what closed surfaces demand.

mod surfaces;

use glam::{DVec2, DVec3};
use gusset::Job;
use gusset::carcass::level::{Between, Planes};
use gusset::carcass::{Carcass, Grid, Nodes, Paths, Place, Scheme, Sheet};
use std::f64::consts::TAU;
use surfaces::{Random, SHAPES, Shape, grid, torus};

fn carcass(shape: &Shape) -> Carcass<'static> {
    Carcass::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap()
}

fn torus_of(cells: [usize; 2]) -> Carcass<'static> {
    carcass(&Shape { name: "torus", cells, closed: [true, true], point: |u, v| torus(u, v, 0.0) })
}

fn length(paths: &Paths, k: usize) -> f64 {
    let points = paths.points_of(k);
    let around = if paths.closed[k] { points.len() } else { points.len() - 1 };
    (0..around).map(|i| points[i].distance(points[(i + 1) % points.len()])).sum()
}

/// What holds of all curves: offsets, flags, points at their places, normals.
fn check(carcass: &Carcass<'_>, paths: &Paths, name: &str) {
    assert_eq!(paths.ends.len(), paths.len() + 1, "{name}");
    assert_eq!((paths.levels.len(), paths.normals.len()), (paths.len(), paths.points.len()), "{name}");
    assert_eq!((paths.ends[0], paths.ends[paths.len()] as usize), (0, paths.points.len()), "{name}");
    assert!(paths.levels.is_sorted(), "{name}");
    for k in 0..paths.len() {
        assert!(paths.points_of(k).len() >= if paths.closed[k] { 3 } else { 2 }, "{name}");
        let points = paths.points_of(k);
        assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "{name}: repeated points");
    }
    for ((&place, &point), &normal) in paths.places.iter().zip(&paths.points).zip(&paths.normals) {
        assert!((0.0..=1.0).contains(&place.u) && (0.0..=1.0).contains(&place.v), "{name}: {place:?}");
        assert!(carcass.jet(place).point.distance(point) < 1e-13, "{name}: {place:?}");
        assert!(carcass.normal(place).distance(normal) < 1e-9, "{name}: {place:?}");
    }
}

/// Connected parts of the zero set by marching over a very fine sampling of the surface: closed and open ones.
fn by_sampling(grid: &Grid<'_>, closed: [bool; 2], fine: usize, value: impl Fn(&Grid<'_>, usize, usize, f64, f64) -> f64) -> [usize; 2] {
    let [h, w] = grid.cells();
    let (rows, columns) = (h * fine, w * fine);
    let at = |r: usize, c: usize| {
        let split = |k: usize, n: usize| if k == n * fine { (n - 1, 1.0) } else { (k / fine, (k % fine) as f64 / fine as f64) };
        let ((i, u), (j, v)) = (split(r, h), split(c, w));
        value(grid, i, j, u, v) >= 0.0
    };
    let mut signs = vec![false; (rows + 1) * (columns + 1)];
    for (r, c) in (0..=rows).flat_map(|r| (0..=columns).map(move |c| (r, c))) {
        let (r0, c0) = (if closed[0] { r % rows } else { r }, if closed[1] { c % columns } else { c });
        signs[r * (columns + 1) + c] = at(r0, c0);
    }
    // Triangles: no saddles to decide. Edges are numbered by node and direction, and linked through triangles.
    let sign = |r: usize, c: usize| signs[r * (columns + 1) + c];
    let node = |r: usize, c: usize| {
        (if closed[0] { r % rows } else { r }) * (columns + 1) + if closed[1] { c % columns } else { c }
    };
    let mut parent: std::collections::HashMap<usize, usize> = std::collections::HashMap::new();
    let mut count: std::collections::HashMap<usize, usize> = std::collections::HashMap::new();
    fn root(parent: &mut std::collections::HashMap<usize, usize>, mut k: usize) -> usize {
        while let Some(&up) = parent.get(&k) {
            if up == k { break; }
            k = up;
        }
        k
    }
    for (r, c) in (0..rows).flat_map(|r| (0..columns).map(move |c| (r, c))) {
        let edges = [
            (3 * node(r, c), (r, c), (r, c + 1)),
            (3 * node(r, c + 1) + 1, (r, c + 1), (r + 1, c + 1)),
            (3 * node(r, c) + 2, (r, c), (r + 1, c + 1)),
            (3 * node(r + 1, c), (r + 1, c), (r + 1, c + 1)),
            (3 * node(r, c) + 1, (r, c), (r + 1, c)),
        ];
        for triangle in [[0, 1, 2], [2, 3, 4]] {
            let crossed: Vec<usize> = triangle
                .into_iter()
                .filter(|&k| sign(edges[k].1.0, edges[k].1.1) != sign(edges[k].2.0, edges[k].2.1))
                .map(|k| edges[k].0)
                .collect();
            if let [a, b] = crossed[..] {
                for k in [a, b] {
                    parent.entry(k).or_insert(k);
                    *count.entry(k).or_insert(0) += 1;
                }
                let (a, b) = (root(&mut parent, a), root(&mut parent, b));
                if a != b {
                    parent.insert(a.max(b), a.min(b));
                }
            }
        }
    }
    let mut open: std::collections::HashMap<usize, bool> = std::collections::HashMap::new();
    let keys: Vec<usize> = parent.keys().copied().collect();
    for k in keys {
        let top = root(&mut parent, k);
        *open.entry(top).or_insert(false) |= count[&k] == 1;
    }
    let opened = open.values().filter(|&&open| open).count();
    [open.len() - opened, opened]
}

#[test]
fn sections_by_sampling() {
    for shape in &SHAPES {
        let (grid, carcass) = (grid(shape), carcass(shape));
        let mut random = Random(11);
        let mut total = 0;
        for k in 0..12 {
            let (point, normal) = (random.point(0.7), random.point(1.0));
            let planes = Planes { point, normal, offsets: &[0.0] };
            let paths = carcass.section(&planes, Between::Auto, &Job::default()).unwrap();
            check(&carcass, &paths, shape.name);
            let unit = normal.normalize();
            for (&at, &direction) in paths.points.iter().zip(&paths.normals) {
                assert!((at - point).dot(unit).abs() < 1e-13, "{}", shape.name);
                assert!(direction.length() > 0.99);
            }
            let truth = by_sampling(&grid, shape.closed, 12, |grid, i, j, u, v| {
                (grid.patch(i, j).point(u, v) - point).dot(unit)
            });
            let closed = paths.closed.iter().filter(|&&closed| closed).count();
            assert_eq!([closed, paths.len() - closed], truth, "{} {k}", shape.name);
            assert!(paths.unresolved.is_empty(), "{} {k}: {:?}", shape.name, paths.unresolved);
            total += paths.len();
        }
        assert!(total > 8, "{}", shape.name);
    }
}

#[test]
#[ignore = "timing"]
fn timing() {
    let carcass = torus_of([707, 1412]);
    let job = Job::new(1, &Quiet);
    let mut random = Random(5);
    for between in [Between::Nothing, Between::Auto] {
        let mut times = Vec::new();
        let mut count = 0;
        for k in 0..40 {
            let planes = Planes { point: random.point(0.3), normal: random.point(1.0), offsets: &[0.0] };
            let start = std::time::Instant::now();
            let paths = carcass.section(&planes, between, &job).unwrap();
            times.push(start.elapsed().as_secs_f64() * 1e3);
            count += paths.points.len();
            assert!(paths.closed.iter().all(|&c| c) && paths.unresolved.is_empty());
        }
        times.sort_by(f64::total_cmp);
        println!("{between:?}: min {:.3} median {:.3} ms, {} points each", times[0], times[20], count / 40);
    }
}

struct Quiet;
impl gusset::Progress for Quiet {
    fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
        std::ops::ControlFlow::Continue(())
    }
}
