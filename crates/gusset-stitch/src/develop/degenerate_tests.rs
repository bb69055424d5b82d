//! Surfaces without area, and coordinates of any size: results are finite, or the call fails.

use super::{Cuts, Developed, Distortion, Finish, Options, develop};
use gusset_base::error::{Element, Error};
use gusset_base::job::Job;
use gusset_mesh::{Faces, MeshView, Positions};
use std::collections::HashSet;

/// Sizes at which squares of coordinates are 0, subnormal, finite and infinite.
const SIZES: [f64; 10] = [0.0, 5e-324, 1e-310, 1e-200, 1e-160, 1.0, 1e100, 1e149, 1e155, 1e300];

const DISTORTIONS: [Distortion; 3] = [Distortion::Symmetric, Distortion::Rigid, Distortion::Conformal];

/// The points and the faces of a surface.
type Shape = (Vec<[f64; 3]>, Vec<Vec<u32>>);

/// A grid of quads, a tetrahedron, a triangle, and an octahedron.
fn shapes() -> Vec<Shape> {
    let grid = (0..20).map(|k| [f64::from(k / 5), f64::from(k % 5), f64::from(k * k % 7) / 3.0]).collect();
    let quads = (0..15).filter(|k| k % 5 < 4).map(|k| vec![k, k + 1, k + 6, k + 5]).collect();
    let corner = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let sides = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]].map(Vec::from).to_vec();
    let poles = (0..6).map(|k| [0, 1, 2].map(|i| if i == k / 2 { f64::from(1 - 2 * (k % 2)) } else { 0.0 })).collect();
    let eighths = (0..8_u32).map(|k| {
        let [x, y, z] = [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2)];
        if k.count_ones() % 2 == 0 { vec![x, y, z] } else { vec![x, z, y] }
    });
    vec![(grid, quads), (corner[..3].to_vec(), vec![vec![0, 1, 2]]), (corner, sides), (poles, eighths.collect())]
}

/// Returns the Euler characteristic of a development: the number of its charts if all are discs.
fn euler_characteristic(done: &Developed) -> usize {
    let sides = done.mesh.faces().flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
    let edges: HashSet<_> = sides.map(|(u, v)| (u.min(v), u.max(v))).collect();
    done.points.len() + done.mesh.face_count() - edges.len()
}

/// Develops a mesh. Checks that all charts are discs and all numbers finite, or returns the error.
fn check_finite(
    points: &[[f64; 3]],
    faces: &[Vec<u32>],
    options: &Options<'_>,
    context: &str,
) -> Result<Finish, Error> {
    let mut offsets = vec![0];
    faces.iter().for_each(|face| offsets.push(offsets[offsets.len() - 1] + face.len() as u32));
    let corners = faces.concat();
    let faces = Faces::polygons(&offsets, &corners).unwrap();
    let mesh = MeshView::new(Positions::from(points), faces, &Job::default()).unwrap();
    let done = develop(&mesh, options, &Job::default())?;
    assert_eq!(euler_characteristic(&done), done.charts.len(), "{context}");
    assert!(done.points.iter().all(|p| p.is_finite()), "{context}: {:?}", done.points);
    assert!(done.stretches.as_flattened().iter().all(|s| s.is_finite()), "{context}: {:?}", done.stretches);
    for chart in &done.charts {
        assert!(!chart.energy.is_nan() && chart.energy > 3.999_999, "{context}: {chart:?}");
        assert!(chart.energy.is_finite() || chart.stretch[1] <= 0.0, "{context}: {chart:?}");
        assert!(chart.area.is_finite() && chart.flat_area.is_finite(), "{context}: {chart:?}");
        if chart.finish == Finish::Exact {
            let worst = chart.stretch.map(|s| (s - 1.0).abs());
            assert!(worst[0].max(worst[1]) < 1e-3, "{context}: {chart:?}");
        }
    }
    Ok(done.charts[0].finish)
}

#[test]
fn surfaces_of_any_size_are_finite_or_refused() {
    for (number, (points, faces)) in shapes().into_iter().enumerate() {
        for (size, distortion) in SIZES.into_iter().flat_map(|size| DISTORTIONS.map(|distortion| (size, distortion))) {
            let scaled: Vec<_> = points.iter().map(|p| p.map(|x| size * x)).collect();
            for (cuts, max_darts) in [(&[][..], 0), (&[0, 1], 0), (&[], 1)] {
                let cuts = Cuts { vertices: cuts, offsets: &[] };
                let options = Options { distortion, cuts, max_darts, max_iterations: 20, ..Options::default() };
                let context = format!("shape {number}, size {size:e}, {options:?}");
                let done = check_finite(&scaled, &faces, &options, &context);
                assert_eq!(done.is_err(), size > 1e150, "{context}");
                if size == 0.0 {
                    assert_eq!(done, Ok(Finish::Exact), "{context}");
                }
            }
        }
    }
}

#[test]
fn a_large_coordinate_is_named() {
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, -2e150, 0.0]];
    let found = check_finite(&points, &[vec![0, 1, 2]], &Options::default(), "large");
    assert_eq!(
        found,
        Err(Error::CoordinateTooLarge {
            element: Element::Vertex,
            index: 2,
            component: gusset_base::Component::Y,
            value: -2e150
        })
    );
}

#[test]
fn surfaces_with_vertices_in_one_point_or_line_are_finite() {
    let mut random = fastrand::Rng::with_seed(60);
    for case in 0..if cfg!(debug_assertions) { 20 } else { 1000 } {
        for (points, faces) in shapes() {
            // Some vertices move to a common point, some coordinates become 0.
            let size = [1.0, 1e-310, 1e-160, 1e140][random.usize(..4)];
            let (stay, flat) = (random.usize(..=points.len()), random.usize(..4));
            let gather = |(v, p): (usize, &[f64; 3])| {
                let mut p = if v < stay { *p } else { [0.5; 3] };
                p[flat..].fill(0.0);
                p.map(|x| size * x)
            };
            let moved: Vec<_> = points.iter().enumerate().map(gather).collect();
            let distortion = DISTORTIONS[random.usize(..3)];
            let ends = [0, random.u32(1..3)];
            let cuts = Cuts { vertices: &ends[..2 * random.usize(..2)], offsets: &[] };
            let max_darts = random.u32(..2);
            let options = Options { distortion, cuts, max_darts, max_iterations: 20, ..Options::default() };
            let context = format!("case {case}, {moved:?}, {options:?}");
            check_finite(&moved, &faces, &options, &context).unwrap();
        }
    }
}
