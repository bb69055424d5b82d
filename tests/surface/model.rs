//! The surface through a grid of nodes: interpolation, and distance from the truth.

use glam::DVec3;
use gusset::surface::{Grid, Nodes, Scheme};
use std::f64::consts::TAU;

fn torus(u: f64, v: f64) -> DVec3 {
    let ring = 1.0 + 0.4 * u.cos();
    DVec3::new(ring * v.cos(), ring * v.sin(), 0.4 * u.sin())
}

/// h x w cells, closed both ways: the last lines repeat the first to the bit.
fn nodes(h: usize, w: usize) -> Vec<f64> {
    let angle = |k: usize, n: usize| TAU * (k % n) as f64 / n as f64;
    let node = |k: usize| torus(angle(k / (w + 1), h), angle(k % (w + 1), w));
    (0..(h + 1) * (w + 1)).flat_map(|k| node(k).to_array()).collect()
}

/// The largest errors of position and normal over all cells, at 5 x 5 places each.
fn errors(h: usize, w: usize, scheme: Scheme) -> [f64; 2] {
    let data = nodes(h, w);
    let grid = Grid::new(Nodes::strided(&data[..], h + 1, w + 1, 0, 0).unwrap(), [true, true], scheme).unwrap();
    let mut worst = [0.0_f64; 2];
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = grid.patch(i, j);
        for (s, t) in (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0)) {
            let (u, v) = (TAU * (i as f64 + s) / h as f64, TAU * (j as f64 + t) / w as f64);
            let normal = DVec3::new(u.cos() * v.cos(), u.cos() * v.sin(), u.sin());
            let jet = patch.jet(s, t);
            worst[0] = worst[0].max(jet.point.distance(torus(u, v)));
            let found = jet.normal().normalize();
            worst[1] = worst[1].max(found.cross(normal).length());
        }
    }
    worst
}

#[test]
fn orders_on_a_torus() {
    let six = [16, 32, 64].map(|h| errors(h, 2 * h, Scheme::SixTap));
    let four = [16, 32, 64].map(|h| errors(h, 2 * h, Scheme::FourPoint));
    let order = |a: f64, b: f64| (a / b).log2();
    for k in 0..2 {
        assert!(order(six[k][0], six[k + 1][0]) >= 3.8, "position: {six:?}");
        assert!(order(six[k][1], six[k + 1][1]) >= 2.9, "normal: {six:?}");
        assert!(order(four[k][0], four[k + 1][0]) >= 3.8, "position: {four:?}");
    }
    // The constants 1/384 and 3/128.
    let ratio = four[2][0] / six[2][0];
    assert!((8.5..9.5).contains(&ratio), "{ratio}");
}
