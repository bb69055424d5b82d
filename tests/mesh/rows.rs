//! Strips between arcs and between loops, with rows of new vertices: counts that H and P predict,
//! valid and oriented meshes.

use crate::common::{Soup, cap, edge_counts, euler, sheet, some_of};
use glam::DVec3;
use gusset::boundary::{Options as BoundaryOptions, boundary_loops};
use gusset::check::check;
use gusset::mesh::{Faces, Mesh, MeshView, PositionBuffer, Positions};
use gusset::stitch::facing::Arc;
use gusset::stitch::{
    Cells, Extent, Meridians, Options, Request, Rows, Ruled, RuledOptions, Start, Stitch, ruled, stitch,
};
use gusset::winged::{Winding, WingedEdges};
use gusset::{Error, Job};

fn join(a: &Soup, b: &Soup, options: &Options) -> Result<Stitch, Error> {
    stitch(&Request { a: &a.view(), loop_a: None, b: Some(&b.view()), loop_b: None }, options, &Job::default())
}

fn faces(mesh: &Mesh) -> impl Iterator<Item = &[u32]> + Clone {
    mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize])
}

/// A sheet with `count` vertices along its upper side (at least two cells wide), shifted by (x, y).
/// Also returns the place in its loop where the arc of `count` vertices on the upper or lower side
/// begins.
fn sheet_with_arc(count: u32, x: f64, y: f64, upper: bool) -> (Soup, Arc) {
    let width = count.max(2) - 1;
    let mut soup = sheet(width, 1);
    // As wide as any other, so that the sides face each other.
    soup.points.iter_mut().for_each(|p| *p = [p[0] / f64::from(width) + x, p[1] + y, 0.01 * p[0]]);
    let rim = boundary_loops(&soup.view(), &BoundaryOptions::default(), &Job::default()).unwrap();
    let start = if upper { 2 * width + 1 } else { 0 };
    let first = rim.get(0).unwrap().vertices.iter().position(|&v| v == start).unwrap();
    (soup, Arc { first, count: count as usize })
}

/// Checks every result: edges have one or two faces, two only in opposite directions, and H and P
/// agree with the faces.
fn assert_predicted(joined: &Stitch, old: [&Soup; 2], cells: Cells) {
    for (edge, (forward, backward)) in edge_counts(faces(&joined.mesh)) {
        assert!(forward <= 1 && backward <= 1, "edge {edge:?}: {forward} {backward}");
    }
    let (columns, rows) = (joined.meridians.len(), joined.rows as usize);
    assert_eq!(joined.matrix.len(), columns * (rows + 2));
    let distinct = columns - usize::from(joined.closed);
    let new = if columns > 1 { rows * distinct } else { 0 };
    assert_eq!((joined.parents.len(), joined.weights.len()), (new, new));
    let vertices: usize = old.iter().map(|soup| soup.points.len()).sum();
    assert_eq!(joined.mesh.positions.len(), vertices + new);

    let mut expected = 0;
    for step in joined.meridians.windows(2) {
        let both = step[1][0] > step[0][0] && step[1][1] > step[0][1];
        expected += match cells {
            Cells::Quads => rows + 1,
            // If a rim repeats its vertex, one of the 2 rows + 2 triangles is missing.
            Cells::Triangles => 2 * rows + 1 + usize::from(both),
        };
    }
    assert_eq!(joined.strip_faces.len(), expected);
    let sizes: Vec<_> = faces(&joined.strip).map(<[u32]>::len).collect();
    let most = if cells == Cells::Quads { 4 } else { 3 };
    assert!(sizes.iter().all(|&n| n == 3 || n == most));

    // P: rims in the first and last row as H says, new vertices on the straight line between,
    // parents and weights the same.
    let at = |row: usize, column: usize| joined.matrix[row * columns + column];
    for (column, &[i, j]) in joined.meridians.iter().enumerate() {
        let [n, m] = joined.rims.each_ref().map(Vec::len);
        assert_eq!(at(0, column), joined.rims[0][i as usize % n]);
        assert_eq!(at(rows + 1, column), joined.rims[1][j as usize % m]);
        for row in 1..=rows {
            let v = at(row, column);
            let k = v as usize - vertices;
            assert_eq!(joined.parents[k], [at(0, column), at(rows + 1, column), at(rows + 1, column)]);
            let [rest, t, none] = joined.weights[k];
            assert!((t - row as f64 / (rows + 1) as f64).abs() < 1e-15 && rest == 1.0 - t && none == 0.0);
            let [p, q, _] = joined.parents[k].map(|v| joined.mesh.positions.get(v));
            assert!((joined.mesh.positions.get(v) - p.lerp(q, t)).length() < 1e-12);
        }
    }
}

#[test]
fn arcs_of_1_to_50_vertices() {
    // 7 and the 8 of the inner list are coprime: each length meets all others in turn.
    let lengths = (1..=50u32).flat_map(|n| [1, 2, 3, 5, 17, 49, 50, n].map(|m| (n, m)));
    for (n, m) in some_of(7, lengths) {
        let (a, arc_a) = sheet_with_arc(n, 0.0, 0.0, true);
        let (b, arc_b) = sheet_with_arc(m, 0.05, 2.0, false);
        for rows in [0, 1, 2, 10] {
            for cells in [Cells::Triangles, Cells::Quads] {
                for meridians in [Meridians::MinArea, Meridians::Index] {
                    let extent = Extent::Arcs([arc_a, arc_b]);
                    let options = Options { meridians, extent, rows: Rows::Count(rows), cells, ..Options::default() };
                    let joined = join(&a, &b, &options).unwrap();
                    assert!(!joined.closed && !joined.turned);
                    assert_eq!(joined.rims.each_ref().map(Vec::len), [n as usize, m as usize]);
                    assert_predicted(&joined, [&a, &b], cells);
                    // Two discs and a disc between them make one disc; a single vertex lacks an
                    // edge to attach to.
                    let pieces = match (n, m) {
                        (1, 1) => 2,
                        _ => 1,
                    };
                    assert_eq!(euler(faces(&joined.mesh)), pieces, "{n} {m} {rows}");
                    let last = joined.meridians.last().unwrap();
                    assert_eq!(*last, [n - 1, m - 1]);
                }
            }
        }
    }
}

#[test]
fn loops_of_3_to_50_vertices() {
    for n in [3, 4, 7, 20, 50] {
        for m in some_of(3, 3..=50) {
            let (a, b) = (cap(n, 2, 0.2, 1.0), cap(m, 2, 0.2, -1.0));
            for (rows, cells) in [(0, Cells::Quads), (1, Cells::Triangles), (3, Cells::Quads), (10, Cells::Triangles)] {
                for meridians in [Meridians::MinArea, Meridians::Index] {
                    let options = Options { meridians, rows: Rows::Count(rows), cells, ..Options::default() };
                    let joined = join(&a, &b, &options).unwrap();
                    assert!(joined.closed);
                    assert_predicted(&joined, [&a, &b], cells);
                    assert!(edge_counts(faces(&joined.mesh)).values().all(|&counts| counts == (1, 1)));
                    assert_eq!(euler(faces(&joined.mesh)), 2);
                }
            }
        }
    }
}

#[test]
fn the_row_count_follows_the_mean_side() {
    // Square cells of side 1, and a gap of 5: four rows, and square cells between.
    let (a, mut b) = (sheet(6, 2), sheet(6, 2));
    b.points.iter_mut().for_each(|p| p[1] += 7.0);
    let options = Options {
        extent: Extent::OpenArcs,
        rows: Rows::MeanEdge,
        meridians: Meridians::Index,
        cells: Cells::Quads,
        ..Options::default()
    };
    let joined = join(&a, &b, &options).unwrap();
    // The centres lie at half height: the upper half of A faces B, which is its upper side of seven
    // vertices.
    assert_eq!((joined.rows, joined.strip_faces.len()), (4, 30));
    assert!((joined.quality.max_edge - 1.0).abs() < 1e-12 && (joined.quality.area - 30.0).abs() < 1e-9);
    let found = check(&joined.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
    assert!(found.manifold && found.oriented && found.boundary_walks == 1 && found.euler == 1);
}

#[test]
fn arcs_count_along_the_loop_as_it_was_given() {
    let (a, arc_a) = sheet_with_arc(5, 0.0, 0.0, true);
    let (b, arc_b) = sheet_with_arc(4, 0.0, 2.0, false);
    let find = |soup: &Soup| {
        let found = boundary_loops(&soup.view(), &BoundaryOptions::default(), &Job::default()).unwrap();
        found.get(0).unwrap().vertices.to_vec()
    };
    let (loop_a, loop_b) = (find(&a), find(&b));
    let expected = join(&a, &b, &Options { extent: Extent::Arcs([arc_a, arc_b]), ..Options::default() }).unwrap();
    // The same arcs on the loops run backwards.
    let n = loop_a.len();
    let back: Vec<u32> = loop_a.iter().rev().copied().collect();
    let last = (arc_a.first + arc_a.count - 1) % n;
    let turned = Arc { first: n - 1 - last, ..arc_a };
    let options = Options { extent: Extent::Arcs([turned, arc_b]), ..Options::default() };
    let request = Request { a: &a.view(), loop_a: Some(&back), b: Some(&b.view()), loop_b: Some(&loop_b) };
    assert_eq!(stitch(&request, &options, &Job::default()).unwrap(), expected);

    for (first, count) in [(n, 1), (0, 0), (0, n + 1), (usize::MAX, 2)] {
        let options = Options { extent: Extent::Arcs([Arc { first, count }, arc_b]), ..Options::default() };
        let refused = stitch(&request, &options, &Job::default());
        assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "arc_a", .. })), "{first} {count}");
    }
    let refuses_a_twist = |a: &Soup, b: &Soup, extent| {
        let request = Request { a: &a.view(), loop_a: None, b: Some(&b.view()), loop_b: None };
        let refused = stitch(&request, &Options { extent, twist: 1, ..Options::default() }, &Job::default());
        assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "twist", .. })), "{refused:?}");
    };
    refuses_a_twist(&a, &b, Extent::Arcs([arc_a, arc_b]));
    refuses_a_twist(&a, &b, Extent::OpenArcs);
    // The rims are coaxial, so that facing arcs do not exist.
    refuses_a_twist(&cap(8, 2, 0.2, 1.0), &cap(8, 2, 0.2, -1.0), Extent::OpenArcs);
}

#[test]
fn arcs_of_pieces_that_disagree() {
    let (a, arc_a) = sheet_with_arc(6, 0.0, 0.0, true);
    let (b, _) = sheet_with_arc(6, 0.0, 2.0, false);
    // The same sheet upside down: its loop runs the other way, its lower side is found from its
    // other end.
    let b = b.turned();
    let rim = boundary_loops(&b.view(), &BoundaryOptions::default(), &Job::default()).unwrap();
    let first = rim.get(0).unwrap().vertices.iter().position(|&v| v == 5).unwrap();
    let extent = Extent::Arcs([arc_a, Arc { first, count: 6 }]);
    let joined = join(&a, &b, &Options { extent, ..Options::default() }).unwrap();
    assert!(joined.turned);
    assert_predicted(&joined, [&a, &b], Cells::Triangles);
    assert_eq!((joined.quality.orientation_conflicts, joined.quality.loops_left), (0, 1));
}

#[test]
fn a_single_precision_mesh_gets_single_precision_rows() {
    let soups = [cap(9, 2, 0.3, 1.0), cap(8, 2, 0.3, -1.0)];
    let points = soups.each_ref().map(|s| s.points.iter().map(|p| p.map(|x| x as f32)).collect::<Vec<[f32; 3]>>());
    let view = |k: usize| {
        let faces = Faces::polygons(&soups[k].offsets, &soups[k].corners).unwrap();
        MeshView::new(Positions::from(points[k].as_slice()), faces, &Job::default()).unwrap()
    };
    let (a, b) = (view(0), view(1));
    let options = Options { rows: Rows::Count(2), ..Options::default() };
    let joined =
        stitch(&Request { a: &a, loop_a: None, b: Some(&b), loop_b: None }, &options, &Job::default()).unwrap();
    let PositionBuffer::F32(found) = &joined.mesh.positions else { panic!("double") };
    assert_eq!(found[..points[0].len()], points[0]);
    assert_eq!(found[points[0].len()..][..points[1].len()], points[1]);
    for (k, &[p, q, _]) in joined.parents.iter().enumerate() {
        let exact = joined.mesh.positions.get(p).lerp(joined.mesh.positions.get(q), joined.weights[k][1]);
        let v = (points[0].len() + points[1].len() + k) as u32;
        assert!((joined.mesh.positions.get(v) - exact).length() < 1e-6);
    }
}

#[test]
fn the_winged_edges_of_the_first_piece_keep_their_numbers() {
    for rows in [0, 3] {
        let (a, b) = (cap(9, 3, 0.3, 1.0), cap(14, 3, 0.3, -1.0));
        let joined = join(&a, &b, &Options { rows: Rows::Count(rows), ..Options::default() }).unwrap();
        let tables = |view: &MeshView<'_>| WingedEdges::new(view, Winding::CounterClockwise, &Job::default()).unwrap();
        let (old, new) = (tables(&a.view()), tables(&joined.mesh.view(&Job::default()).unwrap()));
        let none = gusset::mesh::NONE;
        let mut filled = 0;
        for (before, after) in old.edges().iter().zip(new.edges()) {
            // Old elements stay; NULL sides along the rim, and they alone, are filled, wings and
            // all.
            let slots = |e: &gusset::winged::WingedEdge| [e.m, e.n, e.b, e.c, e.d, e.e, e.left, e.right];
            for (x, y) in slots(before).into_iter().zip(slots(after)) {
                assert!(x == y || x == none);
                filled += u32::from(x == none);
                assert_ne!(y, none);
            }
        }
        assert_eq!(filled, 3 * 9);
        // Euler's formula with the tables' own edges.
        let used = joined.mesh.positions.len() as i64;
        assert_eq!(used - new.edges().len() as i64 + joined.mesh.face_count() as i64, 2);
    }
}

#[test]
fn the_index_rule_is_linear_and_quick() {
    let rule = gusset::stitch::meridian::index_rule::index_rule(100_000, 80_000);
    assert_eq!(rule.last(), Some(80_000));
}

#[test]
fn quads_are_split_and_measured_by_their_shorter_diagonals() {
    // B is shifted by 0.4: of the two diagonals of each quad one leans by 0.6 and the other by 1.4.
    let (a, mut b) = (sheet(6, 1), sheet(6, 1));
    let arc = |soup: &Soup, start: u32| {
        let found = boundary_loops(&soup.view(), &BoundaryOptions::default(), &Job::default()).unwrap();
        Arc { first: found.get(0).unwrap().vertices.iter().position(|&v| v == start).unwrap(), count: 7 }
    };
    // A's upper side from its right end, B's lower side from its left end.
    let extent = Extent::Arcs([arc(&a, 13), arc(&b, 0)]);
    for shift in [0.4, -0.4] {
        b.points.iter_mut().zip(&a.points).for_each(|(p, q)| *p = [q[0] + shift, q[1] + 2.0, 0.0]);
        let with = |cells| {
            let options = Options { extent, meridians: Meridians::Index, cells, ..Options::default() };
            join(&a, &b, &options).unwrap().quality
        };
        let (triangles, quads) = (with(Cells::Triangles), with(Cells::Quads));
        assert!((triangles.max_edge - 1f64.hypot(0.6)).abs() < 1e-12, "{shift}: {}", triangles.max_edge);
        assert!((quads.max_edge - 1f64.hypot(0.4)).abs() < 1e-12);
        assert!((quads.min_angle - triangles.min_angle).abs() < 1e-12);
        assert!((quads.max_aspect - triangles.max_aspect).abs() < 1e-12);
        assert!((quads.area - 6.0).abs() < 1e-12 && (triangles.area - 6.0).abs() < 1e-12);
    }
}

/// Checks every strip between polylines. Points are unchanged, rows divide meridians evenly, and P
/// covers them. The free edges are the polylines, and for an open strip its two end meridians.
fn assert_ruled(made: &Ruled, a: &[DVec3], b: &[DVec3], closed: bool) {
    let (n, m) = (a.len(), b.len());
    let columns = made.meridians.len();
    let distinct = columns - usize::from(closed);
    let PositionBuffer::F64(points) = &made.mesh.positions else { panic!("f64 in, f64 out") };
    let point = |v: u32| DVec3::from(points[v as usize]);
    assert!(a.iter().chain(b).zip(points).all(|(p, &q)| p.to_array() == q));
    assert_eq!(points.len(), n + m + made.rows as usize * distinct);
    assert_eq!((made.parents.len(), made.weights.len()), (points.len() - n - m, points.len() - n - m));
    for (k, (&[i, j], &t)) in made.parents.iter().zip(&made.weights).enumerate() {
        assert_eq!(t, (k / distinct + 1) as f64 / f64::from(made.rows + 1));
        let (i, j) = (i as usize, j as usize);
        assert!(i < n && (n..n + m).contains(&j));
        let there = a[i].lerp(b[j - n], t);
        assert!(point((n + m + k) as u32).distance(there) <= 1e-15 * there.length().max(1.0));
    }
    let at = |row: usize, column: usize| made.matrix[row * columns + column];
    for (column, &[i, j]) in made.meridians.iter().enumerate() {
        assert_eq!(at(0, column) as usize, (made.start[0] + i) as usize % n);
        assert_eq!(at(made.rows as usize + 1, column) as usize, n + (made.start[1] + j) as usize % m);
        for row in 1..=made.rows as usize {
            let [from, to] = made.parents[at(row, column) as usize - n - m];
            assert_eq!([from, to], [at(0, column), at(made.rows as usize + 1, column)]);
        }
    }
    let edges = edge_counts(faces(&made.mesh));
    assert!(edges.values().all(|&(forward, backward)| forward <= 1 && backward <= 1));
    let free = edges.values().filter(|&&(forward, backward)| forward + backward == 1).count();
    let sides = if closed { n + m } else { n + m - 2 + 2 * (made.rows as usize + 1) };
    assert_eq!(free, sides);
    // Against polyline A and along B.
    let runs = |u: usize, v: usize| {
        faces(&made.mesh).any(|f| (0..f.len()).any(|k| f[k] as usize == u && f[(k + 1) % f.len()] as usize == v))
    };
    for i in 0..if closed { n } else { n - 1 } {
        assert!(runs((i + 1) % n, i));
    }
    for j in 0..if closed { m } else { m - 1 } {
        assert!(runs(n + j, n + (j + 1) % m));
    }
}

#[test]
fn strips_of_polylines_have_rows_quads_and_p() {
    let ring = |count: usize, radius: f64, z: f64, turn: f64| -> Vec<DVec3> {
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / count as f64 + turn;
        (0..count).map(|i| DVec3::new(radius * angle(i).cos(), radius * angle(i).sin(), z)).collect()
    };
    for (n, m) in [(6, 4), (12, 12), (7, 31), (3, 3)] {
        for closed in [true, false] {
            let (a, b) = (ring(n, 1.0, 0.0, 0.0), ring(m, 1.3, 2.0, 0.3));
            for meridians in [Meridians::Continuation, Meridians::Index, Meridians::Quad] {
                for (rows, start) in [
                    (Rows::None, Some(Start::Auto)),
                    (Rows::Count(1), Some(Start::Closest)),
                    (Rows::Count(5), None),
                    (Rows::MeanEdge, None),
                ] {
                    for cells in [Cells::Triangles, Cells::Quads] {
                        let options = RuledOptions { meridians, rows, start, cells, ..RuledOptions::default() };
                        let made = ruled(&a, &b, closed, &options, &Job::default()).unwrap();
                        assert_ruled(&made, &a, &b, closed);
                        let four = faces(&made.mesh).filter(|face| face.len() == 4).count();
                        assert!(cells == Cells::Quads || four == 0);
                        assert!(cells == Cells::Triangles || made.rows < 3 || four > 0);
                        assert!(rows != Rows::Count(5) || made.rows == 5);
                    }
                }
            }
        }
    }
}

#[test]
fn rows_by_the_mean_edge_of_the_polylines() {
    // Segments of length 1, meridians of length 6: five rows make edges of length 1.
    let line = |y: f64| (0..9).map(|i| DVec3::new(f64::from(i), y, 0.0)).collect::<Vec<_>>();
    let options = RuledOptions {
        rows: Rows::MeanEdge,
        cells: Cells::Quads,
        meridians: Meridians::Index,
        ..RuledOptions::default()
    };
    let made = ruled(&line(0.0), &line(6.0), false, &options, &Job::default()).unwrap();
    assert_eq!((made.rows, made.mesh.face_count()), (5, 48));
    // Two points alone have one meridian, no face, and no rows on it.
    let one = ruled(&[DVec3::ZERO], &[DVec3::X], false, &options, &Job::default()).unwrap();
    assert_eq!((one.rows, one.mesh.face_count(), one.meridians.len(), one.matrix.len()), (0, 0, 1, 2));
    let many = RuledOptions { rows: Rows::Count(u32::MAX), ..options };
    let refused = ruled(&line(0.0), &line(6.0), false, &many, &Job::default());
    assert!(matches!(refused, Err(Error::TooLarge { .. })), "{refused:?}");
    // Points of the largest numbers that there are.
    let far = |y: f64| line(y).into_iter().map(|p| p * 1e307).collect::<Vec<_>>();
    let made = ruled(&far(-6.0), &far(6.0), false, &options, &Job::default()).unwrap();
    assert_eq!(made.rows, 11);
    let PositionBuffer::F64(points) = &made.mesh.positions else { panic!("f64 in, f64 out") };
    assert!(points.iter().flatten().all(|x| x.is_finite()));
}
