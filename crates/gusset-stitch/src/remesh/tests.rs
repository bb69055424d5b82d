//! Edits preserve adjacency, and the resulting triangles satisfy the requirements.

use super::{PatchMesh, VertexSizes, even_out_side_lengths, refine_by_insertion};
use glam::DVec3;
use gusset_base::Job;
use gusset_base::geom::triangle::min_angle;
use proptest::prelude::*;
use std::collections::BTreeMap;

const NO_TAKEN_EDGE: fn(u32, u32) -> bool = |_, _| false;

/// Returns a square of `n` x `n` cells in the plane, with the rim's vertices first, in order.
fn square_mesh(n: u32) -> (PatchMesh, usize) {
    let mut number = BTreeMap::new();
    let mut points = Vec::new();
    let rim = (0..n)
        .map(|k| (k, 0))
        .chain((0..n).map(|k| (n, k)))
        .chain((1..=n).rev().map(|k| (k, n)))
        .chain((1..=n).rev().map(|k| (0, k)));
    let inside = (1..n).flat_map(|i| (1..n).map(move |j| (i, j)));
    for at in rim.chain(inside) {
        number.insert(at, points.len() as u32);
        points.push(DVec3::new(f64::from(at.0), f64::from(at.1), 0.0));
    }
    let mut triangles = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|at| number[&at]);
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    (PatchMesh::new(points, triangles).unwrap(), 4 * n as usize)
}

fn total_area(mesh: &PatchMesh) -> f64 {
    let signed = |t: usize| {
        let [a, b, c] = mesh.corner_points(t);
        (b - a).cross(c - a).z / 2.0
    };
    (0..mesh.triangles.len()).map(signed).sum()
}

/// Asserts that adjacency matches the sides, and that the patch is a disc.
fn assert_disc(mesh: &PatchMesh, rim: usize) {
    let mut sides = BTreeMap::new();
    for (t, corners) in mesh.triangles.iter().enumerate() {
        for k in 0..3 {
            assert!(sides.insert((corners[k], corners[(k + 1) % 3]), (t, k)).is_none());
        }
    }
    for (&(u, v), &(t, k)) in &sides {
        assert_eq!(mesh.triangle_across(t, k), sides.get(&(v, u)).copied());
    }
    let outer = sides.keys().filter(|&&(u, v)| !sides.contains_key(&(v, u))).count();
    assert_eq!(outer, rim);
    let edges = (sides.len() + outer) / 2;
    assert_eq!(mesh.points.len() + mesh.triangles.len(), edges + 1);
}

fn uniform_sizes(mesh: &PatchMesh, size: f64) -> VertexSizes {
    VertexSizes {
        wanted_side_lengths: vec![size; mesh.points.len()],
        points_before_fairing: mesh.points.clone(),
        curvature: vec![DVec3::ZERO; mesh.points.len()],
        max_vertices: mesh.points.len() + 100_000,
        min_shortest_side_in_sizes: 1e-3,
    }
}

proptest! {
    #[test]
    fn edits_keep_a_disc(edits in prop::collection::vec((0..4, any::<u16>(), 0..3usize), 1..60)) {
        let (mut mesh, rim) = square_mesh(3);
        let mut star = Vec::new();
        for (kind, place, k) in edits {
            let t = usize::from(place) % mesh.triangles.len();
            let corners = mesh.corner_points(t);
            match (kind, mesh.triangle_across(t, k)) {
                (0, _) => drop(mesh.split_triangle(t, (corners[0] + corners[1] + corners[2]) / 3.0).unwrap()),
                (1, Some(beyond)) => {
                    let middle = corners[k].midpoint(corners[(k + 1) % 3]);
                    mesh.split_side((t, k), beyond, middle).unwrap();
                }
                (2, Some(_)) => drop(mesh.flip_side_if_not_delaunay(rim, &NO_TAKEN_EDGE, t, k)),
                (3, Some(_)) if mesh.triangles[t][k] as usize >= rim => {
                    // Common neighbours other than the two beside the side would pinch the disc.
                    prop_assert!(mesh.one_ring(t, k, &mut star).unwrap());
                    let onto = mesh.triangles[t][(k + 1) % 3];
                    let others = star[1..star.len() - 1].iter().map(|&(s, j)| mesh.triangles[s][(j + 2) % 3]);
                    let others: Vec<u32> = others.take(star.len().saturating_sub(3)).collect();
                    if star.len() > 3 && others.iter().all(|&v| v != onto && !mesh.has_edge(t, (k + 1) % 3, v)) {
                        mesh.collapse_edge((t, k), &star);
                        mesh.renumber_remaining(rim).unwrap();
                    }
                }
                _ => {}
            }
            assert_disc(&mesh, rim);
            prop_assert!((total_area(&mesh) - 9.0).abs() < 1e-9);
        }
    }
}

#[test]
fn a_square_is_refined_to_any_size_without_sharp_angles() {
    for (n, size) in [(1, 0.1), (4, 1.0), (6, 0.4), (24, 4.0)] {
        let (mut mesh, rim) = square_mesh(n);
        let mut sizing = uniform_sizes(&mesh, size);
        even_out_side_lengths(&mut mesh, rim, &mut sizing, &NO_TAKEN_EDGE, &Job::default()).unwrap();
        assert_disc(&mesh, rim);
        refine_by_insertion(&mut mesh, rim, &mut sizing, &NO_TAKEN_EDGE, &Job::default()).unwrap();
        mesh.move_vertices_within_surface(rim, &NO_TAKEN_EDGE, 3, &Job::default()).unwrap();
        assert_disc(&mesh, rim);
        let whole = f64::from(n * n);
        assert!((total_area(&mesh) / whole - 1.0).abs() < 1e-12);
        assert_eq!(sizing.points_before_fairing.len(), mesh.points.len());
        let least = (0..mesh.triangles.len())
            .map(|t| {
                let [a, b, c] = mesh.corner_points(t);
                assert!((b - a).cross(c - a).z > 0.0, "{n} {size}: {a} {b} {c}");
                min_angle(a, b, c).to_degrees()
            })
            .fold(180.0, f64::min);
        // If rim sides are longer than the size, small angles are unavoidable.
        assert!(least > if size < 0.5 { 1.0 } else { 20.0 }, "{n} {size}: {least}");
        let expected = whole / (0.43 * f64::max(size, 1.0).powi(2));
        assert!(size < 1.0 || (mesh.triangles.len() as f64) < 8.0 * expected + 8.0 * rim as f64, "{n} {size}");
    }
}

#[test]
fn taken_edges_are_never_made() {
    // The common edge is the longer diagonal, so it would be flipped.
    let points = [[0.0, 0.0], [1.0, 0.2], [3.0, 0.0], [1.0, -0.2]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
    let triangles = vec![[0, 2, 1], [0, 3, 2]];
    let mut free = PatchMesh::new(points.clone(), triangles.clone()).unwrap();
    free.flip_edges_to_delaunay(4, &NO_TAKEN_EDGE, &Job::default()).unwrap();
    assert!(free.triangles.iter().all(|t| t.contains(&1) && t.contains(&3)));
    let mut taken = PatchMesh::new(points, triangles.clone()).unwrap();
    taken.flip_edges_to_delaunay(4, &|u, v| (u.min(v), u.max(v)) == (1, 3), &Job::default()).unwrap();
    assert_eq!(taken.triangles, triangles);
}

#[test]
fn coincident_and_collinear_points_do_not_hang() {
    for points in [vec![[0.0; 2]; 4], vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]] {
        let points: Vec<DVec3> = points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect();
        let mut mesh = PatchMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        for size in [0.0, 0.1, f64::NAN] {
            let mut sizing = uniform_sizes(&mesh, size);
            sizing.max_vertices = mesh.points.len() + 50;
            even_out_side_lengths(&mut mesh, 4, &mut sizing, &NO_TAKEN_EDGE, &Job::default()).unwrap();
            refine_by_insertion(&mut mesh, 4, &mut sizing, &NO_TAKEN_EDGE, &Job::default()).unwrap();
            mesh.move_vertices_within_surface(4, &NO_TAKEN_EDGE, 2, &Job::default()).unwrap();
            assert!(mesh.points.iter().all(|p| p.is_finite()));
        }
    }
}

#[test]
fn a_crease_is_ironed_out_and_a_gentle_slope_stays() {
    let bends = |mesh: &PatchMesh| {
        let normal = |t: usize| {
            let [a, b, c] = mesh.corner_points(t);
            (b - a).cross(c - a).normalize()
        };
        let sides = (0..mesh.triangles.len())
            .flat_map(|t| (0..3).filter_map(move |k| Some((t, mesh.triangle_across(t, k)?.0))));
        sides.map(|(t, s)| normal(t).dot(normal(s))).fold(1.0, f64::min)
    };
    let least = std::f64::consts::FRAC_1_SQRT_2;
    for (height, moves) in [(0.2, false), (4.0, true)] {
        let (mut mesh, rim) = square_mesh(8);
        // A spike in the middle, and beside it a vertex on which a fold lies.
        mesh.points[rim + 24].z = height;
        mesh.points[rim + 25].x += if moves { 1.5 } else { 0.0 };
        let before = mesh.points.clone();
        assert_eq!(bends(&mesh) < least, moves);
        mesh.iron_out_creases(rim, least, &vec![false; rim], &Job::default()).unwrap();
        assert!(bends(&mesh) >= least);
        assert_eq!(mesh.points != before, moves);
        assert_eq!(mesh.points[..rim], before[..rim]);
        assert_disc(&mesh, rim);
    }
    // Next to a crease of the rim, nothing moves.
    let (mut mesh, rim) = square_mesh(4);
    mesh.points[rim + 4].z = 4.0;
    let before = mesh.points.clone();
    mesh.iron_out_creases(rim, least, &vec![true; rim], &Job::default()).unwrap();
    assert_eq!(mesh.points, before);
}
