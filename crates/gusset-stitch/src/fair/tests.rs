//! Tests thin-plate fairing with known shapes and equations.

use super::exact_laplacian::ExactLaplacian;
use super::one_rings::OneRings;
use super::{Continuity, LaplacianWeights, Plate, RestShape, mean_curvature, minimise_plate_energy};
use glam::{DQuat, DVec3};
use gusset_base::Job;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

const ALL_WEIGHTS: [LaplacianWeights; 2] = [LaplacianWeights::Uniform, LaplacianWeights::Cotangent];

/// A patch with free vertices.
#[derive(Clone)]
struct TestPatch {
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    free: Vec<bool>,
}

impl TestPatch {
    /// Returns the free vertices, and their neighbours that are not on the patch's own border.
    fn free_vertices_and_neighbours(&self) -> Vec<bool> {
        let edges: BTreeSet<[u32; 2]> = self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        let mut centres = self.free.clone();
        for &[a, b] in edges.iter().filter(|&&[a, b]| self.free[a as usize] || self.free[b as usize]) {
            centres[a as usize] = true;
            centres[b as usize] = true;
        }
        for &[a, b] in edges.iter().filter(|&&[a, b]| !edges.contains(&[b, a])) {
            centres[a as usize] = self.free[a as usize];
            centres[b as usize] = self.free[b as usize];
        }
        centres
    }

    fn fair_with_own_centres(&mut self, weights: LaplacianWeights) {
        self.fair_with_centres(&self.free_vertices_and_neighbours(), weights);
    }

    fn fair_with_centres(&mut self, centres: &[bool], weights: LaplacianWeights) {
        self.fair_with_rest_curvature(centres, weights, None);
    }

    fn fair_with_rest_curvature(&mut self, centres: &[bool], weights: LaplacianWeights, curvature: Option<&[DVec3]>) {
        let (triangles, free) = (&self.triangles, &self.free);
        let places = self.points.clone();
        // The reach is far beyond the patch, so that the springs do not matter.
        let shape =
            curvature.map(|curvature| RestShape { curvature, rest_positions: &places, max_width_without_springs: 1e9 });
        let plate = Plate {
            triangles,
            is_free_vertex: free,
            has_laplacian_in_energy: centres,
            weights,
            continuity: Continuity::C1,
            shape,
            ordering_positions: None,
        };
        minimise_plate_energy(&mut self.points, &plate, &Job::default()).unwrap();
    }
}

/// Returns a disk of radius 1 in the plane z = 0, with a middle vertex and `rings` rings of 6 i
/// vertices. All vertices except the last two rings are free.
fn disk_patch(rings: u32) -> TestPatch {
    let first = |i: u32| if i == 0 { 0 } else { 3 * i * (i - 1) + 1 };
    let vertex = |i: u32, k: u32| if i == 0 { 0 } else { first(i) + k % (6 * i) };
    let (mut points, mut triangles) = (vec![DVec3::ZERO], Vec::new());
    for i in 1..=rings {
        for k in 0..6 * i {
            let angle = TAU * f64::from(k) / f64::from(6 * i);
            points.push(DVec3::new(angle.cos(), angle.sin(), 0.0) * f64::from(i) / f64::from(rings));
        }
        for side in 0..6 {
            for k in 0..i {
                let (outer, inner) = (side * i + k, side * (i - 1) + k);
                triangles.push([vertex(i, outer), vertex(i, outer + 1), vertex(i - 1, inner)]);
                if k + 1 < i {
                    triangles.push([vertex(i - 1, inner), vertex(i, outer + 1), vertex(i - 1, inner + 1)]);
                }
            }
        }
    }
    let free = (0..points.len() as u32).map(|v| v < first(rings - 1)).collect();
    TestPatch { points, triangles, free }
}

/// Returns a reproducible number from -1 to 1.
fn reproducible_noise(i: usize) -> f64 {
    ((i as f64 * 12.9898).sin() * 43758.5453).fract()
}

#[test]
fn a_plane_stays_a_plane() {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 1.0);
    let away = DVec3::new(100.0, -200.0, 50.0);
    for weights in ALL_WEIGHTS {
        let mut patch = disk_patch(8);
        for (i, p) in patch.points.iter_mut().enumerate() {
            *p += DVec3::new(reproducible_noise(i), reproducible_noise(i + 1000), 0.0) * 0.03;
            *p = turn * *p + away;
        }
        patch.fair_with_own_centres(weights);
        for p in &patch.points {
            assert!((turn.inverse() * (*p - away)).z.abs() < 1e-12, "{weights:?}");
        }
    }
}

#[test]
fn fixed_vertices_keep_their_bits_and_free_ones_forget_where_they_were() {
    let mut patch = disk_patch(6);
    for (i, p) in patch.points.iter_mut().enumerate() {
        p.z = (3.0 * p.x).sin() + 0.1 * reproducible_noise(i);
    }
    let mut other = patch.clone();
    for v in (0..other.points.len()).filter(|&v| other.free[v]) {
        other.points[v] += DVec3::new(reproducible_noise(v), reproducible_noise(v + 7), reproducible_noise(v + 99));
    }
    let before = patch.points.clone();
    patch.fair_with_own_centres(LaplacianWeights::Uniform);
    other.fair_with_own_centres(LaplacianWeights::Uniform);
    for (v, &was) in before.iter().enumerate() {
        assert_eq!(patch.points[v] == was, !patch.free[v]);
        assert!(patch.points[v].distance(other.points[v]) < 1e-12);
    }
}

/// On a nearly flat disk, the energy with cotangent weights is the thin plate's. Biharmonic
/// functions minimise it, with an error of second order in the edge length.
#[test]
fn biharmonic_functions_are_found() {
    let height = |p: DVec3| 1e-4 * (p.length_squared() * (p.x + 1.0) + p.x * p.y);
    let error = |rings: u32| {
        let mut patch = disk_patch(rings);
        for v in 0..patch.points.len() {
            patch.points[v].z = if patch.free[v] { 0.0 } else { height(patch.points[v]) };
        }
        patch.fair_with_own_centres(LaplacianWeights::Cotangent);
        patch.points.iter().map(|&p| (p.z - height(p)).abs()).fold(0.0, f64::max) / 1e-4
    };
    let errors = [8, 16, 32].map(error);
    assert!(errors[0] < 0.03 && errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0, "{errors:?}");
}

/// The cap has radius R on the unit sphere. The biharmonic surface with the sphere's height and
/// slope at the rim deviates by at most R^4 / 8.
#[test]
fn a_hole_in_a_sphere_is_domed() {
    for weights in ALL_WEIGHTS {
        for radius in [0.2, 0.4] {
            let mut patch = disk_patch(16);
            let on_sphere = |p: DVec3| DVec3::new(p.x, p.y, (1.0 - p.x * p.x - p.y * p.y).sqrt());
            let rim = on_sphere(DVec3::X * radius).z;
            for v in 0..patch.points.len() {
                let flat = patch.points[v] * radius;
                patch.points[v] = if patch.free[v] { flat + DVec3::Z * rim } else { on_sphere(flat) };
            }
            patch.fair_with_own_centres(weights);
            let error = patch.points.iter().map(|p| (p.length() - 1.0).abs()).fold(0.0, f64::max);
            // Uniform weights mistake the disk's six corners for bends: 5 % of the dome's height.
            let bound = if weights == LaplacianWeights::Cotangent {
                1.2 * radius.powi(4) / 8.0
            } else {
                0.025 * radius * radius
            };
            assert!(error < bound, "{weights:?}: {error} at {radius}");
        }
    }
}

/// Returns a tube of `rows` rows with `around` vertices each. All rows except the outer two on each
/// side are free.
fn tube_patch(around: u32, rows: u32) -> TestPatch {
    let (mut points, mut triangles, mut free) = (Vec::new(), Vec::new(), Vec::new());
    for row in 0..rows {
        for k in 0..around {
            let angle = TAU * f64::from(k) / f64::from(around);
            let height = TAU * f64::from(row) / f64::from(around);
            points.push(DVec3::new(angle.cos(), angle.sin(), height));
            free.push((2..rows - 2).contains(&row));
            let [a, b] = [row * around + k, row * around + (k + 1) % around];
            if row + 1 < rows {
                triangles.extend([[a, b, a + around], [b, b + around, a + around]]);
            }
        }
    }
    TestPatch { points, triangles, free }
}

#[test]
fn a_gap_in_a_cylinder_gets_its_waist_back() {
    for weights in ALL_WEIGHTS {
        let mut patch = tube_patch(60, 9);
        for (v, p) in patch.points.iter_mut().enumerate() {
            if patch.free[v] {
                *p *= DVec3::new(0.95, 0.95, 1.0);
            }
        }
        patch.fair_with_own_centres(weights);
        for p in &patch.points {
            assert!((p.truncate().length() - 1.0).abs() < 5e-3, "{weights:?} {p}");
        }
    }
}

#[test]
fn symmetric_input_gives_symmetric_output() {
    // The disk is symmetric under a sixth of a turn, up to the numbering of each ring.
    for weights in ALL_WEIGHTS {
        let mut patch = disk_patch(7);
        for p in &mut patch.points {
            let angle = p.y.atan2(p.x);
            p.z = 0.3 * p.length_squared() * (6.0 * angle).cos();
        }
        patch.fair_with_own_centres(weights);
        let turn = DQuat::from_rotation_z(TAU / 6.0);
        for &p in &patch.points {
            let nearest = patch.points.iter().map(|q| q.distance(turn * p)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-12, "{weights:?} {nearest}");
        }
    }
}

/// At the minimum, moving a vertex cannot reduce the energy. The test computes the energy in its
/// own way.
#[test]
fn the_energy_is_least() {
    let mut patch = disk_patch(6);
    for (i, p) in patch.points.iter_mut().enumerate() {
        *p += DVec3::new(reproducible_noise(i), reproducible_noise(i + 1000), reproducible_noise(i + 2000)) * 0.2;
    }
    let centres = patch.free_vertices_and_neighbours();
    let mut neighbours = vec![BTreeSet::new(); patch.points.len()];
    for &[a, b, c] in &patch.triangles {
        for [u, v] in [[a, b], [b, c], [c, a]] {
            neighbours[u as usize].insert(v as usize);
            neighbours[v as usize].insert(u as usize);
        }
    }
    let energy = |points: &[DVec3]| -> f64 {
        let mean = |v: usize| neighbours[v].iter().map(|&w| points[w]).sum::<DVec3>() / neighbours[v].len() as f64;
        (0..points.len()).filter(|&v| centres[v]).map(|v| (mean(v) - points[v]).length_squared()).sum()
    };
    let before = energy(&patch.points);
    patch.fair_with_own_centres(LaplacianWeights::Uniform);
    let least = energy(&patch.points);
    assert!(least < before / 2.0);
    for v in (0..patch.points.len()).filter(|&v| patch.free[v]) {
        for by in [DVec3::X, DVec3::Y, DVec3::Z] {
            let mut sides = [1e-4, -1e-4].map(|h| {
                let mut moved = patch.points.clone();
                moved[v] += by * h;
                energy(&moved) - least
            });
            sides.sort_by(f64::total_cmp);
            assert!(sides[0] > 0.0 && (sides[1] - sides[0]) < 1e-6 * sides[1], "{v} {sides:?}");
        }
    }
}

#[test]
fn a_single_free_vertex_moves_to_the_mean() {
    // With uniform weights and itself as the only centre, a vertex moves to the mean of its
    // neighbours.
    let mut patch = disk_patch(1);
    patch.free = vec![true, false, false, false, false, false, false];
    patch.points[0] = DVec3::new(0.3, 0.2, 5.0);
    let centres = patch.free.clone();
    patch.fair_with_centres(&centres, LaplacianWeights::Uniform);
    assert!(patch.points[0].length() < 1e-15);
}

#[test]
fn vertices_that_nothing_determines_stay() {
    for weights in ALL_WEIGHTS {
        // All vertices are free: the energy is 0 wherever the patch shrinks to a point.
        let mut patch = disk_patch(4);
        patch.free.fill(true);
        let before = patch.points.clone();
        patch.fair_with_own_centres(weights);
        assert_eq!(patch.points, before);

        // Without centres the energy is 0.
        let mut patch = disk_patch(4);
        let none = vec![false; patch.points.len()];
        patch.fair_with_centres(&none, weights);
        assert_eq!(patch.points, before);

        // Add a second disk far away, loose vertices, and degenerate triangles.
        let mut patch = disk_patch(4);
        let count = patch.points.len() as u32;
        patch.points.extend(before.iter().map(|&p| p + DVec3::X * 10.0));
        let again: Vec<_> = patch.triangles.iter().map(|t| t.map(|v| v + count)).collect();
        patch.triangles.extend(again);
        patch.points.extend([DVec3::ONE, DVec3::NEG_ONE]);
        patch.triangles.extend([[2 * count, 2 * count, 0], [2 * count, 2 * count + 1, 2 * count]]);
        patch.free.resize(patch.points.len(), true);
        patch.points[0].z = 1.0;
        patch.fair_with_own_centres(weights);
        assert!(patch.points[0].z.abs() < 1e-9, "{weights:?}");
        assert_eq!(patch.points[2 * count as usize], DVec3::ONE);
        assert!((count..2 * count).all(|v| patch.points[v as usize].x > 8.0));
    }
}

#[test]
fn one_centre_moves_one_vertex() {
    // One centre among seven free vertices: one of them makes the sum 0, and the others stay.
    for weights in ALL_WEIGHTS {
        let mut patch = disk_patch(3);
        for (i, p) in patch.points.iter_mut().enumerate() {
            *p += DVec3::new(reproducible_noise(i), reproducible_noise(i + 1000), reproducible_noise(i + 2000)) * 0.1;
        }
        let before = patch.points.clone();
        let centres: Vec<bool> = (0..before.len()).map(|v| v == 0).collect();
        patch.fair_with_centres(&centres, weights);
        let moved: Vec<f64> = before.iter().zip(&patch.points).map(|(p, q)| p.distance(*q)).collect();
        assert_eq!(moved.iter().filter(|&&by| by > 1e-12).count(), 1, "{weights:?} {moved:?}");
        assert!(moved.iter().all(|&by| by < 2.0), "{weights:?} {moved:?}");
    }
}

#[test]
fn degenerate_patches_do_no_harm() {
    for weights in ALL_WEIGHTS {
        for size in [0.0, 1e-300, 1e300] {
            let mut patch = disk_patch(4);
            patch.points.iter_mut().for_each(|p| *p *= size);
            // Half of the free vertices coincide.
            for v in (0..10).filter(|v| v % 2 == 0) {
                patch.points[v] = patch.points[0];
            }
            patch.fair_with_own_centres(weights);
            assert!(patch.points.iter().all(|p| p.abs().max_element() <= 1.1 * size), "{weights:?} {size}");
        }
    }
    let (triangles, free, centres, weights) = (&[], &[], &[], LaplacianWeights::Uniform);
    let plate = Plate {
        triangles,
        is_free_vertex: free,
        has_laplacian_in_energy: centres,
        weights,
        continuity: Continuity::C1,
        shape: None,
        ordering_positions: None,
    };
    let nothing = minimise_plate_energy(&mut [], &plate, &Job::default());
    assert_eq!(nothing, Ok(()));
}

/// A perturbed cap of a ball is restored if the rest curvature is the ball's, in any unit. A flat
/// plate stays below it.
#[test]
fn a_bent_plate_has_its_own_shape() {
    const BALL_RADIUS: f64 = 1.2;
    for size in [1e-3, 1.0, 1e3] {
        let mut patch = disk_patch(12);
        for p in &mut patch.points {
            p.z = (BALL_RADIUS * BALL_RADIUS - p.x * p.x - p.y * p.y).sqrt();
            *p *= size;
        }
        let ball = patch.points.clone();
        // Twice the mean curvature, towards the centre.
        let curvature: Vec<DVec3> = ball.iter().map(|p| -2.0 * p / (BALL_RADIUS * size).powi(2)).collect();
        let farthest = |patch: &TestPatch| {
            patch.points.iter().map(|p| (p.length() / (BALL_RADIUS * size) - 1.0).abs()).fold(0.0, f64::max)
        };
        for (v, p) in patch.points.iter_mut().enumerate().filter(|&(v, _)| patch.free[v]) {
            p.z += 0.02 * reproducible_noise(v) * size;
        }
        let centres = patch.free_vertices_and_neighbours();
        let mut flat = patch.clone();
        flat.fair_with_rest_curvature(&centres, LaplacianWeights::Cotangent, None);
        patch.fair_with_rest_curvature(&centres, LaplacianWeights::Cotangent, Some(&curvature));
        assert!(farthest(&patch) < 4e-3, "{size} {}", farthest(&patch));
        assert!(farthest(&flat) > 3.0 * farthest(&patch), "{size} {}", farthest(&flat));
    }
}

/// For a ball of radius 2, the mean curvature is 1 towards the centre at every vertex, including
/// the rim; and ridges of noise are smoothed out.
#[test]
fn mean_curvature_of_a_ball_is_its_inverse_radius() {
    let mut patch = disk_patch(12);
    patch.points.iter_mut().for_each(|p| p.z = (4.0 - p.x * p.x - p.y * p.y).sqrt());
    // Put the rim first.
    patch.points.reverse();
    let last = patch.points.len() as u32 - 1;
    patch.triangles.iter_mut().flatten().for_each(|v| *v = last - *v);
    let off = |passes: u32, patch: &TestPatch| {
        let curvature = mean_curvature(&patch.points, &patch.triangles, &|v| v >= 72, passes, &Job::default()).unwrap();
        let off = curvature.iter().zip(&patch.points).map(|(bend, &p)| bend.distance(-p / 2.0));
        off.fold(0.0, f64::max)
    };
    assert!(off(5, &patch) < 0.1, "{}", off(5, &patch));
    for v in 72..patch.points.len() {
        patch.points[v].z += 1e-3 * reproducible_noise(v);
    }
    let [rough, smooth] = [off(1, &patch), off(10, &patch)];
    assert!(smooth < rough / 2.0 && smooth < 0.3, "{rough} {smooth}");
}

/// A function with nonzero Laplacians of all orders except the third, on a nearly flat disk of
/// irregular triangles. With curvature continuity the error decreases on finer triangles, and is
/// far smaller than with tangent continuity.
#[test]
fn triharmonic_functions_are_found() {
    let height = |p: DVec3| 1e-4 * p.length_squared() * (p.length_squared() * (p.x + 1.0) + p.x * p.y + p.y + 1.0);
    let error = |rings: u32, continuity: Continuity| {
        let mut patch = disk_patch(rings);
        for (v, p) in patch.points.iter_mut().enumerate() {
            *p += DVec3::new(reproducible_noise(v), reproducible_noise(v + 1000), 0.0) * 0.2 / f64::from(rings);
        }
        // Three rows are fixed.
        let count = patch.points.len();
        let inner = 3 * (rings as usize - 2) * (rings as usize - 3) + 1;
        patch.free = (0..count).map(|v| v < inner).collect();
        let centres: Vec<_> = (0..count).map(|v| v < count - 6 * rings as usize).collect();
        for v in 0..count {
            patch.points[v].z = if patch.free[v] { 0.0 } else { height(patch.points[v]) };
        }
        let (triangles, free) = (&patch.triangles, &patch.free);
        let weights = LaplacianWeights::Cotangent;
        let plate = Plate {
            triangles,
            is_free_vertex: free,
            has_laplacian_in_energy: &centres,
            weights,
            continuity,
            shape: None,
            ordering_positions: None,
        };
        minimise_plate_energy(&mut patch.points, &plate, &Job::default()).unwrap();
        patch.points.iter().map(|&p| (p.z - height(p)).abs()).fold(0.0, f64::max) / 1e-4
    };
    let errors = [8, 16, 32].map(|rings| error(rings, Continuity::C2));
    assert!(errors[0] < 0.2 && errors[1] < errors[0] / 2.0 && errors[2] < errors[1] / 2.0, "{errors:?}");
    assert!(errors[2] < error(32, Continuity::C1) / 10.0, "{errors:?} {}", error(32, Continuity::C1));
}

/// The Laplacians of quadratic functions are exact, also on triangles much longer than wide.
#[test]
fn laplacians_of_quadratic_functions_are_exact() {
    type Function = fn(DVec3) -> f64;
    let functions: [(Function, f64); 3] = [(|p| p.x * p.x, 2.0), (|p| p.y * p.y, 2.0), (|p| p.x * p.y, 0.0)];
    for (stretch, most) in [(1.0, 0.01), (3.0, 0.02), (10.0, 0.05), (0.05, 0.25)] {
        let mut patch = disk_patch(12);
        for (v, p) in patch.points.iter_mut().enumerate() {
            *p = 12.0 * *p + DVec3::new(reproducible_noise(v), reproducible_noise(v + 1000), 0.0) * 0.25;
            p.y *= stretch;
        }
        let (points, triangles) = (&patch.points, &patch.triangles);
        let rings = OneRings::new(points, triangles, LaplacianWeights::Cotangent, &Job::default()).unwrap();
        let exact = ExactLaplacian::new(points, triangles, &rings, &Job::default()).unwrap();
        let inner: Vec<usize> = (0..points.len()).filter(|&v| patch.free[v]).collect();
        for (k, (f, expected)) in functions.iter().enumerate() {
            // In the plane of each vertex.
            let laplacian = |&v: &usize| {
                let row = exact.matrix_rows(&rings).row(v);
                row.map(|(w, weight)| weight * f(points[w] - points[v])).sum::<f64>() - expected
            };
            let square: f64 = inner.iter().map(laplacian).map(|error| error * error).sum();
            // The mixed function is of the size of both.
            let error = (square / inner.len() as f64).sqrt() * if k == 2 { stretch.min(1.0 / stretch) } else { 1.0 };
            assert!(error < most, "{k}, stretched {stretch} times: {error}");
        }
    }
}

/// A plane stays a plane with irregular triangles.
#[test]
fn a_plane_stays_a_plane_with_its_curvature() {
    let mut patch = disk_patch(9);
    for (v, p) in patch.points.iter_mut().enumerate() {
        *p += DVec3::new(reproducible_noise(v), reproducible_noise(v + 1000), 0.0) * 0.05;
        p.z = if patch.free[v] { 0.1 * reproducible_noise(v + 77) } else { 0.0 };
    }
    let centres: Vec<_> = (0..patch.points.len()).map(|v| v < patch.points.len() - 54).collect();
    let (triangles, free) = (&patch.triangles, &patch.free);
    let (weights, continuity) = (LaplacianWeights::Cotangent, Continuity::C2);
    let plate = Plate {
        triangles,
        is_free_vertex: free,
        has_laplacian_in_energy: &centres,
        weights,
        continuity,
        shape: None,
        ordering_positions: None,
    };
    minimise_plate_energy(&mut patch.points, &plate, &Job::default()).unwrap();
    assert!(patch.points.iter().all(|p| p.z.abs() < 1e-10));
}
