//! Curves that run along lines of parameters that are borders of cells: whole, and once.

use crate::pairs::{check, length, one, summary};
use glam::DVec3;
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Patches, Paths, Sheet, Surface};

/// How the parameters of a surface run: u and v exchanged, and each reversed.
type Way = [bool; 3];

/// A sheet of patches of degree 2 in x and 1 in y over a rectangle, by the blossom of a height that
/// is quadratic in x.
fn sheet(
    [rows, columns]: [usize; 2],
    [[x0, x1], [y0, y1]]: [[f64; 2]; 2],
    [exchanged, back_x, back_y]: Way,
    point: &dyn Fn(f64, f64, f64) -> DVec3,
) -> Sheet<'static> {
    let at = |k: usize, n: usize, [low, high]: [f64; 2], back: bool| {
        let t = if back { n - k } else { k } as f64 / n as f64;
        low + t * (high - low)
    };
    let net = |i: usize, j: usize| {
        let (xs, ys) =
            ([i, i + 1].map(|i| at(i, rows, [x0, x1], back_x)), [j, j + 1].map(|j| at(j, columns, [y0, y1], back_y)));
        let net = [[0, 0], [0, 1], [1, 1]].map(|[k, n]| ys.map(|y| point(xs[k], xs[n], y)));
        let order: Vec<[usize; 2]> = match exchanged {
            true => (0..2).flat_map(|b| (0..3).map(move |a| [a, b])).collect(),
            false => (0..3).flat_map(|a| (0..2).map(move |b| [a, b])).collect(),
        };
        order.into_iter().map(move |[a, b]| net[a][b])
    };
    let points: Vec<DVec3> = match exchanged {
        true => (0..columns).flat_map(|j| (0..rows).map(move |i| [i, j])).flat_map(|[i, j]| net(i, j)).collect(),
        false => (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j])).flat_map(|[i, j]| net(i, j)).collect(),
    };
    let (degrees, counts) = if exchanged { ([1, 2], [columns, rows]) } else { ([2, 1], [rows, columns]) };
    Sheet::Cubic(Patches::new(&points, degrees, counts[0], counts[1]).unwrap())
}

fn all_ways() -> Vec<Way> {
    (0..8).map(|k| [k & 1 == 1, k & 2 == 2, k & 4 == 4]).collect()
}

fn meet(a: &Surface<'_>, b: &Surface<'_>) -> Paths {
    let paths = a.meet(b, &Options::default(), &Job::default()).unwrap();
    check(&paths, a, b);
    paths
}

/// z = x^2 - 1/4.
fn valley(x: f64, other: f64, y: f64) -> DVec3 {
    DVec3::new(0.5 * (x + other), y, x * other - 0.25)
}

fn plane(x: f64, other: f64, y: f64) -> DVec3 {
    DVec3::new(0.5 * (x + other), y, 0.0)
}

const SQUARE: [[f64; 2]; 2] = [[-1.0, 1.0]; 2];
const WIDER: [[f64; 2]; 2] = [[-1.3, 1.2], [-1.15, 1.25]];

/// Two lines, x = -1/2 and x = 1/2 from y = -1 to y = 1.
fn has_two_lines(paths: &Paths) -> bool {
    let is_line = |k: usize| {
        let points = paths.points_of(k);
        let ends = [points[0].y, points[points.len() - 1].y];
        let long: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        !paths.closed[k]
            && (ends[0].min(ends[1]) + 1.0).abs() < 1e-9
            && (ends[0].max(ends[1]) - 1.0).abs() < 1e-9
            && (long - 2.0).abs() < 1e-9
            && points.iter().all(|p| (p.x - points[0].x).abs() < 1e-9 && (p.x.abs() - 0.5).abs() < 1e-9)
    };
    paths.len() == 2 && (0..2).all(is_line) && paths.points_of(0)[0].x * paths.points_of(1)[0].x < 0.0
}

#[test]
fn lines_along_borders_of_patches() {
    let mut bad = Vec::new();
    let mut count = 0;
    for cells in (1..=12).flat_map(|h| [1, 2, 3, 4, 5, 8, 12].map(|w| [h, w])) {
        for others in [[1, 1], [2, 3], [4, 4], [5, 1]] {
            let (a, b) =
                (one(sheet(cells, SQUARE, [false; 3], &valley)), one(sheet(others, WIDER, [false; 3], &plane)));
            for (paths, way) in [(meet(&a, &b), "a b"), (meet(&b, &a), "b a")] {
                count += 1;
                if !has_two_lines(&paths) || !paths.unresolved.is_empty() {
                    bad.push(format!("{cells:?} {others:?} {way}: {} {}", summary(&paths), length(&paths)));
                }
            }
        }
    }
    for (own, other) in all_ways().into_iter().flat_map(|own| all_ways().into_iter().map(move |other| (own, other))) {
        for (cells, others, range) in
            [([4, 4], [1, 1], WIDER), ([4, 4], [4, 3], [[-2.0, 2.0], [-1.5, 1.5]]), ([8, 3], [8, 5], SQUARE)]
        {
            let (a, b) = (one(sheet(cells, SQUARE, own, &valley)), one(sheet(others, range, other, &plane)));
            let paths = meet(&a, &b);
            count += 1;
            if !has_two_lines(&paths) || !paths.unresolved.is_empty() {
                bad.push(format!("{own:?} {other:?} {cells:?} {others:?}: {} {}", summary(&paths), length(&paths)));
            }
        }
    }
    assert!(bad.is_empty(), "{} of {count}\n{}", bad.len(), bad.join("\n"));
}
