//! Angles of normals round poles, where the derivatives along one side vanish.

use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use std::f64::consts::PI;

/// At a pole a side's normals vanish in the parameters: the cells there hide no angle.
#[test]
fn nearest_angles_at_poles() {
    for (tilt, size) in [(0.0, 1.0), (0.0, 1e-6), (0.05, 1e9), (0.1, 1e-9)] {
        let nodes = (0..9).flat_map(|i| (0..17).map(move |j| (0.12 * f64::from(i), PI / 8.0 * f64::from(j % 16))));
        let turn = DMat3::from_rotation_x(tilt);
        let point = |(down, round): (f64, f64)| {
            turn * DVec3::new(down.sin() * round.cos(), down.sin() * round.sin(), down.cos()) * size
        };
        let nodes: Vec<f64> = nodes.flat_map(|at| point(at).to_array()).collect();
        let nodes = Nodes::strided(nodes, 9, 17, 0, 0).unwrap();
        let grid = Grid::new(nodes, [false, true], Scheme::SixTap).unwrap();
        let cap = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        for (k, unsigned) in (1..16).flat_map(|k| [(k, false), (k, true)]) {
            let goal = 0.01 * f64::from(k * k) * 0.3;
            let found = cap.nearest_angle(DVec3::Z, goal, unsigned, &Job::default()).unwrap().unwrap();
            let deviation = |normal: DVec3| {
                let given = normal.angle_between(DVec3::Z);
                (if unsigned { given.min(PI - given) } else { given } - goal).abs()
            };
            // One for each of many places, but the pole itself.
            let places = (0..4000).map(|k| (k / 500, k / 25 % 20 % 16, f64::from(k as u32 % 25) / 24.0));
            let normals = places.map(|(i, j, v)| grid.patch(i, j).jet(0.01 + 0.98 * v, 0.3).normal());
            let least = normals.map(deviation).fold(f64::INFINITY, f64::min);
            assert!(
                found.deviation <= least + 1e-9 && found.bound <= least + 1e-12,
                "{tilt} {size} {goal}: {found:?} {least}"
            );
        }
    }
}
