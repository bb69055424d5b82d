//! Filters of pieces that overlap: parts of one shape made by formula, moved apart and brought back,
//! trimmed, and assembled.

use crate::common::{Soup, cap, edge_counts, euler, volume};
use crate::editor::{Given, inputs, mesh, points, run_on, text, value, values};
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::attributes::{Domain, Origins};
use gusset::filters::Filter;
use gusset::filters::data::Output;

/// A sphere with bumps, which no turn brings onto itself.
fn bumpy([x, y, z]: [f64; 3]) -> [f64; 3] {
    let radius = 1.0 + 0.12 * (3.0 * x + 1.0).sin() * (2.0 * y).cos() + 0.1 * (4.0 * z + 2.0 * x - y).sin();
    [radius * x, radius * y, radius * z]
}

/// Two parts of it that have a belt in common, with other vertices each.
fn halves() -> [Soup; 2] {
    let mut both = [cap(80, 24, -0.3, 1.0), cap(76, 25, -0.3, -1.0)];
    both.iter_mut().for_each(|soup| soup.points.iter_mut().for_each(|p| *p = bumpy(*p)));
    both
}

fn mean_edge(soup: &Soup) -> f64 {
    let edges = edge_counts(soup.faces());
    let at = |v: u32| DVec3::from(soup.points[v as usize]);
    edges.keys().map(|&(u, v)| at(u).distance(at(v))).sum::<f64>() / edges.len() as f64
}

/// A small motion: a turn about a slanted axis, and a shift.
fn motion() -> (DMat3, DVec3) {
    let rotation = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize(), 2f64.to_radians());
    (rotation, DVec3::new(0.03, -0.02, 0.02))
}

/// Runs a filter on meshes, and returns the origins of its elements.
fn traced(id: &str, soups: &[Soup], set: &[(&str, &[f64])]) -> Vec<Output> {
    let given: Vec<Given> = soups.iter().cloned().map(Given::Mesh).collect();
    let inputs = inputs(&given);
    Filter::find(id).unwrap().run_traced(&inputs, &values(id, &inputs, set), &Job::default()).unwrap()
}

fn origins(output: &Output) -> &Origins {
    let Output::Mesh(_, Some(origins)) = output else { panic!("no origins: {output:?}") };
    origins
}

/// The sources of all elements of a kind, each of which has one.
fn sources(origins: &Origins, domain: Domain) -> Vec<u32> {
    let table = origins.table(domain);
    assert!(table.weights().iter().all(|&weight| weight == 1.0));
    assert_eq!(table.source_indices().len(), table.len());
    table.source_indices().to_vec()
}

#[test]
fn pieces_that_were_moved_apart_are_brought_back() {
    let [first, second] = halves();
    let (rotation, shift) = motion();
    let mut moved = second.clone();
    moved.points.iter_mut().for_each(|p| *p = (rotation * DVec3::from(*p) + shift).to_array());
    let far = moved.points.iter().zip(&second.points).map(|(p, q)| DVec3::from(*p).distance(DVec3::from(*q)));
    let edge = mean_edge(&second);
    assert!(far.fold(0.0, f64::max) > 0.5 * edge);
    let given = [first.clone(), moved];
    let outputs = traced("align", &given, &[]);
    let report = &outputs[1];
    let (at, faces) = mesh(&outputs[0]);
    let count = first.points.len();
    assert_eq!(at[..count], first.points, "the first piece stays");
    for (v, (p, q)) in at[count..].iter().zip(&second.points).enumerate() {
        let off = DVec3::from(*p).distance(DVec3::from(*q));
        assert!(off < 0.1 * edge, "vertex {v} is {off} off\n{}", text(report));
    }
    let both = given[0].and(&given[1]);
    assert_eq!(faces, both.faces().collect::<Vec<_>>());
    let origins = origins(&outputs[0]);
    for (domain, count) in
        [(Domain::Vertices, at.len()), (Domain::Corners, both.corners.len()), (Domain::Faces, faces.len())]
    {
        assert_eq!(sources(origins, domain), (0..count as u32).collect::<Vec<_>>());
    }

    let of = |name: &str| value(report, name);
    assert_eq!([of("pieces"), of("trusted_pieces"), of("converged"), of("overlaps")], [2.0, 2.0, 1.0, 1.0]);
    assert!(of("rounds") > 1.0 && of("mean_residual") < 0.1 * edge, "{}", text(report));
    assert!(text(report).starts_with("2 of 2 pieces trusted\n"), "{}", text(report));
    // The motion as the report writes it does what was done to the mesh, bit for bit.
    let lines: Vec<&str> = text(report).lines().collect();
    let start = lines.iter().position(|line| line.starts_with("piece 1: trusted")).unwrap();
    let rows: Vec<Vec<f64>> = lines[start + 1..start + 4]
        .iter()
        .map(|line| line.split_whitespace().map(|number| number.parse().unwrap()).collect())
        .collect();
    let column = |k: usize| DVec3::new(rows[0][k], rows[1][k], rows[2][k]);
    let turn = DMat3::from_cols(column(0), column(1), column(2));
    for (p, q) in given[1].points.iter().zip(&at[count..]) {
        assert_eq!((turn * DVec3::from(*p) + column(3)).to_array(), *q);
    }
    // A piece alone, and pieces that are apart, stay where they are.
    for alone in [vec![first.clone()], vec![first.clone(), far_away(&second)]] {
        let outputs = run_on("align", &alone, &[]).unwrap();
        let all: Vec<[f64; 3]> = alone.iter().flat_map(|soup| soup.points.clone()).collect();
        assert_eq!(mesh(&outputs[0]).0, all);
        assert_eq!(value(&outputs[1], "trusted_pieces"), 1.0);
    }
}

fn far_away(soup: &Soup) -> Soup {
    let points = soup.points.iter().map(|p| [p[0] + 10.1, p[1] / 3.0, p[2]]).collect();
    Soup { points, ..soup.clone() }
}

/// Moved apart, aligned, trimmed and joined in one go: closed, with the bits of the piece that stays.
#[test]
fn pieces_that_were_moved_apart_become_one() {
    let [first, second] = halves();
    let (rotation, shift) = motion();
    let mut moved = second;
    moved.points.iter_mut().for_each(|p| *p = (rotation * DVec3::from(*p) + shift).to_array());
    let set: &[(&str, &[f64])] = &[("align", &[1.0]), ("overlaps", &[1.0]), ("holes", &[1.0])];
    let outputs = traced("join", &[first.clone(), moved], set);
    let (at, faces) = mesh(&outputs[0]);
    assert_eq!(euler(faces.iter().copied()), 2);
    assert_eq!(["trusted_pieces", "boundary_loops"].map(|name| value(&outputs[1], name)), [2.0, 0.0]);
    assert!(text(&outputs[1]).starts_with("2 of 2 pieces trusted\n"), "{}", text(&outputs[1]));
    let expected: Vec<[f64; 3]> = halves().into_iter().flat_map(|half| half.points).collect();
    let near = at.iter().filter(|p| expected.iter().any(|q| DVec3::from(**p).distance(DVec3::from(*q)) < 0.02));
    assert_eq!(near.count(), at.len());
    let kept = at.iter().filter(|p| first.points.contains(p)).count();
    assert!(kept > first.points.len() / 2, "{kept}");
}

#[test]
fn one_piece_of_each_overlap_is_kept() {
    let given = halves();
    let both = given[0].and(&given[1]);
    let outputs = traced("trim", &given, &[]);
    let (at, faces) = mesh(&outputs[0]);
    let origins = origins(&outputs[0]);
    // Each face is there once at the most, with its corners and vertices, bit for bit.
    let [vertices, corners, kept] = [Domain::Vertices, Domain::Corners, Domain::Faces].map(|of| sources(origins, of));
    for ascending in [&vertices, &corners, &kept] {
        assert!(ascending.windows(2).all(|pair| pair[0] < pair[1]));
    }
    assert_eq!((vertices.len(), kept.len()), (at.len(), faces.len()));
    let old: Vec<&[u32]> = both.faces().collect();
    for (face, &source) in faces.iter().zip(&kept) {
        let named: Vec<u32> = face.iter().map(|&v| vertices[v as usize]).collect();
        assert_eq!(named, old[source as usize]);
    }
    assert!(at.iter().zip(&vertices).all(|(p, &v)| *p == both.points[v as usize]));
    let at_corners: Vec<u32> = faces.iter().flat_map(|face| face.iter().map(|&v| vertices[v as usize])).collect();
    assert!(at_corners.iter().zip(&corners).all(|(&v, &corner)| v == both.corners[corner as usize]));
    // No vertex is left over, and none lies on another piece.
    let used: std::collections::HashSet<u32> = faces.iter().copied().flatten().copied().collect();
    assert_eq!(used.len(), at.len());
    let split = vertices.partition_point(|&v| (v as usize) < given[0].points.len());
    assert!(split > 0 && split < at.len());
    let edge = mean_edge(&given[0]).min(mean_edge(&given[1]));
    for (k, p) in at[..split].iter().enumerate() {
        for q in &at[split..] {
            let distance = DVec3::from(*p).distance(DVec3::from(*q));
            assert!(distance > 0.3 * edge, "vertex {k} is {distance} from the other piece");
        }
    }
    let of = |name: &str| value(&outputs[1], name);
    assert_eq!(of("kept_faces"), faces.len() as f64);
    assert_eq!(of("kept_faces") + of("trimmed_faces"), old.len() as f64);
    assert!(of("trimmed_faces") > 100.0 && of("covered_vertices") > 100.0);
    let report = text(&outputs[1]);
    assert!(report.starts_with(&format!("{} of {} faces kept\npiece 0: ", faces.len(), old.len())), "{report}");
    assert_eq!(report.lines().filter(|line| line.contains("lie on other pieces")).count(), 2, "{report}");
    // Alone, all of a piece is kept.
    let alone = run_on("trim", &given[..1], &[]).unwrap();
    let Output::Mesh(made, _) = &alone[0] else { panic!("{alone:?}") };
    assert_eq!((points(made), made.face_count()), (given[0].points.clone(), given[0].faces().count()));
}

#[test]
fn overlapping_pieces_are_assembled_to_a_closed_mesh() {
    let given = halves();
    let outputs = traced("join", &given, &[("overlaps", &[1.0]), ("holes", &[1.0])]);
    let (at, faces) = mesh(&outputs[0]);
    assert!(edge_counts(faces.iter().copied()).values().all(|&n| n == (1, 1)), "{}", text(&outputs[1]));
    assert_eq!(euler(faces.iter().copied()), 2, "{}", text(&outputs[1]));
    assert!(volume(|v| at[v as usize], faces.iter().copied()) > 3.0);
    let trimmed = value(&outputs[1], "trimmed_faces");
    assert!(trimmed > 100.0);
    assert!(
        text(&outputs[1]).starts_with(&format!("{trimmed} faces trimmed from overlaps\n")),
        "{}",
        text(&outputs[1])
    );
    // The remaining vertices keep their positions.
    let both = given[0].and(&given[1]);
    let table = origins(&outputs[0]).table(Domain::Vertices);
    let old = (0..at.len()).filter_map(|v| if let [source] = table.row(v).0 { Some((v, *source)) } else { None });
    assert!(old.clone().count() > both.points.len() / 2);
    assert!(old.into_iter().all(|(v, source)| at[v] == both.points[source as usize]));
    let kept = run_on("join", &given, &[]).unwrap();
    assert_eq!(value(&kept[1], "trimmed_faces"), 0.0);
    assert!(!text(&kept[1]).contains("trimmed"));
}
