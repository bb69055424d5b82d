//! Checks against enumerated triangulations, known areas and Euler's formula.

use super::closing_task::ClosingTask;
use super::exhaustive_triangulation::{ExhaustiveTriangulation, is_connected_manifold};
use super::improve_along_bridges::farthest_spanning_tree;
use super::numbered_rims::{NumberedRims, thin_loops};
use super::opened_loops::cut_open_along_tree;
use super::{add_ears_at_finer_vertices, close_loops_coarse_to_fine, cost_of_closing, triangulate_loops_together};
use crate::fill::Weight;
use crate::fill::triangulation_cost::Polygon;
use glam::DVec3;
use gusset_base::Job;
use gusset_base::testing::case_count;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

const NO_TAKEN_EDGE: &dyn Fn(u32, u32) -> bool = &|_, _| false;
const ALL_WEIGHTS: [Weight; 4] = [Weight::Continuation, Weight::AreaAndBend, Weight::BendThenArea, Weight::Area];

fn random_point(random: &mut fastrand::Rng) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| 2.0 * random.f64() - 1.0))
}

/// Returns a circle that runs forwards around an axis, as the rim of a tube that arrives along the
/// axis.
fn circle_polygon(n: usize, radius: f64, centre: DVec3, axis: DVec3) -> Polygon {
    let x = axis.any_orthonormal_vector();
    let y = axis.cross(x);
    let normals = (0..n).map(|i| TAU * i as f64 / n as f64).map(|t| x * t.cos() + y * t.sin()).collect::<Vec<_>>();
    let points = normals.iter().map(|normal| centre + *normal * radius).collect();
    let across = (0..n).map(|i| (normals[i] + normals[(i + 1) % n]).normalize()).collect();
    Polygon::new(points, across, normals)
}

/// Returns circles with perturbed points.
fn perturbed_circles(lengths: &[usize], noise: f64, random: &mut fastrand::Rng) -> Vec<Polygon> {
    let mut loops = circles_on_sphere(lengths.len(), 3, 1.5);
    for (polygon, &n) in loops.iter_mut().zip(lengths) {
        let centre = polygon.points.iter().sum::<DVec3>() / 3.0;
        *polygon = circle_polygon(n, 1.0, centre, (-centre).normalize());
        polygon.points.iter_mut().for_each(|p| *p += random_point(random) * noise);
        let turned = |normal: &mut DVec3| *normal = (*normal + random_point(random) * 0.2).normalize();
        polygon.normals.iter_mut().chain(&mut polygon.normals_across_edges).for_each(turned);
    }
    loops
}

/// Returns circles around an origin, facing it.
fn circles_on_sphere(k: usize, n: usize, distance: f64) -> Vec<Polygon> {
    let on_sphere = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / k as f64;
        let (r, t) = ((1.0 - z * z).sqrt(), 2.4 * i as f64);
        DVec3::new(r * t.cos(), r * t.sin(), z)
    };
    (0..k).map(|i| circle_polygon(n, 1.0, on_sphere(i) * distance, -on_sphere(i))).collect()
}

fn next_on_loops(loops: &[Polygon]) -> Vec<usize> {
    let mut next = Vec::new();
    for polygon in loops {
        let (start, n) = (next.len(), polygon.points.len());
        next.extend((0..n).map(|i| start + (i + 1) % n));
    }
    next
}

/// Asserts one surface of genus 0 whose border is exactly the rims.
fn assert_closes(loops: &[Polygon], triangles: &[[u32; 3]]) {
    let next = next_on_loops(loops);
    let n = next.len();
    let mut sides = BTreeMap::new();
    for &[a, b, c] in triangles {
        assert!(a != b && b != c && c != a);
        for side in [(a, b), (b, c), (c, a)] {
            assert_eq!(sides.insert(side, ()), None, "{side:?} twice");
        }
    }
    let borders = sides.keys().filter(|&&(u, v)| !sides.contains_key(&(v, u)));
    let borders: Vec<_> = borders.map(|&(u, v)| (u as usize, v as usize)).collect();
    assert_eq!(borders, next.iter().copied().enumerate().collect::<Vec<_>>());
    let edges = (sides.len() + n) / 2;
    assert_eq!(n as i64 - edges as i64 + triangles.len() as i64, 2 - loops.len() as i64);
    if n < 1000 {
        assert!(is_connected_manifold(triangles, n, &next));
    }
}

fn total_area(loops: &[Polygon], triangles: &[[u32; 3]]) -> f64 {
    let points: Vec<_> = loops.iter().flat_map(|polygon| &polygon.points).collect();
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| *points[v as usize]);
        (b - a).cross(c - a).length() / 2.0
    };
    triangles.iter().map(area).sum()
}

fn triangulate_together_directly(
    loops: &[Polygon],
    weight: Weight,
    taken: &dyn Fn(u32, u32) -> bool,
) -> Option<Vec<[u32; 3]>> {
    triangulate_loops_together(loops, weight, taken, &Job::default()).unwrap()
}

/// Compares areas with the enumerated minimum, and returns the number of cases with a
/// triangulation.
fn compare_areas_with_enumeration(count: u32, lengths: impl Fn(u32) -> Vec<usize>) -> u32 {
    let mut random = fastrand::Rng::with_seed(11);
    let mut closed = 0;
    for case in 0..count {
        let noise = [0.1, 0.5, 2.0][case as usize % 3];
        let loops = perturbed_circles(&lengths(case), noise, &mut random);
        // In some cases, some of the edges are taken.
        let (share, key) = ([0, 0, 10, 40][case as usize / 3 % 4], random.u32(..));
        let hash = |u: u32, v: u32| (u.min(v) * 31 + u.max(v)).wrapping_add(key).wrapping_mul(0x9E37_79B1) >> 16;
        let taken = |u: u32, v: u32| hash(u, v) % 100 < share;
        let found = triangulate_together_directly(&loops, Weight::Area, &taken);
        let value = found.as_ref().map_or(f64::INFINITY, |triangles| total_area(&loops, triangles));
        // The limit lies just above the value, so that the enumeration finds it again.
        let least = ExhaustiveTriangulation::least_cost(&loops, Weight::Area, &taken, value * (1.0 + 1e-9));
        assert_eq!(found.is_some(), least.is_finite(), "case {case}");
        if let Some(triangles) = found {
            assert_closes(&loops, &triangles);
            assert!((value - least).abs() <= 1e-12 * least, "case {case}: {value}, {least}");
            closed += 1;
        }
    }
    closed
}

#[test]
fn area_of_two_loops_is_the_least() {
    let count = case_count(1500);
    let closed =
        compare_areas_with_enumeration(count, |case| [[3, 3], [4, 3], [3, 4], [4, 4]][case as usize % 4].to_vec());
    assert!(closed > count * 3 / 4 && closed < count, "{closed}");
}

#[test]
fn area_of_three_loops_is_the_least() {
    let count = case_count(100);
    let closed = compare_areas_with_enumeration(count, |_| vec![3; 3]);
    assert!(closed > count * 3 / 4, "{closed}");
}

#[test]
fn area_of_one_loop_is_the_least() {
    compare_areas_with_enumeration(case_count(200), |case| vec![4 + case as usize % 3]);
}

/// Returns the median ratio of the cost to the enumerated minimum.
fn median_cost_ratio(weight: Weight, lengths: &[usize], count: u32) -> f64 {
    let mut random = fastrand::Rng::with_seed(12);
    let mut ratios = Vec::new();
    for _ in 0..count {
        let loops = perturbed_circles(lengths, 0.3, &mut random);
        let triangles = triangulate_together_directly(&loops, weight, NO_TAKEN_EDGE).unwrap();
        assert_closes(&loops, &triangles);
        let value = ExhaustiveTriangulation::cost_of_triangles(&loops, weight, &triangles);
        let own = cost_of_closing(&loops, &triangles, weight).unwrap().weighted_value();
        assert!((own - value).abs() <= 1e-9 * value, "{own}, {value}");
        let least = ExhaustiveTriangulation::least_cost(&loops, weight, NO_TAKEN_EDGE, value * (1.0 + 1e-9));
        assert!(value >= least * (1.0 - 1e-9));
        ratios.push(value / least);
    }
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}

#[test]
fn bends_are_near_the_least() {
    for weight in [Weight::Continuation, Weight::AreaAndBend] {
        assert!(median_cost_ratio(weight, &[3, 3], case_count(300)) <= 1.05);
        assert!(median_cost_ratio(weight, &[4, 4], case_count(100)) <= 1.05);
    }
    assert!(median_cost_ratio(Weight::Continuation, &[3, 3, 3], case_count(50)) <= 1.05);
}

#[test]
fn an_annulus_of_two_circles_is_a_belt() {
    for (n, turn) in [(3, 0), (8, 0), (40, 0), (40, 13), (300, 0), (300, 1), (300, 101)] {
        let height = 2.0 / n as f64;
        let mut loops =
            vec![circle_polygon(n, 1.0, DVec3::ZERO, DVec3::Z), circle_polygon(n, 1.0, DVec3::Z * height, DVec3::Z)];
        loops[1].points.reverse();
        loops[1].normals.reverse();
        // Each edge now starts at its former end.
        loops[1].normals_across_edges[..n - 1].reverse();
        let Polygon { points, normals_across_edges: across, normals, .. } = &mut loops[1];
        [points, across, normals].into_iter().for_each(|of| of.rotate_left(turn));
        let belt = 2.0 * (TAU / 2.0 / n as f64).sin() * height * n as f64;
        // The largest bend does not distinguish the belt from others.
        for weight in [Weight::Continuation, Weight::AreaAndBend, Weight::Area] {
            let triangles = triangulate_together_directly(&loops, weight, NO_TAKEN_EDGE).unwrap();
            assert_closes(&loops, &triangles);
            let area = total_area(&loops, &triangles);
            assert!((area - belt).abs() <= 1e-9 * belt, "{weight:?} {n}: {area}, {belt}");
        }
    }
}

#[test]
fn loops_side_by_side_are_zipped_even_if_thinned_loops_are_not() {
    let n = 300;
    let height = 2.0 / n as f64;
    let mut loops =
        vec![circle_polygon(n, 1.0, DVec3::ZERO, DVec3::Z), circle_polygon(n, 1.0, DVec3::Z * height, DVec3::Z)];
    loops[1].points.reverse();
    // The normals fit a surface across the belt: the thinned loops get two discs and a tube.
    let triangles = triangulate_together_directly(&loops, Weight::Continuation, NO_TAKEN_EDGE).unwrap();
    assert_closes(&loops, &triangles);
    assert!(total_area(&loops, &triangles) <= 1.1 * TAU * height);
}

/// Returns a smaller size for unoptimised builds.
fn test_size_for_build(small: usize, full: usize) -> usize {
    if cfg!(debug_assertions) { small } else { full }
}

#[test]
fn loops_of_any_number_and_length_are_closed() {
    let mut random = fastrand::Rng::with_seed(13);
    for (k, n, noise) in [
        (2, 40, 0.1),
        (3, 5, 0.5),
        (3, test_size_for_build(26, 40), 0.01),
        (4, 4, 0.5),
        (5, 9, 0.1),
        (6, 12, 0.01),
        (test_size_for_build(7, 9), 4, 0.2),
    ] {
        let lengths: Vec<_> = (0..k).map(|_| random.usize(n / 2 + 2..=n + 1)).collect();
        let loops = perturbed_circles(&lengths, noise, &mut random);
        for weight in [ALL_WEIGHTS[k % 4], ALL_WEIGHTS[(k + 2) % 4]] {
            let triangles = triangulate_together_directly(&loops, weight, NO_TAKEN_EDGE);
            assert_closes(&loops, &triangles.unwrap_or_else(|| panic!("{weight:?} {lengths:?}")));
        }
    }
}

#[test]
fn taken_chords_are_kept_out() {
    let mut random = fastrand::Rng::with_seed(14);
    for lengths in
        [vec![9, 30], vec![12, 7, 8], vec![test_size_for_build(60, 100), test_size_for_build(40, 60)], vec![3, 4, 5, 4]]
    {
        let loops = perturbed_circles(&lengths, 0.01, &mut random);
        let mut taken = Vec::new();
        for _ in 0..2 {
            let is_taken = |u: u32, v: u32| taken.contains(&(u, v)) || taken.contains(&(v, u));
            let triangles = triangulate_together_directly(&loops, Weight::Area, &is_taken).unwrap();
            assert_closes(&loops, &triangles);
            let next = next_on_loops(&loops);
            let sides = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
            let inner =
                sides.filter(|&(u, v)| u < v && next[u as usize] != v as usize && next[v as usize] != u as usize);
            let inner: Vec<_> = inner.collect();
            assert!(!inner.iter().any(|&(u, v)| is_taken(u, v)));
            taken.extend(inner.into_iter().step_by(3));
        }
    }
}

/// Returns a star with `n` corners in the plane of `x` and `y`; clockwise for an inner loop.
fn star_polygon(n: usize, radius: f64, centre: DVec3, [x, y]: [DVec3; 2], is_inner: bool) -> Polygon {
    let at = |i: usize| {
        let (r, t) = (radius * [1.0, 0.6][i % 2], TAU * i as f64 / n as f64);
        centre + (x * t.cos() + y * t.sin()) * r
    };
    let mut points: Vec<_> = (0..n).map(at).collect();
    if is_inner {
        points.reverse();
    }
    let normal = x.cross(y);
    Polygon::new(points, vec![normal; n], vec![normal; n])
}

#[test]
fn nested_planar_loops_are_filled_without_overlaps() {
    let frames = [[DVec3::X, DVec3::Y], [DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.8, 0.0, -0.6)]];
    for (frame, n, k) in [(0, 6, 1), (1, 6, 2), (0, 12, 5), (1, 40, 4), (0, 600, 1), (1, 1000, 5)] {
        let [x, y] = frames[frame];
        let around = |i: usize| {
            let t = TAU * i as f64 / k as f64 + 0.1;
            x * (t.cos() * 0.35) + y * (t.sin() * 0.35)
        };
        let inner = (0..k).map(|i| star_polygon(n / 2 * 2, 0.15, around(i), frames[frame], true));
        let mut loops: Vec<_> = inner.chain([star_polygon(n, 1.0, DVec3::ZERO, frames[frame], false)]).collect();
        loops.rotate_left(k / 2);
        let sine = (TAU / n as f64).sin() * 0.6 * n as f64 / 2.0;
        let exact = sine * (1.0 - k as f64 * 0.15 * 0.15);
        let points: Vec<_> = loops.iter().flat_map(|polygon| polygon.points.clone()).collect();
        for weight in ALL_WEIGHTS {
            let triangles = triangulate_together_directly(&loops, weight, NO_TAKEN_EDGE).unwrap();
            assert_closes(&loops, &triangles);
            let area = total_area(&loops, &triangles);
            assert!((area - exact).abs() <= 1e-9 * exact, "{weight:?} {n} {k}: {area}, {exact}");
            for triangle in triangles {
                let [a, b, c] = triangle.map(|v| points[v as usize]);
                assert!((b - a).cross(c - a).dot(x.cross(y)) >= -1e-12);
            }
        }
    }
}

#[test]
fn degenerate_loops_terminate() {
    let flat = |points: Vec<DVec3>| {
        let n = points.len();
        Polygon::new(points, vec![DVec3::ZERO; n], vec![DVec3::ZERO; n])
    };
    for (lengths, step) in [([4, 5, 3], 0.0), ([4, 5, 3], 1.0), ([30, 20, 3], 0.0), ([9, 40, 10], 1.0)] {
        let line = |n: usize| flat((0..n).map(|i| DVec3::X * step * i as f64).collect());
        for k in 2..=3 {
            let loops: Vec<_> = lengths[..k].iter().map(|&n| line(n)).collect();
            for weight in [Weight::Continuation, Weight::Area] {
                if let Some(triangles) = triangulate_together_directly(&loops, weight, NO_TAKEN_EDGE) {
                    assert_closes(&loops, &triangles);
                }
            }
        }
    }
    let slit = flat(vec![DVec3::ZERO, DVec3::X]);
    assert_eq!(
        triangulate_together_directly(&[slit, circle_polygon(4, 1.0, DVec3::Z, DVec3::Z)], Weight::Area, NO_TAKEN_EDGE),
        None
    );
    assert_eq!(triangulate_together_directly(&[], Weight::Area, NO_TAKEN_EDGE), None);
    let loops = circles_on_sphere(2, 4, 2.0);
    assert_eq!(triangulate_together_directly(&loops, Weight::Area, &|_, _| true), None);
}

#[test]
fn costs_tell_whether_loops_belong_together() {
    for (distance, is_together) in [(0.3, true), (3.0, false)] {
        let mut loops = circles_on_sphere(2, 30, 1.0);
        for (polygon, z) in loops.iter_mut().zip([0.0, distance]) {
            *polygon = circle_polygon(30, 1.0, DVec3::Z * z, if z > 0.0 { -DVec3::Z } else { DVec3::Z });
        }
        let joined = triangulate_together_directly(&loops, Weight::Area, NO_TAKEN_EDGE).unwrap();
        assert_closes(&loops, &joined);
        let mut apart = Vec::new();
        for (polygon, first) in loops.chunks(1).zip([0, 30]) {
            apart.extend(
                triangulate_together_directly(polygon, Weight::Area, NO_TAKEN_EDGE)
                    .unwrap()
                    .iter()
                    .map(|corners| corners.map(|v| v + first)),
            );
        }
        let [joined, apart] =
            [joined, apart].map(|triangles| cost_of_closing(&loops, &triangles, Weight::Area).unwrap());
        assert_eq!(joined.relative_gain_over(&apart) > 0.0, is_together);
        assert_eq!(apart.relative_gain_over(&joined) > 0.0, !is_together);
    }
}

#[test]
fn polygons_cost_what_their_surfaces_do() {
    let mut random = fastrand::Rng::with_seed(15);
    let (two, three) = (
        vec![test_size_for_build(40, 70), test_size_for_build(35, 61)],
        vec![test_size_for_build(15, 30), test_size_for_build(12, 24), 20],
    );
    for lengths in [vec![5, 6], two, vec![4, 5, 4], three, vec![6, 4, 5, 7]] {
        let loops = perturbed_circles(&lengths, 0.1, &mut random);
        let (coarse, kept) = thin_loops(&loops).unwrap().unwrap();
        let [rims, coarse_rims] = [&loops, &coarse].map(|loops| NumberedRims::new(loops).unwrap());
        for weight in ALL_WEIGHTS {
            let task = |rims| ClosingTask {
                rims,
                weight,
                normalisation: NumberedRims::common_cost_normalisation(rims),
                is_forbidden_edge: NO_TAKEN_EDGE,
                is_finest: true,
            };
            let (task, coarse_task) = (task(&rims), task(&coarse_rims));
            let few = close_loops_coarse_to_fine(&coarse, &coarse_task, &Job::default()).unwrap().unwrap();
            let refined = add_ears_at_finer_vertices(&task, &few, &kept).unwrap().unwrap();
            let all = close_loops_coarse_to_fine(&loops, &task, &Job::default()).unwrap().unwrap();
            assert!(!task.is_cheaper_by_loop_measure(&refined.cost, &all.cost), "{weight:?} {lengths:?}");
            for found in [refined, all] {
                let triangles = found.opened.places_to_vertices(&found.triangles).unwrap();
                assert_closes(&loops, &triangles);
                let [own, other] =
                    [found.cost, task.cost_of_closing(&triangles).unwrap()].map(|cost| cost.weighted_value());
                assert!((own - other).abs() <= 1e-9 * other, "{weight:?} {lengths:?}: {own}, {other}");
                // Cut open elsewhere, it stays the same surface.
                let old: Vec<_> = found.opened.bridge_tree().unwrap().iter().map(|&(ends, _)| ends).collect();
                let tree = farthest_spanning_tree(&task, &triangles, &old).unwrap();
                assert!(tree != old && tree.len() == old.len());
                let (opened, places) = cut_open_along_tree(&rims, &triangles, &tree).unwrap().unwrap();
                assert_eq!(opened.len(), rims.vertex_count() + 2 * tree.len());
                let sorted = |triangles: &[[u32; 3]]| {
                    let mut triangles = triangles.to_vec();
                    triangles.iter_mut().for_each(|corners| corners.sort_unstable());
                    triangles.sort_unstable();
                    triangles
                };
                assert_eq!(sorted(&opened.places_to_vertices(&places).unwrap()), sorted(&triangles));
                // The triangles must keep their orientation.
                let directed = |triangles: &[[u32; 3]]| {
                    let turned = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
                    triangles.iter().filter_map(turned).collect::<std::collections::BTreeSet<_>>()
                };
                assert_eq!(directed(&opened.places_to_vertices(&places).unwrap()), directed(&triangles));
            }
        }
    }
}

#[test]
fn a_long_thin_tunnel_is_found() {
    // The rims of two opposite caps cut off a ball, and a tunnel through it.
    for n in [8, 20, 40].into_iter().take(if cfg!(debug_assertions) { 1 } else { 3 }) {
        let rim = |sign: f64| {
            let mut polygon = circle_polygon(n, 0.34, DVec3::Z * 0.94 * sign, DVec3::Z * sign);
            polygon.normals = polygon.points.iter().map(|p| p.normalize()).collect();
            polygon.normals_across_edges = polygon.normals.clone();
            polygon
        };
        let loops = [rim(1.0), rim(-1.0)];
        // An old face cuts off each third vertex.
        let taken = |u: u32, v: u32| u.abs_diff(v) == 2 && u.min(v).is_multiple_of(3);
        for weight in [Weight::Continuation, Weight::Area] {
            for taken in [NO_TAKEN_EDGE, &taken] {
                let triangles =
                    triangulate_together_directly(&loops, weight, taken).unwrap_or_else(|| panic!("{weight:?} {n}"));
                assert_closes(&loops, &triangles);
            }
        }
    }
}
