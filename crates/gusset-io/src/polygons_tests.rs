use crate::test_measures::{area_and_volume, is_closed, mesh_from_faces, triangulated};

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
