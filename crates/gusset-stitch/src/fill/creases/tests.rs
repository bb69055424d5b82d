//! Grids of 9 by 9 cells with a square hole of 5 by 5 cells, over several height functions.

use super::super::patch_rim::{OldFaces, PatchRim};
use super::{DividedHole, divide_along_creases};
use glam::DVec3;
use gusset_base::testing::case_count;

const GRID_CELLS: u32 = 9;
const HOLE_CELL_RANGE: std::ops::RangeInclusive<u32> = 2..=6;

fn rim_of_height_field(mut height: impl FnMut(f64, f64) -> f64) -> PatchRim {
    let side = GRID_CELLS + 1;
    // Around the hole counter-clockwise, then all other vertices.
    let ring = (0..5).map(|k| (2 + k, 2)).chain((0..5).map(|k| (7, 2 + k)));
    let ring = ring.chain((0..5).map(|k| (7 - k, 7))).chain((0..5).map(|k| (2, 7 - k)));
    let mut order: Vec<(u32, u32)> = ring.collect();
    let others = (0..side * side).map(|k| (k % side, k / side)).filter(|at| !order.contains(at));
    let others: Vec<_> = others.collect();
    order.extend(others);
    let number = |at: (u32, u32)| order.iter().position(|&other| other == at).unwrap() as u32;
    let cells = (0..GRID_CELLS * GRID_CELLS).map(|k| (k % GRID_CELLS, k / GRID_CELLS));
    let kept = cells.filter(|(x, y)| !(HOLE_CELL_RANGE.contains(x) && HOLE_CELL_RANGE.contains(y)));
    let around: Vec<[u32; 3]> = kept
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(number);
            [[a, b, c], [a, c, d]]
        })
        .filter(|triangle| triangle.iter().any(|&v| v < 20))
        .collect();
    let points: Vec<_> =
        order.iter().map(|&(x, y)| (f64::from(x), f64::from(y))).map(|(x, y)| DVec3::new(x, y, height(x, y))).collect();
    let sides = around.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
    PatchRim::new(
        &points,
        vec![20],
        OldFaces { first_ring: around, second_ring_triangles: Vec::new(), first_ring_sides: sides },
        vec![DVec3::Z; 20],
        vec![true; 20],
    )
    .unwrap()
}

fn divide_without_taken_edges(rim: &PatchRim, limit: Option<u32>) -> Option<DividedHole> {
    divide_along_creases(rim, &|_, _| false, limit).unwrap()
}

#[test]
fn a_roof_is_two_parts() {
    let roof = rim_of_height_field(|x, _| -(x - 4.0).abs());
    for (limit, points) in [(None, 0), (Some(100), 3)] {
        let division = divide_without_taken_edges(&roof, limit).unwrap();
        assert_eq!((division.parts.len(), division.points.len()), (2, points));
        for part in &division.parts {
            // Each part is flat: its own old triangles have one normal.
            let normals: Vec<_> = part.rim.normals.iter().filter(|normal| **normal != DVec3::ZERO).collect();
            assert!(normals.len() > 3 && normals.iter().all(|normal| normal.distance(*normals[0]) < 1e-12));
        }
        let names: Vec<_> = division.parts.iter().map(|part| part.names.len()).collect();
        assert_eq!(names.iter().sum::<usize>(), 20 + 2 + 2 * points);
    }
    // If the chord is taken, the roof is not divided.
    assert!(divide_along_creases(&roof, &|_, _| true, None).unwrap().is_none());
}

#[test]
fn a_ridge_that_touches_the_rim_hides_what_is_beyond() {
    let ridge = rim_of_height_field(|x, _| -(x - 2.0).abs());
    let division = divide_without_taken_edges(&ridge, None).unwrap();
    let [part] = &division.parts[..] else { panic!("it is one part") };
    assert_eq!(part.names, (0..20).collect::<Vec<_>>());
    let normal = DVec3::new(1.0, 0.0, 1.0).normalize();
    assert!(part.rim.normals.iter().all(|&own| own == DVec3::ZERO || own.distance(normal) < 1e-12));
    // Vertices 15 to 20 lie on the ridge.
    assert!(part.is_taken_edge(15, 18, &|_, _| false) && !part.is_taken_edge(3, 8, &|_, _| false));
    assert_eq!(part.rim.normals_across_edges.iter().filter(|across| **across == DVec3::ZERO).count(), 5);
}

#[test]
fn noise_has_no_creases() {
    let count = u64::from(case_count(1000));
    let rough = |&seed: &u64| {
        let mut random = fastrand::Rng::with_seed(seed);
        let noise = 0.4 * random.f64();
        let rough = rim_of_height_field(|x, y| 0.1 * (x * x - x * y) + noise * random.f64());
        divide_without_taken_edges(&rough, Some(100)).is_some()
    };
    // By chance, two unrelated sharp edges may line up.
    let creased: Vec<u64> = (0..count).filter(rough).collect();
    assert!(creased.len() as u64 <= count / 200, "{creased:?}");
}
