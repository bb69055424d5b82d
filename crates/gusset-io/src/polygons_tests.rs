use crate::test_measures::{area_and_volume, is_closed, mesh_from_faces, polygon_area, triangulated};
use proptest::prelude::*;

fn one_face(points: &[[f64; 3]]) -> crate::Mesh {
    let face: Vec<u32> = (0..points.len() as u32).collect();
    mesh_from_faces(points, &[&face])
}

fn flat(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    points.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}

/// Area of the triangles, of which none may be turned over.
fn area_of_split(points: &[[f64; 3]]) -> f64 {
    area_and_volume(&triangulated(&one_face(points))).0
}

#[test]
fn u_profile_keeps_its_area() {
    let outline = [[0, 0], [5, 0], [5, 4], [4, 4], [4, 1], [1, 1], [1, 4], [0, 4]];
    let points: Vec<[f64; 3]> =
        [0.0, 2.0].iter().flat_map(|&z| outline.map(|[x, y]| [f64::from(x), f64::from(y), z])).collect();
    let mut faces: Vec<Vec<u32>> = vec![(0..8).rev().collect(), (8..16).collect()];
    faces.extend((0..8).map(|k| vec![k, (k + 1) % 8, (k + 1) % 8 + 8, k + 8]));
    let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    let made = triangulated(&mesh_from_faces(&points, &faces));
    let (area, volume) = area_and_volume(&made);
    assert!((area - 70.0).abs() < 1e-12 && (volume - 22.0).abs() < 1e-12, "{area} {volume}");
    assert!(is_closed(&made));
}

#[test]
fn wall_with_window_keeps_its_hole() {
    let front = [[0, 0], [6, 0], [6, 3], [0, 3], [2, 1], [4, 1], [4, 2], [2, 2]];
    let points: Vec<[f64; 3]> =
        [0.0, 0.3].iter().flat_map(|&y| front.map(|[x, z]| [f64::from(x), y, f64::from(z)])).collect();
    let faces: [&[u32]; 10] = [
        &[0, 1, 2, 3, 0, 4, 7, 6, 5, 4],
        &[9, 8, 12, 13, 14, 15, 12, 8, 11, 10],
        &[0, 8, 9, 1],
        &[1, 9, 10, 2],
        &[2, 10, 11, 3],
        &[3, 11, 8, 0],
        &[4, 5, 13, 12],
        &[5, 6, 14, 13],
        &[6, 7, 15, 14],
        &[7, 4, 12, 15],
    ];
    let made = triangulated(&mesh_from_faces(&points, &faces));
    let (area, volume) = area_and_volume(&made);
    assert!((area - 39.2).abs() < 1e-12 && (volume - 4.8).abs() < 1e-12, "{area} {volume}");
    assert!(is_closed(&made));
}

#[test]
fn several_holes_share_bridges() {
    // Windows in a row, each bridged to the lower left corner of the window before it.
    for (windows, scale) in [(2, 1.0), (7, 0.1), (40, 1e6), (300, 1.0)] {
        let mut outline = vec![[0.0, 0.0]];
        let mut way_back = Vec::new();
        let width = f64::from(windows) * 3.0 + 1.0;
        for window in 0..windows {
            let (x, y) = (1.0 + 3.0 * f64::from(window), 1.0 - 0.5 * f64::from(window) / f64::from(windows));
            outline.extend([[x, y], [x, y + 1.0], [x + 1.0, y + 1.0], [x + 1.0, y], [x, y]]);
            way_back.push([x, y]);
        }
        way_back.pop();
        outline.extend(way_back.iter().rev());
        outline.extend([[0.0, 0.0], [width, 0.0], [width, 3.0], [0.0, 3.0]]);
        let outline: Vec<[f64; 2]> = outline.iter().map(|point| point.map(|part| part * scale)).collect();
        let wanted = (3.0 * width - f64::from(windows)) * scale * scale;
        let area = area_of_split(&flat(&outline));
        assert!((area / wanted - 1.0).abs() < 1e-12, "{windows}: {area} {wanted}");
    }
}

#[test]
fn quad_takes_the_better_diagonal() {
    let arrow = [[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]];
    for first in 0..4 {
        let turned: Vec<[f64; 2]> = (0..4).map(|k| arrow[(first + k) % 4]).collect();
        assert!((area_of_split(&flat(&turned)) - 1.0).abs() < 1e-15);
    }
    let mut triangles = Vec::new();
    let long = flat(&[[0.0, 0.0], [1.0, -0.1], [4.0, 0.0], [1.0, 0.1]]);
    crate::polygons::triangulate_face(&one_face(&long), 0, &mut triangles).unwrap();
    assert_eq!(triangles, [[1, 2, 3], [1, 3, 0]]);
    // A square that is turned by rounding: always from the first corner.
    for step in 0..100 {
        let (sin, cos) = f64::from(step).sin_cos();
        let square = flat(&[[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]]);
        crate::polygons::triangulate_face(&one_face(&square), 0, &mut triangles).unwrap();
        assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
    }
}

#[test]
fn corners_on_sides_are_used() {
    // A triangle with corners on its sides: no triangle is flat.
    let points =
        flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [2.0, 1.0], [1.0, 2.0], [0.0, 3.0], [0.0, 1.5]]);
    for first in 0..points.len() {
        let turned: Vec<[f64; 3]> = (0..points.len()).map(|k| points[(first + k) % points.len()]).collect();
        let made = triangulated(&one_face(&turned));
        for face in 0..made.face_count() {
            let corners: Vec<[f64; 3]> = made.face(face).iter().map(|&v| made.positions.get(v as usize)).collect();
            assert!(area_of_split(&corners) > 0.1);
        }
        assert!((area_of_split(&turned) - 4.5).abs() < 1e-12);
    }
}

#[test]
fn warped_polygon_is_covered_once() {
    // A ring around a cylinder's side, whose projection along its mean normal folds over nothing.
    let points: Vec<[f64; 3]> = (0..12)
        .map(|k| (f64::from(k) / 12.0 * std::f64::consts::TAU).sin_cos())
        .map(|(sin, cos)| [cos, sin, 0.4 * (cos * cos - sin * sin)])
        .collect();
    let area = area_of_split(&points);
    assert!(area > 3.0 && area < 4.0, "{area}");
}

#[test]
fn degenerate_polygons_give_all_triangles() {
    let mut cases: Vec<Vec<[f64; 3]>> = vec![
        vec![[1.0; 3]; 9],
        (0..50).map(|k| [f64::from(k), 0.0, 0.0]).collect(),
        vec![[f64::NAN; 3]; 70],
        vec![[f64::INFINITY, 0.0, 1.0]; 70],
        vec![[1e308, -1e308, 1e308]; 6],
    ];
    cases.push(
        (0..200).map(|k| [f64::from(k * k % 17) * 1e300, f64::from(k * 7 % 13) * -1e300, f64::from(k % 5)]).collect(),
    );
    for points in cases {
        let made = triangulated(&one_face(&points));
        assert_eq!(made.face_count(), points.len() - 2);
    }
}

#[test]
fn large_polygons_take_little_time() {
    let count = 20_000;
    let start = std::time::Instant::now();
    // A comb, a star with random radii, one point, and random points.
    let mut random = 1_u64;
    let mut next = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 40) as f64 / f64::from(1 << 24)
    };
    let comb: Vec<[f64; 2]> = (0..count)
        .map(|k| [f64::from(k / 2), if k % 2 == 0 { 0.5 } else { 1.0 }])
        .chain([[f64::from(count), 0.0], [-1.0, 0.0]])
        .rev()
        .collect();
    let star: Vec<[f64; 2]> = (0..count)
        .map(|k| (f64::from(k) / f64::from(count) * std::f64::consts::TAU).sin_cos())
        .map(|(sin, cos)| {
            let radius = 1.0 + next();
            [radius * cos, radius * sin]
        })
        .collect();
    for outline in [&comb, &star] {
        let area = area_of_split(&flat(outline));
        assert!((area / polygon_area(outline) - 1.0).abs() < 1e-9, "{area} {}", polygon_area(outline));
    }
    let random_points: Vec<[f64; 2]> = (0..count).map(|_| [next(), next()]).collect();
    for outline in [&random_points, &vec![[0.0, 0.0]; count as usize]] {
        area_of_split(&flat(outline));
    }
    assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
}

/// Splits a disc's sectors at random radii: a simple star-shaped polygon in a random plane.
fn star(radii: &[f64], tilt: [f64; 3]) -> (Vec<[f64; 3]>, f64) {
    let flat: Vec<[f64; 2]> = radii
        .iter()
        .enumerate()
        .map(|(k, radius)| (*radius, (k as f64 / radii.len() as f64 * std::f64::consts::TAU).sin_cos()))
        .map(|(radius, (sin, cos))| [radius * cos, radius * sin])
        .collect();
    let slope = (1.0 + tilt[0] * tilt[0] + tilt[1] * tilt[1]).sqrt();
    let area = polygon_area(&flat) * slope;
    (flat.iter().map(|&[x, y]| [x, y, tilt[0] * x + tilt[1] * y + tilt[2]]).collect(), area)
}

proptest! {
    #[test]
    fn simple_polygons_keep_their_area(
        radii in prop::collection::vec(0.1_f64..3.0, 5..120),
        tilt in prop::array::uniform3(-20.0_f64..20.0),
    ) {
        let (points, wanted) = star(&radii, tilt);
        let area = area_of_split(&points);
        prop_assert!((area / wanted - 1.0).abs() < 1e-9, "{area} {wanted}");
    }

    #[test]
    fn coordinates_on_a_lattice_never_lose_triangles(points in prop::collection::vec(prop::array::uniform3(0_u8..4), 3..60)) {
        let points: Vec<[f64; 3]> = points.iter().map(|point| point.map(f64::from)).collect();
        let count = points.len() as u32;
        let front: Vec<u32> = (0..count).collect();
        let back: Vec<u32> = (0..count).rev().collect();
        prop_assert!(is_closed(&triangulated(&mesh_from_faces(&points, &[&front, &back]))));
    }
}
