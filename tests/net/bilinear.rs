//! The area of bilinear patches against dense subdivision, formulas, and plane cells.

use crate::common::Silent;
use crate::space::{Random, sheet, sphere, torus};
use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::Net;
use gusset::net::measure::{bilinear_area, measure};

fn cell([a, b, c, d]: [DVec3; 4]) -> Net<'static> {
    let topology = sheet(2, 2, Scalar::F64).topology().clone();
    Net::from_fn(topology, Scalar::F64, |i, j| [[a, b], [d, c]][i][j]).unwrap()
}

/// The areas of n x n parts of a patch by their diagonals.
fn divided([a, b, c, d]: [DVec3; 4], n: usize) -> f64 {
    let at =
        |i: usize, j: usize| a.lerp(b, j as f64 / n as f64).lerp(d.lerp(c, j as f64 / n as f64), i as f64 / n as f64);
    let part = |i: usize, j: usize| (at(i + 1, j + 1) - at(i, j)).cross(at(i + 1, j) - at(i, j + 1)).length() / 2.0;
    (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| part(i, j)).sum()
}

#[test]
fn patches_are_as_large_as_dense_subdivision_says() {
    let mut random = Random(17);
    let mut worst = 0.0f64;
    for k in 0..60 {
        // From nearly plane cells to corners anywhere, also folded.
        let bend = [1e-9, 1e-3, 0.05, 0.3, 1.0, 3.0][k % 6];
        let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y].map(|p| p + bend * random.vector());
        let found = bilinear_area(&cell(square), &Job::default()).unwrap();
        // The error of subdivision falls by 4 and by 16 with the halving of its parts, where smooth.
        let [one, two, four] = [100, 200, 400].map(|n| divided(square, n));
        let [first, second] = [(4.0 * two - one) / 3.0, (4.0 * four - two) / 3.0];
        let expected = (16.0 * second - first) / 15.0;
        let bound = 1e-11 + 4.0 * (second - first).abs();
        assert!((found.area - expected).abs() <= bound, "{k}: {} {expected} {bound:e}", found.area);
        assert!(found.error_bound <= 1e-12 * (1.0 + found.area), "{k}: {found:?}");
        worst = worst.max((found.area - expected).abs() / expected);
    }
    println!("worst {worst:e}");
}

#[test]
fn formulas() {
    let area = |corners: [DVec3; 4]| bilinear_area(&cell(corners), &Job::default()).unwrap().area;
    // z = x y over the unit square: the integral of sqrt(1 + x^2 + y^2). The inner integral is
    // elementary; Romberg's method with two steps computes the outer one.
    let inner = |x: f64| {
        let h = 1.0 + x * x;
        0.5 * ((h + 1.0).sqrt() + h * (1.0 / h.sqrt()).asinh())
    };
    let mut table: Vec<f64> = Vec::new();
    for level in 0..10u32 {
        let n = 1usize << level;
        let mut row = vec![
            (0..=n).map(|k| if k == 0 || k == n { 0.5 } else { 1.0 } * inner(k as f64 / n as f64)).sum::<f64>()
                / n as f64,
        ];
        for (k, &before) in table.iter().enumerate() {
            let ratio = 4f64.powi(k as i32 + 1);
            row.push((ratio * row[k] - before) / (ratio - 1.0));
        }
        table = row;
    }
    let saddle = [DVec3::ZERO, DVec3::X, DVec3::ONE, DVec3::Y];
    assert!((area(saddle) - table[9]).abs() < 2e-15, "{} {}", area(saddle), table[9]);
    // Plane cells, a triangle, a line, a point.
    let flat = [DVec3::ZERO, DVec3::new(3.0, 0.0, 0.0), DVec3::new(2.0, 2.0, 0.0), DVec3::new(0.5, 1.0, 0.0)];
    assert!((area(flat) - 3.5).abs() < 1e-15, "{}", area(flat));
    assert!((area([DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y]) - 0.5).abs() < 1e-15);
    assert_eq!(area([DVec3::ZERO, DVec3::X, 2.0 * DVec3::X, 3.0 * DVec3::X]), 0.0);
    assert_eq!(area([DVec3::ONE; 4]), 0.0);
    // A bow tie in a plane: the normal is 1 - 2 v times a constant, of either sign: two triangles
    // of a quarter.
    assert!((area([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y]) - 0.5).abs() < 1e-14);
}

#[test]
fn nets() {
    for net in [sphere(17, 33, Scalar::F64), torus(17, 33, Scalar::F64), sheet(5, 9, Scalar::F64)] {
        let (found, plane) =
            (bilinear_area(&net, &Job::default()).unwrap(), measure(&net, &Job::default()).unwrap().area);
        assert!((found.area - plane).abs() < 1e-12 && found.error_bound < 1e-11, "{found:?} {plane}");
    }
    let mut random = Random(2);
    let topology = sheet(70, 90, Scalar::F32).topology().clone();
    let rough = |i: usize, j: usize| DVec3::new(j as f64, i as f64, 0.0) + 0.4 * random.vector();
    let mut net = Net::from_fn(topology, Scalar::F32, rough).unwrap();
    let area = |net: &Net<'_>, threads| bilinear_area(net, &Job::new(threads, &Silent)).unwrap();
    assert_eq!(area(&net, 1), area(&net, 3));
    assert!(area(&net, 1).area > measure(&net, &Job::default()).unwrap().area);
    // Cells that touch a missing node are not there.
    let corners = |net: &Net<'_>, i: usize, j: usize| {
        [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| net.get(i, j))
    };
    let around: f64 =
        [(3, 4), (3, 5), (4, 4), (4, 5)].map(|(i, j)| area(&cell(corners(&net, i, j)), 1).area).iter().sum();
    let whole = area(&net, 1).area;
    net.coordinates_mut().set(4, 5, DVec3::NAN);
    assert!((whole - around - area(&net, 1).area).abs() < 1e-11);
}

#[test]
fn scans_are_larger_than_their_diagonals_say() {
    for file in ["bun000_range_214x313", "bun045_range_221x296", "depthcam_table_scene_mug_stereo_textured_240x320"] {
        let Some((size, numbers)) = crate::grids::npz(&format!("{file}.npz"), "xyz") else { return };
        let topology = sheet(size[0], size[1], Scalar::F64).topology().clone();
        let net = Net::from_fn(topology, Scalar::F64, |i, j| {
            let k = 3 * (i * size[1] + j);
            DVec3::new(numbers[k], numbers[k + 1], numbers[k + 2])
        })
        .unwrap();
        let (found, diagonals) =
            (bilinear_area(&net, &Job::default()).unwrap(), measure(&net, &Job::default()).unwrap().area);
        println!(
            "{file}: bilinear {} error {:e} diagonals {diagonals}: {} %",
            found.area,
            found.error_bound,
            100.0 * (found.area / diagonals - 1.0)
        );
        assert!(
            found.area > diagonals && found.area < 1.1 * diagonals && found.error_bound < 1e-10 * found.area,
            "{file}"
        );
    }
}

/// Plane cells that may fold over themselves: the integral of |A + B u + C v| has the second
/// antiderivative |x|^3 / (6 B C), which is exact for integers.
#[test]
fn folded_plane_cells_have_the_area_of_their_formula() {
    let mut random = Random(91);
    let mut folded = 0;
    for case in 0..6000 {
        let mut corner = || [0; 2].map(|_| (random.next() * 4.5).floor() as i64);
        let [a, b, c, d] = [corner(), corner(), corner(), corner()];
        let minus = |p: [i64; 2], q: [i64; 2]| [p[0] - q[0], p[1] - q[1]];
        let cross = |p: [i64; 2], q: [i64; 2]| p[0] * q[1] - p[1] * q[0];
        let (p, q) = (minus(b, a), minus(d, a));
        let e = minus(minus(c, d), p);
        let (n0, n1, n2) = (cross(p, q), cross(p, e), cross(e, q));
        if n1 * n2 == 0 {
            continue;
        }
        let cube = |x: i64| x.abs().pow(3);
        let whole = cube(n0 + n1 + n2) - cube(n0 + n1) - cube(n0 + n2) + cube(n0);
        let expected = whole as f64 / (6 * n1 * n2) as f64;
        let signs = [n0, n0 + n1, n0 + n2, n0 + n1 + n2].map(i64::signum);
        folded += i32::from(signs.contains(&1) && signs.contains(&-1));
        let corners = [a, b, c, d].map(|[x, y]| DVec3::new(x as f64, y as f64, 0.0));
        for unit in [1.0, 1e-140, 1e-40, 1e40, 1e140] {
            let found = bilinear_area(&cell(corners.map(|p| p * unit)), &Job::default()).unwrap();
            let [area, error] = [found.area, found.error_bound].map(|x| x / unit / unit);
            assert!((area - expected).abs() <= error + 1e-13, "{case} {unit}: {area} {expected} {error}");
            assert!(error <= 1e-11, "{case} {unit}: {error}");
        }
    }
    assert!(folded > 1000, "{folded}");
}

/// Cells that are nearly plane, and folded: turned by a quarter, and cut in four, they are as
/// large.
#[test]
fn folded_cells_are_as_large_however_they_are_cut() {
    let mut random = Random(92);
    for case in 0..2000 {
        let height = [1e-12, 1e-9, 1e-6, 1e-3][case % 4];
        let corners = [(); 4].map(|()| random.vector() * DVec3::new(1.0, 1.0, height));
        let [a, b, c, d] = corners;
        let area = |corners| bilinear_area(&cell(corners), &Job::default()).unwrap();
        let (whole, turned) = (area(corners), area([b, c, d, a]));
        let (ab, bc, cd, da, middle) =
            (a.midpoint(b), b.midpoint(c), c.midpoint(d), d.midpoint(a), (a + b + c + d) / 4.0);
        let parts = [[a, ab, middle, da], [ab, b, bc, middle], [middle, bc, c, cd], [da, middle, cd, d]].map(area);
        let sum: f64 = parts.iter().map(|part| part.area).sum();
        let bound =
            4.0 * (whole.error_bound + turned.error_bound) + parts.iter().map(|part| part.error_bound).sum::<f64>();
        assert!(bound < 1e-11, "{case}: {bound}");
        assert!((whole.area - turned.area).abs() <= bound, "{case}: {} {}", whole.area, turned.area);
        assert!((whole.area - sum).abs() <= bound, "{case}: {} {sum}", whole.area);
    }
}
