//! Filters that read and mend meshes, held against what the meshes are known to be.

use crate::common::{self, Soup, cap, sheet};
use crate::editor::{circle, curve, lines, mesh, pieces, polylines, run_on, run_on_curves, text, value, values};
use gusset::filters::Filter;
use gusset::filters::data::{Input, Output};
use gusset::{Allowed, Error, Job};

fn inputs(soups: &[Soup]) -> Vec<Input<'_>> {
    soups.iter().map(|soup| Input::Mesh(soup.view())).collect()
}

/// Two caps of 12 and of 9 columns.
fn caps() -> [Soup; 2] {
    let mut second = cap(9, 4, 0.3, -1.0);
    second.points.iter_mut().for_each(|p| p[0] += 0.6);
    [cap(12, 3, 0.2, 1.0), second]
}

#[test]
fn boundary_loops_gives_the_rim() {
    let soups = caps();
    let outputs = Filter::find("boundary_loops").unwrap().run(&inputs(&soups[..1]), &[], &Job::default()).unwrap();
    let [Output::Curves(curves), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
    assert_eq!((curves.offsets.as_slice(), curves.closed.as_slice()), (&[0, 12][..], &[true][..]));
    assert!(curves.points.iter().all(|p| (p[2] - 0.2).abs() < 1e-12));
    assert!(text.starts_with("1 boundary loop, 12 edges\n"), "{text}");
}

#[test]
fn stitch_closes_a_sphere_by_loops_found_and_by_loops_given() {
    let soups = caps();
    let filter = Filter::find("stitch").unwrap();
    let found = filter.run(&inputs(&soups), &[], &Job::default()).unwrap();
    assert_eq!(filter.run(&inputs(&soups), &[0.0, 0.0], &Job::default()).unwrap(), found);
    let Output::Mesh(mesh, _) = &found[0] else { panic!("{found:?}") };
    let faces = mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize]);
    assert!(common::edge_counts(faces.clone()).values().all(|&n| n == (1, 1)));
    assert_eq!(common::euler(faces), 2);
    let wrong = filter.run(&inputs(&soups), &[0.0, 1.0], &Job::default());
    let below =
        |option, value, count| Err(Error::OptionOutOfRange { option, value, allowed: Allowed::IndexBelow(count) });
    assert_eq!(wrong, below("loop_b", 1.0, 1));
    let both = soups[0].and(&soups[1]);
    let within = filter.run(&[Input::Mesh(both.view())], &[], &Job::default()).unwrap();
    assert_eq!(within[0], found[0]);
}

#[test]
fn fill_closes_what_it_may() {
    let filter = Filter::find("fill").unwrap();
    let soups = caps();
    let both = soups[0].and(&soups[1]);
    // Refined and fair; then the second rim is too long, or is the longest.
    for (values, filled) in
        [(&[2.0][..], 2), (&[0.0, 2.0, 10.0], 1), (&[1.0, 0.0, 0.0, 6.05], 1), (&[0.0, 0.0, 0.0, 0.0, 2.0], 1)]
    {
        let outputs = filter.run(&[Input::Mesh(both.view())], values, &Job::default()).unwrap();
        let [Output::Mesh(mesh, _), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
        assert!(text.starts_with(&format!("filled {filled} of 2 boundary loops")), "{values:?}: {text}");
        let faces = mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize]);
        let open = common::edge_counts(faces).values().filter(|&&n| n != (1, 1)).count();
        assert_eq!(open == 0, filled == 2, "{values:?}");
    }
    let inputs = [Input::Mesh(both.view())];
    let planned = values("fill", &inputs, &[("plan_only", &[1.0])]);
    let outputs = filter.run(&inputs, &planned, &Job::default()).unwrap();
    let said = text(&outputs[1]);
    assert!(
        said.starts_with("would fill 2 of 2 boundary loops by 0 faces and 0 new vertices\n2 boundary loops left"),
        "{said}"
    );
    assert_eq!(mesh(&outputs[0]).1.len(), both.faces().count());
}

#[test]
fn closed_results_are_turned_outwards_as_the_flags_say() {
    let turned: Vec<Soup> = caps().iter().map(Soup::turned).collect();
    let faces: usize = turned.iter().map(|soup| soup.faces().count()).sum();
    for (id, soups, later, default) in
        [("stitch", &turned[..], 0, 0.0), ("fill", &turned[..1], 1, 0.0), ("join", &turned[..], 7, 1.0)]
    {
        let params = Filter::find(id).unwrap().params;
        let place = params.iter().position(|param| param.id == "outward").unwrap();
        assert_eq!(params[place].default, [default], "{id}");
        assert_eq!(place + 1 + later, params.len(), "hosts store parameters by their places");
        for set in [false, true] {
            let mut given: Vec<f64> =
                params.iter().map(|param| param.default.first().copied().unwrap_or(0.0)).collect();
            given[place] = f64::from(u8::from(set));
            let outputs = run_on(id, soups, &given).unwrap();
            let (points, joined) = mesh(&outputs[0]);
            let volume = common::volume(|v| points[v as usize], joined.iter().copied());
            assert!(if set { volume > 1.0 } else { volume < -1.0 }, "{id} {set}: {volume}");
            let count = match id {
                "join" => value(&outputs[1], "turned_faces") as usize,
                _ => value(&outputs[1], "turned_outwards") as usize,
            };
            let all = if id == "join" { faces } else { joined.len() };
            assert_eq!(count, if set { all } else { 0 }, "{id} {set}");
            assert_eq!(text(&outputs[1]).contains(" reversed"), set, "{}", text(&outputs[1]));
        }
    }
}

#[test]
fn check_names_what_is_wrong() {
    // A sheet of 3 x 2 quads; then a fin on an inner edge, a face against its neighbours, a twin, a
    // needle, a lone vertex.
    let mut soup = sheet(3, 2);
    let clean = run_on("check", std::slice::from_ref(&soup), &[]).unwrap();
    let clean = text(&clean[0]);
    assert!(clean.starts_with("12 vertices, 17 edges, 6 faces, 1 piece, 1 walk round the boundary\n"), "{clean}");
    assert!(clean.contains("not closed, manifold, oriented\nEuler characteristic 1, genus 0\n"), "{clean}");
    assert!(clean.contains("10 boundary edges:") && clean.contains(" 0-1"), "{clean}");
    assert_eq!(clean.lines().count(), 4, "{clean}");
    soup.points.extend([[1.0, 1.0, 1.0], [9.0; 3], [3.0, 0.0, 0.0]]);
    soup.face(&[5, 6, 12]);
    soup.face(&[0, 1, 5, 4]);
    soup.face(&[2, 3, 14]);
    let faulty = run_on("check", std::slice::from_ref(&soup), &[]).unwrap();
    let faulty = text(&faulty[0]);
    for line in ["1 duplicate face: 7\n", "1 face without area: 8\n", "1 unused vertex: 13\n", "not manifold"] {
        assert!(faulty.contains(line), "{line}: {faulty}");
    }
    let threes = faulty.lines().find(|line| line.contains("three or more")).unwrap();
    assert!(threes.contains(" 5-6") || threes.contains(" 6-5"), "{threes}");
    let short = run_on("check", &[soup], &[1.0]).unwrap();
    assert!(text(&short[0]).contains(" ...\n"));
    // A one-sided strip of three quads.
    let strip = Soup::new(
        (0..6).map(|k| [f64::from(k % 3), f64::from(k / 3), f64::from(k * k)]).collect(),
        &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 3, 0, 5]],
    );
    assert!(text(&run_on("check", &[strip], &[]).unwrap()[0]).contains("one-sided"));
}

#[test]
fn check_finds_intersections_on_request() {
    let mut soup = sheet(3, 2);
    soup.points.extend([[0.25, 0.5, -1.0], [1.75, 0.5, -1.0], [1.75, 0.5, 1.0], [0.25, 0.5, 1.0]]);
    soup.face(&[12, 13, 14, 15]);
    let Output::Text(plain) = &run_on("check", std::slice::from_ref(&soup), &[]).unwrap()[0] else { panic!() };
    assert!(plain.values().iter().all(|(name, _)| *name != "intersections"));
    for (listed, list) in [(20.0, "0-6 1-6\n"), (1.0, "0-6 ...\n")] {
        let found = &run_on("check", std::slice::from_ref(&soup), &[listed, 1.0]).unwrap()[0];
        assert_eq!(value(found, "intersections"), 2.0);
        assert!(text(found).ends_with(&format!("\n2 pairs of faces intersect: {list}")), "{}", text(found));
    }
    let clean = &run_on("check", &[sheet(3, 2)], &[20.0, 1.0]).unwrap()[0];
    assert!(value(clean, "intersections") == 0.0 && text(clean).ends_with("\nno faces intersect\n"));
}

#[test]
fn join_keeps_outlines_open_unless_every_loop_is_a_hole() {
    // A sheet with a hole, and a part beside it.
    let whole = sheet(5, 5);
    let part = |wanted: fn(usize) -> bool| {
        let mut soup = Soup { points: whole.points.clone(), offsets: vec![0], ..Soup::default() };
        whole.faces().enumerate().filter(|(f, _)| wanted(*f)).for_each(|(_, face)| soup.face(face));
        soup
    };
    let pieces = [part(|f| f % 5 < 3 && f != 11), part(|f| f % 5 >= 3)];
    for (keep, filled, loops) in [(0.0, 1.0, 1.0), (1.0, 2.0, 0.0), (2.0, 1.0, 1.0), (3.0, 1.0, 1.0)] {
        let inputs = inputs(&pieces);
        let values = values("join", &inputs, &[("holes", &[1.0]), ("keep", &[keep])]);
        let done = Filter::find("join").unwrap().run(&inputs, &values, &Job::default()).unwrap();
        assert_eq!((value(&done[1], "filled_holes"), value(&done[1], "boundary_loops")), (filled, loops), "{keep}");
    }
}

#[test]
fn welding_and_checking_agree_in_their_words_and_numbers() {
    // Two quads beside each other, with vertices of their own; and one that lies on the border of both.
    let mut soup = Soup::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], &[&[0, 1, 2, 3]]);
    soup.points.extend([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 1.0, 0.0]]);
    soup.face(&[4, 5, 6, 7]);
    let apart = run_on("check", std::slice::from_ref(&soup), &[]).unwrap();
    assert_eq!((value(&apart[0], "boundary_edges"), value(&apart[0], "pieces")), (8.0, 2.0));
    let welded = run_on("weld", std::slice::from_ref(&soup), &[]).unwrap();
    assert_eq!(
        text(&welded[1]),
        "2 vertices welded, 1 edge sewn, 0 faces dropped\nall coincident borders are welded\n"
    );
    assert_eq!(value(&welded[1], "coincident_boundary_edges"), 0.0);
    let Output::Mesh(mesh, _) = &welded[0] else { panic!("{welded:?}") };
    let after = Filter::find("check")
        .unwrap()
        .run(&[Input::Mesh(mesh.view(&Job::default()).unwrap())], &[], &Job::default())
        .unwrap();
    assert!(text(&after[0]).starts_with("6 vertices, 7 edges, 2 faces, 1 piece, 1 walk round the boundary\n"));
    assert!(text(&after[0]).contains("\n6 boundary edges: "), "{}", text(&after[0]));
    // A third sheet on the same border: two of the three edges can be one, the third is left on them.
    soup.points.extend([[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.5, 1.0]]);
    soup.face(&[8, 9, 10]);
    let left = run_on("weld", &[soup], &[]).unwrap();
    let count = value(&left[1], "coincident_boundary_edges");
    assert!(count > 0.0 && text(&left[1]).contains("not welded: "), "{}", text(&left[1]));
    assert!(text(&left[1]).contains("that coincide with others"), "{}", text(&left[1]));
}

#[test]
fn borders_that_do_not_match_are_sewn_and_assembled() {
    // A triangle on the side of a square that has a vertex more there.
    let points = vec![[0.0; 3], [4.0, 0.0, 0.0], [2.0, 3.0, 0.0]];
    let upper = Soup::new(points, &[&[0, 1, 2]]);
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, -4.0, 0.0], [0.0, -4.0, 0.0]];
    let lower = Soup::new(points, &[&[4, 3, 2, 1, 0]]);
    let sewn = run_on("sew", &[upper.and(&lower)], &[]).unwrap();
    assert_eq!(
        text(&sewn[1]),
        "2 vertices welded, 2 edges sewn, 1 face split at 1 point\nnot welded: 0 vertices that lie on other vertices or on edges\n"
    );
    let Output::Mesh(mesh, _) = &sewn[0] else { panic!("{sewn:?}") };
    assert_eq!((mesh.positions.len(), mesh.face_count()), (6, 3));
    let pieces = [upper, lower];
    for (weld, edges, loops) in [(0.0, 2.0, 1.0), (1.0, 0.0, 2.0), (2.0, 0.0, 2.0)] {
        let done = run_on("join", &pieces, &[weld, -1.0, 0.0]).unwrap();
        assert_eq!((value(&done[1], "sewn_edges"), value(&done[1], "boundary_loops")), (edges, loops), "{weld}");
    }
}

#[test]
fn facing_arcs_are_on_the_side_of_the_other_loop() {
    // Two circles side by side in a plane: of each the half that looks at the other, without the
    // two points abreast.
    let loops = polylines(&[(circle(40, 1.0, [0.0; 3]), true), (circle(24, 1.0, [5.0, 0.0, 0.0]), true)]);
    let outputs = run_on_curves("facing_arcs", std::slice::from_ref(&loops), &[]).unwrap();
    let arcs = lines(&outputs[0]);
    assert_eq!(arcs.closed, [false, false]);
    assert_eq!([curve(arcs, 0).len(), curve(arcs, 1).len()], [19, 11], "{}", text(&outputs[1]));
    assert!(curve(arcs, 0).iter().all(|p| p[0] > 1e-9) && curve(arcs, 1).iter().all(|p| p[0] < 5.0 - 1e-9));
    // From end to end, across the first point of the list.
    let ys: Vec<f64> = curve(arcs, 0).iter().map(|p| p[1]).collect();
    assert!(ys.windows(2).all(|pair| pair[0] < pair[1]), "{ys:?}");
    let outputs = run_on_curves("facing_arcs", std::slice::from_ref(&loops), &[0.0, 1.0, 0.0, 0.0, 0.9]).unwrap();
    assert!(curve(lines(&outputs[0]), 0).iter().all(|p| p[0] > 0.9));
    let missing = run_on_curves("facing_arcs", &[loops], &[0.0, 2.0]);
    let allowed = Allowed::IndexBelow(2);
    assert_eq!(missing, Err(Error::OptionOutOfRange { option: "curve_b", value: 2.0, allowed }));
    // One above the other with all of either facing: a closed curve each.
    let tilted = polylines(&[(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], true), (vec![[0.0, 0.0, 1.0]], true)]);
    let refused = run_on_curves("facing_arcs", &[tilted], &[]);
    assert!(matches!(refused, Err(Error::PlanesUndecided { .. })), "{refused:?}");
}

#[test]
fn strips_span_two_curves() {
    let rings = polylines(&[(circle(16, 1.0, [0.0; 3]), true), (circle(12, 1.0, [0.0, 0.0, 2.0]), true)]);
    let outputs = run_on_curves("strip", std::slice::from_ref(&rings), &[]).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!((points.len(), faces.len()), (28, 28));
    assert_eq!(common::euler(faces.iter().copied()), 0);
    // Every edge except the edges of the two curves has two half-edges of opposite directions.
    let edges = common::edge_counts(faces.iter().copied());
    assert_eq!(edges.values().filter(|&&count| count != (1, 1)).count(), 28);
    // The band of least area about a cylinder is near to it.
    let area: f64 = faces
        .iter()
        .map(|face| {
            let [a, b, c] = [0, 1, 2].map(|k| glam::DVec3::from(points[face[k] as usize]));
            (b - a).cross(c - a).length() / 2.0
        })
        .sum();
    assert!((area / (4.0 * std::f64::consts::PI) - 1.0).abs() < 0.03, "{area}");
    let three = polylines(&[(circle(5, 1.0, [0.0; 3]), true), (circle(5, 1.0, [1.0; 3]), true), (Vec::new(), true)]);
    let mixed = polylines(&[(circle(5, 1.0, [0.0; 3]), true), (circle(5, 1.0, [1.0; 3]), false)]);
    for wrong in [three, mixed] {
        let refused = run_on_curves("strip", &[wrong], &[]);
        let is_named = matches!(
            refused,
            Err(Error::CurveCount { input: 0, given: 3, needed: "two" } | Error::InputUnfit { input: 0, .. })
        );
        assert!(is_named, "{refused:?}");
    }
    let short = polylines(&[(vec![[0.0; 3]], true), (vec![[1.0; 3]], true)]);
    assert!(matches!(run_on_curves("strip", &[short], &[]), Err(Error::LoopTooShort { count: 1, .. })));
}

#[test]
fn what_is_joined_or_deformed_keeps_its_faces() {
    let [soup, _] = pieces(200);
    let given = [Input::Mesh(soup.view())];
    let faces: Vec<&[u32]> = soup.faces().collect();
    // A twist by an angle for each unit of height, round the z axis.
    let twisted =
        run_on("deform", std::slice::from_ref(&soup), &values("deform", &given, &[("amount", &[0.7])])).unwrap();
    let (points, twisted_faces) = mesh(&twisted[0]);
    assert_eq!(twisted_faces, faces);
    for (p, q) in soup.points.iter().zip(&points) {
        let (sin, cos) = (0.7 * p[2]).sin_cos();
        let expected = [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1], p[2]];
        assert!((0..3).all(|k| (expected[k] - q[k]).abs() < 1e-12), "{q:?} {expected:?}");
    }
    let same = run_on("deform", std::slice::from_ref(&soup), &values("deform", &given, &[("amount", &[0.0])])).unwrap();
    assert_eq!(mesh(&same[0]).0, soup.points);
}

#[test]
fn projections_land_on_the_plane_along_their_lines() {
    let [soup, _] = pieces(200);
    let given = [Input::Mesh(soup.view())];
    // 2 x + 3 y + 6 z = 14: the unit normal is (2, 3, 6) / 7, the distance 2.
    let plane: &[f64] = &[2.0, 3.0, 6.0, 14.0];
    let height = |p: &[f64; 3]| (2.0 * p[0] + 3.0 * p[1] + 6.0 * p[2]) / 7.0 - 2.0;
    let cases: [(f64, [f64; 3]); 3] = [(0.0, [2.0, 3.0, 6.0]), (1.0, [1.0, 0.0, 1.0]), (2.0, [0.0; 3])];
    for (along, way) in cases {
        let set: &[(&str, &[f64])] =
            &[("plane", plane), ("along", &[along]), ("direction", &[1.0, 0.0, 1.0]), ("eye", &[10.0, 20.0, 30.0])];
        let outputs = run_on("project", std::slice::from_ref(&soup), &values("project", &given, set)).unwrap();
        let (points, _) = mesh(&outputs[0]);
        for (p, q) in soup.points.iter().zip(&points) {
            let moved = [0, 1, 2].map(|k| q[k] - p[k]);
            let way = if along == 2.0 { [p[0] - 10.0, p[1] - 20.0, p[2] - 30.0] } else { way };
            let cross = (0..3).map(|k| moved[k] * way[(k + 1) % 3] - moved[(k + 1) % 3] * way[k]);
            assert!(height(q).abs() < 1e-12 && cross.into_iter().all(|x| x.abs() < 1e-10), "{along} {p:?} {q:?}");
        }
    }
    for (along, option, set) in [(1.0, "direction", [3.0, -2.0, 0.0]), (2.0, "eye", [7.0, 0.0, 0.0])] {
        let set: &[(&str, &[f64])] = &[("plane", plane), ("along", &[along]), (option, &set)];
        match run_on("project", std::slice::from_ref(&soup), &values("project", &given, set)) {
            Err(Error::OptionOutOfRange { option: found, .. }) => assert_eq!(found, option),
            other => panic!("{option}: {:?}", other.err()),
        }
    }
    // Suggested: the plane under the mesh, so that half the way halves heights above it.
    let half =
        run_on("project", std::slice::from_ref(&soup), &values("project", &given, &[("strength", &[0.5])])).unwrap();
    let low = soup.points.iter().map(|p| p[2]).fold(f64::MAX, f64::min);
    for (p, q) in soup.points.iter().zip(mesh(&half[0]).0) {
        assert!((q[2] - (p[2] + low) / 2.0).abs() < 1e-12 && p[0] == q[0]);
    }
}
