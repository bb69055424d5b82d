//! Where filters say that the elements of their results come from.

use crate::editor::{Given, given, inputs, mesh};
use gusset::Job;
use gusset::attributes::{Domain, Origins};
use gusset::filters::data::{Input, Output};
use gusset::filters::{FILTERS, Filter};

/// Filters that put vertices elsewhere.
const MOVING: [&str; 9] =
    ["align", "deform", "develop", "displace", "lattice", "morph", "net_planarise", "project", "smooth_distance"];

/// The only source of an element, if it has one only.
fn only(origins: &Origins, domain: Domain, k: usize) -> Option<usize> {
    let (sources, weights) = origins.table(domain).row(k);
    (sources.len() == 1).then(|| {
        assert_eq!(weights, [1.0]);
        sources[0] as usize
    })
}

/// The vertices, corners and faces of all inputs, one after the other.
struct Sources {
    points: Vec<[f64; 3]>,
    /// The vertex of each corner, and its face.
    corners: Vec<[usize; 2]>,
}

fn sources(given: &[Given]) -> Sources {
    let mut all = Sources { points: Vec::new(), corners: Vec::new() };
    let mut face = 0;
    for one in given {
        let Given::Mesh(soup) = one else { panic!("curves have no origins") };
        let first = all.points.len();
        all.points.extend(&soup.points);
        let view = soup.view();
        let faces = view.faces();
        for f in 0..faces.len() {
            all.corners.extend(faces.corners(faces.corner_range(f)).map(|v| [first + v as usize, face]));
            face += 1;
        }
    }
    all
}

fn check(filter: &Filter, given: &[Given], outputs: &[Output], name: &str) {
    let Output::Mesh(_, Some(origins)) = &outputs[0] else { panic!("{name}: no origins") };
    let (points, faces) = mesh(&outputs[0]);
    let from = sources(given);
    let count = |domain| origins.table(domain).len();
    let corners: usize = faces.iter().map(|face| face.len()).sum();
    assert_eq!([Domain::Vertices, Domain::Corners, Domain::Faces].map(count), [points.len(), corners, faces.len()]);
    assert_eq!(
        origins.first_sources_of_inputs(Domain::Vertices).last().map(|&end| end as usize),
        Some(from.points.len()),
        "{name}"
    );
    assert_eq!(
        origins.first_sources_of_inputs(Domain::Corners).last().map(|&end| end as usize),
        Some(from.corners.len()),
        "{name}"
    );
    let mut kept = 0;
    for (v, point) in points.iter().enumerate() {
        if let Some(source) = only(origins, Domain::Vertices, v) {
            kept += 1;
            assert!(MOVING.contains(&filter.id) || *point == from.points[source], "{name}: vertex {v}");
        }
    }
    if filter.id == "unite" {
        // New vertices lie on faces of the input.
        for (v, &point) in points.iter().enumerate() {
            let (sources, weights) = origins.table(Domain::Vertices).row(v);
            let mean =
                |k: usize| sources.iter().zip(weights).map(|(&s, &w)| w * from.points[s as usize][k]).sum::<f64>();
            assert!((0..3).all(|k| (mean(k) - point[k]).abs() < 1e-6), "{name}: vertex {v}");
        }
    }
    // They are there for what is old.
    assert!(2 * kept > points.len(), "{name}: {kept} of {}", points.len());
    let mut corner = 0;
    for (f, face) in faces.iter().enumerate() {
        let face_source = only(origins, Domain::Faces, f);
        for &v in *face {
            if let Some([vertex, face]) = only(origins, Domain::Corners, corner).map(|source| from.corners[source]) {
                let row = origins.table(Domain::Vertices).row(v as usize).0;
                let new = only(origins, Domain::Vertices, v as usize).is_none();
                assert!(new || row.contains(&(vertex as u32)), "{name}: corner {corner}");
                // One cell of a thinned grid is many.
                assert!(filter.id == "net_decimate" || new || face_source.is_some(), "{name}: face {face}");
            }
            corner += 1;
        }
    }
}

#[test]
fn filters_tell_where_elements_come_from() {
    let mut checked = 0;
    for filter in FILTERS {
        let given = given(filter, 100);
        let inputs = inputs(&given);
        let defaults = filter.defaults(&inputs);
        let mut start = 0;
        let mut cases = vec![defaults.clone()];
        for param in filter.params {
            for choice in 0..param.choices.len().max(if param.max == 1.0 && param.step == 1.0 { 2 } else { 0 }) {
                let mut values = defaults.clone();
                values[start] = choice as f64;
                cases.push(values);
            }
            start += param.kind.component_count();
        }
        for values in &cases {
            // Some choices fit other inputs.
            let (Ok(traced), Ok(plain)) =
                (filter.run_traced(&inputs, values, &Job::default()), filter.run(&inputs, values, &Job::default()))
            else {
                continue;
            };
            let is_traced = |output: &Output| matches!(output, Output::Mesh(_, Some(_)));
            assert!(!plain.iter().any(is_traced), "{}", filter.id);
            assert_eq!(traced.iter().any(is_traced), filter.has_origins, "{}", filter.id);
            if filter.has_origins {
                let name = format!("{} {values:?}", filter.id);
                assert!(mesh(&traced[0]) == mesh(&plain[0]), "{name}");
                check(filter, &given, &traced, &name);
                checked += 1;
            }
        }
    }
    assert!(checked > 60, "{checked}");
}

/// Every second row and column of a plane, and the plane moved: corners come from the cells there.
#[test]
fn corners_of_grids_are_those_of_their_own_cells() {
    let mut soup = crate::common::sheet(9, 7);
    soup.points.iter_mut().for_each(|p| p[2] = 1e-4 * (p[0] % 2.0));
    for (id, values) in [("net_decimate", [0.01, 0.0]), ("displace", [0.5, 0.0]), ("displace", [0.5, 1.0])] {
        let inputs = [Input::Mesh(soup.view())];
        let outputs = Filter::find(id).unwrap().run_traced(&inputs, &values, &Job::default()).unwrap();
        let Output::Mesh(made, Some(origins)) = &outputs[0] else { panic!("{id}") };
        let view = soup.view();
        let faces = view.faces();
        assert!(id != "net_decimate" || made.positions.len() < soup.points.len() / 2);
        for c in 0..made.face_corners.len() {
            let source = only(origins, Domain::Corners, c).unwrap();
            let v = only(origins, Domain::Vertices, made.face_corners[c] as usize).unwrap();
            assert_eq!(faces.corner(source as u32) as usize, v, "{id}: corner {c}");
            // The old cell is on the same side: its middle is nearer to the new face's than the corner.
            let middle = |points: &[[f64; 3]]| -> [f64; 2] {
                [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64)
            };
            let old: Vec<_> = faces
                .corners(faces.corner_range(faces.face_of_half_edge(source as u32) as usize))
                .map(|v| soup.points[v as usize])
                .collect();
            let f = made.face_offsets.partition_point(|&end| end as usize <= c) - 1;
            let range = made.face_offsets[f] as usize..made.face_offsets[f + 1] as usize;
            let new: Vec<_> = made.face_corners[range].iter().map(|&v| made.positions.get(v).to_array()).collect();
            let (at, [old, new]) = (soup.points[v], [middle(&old), middle(&new)]);
            let side = |to: [f64; 2]| [0, 1].map(|k| (to[k] - at[k]).partial_cmp(&0.0));
            assert_eq!(side(old), side(new), "{id}: corner {c}");
        }
    }
}
