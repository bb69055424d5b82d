//! A second repair, nearly coincident parts, and the largest move of a vertex.

use crate::common::{Soup, edge_counts, faces_of, is_exhaustive, torus, volume};
use crate::solid::{Cell, Random, assert_manifold, mesh_of, outer_walls, scattered, shuffled, volume_of, wall};
use glam::DVec3;
use gusset::Job;
use gusset::fill::Keep;
use gusset::mesh::Mesh;
use gusset::solid::{Options, Repaired, repair, unite_solids};
use proptest::prelude::*;
use std::collections::BTreeSet;

fn repaired(soup: &Soup) -> Repaired {
    repair(&soup.view(), &Options::default(), &Job::default()).unwrap()
}

fn repaired_mesh(mesh: &Mesh) -> Repaired {
    repair(&mesh.view(&Job::default()).unwrap(), &Options::default(), &Job::default()).unwrap()
}

fn cells() -> impl Strategy<Value = BTreeSet<Cell>> {
    prop::collection::btree_set(prop::array::uniform3(0..3i32), 1..8)
}

/// A point in the cube of side 1 around the origin.
fn offset(random: &mut Random) -> DVec3 {
    DVec3::from_array([0.0; 3].map(|_| random.below(1001) as f64 / 1000.0 - 0.5))
}

fn moved(soup: &Soup, by: impl FnMut(DVec3) -> DVec3) -> Soup {
    let points = soup.points.iter().copied().map(DVec3::from_array).map(by).map(|p| p.to_array()).collect();
    Soup { points, ..soup.clone() }
}

/// The mesh with a defect.
fn with_defect(soup: &Soup, kind: usize, random: &mut Random) -> Soup {
    let mut faces: Vec<Vec<u32>> = soup.faces().map(<[u32]>::to_vec).collect();
    let f = random.below(faces.len());
    match kind {
        0 => faces[f].reverse(),
        1 => faces.push(faces[f].clone()),
        2 if faces.len() > 1 => _ = faces.remove(f),
        3 => {
            // A vertex on another place, and borders that coincide nearly.
            let v = random.below(soup.points.len());
            let mut far = soup.clone();
            far.points[v] = (DVec3::from_array(far.points[v]) + offset(random)).to_array();
            return far;
        }
        4 => {
            let width = [1e-9, 1e-3, 1e-2, 0.1][random.below(4)];
            return moved(&scattered(soup), |p| p + width * offset(random));
        }
        5 => {
            let by = offset(random);
            return soup.and(&moved(soup, |p| p + by));
        }
        6 => {
            let size = [1e-9, 1e-6, 1e-3][random.below(3)];
            return soup.and(&moved(soup, |p| p + size * offset(random)));
        }
        _ => {
            let corners = [0; 3].map(|_| random.below(soup.points.len()) as u32);
            if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
                faces.push(corners.to_vec());
            }
        }
    }
    let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    Soup::new(soup.points.clone(), &faces)
}

/// Returns the smallest height of a triangle.
fn smallest_height(mesh: &Mesh) -> f64 {
    let height = |face: &[u32]| {
        let [p, q, r] = [face[0], face[1], face[2]].map(|v| mesh.positions.get(v));
        (q - p).cross(r - p).length() / (q - p).length().max((r - q).length()).max((p - r).length())
    };
    faces_of(mesh).filter(|face| face.len() == 3).map(height).fold(f64::INFINITY, f64::min)
}

/// Returns true if a second repair of a result changes nothing.
fn is_settled(first: &Repaired) -> bool {
    let again = repaired_mesh(&first.mesh);
    again.mesh == first.mesh
        && (again.welded_vertices, again.sewn_edges, again.split_vertices, again.filled_holes) == (0, 0, 0, 0)
        && again.dropped.is_empty()
        && again.turned.iter().all(|&turned| !turned)
}

// Rounding can make faces without area again and again, in about 1 of 1000 results.
#[test]
fn a_second_repair_changes_nothing() {
    let count = if is_exhaustive() { 2000 } else { 200 };
    let mut changed = Vec::new();
    for seed in 0..count {
        let mut random = Random(seed);
        let cells: BTreeSet<Cell> = (0..=random.below(7)).map(|_| [0; 3].map(|_| random.below(3) as i32)).collect();
        let mut soup = mesh_of(outer_walls(&cells));
        for _ in 0..=random.below(3) {
            let kind = random.below(8);
            soup = with_defect(&soup, kind, &mut random);
        }
        let first = repaired(&soup);
        if !is_settled(&first) {
            assert!(!first.is_valid(), "seed {seed}");
            changed.push(seed);
        }
    }
    assert!(changed.len() as u64 <= count / 100, "{changed:?}");
}

// A face without area remains in about 1 of 200 results.
#[test]
fn nearly_coincident_copies_become_one_solid() {
    let count = if is_exhaustive() { 1000 } else { 60 };
    let mut invalid = Vec::new();
    for seed in 0..count {
        let mut random = Random(seed);
        let size = 10f64.powf(-9.0 + 0.006 * random.below(1001) as f64);
        let soup = torus(3 + random.below(5) as u32, 3 + random.below(4) as u32);
        let (by, each) = (offset(&mut random), random.below(2) == 0);
        let copy = moved(&soup, |p| p + size * if each { offset(&mut random) } else { by });
        let own = volume(|v| soup.points[v as usize], soup.faces());
        let united = unite_solids(&[soup.view(), copy.view()], &Job::default()).unwrap();
        for made in [repaired(&soup.and(&copy)), united] {
            // The union is at most as far from the first solid as the copy. A torus has less than 100 units of area.
            assert!((volume_of(&made) - own).abs() < 100.0 * size, "seed {seed}: {} {own}", volume_of(&made));
            if made.is_valid() {
                assert_manifold(&made);
                assert!(smallest_height(&made.mesh) > 1e-16, "seed {seed}");
            } else {
                invalid.push(seed);
            }
        }
    }
    assert!(invalid.len() as u64 <= count / 60, "{invalid:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(if is_exhaustive() { 2000 } else { 64 }))]

    #[test]
    fn the_tolerance_is_the_largest_move(cells in cells(), width in 1e-6..0.1f64, seed: u64) {
        let mut random = Random(seed);
        let soup = moved(&scattered(&mesh_of(outer_walls(&cells))), |p| p + width * offset(&mut random));
        let made = repaired(&soup);
        let mut largest = 0.0f64;
        for (f, face) in faces_of(&made.mesh).enumerate() {
            let Some(start) = soup.offsets.get(made.face_origin[f] as usize) else { continue };
            let old = &soup.corners[*start as usize..][..4];
            // Parts of faces start at other corners.
            if made.split_faces > 0 || face.len() != 4 {
                return Ok(());
            }
            let old: Vec<u32> = if made.turned[f] { [0, 3, 2, 1].map(|k| old[k]).to_vec() } else { old.to_vec() };
            for (&v, &u) in face.iter().zip(&old) {
                largest = largest.max(made.mesh.positions.get(v).distance(DVec3::from_array(soup.points[u as usize])));
            }
        }
        prop_assert!((made.tolerance - largest).abs() <= 1e-12 * largest, "{} {largest}", made.tolerance);
    }

    #[test]
    fn cavities_that_are_covered_twice_are_united(corners in prop::collection::vec(prop::array::uniform6(1..5i32), 2..4), turns in prop::array::uniform4(any::<bool>())) {
        let host = [[0, 6]; 3];
        let boxes: Vec<[[i32; 2]; 3]> =
            corners.iter().map(|c| [0, 1, 2].map(|k| [c[k].min(c[k + 3]), c[k].max(c[k + 3]) + 1])).collect();
        // A box strictly within another is a solid in the cavity.
        let is_within = |a: &[[i32; 2]; 3], b: &[[i32; 2]; 3]| (0..3).all(|k| a[k][0] > b[k][0] && a[k][1] < b[k][1]);
        prop_assume!(!boxes.iter().any(|a| boxes.iter().any(|b| is_within(a, b))));
        let walls_of = |sides: &[[i32; 2]; 3], is_turned: bool| {
            let sides = *sides;
            let stretched = move |corner: Cell| [0, 1, 2].map(|k| sides[k][corner[k] as usize]);
            (0..6).map(move |k| {
                let mut wall = wall([0; 3], k / 2, k % 2 == 1).map(stretched);
                if is_turned {
                    wall.reverse();
                }
                wall
            })
        };
        let mut soup = mesh_of(walls_of(&host, false));
        let mut empty = BTreeSet::new();
        for (sides, &is_turned) in boxes.iter().zip(&turns) {
            soup = soup.and(&mesh_of(walls_of(sides, is_turned)));
            let [x, y, z] = *sides;
            empty.extend((x[0]..x[1]).flat_map(|i| (y[0]..y[1]).flat_map(move |j| (z[0]..z[1]).map(move |k| [i, j, k]))));
        }
        let made = repaired(&soup);
        assert_manifold(&made);
        prop_assert!(made.is_valid(), "{:?} {:?}", made.after, made.intersections);
        let expected = 216.0 - empty.len() as f64;
        prop_assert!((volume_of(&made) - expected).abs() < 1e-9, "{} instead of {expected}", volume_of(&made));
    }

    #[test]
    fn loose_triangles_stay_as_they_are(count in 1..5u32, seed: u64) {
        let mut random = Random(seed);
        let points: Vec<[f64; 3]> =
            (0..3 * count).map(|v| (offset(&mut random) + 9.0 * f64::from(v / 3)).to_array()).collect();
        let faces: Vec<[u32; 3]> = shuffled((0..count).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect(), seed);
        let soup = Soup::new(points, &faces.iter().map(<[u32; 3]>::as_slice).collect::<Vec<_>>());
        let mut options = Options::default();
        options.fill.keep = Keep::None;
        let made = repair(&soup.view(), &options, &Job::default()).unwrap();
        prop_assert_eq!((made.filled_holes, made.mesh.face_count(), made.is_valid()), (0, count as usize, false));
        prop_assert!(edge_counts(faces_of(&made.mesh)).values().all(|&(up, down)| up + down == 1));
    }
}
